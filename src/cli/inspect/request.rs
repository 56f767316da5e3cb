//! Options of `crease inspect` made into a list of inputs.

use super::args::{InspectArgs, PictureArgs};
use crate::cli::common::failure::Failure;
use crate::cli::common::input::{Source, check_root, expand};
use crate::cli::common::output::{Target, is_same_file, resolve_parent};
use std::path::Path;

pub fn sources(args: &InspectArgs) -> Result<Vec<Source>, Failure> {
    check_root(args.root.as_ref())?;
    let found = expand(&args.inputs, args.recursive, None)?;
    let options = [
        ("--html", args.pictures.html.is_some()),
        ("--heatmap", args.pictures.heatmap.is_some()),
        ("--against", args.against.is_some()),
    ];
    if let Some((option, _)) = options.iter().find(|(_, is_given)| *is_given && found.len() > 1) {
        return Err(Failure::usage(format!(
            "{option} takes one input, not {}\nhelp: inspect one file at a time",
            found.len()
        )));
    }
    let sources: Vec<Source> = found.into_iter().map(|input| input.source).collect();
    if args.against.as_deref().map(Source::of) == Some(Source::Standard)
        && sources.contains(&Source::Standard)
    {
        return Err(Failure::usage("standard input can be read only once\nhelp: name one of the two files"));
    }
    check_outputs(&sources, args).map_err(Failure::usage)?;
    Ok(sources)
}

/// No picture may be written over an input, nor over the other picture.
fn check_outputs(sources: &[Source], args: &InspectArgs) -> Result<(), String> {
    let inputs: Vec<&Path> = sources.iter().filter_map(Source::path).chain(args.against.as_deref()).collect();
    let PictureArgs { html, heatmap, .. } = &args.pictures;
    let is_file = |path: &Path| Target::of(path) != Target::Standard;
    for output in [html, heatmap].into_iter().flatten().filter(|path| is_file(path)) {
        if let Some(input) = inputs.iter().find(|input| is_same_file(input, output)) {
            return Err(format!(
                "this would overwrite the input {}\nhelp: name another output",
                input.display()
            ));
        }
    }
    let is_png = |path: &Path| path.extension().is_some_and(|name| name.eq_ignore_ascii_case("png"));
    match (html, heatmap) {
        (Some(html), Some(heatmap)) if resolve_parent(html) == resolve_parent(heatmap) => Err(format!(
            "--html and --heatmap would both be written to {}\nhelp: name two outputs",
            html.display()
        )),
        (_, Some(path)) if is_file(path) && !is_png(path) => {
            Err(format!("--heatmap writes a PNG, not {}\nhelp: use a name that ends in .png", path.display()))
        }
        _ => Ok(()),
    }
}
