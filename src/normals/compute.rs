//! From a mesh and a recipe to a field of normals.

use crate::mesh::{Column, Mesh, Storage, Topology};
use crate::normals::creases::dihedral_test::CreaseTest;
use crate::normals::creases::edge_counts::edge_counts;
use crate::normals::creases::fans::{FanWalker, MeshFans};
use crate::normals::creases::hard_edges::{Marks, applied_angle};
use crate::normals::creases::smooth_groups::{SlotCorners, SmoothGroups};
use crate::normals::faces::face_normals::FaceNormals;
use crate::normals::faces::face_normals::face_normals;
use crate::normals::faces::field::FaceField;
use crate::normals::faces::positions::Positions;
use crate::normals::fallback::fallback_normals::{FallbackNormals, face_faults};
use crate::normals::fault::{Fault, FaultReason, Faults};
use crate::normals::field::{Extras, NormalField, Summary};
use crate::normals::fits::quadric::{QuadricRequest, quadric_normals};
use crate::normals::recipe::{CreaseRule, Groups, NormalRecipe, Precision, Scope, Weight};
use crate::normals::sums::corner_sums::TermTable;
use crate::normals::sums::request::{SlotState, SumRequest, Sums};
use crate::normals::sums::single_precision::single_sums;
use crate::normals::sums::weighted_sums::weighted_sums;
use crate::normals::triangle_field::{count_runs, triangle_field, turns, unreferenced};
use crate::num::Degrees;
use glam::DVec3;
use rayon::prelude::*;

/// Computes the normals of a mesh.
///
/// Builds the topology that the recipe's welding asks for; a caller that has it already uses [`compute_on`].
///
/// ```
/// use crease::mesh::{Faces, MeshBuilder};
/// use crease::normals::{NormalRecipe, compute};
/// use glam::DVec3;
///
/// // A ridge of 90° between two triangles: over the default crease angle, so each side keeps its own normal.
/// let mesh = MeshBuilder {
///     positions: vec![DVec3::ZERO, DVec3::Y, DVec3::new(1.0, 0.0, 0.0), DVec3::new(0.0, 0.0, -1.0)],
///     faces: Faces::triangles(vec![0, 2, 1, 0, 1, 3]),
///     ..MeshBuilder::default()
/// }
/// .build()?;
/// let field = compute(&mesh, &NormalRecipe::default());
/// assert_eq!(field.summary.splits, 2);
/// assert_eq!(field.normals.get(0, 0), Some(&DVec3::Z));
/// # Ok::<(), crease::mesh::MeshError>(())
/// ```
pub fn compute(mesh: &Mesh, recipe: &NormalRecipe) -> NormalField {
    compute_with(mesh, recipe, Extras::ALL)
}

/// As [`compute`], with only some of the extras.
pub fn compute_with(mesh: &Mesh, recipe: &NormalRecipe, extras: Extras) -> NormalField {
    let faces = match triangle_field(mesh, recipe, extras) {
        Ok(field) => return field,
        Err(faces) => faces,
    };
    let topology = Topology::build(mesh, recipe.weld);
    let faces = faces.map_or_else(
        || Shape::new(mesh.positions(), mesh, mesh.storage()),
        |faces| Shape::of(mesh.positions(), mesh.storage(), faces),
    );
    on_topology(mesh, &topology, recipe, faces, extras)
}

/// As [`compute`], on a topology built before, with the welding that it was built with.
pub fn compute_on(mesh: &Mesh, topology: &Topology, recipe: &NormalRecipe) -> NormalField {
    let shape = Shape::new(mesh.positions(), mesh, mesh.storage());
    on_topology(mesh, topology, recipe, shape, Extras::ALL)
}

/// As [`compute_on`], with the normals of faces that are there already.
pub(crate) fn compute_from(
    mesh: &Mesh,
    topology: &Topology,
    recipe: &NormalRecipe,
    faces: FaceField,
) -> NormalField {
    let shape = Shape::of(mesh.positions(), mesh.storage(), faces.into_computed());
    on_topology(mesh, topology, recipe, shape, Extras::ALL)
}

