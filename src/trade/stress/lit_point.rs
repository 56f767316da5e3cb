//! One point under one light, in three precisions, against the lectures' formulas in 256 bits.

use super::case::Measured;
use super::plain;
use crate::num::{LinearRgb, Real};
use crate::shade::{
    Attenuation, Light, Material, Reflectance, Reflection, ShadeSettings, Shader, SurfacePoint, Viewer,
};
use crate::trade::exact::{self, Big, big, small};
use dashu::base::Abs;
use glam::{DVec3, Vec3};

/// A point at the origin, its normal, and the positions of light and viewer. All coordinates are `f32` numbers.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scene {
    light: Vec3,
    view: Vec3,
    pub(super) normal: Vec3,
    exponent: u32,
    reflection: Reflection,
    /// Whether light and viewer are infinitely far away, in these directions.
    far: bool,
    /// Whether the true highlight is 0, whatever the formula says.
    dark: bool,
}

impl Scene {
    /// Light and viewer in these directions, infinitely far away; then the normal.
    pub(super) fn far(vectors: [DVec3; 3], exponent: u32, reflection: Reflection) -> Self {
        let [light, view, normal] = vectors.map(|v| v.as_vec3());
        Self { light, view, normal, exponent, reflection, far: true, dark: false }
    }

    /// Light and viewer at these points; then the normal.
    pub(super) fn near(vectors: [DVec3; 3], exponent: u32, reflection: Reflection) -> Self {
        Self { far: false, ..Self::far(vectors, exponent, reflection) }
    }

    /// The same scene with a true highlight of 0.
    pub(super) fn without_highlight(self) -> Self {
        Self { dark: true, ..self }
    }

    /// The red light that the point reflects.
    fn shade<R: Real>(&self, material: &Material) -> f64 {
        let [light, view] = [self.light, self.view].map(|v| v.as_dvec3());
        let (light, viewer) = if self.far {
            let light = Light::Directional { towards: light, colour: LinearRgb::WHITE };
            (light, Viewer::Towards(view))
        } else {
            let attenuation = Attenuation::None;
            (Light::Point { position: light, colour: LinearRgb::WHITE, attenuation }, Viewer::At(view))
        };
        let settings = ShadeSettings { viewer, ..ShadeSettings::default() };
        let shader = Shader::<R>::new(&[light], material, &settings).expect("numbers that make sense");
        let normal = self.normal.to_array().map(|x| R::of(f64::from(x)));
        let point = SurfacePoint { position: [R::ZERO; 3], normal };
        shader.shade(&point).map_or(f64::NAN, |[red, ..]| red.to_f64())
    }

    fn highlights(&self) -> [f64; 2] {
        let material = Material {
            specular: Reflectance::Merged(LinearRgb::WHITE),
            diffuse: Reflectance::NONE,
            exponent: f64::from(self.exponent),
            reflection: self.reflection,
            ..Material::default()
        };
        [self.shade::<f64>(&material), self.shade::<f32>(&material)]
    }

    /// Diffuse light, in double and in single precision.
    pub(super) fn diffuse(&self) -> [f64; 2] {
        let white = Reflectance::Merged(LinearRgb::WHITE);
        let material = Material { diffuse: white, specular: Reflectance::NONE, ..Material::default() };
        [self.shade::<f64>(&material), self.shade::<f32>(&material)]
    }

    /// N, L, V.
    fn true_directions(&self) -> [exact::Vector; 3] {
        [self.normal, self.light, self.view]
            .map(|v| exact::unit(&v.as_dvec3().to_array().map(big)).expect("a vector with a direction"))
    }

    /// max(N·L, 0).
    pub(super) fn true_diffuse(&self) -> Big {
        let [normal, light, _] = self.true_directions();
        exact::dot(&normal, &light).max(big(0.0))
    }

    /// max(cos, 0)ⁿ, and 0 where N·L is not above 0.
    fn true_highlight(&self) -> Big {
        let [normal, light, view] = self.true_directions();
        let incoming = exact::dot(&normal, &light);
        if self.dark || incoming <= big(0.0) {
            return big(0.0);
        }
        let cosine = match self.reflection {
            Reflection::Blinn => {
                let sum: exact::Vector = std::array::from_fn(|axis| &light[axis] + &view[axis]);
                exact::dot(&normal, &exact::unit(&sum).expect("a half-vector"))
            }
            Reflection::Phong => big(2.0) * incoming * exact::dot(&normal, &view) - exact::dot(&light, &view),
        };
        cosine.max(big(0.0)).powi(self.exponent.into())
    }

    /// The formulas as usually written.
    fn plain_highlight(&self) -> f32 {
        let [normal, light, view] = [self.normal, self.light, self.view].map(plain::unit);
        let cosine = match self.reflection {
            Reflection::Blinn => normal.dot(plain::unit(light + view)),
            Reflection::Phong => (2.0 * normal.dot(light) * normal - light).dot(view),
        };
        if cosine <= 0.0 { 0.0 } else { libm::powf(cosine, self.exponent as f32) }
    }
}

/// The errors of the highlights of scenes.
pub(super) fn measure(scenes: impl Iterator<Item = Scene>) -> Measured {
    Measured::triples(scenes.map(|scene| {
        let truth = scene.true_highlight();
        let error = |found: f64| if found.is_nan() { found } else { small(&(big(found) - &truth).abs()) };
        let [double, single] = scene.highlights();
        [double, single, f64::from(scene.plain_highlight())].map(error)
    }))
}
