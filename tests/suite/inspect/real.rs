//! Real meshes, with known faults and without.

use super::grave;
use crate::meshes::{path, rows};
use crease::io::{ReadOptions, read};
use crease::quality::catalogue::Kind;
use crease::quality::{Diagnosis, Severity, Thresholds, diagnose};

fn inspect(name: &str) -> Option<Diagnosis> {
    let loaded = read(&path(name)?, None, &ReadOptions::default()).unwrap();
    Some(diagnose(&loaded, &Thresholds::default(), &|_| {}))
}

/// The faults of these files according to the manifest, as kinds of the catalogue, with their number if it is known.
const KNOWN: [(&str, Kind, Option<u64>); 17] = [
    ("stl/Spider_binary_flipped.stl", Kind::Inverted, None),
    ("stl/Spider_ascii_flipped.stl", Kind::Inverted, None),
    ("stl/Spider_binary_flipped.stl", Kind::ZeroArea, Some(56)),
    ("stl/torus_wrong_normals.stl", Kind::SwappedAxes, Some(1)),
    ("stl/busted_zero_normals.STL", Kind::ZeroNormals, Some(3 * 3878)),
    ("obj/box-incorrect-winding-order.obj", Kind::InconsistentWinding, None),
    ("obj/box-unnormalized.obj", Kind::NotUnit, None),
    ("obj/box-unnormalized.obj", Kind::Flipped, Some(12)),
    ("obj/box-incomplete-normals.obj", Kind::MissingNormals, None),
    ("obj/moebius.obj", Kind::NonOrientable, None),
    ("obj/non_manifold_wrap.obj", Kind::NonManifold, None),
    ("obj/fan3.obj", Kind::NonManifold, Some(1)),
    ("obj/hourglass_ico.obj", Kind::PinchedVertices, Some(1)),
    ("obj/spider.obj", Kind::ZeroArea, Some(56)),
    ("gltf/car_negscale.glb", Kind::MirroredNode, Some(2)),
    ("gltf/car_negscale.glb", Kind::ZeroArea, Some(12)),
    ("gltf/alien.glb", Kind::ZeroArea, Some(7)),
];

#[test]
fn known_faults_are_found() {
    for (name, kind, count) in KNOWN {
        let Some(diagnosis) = inspect(name) else { continue };
        let found = diagnosis.get(kind);
        assert!(found.is_some(), "{name}: {} is not among {:?}", kind.id(), diagnosis.findings);
        if let Some(count) = count {
            assert_eq!(found.map(|finding| finding.count), Some(count), "{name}: {}", kind.id());
        }
    }
}

/// References that another program computed, and analytic shapes.
#[test]
fn good_meshes_get_no_warning() {
    for name in [
        "ref/fandisk_vtk_split30.ply",
        "ref/wingnut_vtk_split45.ply",
        "gltf/roundedCube.glb",
        "gltf/ShapeCollection.glb",
        "ply/suzanne_vn.ply",
        "gltf/BoxInterleaved.glb",
    ] {
        let Some(diagnosis) = inspect(name) else { continue };
        assert_eq!(grave(&diagnosis), Vec::<&str>::new(), "{name}");
    }
}

