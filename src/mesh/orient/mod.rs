//! Turning faces round until they agree.

mod cavities;
mod components;
mod nesting;
mod probe;
mod rooms;
mod visibility;
mod volume;

use super::{Mesh, Topology, vector_area};
use crate::num::unit_scale;
pub(crate) use cavities::{Placed, cavities};
use components::Components;
use rayon::prelude::*;
use rooms::{Role, Shell, roles};
use visibility::votes;

/// Which faces are turned round.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Orient {
    /// None.
    #[default]
    Keep,
    /// In each component the fewer ones that run against the rest; if there are as many of both kinds, those
    /// that run against the lowest face. Faces without area, such as fillers beside a vertex on an edge, do not count, however
    /// many they are: those of twice their area below a millionth of their longest edge squared. They turn with the others.
    Consistent,
    /// In each closed component the ones that do not face outwards, where it lies in an even number of other
    /// closed components, or inwards, as a cavity, where it lies in an odd number. A room faces inwards, and for what stands
    /// in it does not count: it is what faces inwards with most of its stored normals, round things of which at
    /// least half face outwards by theirs. In each component with a rim those that do not face the side from which more is
    /// seen of the world, if that is sure enough ([`Confidence`]). Others stay as they are.
    Outward,
}

/// What it has to be surer than which side of a component with a rim is its outer one, for it to be turned: from ½, a mere
/// majority, to 1, which no vote reaches.
///
/// Up to 64 points of the component are asked, each of which compares by 64 rays how much of the surroundings either side
/// sees (Takayama et al., JCGT 3(4), 2014) and has a vote if that differs by a quarter. With *a* votes of *b* for one side
/// the confidence is (a + 1)/(b + 2), Laplace's rule of succession. A plane has no votes: ½.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Confidence(pub f64);

impl Confidence {
    /// No component with a rim is turned.
    pub const NEVER: Self = Self(1.0);
}

impl Default for Confidence {
    fn default() -> Self {
        Self(0.9)
    }
}

/// What [`orient`] found.
///
/// A *component* is faces connected over edges that join exactly two of them, by vertex index or welded. It is
/// *closed* if, once its faces agree, their half-edges cancel at every edge. Faces of fewer than three distinct
/// places belong to none.
#[derive(Clone, Debug, Default, PartialEq, serde::Serialize)]
pub struct Orientation {
    /// The faces to turn round, ascending: [`FaceEdit::reversed`](super::FaceEdit::reversed).
    #[serde(skip)]
    pub reversed: Vec<u32>,
    /// Those of them that are of components with a rim, ascending ([`Orient::Outward`] only).
    #[serde(skip)]
    pub reversed_open: Vec<u32>,
    /// How many components there are.
    pub components: usize,
    /// Closed components whose faces can all be made to agree.
    pub closed: usize,
    /// Components with a rim of which it was sure enough which side is the outer one ([`Orient::Outward`] only).
    pub open_told: usize,
    /// The least confidence among those; 0 if there are none.
    #[serde(serialize_with = "null_if_zero")]
    pub confidence: f64,
    /// Components with a rim, left as they are because that was not sure ([`Orient::Outward`] only).
    pub open_left: usize,
    /// Components whose faces cannot all agree, as those of a Möbius strip; left as they are.
    pub non_orientable: usize,
    /// Closed components whose volume is not above its rounding error, as that of a sheet with two sides; left
    /// as they are, and taken to contain nothing ([`Orient::Outward`] only).
    pub flat: usize,
    /// Closed components for which it could not be told whether they lie in others: every point tried lies on
    /// the other's surface, or the search became too long. Left as they are ([`Orient::Outward`] only).
    pub undecided: usize,
    /// Closed components that had more than half of their faces turned round ([`Orient::Outward`] only).
    pub inside_out: usize,
    /// Components with a rim that had more than half of their faces turned round ([`Orient::Outward`] only).
    pub open_inside_out: usize,
    /// Closed components that lie in an odd number of others and now face inwards ([`Orient::Outward`] only).
    pub cavities: usize,
    /// Closed components that face inwards and stay so, as rooms ([`Orient::Outward`] only).
    pub rooms: usize,
    /// The faces of these, ascending.
    #[serde(skip)]
    pub room_faces: Vec<u32>,
}

