//! SVG drawings and path data. What runs, links or needs a font is refused before anything is drawn.

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::roxmltree::{Document, Node, ParsingOptions};
use resvg::usvg::{self, Options, Tree};

use super::{Pixels, SIDE, SVG_BYTES, refused};
use crate::failure::Failure;

/// Elements of a drawing: a map of a city has fewer.
const ELEMENTS: u32 = 200_000;

/// Elements that a drawing is refused for, and why.
const UNWELCOME: [(&str, &str); 7] = [
    ("script", "has a script in it; only shapes are drawn"),
    ("foreignObject", "has a page in it; only shapes are drawn"),
    ("iframe", "has a page in it; only shapes are drawn"),
    ("image", "has a picture in it; give that picture itself"),
    ("a", "has a link in it; only shapes are drawn"),
    ("text", "has text in it; turn the text into paths first"),
    ("animate", "moves; only what stands still is drawn"),
];

/// Pixels of an SVG.
pub fn draw(bytes: &[u8], name: &str) -> Result<Pixels, Failure> {
    let broken = |what: String| refused("broken-picture", what, name);
    if bytes.len() > SVG_BYTES {
        return Err(broken(format!("{} bytes; an SVG has at most {SVG_BYTES}", bytes.len())));
    }
    let kinds = "this is no PNG, JPEG, WebP or SVG";
    let text = std::str::from_utf8(bytes).map_err(|_| broken(kinds.to_owned()))?;
    let options = ParsingOptions { allow_dtd: true, nodes_limit: ELEMENTS, ..ParsingOptions::default() };
    let is_drawing = text.trim_start_matches('\u{feff}').trim_start().starts_with('<');
    let unread = |error| if is_drawing { format!("the SVG cannot be read; it may be cut short: {error}") } else { kinds.to_owned() };
    let document = Document::parse_with_options(text, options).map_err(|error| broken(unread(error)))?;
    if let Some(what) = document.descendants().find_map(unwelcome) {
        return Err(refused("active-svg", format!("this SVG {what}"), name));
    }
    let tree = Tree::from_xmltree(&document, &Options::default()).map_err(|error| broken(format!("the SVG cannot be drawn: {error}")))?;
    render(&tree).ok_or_else(|| broken("the SVG has no size".to_owned()))
}

/// Whether somebody gave the `d` of a path and not text: it moves somewhere and then draws, or is cut short after two numbers.
pub fn is_path_data(text: &str) -> bool {
    let drawn = text.trim().strip_prefix(['M', 'm']);
    let has_two_numbers = |rest: &str| rest.split([' ', ',']).filter(|word| word.parse::<f64>().is_ok()).count() > 1;
    let is_drawn = |rest: &str| {
        rest.contains(|c: char| "LlHhVvCcSsQqTtAaZz".contains(c)) && rest.contains(|c: char| c.is_ascii_digit()) || has_two_numbers(rest)
    };
    drawn.is_some_and(|rest| is_drawn(rest) && rest.chars().all(|c| "LlHhVvCcSsQqTtAaZzMmEe+-., \n\t\r".contains(c) || c.is_ascii_digit()))
}

/// Pixels of the inside of a path, however large its numbers are.
pub fn path(data: &str) -> Result<Pixels, Failure> {
    let svg = |view_box: String| format!("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{view_box}\"><path d=\"{data}\"/></svg>");
    let parse = |text: String| Tree::from_str(&text, &Options::default()).ok();
    let drawn = parse(svg("0 0 1 1".to_owned())).and_then(|tree| {
        let bounds = path_bounds(&tree).filter(|bounds| bounds.width() > 0.0 && bounds.height() > 0.0)?;
        let margin = 0.01 * bounds.width().max(bounds.height());
        let (x, y) = (bounds.x() - margin, bounds.y() - margin);
        render(&parse(svg(format!("{x} {y} {} {}", bounds.width() + 2.0 * margin, bounds.height() + 2.0 * margin)))?)
    });
    let has_inside = |pixels: &Pixels| pixels.rgba.chunks_exact(4).any(|pixel| pixel[3] > 0);
    drawn
        .filter(has_inside)
        .ok_or_else(|| refused("broken-picture", "this path has no inside; a path has corners such as M 0 0 L 4 0 L 2 3 Z", data))
}

/// In the path's own numbers.
fn path_bounds(tree: &Tree) -> Option<usvg::Rect> {
    fn first(group: &usvg::Group) -> Option<usvg::Rect> {
        group.children().iter().find_map(|node| match node {
            usvg::Node::Path(path) => Some(path.bounding_box()),
            usvg::Node::Group(group) => first(group),
            _ => None,
        })
    }
    first(tree.root())
}

fn render(tree: &Tree) -> Option<Pixels> {
    let scale = SIDE / tree.size().width().max(tree.size().height());
    let size = tree.size().to_int_size().scale_by(scale)?;
    let mut pixmap = Pixmap::new(size.width(), size.height())?;
    resvg::render(tree, Transform::from_scale(scale, scale), &mut pixmap.as_mut());
    let rgba = pixmap.pixels().iter().flat_map(|pixel| {
        let color = pixel.demultiply();
        [color.red(), color.green(), color.blue(), color.alpha()]
    });
    Some(Pixels { width: size.width() as usize, height: size.height() as usize, rgba: rgba.collect() })
}

/// What a drawing is refused for at this node.
fn unwelcome(node: Node<'_, '_>) -> Option<&'static str> {
    let name = node.tag_name().name();
    let by_name = UNWELCOME.iter().find(|(unwelcome, _)| name.eq_ignore_ascii_case(unwelcome)).map(|(_, why)| *why);
    let by_attribute = node.attributes().find_map(|attribute| {
        let (name, value) = (attribute.name().to_lowercase(), attribute.value().trim());
        if name.starts_with("on") {
            Some("has a script in it; only shapes are drawn")
        } else if name == "href" && !value.starts_with('#') || fetches(value) {
            Some("links to something outside; only shapes are drawn")
        } else {
            None
        }
    });
    let by_style =
        || (name == "style" && fetches(node.text().unwrap_or_default())).then_some("links to something outside; only shapes are drawn");
    by_name.or(by_attribute).or_else(by_style)
}

/// Whether a style asks for anything but a part of the drawing.
fn fetches(style: &str) -> bool {
    style.contains("@import") || style.split("url(").skip(1).any(|rest| !rest.trim_start_matches([' ', '"', '\'']).starts_with('#'))
}
