//! A whole scene file.

use crate::io::ReadError;
use crate::num::LinearRgb;
use crate::raster::load::scene_file::{LoadOptions, SceneFile};
use crate::raster::load::toml::lights::{LightTables, lights};
use crate::raster::load::toml::objects::{Builder, ObjectTable};
use crate::raster::load::toml::settings::{CameraTable, SettingsTable};
use crate::raster::load::toml::source::Source;
use crate::raster::settings::RenderSettings;
use serde::Deserialize;
use std::path::Path;
use toml::Spanned;

/// The tables of a scene file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Document {
    #[serde(default)]
    settings: SettingsTable,
    camera: Option<Spanned<CameraTable>>,
    #[serde(default)]
    light: LightTables,
    #[serde(default)]
    object: Vec<Spanned<ObjectTable>>,
}

impl SceneFile {
    /// A scene from the text of a TOML file that lies in the folder `base`; `docs/scenes.md` lists its keys.
    /// Meshes are looked for there, and in no place outside of it unless
    /// [`ReadOptions::root`](crate::io::ReadOptions::root) names one.
    ///
    /// ```
    /// use crease::raster::{LoadOptions, SceneFile, render};
    ///
    /// let text = "[[object]]\nsurface.sphere.radius = 1\nmaterial.colour = \"#3080c0\"\n";
    /// let file = SceneFile::from_toml(text, "".as_ref(), &LoadOptions::default())?;
    /// assert!(render(&file.scene(), &file.settings)?.statistics.covered_pixels > 0);
    ///
    /// let error = SceneFile::from_toml("[settings]\nsize = 7\n", "".as_ref(), &LoadOptions::default()).unwrap_err();
    /// assert!(error.to_string().starts_with("line 2: `settings.size`: "));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// With the line and the key: what is no TOML, unknown keys, values of the wrong type or out of range, and what is
    /// wrong with meshes that the scene names.
    pub fn from_toml(text: &str, base: &Path, options: &LoadOptions) -> Result<Self, ReadError> {
        let source = Source(text);
        let document: Document = toml::from_str(text).map_err(|error| source.syntax(&error))?;
        let mut scene = SceneFile {
            meshes: Vec::new(),
            objects: Vec::new(),
            lights: lights(source, document.light)?,
            camera: None,
            background: LinearRgb::BLACK,
            settings: RenderSettings::default(),
            notes: Vec::new(),
        };
        document.settings.apply(source, &mut scene)?;
        scene.camera = document.camera.map(|camera| CameraTable::camera(source, &camera)).transpose()?;
        let mut builder = Builder::new(source, base, options, document.settings.reflection, scene);
        document.object.into_iter().try_for_each(|object| builder.add(object))?;
        let scene = builder.finish()?;
        document.settings.check_scene(source, &scene)?;
        Ok(scene)
    }
}
