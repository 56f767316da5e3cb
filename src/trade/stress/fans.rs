//! Vertex normals of fans, by three methods, against the same formula in 256 bits.

use super::face_normals::{FAST, indexed};
use super::prelude::*;
use crate::normals::{Averaging, Scope, vertex_normals};
use crate::trade::exact;

/// All weights that sum faces.
pub(super) const WEIGHTS: [Weight; 6] =
    [Weight::Uniform, Weight::Area, Weight::Angle, Weight::AngleArea, Weight::Max, Weight::Edge];

#[derive(Clone, Debug)]
pub(super) struct Fan {
    pub(super) centre: Vec3,
    /// The two other corners of each triangle.
    pub(super) triangles: Vec<[Vec3; 2]>,
}

impl Fan {
    /// A closed fan over a ring of points.
    pub(super) fn closed(centre: Vec3, ring: &[Vec3]) -> Self {
        let next = ring.iter().cycle().skip(1);
        Self { centre, triangles: ring.iter().zip(next).map(|(&a, &b)| [a, b]).collect() }
    }

    /// The tip of a cone of radius 1 or so: the higher, the steeper its faces. It is a little tilted, by less than its
    /// normals lean, so that no axis is its normal and its condition number stays the same.
    pub(super) fn cone(sides: usize, height: f64) -> Self {
        let tilt = (0.5 / height).min(0.2);
        let rim = |k: usize| {
            let turn = TAU * k as f64 / sides as f64;
            let radius = 1.0 + tilt * (libm::sin(turn + 0.5) + libm::sin(2.0 * turn));
            DVec3::new(radius * libm::cos(turn), radius * libm::sin(turn), 0.0).as_vec3()
        };
        Self::closed(DVec3::new(0.0, 0.0, height).as_vec3(), &(0..sides).map(rim).collect::<Vec<_>>())
    }

    /// The same fan with every coordinate times a factor, rounded.
    pub(super) fn scaled(&self, factor: f64) -> Self {
        let scale = |v: Vec3| (v.as_dvec3() * factor).as_vec3();
        let triangles = self.triangles.iter().map(|pair| pair.map(scale)).collect();
        Self { centre: scale(self.centre), triangles }
    }

    /// Vertices, the centre first, two for each triangle.
    pub(super) fn positions(&self) -> Vec<Vec3> {
        std::iter::once(self.centre).chain(self.triangles.iter().flatten().copied()).collect()
    }

    pub(super) fn indices(&self) -> Vec<[u32; 3]> {
        (0..self.triangles.len() as u32).map(|i| [0, 2 * i + 1, 2 * i + 2]).collect()
    }

    /// The normal at the centre, from all triangles, in 256 bits.
    pub(super) fn true_normal(&self, weight: Weight) -> exact::Vector {
        let triangles: Vec<[DVec3; 2]> =
            self.triangles.iter().map(|pair| pair.map(|p| p.as_dvec3())).collect();
        exact::vertex_normal(self.centre.as_dvec3(), &triangles, weight).expect("a fan with a normal")
    }

    /// The condition number of the sum of unit normals: Σ|n̂| / |Σ n̂|.
    fn condition(&self) -> f64 {
        let normal = |&[a, b]: &[Vec3; 2]| {
            let [e1, e2] = [a, b].map(|p| p.as_dvec3() - self.centre.as_dvec3());
            e1.cross(e2).normalize_or_zero()
        };
        self.triangles.len() as f64 / self.triangles.iter().map(normal).sum::<DVec3>().length()
    }

    /// The bounds of `faithful` and `fast` for v faces and the condition number κ of this fan. `faithful`: the rounding of
    /// components to `f32`, √3·2⁻²⁵ rad, and κ(v + 30)·2⁻⁵³ of v rounded terms. `fast`: its faces, and sums in single precision.
    pub(super) fn bounds(&self, valence: usize) -> (Bound, Option<Bound>) {
        let terms = self.condition() * (valence + 30) as f64;
        let radians = libm::ldexp(3.0_f64.sqrt(), -25) + libm::ldexp(terms, -53);
        let fast = (FAST.most + libm::ldexp(terms, -24).to_degrees()).min(180.0);
        let faithful = Bound::new(radians.to_degrees(), Unit::Degrees, "fan-bound");
        (faithful, Some(Bound::new(fast, Unit::Degrees, "fan-fast")))
    }
}

/// A case about the normals at the centres of some fans, by six weights.
pub(super) fn case(group: Group, texts: &'static str, name: impl Into<String>, fans: Vec<Fan>) -> StressCase {
    // Both bounds grow with the condition number.
    let bounds = fans.iter().map(|fan| fan.bounds(fan.triangles.len()));
    let widest = bounds.max_by(|(a, _), (b, _)| a.most.total_cmp(&b.most)).expect("at least one fan");
    StressCase::new(group, texts, name, widest, move || measure(&fans, &WEIGHTS))
}

/// The errors of the normal at the centre of each fan, by each weight.
pub(super) fn measure(fans: &[Fan], weights: &[Weight]) -> Measured {
    let mut declined = 0;
    let of_fan = |fan: &Fan| {
        let (positions, indices) = (fan.positions(), fan.indices());
        let mesh = indexed(&positions, &indices);
        let of_weight = |&weight: &Weight| {
            let truth = fan.true_normal(weight);
            let faithful = faithful(&positions, &indices, weight, Slivers::Keep)[0];
            let fast = fast(&mesh, weight, Slivers::Keep);
            declined += usize::from(fast.summary.fast_declined);
            let plain = plain::vertex_normal(fan.centre, &fan.triangles, weight).as_dvec3();
            [faithful, fast.normals.values[0], plain].map(|normal| Outcome::degrees(normal, &truth))
        };
        weights.iter().map(of_weight).collect::<Vec<_>>()
    };
    let outcomes: Vec<[Outcome; 3]> = fans.iter().flat_map(of_fan).collect();
    Measured { declined, ..Measured::triples(outcomes) }
}

pub(super) fn fast(mesh: &Mesh, weight: Weight, slivers: Slivers) -> NormalField {
    compute(mesh, &NormalRecipe { slivers, ..recipe(weight, Precision::Fast) })
}

pub(super) fn recipe(weight: Weight, precision: Precision) -> NormalRecipe {
    NormalRecipe { weight, crease: Crease::OFF, precision, scope: Scope::Vertex, ..NormalRecipe::default() }
}

/// Vertex normals through the slice interface.
pub(super) fn faithful(
    positions: &[Vec3],
    triangles: &[[u32; 3]],
    weight: Weight,
    slivers: Slivers,
) -> Vec<DVec3> {
    let positions: Vec<[f32; 3]> = positions.iter().map(Vec3::to_array).collect();
    let mut normals = vec![[0.0; 3]; positions.len()];
    vertex_normals(
        &positions,
        triangles,
        Averaging { weight, slivers, ..Averaging::default() },
        &mut Scratch::new(),
        &mut normals,
    )
    .expect("slices of matching lengths");
    normals.into_iter().map(|normal| Vec3::from(normal).as_dvec3()).collect()
}
