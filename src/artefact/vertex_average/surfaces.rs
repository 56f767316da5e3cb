//! Round surfaces in triangles of bad shape, whose own normals are known: an irregular torus and a ball of slivers.

use super::super::prelude::*;
use crate::metric::{NormalDeviation, normal_deviation};
use crate::surface::{Pattern, Surface, Tessellation, Torus};

/// How many times narrower every other row of the ball is than the next.
pub(super) const SLIVERS: f64 = 12.0;
/// Full scale of the maps of angles, in degrees.
const FULL_ANGLE: f64 = 5.0;

pub(super) fn torus(view: &View) -> Result<LitSurface> {
    let irregular = Tessellation { jitter: 0.5, ..Tessellation::default() };
    LitSurface::new(Torus::default().into(), Torus::default().into(), &irregular, view)
}

/// A ball in rows, every other one so many times narrower.
pub(super) fn ball(ratio: f64, view: &View) -> Result<LitSurface> {
    let (pattern, segments) = (Pattern::Slivers(ratio), [24, 24]);
    let tessellation = Tessellation { pattern, segments, ..Tessellation::default() };
    LitSurface::new(Sphere::default().into(), Sphere::default().into(), &tessellation, view)
}

/// Rms and maximum over the vertices of the torus, for two weights by figures of another program.
pub(super) fn measure_torus(torus: &LitSurface, out: &mut Recorder) {
    const KNOWN: [(Weight, [f64; 2]); 2] = [(Weight::Uniform, [1.644, 4.677]), (Weight::Max, [0.498, 2.054])];
    for (weight, name) in MEANS {
        out.set("weighting", out.text(name));
        let known = KNOWN.iter().find(|(known, _)| *known == weight).map(|(_, known)| known);
        let check = |figure: usize| known.map_or(Check::None, |known| Check::Near(known[figure], 5e-4));
        let errors = torus.at_vertices(weight);
        out.measure("torus-rms", "°", errors.rms, check(0));
        out.measure("torus-largest", "°", errors.max, check(1));
    }
}

pub(super) fn measure_ball(ball: &LitSurface, out: &mut Recorder) {
    for (weight, name) in MEANS {
        out.set("weighting", out.text(name));
        let check = if weight == ROUND { Check::Near(0.0, 1e-9) } else { Check::None };
        out.measure("ball", "°", ball.at_vertices(weight).rms, check);
    }
}

fn effect(name: &str, surface: &LitSurface, weight: Weight, factor: f64, out: &Recorder) -> Effect {
    let errors = [weight, ROUND].map(|weight| surface.at_vertices(weight).rms);
    out.effect(name, "°", errors, Threshold::half_step_of_tilt(), factor)
}

pub(super) fn show_ball(ball: &LitSurface, weight: Weight, out: &mut Recorder) -> Result<Effect> {
    let slivers = effect("slivers", ball, weight, 1000.0, out);
    let by_angle = effect("slivers", ball, FLAT, 1000.0, out);
    out.set("full-angle", FULL_ANGLE);
    out.bad("slivers", &slivers, ball.picture(weight)?);
    out.bad("slivers-angle", &by_angle, ball.picture(FLAT)?);
    out.cured("slivers-max", &by_angle, ball.picture(ROUND)?);
    out.difference("slivers-error", ball.error_map(weight, FULL_ANGLE)?, FULL_ANGLE, "°");
    Ok(slivers)
}

pub(super) fn show_torus(torus: &LitSurface, weight: Weight, out: &mut Recorder) -> Result<Effect> {
    // No weights are exact on a torus.
    let effect = effect("torus", torus, weight, 1.5, out);
    out.bad("torus", &effect, torus.picture(weight)?);
    out.cured("torus-max", &effect, torus.picture(ROUND)?);
    out.difference("torus-error", torus.error_map(weight, FULL_ANGLE)?, FULL_ANGLE, "°");
    out.truth("torus-itself", torus.truth(Show::Shaded)?);
    Ok(effect)
}

/// Errors on the ball by the thinness of its slivers.
pub(super) fn chart(view: &View, out: &mut Recorder) -> Result<()> {
    const RATIOS: [f64; 6] = [1.0, 2.0, 4.0, 8.0, 16.0, 32.0];
    let balls = RATIOS.map(|ratio| ball(ratio, view).map(|ball| (ratio, ball)));
    let balls = balls.into_iter().collect::<Result<Vec<_>>>()?;
    let mut curves = Vec::new();
    for (weight, name) in MEANS {
        let errors = balls.iter().map(|(ratio, ball)| [*ratio, ball.at_vertices(weight).rms]);
        curves.push(out.curve(name, Drawn::Line, errors.collect()));
    }
    out.chart("error-by-slivers", [Axis::Log, Axis::Linear], curves);
    Ok(())
}

