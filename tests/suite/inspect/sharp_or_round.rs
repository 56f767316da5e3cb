//! Whether a shape is sharp or round, which decides if normals that are smooth or flat all over are a fault.

use super::{inspect, rebuilt, recipe, surface, with_normals};
use crease::mesh::{Column, Faces, Mesh};
use crease::normals::Weight;
use crease::quality::Severity;
use crease::quality::catalogue::Kind;
use crease::surface::{Ellipsoid, Sphere, Surface, Tessellation};
use glam::DVec3;
use std::collections::HashMap;

/// A square plate with `cells` cells along each side and an octagonal hole in each cell, in quads or in triangles. The dihedral
/// angle between neighbouring walls of a hole is 45°.
fn plate(cells: u32, is_cut: bool) -> Mesh {
    let (mut positions, mut at) = (Vec::new(), HashMap::new());
    let mut vertex = |place: [i32; 3]| {
        *at.entry(place).or_insert_with(|| {
            positions.push(0.005 * DVec3::from(place.map(f64::from)));
            positions.len() as u32 - 1
        })
    };
    let mut faces = Faces::new();
    let mut quad = |[a, b, c, d]: [u32; 4]| match is_cut {
        true => [[a, b, c], [a, c, d]].iter().for_each(|face| faces.push(face)),
        false => faces.push(&[a, b, c, d]),
    };
    // A cell of 200 by 200 units: the points of its rim, and of a hole with a radius of about 60.
    let rim = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1)];
    let hole = rim.map(|(x, y)| if x * y == 0 { (60 * x, 60 * y) } else { (42 * x, 42 * y) });
    let rim = rim.map(|(x, y)| (100 * x, 100 * y));
    let last = cells as i32 - 1;
    for (cell, middle) in (0..=last).flat_map(|i| (0..=last).map(move |j| ([i, j], (200 * i, 200 * j)))) {
        let mut on = |(x, y): (i32, i32), z| vertex([middle.0 + x, middle.1 + y, z]);
        for k in 0..8 {
            let [a, b, c, d] = [rim[k], rim[(k + 1) % 8], hole[(k + 1) % 8], hole[k]];
            quad([on(a, 20), on(b, 20), on(c, 20), on(d, 20)]);
            quad([on(d, -20), on(c, -20), on(b, -20), on(a, -20)]);
            quad([on(c, -20), on(d, -20), on(d, 20), on(c, 20)]);
            let is_outside = |sign: i32, axis: fn((i32, i32)) -> i32, cell: i32| {
                axis(a) == 100 * sign && axis(b) == 100 * sign && cell == if sign > 0 { last } else { 0 }
            };
            let sides = [is_outside(1, |p| p.0, cell[0]), is_outside(-1, |p| p.0, cell[0])];
            let ends = [is_outside(1, |p| p.1, cell[1]), is_outside(-1, |p| p.1, cell[1])];
            if sides.into_iter().chain(ends).any(|outside| outside) {
                quad([on(a, -20), on(b, -20), on(b, 20), on(a, 20)]);
            }
        }
    }
    rebuilt(positions, faces)
}

/// Wide flat faces next to edges show that a shape is sharp, even if it also has coarse round holes.
#[test]
fn parts_with_coarse_holes_are_sharp() {
    for is_cut in [false, true] {
        let smooth = with_normals(plate(4, is_cut), &recipe(Weight::Angle, 180.0));
        let diagnosis = inspect(&smooth, 1);
        let soft = diagnosis.get(Kind::Soft).unwrap_or_else(|| panic!("{is_cut}: nothing is reported"));
        // Two rims of eight edges for each hole, two rims of 32 edges around the plate, and its four corners.
        assert_eq!((soft.count, soft.severity), (16 * 16 + 2 * 32 + 4, Severity::Warning), "{is_cut}");
        let sharp = with_normals(smooth.with_normals(None), &recipe(Weight::Angle, 40.0));
        assert!(inspect(&sharp, 1).get(Kind::Soft).is_none(), "{is_cut}");
    }
}

/// Faults of single normals do not hide that all edges are smooth: edges next to them do not count as sharp. If the smooth edges
/// were reported only after these faults are fixed, the fix would seem to cause them.
#[test]
fn outliers_do_not_hide_that_all_is_smooth() {
    let smooth = with_normals(plate(4, false), &recipe(Weight::Angle, 180.0));
    let sides = 16 * 16 + 2 * 32 + 4;
    let spoilt = |wrong: fn(DVec3) -> DVec3| {
        let (corners, normals) = (smooth.faces().corners(), smooth.columns().normals.as_ref().unwrap());
        let normal = |corner: usize| {
            let own = *normals.get(corner, corners[corner]).unwrap();
            if corner % 97 == 5 { wrong(own) } else { own }
        };
        let all = 0..corners.len();
        let normals =
            Column::per_corner(all.clone().map(normal).collect(), all.map(|it| it as u32).collect());
        inspect(&smooth.clone().with_normals(Some(normals)), 1)
    };
    for (wrong, kind) in [
        ((|_| DVec3::ZERO) as fn(DVec3) -> DVec3, Kind::ZeroNormals),
        (|normal| -normal, Kind::Flipped),
        (|normal| (normal + 0.5 * normal.any_orthonormal_vector()).normalize(), Kind::Outlier),
    ] {
        let diagnosis = spoilt(wrong);
        assert!(diagnosis.get(kind).is_some(), "{kind:?}");
        let soft = diagnosis.get(Kind::Soft).unwrap_or_else(|| panic!("{kind:?} hides it"));
        assert!(
            (sides - 40..sides).contains(&(soft.count as usize)) && soft.severity == Severity::Warning,
            "{soft:?}"
        );
    }
}

/// The dihedral angle at the rim of a flat ellipsoid is 52°, over few faces, but its exact normals are smooth there.
#[test]
fn rims_of_lenses_may_be_round() {
    let lens = Surface::from(Ellipsoid::new(DVec3::new(1.0, 0.1, 1.0)).unwrap());
    let exact = surface(&lens, [24, 12]);
    let diagnosis = inspect(&exact, 1);
    let soft = diagnosis.get(Kind::Soft).expect("the dihedral angle is that of an edge");
    assert_eq!((soft.count, soft.severity), (24, Severity::Note));
}

/// Dihedral angles of all sizes, some above 90°, and no flat faces next to them: the shape is rough and meant to look round.
#[test]
fn rough_shapes_are_round() {
    let rough = Tessellation { noise: 0.35, segments: [24, 12], ..Tessellation::default() };
    let rough = Surface::from(Sphere::default()).tessellate(&rough).unwrap().with_normals(None);
    let smooth = with_normals(rough, &recipe(Weight::Angle, 180.0));
    assert!(inspect(&smooth, 1).get(Kind::Soft).is_none());
}

/// A smooth shape may have some sharp edges. A shape that has only sharp edges is meant to be faceted.
#[test]
fn facets_are_reported_on_shapes_that_mostly_bend_gently() {
    let flat = |mesh: Mesh| with_normals(mesh.with_normals(None), &recipe(Weight::Angle, 0.0));
    let rough = Tessellation { noise: 0.06, segments: [24, 12], ..Tessellation::default() };
    let rough = Surface::from(Sphere::default()).tessellate(&rough).unwrap();
    assert!(inspect(&flat(rough), 1).get(Kind::Faceted).is_some());
    for shape in [plate(4, true), surface(&Surface::from(Sphere::default()), [6, 4])] {
        assert!(inspect(&flat(shape), 1).get(Kind::Faceted).is_none());
    }
}
