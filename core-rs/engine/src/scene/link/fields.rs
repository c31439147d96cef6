//! The kinds of fields that a link is made of.

use super::graph::Pairs;
use super::models::Number;
use super::names::Texts;
use super::range::{Bit, Coder};
use crate::choice::MethodName;
use crate::error::Error;

// The place in this list is the value in the link: append only.
pub(super) const METHODS: [MethodName; 6] =
    [MethodName::Auto, MethodName::Spectral, MethodName::Shared, MethodName::Polar, MethodName::Linear, MethodName::Crowd];

/// A link being written or read.
pub(super) struct Fields<'c> {
    pub(super) coder: &'c mut dyn Coder,
    pub(super) texts: Texts,
    pub(super) pairs: Pairs,
}

impl Fields<'_> {
    /// A number that occurs once and mostly has its usual value.
    pub(super) fn code_usual(&mut self, usual: f64, value: &mut f64) {
        self.code_number(&mut Bit::likely(true), &mut Number::default(), usual, value);
    }

    pub(super) fn code_number(&mut self, is_usual: &mut Bit, number: &mut Number, usual: f64, value: &mut f64) {
        let mut is_usual_here = value.to_bits() == usual.to_bits();
        self.coder.bit(is_usual, &mut is_usual_here);
        if is_usual_here {
            *value = usual;
        } else {
            number.code(self.coder, value);
        }
    }

    /// One of a list with room for sixteen; the first is the usual one.
    pub(super) fn code_word<T: Copy + PartialEq>(&mut self, words: &[T], word: &mut T) -> Result<(), Error> {
        let mut at = words.iter().position(|known| known == word).unwrap_or(0) as u32;
        let mut is_usual = at == 0;
        self.coder.bit(&mut Bit::likely(true), &mut is_usual);
        if !is_usual {
            self.coder.even(16, &mut at);
        }
        *word = if is_usual { words[0] } else { *words.get(at as usize).ok_or_else(newer)? };
        Ok(())
    }
}

pub(super) fn newer() -> Error {
    Error::NewerVersion { version: "1 with additions".to_owned() }
}

pub(super) fn as_integer(value: f64) -> Result<u32, Error> {
    let integer = value as u32;
    if f64::from(integer).to_bits() == value.to_bits() { Ok(integer) } else { Err(Error::LinkDamaged) }
}
