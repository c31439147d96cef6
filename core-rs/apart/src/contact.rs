//! Two who push one another at a knot, and which side they pass on.

/// A pair at a knot, in the order of (i, j, knot).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Key(u64);

const KNOT_BITS: u32 = 16;
const AGENT_BITS: u32 = 24;

impl Key {
    pub(crate) fn new(i: u32, j: u32, knot: usize) -> Self {
        Self(((u64::from(i) << AGENT_BITS | u64::from(j)) << KNOT_BITS) | knot as u64)
    }

    pub(crate) fn pair(self) -> (usize, usize) {
        let pair = self.0 >> KNOT_BITS;
        ((pair >> AGENT_BITS) as usize, (pair % (1 << AGENT_BITS)) as usize)
    }

    pub(crate) fn knot(self) -> usize {
        (self.0 % (1 << KNOT_BITS)) as usize
    }

    /// Whether both are of one pair in one sixth of the segment.
    pub(crate) fn is_one_pass(self, other: Self, knot_count: usize) -> bool {
        let sixth = |key: Self| 6 * key.knot() / knot_count;
        self.0 >> KNOT_BITS == other.0 >> KNOT_BITS && sixth(self) == sixth(other)
    }

    /// Numbers without order, the same everywhere (the finalizer of `SplitMix64`).
    pub(crate) fn hash(self, seed: u64) -> u64 {
        let mut mixed = self.0 ^ seed.wrapping_mul(0x9e37_79b9_7f4a_7c15);
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }
}

/// On which side of j agent i passes, as seen along their relative way; one for a pair and a sixth of the segment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Side {
    Undecided,
    Right,
    Left,
}

/// What a pair at a knot has been pushed so far.
#[derive(Clone, Debug)]
pub(crate) struct Contact {
    pub(crate) key: Key,
    /// On i; on j the same the other way.
    pub(crate) impulse: [f64; 3],
    pub(crate) depth: f64,
    pub(crate) side: Side,
    /// Visits in a row that left it far too near.
    pub(crate) strikes: u8,
}

impl Contact {
    pub(crate) fn new(key: Key, depth: f64) -> Self {
        Self { key, impulse: [0.0; 3], depth, side: Side::Undecided, strikes: 0 }
    }

    pub(crate) fn is_at_rest(&self) -> bool {
        self.impulse == [0.0; 3] && self.depth <= 0.0
    }
}

impl Side {
    pub(crate) fn sign(self) -> f64 {
        if self == Self::Left { -1.0 } else { 1.0 }
    }

    pub(crate) fn other(self) -> Self {
        if self == Self::Left { Self::Right } else { Self::Left }
    }
}
