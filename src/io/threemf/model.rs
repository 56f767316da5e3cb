//! One model part: its objects, and the items of its build.

use super::package::{Element, Package, attribute, error};
use crate::io::text::{float, shown};
use crate::io::{Problem, ReadError};
use glam::{DMat4, DVec3};
use quick_xml::events::BytesStart;
use std::collections::BTreeSet;

/// The most objects, components and items of a file. Each takes far more memory than the words that make one.
const MOST: usize = 1 << 16;

const ADVICE: &str = "export it again";

/// Extensions of which a file may require the understanding: they add no geometry. The production extension distributes objects
/// over several parts.
const UNDERSTOOD: [&str; 3] = [
    "http://schemas.microsoft.com/3dmanufacturing/production/2015/06",
    "http://schemas.microsoft.com/3dmanufacturing/material/2015/02",
    "http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07",
];

/// A reference to an object with its transform.
pub struct Use {
    /// The part that has the object; `None` for this one.
    pub part: Option<String>,
    pub object: u32,
    pub matrix: DMat4,
}

#[derive(Default)]
pub struct Object {
    pub id: u32,
    pub name: String,
    pub positions: Vec<DVec3>,
    pub corners: Vec<u32>,
    pub components: Vec<Use>,
}

#[derive(Default)]
pub struct Model {
    pub unit: String,
    pub objects: Vec<Object>,
    pub items: Vec<Use>,
    /// Whether triangles or objects have colours or materials.
    pub has_properties: bool,
    /// Elements of meshes that are not read.
    pub skipped: BTreeSet<String>,
    /// Objects, components and items, those of the parts before included.
    uses: usize,
}

impl Model {
    /// Reads a part. `uses` counts the objects, components and items of all parts.
    pub fn read(package: &mut Package<'_>, part: &str, uses: &mut usize) -> Result<Self, ReadError> {
        let mut model = Self { uses: *uses, ..Self::default() };
        let mut is_in_mesh = false;
        package.elements(part, |element| match element {
            Element::Start(start) => model.start(start, &mut is_in_mesh),
            Element::End(name) => {
                if name == "mesh" {
                    is_in_mesh = false;
                }
                if name == "object" { model.check() } else { Ok(()) }
            }
        })?;
        *uses = model.uses;
        Ok(model)
    }

    fn start(&mut self, start: &BytesStart<'_>, is_in_mesh: &mut bool) -> Result<(), ReadError> {
        let name = start.local_name();
        let name = name.as_ref();
        match (name, self.objects.last_mut()) {
            ("vertex", Some(object)) if *is_in_mesh => {
                let [x, y, z] = ["x", "y", "z"].map(|axis| number(start, axis, float));
                object.positions.push(DVec3::new(x?, y?, z?));
            }
            ("triangle", Some(object)) if *is_in_mesh => {
                let [a, b, c] = ["v1", "v2", "v3"].map(|corner| number(start, corner, index));
                object.corners.extend([a?, b?, c?]);
                self.has_properties |= attribute(start, "p1").is_some();
            }
            ("component", Some(object)) => {
                object.components.push(reference(start)?);
                self.count_use()?;
            }
            ("item", _) => {
                self.items.push(reference(start)?);
                self.count_use()?;
            }
            ("object", _) => {
                let name = attribute(start, "name").unwrap_or_default().into_owned();
                self.has_properties |= attribute(start, "pid").is_some();
                self.objects.push(Object { id: number(start, "id", index)?, name, ..Object::default() });
                self.count_use()?;
            }
            ("model", _) => {
                self.unit = attribute(start, "unit").map_or("millimeter".into(), |unit| unit.into_owned());
                check_extensions(start)?;
            }
            ("mesh", _) => *is_in_mesh = true,
            ("vertices" | "triangles" | "trianglesets" | "triangleset" | "ref" | "refrange", _) => {}
            _ if *is_in_mesh && self.skipped.len() < 10 => {
                self.skipped.insert(shown(name.as_bytes()));
            }
            _ => {}
        }
        Ok(())
    }

    fn count_use(&mut self) -> Result<(), ReadError> {
        self.uses += 1;
        if self.uses <= MOST {
            return Ok(());
        }
        let found = format!("more than {MOST} objects, components and items");
        Err(error(Problem::Limit, found, "divide the model"))
    }

    /// Checks the indices of the last object.
    fn check(&self) -> Result<(), ReadError> {
        let Some(Object { id, positions, corners, .. }) = self.objects.last() else { return Ok(()) };
        let wrong = corners.iter().position(|&vertex| vertex as usize >= positions.len());
        let Some(wrong) = wrong else { return Ok(()) };
        let found = format!(
            "object {id}: triangle {}: vertex index {} is out of range ({} vertices)",
            wrong / 3,
            corners[wrong],
            positions.len()
        );
        Err(error(Problem::Range, found, ADVICE))
    }
}

fn index(token: &[u8]) -> Option<u32> {
    std::str::from_utf8(token).ok()?.parse().ok()
}

/// An attribute that has to be there.
fn number<T>(start: &BytesStart<'_>, name: &str, parse: impl Fn(&[u8]) -> Option<T>) -> Result<T, ReadError> {
    let value = attribute(start, name);
    value.as_ref().and_then(|value| parse(value.trim().as_bytes())).ok_or_else(|| {
        let element = start.local_name();
        let element = element.as_ref();
        let found = match value {
            None => format!("a `{element}` has no `{name}`"),
            Some(value) => {
                format!("`{}` is not a number: `{name}` of a `{element}`", shown(value.as_bytes()))
            }
        };
        error(Problem::Syntax, found, ADVICE)
    })
}

fn reference(start: &BytesStart<'_>) -> Result<Use, ReadError> {
    let matrix = match attribute(start, "transform") {
        None => DMat4::IDENTITY,
        Some(text) => matrix(&text).ok_or_else(|| {
            let found = format!("`{}` is not a transform of 12 numbers", shown(text.as_bytes()));
            error(Problem::Syntax, found, ADVICE)
        })?,
    };
    let part = attribute(start, "path").map(|path| path.into_owned());
    Ok(Use { part, object: number(start, "objectid", index)?, matrix })
}

/// Four rows of three numbers, by which a row vector is multiplied from the left (section 3.3 of the specification): the columns of
/// the matrix for column vectors.
fn matrix(text: &str) -> Option<DMat4> {
    let numbers: Option<Vec<f64>> = text.split_whitespace().map(|word| float(word.as_bytes())).collect();
    let numbers: [f64; 12] = numbers?.try_into().ok()?;
    let column = |k: usize, last| DVec3::from_slice(&numbers[3 * k..]).extend(last);
    let matrix = DMat4::from_cols(column(0, 0.0), column(1, 0.0), column(2, 0.0), column(3, 1.0));
    matrix.is_finite().then_some(matrix)
}

/// Refuses a file that requires an extension which may hold geometry.
fn check_extensions(start: &BytesStart<'_>) -> Result<(), ReadError> {
    let required = attribute(start, "requiredextensions").unwrap_or_default();
    for prefix in required.split_whitespace() {
        let mut all = start.attributes();
        let name = all
            .with_checks(false)
            .flatten()
            .find(|it| it.key.as_ref().strip_prefix("xmlns:") == Some(prefix));
        let name = name.map_or(Default::default(), |it| it.value);
        if !UNDERSTOOD.contains(&&*name) {
            let found = format!("the file requires the extension {prefix} ({})", shown(name.as_bytes()));
            return Err(error(Problem::Unsupported, found, "export the file without this extension"));
        }
    }
    Ok(())
}
