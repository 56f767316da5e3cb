//! When one colour a face is right.

mod pictures;
mod texts;

use super::stage::{chalk, draw, front, object, settings};
use super::{
    ArtefactError, Chart, Curve, Drawn, Experiment, Knob, Measure, Moved, Outcome, Parameters, Scale, Setup,
    Text, Threshold, Verdict,
};
use crate::mesh::{Faces, Mesh, MeshBuilder};
use crate::metric::image_error;
use crate::normals::{NormalRecipe, compute};
use crate::num::{Degrees, LinearRgb, Radians, steepest_slope};
use crate::raster::{Camera, Image, Interpolation, Projection, Shading};
use crate::shade::{Attenuation, Light, Material, Reflectance, Reflection};
use glam::DVec3;
use std::f64::consts::SQRT_2;
use texts::TEXTS;

pub(super) static EXPERIMENT: Experiment = Experiment {
    id: "flat-validity",
    texts: &TEXTS,
    takes: &[Knob::Size, Knob::Segments, Knob::Light, Knob::Exponent],
    // More would be hardly larger than pixels.
    segments: 3..=256,
    defaults: Parameters { segments: 12, light: Degrees(45.0), exponent: 32.0, ..Parameters::USUAL },
    run,
    frame: None,
};

/// Distances in circumradii of the face.
const RATIOS: [f64; 6] = [2.0, 5.0, 10.0, 50.0, 100.0, 510.0];
/// The circumradius of the plate of side 2.
const RADIUS: f64 = SQRT_2;

fn run(setup: &Setup) -> Result<Outcome, ArtefactError> {
    let Parameters { size, segments, light, exponent, .. } = setup.parameters;
    let mut measures = Vec::new();
    let (mut diffuse, mut specular) = (Vec::new(), Vec::new());
    let held = |measure: Measure, viewer: Viewer| {
        let (law, steepest) = viewer.law(size);
        // Cosines are rounded by up to 2·10⁻⁷ in each picture; below an exponent of 1 their power may be as steep as can be.
        let rounding = (4e-7 * steepest + 2e-7).min(2e-6 + 4e-7 * exponent);
        measure.expect(law, rounding, single())
    };
    for ratio in RATIOS {
        let distance = ratio * RADIUS;
        let lamp = Lamp { angle: light, distance };
        let found = lamp.error(1, size)?;
        diffuse.push([ratio, found]);
        measures.push(
            Measure::new(TEXTS.with("measure-lamp-ratio-circumradii", &[("ratio", ratio.into())]), "", found)
                .expect(lamp.law(1, size).1, 2e-6, single()),
        );
        let viewer = Viewer { angle: light, distance, exponent };
        let found = viewer.error(1, size)?;
        specular.push([ratio, found]);
        let measure = Measure::new(
            TEXTS.with("measure-viewer-ratio-circumradii", &[("ratio", ratio.into())]),
            "",
            found,
        );
        measures.push(match libm::cos(Radians::from(light).0).abs() > 1e-6 {
            true => held(measure, viewer),
            false => measure.beyond(TEXTS.get("untested-light-along-plate")),
        });
    }
    let aside = Viewer { angle: pictures::ASIDE, distance: RATIOS[0] * RADIUS, exponent };
    let measure = Measure::new(
        TEXTS.with(
            "measure-viewer-ratios-circumradii",
            &[("ratios-0", (RATIOS[0]).into()), ("value", pictures::ASIDE.0.into())],
        ),
        "",
        aside.error(1, size)?,
    );
    measures.push(held(measure, aside));
    let bound = |ratio: f64| 2.0 * libm::sin(0.5 * libm::asin(1.0 / ratio));
    let share = diffuse.iter().map(|&[ratio, error]| error / bound(ratio)).fold(0.0, f64::max);
    // Below an exponent of 1 the slope of cosⁿ has no bound; light along the plate is on or off.
    let is_bounded = exponent >= 1.0 && light.0.abs() < 89.9;
    let of_viewer = specular.iter().filter(|_| is_bounded);
    let of_viewer =
        of_viewer.map(|&[ratio, error]| error / (steepest_slope(exponent) * libm::asin(1.0 / ratio)));
    let share = share.max(of_viewer.fold(0.0, f64::max));
    measures.push(
        Measure::new(TEXTS.get("measure-largest-error-over"), "", share)
            .at_most(1.0, TEXTS.get("by-bounds-hold")),
    );
    let near = Lamp { angle: light, distance: RATIOS[0] * RADIUS };
    let cured = near.error(segments, size)?;
    let (least, most) = near.law(segments, size);
    measures.push(
        Measure::new(
            TEXTS.with("measure-lamp-circumradii-segments", &[("segments", segments.into())]),
            "",
            cured,
        )
        .expect(0.5 * (least + most), 0.5 * (most - least) + 1e-5, single()),
    );
    let moved = Moved {
        name: TEXTS.get("moved"),
        unit: "",
        bad: diffuse[0][1],
        present: Threshold::HALF_STEP,
        cure: TEXTS.with("cure", &[("segments", segments.into())]),
        cured,
        // Both follow their laws to a few units of single precision.
        factor: (0.99 * near.law(1, size).0 / most).max(1.0),
    };
    let mut shots = pictures::of_box(size, segments)?;
    shots.extend(pictures::of_plate(&near, &moved, segments, size)?);
    shots.extend(pictures::of_highlight(exponent, segments, size)?);
    Ok(Outcome {
        verdict: Verdict::HoldsOnlyIf(TEXTS.get("holds-only-if-light-or-viewer")),
        moved,
        measures,
        shots,
        charts: vec![chart(diffuse, specular, exponent, is_bounded)],
        notes: vec![TEXTS.get("note-counts-light-distance")],
    })
}

