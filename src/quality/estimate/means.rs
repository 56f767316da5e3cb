//! Sums of the faces round a corner by each weighting, for a rule about which edges are smooth.

use crate::normals::{CreaseTest, Weight};
use crate::num::{Degrees, angle_between};
use crate::quality::facts::{Facts, Significance};
use crate::quality::stored::vertex_fans::{SHORT, VertexFans};
use glam::DVec3;

/// All weightings but the quadric, which is a fit.
pub(in crate::quality) const MEANS: [Weight; 6] =
    [Weight::Angle, Weight::Area, Weight::Uniform, Weight::AngleArea, Weight::Max, Weight::Edge];

/// Sums of the faces round a corner, by each weighting.
pub(in crate::quality) type Sums = [DVec3; MEANS.len()];

/// Which edges are smooth.
#[derive(Clone, Copy)]
pub(in crate::quality) struct Smoothness<'a> {
    /// Those that bend by no more.
    pub(in crate::quality) crease: Degrees,
    test: CreaseTest,
    /// Of those, the ones whose two faces have one of these numbers, and not 0.
    pub(in crate::quality) groups: Option<&'a [u32]>,
}

impl<'a> Smoothness<'a> {
    pub(in crate::quality) fn new(crease: Degrees, groups: Option<&'a [u32]>) -> Self {
        Self { crease, test: CreaseTest::new(Some(crease)), groups }
    }
}

impl Smoothness<'_> {
    /// Whether an edge between two faces is smooth.
    fn joins(self, facts: &Facts<'_>, [a, b]: [usize; 2]) -> bool {
        let in_one_group = |groups: &[u32]| groups[a] == groups[b] && groups[a] != 0;
        self.groups.is_none_or(in_one_group) && !self.test.is_over(facts.face_normal(a), facts.face_normal(b))
    }
}

/// The sum by each weighting over the faces that are reached from a corner without crossing a sharp edge.
pub(in crate::quality) fn sums(
    facts: &Facts<'_>,
    corner: u32,
    rule: Smoothness<'_>,
    poles: &VertexFans<Sums>,
) -> Sums {
    let add = |sums: &mut Sums, corner| {
        sums.iter_mut().zip(pulls(facts, corner)).for_each(|(sum, pull)| *sum += pull);
    };
    let short = || {
        let mut sums = Sums::default();
        walk(facts, corner, rule, SHORT, |corner| add(&mut sums, corner)).then_some(sums)
    };
    let whole = || {
        let (mut sums, mut corners) = (Sums::default(), Vec::new());
        walk(facts, corner, rule, usize::MAX, |corner| corners.push(corner));
        // Whichever of them it began at, the order is the same.
        corners.sort_unstable();
        corners.iter().for_each(|&corner| add(&mut sums, corner));
        (sums, corners)
    };
    poles.of(corner, short, whole)
}

/// What the face of a corner adds to the sum there, by each weighting.
fn pulls(facts: &Facts<'_>, corner: u32) -> Sums {
    let Some(pull) = Pull::at(facts, corner) else { return Sums::default() };
    let angle = pull.angle();
    MEANS.map(|weight| pull.by(weight, || angle))
}

/// The same by one of the means.
pub(in crate::quality) fn pull(facts: &Facts<'_>, corner: u32, weight: Weight) -> DVec3 {
    Pull::at(facts, corner).map_or(DVec3::ZERO, |pull| pull.by(weight, || pull.angle()))
}

/// The same as if two triangles that a quadrilateral is cut into still were one, with its normal.
pub(in crate::quality) fn pull_uncut(facts: &Facts<'_>, corner: u32, weight: Weight) -> DVec3 {
    let face = facts.topology.face_of(corner) as usize;
    let Some(mut pull) = Pull::at(facts, corner) else { return DVec3::ZERO };
    if let Some(other) = other_half(facts, face) {
        let sum = [face, other].map(|face| facts.area[face] * facts.face_normal(face)).iter().sum::<DVec3>();
        pull.normal = sum.normalize_or(pull.normal);
    }
    pull.by(weight, || pull.angle())
}

/// The triangle that was one quadrilateral with another, as programs cut them: a, b, c and right after it a, c, d, or a, b, d and
/// b, c, d.
fn other_half(facts: &Facts<'_>, face: usize) -> Option<usize> {
    let faces = facts.mesh.faces();
    let is_cut = |first: usize| {
        let [a, b] = [first, first + 1].map(|face| faces.range(face));
        let meets = |from: usize, to: usize| {
            facts.topology.across((a.start + from) as u32) == Some((b.start + to) as u32)
        };
        a.len() == 3 && b.len() == 3 && (meets(2, 0) || meets(1, 2))
    };
    if face + 1 < faces.len() && is_cut(face) {
        return Some(face + 1);
    }
    face.checked_sub(1).filter(|&before| is_cut(before))
}

/// What weightings look at: a corner of a face that has a direction.
struct Pull {
    normal: DVec3,
    ahead: DVec3,
    behind: DVec3,
    area: f64,
}

impl Pull {
    fn at(facts: &Facts<'_>, corner: u32) -> Option<Self> {
        let face = facts.topology.face_of(corner) as usize;
        let here = facts.place(corner as usize);
        let to = |other: u32| facts.place(other as usize) - here;
        let [ahead, behind] = [facts.topology.next(corner), facts.topology.previous(corner)].map(to);
        (facts.worth[face] != Significance::Silent).then(|| Self {
            normal: facts.face_normal(face),
            ahead,
            behind,
            area: facts.area[face],
        })
    }

    fn angle(&self) -> f64 {
        angle_between(self.ahead, self.behind).0
    }

    /// The normal of the face by its weight; the angle costs most and is asked for where it counts.
    fn by(&self, weight: Weight, angle: impl FnOnce() -> f64) -> DVec3 {
        let edges = || self.ahead.length() * self.behind.length();
        self.normal
            * match weight {
                Weight::Area => self.area,
                Weight::Uniform => 1.0,
                Weight::AngleArea => angle() * self.area,
                Weight::Max => libm::sin(angle()) / edges(),
                Weight::Edge => 1.0 / edges(),
                // No other is among the means.
                _ => angle(),
            }
    }
}

/// Visits the corners of the smooth group of a corner, no more than so many to either side of it; gives whether those are all.
pub(in crate::quality) fn walk(
    facts: &Facts<'_>,
    start: u32,
    rule: Smoothness<'_>,
    most: usize,
    mut visit: impl FnMut(u32),
) -> bool {
    let topology = &facts.topology;
    let is_smooth =
        |a: u32, b: u32| rule.joins(facts, [a, b].map(|corner| topology.face_of(corner) as usize));
    let ahead = |corner: u32| topology.across(corner).map(|across| topology.next(across));
    let behind = |corner: u32| topology.across(topology.previous(corner));
    visit(start);
    let mut corner = start;
    let mut steps = 0;
    while let Some(next) = ahead(corner) {
        if next == start {
            return true;
        }
        if !is_smooth(corner, next) {
            break;
        }
        if steps == most {
            return false;
        }
        visit(next);
        (corner, steps) = (next, steps + 1);
    }
    (corner, steps) = (start, 0);
    while let Some(next) = behind(corner).filter(|&next| is_smooth(corner, next)) {
        if steps == most {
            return false;
        }
        visit(next);
        (corner, steps) = (next, steps + 1);
    }
    true
}
