//! Tests of the revision of single parts.

use super::*;
use crate::io::Document;
use crate::io::{Emit, Format, Loaded, Part, PartEdit, ReadOptions, read_bytes};
use crate::mesh::Orient;
use crate::mesh::{Column, ColumnIndex, Faces, MeshBuilder, NONE};
use crate::normals::{self, Crease, NormalRecipe, Weight, When};
use crate::num::Degrees;
use crate::surface::{Surface, Tessellation, Torus};
use glam::DVec3;
use std::sync::Mutex;

/// A tetrahedron with its third face reversed, a face without area, and a face that represents one with a position that is not
/// finite.
fn part(normals: Option<Column<DVec3>>) -> Part {
    let positions = vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z, DVec3::X * 2.0, DVec3::ONE];
    let mut faces = Faces::new();
    for face in [[0, 2, 1], [0, 1, 3], [0, 2, 3], [0, 1, 4], [1, 2, 3], [1, 2, 5]] {
        faces.push(&face);
    }
    let builder = MeshBuilder { positions: positions.into(), faces, ..MeshBuilder::default() };
    let mut mesh = builder.build().unwrap();
    if normals.is_some() {
        mesh = mesh.with_normals(normals);
    }
    Part { name: "part".into(), mesh, non_finite_faces: vec![5] }
}

fn loaded(part: &Part) -> Loaded {
    Loaded {
        format: Format::Obj,
        parts: vec![part.clone()],
        nodes: Vec::new(),
        notes: Vec::new(),
        document: Document::None,
    }
}

fn revise_one(part: &Part, task: &Task, target: Option<Format>) -> (PartEdit, PartOutcome) {
    let mut revision = revise(&loaded(part), task, target, &|_| {});
    (revision.edits.pop().unwrap(), revision.parts.pop().unwrap())
}

/// The normal at each corner of the output, found as a writer does.
fn written(part: &Part, edit: &PartEdit) -> Vec<DVec3> {
    let (_, order) = edit.faces.corner_order(part.mesh.faces());
    let normals = edit.normals.as_ref().unwrap();
    let corners = part.mesh.faces().corners();
    order.iter().map(|&c| *normals.get(c as usize, corners[c as usize]).expect("a normal")).collect()
}

/// The normals that the library computes for the mesh of the output.
fn expected(part: &Part, edit: &PartEdit, task: &Task) -> Vec<DVec3> {
    let mesh = part.mesh.with_faces(&edit.faces);
    let field = normals::compute(&mesh, &task.recipe);
    let corners = mesh.faces().corners();
    (0..corners.len()).map(|c| *field.normals.get(c, corners[c]).unwrap()).collect()
}

#[test]
fn normals_are_those_of_the_output_in_the_numbers_of_the_input() {
    let part = part(None);
    for flip in [false, true] {
        for orient in [Orient::Keep, Orient::Consistent, Orient::Outward] {
            for degenerate in [Degenerate::Keep, Degenerate::Drop] {
                let task = Task { flip, orient, degenerate, ..Task::default() };
                let (edit, outcome) = revise_one(&part, &task, None);
                let dropped = if degenerate == Degenerate::Drop { &[3, 5][..] } else { &[5] };
                assert_eq!(edit.faces.dropped, dropped);
                assert_eq!(outcome.dropped_faces + outcome.non_finite_faces, dropped.len());
                assert_eq!(outcome.reversed_faces, edit.faces.reversed.len());
                assert_eq!(written(&part, &edit), expected(&part, &edit, &task), "{task:?}");
                assert_eq!(edit.kept, 0);
            }
        }
    }
}

