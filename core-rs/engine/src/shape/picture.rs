//! Which part of a picture is its shape.

use std::ops::RangeInclusive;

use crate::error::{Blank, Error};

/// Pixels a side: fewer hold no shape, more is no camera's picture.
const SIDE: RangeInclusive<usize> = 4..=8_192;

/// Pixels of the longer side that are looked at: eight for each place of a row where 5,000 agents fill a square, and then some.
const FINEST: usize = 1_024;

/// Brightness below which a pixel belongs to the shape; at either end all or nothing would.
pub const THRESHOLD: RangeInclusive<f64> = 0.01..=0.99;

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

/// How much of each pixel is covered, row by row from the top; from 128 on it is inside.
pub(super) struct Mask {
    pub(super) width: usize,
    pub(super) height: usize,
    pub(super) coverage: Vec<u8>,
}

impl Mask {
    /// Refuses pictures that are too small or too large, and those that are one color to this reading.
    pub(super) fn new(picture: Picture<'_>, reading: Reading) -> Result<Self, Error> {
        let Picture { width, height, rgba } = picture;
        Picture::check_size(width, height)?;
        assert_eq!(rgba.len(), 4 * width * height, "a pixel has four bytes");
        if !THRESHOLD.contains(&reading.threshold) {
            let (low, high) = THRESHOLD.into_inner();
            return Err(Error::OutOfRange { value: reading.threshold, low, high, place: "threshold".to_owned() });
        }
        let mask = Self::reduced(picture, reading);
        let inside = mask.coverage.iter().filter(|&&covered| covered >= 128).count();
        let why = match inside {
            0 if rgba.chunks_exact(4).all(|pixel| pixel[3] == 0) => Blank::Transparent,
            0 => Blank::Nothing,
            all if all == mask.coverage.len() => Blank::Everything,
            _ => return Ok(mask),
        };
        Err(Error::BlankPicture { why })
    }

    /// Squares of pixels become one where the picture is finer than places are told apart.
    fn reduced(Picture { width, height, rgba }: Picture<'_>, reading: Reading) -> Self {
        let factor = width.max(height).div_ceil(FINEST);
        let brightness = if rgba.chunks_exact(4).any(|pixel| pixel[3] < 128) { transparency } else { brightness };
        let (columns, rows) = (width.div_ceil(factor), height.div_ceil(factor));
        let mut coverage = Vec::with_capacity(columns * rows);
        for row in 0..rows {
            let ys = row * factor..((row + 1) * factor).min(height);
            for column in 0..columns {
                let xs = column * factor..((column + 1) * factor).min(width);
                let pixels = (xs.len() * ys.len()) as f64;
                let sum: u32 =
                    ys.clone().flat_map(|y| xs.clone().map(move |x| 4 * (y * width + x))).map(|at| brightness(&rgba[at..at + 4])).sum();
                coverage.push(covered(f64::from(sum) / (FULL * pixels), reading));
            }
        }
        Self { width: columns, height: rows, coverage }
    }
}

/// The brightness of a white pixel.
const FULL: f64 = 255.0 * 255.0;

/// Luma on white paper, Rec. 709 in 256ths, 0 to `FULL`.
fn brightness(pixel: &[u8]) -> u32 {
    let [r, g, b, opacity] = [0, 1, 2, 3].map(|at| u32::from(pixel[at]));
    let luma = (54 * r + 183 * g + 19 * b) / 256;
    255 * 255 - opacity * (255 - luma)
}

/// As if all that can be seen were black.
fn transparency(pixel: &[u8]) -> u32 {
    255 * (255 - u32::from(pixel[3]))
}

/// The threshold is half covered, and what is drawn without jagged edges keeps its edges between pixels.
fn covered(brightness: f64, Reading { threshold, is_inverted }: Reading) -> u8 {
    let share = if brightness < threshold { 1.0 - 0.5 * brightness / threshold } else { 0.5 * (1.0 - brightness) / (1.0 - threshold) };
    // What is exactly as bright as the threshold is not darker.
    let covered = if brightness < threshold { (255.0 * share).max(128.0) } else { (255.0 * share).min(127.0) };
    if is_inverted { 255 - covered as u8 } else { covered as u8 }
}
