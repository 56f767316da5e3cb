//! Decimal text to numbers, correctly rounded.
//!
//! Digits are taken eight at a time in one 64-bit word. A decimal of at most 2⁵³ times or over a power of ten up
//! to 10²² is one correctly rounded operation on exact operands (Clinger 1990, "How to read floating point numbers
//! accurately"); everything else goes to `fast-float2` (Lemire 2021, "Number parsing at a gigabyte per second").

use crate::mesh::Storage;

/// The powers of ten that an `f64` holds exactly.
pub const EXACT_POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18,
    1e19, 1e20, 1e21, 1e22,
];

const INTEGER_POWERS: [u64; 9] = [1, 10, 100, 1_000, 10_000, 100_000, 1_000_000, 10_000_000, 100_000_000];

/// Digits that a `u64` holds whatever they are.
const SAFE_DIGITS: usize = 19;

/// The value and the number of the ASCII digits at the front of a little-endian word, the first in the lowest byte.
#[inline]
fn leading_digits(word: u64) -> (u64, usize) {
    let values = word ^ 0x3030_3030_3030_3030;
    // The top bit of each byte that is no digit; carries only disturb bytes behind the first such.
    let others = (values.wrapping_add(0x7676_7676_7676_7676) | values) & 0x8080_8080_8080_8080;
    let count = others.trailing_zeros() as usize / 8;
    if count == 0 {
        return (0, 0);
    }
    // Zeros come in front, then eight digits are added up by pairs, fours, eight.
    let digits = values << (64 - 8 * count);
    let pairs = digits.wrapping_mul(10).wrapping_add(digits >> 8);
    let high = (pairs & 0x0000_00ff_0000_00ff).wrapping_mul(0x000f_4240_0000_0064);
    let low = ((pairs >> 16) & 0x0000_00ff_0000_00ff).wrapping_mul(0x0000_2710_0000_0001);
    (high.wrapping_add(low) >> 32, count)
}

/// Eight bytes at `at`, filled up behind the end of the text.
#[inline]
fn word_at(text: &[u8], at: usize) -> u64 {
    match text.get(at..at + 8) {
        Some(bytes) => u64::from_le_bytes(bytes.try_into().unwrap_or_default()),
        None => {
            let mut bytes = [b' '; 8];
            let rest = text.get(at..).unwrap_or_default();
            bytes[..rest.len()].copy_from_slice(rest);
            u64::from_le_bytes(bytes)
        }
    }
}

/// Adds the digits at `at` to `mantissa`, which wraps if there are too many, and returns where they end.
#[inline]
fn digits(text: &[u8], mut at: usize, mantissa: &mut u64) -> usize {
    loop {
        let (value, count) = leading_digits(word_at(text, at));
        *mantissa = mantissa.wrapping_mul(INTEGER_POWERS[count]).wrapping_add(value);
        at += count;
        if count < 8 {
            return at;
        }
    }
}

/// The number at the front of a text and its length; `None` if there is none, or if only [`float`] can read it.
#[inline]
pub fn float_prefix(text: &[u8]) -> Option<(f64, usize)> {
    let first = *text.first()?;
    let negative = first == b'-';
    let start = usize::from(negative || first == b'+');
    let mut mantissa = 0;
    let mut at = digits(text, start, &mut mantissa);
    let mut count = at - start;
    let mut exponent = 0;
    if text.get(at) == Some(&b'.') {
        let point = at + 1;
        at = digits(text, point, &mut mantissa);
        count += at - point;
        exponent = -((at - point) as i64);
    }
    if count == 0 || count > SAFE_DIGITS || mantissa > 1 << 53 {
        return None;
    }
    if let Some(b'e' | b'E') = text.get(at) {
        let (value, length) = integer_prefix(&text[at + 1..])?;
        exponent = exponent.saturating_add(value);
        at += 1 + length;
    }
    let power = *EXACT_POWERS.get(usize::try_from(exponent.unsigned_abs()).ok()?)?;
    let size = if exponent < 0 { mantissa as f64 / power } else { mantissa as f64 * power };
    Some((if negative { -size } else { size }, at))
}

