//! Lights and a material resolved to the terms that they need, and the light on a point.

use super::error::{NotFinite, Place, Result};
use super::formula::{self, Triple, rounded, unit};
use super::light::Light;
use super::material::Material;
use super::settings::{Frame, Guards, ShadeSettings, Terminator, ToneRule, Viewer};
use super::source::{Highlight, Incoming, LightTerm, PreparedPoint, Source, in_frame};
use crate::num::{LinearRgb, Power, Real, Underflow};
use glam::DVec3;

/// Lights, one material and the settings, resolved to the terms that this combination needs.
///
/// `Shader<f32>` is for pictures, `Shader<f64>` for probes: the same formulas. Make one for each material: it is cheap,
/// and threads can share it.
///
/// ```
/// use crease::num::LinearRgb;
/// use crease::shade::{Light, Material, ShadeSettings, Shader, SurfacePoint, Viewer};
/// use glam::DVec3;
///
/// let lights = [Light::Directional { towards: DVec3::new(0.0, 0.0, 2.0), colour: LinearRgb::WHITE }];
/// let shader = Shader::<f64>::new(&lights, &Material::matte(LinearRgb::WHITE), &ShadeSettings::default())?;
/// let tilted = SurfacePoint { position: [0.0; 3], normal: [0.8, 0.0, 0.6] };
/// assert_eq!(shader.shade(&tilted)?, [0.9 * 0.6; 3]);
/// // One light far away and no highlight: neither positions nor the viewer matter.
/// assert!(!shader.needs_positions());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Shader<R> {
    /// Σ I_a K_a.
    pub(super) ambient: Triple<R>,
    pub(super) lights: Vec<LightTerm<R>>,
    /// The viewer, if a term depends on the view direction.
    pub(super) view: Option<View<R>>,
    pub(super) power: Power<R>,
    pub(super) depth_cue: Option<R>,
    pub(super) two_sided: bool,
    pub(super) terminator: Terminator,
    pub(super) limits: Limits<R>,
    pub(super) frame: Frame,
    pub(super) tone: ToneRule,
    pub(super) exponent: f64,
    pub(super) viewer: View<R>,
}

/// A point of a surface, in the frame of the settings.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SurfacePoint<R> {
    /// Its position. Not read if the shader doesn't [need positions](Shader::needs_positions).
    pub position: [R; 3],
    /// Its normal, of any length if the guard `renormalise` is on, and of length 1 otherwise.
    pub normal: [R; 3],
}

/// The direction from a point against the ray that meets it, and the length of the path to the viewer.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SeenFrom<R> {
    /// A unit vector.
    pub(crate) view: [R; 3],
    /// In units of the frame.
    pub(crate) distance: R,
}

#[derive(Clone, Copy, Debug)]
pub(super) enum View<R> {
    /// V, the same at every point.
    Same(Triple<R>),
    /// The position of the viewer, in the frame of the shader.
    From(Triple<R>),
}

/// Guards as numbers to compare cosines with, without a branch.
#[derive(Clone, Copy, Debug)]
pub(super) struct Limits<R> {
    /// A diffuse cosine is at least this.
    pub(super) diffuse: R,
    /// There is no highlight where N·L is at most this.
    pub(super) highlight: R,
    pub(super) renormalise: bool,
}

impl<R: Real> Limits<R> {
    fn new(guards: Guards) -> Self {
        let zero_if = |on: bool| if on { R::ZERO } else { R::NEG_INFINITY };
        Self {
            diffuse: zero_if(guards.diffuse),
            highlight: zero_if(guards.highlight),
            renormalise: guards.renormalise,
        }
    }
}

impl<R: Real> Shader<R> {
    /// Resolves lights and a material to the terms that they need.
    ///
    /// # Errors
    /// Invalid numbers: not finite, negative, a direction of length 0, an angle out of range, depth cueing without a viewer at a
    /// finite distance, lights or viewers too far from the scene, and colours beyond the range of `R`.
    pub fn new(lights: &[Light], material: &Material, settings: &ShadeSettings) -> Result<Self> {
        Self::with(lights, material, settings, |term| !term.is_dark())
    }

