//! The arguments of statements, and what can be wrong with them.

use super::indices::Indices;
use super::lexer::Cursor;
use crate::io::text::{counted, shown};
use crate::io::{Problem, number};
use glam::DVec3;

/// Why a stretch cannot be parsed, at a byte offset of the file.
#[derive(Debug)]
pub(super) struct Fault {
    pub offset: usize,
    pub problem: Problem,
    pub found: String,
    pub advice: &'static str,
}

/// Whether a free-form surface's control points have the form v/vt/vn.
pub(super) fn refers_to_normals(cursor: &mut Cursor<'_>) -> bool {
    loop {
        cursor.skip_blanks();
        if cursor.at_statement_end() {
            return false;
        }
        if cursor.token().iter().filter(|&&byte| byte == b'/').count() == 2 {
            return true;
        }
    }
}

/// Indices are 32 bits wide, also within a stretch, which one endless line can make as long as the file.
pub(super) fn checked_end(total: usize, offset: usize) -> Result<u32, Fault> {
    u32::try_from(total).map_err(|_| Fault {
        offset,
        problem: Problem::Limit,
        found: format!("{total} corners, more than 32-bit indices can count"),
        advice: "split the file",
    })
}

/// The vertices of a line or of points; texture coordinates of lines are left to the document.
pub(super) fn vertex_list(cursor: &mut Cursor<'_>, into: &mut Indices, count: usize) -> Result<(), Fault> {
    loop {
        cursor.skip_blanks();
        if cursor.at_statement_end() {
            return Ok(());
        }
        let at = cursor.at;
        let Some(corner) = cursor.corner() else { return Err(not_a_corner(cursor, at)) };
        if corner.vertex == 0 {
            return Err(zero_index(at));
        }
        into.push(corner.vertex, count);
    }
}

#[inline]
pub(super) fn three_numbers(cursor: &mut Cursor<'_>, what: &'static str) -> Result<DVec3, Fault> {
    let mut values = [0.0; 3];
    for (count, value) in values.iter_mut().enumerate() {
        cursor.skip_blanks();
        if cursor.at_statement_end() {
            return Err(too_few(cursor, what, count, "3 are needed"));
        }
        *value = number(cursor)?;
    }
    Ok(DVec3::from_array(values))
}

#[inline]
pub(super) fn number(cursor: &mut Cursor<'_>) -> Result<f64, Fault> {
    let start = cursor.at;
    if let Some((value, length)) = number::quick_float(&cursor.text[start..]) {
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
    number::float(token).ok_or_else(|| Fault {
        offset: start,
        problem: Problem::Syntax,
        found: format!("`{}` is not a number", shown(token)),
        advice: match token {
            [.., b','] => "separate numbers by blanks alone",
            _ if token.contains(&b',') => "write decimals with a point",
            _ if token.contains(&b'd') || token.contains(&b'D') => "write exponents with an e",
            _ => "correct it, or remove the line",
        },
    })
}

#[cold]
pub(super) fn too_few(cursor: &Cursor<'_>, what: &str, count: usize, needed: &str) -> Fault {
    Fault {
        offset: cursor.at,
        problem: Problem::Syntax,
        found: format!("{what} with {}; {needed}", counted(count, "number", "numbers")),
        advice: "complete it, or remove the line; perhaps the file was cut off",
    }
}

#[cold]
pub(super) fn not_a_corner(cursor: &mut Cursor<'_>, at: usize) -> Fault {
    cursor.at = at;
    Fault {
        offset: at,
        problem: Problem::Syntax,
        found: format!("`{}` is not a vertex reference", shown(cursor.token())),
        advice: "write v, v/vt, v//vn or v/vt/vn with whole numbers",
    }
}

#[cold]
pub(super) fn zero_index(offset: usize) -> Fault {
    Fault {
        offset,
        problem: Problem::Range,
        found: "a reference to vertex 0".to_owned(),
        advice: "vertices count from 1, or back from -1; correct the index",
    }
}
