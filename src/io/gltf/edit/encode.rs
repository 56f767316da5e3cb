//! Encoding of normals.

use crate::io::NormalFormat;
use crate::io::gltf::document::records::{Component, Format};
use glam::DVec3;

/// How the normals of a primitive are to be stored, from how they were.
pub fn format(stored: Option<Format>, wanted: NormalFormat) -> Format {
    let as_stored = stored.filter(|format| format.component == Component::F32 || format.normalized);
    match wanted {
        NormalFormat::Same => as_stored.unwrap_or(Format::vector(Component::F32, false, 3)),
        NormalFormat::F32 => Format::vector(Component::F32, false, 3),
        NormalFormat::I16 => Format::vector(Component::I16, true, 3),
        NormalFormat::I8 => Format::vector(Component::I8, true, 3),
    }
}

/// Appends a unit vector. −0 is stored as +0, so that equal vectors are equal bytes.
pub fn push(normal: DVec3, format: Format, out: &mut Vec<u8>) {
    match format.component {
        Component::I8 => out.extend(steps(normal, 127).iter().map(|&step| step as i8 as u8)),
        Component::I16 => {
            out.extend(steps(normal, 32767).iter().flat_map(|&step| (step as i16).to_le_bytes()))
        }
        _ => push_floats(normal, out),
    }
}

/// Appends three floats.
pub fn push_floats(vector: DVec3, out: &mut Vec<u8>) {
    out.extend(vector.as_vec3().to_array().iter().flat_map(|x| (x + 0.0).to_le_bytes()));
}

/// The bound that the glTF validator puts on |length - 1|.
pub const LENGTH_TOLERANCE: f64 = 0.00674;

/// A unit vector in steps of 1/`most`: rounded, or where eight bits are too coarse for a unit length, the one of
/// the eight grid points around it with a good length that is nearest.
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

    #[test]
    fn stored_steps_survive() {
        for step in -127..=127_i32 {
            let x = f64::from((step as f32) / 127.0);
            assert_eq!((x * 127.0).round() as i32, step);
        }
        let mut bytes = Vec::new();
        push(DVec3::new(-0.0, 0.0, 1.0), Format::vector(Component::F32, false, 3), &mut bytes);
        assert_eq!(bytes, [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 128, 63]);
    }

    #[test]
    fn the_format_follows_the_file_unless_specified() {
        let float = Format::vector(Component::F32, false, 3);
        let byte = Format::vector(Component::I8, true, 3);
        assert_eq!(format(Some(byte), NormalFormat::Same), byte);
        assert_eq!(format(Some(Format { normalized: false, ..byte }), NormalFormat::Same), float);
        assert_eq!(format(Some(byte), NormalFormat::F32), float);
        assert_eq!(format(None, NormalFormat::Same), float);
        assert_eq!(format(Some(float), NormalFormat::I16).component, Component::I16);
    }
}