pub(super) struct LitSurface {
    mesh: Mesh,
    primitive: Primitive,
    exponent: f64,
    camera: Camera,
    light: Light,
    size: u32,
}

pub(super) struct View {
    pub(super) size: u32,
    pub(super) light: Degrees,
    pub(super) exponent: f64,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Errors {
    pub(super) rms: f64,
    pub(super) max: f64,
}

impl LitSurface {
    pub(super) fn new(
        primitive: Primitive,
        surface: Surface,
        tessellation: &Tessellation,
        view: &View,
    ) -> Result<Self> {
        let mesh = surface.tessellate(tessellation)?;
        let &View { size, light, exponent } = view;
        let camera = camera(&[Object::new(Shape::Surface(primitive), shiny(SHARES, exponent))]);
        Ok(Self { light: light_from(&camera, light)?, mesh, primitive, exponent, camera, size })
    }

    /// Between averaged normals and the surface's own, at the vertices.
    pub(super) fn at_vertices(&self, weight: Weight) -> Errors {
        let field = smooth(&self.mesh, weight);
        let own = self.mesh.columns().normals.as_ref().map_or(&[][..], |own| &own.values);
        let off = |(normal, &vertex): (&DVec3, &u32)| {
            Some(Degrees::from(angle_between(*normal, *own.get(vertex as usize)?)).0)
        };
        let angles: Vec<f64> = field.normals.values.iter().zip(&field.entry_vertex).filter_map(off).collect();
        let squares: f64 = angles.iter().map(|angle| angle * angle).sum();
        let rms = (squares / angles.len().max(1) as f64).sqrt();
        Errors { rms, max: angles.into_iter().fold(0.0, f64::max) }
    }

    /// Under Phong's shading with averaged normals.
    pub(super) fn picture(&self, weight: Weight) -> Result<Image> {
        let field = smooth(&self.mesh, weight);
        self.draw(object(&self.mesh, &field, shiny(SHARES, self.exponent)), Show::Shaded)
    }

    /// With the surface's own normals.
    pub(super) fn truth(&self, show: Show) -> Result<Image> {
        self.draw(Object::new(Shape::Surface(self.primitive), shiny(SHARES, self.exponent)), show)
    }

    /// Between interpolated normals and the surface's own, pixel by pixel.
    pub(super) fn deviation(&self, weight: Weight) -> Result<NormalDeviation> {
        let field = smooth(&self.mesh, weight);
        let picture = self.draw(object(&self.mesh, &field, shiny(SHARES, self.exponent)), Show::Normals)?;
        Ok(normal_deviation(&picture, &self.truth(Show::Normals)?)?)
    }

    /// That as a map, yellow at so many degrees.
    pub(super) fn error_map(&self, weight: Weight, full: f64) -> Result<Image> {
        Ok(map([self.size; 2], &self.deviation(weight)?.angles, full))
    }

    fn draw(&self, object: Object, show: Show) -> Result<Image> {
        let settings = RenderSettings { show, ..settings([self.size; 2], Shading::Phong) };
        draw(vec![object], std::slice::from_ref(&self.light), self.camera, settings)
    }
}

/// Half diffuse, half highlight, which shows small angles.
const SHARES: [f64; 2] = [0.5, 0.5];

pub(super) const MEANS: [(Weight, &str); 6] = [
    (Weight::Uniform, "equal-weights"),
    (Weight::Area, "area-weights"),
    (Weight::Angle, "angle-weights"),
    (Weight::AngleArea, "angle-area-weights"),
    (Weight::Max, "max-weights"),
    (Weight::Edge, "edge-weights"),
];

/// The weights that do not change when flat faces are cut, and those that are exact on spheres.
pub(super) const FLAT: Weight = Weight::Angle;
pub(super) const ROUND: Weight = Weight::Max;

pub(super) fn name(weight: Weight, out: &Recorder) -> Value {
    let known = MEANS.iter().find(|(known, _)| *known == weight);
    known.map_or_else(|| weight.name().into(), |(_, key)| out.text(key).into())
}
