//! Findings about geometry that spoils normals: faces, edges, vertices.

use crate::mesh::Link;
use crate::normals::FaultReason;
use crate::num::{Degrees, Radians};
use crate::quality::catalogue::Kind;
use crate::quality::counts::{Gauge, Remark, Spot, Tallies, scan};
use crate::quality::effect::lost_light::key_light_lost;
use crate::quality::estimate::other_programs;
use crate::quality::facts::{Facts, InsideOut, Significance};
use crate::quality::finding::Severity;
use crate::quality::geometry::angle_limit::Limit;
use crate::quality::geometry::duplicates;
use crate::quality::geometry::polygons;
use crate::quality::geometry::slenderness;
use crate::quality::thresholds::Thresholds;
use glam::DVec3;
use rayon::prelude::*;

/// Everything about the shape of a part.
pub(in crate::quality) fn find(facts: &Facts<'_>, thresholds: &Thresholds, found: &mut Tallies) {
    duplicates::faces(facts, found);
    duplicates::vertices(facts, found);
    winding(facts, found);
    let folded = Limit::new(thresholds.fold.0);
    let faces = scan(facts.mesh.face_count(), thresholds.places, |faces, found| {
        for face in faces {
            slenderness::look_at(facts, face, thresholds, found);
            polygons::look_at(facts, face, thresholds, found);
            for half_edge in facts.mesh.faces().range(face) {
                fold(facts, face, half_edge as u32, folded, found);
            }
        }
    });
    found.merge(faces);
    faults(facts, found);
    let vertices = scan(facts.mesh.vertex_count(), thresholds.places, |vertices, found| {
        vertices.for_each(|vertex| fans(facts, vertex, thresholds, found));
    });
    found.merge(vertices);
    crowded_edges(facts, found);
    far_from_origin(facts, thresholds, found);
}

/// Faces that run against their neighbours, and components that face the wrong way.
fn winding(facts: &Facts<'_>, found: &mut Tallies) {
    // Pieces that only touch may run as they like; their edges are no edges by index.
    let by_index = |half_edge: usize| match facts.topology.link(half_edge as u32) {
        Link::Inconsistent(other) => {
            let corners = facts.mesh.faces().corners();
            facts.topology.ends(corners, half_edge as u32) == facts.topology.ends(corners, other)
        }
        _ => false,
    };
    let mut certain = !facts.shares_vertices;
    // A face that stands twice runs the same way as its double: that is told as what it is.
    let is_single = |face: &&u32| facts.doubles.same_way().binary_search(face).is_err();
    // What has no direction shows none.
    let is_seen = |face: &&u32| facts.worth[**face as usize] != Significance::Silent;
    for &face in facts.minority.iter().filter(is_single).filter(is_seen) {
        certain |= facts.mesh.faces().range(face as usize).any(by_index);
        found.add(
            Kind::InconsistentWinding,
            Spot::face(face as usize, 0.0).by(180.0),
            facts.area[face as usize],
        );
    }
    if !certain {
        found.tally(Kind::InconsistentWinding).severity = Some(Severity::Warning);
    }
    inside_out(facts, found);
    for &face in &facts.outward.room_faces {
        found.add(Kind::Room, Spot::face(face as usize, 0.0), facts.area[face as usize]);
    }
    if facts.outward.rooms > 0 {
        found.tally(Kind::Room).components = facts.outward.rooms as u64;
    }
    if facts.outward.non_orientable > 0 {
        let half_edges = 0..facts.mesh.faces().corner_count() as u32;
        let turned =
            half_edges.filter(|&h| matches!(facts.topology.link(h), Link::Inconsistent(other) if h < other));
        for half_edge in turned {
            let face = facts.topology.face_of(half_edge) as usize;
            if facts.minority.binary_search(&(face as u32)).is_err() {
                found.add(Kind::NonOrientable, Spot::face(face, 0.0).by(180.0), facts.area[face]);
            }
        }
    }
}

/// Components that face the wrong way as a whole: closed ones by their volume, those with a rim by what is seen of them. Only
/// those of the gravest severity are counted, which a finding has one of.
fn inside_out(facts: &Facts<'_>, found: &mut Tallies) {
    let gravest = [false, true].map(|is_open| {
        let alike = facts.inside_out.iter().filter(|component| component.is_open == is_open);
        alike.map(InsideOut::severity).max()
    });
    for component in &facts.inside_out {
        let kind = component.kind();
        let severity = component.severity();
        // The back of faces that stand there as well is told as that.
        if component.is_open && component.faces.iter().all(|&face| facts.doubles.is_back(face)) {
            continue;
        }
        if gravest[usize::from(component.is_open)] > Some(severity) {
            found.tally(kind).milder.add(1, component.faces.len() as u64);
            continue;
        }
        for &face in &component.faces {
            found.add(kind, Spot::face(face as usize, 0.0).by(180.0), facts.area[face as usize]);
        }
        let tally = found.tally(kind);
        tally.components += 1;
        tally.confidence = Some(if component.is_open { facts.outward.confidence } else { 1.0 });
        tally.severity = Some(severity);
    }
}

