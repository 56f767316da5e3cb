//! What rounding of positions and normals does to a highlight.

mod needles;
mod plate;
mod texts;

use super::body::{Body, Diagonal};
use super::stage::{draw, front, settings};
use super::{
    ArtefactError, Experiment, Knob, Language, Measure, Moved, Outcome, Parameters, Setup, Text, Threshold,
    Verdict,
};
use crate::metric::{NormalDeviation, image_error, normal_deviation};
use crate::normals::encoding::{Encoding, Snorm};
use crate::num::{Degrees, LinearRgb, Radians, steepest_slope};
use crate::raster::{Image, Interpolation, Object, RenderSettings, Shading, Shape, Show};
use crate::shade::{Light, Material, Reflectance, Reflection};
use crate::surface::{Primitive, Sphere};
use glam::{DVec3, Vec3};
use std::f64::consts::FRAC_1_SQRT_2;
use texts::TEXTS;

pub(super) static EXPERIMENT: Experiment = Experiment {
    id: "precision",
    texts: &TEXTS,
    takes: &[Knob::Size, Knob::Segments, Knob::Exponent],
    segments: Parameters::SEGMENTS,
    defaults: Parameters { segments: 24, exponent: 2000.0, ..Parameters::USUAL },
    run,
    frame: None,
};

/// The window's side: a close look at the highlight on a sphere of radius 1.
const WINDOW: f64 = 0.25;
/// The part of the sphere that is modelled: so many radians to all sides of +z, more than the window shows.
const REACH: f64 = 0.16;
/// How far from the origin the sphere is modelled, in radii.
const AWAY: f64 = 3e3;

