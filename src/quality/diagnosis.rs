//! From a file to its findings.

use crate::io::{Document, FileNode, Format, Loaded};
use crate::mesh::{Mesh, NONE, normal_matrix};
use crate::quality::catalogue::{Kind, entries};
use crate::quality::counts::{Gauge, Milder, Remark, Spot, Tallies, Tally, least, weightier};
use crate::quality::effect::lost_light::key_light_lost;
use crate::quality::effect::lost_light::key_light_steps;
use crate::quality::effect::risk_findings;
use crate::quality::effect::specular_exponent::{self, Gloss};
use crate::quality::estimate::other_programs;
use crate::quality::estimate::recipe::Estimate;
use crate::quality::facts::Facts;
use crate::quality::finding::{Element, Finding, Severity, Site};
use crate::quality::geometry::geometry_findings;
use crate::quality::smoothing::smoothing_findings;
use crate::quality::storage::quantisation::Precision;
use crate::quality::stored::attributes;
use crate::quality::stored::coordinate_space::Spaces;
use crate::quality::stored::neighbours::Around;
use crate::quality::stored::stored_findings;
use crate::quality::thresholds::Thresholds;
use glam::DMat3;

/// What was found in a file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Diagnosis {
    /// The file's parts, in their order.
    pub parts: Vec<PartDiagnosis>,
    /// Findings over all parts: the gravest first, then in the order of the catalogue.
    pub findings: Vec<Finding>,
}

/// A part of a file.
#[derive(Clone, Debug, Default, PartialEq, serde::Serialize)]
pub struct PartDiagnosis {
    /// Its name.
    pub name: String,
    /// Vertices that faces use; in STL every corner has its own.
    pub vertices: usize,
    /// Faces.
    pub faces: usize,
    /// Corners of all faces.
    pub corners: usize,
    /// How its stored normals were made; `None` if it has none that tell.
    pub estimate: Option<Estimate>,
    /// What they were rounded to; `None` if that is no grid of ours, or they are too few to tell.
    pub precision: Option<Precision>,
}

impl Diagnosis {
    /// The gravest severity; `None` if nothing was found.
    pub fn worst(&self) -> Option<Severity> {
        self.findings.iter().map(|finding| finding.severity).max()
    }

    /// How many findings have this severity.
    pub fn count(&self, severity: Severity) -> usize {
        self.findings.iter().filter(|finding| finding.severity == severity).count()
    }

    /// The finding of a kind, if there is one.
    pub fn get(&self, kind: Kind) -> Option<&Finding> {
        self.findings.iter().find(|finding| finding.kind == kind)
    }
}

