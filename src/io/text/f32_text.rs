//! Coordinates in text that were printed from single precision, or with no more digits than that holds.

use super::numbers::{EXACT_POWERS, float};
use crate::mesh::Storage;
use crate::num;
use crate::num::parallel;
use glam::DVec3;

/// How many coordinates must agree: by chance, a double looks like a printed `f32` with a probability of at most one half.
const ENOUGH: usize = 20;

/// The digits of a floating-point number that C, C++ and Python print by default.
const DIGITS: i32 = 6;

/// Finds whether the coordinates of a text were printed from `f32`. If so, round them to `f32`.
///
/// The shortest decimal of an `f32` is a different `f64`, up to half a spacing away, which rotates the normal of a sliver by many
/// degrees. The coordinates were `f32` in two cases:
///
/// - each has the shortest spelling of one, and enough of them end in a digit finer than single precision or have fewer
///   decimals the larger they are;
/// - each is within half a unit of its last digit of one (as after `%.9g` or `%.17g`), and enough of them have digits so fine
///   that most doubles would not be.
///
/// Other numbers with a fixed count of decimals stay unchanged.
pub fn storage_of_text(parts: &[&[DVec3]]) -> Storage {
    let of_range = |part: &[DVec3]| part.iter().try_fold(Spellings::default(), Spellings::with);
    let of_parts =
        parallel::map_each(parts, |part| parallel::ranges(part.len(), |range| of_range(&part[range])));
    let mut spellings = of_parts.into_iter().flatten();
    let spellings = spellings.try_fold(Spellings::default(), |sum, part| Some(sum.and(&part?)));
    let are_singles = |spellings: Spellings| spellings.are_singles();
    if spellings.is_some_and(are_singles) { Storage::F32 } else { Storage::F64 }
}

/// The powers of ten of first digits of `f32`: from 10⁻⁴⁵ to 10³⁸.
const DECADES: usize = 84;
const LOWEST: i32 = -45;

/// Counts of coordinates that are all spelled like `f32`, in one of two ways.
struct Spellings {
    /// Whether each is the shortest decimal of an `f32`.
    are_shortest: bool,
    /// Whether each is within half a unit of its last digit of an `f32`.
    are_near: bool,
    /// How many of them need not have been.
    tested: usize,
    /// How many end in a digit whose unit is at most half the spacing of `f32` there.
    fine: usize,
    /// How many have their first digit at each power of ten, and the most decimals that one of them has.
    decades: [(usize, i32); DECADES],
}

impl Default for Spellings {
    fn default() -> Self {
        Self { are_shortest: true, are_near: true, tested: 0, fine: 0, decades: [(0, i32::MIN); DECADES] }
    }
}

impl Spellings {
    /// Adds a position; `None` if it is spelled in neither way.
    fn with(mut self, position: &DVec3) -> Option<Self> {
        for coordinate in position.to_array().into_iter().filter(|&coordinate| coordinate != 0.0) {
            let spelling = Spelling::of(coordinate)?;
            self.are_shortest &= spelling.is_shortest;
            self.are_near &= spelling.is_near;
            self.tested += usize::from(spelling.is_tested);
            if !self.are_shortest && !self.are_near {
                return None;
            }
            if self.fine < ENOUGH {
                self.fine += usize::from(spelling.is_fine(coordinate));
            }
            let (count, most) = &mut self.decades[(spelling.first - LOWEST) as usize];
            *count += 1;
            *most = spelling.decimals.max(*most);
        }
        Some(self)
    }

    fn and(mut self, other: &Self) -> Self {
        self.are_shortest &= other.are_shortest;
        self.are_near &= other.are_near;
        self.tested += other.tested;
        self.fine += other.fine;
        for (own, other) in self.decades.iter_mut().zip(other.decades) {
            *own = (own.0 + other.0, own.1.max(other.1));
        }
        self
    }

    fn are_singles(&self) -> bool {
        self.are_near && self.tested >= ENOUGH
            || self.are_shortest && (self.fine >= ENOUGH || self.is_floating())
    }

