//! The texts of a scene: letters by the letters before them, words by where they came up, names by their numbers.

use std::collections::BTreeMap;

use super::models::Integer;
use super::range::{Bit, Coder};
use crate::error::Error;

/// The texts of a scene: titles, names, colors.
#[derive(Default)]
pub struct Texts {
    text: Text,
    stems: Words,
    has_number: Bit,
    follows: Bit,
    number: Integer,
    /// The last number of each stem.
    last_numbers: Vec<i64>,
    colors: Words,
}

impl Texts {
    /// Codes a name: a stem and a number, which mostly follows the stem's last one, so "T1", "T2", … cost nothing.
    pub fn code_name(&mut self, coder: &mut dyn Coder, name: &mut String) -> Result<(), Error> {
        let (mut stem, number) = split_number(name);
        let at = self.stems.code(coder, &mut self.text, &mut stem)?;
        self.last_numbers.resize(self.stems.list.len(), 0);
        let mut has_number = number.is_some();
        coder.bit(&mut self.has_number, &mut has_number);
        *name = stem;
        if has_number {
            let expected = self.last_numbers[at] + 1;
            let mut number = number.unwrap_or(expected);
            let mut follows = number == expected;
            coder.bit(&mut self.follows, &mut follows);
            let mut skipped = if follows { 0 } else { number - expected };
            if !follows {
                self.number.code(coder, &mut skipped);
            }
            number = expected.checked_add(skipped).filter(|n| (0..=GREATEST_NUMBER).contains(n)).ok_or(Error::LinkDamaged)?;
            self.last_numbers[at] = number;
            name.push_str(&number.to_string());
        }
        Ok(())
    }

    /// Codes a color.
    pub fn code_color(&mut self, coder: &mut dyn Coder, color: &mut String) -> Result<(), Error> {
        self.colors.code(coder, &mut self.text, color).map(|_| ())
    }
}

const GREATEST_NUMBER: i64 = 999_999_999;

/// "T12" is "T" and 12; "T012" is "T0" and 12, so that the number prints as it was.
fn split_number(name: &str) -> (String, Option<i64>) {
    let digits = name.bytes().rev().take(9).take_while(u8::is_ascii_digit).count();
    let tail = &name[name.len() - digits..];
    // Of zeros alone the last is the number.
    let zeros = tail.bytes().take_while(|byte| *byte == b'0').count().min(digits.saturating_sub(1));
    let (stem, number) = name.split_at(name.len() - digits + zeros);
    (stem.to_owned(), number.parse().ok())
}

/// UTF-8 text, each byte by the none, one and two bytes before it.
struct Text {
    // A tree of 256 nodes for every context; the pairs share a table by a hash.
    tables: [Vec<Bit>; 3],
}

/// Ends a text: no byte of UTF-8 has this value.
const END: u8 = 0xFF;

/// Longer than the longest valid text (200 characters of four bytes).
const LONGEST_TEXT: usize = 1024;

const PAIR_CONTEXTS: usize = 1 << 11;

impl Default for Text {
    fn default() -> Self {
        Self { tables: [1, 256, PAIR_CONTEXTS].map(|contexts| vec![Bit::default(); contexts * 256]) }
    }
}

impl Text {
    fn code(&mut self, coder: &mut dyn Coder, text: &mut String) -> Result<(), Error> {
        let mut bytes = std::mem::take(text).into_bytes();
        bytes.push(END);
        let mut before = (0, 0);
        let mut at = 0;
        loop {
            if at == bytes.len() {
                bytes.push(0);
            }
            self.code_byte(coder, before, &mut bytes[at]);
            if bytes[at] == END {
                bytes.truncate(at);
                break;
            }
            before = (before.1, bytes[at]);
            at += 1;
            if at > LONGEST_TEXT {
                return Err(Error::LinkDamaged);
            }
        }
        *text = String::from_utf8(bytes).map_err(|_| Error::LinkDamaged)?;
        Ok(())
    }

