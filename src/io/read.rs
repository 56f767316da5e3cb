//! Reading a file of any format: opening it, detecting its format, calling its reader.

use super::mesh_checks::{check_size, face_notes};
use super::text::without_byte_order_mark;
use super::{Format, Limits, Loaded, Place, Problem, ReadError, ReadOptions, gltf, obj, ply, stl, threemf};
#[cfg(unix)]
use crate::num::parallel;
use std::fs;
use std::io::ErrorKind;
use std::path::Path;

/// The format of a file: from its content if that is decisive, else from its name, else from its first words.
///
/// Decisive are the magic words of GLB and PLY, the brace that a glTF begins with, the length or facets of an STL, and the model of a
/// 3MF.
pub fn detect(bytes: &[u8], path: Option<&Path>) -> Option<Format> {
    decisive(bytes).or_else(|| Format::from_path(path?)).or_else(|| likely(bytes))
}

fn decisive(bytes: &[u8]) -> Option<Format> {
    if bytes.starts_with(b"glTF") {
        return Some(Format::Glb);
    }
    if let [b'p', b'l', b'y', b' ' | b'\t' | b'\r' | b'\n', ..] = bytes {
        return Some(Format::Ply);
    }
    if stl::is_certain(bytes) {
        return Some(Format::Stl);
    }
    if threemf::is_certain(bytes) {
        return Some(Format::ThreeMf);
    }
    (without_byte_order_mark(bytes).trim_ascii_start().first() == Some(&b'{')).then_some(Format::Gltf)
}

/// Text whose first statement is one of OBJ.
fn likely(bytes: &[u8]) -> Option<Format> {
    const KEYWORDS: [&[u8]; 12] =
        [b"v", b"vt", b"vn", b"vp", b"f", b"l", b"p", b"o", b"g", b"s", b"mtllib", b"usemtl"];
    let lines = without_byte_order_mark(bytes).split(|byte| matches!(byte, b'\n' | b'\r'));
    let statement = lines.map(<[u8]>::trim_ascii).find(|line| !line.is_empty() && line[0] != b'#')?;
    let keyword = statement.split(u8::is_ascii_whitespace).next()?;
    KEYWORDS.contains(&keyword).then_some(Format::Obj)
}

/// Reads a file. Without a format, content and name determine it ([`detect`]).
///
/// # Errors
/// If the file is missing, not a regular file, not readable, too large or of no known format, or the error of its
/// format's reader.
pub fn read(path: &Path, format: Option<Format>, options: &ReadOptions) -> Result<Loaded, ReadError> {
    let bytes = read_whole(path, &options.limits)?;
    options.log.add(path);
    let format = format.or_else(|| detect(&bytes, Some(path)));
    if format.is_none() && path.extension().is_some_and(|name| name.eq_ignore_ascii_case("toml")) {
        let advice = "`crease render` draws scene files";
        return Err(ReadError { advice: advice.to_owned(), ..unknown(&bytes) });
    }
    read_bytes(bytes, format, Some(path.parent().unwrap_or(path)), options)
}

pub(crate) fn read_whole(path: &Path, limits: &Limits) -> Result<Vec<u8>, ReadError> {
    let metadata = fs::metadata(path).map_err(|error| io_error(&error))?;
    if !metadata.is_file() {
        let (found, advice) = match metadata.is_dir() {
            true => ("this is a folder", "name a file in it"),
            // Opening a pipe may wait for ever.
            false => ("this is not a regular file", "read a stream from standard input with -"),
        };
        return Err(ReadError::new(Problem::Io, Place::File, found, advice));
    }
    check_size(metadata.len(), limits)?;
    read_length(path, metadata.len()).map_err(|error| io_error(&error))
}

#[cfg(not(unix))]
fn read_length(path: &Path, _length: u64) -> std::io::Result<Vec<u8>> {
    fs::read(path)
}

