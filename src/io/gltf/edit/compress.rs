//! A GLB whose vertices, indices and other numbers of accessors are compressed by meshopt, without loss.
//!
//! Specification: Khronos, `EXT_meshopt_compression`. Triangles may begin with another of their corners, in the same order around.

use super::compact::opened;
use crate::io::gltf::compressed::copy_views;
use crate::io::gltf::extensions::ORDERED;
use crate::io::gltf::glb::{padded, unpadded};
use crate::io::gltf::records::{Component, MESHOPT, Records};
use crate::io::gltf::splice::Splices;
use crate::io::{Format, MeshCompression, Note, WriteError, Written};
use gltf::json::mesh::TRIANGLES;
use meshoptimizer_rs::codec::{
    IndexEncoding, VertexEncoding, encode_index_buffer, encode_index_sequence, encode_vertex_buffer,
};
use meshoptimizer_rs::{Error, Limits, Workspace};

/// What a view holds, which decides how it is compressed.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Content {
    /// Elements of this many bytes.
    Elements(usize),
    /// Indices of this many bytes, of whole triangles or not.
    Indices(usize, bool),
    /// Something else, or several of these.
    Other,
}

impl Content {
    fn mode(self) -> (&'static str, usize) {
        match self {
            Content::Indices(size, true) => ("TRIANGLES", size),
            Content::Indices(size, false) => ("INDICES", size),
            Content::Elements(stride) => ("ATTRIBUTES", stride),
            Content::Other => ("", 1),
        }
    }
}

/// The largest element that the format allows.
const LARGEST_STRIDE: usize = 256;

/// Compresses an output in place as the options ask. Returns whether it is compressed then; if not, a note says why.
///
/// # Errors
/// Another format than GLB.
pub fn compress_as(
    compression: MeshCompression,
    to: Format,
    written: &mut Written,
) -> Result<bool, WriteError> {
    if compression == MeshCompression::None {
        return Ok(false);
    }
    if to != Format::Glb {
        return Err(WriteError::not_compressible(to));
    }
    let Some(bytes) = compress(&written.bytes)? else {
        written.notes.push(Note::remark("compression by meshopt makes nothing in the file smaller"));
        return Ok(false);
    };
    written.bytes = bytes;
    Ok(true)
}

/// Compresses a GLB. `None` if its data are not in its BIN chunk, or no view would become smaller.
///
/// # Errors
/// What makes the file unreadable.
fn compress(bytes: &[u8]) -> Result<Option<Vec<u8>>, WriteError> {
    let Some((glb, records, bin)) = opened(bytes)? else { return Ok(None) };
    let contents = contents(&records);
    let (mut streams, mut plain) = (Vec::new(), Vec::new());
    for (number, view) in records.views.iter().enumerate().filter(|(_, view)| view.buffer == 0) {
        let range = view.offset as usize..view.offset.saturating_add(view.length) as usize;
        let Some(old) = bin.get(range) else { return Ok(None) };
        let stream = if view.extended { None } else { encode(old, contents[number]) };
        match stream.filter(|stream| stream.len() < old.len()) {
            Some(stream) => streams.push((view, contents[number].mode(), stream)),
            None => plain.push((number, *view)),
        }
    }
    if streams.is_empty() {
        return Ok(None);
    }
    let mut splices = Splices::new(&records.json);
    let mut content = Vec::new();
    for (number, offset) in copy_views(plain, |_| bin, &mut content) {
        if records.views[number].offset != offset {
            splices.set(records.views[number].object, "byteOffset", offset);
        }
    }
    // Decompressed views are places in a buffer without data.
    let (fallback, mut length) = (records.buffers.len(), 0);
    for (view, (mode, stride), stream) in streams {
        content.resize(padded(content.len()), 0);
        let (offset, size, count) = (content.len(), stream.len(), view.length as usize / stride);
        content.extend_from_slice(&stream);
        let extension = format!(
            "{{\"{}\":{{\"buffer\":0,\"byteOffset\":{offset},\"byteLength\":{size},\"byteStride\":{stride},\"count\":{count},\"mode\":\"{mode}\"}}}}",
            MESHOPT[0]
        );
        splices.set(view.object, "buffer", fallback);
        splices.set(view.object, "byteOffset", length);
        splices.set(view.object, "extensions", extension);
        length += padded(view.length as usize);
    }
    splices.set(records.buffers[0], "byteLength", content.len());
    let mark =
        format!("{{\"byteLength\":{length},\"extensions\":{{\"{}\":{{\"fallback\":true}}}}}}", MESHOPT[0]);
    splices.push("buffers", mark);
    splices.require(MESHOPT[0]);
    Ok(Some(glb.rewrite(bytes, unpadded(&splices.apply()), Some([&content, &[], &[]]))?.0))
}

