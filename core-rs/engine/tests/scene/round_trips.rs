//! A scene survives every way out and in again.

use std::sync::Arc;

use crate::scenes::arbitrary_scene;
use eigenform::scene::{self, Scene, document, read_json, write_json};
use glam::DVec2;
use proptest::prelude::*;

/// A formation as the page has it.
#[derive(serde::Deserialize)]
struct Flat {
    xy: Vec<f64>,
    heights: Option<Vec<f64>>,
}

/// The document as the page sends it, positions still in place: the one track's fields at the top, obstacles flat.
fn rest_of(scene: &Scene) -> serde_json::Value {
    let mut value: serde_json::Value = serde_json::from_str(&document::write(scene)).unwrap();
    let top = value.as_object_mut().unwrap();
    let mut tracks = top.remove("tracks").unwrap();
    top.append(tracks[0].as_object_mut().unwrap());
    for obstacle in top["obstacles"].as_array_mut().unwrap() {
        let mut shape = obstacle.as_object_mut().unwrap().remove("shape").unwrap();
        obstacle.as_object_mut().unwrap().append(shape.as_object_mut().unwrap());
    }
    value
}

proptest! {
    #[test]
    fn every_generated_scene_is_valid(scene in arbitrary_scene()) {
        prop_assert_eq!(scene::validate(&scene), Ok(()));
    }

    #[test]
    fn a_scene_file_reads_back_as_the_scene_written(scene in arbitrary_scene()) {
        let text = write_json(&scene);
        let read = read_json(&text).map_err(|error| TestCaseError::fail(format!("{error} ({}): {text}", error.place())))?;
        prop_assert_eq!(&read, &scene);
        // Debug text tells −0 from 0, which equality does not.
        prop_assert_eq!(format!("{read:?}"), format!("{scene:?}"));
        prop_assert_eq!(write_json(&read), text);
    }

    #[test]
    fn a_page_document_reads_back_with_its_formations(scene in arbitrary_scene()) {
        let mut value = rest_of(&scene);
        for (keyframe, expected) in value["keyframes"].as_array_mut().unwrap().iter_mut().zip(&scene.tracks[0].keyframes) {
            let positions = keyframe.as_object_mut().unwrap().remove("positions").unwrap();
            let Flat { xy, heights } = serde_json::from_value(positions).unwrap();
            prop_assert_eq!(xy, expected.positions.positions().iter().flat_map(DVec2::to_array).collect::<Vec<_>>());
            prop_assert_eq!(heights.as_deref(), expected.positions.heights());
        }
        let formations: Vec<_> = scene.tracks[0].keyframes.iter().map(|keyframe| Arc::clone(&keyframe.positions)).collect();
        let read = document::read(&value.to_string(), formations.clone());
        prop_assert_eq!(read.as_ref(), Ok(&scene));
        for (keyframe, formation) in read.unwrap().tracks[0].keyframes.iter().zip(&formations) {
            prop_assert!(Arc::ptr_eq(&keyframe.positions, formation));
        }
    }
}

#[test]
fn a_page_document_has_a_formation_for_every_keyframe_and_no_positions() {
    let scene = Scene::default();
    let whole = rest_of(&scene).to_string();
    let rest = whole.replace(",\"positions\":{\"heights\":null,\"xy\":[]}", "");
    let formation = Arc::clone(&scene.main_track().keyframes[0].positions);
    assert_eq!(document::read(&rest, vec![Arc::clone(&formation)]), Ok(scene));
    let cases = [
        (rest.clone(), vec![], "wrong-count"),
        (rest.clone(), vec![Arc::clone(&formation); 2], "wrong-count"),
        (whole, vec![Arc::clone(&formation)], "unknown-field"),
        (rest.replace("\"keyframes\":[", "\"keyframes\":[{}],\"x\":["), vec![Arc::clone(&formation)], "unknown-field"),
        ("{".to_owned(), vec![Arc::clone(&formation)], "invalid-json"),
        (rest.replace("30.0", "500.0"), vec![formation], "out-of-range"),
    ];
    for (rest, formations, code) in cases {
        assert_eq!(document::read(&rest, formations).expect_err(&rest).code(), code, "{rest}");
    }
}
