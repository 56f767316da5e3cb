//! What the fuzz targets share: a file is read, its normals are computed, it is written to every format, and each output is read
//! back and compared with what was written.

use crease::io::{
    self, Emit, Format, Limits, Loaded, MaterialFallback, Merge, MeshCompression, NonFinite, NormalFormat,
    OutputContent, PartEdit, ReadOptions, TangentPolicy, WriteOptions, Written,
};
use crease::mesh::{Mesh, Orient, Weld, triangulate};
use crease::normals::{
    Crease, CreaseRule, Groups, HardEdges, LENGTH_TOLERANCE, NormalRecipe, Precision, Scope, Slivers, Weight,
    When,
};
use crease::num::Degrees;
use crease::pipeline::{self, Degenerate, Task};
use glam::DVec3;
use std::path::{Component, Path, PathBuf};

/// Most corners of faces, counted once for each node, of a mesh that is computed and written: more only take longer.
pub const MOST_CORNERS: usize = 20_000;

/// Starts rayon with the current thread only: others would take time without finding more, and blur the coverage of an input.
pub fn start() {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).use_current_thread();
    pool.build_global().expect("the first thread pool");
}

/// Choices that depend on the input alone, so that each input always does the same.
pub struct Choices(u64);

impl Choices {
    /// FNV-1a of the input.
    pub fn of(bytes: &[u8]) -> Self {
        let hash = |hash: u64, &byte: &u8| (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3);
        Self(bytes.iter().fold(0xcbf2_9ce4_8422_2325, hash))
    }

    /// One of these.
    pub fn one<T: Copy>(&mut self, of: &[T]) -> T {
        // SplitMix64 (Steele, Lea, Flood 2014).
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        of[((mixed ^ (mixed >> 31)) % of.len() as u64) as usize]
    }

    fn yes(&mut self) -> bool {
        self.one(&[false, true])
    }

    /// A recipe for normals.
    pub fn recipe(&mut self) -> NormalRecipe {
        let angles = [0.0, 1e-3, 20.0, 40.0, 90.0, 179.9, 180.0];
        NormalRecipe {
            weight: self.one(&Weight::ALL),
            crease: if self.yes() { Crease::Default } else { Crease::Angle(Degrees(self.one(&angles))) },
            rule: self.one(&[CreaseRule::Fan, CreaseRule::Fan, CreaseRule::Cone]),
            groups: self.one(&[Groups::Honour, Groups::Ignore]),
            hard_edges: HardEdges { uv: self.yes(), material: self.yes(), authored: self.yes() },
            weld: self.one(&[Weld::Exact, Weld::Off, Weld::Relative(1e-3)]),
            slivers: self.one(&[Slivers::Exclude, Slivers::Keep]),
            precision: self.one(&[Precision::Faithful, Precision::Fast]),
            scope: Scope::Corner,
        }
    }

    fn task(&mut self) -> Task {
        let mut recipe = self.recipe();
        let emit = self.one(&[Emit::Corner, Emit::Corner, Emit::Corner, Emit::Vertex, Emit::Face]);
        if emit == Emit::Vertex {
            recipe.scope = Scope::Vertex;
        }
        Task {
            recipe,
            emit,
            when: self.one(&[When::Always, When::Missing, When::Broken]),
            orient: self.one(&[Orient::Keep, Orient::Keep, Orient::Consistent, Orient::Outward]),
            flip: self.one(&[false, false, false, true]),
            degenerate: self.one(&[Degenerate::Keep, Degenerate::Drop]),
            edge_counts: self.yes(),
            ..Task::default()
        }
    }

    fn write_options(&mut self, emit: Emit, format: Format, folder: Option<&Path>) -> WriteOptions {
        let tangents =
            [TangentPolicy::Auto, TangentPolicy::Drop, TangentPolicy::Keep, TangentPolicy::Regenerate];
        let compression = self.one(&[MeshCompression::None, MeshCompression::None, MeshCompression::Meshopt]);
        let normal_formats = [NormalFormat::Same, NormalFormat::F32, NormalFormat::I16, NormalFormat::I8];
        WriteOptions {
            emit,
            tangents: self.one(&tangents),
            normal_format: self.one(&normal_formats),
            merge: self.one(&[Merge::FacetWise, Merge::Off, Merge::Exact]),
            material: self.one(&[MaterialFallback::Plastic, MaterialFallback::Omit]),
            compression: if format == Format::Glb { compression } else { MeshCompression::None },
            compact: self.yes(),
            stem: folder.map(|_| "out".to_owned()),
            folder: folder.map(Path::to_owned),
            ..WriteOptions::default()
        }
    }
}

