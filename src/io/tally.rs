//! Warnings that may be due many times, and the check that every reader ends with.

use super::text::counted;
use super::{NonFinite, Note, Part, Place, Problem, ReadError, ReadOptions, Severity};
use crate::mesh::{MeshBuilder, MeshError};
use glam::DVec3;

/// Something odd that is said once: how often it was met, and where at first.
#[derive(Clone, Debug, Default)]
pub(super) struct Tally {
    count: u64,
    /// Offsets, no more than a note lists.
    places: Vec<usize>,
}

impl Tally {
    /// It was met at this offset.
    pub fn add(&mut self, offset: usize) {
        self.add_all(1, [offset]);
    }

    /// It was met so often, at these offsets among others.
    pub fn add_all(&mut self, count: u64, offsets: impl IntoIterator<Item = usize>) {
        let room = (1 + Note::MOST_PLACES).saturating_sub(self.places.len());
        self.places.extend(offsets.into_iter().take(room));
        self.count += count;
    }

    /// It was also met as another tally says, behind where this one met it.
    pub fn append(&mut self, other: Tally) {
        self.add_all(other.count, other.places);
    }

    /// The offset where it was first.
    pub fn first(&self) -> Option<usize> {
        self.places.iter().min().copied()
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
    pub fn is_met(&self) -> bool {
        self.count > 0
    }

    /// The note, if there is any; `places` turns ascending offsets into places.
    pub fn note(
        &self,
        severity: Severity,
        places: impl FnOnce(&[usize]) -> Vec<Place>,
        text: impl Into<String>,
    ) -> Option<Note> {
        let mut offsets = self.places.clone();
        offsets.sort_unstable();
        Note::for_all(severity, self.count, places(&offsets), text)
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

/// What is told of positions that are not finite where they are let pass.
pub(super) fn non_finite_note(positions: &[DVec3], non_finite: NonFinite) -> Option<Note> {
    let is_bad = |position: &DVec3| !position.is_finite();
    let first = positions.iter().position(is_bad).filter(|_| non_finite == NonFinite::DropFaces)?;
    let count = counted(positions.iter().filter(|position| is_bad(position)).count(), "vertex", "vertices");
    let text = format!(
        "no finite position: {count} (the first is vertex {first}, counted from 0); faces there are dropped, and what \
         the file says stays where it is edited, but is the origin in a new file"
    );
    Some(Note::warning(Place::File, text))
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
                MeshError::NonFinite { .. } => (
                    Problem::NonFinite,
                    "correct it (text beyond 1.8e308 reads as infinite), or drop the faces that use such vertices with `crease normals --force` (`crease render --force` draws the others)",
                ),
                MeshError::TooLarge { .. } => (Problem::Limit, "divide the mesh"),
                _ => (Problem::Range, "the file is damaged, or its writer is at fault"),
            };
            Err(ReadError::new(problem, place(&error), error.to_string(), advice))
        }
    }
}
