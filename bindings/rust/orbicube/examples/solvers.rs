//! The example problems of examples/c in Rust: a fit without derivatives, a mix of feeds, points that repel each other.

use orbicube::{projected_gradient, sphere_optimizer, trust_region, Error};

/// Fits a / (1 + b t) + c to eight measurements, within bounds.
fn decay() -> Result<(), Error> {
    let model = |x: &[f64], t: f64| x[0] / (1.0 + x[1] * t) + x[2];
    let truth = [2.5, 0.7, 0.4];
    let problem = trust_region::Problem { lower: vec![0.0, 0.0, -1.0], upper: vec![10.0, 2.0, 1.0], ..Default::default() };
    let mut x = [1.0, 0.1, 0.0];
    let report = trust_region::least_squares(
        |x: &[f64], residuals: &mut [f64]| {
            for (i, residual) in residuals.iter_mut().enumerate() {
                *residual = model(x, 0.5 * i as f64) - model(&truth, 0.5 * i as f64);
            }
        },
        8, &mut x, &problem, &Default::default(),
    )?;
    println!("decay: {} after {} evaluations, {x:?}", report.stop_name(), report.evaluations);
    assert!(x.iter().zip(truth).all(|(a, b)| (a - b).abs() < 1e-7));
    Ok(())
}

/// The cheapest mix of five feeds that reaches a given share of protein.
fn feeds() -> Result<(), Error> {
    let (price, usual) = ([0.9, 0.3, 0.5, 1.4, 0.2], [0.2, 0.3, 0.2, 0.1, 0.2]);
    let (weight, protein) = ([2.0, 1.0, 3.0, 1.0, 4.0], [0.12, 0.09, 0.35, 0.44, 0.05]);
    let mut problem = projected_gradient::Problem::bounded(vec![0.0; 5], vec![0.6; 5]);
    problem.add_row(&[0, 1, 2, 3, 4].map(|j| (j, 1.0)), 1.0);
    problem.add_row(&[0, 1, 2, 3, 4].map(|j| (j, protein[j as usize])), 0.2);
    let mut x = [0.0; 5];
    let report = projected_gradient::minimize(
        |x: &[f64], gradient: &mut [f64]| {
            (0..5).map(|j| {
                let away = x[j] - usual[j];
                gradient[j] = price[j] + weight[j] * away;
                price[j] * x[j] + 0.5 * weight[j] * away * away
            }).sum::<f64>()
        },
        &mut x, &problem, &Default::default(),
    )?;
    println!("feeds: {} after {} evaluations, {x:?}", report.stop_name(), report.evaluations);
    assert!(report.converged() && report.equality_residual < 1e-14 && x.iter().all(|&share| share >= 0.0));
    Ok(())
}

/// Twelve points on a sphere that repel each other settle at the corners of an icosahedron.
fn charges() -> Result<(), Error> {
    let mut x: Vec<f64> = (0..36).map(|i| f64::from(i * i * 7 % 37) / 37.0 - 0.5).collect();
    let report = sphere_optimizer::minimize(
        |x: &[f64], gradient: &mut [f64]| {
            let mut energy = 0.0;
            gradient.fill(0.0);
            for i in (0..x.len()).step_by(3) {
                for j in (0..i).step_by(3) {
                    let away = [x[i] - x[j], x[i + 1] - x[j + 1], x[i + 2] - x[j + 2]];
                    let term = 1.0 / away.iter().map(|a| a * a).sum::<f64>();
                    energy += term;
                    for k in 0..3 {
                        gradient[i + k] -= 2.0 * term * term * away[k];
                        gradient[j + k] += 2.0 * term * term * away[k];
                    }
                }
            }
            energy
        },
        &mut x, 3, &Default::default(),
    )?;
    println!("charges: {} after {} evaluations, energy {:.9}", report.stop_name(), report.evaluations, report.value);
    assert!((report.value - 39.0).abs() < 1e-9);
    Ok(())
}

fn main() -> Result<(), Error> {
    decay()?;
    feeds()?;
    charges()
}
