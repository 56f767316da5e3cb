use super::*;
use crate::mesh::{Faces, MeshBuilder};
use glam::{DMat3, DVec2};

fn polygon(points: Vec<DVec3>) -> Mesh {
    let mut faces = Faces::new();
    faces.push(&(0..points.len() as u32).collect::<Vec<_>>());
    MeshBuilder { positions: points.into(), faces, ..Default::default() }.build().unwrap()
}

fn flat(points: &[[f64; 2]]) -> Vec<DVec3> {
    points.iter().map(|&[x, y]| DVec3::new(x, y, 0.0)).collect()
}

/// Twice the vector area about the first point.
fn doubled_area(points: &[DVec3]) -> DVec3 {
    points[1..].windows(2).map(|pair| (pair[0] - points[0]).cross(pair[1] - points[0])).sum()
}

/// The properties of a right triangulation, for a planar polygon: n − 2 triangles, every corner used, none turned
/// over, the areas add up, each edge of the polygon in one triangle and each diagonal in two, both ways.
fn check(name: &str, points: &[DVec3]) -> Triangulation {
    let mesh = polygon(points.to_vec());
    let out = triangulate(&mesh);
    assert_eq!(out.failed, [] as [u32; 0], "{name}");
    assert_eq!(out.triangles.len(), points.len() - 2, "{name}");
    assert_eq!(out.source_face, vec![0; points.len() - 2], "{name}");
    let total = doubled_area(points);
    let axis = total.normalize();
    let mut sum = 0.0;
    let mut edges = std::collections::BTreeMap::<(u32, u32), i32>::new();
    for triangle in &out.triangles {
        let [a, b, c] = triangle.map(|corner| points[corner as usize]);
        let area = (b - a).cross(c - a).dot(axis);
        // Rounding of the projection may leave a corner of a straight edge a few ulps inside.
        assert!(area >= -1e-13 * total.length(), "{name}: {triangle:?} has area {area}");
        sum += area;
        for k in 0..3 {
            *edges.entry((triangle[k], triangle[(k + 1) % 3])).or_default() += 1;
        }
    }
    assert!((sum - total.length()).abs() <= 1e-12 * total.length(), "{name}: {sum} of {}", total.length());
    let n = points.len() as u32;
    for (&(a, b), &times) in &edges {
        assert_eq!(times, 1, "{name}: edge {a}-{b} runs one way twice");
        let boundary = (a + 1) % n == b;
        assert_eq!(edges.contains_key(&(b, a)), !boundary, "{name}: edge {a}-{b}");
    }
    for corner in 0..n {
        assert!(edges.contains_key(&(corner, (corner + 1) % n)), "{name}: edge of corner {corner}");
    }
    out
}

fn star(tips: usize, inner: f64) -> Vec<DVec3> {
    (0..2 * tips)
        .map(|k| {
            let (sin, cos) = libm::sincos(std::f64::consts::PI * k as f64 / tips as f64);
            let radius = if k % 2 == 0 { 1.0 } else { inner };
            DVec3::new(radius * cos, radius * sin, 0.0)
        })
        .collect()
}

/// A band that winds inwards, out along one side and back along the other.
fn spiral(steps: usize) -> Vec<DVec3> {
    let arm = |width: f64| {
        (0..steps).map(move |k| {
            let turn = 12.0 * k as f64 / steps as f64;
            let (sin, cos) = libm::sincos(turn);
            let radius = 1.0 + turn + width;
            DVec3::new(radius * cos, radius * sin, 0.0)
        })
    };
    arm(2.0).chain(arm(0.0).collect::<Vec<_>>().into_iter().rev()).collect()
}

fn shapes() -> Vec<(&'static str, Vec<DVec3>)> {
    let l = flat(&[[0., 0.], [2., 0.], [2., 1.], [1., 1.], [1., 2.], [0., 2.]]);
    let u = flat(&[[0., 0.], [3., 0.], [3., 3.], [2., 3.], [2., 1.], [1., 1.], [1., 3.], [0., 3.]]);
    let plus = [
        [1., 0.],
        [2., 0.],
        [2., 1.],
        [3., 1.],
        [3., 2.],
        [2., 2.],
        [2., 3.],
        [1., 3.],
        [1., 2.],
        [0., 2.],
        [0., 1.],
        [1., 1.],
    ];
    let straight = flat(&[[0., 0.], [1., 0.], [2., 0.], [3., 0.], [3., 2.], [1.5, 2.], [0., 2.], [0., 1.]]);
    let triangle =
        flat(&[[0., 0.], [1., 0.], [2., 0.], [3., 0.], [2., 1.], [1., 2.], [0., 3.], [0., 2.], [0., 1.]]);
    vec![
        ("L", l),
        ("U", u),
        ("plus", flat(&plus)),
        ("star 4", star(4, 0.3)),
        ("star 6", star(6, 0.5)),
        ("star 50", star(50, 0.01)),
        ("pentagon", star(5, 0.81)),
        ("spiral", spiral(60)),
        ("corners on straight edges", straight),
        ("a triangle of nine corners", triangle),
        ("concave quad", flat(&[[0., 0.], [2., 0.], [0.5, 0.5], [0., 2.]])),
        ("quad with a corner on a straight edge", flat(&[[0., 0.], [1., 0.], [2., 0.], [1., 3.]])),
    ]
}

