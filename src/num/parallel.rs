//! Loops over numbered items on the threads of rayon's current pool.
//!
//! Each chain of rayon's iterators is compiled anew, with the division of work: about 2000 lines of LLVM's intermediate code. Here
//! the division is compiled once, and only the body of a loop is generic. Rayon's own iterators remain in loops over whole meshes
//! that would lose time if their results were copied once more.
//!
//! Items are divided into consecutive ranges. The number of ranges depends on the number of threads; the order of results does not.

use std::ops::Range;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

/// Ranges for each thread: a thread that is done early takes over some of another's.
const RANGES_PER_THREAD: usize = 8;

/// The results of `work` for consecutive ranges that cover `0..count`, in order.
///
/// The ranges depend on the number of threads, so only joins that give the same for any division may follow.
pub(crate) fn ranges<R: Send>(count: usize, work: impl Fn(Range<usize>) -> R + Sync) -> Vec<R> {
    results(count, &work)
}

/// The results of `work` for consecutive ranges of `size` items, the last one shorter, that cover `0..count`, in order.
///
/// The ranges do not depend on the number of threads: their sums may be rounded.
pub(crate) fn blocks<R: Send>(count: usize, size: usize, work: impl Fn(Range<usize>) -> R + Sync) -> Vec<R> {
    map(count.div_ceil(size), |block| work(block * size..((block + 1) * size).min(count)))
}

/// The values of `item` for `0..count`, in order.
pub(crate) fn map<T: Send>(count: usize, item: impl Fn(usize) -> T + Sync) -> Vec<T> {
    joined(ranges(count, |range| range.map(&item).collect()))
}

/// The values of `item` for each element of a slice, in order.
pub(crate) fn map_each<S: Sync, T: Send>(items: &[S], item: impl Fn(&S) -> T + Sync) -> Vec<T> {
    joined(ranges(items.len(), |range| items[range].iter().map(&item).collect()))
}

/// The values of `item` for each element of a vector, which is consumed, in order.
pub(crate) fn map_owned<S: Send, T: Send>(items: Vec<S>, item: impl Fn(S) -> T + Sync) -> Vec<T> {
    let slots: Vec<Mutex<Option<S>>> = items.into_iter().map(|item| Mutex::new(Some(item))).collect();
    let take = |slot: &Mutex<Option<S>>| slot.lock().unwrap_or_else(PoisonError::into_inner).take();
    filter_map(slots.len(), |number| take(&slots[number]).map(&item))
}

/// As [`map`], with a scratch value that a range of items shares. A result must not depend on what others left in it.
pub(crate) fn map_with<W, T: Send>(
    count: usize,
    scratch: impl Fn() -> W + Sync,
    item: impl Fn(&mut W, usize) -> T + Sync,
) -> Vec<T> {
    joined(ranges(count, |range| {
        let mut scratch = scratch();
        range.map(|number| item(&mut scratch, number)).collect()
    }))
}

/// The values of `item` for `0..count` that exist, in order.
pub(crate) fn filter_map<T: Send>(count: usize, item: impl Fn(usize) -> Option<T> + Sync) -> Vec<T> {
    joined(ranges(count, |range| range.filter_map(&item).collect()))
}

/// The numbers of `0..count` that pass `test`, ascending.
pub(crate) fn filter(count: usize, test: impl Fn(u32) -> bool + Sync) -> Vec<u32> {
    filter_map(count, |number| test(number as u32).then_some(number as u32))
}

/// How many numbers of `0..count` pass `test`.
pub(crate) fn count(count: usize, test: impl Fn(u32) -> bool + Sync) -> usize {
    ranges(count, |range| range.filter(|&number| test(number as u32)).count()).into_iter().sum()
}

/// The number of the first element that passes `test`. Later ranges that have not begun when one is found are skipped.
pub(crate) fn position<S: Sync>(items: &[S], test: impl Fn(&S) -> bool + Sync) -> Option<usize> {
    let first = AtomicUsize::new(usize::MAX);
    ranges(items.len(), |range| {
        let start = range.start;
        if start < first.load(Ordering::Relaxed)
            && let Some(found) = items[range].iter().position(&test)
        {
            first.fetch_min(start + found, Ordering::Relaxed);
        }
    });
    Some(first.into_inner()).filter(|&first| first < items.len())
}

/// Whether all elements pass `test`.
pub(crate) fn all<S: Sync>(items: &[S], test: impl Fn(&S) -> bool + Sync) -> bool {
    position(items, |item| !test(item)).is_none()
}

/// The results of `work` for each chunk of `size` elements, the last one shorter, and its number, in order.
pub(crate) fn map_chunks<T: Send, R: Send>(
    items: &mut [T],
    size: usize,
    work: impl Fn(usize, &mut [T]) -> R + Sync,
) -> Vec<R> {
    map_chunks_with(items, size, || (), |(), number, chunk| work(number, chunk))
}

