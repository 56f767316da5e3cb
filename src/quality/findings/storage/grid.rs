//! The grids to which formats round normals, and whether stored normals are on one.

use crate::normals::encoding::Encoding;
use crate::num::{Degrees, Radians};
use crate::quality::findings::remarks::REMARKS;
use crate::text::Text;
use glam::DVec3;
use std::collections::BTreeMap;

/// The evidence against chance, in bits, that a grid needs: one in a million, divided by some sixty grids.
const NEEDED: f64 = 20.0;

/// The largest component of directions that are no evidence: multiples of small whole numbers are on very many grids.
const SIMPLE: i32 = 4;

/// The largest distance from a grid, as a share of the largest code, of what was on it: more than 32 bits and six decimals leave.
const ROUNDED: f64 = 1e-6;

/// The largest difference from 1 of the length of a unit vector: more than 32 bits leave.
const UNIT: f64 = 1e-5;

/// How far rounding three components to whole numbers may move a vector: half a step in each.
const REACH: f64 = 0.866_025_403_784_438_6;

/// A way of rounding normals: x · scale + offset is whole.
#[derive(Clone, Debug)]
pub(crate) struct Grid {
    layout: Layout,
    scale: f64,
    offset: f64,
    numbers: Numbers,
}

/// The numbers to which components are rounded.
#[derive(Clone, Copy, Debug)]
enum Numbers {
    Decimals(u32),
    Signed { bits: u32 },
    Unsigned { bits: u32 },
}

/// What is rounded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Layout {
    Components,
    /// Each component, before the vector is normalised.
    MadeUnit,
    /// Two coordinates on an octahedron. The third is 1 less their magnitudes, and so on the grid as well.
    Octahedral,
}

impl Grid {
    /// The coarsest grid that all normals are on; `None` if there is none, or if it may be by chance.
    pub(crate) fn find(normals: &[DVec3]) -> Option<Grid> {
        let usable = normals.iter().copied().filter(|n| n.is_finite() && *n != DVec3::ZERO);
        let normals: Vec<DVec3> = usable.collect();
        let evident = normals.iter().filter(|normal| !is_simple(normal.normalize()));
        let different: BTreeMap<[u32; 3], DVec3> = evident.map(|&normal| (shape(normal), normal)).collect();
        let evidence = |grid: &Grid| different.values().map(|&normal| grid.evidence(normal)).sum::<f64>();
        if different.is_empty() {
            return None;
        }
        let has_all = |grid: &Grid| normals.iter().all(|&normal| grid.has(normal));
        grids().into_iter().find(|grid| has_all(grid) && evidence(grid) >= NEEDED)
    }

    fn has(&self, normal: DVec3) -> bool {
        match self.layout {
            Layout::Components => self.are_codes(normal * self.scale),
            Layout::MadeUnit => self.codes_of(normal.normalize()).is_some(),
            Layout::Octahedral => self.are_codes(normal / normal.abs().element_sum() * self.scale),
        }
    }

    /// Whether all components of a scaled vector are codes without their offset.
    fn are_codes(&self, scaled: DVec3) -> bool {
        let is_code = |x: f64| (x + self.offset - libm::round(x + self.offset)).abs() <= ROUNDED * self.scale;
        scaled.to_array().into_iter().all(is_code)
    }

    /// How unlikely it is that a vector is on the grid by chance, in bits.
    ///
    /// A vector that was not rounded may be any, or of whole numbers: slopes of models often are. Rounded vectors are not of
    /// length 1, while unit vectors of either kind are.
    fn evidence(&self, normal: DVec3) -> f64 {
        let scale = self.scale;
        let by_component = -libm::log2((2.0 * ROUNDED * scale).min(1.0));
        let free =
            |vector: DVec3| vector.to_array().iter().filter(|x| **x != 0.0 && x.abs() != 1.0).count() as f64;
        let error = (normal.length() - 1.0).abs();
        match self.layout {
            // No rounding of a unit vector leaves this.
            Layout::Components if error * scale > REACH + ROUNDED * scale => 0.0,
            Layout::Components if error > UNIT => free(normal) * by_component,
            Layout::Octahedral => {
                let codes = normal / normal.abs().element_sum() * scale;
                let any = (free(codes / scale) - 1.0).max(0.0) * by_component;
                any.min(libm::log2(primitive(codes).abs().element_sum()))
            }
            _ => {
                let Some(codes) = self.codes_of(normal.normalize()) else { return 0.0 };
                // The share of the circle, or the sphere, that is as near to a direction of codes.
                let off = ROUNDED * scale;
                let near = match codes.to_array().contains(&0.0) {
                    true => 4.0 * REACH * off,
                    false => std::f64::consts::TAU * REACH * off * off,
                };
                let whole = libm::log2(primitive(codes).length() / (2.0 * REACH));
                (-libm::log2(near.min(1.0))).min(whole.max(0.0))
            }
        }
    }

