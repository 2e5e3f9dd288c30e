//! The bits of C, reverse communication, panics, failed evaluations, threads.

use std::collections::HashMap;
use std::panic::{catch_unwind, AssertUnwindSafe};
use std::process::Command;

use orbicube::{projected_gradient, sphere_optimizer, trust_region, Answer, Evaluation};

fn model(x: &[f64], i: usize) -> f64 {
    x[0] / (1.0 + x[1] * (0.5 * i as f64)) + x[2]
}

fn misfit(x: &[f64], residuals: &mut [f64]) {
    for (i, residual) in residuals.iter_mut().enumerate() {
        *residual = model(x, i) - model(&[2.5, 0.7, 0.4], i);
    }
}

fn decay() -> trust_region::Problem {
    trust_region::Problem { lower: vec![0.0, 0.0, -1.0], upper: vec![10.0, 2.0, 1.0], ..Default::default() }
}

fn cost(x: &[f64], gradient: &mut [f64]) -> f64 {
    let price = [0.9, 0.3, 0.5, 1.4, 0.2];
    let usual = [0.2, 0.3, 0.2, 0.1, 0.2];
    let weight = [2.0, 1.0, 3.0, 1.0, 4.0];
    let mut sum = 0.0;
    for j in 0..x.len() {
        let away = x[j] - usual[j];
        sum += price[j] * x[j] + 0.5 * weight[j] * away * away;
        gradient[j] = price[j] + weight[j] * away;
    }
    sum
}

fn feeds() -> projected_gradient::Problem {
    let mut problem = projected_gradient::Problem::bounded(vec![0.0; 5], vec![0.6; 5]);
    problem.add_row(&[(0, 1.0), (1, 1.0), (2, 1.0), (3, 1.0), (4, 1.0)], 1.0);
    problem.add_row(&[(0, 0.12), (1, 0.09), (2, 0.35), (3, 0.44), (4, 0.05)], 0.2);
    problem
}

fn charges(x: &[f64], gradient: &mut [f64]) -> f64 {
    let mut sum = 0.0;
    gradient.fill(0.0);
    for i in (0..x.len()).step_by(3) {
        for j in (0..i).step_by(3) {
            let away = [x[i] - x[j], x[i + 1] - x[j + 1], x[i + 2] - x[j + 2]];
            let square = away[0] * away[0] + away[1] * away[1] + away[2] * away[2];
            let term = 1.0 / square;
            sum += term;
            for k in 0..3 {
                let pull = 2.0 * term * term * away[k];
                gradient[i + k] -= pull;
                gradient[j + k] += pull;
            }
        }
    }
    sum
}

fn scattered() -> Vec<f64> {
    (0..36).map(|i| f64::from(i * i * 7 % 37) / 37.0 - 0.5).collect()
}

/// What the C program ends in that solves the same problems: evaluations and bits, by name. None where it is not built.
fn from_c() -> Option<HashMap<String, (u64, Vec<u64>)>> {
    let program = std::env::var_os("ORBICUBE_PROBLEMS")?;
    let printed = String::from_utf8(Command::new(program).output().unwrap().stdout).unwrap();
    Some(printed.lines().map(|line| {
        let words: Vec<&str> = line.split(' ').collect();
        let bits = words[2..].iter().map(|word| u64::from_str_radix(word, 16).unwrap()).collect();
        (words[0].to_string(), (words[1].parse().unwrap(), bits))
    }).collect())
}

fn bits(x: &[f64]) -> Vec<u64> {
    x.iter().map(|value| value.to_bits()).collect()
}

