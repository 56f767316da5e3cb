//! Running a kernel with the instructions that the CPU has.

use super::lanes::{Lanes, Plain};

/// Work that is compiled once for each way to compute.
///
/// `run` and everything hot that it calls must be `#[inline(always)]`: only what is inlined into the function
/// that enables the instructions is compiled with them. A call that is not inlined stays right, but is slow.
pub(crate) trait Kernel {
    /// What the work gives.
    type Output;

    /// Does the work.
    fn run<A: Lanes>(self, arch: A) -> Self::Output;
}

/// Runs a kernel with AVX-512 or with AVX2 and FMA where there is one of them, found out at run time.
#[cfg(target_arch = "x86_64")]
#[inline]
pub(crate) fn dispatch<K: Kernel>(kernel: K) -> K::Output {
    use super::lanes::{Avx2, Avx512};

    struct With<K, A> {
        kernel: K,
        arch: A,
    }

    impl<K: Kernel, A: Lanes> pulp::NullaryFnOnce for With<K, A> {
        type Output = K::Output;

        #[inline(always)]
        fn call(self) -> K::Output {
            self.kernel.run(self.arch)
        }
    }

    if let Some(arch) = Avx512::new() {
        arch.token().vectorize(With { kernel, arch })
    } else if let Some(arch) = Avx2::new() {
        arch.token().vectorize(With { kernel, arch })
    } else {
        portable(kernel)
    }
}

/// Runs a kernel with the instructions that every CPU of this target has. By itself, as without optimisation a kernel with all
/// that is inlined into it takes most of a megabyte of stack, and twice that does not fit into a thread's.
#[cfg(target_arch = "x86_64")]
#[inline(never)]
fn portable<K: Kernel>(kernel: K) -> K::Output {
    kernel.run(Plain::<f64, super::lanes::product::Split>::new())
}

/// Runs a kernel with the fused multiply-add that every CPU of this target has.
#[cfg(target_arch = "aarch64")]
#[inline]
pub(crate) fn dispatch<K: Kernel>(kernel: K) -> K::Output {
    kernel.run(Plain::<f64, super::lanes::product::Fused>::new())
}

/// Runs a kernel with SIMD128, if the program is compiled for it.
#[cfg(target_arch = "wasm32")]
#[inline]
pub(crate) fn dispatch<K: Kernel>(kernel: K) -> K::Output {
    #[cfg(target_feature = "simd128")]
    if let Some(arch) = super::lanes::Simd128::new() {
        return kernel.run(arch);
    }
    kernel.run(Plain::<f64, super::lanes::product::Split>::new())
}

/// Runs a kernel without fused multiply-add, which this target may not have.
#[cfg(not(any(target_arch = "x86_64", target_arch = "aarch64", target_arch = "wasm32")))]
#[inline]
pub(crate) fn dispatch<K: Kernel>(kernel: K) -> K::Output {
    kernel.run(Plain::<f64, super::lanes::product::Split>::new())
}
