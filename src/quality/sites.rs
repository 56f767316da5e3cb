//! Where an occurrence is in its file.

use crate::io::{Document, FileNode, Format, Loaded};
use crate::mesh::NONE;
use crate::quality::finding::Site;
use crate::quality::spot::Spot;
use glam::DVec3;

/// The site of an occurrence, without node and line.
pub(crate) fn site(loaded: &Loaded, spot: &Spot) -> Site {
    let is = |number: u32| (number != NONE).then_some(number);
    let mesh = &loaded.parts[spot.part as usize].mesh;
    let (positions, faces) = (mesh.positions(), mesh.faces());
    let vertex = is(spot.vertex).or_else(|| is(spot.corner).map(|corner| faces.corners()[corner as usize]));
    let centre = |face: u32| {
        let corners = faces.face(face as usize);
        corners.iter().map(|&v| positions.at(v) / corners.len() as f64).sum::<DVec3>()
    };
    Site {
        part: spot.part as usize,
        face: is(spot.face),
        corner: is(spot.corner).map(|corner| corner - faces.range(spot.face as usize).start as u32),
        vertex,
        position: vertex.map(|vertex| positions.at(vertex)).or_else(|| is(spot.face).map(centre)),
        degrees: spot.degrees,
        place: is(spot.node),
        node: None,
        line: None,
    }
}

/// Adds to every site where it is in the file: the path to the first node that has its part (glTF), or the line of its face, or of
/// its vertex if it is on none (OBJ).
pub(crate) fn locate<'a>(sites: impl Iterator<Item = &'a mut Site>, loaded: &Loaded) {
    let mut sites: Vec<&mut Site> = sites.collect();
    if !loaded.nodes.is_empty() {
        let nodes = nodes_of_parts(loaded);
        let first = |site: &Site| {
            let place = site.place.unwrap_or_default() as usize;
            nodes[site.part].get(place).map(|node| node.number)
        };
        let numbers: Vec<usize> = sites.iter().filter_map(|site| first(site)).collect();
        let placed = sites.iter_mut().filter(|site| first(site).is_some());
        placed.zip(loaded.node_paths(&numbers)).for_each(|(site, path)| site.node = Some(path));
    }
    if loaded.format == Format::Stl {
        sites.iter_mut().for_each(|site| site.vertex = vertex_in_stl(site, loaded));
    }
    if let Document::Obj(document) = &loaded.document {
        for site in sites {
            site.line = match (site.face, site.vertex) {
                (Some(face), _) => document.lines().of_face(face),
                (None, Some(vertex)) => document.lines().of_vertex(vertex),
                (None, None) => None,
            };
        }
    }
}

/// The number of a site's vertex if every facet has three of its own, as in the file, whether the mesh shares them or not.
fn vertex_in_stl(site: &Site, loaded: &Loaded) -> Option<u32> {
    let faces = loaded.parts[site.part].mesh.faces();
    let vertex = site.vertex?;
    let first = || faces.corners().iter().position(|&other| other == vertex).map(|corner| corner as u32);
    site.face
        .zip(site.corner)
        .map(|(face, corner)| faces.range(face as usize).start as u32 + corner)
        .or_else(first)
}

pub(crate) fn nodes_of_parts(loaded: &Loaded) -> Vec<Vec<&FileNode>> {
    let mut nodes = vec![Vec::new(); loaded.parts.len()];
    loaded.nodes.iter().for_each(|node| nodes[node.part].push(node));
    nodes
}
