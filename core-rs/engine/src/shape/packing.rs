//! As many places as a shape holds at a distance, row by row.

use glam::DVec2;

use super::region::Region;

/// Rows for one distance: a place is put lower than it could be by a row at most.
const ROWS: f64 = 24.0;

/// A hair more than the distance, so that rounding leaves nobody nearer.
const HAIR: f64 = 1e-9;

/// Places inside that are at least `distance` apart, from the top to the bottom and each row from the left: wherever there is room, until
/// there are `limit` of them.
///
/// A line of the shape that is thinner than the distance gets its places like any other part, and in the open the rows come to stand as in
/// a triangular lattice. O(places) for a given shape.
pub(super) fn pack(region: &Region, distance: f64, limit: usize) -> Vec<DVec2> {
    let distance = distance * (1.0 + HAIR);
    let step = distance / ROWS;
    let (mut packed, mut spans) = (Vec::new(), Vec::new());
    // Those that may still be in the way, from the left.
    let mut near: Vec<DVec2> = Vec::new();
    let mut y = region.top();
    while y > -region.top() {
        spans.clear();
        region.spans(y, &mut spans);
        near.retain(|place| place.y - y < distance);
        for &(start, end) in &spans {
            let mut at = DVec2::new(start, y);
            while at.x <= end {
                let free = past(&near, at, distance);
                if free > at.x {
                    at.x = free;
                    continue;
                }
                if packed.len() == limit {
                    return packed;
                }
                packed.push(at);
                near.insert(near.partition_point(|place| place.x <= at.x), at);
                at.x += distance;
            }
        }
        // Where nothing is inside, rows that are fine for crowded places would only take time.
        y -= if spans.is_empty() { step.max(region.pixel() / 4.0) } else { step };
    }
    packed
}

/// How far right of `at` one must go to be clear of all that are in its way; `at.x` when nobody is.
fn past(near: &[DVec2], at: DVec2, distance: f64) -> f64 {
    let first = near.partition_point(|place| place.x <= at.x - distance);
    let around = near[first..].iter().take_while(|place| place.x < at.x + distance);
    around.fold(at.x, |free, place| {
        let (across, down) = (place.x - at.x, place.y - at.y);
        let reach = (distance * distance - down * down).max(0.0).sqrt();
        if across.abs() < reach { free.max(place.x + reach) } else { free }
    })
}
