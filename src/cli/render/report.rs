//! What `render` tells: the one source of the JSON and of the text for people.
//!
//! # The JSON schema, `crease-render/1`
//! One object on one line. A change that could break a reader raises the number after the slash; new members may come
//! at any time.
//!
//! | member | meaning |
//! |---|---|
//! | `schema`, `crease` | `"crease-render/1"`; the program's version |
//! | `status`, `error`, `notes` | as in `crease-normals/1` |
//! | `input` | `path` (`"-"`: standard input), `bytes` |
//! | `output` | absent if none was made; else `path`, `format` (`"png"`, `"gif"`), `bytes`, `width`, `height` |
//! | `scene` | `objects`, `meshes`, `vertices`, `faces` (counts, each mesh once), `lights` (their kinds), `camera` (`eye`, `target`, `up`, `near`, and `angle` in degrees or `height`) |
//! | `settings` | `width`, `height`, `shading`, `interpolation`, `samples`, `bits`, `tone`, `transfer`, `guards` (by name), `terminator` |
//! | `drawings` | one for each panel or frame: `name` (absent for a single picture), `covered_pixels`, `triangles_drawn`, `triangles_clipped`, `triangles_culled`, and `seconds`: `geometry`, `binning`, `tiles` |
//! | `probe` | absent unless asked for; what the library's `PixelReport` has |
//! | `seconds` | `load` (reading, normals), `draw` (with encoding, and storing an animation), `write`, `total` |

use super::args::{INTERPOLATIONS, SHADINGS, TERMINATORS, TRANSFERS};
use super::draw::{Drawing, Drawn};
use super::request::{FileKind, Request};
use crate::cli::choice::name_of;
use crate::cli::inputs::Source;
use crate::cli::report::{ErrorReport, Head, NoteReport};
use crate::cli::request::Target;
use crease::num::Degrees;
use crease::raster::{Camera, Projection, RenderSettings, Scene, SceneFile};
use crease::report::PixelReport;
use crease::shade::Guards;
use serde::Serialize;
use std::collections::BTreeMap;

/// The schema's name and version.
pub const SCHEMA: &str = "crease-render/1";

#[derive(Debug, Serialize)]
pub struct Report {
    #[serde(flatten)]
    pub head: Head,
    pub input: InputReport,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub output: Option<OutputReport>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub scene: Option<SceneReport>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub settings: Option<SettingsReport>,
    pub drawings: Vec<DrawingReport>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub probe: Option<PixelReport>,
    pub notes: Vec<NoteReport>,
    pub seconds: Seconds,
}

#[derive(Debug, Serialize)]
pub struct InputReport {
    pub path: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bytes: Option<u64>,
}

#[derive(Debug, Serialize)]
pub struct OutputReport {
    pub path: String,
    pub format: &'static str,
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
    pub camera: CameraReport,
}

#[derive(Debug, Serialize)]
pub struct CameraReport {
    pub eye: [f64; 3],
    pub target: [f64; 3],
    pub up: [f64; 3],
    pub near: f64,
    #[serde(flatten)]
    pub projection: ProjectionReport,
}

#[derive(Debug, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum ProjectionReport {
    Angle(f64),
    Height(f64),
}

#[derive(Debug, Serialize)]
pub struct SettingsReport {
    pub width: u32,
    pub height: u32,
    pub shading: &'static str,
    pub interpolation: &'static str,
    pub samples: usize,
    pub bits: u8,
    pub tone: &'static str,
    pub transfer: &'static str,
    pub guards: BTreeMap<&'static str, bool>,
    pub terminator: &'static str,
}

#[derive(Debug, Serialize)]
pub struct DrawingReport {
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    pub covered_pixels: u64,
    pub triangles_drawn: u64,
    pub triangles_clipped: u64,
    pub triangles_culled: u64,
    pub seconds: StageSeconds,
}

#[derive(Debug, Serialize)]
pub struct StageSeconds {
    pub geometry: f64,
    pub binning: f64,
    pub tiles: f64,
}

#[derive(Debug, Default, Serialize)]
pub struct Seconds {
    pub load: f64,
    pub draw: f64,
    pub write: f64,
    pub total: f64,
}

impl Report {
    /// A report on an input that nothing has been done with yet.
    pub fn new(request: &Request) -> Self {
        let (path, bytes) = match &request.source {
            Source::Stdin => ("-".into(), None),
            Source::File(path) => {
                (path.to_string_lossy().into_owned(), path.metadata().ok().map(|m| m.len()))
            }
        };
        Self {
            head: Head::new(SCHEMA),
            input: InputReport { path, bytes },
            output: None,
            scene: None,
            settings: None,
            drawings: Vec::new(),
            probe: None,
            notes: Vec::new(),
            seconds: Seconds::default(),
        }
    }

    /// Notes down why there is no picture.
    pub fn fail(&mut self, error: ErrorReport) {
        self.head.fail(error);
        self.output = None;
    }
}

impl OutputReport {
    pub fn new(target: &Target, kind: FileKind, drawn: &Drawn) -> Self {
        let [width, height] = drawn.size;
        Self {
            path: match target {
                Target::Stdout => "-".into(),
                Target::File(path) => path.to_string_lossy().into_owned(),
            },
            format: match kind {
                FileKind::Png => "png",
                FileKind::Gif => "gif",
            },
            bytes: drawn.made.len(),
            width,
            height,
        }
    }
}

impl SceneReport {
    pub fn new(file: &SceneFile, scene: &Scene) -> Self {
        let Camera { eye, target, up, near, projection } = scene.camera;
        Self {
            objects: file.objects.len(),
            meshes: file.meshes.len(),
            vertices: file.meshes.iter().map(|mesh| mesh.mesh.vertex_count()).sum(),
            faces: file.meshes.iter().map(|mesh| mesh.mesh.face_count()).sum(),
            lights: scene.lights.iter().map(|light| light.kind()).collect(),
            camera: CameraReport {
                eye: eye.to_array(),
                target: target.to_array(),
                up: up.to_array(),
                near,
                projection: match projection {
                    Projection::Perspective(angle) => ProjectionReport::Angle(Degrees::shortest(angle).0),
                    Projection::Orthographic(height) => ProjectionReport::Height(height),
                },
            },
        }
    }
}

impl SettingsReport {
    pub fn new(settings: &RenderSettings) -> Self {
        let Guards { highlight, diffuse, spot, renormalise, underflow } = settings.guards;
        let guards = [highlight, diffuse, spot, renormalise, underflow];
        Self {
            width: settings.size[0],
            height: settings.size[1],
            shading: name_of(SHADINGS, &settings.shading),
            interpolation: name_of(INTERPOLATIONS, &settings.interpolation),
            samples: settings.samples.count(),
            bits: settings.bits.count(),
            tone: settings.tone.name(),
            transfer: name_of(TRANSFERS, &settings.transfer),
            guards: Guards::NAMES.into_iter().zip(guards).collect(),
            terminator: name_of(TERMINATORS, &settings.terminator),
        }
    }
}

impl DrawingReport {
    pub fn new(drawing: &Drawing) -> Self {
        let statistics = &drawing.statistics;
        Self {
            name: drawing.name.clone(),
            covered_pixels: statistics.covered_pixels,
            triangles_drawn: statistics.triangles_drawn,
            triangles_clipped: statistics.triangles_clipped,
            triangles_culled: statistics.triangles_culled,
            seconds: StageSeconds {
                geometry: statistics.times.geometry.as_secs_f64(),
                binning: statistics.times.binning.as_secs_f64(),
                tiles: statistics.times.tiles.as_secs_f64(),
            },
        }
    }
}
