//! Errors and costs of normals that are stored in few bits.

use super::angles::angle_between;
use super::effort::{Candidate, Effort, Observer, Progress, fewest_seconds};
use crate::normals::encoding::Encoding;
use crate::num::parallel;
use crate::num::{CompensatedSum, Degrees, Radians, largest_exponent};
use glam::DVec3;
use serde::Serialize;
use std::f64::consts::TAU;
use std::hint::black_box;
use std::ops::Range;

/// Half a step of 8 bits: the largest invisible change of a highlight.
const HALF_STEP: f64 = 1.0 / 510.0;

/// One encoding.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct EncodingRow {
    /// Its name.
    pub name: String,
    /// Bytes of a packed normal.
    pub bytes: usize,
    /// The mean angle to what was encoded, in degrees.
    pub mean: f64,
    /// The largest of them.
    pub max: f64,
    /// How many directions these two are of.
    pub directions: u32,
    /// The largest error of any normal: [`Encoding::worst_angle`], in degrees.
    pub bound: f64,
    /// Whether a diffuse term stays within half a step of 8 bits, of every normal: by the bound.
    pub diffuse: bool,
    /// The largest exponent of Blinn's highlight that does.
    pub blinn: Option<u64>,
    /// The same of Phong's, whose angles are twice as wrong.
    pub phong: Option<u64>,
    /// Nanoseconds to pack a normal, on one thread.
    pub encode_ns: f64,
    /// Nanoseconds to unpack it.
    pub decode_ns: f64,
}

/// Two million directions: what figures are quoted for.
pub const DIRECTIONS: u32 = 2_000_000;

/// A direction by its number: even on the sphere, and the same on any machine. Height and longitude come from splitmix64
/// (Steele, Lea & Flood 2014) of twice the number and of the next one.
pub fn direction(number: u32) -> DVec3 {
    let share = |place: u64| {
        let mut z = place.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    };
    let z = 2.0 * share(2 * u64::from(number)) - 1.0;
    let (sin, cos) = libm::sincos(TAU * share(2 * u64::from(number) + 1));
    let radius = ((1.0 - z) * (1.0 + z)).sqrt();
    DVec3::new(radius * cos, radius * sin, z)
}

/// The mean and the largest angle, in degrees, between so many directions and what an encoding makes of them.
pub fn encoding_error(encoding: Encoding, directions: u32) -> (f64, f64) {
    const CHUNK: usize = 1 << 14;
    let of_chunk = |chunk: Range<usize>| {
        let (mut sum, mut max) = (CompensatedSum::default(), 0.0_f64);
        for number in chunk {
            let normal = direction(number as u32);
            let angle = angle_between(normal, encoding.decode(encoding.encode(normal))).0;
            sum += angle;
            max = max.max(angle);
        }
        (sum, max)
    };
    // Chunks are joined in order, so that the sum does not depend on who made them.
    let (mut sum, mut max) = (CompensatedSum::default(), 0.0_f64);
    for (part, largest) in parallel::blocks(directions as usize, CHUNK, of_chunk) {
        sum += part;
        max = max.max(largest);
    }
    (Degrees::from(Radians(sum.value() / f64::from(directions.max(1)))).0, Degrees::from(Radians(max)).0)
}

/// All encodings on [`DIRECTIONS`], a tenth of them with [`Effort::Quick`].
pub fn encoding_rows(effort: Effort, observe: Observer) -> Vec<EncodingRow> {
    let directions = if effort == Effort::Quick { DIRECTIONS / 10 } else { DIRECTIONS };
    let total = Encoding::ALL.len() + 1;
    let row = |(done, encoding): (usize, Encoding)| {
        observe(Progress { stage: "encodings", done, total });
        let (mean, max) = encoding_error(encoding, directions);
        let bound = encoding.worst_angle();
        let worst = Radians::from(bound);
        EncodingRow {
            name: encoding.name(),
            bytes: encoding.bytes(),
            mean,
            max,
            directions,
            bound: bound.0,
            diffuse: largest_exponent(worst, HALF_STEP).is_some(),
            blinn: largest_exponent(worst, HALF_STEP),
            phong: largest_exponent(Radians(2.0 * worst.0), HALF_STEP),
            encode_ns: 0.0,
            decode_ns: 0.0,
        }
    };
    let mut rows: Vec<EncodingRow> = Encoding::ALL.into_iter().enumerate().map(row).collect();
    observe(Progress { stage: "encodings", done: total - 1, total });
    for (row, times) in rows.iter_mut().zip(times()) {
        [row.encode_ns, row.decode_ns] = times;
    }
    observe(Progress { stage: "encodings", done: total, total });
    rows
}

