//! The quick end of the trade: everything in `f32`, on positions rounded to `f32`.
//!
//! Within its range a face normal is off by at most 3e-7 rad times length over height, so 3e-4 rad (0.017°) for the
//! thinnest face allowed; a mean whose sum shrinks by k, by no more than k times that of its worst face, where k is near 1 on
//! smooth surfaces and up to 1000 at steep tips. Whatever lies outside the range is left to
//! the faithful way: [`Single`] then declines.

use crate::mesh::{FacesRef, Topology};
use crate::normals::creases::smooth_groups::SlotCorners;
use crate::normals::faces::face_normals::FaceNormals;
use crate::normals::faces::shape::FaceState;
use crate::normals::recipe::Weight;
use crate::normals::sums::request::{SlotState, Sums};
use crate::num::corner_angle;
use glam::{DVec3, Vec3};
use rayon::prelude::*;
use std::f32::consts::TAU;

/// Squares of the shortest and the longest edge: 1e-6 and 1e6, in units of the caller.
const SQUARED_EDGES: std::ops::RangeInclusive<f32> = 1e-12..=1e12;
/// Least height of a face, as a share of its longest edge.
const LEAST_HEIGHT: f32 = 1e-3;
/// Most faces in one sum.
const MOST_FACES: u32 = 1000;
/// Sums that shrink to less than this share of their weights lose three of the seven digits of an `f32`.
const LEAST_SUM: f32 = 1e-3;
/// Height under which the direction of a face is rounding, as a share of its largest coordinate: 4 ulp.
const LEAST_RELATIVE_HEIGHT: f32 = 4.0 * f32::EPSILON;

/// Positions and face normals in single precision.
pub(crate) struct Single<'a> {
    faces: FacesRef<'a>,
    positions: Vec<Vec3>,
    shapes: Vec<Shape>,
}

/// A face: its unit normal, and twice its area.
#[derive(Clone, Copy, Default)]
struct Shape {
    normal: Vec3,
    area: f32,
}

/// What has been added up for a slot.
#[derive(Clone, Copy, Default)]
struct Total {
    sum: Vec3,
    weights: f32,
    count: u32,
}

impl<'a> Single<'a> {
    /// Rounds positions and computes face normals; `None` if anything is out of range.
    pub(crate) fn new(faces: FacesRef<'a>, positions: &[DVec3]) -> Option<Self> {
        let positions: Vec<Vec3> = positions.par_iter().map(|p| p.as_vec3()).collect();
        let mut shapes = vec![Shape::default(); faces.len()];
        let shape = |(face, out): (usize, &mut Shape)| -> Option<()> {
            *out = Shape::new(faces.face(face), &positions)?;
            Some(())
        };
        shapes.par_iter_mut().enumerate().with_min_len(TASK).try_for_each(shape)?;
        Some(Self { faces, positions, shapes })
    }

    /// The face normals, as the rest of the way wants them.
    pub(crate) fn face_normals(&self) -> FaceNormals {
        FaceNormals {
            unit: self.shapes.par_iter().map(|shape| widened(shape.normal)).collect(),
            state: vec![FaceState::Counted; self.shapes.len()],
        }
    }

    /// The weight of one corner.
    fn weight(&self, weight: Weight, face: usize, corner: usize) -> f32 {
        let Shape { normal, area } = self.shapes[face];
        let edges = || {
            let corners = self.faces.face(face);
            let (count, place) = (corners.len(), corner - self.faces.start(face));
            let at = |place: usize| self.positions[corners[place] as usize];
            let next = if place + 1 < count { place + 1 } else { 0 };
            let before = if place > 0 { place - 1 } else { count - 1 };
            let (e1, e2) = (at(next) - at(place), at(before) - at(place));
            [e1, e2, e1.cross(e2)]
        };
        let angle = || {
            let [e1, e2, cross] = edges();
            let angle = corner_angle(cross.length().into(), e1.dot(e2).into()) as f32;
            if cross.dot(normal) < 0.0 { TAU - angle } else { angle }
        };
        match weight {
            Weight::Uniform => 1.0,
            Weight::Area => area,
            Weight::Angle | Weight::Quadric => angle(),
            Weight::AngleArea => angle() * area,
            Weight::Max => {
                let [e1, e2, cross] = edges();
                cross.length() / e1.length_squared() / e2.length_squared()
            }
            Weight::Edge => {
                let [e1, e2, _] = edges();
                1.0 / (e1.length() * e2.length())
            }
        }
    }

    /// Sums over slots, in ascending face index; `None` if a sum is out of range.
    pub(crate) fn sums(
        &self,
        weight: Weight,
        target: &[u32],
        slots: usize,
        members: Option<&SlotCorners>,
        topology: &Topology,
    ) -> Option<Sums> {
        let face_of = |corner: usize| topology.face_of(corner as u32) as usize;
        let of_corner = |corner: usize| self.weight(weight, face_of(corner), corner);
        let weights: Vec<f32> = (0..target.len()).into_par_iter().map(of_corner).collect();
        let mut totals = vec![Total::default(); slots];
        let mut add = |slot: u32, corner: usize| {
            totals[slot as usize].add(self.shapes[face_of(corner)].normal, weights[corner]);
        };
        match members {
            None => target.iter().enumerate().for_each(|(corner, &slot)| add(slot, corner)),
            Some(members) => (0..slots as u32).for_each(|slot| {
                members.row(slot).iter().for_each(|&corner| add(slot, corner as usize));
            }),
        }
        let unit = totals
            .par_iter()
            .all(Total::is_in_range)
            .then(|| totals.par_iter().map(Total::unit).collect())?;
        Some(Sums { unit, state: vec![SlotState::Good; slots] })
    }
}

