//! One light on one material: what of it there is to compute.

use super::formula::{Triple, half_vector, rounded, unit};
use super::light::Light;
use super::material::{Material, Reflection};
use super::settings::{ShadeSettings, Viewer};
use super::source::Source;
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

/// A point of a surface, prepared for all lights.
#[derive(Clone, Copy, Debug)]
pub(super) struct PreparedPoint<R> {
    pub(super) position: Triple<R>,
    /// N.
    pub(super) normal: Triple<R>,
    /// V; not a direction if nothing needs it.
    pub(super) view: Triple<R>,
    /// The distance to the viewer; 0 if the viewer is at infinity.
    pub(super) view_distance: R,
    /// The normal of its face, if the terminator needs it.
    pub(super) face: Option<Triple<R>>,
}

/// The light that arrives at a point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Incoming<R> {
    /// L; for an area light the direction of its representative point.
    pub(super) towards: Triple<R>,
    /// The distance to the light; 0 for directional lights.
    pub(super) distance: R,
    /// The attenuation; for an area light what a surface facing it receives.
    pub(super) attenuation: R,
    /// The factor of a spot's cone.
    pub(super) cone: Option<R>,
    /// The diffuse irradiance of an area light, in place of f·N·L.
    pub(super) irradiance: Option<R>,
}

impl<R: Real> Incoming<R> {
    /// f: attenuation and cone together.
    #[inline(always)]
    pub(super) fn factor(&self) -> R {
        match self.cone {
            Some(cone) => self.attenuation * cone,
            None => self.attenuation,
        }
    }
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
                half_vector(unit(towards), unit(view)).map(|half| Highlight::BlinnSame(rounded(half)))
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

    /// The light that arrives at a point. `direction` says whether L and the attenuation of an area light are needed.
    #[inline(always)]
    pub(super) fn incoming(&self, point: &PreparedPoint<R>, direction: bool) -> Incoming<R> {
        let at_infinity = |towards| Incoming {
            towards,
            distance: R::ZERO,
            attenuation: R::ONE,
            cone: None,
            irradiance: None,
        };
        match &self.source {
            Source::Directional(towards) => at_infinity(*towards),
            Source::Point(source) => {
                let (towards, distance, attenuation) = source.at(point.position);
                Incoming { distance, attenuation, ..at_infinity(towards) }
            }
            Source::Spot(source, spot) => {
                let (towards, distance, attenuation) = source.at(point.position);
                Incoming { distance, attenuation, cone: Some(spot.at(towards)), ..at_infinity(towards) }
            }
            Source::Area(area) => {
                // In double precision always: angles of narrow edges and clipping want it, and nothing here is a
                // vector operation.
                let [position, normal, view] = [point.position, point.normal, point.view]
                    .map(|v| DVec3::from_array(v.map(Real::to_f64)));
                let ((towards, distance), facing) = match direction {
                    true => (area.towards(position, normal, view), area.facing(position)),
                    false => ((DVec3::ZERO, 0.0), 0.0),
                };
                Incoming {
                    towards: rounded(towards),
                    distance: R::of(distance),
                    attenuation: R::of(facing),
                    cone: None,
                    irradiance: Some(R::of(area.irradiance(position, normal))),
                }
            }
        }
    }
}
