//! The grids that formats round normals to, and whether stored normals lie on one.

use crate::normals::encoding::Encoding;
use crate::num::{Degrees, Radians};
use glam::DVec3;
use std::collections::BTreeMap;

/// How unlikely it has to be that directions lie on a grid by chance before it is believed, in bits: one in a million, of
/// which some sixty grids take their share.
const NEEDED: f64 = 20.0;

/// The largest component of directions that say nothing: multiples of few whole numbers are on very many grids.
const SIMPLE: i32 = 4;

/// How far what was on a grid may be from it, as a share of the largest code: more than 32 bits and six decimals leave.
const ROUNDED: f64 = 1e-6;

/// How far the length of a vector may be from 1 for it to count as unit: more than 32 bits leave.
const UNIT: f64 = 1e-5;

/// How far rounding three components to whole numbers may move a vector: half a step in each.
const REACH: f64 = 0.866_025_403_784_438_6;

/// A way of rounding normals.
#[derive(Clone, Debug)]
pub(in crate::quality) struct Grid {
    layout: Layout,
    codes: Codes,
}

/// What is rounded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Layout {
    /// Each component.
    Components,
    /// Each component, and what came out was made unit again.
    MadeUnit,
    /// Two coordinates on an octahedron. Whichever: the third is what they leave of 1, and so on the grid as well.
    Octahedral,
}

/// Numbers from −1 to 1 as whole ones: x · scale + offset.
#[derive(Clone, Debug)]
struct Codes {
    scale: f64,
    offset: f64,
    bits: u32,
    kind: Kind,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Decimals,
    Signed,
    Unsigned,
}

impl Codes {
    fn decimals(digits: u32) -> Self {
        Self { scale: f64::from(10u32.pow(digits)), offset: 0.0, bits: digits, kind: Kind::Decimals }
    }

    /// Signed integers over the largest of them, as in glTF and OpenGL.
    fn signed(bits: u32) -> Self {
        Self { scale: f64::from((1u32 << (bits - 1)) - 1), offset: 0.0, bits, kind: Kind::Signed }
    }

    /// Signed integers over the power of two above the largest.
    fn over_power(bits: u32) -> Self {
        Self { scale: f64::from(1u32 << (bits - 1)), offset: 0.0, bits, kind: Kind::Signed }
    }

    /// Unsigned integers stretched from 0 … 1 to −1 … 1, as in normal maps.
    fn unsigned(bits: u32) -> Self {
        let half = 0.5 * f64::from((1u32 << bits) - 1);
        Self { scale: half, offset: half, bits, kind: Kind::Unsigned }
    }

    /// Whether a number times the scale is one of them.
    fn has(&self, scaled: f64) -> bool {
        let code = scaled + self.offset;
        (code - libm::round(code)).abs() <= ROUNDED * self.scale
    }

    /// Whether all components of a vector are.
    fn have(&self, vector: DVec3) -> bool {
        vector.to_array().iter().all(|x| self.has(x * self.scale))
    }

    fn name(&self) -> String {
        let bits = self.bits;
        match self.kind {
            Kind::Decimals if bits == 1 => "one decimal".into(),
            Kind::Decimals => format!("{} decimals", ["two", "three", "four"][bits as usize - 2]),
            Kind::Signed => format!("{bits}-bit signed integers over {}", self.scale),
            Kind::Unsigned => format!("{bits}-bit unsigned integers, 2k/{} − 1", 2.0 * self.scale),
        }
    }
}

impl Grid {
    /// The coarsest grid that all of some normals lie on; `None` if they lie on none, or too few do for it to be no chance.
    pub(in crate::quality) fn find(normals: &[DVec3]) -> Option<Grid> {
        let usable = normals.iter().copied().filter(|n| n.is_finite() && *n != DVec3::ZERO);
        let normals: Vec<DVec3> = usable.collect();
        let telling = normals.iter().filter(|normal| !is_simple(normal.normalize()));
        let different: BTreeMap<[u32; 3], DVec3> = telling.map(|&normal| (shape(normal), normal)).collect();
        let evidence = |grid: &Grid| different.values().map(|&normal| grid.evidence(normal)).sum::<f64>();
        if different.is_empty() {
            return None;
        }
        grids().find(|grid| normals.iter().all(|&normal| grid.has(normal)) && evidence(grid) >= NEEDED)
    }

    fn has(&self, normal: DVec3) -> bool {
        match self.layout {
            Layout::Components => self.codes.have(normal),
            Layout::MadeUnit => self.is_made_unit(normal.normalize()),
            Layout::Octahedral => self.codes.have(normal / normal.abs().element_sum()),
        }
    }

