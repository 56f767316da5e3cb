//! Coordinates in text that were printed from single precision, or with no more digits than that holds.

use super::numbers::{EXACT_POWERS, float};
use crate::mesh::Storage;
use crate::num;
use glam::DVec3;
use rayon::prelude::*;

/// How many coordinates must agree: by chance, a double looks like a printed `f32` with a probability of at most one half.
const ENOUGH: usize = 20;

/// The digits of a floating-point number that C, C++ and Python print by default.
const DIGITS: i32 = 6;

/// Finds whether the coordinates of a text were printed from `f32`. If so, round them to `f32`.
///
/// The shortest decimal of an `f32` is a different `f64`, up to half a spacing away, which rotates the normal of a sliver by many
/// degrees. The coordinates were `f32` if each has the shortest spelling of one, and enough of them end in a digit finer than
/// single precision or have fewer decimals the larger they are. Numbers with a fixed count of decimals stay unchanged.
pub fn storage_of_text(parts: &[&[DVec3]]) -> Storage {
    let all = parts.par_iter().flat_map(|part| part.par_iter());
    let spellings = all.try_fold(Spellings::default, Spellings::with);
    let spellings = spellings.try_reduce(Spellings::default, |a, b| Some(a.and(&b)));
    let are_singles = |spellings: Spellings| spellings.fine >= ENOUGH || spellings.is_floating();
    if spellings.is_some_and(are_singles) { Storage::F32 } else { Storage::F64 }
}

/// The powers of ten of first digits of `f32`: from 10⁻⁴⁵ to 10³⁸.
const DECADES: usize = 84;
const LOWEST: i32 = -45;

/// Counts of coordinates that are all the shortest decimals of `f32`.
struct Spellings {
    /// How many end in a digit whose unit is at most half the spacing of `f32` there.
    fine: usize,
    /// How many have their first digit at each power of ten, and the most decimals that one of them has.
    decades: [(usize, i32); DECADES],
}

impl Default for Spellings {
    fn default() -> Self {
        Self { fine: 0, decades: [(0, i32::MIN); DECADES] }
    }
}

impl Spellings {
    /// Adds a position; `None` if it is not spelled that way.
    fn with(mut self, position: &DVec3) -> Option<Self> {
        for coordinate in position.to_array().into_iter().filter(|&coordinate| coordinate != 0.0) {
            let spelling = Spelling::of(coordinate)?;
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
        self.fine += other.fine;
        for (own, other) in self.decades.iter_mut().zip(other.decades) {
            *own = (own.0 + other.0, own.1.max(other.1));
        }
        self
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

/// The shortest decimal that reads back as an `f32`.
#[derive(Debug, PartialEq)]
struct Spelling {
    /// The power of ten of the first digit.
    first: i32,
    /// How many decimals it has; negative if it ends in zeros before the point.
    decimals: i32,
}

/// Arithmetic in `f64` cannot decide: the text must be compared.
struct Unclear;

/// The relative error of a distance: some 2⁻²⁰ of the spacing of `f32`, 2⁹ times the rounding error of an `f64`.
const MARGIN: f64 = 1e-6;

impl Spelling {
    /// The spelling of a coordinate other than 0; `None` if it is not the shortest decimal of an `f32`.
    fn of(coordinate: f64) -> Option<Self> {
        let single = coordinate as f32;
        if !single.is_finite() || single == 0.0 {
            return None;
        }
        Self::by_arithmetic(coordinate.abs(), f64::from(single.abs()))
            .unwrap_or_else(|Unclear| Self::by_text(coordinate, single))
    }

    /// The same for a positive coordinate: the decimal with the fewest digits that reads as the `f32`. Much faster than printing.
    fn by_arithmetic(coordinate: f64, single: f64) -> Result<Option<Self>, Unclear> {
        // No less than the power of ten of the first digit, less one: nine digits or ten come before the point.
        let decade = (num::exponent(coordinate) * 1233) >> 12;
        let scale = 8 - decade;
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
            return Ok(None);
        }
        let (mut digits, mut decimals) = (digits as u64, scale);
        while digits.is_multiple_of(10) {
            (digits, decimals) = (digits / 10, decimals - 1);
        }
        let first = digits.ilog10() as i32 - decimals;
        let spelling = Self { first, decimals };
        // An f32 keeps all numbers of so few digits, so no other of them reads as the same.
        if first + decimals < DIGITS {
            return Ok(Some(spelling));
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
        Ok(is_shortest.then_some(spelling))
    }

    /// The same by printing the single.
    fn by_text(coordinate: f64, single: f32) -> Option<Self> {
        let mut buffer = zmij::Buffer::new();
        let text = buffer.format_finite(single);
        if float(text.as_bytes())? != coordinate {
            return None;
        }
        let (digits, power) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
        let digits = digits.trim_start_matches('-').trim_end_matches(".0");
        let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
        let power: i32 = power.parse().ok()?;
        let leading = fraction.bytes().take_while(|&digit| digit == b'0').count() as i32;
        let first = if whole == "0" { -1 - leading } else { whole.len() as i32 - 1 };
        let zeros = if fraction.is_empty() { whole.len() - whole.trim_end_matches('0').len() } else { 0 };
        Some(Self { first: first + power, decimals: fraction.len() as i32 - zeros as i32 - power })
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

    #[test]
    fn decimals_and_doubles_stay_as_they_are() {
        let spellings: [fn(f64) -> String; 7] = [
            |x| x.to_string(),
            |x| format!("{x:.2}"),
            |x| format!("{x:.4}"),
            |x| format!("{x:.6}"),
            |x| format!("{x:.9}"),
            |x| format!("{x:.4e}"),
            |x| format!("{x:.7e}"),
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
                    shortest += usize::from(spelling.is_some());
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
