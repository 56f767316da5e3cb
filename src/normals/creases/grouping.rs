//! The smooth groups that a recipe gives a mesh, and the edges counted on the way.
//!
//! Most meshes need no topology: edges are hard for nothing but their angle, and none is joined to another by position, or all
//! are. Then the corners at each vertex determine its groups.

use crate::mesh::{FacesRef, Mesh, Topology, Weld, joins_no_edges};
use crate::normals::creases::coordinate_rounding::turns_by_rounding;
use crate::normals::creases::dihedral_test::CreaseTest;
use crate::normals::creases::edge_counts::{FoundEdges, edge_counts};
use crate::normals::creases::fans::{FanWalker, MeshFans};
use crate::normals::creases::hard_edges::{Marks, applied_angle};
use crate::normals::creases::smooth_groups::SmoothGroups;
use crate::normals::creases::triangle_groups::{GroupMemory, TriangleCreases};
use crate::normals::faces::face_normals::FaceNormals;
use crate::normals::recipe::{CreaseRule, NormalRecipe, Scope};

/// Smooth groups, and what was counted on the way; see [`Summary`](crate::normals::Summary).
pub(in crate::normals) struct Grouping {
    pub(in crate::normals) groups: SmoothGroups,
    pub(in crate::normals) edges: FoundEdges,
    pub(in crate::normals) cone_declined: usize,
}

/// The groups of any mesh. Edges are counted if asked for.
pub(in crate::normals) fn on_topology(
    mesh: &Mesh,
    topology: &Topology,
    recipe: &NormalRecipe,
    normals: &FaceNormals,
    counts_edges: bool,
) -> Grouping {
    let marks = Marks::new(mesh, recipe);
    let faces = mesh.faces().view();
    let crease = CreaseTest::of(mesh, recipe);
    let walker = FanWalker {
        fans: MeshFans { faces, topology, marks: &marks },
        normals,
        crease,
        slivers: recipe.slivers,
    };
    let edges = match counts_edges {
        true => edge_counts(&walker, turns(mesh, &crease).as_deref()),
        false => FoundEdges::default(),
    };
    let (groups, cone_declined) = match (recipe.scope, recipe.rule) {
        (Scope::Vertex, _) => (SmoothGroups::per_vertex(faces, topology, mesh.vertex_count()), 0),
        (Scope::Corner, CreaseRule::Fan) => (SmoothGroups::by_fan(&walker, mesh.vertex_count()), 0),
        (Scope::Corner, CreaseRule::Cone) => SmoothGroups::by_cone(&walker, mesh.vertex_count()),
    };
    Grouping { groups, edges, cone_declined }
}

/// Whether a mesh has only triangles and the recipe asks for nothing that takes a topology.
pub(in crate::normals) fn can_do_without_topology(mesh: &Mesh, recipe: &NormalRecipe) -> bool {
    !recipe.weight.is_fit()
        && (recipe.scope, recipe.rule) == (Scope::Corner, CreaseRule::Fan)
        && matches!(recipe.weld, Weld::Exact | Weld::Off)
        && mesh.faces().is_triangles()
        && mesh.columns().morph_targets.is_empty()
        && Marks::new(mesh, recipe).is_empty()
}

/// The same of such a mesh, whose faces all add to sums, as the topology would give them. `None` if edges would be joined to
/// others by position. Face normals may be omitted if no edge is hard for its angle.
pub(in crate::normals) fn of_triangles(
    mesh: &Mesh,
    recipe: &NormalRecipe,
    normals: &FaceNormals,
    counts_edges: bool,
    memory: &mut GroupMemory,
) -> Option<Grouping> {
    let crease = CreaseTest::of(mesh, recipe);
    let turns = counts_edges.then(|| turns(mesh, &crease));
    let faces = mesh.faces().view();
    // Separate triangles meet where their positions are equal: numbering vertices by position joins all that welding would.
    let joined = (recipe.weld == Weld::Exact && mesh.is_soup()).then(|| mesh.first_vertices());
    let creases = TriangleCreases {
        faces: joined.as_ref().map_or(faces, |vertices| FacesRef::triangles(vertices.as_chunks().0)),
        normals,
        crease,
        slivers: recipe.slivers,
        counts: turns.as_ref().map(Option::as_deref),
    };
    let mut corner_slot = bytemuck::zeroed_vec(faces.corners().len());
    let (slots, found) = creases.entries(mesh.vertex_count(), memory, &mut corner_slot);
    let is_joined = joined.is_some();
    if recipe.weld == Weld::Exact && !is_joined && !joins_no_edges(mesh, &found.edges.open) {
        return None;
    }
    let groups = if is_joined {
        let own = || faces.corners().to_vec();
        SmoothGroups {
            corner_entry: own(),
            entry_vertex: own(),
            entry_slot: Some(corner_slot),
            slots,
            members: None,
        }
    } else {
        let entry_vertex = memory.entry_vertices(slots);
        SmoothGroups { corner_entry: corner_slot, entry_vertex, entry_slot: None, slots, members: None }
    };
    let edges = if counts_edges { found.finish(is_joined) } else { FoundEdges::default() };
    Some(Grouping { groups, edges, cone_declined: 0 })
}

/// By how many radians the rounding of coordinates may turn the normal of each face, if that matters to the test.
fn turns(mesh: &Mesh, crease: &CreaseTest) -> Option<Vec<f64>> {
    matches!(crease, CreaseTest::Over { .. }).then(|| turns_by_rounding(mesh)).flatten()
}

impl CreaseTest {
    /// The test that a recipe applies to a mesh.
    pub(in crate::normals) fn of(mesh: &Mesh, recipe: &NormalRecipe) -> Self {
        Self::new(applied_angle(mesh, recipe))
    }
}
