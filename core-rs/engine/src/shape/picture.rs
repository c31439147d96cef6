//! Which part of a picture is its shape.

use std::ops::RangeInclusive;

use crate::error::{Blank, Error};

/// Pixels a side: fewer hold no shape, and more tell no finer where people stand.
const SIDE: RangeInclusive<usize> = 4..=4_096;

/// Brightness below which a pixel belongs to the shape; at either end all or nothing would.
pub const THRESHOLD: RangeInclusive<f64> = 0.01..=0.99;

/// Coverage from which a pixel is inside.
pub(super) const INSIDE: u8 = 128;

/// Pixels row by row from the top: red, green, blue and opacity of each, not premultiplied.
#[derive(Clone, Copy, Debug)]
pub struct Picture<'p> {
    /// Pixels in a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// Four bytes a pixel.
    pub rgba: &'p [u8],
}

impl Picture<'_> {
    /// Refuses a size that no picture has; asked before one is decoded.
    pub fn check_size(width: usize, height: usize) -> Result<(), Error> {
        let (low, high) = SIDE.into_inner();
        let fits = |side: usize| (low..=high).contains(&side);
        if fits(width) && fits(height) { Ok(()) } else { Err(Error::PictureSize { width, height, low, high }) }
    }

    /// How much of each pixel is covered, row by row from the top.
    ///
    /// Refuses pictures that are too small or too large, and those that are all alike to this reading.
    pub(super) fn coverage(self, reading: Reading) -> Result<Vec<u8>, Error> {
        Self::check_size(self.width, self.height)?;
        if !THRESHOLD.contains(&reading.threshold) {
            let (low, high) = THRESHOLD.into_inner();
            return Err(Error::OutOfRange { value: reading.threshold, low, high, place: "threshold".to_owned() });
        }
        let pixels = self.rgba.as_chunks::<4>().0;
        assert_eq!(pixels.len(), self.width * self.height, "a pixel has four bytes");
        let opacities = pixels.iter().map(|pixel| pixel[3]);
        let (faintest, firmest) = opacities.fold((u8::MAX, 0), |(low, high), opacity| (low.min(opacity), high.max(opacity)));
        // A picture that is equally faint everywhere is told by its colors.
        let tells = if faintest < INSIDE && faintest < firmest { transparency } else { brightness };
        let (mut coverage, mut inside) = (Vec::with_capacity(pixels.len()), 0);
        let [mut darkest, mut brightest] = [f64::INFINITY, f64::NEG_INFINITY];
        for pixel in pixels {
            let tone = tells(*pixel);
            (darkest, brightest) = (tone.min(darkest), tone.max(brightest));
            let covered = reading.covered(tone);
            inside += usize::from(covered >= INSIDE);
            coverage.push(covered);
        }
        if 0 < inside && inside < pixels.len() {
            return Ok(coverage);
        }
        let why = match threshold_between(darkest, brightest) {
            _ if firmest == 0 => Blank::Transparent,
            None => Blank::Alike,
            Some(better) => Blank::Undivided { is_everything: inside > 0, threshold: reading.threshold, better },
        };
        Err(Error::BlankPicture { why })
    }
}

/// What of a picture is taken for the shape.
#[derive(Clone, Copy, Debug)]
pub struct Reading {
    /// What is darker than this, 0 black to 1 white; where a picture has transparent parts, what is more opaque than 1 minus it.
    pub threshold: f64,
    /// What is not, instead.
    pub is_inverted: bool,
}

impl Default for Reading {
    fn default() -> Self {
        Self { threshold: 0.5, is_inverted: false }
    }
}

impl Reading {
    /// Half at the threshold: what is drawn without jagged edges keeps them between pixels.
    fn covered(self, brightness: f64) -> u8 {
        // What is exactly as bright as the threshold is not darker.
        let covered = if brightness < self.threshold {
            (255.0 - 127.5 * brightness / self.threshold).max(128.0)
        } else {
            (127.5 * (1.0 - brightness) / (1.0 - self.threshold)).min(127.0)
        };
        if self.is_inverted { 255 - covered as u8 } else { covered as u8 }
    }
}

/// A threshold above one brightness and not above another, as round as there is.
fn threshold_between(low: f64, high: f64) -> Option<f64> {
    let middle = low.max(*THRESHOLD.start()).midpoint(high.min(*THRESHOLD.end()));
    // Brightnesses of two pixels differ by 1 / 255² at least.
    let rounded = (2..=5).map(|digits| 10.0_f64.powi(digits)).map(|unit| (middle * unit).round() / unit);
    rounded.into_iter().find(|threshold| low < *threshold && *threshold <= high && THRESHOLD.contains(threshold))
}

/// Luma on white paper, Rec. 709 in 256ths; 0 to 1.
fn brightness([r, g, b, opacity]: [u8; 4]) -> f64 {
    let luma = (54 * u32::from(r) + 183 * u32::from(g) + 19 * u32::from(b)) / 256;
    1.0 - f64::from(u32::from(opacity) * (255 - luma)) / (255.0 * 255.0)
}

/// As if all that can be seen were black.
fn transparency([.., opacity]: [u8; 4]) -> f64 {
    1.0 - f64::from(opacity) / 255.0
}
