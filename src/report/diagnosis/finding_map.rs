//! Maps of findings: each finding in a colour of its own on the lit mesh.
//!
//! A colour fades to grey with the angle, so that interpolated colours are those of interpolated angles.

use super::legend::{Marks, coded};
use super::markers::{HeatScale, dot_lines, end_above, is_small, longest_edge};
use super::model::{Model, draw};
use super::texts::Texts;
use super::view_choice::{Sight, WantedSite, camera_of_sites};
use crate::io::Loaded;
use crate::num::{LinearRgb, Srgb8, three_digits};
use crate::quality::{
    Diagnosis, Element, Finding, Occurrence, Severity, Site, Thresholds, occurrences, survey,
};
use crate::raster::{Camera, LinePath, LineStyle, Lines, Show, default_lights};
use crate::report::error::{ReportError, Result};
use crate::report::legend::{ColourScale, Key, Legend};
use crate::report::picture::Picture;
use crate::shade::Light;
use crate::text::Value;
use glam::{DMat3, DVec3};

/// Colours that people without full colour vision distinguish (Okabe & Ito 2008), the most severe finding first.
const COLOURS: [Srgb8; 6] = [
    Srgb8([0xd5, 0x5e, 0x00]),
    Srgb8([0x00, 0x72, 0xb2]),
    Srgb8([0xcc, 0x79, 0xa7]),
    Srgb8([0x00, 0x9e, 0x73]),
    Srgb8([0xe6, 0x9f, 0x00]),
    Srgb8([0x56, 0xb4, 0xe9]),
];

/// The surface without a finding.
const PLAIN: LinearRgb = LinearRgb::grey(0.6);

/// The light on a surface that faces away from the lamp, as a share of that on one that faces it.
const SHADOW: f64 = 0.4;

/// The share of a colour at an angle of 0: a corner with a finding is never as grey as one without.
const LEAST: f64 = 0.3;

/// The width of lines along edges in a picture of 480 pixels.
const LINE: f64 = 3.0;

/// The most dots of a finding, worst first.
const MOST_DOTS: usize = 20_000;

/// The most positions for which a view is chosen.
const MOST_SITES: usize = 192;

/// A finding in the map: its occurrences, its colour, and the angle at the end of its scale.
struct Layer<'a> {
    finding: &'a Finding,
    occurrences: Vec<Occurrence>,
    colour: LinearRgb,
    /// The angle of the full colour; `None` if the finding has no angle, or the same everywhere.
    full: Option<f64>,
}

impl<'a> Layer<'a> {
    fn new(finding: &'a Finding, occurrences: Vec<Occurrence>, colour: Srgb8) -> Self {
        let angles = || occurrences.iter().filter_map(|it| it.degrees);
        let (least, largest) = (angles().fold(f64::INFINITY, f64::min), angles().fold(0.0, f64::max));
        let has_scale =
            finding.kind.entry().element != Element::Edge && three_digits(least) != three_digits(largest);
        let full = (largest > 0.0 && has_scale).then(|| end_above(largest));
        Self { finding, occurrences, colour: colour.into(), full }
    }

    fn shade(&self, degrees: Option<f64>) -> LinearRgb {
        let share = match (self.full, degrees) {
            (Some(full), Some(degrees)) => LEAST + (1.0 - LEAST) * (degrees / full).min(1.0),
            _ => 1.0,
        };
        PLAIN * (1.0 - share) + self.colour * share
    }

    fn words(&self, texts: Texts) -> String {
        let Finding { kind, count, degrees, .. } = self.finding;
        let element = format!("elements-{}", kind.entry().element.name());
        let elements = texts.with(&element, &[("count", (*count).into())]);
        let words = match degrees.filter(|_| self.full.is_none()) {
            None => elements,
            Some(degrees) => {
                let degrees = Value::digits(&three_digits(degrees));
                texts.with("up-to", &[("elements", elements.into()), ("degrees", degrees)])
            }
        };
        format!("{}: {words}", kind.id())
    }
}

/// A picture of the findings of a file: the mesh lit, with a colour for each finding on the faces, corners, edges and vertices that
/// have it. The colour of a corner deepens with its angle. Dots mark corners and faces too small to be visible.
///
/// It shows errors and warnings, at most six, or notes too if `with_notes`. A legend below names them.
///
/// # Errors
/// If there is nothing to draw, or it cannot be drawn.
pub(super) fn finding_picture(
    loaded: &Loaded,
    (diagnosis, thresholds): (&Diagnosis, &Thresholds),
    with_notes: bool,
    (sight, side): (Sight, u32),
    texts: Texts,
) -> Result<Picture> {
    let map = FindingMap::new(loaded, (diagnosis, thresholds), with_notes);
    let surveys = survey(loaded);
    let model = Model::new(loaded, &surveys, HeatScale::of(surveys.iter()))?;
    let sites = sites(loaded, &map.layers);
    let camera = camera_of_sites(&model, &sites, sight).ok_or(ReportError::Empty)?;
    Ok(map.draw(&model, loaded, (camera, side), texts)?.0)
}

