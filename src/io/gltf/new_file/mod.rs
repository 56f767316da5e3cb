//! A new glTF file from meshes.

// Images and textures of its materials.
mod textures;
// Its materials.
mod materials;
// Its meshes and primitives.
mod pieces;
// Tangents for normal textures.
mod tangents;

use super::buffers::address;
use super::data::{Blob, Bounds, Bytes, Target, accessor_json, normal_format, steps, view_json};
use super::edit::compress::compress_as;
use super::extensions::QUANTIZATION;
use super::glb;
use super::json::quoted;
use super::records::{Component, Format as ElementFormat};
use crate::io::mesh_checks::{beyond_f32, blank_uv_note, displacement_note, unsupported_notes};
use crate::io::split_mesh::SplitMesh;
use crate::io::text::counted;
use crate::io::{
    FileMaterial, Format, MaterialFallback, Merge, NormalFormat, Note, OutputContent, OutputFile, Part,
    TangentPolicy, WriteError, WriteOptions, Written,
};
use crate::mesh::{Column, Mesh, NONE, PositionsRef, Storage};
use crate::num::parallel;
use glam::DVec3;
use gltf::json::mesh as mode;
use pieces::{Group, groups, pieces};
use rayon::prelude::*;
use rustc_hash::FxHashMap;
use std::borrow::Cow;
use std::fmt::Write as _;
use tangents::new_tangents;
use textures::NewTextures;

/// Writes a new `.glb` or `.gltf`: one mesh and one node a part, or an object of a part; one primitive a material.
///
/// Positions are rounded to `f32`. Vertices are split where corners differ in normal or uv; polygons are cut into triangles.
/// Faces with a corner without a normal become a primitive without normals, which glTF draws flat. A `.gltf` keeps its data in
/// a companion `<stem>.bin`, or inside if there is no stem.
pub(in crate::io) fn write(
    parts: &[Part],
    materials: &[FileMaterial],
    to: Format,
    options: &WriteOptions,
) -> Result<Written, WriteError> {
    let (pieces, unused) = pieces(parts);
    let known = materials.iter().map(|material| (material.name.as_str(), material)).collect();
    let WriteOptions { normal_format, merge, material, tangents, .. } = *options;
    let textures = NewTextures::new(to == Format::Glb || options.stem.is_none());
    let mut file =
        File { known, normal_format, merge, tangents, fallback: material, textures, ..File::default() };
    for part in &pieces {
        file.part(part)?;
    }
    let mut written = std::mem::take(&mut file.written);
    let old: usize = parts.iter().map(|part| part.mesh.vertex_count()).sum();
    written.count_change(old);
    written.notes.extend(notes(parts, unused, file.textures.note()));
    written.notes.extend(blank_uv_note("glTF", pieces.iter().map(|piece| &**piece), false));
    written.companions.append(&mut file.textures.companions);
    let length = file.blob.length as usize;
    if to == Format::Glb {
        written.bytes = glb::before_bin(&file.json(None), length)?;
        file.blob.append_to(&mut written.bytes);
    } else if length == 0 {
        written.bytes = file.json(None).into_bytes();
    } else {
        let name = options.stem.as_ref().map(|stem| format!("{stem}.bin"));
        let mut data = Vec::with_capacity(length);
        file.blob.append_to(&mut data);
        written.bytes = file.json(Some(&address(name.as_deref(), &data))).into_bytes();
        let companion = name.map(|name| OutputFile { name, content: OutputContent::Bytes(data) });
        written.companions.extend(companion);
    }
    compress_as(options.compression, to, &mut written)?;
    Ok(written)
}

#[derive(Default)]
struct File<'a> {
    written: Written,
    blob: Blob<'a>,
    views: Vec<String>,
    accessors: Vec<String>,
    meshes: Vec<String>,
    nodes: Vec<String>,
    materials: Vec<String>,
    /// The number of each material by its name, and whether it is for vertices with texture coordinates, which textures need.
    material_numbers: FxHashMap<(&'a str, bool), usize>,
    known: FxHashMap<&'a str, &'a FileMaterial>,
    fallback: MaterialFallback,
    /// The numbers of the fallback materials, without and with colours of vertices.
    fallback_numbers: [Option<usize>; 2],
    textures: NewTextures<'a>,
    normal_format: NormalFormat,
    merge: Merge,
    tangents: TangentPolicy,
    is_quantized: bool,
}

