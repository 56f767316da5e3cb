//! Before and after: what changed between two files of one shape.

mod cut;
mod matching;

use crate::io::Loaded;
use crate::mesh::{Mesh, stored_unit};
use crate::num::{CompensatedSum, Degrees, angle_between};
use crate::quality::catalogue::Kind;
use crate::quality::counts::Spot;
use crate::quality::diagnosis::{Diagnosis, locate, site};
use crate::quality::effect::lost_light::key_light_steps;
use crate::quality::finding::Site;
use glam::DVec3;
use matching::{Matching, Side};
use rayon::prelude::*;

/// From here on, in degrees, two normals are two: above what rounding to single precision does to each of them.
const SAME: f64 = 1e-4;

/// Half a step of 8 bits: what rounding may show.
const VISIBLE: f64 = 0.5;

/// What changed between two files of one shape, corner by corner.
///
/// Faces are matched by the places of their corners, in single precision and each part in its own space, so that the order
/// of faces, vertices and parts does not matter; polygons also by the triangles that [`triangulate`](crate::mesh::triangulate)
/// cuts them into. Only directions are compared: a normal that got longer or shorter did not change.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Comparison {
    /// How many faces the two files have.
    pub faces: [usize; 2],
    /// How many of them have no counterpart in the other.
    pub unmatched: [usize; 2],
    /// Faces, or triangles of them, that go round the other way.
    pub turned: usize,
    /// Corners that were matched. A corner of a polygon is one for each triangle at it, where the other file has those.
    pub corners: usize,
    /// Corners with a normal in the second file only.
    pub gained: usize,
    /// Corners with a normal in the first file only.
    pub lost: usize,
    /// Corners with a normal in both whose direction differs by more than 0.0001°.
    pub changed: usize,
    /// Corners whose change is half a step of 8 bits and more under a key light.
    pub visible: usize,
    /// The mean angle over all corners with a normal in both.
    pub mean: Degrees,
    /// The mean over the same of what each change does to a grey value under a key light at most, in steps of 8 bits.
    pub mean_steps: f64,
    /// The largest angle.
    pub largest: Degrees,
    /// The places that changed most, in the first file.
    pub places: Vec<Site>,
    /// For every part and corner of the second file, by how many degrees its normal changed; 0 without a counterpart.
    pub change: Vec<Vec<f64>>,
    /// Findings of either file, in the order of the catalogue, with their counts before and after.
    pub findings: Vec<(Kind, [u64; 2])>,
}

/// Why two files cannot be compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Incomparable {
    /// No face of the one stands where one of the other does.
    NothingInCommon,
    /// Corners are numbered in 32 bits.
    TooLarge,
}

impl std::fmt::Display for Incomparable {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::NothingInCommon => {
                "no face of the one file has its corners where a face of the other has them, each part in its own space: these are \
                 different shapes, or nodes that place the parts of one were applied to the other"
            }
            Self::TooLarge => "the files have more than 2³² corners",
        })
    }
}

impl std::error::Error for Incomparable {}

impl Comparison {
    /// What the changes do to a grey value under a key light at most, in steps of 8 bits: in the mean, and the largest.
    pub fn steps(&self) -> [f64; 2] {
        [self.mean_steps, key_light_steps(self.largest.0)]
    }
}

