//! The program as a person runs it: each verb does what its help says, and failures are said.

mod desk;
mod failures;
mod files;
mod formations;
mod motions;
mod space;

use serde_json::Value;

fn parsed(text: &str) -> Value {
    serde_json::from_str(text).expect("JSON")
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}
