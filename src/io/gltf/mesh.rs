//! glTF meshes to [`Part`]s: all primitives of a mesh in one, vertices shared where primitives share accessors.

use super::accessor::Source;
use super::document::{Component, Format, Primitive};
use super::fields::At;
use super::primitive::{Drawn, draw};
use crate::io::{NonFinite, Note, Part, Problem, ReadError};
use crate::mesh::{Column, Columns, FaceLabels, Faces, Mesh, MeshBuilder, MeshError, NONE, Storage};
use glam::{DVec2, DVec3};
use rustc_hash::FxHashMap;

/// A set of vertex accessors that primitives use together: the vertices that they share.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) struct VertexSource {
    pub(super) attributes: Vec<(String, usize)>,
    pub(super) targets: Vec<Vec<(String, usize)>>,
}

impl VertexSource {
    pub(super) fn get(&self, semantic: &str) -> Option<usize> {
        self.attributes.iter().find(|(name, _)| name == semantic).map(|&(_, accessor)| accessor)
    }

    pub(super) fn target(&self, target: usize, semantic: &str) -> Option<usize> {
        let attributes = self.targets.get(target)?;
        attributes.iter().find(|(name, _)| name == semantic).map(|&(_, accessor)| accessor)
    }
}

/// How a part's mesh is made of vertex blocks and primitives.
#[derive(Clone, Debug, Default)]
pub(super) struct Layout {
    pub(super) blocks: Vec<Block>,
    pub(super) pieces: Vec<Piece>,
}

/// The vertices of one source within a part.
#[derive(Clone, Debug)]
pub(super) struct Block {
    pub(super) source: usize,
    pub(super) first_vertex: u32,
    pub(super) count: u32,
    /// Triangles use it.
    solid: bool,
    /// Where its stored normals begin among the part's, if it has any.
    pub(super) first_normal: Option<u32>,
}

/// The triangles of one primitive within a part.
#[derive(Clone, Debug)]
pub(super) struct Piece {
    pub(super) primitive: usize,
    pub(super) block: usize,
    pub(super) first_face: u32,
    pub(super) faces: u32,
}

/// Reads meshes one after the other, and collects the vertex sources that they share.
pub(super) struct Assembler<'a> {
    pub(super) source: Source<'a>,
    pub(super) non_finite: NonFinite,
    pub(super) sources: Vec<VertexSource>,
    pub(super) numbers: FxHashMap<VertexSource, usize>,
    pub(super) material_names: Vec<String>,
}

