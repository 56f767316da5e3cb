//! One point under one light, three ways, against the lectures' formulas in 256 bits.

use crate::num::{LinearRgb, Real};
use crate::shade::{
    Attenuation, Light, Material, Reflectance, Reflection, ShadeSettings, Shader, SurfacePoint, Viewer,
};
use crate::trade::exact::{self, Big, big, small};
use crate::trade::stress::case::{Measured, Worst};
use crate::trade::stress::normals::naive;
use dashu::base::Abs;
use glam::{DVec3, Vec3};

/// A point at the origin, its normal, and where light and viewer are. All coordinates are `f32` numbers.
#[derive(Clone, Copy, Debug)]
pub(in crate::trade::stress) struct Scene {
    light: Vec3,
    view: Vec3,
    pub(in crate::trade::stress) normal: Vec3,
    exponent: u32,
    reflection: Reflection,
    /// Whether light and viewer are infinitely far away, in these directions.
    far: bool,
    /// Whether there must be no highlight, whatever the formula says.
    dark: bool,
}

impl Scene {
    /// Light and viewer in these directions, infinitely far away.
    pub(in crate::trade::stress) fn far(
        light: DVec3,
        view: DVec3,
        normal: DVec3,
        exponent: u32,
        reflection: Reflection,
    ) -> Self {
        let [light, view, normal] = [light, view, normal].map(|v| v.as_vec3());
        Self { light, view, normal, exponent, reflection, far: true, dark: false }
    }

    /// Light and viewer at these points.
    pub(in crate::trade::stress) fn near(
        light: DVec3,
        view: DVec3,
        normal: DVec3,
        exponent: u32,
        reflection: Reflection,
    ) -> Self {
        Self { far: false, ..Self::far(light, view, normal, exponent, reflection) }
    }

    /// There is no highlight here.
    pub(in crate::trade::stress) fn without_highlight(self) -> Self {
        Self { dark: true, ..self }
    }

    /// The red light that the point sends, of a white material.
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
    pub(in crate::trade::stress) fn diffuse(&self) -> [f64; 2] {
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
    pub(in crate::trade::stress) fn true_diffuse(&self) -> Big {
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

    /// The formulas as they are usually written.
    fn plain_highlight(&self) -> f32 {
        let [normal, light, view] = [self.normal, self.light, self.view].map(naive::unit);
        let cosine = match self.reflection {
            Reflection::Blinn => normal.dot(naive::unit(light + view)),
            Reflection::Phong => (2.0 * normal.dot(light) * normal - light).dot(view),
        };
        if cosine <= 0.0 { 0.0 } else { libm::powf(cosine, self.exponent as f32) }
    }
}

/// The highlights of scenes.
pub(in crate::trade::stress) fn measure(scenes: impl Iterator<Item = Scene>) -> Measured {
    let errors = scenes.map(|scene| {
        let truth = scene.true_highlight();
        let error = |got: f64| if got.is_nan() { got } else { small(&(big(got) - &truth).abs()) };
        let [double, single] = scene.highlights();
        [double, single, f64::from(scene.plain_highlight())].map(error)
    });
    three(&errors.collect::<Vec<_>>())
}

/// Errors of double precision, single precision and plain code.
pub(in crate::trade::stress) fn three(errors: &[[f64; 3]]) -> Measured {
    let [faithful, fast, plain] = [0, 1, 2].map(|way| errors.iter().map(|e| e[way]).collect::<Worst>());
    Measured { samples: errors.len(), faithful, fast: Some(fast), declined: 0, plain: Some(plain) }
}
