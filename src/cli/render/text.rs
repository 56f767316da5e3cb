//! The report for people.

use super::report::{DrawingReport, Report, SceneReport};
use crate::cli::console::{Style, escaped};
use crate::cli::text::{count, count_of, size};
use std::fmt::Write;

/// More drawings than this are told in one line.
const EACH: usize = 8;

/// One picture in full.
pub fn block(report: &Report, style: Style) -> String {
    let mut out = style.paint(Style::BOLD, &escaped(&report.input.path));
    if let Some(output) = &report.output {
        let _ = write!(out, " -> {}", style.paint(Style::BOLD, &escaped(&output.path)));
    }
    out.push('\n');
    let mut row = |name: &str, text: String| {
        let _ = writeln!(out, "  {name:<9}{text}");
    };
    if let Some(scene) = &report.scene {
        row("scene", of_scene(scene));
    }
    if let Some(settings) = &report.settings {
        let samples = count(settings.samples, "sample");
        row(
            "settings",
            format!("{} shading, {} interpolation, {samples}", settings.shading, settings.interpolation),
        );
    }
    match &report.drawings[..] {
        drawings @ [_, ..] if drawings.len() <= EACH => {
            drawings.iter().for_each(|drawing| row("drawn", of_drawing(drawing)));
        }
        drawings => row("drawn", count(drawings.len(), "frame")),
    }
    if let (Some(output), Some(settings)) = (&report.output, &report.settings) {
        let bytes = size(output.bytes);
        let (width, height) = (output.width, output.height);
        row(
            "output",
            format!(
                "{}, {width}x{height}, {} bits, {}, {bytes}",
                output.format, settings.bits, settings.transfer
            ),
        );
    }
    let seconds = &report.seconds;
    let stages = format!("load {:.3}, draw {:.3}, write {:.3}", seconds.load, seconds.draw, seconds.write);
    row("time", format!("{:.3} s ({stages})", seconds.total));
    out
}

fn of_scene(scene: &SceneReport) -> String {
    let lights: Vec<&str> = scene.lights.clone();
    let lights = if lights.is_empty() { "no light".into() } else { format!("{} light", lights.join(", ")) };
    let vertices = count_of(scene.vertices, "vertex", "vertices");
    format!("{}, {vertices}, {}; {lights}", count(scene.objects, "object"), count(scene.faces, "face"))
}

fn of_drawing(drawing: &DrawingReport) -> String {
    let name = drawing.name.as_ref().map(|name| format!("{name}: ")).unwrap_or_default();
    let triangles = count(drawing.triangles_drawn as usize, "triangle");
    let pixels = count(drawing.covered_pixels as usize, "pixel");
    let (clipped, culled) = (drawing.triangles_clipped, drawing.triangles_culled);
    format!("{name}{triangles} ({clipped} clipped), {culled} left out; {pixels} covered")
}
