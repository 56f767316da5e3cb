//! A cylinder in facets, luminance across it, and its jumps at an edge in closed form.

use super::super::prelude::*;
use crate::surface::Cylinder;
use std::f64::consts::{PI, TAU};

/// The window's side; the cylinder has the radius 1.
pub(super) const WINDOW: f64 = 2.2;
/// Pixels of a scanline that is measured.
const LINE: u32 = 16_384;
/// Edges farther round are seen so much from the side that their facets have few pixels.
const FARTHEST: Degrees = Degrees(60.0);
/// The part of a facet that slopes are taken over, in radians. Over a larger part Phong's luminance is no polynomial of
/// fourth degree; over a smaller one roundings are too large.
const SPAN: f64 = 0.1;

/// A prism with N sides of radius 1 about the y axis, with the cylinder's own normals.
pub(super) struct Tube {
    mesh: Mesh,
    normals: NormalField,
    pub(super) segments: u32,
    /// The angle of one of its edges, from the viewer to the right.
    start: f64,
}

impl Tube {
    pub(super) fn new(segments: u32, start: f64) -> Result<Self> {
        let angle = |k: u32| start + TAU * f64::from(k) / f64::from(segments);
        let ring =
            |y: f64| (0..segments).map(move |k| DVec3::new(libm::sin(angle(k)), y, libm::cos(angle(k))));
        let mut faces = Faces::new();
        for (k, next) in (0..segments).map(|k| (k, (k + 1) % segments)) {
            faces.push(&[k, next, next + segments, k + segments]);
        }
        let mesh = build(ring(-0.8).chain(ring(0.8)).collect(), faces)?;
        // Between two facets alike, the mean of their normals is the cylinder's.
        let normals = smooth(&mesh, Weight::Uniform);
        Ok(Self { mesh, normals, segments, start })
    }

    /// With an edge where the light ends: a facet across that border would have two bands under Gouraud's shading.
    pub(super) fn under(light: Degrees, segments: u32) -> Result<Self> {
        Self::new(segments, Radians::from(light).0 - (PI / 2.0).copysign(light.0))
    }

    pub(super) fn delta(&self) -> f64 {
        TAU / f64::from(self.segments)
    }

    fn object(&self) -> Object<'_> {
        let cylinder = Cylinder::new(1.0, 1.6).ok().map(Primitive::from);
        Object { surface: cylinder, ..object(&self.mesh, &self.normals, chalk()) }
    }

    pub(super) fn draw(&self, size: [u32; 2], light: Degrees, shading: Shading) -> Result<Image> {
        let mut object = self.object();
        if let (Shading::Exact, Some(cylinder)) = (shading, object.surface) {
            object.shape = Shape::Surface(cylinder);
        }
        let camera = front(WINDOW * f64::from(size[1]) / f64::from(size[0]));
        draw(vec![object], &[light_at(light)], camera, settings(size, shading))
    }

    pub(super) fn profile(&self, light: Degrees, shading: Shading) -> Result<Profile> {
        let image = self.draw([LINE, 1], light, shading)?;
        Ok(Profile { values: luminance(&image) })
    }

    /// The edges up to 60° round both of whose facets are seen and lit all over.
    pub(super) fn edges(&self, light: Degrees) -> impl Iterator<Item = f64> {
        let (Radians(light), Radians(farthest)) = (light.into(), FARTHEST.into());
        let (start, delta) = (self.start, self.delta());
        let turned = move |k: u32| {
            let angle = start + f64::from(k) * delta;
            angle - TAU * libm::round(angle / TAU)
        };
        let is_lit = move |theta: &f64| {
            // A rounding's room, for edges that stand at the ends of the ranges.
            let is_seen = theta.abs() <= farthest + 1e-9 && theta.abs() + 0.5 * delta < PI / 2.0 - 1e-9;
            is_seen && (theta - light).abs() + delta < PI / 2.0 + 1e-9
        };
        (0..self.segments).map(turned).filter(is_lit)
    }

    /// The range across the picture, in radii, of the facets next to those edges, without a little at both ends; everything if there
    /// is no such edge.
    pub(super) fn near_edges(&self, light: Degrees) -> (f64, f64) {
        let edges: Vec<f64> = self.edges(light).collect();
        let from = edges.iter().copied().fold(f64::INFINITY, f64::min) - self.delta();
        let to = edges.iter().copied().fold(f64::NEG_INFINITY, f64::max) + self.delta();
        match edges.is_empty() {
            true => (-1.0, 1.0),
            false => (libm::sin(from) + 0.01, libm::sin(to.min(PI / 2.0)) - 0.01),
        }
    }

    /// The width across the picture of the narrowest facet next to one of those edges, in radii.
    pub(super) fn narrowest(&self) -> f64 {
        let Radians(farthest) = FARTHEST.into();
        libm::sin((farthest + self.delta()).min(PI / 2.0)) - libm::sin(farthest)
    }

    /// The places of those edges across the picture, in radii, each with the slope's jump there.
    pub(super) fn jumps(&self, light: Degrees, shading: Shading) -> Result<Vec<[f64; 2]>> {
        let line = self.profile(light, shading)?;
        let jump = |theta| [libm::sin(theta), line.slope_jump(self, theta).0.abs()];
        Ok(self.edges(light).map(jump).collect())
    }

    pub(super) fn largest(&self, light: Degrees, jump: impl Fn(f64) -> (f64, f64)) -> Found {
        let found = self.edges(light).map(|theta| {
            let (measured, law) = jump(theta);
            Found { theta, measured, law }
        });
        found.max_by(|a, b| a.measured.abs().total_cmp(&b.measured.abs())).unwrap_or_default()
    }
}