/// Nanoseconds to pack and to unpack a normal with each encoding.
fn times() -> Vec<[f64; 2]> {
    const COUNT: u32 = 1 << 14;
    let normals: Vec<DVec3> = (0..COUNT).map(direction).collect();
    let packed: Vec<Vec<u8>> =
        Encoding::ALL.iter().map(|encoding| encoding.pack(normals.iter().copied())).collect();
    let mut candidates: Vec<Candidate> = Vec::new();
    for (encoding, packed) in Encoding::ALL.into_iter().zip(&packed) {
        let normals = &normals;
        candidates.push(Box::new(move || drop(black_box(encoding.pack(normals.iter().copied())))));
        candidates.push(Box::new(move || {
            black_box(encoding.unpack(packed).fold(DVec3::ZERO, |sum, normal| sum + normal));
        }));
    }
    let nanoseconds =
        fewest_seconds(candidates, 3).into_iter().map(|seconds| seconds * 1e9 / f64::from(COUNT));
    nanoseconds.collect::<Vec<_>>().as_chunks().0.to_vec()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Means within 0.3 % and maxima within 2 % of figures computed outside this program on other directions; and half
    /// a unit of the last digit that they are printed with.
    #[test]
    fn published_errors_come_out() {
        let quoted = [
            ("oct 8+8", (0.33711, 1e-5), (0.956, 1e-3)),
            ("oct 8+8 nearest", (0.31492, 1e-5), (0.6363, 1e-4)),
            ("oct 10+10", (0.08366, 1e-5), (0.2351, 1e-4)),
            ("oct 10+10 nearest", (0.07817, 1e-5), (0.1584, 1e-4)),
            ("oct 12+12", (0.02089, 1e-5), (0.0588, 1e-4)),
            ("oct 12+12 nearest", (0.01952, 1e-5), (0.0394, 1e-4)),
            ("oct 16+16", (0.001_305, 1e-6), (0.003_69, 1e-5)),
            ("oct 16+16 nearest", (0.001_22, 1e-5), (0.002_46, 1e-5)),
            ("snorm 3×8", (0.17006, 1e-5), (0.3883, 1e-4)),
            ("snorm 3×10", (0.04229, 1e-5), (0.0963, 1e-4)),
            ("snorm 3×16", (0.00066, 1e-5), (0.0015, 1e-4)),
            ("half ×3", (0.00606, 1e-5), (0.0235, 1e-4)),
            ("f32 ×3", (7.4e-7, 1e-8), (2.8e-6, 1e-7)),
        ];
        for (name, (mean, mean_unit), (max, max_unit)) in quoted {
            let encoding = Encoding::ALL.into_iter().find(|encoding| encoding.name() == name).unwrap();
            let found = encoding_error(encoding, DIRECTIONS);
            assert!((found.0 - mean).abs() <= 0.003 * mean + 0.5 * mean_unit, "{name}: mean {}", found.0);
            assert!((found.1 - max).abs() <= 0.02 * max + 0.5 * max_unit, "{name}: largest {}", found.1);
        }
    }

    /// A sample knows less than the bound, and the fewer it is of, the less.
    #[test]
    fn exponents_do_not_depend_on_the_sample() {
        let rows = encoding_rows(Effort::Quick, &|_| ());
        let of = |name: &str| rows.iter().find(|row| row.name == name).unwrap();
        assert_eq!((of("half ×3").blinn, of("half ×3").phong), (Some(59), Some(14)));
        assert_eq!(of("snorm 3×16").blinn, Some(14960));
        assert_eq!(of("oct 16+16").blinn, Some(2487));
        for row in rows {
            assert!(row.max <= row.bound && row.directions == DIRECTIONS / 10, "{row:?}");
        }
    }

    #[test]
    fn directions_are_unit_and_even() {
        let sum = (0..100_000).map(direction).fold(DVec3::ZERO, |sum, direction| {
            // Two roundings of squares and a root.
            assert!((direction.length() - 1.0).abs() < 4e-16);
            sum + direction
        });
        // Each component of the mean has the deviation 1/√(3·10⁵): five of them.
        assert!((sum / 1e5).abs().max_element() < 5.0 * 0.001_83, "{sum}");
    }

    #[test]
    fn threads_change_no_bit() {
        let measure = |threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| encoding_error(Encoding::OCTAHEDRAL_8, 50_000))
        };
        assert_eq!(measure(1), measure(3));
    }
}
