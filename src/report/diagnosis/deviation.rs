//! Heat maps: deviations as colours.
//!
//! The mean of two colours is not on the scale. So deviations are interpolated over faces instead of colours; each pixel has
//! the colour of the mean deviation of its samples, or that of corners without a deviation if they are the majority. Colours
//! are mixed only at the borders of the mesh, of lines and of dots.

use super::finding_map::finding_picture;
use super::legend::{Marks, with_legend};
use super::markers::{Corner, HeatScale, crease_lines, dots, longest_edge};
use super::model::{Model, PartModel, render_at};
use super::texts::Texts;
use super::view_choice::{Sight, camera, hidden};
use crate::io::Loaded;
use crate::mesh::{Mesh, place_key};
use crate::normals::Weight;
use crate::num::{LinearRgb, Srgb8};
use crate::quality::{Diagnosis, Severity, Site, Thresholds, survey};
use crate::raster::{Camera, Lines, Paint, Pixels, RenderSettings, Scene};
use crate::report::error::{ReportError, Result};
use crate::report::legend::ring;
use crate::report::picture::Picture;
use crate::text::Language;
use std::borrow::Cow;
use std::collections::{BTreeSet, HashMap};

/// The worst position of each error and warning.
pub(super) fn worst_places(diagnosis: &Diagnosis) -> Vec<&Site> {
    let grave = diagnosis.findings.iter().filter(|finding| finding.severity > Severity::Note);
    grave.filter_map(|finding| finding.places.first()).collect()
}

/// What a heat map shows.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum HeatMap {
    /// All errors and warnings, each in a colour of its own.
    #[default]
    Findings,
    /// The findings of a diagnosis, notes too.
    AllFindings,
    /// The angle between stored normals and those of the estimated recipe.
    Deviation,
    /// The angle between stored normals and those of a weight, with the estimated crease angle.
    From(Weight),
}

/// A picture of a file and what was found in it, `side` pixels wide, and higher by a legend below it.
///
/// Findings are on the lit mesh: a colour for each, on the faces, corners, edges and vertices that have it. It deepens with the
/// angle. Deviations have the colours of a scale. They are interpolated over faces, and each pixel has the colour of the mean of
/// its samples. Corners on faces too small to be visible are marked with dots, the worst last; corners without a valid stored normal
/// have a separate colour. A ring is around the visible worst position of each error and warning. The
/// legend is in the language.
///
/// # Errors
/// If there is nothing to draw, or it cannot be drawn.
pub fn heat_map(
    loaded: &Loaded,
    (diagnosis, thresholds): (&Diagnosis, &Thresholds),
    of: HeatMap,
    sight: Sight,
    side: u32,
    language: Language,
) -> Result<Picture> {
    let texts = Texts(language);
    let weight = match of {
        HeatMap::Findings | HeatMap::AllFindings => {
            let with_notes = of == HeatMap::AllFindings;
            return finding_picture(loaded, (diagnosis, thresholds), with_notes, (sight, side), texts);
        }
        HeatMap::Deviation => None,
        HeatMap::From(weight) => Some(weight),
    };
    let mut surveys = survey(loaded);
    if let Some(weight) = weight {
        for ((part, own), survey) in loaded.parts.iter().zip(&diagnosis.parts).zip(&mut surveys) {
            survey.compare_with(&part.mesh, weight, own.estimate);
        }
    }
    let model = Model::new(loaded, &surveys, HeatScale::of(surveys.iter()))?;
    let camera = camera(&model, diagnosis, None, sight).ok_or(ReportError::Empty)?;
    let title = match weight {
        None => texts.get("angle-of-recipe"),
        Some(weight) => texts.with("angle-of-weight", &[("weight", weight.name().into())]),
    };
    Ok(model.deviation(&title, camera, side, &worst_places(diagnosis), texts)?.0)
}

