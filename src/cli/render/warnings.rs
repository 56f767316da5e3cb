//! Notes on options that have no effect, and on materials that cannot be drawn as meant.

use super::args::RenderArgs;
use super::request::{Request, is_solid};
use super::values::ReflectionChoice;
use crate::cli::common::console::escaped;
use crease::io::{Note, Place};
use crease::mesh::{Link, Mesh, Topology, Weld};
use crease::raster::{FlatSample, RenderSettings, SceneFile, SceneObject, SceneShape, Shading, Show};
use crease::report::Overlay;

pub fn notes(request: &Request, file: &SceneFile) -> Vec<Note> {
    let args = request.args;
    let panels = request.panels(&file.settings);
    let mut texts = without_effect(args, file, &panels);
    texts.extend(analytic(args, file, &panels));
    let is_lit = |object: &SceneObject| unlit(file, &panels).is_none() && !object.given;
    let has_colours = |object| file.mesh_of(object).is_some_and(|mesh| mesh.colours.is_some());
    let numbers = 0..file.objects.len();
    let is_lost = numbers.clone().any(|object| has_colours(object) && is_lit(&file.objects[object]));
    if is_lost && !request.has_settings() {
        let advice = match numbers.clone().all(has_colours) {
            true => "--reflection given shows them",
            false => "a scene in TOML can give each object `reflection = \"given\"`",
        };
        texts.push(format!("the vertex colours are not drawn: lit materials replace them; {advice}"));
    }
    let gains =
        numbers.zip(&file.objects).filter(|(_, object)| is_lit(object)).filter_map(|(number, object)| {
            let gain = object.material.gain()?;
            Some(Note::warning(Place::File, format!("object {number}: {gain}")))
        });
    texts.extend(untraced(file, &panels));
    texts.into_iter().map(Note::remark).chain(gains).chain(open_bodies(file, &panels)).collect()
}

fn is_traced(file: &SceneFile, panels: &[RenderSettings]) -> bool {
    file.settings.show == Show::Shaded && panels.iter().any(|panel| panel.shading == Shading::Traced)
}

/// How messages name an object.
fn named(number: usize, object: &SceneObject) -> String {
    match &*object.name {
        "" => format!("object {number}"),
        name => format!("object {number} (`{}`)", escaped(name)),
    }
}

fn untraced(file: &SceneFile, panels: &[RenderSettings]) -> Option<String> {
    let (number, object) = file.objects.iter().enumerate().find(|(_, object)| object.optics.continues())?;
    let what = if object.optics.transmits() { "transmits light" } else { "mirrors light" };
    let is_shown = is_traced(file, panels) || file.settings.show != Show::Shaded;
    (!is_shown).then(|| format!("{} {what}, which only --shading traced draws", named(number, object)))
}

fn has_border(mesh: &Mesh) -> bool {
    let topology = Topology::build(mesh, Weld::Exact);
    let corners = 0..mesh.faces().corner_count() as u32;
    corners.into_iter().any(|corner| matches!(topology.link(corner), Link::Boundary | Link::Ambiguous))
}

/// Warnings about the first transmitting object with a border: light that enters it does not leave.
fn open_bodies(file: &SceneFile, panels: &[RenderSettings]) -> Option<Note> {
    let is_open = |number: usize, object: &SceneObject| match (&object.shape, file.mesh_of(number)) {
        (SceneShape::Surface(primitive), _) => !primitive.is_closed(),
        (_, Some(mesh)) => has_border(&mesh.mesh),
        _ => false,
    };
    let mut open = file.objects.iter().enumerate().filter(|(number, object)| {
        object.optics.transmits() && object.optics.ior != 1.0 && is_open(*number, object)
    });
    let (number, object) = open.next().filter(|_| is_traced(file, panels))?;
    let text = format!(
        "{} transmits light, but its surface is open: a ray that enters may never leave; close it, or use `ior = 1` for a thin wall",
        named(number, object)
    );
    Some(Note { more: open.count() as u64, ..Note::warning(Place::File, text) })
}