impl<'a> File<'a> {
    fn json(&self, buffer_uri: Option<&str>) -> String {
        let generator = concat!("crease ", env!("CARGO_PKG_VERSION"));
        let mut json = format!("{{\"asset\":{{\"version\":\"2.0\",\"generator\":{}}}", quoted(generator));
        if self.is_quantized {
            for list in ["extensionsUsed", "extensionsRequired"] {
                let _ = write!(json, ",\"{list}\":[\"{QUANTIZATION}\"]");
            }
        }
        if !self.nodes.is_empty() {
            let all: Vec<String> = (0..self.nodes.len()).map(|node| node.to_string()).collect();
            let _ = write!(json, ",\"scene\":0,\"scenes\":[{{\"nodes\":[{}]}}]", all.join(","));
        }
        let textures = self.textures.textures();
        let lists = [
            ("nodes", &self.nodes),
            ("meshes", &self.meshes),
            ("materials", &self.materials),
            ("textures", &textures),
            ("images", &self.textures.images),
            ("accessors", &self.accessors),
            ("bufferViews", &self.views),
        ];
        for (name, list) in lists.into_iter().filter(|(_, list)| !list.is_empty()) {
            let _ = write!(json, ",\"{name}\":[{}]", list.join(","));
        }
        if self.blob.length > 0 {
            let uri = buffer_uri.map_or(String::new(), |uri| format!(",\"uri\":{}", quoted(uri)));
            let _ = write!(json, ",\"buffers\":[{{\"byteLength\":{}{uri}}}]", self.blob.length);
        }
        json.push('}');
        json
    }

    fn part(&mut self, part: &'a Part) -> Result<(), WriteError> {
        let mesh = &part.mesh;
        if mesh.vertex_count() == 0 {
            return Ok(());
        }
        let groups = groups(mesh, &mut self.written.notes);
        let mut split = SplitMesh::new(mesh, false, (self.merge, Storage::F32));
        let has_normal_texture = |group: &Group| self.normal_texture(mesh, group.label).is_some();
        let tangents = match self.tangents {
            TangentPolicy::Drop | TangentPolicy::Keep => None,
            TangentPolicy::Auto | TangentPolicy::Regenerate => {
                new_tangents(mesh, &groups, has_normal_texture)
            }
        };
        if let Some(tangents) = &tangents {
            split.refine(&tangents.of_corner);
        }
        let mut attributes = self.attributes(&split)?;
        if let Some(tangents) = &tangents {
            let values = tangents.of_vertices(&split.vertex_of, split.vertex_count());
            let accessor = self.vertices(values, ElementFormat::vector(Component::F32, false, 4), None);
            attributes.textured = format!("{},\"TANGENT\":{accessor}", attributes.full);
        }
        let mut primitives = Vec::new();
        let vertices = split.vertex_count();
        let mut vertex_of = split.vertex_of;
        // A primitive for each material, and separate ones for faces without normals.
        for (group, corners) in groups {
            let indices = match corners {
                None => std::mem::take(&mut vertex_of),
                Some(corners) => corners.iter().map(|&corner| vertex_of[corner as usize]).collect(),
            };
            let indices = self.indices(indices, vertices);
            let list = match group.flat {
                true => &attributes.flat,
                false if self.normal_texture(mesh, group.label).is_some() => &attributes.textured,
                false => &attributes.full,
            };
            let mut json = format!("{{\"attributes\":{{{list}}},\"indices\":{indices}");
            let material = match &mesh.columns().materials {
                Some(labels) if group.label != NONE => {
                    Some(self.material(labels, group.label, mesh.columns().uvs.is_some())?)
                }
                _ => self.fallback_material(mesh.columns().colors.is_some()),
            };
            if let Some(number) = material {
                let _ = write!(json, ",\"material\":{number}");
            }
            json.push('}');
            primitives.push(json);
        }
        self.loose(mesh, &attributes, &mut primitives);
        let name =
            if part.name.is_empty() { String::new() } else { format!(",\"name\":{}", quoted(&part.name)) };
        self.nodes.push(format!("{{\"mesh\":{}{name}}}", self.meshes.len()));
        self.meshes.push(format!("{{\"primitives\":[{}]{name}}}", primitives.join(",")));
        Ok(())
    }

