//! New normals and tangents for the primitives that share one set of vertices.

use super::member::{Member, drop_draco, rewrite_indices};
use super::rows::{CornerRows, Stored, Tables};
use super::store::{NewData, Remark, Store};
use crate::io::gltf::accessor::{Elements, Source};
use crate::io::gltf::data::Target;
use crate::io::gltf::json::Value;
use crate::io::gltf::records::{Component, Format, VertexAccessors};
use crate::io::{ReadError, TangentPolicy, WriteError, WriteOptions};
use crate::mesh::{NONE, VertexSplit, split_vertices};
use bevy_mikktspace::{Geometry, Ops, TangentSpace, generate_tangents};
use glam::Vec3;
use rustc_hash::FxHashMap;
use std::borrow::Cow;

/// Primitives with the same vertex accessors, all of which get normals.
pub struct Group<'g, 'a> {
    pub vertices: &'g VertexAccessors,
    pub members: &'g [Member<'a>],
    pub source: &'g Source<'a>,
    pub options: &'g WriteOptions,
}

/// An attribute of vertices: the set that it is in, its name and its accessor.
#[derive(Clone, Copy)]
pub struct Attribute<'a> {
    pub set: usize,
    pub semantic: &'a str,
    pub accessor: usize,
}

/// Which normals an edit writes or omits.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Replaced {
    Nothing,
    Normals,
    NormalsAndDeltas,
}

/// A tangent for every corner, and its number among the different ones.
type CornerTangents = (Vec<[f32; 4]>, Vec<u32>);

impl Group<'_, '_> {
    /// Writes what changes. Returns how many vertices were added; below 0 if more were merged.
    pub fn write(&self, store: &mut Store<'_>, tables: &mut Tables) -> Result<i64, WriteError> {
        if self.options.omit_normals && !self.vertices.need_normals() {
            return self.write_without_normals(store);
        }
        let target_sets = self.vertices.target_sets();
        let morph = self.members.iter().all(|member| member.has_morph_normals(target_sets.len()));
        let stored =
            Stored::new(self.source, self.vertices, self.options.normal_format, morph).map_err(unreadable)?;
        let rows = CornerRows::new(&stored, self.members, tables);
        store.remark(Remark::WITHOUT_NORMAL, rows.missing);

        let count = self.members[0].block.count as usize;
        let locals: Vec<u32> = self.corners().map(|(member, corner)| member.vertex(corner)).collect();
        let mut split = split_vertices(count, &locals, &[&rows.of_corner]);
        let mut new_rows = rows.gather(&split);
        if split.added(count) == 0 && stored.is_stored(&new_rows) {
            return self.write_merged(store, &self.others(Replaced::Nothing));
        }
        let has_normals = |set| self.vertices.of_set(set, "NORMAL").is_some();
        let are_new = self.members.iter().any(Member::has_new_normals);
        if are_new && !morph && target_sets.clone().any(has_normals) {
            store.remark(Remark::STALE_DELTAS, self.members.len());
        }
        let new_tangents = self.tangents(&rows, &locals)?;
        let others = self.others(if morph { Replaced::NormalsAndDeltas } else { Replaced::Normals });
        if let Some((_, keys)) = &new_tangents {
            split = split_vertices(count, &locals, &[&rows.of_corner, keys]);
            new_rows = rows.gather(&split);
        } else if let Some(merged) = self.merged(store, &split, Some(&new_rows), &others)? {
            split = merged;
            new_rows = rows.gather(&split);
        }
        rows.repair_unused(&mut new_rows, &split);

        store.is_quantized |= stored.format.component != Component::F32;
        self.put(store, 0, "NORMAL", stored.format, new_rows.take_normals(&stored), false);
        for (target, set) in target_sets.enumerate().take(stored.targets) {
            let deltas = new_rows.deltas(&stored, target);
            if has_normals(set) || deltas.iter().any(|&byte| byte != 0) {
                self.put(store, set, "NORMAL", Format::vector(Component::F32, false, 3), deltas, false);
            }
        }
        self.write_tangents(store, &split, new_tangents.as_ref())?;
        if split.is_identity(count) {
            self.repair_positions(store)?;
        } else {
            self.copy(store, &split, &others)?;
        }
        self.write_indices(store, &split)?;
        Ok(split.source.len() as i64 - count as i64)
    }

    /// Writes dropped and flipped faces, where normals do not change.
    pub fn write_faces(&self, store: &mut Store<'_>) -> Result<(), WriteError> {
        self.repair_positions(store)?;
        for member in self.members {
            let indices = member.corners.iter().map(|&corner| member.vertex(corner)).collect();
            if rewrite_indices(store, member, indices, member.block.count as usize)? {
                drop_draco(store, member);
            }
        }
        Ok(())
    }

