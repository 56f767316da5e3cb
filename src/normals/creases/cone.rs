//! The cone rule: each corner averages the faces of its fan whose normals are close to that of its own face.

use crate::mesh::NONE;
use crate::normals::creases::dihedral_test::CreaseTest;
use crate::normals::creases::fans::MeshWalker;
use crate::normals::creases::smooth_groups::{FanScratch, SlotCorners, SmoothGroups};
use rustc_hash::FxHashMap;

/// Time and memory of the cone rule are quadratic in the corners of a fan. Fans up to this size are always cut by it: 16 MiB
/// of hostile ones need some 300 MB.
pub(crate) const ALWAYS: usize = 128;
/// Of larger fans, so many corners squared are cut by it, the smallest fans first: some 200 MB. One of 4096 corners, or two
/// caps of 2896, come through.
const BUDGET: usize = 1 << 24;
/// A corner of a fan whose turn is yet to come.
const LATER: u32 = NONE - 1;

impl SmoothGroups {
    /// Groups under the cone rule. Also returns how many fans were too large and cut by the fan rule.
    pub(crate) fn by_cone(walker: &MeshWalker, vertex_count: usize) -> (Self, usize) {
        let corner_count = walker.fans.faces.corners().len();
        let mut cutter = Cutter {
            walker,
            group: vec![NONE; corner_count],
            members: SlotCorners { offsets: vec![0], corners: Vec::new() },
            scratch: FanScratch::default(),
        };
        let mut large: Vec<(usize, u32)> = Vec::new();
        for start in 0..corner_count as u32 {
            if cutter.group[start as usize] != NONE {
                continue;
            }
            walker.sector(start, &mut cutter.scratch.sector);
            let corners = &cutter.scratch.sector.corners;
            if corners.len() <= ALWAYS {
                cutter.by_cone();
            } else {
                large.push((corners.len(), start));
                corners.iter().for_each(|&corner| cutter.group[corner as usize] = LATER);
            }
        }
        let (mut spent, mut declined) = (0_usize, 0);
        large.sort_unstable();
        // Fans of one size share one fate, so that it does not hang on the order of faces.
        for fans in large.chunk_by(|a, b| a.0 == b.0) {
            let size = fans[0].0;
            spent = spent.saturating_add(size.saturating_mul(size).saturating_mul(fans.len()));
            for &(_, start) in fans {
                walker.sector(start, &mut cutter.scratch.sector);
                if spent <= BUDGET {
                    cutter.by_cone();
                } else {
                    cutter.by_fan();
                    declined += 1;
                }
            }
        }
        let Cutter { group, members, .. } = cutter;
        let mut groups = Self::from_groups(walker.fans.faces, vertex_count, &group);
        groups.members = Some(groups.members_by_slot(&group, &members));
        (groups, declined)
    }

    /// The members of groups in the order of slots.
    fn members_by_slot(&self, group: &[u32], members: &SlotCorners) -> SlotCorners {
        let mut of_slot = vec![NONE; self.slots];
        for (corner, &entry) in self.corner_entry.iter().enumerate() {
            of_slot[self.slot(entry) as usize] = group[corner];
        }
        let mut ordered = SlotCorners { offsets: vec![0], corners: Vec::new() };
        for number in of_slot {
            ordered.push(members.row(number));
        }
        ordered
    }
}

/// Cuts fans into groups, the one in `scratch.sector` at each call.
struct Cutter<'a> {
    walker: &'a MeshWalker<'a>,
    /// The group of each corner.
    group: Vec<u32>,
    members: SlotCorners,
    scratch: FanScratch,
}

impl Cutter<'_> {
    /// For each corner the faces whose normals are within the crease angle of its own face's.
    fn by_cone(&mut self) {
        let Self { walker, group, members, scratch } = self;
        walker.deciding_places(&scratch.sector, &mut scratch.places);
        let corners = &scratch.sector.corners;
        let mut decides = vec![false; corners.len()];
        scratch.places.iter().for_each(|&place| decides[place] = true);
        let mut set = Vec::new();
        let mut known: FxHashMap<Vec<u32>, u32> = FxHashMap::default();
        for (place, &corner) in corners.iter().enumerate() {
            set.clear();
            if !decides[place] && !matches!(walker.crease, CreaseTest::Every) {
                set.extend_from_slice(corners);
            } else {
                let own = walker.normal(corner);
                set.push(corner);
                let deciding = scratch.places.iter().map(|&place| corners[place]);
                set.extend(deciding.filter(|&other| {
                    other != corner
                        && match walker.crease {
                            CreaseTest::Every => false,
                            CreaseTest::None => true,
                            CreaseTest::Over { limit, .. } => !limit.exceeded(own, walker.normal(other)),
                        }
                }));
            }
            set.sort_unstable();
            group[corner as usize] = *known.entry(set.clone()).or_insert_with(|| members.push(&set));
        }
    }

    /// One group between two edges over the crease angle.
    fn by_fan(&mut self) {
        let Self { walker, group, members, scratch } = self;
        walker.cuts(&scratch.sector, &mut scratch.places, &mut scratch.cuts);
        let mut pieces: Vec<(u32, u32)> = Vec::new();
        crate::normals::creases::smooth_groups::for_each_piece(&scratch.sector, &scratch.cuts, |c, piece| {
            pieces.push((piece, c))
        });
        pieces.sort_unstable();
        for piece in pieces.chunk_by(|a, b| a.0 == b.0) {
            let set: Vec<u32> = piece.iter().map(|&(_, corner)| corner).collect();
            let number = members.push(&set);
            set.iter().for_each(|&corner| group[corner as usize] = number);
        }
    }
}

