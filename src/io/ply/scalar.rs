//! The number types of PLY.

use crate::io::text::format_number::{push_f32, push_f64, push_integer};
use crate::io::text::parse_number::float;

/// How the body of a file is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Encoding {
    Ascii,
    Little,
    Big,
}

/// A number type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

use Scalar::{F32, F64, I8, I16, I32, U8, U16, U32};

/// Both styles of names: those of the first readers, and those with sizes.
const NAMES: [(Scalar, &str, &str); 8] = [
    (I8, "char", "int8"),
    (U8, "uchar", "uint8"),
    (I16, "short", "int16"),
    (U16, "ushort", "uint16"),
    (I32, "int", "int32"),
    (U32, "uint", "uint32"),
    (F32, "float", "float32"),
    (F64, "double", "float64"),
];

impl Scalar {
    /// The type of a name, and whether the name has a size in it.
    pub fn from_name(name: &[u8]) -> Option<(Scalar, bool)> {
        NAMES.iter().find_map(|(scalar, plain, sized)| match name {
            _ if name == plain.as_bytes() => Some((*scalar, false)),
            _ if name == sized.as_bytes() => Some((*scalar, true)),
            _ => None,
        })
    }

    /// Its name in one of the two styles.
    pub fn name(self, sized: bool) -> &'static str {
        let (_, plain, with_size) = NAMES[self as usize];
        if sized { with_size } else { plain }
    }

    /// Bytes of a binary number.
    pub fn size(self) -> usize {
        match self {
            I8 | U8 => 1,
            I16 | U16 => 2,
            I32 | U32 | F32 => 4,
            F64 => 8,
        }
    }

    pub fn is_integer(self) -> bool {
        !matches!(self, F32 | F64)
    }

    /// The largest whole number up to which all can be held.
    pub fn largest(self) -> f64 {
        match self {
            I8 => f64::from(i8::MAX),
            U8 => f64::from(u8::MAX),
            I16 => f64::from(i16::MAX),
            U16 => f64::from(u16::MAX),
            I32 => f64::from(i32::MAX),
            U32 => f64::from(u32::MAX),
            F32 => 16_777_216.0,
            F64 => 9_007_199_254_740_992.0,
        }
    }

    /// What stands for 1 in a colour.
    pub fn full_scale(self) -> f64 {
        if self.is_integer() { self.largest() } else { 1.0 }
    }

    /// The number in `bytes`: exactly its binary bytes, or an ascii word. `None` if the word is no number.
    #[inline]
    pub fn read(self, bytes: &[u8], encoding: Encoding) -> Option<f64> {
        macro_rules! decode {
            ($number:ty) => {{
                let bytes = bytes.try_into().ok()?;
                match encoding {
                    Encoding::Big => <$number>::from_be_bytes(bytes).into(),
                    _ => <$number>::from_le_bytes(bytes).into(),
                }
            }};
        }
        Some(match self {
            _ if encoding == Encoding::Ascii => return float(bytes),
            I8 => decode!(i8),
            U8 => decode!(u8),
            I16 => decode!(i16),
            U16 => decode!(u16),
            I32 => decode!(i32),
            U32 => decode!(u32),
            F32 => decode!(f32),
            F64 => decode!(f64),
        })
    }

    /// What becomes of a number that is stored in this type: rounded, integers saturated.
    pub fn round(self, value: f64) -> f64 {
        match self {
            F32 => f64::from(value as f32),
            F64 => value,
            I8 => f64::from(value.round() as i8),
            U8 => f64::from(value.round() as u8),
            I16 => f64::from(value.round() as i16),
            U16 => f64::from(value.round() as u16),
            I32 => f64::from(value.round() as i32),
            U32 => f64::from(value.round() as u32),
        }
    }

    /// Appends a number, rounded to this type. Ascii words must be finite.
    pub fn push(self, out: &mut Vec<u8>, value: f64, encoding: Encoding) {
        let value = self.round(value);
        if encoding == Encoding::Ascii {
            return match self {
                F32 => push_f32(out, value as f32),
                F64 => push_f64(out, value),
                _ => {
                    if value < 0.0 {
                        out.push(b'-');
                    }
                    push_integer(out, value.abs() as u64);
                }
            };
        }
        let word = match self {
            F32 => u64::from((value as f32).to_bits()),
            F64 => value.to_bits(),
            _ => value as i64 as u64,
        };
        let bytes = word.to_le_bytes();
        let bytes = &bytes[..self.size()];
        match encoding {
            Encoding::Big => out.extend(bytes.iter().rev()),
            _ => out.extend_from_slice(bytes),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_come_back_in_every_type_and_encoding() {
        for (scalar, plain, sized) in NAMES {
            assert_eq!(Scalar::from_name(plain.as_bytes()), Some((scalar, false)));
            assert_eq!(Scalar::from_name(sized.as_bytes()), Some((scalar, true)));
            assert_eq!((scalar.name(false), scalar.name(true)), (plain, sized));
            for value in [0.0, 1.0, -1.0, 100.0, -100.0, 0.5, 1e9, -1e9, 3e38, 0.1] {
                for encoding in [Encoding::Ascii, Encoding::Little, Encoding::Big] {
                    let mut bytes = Vec::new();
                    scalar.push(&mut bytes, value, encoding);
                    // The shortest decimal of a float is no float itself.
                    let back = scalar.read(&bytes, encoding).map(|value| scalar.round(value));
                    assert_eq!(back, Some(scalar.round(value)), "{scalar:?} {value}");
                    assert!(encoding == Encoding::Ascii || bytes.len() == scalar.size());
                }
            }
        }
        assert_eq!(I16.read(&[0x80, 0x01], Encoding::Big), Some(-32767.0));
        assert_eq!(I16.read(&[0x80, 0x01], Encoding::Little), Some(384.0));
        assert_eq!(U32.read(&[1, 0, 0, 0x80], Encoding::Little), Some(2_147_483_649.0));
    }
}
