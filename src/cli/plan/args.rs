//! The options of `crease plan`.

use crate::cli::common::choice::{choices, one_of};
use crate::cli::common::options::{RunArgs, not_negative};
use crate::cli::render::values::size;
use clap::Args;
use crease::plan::{Axis, Minimise};
use std::path::{Path, PathBuf};

#[derive(Args)]
pub struct PlanArgs {
    #[arg(value_name = "SCENE", required_unless_present = "explain")]
    pub input: Option<PathBuf>,
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    #[arg(long, value_name = "STEPS", default_value = "2", value_parser = not_negative, allow_negative_numbers = true)]
    pub tolerance: f64,
    #[arg(long, value_name = "SHARE", default_value = "0", value_parser = share)]
    pub share: f64,
    #[arg(long, value_name = "PIXELS", default_value = "0.5", value_parser = not_negative, allow_negative_numbers = true)]
    pub outline: f64,
    #[arg(long, value_name = "FILE|DIR")]
    pub apply: Option<PathBuf>,
    #[arg(long, value_name = "WHAT", value_parser = one_of::<Minimise>())]
    minimise: Option<Minimise>,
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub views: Option<u32>,
    #[arg(long, value_name = "WIDTHxHEIGHT", value_parser = size)]
    pub size: Option<[u32; 2]>,
    #[arg(long, value_name = "AXIS,AXIS", value_parser = one_of::<Axis>(), value_delimiter = ',')]
    pub keep: Vec<Axis>,
    #[arg(long, value_name = "AXIS,AXIS", value_parser = one_of::<Axis>(), value_delimiter = ',', conflicts_with = "keep")]
    pub only: Vec<Axis>,
    #[arg(long, value_name = "PIXELS", default_value = "10000000000")]
    pub budget: u64,
    #[arg(long)]
    pub explain: bool,

    #[command(flatten)]
    pub run: RunArgs,
}

choices! { Minimise: "work" => Work, "bytes" => Bytes, "vertices" => Vertices }

choices! { Axis:
    "shading" => Shading, "weight" => Weight, "creases" => Creases, "precision" => Precision,
    "storage" => Storage, "interpolation" => Interpolation, "reflection" => Reflection,
    "tessellation" => Tessellation, "two-sided" => TwoSided, "lights" => Lights,
}

impl PlanArgs {
    /// The scene; empty if an explanation is asked for.
    pub fn scene(&self) -> &Path {
        self.input.as_deref().unwrap_or(Path::new(""))
    }

    /// The quantity to minimise: of files, their bytes.
    pub fn minimise(&self) -> Minimise {
        let default = if self.apply.is_some() { Minimise::Bytes } else { Minimise::Work };
        self.minimise.unwrap_or(default)
    }

    /// The axes that stay as declared.
    pub fn kept(&self) -> Vec<Axis> {
        match &self.only[..] {
            [] => self.keep.clone(),
            only => Axis::ALL.into_iter().filter(|axis| !only.contains(axis)).collect(),
        }
    }
}

fn share(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(share) if (0.0..=1.0).contains(&share) => Ok(share),
        _ => Err("a share from 0 to 1 was expected".into()),
    }
}