/// How inputs are read: bounds that suit small files, and an extension that is allowed although it is unknown.
pub fn read_options(choices: &mut Choices) -> ReadOptions {
    ReadOptions {
        non_finite: choices.one(&[NonFinite::Refuse, NonFinite::Refuse, NonFinite::DropFaces]),
        allowed_extensions: vec!["EXT_allowed".to_owned()],
        limits: Limits { bytes: 1 << 20, implied_elements: 1 << 10, ..Limits::default() },
        ..ReadOptions::default()
    }
}

/// A folder of this process for companion files, which is emptied each time.
pub fn fresh_folder(name: &str) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("crease-fuzz-{}", std::process::id())).join(name);
    if folder.exists() {
        std::fs::remove_dir_all(&folder).expect("a folder of this process");
    }
    std::fs::create_dir_all(&folder).expect("a folder for companion files");
    folder
}

/// Reads a file and does everything with it. `folder` has its companion files.
pub fn check_file(bytes: &[u8], format: Format, folder: Option<&Path>) {
    let mut choices = Choices::of(bytes);
    let options = read_options(&mut choices);
    match io::read_bytes(bytes.to_vec(), Some(format), folder, &options) {
        Err(error) => assert!(!error.found.is_empty() && !error.advice.is_empty(), "{error:?}"),
        Ok(loaded) => check_loaded(&loaded, &options, &mut choices, folder),
    }
}

fn check_loaded(loaded: &Loaded, options: &ReadOptions, choices: &mut Choices, folder: Option<&Path>) {
    for part in &loaded.parts {
        assert!(is_finite(&part.mesh), "a value is not finite");
    }
    loaded.appearance();
    if placed_corners(loaded) > MOST_CORNERS {
        return;
    }
    for format in Format::WRITTEN {
        let task = choices.task();
        let write = choices.write_options(task.emit, format, folder.filter(|_| !format.is_gltf()));
        let revision = pipeline::revise(loaded, &task, Some(format), &|_| {});
        // Stored normals are kept if their length is right within a tolerance; reversed ones are new values.
        let tolerance = if task.flip { LENGTH_TOLERANCE } else { 1e-6 };
        let has_new_faces = task.when == When::Always;
        revision.edits.iter().for_each(|edit| check_edit(edit, tolerance, has_new_faces));
        match io::write(loaded, &revision.edits, format, &write) {
            // Some content has no place in a format; the message says which.
            Err(error) => assert!(!error.to_string().is_empty()),
            Ok(written) => {
                let again = read_again(written, format, options, folder.is_some())
                    .unwrap_or_else(|error| panic!("{} as {format}, {write:?}: {error}", loaded.format));
                compare(loaded, &revision.edits, &task, &again);
            }
        }
    }
}

fn placed_corners(loaded: &Loaded) -> usize {
    let corners = |part: usize| {
        let mesh = &loaded.parts[part].mesh;
        mesh.faces().corner_count() + mesh.vertex_count()
    };
    let parts: usize = (0..loaded.parts.len()).map(corners).sum();
    parts.max(loaded.nodes.iter().map(|node| corners(node.part)).sum())
}

fn is_finite(mesh: &Mesh) -> bool {
    let columns = mesh.columns();
    mesh.positions().iter().all(|position| position.is_finite())
        && columns.uvs.iter().flat_map(|uvs| &uvs.values).all(|uv| uv.is_finite())
        && columns.colors.iter().flatten().flatten().all(|value| value.is_finite())
        && columns.morph_targets.iter().flatten().all(|moved| moved.is_finite())
}

