//! Every surface in every pattern: closed where it shall be, facing outward, and converging to the surface.

use crate::mesh::{Link, Topology};
use crate::surface::meshing::gridless::delaunay;
use crate::surface::meshing::pattern::{Pattern, Tessellation};
use crate::surface::meshing::tessellation::*;
use crate::surface::shapes::height::Plane;
use crate::surface::shapes::revolution::{Catenoid, Cone, Cylinder, Torus};
use crate::surface::shapes::star::Sphere;
use crate::surface::tests::all;
use glam::{DVec2, DVec3};
use std::collections::BTreeMap;
use std::f64::consts::PI;

const PATTERNS: [Pattern; 8] = [
    Pattern::Triangles,
    Pattern::Stretched(10.0),
    Pattern::Slivers(1e3),
    Pattern::Quads,
    Pattern::Polygons,
    Pattern::Icosphere(3),
    Pattern::Marching,
    Pattern::Scattered,
];

fn normals(mesh: &Mesh) -> &[DVec3] {
    &mesh.columns().normals.as_ref().unwrap().values
}

/// Twice the vector area of a face, relative to its first corner.
fn vector_area(mesh: &Mesh, face: &[u32]) -> DVec3 {
    let place = |k: usize| mesh.positions().at(face[k]) - mesh.positions().at(face[0]);
    (1..face.len() - 1).map(|k| place(k).cross(place(k + 1))).sum()
}

fn area(mesh: &Mesh) -> f64 {
    mesh.faces().iter().map(|face| vector_area(mesh, face).length() / 2.0).sum()
}

/// Vertices − edges + faces, and how many edges are on an open side. Every other edge has to have one face on each side.
fn euler(mesh: &Mesh) -> (i64, usize) {
    let topology = Topology::by_index(mesh.faces(), mesh.vertex_count());
    let (mut twins, mut open) = (0, 0);
    for half_edge in 0..mesh.faces().corner_count() as u32 {
        match topology.link(half_edge) {
            Link::Twin(_) => twins += 1,
            Link::Boundary => open += 1,
            other => panic!("half-edge {half_edge}: {other:?}"),
        }
    }
    (mesh.vertex_count() as i64 - (twins / 2 + open) as i64 + mesh.face_count() as i64, open)
}

/// Euler number, and whether there is an open side.
fn shape(name: &str) -> (i64, bool) {
    match name {
        "sphere" | "ellipsoid" | "box" | "octahedron" => (2, false),
        "torus" => (0, false),
        "cylinder" | "catenoid" => (0, true),
        // A pot and a lid like cups, a handle and a spout like tubes.
        "teapot" => (2, true),
        _ => (1, true),
    }
}

#[test]
fn every_pattern_is_a_surface_of_the_right_kind_that_faces_outward() {
    let mut made = 0;
    for (name, surface) in all() {
        for (pattern, jitter) in PATTERNS.into_iter().flat_map(|pattern| [(pattern, 0.0), (pattern, 0.5)]) {
            // Long cells that are moved much bend by more than they are wide, and fold, unless there are many.
            // The teapot's rim is a narrow patch already.
            let jitter = match pattern {
                Pattern::Stretched(_) if name == "teapot" => 0.0,
                Pattern::Stretched(_) => jitter / 2.0,
                _ => jitter,
            };
            let segments = match pattern {
                _ if name == "teapot" => [8, 8],
                Pattern::Stretched(_) => [192, 96],
                _ => [48, 24],
            };
            let tessellation = Tessellation { pattern, segments, jitter, ..Tessellation::default() };
            let mesh = match surface.tessellate(&tessellation) {
                Ok(mesh) => mesh,
                Err(SurfaceError::Pattern(_)) => continue,
                Err(error) => panic!("{name} {pattern:?}: {error}"),
            };
            made += 1;
            let case = format!("{name} {pattern:?} {jitter}");
            let (number, open) = euler(&mesh);
            assert_eq!((number, open > 0), shape(name), "{case}");
            let used: std::collections::BTreeSet<u32> = mesh.faces().corners().iter().copied().collect();
            assert_eq!(used.len(), mesh.vertex_count(), "{case}: unused vertices");
            for face in mesh.faces().iter() {
                let area = vector_area(&mesh, face);
                // Slivers between scattered points may be steeper than the surface, but not turned over.
                let normal = match pattern {
                    Pattern::Scattered => DVec3::Z,
                    _ => face.iter().map(|&v| normals(&mesh)[v as usize]).sum(),
                };
                assert!(area.dot(normal) > 0.0, "{case}: face {face:?} of area {area}");
            }
        }
    }
    // Thirteen surfaces in four patterns with and without jitter, and in slivers; four stretched spheres, eleven zero
    // sets, three heights.
    assert_eq!(made, 13 * (4 * 2 + 1) + 4 + 11 + 3);
}

