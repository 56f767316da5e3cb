//! Numbers to text, for every format that is text.

use crate::mesh::Storage;

/// Appends the shortest decimal that reads back as the same `f32`. The number must be finite.
pub(in crate::io) fn push_f32(out: &mut Vec<u8>, value: f32) {
    push_trimmed(out, zmij::Buffer::new().format_finite(value));
}

/// Appends the shortest decimal that reads back as the same `f64`. The number must be finite.
pub(in crate::io) fn push_f64(out: &mut Vec<u8>, value: f64) {
    push_trimmed(out, zmij::Buffer::new().format_finite(value));
}

/// Appends a keyword and numbers, with the digits that this precision needs.
pub(in crate::io) fn push_row(out: &mut Vec<u8>, keyword: &str, storage: Storage, values: &[f64]) {
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

/// Appends a whole number.
pub(in crate::io) fn push_integer(out: &mut Vec<u8>, mut value: u64) {
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
