//! Options that several verbs have, and their values: names, angles, numbers, vectors, colours.

use super::choice::choices;
use clap::Args;
use crease::io::{Format, NonFinite, ReadOptions};
use crease::mesh::{Confidence, UpAxis};
use crease::normals::{Crease, Weight, When};
use crease::num::{Degrees, LinearRgb, Srgb8};
use glam::DVec3;
use std::path::PathBuf;

#[derive(Args, Clone, Debug, Default)]
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

/// Files that an input refers to.
#[derive(Args, Clone, Debug)]
pub struct CompanionArgs {
    #[arg(long, value_name = "DIR")]
    root: Option<PathBuf>,
    #[arg(long, value_name = "NAME")]
    allow_extension: Vec<String>,
}

impl CompanionArgs {
    /// How an input is read; `force` drops faces that are not finite.
    pub fn read_options(&self, force: bool) -> ReadOptions {
        ReadOptions {
            root: self.root.clone(),
            allowed_extensions: self.allow_extension.clone(),
            non_finite: if force { NonFinite::DropFaces } else { NonFinite::Refuse },
            ..ReadOptions::default()
        }
    }

    /// # Errors
    /// If the root is no folder.
    pub fn check(&self) -> Result<(), String> {
        match self.root.as_ref().filter(|root| !root.is_dir()) {
            Some(root) => Err(format!("--root {} is not a folder", root.display())),
            None => Ok(()),
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

choices! { Format: "obj" => Obj, "ply" => Ply, "stl" => Stl, "gltf" => Gltf, "glb" => Glb, "3mf" => ThreeMf }

choices! { Weight:
    "uniform" => Uniform, "area" => Area, "angle" => Angle, "angle-area" => AngleArea, "max" => Max,
    "edge" => Edge, "quadric" => Quadric, "jet" => Jet, "best" => Best,
}

choices! { UpAxis: "x" => X, "y" => Y, "z" => Z }

choices! { When: "always" => Always, "missing" => Missing, "broken" => Broken }

pub fn confidence(text: &str) -> Result<Confidence, String> {
    match text.parse() {
        Ok(share) if (0.5..=1.0).contains(&share) => Ok(Confidence(share)),
        _ => Err("expected a number from 0.5 to 1".into()),
    }
}

pub fn crease_angle(text: &str) -> Result<Degrees, String> {
    if text == "off" {
        let Crease::Angle(off) = Crease::OFF else { unreachable!("off is an angle") };
        return Ok(off);
    }
    match text.parse() {
        Ok(angle) if (0.0..=180.0).contains(&angle) => Ok(Degrees(angle)),
        _ => Err("expected an angle from 0 to 180 degrees, or `off`".into()),
    }
}

pub fn number(text: &str) -> Result<f64, String> {
    let number = text.trim().parse().ok().filter(|number: &f64| number.is_finite());
    number.ok_or_else(|| format!("{text:?} is not a finite number"))
}

pub fn not_negative(text: &str) -> Result<f64, String> {
    let number = number(text).ok().filter(|&number| number >= 0.0);
    number.ok_or_else(|| format!("{text:?} is not a finite number, 0 or more"))
}

/// A number from 0 to a largest one.
pub fn at_most(most: f64) -> impl Fn(&str) -> Result<f64, String> + Clone + Send + Sync {
    move |text| {
        let number = not_negative(text).ok().filter(|&number| number <= most);
        number.ok_or_else(|| format!("{text:?} is not a number from 0 to {most}"))
    }
}

pub fn finite_numbers(text: &str) -> Result<Vec<f64>, String> {
    text.split(',').map(number).collect()
}

/// `1,2,3`.
pub fn vector(text: &str) -> Result<DVec3, String> {
    match finite_numbers(text)?[..] {
        [x, y, z] => Ok(DVec3::new(x, y, z)),
        _ => Err(format!("{text:?} is not three numbers such as 1,0,2.5")),
    }
}

/// `#rrggbb` in sRGB, three linear components, or one for a grey.
pub fn colour(text: &str) -> Result<LinearRgb, String> {
    let wrong = || {
        format!("{text:?} is not a colour: expected #rrggbb (sRGB), R,G,B or one number (linear, 0 or more)")
    };
    if let Some(digits) = text.strip_prefix('#') {
        let is_hexadecimal = digits.len() == 6 && digits.bytes().all(|digit| digit.is_ascii_hexdigit());
        let code = u32::from_str_radix(digits, 16).ok().filter(|_| is_hexadecimal).ok_or_else(wrong)?;
        let [_, r, g, b] = code.to_be_bytes();
        return Ok(Srgb8([r, g, b]).into());
    }
    let numbers: Result<Vec<f64>, _> = text.split(',').map(not_negative).collect();
    match numbers.map_err(|_| wrong())?[..] {
        [grey] => Ok(LinearRgb::grey(grey)),
        [r, g, b] => Ok(LinearRgb::new(r, g, b)),
        _ => Err(wrong()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_are_codes_or_light() {
        assert_eq!(colour("#ff0000"), Ok(LinearRgb::new(1.0, 0.0, 0.0)));
        assert!((colour("#bcbcbc").unwrap().g - 0.502_886_5).abs() < 1e-6, "188 is about half the light");
        assert_eq!(colour("0.5"), Ok(LinearRgb::grey(0.5)));
        assert_eq!(colour("2, 0,1e-3"), Ok(LinearRgb::new(2.0, 0.0, 1e-3)));
        for wrong in ["", "#12", "#+12345", "#12345g", "1,2", "1,2,3,4", "-1", "nan", "1,inf,1", "red"] {
            assert!(colour(wrong).unwrap_err().contains("#rrggbb"), "{wrong}");
        }
    }
}
