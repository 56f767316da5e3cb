//! Options of `crease render` made into what is drawn.

use super::args::RenderArgs;
use super::values::{Background, FileKind, HiddenLines, Variant};
use crate::cli::common::choice::Choose;
use crate::cli::common::input::Source;
use crate::cli::common::output::Target;
use crate::cli::common::output_conflicts::Files;
use crease::io::Format;
use crease::normals::{Crease, When};
use crease::raster::{Bits, LoadOptions, NormalSettings, RenderSettings, SceneObject, SceneShape, Shading};
use crease::report::panels_size;
use crease::shade::Light;
use std::path::Path;

pub struct Request<'a> {
    pub args: &'a RenderArgs,
    pub source: Source,
    pub format: Option<Format>,
    pub load: LoadOptions,
    /// The output; `None` if nothing is written.
    pub target: Option<Target>,
    pub file: FileKind,
    pub subject: Subject<'a>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subject<'a> {
    Picture,
    Panels(&'a [Variant]),
    Turntable(u16),
}

/// Most pixels of all frames or panels together: as many as the largest single picture has.
const MOST_PIXELS: u64 = 1 << 28;

impl<'a> Request<'a> {
    pub fn resolve(args: &'a RenderArgs) -> Result<Self, String> {
        let input = args.input.as_deref().unwrap_or(Path::new("-"));
        let source = Source::of(input);
        if source != Source::Standard && input.is_dir() {
            return usage(format!("{} is a folder\nhelp: name one file to draw", input.display()));
        }
        let (target, file) = target(args)?;
        if let Some(Target::File(output)) = &target {
            Files::read(source.path()).check(output)?;
        }
        if target.is_none() && args.output.probe.is_none() && !args.run.json {
            return usage("--output is required\nhelp: --probe and --json need none");
        }
        let subject = match (args.output.turntable, &args.output.compare[..]) {
            (Some(frames), _) => Subject::Turntable(frames),
            (None, []) => Subject::Picture,
            (None, variants) => Subject::Panels(variants),
        };
        let is_computed = args.normals.weight.is_some() || args.normals.crease.is_some();
        let request = Self {
            args,
            source,
            format: args.output.format,
            load: LoadOptions {
                // Options override a scene.
                normals: NormalSettings {
                    weight: args.normals.weight,
                    crease: args.normals.crease.map(Crease::Angle),
                    ..NormalSettings::default()
                },
                when: args.normals.when.or(is_computed.then(When::default)),
                from_elsewhere: args.scene.camera.is_some(),
                read: args.output.companions.read_options(args.output.force),
                ..LoadOptions::default()
            },
            target,
            file,
            subject,
        };
        request.check_combinations()?;
        Ok(request)
    }

    fn check_combinations(&self) -> Result<(), String> {
        let args = self.args;
        if args.output.bits == Some(Bits::Sixteen) && self.file != FileKind::Png {
            return usage(format!(
                "--bits 16 needs a PNG output: {} has 8 bits per component\nhelp: name a .png file",
                self.file.choice().to_uppercase()
            ));
        }
        if args.scene.background == Some(Background::Transparent) {
            if !matches!(self.file, FileKind::Png | FileKind::WebP) {
                return usage("--background transparent needs a PNG or WebP output\nhelp: name a .png file");
            }
            if self.subject != Subject::Picture {
                return usage(
                    "--background transparent does not work with --compare\nhelp: use --background white",
                );
            }
        }
        let compares = |wanted: fn(&Variant) -> bool| args.output.compare.iter().any(wanted);
        if args.shading.shading.is_some() && compares(|it| matches!(it, Variant::Shading(_))) {
            return usage("--shading cannot be used with a --compare of shadings");
        }
        if args.shading.interpolation.is_some() && compares(|it| matches!(it, Variant::Interpolation(_))) {
            return usage("--interpolation cannot be used with a --compare of interpolations");
        }
        Ok(())
    }

    pub fn has_settings(&self) -> bool {
        let is_toml = |path: &Path| path.extension().is_some_and(|name| name.eq_ignore_ascii_case("toml"));
        matches!(&self.source, Source::File(path) if is_toml(path)) && self.format.is_none()
    }

    pub fn panels(&self, settings: &RenderSettings) -> Vec<RenderSettings> {
        match self.subject {
            Subject::Panels(variants) => variants.iter().map(|variant| variant.settings(settings)).collect(),
            Subject::Picture | Subject::Turntable(_) => vec![*settings],
        }
    }

    /// Whether lines behind surfaces are hidden; `default` if no option specifies it.
    pub fn hides_lines(&self, default: bool) -> bool {
        self.args.shading.hidden_lines.map_or(default, |lines| lines == HiddenLines::Remove)
    }

    /// Whether options contain positions in the scene's own space.
    pub fn has_places(&self) -> bool {
        let scene = &self.args.scene;
        scene.camera.is_some_and(|camera| camera.has_places())
            || scene.light.iter().any(|light| !matches!(light, Light::Directional { .. }))
    }

    /// Refuses too many pixels: panels are kept until they are put together, and frames cost time.
    pub fn check_amount(&self, size: [u32; 2]) -> Result<(), String> {
        let (count, what) = match self.subject {
            Subject::Picture => return Ok(()),
            Subject::Panels(variants) => {
                let captions: Vec<_> = variants.iter().map(|variant| variant.caption()).collect();
                panels_size(&captions, size).map_err(|error| format!("--compare: {error}"))?;
                (variants.len(), "panels")
            }
            Subject::Turntable(frames) => (frames.into(), "frames"),
        };
        let [width, height] = size.map(u64::from);
        let pixels = width * height * count as u64;
        match pixels > MOST_PIXELS {
            true => Err(format!(
                "{count} {what} of {width}x{height} pixels have {pixels} (limit {MOST_PIXELS})\nhelp: draw fewer or smaller {what}"
            )),
            false => Ok(()),
        }
    }

    pub fn check_probe(&self, settings: &RenderSettings) -> Result<(), String> {
        let Some([x, y]) = self.args.output.probe else { return Ok(()) };
        let [width, height] = settings.size;
        if x >= width || y >= height {
            let last = [width, height].map(|side| side - 1);
            return usage(format!(
                "--probe {x},{y} is outside the picture of {width}x{height} pixels\nhelp: give a pixel from 0,0 to {},{}",
                last[0], last[1]
            ));
        }
        if settings.shading == Shading::Wireframe {
            return usage(
                "--probe needs shaded pixels; it does not work with --shading wireframe\nhelp: use --shading phong",
            );
        }
        Ok(())
    }
}

fn target(args: &RenderArgs) -> Result<(Option<Target>, FileKind), String> {
    let wants_gif = args.output.turntable.is_some();
    let chosen = args.output.to;
    let by_subject = chosen.unwrap_or(if wants_gif { FileKind::Gif } else { FileKind::Png });
    let path = args.output.output.as_deref();
    let target = path.map(Target::of);
    let file = match (&target, path) {
        (Some(Target::File(_)), Some(path)) => {
            if path.is_dir() {
                return usage(format!("{} is a folder\nhelp: name a file", path.display()));
            }
            let extension = path.extension().and_then(|name| name.to_str()).map(str::to_ascii_lowercase);
            let by_name = extension.and_then(|extension| FileKind::of_extension(&extension));
            let Some(file) = chosen.or(by_name) else {
                let found = format!("unknown picture format ({})", path.display());
                return usage(format!("{found}\nhelp: use .png, .jpg, .webp or .gif, or choose with --to"));
            };
            file
        }
        _ => by_subject,
    };
    if wants_gif && file != FileKind::Gif {
        return usage("--turntable makes a GIF\nhelp: name an output that ends in .gif");
    }
    Ok((target, file))
}

fn usage<T>(message: impl Into<String>) -> Result<T, String> {
    Err(message.into())
}

/// Whether an object is drawn by casting rays, whatever the shading.
pub fn is_solid(object: &SceneObject) -> bool {
    matches!(object.shape, SceneShape::Surface(_))
}
