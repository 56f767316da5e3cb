//! Options made into jobs. All errors of the command line are found here, before anything is read or written.

use super::args::{HardEdge, Merging, NormalsArgs, RecipeArgs};
use crate::cli::common::failure::Failure;
use crate::cli::common::input::{Input, Source, expand};
use crate::cli::common::output::{Target, is_same_file};
use crate::cli::common::output_conflicts::Files;
use crate::cli::common::stream::file_target;
use crate::cli::line_options::with_line;
use crease::io::{Emit, Format, Merge, ReadOptions, WriteOptions};
use crease::normals::{Crease, HardEdges, NormalRecipe, Scope};
use crease::pipeline::Task;
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::path::PathBuf;
use std::sync::Arc;

#[derive(Clone, Debug)]
pub struct Job {
    pub input: Input,
    /// The input's format as typed; `None`: by its content, else by its name.
    pub format: Option<Format>,
    /// The output; `None` if nothing is written.
    pub target: Option<Target>,
    /// The output's format; `None`: that of the input.
    pub to: Option<Format>,
    /// Face normals go into the JSON report.
    pub rows: bool,
    pub settings: Arc<Settings>,
}

/// What options ask for. A line of a manifest may have options of its own.
#[derive(Debug)]
pub struct Settings {
    pub args: NormalsArgs,
    pub task: Task,
    pub read: ReadOptions,
    pub write: WriteOptions,
    /// Vertices move to others that are closer than this fraction of the diagonal.
    pub merge_distance: Option<f64>,
    /// Face normals go into the JSON report, unless a manifest names an output.
    pub rows: bool,
}

/// The jobs of a command line, whose options are checked, also against existing files.
pub fn jobs(args: &NormalsArgs) -> Result<Vec<Job>, Failure> {
    jobs_of(args, || {
        let search = || expand(&args.inputs, args.output.recursive, args.output.out_dir.as_deref());
        args.batch.inputs(search)
    })
}

/// The jobs of inputs.
pub fn jobs_of(
    args: &NormalsArgs,
    inputs: impl FnOnce() -> Result<Vec<Input>, Failure>,
) -> Result<Vec<Job>, Failure> {
    let settings = Arc::new(Settings::new(args.clone()));
    // A manifest may name its outputs.
    if !has_destination(args) && !settings.rows && !args.output.dry_run && args.batch.manifest.is_none() {
        return usage(
            "one of --output, --out-dir and --in-place is required\nhelp: --dry-run and --emit face --json need none",
        );
    }
    args.output.companions.check().map_err(Failure::usage)?;
    let found = inputs()?;
    if args.output.output.is_some() && found.len() > 1 {
        return usage(format!(
            "--output takes one input, not {}\nhelp: --out-dir takes several",
            found.len()
        ));
    }
    let mut of_lines = BTreeMap::from([(&[][..], settings)]);
    let mut jobs = Vec::with_capacity(found.len());
    for input in &found {
        let settings = match of_lines.entry(&input.options) {
            Entry::Occupied(known) => known.get().clone(),
            Entry::Vacant(free) => free.insert(Arc::new(Settings::new(with_line("normals", input)?))).clone(),
        };
        jobs.push(job(input, settings).map_err(|failure| input.refused(failure))?);
    }
    check_outputs(&jobs, args.output.in_place).map_err(Failure::usage)?;
    jobs.retain(|job| args.batch.takes(&job.input.source));
    Ok(jobs)
}

impl Settings {
    fn new(args: NormalsArgs) -> Self {
        Self {
            task: task(&args),
            read: args.output.companions.read_options(args.mesh.force),
            write: WriteOptions {
                emit: args.normals.emit,
                tangents: args.gltf.tangents,
                normal_format: args.gltf.normal_format,
                material: args.gltf.material,
                compression: args.gltf.compress,
                merge: match args.mesh.merge {
                    None => Merge::FacetWise,
                    Some(Merging::Off) => Merge::Off,
                    Some(Merging::Exact | Merging::Near(_)) => Merge::Exact,
                },
                ..WriteOptions::default()
            },
            merge_distance: match args.mesh.merge {
                Some(Merging::Near(fraction)) => Some(fraction),
                _ => None,
            },
            rows: args.normals.emit == Emit::Face && args.run.json && !has_destination(&args),
            args,
        }
    }
}

fn usage<T>(message: impl ToString) -> Result<T, Failure> {
    Err(Failure::usage(message))
}