/// Why light changes nothing.
fn unlit(file: &SceneFile, panels: &[RenderSettings]) -> Option<&'static str> {
    match file.settings.show {
        Show::Shaded if panels.iter().all(|it| it.shading == Shading::Wireframe) => {
            Some("a wireframe is not lit")
        }
        Show::Shaded if file.objects.iter().all(|it| it.given) => {
            Some("the colours of vertices are shown unlit")
        }
        Show::Shaded => None,
        _ => Some("--show draws something else in place of light"),
    }
}

fn without_effect(args: &RenderArgs, file: &SceneFile, panels: &[RenderSettings]) -> Vec<String> {
    let (shading, scene, colour, normals) = (&args.shading, &args.scene, &args.colour, &args.normals);
    let has = |wanted: &[Shading]| panels.iter().any(|panel| wanted.contains(&panel.shading));
    let is_shaded = file.settings.show == Show::Shaded;
    let probes = args.output.probe.is_some();
    let interpolates = has(&[Shading::Gouraud, Shading::Phong, Shading::Traced])
        || !is_shaded && has(&[Shading::Wireframe])
        || probes;
    let mut texts = Vec::new();
    let mut warn = |options: &[(&str, bool)], why: &str| {
        let typed: Vec<&str> = options.iter().filter(|option| option.1).map(|option| option.0).collect();
        let verb = if typed.len() == 1 { "changes" } else { "change" };
        if !typed.is_empty() {
            texts.push(format!("{} {verb} nothing: {why}", typed.join(", ")));
        }
    };
    if let Some(why) = unlit(file, panels) {
        let makes_given = is_shaded && shading.reflection == Some(ReflectionChoice::Given);
        let options = [
            ("--light", !scene.light.is_empty()),
            ("--ambient", scene.ambient.is_some()),
            ("--material", scene.material.is_some()),
            ("--reflection", shading.reflection.is_some() && !makes_given),
            ("--exponent", shading.exponent.is_some()),
            ("--guard", !colour.guard.is_empty()),
            ("--literal", colour.literal),
            ("--terminator", colour.terminator.is_some()),
        ];
        warn(&options, why);
    } else if !has(&[Shading::Phong, Shading::Traced]) {
        warn(&[("--terminator", colour.terminator.is_some())], "only Phong shading and tracing use it");
    }
    let of_normals = [
        ("--weight", normals.weight.is_some()),
        ("--crease", normals.crease.is_some()),
        ("--when", normals.when.is_some()),
    ];
    let draws_normals =
        shading.overlay.iter().any(|it| matches!(it, Overlay::VertexNormals | Overlay::Creases));
    let has_means = file.settings.flat_sample == FlatSample::VertexMean && has(&[Shading::Flat]);
    if file.objects.iter().all(is_solid) {
        warn(&of_normals, "the scene has no meshes");
    } else if !interpolates && !draws_normals && !has_means {
        warn(&of_normals, "only Gouraud and Phong shading use the normals of corners");
    }
    if !interpolates {
        let is_typed = shading.interpolation.is_some();
        warn(&[("--interpolation", is_typed)], "only Gouraud and Phong shading interpolate");
    }
    texts
}

/// Analytic surfaces without a tessellation have neither faces nor corners that light could be computed at.
fn analytic(args: &RenderArgs, file: &SceneFile, panels: &[RenderSettings]) -> Option<String> {
    let number = file.objects.iter().position(is_solid)?;
    let is_asked = args.shading.shading.is_some() || args.output.compare.len() > 1;
    let is_other = |panel: &RenderSettings| match panel.shading {
        Shading::Flat | Shading::Gouraud => true,
        Shading::Phong => is_asked,
        Shading::Wireframe | Shading::Exact | Shading::Traced => false,
    };
    let which = match file.objects.iter().all(is_solid) {
        true => "the objects are analytic surfaces".into(),
        false => format!("object {number} is an analytic surface"),
    };
    panels
        .iter()
        .any(is_other)
        .then(|| format!("{which} without a tessellation, drawn exactly by ray casting with any shading"))
}