    /// Whether enough of the largest have all digits of an `f32`, but fewer decimals than smaller ones.
    fn is_floating(&self) -> bool {
        let (mut count, mut decimals) = (0, i32::MIN);
        for at in (0..DECADES).rev() {
            count += self.decades[at].0;
            decimals = decimals.max(self.decades[at].1);
            if count >= ENOUGH {
                let first = at as i32 + LOWEST;
                let is_finer = |decade: &(usize, i32)| decade.1 > decimals;
                return first + 1 + decimals >= DIGITS && self.decades[..at].iter().any(is_finer);
            }
        }
        false
    }
}

/// A decimal, compared with the nearest `f32`.
#[derive(Debug, PartialEq)]
struct Spelling {
    /// Whether it is the shortest decimal that reads back as the `f32`.
    is_shortest: bool,
    /// Whether the `f32` is within half a unit of its last digit.
    is_near: bool,
    /// Whether most decimals of so many digits are not: the spacing of `f32` is over 4 units.
    is_tested: bool,
    /// The power of ten of the first digit.
    first: i32,
    /// How many decimals it has; negative if it ends in zeros before the point.
    decimals: i32,
}

/// Arithmetic in `f64` cannot decide: the text must be compared.
struct Unclear;

/// The relative error of a distance: some 2⁻²⁰ of the spacing of `f32`, 2⁹ times the rounding error of an `f64`.
const MARGIN: f64 = 1e-6;

/// The most decimals of a number that is not near an `f32`: nine digits or ten, as the power of two of a number bounds that of
/// ten; and eight decimals, if an `f64` holds so many digits. The shortest decimal of an `f32` has no more.
fn most_decimals(coordinate: f64) -> i32 {
    let decade = (num::exponent(coordinate) * 1233) >> 12;
    if (0..=6).contains(&decade) { 8 } else { 8 - decade }
}

impl Spelling {
    /// The spelling of a coordinate other than 0; `None` if it has more digits than an `f32` nearby, or is out of range.
    fn of(coordinate: f64) -> Option<Self> {
        let single = coordinate as f32;
        if !single.is_finite() || single == 0.0 {
            return None;
        }
        Self::by_arithmetic(coordinate.abs(), f64::from(single.abs()))
            .unwrap_or_else(|Unclear| Self::by_text(coordinate, single))
    }

    /// The same for a positive coordinate. Much faster than printing.
    fn by_arithmetic(coordinate: f64, single: f64) -> Result<Option<Self>, Unclear> {
        let scale = most_decimals(coordinate);
        let power = *EXACT_POWERS.get(scale.unsigned_abs() as usize).ok_or(Unclear)?;
        let (digits, value) = if scale >= 0 {
            let digits = (coordinate * power).round();
            (digits, digits / power)
        } else {
            let digits = (coordinate / power).round();
            (digits, digits * power)
        };
        // One operation on exact operands is what reading these digits gives (Clinger 1990).
        if value != coordinate {
            // The unit of one more digit: none of a longer text is larger.
            let unit = if scale >= 0 { 0.1 / power } else { 0.1 * power };
            let may_be_near =
                (coordinate - single).abs() <= (0.5 + MARGIN) * unit + f64::EPSILON * coordinate;
            return if may_be_near { Err(Unclear) } else { Ok(None) };
        }
        let (mut digits, mut decimals) = (digits as u64, scale);
        while digits.is_multiple_of(10) {
            (digits, decimals) = (digits / 10, decimals - 1);
        }
        let first = digits.ilog10() as i32 - decimals;
        let spelling = Self::new(coordinate, single, first, decimals);
        // An f32 keeps all numbers of so few digits, so no other of them reads as the same.
        if first + decimals < DIGITS {
            return Ok(Some(Self { is_shortest: true, ..spelling }));
        }
        let unit = match usize::try_from(decimals) {
            Ok(decimals) => 1.0 / EXACT_POWERS.get(decimals).ok_or(Unclear)?,
            Err(_) => *EXACT_POWERS.get(decimals.unsigned_abs() as usize).ok_or(Unclear)?,
        };
        // The spacing of f32 changes at a power of two.
        if single.to_bits() << 12 == 0 {
            return Err(Unclear);
        }
        let half_spacing = num::power_of_two(num::exponent(single) - 24);
        let (off, last) = (coordinate - single, (digits % 10) as f64);
        let is_beyond = |distance: f64, limit: f64| {
            let excess = distance.abs() - limit;
            (excess.abs() > MARGIN * limit).then_some(excess > 0.0).ok_or(Unclear)
        };
        let is_shortest = is_beyond(off - last * unit, half_spacing)?
            && is_beyond(off + (10.0 - last) * unit, half_spacing)?
            && !is_beyond(off, half_spacing)?
            && !is_beyond(off, 0.5 * unit)?;
        Ok(Some(Self { is_shortest, ..spelling }))
    }

