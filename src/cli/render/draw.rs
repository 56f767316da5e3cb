//! A picture, panels side by side, or an animation.

use super::changes::{about, blame, pivot, turn};
use super::request::{Request, Subject};
use super::values::{Background, FileKind, GRADIENT, Shown};
use crate::cli::common::choice::Choose;
use crate::cli::common::failure::Failure;
use crate::cli::common::output::Store;
use crate::cli::common::progress::Progress;
use crease::num::{Degrees, LinearRgb};
use crease::raster::{
    Image, RenderError, RenderScratch, RenderSettings, SceneFile, Show, Statistics, render_reusing,
};
use crease::report::{
    Animation, CutOut, Panel, Picture, ReportError, cut_out, deviation_range, encode_jpeg, encode_png,
    encode_webp, overlay, panels, show_legend,
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

pub fn draw(
    file: &mut SceneFile,
    request: &Request,
    progress: &Progress,
    scratch: &mut RenderScratch,
) -> Result<Drawn, Failure> {
    match request.subject {
        Subject::Picture => {
            let image = image(file, &file.settings, request, scratch)?;
            let drawings = vec![Drawing { name: None, statistics: image.statistics }];
            if request.target.is_none() {
                let size = image.size;
                return Ok(Drawn { image: Some(image), ..Drawn::of_bytes(Vec::new(), size, drawings, None) });
            }
            let settings = file.settings;
            let cut = finished(image.clone(), file, &settings, request, scratch)?;
            let opacity = Some(&*cut.opacity).filter(|opacity| !opacity.is_empty());
            let bytes = as_file(&cut.picture, opacity, &file.settings, request.file)?;
            Ok(Drawn::of_bytes(bytes, cut.picture.size, drawings, Some(image)))
        }
        Subject::Panels(variants) => {
            let (mut drawings, mut list) = (Vec::new(), Vec::new());
            for variant in variants {
                let settings = variant.settings(&file.settings);
                let image = image(file, &settings, request, scratch)?;
                drawings.push(Drawing { name: Some(variant.choice().into()), statistics: image.statistics });
                let picture = finished(image, file, &settings, request, scratch)?.picture;
                list.push(Panel { caption: variant.caption().into(), picture });
            }
            let sheet = panels(&list)?;
            drop(list);
            let bytes = as_file(&sheet, None, &file.settings, request.file)?;
            Ok(Drawn::of_bytes(bytes, sheet.size, drawings, None))
        }
        Subject::Turntable(frames) => turntable(file, frames, request, progress, scratch),
    }
}

fn image(
    file: &SceneFile,
    settings: &RenderSettings,
    request: &Request,
    scratch: &mut RenderScratch,
) -> Result<Image, Failure> {
    let mut scene = file.scene();
    let kinds = &request.args.shading.overlay;
    let mut lines: Vec<_> = kinds.iter().flat_map(|&kind| overlay(&scene, settings.size, kind)).collect();
    for lines in &mut lines {
        lines.style.hide = request.hides_lines(lines.style.hide);
    }
    scene.lines.extend(lines);
    render_reusing(&scene, settings, scratch).map_err(|error| {
        let lights = file.lights.as_ref().map_or(0, Vec::len);
        let of_input = |error: RenderError| match error {
            RenderError::Lacks { .. } => Failure::advised(error),
            error => Failure::input(error),
        };
        blame(request.args, &error, lights).map_or_else(|| of_input(error), Failure::usage)
    })
}

/// An image with the background and the legend that were asked for. Only a transparent background has opacities.
fn finished(
    image: Image,
    file: &mut SceneFile,
    settings: &RenderSettings,
    request: &Request,
    scratch: &mut RenderScratch,
) -> Result<CutOut, Failure> {
    let mut cut = CutOut { picture: Picture::from(image), opacity: Vec::new() };
    if let Some(background @ (Background::Transparent | Background::Gradient)) = request.args.scene.background
    {
        let black = std::mem::replace(&mut file.background, LinearRgb::WHITE);
        let on_white = self::image(file, settings, request, scratch);
        file.background = black;
        cut = cut_out(cut.picture, &on_white?.into(), settings.transfer);
        if background == Background::Gradient {
            cut = CutOut { picture: cut.over(GRADIENT, settings.transfer), opacity: Vec::new() };
        }
    }
    let is_fitted = request.args.shading.show == Some(Shown::FittedDeviation);
    let legend = show_legend(&file.scene(), settings, is_fitted);
    if let Some(legend) = legend.filter(|_| !request.args.shading.no_legend) {
        cut.picture = legend.below(&cut.picture);
        let [width, height] = cut.picture.size.map(|side| side as usize);
        if !cut.opacity.is_empty() {
            cut.opacity.resize(width * height, 1.0);
        }
    }
    Ok(cut)
}

/// Sets the range of fitted deviations to one that holds all of a picture, or of eight positions of a turntable.
pub fn fit_deviation(file: &mut SceneFile, request: &Request) -> Result<(), Failure> {
    if request.args.shading.show != Some(Shown::FittedDeviation) {
        return Ok(());
    }
    let positions = if matches!(request.subject, Subject::Turntable(_)) { 8 } else { 1 };
    let (pivot, up) = (pivot(file), file.scene().camera.up);
    let placed: Vec<_> = file.objects.iter().map(|object| object.transform).collect();
    let mut largest = Degrees(0.0);
    for position in 0..positions {
        turn(file, about(up, Degrees(360.0 / f64::from(positions) * f64::from(position))), pivot);
        let range = deviation_range(&file.scene(), &file.settings);
        file.objects.iter_mut().zip(&placed).for_each(|(object, &transform)| object.transform = transform);
        // What cannot be drawn is reported when it is drawn.
        largest.0 = largest.0.max(range.map_or(0.0, |range| range.0));
    }
    file.settings.show = Show::Deviation(if largest.0 > 0.0 { largest } else { Degrees(180.0) });
    Ok(())
}

fn as_file(
    picture: &Picture,
    opacity: Option<&[f32]>,
    settings: &RenderSettings,
    kind: FileKind,
) -> Result<Vec<u8>, ReportError> {
    match kind {
        FileKind::Png => encode_png(picture, opacity, settings.transfer),
        FileKind::WebP => encode_webp(picture, opacity),
        // The other formats have no transparent background: that is refused before.
        FileKind::Jpeg => encode_jpeg(picture),
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
    scratch: &mut RenderScratch,
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
        let image = image(file, &file.settings, request, scratch)?;
        // Some frames are asked for twice.
        if frame == drawings.len() {
            drawings.push(Drawing { name: Some(format!("{}°", angle.0)), statistics: image.statistics });
        }
        let settings = file.settings;
        let picture = finished(image, file, &settings, request, scratch)?.picture;
        progress.done();
        Ok(picture)
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