/// An inscribed mesh loses area to second order.
#[test]
fn areas_converge_to_closed_forms() {
    let (radius, height, waist, tall) = (0.5, 3.0, 0.5, 1.5);
    let cases: [(Surface, f64); 6] = [
        (Plane::new(2.0, 3.0).unwrap().into(), 6.0),
        (Sphere::new(2.0).unwrap().into(), 16.0 * PI),
        (Cylinder::new(radius, height).unwrap().into(), 2.0 * PI * radius * height),
        (Cone::new(1.0, 2.0).unwrap().into(), PI * 5f64.sqrt()),
        (Torus::new(1.0, 0.4).unwrap().into(), 4.0 * PI * PI * 0.4),
        (
            Surface::Catenoid(Catenoid::new(waist, tall).unwrap()),
            PI * waist * (tall + waist * libm::sinh(tall / waist)),
        ),
    ];
    for (surface, truth) in cases {
        for pattern in PATTERNS {
            if matches!(pattern, Pattern::Polygons) {
                // Vector areas of polygons that are not plane, and none at open sides: no inscribed mesh.
                continue;
            }
            let error = |level: u32| {
                let pattern =
                    if let Pattern::Icosphere(_) = pattern { Pattern::Icosphere(level) } else { pattern };
                let segments = [16 << level, 8 << level];
                let mesh = surface
                    .tessellate(&Tessellation { pattern, segments, ..Tessellation::default() })
                    .ok()?;
                Some((area(&mesh) - truth).abs() / truth)
            };
            let (Some(coarse), Some(fine)) = (error(1), error(3)) else { continue };
            if coarse < 1e-12 {
                assert!(matches!(surface, Surface::Primitive(crate::surface::Primitive::Plane(_))));
                continue;
            }
            let order = libm::log2(coarse / fine) / 2.0;
            // A lattice meets surface and tip differently at each resolution.
            let slack = if pattern == Pattern::Marching { 0.3 } else { 0.06 };
            assert!(
                (order - 2.0).abs() < slack,
                "{surface:?} {pattern:?}: order {order} from {coarse:e}, {fine:e}"
            );
        }
    }
}

#[test]
fn patches_share_vertices_and_normals_along_their_sides() {
    for (pattern, jitter) in
        [(Pattern::Triangles, 0.5), (Pattern::Slivers(100.0), 0.0), (Pattern::Stretched(3.0), 0.5)]
    {
        let spec = Tessellation { pattern, segments: [7, 5], jitter, ..Tessellation::default() };
        let apart = grid::net(&Surface::Teapot.charts(), &spec).unwrap();
        let mut joined = grid::net(&Surface::Teapot.charts(), &spec).unwrap();
        grid::join(&mut joined, Surface::Teapot.patches(), &spec);
        assert!(joined.samples.len() < apart.samples.len());
        for (&a, &b) in apart.faces.corners().iter().zip(joined.faces.corners()) {
            let (own, shared) = (apart.samples[a as usize], joined.samples[b as usize]);
            // Both evaluate the same curve, perhaps from its other end: a few roundings of numbers up to 3.5.
            assert!((own.position - shared.position).length() < 4e-15, "{own:?} {shared:?}");
            assert!((own.normal.get() - shared.normal.get()).length() < 2e-14, "{own:?} {shared:?}");
        }
    }
}

