//! The exercises of the lectures, and the same with random numbers: their scenes, statements, answers and ways.

// The list of exercises.
mod list;
// Random numbers in place of the printed ones.
mod random;
// The givens of an exercise, from its scene.
mod statement;

use crate::laboratory::Result;
use crate::pictures::{draw_scene, probe_scene, rgba};
use crease::raster::{FlatSample, LoadOptions, SceneFile, Shading};
use crease::shade::Reflection;
use list::{Change, EXERCISES, Exercise};
use serde_json::{Value, json};
use std::path::Path;

pub(crate) fn list() -> Value {
    json!(
        EXERCISES
            .iter()
            .map(|exercise| json!({ "id": exercise.id, "scene": exercise.scene }))
            .collect::<Vec<_>>()
    )
}

fn find(id: &str) -> Result<&'static Exercise> {
    EXERCISES
        .iter()
        .find(|exercise| exercise.id == id)
        .ok_or_else(|| format!("no exercise has the name {id:?}"))
}

/// The scene of an exercise, with the numbers of the lectures or random ones.
fn scene_of(exercise: &Exercise, seed: Option<u32>) -> Result<SceneFile> {
    let read = SceneFile::from_toml(exercise.text, Path::new("."), &LoadOptions::default());
    let mut file = read.map_err(|error| format!("{}: {error}", exercise.scene))?;
    match exercise.change {
        Change::None => {}
        Change::Blinn => {
            file.objects.iter_mut().for_each(|object| object.material.reflection = Reflection::Blinn);
        }
        Change::Flat => {
            file.settings.shading = Shading::Flat;
            file.settings.flat_sample = FlatSample::VertexMean;
        }
    }
    if let Some(seed) = seed {
        random::vary(&mut file, seed);
    }
    Ok(file)
}

/// The colour that is asked for, and the numbers of the pixel.
fn solution(exercise: &Exercise, file: &SceneFile) -> Result<([f64; 3], Value)> {
    let probe = probe_scene(&file.scene(), &file.settings, exercise.pixel, 1.0)?;
    let linear = &probe["report"]["linear"];
    let colour = [0, 1, 2].map(|k| linear[k].as_f64().unwrap_or(f64::NAN));
    Ok((colour, probe))
}

/// The givens, and a picture of the scene as a buffer.
pub(crate) fn statement(id: &str, seed: Option<u32>) -> Result {
    let exercise = find(id)?;
    let file = scene_of(exercise, seed)?;
    let (_, probe) = solution(exercise, &file)?;
    let image = draw_scene(&file.scene(), &file.settings)?;
    let answer = json!({
        "id": id,
        "givens": statement::givens(&file, &probe),
        "given_colours": file.objects.first().is_some_and(|object| object.given),
        "decimals": exercise.decimals,
        "pixel": exercise.pixel,
        "size": image.size,
        "command": exercise.command(),
    });
    Ok((answer, vec![rgba(&image)]))
}

/// Whether each number is right to the printed digits, the right numbers, and the way as the terms of the probe. The lectures cut
/// off some digits rather than round them: a number is right within one unit of the last printed digit.
pub(crate) fn check(id: &str, seed: Option<u32>, answer: [f64; 3]) -> Result<Value> {
    let exercise = find(id)?;
    let file = scene_of(exercise, seed)?;
    let (colour, probe) = solution(exercise, &file)?;
    let tolerance = libm::pow(10.0, -f64::from(exercise.decimals)) * (1.0 + 1e-9);
    let right = [0, 1, 2].map(|k| (answer[k] - colour[k]).abs() <= tolerance);
    let cosine = match file.objects.first().map(|object| object.material.reflection) {
        Some(Reflection::Phong) => "V·R",
        _ => "N·H",
    };
    Ok(json!({
        "right": right, "colour": colour, "tolerance": tolerance, "way": probe["text"], "report": probe["report"],
        "cosine_of": cosine, "arrows": probe["arrows"],
    }))
}