fn on_topology(
    mesh: &Mesh,
    topology: &Topology,
    recipe: &NormalRecipe,
    shape: Shape<'_>,
    extras: Extras,
) -> NormalField {
    let angle = applied_angle(mesh, recipe);
    let marks = Marks::new(mesh, recipe);
    let walker = FanWalker {
        fans: MeshFans { faces: mesh.faces().view(), topology, marks: &marks },
        normals: &shape.faces,
        crease: CreaseTest::new(angle),
        slivers: recipe.slivers,
    };
    let mut summary = Summary {
        crease_degrees: angle.map(|Degrees(angle)| angle),
        wide_clusters: topology.wide_clusters(),
        faces_before_groups: faces_before_groups(mesh, recipe),
        ..Summary::default()
    };
    if extras.edge_counts {
        (summary.edges, summary.near_crease) = edge_counts(&walker, turns(mesh, &walker.crease).as_deref());
    }
    let groups = match (recipe.scope, recipe.rule) {
        (Scope::Vertex, _) => SmoothGroups::per_vertex(mesh.faces().view(), topology, mesh.vertex_count()),
        (Scope::Corner, CreaseRule::Fan) => SmoothGroups::by_fan(&walker, mesh.vertex_count()),
        (Scope::Corner, CreaseRule::Cone) => {
            let (groups, declined) = SmoothGroups::by_cone(&walker, mesh.vertex_count());
            summary.cone_declined = declined;
            groups
        }
    };
    summary.referenced_vertices = count_runs(&groups.entry_vertex);
    summary.splits = groups.entry_vertex.len() - summary.referenced_vertices;

    let filled = shape.entries(mesh, topology, recipe, &groups);
    summary.quadric_fallbacks = filled.quadric_fallbacks;
    summary.fast_declined = filled.fast_declined;
    let mut morph_normals = Vec::new();
    for target in &mesh.columns().morph_targets {
        let moved: Vec<DVec3> = mesh.positions().iter().zip(target).map(|(&p, &by)| p + by).collect();
        // The sum of two f32 values need not be one.
        let mut normals = Shape::new(&moved, mesh, Storage::F64).entries(mesh, topology, recipe, &groups);
        // A shape that loses a normal keeps that of the base: no displacement rather than an arbitrary one.
        summary.morph_fallbacks += normals.fallbacks.len();
        for &(entry, _) in &normals.fallbacks {
            normals.values[entry as usize] = filled.values[entry as usize];
        }
        morph_normals.push(normals.values);
    }

    let faults = Faults {
        faces: face_faults(&shape.faces, recipe.slivers),
        corners: corner_faults(&groups.corner_entry, &filled.fallbacks),
        vertices: unreferenced(&groups.entry_vertex, mesh.vertex_count()),
    };
    NormalField {
        normals: Column::per_corner(filled.values, groups.corner_entry),
        entry_vertex: groups.entry_vertex,
        face_normals: match extras.face_normals {
            true => FaceField::with_fallbacks(mesh, topology, shape.faces).into_units(),
            false => Vec::new(),
        },
        morph_normals,
        faults,
        summary,
    }
}

/// A mesh in one of its shapes: its own, or a morph target's.
struct Shape<'a> {
    points: &'a [DVec3],
    positions: Positions<'a>,
    faces: FaceNormals,
}

impl<'a> Shape<'a> {
    fn new(points: &'a [DVec3], mesh: &Mesh, storage: Storage) -> Self {
        Self::of(points, storage, face_normals(mesh.faces().view(), Positions::F64(points, storage)))
    }

    fn of(points: &'a [DVec3], storage: Storage, faces: FaceNormals) -> Self {
        Self { points, positions: Positions::F64(points, storage), faces }
    }