/// New normals are finite and unit. Those of faces may be stored ones, unless all are new.
fn check_edit(edit: &PartEdit, tolerance: f64, has_new_faces: bool) {
    let new = edit.normals.iter().flat_map(|column| &column.values[edit.kept..]);
    let faces = edit.face_normals.iter().flatten().filter(|_| has_new_faces);
    let all = new.chain(faces).chain(edit.morph_normals.iter().flatten());
    for normal in all {
        assert!((normal.length() - 1.0).abs() <= tolerance, "a normal of length {}", normal.length());
    }
}

/// Reads an output back, with its companion files next to it.
fn read_again(
    written: Written,
    format: Format,
    options: &ReadOptions,
    has_folder: bool,
) -> Result<Loaded, io::ReadError> {
    let folder = has_folder.then(|| fresh_folder("out"));
    for companion in &written.companions {
        let name = Path::new(&companion.name);
        let is_inside = name.components().all(|part| matches!(part, Component::Normal(_)));
        assert!(is_inside, "a companion outside the folder of the output: {name:?}");
        let Some(folder) = &folder else { continue };
        let path = folder.join(name);
        std::fs::create_dir_all(path.parent().expect("a file has a folder")).expect("a folder");
        match &companion.content {
            OutputContent::Bytes(bytes) => std::fs::write(&path, bytes).expect("a companion"),
            OutputContent::CopyOf(from) => drop(std::fs::copy(from, &path).expect("a copy")),
        }
    }
    // An edited file keeps its extensions, and stored positions that are not finite.
    let options = ReadOptions { limits: Limits::default(), ..options.clone() };
    io::read_bytes(written.bytes, Some(format), folder.as_deref(), &options)
}

/// A corner of a face: its position, and its normal if that must be in the output.
type Corner = (DVec3, Option<DVec3>);

/// The output has the same faces in the same order, within the limits of its format (docs/formats.md):
/// - positions are those of the mesh, rounded to `f32` at most;
/// - a new glTF and STL have triangles, and a new glTF has them in the order of objects and materials;
/// - normals have the precision of the output: `f32`, in glTF also 16 or 8 bits;
/// - STL has the normals of facets, and other formats with `--emit face` those of faces.
fn compare(loaded: &Loaded, edits: &[PartEdit], task: &Task, again: &Loaded) {
    let (from, to) = (loaded.format, again.format);
    let what = format!("{from} as {to} with {task:?}");
    let by_face = to == Format::Stl || task.emit == Emit::Face;
    let is_edited = to.edits(from);
    let expected = faces(loaded, edits, by_face, !is_edited);
    let found = faces(again, &[], false, !is_edited);
    if to.is_gltf() && !is_edited {
        let (expected, found) = (sorted_triangles(&expected), sorted_triangles(&found));
        assert_eq!(expected.len(), found.len(), "{what}: triangles");
        assert!(expected == found, "{what}: other triangles");
        return;
    }
    let cut = |meshes: Vec<Mesh>| if to == Format::Stl { triangles(&meshes) } else { polygons(&meshes) };
    let (mut expected, mut found) = (cut(expected), cut(found));
    if to.is_gltf() {
        // A primitive without faces keeps one triangle that has no area.
        let has_area = |face: &Vec<Corner>| face.iter().any(|corner| corner.0 != face[0].0);
        expected.retain(has_area);
        found.retain(has_area);
    }
    assert_eq!(expected.len(), found.len(), "{what}: faces");
    let tolerance = if to.is_gltf() { 0.02 } else { 1e-5 };
    // Compressed triangles may begin at another corner.
    let turns = if to.is_gltf() { 3 } else { 1 };
    for (face, (expected, found)) in expected.iter().zip(&found).enumerate() {
        assert_eq!(expected.len(), found.len(), "{what}: corners of face {face}");
        let is_same = |turn: usize| {
            let found = found.iter().cycle().skip(turn);
            expected.iter().zip(found).all(|(expected, found)| is_same_corner(*expected, *found, tolerance))
        };
        assert!((0..turns).any(is_same), "{what}: face {face} is {found:?} instead of {expected:?}");
    }
}

/// Stored normals that are not unit vectors may be kept.
fn is_same_corner((p, n): Corner, (q, m): Corner, tolerance: f64) -> bool {
    let is_same = |(n, m): (DVec3, DVec3)| (n.length() - 1.0).abs() > 1e-3 || n.distance(m) <= tolerance;
    is_close(p, q) && n.zip(m).is_none_or(is_same)
}

