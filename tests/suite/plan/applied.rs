//! Mesh files as planned: they draw what was planned to the bit, and their sizes are as stated.

use super::{only, scene_in};
use crate::cli::{data, names};
use crate::meshes;
use crease::io::gltf::GltfDocument;
use crease::io::{
    Document, Format, Loaded, NormalFormat, OutputContent, ReadOptions, WriteOptions, read, write,
};
use crease::mesh::Column;
use crease::plan::{Applied, Axis, FileSize, Home, Minimise, Plan, PlanError, PlanOptions, Reference};
use crease::plan::{apply, plan, scene_text, with_size, with_stored_normals};
use crease::raster::{Camera, LoadOptions, RenderSettings, SceneFile, SceneShape, render};
use glam::{DQuat, DVec3};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// A plan of a scene or a file, and its mesh files in a folder.
struct Done {
    plan: Plan,
    applied: Applied,
    folder: TempDir,
}

impl Done {
    fn change(&self, axis: Axis) -> Option<&str> {
        super::change(&self.plan, axis)
    }

    fn file(&self, name: &str) -> Loaded {
        read(&self.folder.path().join(name), None, &ReadOptions::default()).unwrap()
    }
}

fn options(tolerance: f64) -> PlanOptions {
    PlanOptions { tolerance, minimise: Minimise::Bytes, for_files: true, ..PlanOptions::default() }
}

/// Plans a scene, whose files go into a folder under their own names with another ending.
fn applied(
    text: &str,
    base: &Path,
    reference: Reference,
    ending: &str,
    options: &PlanOptions,
) -> Result<Done, PlanError> {
    let load = LoadOptions::default();
    let text = with_stored_normals(text, base, &load, reference)?;
    let plan = plan(&text, base, &load, options, &|_| ())?;
    let folder = tempfile::tempdir().unwrap();
    let mut taken = BTreeSet::new();
    let mut home = |input: &Path| {
        let stem = input.file_stem().unwrap().to_str().unwrap();
        let mut names = (0..).map(|number| format!("{stem}{number}.{ending}"));
        let mesh = names.find(|name| taken.insert(name.clone())).unwrap();
        Home { path: folder.path().join(&mesh), mesh }
    };
    let applied = apply(&plan, base, &load, &mut home)?;
    for file in &applied.files {
        store(&folder, &file.home.mesh, &file.written.bytes);
        for companion in &file.written.companions {
            match &companion.content {
                OutputContent::Bytes(bytes) => store(&folder, &companion.name, bytes),
                OutputContent::CopyOf(path) => store(&folder, &companion.name, &fs::read(path).unwrap()),
            }
        }
    }
    Ok(Done { plan, applied, folder })
}

fn store(folder: &TempDir, name: &str, bytes: &[u8]) {
    let path = folder.path().join(name);
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    fs::write(path, bytes).unwrap();
}

fn of_file(path: &Path, ending: &str, options: &PlanOptions) -> Result<Done, PlanError> {
    of(path, Reference::File, ending, options)
}

fn of(path: &Path, reference: Reference, ending: &str, options: &PlanOptions) -> Result<Done, PlanError> {
    let text = with_size(&scene_text(path, &LoadOptions::default())?, [40, 40]).unwrap();
    applied(&text, path.parent().unwrap(), reference, ending, options)
}

/// Pictures of the planned scene and of the one with its files, from the scene's camera and from three others.
fn compare(done: &Done, base: &Path, name: &str) {
    let (mut planned, mut written) =
        (scene_in(&done.plan.text, base), scene_in(&done.applied.text, done.folder.path()));
    let camera = planned.scene().camera;
    assert_eq!(camera, written.scene().camera, "{name}");
    let turned = |turn: DQuat| Camera { eye: camera.target + turn * (camera.eye - camera.target), ..camera };
    let turns = [
        DQuat::IDENTITY,
        DQuat::from_rotation_y(1.9),
        DQuat::from_rotation_x(0.7),
        DQuat::from_axis_angle(DVec3::ONE.normalize(), 3.6),
    ];
    for camera in turns.map(turned) {
        (planned.camera, written.camera) = (Some(camera), Some(camera));
        let of = |file: &SceneFile| {
            let settings = RenderSettings { keep_linear: true, keep_objects: true, ..file.settings };
            render(&file.scene(), &settings).unwrap()
        };
        let (planned, written) = (of(&planned), of(&written));
        let bits = |linear: &Option<Vec<[f32; 3]>>| -> Vec<[u32; 3]> {
            linear.as_ref().unwrap().iter().map(|colour| colour.map(|x| (x + 0.0).to_bits())).collect()
        };
        assert!(bits(&planned.linear) == bits(&written.linear), "{name}: colours");
        assert_eq!((planned.coverage, planned.objects), (written.coverage, written.objects), "{name}");
        assert!(planned.pixels == written.pixels, "{name}: pixels");
    }
}

