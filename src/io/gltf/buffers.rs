//! The bytes behind `buffers`: the BIN chunk, data URIs, files.

use super::fields::Fields;
use super::glb::TRUNCATED;
use super::json::{Json, Value};
use super::records::MESHOPT;
use crate::io::companion_files::{Refusal, find};
use crate::io::{Note, Place, Problem, ReadError, ReadOptions, Severity};
use base64::engine::{DecodePaddingMode, GeneralPurpose, GeneralPurposeConfig};
use base64::{DecodeError, Engine};
use rustc_hash::FxHashMap;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;

#[derive(Clone, Debug)]
pub enum Storage {
    Bin(Range<usize>),
    Embedded(Arc<Vec<u8>>),
    File {
        name: String,
        path: PathBuf,
        bytes: Arc<Vec<u8>>,
    },
    /// What was decompressed when the document was read, and whether the compressed data were in a file of their own.
    Decompressed {
        bytes: Arc<Vec<u8>>,
        is_external: bool,
    },
    /// No data: only a compressed copy exists.
    Absent,
}

impl Storage {
    /// The bytes, of a BIN chunk from the `file`; `None` if only a compressed copy exists.
    fn bytes<'a>(&'a self, file: &'a [u8]) -> Option<&'a [u8]> {
        match self {
            Storage::Bin(range) => Some(&file[range.clone()]),
            Storage::Embedded(bytes) | Storage::File { bytes, .. } | Storage::Decompressed { bytes, .. } => {
                Some(bytes)
            }
            Storage::Absent => None,
        }
    }

    /// Whether it is, or was before it was decompressed, a file of its own.
    pub fn is_external(&self) -> bool {
        matches!(self, Storage::File { .. } | Storage::Decompressed { is_external: true, .. })
    }

    pub fn file(&self) -> Option<(&str, &Path)> {
        if let Storage::File { name, path, .. } = self { Some((name, path)) } else { None }
    }
}

/// A buffer: its declared length, never more than what is there.
#[derive(Clone, Debug)]
pub struct Buffer {
    pub storage: Storage,
    pub length: u64,
}

#[derive(Clone, Debug, Default)]
pub struct Buffers {
    /// The file, for the BIN chunk; empty for `.gltf`.
    pub file: Vec<u8>,
    pub list: Vec<Buffer>,
}

impl Buffers {
    /// The bytes of a buffer, cut to its declared length; `None` if only a compressed copy exists.
    pub fn bytes(&self, buffer: usize) -> Option<&[u8]> {
        let Buffer { storage, length } = &self.list[buffer];
        storage.bytes(&self.file).map(|bytes| &bytes[..*length as usize])
    }

    /// Sum of all lengths, which bounds what decoding may allocate.
    pub fn total(&self) -> u64 {
        self.list.iter().map(|buffer| buffer.length).sum()
    }
}

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
        let fields = Fields { json, object };
        let length = fields.required("byteLength")?;
        let storage = match (fields.string("uri")?, &bin) {
            (Some(uri), _) => files.storage(&uri, || fields.member("uri"))?,
            (None, Some(bin)) if number == 0 => Storage::Bin(bin.clone()),
            _ if length == 0 || MESHOPT.iter().any(|name| fields.extension(name).is_some()) => {
                Storage::Absent
            }
            _ if number == 0 && !file.is_empty() => {
                let found = "the file has no BIN chunk for the first buffer";
                return Err(refused(fields.place(), found, TRUNCATED));
            }
            _ => {
                let advice = "put the data next to the document and name it in `uri`";
                return Err(refused(fields.member("uri"), "the buffer has no data", advice));
            }
        };
        let available = storage.bytes(&file).map(|bytes| bytes.len() as u64);
        if let Some(available) = available.filter(|&available| length > available) {
            let found = format!("the buffer length is {length} bytes, but only {available} bytes are stored");
            return Err(ReadError::new(Problem::Truncated, fields.member("byteLength"), found, TRUNCATED));
        }
        list.push(Buffer { storage, length: if available.is_some() { length } else { 0 } });
    }
    Ok(Buffers { file, list })
}