    /// Puts vertices without a finite position at the origin, where the mesh has them; no face uses them any more.
    fn repair_positions(&self, store: &mut Store<'_>) -> Result<(), WriteError> {
        for set in 0..self.vertices.sets.len() {
            let Some(accessor) = self.vertices.of_set(set, "POSITION") else { continue };
            let elements = self.source.elements(accessor).map_err(unreadable)?;
            if let Some(bytes) = finite(&elements) {
                self.put(store, set, "POSITION", elements.format, bytes, false);
            }
        }
        Ok(())
    }

    fn corners(&self) -> impl Iterator<Item = (&Member<'_>, u32)> {
        self.members.iter().flat_map(|member| member.corners.iter().map(move |&corner| (member, corner)))
    }

    /// The JSON objects that list the vertex accessors of a set, one a primitive.
    pub fn sites(&self, set: usize) -> Vec<Value> {
        self.members.iter().map(|member| member.primitive.sites[set]).collect()
    }

    fn put(
        &self,
        store: &mut Store<'_>,
        set: usize,
        semantic: &str,
        format: Format,
        bytes: Vec<u8>,
        same_bounds: bool,
    ) {
        let data = NewData { format, bytes, target: Target::Vertices, same_bounds };
        store.put(self.vertices.of_set(set, semantic), semantic, &self.sites(set), data);
    }

    /// Tangents to go with the new normals, if they are wanted and can be had.
    fn tangents(&self, rows: &CornerRows<'_>, locals: &[u32]) -> Result<Option<CornerTangents>, WriteError> {
        let wanted =
            self.options.tangents == TangentPolicy::Regenerate && self.vertices.get("TANGENT").is_some();
        let uv_sets: Option<Vec<usize>> =
            self.members.iter().map(|member| self.uv_accessor(member)).collect();
        let Some(uv_sets) = uv_sets.filter(|_| wanted) else { return Ok(None) };
        let mut values: Vec<[f32; 4]> = Vec::with_capacity(locals.len());
        for (member, uv_set) in self.members.iter().zip(uv_sets) {
            let uvs = self.source.elements(uv_set).map_err(unreadable)?.floats::<2>(0.0);
            let uvs: Vec<[f32; 2]> = uvs.collect();
            let range = values.len()..values.len() + member.corners.len();
            let finite = |uv: [f32; 2]| uv.map(|x| if x.is_finite() { x } else { 0.0 });
            let corners = member.corners.iter();
            let vertices = corners.map(|&corner| member.mesh.faces().corners()[corner as usize]);
            let normals: Vec<Vec3> = range.clone().map(|corner| rows.normal(corner)).collect();
            let mut surface = Surface {
                positions: vertices.map(|v| member.mesh.position(v).as_vec3().to_array()).collect(),
                uvs: locals[range].iter().map(|&vertex| finite(uvs[vertex as usize])).collect(),
                tangents: normals.iter().map(|&normal| perpendicular(normal)).collect(),
                normals,
            };
            // The error type has no values.
            let _ = generate_tangents(&mut surface);
            values.extend(surface.tangents);
        }
        let mut numbers: FxHashMap<[u32; 4], u32> = FxHashMap::default();
        let mut number = |tangent: &[f32; 4]| {
            let next = numbers.len() as u32;
            *numbers.entry(tangent.map(f32::to_bits)).or_insert(next)
        };
        let keys = values.iter().map(&mut number).collect();
        Ok(Some((values, keys)))
    }

    /// The texture coordinates of the material's normal map, which tangents are for.
    fn uv_accessor(&self, member: &Member<'_>) -> Option<usize> {
        let records = self.source.records;
        let set = member.primitive.material.and_then(|material| {
            let json = &records.json;
            let map = json.member(records.materials[material], "normalTexture")?;
            json.integer(json.member(map, "texCoord")?)
        });
        let accessor = self.vertices.get(&format!("TEXCOORD_{}", set.unwrap_or(0)))?;
        let format = records.accessors[accessor].format?;
        (format.width == 2 && format.columns == 1 && format.component != Component::U32).then_some(accessor)
    }

