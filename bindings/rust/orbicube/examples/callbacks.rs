//! What a call of the user's function costs through Rust: does what bench/bindings/callbacks.c does; run it with --release.

use std::time::Instant;

use orbicube::projected_gradient::{minimize, Problem};

fn rosenbrock(x: &[f64], gradient: &mut [f64]) -> f64 {
    let mut sum = 0.0;
    gradient.fill(0.0);
    for i in 0..x.len() - 1 {
        let (a, b) = (x[i + 1] - x[i] * x[i], 1.0 - x[i]);
        sum += 100.0 * a * a + b * b;
        gradient[i] -= 400.0 * x[i] * a + 2.0 * b;
        gradient[i + 1] += 200.0 * a;
    }
    sum
}

fn main() -> Result<(), orbicube::Error> {
    let start: Vec<f64> = (0..10).map(|i| if i % 2 == 0 { -1.2 } else { 1.0 }).collect();
    let mut recorded = vec![];
    let mut x = start.clone();
    minimize(|x: &[f64], gradient: &mut [f64]| {
        let value = rosenbrock(x, gradient);
        recorded.push((value, gradient.to_vec()));
        value
    }, &mut x, &Problem::default(), &Default::default())?;
    let mut best = f64::INFINITY;
    for _ in 0..1500 {
        let (mut next, mut x) = (0, start.clone());
        let begin = Instant::now();
        minimize(|_: &[f64], gradient: &mut [f64]| {
            let (value, slope) = &recorded[next];
            next += 1;
            gradient.copy_from_slice(slope);
            *value
        }, &mut x, &Problem::default(), &Default::default())?;
        best = best.min(begin.elapsed().as_nanos() as f64 / recorded.len() as f64);
        assert_eq!(next, recorded.len());
    }
    println!("Rust: {best:.0} ns an evaluation, {} evaluations a run", recorded.len());
    Ok(())
}
