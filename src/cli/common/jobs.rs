//! Several inputs at a time, within a budget of memory.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::ControlFlow;
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError, mpsc};
use std::thread;

/// The stack of a thread in bytes, as large as that of a program on most systems.
const STACK: usize = 8 << 20;

/// An item that needs fewer bytes than this is processed on one thread if other items keep the other threads busy: waking them takes
/// longer than the work. A mesh of a few thousand triangles needs as much.
const SMALL: u64 = 1 << 20;

/// How many inputs are processed at the same time.
#[derive(Clone, Copy, Debug)]
pub struct Jobs {
    pub most: usize,
    /// Bytes that all of them may need together. An input that needs more is processed alone.
    pub memory: u64,
}

/// The items of a batch, in their order.
struct Queue<'a> {
    /// The bytes that each item needs.
    needs: &'a [u64],
    memory: u64,
    state: Mutex<State>,
    changed: Condvar,
}

#[derive(Default)]
struct State {
    next: usize,
    /// Bytes of the items that are being processed.
    used: u64,
    /// All items before this one are done.
    due: usize,
    /// Items after `due` that are done.
    early: BTreeSet<usize>,
}

/// An item that is being processed.
pub struct Turn<'a> {
    number: usize,
    queue: &'a Queue<'a>,
}

impl Queue<'_> {
    fn lock(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn wait<'a>(&self, state: MutexGuard<'a, State>) -> MutexGuard<'a, State> {
        self.changed.wait(state).unwrap_or_else(PoisonError::into_inner)
    }

    /// The next item, once there is memory for it.
    fn next(&self) -> Option<Turn<'_>> {
        let mut state = self.lock();
        loop {
            let number = state.next;
            let need = *self.needs.get(number)?;
            if state.used == 0 || state.used.saturating_add(need) <= self.memory {
                state.next += 1;
                state.used = state.used.saturating_add(need);
                return Some(Turn { number, queue: self });
            }
            state = self.wait(state);
        }
    }

    /// No further items are taken.
    fn close(&self) {
        self.lock().next = self.needs.len();
    }
}

impl Turn<'_> {
    /// Waits until all items before this one are done.
    pub fn wait(&self) {
        let mut state = self.queue.lock();
        while state.due < self.number {
            state = self.queue.wait(state);
        }
    }
}

impl Drop for Turn<'_> {
    fn drop(&mut self) {
        let mut state = self.queue.lock();
        state.used = state.used.saturating_sub(self.queue.needs[self.number]);
        state.early.insert(self.number);
        while state.early.first() == Some(&state.due) {
            state.early.pop_first();
            state.due += 1;
        }
        self.queue.changed.notify_all();
    }
}

impl Jobs {
    /// Does the work of each item on several threads; `needs` are the bytes that each needs. `finish` receives the results on the
    /// calling thread in the order of the items. After work that breaks, no further items are taken; those in work are finished.
    pub fn run<'a, T: Sync, R: Send>(
        self,
        items: &'a [T],
        needs: &[u64],
        work: impl Fn(&'a T, &Turn<'_>) -> ControlFlow<R, R> + Sync,
        mut finish: impl FnMut(&'a T, R),
    ) {
        let queue = Queue { needs, memory: self.memory, state: Mutex::default(), changed: Condvar::new() };
        let (sender, receiver) = mpsc::channel();
        let all_busy = self.most.min(items.len()) >= rayon::current_num_threads();
        let work_off = |sender: mpsc::Sender<(usize, R)>| {
            let mut alone = None;
            while let Some(turn) = queue.next() {
                let work = || work(&items[turn.number], &turn);
                let result = match needs[turn.number] {
                    ..SMALL if all_busy => alone.get_or_insert_with(one_thread).install(work),
                    _ => work(),
                };
                if result.is_break() {
                    queue.close();
                }
                let (ControlFlow::Continue(result) | ControlFlow::Break(result)) = result;
                // The receiver is there until all threads have ended.
                let _ = sender.send((turn.number, result));
            }
        };
        let work_off = &work_off;
        thread::scope(|scope| {
            for _ in 0..self.most.min(items.len()) {
                let sender = sender.clone();
                let thread = thread::Builder::new().stack_size(STACK);
                thread.spawn_scoped(scope, move || work_off(sender)).expect("the system has no more threads");
            }
            drop(sender);
            let (mut results, mut due) = (BTreeMap::new(), 0);
            for (number, result) in receiver {
                results.insert(number, result);
                while let Some(result) = results.remove(&due) {
                    finish(&items[due], result);
                    due += 1;
                }
            }
        });
    }
}