impl Model {
    /// A heat map with rings around the visible ones of some sites and a legend below, and the marks of the legend.
    pub(super) fn deviation(
        &self,
        title: &str,
        camera: Camera,
        side: u32,
        sites: &[&Site],
        texts: Texts,
    ) -> Result<(Picture, Marks)> {
        let scene = self.encoded(camera);
        // Colours alone do not show the form.
        let mut lines = crease_lines(&scene, side);
        let mut marks = Marks { lines: !lines.is_empty(), ..Marks::default() };
        let dots =
            if self.is_any_far() { dots(self.corners(), self.scale, &camera, side) } else { Vec::new() };
        marks.dots = !dots.is_empty();
        lines.extend(dots);
        let mut picture = coloured(scene, lines, self.scale, side)?;
        let Marks { rings, hidden, .. } = self.mark_worst(&mut picture, &camera, side, sites);
        marks = Marks { rings, hidden, ..marks };
        Ok((with_legend(&picture, title, (self.scale, marks), texts), marks))
    }

    /// Draws a ring around each site that is visible.
    pub(super) fn mark_worst(
        &self,
        picture: &mut Picture,
        camera: &Camera,
        side: u32,
        sites: &[&Site],
    ) -> Marks {
        let mut marks = Marks::default();
        for (site, is_hidden) in sites.iter().zip(hidden(self, sites, camera.eye)) {
            if is_hidden {
                marks.hidden = true;
            } else if let Some((_, position, _)) = self.locate(site)
                && let Ok(Some(at)) = camera.on_picture([side; 2], position)
            {
                ring(picture, at, f64::from(side) / 40.0);
                marks.rings = true;
            }
        }
        marks
    }

    /// Whether any corner may have to be marked.
    fn is_any_far(&self) -> bool {
        let parts: BTreeSet<usize> = self.objects.iter().map(|(part, _)| *part).collect();
        parts.into_iter().any(|part| self.parts[part].deviations.iter().any(|&it| self.scale.is_far(it)))
    }

    /// All corners, in the world.
    fn corners(&self) -> impl Iterator<Item = Corner> {
        self.objects.iter().flat_map(|&(part, place)| {
            let PartModel { mesh, deviations, .. } = &self.parts[part];
            let point = |vertex: u32| mesh.positions().at(vertex);
            let least_at = least_at_places(mesh, deviations);
            let of_face = move |face: &[u32]| -> Vec<Corner> {
                let count = face.len();
                let around =
                    face.iter().filter_map(|&vertex| least_at.get(&place_key(point(vertex))).copied());
                let around = around.reduce(f64::min);
                let corner = |at: usize| Corner {
                    position: place.transform_point3(point(face[at])),
                    deviation: deviations[face[at] as usize],
                    edge: longest_edge(place, [at + count - 1, at, at + 1].map(|at| point(face[at % count]))),
                    around,
                };
                (0..count).map(corner).collect()
            };
            mesh.faces().iter().flat_map(of_face)
        })
    }
}

fn least_at_places(mesh: &Mesh, deviations: &[Option<f64>]) -> HashMap<[u64; 3], f64> {
    let mut least = HashMap::new();
    for (position, degrees) in mesh.positions().iter().zip(deviations) {
        if let &Some(degrees) = degrees {
            let known = least.entry(place_key(position)).or_insert(degrees);
            *known = degrees.min(*known);
        }
    }
    least
}

/// A scene of [encoded](super::markers::encode) deviations in colours of a scale, with lines.
fn coloured(scene: Scene<'_>, lines: Vec<Lines>, scale: HeatScale, side: u32) -> Result<Picture> {
    let vertices = scene.objects.iter().map(|object| count(&object.paint)).max();
    // Shared: a file may have many nodes with one mesh.
    let black = vec![LinearRgb::BLACK; vertices.unwrap_or(0)];
    let mut scene: Scene<'_> = scene;
    let background = scene.background;
    let linear = |scene: &Scene<'_>| -> Result<Vec<[f32; 3]>> {
        let image =
            render_at(scene, side, RenderSettings { keep_linear: true, ..RenderSettings::default() })?;
        Ok(image.linear.unwrap_or_default())
    };
    // Every sample counts in one of two pictures: in this one those of surfaces,
    scene.background = LinearRgb::BLACK;
    scene.lines = lines;
    let colours: Vec<LinearRgb> = scene.lines.iter().map(|lines| lines.style.colour).collect();
    scene.lines.iter_mut().for_each(|lines| lines.style.colour = LinearRgb::BLACK);
    let measures = linear(&scene)?;
    // in this one those of lines, and of what is behind all.
    scene.background = background;
    scene.lines.iter_mut().zip(colours).for_each(|(lines, colour)| lines.style.colour = colour);
    for object in &mut scene.objects {
        object.paint = Paint::Given(Cow::Borrowed(&black[..count(&object.paint)]));
    }
    let rest = linear(&scene)?;
    let pixel = |(measures, rest): (&[f32; 3], &[f32; 3])| {
        let [sum, present, absent] = measures.map(f64::from);
        let mean = (present > absent).then(|| sum / present);
        let surface = scale.colour(mean) * (present + absent);
        Srgb8::from(LinearRgb::from(rest.map(f64::from)) + surface).0
    };
    let pixels = measures.iter().zip(&rest).map(pixel).collect();
    Ok(Picture { size: [side; 2], pixels: Pixels::Eight(pixels) })
}

