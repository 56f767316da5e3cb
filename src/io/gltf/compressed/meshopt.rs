//! Buffer views compressed by meshopt.
//!
//! Specification: Khronos, `EXT_meshopt_compression` and `KHR_meshopt_compression`. Both versions of each bitstream and all filters are
//! read under both names.

use super::rebuild::Rebuild;
use crate::io::ReadError;
use crate::io::gltf::fields::{Fields, only_compressed, out_of_range};
use crate::io::gltf::records::{MESHOPT, View};
use meshoptimizer_rs::codec::{
    decode_filter_color, decode_filter_exp, decode_filter_oct, decode_filter_quat, decode_index_buffer,
    decode_index_sequence, decode_vertex_buffer,
};
use meshoptimizer_rs::{Error, Limits, Workspace};

/// A compressed view, as its extension describes it.
struct Stream<'a> {
    source: &'a [u8],
    mode: String,
    filter: String,
    count: usize,
    stride: usize,
}

/// Decompresses the views that have no plain copy.
pub fn decode_views(rebuild: &mut Rebuild<'_>) -> Result<(), ReadError> {
    let (records, buffers) = (rebuild.records, rebuild.buffers);
    let is_stored = |view: &View| buffers.bytes(view.buffer).is_some();
    if !records.views.iter().any(|view| view.meshopt.is_some() && !is_stored(view)) {
        return Ok(());
    }
    rebuild
        .names
        .extend(MESHOPT.iter().filter(|name| records.views.iter().any(|view| view.meshopt == Some(*name))));
    for (number, view) in records.views.iter().enumerate() {
        let Some(name) = view.meshopt else { continue };
        let fields = records.fields(view.object);
        rebuild.strip(view.object, &MESHOPT);
        if is_stored(view) {
            continue;
        }
        let Some(extension) = fields.extension(name) else { continue };
        let extension = Fields::new(fields.json, extension)?;
        let stream = stream(rebuild, view, extension)?;
        rebuild.spend(view.length, || extension.place())?;
        let bytes = stream.decode().map_err(|error| failure(error, name, &extension))?;
        rebuild.merge(view.buffer);
        rebuild.views.insert(number, bytes);
    }
    Ok(())
}

fn stream<'a>(
    rebuild: &mut Rebuild<'a>,
    view: &View,
    extension: Fields<'_>,
) -> Result<Stream<'a>, ReadError> {
    let buffer = extension.required_reference("buffer", "buffer", rebuild.buffers.list.len())?;
    let (offset, length) = (extension.integer("byteOffset")?.unwrap_or(0), extension.required("byteLength")?);
    let source = rebuild.source(buffer, offset, length, || extension.place())?;
    let (count, stride) = (extension.required("count")?, extension.required("byteStride")?);
    if count.checked_mul(stride) != Some(view.length) || count == 0 {
        let length = view.length;
        let found =
            format!("{count} compressed elements of {stride} bytes do not match the view of {length} bytes");
        return Err(out_of_range(extension.place(), found));
    }
    let mode = extension.required_string("mode")?.into_owned();
    let filter = extension.string("filter")?.unwrap_or("NONE".into()).into_owned();
    let known = match &*mode {
        "ATTRIBUTES" => ["NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL", "COLOR"].contains(&&*filter),
        "TRIANGLES" | "INDICES" => filter == "NONE",
        _ => false,
    };
    if !known {
        let found = format!("unknown compression mode {mode:?} with filter {filter:?}");
        return Err(only_compressed(extension.place(), found));
    }
    Ok(Stream { source, mode, filter, count: count as usize, stride: stride as usize })
}

impl Stream<'_> {
    fn decode(&self) -> Result<Vec<u8>, Error> {
        let &Stream { source, count, stride, .. } = self;
        // The size of the output is limited already, and the work is linear in it.
        let workspace = &mut Workspace::new(Limits { max_bytes: usize::MAX, max_work: u64::MAX });
        let mut bytes = match &*self.mode {
            "TRIANGLES" => decode_index_buffer(count, stride, source, workspace)?,
            "INDICES" => decode_index_sequence(count, stride, source, workspace)?,
            _ => decode_vertex_buffer(count, stride, source, workspace)?,
        };
        match &*self.filter {
            "OCTAHEDRAL" => decode_filter_oct(&mut bytes, count, stride, workspace)?,
            "QUATERNION" => decode_filter_quat(&mut bytes, count, stride, workspace)?,
            "EXPONENTIAL" => decode_filter_exp(&mut bytes, count, stride, workspace)?,
            "COLOR" => decode_filter_color(&mut bytes, count, stride, workspace)?,
            _ => {}
        }
        Ok(bytes)
    }
}

fn failure(error: Error, name: &str, extension: &Fields<'_>) -> ReadError {
    if error == Error::UnsupportedVersion {
        let found = format!("a version of {name} that crease does not know");
        return only_compressed(extension.place(), found);
    }
    out_of_range(extension.place(), format!("the data compressed by {name} are damaged: {error}"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use meshoptimizer_rs::codec::{VertexEncoding, encode_vertex_buffer};

    /// One element of each filter, computed by the formulas of the specification.
    #[test]
    fn filters_are_those_of_the_specification() {
        let cases: [(&str, &[u8], &[u8]); 7] = [
            ("NONE", &[1, 2, 3, 4], &[1, 2, 3, 4]),
            // 3 · 2¹ and −1 · 2⁻¹.
            ("EXPONENTIAL", &[3, 0, 0, 1], &6.0_f32.to_le_bytes()),
            ("EXPONENTIAL", &[0xFF; 4], &(-0.5_f32).to_le_bytes()),
            ("OCTAHEDRAL", &[0, 0, 127, 5], &[0, 0, 127, 5]),
            // The sum of |x| and |y| is beyond 1: z is negative.
            ("OCTAHEDRAL", &[127, 127, 127, 5], &[0, 0, 129, 5]),
            // The last component is the largest and not stored.
            ("QUATERNION", &[0, 0, 0, 0, 0, 0, 0xFF, 7], &[0, 0, 0, 0, 0, 0, 0xFF, 0x7F]),
            ("COLOR", &[100, 0, 0, 0xFF], &[100, 100, 100, 0xFF]),
        ];
        for (filter, stored, expected) in cases {
            for version in [0, 1] {
                let encoding = VertexEncoding::new(version, 2).unwrap();
                let workspace = &mut Workspace::default();
                let source = encode_vertex_buffer(stored, 1, stored.len(), encoding, workspace).unwrap();
                let (mode, filter) = ("ATTRIBUTES".to_owned(), filter.to_owned());
                let stream = Stream { source: &source, mode, filter, count: 1, stride: stored.len() };
                assert_eq!(stream.decode().unwrap(), expected, "{}", stream.filter);
            }
        }
    }
}
