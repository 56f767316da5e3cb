//! What to use, said plainly: every sentence is made from numbers of the measurement.

use super::summary::{ClassPoint, frontier};
use super::{Effort, Subject, Tiling, Trade};
use crate::normals::Weight;
use crate::num::three_digits;

/// Weights whose errors are this close are alike: surfaces differ by more.
const ALIKE: f64 = 1.1;

/// Advice on which weights, which precision, which encodings and which shading to use.
pub fn advice(trade: &Trade) -> Vec<String> {
    let weights = Tiling::ALL.into_iter().filter_map(|tiling| on_class(trade, tiling));
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
    let names = |effort| Subject::all(effort).iter().map(|subject| subject.name).collect::<Vec<_>>();
    (trade.effort == Effort::Quick).then(|| {
        let (few, all) = (names(Effort::Quick), names(Effort::Usual));
        format!(
            "Quick: from {} surfaces ({}). Over all {} the best weight of a class may be another: measure without --quick \
             before you choose.",
            few.len(),
            few.join(", "),
            all.len()
        )
    })
}

/// The best weight that sums faces; [`Weight::Angle`], the usual one, among those that are alike.
pub(super) fn best_sum(points: &[ClassPoint]) -> Option<ClassPoint> {
    let sums = || points.iter().filter(|point| point.weight != Weight::Quadric);
    let best = sums().min_by(|a, b| a.rms.total_cmp(&b.rms))?;
    let usual = sums().find(|point| point.weight == Weight::Angle && point.rms <= ALIKE * best.rms);
    Some(*usual.unwrap_or(best))
}

fn on_class(trade: &Trade, tiling: Tiling) -> Option<String> {
    let points = trade.of_class(tiling);
    let best = best_sum(&points)?;
    let others = |worst: bool| {
        let sums =
            points.iter().filter(|point| point.weight != Weight::Quadric && point.weight != best.weight);
        let by_error = |a: &&ClassPoint, b: &&ClassPoint| a.rms.total_cmp(&b.rms);
        if worst { sums.max_by(by_error) } else { sums.min_by(by_error) }
    };
    let (next, worst) = (others(false)?, others(true)?);
    // The usual weight stands for all that are alike, which has to be said.
    let (title, relation) = match next.rms < best.rms {
        true => (format!("{}, the default", best.weight.name()), "within a tenth of the least, which is"),
        false => (best.weight.name().to_owned(), "next is"),
    };
    let mut text = format!(
        "On {}: {title} (rms {}°, {} times the plain loop; {relation} {} with {}°, last {} with {}°).",
        tiling.describes(),
        three_digits(best.rms),
        three_digits(best.ratio),
        next.weight.name(),
        three_digits(next.rms),
        worst.weight.name(),
        three_digits(worst.rms),
    );
    let on_frontier = |weight: Weight| frontier(&points).into_iter().find(|point| point.weight == weight);
    let is_worth_it = |quadric: &ClassPoint| ALIKE * quadric.rms < best.rms;
    if let Some(quadric) = on_frontier(Weight::Quadric).filter(is_worth_it) {
        text.push_str(&format!(
            " Where accuracy is worth {} times the plain loop, quadric: {}°.",
            three_digits(quadric.ratio),
            three_digits(quadric.rms)
        ));
    }
    Some(text)
}

fn on_boxes(trade: &Trade) -> Option<String> {
    let right = |weight: Weight| {
        let mut rows = trade.boxes.iter().filter(|row| row.weight == weight);
        rows.all(|row| row.deviations.iter().all(|&deviation| deviation < 1e-9))
    };
    let invariant = |weight: Weight| {
        trade.boxes.iter().filter(|row| row.weight == weight).all(super::BoxRow::is_invariant)
    };
    let names = |of: &dyn Fn(Weight) -> bool| {
        let found = Weight::ALL.into_iter().filter(|&weight| weight != Weight::Quadric && of(weight));
        found.map(Weight::name).collect::<Vec<_>>().join(", ")
    };
    let (right, invariant) = (names(&right), names(&invariant));
    (!right.is_empty()).then(|| {
        format!(
            "On flat faces that may be triangulated this way or that (buildings, machine parts): {right}, which points \
             along the diagonal at every corner of a box; only {invariant} do not depend on the cut at all."
        )
    })
}

fn on_precision(trade: &Trade) -> Option<String> {
    let kept = || trade.precision.iter().filter(|row| !row.declined);
    let worst = kept().map(|row| row.fast.max).reduce(f64::max)?;
    let declined: Vec<&str> = trade.precision.iter().filter(|row| row.declined).map(|row| row.case).collect();
    let cost = |way| trade.costs.ratio(way, Weight::Angle);
    let saved = cost(super::Way::MeshFast)? / cost(super::Way::Mesh)?;
    let mut declined = declined;
    declined.dedup();
    let time = match three_digits(saved) {
        share if saved < 0.95 => format!("takes {share} of the time"),
        share if saved > 1.05 => format!("takes {share} times as long"),
        _ => "saves no time".into(),
    };
    let mut text = format!(
        "`--precision fast` differs from faithful by {}° at the most on these meshes, and {time}. A face it is off by up to \
         0.0172° where it is a thousandth as high as long, a vertex by that times what its sum shrinks by; beyond, it leaves \
         the mesh to faithful.",
        three_digits(worst)
    );
    if !declined.is_empty() {
        text.push_str(&format!(" It left {} to faithful.", declined.join(", ")));
    }
    Some(text)
}

fn on_encodings(trade: &Trade) -> Option<String> {
    let smallest = |serves: &dyn Fn(&super::EncodingRow) -> bool| {
        let found = trade.encodings.iter().filter(|row| serves(row));
        found.min_by(|a, b| a.bytes.cmp(&b.bytes).then(a.max.total_cmp(&b.max)))
    };
    let diffuse = smallest(&|row| row.diffuse)?;
    let shiny = smallest(&|row| row.blinn.is_some_and(|exponent| exponent >= 1000))?;
    let failing: Vec<&str> =
        trade.encodings.iter().filter(|row| !row.diffuse).map(|row| row.name.as_str()).collect();
    Some(format!(
        "Stored normals: {} bytes ({}) are enough for diffuse light within half an 8-bit step, {} bytes ({}) for Blinn \
         highlights of n = 1000 and more. Not even diffuse light survives {}.",
        diffuse.bytes,
        diffuse.name,
        shiny.bytes,
        shiny.name,
        failing.join(", ")
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
        (!squares.is_empty()).then(|| (squares.iter().sum::<f64>() / squares.len() as f64).sqrt())
    };
    let (flat, gouraud, phong) = (rms("flat")?, rms("gouraud")?, rms("phong")?);
    Some(format!(
        "Shading, over all regular meshes here: flat is off by {} steps of 1/255, Gouraud by {}, Phong by {} (rms, linear \
         light). A mesh four times as fine brings each closer; no shading repairs a silhouette.",
        three_digits(flat),
        three_digits(gouraud),
        three_digits(phong)
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_usual_weight_wins_among_those_alike() {
        let point = |weight, rms| ClassPoint { weight, rms, ratio: 1.0 };
        let points = [point(Weight::Angle, 1.05), point(Weight::Max, 1.0), point(Weight::Quadric, 0.1)];
        assert_eq!(best_sum(&points).unwrap().weight, Weight::Angle);
        let points = [point(Weight::Angle, 1.2), point(Weight::Max, 1.0)];
        assert_eq!(best_sum(&points).unwrap().weight, Weight::Max);
        assert_eq!(best_sum(&points[..0]), None);
    }
}
