//! 3D Manufacturing Format (3MF Core Specification 1.4, and the Production Extension 1.1): objects, components and the build of a
//! package. Files have no normals, so they are read only.

// The parts of the package: a ZIP archive.
mod package;
// One model part: its objects and its build, as XML.
mod model;
// All model parts, and where the build places their meshes.
mod read;

pub(super) use package::is_certain;
pub use read::read;

// Tests of the 3MF reader.
#[cfg(test)]
mod tests;