/// The number that a whole token spells, C's `nan(…)`, `-nan(ind)`, `1.#INF` and `-1.#IND` included; `None` if it is none.
pub fn float(token: &[u8]) -> Option<f64> {
    if let Some((value, length)) = float_prefix(token)
        && length == token.len()
    {
        return Some(value);
    }
    let (sign, size) = match token {
        [b'-', size @ ..] => (-1.0, size),
        [b'+', size @ ..] => (1.0, size),
        size => (1.0, size),
    };
    // A second sign is no number, though the parser below would take it.
    if matches!(size.first(), None | Some(b'-' | b'+')) {
        return None;
    }
    if let Ok(value) = fast_float2::parse::<f64, _>(size) {
        return Some(sign * value);
    }
    let lower = size.to_ascii_lowercase();
    if lower.starts_with(b"nan(") && lower.ends_with(b")") {
        return Some(f64::NAN);
    }
    match lower.strip_prefix(b"1.#")? {
        [b'i', b'n', b'f', ..] => Some(sign * f64::INFINITY),
        [b'i', b'n', b'd', ..] | [b'q', b'n', b'a', b'n', ..] | [b's', b'n', b'a', b'n', ..] => {
            Some(f64::NAN)
        }
        _ => None,
    }
}

/// The integer at the front of a text, with or without a sign, and its length. Beyond `i64` it is the nearest of that.
#[inline]
pub fn integer_prefix(text: &[u8]) -> Option<(i64, usize)> {
    let first = *text.first()?;
    let negative = first == b'-';
    let start = usize::from(negative || first == b'+');
    let mut size = 0;
    let end = digits(text, start, &mut size);
    if end == start {
        return None;
    }
    let size = if end - start < SAFE_DIGITS { size as i64 } else { saturated(&text[start..end]) };
    Some((if negative { -size } else { size }, end))
}

#[cold]
fn saturated(digits: &[u8]) -> i64 {
    digits.iter().fold(0_i64, |value, digit| value.saturating_mul(10).saturating_add(i64::from(digit - b'0')))
}

/// Appends the shortest decimal that reads back as the same `f32`. The number must be finite.
pub fn push_f32(out: &mut Vec<u8>, value: f32) {
    push_trimmed(out, zmij::Buffer::new().format_finite(value));
}

/// Appends the shortest decimal that reads back as the same `f64`. The number must be finite.
pub fn push_f64(out: &mut Vec<u8>, value: f64) {
    push_trimmed(out, zmij::Buffer::new().format_finite(value));
}

/// Appends a keyword and numbers, with the digits that this precision needs.
pub fn push_row(out: &mut Vec<u8>, keyword: &str, storage: Storage, values: &[f64]) {
    out.extend_from_slice(keyword.as_bytes());
    for &value in values {
        out.push(b' ');
        match storage {
            Storage::F32 => push_f32(out, value as f32),
            Storage::F64 => push_f64(out, value),
        }
    }
}

/// Writes `1.0` as `1`.
fn push_trimmed(out: &mut Vec<u8>, text: &str) {
    out.extend_from_slice(text.strip_suffix(".0").unwrap_or(text).as_bytes());
}

