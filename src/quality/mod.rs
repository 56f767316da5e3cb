//! What is wrong with a mesh's normals, why, where, and how much it shows (layer 3).
//!
//! [`diagnose`] looks at a file and gives a [`Diagnosis`]: findings with a stable name, a cause in words, counts, the
//! worst places, and what mends them. The [`catalogue`] tells what each finding means for a picture.
//!
//! # How a normal is judged
//! Stored normals are compared with those that *this* mesh's own normals were most likely made by: the weighting and the
//! crease angle that reproduce them best ([`Estimate`]). So a mesh made by another rule than our default is not wrong,
//! and where no rule fits, the normals were made by hand and are only noted. Single corners are faults whatever made the
//! others if nothing at their vertex explains them: no run of the faces there has such a mean, as marks on edges make, and no
//! other corner there has the same normal, or most have what the best rule gives. What all corners of a vertex share can be
//! told to stray only where a rule made the rest, and to be turned round besides where it is the very opposite of the right
//! one, or alone of its face: leaves that are lit like a ball are meant. So they are beside the trunk of a tree: a connected
//! piece of surface of whose normals fewer than one in three are what the rule gives, without having been negated or turned as a
//! whole, was made otherwise than the rest. So was a region in which none is, and what they are off by goes on smoothly, unless
//! all are negated or the same. Where none fits them as they are but one does once a rotation or reflection of all of them is taken off, that is what is told. Normals on fewer than three lines, as of
//! a flat sheet or two, leave open what they were turned by, and so do normals of which no rule gives half. Faces that run
//! against their neighbours, that are inside out or without direction have no say about normals: their cause is told of
//! them, not of the normals; beside and on them a single normal is told to stray if no mean explains it, over these faces as
//! they are or turned back. The normals of a closed surface that faces inwards and whose normals do so too are judged by
//! its faces as they are; with closed things in it, in the same mesh, that face outwards, as most of their normals do, it is
//! a room, and right.
//!
//! Findings about shading are notes: they are what even right normals will show.
//!
//! # What cannot be told
//! - All corners of a vertex with one wrong normal, where the others follow no rule: an artist may have made it so. A rule is
//!   followed where 98 of 100 normals are within 5° of what it gives; the exact ones of a coarsely cut surface may not be.
//! - Few normals bent by hand in one place of a surface that follows a rule: fewer than 16 faces are taken for single faults.
//! - More than half of all sharp edges averaged: what most edges have is then the rule, and the rest is custom.
//! - Which of several nodes' matrices stands in normals where these do the same to them, as a turn and the one that takes it
//!   back: one is named, and that there are others. A stretch shows in normals that lean between its axes only, and passes on
//!   ones made by hand unless it is more than they are off their rule. What no node of the file does, as in formats without
//!   nodes, is looked for as a turn or a mirror only: stretched normals pass as made by hand.
//! - A cut through a coarse mesh where it bends by more than the 40° that creases begin at by default: it looks like one. Where
//!   more than one in fifty of the edges that bend is split below the crease angle, a cut is told from edges that were marked
//!   by how far the split edges bend: the middle one of them by no more than 1.25 times what three in four smooth edges bend
//!   by. With many meant creases beside it, it stays a note.
//! - By which rule normals were smoothed over what are the borders of parts now: each part is looked at by itself. Where another
//!   part has the same normal at the same place of the world, to the bit, it is taken for one that goes on there.
//! - Whether facets are meant: a ball stored flat gets a note. Whether a shape with bends of all sizes and no broad flats was
//!   meant to be sharp: made smooth all over, it passes.
//!
//! # How good that is
//! Faults planted into clean meshes at known places, of twice the threshold or more: the lowest recall and precision over
//! an icosphere, an uneven torus, an open wave, an open bowl and a gear, and what else is told of them. Rooms made of a
//! ball, of a box and of the gear are held to the same.
//!
#![doc = include_str!("measured/planted.md")]
//!
//! The confusion matrix: on how many of those meshes each kind was planted, and on how many each was reported, as error,
//! warning or note, unless the clean mesh has it too. Rounding leaves loose lengths; what else stands beside the diagonal
//! are notes of what else is true of the planted mesh.
//!
#![doc = include_str!("measured/confusion.md")]
//!
//! Recall by the size of the fault, over the icosphere and the bowl; below its threshold a fault passes:
//!
#![doc = include_str!("measured/recall.md")]

// From which size a deviation is a finding.
mod thresholds;
// A finding: cause, count, positions.
mod finding;
// The analysis of one part that all findings use.
mod facts;
// Counts of findings in parallel.
mod counts;
// Data for pictures and histograms of a report.
mod survey;
// From a file to its findings.
mod diagnosis;
// Geometry: faces, edges and vertices that spoil normals.
mod geometry;
// Smoothing: what stored normals do across edges.
mod smoothing;
// Stored: the normals of the file, corner by corner.
mod stored;
// Storage: the precision in which normals are stored.
mod storage;
// Estimate: which recipe made the stored normals.
mod estimate;
// Effect: what a wrong normal does to a picture.
pub mod catalogue;
mod comparison;
mod effect;

pub use comparison::{Comparison, Incomparable, compare};
pub use diagnosis::{Diagnosis, PartDiagnosis, diagnose};
pub use effect::lost_light::key_light_steps;
pub use estimate::recipe::{Estimate, SAMPLE};
pub use finding::{Element, Finding, Severity, Site};
pub use storage::quantisation::Precision;
pub use survey::{Survey, survey};
pub use thresholds::Thresholds;
