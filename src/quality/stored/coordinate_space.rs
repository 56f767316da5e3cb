//! Whether stored normals are in another space of the node tree than their positions.

use crate::io::{FileNode, Loaded, NodeTree};
use crate::mesh::{Mesh, normal_matrix};
use crate::num::{Degrees, UnitVec3, angle_between};
use crate::quality::catalogue::Kind;
use crate::quality::counts::{Remark, Tallies};
use crate::quality::estimate::recipe::Estimate;
use crate::quality::facts::{Facts, Significance};
use crate::quality::stored::rotated::{explains, least, worst};
use crate::quality::thresholds::Thresholds;
use glam::{DMat3, DVec3};
use std::cell::OnceCell;
use std::ops::Range;

/// The nodes of a file, looked at when a part first asks.
pub(in crate::quality) struct Spaces<'a> {
    loaded: &'a Loaded,
    tree: OnceCell<Option<NodeTree<'a>>>,
}

impl<'a> Spaces<'a> {
    pub(in crate::quality) fn new(loaded: &'a Loaded) -> Self {
        Self { loaded, tree: OnceCell::new() }
    }

    fn tree(&self) -> Option<&NodeTree<'a>> {
        self.tree.get_or_init(|| self.loaded.node_tree()).as_ref()
    }

    /// What is most likely wrong with the matrices of the nodes that place a mesh, if anything may be.
    pub(in crate::quality) fn mistaken(
        &self,
        facts: &Facts<'_>,
        nodes: &[&FileNode],
        thresholds: &Thresholds,
    ) -> Option<Mistaken> {
        /// Places of a mesh in the world that are looked at.
        const PLACES: usize = 32;
        facts.stored?;
        let of_node = |node: &&FileNode| Chain::new(node, self.tree()).mistakes(thresholds.rotation);
        let mistakes: Vec<Vec<Mistake>> = nodes.iter().take(PLACES).map(of_node).collect();
        if mistakes.iter().all(Vec::is_empty) {
            return None;
        }
        let all = Agreement::new(facts, 1);
        // No matrix explains what is not wrong.
        if 1.0 - all.either_way <= least(thresholds) {
            return None;
        }
        let (mistake, is_only) = most_like(facts, &mistakes)?;
        let with = all.with(mistake.map)?;
        let is_certain =
            explains(with, all.either_way, thresholds) && all.by_turn - with <= least(thresholds);
        if !is_certain && with <= all.as_stored {
            return None;
        }
        let or = if is_only { "" } else { ", or something else that these matrices do not tell from it" };
        let reported = mistake.reported(|node| self.tree().map(|tree| tree.name(node)));
        Some(Mistaken {
            taken_back: taken_back(facts.mesh, mistake.map),
            turn: mistake.turn,
            reported: reported.map(|reported| reported + or),
            is_certain,
        })
    }
}

/// Stored normals that matrices of nodes seem to stand between and the mesh.
pub(in crate::quality) struct Mistaken {
    /// The mesh with its stored normals in its own space.
    pub(in crate::quality) taken_back: Mesh,
    /// How far the matrices turn normals at most, in degrees.
    turn: f64,
    /// What is wrong with which node's matrix.
    reported: Option<String>,
    /// Whether the normals agree so well with the faces then that it needs no other proof.
    is_certain: bool,
}

impl Mistaken {
    /// Whether it is what is wrong, by what rule the normals follow as they are stored and taken back. What a stretch leaves of
    /// normals may look as if it were made by another rule, by which the matrix explains nothing: then the rules decide.
    pub(in crate::quality) fn is_proved(
        &self,
        as_stored: Option<Estimate>,
        taken_back: Option<Estimate>,
    ) -> bool {
        let clears_up = || Some(taken_back?.clears_up(&as_stored?));
        self.is_certain || clears_up().unwrap_or(false)
    }

    /// Tells it of what was stored.
    pub(in crate::quality) fn tell(&self, stored: &Facts<'_>, most: usize, found: &mut Tallies) {
        found.add_mesh(Kind::Untransformed, stored.total_area, worst(stored, most));
        found.tally(Kind::Untransformed).turn = Some(self.turn);
        let remark = |text: String| Remark { weight: self.turn, text };
        found.tally(Kind::Untransformed).remark = self.reported.clone().map(remark);
    }
}

