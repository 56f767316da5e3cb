//! Smooth groups: which corners share a normal.

use crate::mesh::{DisjointSets, FacesRef, Link, NONE, Rings, Scatter, Topology};
use crate::normals::creases::fans::{FanWalker, Fans, MeshFans, MeshWalker, Sector};
use rayon::prelude::*;

/// The smooth groups of a mesh.
///
/// An *entry* is a (vertex, smooth group): what a file stores. A *slot* is a smooth group: what is summed. They
/// differ only where welding lets a group reach over several vertices. Slots are numbered in the order of their lowest
/// entries.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct SmoothGroups {
    /// The entry of each corner.
    pub(crate) corner_entry: Vec<u32>,
    /// The vertex of each entry; entries are ordered by vertex, then by the lowest corner of the group there.
    pub(crate) entry_vertex: Vec<u32>,
    /// The slot of each entry, if that is not the entry itself.
    pub(crate) entry_slot: Option<Vec<u32>>,
    /// The number of slots.
    pub(crate) slots: usize,
    /// Under the cone rule: the corners that each slot averages, ascending. Otherwise a slot averages the
    /// corners that have it.
    pub(crate) members: Option<SlotCorners>,
}

/// Corners by slot, in compressed rows.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct SlotCorners {
    pub(crate) offsets: Vec<u32>,
    pub(crate) corners: Vec<u32>,
}

impl SlotCorners {
    /// The corners that have each slot.
    pub(crate) fn by_slot(corner_slot: &[u32], slots: usize) -> Self {
        let Rings { offsets, corners } = Rings::build(corner_slot, slots);
        Self { offsets, corners }
    }
}

impl SmoothGroups {
    /// `alike`: for each entry the entry that represents its slot, or nothing if each has a slot of its own.
    fn new(corner_entry: Vec<u32>, entry_vertex: Vec<u32>, mut alike: Vec<u32>) -> Self {
        let mut slots = 0;
        let mut number = vec![NONE; alike.len()];
        for entry in &mut alike {
            let number = &mut number[*entry as usize];
            if *number == NONE {
                *number = slots;
                slots += 1;
            }
            *entry = *number;
        }
        let (entry_slot, slots) =
            if alike.is_empty() { (None, entry_vertex.len()) } else { (Some(alike), slots as usize) };
        Self { corner_entry, entry_vertex, entry_slot, slots, members: None }
    }

    /// The values of entries, from those of slots.
    pub(crate) fn of_entries<T: Copy + Send + Sync>(&self, values: Vec<T>) -> Vec<T> {
        match &self.entry_slot {
            None => values,
            Some(slots) => slots.par_iter().map(|&slot| values[slot as usize]).collect(),
        }
    }

    /// The slot of an entry.
    #[inline]
    pub(crate) fn slot(&self, entry: u32) -> u32 {
        self.entry_slot.as_ref().map_or(entry, |slots| slots[entry as usize])
    }

