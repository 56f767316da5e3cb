//! Options that several verbs have, and their values.

use super::choice::choices;
use clap::Args;
use crease::io::Format;
use crease::mesh::Confidence;
use crease::normals::{Crease, Weight, When};
use crease::num::Degrees;

#[derive(Args)]
#[command(next_help_heading = "Running and reporting")]
pub struct RunArgs {
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub threads: Option<u16>,
    #[arg(long)]
    pub json: bool,
    #[arg(short, long, conflicts_with = "verbose")]
    pub quiet: bool,
    #[arg(short, long)]
    pub verbose: bool,
}

impl RunArgs {
    /// Bounds the number of threads; to be called before any work is done.
    pub fn use_threads(&self) {
        if let Some(threads) = self.threads {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads.into()).build_global();
            pool.expect("the pool has not been used yet");
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Color {
    Auto,
    Always,
    Never,
}

choices! { Color: "auto" => Auto, "always" => Always, "never" => Never }

choices! { Format: "obj" => Obj, "ply" => Ply, "stl" => Stl, "gltf" => Gltf, "glb" => Glb }

choices! { Weight:
    "uniform" => Uniform, "area" => Area, "angle" => Angle, "angle-area" => AngleArea, "max" => Max,
    "edge" => Edge, "quadric" => Quadric,
}

choices! { When: "always" => Always, "missing" => Missing, "broken" => Broken }

pub fn confidence(text: &str) -> Result<Confidence, String> {
    match text.parse() {
        Ok(share) if (0.5..=1.0).contains(&share) => Ok(Confidence(share)),
        _ => Err("a number from 0.5 to 1 was expected".into()),
    }
}

pub fn crease_angle(text: &str) -> Result<Degrees, String> {
    if text == "off" {
        let Crease::Angle(off) = Crease::OFF else { unreachable!("off is an angle") };
        return Ok(off);
    }
    match text.parse() {
        Ok(angle) if (0.0..=180.0).contains(&angle) => Ok(Degrees(angle)),
        _ => Err("an angle from 0 to 180 degrees, or `off`, was expected".into()),
    }
}
