//! The text of a link: finding it in what was pasted, and telling whole, cut and damaged apart.

use base64::Engine as _;
use base64::alphabet::URL_SAFE;
use base64::engine::{DecodePaddingMode, GeneralPurpose, GeneralPurposeConfig};

use crate::error::Error;

const MARK: &str = "#s=";
const VERSION: &str = "1";

/// No valid scene needs a longer payload: 500,000 ties, 200,000 positions and 40,000 corners at their longest take 14 million
/// characters.
pub const LONGEST_PAYLOAD: usize = 16 << 20;

const CHECKSUM_BYTES: usize = 4;

const BASE64: GeneralPurpose = GeneralPurpose::new(
    &URL_SAFE,
    GeneralPurposeConfig::new().with_encode_padding(false).with_decode_padding_mode(DecodePaddingMode::RequireNone),
);

/// The fragment that carries a body.
pub fn wrap(body: &[u8]) -> String {
    let mut payload = Vec::with_capacity(body.len() + 8);
    let mut length = body.len();
    while length >= 0x80 {
        payload.push(length as u8 | 0x80);
        length >>= 7;
    }
    payload.push(length as u8);
    payload.extend(crc32(body).to_le_bytes());
    payload.extend(body);
    format!("{MARK}{VERSION}.{}", BASE64.encode(payload))
}

/// The body that a link carries.
pub fn unwrap(text: &str) -> Result<Vec<u8>, Error> {
    let payload = find_payload(text)?;
    if payload.len() > LONGEST_PAYLOAD {
        return Err(Error::LinkTooLarge);
    }
    if !payload.bytes().all(|c| c.is_ascii_alphanumeric() || c == b'-' || c == b'_') {
        return Err(Error::LinkDamaged);
    }
    let (body_length, head_length) = read_length(payload)?;
    let whole = ((head_length + CHECKSUM_BYTES + body_length) * 4).div_ceil(3);
    if payload.len() < whole {
        return Err(Error::LinkCut);
    }
    let bytes = BASE64.decode(payload).map_err(|_| Error::LinkDamaged)?;
    let (checksum, body) = bytes[head_length..].split_at(CHECKSUM_BYTES);
    let is_sound = body.len() == body_length && crc32(body).to_le_bytes() == checksum;
    if is_sound { Ok(body.to_vec()) } else { Err(Error::LinkDamaged) }
}

/// What follows the version.
fn find_payload(text: &str) -> Result<&str, Error> {
    let text = text.trim_matches(is_packing);
    let Some((_, marked)) = text.split_once('#') else { return Err(Error::NotALink) };
    let Some(versioned) = marked.strip_prefix("s=") else {
        return Err(if MARK.ends_with(marked) || "s".starts_with(marked) { Error::LinkCut } else { Error::NotALink });
    };
    // What stands behind an ampersand says how a scene is shown, not what it is.
    let versioned = without_escapes(versioned.split('&').next().unwrap_or(versioned));
    let (version, payload) = versioned.split_once('.').unwrap_or((versioned, ""));
    let is_number = version.bytes().all(|c| c.is_ascii_digit()) && !version.starts_with('0');
    if !is_number || (version.is_empty() && versioned.starts_with('.')) {
        return Err(Error::LinkDamaged);
    }
    if payload.is_empty() {
        return Err(Error::LinkCut);
    }
    if version == VERSION { Ok(payload) } else { Err(Error::NewerVersion { version: version.to_owned() }) }
}

/// What a link is pasted with.
fn is_packing(c: char) -> bool {
    c.is_whitespace() || c.is_control() || "<>()[]{}\"'`“”‘’«»„.,;:!?\u{200b}\u{feff}".contains(c)
}

/// The text without what it was pasted with, where a browser has escaped that: `%3E.`
fn without_escapes(text: &str) -> &str {
    let Some((kept, escaped)) = text.find('%').map(|at| text.split_at(at)) else { return text };
    let is_only_packing = unescape(escaped).and_then(|bytes| String::from_utf8(bytes).ok()).is_some_and(|end| end.chars().all(is_packing));
    if is_only_packing { kept } else { text }
}

/// The bytes of a percent-encoded text; none where a `%` stands before anything but two hexadecimal digits.
fn unescape(text: &str) -> Option<Vec<u8>> {
    let digit = |byte: Option<u8>| char::from(byte?).to_digit(16);
    let mut bytes = text.bytes();
    let mut found = Vec::new();
    while let Some(byte) = bytes.next() {
        found.push(if byte == b'%' { (16 * digit(bytes.next())? + digit(bytes.next())?) as u8 } else { byte });
    }
    Some(found)
}

