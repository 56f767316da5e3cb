//! Tables of the measurement, for pages and the terminal.

use super::plots::is_compared;
use crate::normals::Weight;
use crate::num::{significant_digits, three_digits};
use crate::report::table::{Column, Table};
use crate::trade::{
    ApproximationRow, BoxRow, ClassPoint, EncodingRow, OwnMesh, OwnMethod, PrecisionRow, Reference,
    ShadingRow, Tiling, Trade, Way, frontier,
};

/// A cell without a number.
const NONE: &str = "–";

/// Columns: one thing, then every weight.
fn by_weight(caption: &str, first: &[&'static str]) -> Table {
    let columns: Vec<&str> = first.iter().copied().chain(Weight::ALL.map(Weight::name)).collect();
    Table::new(caption, &columns)
}

/// An error in degrees. Errors below the rounding of positions count as none.
fn degrees(x: f64, digits: usize) -> String {
    if x < 1e-9 { "exact".into() } else { significant_digits(x, digits) }
}

/// The rms error of each weight on each class of meshes, the median over its surfaces; a star marks the best sum of faces.
pub fn class_table(trade: &Trade) -> Table {
    let columns = ["mesh", "surfaces"].into_iter().chain(Weight::ALL.map(Weight::name)).chain(["spread"]);
    let caption = "Vertex normals: rms error in degrees at 64 × 32, median over surfaces, boundary vertices omitted; \
                   spread: largest change of a median over five seeds";
    let mut table = Table::new(caption, &columns.collect::<Vec<_>>());
    for class in &trade.classes {
        let sums = class.points.iter().filter(|point| !point.weight.is_fit());
        let best = sums.map(|point| point.rms).fold(f64::INFINITY, f64::min);
        let cell = |point: &ClassPoint| {
            let star = if !point.weight.is_fit() && point.rms == best { "*" } else { "" };
            format!("{}{star}", degrees(point.rms, 3))
        };
        let spread =
            if class.tiling.is_random() { format!("{:.0} %", 100.0 * class.spread()) } else { NONE.into() };
        let names = [class.tiling.name().to_owned(), class.surfaces.to_string()];
        table.push(names.into_iter().chain(class.points.iter().map(cell)).chain([spread]));
    }
    table
}

/// The Pareto frontier of each class of meshes, and the weights that others dominate.
pub fn frontier_table(trade: &Trade) -> Table {
    let caption = "Error against cost: no weight is both cheaper and more accurate than one on the frontier";
    let mut table = Table::new(caption, &["mesh", "frontier, from cheap to accurate", "dominated"]);
    for class in &trade.classes {
        let best: Vec<&str> = frontier(&class.points).iter().map(|point| point.weight.name()).collect();
        let dominated = class
            .points
            .iter()
            .filter_map(|point| Some(format!("{} by {}", point.weight.name(), point.dominated_by?.name())));
        let dominated: Vec<String> = dominated.collect();
        table.push([class.tiling.name().to_owned(), best.join(", "), dominated.join(", ")]);
    }
    table
}

/// The order of convergence of each weight on each class of meshes: the median over its surfaces.
pub fn order_table(trade: &Trade) -> Table {
    let mut table = by_weight("Order of convergence over three halvings, median over surfaces", &["mesh"]);
    for tiling in Tiling::ALL {
        let cases = || trade.vertex.iter().filter(|case| case.tiling == tiling);
        let order = |weight: Weight| {
            let mut orders: Vec<f64> = cases().filter_map(|case| case.method(weight)?.order).collect();
            orders.sort_by(f64::total_cmp);
            orders.get(orders.len() / 2).map_or("exact".into(), |order| format!("{order:.2}"))
        };
        if cases().next().is_some() {
            table.push(std::iter::once(tiling.name().to_owned()).chain(Weight::ALL.map(order)));
        }
    }
    table
}

/// Every surface in every tiling: errors on the quoted mesh, to the digits that the reference prints.
pub fn surface_table(trade: &Trade) -> Table {
    let mut table = by_weight(
        "Error in degrees at 64 × 32: rms / median / 99 % / largest",
        &["surface", "mesh", "omitted"],
    );
    for case in &trade.vertex {
        let error = |weight: Weight| {
            let errors = case.quoted_errors(weight);
            errors.map_or(NONE.into(), |e| [e.rms, e.median, e.p99, e.max].map(|x| degrees(x, 4)).join(" / "))
        };
        let excluded = case.meshes.get(case.quoted).map_or(0, |mesh| mesh.excluded);
        let names = [case.surface.to_owned(), case.tiling.name().to_owned(), excluded.to_string()];
        table.push(names.into_iter().chain(Weight::ALL.map(error)));
    }
    table
}

/// The cost of each weight.
pub fn cost_table(trade: &Trade) -> Table {
    let costs = &trade.costs;
    let caption = format!(
        "Cost on one thread, {} triangles: ns per triangle (times the plain f32 loop, {} ns)",
        costs.triangles,
        three_digits(costs.plain_ns)
    );
    let mut table =
        Table::new(&caption, &["weight", "slices, faithful", "slices, fast", "mesh, faithful", "mesh, fast"]);
    for weight in Weight::ALL {
        let cell = |way: Way| {
            costs.row(way, weight).map_or(NONE.into(), |row| {
                format!("{} ({}×)", three_digits(row.ns_per_triangle), three_digits(row.ratio))
            })
        };
        let ways = Way::ALL.map(cell);
        table.push(std::iter::once(weight.name().to_owned()).chain(ways));
    }
    table
}

/// The deviation of normals at corners of boxes from the diagonals.
pub fn box_table(trade: &Trade) -> Table {
    let caption = "Corners of boxes, all 64 triangulations: degrees off the diagonal";
    let mut table = Table::new(caption, &["weight", "1 × 1 × 1", "1 × 1 × 10"]);
    let exact = |&x: &f64| if x < 1e-9 { "0".into() } else { format!("{x:.3}") };
    let cell = |row: &BoxRow| match row.deviations.as_slice() {
        values if values.len() <= 3 => values.iter().map(exact).collect::<Vec<_>>().join(", "),
        values => format!("{:.1} to {:.1}", values[0], values[values.len() - 1]),
    };
    for weight in Weight::SUMS {
        let cells = trade.boxes.iter().filter(|row| row.weight == weight).map(cell);
        table.push(std::iter::once(weight.name().to_owned()).chain(cells));
    }
    table
}

/// `fast` compared with `faithful`.
pub fn precision_table(trade: &Trade) -> Table {
    let columns: [Column<PrecisionRow>; 6] = [
        ("stored in f32", &|row| row.case.to_owned()),
        ("weight", &|row| row.weight.name().to_owned()),
        ("fast − faithful, rms", &|row| three_digits(row.fast.rms)),
        ("largest", &|row| three_digits(row.fast.max)),
        ("faithful − truth, rms", &|row| three_digits(row.faithful.rms)),
        ("", &|row| if row.declined { "faithful used" } else { "" }.to_owned()),
    ];
    Table::of("Precision: degrees", &trade.precision, &columns)
}

/// Stored normals; their times, which depend on the machine, can be omitted.
pub fn encoding_table(rows: &[EncodingRow], timed: bool) -> Table {
    let directions = rows.iter().map(|row| row.directions).max().unwrap_or(0);
    let caption = format!(
        "Stored normals: degrees over {directions} directions, the bound that none exceeds, and the largest highlight \
         exponents within half an 8-bit step up to that bound"
    );
    let exponent = |n: Option<u64>| match n {
        Some(1_000_000_000..) => "any".into(),
        Some(n) => n.to_string(),
        None => NONE.into(),
    };
    let columns: [Column<EncodingRow>; 10] = [
        ("encoding", &|row| row.name.clone()),
        ("bytes", &|row| row.bytes.to_string()),
        ("mean", &|row| three_digits(row.mean)),
        ("largest", &|row| three_digits(row.max)),
        ("bound", &|row| three_digits(row.bound)),
        ("diffuse", &|row| if row.diffuse { "yes" } else { "no" }.to_owned()),
        ("n, Blinn", &|row| exponent(row.blinn)),
        ("n, Phong", &|row| exponent(row.phong)),
        ("encode ns", &|row| three_digits(row.encode_ns)),
        ("decode ns", &|row| three_digits(row.decode_ns)),
    ];
    Table::of(&caption, rows, if timed { &columns } else { &columns[..8] })
}

/// Ways to shade with one kind of highlight: rms error in steps of 1/255 and the share of pixels over half a step.
pub fn shading_table(rows: &[ShadingRow], reflection: &str) -> Table {
    let caption = format!(
        "Shading, {reflection} highlight: rms error in steps of 1/255 of linear light (pixels over half a step); \
         pixels covered otherwise"
    );
    let columns = [
        "surface",
        "mesh",
        "faces",
        "wireframe",
        "flat",
        "gouraud scanline",
        "affine",
        "perspective",
        "phong scanline",
        "affine",
        "perspective",
        "covered otherwise",
        "Y rms, phong",
        "largest, phong",
    ];
    let mut table = Table::new(&caption, &columns);
    let of_reflection: Vec<&ShadingRow> = rows.iter().filter(|row| row.reflection == reflection).collect();
    for mesh in
        of_reflection.chunk_by(|a, b| (a.surface, a.tiling, a.faces) == (b.surface, b.tiling, b.faces))
    {
        let cells = mesh.iter().map(|row| {
            format!("{} ({:.0} %)", three_digits(row.error.linear.rms), 100.0 * row.error.linear.over)
        });
        // The last row is that of Phong shading, right under perspective.
        let (first, phong) = (mesh[0], mesh[mesh.len() - 1].error);
        let names = [first.surface.to_owned(), first.tiling.name().to_owned(), first.faces.to_string()];
        let last = [
            format!("{:.2} %", 100.0 * phong.disagreement),
            three_digits(phong.luminance.rms),
            three_digits(phong.linear.max),
        ];
        table.push(names.into_iter().chain(cells).chain(last));
    }
    table
}

/// The crate's own approximations.
pub fn approximation_table(trade: &Trade) -> Table {
    let columns: [Column<ApproximationRow>; 5] = [
        ("approximation", &|row| row.what.clone()),
        ("largest error", &|row| three_digits(row.error)),
        ("unit", &|row| row.unit.to_owned()),
        ("ns", &|row| three_digits(row.ns)),
        ("ns exactly", &|row| three_digits(row.exact_ns)),
    ];
    let caption = "Approximations of this crate compared with libm, and single with double precision";
    Table::of(caption, &trade.approximations, &columns)
}

/// The weights on a user mesh.
pub fn own_table(own: &OwnMesh) -> Table {
    let reference = match own.reference {
        Reference::Stored => "stored normals",
        Reference::Jet => "normals of jet",
        Reference::Quadric => "normals of quadric",
    };
    let caption = format!(
        "Angle to the {reference} in degrees, over {} of {} normals; cost on one thread (plain f32 loop: {} ns a triangle)",
        own.estimated_from,
        own.normals,
        three_digits(own.plain_ns)
    );
    let star = |row: &OwnMethod| if Some(row.weight) == own.recommended { "*" } else { "" };
    let estimate = |row: &OwnMethod, x: f64| match row.estimate.count > 0 && is_compared(own, row.weight) {
        true => degrees(x, 3),
        false => NONE.into(),
    };
    let columns: [Column<OwnMethod>; 8] = [
        ("weight", &|row| format!("{}{}", row.weight.name(), star(row))),
        ("rms", &|row| estimate(row, row.estimate.rms)),
        ("median", &|row| estimate(row, row.estimate.median)),
        ("99 %", &|row| estimate(row, row.estimate.p99)),
        ("largest", &|row| estimate(row, row.estimate.max)),
        ("ns/triangle", &|row| three_digits(row.ns_per_triangle)),
        ("× plain", &|row| three_digits(row.ratio)),
        ("rms to angle", &|row| three_digits(row.to_angle)),
    ];
    Table::of(&caption, &own.methods, &columns)
}

/// Milliseconds of each way to shade, on the finest regular mesh of each surface.
pub fn shading_times(rows: &[ShadingRow]) -> Table {
    let is_shown = |row: &&ShadingRow| row.reflection == "blinn" && row.tiling == Tiling::Regular;
    // For each surface the rows of its finest mesh, in the order of the ways to shade.
    let finest = rows.chunk_by(|a, b| a.surface == b.surface).map(|rows| {
        let faces = rows.iter().filter(is_shown).map(|row| row.faces).max();
        rows.iter().filter(is_shown).filter(|row| Some(row.faces) == faces).collect()
    });
    let finest: Vec<Vec<&ShadingRow>> = finest.collect();
    let surfaces = finest.iter().filter_map(|rows| Some(rows.first()?.surface));
    let columns: Vec<&str> = ["shading", "interpolation"].into_iter().chain(surfaces).collect();
    let mut table = Table::new("Time of a picture of the finest regular mesh, all threads: ms", &columns);
    for (number, way) in finest.first().into_iter().flatten().enumerate() {
        let names = [way.shading.to_owned(), way.interpolation.unwrap_or(NONE).to_owned()];
        let times = finest.iter().filter_map(|rows| Some(three_digits(rows.get(number)?.milliseconds)));
        table.push(names.into_iter().chain(times));
    }
    table
}