fn refused(place: Place, found: impl Into<String>, advice: &str) -> ReadError {
    ReadError::new(Problem::Companion, place, found, advice)
}

struct Files<'a> {
    base: Option<&'a Path>,
    options: &'a ReadOptions,
    left: u64,
    known: FxHashMap<PathBuf, Arc<Vec<u8>>>,
}

impl Files<'_> {
    fn storage(&mut self, uri: &str, place: impl Fn() -> Place) -> Result<Storage, ReadError> {
        let name = match Uri::parse(uri) {
            Uri::Data => {
                let broken = |found| ReadError::new(Problem::Syntax, place(), found, "export the file again");
                return Ok(Storage::Embedded(Arc::new(decode_data(uri).map_err(broken)?)));
            }
            Uri::Elsewhere => {
                let uri: String = uri.chars().take(100).collect();
                let found = format!("the buffer {uri:?} is not a relative file name");
                let advice = "crease does not read from networks; download the file and use its name";
                return Err(refused(place(), found, advice));
            }
            Uri::File(name) => name,
        };
        let path = companion(self.base, self.options, &name).map_err(|why| {
            refused(place(), format!("the buffer {name:?} {why}"), why.advice(self.base.is_none()))
        })?;
        if let Some(bytes) = self.known.get(&path) {
            return Ok(Storage::File { name, path, bytes: bytes.clone() });
        }
        let failed = |problem, found| ReadError::new(problem, place(), found, "replace the file");
        let io = |error| failed(Problem::Io, format!("{name:?} cannot be read: {error}"));
        let size = std::fs::metadata(&path).map_err(io)?.len();
        self.left = self.left.checked_sub(size).ok_or_else(|| {
            failed(Problem::Limit, format!("{name:?} has {size} bytes, more than the limit for one input"))
        })?;
        let bytes = Arc::new(std::fs::read(&path).map_err(io)?);
        self.known.insert(path.clone(), bytes.clone());
        Ok(Storage::File { name, path, bytes })
    }
}

fn companion(base: Option<&Path>, options: &ReadOptions, name: &str) -> Result<PathBuf, Refusal> {
    let folder = base.or(options.root.as_deref()).ok_or(Refusal::Missing)?;
    find(folder, Path::new(""), name, options)
}

