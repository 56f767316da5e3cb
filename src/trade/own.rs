//! All weights on a user mesh: their errors, costs and a recommendation.

use super::angles::{AngleErrors, Histogram, angle_between};
use super::cost::{CostRow, Costs, Way};
use super::effort::{Observer, Progress};
use super::reference::{MeasuredPart, Reference, fit_differences};
use crate::mesh::Mesh;
use crate::normals::{FitDifferences, NormalRecipe, Weight};
use crate::num::{Degrees, Radians};
use glam::DVec3;
use serde::Serialize;
use std::cell::Cell;

/// Where the true normals of a user mesh come from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Truth {
    /// They are unknown. A fit replaces them, whose own error is estimated.
    #[default]
    Estimated,
    /// The mesh stores them.
    Stored,
}

/// The errors and costs of all weights on a user mesh.
///
/// Unless the mesh stores its true normals, errors are angles to a [`Reference`]: jets, or quadrics if the mesh is noisy. The
/// error of the reference is estimated by fits to wider neighbourhoods. A weighting is recommended only if that error
/// leaves it among the most accurate sums of faces, up to 10 %.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct OwnMesh {
    /// Vertices of all parts.
    pub vertices: usize,
    /// Faces of all parts.
    pub faces: usize,
    /// Normals: one for each vertex and smooth group.
    pub normals: usize,
    /// The share of normals that are the same, within 10⁻⁵ degrees, with every weight.
    pub alike: f64,
    /// What errors are measured from.
    pub reference: Reference,
    /// The estimated rms error of the reference in degrees; 0 for stored normals.
    pub reference_error: f64,
    /// How much fits differ; 0 for stored normals.
    pub fits: FitDifferences,
    /// Normals that are compared: those that the reference has away from open boundaries.
    pub estimated_from: usize,
    /// Of these, normals at which the error of the reference is estimated: all for stored normals.
    pub error_from: usize,
    /// One for each of [`Weight::ALL`].
    pub methods: Vec<OwnMethod>,
    /// Triangles that costs are taken on: those of the largest part.
    pub timed_triangles: usize,
    /// Nanoseconds a triangle of the plain loop.
    pub plain_ns: f64,
    /// The sum of faces to use; `None` if it cannot be determined.
    pub recommended: Option<Weight>,
    /// The sums of faces that may be the most accurate.
    pub candidates: Vec<Weight>,
    /// Why.
    pub reasons: Vec<String>,
}

/// One weight on the mesh.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct OwnMethod {
    /// The weight.
    pub weight: Weight,
    /// The angle to the reference.
    pub estimate: AngleErrors,
    /// How these angles are spread.
    pub histogram: Histogram,
    /// The rms angle in degrees to the angle mean, over all normals.
    pub to_angle: f64,
    /// Nanoseconds a triangle, on one thread, creases off.
    pub ns_per_triangle: f64,
    /// Times the plain loop.
    pub ratio: f64,
}

/// Normals count as equal below this angle, in degrees: single precision is a hundred times coarser.
pub(super) const ALIKE: f64 = 1e-5;

impl OwnMesh {
    /// Measures all weights on the parts of a mesh, with the recipe's creases and groups.
    pub fn measure(parts: &[&Mesh], recipe: &NormalRecipe, truth: Truth, observe: Observer) -> Self {
        observe(Progress { stage: "cost", done: 0, total: 1 });
        let costs = costs(parts);
        observe(Progress { stage: "cost", done: 1, total: 1 });
        Self::of_weights(&Weight::ALL, parts, recipe, truth, &costs, observe)
    }

