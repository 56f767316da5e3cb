//! A picture, panels side by side, or an animation.

use super::changes::{about, blame, pivot, turn};
use super::request::{Request, Subject};
use super::values::FileKind;
use crate::cli::common::choice::Choose;
use crate::cli::common::failure::Failure;
use crate::cli::common::output::Store;
use crate::cli::common::progress::Progress;
use crease::num::Degrees;
use crease::raster::{Image, RenderError, RenderSettings, SceneFile, Statistics, render};
use crease::report::{
    Animation, Panel, Picture, ReportError, encode_jpeg, encode_png, encode_webp, overlay, panels,
};

/// A picture as a file, and what was drawn for it.
pub struct Drawn {
    /// The file, unless it is stored already or none is wanted.
    pub bytes: Option<Vec<u8>>,
    pub length: u64,
    pub size: [u32; 2],
    pub drawings: Vec<Drawing>,
    pub image: Option<Image>,
}

impl Drawn {
    fn of_bytes(bytes: Vec<u8>, size: [u32; 2], drawings: Vec<Drawing>, image: Option<Image>) -> Self {
        Self { length: bytes.len() as u64, bytes: Some(bytes), size, drawings, image }
    }
}

#[derive(serde::Serialize)]
pub struct Drawing {
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    #[serde(flatten)]
    pub statistics: Statistics,
}

pub fn draw(file: &mut SceneFile, request: &Request, progress: &Progress) -> Result<Drawn, Failure> {
    match request.subject {
        Subject::Picture => {
            let image = image(file, &file.settings, request)?;
            let drawings = vec![Drawing { name: None, statistics: image.statistics }];
            let picture = Picture { size: image.size, pixels: image.pixels };
            let bytes = match request.target {
                Some(_) => as_file(&picture, &file.settings, request.file)?,
                None => Vec::new(),
            };
            let image = Image { pixels: picture.pixels, ..image };
            Ok(Drawn::of_bytes(bytes, image.size, drawings, Some(image)))
        }
        Subject::Panels(variants) => {
            let (mut drawings, mut list) = (Vec::new(), Vec::new());
            for variant in variants {
                let settings = variant.settings(&file.settings);
                let image = image(file, &settings, request)?;
                drawings.push(Drawing { name: Some(variant.choice().into()), statistics: image.statistics });
                list.push(Panel { caption: variant.caption().into(), picture: image.into() });
            }
            let sheet = panels(&list)?;
            drop(list);
            let bytes = as_file(&sheet, &file.settings, request.file)?;
            Ok(Drawn::of_bytes(bytes, sheet.size, drawings, None))
        }
        Subject::Turntable(frames) => turntable(file, frames, request, progress),
    }
}

fn image(file: &SceneFile, settings: &RenderSettings, request: &Request) -> Result<Image, Failure> {
    let mut scene = file.scene();
    let kinds = &request.args.shading.overlay;
    let mut lines: Vec<_> = kinds.iter().flat_map(|&kind| overlay(&scene, settings.size, kind)).collect();
    for lines in &mut lines {
        lines.style.hide = request.hides_lines(lines.style.hide);
    }
    scene.lines.extend(lines);
    render(&scene, settings).map_err(|error| {
        let lights = file.lights.as_ref().map_or(0, Vec::len);
        let of_input = |error: RenderError| match error {
            RenderError::Lacks { .. } => Failure::advised(error),
            error => Failure::input(error),
        };
        blame(request.args, &error, lights).map_or_else(|| of_input(error), Failure::usage)
    })
}

fn as_file(picture: &Picture, settings: &RenderSettings, kind: FileKind) -> Result<Vec<u8>, ReportError> {
    match kind {
        FileKind::Png => encode_png(picture, settings.transfer),
        FileKind::Jpeg => encode_jpeg(picture),
        FileKind::WebP => encode_webp(picture),
        FileKind::Gif => {
            let mut bytes = Vec::new();
            Animation::STILL.write_gif(&mut bytes, |_| Ok::<_, ReportError>(picture.clone()))?;
            Ok(bytes)
        }
    }
}

/// Hundredths of a second that a whole turn takes, and the shortest frame that viewers play.
const TURN: u16 = 400;
const SHORTEST: u16 = 2;

pub fn turn_of(frames: u16) -> Animation {
    Animation { frames: frames.into(), hundredths: (TURN / frames).max(SHORTEST) }
}

/// Draws frame by frame into the output: neither all frames nor the file are ever in memory.
fn turntable(
    file: &mut SceneFile,
    frames: u16,
    request: &Request,
    progress: &Progress,
) -> Result<Drawn, Failure> {
    let pivot = pivot(file);
    let placed: Vec<_> = file.objects.iter().map(|object| object.transform).collect();
    let up = file.scene().camera.up;
    let size = file.settings.size;
    let mut drawings = Vec::new();
    let mut draw = |frame: usize| -> Result<Picture, Failure> {
        let angle = Degrees(360.0 * frame as f64 / f64::from(frames));
        // Each frame turns from the start: roundings do not add up.
        file.objects.iter_mut().zip(&placed).for_each(|(object, &transform)| object.transform = transform);
        turn(file, about(up, angle), pivot);
        let image = image(file, &file.settings, request)?;
        // Some frames are asked for twice.
        if frame == drawings.len() {
            drawings.push(Drawing { name: Some(format!("{}°", angle.0)), statistics: image.statistics });
        }
        progress.done();
        Ok(image.into())
    };
    let length = match &request.target {
        Some(target) => Store::default().stream(target, |out| turn_of(frames).write_gif(out, draw))?,
        None => {
            (0..usize::from(frames)).try_for_each(|frame| draw(frame).map(drop))?;
            0
        }
    };
    Ok(Drawn { bytes: None, length, size, drawings, image: None })
}
