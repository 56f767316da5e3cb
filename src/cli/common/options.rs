//! Options that several verbs have, and their values.

use super::choice::choices;
use clap::Args;
use crease::io::Format;
use crease::mesh::Confidence;
use crease::normals::{Crease, Weight, When};
use crease::num::Degrees;

pub const EXIT_CODES: &str = "\
Exit codes:
  0  done
  1  `crease inspect --fail-on` found something,
     an expectation of `crease stress` does not hold,
     or a measure of `crease artefact` differs from its expected value
  2  wrong usage
  3  an input could not be read
  4  an output could not be made or stored
  5  some files of a batch failed; the others are done";

#[derive(Args)]
#[command(next_help_heading = "Running and reporting")]
pub struct RunArgs {
    /// Threads to use; the output is the same for any number [default: one per processor]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub threads: Option<u16>,

    /// Report as JSON
    #[arg(long)]
    pub json: bool,

    /// Report errors only
    #[arg(short, long, conflicts_with = "verbose")]
    pub quiet: bool,

    /// Report details
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

/// When to use colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Color {
    Auto,
    Always,
    Never,
}

choices! { Color {
    "auto" => Auto: "on a terminal, unless NO_COLOR is set; CLICOLOR_FORCE forces it",
    "always" => Always: "always",
    "never" => Never: "never",
} }

choices! { Format {
    "obj" => Obj: "Wavefront OBJ",
    "ply" => Ply: "PLY, ascii or binary",
    "stl" => Stl: "STL, ascii or binary",
    "gltf" => Gltf: "glTF 2.0, JSON",
    "glb" => Glb: "glTF 2.0, binary",
} }

choices! { Weight {
    "uniform" => Uniform: "all equal (Gouraud 1971)",
    "area" => Area: "area of the face",
    "angle" => Angle: "angle of the face at the corner (Thürmer & Wüthrich 1998)",
    "angle-area" => AngleArea: "angle times area",
    "max" => Max: "sin of the angle over the product of the edge lengths; exact on a sphere (Max 1999)",
    "edge" => Edge: "1 over the product of the edge lengths",
    "quadric" => Quadric: "least-squares quadric through the two-ring: second order; for noise",
    "jet" => Jet: "osculating jet of degree 3 (Cazals & Pouget 2005): third order; for smooth surfaces without noise",
    "best" => Best: "jet, quadric or angle, whichever has the smallest estimated error on the mesh",
} }

choices! { When {
    "always" => Always: "all",
    "missing" => Missing: "only those of corners without a normal",
    "broken" => Broken: "also normals that are not finite, zero, or against their own face; other lengths are normalised",
} }

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
