//! The octahedron, unfolded to a square.

use crate::normals::encoding::{largest_code, unit};
use glam::{DVec2, DVec3};

/// How a place between codes becomes a code.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Rounding {
    /// Each component to the nearest: fast.
    #[default]
    Plain,
    /// Among the four codes around, the one whose direction is nearest (Cigolle et al. 2014, "precise"): about four times
    /// the work, two thirds of the worst angle.
    Nearest,
}

/// Octahedral codes of 8 to 16 bits a component, as signed normalised integers.
///
/// The normal is divided by |x| + |y| + |z|, which puts it on the octahedron; the lower half is folded out over the upper
/// one's diagonals, and (x, y) is rounded to multiples of 1/(2^(bits−1) − 1). 0 counts as positive where the lower half is
/// folded, so −Z is (1, 1) and decodes exactly from any of the square's corners. The six axes are exact; so, with `Nearest`
/// and `Plain` alike, are directions that have a code. (Meyer et al. 2010; Cigolle et al. 2014.)
///
/// Worst angle, in degrees, of any unit normal: 0.958 for 8 bits (0.638 with [`Rounding::Nearest`]), half of it with each
/// further bit, 0.00372 (0.00247) for 16.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Octahedral {
    bits: u32,
}

impl Octahedral {
    /// Codes with this many bits a component; `None` unless there are 8 to 16.
    pub const fn new(bits: u32) -> Option<Self> {
        if matches!(bits, 8..=16) { Some(Self { bits }) } else { None }
    }

    /// Bits of each component.
    pub const fn bits(self) -> u32 {
        self.bits
    }

    /// The code of a direction of any length. Zero and what is not finite have the code of +Z.
    #[inline]
    pub fn encode(self, direction: DVec3, rounding: Rounding) -> [i32; 2] {
        let place = unfold(direction) * largest_code(self.bits);
        match rounding {
            Rounding::Plain => place.round().to_array().map(|x| x as i32),
            Rounding::Nearest => self.nearest(place, unit(direction)),
        }
    }

    /// Of the four codes around a place, the one that is nearest to the direction; of equally near ones the first.
    fn nearest(self, place: DVec2, direction: DVec3) -> [i32; 2] {
        let low = place.floor();
        let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]].map(|step| {
            // Codes end at the square's sides; beyond them the surface continues elsewhere, and not nearer.
            let corner = (low + DVec2::from(step)).min(DVec2::splat(largest_code(self.bits)));
            corner.to_array().map(|x| x as i32)
        });
        let distance = |code: [i32; 2]| self.decode(code).distance_squared(direction);
        let first = (corners[0], distance(corners[0]));
        let nearer = |best: ([i32; 2], f64), &code: &[i32; 2]| {
            let distance = distance(code);
            if distance < best.1 { (code, distance) } else { best }
        };
        corners[1..].iter().fold(first, nearer).0
    }

    /// The unit normal of a code. Components are clamped to the square: −2^(bits−1) counts as −1.
    #[inline]
    pub fn decode(self, code: [i32; 2]) -> DVec3 {
        let [x, y] = code.map(|component| (f64::from(component) / largest_code(self.bits)).clamp(-1.0, 1.0));
        let z = 1.0 - x.abs() - y.abs();
        // Below the square's diagonals: folded back.
        let over = (-z).max(0.0);
        let fold = |x: f64| if x >= 0.0 { x - over } else { x + over };
        unit(DVec3::new(fold(x), fold(y), z))
    }
}

/// A direction on the square from −1 to 1.
#[inline]
fn unfold(direction: DVec3) -> DVec2 {
    // Scaled first: the sum of three components may leave the range that each of them is in.
    let v = direction / direction.abs().max_element();
    let v = v / (v.x.abs() + v.y.abs() + v.z.abs());
    if !v.is_finite() {
        return DVec2::ZERO;
    }
    let signed = |x: f64, magnitude: f64| if x >= 0.0 { magnitude } else { -magnitude };
    match v.z < 0.0 {
        false => DVec2::new(v.x, v.y),
        true => DVec2::new(signed(v.x, 1.0 - v.y.abs()), signed(v.y, 1.0 - v.x.abs())),
    }
}
