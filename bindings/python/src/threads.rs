//! Threads, the interpreter lock and Ctrl-C.

use crate::arrays::wrong;
use pyo3::exceptions::{PyOverflowError, PyRuntimeError};
use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::any::Any;
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

/// Most threads, as for the program.
const MOST: usize = 1024;

/// How often a long call checks for signals.
const PATIENCE: Duration = Duration::from_millis(20);

/// The pools of a process, by their number of threads.
struct Pools {
    process: u32,
    of_size: BTreeMap<usize, Arc<ThreadPool>>,
}

static POOLS: Mutex<Pools> = Mutex::new(Pools { process: 0, of_size: BTreeMap::new() });

/// A pool of as many threads; `None` is one for each processor. A process made by `fork` has no threads of its parent, so it makes
/// new pools.
fn pool(threads: Option<ThreadCount>) -> PyResult<Arc<ThreadPool>> {
    let size = threads.map_or(0, |count| count.0);
    let mut pools = POOLS.lock().unwrap_or_else(PoisonError::into_inner);
    let process = std::process::id();
    if pools.process != process {
        // Dropping a pool would signal threads that are not there.
        std::mem::forget(std::mem::take(&mut pools.of_size));
        pools.process = process;
    }
    if let Some(pool) = pools.of_size.get(&size) {
        return Ok(pool.clone());
    }
    let built = ThreadPoolBuilder::new().num_threads(size).build();
    let pool = Arc::new(built.map_err(|error| PyRuntimeError::new_err(error.to_string()))?);
    pools.of_size.insert(size, pool.clone());
    Ok(pool)
}

/// Removes a pool, so that later calls do not wait for the work in it.
fn abandon(pool: &Arc<ThreadPool>) {
    let mut pools = POOLS.lock().unwrap_or_else(PoisonError::into_inner);
    pools.of_size.retain(|_, known| !Arc::ptr_eq(known, pool));
}

/// Runs work that borrows arrays, without the interpreter lock.
pub fn without_lock<T: Send>(
    py: Python<'_>,
    threads: Option<ThreadCount>,
    work: impl FnOnce() -> T + Send,
) -> PyResult<T> {
    let pool = pool(threads)?;
    let result = py.detach(|| catch_unwind(AssertUnwindSafe(|| pool.install(work))));
    result.map_err(|panic| internal(&*panic))
}

/// Set by Ctrl-C.
#[derive(Clone, Default)]
pub struct Stop(Arc<AtomicBool>);

impl Stop {
    /// Ends the work on all its threads if the call was interrupted.
    pub fn check(&self) {
        if self.0.load(Ordering::Relaxed) {
            resume_unwind(Box::new("interrupted"));
        }
    }
}

/// The argument `threads`.
#[derive(Clone, Copy)]
pub struct ThreadCount(usize);

impl FromPyObject<'_, '_> for ThreadCount {
    type Error = PyErr;

    fn extract(given: Borrowed<'_, '_, PyAny>) -> PyResult<Self> {
        let refused = || wrong(format!("threads is {}; a number from 1 to {MOST} was expected", &*given));
        match given.extract::<usize>() {
            Ok(count @ 1..=MOST) => Ok(Self(count)),
            Ok(_) => Err(refused()),
            // Negative, or larger than any size.
            Err(error) if error.is_instance_of::<PyOverflowError>(given.py()) => Err(refused()),
            Err(error) => Err(error),
        }
    }
}

/// Runs work that owns its data, without the interpreter lock, and raises the exception of a signal at once. The work then ends at its
/// next check of [`Stop`].
pub fn interruptible<T: Send + 'static>(
    py: Python<'_>,
    threads: Option<ThreadCount>,
    work: impl FnOnce(&Stop) -> T + Send + 'static,
) -> PyResult<T> {
    let stop = Stop::default();
    let (send, receive) = mpsc::channel();
    let receive = Mutex::new(receive);
    let inside = stop.clone();
    let pool = pool(threads)?;
    pool.spawn(move || {
        let result = catch_unwind(AssertUnwindSafe(|| work(&inside)));
        // Without a receiver the call was interrupted.
        send.send(result).ok();
    });
    let wait = || receive.lock().unwrap_or_else(PoisonError::into_inner).recv_timeout(PATIENCE);
    loop {
        match py.detach(wait) {
            Ok(result) => return result.map_err(|panic| internal(&*panic)),
            Err(RecvTimeoutError::Disconnected) => return Err(internal(&"the work has no result")),
            Err(RecvTimeoutError::Timeout) => py.check_signals().inspect_err(|_| {
                stop.0.store(true, Ordering::Relaxed);
                abandon(&pool);
            })?,
        }
    }
}

/// The exception for a panic, which is a fault of this package.
fn internal(panic: &(dyn Any + Send)) -> PyErr {
    let text = panic.downcast_ref::<&str>().map(|text| (*text).to_owned());
    let text = text.or_else(|| panic.downcast_ref::<String>().cloned());
    let text = text.unwrap_or_else(|| "panicked".to_owned());
    PyRuntimeError::new_err(format!("internal error: {text}; please report it"))
}
