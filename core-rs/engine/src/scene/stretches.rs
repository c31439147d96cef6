//! Which keyframes transitions run between, where others lie in them.

use super::{Keyframe, Track};

impl Keyframe {
    /// Who is absent here and at another, ascending.
    pub fn absent_too(&self, other: &Self) -> Vec<u32> {
        self.absent.iter().copied().filter(|agent| other.absent.binary_search(agent).is_ok()).collect()
    }
}

impl Track {
    /// The keyframes that transitions run between, ascending: all but those that lie in one and bend it.
    ///
    /// A keyframe is none of the latter where agents stop, at the ends of the show, and where not the same agents are there all the way.
    pub fn anchors(&self) -> Vec<usize> {
        let last = self.keyframes.len().saturating_sub(1);
        let mut anchors = vec![0];
        let mut start = 0;
        for (end, keyframe) in self.keyframes.iter().enumerate().skip(1) {
            if end < last && keyframe.between > 0 && !keyframe.corner && keyframe.hold <= 0.0 {
                continue;
            }
            let gone = self.keyframes[start].absent_too(keyframe);
            let are_the_same = self.keyframes[start..=end].windows(2).all(|pair| pair[0].absent_too(&pair[1]) == gone);
            anchors.extend(if are_the_same { end..=end } else { start + 1..=end });
            start = end;
        }
        anchors
    }
}

impl Track {
    /// By keyframe how deep it lies in a transition; 0 for those that transitions run between.
    ///
    /// One of depth 1 bends the transition, one of depth 2 what that has made of it, and so on: whoever lies deeper was there later,
    /// and leaves to the others what they have.
    pub fn depths(&self) -> Vec<u32> {
        let mut depths: Vec<u32> = self.keyframes.iter().map(|keyframe| keyframe.between).collect();
        self.anchors().into_iter().for_each(|anchor| depths[anchor] = 0);
        depths
    }
}

#[cfg(test)]
mod tests {
    use crate::scene::read_json;

    fn anchors(keyframes: &str) -> Vec<usize> {
        let text = format!(r#"{{ "format": "eigenform", "version": 1, "agents": [{{}}, {{}}], "keyframes": [{keyframes}] }}"#);
        read_json(&text).expect("the scene is valid").main_track().anchors()
    }

    fn keyframe(time: u32, more: &str) -> String {
        format!(r#"{{ "time": {time}, {more} "positions": [[0, 0], [1, 0]] }}"#)
    }

    #[test]
    fn a_keyframe_between_ends_nothing() {
        let with = |flags: [&str; 5]| anchors(&(0..).zip(flags).map(|(time, flags)| keyframe(time, flags)).collect::<Vec<_>>().join(","));
        let between = r#""between": 1,"#;
        assert_eq!(with([""; 5]), [0, 1, 2, 3, 4]);
        assert_eq!(with(["", between, between, "", ""]), [0, 3, 4]);
        assert_eq!(with([between; 5]), [0, 4], "the show has two ends");
        assert_eq!(with(["", r#""between": 1, "corner": true,"#, between, r#""between": 1, "hold": 0.5,"#, ""]), [0, 1, 3, 4]);
    }

    #[test]
    fn nobody_comes_or_goes_in_the_middle_of_a_transition() {
        let with = |absent: [&str; 4]| {
            let flags = |(k, absent): (u32, &str)| keyframe(k, &format!(r#""between": 1, "absent": [{absent}],"#));
            anchors(&(0..).zip(absent).map(flags).collect::<Vec<_>>().join(","))
        };
        assert_eq!(with(["1", "1", "1", "1"]), [0, 3]);
        assert_eq!(with(["1", "", "", ""]), [0, 3], "who comes is there all the way");
        assert_eq!(with(["1", "1", "", ""]), [0, 1, 2, 3]);
        assert_eq!(with(["1", "", "", "1"]), [0, 1, 2, 3]);
    }
}