/// A pool in which loops are not divided.
fn one_thread() -> rayon::ThreadPool {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).stack_size(STACK);
    pool.build().expect("the system has no more threads")
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::atomic::{AtomicU64, Ordering};
    use std::time::Duration;

    /// Runs items that sleep for so many milliseconds, and returns the order of results and the largest sum of bytes at a time.
    fn run(most: usize, memory: u64, items: &[(u64, u64)]) -> (Vec<u64>, u64) {
        let needs: Vec<u64> = items.iter().map(|item| item.1).collect();
        let (used, largest) = (AtomicU64::new(0), AtomicU64::new(0));
        let mut order = Vec::new();
        let work = |&(sleep, need): &(u64, u64), _: &Turn<'_>| {
            largest.fetch_max(used.fetch_add(need, Ordering::SeqCst) + need, Ordering::SeqCst);
            thread::sleep(Duration::from_millis(sleep));
            used.fetch_sub(need, Ordering::SeqCst);
            ControlFlow::Continue(sleep)
        };
        Jobs { most, memory }.run(items, &needs, work, |_, result| order.push(result));
        (order, largest.into_inner())
    }

    #[test]
    fn results_come_in_order_and_memory_stays_within_its_budget() {
        let items = [(30, 4), (1, 4), (20, 4), (2, 9), (3, 1), (4, 1)];
        let expected: Vec<u64> = items.iter().map(|item| item.0).collect();
        for most in [1, 2, 3, 8] {
            let (order, largest) = run(most, 8, &items);
            assert_eq!(order, expected);
            assert_eq!(largest, 9, "the item of 9 bytes is alone");
        }
        assert!(run(4, 100, &[]).0.is_empty());
    }

    #[test]
    fn as_many_items_as_threads_are_processed_at_the_same_time() {
        let present = AtomicU64::new(0);
        let all_are_there = |_: &u64, _: &Turn<'_>| {
            present.fetch_add(1, Ordering::SeqCst);
            // Without the others this ends after half a minute, and fails.
            ControlFlow::Continue((0..15_000).any(|_| {
                thread::sleep(Duration::from_millis(2));
                present.load(Ordering::SeqCst) == 3
            }))
        };
        let mut met = Vec::new();
        Jobs { most: 3, memory: 12 }.run(&[1, 2, 3], &[4; 3], all_are_there, |_, is_met| met.push(is_met));
        assert_eq!(met, [true; 3]);
    }

    #[test]
    fn a_turn_waits_for_all_before_it() {
        let items: Vec<u64> = (0..40).collect();
        let done = Mutex::new(Vec::new());
        let work = |item: &u64, turn: &Turn<'_>| {
            thread::sleep(Duration::from_millis((item * 7) % 5));
            turn.wait();
            done.lock().unwrap().push(*item);
            ControlFlow::Continue(())
        };
        Jobs { most: 4, memory: u64::MAX }.run(&items, &[1; 40], work, |_, ()| ());
        assert_eq!(done.into_inner().unwrap(), items);
    }

    #[test]
    fn work_that_breaks_is_the_last_that_is_taken() {
        let items: Vec<u64> = (0..1000).collect();
        for most in [1, 2] {
            let mut done = Vec::new();
            let work = |&item: &u64, _: &Turn<'_>| {
                if item < 5 { ControlFlow::Continue(item) } else { ControlFlow::Break(item) }
            };
            Jobs { most, memory: u64::MAX }.run(&items, &[1; 1000], work, |_, item| done.push(item));
            assert_eq!(done[..6], [0, 1, 2, 3, 4, 5]);
            assert!(done.len() < 6 + most, "{done:?}");
        }
    }
}
