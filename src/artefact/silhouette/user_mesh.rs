//! The outline of a user's mesh, compared with that of a finer one or of its own curved triangles.

use super::super::prelude::*;
use super::curved_triangles::curved;
use super::outline::{View, between};
use crate::metric::MetricError;

/// Into how many parts the edges of the cure are cut, which is what a program that draws would do.
const CURE: u32 = 3;
/// Into how many those of a mesh that has to be its own truth, at most, and how many triangles that may make.
const TRUTH: u32 = 8;
const MOST_TRIANGLES: usize = 1 << 21;

pub(super) fn run(own: &UserMesh, parameters: &Parameters, out: Recorder) -> Result<Outcome> {
    measure(own, parameters, out).map_err(|error| match error {
        ArtefactError::Metric(MetricError::Empty) => not_visible(own, parameters.size),
        other => other,
    })
}

fn measure(own: &UserMesh, parameters: &Parameters, mut out: Recorder) -> Result<Outcome> {
    let &Parameters { size, light, crease, .. } = parameters;
    let normalisation = Normalisation::of(own)?;
    let recipe = NormalRecipe { crease: Crease::Angle(crease), ..NormalRecipe::default() };
    let mesh = normalisation.apply(own.mesh)?;
    let finer = own.finer.map(|(_, finer)| normalisation.apply(finer)).transpose()?;
    let field = compute(&mesh, &recipe);
    let of_finer = finer.as_ref().map(|finer| compute(finer, &recipe));
    let object = |mesh, normals| Object::new(Shape::Mesh { mesh, normals }, chalk());
    let parts = parts(&mesh);
    let (patches, patches_of_cure) = (curved(&mesh, &field, parts), curved(&mesh, &field, CURE));
    let truth = match (&finer, &of_finer) {
        (Some(finer), Some(normals)) => object(finer, normals),
        _ => patches.object(chalk()),
    };
    let (coarse, cure) = (object(&mesh, &field), patches_of_cure.object(chalk()));
    let camera = camera(&[truth.clone(), coarse.clone()]);
    let view = View { size, camera, light: light_from(&camera, light)? };
    let outline = |object: &Object| view.outline(object.clone(), Shading::Flat);
    let true_outline = outline(&truth)?;
    let of_coarse = outline(&coarse)?.distance(&true_outline)?;
    let of_cured = outline(&cure)?.distance(&true_outline)?;

    let sharp_edges = field.summary.edges.crease;
    for (name, value) in [
        ("finer", own.finer.map_or("", |(name, _)| name).into()),
        ("compared", if own.finer.is_some() { "finer" } else { "itself" }.into()),
        ("parts", parts.into()),
        ("cure-parts", CURE.into()),
        ("sharp-edges", sharp_edges.into()),
        ("crease", Value::number(crease.0)),
    ] {
        out.set(name, value);
    }
    out.measure("own-distance", "px", of_coarse.hausdorff, Check::None);
    out.measure("own-mean-distance", "px", of_coarse.mean, Check::None);
    out.measure("own-area", "", of_coarse.area_ratio, Check::None);
    out.measure("curved-distance", "px", of_cured.hausdorff, Check::None);
    out.measure("curved-mean-distance", "px", of_cured.mean, Check::None);
    out.measure("shorter-edges", "", (2.0 * of_coarse.hausdorff).sqrt(), Check::None);
    let distances = [of_coarse.hausdorff, of_cured.hausdorff];
    let effect = out.effect("own", "px", distances, Threshold::half_pixel(), 2.0);

    let picture = |object: &Object| view.draw(object.clone(), Shading::Phong);
    let (truth, coarse, cured) = (picture(&truth)?, picture(&coarse)?, picture(&cure)?);
    let between = between(&coarse, &truth);
    out.bad("own", &effect, coarse);
    out.difference("lacking", between, 1.0, "px");
    out.cured("own-curved", &effect, cured);
    out.truth("finer", truth);
    let verdict = match (effect.is_present(), own.finer) {
        (true, _) => Verdict::Holds(out.text("own-holds")),
        (false, Some(_)) => Verdict::Absent(out.text("same-outlines")),
        (false, None) if sharp_edges == 0 => Verdict::Absent(out.text("no-finer-mesh")),
        (false, None) => Verdict::Absent(out.text("no-finer-mesh-sharp-edges")),
    };
    let mut notes = vec![out.text("compared-with")];
    if own.finer.is_some() && effect.is_present() && !effect.is_cured() {
        notes.push(out.text("control-mesh"));
    }
    Ok(out.finish_with_notes(notes, verdict, effect))
}

/// Into how many parts edges are cut: all of them, unless that makes too many triangles.
fn parts(mesh: &Mesh) -> u32 {
    let triangles = mesh.faces().corner_count() - 2 * mesh.face_count();
    let fits = |&parts: &u32| triangles.saturating_mul((parts * parts) as usize) <= MOST_TRIANGLES;
    (CURE + 1..=TRUTH).rev().find(fits).unwrap_or(CURE + 1)
}
