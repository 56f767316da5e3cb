//! When one colour for each face is exact.

use super::prelude::*;
use crate::num::steepest_slope;
use std::f64::consts::SQRT_2;

static TEXTS: Catalogue = catalogue!("texts");

pub(super) static EXPERIMENT: Experiment = Experiment {
    takes: &[ParameterName::Size, ParameterName::Segments, ParameterName::Light, ParameterName::Exponent],
    // More would be hardly larger than pixels.
    ranges: &[(ParameterName::Segments, [3.0, 256.0])],
    defaults: Parameters { segments: 12, light: Degrees(45.0), exponent: 32.0, ..Parameters::USUAL },
    ..Experiment::new("flat-validity", &TEXTS, run)
};

fn run(setup: &Setup) -> Result<Outcome> {
    let Parameters { size, segments, light, exponent, .. } = setup.parameters;
    let values = [("segments", segments.into()), ("exponent", exponent.into()), ("aside", ASIDE.0.into())];
    let mut out = Recorder::new(&TEXTS, &values);
    let errors = Errors::measure(&setup.parameters, &mut out)?;
    errors.measure_share_of_bounds(&setup.parameters, &mut out);
    let near = Lamp { angle: light, distance: RATIOS[0] * RADIUS };
    let cured = near.error(segments, size)?;
    let (least, most) = near.law(segments, size);
    let check = Check::Near(0.5 * (least + most), 0.5 * (most - least) + 1e-5);
    out.measure("lamp-small-faces", "", cured, check);
    // Both follow their laws to a few units of single precision.
    let factor = (0.99 * near.law(1, size).0 / most).max(1.0);
    let effect = out.effect("plate", "", [errors.diffuse[0][1], cured], Threshold::half_step(), factor);
    show_box(size, segments, &mut out)?;
    show_plate(&near, &effect, segments, size, &mut out)?;
    show_highlight(exponent, segments, size, &mut out)?;
    errors.chart(exponent, &mut out);
    Ok(out.finish(Verdict::HoldsOnlyIf(out.text("holds-only-if")), effect))
}

/// The largest errors of one flat face, by distance in circumradii.
struct Errors {
    diffuse: Vec<[f64; 2]>,
    highlight: Vec<[f64; 2]>,
}

impl Errors {
    fn measure(&Parameters { size, light, exponent, .. }: &Parameters, out: &mut Recorder) -> Result<Self> {
        let mut errors = Self { diffuse: Vec::new(), highlight: Vec::new() };
        for ratio in RATIOS {
            out.set("ratio", ratio);
            let distance = ratio * RADIUS;
            let lamp = Lamp { angle: light, distance };
            let found = lamp.error(1, size)?;
            errors.diffuse.push([ratio, found]);
            out.measure("lamp", "", found, Check::Near(lamp.law(1, size).1, 2e-6));
            let viewer = Viewer { angle: light, distance, exponent };
            let found = viewer.error(1, size)?;
            errors.highlight.push([ratio, found]);
            let check = match libm::cos(Radians::from(light).0).abs() > 1e-6 {
                true => of_highlight(&viewer, size),
                false => Check::Untested("light-along-plate"),
            };
            out.measure("viewer", "", found, check);
        }
        out.set("ratio", RATIOS[0]);
        let aside = Viewer { angle: ASIDE, distance: RATIOS[0] * RADIUS, exponent };
        out.measure("viewer-aside", "", aside.error(1, size)?, of_highlight(&aside, size));
        Ok(errors)
    }

    fn measure_share_of_bounds(&self, &Parameters { light, exponent, .. }: &Parameters, out: &mut Recorder) {
        let share = self.diffuse.iter().map(|&[ratio, error]| error / bound(ratio)).fold(0.0, f64::max);
        // Below an exponent of 1 the slope of cosⁿ has no bound; light along the plate is on or off.
        let is_bounded = exponent >= 1.0 && light.0.abs() < 89.9;
        out.set("is-bounded", if is_bounded { "yes" } else { "no" });
        let of_viewer = self.highlight.iter().filter(|_| is_bounded);
        let of_viewer =
            of_viewer.map(|&[ratio, error]| error / (steepest_slope(exponent) * libm::asin(1.0 / ratio)));
        out.measure("share-of-bound", "", share.max(of_viewer.fold(0.0, f64::max)), Check::AtMost(1.0));
    }

