//! From a file to its findings.

use crate::io::{FileNode, Loaded, NodeTree};
use crate::mesh::NONE;
use crate::quality::angles::Limit;
use crate::quality::catalogue::{Entry, Kind, entries};
use crate::quality::counts::{Found, Tallies};
use crate::quality::element::{Element, Severity};
use crate::quality::estimate::recipe::Estimate;
use crate::quality::facts::Facts;
use crate::quality::finding::Finding;
use crate::quality::findings::geometry::{duplicates, edges, face_shape, placement, vertices};
use crate::quality::findings::shading;
use crate::quality::findings::smoothing::{seams, sharpness};
use crate::quality::findings::storage::quantisation::{self, Precision};
use crate::quality::findings::stored::coordinate_space::find_mistake;
use crate::quality::findings::stored::{deviations, values};
use crate::quality::findings::winding;
use crate::quality::input::file::FileContext;
use crate::quality::sites::{locate, nodes_of_parts, site};
use crate::quality::spot::Spot;
use crate::quality::thresholds::Thresholds;
use std::cell::OnceCell;

/// The diagnosis of a file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Diagnosis {
    /// The file's parts, in their order.
    pub parts: Vec<PartDiagnosis>,
    /// Findings over all parts: the most severe first, then in the order of the catalogue.
    pub findings: Vec<Finding>,
}

/// A part of a file.
#[derive(Clone, Debug, Default, PartialEq, serde::Serialize)]
pub struct PartDiagnosis {
    /// The name of the part.
    pub name: String,
    /// Vertices that faces use; in STL every corner has its own.
    pub vertices: usize,
    /// Faces.
    pub faces: usize,
    /// Corners of all faces.
    pub corners: usize,
    /// How its stored normals were made; `None` if it has none with a direction.
    pub estimate: Option<Estimate>,
    /// What they were rounded to; `None` if that is no known grid, or they are too few.
    pub precision: Option<Precision>,
}

impl Diagnosis {
    /// The highest severity; `None` if nothing was found.
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

/// Searches every part of a file for all findings of the catalogue.
///
/// `done` is called with the number of faces of each part that is finished. Time is linear in the mesh except for sorting. The
/// result does not depend on the number of threads.
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
    let (parts, mut totals) = search_parts(loaded, thresholds, done);
    let mut diagnosis = Diagnosis { parts, findings: Vec::new() };
    diagnosis.findings = entries().filter_map(|entry| totals.finding(entry, loaded)).collect();
    locate(diagnosis.findings.iter_mut().flat_map(|finding| &mut finding.places), loaded);
    diagnosis.findings.sort_by_key(|finding| (std::cmp::Reverse(finding.severity), finding.kind));
    diagnosis
}

/// One element of a file that has a finding, by numbers of the mesh that was read.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Occurrence {
    /// The part; a finding about a whole mesh has no other number.
    pub part: usize,
    /// The face.
    pub face: Option<u32>,
    /// The corner, counted over all faces of the part. An edge is that from this corner to the next one of its face.
    pub corner: Option<u32>,
    /// The vertex.
    pub vertex: Option<u32>,
    /// The angle in degrees, if one is measured.
    pub degrees: Option<f64>,
}

/// All occurrences of each of some kinds, worst first, where [`diagnose`] keeps only the worst ones.
///
/// It takes as long as [`diagnose`], and needs 64 bytes for each occurrence of any finding.
pub fn occurrences(loaded: &Loaded, thresholds: &Thresholds, kinds: &[Kind]) -> Vec<Vec<Occurrence>> {
    let (_, mut totals) = search_parts(loaded, &Thresholds { places: usize::MAX, ..*thresholds }, &|_| {});
    let is = |number: u32| (number != NONE).then_some(number);
    let occurrence = |spot: &Spot| Occurrence {
        part: spot.part as usize,
        face: is(spot.face),
        corner: is(spot.corner),
        vertex: is(spot.vertex),
        degrees: spot.degrees,
    };
    kinds.iter().map(|&kind| totals.found.take(kind).worst.iter().map(occurrence).collect()).collect()
}

/// The findings of all parts, before they are put into words.
fn search_parts(
    loaded: &Loaded,
    thresholds: &Thresholds,
    done: &dyn Fn(usize),
) -> (Vec<PartDiagnosis>, Totals) {
    let file = FileContext::new(loaded, thresholds);
    let tree = OnceCell::new();
    let tree = || tree.get_or_init(|| loaded.node_tree()).as_ref();
    let nodes = nodes_of_parts(loaded);
    let mut parts = Vec::new();
    let mut totals =
        Totals { found: Tallies::new(thresholds.places), elements: Default::default(), area: 0.0 };
    for (number, part) in loaded.parts.iter().enumerate() {
        let mut own = PartDiagnosis { name: part.name.clone(), ..PartDiagnosis::default() };
        if part.mesh.face_count() > 0 {
            diagnose_part(&file, number, &nodes[number], &tree, &mut own, &mut totals);
        }
        done(part.mesh.face_count());
        parts.push(own);
    }
    if parts.iter().all(|part| part.faces == 0) {
        let first_part = parts.first().map(|_| Spot::mesh());
        totals.elements[Element::Mesh as usize] = 1;
        totals.found.add_mesh(Kind::NoFaces, 0.0, first_part.into_iter().collect());
    }
    (parts, totals)
}

