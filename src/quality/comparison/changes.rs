//! What changed between two files of one shape.

use crate::io::Loaded;
use crate::mesh::{Mesh, stored_unit};
use crate::num::parallel;
use crate::num::{AngleErrors, CompensatedSum, Degrees, angle_between};
use crate::quality::catalogue::{Kind, entries};
use crate::quality::comparison::matching::Matching;
use crate::quality::comparison::side::Side;
use crate::quality::diagnosis::Diagnosis;
use crate::quality::effect::key_light_steps;
use crate::quality::finding::Site;
use crate::quality::sites::{locate, site};
use crate::quality::spot::Spot;
use glam::DVec3;
use rayon::prelude::*;

/// Normals closer than this, in degrees, are the same: more than single precision does to each of them.
const SAME: f64 = 1e-4;

/// Half a step of 8 bits: less is not visible.
const VISIBLE: f64 = 0.5;

/// What changed between two files of one shape, corner by corner.
///
/// Faces are matched by the positions of their corners, in single precision and each part in its own space. The order of faces,
/// vertices and parts does not matter. Polygons are also matched by the triangles that
/// [`triangulate`](crate::mesh::triangulate) cuts them into. Only directions are compared, not lengths.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Comparison {
    /// How many faces the two files have.
    pub faces: [usize; 2],
    /// How many of them have no counterpart in the other.
    pub unmatched: [usize; 2],
    /// The number of faces, or of their triangles, with the opposite winding.
    pub turned: usize,
    /// Corners that were matched. A corner of a polygon counts once for each triangle at it, if the other file has those.
    pub corners: usize,
    /// Corners with a normal in the second file only.
    pub gained: usize,
    /// Corners with a normal in the first file only.
    pub lost: usize,
    /// Corners with a normal in both whose direction differs by more than 0.0001°.
    pub changed: usize,
    /// Corners whose change is at least half a step of 8 bits under a key light.
    pub visible: usize,
    /// The angles at all corners with a normal in both.
    pub angles: AngleErrors,
    /// The mean over these of the largest change of the grey value under a key light, in steps of 8 bits.
    pub mean_steps: f64,
    /// The largest angle.
    pub largest: Degrees,
    /// The positions with the largest changes, in the first file.
    pub places: Vec<Site>,
    /// The change of each corner of each part of the second file, in degrees; 0 without a counterpart.
    pub change: Vec<Vec<f64>>,
    /// Findings of either file, in the order of the catalogue, with their counts before and after.
    pub findings: Vec<(Kind, [u64; 2])>,
}

/// Why two files cannot be compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Incomparable {
    /// No face of the one is at the position of a face of the other.
    #[error(
        "the files have no face in common; compare versions of one mesh, with the transforms of nodes applied to both or to neither"
    )]
    NothingInCommon,
    /// Corners are numbered in 32 bits.
    #[error("the files have more than 2³² corners")]
    TooLarge,
}

impl Comparison {
    /// The mean and the largest change of the grey value under a key light, in steps of 8 bits.
    pub fn steps(&self) -> [f64; 2] {
        [self.mean_steps, key_light_steps(self.largest.0)]
    }

    /// Percentiles of the angles by name, in degrees.
    pub fn percentiles(&self) -> [(&'static str, f64); 3] {
        let AngleErrors { median, p95, p99, .. } = self.angles;
        [("p50", median), ("p95", p95), ("p99", p99)]
    }
}

/// Compares two files with their diagnoses. `most` is how many positions are kept.
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
    let normal = |file: usize, corner: u32| {
        let (part, corner) = sides[file].locate(corner);
        let mesh = meshes[file][part];
        stored_unit(mesh.columns().normals.as_ref()?, mesh, corner)
    };
    let normals = |pair: &[u32; 2]| [0, 1].map(|file| normal(file, pair[file]));
    let normals: Vec<[Option<DVec3>; 2]> = parallel::map_each(&matching.pairs, normals);
    let mut comparison = Comparison {
        faces: sides.each_ref().map(Side::faces),
        unmatched: matching.unmatched,
        turned: matching.reversed,
        corners: matching.pairs.len(),
        change: meshes[1].iter().map(|mesh| vec![0.0; mesh.faces().corner_count()]).collect(),
        findings: changed_findings(diagnoses),
        ..Comparison::default()
    };
    let mut worst = comparison.measure(&matching.pairs, &normals, &sides[1]);
    worst.par_sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    worst.dedup_by_key(|(_, corner)| *corner);
    let place = |&(degrees, corner): &(f64, u32)| {
        let (part, corner) = sides[0].locate(corner);
        let face = meshes[0][part].faces().ranges().position(|range| range.contains(&corner)).unwrap_or(0);
        site(files[0], &Spot { part: part as u32, ..Spot::corner(face, corner, degrees) })
    };
    comparison.places = worst.iter().take(most).map(place).collect();
    locate(comparison.places.iter_mut(), files[0]);
    Ok(comparison)
}

impl Comparison {
    /// Sums up the changes between pairs of corners. Returns those of more than rounding, with the corner before.
    fn measure(
        &mut self,
        pairs: &[[u32; 2]],
        normals: &[[Option<DVec3>; 2]],
        after_side: &Side<'_>,
    ) -> Vec<(f64, u32)> {
        let mut steps = CompensatedSum::default();
        let (mut angles, mut changes) = (Vec::new(), Vec::new());
        for (&[before, after], normals) in pairs.iter().zip(normals) {
            let angle = match *normals {
                [Some(before), Some(after)] => angle_between(before, after),
                [before, after] => {
                    self.gained += usize::from(before.is_none() && after.is_some());
                    self.lost += usize::from(before.is_some());
                    continue;
                }
            };
            angles.push(angle);
            let Degrees(degrees) = angle.into();
            let shown = key_light_steps(degrees);
            steps += shown;
            if degrees > SAME {
                self.changed += 1;
                self.visible += usize::from(shown >= VISIBLE);
                self.largest.0 = self.largest.0.max(degrees);
                let (part, corner) = after_side.locate(after);
                self.change[part][corner] = self.change[part][corner].max(degrees);
                changes.push((degrees, before));
            }
        }
        self.mean_steps = steps.value() / angles.len().max(1) as f64;
        self.angles = AngleErrors::of(&angles);
        changes
    }
}

/// How often each kind was found before and after, without those that were not.
fn changed_findings(diagnoses: [&Diagnosis; 2]) -> Vec<(Kind, [u64; 2])> {
    let count = |kind| diagnoses.map(|found| found.get(kind).map_or(0, |finding| finding.count));
    let counts = entries().map(|entry| (entry.kind, count(entry.kind)));
    counts.filter(|(_, counts)| *counts != [0; 2]).collect()
}