/// The bytes of a file and of its buffers, and those of vertices and indices, from the JSON of the file alone.
fn size_of(path: &Path) -> FileSize {
    let bytes = fs::read(path).unwrap();
    let mut file_bytes = bytes.len() as u64;
    let text = match bytes.starts_with(b"glTF") {
        true => &bytes[20..20 + u32::from_le_bytes(bytes[12..16].try_into().unwrap()) as usize],
        false => &bytes[..],
    };
    let json: serde_json::Value = serde_json::from_slice(text).unwrap();
    let buffers: BTreeSet<&str> =
        json["buffers"].as_array().into_iter().flatten().filter_map(|it| it["uri"].as_str()).collect();
    for uri in buffers.into_iter().filter(|uri| !uri.starts_with("data:")) {
        file_bytes += fs::metadata(path.parent().unwrap().join(uri.replace("%20", " "))).unwrap().len();
    }
    let (mut vertices, mut indices) = (BTreeSet::new(), BTreeSet::new());
    for primitive in json["meshes"]
        .as_array()
        .into_iter()
        .flatten()
        .flat_map(|mesh| mesh["primitives"].as_array().unwrap())
    {
        let sets = std::iter::once(&primitive["attributes"])
            .chain(primitive["targets"].as_array().into_iter().flatten());
        vertices.extend(sets.flat_map(|set| set.as_object().unwrap().values()).filter_map(|it| it.as_u64()));
        indices.extend(primitive["indices"].as_u64());
    }
    let element = |number: u64| {
        let accessor = &json["accessors"][number as usize];
        let component = match accessor["componentType"].as_u64().unwrap() {
            5120 | 5121 => 1,
            5122 | 5123 => 2,
            _ => 4,
        };
        let kind = accessor["type"].as_str().unwrap();
        let width = if kind == "SCALAR" { 1 } else { kind[3..].parse::<u64>().unwrap() };
        (component * width, accessor["count"].as_u64().unwrap())
    };
    let loaded = read(path, None, &ReadOptions::default()).unwrap();
    FileSize {
        file_bytes,
        vertex_bytes: vertices
            .into_iter()
            .map(element)
            .map(|(size, count)| size.next_multiple_of(4) * count)
            .sum(),
        index_bytes: indices.into_iter().map(element).map(|(size, count)| size * count).sum(),
        vertices: loaded.parts.iter().map(|part| part.mesh.vertex_count() as u64).sum(),
    }
}

/// Everything that holds for all files.
fn check(done: &Done, base: &Path, name: &str) {
    for file in &done.applied.files {
        assert_eq!(file.before, size_of(&file.input), "{name}: before");
        assert_eq!(file.after, size_of(&file.home.path), "{name}: after");
        assert!(
            file.after.vertex_bytes <= file.before.vertex_bytes || !has_all_normals(&file.input),
            "{name}"
        );
    }
    compare(done, base, name);
}

/// Whether all corners of faces have stored normals. Otherwise computed ones are added.
fn has_all_normals(path: &Path) -> bool {
    let loaded = read(path, None, &ReadOptions::default()).unwrap();
    loaded.parts.iter().all(|part| {
        let mut corners = part.mesh.faces().corners().iter().enumerate();
        let normals = part.mesh.columns().normals.as_ref();
        corners.all(|(corner, &vertex)| normals.is_some_and(|normals| normals.get(corner, vertex).is_some()))
    })
}

fn document(loaded: &Loaded) -> &GltfDocument {
    let Document::Gltf(document) = &loaded.document else { panic!("no glTF") };
    document
}

/// A shape of a scene as a GLB, with or without normals.
fn glb(folder: &TempDir, shape: &str, has_normals: bool) -> PathBuf {
    let text = format!("[[object]]\n{shape}\n");
    let mut file = scene_in(&text, folder.path());
    let SceneShape::Mesh(number) = file.objects[0].shape else { panic!("a mesh") };
    let mesh = file.meshes.swap_remove(number).mesh;
    let mesh = if has_normals { mesh } else { mesh.with_normals(None) };
    let part = crease::io::Part { name: "shape".into(), mesh, ..Default::default() };
    let written = crease::io::write_new(&[part], Format::Glb, &WriteOptions::default()).unwrap();
    let path = folder.path().join("shape.glb");
    fs::write(&path, written.bytes).unwrap();
    path
}

