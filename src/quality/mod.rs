//! What is wrong with the normals of a mesh: why, where, and how much it shows (layer 3).
//!
//! [`diagnose`] checks a file and returns a [`Diagnosis`]: findings with a stable name, a cause in words, counts, the worst
//! positions, and a command that fixes them. The [`catalogue`] explains what each finding means for a picture.
//!
//! # How a normal is judged
//! 1. **Estimate.** The recipe of the stored normals is estimated: the weighting and the crease angle that reproduce them best
//!    ([`Estimate`]). Every normal is compared with what this recipe gives. A mesh that was made by another recipe than the
//!    default is not wrong. If no recipe fits, the normals are authored, which is a note.
//! 2. **All normals.** Normals may be constant, negated, or rotated or reflected as a whole. If no recipe fits the stored normals
//!    but one fits after a rotation of all of them, the rotation is the finding. Normals on fewer than three lines leave the
//!    rotation open, as those of flat sheets do, and so do normals of which no recipe gives half.
//! 3. **Single corners.** A corner is a fault if nothing at its vertex explains its normal: it is the mean of no run of faces, as
//!    marked edges make, and no other corner of the vertex has it, or most of these have the expected normal.
//! 4. **Whole vertices.** A normal that all corners of a vertex share is an outlier only if a recipe made the rest of the mesh. It
//!    is flipped if it is the exact opposite of the expected one, or the only one of its face. Leaves that are lit like a ball
//!    are intended.
//! 5. **Regions.** A connected component was made in another way than the rest if fewer than one in three of its normals follow the
//!    recipe and they are neither negated nor rotated as a whole. So was a region in which no normal follows it and the deviations
//!    change gradually.
//! 6. **Winding.** Faces that have the opposite winding of their neighbours, face inwards or have no direction are findings of their own and do not
//!    count against normals. At these faces a normal is an outlier only if no mean explains it, with the faces as they are or
//!    reversed. A closed surface whose faces and normals point inwards is judged as it is. If it encloses closed components of
//!    the same mesh whose faces and most normals point outwards, it is a room, and right.
//!
//! Findings about shading are notes: even correct normals have them.
//!
//! # What cannot be determined
//! - One wrong normal on all corners of a vertex, if the others follow no recipe: it may be authored. A recipe is followed if 98 of
//!   100 normals are within 5° of it. The exact normals of a coarse surface may not be.
//! - Few normals edited on a surface that follows a recipe: fewer than 16 faces are taken for single faults.
//! - More than half of all sharp edges averaged: that is then the recipe, and the rest is custom.
//! - Which of several nodes' matrices is in the normals, if they have the same effect. One is named, and that there are others. A
//!   stretch shows only in normals between its axes, and not on authored normals unless it is larger than their deviation. In
//!   formats without nodes, only a rotation or reflection is found: stretched normals pass as authored.
//! - A cut through a coarse mesh at dihedral angles above the default crease angle of 40°: it looks like a crease. If more than one
//!   in fifty edges is split below the crease angle, they are a cut if their median dihedral angle is at most 1.25 times the upper
//!   quartile of smooth edges. Next to many intended creases it stays a note.
//! - The recipe of normals that were smoothed across what are now borders of parts: each part is judged by itself. A normal that
//!   another part has at the same position, to the bit, is taken to continue there.
//! - Whether facets are intended: a ball with flat normals is a note. Whether a shape with dihedral angles of all sizes and no broad
//!   flats should be sharp: if it is smooth all over, it passes.
//!
//! # How good that is
//! The lowest recall and precision of faults that were planted into clean meshes at known positions, of twice the threshold or more,
//! over an icosphere, an uneven torus, an open wave, an open bowl and a gear, and what else is reported of them. Rooms made of a
//! ball, of a box and of the gear have the same limits.
//!
#![doc = include_str!("measured/planted.md")]
//!
//! The confusion matrix: on how many of those meshes each kind was planted, and on how many each was reported, as error, warning or
//! note, unless the clean mesh has it too. Rounding leaves loose lengths. The other entries off the diagonal are notes about the
//! planted mesh that are also true.
//!
#![doc = include_str!("measured/confusion.md")]
//!
//! Recall by the size of the fault, over the icosphere and the bowl. Faults below the threshold pass:
//!
#![doc = include_str!("measured/recall.md")]

// From which size a deviation is a finding.
mod thresholds;
// Angles in degrees and limits of them.
mod angles;
// How much a finding matters, and what it counts.
mod element;
// The list of all findings, with their texts.
pub mod catalogue;
// One occurrence of a finding.
mod spot;
// Occurrences, counted in parallel.
mod counts;
// A part of a file, before its normals are judged.
mod input;
// Which recipe made the stored normals.
mod estimate;
// The analysis of a part that all findings use.
mod facts;
// What a wrong normal does to a picture.
mod effect;
// The findings, one file for each or for a close family.
mod findings;
// A finding in a file.
mod finding;
// One command for several findings.
mod fix;
// Where an occurrence is in its file.
mod sites;
// From a file to its findings.
mod diagnosis;
// Before and after: two files of one shape.
mod comparison;
// Data for the pictures and histograms of a report.
mod survey;

pub use comparison::changes::{Comparison, Incomparable, compare};
pub use diagnosis::{Diagnosis, Occurrence, PartDiagnosis, diagnose, occurrences};
pub use effect::key_light_steps;
pub use element::{Element, Severity};
pub use estimate::recipe::{Estimate, SAMPLE};
pub use finding::{Finding, Site, fix_command};
pub use findings::storage::quantisation::Precision;
pub use fix::Fix;
pub use survey::{Survey, survey};
pub use thresholds::Thresholds;
