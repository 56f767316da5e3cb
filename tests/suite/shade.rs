//! Light on a point, through the public interface.

mod errors;
mod extremes;
mod formulas;
mod guards;
mod rows;
mod terminator;

use crate::random::Random;
use crease::num::LinearRgb;
use crease::shade::{Light, Material, Probe, ShadeSettings, Shader, SurfacePoint};
use glam::DVec3;

/// The colour of a point. Asserts that points and rows in both precisions agree up to rounding, and that a probe reports the same
/// sum.
pub fn lit(
    lights: &[Light],
    material: &Material,
    settings: &ShadeSettings,
    position: DVec3,
    normal: DVec3,
) -> [f64; 3] {
    let point = SurfacePoint { position: position.to_array(), normal: normal.to_array() };
    let colour = Shader::<f64>::new(lights, material, settings).unwrap().shade(&point).unwrap();
    assert_eq!(Probe::new(lights, material, settings).unwrap().explain(&point).sum, colour);
    let single =
        SurfacePoint { position: point.position.map(|x| x as f32), normal: point.normal.map(|x| x as f32) };
    let single = Shader::<f32>::new(lights, material, settings).unwrap().shade(&single).unwrap();
    for (single, double) in single.into_iter().zip(colour) {
        // Some tens of roundings, times the exponents of up to 4 that the worked examples have.
        let tolerance = 1e-5 * double.abs().max(1.0);
        assert!(
            (f64::from(single) - double).abs() < tolerance,
            "{single} in single precision, {double} in double"
        );
    }
    colour
}

/// A direction, uniform on the sphere.
pub fn direction(random: &mut Random) -> DVec3 {
    loop {
        let v = DVec3::from_array([(); 3].map(|()| uniform(random) * 2.0 - 1.0));
        if (0.01..1.0).contains(&v.length_squared()) {
            return v.normalize();
        }
    }
}

/// Uniform in [0, 1).
pub fn uniform(random: &mut Random) -> f64 {
    (random.next() >> 11) as f64 / (1_u64 << 53) as f64
}

/// White ambient light, and white light from one side.
pub fn ambient(value: f64) -> Light {
    Light::Ambient { colour: LinearRgb::grey(value) }
}

/// White light from far away.
pub fn sun(x: f64, y: f64, z: f64) -> Light {
    Light::Directional { towards: DVec3::new(x, y, z), colour: LinearRgb::WHITE }
}
