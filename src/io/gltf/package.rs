//! A changed document as files: the same spelling again, or `.gltf` as `.glb` and the other way round.

use super::GltfDocument;
use super::buffers::Storage;
use super::container;
use super::edit::store::{Changed, Store};
use super::json::{Json, Value, quoted};
use super::splice::{Splices, changed_object};
use super::uri;
use crate::io::companion::output_name;
use crate::io::{Format, Note, OutputContent, OutputFile, Place, WriteError, WriteOptions, Written};
use std::path::{Path, PathBuf};

/// Makes the output of a changed document.
pub(super) fn package(
    document: &GltfDocument,
    store: Store<'_>,
    to: Format,
    options: &WriteOptions,
) -> Result<Written, WriteError> {
    let mut written = Written::default();
    match (&document.glb, to) {
        (Some(_), Format::Glb) => same_glb(document, store, &mut written)?,
        (Some(_), _) => as_gltf(document, store, options, &mut written)?,
        (None, Format::Glb) => as_glb(document, store, &mut written)?,
        (None, _) => same_gltf(document, store, options, &mut written),
    }
    let buffers_stay = to == Format::Gltf && document.glb.is_none();
    copy_companions(document, buffers_stay, options, &mut written);
    Ok(written)
}

fn same_glb(document: &GltfDocument, store: Store<'_>, written: &mut Written) -> Result<(), WriteError> {
    let Some(glb) = &document.glb else { return Ok(()) };
    if store.is_empty() {
        written.bytes = document.buffers.file.clone();
        return Ok(());
    }
    // A GLB keeps to one file even where it has no BIN chunk to append to.
    let changed = store.finish(|extra| Some(uri::encode_data(extra)));
    let json =
        if changed.json == document.records.json.text() { &changed.json } else { unpadded(&changed.json) };
    written.bytes = glb.rewrite(&document.buffers.file, json, changed.bin.as_deref())?;
    Ok(())
}

fn same_gltf(document: &GltfDocument, mut store: Store<'_>, options: &WriteOptions, written: &mut Written) {
    if options.stem.is_none() {
        for (buffer, &object) in document.buffers.list.iter().zip(&document.records.buffers) {
            if let Storage::File { bytes, .. } = &buffer.storage {
                store.splices.set(object, "uri", quoted(&uri::encode_data(bytes)));
            }
        }
    }
    // A document that is one file stays one.
    let external = document.buffers.list.iter().any(|buffer| matches!(buffer.storage, Storage::File { .. }));
    let name = options.stem.as_ref().filter(|_| external).map(|stem| free_name(document, stem));
    let changed = store.finish(|extra| {
        Some(name.as_ref().map_or_else(|| uri::encode_data(extra), |name| uri::percent_encoded(name)))
    });
    written.bytes = changed.json.into_bytes();
    if let (Some(name), Some(extra)) = (name, changed.extra) {
        written.companions.push(OutputFile { name, content: OutputContent::Bytes(extra) });
    }
}

/// A name for a new buffer file that no file of the document has.
fn free_name(document: &GltfDocument, stem: &str) -> String {
    let taken = |name: &str| {
        document.buffers.list.iter().any(|buffer| match &buffer.storage {
            Storage::File { name: other, .. } => output_name(Path::new(""), other).as_deref() == Some(name),
            _ => false,
        })
    };
    let names =
        std::iter::once(format!("{stem}.normals.bin")).chain((2..).map(|n| format!("{stem}.normals{n}.bin")));
    names.into_iter().find(|name| !taken(name)).unwrap_or_default()
}

/// `.glb` from `.gltf`: all buffers become one, and views move with them.
fn as_glb(document: &GltfDocument, store: Store<'_>, written: &mut Written) -> Result<(), WriteError> {
    let Changed { json, extra, .. } = store.finish(|_| None);
    let json = reparsed(json)?;
    let lists = |name: &str| -> Vec<Value> {
        json.member(json.root(), name).into_iter().flat_map(|list| json.elements(list)).collect()
    };
    let objects = lists("buffers");
    let contents: Vec<Option<&[u8]>> = (0..document.buffers.list.len())
        .map(|buffer| document.buffers.bytes(buffer))
        .chain([extra.as_deref()])
        .collect();
    let mut splices = Splices::new(&json);
    let mut pieces: Vec<&[u8]> = Vec::new();
    let mut homes: Vec<(usize, u64)> = Vec::new();
    let (mut length, mut absent) = (0_usize, Vec::new());
    for (&object, content) in objects.iter().zip(&contents) {
        match content {
            Some(bytes) => {
                homes.push((0, length as u64));
                pieces.extend([bytes, &[0; 4][..container::padded(bytes.len()) - bytes.len()]]);
                length += container::padded(bytes.len());
            }
            None => {
                absent.push(json.raw(object).to_owned());
                homes.push((absent.len(), 0));
            }
        }
    }
    for view in lists("bufferViews") {
        move_reference(&json, view, &homes, &mut splices);
        let extensions = json.member(view, "extensions");
        for (_, compressed) in extensions.into_iter().flat_map(|extensions| json.members(extensions)) {
            move_reference(&json, compressed, &homes, &mut splices);
        }
    }
    if let (Some(list), Some(&first)) = (json.member(json.root(), "buffers"), objects.first()) {
        // The first buffer's object stands for all, so that its name and extras survive.
        let changes = vec![("uri".to_owned(), None), ("byteLength".to_owned(), Some(length.to_string()))];
        let merged = std::iter::once(changed_object(&json, first, &changes)).chain(absent);
        splices.replace(list, format!("[{}]", merged.collect::<Vec<_>>().join(",")));
        let named = |object: &Value| {
            json.members(*object).any(|(key, _)| !matches!(json.raw(key), "\"uri\"" | "\"byteLength\""))
        };
        if objects[1..].iter().any(named) {
            written.notes.push(Note::remark(
                "buffers were merged into one; what the others said of themselves is lost",
            ));
        }
    }
    written.bytes = container::glb(unpadded(&splices.apply()), &pieces)?;
    Ok(())
}

