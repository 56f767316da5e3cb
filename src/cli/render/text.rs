//! The report of `crease render` as text.

use super::draw::Drawing;
use super::json::{Report, SceneReport};
use super::request::FileKind;
use crate::cli::common::choice::Choose;
use crate::cli::common::console::{Style, escaped};
use crate::cli::common::numbers::{count, count_of, row, seconds, size};
use std::fmt::Write;

/// More drawings than this are reported in one line.
const EACH: usize = 8;

pub fn block(report: &Report, style: Style) -> String {
    let mut out = style.paint(Style::BOLD, &escaped(&report.input.path));
    if let Some(output) = &report.output {
        let _ = write!(out, " -> {}", style.paint(Style::BOLD, &escaped(&output.path)));
    }
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
        let format = match output.format {
            FileKind::Png => "png",
            FileKind::Gif => "gif",
        };
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