    /// The digits of a coordinate, compared with a single: all but whether they are the fewest.
    fn new(coordinate: f64, single: f64, first: i32, decimals: i32) -> Self {
        let unit = match EXACT_POWERS.get(decimals.max(0) as usize) {
            Some(power) if decimals >= 0 => 1.0 / power,
            _ => libm::exp10(-f64::from(decimals)),
        };
        let spacing = num::power_of_two((num::exponent(single) - 23).max(-149));
        // The coordinate is itself rounded to f64.
        let is_near = (coordinate - single).abs() <= 0.5 * unit + f64::EPSILON * coordinate;
        Self { is_shortest: false, is_near, is_tested: spacing > 4.0 * unit, first, decimals }
    }

    /// The same by printing.
    fn by_text(coordinate: f64, single: f32) -> Option<Self> {
        let (mut buffer, mut other) = (zmij::Buffer::new(), zmij::Buffer::new());
        let is_shortest = float(other.format_finite(single).as_bytes())? == coordinate;
        let text = buffer.format_finite(coordinate);
        let (digits, power) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
        let digits = digits.trim_start_matches('-').trim_end_matches(".0");
        let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
        let power: i32 = power.parse().ok()?;
        let leading = fraction.bytes().take_while(|&digit| digit == b'0').count() as i32;
        let first = if whole == "0" { -1 - leading } else { whole.len() as i32 - 1 };
        let zeros = if fraction.is_empty() { whole.len() - whole.trim_end_matches('0').len() } else { 0 };
        let (first, decimals) = (first + power, fraction.len() as i32 - zeros as i32 - power);
        let (magnitude, single) = (coordinate.abs(), f64::from(single.abs()));
        let spelling = Self { is_shortest, ..Self::new(magnitude, single, first, decimals) };
        (is_shortest || spelling.is_near || decimals <= most_decimals(magnitude)).then_some(spelling)
    }