/// Compares two files, with what was found in each; `most` is how many places to tell.
///
/// ```
/// use crease::io::{Format, ReadOptions, read_bytes};
/// use crease::quality::{Thresholds, compare, diagnose};
///
/// let read = |normal: &str| {
///     let text = format!("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn {normal}\nf 1//1 2//1 3//1\n");
///     read_bytes(text.into_bytes(), Some(Format::Obj), None, &ReadOptions::default()).unwrap()
/// };
/// let files = ["0 0 1", "0 1 1"].map(read);
/// let found = files.each_ref().map(|file| diagnose(file, &Thresholds::default(), &|_| {}));
/// let comparison = compare(files.each_ref(), found.each_ref(), 10)?;
/// assert_eq!((comparison.corners, comparison.changed), (3, 3));
/// assert!((comparison.largest.0 - 45.0).abs() < 1e-12);
/// # Ok::<(), crease::quality::Incomparable>(())
/// ```
///
/// # Errors
/// If the files have no face in common.
pub fn compare(
    files: [&Loaded; 2],
    diagnoses: [&Diagnosis; 2],
    most: usize,
) -> Result<Comparison, Incomparable> {
    let meshes = files.map(|file| file.parts.iter().map(|part| &part.mesh).collect::<Vec<&Mesh>>());
    let sides = meshes.each_ref().map(|meshes| Side::new(meshes.clone()));
    if sides.iter().any(|side| side.corners() > u32::MAX as usize) {
        return Err(Incomparable::TooLarge);
    }
    let matching = Matching::find(&sides);
    if matching.pairs.is_empty() {
        return Err(Incomparable::NothingInCommon);
    }
    let normals = |pair: &[u32; 2]| {
        [0, 1].map(|file| {
            let (part, corner) = sides[file].locate(pair[file]);
            let mesh = meshes[file][part];
            stored_unit(mesh.columns().normals.as_ref()?, mesh, corner)
        })
    };
    let angles: Vec<[Option<DVec3>; 2]> = matching.pairs.par_iter().map(normals).collect();
    let mut comparison = Comparison {
        faces: sides.each_ref().map(Side::faces),
        unmatched: matching.unmatched,
        turned: matching.turned,
        corners: matching.pairs.len(),
        change: meshes[1].iter().map(|mesh| vec![0.0; mesh.faces().corner_count()]).collect(),
        findings: changed_findings(diagnoses),
        ..Comparison::default()
    };
    let (mut sum, mut steps, mut both) = (CompensatedSum::default(), CompensatedSum::default(), 0usize);
    let mut worst: Vec<(f64, u32)> = Vec::new();
    for (&[before, after], normals) in matching.pairs.iter().zip(angles) {
        let degrees = match normals {
            [Some(before), Some(after)] => Degrees::from(angle_between(before, after)).0,
            [None, None] => continue,
            [from, _] => {
                *(if from.is_none() { &mut comparison.gained } else { &mut comparison.lost }) += 1;
                continue;
            }
        };
        both += 1;
        sum += degrees;
        let shown = key_light_steps(degrees);
        steps += shown;
        if degrees > SAME {
            comparison.changed += 1;
            comparison.visible += usize::from(shown >= VISIBLE);
            comparison.largest.0 = comparison.largest.0.max(degrees);
            let (part, corner) = sides[1].locate(after);
            comparison.change[part][corner] = comparison.change[part][corner].max(degrees);
            worst.push((degrees, before));
        }
    }
    [comparison.mean.0, comparison.mean_steps] = [sum, steps].map(|sum| sum.value() / both.max(1) as f64);
    worst.par_sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    worst.dedup_by_key(|(_, corner)| *corner);
    let place = |&(degrees, corner): &(f64, u32)| {
        let (part, corner) = sides[0].locate(corner);
        let mesh = meshes[0][part];
        let face = mesh.faces().ranges().position(|range| range.contains(&corner)).unwrap_or(0);
        site(mesh, Spot::corner(face, corner, degrees), part)
    };
    comparison.places = worst.iter().take(most).map(place).collect();
    locate(comparison.places.iter_mut(), files[0]);
    Ok(comparison)
}

/// How often each kind was found before and after.
fn changed_findings(diagnoses: [&Diagnosis; 2]) -> Vec<(Kind, [u64; 2])> {
    let count = |kind| diagnoses.map(|found| found.get(kind).map_or(0, |finding| finding.count));
    let kinds = crate::quality::catalogue::entries().map(|entry| entry.kind);
    kinds
        .map(|kind| (kind, count(kind)))
        .filter(|(_, counts)| counts.iter().any(|&count| count > 0))
        .collect()
}
