//! One polygon, cut in two ways.

use super::body::{Body, Diagonal};
use super::stage::{BACKGROUND, chalk, differences, draw, front, light_at, linear, map, picture, settings};
use super::{
    ArtefactError, Chart, Curve, Drawn, Experiment, Knob, Measure, Moved, Outcome, Parameters, Scale, Setup,
    Shot, Text, Threshold, Verdict,
};
use crate::metric::image_error;
use crate::num::{Degrees, LinearRgb, Radians};
use crate::raster::{Image, Interpolation, Object, Paint, Shading};
use crate::text::{Catalogue, catalogue};
use glam::DVec3;
use std::borrow::Cow;
use std::f64::consts::TAU;

static TEXTS: Catalogue = catalogue!("triangulation");

pub(super) static EXPERIMENT: Experiment = Experiment {
    id: "triangulation",
    texts: &TEXTS,
    takes: &[Knob::Size, Knob::Segments, Knob::Light],
    // More, and four times as many in the cured picture, would be hardly larger than pixels.
    segments: 3..=256,
    defaults: Parameters { segments: 12, light: Degrees(50.0), ..Parameters::USUAL },
    run,
    frame: None,
};

/// The corners' colours, from the right one counter-clockwise as the exercise counts them.
const CORNERS: [LinearRgb; 4] = [
    LinearRgb::new(0.0, 0.4, 0.4),
    LinearRgb::new(0.0, 0.2, 0.2),
    LinearRgb::new(0.2, 0.6, 0.6),
    LinearRgb::new(0.4, 0.4, 0.0),
];
/// How many times more squares the cured surface has along a side.
const FINER: u32 = 4;
/// The window's side; bodies are 2 wide.
const WINDOW: f64 = 2.2;
/// Height of the waves.
const HEIGHT: f64 = 0.12;
/// How many waves lie along a side: few squares to each, so that it shows how these are cut.
const WAVES: f64 = 2.0;

