//! One light on one material: what of it there is to compute.

use super::formula::{self, Triple};
use super::light::Light;
use super::material::{Material, Reflection};
use super::settings::{ShadeSettings, Viewer};
use super::shader::Ready;
use super::source::{Source, rounded, unit};
use crate::num::{LinearRgb, Real};
use glam::DVec3;

/// One light on one material.
#[derive(Clone, Debug)]
pub(super) struct LightTerm<R> {
    /// The light's number in the scene.
    pub(super) number: usize,
    pub(super) kind: &'static str,
    pub(super) source: Source<R>,
    /// I·K_d, unless it is black.
    pub(super) diffuse: Option<Triple<R>>,
    /// I·K_s and what the cosine is taken of, unless there is no highlight.
    pub(super) specular: Option<(Triple<R>, Highlight<R>)>,
}

/// What the cosine of a highlight is taken of.
#[derive(Clone, Copy, Debug)]
pub(super) enum Highlight<R> {
    /// V·R.
    Phong,
    /// N·H with an H of each point's own.
    Blinn,
    /// N·H with the same H everywhere: light and viewer are at infinity.
    BlinnSame(Triple<R>),
}

/// What arrives from a light at a point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Incoming<R> {
    /// L; for an area light the direction of its representative point.
    pub(super) towards: Triple<R>,
    /// Attenuation and cone together; for an area light what a surface facing it gets.
    pub(super) factor: R,
    /// The diffuse irradiance of an area light, in place of f·N·L.
    pub(super) irradiance: Option<R>,
}

impl<R: Real> LightTerm<R> {
    pub(super) fn new(
        number: usize,
        source: Source<R>,
        light: &Light,
        material: &Material,
        settings: &ShadeSettings,
    ) -> Self {
        let coloured = |reflectance: LinearRgb| {
            let product = light.colour() * reflectance;
            (product != LinearRgb::BLACK).then(|| product.to_array().map(|c| R::of(c)))
        };
        let highlight = match (material.reflection, light, settings.viewer) {
            (Reflection::Phong, ..) => Some(Highlight::Phong),
            (Reflection::Blinn, &Light::Directional { towards, .. }, Viewer::Towards(view)) => {
                same_half_vector(unit(towards), unit(view)).map(|half| Highlight::BlinnSame(rounded(half)))
            }
            (Reflection::Blinn, ..) => Some(Highlight::Blinn),
        };
        let diffuse = coloured(material.diffuse.merged());
        let specular = coloured(material.specular.merged()).zip(highlight);
        Self { number, kind: light.kind(), source, diffuse, specular }
    }

    /// Whether the material returns nothing of this light.
    pub(super) fn is_dark(&self) -> bool {
        self.diffuse.is_none() && self.specular.is_none()
    }

    /// L and what arrives.
    #[inline(always)]
    pub(super) fn incoming(&self, ready: &Ready<R>) -> Incoming<R> {
        match &self.source {
            Source::Directional(towards) => Incoming { towards: *towards, factor: R::ONE, irradiance: None },
            Source::Point(point) => {
                let (towards, _, factor) = point.at(ready.position);
                Incoming { towards, factor, irradiance: None }
            }
            Source::Spot(point, spot) => {
                let (towards, _, factor) = point.at(ready.position);
                Incoming { towards, factor: factor * spot.at(towards), irradiance: None }
            }
            Source::Area(area) => {
                // In double precision always: angles of narrow edges and clipping want it, and nothing here is a
                // vector operation.
                let [position, normal, view] = [ready.position, ready.normal, ready.view]
                    .map(|v| DVec3::from_array(v.map(Real::to_f64)));
                let (towards, factor) = match self.specular {
                    Some(_) => (area.towards(position, normal, view).0, area.facing(position)),
                    None => (DVec3::ZERO, 0.0),
                };
                let irradiance = Some(R::of(area.irradiance(position, normal)));
                Incoming { towards: rounded(towards), factor: R::of(factor), irradiance }
            }
        }
    }
}

impl<R: Real> LightTerm<R> {
    /// L; of an area light that of its representative point, whether or not anything else needs it.
    pub(super) fn towards(&self, incoming: &Incoming<R>, ready: &Ready<R>) -> Triple<R> {
        let Source::Area(area) = &self.source else { return incoming.towards };
        let [position, normal, view] =
            [ready.position, ready.normal, ready.view].map(|v| DVec3::from_array(v.map(Real::to_f64)));
        rounded(area.towards(position, normal, view).0)
    }
}

/// H, unless light and viewer are opposite.
pub(super) fn same_half_vector(light: DVec3, view: DVec3) -> Option<DVec3> {
    let sum = light + view;
    (sum.length_squared() > formula::rounding_of_opposites::<f64>()).then(|| unit(sum))
}
