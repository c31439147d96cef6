//! Scene files.
#![no_main]

use eigenform::scene::read_json;
use libfuzzer_sys::fuzz_target;

#[path = "laws.rs"]
mod laws;

fuzz_target!(|text: &str| {
    if let Ok(scene) = read_json(text) {
        laws::check(&scene);
    }
});
