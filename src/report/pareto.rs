//! The Pareto front.

/// Positions of the pairs that no other pair beats. A pair beats another if it is no larger in both
/// numbers and smaller in one. Equal pairs stay together; pairs with a NaN are left out. The result
/// is ascending in the first number, and equal pairs keep their order.
#[must_use]
pub fn pareto(costs: &[(f64, f64)]) -> Vec<usize> {
    let mut order: Vec<usize> =
        (0..costs.len()).filter(|i| !costs[*i].0.is_nan() && !costs[*i].1.is_nan()).collect();
    order.sort_by(|a, b| {
        let ((a0, a1), (b0, b1)) = (costs[*a], costs[*b]);
        a0.total_cmp(&b0).then(a1.total_cmp(&b1))
    });
    let mut front: Vec<usize> = Vec::new();
    for index in order {
        // The last of the front has the smallest second number so far.
        let beaten = front
            .last()
            .is_some_and(|last| costs[index].1 >= costs[*last].1 && costs[index] != costs[*last]);
        if !beaten {
            front.push(index);
        }
    }
    front
}
