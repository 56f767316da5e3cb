//! Normals in few bits: octahedral codes, signed normalised integers, half and single precision.
//!
//! Angles between a normal and what its code gives back, in degrees, and the largest highlight exponents n that every
//! normal stays within half an 8-bit step for ([`largest_exponent`](crate::num::largest_exponent) of
//! [`Encoding::worst_angle`]):
//!
//! | encoding | bytes | mean | worst | diffuse | n, Blinn | n, Phong |
//! |---|---:|---:|---:|---|---:|---:|
//! | [`Octahedral`] 8 + 8 | 2 | 0.337 | 0.958 | no | – | – |
//! | 8 + 8, nearest | 2 | 0.315 | 0.638 | no | – | – |
//! | 10 + 10 | 3 | 0.0837 | 0.238 | no | – | – |
//! | 12 + 12 | 3 | 0.0209 | 0.0594 | yes | 9 | – |
//! | 12 + 12, nearest | 3 | 0.0195 | 0.0396 | yes | 21 | 4 |
//! | 16 + 16 | 4 | 0.00131 | 0.00371 | yes | 2487 | 621 |
//! | 16 + 16, nearest | 4 | 0.00122 | 0.00247 | yes | 5609 | 1402 |
//! | [`Snorm`] 3 × 8 | 3 | 0.170 | 0.391 | no | – | – |
//! | 3 × 10 | 4 | 0.0423 | 0.0971 | yes | 3 | – |
//! | 3 × 16 | 6 | 0.00066 | 0.00151 | yes | 14960 | 3739 |
//! | half × 3 | 6 | 0.0061 | 0.0239 | yes | 59 | 14 |
//! | single × 3 | 12 | 7.4e-7 | 2.92e-6 | yes | 10⁹ | 10⁹ |
//!
//! `crease trade` measures them again on two million directions. Octahedral codes are as good as three times as many
//! bits in a grid of components would be: they waste none on lengths (Cigolle, Donow, Evangelakos, Mara, McGuire & Meyer,
//! *A survey of efficient representations for independent unit vectors*, JCGT 3(2), 2014; Meyer, Süßmuth, Sußner,
//! Stamminger & Greiner, *On floating-point normal vectors*, EGSR 2010).
//!
//! ```
//! use crease::normals::encoding::Encoding;
//! use glam::DVec3;
//!
//! let normal = DVec3::new(0.6, 0.0, -0.8);
//! let packed = Encoding::OCTAHEDRAL_16.pack([normal]);
//! assert_eq!(packed.len(), 4);
//! let back: Vec<DVec3> = Encoding::OCTAHEDRAL_16.unpack(&packed).collect();
//! assert!(back[0].distance(normal) < 6.5e-5); // 0.0037°
//! ```

// Half precision.
mod float;
// The octahedron, unfolded to a square.
mod octahedral;
// Signed normalised integers.
mod snorm;
// Tests.
#[cfg(test)]
mod tests;

pub use float::{from_half, to_half};
pub use octahedral::{Octahedral, Rounding};
pub use snorm::Snorm;

use crate::num::{Degrees, Radians, UnitVec3};
use glam::DVec3;
use std::f64::consts::{FRAC_1_SQRT_2, SQRT_2};

/// A way to store a unit normal.
///
/// Codes without a direction (three zeros, or what is not a number) decode as +Z, and so does what had no direction
/// before it was encoded.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Encoding {
    /// Two signed integers: a place on the octahedron, unfolded to a square.
    Octahedral(Octahedral, Rounding),
    /// Three signed integers: each component by itself.
    Snorm(Snorm),
    /// Three numbers of IEEE 754 binary16.
    Half,
    /// Three numbers of IEEE 754 binary32.
    Single,
}

impl Encoding {
    /// Octahedral, 8 bits a component, rounded to the nearest.
    pub const OCTAHEDRAL_8: Encoding = Encoding::octahedral(8, Rounding::Plain);
    /// Octahedral, 16 bits a component, rounded to the nearest.
    pub const OCTAHEDRAL_16: Encoding = Encoding::octahedral(16, Rounding::Plain);

    /// All of them: octahedral of 8 to 16 bits with both kinds of rounding, then those of three components.
    pub const ALL: [Encoding; 23] = {
        let mut all = [Encoding::Single; 23];
        let mut at = 0;
        while at < 18 {
            let rounding = if at % 2 == 0 { Rounding::Plain } else { Rounding::Nearest };
            all[at] = Encoding::octahedral(8 + at as u32 / 2, rounding);
            at += 1;
        }
        all[18] = Encoding::Snorm(Snorm::EIGHT);
        all[19] = Encoding::Snorm(Snorm::TEN);
        all[20] = Encoding::Snorm(Snorm::SIXTEEN);
        all[21] = Encoding::Half;
        all
    };

    const fn octahedral(bits: u32, rounding: Rounding) -> Self {
        match Octahedral::new(bits) {
            Some(octahedral) => Encoding::Octahedral(octahedral, rounding),
            None => panic!("octahedral codes have 8 to 16 bits a component"),
        }
    }

    /// The name used in reports, such as `oct 8+8 nearest`.
    pub fn name(self) -> String {
        match self {
            Encoding::Octahedral(codec, rounding) => {
                let nearest = if rounding == Rounding::Nearest { " nearest" } else { "" };
                format!("oct {0}+{0}{nearest}", codec.bits())
            }
            Encoding::Snorm(codec) => format!("snorm 3×{}", codec.bits()),
            Encoding::Half => "half ×3".into(),
            Encoding::Single => "f32 ×3".into(),
        }
    }