fn run(setup: &Setup) -> Result<Outcome, ArtefactError> {
    let Parameters { size, segments, exponent, .. } = setup.parameters;
    let globe = Body::cap(segments);
    let stored = |encoding: Encoding| globe.with_normals(|n| encoding.decode(encoding.encode(n)));
    let (eight, sixteen) = (stored(Encoding::Snorm(Snorm::EIGHT)), stored(Encoding::OCTAHEDRAL_16));
    let far = globe.far_away(AWAY);
    let scene = Scene { size };
    let truth = scene.normals(&exact(exponent), Shading::Exact)?;
    let deviation = |body: &Body| -> Result<NormalDeviation, ArtefactError> {
        Ok(normal_deviation(
            &scene.normals(&body.object(surface(exponent, [DIFFUSE, SPECULAR])), Shading::Phong)?,
            &truth,
        )?)
    };
    let (of_eight, of_sixteen, of_single, of_far) =
        (deviation(&eight)?, deviation(&sixteen)?, deviation(&globe)?, deviation(&far)?);
    let reference = scene.light(&globe.object(surface(exponent, [DIFFUSE, SPECULAR])), Shading::Phong)?;
    let picture =
        |body: &Body| scene.light(&body.object(surface(exponent, [DIFFUSE, SPECULAR])), Shading::Phong);
    let (lit_eight, lit_sixteen, lit_far) = (picture(&eight)?, picture(&sixteen)?, picture(&far)?);
    let lit_centred = picture(&globe.far_away(0.0))?;
    let error = |image: &Image| image_error(image, &reference, 0.5).map(|error| error.linear.max / 255.0);
    let (worst_eight, worst_sixteen) = (error(&lit_eight)?, error(&lit_sixteen)?);
    // Each kind of light by itself, as strong as can be.
    let alone = |parts: [f64; 2], reflection: Reflection| -> Result<f64, ArtefactError> {
        let material = Material { reflection, ..surface(exponent, parts) };
        let lit = |body: &Body| scene.light(&body.object(material), Shading::Phong);
        Ok(image_error(&lit(&eight)?, &lit(&globe)?, 0.5)?.linear.max / 255.0)
    };
    let of_diffuse = alone([1.0, 0.0], Reflection::Blinn)?;
    let of_highlight = alone([0.0, 1.0], Reflection::Blinn)?;
    let of_phong = alone([0.0, 1.0], Reflection::Phong)?;
    let [mean, largest] = globe.angles(&eight);
    let [mean_law, largest_law] = globe.angles(&globe.with_normals(nearest_of_127));
    // One vertex may lie on the border between two codes.
    let of_one = Degrees::from(Radians(FRAC_1_SQRT_2 / 127.0)).0 / globe.normals.len() as f64;
    let bound = |degrees: f64| bound(exponent, degrees);
    let [naive, careful] = needles::errors();
    let mut measures = vec![
        Measure::new(TEXTS.get("measure-three-times-bits"), "°", mean).expect(
            mean_law,
            of_one + 1e-5,
            TEXTS.get("by-every-component-nearest"),
        ),
        Measure::new(TEXTS.get("measure-three-times-bits-largest"), "°", largest).expect(
            largest_law,
            1e-5,
            TEXTS.get("by-same-half-step"),
        ),
        Measure::new(TEXTS.get("measure-bits-change-highlight"), "", worst_eight / bound(largest))
            .at_most(1.0, TEXTS.get("by-bound-k-d")),
        Measure::new(TEXTS.get("measure-bits-largest-change"), "", worst_eight),
        Measure::new(TEXTS.get("measure-bits-largest-change-diffuse"), "", of_diffuse),
        Measure::new(TEXTS.get("measure-bits-largest-change-blinn"), "", of_highlight),
        Measure::new(TEXTS.get("measure-bits-largest-change-phong"), "", of_phong).at_most(
            2.0 * steepest_slope(exponent) * Radians::from(Degrees(largest)).0,
            TEXTS.get("by-m-n-twice"),
        ),
        Measure::new(TEXTS.get("measure-twice-bits-largest"), "", worst_sixteen).at_most(
            // Cosines of two pictures, each rounded to single precision, times n.
            bound(SIXTEEN) + 1e-5 + 1.2e-7 * exponent,
            TEXTS.get("by-bound-largest-error"),
        ),
        far_from_the_origin(globe.face_angles(&far), globe.rounded_faces(AWAY), segments),
        Measure::new(TEXTS.get("measure-needle-plain-arithmetic"), "°", naive[4][1]),
        Measure::new(
            TEXTS.get("measure-needles-exact-differences"),
            "°",
            careful.iter().map(|point| point[1]).fold(0.0, f64::max),
        )
        .at_most(6e-6, TEXTS.get("by-rounding-result")),
        Measure::new(TEXTS.get("measure-pixels-bits-mean"), "°", of_eight.mean),
        Measure::new(TEXTS.get("measure-pixels-twice-bits"), "°", of_sixteen.mean),
        Measure::new(TEXTS.get("measure-pixels-single-precision"), "°", of_single.mean),
        Measure::new(TEXTS.get("measure-pixels-far-origin"), "°", of_far.mean),
    ];
    let moved = Moved {
        name: TEXTS.get("moved"),
        unit: "",
        bad: worst_eight,
        present: Threshold::HALF_STEP,
        cure: TEXTS.get("cure"),
        cured: worst_sixteen,
        factor: 20.0,
    };
    let far_off = Moved {
        bad: error(&lit_far)?,
        cure: TEXTS.get("cure-positions-centred-before"),
        cured: error(&lit_centred)?,
        ..moved.clone()
    };
    let (of_plate, [torn, round]) = plate::plate([size, segments], exponent, &moved)?;
    measures.push(of_plate);
    Ok(Outcome {
        verdict: verdict([of_diffuse, of_highlight], exponent, [largest, SIXTEEN]),
        shots: vec![
            moved.bad_shot(
                "eight-bits",
                TEXTS.get("eight-bits-title"),
                [
                    TEXTS.get("eight-bits-caption-highlight-seen-close"),
                    TEXTS.get("eight-bits-caption-dented-blotchy"),
                ],
                lit_eight,
            ),
            moved.cured_shot(
                "sixteen-bits",
                TEXTS.get("sixteen-bits-title"),
                [
                    TEXTS.get("sixteen-bits-caption-same-normals-octahedron"),
                    TEXTS.get("sixteen-bits-caption-dents-all-but"),
                ],
                lit_sixteen,
            ),
            far_off.bad_shot(
                "far-away",
                TEXTS.get("far-away-title"),
                [
                    Text::made(
                        format!("Positions stored in single precision {AWAY} radii from the origin."),
                        format!("Posições guardadas em precisão simples a {AWAY} raios da origem."),
                    ),
                    TEXTS.get("far-away-caption-normals-computed-them"),
                ],
                lit_far,
            ),
            far_off.cured_shot(
                "centred",
                TEXTS.get("centred-title"),
                [
                    TEXTS.get("centred-caption-same-sphere-positions"),
                    TEXTS.get("centred-caption-nothing-rough"),
                ],
                lit_centred,
            ),
            torn,
            round,
        ],
        moved,
        measures,
        charts: vec![needles::chart(naive, careful)],
        notes: vec![TEXTS.get("note-far-origin-no")],
    })
}

