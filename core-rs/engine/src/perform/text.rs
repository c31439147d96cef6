//! The motion as text, for other tools.

use std::fmt::Write;

use glam::DVec2;

use super::show::Performance;
use crate::formation::Places;
use crate::text;

impl Performance {
    /// Motion CSV: `frame,time,agent,x,y,z`, a row a frame and agent; seconds, meters; z is 0 on the plane.
    /// Agents by name, or by number where names are missing or not distinct.
    pub fn to_csv(&self) -> String {
        let ids: Vec<String> = self.scene().agent_ids().iter().map(|id| quoted(id)).collect();
        let mut text = String::from("frame,time,agent,x,y,z\n");
        self.for_each_frame(|frame, time, places| {
            for (id, p) in ids.iter().zip(places.iter()) {
                writeln!(text, "{frame},{time},{id},{},{},{}", p.x, p.y, p.z).expect("a string takes any text");
            }
        });
        text
    }

    /// Motion JSON: `{"times": […], "positions": [[[x, y], …], …]}`, one entry a frame; seconds, meters. Places in a scene with
    /// heights have three numbers.
    pub fn to_json(&self) -> String {
        let mut times = Vec::new();
        let mut positions = Vec::new();
        self.for_each_frame(|_, time, at| {
            times.push(time);
            positions.push(json_points(at));
        });
        json(&times, &positions)
    }

    /// The same JSON at chosen instants (scene seconds), in full precision from the methods themselves.
    pub fn to_json_at(&self, times: &[f64]) -> String {
        let positions: Vec<String> = times.iter().map(|time| json_points(self.formation_at(*time).places())).collect();
        json(times, &positions)
    }
}

fn json(times: &[f64], positions: &[String]) -> String {
    let times = text::json(times);
    format!("{{\"times\":{times},\"positions\":[{}]}}", positions.join(","))
}

fn json_points(at: Places<'_>) -> String {
    match at.heights() {
        None => text::json(&at.plan().iter().map(DVec2::to_array).collect::<Vec<_>>()),
        Some(_) => text::json(&at.iter().map(|place| place.to_array()).collect::<Vec<_>>()),
    }
}

/// A CSV field: quoted where it must be.
fn quoted(field: &str) -> String {
    if field.contains([',', '"', '\n', '\r']) { format!("\"{}\"", field.replace('"', "\"\"")) } else { field.to_owned() }
}
