//! Minimizes f(x), or a sum of squares of residuals, within bounds, from values alone.
//!
//! ```
//! use orbicube::trust_region::{least_squares, Problem};
//!
//! // Eight measurements of a / (1 + b t) + c.
//! let model = |x: &[f64], t: f64| x[0] / (1.0 + x[1] * t) + x[2];
//! let mut x = [1.0, 0.1, 0.0];
//! let problem = Problem { lower: vec![0.0, 0.0, -1.0], upper: vec![10.0, 2.0, 1.0], ..Problem::default() };
//! let report = least_squares(
//!     |x: &[f64], residuals: &mut [f64]| {
//!         for (i, residual) in residuals.iter_mut().enumerate() {
//!             *residual = model(x, 0.5 * i as f64) - model(&[2.5, 0.7, 0.4], 0.5 * i as f64);
//!         }
//!     },
//!     8, &mut x, &problem, &Default::default(),
//! )?;
//! assert!(report.converged() && (x[1] - 0.7).abs() < 1e-7);
//! # Ok::<(), orbicube::Error>(())
//! ```

use std::os::raw::c_void;
use std::slice;

use crate::call::{checked, expect_length, pointer, rows, text, Answer, Caught, Error, Evaluation};
use crate::sys::trust_region::*;

filled!(/// Options, with their defaults.
    Options, obc_trust_region_options, obc_trust_region_options_init);
sized!(/// How a run ended, with all figures.
    Report, obc_trust_region_result);

impl Report {
    pub fn converged(&self) -> bool {
        self.stop == OBC_TRUST_REGION_CONVERGED
    }
    /// Why the run ended, such as "evaluation budget".
    pub fn stop_name(&self) -> String {
        text(unsafe { obc_trust_region_stop_name(self.stop) })
    }
}

/// What is minimized, beside the function; an empty vector: none.
#[derive(Clone, Debug, Default)]
pub struct Problem {
    pub lower: Vec<f64>,
    pub upper: Vec<f64>,
    /// Typical magnitudes of the unknowns.
    pub scale: Vec<f64>,
    /// 1 or -1 a residual: how squares are summed.
    pub sign: Vec<f64>,
    /// What f is of residuals: `OBC_TRUST_REGION_SUM_OF_SQUARES` or another constant.
    pub objective: i32,
}

impl Problem {
    fn filled(&self, n: usize, residuals: usize) -> Result<obc_trust_region_problem, Error> {
        let mut problem: obc_trust_region_problem = unsafe { std::mem::zeroed() };
        unsafe { obc_trust_region_problem_init(&mut problem, std::mem::size_of::<obc_trust_region_problem>()) };
        for (what, array, wanted) in [
            ("lower", &self.lower, n), ("upper", &self.upper, n), ("scale", &self.scale, n), ("sign", &self.sign, residuals),
        ] {
            if !array.is_empty() {
                expect_length(array.len(), wanted, what)?;
            }
        }
        problem.n = n;
        problem.residuals = residuals;
        problem.lower = pointer(&self.lower);
        problem.upper = pointer(&self.upper);
        problem.scale = pointer(&self.scale);
        problem.sign = pointer(&self.sign);
        problem.objective = self.objective;
        Ok(problem)
    }
}

struct Function<F> {
    f: F,
    outputs: usize,
    caught: Caught,
}

unsafe extern "C" fn called<F: FnMut(&[f64], &mut [f64]) -> i32>(x: *const f64, n: usize, outputs: *mut f64,
                                                                 user: *mut c_void) -> i32 {
    let Function { f, outputs: count, caught } = &mut *(user as *mut Function<F>);
    caught.guard(|| f(slice::from_raw_parts(x, n), slice::from_raw_parts_mut(outputs, *count)))
}

fn run<F: FnMut(&[f64], &mut [f64]) -> i32>(f: F, residuals: usize, x: &mut [f64], problem: &Problem,
                                            options: &Options) -> Result<Report, Error> {
    let filled = problem.filled(x.len(), residuals)?;
    let mut function = Function { f, outputs: residuals.max(1), caught: Caught::default() };
    let mut report = Report::default();
    let result = checked(|error| unsafe {
        obc_trust_region_minimize(&filled, &options.0, Some(called::<F>), &mut function as *mut Function<F> as *mut c_void,
                                  x.as_mut_ptr(), &mut report.0, std::ptr::null(), error)
    });
    function.caught.resume();
    result.map(|_| report)
}

/// The minimum value of `f` that is found from `x`, which receives the point. `f` returns a number or an [`Evaluation`].
pub fn minimize<E: Into<Evaluation>>(mut f: impl FnMut(&[f64]) -> E, x: &mut [f64], problem: &Problem,
                                     options: &Options) -> Result<Report, Error> {
    run(|x, outputs| f(x).into().code(&mut outputs[0]), 0, x, problem, options)
}

/// The minimum sum of squares, or what else the problem's objective is, of `count` residuals, which `f` fills; it returns nothing or an [`Answer`].
pub fn least_squares<A: Into<Answer>>(mut f: impl FnMut(&[f64], &mut [f64]) -> A, count: usize, x: &mut [f64],
                                      problem: &Problem, options: &Options) -> Result<Report, Error> {
    if count == 0 {
        return Err(Error::invalid("no residuals"));
    }
    run(|x, outputs| f(x, outputs).into().code(), count, x, problem, options)
}

