//! Paths: few enough points, where coordinates are, heights only where positions have them, and a length.

use super::{at_most, within};
use crate::error::{Counted, Error};
use crate::scene::place::Place;
use crate::scene::{PathSpec, Track, limits};

pub(super) fn check(path: Option<&PathSpec>, track: &Track, place: &Place) -> Result<(), Error> {
    let Some(path) = path else { return Ok(()) };
    at_most(path.points.len(), limits::PATH_POINTS, Counted::PathPoints, place)?;
    for (index, point) in path.points.iter().enumerate() {
        let place = place.item(index);
        point.to_array().iter().try_for_each(|coordinate| within(*coordinate, &limits::COORDINATE, place))?;
    }
    // Nobody's positions say nothing of heights.
    let is_plane = track.keyframes[0].positions.heights().is_none() && !track.agents.is_empty();
    if path.is_spatial && is_plane {
        return Err(Error::MixedDimensions { found: 3, expected: 2, place: place.item(0).to_string() });
    }
    let length: f64 = path.points.windows(2).map(|pair| pair[0].distance(pair[1])).sum();
    if length >= limits::PATH_LENGTH { Ok(()) } else { Err(Error::NoLength { place: place.to_string() }) }
}