/// Separate triangles, as in STL, are computed with shared vertices. Their normals, the order of these and the counts of edges are
/// those of the library. If a face collapses, vertices stay separate.
#[test]
fn separate_triangles_have_the_normals_of_shared_vertices() {
    let tessellation = Tessellation { segments: [24, 12], ..Tessellation::default() };
    let shared = Surface::from(Torus::default()).tessellate(&tessellation).unwrap().with_normals(None);
    for collapsed in [false, true] {
        let mut corners = shared.faces().corners().to_vec();
        if collapsed {
            corners[4] = corners[3];
        }
        let positions: Vec<DVec3> = corners.iter().map(|&vertex| shared.positions().at(vertex)).collect();
        let faces = Faces::triangles((0..corners.len() as u32).collect());
        let mesh =
            MeshBuilder { positions: positions.into(), faces, ..MeshBuilder::default() }.build().unwrap();
        let part = Part { name: String::new(), mesh, non_finite_faces: Vec::new() };
        for crease in [Crease::OFF, Crease::Angle(Degrees(25.0))] {
            let recipe = NormalRecipe { crease, ..NormalRecipe::default() };
            let task = Task { recipe, edge_counts: true, ..Task::default() };
            let (edit, outcome) = revise_one(&part, &task, Some(Format::Glb));
            assert_eq!(written(&part, &edit), expected(&part, &edit, &task), "{task:?}");
            let field = normals::compute(&part.mesh, &task.recipe);
            assert_eq!(outcome.edges, field.summary.edges);
            assert_eq!(outcome.faults, FaultCounts::of(&field.faults));
            let normals = edit.normals.unwrap();
            assert_eq!(
                normals.values.len() < corners.len(),
                !collapsed,
                "each position has its normals once"
            );
            let mut next = 0;
            for slot in normals.corner_index(part.mesh.faces().corners()) {
                assert!(slot <= next, "in the order of corners");
                next = next.max(slot + 1);
            }
        }
    }
}

#[test]
fn faces_are_turned_by_orientation_and_then_by_flipping() {
    let part = part(None);
    let reversed = |orient, flip| {
        let (edit, outcome) = revise_one(&part, &Task { orient, flip, ..Task::default() }, None);
        assert_eq!(outcome.orientation.is_some(), orient != Orient::Keep);
        edit.faces.reversed
    };
    let outward = reversed(Orient::Outward, false);
    assert!(outward.contains(&2) && !outward.contains(&0), "{outward:?}");
    assert_eq!(reversed(Orient::Keep, true), [0, 1, 2, 3, 4]);
    let both = reversed(Orient::Outward, true);
    assert!((0..5).all(|face| outward.contains(&face) != both.contains(&face)), "{both:?}");
}

/// A new file of another format is the same whether or not what it does not take was freed before.
#[test]
fn freeing_what_is_unused_changes_no_output() {
    use crate::io::{ReadOptions, WriteOptions, read_bytes, write, write_new};
    let normals = Some(Column::per_corner(vec![DVec3::X], vec![0; 18]));
    let source = write_new(&[part(normals)], Format::Ply, &WriteOptions::default()).unwrap().bytes;
    let text = "solid\nfacet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet\nendsolid";
    for (bytes, format) in [(source, Format::Ply), (text.into(), Format::Stl)] {
        let read = || read_bytes(bytes.clone(), Some(format), None, &ReadOptions::default()).unwrap();
        for when in [When::Always, When::Missing] {
            for target in [Format::Glb, Format::Ply, Format::Obj] {
                let task = Task { when, ..Task::default() };
                let written = |loaded: &Loaded| {
                    let edits = revise(loaded, &task, Some(target), &|_| {}).edits;
                    write(loaded, edits, target, &WriteOptions::default())
                };
                let (whole, mut freed) = (read(), read());
                forget_unused(&mut freed, &task, Some(target));
                let is_freed = !matches!(freed.document, Document::Ply(_) | Document::Stl(_));
                assert_eq!(is_freed, target != format);
                let is_kept = freed.parts[0].mesh.columns().normals.is_some();
                assert_eq!(is_kept, target == format || when != When::Always);
                assert_eq!(
                    written(&freed).unwrap().bytes,
                    written(&whole).unwrap().bytes,
                    "{format} {target}"
                );
                if is_freed {
                    assert!(write(&freed, &[], format, &WriteOptions::default()).is_err());
                }
            }
        }
    }
}

#[test]
fn values_of_dropped_faces_are_forgotten() {
    let part = part(None);
    let task = Task { degenerate: Degenerate::Drop, ..Task::default() };
    let (edit, _) = revise_one(&part, &task, None);
    let normals = edit.normals.unwrap();
    let ColumnIndex::PerCorner(index) = &normals.index else { panic!("per corner") };
    assert_eq!(index.len(), 18);
    assert!(index[9..12].iter().chain(&index[15..]).all(|&slot| slot == NONE));
    let used: std::collections::BTreeSet<u32> = index.iter().copied().filter(|&slot| slot != NONE).collect();
    assert_eq!(used.len(), normals.values.len(), "each value is used");
}