impl SlotCorners {
    fn push(&mut self, row: &[u32]) -> u32 {
        self.corners.extend_from_slice(row);
        self.offsets.push(self.corners.len() as u32);
        self.offsets.len() as u32 - 2
    }

    /// The corners of one row.
    pub(crate) fn row(&self, number: u32) -> &[u32] {
        let number = number as usize;
        &self.corners[self.offsets[number] as usize..self.offsets[number + 1] as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Faces, Mesh, MeshBuilder};
    use crate::normals::compute::compute;
    use crate::normals::field::NormalField;
    use crate::normals::recipe::{Crease, CreaseRule, NormalRecipe};
    use crate::num::Degrees;
    use glam::DVec3;

    fn by_cone(mesh: &Mesh, degrees: f64) -> NormalField {
        let crease = Crease::Angle(Degrees(degrees));
        compute(mesh, &NormalRecipe { crease, rule: CreaseRule::Cone, ..NormalRecipe::default() })
    }

    /// A cone of height 1 over a regular polygon of radius 1. Corner 3i is the tip's in face i.
    fn cone(sides: u32) -> Mesh {
        let rim = |i: u32| {
            let angle = std::f64::consts::TAU * f64::from(i) / f64::from(sides);
            DVec3::new(libm::cos(angle), libm::sin(angle), 0.0)
        };
        let mut faces = Faces::new();
        (0..sides).for_each(|i| faces.push(&[0, 1 + i, 1 + (i + 1) % sides]));
        let positions = std::iter::once(DVec3::Z).chain((0..sides).map(rim)).collect();
        MeshBuilder { positions, faces, ..MeshBuilder::default() }.build().unwrap()
    }

    #[test]
    fn corners_of_a_large_fan_pick_their_own_faces() {
        for sides in [ALWAYS as u32, 200, 1000] {
            let mesh = cone(sides);
            let field = by_cone(&mesh, 40.0);
            assert_eq!(field.summary.cone_declined, 0);
            for face in (0..sides as usize).step_by(7) {
                let own = field.face_normals[face];
                let near =
                    |n: &&DVec3| libm::atan2(own.cross(**n).length(), own.dot(**n)).to_degrees() <= 40.01;
                // All tip angles are the same.
                let mean = field.face_normals.iter().filter(near).sum::<DVec3>().normalize();
                let found = *field.normals.get(3 * face, 0).unwrap();
                // Sums of a thousand unit vectors in two orders.
                assert!(found.distance(mean) < 1e-13, "{sides} {face}: {found} {mean}");
            }
        }
    }

    #[test]
    fn fans_beyond_the_budget_are_cut_by_the_fan_rule_and_counted() {
        let field = by_cone(&cone(4097), 40.0);
        assert_eq!(field.summary.cone_declined, 1);
        assert_eq!(field.normals.get(0, 0), field.normals.get(3 * 2048, 0));
    }

    #[test]
    fn a_face_with_two_corners_in_one_place_counts_once() {
        let sign = |bit: usize, i: usize| if i >> bit & 1 == 1 { 1.0 } else { -1.0 };
        let mut positions: Vec<DVec3> =
            (0..8).map(|i| DVec3::new(sign(0, i), sign(1, i), sign(2, i))).collect();
        positions.push(positions[0]);
        let mut faces = Faces::new();
        faces.push(&[0, 8, 4, 6, 2]);
        for face in [[1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]] {
            faces.push(&face);
        }
        let mesh =
            MeshBuilder { positions: positions.into(), faces, ..MeshBuilder::default() }.build().unwrap();
        let field = by_cone(&mesh, 179.0);
        for (corner, &vertex) in mesh.faces().corners().iter().enumerate() {
            let found = *field.normals.get(corner, vertex).unwrap();
            let diagonal = mesh.positions().at(vertex).normalize();
            assert!(found.distance(diagonal) < 1e-15, "{corner}: {found}");
        }
    }
}
