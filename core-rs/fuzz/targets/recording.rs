//! Recordings of motion.
#![no_main]

use eigenform::scene::recording::read_recording;
use libfuzzer_sys::fuzz_target;

#[path = "laws.rs"]
mod laws;

fuzz_target!(|text: &str| {
    if let Ok(recording) = read_recording(text) {
        assert!(recording.frame_count >= 2 && recording.frame_rate.is_finite());
        if let Ok(made) = recording.scene(&[0, recording.frame_count - 1]) {
            laws::check(&made.scene);
        }
    }
});