#[test]
fn closures_and_questions_end_in_the_bits_of_c() {
    let mut x = [1.0, 0.1, 0.0];
    let report = trust_region::least_squares(misfit, 8, &mut x, &decay(), &Default::default()).unwrap();
    assert!(report.converged());
    let mut solver = trust_region::Solver::new(&[1.0, 0.1, 0.0], 8, &decay(), &Default::default()).unwrap();
    let mut residuals = [0.0; 8];
    while let Some(at) = solver.ask().unwrap() {
        misfit(at, &mut residuals);
        solver.tell(&residuals).unwrap();
        solver = trust_region::Solver::load(&solver.save().unwrap(), 3, 8, &decay()).unwrap();
    }
    assert_eq!(bits(&solver.best().unwrap()), bits(&x));

    let mut y = [0.0; 5];
    let feeds_report = projected_gradient::minimize(cost, &mut y, &feeds(), &Default::default()).unwrap();
    let mut solver = projected_gradient::Solver::new(&[0.0; 5], &feeds(), &Default::default()).unwrap();
    let mut gradient = [0.0; 5];
    while let Some(at) = solver.ask().unwrap() {
        let value = cost(at, &mut gradient);
        solver.tell(value, &gradient).unwrap();
        solver = projected_gradient::Solver::load(&solver.save().unwrap(), 5, &feeds()).unwrap();
    }
    assert_eq!(bits(&solver.best().unwrap()), bits(&y));
    let multipliers = solver.multipliers().unwrap();
    cost(&y, &mut gradient);
    let slope = gradient[1] - multipliers[0] - multipliers[1] * 0.09;
    assert!(slope.abs() < 1e-7, "{slope}"); // gradient_tolerance is 1e-8

    let mut z = scattered();
    let charges_report = sphere_optimizer::minimize(charges, &mut z, 3, &Default::default()).unwrap();
    let mut solver = sphere_optimizer::Solver::new(&scattered(), 3, &Default::default()).unwrap();
    let mut gradient = [0.0; 36];
    while let Some(at) = solver.ask().unwrap() {
        let value = charges(at, &mut gradient);
        solver.tell(value, &gradient).unwrap();
        solver = sphere_optimizer::Solver::load(&solver.save().unwrap()).unwrap();
    }
    assert_eq!(bits(&solver.best().unwrap()), bits(&z));

    match from_c() {
        None => println!("ORBICUBE_PROBLEMS is not set: not compared with C"),
        Some(expected) => {
            assert_eq!(expected["decay"], (report.evaluations, bits(&x)));
            assert_eq!(expected["feeds"], (feeds_report.evaluations, bits(&y)));
            assert_eq!(expected["icosahedron"], (charges_report.evaluations, bits(&z)));
        }
    }
}

fn panics(f: impl FnOnce()) -> String {
    let panic = catch_unwind(AssertUnwindSafe(f)).expect_err("no panic came through");
    panic.downcast_ref::<&str>().expect("a text").to_string()
}

#[test]
fn a_panic_stops_the_run_and_goes_on_after_it() {
    let calls = std::cell::Cell::new(0);
    let said = panics(|| {
        let _ = trust_region::minimize(|x: &[f64]| {
            calls.set(calls.get() + 1);
            if calls.get() == 7 {
                panic!("in f");
            }
            x[0] * x[0]
        }, &mut [3.0], &Default::default(), &Default::default());
    });
    assert_eq!((said.as_str(), calls.get()), ("in f", 7)); // not called again after the panic
    assert_eq!(panics(|| {
        let _ = projected_gradient::minimize(|_: &[f64], _: &mut [f64]| -> f64 { panic!("in f") }, &mut [3.0],
                                             &Default::default(), &Default::default());
    }), "in f");
    assert_eq!(panics(|| {
        let _ = projected_gradient::minimize_over(|x: &[f64], g: &mut [f64]| { g[0] = 1.0; x[0] }, &mut [3.0],
                                                  |_: &[f64], _: &mut [f64]| panic!("in the projection"), &Default::default());
    }), "in the projection");
    assert_eq!(panics(|| {
        let _ = sphere_optimizer::relax(|_: sphere_optimizer::Part| -> f64 { panic!("in a part") }, &mut [1.0, 0.0], 2,
                                        &[vec![]], &Default::default());
    }), "in a part");
}

