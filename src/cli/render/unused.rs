//! Options that change nothing in what is drawn: an expectation that is not met is told.

use super::args::Variant;
use super::request::{Request, Subject};
use crate::cli::report::NoteReport;
use crease::io::Note;
use crease::num::LinearRgb;
use crease::raster::{RenderSettings, SceneFile, SceneObject, SceneShape, Shading, Show};

/// A note for each option, or group of them, that was typed for nothing.
pub fn notes(request: &Request, file: &SceneFile) -> Vec<NoteReport> {
    let drawn = drawn(request, &file.settings);
    let texts = [
        normals(request, file),
        exact(request, file, &drawn),
        flat_sample(request, &drawn),
        interpolation(request, file, &drawn),
        hidden_lines(request, &drawn),
        light(request, &file.settings, &drawn),
        wire_colour(file, &drawn),
    ];
    texts.into_iter().flatten().map(|text| NoteReport::new(&Note::remark(text))).collect()
}

/// The shadings of what is drawn: of the picture, or of each panel.
fn drawn(request: &Request, settings: &RenderSettings) -> Vec<Shading> {
    let of_panel = |variant: &Variant| match variant {
        Variant::Shading(shading) => *shading,
        Variant::Interpolation(_) => settings.shading,
    };
    match request.subject {
        Subject::Panels(variants) => variants.iter().map(of_panel).collect(),
        _ => vec![settings.shading],
    }
}

fn is_solid(object: &SceneObject) -> bool {
    matches!(object.shape, SceneShape::Surface(_))
}

fn normals(request: &Request, file: &SceneFile) -> Option<String> {
    let text = "there are no meshes, whose normals --weight, --crease and --when would change";
    (request.args.normals.are_typed() && file.meshes.is_empty()).then(|| text.to_owned())
}

/// Surfaces without a tessellation have neither faces nor corners that light could be computed at.
fn exact(request: &Request, file: &SceneFile, drawn: &[Shading]) -> Option<String> {
    let number = file.objects.iter().position(is_solid)?;
    let is_asked = request.args.shading.shading.is_some() || drawn.len() > 1;
    let is_other = |shading: &Shading| match shading {
        Shading::Flat | Shading::Gouraud => true,
        Shading::Phong => is_asked,
        Shading::Wireframe | Shading::Exact => false,
    };
    let is_all = file.objects.iter().all(is_solid);
    let which = if is_all { "the objects are".into() } else { format!("object {} is", number + 1) };
    let kind = if is_all { "analytic surfaces" } else { "an analytic surface" };
    drawn.iter().any(is_other).then(|| {
        format!("{which} {kind} without a tessellation: whatever the shading, drawn exactly, by casting rays")
    })
}

fn flat_sample(request: &Request, drawn: &[Shading]) -> Option<String> {
    let is_unused = request.args.shading.flat_sample.is_some() && !drawn.contains(&Shading::Flat);
    is_unused.then(|| "--flat-sample changes nothing without flat shading".into())
}

fn interpolation(request: &Request, file: &SceneFile, drawn: &[Shading]) -> Option<String> {
    let compares =
        request.args.output.compare.iter().any(|variant| matches!(variant, Variant::Interpolation(_)));
    if request.args.shading.interpolation.is_none() && !compares {
        return None;
    }
    let what = if compares {
        "comparing interpolations shows no difference"
    } else {
        "--interpolation changes nothing"
    };
    if file.objects.iter().all(is_solid) {
        return Some(format!("{what}: analytic surfaces without a tessellation have no corners"));
    }
    let show = file.settings.show;
    if matches!(show, Show::Facing | Show::Depth | Show::FaceId) {
        return Some(format!("{what}: what --show shows is not interpolated"));
    }
    let varies = |shading: &Shading| match shading {
        Shading::Gouraud | Shading::Phong => true,
        // What is shown in place of light are normals, which a wireframe interpolates as well.
        Shading::Wireframe => show != Show::Shaded,
        Shading::Flat | Shading::Exact => false,
    };
    (!drawn.iter().any(varies)).then(|| format!("{what}: only Gouraud and Phong shading interpolate"))
}

fn hidden_lines(request: &Request, drawn: &[Shading]) -> Option<String> {
    let shading = &request.args.shading;
    let has_lines = drawn.contains(&Shading::Wireframe) || !shading.overlay.is_empty();
    (shading.hidden_lines.is_some() && !has_lines).then(|| {
        "--hidden-lines changes nothing: there are no lines without --shading wireframe or --overlay".into()
    })
}

/// Options of light where none is shown.
fn light(request: &Request, settings: &RenderSettings, drawn: &[Shading]) -> Option<String> {
    let (scene, shading, colour) = (&request.args.scene, &request.args.shading, &request.args.colour);
    let why = match settings.show {
        Show::Shaded if drawn.iter().all(|&shading| shading == Shading::Wireframe) => {
            "a wireframe is not lit"
        }
        Show::Shaded => return None,
        _ => "--show shows something in place of light",
    };
    let typed = [
        (!scene.light.is_empty(), "--light"),
        (scene.ambient.is_some(), "--ambient"),
        (scene.material.is_some(), "--material"),
        (shading.reflection.is_some(), "--reflection"),
        (shading.exponent.is_some(), "--exponent"),
        (!colour.guard.is_empty(), "--guard"),
        (colour.literal, "--literal"),
        (colour.terminator.is_some(), "--terminator"),
    ];
    let typed: Vec<&str> = typed.iter().filter(|(is_typed, _)| *is_typed).map(|&(_, name)| name).collect();
    let verb = if typed.len() == 1 { "changes" } else { "change" };
    (!typed.is_empty()).then(|| format!("{} {verb} nothing: {why}", typed.join(", ")))
}

fn wire_colour(file: &SceneFile, drawn: &[Shading]) -> Option<String> {
    let code = |colour: LinearRgb| colour.to_array().map(|light| file.settings.transfer.to_u8(light));
    let is_lost = drawn.contains(&Shading::Wireframe)
        && file.settings.show == Show::Shaded
        && code(file.settings.wire.colour) == code(file.background);
    is_lost.then(|| "the wireframe has the colour of the background: choose another --background".into())
}
