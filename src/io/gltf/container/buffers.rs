//! The bytes behind `buffers`: the BIN chunk, data URIs, files.

use crate::io::companion_files::{Companions, Refusal};
use crate::io::gltf::container::uri::{self, Uri};
use crate::io::gltf::document::records::MESHOPT;
use crate::io::gltf::json::fields::{At, Fields};
use crate::io::gltf::json::tree::{Json, Value};
use crate::io::text::counted;
use crate::io::{Note, Place, Problem, ReadError, ReadOptions, Severity};
use rustc_hash::FxHashMap;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Where the bytes of a buffer are.
#[derive(Clone, Debug)]
pub enum Storage {
    /// In the BIN chunk of the file itself.
    Bin(Range<usize>),
    /// In the JSON, as a data URI.
    Embedded(Arc<Vec<u8>>),
    /// In a file of its own.
    File { name: String, path: PathBuf, bytes: Arc<Vec<u8>> },
    /// Nowhere: only a compressed copy exists.
    Absent,
}

/// A buffer: its declared length, never more than what is there.
#[derive(Clone, Debug)]
pub struct Buffer {
    pub storage: Storage,
    pub length: u64,
}

/// All buffers of a document.
#[derive(Clone, Debug, Default)]
pub struct Buffers {
    /// The file, for the BIN chunk; empty for `.gltf`.
    pub file: Vec<u8>,
    pub list: Vec<Buffer>,
}

impl Buffers {
    /// The bytes of a buffer, cut to its declared length; `None` if only a compressed copy exists.
    pub fn bytes(&self, buffer: usize) -> Option<&[u8]> {
        let buffer = &self.list[buffer];
        let bytes: &[u8] = match &buffer.storage {
            Storage::Bin(range) => &self.file[range.clone()],
            Storage::Embedded(bytes) | Storage::File { bytes, .. } => bytes,
            Storage::Absent => return None,
        };
        Some(&bytes[..buffer.length as usize])
    }

    /// Sum of all lengths, which bounds what decoding may allocate.
    pub fn total(&self) -> u64 {
        self.list.iter().map(|buffer| buffer.length).sum()
    }
}

/// Finds the bytes of every buffer.
pub fn load(
    json: &Json,
    objects: &[Value],
    file: Vec<u8>,
    bin: Option<Range<usize>>,
    base: Option<&Path>,
    options: &ReadOptions,
) -> Result<Buffers, ReadError> {
    let left = options.limits.bytes.saturating_sub(file.len().max(json.text().len()) as u64);
    let mut files = Files { base, options, left, known: FxHashMap::default() };
    let mut list = Vec::with_capacity(objects.len());
    for (number, &object) in objects.iter().enumerate() {
        let fields = Fields { json, object, at: At::new("buffers", number) };
        let length = fields.required("byteLength")?;
        let storage = match (fields.string("uri")?, &bin) {
            (Some(uri), _) => files.storage(&uri, fields.at.member("uri"))?,
            (None, Some(bin)) if number == 0 => Storage::Bin(bin.clone()),
            _ if length == 0 || MESHOPT.iter().any(|name| fields.extension(name).is_some()) => {
                Storage::Absent
            }
            _ if number == 0 && !file.is_empty() => {
                let found = "the first buffer is the BIN chunk, which the file does not have";
                let advice = "the file is cut off, or its writer is at fault; copy or export it again";
                return Err(refused(fields.at.place(), found, advice));
            }
            _ => {
                let advice = "put the data beside the document and name it in `uri`";
                return Err(refused(fields.at.member("uri"), "a buffer without data", advice));
            }
        };
        let available = match &storage {
            Storage::Bin(range) => range.len() as u64,
            Storage::Embedded(bytes) | Storage::File { bytes, .. } => bytes.len() as u64,
            Storage::Absent => 0,
        };
        if length > available && !matches!(storage, Storage::Absent) {
            let length = counted(length, "byte", "bytes");
            let found = format!("a buffer of {length}, where {available} are there");
            let advice = "the data are cut off; copy or export the file again";
            return Err(ReadError::new(Problem::Truncated, fields.at.member("byteLength"), found, advice));
        }
        list.push(Buffer { storage, length: length.min(available) });
    }
    Ok(Buffers { file, list })
}