/// Looks for everything in the catalogue in every part of a file.
///
/// `done` is told the number of faces of each part that is finished. Time is linear in the mesh, but for sorting; the
/// result is the same for any number of threads.
///
/// ```
/// use crease::io::{Format, ReadOptions, read_bytes};
/// use crease::quality::{Severity, Thresholds, diagnose};
///
/// let down = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 -1\nf 1//1 2//1 3//1\n";
/// let loaded = read_bytes(down.to_vec(), Some(Format::Obj), None, &ReadOptions::default())?;
/// let diagnosis = diagnose(&loaded, &Thresholds::default(), &|_| {});
/// assert_eq!(diagnosis.worst(), Some(Severity::Error));
/// assert_eq!(diagnosis.findings[0].kind.id(), "inverted-normals");
/// # Ok::<(), crease::io::ReadError>(())
/// ```
pub fn diagnose(loaded: &Loaded, thresholds: &Thresholds, done: &dyn Fn(usize)) -> Diagnosis {
    let mut diagnosis = Diagnosis::default();
    let mut merged: Vec<Merged> = entries().map(|_| Merged::default()).collect();
    let nodes_of_parts = nodes_of_parts(loaded);
    let around = Around::new(loaded, thresholds.weld);
    let spaces = Spaces::new(loaded);
    let materials = specular_exponent::materials(loaded, thresholds.exponent);
    for (number, part) in loaded.parts.iter().enumerate() {
        let mut own = PartDiagnosis { name: part.name.clone(), ..PartDiagnosis::default() };
        if part.mesh.face_count() > 0 {
            let nodes = &nodes_of_parts[number];
            let gloss = Gloss::new(&part.mesh, &materials, thresholds.exponent);
            let mut facts = Facts::new(&around, number, thresholds.confidence, gloss);
            let mut found = Tallies::new(thresholds.places);
            // What is told of normals of another space is of what they are in that of the mesh.
            let mistaken = spaces.mistaken(&facts, nodes, thresholds);
            if let Some(mistaken) = &mistaken {
                let mesh = &mistaken.taken_back;
                let gloss = Gloss::new(mesh, &materials, thresholds.exponent);
                let mut back = Facts::of(&around, (number, mesh), thresholds.confidence, gloss);
                if mistaken.is_proved(facts.estimate, back.estimate) {
                    mistaken.tell(&facts, thresholds.places, &mut found);
                    back.written = facts.stored;
                    back.estimate.iter_mut().for_each(|estimate| estimate.turned = true);
                    facts = back;
                }
            }
            own.precision = look(&facts, nodes, thresholds, &mut found);
            attributes::find(&facts, loaded, number, thresholds, &mut found);
            if let Some(near) = facts.near {
                found.add_to_remedies(&format!("--weld {near:e}"));
            }
            own.estimate = facts.estimate;
            own.faces = part.mesh.face_count();
            own.corners = part.mesh.faces().corner_count();
            own.vertices =
                if facts.shares_vertices { facts.field.summary.referenced_vertices } else { own.corners };
            for (entry, merged) in entries().zip(&mut merged) {
                merged.of += elements(&facts, entry.element, nodes.len());
                merged.all_area += facts.total_area / (facts.scale * facts.scale);
                merged.add((entry.kind, found.take(entry.kind)), &facts, number);
                merged.sites.truncate(thresholds.places);
            }
        }
        done(part.mesh.face_count());
        diagnosis.parts.push(own);
    }
    if diagnosis.parts.iter().all(|part| part.faces == 0) {
        merged[Kind::NoFaces as usize] = Merged::whole_file(!diagnosis.parts.is_empty());
    }
    diagnosis.findings =
        entries().zip(merged).filter_map(|(entry, merged)| merged.finding(entry.kind)).collect();
    locate(diagnosis.findings.iter_mut().flat_map(|finding| &mut finding.places), loaded);
    diagnosis.findings.sort_by_key(|finding| (std::cmp::Reverse(finding.severity), finding.kind));
    diagnosis
}

