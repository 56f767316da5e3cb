//! How stored normals were made: which weighting and which crease angle reproduce them best.

use super::facts::{Facts, Worth};
use crate::mesh::Column;
use crate::normals::{Crease, Groups, NormalRecipe, Weight};
use crate::num::{Degrees, angle_between};
use glam::DVec3;
use rayon::prelude::*;

/// The most corners that are looked at.
pub const SAMPLE: usize = 100_000;

/// Two normals closer than this, in degrees, are taken to be one: above what 8 bits do to each of them.
const SAME: f64 = 1.0;

/// The share of corners that a rule reproduces, if nothing else made them.
const NEARLY_ALL: f64 = 0.98;

/// Edges that bend by less, in degrees, tell nothing about creases.
const FLAT: f64 = 1.0;

/// A corner counts as reproduced within this many degrees.
const REPRODUCED: f64 = 5.0;

/// For how many edges that look smooth beyond the crease angle one that looks sharp below it counts, where those may all be
/// the only sharp ones at their vertices.
const LONE: usize = 16;

/// Means of faces that were tried: all but the quadric, which is a fit.
const MEANS: [Weight; 6] =
    [Weight::Angle, Weight::Area, Weight::Uniform, Weight::AngleArea, Weight::Max, Weight::Edge];

/// How the stored normals of a part were made, as far as they tell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// The weighting that reproduces them best.
    pub weight: Weight,
    /// The crease angle that reproduces them best: 0 if they are flat, 180 if no edge is sharp.
    pub crease: Degrees,
    /// Whether smoothing groups reproduce them better than a crease angle alone; the angle then applies beside them.
    pub groups: bool,
    /// Corners looked at.
    pub sample: usize,
    /// The share of them that it reproduces within 5°.
    pub reproduced: f64,
    /// The share of them that it reproduces within 1°.
    pub closely: f64,
    /// The share of the edges at them, of those that bend at all, that the crease angle puts on the right side.
    pub separated: f64,
    /// The median angle between stored and reproduced normals.
    pub median: Degrees,
}

impl Estimate {
    /// The recipe that it stands for.
    pub fn recipe(&self) -> NormalRecipe {
        NormalRecipe {
            weight: self.weight,
            crease: Crease::Angle(self.crease),
            groups: if self.groups { Groups::Honour } else { Groups::Ignore },
            ..NormalRecipe::default()
        }
    }

    /// The same as options of `crease normals`.
    pub fn options(&self) -> String {
        let mut options = match self.weight {
            Weight::Angle => String::new(),
            weight => format!("--weight {} ", weight.name()),
        };
        options.push_str(&format!("--crease {}", self.crease.0));
        options.push_str(if self.groups { "" } else { " --groups ignore" });
        options
    }

    /// Whether the recipe is what is computed without being asked for, on a mesh without smoothing groups.
    pub(super) fn is_default(&self) -> bool {
        self.weight == Weight::Angle && self.crease == Crease::DEFAULT_ANGLE
    }

    /// The bend in degrees from which on edges may be sharp: with smoothing groups any.
    pub(super) fn sharp_from(&self) -> f64 {
        if self.groups { 0.0 } else { self.crease.0 }
    }

    /// Whether the normals follow a rule closely enough for exceptions to be faults: nearly all do, or most do to the letter
    /// and the others not at all.
    pub fn is_rule(&self) -> bool {
        self.reproduced >= NEARLY_ALL || (self.closely >= 0.85 && self.reproduced - self.closely <= 0.01)
    }
}

/// Estimates from a fixed sample; `None` if no corner has a usable normal.
pub(super) fn estimate(facts: &Facts<'_>, stored: &Column<DVec3>) -> Option<Estimate> {
    let sample = sample(facts);
    if sample.is_empty() {
        return None;
    }
    let bends: Vec<Bend> = sample.par_iter().filter_map(|&corner| Bend::at(facts, stored, corner)).collect();
    let sharp_from = |crease| Smoothness { crease, groups: None };
    let separating = separating_angle(&bends, 1);
    let mut plain = by_rule(facts, &sample, &bends, sharp_from(separating));
    // A sharp edge that is the only one at its vertex splits nothing, and looks smooth: what separates best need not be
    // what the normals were made with. Edges that look sharp are what they seem.
    let others = [Crease::DEFAULT_ANGLE, separating_angle(&bends, LONE)];
    if plain.1.reproduced < 1.0 {
        for &other in others.iter().filter(|&&other| other != separating) {
            let other = by_rule(facts, &sample, &bends, sharp_from(other));
            plain = if other.0 < plain.0 { other } else { plain };
        }
    }
    if let Some(groups) = facts.mesh.columns().smoothing.as_ref().filter(|_| plain.1.reproduced < NEARLY_ALL)
    {
        for crease in [plain.1.crease, Crease::DEFAULT_ANGLE, Degrees(180.0)] {
            let rule = Smoothness { crease, groups: Some(&groups.of_face) };
            let other = by_rule(facts, &sample, &bends, rule);
            plain = if other.1.reproduced > plain.1.reproduced { other } else { plain };
        }
    }
    Some(plain.1)
}

