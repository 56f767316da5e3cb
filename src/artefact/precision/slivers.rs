//! Slivers: triangles whose normals cancel in plain arithmetic, and a plate cut into them in a light nearby.

use super::super::prelude::*;
use super::sphere::{angle, bound, material};
use crate::normals::{Scratch, face_normals};
use glam::Vec3;

/// Heights of slivers over their lengths.
const SLIVERS: [f64; 5] = [1e-2, 1e-3, 1e-4, 1e-5, 1e-6];

/// Each height with the largest error of the normal in degrees: by plain single precision, and as this library computes it.
fn errors() -> [Vec<[f64; 2]>; 2] {
    [0, 1].map(|way| SLIVERS.map(|ratio| [ratio, sliver(ratio)[way]]).to_vec())
}

/// The normal of a triangle, of any length: by products and differences in single precision, and as this library computes it.
fn normals([p, q, r]: [Vec3; 3]) -> [Vec3; 2] {
    let positions = [p, q, r].map(|corner| corner.to_array());
    let mut own = [[0.0_f32; 3]];
    let faults = face_normals(&positions, &[[0, 1, 2]], &mut Scratch::new(), &mut own);
    faults.expect("slices of matching lengths");
    [(q - p).cross(r - p), Vec3::from(own[0])]
}

/// The largest error of normals of slivers of this ratio: by plain single precision, and as this library computes it.
fn sliver(ratio: f64) -> [f64; 2] {
    let mut worst = [0.0_f64; 2];
    for k in 0..400 {
        // Directions that share no digits with the axes.
        let t = f64::from(k) * 0.618_033_988_749_895;
        let along = DVec3::new(libm::cos(t), libm::sin(t) * 0.8, libm::sin(t) * 0.6);
        let aside = along.cross(DVec3::new(0.3, -0.5, 0.81)).normalize();
        let base = DVec3::new(0.4, -0.7, 0.3) * libm::cos(3.0 * t);
        let corners = [DVec3::ZERO, along, along * 0.37 + aside * ratio];
        let corners = corners.map(|p| (base + p).as_vec3());
        let [p, q, r] = corners.map(|v| v.as_dvec3());
        // Differences of single numbers and their products are exact in double precision.
        let truth = (q - p).cross(r - p);
        for (worst, found) in worst.iter_mut().zip(normals(corners)) {
            *worst = worst.max(angle(found.as_dvec3(), truth));
        }
    }
    worst
}

/// One rounding of a product over the height of the triangle, in degrees: the size of the error of plain arithmetic.
fn rounding(ratio: f64) -> f64 {
    Degrees::from(Radians(0.5 * f64::from(f32::EPSILON) / ratio)).0
}

pub(super) fn record(out: &mut Recorder) {
    let [plain, careful] = errors();
    out.measure("needle-plain", "°", plain[4][1], Check::None);
    let largest = careful.iter().map(|point| point[1]).fold(0.0, f64::max);
    out.measure("needles-exact", "°", largest, Check::AtMost(6e-6));
    let guide = SLIVERS.iter().map(|&ratio| [ratio, rounding(ratio)]).collect();
    let curves = vec![
        out.curve("plain", Drawn::Points, plain),
        out.curve("exact", Drawn::Points, careful),
        out.curve("rounding", Drawn::Guide, guide),
    ];
    out.chart("needles", [Axis::Log; 2], curves);
}

/// Across the plate and along its slivers, in whole numbers. The corners are sums of multiples of them below 2²⁴, which
/// single precision holds exactly: the plate is flat, and every error is one of arithmetic.
const ACROSS: DVec3 = DVec3::new(18.0, 16.0, 13.0);
const ALONG: DVec3 = DVec3::new(3001.0, -4999.0, 2003.0);
/// How many times [`ALONG`] a sliver is long: about 300 000 times its height.
const LENGTH: u32 = 1333;
/// How far away the light is, in sides of the window: its highlight is a fifth of the window to each side.
const LIGHT: f64 = 4.0;

struct Normals {
    /// By products and differences in single precision.
    plain: Vec<DVec3>,
    careful: Vec<DVec3>,
}

