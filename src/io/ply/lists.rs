//! Lists of vertices, written again.

use super::changes::Changes;
use super::header::Kind;
use super::rows::{Row, Rows};
use super::scalar::{Encoding, Scalar};

/// The type of a list of vertices that must hold this number: its own if it can, else `int`, else `uint`. An ascii
/// word holds anything, but its readers may go by the type.
pub(super) fn widened(item: Scalar, largest: usize) -> Scalar {
    [item, Scalar::I32, Scalar::U32]
        .into_iter()
        .find(|scalar| scalar.largest() >= largest as f64)
        .unwrap_or(Scalar::U32)
}

/// Appends a list.
pub(super) fn push_list(out: &mut Vec<u8>, values: &[u32], count: Scalar, item: Scalar, encoding: Encoding) {
    count.push(out, values.len() as f64, encoding);
    for &value in values {
        if encoding == Encoding::Ascii {
            out.push(b' ');
        }
        item.push(out, f64::from(value), encoding);
    }
}

/// Turns round a list of two numbers a corner, as [`FaceEdit`](crate::mesh::FaceEdit) turns corners: the first stays.
/// A list of another length is left alone.
pub(super) fn reverse_pairs(
    rows: &Rows<'_>,
    row: &Row,
    list: usize,
    kind: Kind,
    corners: usize,
    changes: &mut Changes,
) {
    let items: Vec<_> = rows.items(&row.fields[list], kind).collect();
    if items.len() != 2 * corners {
        return;
    }
    for corner in 1..corners {
        for part in 0..2 {
            let (here, there) =
                (items[2 * corner + part].clone(), items[2 * (corners - corner) + part].clone());
            changes.replace(here, |out| out.extend_from_slice(&rows.bytes[there]));
        }
    }
}
