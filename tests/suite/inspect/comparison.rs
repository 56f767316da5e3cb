//! Comparison of two files: changes of known size at known corners are found, whatever the order of faces and vertices.

use super::{loaded, rebuilt, surface, with_normals};
use crease::io::Loaded;
use crease::mesh::{Column, FaceEdit, Faces, Mesh, triangulate};
use crease::normals::NormalRecipe;
use crease::quality::{Comparison, Diagnosis, Incomparable, compare, key_light_steps};
use crease::surface::{Pattern, Surface, Tessellation, Torus};
use glam::{DMat3, DVec3};

fn torus() -> Mesh {
    let mesh = surface(&Surface::from(Torus::default()), [24, 12]);
    with_normals(mesh.with_normals(None), &NormalRecipe::default())
}

fn compared(before: &Mesh, after: &Mesh) -> Comparison {
    try_to_compare(before, after).unwrap()
}

fn try_to_compare(before: &Mesh, after: &Mesh) -> Result<Comparison, Incomparable> {
    let files: [Loaded; 2] = [before, after].map(|mesh| loaded(mesh.clone()));
    let nothing = Diagnosis::default();
    compare(files.each_ref(), [&nothing; 2], 10)
}

/// The stored normals corner by corner.
fn of_corners(mesh: &Mesh) -> Vec<DVec3> {
    let stored = mesh.columns().normals.as_ref().unwrap();
    mesh.faces().corners().iter().enumerate().map(|(corner, &v)| *stored.get(corner, v).unwrap()).collect()
}

fn with_corners(mesh: &Mesh, normals: Vec<DVec3>) -> Mesh {
    let index = (0..normals.len() as u32).collect();
    mesh.clone().with_normals(Some(Column::per_corner(normals, index)))
}

/// Every 50th corner normal rotated, by 1°, 2°, 3° and so on; and these corners with their angles.
fn changed(mesh: &Mesh) -> (Mesh, Vec<(u32, f64)>) {
    let mut normals = of_corners(mesh);
    let known: Vec<(u32, f64)> =
        (0..normals.len() as u32).step_by(50).zip(1..).map(|(corner, n)| (corner, f64::from(n))).collect();
    for &(corner, degrees) in &known {
        let normal = &mut normals[corner as usize];
        *normal = DMat3::from_axis_angle(normal.any_orthonormal_vector(), degrees.to_radians()) * *normal;
    }
    (with_corners(mesh, normals), known)
}

/// The same mesh with vertices, faces and the corners of each face in another order.
fn shuffled(mesh: &Mesh) -> Mesh {
    let (vertices, count) = (mesh.vertex_count() as u32, mesh.face_count());
    // Neither number has a factor in common with the counts of the torus.
    let vertex = |v: u32| v * 7 % vertices;
    let order: Vec<usize> = (0..count).map(|face| face * 11 % count).collect();
    let mut positions = vec![DVec3::NAN; vertices as usize];
    for (v, position) in mesh.positions().iter().enumerate() {
        positions[vertex(v as u32) as usize] = position;
    }
    assert!(positions.iter().all(|position| position.is_finite()), "every vertex has a place");
    let normals = of_corners(mesh);
    let (mut faces, mut stored) = (Faces::new(), Vec::new());
    for &face in &order {
        let range = mesh.faces().range(face);
        let corners: Vec<usize> = range.clone().cycle().skip(face % 3).take(range.len()).collect();
        faces.push(&corners.iter().map(|&c| vertex(mesh.faces().corners()[c])).collect::<Vec<_>>());
        stored.extend(corners.iter().map(|&corner| normals[corner]));
    }
    with_corners(&rebuilt(positions, faces), stored)
}

