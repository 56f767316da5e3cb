//! Compressed documents: when a file is read, meshopt and Draco data become plain accessors, before anything else sees the document.
//!
//! The text of the document is spliced. All plain data that shared a buffer with compressed ones, and what was decompressed, form one
//! new buffer in its place: the BIN chunk of a GLB.
//!
//! Extensions: `EXT_meshopt_compression`, `KHR_meshopt_compression` and `KHR_draco_mesh_compression`.

// Primitives compressed by Draco.
mod draco;
// Buffer views compressed by meshopt.
mod meshopt;
// The new buffer, and the text that describes it.
mod rebuild;

use super::buffers::{Buffer, Buffers, Storage};
use super::glb::{Glb, unpadded};
use super::json::Json;
use super::records::Records;
use crate::io::{Note, OutputContent, Place, Problem, ReadError, ReadOptions, Written};
pub use rebuild::copy_views;
use rebuild::{Rebuild, Rebuilt};
use std::sync::Arc;

/// What a document was before it was decompressed.
#[derive(Clone, Debug)]
pub struct Compression {
    /// The extensions that it used.
    names: Vec<&'static str>,
    /// Bytes of the document and of its buffers that are files.
    bytes: u64,
    /// The files of the buffers that the new one replaces.
    files: Vec<String>,
}

/// The bytes that decompressed data may have: so many times those of the file, and so many for each implied element.
const LARGEST_RATIO: u64 = 64;
const ELEMENT: u64 = 24;

/// Decompresses what is stored only compressed. A document with plain copies of all of its data stays unchanged.
///
/// # Errors
/// Damaged data, and more of them than the limits allow.
pub fn decompress(
    records: Records,
    buffers: Buffers,
    glb: Option<Glb>,
    options: &ReadOptions,
) -> Result<(Records, Buffers, Option<Glb>, Option<Compression>), ReadError> {
    let bytes = records.json.text().len() as u64 + buffers.total();
    let limit = (LARGEST_RATIO * bytes + ELEMENT * options.limits.implied_elements).min(options.limits.bytes);
    let mut rebuild = Rebuild::new(&records, &buffers, limit);
    meshopt::decode_views(&mut rebuild)?;
    draco::decode_primitives(&mut rebuild)?;
    if rebuild.names.is_empty() {
        return Ok((records, buffers, glb, None));
    }
    let names = rebuild.names.clone();
    let rebuilt = rebuild.finish(glb.is_some())?;
    let of_files = buffers.list.iter().filter(|buffer| buffer.storage.file().is_some());
    let document = if glb.is_some() { buffers.file.len() } else { records.json.text().len() };
    let bytes = document as u64 + of_files.map(|buffer| buffer.length).sum::<u64>();
    let files = buffers.list.iter().zip(&rebuilt.is_merged).filter(|(_, is_merged)| **is_merged);
    let files = files.filter_map(|(buffer, _)| Some(buffer.storage.file()?.0.to_owned())).collect();
    let compression = Compression { names, bytes, files };
    let (json, buffers, glb) = reopen(rebuilt, buffers, glb, !compression.files.is_empty(), options)?;
    // The notes on the records are the same as before.
    let records = Records::new(json, &mut Vec::new())?;
    Ok((records, buffers, glb, Some(compression)))
}

/// The document as if it had been read like this.
fn reopen(
    rebuilt: Rebuilt,
    buffers: Buffers,
    glb: Option<Glb>,
    is_external: bool,
    options: &ReadOptions,
) -> Result<(Json, Buffers, Option<Glb>), ReadError> {
    let Rebuilt { text, content, home, is_merged } = rebuilt;
    let length = content.len() as u64;
    let (text, glb, file, storage) = match glb {
        Some(glb) => {
            let too_large = |_| {
                let found = "the decompressed file would have more than 4 GiB, the limit of a GLB";
                ReadError::new(
                    Problem::Limit,
                    Place::File,
                    found,
                    "split the file, or convert it to .gltf first",
                )
            };
            let text = unpadded(&text);
            let (file, _) =
                glb.rewrite(&buffers.file, text, Some([&content, &[], &[]])).map_err(too_large)?;
            let glb = Glb::parse(&file, &mut Vec::new())?;
            let storage = Storage::Bin(glb.bin().unwrap_or_default());
            (text.to_owned(), Some(glb), file, storage)
        }
        None => (text, None, Vec::new(), Storage::Decompressed { bytes: Arc::new(content), is_external }),
    };
    let json = Json::parse(text.into_bytes(), 0, options.limits.json_depth)?;
    let list = buffers.list.into_iter().zip(is_merged).enumerate();
    let list = list.filter_map(|(number, (buffer, is_merged))| match is_merged {
        true => (number == home).then(|| Buffer { storage: storage.clone(), length }),
        false => Some(buffer),
    });
    let list = list.collect();
    Ok((json, Buffers { file, list }, glb))
}

impl Compression {
    /// The bytes of the compressed document and of its buffers that are files.
    pub fn file_bytes(&self) -> u64 {
        self.bytes
    }

    /// Whether the input has its compressed data in a file of this name.
    pub fn has_file(&self, name: &str) -> bool {
        self.files.iter().any(|file| file == name)
    }

    /// How much larger the output is, which is compressed anew or not. Copies of images do not count, other buffers do.
    pub fn note(&self, written: &Written, buffers: &Buffers, is_compressed: bool) -> Note {
        let copied = |path| {
            buffers.list.iter().find(|buffer| buffer.storage.file().is_some_and(|file| file.1 == path))
        };
        let companions = written.companions.iter().map(|file| match &file.content {
            OutputContent::Bytes(bytes) => bytes.len() as u64,
            OutputContent::CopyOf(path) => copied(path).map_or(0, |buffer| buffer.length),
        });
        let (now, before) = (written.bytes.len() as u64 + companions.sum::<u64>(), self.bytes);
        let change = match now.checked_sub(before) {
            Some(more) => format!("{more} more"),
            None => format!("{} fewer", before - now),
        };
        let names = self.names.join(" and ");
        let how = if is_compressed { "compressed anew instead of by" } else { "written without" };
        Note::remark(format!("{how} {names}: {now} bytes, {change} than the input"))
    }
}
