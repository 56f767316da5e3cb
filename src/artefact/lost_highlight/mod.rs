//! A highlight that falls between vertices.

use super::prelude::*;
use crate::metric::Highlight;
use std::f64::consts::{FRAC_1_SQRT_2, PI, SQRT_2, TAU};

static TEXTS: Catalogue = catalogue!("texts");

pub(super) static EXPERIMENT: Experiment = Experiment {
    takes: &[ParameterName::Size, ParameterName::Segments, ParameterName::Exponent],
    // More would be hardly larger than pixels.
    ranges: &[(ParameterName::Segments, [3.0, 256.0])],
    defaults: Parameters { segments: 16, exponent: 32.0, ..Parameters::USUAL },
    frame: Some(frame),
    ..Experiment::new("lost-highlight", &TEXTS, run)
};

/// The window's side from close by.
const CLOSE: f64 = 1.1;
/// Pictures of one turn by a segment.
const FRAMES: u32 = 8;

/// Whether a vertex at this angle from a highlight has at most e^(−1/2) of its height, its height where it is steepest.
/// A narrower highlight is lost, a wider one is only dulled.
fn is_lost(angle: f64, exponent: f64) -> bool {
    libm::pow(libm::cos(angle), exponent) <= libm::exp(-0.5)
}

/// The largest tolerance for a value of up to 1, or for a length of 1.
const MOST_TOLERANCE: f64 = 0.5;

fn run(setup: &Setup) -> Result<Outcome> {
    let Parameters { segments, exponent, .. } = setup.parameters;
    // A vertex is at most half a segment from the highlight, whose width is that of half a segment from (N/π)² on.
    let least = (f64::from(segments) / PI) * (f64::from(segments) / PI);
    let values = [
        ("segments", f64::from(segments).into()),
        ("exponent", Value::number(exponent)),
        ("least", Value::number(least.round())),
    ];
    let mut out = Recorder::new(&TEXTS, &values);
    plate(&setup.parameters, &mut out)?;
    let effect = Sphere::new(&setup.parameters).record(&mut out)?;
    let verdict = verdict(segments, exponent, &out);
    Ok(out.finish(verdict, effect))
}

/// Whether the highlight is narrower than half a segment, where a vertex is farthest.
fn verdict(segments: u32, exponent: f64, out: &Recorder) -> Verdict {
    match is_lost(PI / f64::from(segments), exponent) {
        true => Verdict::Holds(out.text("holds")),
        false => Verdict::HoldsOnlyIf(out.text("holds-only-if")),
    }
}

fn peak(image: &Image) -> Result<f64> {
    Ok(Highlight::of(image)?.peak)
}

/// The share of its light that a true peak loses in the middle between four pixels.
#[derive(Clone, Copy)]
struct Loss(f64);

impl Loss {
    fn is_small(self) -> bool {
        self.0 < 0.2
    }

    fn reported(self, value: f64) -> f64 {
        if self.is_small() { value } else { 0.0 }
    }

    fn check(self, law: f64, tolerance: f64) -> Check {
        match self.is_small() {
            true => Check::Near(law, tolerance + self.0 * law),
            false => Check::Untested("highlight-below-pixel"),
        }
    }

    /// The light missing at a peak of 1 under Gouraud's shading and Phong's, with the nearest vertex at an angle from it.
    fn missing(self, images: [&Image; 2], angle: f64, out: &Recorder) -> Result<Effect> {
        let bad = self.reported((1.0 - peak(images[0])? - of_diffuse(angle)).max(0.0));
        // No diffuse light is missing: the normals in the middle face the light.
        let cured = self.reported((1.0 - peak(images[1])?).max(0.0));
        // The highlight's middle may lie between four pixels.
        Ok(out.effect("missing", "", [bad, cured], Threshold::half_step(), 5.0))
    }
}

/// The distance in radii from a point to the farthest pixel centre next to it.
fn between_pixels(size: u32) -> f64 {
    FRAC_1_SQRT_2 * WINDOW / f64::from(size)
}

