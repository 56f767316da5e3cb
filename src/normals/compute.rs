//! From a mesh and a recipe to a field of normals.

use crate::mesh::{Column, Mesh, PositionsRef, Topology};
use crate::normals::creases::dihedral_test::CreaseTest;
use crate::normals::creases::grouping::{Grouping, can_do_without_topology, of_triangles, on_topology};
use crate::normals::creases::hard_edges::applied_angle;
use crate::normals::creases::smooth_groups::{SlotCorners, SmoothGroups};
use crate::normals::faces::face_normals::FaceNormals;
use crate::normals::faces::shape::FaceState;
use crate::normals::fallback::fallback_normals::{FaceField, FallbackNormals, corner_faults, face_faults};
use crate::normals::fault::{Fault, FaultReason, Faults};
use crate::normals::field::{Extras, NearCancellation, NormalField, Summary};
use crate::normals::fits::progress::{FitCount, FitObserver, UNOBSERVED};
use crate::normals::fits::rings::FitRequest;
use crate::normals::fits::slot_fits::{Fits, fit_slots};
use crate::normals::recipe::{Groups, NormalRecipe, Precision, Weight};
use crate::normals::scratch::Scratch;
use crate::normals::sums::corner_sums::TermTable;
use crate::normals::sums::request::{SlotState, SumRequest, Sums};
use crate::normals::sums::single_precision::single_sums;
use crate::normals::sums::weighted_sums::{SumScratch, weighted_sums};
use crate::num::Degrees;
use crate::num::parallel;
use glam::DVec3;

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
///     positions: vec![DVec3::ZERO, DVec3::Y, DVec3::new(1.0, 0.0, 0.0), DVec3::new(0.0, 0.0, -1.0)].into(),
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
    compute_observed(mesh, recipe, extras, UNOBSERVED)
}

/// As [`compute_with`]; reports the progress of fits, which take a hundred times as long as sums.
pub fn compute_observed(
    mesh: &Mesh,
    recipe: &NormalRecipe,
    extras: Extras,
    observe: FitObserver<'_>,
) -> NormalField {
    compute_in(mesh, recipe, extras, &mut Scratch::once(), observe)
}

/// As [`compute_with`], in memory that has served before. The result is the same to the bit.
///
/// ```
/// use crease::mesh::{Faces, Mesh};
/// use crease::normals::{Extras, NormalRecipe, Scratch, Weight, compute_reusing};
/// use glam::DVec3;
///
/// let mesh = Mesh::new(vec![DVec3::ZERO, DVec3::X, DVec3::Y], Faces::triangles(vec![0, 1, 2]))?;
/// let mut scratch = Scratch::new();
/// for weight in [Weight::Area, Weight::Angle] {
///     let recipe = NormalRecipe { weight, ..NormalRecipe::default() };
///     let field = compute_reusing(&mesh, &recipe, Extras::NONE, &mut scratch);
///     assert_eq!(field.normals.values, [DVec3::Z; 3]);
/// }
/// # Ok::<(), crease::mesh::MeshError>(())
/// ```
pub fn compute_reusing(
    mesh: &Mesh,
    recipe: &NormalRecipe,
    extras: Extras,
    scratch: &mut Scratch,
) -> NormalField {
    compute_in(mesh, recipe, extras, scratch, UNOBSERVED)
}

