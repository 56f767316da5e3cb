//! Times that can be compared.

use std::time::Instant;

/// Something to measure.
pub(super) type Candidate<'a> = Box<dyn FnMut() + Send + 'a>;

/// Shorter measurements say more of the clock than of the work.
const SHORTEST: f64 = 2e-3;

/// The fewest seconds of each candidate on one thread: what it takes when nothing else disturbs it. They take turns, so that a
/// machine that is busy for a while does not slow one of them alone; the first turn is for warming up and to find how often
/// the work must be repeated.
pub(super) fn fewest_seconds(mut candidates: Vec<Candidate>, rounds: usize) -> Vec<f64> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    let mut measure = || {
        let repeats: Vec<u32> = candidates
            .iter_mut()
            .map(|work| {
                let start = Instant::now();
                work();
                (SHORTEST / start.elapsed().as_secs_f64().max(1e-9)).ceil().clamp(1.0, 1e6) as u32
            })
            .collect();
        let mut fewest = vec![f64::INFINITY; candidates.len()];
        for _ in 0..rounds {
            for ((work, &repeats), fewest) in candidates.iter_mut().zip(&repeats).zip(&mut fewest) {
                let start = Instant::now();
                (0..repeats).for_each(|_| work());
                *fewest = fewest.min(start.elapsed().as_secs_f64() / f64::from(repeats));
            }
        }
        fewest
    };
    match pool {
        Ok(pool) => pool.install(measure),
        // Where no thread can be had, the ones that there are must do.
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