/// The plate whose corners lean away from the light.
fn plate(&Parameters { size, exponent, .. }: &Parameters, out: &mut Recorder) -> Result<()> {
    let draw = |shading| paint(leaning_plate().object(material(exponent)), size, shading);
    let (gouraud, phong) = (draw(Shading::Gouraud)?, draw(Shading::Phong)?);
    let tilt = Radians::from(TILT).0;
    let lean = libm::tan(tilt) * FRAC_1_SQRT_2;
    let loss = Loss(1.0 - law(libm::atan(between_pixels(size) * lean), exponent));
    let check = loss.check(law(tilt, exponent), 2e-3);
    out.measure("plate", "", peak(&gouraud)? / peak(&phong)?, check);
    let effect = loss.missing([&gouraud, &phong], tilt, out)?;
    out.bad("plate-gouraud", &effect, gouraud);
    out.cured("plate-phong", &effect, phong);
    Ok(())
}

struct Sphere {
    size: u32,
    segments: u32,
    exponent: f64,
    delta: f64,
}

impl Sphere {
    fn new(&Parameters { size, segments, exponent, .. }: &Parameters) -> Self {
        Self { size, segments, exponent, delta: TAU / f64::from(segments) }
    }

    fn draw(&self, turn: f64, shading: Shading) -> Result<Image> {
        paint(TriangleMesh::globe(self.segments, turn).object(material(self.exponent)), self.size, shading)
    }

    /// The peak at some turns by up to a segment, in degrees.
    fn peaks(&self, shading: Shading) -> Result<Vec<[f64; 2]>> {
        let turns = (0..=FRAMES).map(|k| self.delta * f64::from(k) / f64::from(FRAMES));
        turns.map(|turn| Ok([Degrees::from(Radians(turn)).0, peak(&self.draw(turn, shading)?)?])).collect()
    }

    fn record(&self, out: &mut Recorder) -> Result<Effect> {
        let &Self { size, exponent, delta, .. } = self;
        let sphere = Shape::Surface(Primitive::from(crate::surface::Sphere::default()));
        let truth = paint(Object::new(sphere, material(exponent)), size, Shading::Exact)?;
        let [worst, cured] =
            [Shading::Gouraud, Shading::Phong].map(|shading| self.draw(delta / 2.0, shading));
        let (worst, cured) = (worst?, cured?);
        let quarter = self.draw(delta / 4.0, Shading::Gouraud)?;
        let (gouraud, phong) = (self.peaks(Shading::Gouraud)?, self.peaks(Shading::Phong)?);
        let loss = Loss(1.0 - law(libm::asin(between_pixels(size)), exponent));
        let flickers = [flicker(&gouraud), flicker(&phong)];
        let beyond = flickers.map(|flicker| (flicker - of_diffuse(0.5 * delta)).max(0.0));
        let displacement = Highlight::change(&quarter, &truth)?.displacement;
        self.measure(Highlight::change(&worst, &truth)?.peak_ratio, displacement, flickers, loss, out);
        out.measure("flicker-beyond-diffuse", "", beyond[0], Check::None);
        let numbers = beyond.map(|flicker| loss.reported(flicker));
        let of_film = out.effect("flicker", "", numbers, Threshold::half_step(), 100.0);
        let of_sphere = loss.missing([&worst, &cured], 0.5 * delta, out)?;
        let is_cured = of_film.is_present() && of_film.is_cured();
        out.set("is-cured", if is_cured { "yes" } else { "no" });
        self.chart(gouraud, phong, out);
        out.bad("sphere-gouraud", &of_sphere, worst);
        out.cured("sphere-phong", &of_sphere, cured);
        out.truth("sphere-exact", truth);
        out.bad("film", &of_film, self.film()?);
        // A sphere that is black throughout does not flicker, but is not cured either.
        Ok(if of_sphere.is_cured() { of_film } else { of_sphere })
    }

