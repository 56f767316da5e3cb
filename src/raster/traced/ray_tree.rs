//! The tree of rays behind one sample of a traced picture.

use serde::Serialize;

/// A ray with what it meets. Positions and lengths are those of the scene.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct RayNode {
    /// `camera`, `reflected` or `refracted`.
    pub kind: &'static str,
    /// Its share of the colour of the point where it starts: 1 for the ray of the camera.
    pub share: [f64; 3],
    /// Where it starts.
    pub origin: [f64; 3],
    /// A unit vector.
    pub direction: [f64; 3],
    /// The share of light that absorption leaves along it (Beer's law).
    pub transmittance: [f64; 3],
    /// What it meets; the background if absent.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hit: Option<RayHit>,
    /// The linear light that arrives at its start.
    pub colour: [f64; 3],
}

/// The point that a ray meets. Objects, faces and lights count from 0.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct RayHit {
    /// The number of the object.
    pub object: usize,
    /// The face; absent on an analytic surface.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub face: Option<u32>,
    /// Whether the front is met.
    pub front: bool,
    /// The point.
    pub position: [f64; 3],
    /// The length of the ray.
    pub distance: f64,
    /// The unit normal that light, reflection and refraction use, on the side of the ray.
    pub normal: [f64; 3],
    /// The local light: Phong's model with shadows. None inside a transmitting body.
    pub local: [f64; 3],
    /// The share of each light that reaches the point, for the lights that its colour asks for.
    pub shadows: Vec<ShadowTest>,
    /// The refractive indices on both sides of a transmitting surface, that of the ray first.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub indices: Option<[f64; 2]>,
    /// Fresnel's share of reflected light on a transmitting surface: 1 in total reflection.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fresnel: Option<f64>,
    /// The rays that go on from here.
    pub rays: Vec<RayNode>,
    /// The share of light that depth or weight of rays cut off here, relative to the sample.
    pub cut: f64,
}

/// A shadow test.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct ShadowTest {
    /// The number of the light.
    pub light: usize,
    /// The share of it that reaches the point.
    pub visible: [f64; 3],
}
