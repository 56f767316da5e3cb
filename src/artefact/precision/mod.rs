//! The effect of rounded positions and normals on a highlight.

// A part of a sphere with normals of different precision, how far they are from the true ones, and its highlight.
mod sphere;
// Slivers: triangles whose normals cancel in plain arithmetic, and a plate cut into them in a light nearby.
mod slivers;

use super::prelude::*;
use crate::metric::normal_deviation;
use crate::normals::encoding::{Encoding, Snorm};
use crate::num::steepest_slope;
use sphere::{SPECULAR, bound, draw_close_up, material, needed};
use std::f64::consts::FRAC_1_SQRT_2;

static TEXTS: Catalogue = catalogue!("texts");

pub(super) static EXPERIMENT: Experiment = Experiment {
    takes: &[ParameterName::Size, ParameterName::Segments, ParameterName::Exponent],
    defaults: Parameters { segments: 24, exponent: 2000.0, ..Parameters::USUAL },
    ..Experiment::new("precision", &TEXTS, run)
};

/// How far from the origin the sphere is modelled, in radii.
const AWAY: f64 = 3e3;

/// The largest error of a normal on an octahedron with twice 16 bits, in degrees.
const SIXTEEN: f64 = 0.0037;

fn run(setup: &Setup) -> Result<Outcome> {
    let Parameters { size, segments, exponent, .. } = setup.parameters;
    let values = [
        ("exponent", Value::number(exponent)),
        ("strength", Value::number(SPECULAR)),
        ("distance", Value::number(AWAY)),
    ];
    let mut out = Recorder::new(&TEXTS, &values);
    let spheres = Spheres::new(segments);
    let largest = spheres.measure_stored_normals(&mut out);
    let lit = |mesh: &TriangleMesh| {
        draw_close_up(&mesh.object(material(exponent)), Shading::Phong, Show::Shaded, size)
    };
    let reference = lit(&spheres.own)?;
    let error = |image: &Image| largest_error(image, &reference);
    let (eight, sixteen) = (lit(&spheres.eight)?, lit(&spheres.sixteen)?);
    let (of_eight, of_sixteen) = (error(&eight)?, error(&sixteen)?);
    out.measure("change-over-bound", "", of_eight / bound(exponent, largest), Check::AtMost(1.0));
    out.measure("change", "", of_eight, Check::None);
    let changes = spheres.measure_changes(size, exponent, largest, &mut out)?;
    // Cosines of two pictures, each rounded to single precision, times n.
    let most = bound(exponent, SIXTEEN) + 1e-5 + 1.2e-7 * exponent;
    out.measure("change-sixteen", "", of_sixteen, Check::AtMost(most));
    spheres.measure_far_faces(segments, &mut out);
    slivers::record(&mut out);
    spheres.measure_pixels(size, exponent, &mut out)?;
    let effect = out.effect("bits", "", [of_eight, of_sixteen], Threshold::half_step(), 20.0);
    out.bad("eight-bits", &effect, eight);
    out.cured("sixteen-bits", &effect, sixteen);
    let (far, centred) = (lit(&spheres.far)?, lit(&spheres.own.far_away(0.0))?);
    let errors = [error(&far)?, error(&centred)?];
    let of_far = out.effect("far", "", errors, Threshold::half_step(), 20.0);
    out.bad("far-away", &of_far, far);
    out.cured("centred", &of_far, centred);
    slivers::record_plate([size, segments], exponent, &mut out)?;
    let verdict = verdict(changes, exponent, [largest, SIXTEEN], &mut out);
    Ok(out.finish(verdict, effect))
}

/// By the largest changes of diffuse light and highlight, and the largest errors in degrees of normals of 8 and twice 16 bits.
fn verdict(
    [of_diffuse, of_highlight]: [f64; 2],
    exponent: f64,
    [eight, sixteen]: [f64; 2],
    out: &mut Recorder,
) -> Verdict {
    if of_highlight <= of_diffuse {
        return Verdict::Fails(out.text("fails"));
    }
    let needed = needed(exponent);
    out.set("needed", needed);
    out.set("eight", eight);
    out.set("eight-times", eight / needed);
    out.set("sixteen", sixteen);
    out.set("sixteen-times", sixteen / needed);
    Verdict::Holds(out.text("holds"))
}

/// A unit vector of components of 8 bits: the nearest multiples of 1/127.
fn nearest_of_127(normal: DVec3) -> DVec3 {
    (normal * 127.0).round().normalize()
}

struct Spheres {
    /// With its own normals in single precision.
    own: TriangleMesh,
    eight: TriangleMesh,
    sixteen: TriangleMesh,
    /// With positions that were rounded far from the origin.
    far: TriangleMesh,
}

impl Spheres {
    fn new(segments: u32) -> Self {
        let own = TriangleMesh::cap(segments);
        let stored = |encoding: Encoding| own.with_normals(|n| encoding.decode(encoding.encode(n)));
        let eight = stored(Encoding::Snorm(Snorm::EIGHT));
        Self { eight, sixteen: stored(Encoding::OCTAHEDRAL_16), far: own.far_away(AWAY), own }
    }