/// The largest error of a normal on an octahedron with twice 16 bits, in degrees.
const SIXTEEN: f64 = 0.0037;

/// By the largest changes of diffuse light and of the highlight, and the largest errors of normals of 8 bits and of twice 16, in
/// degrees.
fn verdict([of_diffuse, of_highlight]: [f64; 2], exponent: f64, errors: [f64; 2]) -> Verdict {
    if of_highlight <= of_diffuse {
        return Verdict::Fails(TEXTS.get("fails-diffuse-light-changes"));
    }
    let needed = needed(exponent);
    Verdict::Holds(Text::each(|language| {
        let [n, strength] = [exponent, SPECULAR].map(|x| language.number(x));
        let [eight_times, sixteen_times] = errors.map(|error| language.short(error / needed, ""));
        let [needed, eight, sixteen] = [needed, errors[0], errors[1]].map(|x| language.short(x, "°"));
        match language {
            Language::English => format!(
                "for small errors. Half a step of 8 bits of this highlight (Blinn's, n = {n}, k_s = {strength}) takes normals right to \
                 {needed}. 8 bits a component are off by up to {eight} here, {eight_times} times that, twice 16 bits by up to \
                 {sixteen}, {sixteen_times} of that."
            ),
            Language::Portuguese => format!(
                "para erros pequenos. Meio passo de 8 bits deste brilho (de Blinn, n = {n}, k_s = {strength}) pede normais certas até \
                 {needed}. 8 bits por componente erram aqui até {eight}, {eight_times} vezes isso, duas vezes 16 bits até {sixteen}, \
                 {sixteen_times} disso."
            ),
        }
    }))
}

/// How far a normal may be off, in degrees, for this highlight to change by half a step of 8 bits where it is steepest.
fn needed(exponent: f64) -> f64 {
    Degrees::from(Radians(Threshold::HALF_STEP.value / (SPECULAR * steepest_slope(exponent)))).0
}

/// How much the light may change at most where a normal is off by so many degrees: Δ_d ≤ δ and Δ_s ≤ M(n) δ.
fn bound(exponent: f64, degrees: f64) -> f64 {
    (DIFFUSE + SPECULAR * steepest_slope(exponent)) * Radians::from(Degrees(degrees)).0
}

/// A unit vector of components of 8 bits: the nearest multiples of 1/127.
fn nearest_of_127(normal: DVec3) -> DVec3 {
    (normal * 127.0).round().normalize()
}

/// The error of the faces' normals by theory, where there are faces enough for a mean over roundings.
fn far_from_the_origin(found: f64, law: f64, segments: u32) -> Measure {
    let measure = Measure::new(
        Text::made(
            format!("{AWAY} radii from the origin: error of face normals (rms)"),
            format!("a {AWAY} raios da origem: erro das normais das faces (rms)"),
        ),
        "°",
        found,
    );
    // Of vertices that lie mirrored to both sides of the middle, one in four is rounded by itself. The root of a mean of so many
    // squares scatters by half of one over the root of their number; three times that.
    let quarter = f64::from(segments / 2 + 1);
    if segments < 10 {
        return measure.beyond(TEXTS.get("untested-few-faces-no"));
    }
    measure.expect(
        law,
        // And terms of second order in the angle.
        law * (1.5 / quarter + 2.0 * Radians::from(Degrees(law)).0),
        TEXTS.get("by-u-b-c"),
    )
}

/// How much of the light the body scatters, and how much it mirrors.
const DIFFUSE: f64 = 0.3;
const SPECULAR: f64 = 0.7;

