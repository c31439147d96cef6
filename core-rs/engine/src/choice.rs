//! The words for a method and its options, shared by the document and the rooms that give them meaning.

use serde::{Deserialize, Serialize};

/// A method with its options, as `auto` compares and keeps them.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct Choice {
    /// Never `auto`.
    pub method: MethodName,
    /// Used by spectral.
    pub order: Order,
    /// Used by spectral, shared, polar.
    pub alignment: Alignment,
    /// Used by spectral.
    pub sharing: f64,
}

/// How a formation becomes the next.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "lowercase")]
pub enum MethodName {
    /// Try the candidates and keep the best.
    #[default]
    Auto,
    /// Paper A: the eigenbases turn into one another.
    Spectral,
    /// One basis of the mean Laplacian.
    Shared,
    /// Polar coordinates about the barycenter.
    Polar,
    /// Straight lines.
    Linear,
    /// Paper D: social forces along another method's way.
    Crowd,
}

/// A second method that a group moves by, and its share.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct Blend {
    /// Never `auto`.
    pub method: MethodName,
    /// 0–1: how much of the motion is the second method's.
    pub amount: f64,
}

/// How segments meet at a keyframe where the agents do not stop.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "lowercase")]
pub enum Join {
    /// Each on its own, easing at both ends.
    #[default]
    Separate,
    /// With one velocity: the cumulative cubic of all keyframes.
    Smooth,
    /// Paper A's product of all segments, as printed.
    Product,
}

/// How the modes of two bases are paired.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "lowercase")]
pub enum Order {
    /// As the eigenvalues ascend.
    Eigenvalue,
    /// Each source mode takes the free target mode most like it.
    #[default]
    Greedy,
    /// Greedy, then exchanged while the worse of two pairs gains.
    Maxmin,
    /// The greatest sum of squared inner products.
    Hungarian,
}

/// Which turn is taken out before modes interpolate.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "lowercase")]
pub enum Alignment {
    /// None.
    None,
    /// Between the principal axes.
    #[default]
    Pca,
    /// The turn of least squares.
    Procrustes,
}

/// How the parameter t runs with time.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "lowercase")]
pub enum Timing {
    /// t = time.
    Linear,
    /// 3t² − 2t³.
    #[default]
    Smooth,
    /// Equal speed along the path.
    Even,
}

/// Sharing where none is given.
pub const DEFAULT_SHARING: f64 = 0.5;
