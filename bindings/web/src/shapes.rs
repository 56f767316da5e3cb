//! The ten built-in meshes: analytic surfaces, whose exact normals are known, and files of the repository.

use crate::laboratory::Result;
use crease::io::Part;
use crease::io::{Format, WriteOptions, write_new};
use crease::surface::{Cone, Cylinder, Primitive, Sphere, Superquadric, Surface, Tessellation, Torus, Wave};
use serde::Serialize;

/// A built-in mesh, as the page lists it.
#[derive(Serialize)]
pub(crate) struct Shape {
    /// Its name in links.
    pub id: &'static str,
    /// The default number of segments of an analytic surface; 0 for files.
    pub segments: u32,
    /// The largest number of segments; 0 for files.
    pub most: u32,
    /// Whether rays can be cast at the surface, so that there is an exact picture.
    pub exact: bool,
    #[serde(skip)]
    source: Source,
}

enum Source {
    Surface(fn() -> Surface),
    File(&'static str, &'static [u8]),
}

const fn surface(id: &'static str, segments: u32, exact: bool, make: fn() -> Surface) -> Shape {
    Shape { id, segments, most: 192, exact, source: Source::Surface(make) }
}

const fn file(id: &'static str, name: &'static str, bytes: &'static [u8]) -> Shape {
    Shape { id, segments: 0, most: 0, exact: false, source: Source::File(name, bytes) }
}

macro_rules! data {
    ($name:literal) => {
        include_bytes!(concat!("../../../data/", $name))
    };
}

/// All of them, in the order of the page.
pub(crate) static SHAPES: [Shape; 10] = [
    surface("sphere", 16, true, || Sphere::default().into()),
    surface("torus", 24, true, || Torus::default().into()),
    surface("cylinder", 12, true, || Cylinder::default().into()),
    surface("cone", 12, true, || Cone::default().into()),
    surface("wave", 24, false, || Surface::Wave(Wave::default())),
    surface("superquadric", 32, false, || Surface::Superquadric(Superquadric::default())),
    Shape { most: 48, ..surface("teapot", 6, false, || Surface::Teapot) },
    file("gear", "gear.obj", data!("gear.obj")),
    file("bracket", "bracket.obj", data!("bracket.obj")),
    file("leaf", "leaf.ply", data!("leaf.ply")),
];

/// A built-in mesh as a file.
pub(crate) struct Made {
    pub name: String,
    pub bytes: Vec<u8>,
    pub surface: Option<Primitive>,
    /// The command that makes the file, or nothing for files of the repository.
    pub command: Option<String>,
}

pub(crate) fn make(id: &str, segments: u32) -> Result<Made> {
    let shape =
        SHAPES.iter().find(|shape| shape.id == id).ok_or_else(|| format!("no mesh has the name {id:?}"))?;
    let make = match shape.source {
        Source::File(name, bytes) => {
            return Ok(Made { name: name.to_owned(), bytes: bytes.to_vec(), surface: None, command: None });
        }
        Source::Surface(make) => make,
    };
    if !(3..=shape.most).contains(&segments) {
        return Err(format!("{segments} segments: give 3 to {}", shape.most));
    }
    let surface = make();
    let segments = match id {
        "sphere" | "torus" => [segments, segments.div_ceil(2).max(3)],
        "cylinder" | "cone" => [segments, segments.div_ceil(4)],
        _ => [segments; 2],
    };
    let mesh = surface
        .tessellate(&Tessellation { segments, ..Tessellation::default() })
        .map_err(|error| error.to_string())?;
    let part = Part { name: id.to_owned(), mesh, ..Part::default() };
    let written =
        write_new(&[part], Format::Ply, &WriteOptions::default()).map_err(|error| error.to_string())?;
    let [u, v] = segments;
    let command = format!("crease surface {id} --segments {u}x{v} -o {id}.ply");
    let surface = if let Surface::Primitive(primitive) = surface { Some(primitive) } else { None };
    Ok(Made { name: format!("{id}.ply"), bytes: written.bytes, surface, command: Some(command) })
}
