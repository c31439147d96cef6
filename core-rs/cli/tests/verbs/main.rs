//! Each verb does what its help says.

mod files;
mod formations;
mod motions;
#[path = "../support/mod.rs"]
mod support;

use serde_json::Value;

fn parsed(text: &str) -> Value {
    serde_json::from_str(text).expect("JSON")
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}