    /// The codes without their offset that rounding a unit vector may give and that have this direction.
    fn codes_of(&self, direction: DVec3) -> Option<DVec3> {
        let largest = direction[direction.abs().max_position()];
        let [a, b] = [self.scale - REACH, self.scale + REACH].map(|length| length * largest + self.offset);
        let (first, last) = (libm::ceil(a.min(b)), libm::floor(a.max(b)));
        // Two or three, at most.
        let codes = (0..4).map(|i| first + f64::from(i)).take_while(|&code| code <= last);
        let mut lengths = codes.map(|code| (code - self.offset) / largest);
        let length = lengths.find(|&length| self.are_codes(direction * length))?;
        Some((direction * length + self.offset).round() - self.offset)
    }

    /// A bound on the angle between a normal and the same rounded to the nearest.
    pub(crate) fn error(&self) -> Degrees {
        match self.layout {
            // Proportional to the step, which is 1/127 for 8 bits.
            Layout::Octahedral => Degrees(Encoding::OCTAHEDRAL_8.worst_angle().0 * 127.0 / self.scale),
            // At right angles to the normal at worst.
            _ => Radians(libm::asin(REACH / self.scale)).into(),
        }
    }

    /// What it rounds to, in words.
    pub(crate) fn name(&self) -> Text {
        let numbers = match self.numbers {
            Numbers::Decimals(count) => REMARKS.with("decimals", &[("count", count.into())]),
            Numbers::Signed { bits } => {
                let scale = self.scale.to_string();
                REMARKS.with("signed-integers", &[("bits", bits.into()), ("scale", scale.into())])
            }
            Numbers::Unsigned { bits } => {
                let largest = (2.0 * self.scale).to_string();
                REMARKS.with("unsigned-integers", &[("bits", bits.into()), ("largest", largest.into())])
            }
        };
        match self.layout {
            Layout::Components => numbers,
            Layout::MadeUnit => REMARKS.with("renormalised", &[("numbers", numbers.into())]),
            Layout::Octahedral => REMARKS.with("octahedral-codes", &[("numbers", numbers.into())]),
        }
    }

    /// Whether its normals have the lengths that rounding leaves.
    pub(crate) fn spoils_lengths(&self) -> bool {
        self.layout == Layout::Components
    }
}

/// All grids, coarse ones before those that contain them.
fn grids() -> Vec<Grid> {
    let widths = [8, 10, 12, 16];
    let signed = |bits: u32, scale: f64| (scale, 0.0, Numbers::Signed { bits });
    // Over the largest integer, as in glTF and OpenGL, or over the power of two above it.
    let over_largest = |bits: u32| signed(bits, f64::from((1u32 << (bits - 1)) - 1));
    let over_power = |bits: u32| signed(bits, f64::from(1u32 << (bits - 1)));
    // From 0 … 1 to −1 … 1, as in normal maps.
    let unsigned = |bits: u32| {
        let half = 0.5 * f64::from((1u32 << bits) - 1);
        (half, half, Numbers::Unsigned { bits })
    };
    let decimals = |count: u32| (f64::from(10u32.pow(count)), 0.0, Numbers::Decimals(count));
    let mut components: Vec<(f64, f64, Numbers)> = (1..=4).map(decimals).collect();
    components.extend((4..=16).map(over_largest));
    components.extend(widths.map(over_power));
    components.extend(widths.map(unsigned));
    components.sort_by(|a, b| a.0.total_cmp(&b.0));
    let grid = |layout, (scale, offset, numbers)| Grid { layout, scale, offset, numbers };
    let each = components.into_iter();
    let components =
        each.flat_map(|it| [Layout::Components, Layout::MadeUnit].map(|layout| grid(layout, it)));
    let octahedral = (8..=16).map(over_largest).chain(widths.map(unsigned));
    components.chain(octahedral.map(|it| grid(Layout::Octahedral, it))).collect()
}

