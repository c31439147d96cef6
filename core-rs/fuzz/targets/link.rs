//! Text that may hold a link. Run it with `cargo +nightly fuzz run -s none link -- -max_total_time=60`, in this folder.
#![no_main]

use eigenform::scene::link::decode;
use libfuzzer_sys::fuzz_target;

#[path = "laws.rs"]
mod laws;

fuzz_target!(|text: &str| {
    if let Ok(scene) = decode(text) {
        laws::check(&scene);
    }
});
