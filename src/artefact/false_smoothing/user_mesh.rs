//! A user's mesh, averaged over all edges and split at creases.

use super::super::prelude::*;
use super::lit_mesh::LitMesh;

pub(super) fn run(own: &UserMesh, parameters: &Parameters, mut out: Recorder) -> Result<Outcome> {
    let &Parameters { size, light, weight, crease, .. } = parameters;
    let mesh = LitMesh::from_corner(Normalisation::of(own)?.apply(own.mesh)?, light, size)?;
    let (smooth, sharp) = (mesh.render(weight, Crease::OFF)?, mesh.render(weight, Crease::Angle(crease))?);
    if smooth.lit.coverage.iter().all(|&covered| covered == 0) {
        return Err(not_visible(own, size));
    }
    out.measure("own-share-averaged", "", smooth.share_over(crease), Check::None);
    out.measure("own-share-split", "", sharp.share_over(crease), Check::None);
    out.measure("own-largest-averaged", "°", smooth.largest(), Check::None);
    out.measure("own-largest-split", "°", sharp.largest(), Check::None);
    out.measure("own-mean-averaged", "°", smooth.deviation.mean, Check::None);
    out.measure("own-mean-split", "°", sharp.deviation.mean, Check::None);
    let present = Threshold { value: crease.0, why: out.text("why-crease-angle") };
    let effect = out.effect("own", "°", [smooth.largest(), sharp.largest()], present, 2.0);
    let [angles, light] = smooth.maps();
    out.bad("own", &effect, smooth.lit);
    out.cured("own-split", &effect, sharp.lit);
    out.difference("own-angles", angles);
    out.difference("own-light", light);
    let (notes, verdict) = (vec![out.text("own-note")], Verdict::Holds(out.text("own-holds")));
    Ok(out.finish_with_notes(notes, verdict, effect))
}
