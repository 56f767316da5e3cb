//! The vertices of a part: positions and every column that meshes know.

use crate::io::gltf::document::mesh::{Assembler, Block, Layout};
use crate::io::gltf::json::fields::At;
use crate::io::tally::non_finite_note;
use crate::io::text::counted;
use crate::io::{NonFinite, Note, Problem, ReadError};
use crate::mesh::{Column, Columns, Faces, Mesh, MeshBuilder, MeshError, NONE, Storage};
use glam::{DVec2, DVec3};
use rustc_hash::FxHashMap;

impl Assembler<'_> {
    /// Decodes the vertices of all blocks and builds the mesh.
    pub fn fill(
        &self,
        mesh: usize,
        layout: &mut Layout,
        corners: Vec<u32>,
        mut columns: Columns,
        notes: &mut Vec<Note>,
    ) -> Result<(Mesh, Vec<u32>), ReadError> {
        let at = At::new("meshes", mesh);
        let mut positions = Vec::new();
        for block in &layout.blocks {
            let position = self.sources[block.source].get("POSITION").unwrap_or_default();
            self.source.spend(24 * u64::from(block.count), at)?;
            positions.extend(self.vectors(position)?);
        }
        columns.normals = self.normals(layout, &corners, at)?;
        columns.uvs = self.uvs(layout, &corners, at, notes)?;
        columns.colors = self.colors(layout, at, notes)?;
        columns.morph_targets = self.morph_targets(layout, positions.len(), at, notes)?;
        let faces = Faces::triangles(corners);
        let note = non_finite_note(&positions, self.non_finite);
        notes.extend(note.map(|note| Note { place: at.place(), ..note }));
        let builder = MeshBuilder { positions, storage: Storage::F32, faces, columns };
        let built = match self.non_finite {
            NonFinite::Refuse => builder.build().map(|mesh| (mesh, Vec::new())),
            NonFinite::DropFaces => builder.build_dropping_non_finite(),
        };
        built.map_err(|error| match error {
            MeshError::NonFinite { vertex, position } => {
                let block = layout.blocks.partition_point(|block| block.first_vertex as usize <= vertex) - 1;
                let accessor = self.sources[layout.blocks[block].source].get("POSITION").unwrap_or_default();
                let element = vertex - layout.blocks[block].first_vertex as usize;
                let found = format!(
                    "element {element} is the position ({}, {}, {})",
                    position.x, position.y, position.z
                );
                let advice = "repair the file, or drop the faces there with `crease normals --force` (`crease render --force` draws the others)";
                ReadError::new(Problem::NonFinite, At::new("accessors", accessor).place(), found, advice)
            }
            other => ReadError::new(
                Problem::Range,
                at.place(),
                other.to_string(),
                "the file is broken; export it again",
            ),
        })
    }

    fn vectors(&self, accessor: usize) -> Result<impl Iterator<Item = DVec3> + use<>, ReadError> {
        let floats = self.source.elements(accessor)?.floats::<3>(0.0);
        Ok(floats.into_iter().map(|[x, y, z]| DVec3::new(x.into(), y.into(), z.into())))
    }

    fn normals(
        &self,
        layout: &mut Layout,
        corners: &[u32],
        at: At,
    ) -> Result<Option<Column<DVec3>>, ReadError> {
        let mut values: Vec<DVec3> = Vec::new();
        for block in layout.blocks.iter_mut().filter(|block| block.solid) {
            let Some(accessor) = self.sources[block.source].get("NORMAL") else { continue };
            self.source.spend(24 * u64::from(block.count), at)?;
            block.first_normal = Some(values.len() as u32);
            values.extend(self.vectors(accessor)?);
        }
        self.column(layout, corners, values, |block| block.first_normal, at)
    }

    /// Floats for show: what is not a finite number becomes 0, with a warning.
    fn shown<const N: usize>(
        &self,
        accessor: usize,
        notes: &mut Vec<Note>,
    ) -> Result<Vec<[f32; N]>, ReadError> {
        let mut floats = self.source.elements(accessor)?.floats::<N>(1.0);
        let broken = floats.as_flattened_mut().iter_mut().filter(|x| !x.is_finite());
        let count = broken.map(|x| *x = 0.0).count();
        if count > 0 {
            let numbers = counted(count, "number", "numbers");
            let text = format!("texture coordinates or colours that are not finite count as 0: {numbers}");
            notes.push(Note::warning(At::new("accessors", accessor).place(), text));
        }
        Ok(floats)
    }

    fn uvs(
        &self,
        layout: &Layout,
        corners: &[u32],
        at: At,
        notes: &mut Vec<Note>,
    ) -> Result<Option<Column<DVec2>>, ReadError> {
        let mut values: Vec<DVec2> = Vec::new();
        let mut first: FxHashMap<u32, u32> = FxHashMap::default();
        for block in layout.blocks.iter().filter(|block| block.solid) {
            let Some(accessor) = self.sources[block.source].get("TEXCOORD_0") else { continue };
            self.source.spend(16 * u64::from(block.count), at)?;
            first.insert(block.first_vertex, values.len() as u32);
            // glTF counts v from the top of the image, meshes count from the bottom.
            let floats = self.shown::<2>(accessor, notes)?;
            values.extend(floats.into_iter().map(|[u, v]| DVec2::new(u.into(), 1.0 - f64::from(v))));
        }
        self.column(layout, corners, values, |block| first.get(&block.first_vertex).copied(), at)
    }

    /// A column of values stored block by block: per vertex if every block has them, per corner otherwise.
    fn column<T>(
        &self,
        layout: &Layout,
        corners: &[u32],
        values: Vec<T>,
        first: impl Fn(&Block) -> Option<u32>,
        at: At,
    ) -> Result<Option<Column<T>>, ReadError> {
        if values.is_empty() {
            return Ok(None);
        }
        if layout.blocks.iter().all(|block| first(block).is_some()) {
            return Ok(Some(Column::per_vertex(values)));
        }
        self.source.spend(4 * corners.len() as u64, at)?;
        let mut index = Vec::with_capacity(corners.len());
        for piece in &layout.pieces {
            let block = &layout.blocks[piece.block];
            let first = first(block);
            let range = 3 * piece.first_face as usize..3 * (piece.first_face + piece.faces) as usize;
            let slots =
                corners[range].iter().map(|v| first.map_or(NONE, |first| first + v - block.first_vertex));
            index.extend(slots);
        }
        Ok(Some(Column::per_corner(values, index)))
    }

    fn colors(
        &self,
        layout: &Layout,
        at: At,
        notes: &mut Vec<Note>,
    ) -> Result<Option<Vec<[f32; 4]>>, ReadError> {
        let color = |block: &Block| self.sources[block.source].get("COLOR_0");
        if layout.blocks.iter().all(|block| color(block).is_none()) {
            return Ok(None);
        }
        let mut colors = Vec::new();
        for block in &layout.blocks {
            self.source.spend(16 * u64::from(block.count), at)?;
            match color(block) {
                Some(accessor) => colors.extend(self.shown::<4>(accessor, notes)?),
                // Colours multiply, so that white is the same as none.
                None => colors.extend(std::iter::repeat_n([1.0; 4], block.count as usize)),
            }
        }
        Ok(Some(colors))
    }

    fn morph_targets(
        &self,
        layout: &Layout,
        vertices: usize,
        at: At,
        notes: &mut Vec<Note>,
    ) -> Result<Vec<Vec<DVec3>>, ReadError> {
        let counts = layout.blocks.iter().map(|block| self.sources[block.source].targets());
        let count = counts.clone().max().unwrap_or(0);
        if counts.min().unwrap_or(0) < count {
            notes.push(Note::warning(at.place(), "primitives with different numbers of morph targets"));
        }
        self.source.spend((24 * vertices as u64).saturating_mul(count as u64), at)?;
        let mut targets = vec![vec![DVec3::ZERO; vertices]; count];
        for block in &layout.blocks {
            for (number, target) in targets.iter_mut().enumerate() {
                let Some(accessor) = self.sources[block.source].target(number, "POSITION") else { continue };
                for (to, from) in
                    target[block.first_vertex as usize..].iter_mut().zip(self.vectors(accessor)?)
                {
                    *to = from;
                }
            }
        }
        for (number, target) in targets.iter_mut().enumerate() {
            self.check_displacements(number, target, at, notes)?;
        }
        Ok(targets)
    }

    fn check_displacements(
        &self,
        number: usize,
        target: &mut [DVec3],
        at: At,
        notes: &mut Vec<Note>,
    ) -> Result<(), ReadError> {
        let Some(vertex) = target.iter().position(|displacement| !displacement.is_finite()) else {
            return Ok(());
        };
        let found = format!("morph target {number} displaces vertex {vertex} by what is not a finite number");
        if self.non_finite == NonFinite::Refuse {
            let advice = "repair the file, or leave such displacements out with `crease normals --force`";
            return Err(ReadError::new(Problem::NonFinite, at.place(), found, advice));
        }
        target.iter_mut().filter(|d| !d.is_finite()).for_each(|d| *d = DVec3::ZERO);
        notes.push(Note::warning(at.place(), format!("{found}; such vertices stay where they are")));
        Ok(())
    }
}
