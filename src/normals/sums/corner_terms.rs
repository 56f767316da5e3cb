//! What the corners of one face of any shape add to sums: the scalar path, the same bits as in blocks.

use crate::mesh::{FacesRef, Storage};
use crate::normals::faces::positions::Source;
use crate::normals::faces::shape::{FaceShape, FaceState, face_shape};
use crate::normals::recipe::Weight;
use crate::normals::sums::weight::TriangleMeasures;
use crate::num::{self, Kernel, Lanes, OneLane, Scalars, Vectors};
use glam::DVec3;
use std::f64::consts::TAU;

/// A face's share in sums: corner c adds `vector` · `weights[c]`, where `vector` is n̂ or a multiple of the area vector,
/// followed by its length. So the fourth component of a sum is the sum of weights.
#[derive(Clone, Debug, Default)]
pub(crate) struct CornerTerms {
    /// The face's vector and its length.
    pub(crate) vector: [f64; 4],
    /// The face's unit normal; not set if it has no direction.
    pub(crate) unit: DVec3,
    /// One weight a corner.
    pub(crate) weights: Vec<f64>,
    /// The state of the face.
    pub(crate) state: FaceState,
    points: Vec<DVec3>,
    next: Vec<usize>,
    previous: Vec<usize>,
}

/// Faces smaller or larger than 2^±480 kernel units weigh as if they had that size.
const EXPONENTS: i32 = 480;
/// Squared edges, in units of the face's size, are not taken for smaller than this: 1/x² of an edge must stay finite.
const SMALLEST_SQUARE: f64 = 1e-250;

impl CornerTerms {
    /// The shape of a face.
    pub(crate) fn shape(&mut self, faces: FacesRef, source: &Source, face: usize) -> FaceShape {
        self.points.clear();
        let mut lossy = false;
        self.points.extend(faces.face(face).iter().map(|&vertex| {
            let (point, lost) = source.point(vertex);
            lossy |= lost;
            point
        }));
        num::dispatch(Shape { points: &self.points, storage: source.storage(), lossy })
    }

    /// Fills in what a face adds. A corner at the position of the corner before it adds nothing of its own if `repeats` is true
    /// for it.
    pub(crate) fn fill(
        &mut self,
        faces: FacesRef,
        source: &Source,
        weight: Weight,
        face: usize,
        repeats: impl Fn(usize) -> bool,
    ) {
        let shape = self.shape(faces, source, face);
        self.state = shape.state;
        self.unit = shape.unit;
        self.weights.clear();
        if !shape.state.has_direction() {
            self.vector = [0.0; 4];
            self.weights.resize(self.points.len(), 0.0);
            return;
        }
        let exponent = shape.exponent.clamp(-EXPONENTS, EXPONENTS);
        self.vector = match (weight.has_area_factor(), weight.is_equal_at_corners()) {
            (true, _) => {
                let unit = num::power_of_two(2 * exponent);
                (shape.vector * unit).extend(shape.length * unit).to_array()
            }
            (false, true) => shape.unit.extend(1.0).to_array(),
            (false, false) => shape.vector.extend(shape.length).to_array(),
        };
        if let [p0, p1, p2] = self.points[..] {
            let arch = OneLane::new();
            let edge = |from: DVec3, to: DVec3| {
                let edge = num::scale(to - from, -shape.exponent);
                Vectors::new(arch, edge.to_array().map(|x| [x]))
            };
            let length = Scalars::splat(arch, shape.length);
            let mut measures = TriangleMeasures::new(length, edge(p0, p1), edge(p0, p2), edge(p1, p2));
            let smallest = Scalars::splat(arch, SMALLEST_SQUARE);
            measures.opposite = measures.opposite.map(|square| square.max(smallest));
            self.weights.extend(measures.corner_factors(weight).map(|factor| factor.value[0]));
        } else {
            self.fill_polygon(weight, &shape, repeats);
        }
        if !weight.has_area_factor() && !weight.is_equal_at_corners() {
            let reciprocal = 1.0 / shape.length;
            self.weights.iter_mut().for_each(|weight| *weight *= reciprocal);
        }
        if weight.length_power() != 0 {
            let unit = num::power_of_two(weight.length_power() * exponent);
            self.weights.iter_mut().for_each(|weight| *weight *= unit);
        }
    }

    fn fill_polygon(&mut self, weight: Weight, shape: &FaceShape, repeats: impl Fn(usize) -> bool) {
        self.find_neighbours();
        let Self { points, next, previous, weights, .. } = self;
        let count = points.len();
        for i in 0..count {
            let before = (i + count - 1) % count;
            if points[i] == points[before] && repeats(i) {
                weights.push(0.0);
                continue;
            }
            let edge = |to: usize| num::scale(points[to] - points[i], -shape.exponent);
            let (e1, e2) = (edge(next[i]), edge(previous[i]));
            let cross = num::cross::<num::Split>(e1, e2);
            let [a, b] = [e1, e2].map(|e| num::squared_length(e).max(SMALLEST_SQUARE));
            let sine = num::squared_length(cross).sqrt();
            weights.push(match weight {
                Weight::Uniform | Weight::Area => 1.0,
                Weight::Angle | Weight::AngleArea | Weight::Quadric | Weight::Jet | Weight::Best => {
                    let angle = num::corner_angle(sine, dot(e1, e2));
                    let is_reflex = dot(cross, shape.unit) < 0.0;
                    if is_reflex { TAU - angle } else { angle }
                }
                Weight::Max => sine / (a * b),
                Weight::Edge => 1.0 / (a * b).sqrt(),
            });
        }
    }

    /// The nearest corner on each side that lies elsewhere, in two sweeps. The face has a direction, so that some
    /// corner differs from the one after it.
    fn find_neighbours(&mut self) {
        let Self { points, next, previous, .. } = self;
        let count = points.len();
        let start = (0..count).find(|&i| points[i] != points[(i + 1) % count]).unwrap_or(0);
        next.resize(count, 0);
        previous.resize(count, 0);
        for step in 0..count {
            let i = (start + count - step) % count;
            let after = (i + 1) % count;
            next[i] = if points[i] == points[after] { next[after] } else { after };
            let j = (start + 1 + step) % count;
            let before = (j + count - 1) % count;
            previous[j] = if points[j] == points[before] { previous[before] } else { before };
        }
    }
}

/// a·b, added in the same order everywhere.
#[inline(always)]
fn dot(a: DVec3, b: DVec3) -> f64 {
    (a.x * b.x + a.y * b.y) + a.z * b.z
}

/// A face's shape, computed with the instructions that the CPU has.
struct Shape<'a> {
    points: &'a [DVec3],
    storage: Storage,
    lossy: bool,
}

impl Kernel for Shape<'_> {
    type Output = FaceShape;

    #[inline(always)]
    fn run<A: Lanes>(self, _: A) -> FaceShape {
        face_shape::<A>(self.points, self.storage, self.lossy)
    }
}
