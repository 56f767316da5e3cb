//! Nothing is wrong with what `crease normals` has just written, in any format.

use crate::cli::{crease, path, text};
use crate::meshes::{Row, rows};
use crease::io::{Format, Part, ReadOptions, WriteOptions, read, write_new};
use crease::mesh::{Columns, Faces, Mesh, MeshBuilder, Positions, Storage};
use crease::quality::catalogue::Family;
use crease::quality::{Severity, Thresholds, diagnose};
use crease::surface::{Sphere, Surface, Tessellation};
use glam::DVec3;
use rayon::prelude::*;
use std::fs;
use std::path::Path;

/// A grid of quads that are not flat, on a saddle so steep that some dihedral angles exceed the crease angle.
fn saddle() -> Mesh {
    let place = |i: u32, j: u32| {
        let [x, y] = [i, j].map(|k| f64::from(k) - 4.0);
        DVec3::new(x, y, 0.22 * x * y + if (i + j).is_multiple_of(3) { 0.5 } else { 0.0 })
    };
    let positions = (0..81).map(|k| place(k % 9, k / 9)).collect();
    let corner = |i: u32, j: u32| i + 9 * j;
    let mut faces = Faces::new();
    for (i, j) in (0..8).flat_map(|j| (0..8).map(move |i| (i, j))) {
        faces.push(&[corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)]);
    }
    let builder = MeshBuilder {
        positions: Positions::rounded(positions, Storage::F32),
        faces,
        columns: Columns::default(),
    };
    builder.build().unwrap()
}

#[test]
fn halves_of_quadrilaterals_have_the_normals_of_these() {
    let folder = tempfile::tempdir().unwrap();
    let parts = [Part { mesh: saddle(), ..Part::default() }];
    let written = write_new(&parts, Format::Ply, &WriteOptions::default()).unwrap();
    let file = folder.path().join("saddle.ply");
    fs::write(&file, written.bytes).unwrap();
    let outliers =
        blamed(&file, true).into_iter().filter(|reported| reported.contains("stray")).collect::<Vec<_>>();
    assert_eq!(outliers, Vec::<String>::new());
}

const FORMATS: [Format; 4] = [Format::Obj, Format::Ply, Format::Glb, Format::Stl];

/// Errors and warnings about normals in the program's output for a file. Formats that cut polygons are only checked for triangle
/// meshes: polygons that are not flat keep their normals, which are not those of their triangles.
fn blamed(file: &Path, are_triangles: bool) -> Vec<String> {
    let folder = tempfile::tempdir().unwrap();
    let keeps_polygons = |format: &&Format| matches!(format, Format::Obj | Format::Ply);
    let formats = FORMATS.iter().filter(|format| are_triangles || keeps_polygons(format));
    let blamed = formats.flat_map(|format| {
        let written = folder.path().join(format!("own.{}", format.extension()));
        let output = crease().args(["normals", "-q", &path(file), "-o", &path(&written)]).output().unwrap();
        assert!(output.status.success(), "{}: {}", file.display(), text(&output.stderr));
        let loaded = read(&written, None, &ReadOptions::default()).unwrap();
        let diagnosis = diagnose(&loaded, &Thresholds::default(), &|_| {});
        let about_normals = diagnosis.findings.into_iter().filter(|finding| {
            finding.severity > Severity::Note
                && matches!(finding.kind.entry().family, Family::Stored | Family::Smoothing)
        });
        let reported =
            |it: crease::quality::Finding| format!("{}: {} {}", format.extension(), it.count, it.kind.id());
        about_normals.map(reported).collect::<Vec<_>>()
    });
    blamed.collect()
}

/// A rough ball in `f32`, with slivers no higher than a rounding error, as if one part of a mesh was cut and its neighbour was
/// not, and with needles a few times as high.
fn with_slivers(seed: u32, round: impl Fn(f64) -> f64) -> Mesh {
    let rough = Tessellation { noise: 0.2, seed, segments: [32, 20], ..Tessellation::default() };
    let ball = Surface::from(Sphere::default()).tessellate(&rough).unwrap();
    let round = |point: DVec3| DVec3::from_array(point.to_array().map(|x| f64::from(round(x) as f32)));
    let mut positions: Vec<DVec3> = ball.positions().iter().map(round).collect();
    let mut faces = Faces::new();
    for (number, face) in ball.faces().iter().enumerate() {
        let &[a, b, c] = face else { panic!("the ball is of triangles") };
        if number % 5 > 0 {
            faces.push(face);
            continue;
        }
        let [from, to, top] = [a, b, c].map(|vertex| positions[vertex as usize]);
        let share = 0.2 + 0.1 * (number % 7) as f64;
        let inward = [0.0, 1e-6, 3e-6][number % 3];
        positions.push(round(from.lerp(to, share).lerp(top, inward)));
        let between = positions.len() as u32 - 1;
        [[a, between, c], [between, b, c], [a, b, between]].iter().for_each(|face| faces.push(face));
    }
    let builder = MeshBuilder {
        positions: Positions::rounded(positions, Storage::F32),
        faces,
        columns: Columns::default(),
    };
    builder.build().unwrap()
}

#[test]
fn own_normals_of_slivers_and_needles_are_right_in_every_format() {
    let roundings: [fn(f64) -> f64; 2] = [|x| x, |x| format!("{x:.5e}").parse().unwrap()];
    let folder = tempfile::tempdir().unwrap();
    for (round, name) in roundings.into_iter().zip(["singles", "six digits"]) {
        for seed in 0..4 {
            let parts = [Part { mesh: with_slivers(seed, round), ..Part::default() }];
            let written = write_new(&parts, Format::Ply, &WriteOptions::default()).unwrap();
            let file = folder.path().join("slivers.ply");
            fs::write(&file, written.bytes).unwrap();
            assert_eq!(blamed(&file, true), Vec::<String>::new(), "{name}, {seed}");
        }
    }
}

/// The same for real meshes of one part. With several parts, normals computed for each part show where they meet if the output
/// joins them, and vice versa. `CREASE_LONG` includes the large meshes.
#[test]
fn own_normals_of_real_meshes_are_right_in_every_format() {
    let most = if std::env::var_os("CREASE_LONG").is_some() { u64::MAX } else { 500_000 };
    let folders = [
        ("obj", &["obj"][..]),
        ("ply", &["ply"]),
        ("stl", &["stl", "STL"]),
        ("gltf", &["glb"]),
        ("ref", &["ply"]),
    ];
    let rows: Vec<Row> =
        folders.into_iter().flat_map(|(folder, extensions)| rows(folder, extensions)).collect();
    let look = |row: &Row| {
        let is_small = fs::metadata(&row.path).is_ok_and(|it| it.len() <= most);
        let loaded = read(&row.path, None, &ReadOptions::default()).ok().filter(|_| is_small)?;
        let [part] = &loaded.parts[..] else { return None };
        let faces = part.mesh.faces();
        let are_triangles = (0..faces.len()).all(|face| faces.face(face).len() == 3);
        (!faces.is_empty()).then(|| format!("{}: {:?}", row.name(), blamed(&row.path, are_triangles)))
    };
    let reported: Vec<String> = rows.par_iter().filter_map(look).collect();
    let bad: Vec<&String> = reported.iter().filter(|line| !line.ends_with("[]")).collect();
    assert!(bad.is_empty(), "{bad:#?}");
    assert!(rows.is_empty() || reported.len() > 40, "{}", reported.len());
}
