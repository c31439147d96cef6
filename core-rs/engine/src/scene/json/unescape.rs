//! The text of a JSON string.

/// The text of a quoted string that a parser has passed; none where an escape is half of a surrogate pair, which it lets through.
pub(super) fn unescape(quoted: &str) -> Option<String> {
    let mut rest = quoted.get(1..quoted.len() - 1)?;
    let mut text = String::with_capacity(rest.len());
    while let Some((plain, escape)) = rest.split_once('\\') {
        text.push_str(plain);
        let (letter, after) = escape.split_at_checked(1)?;
        rest = after;
        text.push(match letter {
            "b" => '\u{8}',
            "f" => '\u{c}',
            "n" => '\n',
            "r" => '\r',
            "t" => '\t',
            "u" => {
                let (character, after) = by_number(after)?;
                rest = after;
                character
            }
            itself => itself.chars().next()?,
        });
    }
    text.push_str(rest);
    Some(text)
}

/// A character by its one or two UTF-16 units, and what follows.
fn by_number(text: &str) -> Option<(char, &str)> {
    let (first, rest) = unit(text)?;
    if let Some(character) = char::from_u32(u32::from(first)) {
        return Some((character, rest));
    }
    let (second, rest) = unit(rest.strip_prefix("\\u")?)?;
    let character = char::decode_utf16([first, second]).next()?.ok()?;
    Some((character, rest))
}

fn unit(text: &str) -> Option<(u16, &str)> {
    let (digits, rest) = text.split_at_checked(4)?;
    Some((u16::from_str_radix(digits, 16).ok()?, rest))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::unescape;

    #[test]
    fn escapes_are_what_json_says() {
        let check = |quoted: &str, text: Option<&str>| assert_eq!(unescape(quoted).as_deref(), text, "{quoted}");
        check(r#""""#, Some(""));
        check(r#""\"\\\/\b\f\n\r\t""#, Some("\"\\/\u{8}\u{c}\n\r\t"));
        check(r#""\u0041\u00e9\ud83d\ude00!""#, Some("Aé😀!"));
        for half in [r#""\ud83d""#, r#""\ude00""#, r#""\ud83d\u0041""#, r#""\ud83dx""#, r#""\ud83d\n""#] {
            check(half, None);
        }
    }

    proptest! {
        #[test]
        fn every_text_comes_back(text in ".*") {
            prop_assert_eq!(unescape(&serde_json::to_string(&text).unwrap()), Some(text.clone()));
            let numbers: Vec<String> = text.encode_utf16().map(|unit| format!("\\u{unit:04x}")).collect();
            prop_assert_eq!(unescape(&format!("\"{}\"", numbers.concat())), Some(text));
        }
    }
}
