//! How finely an edit looks at a guide.

use glam::DVec3;

/// Guides are rounded to this, meters: machines that differ in a guide's last bits then edit it the same way.
const GRAIN: f64 = 1.0 / (1 << 20) as f64;

pub(super) fn rounded(p: DVec3) -> DVec3 {
    (p / GRAIN).round() * GRAIN
}
