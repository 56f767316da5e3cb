//! The pages of the measurement, with meshes coloured by the errors of their normals. The texts are in page.en.ftl.

use super::plots::{
    convergence_plot, encoding_plot, frontier_plot, histogram_plot, own_histogram_plot, own_plot,
    shading_plot,
};
use super::tables::{
    approximation_table, box_table, class_table, cost_table, encoding_table, frontier_table, order_table,
    own_table, precision_table, shading_table, shading_times, surface_table,
};
use crate::mesh::Mesh;
use crate::normals::{NormalField, NormalRecipe, Weight};
use crate::num::{Degrees, LinearRgb, Radians, three_digits, unit_scale, viridis};
use crate::raster::{Camera, Object, Paint, RenderSettings, Samples, Scene, Shape, render};
use crate::report::error::{ReportError, Result};
use crate::report::html::{Drawing, Page};
use crate::report::panel::{Panel, panels};
use crate::report::picture::Picture;
use crate::report::plot::Plot;
use crate::shade::Material;
use crate::text::{Catalogue, Language, Value, catalogue};
use crate::trade::{
    AngleErrors, MeshClass, NamedSurface, OwnMesh, Reference, Tiling, Trade, VertexCase, advice, error_map,
    error_maps,
};
use glam::{DMat4, DVec3};
use std::borrow::Cow;

static TEXTS: Catalogue = catalogue!("page", en);

/// Pixels along the sides of pictures.
const SIDE: u32 = 230;

const SHOWN: [Weight; 3] = [Weight::Angle, Weight::Max, Weight::Quadric];

const CONVERGENCE: [(&str, Tiling); 5] = [
    ("torus", Tiling::Jittered),
    ("torus", Tiling::Regular),
    ("sphere", Tiling::Icosphere),
    ("torus", Tiling::Marching),
    ("wave", Tiling::Scattered),
];