fn compute_in(
    mesh: &Mesh,
    recipe: &NormalRecipe,
    extras: Extras,
    scratch: &mut Scratch,
    observe: FitObserver<'_>,
) -> NormalField {
    let is_plain = can_do_without_topology(mesh, recipe);
    let needs_faces =
        !is_plain || extras.face_normals || !matches!(CreaseTest::of(mesh, recipe), CreaseTest::None);
    let points = mesh.positions();
    let mut shape = Shape { points, faces: std::mem::take(&mut scratch.faces), more_rings: 0, observe };
    if needs_faces {
        shape.find_faces(mesh);
    } else {
        shape.faces.clear();
    }
    let all_counted = parallel::all(&shape.faces.state, |&state| state == FaceState::Counted);
    let plain = (is_plain && all_counted)
        .then(|| of_triangles(mesh, recipe, &shape.faces, extras.edge_counts, &mut scratch.groups));
    if scratch.serves_once {
        scratch.groups = Default::default();
    }
    if let Some(grouping) = plain.flatten() {
        let found = shape.sums(mesh, recipe, &grouping.groups, &mut scratch.sums);
        if found.is_clean {
            let (field, faces) = shape.field(mesh, recipe, extras, grouping, found, None);
            scratch.faces = faces;
            return field;
        }
    }
    if !needs_faces {
        shape.find_faces(mesh);
    }
    compute_shape(mesh, &Topology::build(mesh, recipe.weld), recipe, shape, extras, scratch)
}

/// As [`compute`], on a topology built before, with the welding that it was built with.
pub fn compute_on(mesh: &Mesh, topology: &Topology, recipe: &NormalRecipe) -> NormalField {
    let shape = Shape::new(mesh.positions(), mesh);
    compute_shape(mesh, topology, recipe, shape, Extras::ALL, &mut Scratch::new())
}

/// As [`compute_on`], but fits take one more ring of neighbours. The angle to the normals of [`compute_on`] estimates their error
/// on a surface without noise, as the error grows with the size of the neighbourhood.
pub fn compute_wider(mesh: &Mesh, topology: &Topology, recipe: &NormalRecipe) -> NormalField {
    let shape = Shape { more_rings: 1, ..Shape::new(mesh.positions(), mesh) };
    compute_shape(mesh, topology, recipe, shape, Extras::NONE, &mut Scratch::new())
}

/// As [`compute_on`], with the normals of faces that are there already.
pub(crate) fn compute_from(
    mesh: &Mesh,
    topology: &Topology,
    recipe: &NormalRecipe,
    faces: FaceField,
) -> NormalField {
    let (points, faces) = (mesh.positions(), faces.into_computed());
    let shape = Shape { points, faces, more_rings: 0, observe: UNOBSERVED };
    compute_shape(mesh, topology, recipe, shape, Extras::ALL, &mut Scratch::new())
}

fn compute_shape(
    mesh: &Mesh,
    topology: &Topology,
    recipe: &NormalRecipe,
    shape: Shape<'_>,
    extras: Extras,
    scratch: &mut Scratch,
) -> NormalField {
    let grouping = on_topology(mesh, topology, recipe, &shape.faces, extras.edge_counts);
    let sums = shape.sums(mesh, recipe, &grouping.groups, &mut scratch.sums);
    let (field, faces) = shape.field(mesh, recipe, extras, grouping, sums, Some(topology));
    scratch.faces = faces;
    field
}

/// A mesh in one of its shapes: its own, or a morph target's.
struct Shape<'a> {
    points: PositionsRef<'a>,
    faces: FaceNormals,
    /// Rings that fits take in addition.
    more_rings: usize,
    observe: FitObserver<'a>,
}

/// The sums of all slots.
struct SlotSums {
    sums: Sums,
    /// Whether every slot has a direction and every face adds to sums.
    is_clean: bool,
    fast_declined: bool,
}

impl<'a> Shape<'a> {
    fn new(points: PositionsRef<'a>, mesh: &Mesh) -> Self {
        let faces = FaceNormals::default();
        let mut shape = Self { points, faces, more_rings: 0, observe: UNOBSERVED };
        shape.find_faces(mesh);
        shape
    }

    fn find_faces(&mut self, mesh: &Mesh) {
        self.faces.fill(mesh.faces().view(), self.points);
    }

