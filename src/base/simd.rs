//! Loops compiled for several sets of processor features, chosen at run time.
//!
//! This module holds the only `unsafe` of the crate. The loops themselves are safe Rust; the
//! compiler is only allowed to use wider instructions for them. It fuses a multiplication and an
//! addition only where the code says `mul_add`, which rounds once on every processor. So all
//! feature sets give the same floats.

use std::sync::OnceLock;

/// A set of processor features that loops are compiled for.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Features {
    /// Features that every processor of the target has.
    Portable,
    /// AVX2, BMI2 and LZCNT.
    Avx2,
    /// AVX2's set, and AVX-512 F, BW, CD, DQ and VL.
    Avx512,
}

impl Features {
    /// The sets that this processor has, widest last.
    #[must_use]
    pub fn here() -> &'static [Self] {
        static HERE: OnceLock<Vec<Features>> = OnceLock::new();
        HERE.get_or_init(|| {
            let mut here = vec![Self::Portable];
            if has_avx2() {
                here.push(Self::Avx2);
            }
            if has_avx512() {
                here.push(Self::Avx512);
            }
            here
        })
    }

    /// The widest set that this processor has.
    #[must_use]
    pub fn best() -> Self {
        let best = Self::here().last().copied().unwrap_or(Self::Portable);
        #[cfg(test)]
        let best = best.min(limit::get());
        best
    }
}

/// Work whose loops are worth vectorising. `run` must be `#[inline(always)]`, so that it is
/// compiled for each set of features.
pub(crate) trait Body {
    /// Does the work.
    fn run(self);
}

/// Runs a body with the widest instructions of this processor.
pub(crate) fn vectorised<B: Body>(body: B) {
    vectorised_for(Features::best(), body);
}

/// Runs a body compiled for a set of features, or for the baseline if the processor lacks them.
pub(crate) fn vectorised_for<B: Body>(features: Features, body: B) {
    #[cfg(target_arch = "x86_64")]
    match features {
        Features::Avx512 if has_avx512() => {
            // SAFETY: `with_avx512` is safe code; calling it is sound where the processor has the
            // features that it is compiled for, which were just checked.
            #[expect(unsafe_code, reason = "calling code compiled for detected processor features")]
            unsafe {
                with_avx512(body);
            }
            return;
        }
        Features::Avx2 if has_avx2() => {
            // SAFETY: as above.
            #[expect(unsafe_code, reason = "calling code compiled for detected processor features")]
            unsafe {
                with_avx2(body);
            }
            return;
        }
        Features::Avx512 | Features::Avx2 | Features::Portable => {}
    }
    #[cfg(not(target_arch = "x86_64"))]
    let _ = features;
    body.run();
}

/// Prefetches the cache lines of a slice that is about to be read.
#[inline(always)]
pub(crate) fn prefetch<T>(slice: &[T]) {
    #[cfg(target_arch = "x86_64")]
    for part in slice.chunks((64 / size_of::<T>().max(1)).max(1)) {
        // SAFETY: a prefetch is a hint that reads nothing and never faults.
        #[expect(unsafe_code, reason = "a hint about memory")]
        unsafe {
            std::arch::x86_64::_mm_prefetch::<{ std::arch::x86_64::_MM_HINT_T0 }>(
                part.as_ptr().cast(),
            );
        }
    }
    #[cfg(not(target_arch = "x86_64"))]
    let _ = slice;
}

#[cfg(target_arch = "x86_64")]
#[inline]
fn has_avx2() -> bool {
    std::arch::is_x86_feature_detected!("avx2")
        && std::arch::is_x86_feature_detected!("bmi2")
        && std::arch::is_x86_feature_detected!("lzcnt")
}

#[cfg(target_arch = "x86_64")]
#[inline]
fn has_avx512() -> bool {
    has_avx2()
        && std::arch::is_x86_feature_detected!("fma")
        && std::arch::is_x86_feature_detected!("f16c")
        && std::arch::is_x86_feature_detected!("avx512f")
        && std::arch::is_x86_feature_detected!("avx512bw")
        && std::arch::is_x86_feature_detected!("avx512cd")
        && std::arch::is_x86_feature_detected!("avx512dq")
        && std::arch::is_x86_feature_detected!("avx512vl")
}

#[cfg(not(target_arch = "x86_64"))]
fn has_avx2() -> bool {
    false
}

#[cfg(not(target_arch = "x86_64"))]
fn has_avx512() -> bool {
    false
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,bmi2,lzcnt")]
fn with_avx2<B: Body>(body: B) {
    body.run();
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,bmi2,lzcnt,avx512f,avx512bw,avx512cd,avx512dq,avx512vl")]
fn with_avx512<B: Body>(body: B) {
    body.run();
}

/// Runs a body as a processor without AVX2 would, to test that path.
#[cfg(test)]
pub(crate) fn portable<B: Body>(body: B) {
    body.run();
}

/// Upper limit on [`Features::best`] in tests, for all threads. Other tests may run meanwhile, as
/// results don't depend on it.
#[cfg(test)]
pub(crate) mod limit {
    use super::Features;
    use std::sync::Mutex;

    static LIMIT: Mutex<Features> = Mutex::new(Features::Avx512);

    pub(super) fn get() -> Features {
        *LIMIT.lock().unwrap()
    }

    /// Runs `work` with instructions no wider than these.
    pub(crate) fn to<R>(features: Features, work: impl FnOnce() -> R) -> R {
        *LIMIT.lock().unwrap() = features;
        let result = work();
        *LIMIT.lock().unwrap() = Features::Avx512;
        result
    }
}