/// No confidence, if there are no votes.
fn null_if_zero<S: serde::Serializer>(confidence: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    serde::Serialize::serialize(&Some(confidence).filter(|it| **it > 0.0), serializer)
}

/// Finds the faces to turn round so that neighbours agree and, if asked for, closed surfaces face outwards.
///
/// Welded edges count as connections, whatever else they separate. Outward is decided by signed volume, nesting
/// by rays from points of the inner surface; both hold at any size and any distance from the origin. Surfaces
/// that cut through each other are not nested. Stored normals, if there are any, tell rooms from what is inside out
/// ([`Orient::Outward`]); without them all is taken for solid.
///
/// Components with a rim are turned, by a vote of visibility, if its outcome is surer than `confidence`.
///
/// Linear in faces, and n log n in closed components that lie in the boxes of others and in faces where a component has a
/// rim; where faces overlap without end the search is cut short (see [`Orientation::undecided`]; such votes are not
/// taken). The result does not depend on the number of threads. [`Orient::Keep`] looks at nothing and leaves all counts
/// at 0.
///
/// ```
/// use crease::mesh::{Confidence, FaceEdit, Faces, MeshBuilder, Orient, Topology, Weld, orient};
/// use glam::DVec3;
///
/// // A tetrahedron with its last face turned round.
/// let mesh = MeshBuilder {
///     positions: vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z],
///     faces: Faces::triangles(vec![0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 3, 2]),
///     ..MeshBuilder::default()
/// }
/// .build()?;
/// let topology = Topology::build(&mesh, Weld::Exact);
/// let found = orient(&mesh, &topology, Orient::Outward, Confidence::default());
/// assert_eq!(found.reversed, [3]);
/// let mended = mesh.with_faces(&FaceEdit { reversed: found.reversed, ..FaceEdit::default() });
/// assert_eq!(mended.faces().face(3), [1, 2, 3]);
/// # Ok::<(), crease::mesh::MeshError>(())
/// ```
pub fn orient(mesh: &Mesh, topology: &Topology, policy: Orient, confidence: Confidence) -> Orientation {
    match policy {
        Orient::Keep => Orientation::default(),
        Orient::Consistent => Orientations::new(mesh, topology).consistent(mesh),
        Orient::Outward => Orientations::new(mesh, topology).outward(mesh, confidence, &[]),
    }
}

/// The components of a mesh, for whoever wants more than one orientation of it.
pub(crate) struct Orientations {
    components: Components,
    /// Those that are orientable, ascending: the closed ones, and the others.
    closed: Vec<usize>,
    open: Vec<usize>,
}

impl Orientations {
    pub(crate) fn new(mesh: &Mesh, topology: &Topology) -> Self {
        let components = Components::find(mesh, topology);
        let orientable: Vec<(usize, bool)> = (0..components.len())
            .into_par_iter()
            .filter(|&component| components.is_orientable(component))
            .map(|component| (component, components.is_closed(component, mesh, topology)))
            .collect();
        let of =
            |wanted: bool| orientable.iter().filter(|(_, closed)| *closed == wanted).map(|it| it.0).collect();
        Self { closed: of(true), open: of(false), components }
    }

    /// The faces of each component, ascending.
    pub(crate) fn components(&self) -> impl IndexedParallelIterator<Item = &[u32]> {
        (0..self.components.len()).into_par_iter().map(|component| self.components.faces(component))
    }