    /// The sum of every slot.
    fn sums(
        &self,
        mesh: &Mesh,
        recipe: &NormalRecipe,
        groups: &SmoothGroups,
        scratch: &mut SumScratch,
    ) -> SlotSums {
        let request = SumRequest {
            faces: mesh.faces().view(),
            positions: self.points,
            target: &groups.corner_slots(),
            slots: groups.slots,
            weight: if recipe.weight.is_fit() { Weight::Angle } else { recipe.weight },
            slivers: recipe.slivers,
        };
        let fast = recipe.precision == Precision::Fast;
        if let Some(members) = &groups.members {
            return SlotSums { sums: gather_sums(&request, members), is_clean: false, fast_declined: fast };
        }
        // A fit takes the mean of `faithful` for its frame.
        let is_fit = recipe.weight.is_fit();
        if let Some(sums) = (fast && !is_fit).then(|| single_sums(&request, scratch)).flatten() {
            return SlotSums { sums, is_clean: true, fast_declined: false };
        }
        let (sums, outcome) = weighted_sums(&request, scratch);
        let is_clean = outcome.all_good && outcome.unusual.is_empty();
        SlotSums { sums, is_clean, fast_declined: fast }
    }

    /// The field of a mesh in its own shape, and the memory of face normals that are not part of it. Without a topology, sums
    /// are clean.
    fn field(
        mut self,
        mesh: &Mesh,
        recipe: &NormalRecipe,
        extras: Extras,
        grouping: Grouping,
        sums: SlotSums,
        topology: Option<&Topology>,
    ) -> (NormalField, FaceNormals) {
        let Grouping { groups, edges, cone_declined } = grouping;
        let mut summary = Summary {
            edges: edges.counts,
            near_crease: edges.near,
            crease_chains: edges.chains(mesh.positions()),
            cone_declined,
            crease_degrees: applied_angle(mesh, recipe).map(|Degrees(angle)| angle),
            wide_clusters: topology.map_or(0, Topology::wide_clusters),
            faces_before_groups: faces_before_groups(mesh, recipe),
            referenced_vertices: groups.entry_vertex.chunk_by(|a, b| a == b).count(),
            fast_declined: sums.fast_declined,
            near_cancellation: near_cancellation(&sums.sums.state, &groups),
            ..Summary::default()
        };
        summary.splits = groups.entry_vertex.len() - summary.referenced_vertices;
        let mut faults = Faults { vertices: unreferenced(&groups.entry_vertex, mesh), ..Faults::default() };
        let Some(topology) = topology else {
            let field = NormalField {
                normals: Column::per_corner(groups.of_entries(sums.sums.unit), groups.corner_entry),
                entry_vertex: groups.entry_vertex,
                face_normals: match extras.face_normals {
                    true => std::mem::take(&mut self.faces.unit),
                    false => Vec::new(),
                },
                morph_normals: Vec::new(),
                faults,
                summary,
            };
            return (field, self.faces);
        };
        let shapes = 1 + mesh.columns().morph_targets.len();
        let count = FitCount::new(shapes * groups.slots, self.observe);
        let (values, fallbacks, fits) = self.entries(mesh, topology, recipe, &groups, sums.sums, &count);
        summary.quadric_fallbacks = fits.quadric.total();
        summary.jet_fallbacks = fits.jet;
        summary.choice = fits.choice;
        // All shapes of a mesh are smoothed alike.
        let recipe = &NormalRecipe { weight: fits.choice.map_or(recipe.weight, |it| it.weight), ..*recipe };
        let mut morph_normals = Vec::new();
        for target in &mesh.columns().morph_targets {
            let moved: Vec<DVec3> = mesh.positions().iter().zip(target).map(|(p, &by)| p + by).collect();
            // The sum of two f32 values need not be one.
            let shape = Shape::new(PositionsRef::F64(&moved), mesh);
            let sums = shape.sums(mesh, recipe, &groups, &mut SumScratch::default()).sums;
            let (mut normals, fallbacks, _) = shape.entries(mesh, topology, recipe, &groups, sums, &count);
            // A shape that loses a normal keeps that of the base: no displacement rather than an arbitrary one.
            summary.morph_fallbacks += fallbacks.len();
            for (entry, _) in fallbacks {
                normals[entry as usize] = values[entry as usize];
            }
            morph_normals.push(normals);
        }
        faults.faces = face_faults(&self.faces, recipe.slivers);
        faults.corners = corner_faults(&groups.corner_entry, &fallbacks);
        let field = NormalField {
            normals: Column::per_corner(values, groups.corner_entry),
            entry_vertex: groups.entry_vertex,
            face_normals: match extras.face_normals {
                true => {
                    let faces = std::mem::take(&mut self.faces);
                    FaceField::with_fallbacks(mesh, topology, faces).into_units()
                }
                false => Vec::new(),
            },
            morph_normals,
            faults,
            summary,
        };
        (field, self.faces)
    }

