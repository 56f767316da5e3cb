//! What a wrong normal does to a picture: grey levels under a key light, and the width of highlights.

use crate::io::{FileMaterial, FileReflection};
use crate::mesh::Mesh;
use crate::num::Transfer;
use crate::quality::angles::Limit;
use crate::quality::facts::Facts;
use crate::shade::roughness_exponent;

/// The angle between the right normal and the key light, in degrees: where photographers put it.
const KEY_LIGHT: f64 = 45.0;

/// Steps of 8 bits, sRGB-coded, between a white matte surface lit by a key light 45° from its normal and the same with a
/// normal that is off by this many degrees, away from the light: |sRGB(cos 45°) − sRGB(max(0, cos(45° + δ)))| · 255.
///
/// A statement about any mesh in any light would need a scene; this one needs an angle only. One degree is 1.7 steps,
/// and 45° and more are black.
///
/// ```
/// use crease::quality::key_light_steps;
///
/// assert!((key_light_steps(1.0) - 1.717).abs() < 1e-3);
/// assert_eq!(key_light_steps(45.0), key_light_steps(180.0));
/// ```
pub fn key_light_steps(degrees: f64) -> f64 {
    grey(KEY_LIGHT) - grey(KEY_LIGHT + degrees)
}

/// The same for a normal that gives no light at all.
pub(crate) fn key_light_lost() -> f64 {
    grey(KEY_LIGHT)
}

/// The same where nothing divides a normal by its length, and light is that many times as strong; white is the most there is.
pub(crate) fn key_light_scaled(length: f64) -> f64 {
    let light = (length * libm::cos(KEY_LIGHT.to_radians())).min(1.0);
    (Transfer::Srgb.encode(light) * 255.0 - grey(KEY_LIGHT)).abs()
}

/// What a white matte surface shows whose normal is so many degrees from the light, in steps of 8 bits.
fn grey(degrees: f64) -> f64 {
    let cosine = if degrees.abs() >= 90.0 { 0.0 } else { libm::cos(degrees.to_radians()) };
    Transfer::Srgb.encode(cosine) * 255.0
}

/// The same from the cosine, for as many as a mesh has edges: the power of 1/2.4 is the fifth power of the twelfth root,
/// which three roots give several times sooner.
fn grey_of_cosine(cosine: f64) -> f64 {
    const CUT: f64 = 0.003_130_8;
    let root = libm::cbrt(cosine.max(CUT).sqrt().sqrt());
    let squared = root * root;
    let curved = 1.055 * (squared * squared * root) - 0.055;
    255.0 * if cosine <= CUT { 12.92 * cosine.max(0.0) } else { curved }
}

/// The cosine of 45°.
const DIAGONAL: f64 = std::f64::consts::FRAC_1_SQRT_2;

/// [`grey_of_cosine`] of that.
const GREY_AT_DIAGONAL: f64 = 218.825_973_324_677_62;

/// By how much the slope of brightness changes at an edge, in steps of 8 bits a pixel, under a key light 45° from its normal
/// and across it, on the side where that is more.
///
/// Brightness is interpolated from the edge to what is beyond it on either side: the normals there by their parts along
/// that of the edge and across it, positive on the first side's own side, of any length; and `pixels` from the edge.
pub(crate) fn slope_jump(normals: [[f64; 2]; 2], pixels: [f64; 2]) -> f64 {
    let units = normals.map(|[up, aside]| match (up * up + aside * aside).sqrt() {
        length if length > 0.0 => [up, aside].map(|part| part * (DIAGONAL / length)),
        // No direction: as on the edge.
        _ => [DIAGONAL, 0.0],
    });
    // On either side of the edge: cos(θ ∓ 45°) = (cos θ ± sin θ)/√2.
    let jump = |side: f64| {
        let slopes = [0, 1].map(|k| {
            let [up, aside] = units[k];
            (grey_of_cosine(up + side * aside) - GREY_AT_DIAGONAL) / pixels[k].max(1.0)
        });
        (slopes[0] + slopes[1]).abs()
    };
    jump(1.0).max(jump(-1.0))
}

const USUAL: f64 = 32.0;

/// The highlight of each material that the faces of a part name.
#[derive(Clone, Debug)]
pub(crate) struct Highlights {
    /// By the label of a face.
    of_material: Vec<Highlight>,
    /// For faces without a label, or for all if the thresholds give an exponent.
    otherwise: Highlight,
}

/// A highlight cosⁿ.
#[derive(Clone, Copy, Debug)]
struct Highlight {
    exponent: f64,
    /// The angle between the positions where it has half of its height.
    width: Limit,
}

impl Highlight {
    fn new(exponent: f64) -> Self {
        Self { exponent, width: Limit::new(2.0 * libm::acos(libm::exp2(-1.0 / exponent)).to_degrees()) }
    }
}

