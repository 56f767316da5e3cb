//! An edit of a document, and the files that it becomes: in the same spelling, or `.gltf` as `.glb` and the other way round.

use super::compact::compact;
use super::compress::compress_as;
use super::data_images::DataImage;
use super::group::Group;
use super::member::Member;
use super::rows::Tables;
use super::store::{Changed, NewBin, Remark, Store};
use crate::io::companion_files::{leads_to, output_name};
use crate::io::gltf::buffers::{Storage, address, encode_data, percent_encoded};
use crate::io::gltf::document::GltfDocument;
use crate::io::gltf::extensions::QUANTIZATION;
use crate::io::gltf::glb;
use crate::io::gltf::glb::Glb;
use crate::io::gltf::json::{Json, Value, quoted};
use crate::io::gltf::splice::{Splices, changed_object};
use crate::io::gltf::tangent_space::MaterialUses;
use crate::io::{
    Emit, Format, Loaded, Merge, Note, OutputContent, OutputFile, Part, PartEdit, Place, Severity,
    WriteError, WriteOptions, Written,
};
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::path::Path;

/// Writes a document with changes, one entry of `edits` a part, in the spelling `to`. Everything else stays byte for byte.
///
/// Normals replace the stored ones in place where nothing else uses those bytes, or are appended. Vertices are split where
/// corners need different normals, and then all their attributes are copied.
///
/// # Errors
/// [`WriteError::Unsupported`] for normals of faces, and where an extension refers to vertices or triangles by number and these change;
/// [`WriteError::TooLarge`] for a GLB beyond 4 GiB.
pub fn edit<'e>(
    document: &GltfDocument,
    loaded: &Loaded,
    edits: impl Into<Cow<'e, [PartEdit]>>,
    to: Format,
    options: &WriteOptions,
) -> Result<Written, WriteError> {
    apply(document, loaded, edits.into(), to, options)
}

fn apply(
    document: &GltfDocument,
    loaded: &Loaded,
    edits: Cow<'_, [PartEdit]>,
    to: Format,
    options: &WriteOptions,
) -> Result<Written, WriteError> {
    if options.emit == Emit::Face {
        let text = "an edited glTF has no face normals; use --emit corner or --emit vertex";
        return Err(WriteError::Unsupported(text.to_owned()));
    }
    let mut store = Store::new(document);
    let source = document.accessors();
    let materials = MaterialUses::all(&document.records);
    let mut tables = Tables::default();
    let mut groups: BTreeMap<(usize, bool), Vec<Member<'_>>> = BTreeMap::new();
    for member in Member::all(document, loaded, &edits) {
        groups.entry((member.block.source, member.has_normals())).or_default().push(member);
    }
    let mut added = 0;
    for ((number, new_normals), members) in &groups {
        let vertices = document.vertex_accessors(*number);
        let group = Group { vertices, members, source: &source, materials: &materials, options };
        if *new_normals {
            added += group.write(&mut store, &mut tables)?;
        } else {
            group.write_faces(&mut store)?;
        }
    }
    drop(groups);
    let drops = edits.iter().any(|edit| !edit.faces.dropped.is_empty());
    // Their normals take as much memory as a third of the file.
    drop(edits);
    let remarks = std::mem::take(&mut store.remarks).into_iter();
    let warnings = std::mem::take(&mut store.warnings).into_iter();
    if store.is_quantized {
        store.splices.require(QUANTIZATION);
    }
    let mut package = Package { document, options, written: Written::default() };
    if to != Format::Glb || document.glb.is_some() {
        package.settle_buffers(&mut store);
    }
    match (&document.glb, to) {
        (Some(glb), Format::Glb) => package.same_glb(glb, store)?,
        (Some(glb), _) => package.as_gltf(glb, store)?,
        (None, Format::Glb) => package.as_glb(store)?,
        (None, _) => package.same_gltf(store),
    }
    package.copy_images();
    let mut written = package.written;
    let merged = options.merge == Merge::Exact && added < 0;
    if (options.compact || merged) && to == Format::Glb {
        match compact(&written.bytes)? {
            Some(bytes) => written.bytes = bytes,
            None => written.notes.push(Note::remark(
                "bytes that nothing uses stay: an extension may refer to accessors or buffer views, or the data are elsewhere",
            )),
        }
    }
    let is_compressed = compress_as(options.compression, to, &mut written)?;
    if let Some(compression) = &document.compression {
        let note = compression.note(&written, &document.buffers, is_compressed);
        written.notes.push(note);
    }
    let vertices: usize = loaded.parts.iter().map(|part: &Part| part.mesh.vertex_count()).sum();
    written.vertices = vertices.saturating_add_signed(added as isize) as u64;
    written.count_change(vertices);
    let note = |(remark, count): (Remark, usize)| {
        let note = Note::counted(count, remark.1, remark.2)?;
        Some(if remark.is_expected() { Note { severity: Severity::Note, ..note } } else { note })
    };
    written.notes.extend(remarks.filter_map(note));
    let warning = |(text, places): (String, Vec<Place>)| {
        Note::for_all(Severity::Warning, places.len() as u64, places, text)
    };
    written.notes.extend(warnings.filter_map(warning));
    if (added != 0 || drops) && document.lists("extensionsUsed", "FB_geometry_metadata") {
        let text = "FB_geometry_metadata still has the vertex and face counts of the input";
        written.notes.push(Note::warning(Place::File, text));
    }
    Ok(written)
}

