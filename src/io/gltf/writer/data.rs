//! New binary data, and the JSON that describes them.

use crate::io::gltf::container::glb::padded;
use crate::io::gltf::document::records::{Component, Format};
use std::borrow::Cow;
use std::fmt::Write as _;

// glTF is little-endian, and arrays are stored as they lie in memory.
const _: () = assert!(cfg!(target_endian = "little"), "a big-endian machine needs byte swaps here");

/// What a view is for: glTF's codes for vertex attributes and for indices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    Vertices = 34962,
    Indices = 34963,
}

/// An array that becomes a buffer view of its own.
#[derive(Clone, Debug)]
pub enum Array<'a> {
    Vec2(Vec<[f32; 2]>),
    Vec3(Vec<[f32; 3]>),
    Vec4(Vec<[f32; 4]>),
    /// Three numbers from −1 to 1 and a filler, since elements begin at multiples of four bytes.
    Bytes3(Vec<[i8; 4]>),
    /// The same in 16 bits.
    Shorts3(Vec<[i16; 4]>),
    U16(Vec<u16>),
    U32(Cow<'a, [u32]>),
}

impl Array<'_> {
    /// Indices in the smallest type of two or four bytes that has room; the largest value of each is forbidden.
    pub fn indices(indices: Cow<'_, [u32]>, vertices: usize) -> Array<'_> {
        if vertices <= usize::from(u16::MAX) {
            Array::U16(indices.iter().map(|&index| index as u16).collect())
        } else {
            Array::U32(indices)
        }
    }

    pub fn bytes(&self) -> &[u8] {
        match self {
            Array::Vec2(values) => bytemuck::cast_slice(values),
            Array::Vec3(values) => bytemuck::cast_slice(values),
            Array::Vec4(values) => bytemuck::cast_slice(values),
            Array::Bytes3(values) => bytemuck::cast_slice(values),
            Array::Shorts3(values) => bytemuck::cast_slice(values),
            Array::U16(values) => bytemuck::cast_slice(values),
            Array::U32(values) => bytemuck::cast_slice(values),
        }
    }

    /// How many elements it has.
    pub fn count(&self) -> usize {
        self.bytes().len() / self.stride().unwrap_or(self.format().size())
    }

    /// From the beginning of an element to that of the next, where fillers are between them.
    pub fn stride(&self) -> Option<usize> {
        match self {
            Array::Bytes3(_) => Some(size_of::<[i8; 4]>()),
            Array::Shorts3(_) => Some(size_of::<[i16; 4]>()),
            _ => None,
        }
    }

    pub fn format(&self) -> Format {
        match self {
            Array::Vec2(_) => Format::vector(Component::F32, false, 2),
            Array::Vec3(_) => Format::vector(Component::F32, false, 3),
            Array::Vec4(_) => Format::vector(Component::F32, false, 4),
            Array::Bytes3(_) => Format::vector(Component::I8, true, 3),
            Array::Shorts3(_) => Format::vector(Component::I16, true, 3),
            Array::U16(_) => Format::vector(Component::U16, false, 1),
            Array::U32(_) => Format::vector(Component::U32, false, 1),
        }
    }
}

/// The JSON of a buffer view. A stride is told where elements do not fill whole multiples of four.
pub fn view_json(buffer: usize, offset: u64, length: usize, stride: Option<usize>, target: Target) -> String {
    let mut json = format!("{{\"buffer\":{buffer},\"byteOffset\":{offset},\"byteLength\":{length}");
    if let Some(stride) = stride {
        let _ = write!(json, ",\"byteStride\":{stride}");
    }
    let _ = write!(json, ",\"target\":{}}}", target as u32);
    json
}

/// The JSON of an accessor that fills a view from its start.
pub fn accessor_json(view: usize, format: Format, count: usize, bounds: Option<&Bounds>) -> String {
    let kind = ["SCALAR", "VEC2", "VEC3", "VEC4"][format.width - 1];
    let mut json = format!("{{\"bufferView\":{view},\"componentType\":{}", format.component.as_gl_enum());
    if format.normalized {
        json.push_str(",\"normalized\":true");
    }
    let _ = write!(json, ",\"count\":{count},\"type\":\"{kind}\"");
    if let Some(bounds) = bounds {
        let _ = write!(json, ",\"min\":{},\"max\":{}", number_list(&bounds.low), number_list(&bounds.high));
    }
    json.push('}');
    json
}

/// Smallest and largest value of each component, in the units of the storage.
#[derive(Clone, Debug, PartialEq)]
pub struct Bounds {
    pub low: Vec<f64>,
    pub high: Vec<f64>,
}

/// A list of numbers, each in the shortest spelling that reads back as the same double.
pub fn number_list(numbers: &[f64]) -> String {
    let spelt: Vec<String> =
        numbers.iter().map(|&number| serde_json::Value::from(number).to_string()).collect();
    format!("[{}]", spelt.join(","))
}

/// Pieces that make up a buffer, each at a multiple of four.
#[derive(Clone, Debug, Default)]
pub struct Blob<'a> {
    pub arrays: Vec<Array<'a>>,
    pub length: u64,
}

impl<'a> Blob<'a> {
    /// Adds an array and returns where it begins.
    pub fn push(&mut self, array: Array<'a>) -> u64 {
        let offset = self.length;
        self.length += padded(array.bytes().len()) as u64;
        self.arrays.push(array);
        offset
    }

    /// The bytes, piece by piece, fillers included.
    pub fn pieces(&self) -> Vec<&[u8]> {
        const FILLER: [u8; 4] = [0; 4];
        let bytes = self.arrays.iter().map(Array::bytes);
        bytes.flat_map(|bytes| [bytes, &FILLER[..padded(bytes.len()) - bytes.len()]]).collect()
    }
}
