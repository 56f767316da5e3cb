//! Authored normals: what may be intended is not a fault, whatever is next to it or was done to it.

use super::clean::meshes;
use super::planted::{per_corner, turned, unshared};
use super::{grave, inspect, rebuilt, recipe, surface, with_normals};
use crate::random::Random;
use crease::mesh::{Column, Faces, Mesh, MeshBuilder};
use crease::normals::{Weight, When, compute, select};
use crease::quality::Severity;
use crease::quality::catalogue::Kind;
use crease::surface::{Cylinder, Pattern, Sphere, Surface, Tessellation, Wave};
use glam::{DMat3, DVec3};

/// Leaves around the centre of a tree: quads of random directions, not quite planar, with or without a back side. Their normals
/// are those of a ball, as is usual for foliage, tilted upwards by `up`.
fn leaves(count: u32, up: f64, have_backs: bool) -> Mesh {
    let mut random = Random(71);
    let mut any = || DVec3::from([(); 3].map(|()| 2.0 * random.unit() - 1.0));
    let (mut positions, mut normals, mut faces) = (Vec::new(), Vec::new(), Faces::default());
    for leaf in 0..count {
        let (middle, along) = (3.0 * any().normalize(), any().normalize());
        let across = along.cross(any()).normalize();
        for [u, w] in [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]] {
            let position = middle + 0.4 * (u * along + w * across) + 1e-9 * any();
            positions.push(position);
            normals.push((position.normalize() + up * DVec3::Y).normalize());
        }
        let corners = [0, 1, 2, 3].map(|corner| 4 * leaf + corner);
        faces.push(&corners);
        if have_backs {
            faces.push(&[3, 2, 1, 0].map(|corner| corners[corner]));
        }
    }
    let mesh = MeshBuilder { positions: positions.into(), faces, ..MeshBuilder::default() }.build().unwrap();
    mesh.with_normals(Some(Column::per_vertex(normals)))
}

/// Half of the leaves have normals that point behind their face, which is no fault. Leaves with backs are closed and have no
/// inside.
#[test]
fn leaves_lit_like_a_ball_may_be_meant() {
    for up in [0.0, 0.5, 2.0] {
        for have_backs in [false, true] {
            let diagnosis = inspect(&leaves(300, up, have_backs), 10);
            let reported = format!("{up}, {have_backs}: {:?}", grave(&diagnosis));
            assert!(diagnosis.worst() < Some(Severity::Error), "{reported}");
            for kind in [Kind::Flipped, Kind::Outlier, Kind::Inverted, Kind::InsideOut] {
                assert!(diagnosis.get(kind).is_none(), "{kind:?}, {reported}");
            }
            let against = diagnosis.get(Kind::AgainstFace);
            assert!(against.is_none_or(|finding| finding.severity == Severity::Note), "{reported}");
            assert_eq!(against.and_then(|finding| finding.remedy.as_ref()), None, "{reported}");
        }
    }
}

/// Two meshes in one, each with its own normals.
fn together(first: &Mesh, second: &Mesh) -> Mesh {
    let mut faces = first.faces().clone();
    let count = first.vertex_count() as u32;
    for face in second.faces().iter() {
        faces.push(&Vec::from_iter(face.iter().map(|vertex| vertex + count)));
    }
    let mesh = rebuilt([first.positions().to_vec(), second.positions().to_vec()].concat(), faces);
    per_corner(&mesh, [unshared(first), unshared(second)].concat())
}

/// A trunk with computed normals, and a fault at some of its corners.
fn trunk(faults: usize, fault: impl Fn(DVec3) -> DVec3) -> Mesh {
    let tube = surface(&Surface::from(Cylinder::default()), [24, 12]).with_normals(None);
    let mut normals = unshared(&with_normals(tube.clone(), &recipe(Weight::Angle, 180.0)));
    for k in 0..faults {
        let corner = k * 53 % normals.len();
        normals[corner] = fault(normals[corner]);
    }
    per_corner(&tube, normals)
}

/// Leaves next to a trunk are no faults by its weighting, few or many, and faults of the trunk are still reported. By chance,
/// some of 400 leaves have normals opposite to those of a flat face.
#[test]
fn leaves_next_to_a_trunk_may_be_meant() {
    for count in [5, 20, 100, 400] {
        for up in [0.0, 0.5, 2.0, 1e6] {
            let leaves = leaves(count, up, false);
            let of_trunk = trunk(0, |_| unreachable!()).face_count() as u32;
            for (faults, kind) in [(0, None), (20, Some(Kind::Flipped)), (20, Some(Kind::Outlier))] {
                let fault =
                    |normal: DVec3| if kind == Some(Kind::Flipped) { -normal } else { turned(normal, 40.0) };
                let diagnosis = inspect(&together(&trunk(faults, fault), &leaves), 20);
                let reported = format!("{count}, {up}, {kind:?}: {:?}", grave(&diagnosis));
                for blamed in [Kind::Flipped, Kind::Outlier] {
                    let finding = diagnosis.get(blamed);
                    let wanted = if Some(blamed) == kind { faults } else { 0 };
                    assert_eq!(finding.map_or(0, |finding| finding.count), wanted as u64, "{reported}");
                    let places = finding.iter().flat_map(|finding| &finding.places);
                    assert!(places.into_iter().all(|site| site.face < Some(of_trunk)), "{reported}");
                }
                let against = diagnosis.get(Kind::AgainstFace);
                assert!(against.is_none_or(|finding| finding.severity == Severity::Note), "{reported}");
            }
        }
    }
}

