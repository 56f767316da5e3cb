//! Faults of whole meshes and components: rounding, noise, softness, gaps, a reversed component.

use super::clean::Clean;
use super::planted::{Planted, at_corners, everywhere, per_corner, turned, unshared};
use super::{rebuilt, recipe, with_normals};
use crate::random::Random;
use crease::mesh::{Column, ColumnIndex, FaceEdit, Faces, Mesh, NONE};
use crease::normals::Weight;
use crease::normals::encoding::{Encoding, Snorm};
use crease::quality::catalogue::Kind;
use glam::DVec3;
use std::collections::BTreeSet;

/// The faults of whole meshes and components that fit a clean mesh.
pub(super) fn faults(clean: &Clean) -> Vec<Planted> {
    let mut all = vec![missing(clean), perturbed(clean)];
    all.extend(clean.is_round.then(|| made_otherwise(clean)));
    all.extend(clean.is_round.then(|| rounded(clean)).into_iter().flatten());
    all.extend(clean.is_closed.then(|| reversed_component(clean)));
    match clean.name {
        "icosphere" | "torus" => all.push(recomputed(clean, "all flat", Kind::Faceted, 0.0)),
        "gear" => all.push(recomputed(clean, "all edges smooth", Kind::Soft, 180.0)),
        _ => {}
    }
    all
}

/// Corners without a normal.
fn missing(clean: &Clean) -> Planted {
    let planted = at_corners(clean, "1 corner in 111 without a normal", Kind::MissingNormals, |n| n);
    let mut normals = planted.mesh.columns().normals.clone().unwrap();
    let ColumnIndex::PerCorner(index) = &mut normals.index else { panic!("per corner") };
    planted.places.iter().for_each(|&corner| index[corner as usize] = NONE);
    Planted { mesh: planted.mesh.clone().with_normals(Some(normals)), ..planted }
}

/// A random half of the normals, tilted by 30° to 60° in random directions.
fn perturbed(clean: &Clean) -> Planted {
    let mut random = Random(17);
    let mut normals = unshared(&clean.mesh);
    let mut places = BTreeSet::new();
    for (corner, normal) in normals.iter_mut().enumerate() {
        if random.unit() < 0.5 {
            *normal = turned_any_way(*normal, 30.0 + 30.0 * random.unit(), &mut random);
            places.insert(corner as u32);
        }
    }
    let mesh = per_corner(&clean.mesh, normals);
    Planted::new("every second corner perturbed by 30° to 60°", Kind::Outlier, mesh, places)
}

/// All normals tilted by 30° to 60° in random directions, each for all corners that share it, so that no weighting fits. On a
/// shape with sharp edges this would be noise corner by corner.
fn made_otherwise(clean: &Clean) -> Planted {
    let mut random = Random(19);
    let mut normals = clean.mesh.columns().normals.clone().unwrap();
    let turn = |normal: &mut DVec3| {
        *normal = turned_any_way(*normal, 30.0 + 30.0 * random.unit(), &mut random);
    };
    normals.values.iter_mut().for_each(turn);
    let places = (0..clean.mesh.faces().corner_count() as u32).collect();
    let mesh = clean.mesh.clone().with_normals(Some(normals));
    Planted::new("each normal perturbed by 30° to 60°", Kind::Custom, mesh, places)
}

/// A direction at an angle from another, on a random side.
pub(super) fn turned_any_way(normal: DVec3, degrees: f64, random: &mut Random) -> DVec3 {
    let round = glam::DQuat::from_axis_angle(normal, std::f64::consts::TAU * random.unit());
    round * turned(normal, degrees)
}