/// Two sides of a folded strip have an edge of their own each. A face without area is at one of them; without it, they meet, and
/// share normals.
#[test]
fn normals_are_those_of_what_remains() {
    let edge = [DVec3::ZERO, DVec3::Y];
    let others = [DVec3::new(1.0, 0.5, 0.2), DVec3::NEG_X, 0.5 * DVec3::Y];
    let positions = [edge, edge].concat().into_iter().chain(others).collect();
    let faces = Faces::triangles(vec![0, 4, 1, 2, 3, 5, 0, 1, 6]);
    let builder = MeshBuilder { positions, faces, ..MeshBuilder::default() };
    let part = Part { mesh: builder.build().unwrap(), ..Part::default() };
    for degenerate in [Degenerate::Keep, Degenerate::Drop] {
        let task = Task { degenerate, ..Task::default() };
        let (edit, outcome) = revise_one(&part, &task, None);
        let written = written(&part, &edit);
        assert_eq!(written, expected(&part, &edit, &task));
        assert_eq!(outcome.faults.faces.values().sum::<usize>(), 1);
        let meet = written[0] == written[3];
        assert_eq!(meet, degenerate == Degenerate::Drop, "{written:?}");
    }
}

#[test]
fn good_stored_normals_stay_and_turned_ones_are_new() {
    let corner = |face: usize| [[0, 2, 1], [0, 1, 3], [0, 2, 3], [0, 1, 4], [1, 2, 3], [1, 2, 5]][face];
    let outward = [-DVec3::Z, -DVec3::Y, -DVec3::X, DVec3::Z, DVec3::ONE.normalize(), DVec3::Z];
    let index: Vec<u32> = (0..6).flat_map(|face| corner(face).map(|_| face as u32)).collect();
    let stored = Column::per_corner(outward.to_vec(), index);
    let task = Task { when: When::Missing, ..Task::default() };
    let (edit, outcome) = revise_one(&part(Some(stored.clone())), &task, Some(Format::Stl));
    assert!(edit.normals.is_none(), "nothing is missing");
    assert_eq!((outcome.kept_corners, outcome.replaced_corners.len()), (15, 0));
    let facets = edit.face_normals.expect("an STL file carries them");
    assert_eq!(facets[..5], outward[..5]);

    let mut holes = stored.clone();
    let ColumnIndex::PerCorner(index) = &mut holes.index else { panic!("per corner") };
    index[0] = NONE;
    let holed = part(Some(holes));
    let (edit, outcome) = revise_one(&holed, &task, None);
    assert_eq!((edit.kept, outcome.replaced_corners["Missing"]), (6, 1));
    assert_eq!(edit.normals.as_ref().unwrap().values[..6], outward);
    assert_eq!(written(&holed, &edit)[3], -DVec3::Y);

    let flipped = Task { flip: true, ..task };
    let turned = part(Some(stored));
    let (edit, _) = revise_one(&turned, &flipped, None);
    assert_eq!(edit.kept, 0, "they are no longer the file's own");
    assert_eq!(written(&turned, &edit)[12], -outward[4]);
}

/// Faces have their numbers in the file although face 0 is dropped, and corners have the order of the file although a face is
/// reversed.
#[test]
fn places_are_those_of_the_file() {
    let positions = vec![DVec3::NAN, DVec3::ZERO, DVec3::X, DVec3::new(1.0, 1.0, 0.0), DVec3::X * 2.0];
    let faces = Faces::triangles(vec![0, 1, 2, 1, 2, 4, 1, 2, 3]);
    let stored = Column::per_corner(vec![DVec3::Z, DVec3::Z * 3.0], vec![0, 0, 0, 0, 0, 0, 0, 0, 1]);
    let columns = crate::mesh::Columns { normals: Some(stored), ..Default::default() };
    let builder = MeshBuilder { positions: positions.into(), faces, columns };
    let (mesh, non_finite_faces) = builder.build_dropping_non_finite().unwrap();
    let part = Part { name: String::new(), mesh, non_finite_faces };
    for flip in [false, true] {
        let task = Task { flip, when: When::Broken, ..Task::default() };
        let (_, outcome) = revise_one(&part, &task, None);
        assert!(outcome.fault_places.contains(&FaultPlace { spot: Spot::Face(1), reason: "ZeroArea" }));
        // Flipping makes new values and omits those that are no unit vectors.
        let broken = FaultPlace { spot: Spot::Corner { face: 2, corner: 2, vertex: 3 }, reason: "Length" };
        let expected = if flip { vec![] } else { vec![broken] };
        assert_eq!(outcome.broken_places, expected);
        let of_corners: Vec<Spot> = outcome
            .fault_places
            .iter()
            .map(|place| place.spot)
            .filter(|spot| matches!(spot, Spot::Corner { .. }))
            .collect();
        let own = |corner, vertex| Spot::Corner { face: 1, corner, vertex };
        let expected =
            if flip { [own(0, 1), own(2, 4), own(1, 2)] } else { [own(0, 1), own(1, 2), own(2, 4)] };
        assert!(of_corners.iter().all(|spot| expected.contains(spot)), "{of_corners:?}");
        assert!(of_corners.contains(&own(2, 4)), "{of_corners:?}");
    }
}