const SPHERE: &str = "surface = { sphere = { radius = 1 } }\ntessellation = { segments = [24, 16] }";
/// With the default crease angle it has three normals at each corner.
const CUBE: &str = "polygons = { vertices = [[-1, -1, -1], [1, -1, -1], [1, 1, -1], [-1, 1, -1], [-1, -1, 1], [1, -1, 1], [1, 1, 1], [-1, 1, 1]], \
     faces = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [2, 3, 7, 6], [1, 2, 6, 5], [0, 4, 7, 3]] }";

#[test]
fn stored_normals_become_smaller_as_the_tolerance_grows() {
    let folder = tempfile::tempdir().unwrap();
    let path = glb(&folder, SPHERE, true);
    let mut formats = Vec::new();
    for tolerance in [1e-4, 0.02, 5.0, 200.0] {
        let done = of_file(&path, "glb", &options(tolerance)).unwrap();
        check(&done, folder.path(), &format!("tolerance {tolerance}"));
        let loaded = done.file("shape0.glb");
        let stored = document(&loaded).normal_format();
        let planned = done.change(Axis::Storage).unwrap_or("f32").to_owned();
        assert!(done.plan.decisions.iter().all(|decision| decision.axis == Axis::Storage));
        let expected = match stored {
            Some(NormalFormat::F32) => "f32",
            Some(NormalFormat::I16) => "i16",
            Some(NormalFormat::I8) => "i8",
            _ => "none",
        };
        assert_eq!(planned, expected);
        assert!(done.applied.text.contains("mesh = \"shape0.glb\""), "{}", done.applied.text);
        formats.push(planned);
    }
    assert_eq!(formats, ["f32", "i16", "i8", "none"]);
}

/// A file of another format without normals is drawn with computed ones, and how they are computed may change.
#[test]
fn computed_normals_are_written_as_planned() {
    let folder = tempfile::tempdir().unwrap();
    let path = glb(&folder, CUBE, false);
    for (axes, tolerance) in [
        (vec![Axis::Creases], 255.0),
        (vec![Axis::Weight, Axis::Precision], 255.0),
        (vec![Axis::Storage], 3.0),
        (vec![Axis::Weight, Axis::Creases, Axis::Precision, Axis::Storage], 6.0),
        (vec![], 0.0),
    ] {
        let options = PlanOptions { minimise: Minimise::Work, ..options(tolerance) };
        let done =
            of(&path, Reference::Conversion, "gltf", &PlanOptions { keep: only(&axes, 0.0).keep, ..options })
                .unwrap();
        compare(&done, folder.path(), &format!("{axes:?}"));
        let mesh = &done.file("shape0.gltf").parts[0].mesh;
        if done.change(Axis::Creases).is_some() {
            let count = mesh.vertex_count();
            assert_eq!(count as u64, done.plan.planned.vertices, "vertices that agree are one");
            assert!(done.plan.declared.vertices > done.plan.planned.vertices);
        }
    }
    let mut creases = options(255.0);
    creases.keep = only(&[Axis::Creases], 0.0).keep;
    assert_eq!(
        of(&path, Reference::Conversion, "glb", &creases).unwrap().change(Axis::Creases),
        Some("none")
    );
}

/// By its standard, a glTF file without normals is flat.
#[test]
fn files_without_normals_stay_flat() {
    let folder = tempfile::tempdir().unwrap();
    let path = glb(&folder, SPHERE, false);
    let done = of_file(&path, "glb", &options(2.0)).unwrap();
    check(&done, folder.path(), "a sphere");
    assert!(
        done.plan.decisions.is_empty() && done.plan.text.contains("shading = \"flat\""),
        "{}",
        done.plan.text
    );
    let file = &done.applied.files[0];
    assert!(file.after.file_bytes <= file.before.file_bytes, "{file:?}");
}

/// Under a sun and without highlights, the faces of a cube need no normals, and its corners are 8 vertices.
#[test]
fn a_cube_without_normals_has_eight_vertices() {
    let Some(path) = meshes::path("gltf/BoxInterleaved.glb") else { return };
    let done = of_file(&path, "glb", &options(1.0)).unwrap();
    check(&done, path.parent().unwrap(), "BoxInterleaved");
    assert_eq!(done.change(Axis::Storage), Some("none"));
    let file = &done.applied.files[0];
    assert_eq!((file.before.vertices, file.after.vertices), (24, 8));
    assert_eq!((file.before.vertex_bytes, file.after.vertex_bytes), (576, 96));
    assert_eq!(document(&done.file("BoxInterleaved0.glb")).normal_format(), None);
}

