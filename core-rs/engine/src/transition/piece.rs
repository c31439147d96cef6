//! What plans are made of: each piece is known by what it was made from.

use std::sync::Arc;

use faer::Mat;

use super::chain::Couple;
use crate::adjacency::Adjacency;
use crate::choice::Order;
use crate::recent::Same;
use crate::spectral::{Eigenbasis, Matched, Pair, Pairing, Planes, Spectrum};

/// How a piece is made. Its ingredients are shared objects compared by identity, and every piece is an ingredient of others.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Recipe {
    /// The eigenvalues of a graph.
    Spectrum(Same<Adjacency>),
    /// The eigenbasis of a graph.
    Basis(Same<Adjacency>),
    /// The source's eigenbasis with the tie-break of both mixed in.
    BrokenSource(Couple),
    /// The target's.
    BrokenTarget(Couple),
    /// The eigenbasis of the mean of both graphs.
    Mean(Couple),
    /// Both bases side by side.
    Pair(Couple),
    /// Which mode becomes which.
    Pairing(Same<Pair>, Order),
    /// Signs too, and the rotation taken apart.
    Matched(Same<Pair>, Order, Vec<bool>),
    /// The rotation of a pair over all agents.
    Turn(Same<Matched>),
    /// The rotation that takes a keyframe's basis toward its neighbors' by an amount.
    Meeting { before: Option<Same<Planes>>, after: Option<Same<Planes>>, amount: f64 },
    /// The rotation that is left between two keyframes once their bases were taken toward their neighbors'.
    Rest { turn: Same<Planes>, source: Same<Planes>, target: Same<Planes> },
    /// The mean of two logarithms: its exponential.
    Halfway { before: Same<Planes>, after: Same<Planes>, share: f64 },
    /// What a rotation leaves to do once the first turned by the start of it and the last will turn by the end of it.
    Middle { whole: Same<Planes>, first: (Same<Planes>, f64), last: (Same<Planes>, f64) },
    /// One rotation after another.
    Product { first: Same<Planes>, second: Same<Planes> },
    /// A rotation to a power, as a matrix.
    Power(Same<Planes>, f64),
}

/// A piece of a plan.
#[derive(Clone, Debug)]
pub(super) enum Piece {
    Spectrum(Arc<Spectrum>),
    Basis(Arc<Eigenbasis>),
    Pair(Arc<Pair>),
    Pairing(Arc<Pairing>),
    Matched(Arc<Matched>),
    Planes(Arc<Planes>),
    Matrix(Arc<Mat<f64>>),
}
