//! glTF meshes to [`Part`]s: all primitives of a mesh in one, vertices shared where primitives share accessors.

use crate::io::gltf::document::accessor::Source;
use crate::io::gltf::document::primitive::{Drawn, draw};
use crate::io::gltf::document::records::{Component, Format, Primitive, Records};
use crate::io::gltf::json::fields::{At, Fields};
use crate::io::{NonFinite, Note, Part, Problem, ReadError};
use crate::mesh::{Columns, FaceLabels, NONE};
use rustc_hash::{FxHashMap, FxHashSet};
use std::hash::{Hash, Hasher};

/// The vertex accessors of a primitive. Primitives for which these are equal share their vertices.
#[derive(Clone, Copy, Debug)]
pub struct VertexSource<'a>(pub(in crate::io::gltf) &'a Primitive);

impl<'a> VertexSource<'a> {
    /// The attributes, then those of each morph target, each list sorted by semantic.
    pub fn lists(self) -> impl Iterator<Item = (Option<usize>, &'a [(String, usize)])> {
        let targets = self.0.targets.iter().enumerate();
        let targets = targets.map(|(number, target)| (Some(number), target.list.as_slice()));
        std::iter::once((None, self.0.attributes.list.as_slice())).chain(targets)
    }

    pub fn targets(self) -> usize {
        self.0.targets.len()
    }

    pub fn get(self, semantic: &str) -> Option<usize> {
        self.0.attributes.get(semantic)
    }

    pub fn target(self, target: usize, semantic: &str) -> Option<usize> {
        self.0.targets.get(target)?.get(semantic)
    }
}

impl PartialEq for VertexSource<'_> {
    fn eq(&self, other: &Self) -> bool {
        self.lists().eq(other.lists())
    }
}

impl Eq for VertexSource<'_> {}

impl Hash for VertexSource<'_> {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.lists().for_each(|list| list.hash(state));
    }
}

/// How a part's mesh is made of vertex blocks and primitives.
#[derive(Clone, Debug, Default)]
pub struct Layout {
    pub blocks: Vec<Block>,
    pub pieces: Vec<Piece>,
}

/// The vertices of one source within a part.
#[derive(Clone, Debug)]
pub struct Block {
    pub source: usize,
    pub first_vertex: u32,
    pub count: u32,
    /// Triangles use it.
    pub solid: bool,
    /// Where its stored normals begin among the part's, if it has any.
    pub first_normal: Option<u32>,
}

/// The triangles of one primitive within a part.
#[derive(Clone, Debug)]
pub struct Piece {
    pub primitive: usize,
    pub block: usize,
    pub first_face: u32,
    pub faces: u32,
}

/// Reads meshes one after the other, and collects the vertex sources that they share.
pub struct Assembler<'a> {
    pub source: Source<'a>,
    pub non_finite: NonFinite,
    pub sources: Vec<VertexSource<'a>>,
    pub numbers: FxHashMap<VertexSource<'a>, usize>,
    pub materials: Materials<'a>,
}

impl<'a> Assembler<'a> {
    /// Reads one mesh.
    pub fn part(&mut self, mesh: usize, notes: &mut Vec<Note>) -> Result<(Part, Layout), ReadError> {
        let records: &'a Records = self.source.records;
        let record = &records.meshes[mesh];
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
        columns.materials = self.labels(mesh, &layout)?;
        let mesh = self.fill(mesh, &mut layout, corners, columns, notes)?;
        Ok((Part { name: record.name.clone(), mesh: mesh.0, non_finite_faces: mesh.1 }, layout))
    }

    fn vertex_source(&mut self, primitive: &'a Primitive) -> Result<usize, ReadError> {
        let source = VertexSource(primitive);
        if let Some(&number) = self.numbers.get(&source) {
            return Ok(number);
        }
        self.check_source(source)?;
        self.sources.push(source);
        self.numbers.insert(source, self.sources.len() - 1);
        Ok(self.sources.len() - 1)
    }

    /// Every attribute must be there in full, decoded or not, so that later no copying can fail.
    fn check_source(&self, source: VertexSource<'_>) -> Result<(), ReadError> {
        let primitive = source.0;
        let position = source.get("POSITION").unwrap_or_default();
        let count = self.source.records.accessors[position].count;
        for (semantic, accessor) in source.lists().flat_map(|(_, list)| list) {
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
        let compressed =
            self.source.records.json.member(primitive.object, "extensions").and_then(|extensions| {
                self.source.records.json.member(extensions, crate::io::gltf::extensions::DRACO)
            });
        let stored =
            |&(_, accessor): &(String, usize)| self.source.records.accessors[accessor].view.is_some();
        if compressed.is_some() && !primitive.attributes.list.iter().all(stored) {
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

    /// The material of each face.
    fn labels(&mut self, mesh: usize, layout: &Layout) -> Result<Option<FaceLabels>, ReadError> {
        let primitives = &self.source.records.meshes[mesh].primitives;
        if layout.pieces.iter().all(|piece| primitives[piece.primitive].material.is_none()) {
            return Ok(None);
        }
        let mut numbers: FxHashMap<usize, u32> = FxHashMap::default();
        let mut labels = FaceLabels::default();
        for piece in &layout.pieces {
            let label = match primitives[piece.primitive].material {
                None => NONE,
                Some(material) => match numbers.get(&material) {
                    Some(&label) => label,
                    None => {
                        labels.names.push(self.materials.name(material)?);
                        numbers.insert(material, labels.names.len() as u32 - 1);
                        labels.names.len() as u32 - 1
                    }
                },
            };
            labels.of_face.extend(std::iter::repeat_n(label, piece.faces as usize));
        }
        Ok(Some(labels))
    }
}

/// Names of materials, no two alike, so that formats which know materials by name keep them apart.
pub struct Materials<'a> {
    pub records: &'a Records,
    pub names: FxHashMap<usize, String>,
    pub taken: FxHashSet<String>,
}

impl Materials<'_> {
    fn name(&mut self, material: usize) -> Result<String, ReadError> {
        if let Some(name) = self.names.get(&material) {
            return Ok(name.clone());
        }
        let object = self.records.materials[material];
        let fields = Fields { json: &self.records.json, object, at: At::new("materials", material) };
        let mut name = fields.string("name")?.unwrap_or_default().into_owned();
        if name.is_empty() {
            name = format!("material{material}");
        }
        while !self.taken.insert(name.clone()) {
            name = format!("{name}.{material}");
        }
        self.names.insert(material, name.clone());
        Ok(name)
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
