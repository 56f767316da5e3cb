//! Any bits as positions and indices, through every public function of `normals`: all normals are finite and unit, and both ways
//! to the kernels, by slices and by a mesh, have the same bits.
//!
//! The first byte chooses the type of coordinates, the second the number of vertices; three coordinates a vertex follow, and then
//! a byte for each index.
#![no_main]

use crease::mesh::{Faces, Mesh, MeshBuilder, Positions, Topology, Weld};
use crease::normals::encoding::{Encoding, Octahedral, from_half, to_half};
use crease::normals::{
    Averaging, Coordinate, Crease, Extras, NormalField, NormalRecipe, Precision, Scope, Scratch, Slivers,
    Weight, When, compute, compute_observed, compute_on, compute_wider, compute_with, corner_normals,
    crease_slack, face_normals, select, vertex_normals,
};
use crease::num::Degrees;
use crease_fuzz::{Choices, start};
use glam::DVec3;
use libfuzzer_sys::fuzz_target;

fn is_unit(normal: [f64; 3]) -> bool {
    (DVec3::from_array(normal).length() - 1.0).abs() < 1e-6
}

/// The slice functions with all weights and precisions.
fn by_slices<T: Coordinate + Copy + Into<f64> + Default + PartialEq + std::fmt::Debug>(
    positions: &[[T; 3]],
    triangles: &[[u32; 3]],
    crease: Degrees,
) {
    let mut scratch = Scratch::new();
    let zero = [T::default(); 3];
    let are_unit = |normals: &[[T; 3]]| normals.iter().all(|normal| is_unit(normal.map(Into::into)));
    let mut of_faces = vec![zero; triangles.len()];
    let faces = face_normals(positions, triangles, &mut scratch, &mut of_faces);
    assert!(faces.is_err() || are_unit(&of_faces), "{of_faces:?}");
    for weight in Weight::ALL {
        for slivers in [Slivers::Exclude, Slivers::Keep] {
            for precision in [Precision::Faithful, Precision::Fast] {
                let averaging = Averaging { weight, slivers, precision };
                let mut of_vertices = vec![zero; positions.len()];
                let found = vertex_normals(positions, triangles, averaging, &mut scratch, &mut of_vertices);
                assert_eq!(found.is_ok(), faces.is_ok() && !weight.is_fit(), "{averaging:?}");
                assert!(found.is_err() || are_unit(&of_vertices), "{averaging:?}: {of_vertices:?}");
                let (mut normals, mut index) = (Vec::new(), vec![0; 3 * triangles.len()]);
                let found = corner_normals(
                    positions,
                    triangles,
                    averaging,
                    crease,
                    &mut scratch,
                    &mut normals,
                    &mut index,
                );
                assert_eq!(found.is_ok(), faces.is_ok() && !weight.is_fit(), "{averaging:?}");
                assert!(found.is_err() || are_unit(&normals), "{averaging:?}: {normals:?}");
                assert!(found.is_err() || index.iter().all(|&slot| (slot as usize) < normals.len()));
            }
        }
    }
}

