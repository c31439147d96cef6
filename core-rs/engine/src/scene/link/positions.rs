//! Formations: each as the cheapest of a few tellings.
//!
//! A formation is told along a route (agents in index order, along a curve through the formation before, or in an order of its own), as
//! differences of places or of displacements since the formation before; scattered agents are told one by one within their box.

use super::models::{Integer, code_even};
use super::range::{Bit, Coder, Writer};
use super::route::{Cell, along_curve, by_rows};
use super::step::is_near;
use crate::error::Error;

/// In which order agents are told.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
enum Route {
    /// By index.
    #[default]
    Agents,
    /// Along the Hilbert curve through the formation before.
    Curve,
    /// As the latest order told.
    Last,
    /// In an order that is told with it.
    Own,
}

/// How a formation is told.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
enum Telling {
    /// As an earlier formation.
    Again { formation: u32 },
    /// Each agent on its own.
    #[default]
    Scattered,
    /// Along a route.
    Routed { route: Route, is_displacement: bool, is_curved: bool },
}

const ROUTES: [Route; 4] = [Route::Agents, Route::Curve, Route::Last, Route::Own];

/// Codes the formations of a scene one after the other; each learns from those before.
#[derive(Default)]
pub struct Formations {
    past: Vec<Vec<Cell>>,
    models: Models,
}

/// What has been learned.
#[derive(Clone, Default)]
struct Models {
    /// The latest order told.
    order: Vec<u32>,
    follows: Bit,
    /// By telling: places or displacements, straight or curved.
    deltas: [Deltas; 4],
}

impl Formations {
    /// Codes one formation; a reader's `cells` has the right length.
    pub fn code(&mut self, coder: &mut dyn Coder, cells: &mut Vec<Cell>) -> Result<(), Error> {
        let (mut telling, mut order) = if coder.is_reading() { <_>::default() } else { self.cheapest(cells) };
        self.code_telling(coder, &mut telling)?;
        self.models.code(coder, telling, &self.past, &mut order, cells)?;
        if cells.iter().flatten().any(|index| !is_near(*index)) {
            return Err(Error::LinkDamaged);
        }
        self.past.push(cells.clone());
        Ok(())
    }

    fn cheapest(&self, cells: &[Cell]) -> (Telling, Vec<u32>) {
        if let Some(formation) = self.past.iter().position(|past| past == cells) {
            return (Telling::Again { formation: formation as u32 }, Vec::new());
        }
        let orders = [along_curve(cells), by_rows(cells, 0), by_rows(cells, 1)];
        let mut best = (self.cost(Telling::Scattered, &mut Vec::new(), cells), Telling::Scattered, Vec::new());
        for route in ROUTES {
            let has_past = !self.past.is_empty();
            let is_open = match route {
                Route::Agents | Route::Own => true,
                Route::Curve => has_past,
                Route::Last => !self.models.order.is_empty(),
            };
            let own = if route == Route::Own { &orders[..] } else { &orders[..1] };
            for order in own.iter().filter(|_| is_open) {
                for is_displacement in [false, true].into_iter().take(1 + usize::from(has_past)) {
                    for is_curved in [false, true] {
                        let telling = Telling::Routed { route, is_displacement, is_curved };
                        let mut order = order.clone();
                        let cost = self.cost(telling, &mut order, cells);
                        if cost < best.0 {
                            best = (cost, telling, order);
                        }
                    }
                }
            }
        }
        (best.1, best.2)
    }

    /// In bytes.
    fn cost(&self, telling: Telling, order: &mut Vec<u32>, cells: &[Cell]) -> usize {
        let mut writer = Writer::default();
        let written = self.models.clone().code(&mut writer, telling, &self.past, order, &mut cells.to_vec());
        assert!(written.is_ok(), "what is written is sound");
        writer.len()
    }

    fn code_telling(&self, coder: &mut dyn Coder, telling: &mut Telling) -> Result<(), Error> {
        let (mut kind, mut formation, mut route, mut is_displacement, mut is_curved) = match *telling {
            Telling::Scattered => (0, 0, 0, false, false),
            Telling::Again { formation } => (1, formation, 0, false, false),
            Telling::Routed { route, is_displacement, is_curved } => (2, 0, route as u32, is_displacement, is_curved),
        };
        coder.even(3, &mut kind);
        let past = self.past.len() as u32;
        *telling = match kind {
            0 => Telling::Scattered,
            1 if past == 0 => return Err(Error::LinkDamaged),
            1 => {
                coder.even(past, &mut formation);
                Telling::Again { formation }
            }
            _ => {
                coder.even(4, &mut route);
                coder.bit(&mut Bit::default(), &mut is_displacement);
                coder.bit(&mut Bit::default(), &mut is_curved);
                let route = ROUTES[route as usize];
                let needs_past = is_displacement || route == Route::Curve;
                if needs_past && past == 0 || route == Route::Last && self.models.order.is_empty() {
                    return Err(Error::LinkDamaged);
                }
                Telling::Routed { route, is_displacement, is_curved }
            }
        };
        Ok(())
    }
}

