//! The progress of fits, which take a hundred times as long as sums.

use std::sync::atomic::{AtomicUsize, Ordering};

/// Called with the number of fits that are done and that of all, in any order and from any thread.
pub type FitObserver<'a> = &'a (dyn Fn(usize, usize) + Sync);

/// Observes nothing.
pub(crate) const UNOBSERVED: FitObserver<'static> = &|_, _| ();

/// How many fits are done.
pub(crate) struct FitCount<'a> {
    done: AtomicUsize,
    all: usize,
    observe: FitObserver<'a>,
}

impl<'a> FitCount<'a> {
    pub(crate) fn new(all: usize, observe: FitObserver<'a>) -> Self {
        Self { done: AtomicUsize::new(0), all, observe }
    }

    pub(crate) fn add(&self, more: usize) {
        let before = self.done.fetch_add(more, Ordering::Relaxed);
        (self.observe)(before + more, self.all);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::normals::compute::compute_observed;
    use crate::normals::field::Extras;
    use crate::normals::fits::test_surfaces::torus;
    use crate::normals::recipe::{Crease, NormalRecipe, Weight};

    #[test]
    fn fits_report_their_progress_and_sums_do_not() {
        let (mesh, _) = torus(48, 24);
        for weight in Weight::ALL {
            let (calls, most) = (AtomicUsize::new(0), AtomicUsize::new(0));
            let observe = |done, all| {
                assert_eq!(all, mesh.vertex_count());
                calls.fetch_add(1, Ordering::Relaxed);
                most.fetch_max(done, Ordering::Relaxed);
            };
            let recipe = NormalRecipe { weight, crease: Crease::OFF, ..NormalRecipe::default() };
            compute_observed(&mesh, &recipe, Extras::NONE, &observe);
            let found = (calls.into_inner(), most.into_inner());
            let expected = if weight.is_fit() { (9, mesh.vertex_count()) } else { (0, 0) };
            assert_eq!(found, expected, "{}", weight.name());
        }
    }
}
