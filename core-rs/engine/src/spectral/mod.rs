//! (spectral)
