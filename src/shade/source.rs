//! Lights as a shader needs them: in the frame and the precision of its points, everything constant worked out.

use super::area::AreaSource;
use super::error::{Check, Place, ShadeError};
use super::formula::{self, Triple, rounded, unit};
use super::light::{Attenuation, Cone, Light};
use super::settings::{Frame, Guards};
use crate::num::{Power, Real, Underflow};
use glam::DVec3;

/// Where light comes from, and how much.
#[derive(Clone, Debug)]
pub(super) enum Source<R> {
    /// L, everywhere the same.
    Directional(Triple<R>),
    Point(PointSource<R>),
    Spot(PointSource<R>, SpotSource<R>),
    Area(AreaSource),
}

/// A light at a point.
#[derive(Clone, Copy, Debug)]
pub(super) struct PointSource<R> {
    position: Triple<R>,
    /// kc, kl, kq for distances in units of the frame; none where the factor is 1.
    attenuation: Option<Triple<R>>,
    /// 1/r², where there is a range.
    inverse_square_range: Option<R>,
}

/// The cone of a spot.
#[derive(Clone, Copy, Debug)]
pub(super) struct SpotSource<R> {
    /// D, from the light.
    axis: Triple<R>,
    /// 1 − cos of the cut-off and 1/(its difference to where the edge begins), unless there is no cut-off.
    edge: Option<(R, R)>,
    /// The exponent of the cosine, unless it is 0.
    pub(super) concentration: Option<Power<R>>,
    /// Whether the cosine is not let below 0.
    guarded: bool,
}

impl<R: Real> Source<R> {
    /// Whether L is the same everywhere.
    pub(super) fn is_directional(&self) -> bool {
        matches!(self, Self::Directional(_))
    }

    /// None for ambient light, which comes from nowhere.
    pub(super) fn new(
        light: &Light,
        number: usize,
        frame: &Frame,
        guards: Guards,
    ) -> Result<Option<Self>, ShadeError> {
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
    fn new(
        position: DVec3,
        attenuation: Attenuation,
        number: usize,
        frame: &Frame,
    ) -> Result<Self, ShadeError> {
        let [constant, linear, quadratic] = attenuation.coefficients();
        let range = attenuation.range() / frame.unit;
        Ok(Self {
            position: in_frame(position, frame, Check(Place::Light(number)), "position")?,
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

    /// What the exponent is applied to: |D·L|, so that a spot without guard keeps its sign.
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

    /// The whole factor at once.
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
    check: Check,
    field: &'static str,
) -> Result<Triple<R>, ShadeError> {
    let local = frame.to_local(position);
    // A quarter of the exponents: the square has half of them, and there is room for what points add.
    let farthest = libm::exp2(R::EXPONENTS.1 / 4.0);
    if local.abs().max_element() <= farthest {
        return Ok(rounded(local));
    }
    let expected = "nearer to the scene (within 2^31 of its sizes in single precision); for a light, or a viewer, \
                    as far away as this, give a direction";
    Err(check.text(field, position.to_string(), expected))
}