    /// The slot of each corner.
    pub(crate) fn corner_slots(&self) -> std::borrow::Cow<'_, [u32]> {
        match &self.entry_slot {
            None => (&self.corner_entry).into(),
            Some(slots) => {
                self.corner_entry.par_iter().map(|&e| slots[e as usize]).collect::<Vec<_>>().into()
            }
        }
    }

    /// One group a vertex: all faces at it and at vertices joined to it by a welded edge, or one without length.
    pub(crate) fn per_vertex(faces: FacesRef, topology: &Topology, vertex_count: usize) -> Self {
        let mut sets = DisjointSets::new(vertex_count);
        if topology.has_welds() {
            for half_edge in 0..faces.corners().len() as u32 {
                let (a, b) = topology.ends(faces.corners(), half_edge);
                if topology.has_no_length(half_edge) && !topology.is_collapsed(half_edge) {
                    sets.union(a, b);
                } else if let Link::Welded(across) = topology.link(half_edge) {
                    let (c, d) = topology.ends(faces.corners(), across);
                    sets.union(a, d);
                    sets.union(b, c);
                }
            }
        }
        let mut entry_of = vec![NONE; vertex_count];
        let mut entry_vertex = Vec::new();
        for vertex in (0..vertex_count as u32).filter(|&v| !topology.corners_at(v).is_empty()) {
            entry_of[vertex as usize] = entry_vertex.len() as u32;
            entry_vertex.push(vertex);
        }
        let corner_entry = faces.corners().iter().map(|&v| entry_of[v as usize]).collect();
        let roots: Vec<u32> = match topology.has_welds() {
            true => entry_vertex.iter().map(|&v| entry_of[sets.find(v) as usize]).collect(),
            false => Vec::new(),
        };
        Self::new(corner_entry, entry_vertex, roots)
    }

    /// The fan rule: hard edges cut the fan around a vertex into groups. A closed fan cut by one edge stays one.
    pub(crate) fn by_fan(walker: &MeshWalker, vertex_count: usize) -> Self {
        const CHUNK: usize = 1024;
        let MeshFans { faces, topology, .. } = walker.fans;
        let labels = Scatter::new(faces.corners().len(), NONE);
        let mut counts = vec![0u32; vertex_count];
        counts.par_chunks_mut(CHUNK).enumerate().for_each_init(
            FanScratch::default,
            |scratch, (i, counts)| {
                for (j, count) in counts.iter_mut().enumerate() {
                    let vertex = (i * CHUNK + j) as u32;
                    if !topology.is_welded(vertex) {
                        let ring = topology.corners_at(vertex);
                        *count = if walker.is_smooth_ring(ring) {
                            ring.iter().for_each(|&corner| labels.set(corner, 0));
                            1
                        } else {
                            label_ring(walker, ring, &labels, scratch)
                        };
                    }
                }
            },
        );
        // Fans that continue at other vertices are walked one after the other.
        let (mut welded, mut count): (Vec<(u32, u32)>, u32) = (Vec::new(), 0);
        if topology.has_welds() {
            let corners = || 0..faces.corners().len() as u32;
            let here = |corner: u32| topology.is_welded(faces.corners()[corner as usize]);
            let mut scratch = FanScratch::default();
            for start in corners().filter(|&c| here(c) && !walker.fans.is_isolated(c)) {
                if labels.get(start) == NONE {
                    walker.sector(start, &mut scratch.sector);
                    walker.cuts(&scratch.sector, &mut scratch.places, &mut scratch.cuts);
                    let first = count;
                    for_each_piece(&scratch.sector, &scratch.cuts, |corner, piece| {
                        labels.set(corner, first + piece);
                        welded.push((first + piece, corner));
                        count = first + piece + 1;
                    });
                }
            }
            for isolated in corners().filter(|&c| here(c) && walker.fans.is_isolated(c)) {
                let ring = topology.corners_at(faces.corners()[isolated as usize]);
                let host = ring.iter().map(|&c| labels.get(c)).find(|&group| group != NONE);
                let group = host.unwrap_or(count);
                labels.set(isolated, group);
                welded.push((group, isolated));
                count = count.max(group + 1);
            }
        }
        welded.par_sort_unstable();
        assemble(faces, &labels, counts, &welded)
    }

    /// Entries from explicit groups of corners (the cone rule): `group` of each corner, numbered from 0.
    pub(crate) fn from_groups(faces: FacesRef, vertex_count: usize, group: &[u32]) -> Self {
        let labels = Scatter::new(faces.corners().len(), NONE);
        let mut corners: Vec<(u32, u32)> = group.iter().enumerate().map(|(c, &g)| (g, c as u32)).collect();
        corners.par_sort_unstable();
        assemble(faces, &labels, vec![0; vertex_count], &corners)
    }
}

#[derive(Default)]
pub(in crate::normals) struct FanScratch {
    pub(in crate::normals) sector: Sector,
    pub(in crate::normals) places: Vec<usize>,
    pub(in crate::normals) cuts: Vec<bool>,
    renumber: Vec<u32>,
}