#[test]
fn polygons_of_all_shapes_are_covered_once() {
    for (name, points) in shapes() {
        for start in 0..points.len() {
            let mut turned = points.clone();
            turned.rotate_left(start);
            check(name, &turned);
        }
        let mut reversed = points.clone();
        reversed.reverse();
        check(name, &reversed);
    }
}

#[test]
fn tilted_planes_far_places_and_all_scales() {
    let tilt = DMat3::from_cols(
        DVec3::new(2.0 / 3.0, -1.0 / 3.0, 2.0 / 3.0),
        DVec3::new(2.0 / 3.0, 2.0 / 3.0, -1.0 / 3.0),
        DVec3::new(-1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0),
    );
    for (name, points) in shapes() {
        check(name, &points.iter().map(|&p| tilt * p).collect::<Vec<_>>());
        check(name, &points.iter().map(|&p| p + DVec3::new(1024.0, -4096.0, 0.0)).collect::<Vec<_>>());
        let base = triangulate(&polygon(points.clone()));
        for exponent in [-1000, -100, -60, 60, 100, 1000] {
            let scale = libm::ldexp(1.0, exponent);
            let scaled = triangulate(&polygon(points.iter().map(|&p| p * scale).collect()));
            assert_eq!(scaled, base, "{name} at 2^{exponent}");
        }
        for scale in [1e-30, 1e30] {
            check(name, &points.iter().map(|&p| p * scale).collect::<Vec<_>>());
        }
    }
}

#[test]
fn a_hole_on_a_bridge_is_left_out() {
    // A square with a square hole, joined by a bridge that is run through both ways.
    let keyhole = flat(&[
        [0., 0.],
        [4., 0.],
        [4., 4.],
        [0., 4.],
        [0., 0.],
        [1., 1.],
        [1., 3.],
        [3., 3.],
        [3., 1.],
        [1., 1.],
    ]);
    let out = check("keyhole", &keyhole);
    let centre = DVec2::new(2.0, 2.0);
    for triangle in out.triangles {
        let [a, b, c] = triangle.map(|corner| keyhole[corner as usize].truncate());
        let inside = [(a, b), (b, c), (c, a)].iter().all(|(p, q)| (*q - *p).perp_dot(centre - *p) > 0.0);
        assert!(!inside, "{triangle:?} covers the hole");
    }
}

#[test]
fn repeated_positions_give_triangles_without_area() {
    for points in [
        flat(&[[0., 0.], [2., 0.], [2., 0.], [2., 2.], [0., 2.]]),
        flat(&[[0., 0.], [2., 0.], [2., 2.], [0., 2.], [0., 0.]]),
        flat(&[[0., 0.], [0., 0.], [2., 0.], [2., 2.], [0., 2.], [0., 0.]]),
        // Out along a whisker and back, in the middle of the list and where it begins.
        flat(&[[0., 0.], [2., 0.], [2., 2.], [3., 3.], [2., 2.], [0., 2.]]),
        flat(&[[3., 3.], [2., 2.], [0., 2.], [0., 0.], [2., 0.], [2., 2.]]),
        flat(&[[2., 2.], [0., 2.], [0., 0.], [2., 0.], [2., 2.], [3., 3.]]),
        flat(&[[0., 0.], [2., 0.], [2., 0.], [0., 2.]]),
    ] {
        check("repeated", &points);
    }
}

#[test]
fn what_cannot_be_cut_is_reported_and_kept_as_a_fan() {
    let bow_tie = flat(&[[0., 0.], [1., 1.], [1., 0.], [0., 1.]]);
    let crossing = flat(&[[0., 0.], [4., 0.], [4., 4.], [2., -1.], [0., 4.]]);
    let line = flat(&[[0., 0.], [1., 0.], [2., 0.], [3., 0.], [4., 0.]]);
    let point = vec![DVec3::ONE; 6];
    let twice = [star(3, 0.6), star(3, 0.6)].concat();
    let touching = flat(&[[0., 0.], [4., 0.], [4., 4.], [2., 0.], [0., 4.]]);
    let eight = flat(&[[0., 0.], [2., 0.], [0., 1.], [-2., 3.], [2., 3.], [0., 1.]]);
    for (name, points) in [
        ("bow tie", bow_tie),
        ("crossing", crossing),
        ("line", line),
        ("point", point),
        ("twice round", twice),
        ("touching", touching),
        ("figure of eight", eight),
    ] {
        let out = triangulate(&polygon(points.clone()));
        assert_eq!(out.failed, [0], "{name}");
        let fan: Vec<_> = (1..points.len() as u32 - 1).map(|k| [0, k, k + 1]).collect();
        assert_eq!(out.triangles, fan, "{name}");
    }
}

