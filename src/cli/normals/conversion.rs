//! `--up` and `--scale`: the axes and units of a new file.

use super::args::{MeshArgs, Scale};
use crate::cli::common::choice::Choose;
use crate::cli::common::failure::Failure;
use crease::io::{Format, Note};
use crease::mesh::{AxisConversion, UpAxis};

/// How coordinates change, and a description of it for the report.
pub struct Conversion {
    pub map: AxisConversion,
    pub text: String,
}

/// The conversion that the options ask for, if any.
///
/// The options describe the file that is not glTF: `--up z --scale mm` converts from z up and millimetres to glTF, or
/// back.
///
/// # Errors
/// If the output keeps the positions of the input, or neither file has fixed axes and units.
pub fn conversion(args: &MeshArgs, from: Format, to: Format) -> Result<Option<Conversion>, Failure> {
    if args.up.is_none() && args.scale.is_none() {
        return Ok(None);
    }
    if to.edits(from) {
        return Err(Failure::usage(format!(
            "--up and --scale change positions, but {from} to {to} keeps them\n\
             help: choose another format with --to"
        )));
    }
    let needs_gltf = args.up.is_some() || matches!(args.scale, Some(Scale::Unit(_)));
    if needs_gltf && !from.is_gltf() && !to.is_gltf() {
        return Err(Failure::usage(format!(
            "{from} and {to} have no fixed up axis and no fixed unit: --up and units convert to or from glTF\n\
             help: without --up, --scale takes a factor, such as 0.001"
        )));
    }
    let up = args.up.unwrap_or_default();
    let to_y_up = AxisConversion::to_y_up(up);
    let (rotation, direction) = if from.is_gltf() { (to_y_up.inverse(), "to") } else { (to_y_up, "from") };
    let factor = match args.scale {
        None => 1.0,
        Some(Scale::Factor(factor)) => factor,
        Some(Scale::Unit(metres)) if from.is_gltf() => 1.0 / metres,
        Some(Scale::Unit(metres)) => metres,
    };
    let rotated = (up != UpAxis::Y).then(|| format!("rotated {direction} {} up", up.choice()));
    let scaled = (factor != 1.0).then(|| format!("multiplied by {factor}"));
    let text = rotated.into_iter().chain(scaled).collect::<Vec<_>>().join(", ");
    Ok(Some(Conversion { map: rotation.scaled(factor), text }))
}

/// A note if a file without fixed axes becomes glTF, which has some.
pub fn axes_note(conversion: Option<&Conversion>, from: Format, to: Format) -> Option<Note> {
    let is_open = conversion.is_none() && to.is_gltf() && !from.is_gltf();
    is_open.then(|| {
        Note::remark("coordinates are unchanged, but glTF is y-up and in metres: --up and --scale convert")
    })
}
