//! A part of a sphere with normals of different precision, how far they are from the true ones, and its highlight.

use super::super::prelude::*;
use crate::num::steepest_slope;
use glam::Vec3;

/// The window's side: a close look at the highlight on a sphere of radius 1.
const WINDOW: f64 = 0.25;
/// The part of the sphere that is modelled: so many radians to all sides of +z, more than the window shows.
pub(super) const REACH: f64 = 0.16;

/// A close look at the middle of the sphere, light and viewer in front.
pub(super) fn draw_close_up(object: &Object, shading: Shading, show: Show, size: u32) -> Result<Image> {
    // A little off the axis, so that the highlight does not sit on a vertex.
    let light = far_light(DVec3::new(0.05, 0.03, 1.0));
    let settings = RenderSettings { show, ..settings([size; 2], shading) };
    draw(vec![object.clone()], &[light], front(WINDOW), settings)
}

impl TriangleMesh {
    /// A part of the unit sphere about +z, cut into so many squares each way, with its own normals.
    pub(super) fn cap(cells: u32) -> Self {
        Self::grid([cells; 2], Diagonal::Rising, |u, v| {
            let (longitude, latitude) = ((2.0 * u - 1.0) * REACH, (2.0 * v - 1.0) * REACH);
            let (up, ring) = libm::sincos(latitude);
            let (right, ahead) = libm::sincos(longitude);
            let place = DVec3::new(ring * right, up, ring * ahead);
            (place, place)
        })
    }

    pub(super) fn with_normals(&self, change: impl Fn(DVec3) -> DVec3) -> Self {
        let changed = |normal: &[f32; 3]| change(Vec3::from(*normal).as_dvec3()).as_vec3().to_array();
        Self { normals: self.normals.iter().map(changed).collect(), ..self.clone() }
    }

    /// The mesh with positions that were stored in single precision far from the origin, and normals computed from them.
    pub(super) fn far_away(&self, away: f64) -> Self {
        let offset = DVec3::new(away, 0.9 * away, 0.8 * away);
        let stored = |p: &[f32; 3]| (Vec3::from(*p).as_dvec3() + offset).as_vec3().as_dvec3() - offset;
        let positions: Vec<DVec3> = self.positions.iter().map(stored).collect();
        let mut sums = vec![DVec3::ZERO; positions.len()];
        for triangle in &self.triangles {
            let [a, b, c] = triangle.map(|vertex| positions[vertex as usize]);
            let area = (b - a).cross(c - a);
            triangle.iter().for_each(|&vertex| sums[vertex as usize] += area);
        }
        let own = self.normals.iter().map(|n| Vec3::from(*n).as_dvec3());
        let normals: Vec<DVec3> =
            sums.iter().zip(own).map(|(sum, own)| sum.try_normalize().unwrap_or(own)).collect();
        Self::new(&positions, self.triangles.clone(), &normals)
    }

    /// Mean and largest angle to the normals of another mesh, at vertices, in degrees.
    pub(super) fn angles(&self, other: &Self) -> [f64; 2] {
        let pairs = self.normals.iter().zip(&other.normals);
        let angles: Vec<f64> =
            pairs.map(|(a, b)| angle(Vec3::from(*a).as_dvec3(), Vec3::from(*b).as_dvec3())).collect();
        [angles.iter().sum::<f64>() / angles.len() as f64, angles.iter().copied().fold(0.0, f64::max)]
    }

    /// The root of the mean square of the angles to the normals of the faces of another mesh, in degrees.
    pub(super) fn face_angles(&self, other: &Self) -> f64 {
        let pairs = self.face_normals.iter().zip(&other.face_normals);
        let squares: f64 = pairs
            .map(|(a, b)| angle(Vec3::from(*a).as_dvec3(), Vec3::from(*b).as_dvec3()))
            .map(|angle| angle * angle)
            .sum();
        (squares / self.face_normals.len() as f64).sqrt()
    }

    /// The same by theory for positions rounded at this distance: a normal leans by the gradient Σ e_k ∇λ_k of independent errors of
    /// the variance u²/12 with |∇λ_k| = side_k/(2A).
    pub(super) fn rounded_faces(&self, away: f64) -> f64 {
        let step = f64::from((away as f32).next_up()) - f64::from(away as f32);
        let square = |triangle: &[u32; 3]| {
            let [a, b, c] = triangle.map(|vertex| Vec3::from(self.positions[vertex as usize]).as_dvec3());
            let sides = (b - a).length_squared() + (c - b).length_squared() + (a - c).length_squared();
            step * step / 12.0 * sides / (b - a).cross(c - a).length_squared()
        };
        let sum: f64 = self.triangles.iter().map(square).sum();
        Degrees::from(Radians((sum / self.triangles.len() as f64).sqrt())).0
    }
}

/// The shares of light that the material scatters and mirrors.
pub(super) const DIFFUSE: f64 = 0.3;
pub(super) const SPECULAR: f64 = 0.7;

pub(super) fn material(exponent: f64) -> Material {
    shiny([DIFFUSE, SPECULAR], exponent)
}

/// The error of a normal, in degrees, at which this highlight changes by half a step of 8 bits where it is steepest.
pub(super) fn needed(exponent: f64) -> f64 {
    Degrees::from(Radians(Threshold::HALF_STEP / (SPECULAR * steepest_slope(exponent)))).0
}

/// The largest change of the light for a normal that is off by so many degrees: Δ_d ≤ δ and Δ_s ≤ M(n) δ.
pub(super) fn bound(exponent: f64, degrees: f64) -> f64 {
    (DIFFUSE + SPECULAR * steepest_slope(exponent)) * Radians::from(Degrees(degrees)).0
}

pub(super) fn angle(a: DVec3, b: DVec3) -> f64 {
    Degrees::from(Radians(libm::atan2(a.cross(b).length(), a.dot(b)))).0
}
