//! In which order the agents of a formation are told, so that each stands near the one before.

use crate::order;

/// A place on the link's grid.
pub type Cell = [i64; 2];

/// Agents along a Hilbert curve through the box of their cells; equal cells by agent index.
pub fn along_curve(cells: &[Cell]) -> Vec<u32> {
    const ORDER: u32 = 16;
    let low = [0, 1].map(|axis| cells.iter().map(|cell| cell[axis]).min().unwrap_or(0));
    let side = [0, 1].map(|axis| cells.iter().map(|cell| cell[axis] - low[axis]).max().unwrap_or(0));
    let bits = i64::BITS - side[0].max(side[1]).leading_zeros();
    let coarse = bits.saturating_sub(ORDER);
    let along = |cell: &Cell| curve_index([0, 1].map(|axis| ((cell[axis] - low[axis]) >> coarse) as u64), ORDER);
    order::by_key(cells.iter().map(|cell| u128::from(along(cell))))
}

/// Agents row by row; `axis` 0: columns, 1: rows.
pub fn by_rows(cells: &[Cell], axis: usize) -> Vec<u32> {
    order::by_key(cells.iter().map(|cell| order::key_of_two(order::of_integer(cell[axis]), order::of_integer(cell[1 - axis]))))
}

/// How far along the Hilbert curve over 2^`order` × 2^`order` cells this one lies.
fn curve_index([mut x, mut y]: [u64; 2], order: u32) -> u64 {
    let mut index = 0;
    for level in (0..order).rev() {
        let (right, up) = (x >> level & 1, y >> level & 1);
        index = index << 2 | ((3 * right) ^ up);
        if up == 0 {
            if right == 1 {
                let mask = (1 << level) - 1;
                (x, y) = (!x & mask, !y & mask);
            }
            (x, y) = (y, x);
        }
    }
    index
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_curve_visits_every_cell_of_a_square_and_steps_to_a_neighbor() {
        let cells: Vec<Cell> = (0..256).map(|i| [i % 16, i / 16]).collect();
        // The curve of order 16 over the corner of 16 × 16 cells is the curve of order 4.
        let route = along_curve(&cells);
        for pair in route.windows(2) {
            let [from, to] = [0, 1].map(|end| cells[pair[end] as usize]);
            assert_eq!((from[0] - to[0]).abs() + (from[1] - to[1]).abs(), 1);
        }
    }
}
