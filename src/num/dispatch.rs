//! Running a kernel with the instructions that the CPU has: the one module of the crate with `unsafe` code.

use super::product::{Product, Split};

/// Work that is compiled once for each way to multiply exactly.
///
/// `run` and everything hot that it calls must be `#[inline(always)]`: only what is inlined into the function
/// that enables the instructions is compiled with them. A call that is not inlined stays right, but is slow.
pub(crate) trait Kernel {
    /// What the work gives.
    type Output;

    /// Does the work.
    fn run<P: Product>(self) -> Self::Output;
}

/// Runs a kernel with fused multiply-add where there is one, found out at run time on x86-64.
#[cfg(all(target_arch = "x86_64", not(target_feature = "fma")))]
#[inline]
#[allow(unsafe_code)]
pub(crate) fn dispatch<K: Kernel>(kernel: K) -> K::Output {
    use super::product::Fused;
    use std::is_x86_feature_detected as has;

    #[target_feature(enable = "avx512f,avx512vl,avx512dq,avx512bw,avx2,fma")]
    fn with_avx512<K: Kernel>(kernel: K) -> K::Output {
        kernel.run::<Fused>()
    }

    #[target_feature(enable = "avx2,fma")]
    fn with_avx2<K: Kernel>(kernel: K) -> K::Output {
        kernel.run::<Fused>()
    }

    let avx2 = has!("avx2") && has!("fma");
    if avx2 && has!("avx512f") && has!("avx512vl") && has!("avx512dq") && has!("avx512bw") {
        // SAFETY: the CPU has just been found to have every instruction set that the function is compiled with,
        // which is all that calling this otherwise safe function asks for.
        unsafe { with_avx512(kernel) }
    } else if avx2 {
        // SAFETY: as above.
        unsafe { with_avx2(kernel) }
    } else {
        kernel.run::<Split>()
    }
}

/// Runs a kernel with the fused multiply-add that every CPU of this target has.
#[cfg(any(target_arch = "aarch64", target_feature = "fma"))]
#[inline]
pub(crate) fn dispatch<K: Kernel>(kernel: K) -> K::Output {
    kernel.run::<super::product::Fused>()
}

/// Runs a kernel without fused multiply-add, which this target may not have.
#[cfg(not(any(target_arch = "x86_64", target_arch = "aarch64", target_feature = "fma")))]
#[inline]
pub(crate) fn dispatch<K: Kernel>(kernel: K) -> K::Output {
    kernel.run::<Split>()
}