/// Labels the corners at one vertex with the number of their group there, from 0, in the order of each group's
/// lowest corner; none of them may have a label before. Returns how many groups there are.
pub(in crate::normals) fn label_ring<F: Fans>(
    walker: &FanWalker<F>,
    ring: &[u32],
    labels: &Scatter,
    scratch: &mut FanScratch,
) -> u32 {
    let mut pieces = 0;
    for &start in ring.iter() {
        if labels.get(start) != NONE || walker.fans.is_isolated(start) {
            continue;
        }
        walker.sector(start, &mut scratch.sector);
        walker.cuts(&scratch.sector, &mut scratch.places, &mut scratch.cuts);
        let mut last = 0;
        for_each_piece(&scratch.sector, &scratch.cuts, |corner, piece| {
            labels.set(corner, pieces + piece);
            last = last.max(piece);
        });
        pieces += last + 1;
    }
    // Pieces were numbered as they were met; entries go by lowest corner.
    scratch.renumber.clear();
    scratch.renumber.resize(pieces as usize, NONE);
    let mut seen = 0;
    for &corner in ring.iter().filter(|&&corner| labels.get(corner) != NONE) {
        let number = &mut scratch.renumber[labels.get(corner) as usize];
        if *number == NONE {
            *number = seen;
            seen += 1;
        }
        labels.set(corner, *number);
    }
    // Corners of collapsed faces are in no fan. They join the first group, rather than make a vertex of their own.
    ring.iter().filter(|&&corner| labels.get(corner) == NONE).for_each(|&corner| labels.set(corner, 0));
    seen.max(u32::from(!ring.is_empty()))
}

/// Gives each corner of a sector the number of the piece that the cuts leave it in.
pub(in crate::normals) fn for_each_piece(sector: &Sector, cuts: &[bool], mut visit: impl FnMut(u32, u32)) {
    let count = sector.corners.len();
    // In a closed sector, pieces start behind a cut; the first one found will do.
    let first = if sector.closed { cuts.iter().position(|&cut| cut).map_or(0, |cut| cut + 1) } else { 0 };
    let mut piece = 0;
    for i in 0..count {
        let at = (first + i) % count;
        visit(sector.corners[at], piece);
        if cuts[at] && i + 1 < count {
            piece += 1;
        }
    }
}

