//! The text of a scene file, and the changes of a plan to it. Everything else of the text stays as it is.

use super::axes::{Axis, LightModel, ObjectModel, Source, Terms};
use crate::num::{Degrees, LinearRgb};
use crate::raster::{Camera, Projection, Shading};
use crate::shade::{AreaShape, Attenuation, Light, Material, Reflection, blinn_exponent};
use crate::surface::Tessellation;
use glam::DVec3;
use toml_edit::{Array, ArrayOfTables, DocumentMut, InlineTable, Item, Table, TomlError, Value, value};

/// A scene file that can be changed.
#[derive(Clone, Debug)]
pub struct Document(pub(super) DocumentMut);

/// The kinds of lights, as their tables are called.
const KINDS: [&str; 6] = ["ambient", "directional", "point", "spot", "rectangle", "disc"];

impl Document {
    /// From the text of a scene file.
    ///
    /// # Errors
    /// What is no TOML.
    pub fn parse(text: &str) -> Result<Self, TomlError> {
        text.parse().map(Self)
    }

    /// The number of `[[object]]` tables.
    pub fn objects(&self) -> usize {
        self.0.get("object").map_or(0, |item| match item {
            Item::ArrayOfTables(tables) => tables.len(),
            Item::Value(Value::Array(list)) => list.len(),
            _ => 0,
        })
    }

    /// The cells of the tessellation of an object.
    pub fn segments(&self, object: usize) -> Option<[u32; 2]> {
        let tessellation = self.table(object)?.get("tessellation")?;
        let Some(list) = tessellation.get("segments") else { return Some(Tessellation::default().segments) };
        let numbers: Vec<u32> =
            list.as_array()?.iter().filter_map(|n| u32::try_from(n.as_integer()?).ok()).collect();
        numbers.try_into().ok()
    }

    /// Whether an object has the default tessellation, with any number of cells.
    pub fn has_regular_cells(&self, object: usize) -> bool {
        let tessellation = self.table(object).and_then(|table| table.get("tessellation")?.as_table_like());
        tessellation.is_some_and(|table| table.iter().all(|(key, _)| key == "segments"))
    }

    /// The name of the mesh file of an object.
    pub fn mesh(&self, object: usize) -> Option<&str> {
        self.table(object)?.get("mesh")?.as_str()
    }

    /// Names the mesh file of an object anew; comments on its line stay.
    pub fn rename_mesh(&mut self, object: usize, name: &str) {
        let tables = self.0.get_mut("object").and_then(Item::as_array_of_tables_mut);
        let table = tables.and_then(|tables| tables.get_mut(object));
        if let Some(old) = table.and_then(|table| table.get_mut("mesh")).and_then(Item::as_value_mut) {
            let decor = old.decor().clone();
            *old = Value::from(name);
            *old.decor_mut() = decor;
        }
    }

    /// Removes a key of an object.
    pub fn remove(&mut self, object: usize, key: &str) {
        let tables = self.0.get_mut("object").and_then(Item::as_array_of_tables_mut);
        tables.and_then(|tables| tables.get_mut(object)).and_then(|table| table.remove(key));
    }

    fn table(&self, object: usize) -> Option<&Table> {
        self.0.get("object")?.as_array_of_tables()?.get(object)
    }

    /// The scene with this object alone.
    #[must_use]
    pub fn only(&self, object: usize) -> Self {
        let mut document = self.0.clone();
        let mut tables = ArrayOfTables::new();
        tables.extend(self.table(object).cloned());
        document.insert("object", Item::ArrayOfTables(tables));
        Self(document)
    }

    /// Makes `[[object]]` tables of objects that are written in a list of inline tables, so that they can be changed.
    pub fn with_tables(mut self) -> Self {
        if let Some(Item::Value(Value::Array(list))) = self.0.get("object") {
            let tables = list.iter().filter_map(|value| value.as_inline_table().cloned());
            let tables: ArrayOfTables = tables.map(InlineTable::into_table).collect();
            self.0.insert("object", Item::ArrayOfTables(tables));
        }
        self
    }