#[test]
fn a_function_may_stop_or_have_no_value() {
    let mut calls = 0;
    let mut x = [-1.2, 1.0];
    let report = trust_region::minimize(|x: &[f64]| {
        calls += 1;
        match calls {
            5 => Evaluation::Failed,
            21 => Evaluation::Stop,
            _ => Evaluation::Value((x[0] - 1.0).powi(2) + x[1] * x[1]),
        }
    }, &mut x, &Default::default(), &Default::default()).unwrap();
    assert_eq!((report.stop_name().as_str(), report.failed_evaluations), ("cancelled", 1));
    assert_eq!((x[0] - 1.0).powi(2) + x[1] * x[1], report.value);
    // A value that comes with it counts.
    let mut x = [0.0, 0.0];
    let report = trust_region::minimize(|x: &[f64]| {
        let value = (x[0] - 1.0).powi(2) + (x[1] - 1.0).powi(2);
        if value < 1e-3 { Evaluation::StopAt(value) } else { Evaluation::Value(value) }
    }, &mut x, &Default::default(), &Default::default()).unwrap();
    assert!(report.stop_name() == "cancelled" && report.value < 1e-3);
    assert_eq!((x[0] - 1.0).powi(2) + (x[1] - 1.0).powi(2), report.value);
    let report = trust_region::least_squares(|_: &[f64], _: &mut [f64]| Answer::Stop, 2, &mut x, &Default::default(),
                                             &Default::default()).unwrap();
    assert_eq!(report.stop_name(), "cancelled");
}

/// What packages of optimizers have as the trait of a problem: nothing of this crate.
struct Cup {
    center: Vec<f64>,
}

impl Cup {
    fn cost(&self, x: &Vec<f64>) -> Result<f64, String> {
        if x[0] > 2.0 {
            return Err("outside of the domain".into());
        }
        Ok(x.iter().zip(&self.center).map(|(a, b)| (a - b).powi(2)).sum())
    }
    fn gradient(&self, x: &Vec<f64>) -> Result<Vec<f64>, String> {
        Ok(x.iter().zip(&self.center).map(|(a, b)| 2.0 * (a - b)).collect())
    }
    fn differences(&self, x: &[f64], out: &mut [f64]) -> Result<(), String> {
        self.gradient(&x.to_vec()).map(|all| out.copy_from_slice(&all))
    }
}

#[test]
fn methods_of_a_problem_that_return_results() {
    let cup = Cup { center: vec![1.0, -2.0] };
    let mut x = [3.0, 0.0]; // which has no value: a chain cannot begin there
    let report = trust_region::minimize(|x: &[f64]| cup.cost(&x.to_vec()), &mut x, &Default::default(), &Default::default()).unwrap();
    assert_eq!((report.stop_name().as_str(), report.failed_evaluations), ("evaluation failed", 1));
    let mut x = [1.9, 0.0];
    let report = trust_region::minimize(|x: &[f64]| cup.cost(&x.to_vec()), &mut x, &Default::default(), &Default::default()).unwrap();
    assert!(report.converged() && (x[0] - 1.0).abs() < 1e-6 && (x[1] + 2.0).abs() < 1e-6);
    let mut y = [1.9, 0.0];
    let report = projected_gradient::minimize(
        |y: &[f64], gradient: &mut [f64]| {
            gradient.copy_from_slice(&cup.gradient(&y.to_vec())?);
            cup.cost(&y.to_vec())
        },
        &mut y, &Default::default(), &Default::default(),
    ).unwrap();
    assert!(report.converged() && (y[0] - 1.0).abs() < 1e-7 && (y[1] + 2.0).abs() < 1e-7);
    let mut z = [1.9, 0.0];
    let report = trust_region::least_squares(|z: &[f64], out: &mut [f64]| cup.differences(z, out), 2, &mut z, &Default::default(),
                                             &Default::default()).unwrap();
    assert!(report.converged() && report.value < 1e-12);
    let report = trust_region::minimize(|_: &[f64]| None, &mut z, &Default::default(), &Default::default()).unwrap();
    assert_eq!(report.stop_name(), "evaluation failed");
}

