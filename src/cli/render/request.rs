//! What was typed after `render`, made into what shall be done.

use super::args::{ReflectionChoice, RenderArgs, Variant};
use super::turn;
use crate::cli::inputs::Source;
use crate::cli::request::Target;
use crease::io::{Format, ReadOptions};
use crease::normals::{Crease, NormalRecipe};
use crease::num::{LinearRgb, Transfer};
use crease::raster::{Bits, LoadOptions, Samples, SceneFile, Shading, Show, default_lights, rotation};
use crease::shade::{Guards, Light, Reflection};
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

/// Most pixels of all frames or panels together, as many as the largest single picture has.
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
            && input
                .canonicalize()
                .is_ok_and(|input| output.canonicalize().is_ok_and(|output| input == output))
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
                    weight: args.normals.weight,
                    crease: args.normals.crease.map_or(Crease::Default, Crease::Angle),
                    ..NormalRecipe::default()
                },
                when: args.normals.when,
                read: ReadOptions { root: args.output.root.clone(), ..ReadOptions::default() },
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
        Ok(())
    }

    /// Whether the input is a scene with settings of its own.
    pub fn has_settings(&self) -> bool {
        let is_toml = |path: &Path| path.extension().is_some_and(|name| name.eq_ignore_ascii_case("toml"));
        matches!(&self.source, Source::File(path) if is_toml(path)) && self.format.is_none()
    }

    /// Changes a scene as asked.
    ///
    /// # Errors
    /// What the scene lacks.
    pub fn change(&self, file: &mut SceneFile) -> Result<(), String> {
        self.change_settings(file);
        self.check_amount(file.settings.size)?;
        if self.args.output.probe.is_some() && file.settings.shading == Shading::Wireframe {
            return Err(
                "--probe tells how colours come about, and a wireframe has none: give another --shading"
                    .into(),
            );
        }
        self.change_materials(file)?;
        let scene = &self.args.scene;
        file.background = scene.background.unwrap_or(file.background);
        if let Some(degrees) = scene.rotate {
            let pivot = turn::pivot(file);
            turn::turn(file, rotation(degrees), pivot);
        }
        // From here on the camera stays where it is, whatever turns.
        let camera = match self.subject {
            Subject::Turntable(_) => turn::camera(file),
            _ => file.scene().camera,
        };
        let camera = scene.camera.map_or(camera, |change| change.apply(&camera));
        file.camera = Some(camera);
        if !scene.light.is_empty() || scene.ambient.is_some() {
            let before = file.lights.take().unwrap_or_else(|| default_lights(&camera).to_vec());
            file.lights = Some(lights(&before, &scene.light, scene.ambient));
        }
        Ok(())
    }

    /// All frames are kept until their palette is known, and all panels until they are put together.
    fn check_amount(&self, size: [u32; 2]) -> Result<(), String> {
        let (count, what) = match self.subject {
            Subject::Picture => return Ok(()),
            Subject::Panels(variants) => (variants.len(), "panels"),
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
        set.cull = shading.cull.unwrap_or(set.cull);
        set.two_sided |= shading.two_sided;
        if let Some(show) = shading.show {
            set.show = show;
            // Codes are then proportional to what is shown, as in any normal map.
            if matches!(show, Show::Normals | Show::Depth) {
                set.transfer = Transfer::Direct;
            }
        }
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
            let lack = "its vertices have no colours, which --reflection given shows";
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
    fn lights_and_ambient_light_are_replaced_apart() {
        let ambient = |grey| Light::Ambient { colour: LinearRgb::grey(grey) };
        let sun = |x| Light::Directional { towards: DVec3::new(x, 0.0, 0.0), colour: LinearRgb::WHITE };
        let before = [ambient(0.1), sun(1.0), sun(2.0)];
        assert_eq!(lights(&before, &[sun(3.0)], None), [ambient(0.1), sun(3.0)]);
        assert_eq!(lights(&before, &[], Some(LinearRgb::grey(0.5))), [ambient(0.5), sun(1.0), sun(2.0)]);
        assert_eq!(lights(&before, &[sun(3.0)], Some(LinearRgb::BLACK)), [ambient(0.0), sun(3.0)]);
    }
}