/// A component with all its normals rotated or inverted does not count as authored.
#[test]
fn what_happened_to_a_whole_piece_is_a_fault() {
    let ball = Tessellation { pattern: Pattern::Icosphere(2), ..Tessellation::default() };
    let ball = Surface::from(Sphere::default()).tessellate(&ball).unwrap();
    let away = ball.positions().iter().map(|position| position + 9.0 * DVec3::X).collect();
    let ball = with_normals(rebuilt(away, ball.faces().clone()), &recipe(Weight::Angle, 180.0));
    let changed = |change: &dyn Fn(DVec3) -> DVec3| {
        per_corner(&ball, unshared(&ball).into_iter().map(change).collect())
    };
    let by_40 = DMat3::from_axis_angle(DVec3::new(1.0, 2.0, 3.0).normalize(), 0.7);
    for (piece, kind) in
        [(changed(&|normal| -normal), Kind::Flipped), (changed(&|normal| by_40 * normal), Kind::Outlier)]
    {
        let diagnosis = inspect(&together(&trunk(0, |_| unreachable!()), &piece), 1);
        assert_eq!(grave(&diagnosis), [kind.id()]);
        let count = diagnosis.get(kind).unwrap().count as usize;
        // Near the axis of the rotation, normals stay within the threshold.
        assert!(count > piece.faces().corner_count() * 8 / 10, "{kind:?}: {count}");
    }
}

/// Normals tilted upwards change gradually over a ball. The lowest are opposite to the computed ones, which is no fault next to
/// their neighbours. Tilted flat normals, one for each facet, are no fault either.
#[test]
fn what_is_curved_upwards_may_be_meant() {
    for subdivisions in [2, 3, 4] {
        let cells = Tessellation { pattern: Pattern::Icosphere(subdivisions), ..Tessellation::default() };
        let ball = Surface::from(Sphere::default()).tessellate(&cells).unwrap();
        for crease in [0.0, 180.0] {
            let normals =
                unshared(&with_normals(ball.clone().with_normals(None), &recipe(Weight::Angle, crease)));
            for up in [0.3, 0.6] {
                let bent = normals.iter().map(|&normal| ((1.0 - up) * normal + up * DVec3::Y).normalize());
                let diagnosis = inspect(&per_corner(&ball, bent.collect()), 10);
                assert_eq!(grave(&diagnosis), [""; 0], "{subdivisions}, {crease}, {up}");
            }
        }
    }
}

/// A ball with computed normals, changed by a function of position and normal.
fn ball_changed(change: impl Fn(DVec3, DVec3) -> DVec3) -> Mesh {
    let cells = Tessellation { pattern: Pattern::Icosphere(3), ..Tessellation::default() };
    let ball = Surface::from(Sphere::default()).tessellate(&cells).unwrap().with_normals(None);
    let normals = unshared(&with_normals(ball.clone(), &recipe(Weight::Angle, 180.0)));
    let place = |corner: usize| ball.positions().at(ball.faces().corners()[corner]);
    let changed = normals.iter().enumerate().map(|(corner, &normal)| change(place(corner), normal));
    per_corner(&ball, changed.collect())
}

/// As artists smooth a face: normals up to 25° off the weighting in one region, with a sharp or soft border. Faults elsewhere are
/// still reported.
#[test]
fn what_is_curved_in_one_place_may_be_meant() {
    for from in [0.0, 0.5] {
        for width in [1e-9, 0.3] {
            for faults in [0, 12] {
                let bent = ball_changed(|place, normal| {
                    let share = ((place.x - from) / width).clamp(0.0, 1.0);
                    normal.lerp(DVec3::Y, 0.3 * share).normalize()
                });
                let mut normals = unshared(&bent);
                let corners = bent.faces().corners().iter().enumerate();
                let behind = corners.filter(|&(_, &vertex)| bent.positions().at(vertex).x < -0.2);
                let behind: Vec<usize> = behind.map(|(corner, _)| corner).collect();
                for k in 0..faults {
                    normals[behind[k * 71 % behind.len()]] *= -1.0;
                }
                let diagnosis = inspect(&per_corner(&bent, normals), 1);
                let reported = if faults > 0 { vec![Kind::Flipped.id()] } else { vec![] };
                assert_eq!(grave(&diagnosis), reported, "{from}, {width}");
                let count = diagnosis.get(Kind::Flipped).map_or(0, |finding| finding.count);
                assert_eq!(count, faults as u64, "{from}, {width}");
                assert!(diagnosis.get(Kind::Custom).is_some(), "{from}, {width}");
            }
        }
    }
}