/// Reads a file of about this many bytes; a large one on all threads, since most of the time goes into giving it memory.
#[cfg(unix)]
fn read_length(path: &Path, length: u64) -> std::io::Result<Vec<u8>> {
    use std::os::unix::fs::FileExt;
    const PIECE: usize = 1 << 20;
    let Some(length) = usize::try_from(length).ok().filter(|&length| length > 2 * PIECE) else {
        return fs::read(path);
    };
    let file = fs::File::open(path)?;
    let mut bytes = vec![0; length];
    let read = |number: usize, piece: &mut [u8]| file.read_exact_at(piece, (number * PIECE) as u64);
    match parallel::map_chunks(&mut bytes, PIECE, read).into_iter().collect::<std::io::Result<()>>() {
        Err(error) if error.kind() == ErrorKind::UnexpectedEof => return fs::read(path),
        result => result?,
    }
    let has_grown = file.read_at(&mut [0], length as u64)? > 0;
    if has_grown { fs::read(path) } else { Ok(bytes) }
}

fn io_error(error: &std::io::Error) -> ReadError {
    let (found, advice) = match error.kind() {
        ErrorKind::NotFound => ("there is no such file".to_owned(), "check the name"),
        ErrorKind::PermissionDenied => ("no permission to read it".to_owned(), "check its permissions"),
        ErrorKind::OutOfMemory => ("the file does not fit into memory".to_owned(), "split it"),
        _ => (error.to_string(), "check the path"),
    };
    ReadError::new(Problem::Io, Place::File, found, advice)
}

/// Reads a file that is in memory. Without a format, its content determines it. `base` is the folder that companion files
/// are searched for in; `None` for a stream, which has none: then it is the root of the options.
///
/// # Errors
/// If the content has no known format, or the error of the format's reader.
pub fn read_bytes(
    bytes: Vec<u8>,
    format: Option<Format>,
    base: Option<&Path>,
    options: &ReadOptions,
) -> Result<Loaded, ReadError> {
    let Some(format) = format.or_else(|| detect(&bytes, None)) else {
        return Err(unknown(&bytes));
    };
    let is_package = format == Format::ThreeMf && bytes.starts_with(b"PK");
    let is_other = bytes.is_empty() || !is_package && other_format(&bytes).is_some();
    let what_it_is = is_other.then(|| unknown(&bytes));
    let may_be_text = bytes.starts_with(b"<");
    let loaded = match format {
        Format::Obj => obj::read(bytes, base, options),
        Format::Gltf | Format::Glb => gltf::read(bytes, base, options),
        Format::Stl => stl::read(bytes, base, options),
        Format::Ply => ply::read(bytes, base, options),
        Format::ThreeMf => threemf::read(bytes, base, options),
    };
    let mut loaded = loaded.map_err(|error| match what_it_is {
        Some(other) if !may_be_text || is_about_the_start(&error) => other,
        _ => error,
    })?;
    loaded.notes.extend(face_notes(&loaded.parts));
    Ok(loaded)
}

/// Whether an error may come from another format than the reader's, if that has no binary signature. Behind the first line,
/// the format is right. A binary STL has no signature: its reader takes the first bytes for a header, and misses data.
fn is_about_the_start(error: &ReadError) -> bool {
    match error.problem {
        Problem::Syntax => matches!(error.place, Place::File | Place::Line(1) | Place::Byte(0..4)),
        Problem::Truncated => matches!(error.place, Place::Byte(_)),
        _ => false,
    }
}

/// The name of a format that is no mesh that crease reads, by its first bytes, and what to do.
fn other_format(bytes: &[u8]) -> Option<(&'static str, &'static str)> {
    const MESH: &str = "name a mesh file";
    const UNPACK: &str = "unpack it first";
    const EXPORT: &str = "export it as glTF or OBJ";
    const OTHERS: [(&[u8], &str, &str); 9] = [
        (b"\x89PNG", "a PNG image", MESH),
        (b"\xff\xd8\xff", "a JPEG image", MESH),
        (b"GIF8", "a GIF image", MESH),
        (b"%PDF", "a PDF document", MESH),
        (b"PK\x03\x04", "a ZIP archive", UNPACK),
        (b"\x1f\x8b", "a gzip archive", UNPACK),
        (b"Kaydara FBX", "an FBX file", EXPORT),
        (b"BLENDER", "a Blender file", EXPORT),
        (b"<", "XML or HTML", MESH),
    ];
    let known = OTHERS.iter().find(|(start, ..)| bytes.starts_with(start));
    known.map(|&(_, name, advice)| (name, advice))
}

