//! Weighted sums of the face normals around a corner by each weighting, for a rule about which edges are smooth.

use crate::normals::{CreaseTest, Weight};
use crate::num::parallel;
use crate::num::{Degrees, angle_between};
use crate::quality::angles::degrees_between;
use crate::quality::estimate::crease_angle::equal_angles;
use crate::quality::input::part::Part;
use glam::DVec3;
use rustc_hash::FxHashMap;
use std::sync::{Mutex, PoisonError};

/// All weightings that sum face normals, in the order in which they are tried.
pub(crate) const MEANS: [Weight; 6] =
    [Weight::Angle, Weight::Area, Weight::Uniform, Weight::AngleArea, Weight::Max, Weight::Edge];

/// The sum of the faces around a corner by each weighting.
pub(crate) type Sums = [DVec3; MEANS.len()];

/// Which edges are smooth.
#[derive(Clone, Copy)]
pub(crate) struct Smoothness<'a> {
    /// Those of no larger dihedral angle.
    pub(crate) crease: Degrees,
    test: CreaseTest,
    /// Of those, the ones whose two faces have the same number here, and not 0.
    pub(crate) groups: Option<&'a [u32]>,
}

impl<'a> Smoothness<'a> {
    pub(crate) fn new(crease: Degrees, groups: Option<&'a [u32]>) -> Self {
        Self { crease, test: CreaseTest::new(Some(crease)), groups }
    }

    /// Whether the crease angle decides about an edge between two faces.
    fn is_one_group(self, [a, b]: [usize; 2]) -> bool {
        self.groups.is_none_or(|groups| groups[a] == groups[b] && groups[a] != 0)
    }

    /// Whether an edge between two faces is smooth.
    fn joins(self, part: &Part<'_>, [a, b]: [usize; 2]) -> bool {
        self.is_one_group([a, b]) && !self.test.is_over(part.face_normal(a), part.face_normal(b))
    }
}

/// The factors of the face normals at all corners by each weighting, so that rules about edges share them; none if there are too
/// many.
pub(crate) struct Factors(Vec<Option<[f64; MEANS.len()]>>);

impl Factors {
    /// Of all corners, if they are no more than `most`.
    pub(crate) fn of(part: &Part<'_>, most: usize) -> Self {
        let count = part.mesh.faces().corner_count();
        let count = if count <= most { count } else { 0 };
        Self(parallel::map(count, |corner| factors(part, corner as u32)))
    }

    fn at(&self, part: &Part<'_>, corner: u32) -> Option<[f64; MEANS.len()]> {
        self.0.get(corner as usize).copied().unwrap_or_else(|| factors(part, corner))
    }
}

/// The factors at a corner; `None` if the face has no direction.
fn factors(part: &Part<'_>, corner: u32) -> Option<[f64; MEANS.len()]> {
    let term = CornerTerm::at(part, corner)?;
    let angle = term.angle();
    Some(MEANS.map(|weight| term.factor(weight, || angle)))
}

