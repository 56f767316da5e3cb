//! The bytes behind `buffers`: the BIN chunk, data URIs, files.

use crate::io::companion::{Companions, Refusal};
use crate::io::gltf::container::uri::{self, Uri};
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
    let mut files: FxHashMap<PathBuf, Arc<Vec<u8>>> = FxHashMap::default();
    let mut left = options.limits.bytes.saturating_sub(file.len().max(json.text().len()) as u64);
    let mut list = Vec::with_capacity(objects.len());
    for (number, &object) in objects.iter().enumerate() {
        let fields = Fields { json, object, at: At::new("buffers", number) };
        let length = fields.required("byteLength")?;
        let place = fields.at.member("uri");
        let storage = match fields.string("uri")? {
            None => match &bin {
                Some(bin) if number == 0 => Storage::Bin(bin.clone()),
                _ if length == 0 || is_fallback(&fields) => Storage::Absent,
                _ if number == 0 && !file.is_empty() => {
                    let found = "the first buffer is the BIN chunk, which the file does not have";
                    let advice = "the file is cut off, or its writer is at fault; copy or export it again";
                    return Err(ReadError::new(Problem::Companion, fields.at.place(), found, advice));
                }
                _ => {
                    let advice = "put the data beside the document and name it in `uri`";
                    return Err(ReadError::new(Problem::Companion, place, "a buffer without data", advice));
                }
            },
            Some(uri) => match Uri::parse(&uri) {
                Uri::Data => Storage::Embedded(Arc::new(uri::decode_data(&uri, place)?)),
                Uri::Elsewhere => {
                    let found = format!("the buffer is at {:?}", uri.chars().take(100).collect::<String>());
                    let advice = "nothing is read from networks; download it and name the file";
                    return Err(ReadError::new(Problem::Companion, place, found, advice));
                }
                Uri::File(name) => {
                    let path = companion(base, options, &name).map_err(|why| {
                        let found = format!("the buffer {name:?} {why}");
                        let advice =
                            "put it beside the document; a stream has no folder, there it must be inside";
                        ReadError::new(Problem::Companion, place.clone(), found, advice)
                    })?;
                    let bytes = match files.get(&path) {
                        Some(bytes) => bytes.clone(),
                        None => {
                            let bytes = Arc::new(read(&path, &name, &mut left, place)?);
                            files.insert(path.clone(), bytes.clone());
                            bytes
                        }
                    };
                    Storage::File { name, path, bytes }
                }
            },
        };
        let available = match &storage {
            Storage::Bin(range) => range.len() as u64,
            Storage::Embedded(bytes) | Storage::File { bytes, .. } => bytes.len() as u64,
            Storage::Absent => 0,
        };
        if length > available && !matches!(storage, Storage::Absent) {
            let found =
                format!("a buffer of {}, where {available} are there", counted(length, "byte", "bytes"));
            let advice = "the data are cut off; copy or export the file again";
            return Err(ReadError::new(Problem::Truncated, fields.at.member("byteLength"), found, advice));
        }
        list.push(Buffer { storage, length: length.min(available) });
    }
    Ok(Buffers { file, list })
}

fn companion(base: Option<&Path>, options: &ReadOptions, name: &str) -> Result<PathBuf, Refusal> {
    let folder = base.or(options.root.as_deref()).ok_or(Refusal::Missing)?;
    Companions::new(folder, options).find(Path::new(""), name)
}

fn is_fallback(fields: &Fields<'_>) -> bool {
    ["EXT_meshopt_compression", "KHR_meshopt_compression"]
        .into_iter()
        .any(|name| fields.extension(name).is_some())
}

fn read(path: &Path, name: &str, left: &mut u64, place: Place) -> Result<Vec<u8>, ReadError> {
    let failed = |problem, found| {
        ReadError::new(problem, place.clone(), found, "put a readable file beside the document")
    };
    let io = |error| failed(Problem::Io, format!("{name:?} cannot be read ({error})"));
    let size = std::fs::metadata(path).map_err(io)?.len();
    *left = left.checked_sub(size).ok_or_else(|| {
        failed(
            Problem::Limit,
            format!("{name:?} has {size} bytes, which goes beyond the limit for one input"),
        )
    })?;
    std::fs::read(path).map_err(io)
}

/// Warns of images that are not there, or that point where nothing is read. Images themselves are never opened.
/// Returns the image files that are there, as relative name and path.
pub fn check_images(
    json: &Json,
    images: &[Value],
    base: Option<&Path>,
    options: &ReadOptions,
    notes: &mut Vec<Note>,
) -> Result<Vec<(String, PathBuf)>, ReadError> {
    let mut present = Vec::new();
    let mut absent: Vec<(Place, String)> = Vec::new();
    for (number, &object) in images.iter().enumerate() {
        let fields = Fields { json, object, at: At::new("images", number) };
        let Some(uri) = fields.string("uri")? else { continue };
        let place = fields.at.member("uri");
        match Uri::parse(&uri) {
            Uri::Data => {}
            Uri::Elsewhere => {
                absent.push((place, "is not a file of this folder, and is not looked at".into()))
            }
            Uri::File(name) => match companion(base, options, &name) {
                Ok(path) => present.push((name, path)),
                Err(why) => absent.push((place, format!("{name:?} {why}"))),
            },
        }
    }
    let text = absent.first().map(|(_, why)| format!("the image {why}")).unwrap_or_default();
    let count = absent.len() as u64;
    let places = absent.into_iter().map(|(place, _)| place);
    notes.extend(Note::for_all(Severity::Warning, count, places, text));
    Ok(present)
}
