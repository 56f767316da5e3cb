//! glTF files that mean harm or are simply broken: errors, never panics, and never more memory than the file's size
//! warrants.

use super::gltf::{entries, load};
use crease::io::gltf::{edit, read};
use crease::io::{
    Document, Format, NonFinite, Part, PartEdit, Problem, ReadOptions, TangentPolicy, WriteOptions,
};
use crease::mesh::{Column, FaceEdit};
use glam::DVec3;
use std::path::Path;

/// Small files of each spelling, from this repository.
fn seeds() -> Vec<Vec<u8>> {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("data");
    let names = ["mirrored.gltf", "morph.gltf", "sphere-seam.glb"];
    names.iter().map(|name| std::fs::read(data.join(name)).unwrap()).collect()
}

/// Reads a file, and if that succeeds edits it in every way; all of it may fail, none of it may panic.
fn try_everything(bytes: &[u8]) -> bool {
    let force = ReadOptions { non_finite: NonFinite::DropFaces, ..ReadOptions::default() };
    let Ok(loaded) = read(bytes.to_vec(), None, &force) else { return false };
    let Document::Gltf(document) = &loaded.document else { panic!("no glTF") };
    let options = WriteOptions { tangents: TangentPolicy::Regenerate, ..WriteOptions::default() };
    let edits: Vec<PartEdit> = loaded.parts.iter().map(per_face).collect();
    for to in [Format::Gltf, Format::Glb] {
        if let Ok(written) = edit(document, &loaded, &edits, to, &options) {
            let again = read(written.bytes, None, &force);
            assert!(again.is_ok(), "what was written does not read: {}", again.unwrap_err());
        }
    }
    true
}

fn per_face(part: &Part) -> PartEdit {
    let faces = part.mesh.face_count() as u32;
    let values = vec![DVec3::X, DVec3::Y, DVec3::Z];
    let index = (0..3 * faces).map(|corner| corner / 3 % 3).collect();
    let targets = part.mesh.columns().morph_targets.len();
    PartEdit {
        faces: FaceEdit { dropped: part.non_finite_faces.clone(), reversed: (0..faces).step_by(5).collect() },
        morph_normals: vec![values.clone(); targets],
        normals: Some(Column::per_corner(values, index)),
        ..PartEdit::default()
    }
}

#[test]
fn every_prefix_is_an_error_or_loads() {
    for seed in seeds() {
        assert!(try_everything(&seed));
        let step = seed.len() / 1000 + 1;
        for end in (0..seed.len()).step_by(step) {
            try_everything(&seed[..end]);
        }
    }
}

#[test]
fn flipped_bytes_never_panic() {
    let mut random = 0x9E37_79B9_7F4A_7C15_u64;
    let mut next = || {
        // xorshift64*, Vigna 2016.
        random ^= random >> 12;
        random ^= random << 25;
        random ^= random >> 27;
        random.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 32
    };
    for seed in seeds() {
        let rounds = (6_000_000 / seed.len()).clamp(200, 3000);
        for _ in 0..rounds {
            let mut bytes = seed.clone();
            for _ in 0..=next() % 3 {
                let at = next() as usize % bytes.len();
                // Digits make new numbers out of old ones, which gets further than noise.
                bytes[at] =
                    if bytes[at].is_ascii_digit() { b'0' + (next() % 10) as u8 } else { next() as u8 };
            }
            try_everything(&bytes);
        }
    }
}

#[test]
fn force_leaves_a_file_that_needs_no_force() {
    let bad = entries("bad/")
        .into_iter()
        .filter(|entry| entry.name.contains("nan_positions") || entry.name.contains("Infinites"));
    for entry in bad {
        let bytes = std::fs::read(&entry.path).unwrap();
        let error = read(bytes.clone(), None, &ReadOptions::default()).unwrap_err();
        assert_eq!(error.problem, Problem::NonFinite, "{}", entry.name);
        let force = ReadOptions { non_finite: NonFinite::DropFaces, ..ReadOptions::default() };
        let loaded = read(bytes, None, &force).unwrap();
        let Document::Gltf(document) = &loaded.document else { panic!("no glTF") };
        assert!(loaded.parts.iter().any(|part| !part.non_finite_faces.is_empty()), "{}", entry.name);
        let dropped = |part: &Part| FaceEdit { dropped: part.non_finite_faces.clone(), reversed: Vec::new() };
        let faces_only = |part: &Part| PartEdit { faces: dropped(part), ..PartEdit::default() };
        let both = |part: &Part| PartEdit { faces: dropped(part), ..per_face(part) };
        for edits in
            [loaded.parts.iter().map(faces_only).collect::<Vec<_>>(), loaded.parts.iter().map(both).collect()]
        {
            let written = edit(document, &loaded, &edits, Format::Glb, &WriteOptions::default()).unwrap();
            read(written.bytes, None, &ReadOptions::default()).unwrap();
        }
    }
}

