//! Obstacles: few enough, where coordinates are, and with one inside.

use super::{at_most, length, within};
use crate::error::{Counted, Error};
use crate::formation::Formation;
use crate::obstacle::{ObstacleShape, crossing, signed_area};
use crate::scene::place::Place;
use crate::scene::{Obstacle, limits};
use glam::DVec2;

pub(super) fn check(obstacles: &[Obstacle]) -> Result<(), Error> {
    let place = Place::Top.field("obstacles");
    at_most(obstacles.len(), limits::OBSTACLES, Counted::Obstacles, place)?;
    obstacles.iter().enumerate().try_for_each(|(index, obstacle)| check_obstacle(obstacle, &place.item(index)))
}

fn check_obstacle(obstacle: &Obstacle, place: &Place) -> Result<(), Error> {
    length(&obstacle.name, limits::NAME_CHARACTERS, place.field("name"))?;
    match &obstacle.shape {
        ObstacleShape::Circle { center, radius } => {
            coordinates(*center, &place.field("center"))?;
            within(*radius, &limits::OBSTACLE_RADIUS, place.field("radius"))
        }
        ObstacleShape::Polygon { points } => polygon(points, &place.field("points")),
    }
}

fn polygon(points: &[DVec2], place: &Place) -> Result<(), Error> {
    at_most(points.len(), *limits::CORNERS.end(), Counted::Corners, place)?;
    points.iter().enumerate().try_for_each(|(index, point)| coordinates(*point, &place.item(index)))?;
    let extent = Formation::new(points.to_vec()).extent();
    // Fewer corners than a polygon has enclose nothing either.
    let has_area = signed_area(points).abs() > limits::LEAST_AREA * extent * extent;
    if !has_area {
        return Err(Error::NoArea { place: place.to_string() });
    }
    match crossing(points) {
        Some((first, second)) => Err(Error::SelfCrossing { first, second, place: place.to_string() }),
        None => Ok(()),
    }
}

fn coordinates(point: DVec2, place: &Place) -> Result<(), Error> {
    within(point.x, &limits::COORDINATE, place)?;
    within(point.y, &limits::COORDINATE, place)
}
