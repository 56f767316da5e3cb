//! The terms of the colour of one point.

use super::error::{NotFinite, ShadeError};
use super::formula::{self, half_vector};
use super::light::Light;
use super::material::Material;
use super::settings::{Guards, ShadeSettings};
use super::shader::{Shader, SurfacePoint, View};
use super::source::{Highlight, Incoming, LightTerm, PreparedPoint};
use crate::num::{Nine, NineEach};
use glam::DVec3;
use serde::Serialize;
use std::fmt;

/// The terms of the colour of a point. Vectors are unit vectors in the world, distances in its unit.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Explanation {
    /// The point.
    pub position: [f64; 3],
    /// N, renormalised and flipped as the settings ask.
    pub normal: [f64; 3],
    /// V, to the viewer.
    pub view: [f64; 3],
    /// The distance to the viewer; `None` at infinity.
    pub view_distance: Option<f64>,
    /// Σ I_a K_a.
    pub ambient: [f64; 3],
    /// All lights but ambient ones, also those that the material does not reflect.
    pub lights: Vec<LightExplanation>,
    /// 1/(d+k) with the distance to the viewer, if there is depth cueing.
    pub depth_cue: Option<f64>,
    /// The whole: ambient light, and all lights faded by the depth cue.
    pub sum: [f64; 3],
    /// The tone rule's name.
    pub tone: &'static str,
    /// The sum after it.
    pub colour: [f64; 3],
}

impl Explanation {
    /// The error of a picture if this sum is not finite.
    pub fn not_finite(&self) -> Option<NotFinite> {
        let is_finite = |parts: &[f64; 3]| parts.iter().all(|part| part.is_finite());
        let spoils = |light: &&LightExplanation| {
            !(is_finite(&light.diffuse.guarded) && is_finite(&light.specular.guarded))
        };
        let error = || NotFinite {
            index: 0,
            position: self.position,
            normal: self.normal,
            light: self.lights.iter().find(spoils).map(|light| light.light),
        };
        (!is_finite(&self.sum)).then(error)
    }
}

/// The terms of one light.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LightExplanation {
    /// Its number among the scene's lights, from 0.
    pub light: usize,
    /// Its kind.
    pub kind: &'static str,
    /// L, to the light; for an area light to its representative point.
    pub towards: [f64; 3],
    /// Its distance; `None` at infinity.
    pub distance: Option<f64>,
    /// The factor of the distance: 1 at infinity. For an area light the irradiance of a surface facing it.
    pub attenuation: f64,
    /// The factor of a spot's cone.
    pub cone: Option<f64>,
    /// The irradiance from an area light, in place of attenuation and N·L.
    pub irradiance: Option<f64>,
    /// N·L, not clamped.
    pub n_dot_l: f64,
    /// R = 2N(N·L) − L.
    pub reflected: [f64; 3],
    /// V·R.
    pub v_dot_r: f64,
    /// H = (L+V)/‖L+V‖; `None` for 0/0.
    pub half: Option<[f64; 3]>,
    /// N·H.
    pub n_dot_h: Option<f64>,
    /// The highlight, if the material and the light have one.
    pub highlight: Option<HighlightExplanation>,
    /// The diffuse term.
    pub diffuse: Term,
    /// The specular term.
    pub specular: Term,
}

/// The cosine of a highlight and its power.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct HighlightExplanation {
    /// `V·R` or `N·H`.
    pub cosine_of: &'static str,
    /// n.
    pub exponent: f64,
    /// cosⁿ, after the guards.
    pub power: f64,
}

/// A term before and after the guards.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Term {
    /// By the formula as the lectures print it.
    pub literal: [f64; 3],
    /// As it counts.
    pub guarded: [f64; 3],
}

/// A shader for single points that reports the terms of its sum.
///
/// ```
/// use crease::num::LinearRgb;
/// use crease::shade::{Light, Material, Probe, ShadeSettings, SurfacePoint};
/// use glam::DVec3;
///
/// let light = Light::Directional { towards: DVec3::new(-4.0, 0.0, -3.0), colour: LinearRgb::WHITE };
/// let probe = Probe::new(&[light], &Material::matte(LinearRgb::WHITE), &ShadeSettings::default())?;
/// let explanation = probe.explain(&SurfacePoint { position: [0.0; 3], normal: [0.0, 0.0, 1.0] });
/// assert!((explanation.lights[0].n_dot_l + 0.6).abs() < 1e-15);
/// // The guard against light from behind at work.
/// assert!(explanation.lights[0].diffuse.literal[0] < -0.5);
/// assert_eq!(explanation.lights[0].diffuse.guarded, [0.0; 3]);
/// println!("{explanation}");
/// # Ok::<(), crease::shade::ShadeError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Probe {
    guarded: Shader<f64>,
    /// The same without guards.
    literal: Shader<f64>,
}

impl Probe {
    /// As [`Shader::new`].
    ///
    /// # Errors
    /// The same.
    pub fn new(lights: &[Light], material: &Material, settings: &ShadeSettings) -> Result<Self, ShadeError> {
        let without = ShadeSettings { guards: Guards::literal(), ..*settings };
        Ok(Self {
            guarded: Shader::with(lights, material, settings, |_| true)?,
            literal: Shader::with(lights, material, &without, |_| true)?,
        })
    }

    /// The sum of [`Shader::shade`] at this point, with its terms. Numbers that are not finite are reported unchanged.
    pub fn explain(&self, point: &SurfacePoint<f64>) -> Explanation {
        self.explain_on(point, None)
    }