    /// The number of bits of a code that are used.
    pub fn bits(self) -> u32 {
        match self {
            Encoding::Octahedral(codec, _) => 2 * codec.bits(),
            Encoding::Snorm(codec) => 3 * codec.bits(),
            Encoding::Half => 48,
            Encoding::Single => 96,
        }
    }

    /// Bytes of a packed code: [`bits`](Self::bits) and what fills the last byte; 4 for three times 10 bits.
    pub fn bytes(self) -> usize {
        self.bits().div_ceil(8) as usize
    }

    /// A bound on the angle between any normal and the decoded one. It determines the exponents of highlights that *every* normal
    /// is right for; the worst of a sample allows larger ones, the more so the smaller the sample.
    ///
    /// Octahedral codes: 0.958° for 8 bits, by the largest code for others; the worst are in the middle of an octant, where
    /// half a step each way moves the normal by 3/√2 of 1/(2^(bits−1) − 1) rad (0.957°; the rest allows for curvature). With
    /// [`Rounding::Nearest`], √2/(2^(bits−1) − 1) rad: in the middle of an octant codes form triangles whose circumradius
    /// approaches this value from below (0.63799° of 0.63802° for 8 bits). Integers: half a step in each component, at right
    /// angles to the normal at worst, asin(√3/2 / (2^(bits−1) − 1)). Half and single precision: three components from ½ on, each off by half a unit
    /// u of the last place there; of (±1, ±1, ±1)u at most (1 + √½)u is at right angles to such a normal, at
    /// (√½, ½, ½); a factor 1 + 2⁻¹⁰ allows for the length that rounding changes.
    pub fn worst_angle(self) -> Degrees {
        let radians = match self {
            Encoding::Octahedral(codec, Rounding::Nearest) => SQRT_2 / largest_code(codec.bits()),
            Encoding::Octahedral(codec, Rounding::Plain) => {
                return Degrees(0.958 * 127.0 / largest_code(codec.bits()));
            }
            Encoding::Snorm(codec) => libm::asin(0.5 * 3.0_f64.sqrt() / largest_code(codec.bits())),
            Encoding::Half => of_floats(-12),
            Encoding::Single => of_floats(-25),
        };
        Degrees::from(Radians(radians))
    }

    /// The code of a normal, in the lowest [`bits`](Self::bits): the first component lowest, negative numbers in two's
    /// complement.
    pub fn encode(self, normal: DVec3) -> u128 {
        match self {
            Encoding::Octahedral(codec, rounding) => join(codec.encode(normal, rounding), codec.bits()),
            Encoding::Snorm(codec) => join(codec.encode(normal), codec.bits()),
            Encoding::Half => join(normal.to_array().map(|x| i32::from(to_half(x))), 16),
            Encoding::Single => join(normal.to_array().map(|x| (x as f32).to_bits() as i32), 32),
        }
    }

    /// The unit normal of a code. Bits above [`bits`](Self::bits) are ignored.
    pub fn decode(self, code: u128) -> DVec3 {
        match self {
            Encoding::Octahedral(codec, _) => codec.decode(split(code, codec.bits())),
            Encoding::Snorm(codec) => codec.decode(split(code, codec.bits())),
            Encoding::Half => unit(split(code, 16).map(|bits| from_half(bits as u16)).into()),
            Encoding::Single => {
                unit(split(code, 32).map(|bits| f64::from(f32::from_bits(bits as u32))).into())
            }
        }
    }

    /// The codes of normals one after the other, [`bytes`](Self::bytes) each, the lowest byte first.
    pub fn pack(self, normals: impl IntoIterator<Item = DVec3>) -> Vec<u8> {
        let normals = normals.into_iter();
        let mut packed = Vec::with_capacity(normals.size_hint().0 * self.bytes());
        for normal in normals {
            packed.extend_from_slice(&self.encode(normal).to_le_bytes()[..self.bytes()]);
        }
        packed
    }

    /// The normals of packed codes. Bytes at the end that are no whole code are omitted.
    pub fn unpack(self, packed: &[u8]) -> impl ExactSizeIterator<Item = DVec3> {
        packed.chunks_exact(self.bytes()).map(move |bytes| {
            let mut code = [0; 16];
            code[..bytes.len()].copy_from_slice(bytes);
            self.decode(u128::from_le_bytes(code))
        })
    }
}

/// The worst angle of three numbers whose components from ½ to 1 are off by 2 to a power at most.
fn of_floats(power: i32) -> f64 {
    (1.0 + FRAC_1_SQRT_2) * (1.0 + 1.0 / 1024.0) * libm::ldexp(1.0, power)
}

/// Components side by side, the first one lowest.
#[inline]
fn join<const N: usize>(components: [i32; N], bits: u32) -> u128 {
    let mask = u32::MAX >> (32 - bits);
    let place = |(at, component): (usize, i32)| u128::from(component as u32 & mask) << (at as u32 * bits);
    components.into_iter().enumerate().map(place).fold(0, |code, part| code | part)
}

/// The signed components that were joined.
#[inline]
fn split<const N: usize>(code: u128, bits: u32) -> [i32; N] {
    let unused = 32 - bits;
    std::array::from_fn(|at| ((code >> (at as u32 * bits)) as i32) << unused >> unused)
}

/// The largest code of signed normalised integers: 2^(bits−1) − 1.
#[inline]
fn largest_code(bits: u32) -> f64 {
    f64::from((1_i32 << (bits - 1)) - 1)
}

/// Made unit; +Z without direction.
#[inline]
fn unit(v: DVec3) -> DVec3 {
    UnitVec3::new(v).map_or(DVec3::Z, UnitVec3::get)
}
