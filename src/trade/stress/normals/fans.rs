//! Vertex normals of fans, three ways, against the same formula in 256 bits.

use crate::mesh::Mesh;
use crate::normals::{
    Crease, NormalField, NormalRecipe, Precision, Scope, Scratch, Slivers, Weight, compute, vertex_normals,
};
use crate::trade::exact;
use crate::trade::stress::case::{Bound, Measured, Unit, Worst};
use crate::trade::stress::normals::naive;
use crate::trade::stress::normals::triangles::{FAST, indexed};
use glam::{DVec3, Vec3};

/// The weights that are weights.
pub(in crate::trade::stress) const WEIGHTS: [Weight; 6] =
    [Weight::Uniform, Weight::Area, Weight::Angle, Weight::AngleArea, Weight::Max, Weight::Edge];

/// The plain formula.
pub(in crate::trade::stress) const FORMULA: &str =
    "sum of w n, made unit; angles by acos(dot), Max's weight over |a|^2 |b|^2";

/// Triangles round a vertex.
#[derive(Clone, Debug)]
pub(in crate::trade::stress) struct Fan {
    /// The vertex.
    pub(in crate::trade::stress) centre: Vec3,
    /// The two other corners of each triangle.
    pub(in crate::trade::stress) triangles: Vec<[Vec3; 2]>,
}

impl Fan {
    /// A closed fan over a ring of points.
    pub(in crate::trade::stress) fn closed(centre: Vec3, ring: &[Vec3]) -> Self {
        let next = ring.iter().cycle().skip(1);
        Self { centre, triangles: ring.iter().zip(next).map(|(&a, &b)| [a, b]).collect() }
    }

    /// The tip of a cone of radius 1 or so: its faces are steeper the higher it is. It is a little askew, by less than its
    /// normals lean, so that no axis is its normal and what sums shrink by stays the same.
    pub(in crate::trade::stress) fn cone(sides: usize, height: f64) -> Self {
        let askew = (0.5 / height).min(0.2);
        let rim = |k: usize| {
            let turn = std::f64::consts::TAU * k as f64 / sides as f64;
            let radius = 1.0 + askew * (libm::sin(turn + 0.5) + libm::sin(2.0 * turn));
            DVec3::new(radius * libm::cos(turn), radius * libm::sin(turn), 0.0).as_vec3()
        };
        Self::closed(DVec3::new(0.0, 0.0, height).as_vec3(), &(0..sides).map(rim).collect::<Vec<_>>())
    }

    /// The same fan with every coordinate times a factor, rounded.
    pub(in crate::trade::stress) fn scaled(&self, factor: f64) -> Self {
        let scale = |v: Vec3| (v.as_dvec3() * factor).as_vec3();
        let triangles = self.triangles.iter().map(|pair| pair.map(scale)).collect();
        Self { centre: scale(self.centre), triangles }
    }

    /// Vertices, the centre first, each triangle with two of its own.
    fn positions(&self) -> Vec<Vec3> {
        std::iter::once(self.centre).chain(self.triangles.iter().flatten().copied()).collect()
    }

    /// Triangles as indices of [`positions`](Self::positions).
    fn indices(&self) -> Vec<[u32; 3]> {
        (0..self.triangles.len() as u32).map(|i| [0, 2 * i + 1, 2 * i + 2]).collect()
    }

    /// What the sum of unit normals shrinks to: Σ|n̂| / |Σ n̂|.
    fn condition(&self) -> f64 {
        let normal = |&[a, b]: &[Vec3; 2]| {
            let [e1, e2] = [a, b].map(|p| p.as_dvec3() - self.centre.as_dvec3());
            e1.cross(e2).normalize_or_zero()
        };
        self.triangles.len() as f64 / self.triangles.iter().map(normal).sum::<DVec3>().length()
    }
}

/// What a vertex normal of a fan is held to: the rounding of its components to `f32`, √3·2⁻²⁵ rad, and
/// κ(v + 30)·2⁻⁵³ for v rounded terms and sums that shrink by κ, as they do for this fan.
pub(in crate::trade::stress) fn bound(fan: &Fan, valence: usize) -> Bound {
    let terms = (valence + 30) as f64;
    let radians = libm::ldexp(3.0_f64.sqrt(), -25) + libm::ldexp(fan.condition() * terms, -53);
    Bound::new(
        radians.to_degrees(),
        Unit::Degrees,
        "rounding to f32, sqrt(3)/2^25 rad, and k(v + 30)/2^53 of summation over v faces that shrinks by k",
    )
}

/// What `fast` is held to: its faces, and its sums in single precision.
pub(in crate::trade::stress) fn fast_bound(fan: &Fan, valence: usize) -> Bound {
    let summed = libm::ldexp(fan.condition() * (valence + 30) as f64, -24).to_degrees();
    Bound::new(
        (FAST.most + summed).min(180.0),
        Unit::Degrees,
        "that of its faces, 0.0172 degrees, and k(v + 30)/2^24 of summation over v faces that shrinks by k",
    )
}

/// The normal at the centre of each fan, by each weight.
pub(in crate::trade::stress) fn measure(fans: &[Fan], weights: &[Weight]) -> Measured {
    let mut measured = Measured { samples: fans.len() * weights.len(), ..Measured::default() };
    let (mut fast, mut plain) = (Worst::default(), Worst::default());
    for fan in fans {
        let centre = fan.centre.as_dvec3();
        let triangles: Vec<[DVec3; 2]> =
            fan.triangles.iter().map(|pair| pair.map(|p| p.as_dvec3())).collect();
        let (positions, indices) = (fan.positions(), fan.indices());
        let mesh = indexed(&positions, &indices);
        for &weight in weights {
            let truth = exact::vertex_normal(centre, &triangles, weight).expect("a fan with a normal");
            let error = |normal: DVec3| exact::angle_to(normal, &truth).to_degrees();
            measured.faithful.add(error(faithful(&positions, &indices, weight, Slivers::Keep)[0]));
            let field = self::fast(&mesh, weight, Slivers::Keep);
            measured.declined += usize::from(field.summary.fast_declined);
            fast.add(error(field.normals.values[0]));
            plain.add(error(naive::direction(naive::vertex_normal(fan.centre, &fan.triangles, weight))));
        }
    }
    Measured { fast: Some(fast), plain: Some(plain), ..measured }
}

/// Vertex normals by [`Precision::Fast`].
pub(in crate::trade::stress) fn fast(mesh: &Mesh, weight: Weight, slivers: Slivers) -> NormalField {
    let recipe = NormalRecipe {
        weight,
        crease: Crease::OFF,
        slivers,
        precision: Precision::Fast,
        scope: Scope::Vertex,
        ..NormalRecipe::default()
    };
    compute(mesh, &recipe)
}

/// Vertex normals by the interface for slices.
pub(in crate::trade::stress) fn faithful(
    positions: &[Vec3],
    triangles: &[[u32; 3]],
    weight: Weight,
    slivers: Slivers,
) -> Vec<DVec3> {
    let positions: Vec<[f32; 3]> = positions.iter().map(Vec3::to_array).collect();
    let mut normals = vec![[0.0; 3]; positions.len()];
    vertex_normals(&positions, triangles, weight, slivers, &mut Scratch::new(), &mut normals)
        .expect("slices that go together");
    normals.into_iter().map(|normal| Vec3::from(normal).as_dvec3()).collect()
}