#[test]
fn projections() {
    let mut x = [0.0, 0.0];
    projected_gradient::minimize_over(
        |x: &[f64], g: &mut [f64]| {
            g[0] = 2.0 * (x[0] - 3.0);
            g[1] = 2.0 * (x[1] - 4.0);
            (x[0] - 3.0).powi(2) + (x[1] - 4.0).powi(2)
        },
        &mut x,
        |y: &[f64], x: &mut [f64]| {
            let length = y[0].hypot(y[1]).max(1.0);
            x[0] = y[0] / length;
            x[1] = y[1] / length;
        },
        &Default::default()).unwrap();
    assert!((x[0] - 0.6).abs() < 1e-7 && (x[1] - 0.8).abs() < 1e-7); // gradient_tolerance is 1e-8

    let mut problem = projected_gradient::Problem::bounded(vec![0.0; 2], vec![]);
    problem.add_row(&[(0, 1.0), (1, 1.0)], 1.0);
    let (x, multipliers, _) = projected_gradient::project(&[2.0, 2.0], &problem, &mut orbicube::Host::new()).unwrap();
    assert!((x[0] - 0.5).abs() < 1e-15 && (multipliers[0] + 1.5).abs() < 1e-15); // a root of a linear function

    let mut impossible = projected_gradient::Problem::bounded(vec![0.0], vec![]);
    impossible.add_row(&[(0, 1.0)], -1.0);
    let mut solver = projected_gradient::Solver::new(&[0.0], &impossible, &Default::default()).unwrap();
    assert!(solver.ask().unwrap().is_none());
    assert_eq!(solver.report().unwrap().stop_name(), "infeasible");
    assert!(solver.certificate().unwrap()[0] < 0.0);
}

fn others() -> Vec<Vec<u32>> {
    (0..12).map(|i| (0..12).filter(|&j| j != i).collect()).collect()
}

/// The part of `charges` that has one of them.
#[test]
fn products_of_the_hessian() {
    let stiffness = [3.0, 1.0, 2.0, 5.0]; // the minimum is 1
    let quotient = |x: &[f64], gradient: &mut [f64]| {
        (0..4).map(|k| { gradient[k] = 2.0 * stiffness[k] * x[k]; stiffness[k] * x[k] * x[k] }).sum::<f64>()
    };
    let product = |_: &[f64], direction: &[f64], out: &mut [f64]| (0..4).for_each(|k| out[k] = 2.0 * stiffness[k] * direction[k]);
    let mut x = [1.0; 4];
    let report = sphere_optimizer::minimize_second_order(quotient, product, &mut x, 4, &Default::default()).unwrap();
    assert!(report.converged() && report.products > 0);
    assert!((report.value - 1.0).abs() < 1e-12);

    let mut options = sphere_optimizer::Options::default();
    options.method = orbicube::sys::sphere_optimizer::OBC_SPHERE_OPTIMIZER_TRUNCATED_NEWTON;
    options.hessian_products = 1;
    let mut solver = sphere_optimizer::Solver::new(&[1.0; 4], 4, &options).unwrap();
    let mut numbers = [0.0; 4];
    while let Some(at) = solver.ask().unwrap().map(|at| at.to_vec()) {
        match solver.direction().map(|direction| direction.to_vec()) {
            None => {
                let value = quotient(&at, &mut numbers);
                solver.tell(value, &numbers).unwrap();
            }
            Some(direction) => {
                product(&at, &direction, &mut numbers);
                solver.tell_product(&numbers).unwrap();
            }
        }
    }
    assert_eq!(bits(&solver.best().unwrap()), bits(&x));
}

fn charge(part: sphere_optimizer::Part) -> f64 {
    let (mut value, mut slope) = (0.0, [0.0; 3]);
    for (j, other) in part.points.chunks(3).enumerate() {
        if j != part.block {
            let away = [part.place[0] - other[0], part.place[1] - other[1], part.place[2] - other[2]];
            let term = 1.0 / (away[0] * away[0] + away[1] * away[1] + away[2] * away[2]);
            value += term;
            for k in 0..3 {
                slope[k] -= 2.0 * term * term * away[k];
            }
        }
    }
    if let Some(gradient) = part.gradient {
        gradient.copy_from_slice(&slope);
    }
    value
}

