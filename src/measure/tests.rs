use super::*;
use crate::base::simd::{Features, limit};
use crate::design::Sampler;
use crate::units::UNITS;

/// Inputs, words, reals, goldens and sums of every unit, bit for bit.
#[test]
fn figures_are_the_same_with_every_set_of_processor_features() {
    let inputs = Inputs { sampler: Sampler::Lit, samples: 2000, seed: 7 };
    for unit in UNITS.iter() {
        let design = unit.defaults().build().unwrap();
        // As text: every float has its own text, and all NaNs have the same.
        let figures = |features: &Features| {
            let measured = || measure(&[&design], &inputs, &|_| {}).unwrap();
            format!("{:#?}", limit::to(*features, measured)[0].figures)
        };
        let mut of_each = Features::here().iter().map(figures);
        let portable = of_each.next().unwrap();
        for other in of_each {
            assert!(other == portable, "{}:\n{portable}\n{other}", unit.name);
        }
    }
}
