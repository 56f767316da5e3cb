//! Files of experiments: pages, pictures, plots, animations.

use crate::cli::common::console::Console;
use crate::cli::common::failure::Failure;
use crate::cli::common::output::Target;
use crate::cli::common::progress::Progress;
use crate::cli::render::draw::turn_of;
use crease::artefact::{Experiment, Language, Outcome, Setup};
use crease::num::Transfer;
use crease::report::{
    Picture, ReportError, chart_plot, encode_png, experiment_page, experiment_sheet, index_page, page_name,
    picture_name, svg_file,
};
use rayon::prelude::*;
use std::path::Path;

/// One experiment, run.
pub struct Run<'a> {
    pub experiment: &'static Experiment,
    pub setup: Setup<'a>,
    pub outcome: Outcome,
    pub seconds: f64,
}

/// A file's name in the folder, and its bytes.
type File = (String, Vec<u8>);

/// Writes the files of some runs into a folder, with an index if there are several; returns the paths, run by run.
pub fn write_all(runs: &[Run], folder: &Path, language: Language) -> Result<Vec<Vec<String>>, Failure> {
    let in_gallery = runs.len() > 1;
    let files = |run: &Run| files(run, language, in_gallery);
    let made: Result<Vec<Vec<File>>, ReportError> = runs.par_iter().with_max_len(1).map(files).collect();
    let mut stored = Vec::new();
    for files in made? {
        let mut paths = Vec::new();
        for (name, bytes) in files {
            paths.push(Target::File(folder.join(name)).store(bytes)?);
        }
        stored.push(paths);
    }
    if in_gallery {
        let found: Vec<_> = runs.iter().map(|run| (run.experiment, &run.outcome)).collect();
        let index = index_page(&found, language)?;
        Target::File(folder.join("index.html")).store(index.into_bytes())?;
    }
    Ok(stored)
}

fn files(run: &Run, language: Language, in_gallery: bool) -> Result<Vec<File>, ReportError> {
    let Run { experiment, setup, outcome, .. } = run;
    let page = experiment_page(experiment, setup, outcome, language, in_gallery)?;
    let sheet = encode_png(&experiment_sheet(outcome, language)?, None, Transfer::Srgb)?;
    let mut files =
        vec![(page_name(experiment), page.into_bytes()), (format!("{}.png", experiment.id), sheet)];
    for shot in &outcome.shots {
        let picture = Picture::from(shot.image.clone());
        let name = format!("{}.png", picture_name(experiment, shot.name));
        files.push((name, encode_png(&picture, None, Transfer::Srgb)?));
    }
    for chart in &outcome.charts {
        let svg = svg_file(&chart_plot(chart, language).svg(chart.name));
        files.push((format!("{}.svg", picture_name(experiment, chart.name)), svg.into_bytes()));
    }
    Ok(files)
}

pub fn animate(run: &Run, path: &Path, frames: u16, console: &Console) -> Result<String, Failure> {
    let progress = Progress::of_count(console, "drawing", "frames", frames.into());
    let draw = |number: u32| {
        let image = run.experiment.frame(&run.setup, number, frames.into());
        progress.done();
        image.map_err(Failure::input)
    };
    let images: Vec<_> = (0..u32::from(frames)).into_par_iter().map(draw).collect::<Result<_, _>>()?;
    drop(progress);
    let animation = turn_of(frames);
    let mut bytes = Vec::new();
    animation.write_gif(&mut bytes, |number| Ok::<_, ReportError>(Picture::from(images[number].clone())))?;
    Ok(Target::File(path.to_owned()).store(bytes)?)
}
