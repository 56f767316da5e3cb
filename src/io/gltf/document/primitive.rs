//! Primitives: which vertices their triangles, lines and points use.

use crate::io::ReadError;
use crate::io::gltf::document::accessor::Source;
use crate::io::gltf::document::records::{Component, Format, Primitive};
use crate::io::gltf::json::fields::{At, out_of_range};
use crate::io::text::counted;

/// glTF's codes for what a primitive draws.
pub mod mode {
    pub const POINTS: u64 = 0;
    pub const LINES: u64 = 1;
    pub const LINE_LOOP: u64 = 2;
    pub const LINE_STRIP: u64 = 3;
    pub const TRIANGLES: u64 = 4;
    pub const TRIANGLE_STRIP: u64 = 5;
    pub const TRIANGLE_FAN: u64 = 6;
}

/// What a primitive draws, as vertex numbers of its own accessors.
pub enum Drawn {
    Points(Vec<u32>),
    Lines(Vec<Vec<u32>>),
    /// Three numbers a triangle.
    Triangles(Vec<u32>),
}

/// Reads the indices of a primitive with `count` vertices and resolves its mode.
pub fn draw(source: &Source<'_>, primitive: &Primitive, count: usize) -> Result<Drawn, ReadError> {
    let mut order = match primitive.indices {
        Some(accessor) => {
            let elements = source.elements(accessor)?;
            check_format(elements.format, accessor)?;
            let expansion = if primitive.mode == mode::TRIANGLES { 1 } else { 8 };
            source.spend(4 * expansion * elements.count as u64, primitive.at)?;
            let indices = elements.integers();
            check_range(&indices, elements.format, count, accessor)?;
            indices
        }
        None => {
            source.spend(4 * count as u64, primitive.at)?;
            (0..count as u32).collect()
        }
    };
    let drawn = match primitive.mode {
        mode::POINTS => Drawn::Points(order),
        mode::LINES => Drawn::Lines(order.chunks_exact(2).map(<[u32]>::to_vec).collect()),
        mode::LINE_LOOP => Drawn::Lines(polyline(order.iter().chain(order.first()))),
        mode::LINE_STRIP => Drawn::Lines(polyline(order.iter())),
        mode::TRIANGLES => {
            let rest = order.len() % 3;
            if rest > 0 {
                let corners = counted(rest, "corner", "corners");
                let text = format!("ignored, because whole triangles leave it over: {corners}");
                source.warn(primitive.at.place(), text);
                order.truncate(order.len() - rest);
            }
            Drawn::Triangles(order)
        }
        mode::TRIANGLE_STRIP => Drawn::Triangles(strip(&order)),
        mode::TRIANGLE_FAN => Drawn::Triangles(fan(&order)),
        other => {
            let found = format!("primitive mode {other}, where glTF has 0 to 6");
            return Err(out_of_range(primitive.at.member("mode"), found));
        }
    };
    Ok(drawn)
}

fn polyline<'a>(order: impl Iterator<Item = &'a u32>) -> Vec<Vec<u32>> {
    let line: Vec<u32> = order.copied().collect();
    if line.len() < 2 { Vec::new() } else { vec![line] }
}

/// Triangles of a strip: every other one is flipped, so that all face the same way.
fn strip(order: &[u32]) -> Vec<u32> {
    let triangles = order.windows(3).enumerate();
    triangles.flat_map(|(i, w)| if i % 2 == 0 { [w[0], w[1], w[2]] } else { [w[0], w[2], w[1]] }).collect()
}

/// Triangles of a fan, the common vertex last as the standard writes them.
fn fan(order: &[u32]) -> Vec<u32> {
    let Some((&centre, rim)) = order.split_first() else { return Vec::new() };
    rim.windows(2).flat_map(|edge| [edge[0], edge[1], centre]).collect()
}

/// Checks that indices are unsigned integers.
fn check_format(format: Format, accessor: usize) -> Result<(), ReadError> {
    let unsigned = matches!(format.component, Component::U8 | Component::U16 | Component::U32);
    if unsigned && format.width == 1 {
        return Ok(());
    }
    Err(out_of_range(At::new("accessors", accessor).place(), "indices that are not unsigned integers"))
}

fn check_range(indices: &[u32], format: Format, count: usize, accessor: usize) -> Result<(), ReadError> {
    let Some(position) = indices.iter().position(|&index| index as usize >= count) else { return Ok(()) };
    let index = indices[position];
    let found = if index == u32::MAX >> (32 - 8 * format.component.size()) {
        format!("index number {position} is {index}, which restarts a primitive; glTF does not allow it")
    } else {
        format!("index number {position} asks for vertex {index}, counted from 0, of {count}")
    };
    Err(out_of_range(At::new("accessors", accessor).place(), found))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strips_and_fans_wind_as_the_standard_says() {
        assert_eq!(strip(&[0, 1, 2, 3, 4]), [0, 1, 2, 1, 3, 2, 2, 3, 4]);
        assert_eq!(fan(&[0, 1, 2, 3]), [1, 2, 0, 2, 3, 0]);
        for short in [&[][..], &[1], &[1, 2]] {
            assert!(strip(short).is_empty() && fan(short).is_empty());
        }
    }
}
