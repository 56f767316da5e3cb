//! Primitives compressed by Draco.
//!
//! Specification: Khronos, `KHR_draco_mesh_compression`, with version 2.2 of the Draco bitstream. Accessors take the counts and bounds of
//! what was decoded: exporters declare those of the original mesh, which quantisation and seams of attributes change.

use super::rebuild::{AddedView, Rebuild};
use crate::io::ReadError;
use crate::io::gltf::data::{Target, bounds, number_list};
use crate::io::gltf::extensions::DRACO;
use crate::io::gltf::fields::{Fields, only_compressed, out_of_range};
use crate::io::gltf::records::{Component, Format, Primitive};
use draco_core::draco_types::DataType;
use draco_core::geometry_indices::PointIndex;
use draco_core::{DecodeLimits, DecoderBuffer, DracoError, Mesh, MeshDecoder, PointAttribute};
use gltf::json::mesh::TRIANGLES;
use rustc_hash::FxHashMap;

/// What an accessor was decoded from: a view and the id of a Draco attribute, or the indices.
type Origin = (usize, Option<u64>);

/// Decompresses the primitives that have no plain copy.
pub fn decode_primitives(rebuild: &mut Rebuild<'_>) -> Result<(), ReadError> {
    let records = rebuild.records;
    let extension = |primitive: &Primitive| records.fields(primitive.object).extension(DRACO);
    let compressed = records.primitives().filter(|primitive| {
        let mut accessors =
            primitive.vertices.sets[0].iter().map(|(_, accessor)| *accessor).chain(primitive.indices);
        extension(primitive).is_some() && accessors.any(|accessor| records.accessors[accessor].view.is_none())
    });
    let compressed: Vec<&Primitive> = compressed.collect();
    if compressed.is_empty() {
        return Ok(());
    }
    rebuild.names.push(DRACO);
    for primitive in records.primitives() {
        rebuild.strip(primitive.object, &[DRACO]);
    }
    let mut decoder = Decoder { rebuild, origins: FxHashMap::default() };
    for primitive in compressed {
        let Some(object) = extension(primitive) else { continue };
        decoder.decode(primitive, Fields::new(&records.json, object)?)?;
    }
    Ok(())
}

struct Decoder<'a, 'b> {
    rebuild: &'b mut Rebuild<'a>,
    /// The accessors that have data by now.
    origins: FxHashMap<usize, Origin>,
}

impl Decoder<'_, '_> {
    fn decode(&mut self, primitive: &Primitive, extension: Fields<'_>) -> Result<(), ReadError> {
        let records = self.rebuild.records;
        let view = extension.required_reference("bufferView", "buffer view", records.views.len())?;
        let indices = primitive.indices.filter(|_| primitive.mode == u64::from(TRIANGLES));
        let Some(indices) = indices else {
            let found = "only indexed triangles are read from Draco data";
            return Err(only_compressed(primitive.place(), found));
        };
        let ids = extension.required_child("attributes")?;
        let mut wanted: Vec<(usize, Origin)> = vec![(indices, (view, None))];
        for (semantic, accessor) in &primitive.vertices.sets[0] {
            let id = ids.integer(semantic)?;
            wanted.extend(id.map(|id| (*accessor, (view, Some(id)))));
        }
        let mut missing = Vec::new();
        for (accessor, origin) in wanted {
            match self.origins.get(&accessor) {
                Some(other) if *other == origin => {}
                Some(_) => {
                    let found = format!("accessor {accessor} has two different sources of Draco data");
                    return Err(out_of_range(primitive.place(), found));
                }
                None => missing.push((accessor, origin.1)),
            }
        }
        if missing.is_empty() {
            return Ok(());
        }
        let mesh = self.mesh(view, &extension)?;
        for (accessor, id) in missing {
            let (format, bytes) = match id {
                None => self.indices(&mesh, accessor),
                Some(id) => self.attribute(&mesh, accessor, id),
            }
            .map_err(|found| out_of_range(extension.place(), found))?;
            let target = if id.is_none() { Target::Indices } else { Target::Vertices };
            self.store(accessor, view, format, target, bytes);
            self.origins.insert(accessor, (view, id));
        }
        Ok(())
    }