#[test]
fn real_bad_files_survive_everything() {
    for entry in entries("bad/") {
        try_everything(&std::fs::read(&entry.path).unwrap());
        let _ = load(&entry.path);
    }
}

fn document(accessors: &str, meshes: &str, views: &str, bin: &[u8]) -> Vec<u8> {
    use base64::Engine;
    let data = base64::engine::general_purpose::STANDARD.encode(bin);
    format!(
        "{{\"asset\":{{\"version\":\"2.0\"}},\"accessors\":[{accessors}],\"meshes\":[{meshes}],\"bufferViews\":[{views}],\
         \"buffers\":[{{\"byteLength\":{},\"uri\":\"data:;base64,{data}\"}}]}}",
        bin.len()
    )
    .into_bytes()
}

fn refused(bytes: Vec<u8>) -> Problem {
    read(bytes, None, &ReadOptions::default()).unwrap_err().problem
}

#[test]
fn the_same_bytes_cannot_be_asked_for_without_end() {
    let bin = vec![0; 1_200_000];
    let view = "{\"buffer\":0,\"byteLength\":1200000}";
    let accessor = "{\"bufferView\":0,\"componentType\":5126,\"type\":\"VEC3\",\"count\":100000}";
    // A thousand meshes of a hundred thousand vertices each would take 2.4 GB.
    let mesh = "{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"mode\":0}]}";
    assert_eq!(refused(document(accessor, &[mesh; 1000].join(","), view, &bin)), Problem::Limit);
    // As would a thousand morph targets, or primitives that differ in what they do not need.
    let targets = ["{}"; 1000].join(",");
    let mesh = format!("{{\"primitives\":[{{\"attributes\":{{\"POSITION\":0}},\"targets\":[{targets}]}}]}}");
    assert_eq!(refused(document(accessor, &mesh, view, &bin)), Problem::Limit);
    let primitives: Vec<String> =
        (0..1000).map(|n| format!("{{\"attributes\":{{\"POSITION\":0,\"_{n}\":0}},\"mode\":0}}")).collect();
    let mesh = format!("{{\"primitives\":[{}]}}", primitives.join(","));
    assert_eq!(refused(document(accessor, &mesh, view, &bin)), Problem::Limit);
    // One primitive that shares them all is fine.
    let shared = ["{\"attributes\":{\"POSITION\":0},\"mode\":0,\"indices\":1}"; 1000].join(",");
    let index = "{\"bufferView\":0,\"componentType\":5125,\"type\":\"SCALAR\",\"count\":3}";
    let bytes =
        document(&format!("{accessor},{index}"), &format!("{{\"primitives\":[{shared}]}}"), view, &bin);
    let loaded = read(bytes, None, &ReadOptions::default()).unwrap();
    assert_eq!(loaded.parts[0].mesh.vertex_count(), 100_000);
}

#[test]
fn offsets_that_wrap_are_out_of_range() {
    let view = "{\"buffer\":0,\"byteLength\":36}";
    let mesh = "{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}";
    let accessor =
        |extra: &str| format!("{{\"bufferView\":0,\"componentType\":5126,\"type\":\"VEC3\",{extra}}}");
    let max = u64::MAX;
    let wraps = [
        (accessor(&format!("\"count\":3,\"byteOffset\":{max}")), view.to_owned()),
        (accessor(&format!("\"count\":{max}")), view.to_owned()),
        (accessor("\"count\":3"), format!("{{\"buffer\":0,\"byteLength\":36,\"byteOffset\":{max}}}")),
        (accessor("\"count\":3"), format!("{{\"buffer\":0,\"byteLength\":{max},\"byteOffset\":{max}}}")),
        (accessor("\"count\":3"), format!("{{\"buffer\":0,\"byteLength\":36,\"byteStride\":{max}}}")),
        (accessor("\"count\":3"), "{\"buffer\":0,\"byteLength\":36,\"byteStride\":0}".to_owned()),
        (accessor("\"count\":4"), view.to_owned()),
        (accessor("\"count\":0"), view.to_owned()),
    ];
    for (accessor, view) in wraps {
        assert_eq!(refused(document(&accessor, mesh, &view, &[0; 36])), Problem::Range, "{accessor} {view}");
    }
    assert!(
        read(document(&accessor("\"count\":3"), mesh, view, &[0; 36]), None, &ReadOptions::default()).is_ok()
    );
}
