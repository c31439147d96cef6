//! Which of eight classes a speed is in.

/// V: classes of equal width from rest to the top speed of the moment.
pub const SPEED_CLASSES: u32 = 8;

/// The class of each speed, of [`SPEED_CLASSES`].
pub fn speeds_into(vx: &[f64], vy: &[f64], classes: &mut [u32]) {
    let squares = || vx.iter().zip(vy).map(|(x, y)| x * x + y * y);
    let top = squares().fold(0.0, |top, square| if square > top { square } else { top }).sqrt();
    let per_class = if top > 0.0 { f64::from(SPEED_CLASSES) / top } else { 0.0 };
    for (class, square) in classes.iter_mut().zip(squares()) {
        *class = ((square.sqrt() * per_class) as u32).min(SPEED_CLASSES - 1);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn classes_are_eighths_of_the_top_speed() {
        let mut classes = [9; 3];
        speeds_into(&[4.0, 0.0, 1.9], &[0.0, 2.0, 0.0], &mut classes);
        assert_eq!(classes, [7, 4, 3]);
        speeds_into(&[0.0; 3], &[0.0; 3], &mut classes);
        assert_eq!(classes, [0; 3]);
    }
}