    /// Stores the vertex attributes, which all primitives of the part share.
    fn attributes(&mut self, split: &SplitMesh<'a>) -> Result<Attributes, WriteError> {
        let columns = split.mesh.columns();
        let vertices = split.vertex_count();
        self.written.vertices += vertices as u64;
        let (positions, bounds) = positions(split, &mut self.written.notes)?;
        let float = |width| ElementFormat::vector(Component::F32, false, width);
        let mut loose = format!("\"POSITION\":{}", self.vertices(positions, float(3), Some(&bounds)));
        if let Some(colors) = &columns.colors {
            let clamped = |color: &[f32; 4]| color.map(|c| if c > 0.0 { c.min(1.0) } else { 0.0 });
            let colors: Vec<_> = (0..vertices).map(|v| clamped(&colors[split.source(v)])).collect();
            let accessor = self.vertices(colors, float(4), None);
            let _ = write!(loose, ",\"COLOR_0\":{accessor}");
        }
        let mut flat = loose.clone();
        if let Some(uvs) = &columns.uvs {
            // glTF counts v from the top of the image, meshes count from the bottom.
            let finite = |x: f64| if (x as f32).is_finite() { x as f32 } else { 0.0 };
            let values = values(split, uvs, [0.0; 2], |uv| [finite(uv.x), finite(1.0 - uv.y)]);
            let accessor = self.vertices(values, float(2), None);
            let _ = write!(flat, ",\"TEXCOORD_0\":{accessor}");
        }
        let mut full = flat.clone();
        if let Some(normals) = &columns.normals {
            let _ = write!(full, ",\"NORMAL\":{}", self.normals(split, normals));
        }
        Ok(Attributes { loose, flat, textured: full.clone(), full })
    }

    /// Stores the normal of every vertex, +z where there is none.
    fn normals(&mut self, split: &SplitMesh<'_>, normals: &Column<DVec3>) -> usize {
        let format = normal_format(None, self.normal_format);
        self.is_quantized |= format.normalized;
        // Elements begin at multiples of four bytes.
        let padded = |[x, y, z]: [i32; 3]| [x, y, z, 0];
        match format.component {
            Component::I16 => {
                let coded = |n: &DVec3| padded(steps(*n, i16::MAX.into())).map(|step| step as i16);
                self.vertices(values(split, normals, coded(&DVec3::Z), coded), format, None)
            }
            Component::I8 => {
                let coded = |n: &DVec3| padded(steps(*n, i8::MAX.into())).map(|step| step as i8);
                self.vertices(values(split, normals, coded(&DVec3::Z), coded), format, None)
            }
            _ => {
                let coded = |n: &DVec3| n.as_vec3().to_array();
                self.vertices(values(split, normals, coded(&DVec3::Z), coded), format, None)
            }
        }
    }

    /// Points and lines; a mesh with nothing but vertices is drawn as points.
    fn loose(&mut self, mesh: &'a Mesh, attributes: &Attributes, primitives: &mut Vec<String>) {
        let columns = mesh.columns();
        let vertices = mesh.vertex_count();
        let mut primitive = |file: &mut Self, mode: u32, indices: Cow<'a, [u32]>| {
            let indices = file.indices(indices, vertices);
            let list = &attributes.loose;
            primitives.push(format!("{{\"attributes\":{{{list}}},\"indices\":{indices},\"mode\":{mode}}}"));
        };
        if !columns.points.is_empty() {
            primitive(self, mode::POINTS, Cow::Borrowed(&columns.points));
        }
        match columns.lines.as_slice() {
            [] => {}
            [line] => primitive(self, mode::LINE_STRIP, Cow::Borrowed(line)),
            lines => {
                let segments = lines.iter().flat_map(|line| line.windows(2)).flatten();
                primitive(self, mode::LINES, segments.copied().collect());
            }
        }
        if mesh.face_count() == 0 && columns.points.is_empty() && columns.lines.is_empty() {
            let list = &attributes.loose;
            primitives.push(format!("{{\"attributes\":{{{list}}},\"mode\":{}}}", mode::POINTS));
        }
    }

    /// Stores indices in the smallest type of two or four bytes that has room; the largest value of each is forbidden.
    fn indices(&mut self, indices: Cow<'a, [u32]>, vertices: usize) -> usize {
        let format = |component| ElementFormat::vector(component, false, 1);
        if vertices <= usize::from(u16::MAX) {
            let indices: Vec<u16> = indices.iter().map(|&index| index as u16).collect();
            self.store(indices, format(Component::U16), Target::Indices, None)
        } else {
            self.store(indices, format(Component::U32), Target::Indices, None)
        }
    }

    fn vertices(&mut self, data: impl Bytes + 'a, format: ElementFormat, bounds: Option<&Bounds>) -> usize {
        self.store(data, format, Target::Vertices, bounds)
    }

    /// Stores an array in a view and an accessor of its own, and returns the accessor's number.
    fn store(
        &mut self,
        data: impl Bytes + 'a,
        format: ElementFormat,
        target: Target,
        bounds: Option<&Bounds>,
    ) -> usize {
        let (length, stride) = (data.bytes().len(), target.stride(format));
        let count = length / stride.unwrap_or(format.size());
        let offset = self.blob.push(data);
        self.views.push(view_json(0, offset, length, stride, target));
        self.accessors.push(accessor_json(self.views.len() - 1, format, count, bounds));
        self.accessors.len() - 1
    }
}