    /// As [`measure`](Self::measure), for some weights, at least the sums and the references, with costs that were taken before.
    pub(super) fn of_weights(
        weights: &[Weight],
        parts: &[&Mesh],
        recipe: &NormalRecipe,
        truth: Truth,
        costs: &Costs,
        observe: Observer,
    ) -> Self {
        let (done, total) = (Cell::new(0), weights.len() * parts.len() + 1);
        let step = |stage| {
            observe(Progress { stage, done: done.get(), total });
            done.set(done.get() + 1);
        };
        let measured: Vec<MeasuredPart> =
            parts.iter().map(|&mesh| MeasuredPart::new(mesh, recipe, weights, || step("normals"))).collect();
        step("reference");
        let (fits, known) = match truth {
            Truth::Estimated => fit_differences(&measured, recipe),
            Truth::Stored => (FitDifferences::default(), usize::MAX),
        };
        let (reference, reference_error) =
            if truth == Truth::Stored { (Reference::Stored, 0.0) } else { Reference::of(&fits) };
        let references: Vec<_> = measured.iter().map(|part| part.reference(reference)).collect();
        observe(Progress { stage: "reference", done: total, total });
        let method = |weight: Weight| {
            let angles: Vec<Radians> = measured
                .iter()
                .zip(&references)
                .flat_map(|(part, reference)| part.angles(weight, reference))
                .collect();
            let to_angle: Vec<Radians> =
                measured.iter().flat_map(|part| between(part, weight, Weight::Angle)).collect();
            let cost = |of: fn(&CostRow) -> f64| costs.row(Way::Mesh, weight).map_or(0.0, of);
            OwnMethod {
                weight,
                estimate: AngleErrors::of(&angles),
                histogram: Histogram::of(&angles),
                to_angle: AngleErrors::of(&to_angle).rms,
                ns_per_triangle: cost(|row| row.ns_per_triangle),
                ratio: cost(|row| row.ratio),
            }
        };
        let estimated_from: usize = references.iter().map(Vec::len).sum();
        let normals: usize = measured.iter().map(|part| part.normals(Weight::Angle).len()).sum();
        let alike: usize = measured.iter().map(|part| count_alike(part, weights)).sum();
        let mut own = Self {
            vertices: parts.iter().map(|mesh| mesh.vertex_count()).sum(),
            faces: parts.iter().map(|mesh| mesh.face_count()).sum(),
            normals,
            alike: if normals == 0 { 1.0 } else { alike as f64 / normals as f64 },
            reference,
            reference_error,
            fits,
            estimated_from,
            error_from: known.min(estimated_from),
            methods: weights.iter().copied().map(method).collect(),
            timed_triangles: costs.triangles,
            plain_ns: costs.plain_ns,
            recommended: None,
            candidates: Vec::new(),
            reasons: Vec::new(),
        };
        own.recommend();
        own
    }

    /// The row of a weight.
    pub(super) fn method(&self, weight: Weight) -> &OwnMethod {
        &self.methods[weight as usize]
    }
}

/// Costs on the largest part; large meshes are timed once, small ones several times.
fn costs(parts: &[&Mesh]) -> Costs {
    let largest = parts.iter().max_by_key(|mesh| mesh.face_count());
    let Some(mesh) = largest.filter(|mesh| mesh.face_count() > 0) else { return Costs::default() };
    Costs::on(mesh, &[Way::Mesh], if mesh.face_count() > 100_000 { 1 } else { 3 })
}

fn between<'a>(part: &'a MeasuredPart, a: Weight, b: Weight) -> impl Iterator<Item = Radians> + 'a {
    part.normals(a).iter().zip(part.normals(b)).map(|(&a, &b): (&DVec3, &DVec3)| angle_between(a, b))
}

