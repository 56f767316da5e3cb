//! Plots of the measurement.

use crate::normals::Weight;
use crate::num::three_digits;
use crate::report::plot::{Axis, Mark, Plot, Series};
use crate::trade::{
    AngleErrors, ClassPoint, EncodingRow, Histogram, MethodErrors, OwnMesh, ShadingRow, Tiling, Trade,
    VertexCase, frontier,
};

/// Errors below this, in degrees, count as exact and are not on a logarithmic axis.
const EXACT: f64 = 1e-9;

const SIZE: [u32; 2] = [680, 320];

fn weight_series(weight: Weight, name: String, points: Vec<[f64; 2]>, mark: Mark) -> Series {
    Series { colour: Some(weight as usize), ..Series::new(&name, points, mark) }
}

/// A grey line to compare with.
fn guide(name: &str, points: [[f64; 2]; 2]) -> Series {
    Series::new(name, points.to_vec(), Mark::Guide)
}

/// Error against cost of every weight on a class of meshes, with the Pareto frontier.
pub(super) fn frontier_plot(trade: &Trade, tiling: Tiling) -> Plot {
    let points = trade.of_class(tiling);
    Plot {
        title: format!("Error against cost: {}", tiling.about()),
        x: Axis::log("times the plain f32 loop, one thread; sums by slices, fits on a mesh"),
        ..pareto_plot(&points, "")
    }
}

/// Weights by cost and error, with the Pareto frontier.
fn pareto_plot(points: &[ClassPoint], description: &str) -> Plot {
    let place = |point: &ClassPoint| [point.ratio, point.rms];
    let best = frontier(points);
    let on_it: Vec<&str> = best.iter().map(|point| point.weight.name()).collect();
    let line = Series::new("Pareto frontier", best.iter().map(place).collect(), Mark::Frontier);
    let weights = points.iter().map(|point| {
        weight_series(point.weight, point.weight.name().into(), vec![place(point)], Mark::Points)
    });
    let description = format!("Pareto frontier, from cheap to accurate: {}. {description}", on_it.join(", "));
    Plot {
        description: description.trim_end().into(),
        size: SIZE,
        y: Axis::log("rms error, degrees"),
        series: std::iter::once(line).chain(weights).collect(),
        ..Plot::default()
    }
}

/// Errors over edge lengths on one surface.
pub(super) fn convergence_plot(case: &VertexCase) -> Plot {
    // The mean edge in units of the coarsest one.
    let faces: Vec<f64> = case.meshes.iter().map(|mesh| mesh.faces as f64).collect();
    let edge = |place: usize| (faces[0] / faces[place]).sqrt();
    let method = |method: &MethodErrors| {
        let name = match method.order {
            Some(order) => format!("{}, order {order:.2}", method.weight.name()),
            None => format!("{}, exact", method.weight.name()),
        };
        let shown = |rms: f64| if rms < EXACT { 0.0 } else { rms };
        let points = method.errors.iter().enumerate().map(|(place, errors)| [edge(place), shown(errors.rms)]);
        weight_series(method.weight, name, points.collect(), Mark::Line)
    };
    let coarsest = case.methods.iter().filter_map(|method| Some(method.errors.first()?.rms));
    let top = coarsest.fold(0.0, f64::max) * 1.6;
    let finest = edge(faces.len() - 1);
    let slopes = [("slope 1", top * finest), ("slope 2", top * finest * finest)];
    let slopes = slopes.map(|(name, low)| guide(name, [[1.0, top], [finest, low]]));
    let series = case.methods.iter().map(method).chain(slopes).collect();
    let orders = case.methods.iter().map(|method| {
        let order = method.order.map_or("exact".into(), |order| format!("{order:.2}"));
        format!("{} {order}", method.weight.name())
    });
    Plot {
        title: format!("Convergence: {}, {}", case.surface, case.tiling.name()),
        description: format!("Orders: {}.", orders.collect::<Vec<_>>().join(", ")),
        size: [680, 340],
        x: Axis::log("mean edge, coarsest mesh = 1"),
        y: Axis::log("rms error, degrees"),
        series,
        ..Plot::default()
    }
}

pub(super) fn histogram_plot(case: &VertexCase) -> Plot {
    let spread = case
        .methods
        .iter()
        .filter_map(|method| Some((method.weight, method.errors.get(case.quoted)?, &method.histogram)));
    Plot {
        title: format!("Errors of normals: {}, {}", case.surface, case.tiling.name()),
        x: Axis::log("error, degrees"),
        ..spread_plot(&spread.collect::<Vec<_>>())
    }
}