    /// The normal of every entry, from the sums of slots; the entries with a fallback normal, ascending, with the reason; and
    /// where fits failed.
    fn entries(
        &self,
        mesh: &Mesh,
        topology: &Topology,
        recipe: &NormalRecipe,
        groups: &SmoothGroups,
        mut sums: Sums,
        count: &FitCount<'_>,
    ) -> (Vec<DVec3>, Vec<(u32, FaultReason)>, Fits) {
        let target = groups.corner_slots();
        let mut fits = Fits::default();
        if recipe.weight.is_fit() {
            let by_slot;
            let group_corners = match &groups.members {
                Some(members) => members,
                None => {
                    by_slot = SlotCorners::by_slot(&target, sums.unit.len());
                    &by_slot
                }
            };
            let request = FitRequest {
                corner_vertices: mesh.faces().corners(),
                topology,
                positions: self.points,
                corner_group: &target,
                group_corners,
            };
            fits = fit_slots(request, recipe.weight, self.more_rings, &mut sums, count);
        }
        let mut fallbacks = FallbackNormals::new(mesh.faces().view(), topology, &self.faces);
        let fallbacks = fallbacks.for_slots(&target, &sums.state, |slot, normal| sums.unit[slot] = normal);
        let values = groups.of_entries(sums.unit);
        let entries = (0..values.len() as u32).filter(|_| !fallbacks.is_empty());
        let reason = |entry| {
            let found = fallbacks.binary_search_by_key(&groups.slot(entry), |&(slot, _)| slot).ok()?;
            Some((entry, fallbacks[found].1))
        };
        let fallbacks = entries.filter_map(reason).collect();
        (values, fallbacks, fits)
    }
}

/// Sums over explicit lists of corners: the cone rule, where a face counts in several groups.
fn gather_sums(request: &SumRequest, members: &SlotCorners) -> Sums {
    let table = TermTable::new(request);
    let mean = |terms: &mut Vec<_>, slot: usize| table.mean(members.row(slot as u32), terms);
    let (unit, state) = parallel::map_with(request.slots, Vec::new, mean).into_iter().unzip();
    Sums { unit, state }
}

fn near_cancellation(states: &[SlotState], groups: &SmoothGroups) -> NearCancellation {
    if parallel::all(states, |state| state.near_cancellation().is_none()) {
        return NearCancellation::default();
    }
    let entries = 0..groups.entry_vertex.len() as u32;
    NearCancellation::of(entries.filter_map(|entry| states[groups.slot(entry) as usize].near_cancellation()))
}

fn faces_before_groups(mesh: &Mesh, recipe: &NormalRecipe) -> usize {
    let smoothing = mesh.columns().smoothing.as_ref().filter(|_| recipe.groups == Groups::Honour);
    smoothing.map_or(0, |smoothing| smoothing.before_first)
}

