//! The options of `crease plan`.

use crate::cli::common::choice::{choices, one_of};
use crate::cli::common::options::{RunArgs, at_most, not_negative};
use crate::cli::render::values::size;
use clap::Args;
use crease::artefact::Language;
use crease::num::Degrees;
use crease::plan::{Axis, Metric, Minimise, PlanOptions};
use std::path::{Path, PathBuf};

#[derive(Args)]
pub struct PlanArgs {
    #[arg(value_name = "SCENE", required_unless_present = "explain")]
    pub input: Option<PathBuf>,
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    #[arg(long, value_name = "STEPS", value_parser = not_negative, allow_negative_numbers = true)]
    pub tolerance: Option<f64>,
    #[arg(long, value_name = "METRIC", default_value = "steps", value_parser = one_of::<Metric>())]
    pub metric: Metric,
    #[arg(long, value_name = "MODEL", default_value = "declared", value_parser = one_of::<Reference>())]
    pub reference: Reference,
    #[arg(long, value_name = "SHARE", value_parser = at_most(1.0), allow_negative_numbers = true)]
    pub share: Option<f64>,
    #[arg(long, value_name = "PIXELS", value_parser = not_negative, allow_negative_numbers = true)]
    pub outline: Option<f64>,
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
    #[arg(long, value_name = "DEG", value_parser = at_most(180.0), allow_negative_numbers = true)]
    pub light_cone: Option<f64>,
    #[arg(long, value_name = "WHAT", value_parser = one_of::<Permission>())]
    pub allow: Option<Permission>,
    #[arg(long, value_name = "PIXELS", default_value = "1000000000")]
    pub budget: u64,
    #[arg(long, value_name = "S", value_parser = at_most(1e9), allow_negative_numbers = true)]
    pub seconds: Option<f64>,
    #[arg(long, value_name = "FILE")]
    pub html: Option<PathBuf>,
    #[arg(long, value_name = "FILE")]
    pub picture: Option<PathBuf>,
    #[arg(long, value_name = "LANG", default_value = "en", value_parser = one_of::<Language>())]
    pub lang: Language,
    #[arg(long)]
    pub explain: bool,

    #[command(flatten)]
    pub run: RunArgs,
}

choices! { Minimise: "work" => Work, "bytes" => Bytes, "vertices" => Vertices }

/// What pictures are compared with.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Reference {
    #[default]
    Declared,
    Accurate,
}

/// What changes whole pictures, and must be allowed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Permission {
    Antialiasing,
}

choices! { Permission: "antialiasing" => Antialiasing }

choices! { Reference: "declared" => Declared, "accurate" => Accurate }

choices! { Metric: "steps" => Steps, "flip" => Flip }

choices! { Axis:
    "shading" => Shading, "weight" => Weight, "creases" => Creases, "precision" => Precision,
    "storage" => Storage, "merging" => Merging, "interpolation" => Interpolation, "reflection" => Reflection,
    "tessellation" => Tessellation, "two-sided" => TwoSided, "lights" => Lights,
}

impl PlanArgs {
    /// The scene; empty if an explanation is asked for.
    pub fn scene(&self) -> &Path {
        self.input.as_deref().unwrap_or(Path::new(""))
    }

    /// The files to write.
    pub fn files(&self) -> impl Iterator<Item = &PathBuf> {
        [&self.output, &self.html, &self.picture].into_iter().flatten()
    }

    /// The tolerance of the metric: 2 steps or a mean ꟻLIP of 0.01, if none is given.
    pub fn tolerance(&self) -> f64 {
        self.tolerance.unwrap_or(match self.metric {
            Metric::Steps => 2.0,
            Metric::Flip => 0.01,
        })
    }

    /// What the library plans with.
    ///
    /// # Errors
    /// Options that do not go together.
    pub fn options(&self) -> Result<PlanOptions, String> {
        let default = PlanOptions::default();
        if self.metric == Metric::Flip {
            let unused = [("--share", self.share.is_some()), ("--outline", self.outline.is_some())];
            if let Some((name, _)) = unused.into_iter().find(|(_, is_given)| *is_given) {
                return Err(format!(
                    "{name} does not apply to --metric flip\nhelp: ꟻLIP compares whole pictures; omit {name}"
                ));
            }
        }
        Ok(PlanOptions {
            metric: self.metric,
            tolerance: self.tolerance(),
            share: self.share.unwrap_or(default.share),
            outline: self.outline.unwrap_or(default.outline),
            minimise: self.minimise(),
            views: self.views,
            light_cone: Degrees(self.light_cone.unwrap_or(0.0)),
            keep: self.kept(),
            allow_antialiasing: self.allow == Some(Permission::Antialiasing),
            budget: self.budget,
            seconds: self.seconds,
            for_files: self.apply.is_some(),
        })
    }

    /// The quantity to minimise: of files, their bytes.
    pub fn minimise(&self) -> Minimise {
        let default = if self.apply.is_some() { Minimise::Bytes } else { Minimise::Work };
        self.minimise.unwrap_or(default)
    }

    /// The axes that stay as declared.
    fn kept(&self) -> Vec<Axis> {
        match &self.only[..] {
            [] => self.keep.clone(),
            only => Axis::ALL.into_iter().filter(|axis| !only.contains(axis)).collect(),
        }
    }
}
