//! Places in a scene file: where agents stand and what they go around.

use glam::DVec2;
use serde::Deserialize;

use super::fields::Fields;
use super::value::Value;
use crate::error::{Counted, Error};
use crate::formation::Formation;
use crate::obstacle::ObstacleShape;
use crate::scene::{Obstacle, PathSpec, limits};

const OBSTACLE: &[&str] = &["name", "kind", "center", "radius", "points"];
const CIRCLE: &[&str] = &["name", "kind", "center", "radius"];
const POLYGON: &[&str] = &["name", "kind", "points"];

#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
enum Kind {
    Circle,
    Polygon,
}

/// A position: two numbers, and in space a third.
struct Spot {
    position: DVec2,
    height: Option<f64>,
}

/// The positions of a keyframe. All positions of a scene have as many numbers as the first, which sets `dimensions`.
pub(super) fn formation(keyframe: &Fields, dimensions: &mut Option<usize>) -> Result<Formation, Error> {
    let mut heights = Vec::new();
    let positions = keyframe.list("positions", limits::AGENTS, Counted::Agents, |value| {
        let Spot { position, height } = alike(value, dimensions)?;
        heights.extend(height);
        Ok(position)
    })?;
    Ok(if heights.is_empty() { Formation::new(positions) } else { Formation::spatial(positions, heights) })
}

/// The points of a path, all of as many numbers as the first.
pub(super) fn path(value: Value) -> Result<PathSpec, Error> {
    let mut dimensions = None;
    let items = value.items(limits::PATH_POINTS, Counted::PathPoints)?;
    let points = items.into_iter().enumerate().map(|(index, text)| {
        let value = Value { text, place: value.place.item(index) };
        let spot = alike(value, &mut dimensions)?;
        Ok(spot.position.extend(spot.height.unwrap_or(0.0)))
    });
    Ok(PathSpec { points: points.collect::<Result<_, Error>>()?, is_spatial: dimensions == Some(3) })
}

/// One obstacle; which fields it has depends on its kind.
pub(super) fn obstacle(value: Value) -> Result<Obstacle, Error> {
    let kind: Kind = value.fields(OBSTACLE)?.required("kind")?.word(&[])?;
    let fields = value.object(match kind {
        Kind::Circle => CIRCLE,
        Kind::Polygon => POLYGON,
    })?;
    let shape = match kind {
        Kind::Circle => ObstacleShape::Circle { center: point(fields.required("center")?)?, radius: fields.required("radius")?.number()? },
        Kind::Polygon => {
            fields.required("points")?;
            ObstacleShape::Polygon { points: fields.list("points", *limits::CORNERS.end(), Counted::Corners, point)? }
        }
    };
    Ok(Obstacle { name: fields.string("name")?, shape })
}

/// An entry of a short list that is named as a whole.
pub(super) fn entry<'a, 'p>(list: &Value<'_, 'p>, text: &'a str) -> Value<'a, 'p> {
    Value { text, place: list.place }
}

/// A position of as many numbers as those before it.
fn alike(value: Value, dimensions: &mut Option<usize>) -> Result<Spot, Error> {
    let spot = spot(value)?;
    let found = if spot.height.is_some() { 3 } else { 2 };
    let expected = *dimensions.get_or_insert(found);
    if found == expected { Ok(spot) } else { Err(Error::MixedDimensions { found, expected, place: value.place.to_string() }) }
}

fn spot(value: Value) -> Result<Spot, Error> {
    const SHAPE: &str = "[x, y] or [x, y, z], numbers in meters";
    let number = |text| entry(&value, text).number();
    if let Some([x, y]) = value.parts() {
        return Ok(Spot { position: DVec2::new(number(x)?, number(y)?), height: None });
    }
    let [x, y, z] = value.exactly(SHAPE)?;
    Ok(Spot { position: DVec2::new(number(x)?, number(y)?), height: Some(number(z)?) })
}

fn point(value: Value) -> Result<DVec2, Error> {
    let [x, y] = value.exactly("[x, y], two numbers in meters")?;
    Ok(DVec2::new(entry(&value, x).number()?, entry(&value, y).number()?))
}