/// The nodes that place a mesh and turn or stretch it, from the root on, and the matrices of all together.
struct Chain {
    links: Vec<(usize, DMat3)>,
    whole: DMat3,
}

impl Chain {
    fn new(node: &FileNode, tree: Option<&NodeTree<'_>>) -> Self {
        /// The angle in degrees below which a matrix leaves normals as they are but for rounding.
        const NOTHING: f64 = 1e-6;
        let whole = DMat3::from_mat4(node.world_from_part);
        let mut links: Vec<(usize, DMat3)> = match tree {
            Some(tree) => {
                tree.chain(node.number).into_iter().map(|(it, map)| (it, DMat3::from_mat4(map))).collect()
            }
            None => vec![(node.number, whole)],
        };
        links.retain(|&(_, map)| largest_turn(map) > NOTHING);
        if normal_matrix(whole).is_none() {
            // What is squeezed flat has no normals.
            links.clear();
        }
        Self { links, whole }
    }

    fn product(&self, range: Range<usize>) -> DMat3 {
        self.links[range].iter().fold(DMat3::IDENTITY, |above, link| above * link.1)
    }

    /// All ways to mistake the matrix of one node, or those from the root to one or from one to the mesh: the likely ones first.
    fn mistakes(&self, turned: Degrees) -> Vec<Mistake> {
        let count = self.links.len();
        let from_here_down = (0..count).map(|from| from..count);
        let from_root = (1..count).map(|to| 0..to);
        // Those at both ends stand there already.
        let single = (1..count.max(2) - 1).map(|at| at..at + 1);
        let ranges: Vec<Range<usize>> = from_here_down.chain(from_root).chain(single).collect();
        let mut mistakes = Vec::new();
        for range in ranges {
            let map = if range.len() == count { self.whole } else { self.product(range.clone()) };
            let below = self.product(range.end..count);
            let ends = [range.start, range.end - 1].map(|at| self.links[at].0);
            let seen_here = below.inverse() * map * below;
            let mut tell = |how, map: DMat3, forth: DMat3| {
                let turn = largest_turn(forth);
                if turn > turned.0 && map.is_finite() {
                    mistakes.push(Mistake { map, turn, ends, how });
                }
            };
            tell(How::Twice, seen_here, seen_here);
            tell(How::Missing, seen_here.inverse(), seen_here);
            if range.end < count {
                tell(How::Within, map, map);
                tell(How::WithinInverse, map.inverse(), map);
            }
        }
        mistakes
    }
}

/// What may have been done wrong with the matrices of nodes that follow one another.
#[derive(Clone, Copy)]
enum How {
    /// They are in the normals, and the nodes apply them again.
    Twice,
    /// Their inverse is in the normals, and the nodes undo it.
    Missing,
    /// They are in the normals as if these stood where the matrices apply.
    Within,
    /// The same with their inverse.
    WithinInverse,
}

/// A way to mistake matrices.
struct Mistake {
    /// What it makes of a normal: the map of points whose normal matrix that is.
    map: DMat3,
    /// How far the matrices turn normals at most, in degrees.
    turn: f64,
    /// The first and the last of the nodes.
    ends: [usize; 2],
    how: How,
}

impl Mistake {
    /// In words, with names for nodes; `None` if these have none.
    fn reported(&self, name: impl Fn(usize) -> Option<String>) -> Option<String> {
        let [first, last] = self.ends;
        let (them, nodes) = if first == last {
            ("the matrix", format!("of node `{}`", name(last)?))
        } else {
            ("the matrices", format!("of nodes `{}` to `{}`", name(first)?, name(last)?))
        };
        let [is, applies] = if first == last { ["is", "applies"] } else { ["are", "apply"] };
        let elsewhere = "is in them, in a space that it is not for";
        Some(match self.how {
            How::Twice => format!("{them} {nodes} {is} in them already and {applies} twice"),
            How::Missing => format!("{them} {nodes} {is} undone in them, as if there were none"),
            How::Within => format!("the product of {them} {nodes} {elsewhere}"),
            How::WithinInverse => format!("the inverse of {them} {nodes} {elsewhere}"),
        })
    }
}

/// How well stored normals agree with what they should be, as means of cosines.
struct Agreement<'a> {
    facts: &'a Facts<'a>,
    /// Each so many-th face is looked at.
    step: usize,
    weight: f64,
    as_stored: f64,
    /// With all turned by what is closest, if that is known.
    by_turn: f64,
    /// If each may stand for its opposite.
    either_way: f64,
}

