//! The quick end of the trade: everything in `f32`, on positions rounded to `f32`.
//!
//! Within its range a face normal is off by at most 3e-7 rad times length over height, so 3e-4 rad (0.017°) for the
//! thinnest face allowed; a mean whose sum shrinks by k, by no more than k times that of its worst face, where k is near 1 on
//! smooth surfaces and up to 1000 at steep tips. Whatever lies outside the range is left to
//! the faithful way: [`Single`] then declines.

use super::groups::Members;
use super::sums::{SlotState, Sums};
use super::{FaceNormals, FaceState, Weight};
use crate::mesh::{FacesRef, Topology};
use glam::{DVec3, Vec3};

/// Shortest and longest edge, in units of the caller.
const EDGES: std::ops::RangeInclusive<f32> = 1e-6..=1e6;
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
    normals: Vec<Vec3>,
    /// Twice the area of each face.
    areas: Vec<f32>,
}

impl<'a> Single<'a> {
    /// Rounds positions and computes face normals; `None` if anything is out of range.
    pub(crate) fn new(faces: FacesRef<'a>, positions: &[DVec3]) -> Option<Self> {
        let positions: Vec<Vec3> = positions.iter().map(|p| p.as_vec3()).collect();
        let (mut normals, mut areas) = (Vec::with_capacity(faces.len()), Vec::with_capacity(faces.len()));
        for face in 0..faces.len() {
            let corners = faces.face(face);
            let points = || corners.iter().map(|&v| positions[v as usize]);
            let origin = positions[corners[0] as usize];
            // Twice the area vector, relative to the first corner.
            let fan = corners[1..].windows(2).map(|pair| {
                let [a, b] = [0, 1].map(|i| positions[pair[i] as usize] - origin);
                a.cross(b)
            });
            let vector: Vec3 = fan.sum();
            let area = vector.length();
            let edges = points().zip(points().cycle().skip(1)).map(|(a, b)| a.distance(b));
            let (shortest, longest) =
                edges.fold((f32::INFINITY, 0.0f32), |(low, high), edge| (low.min(edge), high.max(edge)));
            let largest = points().map(|p| p.abs().max_element()).fold(0.0, f32::max);
            let height = area / longest;
            let in_range = EDGES.contains(&shortest)
                && EDGES.contains(&longest)
                && height >= LEAST_HEIGHT * longest
                && height >= LEAST_RELATIVE_HEIGHT * largest;
            if !in_range {
                return None;
            }
            normals.push(vector / area);
            areas.push(area);
        }
        Some(Self { faces, positions, normals, areas })
    }

    /// The face normals, as the rest of the way wants them.
    pub(crate) fn face_normals(&self) -> FaceNormals {
        FaceNormals {
            unit: self.normals.iter().map(|normal| normal.as_dvec3().normalize()).collect(),
            state: vec![FaceState::Counted; self.normals.len()],
        }
    }

    /// The weight of one corner of a face.
    fn weight(&self, weight: Weight, face: usize, corner: usize) -> f32 {
        let corners = self.faces.face(face);
        let count = corners.len();
        let at = |i: usize| self.positions[corners[i % count] as usize];
        let (e1, e2) = (at(corner + 1) - at(corner), at(corner + count - 1) - at(corner));
        let cross = e1.cross(e2);
        let angle = || {
            let angle = libm::atan2f(cross.length(), e1.dot(e2));
            if cross.dot(self.normals[face]) < 0.0 { std::f32::consts::TAU - angle } else { angle }
        };
        match weight {
            Weight::Uniform => 1.0,
            Weight::Area => self.areas[face],
            Weight::Angle | Weight::Quadric => angle(),
            Weight::AngleArea => angle() * self.areas[face],
            Weight::Max => cross.length() / e1.length_squared() / e2.length_squared(),
            Weight::Edge => 1.0 / (e1.length() * e2.length()),
        }
    }

    /// Sums over slots, in ascending face index; `None` if a sum is out of range.
    pub(crate) fn sums(
        &self,
        weight: Weight,
        target: &[u32],
        slots: usize,
        members: Option<&Members>,
        topology: &Topology,
    ) -> Option<Sums> {
        let mut totals = vec![(Vec3::ZERO, 0.0f32, 0u32); slots];
        let mut add = |slot: u32, face: usize, weight: f32| {
            let (sum, weights, count) = &mut totals[slot as usize];
            *sum += self.normals[face] * weight;
            *weights += weight;
            *count += 1;
        };
        match members {
            None => {
                for face in 0..self.faces.len() {
                    for (i, corner) in self.faces.range(face).enumerate() {
                        add(target[corner], face, self.weight(weight, face, i));
                    }
                }
            }
            Some(members) => {
                for slot in 0..slots as u32 {
                    for &corner in members.row(slot) {
                        let face = topology.face_of(corner) as usize;
                        let weight = self.weight(weight, face, corner as usize - self.faces.start(face));
                        add(slot, face, weight);
                    }
                }
            }
        }
        let mut sums = Sums { unit: Vec::with_capacity(slots), state: Vec::with_capacity(slots) };
        for (sum, weights, count) in totals {
            if count == 0 {
                // A slot that stands for no group of its own.
                sums.unit.push(DVec3::Z);
                sums.state.push(SlotState::Good);
                continue;
            }
            let length = sum.length();
            let in_range = count <= MOST_FACES && weights.is_normal() && length >= LEAST_SUM * weights;
            if !in_range {
                return None;
            }
            sums.unit.push((sum / length).as_dvec3().normalize());
            sums.state.push(SlotState::Good);
        }
        Some(sums)
    }
}

#[cfg(test)]
mod tests {
    use crate::mesh::{Faces, Mesh, MeshBuilder};
    use crate::normals::test_meshes::bumpy;
    use crate::normals::{NormalRecipe, Precision, Weight, compute};
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
