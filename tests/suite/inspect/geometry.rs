//! Geometry that spoils normals, against independent computations.

use super::{inspect, loaded, rebuilt, surface};
use crease::io::{FileNode, Format, Loaded, Part, ReadOptions, read_bytes};
use crease::mesh::{
    Column, Columns, Confidence, FaceLabels, Faces, Mesh, MeshBuilder, Orient, Topology, Weld, orient,
};
use crease::normals::{Crease, NormalRecipe, compute};
use crease::num::{Degrees, angle_between, three_digits};
use crease::quality::catalogue::Kind;
use crease::quality::{Diagnosis, Severity, Thresholds, diagnose, survey};
use crease::surface::{Catenoid, Cone, Pattern, Sphere, Surface, Tessellation, Torus};
use glam::{DMat3, DMat4, DVec2, DVec3};

fn polygon(corners: &[[f64; 3]]) -> Mesh {
    let mut faces = Faces::new();
    faces.push(&(0..corners.len() as u32).collect::<Vec<_>>());
    rebuilt(corners.iter().map(|&corner| DVec3::from(corner)).collect(), faces)
}

/// One half of a bow tie faces up and the other down, so its vector area is zero; it still crosses itself.
#[test]
fn balanced_bow_ties_cross_themselves() {
    let bow = [[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let uneven = [bow[0], bow[1], bow[2], [0.0, 0.9, 0.0]];
    for corners in [bow, uneven, bow.map(|[x, y, z]| [z, 3.0 * x, 3.0 * y])] {
        let found = inspect(&polygon(&corners), 10);
        assert_eq!(found.get(Kind::Crossed).map(|finding| finding.count), Some(1), "{corners:?}");
        assert!(found.get(Kind::ZeroArea).is_none(), "{corners:?}");
    }
    let on_a_line = [[0.0; 3], [1.0; 3], [3.0; 3], [2.0; 3]];
    let found = inspect(&polygon(&on_a_line), 10);
    assert!(found.get(Kind::Crossed).is_none() && found.get(Kind::ZeroArea).is_some());
}

/// The reported error is the mean over faces with rounded corners, and the reported bound is that of a typical face.
#[test]
fn errors_far_from_the_origin_are_as_reported() {
    for pattern in [Pattern::Triangles, Pattern::Quads] {
        let cells = Tessellation { pattern, segments: [40, 20], ..Tessellation::default() };
        let mesh = Surface::from(Torus::default()).tessellate(&cells).unwrap();
        // Rotated, so that no two corners of a face share a coordinate, which rounding would move together.
        let aslant = DMat3::from_axis_angle(DVec3::new(1.0, 2.0, 3.0).normalize(), 1.0);
        let moved = |p: DVec3| aslant * p + DVec3::new(1e5, 1e5, 0.0);
        let far = rebuilt(mesh.positions().iter().map(moved).collect(), mesh.faces().clone());
        let rounded = far.positions().iter().map(|p| p.as_vec3().as_dvec3()).collect();
        let rounded = rebuilt(rounded, far.faces().clone());
        let area_vector = |mesh: &Mesh, face: &[u32]| {
            let place =
                |corner: usize| mesh.positions().at(face[corner % face.len()]) - far.positions().at(0);
            (0..face.len()).map(|corner| place(corner).cross(place(corner + 1))).sum::<DVec3>()
        };
        let off = |face: &[u32]| {
            Degrees::from(angle_between(area_vector(&far, face), area_vector(&rounded, face))).0
        };
        let mut errors: Vec<f64> = far.faces().iter().map(off).collect();
        errors.sort_by(f64::total_cmp);
        let mean = errors.iter().sum::<f64>() / errors.len() as f64;

        let diagnosis = inspect(&far, 1);
        let reported = diagnosis.get(Kind::FarFromOrigin).expect("it is far");
        let cause = reported.cause.english().split("slender ones, is ").nth(1).unwrap();
        let expected: f64 = cause.split('°').next().unwrap().parse().unwrap();
        // The errors of 800 faces have a standard deviation of half their mean, so the mean is known to 2 %.
        assert!((expected / mean - 1.0).abs() < 0.06, "{pattern:?}: {expected} reported, {mean} measured");
        // Nine in ten faces are below it; the bound is that of the median face.
        assert!(
            errors[errors.len() * 9 / 10] < reported.degrees.unwrap(),
            "{pattern:?}: {:?}",
            reported.degrees
        );
    }
}

/// Two solids of a file, each inside out: both are counted.
#[test]
fn components_are_counted_over_all_parts() {
    let solid = |x: f64| {
        let corners = [[x, 0.0, 0.0], [x + 1.0, 0.0, 0.0], [x, 1.0, 0.0], [x, 0.0, 1.0]];
        let facets = [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]].map(|facet| {
            let vertices = facet.map(|corner: usize| {
                let [x, y, z] = corners[corner];
                format!("vertex {x} {y} {z}\n")
            });
            format!("facet normal 0 0 0\nouter loop\n{}endloop\nendfacet\n", vertices.concat())
        });
        format!("solid s\n{}endsolid s\n", facets.concat())
    };
    let text = [0.0, 5.0].map(solid).concat();
    let loaded = read_bytes(text.into_bytes(), Some(Format::Stl), None, &ReadOptions::default()).unwrap();
    let diagnosis = diagnose(&loaded, &Thresholds::default(), &|_| {});
    let found = diagnosis.get(Kind::InsideOut).unwrap();
    assert!(found.count == 8 && found.cause.english().ends_with("in 2 closed components"), "{found:?}");
}

/// Of tetrahedra that face inwards, those with inward normals are rooms and the others are errors. Only errors are counted as
/// such, in any order, in one part or several.
#[test]
fn rooms_are_not_counted_with_what_is_inside_out() {
    let solids = |solids: &[(f64, f64)]| {
        let mut text = String::new();
        for (at, &(x, sign)) in solids.iter().enumerate() {
            for [a, b, c] in [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] {
                let outward = [a, b, c].map(|it: f64| sign * (it - 0.25));
                text += &format!("v {} {b} {c}\nvn {} {} {}\n", a + x, outward[0], outward[1], outward[2]);
            }
            for facet in [[1, 2, 3], [1, 4, 2], [1, 3, 4], [2, 4, 3]] {
                let corners = facet.map(|corner| format!("{0}//{0}", corner + 4 * at));
                text += &format!("f {}\n", corners.join(" "));
            }
        }
        read_bytes(text.into_bytes(), Some(Format::Obj), None, &ReadOptions::default()).unwrap()
    };
    let (room, fault) = (-1.0, 1.0);
    let in_parts = |signs: &[f64]| {
        let mut parts = signs.iter().map(|&sign| solids(&[(0.0, sign)]));
        let mut all = parts.next().unwrap();
        parts.for_each(|loaded| all.parts.extend(loaded.parts));
        all
    };
    for (loaded, first_fault) in [
        (solids(&[(0.0, room), (5.0, fault)]), (0, 4)),
        (solids(&[(0.0, fault), (5.0, room)]), (0, 0)),
        (solids(&[(0.0, room), (5.0, fault), (9.0, room)]), (0, 4)),
        (in_parts(&[room, fault]), (1, 0)),
        (in_parts(&[fault, room]), (0, 0)),
    ] {
        let diagnosis = diagnose(&loaded, &Thresholds::default(), &|_| {});
        let found = diagnosis.get(Kind::InsideOut).unwrap();
        assert_eq!((found.severity, found.count), (Severity::Error, 4), "{found:?}");
        assert!(
            found.cause.english().contains("in 1 closed component, contradicted"),
            "{}",
            found.cause.english()
        );
        let rooms = found.of / 4 - 1;
        let others =
            format!("{rooms} other component{} with {} faces", if rooms == 1 { "" } else { "s" }, 4 * rooms);
        assert!(found.cause.english().contains(&others), "{}", found.cause.english());
        let first = &found.places[0];
        assert_eq!((first.part, first.face), (first_fault.0, Some(first_fault.1)));
        assert_eq!(found.area_share, Some(1.0 / (rooms + 1) as f64), "{found:?}");
    }
    let rooms = diagnose(&solids(&[(0.0, room), (5.0, room)]), &Thresholds::default(), &|_| {});
    let found = rooms.get(Kind::InsideOut).unwrap();
    assert_eq!((found.severity, found.count), (Severity::Warning, 8));
    assert!(found.cause.english().ends_with("in 2 closed components"), "{}", found.cause.english());
}

/// The actual errors of rounded normals are reported with their places, and not only a bound.
#[test]
fn rounded_normals_are_measured() {
    let torus = surface(&Surface::from(Torus::default()), [60, 30]);
    let ruled = compute(&torus, &NormalRecipe::default()).normals;
    let rounded =
        |normals: &[DVec3]| -> Vec<DVec3> { normals.iter().map(|n| (*n * 127.0).round() / 127.0).collect() };
    let with = |normals: Vec<DVec3>| {
        let entries = ruled.corner_index(torus.faces().corners());
        let columns =
            Columns { normals: Some(Column::per_corner(normals, entries)), ..torus.columns().clone() };
        let builder = MeshBuilder { positions: torus.positions().to_vec().into(), ..MeshBuilder::default() };
        MeshBuilder { faces: torus.faces().clone(), columns, ..builder }.build().unwrap()
    };
    let stored = rounded(&ruled.values);
    let off = |(a, b): (&DVec3, &DVec3)| Degrees::from(angle_between(*a, *b)).0;
    let mut all: Vec<f64> = ruled
        .corner_index(torus.faces().corners())
        .into_iter()
        .map(|entry| off((&ruled.values[entry as usize], &stored[entry as usize])))
        .collect();
    let rms = (all.iter().map(|it| it * it).sum::<f64>() / all.len() as f64).sqrt();
    all.sort_by(|a, b| b.total_cmp(a));
    let diagnosis = inspect(&with(stored), 10);
    let found = diagnosis.get(Kind::Quantised).unwrap();
    assert_eq!((found.count, found.of), (1, 1));
    let reported: Vec<f64> = found.places.iter().map(|site| site.degrees.unwrap()).collect();
    assert!(
        reported.len() == 10 && reported.iter().zip(&all).all(|(a, b)| (a - b).abs() < 1e-9),
        "{reported:?}"
    );
    let words = format!("by up to {}° (rms {}°)", three_digits(all[0]), three_digits(rms));
    assert!(
        found.cause.english().contains(&words) && found.cause.english().contains("at most 0.391°"),
        "{}",
        found.cause.english()
    );
    // Without a known weighting, the unrounded normals are unknown.
    let turned = |n: &DVec3| DMat3::from_axis_angle(n.any_orthonormal_vector(), 0.1) * *n;
    let diagnosis = inspect(&with(rounded(&ruled.values.iter().map(turned).collect::<Vec<_>>())), 10);
    let found = diagnosis.get(Kind::Quantised).unwrap();
    assert!(found.degrees.is_none() && !found.cause.english().contains("by up to"), "{found:?}");
    assert!(found.cause.english().contains("at most 0.391°"), "{}", found.cause.english());
}

/// A strip of two squares, the second with two vertices of its own where it meets the first.
fn cut_strip(columns: Columns) -> Mesh {
    let at = |x: f64, y: f64| DVec3::new(x, y, 0.0);
    let positions = vec![
        at(0.0, 0.0),
        at(1.0, 0.0),
        at(1.0, 1.0),
        at(-0.0, 1.0),
        at(1.0, 0.0),
        at(2.0, 0.0),
        at(2.0, 1.0),
        at(1.0, 1.0),
        // A vertex of no face.
        at(0.0, 0.0),
    ];
    let mut faces = Faces::new();
    [[0, 1, 2, 3], [4, 5, 6, 7]].iter().for_each(|face| faces.push(face));
    MeshBuilder { positions: positions.into(), faces, columns }.build().unwrap()
}

/// Places on faces have the line of the face, and others that of the vertex, whatever is between these lines.
#[test]
fn places_in_obj_tell_their_lines() {
    let text = "# two squares\nv 0 0 0\nv 1 0 0\nvt 0 0\nv 1 1 0\nv 0 1 0\n\nf 1 2 3 4\nv 1 0 0 \\\n1\nv 2 0 0\nv 2 1 0\n\
                v 1 1 0\np 5\nf 5 6 7 8\nf 1 4 3 2\n";
    let file = read_bytes(text.into(), Some(Format::Obj), None, &ReadOptions::default()).unwrap();
    let diagnosis = diagnose(&file, &Thresholds::default(), &|_| {});
    let lines = |kind: Kind| -> Vec<Option<u64>> {
        let reported = diagnosis.get(kind).unwrap_or_else(|| panic!("{kind:?} is not reported"));
        reported.places.iter().map(|site| site.line).collect()
    };
    assert_eq!(lines(Kind::DuplicateVertices), [Some(9), Some(13)]);
    assert_eq!(lines(Kind::BackToBack), [Some(16)]);
}

/// Without stored normals, each vertex that duplicates another is reported once; with normals, the seams between duplicates are.
#[test]
fn vertices_that_stand_twice_are_reported() {
    let vertices = |diagnosis: &Diagnosis| -> Vec<Option<u32>> {
        let reported = diagnosis.get(Kind::DuplicateVertices);
        reported.map_or(vec![], |finding| finding.places.iter().map(|site| site.vertex).collect())
    };
    let bare = inspect(&cut_strip(Columns::default()), 10);
    assert_eq!(vertices(&bare), [Some(4), Some(7)]);
    let reported = bare.get(Kind::DuplicateVertices).unwrap();
    assert_eq!((reported.count, reported.of, reported.severity), (2, 8, Severity::Note));

    let colors = (0..9).map(|vertex| [if vertex == 4 { 1.0 } else { 0.5 }, 0.0, 0.0, 1.0]).collect();
    let coloured = cut_strip(Columns { colors: Some(colors), ..Columns::default() });
    assert_eq!(vertices(&inspect(&coloured, 10)), [Some(7)], "another colour is a reason");
    let uvs = (0..9).map(|vertex| DVec2::splat(f64::from(u8::from(vertex == 7)))).collect();
    let mapped = cut_strip(Columns { uvs: Some(Column::per_vertex(uvs)), ..Columns::default() });
    assert_eq!(vertices(&inspect(&mapped, 10)), [Some(4)], "another place in the texture is a reason");
    let materials = FaceLabels { of_face: vec![0, 1], names: vec!["a".into(), "b".into()] };
    let painted = cut_strip(Columns { materials: Some(materials), ..Columns::default() });
    assert!(vertices(&inspect(&painted, 10)).is_empty(), "another material is a reason");

    let stored = cut_strip(Columns::default()).with_normals(Some(Column::per_vertex(vec![DVec3::Z; 9])));
    let diagnosis = inspect(&stored, 10);
    assert!(vertices(&diagnosis).is_empty() && diagnosis.get(Kind::NeedlessSeam).is_some());
    // Facets of STL cannot share vertices.
    let mut facets = loaded(cut_strip(Columns::default()));
    facets.format = Format::Stl;
    assert!(vertices(&diagnose(&facets, &Thresholds::default(), &|_| {})).is_empty());
}

/// Stored normals at corners of a face without area are neither right nor wrong.
#[test]
fn normals_of_faces_without_area_deviate_by_nothing() {
    let text =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nvn 0 0 1\nvn 0 -1 0\nf 1//1 2//1 3//1\nf 1//2 2//2 4//2\n";
    let file = read_bytes(text.into(), Some(Format::Obj), None, &ReadOptions::default()).unwrap();
    let deviations = &survey(&file)[0].deviations;
    assert_eq!(*deviations, [Some(0.0); 6]);
}

/// A finding on an empty document has no places, because there are no parts.
#[test]
fn no_faces_of_no_part_are_at_no_place() {
    let text = r#"{"asset": {"version": "2.0"}}"#;
    let file = read_bytes(text.into(), Some(Format::Gltf), None, &ReadOptions::default()).unwrap();
    let diagnosis = diagnose(&file, &Thresholds::default(), &|_| {});
    assert!(diagnosis.parts.is_empty());
    assert_eq!(diagnosis.get(Kind::NoFaces).map(|finding| finding.places.len()), Some(0));
}

/// A square of two triangles, with faces without area along its edges: these have the opposite winding and are more numerous, but
/// they are not visible.
#[test]
fn faces_without_area_have_no_say_in_winding() {
    let text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv .5 0 0\nv 1 .5 0\nv .5 1 0\nv 0 .5 0\nf 1 2 3\nf 1 3 4\n\
                f 1 2 5\nf 2 3 6\nf 3 4 7\nf 4 1 8\n";
    let file = read_bytes(text.into(), Some(Format::Obj), None, &ReadOptions::default()).unwrap();
    let diagnosis = diagnose(&file, &Thresholds::default(), &|_| {});
    assert!(diagnosis.get(Kind::InconsistentWinding).is_none());
    let mesh = &file.parts[0].mesh;
    let found = orient(mesh, &Topology::build(mesh, Weld::Exact), Orient::Consistent, Confidence::default());
    assert_eq!(found.reversed, [2, 3, 4, 5], "they are reversed nevertheless");
    // If no face has area, the majority decides.
    let text = "v 0 0 0\nv 1 0 0\nv .5 0 0\nv .25 0 0\nf 1 2 3\nf 1 2 4\nf 2 1 4\n";
    let file = read_bytes(text.into(), Some(Format::Obj), None, &ReadOptions::default()).unwrap();
    let diagnosis = diagnose(&file, &Thresholds::default(), &|_| {});
    assert!(diagnosis.get(Kind::InconsistentWinding).is_none());
}

/// Each node is reported on its own, although all of them show one mesh.
#[test]
fn nodes_are_identified_by_their_own_names() {
    let mut file = loaded(polygon(&[[0., 0., 0.], [1., 0., 0.], [0., 1., 0.]]));
    file.format = Format::Gltf;
    let scales = [[1., 1., 1.], [-1., 1., 1.], [1., -1., 1.], [1., 1., 0.]];
    let node = |(number, scale): (usize, &[f64; 3])| FileNode {
        number,
        name: String::new(),
        part: 0,
        world_from_part: DMat4::from_scale(DVec3::from(*scale)),
    };
    file.nodes = scales.iter().enumerate().map(node).collect();
    let diagnosis = diagnose(&file, &Thresholds::default(), &|_| {});
    let places = |kind: Kind| -> Vec<Option<u32>> {
        diagnosis.get(kind).unwrap().places.iter().map(|site| site.place).collect()
    };
    assert_eq!(places(Kind::MirroredNode), [Some(1), Some(2)]);
    assert_eq!(places(Kind::SingularNode), [Some(3)]);
}

/// Rounding to 13 bits changes a normal by less than the threshold, but shows in a sharp highlight: the material decides.
#[test]
fn glossy_materials_need_more_bits() {
    let torus = surface(&Surface::from(Torus::default()), [60, 30]);
    let exact = compute(&torus, &NormalRecipe::default()).normals;
    let values = exact.values.iter().map(|n| (*n * 4095.0).round() / 4095.0).collect();
    let file = loaded(torus.with_normals(Some(Column { values, ..exact })));
    let cause = |exponent: Option<f64>| {
        let diagnosis = diagnose(&file, &Thresholds { exponent, ..Thresholds::default() }, &|_| {});
        diagnosis.get(Kind::Quantised).map(|finding| finding.cause.english().to_owned())
    };
    assert_eq!(cause(None), None);
    assert_eq!(cause(Some(100.0)), None);
    assert!(
        cause(Some(10_000.0))
            .unwrap()
            .ends_with("the exponent 10000 of the material needs 16 bits a component")
    );
}

/// The back of one face of a ball is reported once, as such, and not as a component that faces inwards.
#[test]
fn the_back_of_a_face_is_no_component_inside_out() {
    let ball = surface(&Surface::from(Sphere::default()), [24, 12]);
    let mut faces = ball.faces().clone();
    let back: Vec<u32> = faces.face(100).iter().rev().copied().collect();
    faces.push(&back);
    let diagnosis = inspect(&rebuilt(ball.positions().to_vec(), faces), 10);
    assert_eq!(diagnosis.get(Kind::BackToBack).map(|finding| finding.count), Some(1));
    for kind in [Kind::OpenInsideOut, Kind::InsideOut, Kind::InconsistentWinding] {
        assert!(diagnosis.get(kind).is_none(), "{kind:?}");
    }
}

/// A needle is recognised by width over length, whatever the number, positions and order of its corners.
#[test]
fn polygons_are_needles_by_their_width() {
    // A strip of squares in a row as one polygon that begins at any corner, rotated out of all axes.
    let strip = |squares: usize, width: f64, first: usize| {
        let row = |y: f64| (0..=squares).map(move |i| [i as f64 / squares as f64, y * width, 0.0]);
        let mut corners: Vec<[f64; 3]> = row(0.0).chain(row(1.0).rev()).collect();
        corners.rotate_left(first);
        let turn = DMat3::from_rotation_y(0.7) * DMat3::from_rotation_x(1.1);
        polygon(&corners.iter().map(|&corner| (turn * DVec3::from(corner)).to_array()).collect::<Vec<_>>())
    };
    for (squares, first) in [(1, 0), (1, 3), (4, 0), (4, 2), (4, 7), (50, 31)] {
        for width in [1e-2, 1.01e-3, 0.99e-3, 1e-5] {
            let diagnosis = inspect(&strip(squares, width, first), 1);
            let finding = diagnosis.get(Kind::Needles);
            assert_eq!(finding.is_some(), width < 1e-3, "{squares}, {first}, {width}");
            let measured = finding.map(|finding| finding.amount.unwrap());
            // The length is that of the diagonal: longer by half the square of the width.
            assert!(measured.is_none_or(|it| (it / width - 1.0).abs() < 1e-6), "{measured:?} of {width}");
        }
    }
    let arrow = [[0., 0., 0.], [1., 1e-4, 0.], [2., 0., 0.], [1., 1., 0.]];
    assert!(inspect(&polygon(&arrow), 1).get(Kind::Needles).is_none());
}

/// Numbers in the cause cover the same parts as those of the finding: all parts, or the worst one.
#[test]
fn words_and_numbers_are_of_the_same_parts() {
    let ball = |radius: f64, segments| {
        let sphere = surface(&Surface::from(Sphere::new(radius).unwrap()), segments).with_normals(None);
        // Every face with vertices of its own: all edges could be merged.
        let corners = sphere.faces().corners();
        let positions = corners.iter().map(|&vertex| sphere.positions().at(vertex)).collect();
        let mut faces = Faces::new();
        sphere.faces().ranges().for_each(|range| faces.push(&range.map(|it| it as u32).collect::<Vec<_>>()));
        let mesh = rebuilt(positions, faces);
        let normals =
            compute(&mesh, &NormalRecipe { crease: Crease::OFF, ..NormalRecipe::default() }).normals;
        let merged = corners.len() - sphere.vertex_count();
        (Part { mesh: mesh.with_normals(Some(normals)), ..Part::default() }, merged)
    };
    // The first has more edges at fault, the second the worst ones.
    let [(fine, a), (coarse, b)] = [ball(1.0, [48, 24]), ball(3.0, [12, 6])];
    let file = Loaded { parts: vec![fine, coarse], ..loaded(Mesh::default()) };
    let diagnosis = diagnose(&file, &Thresholds::default(), &|_| {});
    let cause = |kind: Kind| diagnosis.get(kind).unwrap().cause.english();
    assert!(cause(Kind::NeedlessSeam).ends_with(&format!(": {} vertices could be merged", a + b)));
    for kind in [Kind::MachBands, Kind::CoarseOutline] {
        let finding = diagnosis.get(kind).unwrap();
        assert_eq!(finding.places[0].part, 1);
        assert!(
            finding.cause.english().contains(&format!("up to {} ", three_digits(finding.amount.unwrap()))),
            "{kind:?}"
        );
    }
}

/// A note in one part is not counted with the warnings in another and is not their worst place. The cause still mentions it,
/// because a command that fixes the warnings would change these places too.
#[test]
fn parts_where_it_matters_less_are_reported_next_to() {
    let part = |shape: &Surface, segments, pattern| {
        let tessellation = Tessellation { segments, pattern, ..Tessellation::default() };
        Part { mesh: shape.tessellate(&tessellation).unwrap(), ..Part::default() }
    };
    // The dual cuts the tip of the cone off, and a triangle of the other mesh hardly has the direction of the surface.
    let severe = || part(&Surface::from(Cone::default()), [64, 32], Pattern::Polygons);
    let milder = || part(&Surface::Catenoid(Catenoid::default()), [40, 24], Pattern::Marching);
    let found = |parts: Vec<Part>| {
        let file = Loaded { parts, ..loaded(Mesh::default()) };
        let diagnosis = diagnose(&file, &Thresholds::default(), &|_| {});
        diagnosis
            .get(Kind::AveragedCrease)
            .map(|it| (it.severity, it.count, it.cause.english().to_owned(), it.places[0].part))
    };
    let (grave, count, ..) = found(vec![severe()]).unwrap();
    let (mild, others, ..) = found(vec![milder()]).unwrap();
    assert_eq!((grave, mild), (Severity::Warning, Severity::Note));
    for (parts, part) in [(vec![severe(), milder()], 0), (vec![milder(), severe()], 1)] {
        let (severity, reported, cause, worst) = found(parts).unwrap();
        assert_eq!((severity, reported, worst), (Severity::Warning, count, part));
        assert!(
            cause.ends_with(&format!("not counted: {others} of lower severity in other submeshes")),
            "{cause}"
        );
    }
}
