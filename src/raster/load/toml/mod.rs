//! Scenes written in TOML.
//!
//! `data/scenes` of the repository has annotated examples; [`load`](crate::raster::load::load()) documents every key.

mod keys;
mod lights;
mod material;
mod objects;
mod place;
mod settings;
mod surfaces;
mod values;

use crate::io::ReadError;
use crate::num::LinearRgb;
use crate::raster::load::{LoadOptions, SceneFile};
use crate::raster::settings::RenderSettings;
use keys::SceneKeys;
use objects::Builder;
use place::Source;
use std::path::Path;
use toml::Spanned;

impl SceneFile {
    /// A scene from the text of a TOML file that lies in the folder `base`; [`load`](crate::raster::load()) lists its keys.
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
        let keys: SceneKeys = toml::from_str(text).map_err(|error| source.syntax(&error))?;
        let mut scene = SceneFile {
            meshes: Vec::new(),
            objects: Vec::new(),
            lights: lights::lights(source, &keys.light)?,
            camera: None,
            background: LinearRgb::BLACK,
            settings: RenderSettings::default(),
            notes: Vec::new(),
        };
        let colouring = settings::apply(source, &keys.settings, &mut scene)?;
        scene.camera = keys.camera.map(|camera| settings::camera(source, &camera)).transpose()?;
        let mut builder = Builder::new(source, base, options, colouring, scene);
        keys.object.into_iter().try_for_each(|object| builder.add(object))?;
        let scene = builder.finish()?;
        settings::check_exact(source, &keys.settings, &scene)?;
        settings::check_depth_cue(source, &keys.settings, &scene)?;
        Ok(scene)
    }
}

/// The value that a name stands for.
fn choose<T: Copy>(source: Source, name: &Spanned<String>, choices: &[(&str, T)]) -> Result<T, ReadError> {
    let chosen = choices.iter().find(|(choice, _)| choice == name.get_ref());
    chosen.map(|&(_, value)| value).ok_or_else(|| {
        let names: Vec<&str> = choices.iter().map(|&(name, _)| name).collect();
        source.error(
            &name.span(),
            &format!("no `{}` here", name.get_ref()),
            &format!("it may be {}", names.join(", ")),
        )
    })
}
