//! Places in shapes as the page calls them: a package of its own, which only those fetch who make a shape.
//!
//! Every function decodes, calls and encodes. A refusal is thrown as the JSON text `{code, what, where}`, with `tooCrowded: {count,
//! largest}` where so many agents do not fit; anything else that is thrown is a trap, and the instance is dead.

use eigenform::error::Error;
use eigenform::shape::{Picture, Reading, Region, Request, Room, SlotJob, Step, Style};
use serde_json::json;
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

/// At most one shape and places under way in it.
#[wasm_bindgen]
#[derive(Default)]
pub struct Shapes {
    region: Option<Region>,
    job: Option<SlotJob>,
    slots: Vec<f64>,
}

#[wasm_bindgen]
impl Shapes {
    /// Nothing yet. Keeps the message of a panic for the page.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        std::panic::set_hook(Box::new(|panic| wasm_bindgen::throw_str(&panic.to_string())));
        Self::default()
    }

    /// The shape in a picture, as large as fits: `width` pixels a row, red, green, blue and opacity of each; `room` in meters.
    pub fn read(&mut self, width: usize, rgba: &[u8], threshold: f64, is_inverted: bool, room: &[f64]) -> Result<(), JsValue> {
        let picture = Picture { width, height: rgba.len() / (4 * width.max(1)), rgba };
        let room = Room { width: room[0], depth: room[1] };
        self.region = Some(Region::from_picture(picture, Reading { threshold, is_inverted }, room).map_err(|error| refusal(&error))?);
        Ok(())
    }

    /// Begins places in the shape read last.
    ///
    /// # Panics
    /// When none was read: a bug of the page.
    pub fn begin(&mut self, count: usize, least_distance: f64, is_outline: bool, seed: u32) -> Result<(), JsValue> {
        let style = if is_outline { Style::Outline } else { Style::Filled };
        let region = self.region.take().expect("a shape is read before places in it are sought");
        self.job = Some(SlotJob::new(region, Request { count, least_distance, style, seed }).map_err(|error| refusal(&error))?);
        Ok(())
    }

    /// Works on them for a while; answers how far it is, 1 when they are done and can be read.
    ///
    /// # Panics
    /// When none were begun: a bug of the page.
    pub fn step(&mut self) -> Result<f64, JsValue> {
        let job = self.job.as_mut().expect("places are begun before they are worked on");
        match job.step().map_err(|error| refusal(&error))? {
            Step::Progress(progress) => Ok(progress.min(0.999)),
            Step::Done(slots) => {
                self.slots = slots.positions().iter().flat_map(|place| [place.x, place.y]).collect();
                self.job = None;
                Ok(1.0)
            }
        }
    }

    /// The places just done, once: x, y each.
    pub fn slots(&mut self) -> Vec<f64> {
        std::mem::take(&mut self.slots)
    }
}

fn refusal(error: &Error) -> JsValue {
    let mut refusal = json!({ "code": error.code(), "what": error.to_string(), "where": error.place() });
    if let Error::TooCrowded { count, largest, .. } = error {
        refusal["tooCrowded"] = json!({ "count": count, "largest": largest });
    }
    JsValue::from_str(&refusal.to_string())
}
