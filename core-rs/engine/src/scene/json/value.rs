//! One JSON value, found but not yet read: a slice of the text and its place.

use std::fmt::{self, Display, Formatter};

use serde::de::value::StrDeserializer;
use serde::de::{self, IgnoredAny};

use super::split::entries;
use super::unescape::unescape;
use crate::error::{Counted, Error, JsonError};
use crate::scene::place::Place;
use crate::scene::shown;
use crate::scene::validate::at_most;

/// A slice of well-formed JSON.
#[derive(Clone, Copy)]
pub(super) struct Value<'a, 'p> {
    pub(super) text: &'a str,
    pub(super) place: Place<'p>,
}

impl<'a> Value<'a, '_> {
    /// A whole text, once it is known to be well-formed.
    pub(super) fn document(text: &'a str) -> Result<Self, Error> {
        let place = |error: &serde_json::Error| format!("line {} column {}", error.line(), error.column());
        serde_json::from_str::<IgnoredAny>(text).map_err(|error| Self::malformed(&error, place(&error)))?;
        Ok(Self { text: text.trim_ascii(), place: Place::Top })
    }

    pub(super) fn is_null(&self) -> bool {
        self.text == "null"
    }

    /// Finite; the nearest double.
    pub(super) fn number(&self) -> Result<f64, Error> {
        self.must_start(b"-0123456789", "a number")?;
        // Well-formed JSON writes numbers as Rust does.
        match self.text.parse::<f64>() {
            Ok(number) if number.is_finite() => Ok(number),
            _ => Err(Error::NotFinite { place: self.place.to_string() }),
        }
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
        self.must_start(b"\"", "a text")?;
        unescape(self.text).ok_or_else(|| {
            JsonError::InvalidJson { message: "an escape is half of a character".to_owned(), place: self.place.to_string() }.into()
        })
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

    /// The slices of a list of at most `limit`.
    pub(super) fn items(&self, limit: usize, what: Counted) -> Result<Vec<&'a str>, Error> {
        self.must_start(b"[", "a list")?;
        let items: Vec<&str> = entries(self.text).take(limit + 1).collect();
        at_most(items.len(), limit, what, self.place)?;
        Ok(items)
    }

    /// Exactly `N` slices of a list, as `shape` says.
    pub(super) fn exactly<const N: usize>(&self, shape: &'static str) -> Result<[&'a str; N], Error> {
        self.must_start(b"[", shape)?;
        self.parts().ok_or_else(|| JsonError::WrongType { found: shown(self.text), expected: shape, place: self.place.to_string() }.into())
    }

    /// The slices of a list if there are exactly `N`.
    pub(super) fn parts<const N: usize>(&self) -> Option<[&'a str; N]> {
        let mut entries = entries(self.text);
        let mut parts = [""; N];
        for part in &mut parts {
            *part = entries.next()?;
        }
        entries.next().is_none().then_some(parts)
    }

    pub(super) fn is_empty_list(&self) -> Result<bool, Error> {
        self.must_start(b"[", "a list")?;
        Ok(entries(self.text).next().is_none())
    }

    pub(super) fn wrong_type(&self, expected: &'static str) -> Error {
        let found = match self.text.as_bytes()[0] {
            b'{' => "an object".to_owned(),
            b'[' => "a list".to_owned(),
            _ => shown(self.text),
        };
        JsonError::WrongType { found, expected, place: self.place.to_string() }.into()
    }

    /// A value is of the type that its first byte says.
    pub(super) fn must_start(&self, firsts: &[u8], expected: &'static str) -> Result<(), Error> {
        if firsts.contains(&self.text.as_bytes()[0]) { Ok(()) } else { Err(self.wrong_type(expected)) }
    }

    fn malformed(error: &serde_json::Error, place: String) -> Error {
        let whole = error.to_string();
        let message = match whole.rsplit_once(" at line ") {
            _ if error.is_eof() => "the text ends too early",
            Some((message, _)) => message,
            None => &whole,
        };
        JsonError::InvalidJson { message: message.to_owned(), place }.into()
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