struct Package<'a> {
    document: &'a GltfDocument,
    options: &'a WriteOptions,
    written: Written,
}

impl Package<'_> {
    /// Lets the output find the buffers that are files: by the same name if that is inside the output's folder or leads to the file,
    /// by a new name otherwise. In a stream they are stored in the document.
    fn settle_buffers(&mut self, store: &mut Store<'_>) {
        let document = self.document;
        for (buffer, &object) in document.buffers.list.iter().zip(&document.records.buffers) {
            if let Storage::Decompressed { bytes, is_external } = &buffer.storage {
                let stem = self.options.stem.as_ref().filter(|_| *is_external);
                let name = stem.map(|stem| self.free_name(stem, ".bin"));
                store.splices.set(object, "uri", quoted(&address(name.as_deref(), bytes)));
                let content = || OutputContent::Bytes(bytes.to_vec());
                self.written.companions.extend(name.map(|name| OutputFile { name, content: content() }));
            }
            let Storage::File { name, path, bytes } = &buffer.storage else { continue };
            let Some(stem) = &self.options.stem else {
                store.splices.set(object, "uri", quoted(&encode_data(bytes)));
                continue;
            };
            let name = match output_name(Path::new(""), name) {
                Some(name) => name,
                None if leads_to(self.options.folder.as_deref(), name, path) => continue,
                None => {
                    let copy = OutputContent::CopyOf(path.clone());
                    let known = self.written.companions.iter().find(|other| other.content == copy);
                    let known = known.map(|other| other.name.clone());
                    let name = known.unwrap_or_else(|| {
                        // The file name only, so that it stays in the output's folder.
                        let bare = path.file_name().map(|name| name.to_string_lossy());
                        self.free_name(stem, &bare.unwrap_or("buffer.bin".into()))
                    });
                    store.splices.set(object, "uri", quoted(&percent_encoded(&name)));
                    name
                }
            };
            self.add_copy(name, path);
        }
    }

    fn add_copy(&mut self, name: String, path: &Path) {
        let companions = &mut self.written.companions;
        if !companions.iter().any(|file| file.name == name) {
            companions.push(OutputFile { name, content: OutputContent::CopyOf(path.to_owned()) });
        }
    }

    fn same_glb(&mut self, glb: &Glb, store: Store<'_>) -> Result<(), WriteError> {
        let document = self.document;
        if store.is_empty() {
            self.written.bytes = document.buffers.file.clone();
            return Ok(());
        }
        // A GLB keeps to one file even where it has no BIN chunk to append to.
        let changed = store.finish(None, |extra| Some(encode_data(extra)));
        let is_same = changed.json == document.records.json.text();
        let json = if is_same { &changed.json } else { glb::unpadded(&changed.json) };
        let pieces = changed.bin.as_ref().map(NewBin::pieces);
        let (mut bytes, bin) = glb.rewrite(&document.buffers.file, json, pieces)?;
        if let Some(changed) = &changed.bin {
            changed.patch(&mut bytes[bin..]);
        }
        self.written.bytes = bytes;
        Ok(())
    }

    fn same_gltf(&mut self, store: Store<'_>) {
        let document = self.document;
        // A document that is one file stays one.
        let external = document.buffers.list.iter().any(|buffer| buffer.storage.is_external());
        let stem = self.options.stem.as_ref().filter(|_| external);
        let name = stem.map(|stem| self.free_name(stem, "normals.bin"));
        let stale = stem.and_then(|stem| self.own_earlier(stem));
        let changed = store.finish(stale, |extra| Some(address(name.as_deref(), extra)));
        self.written.bytes = changed.json.into_bytes();
        if let (Some(name), Some(extra)) = (name, changed.extra) {
            let replaced = changed.replaced.and_then(|buffer| document.buffers.list[buffer].storage.file());
            if let Some((_, path)) = replaced {
                let copy = OutputContent::CopyOf(path.to_owned());
                self.written.companions.retain(|file| file.content != copy);
            }
            self.written.companions.insert(0, OutputFile { name, content: OutputContent::Bytes(extra) });
        }
    }

    /// The last buffer whose file an earlier edit of this document wrote, which this one may replace. The new file still has
    /// another name: until the document is stored, the old one needs its file.
    fn own_earlier(&self, stem: &str) -> Option<usize> {
        let is_own = |name: &str| {
            let number = name.strip_prefix(stem).and_then(|name| name.strip_prefix(".normals"));
            let number = number.and_then(|name| name.strip_suffix(".bin"));
            number.is_some_and(|number| number.bytes().all(|byte| byte.is_ascii_digit()))
        };
        let mut buffers = self.document.buffers.list.iter().map(|buffer| buffer.storage.file());
        buffers.rposition(|file| file.is_some_and(|(name, _)| is_own(name)))
    }

    /// A name for a file next to the output, `<stem>.<name>` or with a number in it, that no other such file has.
    fn free_name(&self, stem: &str, name: &str) -> String {
        let is_taken = |name: &String| {
            let mut of_input = self.document.buffers.list.iter().filter_map(|buffer| buffer.storage.file());
            of_input.any(|(other, _)| output_name(Path::new(""), other).as_ref() == Some(name))
                || self.written.companions.iter().any(|file| file.name == *name)
                || self.document.compression.as_ref().is_some_and(|compression| compression.has_file(name))
        };
        let (front, extension) = name.rsplit_once('.').unwrap_or((name, "bin"));
        let front = if front.is_empty() { stem.to_owned() } else { format!("{stem}.{front}") };
        let numbered = (2_u64..).map(|number| format!("{front}{number}.{extension}"));
        let mut names = std::iter::once(format!("{front}.{extension}")).chain(numbered);
        names.find(|name| !is_taken(name)).unwrap_or_default()
    }

    /// `.glb` from `.gltf`: all buffers become one, and views move with them. Images in data URIs move into it.
    fn as_glb(&mut self, store: Store<'_>) -> Result<(), WriteError> {
        let document = self.document;
        let Changed { json, extra, .. } = store.finish(None, |_| None);
        let json = Json::of_edited(json)?;
        let objects: Vec<Value> = json.items(json.root(), "buffers").collect();
        let old = (0..document.buffers.list.len()).map(|buffer| document.buffers.bytes(buffer));
        let mut splices = Splices::new(&json);
        let mut pieces: Vec<&[u8]> = Vec::new();
        // The buffer and the offset where each old buffer begins.
        let mut homes: Vec<(usize, u64)> = Vec::new();
        let (mut length, mut absent) = (0_usize, Vec::new());
        for (&object, content) in objects.iter().zip(old.chain([extra.as_deref()])) {
            let Some(bytes) = content else {
                absent.push(json.raw(object).to_owned());
                homes.push((absent.len(), 0));
                continue;
            };
            homes.push((0, length as u64));
            pieces.extend([bytes, &[0; 4][..glb::padded(bytes.len()) - bytes.len()]]);
            length += glb::padded(bytes.len());
        }
        let images = DataImage::all(&json);
        let views = json.items(json.root(), "bufferViews").count();
        for (number, image) in images.iter().enumerate() {
            image.move_to(&json, length, views + number, &mut splices);
            pieces.extend([&image.bytes, &[0; 4][..glb::padded(image.bytes.len()) - image.bytes.len()]]);
            length += glb::padded(image.bytes.len());
        }
        if objects.is_empty() && length > 0 {
            splices.push("buffers", format!("{{\"byteLength\":{length}}}"));
        }
        for view in json.items(json.root(), "bufferViews") {
            move_reference(&json, view, &homes, &mut splices);
            let extensions = json.member(view, "extensions");
            for (_, compressed) in extensions.into_iter().flat_map(|extensions| json.members(extensions)) {
                move_reference(&json, compressed, &homes, &mut splices);
            }
        }
        if let Some(&first) = objects.first() {
            // The first buffer's object is kept for all, so that its name and extras survive.
            let changes = vec![("uri".to_owned(), None), ("byteLength".to_owned(), Some(length.to_string()))];
            let merged = std::iter::once(changed_object(&json, first, &changes)).chain(absent);
            splices.set(json.root(), "buffers", format!("[{}]", merged.collect::<Vec<_>>().join(",")));
            let named = |object: &Value| {
                json.members(*object).any(|(key, _)| !matches!(json.raw(key), "\"uri\"" | "\"byteLength\""))
            };
            if objects[1..].iter().any(named) {
                let text = "buffers were merged; members of all but the first were omitted";
                self.written.notes.push(Note::remark(text));
            }
        }
        self.written.bytes = glb::glb(glb::unpadded(&splices.apply()), pieces)?;
        Ok(())
    }

    /// `.gltf` from `.glb`: the BIN chunk becomes a file, or part of the text.
    fn as_gltf(&mut self, glb: &Glb, store: Store<'_>) -> Result<(), WriteError> {
        let changed = store.finish(None, |extra| Some(encode_data(extra)));
        let json = Json::of_edited(changed.json)?;
        let mut splices = Splices::new(&json);
        let first = json.items(json.root(), "buffers").next();
        if let Some(first) = first.filter(|&first| json.member(first, "uri").is_none()) {
            let bin = match (&changed.bin, glb.bin()) {
                (Some(bin), _) => Cow::Owned(bin.to_vec()),
                (None, Some(range)) => Cow::Borrowed(&self.document.buffers.file[range]),
                (None, None) => Cow::Borrowed(&[][..]),
            };
            let length = json.integer_member(first, "byteLength").unwrap_or(0);
            let bin = &bin[..bin.len().min(length as usize)];
            let name = self.options.stem.as_ref().map(|stem| self.free_name(stem, ".bin"));
            splices.set(first, "uri", quoted(&address(name.as_deref(), bin)));
            let content = || OutputContent::Bytes(bin.to_vec());
            self.written.companions.extend(name.map(|name| OutputFile { name, content: content() }));
        }
        let text = "that only a GLB can store omitted";
        self.written.notes.extend(Note::counted(glb.other_chunks(), ["chunk", "chunks"], text));
        self.written.bytes = glb::unpadded(&splices.apply()).as_bytes().to_vec();
        Ok(())
    }

    fn copy_images(&mut self) {
        let mut left: Vec<&str> = Vec::new();
        for (name, path) in &self.document.images {
            match output_name(Path::new(""), name).filter(|_| self.options.stem.is_some()) {
                Some(name) => self.add_copy(name, path),
                None if leads_to(self.options.folder.as_deref(), name, path) => {}
                None => left.push(name),
            }
        }
        if let Some(first) = left.first() {
            let text = format!("not copied, although the output refers to it (first: {first:?})");
            self.written.notes.extend(Note::counted(left.len(), ["image was", "images were"], text));
        }
    }
}

/// Points what has `buffer` and `byteOffset` at the merged buffer.
fn move_reference(json: &Json, object: Value, homes: &[(usize, u64)], splices: &mut Splices<'_>) {
    let Some(buffer) = json.integer_member(object, "buffer") else { return };
    let Some(&(home, offset)) = usize::try_from(buffer).ok().and_then(|buffer| homes.get(buffer)) else {
        return;
    };
    if home as u64 != buffer {
        splices.set(object, "buffer", home);
    }
    if offset > 0 {
        let old = json.integer_member(object, "byteOffset").unwrap_or(0);
        splices.set(object, "byteOffset", old.saturating_add(offset));
    }
}
