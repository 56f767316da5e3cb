//! One mesh of single precision with slivers, printed with many and few digits: its normals are the same.

use super::{Random, mesh_of};
use crease::io::{self, Format, ReadOptions};
use crease::mesh::{Faces, Mesh, MeshBuilder, PrintedDigits};
use crease::normals::{FaultReason, Faults, NormalRecipe, Precision, compute};
use std::f64::consts::TAU;
use std::fmt::Write as _;

type Spell<'a> = &'a dyn Fn(f32) -> String;

/// Rows and columns of the torus.
const SIZE: [usize; 2] = [48, 24];

/// A jittered torus of single precision, and how many slivers it has. One diagonal in three has a vertex on it, which makes
/// a sliver of the triangle on its other side.
fn torus(scale: f64) -> (Vec<[f32; 3]>, Vec<[u32; 3]>, usize) {
    let mut random = Random(5);
    let [rows, columns] = SIZE;
    let mut points = Vec::new();
    for i in 0..rows * columns {
        let [u, v] = [(i / columns, rows), (i % columns, columns)]
            .map(|(at, count)| TAU * (at as f64 + 0.3 * random.unit()) / count as f64);
        let radius = 1.0 + 0.4 * libm::cos(v);
        points.push(
            [radius * libm::cos(u), radius * libm::sin(u), 0.4 * libm::sin(v)].map(|x| (scale * x) as f32),
        );
    }
    let vertex = |i: usize, j: usize| ((i % rows) * columns + j % columns) as u32;
    let (mut triangles, mut slivers) = (Vec::new(), 0);
    for cell in 0..rows * columns {
        let (i, j) = (cell / columns, cell % columns);
        let [a, b, c, d] = [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)];
        if !random.one_in(3) {
            triangles.extend([[a, b, c], [a, c, d]]);
            continue;
        }
        let (share, middle) = (0.3 + 0.4 * random.unit(), points.len() as u32);
        let [start, end] = [a, c].map(|end| points[end as usize].map(f64::from));
        points.push([0, 1, 2].map(|k| (start[k] + share * (end[k] - start[k])) as f32));
        triangles.extend([[a, b, middle], [middle, b, c], [a, middle, c], [a, c, d]]);
        slivers += 1;
    }
    (points, triangles, slivers)
}

fn from_single(points: &[[f32; 3]], triangles: &[[u32; 3]]) -> Mesh {
    let faces = Faces::triangles(triangles.as_flattened().to_vec());
    MeshBuilder { positions: points.to_vec().into(), faces, ..MeshBuilder::default() }.build().unwrap()
}

fn as_obj(points: &[[f32; 3]], triangles: &[[u32; 3]], spell: Spell) -> Mesh {
    let mut text = String::new();
    for point in points {
        let _ = writeln!(text, "v {}", point.map(spell).join(" "));
    }
    for triangle in triangles {
        let _ = writeln!(text, "f {}", triangle.map(|vertex| (vertex + 1).to_string()).join(" "));
    }
    mesh_of(text.as_bytes())
}

fn as_ply(points: &[[f32; 3]], triangles: &[[u32; 3]], spell: Spell) -> Mesh {
    let mut text = format!(
        "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n\
         element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        points.len(),
        triangles.len()
    );
    for point in points {
        let _ = writeln!(text, "{}", point.map(spell).join(" "));
    }
    for triangle in triangles {
        let _ = writeln!(text, "3 {}", triangle.map(|vertex| vertex.to_string()).join(" "));
    }
    let loaded = io::read_bytes(text.into_bytes(), Some(Format::Ply), None, &ReadOptions::default());
    loaded.unwrap().parts.remove(0).mesh
}

/// The largest angle in degrees between the normals of two meshes of the same corners, by the default recipe.
fn largest_difference(a: &Mesh, b: &Mesh, precision: Precision) -> f64 {
    let [a, b] =
        [a, b].map(|mesh| (mesh, compute(mesh, &NormalRecipe { precision, ..NormalRecipe::default() })));
    let normal = |(mesh, field): &(&Mesh, crease::normals::NormalField), corner: usize| {
        *field.normals.get(corner, mesh.faces().corners()[corner]).unwrap()
    };
    let angle = |corner: usize| {
        let (a, b) = (normal(&a, corner), normal(&b, corner));
        libm::atan2(a.cross(b).length(), a.dot(b)).to_degrees()
    };
    (0..a.0.faces().corner_count()).map(angle).fold(0.0, f64::max)
}

/// As of `%.9f` to `%.4f`, `%.6e` and, where it writes no exponent, `%.6g`.
fn fixed(decimals: usize) -> impl Fn(f32) -> String {
    move |x| format!("{x:.decimals$}")
}

