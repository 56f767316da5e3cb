//! The options of `crease surface`.

use crate::cli::common::choice::{choices, one_of};
use crate::cli::common::options::{EXIT_CODES, RunArgs};
use crate::cli::common::vectors::{finite_numbers, vector};
use clap::Args;
use crease::io::Format;
use crease::surface::Pattern;
use glam::DVec3;
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  crease surface torus --segments 64x32 --jitter 0.5 -o torus.ply
  crease surface sphere --pattern icosphere --level 4 -o sphere.glb
  crease surface teapot --segments 16 --uv -o teapot.obj";

/// Write an analytic surface as a mesh with its exact normals
///
/// Positions lie on the surface to the last digits of a double. Normals are those of the surface, not of the mesh. OBJ
/// and PLY store positions as doubles, PLY also normals. OBJ and glTF store normals in single precision, with an error of
/// up to 3e-6 degrees. STL stores facet normals instead. The axis of surfaces of revolution is y; planes,
/// waves and saddles lie in x and y and face +z.
#[derive(Args)]
#[command(allow_negative_numbers = true, after_help = EXAMPLES, after_long_help = format!("{EXAMPLES}\n\n{EXIT_CODES}"))]
pub struct SurfaceArgs {
    /// Surface by its name
    #[arg(value_name = "SURFACE", value_parser = one_of::<Kind>())]
    pub kind: Kind,

    /// Output file, or `-` for standard output; folders are created if necessary
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,

    /// Format of the output [default: by name]
    #[arg(long, value_name = "FORMAT", value_parser = one_of::<Format>())]
    pub to: Option<Format>,

    /// Wait until the output is on the disk
    #[arg(long)]
    pub sync: bool,

    #[command(flatten)]
    pub shape: ShapeArgs,
    #[command(flatten)]
    pub mesh: PatternArgs,
    #[command(flatten)]
    pub run: RunArgs,
}

#[derive(Args)]
#[command(next_help_heading = "Shape")]
pub struct ShapeArgs {
    /// Radius of a sphere, a cylinder, or the base of a cone [default: 1]
    #[arg(long, value_name = "R")]
    pub radius: Option<f64>,

    /// Height of a cylinder or a cone [default: 2], or a catenoid [default: 1.5]
    #[arg(long, value_name = "H")]
    pub height: Option<f64>,

    /// Torus: distance from the axis to the middle of the tube [default: 1]
    #[arg(long, value_name = "R")]
    pub major: Option<f64>,

    /// Torus: radius of the tube [default: 0.4]
    #[arg(long, value_name = "R")]
    pub minor: Option<f64>,

    /// Catenoid: smallest radius [default: 0.5]
    #[arg(long, value_name = "R")]
    pub waist: Option<f64>,

    /// Plane, wave or saddle: width and, for the plane, height [default: 2]
    #[arg(long, value_name = "W[,H]", value_parser = one_or_two)]
    pub size: Option<[f64; 2]>,

    /// Semi-axes along x, y and z of an ellipsoid [default: 1,0.6,0.4] or a superquadric [default: 1,1,1]
    #[arg(long, value_name = "A,B,C", value_parser = vector)]
    pub semi_axes: Option<DVec3>,

    /// Superquadric: exponents from north to south and from east to west; 0.1 is a box, 1 an ellipsoid, 1.9 an
    /// octahedron [default: 0.5,0.5]
    #[arg(long, value_name = "N,E", value_parser = one_or_two)]
    pub roundness: Option<[f64; 2]>,

    /// Stretch the surface, by one factor or along each axis; a negative one mirrors
    #[arg(long, value_name = "S|X,Y,Z", default_value = "1", value_parser = factors, allow_hyphen_values = true)]
    pub scale: DVec3,

    /// Move the surface, after scaling
    #[arg(long, value_name = "X,Y,Z", default_value = "0,0,0", value_parser = vector, allow_hyphen_values = true)]
    pub offset: DVec3,
}

#[derive(Args)]
#[command(next_help_heading = "Mesh")]
pub struct PatternArgs {
    /// Arrangement of vertices and faces
    #[arg(long, value_name = "PATTERN", default_value = "triangles", value_parser = one_of::<Pattern>())]
    pub pattern: Pattern,

