//! What a link's checksum lets through: any body with a sound head.
#![no_main]

use base64::Engine as _;
use base64::prelude::BASE64_URL_SAFE_NO_PAD;
use eigenform::scene::link::decode;
use libfuzzer_sys::fuzz_target;

#[path = "laws.rs"]
mod laws;

fuzz_target!(|body: &[u8]| {
    if let Ok(scene) = decode(&sealed(body)) {
        laws::check(&scene);
    }
});

fn sealed(body: &[u8]) -> String {
    let length = body.len();
    let mut payload = vec![length as u8 | 0x80, (length >> 7) as u8 | 0x80, (length >> 14) as u8 & 0x7F];
    payload.extend(crc32fast::hash(body).to_le_bytes());
    payload.extend(body);
    format!("#s=1.{}", BASE64_URL_SAFE_NO_PAD.encode(payload))
}