    fn mesh(&mut self, view: usize, extension: &Fields<'_>) -> Result<Mesh, ReadError> {
        let place = || extension.place();
        let record = self.rebuild.records.views[view];
        let source = self.rebuild.source(record.buffer, record.offset, record.length, place)?;
        let left = self.rebuild.left();
        // Three indices a triangle, and at least a byte a point, in what is decoded.
        let limits = DecodeLimits::default()
            .with_max_faces(left / 12)
            .with_max_points(left)
            .with_max_decoded_bytes(left);
        let mut mesh = Mesh::new();
        let mut buffer = DecoderBuffer::new(source).with_limits(limits);
        let failure = |error: DracoError| {
            out_of_range(
                place(),
                format!("the data compressed by {DRACO} are damaged or unsupported: {error}"),
            )
        };
        MeshDecoder::new().decode(&mut buffer, &mut mesh).map_err(failure)?;
        Ok(mesh)
    }

    /// The indices, in a wider type than declared if they need one.
    fn indices(&mut self, mesh: &Mesh, accessor: usize) -> Result<(Format, Vec<u8>), String> {
        let declared = self.rebuild.records.accessors[accessor].format;
        let component = match (declared.map(|format| format.component), mesh.num_points()) {
            (Some(Component::U8), 0..=0xFF) => Component::U8,
            (Some(Component::U8 | Component::U16), 0..=0xFFFF) => Component::U16,
            (Some(Component::U8 | Component::U16 | Component::U32), _) => Component::U32,
            _ => return Err(format!("accessor {accessor} of the indices is not of unsigned integers")),
        };
        let format = Format::vector(component, false, 1);
        self.spend(mesh.num_faces(), 3 * format.size())?;
        let mut bytes = Vec::with_capacity(3 * format.size() * mesh.num_faces());
        for index in mesh.faces().iter().flatten() {
            bytes.extend_from_slice(&index.0.to_le_bytes()[..format.size()]);
        }
        Ok((format, bytes))
    }

    /// The values of an attribute by vertex.
    fn attribute(&mut self, mesh: &Mesh, accessor: usize, id: u64) -> Result<(Format, Vec<u8>), String> {
        let attribute = u32::try_from(id).ok().and_then(|id| mesh.attribute_by_unique_id(id));
        let attribute = attribute.ok_or_else(|| format!("the Draco data have no attribute {id}"))?;
        let format = self.rebuild.records.accessors[accessor].format;
        let width = usize::from(attribute.num_components());
        let format = format.filter(|format| format.columns == 1 && format.width == width);
        let format = format.ok_or_else(|| {
            format!("Draco attribute {id} has {width} components and does not match accessor {accessor}")
        })?;
        self.spend(mesh.num_points(), format.size())?;
        let bytes = values(attribute, mesh.num_points(), format.component);
        Ok((format, bytes.map_err(|found| format!("Draco attribute {id}: {found}"))?))
    }

    fn spend(&mut self, count: usize, size: usize) -> Result<(), String> {
        let bytes = (count as u64).saturating_mul(size as u64);
        self.rebuild.spend(bytes, Default::default).map_err(|error| error.found)
    }

    /// Gives an accessor its data: in the place of the compressed view if nothing else uses it, or in a new view.
    fn store(&mut self, accessor: usize, source: usize, format: Format, target: Target, bytes: Vec<u8>) {
        let rebuild = &mut *self.rebuild;
        let record = &rebuild.records.accessors[accessor];
        let count = bytes.len() / format.size();
        let splices = &mut rebuild.splices;
        splices.remove(record.object, "byteOffset");
        if record.count != count as u64 {
            splices.set(record.object, "count", count);
        }
        if record.format.is_none_or(|old| old.component != format.component) {
            splices.set(record.object, "componentType", format.component.as_gl_enum());
        }
        let bounds = bounds(&bytes, format);
        for (name, values) in [("min", &bounds.low), ("max", &bounds.high)] {
            if rebuild.records.json.member(record.object, name).is_some() {
                splices.set(record.object, name, number_list(values));
            }
        }
        let stride = target.stride(format);
        let bytes = match stride {
            Some(stride) => {
                let mut spaced = vec![0; stride * count];
                for (to, from) in spaced.chunks_exact_mut(stride).zip(bytes.chunks_exact(format.size())) {
                    to[..from.len()].copy_from_slice(from);
                }
                spaced
            }
            None => bytes,
        };
        let is_free =
            target == Target::Indices && !rebuild.views.contains_key(&source) && !rebuild.is_used(source);
        let view = if is_free {
            let object = rebuild.records.views[source].object;
            rebuild.splices.remove(object, "byteStride");
            rebuild.splices.set(object, "target", target as u32);
            rebuild.views.insert(source, bytes);
            source
        } else {
            rebuild.added.push(AddedView { bytes, stride, target });
            rebuild.records.views.len() + rebuild.added.len() - 1
        };
        rebuild.splices.set(record.object, "bufferView", view);
    }
}

