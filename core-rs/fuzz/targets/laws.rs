//! What holds for every scene that came through a door.

use eigenform::scene::link::{Precision, decode, encode};
use eigenform::scene::{Scene, read_json, validate, write_json};

/// It is valid, and goes out and in again by every way.
pub fn check(scene: &Scene) {
    assert_eq!(validate(scene), Ok(()));
    assert_eq!(read_json(&write_json(scene)).as_ref(), Ok(scene));
    for precision in [Precision::Exact, Precision::Short] {
        let link = encode(scene, precision);
        let opened = decode(&link.fragment).expect("a link that was made opens");
        assert_eq!(encode(&opened, precision).fragment, link.fragment);
    }
}
