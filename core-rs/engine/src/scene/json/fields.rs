//! The fields of one JSON object: known by name, absent ones at their default.

use std::borrow::Cow;

use serde::de::DeserializeOwned;

use super::split;
use super::value::Value;
use crate::error::{Counted, Error, JsonError};
use crate::scene::place::Place;
use crate::scene::shown;

/// The fields of an object that are known, and whether there are others.
pub(super) struct Fields<'a, 'p> {
    place: Place<'p>,
    known: &'static [&'static str],
    /// By index into `known`.
    values: Vec<Option<&'a str>>,
    /// The name of the first field that is not known.
    stranger: Option<String>,
}

/// The only value so far of a field that version 1 names.
pub(super) enum Only {
    NoEntries,
    Word(&'static str, &'static [&'static str]),
}

impl<'a, 'p> Value<'a, 'p> {
    /// The fields of an object; one that is not `known` is refused.
    pub(super) fn object(&self, known: &'static [&'static str]) -> Result<Fields<'a, 'p>, Error> {
        let fields = self.fields(known)?;
        fields.refuse_strangers()?;
        Ok(fields)
    }

    /// The fields of an object, not yet judged by [`Fields::refuse_strangers`].
    pub(super) fn fields(&self, known: &'static [&'static str]) -> Result<Fields<'a, 'p>, Error> {
        self.must_start(b"{", "an object")?;
        let mut fields = Fields { place: self.place, known, values: vec![None; known.len()], stranger: None };
        for (quoted, value) in split::fields(self.text) {
            let name = Value { text: quoted, place: self.place }.name()?;
            match known.iter().position(|known| *known == name) {
                Some(index) if fields.values[index].is_none() => fields.values[index] = Some(value),
                Some(_) => return Err(JsonError::RepeatedField { field: name.into_owned(), place: self.place.to_string() }.into()),
                None if fields.stranger.is_none() => fields.stranger = Some(shown(&name)),
                None => {}
            }
        }
        Ok(fields)
    }

    /// Names are many, and hardly any is spelled with escapes.
    fn name(&self) -> Result<Cow<'a, str>, Error> {
        if self.text.contains('\\') { self.string().map(Cow::Owned) } else { Ok(Cow::Borrowed(&self.text[1..self.text.len() - 1])) }
    }
}

impl<'a> Fields<'a, '_> {
    pub(super) fn refuse_strangers(&self) -> Result<(), Error> {
        match &self.stranger {
            Some(field) => {
                Err(JsonError::UnknownField { field: field.clone(), admissible: self.known, place: self.place.to_string() }.into())
            }
            None => Ok(()),
        }
    }

    pub(super) fn get(&self, name: &'static str) -> Option<Value<'a, '_>> {
        let index = self.known.iter().position(|known| *known == name).expect("a field that is read is known");
        self.values[index].map(|text| Value { text, place: self.place.field(name) })
    }

    pub(super) fn required(&self, name: &'static str) -> Result<Value<'a, '_>, Error> {
        self.get(name).ok_or_else(|| JsonError::MissingField { field: name.to_owned(), place: self.place.to_string() }.into())
    }

    pub(super) fn number(&self, name: &'static str, default: f64) -> Result<f64, Error> {
        self.get(name).map_or(Ok(default), |value| value.number())
    }

    pub(super) fn whole(&self, name: &'static str, default: u32) -> Result<u32, Error> {
        self.get(name).map_or(Ok(default), |value| value.whole())
    }

    pub(super) fn string(&self, name: &'static str) -> Result<String, Error> {
        self.get(name).map_or(Ok(String::new()), |value| value.string())
    }

    pub(super) fn flag(&self, name: &'static str) -> Result<bool, Error> {
        self.get(name).map_or(Ok(false), |value| value.flag())
    }

    /// A flag that is set where it is absent.
    pub(super) fn set_flag(&self, name: &'static str) -> Result<bool, Error> {
        self.get(name).map_or(Ok(true), |value| value.flag())
    }

    pub(super) fn word<T: Default + DeserializeOwned>(&self, name: &'static str, later: &[&str]) -> Result<T, Error> {
        self.get(name).map_or_else(|| Ok(T::default()), |value| value.word(later))
    }

    /// A field whose absence and null both mean none.
    pub(super) fn optional<T>(&self, name: &'static str, read: impl Fn(Value) -> Result<T, Error>) -> Result<Option<T>, Error> {
        self.get(name).filter(|value| !value.is_null()).map(read).transpose()
    }

    /// Every entry of a list of at most `limit`, read in order; absent: empty.
    pub(super) fn list<T>(
        &self,
        name: &'static str,
        limit: usize,
        what: Counted,
        mut read: impl FnMut(Value) -> Result<T, Error>,
    ) -> Result<Vec<T>, Error> {
        let Some(list) = self.get(name) else { return Ok(Vec::new()) };
        let items = list.items(limit, what)?;
        items.into_iter().enumerate().map(|(index, text)| read(Value { text, place: list.place.item(index) })).collect()
    }

    /// Refuses any value but the one that is supported.
    pub(super) fn only(&self, name: &'static str, only: &Only) -> Result<(), Error> {
        let Some(value) = self.get(name) else { return Ok(()) };
        let (is_supported, supported) = match *only {
            Only::NoEntries => (value.is_empty_list()?, "[]".to_owned()),
            Only::Word(word, admissible) => {
                let given = value.string()?;
                if !admissible.contains(&given.as_str()) {
                    return Err(Error::UnknownValue { value: shown(value.text), admissible, place: value.place.to_string() });
                }
                (given == word, format!("\"{word}\""))
            }
        };
        if is_supported { Ok(()) } else { Err(Error::Unsupported { value: shown(value.text), supported, place: value.place.to_string() }) }
    }
}
