//! Programs run as processes of their own, with the time and memory that they take.

use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// The time and memory of one process.
pub struct Run {
    pub seconds: f64,
    /// Bytes of resident memory at the peak; 0 if the system does not report it.
    pub peak: u64,
}

/// Runs a program, which has to succeed.
pub fn run(mut command: Command) -> Run {
    let start = Instant::now();
    let mut child = command.stdin(Stdio::null()).spawn().expect("the program starts");
    let mut peak = 0;
    let status = loop {
        peak = peak.max(high_water_mark(child.id()));
        if let Some(status) = child.try_wait().expect("a child can be waited for") {
            break status;
        }
        std::thread::sleep(Duration::from_micros(500));
    };
    let seconds = start.elapsed().as_secs_f64();
    assert!(status.success(), "{status}");
    Run { seconds, peak }
}

/// The peak so far, if the system reports it in `/proc`; 0 otherwise.
fn high_water_mark(process: u32) -> u64 {
    let status = std::fs::read_to_string(format!("/proc/{process}/status")).unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    line.and_then(|line| line.split_whitespace().next()?.parse::<u64>().ok()).unwrap_or(0) * 1024
}

/// The median of the seconds that runs took.
pub fn median(runs: &[Run]) -> f64 {
    let mut seconds: Vec<f64> = runs.iter().map(|run| run.seconds).collect();
    seconds.sort_by(f64::total_cmp);
    seconds[seconds.len() / 2]
}