/// The sums over the faces that are reached from a corner without crossing a sharp edge.
pub(crate) fn sums(
    (part, known): (&Part<'_>, &Factors),
    corner: u32,
    rule: Smoothness<'_>,
    poles: &PoleCache<Sums>,
) -> Sums {
    let add = |sums: &mut Sums, corner| {
        let Some(factors) = known.at(part, corner) else { return };
        let normal = part.face_normal(part.face_of(corner as usize));
        sums.iter_mut().zip(factors).for_each(|(sum, factor)| *sum += normal * factor);
    };
    let short = || {
        let mut sums = Sums::default();
        walk(part, corner, rule, SHORT, |corner| add(&mut sums, corner)).then_some(sums)
    };
    let whole = || {
        let (mut sums, mut corners) = (Sums::default(), Vec::new());
        walk(part, corner, rule, usize::MAX, |corner| corners.push(corner));
        // The same order from whichever corner the walk began.
        corners.sort_unstable();
        corners.iter().for_each(|&corner| add(&mut sums, corner));
        (sums, corners)
    };
    poles.of(corner, short, whole)
}

/// The lowest crease angle in degrees that puts the same faces around a corner, and the one from which on it does not.
pub(crate) fn equal_creases(
    part: &Part<'_>,
    corner: u32,
    rule: Smoothness<'_>,
    poles: &PoleCache<[f64; 2]>,
) -> [f64; 2] {
    let topology = &part.topology;
    let of = |corners: &mut Vec<u32>| {
        corners.sort_unstable();
        corners.dedup();
        let (mut inside, mut ends, mut open) = (Vec::new(), Vec::new(), 0);
        for &corner in corners.iter() {
            let behind = topology.previous(corner);
            for (edge, is_ahead) in [(corner, true), (behind, false)] {
                let Some(across) = topology.across(edge) else {
                    open += 1;
                    continue;
                };
                let faces = [edge, across].map(|corner| part.face_of(corner as usize));
                let degrees = degrees_between(part.face_normal(faces[0]), part.face_normal(faces[1]));
                let other = if is_ahead { topology.next(across) } else { across };
                // An edge between two corners of the fan is inside, and counts once.
                match corners.binary_search(&other) {
                    Ok(_) if is_ahead && rule.is_one_group(faces) => inside.push(degrees),
                    Ok(_) if is_ahead => open += 1,
                    Ok(_) => {}
                    Err(_) if rule.is_one_group(faces) => ends.push(degrees),
                    Err(_) => open += 1,
                }
            }
        }
        equal_angles(&inside, &ends, open == 0 && ends.is_empty())
    };
    let short = || {
        let mut corners = Vec::new();
        walk(part, corner, rule, SHORT, |corner| corners.push(corner)).then(|| of(&mut corners))
    };
    let whole = || {
        let mut corners = Vec::new();
        walk(part, corner, rule, usize::MAX, |corner| corners.push(corner));
        (of(&mut corners), corners)
    };
    poles.of(corner, short, whole)
}

/// What the face of a corner adds to the sum by a weighting; zero if the face has no direction.
pub(crate) fn term(part: &Part<'_>, corner: u32, weight: Weight) -> DVec3 {
    CornerTerm::at(part, corner).map_or(DVec3::ZERO, |term| term.by(weight))
}

/// The same if the two triangles of a quadrilateral have its normal.
pub(crate) fn term_of_quadrilateral(part: &Part<'_>, corner: u32, weight: Weight) -> DVec3 {
    let face = part.face_of(corner as usize);
    let Some(mut term) = CornerTerm::at(part, corner) else { return DVec3::ZERO };
    if let Some(other) = other_half(part, face) {
        let sum: DVec3 = [face, other].map(|face| part.area[face] * part.face_normal(face)).iter().sum();
        term.normal = sum.normalize_or(term.normal);
    }
    term.by(weight)
}

/// The other triangle of a quadrilateral abcd, as programs cut it: next to each other in the file are abc and acd, or abd and
/// bcd.
fn other_half(part: &Part<'_>, face: usize) -> Option<usize> {
    let is_cut = |first: usize| {
        let [a, b] = [first, first + 1].map(|face| part.corners_of(face));
        let meets = |from: usize, to: usize| {
            part.topology.across((a.start + from) as u32) == Some((b.start + to) as u32)
        };
        a.len() == 3 && b.len() == 3 && (meets(2, 0) || meets(1, 2))
    };
    if face + 1 < part.mesh.face_count() && is_cut(face) {
        return Some(face + 1);
    }
    face.checked_sub(1).filter(|&before| is_cut(before))
}

struct CornerTerm {
    normal: DVec3,
    ahead: DVec3,
    behind: DVec3,
    area: f64,
}

impl CornerTerm {
    /// `None` if the face has no direction.
    fn at(part: &Part<'_>, corner: u32) -> Option<Self> {
        let face = part.face_of(corner as usize);
        let here = part.position(corner as usize);
        let [ahead, behind] = [part.topology.next(corner), part.topology.previous(corner)]
            .map(|other| part.position(other as usize) - here);
        let term = || Self { normal: part.face_normal(face), ahead, behind, area: part.area[face] };
        part.has_direction(face).then(term)
    }

    fn angle(&self) -> f64 {
        angle_between(self.ahead, self.behind).0
    }

    /// The face normal times its weight.
    fn by(&self, weight: Weight) -> DVec3 {
        self.normal * self.factor(weight, || self.angle())
    }

    /// The weight of the face. The angle costs most and is computed only where it counts.
    fn factor(&self, weight: Weight, angle: impl FnOnce() -> f64) -> f64 {
        let edges = || self.ahead.length() * self.behind.length();
        match weight {
            Weight::Area => self.area,
            Weight::Uniform => 1.0,
            Weight::AngleArea => angle() * self.area,
            Weight::Max => libm::sin(angle()) / edges(),
            Weight::Edge => 1.0 / edges(),
            // The weighting by angles is the mean that is closest to a fit.
            Weight::Angle | Weight::Quadric | Weight::Jet | Weight::Best => angle(),
        }
    }
}

/// Visits the corners of the smooth group of a corner, no more than `most` on either side of it. Returns whether those are
/// all.
pub(crate) fn walk(
    part: &Part<'_>,
    start: u32,
    rule: Smoothness<'_>,
    most: usize,
    mut visit: impl FnMut(u32),
) -> bool {
    let topology = &part.topology;
    let is_smooth = |a: u32, b: u32| rule.joins(part, [a, b].map(|corner| part.face_of(corner as usize)));
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

/// The longest run that is walked from each of its corners.
pub(crate) const SHORT: usize = 32;

/// The values of long runs by corner, so that the cost of a pole is linear in its corners.
pub(crate) struct PoleCache<T> {
    long: Mutex<FxHashMap<u32, T>>,
}

impl<T> Default for PoleCache<T> {
    fn default() -> Self {
        Self { long: Mutex::default() }
    }
}

impl<T: Copy> PoleCache<T> {
    /// The value for a corner: from a walk of no more than [`SHORT`] corners, or from one over all corners that share the value.
    /// The second has to give the same bits from whichever corner it starts: threads may come in any order.
    pub(crate) fn of(
        &self,
        corner: u32,
        short: impl FnOnce() -> Option<T>,
        whole: impl FnOnce() -> (T, Vec<u32>),
    ) -> T {
        let long = || self.long.lock().unwrap_or_else(PoisonError::into_inner);
        let known = short().or_else(|| long().get(&corner).copied());
        known.unwrap_or_else(|| {
            let (value, corners) = whole();
            long().extend(corners.into_iter().map(|corner| (corner, value)));
            value
        })
    }
}
