//! The pages.

use super::pictures::{Coloured, KEY};
use super::plots::{
    convergence_plot, encoding_plot, frontier_plot, histogram_plot, own_histogram_plot, own_plot,
    shading_plot,
};
use super::tables::{
    approximation_table, box_table, class_table, cost_table, encoding_table, order_table, own_table,
    precision_table, shading_table, shading_times, surface_table,
};
use crate::mesh::Mesh;
use crate::normals::{NormalRecipe, Weight};
use crate::num::three_digits;
use crate::report::{Page, Panel, ReportError, panels};
use crate::trade::{AngleErrors, OwnMesh, Subject, Tiling, Trade, VertexCase, advice};

/// The measurement as a page of HTML that opens from disk with nothing else and ends in plain advice.
///
/// # Errors
/// Pictures that cannot be drawn or made into files.
pub fn trade_page(trade: &Trade) -> Result<String, ReportError> {
    let mut page = Page::new(
        "Accuracy against speed",
        "Which vertex normals should I use, how should I store them, and how should I shade with them? Errors against \
         surfaces whose normals are known, beside what they cost.",
    );
    weights(trade, &mut page);
    surfaces(trade, &mut page)?;
    convergence(trade, &mut page);
    page.heading("Flat faces");
    page.paragraph(
        "On a box, a weight that depends on how flat faces happen to be triangulated gives several values. One value that \
         is not 0 is another thing: Max's weights do not care about the cut, but are drawn to the small faces of a long box.",
    );
    page.table(&box_table(trade));
    page.heading("Cost");
    page.paragraph(
        "One thread. The plain loop sums cross products in single precision and looks after nothing; slices are this \
         crate's kernel on the same arrays; a mesh has its topology, creases and faults as well. Ratios were taken in the \
         same run and differ little from machine to machine; nanoseconds do.",
    );
    page.table(&cost_table(trade));
    page.heading("Precision");
    page.paragraph(
        "What single-precision arithmetic adds to the error, beside what tessellation and storage cost already. Far from \
         the origin it is the stored positions that are coarse, which no arithmetic mends.",
    );
    page.table(&precision_table(trade));
    page.heading("Stored normals");
    page.drawing("encodings", "The dotted line: what diffuse light bears unseen.", |id| {
        encoding_plot(&trade.encodings).svg(id)
    });
    page.table(&encoding_table(&trade.encodings, true));
    shading(trade, &mut page);
    page.heading("Approximations");
    page.paragraph(
        "Functions that this crate computes in its own way, so that they give the same bits everywhere.",
    );
    page.table(&approximation_table(trade));
    page.heading("Advice");
    page.list(advice(trade).iter().map(String::as_str));
    Ok(page.finish())
}

fn weights(trade: &Trade, page: &mut Page) {
    page.heading("Weights by class of mesh");
    page.paragraph(
        "Each number is the root mean square error on a surface at about 64 × 32 cells, the median over all surfaces; the \
         star marks the best sum of faces. quadric is no sum of faces: it fits a surface through each vertex's neighbours.",
    );
    page.table(&class_table(trade));
    for tiling in Tiling::ALL {
        if !trade.of_class(tiling).is_empty() {
            let name = format!("frontier {}", tiling.name());
            let caption =
                "Towards the lower left is better. What lies above the dashed line is beaten in both.";
            page.drawing(&name, caption, |id| frontier_plot(trade, tiling).svg(id));
        }
    }
}

/// Weights that pictures and histograms are shown of.
const SHOWN: [Weight; 3] = [Weight::Angle, Weight::Max, Weight::Quadric];

fn surfaces(trade: &Trade, page: &mut Page) -> Result<(), ReportError> {
    page.heading("Surfaces");
    page.paragraph(
        "Vertices on open sides lack half of their faces, and a cone has no normal at its tip: these are left out, and \
         counted. Pictures are of irregular triangles.",
    );
    for subject in Subject::all(trade.effort) {
        let cases = || trade.vertex.iter().filter(|case| case.surface == subject.name);
        let Some(case) = cases().find(|case| case.tiling == Tiling::Jittered) else { continue };
        let mut sheet = Vec::new();
        for weight in SHOWN {
            let Some(coloured) = Coloured::surface(&subject, Tiling::Jittered, weight) else { continue };
            let (Some(picture), Some(errors)) = (coloured.draw(230)?, case.quoted_errors(weight)) else {
                continue;
            };
            sheet.push(Panel { caption: error_label(weight, &errors), picture });
        }
        error_sheet(page, sheet, &format!("{}, irregular triangles", subject.name))?;
    }
    page.table(&surface_table(trade));
    Ok(())
}

