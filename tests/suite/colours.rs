//! Colours that distinguish things do so without full colour vision too.
//!
//! Protanopia, deuteranopia and tritanopia as G. M. Machado, M. M. Oliveira and L. A. F. Fernandes simulate them (*A
//! physiologically-based model for simulation of color vision deficiency*, IEEE TVCG 15(6), 2009, severity 1.0, on linear
//! components), and differences as CIELAB has them (ΔE*ab of 1976, white D65), in which 2.3 are just noticed side by side
//! (M. Mahy et al., *Evaluation of uniform color spaces*, Color Research and Application 19(2), 1994).

use crease::artefact::{Parameters, Setup, experiment};
use crease::normals::{NormalRecipe, compute};
use crease::num::{LinearRgb, Srgb8};
use crease::raster::{Camera, Image, Object, Projection, Scene, Shape};
use crease::report::{Axis, Mark, Overlay, Plot, Series, overlay};
use crease::shade::Material;
use crease::surface::{Sphere, Surface, Tessellation};
use glam::DVec3;

type Matrix = [[f64; 3]; 3];

const SIGHT: [(&str, Matrix); 4] = [
    ("full colour vision", [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]),
    (
        "protanopia",
        [
            [0.152_286, 1.052_583, -0.204_868],
            [0.114_503, 0.786_281, 0.099_216],
            [-0.003_882, -0.048_116, 1.051_998],
        ],
    ),
    (
        "deuteranopia",
        [
            [0.367_322, 0.860_646, -0.227_968],
            [0.280_085, 0.672_501, 0.047_413],
            [-0.011_820, 0.042_940, 0.968_881],
        ],
    ),
    (
        "tritanopia",
        [
            [1.255_528, -0.076_749, -0.178_779],
            [-0.078_411, 0.930_809, 0.147_602],
            [0.004_733, 0.691_367, 0.303_900],
        ],
    ),
];

