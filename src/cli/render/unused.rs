//! Options that change nothing in what is drawn: an expectation that is not met is told.

use super::args::Variant;
use super::case::{Case, Stage, is_solid, shows_no_values};
use super::contrast::{LEAST, code, contrast};
use super::option_effects::{INTERPOLATION, readers};
use super::request::Request;
use crate::cli::report::NoteReport;
use crease::io::Note;
use crease::raster::{SceneFile, Shading, Show};

/// A note for each option, or group of them, that was typed for nothing.
pub fn notes(request: &Request, stage: &Stage) -> Vec<NoteReport> {
    let (cases, file) = (stage.cases(), stage.file);
    // Where there is nothing, that is told alone.
    if cases.is_empty() {
        return Vec::new();
    }
    let mut texts = unread(request, &cases);
    texts.extend(exact(request, file, &cases));
    texts.extend(shading(request, stage, &cases));
    texts.extend(interpolations(request, &cases));
    texts.extend(repeated(request));
    texts.extend(wire_colour(file, &cases));
    texts.extend(colours(request, file, &cases));
    texts.into_iter().map(|text| NoteReport::new(&Note::remark(text))).collect()
}

/// Options that nothing reads, those together that have the same reason.
fn unread(request: &Request, cases: &[Case]) -> Vec<String> {
    let mut groups: Vec<(&str, Vec<&str>)> = Vec::new();
    for reader in readers() {
        let Some(why) = reader.unread(request.args, cases) else { continue };
        match groups.iter_mut().find(|(reason, _)| *reason == why) {
            Some((_, names)) => names.push(reader.name),
            None => groups.push((why, vec![reader.name])),
        }
    }
    let text = |(why, names): (&str, Vec<&str>)| {
        let verb = if names.len() == 1 { "changes" } else { "change" };
        format!("{} {verb} nothing: {why}", names.join(", "))
    };
    groups.into_iter().map(text).collect()
}

/// Surfaces without a tessellation have neither faces nor corners that light could be computed at.
fn exact(request: &Request, file: &SceneFile, cases: &[Case]) -> Option<String> {
    let number = file.objects.iter().position(is_solid)?;
    let is_asked = request.args.shading.shading.is_some() || request.args.output.compare.len() > 1;
    let is_other = |case: &Case| match case.settings.shading {
        Shading::Flat | Shading::Gouraud => true,
        Shading::Phong => is_asked,
        Shading::Wireframe | Shading::Exact => false,
    };
    let is_all = file.objects.iter().all(is_solid);
    let which = if is_all { "the objects are".into() } else { format!("object {} is", number + 1) };
    let kind = if is_all { "analytic surfaces" } else { "an analytic surface" };
    cases.iter().any(is_other).then(|| {
        format!("{which} {kind} without a tessellation: whatever the shading, drawn exactly, by casting rays")
    })
}

/// Shadings between which what is shown does not tell.
fn shading(request: &Request, stage: &Stage, cases: &[Case]) -> Option<String> {
    let of_panel = |variant: &Variant| match variant {
        Variant::Shading(shading) => Some(*shading),
        Variant::Interpolation(_) => None,
    };
    let (show, own) = (stage.file.settings.show, stage.before.shading);
    let (what, compared) = match request.args.shading.shading {
        Some(typed) => ("--shading changes nothing", vec![own, typed]),
        None => (
            "comparing shadings shows no difference",
            request.args.output.compare.iter().filter_map(of_panel).collect(),
        ),
    };
    // Of those that rays are cast at another note tells.
    let is_given = cases.iter().all(|case| case.object.given);
    if cases.iter().all(Case::is_solid) || show == Show::Shaded && !is_given {
        return None;
    }
    let (alike, names): (&[Shading], _) = match shows_no_values(show) {
        true => (&[Shading::Flat, Shading::Gouraud, Shading::Phong], "flat, Gouraud and Phong"),
        false if compared.iter().all(|&shading| shading == own) => return None,
        false => (&[Shading::Gouraud, Shading::Phong], "Gouraud and Phong"),
    };
    let shown = if show == Show::Shaded { "the colours of vertices are" } else { "what --show shows is" };
    let is_reported = compared.len() > 1 && compared.iter().all(|shading| alike.contains(shading));
    is_reported.then(|| format!("{what}: {shown} the same under {names} shading"))
}

fn interpolations(request: &Request, cases: &[Case]) -> Option<String> {
    let mut variants = request.args.output.compare.iter();
    let why =
        INTERPOLATION.lack(cases).filter(|_| variants.any(|it| matches!(it, Variant::Interpolation(_))));
    why.map(|why| format!("comparing interpolations shows no difference: {why}"))
}

/// Panels that are the same because they are asked for twice.
fn repeated(request: &Request) -> Option<String> {
    let variants = &request.args.output.compare[..];
    let twice = variants.iter().enumerate().find(|&(at, variant)| variants[..at].contains(variant));
    twice.map(|(_, variant)| {
        format!("--compare names {} more than once: its panels are the same", variant.name())
    })
}

fn wire_colour(file: &SceneFile, cases: &[Case]) -> Option<String> {
    let (wire, background, transfer) = (file.settings.wire.colour, file.background, file.settings.transfer);
    let is_drawn = file.settings.show == Show::Shaded
        && cases.iter().any(|case| case.settings.shading == Shading::Wireframe && !case.is_solid());
    let found = contrast(wire, background, transfer);
    if !is_drawn || found >= LEAST {
        return None;
    }
    // Not up to what is asked for.
    let reported = (found * 100.0).floor() / 100.0;
    let what = match code(wire, transfer) == code(background, transfer) {
        true => "has the colour of the background".into(),
        false => format!(
            "is hard to tell from the background: their contrast is {reported:.2}:1, and WCAG 2.1 asks for {LEAST}:1"
        ),
    };
    Some(format!("the wireframe {what}; choose another --background"))
}

/// Colours of a mesh's vertices that it is not drawn in. A scene says itself which of its objects are.
fn colours(request: &Request, file: &SceneFile, cases: &[Case]) -> Option<String> {
    let has_colours = |object| file.mesh_of(object).is_some_and(|mesh| mesh.colours.is_some());
    let all = 0..file.objects.len();
    let is_lost = cases.iter().any(Case::is_lit)
        && all.clone().any(|object| has_colours(object) && !file.objects[object].given);
    let advice = match all.clone().all(has_colours) {
        true => "--reflection given shows them",
        false => "a scene in TOML can give each object `reflection = \"given\"`",
    };
    (is_lost && !request.has_settings())
        .then(|| format!("vertices have colours, which light on materials does not show; {advice}"))
}
