//! Warnings that may be due many times, and the check that every reader ends with.

use super::{NonFinite, Note, Part, Place, Problem, ReadError, ReadOptions};
use crate::mesh::{MeshBuilder, MeshError};

/// Something odd that is said once: where it was first, and how often.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Tally {
    count: u64,
    first: usize,
}

impl Tally {
    /// It was met at this offset.
    pub fn add(&mut self, offset: usize) {
        if self.count == 0 {
            self.first = offset;
        }
        self.count += 1;
    }

    /// A value, or 0 and a count where it will not do.
    pub fn mend<T: Default>(&mut self, is_good: bool, value: T, offset: usize) -> T {
        if is_good {
            return value;
        }
        self.add(offset);
        T::default()
    }

    /// Whether it was met at all.
    pub fn is_met(self) -> bool {
        self.count > 0
    }

    /// The warning, if there is any.
    pub fn note(self, place: impl FnOnce(usize) -> Place, text: &str) -> Option<Note> {
        let more = match self.count {
            0 => return None,
            1 => String::new(),
            count => format!(" (and {} more like it)", count - 1),
        };
        Some(Note::warning(place(self.first), format!("{text}{more}")))
    }
}

/// The most bytes that a file may have.
pub(super) fn check_size(bytes: &[u8], options: &ReadOptions) -> Result<(), ReadError> {
    if bytes.len() as u64 <= options.limits.bytes {
        return Ok(());
    }
    let found = format!("{} bytes, more than the limit of {}", bytes.len(), options.limits.bytes);
    Err(ReadError::new(Problem::Limit, Place::File, found, "raise the limit"))
}

/// Checks the mesh of a part. `place` tells where the faulty vertex or face is.
pub(super) fn build_part(
    name: String,
    builder: MeshBuilder,
    options: &ReadOptions,
    place: impl FnOnce(&MeshError) -> Place,
) -> Result<Part, ReadError> {
    let built = match options.non_finite {
        NonFinite::Refuse => builder.build().map(|mesh| (mesh, Vec::new())),
        NonFinite::DropFaces => builder.build_dropping_non_finite(),
    };
    match built {
        Ok((mesh, non_finite_faces)) => Ok(Part { name, mesh, non_finite_faces }),
        Err(error) => {
            let (problem, advice) = match error {
                MeshError::NonFinite { .. } => {
                    (Problem::NonFinite, "correct it, or drop the faces that use such vertices with --force")
                }
                MeshError::TooLarge { .. } => (Problem::Limit, "divide the mesh"),
                _ => (Problem::Range, "the file is damaged, or its writer is at fault"),
            };
            Err(ReadError::new(problem, place(&error), error.to_string(), advice))
        }
    }
}
