//! Those near one agent, picked out first and pushed then: whether somebody is near is a coin's toss, and what a coin decides no
//! processor foresees. Picked out, they are pushed several at a time.

use std::ops::Range;

use wide::f32x4;

use crate::push::Push;
use crate::ranks::Ranks;

/// So many are weighed side by side.
const LANES: usize = 4;

/// So many are picked out before they are pushed.
const ROOM: usize = 128;

/// So many are looked at before it is seen whether there is room.
const LOOK: usize = ROOM / 2;

/// What agents do to each other.
#[derive(Clone, Copy, Debug)]
pub struct Pushes {
    /// Everybody.
    pub all: Push,
    /// Those of other subgroups beside.
    pub strangers: Option<Push>,
}

/// The near of one agent.
#[derive(Clone, Debug)]
pub struct Near {
    count: usize,
    /// By place in the ranks.
    who: [u32; ROOM],
    way: [[f32; ROOM]; 2],
    girth: [f32; ROOM],
    /// 1 for a stranger, else 0.
    strange: [f32; ROOM],
    push: [[f32; ROOM]; 2],
}

impl Near {
    pub fn new() -> Self {
        let zeros = [0.0; ROOM];
        Self { count: 0, who: [0; ROOM], way: [zeros; 2], girth: zeros, strange: zeros, push: [zeros; 2] }
    }

    /// Looks for those near `here` in a run of the ranks, and pushes whenever there is no room for more.
    pub fn look(&mut self, ranks: &mut Ranks, here: usize, run: Range<usize>, pushes: &Pushes) {
        let mut from = run.start;
        while from < run.end {
            let end = run.end.min(from + LOOK);
            self.pick(ranks, here, from..end, pushes);
            from = end;
            if self.count > ROOM - LOOK {
                self.push(ranks, here, pushes);
            }
        }
    }

    fn pick(&mut self, ranks: &Ranks, here: usize, run: Range<usize>, pushes: &Pushes) {
        let (at, own_girth, own_group) = ([ranks.x[here], ranks.y[here]], ranks.girth[here], ranks.group[here]);
        let usual = pushes.all.range + own_girth;
        let strange = pushes.strangers.map_or(usual, |strangers| usual.max(strangers.range + own_girth));
        let places = ranks.x[run.clone()].iter().zip(&ranks.y[run.clone()]);
        let bodies = ranks.girth[run.clone()].iter().zip(&ranks.group[run.clone()]);
        let mut count = self.count;
        for (who, ((x, y), (girth, group))) in (run.start as u32..).zip(places.zip(bodies)) {
            let (x, y) = (at[0] - x, at[1] - y);
            let range = girth + if *group == own_group { usual } else { strange };
            self.who[count % ROOM] = who;
            count += usize::from(x * x + y * y < range * range);
        }
        self.count = count;
    }

    /// Adds the pushes between `here` and all who were picked out, and forgets them.
    pub fn push(&mut self, ranks: &mut Ranks, here: usize, pushes: &Pushes) {
        let count = self.count.min(ROOM);
        self.count = 0;
        let (own_girth, own_group) = (ranks.girth[here], ranks.group[here]);
        for (k, who) in self.who[..count].iter().enumerate() {
            let who = *who as usize;
            [self.way[0][k], self.way[1][k]] = ranks.way(here, who);
            self.girth[k] = (own_girth + ranks.girth[who]) as f32;
            self.strange[k] = if ranks.group[who] == own_group { 0.0 } else { 1.0 };
        }
        self.weigh(count, pushes);
        let mut own = [0.0; 2];
        for (k, who) in self.who[..count].iter().enumerate() {
            let who = *who as usize;
            let push = [f64::from(self.push[0][k]), f64::from(self.push[1][k])];
            (own[0], own[1]) = (own[0] + push[0], own[1] + push[1]);
            ranks.fx[who] -= push[0];
            ranks.fy[who] -= push[1];
        }
        ranks.fx[here] += own[0];
        ranks.fy[here] += own[1];
    }

    fn weigh(&mut self, count: usize, pushes: &Pushes) {
        let fours = |list: &[f32; ROOM], at: usize| f32x4::from(list.as_chunks().0[at]);
        for at in 0..count.div_ceil(LANES) {
            let (x, y) = (fours(&self.way[0], at), fours(&self.way[1], at));
            let (apart, girth) = ((x * x + y * y).sqrt(), fours(&self.girth, at));
            let mut push = pushes.all.per_way(apart, girth);
            if let Some(strangers) = &pushes.strangers {
                push += fours(&self.strange, at) * strangers.per_way(apart, girth);
            }
            self.push[0].as_chunks_mut().0[at] = (push * x).to_array();
            self.push[1].as_chunks_mut().0[at] = (push * y).to_array();
        }
    }
}