/// L*, a*, b* of a linear colour as it is seen.
fn lab(colour: [f64; 3], sight: &Matrix) -> [f64; 3] {
    let apply = |matrix: &Matrix, v: [f64; 3]| matrix.map(|[a, b, c]| a * v[0] + b * v[1] + c * v[2]);
    // sRGB's primaries (IEC 61966-2-1).
    const XYZ: Matrix = [
        [0.412_456_4, 0.357_576_1, 0.180_437_5],
        [0.212_672_9, 0.715_152_2, 0.072_175_0],
        [0.019_333_9, 0.119_192_0, 0.950_304_1],
    ];
    let [x, y, z] = apply(&XYZ, apply(sight, colour).map(|component| component.clamp(0.0, 1.0)));
    let f = |t: f64| if t > 216.0 / 24389.0 { libm::cbrt(t) } else { (24389.0 / 27.0 * t + 16.0) / 116.0 };
    let [x, y, z] = [x / 0.950_47, y, z / 1.088_83].map(f);
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

fn difference(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
}

/// Every two of these colours differ by at least `least` for every kind of colour vision.
fn assert_distinct(what: &str, colours: &[[f64; 3]], least: f64) {
    for (name, sight) in &SIGHT {
        let seen: Vec<[f64; 3]> = colours.iter().map(|&colour| lab(colour, sight)).collect();
        for (i, j) in (0..seen.len()).flat_map(|i| (i + 1..seen.len()).map(move |j| (i, j))) {
            let found = difference(seen[i], seen[j]);
            assert!(found >= least, "{what}, {name}: {:?} and {:?}: {found:.1}", colours[i], colours[j]);
        }
    }
}

/// A colour of SVG.
fn hexadecimal(text: &str) -> [f64; 3] {
    let code = |k: usize| u8::from_str_radix(&text[k..k + 2], 16).unwrap();
    LinearRgb::from(Srgb8([code(1), code(3), code(5)])).to_array()
}

/// Figures computed independently: red is L* 53.2, a* 80.1, b* 67.2; white stays white for every kind of colour vision.
#[test]
fn simulations_are_right() {
    let red = lab([1.0, 0.0, 0.0], &SIGHT[0].1);
    assert!(difference(red, [53.24, 80.09, 67.20]) < 0.05, "{red:?}");
    for (name, sight) in &SIGHT {
        // Rows of the published matrices add up to 1 to their last digit.
        assert!(difference(lab([1.0; 3], sight), [100.0, 0.0, 0.0]) < 0.02, "{name}");
    }
    // A red and a green that look alike to people with deuteranopia.
    let [red, green] = [[0.4, 0.05, 0.0], [0.06, 0.2, 0.0]];
    let seen = |k: usize| difference(lab(red, &SIGHT[k].1), lab(green, &SIGHT[k].1));
    assert!(seen(0) > 60.0 && seen(2) < 12.0, "{} {}", seen(0), seen(2));
}

/// Lines also differ in dashes and markers, so five times the just noticeable difference is enough.
#[test]
fn lines_of_plots_are_distinguished() {
    let series = |k: u32, mark| Series {
        name: k.to_string(),
        points: vec![[0.0, f64::from(k)], [1.0, f64::from(k)]],
        mark,
        ..Series::default()
    };
    let lines = (0..8).map(|k| series(k, Mark::Curve)).chain([series(8, Mark::Guide)]);
    let plot =
        Plot { x: Axis::linear("x"), y: Axis::linear("y"), series: lines.collect(), ..Plot::default() };
    let svg = plot.svg("plot");
    let mut colours: Vec<&str> = Vec::new();
    for stroke in svg.split("fill=\"none\" stroke=\"").skip(1) {
        let stroke = &stroke[..stroke.find('"').unwrap()];
        if !colours.contains(&stroke) {
            colours.push(stroke);
        }
    }
    assert!(colours.len() >= 9, "{colours:?} of {svg}");
    let mut colours: Vec<[f64; 3]> = colours.into_iter().map(hexadecimal).collect();
    colours.push([1.0; 3]);
    assert_distinct("lines", &colours, 11.0);
}

/// Lines over a picture differ in colour only.
#[test]
fn overlays_are_distinguished() {
    let mesh = Surface::from(Sphere::default()).tessellate(&Tessellation::default()).unwrap();
    let normals = compute(&mesh, &NormalRecipe::default());
    let scene = Scene {
        objects: vec![Object::new(Shape::Mesh { mesh: &mesh, normals: &normals }, Material::default())],
        lines: Vec::new(),
        lights: Vec::new(),
        camera: Camera {
            eye: DVec3::Z * 10.0,
            target: DVec3::ZERO,
            up: DVec3::Y,
            projection: Projection::Orthographic(2.0),
            near: 0.0,
        },
        background: LinearRgb::BLACK,
    };
    let kinds = [Overlay::Wire, Overlay::Creases, Overlay::VertexNormals, Overlay::FaceNormals];
    let colours = kinds.map(|kind| overlay(&scene, [64; 2], kind)[0].style.colour.to_array());
    assert_distinct("overlays", &colours, 25.0);
}

/// The linear colours of what is covered, each once.
fn colours_of(image: &Image) -> Vec<[f64; 3]> {
    let pixels = image.linear.as_ref().unwrap().iter().zip(&image.coverage);
    let mut colours: Vec<[f32; 3]> =
        pixels.filter(|&(_, &covered)| covered > 0).map(|(&colour, _)| colour).collect();
    colours.sort_by(|a, b| a.partial_cmp(b).unwrap());
    colours.dedup();
    colours.into_iter().map(|colour| colour.map(f64::from)).collect()
}

/// The squares of the checkerboard, and colour maps: larger values are lighter for every kind of colour vision.
#[test]
fn maps_and_squares_are_distinguished() {
    let experiment = experiment("perspective-distortion").unwrap();
    let parameters = Parameters { size: 64, ..experiment.defaults };
    let outcome = experiment.run(&Setup { parameters, mesh: None }).unwrap();
    let shot = |name| &outcome.shots.iter().find(|shot| shot.name == name).unwrap().image;
    let squares = colours_of(shot("perspective"));
    assert_eq!(squares.len(), 2);
    assert_distinct("squares", &squares, 40.0);
    let mut map = colours_of(shot("error"));
    assert!(map.len() > 20, "{}", map.len());
    map.sort_by(|a, b| lab(*a, &SIGHT[0].1)[0].total_cmp(&lab(*b, &SIGHT[0].1)[0]));
    for (name, sight) in &SIGHT {
        let seen: Vec<f64> = map.iter().map(|&colour| lab(colour, sight)[0]).collect();
        // Neighbouring steps may look alike, but no step is noticeably darker than the one before.
        let back = seen.windows(2).map(|pair| pair[0] - pair[1]).fold(0.0, f64::max);
        assert!(back < 1.0 && seen[seen.len() - 1] - seen[0] > 60.0, "{name}: {back} {seen:?}");
    }
}
