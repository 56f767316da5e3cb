//! glTF meshes to [`Part`]s: all primitives of a mesh in one, vertices shared where primitives share accessors.

use super::accessor::Source;
use super::document::{Block, Layout, Piece};
use super::extensions::DRACO;
use super::fields::{numbered, only_compressed, out_of_range};
use super::records::{Component, Format, Primitive, VertexAccessors};
use crate::io::text::counted;
use crate::io::{NonFinite, Part, Place, Problem, ReadError};
use crate::mesh::{Columns, FaceLabels, NONE};
use gltf::json::mesh as mode;
use rustc_hash::FxHashMap;
use std::collections::BTreeMap;
use std::collections::hash_map::Entry;

/// Reads meshes one after the other, and collects the vertex sources and materials that they share.
pub struct Assembler<'a> {
    pub source: Source<'a>,
    pub non_finite: NonFinite,
    mesh: usize,
    /// The first primitive of each vertex source, as numbers of mesh and primitive.
    pub sources: Vec<(usize, usize)>,
    source_numbers: FxHashMap<&'a VertexAccessors, usize>,
    /// The materials in use by name, no two with the same, since other formats know materials by name.
    pub materials: BTreeMap<String, usize>,
    material_names: FxHashMap<usize, String>,
}

impl<'a> Assembler<'a> {
    pub fn new(source: Source<'a>, non_finite: NonFinite) -> Self {
        Self {
            source,
            non_finite,
            mesh: 0,
            sources: Vec::new(),
            source_numbers: FxHashMap::default(),
            materials: BTreeMap::new(),
            material_names: FxHashMap::default(),
        }
    }

    pub fn part(&mut self, mesh: usize) -> Result<(Part, Layout), ReadError> {
        self.mesh = mesh;
        let record = &self.source.records.meshes[mesh];
        let mut layout = Layout::default();
        let mut blocks: FxHashMap<usize, usize> = FxHashMap::default();
        let mut corners: Vec<u32> = Vec::new();
        let mut columns = Columns::default();
        let mut vertices: u64 = 0;
        for (number, primitive) in record.primitives.iter().enumerate() {
            let Some(position) = primitive.vertices.get("POSITION") else {
                self.source.warn(primitive.place(), "a primitive without positions was skipped");
                continue;
            };
            let source = self.vertex_source(mesh, number)?;
            let too_many = |what: &str, count: u64| {
                let found = format!("{what}{count} vertices, more than 32-bit indices can count");
                ReadError::new(Problem::Limit, primitive.place(), found, "split the mesh")
            };
            let count = self.source.records.accessors[position].count;
            if count >= u64::from(NONE) {
                return Err(too_many("", count));
            }
            let block = *blocks.entry(source).or_insert_with(|| {
                let (first_vertex, count) = (vertices as u32, count as u32);
                vertices += u64::from(count);
                layout.blocks.push(Block { source, first_vertex, count, solid: false, first_normal: None });
                layout.blocks.len() - 1
            });
            if vertices >= u64::from(NONE) {
                return Err(too_many("a mesh of ", vertices));
            }
            let first = layout.blocks[block].first_vertex;
            match draw(&self.source, primitive, count as usize)? {
                Drawn::Points(points) => columns.points.extend(points.iter().map(|v| v + first)),
                Drawn::Lines(lines) => {
                    let shifted = |line: Vec<u32>| line.iter().map(|v| v + first).collect();
                    columns.lines.extend(lines.into_iter().map(shifted));
                }
                Drawn::Triangles(triangles) => {
                    layout.blocks[block].solid = true;
                    let (first_face, faces) = ((corners.len() / 3) as u32, (triangles.len() / 3) as u32);
                    layout.pieces.push(Piece { primitive: number, block, first_face, faces });
                    match corners.is_empty() && first == 0 {
                        true => corners = triangles,
                        false => corners.extend(triangles.iter().map(|v| v + first)),
                    }
                }
            }
        }
        columns.materials = self.labels(&record.primitives, &layout)?;
        let (mesh, non_finite_faces) = self.fill(&mut layout, corners, columns)?;
        Ok((Part { name: record.name.clone(), mesh, non_finite_faces }, layout))
    }

    pub fn place(&self) -> Place {
        numbered("meshes", self.mesh)
    }

