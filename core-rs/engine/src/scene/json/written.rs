//! Fields as they are written: none that is as usual.

use serde::Serialize;

use super::layout::Layout;
use crate::text::json;

pub(super) fn numbers(out: &mut Layout, numbers: &[f64]) {
    out.list_line(numbers, |out, number| out.number(*number));
}

pub(super) fn number(out: &mut Layout, name: &str, value: f64, default: f64) {
    if value.to_bits() != default.to_bits() {
        out.key(name).number(value);
    }
}

pub(super) fn string(out: &mut Layout, name: &str, text: &str) {
    if !text.is_empty() {
        out.key(name).string(text);
    }
}

pub(super) fn flag(out: &mut Layout, name: &str, is_so: bool) {
    if is_so {
        out.key(name).raw("true");
    }
}

pub(super) fn word<T: Serialize + Default + PartialEq>(out: &mut Layout, name: &str, word: &T) {
    if *word != T::default() {
        required_word(out, name, word);
    }
}

pub(super) fn required_word<T: Serialize>(out: &mut Layout, name: &str, word: &T) {
    out.key(name).raw(&json(word));
}
