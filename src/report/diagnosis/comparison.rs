//! The comparison of two files: pictures side by side, and the numbers.

use super::heat_scale::HeatScale;
use super::model::{Model, OVERVIEW};
use super::view_choice::hidden;
use crate::io::Loaded;
use crate::num::three_digits;
use crate::quality::{Comparison, Site, Survey};
use crate::raster::Camera;
use crate::report::error::ReportError;
use crate::report::html::Page;
use crate::report::picture::Picture;
use crate::report::table::Table;

/// A file after a change, with its comparison.
#[derive(Clone, Copy, Debug)]
pub struct After<'a> {
    /// The name of the file.
    pub name: &'a str,
    /// The file.
    pub loaded: &'a Loaded,
    /// The differences.
    pub comparison: &'a Comparison,
}

/// Pictures of both files from one side, what changed as colours, and the numbers.
pub(super) fn section(
    page: &mut Page,
    before: &Model,
    after: After<'_>,
    surveys: &[Survey],
    camera: Camera,
) -> Result<(), ReportError> {
    let comparison = after.comparison;
    page.heading("Before and after");
    page.paragraph(&words(after.name, comparison));
    let changes = surveys.iter().zip(&comparison.change);
    let changed = |change: &[f64]| change.iter().copied().map(Some).collect();
    let changes: Vec<Survey> =
        changes.map(|(survey, change)| Survey { deviations: changed(change), ..survey.clone() }).collect();
    let then = Model::new(after.loaded, surveys, before.scale)?;
    let change = Model::new(after.loaded, &changes, HeatScale::of(changes.iter()))?;
    let places: Vec<&Site> = comparison.places.iter().collect();
    let mut seen =
        places.iter().zip(hidden(&change, &places, camera.eye)).filter(|(_, is_hidden)| !is_hidden);
    let worst: Vec<&Site> = seen.next().map(|(site, _)| *site).into_iter().collect();
    let lit = [before.lit(camera, OVERVIEW)?, then.lit(camera, OVERVIEW)?];
    let (marked, _) = change.deviation(camera, OVERVIEW, &worst)?;
    let pictures: [(&Picture, &str); 3] = [
        (&lit[0], "the mesh lit with the normals that it had before"),
        (&lit[1], "the mesh lit with the normals that it has after"),
        (&marked, &format!("the mesh coloured by how far its normals changed, {}", change.scale.words())),
    ];
    let caption = "Left: before. Middle: after. Right: by how much the normals of each corner changed; a ring marks \
                   the place that changed most of those that are seen.";
    page.pictures(&pictures, caption)?;
    let off = [before.deviation(camera, OVERVIEW, &[])?.0, then.deviation(camera, OVERVIEW, &[])?.0];
    let words = ["before", "after"].map(|when| {
        let scale = before.scale.words();
        format!("{when}: the mesh coloured by the deviation of its normals from the rule that they follow, {scale}")
    });
    let pictures: [(&Picture, &str); 2] = [(&off[0], &words[0]), (&off[1], &words[1])];
    page.pictures(
        &pictures,
        "How far normals are from those that the rule of their own mesh gives, before and after.",
    )?;
    let mut table = Table::new("Findings, before and after", &["finding", "before", "after"]);
    for (kind, counts) in &comparison.findings {
        table.push([kind.id().to_owned(), counts[0].to_string(), counts[1].to_string()]);
    }
    if !table.is_empty() {
        page.table(&table);
    }
    Ok(())
}

fn words(name: &str, comparison: &Comparison) -> String {
    let [mean, largest] = [comparison.mean, comparison.largest].map(|angle| three_digits(angle.0));
    let [mean_steps, largest_steps] = comparison.steps().map(three_digits);
    let Comparison { corners, changed, visible, gained, lost, turned, unmatched: [here, there], .. } =
        comparison;
    let added = match (here, there) {
        (0, 0) => "no faces were added or removed".to_owned(),
        _ => format!("{here} faces were removed, {there} added"),
    };
    format!(
        "In {name}, {changed} of {corners} corners have another direction, {visible} of them visibly: by {largest}° at most \
         ({largest_steps} of 255 grey steps under a key light) and {mean}° in the mean ({mean_steps} steps). {gained} corners \
         gained a normal and {lost} lost one. {turned} faces have reversed winding, and {added}."
    )
}
