//! The path of a file through the library: read, revise, write, and read again.

use crate::meshes;
use crease::io::{self, Format, Loaded, PartEdit, ReadOptions, WriteOptions};
use crease::normals::{LENGTH_TOLERANCE, NormalRecipe, Weight, When};
use crease::pipeline::{Revision, Task, revise};
use std::collections::BTreeSet;
use std::path::Path;

/// All output as bytes, so that it can be read again from memory.
fn write(loaded: &Loaded, edits: &[PartEdit], to: Format) -> Vec<u8> {
    io::write(loaded, edits, to, &WriteOptions::default()).unwrap_or_else(|error| panic!("{error}")).bytes
}

fn read(bytes: Vec<u8>, format: Format, base: Option<&Path>) -> Loaded {
    io::read_bytes(bytes, Some(format), base, &ReadOptions::default())
        .unwrap_or_else(|error| panic!("{error}"))
}

fn revised(loaded: &Loaded, when: When, to: Format) -> Revision {
    revise(loaded, &Task { when, ..Task::default() }, Some(to), &|_| {})
}

/// How many corners there are; each has a normal that is finite and of unit length.
fn check_normals(loaded: &Loaded, tolerance: f64) -> usize {
    let mut corners = 0;
    for part in &loaded.parts {
        let mesh = &part.mesh;
        for (corner, &vertex) in mesh.faces().corners().iter().enumerate() {
            let normals = mesh.columns().normals.as_ref().expect("normals were written");
            let normal = normals.get(corner, vertex).expect("each corner has one");
            assert!(
                normal.is_finite() && (normal.length() - 1.0).abs() <= tolerance,
                "corner {corner}: {normal}"
            );
            corners += 1;
        }
    }
    corners
}

fn faces(loaded: &Loaded) -> usize {
    loaded.parts.iter().map(|part| part.mesh.face_count()).sum()
}

#[test]
fn every_good_file_comes_back_with_normals_in_its_own_format_and_as_glb() {
    let good = ["obj", "ply", "stl", "STL", "gltf", "glb"];
    let rows = meshes::rows("", &good);
    let rows =
        rows.iter().filter(|row| !row.name().starts_with("bad/") && row.text("expect").starts_with("load"));
    let mut count = 0;
    for row in rows {
        println!("{}", row.name());
        let base = row.path.parent();
        let loaded =
            io::read(&row.path, None, &ReadOptions::default()).unwrap_or_else(|error| panic!("{error}"));
        let own = loaded.format;

        let revision = revised(&loaded, When::Always, own);
        let bytes = write(&loaded, &revision.edits, own);
        let again = read(bytes.clone(), own, base);
        assert_eq!(faces(&again), faces(&loaded), "no face is lost");
        // Normals keep the storage that they had; 8-bit ones are off by up to the validator's bound.
        check_normals(&again, LENGTH_TOLERANCE);

        let second = revised(&again, When::Broken, own);
        assert!(second.edits.iter().all(PartEdit::is_empty), "a second time changes nothing");
        assert!(write(&again, &second.edits, own) == bytes, "not a byte");

        let revision = revised(&loaded, When::Always, Format::Glb);
        let glb = read(write(&loaded, &revision.edits, Format::Glb), Format::Glb, base);
        let corners = check_normals(&glb, if own.is_gltf() { LENGTH_TOLERANCE } else { 1e-6 });
        assert!(corners > 0 || faces(&loaded) == 0);
        count += 1;
    }
    assert!(count == 0 || count > 150, "only {count} files");
}

/// On larger meshes fits take minutes without optimisation.
const LARGEST: usize = 100_000;

#[test]
fn the_best_weight_has_a_normal_everywhere_and_keeps_creases() {
    let rows = meshes::rows("", &["obj", "ply", "stl", "STL", "gltf", "glb"]);
    let is_good = |row: &&meshes::Row| {
        !row.name().starts_with("bad/")
            && row.text("expect").starts_with("load")
            && row.number("tris") <= LARGEST
    };
    let (mut count, mut chosen) = (0, BTreeSet::new());
    for row in rows.iter().filter(is_good) {
        let loaded =
            io::read(&row.path, None, &ReadOptions::default()).unwrap_or_else(|error| panic!("{error}"));
        let with = |weight| {
            let recipe = NormalRecipe { weight, ..NormalRecipe::default() };
            revise(&loaded, &Task { recipe, ..Task::default() }, Some(loaded.format), &|_| {})
        };
        let [best, angle] = [Weight::Best, Weight::Angle].map(with);
        for (best, angle) in best.parts.iter().zip(&angle.parts) {
            assert_eq!((best.edges, best.splits), (angle.edges, angle.splits), "{}", row.name());
            chosen.extend(best.best.map(|choice| choice.weight.name()));
        }
        let again = read(write(&loaded, &best.edits, loaded.format), loaded.format, row.path.parent());
        assert_eq!(faces(&again), faces(&loaded), "{}", row.name());
        check_normals(&again, LENGTH_TOLERANCE);
        count += 1;
    }
    assert!(count == 0 || count > 150 && chosen == ["angle", "jet", "quadric"].into(), "{count} {chosen:?}");
}

#[test]
fn the_pipeline_does_not_depend_on_threads() {
    let gear = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/gear.obj");
    let loaded = io::read(&gear, None, &ReadOptions::default()).unwrap();
    let outputs = [1, 2, 3, 8].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| write(&loaded, &revised(&loaded, When::Always, Format::Glb).edits, Format::Glb))
    });
    assert!(outputs.windows(2).all(|pair| pair[0] == pair[1]));
}
