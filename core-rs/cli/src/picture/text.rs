//! Text as a shape, in a font of this machine.

use fontdb::{Database, Family, ID, Query};
use resvg::tiny_skia::{FillRule, Paint, Path, PathBuilder, Pixmap, Transform};
use ttf_parser::{Face, OutlineBuilder};

use super::{Pixels, SIDE, refused};
use crate::failure::Failure;

/// Characters of a formation: more are no shape that anybody reads.
const CHARACTERS: usize = 200;

/// From line to line, in heights of the letters.
const LEADING: f32 = 1.2;

/// Pixels of text; it stands in the font named, or in one that has all its characters.
pub fn write(text: &str, font: Option<&str>) -> Result<Pixels, Failure> {
    let length = text.chars().count();
    if text.trim().is_empty() {
        return Err(refused("no-text", "nothing of this text can be seen; give letters, or the name of a picture", "the text"));
    }
    if length > CHARACTERS {
        return Err(refused("no-text", format!("{length} characters; a text has at most {CHARACTERS}"), "the text"));
    }
    let mut fonts = Database::new();
    fonts.load_system_fonts();
    let face = face_for(&fonts, text, font)?;
    let outline = fonts.with_face_data(face, |data, index| Face::parse(data, index).ok().and_then(|face| outline_of(&face, text)));
    outline
        .flatten()
        .and_then(|outline| fill(&outline))
        .ok_or_else(|| refused("no-glyph", "the font draws nothing for this text; give another with --font", text))
}

fn face_for(fonts: &Database, text: &str, font: Option<&str>) -> Result<ID, Failure> {
    let families = [font.map_or(Family::SansSerif, Family::Name)];
    let asked = fonts.query(&Query { families: &families, ..Query::default() });
    if let (Some(name), None) = (font, asked) {
        let known = fonts.faces().next().map_or_else(String::new, |face| format!("; one is {:?}", face.families[0].0));
        return Err(refused("no-font", format!("there is no font {name:?} on this machine{known}"), "--font"));
    }
    let lacking = |id: ID| fonts.with_face_data(id, |data, index| lacks(data, index, text)).unwrap_or(text.chars().next());
    let missing = match asked.map(|id| (id, lacking(id))) {
        Some((id, None)) => return Ok(id),
        Some((_, Some(missing))) => missing,
        None => text.chars().next().unwrap_or_default(),
    };
    if let Some(name) = font {
        return Err(refused("no-glyph", format!("the font {name:?} has no {missing:?}; give another, or none"), "--font"));
    }
    let other = fonts.faces().map(|face| face.id).find(|&id| lacking(id).is_none());
    other.ok_or_else(|| {
        refused(
            "no-glyph",
            format!("no font of this machine has all of these letters, {missing:?} among them; install one, or give a picture of the text"),
            text,
        )
    })
}

/// The first character that a font does not have.
fn lacks(data: &[u8], index: u32, text: &str) -> Option<char> {
    let face = Face::parse(data, index).ok();
    let has = |c: char| face.as_ref().is_some_and(|face| face.glyph_index(c).is_some());
    text.chars().find(|&c| !c.is_whitespace() && !has(c))
}

/// The letters one after another, lines one below another and in the middle; y down.
fn outline_of(face: &Face<'_>, text: &str) -> Option<Path> {
    let advance = |c: char| face.glyph_index(c).and_then(|glyph| face.glyph_hor_advance(glyph)).map_or(0.0, f32::from);
    let line_height = LEADING * f32::from(face.units_per_em());
    let mut pen = Pen { path: PathBuilder::new(), x: 0.0, y: 0.0 };
    for (number, line) in text.lines().enumerate() {
        pen.x = -0.5 * line.chars().map(advance).sum::<f32>();
        pen.y = number as f32 * line_height;
        for c in line.chars() {
            if let Some(glyph) = face.glyph_index(c) {
                face.outline_glyph(glyph, &mut pen);
            }
            pen.x += advance(c);
        }
    }
    pen.path.finish()
}

fn fill(path: &Path) -> Option<Pixels> {
    let bounds = path.bounds();
    let scale = SIDE / bounds.width().max(bounds.height());
    // A pixel around it, so that something is transparent whatever the letters are.
    let size = |length: f32| (length * scale).ceil() as u32 + 2;
    let mut pixmap = Pixmap::new(size(bounds.width()), size(bounds.height()))?;
    let into_place = Transform::from_translate(-bounds.left(), -bounds.top()).post_scale(scale, scale).post_translate(1.0, 1.0);
    pixmap.fill_path(path, &Paint::default(), FillRule::Winding, into_place, None);
    let (width, height) = (pixmap.width() as usize, pixmap.height() as usize);
    // Black, however transparent, is the same premultiplied.
    Some(Pixels { width, height, rgba: pixmap.take() })
}

/// Draws a glyph where the line has come to; fonts have y up.
struct Pen {
    path: PathBuilder,
    x: f32,
    y: f32,
}

impl OutlineBuilder for Pen {
    fn move_to(&mut self, x: f32, y: f32) {
        self.path.move_to(self.x + x, self.y - y);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.path.line_to(self.x + x, self.y - y);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        self.path.quad_to(self.x + x1, self.y - y1, self.x + x, self.y - y);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        self.path.cubic_to(self.x + x1, self.y - y1, self.x + x2, self.y - y2, self.x + x, self.y - y);
    }

    fn close(&mut self) {
        self.path.close();
    }
}
