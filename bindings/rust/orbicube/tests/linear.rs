//! Sparse symmetric systems: residuals by products with the matrix, changes of a factor, iterations, panics, lifetimes.

use std::panic::{catch_unwind, AssertUnwindSafe};
use std::thread;

use orbicube::linear::{Direct, DirectOptions, Iterative, IterativeOptions, Matrix};
use orbicube::sys::base::{OBC_INVALID_ARGUMENT, OBC_NO_VALID_RESULT, OBC_UNSUPPORTED};
use orbicube::sys::linear::{OBC_LINEAR_CHOLMOD_SIMPLICIAL, OBC_LINEAR_GAUSS_SEIDEL, OBC_LINEAR_MULTIGRID};
use orbicube::{Error, Host};

type Entries = Vec<(u32, u32, f64)>;

/// The lower triangle of the Laplacian of an n by n grid plus 1/100.
fn grid(n: u32) -> Entries {
    let mut entries = vec![];
    for i in 0..n * n {
        let mut degree = 0.01;
        for (there, other) in [(i % n > 0, i.wrapping_sub(1)), (i >= n, i.wrapping_sub(n))] {
            if there {
                entries.push((i, other, -1.0));
                degree += 1.0;
            }
        }
        for there in [i % n + 1 < n, i + n < n * n] {
            degree += if there { 1.0 } else { 0.0 };
        }
        entries.push((i, i, degree));
    }
    entries
}

fn right(size: usize) -> Vec<f64> {
    (0..size).map(|i| ((i * i * 7 % 37) as f64) / 37.0 - 0.5).collect()
}

/// |b - A x| / |b|
fn residual(entries: &Entries, x: &[f64], b: &[f64]) -> f64 {
    let mut rest = b.to_vec();
    for &(row, column, value) in entries {
        rest[row as usize] -= value * x[column as usize];
        if row != column {
            rest[column as usize] -= value * x[row as usize];
        }
    }
    let norm = |v: &[f64]| v.iter().map(|entry| entry * entry).sum::<f64>().sqrt();
    norm(&rest) / norm(b)
}

#[test]
fn a_factor_solves_and_follows_changes() -> Result<(), Error> {
    let (n, mut entries) = (100, grid(10));
    let mut matrix = Matrix::from_entries(n, &entries)?;
    let mut factor = Direct::new(&matrix, &DirectOptions::default())?;
    let b = right(n);
    let x = factor.solve(&b)?;
    assert!(residual(&entries, &x, &b) < 1e-13);
    assert_eq!(factor.solve(&[b.clone(), b.clone()].concat())?, [x.clone(), x.clone()].concat());
    assert!(factor.entry_count() >= matrix.values().len() - n);

    let removed: Entries = entries.iter().copied().filter(|e| e.0 != 42 && e.1 != 42).chain([(42, 42, 1.0)]).collect();
    factor.remove_row(42)?;
    let held = factor.solve(&b)?;
    assert!(held[42] == b[42] && residual(&removed, &held, &b) < 1e-13);

    factor.update(&[11, 12], &[3.0, -2.0], 1)?;
    let updated: Entries = removed.iter().copied().chain([(11, 11, 9.0), (12, 11, -6.0), (12, 12, 4.0)]).collect();
    assert!(residual(&updated, &factor.solve(&b)?, &b) < 1e-12);
    factor.update(&[11, 12], &[3.0, -2.0], -1)?;
    assert!(residual(&removed, &factor.solve(&b)?, &b) < 1e-12);

    matrix.values_mut().iter_mut().for_each(|value| *value *= 2.0);
    entries.iter_mut().for_each(|entry| entry.2 *= 2.0);
    factor.refactor(matrix.values())?;
    assert!(residual(&entries, &factor.solve(&b)?, &b) < 1e-13);
    Ok(())
}

#[test]
fn entries_come_in_any_order_and_are_added() -> Result<(), Error> {
    let entries = grid(6);
    let mut halves: Entries = entries.iter().chain(&entries).map(|e| (e.0, e.1, e.2 / 2.0)).collect();
    halves.reverse();
    let matrix = Matrix::from_entries(36, &entries)?;
    assert_eq!(Matrix::from_entries(36, &halves)?, matrix);
    assert!(Matrix::from_entries(36, &[(3, 4, 1.0)]).is_err());
    assert!(Matrix::from_entries(36, &[(36, 0, 1.0)]).is_err());
    assert_eq!(Matrix::new(vec![0, 1, 3], vec![0, 0, 1], vec![2.0, 1.0, 3.0])?,
               Matrix::from_entries(2, &[(1, 1, 3.0), (1, 0, 1.0), (0, 0, 2.0)])?);
    for (begin, columns) in [(vec![], vec![]), (vec![1], vec![]), (vec![0, 2, 1], vec![0]), (vec![0, 1], vec![])] {
        let values = vec![1.0; columns.len()];
        assert_eq!(Matrix::new(begin, columns, values).unwrap_err().status, OBC_INVALID_ARGUMENT);
    }
    Ok(())
}