#[test]
fn noise_leaves_the_surface_by_no_more_than_asked_and_keeps_normals() {
    let plain = Tessellation { jitter: 0.5, ..Tessellation::default() };
    let surface = Surface::from(Torus::default());
    let (smooth, rough) = (
        surface.tessellate(&plain).unwrap(),
        surface.tessellate(&Tessellation { noise: 0.1, ..plain }).unwrap(),
    );
    assert_eq!(normals(&smooth), normals(&rough));
    let (mut furthest, mut sum) = (0.0_f64, 0.0);
    for ((p, q), n) in smooth.positions().iter().zip(rough.positions().iter()).zip(normals(&smooth)) {
        let lift = (q - p).dot(*n);
        assert!((p + *n * lift - q).length() < 1e-15);
        furthest = furthest.max(lift.abs());
        sum += lift;
    }
    // Mean edge of a grid of 64 × 32 over the torus with diagonals: 0.10 or so.
    assert!((0.008..0.012).contains(&furthest), "{furthest}");
    assert!((sum / smooth.vertex_count() as f64).abs() < 0.0005, "{sum}");
}

#[test]
fn texture_coordinates_are_the_parameters() {
    let spec = Tessellation { uvs: true, segments: [8, 6], ..Tessellation::default() };
    let surface = Surface::from(Sphere::default());
    let mesh = surface.tessellate(&spec).unwrap();
    let uvs = mesh.columns().uvs.as_ref().unwrap();
    let chart = surface.charts()[0];
    for (corner, &vertex) in mesh.faces().corners().iter().enumerate() {
        let uv = *uvs.get(corner, vertex).unwrap();
        assert!(uv.cmpge(DVec2::ZERO).all() && uv.cmple(DVec2::ONE).all());
        let position = chart.at(uv.x, uv.y).unwrap().position;
        assert!((position - mesh.positions().at(vertex)).length() < 1e-15);
    }
    // No face reaches round the back of the texture.
    for range in mesh.faces().ranges() {
        let us: Vec<f64> = range.map(|corner| uvs.values[corner].x).collect();
        let spread = us.iter().copied().fold(0.0, f64::max) - us.iter().copied().fold(1.0, f64::min);
        assert!(spread <= 1.0 / 8.0 + 1e-15);
    }
    assert!(surface.tessellate(&Tessellation { uvs: false, ..spec }).unwrap().columns().uvs.is_none());
}

#[test]
fn counts_and_seeds() {
    let mesh = |spec: Tessellation| Surface::from(Sphere::default()).tessellate(&spec).unwrap();
    let count = |mesh: &Mesh| (mesh.vertex_count(), mesh.face_count());
    let icosphere = Tessellation { pattern: Pattern::Icosphere(3), ..Tessellation::default() };
    assert_eq!(count(&mesh(icosphere)), (642, 1280));
    let grid = Tessellation { segments: [8, 6], jitter: 0.5, ..Tessellation::default() };
    assert_eq!(count(&mesh(grid)), (2 + 8 * 5, 8 * (2 + 2 * 4)));
    assert_eq!(mesh(grid), mesh(grid));
    assert_ne!(mesh(grid), mesh(Tessellation { seed: 1, ..grid }));
    // The dual has a vertex for each triangle and a polygon for each vertex.
    let dual = mesh(Tessellation { pattern: Pattern::Polygons, ..grid });
    assert_eq!(count(&dual), (8 * (2 + 2 * 4), 2 + 8 * 5));
    assert_eq!(dual.faces().max_arity(), 8, "round the poles");
    let stretched = Tessellation { pattern: Pattern::Stretched(10.0), ..Tessellation::default() };
    let torus = Surface::from(Torus::default()).tessellate(&stretched).unwrap();
    assert_eq!(torus.vertex_count(), 20 * 101);
    let teapot = Tessellation { segments: [4, 4], ..Tessellation::default() };
    let teapot = Surface::Teapot.tessellate(&teapot).unwrap();
    assert_eq!(teapot.face_count(), 32 * 2 * 16 - 8 * 4);
}