fn count(paint: &Paint<'_>) -> usize {
    if let Paint::Given(colours) = paint { colours.len() } else { 0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Column, Faces, MeshBuilder};
    use crate::normals::NormalField;
    use crate::num::viridis;
    use crate::quality::Survey;
    use crate::raster::{LinePath, LineStyle, Object, Projection, Shape};
    use crate::shade::Material;
    use glam::DVec3;

    const SIDE: u32 = 60;

    /// Triangles with separate corners, in the plane of the picture, and what they look like at each pixel: its colour, how
    /// many of its four samples are covered, and its middle.
    fn drawn(
        corners: &[([f64; 2], Option<f64>)],
        full: f64,
        lines: Vec<Lines>,
    ) -> Vec<([u8; 3], u8, [f64; 2])> {
        let positions: Vec<DVec3> = corners.iter().map(|&([x, y], _)| DVec3::new(x, y, 0.0)).collect();
        let count = positions.len() as u32;
        let faces = Faces::triangles((0..count).collect());
        let mesh =
            MeshBuilder { positions: positions.into(), faces, ..MeshBuilder::default() }.build().unwrap();
        let vertices: Vec<u32> = (0..count).collect();
        let normals = NormalField {
            normals: Column::per_corner(vec![DVec3::Z; corners.len()], vertices.clone()),
            entry_vertex: vertices,
            face_normals: vec![DVec3::Z; corners.len() / 3],
            morph_normals: Vec::new(),
            faults: Default::default(),
            summary: Default::default(),
        };
        let camera = Camera {
            eye: DVec3::new(0.5, 0.5, 5.0),
            target: DVec3::new(0.5, 0.5, 0.0),
            up: DVec3::Y,
            projection: Projection::Orthographic(1.2),
            near: 0.0,
        };
        let measures: Vec<LinearRgb> =
            corners.iter().map(|&(_, deviation)| super::super::markers::encode(deviation)).collect();
        let object = Object {
            paint: Paint::Given(Cow::Owned(measures)),
            ..Object::new(Shape::Mesh { mesh: &mesh, normals: &normals }, Material::default())
        };
        let scene = Scene {
            objects: vec![object],
            lines: Vec::new(),
            lights: Vec::new(),
            camera,
            background: LinearRgb::WHITE,
        };
        let deviations = vec![Some(full)];
        let scale = HeatScale::of([Survey { deviations, ..Survey::default() }].iter());
        let coverage = render_at(&scene, SIDE, RenderSettings::default()).unwrap().coverage;
        let picture = coloured(scene, lines, scale, SIDE).unwrap();
        let Pixels::Eight(pixels) = picture.pixels else { panic!("8 bits") };
        let middle = |pixel: usize| {
            let [x, y] = [pixel % SIDE as usize, pixel / SIDE as usize]
                .map(|at| (at as f64 + 0.5) * 1.2 / f64::from(SIDE) - 0.1);
            [x, 1.0 - y]
        };
        let pixels = pixels.into_iter().zip(coverage).enumerate();
        pixels.map(|(number, (colour, covered))| (colour, covered, middle(number))).collect()
    }

    fn distance(a: [u8; 3], b: [u8; 3]) -> u8 {
        a.into_iter().zip(b).map(|(a, b)| a.abs_diff(b)).max().unwrap()
    }

    fn on_scale(share: f64) -> [u8; 3] {
        Srgb8::from(viridis(share)).0
    }

    /// Samples lie round the middles of pixels, so the mean over one is what the triangle has in its middle. Corners are
    /// snapped to 256ths of a pixel, which is 2⁻⁸/50 of the scale; one code is rounding.
    #[test]
    fn each_pixel_has_the_colour_of_its_own_deviation() {
        let triangle = [([0.0, 0.0], Some(0.0)), ([1.0, 0.0], Some(0.0)), ([0.0, 1.0], Some(30.0))];
        let mut inside = 0;
        for (colour, covered, [x, y]) in drawn(&triangle, 30.0, Vec::new()) {
            match covered {
                0 => assert_eq!(colour, [255; 3]),
                4 => {
                    inside += 1;
                    assert!(distance(colour, on_scale(y)) <= 1, "{colour:?} at {x}, {y}");
                }
                _ => {}
            }
        }
        assert!(inside > 1100, "{inside}");
        // Beyond the scale the deviation spreads as it is, and only its colour ends.
        let beyond = [triangle[0], triangle[1], ([0.0, 1.0], Some(120.0))];
        for (colour, _, [x, y]) in
            drawn(&beyond, 30.0, Vec::new()).into_iter().filter(|(_, covered, _)| *covered == 4)
        {
            assert!(distance(colour, on_scale(4.0 * y)) <= 1, "{colour:?} at {x}, {y}");
        }
    }

    /// Where faces of different deviations meet, and where a corner has none, no colour is mixed.
    #[test]
    fn all_colours_are_those_of_the_legend() {
        let scale = HeatScale::of([Survey { deviations: vec![Some(30.0)], ..Survey::default() }].iter());
        let absent = Srgb8::from(scale.colour(None)).0;
        let corners = [
            ([0.0, 0.0], Some(0.0)),
            ([1.0, 0.0], Some(0.0)),
            ([0.0, 1.0], Some(0.0)),
            ([1.0, 0.0], Some(30.0)),
            ([1.0, 1.0], None),
            ([0.0, 1.0], Some(30.0)),
        ];
        let pixels = drawn(&corners, 30.0, Vec::new());
        let inside = pixels.into_iter().filter(|(_, covered, _)| *covered == 4);
        let (mut without, mut between) = (0, 0);
        for (colour, _, at) in inside {
            without += u32::from(colour == absent);
            let nearest = (0..=600).map(|i| distance(colour, on_scale(f64::from(i) / 600.0))).min().unwrap();
            assert!(colour == absent || nearest <= 1, "{colour:?} at {at:?}");
            between += u32::from(colour != absent && ![0.0, 1.0].map(on_scale).contains(&colour));
        }
        // A quarter of the one triangle, half of its height; and the edge between both.
        assert!((280..330).contains(&without) && (40..60).contains(&between), "{without} {between}");
    }

    #[test]
    fn lines_keep_their_colour() {
        let triangle = [([0.0, 0.0], Some(30.0)), ([1.0, 0.0], Some(30.0)), ([0.0, 1.0], Some(30.0))];
        let points = vec![DVec3::new(-0.05, 0.3, 0.1), DVec3::new(0.9, 0.3, 0.1)];
        let style = LineStyle { colour: LinearRgb::grey(0.3), width: 4.0, hide: true };
        let line = Lines { path: LinePath::Points { points, segments: vec![[0, 1]] }, style };
        let pixels = drawn(&triangle, 30.0, vec![line]);
        let grey = Srgb8::from(LinearRgb::grey(0.3)).0;
        for (colour, covered, [x, y]) in pixels {
            let off = (y - 0.3).abs();
            if off < 0.02 && (-0.02..0.86).contains(&x) {
                assert_eq!(colour, grey, "{x}, {y}");
            } else if off > 0.08 && covered == 4 {
                assert_eq!(colour, on_scale(1.0), "{x}, {y}");
            }
        }
    }
}