/// Adds to every place where it is in the file: the way to the first node that has its part (glTF), or the line of its face,
/// of its vertex where it is on none (OBJ).
pub(super) fn locate<'a>(sites: impl Iterator<Item = &'a mut Site>, loaded: &Loaded) {
    let mut sites: Vec<&mut Site> = sites.collect();
    if !loaded.nodes.is_empty() {
        let nodes = nodes_of_parts(loaded);
        let first = |site: &Site| {
            let place = site.place.unwrap_or_default() as usize;
            nodes[site.part].get(place).map(|node| node.number)
        };
        let numbers: Vec<usize> = sites.iter().filter_map(|site| first(site)).collect();
        let reported = sites.iter_mut().filter(|site| first(site).is_some());
        reported.zip(loaded.node_paths(&numbers)).for_each(|(site, path)| site.node = Some(path));
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

/// The number of a place's vertex where every facet has three of its own, as in the file, whether these are shared by now or not.
fn vertex_in_stl(site: &Site, loaded: &Loaded) -> Option<u32> {
    let faces = loaded.parts[site.part].mesh.faces();
    let vertex = site.vertex?;
    let first = || faces.corners().iter().position(|&other| other == vertex).map(|corner| corner as u32);
    site.face
        .zip(site.corner)
        .map(|(face, corner)| faces.range(face as usize).start as u32 + corner)
        .or_else(first)
}

/// The nodes of each part, in their order.
fn nodes_of_parts(loaded: &Loaded) -> Vec<Vec<&FileNode>> {
    let mut nodes = vec![Vec::new(); loaded.parts.len()];
    loaded.nodes.iter().for_each(|node| nodes[node.part].push(node));
    nodes
}

fn look(
    facts: &Facts<'_>,
    nodes: &[&FileNode],
    thresholds: &Thresholds,
    found: &mut Tallies,
) -> Option<Precision> {
    let precision = stored_findings::find(facts, thresholds, found);
    smoothing_findings::find(facts, thresholds, found);
    geometry_findings::find(facts, thresholds, found);
    risk_findings::find(facts, thresholds, found);
    for (number, node) in nodes.iter().enumerate() {
        place(number, node, found);
    }
    precision
}

/// What the places of a part in the world mean for its normals.
fn place(number: usize, node: &FileNode, found: &mut Tallies) {
    let Some(matrix) = normal_matrix(DMat3::from_mat4(node.world_from_part)) else {
        found.add(Kind::SingularNode, Spot::node(number).of(Gauge::Steps, key_light_lost()), 0.0);
        return;
    };
    if matrix.mirrored() {
        // To a viewer that does not turn the winding.
        found.add(Kind::MirroredNode, Spot::node(number).by(180.0), 0.0);
    }
}

/// How many elements of a kind a part has.
fn elements(facts: &Facts<'_>, element: Element, nodes: usize) -> u64 {
    let edges = &facts.field.summary.edges;
    let count = match element {
        Element::Corner => facts.mesh.faces().corner_count(),
        Element::Face => facts.mesh.face_count(),
        Element::Edge => {
            edges.smooth
                + edges.boundary
                + edges.non_manifold
                + edges.inconsistent
                + edges.ambiguous
                + edges.marked
                + edges.crease
        }
        Element::Vertex => facts.field.summary.referenced_vertices,
        Element::Node => nodes,
        Element::Mesh => 1,
    };
    count as u64
}

/// One kind of finding over all parts.
#[derive(Default)]
struct Merged {
    count: u64,
    of: u64,
    area: f64,
    all_area: f64,
    severity: Option<Severity>,
    sites: Vec<(Spot, Site)>,
    /// How much of it the part has whose remedy is told: no other has more.
    most: u64,
    remark: Option<Remark>,
    mergeable: usize,
    components: u64,
    /// What is less grave, of components or in other parts, which is not counted.
    milder: Milder,
    remedy: Option<String>,
    /// In one of the parts it may be meant.
    may_be_meant: bool,
    confidence: Option<f64>,
    turn: Option<f64>,
}

impl Merged {
    /// Something about the file, not about a part.
    fn whole_file(has_parts: bool) -> Self {
        let severity = Some(Severity::Error);
        let first_part = has_parts.then(|| (Spot::mesh(), Site::default()));
        Self { count: 1, of: 1, severity, sites: first_part.into_iter().collect(), ..Self::default() }
    }

    fn add(&mut self, (kind, tally): (Kind, Tally), facts: &Facts<'_>, part: usize) {
        if tally.count == 0 {
            return;
        }
        let severity = tally.severity.unwrap_or(Severity::Error).min(kind.entry().severity);
        // To mend the file is to mend all of its parts.
        self.may_be_meant |= tally.may_be_meant;
        if self.severity > Some(severity) {
            self.milder.add(tally.components, tally.count);
            return;
        }
        if self.count > 0 && self.severity < Some(severity) {
            self.milder.add(self.components, self.count);
            let (of, all_area, milder, may_be_meant) =
                (self.of, self.all_area, self.milder, self.may_be_meant);
            *self = Self { of, all_area, milder, may_be_meant, ..Self::default() };
        }
        self.milder.add(tally.milder.components, tally.milder.count);
        self.count += tally.count;
        self.area += tally.area / (facts.scale * facts.scale);
        self.severity = self.severity.max(Some(severity));
        if tally.count > self.most {
            self.most = tally.count;
            self.remedy = tally.remedy;
        }
        self.remark = weightier(self.remark.take(), tally.remark);
        self.mergeable += tally.mergeable;
        self.components += tally.components;
        self.confidence = least(self.confidence, tally.confidence);
        self.turn = self.turn.into_iter().chain(tally.turn).reduce(f64::max);
        let site = |spot: Spot| {
            let mut site = site(facts.mesh, spot, part);
            site.degrees = site.degrees.or_else(|| other_programs::next_to(facts, kind, &spot));
            (spot, site)
        };
        self.sites.extend(tally.worst.into_iter().map(site));
        // Stable: among equals earlier parts come first.
        self.sites.sort_by(|a, b| b.0.weight.total_cmp(&a.0.weight));
    }

    fn finding(self, kind: Kind) -> Option<Finding> {
        let entry = kind.entry();
        let severity = self.severity?.min(entry.severity);
        let off = self.sites.iter().filter_map(|(_, site)| site.degrees).reduce(f64::max);
        let degrees = self.turn.or(off);
        let steps = self.sites.iter().filter_map(|(spot, site)| match spot.gauge {
            Gauge::Steps => Some(spot.weight),
            _ => site.degrees.map(|degrees| key_light_steps(self.turn.unwrap_or(degrees))),
        });
        let steps = steps.reduce(f64::max);
        let amount = self.sites.first().filter(|(spot, _)| spot.gauge == Gauge::Amount);
        let what = if kind == Kind::OpenInsideOut { "open" } else { "closed" };
        let of_components = match self.components {
            0 => None,
            1 => Some(format!("in 1 {what} component")),
            many => Some(format!("in {many} {what} components")),
        };
        let of_components = of_components.map(|reported| match self.milder {
            Milder { components: 0, .. } => reported,
            Milder { components, count } => {
                let plural = if components == 1 { "" } else { "s" };
                format!(
                    "{reported}, against the stored normals; not counted: {components} other{plural} of {count} faces, which no stored \
                     normals contradict"
                )
            }
        });
        let of_vertices = (self.mergeable > 0).then(|| {
            let vertices = if self.mergeable == 1 { "vertex" } else { "vertices" };
            format!("{} {vertices} could be merged away", self.mergeable)
        });
        let remark = self.remark.map(|remark| remark.text);
        let of_others = match self.milder {
            Milder { components: 0, count: 1.. } => {
                Some(format!("not counted: {} in other parts, where it matters less", self.milder.count))
            }
            _ => None,
        };
        let said = [remark.or(of_vertices).or(of_components), of_others].into_iter().flatten();
        let said = said.collect::<Vec<_>>().join("; ");
        let cause = if said.is_empty() { entry.title() } else { format!("{}: {said}", entry.title()) };
        Some(Finding {
            kind,
            severity,
            cause,
            count: self.count,
            of: self.of,
            area_share: entry.element.has_area().then(|| match self.all_area {
                all if all > 0.0 => (self.area / all).min(1.0),
                _ => 0.0,
            }),
            degrees,
            steps,
            amount: amount.map(|(spot, _)| spot.weight.abs()),
            confidence: self.confidence,
            places: self.sites.into_iter().map(|(_, site)| site).collect(),
            remedy: self.remedy.or_else(|| entry.remedy.map(str::to_owned)).filter(|_| !self.may_be_meant),
        })
    }
}

/// Where an occurrence is, as it is told.
pub(super) fn site(mesh: &Mesh, spot: Spot, part: usize) -> Site {
    let is = |number: u32| (number != NONE).then_some(number);
    let faces = mesh.faces();
    let corner = is(spot.corner).map(|corner| corner - faces.range(spot.face as usize).start as u32);
    let vertex = is(spot.vertex).or_else(|| is(spot.corner).map(|corner| faces.corners()[corner as usize]));
    let position = match (vertex, is(spot.face)) {
        (Some(vertex), _) => Some(mesh.positions()[vertex as usize]),
        (None, Some(face)) => {
            let corners = faces.face(face as usize);
            let sum: glam::DVec3 =
                corners.iter().map(|&v| mesh.positions()[v as usize] / corners.len() as f64).sum();
            Some(sum)
        }
        (None, None) => None,
    };
    let degrees = (spot.gauge == Gauge::Angle).then_some(spot.weight);
    let place = is(spot.node);
    Site { part, face: is(spot.face), corner, vertex, position, degrees, place, node: None, line: None }
}
