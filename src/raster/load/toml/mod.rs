//! Scenes written in TOML.
//!
//! `docs/scenes.md` of the repository describes every key; `data/scenes` has annotated examples.

// The line and the key of an error.
mod source;
// Colours, reflectances and transforms.
mod values;
// `[[light.…]]` and `material`.
mod lighting;
// The shape of an object: `polygons` and `surface`.
mod shapes;
// `[[object]]`
mod objects;
// The whole file, `[settings]` and `[camera]`.
mod document;