fn single() -> Text {
    TEXTS.get("formula-light-every")
}

/// The plate of side 2 facing +z, cut into squares.
fn plate(cells: u32) -> Result<Mesh, ArtefactError> {
    squares(cells, &[(DVec3::new(-1.0, -1.0, 0.0), DVec3::X * 2.0, DVec3::Y * 2.0)])
}

/// Parallelograms, given by a corner and two sides, cut into so many smaller ones each way.
fn squares(cells: u32, sides: &[(DVec3, DVec3, DVec3)]) -> Result<Mesh, ArtefactError> {
    let (mut positions, mut corners) = (Vec::new(), Vec::new());
    for &(corner, along, up) in sides {
        let first = positions.len() as u32;
        let row = cells + 1;
        let share = |k: u32| f64::from(k) / f64::from(cells);
        positions.extend((0..row * row).map(|k| corner + along * share(k % row) + up * share(k / row)));
        corners.extend((0..cells * cells).flat_map(|k| {
            let a = first + k / cells * row + k % cells;
            [a, a + 1, a + 1 + row, a + row]
        }));
    }
    let count = corners.len() as u32 / 4;
    let faces = Faces::polygons(corners, (0..=count).map(|k| 4 * k).collect());
    Ok(MeshBuilder { positions, faces, ..MeshBuilder::default() }.build()?)
}

/// The centres of the pixels of a picture of the plate.
fn centres(size: u32) -> impl Iterator<Item = DVec3> {
    let place = move |k: u32| (f64::from(k) + 0.5) * 2.0 / f64::from(size) - 1.0;
    (0..size * size).map(move |k| DVec3::new(place(k % size), -place(k / size), 0.0))
}

fn towards(angle: Degrees) -> DVec3 {
    let (sine, cosine) = libm::sincos(Radians::from(angle).0);
    DVec3::new(sine, 0.0, cosine)
}

/// A lamp over the plate's middle, and chalk.
struct Lamp {
    angle: Degrees,
    distance: f64,
}

impl Lamp {
    /// Flat shading against shading every pixel.
    fn error(&self, cells: u32, size: u32) -> Result<f64, ArtefactError> {
        difference(cells, chalk(), self.light(), front(2.0), size)
    }

    fn light(&self) -> Light {
        let position = towards(self.angle) * self.distance;
        Light::Point { position, colour: LinearRgb::WHITE, attenuation: Attenuation::None }
    }

