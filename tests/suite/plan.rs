//! The cheapest model of a scene: known answers, all combinations of small scenes, pictures compared without `plan`, and requests
//! that cannot be met.

mod answers;
mod applied;
mod comparisons;
mod exhaustive;
mod lights;
mod pictures;
mod random_scenes;
mod requests;

use crease::plan::{Axis, Plan, PlanOptions, plan};
use crease::raster::{Image, LoadOptions, RenderSettings, SceneFile, render};
use crease::shade::ToneRule;
use std::path::Path;

/// Options that leave only some axes open.
fn only(axes: &[Axis], tolerance: f64) -> PlanOptions {
    let keep = Axis::ALL.into_iter().filter(|axis| !axes.contains(axis)).collect();
    PlanOptions { tolerance, keep, ..PlanOptions::default() }
}

/// The plan of a scene that refers to no file.
fn planned(text: &str, options: &PlanOptions) -> Plan {
    plan(text, Path::new(""), &LoadOptions::default(), options, &|_| ())
        .unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// What a plan changes an axis to; `None` if the axis is as declared.
fn change(plan: &Plan, axis: Axis) -> Option<&str> {
    plan.decisions.iter().find(|decision| decision.axis == axis).map(|decision| decision.to.as_str())
}

fn scene(text: &str) -> SceneFile {
    scene_in(text, Path::new(""))
}

fn scene_in(text: &str, folder: &Path) -> SceneFile {
    SceneFile::from_toml(text, folder, &LoadOptions::default())
        .unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// A picture with its linear colours and objects.
fn drawn(file: &SceneFile) -> Image {
    render(&file.scene(), &RenderSettings { keep_linear: true, keep_objects: true, ..file.settings }).unwrap()
}

/// The curve of sRGB (IEC 61966-2-1), from 0 to 1.
fn srgb(linear: f64) -> f64 {
    let linear = linear.clamp(0.0, 1.0);
    if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * libm::pow(linear, 1.0 / 2.4) - 0.055 }
}

/// The encoded values of a pixel from 0 to 255, before they are rounded.
fn codes(colour: [f32; 3], settings: &RenderSettings) -> [f64; 3] {
    let linear = colour.map(f64::from);
    let largest = linear.iter().copied().fold(0.0, f64::max);
    let divisor = if settings.tone == ToneRule::DivideByMax && largest > 1.0 { largest } else { 1.0 };
    linear.map(|component| {
        let component = (component / divisor).clamp(0.0, 1.0);
        255.0 * if settings.transfer == crease::num::Transfer::Srgb { srgb(component) } else { component }
    })
}

/// The difference of each pixel at which two pictures show the same objects.
fn differences(truth: &Image, other: &Image, settings: &RenderSettings) -> Vec<f64> {
    let (ours, theirs) = (truth.linear.as_ref().unwrap(), other.linear.as_ref().unwrap());
    let (shown, shown_there) = (truth.objects.as_ref().unwrap(), other.objects.as_ref().unwrap());
    (0..ours.len())
        .filter(|&pixel| shown[pixel] == shown_there[pixel])
        .map(|pixel| {
            let (a, b) = (codes(ours[pixel], settings), codes(theirs[pixel], settings));
            (0..3).map(|channel| (a[channel] - b[channel]).abs()).fold(0.0, f64::max)
        })
        .collect()
}

/// The largest difference of two scenes, in steps of 1/255.
fn steps(declared: &SceneFile, planned: &SceneFile) -> f64 {
    let (truth, other) = (drawn(declared), drawn(planned));
    differences(&truth, &other, &declared.settings).into_iter().fold(0.0, f64::max)
}

/// Where a condition that holds at `low` and not at `high` changes, to a thousandth.
fn switch(mut low: f64, mut high: f64, holds: impl Fn(f64) -> bool) -> f64 {
    assert!(holds(low) && !holds(high), "no change between {low} and {high}");
    while high / low > 1.001 {
        let middle = (low * high).sqrt();
        if holds(middle) { low = middle } else { high = middle }
    }
    (low * high).sqrt()
}

fn assert_near(value: f64, expected: f64, share: f64) {
    assert!((value - expected).abs() <= share * expected.abs(), "{value}, expected {expected}");
}