fn has_destination(args: &NormalsArgs) -> bool {
    let output = &args.output;
    output.output.is_some() || output.out_dir.is_some() || output.in_place
}

fn task(args: &NormalsArgs) -> Task {
    let RecipeArgs { weight, crease, crease_rule, groups, weld, slivers, precision, .. } = args.normals;
    let hard = |kind| args.normals.hard_edges.contains(&kind);
    Task {
        recipe: NormalRecipe {
            weight,
            crease: crease.map_or(Crease::Default, Crease::Angle),
            rule: crease_rule,
            groups,
            hard_edges: HardEdges {
                uv: hard(HardEdge::Uv),
                material: hard(HardEdge::Material),
                authored: hard(HardEdge::Authored),
            },
            weld,
            slivers,
            precision,
            scope: if args.normals.emit == Emit::Vertex { Scope::Vertex } else { Scope::Corner },
        },
        emit: args.normals.emit,
        when: args.normals.when,
        orient: args.mesh.orient,
        confidence: args.mesh.confidence,
        flip: args.mesh.flip,
        degenerate: args.mesh.degenerate,
        edge_counts: args.run.json || args.run.verbose,
    }
}

fn job(input: &Input, settings: Arc<Settings>) -> Result<Job, Failure> {
    let args = &settings.args;
    let output = &args.output;
    let format = output.format.or_else(|| Format::from_path(input.source.path()?));
    let named = input.output.as_ref().or(output.output.as_ref());
    let (target, to) = if let Some(path) = named {
        let (target, to) = file_target(path, output.to).map_err(Failure::usage)?;
        (Some(target), to)
    } else if let Some(folder) = &output.out_dir {
        // 3MF is not written.
        let to = output.to.or((format == Some(Format::ThreeMf)).then_some(Format::Glb));
        let place = folder_place(input, format, to)?;
        (Some(Target::File(folder.join(place))), to)
    } else if output.in_place {
        (Some(in_place_target(input, format, output.to)?), output.to)
    } else if args.batch.manifest.is_some() && !output.dry_run {
        return usage(format!(
            "no output for {}\nhelp: give --out-dir or --in-place, or name an `output` in the manifest",
            input.source.name()
        ));
    } else {
        (None, output.to)
    };
    let writes = target.is_some() || output.dry_run;
    if args.normals.emit == Emit::Face && writes {
        match to.or(format) {
            None | Some(Format::Ply | Format::Stl) => {}
            Some(_) if target.is_none() && args.run.json => {}
            Some(other) => {
                return usage(format!(
                    "--emit face writes ply or stl, not {other}\nhelp: choose one with --to, or use --json without an output"
                ));
            }
        }
    }
    let rows = settings.rows && target.is_none();
    Ok(Job { input: input.clone(), format: output.format, target, to, rows, settings })
}

fn folder_place(input: &Input, format: Option<Format>, to: Option<Format>) -> Result<PathBuf, Failure> {
    if input.source == Source::Standard {
        return usage("standard input has no name to use in --out-dir\nhelp: name the output with --output");
    }
    Ok(match to {
        Some(to) if format != Some(to) || Format::from_path(&input.place) != Some(to) => {
            input.place.with_extension(to.extension())
        }
        _ => input.place.clone(),
    })
}

fn in_place_target(input: &Input, format: Option<Format>, to: Option<Format>) -> Result<Target, Failure> {
    let Source::File(path) = &input.source else {
        return usage(
            "standard input cannot be replaced in place\nhelp: --output - writes to standard output",
        );
    };
    match (format, to) {
        (Some(format), Some(to)) if format != to => usage(format!(
            "--in-place cannot convert {} from {format} to {to}\nhelp: name an output with -o or --out-dir",
            path.display()
        )),
        (None, Some(_)) => {
            usage(format!("unknown format of {}\nhelp: name it with --format", path.display()))
        }
        _ => Ok(Target::File(path.clone())),
    }
}

/// No two outputs may be one file, and none may be an input unless that is what was asked for.
fn check_outputs(jobs: &[Job], in_place: bool) -> Result<(), String> {
    let mut files = Files::read(jobs.iter().filter_map(|job| job.input.source.path()));
    for job in jobs {
        let (Some(Target::File(target)), Source::File(source)) = (&job.target, &job.input.source) else {
            continue;
        };
        files.write(target, source.display().to_string())?;
        if !(in_place && is_same_file(source, target)) {
            files.check(target).map_err(|why| format!("{why}, or use --in-place"))?;
        }
    }
    Ok(())
}