handle!(Handle, obc_trust_region, obc_trust_region_destroy);

/// A run by reverse communication.
///
/// ```
/// use orbicube::trust_region::{Problem, Solver};
/// let mut solver = Solver::new(&[0.0, 0.0], 0, &Problem::default(), &Default::default())?;
/// while let Some(x) = solver.ask()? {
///     let value = (x[0] - 1.0).powi(2) + x[1].powi(2);
///     solver.tell(&[value])?;
/// }
/// assert!((solver.best()?[0] - 1.0).abs() < 1e-6);
/// # Ok::<(), orbicube::Error>(())
/// ```
///
/// One thread at a time uses it, so it is not `Sync`:
///
/// ```compile_fail
/// fn sync<T: Sync>() {}
/// sync::<orbicube::trust_region::Solver>();
/// ```
pub struct Solver {
    handle: Handle,
    n: usize,
    outputs: usize,
}

// Distinct solvers may be used at the same time, one by one thread at a time; nothing in them belongs to a thread.
unsafe impl Send for Solver {}

impl Solver {
    /// `residuals`: their number, 0 for one value.
    pub fn new(x0: &[f64], residuals: usize, problem: &Problem, options: &Options) -> Result<Solver, Error> {
        let filled = problem.filled(x0.len(), residuals)?;
        let mut out = std::ptr::null_mut();
        checked(|error| unsafe {
            obc_trust_region_create(&filled, &options.0, x0.as_ptr(), std::ptr::null(), &mut out, error)
        })?;
        Ok(Solver { handle: Handle::own(out), n: x0.len(), outputs: residuals.max(1) })
    }
    /// Goes on with a run that was saved, of the same problem.
    pub fn load(bytes: &[u8], unknowns: usize, residuals: usize, problem: &Problem) -> Result<Solver, Error> {
        let filled = problem.filled(unknowns, residuals)?;
        let mut out = std::ptr::null_mut();
        checked(|error| unsafe {
            obc_trust_region_load(&filled, bytes.as_ptr() as *const c_void, bytes.len(), std::ptr::null(), &mut out, error)
        })?;
        Ok(Solver { handle: Handle::own(out), n: unknowns, outputs: residuals.max(1) })
    }
    /// The point at which f, or the residuals, are requested next; `None` when the run has ended.
    pub fn ask(&mut self) -> Result<Option<&[f64]>, Error> {
        let n = self.n;
        Ok(self.ask_all()?.map(|points| &points[..n]))
    }
    /// All points that may be evaluated at the same time, one after the other; tell each in order.
    pub fn ask_all(&mut self) -> Result<Option<&[f64]>, Error> {
        let (mut points, mut count) = (std::ptr::null(), 0);
        loop {
            match unsafe { obc_trust_region_step(self.handle.as_ptr(), &mut points, &mut count) } {
                OBC_TRUST_REGION_ITERATION => {}
                OBC_TRUST_REGION_NEED_VALUES => {
                    return Ok(Some(unsafe { slice::from_raw_parts(points, count * self.n) }))
                }
                OBC_TRUST_REGION_DONE => return Ok(None),
                status => return Err(Error { status, kind: "internal".into(), message: "step".into() }),
            }
        }
    }
    /// The value, or the residuals, at the first point requested; what is not finite: there is none.
    pub fn tell(&mut self, outputs: &[f64]) -> Result<(), Error> {
        expect_length(outputs.len(), self.outputs, "outputs")?;
        checked(|error| unsafe { obc_trust_region_tell(self.handle.as_ptr(), outputs.as_ptr(), error) })
    }
    /// Evaluations made before: points one after the other, with their outputs; before the first `ask`.
    pub fn give(&mut self, points: &[f64], outputs: &[f64]) -> Result<(), Error> {
        let count = rows(points.len(), self.n, "points")?;
        expect_length(outputs.len(), count * self.outputs, "outputs")?;
        checked(|error| unsafe {
            obc_trust_region_give(self.handle.as_ptr(), points.as_ptr(), outputs.as_ptr(), count, error)
        })
    }
    /// What is known now.
    pub fn report(&self) -> Result<Report, Error> {
        let mut report = Report::default();
        checked(|error| unsafe {
            obc_trust_region_get_result(self.handle.as_ptr(), &mut report.0, std::ptr::null_mut(), std::ptr::null_mut(), error)
        })?;
        Ok(report)
    }
    /// The lowest point so far.
    pub fn best(&self) -> Result<Vec<f64>, Error> {
        let mut x = vec![0.0; self.n];
        checked(|error| unsafe {
            obc_trust_region_get_result(self.handle.as_ptr(), std::ptr::null_mut(), x.as_mut_ptr(), std::ptr::null_mut(), error)
        })?;
        Ok(x)
    }
    /// The run as bytes, from which [`Solver::load`] goes on to the same bits.
    pub fn save(&self) -> Result<Vec<u8>, Error> {
        let mut bytes = vec![0; unsafe { obc_trust_region_save_size(self.handle.as_ptr()) }];
        checked(|error| unsafe {
            obc_trust_region_save(self.handle.as_ptr(), bytes.as_mut_ptr() as *mut c_void, bytes.len(), error)
        })?;
        Ok(bytes)
    }
}