/// Every error on the real meshes, and the result of checking it manually: all are real.
const LOOKED_AT: [(&str, &str, &str); 16] = [
    ("obj/box-incorrect-winding-order.obj", "inconsistent-winding", "made so"),
    ("obj/box-unnormalized.obj", "zero-normals", "its first vn is 0 0 0"),
    (
        "obj/box-unnormalized.obj",
        "flipped-normals",
        "the vn of three of its sides point to the sides opposite",
    ),
    ("obj/extra_vertex.obj", "zero-normals", "each vn is 0 0 0"),
    (
        "obj/pirate.obj",
        "inconsistent-winding",
        "18 edges of shared vertices are run the same way by both faces",
    ),
    (
        "obj/spider.obj",
        "inconsistent-winding",
        "10 edges of shared vertices are run the same way by both faces",
    ),
    (
        "obj/triple_vierbein.obj",
        "inconsistent-winding",
        "3 edges of shared vertices are run the same way by both faces",
    ),
    ("gltf/pirate_quantized.glb", "inconsistent-winding", "made from pirate.obj"),
    (
        "gltf/mesh-primitives-types.gltf",
        "flipped-normals",
        "a test of component types, whose normals have no meaning",
    ),
    ("stl/Spider_ascii_flipped.stl", "inverted-normals", "made so"),
    ("stl/Spider_ascii_flipped.stl", "inconsistent-winding", "made from spider.obj"),
    ("stl/Spider_binary_flipped.stl", "inverted-normals", "made so"),
    ("stl/Spider_binary_flipped.stl", "inconsistent-winding", "made from spider.obj"),
    ("stl/busted_zero_normals.STL", "zero-normals", "each normal is 0 0 0"),
    ("stl/multibody_ascii.stl", "inconsistent-winding", "12 edges are run the same way by both facets"),
    ("stl/torus_wrong_normals.stl", "swapped-axes", "made so"),
];

/// Kinds without a measure: no place is worse than another, or the unrounded normals are unknown and the cause has a bound.
const UNMEASURED: [Kind; 4] = [Kind::ZeroArea, Kind::NoFaces, Kind::Room, Kind::Quantised];

/// Every readable file is diagnosed, numbers stay within bounds, and each finding has a measure of its severity.
#[test]
fn every_readable_file_is_diagnosed() {
    let files = [
        ("obj", &["obj"][..]),
        ("ply", &["ply"]),
        ("stl", &["stl", "STL"]),
        ("gltf", &["gltf", "glb"]),
        ("bad", &["obj", "ply", "stl", "gltf", "glb"]),
    ];
    let long = std::env::var_os("CREASE_LONG").is_some();
    for row in files.into_iter().flat_map(|(folder, extensions)| rows(folder, extensions)) {
        let Ok(loaded) = read(&row.path, None, &ReadOptions::default()) else { continue };
        let faces: usize = loaded.parts.iter().map(|part| part.mesh.face_count()).sum();
        if faces > 5_000 && !long {
            continue;
        }
        let diagnosis = diagnose(&loaded, &Thresholds::default(), &|_| {});
        for finding in &diagnosis.findings {
            let (file, id) = (row.name(), finding.kind.id());
            let name = format!("{file}: {id}");
            let is_known = LOOKED_AT.iter().any(|(known, kind, _)| (*known, *kind) == (file, id));
            assert!(
                finding.severity < Severity::Error || is_known || file.starts_with("bad/"),
                "{name} is an error that was not checked: {finding:?}"
            );
            assert!(
                finding.count > 0 && finding.count <= finding.of,
                "{name}: {} of {}",
                finding.count,
                finding.of
            );
            let share = finding.area_share;
            assert!(share.is_none_or(|share| (0.0..=1.0).contains(&share)), "{name}: {share:?}");
            // A document without parts has no places.
            let least = diagnosis.parts.len().min(1);
            assert!((least..=10).contains(&finding.places.len()), "{name}");
            assert!(finding.places.iter().all(|site| site.part < diagnosis.parts.len()), "{name}");
            assert!(finding.degrees.is_none_or(|degrees| (0.0..=180.0001).contains(&degrees)), "{name}");
            let measures = [finding.degrees, finding.steps, finding.amount];
            assert!(measures.iter().any(Option::is_some) || UNMEASURED.contains(&finding.kind), "{name}");
        }
    }
}

/// The diagnosis is the same at any number of threads.
#[test]
fn threads_change_nothing() {
    let diagnose_with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| super::inspect(&super::clean::meshes()[1].mesh, 10))
    };
    assert_eq!(diagnose_with(1), diagnose_with(5));
}