/// Whether a place across the picture, in radii, is drawn in charts.
pub(super) fn is_drawn(x: f64) -> bool {
    x.abs() < 1.03 * libm::sin(Radians::from(FARTHEST).0)
}

/// A jump as measured and by its closed form.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Found {
    pub(super) theta: f64,
    pub(super) measured: f64,
    pub(super) law: f64,
}

/// Luminance along a scanline of the window.
pub(super) struct Profile {
    values: Vec<f64>,
}

impl Profile {
    /// Where a pixel's centre is.
    pub(super) fn x(pixel: usize) -> f64 {
        ((pixel as f64 + 0.5) / f64::from(LINE) - 0.5) * WINDOW
    }

    fn pixel(x: f64) -> f64 {
        (x / WINDOW + 0.5) * f64::from(LINE) - 0.5
    }

    /// The jump of the value itself at an edge of a tube: of the middles of both facets.
    pub(super) fn step(&self, tube: &Tube, theta: f64) -> f64 {
        let value = |side: f64| {
            let middle = 0.5 * (libm::sin(theta) + libm::sin(theta + side * tube.delta()));
            self.values[Self::pixel(middle) as usize]
        };
        (value(1.0) - value(-1.0)).abs()
    }

    /// The slope to the right of an edge of a tube less that to the left, and how far roundings may move it.
    pub(super) fn slope_jump(&self, tube: &Tube, theta: f64) -> (f64, f64) {
        let [[right, by_right], [left, by_left]] = [1.0, -1.0].map(|side| self.slope(tube, theta, side));
        (right - left, by_right + by_left)
    }

    /// The slope next to an edge from five samples, and how far roundings may move it.
    fn slope(&self, tube: &Tube, theta: f64, side: f64) -> [f64; 2] {
        let (edge, next) = (libm::sin(theta), libm::sin(theta + side * tube.delta()));
        let reach = (SPAN / tube.delta()).min(0.9) * (next - edge);
        let pixels =
            [0.2, 0.4, 0.6, 0.8, 1.0].map(|share| Self::pixel(edge + share * reach).round() as usize);
        let weights = slope_weights(edge, &pixels.map(Self::x));
        let slope: f64 =
            pixels.iter().zip(&weights).map(|(&pixel, weight)| weight * self.values[pixel]).sum();
        // Three standard deviations of roundings of samples in single precision. Vertices snap to 256ths of pixels.
        let of_samples =
            f64::from(f32::EPSILON) * weights.iter().map(|weight| weight * weight).sum::<f64>().sqrt();
        let snapped = WINDOW / f64::from(LINE) / 256.0;
        [slope, of_samples + slope.abs() * snapped / (next - edge).abs()]
    }

    /// Every so many pixels up to a little more than 60° round, as points of a chart.
    pub(super) fn points(&self, every: usize, value: impl Fn(&[f64], usize) -> f64) -> Vec<[f64; 2]> {
        let inside = |&pixel: &usize| is_drawn(Self::x(pixel));
        let pixels = (0..self.values.len()).step_by(every).filter(inside);
        pixels.map(|pixel| [Self::x(pixel), value(&self.values, pixel)]).collect()
    }
}

/// What each of some values counts in the slope at a place of the polynomial through them.
pub(super) fn slope_weights(at: f64, nodes: &[f64]) -> Vec<f64> {
    let weight = |i: usize| {
        let others = || (0..nodes.len()).filter(move |&j| j != i);
        let below: f64 = others().map(|j| nodes[i] - nodes[j]).product();
        let above =
            |left_out: usize| others().filter(|&j| j != left_out).map(|j| at - nodes[j]).product::<f64>();
        others().map(above).sum::<f64>() / below
    };
    (0..nodes.len()).map(weight).collect()
}

pub(super) type Law = fn(f64, Degrees, f64) -> f64;

pub(super) fn flat_step(theta: f64, light: Degrees, delta: f64) -> f64 {
    2.0 * libm::sin(theta - Radians::from(light).0).abs() * libm::sin(delta / 2.0)
}

pub(super) fn gouraud_jump(theta: f64, light: Degrees, delta: f64) -> f64 {
    -libm::cos(Radians::from(light).0) * (libm::tan(theta + delta / 2.0) - libm::tan(theta - delta / 2.0))
}

pub(super) fn phong_jump(theta: f64, light: Degrees, delta: f64) -> f64 {
    let bend = libm::tan(theta + delta / 2.0) - libm::tan(theta - delta / 2.0);
    -libm::sin(theta - Radians::from(light).0) * libm::sin(theta) * bend
}