/// A face without stored normals has that of its shape, not the one that all of its corners had.
#[test]
fn flat_faces_have_the_normals_of_their_shape() {
    let folder = tempfile::tempdir().unwrap();
    let path = glb(
        &folder,
        "polygons = { vertices = [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], faces = [[0, 1, 2, 3]] }",
        false,
    );
    let mut loaded = read(&path, None, &ReadOptions::default()).unwrap();
    let tilted = Column::per_vertex(vec![DVec3::new(0.28, 0.0, 0.96); 4]);
    let part = loaded.parts.remove(0);
    let part = crease::io::Part { mesh: part.mesh.with_normals(Some(tilted)), ..part };
    let written = crease::io::write_new(&[part], Format::Glb, &WriteOptions::default()).unwrap();
    fs::write(&path, written.bytes).unwrap();
    let done = of_file(&path, "glb", &options(255.0)).unwrap();
    check(&done, folder.path(), "a tilted normal");
    assert_eq!(done.change(Axis::Storage), Some("none"));
    assert!(done.plan.worst.steps > 5.0, "{:?}", done.plan.worst);
}

/// Tangents, normals of morph targets and normal maps need normals: they are never omitted.
#[test]
fn normals_stay_where_others_need_them() {
    for name in ["morph.gltf", "gltf/AnimatedMorphCube/AnimatedMorphCube.gltf", "gltf/Lantern/Lantern.gltf"] {
        let path = if name.contains('/') { meshes::path(name) } else { Some(data(name)) };
        let Some(path) = path else { continue };
        let done = of_file(&path, "glb", &options(255.0)).unwrap();
        check(&done, path.parent().unwrap(), name);
        assert_eq!(done.change(Axis::Storage), Some("i8"), "{name}");
        let (before, after) = (
            read(&path, None, &ReadOptions::default()).unwrap(),
            done.file(&done.applied.files[0].home.mesh),
        );
        for part in 0..before.parts.len() {
            assert_eq!(before.tangents(part).is_empty(), after.tangents(part).is_empty(), "{name}");
            let targets = before.parts[part].mesh.columns().morph_targets.len();
            assert_eq!(targets, after.parts[part].mesh.columns().morph_targets.len());
            for target in 0..targets {
                let deltas = |loaded: &Loaded| loaded.morph_normals(part, target).is_empty();
                assert_eq!(deltas(&before), deltas(&after), "{name}");
            }
        }
    }
}

/// Two objects of one file, one of which is flat by its own key, and a surface.
#[test]
fn each_object_of_a_scene_has_its_file() {
    let folder = tempfile::tempdir().unwrap();
    glb(&folder, SPHERE, true);
    let text = "# Three shapes.\n[settings]\nsize = [48, 40]\n[[light.directional]]\ntowards = [1, 2, 3]\n\
         [[object]]\nname = \"left\"\nmesh = \"shape.glb\" # a file\nnormals = \"given\"\ntransform = [{ translate = [-3, 0, 0] }]\n\
         [[object]]\nname = \"middle\"\nmesh = \"shape.glb\"\nshading = \"flat\"\n\
         [[object]]\nname = \"other\"\nmesh = \"shape.glb\"\nnormals = \"given\"\ntransform = [{ rotate = [0, 20, 0] }]\n\
         [[object]]\nname = \"kept\"\nmesh = \"shape.glb\"\nplan = \"keep\"\nweight = \"area\"\n\
         [[object]]\nname = \"ball\"\nsurface = { sphere = { radius = 1 } }\ntransform = [{ translate = [3, 0, 0] }]\n";
    let done = applied(text, folder.path(), Reference::Scene, "glb", &options(4.0)).unwrap();
    check(&done, folder.path(), "a scene");
    let written = &done.applied.text;
    assert!(written.contains("# Three shapes.") && !written.contains("\"shape.glb\""), "{written}");
    // The kept file is a copy, and its normals are computed as before.
    let kept = done.applied.files.iter().find(|file| file.before == file.after).expect("an unchanged file");
    assert_eq!(fs::read(&kept.home.path).unwrap(), fs::read(folder.path().join("shape.glb")).unwrap());
    assert!(written.contains("weight = \"area\""), "{written}");
    let file_of = |name: &str| {
        let object = written.split("[[object]]").find(|it| it.contains(&format!("\"{name}\""))).unwrap();
        object.split("mesh = \"").nth(1).unwrap().split('"').next().unwrap().to_owned()
    };
    assert_eq!(file_of("left"), file_of("other"));
    assert_eq!(document(&done.file(&file_of("middle"))).normal_format(), None);
    assert_eq!(done.plan.decisions.iter().map(|it| it.what.as_str()).collect::<Vec<_>>(), ["left", "other"]);
    assert_eq!(names(done.folder.path()).len(), 3, "{:?}", names(done.folder.path()));
}

