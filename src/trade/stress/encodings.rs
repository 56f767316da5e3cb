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
        let mut definition = Worst::default();
        let errors = directions.into_iter().map(|direction| {
            let [encoded, plain, exact] = errors(encoding, direction);
            definition.add(exact);
            [encoded, plain]
        });
        let measured = Measured::pairs(errors);
        Measured { definition, ..measured }
    })
}

/// The errors of this library, of the plain formula in `f32`, and of the same in `f64`.
fn errors(encoding: Encoding, direction: DVec3) -> [f64; 3] {
    let truth = exact::unit(&direction.to_array().map(exact::big)).expect("a direction");
    let single = direction.to_array().map(|x| x as f32);
    let formulas = [plain(encoding, single), plain(encoding, direction.to_array())];
    let encoded = encoding.decode(encoding.encode(direction));
    [encoded, formulas[0], formulas[1]].map(|v| exact::degrees_to(v, &truth))
}

fn plain<R: Real>(encoding: Encoding, v: [R; 3]) -> DVec3 {
    let decoded = match encoding {
        Encoding::Octahedral(codec, _) => plain_octahedral(v, codec.bits()),
        Encoding::Snorm(codec) => {
            let steps = steps(codec.bits());
            v.map(|x| (x * steps).nearest() / steps)
        }
        Encoding::Half | Encoding::Single => v.map(|x| R::of(from_half(to_half(x.to_f64())))),
    };
    DVec3::from(decoded.map(R::to_f64))
}

/// The largest code of so many bits.
fn steps<R: Real>(bits: u32) -> R {
    R::of(f64::from((1 << (bits - 1)) - 1))
}

/// Encoded and decoded as shaders do it: the sign of 0 is 0.
fn plain_octahedral<R: Real>([x, y, z]: [R; 3], bits: u32) -> [R; 3] {
    let steps: R = steps(bits);
    let sign = |x: R| {
        if x == R::ZERO {
            R::ZERO
        } else if x < R::ZERO {
            -R::ONE
        } else {
            R::ONE
        }
    };
    let fold = |x: R, y: R| [(R::ONE - y.abs()) * sign(x), (R::ONE - x.abs()) * sign(y)];
    let sum = x.abs() + y.abs() + z.abs();
    let [x, y] = [x / sum, y / sum];
    let [x, y] = if z <= R::ZERO { fold(x, y) } else { [x, y] };
    let [x, y] = [x, y].map(|x| (x * steps).nearest() / steps);
    let z = R::ONE - x.abs() - y.abs();
    let [x, y] = if z < R::ZERO { fold(x, y) } else { [x, y] };
    [x, y, z]
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