/// The error for a file of an unknown format: what it looks like. Where that is clear, another format is not suggested.
fn unknown(bytes: &[u8]) -> ReadError {
    const FOUND: &str = "not a mesh file that crease reads (OBJ, PLY, STL, glTF, GLB, 3MF)";
    let (found, advice) = match other_format(bytes) {
        _ if bytes.is_empty() => ("the file is empty".to_owned(), "export it again"),
        Some((name, advice)) => (format!("{FOUND}; it starts like {name}"), advice),
        None => (FOUND.to_owned(), "choose its format with --format"),
    };
    ReadError::new(Problem::Syntax, Place::File, found, advice)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn content_reports_before_the_name() {
        let mut binary = b"solid but binary".to_vec();
        binary.resize(84, 0);
        let stl = b"SOLID x\nfacet normal 0 0 1\n";
        for (bytes, name, expected) in [
            (&b"glTF\x02\0\0\0"[..], "a.obj", Some(Format::Glb)),
            (b"ply\r\nformat", "a.obj", Some(Format::Ply)),
            (b"\xef\xbb\xbf \n{\"asset\"", "a.glb", Some(Format::Gltf)),
            (stl, "a.obj", Some(Format::Stl)),
            (&binary, "a.bin", Some(Format::Stl)),
            (b"solid", "a.stl", Some(Format::Stl)),
            (b"# hello\n\nv 1 2 3", "a.txt", Some(Format::Obj)),
            (b"# hello\n\nv 1 2 3", "a.STL", Some(Format::Stl)),
            (b"plywood", "a", None),
            (b"vertex", "a", None),
            (b"", "a", None),
        ] {
            assert_eq!(detect(bytes, Some(Path::new(name))), expected, "{name}");
        }
    }

    #[test]
    fn what_cannot_be_opened_is_an_error() {
        let folder = tempfile::tempdir().unwrap();
        let error = |path: &Path| read(path, None, &ReadOptions::default()).unwrap_err();
        assert!(error(folder.path()).found.contains("folder"));
        assert!(error(&folder.path().join("none")).found.contains("no such file"));
        assert!(error(Path::new("/dev/null")).found.contains("not a regular file"));
        let path = folder.path().join("a.xyz");
        fs::write(&path, "???").unwrap();
        assert!(error(&path).found.contains("not a mesh file") && error(&path).advice.contains("--format"));
        fs::write(&path, b"\x89PNG").unwrap();
        assert!(error(&path).found.ends_with("a PNG image") && error(&path).advice == "name a mesh file");
        let scene = folder.path().join("a.toml");
        fs::write(&scene, "[camera]\n").unwrap();
        assert!(error(&scene).advice.contains("crease render"));
        fs::write(&path, "v 0 0 0\n").unwrap();
        assert_eq!(read(&path, None, &ReadOptions::default()).unwrap().format, Format::Obj);
        let mut options = ReadOptions::default();
        options.limits.bytes = 4;
        assert_eq!(read(&path, None, &options).unwrap_err().problem, Problem::Limit);
        for reader in [obj::read, gltf::read, stl::read, ply::read] {
            assert_eq!(reader(vec![b' '; 5], None, &options).unwrap_err().problem, Problem::Limit);
        }
    }

    /// A wrong suffix is the fault that is reported, unless the reader has come beyond the first line.
    #[test]
    fn files_of_other_formats_are_named_whatever_their_suffix() {
        let page = format!("<!DOCTYPE html>{}", " ".repeat(200)).into_bytes();
        let gzip = [&b"\x1f\x8b\x08"[..], &[b'0'; 200]].concat();
        let error = |bytes: &[u8], format| {
            read_bytes(bytes.to_vec(), Some(format), None, &ReadOptions::default()).unwrap_err().to_string()
        };
        for format in Format::ALL {
            assert!(error(&page, format).contains("starts like XML or HTML"), "{format}");
            assert!(error(&gzip, format).contains("starts like a gzip archive"), "{format}");
        }
        assert!(error(b"", Format::Gltf).contains("the file is empty"));
        let obj = b"<!-- a line of no meaning -->\nv 0 0 0\nv 1 0 0\nv 0 1 zz\n";
        assert!(error(obj, Format::Obj).starts_with("line 4: "), "{}", error(obj, Format::Obj));
    }
}