/// What a direction has in common with its permutations and changes of sign, which are on the same grids.
fn shape(vector: DVec3) -> [u32; 3] {
    let mut sizes = vector.normalize().abs().to_array().map(|x| libm::round(x * 1e5) as u32);
    sizes.sort_unstable();
    sizes
}

/// The smallest vector of whole numbers in the direction of one of whole numbers or halves.
fn primitive(halves: DVec3) -> DVec3 {
    let whole = (halves * 2.0).round();
    let common = whole.to_array().into_iter().fold(0, |common, x| common_divisor(common, x.abs() as u64));
    whole / common.max(1) as f64
}

/// The greatest common divisor; of 0 and another number, the other.
fn common_divisor(a: u64, b: u64) -> u64 {
    if b == 0 { a } else { common_divisor(b, a % b) }
}

/// Whether a direction is that of a vector of small whole numbers.
fn is_simple(direction: DVec3) -> bool {
    let largest = direction.abs().max_element();
    (1..=SIMPLE).any(|whole| {
        let scaled = direction * (f64::from(whole) / largest);
        (scaled - scaled.round()).abs().max_element() <= 1e-5
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::normals::encoding::{Octahedral, Rounding, Snorm};
    use glam::Vec3Swizzles;

    /// Directions spread evenly over the sphere, in 32 bits.
    fn spiral(count: usize) -> Vec<DVec3> {
        let at = |i: usize| {
            let z = 1.0 - (2.0 * i as f64 + 1.0) / count as f64;
            let (sine, cosine) = libm::sincos(2.399_963 * i as f64);
            let round = (1.0 - z * z).sqrt();
            DVec3::new(round * cosine, round * sine, z)
        };
        (0..count).map(at).map(single).collect()
    }

    fn single(normal: DVec3) -> DVec3 {
        normal.as_vec3().as_dvec3()
    }

    fn named(change: impl Fn(DVec3) -> DVec3) -> Option<String> {
        let normals: Vec<DVec3> = spiral(200).into_iter().map(|n| single(change(n))).collect();
        Grid::find(&normals).map(|grid| grid.name().english().to_owned())
    }

    #[test]
    fn grids_are_distinguished() {
        let over = |steps: f64| move |n: DVec3| (n * steps).round() / steps;
        let unsigned = |most: f64| move |n: DVec3| (n * 0.5 * most + 0.5 * most).round() * (2.0 / most) - 1.0;
        for (steps, name) in [
            (10.0, "one decimal"),
            (100.0, "two decimals"),
            (1000.0, "three decimals"),
            (10_000.0, "four decimals"),
            (7.0, "4-bit signed integers over 7"),
            (127.0, "8-bit signed integers over 127"),
            (128.0, "8-bit signed integers over 128"),
            (511.0, "10-bit signed integers over 511"),
            (32_767.0, "16-bit signed integers over 32767"),
        ] {
            assert_eq!(named(over(steps)).as_deref(), Some(name));
            let unit = named(|n| over(steps)(n).normalize());
            assert_eq!(unit, Some(format!("{name}, renormalised")));
        }
        for (most, name) in [
            (255.0, "8-bit unsigned integers, 2k/255 − 1"),
            (1023.0, "10-bit unsigned integers, 2k/1023 − 1"),
        ] {
            assert_eq!(named(unsigned(most)).as_deref(), Some(name));
            let unit = named(|n| unsigned(most)(n).normalize());
            assert_eq!(unit, Some(format!("{name}, renormalised")));
        }
        assert_eq!(named(|n| n), None);
    }

    /// Against the codec that stores them.
    #[test]
    fn octahedral_codes_are_reported() {
        for (bits, name) in [(8, 127), (10, 511), (12, 2047), (16, 32767)] {
            let codec = Octahedral::new(bits).unwrap();
            let expected = format!("octahedral codes of 2 × {bits}-bit signed integers over {name}");
            let stored = |n| codec.decode(codec.encode(n, Rounding::Nearest));
            assert_eq!(named(stored).as_ref(), Some(&expected));
            let other_pole = |n: DVec3| stored(n.xzy()).xzy();
            assert_eq!(named(other_pole), Some(expected));
        }
    }

    /// What a grid does to normals is within its bound, and not far below.
    #[test]
    fn errors_are_bounds() {
        let round = |encoding: Encoding| {
            let stored = |n: &DVec3| encoding.decode(encoding.encode(*n));
            let off = |n: &DVec3| Degrees::from(crate::num::angle_between(*n, stored(n))).0;
            let normals = spiral(20_000);
            let worst = normals.iter().map(off).fold(0.0, f64::max);
            let grid = Grid::find(&normals.iter().map(stored).map(single).collect::<Vec<_>>()).unwrap();
            (worst, grid.error().0)
        };
        for encoding in [Encoding::OCTAHEDRAL_8, Encoding::Snorm(Snorm::EIGHT), Encoding::Snorm(Snorm::TEN)] {
            let (worst, bound) = round(encoding);
            assert!(worst <= bound && worst > 0.9 * bound, "{}: {worst} of {bound}", encoding.name());
        }
    }

    /// A prism of few sides has few directions, and fewer that signs and permutations do not make of each other.
    #[test]
    fn few_directions_tell_how_they_were_rounded() {
        let side = |count: u32, lean: f64| {
            let at = move |i: u32| {
                let (sine, cosine) = libm::sincos(f64::from(i) * std::f64::consts::TAU / f64::from(count));
                DVec3::new(cosine, lean, sine).normalize()
            };
            (0..count).map(at)
        };
        let named = |normals: &[DVec3], round: fn(DVec3) -> DVec3| {
            let rounded: Vec<DVec3> = normals.iter().map(|&n| single(round(n))).collect();
            Grid::find(&rounded).map(|grid| grid.name().english().to_owned())
        };
        let signed: fn(DVec3) -> DVec3 = |n| (n * 127.0).round() / 127.0;
        let unit: fn(DVec3) -> DVec3 = |n| (n * 127.0).round().normalize();
        let octahedral: fn(DVec3) -> DVec3 = |n| {
            let codec = Octahedral::new(8).unwrap();
            codec.decode(codec.encode(n, Rounding::Nearest))
        };
        // Of a prism of 8 sides all are simple; of one of 16, one direction is enough. A renormalised vector needs more of them.
        for count in [12, 16, 20, 24, 32, 48, 64, 96, 128, 360] {
            for lean in [0.0, 0.4] {
                let sides: Vec<DVec3> = side(count, lean).collect();
                let reported = |round| named(&sides, round);
                assert_eq!(named(&sides, |n| n), None, "{count} sides, {lean}");
                assert_eq!(
                    reported(signed).as_deref(),
                    Some("8-bit signed integers over 127"),
                    "{count}, {lean}"
                );
                if count >= 48 {
                    let expected = Some("8-bit signed integers over 127, renormalised");
                    assert_eq!(reported(unit).as_deref(), expected, "{count}, {lean}");
                    let expected = Some("octahedral codes of 2 × 8-bit signed integers over 127");
                    assert_eq!(reported(octahedral).as_deref(), expected, "{count}, {lean}");
                }
            }
        }
    }

    /// Exact normals of shapes along the axes and the diagonals are on many grids, and so are those of surfaces over whole
    /// numbers; they were not rounded to any.
    #[test]
    fn exact_normals_are_on_no_grid() {
        let steps = [-4, -3, -2, -1, 0, 1, 2, 3, 4].map(f64::from);
        let all = steps.iter().flat_map(|&x| steps.iter().flat_map(move |&y| steps.map(|z| [x, y, z])));
        let simple: Vec<DVec3> = all.map(DVec3::from).filter_map(DVec3::try_normalize).collect();
        assert!(Grid::find(&simple).is_none());
        let prism = |i: u32| {
            let (sine, cosine) = libm::sincos(f64::from(i) * std::f64::consts::TAU / 360.0);
            DVec3::new(cosine, 0.0, sine)
        };
        assert!(Grid::find(&(0..360).map(prism).collect::<Vec<_>>()).is_none());
        let hills = (-9..9).flat_map(|x| (-9..9).map(move |y| DVec3::new(x.into(), 1.0, y.into())));
        assert!(Grid::find(&hills.map(|n| single(n.normalize())).collect::<Vec<_>>()).is_none());
    }
}
