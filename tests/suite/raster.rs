//! The rasterizer: coverage, interpolation, shading and what must not change them.

mod casting;
mod coverage;
mod extremes;
mod interpolation;
mod probe;
mod shading;
mod shapes;
mod stress;
mod tracing;