    /// What [`Orient::Consistent`] turns. Faces too thin to be seen have no say in which way is the other one: fillers beside
    /// vertices on edges may be many, and run as they like.
    pub(crate) fn consistent(&self, mesh: &Mesh) -> Orientation {
        /// Twice the area over the square of the longest edge: what is left of faces without area after rounding to single
        /// precision is below it.
        const THIN: f64 = 1e-6;
        let mut found = self.nothing();
        let scale = unit_scale(mesh.bounds().map_or(0.0, |(low, high)| (high - low).max_element()));
        let has_say = |face: u32| {
            let corners = mesh.faces().face(face as usize);
            let place = |i: usize| mesh.positions()[corners[i % corners.len()] as usize] * scale;
            let edges = (0..corners.len()).map(|i| (place(i + 1) - place(i)).length_squared());
            2.0 * vector_area(mesh, face as usize, scale).length() > THIN * edges.fold(0.0, f64::max)
        };
        for &component in self.closed.iter().chain(&self.open) {
            let minority = self.components.agrees_with_lowest(component, has_say);
            found.reversed.extend(self.faces(component, minority));
        }
        found.reversed.par_sort_unstable();
        found
    }

    /// What [`Orient::Outward`] turns, where some components, ascending, are known to lie [inside of another
    /// mesh](hollows()) as well as they lie in their own.
    pub(crate) fn outward(&self, mesh: &Mesh, confidence: Confidence, cavities: &[usize]) -> Orientation {
        let mut found = self.nothing();
        self.turn_closed(mesh, cavities, &mut found);
        self.turn_open(mesh, confidence, &mut found);
        found.reversed.extend_from_slice(&found.reversed_open);
        found.reversed.par_sort_unstable();
        found
    }

    /// Of faces to turn, ascending, those of each component that has more than half of its faces turned.
    pub(crate) fn inside_out(&self, reversed: &[u32]) -> Vec<Vec<u32>> {
        if reversed.is_empty() {
            return Vec::new();
        }
        let is_turned = |face: &u32| reversed.binary_search(face).is_ok();
        let turned = |component: usize| -> Vec<u32> {
            self.components.faces(component).iter().copied().filter(is_turned).collect()
        };
        let components = (0..self.components.len()).into_par_iter();
        let turned = components.map(|component| (component, turned(component)));
        turned
            .filter(|(component, faces)| self.is_inside_out(*component, faces.len()))
            .map(|it| it.1)
            .collect()
    }

    /// The counts of components, and no face turned.
    fn nothing(&self) -> Orientation {
        Orientation {
            components: self.components.len(),
            closed: self.closed.len(),
            non_orientable: self.components.len() - self.closed.len() - self.open.len(),
            ..Orientation::default()
        }
    }

    /// Either the faces of a component that run against its lowest one, or the others.
    fn faces(&self, component: usize, against: bool) -> impl Iterator<Item = u32> {
        let faces = self.components.faces(component).iter().copied();
        faces.filter(move |&face| self.components.against()[face as usize] == against)
    }

    /// Whether more than half of a component is turned, if so many are.
    fn is_inside_out(&self, component: usize, turned: usize) -> bool {
        2 * turned > self.components.faces(component).len()
    }

    fn turn_closed(&self, mesh: &Mesh, cavities: &[usize], found: &mut Orientation) {
        let shells = self.shells(mesh);
        found.flat = self.closed.len() - shells.len();
        for (&Shell { component, outward, .. }, role) in shells.iter().zip(roles(&shells, cavities)) {
            match role {
                Role::Unknown => {
                    found.undecided += 1;
                    continue;
                }
                Role::Cavity => found.cavities += 1,
                Role::Room => {
                    found.rooms += 1;
                    found.room_faces.extend_from_slice(self.components.faces(component));
                }
                Role::Solid => {}
            }
            let is_inward = role != Role::Solid;
            let before = found.reversed.len();
            // Faces that run with the lowest one are right as they are if they face outwards and should.
            found.reversed.extend(self.faces(component, outward != is_inward));
            found.inside_out += usize::from(self.is_inside_out(component, found.reversed.len() - before));
        }
        found.room_faces.par_sort_unstable();
    }

