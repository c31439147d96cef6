//! JSON as a person lays it out: what belongs together on a line, the rest indented below.

use crate::scene::number::number_text;
use crate::text::json;

/// JSON text under construction. Entries are separated and indented by the container that is open.
#[derive(Default)]
pub(super) struct Layout {
    text: String,
    depth: usize,
    /// Open containers that stay on one line.
    lines: usize,
    has_entry: bool,
}

impl Layout {
    /// The finished text, with a line end.
    pub(super) fn finish(mut self) -> String {
        self.text.push('\n');
        self.text
    }

    /// An object whose fields stand below one another.
    pub(super) fn object(&mut self, fill: impl FnOnce(&mut Self)) {
        self.container(['{', '}'], fill);
    }

    /// An object on one line.
    pub(super) fn object_line(&mut self, fill: impl FnOnce(&mut Self)) {
        self.lines += 1;
        self.container(['{', '}'], fill);
        self.lines -= 1;
    }

    /// A list whose entries stand below one another.
    pub(super) fn list<T>(&mut self, entries: &[T], mut write: impl FnMut(&mut Self, &T)) {
        self.container(['[', ']'], |list| {
            for entry in entries {
                list.separate();
                write(list, entry);
            }
        });
    }

    /// A list on one line.
    pub(super) fn list_line<T>(&mut self, entries: &[T], write: impl FnMut(&mut Self, &T)) {
        self.lines += 1;
        self.list(entries, write);
        self.lines -= 1;
    }

    /// Starts a field; its value comes next.
    pub(super) fn key(&mut self, name: &str) -> &mut Self {
        self.separate();
        self.string(name);
        self.text.push_str(": ");
        self
    }

    pub(super) fn string(&mut self, text: &str) {
        self.text.push_str(&json(text));
    }

    pub(super) fn number(&mut self, value: f64) {
        self.text.push_str(&number_text(value));
    }

    /// Text that is JSON already.
    pub(super) fn raw(&mut self, json: &str) {
        self.text.push_str(json);
    }

    fn container(&mut self, [open, close]: [char; 2], fill: impl FnOnce(&mut Self)) {
        self.text.push(open);
        self.depth += 1;
        let outer = std::mem::replace(&mut self.has_entry, false);
        fill(self);
        self.depth -= 1;
        if self.has_entry {
            if self.lines == 0 {
                self.new_line();
            } else if open == '{' {
                self.text.push(' ');
            }
        }
        self.has_entry = outer;
        self.text.push(close);
    }

    fn separate(&mut self) {
        let is_first = !std::mem::replace(&mut self.has_entry, true);
        if !is_first {
            self.text.push(',');
        }
        match (self.lines, is_first && self.text.ends_with('[')) {
            (0, _) => self.new_line(),
            (_, true) => {}
            (_, false) => self.text.push(' '),
        }
    }

    fn new_line(&mut self) {
        self.text.push('\n');
        self.text.extend(std::iter::repeat_n("  ", self.depth));
    }
}