/// What each view holds.
fn contents(records: &Records) -> Vec<Content> {
    let json = &records.json;
    let mut contents: Vec<Option<Content>> = vec![None; records.views.len()];
    let mut add = |view: usize, content: Content| {
        let known = contents[view].get_or_insert(content);
        if *known != content {
            *known = Content::Other;
        }
    };
    // Extensions may mean triangles by their first corners or by number.
    let names = || json.items(json.root(), "extensionsUsed").filter_map(|name| json.string(name));
    let is_fixed = names().any(|name| {
        name == "FB_ngon_encoding" || ORDERED.iter().any(|(ordered, _)| name.starts_with(ordered))
    });
    for (_, name, accessor) in records.references() {
        let record = &records.accessors[accessor];
        let (Some(view), Some(format)) = (record.view, record.format) else { continue };
        if name != "indices" {
            let stride = records.views[view].stride.unwrap_or(format.size() as u64);
            add(view, usize::try_from(stride).map_or(Content::Other, Content::Elements));
        }
    }
    for primitive in records.primitives() {
        let Some(record) = primitive.indices.map(|accessor| &records.accessors[accessor]) else { continue };
        let (Some(view), Some(format)) = (record.view, record.format) else { continue };
        let is_whole = record.offset == 0
            && records.views[view].length == record.count.saturating_mul(format.size() as u64);
        let is_list = primitive.mode == u64::from(TRIANGLES) && record.count.is_multiple_of(3) && !is_fixed;
        let is_wide = matches!(format.component, Component::U16 | Component::U32) && format.width == 1;
        let content =
            if is_whole && is_wide { Content::Indices(format.size(), is_list) } else { Content::Other };
        add(view, content);
    }
    let others = records.sparse_views().chain(records.images().map(|(_, view)| view));
    others.for_each(|view| add(view, Content::Other));
    contents.into_iter().map(|content| content.unwrap_or(Content::Other)).collect()
}

/// The compressed bytes; `None` for what meshopt cannot compress.
fn encode(bytes: &[u8], content: Content) -> Option<Vec<u8>> {
    // Work and memory are linear in the size of the view.
    let workspace = &mut Workspace::new(Limits { max_bytes: usize::MAX, max_work: u64::MAX });
    let encoded: Result<Vec<u8>, Error> = match content {
        Content::Elements(stride) => {
            let is_allowed = stride > 0 && stride.is_multiple_of(4) && stride <= LARGEST_STRIDE;
            if !is_allowed || bytes.is_empty() || !bytes.len().is_multiple_of(stride) {
                return None;
            }
            // All readers know this version.
            let oldest = VertexEncoding::new(0, 0).ok()?;
            encode_vertex_buffer(bytes, bytes.len() / stride, stride, oldest, workspace)
        }
        Content::Indices(size, is_list) => {
            let index =
                |bytes: &[u8]| bytes.iter().rev().fold(0, |index, &byte| index << 8 | u32::from(byte));
            let indices: Vec<u32> = bytes.chunks_exact(size).map(index).collect();
            match is_list {
                true => encode_index_buffer(&indices, IndexEncoding::DEFAULT, workspace),
                false => encode_index_sequence(&indices, IndexEncoding::DEFAULT, workspace),
            }
        }
        Content::Other => return None,
    };
    encoded.ok()
}