#[test]
fn known_changes_are_measured() {
    let before = torus();
    let (after, known) = changed(&before);
    let largest = known.len() as f64;
    for after in [after.clone(), shuffled(&after)] {
        let found = compared(&before, &after);
        assert_eq!(
            (found.corners, found.unmatched, found.turned),
            (before.faces().corner_count(), [0; 2], 0)
        );
        assert_eq!((found.changed, found.gained, found.lost), (known.len(), 0, 0));
        // The rounding of a rotation, with a margin.
        assert!((found.largest.0 - largest).abs() < 1e-7, "{:?}", found.largest);
        let mean = largest * (largest + 1.0) / 2.0 / found.corners as f64;
        assert!((found.angles.mean - mean).abs() < 1e-7, "{:?}", found.angles);
        let squares = known.iter().map(|&(_, degrees)| degrees * degrees).sum::<f64>();
        let rms = (squares / found.corners as f64).sqrt();
        assert!((found.angles.rms - rms).abs() < 1e-7, "{:?}", found.angles);
        // One corner in fifty changes, by whole degrees: of 100, 98 are unchanged.
        let at = |share: f64| (largest - ((1.0 - share) * found.corners as f64).floor()).max(0.0);
        for (percentile, expected) in found.percentiles().into_iter().zip([0.0, 0.0, at(0.99)]) {
            assert!((percentile.1 - expected).abs() < 1e-7, "{percentile:?} is not {expected}");
        }
        assert!((found.steps()[1] - key_light_steps(largest)).abs() < 1e-6);
        let steps = known.iter().map(|&(_, degrees)| key_light_steps(degrees)).sum::<f64>();
        assert!((found.steps()[0] - steps / found.corners as f64).abs() < 1e-6, "{:?}", found.steps());
        // Half a step is 0.29°, so a degree shows.
        assert_eq!(found.visible, known.len());
        let places: Vec<u32> = found
            .places
            .iter()
            .map(|site| before.faces().range(site.face.unwrap() as usize).start as u32 + site.corner.unwrap())
            .collect();
        let worst: Vec<u32> = known.iter().rev().take(10).map(|&(corner, _)| corner).collect();
        assert_eq!(places, worst);
        assert_eq!(found.change[0].iter().filter(|&&degrees| degrees > 0.0).count(), known.len());
    }
    let same = compared(&before, &shuffled(&before));
    assert_eq!((same.changed, same.largest.0, same.angles.max), (0, 0.0, 0.0));
}

#[test]
fn faces_that_go_round_the_other_way_are_the_same_faces() {
    let before = torus();
    let edit = FaceEdit { reversed: vec![3, 4, 90], dropped: vec![17] };
    let found = compared(&before, &before.with_faces(&edit));
    assert_eq!((found.turned, found.unmatched, found.changed), (3, [1, 0], 0));
}

/// A quad is matched with its two triangles, whichever diagonal cuts it.
#[test]
fn polygons_find_their_triangles() {
    let grid = Tessellation { segments: [24, 12], pattern: Pattern::Quads, ..Tessellation::default() };
    let quads = Surface::from(Torus::default()).tessellate(&grid).unwrap();
    let before = with_normals(quads.with_normals(None), &NormalRecipe::default());
    assert_eq!(before.faces().max_arity(), 4);
    let along = |diagonals: [[[u32; 3]; 2]; 2]| -> Vec<[u32; 3]> {
        let quad = |face: u32| diagonals[face as usize % 2].map(|triangle| triangle.map(|i| 4 * face + i));
        (0..before.face_count() as u32).flat_map(quad).collect()
    };
    let [first, second] = [[[0, 1, 2], [0, 2, 3]], [[3, 0, 1], [1, 2, 3]]];
    let turned = second.map(|[a, b, c]| [a, c, b]);
    for (cut, reversed) in [
        (triangulate(&before).triangles, 0),
        (along([first, first]), 0),
        (along([second, first]), 0),
        (along([turned, first]), before.face_count()),
    ] {
        let after = cut_into(&before, &cut);
        for [one, other] in [[&before, &after], [&after, &before]] {
            let found = compared(one, other);
            assert_eq!((found.unmatched, found.changed, found.turned), ([0; 2], 0, reversed));
            assert_eq!(found.corners, cut.len() * 3);
        }
        // If one triangle is missing, its quad and the other triangle have no counterpart.
        let found = compared(&before, &cut_into(&before, &cut[1..]));
        assert_eq!(found.unmatched[0], 1);
    }
}

/// A mesh of triangles between corners of another, with the normals of these corners.
fn cut_into(mesh: &Mesh, triangles: &[[u32; 3]]) -> Mesh {
    let (normals, corners) = (of_corners(mesh), mesh.faces().corners());
    let faces =
        Faces::triangles(triangles.iter().flatten().map(|&corner| corners[corner as usize]).collect());
    let stored = triangles.iter().flatten().map(|&corner| normals[corner as usize]).collect();
    with_corners(&rebuilt(mesh.positions().to_vec(), faces), stored)
}

#[test]
fn normals_come_and_go() {
    let before = torus();
    let bare = before.clone().with_normals(None);
    let corners = before.faces().corner_count();
    assert_eq!(compared(&bare, &before).gained, corners);
    assert_eq!(compared(&before, &bare).lost, corners);
    let both = compared(&bare, &bare);
    assert_eq!((both.gained, both.lost, both.changed), (0, 0, 0));
}

#[test]
fn shapes_without_a_face_in_common_are_refused() {
    let before = torus();
    let moved = rebuilt(before.positions().iter().map(|p| p + DVec3::X).collect(), before.faces().clone());
    assert_eq!(try_to_compare(&before, &moved), Err(Incomparable::NothingInCommon));
}
