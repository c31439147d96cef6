//! How long rounded links are, over formations as people make them and agents in any order.

use std::f64::consts::TAU;
use std::sync::Arc;

use eigenform::formation::Formation;
use eigenform::scene::link::{Precision, decode, encode};
use eigenform::scene::{Agent, Group, Keyframe, Scene, Segment, Track};
use glam::DVec2;

/// A small generator with a seed (Steele, Lea, Flood: `SplitMix64`, 2014).
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mixed = (self.0 ^ self.0 >> 30).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let mixed = (mixed ^ mixed >> 27).wrapping_mul(0x94D0_49BB_1331_11EB);
        mixed ^ mixed >> 31
    }

    fn below(&mut self, count: usize) -> usize {
        (self.next() % count as u64) as usize
    }

    /// In 0..1.
    fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn shuffle<T>(&mut self, items: &mut [T]) {
        for last in (1..items.len()).rev() {
            items.swap(last, self.below(last + 1));
        }
    }
}

type Place = fn(usize, usize, &mut Random) -> DVec2;

const KINDS: [(&str, Place); 7] = [
    ("grid", |agent, count, _| {
        let columns = (count as f64).sqrt().ceil() as usize;
        DVec2::new((agent % columns) as f64, (agent / columns) as f64) * 1.143
    }),
    ("ring", |agent, count, _| DVec2::from_angle(TAU * agent as f64 / count as f64) * 25.0),
    ("spiral", |agent, count, _| DVec2::from_angle(agent as f64 * 2.399_963) * (agent as f64 / count as f64).sqrt() * 25.0),
    ("arcs", |agent, count, _| {
        let (row, along) = (agent % 5, (agent / 5) as f64 / (count as f64 / 5.0));
        DVec2::from_angle(along * TAU / 2.0) * (12.0 + 2.0 * row as f64)
    }),
    ("turned block", |agent, count, _| {
        let columns = (count as f64 / 2.0).sqrt().ceil() as usize;
        DVec2::from_angle(0.4).rotate(DVec2::new((agent % columns) as f64, (agent / columns) as f64) * 1.1)
    }),
    ("cloud", |agent, _, random| {
        let spread = ((-2.0 * (1.0 - random.unit()).ln()).sqrt() * 4.0) * DVec2::from_angle(TAU * random.unit());
        spread + DVec2::new((agent % 3) as f64 * 20.0, 0.0)
    }),
    ("scatter", |_, _, random| DVec2::new(random.unit() * 91.44, random.unit() * 48.77)),
];

/// As personal names go: two or three syllables and an initial.
fn name(random: &mut Random) -> String {
    let syllable = |random: &mut Random| {
        let letter = |letters: &[u8], random: &mut Random| char::from(letters[random.below(letters.len())]);
        [letter(b"bdfghjklmnprstvyz", random), letter(b"aaeeiou", random)]
    };
    let count = 2 + random.below(2);
    let mut name: String = (0..count).flat_map(|_| syllable(random)).collect();
    name[..1].make_ascii_uppercase();
    format!("{name} {}.", char::from(b'A' + random.below(26) as u8))
}

fn scene(kinds: [Place; 4], agent_count: usize, keeps_labels: bool, random: &mut Random) -> Scene {
    let mut labels: Vec<usize> = (0..agent_count).collect();
    let keyframes = kinds.into_iter().enumerate().map(|(index, place)| {
        if index == 0 || !keeps_labels {
            random.shuffle(&mut labels);
        }
        let mut positions = vec![DVec2::ZERO; agent_count];
        for (slot, agent) in labels.iter().enumerate() {
            positions[*agent] = place(slot, agent_count, random);
        }
        Keyframe { time: index as f64 * 8.0, positions: Arc::new(Formation::new(positions)), ..Keyframe::default() }
    });
    let keyframes: Vec<Keyframe> = keyframes.collect();
    let agents = Arc::new(vec![Agent::default(); agent_count]);
    Scene { tracks: vec![Track { agents, keyframes, segments: vec![Segment::default(); 3] }], ..Scene::default() }
}

/// A personal name, one of 8 colors and of 6 groups each, and 0.8 ties an agent.
fn furnish(scene: &mut Scene, random: &mut Random) {
    let agents = Arc::make_mut(&mut scene.tracks[0].agents);
    let agent_count = agents.len();
    let colors: Vec<String> = (0..8).map(|_| format!("#{:06x}", random.below(1 << 24))).collect();
    for agent in agents {
        agent.name = name(random);
        agent.color.clone_from(&colors[random.below(8)]);
    }
    let mut groups: Vec<Group> = (0..6).map(|index| Group { name: format!("Section {}", index + 1), ..Group::default() }).collect();
    for agent in 0..agent_count as u32 {
        groups[random.below(6)].members.push(agent);
    }
    scene.groups = Arc::new(groups);
    let mut ties = std::collections::BTreeMap::new();
    while ties.len() < agent_count * 4 / 5 {
        let (a, b) = (random.below(agent_count) as u32, random.below(agent_count) as u32);
        if a != b {
            ties.insert((a.min(b), a.max(b)), [2.0, 5.0, 10.0, 0.5][random.below(4)]);
        }
    }
    Arc::make_mut(&mut scene.adjacency).ties = ties.into_iter().map(|((a, b), factor)| (a, b, factor)).collect();
}

fn payload_length(scene: &Scene) -> usize {
    let link = encode(scene, Precision::Short);
    let opened = decode(&link.fragment).expect("a link that was made opens");
    assert_eq!(encode(&opened, Precision::Exact), encode(&opened, Precision::Short), "a rounded scene is not rounded again");
    assert_eq!(encode(&opened, Precision::Exact).fragment, link.fragment);
    link.fragment.len() - "#s=1.".len()
}

fn check(agent_count: usize, plain_limit: usize, furnished_limit: usize) {
    let mut random = Random(agent_count as u64);
    let mut longest = [0; 2];
    for keeps_labels in [true, false] {
        for start in 0..KINDS.len() {
            for kinds in [[start; 4], [0, 1, 2, 3].map(|offset| (start + offset) % KINDS.len())] {
                let mut scene = scene(kinds.map(|kind| KINDS[kind].1), agent_count, keeps_labels, &mut random);
                let plain = payload_length(&scene);
                furnish(&mut scene, &mut random);
                let furnished = payload_length(&scene);
                println!("{agent_count} agents, {:?}, labels kept {keeps_labels}: {plain}, {furnished}", kinds.map(|kind| KINDS[kind].0));
                assert!(plain <= plain_limit && furnished <= furnished_limit, "{plain} and {furnished} characters");
                longest = [longest[0].max(plain), longest[1].max(furnished)];
            }
        }
    }
    println!("{agent_count} agents at most: {longest:?} of {plain_limit} and {furnished_limit}");
}

#[test]
fn a_quartet_of_formations_of_25_fits_a_chat_message() {
    check(25, 600, 1_100);
}

#[test]
fn formations_of_90_fit_a_chat_message_without_names() {
    check(90, 1_850, 2_900);
}

#[test]
fn formations_of_300_stay_short() {
    check(300, 5_500, 8_500);
}

#[test]
fn formations_of_1260_stay_short() {
    check(1_260, 22_000, 32_500);
}