/// Faces that one task looks at.
const TASK: usize = 1024;

impl Shape {
    /// `None` if the face is out of range. Without roots but one: what is compared is squared.
    #[inline(always)]
    fn new(corners: &[u32], positions: &[Vec3]) -> Option<Self> {
        let at = |vertex: &u32| positions[*vertex as usize];
        let (first, mut before) = (at(corners.first()?), at(corners.last()?));
        let (mut vector, mut largest) = (Vec3::ZERO, 0.0_f32);
        let (mut shortest, mut longest) = (f32::INFINITY, 0.0_f32);
        for here in corners.iter().map(at) {
            // Twice the area vector, relative to the first corner.
            vector += (before - first).cross(here - first);
            let squared = before.distance_squared(here);
            (shortest, longest) = (shortest.min(squared), longest.max(squared));
            largest = largest.max(here.abs().max_element());
            before = here;
        }
        let squared = vector.length_squared();
        let (least, relative) = (LEAST_HEIGHT * longest, LEAST_RELATIVE_HEIGHT * largest);
        let in_range = SQUARED_EDGES.contains(&shortest)
            && SQUARED_EDGES.contains(&longest)
            && squared >= least * least
            && squared >= relative * relative * longest;
        let area = squared.sqrt();
        in_range.then(|| Self { normal: vector / area, area })
    }
}

impl Total {
    #[inline(always)]
    fn add(&mut self, normal: Vec3, weight: f32) {
        self.sum += normal * weight;
        self.weights += weight;
        self.count += 1;
    }

    /// A slot without faces is no group.
    fn is_in_range(&self) -> bool {
        let Self { sum, weights, count } = *self;
        count == 0 || count <= MOST_FACES && weights.is_normal() && sum.length() >= LEAST_SUM * weights
    }

    fn unit(&self) -> DVec3 {
        if self.count == 0 { DVec3::Z } else { widened(self.sum / self.sum.length()) }
    }
}

/// A vector of length 1 but for the rounding of single precision, made unit in doubles. The square is off by e < 10⁻⁶, so three
/// terms of the series of 1/√(1 + e) leave 10⁻¹⁸.
#[inline(always)]
fn widened(normal: Vec3) -> DVec3 {
    let normal = normal.as_dvec3();
    let e = normal.length_squared() - 1.0;
    normal * (1.0 - e * (0.5 - 0.375 * e))
}

#[cfg(test)]
mod tests {
    use crate::mesh::{Faces, Mesh, MeshBuilder};
    use crate::normals::compute::compute;
    use crate::normals::recipe::{NormalRecipe, Precision, Weight};
    use crate::normals::test_meshes::bumpy;
    use glam::DVec3;

    fn mesh(scale: f64, flatten: f64) -> Mesh {
        let (faces, positions) = bumpy(24, 7);
        let positions = positions.iter().map(|&p| p * DVec3::new(scale, scale, scale * flatten)).collect();
        let faces = Faces::triangles(faces.as_flattened().to_vec());
        MeshBuilder { positions, faces, ..MeshBuilder::default() }.build().unwrap()
    }

    /// In range the quick way is taken and stays within its stated error: on this mesh no face is thinner than a
    /// hundredth of its length, so 3e-5 rad. It must differ from the faithful way, or it would not be another one.
    #[test]
    fn in_range_it_is_close_and_not_the_same() {
        for weight in Weight::ALL.into_iter().filter(|&weight| weight != Weight::Quadric) {
            let recipe = NormalRecipe { weight, ..NormalRecipe::default() };
            let faithful = compute(&mesh(1.0, 1.0), &recipe);
            let fast = compute(&mesh(1.0, 1.0), &NormalRecipe { precision: Precision::Fast, ..recipe });
            assert!(!fast.summary.fast_declined, "{weight:?}");
            assert_eq!(fast.normals.index, faithful.normals.index);
            let off = faithful.normals.values.iter().zip(&fast.normals.values);
            let worst = off.map(|(a, b)| libm::atan2(a.cross(*b).length(), a.dot(*b))).fold(0.0, f64::max);
            assert!(worst > 0.0 && worst < 3e-5, "{weight:?}: {worst:e}");
        }
    }

    #[test]
    fn normals_are_unit_in_doubles() {
        let recipe = NormalRecipe { precision: Precision::Fast, ..NormalRecipe::default() };
        let field = compute(&mesh(1.0, 1.0), &recipe);
        for normal in field.face_normals.iter().chain(&field.normals.values) {
            // Three roundings of the squared length, one of the factor and one of each component.
            assert!((normal.length() - 1.0).abs() <= 4.0 * f64::EPSILON, "{normal}");
        }
    }

    #[test]
    fn out_of_range_the_faithful_way_is_taken_and_said() {
        for (scale, flatten) in [(1e-9, 1.0), (1e9, 1.0), (1.0, 1e-7)] {
            let mut mesh = mesh(scale, flatten);
            if flatten < 1.0 {
                // Needles: one direction shrunk so far that faces are thinner than a thousandth of their length.
                let thin = mesh.positions().iter().map(|p| p.with_y(p.y * 1e-6)).collect();
                let faces = mesh.faces().clone();
                mesh = MeshBuilder { positions: thin, faces, ..MeshBuilder::default() }.build().unwrap();
            }
            let faithful = compute(&mesh, &NormalRecipe::default());
            let fast =
                compute(&mesh, &NormalRecipe { precision: Precision::Fast, ..NormalRecipe::default() });
            assert!(fast.summary.fast_declined, "{scale:e}");
            assert_eq!(fast.normals, faithful.normals);
        }
    }
}
