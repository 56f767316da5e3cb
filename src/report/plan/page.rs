//! The page of a plan, and its pictures in one. Its texts are in page.en.ftl and page.pt.ftl.

use super::decisions::{axis, cost, difference, name_of, sentence, text, value, what};
use super::tried::tried_plot;
use crate::num::six_digits;
use crate::plan::{Comparison, Evidence, Metric, Minimise, Place, Plan, Refusal};
use crate::raster::{Image, Pixels};
use crate::report::error::Result;
use crate::report::html::{Page, image};
use crate::report::panel::{Panel, panels};
use crate::report::picture::Picture;
use crate::report::table::Table;
use crate::text::{Language, Value};
use maud::{PreEscaped, html};

/// What the page of a plan is about.
#[derive(Clone, Copy, Debug)]
pub struct PlanPage<'a> {
    /// The name of the scene file.
    pub scene: &'a str,
    /// The command that plans it again.
    pub command: &'a str,
    /// What is made small.
    pub minimise: Minimise,
    /// How pictures are compared.
    pub metric: Metric,
    /// The largest difference that is permitted.
    pub tolerance: f64,
    /// The language.
    pub language: Language,
}

/// The side of a crop around the worst pixel, in pixels of the picture, and how many pixels of the page each of them has.
const CROP: u32 = 64;
const MAGNIFIED: u32 = 4;

/// The page: the reference, the plan and their difference; the decisions in words; the next cheaper steps with the pictures that refuse them;
/// error against cost of all that was tried.
///
/// # Errors
/// Pictures that cannot be made into files.
pub fn plan_page(plan: &Plan, evidence: &Evidence, about: &PlanPage) -> Result<String> {
    let language = about.language;
    let say = |key: &str| text(key, &[], language);
    let (before, after) = (plan.declared.of(about.minimise), plan.planned.of(about.minimise));
    let values = [
        ("scene", Value::from(about.scene.to_owned())),
        ("share", Value::quantity(100.0 * after as f64 / before.max(1) as f64, "%")),
        ("quantity", text(name_of(about.minimise), &[], language).into()),
        ("before", cost(before, about.minimise).into()),
        ("after", cost(after, about.minimise).into()),
        ("tolerance", difference(about.tolerance, about.metric)),
        ("worst", difference(plan.worst.by(about.metric), about.metric)),
    ];
    let sentence_of = |key: &str| text(key, &values, language);
    let title = if plan.decisions.is_empty() { "title-unchanged" } else { "title" };
    let mut page = Page::new(
        &sentence_of(title),
        &sentence_of(if after < before {
            "lead"
        } else {
            if plan.is_cheapest { "lead-unchanged" } else { "lead-none-found" }
        }),
    )
    .in_language(language.tag(), &say("contents"));
    if !plan.is_cheapest {
        let gap = Value::quantity(100.0 * plan.gap, "%");
        let proven = [("proven", cost(plan.proven, about.minimise).into()), ("gap", gap)];
        page.paragraph(&text("unproven", &proven, language));
    }
    page.heading(&say("pictures"));
    page.raw(&three(&evidence.planned, None, &sentence_of("pictures-caption"), about)?);
    let held_out = plan.held_out_place.as_ref().map(|place| ("held-out-place", place));
    for (key, place) in [("worst-place", &plan.worst_place)].into_iter().chain(held_out) {
        page.paragraph(&view_of(key, place, language));
    }
    page.heading(&say("decisions"));
    decisions(plan, about, &mut page);
    page.heading(&say("refused"));
    if evidence.refused.is_empty() {
        page.paragraph(&say("refused-none"));
    } else {
        page.paragraph(&say("refused-lead"));
    }
    for refusal in &evidence.refused {
        refused(refusal, about, &mut page)?;
    }
    page.heading(&say("tried"));
    let plot = tried_plot(plan, evidence, (about.minimise, about.metric), about.tolerance, language);
    page.drawing("tried", &say("tried-caption"), |id| plot.svg(id));
    page.heading(&say("costs"));
    page.table(&costs(plan, language));
    page.heading(&say("reproduce"));
    page.raw(&html! { pre { code { (about.command) } } "\n" }.into_string());
    Ok(page.finish())
}

fn decisions(plan: &Plan, about: &PlanPage, page: &mut Page) {
    let language = about.language;
    let say = |key: &str| text(key, &[], language);
    if plan.decisions.is_empty() {
        page.paragraph(&say(if plan.is_cheapest { "decisions-none" } else { "decisions-none-found" }));
        return;
    }
    let sentences: Vec<String> =
        plan.decisions.iter().map(|decision| sentence(decision, about.metric, language)).collect();
    page.list(sentences.iter().map(String::as_str));
    let columns =
        ["column-what", "column-axis", "column-change", "column-saves", "column-difference", "column-bound"];
    let columns = columns.map(say);
    let mut table = Table::new(&say("decisions-caption"), &columns);
    for decision in &plan.decisions {
        let change = format!("{} → {}", value(&decision.from, language), value(&decision.to, language));
        table = table.row([
            what(&decision.what, language),
            axis(decision.axis, language),
            change,
            saved(decision.saved, about.minimise, language),
            language.short(decision.measured, ""),
            decision.bound.map_or_else(|| say("none"), |bound| language.short(bound, "")),
        ]);
    }
    page.table(&table);
}

/// What a decision saves: negative if it only makes others possible.
fn saved(saved: i64, minimise: Minimise, language: Language) -> String {
    let sign = if saved < 0 { "−" } else { "" };
    format!("{sign}{}", cost(saved.unsigned_abs(), minimise).get(language))
}

