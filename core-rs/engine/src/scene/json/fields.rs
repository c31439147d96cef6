//! The fields of one JSON object: known by name, absent ones at their default.

use std::fmt::{self, Formatter};

use serde::de::{DeserializeOwned, Deserializer as _, IgnoredAny, MapAccess, Visitor};
use serde_json::value::RawValue;

use super::value::Value;
use crate::error::{Counted, Error};
use crate::scene::place::Place;
use crate::scene::shown;

/// An object whose every field is one of `known`.
pub(super) struct Fields<'a, 'p> {
    place: Place<'p>,
    known: &'static [&'static str],
    /// By index into `known`.
    values: Vec<Option<&'a str>>,
}

/// The only value so far of a field that version 1 names.
pub(super) enum Only {
    False,
    Null,
    NoEntries,
    Number(f64),
    Word(&'static str, &'static [&'static str]),
}

impl<'a, 'p> Value<'a, 'p> {
    /// The fields of an object; one that is not `known` is refused.
    pub(super) fn object(&self, known: &'static [&'static str]) -> Result<Fields<'a, 'p>, Error> {
        let (values, stranger) = self.scan(known)?;
        match stranger {
            Some(field) => Err(Error::UnknownField { field: shown(&field), admissible: known, place: self.place.to_string() }),
            None => Ok(Fields { place: self.place, known, values }),
        }
    }

    /// The `wanted` fields of an object, whatever else it has.
    pub(super) fn some_fields(&self, wanted: &'static [&'static str]) -> Result<Fields<'a, 'p>, Error> {
        let (values, _) = self.scan(wanted)?;
        Ok(Fields { place: self.place, known: wanted, values })
    }

    /// Slices of the known fields, and the first name that is not known.
    fn scan(&self, known: &'static [&'static str]) -> Result<(Vec<Option<&'a str>>, Option<String>), Error> {
        self.must_start(|first| first == b'{', "an object")?;
        let mut parser = serde_json::Deserializer::from_str(self.text);
        let scan = parser.deserialize_map(Scan { known }).and_then(|scan| parser.end().map(|()| scan));
        let Scanned { values, stranger, repeated } = scan.map_err(|error| self.malformed(&error))?;
        match repeated {
            Some(field) => Err(Error::RepeatedField { field: field.to_owned(), place: self.place.to_string() }),
            None => Ok((values, stranger)),
        }
    }
}

impl<'a> Fields<'a, '_> {
    pub(super) fn get(&self, name: &'static str) -> Option<Value<'a, '_>> {
        let index = self.known.iter().position(|known| *known == name).expect("a field that is read is known");
        self.values[index].map(|text| Value { text, place: self.place.field(name) })
    }

    pub(super) fn required(&self, name: &'static str) -> Result<Value<'a, '_>, Error> {
        self.get(name).ok_or_else(|| Error::MissingField { field: name.to_owned(), place: self.place.to_string() })
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
            Only::False => (!value.flag()?, "false".to_owned()),
            Only::Null => (value.is_null(), "null".to_owned()),
            Only::NoEntries => (value.count()? == 0, "[]".to_owned()),
            // A default is written with few digits, so the parsed number is the same double.
            Only::Number(number) => (value.number()?.to_bits() == number.to_bits(), number.to_string()),
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

struct Scan {
    known: &'static [&'static str],
}

struct Scanned<'a> {
    values: Vec<Option<&'a str>>,
    stranger: Option<String>,
    repeated: Option<&'static str>,
}

impl<'de> Visitor<'de> for Scan {
    type Value = Scanned<'de>;

    fn expecting(&self, f: &mut Formatter) -> fmt::Result {
        f.write_str("an object")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
        let mut scanned = Scanned { values: vec![None; self.known.len()], stranger: None, repeated: None };
        // The scan goes on after a stranger: the rest must be well-formed all the same.
        while let Some(name) = map.next_key::<String>()? {
            let Some(index) = self.known.iter().position(|known| *known == name) else {
                map.next_value::<IgnoredAny>()?;
                scanned.stranger.get_or_insert(name);
                continue;
            };
            if scanned.values[index].replace(map.next_value::<&RawValue>()?.get()).is_some() {
                scanned.repeated = Some(self.known[index]);
            }
        }
        Ok(scanned)
    }
}
