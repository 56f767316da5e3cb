//! The arguments of statements, and what can be wrong with them.

use super::cursor::{CornerSpelling, Cursor};
use super::indices::Indices;
use crate::io::Problem;
use crate::io::text::{Fault, counted, float, float_prefix, shown};
use glam::DVec3;

/// Whether the control points of a free-form surface have the form v/vt/vn.
pub(super) fn refers_to_normals(cursor: &mut Cursor<'_>) -> bool {
    while cursor.next_argument().is_some() {
        if cursor.token().iter().filter(|&&byte| byte == b'/').count() == 2 {
            return true;
        }
    }
    false
}

/// A count as a 32-bit number. One statement can be as long as the file, so the length of a piece does not bound it.
pub(super) fn checked_end(total: usize, offset: usize) -> Result<u32, Fault> {
    u32::try_from(total).map_err(|_| too_many("corners", total, offset))
}

/// The error for more items than 32-bit indices can count.
pub(super) fn too_many(what: &str, count: usize, offset: usize) -> Fault {
    let found = format!("{count} {what}, more than 32-bit indices can count");
    Fault::new(Problem::Limit, offset, found, "split the file")
}

/// Reads the next corner of a face, or vertex of a line or of points; `None` at the end of the statement.
#[inline]
pub(super) fn next_corner(cursor: &mut Cursor<'_>) -> Result<Option<CornerSpelling>, Fault> {
    let Some(at) = cursor.next_argument() else { return Ok(None) };
    match cursor.corner() {
        Some(corner) if corner.vertex != 0 => Ok(Some(corner)),
        corner => Err(bad_corner(cursor, at, corner.is_some())),
    }
}

#[cold]
fn bad_corner(cursor: &mut Cursor<'_>, at: usize, is_zero: bool) -> Fault {
    if is_zero {
        let advice = "vertices count from 1, or back from -1; correct the index";
        return Fault::new(Problem::Range, at, "a reference to vertex 0", advice);
    }
    cursor.at = at;
    let found = format!("`{}` is not a vertex reference", shown(cursor.token()));
    Fault::new(Problem::Syntax, at, found, "write v, v/vt, v//vn or v/vt/vn with whole numbers")
}

/// Reads the vertices of a line or of points; the document keeps the texture coordinates of lines.
pub(super) fn vertex_list(cursor: &mut Cursor<'_>, into: &mut Indices, count: usize) -> Result<(), Fault> {
    while let Some(corner) = next_corner(cursor)? {
        into.push(corner.vertex, count);
    }
    Ok(())
}

#[inline]
pub(super) fn three_numbers(cursor: &mut Cursor<'_>, what: &'static str) -> Result<DVec3, Fault> {
    let mut values = [0.0; 3];
    for (count, value) in values.iter_mut().enumerate() {
        if cursor.next_argument().is_none() {
            return Err(too_few(cursor, what, count, "3 are needed"));
        }
        *value = number(cursor)?;
    }
    Ok(DVec3::from_array(values))
}

#[inline]
pub(super) fn number(cursor: &mut Cursor<'_>) -> Result<f64, Fault> {
    let start = cursor.at;
    if let Some((value, length)) = float_prefix(&cursor.text[start..]) {
        cursor.at += length;
        if cursor.at_token_end() {
            return Ok(value);
        }
    }
    unusual_number(cursor, start)
}

#[cold]
fn unusual_number(cursor: &mut Cursor<'_>, start: usize) -> Result<f64, Fault> {
    cursor.at = start;
    let token = cursor.token();
    float(token).ok_or_else(|| {
        let advice = match token {
            [.., b','] => "separate numbers by blanks alone",
            _ if token.contains(&b',') => "write decimals with a point",
            _ if token.contains(&b'd') || token.contains(&b'D') => "write exponents with an e",
            _ => "correct it, or remove the line",
        };
        Fault::new(Problem::Syntax, start, format!("`{}` is not a number", shown(token)), advice)
    })
}

#[cold]
pub(super) fn too_few(cursor: &Cursor<'_>, what: &str, count: usize, needed: &str) -> Fault {
    let found = format!("{what} with {}; {needed}", counted(count, "number", "numbers"));
    let advice = "complete it, or remove the line; perhaps the file was cut off";
    Fault::new(Problem::Syntax, cursor.at, found, advice)
}
