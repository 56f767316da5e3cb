//! How much is measured, and how far it has come.

use serde::Serialize;

/// How long a measurement may take.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Effort {
    /// Some seconds: five surfaces, small meshes, small pictures.
    Quick,
    /// Within two minutes: every surface in every tiling.
    #[default]
    Usual,
    /// Some minutes: the finest meshes for all.
    Full,
}

/// What is being done. How much of it there is in all is known from the start.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// The part.
    pub stage: &'static str,
    /// Steps of it that are done, and how many there are.
    pub done: usize,
    /// Its steps in all.
    pub total: usize,
}

/// Reported of each step, from any thread.
pub type Observer<'a> = &'a (dyn Fn(Progress) + Sync);