/// The camera and the lights of a view.
fn view_of(key: &str, place: &Place, language: Language) -> String {
    let list = |vector: [f64; 3]| Value::from(vector.map(six_digits).join(", "));
    let mut values = vec![("eye", list(place.eye)), ("target", list(place.target))];
    let mut sentence = text(key, &values, language);
    if let Some(turn) = place.turn {
        values = vec![("angle", Value::quantity(turn.degrees, "°")), ("axis", list(turn.axis))];
        sentence = format!("{sentence} {}", text("turned", &values, language));
    }
    sentence
}

fn refused(refusal: &Refusal, about: &PlanPage, page: &mut Page) -> Result<()> {
    let language = about.language;
    let name = |name: &str| Value::from(value(name, language));
    let worst = &refusal.comparison.worst;
    let [x, y] = worst.pixel;
    let values = [
        ("what", Value::from(what(&refusal.what, language))),
        ("axis", Value::from(axis(refusal.axis, language))),
        ("from", name(&refusal.from)),
        ("to", name(&refusal.to)),
        ("saved", cost(refusal.saved, about.minimise).into()),
        ("difference", difference(worst.by(about.metric), about.metric)),
        ("outline", Value::quantity(refusal.comparison.outline, "px")),
        ("pixel", Value::from(format!("{x},{y}"))),
        ("view", Value::Count(refusal.comparison.view as u64)),
        ("tolerance", difference(about.tolerance, about.metric)),
    ];
    page.subheading(&text("refused-title", &values, language));
    let is_by_colour = worst.by(about.metric) > about.tolerance;
    let caption = text(if is_by_colour { "refused-caption" } else { "refused-outline" }, &values, language);
    page.raw(&three(&refusal.comparison, Some(refusal.comparison.pixel), &caption, about)?);
    Ok(())
}

/// The reference, another picture and their difference: whole, or magnified around a pixel.
fn three(
    comparison: &Comparison,
    around: Option<[u32; 2]>,
    caption: &str,
    about: &PlanPage,
) -> Result<String> {
    let factor = [("factor", comparison.amplification.into())];
    let difference =
        if comparison.amplification == 1.0 { "shot-difference-plain" } else { "shot-difference" };
    let key = if around.is_some() { "shot-step" } else { "shot-planned" };
    let captions = [
        text("shot-reference", &[], about.language),
        text(key, &[], about.language),
        text(difference, &factor, about.language),
    ];
    let images = [&comparison.reference, &comparison.other, &comparison.difference];
    let mut figures = Vec::new();
    for (picture, label) in images.into_iter().zip(&captions) {
        let picture = match around {
            None => Picture::from(picture.clone()),
            Some(centre) => magnified(picture, centre),
        };
        figures.push((PreEscaped(image(&picture, label)?), label));
    }
    let shots = html! {
        div.shots { @for (picture, label) in &figures { figure { (picture) figcaption { (label) } } } }
        p { (caption) }
    };
    Ok(shots.into_string() + "\n")
}

/// The surroundings of a pixel, with each of their pixels as a square.
fn magnified(picture: &Image, [x, y]: [u32; 2]) -> Picture {
    let size = picture.size.map(|side| side.min(CROP));
    let from =
        |centre: u32, axis: usize| centre.saturating_sub(size[axis] / 2).min(picture.size[axis] - size[axis]);
    let corner = [from(x, 0), from(y, 1)];
    let [width, height] = size.map(|side| side * MAGNIFIED);
    let pixel = |row: u32, column: u32| {
        picture.pixel(corner[0] + column / MAGNIFIED, corner[1] + row / MAGNIFIED).unwrap_or_default()
    };
    let pixels = (0..height).flat_map(|row| (0..width).map(move |column| (row, column)));
    let pixels = pixels.map(|(row, column)| pixel(row, column)).collect();
    Picture { size: [width, height], pixels: Pixels::Eight(pixels) }
}

fn costs(plan: &Plan, language: Language) -> Table {
    let say = |key: &str| text(key, &[], language);
    let columns = ["column-cost", "column-declared", "column-planned", "column-share"].map(say);
    let mut table = Table::new(&say("costs-caption"), &columns);
    for minimise in [Minimise::Work, Minimise::Bytes, Minimise::Vertices] {
        let (before, after) = (plan.declared.of(minimise), plan.planned.of(minimise));
        let share = language.short(100.0 * after as f64 / before.max(1) as f64, "%");
        table = table.row([say(name_of(minimise)), before.to_string(), after.to_string(), share]);
    }
    table
}

/// The three pictures of a plan next to each other, with their costs and the largest difference.
///
/// # Errors
/// Pictures that are too large together.
pub fn plan_sheet(plan: &Plan, evidence: &Evidence, about: &PlanPage) -> Result<Picture> {
    let shown = &evidence.planned;
    let of = |key: &str, cost_of: u64| {
        let cost = cost(cost_of, about.minimise).into();
        text(key, &[("cost", cost)], about.language)
    };
    let worst = [
        ("difference", difference(plan.worst.by(about.metric), about.metric)),
        ("factor", shown.amplification.into()),
    ];
    let captions = [
        of("sheet-reference", plan.declared.of(about.minimise)),
        of("sheet-plan", plan.planned.of(about.minimise)),
        text("sheet-difference", &worst, about.language),
    ];
    let pictures = [&shown.reference, &shown.other, &shown.difference];
    let list = captions.into_iter().zip(pictures);
    panels(
        &list
            .map(|(caption, image)| Panel { caption, picture: Picture::from(image.clone()) })
            .collect::<Vec<_>>(),
    )
}