fn notes(parts: &[Part], unused: usize, omitted: Option<Note>) -> Vec<Note> {
    let mut notes = unsupported_notes(Format::Gltf, parts);
    if parts.iter().any(|part| part.mesh.columns().smoothing.is_some()) {
        notes.push(Note::remark("glTF has no smoothing groups; the normals keep their effect"));
    }
    notes.extend(omitted);
    if unused > 0 {
        let vertices = counted(unused, "vertex", "vertices");
        notes.push(Note::remark(format!("omitted, because no object uses them: {vertices}")));
    }
    notes
}

/// The members of a primitive's `attributes`: of points and lines, of flat faces, of faces with normals, and of those of them
/// that have a normal texture.
struct Attributes {
    loose: String,
    flat: String,
    full: String,
    textured: String,
}

/// The value of every written vertex, `default` where it has none.
fn values<T: Sync, U: Copy + Send + Sync>(
    split: &SplitMesh<'_>,
    column: &Column<T>,
    default: U,
    convert: impl Fn(&T) -> U + Send + Sync,
) -> Vec<U> {
    let vertices = (0..split.vertex_count()).into_par_iter();
    vertices.map(|vertex| split.value(column, vertex).map_or(default, &convert)).collect()
}

/// Positions in single precision: those of a mesh, if it has such.
type Singles<'a> = Cow<'a, [[f32; 3]]>;

/// Positions as `f32`, and their bounds.
fn positions<'a>(split: &SplitMesh<'a>, notes: &mut Vec<Note>) -> Result<(Singles<'a>, Bounds), WriteError> {
    let mesh = split.mesh;
    let rounded: Singles = match mesh.positions() {
        PositionsRef::F32(points) => points.into(),
        PositionsRef::F64(points) => points.par_iter().map(|p| p.as_vec3().to_array()).collect(),
    };
    let none = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
    let join = |(low, high): ([f32; 3], [f32; 3]), (l, h): ([f32; 3], [f32; 3])| {
        let axes = [0, 1, 2];
        (axes.map(|axis| low[axis].min(l[axis])), axes.map(|axis| high[axis].max(h[axis])))
    };
    // One zero only: which of two wins would depend on how the work is divided.
    let plain = |p: &[f32; 3]| p.map(|x| x + 0.0);
    let bounds = |points: &[[f32; 3]]| points.iter().map(plain).map(|p| (p, p)).fold(none, join);
    let bounds = parallel::ranges(rounded.len(), |range| bounds(&rounded[range]));
    let (low, high) = bounds.into_iter().fold(none, join);
    if low.iter().chain(&high).any(|bound| bound.is_infinite()) {
        return Err(beyond_f32(mesh));
    }
    notes.extend(displacement_note(mesh));
    let double = |bound: [f32; 3]| bound.map(f64::from).to_vec();
    let bounds = Bounds { low: double(low), high: double(high) };
    let all = || (0..split.vertex_count()).map(|vertex| rounded[split.source(vertex)]).collect();
    Ok((if split.is_identity() { rounded } else { all() }, bounds))
}