#[test]
fn face_normals_are_given_where_they_are_wanted() {
    let part = part(None);
    let facets = |emit, target| {
        let (edit, _) = revise_one(&part, &Task { emit, ..Task::default() }, target);
        assert_eq!(edit.normals.is_none(), emit == Emit::Face);
        edit.face_normals
    };
    assert!(facets(Emit::Corner, Some(Format::Ply)).is_none());
    assert!(facets(Emit::Corner, None).is_none());
    for (emit, target) in
        [(Emit::Face, None), (Emit::Face, Some(Format::Ply)), (Emit::Corner, Some(Format::Stl))]
    {
        let facets = facets(emit, target).unwrap();
        assert_eq!(facets.len(), 6, "one a face as it was read");
        assert_eq!(facets[0], -DVec3::Z);
    }
}

#[test]
fn a_part_without_faces_stays_as_it_is() {
    let task = Task { flip: true, orient: Orient::Outward, degenerate: Degenerate::Drop, ..Task::default() };
    let (edit, outcome) = revise_one(&Part::default(), &task, Some(Format::Stl));
    assert!(edit.is_empty() && outcome.faces == 0);
}

/// Long fits report some of the faces of a part at a time, other weights all at once.
#[test]
fn reported_faces_add_up_to_all() {
    let torus = Surface::from(Torus::default());
    let tessellation = Tessellation { segments: [48, 24], ..Tessellation::default() };
    let mesh = torus.tessellate(&tessellation).unwrap();
    let all = mesh.face_count();
    let loaded = loaded(&Part { name: "torus".into(), mesh, non_finite_faces: Vec::new() });
    for weight in [Weight::Jet, Weight::Angle] {
        let recipe = NormalRecipe { weight, ..NormalRecipe::default() };
        let reported = Mutex::new(Vec::new());
        revise(&loaded, &Task { recipe, ..Task::default() }, None, &|faces| {
            reported.lock().unwrap().push(faces);
        });
        let reported = reported.into_inner().unwrap();
        assert_eq!(reported.iter().sum::<usize>(), all);
        let is_expected = if weight.is_fit() { reported.len() > 1 } else { reported.len() == 1 };
        assert!(is_expected, "{reported:?}");
    }
}

/// A primitive whose faces are all dropped has no computed normals. Its morph targets keep what is stored.
#[test]
fn morph_targets_without_faces_keep_their_normals() {
    let bytes = std::fs::read(concat!(env!("CARGO_MANIFEST_DIR"), "/data/morph.gltf")).unwrap();
    // Indices without a buffer view are zeros.
    let text = String::from_utf8(bytes).unwrap().replacen("\"bufferView\": 4, ", "", 1);
    let loaded = read_bytes(text.into_bytes(), Some(Format::Gltf), None, &ReadOptions::default()).unwrap();
    let stored = loaded.parts[0].mesh.columns().normals.clone().unwrap();
    let task = Task { when: When::Missing, degenerate: Degenerate::Drop, ..Task::default() };
    let revision = revise(&loaded, &task, Some(Format::Glb), &|_| {});
    assert_eq!(revision.edits[0].faces.dropped.len(), 128);
    for normals in &revision.edits[0].morph_normals {
        // The stored ones are rounded to single precision.
        assert!(normals.iter().zip(&stored.values).all(|(normal, stored)| normal.distance(*stored) < 1e-6));
    }
}

/// A stored normal that is not finite has no text. Formats get a computed one also with `--when missing`.
#[test]
fn normals_that_are_not_finite_are_never_written() {
    let normals = Column::per_corner(vec![DVec3::new(0.0, f64::NAN, 1.0)], vec![0; 18]);
    let part = part(Some(normals));
    let task = Task { when: When::Missing, ..Task::default() };
    let (edit, outcome) = revise_one(&part, &task, Some(Format::Obj));
    assert_eq!((outcome.kept_corners, outcome.replaced_corners["NotFinite"]), (0, 15));
    assert!(written(&part, &edit).iter().all(|normal| normal.is_normalized()));
}