    fn code_byte(&mut self, coder: &mut dyn Coder, before: (u8, u8), byte: &mut u8) {
        let pair = (usize::from(before.0) * 33 + usize::from(before.1) * 289) % PAIR_CONTEXTS;
        let contexts = [0, usize::from(before.1), pair];
        let mut node = 1;
        for place in (0..8).rev() {
            let mut bit = *byte >> place & 1 == 1;
            let mut models = [0, 1, 2].map(|order| self.tables[order][contexts[order] * 256 + node]);
            coder.weighted(blend(models), &mut bit);
            for (order, model) in models.iter_mut().enumerate() {
                model.learn(bit);
                self.tables[order][contexts[order] * 256 + node] = *model;
            }
            node = node * 2 + usize::from(bit);
        }
        *byte = (node & 0xFF) as u8;
    }
}

/// The longer the context and the more often it was seen, the more it counts.
fn blend(models: [Bit; 3]) -> u16 {
    let (mut sum, mut total) = (1 << 15, 1_u64);
    for (model, weight) in models.into_iter().zip([1, 4, 16]) {
        let weight = weight * u64::from(model.seen());
        sum += weight * u64::from(model.chance());
        total += weight;
    }
    (sum / total) as u16
}

/// Words that come again and again; the empty word is known from the start.
struct Words {
    list: Vec<String>,
    index: BTreeMap<String, usize>,
    last: usize,
    is_last: Bit,
    is_known: Bit,
}

impl Default for Words {
    fn default() -> Self {
        let list = vec![String::new()];
        let mut index = BTreeMap::new();
        index.insert(String::new(), 0);
        Self { list, index, last: 0, is_last: Bit::likely(true), is_known: Bit::default() }
    }
}

impl Words {
    /// Codes the word and says which of the list it is.
    fn code(&mut self, coder: &mut dyn Coder, text: &mut Text, word: &mut String) -> Result<usize, Error> {
        let known = self.index.get(word).copied();
        let mut is_last = known == Some(self.last);
        coder.bit(&mut self.is_last, &mut is_last);
        let mut is_known = is_last || known.is_some();
        if !is_last {
            coder.bit(&mut self.is_known, &mut is_known);
        }
        if is_last {
            word.clone_from(&self.list[self.last]);
        } else if is_known {
            let mut at = known.unwrap_or(0) as u32;
            coder.even(self.list.len() as u32, &mut at);
            self.last = at as usize;
            word.clone_from(&self.list[self.last]);
        } else {
            text.code(coder, word)?;
            self.last = self.list.len();
            self.list.push(word.clone());
            self.index.insert(word.clone(), self.last);
        }
        Ok(self.last)
    }
}

#[cfg(test)]
mod tests {
    use proptest::collection::vec;
    use proptest::prelude::*;

    use super::super::range::{Reader, Writer};
    use super::*;

    fn code_names(coder: &mut dyn Coder, names: &mut [String]) {
        let mut texts = Texts::default();
        for name in names {
            texts.code_name(coder, name).expect("a short name");
        }
    }

    fn written(names: &[String]) -> Vec<u8> {
        let mut writer = Writer::default();
        code_names(&mut writer, &mut names.to_vec());
        writer.finish()
    }

    proptest! {
        #[test]
        fn names_come_back(names in vec(prop_oneof!["[A-C][0-9]{0,12}", "\\PC{0,64}"], 0..40)) {
            let mut found = vec![String::new(); names.len()];
            code_names(&mut Reader::new(&written(&names)), &mut found);
            prop_assert_eq!(found, names);
        }
    }

    #[test]
    fn a_prefix_and_rising_numbers_cost_next_to_nothing() {
        let names: Vec<String> = (1..=1000).map(|number| format!("Trumpet {number}")).collect();
        let bytes = written(&names).len();
        assert!(bytes <= 30, "{bytes} bytes");
    }
}