/// The vertices that no entry belongs to.
fn unreferenced(entry_vertex: &[u32], mesh: &Mesh) -> Vec<Fault> {
    let mut entries = entry_vertex.iter().copied().peekable();
    let is_unused = |&vertex: &u32| {
        let mut used = false;
        while entries.next_if_eq(&vertex).is_some() {
            used = true;
        }
        !used
    };
    let unused = (0..mesh.vertex_count() as u32).filter(is_unused);
    unused.map(|index| Fault { index, reason: FaultReason::Unreferenced }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Columns, Faces, MeshBuilder, Positions, SmoothingGroups, Storage, Weld};
    use crate::normals::recipe::{Crease, HardEdges, Scope, Weight};
    use crate::num::test_numbers::Numbers;

    const CUBE: [[u32; 4]; 6] =
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];

    fn cube(columns: Columns) -> Mesh {
        let mut faces = Faces::new();
        CUBE.iter().for_each(|face| faces.push(face));
        let bit = |i: u32, b: u32| f64::from(i >> b & 1);
        let positions = (0..8).map(|i| DVec3::new(bit(i, 0), bit(i, 1), bit(i, 2))).collect();
        MeshBuilder { positions, faces, columns }.build().unwrap()
    }

    /// A UV sphere about z whose poles are rows of coincident vertices, as exporters of capsules write them.
    fn sphere_with_rows_at_poles(segments: u32, rings: u32, quads: bool) -> Mesh {
        let mut positions = Vec::new();
        for ring in 0..=rings {
            let (height, radius) = match ring {
                0 => (1.0, 0.0),
                ring if ring == rings => (-1.0, 0.0),
                _ => {
                    let (sin, cos) = libm::sincos(std::f64::consts::PI * f64::from(ring) / f64::from(rings));
                    (cos, sin)
                }
            };
            positions.extend((0..segments).map(|segment| {
                let (sin, cos) =
                    libm::sincos(std::f64::consts::TAU * f64::from(segment) / f64::from(segments));
                DVec3::new(radius * cos, radius * sin, height)
            }));
        }
        let mut faces = Faces::new();
        for (ring, segment) in (0..rings).flat_map(|ring| (0..segments).map(move |segment| (ring, segment))) {
            let vertex = |down: u32, right: u32| (ring + down) * segments + (segment + right) % segments;
            let [a, b, c, d] = [vertex(0, 0), vertex(1, 0), vertex(1, 1), vertex(0, 1)];
            match quads {
                true => faces.push(&[a, b, c, d]),
                false => [[a, b, c], [a, c, d]].iter().for_each(|face| faces.push(face)),
            }
        }
        MeshBuilder { positions: positions.into(), faces, ..MeshBuilder::default() }.build().unwrap()
    }

    /// Zero-area faces at a pole are no gap: all vertices there have the normal of the whole fan, and stay separate.
    #[test]
    fn fans_of_coincident_vertices_at_a_pole_are_one() {
        for (quads, weight) in
            [false, true].into_iter().flat_map(|quads| Weight::ALL.map(|weight| (quads, weight)))
        {
            let mesh = sphere_with_rows_at_poles(24, 12, quads);
            for crease in [Crease::OFF, Crease::Angle(Degrees(40.0))] {
                let recipe = NormalRecipe { crease, weight, ..NormalRecipe::default() };
                let field = compute(&mesh, &recipe);
                assert_eq!((field.summary.splits, field.faults.corners.len()), (0, 0), "{weight:?} {quads}");
                for (normal, &vertex) in field.normals.values.iter().zip(&field.entry_vertex) {
                    let position = mesh.position(vertex);
                    if position.x == 0.0 && position.y == 0.0 {
                        // The fan is symmetric: only rounding is left.
                        assert!(normal.distance(position) < 1e-12, "{weight:?} {quads}: {normal}");
                    }
                }
            }
            // A quadric finds the pole from any of its sides.
            if weight != Weight::Quadric {
                let recipe = NormalRecipe { weld: Weld::Off, weight, ..NormalRecipe::default() };
                let tilt = compute(&mesh, &recipe).normals.values[0].distance(DVec3::Z);
                assert!(tilt > 0.01, "{weight:?} {quads}: without welding each vertex has faces of its own");
            }
        }
    }

    /// One after the other in the same memory, larger and smaller, with and without topology.
    #[test]
    fn memory_that_has_served_before_changes_nothing() {
        let mut scratch = Scratch::new();
        let meshes = [
            sphere_with_rows_at_poles(24, 12, false),
            cube(Columns::default()),
            sphere_with_rows_at_poles(6, 2, false),
            sphere_with_rows_at_poles(24, 12, true),
        ];
        for mesh in meshes.iter().chain(meshes.iter().rev()) {
            for crease in [Crease::OFF, Crease::Angle(Degrees(40.0))] {
                for precision in [Precision::Fast, Precision::Faithful] {
                    for (weld, extras) in [(Weld::Exact, Extras::ALL), (Weld::Off, Extras::NONE)] {
                        let recipe = NormalRecipe { crease, precision, weld, ..NormalRecipe::default() };
                        let field = compute_reusing(mesh, &recipe, extras, &mut scratch);
                        assert_eq!(field, compute_with(mesh, &recipe, extras), "{recipe:?}");
                    }
                }
            }
        }
    }

    /// Creases cut the joined fan as they cut others: a pyramid of six sides whose tip is six vertices.
    #[test]
    fn creases_cut_the_fan_of_coincident_vertices() {
        let mesh = sphere_with_rows_at_poles(6, 2, false);
        let sharp =
            compute(&mesh, &NormalRecipe { crease: Crease::Angle(Degrees(20.0)), ..NormalRecipe::default() });
        for corner in 0..mesh.faces().corner_count() {
            let face = corner / 3;
            if sharp.face_normals[face].z > 0.0
                && !sharp.faults.faces.iter().any(|f| f.index as usize == face)
            {
                let vertex = mesh.faces().corners()[corner];
                let normal = sharp.normals.get(corner, vertex).unwrap();
                assert!(normal.distance(sharp.face_normals[face]) < 1e-12, "{corner}");
            }
        }
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
                let out = cube(Columns::default()).positions().at(vertex) - DVec3::splat(0.5);
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
                let p = |i: usize| cube(Columns::default()).positions().at(face[i]);
                (p(1) - p(0)).cross(p(2) - p(0))
            })
            .collect();
        let index = (0..24).map(|corner| corner / 4).collect();
        let mesh = cube(Columns { normals: Some(Column::per_corner(normals, index)), ..Columns::default() });
        let hard_edges = HardEdges { authored: true, ..HardEdges::default() };
        let recipe = NormalRecipe { crease: Crease::OFF, hard_edges, ..NormalRecipe::default() };
        assert_eq!(compute(&mesh, &recipe).summary.edges.marked, 12);
    }

    /// A fan around an apex far above a flat polygon sums to the polygon's vector area, wherever the apex is. Its sides nearly
    /// cancel, so that κ is about the height.
    #[test]
    fn sums_are_given_up_only_if_their_error_bound_is_large() {
        let mut numbers = Numbers::new(5);
        for (height, expected) in [
            (2e6, NearCancellation::default()),
            (1e9, NearCancellation { normals: 1, bound: 1e-5 }),
            (2e10, NearCancellation { normals: 1, bound: 1e-4 }),
            (1.5e11, NearCancellation { normals: 1, bound: 1e-3 }),
            (1e13, NearCancellation::default()),
        ] {
            let mut positions = vec![DVec3::new(0.3, -0.2, height)];
            positions.extend((0..8).map(|i| {
                let (sin, cos) =
                    libm::sincos(0.1 * numbers.unit() + f64::from(i) * std::f64::consts::FRAC_PI_4);
                DVec3::new(cos, sin, 0.0)
            }));
            let faces = (0..8).flat_map(|i| [0, 1 + i, 1 + (i + 1) % 8]).collect();
            let mesh = MeshBuilder {
                positions: positions.into(),
                faces: Faces::triangles(faces),
                ..MeshBuilder::default()
            };
            let recipe =
                NormalRecipe { crease: Crease::OFF, weight: Weight::Area, ..NormalRecipe::default() };
            let field = compute(&mesh.build().unwrap(), &recipe);
            let is_lost = height > 1e12;
            assert_eq!(
                Faults::count(&field.faults.corners, FaultReason::CancellingFan) > 0,
                is_lost,
                "{height}"
            );
            assert_eq!(field.summary.near_cancellation, expected, "{height}");
            let error = field.normals.values[0].distance(DVec3::Z);
            assert!(is_lost || error <= expected.bound.max(1e-6), "{height}: {error}");
        }
    }

    /// The two sides of a leaf cancel at every vertex that they share: the result is one of them, and is counted.
    #[test]
    fn cancelling_fans_get_a_unit_normal_and_a_fault() {
        let mesh = MeshBuilder {
            positions: vec![DVec3::ZERO, DVec3::X, DVec3::Y].into(),
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
            positions: vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::X * 2.0, DVec3::Z].into(),
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
        MeshBuilder { positions: positions.into(), faces, ..MeshBuilder::default() }.build().unwrap()
    }

    #[test]
    fn edges_next_to_a_face_without_a_say_are_counted_as_they_are_cut() {
        for gap in [0.0, 1e-15] {
            let field = compute(&floor_and_wall(gap), &NormalRecipe::default());
            // The floor meets the wall across the face between them, at every edge of that face.
            assert_eq!((field.summary.edges.smooth, field.summary.edges.crease), (0, 3), "{gap:e}");
            // At both ends the floor, the wall and the face between them have separate normals.
            assert_eq!(field.summary.splits, 4);
        }
        let flat = NormalRecipe { crease: Crease::Angle(Degrees(100.0)), ..NormalRecipe::default() };
        let field = compute(&floor_and_wall(0.0), &flat);
        assert_eq!((field.summary.edges.smooth, field.summary.edges.crease), (3, 0));
        let near = NormalRecipe { crease: Crease::Angle(Degrees(90.05)), ..NormalRecipe::default() };
        assert_eq!(compute(&floor_and_wall(0.0), &near).summary.near_crease, 3);
    }

    /// In text of two decimals the right angle of floor and wall is off by up to a degree. The edges between them are still near
    /// the crease angle, also across the face that is not counted.
    #[test]
    fn edges_next_to_a_face_without_a_say_are_near_within_what_digits_allow() {
        let exact = floor_and_wall(0.0);
        let (mut numbers, mut farthest) = (crate::num::test_numbers::Numbers::new(41), 0.0_f64);
        for _ in 0..30 {
            let [x, y, z, w] = [0; 4].map(|_| 2.0 * numbers.unit() - 1.0);
            let turn = glam::DQuat::from_xyzw(x, y, z, w).normalize();
            // An even last decimal, so that the middle of an edge is still in its middle.
            let round = |x: f64| format!("{:.2}", 0.02 * (50.0 * x).round()).parse::<f64>().unwrap();
            let mut positions: Vec<DVec3> = exact.positions().iter().map(|p| turn * (p * 3.0)).collect();
            positions.iter_mut().for_each(|p| *p = DVec3::from(p.to_array().map(round)));
            positions[4] = (positions[1] + positions[2]) * 0.5;
            // Enough digits to show that there are two decimals.
            positions.extend((1..9).map(|n| DVec3::splat(0.11 * f64::from(n))));
            let (faces, storage) = (exact.faces().clone(), Storage::F64);
            let rounded = MeshBuilder {
                positions: Positions::rounded(positions, storage),
                faces,
                ..MeshBuilder::default()
            };
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
            let mesh =
                MeshBuilder { positions: positions.into(), faces, ..MeshBuilder::default() }.build().unwrap();
            let crease = [Crease::OFF, Crease::Default, Crease::Angle(Degrees(0.0))][round % 3];
            let recipe = NormalRecipe { crease, ..NormalRecipe::default() };
            let expected = compute_on(&mesh, &Topology::build(&mesh, Weld::Exact), &recipe);
            assert_eq!(compute(&mesh, &recipe), expected);
            welded += usize::from(expected.summary.edges.welded > 0 && expected.faults.is_empty());
        }
        assert!(welded > 100, "{welded}");
    }
}
