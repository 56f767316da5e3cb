//! Times of stages, on systems that have a clock.

use std::time::{Duration, Instant};

/// A running stopwatch. In WebAssembly without a system there is no clock, and all times are zero.
pub(super) struct Stopwatch(Option<Instant>);

impl Stopwatch {
    pub(super) fn start() -> Self {
        Self((!cfg!(all(target_arch = "wasm32", target_os = "unknown"))).then(Instant::now))
    }

    pub(super) fn elapsed(&self) -> Duration {
        self.0.map_or(Duration::ZERO, |start| start.elapsed())
    }
}