#[test]
fn block_by_block() {
    let mut x = scattered();
    let report = sphere_optimizer::relax(charge, &mut x, 3, &others(), &Default::default()).unwrap();
    assert_eq!((report.converged(), report.stop_name().as_str()), (true, "converged"));
    assert!((charges(&x, &mut [0.0; 36]) - 39.0).abs() < 1e-9);
}

#[test]
fn block_by_block_in_parts_that_are_broken_off_saved_and_loaded() {
    use sphere_optimizer::{Part, Relaxation};

    let mut whole = scattered();
    let end = sphere_optimizer::relax(charge, &mut whole, 3, &others(), &Default::default()).unwrap();
    let mut relaxation = Relaxation::new(&scattered(), 3, &others(), &Default::default()).unwrap();
    let report = relaxation.report().unwrap();
    assert_eq!((report.running(), report.stop_name().as_str()), (true, "running"));
    assert_eq!(relaxation.run(charge, 10).unwrap().steps, 10);
    assert_eq!(panics(|| {
        let _ = relaxation.run(|_: Part| -> f64 { panic!("in a part") }, 10);
    }), "in a part");
    assert_eq!(relaxation.run(|_: Part| Evaluation::Stop, 10).unwrap().stop_name(), "cancelled");
    let saved = relaxation.save().unwrap();
    let mut again = std::thread::spawn(move || {
        let mut again = Relaxation::load(&saved, 3, &others()).unwrap();
        again.run(charge, 1).unwrap();
        again
    }).join().unwrap();
    for one in [&mut relaxation, &mut again] {
        while one.run(charge, 25).unwrap().running() {}
        let report = one.report().unwrap();
        assert_eq!((report.stop, report.steps), (end.stop, end.steps));
        assert_eq!((report.gain.to_bits(), bits(&one.points().unwrap())), (end.gain.to_bits(), bits(&whole)));
    }

    let saved = relaxation.save().unwrap();
    let refused = |bytes: &[u8], dimension, neighbors: &[Vec<u32>]| {
        Relaxation::load(bytes, dimension, neighbors).err().unwrap().status
    };
    assert_eq!(refused(&saved, 3, &vec![vec![]; 12]), orbicube::sys::base::OBC_INVALID_ARGUMENT); // other neighbors
    assert_eq!(refused(&saved, 4, &others()), orbicube::sys::base::OBC_INVALID_ARGUMENT);
    assert_eq!(refused(&saved[..20], 3, &others()), orbicube::sys::base::OBC_MALFORMED_FILE);
    assert!(Relaxation::new(&scattered(), 4, &others(), &Default::default()).is_err());
}

#[test]
fn wrong_arguments_are_errors() {
    let error = trust_region::Solver::new(&[f64::NAN], 0, &Default::default(), &Default::default()).err().unwrap();
    assert_eq!(error.status, orbicube::sys::base::OBC_INVALID_ARGUMENT);
    assert!(trust_region::Solver::load(b"nothing", 1, 0, &Default::default()).is_err());
    assert!(trust_region::minimize(|_: &[f64]| 0.0, &mut [0.0; 2], &decay(), &Default::default()).is_err());
    let mut solver = trust_region::Solver::new(&[0.0], 0, &Default::default(), &Default::default()).unwrap();
    assert!(solver.tell(&[1.0]).is_err(), "no request waits");
    assert!(solver.tell(&[1.0, 2.0]).is_err());
    assert!(sphere_optimizer::Solver::new(&[1.0; 4], 3, &Default::default()).is_err());
}

#[test]
fn a_run_may_move_to_another_thread() {
    let mut solver = trust_region::Solver::new(&[0.0], 0, &Default::default(), &Default::default()).unwrap();
    let best = std::thread::spawn(move || {
        while let Some(x) = solver.ask().unwrap() {
            let value = (x[0] - 2.0).powi(2);
            solver.tell(&[value]).unwrap();
        }
        solver.best().unwrap()
    }).join().unwrap();
    assert!((best[0] - 2.0).abs() < 1e-7);
}
