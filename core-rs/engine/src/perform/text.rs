//! The motion as text, for other tools.

use std::fmt::Write;

use super::show::Performance;
use crate::formation::Places;
use crate::text;

impl Performance {
    /// Motion CSV: `frame,time,agent,x,y,z`, a row a frame and agent; seconds, meters; z is 0 on the plane.
    /// Agents by name, or by number where names are missing or not distinct; who is not there has no row.
    pub fn to_csv(&self) -> String {
        let ids: Vec<String> = self.scene().agent_ids().iter().map(|id| quoted(id)).collect();
        let mut text = String::from("frame,time,agent,x,y,z\n");
        self.for_each_frame(|frame, time, places| {
            let absent = self.absent_at(time);
            let there = (0..).zip(ids.iter().zip(places.iter())).filter(|(agent, _)| absent.binary_search(agent).is_err());
            for (_, (id, p)) in there {
                writeln!(text, "{frame},{time},{id},{},{},{}", p.x, p.y, p.z).expect("a string takes any text");
            }
        });
        text
    }

    /// Motion JSON: `{"times": […], "positions": [[[x, y], …], …]}`, one entry a frame; seconds, meters. Places in a scene with
    /// heights have three numbers; who is not there has null.
    pub fn to_json(&self) -> String {
        let mut times = Vec::new();
        let mut positions = Vec::new();
        self.for_each_frame(|_, time, at| {
            times.push(time);
            positions.push(json_points(at, &self.absent_at(time)));
        });
        json(&times, &positions)
    }

    /// The same JSON at chosen instants (scene seconds), in full precision from the methods themselves.
    pub fn to_json_at(&self, times: &[f64]) -> String {
        let positions: Vec<String> =
            times.iter().map(|time| json_points(self.formation_at(*time).places(), &self.absent_at(*time))).collect();
        json(times, &positions)
    }
}

fn json(times: &[f64], positions: &[String]) -> String {
    let times = text::json(times);
    format!("{{\"times\":{times},\"positions\":[{}]}}", positions.join(","))
}

fn json_points(at: Places<'_>, absent: &[u32]) -> String {
    let there = |agent: u32| absent.binary_search(&agent).is_err();
    match at.heights() {
        None => text::json(&(0..).zip(at.plan()).map(|(agent, place)| there(agent).then(|| place.to_array())).collect::<Vec<_>>()),
        Some(_) => text::json(&(0..).zip(at.iter()).map(|(agent, place)| there(agent).then(|| place.to_array())).collect::<Vec<_>>()),
    }
}

/// A CSV field: quoted where it must be.
fn quoted(field: &str) -> String {
    if field.contains([',', '"', '\n', '\r']) { format!("\"{}\"", field.replace('"', "\"\"")) } else { field.to_owned() }
}
