//! The number types of PLY.

use crate::io::text::{float, push_f32, push_f64, push_integer};
use Scalar::{F32, F64, I8, I16, I32, U8, U16, U32};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Encoding {
    Ascii,
    Little,
    Big,
}

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

/// Evaluates an expression with the Rust type of a scalar.
macro_rules! with_type {
    ($scalar:expr, $number:ident => $value:expr) => {
        match $scalar {
            I8 => with_type!(i8, $number, $value),
            U8 => with_type!(u8, $number, $value),
            I16 => with_type!(i16, $number, $value),
            U16 => with_type!(u16, $number, $value),
            I32 => with_type!(i32, $number, $value),
            U32 => with_type!(u32, $number, $value),
            F32 => with_type!(f32, $number, $value),
            F64 => with_type!(f64, $number, $value),
        }
    };
    ($type:ty, $number:ident, $value:expr) => {{
        type $number = $type;
        $value
    }};
}

#[expect(clippy::useless_conversion, reason = "one of the types is f64 itself")]
impl Scalar {
    /// The type of a name, and whether the name has a size in it.
    pub fn from_name(name: &[u8]) -> Option<(Scalar, bool)> {
        NAMES.iter().find_map(|(scalar, plain, sized)| match name {
            _ if name == plain.as_bytes() => Some((*scalar, false)),
            _ if name == sized.as_bytes() => Some((*scalar, true)),
            _ => None,
        })
    }

    pub fn name(self, sized: bool) -> &'static str {
        let (_, plain, with_size) = NAMES[self as usize];
        if sized { with_size } else { plain }
    }

    pub fn size(self) -> usize {
        with_type!(self, Number => size_of::<Number>())
    }

    pub fn is_integer(self) -> bool {
        !matches!(self, F32 | F64)
    }

    /// The largest whole number up to which all can be stored.
    pub fn largest(self) -> f64 {
        match self {
            F32 => 16_777_216.0,
            F64 => 9_007_199_254_740_992.0,
            _ => with_type!(self, Number => f64::from(Number::MAX)),
        }
    }

    /// The number in `bytes`: exactly its binary bytes, or an ascii word. `None` if the word is not a number.
    #[inline]
    pub fn read(self, bytes: &[u8], encoding: Encoding) -> Option<f64> {
        if encoding == Encoding::Ascii {
            return float(bytes);
        }
        with_type!(self, Number => {
            let bytes = bytes.try_into().ok()?;
            let number = match encoding {
                Encoding::Big => Number::from_be_bytes(bytes),
                _ => Number::from_le_bytes(bytes),
            };
            Some(number.into())
        })
    }

    /// The value that this type stores for a number: rounded, integers saturated.
    pub fn round(self, value: f64) -> f64 {
        let value = if self.is_integer() { value.round() } else { value };
        with_type!(self, Number => f64::from(value as Number))
    }

    /// Appends a number, rounded to this type. Ascii words must be finite.
    pub fn push(self, out: &mut Vec<u8>, value: f64, encoding: Encoding) {
        let value = self.round(value);
        match (encoding, self) {
            (Encoding::Ascii, F32) => push_f32(out, value as f32),
            (Encoding::Ascii, F64) => push_f64(out, value),
            (Encoding::Ascii, _) => {
                if value < 0.0 {
                    out.push(b'-');
                }
                push_integer(out, value.abs() as u64);
            }
            (Encoding::Little, _) => {
                with_type!(self, Number => out.extend_from_slice(&(value as Number).to_le_bytes()));
            }
            (Encoding::Big, _) => {
                with_type!(self, Number => out.extend_from_slice(&(value as Number).to_be_bytes()));
            }
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
