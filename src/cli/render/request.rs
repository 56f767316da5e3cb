//! What was typed after `render`, made into what shall be done.

use super::args::{HiddenLines, ReflectionChoice, RenderArgs, Variant};
use super::contrast::contrast;
use super::turn;
use crate::cli::inputs::Source;
use crate::cli::normals::Failure;
use crate::cli::output::is_same_file;
use crate::cli::request::Target;
use crease::io::{Format, NonFinite, ReadOptions};
use crease::normals::{Crease, NormalRecipe, When};
use crease::num::{LinearRgb, Transfer};
use crease::raster::{
    Bits, LoadOptions, RenderError, RenderSettings, Samples, SceneFile, Shading, Show, default_lights,
    rotation,
};
use crease::report::panels_size;
use crease::shade::{Guards, Light, Place, Reflection, ShadeError};
use std::path::Path;

/// Everything to do, checked as far as that goes without the input.
pub struct Request<'a> {
    pub args: &'a RenderArgs,
    pub source: Source,
    pub format: Option<Format>,
    pub load: LoadOptions,
    /// Where the picture goes; `None`: nowhere.
    pub target: Option<Target>,
    pub file: FileKind,
    pub subject: Subject<'a>,
}

/// What kind of file a picture becomes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FileKind {
    Png,
    Gif,
}

/// What is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subject<'a> {
    Picture,
    Panels(&'a [Variant]),
    /// So many frames.
    Turntable(u16),
}

/// Most pixels of all frames or panels together, as many as the largest single picture has: what is more was hardly meant.
const MOST_PIXELS: u64 = 1 << 28;