fn run(setup: &Setup) -> Result<Outcome, ArtefactError> {
    let Parameters { size, segments, light, .. } = setup.parameters;
    let [across, upright, fan] = [Cut::Across, Cut::Upright, Cut::Fan].map(|cut| diamond(cut, size));
    let (across, upright, fan) = (across?, upright?, fan?);
    let draw_waves = |cells, diagonal, shading| waves(cells, diagonal, shading, light, size);
    let pair = |cells, shading| -> Result<[Image; 2], ArtefactError> {
        Ok([draw_waves(cells, Diagonal::Rising, shading)?, draw_waves(cells, Diagonal::Falling, shading)?])
    };
    let [rising, falling] = pair(segments, Shading::Gouraud)?;
    let fine = draw_waves(FINER * segments, Diagonal::Rising, Shading::Gouraud)?;
    let [phong, phong_falling] = pair(segments, Shading::Phong)?;
    let exact = waves_themselves(light, size);
    let apart = |a: &Image, b: &Image| image_error(a, b, 0.5).map(|error| error.linear.rms / 255.0);
    let mut orders = Vec::new();
    for cells in [segments, 2 * segments, FINER * segments] {
        let [a, b] = pair(cells, Shading::Gouraud)?;
        orders.push([f64::from(cells), apart(&a, &b)?]);
    }
    let mean = |corners: &[usize]| {
        let sum = corners.iter().fold(LinearRgb::BLACK, |sum, &corner| sum + CORNERS[corner]);
        (sum * (1.0 / corners.len() as f64)).to_array()
    };
    // A pixel's centre is up to 0.71 pixels off the middle; from there to a corner colours change by 0.5 at most.
    let tolerance = 0.5 * 0.71 * WINDOW / f64::from(size) + 1e-6;
    let mut measures = Vec::new();
    for (image, name, corners) in [
        (&across, ["cut 1–3", "corte 1–3"], &[0, 2][..]),
        (&upright, ["cut 2–4", "corte 2–4"], &[1, 3]),
        (&fan, ["vertex in the middle", "vértice no meio"], &[0, 1, 2, 3]),
    ] {
        for (axis, colour) in
            [["red", "vermelho"], ["green", "verde"], ["blue", "azul"]].into_iter().enumerate()
        {
            let text = |k: usize| match k {
                0 => format!("diamond, {}: {} in the middle", name[0], colour[0]),
                _ => format!("losango, {}: {} no meio", name[1], colour[1]),
            };
            measures.push(Measure::new(Text::made(text(0), text(1)), "", centre(image)[axis]).expect(
                mean(corners)[axis],
                tolerance,
                TEXTS.get("by-mean-these-corners"),
            ));
        }
    }
    let middle = |image: &Image| centre(image);
    let blue = (middle(&across)[2] - middle(&upright)[2]).abs();
    let order = order(&orders, light, size);
    let is_square = order.as_ref().is_some_and(|order| order.agrees() == Some(true));
    measures.extend(order);
    measures.push(Measure::new(TEXTS.get("measure-diamond-largest-difference"), "", blue));
    measures.push(Measure::new(TEXTS.get("measure-waves-gouraud-difference"), "", apart(&rising, &falling)?));
    measures.push(Measure::new(
        TEXTS.get("measure-waves-phong-difference"),
        "",
        apart(&phong, &phong_falling)?,
    ));
    let full = 0.3;
    let difference = map([size; 2], &differences(&rising, &falling), full);
    let waves = Moved {
        name: TEXTS.get("moved"),
        unit: "",
        bad: apart(&rising, &exact)?,
        present: Threshold::HALF_STEP,
        cure: Text::made(
            format!("{FINER} times as many squares along a side"),
            format!("{FINER} vezes mais quadrados por lado"),
        ),
        cured: apart(&fine, &exact)?,
        factor: 8.0,
    };
    let along = Moved { cured: apart(&falling, &exact)?, factor: 1.5, ..waves.clone() };
    let off_surface = |(value, name, cut): (f64, &'static str, &'static str)| {
        Measure::new(
            Text::made(
                format!("waves, {name}: light off that of the surface itself (rms)"),
                format!("ondas, {cut}: luz, diferença à da própria superfície (rms)"),
            ),
            "",
            value,
        )
    };
    measures.extend(
        [
            (waves.bad, "cut across", "cortadas de través"),
            (along.cured, "cut along", "cortadas ao longo"),
            (waves.cured, "cut across, finer", "cortadas de través, mais finas"),
        ]
        .map(off_surface),
    );
    let of_all = mean(&[0, 1, 2, 3]);
    let from_mean = |image: &Image| (0..3).map(|k| (centre(image)[k] - of_all[k]).abs()).fold(0.0, f64::max);
    let diamond = Moved {
        name: TEXTS.get("moved-colour-middle-off"),
        bad: from_mean(&across),
        cured: from_mean(&fan),
        // From 0.2 to what half a pixel's diagonal makes of it, an eighth of that in the smallest picture.
        factor: 5.0,
        ..waves.clone()
    };
    let off = |image: &Image| Moved { bad: from_mean(image), ..diamond.clone() };
    Ok(Outcome {
        verdict: Verdict::Holds(TEXTS.get("holds-wherever-corners-values")),
        shots: vec![
            waves.bad_shot(
                "waves-rising",
                TEXTS.get("waves-rising-title"),
                [
                    TEXTS.get("waves-rising-caption-slanting-waves-gouraud"),
                    TEXTS.get("waves-rising-caption-they-fall-into"),
                ],
                rising,
            ),
            along.cured_shot(
                "waves-falling",
                TEXTS.get("waves-falling-title"),
                [
                    TEXTS.get("waves-falling-caption-same-vertices-normals"),
                    TEXTS.get("waves-falling-caption-stripes-straight-but"),
                ],
                falling,
            ),
            Shot::difference(
                "waves-difference",
                TEXTS.get("waves-difference-title"),
                TEXTS.with("waves-difference-caption-how-much-both", &[("full", full.into())]),
                difference,
            ),
            waves.cured_shot(
                "waves-fine",
                TEXTS.get("waves-fine-title"),
                [
                    TEXTS.get("waves-fine-caption-cut-across-first"),
                    TEXTS.get("waves-fine-caption-cut-hardly-seen"),
                ],
                fine,
            ),
            Shot::truth(
                "waves-themselves",
                TEXTS.get("waves-themselves-title"),
                TEXTS.get("waves-themselves-caption-surface-own-normal"),
                exact,
            ),
            off(&across).bad_shot(
                "diamond-1-3",
                TEXTS.get("diamond-1-3-title"),
                [
                    TEXTS.get("diamond-1-3-caption-cut-right-left"),
                    TEXTS.get("diamond-1-3-caption-light-band-runs"),
                ],
                across,
            ),
            off(&upright).bad_shot(
                "diamond-2-4",
                TEXTS.get("diamond-2-4-title"),
                [
                    TEXTS.get("diamond-2-4-caption-cut-upper-lower"),
                    TEXTS.get("diamond-2-4-caption-dark-olive-band"),
                ],
                upright,
            ),
            diamond.cured_shot(
                "diamond-fan",
                TEXTS.get("diamond-fan-title"),
                [
                    TEXTS.get("diamond-fan-caption-four-triangles-about"),
                    TEXTS.get("diamond-fan-caption-no-diagonal-preferred"),
                ],
                fan,
            ),
        ],
        moved: waves,
        measures,
        charts: vec![chart(orders, is_square)],
        notes: vec![TEXTS.get("note-each-triangles-knows")],
    })
}

