//! New binary data, and the JSON that describes them.

use super::accessor::{float, number};
use super::glb::padded;
use super::records::{Component, Format, SHAPES};
use crate::io::NormalFormat;
use bytemuck::NoUninit;
use glam::DVec3;
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

impl Target {
    /// From one element to the next, where elements do not fill whole multiples of four, as those of vertices must.
    pub fn stride(self, format: Format) -> Option<usize> {
        let size = format.size();
        (self == Target::Vertices && padded(size) != size).then(|| padded(size))
    }
}

pub trait Bytes {
    fn bytes(&self) -> &[u8];
}

impl<T: NoUninit> Bytes for Vec<T> {
    fn bytes(&self) -> &[u8] {
        bytemuck::cast_slice(self)
    }
}

impl<T: NoUninit> Bytes for Cow<'_, [T]> {
    fn bytes(&self) -> &[u8] {
        bytemuck::cast_slice(self)
    }
}

/// The JSON of a buffer view. A stride is given where elements do not fill whole multiples of four.
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
    let (kind, code) = (SHAPES[format.width - 1].0, format.component.as_gl_enum());
    let mut json = format!("{{\"bufferView\":{view},\"componentType\":{code}");
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

/// Bounds in the units of the storage, as `min` and `max` are.
pub fn bounds(bytes: &[u8], format: Format) -> Bounds {
    let (size, width) = (format.component.size(), format.width * format.columns);
    let (mut low, mut high) = (vec![f64::INFINITY; width], vec![f64::NEG_INFINITY; width]);
    for element in bytes.chunks_exact(format.size()) {
        for (axis, bytes) in element.chunks_exact(size).take(width).enumerate() {
            let value = number(bytes, format.component);
            low[axis] = low[axis].min(value);
            high[axis] = high[axis].max(value);
        }
    }
    Bounds { low, high }
}

/// A list of numbers, each in the shortest spelling that reads back as the same double.
pub fn number_list(numbers: &[f64]) -> String {
    let spelt: Vec<String> =
        numbers.iter().map(|&number| serde_json::Value::from(number).to_string()).collect();
    format!("[{}]", spelt.join(","))
}

/// Pieces that make up a buffer, each at a multiple of four.
#[derive(Default)]
pub struct Blob<'a> {
    pieces: Vec<Box<dyn Bytes + 'a>>,
    pub length: u64,
}

impl<'a> Blob<'a> {
    pub fn push(&mut self, piece: impl Bytes + 'a) -> u64 {
        let offset = self.length;
        self.length += padded(piece.bytes().len()) as u64;
        self.pieces.push(Box::new(piece));
        offset
    }

    /// Appends the bytes, fillers included. Each piece is freed when it is copied.
    pub fn append_to(&mut self, out: &mut Vec<u8>) {
        for piece in self.pieces.drain(..) {
            let end = out.len() + padded(piece.bytes().len());
            out.extend_from_slice(piece.bytes());
            out.resize(end, 0);
        }
    }
}

/// How the normals of a primitive are to be stored, from how they were.
pub fn normal_format(stored: Option<Format>, wanted: NormalFormat) -> Format {
    let as_stored = stored.filter(|format| format.component == Component::F32 || format.normalized);
    match wanted {
        NormalFormat::Same => as_stored.unwrap_or(Format::vector(Component::F32, false, 3)),
        NormalFormat::F32 => Format::vector(Component::F32, false, 3),
        NormalFormat::I16 => Format::vector(Component::I16, true, 3),
        NormalFormat::I8 => Format::vector(Component::I8, true, 3),
    }
}

/// Appends a unit vector. −0 is stored as +0, so that equal vectors are equal bytes.
pub fn push_normal(normal: DVec3, format: Format, out: &mut Vec<u8>) {
    match format.component {
        Component::I8 => out.extend(steps(normal, 127).iter().map(|&step| step as i8 as u8)),
        Component::I16 => {
            out.extend(steps(normal, 32767).iter().flat_map(|&step| (step as i16).to_le_bytes()))
        }
        _ => push_floats(normal, out),
    }
}

/// Appends a unit vector and its handedness.
pub fn push_tangent(tangent: DVec3, handedness: f32, format: Format, out: &mut Vec<u8>) {
    push_normal(tangent, format, out);
    match format.component {
        Component::I8 => out.push((127.0 * handedness) as i8 as u8),
        Component::I16 => out.extend(((32767.0 * handedness) as i16).to_le_bytes()),
        _ => out.extend(handedness.to_le_bytes()),
    }
}

pub fn push_floats(vector: DVec3, out: &mut Vec<u8>) {
    out.extend(vector.as_vec3().to_array().iter().flat_map(|x| (x + 0.0).to_le_bytes()));
}

