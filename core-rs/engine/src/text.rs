//! Plain data as JSON text.
//!
//! Numbers are written as Rust writes them, so that a visitor does not load a second set of tables for the same digits.

use std::io;

use serde::Serialize;
use serde_json::Serializer;
use serde_json::ser::Formatter;

/// JSON on one line; doubles in the fewest digits that read back the same, what is no number as null.
///
/// # Panics
/// When the value is not plain data: a bug, not input.
pub fn json<T: Serialize + ?Sized>(value: &T) -> String {
    let mut bytes = Vec::new();
    value.serialize(&mut Serializer::with_formatter(&mut bytes, Digits)).expect("plain data is JSON");
    String::from_utf8(bytes).expect("JSON is text")
}

struct Digits;

impl Formatter for Digits {
    fn write_f64<W: io::Write + ?Sized>(&mut self, writer: &mut W, value: f64) -> io::Result<()> {
        write!(writer, "{value:?}")
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::json;

    #[test]
    fn plain_data_is_one_line() {
        assert_eq!(json(&(1.5, f64::NAN, Some("a\"\n"), [0_u32; 2], 30.0)), r#"[1.5,null,"a\"\n",[0,0],30.0]"#);
    }

    proptest! {
        #[test]
        fn every_double_reads_back_to_the_bit(value in any::<f64>().prop_filter("finite", |value| value.is_finite())) {
            prop_assert_eq!(serde_json::from_str::<f64>(&json(&value)).unwrap().to_bits(), value.to_bits());
        }
    }
}