    fn chart(self, exponent: f64, out: &mut Recorder) {
        let by_ratio = |of: &dyn Fn(f64) -> f64| RATIOS.iter().map(|&ratio| [ratio, of(ratio)]).collect();
        let of_highlight = |ratio: f64| steepest_slope(exponent) * libm::asin(1.0 / ratio);
        let curves = vec![
            out.curve("lamp", Drawn::Points, self.diffuse),
            out.curve("viewer", Drawn::Points, self.highlight),
            out.curve("bound-diffuse", Drawn::Guide, by_ratio(&bound)),
            out.curve("bound-highlight", Drawn::Guide, by_ratio(&of_highlight)),
            out.curve("half-step", Drawn::Guide, by_ratio(&|_| 0.5 / 255.0)),
        ];
        out.chart("error-by-distance", [Axis::Log; 2], curves);
    }
}

fn bound(ratio: f64) -> f64 {
    2.0 * libm::sin(0.5 * libm::asin(1.0 / ratio))
}

fn of_highlight(viewer: &Viewer, size: u32) -> Check {
    let (law, steepest) = viewer.law(size);
    // Cosines are rounded by up to 2·10⁻⁷ in each picture; below an exponent of 1 their power may be as steep as can be.
    Check::Near(law, (4e-7 * steepest + 2e-7).min(2e-6 + 4e-7 * viewer.exponent))
}

fn show_plate(lamp: &Lamp, effect: &Effect, segments: u32, size: u32, out: &mut Recorder) -> Result<()> {
    let paint = |cells| paint_plate(cells, chalk(), lamp.light(), front(2.0), size, Shading::Flat);
    out.bad("plate", effect, paint(1)?);
    out.cured("plate-small-faces", effect, paint(segments)?);
    Ok(())
}

/// A box under a lamp that is near its upper corner, and far away in the same direction.
fn show_box(size: u32, segments: u32, out: &mut Recorder) -> Result<()> {
    let sides = [
        (DVec3::new(-1.0, -1.0, 1.0), DVec3::X * 2.0, DVec3::Y * 2.0),
        (DVec3::new(1.0, -1.0, 1.0), DVec3::Z * -2.0, DVec3::Y * 2.0),
        (DVec3::new(-1.0, 1.0, 1.0), DVec3::X * 2.0, DVec3::Z * -2.0),
    ];
    let camera = Camera { eye: DVec3::new(60.0, 45.0, 80.0), ..front(3.8) };
    let place = DVec3::new(1.5, 1.8, 2.1);
    let paint = |cells: u32, away: f64, shading| -> Result<Image> {
        let mesh = squares(cells, &sides)?;
        let normals = compute(&mesh, &NormalRecipe::default());
        let object = object(&mesh, &normals, chalk());
        draw(vec![object], &[lamp(place * away)], camera, settings([size; 2], shading))
    };
    let near = paint(1, 1.0, Shading::Phong)?;
    let [flat, cut_up] = [1, segments].map(|cells| paint(cells, 1.0, Shading::Flat));
    let (flat, cut_up, far) = (flat?, cut_up?, paint(1, 100.0, Shading::Flat)?);
    // Of faces a third as long already.
    let errors = [largest_error(&flat, &near)?, largest_error(&cut_up, &near)?];
    let small = out.effect("small-faces", "", errors, Threshold::half_step(), 2.0);
    let cured = largest_error(&far, &paint(1, 100.0, Shading::Phong)?)?;
    let away = Effect { cured, factor: 10.0, ..small.clone() };
    out.bad("flat", &small, flat);
    out.truth("every-pixel", near);
    out.cured("flat-small-faces", &small, cut_up);
    out.cured("flat-lamp-far", &away, far);
    Ok(())
}

/// How far to the side the light stands whose highlight a near viewer sees on the plate: closer to the axis than its edges.
const ASIDE: Degrees = Degrees(15.0);