    /// The same of [`Shader::shade_on`].
    pub fn explain_on(&self, point: &SurfacePoint<f64>, face: Option<[f64; 3]>) -> Explanation {
        let shader = &self.guarded;
        // V is reported also if no term needs it.
        let (view, view_distance) = shader.viewer.at(point.position);
        let prepared = PreparedPoint { view, view_distance, ..shader.prepared(point, face) };
        let literally = PreparedPoint { view, view_distance, ..self.literal.prepared(point, face) };
        let mut lights = Vec::with_capacity(shader.lights.len());
        let sum = shader.sum(&prepared, true, |term, incoming, terms| {
            lights.push(shader.explain_light(term, incoming, &prepared, terms));
        });
        // Both shaders have the same lights: guards do not remove any.
        let mut explained = lights.iter_mut();
        self.literal.sum(&literally, true, |_, _, [diffuse, specular]| {
            if let Some(light) = explained.next() {
                (light.diffuse.literal, light.specular.literal) = (diffuse, specular);
            }
        });
        let unit = shader.frame.unit;
        Explanation {
            position: shader.frame.to_world(DVec3::from_array(point.position)).to_array(),
            normal: prepared.normal,
            view,
            view_distance: matches!(shader.viewer, View::From(_)).then_some(view_distance * unit),
            ambient: shader.ambient,
            lights,
            depth_cue: shader.depth_cue.map(|k| 1.0 / (unit * (view_distance + k))),
            sum,
            tone: shader.tone.name(),
            colour: shader.tone.apply(sum),
        }
    }
}

impl Shader<f64> {
    /// A light with its terms, whose literal ones are not known yet.
    fn explain_light(
        &self,
        term: &LightTerm<f64>,
        incoming: &Incoming<f64>,
        point: &PreparedPoint<f64>,
        [diffuse, specular]: [[f64; 3]; 2],
    ) -> LightExplanation {
        let (normal, view, towards) = (point.normal, point.view, incoming.towards);
        let reflected = formula::mirrored(normal, towards);
        let half = half_vector(towards.into(), view.into()).map(|h| h.to_array());
        let literal = [0.0; 3];
        LightExplanation {
            light: term.number,
            kind: term.kind,
            towards,
            distance: (!term.source.is_directional()).then_some(incoming.distance * self.frame.unit),
            attenuation: incoming.attenuation,
            cone: incoming.cone,
            irradiance: incoming.irradiance,
            n_dot_l: formula::dot(normal, towards),
            reflected,
            v_dot_r: formula::dot(view, reflected),
            half,
            n_dot_h: half.map(|half| formula::dot(normal, half)),
            highlight: term.specular.map(|(_, highlight)| HighlightExplanation {
                cosine_of: if matches!(highlight, Highlight::Phong) { "V·R" } else { "N·H" },
                exponent: self.exponent,
                power: self.power.of(self.highlight_cosine(&highlight, normal, towards, view)),
            }),
            diffuse: Term { literal, guarded: diffuse },
            specular: Term { literal, guarded: specular },
        }
    }
}

impl fmt::Display for Explanation {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        writeln!(f, "position     {}", NineEach(self.position))?;
        writeln!(f, "N            {}", NineEach(self.normal))?;
        match self.view_distance {
            Some(distance) => {
                writeln!(f, "V            {}, viewer at distance {}", NineEach(self.view), Nine(distance))?
            }
            None => writeln!(f, "V            {}, viewer at infinity", NineEach(self.view))?,
        }
        writeln!(f, "ambient      {}", NineEach(self.ambient))?;
        self.lights.iter().try_for_each(|light| light.fmt(f))?;
        if let Some(factor) = self.depth_cue {
            writeln!(f, "depth cue    {}, on all but ambient light", Nine(factor))?;
        }
        writeln!(f, "sum          {}", NineEach(self.sum))?;
        write!(f, "colour       {}, tone {}", NineEach(self.colour), self.tone)
    }
}

impl fmt::Display for LightExplanation {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        writeln!(f, "light {}, {}", self.light, self.kind)?;
        match self.distance {
            Some(distance) => {
                writeln!(f, "  L          {}, distance {}", NineEach(self.towards), Nine(distance))?
            }
            None => writeln!(f, "  L          {}, at infinity", NineEach(self.towards))?,
        }
        match self.irradiance {
            None => writeln!(f, "  attenuation {}", Nine(self.attenuation))?,
            Some(irradiance) => {
                writeln!(f, "  irradiance {}, the diffuse term's", Nine(irradiance))?;
                if self.highlight.is_some() {
                    writeln!(f, "  facing     {}, the highlight's factor", Nine(self.attenuation))?;
                }
            }
        }
        if let Some(cone) = self.cone {
            writeln!(f, "  cone       {}", Nine(cone))?;
        }
        writeln!(f, "  N·L        {}", Nine(self.n_dot_l))?;
        writeln!(f, "  R          {}, V·R {}", NineEach(self.reflected), Nine(self.v_dot_r))?;
        match (self.half, self.n_dot_h) {
            (Some(half), Some(cosine)) => {
                writeln!(f, "  H          {}, N·H {}", NineEach(half), Nine(cosine))?
            }
            _ => writeln!(f, "  H          none: L = −V")?,
        }
        if let Some(HighlightExplanation { cosine_of, exponent, power }) = &self.highlight {
            writeln!(f, "  highlight  ({cosine_of})^{exponent} = {}", Nine(*power))?;
        }
        self.diffuse.write(f, "diffuse ")?;
        self.specular.write(f, "specular")
    }
}

impl Term {
    fn write(&self, f: &mut fmt::Formatter, name: &str) -> fmt::Result {
        let [guarded, literal] = [self.guarded, self.literal].map(|term| NineEach(term).to_string());
        write!(f, "  {name}   {guarded}")?;
        // Without renormalisation the last digits differ even for unit normals.
        if literal != guarded {
            write!(f, "; without guards {literal}")?;
        }
        writeln!(f)
    }
}