#[test]
fn impossible_settings_are_refused_with_their_reason() {
    let refuse = |surface: &Surface, spec: Tessellation| surface.tessellate(&spec).unwrap_err();
    let (sphere, plane) = (Surface::from(Sphere::default()), Surface::from(Plane::default()));
    let plain = Tessellation::default();
    for segments in [[2, 8], [8, 1], [u32::MAX, u32::MAX], [0, 0]] {
        let error = refuse(&sphere, Tessellation { segments, ..plain });
        assert!(matches!(error, SurfaceError::Segments(_)), "{error}");
        for pattern in [Pattern::Marching, Pattern::Scattered] {
            if segments[0] == 0 || segments[0] == u32::MAX {
                let error = refuse(&plane, Tessellation { segments, pattern, ..plain });
                assert!(matches!(error, SurfaceError::Segments(_)), "{error}");
            }
        }
    }
    for bad in [-0.1, 1.1, f64::NAN] {
        for spec in [Tessellation { jitter: bad, ..plain }, Tessellation { noise: bad, ..plain }] {
            assert!(matches!(refuse(&sphere, spec), SurfaceError::OutOfRange(_)));
        }
    }
    for pattern in [Pattern::Stretched(f64::NAN), Pattern::Slivers(0.5)] {
        assert!(matches!(refuse(&sphere, Tessellation { pattern, ..plain }), SurfaceError::OutOfRange(_)));
    }
    let error = refuse(&sphere, Tessellation { pattern: Pattern::Icosphere(11), ..plain });
    assert_eq!(error.to_string(), "11 levels of division; at most 10 expected");
    for (surface, pattern) in [
        (&Surface::Teapot, Pattern::Marching),
        (&plane, Pattern::Icosphere(1)),
        (&sphere, Pattern::Scattered),
    ] {
        assert!(matches!(refuse(surface, Tessellation { pattern, ..plain }), SurfaceError::Pattern(_)));
    }
    let spec = Tessellation { pattern: Pattern::Marching, jitter: 0.5, ..plain };
    assert_eq!(refuse(&sphere, spec).to_string(), "marching is not possible here: it takes no jitter");
}

#[test]
fn scattered_points_make_a_delaunay_triangulation() {
    let hash = GridHash::default();
    for scale in [1.0, 1e-200, 1e200] {
        let place = |i| DVec2::new(hash.at(i, 0, 1), hash.at(i, 0, 2)) * scale;
        let points: Vec<DVec2> = (0..300).map(place).collect();
        let triangles = delaunay(&points).unwrap();
        let mut faces_of_edge = BTreeMap::new();
        for [a, b, c] in &triangles {
            for [from, to] in [[a, b], [b, c], [c, a]] {
                *faces_of_edge.entry([from.min(to), from.max(to)]).or_insert(0) += 1;
            }
        }
        assert!(faces_of_edge.values().all(|faces| [1, 2].contains(faces)));
        let hull = faces_of_edge.values().filter(|&&faces| faces == 1).count();
        let euler = 300 + triangles.len() - faces_of_edge.len();
        assert_eq!((euler, triangles.len()), (1, 2 * 300 - 2 - hull));
        for face in triangles {
            let [a, b, c] = face.map(|k| points[k as usize] / scale);
            assert!((b - a).perp_dot(c - a) > 0.0);
            // No other point within the circle through the corners, but for the rounding of a determinant of fourth
            // powers.
            for p in points.iter().map(|&p| p / scale) {
                let [a, b, c] = [a - p, b - p, c - p];
                let inside = a.length_squared() * b.perp_dot(c)
                    + b.length_squared() * c.perp_dot(a)
                    + c.length_squared() * a.perp_dot(b);
                assert!(inside < 1e-13, "{inside:e}");
            }
        }
    }
    let fails = |points: &[[f64; 2]]| {
        let points: Vec<DVec2> = points.iter().map(|&p| p.into()).collect();
        delaunay(&points).unwrap_err().to_string()
    };
    assert!(fails(&[[0.0; 2], [1.0, 0.0], [0.0, 1.0], [1.0, -0.0]]).starts_with("point 3: another"));
    for flat in [&[][..], &[[0.0; 2]], &[[0.0; 2], [1.0, 1.0], [2.0, 2.0]]] {
        assert!(fails(flat).contains("no three points"));
    }
}