    /// The same by the formula: N·L at the pixel and at the middle of its square. Edges snap to 256ths of pixels, so that the
    /// centre of a pixel on an edge may count to either square: the least and the most that the error may be.
    fn law(&self, cells: u32, size: u32) -> (f64, f64) {
        let lamp = towards(self.angle) * self.distance;
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
    fn error(&self, cells: u32, size: u32) -> Result<f64, ArtefactError> {
        let (material, light, camera) = self.scene();
        difference(cells, material, light, camera, size)
    }

    fn scene(&self) -> (Material, Light, Camera) {
        let material = Material {
            ambient: Reflectance::NONE,
            diffuse: Reflectance::NONE,
            specular: Reflectance::Merged(LinearRgb::WHITE),
            exponent: self.exponent,
            reflection: Reflection::Phong,
        };
        let light = Light::Directional { towards: towards(self.angle), colour: LinearRgb::WHITE };
        let camera = Camera {
            eye: DVec3::Z * self.distance,
            projection: Projection::Perspective(Radians(2.0 * libm::atan(1.0 / self.distance))),
            near: 0.5 * self.distance,
            ..front(2.0)
        };
        (material, light, camera)
    }

    /// The same by the formula: (V·R)ⁿ at the pixel and in the middle, and nothing by the guard from behind. Then the steepest
    /// slope of that power at a pixel, which is how far an error of the cosine shows.
    fn law(&self, size: u32) -> (f64, f64) {
        if self.angle.0.abs() >= 90.0 {
            return (0.0, 0.0);
        }
        let eye = DVec3::Z * self.distance;
        let mirrored = towards(Degrees(-self.angle.0));
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

/// The largest difference of flat shading and shading every pixel.
fn difference(
    cells: u32,
    material: Material,
    light: Light,
    camera: Camera,
    size: u32,
) -> Result<f64, ArtefactError> {
    let paint = |shading| paint_plate(cells, material, light, camera, size, shading);
    Ok(image_error(&paint(Shading::Flat)?, &paint(Shading::Phong)?, 0.5)?.linear.max / 255.0)
}

fn paint_plate(
    cells: u32,
    material: Material,
    light: Light,
    camera: Camera,
    size: u32,
    shading: Shading,
) -> Result<Image, ArtefactError> {
    let mesh = plate(cells)?;
    let normals = compute(&mesh, &NormalRecipe::default());
    let settings = settings([size; 2], shading, Interpolation::Perspective);
    draw(vec![object(&mesh, &normals, material)], &[light], camera, &settings)
}

fn chart(diffuse: Vec<[f64; 2]>, specular: Vec<[f64; 2]>, exponent: f64, is_bounded: bool) -> Chart {
    let angle = |ratio: f64| libm::asin(1.0 / ratio);
    let bound = |of: &dyn Fn(f64) -> f64| RATIOS.iter().map(|&ratio| [ratio, of(ratio)]).collect::<Vec<_>>();
    let curve = |name, drawn, points| Curve { name, drawn, points };
    Chart {
        name: "error-by-distance",
        title: TEXTS.get("chart-title"),
        caption: match is_bounded {
            true => TEXTS.get("chart-caption"),
            false => TEXTS.get("chart-caption-error-diffuse-light"),
        },
        x: Scale::log(TEXTS.get("axis-distance-circumradii-face")),
        y: Scale::log(TEXTS.get("axis-largest-error")),
        curves: vec![
            curve(TEXTS.get("lamp-diffuse"), Drawn::Points, diffuse),
            curve(TEXTS.get("viewer-highlight"), Drawn::Points, specular),
            curve(
                TEXTS.get("bound-diffuse"),
                Drawn::Guide,
                bound(&|ratio| 2.0 * libm::sin(0.5 * angle(ratio))),
            ),
            curve(
                TEXTS.get("bound-highlight"),
                Drawn::Guide,
                bound(&|ratio| steepest_slope(exponent) * angle(ratio)),
            ),
            curve(TEXTS.get("half-step-bits"), Drawn::Guide, bound(&|_| 0.5 / 255.0)),
        ],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn without_light_nothing_is_claimed() {
        let parameters = Parameters { size: 32, light: Degrees(180.0), ..EXPERIMENT.defaults };
        let outcome = EXPERIMENT.run(&Setup { parameters, mesh: None }).unwrap();
        assert!(matches!(outcome.verdict, Verdict::Absent(_)), "{:?}", outcome.moved);
    }

    /// The law once had a highlight of exponent 0 on all of the plate.
    #[test]
    fn highlights_end_where_the_mirrored_ray_leads_away() {
        let parameters = Parameters { size: 32, light: Degrees(81.58), exponent: 0.0, ..EXPERIMENT.defaults };
        let outcome = EXPERIMENT.run(&Setup { parameters, mesh: None }).unwrap();
        assert_eq!(outcome.measured("viewer at 2 circumradii"), 1.0);
        assert!(outcome.measures.iter().all(|measure| measure.agrees() != Some(false)), "{outcome:?}");
    }

    #[test]
    fn errors_are_those_of_the_formula_and_fall_with_distance() {
        for (light, segments) in [(0.0, 8), (45.0, 12)] {
            let parameters = Parameters { size: 96, segments, light: Degrees(light), ..EXPERIMENT.defaults };
            let outcome = EXPERIMENT.run(&Setup { parameters, mesh: None }).unwrap();
            outcome.prove();
            // At two circumradii an edge's ends are seen from the lamp at up to 30°: no more than 2 sin 15°.
            let near = outcome.measured("lamp at 2 circumradii: largest");
            assert!(near == outcome.moved.bad && near < 0.5177, "{near}");
            // Present: ten steps of 8 bits at least. Cured: each face is a segments-th as wide.
            assert!(outcome.moved.bad > 10.0 / 255.0, "{:?}", outcome.moved);
            assert!(outcome.moved.reduction() > 0.5 * f64::from(segments), "{:?}", outcome.moved);
            let diffuse = &outcome.charts[0].curves[0].points;
            assert!(diffuse.windows(2).all(|pair| pair[1][1] < pair[0][1]));
            // Half a step at 510 circumradii.
            assert!(diffuse[5][1] <= 0.5 / 255.0, "{diffuse:?}");
        }
    }
}