/// As [`map_chunks`], with a scratch value that a range of chunks shares. A result must not depend on what others left in it.
pub(crate) fn map_chunks_with<W, T: Send, R: Send>(
    items: &mut [T],
    size: usize,
    scratch: impl Fn() -> W + Sync,
    work: impl Fn(&mut W, usize, &mut [T]) -> R + Sync,
) -> Vec<R> {
    let chunks: Vec<Mutex<&mut [T]>> = items.chunks_mut(size).map(Mutex::new).collect();
    map_with(chunks.len(), scratch, |scratch, number| {
        work(scratch, number, &mut chunks[number].lock().unwrap_or_else(PoisonError::into_inner))
    })
}

fn results<R: Send>(count: usize, work: &(dyn Fn(Range<usize>) -> R + Sync)) -> Vec<R> {
    let parts = parts(count);
    if parts == 1 {
        return vec![work(0..count)];
    }
    let results: Vec<Mutex<Option<R>>> = std::iter::repeat_with(Mutex::default).take(parts).collect();
    divide(0..parts, &|part| {
        let result = work(range(count, parts, part));
        *results[part].lock().unwrap_or_else(PoisonError::into_inner) = Some(result);
    });
    let result = |slot: Mutex<Option<R>>| slot.into_inner().unwrap_or_else(PoisonError::into_inner);
    results.into_iter().filter_map(result).collect()
}

fn parts(count: usize) -> usize {
    match rayon::current_num_threads() {
        1 => 1,
        threads => count.clamp(1, RANGES_PER_THREAD * threads),
    }
}

fn range(count: usize, parts: usize, part: usize) -> Range<usize> {
    let start = |part: usize| (count as u128 * part as u128 / parts as u128) as usize;
    start(part)..start(part + 1)
}

fn divide(parts: Range<usize>, task: &(dyn Fn(usize) + Sync)) {
    if parts.len() <= 1 {
        return parts.for_each(task);
    }
    let middle = parts.start + parts.len() / 2;
    rayon::join(|| divide(parts.start..middle, task), || divide(middle..parts.end, task));
}

fn joined<T>(mut lists: Vec<Vec<T>>) -> Vec<T> {
    if lists.len() == 1 {
        return lists.swap_remove(0);
    }
    let mut all = Vec::with_capacity(lists.iter().map(Vec::len).sum());
    lists.iter_mut().for_each(|list| all.append(list));
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn loops_give_the_same_at_any_number_of_threads() {
        for threads in [1, 2, 3, 8] {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| [0, 1, 2, 7, 8, 9, 100, 1001].into_iter().for_each(check));
        }
    }

    fn check(length: usize) {
        let numbers: Vec<usize> = (0..length).collect();
        let squares: Vec<usize> = numbers.iter().map(|i| i * i).collect();
        assert_eq!(map(length, |i| i * i), squares);
        assert_eq!(map_each(&numbers, |i| i * i), squares);
        assert_eq!(map_owned(numbers.clone(), |i| i * i), squares);
        let product = |scratch: &mut usize, i: usize| {
            *scratch = i;
            *scratch * i
        };
        assert_eq!(map_with(length, || 0, product), squares);
        let thirds: Vec<usize> = (0..length).step_by(3).collect();
        assert_eq!(filter_map(length, |i| (i % 3 == 0).then_some(i)), thirds);
        assert!(filter(length, |i| i % 3 == 0).iter().map(|&i| i as usize).eq(thirds));
        assert_eq!(count(length, |i| i % 3 == 0), length.div_ceil(3));
        assert_eq!(position(&numbers, |&i| i % 10 == 7), (length > 7).then_some(7));
        assert!(all(&numbers, |&i| i < length));
        assert_eq!(all(&numbers, |&i| i != 7), length <= 7);
        assert!(ranges(length, |range| range).into_iter().flatten().eq(0..length));
        for size in [1, 3, 8] {
            let chunks: Vec<&[usize]> = numbers.chunks(size).collect();
            assert_eq!(blocks(length, size, |range| &numbers[range]), chunks);
            let mut found = vec![usize::MAX; length];
            let lengths = map_chunks(&mut found, size, |number, chunk| {
                chunk.iter_mut().enumerate().for_each(|(i, item)| *item = (number * size + i).pow(2));
                chunk.len()
            });
            assert_eq!(found, squares);
            assert!(lengths.into_iter().eq(chunks.iter().map(|chunk| chunk.len())));
        }
    }

    #[test]
    fn a_panic_in_a_loop_reaches_the_caller() {
        let outcome = std::panic::catch_unwind(|| map(100, |i| assert!(i != 60, "the item that fails")));
        assert!(outcome.is_err());
    }
}