    pub fn accessors(&self, block: &Block) -> &'a VertexAccessors {
        let (mesh, primitive) = self.sources[block.source];
        &self.source.records.meshes[mesh].primitives[primitive].vertices
    }

    fn vertex_source(&mut self, mesh: usize, primitive: usize) -> Result<usize, ReadError> {
        let record = &self.source.records.meshes[mesh].primitives[primitive];
        if let Some(&number) = self.source_numbers.get(&record.vertices) {
            return Ok(number);
        }
        self.check_source(record)?;
        let number = self.sources.len();
        self.sources.push((mesh, primitive));
        self.source_numbers.insert(&record.vertices, number);
        Ok(number)
    }

    /// Every attribute must be there in full, decoded or not, so that later no copying can fail.
    fn check_source(&self, primitive: &Primitive) -> Result<(), ReadError> {
        let records = self.source.records;
        let count = records.accessors[primitive.vertices.position()].count;
        for (semantic, accessor) in primitive.vertices.sets.iter().flatten() {
            let elements = self.source.elements(*accessor)?;
            let place = || numbered("accessors", *accessor);
            if elements.count as u64 != count {
                let found =
                    format!("{semantic} has {} elements, but there are {count} positions", elements.count);
                return Err(out_of_range(place(), found));
            }
            let Format { component, width, .. } = elements.format;
            if !fits(semantic, elements.format) {
                let found = format!("type {component:?} × {width} is not allowed for {semantic}");
                return Err(out_of_range(place(), found));
            }
        }
        let is_stored = |&accessor: &usize| records.accessors[accessor].view.is_some();
        let compressed = records.fields(primitive.object).extension(DRACO);
        if compressed.is_some()
            && !primitive.vertices.sets[0].iter().map(|(_, accessor)| accessor).all(is_stored)
        {
            let found = "the vertices are stored only compressed by KHR_draco_mesh_compression";
            return Err(only_compressed(primitive.place(), found));
        }
        Ok(())
    }

    fn labels(&mut self, primitives: &[Primitive], layout: &Layout) -> Result<Option<FaceLabels>, ReadError> {
        if layout.pieces.iter().all(|piece| primitives[piece.primitive].material.is_none()) {
            return Ok(None);
        }
        let mut numbers: FxHashMap<usize, u32> = FxHashMap::default();
        let mut labels = FaceLabels::default();
        for piece in &layout.pieces {
            let label = match primitives[piece.primitive].material.map(|material| numbers.entry(material)) {
                None => NONE,
                Some(Entry::Occupied(known)) => *known.get(),
                Some(Entry::Vacant(entry)) => {
                    labels.names.push(self.material_name(*entry.key())?);
                    *entry.insert(labels.names.len() as u32 - 1)
                }
            };
            labels.of_face.extend(std::iter::repeat_n(label, piece.faces as usize));
        }
        Ok(Some(labels))
    }

    fn material_name(&mut self, material: usize) -> Result<String, ReadError> {
        if let Some(name) = self.material_names.get(&material) {
            return Ok(name.clone());
        }
        let records = self.source.records;
        let mut name = records.fields(records.materials[material]).name()?;
        if name.is_empty() {
            name = format!("material{material}");
        }
        while self.materials.contains_key(&name) {
            name = format!("{name}.{material}");
        }
        self.materials.insert(name.clone(), material);
        self.material_names.insert(material, name.clone());
        Ok(name)
    }
}

/// Whether a semantic can be stored so, `KHR_mesh_quantization` allowed.
fn fits(semantic: &str, format: Format) -> bool {
    let component = format.component;
    let (widths, is_allowed) = match semantic {
        "POSITION" => (3..=3, component != Component::U32),
        "NORMAL" => (3..=3, matches!(component, Component::F32 | Component::I8 | Component::I16)),
        "TEXCOORD_0" => (2..=2, component != Component::U32),
        "COLOR_0" => (3..=4, component != Component::U32),
        _ => return true,
    };
    format.columns == 1 && widths.contains(&format.width) && is_allowed
}

/// What a primitive draws, as vertex numbers of its own accessors.
pub enum Drawn {
    Points(Vec<u32>),
    Lines(Vec<Vec<u32>>),
    Triangles(Vec<u32>),
}

/// Reads the indices of a primitive with `count` vertices and resolves its mode.
pub fn draw(source: &Source<'_>, primitive: &Primitive, count: usize) -> Result<Drawn, ReadError> {
    let mut order = match primitive.indices {
        Some(accessor) => {
            let elements = source.elements(accessor)?;
            let Format { component, width, .. } = elements.format;
            if width != 1 || !matches!(component, Component::U8 | Component::U16 | Component::U32) {
                let found = "the indices are not unsigned integers";
                return Err(out_of_range(numbered("accessors", accessor), found));
            }
            let expansion = if primitive.mode == u64::from(mode::TRIANGLES) { 1 } else { 8 };
            source.spend(4 * expansion * elements.count as u64, || primitive.place())?;
            let indices = elements.integers();
            check_range(&indices, elements.format, count, accessor)?;
            indices
        }
        None => {
            source.spend(4 * count as u64, || primitive.place())?;
            (0..count as u32).collect()
        }
    };
    Ok(match u32::try_from(primitive.mode) {
        Ok(mode::POINTS) => Drawn::Points(order),
        Ok(mode::LINES) => Drawn::Lines(order.chunks_exact(2).map(<[u32]>::to_vec).collect()),
        Ok(mode::LINE_LOOP) => Drawn::Lines(polyline(order.iter().chain(order.first()))),
        Ok(mode::LINE_STRIP) => Drawn::Lines(polyline(order.iter())),
        Ok(mode::TRIANGLES) => {
            let rest = order.len() % 3;
            if rest > 0 {
                let corners = counted(rest, "corner", "corners");
                let text = format!("ignored after the last whole triangle: {corners}");
                source.warn(primitive.place(), text);
                order.truncate(order.len() - rest);
            }
            Drawn::Triangles(order)
        }
        Ok(mode::TRIANGLE_STRIP) => Drawn::Triangles(strip(&order)),
        Ok(mode::TRIANGLE_FAN) => Drawn::Triangles(fan(&order)),
        _ => {
            let found = format!("mode {} is out of range (0 to 6)", primitive.mode);
            return Err(out_of_range(primitive.place(), found));
        }
    })
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

fn check_range(indices: &[u32], format: Format, count: usize, accessor: usize) -> Result<(), ReadError> {
    let Some(position) = indices.iter().position(|&index| index as usize >= count) else { return Ok(()) };
    let index = indices[position];
    let found = if index == u32::MAX >> (32 - 8 * format.component.size()) {
        format!("index {position}: the restart value {index} is not allowed")
    } else {
        format!("index {position}: vertex {index} is out of range ({count} vertices)")
    };
    Err(out_of_range(numbered("accessors", accessor), found))
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
