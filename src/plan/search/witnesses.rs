//! Pixels at which models were refused.

use crate::plan::axes::Cells;
use std::cell::{Cell, RefCell};
use std::collections::HashMap;
use std::rc::Rc;

/// A pixel of a view of which all samples show one face.
#[derive(Clone, Copy, Debug)]
pub struct Witness {
    /// Its number among all of them.
    pub number: usize,
    pub view: usize,
    pub pixel: [u32; 2],
    pub face: (usize, u32),
}

/// Those of all units.
#[derive(Default)]
pub struct Witnesses {
    /// Of a unit with these cells. The latest comes first.
    pub lists: RefCell<HashMap<(usize, Cells), Vec<Witness>>>,
    pub count: Cell<usize>,
    /// Colours of models, by unit, number of the model and number of the witness.
    pub colours: RefCell<HashMap<(usize, usize, usize), Rc<Colours>>>,
}

/// The linear colours of a pixel without light, and under each replacement of each light alone, as they are needed.
pub struct Colours {
    pub dark: [f32; 3],
    pub lit: RefCell<Vec<Vec<Option<[f32; 3]>>>>,
}

impl Witnesses {
    /// How many were found so far.
    pub fn count(&self) -> usize {
        self.count.get()
    }
}