fn spread_plot(spread: &[(Weight, &AngleErrors, &Histogram)]) -> Plot {
    let edges: Vec<f64> = Histogram::edges().collect();
    let shown = spread.iter().filter(|(_, errors, _)| errors.rms > EXACT);
    let series = shown.map(|(weight, _, histogram)| {
        let shares = histogram.shares.iter().chain(histogram.shares.last());
        // Empty bins at both ends are omitted.
        let points = edges.iter().zip(shares).map(|(&edge, &share)| [edge, 100.0 * share]);
        let points: Vec<[f64; 2]> = points.collect();
        let first = points.iter().position(|point| point[1] > 0.0).unwrap_or(0);
        let last = points.iter().rposition(|point| point[1] > 0.0).map_or(points.len(), |last| last + 2);
        let points = points[first..last.min(points.len())].to_vec();
        weight_series(*weight, weight.name().into(), points, Mark::Steps)
    });
    let medians = spread
        .iter()
        .map(|(weight, errors, _)| format!("{} {}°", weight.name(), three_digits(errors.median)));
    Plot {
        description: format!("Medians: {}.", medians.collect::<Vec<_>>().join(", ")),
        size: SIZE,
        y: Axis::linear("normals in a quarter of a decade, %"),
        series: series.collect(),
        ..Plot::default()
    }
}

pub(super) fn encoding_plot(rows: &[EncodingRow]) -> Plot {
    let kind = |name: &str, takes: &dyn Fn(&EncodingRow) -> bool| {
        let points = rows.iter().filter(|row| takes(row)).map(|row| [row.bytes as f64, row.max]);
        Series::new(name, points.collect(), Mark::Points)
    };
    let nearest = |row: &EncodingRow| row.name.ends_with("nearest");
    let octahedral = |row: &EncodingRow| row.name.starts_with("oct");
    let half_step = (1.0_f64 / 510.0).to_degrees();
    Plot {
        title: "Stored normals: the worst angle".into(),
        description:
            "The worst angle falls by half with each bit of an octahedral component; those of 16 bits are \
                      below four thousandths of a degree in four bytes."
                .into(),
        size: SIZE,
        x: Axis { range: Some([1.0, 13.0]), ..Axis::linear("bytes of a normal") },
        y: Axis::log("largest error, degrees"),
        series: vec![
            kind("octahedral", &|row| octahedral(row) && !nearest(row)),
            kind("octahedral, nearest", &|row| octahedral(row) && nearest(row)),
            kind("snorm", &|row| row.name.starts_with("snorm")),
            kind("floating point", &|row| !octahedral(row) && !row.name.starts_with("snorm")),
            guide("half a step, diffuse", [[1.0, half_step], [13.0, half_step]]),
        ],
        ..Plot::default()
    }
}

/// Errors of ways to shade over the number of faces, on regular meshes of one surface.
pub(super) fn shading_plot(rows: &[ShadingRow], surface: &str) -> Plot {
    let ways = [("flat", None), ("gouraud", Some("perspective")), ("phong", Some("perspective"))];
    let series = ["blinn", "phong"].into_iter().flat_map(|reflection| {
        ways.map(|(shading, interpolation)| {
            let of_way = rows.iter().filter(|row| {
                row.surface == surface
                    && row.tiling == Tiling::Regular
                    && (row.reflection, row.shading, row.interpolation)
                        == (reflection, shading, interpolation)
            });
            let points = of_way.map(|row| [row.faces as f64, row.error.linear.rms]);
            Series::new(&format!("{shading}, {reflection} highlight"), points.collect(), Mark::Line)
        })
    });
    Plot {
        title: format!("Shading: {surface}"),
        description:
            "Flat shading is worst and Phong shading best at every number of faces; all come closer to the \
                      picture of the surface as faces grow in number."
                .into(),
        size: SIZE,
        x: Axis::log("faces"),
        y: Axis::log("rms error, steps of 1/255"),
        series: series.collect(),
        ..Plot::default()
    }
}

/// Estimated error against cost on a user mesh, with the Pareto frontier.
pub(super) fn own_plot(own: &OwnMesh) -> Plot {
    let sums = own.methods.iter().filter(|method| !method.weight.is_fit());
    let points: Vec<ClassPoint> = sums
        .map(|method| ClassPoint { weight: method.weight, rms: method.estimate.rms, ratio: method.ratio })
        .collect();
    let description = format!("Recommended: {}.", own.recommended.name());
    Plot {
        title: "Estimated error against cost".into(),
        x: Axis::log("times the plain f32 loop, one thread, on a mesh"),
        y: Axis::log("rms angle to the quadric's normals, degrees"),
        ..pareto_plot(&points, &description)
    }
}

/// The distribution of the estimated errors on a user mesh.
pub(super) fn own_histogram_plot(own: &OwnMesh) -> Plot {
    let spread = own.methods.iter().filter(|method| !method.weight.is_fit());
    let spread: Vec<_> = spread.map(|method| (method.weight, &method.estimate, &method.histogram)).collect();
    Plot {
        title: "Estimated errors of normals".into(),
        x: Axis::log("angle to the quadric's normals, degrees"),
        ..spread_plot(&spread)
    }
}