/// The number of normals that are the same with every one of some weights.
fn count_alike(part: &MeasuredPart, weights: &[Weight]) -> usize {
    let mut is_alike = vec![true; part.normals(Weight::Angle).len()];
    for &weight in weights {
        for (is_alike, angle) in is_alike.iter_mut().zip(between(part, weight, Weight::Angle)) {
            *is_alike &= Degrees::from(angle) < Degrees(ALIKE);
        }
    }
    is_alike.into_iter().filter(|&it| it).count()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Faces, MeshBuilder};
    use crate::normals::Crease;
    use crate::surface::{Cylinder, Sphere, Surface, Tessellation, Torus};

    fn measured(mesh: &Mesh, truth: Truth) -> OwnMesh {
        let recipe = NormalRecipe { crease: Crease::OFF, ..NormalRecipe::default() };
        OwnMesh::of_weights(&Weight::ALL, &[mesh], &recipe, truth, &Costs::default(), &|_| ())
    }

    fn torus(segments: [u32; 2], noise: f64) -> Mesh {
        let tessellation = Tessellation { jitter: 0.5, segments, noise, ..Tessellation::default() };
        Surface::from(Torus::default()).tessellate(&tessellation).unwrap()
    }

    /// Estimates are as far from the true errors as the reference itself is from the truth, at the most: the triangle
    /// inequality of root mean squares.
    #[test]
    fn estimates_are_close_to_true_errors() {
        let mesh = torus([64, 32], 0.0);
        let [own, true_errors] = [Truth::Estimated, Truth::Stored].map(|truth| measured(&mesh, truth));
        assert_eq!(
            (own.reference, own.recommended),
            (Reference::Jet, Some(Weight::Max)),
            "{:?}",
            own.reasons
        );
        assert_eq!(true_errors.recommended, Some(Weight::Max));
        let of_jet = true_errors.method(Weight::Jet).estimate.rms;
        assert!((0.5..2.0).contains(&(own.reference_error / of_jet)), "{} {of_jet}", own.reference_error);
        for weight in Weight::SUMS {
            let [estimate, error] = [&own, &true_errors].map(|it| it.method(weight).estimate.rms);
            assert!((estimate - error).abs() <= of_jet, "{}: {estimate} {error}", weight.name());
        }
        assert!(
            own.reasons.iter().any(|it| it.contains("the cost of the plain loop: jet")),
            "{:?}",
            own.reasons
        );
    }

    #[test]
    fn noise_makes_the_quadric_the_reference() {
        let own = measured(&torus([64, 32], 0.05), Truth::Estimated);
        assert_eq!(own.reference, Reference::Quadric, "{:?}", own.fits);
        assert!(own.reasons.iter().any(|it| it.contains("the vertices are noisy")), "{:?}", own.reasons);
    }

    /// Against quadrics the exact weight of a sphere had an error of 0.233°.
    #[test]
    fn stored_normals_are_the_truth() {
        let tessellation = Tessellation { segments: [16, 16], ..Tessellation::default() };
        let mesh = Surface::from(Sphere::default()).tessellate(&tessellation).unwrap();
        let own = measured(&mesh, Truth::Stored);
        assert_eq!((own.reference, own.recommended), (Reference::Stored, Some(Weight::Max)));
        assert_eq!(own.estimated_from, own.normals);
        assert!(own.method(Weight::Max).estimate.max < 1e-12 && own.method(Weight::Jet).estimate.rms > 0.01);
    }

    /// Fits through two rings of rounded points are anything: one was taken for the truth once, and all weights for 90° off it.
    #[test]
    fn two_rings_are_too_few() {
        let tessellation = Tessellation { segments: [48, 1], ..Tessellation::default() };
        let mesh = Surface::from(Cylinder::default()).tessellate(&tessellation).unwrap();
        let rotation = glam::DQuat::from_xyzw(0.1, 0.7, -0.3, 0.5).normalize();
        let positions = mesh.positions().iter().map(|p| (rotation * p).as_vec3().as_dvec3()).collect();
        let faces = mesh.faces().clone();
        let mesh = MeshBuilder { positions, faces, ..MeshBuilder::default() }.build().unwrap();
        let own = measured(&mesh, Truth::Estimated);
        assert_eq!((own.recommended, own.estimated_from), (None, 0));
        assert!(
            own.reasons.iter().any(|reason| reason.starts_with("Only 0 of 96 normals")),
            "{:?}",
            own.reasons
        );
    }

    #[test]
    fn every_weighting_is_right_on_a_box() {
        let positions = [0.0, 1.0].into_iter().flat_map(|x| [0.0, 2.0].map(|y| (x, y)));
        let positions = positions.flat_map(|(x, y)| [0.0, 3.0].map(|z| DVec3::new(x, y, z))).collect();
        let quads = [0, 1, 3, 2, 4, 6, 7, 5, 0, 4, 5, 1, 2, 3, 7, 6, 0, 2, 6, 4, 1, 5, 7, 3];
        let faces = Faces::polygons(quads.to_vec(), (0..=6).map(|k| 4 * k).collect());
        let mesh = MeshBuilder { positions, faces, ..MeshBuilder::default() }.build().unwrap();
        let own = OwnMesh::measure(&[&mesh], &NormalRecipe::default(), Truth::Estimated, &|_| ());
        assert_eq!((own.recommended, own.alike, own.normals), (Some(Weight::Angle), 1.0, 24));
        assert!(own.reasons.iter().any(|reason| reason.starts_with("Costs were measured on 12 triangles")));
        let nothing = OwnMesh::measure(&[], &NormalRecipe::default(), Truth::Stored, &|_| ());
        assert_eq!((nothing.recommended, nothing.normals), (Some(Weight::Angle), 0));
    }
}