/// Programs fill a region with one normal, and inverting a region keeps its normals smooth: both are faults.
#[test]
fn what_is_wrong_all_over_a_region_is_a_fault() {
    let filled = ball_changed(|place, normal| if place.x > 0.3 { DVec3::Z } else { normal });
    assert!(grave(&inspect(&filled, 1)).contains(&Kind::Outlier.id()));
    let negated = ball_changed(|place, normal| if place.x > 0.3 { -normal } else { normal });
    assert_eq!(grave(&inspect(&negated, 1)), [Kind::Flipped.id()]);
}

/// A corner with the normal of the best weighting, by chance or after a fix, does not make outliers of the others around it.
#[test]
fn one_corner_by_the_rule_blames_no_other() {
    let teapot = surface(&Surface::Teapot, [8, 8]);
    let estimate = inspect(&teapot, 1);
    assert!(grave(&estimate).is_empty());
    let ruled =
        unshared(&teapot.clone().with_normals(Some(compute(&teapot, &recipe(Weight::Area, 180.0)).normals)));
    let own = unshared(&teapot);
    for count in [1, 5, 50] {
        let mut normals = own.clone();
        for k in 0..count {
            let corner = (k * 7919 + 1) % normals.len();
            normals[corner] = ruled[corner];
        }
        assert_eq!(grave(&inspect(&per_corner(&teapot, normals), 10)), [""; 0], "{count}");
    }
}

/// The command that fixes lengths keeps the directions, which no weighting restores.
#[test]
fn wrong_lengths_are_mended_without_loss() {
    let teapot = surface(&Surface::Teapot, [8, 8]);
    let own = unshared(&teapot);
    for factor in [0.01, 1.05, 100.0] {
        let mesh = per_corner(&teapot, own.iter().map(|&normal| factor * normal).collect());
        let found = inspect(&mesh, 1);
        let finding = found.get(Kind::NotUnit).expect("all lengths are wrong");
        assert_eq!(finding.count as usize, own.len());
        assert!(finding.remedy.as_ref().is_some_and(|remedy| remedy.contains("--when broken")));
        let field = compute(&mesh, &recipe(Weight::Area, 180.0));
        let mended = mesh.clone().with_normals(Some(select(&mesh, field, When::Broken).normals));
        for (corner, (mended, own)) in unshared(&mended).iter().zip(&own).enumerate() {
            // Rounding of a product and of a division by the length.
            assert!(mended.distance(*own) < 1e-15, "{factor}, corner {corner}: {mended} for {own}");
        }
        assert_eq!(grave(&inspect(&mended, 1)), [""; 0], "{factor}");
    }
}

/// A fault of all normals keeps its severity if some normals have another fault.
#[test]
fn a_stray_does_not_make_inverted_normals_less_grave() {
    for clean in meshes().into_iter().filter(|clean| !clean.is_room) {
        let mut normals: Vec<DVec3> = unshared(&clean.mesh).into_iter().map(|normal| -normal).collect();
        for count in [0, 1, 5] {
            for k in 0..count {
                let corner = (k * 7919 + 1) % normals.len();
                normals[corner] = turned(normals[corner], 60.0);
            }
            let diagnosis = inspect(&per_corner(&clean.mesh, normals.clone()), 1);
            let severity = diagnosis.get(Kind::Inverted).map(|finding| finding.severity);
            assert_eq!(severity, Some(Severity::Error), "{}, {count}", clean.name);
        }
    }
}

/// An open sheet has no outer side. If a copy has reversed winding and the same normals, these are reported as inverted, also
/// along its rim, where exact normals differ a little from the mean of faces.
#[test]
fn a_copy_that_runs_the_other_way_has_its_normals_turned_round() {
    let sheet = surface(&Surface::Wave(Wave::default()), [24, 24]);
    let count = sheet.vertex_count() as u32;
    let next_to = sheet.positions().iter().map(|position| position + 5.0 * DVec3::X);
    let positions = sheet.positions().iter().chain(next_to).collect();
    let mut faces = sheet.faces().clone();
    for face in sheet.faces().iter() {
        faces.push(&face.iter().rev().map(|vertex| vertex + count).collect::<Vec<_>>());
    }
    let exact = sheet.columns().normals.clone().unwrap().values;
    let mesh = MeshBuilder { positions, faces, ..MeshBuilder::default() }.build().unwrap();
    let mesh = mesh.with_normals(Some(Column::per_vertex([exact.clone(), exact].concat())));
    let diagnosis = inspect(&mesh, 10);
    assert_eq!(grave(&diagnosis), ["flipped-normals"]);
    let flipped = diagnosis.get(Kind::Flipped).unwrap();
    assert_eq!(flipped.count as usize, sheet.faces().corner_count());
    assert!(flipped.places.iter().all(|site| site.vertex >= Some(count)));
    assert!(diagnosis.get(Kind::AgainstFace).is_none());
}