fn diagnose_part<'a>(
    file: &'a FileContext<'a>,
    number: usize,
    nodes: &[&FileNode],
    tree: &dyn Fn() -> Option<&'a NodeTree<'a>>,
    own: &mut PartDiagnosis,
    totals: &mut Totals,
) {
    let mut found = Tallies::new(file.thresholds.places);
    let mut facts = Facts::new(file, number);
    // Normals in another space are judged as they are in the space of the mesh.
    let mistake = find_mistake(&facts, nodes, tree);
    if let Some(mistake) = &mistake {
        let taken_back = Facts::of_transformed(&facts, &mistake.taken_back);
        if mistake.is_proved(facts.estimate, taken_back.estimate) {
            mistake.report(&facts, &mut found);
            facts = taken_back;
        }
    }
    own.precision = search(&facts, nodes, &mut found);
    own.estimate = facts.estimate;
    own.faces = facts.mesh.face_count();
    own.corners = facts.mesh.faces().corner_count();
    own.vertices = match file.shares_vertices() {
        true => facts.field.summary.referenced_vertices,
        false => own.corners,
    };
    totals.add(&facts, found, nodes.len());
}

/// Searches a part for all findings. Returns the precision of its stored normals.
fn search(facts: &Facts<'_>, nodes: &[&FileNode], found: &mut Found) -> Option<Precision> {
    let mut precision = None;
    if facts.stored.is_none() {
        values::report_none(facts, found);
    } else {
        values::search(facts, found);
        deviations::search(facts, found);
        refine_remedies(facts, found);
        sharpness::search_facets(facts, found);
        sharpness::search_soft(facts, found);
        precision = quantisation::search(facts, found);
        values::search_attributes(facts, found);
    }
    seams::search(facts, found);
    duplicates::search_faces(facts, found);
    duplicates::search_vertices(facts, found);
    winding::search(facts, found);
    winding::search_components(facts, found);
    face_shape::search_without_direction(facts, found);
    let folded = Limit::new(facts.thresholds.fold.0);
    found.merge(facts.scan_faces(|face, found| {
        face_shape::check_width(facts, face, found);
        face_shape::check_polygon(facts, face, found);
        edges::check_folds(facts, face, folded, found);
    }));
    edges::search_non_manifold(facts, found);
    vertices::search(facts, found);
    vertices::search_cancelling(facts, found);
    placement::search_distance(facts, found);
    shading::search(facts, found);
    placement::search_nodes(nodes, found);
    if facts.has_near_edges {
        add_to_remedies(found, &format!("--weld {:e}", facts.thresholds.weld));
    }
    precision
}

/// Single normals are to be replaced by ones of the estimated recipe, or they would be outliers. If no recipe is known, the default
/// one is as good as any.
fn refine_remedies(facts: &Facts<'_>, found: &mut Found) {
    let has_groups = facts.mesh.columns().smoothing.is_some();
    let is_usual = |it: &Estimate| it.is_default() && !has_groups;
    let Some(estimate) = facts.estimate.filter(|it| it.fits_most() && !is_usual(it)) else { return };
    let replaced = [
        Kind::MissingNormals,
        Kind::NotFinite,
        Kind::ZeroNormals,
        Kind::NotUnit,
        Kind::Flipped,
        Kind::AgainstFace,
    ];
    for kind in replaced {
        let own = kind.entry().remedy.unwrap_or_default();
        found.tally(kind).remedy = Some(format!("{own} {}", estimate.options(has_groups)));
    }
}

fn add_to_remedies(found: &mut Found, option: &str) {
    for (kind, tally) in found.iter_mut() {
        let own = tally.remedy.take().or_else(|| kind.entry().remedy.map(str::to_owned));
        tally.remedy = own.map(|own| format!("{own} {option}").trim_start().to_owned());
    }
}

/// The angle at an occurrence in degrees, where the search measures something else.
fn angle(facts: &Facts<'_>, kind: Kind, spot: &Spot) -> Option<f64> {
    match kind {
        Kind::Needles => Some(face_shape::rounding_angle(facts, spot.face as usize)),
        Kind::NonManifold => Some(edges::largest_dihedral_angle(facts, spot.corner)),
        Kind::HighValence => Some(vertices::largest_leaning(facts, spot.vertex)),
        _ => None,
    }
}

struct Totals {
    found: Found,
    /// How many elements of each type the parts have.
    elements: [u64; Element::COUNT],
    area: f64,
}

impl Totals {
    fn add(&mut self, facts: &Facts<'_>, mut found: Found, nodes: usize) {
        let edges = &facts.field.summary.edges;
        let plain = edges.smooth + edges.boundary + edges.crease + edges.marked;
        let edges = plain + edges.non_manifold + edges.inconsistent + edges.ambiguous;
        let counts = [
            (Element::Corner, facts.mesh.faces().corner_count() as u64),
            (Element::Face, facts.mesh.face_count() as u64),
            (Element::Edge, edges as u64),
            (Element::Vertex, facts.field.summary.referenced_vertices as u64),
            (Element::Node, nodes as u64),
            (Element::Mesh, 1),
        ];
        counts.into_iter().for_each(|(element, count)| self.elements[element as usize] += count);
        let unscaled = |area: f64| area / (facts.scale * facts.scale);
        self.area += unscaled(facts.total_area);
        for (kind, tally) in found.iter_mut() {
            let mut tally = std::mem::take(tally);
            tally.area = unscaled(tally.area);
            for spot in &mut tally.worst {
                spot.part = facts.number as u32;
                spot.degrees = spot.degrees.or_else(|| angle(facts, kind, spot));
            }
            self.found.add_part(kind, tally, kind.entry().severity);
        }
    }

    fn finding(&mut self, entry: &Entry, loaded: &Loaded) -> Option<Finding> {
        let tally = self.found.take(entry.kind);
        let places = tally.worst.iter().map(|spot| site(loaded, spot)).collect();
        let of = self.elements[entry.element as usize];
        (tally.count > 0).then(|| Finding::new(entry, tally, of, self.area, places))
    }
}