/// Equal within the rounding to `f32`.
fn is_close(a: DVec3, b: DVec3) -> bool {
    let is_close =
        |a: f64, b: f64| (a - b).abs() <= a.abs() / f64::from(1 << 23) + f64::from(f32::from_bits(1));
    (0..3).all(|axis| is_close(a[axis], b[axis]))
}

/// The meshes as they are written: with their edits, and placed in the world if `is_placed`.
fn faces(loaded: &Loaded, edits: &[PartEdit], by_face: bool, is_placed: bool) -> Vec<Mesh> {
    let edited = |part: usize| {
        let mut mesh = loaded.parts[part].mesh.clone();
        let Some(edit) = edits.get(part) else { return mesh };
        let normals = match &edit.face_normals {
            Some(normals) if by_face => {
                Some(crease::mesh::Column::per_corner(normals.clone(), mesh.faces().owners()))
            }
            _ => edit.normals.clone(),
        };
        if normals.is_some() {
            mesh = mesh.with_normals(normals);
        }
        mesh.with_faces(&edit.faces)
    };
    if !is_placed || loaded.nodes.is_empty() {
        return (0..loaded.parts.len()).map(edited).collect();
    }
    let placed = |node: &io::FileNode| {
        let mesh = edited(node.part);
        mesh.transformed(node.world_from_part).unwrap_or_else(|fault| panic!("{fault:?} was written"))
    };
    loaded.nodes.iter().map(placed).collect()
}

fn corner(mesh: &Mesh, corner: usize) -> Corner {
    let vertex = mesh.faces().corners()[corner];
    let normals = mesh.columns().normals.as_ref();
    (mesh.positions().at(vertex), normals.and_then(|normals| normals.get(corner, vertex).copied()))
}

fn polygons(meshes: &[Mesh]) -> Vec<Vec<Corner>> {
    let faces = |mesh| Mesh::faces(mesh).ranges().map(|range| range.map(|c| corner(mesh, c)).collect());
    meshes.iter().flat_map(faces).collect()
}

fn triangles(meshes: &[Mesh]) -> Vec<Vec<Corner>> {
    let cut =
        |mesh| triangulate(mesh).triangles.into_iter().map(|c| c.map(|c| corner(mesh, c as usize)).to_vec());
    meshes.iter().flat_map(cut).collect()
}

/// The triangles by the bits of their positions in single precision, each from its least corner on.
fn sorted_triangles(meshes: &[Mesh]) -> Vec<[[u32; 3]; 3]> {
    // Both zeros are equal.
    let bits = |(position, _): &Corner| position.as_vec3().to_array().map(|x| (x + 0.0).to_bits());
    let mut all: Vec<[[u32; 3]; 3]> = Vec::new();
    for triangle in triangles(meshes) {
        let corners = [bits(&triangle[0]), bits(&triangle[1]), bits(&triangle[2])];
        let turned = [0, 1, 2].map(|first| [0, 1, 2].map(|k| corners[(first + k) % 3]));
        all.extend(turned.into_iter().min());
    }
    all.sort_unstable();
    all
}

/// A GLB whose lengths suit its content: the text up to the signature of the binary chunk, and the bytes behind it.
pub fn repaired_glb(bytes: &[u8]) -> Option<Vec<u8>> {
    let text_and_rest = bytes.get(20..)?;
    let signature = text_and_rest.windows(4).position(|word| word == b"BIN\0");
    let (text, binary) = match signature {
        Some(at) => (&text_and_rest[..at.saturating_sub(4)], Some(&text_and_rest[at + 4..])),
        None => (text_and_rest, None),
    };
    let mut glb = b"glTF\x02\0\0\0\0\0\0\0".to_vec();
    for (name, chunk, padding) in [(b"JSON", Some(text), b' '), (b"BIN\0", binary, 0)] {
        let Some(chunk) = chunk else { continue };
        let length = chunk.len().next_multiple_of(4);
        glb.extend((length as u32).to_le_bytes());
        glb.extend(name);
        glb.extend(chunk);
        glb.resize(glb.len() + length - chunk.len(), padding);
    }
    let length = (glb.len() as u32).to_le_bytes();
    glb[8..12].copy_from_slice(&length);
    Some(glb)
}