/// Numbers the entries: by vertex, then by label. `across` has the groups that reach over several vertices as
/// (group, corner), ascending; their labels are given out here.
fn assemble(faces: FacesRef, labels: &Scatter, mut counts: Vec<u32>, across: &[(u32, u32)]) -> SmoothGroups {
    // Groups in the order of their lowest corner, so that labels at a vertex come in that order too.
    let mut groups: Vec<&[(u32, u32)]> = across.chunk_by(|a, b| a.0 == b.0).collect();
    groups.sort_unstable_by_key(|group| group[0].1);
    if !groups.is_empty() {
        let mut last_group = vec![NONE; counts.len()];
        for (i, group) in groups.iter().enumerate() {
            for &(_, corner) in *group {
                let vertex = faces.corners()[corner as usize] as usize;
                if last_group[vertex] != i as u32 {
                    last_group[vertex] = i as u32;
                    counts[vertex] += 1;
                }
                labels.set(corner, counts[vertex] - 1);
            }
        }
    }
    let mut total = 0;
    let firsts: Vec<u32> = counts
        .iter()
        .map(|&count| {
            total += count;
            total - count
        })
        .collect();
    let mut entry_vertex = Vec::with_capacity(total as usize);
    for (vertex, &count) in counts.iter().enumerate() {
        entry_vertex.extend(std::iter::repeat_n(vertex as u32, count as usize));
    }
    let corner_entry: Vec<u32> = faces
        .corners()
        .par_iter()
        .enumerate()
        .map(|(corner, &vertex)| firsts[vertex as usize] + labels.get(corner as u32))
        .collect();
    let mut alike: Vec<u32> = if groups.is_empty() { Vec::new() } else { (0..total).collect() };
    for group in &groups {
        let entries = group.iter().map(|&(_, corner)| corner_entry[corner as usize]);
        let lowest = entries.clone().min().expect("a group has corners");
        entries.for_each(|entry| alike[entry as usize] = lowest);
    }
    SmoothGroups::new(corner_entry, entry_vertex, alike)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Faces, Mesh, MeshBuilder, Weld};
    use crate::normals::creases::dihedral_test::CreaseTest;
    use crate::normals::creases::hard_edges::Marks;
    use crate::normals::faces::face_normals::FaceNormals;
    use crate::normals::faces::shape::FaceState;
    use crate::normals::recipe::{NormalRecipe, Slivers};
    use crate::num::Degrees;
    use glam::DVec3;

    fn mesh(positions: Vec<DVec3>, faces: &[&[u32]]) -> Mesh {
        let mut list = Faces::new();
        faces.iter().for_each(|face| list.push(face));
        MeshBuilder { positions: positions.into(), faces: list, ..MeshBuilder::default() }.build().unwrap()
    }

    /// A closed fan around vertex 0 whose faces turn by the given angles: face i has its normal at the sum of
    /// the first i angles. Only topology and normals matter here, so positions are left alone.
    fn fan(turns: &[f64], states: &[FaceState], closed: bool) -> (Mesh, FaceNormals) {
        let count = turns.len() as u32;
        let rim = if closed { count } else { count + 1 };
        let faces: Vec<[u32; 3]> = (0..count).map(|i| [0, 1 + i, 1 + (i + 1) % rim]).collect();
        let faces: Vec<&[u32]> = faces.iter().map(|face| face.as_slice()).collect();
        let mut angle = 0.0;
        let unit = turns
            .iter()
            .map(|turn| {
                angle += f64::to_radians(*turn);
                DVec3::new(libm::cos(angle), libm::sin(angle), 0.0)
            })
            .collect();
        (mesh(vec![DVec3::ZERO; rim as usize + 1], &faces), FaceNormals { unit, state: states.to_vec() })
    }

    fn at_centre(mesh: &Mesh, normals: &FaceNormals, angle: f64, cone: bool) -> (Vec<u32>, SmoothGroups) {
        let topology = Topology::build(mesh, Weld::Off);
        let marks = Marks::new(mesh, &NormalRecipe::default());
        let crease = CreaseTest::new(Some(Degrees(angle)));
        let walker = FanWalker {
            fans: MeshFans { faces: mesh.faces().view(), topology: &topology, marks: &marks },
            normals,
            crease,
            slivers: Slivers::Exclude,
        };
        let groups = if cone {
            SmoothGroups::by_cone(&walker, mesh.vertex_count()).0
        } else {
            SmoothGroups::by_fan(&walker, mesh.vertex_count())
        };
        let centre = topology.corners_at(0).iter().map(|&c| groups.corner_entry[c as usize]).collect();
        (centre, groups)
    }

    use FaceState::{Counted as C, Sliver as S, ZeroArea as Z};

    #[test]
    fn creases_cut_fans() {
        let (mesh, normals) = fan(&[0., 50., 10., 50., 10.], &[C; 5], false);
        assert_eq!(at_centre(&mesh, &normals, 40.0, false).0, [0, 1, 1, 2, 2]);
        assert_eq!(at_centre(&mesh, &normals, 60.0, false).0, [0; 5]);
        assert_eq!(at_centre(&mesh, &normals, 0.0, false).0, [0, 1, 2, 3, 4]);
        assert_eq!(at_centre(&mesh, &normals, 180.0, false).0, [0; 5]);
    }

    #[test]
    fn a_closed_fan_cut_once_stays_whole_and_cut_twice_has_two_groups() {
        // One sharp edge only: the rest of the way round comes back in small steps.
        let once = [0.0, 50.0, -17.0, -17.0, -16.0];
        let (mesh, normals) = fan(&once, &[C; 5], true);
        assert_eq!(at_centre(&mesh, &normals, 40.0, false).0, [0; 5]);
        let (mesh, normals) = fan(&[0., 50., 0., -50., 0.], &[C; 5], true);
        assert_eq!(at_centre(&mesh, &normals, 40.0, false).0, [0, 1, 1, 0, 0]);
    }

    /// A face that adds nothing must neither make nor hide a crease, whatever its own normal is.
    #[test]
    fn faces_that_add_nothing_do_not_decide() {
        let (mesh, normals) = fan(&[0., 90., -85., 5.], &[C, S, C, C], false);
        assert_eq!(at_centre(&mesh, &normals, 40.0, false).0, [0; 4], "a sliver does not cut");
        let (mesh, normals) = fan(&[0., 30., 30., 0.], &[C, Z, C, C], false);
        assert_eq!(at_centre(&mesh, &normals, 40.0, false).0, [0, 1, 2, 2], "nor bridge a crease of 60°");
        let (mesh, normals) = fan(&[0., 90., 0.], &[S, S, S], false);
        assert_eq!(at_centre(&mesh, &normals, 40.0, false).0, [0, 1, 1], "unless there is nothing else");
    }

    #[test]
    fn the_cone_rule_shares_entries_between_equal_sets() {
        let (mesh, normals) = fan(&[0., 30., 30., 30.], &[C; 4], false);
        let (centre, groups) = at_centre(&mesh, &normals, 40.0, true);
        assert_eq!(centre, [0, 1, 2, 3]);
        let members = groups.members.unwrap();
        assert_eq!(members.row(0), [0, 3]);
        assert_eq!(members.row(1), [0, 3, 6]);
        assert_eq!(members.row(3), [6, 9]);
        let (centre, _) = at_centre(&mesh, &normals, 100.0, true);
        assert_eq!(centre, [0; 4]);
        assert_eq!(at_centre(&mesh, &normals, 0.0, true).0, [0, 1, 2, 3]);
    }

    #[test]
    fn groups_go_on_across_welded_edges() {
        let corners = [[0., 0.], [1., 0.], [1., 1.], [0., 0.], [1., 1.], [0., 1.]];
        let soup = mesh(corners.map(|[x, y]| DVec3::new(x, y, 0.0)).to_vec(), &[&[0, 1, 2], &[3, 4, 5]]);
        let topology = Topology::build(&soup, Weld::Exact);
        let marks = Marks::new(&soup, &NormalRecipe::default());
        let normals = FaceNormals { unit: vec![DVec3::Z; 2], state: vec![C; 2] };
        let crease = CreaseTest::None;
        let walker = FanWalker {
            fans: MeshFans { faces: soup.faces().view(), topology: &topology, marks: &marks },
            normals: &normals,
            crease,
            slivers: Slivers::Exclude,
        };
        let groups = SmoothGroups::by_fan(&walker, 6);
        assert_eq!(groups.corner_entry, [0, 1, 2, 3, 4, 5]);
        assert_eq!(groups.corner_slots()[..], [0, 1, 2, 0, 2, 3]);
        assert_eq!(SmoothGroups::per_vertex(soup.faces().view(), &topology, 6), groups);
    }

    /// A face without area between two others must not cost a vertex.
    #[test]
    fn collapsed_faces_add_no_entries() {
        let square = [[0., 0.], [1., 0.], [1., 1.], [0., 1.]].map(|[x, y]| DVec3::new(x, y, 0.0)).to_vec();
        let faces: [&[&[u32]]; 2] =
            [&[&[0, 1, 2], &[0, 2, 2], &[0, 2, 3]], &[&[0, 1, 2], &[0, 2, 2, 0], &[0, 2, 3]]];
        for faces in faces {
            let mesh = mesh(square.clone(), faces);
            let unit = vec![DVec3::Z, DVec3::ZERO, DVec3::Z];
            let normals = FaceNormals { unit, state: vec![C, Z, C] };
            let (_, groups) = at_centre(&mesh, &normals, 40.0, false);
            assert_eq!(groups.entry_vertex, [0, 1, 2, 3]);
        }
    }
}
