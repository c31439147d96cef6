//! Well-formed JSON taken apart without being read: which bytes are an entry, a name, a value.
//!
//! Only for text that a parser has passed: nothing is checked here, so that taking apart costs little more than looking at it,
//! stops wherever the caller stops, and needs no stack however deep the nesting.

/// The entries of a list, as slices.
pub(super) fn entries(list: &str) -> impl Iterator<Item = &str> {
    let mut rest = inside(list);
    std::iter::from_fn(move || take_value(&mut rest))
}

/// Names, still quoted, and values of an object, as slices.
pub(super) fn fields(object: &str) -> impl Iterator<Item = (&str, &str)> {
    let mut rest = inside(object);
    std::iter::from_fn(move || Some((take_value(&mut rest)?, take_value(&mut rest)?)))
}

fn inside(container: &str) -> &str {
    let container = container.trim_ascii();
    container.get(1..container.len().saturating_sub(1)).unwrap_or("")
}

/// The next value, which a comma or colon may precede.
fn take_value<'a>(rest: &mut &'a str) -> Option<&'a str> {
    let text = rest.trim_start_matches([',', ':', ' ', '\t', '\n', '\r']);
    if text.is_empty() {
        return None;
    }
    let (value, after) = text.split_at(value_length(text.as_bytes()));
    *rest = after;
    Some(value)
}

fn value_length(text: &[u8]) -> usize {
    match text[0] {
        b'"' => string_length(text),
        b'{' | b'[' => container_length(text),
        _ => text.iter().position(|b| matches!(b, b',' | b':' | b']' | b'}' | b' ' | b'\t' | b'\n' | b'\r')).unwrap_or(text.len()),
    }
}

fn container_length(text: &[u8]) -> usize {
    let (mut at, mut depth) = (0, 0_usize);
    while at < text.len() {
        match text[at] {
            b'"' => at += string_length(&text[at..]) - 1,
            b'{' | b'[' => depth += 1,
            b'}' | b']' => depth -= 1,
            _ => {}
        }
        at += 1;
        if depth == 0 {
            break;
        }
    }
    at
}

fn string_length(text: &[u8]) -> usize {
    let mut at = 1;
    while at < text.len() && text[at] != b'"' {
        at += if text[at] == b'\\' { 2 } else { 1 };
    }
    (at + 1).min(text.len())
}

#[cfg(test)]
mod tests {
    use proptest::collection::vec;
    use proptest::prelude::*;
    use serde_json::Value;

    use super::*;

    fn json() -> impl Strategy<Value = Value> {
        let leaf = prop_oneof![
            Just(Value::Null),
            any::<bool>().prop_map(Value::from),
            any::<i32>().prop_map(Value::from),
            ".*".prop_map(Value::from)
        ];
        leaf.prop_recursive(4, 64, 6, |inner| {
            let object = vec(("[a-z\\\\\":,]*", inner.clone()), 0..6).prop_map(|fields| fields.into_iter().collect());
            prop_oneof![vec(inner, 0..6).prop_map(Value::Array), object]
        })
    }

    fn parse(text: &str) -> Value {
        serde_json::from_str(text).unwrap()
    }

    proptest! {
        #[test]
        fn the_parts_are_what_a_parser_finds(value in json(), is_spread in any::<bool>()) {
            let text = if is_spread { serde_json::to_string_pretty(&value) } else { serde_json::to_string(&value) }.unwrap();
            match value {
                Value::Array(list) => prop_assert_eq!(entries(&text).map(parse).collect::<Vec<_>>(), list),
                Value::Object(object) => {
                    let parts = fields(&text).map(|(name, value)| (parse(name).as_str().unwrap().to_owned(), parse(value)));
                    prop_assert_eq!(parts.collect::<serde_json::Map<_, _>>(), object);
                }
                _ => {}
            }
        }
    }
}
