//! What a link promises: the same scene after the way out and in, and one answer for everything else.

use std::sync::Arc;

use crate::scenes::arbitrary_scene;
use base64::Engine as _;
use base64::prelude::BASE64_URL_SAFE_NO_PAD as URL_SAFE_NO_PAD;
use eigenform::error::Error;
use eigenform::formation::Formation;
use eigenform::scene::link::{Precision, decode, encode};
use eigenform::scene::{Agent, Scene, validate};
use glam::DVec2;
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};

/// The scene with every coordinate passed through `change`.
fn with_coordinates(scene: &Scene, change: impl Fn(f64) -> f64) -> Scene {
    let mut scene = scene.clone();
    for keyframe in &mut scene.tracks[0].keyframes {
        let moved = keyframe.positions.positions().iter().map(|p| DVec2::new(change(p.x), change(p.y))).collect();
        keyframe.positions = Arc::new(match keyframe.positions.heights() {
            Some(heights) => Formation::spatial(moved, heights.iter().map(|z| change(*z)).collect()),
            None => Formation::new(moved),
        });
    }
    scene
}

/// The farthest that an agent is moved, meters.
fn farthest(a: &Scene, b: &Scene) -> f64 {
    let moved = a.tracks[0].keyframes.iter().zip(&b.tracks[0].keyframes).flat_map(|(a, b)| {
        let pairs = a.positions.positions().iter().zip(b.positions.positions()).enumerate();
        pairs.map(|(agent, (p, q))| p.distance(*q).hypot(a.positions.height(agent) - b.positions.height(agent)))
    });
    moved.fold(0.0, f64::max)
}

fn extent(scene: &Scene) -> f64 {
    let formations = scene.tracks[0].keyframes.iter().map(|keyframe| &keyframe.positions);
    let all = formations.clone().flat_map(|formation| formation.positions()).copied().collect();
    let heights = formations.flat_map(|formation| (0..formation.agent_count()).map(|agent| formation.height(agent))).collect();
    Formation::spatial(all, heights).extent()
}

proptest! {
    #[test]
    fn a_scene_drawn_on_a_grid_comes_back_equal(scene in arbitrary_scene(), parts in prop::sample::select(vec![100.0, 50.0, 8.0, 4.0, 1.0])) {
        let drawn = with_coordinates(&scene, |x| (x * parts).round() / parts);
        let link = encode(&drawn, Precision::Exact);
        prop_assert_eq!((link.rounding, link.broken_keyframes.len()), (0.0, 0));
        prop_assert_eq!(decode(&link.fragment), Ok(drawn));
    }

    #[test]
    fn an_exact_link_moves_no_agent(scene in arbitrary_scene()) {
        let link = encode(&scene, Precision::Exact);
        let opened = decode(&link.fragment).map_err(|error| TestCaseError::fail(error.to_string()))?;
        // Each of three coordinates within 1e-6 m, and once more where a coarser step represents what the first one made.
        prop_assert!(farthest(&scene, &opened) <= 2.0 * 3.0_f64.sqrt() * 1e-6);
        prop_assert_eq!(with_coordinates(&opened, |_| 0.0), with_coordinates(&scene, |_| 0.0));
        prop_assert_eq!(encode(&opened, Precision::Exact).fragment, link.fragment);
    }

    #[test]
    fn a_short_link_says_how_far_it_moves_agents(scene in arbitrary_scene()) {
        let link = encode(&scene, Precision::Short);
        let opened = decode(&link.fragment).map_err(|error| TestCaseError::fail(error.to_string()))?;
        // Half a step each of three ways, a step being at most 1/64 above 1/4095 of the longest side and that a little more for the
        // ends; 1e-6 m as above.
        prop_assert!(link.rounding <= extent(&scene) / 4_095.0 * 1.04 * 3.0_f64.sqrt() / 2.0 + 4e-6);
        prop_assert!((farthest(&scene, &opened) - link.rounding).abs() <= 4e-6);
        for precision in [Precision::Exact, Precision::Short] {
            let again = encode(&opened, precision);
            prop_assert_eq!(&again.fragment, &link.fragment);
            prop_assert!(again.rounding <= 0.0);
        }
    }

    #[test]
    fn a_link_cut_anywhere_is_recognized_as_cut(scene in arbitrary_scene()) {
        let fragment = encode(&scene, Precision::Short).fragment;
        for length in 1..fragment.len() {
            prop_assert_eq!(decode(&fragment[..length]), Err(Error::LinkCut));
        }
    }
}

