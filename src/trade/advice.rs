//! Advice in sentences, made from the numbers of a measurement. The sentences are in advice.en.ftl.

use super::cases::{NamedSurface, Tiling};
use super::cost::Way;
use super::effort::Effort;
use super::encodings::EncodingRow;
use super::frontier::{ClassPoint, MeshClass, frontier};
use super::solids::BoxRow;
use super::summary::Trade;
use crate::normals::Weight;
use crate::num::three_digits;
use crate::text::{Catalogue, Language, Value, catalogue};

static TEXTS: Catalogue = catalogue!("advice", en);

/// Weights whose errors are within this factor count as equal: surfaces differ by more.
const ALIKE: f64 = 1.1;

/// The sentence of a key with its values.
pub(super) fn sentence(key: &str, values: &[(&'static str, Value)]) -> String {
    TEXTS.with(key, values).get(Language::English).to_owned()
}

/// A number as sentences have it.
pub(super) fn digits(x: f64) -> Value {
    three_digits(x).into()
}

/// Advice on which weights, which precision, which encodings and which shading to use.
pub fn advice(trade: &Trade) -> Vec<String> {
    let weights = trade.classes.iter().filter_map(on_class);
    on_effort(trade)
        .into_iter()
        .chain(weights)
        .chain(on_boxes(trade))
        .chain(on_precision(trade))
        .chain(on_encodings(trade))
        .chain(on_shading(trade))
        .collect()
}

/// Medians of few surfaces are not those of all.
fn on_effort(trade: &Trade) -> Option<String> {
    let names = |effort| NamedSurface::all(effort).iter().map(|surface| surface.name).collect::<Vec<_>>();
    let (few, all) = (names(Effort::Quick), names(Effort::Usual).len());
    let values = [
        ("few", few.len().to_string().into()),
        ("names", few.join(", ").into()),
        ("all", all.to_string().into()),
    ];
    (trade.effort == Effort::Quick).then(|| sentence("quick", &values))
}

/// The best weight that sums faces; [`Weight::Angle`], the default, if its error is about as small.
fn best_sum(points: &[ClassPoint]) -> Option<ClassPoint> {
    let sums = || points.iter().filter(|point| !point.weight.is_fit());
    let best = sums().min_by(|a, b| a.rms.total_cmp(&b.rms))?;
    let usual = sums().find(|point| point.weight == Weight::Angle && point.rms <= ALIKE * best.rms);
    Some(*usual.unwrap_or(best))
}

fn on_class(class: &MeshClass) -> Option<String> {
    let points = &class.points;
    let best = best_sum(points)?;
    let others = || points.iter().filter(|point| !point.weight.is_fit() && point.weight != best.weight);
    let next = others().min_by(|a, b| a.rms.total_cmp(&b.rms))?;
    let worst = others().max_by(|a, b| a.rms.total_cmp(&b.rms))?;
    // The default weight is named where its error is about the smallest, which has to be said.
    let key = if next.rms < best.rms { "class-default" } else { "class-best" };
    let mut text = sentence(
        key,
        &[
            ("class", class.tiling.about().into()),
            ("best", best.weight.name().into()),
            ("rms", digits(best.rms)),
            ("ratio", digits(best.ratio)),
            ("next", next.weight.name().into()),
            ("next-rms", digits(next.rms)),
            ("worst", worst.weight.name().into()),
            ("worst-rms", digits(worst.rms)),
        ],
    );
    let fit = frontier(points).into_iter().rfind(|point| point.weight.is_fit());
    if let Some(fit) = fit.filter(|fit| ALIKE * fit.rms < best.rms) {
        let values =
            [("ratio", digits(fit.ratio)), ("fit", fit.weight.name().into()), ("rms", digits(fit.rms))];
        text.push(' ');
        text += &sentence("class-fit", &values);
    }
    Some(text)
}

fn on_boxes(trade: &Trade) -> Option<String> {
    let names = |is_true: fn(&BoxRow) -> bool| {
        let rows = |weight| trade.boxes.iter().filter(move |row| row.weight == weight);
        let found = Weight::SUMS.into_iter().filter(|&weight| rows(weight).all(is_true));
        found.map(Weight::name).collect::<Vec<_>>().join(", ")
    };
    let right = names(|row| row.deviations.iter().all(|&deviation| deviation < 1e-9));
    let values = [("right", right.as_str().into()), ("invariant", names(BoxRow::is_invariant).into())];
    (!right.is_empty()).then(|| sentence("boxes", &values))
}

fn on_precision(trade: &Trade) -> Option<String> {
    let kept = trade.precision.iter().filter(|row| !row.declined);
    let worst = kept.map(|row| row.fast.max).reduce(f64::max)?;
    let cost = |way| trade.costs.ratio(way, Weight::Angle);
    let saved = cost(Way::SlicesFast)? / cost(Way::Slices)?;
    let time = match saved {
        ..0.95 => "time-less",
        1.05.. => "time-more",
        _ => "time-same",
    };
    let time = sentence(time, &[("share", digits(saved))]);
    let mut text = sentence("precision", &[("worst", digits(worst)), ("time", time.into())]);
    let declined = trade.precision.iter().filter(|row| row.declined);
    let mut declined: Vec<&str> = declined.map(|row| row.case).collect();
    declined.dedup();
    if !declined.is_empty() {
        text.push(' ');
        text += &sentence("declined", &[("cases", declined.join(", ").into())]);
    }
    Some(text)
}

fn on_encodings(trade: &Trade) -> Option<String> {
    let smallest = |is_enough: fn(&&EncodingRow) -> bool| {
        let found = trade.encodings.iter().filter(is_enough);
        found.min_by(|a, b| a.bytes.cmp(&b.bytes).then(a.max.total_cmp(&b.max)))
    };
    let diffuse = smallest(|row| row.diffuse)?;
    let shiny = smallest(|row| row.blinn.is_some_and(|exponent| exponent >= 1000))?;
    let failing = trade.encodings.iter().filter(|row| !row.diffuse).map(|row| row.name.as_str());
    Some(sentence(
        "encodings",
        &[
            ("diffuse-bytes", diffuse.bytes.to_string().into()),
            ("diffuse", diffuse.name.as_str().into()),
            ("shiny-bytes", shiny.bytes.to_string().into()),
            ("shiny", shiny.name.as_str().into()),
            ("failing", failing.collect::<Vec<_>>().join(", ").into()),
        ],
    ))
}

fn on_shading(trade: &Trade) -> Option<String> {
    let rms = |shading: &str| {
        let rows = trade.shading.iter().filter(|row| {
            row.shading == shading
                && row.tiling == Tiling::Regular
                && row.interpolation.is_none_or(|i| i == "perspective")
        });
        let squares: Vec<f64> = rows.map(|row| row.error.linear.rms * row.error.linear.rms).collect();
        (!squares.is_empty()).then(|| digits((squares.iter().sum::<f64>() / squares.len() as f64).sqrt()))
    };
    let values = [("flat", rms("flat")?), ("gouraud", rms("gouraud")?), ("phong", rms("phong")?)];
    Some(sentence("shading", &values))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_usual_weight_wins_among_those_alike() {
        let point =
            |weight, rms| ClassPoint { weight, rms, spread: [rms; 2], ratio: 1.0, dominated_by: None };
        let points = [point(Weight::Angle, 1.05), point(Weight::Max, 1.0), point(Weight::Quadric, 0.1)];
        assert_eq!(best_sum(&points).unwrap().weight, Weight::Angle);
        let points = [point(Weight::Angle, 1.2), point(Weight::Max, 1.0)];
        assert_eq!(best_sum(&points).unwrap().weight, Weight::Max);
        assert_eq!(best_sum(&points[..0]), None);
    }
}