    /// The same with the terms that are wanted.
    pub(super) fn with(
        lights: &[Light],
        material: &Material,
        settings: &ShadeSettings,
        wanted: fn(&LightTerm<R>) -> bool,
    ) -> Result<Self> {
        material.check::<R>()?;
        settings.check()?;
        let viewer = match settings.viewer {
            Viewer::At(eye) => View::From(in_frame(eye, &settings.frame, Place::Settings, "viewer")?),
            Viewer::Towards(direction) => View::Same(rounded(unit(direction))),
        };
        let mut ambient = LinearRgb::BLACK;
        let mut terms = Vec::new();
        for (number, light) in lights.iter().enumerate() {
            light.check(number)?;
            Place::Light(number).in_range::<R>("colour", light.colour())?;
            match Source::new(light, number, &settings.frame, settings.guards)? {
                None => ambient += light.colour() * material.ambient.merged(),
                Some(source) => terms.push(LightTerm::new(number, source, light, material, settings)),
            }
        }
        terms.retain(wanted);
        let for_highlights =
            |term: &LightTerm<R>| matches!(term.specular, Some((_, Highlight::Phong | Highlight::Blinn)));
        let lit = !terms.is_empty();
        let seen =
            terms.iter().any(for_highlights) || lit && (settings.two_sided || settings.depth_cue.is_some());
        let underflow = if settings.guards.underflow { Underflow::Zero } else { Underflow::Gradual };
        Ok(Self {
            ambient: ambient.to_array().map(|c| R::of(c)),
            lights: terms,
            view: seen.then_some(viewer),
            power: Power::new(material.exponent, underflow),
            depth_cue: settings.depth_cue.filter(|_| lit).map(|cue| R::of(cue.k / settings.frame.unit)),
            two_sided: settings.two_sided,
            terminator: settings.terminator,
            limits: Limits::new(settings.guards),
            frame: settings.frame,
            tone: settings.tone,
            exponent: material.exponent,
            viewer,
        })
    }

    /// Whether the colour depends on where a point is, or only on its normal. If not, positions need not be given.
    pub fn needs_positions(&self) -> bool {
        self.lights.iter().any(|term| !term.source.is_directional())
            || matches!(self.view, Some(View::From(_)))
    }

    /// Whether the colour depends on the normal. If not, all points have the same.
    pub fn needs_normals(&self) -> bool {
        !self.lights.is_empty()
    }

    /// The light that a point sends to the viewer: linear red, green, blue, before the tone rule (F8, F15, F16).
    ///
    /// # Errors
    /// If it is not finite: a point light at the point itself, an attenuation out of range, NaN in the input.
    pub fn shade(&self, point: &SurfacePoint<R>) -> Result<[R; 3], NotFinite> {
        self.shade_on(point, None)
    }

    /// The light that a point on a face with this unit normal sends to the viewer. [`ShadeSettings::terminator`] uses
    /// the normal to reduce light from behind the face. With `None` or [`Terminator::Smooth`] it is that of
    /// [`shade`](Self::shade).
    ///
    /// # Errors
    /// As [`shade`](Self::shade).
    pub fn shade_on(&self, point: &SurfacePoint<R>, face: Option<[R; 3]>) -> Result<[R; 3], NotFinite> {
        let colour = self.sum(&self.prepared(point, face), false, |_, _, _| {});
        if colour.iter().all(|component| component.is_finite()) {
            Ok(colour)
        } else {
            Err(self.not_finite(0, point))
        }
    }