    fn measure(
        &self,
        peak_ratio: f64,
        displacement: f64,
        flickers: [f64; 2],
        loss: Loss,
        out: &mut Recorder,
    ) {
        let [gouraud, phong] = flickers;
        let &Self { size, exponent, delta, .. } = self;
        let radius = f64::from(size) / WINDOW;
        let of_nearest = law(delta / 2.0, exponent);
        // A pixel's centre is up to 0.71 pixels from a vertex.
        let tolerance = 0.75 / (2.0 * libm::sin(delta / 2.0) * radius);
        // On facets of few pixels that would allow almost anything.
        let unless =
            |is_coarse, check| if is_coarse { Check::Untested("facets-below-pixels") } else { check };
        let is_coarse = tolerance > MOST_TOLERANCE;
        out.measure("sphere", "", peak_ratio, unless(is_coarse, loss.check(of_nearest, tolerance)));
        let law = radius * libm::sin(delta / 4.0);
        let check = unless(SQRT_2 > MOST_TOLERANCE * law, Check::Near(law, SQRT_2));
        out.measure("displacement", "px", displacement, check);
        let check = unless(is_coarse, Check::Near(1.0 - of_nearest, tolerance));
        out.measure("flicker-gouraud", "", gouraud, check);
        out.measure("flicker-phong", "", phong, Check::None);
    }

    /// Three pictures of a turn by a segment from close by, under Gouraud's shading and Phong's.
    fn film(&self) -> Result<Image> {
        const PICTURES: u32 = 3;
        let row = |shading| {
            let picture = |k: u32| {
                let turn = self.delta * f64::from(k) / f64::from(PICTURES - 1);
                let globe = TriangleMesh::globe(self.segments, turn);
                look(globe.object(material(self.exponent)), self.size / PICTURES - GAP, shading, CLOSE)
            };
            (0..PICTURES).map(picture).collect::<Result<Vec<_>>>()
        };
        Ok(tiles(&[row(Shading::Gouraud)?, row(Shading::Phong)?]))
    }

    fn chart(&self, gouraud: Vec<[f64; 2]>, phong: Vec<[f64; 2]>, out: &mut Recorder) {
        let delta = self.delta;
        let theory = (0..=64).map(|k| {
            let turn = delta * f64::from(k) / 64.0;
            [Degrees::from(Radians(turn)).0, law(turn.min(delta - turn), self.exponent)]
        });
        let curves = vec![
            out.curve("gouraud", Drawn::Points, gouraud),
            out.curve("phong", Drawn::Points, phong),
            out.curve("law", Drawn::Guide, theory.collect()),
        ];
        out.chart("flicker", [Axis::Linear; 2], curves);
    }
}

/// A frame of the sphere turning by two segments, with Gouraud's shading at the left and Phong's at the right.
fn frame(setup: &Setup, number: u32, count: u32) -> Result<Image> {
    let Parameters { size, segments, exponent, .. } = setup.parameters;
    let turn = 2.0 * TAU / f64::from(segments) * f64::from(number) / f64::from(count.max(1));
    let globe = TriangleMesh::globe(segments, turn);
    let paint = |shading| paint(globe.object(material(exponent)), size, shading);
    Ok(tiles(&[vec![paint(Shading::Gouraud)?, paint(Shading::Phong)?]]))
}

/// How far a peak falls, as a share of its largest.
fn flicker(peaks: &[[f64; 2]]) -> f64 {
    let values = || peaks.iter().map(|peak| peak[1]);
    let largest = values().fold(0.0, f64::max);
    (largest - values().fold(f64::INFINITY, f64::min)) / largest
}

/// Of diffuse light; the rest of 1 is highlight.
const DIFFUSE: f64 = 0.4;
/// How far the normals at the corners of the plate lean outwards.
const TILT: Degrees = Degrees(35.0);
/// The window's side; plate and sphere are 2 wide.
const WINDOW: f64 = 2.2;

/// The light on a vertex whose normal is this far from the viewer and the light.
fn law(angle: f64, exponent: f64) -> f64 {
    let cosine = libm::cos(angle);
    DIFFUSE * cosine + (1.0 - DIFFUSE) * libm::pow(cosine, exponent)
}

/// What is missing of the diffuse light of such a vertex.
fn of_diffuse(angle: f64) -> f64 {
    DIFFUSE * (1.0 - libm::cos(angle))
}

fn material(exponent: f64) -> Material {
    shiny([DIFFUSE, 1.0 - DIFFUSE], exponent)
}

/// Two triangles whose normals at the corners lean outwards.
fn leaning_plate() -> TriangleMesh {
    let (sine, cosine) = libm::sincos(Radians::from(TILT).0);
    TriangleMesh::grid([1, 1], Diagonal::Rising, |u, v| {
        let place = DVec3::new(2.0 * u - 1.0, 2.0 * v - 1.0, 0.0);
        (place, place * (sine / SQRT_2) + DVec3::Z * cosine)
    })
}

