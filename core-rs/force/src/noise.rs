//! Seeded fluctuation ξ (paper D, equation 7): a number by seed, step and agent, so that nothing depends on who is asked first.

/// An even number in −1..1 for each axis.
pub fn noise(seed: u32, step: u32, agent: u32) -> [f64; 2] {
    let word = mixed(mixed(u64::from(seed) << 32 | u64::from(step)) ^ u64::from(agent));
    [word >> 32, word & 0xFFFF_FFFF].map(|half| half as f64 * (2.0 / 4_294_967_296.0) - 1.0)
}

/// The finalizer of `SplitMix64`: every bit of the input changes half of the output's.
fn mixed(word: u64) -> u64 {
    let word = word.wrapping_add(0x9E37_79B9_7F4A_7C15);
    let word = (word ^ word >> 30).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    let word = (word ^ word >> 27).wrapping_mul(0x94D0_49BB_1331_11EB);
    word ^ word >> 31
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_even_and_repeats_by_seed() {
        let all: Vec<f64> = (0..1000).flat_map(|step| (0..10).flat_map(move |agent| noise(7, step, agent))).collect();
        let mean = all.iter().sum::<f64>() / all.len() as f64;
        // Five standard deviations of a mean of 20,000 even numbers in −1..1.
        assert!(mean.abs() < 5.0 * (1.0 / 3.0 / all.len() as f64).sqrt(), "{mean}");
        assert!(all.iter().all(|value| (-1.0..1.0).contains(value)));
        assert_ne!(noise(7, 1, 0), noise(8, 1, 0));
        assert_ne!(noise(7, 1, 0), noise(7, 0, 1));
    }
}