pub fn push_integer(out: &mut Vec<u8>, mut value: u64) {
    const LONGEST: usize = 20;
    let mut digits = [0; LONGEST];
    let mut start = LONGEST;
    loop {
        start -= 1;
        digits[start] = b'0' + (value % 10) as u8;
        value /= 10;
        if value == 0 {
            return out.extend_from_slice(&digits[start..]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A small generator: the same spellings each time.
    struct Random(u64);

    impl Random {
        fn next(&mut self) -> u64 {
            self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
            let mut z = self.0;
            z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
            z ^ (z >> 31)
        }

        fn below(&mut self, bound: u64) -> u64 {
            self.next() % bound
        }

        fn digits(&mut self, most: u64, into: &mut String) {
            for _ in 0..self.below(most + 1) {
                into.push((b'0' + self.below(10) as u8) as char);
            }
        }

        fn spelling(&mut self) -> String {
            let mut text = ["", "", "-", "+"][self.below(4) as usize].to_owned();
            let most = if self.below(8) == 0 { 24 } else { 9 };
            self.digits(most, &mut text);
            if self.below(4) != 0 {
                text.push('.');
                self.digits(most, &mut text);
            }
            if self.below(3) == 0 {
                text.push_str(["e", "E", "e-", "e+"][self.below(4) as usize]);
                let most = [10, 30, 340][self.below(3) as usize];
                text.push_str(&self.below(most).to_string());
            }
            text
        }
    }

    #[test]
    fn a_million_spellings_are_rounded_correctly() {
        let mut random = Random(1);
        let mut quick = 0;
        for _ in 0..1_000_000 {
            let text = random.spelling();
            let truth = text.parse::<f64>().ok();
            assert_eq!(float(text.as_bytes()).map(f64::to_bits), truth.map(f64::to_bits), "{text}");
            if let Some((value, length)) = float_prefix(text.as_bytes())
                && length == text.len()
            {
                assert_eq!(Some(value.to_bits()), truth.map(f64::to_bits), "{text}");
                quick += 1;
            }
        }
        assert!(quick > 300_000, "the fast path took {quick}");
    }

    #[test]
    fn doubles_come_back_from_their_own_spelling() {
        let mut random = Random(2);
        for _ in 0..100_000 {
            let value = f64::from_bits(random.next());
            if value.is_finite() {
                assert_eq!(float(format!("{value:e}").as_bytes()).map(f64::to_bits), Some(value.to_bits()));
            }
        }
    }

    #[test]
    fn words_of_digits_are_added_up() {
        for (text, expected) in [
            ("12345678", (12_345_678, 8)),
            ("00000000", (0, 8)),
            ("99999999", (99_999_999, 8)),
            ("1 345678", (1, 1)),
            ("12/45678", (12, 2)),
            ("1234567:", (1_234_567, 7)),
            ("/2345678", (0, 0)),
        ] {
            assert_eq!(leading_digits(word_at(text.as_bytes(), 0)), expected, "{text}");
        }
        assert_eq!(leading_digits(u64::from_le_bytes(*b"123\xff5678")), (123, 3));
    }

    #[test]
    fn unusual_numbers_are_numbers_and_others_are_not() {
        for (text, expected) in [
            ("1.", 1.0),
            (".5", 0.5),
            ("+1", 1.0),
            ("1e5", 1e5),
            ("2.e1", 20.0),
            ("1E-2", 0.01),
            ("-0", -0.0),
        ] {
            assert_eq!(float(text.as_bytes()).map(f64::to_bits), Some(f64::to_bits(expected)), "{text}");
        }
        for text in ["nan", "NaN(0x1)", "-nan(ind)", "-1.#IND", "1.#QNAN0"] {
            assert!(float(text.as_bytes()).is_some_and(f64::is_nan), "{text}");
        }
        for text in ["inf", "+Inf", "-infinity", "1.#INF00", "1e400", "-1.#INF"] {
            assert!(float(text.as_bytes()).is_some_and(f64::is_infinite), "{text}");
        }
        for text in
            ["", "-", ".", "e5", "1e", "1d0", "0,5", "3.1+e2", "--1", "+-1", "1.#", "nanx", "0x10", "1_0"]
        {
            assert_eq!(float(text.as_bytes()), None, "{text}");
        }
    }

    #[test]
    fn indices_saturate() {
        assert_eq!(integer_prefix(b"12/3"), Some((12, 2)));
        assert_eq!(integer_prefix(b"-7 "), Some((-7, 2)));
        assert_eq!(integer_prefix(b"123456789012345678 "), Some((123_456_789_012_345_678, 18)));
        assert_eq!(integer_prefix(b"99999999999999999999999"), Some((i64::MAX, 23)));
        assert_eq!(integer_prefix(b"-9223372036854775809"), Some((-i64::MAX, 20)));
        assert_eq!(integer_prefix(b"00000000000000000000012"), Some((12, 23)));
        assert_eq!(integer_prefix(b"/3"), None);
        assert_eq!(integer_prefix(b""), None);
    }

    fn said(push: impl Fn(&mut Vec<u8>)) -> String {
        let mut out = Vec::new();
        push(&mut out);
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn numbers_are_short_and_come_back() {
        for (value, text) in
            [(1.0, "1"), (-0.0, "-0"), (0.1, "0.1"), (0.577_350_26, "0.57735026"), (-2.5, "-2.5")]
        {
            assert_eq!(said(|out| push_f32(out, value)), text);
        }
        for value in [f32::MIN_POSITIVE, f32::MAX, 1e-45, 16_777_216.0, 1e10, 123_456.79] {
            assert_eq!(said(|out| push_f32(out, value)).parse(), Ok(value));
        }
        for value in [f64::MIN_POSITIVE, f64::MAX, 5e-324, 1e22, 0.1 + 0.2] {
            assert_eq!(said(|out| push_f64(out, value)).parse(), Ok(value));
        }
    }

    #[test]
    fn integers_have_no_leading_zeros() {
        for value in [0, 7, 10, 99, 100, 4_294_967_295, u64::MAX] {
            assert_eq!(said(|out| push_integer(out, value)), value.to_string());
        }
    }
}