fn text(key: &str, values: &[(&'static str, Value)]) -> String {
    TEXTS.with(key, values).get(Language::English).to_owned()
}

/// Begins a section: its heading, and a paragraph if there is a text for it.
fn section(page: &mut Page, name: &str) {
    page.heading(&text(&format!("{name}-title"), &[]));
    let lead = format!("{name}-lead");
    if TEXTS.has(&lead) {
        page.paragraph(&text(&lead, &[]));
    }
}

fn drawing(page: &mut Page, name: &str, caption: &str, plot: &Plot) {
    page.drawing(name, &text(caption, &[]), |id| plot.svg(id));
}

/// The measurement as a page of HTML that opens from disk with nothing else and ends in plain advice, and its plots as files.
///
/// # Errors
/// Pictures that cannot be drawn or made into files.
pub fn trade_page(trade: &Trade) -> Result<(String, Vec<Drawing>)> {
    let mut page = Page::new(&text("title", &[]), &text("lead", &[]));
    weights(trade, &mut page);
    surfaces(trade, &mut page)?;
    convergence(trade, &mut page);
    section(&mut page, "boxes");
    page.table(&box_table(trade));
    section(&mut page, "cost");
    page.table(&cost_table(trade));
    section(&mut page, "precision");
    page.table(&precision_table(trade));
    section(&mut page, "encodings");
    drawing(&mut page, "encodings", "encodings-caption", &encoding_plot(&trade.encodings));
    page.table(&encoding_table(&trade.encodings, true));
    shading(trade, &mut page);
    section(&mut page, "approximations");
    page.table(&approximation_table(trade));
    section(&mut page, "advice");
    page.list(advice(trade).iter().map(String::as_str));
    let drawings = page.take_drawings();
    Ok((page.finish(), drawings))
}

fn weights(trade: &Trade, page: &mut Page) {
    section(page, "weights");
    page.table(&class_table(trade));
    page.table(&frontier_table(trade));
    for class in &trade.classes {
        let name = format!("frontier {}", class.tiling.name());
        page.drawing(&name, &class_caption(class), |id| frontier_plot(class).svg(id));
    }
}

/// Over how many surfaces the medians are, and how much they depend on the seed.
fn class_caption(class: &MeshClass) -> String {
    let spread = match class.tiling.is_random() {
        true => text("frontier-spread", &[("share", format!("{:.0}", 100.0 * class.spread()).into())]),
        false => text("frontier-no-spread", &[]),
    };
    let values = [("surfaces", class.surfaces.to_string().into()), ("spread", spread.into())];
    format!("{} {}", text("frontier-caption", &[]), text("frontier-class", &values))
}

fn surfaces(trade: &Trade, page: &mut Page) -> Result<()> {
    section(page, "surfaces");
    for surface in NamedSurface::all(trade.effort) {
        let is_shown = |case: &&VertexCase| case.surface == surface.name && case.tiling == Tiling::Jittered;
        let Some(case) = trade.vertex.iter().find(is_shown) else { continue };
        let pictures = SHOWN.into_iter().filter_map(|weight| {
            let (mesh, field, angles) = error_map(&surface, Tiling::Jittered, weight)?;
            let errors: Vec<_> = angles.into_iter().map(Some).collect();
            Some((weight, case.quoted_errors(weight)?, error_picture(&mesh, &field, &errors)))
        });
        error_sheet(page, pictures, &format!("{}, irregular triangles", surface.name))?;
    }
    page.table(&surface_table(trade));
    Ok(())
}

fn convergence(trade: &Trade, page: &mut Page) {
    section(page, "convergence");
    page.table(&order_table(trade));
    let cases = || {
        CONVERGENCE.into_iter().filter_map(|(surface, tiling)| {
            let is_it = |case: &&VertexCase| case.surface == surface && case.tiling == tiling;
            trade.vertex.iter().find(is_it).filter(|case| !case.meshes.is_empty())
        })
    };
    for case in cases() {
        let name = format!("convergence {} {}", case.surface, case.tiling.name());
        drawing(page, &name, "convergence-caption", &convergence_plot(case));
    }
    page.subheading(&text("spread-title", &[]));
    for case in cases() {
        let name = format!("errors {} {}", case.surface, case.tiling.name());
        drawing(page, &name, "spread-caption", &histogram_plot(case));
    }
}

fn shading(trade: &Trade, page: &mut Page) {
    section(page, "shading");
    for rows in trade.shading.chunk_by(|a, b| a.surface == b.surface) {
        let surface = rows[0].surface;
        drawing(page, &format!("shading {surface}"), "shading-caption", &shading_plot(rows, surface));
    }
    page.table(&shading_table(&trade.shading, "blinn"));
    page.table(&shading_table(&trade.shading, "phong"));
    page.table(&shading_times(&trade.shading));
}

/// Pictures of the errors of several weights on one mesh, each with its own label.
fn error_sheet(
    page: &mut Page,
    pictures: impl Iterator<Item = (Weight, AngleErrors, Result<Option<Picture>>)>,
    mesh: &str,
) -> Result<()> {
    let mut sheet = Vec::new();
    for (weight, errors, picture) in pictures {
        let [rms, max] = [errors.rms, errors.max].map(three_digits);
        let caption = format!("{}: rms {rms}°, largest {max}°", weight.name());
        sheet.extend(picture?.map(|picture| Panel { caption, picture }));
    }
    if sheet.is_empty() {
        return Ok(());
    }
    let labels: Vec<&str> = sheet.iter().map(|panel| panel.caption.as_str()).collect();
    let mesh = ("mesh", mesh.into());
    let alternative = text("errors-alternative", &[mesh.clone(), ("labels", labels.join("; ").into())]);
    page.pictures(&[(&panels(&sheet)?, &alternative)], &text("errors-caption", &[mesh]))
}

/// The measurement of a user mesh with this recipe, as a page, and its plots as files.
///
/// # Errors
/// Pictures that cannot be drawn or made into files.
pub fn own_page(
    own: &OwnMesh,
    parts: &[&Mesh],
    recipe: &NormalRecipe,
    name: &str,
) -> Result<(String, Vec<Drawing>)> {
    let lead = match own.reference {
        Reference::Stored => "own-lead-stored",
        Reference::Jet => "own-lead-jet",
        Reference::Quadric => "own-lead-quadric",
    };
    let mut page = Page::new(&text("own-title", &[("name", name.into())]), &text(lead, &[]));
    section(&mut page, "own-weights");
    let counts = [
        ("vertices", own.vertices.to_string().into()),
        ("faces", own.faces.to_string().into()),
        ("normals", own.normals.to_string().into()),
        ("alike", format!("{:.0}", 100.0 * own.alike).into()),
        ("estimated", own.estimated_from.to_string().into()),
    ];
    page.paragraph(&text("own-weights-counts", &counts));
    page.table(&own_table(own));
    if own.estimated_from > 0 {
        drawing(&mut page, "cost", "frontier-caption", &own_plot(own));
        drawing(&mut page, "errors", "own-errors-caption", &own_histogram_plot(own));
        own_pictures(own, parts, recipe, &mut page)?;
    }
    section(&mut page, "advice");
    page.paragraph(&match own.recommended {
        Some(weight) => text("own-advice", &[("weight", weight.name().into())]),
        None => text("own-no-advice", &[]),
    });
    page.list(own.reasons.iter().map(String::as_str));
    let drawings = page.take_drawings();
    Ok((page.finish(), drawings))
}

/// The errors on the largest part: of the recommended weight and the usual ones.
fn own_pictures(own: &OwnMesh, parts: &[&Mesh], recipe: &NormalRecipe, page: &mut Page) -> Result<()> {
    let Some(&largest) = parts.iter().max_by_key(|mesh| mesh.face_count()) else { return Ok(()) };
    let is_shown = |weight: &Weight| {
        Some(*weight) == own.recommended || matches!(weight, Weight::Uniform | Weight::Area | Weight::Angle)
    };
    let shown: Vec<Weight> = Weight::ALL.into_iter().filter(is_shown).collect();
    let maps = error_maps(largest, recipe, own.reference, &shown);
    let pictures = shown.iter().zip(maps).map(|(&weight, (field, errors))| {
        let estimate = own.methods[weight as usize].estimate;
        (weight, estimate, error_picture(largest, &field, &errors))
    });
    let of = if parts.len() > 1 { "The submesh with the most faces" } else { "The mesh" };
    error_sheet(page, pictures, &format!("{of}: angle to the reference; grey where there is none"))
}

/// The errors at the ends of the colours, in degrees, as powers of ten.
const ENDS: [f64; 2] = [-2.0, 1.0];
/// The colour of vertices without a known error.
const UNKNOWN: LinearRgb = LinearRgb::grey(0.5);

/// A mesh with each vertex in the colour of the error of its normal; `None` for an empty mesh.
fn error_picture(mesh: &Mesh, normals: &NormalField, errors: &[Option<Radians>]) -> Result<Option<Picture>> {
    let Some((low, high)) = mesh.bounds() else { return Ok(None) };
    // Scaled to about unit size around the origin.
    let (centre, half) = (low * 0.5 + high * 0.5, high * 0.5 - low * 0.5);
    let scale = unit_scale(half.max_element());
    let colours = errors.iter().map(|error| error.map_or(UNKNOWN, colour)).collect();
    let scene = Scene {
        objects: vec![Object {
            paint: Paint::Given(Cow::Owned(colours)),
            transform: DMat4::from_scale(DVec3::splat(scale)) * DMat4::from_translation(-centre),
            ..Object::new(Shape::Mesh { mesh, normals }, Material::default())
        }],
        lines: Vec::new(),
        lights: Vec::new(),
        camera: Camera::framing((-half * scale, half * scale), 1.0),
        background: LinearRgb::WHITE,
    };
    let settings = RenderSettings { size: [SIDE; 2], samples: Samples::Four, ..RenderSettings::default() };
    let drawn = render(&scene, &settings).map_err(|error| ReportError::Encoder(error.to_string()))?;
    Ok(Some(drawn.into()))
}

fn colour(angle: Radians) -> LinearRgb {
    let [low, high] = ENDS;
    let share = (libm::log10(Degrees::from(angle).0) - low) / (high - low);
    // The logarithm of 0 is −∞: the first colour.
    viridis(share)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_grow_lighter_with_the_error() {
        let luminance = |degrees: f64| colour(Degrees(degrees).into()).luminance();
        let errors = [0.0, 0.01, 0.03, 0.1, 0.5, 2.0, 10.0, 90.0].map(luminance);
        assert!(errors.is_sorted() && errors[0] == errors[1] && errors[6] == errors[7], "{errors:?}");
        assert_eq!(colour(Radians(0.0)), viridis(0.0));
    }
}