/// Light and viewer in front, far away.
fn paint(object: Object, size: u32, shading: Shading) -> Result<Image> {
    look(object, size, shading, WINDOW)
}

/// The same through a window of any side.
fn look(object: Object, size: u32, shading: Shading, window: f64) -> Result<Image> {
    draw(vec![object], &[far_light(DVec3::Z)], front(window), settings([size; 2], shading))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn highlights_are_lost_and_found() {
        // The last: 1 − 0.4 cos(Δ/2) − 0.6 cosⁿ(Δ/2), computed outside this program.
        for (segments, exponent, flicker) in [(12, 16.0, 0.2691), (16, 32.0, 0.2852), (24, 100.0, 0.3493)] {
            let parameters = Parameters { size: 160, segments, exponent, ..EXPERIMENT.defaults };
            let outcome = EXPERIMENT.run(&Setup { parameters, mesh: None }).unwrap();
            outcome.prove();
            // Present: a tenth of the peak at least. Cured: what the raster of pixels leaves, less than a tenth of that.
            // A pixel's centre is up to 0.71 pixels from the vertex, of an edge of 15 pixels and more.
            let found = outcome.measured("Gouraud: flicker");
            assert!((found - flicker).abs() < 0.05, "{found}");
            // Of that, 0.4 parts of diffuse light fall by 1 − cos(Δ/2) on their own.
            let alone = 0.4 * (1.0 - libm::cos(PI / f64::from(segments)));
            let beyond = outcome.measured("Gouraud: flicker of the peak beyond");
            assert!((found - beyond - alone).abs() < 1e-12, "{beyond} of {found}");
            assert!(outcome.effect.bad > 0.1 && outcome.effect.reduction() > 10.0, "{:?}", outcome.effect);
            let peak = |name: &str| {
                let shot = outcome.shots.iter().find(|shot| shot.name == name).unwrap();
                Highlight::of(&shot.image).unwrap().peak
            };
            assert!(peak("plate-gouraud") < 0.5 * peak("plate-phong"));
            assert!(peak("sphere-gouraud") < peak("sphere-phong"));
            let still = EXPERIMENT.frame(&Setup { parameters, mesh: None }, 0, 2).unwrap();
            assert_eq!(still.size, [2 * 160 + 2, 160]);
        }
    }

    #[test]
    fn what_is_no_highlight_is_not_lost() {
        for (segments, exponent) in [(16, 0.0), (200, 1.0), (200, 32.0)] {
            let parameters = Parameters { size: 48, segments, exponent, ..EXPERIMENT.defaults };
            let outcome = EXPERIMENT.run(&Setup { parameters, mesh: None }).unwrap();
            assert!(
                matches!(outcome.verdict, Verdict::Absent(_)),
                "{segments} {exponent}: {:?}",
                outcome.effect
            );
        }
    }

    /// A highlight as wide as diffuse light loses 0.6 (1 − cos(Δ/2)) = 0.0115 between vertices: it is seen, and no loss.
    #[test]
    fn what_is_wide_is_dulled() {
        let parameters = Parameters { size: 160, segments: 16, exponent: 1.0, ..EXPERIMENT.defaults };
        let outcome = EXPERIMENT.run(&Setup { parameters, mesh: None }).unwrap();
        assert!(matches!(outcome.verdict, Verdict::HoldsOnlyIf(_)), "{:?}", outcome.verdict);
        // The brightest pixel is up to 0.71 pixels from a vertex, of an edge of 28: a fortieth of that fall of diffuse light.
        assert!((outcome.effect.bad - 0.0115).abs() < 0.0192 / 28.0, "{:?}", outcome.effect);
    }

    /// At the usual exponent the highlight is narrower than half a segment of 16, of 12 too, of 24 not.
    #[test]
    fn what_is_wider_than_facets_is_not_lost() {
        for (segments, exponent, holds) in
            [(16, 32.0, true), (12, 32.0, true), (24, 32.0, false), (16, 10.0, false)]
        {
            let verdict = verdict(segments, exponent, &Recorder::new(&TEXTS, &[]));
            assert_eq!(matches!(verdict, Verdict::Holds(_)), holds, "{segments} {exponent}: {verdict:?}");
        }
    }
}
