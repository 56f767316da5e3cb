//! The options of `crease surface`.

use crate::cli::common::choice::{choices, one_of, written_formats};
use crate::cli::common::options::RunArgs;
use crate::cli::common::options::{finite_numbers, vector};
use clap::Args;
use crease::io::Format;
use crease::surface::Pattern;
use glam::DVec3;
use std::path::PathBuf;

#[derive(Args)]
#[command(allow_negative_numbers = true)]
pub struct SurfaceArgs {
    #[arg(value_name = "SURFACE", value_parser = one_of::<Kind>())]
    pub kind: Kind,
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
    #[arg(long, value_name = "FORMAT", value_parser = written_formats())]
    pub to: Option<Format>,
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
    #[arg(long, value_name = "R")]
    pub radius: Option<f64>,
    #[arg(long, value_name = "H")]
    pub height: Option<f64>,
    #[arg(long, value_name = "R")]
    pub major: Option<f64>,
    #[arg(long, value_name = "R")]
    pub minor: Option<f64>,
    #[arg(long, value_name = "R")]
    pub waist: Option<f64>,
    #[arg(long, value_name = "W[,H]", value_parser = one_or_two)]
    pub size: Option<[f64; 2]>,
    #[arg(long, value_name = "A,B,C", value_parser = vector)]
    pub semi_axes: Option<DVec3>,
    #[arg(long, value_name = "N,E", value_parser = one_or_two)]
    pub roundness: Option<[f64; 2]>,
    #[arg(long, value_name = "S|X,Y,Z", default_value = "1", value_parser = factors, allow_hyphen_values = true)]
    pub scale: DVec3,
    #[arg(long, value_name = "X,Y,Z", default_value = "0,0,0", value_parser = vector, allow_hyphen_values = true)]
    pub offset: DVec3,
}

#[derive(Args)]
#[command(next_help_heading = "Mesh")]
pub struct PatternArgs {
    #[arg(long, value_name = "PATTERN", default_value = "triangles", value_parser = one_of::<Pattern>())]
    pub pattern: Pattern,
    #[arg(long, value_name = "U[xV]", value_parser = segments)]
    pub segments: Option<[u32; 2]>,
    #[arg(long, value_name = "RATIO")]
    pub ratio: Option<f64>,
    #[arg(long, value_name = "N")]
    pub level: Option<u32>,
    #[arg(long, value_name = "CELLS", default_value_t = 0.0)]
    pub jitter: f64,
    #[arg(long, value_name = "EDGES", default_value_t = 0.0)]
    pub noise: f64,
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub seed: u32,
    #[arg(long)]
    pub uv: bool,
}

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

choices! { Kind:
    "plane" => Plane, "sphere" => Sphere, "ellipsoid" => Ellipsoid, "cylinder" => Cylinder, "cone" => Cone,
    "torus" => Torus, "catenoid" => Catenoid, "wave" => Wave, "monkey-saddle" => MonkeySaddle,
    "superquadric" => Superquadric, "bezier" => Bezier, "teapot" => Teapot,
}

choices! { Pattern:
    "triangles" => Triangles, "stretched" => Stretched(10.0), "slivers" => Slivers(1000.0),
    "quads" => Quads, "polygons" => Polygons, "icosphere" => Icosphere(3), "marching" => Marching,
    "scattered" => Scattered,
}

fn one_or_two(text: &str) -> Result<[f64; 2], String> {
    match finite_numbers(text).as_deref() {
        Ok(&[one]) => Ok([one; 2]),
        Ok(&[one, two]) => Ok([one, two]),
        _ => Err("expected one number, or two with a comma".into()),
    }
}

fn factors(text: &str) -> Result<DVec3, String> {
    let factors = match finite_numbers(text).as_deref() {
        Ok(&[one]) => DVec3::splat(one),
        Ok(&[x, y, z]) => DVec3::new(x, y, z),
        _ => return Err("expected one factor, or three with commas".into()),
    };
    if factors.cmpne(DVec3::ZERO).all() { Ok(factors) } else { Err("a factor of 0 leaves no surface".into()) }
}

fn segments(text: &str) -> Result<[u32; 2], String> {
    let (u, v) = text.split_once('x').unwrap_or((text, text));
    match (u.parse(), v.parse()) {
        (Ok(u), Ok(v)) if u > 0 && v > 0 => Ok([u, v]),
        _ => Err("expected a number of cells, or two such as 64x32".into()),
    }
}