/// What scatters and mirrors so much of the light.
fn surface(exponent: f64, [diffuse, specular]: [f64; 2]) -> Material {
    Material {
        ambient: Reflectance::NONE,
        diffuse: Reflectance::Merged(LinearRgb::grey(diffuse)),
        specular: Reflectance::Merged(LinearRgb::grey(specular)),
        exponent,
        ..Material::default()
    }
}

fn exact(exponent: f64) -> Object<'static> {
    Object::new(Shape::Surface(Primitive::from(Sphere::default())), surface(exponent, [DIFFUSE, SPECULAR]))
}

/// A close look at the middle of the sphere, light and viewer in front.
struct Scene {
    size: u32,
}

impl Scene {
    fn light(&self, object: &Object, shading: Shading) -> Result<Image, ArtefactError> {
        self.paint(object, shading, Show::Shaded)
    }

    fn normals(&self, object: &Object, shading: Shading) -> Result<Image, ArtefactError> {
        self.paint(object, shading, Show::Normals)
    }

    fn paint(&self, object: &Object, shading: Shading, show: Show) -> Result<Image, ArtefactError> {
        // A little off the axis, so that the highlight does not sit on a vertex.
        let light = Light::Directional { towards: DVec3::new(0.05, 0.03, 1.0), colour: LinearRgb::WHITE };
        let settings =
            RenderSettings { show, ..settings([self.size; 2], shading, Interpolation::Perspective) };
        draw(vec![object.clone()], &[light], front(WINDOW), &settings)
    }
}

impl Body {
    /// A part of the unit sphere about +z, cut into so many squares each way, with its own normals.
    fn cap(cells: u32) -> Self {
        Self::grid([cells; 2], Diagonal::Rising, |u, v| {
            let (longitude, latitude) = ((2.0 * u - 1.0) * REACH, (2.0 * v - 1.0) * REACH);
            let (up, ring) = libm::sincos(latitude);
            let (right, ahead) = libm::sincos(longitude);
            let place = DVec3::new(ring * right, up, ring * ahead);
            (place, place)
        })
    }

    /// The same with other normals.
    fn with_normals(&self, change: impl Fn(DVec3) -> DVec3) -> Self {
        let changed = |normal: &[f32; 3]| change(Vec3::from(*normal).as_dvec3()).as_vec3().to_array();
        Self { normals: self.normals.iter().map(changed).collect(), ..self.clone() }
    }

    /// The body after its positions have been stored in single precision far from the origin, with normals computed from
    /// what was left of them.
    fn far_away(&self, away: f64) -> Self {
        let offset = DVec3::new(away, 0.9 * away, 0.8 * away);
        let stored = |p: &[f32; 3]| (Vec3::from(*p).as_dvec3() + offset).as_vec3().as_dvec3() - offset;
        let positions: Vec<DVec3> = self.positions.iter().map(stored).collect();
        let mut sums = vec![DVec3::ZERO; positions.len()];
        for triangle in &self.triangles {
            let [a, b, c] = triangle.map(|vertex| positions[vertex as usize]);
            let area = (b - a).cross(c - a);
            triangle.iter().for_each(|&vertex| sums[vertex as usize] += area);
        }
        let own = self.normals.iter().map(|n| Vec3::from(*n).as_dvec3());
        let normals: Vec<DVec3> =
            sums.iter().zip(own).map(|(sum, own)| sum.try_normalize().unwrap_or(own)).collect();
        Self::new(&positions, self.triangles.clone(), &normals)
    }

    /// Mean and largest angle to the normals of another body, at vertices, in degrees.
    fn angles(&self, other: &Self) -> [f64; 2] {
        let pairs = self.normals.iter().zip(&other.normals);
        let angles: Vec<f64> = pairs.map(|(a, b)| angle(double(*a), double(*b))).collect();
        [angles.iter().sum::<f64>() / angles.len() as f64, angles.iter().copied().fold(0.0, f64::max)]
    }

    /// The root of the mean square of the angles to the normals of the faces of another body, in degrees.
    fn face_angles(&self, other: &Self) -> f64 {
        let pairs = self.face_normals.iter().zip(&other.face_normals);
        let squares: f64 = pairs.map(|(a, b)| angle(double(*a), double(*b))).map(|angle| angle * angle).sum();
        (squares / self.face_normals.len() as f64).sqrt()
    }

