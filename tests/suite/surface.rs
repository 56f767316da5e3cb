//! Surfaces with exact normals: the published errors of vertex normals on their meshes, and the verb that writes them.

mod verb;

use crease::mesh::Mesh;
use crease::normals::{Crease, NormalRecipe, Scope, Weight, compute};
use crease::surface::{Pattern, Sphere, Surface, Tessellation, Torus};
use glam::DVec3;

/// Root mean square and maximum over vertices of the angle between computed and exact normals, in degrees.
fn errors(mesh: &Mesh, weight: Weight) -> (f64, f64) {
    let recipe =
        NormalRecipe { weight, crease: Crease::OFF, scope: Scope::Vertex, ..NormalRecipe::default() };
    let field = compute(mesh, &recipe);
    let exact = &mesh.columns().normals.as_ref().unwrap().values;
    let mut angles = vec![None; mesh.vertex_count()];
    for (corner, &vertex) in mesh.faces().corners().iter().enumerate() {
        let computed = *field.normals.get(corner, vertex).unwrap();
        angles[vertex as usize] = Some(angle(computed, exact[vertex as usize]).to_degrees());
    }
    let angles: Vec<f64> = angles.into_iter().flatten().collect();
    assert_eq!(angles.len(), mesh.vertex_count());
    let squares: f64 = angles.iter().map(|angle| angle * angle).sum();
    ((squares / angles.len() as f64).sqrt(), angles.iter().copied().fold(0.0, f64::max))
}

fn angle(a: DVec3, b: DVec3) -> f64 {
    libm::atan2(a.cross(b).length(), a.dot(b))
}

#[test]
fn icospheres_have_the_published_errors() {
    let sphere = Surface::from(Sphere::default());
    let mesh = |level| {
        let tessellation = Tessellation { pattern: Pattern::Icosphere(level), ..Tessellation::default() };
        sphere.tessellate(&tessellation).unwrap()
    };
    let (level_2, level_3) = (mesh(2), mesh(3));
    let table = [
        (&level_3, Weight::Uniform, 0.292900, 0.473844),
        (&level_3, Weight::Area, 0.422980, 0.676912),
        (&level_3, Weight::Angle, 0.166633, 0.298514),
        (&level_3, Weight::Edge, 0.108986, 0.242017),
        (&level_2, Weight::Uniform, 0.651007, 0.759910),
        (&level_2, Weight::Area, 0.943064, 1.354141),
        (&level_2, Weight::Angle, 0.369381, 0.595582),
    ];
    for (mesh, weight, rms, max) in table {
        let found = errors(mesh, weight);
        // Six decimals are printed.
        assert!((found.0 - rms).abs() < 5e-7 && (found.1 - max).abs() < 5e-7, "{weight:?}: {found:?}");
    }
    for level in 0..=3 {
        // Max's weights are exact on any mesh inscribed in a sphere.
        assert!(errors(&mesh(level), Weight::Max).1 < 1e-13, "level {level}");
    }
    // At level 1 all are, by symmetry.
    for weight in [Weight::Uniform, Weight::Area, Weight::Angle, Weight::Edge] {
        assert!(errors(&mesh(1), weight).1 < 1e-13, "{weight:?}");
    }
}

#[test]
fn the_jittered_torus_has_the_published_errors() {
    let torus = Surface::from(Torus::default());
    let mesh = |segments| {
        let tessellation = Tessellation { segments, jitter: 0.5, ..Tessellation::default() };
        torus.tessellate(&tessellation).unwrap()
    };
    let coarse = mesh([64, 32]);
    for (weight, rms, max) in [(Weight::Uniform, 1.644, 4.677), (Weight::Max, 0.498, 2.054)] {
        let found = errors(&coarse, weight);
        // Three decimals are printed.
        assert!((found.0 - rms).abs() < 5e-4 && (found.1 - max).abs() < 5e-4, "{weight:?}: {found:?}");
    }
    // Order 1.00 over three halvings.
    let levels =
        [[64, 32], [128, 64], [256, 128], [512, 256]].map(|segments| errors(&mesh(segments), Weight::Max).0);
    let order = libm::log2(levels[0] / levels[3]) / 3.0;
    assert!((order - 1.0).abs() < 0.05, "{order} from {levels:?}");
}