fn general(x: f32) -> String {
    format!("{x:.5e}")
}

/// Printing moves a corner by at most δ = √3/2 steps, and so rotates a face of the height h by at most 2δ/h. Its corner angles
/// change by at most 4δ over an edge of the length h or more each, of which the normals of its fan, within the crease angle,
/// keep less than one half. The sum of a fan, which spans less than a half-space, shrinks by less than two.
fn bound(step: f64, height: f64) -> f64 {
    (2.0 * (2.0 + 4.0 * 0.5) * 0.5 * 3.0_f64.sqrt() * step / height).to_degrees()
}

/// The least height of a face that is no sliver.
fn least_height(mesh: &Mesh) -> f64 {
    let height = |face: &[u32]| {
        let [a, b, c] = [0, 1, 2].map(|corner| mesh.positions().at(face[corner]));
        (b - a).cross(c - a).length()
            / [b - a, c - a, c - b].map(|edge| edge.length()).into_iter().fold(0.0, f64::max)
    };
    let heights: Vec<f64> = mesh.faces().iter().map(height).collect();
    let largest = heights.iter().copied().fold(0.0, f64::max);
    heights.into_iter().filter(|&height| height > 1e-3 * largest).fold(f64::INFINITY, f64::min)
}

#[test]
fn normals_agree_in_all_formats_as_far_as_printing_allows() {
    let (points, triangles, slivers) = torus(1.0);
    assert!(slivers > 300);
    let exact = from_single(&points, &triangles);
    let counted = |mesh: &Mesh| {
        let faults = compute(mesh, &NormalRecipe::default()).faults;
        Faults::count(&faults.faces, FaultReason::BelowStorage)
            + Faults::count(&faults.faces, FaultReason::ZeroArea)
    };
    assert_eq!(counted(&exact), slivers);
    let height = least_height(&exact);
    let spellings: [(&str, Spell, f64); 7] = [
        ("shortest", &|x| x.to_string(), 0.0),
        ("%.9g", &|x| format!("{x:.8e}"), 0.0),
        ("%.8f", &fixed(8), 0.5e-8),
        ("%.7f", &fixed(7), 1e-7),
        ("%.6f", &fixed(6), 1e-6),
        ("%.4f", &fixed(4), 1e-4),
        ("%.6g", &general, 1e-5),
    ];
    for (name, spell, step) in spellings {
        for mesh in [as_obj(&points, &triangles, spell), as_ply(&points, &triangles, spell)] {
            assert_eq!(counted(&mesh), slivers, "{name}");
            for precision in [Precision::Faithful, Precision::Fast] {
                let (found, bound) = (largest_difference(&exact, &mesh, precision), bound(step, height));
                // Both precisions add 2e-5 degrees.
                assert!(found <= bound + 4e-5, "{name}: {found} of {bound}");
            }
        }
    }
}

/// Small meshes are no exception: what counts is the step compared with the faces.
#[test]
fn slivers_of_small_meshes_are_found_too() {
    let (points, triangles, slivers) = torus(0.01);
    let mesh = as_obj(&points, &triangles, &fixed(6));
    assert_eq!(mesh.printed_digits(), Some(PrintedDigits::Decimals(6)));
    let exact = from_single(&points, &triangles);
    let found = largest_difference(&exact, &mesh, Precision::Faithful);
    assert!(slivers > 300 && found <= bound(1e-6, least_height(&exact)), "{found}");
}

/// Where rounding is everywhere no face is singled out, and few decimals may be exact.
#[test]
fn steps_as_large_as_faces_and_few_decimals_make_no_slivers() {
    let (points, triangles, _) = torus(1e-4);
    assert_eq!(as_obj(&points, &triangles, &fixed(6)).printed_digits(), None);
    let (points, triangles, _) = torus(100.0);
    for decimals in 0..4 {
        assert_eq!(as_obj(&points, &triangles, &fixed(decimals)).printed_digits(), None, "{decimals}");
    }
    // A sheet 1 unit thick, in whole numbers.
    let corner = |i: u32| [(i & 1) as f32 * 20_000.0, (i >> 1 & 1) as f32 * 30_000.0, (i >> 2) as f32];
    let sheet: Vec<[f32; 3]> = (0..8).map(corner).collect();
    let sides = [[0, 1, 5], [0, 5, 4], [2, 0, 4], [2, 4, 6], [0, 2, 1], [1, 2, 3], [4, 5, 6], [5, 7, 6]];
    let mesh = as_obj(&sheet, &sides, &|x| format!("{x:.0}"));
    assert!(compute(&mesh, &NormalRecipe::default()).faults.faces.is_empty());
}