impl<'a> Agreement<'a> {
    fn new(facts: &'a Facts<'a>, step: usize) -> Self {
        let mut sums = Self { facts, step, weight: 0.0, as_stored: 0.0, by_turn: 0.0, either_way: 0.0 };
        let turn = facts.turn.unwrap_or_default();
        each(facts, step, |stored, expected, area| {
            sums.as_stored += area * stored.dot(expected);
            sums.by_turn += area * stored.dot(turn * expected);
            sums.either_way += area * stored.dot(expected).abs();
            sums.weight += area;
        });
        let mean = |sum: f64| sum / sums.weight;
        let [as_stored, by_turn, either_way] = [sums.as_stored, sums.by_turn, sums.either_way].map(mean);
        Self { as_stored, by_turn, either_way, ..sums }
    }

    /// With what a map of points makes of the expected ones; `None` if it has no inverse.
    fn with(&self, map: DMat3) -> Option<f64> {
        let matrix = normal_matrix(map)?;
        let mut with = 0.0;
        each(self.facts, self.step, |stored, expected, area| {
            with += area * stored.dot(matrix.apply(expected).unwrap_or(expected));
        });
        Some(with / self.weight)
    }
}

/// Visits stored and expected normals of each so many-th face, with the areas of their faces.
fn each(facts: &Facts<'_>, step: usize, mut visit: impl FnMut(DVec3, DVec3, f64)) {
    let faces = (0..facts.mesh.face_count()).step_by(step);
    for face in faces.filter(|&face| facts.worth[face] != Significance::Silent) {
        for corner in facts.mesh.faces().range(face) {
            if let Some(stored) = facts.stored_unit(corner) {
                visit(stored, facts.right_way(face, corner), facts.area[face]);
            }
        }
    }
}

/// The mistake that agrees best with some of the faces, the first of several, and whether it is the only one at its place.
fn most_like<'a>(facts: &Facts<'_>, mistakes: &'a [Vec<Mistake>]) -> Option<(&'a Mistake, bool)> {
    /// Faces looked at, about.
    const FACES: usize = 1 << 11;
    /// What rounding makes of equal mean cosines.
    const ALIKE: f64 = 1e-6;
    let some = Agreement::new(facts, facts.mesh.face_count().div_ceil(FACES).max(1));
    let with = |mistake: &'a Mistake| Some((some.with(mistake.map)?, mistake));
    let of_place = |ways: &'a Vec<Mistake>| ways.iter().filter_map(with).collect::<Vec<_>>();
    let by_place: Vec<Vec<(f64, &Mistake)>> = mistakes.iter().map(of_place).collect();
    let best = by_place.iter().flatten().map(|it| it.0).reduce(f64::max)?;
    let alike = |ways: &Vec<(f64, &'a Mistake)>| {
        let mut alike = ways.iter().filter(|it| it.0 >= best - ALIKE).map(|it| it.1);
        Some((alike.next()?, alike.next().is_none()))
    };
    by_place.iter().find_map(alike)
}

/// A mesh with the stored normals that it had before a linear map of points took them along. Lengths stay as they are.
fn taken_back(mesh: &Mesh, map: DMat3) -> Mesh {
    let mut normals = mesh.columns().normals.clone();
    let back = normal_matrix(map.inverse());
    for normal in normals.iter_mut().flat_map(|column| &mut column.values) {
        let unit = UnitVec3::new(*normal).and_then(|unit| back.as_ref()?.apply(unit.get()));
        *normal = unit.map_or(*normal, |unit| unit * normal.length());
    }
    mesh.clone().with_normals(normals)
}

/// How far a linear map turns normals at most, over the axes and the diagonals, in degrees.
fn largest_turn(map: DMat3) -> f64 {
    let [across, up] = [DVec3::new(1.0, -1.0, 1.0), DVec3::new(1.0, 1.0, -1.0)];
    let directions = [DVec3::X, DVec3::Y, DVec3::Z, DVec3::ONE, across, up];
    let Some(matrix) = normal_matrix(map) else { return 0.0 };
    let turn = |d: DVec3| matrix.apply(d).map_or(0.0, |turned| Degrees::from(angle_between(d, turned)).0);
    directions.into_iter().map(turn).fold(0.0, f64::max)
}