/// Findings that are shown in a map.
pub(super) struct FindingMap<'a> {
    layers: Vec<Layer<'a>>,
    /// How many findings there are beyond the colours.
    omitted: usize,
}

impl<'a> FindingMap<'a> {
    pub(super) fn new(
        loaded: &Loaded,
        (diagnosis, thresholds): (&'a Diagnosis, &Thresholds),
        with_notes: bool,
    ) -> Self {
        let all = diagnosis.findings.iter().filter(|it| with_notes || it.severity > Severity::Note);
        let all: Vec<&Finding> = all.collect();
        let shown = &all[..all.len().min(COLOURS.len())];
        let kinds: Vec<_> = shown.iter().map(|finding| finding.kind).collect();
        let found = if kinds.is_empty() { Vec::new() } else { occurrences(loaded, thresholds, &kinds) };
        let layers = shown.iter().zip(found).zip(COLOURS);
        let layers = layers.map(|((finding, found), colour)| Layer::new(finding, found, colour)).collect();
        Self { layers, omitted: all.len() - shown.len() }
    }

    /// Whether there is no finding to show.
    pub(super) fn is_empty(&self) -> bool {
        self.layers.is_empty()
    }

    /// The picture with its legend, and the marks on it.
    pub(super) fn draw(
        &self,
        model: &Model,
        loaded: &Loaded,
        (camera, side): (Camera, u32),
        texts: Texts,
    ) -> Result<(Picture, Marks)> {
        let colours = corner_colours(model, &self.layers, &camera);
        let mut scene = model.coloured(camera, &colours);
        let scale = (f64::from(side) / 480.0).max(1.0);
        for layer in self.layers.iter().rev() {
            scene.lines.extend(edges(model, layer, LINE * scale));
            scene.lines.extend(dots(model, loaded, layer, &camera, side));
        }
        let mut picture = draw(&scene, side, Show::Shaded)?;
        let worst: Vec<&Site> = self.layers.iter().filter_map(|it| it.finding.places.first()).collect();
        let marks = model.mark_worst(&mut picture, &camera, side, &worst);
        let mut legend = legend(&self.layers, self.omitted, texts);
        if marks.rings || marks.hidden {
            legend.keys.push((Key::Ring, marks.of_rings(texts)));
        }
        Ok((legend.below(&picture), marks))
    }
}

/// Some positions of each finding, evenly chosen, by the weight of its severity. Edges and vertices count from any side.
fn sites(loaded: &Loaded, layers: &[Layer]) -> Vec<WantedSite> {
    let most = MOST_SITES / layers.len().max(1);
    let of_layer = |layer: &Layer| -> Vec<WantedSite> {
        let step = layer.occurrences.len().div_ceil(most).max(1);
        let weight = [1.0, 10.0, 100.0][layer.finding.severity as usize];
        let has_side = !matches!(layer.finding.kind.entry().element, Element::Edge | Element::Vertex);
        let wanted = |found: &Occurrence| WantedSite { weight, has_side, site: site(loaded, found) };
        layer.occurrences.iter().step_by(step).map(wanted).collect()
    };
    layers.iter().flat_map(of_layer).collect()
}

fn site(loaded: &Loaded, found: &Occurrence) -> Site {
    let mesh = &loaded.parts[found.part].mesh;
    let at = |vertex: u32| mesh.positions().at(vertex);
    let vertex = found.vertex.or_else(|| found.corner.map(|it| mesh.faces().corners()[it as usize]));
    let middle = |face: u32| {
        let corners = mesh.faces().face(face as usize);
        corners.iter().map(|&vertex| at(vertex) / corners.len() as f64).sum()
    };
    let position = vertex.map(at).or_else(|| found.face.map(middle));
    Site { part: found.part, face: found.face, vertex, position, ..Site::default() }
}

/// The colour of each corner of each part, lit. Parts with several nodes are lit as the first of these is.
fn corner_colours(model: &Model, layers: &[Layer], camera: &Camera) -> Vec<Vec<LinearRgb>> {
    let mut colours: Vec<Vec<LinearRgb>> =
        model.parts.iter().map(|part| vec![PLAIN; part.deviations.len()]).collect();
    // The most severe finding covers the others.
    for layer in layers.iter().rev() {
        let element = layer.finding.kind.entry().element;
        // Of several occurrences at a corner the worst comes first.
        for found in layer.occurrences.iter().rev() {
            let (faces, colours) = (model.parts[found.part].mesh.faces(), &mut colours[found.part]);
            match (element, found.corner, found.face) {
                (Element::Edge | Element::Vertex | Element::Node, ..) => {}
                (_, Some(corner), _) => colours[corner as usize] = layer.shade(found.degrees),
                (_, None, Some(face)) => colours[faces.range(face as usize)].fill(layer.shade(found.degrees)),
                (_, None, None) => colours.fill(layer.shade(found.degrees)),
            }
        }
    }
    let towards = match default_lights(camera)[1] {
        Light::Directional { towards, .. } => towards.normalize_or_zero(),
        _ => DVec3::Z,
    };
    let forward = (camera.target - camera.eye).normalize_or_zero();
    for (number, colours) in colours.iter_mut().enumerate() {
        let place = model.objects.iter().find(|(part, _)| *part == number).map(|(_, place)| *place);
        let to_part = place.map_or(DMat3::IDENTITY, |place| DMat3::from_mat4(place).transpose());
        // A covector: the product with the normal has the sign that it has in the world.
        let (towards, forward) = ((to_part * towards).normalize_or_zero(), to_part * forward);
        for (colour, normal) in colours.iter_mut().zip(model.parts[number].form_normals()) {
            let visible = if normal.dot(forward) > 0.0 { -*normal } else { *normal };
            *colour = *colour * (SHADOW + (1.0 - SHADOW) * visible.dot(towards).max(0.0));
        }
    }
    colours
}

/// Lines along the edges of a finding about edges.
fn edges(model: &Model, layer: &Layer, width: f64) -> Vec<Lines> {
    if layer.finding.kind.entry().element != Element::Edge {
        return Vec::new();
    }
    let edge = |found: &Occurrence| {
        let range = model.parts[found.part].mesh.faces().range(found.face? as usize);
        let corner = found.corner? as usize;
        let next = if corner + 1 == range.end { range.start } else { corner + 1 };
        Some([corner as u32, next as u32])
    };
    let style = LineStyle { colour: layer.colour, width, hide: true };
    let of_object = |(object, &(part, _)): (usize, &(usize, _))| {
        let edges: Vec<_> = layer.occurrences.iter().filter(|it| it.part == part).filter_map(edge).collect();
        (!edges.is_empty()).then_some(Lines { path: LinePath::Edges { object, edges }, style })
    };
    model.objects.iter().enumerate().filter_map(of_object).collect()
}

/// Dots on vertices, and on corners and faces too small to be visible.
fn dots(model: &Model, loaded: &Loaded, layer: &Layer, camera: &Camera, side: u32) -> Option<Lines> {
    let element = layer.finding.kind.entry().element;
    if matches!(element, Element::Edge | Element::Node | Element::Mesh) {
        return None;
    }
    let mut points = Vec::new();
    for found in layer.occurrences.iter().take(MOST_DOTS) {
        let Some(position) = site(loaded, found).position else { continue };
        for &(_, place) in model.objects.iter().filter(|(part, _)| *part == found.part) {
            let at = place.transform_point3(position);
            let is_seen = || {
                let mesh = &loaded.parts[found.part].mesh;
                let corners = mesh.faces().face(found.face? as usize);
                let around = |k: usize| mesh.positions().at(corners[k % corners.len()]);
                let longest = (0..corners.len())
                    .map(|k| longest_edge(place, [k, k + 1, k + 2].map(around)))
                    .fold(0.0, f64::max);
                Some(!is_small(longest, at, camera, side))
            };
            if element == Element::Vertex || !is_seen().unwrap_or(true) {
                points.push(at);
            }
        }
    }
    dot_lines(points, layer.colour, camera, side)
}

fn legend(layers: &[Layer], omitted: usize, texts: Texts) -> Legend {
    let mut legend = Legend::default();
    for layer in layers {
        let key = match layer.finding.kind.entry().element {
            Element::Edge => Key::Line(coded(layer.colour)),
            Element::Vertex => Key::Dot(coded(layer.colour)),
            _ => Key::Area(coded(layer.colour)),
        };
        match layer.full {
            Some(full) => {
                let shares = [0.0, full].map(|degrees| coded(layer.shade(Some(degrees))));
                let labels = vec![(0.5, layer.words(texts)), (1.0, format!("{full}°")), (0.0, "0°".into())];
                legend.scales.push(ColourScale { colours: shares.to_vec(), labels });
            }
            None => legend.keys.push((key, layer.words(texts))),
        }
    }
    let plain = if layers.is_empty() { "legend-clean" } else { "legend-plain" };
    legend.keys.push((Key::Area(coded(PLAIN)), texts.get(plain)));
    if omitted > 0 {
        legend.title = texts.with("not-shown", &[("count", omitted.into())]);
    }
    legend
}