    /// The normal of every entry.
    fn entries(
        &self,
        mesh: &Mesh,
        topology: &Topology,
        recipe: &NormalRecipe,
        groups: &SmoothGroups,
    ) -> Entries {
        let target = groups.corner_slots();
        let request = SumRequest {
            faces: mesh.faces().view(),
            positions: self.positions,
            target: &target,
            slots: groups.entry_vertex.len(),
            weight: recipe.weight,
            slivers: recipe.slivers,
        };
        let members = groups.members.as_ref();
        let fast = recipe.precision == Precision::Fast;
        let single = (fast && members.is_none()).then(|| single_sums(&request)).flatten();
        let fast_declined = fast && single.is_none();
        let mut sums = single.unwrap_or_else(|| match members {
            None => weighted_sums(&request),
            Some(members) => gather_sums(&request, members),
        });
        let quadric_fallbacks = if recipe.weight == Weight::Quadric {
            self.fit_quadrics(mesh, topology, &target, groups, &mut sums)
        } else {
            0
        };
        let mut fallbacks = FallbackNormals::new(mesh.faces().view(), topology, &self.faces);
        let fallbacks = fallbacks.for_slots(&target, &sums.state, |slot, normal| sums.unit[slot] = normal);
        let values = match &groups.entry_slot {
            None => sums.unit,
            Some(slots) => slots.iter().map(|&slot| sums.unit[slot as usize]).collect(),
        };
        let reason =
            |slot: u32| fallbacks.binary_search_by_key(&slot, |&(s, _)| s).ok().map(|i| fallbacks[i].1);
        let entries = (0..values.len() as u32).filter(|_| !fallbacks.is_empty());
        let fallbacks = entries.filter_map(|e| reason(groups.slot(e)).map(|reason| (e, reason))).collect();
        Entries { values, fallbacks, quadric_fallbacks, fast_declined }
    }

    /// Replaces means by the normals of quadrics where there is a fit. Gives the number of slots without one.
    fn fit_quadrics(
        &self,
        mesh: &Mesh,
        topology: &Topology,
        target: &[u32],
        groups: &SmoothGroups,
        sums: &mut Sums,
    ) -> usize {
        let by_slot;
        let members = match &groups.members {
            Some(members) => members,
            None => {
                by_slot = SlotCorners::by_slot(target, sums.unit.len());
                &by_slot
            }
        };
        // What is left of a cancelling sum is no frame to fit in.
        for (unit, _) in sums.unit.iter_mut().zip(&sums.state).filter(|(_, state)| **state != SlotState::Good)
        {
            *unit = DVec3::ZERO;
        }
        let request = QuadricRequest {
            corner_vertices: mesh.faces().corners(),
            topology,
            positions: self.points,
            corner_group: target,
            group_corners: members,
        };
        quadric_normals(request, &mut sums.unit)
    }
}

/// Sums over explicit lists of corners: the cone rule, where a face counts in several groups.
fn gather_sums(request: &SumRequest, members: &SlotCorners) -> Sums {
    let table = TermTable::new(request);
    let slots = (0..request.slots as u32).into_par_iter();
    let (unit, state) = slots.map_init(Vec::new, |terms, slot| table.mean(members.row(slot), terms)).unzip();
    Sums { unit, state }
}

/// The normals of all entries.
struct Entries {
    values: Vec<DVec3>,
    /// Entries with a fallback normal, ascending, with the reason.
    fallbacks: Vec<(u32, FaultReason)>,
    quadric_fallbacks: usize,
    fast_declined: bool,
}

fn faces_before_groups(mesh: &Mesh, recipe: &NormalRecipe) -> usize {
    let smoothing = mesh.columns().smoothing.as_ref().filter(|_| recipe.groups == Groups::Honour);
    smoothing.map_or(0, |smoothing| smoothing.before_first)
}