#[test]
fn what_files_cannot_hold_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    glb(&folder, SPHERE, true);
    fs::write(folder.path().join("part.obj"), crate::cli::TRIANGLE).unwrap();
    let object = |keys: &str| format!("[settings]\nsize = [8, 8]\n[[object]]\n{keys}\n");
    let error = |text: &str| {
        let done = applied(text, folder.path(), Reference::Scene, "glb", &options(1.0));
        done.err().unwrap_or_else(|| panic!("{text}")).to_string()
    };
    let refused = [
        ("surface = { sphere = { radius = 1 } }", "no object of the scene has a mesh file"),
        ("mesh = \"part.obj\"", "part.obj is not a glTF file"),
        ("mesh = \"shape.glb\"\nnormal-format = \"oct8\"", "glTF cannot store normals as oct8"),
    ];
    for (keys, message) in refused {
        assert!(error(&object(keys)).contains(message), "{keys}: {}", error(&object(keys)));
    }
    assert!(error(&object("mesh = \"part.obj\"")).ends_with("`crease normals part.obj -o part.glb`"));
    assert!(error("[[object]]\nmesh = \"none.glb\"\n").contains("none.glb"));
}

/// Splits that an extension forbids are an error, and merging leaves such files alone.
#[test]
fn files_whose_vertices_have_numbers_keep_them() {
    let folder = tempfile::tempdir().unwrap();
    let path = glb(&folder, CUBE, false);
    let loaded = read(&path, None, &ReadOptions::default()).unwrap();
    let gltf = write(&loaded, Vec::new(), Format::Gltf, &WriteOptions::default()).unwrap().bytes;
    let mut json: serde_json::Value = serde_json::from_slice(&gltf).unwrap();
    json["meshes"][0]["primitives"][0]["extensions"] = serde_json::json!({"CESIUM_primitive_outline": {}});
    let marked = folder.path().join("marked.gltf");
    fs::write(&marked, json.to_string()).unwrap();
    let error =
        of(&marked, Reference::Conversion, "glb", &PlanOptions { keep: Axis::ALL.to_vec(), ..options(1.0) })
            .err()
            .unwrap();
    assert!(
        matches!(error, PlanError::Write { .. }) && error.to_string().contains("CESIUM_primitive_outline"),
        "{error}"
    );
    // Without normals nothing is split, and nothing is merged.
    let flat = of(&marked, Reference::Conversion, "glb", &options(255.0)).unwrap();
    assert_eq!(
        (flat.change(Axis::Storage), flat.applied.files[0].before.vertices),
        (Some("none"), flat.applied.files[0].after.vertices)
    );
    compare(&flat, folder.path(), "marked");
}

/// Real files at a small size, from one view and another one that was not used. `CREASE_LONG` includes the large ones.
#[test]
fn real_files_draw_as_planned() {
    let most = if std::env::var_os("CREASE_LONG").is_some() { usize::MAX } else { 12_000 };
    let (mut before, mut after, mut count) = (0, 0, 0);
    let small = meshes::rows("gltf/", &["gltf", "glb"]).into_iter();
    let small = small.filter(|row| row.text("expect").starts_with("load") && row.number("tris") <= most);
    for row in small {
        let options = PlanOptions { views: Some(1), budget: 2_000_000, ..options(2.0) };
        let done = match of_file(&row.path, "glb", &options) {
            Ok(done) => done,
            // Points and lines alone, or nothing that this view shows.
            Err(error) => {
                let text = error.to_string();
                let is_empty =
                    text.contains("no faces") || text.contains("no view") || text.contains("extension");
                assert!(is_empty, "{}: {text}", row.name());
                continue;
            }
        };
        check(&done, row.path.parent().unwrap(), row.name());
        let file = &done.applied.files[0];
        before += file.before.file_bytes;
        after += file.after.file_bytes;
        count += 1;
    }
    println!("{count} files: {before} bytes to {after}");
    assert!(count == 0 || count > 40 && after < before, "{count} files: {before} bytes to {after}");
}