impl Models {
    fn code(
        &mut self,
        coder: &mut dyn Coder,
        telling: Telling,
        past: &[Vec<Cell>],
        order: &mut Vec<u32>,
        cells: &mut Vec<Cell>,
    ) -> Result<(), Error> {
        match telling {
            Telling::Again { formation } => cells.clone_from(&past[formation as usize]),
            Telling::Scattered => code_scattered(coder, cells)?,
            Telling::Routed { route, is_displacement, is_curved } => {
                match route {
                    Route::Agents => *order = (0..cells.len() as u32).collect(),
                    Route::Curve => *order = past.last().map(|past| along_curve(past)).unwrap_or_default(),
                    Route::Last => order.clone_from(&self.order),
                    Route::Own => {
                        self.code_order(coder, order, cells.len());
                        self.order.clone_from(order);
                    }
                }
                let from = past.last().filter(|_| is_displacement);
                let models = &mut self.deltas[usize::from(is_displacement) * 2 + usize::from(is_curved)];
                models.code_route(coder, order, from.map(Vec::as_slice), is_curved, cells);
            }
        }
        Ok(())
    }

    /// A permutation: each agent is the next by index or one of those left, all equally likely.
    fn code_order(&mut self, coder: &mut dyn Coder, order: &mut Vec<u32>, agent_count: usize) {
        order.resize(agent_count, 0);
        let mut left: Vec<u32> = (0..agent_count as u32).collect();
        let mut place = left.clone();
        let mut expected = 0;
        for agent in order.iter_mut() {
            let is_left = place.get(expected as usize).is_some_and(|at| (*at as usize) < left.len() && left[*at as usize] == expected);
            let mut follows = is_left && *agent == expected;
            if is_left {
                coder.bit(&mut self.follows, &mut follows);
            }
            let mut at = if follows { place[expected as usize] } else { place[*agent as usize] };
            if !follows {
                coder.even(left.len() as u32, &mut at);
            }
            *agent = left.swap_remove(at as usize);
            if let Some(moved) = left.get(at as usize) {
                place[*moved as usize] = at;
            }
            expected = *agent + 1;
        }
    }
}

/// Each coordinate one of those within the box.
fn code_scattered(coder: &mut dyn Coder, cells: &mut [Cell]) -> Result<(), Error> {
    for axis in 0..2 {
        let mut low = cells.iter().map(|cell| cell[axis]).min().unwrap_or(0);
        let mut span = cells.iter().map(|cell| cell[axis] - low).max().unwrap_or(0);
        Integer::default().code(coder, &mut low);
        Integer::default().code(coder, &mut span);
        if !is_near(low) || !is_near(span) || span < 0 {
            return Err(Error::LinkDamaged);
        }
        for cell in cells.iter_mut() {
            let mut above = (cell[axis] - low) as u64;
            code_even(coder, span as u64 + 1, &mut above);
            cell[axis] = low + above.cast_signed();
        }
    }
    Ok(())
}

/// Differences along a route.
#[derive(Clone, Default)]
struct Deltas {
    repeats: [Bit; 2],
    /// By axis, then by how large the last one was.
    sizes: [[Integer; 3]; 2],
}

impl Deltas {
    /// Codes cells, or displacements `from` the cells of the formation before, in the order of the route.
    fn code_route(&mut self, coder: &mut dyn Coder, order: &[u32], from: Option<&[Cell]>, is_curved: bool, cells: &mut [Cell]) {
        let (mut last, mut last_delta, mut last_residual) = ([0; 2], [0; 2], [0; 2]);
        let mut repeated = false;
        for agent in order {
            let origin = from.map_or([0; 2], |from| from[*agent as usize]);
            let cell = &mut cells[*agent as usize];
            let value = minus(*cell, origin);
            let mut delta = minus(value, last);
            let mut repeats = delta == last_delta;
            coder.bit(&mut self.repeats[usize::from(repeated)], &mut repeats);
            if repeats {
                delta = last_delta;
            } else {
                let base = if is_curved { last_delta } else { [0; 2] };
                let mut residual = minus(delta, base);
                for axis in 0..2 {
                    let size = [0, 4].into_iter().filter(|limit| last_residual[axis] > *limit).count();
                    self.sizes[axis][size].code(coder, &mut residual[axis]);
                }
                delta = plus(base, residual);
                last_residual = residual.map(i64::abs);
            }
            last = plus(last, delta);
            *cell = plus(last, origin);
            (last_delta, repeated) = (delta, repeats);
        }
    }
}

// Wrapping, because a damaged link may ask for anything; what is read is checked afterwards.
fn plus(a: Cell, b: Cell) -> Cell {
    [a[0].wrapping_add(b[0]), a[1].wrapping_add(b[1])]
}

fn minus(a: Cell, b: Cell) -> Cell {
    [a[0].wrapping_sub(b[0]), a[1].wrapping_sub(b[1])]
}