/// By which power of h both diagonals differ on the waves; none where there is no light on them.
fn order(by_cells: &[[f64; 2]], light: Degrees, size: u32) -> Option<Measure> {
    // Of both finer ones: those of the coarsest mesh are far from small.
    let [[cells, _], [half, coarse], [most, fine]] = by_cells else { return None };
    if *coarse == 0.0 || *fine == 0.0 {
        return None;
    }
    let order = Measure::new(
        TEXTS.get("measure-waves-order-difference"),
        "",
        libm::log2(coarse / fine) / libm::log2(most / half),
    );
    let steepest = 0.5 * TAU * WAVES * HEIGHT;
    let is_lit = light.0.abs() < 90.0 && libm::tan(Radians::from(light).0.abs()) * steepest < 1.0;
    Some(if !is_lit {
        order.beyond(TEXTS.get("untested-not-held-against"))
    } else if *fine < 100.0 * f64::from(f32::EPSILON) {
        order.beyond(TEXTS.get("untested-not-held-against-o"))
    } else if 2.0 * most > f64::from(size) {
        order.beyond(TEXTS.get("untested-not-held-against-o-h"))
    } else if *cells < 5.0 * WAVES {
        order.beyond(TEXTS.get("untested-not-held-against-o-h-few"))
    } else {
        order.expect(2.0, 0.25, TEXTS.get("by-o-h-facets"))
    })
}

/// How the diamond is cut.
#[derive(Clone, Copy, Debug)]
enum Cut {
    /// From corner 1 to 3.
    Across,
    /// From corner 2 to 4.
    Upright,
    /// By a vertex in the middle.
    Fan,
}

/// The diamond of exercise 1.6.25 with its corners' colours, unlit.
fn diamond(cut: Cut, size: u32) -> Result<Image, ArtefactError> {
    let places = [DVec3::X, DVec3::Y, DVec3::NEG_X, DVec3::NEG_Y, DVec3::ZERO];
    let triangles = match cut {
        Cut::Across => vec![[0, 1, 2], [0, 2, 3]],
        Cut::Upright => vec![[0, 1, 3], [1, 2, 3]],
        Cut::Fan => vec![[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]],
    };
    let body = Body::new(&places, triangles, &[DVec3::Z; 5]);
    let mean = CORNERS.iter().fold(LinearRgb::BLACK, |sum, &colour| sum + colour) * 0.25;
    let colours: Vec<LinearRgb> = CORNERS.into_iter().chain([mean]).collect();
    let object = Object { paint: Paint::Given(Cow::Owned(colours)), ..body.object(chalk()) };
    let settings = settings([size; 2], Shading::Gouraud, Interpolation::Affine);
    draw(vec![object], &[], front(WINDOW), &settings)
}

/// The pixel in the middle.
fn centre(image: &Image) -> [f64; 3] {
    let index = image.index(image.size[0] / 2, image.size[1] / 2);
    index.map_or([f64::NAN; 3], |index| linear(image)[index].map(f64::from))
}