    /// How unlikely it is that a vector lies on the grid by chance, in bits.
    ///
    /// A vector that was not rounded may be any, or of whole numbers: slopes of models often are. What rounding leaves is
    /// not of length 1, which vectors of neither kind are not that were made unit.
    fn evidence(&self, normal: DVec3) -> f64 {
        let scale = self.codes.scale;
        let by_component = -libm::log2((2.0 * ROUNDED * scale).min(1.0));
        let free =
            |vector: DVec3| vector.to_array().iter().filter(|x| **x != 0.0 && x.abs() != 1.0).count() as f64;
        match self.layout {
            // What no rounding of a unit vector leaves is of another making.
            Layout::Components if (normal.length() - 1.0).abs() * scale > REACH + ROUNDED * scale => 0.0,
            Layout::Components if (normal.length() - 1.0).abs() > UNIT => free(normal) * by_component,
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
                // A multiple of a vector of whole numbers has such a length.
                let whole = libm::log2(primitive(codes).length() / (2.0 * REACH));
                (-libm::log2(near.min(1.0))).min(whole.max(0.0))
            }
        }
    }

    /// Whether a vector of whole codes, which rounding a unit vector may give, has this direction.
    fn is_made_unit(&self, direction: DVec3) -> bool {
        self.codes_of(direction).is_some()
    }

    /// The codes, without their offset, of which one that rounding a unit vector may give has this direction.
    fn codes_of(&self, direction: DVec3) -> Option<DVec3> {
        let Codes { scale, offset, .. } = self.codes;
        let largest = direction[direction.abs().max_position()];
        let [a, b] = [scale - REACH, scale + REACH].map(|length| length * largest + offset);
        let (first, last) = (libm::ceil(a.min(b)), libm::floor(a.max(b)));
        // Two or three, at most.
        let codes = (0..4).map(|i| first + f64::from(i)).take_while(|&code| code <= last);
        let mut lengths = codes.map(|code| (code - offset) / largest);
        let length =
            lengths.find(|length| direction.to_array().iter().all(|x| self.codes.has(x * length)))?;
        Some((direction * length + offset).round() - offset)
    }

    /// An angle that no normal is farther from where it is rounded to.
    pub(in crate::quality) fn error(&self) -> Degrees {
        match self.layout {
            Layout::Octahedral => {
                // The bound goes with the step, and that of 8 bits is 1/127.
                Degrees(Encoding::OCTAHEDRAL_8.worst_angle().0 * 127.0 / self.codes.scale)
            }
            // At right angles to the normal at worst.
            _ => Radians(libm::asin(REACH / self.codes.scale)).into(),
        }
    }

    /// Whether its normals have the lengths that rounding leaves.
    pub(in crate::quality) fn spoils_lengths(&self) -> bool {
        self.layout == Layout::Components
    }

    /// What it is called.
    pub(in crate::quality) fn name(&self) -> String {
        match self.layout {
            Layout::Components => self.codes.name(),
            Layout::MadeUnit => format!("{}, made unit again", self.codes.name()),
            Layout::Octahedral => format!("octahedral codes of 2 × {}", self.codes.name()),
        }
    }
}

/// All grids, coarse ones before those that have all their points too.
fn grids() -> impl Iterator<Item = Grid> {
    let widths = [8, 10, 12, 16];
    let mut codes: Vec<Codes> = (1..=4).map(Codes::decimals).collect();
    codes.extend((4..=16).map(Codes::signed));
    codes.extend(widths.map(Codes::over_power));
    codes.extend(widths.map(Codes::unsigned));
    codes.sort_by(|a, b| a.scale.total_cmp(&b.scale));
    let squares = (8..=16).map(Codes::signed).chain(widths.map(Codes::unsigned));
    let squares: Vec<(Layout, Codes)> = squares.map(|codes| (Layout::Octahedral, codes)).collect();
    let cubes = codes
        .into_iter()
        .flat_map(|codes| [Layout::Components, Layout::MadeUnit].map(|layout| (layout, codes.clone())));
    cubes.chain(squares).map(|(layout, codes)| Grid { layout, codes })
}

/// What a vector's direction has in common with those that permutations and signs make of it, which are on the same grids.
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

/// The greatest common divisor; of 0 and another, the other.
fn common_divisor(a: u64, b: u64) -> u64 {
    if b == 0 { a } else { common_divisor(b, a % b) }
}

/// Whether a direction is that of a vector of few whole numbers.
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
        Grid::find(&normals).map(|grid| grid.name())
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
            assert_eq!(unit, Some(format!("{name}, made unit again")));
        }
        for (most, name) in [
            (255.0, "8-bit unsigned integers, 2k/255 − 1"),
            (1023.0, "10-bit unsigned integers, 2k/1023 − 1"),
        ] {
            assert_eq!(named(unsigned(most)).as_deref(), Some(name));
            let unit = named(|n| unsigned(most)(n).normalize());
            assert_eq!(unit, Some(format!("{name}, made unit again")));
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
            Grid::find(&rounded).map(|grid| grid.name())
        };
        let signed: fn(DVec3) -> DVec3 = |n| (n * 127.0).round() / 127.0;
        let unit: fn(DVec3) -> DVec3 = |n| (n * 127.0).round().normalize();
        let octahedral: fn(DVec3) -> DVec3 = |n| {
            let codec = Octahedral::new(8).unwrap();
            codec.decode(codec.encode(n, Rounding::Nearest))
        };
        // Of a prism of 8 sides all are simple; of one of 16, one direction tells. A vector made unit again tells less.
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
                    let expected = Some("8-bit signed integers over 127, made unit again");
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
