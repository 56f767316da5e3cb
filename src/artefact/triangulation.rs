//! One polygon, cut in two ways.

use super::prelude::*;
use std::borrow::Cow;
use std::f64::consts::TAU;

static TEXTS: Catalogue = catalogue!("triangulation");

pub(super) static EXPERIMENT: Experiment = Experiment {
    takes: &[ParameterName::Size, ParameterName::Segments, ParameterName::Light],
    // More, and four times as many in the cured picture, would be hardly larger than pixels.
    ranges: &[(ParameterName::Segments, [3.0, 256.0])],
    defaults: Parameters { segments: 12, light: Degrees(50.0), ..Parameters::USUAL },
    ..Experiment::new("triangulation", &TEXTS, run)
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
const FULL: f64 = 0.3;
const HEIGHT: f64 = 0.12;
/// How many waves lie along a side: few squares to each, so that it shows how these are cut.
const WAVES: f64 = 2.0;

fn run(setup: &Setup) -> Result<Outcome> {
    let mut out = Recorder::new(&TEXTS, &[("full", FULL.into()), ("finer", FINER.into())]);
    let diamonds = Diamonds::draw(setup.parameters.size)?;
    diamonds.measure(&mut out);
    let effect = waves(&setup.parameters, diamonds.change(), &mut out)?;
    diamonds.show(&mut out);
    Ok(out.finish(Verdict::Holds(out.text("holds")), effect))
}

/// The waves cut across and along, in coarse and in fine squares, under Gouraud's shading and Phong's.
fn waves(
    &Parameters { size, segments, light, .. }: &Parameters,
    diamond_change: f64,
    out: &mut Recorder,
) -> Result<Effect> {
    let draw = |cells, diagonal, shading| draw_waves(cells, diagonal, shading, light, size);
    let pair = |cells, shading| -> Result<[Image; 2]> {
        Ok([draw(cells, Diagonal::Rising, shading)?, draw(cells, Diagonal::Falling, shading)?])
    };
    let rms = |a: &Image, b: &Image| errors(a, b).map(|[_, rms]| rms);
    let [rising, falling] = pair(segments, Shading::Gouraud)?;
    let fine = draw(FINER * segments, Diagonal::Rising, Shading::Gouraud)?;
    let [phong, phong_falling] = pair(segments, Shading::Phong)?;
    let exact = exact_waves(light, size);
    let mut differences_by_cells = Vec::new();
    for cells in [segments, 2 * segments, FINER * segments] {
        let [a, b] = pair(cells, Shading::Gouraud)?;
        differences_by_cells.push([f64::from(cells), rms(&a, &b)?]);
    }
    measure_order(&differences_by_cells, light, size, out);
    out.measure("diamond-change", "", diamond_change, Check::None);
    out.measure("waves-gouraud", "", rms(&rising, &falling)?, Check::None);
    out.measure("waves-phong", "", rms(&phong, &phong_falling)?, Check::None);
    let [across, along, finer] = [&rising, &falling, &fine].map(|image| rms(image, &exact));
    let (across, along, finer) = (across?, along?, finer?);
    out.measure("waves-rising", "", across, Check::None);
    out.measure("waves-falling", "", along, Check::None);
    out.measure("waves-fine", "", finer, Check::None);
    chart(differences_by_cells, out);
    let effect = out.effect("waves", "", [across, finer], Threshold::half_step(), 8.0);
    let of_cut = Effect { cured: along, factor: 1.5, ..effect.clone() };
    let difference = map([size; 2], &differences(&rising, &falling), FULL);
    out.bad("waves-rising", &effect, rising);
    out.cured("waves-falling", &of_cut, falling);
    out.difference("waves-difference", difference, FULL, "");
    out.cured("waves-fine", &effect, fine);
    out.truth("waves-themselves", exact);
    Ok(effect)
}

/// By which power of h the two diagonals differ on the waves; nothing where there is no light on them.
fn measure_order(by_cells: &[[f64; 2]], light: Degrees, size: u32, out: &mut Recorder) {
    // Of both finer ones: those of the coarsest mesh are far from small.
    let [[cells, _], [half, coarse], [most, fine]] = by_cells else { return };
    if *coarse == 0.0 || *fine == 0.0 {
        return;
    }
    let steepest = 0.5 * TAU * WAVES * HEIGHT;
    let is_lit = light.0.abs() < 90.0 && libm::tan(Radians::from(light).0.abs()) * steepest < 1.0;
    let check = if !is_lit {
        Check::Untested("order-of-black-slopes")
    } else if *fine < 100.0 * f64::from(f32::EPSILON) {
        Check::Untested("order-below-precision")
    } else if 2.0 * most > f64::from(size) {
        Check::Untested("order-below-pixels")
    } else if *cells < 5.0 * WAVES {
        Check::Untested("order-of-coarse-squares")
    } else {
        Check::Near(2.0, 0.25)
    };
    out.measure("order", "", libm::log2(coarse / fine) / libm::log2(most / half), check);
}

fn chart(by_cells: Vec<[f64; 2]>, out: &mut Recorder) {
    // Through the finest: a law of small squares holds there.
    let [most, least] = by_cells[by_cells.len() - 1];
    let square = by_cells.iter().map(|&[cells, _]| [cells, least * (most / cells) * (most / cells)]);
    let law = out.curve("law", Drawn::Guide, square.collect());
    let measured = out.curve("measured", Drawn::Points, by_cells);
    out.chart("difference-by-cells", [Axis::Log; 2], vec![measured, law]);
}

/// The diamond of exercise 1.6.25 cut in three ways.
struct Diamonds {
    across: Image,
    upright: Image,
    fan: Image,
}

impl Diamonds {
    fn draw(size: u32) -> Result<Self> {
        let [across, upright, fan] = [Cut::Across, Cut::Upright, Cut::Fan].map(|cut| diamond(cut, size));
        Ok(Self { across: across?, upright: upright?, fan: fan? })
    }

    fn mean(corners: &[usize]) -> [f64; 3] {
        let sum = corners.iter().fold(LinearRgb::BLACK, |sum, &corner| sum + CORNERS[corner]);
        (sum * (1.0 / corners.len() as f64)).to_array()
    }

    fn measure(&self, out: &mut Recorder) {
        // A pixel's centre is up to 0.71 pixels off the middle; from there to a corner colours change by 0.5 at most.
        let tolerance = 0.5 * 0.71 * WINDOW / f64::from(self.fan.size[0]) + 1e-6;
        for (image, cut, corners) in [
            (&self.across, "diamond-1-3-title", &[0, 2][..]),
            (&self.upright, "diamond-2-4-title", &[1, 3]),
            (&self.fan, "diamond-fan-title", &[0, 1, 2, 3]),
        ] {
            out.set("cut", out.text(cut));
            for (axis, colour) in ["red", "green", "blue"].into_iter().enumerate() {
                out.set("colour", out.text(colour));
                let law = Self::mean(corners)[axis];
                out.measure("diamond", "", centre(image)[axis], Check::Near(law, tolerance));
            }
        }
    }

    /// How much the blue of the middle changes with the cut.
    fn change(&self) -> f64 {
        (centre(&self.across)[2] - centre(&self.upright)[2]).abs()
    }

    fn show(self, out: &mut Recorder) {
        let of_all = Self::mean(&[0, 1, 2, 3]);
        let error = |image: &Image| (0..3).map(|k| (centre(image)[k] - of_all[k]).abs()).fold(0.0, f64::max);
        let [across, upright, fan] = [&self.across, &self.upright, &self.fan].map(error);
        // From 0.2 to what half a pixel's diagonal makes of it, an eighth of that in the smallest picture.
        let of_across = out.effect("diamond", "", [across, fan], Threshold::half_step(), 5.0);
        let of_upright = Effect { bad: upright, ..of_across.clone() };
        out.bad("diamond-1-3", &of_across, self.across);
        out.bad("diamond-2-4", &of_upright, self.upright);
        out.cured("diamond-fan", &of_across, self.fan);
    }
}

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
fn diamond(cut: Cut, size: u32) -> Result<Image> {
    let places = [DVec3::X, DVec3::Y, DVec3::NEG_X, DVec3::NEG_Y, DVec3::ZERO];
    let triangles = match cut {
        Cut::Across => vec![[0, 1, 2], [0, 2, 3]],
        Cut::Upright => vec![[0, 1, 3], [1, 2, 3]],
        Cut::Fan => vec![[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]],
    };
    let body = TriangleMesh::new(&places, triangles, &[DVec3::Z; 5]);
    let mean = CORNERS.iter().fold(LinearRgb::BLACK, |sum, &colour| sum + colour) * 0.25;
    let colours: Vec<LinearRgb> = CORNERS.into_iter().chain([mean]).collect();
    let object = Object { paint: Paint::Given(Cow::Owned(colours)), ..body.object(chalk()) };
    let settings =
        RenderSettings { interpolation: Interpolation::Affine, ..settings([size; 2], Shading::Gouraud) };
    draw(vec![object], &[], front(WINDOW), settings)
}

/// A surface of diagonal waves, with its own normals.
fn draw_waves(cells: u32, diagonal: Diagonal, shading: Shading, light: Degrees, size: u32) -> Result<Image> {
    let body = TriangleMesh::grid([cells; 2], diagonal, |u, v| {
        let height = HEIGHT * libm::sin(TAU * WAVES * (u + v));
        (DVec3::new(2.0 * u - 1.0, 2.0 * v - 1.0, height), wave_normal(u, v))
    });
    draw(vec![body.object(chalk())], &[light_at(light)], front(WINDOW), settings([size; 2], shading))
}

/// The normal of the waves; they rise by 2π HEIGHT WAVES / 2 at the most, in x = 2u − 1 as in y = 2v − 1.
fn wave_normal(u: f64, v: f64) -> DVec3 {
    let slope = 0.5 * TAU * WAVES * HEIGHT * libm::cos(TAU * WAVES * (u + v));
    DVec3::new(-slope, -slope, 1.0).normalize()
}

fn exact_waves(light: Degrees, size: u32) -> Image {
    let light = direction(light);
    let at = |pixel: u32| WINDOW * ((f64::from(pixel) + 0.5) / f64::from(size) - 0.5);
    let places = (0..size).flat_map(|y| (0..size).map(move |x| [at(x), -at(y)]));
    let shown = places.map(|[x, y]| {
        if x.abs() > 1.0 || y.abs() > 1.0 {
            return (BACKGROUND.to_array().map(|component| component as f32), 0);
        }
        let cosine = wave_normal(0.5 * (x + 1.0), 0.5 * (y + 1.0)).dot(light);
        ([cosine.max(0.0) as f32; 3], 1)
    });
    let (colours, coverage) = shown.unzip();
    picture([size; 2], colours, coverage)
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
                ("diamond, diagonal 1–3: green", 0.5),
                ("diamond, diagonal 1–3: blue", 0.5),
                ("diamond, diagonal 2–4: green", 0.3),
                ("diamond, diagonal 2–4: blue", 0.1),
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
                outcome.effect.bad > 3.0 / 255.0 && outcome.effect.reduction() > 8.0,
                "{:?}",
                outcome.effect
            );
        }
    }
}