/// A surface of waves that run aslant, with its own normals.
fn waves(
    cells: u32,
    diagonal: Diagonal,
    shading: Shading,
    light: Degrees,
    size: u32,
) -> Result<Image, ArtefactError> {
    let body = Body::grid([cells; 2], diagonal, |u, v| {
        let height = HEIGHT * libm::sin(TAU * WAVES * (u + v));
        (DVec3::new(2.0 * u - 1.0, 2.0 * v - 1.0, height), wave_normal(u, v))
    });
    let settings = settings([size; 2], shading, Interpolation::Perspective);
    draw(vec![body.object(chalk())], &[light_at(light)], front(WINDOW), &settings)
}

/// The normal of the waves; they rise by 2π HEIGHT WAVES / 2 at the most, in x = 2u − 1 as in y = 2v − 1.
fn wave_normal(u: f64, v: f64) -> DVec3 {
    let slope = 0.5 * TAU * WAVES * HEIGHT * libm::cos(TAU * WAVES * (u + v));
    DVec3::new(-slope, -slope, 1.0).normalize()
}

/// The waves without triangles: every pixel has the light of its own normal.
fn waves_themselves(light: Degrees, size: u32) -> Image {
    let (sine, cosine) = libm::sincos(Radians::from(light).0);
    let at = |pixel: u32| WINDOW * ((f64::from(pixel) + 0.5) / f64::from(size) - 0.5);
    let places = (0..size).flat_map(|y| (0..size).map(move |x| [at(x), -at(y)]));
    let shown = places.map(|[x, y]| {
        if x.abs() > 1.0 || y.abs() > 1.0 {
            return (BACKGROUND.to_array().map(|component| component as f32), 0);
        }
        let cosine = wave_normal(0.5 * (x + 1.0), 0.5 * (y + 1.0)).dot(DVec3::new(sine, 0.0, cosine));
        ([cosine.max(0.0) as f32; 3], 1)
    });
    let (colours, coverage) = shown.unzip();
    picture([size; 2], colours, coverage)
}

fn chart(orders: Vec<[f64; 2]>, is_square: bool) -> Chart {
    // Through the finest: a law of the small holds there.
    let [most, least] = orders[orders.len() - 1];
    let square = orders.iter().map(|&[cells, _]| [cells, least * (most / cells) * (most / cells)]).collect();
    Chart {
        name: "difference-by-cells",
        title: TEXTS.get("chart-title"),
        caption: match is_square {
            true => TEXTS.get("chart-caption"),
            false => TEXTS.get("chart-caption-difference-waves-against"),
        },
        x: Scale::log(TEXTS.get("axis-squares-along-side")),
        y: Scale::log(TEXTS.get("axis-rms-difference")),
        curves: vec![
            Curve { name: TEXTS.get("curve-measured"), drawn: Drawn::Points, points: orders },
            Curve { name: TEXTS.get("curve-h-h-number"), drawn: Drawn::Guide, points: square },
        ],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn diagonals_show_and_stop_showing() {
        for segments in [10, 12] {
            let parameters = Parameters { size: 160, segments, ..EXPERIMENT.defaults };
            let outcome = EXPERIMENT.run(&Setup { parameters, mesh: None }).unwrap();
            outcome.prove();
            // Means of two or four of the exercise's colours, in green and blue; half a pixel's diagonal.
            for (name, printed) in [
                ("diamond, cut 1–3: green", 0.5),
                ("diamond, cut 1–3: blue", 0.5),
                ("diamond, cut 2–4: green", 0.3),
                ("diamond, cut 2–4: blue", 0.1),
                ("diamond, vertex in the middle: blue", 0.3),
            ] {
                assert!(
                    (outcome.measured(name) - printed).abs() < 0.006,
                    "{name}: {}",
                    outcome.measured(name)
                );
            }
            // Present: several steps of 8 bits on average. Cured: a sixteenth in the limit, an eighth at least.
            assert!(
                outcome.moved.bad > 3.0 / 255.0 && outcome.moved.reduction() > 8.0,
                "{:?}",
                outcome.moved
            );
        }
    }
}