impl<'a> Request<'a> {
    /// Checks what was typed against itself.
    pub fn resolve(args: &'a RenderArgs) -> Result<Self, String> {
        let source = if args.input.as_os_str() == "-" {
            Source::Stdin
        } else if args.input.is_dir() {
            return usage(format!("{} is a folder; render draws one file", args.input.display()));
        } else {
            Source::File(args.input.clone())
        };
        let (target, file) = target(args)?;
        if let (Source::File(input), Some(Target::File(output))) = (&source, &target)
            && is_same_file(input, output)
        {
            return usage(format!("this would overwrite the input {}; name another output", input.display()));
        }
        if target.is_none() && args.output.probe.is_none() && !args.run.json {
            return usage("--output is needed; --probe and --json go without");
        }
        let subject = match (args.output.turntable, &args.output.compare[..]) {
            (Some(frames), _) => Subject::Turntable(frames),
            (None, []) => Subject::Picture,
            (None, variants) => Subject::Panels(variants),
        };
        let request = Self {
            args,
            source,
            format: args.output.format,
            load: LoadOptions {
                recipe: NormalRecipe {
                    weight: args.normals.weight.unwrap_or(NormalRecipe::default().weight),
                    crease: args.normals.crease.map_or(Crease::Default, Crease::Angle),
                    ..NormalRecipe::default()
                },
                // Options override what a scene says.
                when: args.normals.when.or(args.normals.are_typed().then(When::default)),
                from_elsewhere: args.scene.camera.is_some(),
                read: ReadOptions {
                    root: args.output.root.clone(),
                    non_finite: if args.output.force { NonFinite::DropFaces } else { NonFinite::Refuse },
                    ..ReadOptions::default()
                },
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
        if args.output.bits == Some(Bits::Sixteen) && self.file == FileKind::Gif {
            return usage("GIF has 8 bits a component; --bits 16 needs a PNG output");
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

    /// Whether the input is a scene with settings of its own.
    pub fn has_settings(&self) -> bool {
        let is_toml = |path: &Path| path.extension().is_some_and(|name| name.eq_ignore_ascii_case("toml"));
        matches!(&self.source, Source::File(path) if is_toml(path)) && self.format.is_none()
    }

    /// Whether lines behind surfaces are left out, if nothing else says so.
    pub fn hides_lines(&self, default: bool) -> bool {
        self.args.shading.hidden_lines.map_or(default, |lines| lines == HiddenLines::Remove)
    }

    /// Whether what was typed tells places in the scene's own space.
    pub fn has_places(&self) -> bool {
        let scene = &self.args.scene;
        scene.camera.is_some_and(|camera| camera.has_places())
            || scene.light.iter().any(|light| !matches!(light, Light::Directional { .. }))
    }

    /// Changes a scene as asked.
    ///
    /// # Errors
    /// What the scene lacks, and what makes no sense with it.
    pub fn change(&self, file: &mut SceneFile) -> Result<(), Failure> {
        let transfer = file.settings.transfer;
        self.change_settings(file);
        self.check_amount(file.settings.size).map_err(Failure::Usage)?;
        self.check_probe(&file.settings).map_err(Failure::Usage)?;
        self.change_materials(file).map_err(Failure::Draw)?;
        let scene = &self.args.scene;
        file.background = scene.background.unwrap_or(file.background);
        let is_typed = self.args.colour.transfer.is_some();
        if !is_typed && (transfer, file.settings.transfer) == (Transfer::Srgb, Transfer::Direct) {
            // The same codes as behind the lit picture.
            file.background = file.background.to_array().map(|light| Transfer::Srgb.encode(light)).into();
        }
        let reported = |wire| contrast(wire, file.background, file.settings.transfer);
        if !self.has_settings() && reported(LinearRgb::BLACK) > reported(LinearRgb::WHITE) {
            file.settings.wire.colour = LinearRgb::BLACK;
        }
        if let Some(degrees) = scene.rotate {
            let pivot = turn::pivot(file);
            turn::turn(file, rotation(degrees), pivot);
        }
        // From here on the camera stays where it is, whatever turns.
        let framed = if file.camera.is_none() { file.scene().bounds() } else { None };
        let camera = match self.subject {
            Subject::Turntable(_) => turn::camera(file),
            _ => file.scene().camera,
        };
        let camera = scene.camera.map_or(camera, |change| change.apply(&camera, framed));
        if scene.camera.is_some() {
            camera.check().map_err(|error| Failure::Usage(format!("--camera: {error}")))?;
        }
        file.camera = Some(camera);
        if !scene.light.is_empty() || scene.ambient.is_some() {
            let before = file.lights.take().unwrap_or_else(|| default_lights(&camera).to_vec());
            file.lights = Some(lights(&before, &scene.light, scene.ambient));
        }
        Ok(())
    }

    fn check_probe(&self, settings: &RenderSettings) -> Result<(), String> {
        let Some([x, y]) = self.args.output.probe else { return Ok(()) };
        let [width, height] = settings.size;
        if x >= width || y >= height {
            let last = [width, height].map(|side| side - 1);
            return usage(format!(
                "--probe {x},{y} is outside the picture of {width}x{height} pixels, whose last one is {},{}",
                last[0], last[1]
            ));
        }
        if settings.shading == Shading::Wireframe {
            return usage(
                "--probe tells how colours come about, and a wireframe has none: give another --shading",
            );
        }
        Ok(())
    }

    /// What was typed that is to blame for an error of drawing, and what is wrong with it.
    pub fn blame(&self, error: &RenderError, lights: usize) -> Option<String> {
        let (scene, shading) = (&self.args.scene, &self.args.shading);
        let typed = |is_typed: bool, option: &str, what: &dyn std::fmt::Display| {
            is_typed.then(|| format!("{option}: {what}"))
        };
        let is_typed = |light: usize| !scene.light.is_empty() && light + scene.light.len() >= lights;
        match error {
            RenderError::Camera(error) => typed(scene.camera.is_some(), "--camera", error),
            RenderError::Number { what: "the background", found, expected } => {
                let wrong = format!("the colour is {found}; it must be {expected}");
                typed(scene.background.is_some(), "--background", &wrong)
            }
            RenderError::Shade { error: ShadeError { place, field, found, expected }, .. } => {
                let wrong = format!("{field} is {found}; it must be {expected}");
                match place {
                    // Lights that are typed stand last, ambient light first.
                    Place::Light(0) if scene.ambient.is_some() => typed(true, "--ambient", &wrong),
                    Place::Light(number) => typed(is_typed(*number), "--light", &wrong),
                    Place::Material if *field == "exponent" && shading.exponent.is_some() => {
                        typed(true, "--exponent", &wrong)
                    }
                    Place::Material => typed(scene.material.is_some(), "--material", &wrong),
                    Place::Settings => typed(scene.camera.is_some(), "--camera", &wrong),
                }
            }
            // Each for itself is in range, but not what comes of them together.
            RenderError::NotFinite { error, .. } => {
                let light = match error.light {
                    Some(number) => (is_typed(number), "--light"),
                    None => (scene.ambient.is_some(), "--ambient"),
                };
                let options = [(scene.material.is_some(), "--material"), light];
                let typed: Vec<&str> =
                    options.iter().filter(|(is_typed, _)| *is_typed).map(|&(_, option)| option).collect();
                (!typed.is_empty()).then(|| format!("{}: {error}", typed.join(" and ")))
            }
            _ => None,
        }
    }

    /// Panels are kept until they are put together, and frames cost time.
    fn check_amount(&self, size: [u32; 2]) -> Result<(), String> {
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
                "{count} {what} of {width}x{height} pixels have {pixels}; {MOST_PIXELS} is the most: take fewer or smaller ones"
            )),
            false => Ok(()),
        }
    }

    fn change_settings(&self, file: &mut SceneFile) {
        let (output, shading, colour) = (&self.args.output, &self.args.shading, &self.args.colour);
        let set = &mut file.settings;
        if !self.has_settings() {
            set.samples = Samples::Four;
        }
        set.size = output.size.unwrap_or(set.size);
        set.samples = output.samples.unwrap_or(set.samples);
        set.bits = output.bits.unwrap_or(set.bits);
        if self.file == FileKind::Gif {
            set.bits = Bits::Eight;
        }
        set.shading = shading.shading.unwrap_or(set.shading);
        set.interpolation = shading.interpolation.unwrap_or(set.interpolation);
        set.flat_sample = shading.flat_sample.unwrap_or(set.flat_sample);
        set.wire.hide = self.hides_lines(set.wire.hide);
        set.cull = shading.cull.unwrap_or(set.cull);
        set.two_sided |= shading.two_sided;
        if let Some(show) = shading.show {
            set.show = show;
            // Codes are then proportional to what is shown, as in any normal map.
            if matches!(show, Show::Normals | Show::Depth) {
                set.transfer = Transfer::Direct;
            }
        }
        set.terminator = colour.terminator.unwrap_or(set.terminator);
        set.tone = colour.tone.unwrap_or(set.tone);
        set.transfer = colour.transfer.unwrap_or(set.transfer);
        if colour.literal {
            set.guards = Guards::literal();
        }
        for switch in &colour.guard {
            let known = set.guards.set(&switch.name, switch.on);
            debug_assert!(known, "the parser knows the names");
        }
    }

    fn change_materials(&self, file: &mut SceneFile) -> Result<(), String> {
        let shading = &self.args.shading;
        let wants_given = shading.reflection == Some(ReflectionChoice::Given);
        let lacks = |object| file.mesh_of(object).is_none_or(|mesh| mesh.colours.is_none());
        if let Some(object) = (0..file.objects.len()).find(|&object| wants_given && lacks(object)) {
            let lack = "its vertices have no colours, which --reflection given shows; give it another, or the file colours";
            return Err(format!("object {}: {lack}", object + 1));
        }
        for object in &mut file.objects {
            object.material = self.args.scene.material.unwrap_or(object.material);
            object.material.exponent = shading.exponent.unwrap_or(object.material.exponent);
            match shading.reflection {
                Some(ReflectionChoice::Phong) => object.material.reflection = Reflection::Phong,
                Some(ReflectionChoice::Blinn) => object.material.reflection = Reflection::Blinn,
                Some(ReflectionChoice::Given) | None => {}
            }
            if shading.reflection.is_some() {
                object.given = wants_given;
            }
        }
        Ok(())
    }
}

/// The lights of a scene with some put in place of those that it had.
fn lights(before: &[Light], new: &[Light], ambient: Option<LinearRgb>) -> Vec<Light> {
    let is_ambient = |light: &&Light| matches!(light, Light::Ambient { .. });
    let old_ambient = before.iter().filter(|light| is_ambient(light) && ambient.is_none());
    let old = before.iter().filter(|light| !is_ambient(light) && new.is_empty());
    let ambient = ambient.map(|colour| Light::Ambient { colour });
    ambient.into_iter().chain(old_ambient.copied()).chain(old.copied()).chain(new.iter().copied()).collect()
}

fn target(args: &RenderArgs) -> Result<(Option<Target>, FileKind), String> {
    let wants_gif = args.output.turntable.is_some();
    let by_subject = if wants_gif { FileKind::Gif } else { FileKind::Png };
    let Some(path) = &args.output.output else { return Ok((None, by_subject)) };
    if path.as_os_str() == "-" {
        return Ok((Some(Target::Stdout), by_subject));
    }
    if path.is_dir() {
        return usage(format!("{} is a folder; give a file", path.display()));
    }
    let extension = path.extension().and_then(|name| name.to_str()).map(str::to_ascii_lowercase);
    let file = match extension.as_deref() {
        Some("png") if wants_gif => {
            return usage("--turntable makes a GIF; give an output that ends in .gif");
        }
        Some("png") => FileKind::Png,
        Some("gif") => FileKind::Gif,
        _ => return usage(format!("{} ends neither in .png nor in .gif", path.display())),
    };
    Ok((Some(Target::File(path.clone())), file))
}

fn usage<T>(message: impl Into<String>) -> Result<T, String> {
    Err(message.into())
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    #[test]
    fn lights_and_ambient_light_are_replaced_separately() {
        let ambient = |grey| Light::Ambient { colour: LinearRgb::grey(grey) };
        let sun = |x| Light::Directional { towards: DVec3::new(x, 0.0, 0.0), colour: LinearRgb::WHITE };
        let before = [ambient(0.1), sun(1.0), sun(2.0)];
        assert_eq!(lights(&before, &[sun(3.0)], None), [ambient(0.1), sun(3.0)]);
        assert_eq!(lights(&before, &[], Some(LinearRgb::grey(0.5))), [ambient(0.5), sun(1.0), sun(2.0)]);
        assert_eq!(lights(&before, &[sun(3.0)], Some(LinearRgb::BLACK)), [ambient(0.0), sun(3.0)]);
    }
}
