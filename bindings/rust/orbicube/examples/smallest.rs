//! One solver and nothing else: `--no-default-features --features trust_region`.

use orbicube::trust_region::minimize;

fn main() -> Result<(), orbicube::Error> {
    let mut x = [0.0, 0.0];
    let report = minimize(|x: &[f64]| (x[0] - 1.0).powi(2) + (x[1] + 2.0).powi(2), &mut x, &Default::default(), &Default::default())?;
    println!("{} after {} evaluations: {x:?}", report.stop_name(), report.evaluations);
    assert!((x[0] - 1.0).abs() < 1e-6 && (x[1] + 2.0).abs() < 1e-6); // radius_end is 1e-8, f is quadratic
    Ok(())
}
