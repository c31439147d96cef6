//! How a double is written so that reading gives the same double.

/// Whole numbers without a point, others with the fewest digits that read back the same; JSON and CSV both take it.
pub(super) fn number_text(value: f64) -> String {
    let is_plain = value.fract() == 0.0 && value.abs() < 1e15 && !(value == 0.0 && value.is_sign_negative());
    if is_plain { format!("{value:.0}") } else { format!("{value:?}") }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::number_text;

    #[test]
    fn whole_numbers_have_no_point() {
        let cases =
            [(0.0, "0"), (-0.0, "-0.0"), (-3.0, "-3"), (0.1, "0.1"), (1e15, "1000000000000000.0"), (1e22, "1e22"), (5e-324, "5e-324")];
        for (value, text) in cases {
            assert_eq!(number_text(value), text);
        }
    }

    proptest! {
        #[test]
        fn every_double_reads_back_to_the_bit(value in any::<f64>().prop_filter("finite", |value| value.is_finite())) {
            let text = number_text(value);
            prop_assert_eq!(text.parse::<f64>().unwrap().to_bits(), value.to_bits());
            prop_assert_eq!(serde_json::from_str::<f64>(&text).unwrap().to_bits(), value.to_bits());
        }
    }
}