/// The plate with nothing but a highlight, its viewer at two circumradii.
fn show_highlight(exponent: f64, segments: u32, size: u32, out: &mut Recorder) -> Result<()> {
    let viewer = Viewer { angle: ASIDE, distance: RATIOS[0] * RADIUS, exponent };
    let (material, light, camera) = viewer.scene();
    let paint = |cells, shading| paint_plate(cells, material, light, camera, size, shading);
    // With an error that is only a few steps smaller the squares would still be seen.
    let errors = [viewer.error(1, size)?, viewer.error(segments, size)?];
    let effect = out.effect("highlight", "", errors, Threshold::half_step(), 20.0);
    out.bad("highlight", &effect, paint(1, Shading::Flat)?);
    out.truth("highlight-every-pixel", paint(1, Shading::Phong)?);
    out.cured("highlight-small-faces", &effect, paint(segments, Shading::Flat)?);
    Ok(())
}

/// Distances in circumradii of the face.
const RATIOS: [f64; 6] = [2.0, 5.0, 10.0, 50.0, 100.0, 510.0];
/// The circumradius of the plate of side 2.
const RADIUS: f64 = SQRT_2;

fn plate(cells: u32) -> Result<Mesh> {
    squares(cells, &[(DVec3::new(-1.0, -1.0, 0.0), DVec3::X * 2.0, DVec3::Y * 2.0)])
}

/// Parallelograms, given by a corner and two sides, cut into so many smaller ones each way.
fn squares(cells: u32, sides: &[(DVec3, DVec3, DVec3)]) -> Result<Mesh> {
    let row = cells + 1;
    let share = |k: u32| f64::from(k) / f64::from(cells);
    let corners = sides.iter().flat_map(|&(corner, along, up)| {
        (0..row * row).map(move |k| corner + along * share(k % row) + up * share(k / row))
    });
    sheets(corners.collect(), [cells; 2])
}

fn centres(size: u32) -> impl Iterator<Item = DVec3> {
    let place = move |k: u32| (f64::from(k) + 0.5) * 2.0 / f64::from(size) - 1.0;
    (0..size * size).map(move |k| DVec3::new(place(k % size), -place(k / size), 0.0))
}

struct Lamp {
    angle: Degrees,
    distance: f64,
}

impl Lamp {
    /// Flat shading against shading every pixel.
    fn error(&self, cells: u32, size: u32) -> Result<f64> {
        difference(cells, chalk(), self.light(), front(2.0), size)
    }

    fn light(&self) -> Light {
        lamp(direction(self.angle) * self.distance)
    }

    /// The same by the formula: N·L at the pixel and at the middle of its square. Pixels on an edge may count to either square, since
    /// edges snap to 256ths of pixels: the least and the most that the error may be.
    fn law(&self, cells: u32, size: u32) -> (f64, f64) {
        let lamp = direction(self.angle) * self.distance;
        let light = |point: DVec3| ((lamp - point).z / (lamp - point).length()).max(0.0);
        let side = 2.0 / f64::from(cells);
        let snap = f64::from(cells) / (256.0 * f64::from(size));
        let middles = |x: f64| {
            let place = (x + 1.0) / side;
            [place - snap, place + snap].map(|place| (place.floor() + 0.5) * side - 1.0)
        };
        let errors = |p: DVec3| {
            let [[left, right], [low, high]] = [p.x, p.y].map(middles);
            let places = [(left, low), (left, high), (right, low), (right, high)];
            let errors = places.map(|(x, y)| (light(p) - light(DVec3::new(x, y, 0.0))).abs());
            (errors.into_iter().fold(f64::INFINITY, f64::min), errors.into_iter().fold(0.0, f64::max))
        };
        let larger = |(least, most): (f64, f64), (a, b): (f64, f64)| (least.max(a), most.max(b));
        centres(size).map(errors).fold((0.0, 0.0), larger)
    }
}

/// A viewer over the plate's middle, and nothing but Phong's highlight of a far light.
struct Viewer {
    angle: Degrees,
    distance: f64,
    exponent: f64,
}

impl Viewer {
    /// Flat shading against shading every pixel.
    fn error(&self, cells: u32, size: u32) -> Result<f64> {
        let (material, light, camera) = self.scene();
        difference(cells, material, light, camera, size)
    }