    /// The light that a point on a face sends along a ray: to the viewer, or to `seen_from`.
    ///
    /// `visible` returns the share of the light of each number that reaches the point; it is asked only for lights that
    /// add something. Where all shares are 1 the bits are those of [`shade_on`](Self::shade_on).
    ///
    /// # Errors
    /// As [`shade`](Self::shade).
    pub(crate) fn shade_ray(
        &self,
        point: &SurfacePoint<R>,
        face: Option<[R; 3]>,
        seen_from: Option<SeenFrom<R>>,
        visible: &mut dyn FnMut(usize) -> [R; 3],
    ) -> Result<[R; 3], NotFinite> {
        let mut prepared = self.prepared(point, face);
        if let Some(SeenFrom { view, distance }) = seen_from {
            prepared = PreparedPoint { view, view_distance: distance, own_view: true, ..prepared };
        }
        let share = |term: &LightTerm<R>, terms: [Triple<R>; 2]| {
            let share = if terms == [[R::ZERO; 3]; 2] { [R::ONE; 3] } else { visible(term.number) };
            if share == [R::ONE; 3] { terms } else { terms.map(|term| formula::scaled(term, share)) }
        };
        let colour = self.sum_of(&prepared, false, |_, _, _| {}, share);
        if colour.iter().all(|component| component.is_finite()) {
            Ok(colour)
        } else {
            Err(self.not_finite(0, point))
        }
    }

    /// The shading sum. `record` receives each light with its diffuse and specular terms; `directions`: whether it also
    /// needs L and the attenuation of lights that do not use them.
    pub(super) fn sum(
        &self,
        point: &PreparedPoint<R>,
        directions: bool,
        record: impl FnMut(&LightTerm<R>, &Incoming<R>, [Triple<R>; 2]),
    ) -> Triple<R> {
        self.sum_of(point, directions, record, |_, terms| terms)
    }

    /// The same; `share` returns the terms of a light that reach the point.
    fn sum_of(
        &self,
        point: &PreparedPoint<R>,
        directions: bool,
        mut record: impl FnMut(&LightTerm<R>, &Incoming<R>, [Triple<R>; 2]),
        mut share: impl FnMut(&LightTerm<R>, [Triple<R>; 2]) -> [Triple<R>; 2],
    ) -> Triple<R> {
        let sum = self.lights.iter().fold([R::ZERO; 3], |sum, term| {
            let direction = directions || term.specular.is_some() || point.face.is_some();
            let incoming = term.incoming(point, direction);
            let terms = self.reflected(term, &incoming, point);
            record(term, &incoming, terms);
            let terms = share(term, terms);
            formula::plus(formula::plus(sum, terms[0]), terms[1])
        });
        self.finish(sum, point.view_distance)
    }

    /// The diffuse term f I K_d (N·L) and the specular term f I K_s cosⁿ of one light, 0 if the material has no such term.
    fn reflected(
        &self,
        term: &LightTerm<R>,
        incoming: &Incoming<R>,
        point: &PreparedPoint<R>,
    ) -> [Triple<R>; 2] {
        let share = point.face.map(|face| self.reaching(face, point.normal, incoming.towards));
        let scaled = |colour, amount: R| formula::times(colour, share.map_or(amount, |share| amount * share));
        let diffuse = term.diffuse.map(|colour| scaled(colour, self.diffuse(incoming, point)));
        let specular = term
            .specular
            .map(|(colour, highlight)| scaled(colour, self.specular(&highlight, incoming, point)));
        [diffuse, specular].map(|term| term.unwrap_or([R::ZERO; 3]))
    }

    /// A point with its used normal, V, the distance to the viewer, and the normal of its face if the terminator needs it.
    #[inline(always)]
    pub(super) fn prepared(&self, point: &SurfacePoint<R>, face: Option<Triple<R>>) -> PreparedPoint<R> {
        let (view, view_distance) = match self.view {
            None => ([R::ZERO; 3], R::ZERO),
            Some(view) => view.at(point.position),
        };
        let normal = if self.limits.renormalise { formula::normalised(point.normal) } else { point.normal };
        let normal = if self.two_sided { turned(normal, view) } else { normal };
        let face = face.filter(|_| self.terminator != Terminator::Smooth);
        PreparedPoint { position: point.position, normal, view, view_distance, own_view: false, face }
    }

