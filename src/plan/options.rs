//! The options of a plan.

use super::axes::Axis;
use super::compare::Metric;
use super::cost::Minimise;
use super::stage::PlanError;
use crate::num::Degrees;

/// What a plan keeps to, and how it is found.
#[derive(Clone, Debug, PartialEq)]
pub struct PlanOptions {
    /// How pictures are compared.
    pub metric: Metric,
    /// Largest difference by this metric: in steps of 1/255 before values are rounded, or of ꟻLIP.
    pub tolerance: f64,
    /// Share of the covered pixels that may be beyond it.
    pub share: f64,
    /// Largest distance of outlines, in pixels.
    pub outline: f64,
    /// What is made as small as possible.
    pub minimise: Minimise,
    /// The number of views around the scene; `None` for its camera.
    pub views: Option<u32>,
    /// The angle by which all lights may turn around the middle of the scene.
    pub light_cone: Degrees,
    /// Axes that stay as declared.
    pub keep: Vec<Axis>,
    /// Whether pixels may have fewer samples.
    pub allow_antialiasing: bool,
    /// Most pixels to draw.
    pub budget: u64,
    /// Change only what the mesh files of objects hold, as [`apply`](super::apply()) writes them: normals and their storage, which the
    /// scene has to [state](super::with_stored_normals).
    pub for_files: bool,
    /// Most seconds to search. A plan that ends so depends on the machine.
    pub seconds: Option<f64>,
}

impl Default for PlanOptions {
    /// Two steps, half a pixel, and 10⁹ pixels.
    fn default() -> Self {
        Self {
            metric: Metric::Steps,
            tolerance: 2.0,
            share: 0.0,
            outline: 0.5,
            minimise: Minimise::Work,
            views: None,
            light_cone: Degrees(0.0),
            keep: Vec::new(),
            allow_antialiasing: false,
            budget: 1_000_000_000,
            for_files: false,
            seconds: None,
        }
    }
}

impl PlanOptions {
    /// Refuses numbers out of range.
    pub(super) fn check(&self) -> Result<(), PlanError> {
        // No difference is larger.
        let largest = match self.metric {
            Metric::Steps => 255.0,
            Metric::Flip => 1.0,
        };
        let limits = [
            ("tolerance", self.tolerance, largest),
            ("share of pixels", self.share, 1.0),
            ("distance of outlines", self.outline, f64::MAX),
            ("angle of lights", self.light_cone.0, 180.0),
            ("time", self.seconds.unwrap_or(0.0), MOST_SECONDS),
        ];
        match limits.into_iter().find(|(_, value, most)| !(0.0..=*most).contains(value)) {
            None => Ok(()),
            Some((name, value, most)) => {
                let range = match most == f64::MAX {
                    true => "a finite number, 0 or more, was expected".to_owned(),
                    false => format!("a number from 0 to {most} was expected"),
                };
                Err(PlanError::Invalid(format!("the {name} is {value}; {range}")))
            }
        }
    }
}

/// Why a search ended.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
#[serde(tag = "reason", rename_all = "lowercase")]
pub enum End {
    /// All cheaper plans are refused.
    Proven,
    /// The budget is used up.
    Budget {
        /// Most pixels to draw.
        pixels: u64,
    },
    /// The time is used up, so the plan depends on the machine.
    Time {
        /// Most seconds to search.
        seconds: f64,
    },
}

/// How far a search is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    /// The share of the cost of the best plan that is proven, or of the budget that is used up, whichever is larger; 1 at the end.
    pub share: f64,
    /// The cost of the best plan, as a share of the declared cost.
    pub best: f64,
}

/// Most seconds of a search: thirty years.
const MOST_SECONDS: f64 = 1e9;
