//! Objects within closed surfaces that face inwards: rooms and cavities have air inside, surfaces that are inside out have
//! matter. The diagnosis and `Orient::Outward` agree.

use super::{rebuilt, surface};
use crease::io::{Document, Format, Loaded, Part};
use crease::mesh::{Column, Columns, FaceEdit, Faces, Mesh, MeshBuilder, NONE, Orient};
use crease::normals::{NormalRecipe, compute};
use crease::pipeline::{Task, revise};
use crease::quality::catalogue::Kind;
use crease::quality::{Severity, Thresholds, diagnose};
use crease::surface::{Sphere, Surface};
use glam::DVec3;

/// A ball of a mesh: its radius, the x coordinate of its centre, the side that its faces face, and the side that its stored
/// normals point to, if it has any.
type Ball = (f64, f64, Way, Option<Way>);

#[derive(Clone, Copy, PartialEq)]
enum Way {
    Out,
    In,
}
use Way::{In, Out};

const SEGMENTS: [u32; 2] = [12, 8];

fn ball(radius: f64) -> Mesh {
    surface(&Surface::from(Sphere::new(radius).unwrap()), SEGMENTS).with_normals(None)
}

fn faces_of_ball() -> usize {
    ball(1.0).face_count()
}

/// Balls in one mesh, in their order.
fn mesh(balls: &[Ball]) -> Mesh {
    let (mut positions, mut faces) = (Vec::new(), Faces::new());
    let (mut normals, mut index) = (Vec::new(), Vec::new());
    for &(radius, x, way, stored) in balls {
        let first = positions.len() as u32;
        let ball = ball(radius);
        for face in ball.faces().iter() {
            let mut face: Vec<u32> = face.iter().map(|vertex| vertex + first).collect();
            if way == In {
                face[1..].reverse();
            }
            index.extend(face.iter().map(|&vertex| if stored.is_some() { vertex } else { NONE }));
            faces.push(&face);
        }
        positions.extend(ball.positions().iter().map(|position| position + x * DVec3::X));
        let sign = if stored == Some(In) { -1.0 } else { 1.0 };
        normals.extend(ball.positions().iter().map(|position| sign * position.normalize()));
    }
    if balls.iter().all(|ball| ball.3.is_none()) {
        return rebuilt(positions, faces);
    }
    let columns = Columns { normals: Some(Column::per_corner(normals, index)), ..Columns::default() };
    MeshBuilder { positions: positions.into(), faces, columns }.build().unwrap()
}

fn file(meshes: Vec<Mesh>) -> Loaded {
    let parts = meshes.into_iter().map(|mesh| Part { mesh, ..Part::default() }).collect();
    Loaded { format: Format::Obj, parts, nodes: Vec::new(), notes: Vec::new(), document: Document::None }
}

/// The balls that are reported as a kind, as part and number.
fn reported(loaded: &Loaded, kind: Kind) -> Vec<(usize, usize)> {
    let thresholds = Thresholds { places: 1 << 16, ..Thresholds::default() };
    let diagnosis = diagnose(loaded, &thresholds, &|_| {});
    let places = diagnosis.get(kind).map_or(&[][..], |found| &found.places);
    let ball = |face: u32| face as usize / faces_of_ball();
    let mut balls: Vec<(usize, usize)> = places.iter().map(|at| (at.part, ball(at.face.unwrap()))).collect();
    balls.sort_unstable();
    balls.dedup();
    balls
}

/// The balls that are reported as inside out. Asserts that `Orient::Outward` reverses the faces of these balls and no others, and
/// that nothing is reported afterwards, with normals computed again.
#[track_caller]
fn inside_out(mut loaded: Loaded) -> Vec<(usize, usize)> {
    let balls = reported(&loaded, Kind::InsideOut);
    let has_normals = loaded.parts.iter().any(|part| part.mesh.columns().normals.is_some());
    let outward = Task { orient: Orient::Outward, ..Task::default() };
    let edits = revise(&loaded, &outward, None, &|_| {}).edits;
    for (number, (part, edit)) in loaded.parts.iter_mut().zip(edits).enumerate() {
        let faces = 0..part.mesh.face_count() as u32;
        let is_reported = |face: &u32| balls.contains(&(number, *face as usize / faces_of_ball()));
        let expected: Vec<u32> = faces.filter(is_reported).collect();
        assert_eq!(edit.faces.reversed, expected, "part {number}, where {balls:?} are reported");
        part.mesh = part.mesh.with_faces(&FaceEdit { reversed: expected, ..FaceEdit::default() });
        if has_normals {
            let normals = compute(&part.mesh, &NormalRecipe::default()).normals;
            part.mesh = part.mesh.clone().with_normals(Some(normals));
        }
    }
    assert_eq!(reported(&loaded, Kind::InsideOut), [], "after the fix");
    balls
}

/// The balls of one mesh that are inside out.
#[track_caller]
fn of_one(balls: &[Ball]) -> Vec<usize> {
    inside_out(file(vec![mesh(balls)])).into_iter().map(|(_, ball)| ball).collect()
}

fn bare(balls: &[Ball]) -> Vec<Ball> {
    balls.iter().map(|&(radius, x, way, _)| (radius, x, way, None)).collect()
}

const NONE_REPORTED: [usize; 0] = [];

const ROOM: Ball = (10.0, 0.0, In, Some(In));
const CHAIR: Ball = (2.0, 5.0, Out, Some(Out));
const TABLE: Ball = (3.0, -5.0, Out, Some(Out));
const DRAWER: Ball = (1.5, -5.0, In, Some(In));

