//! Loops compiled twice: for the baseline processor and for AVX2, chosen at run time.
//!
//! This module holds the only `unsafe` of the crate. What runs is safe Rust; the compiler may
//! only use wider instructions for it. No fused multiply-add is enabled, so both give the same
//! floats.

/// Work whose loops are worth vectorising; `run` must be `#[inline(always)]`, so that it is
/// compiled anew inside [`vectorised`].
pub(crate) trait Body {
    /// Does the work.
    fn run(self);
}

/// Runs a body with the widest instructions that the processor has.
pub(crate) fn vectorised<B: Body>(body: B) {
    #[cfg(target_arch = "x86_64")]
    if std::arch::is_x86_feature_detected!("avx2")
        && std::arch::is_x86_feature_detected!("bmi2")
        && std::arch::is_x86_feature_detected!("lzcnt")
    {
        // SAFETY: `with_avx2` is safe code; calling it is sound where the processor has the
        // features that it is compiled for, which was checked just now.
        #[expect(unsafe_code, reason = "calling code compiled for detected processor features")]
        unsafe {
            with_avx2(body);
        }
        return;
    }
    body.run();
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,bmi2,lzcnt")]
fn with_avx2<B: Body>(body: B) {
    body.run();
}

/// Runs a body as a processor without AVX2 would, to test that path.
#[cfg(test)]
pub(crate) fn portable<B: Body>(body: B) {
    body.run();
}
