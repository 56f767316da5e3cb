//! Normals that replace the unknown true ones of a user mesh, and the estimate of their error.

use super::angles::angle_between;
use super::cases::boundary_vertices;
use crate::mesh::{Mesh, Topology, stored_unit};
use crate::normals::{FitDifferences, NormalField, NormalRecipe, Weight, compute_on, compute_wider};
use crate::num::{AngleErrors, Radians};
use glam::DVec3;
use serde::Serialize;

/// The normals that errors are measured from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Reference {
    /// Those that the mesh stores, taken for the true ones.
    Stored,
    /// Those of [`Weight::Jet`]: third order on surfaces without noise.
    Jet,
    /// Those of [`Weight::Quadric`], which averages noise.
    Quadric,
}

impl Reference {
    /// The weight whose normals it is.
    pub fn weight(self) -> Option<Weight> {
        match self {
            Reference::Stored => None,
            Reference::Jet => Some(Weight::Jet),
            Reference::Quadric => Some(Weight::Quadric),
        }
    }
}

impl Reference {
    /// The better of jet and quadric, and its estimated error.
    pub(super) fn of(fits: &FitDifferences) -> (Self, f64) {
        let (jet, quadric) = (fits.jet_error(), fits.quadric_error());
        if jet <= quadric { (Reference::Jet, jet) } else { (Reference::Quadric, quadric) }
    }
}

/// A part of a user mesh with its normals by some weights, one of them [`Weight::Angle`].
pub(super) struct MeasuredPart<'a> {
    mesh: &'a Mesh,
    topology: Topology,
    /// Groups do not depend on the weight, so the same entry is the same corners in each field.
    fields: Vec<(Weight, NormalField)>,
}

impl<'a> MeasuredPart<'a> {
    /// Computes the normals; `step` is called before each weight.
    pub(super) fn new(mesh: &'a Mesh, recipe: &NormalRecipe, weights: &[Weight], step: impl Fn()) -> Self {
        let topology = Topology::build(mesh, recipe.weld);
        let field = |&weight: &Weight| {
            step();
            (weight, compute_on(mesh, &topology, &NormalRecipe { weight, ..*recipe }))
        };
        let fields = weights.iter().map(field).collect();
        Self { mesh, topology, fields }
    }

    fn field(&self, weight: Weight) -> &NormalField {
        let found = self.fields.iter().find(|(own, _)| *own == weight);
        &found.expect("the normals of this weight were computed").1
    }

    pub(super) fn normals(&self, weight: Weight) -> &[DVec3] {
        &self.field(weight).normals.values
    }

    /// The normals that a reference has, with their entries. Vertices on open boundaries have none, as half of their faces are
    /// missing; nor have entries without a fit, whose normal is the angle mean to the last bit.
    pub(super) fn reference(&self, reference: Reference) -> Vec<(u32, DVec3)> {
        let field = self.field(Weight::Angle);
        let on_boundary = boundary_vertices(self.mesh, &self.topology);
        let is_inside = |entry: u32| !on_boundary[field.entry_vertex[entry as usize] as usize];
        let Some(fit) = reference.weight() else { return self.stored(field, is_inside) };
        let fit = self.normals(fit);
        let pairs = (0_u32..).zip(fit.iter().zip(&field.normals.values));
        let fitted = pairs.filter(|&(entry, (fit, mean))| fit != mean && is_inside(entry));
        fitted.map(|(entry, (&fit, _))| (entry, fit)).collect()
    }

    /// Each stored normal of each entry once.
    fn stored(&self, field: &NormalField, is_inside: impl Fn(u32) -> bool) -> Vec<(u32, DVec3)> {
        let Some(column) = &self.mesh.columns().normals else { return Vec::new() };
        let corners = self.mesh.faces().corners().iter().enumerate();
        let pair = |(corner, &vertex): (usize, &u32)| {
            let entry = field.normals.slot(corner, vertex).filter(|&entry| is_inside(entry))?;
            Some((entry, column.slot(corner, vertex)?, stored_unit(column, self.mesh, corner)?))
        };
        let mut pairs: Vec<(u32, u32, DVec3)> = corners.filter_map(pair).collect();
        pairs.sort_unstable_by_key(|&(entry, slot, _)| (entry, slot));
        pairs.dedup_by_key(|&mut (entry, slot, _)| (entry, slot));
        pairs.into_iter().map(|(entry, _, normal)| (entry, normal)).collect()
    }

    /// The angles of a weight's normals to those of a reference.
    pub(super) fn angles(&self, weight: Weight, reference: &[(u32, DVec3)]) -> Vec<Radians> {
        let normals = self.normals(weight);
        reference.iter().map(|&(entry, truth)| angle_between(normals[entry as usize], truth)).collect()
    }
}

/// How much fits differ, over the parts of a mesh, and at how many normals that is known: not where a wider fit has no normal,
/// because it reaches a fold.
pub(super) fn fit_differences(parts: &[MeasuredPart], recipe: &NormalRecipe) -> (FitDifferences, usize) {
    let mut angles = [const { Vec::new() }; 3];
    for part in parts {
        let wider = [Weight::Jet, Weight::Quadric].map(|weight| {
            let recipe = NormalRecipe { weight, ..*recipe };
            compute_wider(part.mesh, &part.topology, &recipe).normals.values
        });
        let [quadrics, means] = [Weight::Quadric, Weight::Angle].map(|weight| part.normals(weight));
        for (entry, jet) in part.reference(Reference::Jet) {
            let entry = entry as usize;
            let [wider_jet, wider_quadric] = [wider[0][entry], wider[1][entry]];
            if wider_jet == means[entry] || wider_quadric == means[entry] {
                continue;
            }
            angles[0].push(angle_between(jet, wider_jet));
            angles[1].push(angle_between(quadrics[entry], wider_quadric));
            angles[2].push(angle_between(jet, quadrics[entry]));
        }
    }
    let known = angles[0].len();
    let [jet, quadric, jet_to_quadric] = angles.map(|angles| AngleErrors::of(&angles).rms);
    (FitDifferences { jet, quadric, jet_to_quadric }, known)
}

/// The normals of some weights on a mesh, and for each the largest angle to the reference at every vertex that has one. For
/// pictures.
pub fn error_maps(
    mesh: &Mesh,
    recipe: &NormalRecipe,
    reference: Reference,
    weights: &[Weight],
) -> Vec<(NormalField, Vec<Option<Radians>>)> {
    let needed = Weight::ALL.into_iter().filter(|weight| {
        weights.contains(weight) || matches!(weight, Weight::Angle | Weight::Jet | Weight::Quadric)
    });
    let part = MeasuredPart::new(mesh, recipe, &needed.collect::<Vec<_>>(), || ());
    let truth = part.reference(reference);
    let map = |&weight: &Weight| {
        let field = part.field(weight).clone();
        let mut largest: Vec<Option<Radians>> = vec![None; mesh.vertex_count()];
        for (&(entry, _), angle) in truth.iter().zip(part.angles(weight, &truth)) {
            let known = &mut largest[field.entry_vertex[entry as usize] as usize];
            *known = Some(known.map_or(angle, |known| Radians(known.0.max(angle.0))));
        }
        (field, largest)
    };
    weights.iter().map(map).collect()
}
