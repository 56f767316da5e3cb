//! Scenes written in TOML.
//!
//! `docs/scenes.md` of the repository describes every key; `data/scenes` has annotated examples.

// The line and the key of an error.
mod source;
// Colours, reflectances, transforms, and the shapes of objects.
mod values;
// `[[light.…]]` and `material`.
mod lighting;
// `[[object]]`
mod objects;
// The whole file, `[settings]` and `[camera]`.
mod document;
