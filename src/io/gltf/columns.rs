//! The vertices of a part: positions and every column that meshes know.

use super::document::Layout;
use super::fields::{numbered, out_of_range};
use super::mesh::Assembler;
use crate::io::mesh_checks::{DROP_ADVICE, build_mesh, non_finite_note};
use crate::io::text::counted;
use crate::io::{NonFinite, Note, Problem, ReadError};
use crate::mesh::{Column, Columns, Faces, Mesh, MeshBuilder, MeshError, NONE, PositionsRef};
use glam::{DVec2, DVec3};

/// A column of the vertices of triangles, and where each block begins in it.
type BlockColumn<T> = (Option<Column<T>>, Vec<Option<u32>>);

impl<'a> Assembler<'a> {
    /// Decodes the vertices of all blocks and builds the mesh. Also returns the faces that are dropped from it.
    pub fn fill(
        &self,
        layout: &mut Layout,
        corners: Vec<u32>,
        mut columns: Columns,
    ) -> Result<(Mesh, Vec<u32>), ReadError> {
        let mut positions: Vec<[f32; 3]> = Vec::new();
        for block in &layout.blocks {
            self.source.spend(12 * u64::from(block.count), || self.place())?;
            let elements = self.source.elements(self.accessors(block).position())?;
            positions.reserve_exact(elements.count);
            positions.extend(elements.floats::<3>(0.0));
        }
        let (normals, first) = self.column(layout, &corners, "NORMAL", |accessor| self.vectors(accessor))?;
        layout.blocks.iter_mut().zip(first).for_each(|(block, first)| block.first_normal = first);
        columns.normals = normals;
        // glTF counts v from the top of the image, meshes count from the bottom.
        let uv = |[u, v]: [f32; 2]| DVec2::new(u.into(), 1.0 - f64::from(v));
        let uvs = |accessor| Ok(self.shown::<2>(accessor)?.into_iter().map(uv));
        columns.uvs = self.column(layout, &corners, "TEXCOORD_0", uvs)?.0;
        columns.colors = self.colors(layout)?;
        columns.morph_targets = self.morph_targets(layout, positions.len())?;
        let note = non_finite_note(PositionsRef::F32(&positions), self.non_finite);
        let note = note.map(|note| Note { place: self.place(), ..note });
        self.source.notes.borrow_mut().extend(note);
        let faces = Faces::triangles(corners);
        let builder = MeshBuilder { positions: positions.into(), faces, columns };
        build_mesh(builder, self.non_finite).map_err(|error| match error {
            MeshError::NonFinite { vertex, position } => self.non_finite_position(layout, vertex, position),
            other => out_of_range(self.place(), other.to_string()),
        })
    }

    fn non_finite_position(&self, layout: &Layout, vertex: usize, position: DVec3) -> ReadError {
        let block = layout.blocks.partition_point(|block| block.first_vertex as usize <= vertex) - 1;
        let block = &layout.blocks[block];
        let element = vertex - block.first_vertex as usize;
        let DVec3 { x, y, z } = position;
        let place = numbered("accessors", self.accessors(block).position());
        let found = format!("element {element} has the position ({x}, {y}, {z}), which is not finite");
        ReadError::new(Problem::NonFinite, place, found, DROP_ADVICE)
    }

