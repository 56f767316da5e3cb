//! Normals in few bits, where the octahedron has its corners and edges.

use super::prelude::*;
use crate::normals::encoding::{Encoding, Octahedral, Rounding, Snorm, from_half, to_half};
use crate::trade::exact;

const DIRECTIONS: usize = 600;

fn encodings() -> [Encoding; 9] {
    let octahedral =
        |bits, rounding| Encoding::Octahedral(Octahedral::new(bits).expect("8 to 16 bits"), rounding);
    [
        octahedral(8, Rounding::Plain),
        octahedral(8, Rounding::Nearest),
        octahedral(10, Rounding::Plain),
        octahedral(12, Rounding::Plain),
        octahedral(16, Rounding::Plain),
        Encoding::Snorm(Snorm::EIGHT),
        Encoding::Snorm(Snorm::TEN),
        Encoding::Snorm(Snorm::SIXTEEN),
        Encoding::Half,
    ]
}

/// How far from a pole or an edge: at it, next to it in `f64`, a rounding of `f32` away, and up to a step of 8 bits.
const DISTANCES: [f64; 7] = [0.0, 1e-300, 1e-16, 1e-8, 1e-5, 1e-3, 1e-2];

pub(super) fn cases() -> Vec<StressCase> {
    encodings().into_iter().flat_map(|encoding| [true, false].map(|poles| case(encoding, poles))).collect()
}

fn case(encoding: Encoding, poles: bool) -> StressCase {
    let texts = match (encoding, poles) {
        (Encoding::Octahedral(..), true) => "octahedral-poles",
        (Encoding::Octahedral(..), false) => "octahedral-edges",
        (Encoding::Snorm(_), true) => "snorm-poles",
        (Encoding::Snorm(_), false) => "snorm-edges",
        (Encoding::Half | Encoding::Single, true) => "half-poles",
        (Encoding::Half | Encoding::Single, false) => "half-edges",
    };
    let name = format!("{}, {}", encoding.name(), if poles { "poles" } else { "octant edges" });
    let bounds = (Bound::new(encoding.worst_angle().0, Unit::Degrees, "encoding-bound"), None);
    StressCase::new(Group::Encoding, texts, name, bounds, move || {
        let directions = if poles { self::poles() } else { edges() };
        Measured::pairs(directions.into_iter().map(|direction| errors(encoding, direction)))
    })
}

fn errors(encoding: Encoding, direction: DVec3) -> [f64; 2] {
    let truth = exact::unit(&direction.to_array().map(exact::big)).expect("a direction");
    let single = direction.as_vec3();
    let plain = match encoding {
        Encoding::Octahedral(codec, _) => plain_octahedral(single, codec.bits()),
        Encoding::Snorm(codec) => {
            let steps = ((1 << (codec.bits() - 1)) - 1) as f32;
            single.map(|x| libm::roundf(x * steps) / steps)
        }
        Encoding::Half | Encoding::Single => single.map(|x| from_half(to_half(f64::from(x))) as f32),
    };
    [encoding.decode(encoding.encode(direction)), plain.as_dvec3()].map(|v| exact::degrees_to(v, &truth))
}

/// Encoded and decoded as shaders do it: the sign of 0 is 0.
fn plain_octahedral(v: Vec3, bits: u32) -> Vec3 {
    let steps = ((1 << (bits - 1)) - 1) as f32;
    let sign = |x: f32| if x == 0.0 { 0.0 } else { x.signum() };
    let fold = |x: f32, y: f32| [(1.0 - y.abs()) * sign(x), (1.0 - x.abs()) * sign(y)];
    let sum = v.x.abs() + v.y.abs() + v.z.abs();
    let [x, y] = [v.x / sum, v.y / sum];
    let [x, y] = if v.z <= 0.0 { fold(x, y) } else { [x, y] };
    let [x, y] = [x, y].map(|x| libm::rintf(x * steps) / steps);
    let z = 1.0 - x.abs() - y.abs();
    let [x, y] = if z < 0.0 { fold(x, y) } else { [x, y] };
    Vec3::new(x, y, z)
}

fn poles() -> Vec<DVec3> {
    let mut numbers = Numbers::new(22);
    let axes = [DVec3::X, DVec3::Y, DVec3::Z].into_iter().flat_map(|axis| [axis, -axis]);
    axes.flat_map(|axis| {
        let off = DISTANCES
            .map(|distance| axis + distance * (DVec3::splat(1.0) - axis.abs()) * vector(&mut numbers));
        off.into_iter().chain([axis])
    })
    .map(DVec3::normalize)
    .collect()
}

fn edges() -> Vec<DVec3> {
    let mut numbers = Numbers::new(23);
    let direction = |i: usize| {
        let mut v = vector(&mut numbers);
        v[i % 3] = DISTANCES[i % DISTANCES.len()] * vector(&mut numbers).x;
        v.normalize()
    };
    (0..DIRECTIONS).map(direction).collect()
}