impl Assembler<'_> {
    /// Reads one mesh.
    pub(super) fn part(&mut self, mesh: usize, notes: &mut Vec<Note>) -> Result<(Part, Layout), ReadError> {
        let record = &self.source.records.meshes[mesh];
        let mut layout = Layout::default();
        let mut blocks: FxHashMap<usize, usize> = FxHashMap::default();
        let mut corners: Vec<u32> = Vec::new();
        let mut columns = Columns::default();
        let mut vertices: u64 = 0;
        for (number, primitive) in record.primitives.iter().enumerate() {
            if primitive.attributes.get("POSITION").is_none() {
                notes.push(Note::warning(
                    primitive.at.place(),
                    "a primitive without positions; nothing can be drawn",
                ));
                continue;
            }
            let source = self.vertex_source(primitive)?;
            let count = self.vertex_count(source, primitive)?;
            let block = *blocks.entry(source).or_insert_with(|| {
                let first_vertex = vertices as u32;
                vertices += u64::from(count);
                layout.blocks.push(Block { source, first_vertex, count, solid: false, first_normal: None });
                layout.blocks.len() - 1
            });
            if vertices >= u64::from(NONE) {
                let found = format!("a mesh of {vertices} vertices, more than 32-bit numbers can count");
                return Err(ReadError::new(Problem::Limit, primitive.at.place(), found, "split the mesh"));
            }
            let first = layout.blocks[block].first_vertex;
            match draw(&self.source, primitive, count as usize, notes)? {
                Drawn::Points(points) => columns.points.extend(points.iter().map(|v| v + first)),
                Drawn::Lines(lines) => {
                    let shifted = |line: Vec<u32>| line.iter().map(|v| v + first).collect();
                    columns.lines.extend(lines.into_iter().map(shifted));
                }
                Drawn::Triangles(triangles) => {
                    layout.blocks[block].solid = true;
                    let (first_face, faces) = ((corners.len() / 3) as u32, (triangles.len() / 3) as u32);
                    layout.pieces.push(Piece { primitive: number, block, first_face, faces });
                    corners.extend(triangles.iter().map(|v| v + first));
                }
            }
        }
        columns.materials = self.materials(mesh, &layout);
        let mesh = self.fill(mesh, &mut layout, corners, columns, notes)?;
        Ok((Part { name: record.name.clone(), mesh: mesh.0, non_finite_faces: mesh.1 }, layout))
    }

    fn vertex_source(&mut self, primitive: &Primitive) -> Result<usize, ReadError> {
        let source = VertexSource {
            attributes: primitive.attributes.list.clone(),
            targets: primitive.targets.iter().map(|target| target.list.clone()).collect(),
        };
        if let Some(&number) = self.numbers.get(&source) {
            return Ok(number);
        }
        self.check_source(&source, primitive)?;
        self.sources.push(source.clone());
        self.numbers.insert(source, self.sources.len() - 1);
        Ok(self.sources.len() - 1)
    }

    /// Every attribute must be there in full, decoded or not, so that later no copying can fail.
    fn check_source(&self, source: &VertexSource, primitive: &Primitive) -> Result<(), ReadError> {
        let position = source.get("POSITION").unwrap_or_default();
        let count = self.source.records.accessors[position].count;
        let own = source.attributes.iter();
        for (semantic, accessor) in own.chain(source.targets.iter().flatten()) {
            let elements = self.source.elements(*accessor)?;
            let place = || At::new("accessors", *accessor).place();
            if elements.count as u64 != count {
                let found = format!("{semantic} of {} vertices, where positions are {count}", elements.count);
                return Err(ReadError::new(
                    Problem::Range,
                    place(),
                    found,
                    "the file is broken; export it again",
                ));
            }
            if !fits(semantic, elements.format) {
                let found = format!("{semantic} of a type that glTF does not allow for it");
                let found = format!("{found} ({:?} × {})", elements.format.component, elements.format.width);
                return Err(ReadError::new(
                    Problem::Range,
                    place(),
                    found,
                    "the file is broken; export it again",
                ));
            }
        }
        let compressed = self
            .source
            .records
            .json
            .member(primitive.object, "extensions")
            .and_then(|extensions| self.source.records.json.member(extensions, super::extensions::DRACO));
        let stored =
            |&(_, accessor): &(String, usize)| self.source.records.accessors[accessor].view.is_some();
        if compressed.is_some() && !source.attributes.iter().all(stored) {
            let found = "vertices that are only there compressed by KHR_draco_mesh_compression";
            let advice = "decompress the file first, for example with `gltf-transform copy`";
            return Err(ReadError::new(Problem::Unsupported, primitive.at.place(), found, advice));
        }
        Ok(())
    }

    fn vertex_count(&self, source: usize, primitive: &Primitive) -> Result<u32, ReadError> {
        let position = self.sources[source].get("POSITION").unwrap_or_default();
        let count = self.source.records.accessors[position].count;
        u32::try_from(count).ok().filter(|&count| count < NONE).ok_or_else(|| {
            let found = format!("{count} vertices, more than 32-bit numbers can count");
            ReadError::new(Problem::Limit, primitive.at.place(), found, "split the mesh")
        })
    }

    fn materials(&self, mesh: usize, layout: &Layout) -> Option<FaceLabels> {
        let primitives = &self.source.records.meshes[mesh].primitives;
        if layout.pieces.iter().all(|piece| primitives[piece.primitive].material.is_none()) {
            return None;
        }
        let mut numbers: FxHashMap<usize, u32> = FxHashMap::default();
        let mut labels = FaceLabels::default();
        for piece in &layout.pieces {
            let label = primitives[piece.primitive].material.map_or(NONE, |material| {
                *numbers.entry(material).or_insert_with(|| {
                    labels.names.push(self.material_names[material].clone());
                    labels.names.len() as u32 - 1
                })
            });
            labels.of_face.extend(std::iter::repeat_n(label, piece.faces as usize));
        }
        Some(labels)
    }

    /// Decodes the vertices of all blocks and builds the mesh.
    fn fill(
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
        columns.uvs = self.uvs(layout, &corners, at)?;
        columns.colors = self.colors(layout, at)?;
        columns.morph_targets = self.morph_targets(layout, positions.len(), at, notes)?;
        let faces = Faces::triangles(corners);
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
                let advice = "repair the file, or drop the faces there with --force";
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

    fn uvs(&self, layout: &Layout, corners: &[u32], at: At) -> Result<Option<Column<DVec2>>, ReadError> {
        let mut values: Vec<DVec2> = Vec::new();
        let mut first: FxHashMap<u32, u32> = FxHashMap::default();
        for block in layout.blocks.iter().filter(|block| block.solid) {
            let Some(accessor) = self.sources[block.source].get("TEXCOORD_0") else { continue };
            self.source.spend(16 * u64::from(block.count), at)?;
            first.insert(block.first_vertex, values.len() as u32);
            // glTF counts v from the top of the image, meshes count from the bottom.
            let floats = self.source.elements(accessor)?.floats::<2>(0.0);
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

    fn colors(&self, layout: &Layout, at: At) -> Result<Option<Vec<[f32; 4]>>, ReadError> {
        let color = |block: &Block| self.sources[block.source].get("COLOR_0");
        if layout.blocks.iter().all(|block| color(block).is_none()) {
            return Ok(None);
        }
        let mut colors = Vec::new();
        for block in &layout.blocks {
            self.source.spend(16 * u64::from(block.count), at)?;
            match color(block) {
                Some(accessor) => colors.extend(self.source.elements(accessor)?.floats::<4>(1.0)),
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
        let counts = layout.blocks.iter().map(|block| self.sources[block.source].targets.len());
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
            let advice = "repair the file, or leave such displacements out with --force";
            return Err(ReadError::new(Problem::NonFinite, at.place(), found, advice));
        }
        target.iter_mut().filter(|d| !d.is_finite()).for_each(|d| *d = DVec3::ZERO);
        notes.push(Note::warning(at.place(), format!("{found}; such vertices stay where they are")));
        Ok(())
    }
}

/// Whether a semantic can be stored so, `KHR_mesh_quantization` allowed.
fn fits(semantic: &str, format: Format) -> bool {
    let Format { component, width, columns, .. } = format;
    match semantic {
        "POSITION" => width == 3 && columns == 1 && component != Component::U32,
        "NORMAL" => {
            let component = matches!(component, Component::F32 | Component::I8 | Component::I16);
            width == 3 && columns == 1 && component
        }
        "TEXCOORD_0" => width == 2 && columns == 1 && component != Component::U32,
        "COLOR_0" => (3..=4).contains(&width) && columns == 1 && component != Component::U32,
        _ => true,
    }
}
