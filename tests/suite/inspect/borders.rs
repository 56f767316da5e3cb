//! Parts of a file that were one surface when their normals were made.

use super::planted::{per_corner, unshared};
use super::{recipe, surface, with_normals};
use crease::io::{Document, FileNode, Format, Loaded, Part};
use crease::mesh::{Faces, Mesh};
use crease::normals::Weight;
use crease::quality::catalogue::Kind;
use crease::quality::{Thresholds, diagnose};
use crease::surface::{Sphere, Surface};
use glam::{DMat4, DVec3, DVec4};

/// The faces of a mesh on one side of the plane x = 0, with the normals that they had in the whole, in another space.
fn side(whole: &Mesh, is_right: bool, to_part: DMat4) -> Mesh {
    let of_whole = unshared(whole);
    let (mut faces, mut normals) = (Faces::new(), Vec::new());
    for face in 0..whole.faces().len() {
        let corners = whole.faces().face(face);
        let middle: DVec3 = corners.iter().map(|&vertex| whole.positions().at(vertex)).sum();
        if (middle.x > 0.0) == is_right {
            faces.push(corners);
            let own = &of_whole[whole.faces().range(face)];
            normals.extend(own.iter().map(|&normal| to_part.transform_vector3(normal)));
        }
    }
    let positions = whole.positions().iter().map(|position| to_part.transform_point3(position)).collect();
    per_corner(&super::rebuilt(positions, faces), normals)
}

/// The number of outliers in a file of these parts.
fn outliers(parts: [(Mesh, DMat4); 2]) -> u64 {
    let [nodes, parts] = [parts.each_ref(), parts.each_ref()];
    let node = |(part, (_, world_from_part)): (usize, &&(Mesh, DMat4))| FileNode {
        number: part,
        name: String::new(),
        part,
        world_from_part: *world_from_part,
    };
    let loaded = Loaded {
        format: Format::Glb,
        nodes: nodes.iter().enumerate().map(node).collect(),
        parts: parts.iter().map(|(mesh, _)| Part { mesh: mesh.clone(), ..Part::default() }).collect(),
        notes: Vec::new(),
        document: Document::None,
    };
    let diagnosis = diagnose(&loaded, &Thresholds::default(), &|_| {});
    diagnosis.get(Kind::Outlier).map_or(0, |finding| finding.count)
}

#[test]
fn normals_that_continue_in_another_part_are_no_outliers() {
    let coarse = surface(&Surface::from(Sphere::default()), [8, 40]);
    let whole = with_normals(coarse, &recipe(Weight::Angle, 180.0));
    // A quarter turn moves no bit of a coordinate.
    let turn = DMat4::from_cols(DVec4::Y, DVec4::NEG_X, DVec4::Z, DVec4::W);
    let [left, right] = [side(&whole, false, DMat4::IDENTITY), side(&whole, true, turn.transpose())];
    assert_eq!(outliers([(left.clone(), DMat4::IDENTITY), (right.clone(), turn)]), 0);

    // With the parts at a distance, neither border continues in the other part.
    let away = DMat4::from_translation(DVec3::X) * turn;
    assert!(outliers([(left.clone(), DMat4::IDENTITY), (right.clone(), away)]) > 10);

    // An outlier at the border is no normal of the other part.
    let border = (0..left.faces().corner_count())
        .find(|&corner| left.positions().at(left.faces().corners()[corner]).x.abs() < 1e-9)
        .unwrap();
    let mut normals = unshared(&left);
    normals[border] = DMat4::from_rotation_z(1.0).transform_vector3(normals[border].any_orthonormal_vector());
    let planted = per_corner(&left, normals);
    assert_eq!(outliers([(planted, DMat4::IDENTITY), (right, turn)]), 1);
}
