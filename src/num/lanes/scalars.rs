//! Numbers and vectors for formulas, for any number of lanes.

use super::{Arithmetic, Eight, EightLanes, Lanes};
use std::ops::{Add, BitAnd, Div, Mul, Sub};

/// A number in every lane.
#[derive(Clone, Copy)]
pub(crate) struct Scalars<A: Arithmetic> {
    pub(crate) arch: A,
    pub(crate) value: A::Number,
}

impl<A: Arithmetic> Scalars<A> {
    #[inline(always)]
    pub(crate) fn new(arch: A, value: A::Number) -> Self {
        Self { arch, value }
    }

    /// The same number in every lane.
    #[inline(always)]
    pub(crate) fn splat(arch: A, x: f64) -> Self {
        Self::new(arch, arch.splat(x))
    }

    #[inline(always)]
    pub(crate) fn sqrt(self) -> Self {
        Self::new(self.arch, self.arch.sqrt(self.value))
    }

    #[inline(always)]
    pub(crate) fn abs(self) -> Self {
        Self::new(self.arch, self.arch.abs(self.value))
    }

    /// self < other; no for NaN.
    #[inline(always)]
    pub(crate) fn less(self, other: Self) -> Truth<A> {
        Truth { arch: self.arch, mask: self.arch.less(self.value, other.value) }
    }

    #[inline(always)]
    pub(crate) fn min(self, other: Self) -> Self {
        Self::new(self.arch, self.arch.min(other.value, self.value))
    }

    #[inline(always)]
    pub(crate) fn max(self, other: Self) -> Self {
        Self::new(self.arch, self.arch.max(other.value, self.value))
    }

    /// `(p, e)` with p = fl(ab) and p + e = ab exactly.
    #[inline(always)]
    fn two_product(self, other: Self) -> (Self, Self) {
        let product = self * other;
        let error = self.arch.product_error(self.value, other.value, product.value);
        (product, Self::new(self.arch, error))
    }

    /// `(d, e)` with d = fl(a−b) and d + e = a − b exactly (Knuth 1969).
    #[inline(always)]
    pub(crate) fn two_difference(self, other: Self) -> (Self, Self) {
        let difference = self - other;
        let taken = difference - self;
        (difference, (self - (difference - taken)) - (other + taken))
    }
}

impl<A: Lanes> Scalars<A> {
    #[inline(always)]
    pub(crate) fn load(arch: A, lanes: &Eight) -> Self {
        Self::new(arch, arch.load(&lanes.0))
    }

    #[inline(always)]
    pub(crate) fn store(self) -> Eight {
        Eight(self.arch.to_array(self.value))
    }

    /// Bits that this has or in which a and b differ.
    #[inline(always)]
    pub(crate) fn differences(self, a: Self, b: Self) -> Self {
        Self::new(self.arch, self.arch.differences(self.value, a.value, b.value))
    }
}

macro_rules! operators {
    ($($operator:ident: $method:ident),*) => {$(
        impl<A: Arithmetic> $operator for Scalars<A> {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self::new(self.arch, self.arch.$method(self.value, other.value))
            }
        }
    )*};
}

operators!(Add: add, Sub: sub, Mul: mul, Div: div);

/// A yes or no in every lane.
#[derive(Clone, Copy)]
pub(crate) struct Truth<A: Arithmetic> {
    arch: A,
    mask: A::Mask,
}

impl<A: Arithmetic> Truth<A> {
    /// `yes` where it is true, elsewhere `no`.
    #[inline(always)]
    pub(crate) fn select(self, yes: Scalars<A>, no: Scalars<A>) -> Scalars<A> {
        Scalars::new(self.arch, self.arch.select(self.mask, yes.value, no.value))
    }
}

impl<A: EightLanes> Truth<A> {
    /// One bit a row.
    #[inline(always)]
    pub(crate) fn row_bits(self) -> u8 {
        self.arch.row_bits(self.mask)
    }

    /// One bit a lane.
    #[inline(always)]
    pub(crate) fn lane_bits(self) -> u8 {
        self.arch.bits(self.mask)
    }
}

impl<A: Arithmetic> BitAnd for Truth<A> {
    type Output = Self;

