//! How much is measured, the progress of a measurement, and times that can be compared.

use serde::Serialize;
use std::time::Instant;

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

/// The progress of one stage. The number of its steps is known from the start.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// The stage.
    pub stage: &'static str,
    /// Steps that are done.
    pub done: usize,
    /// All its steps.
    pub total: usize,
}

/// Called for each step, from any thread.
pub type Observer<'a> = &'a (dyn Fn(Progress) + Sync);

/// A function to time.
pub(super) type Candidate<'a> = Box<dyn FnMut() + Send + 'a>;

/// Seconds. Shorter measurements depend on the resolution of the clock.
const SHORTEST: f64 = 2e-3;

/// The shortest time of each candidate on one thread, in seconds. They take turns, so that a machine that is busy for a while
/// does not slow one of them alone; the first turn warms up and determines how often the work must be repeated.
pub(super) fn fewest_seconds(mut candidates: Vec<Candidate>, rounds: usize) -> Vec<f64> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    let mut measure = || {
        let seconds = |work: &mut Candidate, repeats: u32| {
            let start = Instant::now();
            (0..repeats).for_each(|_| work());
            start.elapsed().as_secs_f64() / f64::from(repeats)
        };
        let repeat = |work| (SHORTEST / seconds(work, 1).max(1e-9)).ceil().clamp(1.0, 1e6) as u32;
        let repeats: Vec<u32> = candidates.iter_mut().map(repeat).collect();
        let mut fewest = vec![f64::INFINITY; candidates.len()];
        for _ in 0..rounds {
            for ((work, &repeats), fewest) in candidates.iter_mut().zip(&repeats).zip(&mut fewest) {
                *fewest = fewest.min(seconds(work, repeats));
            }
        }
        fewest
    };
    match pool {
        Ok(pool) => pool.install(measure),
        // Without a new thread, the current ones are used.
        Err(_) => measure(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::atomic::{AtomicU32, Ordering};

    #[test]
    fn every_candidate_gets_its_turns() {
        let counts = [const { AtomicU32::new(0) }; 2];
        let candidates: Vec<Candidate> = counts
            .iter()
            .map(|count| -> Candidate {
                Box::new(move || {
                    count.fetch_add(1, Ordering::Relaxed);
                    std::thread::sleep(std::time::Duration::from_millis(3));
                })
            })
            .collect();
        let seconds = fewest_seconds(candidates, 3);
        assert!(seconds.iter().all(|&seconds| seconds >= 3e-3), "{seconds:?}");
        assert_eq!(counts.each_ref().map(|count| count.load(Ordering::Relaxed)), [4, 4]);
    }
}