impl Highlights {
    pub(crate) fn new(facts: &Facts<'_>) -> Self {
        let otherwise = Highlight::new(facts.thresholds.exponent.unwrap_or(USUAL));
        let materials = facts.file.materials();
        let of = |name: &String| materials.iter().find(|material| material.name == *name);
        let labels = facts.mesh.columns().materials.iter();
        let of_material = labels
            .flat_map(|labels| &labels.names)
            .map(|name| of(name).map_or(otherwise, |material| Highlight::new(exponent(material))))
            .collect();
        Self { of_material, otherwise }
    }

    fn of(&self, mesh: &Mesh, face: usize) -> Highlight {
        let label = mesh.columns().materials.as_ref().map(|labels| labels.of_face[face] as usize);
        label.and_then(|label| self.of_material.get(label)).copied().unwrap_or(self.otherwise)
    }

    /// The angle between the positions where the highlight of a face has half of its height.
    pub(crate) fn width(&self, mesh: &Mesh, face: usize) -> Limit {
        self.of(mesh, face).width
    }

    /// The largest exponent of any face.
    pub(crate) fn largest_exponent(&self, mesh: &Mesh) -> f64 {
        if mesh.columns().materials.is_none() {
            return self.otherwise.exponent;
        }
        (0..mesh.face_count()).map(|face| self.of(mesh, face).exponent).fold(1.0, f64::max)
    }
}

/// The exponent of a material; 1, the width of diffuse light, if it has no highlight.
fn exponent(material: &FileMaterial) -> f64 {
    match material.reflection {
        FileReflection::Phong { specular: Some([0.0, 0.0, 0.0]), .. }
        | FileReflection::MetallicRoughness { unlit: true, .. } => 1.0,
        FileReflection::Phong { exponent, .. } => exponent.unwrap_or(USUAL).max(1.0),
        FileReflection::MetallicRoughness { roughness, .. } => roughness_exponent(roughness),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// On a cylinder brightness is cos θ all round, and the jump is the second difference of its code over the width of a
    /// face; where a plane goes over into it, it is the slope there itself.
    #[test]
    fn slopes_jump_where_interpolation_bends() {
        let slope_jump = |degrees: [f64; 2], pixels| {
            let normal = |degrees: f64| {
                let (sine, cosine) = libm::sincos(degrees.to_radians());
                [3.0 * cosine, 3.0 * sine]
            };
            super::slope_jump(degrees.map(normal), pixels)
        };
        let jump = slope_jump([10.0, -10.0], [40.0, 40.0]);
        let second = |light: f64| (grey(light - 10.0) - 2.0 * grey(light) + grey(light + 10.0)).abs() / 40.0;
        assert!((jump - second(45.0)).abs() < 1e-12, "{jump}");
        let plane = slope_jump([0.0, -10.0], [40.0, 40.0]);
        assert!((plane - (grey(45.0) - grey(55.0)) / 40.0).abs() < 1e-12, "{plane}");
        assert!(slope_jump([5.0, -5.0], [20.0, 20.0]) < jump, "finer is smoother");
        assert_eq!(slope_jump([0.0, 0.0], [3.0, 4.0]), 0.0);
    }

    #[test]
    fn the_grey_of_the_diagonal_is_its() {
        assert_eq!(GREY_AT_DIAGONAL, grey_of_cosine(DIAGONAL));
    }

    /// Roots and the power agree to a few roundings of 255.
    #[test]
    fn roots_give_the_code_of_the_standard() {
        for k in -100..=1000 {
            let cosine = f64::from(k) * 1e-3;
            let coded = Transfer::Srgb.encode(cosine.max(0.0)) * 255.0;
            assert!((grey_of_cosine(cosine) - coded).abs() < 1e-12, "{cosine}");
        }
    }

    /// √½ of the light is the least that shows as white if it is √2 times as strong.
    #[test]
    fn lengths_make_steps() {
        let lost = key_light_lost();
        assert_eq!((key_light_scaled(1.0), key_light_scaled(0.0)), (0.0, lost));
        assert!((key_light_scaled(std::f64::consts::SQRT_2) - (255.0 - lost)).abs() < 1e-9);
        assert_eq!(key_light_scaled(1e300), key_light_scaled(2.0));
        assert_eq!(key_light_steps(90.0), lost);
    }

    #[test]
    fn steps_grow_with_the_angle() {
        assert_eq!(key_light_steps(0.0), 0.0);
        let steps: Vec<f64> = (0..=45).map(|degrees| key_light_steps(f64::from(degrees))).collect();
        assert!(steps.is_sorted_by(|a, b| a < b), "{steps:?}");
        // sRGB(√½) = 1.055 · 0.5^(1/4.8) − 0.055 = 0.8577.
        let coded = 1.055 * libm::pow(0.5, 1.0 / 4.8) - 0.055;
        assert!((steps[45] - 255.0 * coded).abs() < 1e-9, "{}", steps[45]);
    }
}
