//! Motion CSV: one row a frame and agent, `frame,time,agent,x,y,z`, as this program writes it.

use glam::DVec2;

use super::Recording;
use super::samples::{Sample, Samples};
use crate::error::{Error, RecordingError, TableError};
use crate::order;
use crate::scene::csv::columns::{Row, Shape};
use crate::scene::csv::rows::for_each_row;
use crate::scene::limits;
use crate::scene::validate::within;

const SHAPE: Shape = Shape {
    columns: &["frame", "time", "agent", "x", "y", "z"],
    required: &["frame", "time", "agent", "x", "y"],
    example: "frame,time,agent,x,y,z",
};

/// A frame may be this far from where the frame rate puts it, in frames: beyond, it is nearer to another.
const UNEVEN: f64 = 0.5;

/// A frame rate this near to a whole number, relative to it, is that number: times have few digits.
const NEARLY_WHOLE: f64 = 1e-6;

/// Whether the first line names the columns of a motion.
pub(super) fn has_header(text: &str) -> bool {
    let first = text.trim_start().lines().next().unwrap_or("");
    let names = |name: &str| first.split(',').any(|field| field.trim().trim_matches('"').eq_ignore_ascii_case(name));
    names("frame") && names("agent")
}

pub(super) fn read(text: &str) -> Result<Recording, Error> {
    let mut samples = Samples::default();
    let mut times = Vec::new();
    for_each_row(text, &SHAPE, &mut |row| {
        let sample = sample(row)?;
        // A row a frame is enough; which rows, does not matter.
        if times.last().is_none_or(|last: &Instant| last.frame != sample.frame) {
            times.push(Instant { frame: sample.frame, time: row.number("time")?, row: row.number });
        }
        samples.add(row.text("agent"), sample)
    })?;
    let frame_rate = frame_rate(times)?;
    samples.finish(frame_rate, Vec::new())
}

/// When a frame is.
#[derive(Clone, Copy)]
struct Instant {
    frame: i64,
    time: f64,
    row: u64,
}

fn sample(row: &Row) -> Result<Sample, Error> {
    let position = DVec2::new(row.number("x")?, row.number("y")?);
    within(position.x, &limits::COORDINATE, row.place("x"))?;
    within(position.y, &limits::COORDINATE, row.place("y"))?;
    let height = if row.text("z").is_empty() { 0.0 } else { row.number("z")? };
    within(height, &limits::COORDINATE, row.place("z"))?;
    let frame = row.number("frame")?;
    within(frame, &limits::FRAME_NUMBER, row.place("frame"))?;
    if frame.fract() != 0.0 {
        return Err(TableError::NotANumber { value: row.text("frame").to_owned(), column: "frame", row: row.number }.into());
    }
    Ok(Sample { frame: frame as i64, agent: 0, row: row.number, position, height })
}

/// From the first frame to the last; the frames between must agree with it.
fn frame_rate(mut times: Vec<Instant>) -> Result<f64, Error> {
    order::sort_by_key(&mut times, |instant| u128::from(order::of_integer(instant.frame)));
    let (Some(first), Some(last)) = (times.first(), times.last()) else { return Err(RecordingError::OneFrame.into()) };
    let (frames, seconds) = ((last.frame - first.frame) as f64, last.time - first.time);
    if frames == 0.0 {
        return Err(RecordingError::OneFrame.into());
    }
    let rate = frames / seconds;
    within(rate, &limits::RECORDING_RATE, format_args!("column time, from row {} to row {}", first.row, last.row))?;
    let rate = if (rate - rate.round()).abs() <= NEARLY_WHOLE * rate { rate.round() } else { rate };
    for instant in &times {
        let expected = first.time + (instant.frame - first.frame) as f64 / rate;
        if (instant.time - expected).abs() > UNEVEN / rate {
            return Err(RecordingError::UnevenFrames { frame: instant.frame, time: instant.time, expected, row: instant.row }.into());
        }
    }
    Ok(rate)
}