    #[inline(always)]
    fn bitand(self, other: Self) -> Self {
        Self { arch: self.arch, mask: self.arch.and(self.mask, other.mask) }
    }
}

/// A vector in every lane.
#[derive(Clone, Copy)]
pub(crate) struct Vectors<A: Arithmetic> {
    pub(crate) x: Scalars<A>,
    pub(crate) y: Scalars<A>,
    pub(crate) z: Scalars<A>,
}

impl<A: Arithmetic> Vectors<A> {
    #[inline(always)]
    pub(crate) fn new(arch: A, [x, y, z]: [A::Number; 3]) -> Self {
        Self { x: Scalars::new(arch, x), y: Scalars::new(arch, y), z: Scalars::new(arch, z) }
    }

    /// a·b, added in the same order everywhere.
    #[inline(always)]
    pub(crate) fn dot(self, other: Self) -> Scalars<A> {
        (self.x * other.x + self.y * other.y) + self.z * other.z
    }

    #[inline(always)]
    pub(crate) fn squared_length(self) -> Scalars<A> {
        self.dot(self)
    }

    /// |x| + |y| + |z|: an upper bound of the length.
    #[inline(always)]
    pub(crate) fn sum_of_magnitudes(self) -> Scalars<A> {
        (self.x.abs() + self.y.abs()) + self.z.abs()
    }

    #[inline(always)]
    pub(crate) fn scaled(self, factor: Scalars<A>) -> Self {
        Self { x: self.x * factor, y: self.y * factor, z: self.z * factor }
    }

    /// u × v, each component with a relative error of at most 2u.
    #[inline(always)]
    pub(crate) fn cross(self, other: Self) -> Self {
        Self {
            x: difference_of_products(self.y, other.z, self.z, other.y),
            y: difference_of_products(self.z, other.x, self.x, other.z),
            z: difference_of_products(self.x, other.y, self.y, other.x),
        }
    }

    /// The same of vectors that have low parts, which correct it to first order.
    #[inline(always)]
    pub(crate) fn cross_with_low_parts(self, low: Self, other: Self, other_low: Self) -> Self {
        let ([ux, uy, uz], [vx, vy, vz]) = (self.parts(low), other.parts(other_low));
        Self { x: minor(uy, vz, uz, vy), y: minor(uz, vx, ux, vz), z: minor(ux, vy, uy, vx) }
    }

    /// Each component with its low part.
    #[inline(always)]
    fn parts(self, low: Self) -> [(Scalars<A>, Scalars<A>); 3] {
        [(self.x, low.x), (self.y, low.y), (self.z, low.z)]
    }

    /// The difference without error, as a high and a low part.
    #[inline(always)]
    pub(crate) fn two_difference(self, other: Self) -> (Self, Self) {
        let (x, y, z) =
            (self.x.two_difference(other.x), self.y.two_difference(other.y), self.z.two_difference(other.z));
        (Self { x: x.0, y: y.0, z: z.0 }, Self { x: x.1, y: y.1, z: z.1 })
    }
}

impl<A: Arithmetic> Sub for Vectors<A> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self { x: self.x - other.x, y: self.y - other.y, z: self.z - other.z }
    }
}

/// ab − cd; see [`difference_of_products`](crate::num::lanes::product::difference_of_products).
#[inline(always)]
fn difference_of_products<A: Arithmetic>(
    a: Scalars<A>,
    b: Scalars<A>,
    c: Scalars<A>,
    d: Scalars<A>,
) -> Scalars<A> {
    let ((p, ep), (q, eq)) = (a.two_product(b), c.two_product(d));
    (p - q) + (ep - eq)
}

/// The same of numbers with low parts.
#[inline(always)]
fn minor<A: Arithmetic>(
    a: (Scalars<A>, Scalars<A>),
    b: (Scalars<A>, Scalars<A>),
    c: (Scalars<A>, Scalars<A>),
    d: (Scalars<A>, Scalars<A>),
) -> Scalars<A> {
    let ((p, ep), (q, eq)) = (a.0.two_product(b.0), c.0.two_product(d.0));
    let correction = (a.0 * b.1 + a.1 * b.0) - (c.0 * d.1 + c.1 * d.0);
    (p - q) + ((ep - eq) + correction)
}