    /// The share of light from a direction that the terminator keeps.
    #[inline(always)]
    pub(super) fn reaching(&self, face: Triple<R>, normal: Triple<R>, towards: Triple<R>) -> R {
        let face_light = formula::dot(face, towards);
        match self.terminator {
            Terminator::Soft => {
                formula::softened(face_light, formula::dot(normal, towards), formula::dot(face, normal))
            }
            Terminator::Hard if face_light <= R::ZERO => R::ZERO,
            Terminator::Hard | Terminator::Smooth => R::ONE,
        }
    }

    /// f·max(N·L, 0), or the irradiance of an area light.
    #[inline(always)]
    pub(super) fn diffuse(&self, incoming: &Incoming<R>, point: &PreparedPoint<R>) -> R {
        match incoming.irradiance {
            Some(irradiance) => irradiance,
            None => incoming.factor() * self.diffuse_cosine(point.normal, incoming.towards),
        }
    }

    /// f·cosⁿ.
    #[inline(always)]
    pub(super) fn specular(
        &self,
        highlight: &Highlight<R>,
        incoming: &Incoming<R>,
        point: &PreparedPoint<R>,
    ) -> R {
        // The half-vector of all points is that of the viewer.
        let is_shared = matches!(highlight, Highlight::BlinnSame(_));
        let highlight = if is_shared && point.own_view { &Highlight::Blinn } else { highlight };
        let cosine = self.highlight_cosine(highlight, point.normal, incoming.towards, point.view);
        incoming.factor() * self.power.of(cosine)
    }

    /// N·L, and 0 where it is negative and the guard `diffuse` is on (F3).
    #[inline(always)]
    pub(super) fn diffuse_cosine(&self, normal: Triple<R>, towards: Triple<R>) -> R {
        formula::at_least(formula::dot(normal, towards), self.limits.diffuse)
    }

    /// V·R or N·H, and 0 where the guard is on and the light is behind (F4, F6).
    #[inline(always)]
    pub(super) fn highlight_cosine(
        &self,
        highlight: &Highlight<R>,
        normal: Triple<R>,
        towards: Triple<R>,
        view: Triple<R>,
    ) -> R {
        let cosine = match *highlight {
            Highlight::Phong => formula::phong_cosine(normal, towards, view),
            Highlight::Blinn => formula::blinn_cosine(normal, towards, view),
            Highlight::BlinnSame(half) => formula::dot(normal, half),
        };
        if formula::dot(normal, towards) <= self.limits.highlight { R::ZERO } else { cosine }
    }

    /// Ambient light and the rest, faded with the distance to the viewer (F17).
    #[inline(always)]
    pub(super) fn finish(&self, sum: Triple<R>, view_distance: R) -> Triple<R> {
        let sum = match self.depth_cue {
            Some(k) => formula::times(sum, R::of(1.0 / self.frame.unit) / (view_distance + k)),
            None => sum,
        };
        formula::plus(self.ambient, sum)
    }

    /// The error about a point, with the first light whose terms are not finite.
    #[cold]
    pub(super) fn not_finite(&self, index: usize, point: &SurfacePoint<R>) -> NotFinite {
        let mut light = None;
        self.sum(&self.prepared(point, None), false, |term, _, [diffuse, specular]| {
            let is_finite = formula::plus(diffuse, specular).iter().all(|component| component.is_finite());
            light = light.or((!is_finite).then_some(term.number));
        });
        let position = DVec3::from_array(point.position.map(Real::to_f64));
        NotFinite {
            index,
            position: self.frame.to_world(position).to_array(),
            normal: point.normal.map(Real::to_f64),
            light,
        }
    }
}

impl<R: Real> View<R> {
    #[inline(always)]
    pub(super) fn at(&self, position: Triple<R>) -> (Triple<R>, R) {
        match *self {
            View::Same(view) => (view, R::ZERO),
            View::From(eye) => formula::towards(position, eye),
        }
    }
}

/// The normal on the viewer's side.
#[inline(always)]
pub(super) fn turned<R: Real>(normal: Triple<R>, view: Triple<R>) -> Triple<R> {
    let sign = if formula::dot(normal, view) < R::ZERO { -R::ONE } else { R::ONE };
    formula::times(normal, sign)
}