#[test]
fn what_cannot_be_solved_is_an_error_with_its_reason() -> Result<(), Error> {
    let options = DirectOptions::default();
    let missing = Matrix::from_entries(2, &[(0, 0, 1.0), (1, 0, 1.0)])?;
    let error = Direct::new(&missing, &options).err().expect("an error");
    assert!(error.status == OBC_INVALID_ARGUMENT && error.message.contains("row 1"), "{error}");
    let indefinite = Matrix::from_entries(2, &[(0, 0, 1.0), (1, 0, 2.0), (1, 1, 1.0)])?;
    assert_eq!(Direct::new(&indefinite, &options).err().expect("an error").status, OBC_NO_VALID_RESULT);

    let matrix = Matrix::from_entries(16, &grid(4))?;
    let mut factor = Direct::new(&matrix, &options)?;
    assert!(factor.solve(&[1.0; 15]).is_err() && factor.solve(&[f64::NAN; 16]).is_err());
    assert!(factor.remove_row(16).is_err() && factor.refactor(&[1.0]).is_err());
    assert!(factor.update(&[0, 15], &[1.0, 1.0], 1).is_err() && factor.update(&[0], &[1.0, 1.0], 1).is_err());
    assert_eq!(factor.update(&[0], &[100.0], -1).unwrap_err().status, OBC_NO_VALID_RESULT);
    assert_eq!(factor.solve(&[1.0; 16]).unwrap_err().status, OBC_INVALID_ARGUMENT);
    factor.refactor(matrix.values())?;
    assert!(residual(&grid(4), &factor.solve(&[1.0; 16])?, &[1.0; 16]) < 1e-13);

    let mut cholmod = DirectOptions::default();
    cholmod.method = OBC_LINEAR_CHOLMOD_SIMPLICIAL;
    match Direct::new(&matrix, &cholmod) {
        Ok(factor) => assert!(residual(&grid(4), &factor.solve(&[1.0; 16])?, &[1.0; 16]) < 1e-13),
        Err(error) => assert_eq!(error.status, OBC_UNSUPPORTED),
    }
    let empty = Direct::new(&Matrix::from_entries(0, &[])?, &options)?;
    assert!(empty.solve(&[])?.is_empty() && empty.solve(&[1.0]).is_err());
    Ok(())
}

#[test]
fn iterations_report_the_residual_that_they_reached() -> Result<(), Error> {
    let (entries, n) = (grid(60), 3600);
    let matrix = Matrix::from_entries(n, &entries)?;
    let b = right(n);
    for method in [OBC_LINEAR_GAUSS_SEIDEL, OBC_LINEAR_MULTIGRID] {
        for block_size in [1, 2, 3] {
            let mut options = IterativeOptions::default();
            options.method = method;
            options.block_size = block_size;
            options.tolerance = 1e-10;
            let mut solver = Iterative::new(&matrix, &options, &mut Host::new())?;
            let (x, report) = solver.solve(&b, &mut Host::new())?;
            let reached = residual(&entries, &x, &b);
            assert!(report.converged == 1 && reached < 1.001e-10, "{reached}");
            assert!((report.residual - reached).abs() < 1e-2 * reached);
            assert!(solver.solve(&b[1..], &mut Host::new()).is_err());
        }
    }
    let mut options = IterativeOptions::default();
    options.method = OBC_LINEAR_GAUSS_SEIDEL;
    options.max_iterations = 3;
    let (_, report) = Iterative::new(&matrix, &options, &mut Host::new())?.solve(&b, &mut Host::new())?;
    assert!(report.converged == 0 && report.iterations == 3 && report.residual > 1e-8);
    options.block_size = 4;
    assert!(Iterative::new(&matrix, &options, &mut Host::new()).is_err());
    Ok(())
}

#[test]
fn each_call_reports_to_its_own_closure() -> Result<(), Error> {
    let (entries, n) = (grid(200), 40000);
    let matrix = Matrix::from_entries(n, &entries)?;
    let (b, mut made, mut told) = (right(n), 0, 0);
    let mut solver = {
        let mut host = Host::new().on_progress(|_| {
            made += 1;
            true
        });
        Iterative::new(&matrix, &Default::default(), &mut host)? // which outlives its closure
    };
    assert!(made > 0);
    let mut host = Host::new().on_progress(|_| {
        told += 1;
        true
    });
    let (x, _) = solver.solve(&b, &mut host)?;
    drop(host);
    assert!(told > 0);
    let cancelled = solver.solve(&b, &mut Host::new().on_progress(|_| false));
    assert!(cancelled.err().expect("cancelled").is_cancelled());
    let panicked = catch_unwind(AssertUnwindSafe(|| solver.solve(&b, &mut Host::new().on_progress(|_| panic!("mine")))));
    assert_eq!(panicked.err().expect("a panic").downcast_ref::<&str>(), Some(&"mine"));

    // Another thread may go on with it.
    let again = thread::spawn(move || solver.solve(&b, &mut Host::new()).map(|(x, _)| x)).join().expect("no panic")?;
    assert_eq!(again, x);
    Ok(())
}