/// Warns of images that cannot be found, and returns the name and path of the others. Images are never opened.
pub fn check_images(
    json: &Json,
    base: Option<&Path>,
    options: &ReadOptions,
    notes: &mut Vec<Note>,
) -> Result<Vec<(String, PathBuf)>, ReadError> {
    let mut present = Vec::new();
    let mut absent: Vec<(Place, String)> = Vec::new();
    for (number, object) in Fields::root(json).list("images")?.into_iter().enumerate() {
        let Some(uri) = (Fields { json, object }).string("uri")? else { continue };
        let why = match Uri::parse(&uri) {
            Uri::Data => continue,
            Uri::Elsewhere => "is not a file in this folder and was not checked".to_owned(),
            Uri::File(name) => match companion(base, options, &name) {
                Ok(path) => {
                    present.push((name, path));
                    continue;
                }
                Err(why) => format!("{name:?} {}", why.in_note()),
            },
        };
        absent.push((Place::Json(format!("/images/{number}/uri")), why));
    }
    let text = absent.first().map(|(_, why)| format!("the image {why}")).unwrap_or_default();
    let count = absent.len() as u64;
    let places = absent.into_iter().map(|(place, _)| place);
    notes.extend(Note::for_all(Severity::Warning, count, places, text));
    Ok(present)
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Uri {
    Data,
    File(String),
    /// An address with a scheme: a network, an absolute file.
    Elsewhere,
}

impl Uri {
    pub fn parse(uri: &str) -> Uri {
        if uri.get(..5).is_some_and(|head| head.eq_ignore_ascii_case("data:")) {
            return Uri::Data;
        }
        let head = uri.split(['/', '?', '#', '\\']).next().unwrap_or_default();
        if head.contains(':') || uri.starts_with("//") {
            Uri::Elsewhere
        } else {
            Uri::File(String::from_utf8(percent_decoded(uri)).unwrap_or_else(|_| uri.to_owned()))
        }
    }
}

pub fn decode_data(uri: &str) -> Result<Vec<u8>, String> {
    let (head, data) = uri.split_once(',').ok_or("the data URI has no comma")?;
    if !head.to_ascii_lowercase().ends_with(";base64") {
        return Ok(percent_decoded(data));
    }
    let config = GeneralPurposeConfig::new().with_decode_padding_mode(DecodePaddingMode::Indifferent);
    let engine = GeneralPurpose::new(&base64::alphabet::STANDARD, config);
    engine.decode(data).map_err(|error| match error {
        DecodeError::InvalidByte(at, byte) => {
            let found = char::from(byte).escape_default();
            format!("character {} after the comma of the data URI, `{found}`, is not base64", at + 1)
        }
        _ => "the base64 of the data URI is damaged or cut off".to_owned(),
    })
}

pub fn encode_data(bytes: &[u8]) -> String {
    let mut uri = String::from("data:application/octet-stream;base64,");
    base64::engine::general_purpose::STANDARD.encode_string(bytes, &mut uri);
    uri
}

fn percent_decoded(text: &str) -> Vec<u8> {
    let hex = |byte: u8| (byte as char).to_digit(16).map(|digit| digit as u8);
    let mut out = Vec::with_capacity(text.len());
    let mut rest = text.as_bytes();
    while let [first, tail @ ..] = rest {
        rest = tail;
        if let (b'%', [high, low, after @ ..]) = (*first, tail)
            && let (Some(high), Some(low)) = (hex(*high), hex(*low))
        {
            out.push(high << 4 | low);
            rest = after;
        } else {
            out.push(*first);
        }
    }
    out
}

/// The address of data: of a file of this name, or a data URI.
pub fn address(name: Option<&str>, data: &[u8]) -> String {
    name.map_or_else(|| encode_data(data), percent_encoded)
}

pub fn percent_encoded(name: &str) -> String {
    let is_plain = |byte: u8| byte.is_ascii_alphanumeric() || b"-._~/".contains(&byte);
    let encoded =
        |byte: u8| if is_plain(byte) { char::from(byte).to_string() } else { format!("%{byte:02X}") };
    name.bytes().map(encoded).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn addresses_are_distinguished() {
        assert_eq!(Uri::parse("data:;base64,AA"), Uri::Data);
        assert_eq!(Uri::parse("a%20b/c.bin"), Uri::File("a b/c.bin".into()));
        assert_eq!(Uri::parse("%FF.bin"), Uri::File("%FF.bin".into()), "not UTF-8: left as it is");
        for elsewhere in ["http://x/y", "HTTPS://x", "file:///etc/passwd", "C:\\x.bin", "//host/x"] {
            assert_eq!(Uri::parse(elsewhere), Uri::Elsewhere, "{elsewhere}");
        }
    }

    #[test]
    fn data_round_trips() {
        let bytes: Vec<u8> = (0..=255).collect();
        assert_eq!(decode_data(&encode_data(&bytes)).unwrap(), bytes);
        assert_eq!(decode_data("data:,a%41%").unwrap(), b"aA%");
        assert_eq!(decode_data("data:x;base64,AAE").unwrap(), [0, 1]);
        assert!(decode_data("data:x;base64,A*").is_err());
        assert!(decode_data("data:x;base64").is_err());
        assert_eq!(Uri::parse(&percent_encoded("ü 1.bin")), Uri::File("ü 1.bin".into()));
    }
}