    /// Cells in both directions, of each patch for the teapot [default: 64x32; bezier 32x32; teapot 8x8]
    #[arg(long, value_name = "U[xV]", value_parser = segments)]
    pub segments: Option<[u32; 2]>,

    /// Ratio of cells: stretched [default: 10], slivers [default: 1000]
    #[arg(long, value_name = "RATIO")]
    pub ratio: Option<f64>,

    /// Subdivisions of an icosphere [default: 3]
    #[arg(long, value_name = "N")]
    pub level: Option<u32>,

    /// Random displacement of vertices within the surface, in cells, from 0 to 1. Cells are then cut along a random
    /// diagonal
    #[arg(long, value_name = "CELLS", default_value_t = 0.0)]
    pub jitter: f64,

    /// Random displacement of vertices along the normal, in mean edge lengths, from 0 to 1. Normals stay
    #[arg(long, value_name = "EDGES", default_value_t = 0.0)]
    pub noise: f64,

    /// Seed of the random numbers
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub seed: u32,

    /// Write the parameters as texture coordinates, which splits vertices at seams in most formats
    #[arg(long)]
    pub uv: bool,
}

/// A surface by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    Plane,
    Sphere,
    Ellipsoid,
    Cylinder,
    Cone,
    Torus,
    Catenoid,
    Wave,
    MonkeySaddle,
    Superquadric,
    Bezier,
    Teapot,
}

choices! { Kind {
    "plane" => Plane: "a rectangle",
    "sphere" => Sphere: "a sphere",
    "ellipsoid" => Ellipsoid: "three different axes",
    "cylinder" => Cylinder: "a tube, open at both ends",
    "cone" => Cone: "with a tip, open at the base",
    "torus" => Torus: "a ring",
    "catenoid" => Catenoid: "the film between two rings: mean curvature zero",
    "wave" => Wave: "z = 0.3 sin 3x cos 3y",
    "monkey-saddle" => MonkeySaddle: "z = x³ − 3xy²",
    "superquadric" => Superquadric: "between box, ellipsoid and octahedron",
    "bezier" => Bezier: "one bicubic patch",
    "teapot" => Teapot: "Newell's, of 32 patches",
} }

choices! { Pattern {
    "triangles" => Triangles: "a grid of the parameters, its cells cut in two",
    "stretched" => Stretched(10.0): "the same, with cells stretched by --ratio in one direction",
    "slivers" => Slivers(1000.0): "every other row --ratio times as close to the next",
    "quads" => Quads: "the cells themselves",
    "polygons" => Polygons: "the dual of the triangles: mostly hexagons; the tip of a cone is cut off",
    "icosphere" => Icosphere(3): "a subdivided icosahedron (sphere, ellipsoid, superquadric)",
    "marching" => Marching: "marching tetrahedra (not bezier and teapot); --segments along the longest side",
    "scattered" => Scattered: "Delaunay triangles of random points (plane, wave, monkey-saddle)",
} }

fn one_or_two(text: &str) -> Result<[f64; 2], String> {
    match finite_numbers(text).as_deref() {
        Ok(&[one]) => Ok([one; 2]),
        Ok(&[one, two]) => Ok([one, two]),
        _ => Err("one number, or two with a comma, was expected".into()),
    }
}

fn factors(text: &str) -> Result<DVec3, String> {
    let factors = match finite_numbers(text).as_deref() {
        Ok(&[one]) => DVec3::splat(one),
        Ok(&[x, y, z]) => DVec3::new(x, y, z),
        _ => return Err("one factor, or three with commas, was expected".into()),
    };
    if factors.cmpne(DVec3::ZERO).all() { Ok(factors) } else { Err("a factor of 0 leaves no surface".into()) }
}

fn segments(text: &str) -> Result<[u32; 2], String> {
    let (u, v) = text.split_once('x').unwrap_or((text, text));
    match (u.parse(), v.parse()) {
        (Ok(u), Ok(v)) if u > 0 && v > 0 => Ok([u, v]),
        _ => Err("a number of cells, or two such as 64x32, was expected".into()),
    }
}
