//! Plots of the measurement.

use crate::normals::Weight;
use crate::num::three_digits;
use crate::report::plot::{Axis, Mark, Plot, Series};
use crate::trade::{
    AngleErrors, ClassPoint, EncodingRow, Histogram, MeshClass, MethodErrors, OwnMesh, OwnMethod, Reference,
    ShadingRow, Tiling, VertexCase, frontier, mark_dominated,
};

/// Errors below this, in degrees, count as exact and are not on a logarithmic axis.
const EXACT: f64 = 1e-9;

fn weight_series(weight: Weight, name: String, points: Vec<[f64; 2]>, mark: Mark) -> Series {
    Series { colour: Some(weight as usize), ..Series::new(&name, points, mark) }
}

/// A grey line to compare with.
fn guide(name: &str, points: [[f64; 2]; 2]) -> Series {
    Series::new(name, points.to_vec(), Mark::Guide)
}

/// Error against cost of every weight on a class of meshes, with the Pareto frontier.
pub(super) fn frontier_plot(class: &MeshClass) -> Plot {
    let spread = match class.spread() {
        0.0 => "The meshes have no random numbers.".into(),
        spread => format!("Other seeds change a median by at most {:.0} %.", 100.0 * spread),
    };
    let description =
        format!("Medians over {} surfaces, without boundary vertices. {spread}", class.surfaces);
    Plot {
        title: format!("Error against cost: {}", class.tiling.about()),
        x: Axis::log("cost, times the plain loop on one thread; sums on slices, fits on a mesh"),
        ..pareto_plot(&class.points, &description)
    }
}

/// Weights by cost and error, with the Pareto frontier. Hollow signs are of weights that another dominates.
fn pareto_plot(points: &[ClassPoint], description: &str) -> Plot {
    let place = |point: &ClassPoint| [point.ratio, if point.rms < EXACT { 0.0 } else { point.rms }];
    let best = frontier(points);
    let line = Series::new("Pareto frontier", best.iter().map(place).collect(), Mark::Frontier);
    let weights = points.iter().map(|point| {
        let (mark, note) = match point.dominated_by {
            Some(_) => (Mark::Hollow, ", dominated"),
            None => (Mark::Points, ""),
        };
        let exact = if point.rms < EXACT { ", exact" } else { "" };
        let name = format!("{}{exact}{note}", point.weight.name());
        weight_series(point.weight, name, vec![place(point)], mark)
    });
    let on_it: Vec<&str> = best.iter().map(|point| point.weight.name()).collect();
    let description = format!("Pareto frontier, from cheap to accurate: {}. {description}", on_it.join(", "));
    Plot {
        description,
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
        title: "Stored normals: largest error".into(),
        description:
            "Each bit of an octahedral component halves the largest error. With 16 bits a component, which take four bytes, it \
                      is below 0.004°."
                .into(),
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
            "At every number of faces, flat shading has the largest error and Phong shading the smallest. All errors fall as \
                      the number of faces grows."
                .into(),
        x: Axis::log("faces"),
        y: Axis::log("rms error, steps of 1/255"),
        series: series.collect(),
        ..Plot::default()
    }
}

/// Error against cost on a user mesh, with the Pareto frontier.
pub(super) fn own_plot(own: &OwnMesh) -> Plot {
    // The error of the reference is an estimate of its own.
    let is_reference = |weight| own.reference.weight() == Some(weight);
    let shown =
        own.methods.iter().filter(|method| is_compared(own, method.weight) || is_reference(method.weight));
    let point = |method: &OwnMethod| {
        let OwnMethod { weight, ratio, .. } = *method;
        let rms = if is_reference(weight) { own.reference_error } else { method.estimate.rms };
        ClassPoint { weight, rms, spread: [rms; 2], ratio, dominated_by: None }
    };
    let mut points: Vec<ClassPoint> = shown.map(point).collect();
    mark_dominated(&mut points);
    let description =
        own.recommended.map_or("None is recommended.".into(), |it| format!("Recommended: {}.", it.name()));
    Plot {
        title: "Error against cost".into(),
        x: Axis::log("cost, times the plain loop on one thread, on a mesh"),
        y: Axis::log("rms angle to the reference, or its own estimated error, degrees"),
        ..pareto_plot(&points, &description)
    }
}

/// Whether the angles of a weight to the reference are its errors: fits are or nearly are the reference, unless that is stored.
pub(super) fn is_compared(own: &OwnMesh, weight: Weight) -> bool {
    own.reference == Reference::Stored || !weight.is_fit()
}

/// The distribution of the errors on a user mesh.
pub(super) fn own_histogram_plot(own: &OwnMesh) -> Plot {
    let spread = own.methods.iter().filter(|method| is_compared(own, method.weight));
    let spread: Vec<_> = spread.map(|method| (method.weight, &method.estimate, &method.histogram)).collect();
    Plot {
        title: "Errors of normals".into(),
        x: Axis::log("angle to the reference, degrees"),
        ..spread_plot(&spread)
    }
}