    fn turn_open(&self, mesh: &Mesh, confidence: Confidence, found: &mut Orientation) {
        let sure = |confidence_of: f64| confidence_of > confidence.0;
        if confidence >= Confidence::NEVER {
            found.open_left = self.open.len();
            return;
        }
        for (&component, vote) in self.open.iter().zip(votes(mesh, &self.components, &self.open)) {
            if !sure(vote.confidence) {
                found.open_left += 1;
                continue;
            }
            let least = if found.open_told == 0 { 1.0 } else { found.confidence };
            (found.open_told, found.confidence) = (found.open_told + 1, least.min(vote.confidence));
            let before = found.reversed_open.len();
            found.reversed_open.extend(self.faces(component, vote.outward));
            let turned = found.reversed_open.len() - before;
            found.open_inside_out += usize::from(self.is_inside_out(component, turned));
        }
        found.reversed_open.par_sort_unstable();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{FaceEdit, Faces, Link, MeshBuilder, Weld};
    use glam::DVec3;

    fn build(positions: Vec<DVec3>, faces: &[Vec<u32>]) -> Mesh {
        let mut list = Faces::new();
        faces.iter().for_each(|face| list.push(face));
        MeshBuilder { positions, faces: list, ..MeshBuilder::default() }.build().unwrap()
    }

    /// A sphere of 8·4ˡ triangles, facing outwards.
    fn sphere(levels: u32, centre: DVec3, radius: f64) -> Mesh {
        let axes = [DVec3::X, DVec3::Y, DVec3::Z];
        let mut positions: Vec<DVec3> = axes.iter().flat_map(|&axis| [axis, -axis]).collect();
        let mut faces: Vec<Vec<u32>> = Vec::new();
        for octant in 0..8u32 {
            let [x, y, z] = [octant & 1, octant >> 1 & 1, octant >> 2];
            let face = vec![x, 2 + y, 4 + z];
            faces.push(if (x + y + z) % 2 == 0 { face } else { face.into_iter().rev().collect() });
        }
        for _ in 0..levels {
            let mut middles = std::collections::BTreeMap::new();
            let mut middle = |a: u32, b: u32| {
                *middles.entry((a.min(b), a.max(b))).or_insert_with(|| {
                    positions.push((positions[a as usize] + positions[b as usize]).normalize());
                    positions.len() as u32 - 1
                })
            };
            faces = faces
                .iter()
                .flat_map(|face| {
                    let [a, b, c] = [face[0], face[1], face[2]];
                    let [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
                    [vec![a, ab, ca], vec![ab, b, bc], vec![ca, bc, c], vec![ab, bc, ca]]
                })
                .collect();
        }
        build(positions.into_iter().map(|p| centre + radius * p).collect(), &faces)
    }

    /// The eight corners of a box and its six quadrilaterals, facing outwards.
    fn cuboid(low: DVec3, high: DVec3) -> Mesh {
        let corner = |i: u32| {
            let pick = |bit: u32, axis: usize| if i >> bit & 1 == 1 { high[axis] } else { low[axis] };
            DVec3::new(pick(0, 0), pick(1, 1), pick(2, 2))
        };
        let sides = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        build((0..8).map(corner).collect(), &sides.map(|side| side.to_vec()))
    }

    fn union(meshes: &[Mesh]) -> Mesh {
        let (mut positions, mut faces) = (Vec::new(), Vec::new());
        for mesh in meshes {
            let first = positions.len() as u32;
            positions.extend_from_slice(mesh.positions());
            faces.extend(mesh.faces().iter().map(|face| face.iter().map(|v| v + first).collect()));
        }
        build(positions, &faces)
    }

    fn turned(mesh: &Mesh, reversed: impl IntoIterator<Item = u32>) -> Mesh {
        mesh.with_faces(&FaceEdit { reversed: reversed.into_iter().collect(), ..FaceEdit::default() })
    }

    fn mapped(mesh: &Mesh, map: impl Fn(DVec3) -> DVec3) -> Mesh {
        let faces: Vec<Vec<u32>> = mesh.faces().iter().map(<[u32]>::to_vec).collect();
        build(mesh.positions().iter().map(|&p| map(p)).collect(), &faces)
    }

    /// Every face with vertices of its own, as in an STL file.
    fn soup(mesh: &Mesh) -> Mesh {
        let positions = mesh.faces().corners().iter().map(|&v| mesh.positions()[v as usize]).collect();
        let faces: Vec<Vec<u32>> = mesh.faces().ranges().map(|r| r.map(|c| c as u32).collect()).collect();
        build(positions, &faces)
    }

    fn run(mesh: &Mesh, policy: Orient) -> Orientation {
        orient(mesh, &Topology::build(mesh, Weld::Exact), policy, Confidence::default())
    }

    fn inconsistent(mesh: &Mesh) -> usize {
        let topology = Topology::build(mesh, Weld::Exact);
        let half_edges = 0..mesh.faces().corner_count() as u32;
        half_edges.filter(|&h| matches!(topology.link(h), Link::Inconsistent(_))).count()
    }

    /// A strip of quadrilaterals round a ring, joined with a half turn or without.
    fn strip(half_turn: bool) -> Mesh {
        let count = 12;
        let positions = (0..2 * count)
            .map(|i| {
                let (turn, side) = (f64::from(i / 2) / f64::from(count), f64::from(i % 2) - 0.5);
                let (round, tilt) = (turn * std::f64::consts::TAU, turn * std::f64::consts::PI);
                let out = 2.0 + side * if half_turn { libm::cos(tilt) } else { 1.0 };
                let up = side * if half_turn { libm::sin(tilt) } else { 0.0 };
                DVec3::new(out * libm::cos(round), out * libm::sin(round), up)
            })
            .collect();
        let faces: Vec<Vec<u32>> = (0..count)
            .map(|i| {
                let (a, b) = (2 * i, 2 * i + 1);
                let last = i + 1 == count;
                let (c, d) = ((2 * i + 2) % (2 * count), (2 * i + 3) % (2 * count));
                if last && half_turn { vec![a, b, c, d] } else { vec![a, b, d, c] }
            })
            .collect();
        build(positions, &faces)
    }

    #[test]
    fn scattered_faces_are_turned_back() {
        let good = sphere(2, DVec3::ZERO, 1.0);
        assert!(run(&good, Orient::Outward).reversed.is_empty());
        for wrong in [vec![0], vec![3, 4, 5, 70], (0..60).map(|i| 2 * i).collect()] {
            let mesh = turned(&good, wrong.iter().copied());
            for policy in [Orient::Consistent, Orient::Outward] {
                let found = run(&mesh, policy);
                assert_eq!(found.reversed, wrong);
                assert_eq!((found.components, found.closed, found.inside_out), (1, 1, 0));
                assert_eq!(turned(&mesh, found.reversed), good);
            }
        }
        assert_eq!(run(&turned(&good, [1]), Orient::Keep), Orientation::default());
    }

    #[test]
    fn a_tie_goes_to_the_lowest_face() {
        let square = [[0., 0.], [1., 0.], [1., 1.], [0., 1.]].map(|[x, y]| DVec3::new(x, y, 0.0));
        let found = run(&build(square.to_vec(), &[vec![0, 1, 2], vec![2, 0, 3]]), Orient::Consistent);
        assert_eq!(found.reversed, [1]);
    }

    #[test]
    fn inside_out_surfaces_are_turned_as_a_whole() {
        let good = sphere(1, DVec3::ONE, 3.0);
        let mesh = turned(&good, (0..32).filter(|&face| face != 7));
        let found = run(&mesh, Orient::Outward);
        assert_eq!(turned(&mesh, found.reversed.iter().copied()), good);
        assert_eq!((found.inside_out, found.cavities), (1, 0));
        let found = run(&mesh, Orient::Consistent);
        assert_eq!(found.reversed, [7], "the fewer ones, whichever way the rest faces");
    }

    /// Neither a Möbius strip nor anything with a rim has an outside; a Möbius strip has not even two sides.
    #[test]
    fn surfaces_without_an_outside_stay() {
        let ring = turned(&strip(false), [4]);
        let found = run(&ring, Orient::Outward);
        assert_eq!((found.reversed.len(), found.open_left, found.components), (0, 1, 1));
        assert_eq!(run(&ring, Orient::Consistent).reversed, [4]);
        for mesh in [strip(true), turned(&strip(true), [2, 3])] {
            for policy in [Orient::Consistent, Orient::Outward] {
                let found = run(&mesh, policy);
                assert_eq!((found.reversed.len(), found.non_orientable, found.open_left), (0, 1, 0));
            }
        }
        let half = sphere(2, DVec3::ZERO, 1.0);
        let upper: Vec<Vec<u32>> = half
            .faces()
            .iter()
            .filter(|face| face.iter().all(|&v| half.positions()[v as usize].z >= 0.0))
            .map(<[u32]>::to_vec)
            .collect();
        let half = turned(&build(half.positions().to_vec(), &upper), [9]);
        let topology = Topology::build(&half, Weld::Exact);
        let found = orient(&half, &topology, Orient::Outward, Confidence::NEVER);
        assert_eq!((found.reversed.len(), found.open_left, found.closed), (0, 1, 0));
    }

    #[test]
    fn shells_alternate_with_depth() {
        let radii = [4.0, 3.0, 2.0, 1.0];
        let shells = radii.map(|radius| sphere(2, DVec3::new(0.3, 0.2, 0.1), radius));
        let next_to = sphere(1, DVec3::new(9.0, 0.0, 0.0), 2.0);
        let mesh = union(&[shells.to_vec(), vec![next_to]].concat());
        let found = run(&mesh, Orient::Outward);
        let cavities: Vec<u32> = (128..256).chain(384..512).collect();
        assert_eq!(found.reversed, cavities);
        assert_eq!((found.closed, found.inside_out, found.cavities), (5, 2, 2));
        let found = run(&turned(&mesh, cavities.iter().copied().chain([520])), Orient::Outward);
        assert_eq!((found.reversed.as_slice(), found.inside_out, found.cavities), (&[520][..], 0, 2));
    }

    /// Boxes on a grid: rays through corners and along walls, faces in one plane.
    #[test]
    fn boxes_that_share_planes_are_distinguished() {
        let cube = |low: [f64; 3], size: f64| cuboid(low.into(), DVec3::from(low) + size);
        let depths = |meshes: &[Mesh]| {
            let mesh = union(meshes);
            let found = orient(&mesh, &Topology::build(&mesh, Weld::Off), Orient::Outward, Confidence::NEVER);
            (found.cavities, found.undecided, found.reversed.len())
        };
        let big = cube([0.; 3], 4.0);
        assert_eq!(depths(&[big.clone(), cube([1.; 3], 1.0)]), (1, 0, 6), "inside");
        assert_eq!(depths(&[big.clone(), cube([4., 0., 0.], 4.0)]), (0, 0, 0), "wall to wall");
        assert_eq!(depths(&[big.clone(), cube([0.; 3], 1.0)]), (1, 0, 6), "inside, in a corner");
        assert_eq!(depths(&[big.clone(), cube([3., 1., 1.], 2.0)]), (0, 0, 0), "cutting through a wall");
        let plate = cuboid(DVec3::ZERO, DVec3::new(4.0, 4.0, 1.0));
        let rib = cuboid(DVec3::new(0.0, 0.0, 1.0), DVec3::new(1.0, 4.0, 4.0));
        assert_eq!(depths(&[plate, rib, cube([1.; 3], 1.0)]), (0, 0, 0), "in the hollow of an L");
        assert_eq!(depths(&[big.clone(), big]), (0, 2, 0), "twice the same");
    }

    /// A box that touches another along an edge is closed, though four faces meet there; a fin on its side is
    /// open and stays.
    #[test]
    fn shared_edges_do_not_open_a_surface() {
        let touching = union(&[
            cuboid(DVec3::ZERO, DVec3::ONE),
            cuboid(DVec3::new(1.0, 1.0, 0.0), DVec3::new(2.0, 2.0, 1.0)),
        ]);
        let found = run(&turned(&touching, 3..12), Orient::Outward);
        assert_eq!((found.components, found.closed), (2, 2));
        assert_eq!(found.reversed, (3..12).collect::<Vec<_>>());

        let cube = cuboid(DVec3::ZERO, DVec3::ONE);
        let mut positions = cube.positions().to_vec();
        positions.push(DVec3::new(-1.0, -1.0, 0.5));
        let mut faces: Vec<Vec<u32>> = cube.faces().iter().map(<[u32]>::to_vec).collect();
        faces.push(vec![0, 4, 8]);
        let found = run(&turned(&build(positions, &faces), 0..6), Orient::Outward);
        assert_eq!((found.closed, found.open_left), (1, 1));
        assert_eq!(found.reversed, [0, 1, 2, 3, 4, 5]);
    }

    #[test]
    fn a_sheet_with_two_sides_has_no_volume() {
        let corners = [DVec3::ZERO, DVec3::X, DVec3::new(0.3, 0.7, 0.1)];
        let found = run(&build(corners.to_vec(), &[vec![0, 1, 2], vec![0, 2, 1]]), Orient::Outward);
        assert_eq!((found.closed, found.flat, found.reversed.len()), (1, 1, 0));
        // Its two sides are cut along different diagonals, and what lies between is no inside.
        for height in [1e-9, -1e-9, 0.3, -0.3] {
            let corners = [DVec3::ZERO, DVec3::X, DVec3::new(1.0, 1.0, height), DVec3::Y];
            let sheet = build(corners.to_vec(), &[vec![0, 1, 2, 3], vec![3, 2, 1, 0]]);
            let found = run(&sheet, Orient::Outward);
            assert_eq!((found.closed, found.flat, found.reversed.len()), (1, 1, 0), "{height}");
        }
    }

    /// Edges of no length and faces of no area neither open a surface nor make components of their own.
    #[test]
    fn collapsed_faces_do_not_count() {
        let cube = cuboid(DVec3::ZERO, DVec3::ONE);
        let mut positions = cube.positions().to_vec();
        positions.push(positions[0]);
        let mut faces: Vec<Vec<u32>> = cube.faces().iter().map(<[u32]>::to_vec).collect();
        faces.push(vec![0, 1, 1]);
        faces.push(vec![0, 8, 1]);
        let mesh = soup(&build(positions, &faces));
        let found = run(&turned(&mesh, [5]), Orient::Outward);
        assert_eq!((found.components, found.closed, found.reversed.as_slice()), (1, 1, &[5][..]));
    }

    #[test]
    fn soups_are_oriented_over_welded_edges() {
        let shells = union(&[sphere(2, DVec3::ZERO, 2.0), sphere(1, DVec3::ZERO, 1.0)]);
        let wrong: Vec<u32> = (0..160).filter(|face| face % 7 == 3).collect();
        let mesh = turned(&soup(&shells), wrong.iter().copied());
        let found = run(&mesh, Orient::Outward);
        let mended = turned(&mesh, found.reversed);
        assert_eq!((found.components, found.closed, found.cavities), (2, 2, 1));
        assert_eq!(inconsistent(&mended), 0);
        assert!(inconsistent(&mesh) > 0);
        let right = turned(&soup(&shells), 128..160);
        let same_way = |a: &Mesh, b: &Mesh| {
            // Reversing keeps the first corner, and a soup's corners count up or down from it.
            (0..a.face_count()).all(|face| a.faces().face(face)[1] == b.faces().face(face)[1])
        };
        assert!(same_way(&mended, &right));
        let off = orient(&mesh, &Topology::build(&mesh, Weld::Off), Orient::Outward, Confidence::NEVER);
        assert_eq!((off.components, off.open_left), (160, 160));
    }

    /// Powers of two change nothing, however far they go; distance costs the digits of the file and no more.
    #[test]
    fn size_and_place_do_not_matter() {
        let shells = union(&[3.0, 2.0, 1.0].map(|radius| sphere(2, DVec3::new(0.1, 0.2, 0.3), radius)));
        let mesh = turned(&shells, [5, 130, 131, 300]);
        let expected = run(&mesh, Orient::Outward);
        assert_eq!((expected.closed, expected.cavities, expected.undecided), (3, 1, 0));
        for power in [-1020, -600, -100, 100, 600, 1021] {
            let scaled = mapped(&mesh, |p| p.to_array().map(|x| libm::scalbn(x, power)).into());
            assert_eq!(run(&scaled, Orient::Outward), expected, "2^{power}");
        }
        for away in [1e3, 1e7, 1e12] {
            let moved = mapped(&mesh, |p| p + away * DVec3::new(1.0, -0.7, 0.3));
            assert_eq!(run(&moved, Orient::Outward), expected, "{away:e}");
        }
        // A small pair of shells beside a huge thing.
        let small = mapped(&mesh, |p| p * 1e-60);
        let both = union(&[small, cuboid(DVec3::splat(10.0), DVec3::splat(1e60))]);
        assert_eq!(run(&both, Orient::Outward).reversed, expected.reversed);
    }

    #[test]
    fn numbering_does_not_matter() {
        let shells = union(&[3.0, 2.0, 1.0].map(|radius| sphere(2, DVec3::new(0.1, 0.2, 0.3), radius)));
        let mesh = turned(&shells, (0..384).filter(|face| face % 5 == 2));
        let found = run(&mesh, Orient::Outward);
        let count = mesh.face_count() as u32;
        // 5 and 384 have no common factor, nor have 7 and the number of vertices.
        let vertices = mesh.vertex_count() as u32;
        let old_face = |new: u32| new * 5 % count;
        let new_vertex = |old: u32| old * 7 % vertices;
        assert_ne!(vertices % 7, 0);
        let mut positions = vec![DVec3::ZERO; vertices as usize];
        for (old, &p) in mesh.positions().iter().enumerate() {
            positions[new_vertex(old as u32) as usize] = p;
        }
        let faces: Vec<Vec<u32>> = (0..count)
            .map(|new| mesh.faces().face(old_face(new) as usize).iter().map(|&v| new_vertex(v)).collect())
            .collect();
        let renumbered = run(&build(positions, &faces), Orient::Outward);
        let mut back: Vec<u32> = renumbered.reversed.iter().map(|&new| old_face(new)).collect();
        back.sort_unstable();
        assert_eq!(back, found.reversed);
        assert_eq!(Orientation { reversed: back, ..renumbered }, found);
    }

    #[test]
    fn any_number_of_threads_finds_the_same() {
        let shells = union(&[3.0, 2.0, 1.0].map(|radius| sphere(5, DVec3::new(0.1, 0.2, 0.3), radius)));
        let mesh = turned(&shells, (0..20_000).filter(|face| face % 11 == 2));
        let topology = Topology::build(&mesh, Weld::Exact);
        let with = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| orient(&mesh, &topology, Orient::Outward, Confidence::default()))
        };
        let one = with(1);
        assert_eq!((one.closed, one.cavities), (3, 1));
        assert!([2, 3, 8].iter().all(|&threads| with(threads) == one));
    }

    /// Each of n tetrahedra within all larger ones is a question of n² answers. Few get them all; of many, those
    /// that the budget leaves out are counted and stay.
    #[test]
    fn searches_without_end_are_cut_short() {
        let nested = |count: u32| {
            let tetrahedra: Vec<Mesh> = (0..count)
                .map(|i| {
                    let (low, size) = (DVec3::splat(-0.2 * f64::from(i)), f64::from(i + 1));
                    let corners = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z].map(|p| low + size * p);
                    build(corners.to_vec(), &[vec![0, 2, 1], vec![0, 1, 3], vec![0, 3, 2], vec![1, 2, 3]])
                })
                .collect();
            run(&union(&tetrahedra), Orient::Outward)
        };
        let few = nested(201);
        assert_eq!((few.closed, few.cavities, few.undecided), (201, 100, 0));
        let many = nested(30_000);
        assert!(many.undecided > 20_000, "{}", many.undecided);
        assert_eq!(many.reversed.len(), 4 * many.cavities);
        assert!(many.undecided + many.cavities < many.closed);
    }
}