    fn vectors(&self, accessor: usize) -> Result<impl Iterator<Item = DVec3> + use<'a>, ReadError> {
        let floats = self.source.elements(accessor)?.floats::<3>(0.0);
        Ok(floats.map(|[x, y, z]| DVec3::new(x.into(), y.into(), z.into())))
    }

    /// The floats of texture coordinates or colours: those that are not finite become 0, with a warning.
    fn shown<const N: usize>(&self, accessor: usize) -> Result<Vec<[f32; N]>, ReadError> {
        let mut floats: Vec<[f32; N]> = self.source.elements(accessor)?.floats(1.0).collect();
        let broken = floats.as_flattened_mut().iter_mut().filter(|x| !x.is_finite());
        let count = broken.map(|x| *x = 0.0).count();
        if count > 0 {
            let numbers = counted(count, "number", "numbers");
            let text =
                format!("{numbers} of texture coordinates or colours are not finite and were read as 0");
            self.source.warn(numbered("accessors", accessor), text);
        }
        Ok(floats)
    }

    /// The column of a semantic: per vertex if every block has values, per corner otherwise.
    fn column<T, I: Iterator<Item = T>>(
        &self,
        layout: &Layout,
        corners: &[u32],
        semantic: &str,
        read: impl Fn(usize) -> Result<I, ReadError>,
    ) -> Result<BlockColumn<T>, ReadError> {
        let mut values: Vec<T> = Vec::new();
        let mut first = vec![None; layout.blocks.len()];
        for (block, first) in layout.blocks.iter().zip(&mut first).filter(|(block, _)| block.solid) {
            let Some(accessor) = self.accessors(block).get(semantic) else { continue };
            self.source.spend(size_of::<T>() as u64 * u64::from(block.count), || self.place())?;
            *first = Some(values.len() as u32);
            values.extend(read(accessor)?);
        }
        if values.is_empty() {
            return Ok((None, first));
        }
        if first.iter().all(Option::is_some) {
            return Ok((Some(Column::per_vertex(values)), first));
        }
        self.source.spend(4 * corners.len() as u64, || self.place())?;
        let mut index = Vec::with_capacity(corners.len());
        for piece in &layout.pieces {
            let (first, first_vertex) = (first[piece.block], layout.blocks[piece.block].first_vertex);
            let range = 3 * piece.first_face as usize..3 * (piece.first_face + piece.faces) as usize;
            index.extend(corners[range].iter().map(|v| first.map_or(NONE, |first| first + v - first_vertex)));
        }
        Ok((Some(Column::per_corner(values, index)), first))
    }

    fn colors(&self, layout: &Layout) -> Result<Option<Vec<[f32; 4]>>, ReadError> {
        let colors_of = || layout.blocks.iter().map(|block| self.accessors(block).get("COLOR_0"));
        if colors_of().all(|accessor| accessor.is_none()) {
            return Ok(None);
        }
        let mut colors = Vec::new();
        for (block, accessor) in layout.blocks.iter().zip(colors_of()) {
            self.source.spend(16 * u64::from(block.count), || self.place())?;
            match accessor {
                Some(accessor) => colors.extend(self.shown::<4>(accessor)?),
                // Colours multiply, so that white is the same as none.
                None => colors.extend(std::iter::repeat_n([1.0; 4], block.count as usize)),
            }
        }
        Ok(Some(colors))
    }

    fn morph_targets(&self, layout: &Layout, vertices: usize) -> Result<Vec<Vec<DVec3>>, ReadError> {
        let counts = layout.blocks.iter().map(|block| self.accessors(block).target_sets().len());
        let count = counts.clone().max().unwrap_or(0);
        if counts.min().unwrap_or(0) < count {
            self.source.warn(self.place(), "the primitives have different numbers of morph targets");
        }
        self.source.spend((24 * vertices as u64).saturating_mul(count as u64), || self.place())?;
        let mut targets = vec![vec![DVec3::ZERO; vertices]; count];
        for block in &layout.blocks {
            for (number, target) in targets.iter_mut().enumerate() {
                let accessor = self.accessors(block).of_set(number + 1, "POSITION");
                let Some(accessor) = accessor else { continue };
                let displaced = target[block.first_vertex as usize..].iter_mut();
                displaced.zip(self.vectors(accessor)?).for_each(|(to, from)| *to = from);
            }
        }
        for (number, target) in targets.iter_mut().enumerate() {
            let Some(vertex) = target.iter().position(|displacement| !displacement.is_finite()) else {
                continue;
            };
            let found = format!("morph target {number}: the displacement of vertex {vertex} is not finite");
            if self.non_finite == NonFinite::Refuse {
                let advice = "correct it, or ignore such displacements with `crease normals --force`";
                return Err(ReadError::new(Problem::NonFinite, self.place(), found, advice));
            }
            target.iter_mut().filter(|d| !d.is_finite()).for_each(|d| *d = DVec3::ZERO);
            self.source.warn(self.place(), format!("{found}; such displacements are ignored"));
        }
        Ok(targets)
    }
}
