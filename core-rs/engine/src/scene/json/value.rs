//! One JSON value, found but not yet read: a slice of the text and its place.

use std::fmt::{self, Display, Formatter};

use serde::de::value::StrDeserializer;
use serde::de::{self, Deserializer as _, IgnoredAny, SeqAccess, Visitor};
use serde_json::value::RawValue;

use crate::error::{Counted, Error};
use crate::scene::place::Place;
use crate::scene::shown;

/// A slice of well-formed JSON, or the whole text before it is scanned.
#[derive(Clone, Copy)]
pub(super) struct Value<'a, 'p> {
    pub(super) text: &'a str,
    pub(super) place: Place<'p>,
}

impl<'a> Value<'a, '_> {
    pub(super) fn is_null(&self) -> bool {
        self.text == "null"
    }

    /// Finite; the nearest double.
    pub(super) fn number(&self) -> Result<f64, Error> {
        self.must_start(|first| first == b'-' || first.is_ascii_digit(), "a number")?;
        serde_json::from_str(self.text).map_err(|_| Error::NotFinite { place: self.place.to_string() })
    }

    /// A whole number from 0; `3.0` and `3e0` are 3.
    pub(super) fn whole(&self) -> Result<u32, Error> {
        let value = self.number()?;
        if value.fract() != 0.0 {
            return Err(self.wrong_type("a whole number"));
        }
        if !(0.0..=f64::from(u32::MAX)).contains(&value) {
            return Err(Error::OutOfRange { value, low: 0.0, high: f64::from(u32::MAX), place: self.place.to_string() });
        }
        Ok(value as u32)
    }

    pub(super) fn flag(&self) -> Result<bool, Error> {
        match self.text {
            "true" => Ok(true),
            "false" => Ok(false),
            _ => Err(self.wrong_type("true or false")),
        }
    }

    pub(super) fn string(&self) -> Result<String, Error> {
        self.must_start(|first| first == b'"', "a text")?;
        serde_json::from_str(self.text).map_err(|error| self.malformed(&error))
    }

    /// One of the words of `T`; a word of `later` is known to version 1 but not supported.
    pub(super) fn word<T: de::DeserializeOwned>(&self, later: &[&str]) -> Result<T, Error> {
        let word = self.string()?;
        T::deserialize(StrDeserializer::new(&word)).map_err(|NoSuchWord(admissible)| {
            let place = self.place.to_string();
            if later.contains(&word.as_str()) {
                Error::Unsupported { value: shown(self.text), supported: listed(admissible), place }
            } else {
                Error::UnknownValue { value: shown(self.text), admissible, place }
            }
        })
    }

    /// The slices of a list; counted to its end, kept only up to `limit`.
    pub(super) fn items(&self, limit: usize, what: Counted) -> Result<Vec<&'a str>, Error> {
        let (items, count) = self.first_items(limit, "a list")?;
        if count <= limit { Ok(items) } else { Err(Error::TooMany { what, count, limit, place: self.place.to_string() }) }
    }

    /// Exactly `N` slices of a list, as `shape` says.
    pub(super) fn exactly<const N: usize>(&self, shape: &'static str) -> Result<[&'a str; N], Error> {
        let (items, count) = self.first_items(N, shape)?;
        match items.try_into() {
            Ok(items) if count == N => Ok(items),
            _ => Err(Error::WrongType { found: format!("a list of {count}"), expected: shape, place: self.place.to_string() }),
        }
    }

    /// How many entries the list has.
    pub(super) fn count(&self) -> Result<usize, Error> {
        self.first_items(0, "a list").map(|(_, count)| count)
    }

    pub(super) fn wrong_type(&self, expected: &'static str) -> Error {
        let found = match self.first() {
            b'{' => "an object".to_owned(),
            b'[' => "a list".to_owned(),
            _ => shown(self.text),
        };
        Error::WrongType { found, expected, place: self.place.to_string() }
    }

    pub(super) fn must_start(&self, is_right: impl Fn(u8) -> bool, expected: &'static str) -> Result<(), Error> {
        if is_right(self.first()) { Ok(()) } else { Err(self.wrong_type(expected)) }
    }

    pub(super) fn malformed(&self, error: &serde_json::Error) -> Error {
        let whole = error.to_string();
        let message = match whole.rsplit_once(" at line ") {
            _ if error.is_eof() => "the text ends too early",
            Some((message, _)) => message,
            None => &whole,
        };
        let place = match self.place {
            Place::Top => format!("line {} column {}", error.line(), error.column()),
            place => place.to_string(),
        };
        Error::InvalidJson { message: message.to_owned(), place }
    }

    fn first_items(&self, limit: usize, expected: &'static str) -> Result<(Vec<&'a str>, usize), Error> {
        self.must_start(|first| first == b'[', expected)?;
        let mut parser = serde_json::Deserializer::from_str(self.text);
        parser.deserialize_seq(Items { limit }).map_err(|error| self.malformed(&error))
    }

    fn first(&self) -> u8 {
        self.text.trim_ascii_start().bytes().next().unwrap_or(b' ')
    }
}

/// Keeps the first entries of a list and counts them all.
struct Items {
    limit: usize,
}

impl<'de> Visitor<'de> for Items {
    type Value = (Vec<&'de str>, usize);

    fn expecting(&self, f: &mut Formatter) -> fmt::Result {
        f.write_str("a list")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Self::Value, A::Error> {
        let mut items = Vec::new();
        while items.len() < self.limit {
            match list.next_element::<&RawValue>()? {
                Some(item) => items.push(item.get()),
                None => break,
            }
        }
        let mut count = items.len();
        while list.next_element::<IgnoredAny>()?.is_some() {
            count += 1;
        }
        Ok((items, count))
    }
}

/// The words that would have been right.
#[derive(Debug)]
struct NoSuchWord(&'static [&'static str]);

impl Display for NoSuchWord {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        f.write_str(&listed(self.0))
    }
}

impl std::error::Error for NoSuchWord {}

impl de::Error for NoSuchWord {
    fn custom<T: Display>(_: T) -> Self {
        Self(&[])
    }

    fn unknown_variant(_: &str, expected: &'static [&'static str]) -> Self {
        Self(expected)
    }
}

fn listed(words: &[&str]) -> String {
    words.iter().map(|word| format!("\"{word}\"")).collect::<Vec<_>>().join(" or ")
}