/// Height over longest edge, of a triangle; of a polygon, that of a triangle with its area.
fn height_over_length(facts: &Facts<'_>, face: usize) -> f64 {
    let range = facts.mesh.faces().range(face);
    let length = |corner: usize| {
        (facts.place(facts.topology.next(corner as u32) as usize) - facts.place(corner)).length_squared()
    };
    let longest = range.map(length).fold(0.0, f64::max);
    2.0 * facts.area[face] / longest
}

/// Edges where the surface turns back.
fn fold(facts: &Facts<'_>, face: usize, half_edge: u32, folded: Limit, found: &mut Tallies) {
    match facts.topology.link(half_edge) {
        Link::Twin(across) | Link::Welded(across) if half_edge < across => {
            let other = facts.topology.face_of(across) as usize;
            if facts.area[face] == 0.0 || facts.area[other] == 0.0 {
                return;
            }
            if let Some(bend) = folded.exceeded(facts.face_normal(face), facts.face_normal(other)) {
                found.add(Kind::Folded, Spot::corner(face, half_edge as usize, bend), 0.0);
            }
        }
        _ => {}
    }
}

/// Edges of more than two faces, each once.
fn crowded_edges(facts: &Facts<'_>, found: &mut Tallies) {
    let corners = facts.mesh.faces().corners();
    let place =
        |vertex: u32| (facts.mesh.positions()[vertex as usize] + DVec3::ZERO).to_array().map(f64::to_bits);
    let mut edges: Vec<([[u64; 3]; 2], u32)> = (0..corners.len() as u32)
        .into_par_iter()
        .filter_map(|half_edge| {
            let (tail, head) = facts.topology.ends(corners, half_edge);
            let ends = match facts.topology.link(half_edge) {
                // By index where it is one by index, else by place.
                Link::NonManifold => [[u64::from(tail); 3], [u64::from(head); 3]],
                Link::Ambiguous => [place(tail), place(head)],
                _ => return None,
            };
            let [a, b] = ends;
            Some(([a.min(b), a.max(b)], half_edge))
        })
        .collect();
    edges.par_sort_unstable();
    for edge in edges.chunk_by(|a, b| a.0 == b.0) {
        let half_edge = edge[0].1;
        let face = facts.topology.face_of(half_edge) as usize;
        let spot = Spot::corner(face, half_edge as usize, 0.0).of(Gauge::Amount, edge.len() as f64);
        found.add(Kind::NonManifold, spot, 0.0);
    }
}

/// What computing normals ran into.
fn faults(facts: &Facts<'_>, found: &mut Tallies) {
    for fault in &facts.field.faults.faces {
        let spot = Spot::face(fault.index as usize, 0.0);
        let (kind, spot) = match fault.reason {
            // What crosses itself has area, up and down.
            FaultReason::ZeroArea if polygons::is_balanced(facts, fault.index as usize) => continue,
            FaultReason::ZeroArea => (Kind::ZeroArea, spot),
            // What turns round the longest edge by chance is off by a right angle in the mean.
            FaultReason::BelowStorage => (Kind::BelowStorage, spot.by(90.0)),
            _ => continue,
        };
        found.add(kind, spot, facts.area[fault.index as usize]);
    }
    for fault in facts.field.faults.corners.iter().filter(|fault| fault.reason == FaultReason::CancellingFan)
    {
        let face = facts.topology.face_of(fault.index) as usize;
        let area = facts.area[face] / facts.mesh.faces().range(face).len() as f64;
        let spot = Spot::corner(face, fault.index as usize, 0.0).of(Gauge::Steps, key_light_lost());
        found.add(Kind::Cancelling, spot, area);
    }
}