/// The numbers of an attribute, one element a point, as this type of component.
fn values(attribute: &PointAttribute, points: usize, component: Component) -> Result<Vec<u8>, String> {
    let (kind, width) = (attribute.data_type(), usize::from(attribute.num_components()));
    let size = kind.byte_length();
    let is_float = |kind| matches!(kind, DataType::Float32 | DataType::Float64);
    if is_float(kind) != (component == Component::F32) || kind == DataType::Float64 {
        return Err(format!("{kind:?} does not fit an accessor of {component:?}"));
    }
    let stride = usize::try_from(attribute.byte_stride()).unwrap_or_default();
    let data = attribute.buffer().data();
    let mut bytes = Vec::with_capacity(points * width * component.size());
    for point in 0..points as u32 {
        let start = (attribute.mapped_index(PointIndex(point)).0 as usize).checked_mul(stride);
        let element = start.and_then(|start| data.get(start..)?.get(..size * width));
        let element = element.ok_or_else(|| format!("point {point} has no value"))?;
        if is_float(kind) {
            bytes.extend_from_slice(element);
            continue;
        }
        for number in element.chunks_exact(size) {
            let number = integer(number, kind);
            push_integer(number, component, &mut bytes)
                .ok_or_else(|| format!("{number} does not fit an accessor of {component:?}"))?;
        }
    }
    Ok(bytes)
}

/// A number of up to eight bytes.
fn integer(bytes: &[u8], kind: DataType) -> i128 {
    let mut wide = [0; 8];
    wide[..bytes.len()].copy_from_slice(bytes);
    let unsigned = u64::from_le_bytes(wide);
    let unused = 64 - 8 * bytes.len() as u32;
    match kind {
        DataType::Int8 | DataType::Int16 | DataType::Int32 | DataType::Int64 => {
            i128::from(((unsigned << unused) as i64) >> unused)
        }
        _ => i128::from(unsigned),
    }
}

fn push_integer(number: i128, component: Component, out: &mut Vec<u8>) -> Option<()> {
    match component {
        Component::I8 => out.extend(i8::try_from(number).ok()?.to_le_bytes()),
        Component::U8 => out.extend(u8::try_from(number).ok()?.to_le_bytes()),
        Component::I16 => out.extend(i16::try_from(number).ok()?.to_le_bytes()),
        Component::U16 => out.extend(u16::try_from(number).ok()?.to_le_bytes()),
        _ => out.extend(u32::try_from(number).ok()?.to_le_bytes()),
    }
    Some(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn integers_keep_their_value_or_are_refused() {
        assert_eq!(integer(&[0xFE], DataType::Int8), -2);
        assert_eq!(integer(&[0xFE], DataType::Uint8), 254);
        assert_eq!(integer(&[0xFE, 0xFF, 0xFF, 0xFF], DataType::Int32), -2);
        let mut out = Vec::new();
        assert_eq!(push_integer(254, Component::U16, &mut out), Some(()));
        assert_eq!(push_integer(-2, Component::I8, &mut out), Some(()));
        assert_eq!(out, [254, 0, 254]);
        assert_eq!(push_integer(-1, Component::U16, &mut out), None);
        assert_eq!(push_integer(128, Component::I8, &mut out), None);
    }
}