    /// Sets a key of an object, with a comment at the end of its line.
    pub fn set(&mut self, object: usize, key: &str, new: impl Into<Value>, comment: &str) {
        let tables = self.0.get_mut("object").and_then(Item::as_array_of_tables_mut);
        let Some(table) = tables.and_then(|tables| tables.get_mut(object)) else { return };
        table.insert(key, Item::Value(commented(new, comment)));
    }

    /// Sets a key of `[settings]`, with a comment at the end of its line.
    pub fn set_setting(&mut self, key: &str, new: impl Into<Value>, comment: &str) {
        if self.0.get("settings").is_none() {
            self.0.insert("settings", Item::Table(Table::new()));
        }
        self.0["settings"][key] = Item::Value(commented(new, comment));
    }

    /// Writes an object's model, where it differs from that of the reference. `comment` gives the reason for a change.
    pub fn apply(
        &mut self,
        object: usize,
        model: &ObjectModel,
        reference: &ObjectModel,
        material: Option<&Material>,
        comment: &dyn Fn(Axis) -> String,
    ) {
        let mut set = |axis: Axis, key: &str, new: Value| self.set(object, key, new, &comment(axis));
        if model.shading != reference.shading {
            let name = match model.shading {
                Shading::Flat => "flat",
                Shading::Gouraud => "gouraud",
                _ => "phong",
            };
            set(Axis::Shading, "shading", name.into());
        }
        if model.interpolation != reference.interpolation {
            set(Axis::Interpolation, "interpolation", model.interpolation.name().into());
        }
        if model.two_sided != reference.two_sided {
            set(Axis::TwoSided, "two-sided", model.two_sided.into());
        }
        if let (Some(normals), Some(old)) = (&model.normals, &reference.normals) {
            if let (Source::Computed(weight), true) = (normals.source, normals.source != old.source) {
                set(Axis::Weight, "weight", weight.name().into());
            }
            if normals.creases != old.creases {
                set(Axis::Creases, "crease", "none".into());
            }
            if normals.precision != old.precision {
                set(Axis::Precision, "precision", normals.precision.name().into());
            }
            if let (Some(format), true) = (normals.format, normals.format != old.format) {
                set(Axis::Storage, "normal-format", format.name().into());
            }
        }
        if model.merged != reference.merged {
            set(Axis::Merging, "merge", if model.merged { "exact" } else { "off" }.into());
        }
        if model.terms != reference.terms
            && let Some(material) = material
        {
            set(Axis::Reflection, "material", material_table(&with_terms(material, model.terms)).into());
        }
        if let (Some(segments), true) = (model.segments, model.segments != reference.segments) {
            self.set_segments(object, segments, &comment(Axis::Tessellation));
        }
    }

    /// Sets the cells of a tessellation, and keeps its other keys.
    fn set_segments(&mut self, object: usize, segments: [u32; 2], comment: &str) {
        let list = Value::from(segments.map(i64::from).into_iter().collect::<Array>());
        let tables = self.0.get_mut("object").and_then(Item::as_array_of_tables_mut);
        let Some(table) = tables.and_then(|tables| tables.get_mut(object)) else { return };
        let tessellation = table.get_mut("tessellation").and_then(Item::as_table_like_mut);
        match tessellation {
            Some(tessellation) => drop(tessellation.insert("segments", Item::Value(list))),
            None => drop(table.insert("tessellation", value(InlineTable::from_iter([("segments", list)])))),
        }
        if let Some(Item::Value(tessellation)) = table.get_mut("tessellation") {
            tessellation.decor_mut().set_suffix(format!(" # {comment}"));
        }
    }