/// Points what has `buffer` and `byteOffset` at the merged buffer.
fn move_reference(json: &Json, object: Value, homes: &[(usize, u64)], splices: &mut Splices<'_>) {
    let integer = |name: &str| json.integer(json.member(object, name)?);
    let Some(buffer) = integer("buffer") else { return };
    let Some(&(home, offset)) = usize::try_from(buffer).ok().and_then(|buffer| homes.get(buffer)) else {
        return;
    };
    if home as u64 != buffer {
        splices.set(object, "buffer", home);
    }
    if offset > 0 {
        splices.set(object, "byteOffset", integer("byteOffset").unwrap_or(0).saturating_add(offset));
    }
}

/// `.gltf` from `.glb`: the BIN chunk becomes a file, or part of the text.
fn as_gltf(
    document: &GltfDocument,
    store: Store<'_>,
    options: &WriteOptions,
    written: &mut Written,
) -> Result<(), WriteError> {
    let Some(glb) = &document.glb else { return Ok(()) };
    let changed = store.finish(|extra| Some(uri::encode_data(extra)));
    let json = reparsed(changed.json)?;
    let mut splices = Splices::new(&json);
    let buffers = json.member(json.root(), "buffers");
    let first = buffers.and_then(|buffers| json.elements(buffers).next());
    if let Some(first) = first.filter(|&first| json.member(first, "uri").is_none()) {
        let bin = match (&changed.bin, glb.bin()) {
            (Some(bin), _) => bin.as_slice(),
            (None, Some(range)) => &document.buffers.file[range],
            (None, None) => &[],
        };
        let length = json.member(first, "byteLength").and_then(|length| json.integer(length)).unwrap_or(0);
        let bin = &bin[..bin.len().min(length as usize)];
        match &options.stem {
            Some(stem) => {
                let name = format!("{stem}.bin");
                splices.set(first, "uri", quoted(&uri::percent_encoded(&name)));
                let content = OutputContent::Bytes(bin.to_vec());
                written.companions.push(OutputFile { name, content });
            }
            None => splices.set(first, "uri", quoted(&uri::encode_data(bin))),
        }
    }
    if glb.other_chunks() > 0 {
        let text = format!("{} chunks that only a GLB can hold are left out", glb.other_chunks());
        written.notes.push(Note::warning(Place::File, text));
    }
    written.bytes = unpadded(&splices.apply()).as_bytes().to_vec();
    Ok(())
}

/// Lists the files that the output refers to as the input does.
fn copy_companions(
    document: &GltfDocument,
    buffers_stay: bool,
    options: &WriteOptions,
    written: &mut Written,
) {
    let buffers = document.buffers.list.iter().filter_map(|buffer| match &buffer.storage {
        Storage::File { name, path, .. } if buffers_stay && options.stem.is_some() => Some((name, path)),
        // A GLB may name files too.
        Storage::File { name, path, .. } if document.glb.is_some() => Some((name, path)),
        _ => None,
    });
    let images = document.images.iter().map(|(name, path)| (name, path));
    let files: Vec<(&String, &PathBuf)> = buffers.chain(images).collect();
    let mut left: Vec<&str> = Vec::new();
    for (name, path) in files {
        match output_name(Path::new(""), name).filter(|_| options.stem.is_some()) {
            Some(name) if written.companions.iter().any(|file| file.name == name) => {}
            Some(name) => {
                written.companions.push(OutputFile { name, content: OutputContent::CopyOf(path.clone()) })
            }
            None => left.push(name),
        }
    }
    if let Some(first) = left.first() {
        let text =
            format!("{} files that the output refers to are not copied (the first is {first:?})", left.len());
        written.notes.push(Note::warning(Place::File, text));
    }
}

fn reparsed(json: String) -> Result<Json, WriteError> {
    // Splicing keeps JSON JSON; its depth was bounded when it was read.
    Json::parse(json.into_bytes(), 0, usize::MAX).map_err(|error| WriteError::TooLarge(error.to_string()))
}

/// Without the blanks that filled up a GLB chunk.
fn unpadded(json: &str) -> &str {
    json.trim_end_matches(' ')
}