/// The length of the body and how many bytes say so.
fn read_length(payload: &str) -> Result<(usize, usize), Error> {
    let (mut length, mut bits, mut bit_count) = (0, 0_u32, 0);
    let mut byte_count = 0;
    for character in payload.bytes() {
        bits = bits << 6 | value_of(character);
        bit_count += 6;
        if bit_count < 8 {
            continue;
        }
        bit_count -= 8;
        let byte = (bits >> bit_count & 0xFF) as usize;
        length |= (byte & 0x7F) << (7 * byte_count);
        byte_count += 1;
        if byte < 0x80 {
            return Ok((length, byte_count));
        }
        if byte_count == 4 {
            return Err(Error::LinkDamaged);
        }
    }
    Err(Error::LinkCut)
}

/// Of a character of base64url.
fn value_of(character: u8) -> u32 {
    URL_SAFE.as_str().bytes().position(|known| known == character).unwrap_or(0) as u32
}

/// CRC-32 (IEEE 802.3). Half a byte at a time: a table for more bytes is 16 kB that no compression makes less.
fn crc32(bytes: &[u8]) -> u32 {
    const REMAINDERS: [u32; 16] = {
        let mut remainders = [0; 16];
        let mut half = 0;
        while half < 16 {
            let mut remainder = half as u32;
            let mut bit = 0;
            while bit < 4 {
                remainder = if remainder & 1 == 1 { remainder >> 1 ^ 0xEDB8_8320 } else { remainder >> 1 };
                bit += 1;
            }
            remainders[half] = remainder;
            half += 1;
        }
        remainders
    };
    let take = |crc: u32, half: u8| crc >> 4 ^ REMAINDERS[(crc as u8 ^ half) as usize & 0xF];
    !bytes.iter().fold(u32::MAX, |crc, byte| take(take(crc, *byte), byte >> 4))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_checksum_is_that_of_everybody() {
        assert_eq!(crc32(b"123456789"), 0xCBF4_3926);
        for size in 0..300_u32 {
            let bytes: Vec<u8> = (0..size).map(|i| (i * 97 % 256) as u8).collect();
            assert_eq!(crc32(&bytes), crc32fast::hash(&bytes));
        }
    }

    #[test]
    fn a_link_is_found_in_what_was_pasted() {
        let link = wrap(b"body");
        for (before, after) in [
            ("", ""),
            ("https://example.org/", ""),
            ("https://example.org/page/?a=b", "&embed"),
            ("  <https://example.org/", ">.\n"),
            ("(\"", "\")."),
            ("[", "]"),
            ("„", "“,"),
            ("<https://example.org/", "%3E."),
            ("https://example.org/", "%20"),
            ("https://example.org/", "%E2%80%9d!%29"),
        ] {
            assert_eq!(unwrap(&format!("{before}{link}{after}")), Ok(b"body".to_vec()), "{before}…{after}");
        }
    }

    #[test]
    fn every_cut_is_recognized() {
        for size in [0, 1, 2, 3, 100, 127, 128, 200, 20_000] {
            let body: Vec<u8> = (0..size).map(|i| (i * 37 % 251) as u8).collect();
            let link = wrap(&body);
            for length in 1..link.len() {
                assert_eq!(unwrap(&link[..length]), Err(Error::LinkCut), "{length} of {}", link.len());
            }
        }
    }

    #[test]
    fn other_text_is_refused_for_what_it_is() {
        for (text, error) in [
            ("", Error::NotALink),
            ("https://example.org/", Error::NotALink),
            ("https://example.org/#top", Error::NotALink),
            ("#s=2.AAAA", Error::NewerVersion { version: "2".to_owned() }),
            ("#s=12.AAAA", Error::NewerVersion { version: "12".to_owned() }),
            ("#s=0.AAAA", Error::LinkDamaged),
            ("#s=.AAAA", Error::LinkDamaged),
            ("#s=one.AAAA", Error::LinkDamaged),
            ("#s=1.AA*A", Error::LinkDamaged),
            ("#s=1.AAAA%3EAAAA", Error::LinkDamaged),
            ("#s=1.AAAA%3", Error::LinkDamaged),
            ("#s=1.AAAA%E2%80", Error::LinkDamaged),
            ("#s=1._____w", Error::LinkDamaged),
        ] {
            assert_eq!(unwrap(text), Err(error), "{text}");
        }
        assert_eq!(unwrap(&format!("{}A", wrap(b"body"))), Err(Error::LinkDamaged));
        let link = wrap(b"body");
        let (start, end) = link.split_at(link.len() - 3);
        assert_eq!(unwrap(&format!("{start}{}{}", if end.starts_with('A') { 'B' } else { 'A' }, &end[1..])), Err(Error::LinkDamaged));
        assert_eq!(unwrap(&format!("#s=1.{}", "A".repeat(LONGEST_PAYLOAD + 1))), Err(Error::LinkTooLarge));
    }
}