/// The estimate with a rule about edges and the weighting that does best with it, and by how much it is off in all.
fn by_rule(facts: &Facts<'_>, sample: &[u32], bends: &[Bend], rule: Smoothness<'_>) -> (f64, Estimate) {
    let crease = rule.crease;
    let errors: Vec<[f64; MEANS.len()]> =
        sample.par_iter().map(|&corner| errors(facts, corner, rule)).collect();
    // Far-off corners are faults, not evidence: all beyond the bound count alike.
    let capped = |weight: usize| errors.iter().map(|all| all[weight].min(REPRODUCED)).sum::<f64>();
    let costs: Vec<f64> = (0..MEANS.len()).map(capped).collect();
    // Where all do alike, as on flat shapes, the first one is as good as any.
    let best = (1..MEANS.len())
        .fold(0, |best, i| if costs[i] < costs[best] * (1.0 - 1e-3) - 1e-9 { i } else { best });
    let mut own: Vec<f64> = errors.iter().map(|all| all[best]).collect();
    let within = |most: f64| own.iter().filter(|&&error| error <= most).count() as f64 / own.len() as f64;
    let (reproduced, closely) = (within(REPRODUCED), within(SAME));
    own.sort_unstable_by(f64::total_cmp);
    let separated = bends.iter().filter(|bend| (bend.degrees < crease.0) == bend.smooth).count();
    let estimate = Estimate {
        weight: MEANS[best],
        crease,
        groups: rule.groups.is_some(),
        sample: own.len(),
        reproduced,
        closely,
        separated: match (rule.groups, bends.len()) {
            (None, 1..) => separated as f64 / bends.len() as f64,
            (None, 0) => 1.0,
            // Groups say which edges are sharp, not the angle.
            (Some(_), _) => reproduced,
        },
        median: Degrees(own[own.len() / 2]),
    };
    (costs[best], estimate)
}

/// Corners with a direction on sound faces; if there are too many, those that a fixed generator picks.
fn sample(facts: &Facts<'_>) -> Vec<u32> {
    let count = facts.mesh.faces().corner_count();
    let is_usable = |&corner: &u32| {
        let face = facts.topology.face_of(corner) as usize;
        facts.worth[face] == Worth::Sound && facts.stored_unit(corner as usize).is_some()
    };
    if count <= SAMPLE {
        return (0..count as u32).filter(is_usable).collect();
    }
    // One corner of each stretch of equal length, so that all of the mesh has its say.
    let pick = |stretch: usize| {
        let (from, to) = (stretch * count / SAMPLE, (stretch + 1) * count / SAMPLE);
        (from + (mixed(stretch as u64) % (to - from) as u64) as usize) as u32
    };
    (0..SAMPLE).into_par_iter().map(pick).filter(is_usable).collect()
}