    /// Replaces all lights, each with the comment of its table, and marks those to keep. A file without lights has default ones, so black
    /// ambient light is written if all are omitted.
    pub fn set_lights(&mut self, lights: &[(LightModel, String)], kept: &[usize]) {
        let mut all = Table::new();
        all.set_implicit(true);
        let black = [(LightModel(Some(Light::Ambient { colour: LinearRgb::default() })), String::new())];
        let stays_lit = lights.iter().any(|(light, _)| light.0.is_some());
        let old = self.light_tables();
        let old = |number: usize| if stays_lit && old.len() == lights.len() { old.get(number) } else { None };
        let lights = if stays_lit { lights } else { &black };
        for kind in KINDS {
            let of_kind = lights.iter().enumerate().filter_map(|(number, (light, comment))| {
                let light = light.0.as_ref().filter(|light| light.kind() == kind)?;
                let prefix = old(number).and_then(|table| table.decor().prefix()?.as_str()).unwrap_or("\n");
                let mut table = match old(number) {
                    Some(unchanged) if comment.is_empty() => unchanged.clone(),
                    _ => light_table(light),
                };
                if kept.contains(&number) {
                    table.insert("plan", value("keep"));
                }
                // The order of lights, which their sum is formed in.
                table.set_position(Some(isize::try_from(1000 + number).unwrap_or(isize::MAX)));
                let reason = if comment.is_empty() { String::new() } else { format!("# {comment}\n") };
                table.decor_mut().set_prefix(format!("{prefix}{reason}"));
                Some(table)
            });
            let tables: ArrayOfTables = of_kind.collect();
            if !tables.is_empty() {
                all.insert(kind, Item::ArrayOfTables(tables));
            }
        }
        self.0.insert("light", Item::Table(all));
    }

    /// The tables of lights in the order of the text.
    fn light_tables(&self) -> Vec<Table> {
        let of_kind = |kind: &&str| self.0.get("light")?.get(kind)?.as_array_of_tables();
        let mut tables: Vec<&Table> = KINDS.iter().filter_map(of_kind).flatten().collect();
        tables.sort_by_key(|table| table.position());
        tables.into_iter().cloned().collect()
    }

    /// Sets the camera.
    pub fn set_camera(&mut self, camera: &Camera) {
        let mut table = Table::new();
        for (key, vector) in [("eye", camera.eye), ("target", camera.target), ("up", camera.up)] {
            table.insert(key, value(list(vector)));
        }
        match camera.projection {
            Projection::Perspective(angle) => table.insert("angle", value(Degrees::from(angle).0)),
            Projection::Orthographic(height) => table.insert("height", value(height)),
        };
        table.insert("near", value(camera.near));
        self.0.insert("camera", Item::Table(table));
    }

    /// Writes a comment before everything else.
    pub fn set_head(&mut self, comment: &str) {
        let lines: String = comment.lines().map(|line| format!("# {line}\n")).collect();
        let decor = self.0.decor_mut();
        let old = decor.prefix().and_then(|prefix| prefix.as_str()).unwrap_or_default().to_owned();
        decor.set_prefix(format!("{lines}{old}"));
    }
}

/// A value with a comment at the end of its line.
fn commented(new: impl Into<Value>, comment: &str) -> Value {
    let mut new: Value = new.into();
    if !comment.is_empty() {
        new.decor_mut().set_suffix(format!(" # {comment}"));
    }
    new
}

impl std::fmt::Display for Document {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        self.0.fmt(f)
    }
}

/// A material with some of its terms.
pub fn with_terms(material: &Material, terms: Terms) -> Material {
    use crate::shade::Reflectance;
    match terms {
        Terms::Declared => *material,
        Terms::Blinn => Material {
            reflection: Reflection::Blinn,
            exponent: blinn_exponent(material.exponent),
            ..*material
        },
        Terms::Diffuse => Material { specular: Reflectance::NONE, ..*material },
        Terms::Ambient => Material { diffuse: Reflectance::NONE, specular: Reflectance::NONE, ..*material },
    }
}

fn list(vector: DVec3) -> Array {
    vector.to_array().into_iter().collect()
}

fn colour(colour: LinearRgb) -> Array {
    colour.to_array().into_iter().collect()
}

fn material_table(material: &Material) -> InlineTable {
    let mut table = InlineTable::new();
    let reflectances =
        [("ambient", material.ambient), ("diffuse", material.diffuse), ("specular", material.specular)];
    for (key, reflectance) in reflectances {
        table.insert(key, colour(reflectance.merged()).into());
    }
    table.insert("exponent", material.exponent.into());
    let is_blinn = material.reflection == Reflection::Blinn;
    table.insert("reflection", if is_blinn { "blinn" } else { "phong" }.into());
    table
}

