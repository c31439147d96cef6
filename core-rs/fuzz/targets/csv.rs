//! Keyframe CSV.
#![no_main]

use eigenform::scene::{read_csv, write_csv};
use libfuzzer_sys::fuzz_target;

#[path = "laws.rs"]
mod laws;

fuzz_target!(|text: &str| {
    if let Ok(read) = read_csv(text) {
        laws::check(&read.scene);
        let written = write_csv(&read.scene).text;
        if !read.scene.main_track().agents.is_empty() {
            let again = read_csv(&written).expect("what is written reads back");
            let places = |scene: &eigenform::scene::Scene| {
                let keyframes = &scene.main_track().keyframes;
                keyframes.iter().map(|keyframe| (keyframe.time, keyframe.positions.clone())).collect::<Vec<_>>()
            };
            assert_eq!(places(&again.scene), places(&read.scene));
        }
    }
});
