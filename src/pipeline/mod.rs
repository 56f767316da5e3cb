//! From a file as it was read to what changes in it (layer 3).
//!
//! `io` knows files and `normals` knows meshes; [`revise`] puts them together, part by part: faces without finite
//! positions are dropped, the others are oriented as asked, normals are computed on the faces of the output,
//! and the result refers to the mesh *as it was read*, which is what [`write`](crate::io::write) takes.
//!
//! ```no_run
//! use crease::{io, pipeline};
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let loaded = io::read("gear.obj".as_ref(), None, &io::ReadOptions::default())?;
//! let revision = pipeline::revise(&loaded, &pipeline::Task::default(), Some(io::Format::Glb), &|_| {});
//! let written = io::write(&loaded, revision.edits, io::Format::Glb, &io::WriteOptions::default())?;
//! std::fs::write("gear.glb", written.bytes)?;
//! # Ok(())
//! # }
//! ```

// What to do.
mod task;
// What was found.
mod outcome;
// The faces of the output.
mod edited_part;
// The change of a file.
mod revision;

pub use outcome::{Counts, FaultCounts, FaultPlace, MOST_PLACES, PartOutcome, Spot};
pub use revision::{Revision, forget_unused, revise};
pub use task::{Degenerate, Task};

// Tests of the revision of single parts.
#[cfg(test)]
mod tests;
