//! Lights in the frame and the precision of a shader, and the terms of one light on one material.

use super::area::AreaSource;
use super::error::{Place, Result};
use super::formula::{self, Triple, half_vector, rounded, unit};
use super::light::{Attenuation, Cone, Light};
use super::material::{Material, Reflection};
use super::settings::{Frame, Guards, ShadeSettings, Viewer};
use crate::num::{LinearRgb, Power, Real, Underflow};
use glam::DVec3;

/// The direction and amount of light at a point.
#[derive(Clone, Debug)]
pub(super) enum Source<R> {
    /// L, everywhere the same.
    Directional(Triple<R>),
    Point(PointSource<R>),
    Spot(PointSource<R>, SpotSource<R>),
    Area(AreaSource),
}

#[derive(Clone, Copy, Debug)]
pub(super) struct PointSource<R> {
    position: Triple<R>,
    /// kc, kl, kq for distances in units of the frame; none where the factor is 1.
    attenuation: Option<Triple<R>>,
    /// 1/r², where there is a range.
    inverse_square_range: Option<R>,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct SpotSource<R> {
    /// D, from the light.
    axis: Triple<R>,
    /// 1 − cos of the cut-off and 1/(its difference to where the edge begins), unless there is no cut-off.
    edge: Option<(R, R)>,
    /// The exponent of the cosine, unless it is 0.
    pub(super) concentration: Option<Power<R>>,
    guarded: bool,
}

impl<R: Real> Source<R> {
    pub(super) fn is_directional(&self) -> bool {
        matches!(self, Self::Directional(_))
    }

    /// `None` for ambient light.
    pub(super) fn new(light: &Light, number: usize, frame: &Frame, guards: Guards) -> Result<Option<Self>> {
        let place = |position: DVec3, attenuation| PointSource::new(position, attenuation, number, frame);
        Ok(Some(match *light {
            Light::Ambient { .. } => return Ok(None),
            Light::Directional { towards, .. } => Source::Directional(rounded(unit(towards))),
            Light::Point { position, attenuation, .. } => Source::Point(place(position, attenuation)?),
            Light::Spot { position, attenuation, cone, .. } => {
                Source::Spot(place(position, attenuation)?, SpotSource::new(&cone, guards))
            }
            Light::Area { shape, .. } => Source::Area(AreaSource::new(&shape, frame)),
        }))
    }
}

impl<R: Real> PointSource<R> {
    fn new(position: DVec3, attenuation: Attenuation, number: usize, frame: &Frame) -> Result<Self> {
        let [constant, linear, quadratic] = attenuation.coefficients();
        let range = attenuation.range() / frame.unit;
        Ok(Self {
            position: in_frame(position, frame, Place::Light(number), "position")?,
            attenuation: (attenuation != Attenuation::None).then(|| {
                [constant, linear * frame.unit, quadratic * frame.unit * frame.unit].map(|k| R::of(k))
            }),
            inverse_square_range: range.is_finite().then(|| R::of(1.0 / (range * range))),
        })
    }

    /// L, the distance and the attenuation at a point.
    #[inline(always)]
    pub(super) fn at(&self, point: Triple<R>) -> (Triple<R>, R, R) {
        let (towards, distance) = formula::towards(point, self.position);
        let faded = match self.attenuation {
            Some(coefficients) => formula::attenuation(coefficients, distance),
            None => R::ONE,
        };
        let factor = match self.inverse_square_range {
            Some(inverse) => faded * formula::window(distance, inverse),
            None => faded,
        };
        (towards, distance, factor)
    }
}

impl<R: Real> SpotSource<R> {
    fn new(cone: &Cone, guards: Guards) -> Self {
        let versine = |angle: f64| 2.0 * libm::sin(0.5 * angle) * libm::sin(0.5 * angle);
        let outer = versine(cone.cut_off.0);
        let width = outer - versine(cone.cut_off.0 - cone.soft_edge.0);
        let inverse_width = (1.0 / width).min(R::MAX.to_f64());
        Self {
            axis: rounded(unit(cone.axis)),
            edge: (cone.cut_off.0 < std::f64::consts::PI).then(|| (R::of(outer), R::of(inverse_width))),
            concentration: (cone.exponent != 0.0).then(|| Power::new(cone.exponent, Underflow::Zero)),
            guarded: guards.spot,
        }
    }

    /// D·L, with L from the light.
    #[inline(always)]
    pub(super) fn cosine(&self, towards: Triple<R>) -> R {
        -formula::dot(self.axis, towards)
    }

    /// The base of the power: |D·L|; a spot without guard keeps the sign.
    #[inline(always)]
    pub(super) fn base(cosine: R) -> R {
        cosine.abs()
    }

    /// The whole factor, from the cosine and its power.
    #[inline(always)]
    pub(super) fn factor(&self, towards: Triple<R>, cosine: R, power: R) -> R {
        let behind = if self.guarded { R::ZERO } else { -power };
        let aimed = if cosine <= R::ZERO { behind } else { power };
        match self.edge {
            Some((outer, inverse_width)) => {
                let versine = formula::versine(self.axis, towards, cosine);
                aimed * formula::soft_edge(versine, outer, inverse_width)
            }
            None => aimed,
        }
    }

    #[inline(always)]
    pub(super) fn at(&self, towards: Triple<R>) -> R {
        let cosine = self.cosine(towards);
        let power = match &self.concentration {
            Some(concentration) => concentration.of(Self::base(cosine)),
            None => R::ONE,
        };
        self.factor(towards, cosine, power)
    }
}

/// A position in the frame, where squares of distances stay in range.
pub(super) fn in_frame<R: Real>(
    position: DVec3,
    frame: &Frame,
    place: Place,
    field: &'static str,
) -> Result<Triple<R>> {
    let local = frame.to_local(position);
    // A quarter of the exponents: squares of distances take half of them.
    let farthest = libm::exp2(R::EXPONENTS.1 / 4.0);
    if local.abs().max_element() <= farthest {
        return Ok(rounded(local));
    }
    let expected = "nearer to the scene (within 2^31 of its sizes in single precision); for a light, or a viewer, \
                    as far away as this, give a direction";
    Err(place.error(field, position.to_string(), expected))
}

#[derive(Clone, Debug)]
pub(super) struct LightTerm<R> {
    pub(super) number: usize,
    pub(super) kind: &'static str,
    pub(super) source: Source<R>,
    /// I·K_d, unless it is black.
    pub(super) diffuse: Option<Triple<R>>,
    /// I·K_s and the kind of cosine, unless there is no highlight.
    pub(super) specular: Option<(Triple<R>, Highlight<R>)>,
}

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
    pub(super) normal: Triple<R>,
    /// V; not a direction if nothing needs it.
    pub(super) view: Triple<R>,
    /// The distance to the viewer; 0 if the viewer is at infinity.
    pub(super) view_distance: R,
    /// Whether V is not the direction to the viewer, but that of a reflected or refracted ray.
    pub(super) own_view: bool,
    /// The normal of its face, if the terminator needs it.
    pub(super) face: Option<Triple<R>>,
}

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
                // Always in double precision, for angles of narrow edges and for clipping.
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
