//! Scenes written in TOML.
//!
//! `data/scenes` of the repository has annotated examples; [`load`](crate::raster::load::load()) documents every key.

// The line and the key of an error.
mod source;
// Colours, reflectances and transforms.
mod values;
// `[settings]` and `[camera]`.
mod settings;
// `[[light.…]]`
mod lights;
// `material`
mod material;
// The shape of an object: `polygons` and `surface`.
mod shapes;
// `[[object]]`
mod objects;
// The whole file.
mod document;