#[test]
fn what_stands_in_a_room_is_no_cavity() {
    for balls in [&[ROOM, CHAIR][..], &[ROOM, CHAIR, TABLE], &[CHAIR, TABLE, ROOM]] {
        assert_eq!(of_one(balls), NONE_REPORTED);
        let room = balls.iter().position(|&ball| ball == ROOM).unwrap();
        assert_eq!(reported(&file(vec![mesh(balls)]), Kind::Room), [(0, room)]);
    }
    let diagnosis = diagnose(&file(vec![mesh(&[ROOM, CHAIR])]), &Thresholds::default(), &|_| {});
    let found = diagnosis.get(Kind::Room).unwrap();
    assert_eq!((found.severity, found.count), (Severity::Note, faces_of_ball() as u64));
    assert!(found.cause.english().ends_with("in 1 closed component"), "{}", found.cause.english());
    assert_eq!(diagnosis.worst(), Some(Severity::Note));
}

#[test]
fn a_thing_in_a_room_may_be_hollow() {
    assert_eq!(of_one(&[ROOM, TABLE, DRAWER]), NONE_REPORTED);
    let solid = (DRAWER.0, DRAWER.1, Out, Some(Out));
    assert_eq!(of_one(&[ROOM, CHAIR, TABLE, solid]), [3]);
}

/// The normals of the thing do not matter: those of the other balls show that this is a room.
#[test]
fn a_thing_in_a_room_may_be_inside_out() {
    for stored in [Some(Out), Some(In), None] {
        assert_eq!(of_one(&[ROOM, CHAIR, (TABLE.0, TABLE.1, In, stored)]), [2]);
    }
    // Its own normals are enough to report it.
    assert_eq!(of_one(&[ROOM, (TABLE.0, TABLE.1, In, Some(Out))]), [1]);
    assert_eq!(of_one(&[ROOM, (TABLE.0, TABLE.1, In, Some(Out)), DRAWER]), [1]);
}

#[test]
fn a_room_in_a_solid_is_a_cavity() {
    let house = (12.0, 0.0, Out, Some(Out));
    for balls in [vec![house, ROOM, CHAIR], bare(&[house, ROOM, CHAIR, TABLE, DRAWER])] {
        assert_eq!(of_one(&balls), NONE_REPORTED);
        assert_eq!(reported(&file(vec![mesh(&balls)]), Kind::Room), []);
    }
    assert_eq!(of_one(&[house, ROOM, CHAIR, (TABLE.0, TABLE.1, In, Some(Out))]), [3]);
}

/// A closed surface is solid unless its normals show that it is a room.
#[test]
fn what_is_no_room_is_solid() {
    assert_eq!(of_one(&bare(&[ROOM, CHAIR])), [0, 1], "no normals");
    // Both have the same severity; findings of a lower one would only be counted.
    assert_eq!(of_one(&[(10.0, 0.0, In, Some(Out)), (2.0, 5.0, Out, Some(In))]), [0, 1], "against its faces");
    assert_eq!(of_one(&[(10.0, 0.0, In, None), CHAIR]), [0, 1], "normals only on the thing in it");
    assert_eq!(of_one(&[ROOM]), [0], "nothing in it");
    assert_eq!(of_one(&[ROOM, (20.0 / 3.0, 30.0, Out, Some(Out))]), [0], "next to it");
    assert_eq!(of_one(&[ROOM, (5.0, 0.0, In, Some(In))]), [0], "a cavity in it");
    assert_eq!(
        of_one(&[ROOM, (5.0, 0.0, In, Some(In)), (2.0, 0.0, Out, Some(Out))]),
        [0],
        "and a thing in that"
    );
    let walls = [-5.0, 0.0].map(|x| (2.0, x, In, Some(In)));
    assert_eq!(of_one(&[ROOM, CHAIR, walls[0], walls[1]]), [0, 1], "two cavities and one thing in it");
    assert_eq!(
        of_one(&[ROOM, (CHAIR.0, CHAIR.1, Out, None)]),
        NONE_REPORTED,
        "a thing without normals is not reported"
    );
}

/// A cavity of another mesh shows that there is air inside, as normals do.
#[test]
fn cavities_of_other_meshes_have_air_within() {
    let parts =
        |meshes: &[&[Ball]]| inside_out(file(meshes.iter().map(|balls| mesh(&bare(balls))).collect()));
    let (house, safe) = ((12.0, 0.0, Out, None), (1.0, -5.0, In, None));
    assert_eq!(parts(&[&[house], &[ROOM, CHAIR]]), []);
    assert_eq!(parts(&[&[house], &[ROOM, TABLE, DRAWER]]), []);
    assert_eq!(parts(&[&[ROOM, TABLE], &[house], &[safe]]), [], "a cavity of a thing in it");
    assert_eq!(parts(&[&[safe, ROOM], &[house], &[TABLE]]), [], "both in one mesh");
    assert_eq!(parts(&[&[safe, ROOM], &[house]]), [(0, 0)], "nothing in it");
    assert_eq!(parts(&[&[house], &[ROOM, (TABLE.0, TABLE.1, In, None), CHAIR]]), [(1, 1)]);
    assert_eq!(parts(&[&[ROOM, CHAIR], &[TABLE]]), [(0, 0), (0, 1)], "nothing around it");
}