    fn write_tangents(
        &self,
        store: &mut Store<'_>,
        split: &VertexSplit,
        new: Option<&CornerTangents>,
    ) -> Result<(), WriteError> {
        let Some(accessor) = self.vertices.get("TANGENT") else { return Ok(()) };
        let keep = self.options.tangents == TangentPolicy::Keep;
        if let Some((new, _)) = new {
            let old = self.source.elements(accessor).map_err(unreadable)?.floats::<4>(0.0);
            let old: Vec<[f32; 4]> = old.collect();
            let value = |(&sample, &source): (&u32, &u32)| match sample {
                NONE => old[source as usize],
                sample => new[sample as usize],
            };
            let values: Vec<[f32; 4]> = split.sample.iter().zip(&split.source).map(value).collect();
            let format = Format::vector(Component::F32, false, 4);
            self.put(store, 0, "TANGENT", format, bytemuck::cast_slice(&values).to_vec(), false);
        } else if !keep {
            self.sites(0).into_iter().for_each(|site| store.splices.remove(site, "TANGENT"));
            store.remark(Remark::TANGENTS_REMOVED, self.members.len());
        }
        if !keep {
            let sets = self.vertices.target_sets();
            let had: Vec<usize> =
                sets.filter(|&set| self.vertices.of_set(set, "TANGENT").is_some()).collect();
            let sites = had.iter().flat_map(|&set| self.sites(set));
            sites.for_each(|site| store.splices.remove(site, "TANGENT"));
            if new.is_some() && !had.is_empty() {
                store.remark(Remark::TANGENT_DELTAS_REMOVED, self.members.len());
            }
        }
        Ok(())
    }

    /// Copies attributes to new vertices.
    pub fn copy(
        &self,
        store: &mut Store<'_>,
        split: &VertexSplit,
        attributes: &[Attribute<'_>],
    ) -> Result<(), WriteError> {
        for &Attribute { set, semantic, accessor } in attributes {
            let elements = self.source.elements(accessor).map_err(unreadable)?;
            let repaired = if semantic == "POSITION" { finite(&elements) } else { None };
            let same_bounds = repaired.is_none();
            let (raw, size) = (repaired.map_or_else(|| elements.raw(), Cow::Owned), elements.format.size());
            let mut bytes = Vec::with_capacity(size * split.source.len());
            for &vertex in &split.source {
                bytes.extend_from_slice(&raw[vertex as usize * size..(vertex as usize + 1) * size]);
            }
            self.put(store, set, semantic, elements.format, bytes, same_bounds);
        }
        Ok(())
    }

    /// The attributes of vertices, but for normals that are replaced or omitted, and tangents that are.
    fn others(&self, replaced: Replaced) -> Vec<Attribute<'_>> {
        let keeps_tangents = replaced == Replaced::Nothing || self.options.tangents == TangentPolicy::Keep;
        let is_kept = |attribute: &Attribute<'_>| match attribute.semantic {
            "NORMAL" => match replaced {
                Replaced::Nothing => true,
                Replaced::Normals => attribute.set > 0,
                Replaced::NormalsAndDeltas => false,
            },
            "TANGENT" => keeps_tangents,
            _ => true,
        };
        let sets = self.vertices.sets.iter().enumerate();
        let all = sets.flat_map(|(set, list)| {
            list.iter().map(move |(semantic, accessor)| Attribute { set, semantic, accessor: *accessor })
        });
        all.filter(is_kept).collect()
    }

    /// Writes the primitives without normals.
    fn write_without_normals(&self, store: &mut Store<'_>) -> Result<i64, WriteError> {
        if self.vertices.get("NORMAL").is_some() {
            self.sites(0).into_iter().for_each(|site| store.splices.remove(site, "NORMAL"));
            self.members.iter().for_each(|member| drop_draco(store, member));
        }
        self.write_merged(store, &self.others(Replaced::Normals))
    }

    /// Merges vertices whose values do not change, and writes dropped and flipped faces.
    fn write_merged(&self, store: &mut Store<'_>, attributes: &[Attribute<'_>]) -> Result<i64, WriteError> {
        if !self.may_merge() {
            return self.write_faces(store).map(|()| 0);
        }
        let count = self.members[0].block.count as usize;
        let locals: Vec<u32> = self.corners().map(|(member, corner)| member.vertex(corner)).collect();
        let split = split_vertices(count, &locals, &[]);
        let Some(merged) = self.merged(store, &split, None, attributes)? else {
            self.write_faces(store)?;
            return Ok(0);
        };
        self.copy(store, &merged, attributes)?;
        self.write_indices(store, &merged)?;
        Ok(merged.source.len() as i64 - count as i64)
    }

    /// Stores the triangles of all members, whose vertices changed.
    fn write_indices(&self, store: &mut Store<'_>, split: &VertexSplit) -> Result<(), WriteError> {
        let mut corners = split.corners.iter();
        for member in self.members {
            let indices = corners.by_ref().take(member.corners.len()).copied().collect();
            rewrite_indices(store, member, indices, split.source.len())?;
            drop_draco(store, member);
        }
        Ok(())
    }
}