fn convergence(trade: &Trade, page: &mut Page) {
    page.heading("Convergence");
    page.paragraph(
        "The order is the slope of the error over the edge length, both as logarithms. Sums of faces are of first order on \
         irregular meshes and of second order on regular grids, where errors of opposite faces cancel; quadrics are of \
         second order on both.",
    );
    page.table(&order_table(trade));
    let shown = [
        ("torus", Tiling::Jittered),
        ("torus", Tiling::Regular),
        ("sphere", Tiling::Icosphere),
        ("torus", Tiling::Marching),
        ("wave", Tiling::Scattered),
    ];
    let find = |(surface, tiling)| {
        trade
            .vertex
            .iter()
            .find(|case| case.surface == surface && case.tiling == tiling && !case.meshes.is_empty())
    };
    let cases: Vec<&VertexCase> = shown.into_iter().filter_map(find).collect();
    for case in &cases {
        let name = format!("convergence {} {}", case.surface, case.tiling.name());
        page.drawing(&name, "Dotted: slopes of order 1 and 2.", |id| convergence_plot(case).svg(id));
    }
    page.subheading("How errors are spread");
    for case in &cases {
        let name = format!("errors {} {}", case.surface, case.tiling.name());
        let caption = "At 64 × 32 or its like. Weights that are exact here have no outline.";
        page.drawing(&name, caption, |id| histogram_plot(case).svg(id));
    }
}

fn shading(trade: &Trade, page: &mut Page) {
    page.heading("Shading");
    page.paragraph(
        "Pictures of meshes against pictures of the surfaces themselves, over the pixels that both cover, before any \
         rounding. Vertices have the surface's own normals, so what differs is the shading. A step is 1/255 of the full range \
         of linear light. Where a polygonal outline covers other pixels than the surface is counted apart.",
    );
    let mut surfaces: Vec<&str> = trade.shading.iter().map(|row| row.surface).collect();
    surfaces.dedup();
    for surface in surfaces {
        let name = format!("shading {surface}");
        page.drawing(&name, "Regular meshes, right under perspective.", |id| {
            shading_plot(&trade.shading, surface).svg(id)
        });
    }
    page.table(&shading_table(&trade.shading, "blinn"));
    page.table(&shading_table(&trade.shading, "phong"));
    page.table(&shading_times(&trade.shading));
}

/// What stands below a picture of errors.
fn error_label(weight: Weight, errors: &AngleErrors) -> String {
    format!("{}: rms {}°, largest {}°", weight.name(), three_digits(errors.rms), three_digits(errors.max))
}

/// Pictures of the errors of several weights on one mesh, each with its own label.
fn error_sheet(page: &mut Page, sheet: Vec<Panel>, of: &str) -> Result<(), ReportError> {
    if sheet.is_empty() {
        return Ok(());
    }
    let labels: Vec<&str> = sheet.iter().map(|panel| panel.caption.as_str()).collect();
    let alternative = format!("{of}, coloured by the error of normals. {}", labels.join("; "));
    page.pictures(&[(&panels(&sheet)?, &alternative)], &format!("{of}. {KEY}"))
}

/// The trade on somebody's own mesh, measured with this recipe, as a page.
///
/// # Errors
/// Pictures that cannot be drawn or made into files.
pub fn own_page(
    own: &OwnMesh,
    parts: &[&Mesh],
    recipe: &NormalRecipe,
    name: &str,
) -> Result<String, ReportError> {
    let mut page = Page::new(
        &format!("Accuracy against speed: {name}"),
        "The surface of this mesh is not known; the quadric method, of second order where sums of faces are of first, \
         stands in for the truth.",
    );
    page.heading("Weights");
    page.paragraph(&format!(
        "{} vertices, {} faces, {} normals; {:.0} % of them are the same with every weight. No quadric could be fitted for {}.",
        own.vertices,
        own.faces,
        own.normals,
        100.0 * own.alike,
        own.without_quadric
    ));
    page.table(&own_table(own));
    if own.estimated_from > 0 {
        let caption = "Towards the lower left is better. What lies above the dashed line is beaten in both.";
        page.drawing("cost", caption, |id| own_plot(own).svg(id));
        page.drawing("errors", "Normals that the quadric says something of.", |id| {
            own_histogram_plot(own).svg(id)
        });
        own_pictures(own, parts, recipe, &mut page)?;
    }
    page.heading("Advice");
    page.paragraph(&format!("Use --weight {}.", own.recommended.name()));
    page.list(own.reasons.iter().map(String::as_str));
    Ok(page.finish())
}

/// Where the estimated errors are, on the largest part: of the recommended weight and the usual ones.
fn own_pictures(
    own: &OwnMesh,
    parts: &[&Mesh],
    recipe: &NormalRecipe,
    page: &mut Page,
) -> Result<(), ReportError> {
    let Some(&largest) = parts.iter().max_by_key(|mesh| mesh.face_count()) else { return Ok(()) };
    let shown = own.methods.iter().filter(|method| {
        [own.recommended, Weight::Uniform, Weight::Area, Weight::Angle].contains(&method.weight)
    });
    let mut sheet = Vec::new();
    for method in shown {
        if let Some(picture) = Coloured::own(largest, recipe, method.weight).draw(230)? {
            sheet.push(Panel { caption: error_label(method.weight, &method.estimate), picture });
        }
    }
    let of = if parts.len() > 1 { "The part with the most faces" } else { "The mesh" };
    error_sheet(page, sheet, &format!("{of}: angle to the quadric's normals; grey where there is none"))
}
