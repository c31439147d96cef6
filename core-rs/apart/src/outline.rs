//! Something that stands still and that paths keep away from.

/// A rounded polygon on the plane: everything within `radius` of the polygon of `points`. One point: a circle.
#[derive(Clone, Debug, PartialEq)]
pub struct Outline {
    /// Corners in either direction, meters.
    pub points: Vec<[f64; 2]>,
    /// Meters.
    pub radius: f64,
}

impl Outline {
    /// How far a place is outside the outline (negative: inside), and the direction that leads out fastest.
    pub fn clearance(&self, at: [f64; 2]) -> (f64, [f64; 2]) {
        let count = self.points.len();
        let mut nearest = (f64::INFINITY, [0.0; 2], [0.0; 2]);
        let mut is_inside = false;
        for k in 0..count {
            let (from, to) = (self.points[k], self.points[(k + 1) % count]);
            let edge = [to[0] - from[0], to[1] - from[1]];
            let way = [at[0] - from[0], at[1] - from[1]];
            let length_squared = edge[0] * edge[0] + edge[1] * edge[1];
            let t = if length_squared > 0.0 { ((way[0] * edge[0] + way[1] * edge[1]) / length_squared).clamp(0.0, 1.0) } else { 0.0 };
            let out = [way[0] - t * edge[0], way[1] - t * edge[1]];
            let distance_squared = out[0] * out[0] + out[1] * out[1];
            if distance_squared < nearest.0 {
                nearest = (distance_squared, out, edge);
            }
            if (from[1] > at[1]) != (to[1] > at[1]) && at[0] < from[0] + edge[0] * (at[1] - from[1]) / edge[1] {
                is_inside = !is_inside;
            }
        }
        let (distance_squared, out, edge) = nearest;
        let distance = distance_squared.sqrt();
        let sign = if is_inside { -1.0 } else { 1.0 };
        let normal = if distance > 1e-12 {
            [sign * out[0] / distance, sign * out[1] / distance]
        } else {
            // On the line itself: across the edge, away from the middle of the points.
            self.across(edge, at)
        };
        (sign * distance - self.radius, normal)
    }

    /// The least clearance on the straight way between two places, and where, 0–1.
    ///
    /// Exact outside: the nearest place of a straight way is one of its ends or straight beside a corner. A way that crosses the
    /// outline is found at the crossing.
    pub fn least_clearance(&self, from: [f64; 2], to: [f64; 2]) -> (f64, f64) {
        let way = [to[0] - from[0], to[1] - from[1]];
        let length_squared = way[0] * way[0] + way[1] * way[1];
        let mut least = (f64::INFINITY, 0.0);
        let mut offer = |t: f64| {
            let (distance, _) = self.clearance([from[0] + t * way[0], from[1] + t * way[1]]);
            if distance < least.0 {
                least = (distance, t);
            }
        };
        offer(0.0);
        offer(1.0);
        let count = self.points.len();
        for (k, corner) in self.points.iter().enumerate() {
            let apart = [corner[0] - from[0], corner[1] - from[1]];
            if length_squared > 0.0 {
                offer(((apart[0] * way[0] + apart[1] * way[1]) / length_squared).clamp(0.0, 1.0));
            }
            let next = self.points[(k + 1) % count];
            let edge = [next[0] - corner[0], next[1] - corner[1]];
            let turn = way[0] * edge[1] - way[1] * edge[0];
            if turn != 0.0 {
                let t = (apart[0] * edge[1] - apart[1] * edge[0]) / turn;
                let on_edge = (apart[0] * way[1] - apart[1] * way[0]) / turn;
                if (0.0..=1.0).contains(&t) && (0.0..=1.0).contains(&on_edge) {
                    offer(t);
                }
            }
        }
        least
    }

    fn across(&self, edge: [f64; 2], at: [f64; 2]) -> [f64; 2] {
        let length = (edge[0] * edge[0] + edge[1] * edge[1]).sqrt();
        if length == 0.0 {
            return [1.0, 0.0];
        }
        let count = self.points.len() as f64;
        let middle = self.points.iter().fold([0.0; 2], |sum, p| [sum[0] + p[0] / count, sum[1] + p[1] / count]);
        let across = [edge[1] / length, -edge[0] / length];
        let side = across[0] * (at[0] - middle[0]) + across[1] * (at[1] - middle[1]);
        if side < 0.0 { [-across[0], -across[1]] } else { across }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn clearance_is_the_way_to_the_outline_and_leads_out() {
        let square = Outline { points: vec![[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]], radius: 0.0 };
        let circle = Outline { points: vec![[1.0, 1.0]], radius: 0.5 };
        let check = |outline: &Outline, at, distance, normal| assert_eq!(outline.clearance(at), (distance, normal), "{at:?}");
        check(&square, [3.0, 1.0], 1.0, [1.0, 0.0]);
        check(&square, [1.0, 0.5], -0.5, [0.0, -1.0]);
        check(&square, [5.0, 6.0], 5.0, [0.6, 0.8]);
        check(&square, [2.0, 1.0], 0.0, [1.0, 0.0]);
        check(&circle, [1.0, 3.0], 1.5, [0.0, 1.0]);
        check(&circle, [1.0, 1.25], -0.25, [0.0, 1.0]);
        check(&circle, [1.0, 1.0], -0.5, [1.0, 0.0]);
    }

    #[test]
    fn the_least_clearance_of_a_way_is_at_an_end_beside_a_corner_or_where_it_crosses() {
        let square = Outline { points: vec![[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]], radius: 0.0 };
        let circle = Outline { points: vec![[1.0, 1.0]], radius: 0.5 };
        let check = |outline: &Outline, from, to, expected| assert_eq!(outline.least_clearance(from, to), expected, "{from:?} to {to:?}");
        check(&square, [3.0, 1.0], [5.0, 1.0], (1.0, 0.0));
        check(&square, [5.0, 1.0], [3.0, 1.0], (1.0, 1.0));
        check(&square, [-2.0, 3.0], [2.0, 3.0], (1.0, 1.0));
        check(&circle, [0.0, 3.0], [2.0, 3.0], (1.5, 0.5));
        // Through it, though both ends are far outside.
        assert!(square.least_clearance([-4.0, 1.0], [6.0, 1.5]).0 <= 1e-12);
        assert!(circle.least_clearance([0.0, 1.0], [2.0, 1.0]).0 == -0.5);
    }
}
