//! Angles that carry their unit.

use glam::DVec3;

/// An angle in degrees: the unit of the command line and of reports.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd, serde::Serialize)]
pub struct Degrees(pub f64);

/// An angle in radians: the unit inside.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct Radians(pub f64);

impl From<Degrees> for Radians {
    fn from(angle: Degrees) -> Self {
        Radians(angle.0.to_radians())
    }
}

impl From<Radians> for Degrees {
    fn from(angle: Radians) -> Self {
        Degrees(angle.0.to_degrees())
    }
}

impl Degrees {
    /// The shortest decimal number of degrees that is this angle, as it may have been typed: 30, not 29.999999999999996.
    pub fn shortest(angle: Radians) -> Self {
        let plain = Degrees::from(angle);
        let rounded = (1..=15).map(|digits| {
            let text = format!("{:.*e}", digits - 1, plain.0);
            Degrees(text.parse().unwrap_or(plain.0))
        });
        let mut same = rounded.filter(|&degrees| Radians::from(degrees) == angle);
        same.next().unwrap_or(plain)
    }
}

/// The angle between two vectors by atan2(|a×b|, a·b): exact to the last digits for angles of any size, where an arc cosine
/// has no accuracy below 1.5·10⁻⁸ rad.
pub fn angle_between(a: DVec3, b: DVec3) -> Radians {
    Radians(libm::atan2(a.cross(b).length(), a.dot(b)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn typed_degrees_come_back() {
        for typed in [30.0, 0.001, 25.0, 179.999, 1.0 / 3.0, 1e-30, 0.0, 57.295_779_513_082_32] {
            assert_eq!(Degrees::shortest(Degrees(typed).into()), Degrees(typed));
        }
        assert_ne!(Degrees::from(Radians::from(Degrees(30.0))), Degrees(30.0));
    }

    #[test]
    fn small_angles_are_seen() {
        let tilted = DVec3::new(1.0, 1e-15, 0.0);
        assert_eq!(angle_between(DVec3::X, tilted), Radians(1e-15));
        assert_eq!(angle_between(DVec3::X, DVec3::NEG_X), Radians(std::f64::consts::PI));
    }
}
