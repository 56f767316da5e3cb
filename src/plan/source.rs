//! Texts of scenes to plan: of a mesh file, of another size, and with the most accurate models.

use super::axes::LightModel;
use super::document::Document;
use crate::io::ReadError;
use crate::raster::{LoadOptions, is_scene, load, read_text};
use std::path::Path;
use toml_edit::{Array, ArrayOfTables, DocumentMut, Item, Table, TomlError, value};

/// The text of a scene file; of a mesh file, that of a scene that shows it with the camera and the lights that it has.
///
/// # Errors
/// What makes the file unreadable.
pub fn scene_text(path: &Path, options: &LoadOptions) -> Result<String, ReadError> {
    if is_scene(path) {
        return read_text(path, options);
    }
    let file = load(path, None, options)?;
    let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    let mut document = Document(DocumentMut::new());
    let mut table = Table::new();
    table.insert("mesh", value(name));
    document.0.insert("object", Item::ArrayOfTables([table].into_iter().collect()));
    if let Some(camera) = &file.camera {
        document.set_camera(camera);
    }
    if let Some(lights) = &file.lights {
        let lights: Vec<_> = lights.iter().map(|light| (LightModel(Some(*light)), String::new())).collect();
        document.set_lights(&lights, &[]);
    }
    Ok(document.to_string())
}

/// The text of a scene file with another size of its picture.
///
/// # Errors
/// What is no TOML.
pub fn with_size(text: &str, size: [u32; 2]) -> Result<String, TomlError> {
    let mut document = Document::parse(text)?;
    document.set_setting("size", size.map(i64::from).into_iter().collect::<Array>(), "");
    Ok(document.to_string())
}

/// The text of a scene file with other names of its mesh files. `rename` returns `None` for a file that the text cannot name, and the first
/// such name is the second result.
///
/// # Errors
/// What is no TOML.
pub fn with_mesh_names(
    text: &str,
    rename: &dyn Fn(&str) -> Option<String>,
) -> Result<Result<String, String>, TomlError> {
    let mut document = Document::parse(text)?.with_tables();
    for object in 0..document.objects() {
        let Some(old) = document.mesh(object).map(str::to_owned) else { continue };
        match rename(&old) {
            Some(new) => document.rename_mesh(object, &new),
            None => return Ok(Err(old)),
        }
    }
    Ok(Ok(document.to_string()))
}

/// The text of a scene file with the most accurate value of each axis that has one: Phong shading in place of Gouraud and flat shading,
/// perspective interpolation, the normals of analytic surfaces, the weight `best` for computed ones, and normals that are not rounded.
///
/// # Errors
/// What is no TOML.
pub fn most_accurate(text: &str) -> Result<String, TomlError> {
    let mut document = Document::parse(text)?.with_tables();
    if let Some(settings) = document.0.get_mut("settings").and_then(Item::as_table_mut) {
        make_accurate(settings);
    }
    let tables = document.0.get_mut("object").and_then(Item::as_array_of_tables_mut);
    for table in tables.into_iter().flat_map(ArrayOfTables::iter_mut) {
        make_accurate(table);
        let is_given = table.get("normals").and_then(Item::as_str) == Some("given");
        if table.contains_key("surface") {
            table.remove("normals");
        } else if !is_given {
            table["weight"] = value("best");
        }
    }
    Ok(document.to_string())
}

/// Removes what makes a table's models cheaper. The defaults of these keys are the accurate values, except that of the weight.
fn make_accurate(table: &mut Table) {
    for key in ["precision", "normal-format", "weight", "interpolation"] {
        table.remove(key);
    }
    if table
        .get("shading")
        .and_then(Item::as_str)
        .is_some_and(|shading| matches!(shading, "gouraud" | "flat"))
    {
        table["shading"] = value("phong");
    }
}