/// The output function of splitmix64.
fn mixed(seed: u64) -> u64 {
    let z = seed.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// An edge, by how far it bends and whether the stored normals go on across it.
struct Bend {
    degrees: f64,
    smooth: bool,
}

impl Bend {
    /// The edge that leaves a corner, by the normals at that corner.
    fn at(facts: &Facts<'_>, stored: &Column<DVec3>, corner: u32) -> Option<Bend> {
        let across = facts.topology.across(corner)?;
        let beyond = facts.topology.next(across) as usize;
        let faces = [corner, across].map(|corner| facts.topology.face_of(corner) as usize);
        if faces.iter().any(|&face| facts.worth[face] != Worth::Sound) {
            return None;
        }
        let degrees =
            Degrees::from(angle_between(facts.face_normal(faces[0]), facts.face_normal(faces[1]))).0;
        if degrees < FLAT {
            return None;
        }
        let corners = facts.mesh.faces().corners();
        let slots = [corner as usize, beyond].map(|corner| stored.slot(corner, corners[corner]));
        let smooth = slots[0] == slots[1] || {
            let (a, b) = (facts.stored_unit(corner as usize)?, facts.stored_unit(beyond)?);
            Degrees::from(angle_between(a, b)).0 <= SAME
        };
        Some(Bend { degrees, smooth })
    }
}

/// The angle that best tells smooth edges from sharp ones, if one that looks sharp below it is as wrong as so many that look
/// smooth beyond it.
fn separating_angle(bends: &[Bend], weight: usize) -> Degrees {
    const BINS: usize = 180;
    let bin = |degrees: f64| (degrees as usize).min(BINS - 1);
    let (mut smooth, mut sharp) = ([0usize; BINS], [0usize; BINS]);
    for bend in bends {
        let list = if bend.smooth { &mut smooth } else { &mut sharp };
        list[bin(bend.degrees)] += 1;
    }
    // An angle of k degrees is wrong about sharp edges of bins below k and smooth ones of bins from k on.
    let mut wrong = smooth.iter().sum::<usize>();
    let mut costs = vec![wrong];
    for k in 0..BINS {
        wrong = wrong + weight * sharp[k] - smooth[k];
        costs.push(wrong);
    }
    let least = *costs.iter().min().expect("181 angles");
    let runs = costs.chunk_by(|a, b| a == b);
    // The longest run of best angles; among equals the first.
    let mut best = (0, 0);
    let mut start = 0;
    for run in runs {
        if run[0] == least && run.len() > best.1 {
            best = (start, run.len());
        }
        start += run.len();
    }
    let (low, high) = (best.0, best.0 + best.1 - 1);
    Degrees(match (low, high) {
        _ if sharp.iter().all(|&count| count == 0) => 180.0,
        // What is computed without being asked for is what most have been made with.
        (low, high) if (low..=high).contains(&40) => 40.0,
        _ if smooth.iter().all(|&count| count == 0) => 0.0,
        (low, high) => low.midpoint(high) as f64,
    })
}

/// Which edges are smooth.
#[derive(Clone, Copy)]
struct Smoothness<'a> {
    /// Those that bend by no more.
    crease: Degrees,
    /// Of those, the ones whose two faces have one of these numbers, and not 0.
    groups: Option<&'a [u32]>,
}

impl Smoothness<'_> {
    /// Whether an edge between two faces is smooth.
    fn joins(self, facts: &Facts<'_>, [a, b]: [usize; 2]) -> bool {
        let in_one_group = |groups: &[u32]| groups[a] == groups[b] && groups[a] != 0;
        self.groups.is_none_or(in_one_group)
            && (self.crease.0 >= 180.0
                || Degrees::from(angle_between(facts.face_normal(a), facts.face_normal(b))) <= self.crease)
    }
}

/// The angle in degrees between the stored normal of a corner and the mean by each weighting over the faces that are
/// reached from it without crossing a sharp edge.
fn errors(facts: &Facts<'_>, corner: u32, rule: Smoothness<'_>) -> [f64; MEANS.len()] {
    let mut sums = [DVec3::ZERO; MEANS.len()];
    let mut add = |corner: u32| {
        let face = facts.topology.face_of(corner) as usize;
        if facts.worth[face] == Worth::Silent {
            return;
        }
        let normal = facts.face_normal(face);
        let here = facts.place(corner as usize);
        let ahead = facts.place(facts.topology.next(corner) as usize) - here;
        let behind = facts.place(facts.topology.previous(corner) as usize) - here;
        let angle = angle_between(ahead, behind).0;
        let area = facts.area[face];
        let edges = ahead.length() * behind.length();
        let weights = [angle, area, 1.0, angle * area, libm::sin(angle) / edges, 1.0 / edges];
        for (sum, weight) in sums.iter_mut().zip(weights) {
            *sum += normal * weight;
        }
    };
    walk(facts, corner, rule, &mut add);
    let stored = facts.stored_unit(corner as usize).expect("the sample has corners with a direction");
    sums.map(|sum| Degrees::from(angle_between(stored, sum)).0)
}

/// The longest way from a corner that is walked: poles of more faces are judged by these.
const LONGEST: usize = 512;

/// Visits the corners of the smooth group of a corner.
fn walk(facts: &Facts<'_>, start: u32, rule: Smoothness<'_>, visit: &mut impl FnMut(u32)) {
    let topology = &facts.topology;
    let is_smooth =
        |a: u32, b: u32| rule.joins(facts, [a, b].map(|corner| topology.face_of(corner) as usize));
    visit(start);
    let mut corner = start;
    for _ in 0..LONGEST {
        let Some(across) = topology.across(corner) else { break };
        let next = topology.next(across);
        if next == start {
            return;
        }
        if !is_smooth(corner, next) {
            break;
        }
        visit(next);
        corner = next;
    }
    corner = start;
    for _ in 0..LONGEST {
        let before = topology.across(topology.previous(corner));
        let Some(next) = before.filter(|&next| is_smooth(corner, next)) else { break };
        visit(next);
        corner = next;
    }
}