/// A random share of all corners with a changed normal.
pub(super) fn by_chance(
    clean: &Clean,
    (what, expected, share): (&'static str, Kind, f64),
    change: impl Fn(DVec3, &mut Random) -> DVec3,
) -> Planted {
    let mut random = Random(29);
    let mut normals = unshared(&clean.mesh);
    let mut places = BTreeSet::new();
    for (corner, normal) in normals.iter_mut().enumerate() {
        if random.unit() < share {
            *normal = change(*normal, &mut random);
            places.insert(corner as u32);
        }
    }
    Planted::new(what, expected, per_corner(&clean.mesh, normals), places)
}

/// All normals rounded to grids of several kinds, and then to `f32`.
fn rounded(clean: &Clean) -> Vec<Planted> {
    type Rounding = fn(DVec3) -> DVec3;
    let ways: [(&'static str, Rounding); 6] = [
        ("all rounded to 8 bits", |n| (n * 127.0).round() / 127.0),
        ("all rounded to 8 bits and renormalised", |n| (n * 127.0).round().normalize()),
        ("all rounded to unsigned 8 bits", |n| (n * 127.5 + 127.5).round() / 127.5 - 1.0),
        ("all rounded to two decimals and renormalised", |n| (n * 100.0).round().normalize()),
        ("all rounded to 3 × 10 bits", |n| stored(Encoding::Snorm(Snorm::TEN), n)),
        ("all stored as octahedral 8 + 8 bits", |n| stored(Encoding::OCTAHEDRAL_8, n)),
    ];
    let planted = |(what, round): (&'static str, Rounding)| {
        everywhere(clean, what, Kind::Quantised, |n| round(n).as_vec3().as_dvec3())
    };
    ways.into_iter().map(planted).collect()
}

fn stored(encoding: Encoding, normal: DVec3) -> DVec3 {
    encoding.decode(encoding.encode(normal))
}

/// The mesh, and next to it a copy with reversed faces; both keep the stored normals.
fn reversed_component(clean: &Clean) -> Planted {
    let (mesh, count) = (&clean.mesh, clean.mesh.face_count());
    let offset = DVec3::X * 10.0 * mesh.bounds().map_or(1.0, |(low, high)| (high - low).max_element());
    let positions =
        [DVec3::ZERO, offset].into_iter().flat_map(|at| mesh.positions().iter().map(move |p| p + at));
    let first = mesh.vertex_count() as u32;
    let mut faces = Faces::new();
    for start in [0, first] {
        mesh.faces().iter().for_each(|face| faces.push(&face.iter().map(|v| v + start).collect::<Vec<_>>()));
    }
    let normals = unshared(mesh);
    let both = per_corner(&rebuilt(positions.collect(), faces), [normals.clone(), normals].concat());
    let reversed: Vec<u32> = (count as u32..2 * count as u32).collect();
    let places = reversed.iter().copied().collect();
    let mesh = both.with_faces(&FaceEdit { reversed, ..FaceEdit::default() });
    Planted::new("one of two components reversed", Kind::InsideOut, mesh, places).by_face()
}

/// Normals with a crease angle that does not suit the shape, and no smoothing groups that would ask for it.
fn recomputed(clean: &Clean, what: &'static str, expected: Kind, crease: f64) -> Planted {
    let bare = rebuilt(clean.mesh.positions().to_vec(), clean.mesh.faces().clone());
    Planted::new(what, expected, with_normals(bare, &recipe(Weight::Angle, crease)), BTreeSet::new())
}

/// A sheet folded into a zigzag, each fold by so many degrees, with flat strips between them.
pub(super) fn zigzag(bend: f64) -> Mesh {
    const FOLDS: u32 = 24;
    const LONG: u32 = 12;
    let (sine, cosine) = libm::sincos(0.5 * bend.to_radians());
    let mut positions = Vec::new();
    for x in 0..=FOLDS {
        let at = DVec3::new(f64::from(x) * cosine, f64::from(x % 2) * sine, 0.0);
        positions.extend((0..=LONG).map(|z| at - DVec3::Z * f64::from(z)));
    }
    let mut faces = Faces::new();
    for x in 0..FOLDS {
        for z in 0..LONG {
            let corner = x * (LONG + 1) + z;
            faces.push(&[corner, corner + LONG + 1, corner + LONG + 2, corner + 1]);
        }
    }
    with_normals(rebuilt(positions, faces), &recipe(Weight::Angle, 40.0))
}

/// A reader makes a column without values at some corners if the file has none there.
#[test]
fn what_is_missing_is_left_out() {
    let clean = super::clean::meshes().remove(0);
    let planted = missing(&clean);
    let column: &Column<DVec3> = planted.mesh.columns().normals.as_ref().unwrap();
    let corners = planted.mesh.faces().corners();
    let gaps = (0..corners.len()).filter(|&corner| column.get(corner, corners[corner]).is_none()).count();
    assert_eq!(gaps, planted.places.len());
}