#[test]
fn the_diagonal_of_a_quad_does_not_depend_on_the_first_corner() {
    let diagonal = |points: &[DVec3]| {
        let [a, b, c] = triangulate(&polygon(points.to_vec())).triangles[0];
        // The first triangle holds corner 0 and both ends of the diagonal unless that starts at 0.
        let ends = if [a, b, c] == [0, 1, 2] { [0, 2] } else { [1, 3] };
        let mut ends = ends.map(|corner: usize| points[corner].to_array());
        ends.sort_by(|a, b| a.partial_cmp(b).unwrap());
        ends
    };
    let rectangle = flat(&[[0., 0.], [3., 0.], [3., 1.], [0., 1.]]);
    let kite = flat(&[[0., 0.], [1., -1.], [5., 0.], [1., 1.]]);
    let reflex = flat(&[[0., 0.], [2., 0.], [0.5, 0.5], [0., 2.]]);
    let trapezium = flat(&[[0., 0.], [4., 0.], [3., 1.], [1., 1.]]);
    let saddle = [[0., 0., 0.], [1., 0., 0.3], [1., 1., 0.], [0., 1., 0.3]].map(DVec3::from_array).to_vec();
    let expected = [
        (rectangle, [[0., 0., 0.], [3., 1., 0.]]),
        (kite, [[1., -1., 0.], [1., 1., 0.]]),
        (reflex, [[0., 0., 0.], [0.5, 0.5, 0.]]),
        (trapezium, [[0., 0., 0.], [3., 1., 0.]]),
        (saddle, [[0., 0., 0.], [1., 1., 0.]]),
    ];
    for (points, ends) in expected {
        for start in 0..4 {
            let mut turned = points.clone();
            turned.rotate_left(start);
            assert_eq!(diagonal(&turned), ends, "{turned:?}");
            turned.reverse();
            assert_eq!(diagonal(&turned), ends, "{turned:?}");
        }
    }
}

#[test]
fn a_polygon_of_twenty_thousand_corners() {
    check("gear", &star(10_000, 0.9));
    check("long spiral", &spiral(10_000));
}

#[test]
fn triangles_pass_through_among_polygons() {
    let mut faces = Faces::new();
    for face in [&[0, 1, 2][..], &[0, 1, 2, 3], &[2, 3, 0]] {
        faces.push(face);
    }
    let positions = flat(&[[0., 0.], [2., 0.], [2., 1.], [0., 1.]]);
    let out = triangulate(
        &MeshBuilder { positions: positions.into(), faces, ..Default::default() }.build().unwrap(),
    );
    assert_eq!(out.triangles, [[0, 1, 2], [3, 4, 5], [3, 5, 6], [7, 8, 9]]);
    assert_eq!(out.source_face, [0, 1, 1, 2]);
}

/// Inputs on which a plain bulk load or insertion of edges in order takes minutes.
#[test]
fn hostile_polygons_end() {
    let n = 20_000;
    let mut triangle: Vec<_> = (0..n).map(|k| DVec3::new(k as f64, 0.0, 0.0)).collect();
    triangle.push(DVec3::new(0.5 * n as f64, 1e5, 0.0));
    check("all but one corner on a line", &triangle);
    // Needles from side to side, with rows of corners above and below.
    let along = |k: usize| (k as f64 + 0.5) / n as f64;
    let mut needles: Vec<_> = (0..n).map(|k| DVec3::new((k % 2) as f64, 1e-3 * along(k), 0.0)).collect();
    needles.extend((0..n).map(|k| DVec3::new(1.0 - along(k), 0.002 + 1e-4 * (k % 7) as f64, 0.0)));
    needles.extend([DVec3::new(-0.5, 0.002, 0.0), DVec3::new(-0.5, 0.0, 0.0)]);
    needles.extend((0..n).map(|k| DVec3::new(1.4 * along(k) - 0.5, -0.002, 0.0)));
    needles.push(DVec3::new(0.9, -0.001, 0.0));
    assert_eq!(triangulate(&polygon(needles)).failed, [0]);
    let golden = 2.399963229728653;
    let star: Vec<_> = (0..n)
        .map(|k| {
            let (y, x) = libm::sincos(golden * k as f64);
            DVec3::new(x, y, 0.0)
        })
        .collect();
    assert_eq!(triangulate(&polygon(star)).failed, [0]);
}