/// The elements with zeros for those that are not finite; `None` if all are.
fn finite(elements: &Elements<'_>) -> Option<Vec<u8>> {
    let is_finite = |vector: &[f32; 3]| vector.iter().all(|x| x.is_finite());
    if elements.floats::<3>(0.0).all(|vector| is_finite(&vector)) {
        return None;
    }
    // Integers are finite, so these are floats.
    let floats = elements.floats(0.0);
    let repaired: Vec<[f32; 3]> = floats.map(|v| if is_finite(&v) { v } else { [0.0; 3] }).collect();
    Some(bytemuck::cast_slice(&repaired).to_vec())
}

/// Reading checked every attribute, so that this only passes on what should not happen.
pub fn unreadable(error: ReadError) -> WriteError {
    WriteError::Unsupported(error.to_string())
}

/// What tangents depend on, one entry a corner, three corners a triangle, and the tangents by MikkTSpace (Mikkelsen,
/// *Simulation of Wrinkled Surfaces Revisited*, 2008).
struct Surface {
    positions: Vec<[f32; 3]>,
    normals: Vec<Vec3>,
    /// As stored, v counted from the top of the image.
    uvs: Vec<[f32; 2]>,
    /// With the handedness in `w`. Where uv have no direction it is some unit vector perpendicular to the normal.
    tangents: Vec<[f32; 4]>,
}

/// The same bits on every platform.
struct Portable;

impl Ops for Portable {
    fn sqrt(x: f32) -> f32 {
        x.sqrt()
    }

    fn acos(x: f32) -> f32 {
        libm::acos(f64::from(x)) as f32
    }
}

impl Geometry<Portable> for Surface {
    fn num_faces(&self) -> usize {
        self.positions.len() / 3
    }

    fn num_vertices_of_face(&self, _face: usize) -> usize {
        3
    }

    fn position(&self, face: usize, vert: usize) -> [f32; 3] {
        self.positions[3 * face + vert]
    }

    fn normal(&self, face: usize, vert: usize) -> [f32; 3] {
        self.normals[3 * face + vert].to_array()
    }

    fn tex_coord(&self, face: usize, vert: usize) -> [f32; 2] {
        self.uvs[3 * face + vert]
    }

    fn set_tangent(&mut self, space: Option<TangentSpace>, face: usize, vert: usize) {
        let Some([x, y, z, w]) = space.map(|space| space.tangent_encoded()) else { return };
        let length = Vec3::new(x, y, z).length();
        if (length - 1.0).abs() < 1e-3 {
            // MikkTSpace counts v upwards.
            self.tangents[3 * face + vert] = [x / length, y / length, z / length, -w];
        }
    }
}

fn perpendicular(normal: Vec3) -> [f32; 4] {
    let axis = if normal.x.abs() < 0.5 { Vec3::X } else { Vec3::Y };
    let [x, y, z] = axis.reject_from_normalized(normal).normalize_or(Vec3::X).to_array();
    [x, y, z, 1.0]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(uvs: [[f32; 2]; 4]) -> Vec<[f32; 4]> {
        let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
        let order = [0, 1, 2, 0, 2, 3];
        let mut surface = Surface {
            positions: order.map(|v: usize| points[v]).to_vec(),
            normals: vec![Vec3::Z; 6],
            uvs: order.map(|v: usize| uvs[v]).to_vec(),
            tangents: vec![perpendicular(Vec3::Z); 6],
        };
        let _ = generate_tangents(&mut surface);
        surface.tangents
    }

    #[test]
    fn a_plain_picture_on_a_square() {
        // glTF's v runs down the image: the picture is upright if v falls as y rises, and then the
        // bitangent w · n × t points up.
        let upright = square([[0.0, 1.0], [1.0, 1.0], [1.0, 0.0], [0.0, 0.0]]);
        assert!(upright.iter().all(|&t| t == [1.0, 0.0, 0.0, 1.0]), "{upright:?}");
        let mirrored = square([[1.0, 1.0], [0.0, 1.0], [0.0, 0.0], [1.0, 0.0]]);
        assert!(mirrored.iter().all(|&t| t == [-1.0, 0.0, 0.0, -1.0]), "{mirrored:?}");
    }

    #[test]
    fn without_a_direction_in_uv_a_tangent_is_still_a_unit_vector() {
        for tangent in square([[0.5, 0.5]; 4]) {
            let length = Vec3::new(tangent[0], tangent[1], tangent[2]).length();
            assert!((length - 1.0).abs() < 1e-6 && tangent[3].abs() == 1.0 && tangent[2].abs() < 1e-6);
        }
    }
}