fn refused(place: Place, found: impl Into<String>, advice: &str) -> ReadError {
    ReadError::new(Problem::Companion, place, found, advice)
}

/// The files of a document, each read once.
struct Files<'a> {
    base: Option<&'a Path>,
    options: &'a ReadOptions,
    /// Bytes that may still be read.
    left: u64,
    known: FxHashMap<PathBuf, Arc<Vec<u8>>>,
}

impl Files<'_> {
    /// The bytes at the address of a buffer.
    fn storage(&mut self, uri: &str, place: Place) -> Result<Storage, ReadError> {
        let name = match Uri::parse(uri) {
            Uri::Data => return Ok(Storage::Embedded(Arc::new(uri::decode_data(uri, place)?))),
            Uri::Elsewhere => {
                let found = format!("the buffer is at {:?}", uri.chars().take(100).collect::<String>());
                let advice = "nothing is read from networks; download it and name the file";
                return Err(refused(place, found, advice));
            }
            Uri::File(name) => name,
        };
        let path = companion(self.base, self.options, &name).map_err(|why| {
            let advice = "put it beside the document; a stream has no folder, there it must be inside";
            refused(place.clone(), format!("the buffer {name:?} {why}"), advice)
        })?;
        if let Some(bytes) = self.known.get(&path) {
            return Ok(Storage::File { name, path, bytes: bytes.clone() });
        }
        let failed = |problem, found| {
            ReadError::new(problem, place.clone(), found, "put a readable file beside the document")
        };
        let io = |error| failed(Problem::Io, format!("{name:?} cannot be read ({error})"));
        let size = std::fs::metadata(&path).map_err(io)?.len();
        self.left = self.left.checked_sub(size).ok_or_else(|| {
            let found = format!("{name:?} has {size} bytes, which goes beyond the limit for one input");
            failed(Problem::Limit, found)
        })?;
        let bytes = Arc::new(std::fs::read(&path).map_err(io)?);
        self.known.insert(path.clone(), bytes.clone());
        Ok(Storage::File { name, path, bytes })
    }
}

fn companion(base: Option<&Path>, options: &ReadOptions, name: &str) -> Result<PathBuf, Refusal> {
    let folder = base.or(options.root.as_deref()).ok_or(Refusal::Missing)?;
    Companions::new(folder, options).find(Path::new(""), name)
}

/// Warns of images that are not there, or that point where nothing is read. Images themselves are never opened.
/// Returns the image files that are there, as relative name and path.
pub fn check_images(
    json: &Json,
    base: Option<&Path>,
    options: &ReadOptions,
    notes: &mut Vec<Note>,
) -> Result<Vec<(String, PathBuf)>, ReadError> {
    let mut present = Vec::new();
    let mut absent: Vec<(Place, String)> = Vec::new();
    for (number, object) in Fields::root(json).list("images")?.into_iter().enumerate() {
        let fields = Fields { json, object, at: At::new("images", number) };
        let Some(uri) = fields.string("uri")? else { continue };
        let why = match Uri::parse(&uri) {
            Uri::Data => continue,
            Uri::Elsewhere => "is not a file of this folder, and is not looked at".to_owned(),
            Uri::File(name) => match companion(base, options, &name) {
                Ok(path) => {
                    present.push((name, path));
                    continue;
                }
                Err(why) => format!("{name:?} {why}"),
            },
        };
        absent.push((fields.at.member("uri"), why));
    }
    let text = absent.first().map(|(_, why)| format!("the image {why}")).unwrap_or_default();
    let count = absent.len() as u64;
    let places = absent.into_iter().map(|(place, _)| place);
    notes.extend(Note::for_all(Severity::Warning, count, places, text));
    Ok(present)
}