    /// Whether the unit of its last digit is at most half the spacing of `f32`.
    fn is_fine(&self, coordinate: f64) -> bool {
        // Half a spacing is less than a unit of seven digits.
        if self.first + self.decimals < 7 {
            return false;
        }
        let spacing = num::power_of_two((num::exponent(coordinate) - 23).max(-149));
        2.0 * libm::exp10(-f64::from(self.decimals)) <= spacing
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Positions;
    use crate::num::test_numbers::Numbers;

    fn positions(spell: impl Fn(f64) -> String) -> Vec<DVec3> {
        let mut numbers = Numbers::new(5);
        let mut coordinate = |size: f64| spell(size * (2.0 * numbers.unit() - 1.0)).parse().unwrap();
        (0..40).map(|_| DVec3::from_array([0.1, 16.0, 300.0].map(&mut coordinate))).collect()
    }

    #[test]
    fn what_was_printed_from_singles_is_single_precision() {
        let exact = |x: f64| f64::from(x as f32).to_string();
        let printed = |x: f64| (x as f32).to_string();
        let read = positions(printed);
        assert_ne!(read, positions(exact));
        assert_eq!(storage_of_text(&[&read]), Storage::F32);
        assert_eq!(Positions::rounded(read, Storage::F32).view().to_vec(), positions(exact));
        // One number of its own is enough against it.
        let mut other = positions(printed);
        other[17].y = 0.1 + 0.2;
        assert_eq!(storage_of_text(&[&other]), Storage::F64);
    }

    /// As `%g` and C++ streams print.
    #[test]
    fn six_digits_of_large_and_small_numbers_are_singles_at_any_scale() {
        for scale in [1e-12, 1e-3, 1.0, 1e3, 1e9] {
            let read = positions(|x| format!("{:.5e}", scale * x));
            assert_eq!(storage_of_text(&[&read]), Storage::F32, "{scale}");
        }
    }

    /// As `%.9g`, `%.8f`, `%.12g`, `%.16g` and `%.17g` print, which are no shortest decimals.
    #[test]
    fn nine_digits_and_more_and_eight_decimals_of_singles_are_singles() {
        let spellings: [fn(f64) -> String; 5] = [
            |x| format!("{:.8e}", x as f32),
            |x| format!("{:.8}", x as f32),
            |x| format!("{:.11e}", x as f32),
            |x| format!("{:.15e}", x as f32),
            |x| format!("{:.16e}", x as f32),
        ];
        for spell in spellings {
            let read = positions(spell);
            assert_eq!(storage_of_text(&[&read]), Storage::F32, "{}", spell(0.1));
            assert_eq!(storage_of_text(&[&read[..3]]), Storage::F64, "too few to decide");
            let mut other = read.clone();
            other[17].y += 3e-7;
            assert_eq!(storage_of_text(&[&other]), Storage::F64, "one number is not near");
        }
    }

    #[test]
    fn decimals_and_doubles_stay_as_they_are() {
        let spellings: [fn(f64) -> String; 11] = [
            |x| x.to_string(),
            |x| format!("{x:.2}"),
            |x| format!("{x:.4}"),
            |x| format!("{x:.6}"),
            |x| format!("{x:.9}"),
            |x| format!("{x:.4e}"),
            |x| format!("{x:.7e}"),
            |x| format!("{x:.8e}"),
            |x| format!("{x:.11e}"),
            |x| format!("{x:.16e}"),
            |x| format!("{x:.8}"),
        ];
        for spell in spellings {
            assert_eq!(storage_of_text(&[&positions(spell)]), Storage::F64, "{}", spell(0.1));
        }
        // With 6 decimals numbers between 8 and 16 are as near to each other as singles there.
        let dozen: Vec<DVec3> = (0..99).map(|i| DVec3::splat(f64::from(12_000_001 + i) / 1e6)).collect();
        assert_eq!(storage_of_text(&[&dozen]), Storage::F64);
    }

    #[test]
    fn arithmetic_says_what_the_text_says() {
        let mut numbers = Numbers::new(6);
        let (mut told, mut shortest) = (0, 0);
        for _ in 0..200_000 {
            let size = libm::exp10(30.0 * numbers.unit() - 15.0) * numbers.unit();
            let single = size as f32;
            let nearest_power = num::power_of_two(num::exponent(size)) as f32;
            let spelled = [
                size.to_string(),
                single.to_string(),
                single.next_up().to_string(),
                nearest_power.to_string(),
                nearest_power.next_down().to_string(),
                format!("{size:.5e}"),
                format!("{size:.6e}"),
                format!("{size:.7e}"),
                format!("{size:.8e}"),
                format!("{size:.6}"),
                format!("{single:.11e}"),
                format!("{single:.16e}"),
                // Half way between two singles.
                f64::midpoint(f64::from(single), f64::from(single.next_up())).to_string(),
            ];
            for text in spelled {
                let x: f64 = text.parse().unwrap();
                let single = x as f32;
                if x == 0.0 || single == 0.0 {
                    continue;
                }
                if let Ok(spelling) = Spelling::by_arithmetic(x, f64::from(single)) {
                    told += 1;
                    shortest += usize::from(spelling.as_ref().is_some_and(|spelling| spelling.is_shortest));
                    assert_eq!(spelling, Spelling::by_text(x, single), "{text}");
                }
            }
        }
        // Only powers of two, numbers below 10⁻¹⁴ and what lies half way are left to the text.
        assert!(told > 1_700_000 && shortest > 700_000, "{told} {shortest}");
    }

    #[test]
    fn digits_are_counted_in_all_spellings() {
        for (x, first, decimals) in [
            (0.03, -2, 2),
            (12.0, 1, 0),
            (120.0, 2, -1),
            (-1.25e-7, -7, 9),
            (3e20, 20, -20),
            (1.5, 0, 1),
            (120.25, 2, 2),
            (1e-45, -45, 45),
        ] {
            let spelling = Spelling::of(x).unwrap();
            assert_eq!((spelling.first, spelling.decimals), (first, decimals), "{x}");
        }
        assert!(
            [0.1 + 0.2, f64::NAN, f64::INFINITY, 1e300, 1e-300]
                .into_iter()
                .all(|x| Spelling::of(x).is_none())
        );
    }
}