#[test]
fn rounding_stays_within_the_limit_of_coordinates() {
    let mut scene = Scene::default();
    let positions = [-99_999.8, -99_999.1, 12_345.6, 99_990.0, 99_999.9].map(|x| DVec2::new(x, -x));
    scene.tracks[0].agents = Arc::new(vec![Agent::default(); positions.len()]);
    scene.tracks[0].keyframes[0].positions = Arc::new(Formation::new(positions.to_vec()));
    let opened = decode(&encode(&scene, Precision::Short).fragment).expect("every coordinate is admissible");
    assert!(farthest(&scene, &opened) > 1.0);
}

fn runner() -> TestRunner {
    TestRunner::new_with_rng(Config::default(), TestRng::from_seed(RngAlgorithm::ChaCha, &[7; 32]))
}

fn fragments(runner: &mut TestRunner) -> Vec<String> {
    let precisions = [Precision::Exact, Precision::Short].into_iter().cycle().take(100);
    precisions.map(|precision| encode(&arbitrary_scene().new_tree(runner).expect("a scene").current(), precision).fragment).collect()
}

/// Changes one to three places: another byte of `bytes`, one more, one less, or nothing from there on.
fn mutate(text: &mut Vec<u8>, bytes: std::ops::Range<u8>, runner: &mut TestRunner) {
    for _ in 0..runner.rng().random_range(1..4) {
        let at = runner.rng().random_range(0..=text.len());
        let byte = runner.rng().random_range(bytes.clone());
        match runner.rng().random_range(0..8) {
            0..4 if at < text.len() => text[at] = byte,
            4..6 if at < text.len() => {
                text.remove(at);
            }
            6 => text.truncate(at),
            _ => text.insert(at, byte),
        }
    }
}

fn check_answer(text: &str) {
    if let Ok(scene) = decode(text) {
        assert_eq!(validate(&scene), Ok(()), "{text}");
    }
}

#[test]
fn ten_thousand_mutated_links_are_refused_or_valid() {
    let mut runner = runner();
    for fragment in fragments(&mut runner).iter().cycle().take(10_000) {
        let mut text = fragment.clone().into_bytes();
        mutate(&mut text, 0x20..0x7F, &mut runner);
        check_answer(&String::from_utf8(text).expect("printable characters"));
    }
}

#[test]
fn ten_thousand_mutated_bodies_with_a_sound_checksum_are_refused_or_valid() {
    let mut runner = runner();
    for fragment in fragments(&mut runner).iter().cycle().take(10_000) {
        let payload = URL_SAFE_NO_PAD.decode(fragment.strip_prefix("#s=1.").expect("version 1")).expect("base64url");
        let length_bytes = 1 + payload.iter().take_while(|byte| **byte >= 0x80).count();
        let mut body = payload[length_bytes + 4..].to_vec();
        mutate(&mut body, 0..0xFF, &mut runner);
        check_answer(&sealed(&body));
    }
}

fn sealed(body: &[u8]) -> String {
    assert!(body.len() < 1 << 14, "a length of two bytes");
    let mut payload = vec![body.len() as u8 | 0x80, (body.len() >> 7) as u8];
    payload.extend(crc32fast::hash(body).to_le_bytes());
    payload.extend(body);
    format!("#s=1.{}", URL_SAFE_NO_PAD.encode(payload))
}

#[test]
fn a_deflate_bomb_is_no_scene() {
    let bomb = miniz_oxide::deflate::compress_to_vec(&vec![0; 64 << 20], 9);
    assert_eq!(decode(&format!("#s=1.{}", URL_SAFE_NO_PAD.encode(&bomb))), Err(Error::LinkDamaged));
}
