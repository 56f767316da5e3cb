//! Memory that one computation leaves to the next.

use crate::normals::creases::triangle_groups::GroupMemory;
use crate::normals::faces::face_normals::FaceNormals;
use crate::normals::sums::request::SlotState;
use crate::normals::sums::weighted_sums::SumScratch;

/// Memory for intermediate results: a second call of the same size allocates next to nothing but its result. New memory has
/// to be cleared by the system, which can take longer than the computation.
#[derive(Default)]
pub struct Scratch {
    pub(in crate::normals) sums: SumScratch,
    pub(in crate::normals) slots: Vec<SlotState>,
    pub(in crate::normals) faces: FaceNormals,
    pub(in crate::normals) groups: GroupMemory,
    /// Nothing will use it again: what a later step does not need is freed at once.
    pub(in crate::normals) serves_once: bool,
}

impl Scratch {
    /// Empty.
    pub fn new() -> Self {
        Self::default()
    }

    /// For one computation only.
    pub(in crate::normals) fn once() -> Self {
        Self { serves_once: true, ..Self::default() }
    }
}
