//! Normals in few bits, where the octahedron has its corners and edges.

use crate::normals::encoding::{Encoding, Octahedral, Rounding, Snorm, from_half, to_half};
use crate::num::numbers::Numbers;
use crate::trade::exact;
use crate::trade::stress::case::{Bound, Measured, StressCase, Unit, Worst};
use crate::trade::stress::group::Group;
use glam::{DVec3, Vec3};

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

/// What makes directions.
type Directions = fn() -> Vec<DVec3>;

pub(in crate::trade::stress) fn cases() -> Vec<StressCase> {
    let places: [(&str, &str, Directions); 2] = [
        ("poles", "the six axes and directions up to 1e-2 off them", poles),
        ("octant edges", "directions in the planes x = 0, y = 0, z = 0 and up to 1e-2 off them", edges),
    ];
    let case =
        |encoding: Encoding| places.map(|(name, what, directions)| case(name, what, encoding, directions));
    encodings().into_iter().flat_map(case).collect()
}

fn case(place: &str, what: &'static str, encoding: Encoding, directions: Directions) -> StressCase {
    StressCase {
        group: Group::Encoding,
        name: format!("{}, {place}", encoding.name()),
        what,
        expectation: "no worse than anywhere else",
        bound: Bound::new(
            encoding.worst_angle().0,
            Unit::Degrees,
            "Encoding::worst_angle, of all directions",
        ),
        fast_bound: None,
        plain_unit: Unit::Degrees,
        plain_formula: match encoding {
            Encoding::Octahedral(..) => {
                "v.xy / (|x|+|y|+|z|), folded by (1 - |yx|)·sign(xy) with sign(0) = 0"
            }
            Encoding::Snorm(_) => "round(v·s) / s",
            Encoding::Half | Encoding::Single => "half(v)",
        },
        measure: Box::new(move || measure(encoding, &directions())),
    }
}

fn measure(encoding: Encoding, directions: &[DVec3]) -> Measured {
    let mut faithful = Worst::default();
    let mut plain = Worst::default();
    for &direction in directions {
        let truth = exact::unit(&direction.to_array().map(exact::big)).expect("a direction");
        let error = |got: DVec3| exact::angle_to(got, &truth).to_degrees();
        faithful.add(error(encoding.decode(encoding.encode(direction))));
        let single = direction.as_vec3();
        let portable = match encoding {
            Encoding::Octahedral(codec, _) => plain_octahedral(single, codec.bits()),
            Encoding::Snorm(codec) => {
                let steps = ((1 << (codec.bits() - 1)) - 1) as f32;
                Vec3::from(single.to_array().map(|x| libm::roundf(x * steps) / steps))
            }
            Encoding::Half | Encoding::Single => {
                Vec3::from(single.to_array().map(|x| from_half(to_half(f64::from(x))) as f32))
            }
        };
        plain.add(error(portable.as_dvec3()));
    }
    Measured { samples: directions.len(), faithful, plain: Some(plain), ..Measured::default() }
}

/// There and back, as shaders have it: the sign of 0 is 0.
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
        let off =
            DISTANCES.map(|distance| axis + distance * (DVec3::splat(1.0) - axis.abs()) * off(&mut numbers));
        off.into_iter().chain([axis])
    })
    .map(DVec3::normalize)
    .collect()
}

fn edges() -> Vec<DVec3> {
    let mut numbers = Numbers::new(23);
    let direction = |i: usize| {
        let mut v = off(&mut numbers);
        v[i % 3] = DISTANCES[i % DISTANCES.len()] * off(&mut numbers).x;
        v.normalize()
    };
    (0..DIRECTIONS).map(direction).collect()
}

/// Each component within ±1.
fn off(numbers: &mut Numbers) -> DVec3 {
    DVec3::from_array([0; 3].map(|_| 2.0 * numbers.unit() - 1.0))
}