    fn scene(&self) -> (Material, Light, Camera) {
        let material = Material { reflection: Reflection::Phong, ..shiny([0.0, 1.0], self.exponent) };
        let light = light_at(self.angle);
        let camera = Camera {
            eye: DVec3::Z * self.distance,
            projection: Projection::Perspective(Radians(2.0 * libm::atan(1.0 / self.distance))),
            near: 0.5 * self.distance,
            ..front(2.0)
        };
        (material, light, camera)
    }

    /// The same by the formula, (V·R)ⁿ at the pixel and in the middle; and the steepest slope of that power at a pixel.
    fn law(&self, size: u32) -> (f64, f64) {
        if self.angle.0.abs() >= 90.0 {
            return (0.0, 0.0);
        }
        let eye = DVec3::Z * self.distance;
        let mirrored = direction(Degrees(-self.angle.0));
        let cosine = |point: DVec3| (eye - point).normalize().dot(mirrored);
        // Even an exponent of 0 gives nothing where the mirrored ray leads away.
        let highlight = |cosine: f64| if cosine > 0.0 { libm::pow(cosine, self.exponent) } else { 0.0 };
        let slope = |cosine: f64| self.exponent * libm::pow(cosine.max(0.0), self.exponent - 1.0);
        let middle = highlight(cosine(DVec3::ZERO));
        let larger = |(off, steepest): (f64, f64), cosine: f64| {
            (off.max((highlight(cosine) - middle).abs()), steepest.max(slope(cosine)))
        };
        centres(size).map(cosine).fold((0.0, 0.0), larger)
    }
}

fn difference(cells: u32, material: Material, light: Light, camera: Camera, size: u32) -> Result<f64> {
    let paint = |shading| paint_plate(cells, material, light, camera, size, shading);
    largest_error(&paint(Shading::Flat)?, &paint(Shading::Phong)?)
}

fn paint_plate(
    cells: u32,
    material: Material,
    light: Light,
    camera: Camera,
    size: u32,
    shading: Shading,
) -> Result<Image> {
    let mesh = plate(cells)?;
    let normals = compute(&mesh, &NormalRecipe::default());
    draw(vec![object(&mesh, &normals, material)], &[light], camera, settings([size; 2], shading))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn without_light_nothing_is_claimed() {
        let parameters = Parameters { size: 32, light: Degrees(180.0), ..EXPERIMENT.defaults };
        let outcome = EXPERIMENT.run(&Setup { parameters, mesh: None }).unwrap();
        assert!(matches!(outcome.verdict, Verdict::Absent(_)), "{:?}", outcome.effect);
    }

    /// The law once had a highlight of exponent 0 on all of the plate.
    #[test]
    fn highlights_end_where_the_mirrored_ray_leads_away() {
        let parameters = Parameters { size: 32, light: Degrees(81.58), exponent: 0.0, ..EXPERIMENT.defaults };
        let outcome = EXPERIMENT.run(&Setup { parameters, mesh: None }).unwrap();
        assert_eq!(outcome.measured("viewer at 2 circumradii"), 1.0);
        assert!(outcome.measures.iter().all(|measure| measure.agrees != Some(false)), "{outcome:?}");
    }

    #[test]
    fn errors_are_those_of_the_formula_and_fall_with_distance() {
        for (light, segments) in [(0.0, 8), (45.0, 12)] {
            let parameters = Parameters { size: 96, segments, light: Degrees(light), ..EXPERIMENT.defaults };
            let outcome = EXPERIMENT.run(&Setup { parameters, mesh: None }).unwrap();
            outcome.prove();
            // At two circumradii an edge's ends are seen from the lamp at up to 30°: no more than 2 sin 15°.
            let near = outcome.measured("point light at 2 circumradii: largest");
            assert!(near == outcome.effect.bad && near < 0.5177, "{near}");
            // Present: ten steps of 8 bits at least. Cured: each face is a segments-th as wide.
            assert!(outcome.effect.bad > 10.0 / 255.0, "{:?}", outcome.effect);
            assert!(outcome.effect.reduction() > 0.5 * f64::from(segments), "{:?}", outcome.effect);
            let diffuse = &outcome.charts[0].curves[0].points;
            assert!(diffuse.windows(2).all(|pair| pair[1][1] < pair[0][1]));
            // Half a step at 510 circumradii.
            assert!(diffuse[5][1] <= 0.5 / 255.0, "{diffuse:?}");
        }
    }
}