impl Normals {
    /// Of `count` slivers, each with its third corner at another position along it.
    fn of(count: u32) -> Self {
        let x = ALONG.normalize();
        let z = ALONG.cross(ACROSS).normalize();
        let y = z.cross(x);
        let turned = |normal: Vec3| {
            let normal = normal.as_dvec3();
            DVec3::new(normal.dot(x), normal.dot(y), normal.dot(z)).normalize_or_zero()
        };
        let of_one = |k: u32| {
            // Multiples of the golden ratio fall everywhere between 0 and 1.
            let apex = (f64::from(LENGTH) * (f64::from(k) * 0.618_033_988_749_895).fract()).round();
            let base = f64::from(k % 256) * ACROSS;
            let corners = [base, base + f64::from(LENGTH) * ALONG, base + apex * ALONG + ACROSS];
            normals(corners.map(|corner| corner.as_vec3())).map(turned)
        };
        let (plain, careful) = (0..count).map(of_one).map(|[plain, own]| (plain, own)).unzip();
        Self { plain, careful }
    }
}

/// Stripes from below upwards over a window of the side 1, each with the normal of the sliver whose middle it is.
fn stripes(normals: &[DVec3]) -> TriangleMesh {
    let count = normals.len() as f64;
    let (mut positions, mut all) = (Vec::new(), Vec::new());
    for (k, &normal) in normals.iter().enumerate() {
        let [low, high] = [k, k + 1].map(|line| line as f64 / count - 0.5);
        let corners = [[-0.5, low], [0.5, low], [0.5, high], [-0.5, high]];
        positions.extend(corners.map(|[x, y]| DVec3::new(x, y, 0.0)));
        all.extend([normal; 4]);
    }
    let halves = |k: u32| [[0, 1, 2], [0, 2, 3]].map(|half: [u32; 3]| half.map(|corner| 4 * k + corner));
    TriangleMesh::new(&positions, (0..normals.len() as u32).flat_map(halves).collect(), &all)
}

fn light(normals: &[DVec3], size: u32, exponent: f64) -> Result<Image> {
    let stripes = stripes(normals);
    let object = stripes.object(material(exponent));
    draw(vec![object], &[lamp(DVec3::Z * LIGHT)], front(1.0), settings([size; 2], Shading::Phong))
}

/// The plate with normals by plain arithmetic and by exact differences of products.
pub(super) fn record_plate([size, segments]: [u32; 2], exponent: f64, out: &mut Recorder) -> Result<()> {
    let Normals { plain, careful } = Normals::of(3 * segments);
    let reference = light(&vec![DVec3::Z; plain.len()], size, exponent)?;
    let (lit_plain, lit_careful) = (light(&plain, size, exponent)?, light(&careful, size, exponent)?);
    let error = |image: &Image| largest_error(image, &reference);
    let largest = plain.iter().map(|&normal| angle(normal, DVec3::Z)).fold(0.0, f64::max);
    let errors = [error(&lit_plain)?, error(&lit_careful)?];
    out.set("largest", largest);
    out.measure("plate", "", errors[0] / bound(exponent, largest), Check::AtMost(1.0));
    let effect = out.effect("plate", "", errors, Threshold::half_step(), 20.0);
    out.bad("needles-plain", &effect, lit_plain);
    out.cured("needles-exact", &effect, lit_careful);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Six products are rounded; the largest error over some hundred directions is of the size of one rounding.
    #[test]
    fn needles_cancel_in_plain_arithmetic() {
        for ratio in [1e-3, 1e-4, 1e-5] {
            let [naive, careful] = sliver(ratio);
            let size = naive / rounding(ratio);
            assert!((0.2..6.0).contains(&size), "{ratio}: {naive}");
            assert!(careful < 6e-6, "{ratio}: {careful}");
        }
    }

    /// Whole numbers below 2²⁴, so that corners are what they are meant to be, and as slim as stated.
    #[test]
    fn needles_are_exactly_in_one_plane() {
        let corner = f64::from(LENGTH) * ALONG + 256.0 * ACROSS;
        assert!(corner.abs().max_element() < 16_777_216.0);
        let height = ALONG.cross(ACROSS).length() / ALONG.length();
        let slimness = f64::from(LENGTH) * ALONG.length() / height;
        assert!((slimness - 3e5).abs() < 0.01 * 3e5, "{slimness}");
    }

    /// Plain products lose some 300 000 roundings of single precision, a degree; exact differences none.
    #[test]
    fn only_plain_products_lean() {
        let normals = Normals::of(72);
        let largest = |all: &[DVec3]| all.iter().map(|&normal| angle(normal, DVec3::Z)).fold(0.0, f64::max);
        let (plain, careful) = (largest(&normals.plain), largest(&normals.careful));
        assert!((0.2..6.0).contains(&plain), "{plain}");
        assert!(careful < 6e-6, "{careful}");
    }
}