    /// What that is by theory for positions rounded at this distance. A normal leans by the gradient of the errors' heights over
    /// the face, Σ e_k ∇λ_k with |∇λ_k| = side_k/(2A); errors have the variance u²/12 and know nothing of one another.
    fn rounded_faces(&self, away: f64) -> f64 {
        let step = f64::from((away as f32).next_up()) - f64::from(away as f32);
        let square = |triangle: &[u32; 3]| {
            let [a, b, c] = triangle.map(|vertex| Vec3::from(self.positions[vertex as usize]).as_dvec3());
            let sides = (b - a).length_squared() + (c - b).length_squared() + (a - c).length_squared();
            step * step / 12.0 * sides / (b - a).cross(c - a).length_squared()
        };
        let sum: f64 = self.triangles.iter().map(square).sum();
        Degrees::from(Radians((sum / self.triangles.len() as f64).sqrt())).0
    }
}

fn double(v: [f32; 3]) -> DVec3 {
    Vec3::from(v).as_dvec3()
}

/// Between two directions, in degrees.
fn angle(a: DVec3, b: DVec3) -> f64 {
    Degrees::from(Radians(libm::atan2(a.cross(b).length(), a.dot(b)))).0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_show_in_highlights() {
        for exponent in [500.0, 2000.0] {
            let parameters = Parameters { size: 128, exponent, ..EXPERIMENT.defaults };
            let outcome = EXPERIMENT.run(&Setup { parameters, mesh: None }).unwrap();
            outcome.prove();
            // Errors of directions near an axis: (√2 + ln(1 + √2))/6 of a step of 1/127; a grid of 25 by 25 is no random sample.
            let mean = outcome.measured("three times 8 bits: mean");
            assert!((mean - 0.1726).abs() < 0.1 * 0.1726, "{mean}");
            // A highlight changes more than diffuse light, by up to √(n/e).
            let [diffuse, highlight] = ["diffuse light", "Blinn's highlight"]
                .map(|of| outcome.measured(&format!("8 bits: largest change of {of} alone")));
            assert!(highlight > 3.0 * diffuse && highlight < 1.1 * 0.607 * exponent.sqrt() * 0.005_57);
            // Present: several steps of 8 bits. Cured: codes are a hundred times as fine; twenty at least.
            assert!(
                outcome.moved.bad > 5.0 / 255.0 && outcome.moved.reduction() > 20.0,
                "{:?}",
                outcome.moved
            );
        }
    }

    /// The two means that are told, over a spiral of evenly spread normals: of all directions, and of those of the cap.
    #[test]
    fn errors_of_8_bits_are_those_reported() {
        let golden = std::f64::consts::PI * (3.0 - 5_f64.sqrt());
        let mean = |least: f64| {
            const COUNT: u32 = 200_000;
            let error = |k: u32| {
                let z = 1.0 - (1.0 - least) * (f64::from(k) + 0.5) / f64::from(COUNT);
                let (sine, cosine) = libm::sincos(golden * f64::from(k));
                let ring = (1.0 - z * z).sqrt();
                let normal = DVec3::new(ring * cosine, ring * sine, z);
                Degrees::from(crate::num::angle_between(normal, nearest_of_127(normal))).0
            };
            (0..COUNT).map(error).sum::<f64>() / f64::from(COUNT)
        };
        let (all, near) = (mean(-1.0), mean(libm::cos(REACH)));
        assert!((all - 0.1701).abs() < 2e-4 && (near - 0.1726).abs() < 1.5e-3, "{all} {near}");
    }

    #[test]
    fn wide_highlights_are_no_worse_than_diffuse_light() {
        let parameters = Parameters { size: 64, exponent: 1.0, ..EXPERIMENT.defaults };
        let outcome = EXPERIMENT.run(&Setup { parameters, mesh: None }).unwrap();
        assert!(matches!(outcome.verdict, Verdict::Absent(_)), "{:?}", outcome.moved);
        assert!(matches!(verdict([0.002, 0.001], 1.0, [0.4, SIXTEEN]), Verdict::Fails(_)));
    }
}
