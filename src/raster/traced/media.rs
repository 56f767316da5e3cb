//! The transmitting bodies that a ray is inside of.

/// Most bodies around one another; more are not remembered.
const MOST: usize = 8;

/// A list of objects, the one that was entered last at the end.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Media {
    objects: [u32; MOST],
    count: usize,
}

impl Media {
    /// The object entered last; `None` in air.
    pub(crate) fn inmost(&self) -> Option<usize> {
        self.count.checked_sub(1).map(|last| self.objects[last] as usize)
    }

    /// The list after the front of an object.
    pub(crate) fn entered(mut self, object: usize) -> Self {
        if self.count < MOST {
            self.objects[self.count] = object as u32;
            self.count += 1;
        }
        self
    }

    /// The list after the back of an object: a ray that starts inside was never seen to enter it.
    pub(crate) fn left(mut self, object: usize) -> Self {
        let inside = &self.objects[..self.count];
        if let Some(at) = inside.iter().rposition(|&inside| inside as usize == object) {
            self.objects.copy_within(at + 1..self.count, at);
            self.count -= 1;
        }
        self
    }

    pub(crate) fn holds(&self, object: usize) -> bool {
        self.objects[..self.count].contains(&(object as u32))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bodies_are_left_in_any_order() {
        let water = Media::default().entered(3);
        let both = water.entered(5);
        assert_eq!([Media::default(), water, both].map(|media| media.inmost()), [None, Some(3), Some(5)]);
        assert_eq!(both.left(3).inmost(), Some(5));
        assert_eq!(both.left(5).inmost(), Some(3));
        assert_eq!(both.left(7).inmost(), Some(5));
        assert!(both.holds(3) && !both.left(3).holds(3));
        let many = (0..20).fold(Media::default(), Media::entered);
        assert_eq!((0..20).fold(many, Media::left).inmost(), None);
    }
}
