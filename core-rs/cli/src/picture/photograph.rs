//! PNG, JPEG and WebP, told apart by their first bytes. Sizes are checked before anything is decoded.

use std::io::Cursor;

use eigenform::shape::Picture;
use png::{ColorType, Decoder, Transformations};
use zune_jpeg::JpegDecoder;
use zune_jpeg::zune_core::colorspace::ColorSpace;
use zune_jpeg::zune_core::options::DecoderOptions;

use super::{Pixels, refused};
use crate::failure::Failure;

/// Pixels of a picture; none where the bytes are of another kind.
pub fn decode(bytes: &[u8], name: &str) -> Option<Result<Pixels, Failure>> {
    let decoded = match bytes {
        [0x89, b'P', b'N', b'G', ..] => decode_png(bytes),
        [0xFF, 0xD8, ..] => decode_jpeg(bytes),
        [b'R', b'I', b'F', b'F', _, _, _, _, b'W', b'E', b'B', b'P', ..] => decode_webp(bytes),
        _ => return None,
    };
    Some(decoded.map_err(|trouble| match trouble {
        Trouble::Size(failure) => failure,
        Trouble::Broken => refused("broken-picture", "the picture cannot be decoded; it may be cut short or damaged", name),
        Trouble::Unsupported(why) => refused("broken-picture", format!("the picture cannot be decoded: {why}"), name),
    }))
}

enum Trouble {
    Size(Failure),
    /// The decoders' own words tell nobody more.
    Broken,
    Unsupported(&'static str),
}

fn check_size(width: usize, height: usize) -> Result<(), Trouble> {
    Picture::check_size(width, height).map_err(|error| Trouble::Size(error.into()))
}

fn decode_png(bytes: &[u8]) -> Result<Pixels, Trouble> {
    let mut decoder = Decoder::new(Cursor::new(bytes));
    decoder.set_transformations(Transformations::normalize_to_color8() | Transformations::ALPHA);
    let (width, height) = decoder.read_header_info().map_err(|_| Trouble::Broken)?.size();
    let (width, height) = (width as usize, height as usize);
    check_size(width, height)?;
    let mut reader = decoder.read_info().map_err(|_| Trouble::Broken)?;
    let size = reader.output_buffer_size().ok_or(Trouble::Unsupported("it is too large"))?;
    let mut decoded = vec![0; size];
    let frame = reader.next_frame(&mut decoded).map_err(|_| Trouble::Broken)?;
    let rgba = match frame.color_type {
        ColorType::GrayscaleAlpha => decoded.chunks_exact(2).flat_map(|pixel| [pixel[0], pixel[0], pixel[0], pixel[1]]).collect(),
        _ => decoded,
    };
    whole(Pixels { width, height, rgba })
}

fn decode_jpeg(bytes: &[u8]) -> Result<Pixels, Trouble> {
    let options = DecoderOptions::default().jpeg_set_out_colorspace(ColorSpace::RGBA);
    let mut decoder = JpegDecoder::new_with_options(Cursor::new(bytes), options);
    decoder.decode_headers().map_err(|_| Trouble::Broken)?;
    let (width, height) = decoder.dimensions().ok_or(Trouble::Unsupported("it has no size"))?;
    check_size(width, height)?;
    let rgba = decoder.decode().map_err(|_| Trouble::Broken)?;
    whole(Pixels { width, height, rgba })
}

fn decode_webp(bytes: &[u8]) -> Result<Pixels, Trouble> {
    let mut decoder = image_webp::WebPDecoder::new(Cursor::new(bytes)).map_err(|_| Trouble::Broken)?;
    let (width, height) = decoder.dimensions();
    let (width, height) = (width as usize, height as usize);
    check_size(width, height)?;
    let size = decoder.output_buffer_size().ok_or(Trouble::Unsupported("it is too large"))?;
    let mut decoded = vec![0; size];
    decoder.read_image(&mut decoded).map_err(|_| Trouble::Broken)?;
    let rgba =
        if decoder.has_alpha() { decoded } else { decoded.chunks_exact(3).flat_map(|pixel| [pixel[0], pixel[1], pixel[2], 255]).collect() };
    whole(Pixels { width, height, rgba })
}

/// Every pixel must have come.
fn whole(pixels: Pixels) -> Result<Pixels, Trouble> {
    let is_whole = pixels.rgba.len() == 4 * pixels.width * pixels.height;
    if is_whole { Ok(pixels) } else { Err(Trouble::Unsupported("it is in colors that are not supported")) }
}
