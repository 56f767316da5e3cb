//! The comparison of two files: pictures side by side, and the numbers.

use super::markers::HeatScale;
use super::model::{Model, OVERVIEW};
use super::texts::Texts;
use super::view_choice::hidden;
use crate::io::Loaded;
use crate::num::{AngleErrors, three_digits};
use crate::quality::{Comparison, Site, Survey};
use crate::raster::Camera;
use crate::report::error::Result;
use crate::report::html::Page;
use crate::report::picture::Picture;
use crate::report::table::Table;
use crate::text::Value;

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
    texts: Texts,
) -> Result<()> {
    let comparison = after.comparison;
    page.heading(&texts.get("before-and-after"));
    page.paragraph(&numbers(after.name, comparison, texts));
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
    let (marked, _) = change.deviation("", camera, OVERVIEW, &worst, texts)?;
    let scaled = |key, scale: HeatScale| texts.with(key, &[("scale", scale.words(texts).into())]);
    let pictures: [(&Picture, &str); 3] = [
        (&lit[0], &texts.get("lit-before")),
        (&lit[1], &texts.get("lit-after")),
        (&marked, &scaled("changed", change.scale)),
    ];
    page.pictures(&pictures, &texts.get("lit-caption"))?;
    let off = [
        before.deviation("", camera, OVERVIEW, &[], texts)?.0,
        then.deviation("", camera, OVERVIEW, &[], texts)?.0,
    ];
    let pictures: [(&Picture, &str); 2] =
        [(&off[0], &scaled("off-before", before.scale)), (&off[1], &scaled("off-after", before.scale))];
    page.pictures(&pictures, &texts.get("off-caption"))?;
    let mut table = Table::new(
        &texts.get("findings-before-and-after"),
        &texts.each(["column-finding", "column-before", "column-after"]),
    );
    for (kind, counts) in &comparison.findings {
        table.push([kind.id().to_owned(), counts[0].to_string(), counts[1].to_string()]);
    }
    if !table.is_empty() {
        page.table(&table);
    }
    Ok(())
}

fn numbers(name: &str, comparison: &Comparison, texts: Texts) -> String {
    let AngleErrors { mean, rms, median, p95, p99, .. } = comparison.angles;
    let largest = comparison.largest.0;
    let [mean_steps, largest_steps] = comparison.steps().map(|steps| Value::digits(&three_digits(steps)));
    let Comparison { corners, changed, visible, gained, lost, turned, unmatched: [here, there], .. } =
        comparison;
    let counts = [
        ("changed", changed),
        ("corners", corners),
        ("visible", visible),
        ("gained", gained),
        ("lost", lost),
        ("turned", turned),
    ];
    let counts = counts.map(|(key, count)| (key, Value::from(count.to_string())));
    let faces = if (*here, *there) == (0, 0) { "same-faces" } else { "other-faces" };
    let faces = texts.with(faces, &[("here", here.to_string().into()), ("there", there.to_string().into())]);
    let angles = [
        ("faces", faces.into()),
        ("name", name.into()),
        ("mean-steps", mean_steps),
        ("largest-steps", largest_steps),
    ];
    let sizes =
        [("mean", mean), ("rms", rms), ("median", median), ("p95", p95), ("p99", p99), ("largest", largest)];
    let sizes = sizes.map(|(key, angle)| (key, Value::digits(&three_digits(angle))));
    texts.with("numbers", &[&counts[..], &angles, &sizes].concat())
}