    fn measure_stored_normals(&self, out: &mut Recorder) -> f64 {
        let [mean, largest] = self.own.angles(&self.eight);
        let [mean_law, largest_law] = self.own.angles(&self.own.with_normals(nearest_of_127));
        // One vertex may lie on the border between two codes.
        let of_one = Degrees::from(Radians(FRAC_1_SQRT_2 / 127.0)).0 / self.own.normals.len() as f64;
        out.measure("mean-error", "°", mean, Check::Near(mean_law, of_one + 1e-5));
        out.measure("largest-error", "°", largest, Check::Near(largest_law, 1e-5));
        largest
    }

    /// The changes of each kind of light by normals of 8 bits. Returns those of diffuse light and of Blinn's highlight.
    fn measure_changes(
        &self,
        size: u32,
        exponent: f64,
        largest: f64,
        out: &mut Recorder,
    ) -> Result<[f64; 2]> {
        let change = |shares: [f64; 2], reflection: Reflection| -> Result<f64> {
            let material = Material { reflection, ..shiny(shares, exponent) };
            let lit = |mesh: &TriangleMesh| {
                draw_close_up(&mesh.object(material), Shading::Phong, Show::Shaded, size)
            };
            largest_error(&lit(&self.eight)?, &lit(&self.own)?)
        };
        let diffuse = change([1.0, 0.0], Reflection::Blinn)?;
        let blinn = change([0.0, 1.0], Reflection::Blinn)?;
        let phong = change([0.0, 1.0], Reflection::Phong)?;
        out.measure("change-diffuse", "", diffuse, Check::None);
        out.measure("change-blinn", "", blinn, Check::None);
        let most = 2.0 * steepest_slope(exponent) * Radians::from(Degrees(largest)).0;
        out.measure("change-phong", "", phong, Check::AtMost(most));
        Ok([diffuse, blinn])
    }

    /// The error of the faces' normals far from the origin.
    fn measure_far_faces(&self, segments: u32, out: &mut Recorder) {
        let law = self.own.rounded_faces(AWAY);
        // The vertices lie mirrored on both sides of the middle, across and up, and mirrored vertices have the same
        // rounding errors up to sign: one in four, (segments/2 + 1)², is independent. The root of a mean of N squares
        // has a relative standard deviation of 1/(2√N). The tolerance is three times that.
        let quarter = f64::from(segments / 2 + 1);
        let check = match segments {
            // And terms of second order in the angle.
            10.. => Check::Near(law, law * (1.5 / quarter + 2.0 * Radians::from(Degrees(law)).0)),
            _ => Check::Untested("few-faces"),
        };
        out.measure("far-faces", "°", self.own.face_angles(&self.far), check);
    }

    fn measure_pixels(&self, size: u32, exponent: f64, out: &mut Recorder) -> Result<()> {
        let exact = Object::new(Shape::Surface(Primitive::from(Sphere::default())), material(exponent));
        let truth = draw_close_up(&exact, Shading::Exact, Show::Normals, size)?;
        for (name, mesh) in [
            ("pixels-eight", &self.eight),
            ("pixels-sixteen", &self.sixteen),
            ("pixels-single", &self.own),
            ("pixels-far", &self.far),
        ] {
            let normals =
                draw_close_up(&mesh.object(material(exponent)), Shading::Phong, Show::Normals, size)?;
            out.measure(name, "°", normal_deviation(&normals, &truth)?.mean, Check::None);
        }
        Ok(())
    }
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
            let mean = outcome.measured("3 × 8 bits: mean");
            assert!((mean - 0.1726).abs() < 0.1 * 0.1726, "{mean}");
            // A highlight changes more than diffuse light, by up to √(n/e).
            let [diffuse, highlight] = ["diffuse light", "the Blinn highlight"]
                .map(|of| outcome.measured(&format!("3 × 8 bits: largest change of {of} alone")));
            assert!(highlight > 3.0 * diffuse && highlight < 1.1 * 0.607 * exponent.sqrt() * 0.005_57);
            // Present: several steps of 8 bits. Cured: codes are a hundred times as fine; twenty at least.
            assert!(
                outcome.effect.bad > 5.0 / 255.0 && outcome.effect.reduction() > 20.0,
                "{:?}",
                outcome.effect
            );
        }
    }

    /// The two means that are stated, over a spiral of evenly spread normals: of all directions, and of those of the cap.
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
        let (all, near) = (mean(-1.0), mean(libm::cos(sphere::REACH)));
        assert!((all - 0.1701).abs() < 2e-4 && (near - 0.1726).abs() < 1.5e-3, "{all} {near}");
    }

    #[test]
    fn wide_highlights_are_no_worse_than_diffuse_light() {
        let parameters = Parameters { size: 64, exponent: 1.0, ..EXPERIMENT.defaults };
        let outcome = EXPERIMENT.run(&Setup { parameters, mesh: None }).unwrap();
        assert!(matches!(outcome.verdict, Verdict::Absent(_)), "{:?}", outcome.effect);
        let mut out = Recorder::new(&TEXTS, &[]);
        assert!(matches!(verdict([0.002, 0.001], 1.0, [0.4, SIXTEEN], &mut out), Verdict::Fails(_)));
    }
}
