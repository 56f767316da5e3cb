//! Lights as shadow rays see them, in the frame of the shaders.

use crate::shade::{AreaShape, Frame, Light};
use glam::DVec3;
use std::f64::consts::TAU;

/// Where a light is.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Lamp {
    /// Ambient light, which casts no shadow.
    Everywhere,
    /// The unit vector to a light infinitely far away.
    Far(DVec3),
    /// A point or a spot.
    Point(DVec3),
    /// A surface: its centre, two vectors along it, the unit normal of the side that it shines to, and whether it is a disc.
    Area { centre: DVec3, across: [DVec3; 2], normal: DVec3, is_disc: bool },
}

impl Lamp {
    pub(crate) fn new(light: &Light, frame: Frame) -> Self {
        match *light {
            Light::Ambient { .. } => Self::Everywhere,
            Light::Directional { towards, .. } => Self::Far(crate::num::direction(towards).0),
            Light::Point { position, .. } | Light::Spot { position, .. } => {
                Self::Point(frame.to_local(position))
            }
            Light::Area { shape: AreaShape::Rectangle { centre, u, v }, .. } => {
                let across = [u, v].map(|side| side / frame.unit);
                let normal = crate::num::direction(across[0].cross(across[1])).0;
                Self::Area { centre: frame.to_local(centre), across, normal, is_disc: false }
            }
            Light::Area { shape: AreaShape::Disc { centre, normal, radius }, .. } => {
                let normal = crate::num::direction(normal).0;
                let (u, v) = normal.any_orthonormal_pair();
                let across = [u, v].map(|axis| axis * (radius / frame.unit));
                Self::Area { centre: frame.to_local(centre), across, normal, is_disc: true }
            }
        }
    }
}

/// A point of an area light of equal density, for a number in the unit square.
pub(crate) fn area_point(centre: DVec3, across: [DVec3; 2], is_disc: bool, [a, b]: [f64; 2]) -> DVec3 {
    if is_disc {
        let (sin, cos) = libm::sincos(TAU * b);
        return centre + (across[0] * cos + across[1] * sin) * a.sqrt();
    }
    centre + across[0] * (2.0 * a - 1.0) + across[1] * (2.0 * b - 1.0)
}

/// Point `number` of `count` of Hammersley's set in the unit square, moved cyclically: the same set for every point of a scene
/// would show as bands.
pub(crate) fn hammersley(number: u32, count: u32, moved: [f64; 2]) -> [f64; 2] {
    let along = (f64::from(number) + 0.5) / f64::from(count);
    let inverse = f64::from(number.reverse_bits()) / 4_294_967_296.0;
    [along + moved[0], inverse + moved[1]].map(|x| if x >= 1.0 { x - 1.0 } else { x })
}

/// How far a pixel moves the sets of its shadow rays: Martin Roberts's additive recurrence R2 of a number that mixes column
/// and row, so that neighbours differ.
pub(crate) fn move_of_pixel([x, y]: [u32; 2]) -> [f64; 2] {
    let mixed = (x.wrapping_mul(0x9e37_79b1) ^ y.wrapping_mul(0x85eb_ca77)).wrapping_mul(0xc2b2_ae3d);
    let mixed = mixed ^ mixed >> 15;
    [0.754_877_666_246_692_7, 0.569_840_290_998_053_2].map(|step| (f64::from(mixed) * step).fract())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn samples_cover_a_light_evenly() {
        let across = [DVec3::X, DVec3::Y];
        for is_disc in [false, true] {
            let mut quarters = [0; 4];
            let mut inner = 0;
            for number in 0..256 {
                let place = hammersley(number, 256, move_of_pixel([7, 9]));
                assert!(place.iter().all(|x| (0.0..1.0).contains(x)));
                let point = area_point(DVec3::ZERO, across, is_disc, place);
                assert!(point.abs().max_element() <= 1.0 && (!is_disc || point.length() <= 1.0));
                quarters[usize::from(point.x > 0.0) + 2 * usize::from(point.y > 0.0)] += 1;
                inner += usize::from(point.length_squared() < 0.5);
            }
            assert!(quarters.iter().all(|count| (60..=68).contains(count)), "{quarters:?}");
            // Half of a disc's area; π/8 of the square's.
            let share = if is_disc { 128 } else { 101 };
            // A circle in a square cuts the strips of the pattern at all angles: measured 7. The radius of a disc is one coordinate.
            let most = if is_disc { 2 } else { 8 };
            assert!((share - most..=share + most).contains(&inner), "{inner}");
        }
    }
}