impl NormalFormat {
    /// Makes unit normals what a reader finds once they are stored: three numbers, which rounding leaves a little longer or shorter
    /// than 1.
    pub fn round(self, normals: &mut [DVec3]) {
        let format = normal_format(None, self);
        let mut bytes = Vec::with_capacity(format.size());
        for normal in normals {
            bytes.clear();
            push_normal(*normal, format, &mut bytes);
            let number = |bytes| f64::from(float(bytes, format.component, format.normalized));
            let mut numbers = bytes.chunks_exact(format.component.size()).map(number);
            *normal = DVec3::from_array(std::array::from_fn(|_| numbers.next().unwrap_or_default()));
        }
    }
}

/// The bound that the glTF validator puts on |length - 1|.
pub const LENGTH_TOLERANCE: f64 = 0.00674;

/// A unit vector in steps of 1/`most`: rounded, or if its length is then too far from 1, the nearest of the 8 grid points around.
pub fn steps(normal: DVec3, most: i32) -> [i32; 3] {
    let scaled = normal * f64::from(most);
    let rounded = scaled.round();
    let is_unit = |steps: DVec3| ((steps / f64::from(most)).length() - 1.0).abs() < LENGTH_TOLERANCE;
    let nearest = if is_unit(rounded) {
        rounded
    } else {
        let floor = scaled.floor();
        let corner = |bits: u32| floor + DVec3::from_array([0, 1, 2].map(|axis| f64::from(bits >> axis & 1)));
        let good = (0..8).map(corner).filter(|&corner| is_unit(corner));
        let distance = |corner: &DVec3| corner.distance_squared(scaled);
        good.min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or(rounded)
    };
    nearest.to_array().map(|step| (step as i32).clamp(-most, most))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn eight_bits_are_always_a_unit_vector_for_the_validator() {
        let mut worst: f64 = 0.0;
        for i in 0..300 {
            for j in 0..300 {
                let (z, turn) = (f64::from(i) / 150.0 - 1.0, f64::from(j) * std::f64::consts::TAU / 300.0);
                let radius = (1.0 - z * z).max(0.0).sqrt();
                let normal = DVec3::new(radius * libm::cos(turn), radius * libm::sin(turn), z);
                let stored = DVec3::from_array(steps(normal, 127).map(f64::from)) / 127.0;
                assert!((stored.length() - 1.0).abs() < LENGTH_TOLERANCE);
                worst = worst.max((stored - normal).length());
            }
        }
        // Half a step along each axis, √3/254 = 6.8e-3, and a little more where rounding was not enough.
        assert!(worst < 8e-3, "{worst}");
    }

    /// The bounds of `StoredFormat::worst_angle`, and that storing twice changes nothing.
    #[test]
    fn stored_normals_are_near_and_stay() {
        let bounds = [(NormalFormat::F32, 5.2e-8), (NormalFormat::I16, 2.65e-5), (NormalFormat::I8, 6.95e-3)];
        for (format, bound) in bounds {
            let mut worst: f64 = 0.0;
            for i in 0..400 {
                for j in 0..400 {
                    let (z, turn) =
                        (f64::from(i) / 200.0 - 1.0, f64::from(j) * std::f64::consts::TAU / 400.0);
                    let radius = (1.0 - z * z).max(0.0).sqrt();
                    let normal = DVec3::new(radius * libm::cos(turn), radius * libm::sin(turn), z);
                    let mut stored = [normal.normalize()];
                    format.round(&mut stored);
                    worst = worst.max(stored[0].distance(normal));
                    let mut again = stored;
                    format.round(&mut again);
                    assert_eq!(again, stored, "{format:?}");
                }
            }
            assert!(worst < bound && worst > 0.7 * bound, "{format:?}: {worst}");
        }
    }

    #[test]
    fn stored_steps_survive() {
        for step in -127..=127_i32 {
            let x = f64::from((step as f32) / 127.0);
            assert_eq!((x * 127.0).round() as i32, step);
        }
        let mut bytes = Vec::new();
        push_normal(DVec3::new(-0.0, 0.0, 1.0), Format::vector(Component::F32, false, 3), &mut bytes);
        assert_eq!(bytes, [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 128, 63]);
    }

    #[test]
    fn the_format_follows_the_file_unless_specified() {
        let float = Format::vector(Component::F32, false, 3);
        let byte = Format::vector(Component::I8, true, 3);
        assert_eq!(normal_format(Some(byte), NormalFormat::Same), byte);
        assert_eq!(normal_format(Some(Format { normalized: false, ..byte }), NormalFormat::Same), float);
        assert_eq!(normal_format(Some(byte), NormalFormat::F32), float);
        assert_eq!(normal_format(None, NormalFormat::Same), float);
        assert_eq!(normal_format(Some(float), NormalFormat::I16).component, Component::I16);
    }
}