/// The corners of entries with a fallback normal, with the reason.
fn corner_faults(corner_entry: &[u32], fallbacks: &[(u32, FaultReason)]) -> Vec<Fault> {
    if fallbacks.is_empty() {
        return Vec::new();
    }
    let reason =
        |entry: u32| fallbacks.binary_search_by_key(&entry, |&(e, _)| e).ok().map(|i| fallbacks[i].1);
    let corners = corner_entry.iter().enumerate();
    corners.filter_map(|(c, &entry)| reason(entry).map(|reason| Fault { index: c as u32, reason })).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Columns, Faces, MeshBuilder, SmoothingGroups, Weld};
    use crate::normals::recipe::{Crease, HardEdges, Weight};
    use crate::num::test_numbers::Numbers;

    const CUBE: [[u32; 4]; 6] =
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];

    fn cube(columns: Columns) -> Mesh {
        let mut faces = Faces::new();
        CUBE.iter().for_each(|face| faces.push(face));
        let bit = |i: u32, b: u32| f64::from(i >> b & 1);
        let positions = (0..8).map(|i| DVec3::new(bit(i, 0), bit(i, 1), bit(i, 2))).collect();
        MeshBuilder { positions, faces, columns, ..MeshBuilder::default() }.build().unwrap()
    }

    #[test]
    fn a_cube_is_sharp_by_default_and_round_without_creases() {
        let sharp = compute(&cube(Columns::default()), &NormalRecipe::default());
        assert_eq!((sharp.summary.edges.crease, sharp.summary.splits), (12, 16));
        assert!(sharp.faults.is_empty());
        for weight in Weight::ALL {
            let recipe = NormalRecipe { crease: Crease::OFF, weight, ..NormalRecipe::default() };
            let round = compute(&cube(Columns::default()), &recipe);
            assert_eq!((round.summary.edges.smooth, round.summary.splits), (12, 0));
            for (normal, &vertex) in round.normals.values.iter().zip(&round.entry_vertex) {
                let out = cube(Columns::default()).positions()[vertex as usize] - DVec3::splat(0.5);
                // Every weight gives three equal shares; what remains is rounding.
                assert!((*normal - out.normalize()).length() < 1e-15, "{weight:?} {normal}");
            }
        }
    }

    #[test]
    fn smoothing_groups_decide_alone_unless_an_angle_is_typed() {
        // All sides in group 1 but the last, which is off.
        let smoothing = SmoothingGroups { of_face: vec![1, 1, 1, 1, 1, 0], before_first: 0 };
        let mesh = cube(Columns { smoothing: Some(smoothing), ..Columns::default() });
        let by_groups = compute(&mesh, &NormalRecipe::default());
        assert_eq!((by_groups.summary.edges.marked, by_groups.summary.edges.crease), (4, 0));
        assert_eq!((by_groups.summary.splits, by_groups.summary.crease_degrees), (4, None));
        let typed = NormalRecipe { crease: Crease::Angle(Degrees(40.0)), ..NormalRecipe::default() };
        assert_eq!(compute(&mesh, &typed).summary.edges.crease, 8);
        let ignored = NormalRecipe { groups: Groups::Ignore, ..NormalRecipe::default() };
        assert_eq!(compute(&mesh, &ignored).summary.edges.crease, 12);
    }

    #[test]
    fn listed_edges_are_hard_and_one_normal_a_vertex_ignores_them() {
        let mesh = cube(Columns { hard_edges: vec![[1, 0], [0, 2], [0, 4]], ..Columns::default() });
        let recipe = NormalRecipe { crease: Crease::OFF, ..NormalRecipe::default() };
        assert_eq!(compute(&mesh, &recipe).summary.splits, 2);
        let per_vertex = NormalRecipe { scope: Scope::Vertex, ..recipe };
        assert_eq!(compute(&mesh, &per_vertex).summary.splits, 0);
    }

    #[test]
    fn stored_normals_can_mark_edges() {
        let normals: Vec<DVec3> = CUBE
            .iter()
            .map(|face| {
                let p = |i: usize| cube(Columns::default()).positions()[face[i] as usize];
                (p(1) - p(0)).cross(p(2) - p(0))
            })
            .collect();
        let index = (0..24).map(|corner| corner / 4).collect();
        let mesh = cube(Columns { normals: Some(Column::per_corner(normals, index)), ..Columns::default() });
        let hard_edges = HardEdges { authored: true, ..HardEdges::default() };
        let recipe = NormalRecipe { crease: Crease::OFF, hard_edges, ..NormalRecipe::default() };
        assert_eq!(compute(&mesh, &recipe).summary.edges.marked, 12);
    }

    /// The two sides of a leaf cancel at every vertex that they share: the result is one of them, and is counted.
    #[test]
    fn cancelling_fans_get_a_unit_normal_and_a_fault() {
        let mesh = MeshBuilder {
            positions: vec![DVec3::ZERO, DVec3::X, DVec3::Y],
            faces: Faces::triangles(vec![0, 1, 2, 2, 1, 0]),
            ..MeshBuilder::default()
        }
        .build()
        .unwrap();
        let recipe = NormalRecipe { crease: Crease::OFF, weld: Weld::Off, ..NormalRecipe::default() };
        let leaf = compute(&mesh, &recipe);
        assert_eq!(leaf.normals.values, [DVec3::NEG_Z; 3], "the first by value");
        assert_eq!(Faults::count(&leaf.faults.corners, FaultReason::CancellingFan), 6);
    }

    #[test]
    fn unused_vertices_and_empty_faces_are_counted() {
        let mesh = MeshBuilder {
            positions: vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::X * 2.0, DVec3::Z],
            faces: Faces::triangles(vec![0, 1, 2, 0, 3, 1]),
            ..MeshBuilder::default()
        }
        .build()
        .unwrap();
        let field = compute(&mesh, &NormalRecipe::default());
        assert_eq!(field.faults.vertices, [Fault { index: 4, reason: FaultReason::Unreferenced }]);
        assert_eq!(field.faults.faces, [Fault { index: 1, reason: FaultReason::ZeroArea }]);
        // The empty face borrows the normal of its neighbour.
        assert_eq!(field.face_normals, [DVec3::Z; 2]);
        assert!(field.normals.values.iter().all(|&normal| normal == DVec3::Z));
    }

    /// A floor and a wall at 90°, and between them a face so thin that it adds nothing, or has no area at all.
    fn floor_and_wall(gap: f64) -> Mesh {
        let mut faces = Faces::new();
        let corners: [&[u32]; 3] = [&[0, 1, 2, 3], &[1, 4, 2], &[5, 6, 2, 4, 1]];
        corners.iter().for_each(|face| faces.push(face));
        let positions = [
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [1.0, 1.0, 0.0],
            [0.0, 1.0, 0.0],
            [1.0 - gap, 0.5, 0.0],
            [1.0, 0.0, -1.0],
            [1.0, 1.0, -1.0],
        ];
        let positions = positions.map(DVec3::from).to_vec();
        MeshBuilder { positions, faces, ..MeshBuilder::default() }.build().unwrap()
    }

    #[test]
    fn edges_next_to_a_face_without_a_say_are_counted_as_they_are_cut() {
        for gap in [0.0, 1e-15] {
            let field = compute(&floor_and_wall(gap), &NormalRecipe::default());
            // The floor meets the wall across the face between them, at every edge of that face.
            assert_eq!((field.summary.edges.smooth, field.summary.edges.crease), (0, 3), "{gap:e}");
            // At both ends the floor, the wall and the face between them go apart.
            assert_eq!(field.summary.splits, 4);
        }
        let flat = NormalRecipe { crease: Crease::Angle(Degrees(100.0)), ..NormalRecipe::default() };
        let field = compute(&floor_and_wall(0.0), &flat);
        assert_eq!((field.summary.edges.smooth, field.summary.edges.crease), (3, 0));
        let near = NormalRecipe { crease: Crease::Angle(Degrees(90.05)), ..NormalRecipe::default() };
        assert_eq!(compute(&floor_and_wall(0.0), &near).summary.near_crease, 3);
    }

    /// In text of two decimals the right angle of floor and wall is off by up to a degree: the edges between them are near
    /// it all the same, also across the face without a say.
    #[test]
    fn edges_next_to_a_face_without_a_say_are_near_within_what_digits_allow() {
        let exact = floor_and_wall(0.0);
        let (mut numbers, mut farthest) = (crate::num::test_numbers::Numbers::new(41), 0.0_f64);
        for _ in 0..30 {
            let [x, y, z, w] = [0; 4].map(|_| 2.0 * numbers.unit() - 1.0);
            let turn = glam::DQuat::from_xyzw(x, y, z, w).normalize();
            // An even last decimal, so that the middle of an edge is still in its middle.
            let round = |x: f64| format!("{:.2}", 0.02 * (50.0 * x).round()).parse::<f64>().unwrap();
            let mut positions: Vec<DVec3> = exact.positions().iter().map(|&p| turn * (p * 3.0)).collect();
            positions.iter_mut().for_each(|p| *p = DVec3::from(p.to_array().map(round)));
            positions[4] = (positions[1] + positions[2]) * 0.5;
            // Digits enough to tell that there are two decimals.
            positions.extend((1..9).map(|n| DVec3::splat(0.11 * f64::from(n))));
            let (faces, storage) = (exact.faces().clone(), Storage::F64);
            let rounded = MeshBuilder { positions, storage, faces, ..MeshBuilder::default() };
            let right = NormalRecipe { crease: Crease::Angle(Degrees(90.0)), ..NormalRecipe::default() };
            let field = compute(&rounded.build().unwrap(), &right);
            assert_eq!(field.summary.near_crease, 3);
            let [floor, _, wall] = field.face_normals[..] else { panic!("three faces") };
            farthest = farthest.max((Degrees::from(crate::num::angle_between(floor, wall)).0 - 90.0).abs());
        }
        assert!(farthest > 0.2, "not near but for the digits: {farthest}");
    }

    #[test]
    fn slivers_that_count_decide_creases_too() {
        let recipe = NormalRecipe { slivers: crate::normals::Slivers::Keep, ..NormalRecipe::default() };
        let field = compute(&floor_and_wall(1e-15), &recipe);
        // The sliver is folded under the floor: a crease to it and to the wall, at its lone corner too.
        assert_eq!((field.summary.edges.smooth, field.summary.edges.crease), (0, 3));
        let of_sliver = [4, 5, 6].map(|corner| *field.normals.get(corner, 0).unwrap());
        assert_eq!(of_sliver, [DVec3::NEG_Z; 3]);
    }

    /// Separate triangles take a way of their own; counts and normals are those that the topology gives.
    #[test]
    fn separate_triangles_give_what_their_topology_gives() {
        let mut numbers = Numbers::new(7);
        let mut welded = 0;
        for round in 0..3000 {
            let mut coordinate =
                || f64::from(numbers.below(7) as u8) * if round % 2 == 0 { 1.0 } else { -0.1 };
            let places: Vec<DVec3> =
                (0..4 + round % 5).map(|_| DVec3::new(coordinate(), coordinate(), coordinate())).collect();
            let corners = 3 * (2 + numbers.below(5));
            let positions: Vec<DVec3> = (0..corners).map(|_| places[numbers.below(places.len())]).collect();
            let faces = Faces::triangles((0..corners as u32).collect());
            let mesh = MeshBuilder { positions, faces, ..MeshBuilder::default() }.build().unwrap();
            let crease = [Crease::OFF, Crease::Default, Crease::Angle(Degrees(0.0))][round % 3];
            let recipe = NormalRecipe { crease, ..NormalRecipe::default() };
            let expected = compute_on(&mesh, &Topology::build(&mesh, Weld::Exact), &recipe);
            assert_eq!(compute(&mesh, &recipe), expected);
            welded += usize::from(expected.summary.edges.welded > 0 && expected.faults.is_empty());
        }
        assert!(welded > 100, "{welded}");
    }
}