/// The functions for meshes, and whether slices give the same normals of vertices.
fn by_mesh<T: Coordinate + Copy + Into<f64> + Default>(
    positions: &[[T; 3]],
    triangles: &[[u32; 3]],
    mesh: &Mesh,
    choices: &mut Choices,
) {
    let recipe = choices.recipe();
    let topology = Topology::build(mesh, recipe.weld);
    let check = |field: &NormalField, what: &str| {
        let normals = &field.normals.values;
        assert!(normals.iter().all(|normal| is_unit(normal.to_array())), "{what}, {recipe:?}: {normals:?}");
    };
    let field = compute(mesh, &recipe);
    check(&field, "compute");
    check(&compute_with(mesh, &recipe, Extras::NONE), "compute_with");
    check(&compute_observed(mesh, &recipe, Extras::ALL, &|_, _| {}), "compute_observed");
    assert_eq!(compute_on(mesh, &topology, &recipe).normals, field.normals, "{recipe:?}");
    check(&compute_wider(mesh, &topology, &recipe), "compute_wider");
    for when in [When::Missing, When::Broken, When::Always] {
        let selection = select(mesh, field.clone(), when);
        assert_eq!(selection.kept, 0, "{when:?}: the mesh has no normals");
        assert!(selection.face_normals.iter().all(|normal| is_unit(normal.to_array())));
    }
    if let Crease::Angle(angle) = recipe.crease {
        assert!(crease_slack(angle).0 <= 0.01);
    }

    let weight = choices.one(&Weight::SUMS);
    let recipe = NormalRecipe {
        weight,
        crease: Crease::Angle(Degrees(180.0)),
        weld: Weld::Off,
        scope: Scope::Vertex,
        ..NormalRecipe::default()
    };
    let field = compute(mesh, &recipe);
    let mut of_vertices = vec![[T::default(); 3]; positions.len()];
    let averaging = Averaging { weight, ..Averaging::default() };
    let faults = vertex_normals(positions, triangles, averaging, &mut Scratch::new(), &mut of_vertices)
        .expect("valid slices");
    // Fallback normals differ: those of a mesh also take from faces across its edges.
    let is_fallback = |vertex| faults.vertices.iter().any(|fault| fault.index == vertex);
    for (corner, &vertex) in
        mesh.faces().corners().iter().enumerate().filter(|(_, vertex)| !is_fallback(**vertex))
    {
        let by_mesh = field.normals.get(corner, vertex).expect("every corner has a normal").as_vec3();
        let by_slice = DVec3::from_array(of_vertices[vertex as usize].map(Into::into)).as_vec3();
        assert_eq!(by_mesh, by_slice, "{weight:?}, corner {corner}");
    }
}

/// Any vector in every encoding.
fn encoded(vector: DVec3) {
    for encoding in Encoding::ALL {
        let code = encoding.encode(vector);
        assert!(is_unit(encoding.decode(code).to_array()), "{}: {vector:?}", encoding.name());
        let packed = encoding.pack([vector, vector]);
        assert_eq!(encoding.unpack(&packed).len(), 2, "{}", encoding.name());
    }
    let half = from_half(to_half(vector.x));
    assert_eq!(to_half(half), to_half(vector.x));
    let octahedral = Octahedral::new(vector.x.to_bits() as u32 % 40);
    assert!(octahedral.is_none_or(|it| is_unit(it.decode([vector.y as i32, vector.z as i32]).to_array())));
}

fn check<T: Coordinate + Copy + Into<f64> + Default + PartialEq + std::fmt::Debug>(
    coordinates: Vec<T>,
    rest: &[u8],
    mesh_positions: impl FnOnce(Vec<[T; 3]>) -> Positions,
    choices: &mut Choices,
) {
    let positions = coordinates.as_chunks().0;
    let (triangles, _) = rest.as_chunks::<3>();
    let triangles: Vec<[u32; 3]> = triangles.iter().map(|corners| corners.map(u32::from)).collect();
    let angles = [0.0, 1e-9, 30.0, 40.0, 180.0, 400.0, -1.0, f64::NAN, f64::INFINITY];
    by_slices(positions, &triangles, Degrees(choices.one(&angles)));
    let builder = MeshBuilder {
        positions: mesh_positions(positions.to_vec()),
        faces: Faces::triangles(triangles.clone().into_flattened()),
        ..MeshBuilder::default()
    };
    // Slices may have positions that are not finite; a mesh has none.
    if let Ok(mesh) = builder.build() {
        by_mesh(positions, &triangles, &mesh, choices);
    }
    if let Some(&vector) = positions.first() {
        encoded(DVec3::from_array(vector.map(Into::into)));
    }
}

fuzz_target!(init: start(), |bytes: &[u8]| {
    let [is_double, vertices, rest @ ..] = bytes else { return };
    let mut choices = Choices::of(bytes);
    let count = 3 * usize::from(vertices % 32);
    if is_double % 2 == 0 {
        let (coordinates, indices) = rest.split_at(rest.len().min(4 * count));
        let coordinates = coordinates.as_chunks().0.iter().map(|&x| f32::from_le_bytes(x)).collect();
        check::<f32>(coordinates, indices, Positions::from, &mut choices);
    } else {
        let (coordinates, indices) = rest.split_at(rest.len().min(8 * count));
        let coordinates = coordinates.as_chunks().0.iter().map(|&x| f64::from_le_bytes(x)).collect();
        let points = |points: Vec<[f64; 3]>| points.into_iter().map(DVec3::from_array).collect();
        check::<f64>(coordinates, indices, points, &mut choices);
    }
});
