//! The report of `crease render` as JSON and as text. Members are described in `docs/json.md`.

use super::draw::Drawing;
use super::request::Request;
use super::values::FileKind;
use crate::cli::common::choice::Choose;
use crate::cli::common::console::Style;
use crate::cli::common::numbers::{count, count_of, row, seconds, size};
use crate::cli::common::output::Target;
use crate::cli::common::report::{Head, InputReport};
use crease::io::Note;
use crease::num::Degrees;
use crease::raster::{Camera, Projection, RenderSettings, SceneFile};
use crease::report::PixelReport;
use crease::shade::Guards;
use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};
use std::collections::BTreeMap;

#[derive(Default, Serialize)]
pub struct Report {
    #[serde(flatten)]
    pub head: Head,
    pub input: InputReport,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub output: Option<PictureReport>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub scene: Option<SceneReport>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub settings: Option<Settings>,
    pub drawings: Vec<Drawing>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub probe: Option<PixelReport>,
    pub notes: Vec<Note>,
    pub seconds: Seconds,
}

#[derive(Debug, Serialize)]
pub struct PictureReport {
    pub path: String,
    pub format: FileKind,
    pub bytes: u64,
    pub width: u32,
    pub height: u32,
}

#[derive(Debug, Serialize)]
pub struct SceneReport {
    pub objects: usize,
    pub meshes: usize,
    pub vertices: usize,
    pub faces: usize,
    pub lights: Vec<&'static str>,
    #[serde(serialize_with = "camera")]
    pub camera: Camera,
}

pub struct Settings(pub RenderSettings);

#[derive(Debug, Default, Serialize)]
pub struct Seconds {
    pub load: f64,
    pub draw: f64,
    pub write: f64,
    pub total: f64,
}

impl Report {
    pub fn new(request: &Request) -> Self {
        Self {
            head: Head::new("crease-render/1"),
            input: InputReport::new(&request.source, None),
            ..Self::default()
        }
    }
}

impl PictureReport {
    pub fn new(target: &Target, format: FileKind, [width, height]: [u32; 2], bytes: u64) -> Self {
        Self { path: target.name(), format, bytes, width, height }
    }
}

impl SceneReport {
    pub fn new(file: &SceneFile) -> Self {
        let scene = file.scene();
        Self {
            objects: file.objects.len(),
            meshes: file.meshes.len(),
            vertices: file.meshes.iter().map(|mesh| mesh.mesh.vertex_count()).sum(),
            faces: file.meshes.iter().map(|mesh| mesh.mesh.face_count()).sum(),
            lights: scene.lights.iter().map(|light| light.kind()).collect(),
            camera: scene.camera,
        }
    }
}

fn camera<S: Serializer>(camera: &Camera, serializer: S) -> Result<S::Ok, S::Error> {
    let mut map = serializer.serialize_map(None)?;
    map.serialize_entry("eye", &camera.eye.to_array())?;
    map.serialize_entry("target", &camera.target.to_array())?;
    map.serialize_entry("up", &camera.up.to_array())?;
    map.serialize_entry("near", &camera.near)?;
    match camera.projection {
        Projection::Perspective(angle) => map.serialize_entry("angle", &Degrees::shortest(angle))?,
        Projection::Orthographic(height) => map.serialize_entry("height", &height)?,
    }
    map.end()
}

impl Serialize for Settings {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Self(settings) = self;
        let Guards { highlight, diffuse, spot, renormalise, underflow } = settings.guards;
        let guards = [highlight, diffuse, spot, renormalise, underflow];
        let guards: BTreeMap<&str, bool> = Guards::NAMES.into_iter().zip(guards).collect();
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("width", &settings.size[0])?;
        map.serialize_entry("height", &settings.size[1])?;
        map.serialize_entry("shading", settings.shading.choice())?;
        map.serialize_entry("interpolation", settings.interpolation.choice())?;
        map.serialize_entry("samples", &settings.samples.count())?;
        map.serialize_entry("bits", &settings.bits.count())?;
        map.serialize_entry("tone", settings.tone.choice())?;
        map.serialize_entry("transfer", settings.transfer.choice())?;
        map.serialize_entry("guards", &guards)?;
        map.serialize_entry("terminator", settings.terminator.choice())?;
        map.end()
    }
}

/// More drawings than this are reported in one line.
const EACH: usize = 8;

/// The report on a file of a batch, in one line.
pub fn line(report: &Report, style: Style) -> String {
    let size = report.output.as_ref().map(|output| format!(", {}x{}", output.width, output.height));
    let faces = report.scene.as_ref().map_or(0, |scene| scene.faces);
    format!("{}: {}{}\n", title(report, style), count(faces, "face"), size.unwrap_or_default())
}

fn title(report: &Report, style: Style) -> String {
    style.title(&report.input.path, report.output.as_ref().map(|output| &*output.path))
}

pub fn block(report: &Report, style: Style) -> String {
    let mut out = title(report, style);
    out.push('\n');
    if let Some(scene) = &report.scene {
        row(&mut out, "scene", &of_scene(scene));
    }
    let settings = report.settings.as_ref().map(|settings| &settings.0);
    if let Some(settings) = settings {
        let samples = count(settings.samples.count(), "sample");
        let (shading, interpolation) = (settings.shading.choice(), settings.interpolation.choice());
        row(&mut out, "settings", &format!("{shading} shading, {interpolation} interpolation, {samples}"));
    }
    match &report.drawings[..] {
        drawings @ [_, ..] if drawings.len() <= EACH => {
            drawings.iter().for_each(|drawing| row(&mut out, "drawn", &of_drawing(drawing)));
        }
        drawings => row(&mut out, "drawn", &count(drawings.len(), "frame")),
    }
    if let (Some(output), Some(settings)) = (&report.output, settings) {
        let format = output.format.choice();
        let (bits, transfer, bytes) = (settings.bits.count(), settings.transfer.choice(), size(output.bytes));
        let (width, height) = (output.width, output.height);
        row(&mut out, "output", &format!("{format}, {width}x{height}, {bits} bits, {transfer}, {bytes}"));
    }
    let times = &report.seconds;
    let stages = [("load", times.load), ("draw", times.draw), ("write", times.write)];
    row(&mut out, "time", &seconds(times.total, &stages));
    out
}

fn of_scene(scene: &SceneReport) -> String {
    let lights = match &scene.lights[..] {
        [] => "no light".into(),
        lights => format!("{} light", lights.join(", ")),
    };
    let vertices = count_of(scene.vertices, "vertex", "vertices");
    format!("{}, {vertices}, {}; {lights}", count(scene.objects, "object"), count(scene.faces, "face"))
}

fn of_drawing(drawing: &Drawing) -> String {
    let name = drawing.name.as_ref().map(|name| format!("{name}: ")).unwrap_or_default();
    let statistics = &drawing.statistics;
    let triangles = count(statistics.triangles_drawn as usize, "triangle");
    let pixels = count(statistics.covered_pixels as usize, "pixel");
    let (clipped, culled) = (statistics.triangles_clipped, statistics.triangles_culled);
    format!("{name}{triangles} ({clipped} clipped), {culled} culled; {pixels} covered")
}