fn light_table(light: &Light) -> Table {
    let mut table = Table::new();
    let mut add = |key: &str, new: Value| drop(table.insert(key, Item::Value(new)));
    match *light {
        Light::Ambient { .. } => {}
        Light::Directional { towards, .. } => add("towards", list(towards).into()),
        Light::Point { position, attenuation, .. } => {
            add("position", list(position).into());
            add("attenuation", attenuation_value(attenuation));
        }
        Light::Spot { position, attenuation, cone, .. } => {
            add("position", list(position).into());
            add("axis", list(cone.axis).into());
            add("attenuation", attenuation_value(attenuation));
            add("cut-off", degrees(cone.cut_off.0));
            add("soft-edge", degrees(cone.soft_edge.0));
            add("exponent", cone.exponent.into());
        }
        Light::Area { shape: AreaShape::Rectangle { centre, u, v }, .. } => {
            add("centre", list(centre).into());
            add("u", list(u).into());
            add("v", list(v).into());
        }
        Light::Area { shape: AreaShape::Disc { centre, normal, radius }, .. } => {
            add("centre", list(centre).into());
            add("normal", list(normal).into());
            add("radius", radius.into());
        }
    }
    add("colour", colour(light.colour()).into());
    table
}

fn degrees(radians: f64) -> Value {
    Degrees::from(crate::num::Radians(radians)).0.into()
}

fn attenuation_value(attenuation: Attenuation) -> Value {
    let of = |key: &str, inner: Value| InlineTable::from_iter([(key, inner)]).into();
    match attenuation {
        Attenuation::None => "none".into(),
        Attenuation::InverseSquare => "inverse-square".into(),
        Attenuation::InverseSquareWithin(range) => of("inverse-square-within", range.into()),
        Attenuation::Offset(k) => of("offset", k.into()),
        Attenuation::Quadratic(coefficients) => {
            of("quadratic", Value::Array(coefficients.into_iter().collect()))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan::with_size;

    #[test]
    fn a_size_goes_into_the_settings() {
        let object = "[[object]]\nsurface = { sphere = { radius = 1 } }\n";
        let text = with_size(object, [4, 3]).unwrap();
        assert!(text.contains("[settings]\nsize = [4, 3]\n"), "{text}");
        let text = format!("[settings] # pictures\nshading = \"flat\"\n{object}");
        let expected = text.replace("\"flat\"\n", "\"flat\"\nsize = [4, 3]\n");
        assert_eq!(with_size(&text, [4, 3]).unwrap(), expected);
    }

    /// Comments stay, and lights that do not change stay as they are written.
    #[test]
    fn lights_keep_their_comments_and_their_order() {
        let text = "# the sun\n[[light.directional]]\ntowards = [0, 2, 0] # up\n\n# a lamp\n[[light.point]]\nposition = [0, 9, 0]\n\
                    [[light.directional]] # sky\ntowards = [1, 0, 0]\n[[object]]\nsurface.sphere.radius = 1\n";
        let mut document = Document::parse(text).unwrap();
        let sun = |towards| LightModel(Some(Light::Directional { towards, colour: LinearRgb::WHITE }));
        let lights = [
            (sun(2.0 * DVec3::Y), String::new()),
            (sun(9.0 * DVec3::Y), "plan: nearer".to_owned()),
            (sun(DVec3::X), String::new()),
        ];
        document.set_lights(&lights, &[]);
        let changed = document.to_string();
        let places = [
            "# the sun\n[[light.dir",
            "[0, 2, 0] # up",
            "# a lamp\n# plan: nearer\n[[light.dir",
            "# sky\ntow",
        ];
        let places = places.map(|part| changed.find(part).unwrap_or_else(|| panic!("{part}: {changed}")));
        assert!(places.is_sorted(), "{changed}");
    }
}