/// Vertices with many faces, and those where several fans touch.
fn fans(facts: &Facts<'_>, vertex: usize, thresholds: &Thresholds, found: &mut Tallies) {
    let ring = facts.topology.corners_at(vertex as u32);
    if ring.len() as u64 > u64::from(thresholds.valence) {
        found.add(Kind::HighValence, Spot::vertex(vertex, 0.0).of(Gauge::Amount, ring.len() as f64), 0.0);
    }
    // Where a seam passes, the fan goes on at other vertices; non-manifold edges are told as such.
    if facts.topology.is_welded(vertex as u32) {
        return;
    }
    let mut rims = 0;
    for &corner in ring {
        match facts.topology.link(corner) {
            Link::Boundary => rims += 1,
            Link::Twin(_) => {}
            _ => return,
        }
        if !matches!(facts.topology.link(facts.topology.previous(corner)), Link::Boundary | Link::Twin(_)) {
            return;
        }
    }
    let Some(&start) = ring.first() else { return };
    if rims > 1 || !is_one_fan(facts, start, ring.len(), rims) {
        let spot = Spot::vertex(vertex, 0.0).by(other_programs::by_index(facts, vertex as u32));
        found.add(Kind::PinchedVertices, spot, 0.0);
    }
}

/// Whether walking from a corner reaches all corners of its vertex, over edges by index.
fn is_one_fan(facts: &Facts<'_>, start: u32, corners: usize, rims: usize) -> bool {
    let twin = |half_edge: u32| match facts.topology.link(half_edge) {
        Link::Twin(across) => Some(across),
        _ => None,
    };
    let (mut corner, mut reached) = (start, 1);
    while let Some(across) = twin(corner) {
        corner = facts.topology.next(across);
        if corner == start {
            return reached == corners && rims == 0;
        }
        reached += 1;
    }
    corner = start;
    while let Some(across) = twin(facts.topology.previous(corner)) {
        corner = across;
        reached += 1;
    }
    reached == corners
}

/// What rounding to 32 bits does to the normal of a usual face.
fn far_from_origin(facts: &Facts<'_>, thresholds: &Thresholds, found: &mut Tallies) {
    /// Faces looked at.
    const SAMPLE: usize = 10_000;
    let Some((low, high)) = facts.mesh.bounds() else { return };
    let farthest = low.abs().max(high.abs()).max_element() * facts.scale;
    // A dense mesh round the origin has small faces too; far is what lies outside its own size.
    if farthest < 4.0 * facts.size {
        return;
    }
    let unit = |x: f64| f64::from((x as f32).next_up()) - f64::from(x as f32);
    let units = DVec3::from(low.abs().max(high.abs()).to_array().map(unit)) * facts.scale;
    let stride = facts.mesh.face_count().div_ceil(SAMPLE).max(1);
    let sampled = (0..facts.mesh.face_count()).step_by(stride).filter(|&face| facts.area[face] > 0.0);
    let (mut heights, tilts): (Vec<f64>, Vec<f64>) = sampled
        .map(|face| {
            let height = (2.0 * facts.area[face] * height_over_length(facts, face)).sqrt();
            (height, expected_tilt(facts, face, units))
        })
        .unzip();
    if heights.is_empty() {
        return;
    }
    heights.sort_unstable_by(f64::total_cmp);
    let height = heights[heights.len() / 2];
    let tilt = tilts.iter().sum::<f64>() / tilts.len() as f64;
    // Half a unit in the last place of 24 bits at each of the two ends of the height.
    let rounding = farthest * f64::from(f32::EPSILON) / 2.0;
    let error = Degrees::from(Radians(libm::atan2(2.0 * rounding, height))).0;
    if error > thresholds.rounding.0 {
        found.add(Kind::FarFromOrigin, Spot::mesh().by(error), facts.total_area);
        let bits = libm::floor(libm::log2(height / rounding)).max(0.0);
        let expected = Degrees::from(Radians(libm::atan(tilt))).0;
        let text = format!(
            "{bits} bits are left for the height of a usual face, whose normal may be off by {error:.2}°; over all faces, slender \
             ones too, {expected:.2}° are expected in the mean"
        );
        found.tally(Kind::FarFromOrigin).remark = Some(Remark { weight: error, text });
    }
}

/// The mean tangent of the angle by which a face's normal turns if each coordinate of its corners is rounded to multiples of a
/// unit in the last place: errors eᵢ along the normal n, of variance Σ (n units)²/12, turn the area vector ½ Σ pᵢ × pᵢ₊₁ by
/// ½ Σ eᵢ n × (pᵢ₊₁ − pᵢ₋₁), and the mean length of such a plane vector is √(π/4) of its root mean square.
fn expected_tilt(facts: &Facts<'_>, face: usize, units: DVec3) -> f64 {
    let place = |corner: u32| facts.place(corner as usize);
    let chord = |corner: u32| place(facts.topology.next(corner)) - place(facts.topology.previous(corner));
    let squares = facts.mesh.faces().range(face).map(|corner| chord(corner as u32).length_squared());
    let inverse_heights = squares.sum::<f64>().sqrt() / (2.0 * facts.area[face]);
    let along = (facts.face_normal(face) * units).length() / 12f64.sqrt();
    (std::f64::consts::PI / 4.0).sqrt() * along * inverse_heights
}
