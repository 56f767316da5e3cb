//! How the normals of an element are written back.

use super::document::PlyDocument;
use super::header::Element;
use super::rows::{Row, Rows, damaged};
use super::scalar::{Encoding, Scalar};
use crate::io::text::Changes;
use crate::io::{Note, Place, Problem, ReadError};
use glam::DVec3;

/// Where the normals of an element are, and the types that they have and get.
pub(super) struct NormalProperties {
    present: Option<[usize; 3]>,
    old: [Scalar; 3],
    /// The stored value of 1.
    old_unit: f64,
    new: Scalar,
    new_unit: f64,
    /// The property that they are put behind if they are not there.
    behind: usize,
}

impl NormalProperties {
    /// Chooses the types and changes the header accordingly. `packed`: whether the stored normals are normalised integers.
    pub fn plan(
        document: &PlyDocument,
        element: &Element,
        present: Option<[usize; 3]>,
        packed: bool,
        behind: usize,
        header: &mut Changes,
        notes: &mut Vec<Note>,
    ) -> Result<Self, ReadError> {
        let vertex = &document.roles.vertex;
        let position = &document.header.elements[vertex.element].properties[vertex.position[0]];
        let float = if position.kind.scalar() == Scalar::F64 { Scalar::F64 } else { Scalar::F32 };
        let Some(at) = present else {
            if let Some(part) = ["nx", "ny", "nz"].iter().find_map(|name| element.property(name)) {
                let name = &element.properties[part].name;
                let found = format!(
                    "element `{}` has `{name}`, but not all of nx, ny and nz as scalars",
                    element.name
                );
                return Err(damaged(Problem::Unsupported, 0, found));
            }
            let place = element.properties[behind].line_end;
            header.replace(place..place, |out| {
                for name in ["nx", "ny", "nz"] {
                    let (number, line_end) = (float.name(position.sized_name), document.header.line_end);
                    out.extend_from_slice(format!("property {number} {name}{line_end}").as_bytes());
                }
            });
            return Ok(Self { present, old: [float; 3], old_unit: 1.0, new: float, new_unit: 1.0, behind });
        };
        let old = at.map(|at| element.properties[at].kind.scalar());
        let largest = |scalar: Scalar| if scalar.is_integer() && packed { scalar.largest() } else { 1.0 };
        let keeps_type = old.iter().all(|scalar| *scalar == old[0])
            && (!old[0].is_integer() || packed && matches!(old[0], Scalar::I16 | Scalar::I32));
        let new = if keeps_type { old[0] } else { float };
        if !keeps_type {
            for property in at.map(|at| &element.properties[at]) {
                let name = new.name(property.sized_name);
                header.replace(property.type_at.clone(), |out| out.extend_from_slice(name.as_bytes()));
            }
            let (old, new) = (old[0].name(false), new.name(false));
            let text = format!("normals of type {old} are too coarse and were written as {new}");
            notes.push(Note::warning(Place::Line(element.line), text));
        }
        Ok(Self { present, old, old_unit: largest(old[0]), new, new_unit: largest(new), behind })
    }

    /// Changes the normal in a row; `None` keeps the stored one, or is +Z where there is none. Equal numbers keep their bytes.
    pub fn change(
        &self,
        normal: Option<DVec3>,
        row: &Row,
        rows: &Rows<'_>,
        changes: &mut Changes,
    ) -> Result<(), ReadError> {
        let Some(present) = self.present else {
            let place = row.fields[self.behind].end;
            changes.replace(place..place, |out| {
                for value in normal.unwrap_or(DVec3::Z).to_array() {
                    if rows.encoding == Encoding::Ascii {
                        out.push(b' ');
                    }
                    self.new.push(out, value, rows.encoding);
                }
            });
            return Ok(());
        };
        let keeps_type = self.old == [self.new; 3];
        if normal.is_none() && keeps_type {
            return Ok(());
        }
        for (k, at) in present.into_iter().enumerate() {
            let field = row.fields[at].clone();
            let stored = rows.scalar(&field, self.old[k])?;
            let value = normal.map_or(stored / self.old_unit, |normal| normal[k]) * self.new_unit;
            if !keeps_type || self.new.round(value) != self.new.round(stored) {
                changes.replace(field, |out| self.new.push(out, value, rows.encoding));
            }
        }
        Ok(())
    }
}
