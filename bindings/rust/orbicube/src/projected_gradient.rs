//! Minimizes f(x) subject to A x = b and bounds, with the gradient of f; and projects onto such sets.
//!
//! ```
//! use orbicube::projected_gradient::{minimize, Problem};
//!
//! let mut problem = Problem::bounded(vec![0.0; 2], vec![]);
//! problem.add_row(&[(0, 1.0), (1, 1.0)], 1.0); // x0 + x1 = 1
//! let mut x = [0.0, 0.0];
//! let report = minimize(
//!     |x: &[f64], gradient: &mut [f64]| {
//!         gradient[0] = 2.0 * (x[0] - 3.0);
//!         gradient[1] = 2.0 * x[1];
//!         (x[0] - 3.0).powi(2) + x[1].powi(2)
//!     },
//!     &mut x, &problem, &Default::default(),
//! )?;
//! assert!(report.converged() && (x[0] - 1.0).abs() < 1e-8);
//! # Ok::<(), orbicube::Error>(())
//! ```

use std::os::raw::c_void;
use std::slice;

use crate::call::{call, checked, expect_length, pointer, text, Caught, Error, Evaluation, Host};
use crate::sys::projected_gradient::*;

filled!(/// Options, with their defaults.
    Options, obc_projected_gradient_options, obc_projected_gradient_options_init);
sized!(/// How a run ended, with all figures.
    Report, obc_projected_gradient_result);

impl Report {
    pub fn converged(&self) -> bool {
        self.stop == OBC_PROJECTED_GRADIENT_CONVERGED
    }
    /// Why the run ended, such as "infeasible".
    pub fn stop_name(&self) -> String {
        text(unsafe { obc_projected_gradient_stop_name(self.stop) })
    }
}

/// The feasible set: bounds (empty: none), and A x = b by rows.
#[derive(Clone, Debug)]
pub struct Problem {
    pub lower: Vec<f64>,
    pub upper: Vec<f64>,
    row_start: Vec<usize>,
    column: Vec<u32>,
    value: Vec<f64>,
    b: Vec<f64>,
}

impl Default for Problem {
    fn default() -> Self {
        Problem { lower: vec![], upper: vec![], row_start: vec![0], column: vec![], value: vec![], b: vec![] }
    }
}

impl Problem {
    /// Bounds, a number an unknown each; an empty vector: none.
    pub fn bounded(lower: Vec<f64>, upper: Vec<f64>) -> Problem {
        Problem { lower, upper, ..Problem::default() }
    }
    /// One more equation: the sum of value * x[column] is `right`.
    pub fn add_row(&mut self, entries: &[(u32, f64)], right: f64) {
        self.column.extend(entries.iter().map(|entry| entry.0));
        self.value.extend(entries.iter().map(|entry| entry.1));
        self.row_start.push(self.column.len());
        self.b.push(right);
    }
    pub fn row_count(&self) -> usize {
        self.b.len()
    }
    fn filled(&self, n: usize) -> Result<obc_projected_gradient_problem, Error> {
        let mut problem: obc_projected_gradient_problem = unsafe { std::mem::zeroed() };
        unsafe {
            obc_projected_gradient_problem_init(&mut problem, std::mem::size_of::<obc_projected_gradient_problem>())
        };
        for (what, array) in [("lower", &self.lower), ("upper", &self.upper)] {
            if !array.is_empty() {
                expect_length(array.len(), n, what)?;
            }
        }
        problem.n = n;
        problem.lower = pointer(&self.lower);
        problem.upper = pointer(&self.upper);
        problem.m = self.b.len();
        if problem.m > 0 {
            problem.row_start = self.row_start.as_ptr();
            problem.column = self.column.as_ptr();
            problem.value = self.value.as_ptr();
            problem.b = self.b.as_ptr();
        }
        Ok(problem)
    }
}

struct Function<F> {
    f: F,
    caught: Caught,
}

unsafe extern "C" fn called<E: Into<Evaluation>, F: FnMut(&[f64], &mut [f64]) -> E>(
    x: *const f64, n: usize, value: *mut f64, gradient: *mut f64, user: *mut c_void,
) -> i32 {
    let Function { f, caught } = &mut *(user as *mut Function<F>);
    caught.guard(|| f(slice::from_raw_parts(x, n), slice::from_raw_parts_mut(gradient, n)).into().code(&mut *value))
}

/// The minimum value of `f` in the feasible set; `f` fills the gradient and returns the value, or an [`Evaluation`].
pub fn minimize<E: Into<Evaluation>, F: FnMut(&[f64], &mut [f64]) -> E>(
    f: F, x: &mut [f64], problem: &Problem, options: &Options,
) -> Result<Report, Error> {
    let filled = problem.filled(x.len())?;
    let mut function = Function { f, caught: Caught::default() };
    let mut report = Report::default();
    let result = checked(|error| unsafe {
        obc_projected_gradient_minimize(&filled, &options.0, Some(called::<E, F>),
                                        &mut function as *mut Function<F> as *mut c_void, x.as_mut_ptr(), &mut report.0,
                                        std::ptr::null(), error)
    });
    function.caught.resume();
    result.map(|_| report)
}

/// The same over any closed convex set: `project` fills its second argument with the point nearest to the first.
pub fn minimize_over<E, F, P>(f: F, x: &mut [f64], mut project: P, options: &Options) -> Result<Report, Error>
where
    E: Into<Evaluation>,
    F: FnMut(&[f64], &mut [f64]) -> E,
    P: FnMut(&[f64], &mut [f64]),
{
    unsafe extern "C" fn projected<P: FnMut(&[f64], &mut [f64])>(y: *const f64, n: usize, x: *mut f64, user: *mut c_void) -> i32 {
        let Function { f, caught } = &mut *(user as *mut Function<&mut P>);
        caught.guard(|| {
            f(slice::from_raw_parts(y, n), slice::from_raw_parts_mut(x, n));
            0
        })
    }
    let mut filled = Problem::default().filled(x.len())?;
    let mut projection = Function { f: &mut project, caught: Caught::default() };
    filled.project = Some(projected::<P>);
    filled.project_user = &mut projection as *mut Function<&mut P> as *mut c_void;
    let mut function = Function { f, caught: Caught::default() };
    let mut report = Report::default();
    let result = checked(|error| unsafe {
        obc_projected_gradient_minimize(&filled, &options.0, Some(called::<E, F>),
                                        &mut function as *mut Function<F> as *mut c_void, x.as_mut_ptr(), &mut report.0,
                                        std::ptr::null(), error)
    });
    function.caught.resume();
    projection.caught.resume();
    result.map(|_| report)
}

/// The point of the feasible set that is nearest to y, and the multipliers of the rows.
pub fn project(y: &[f64], problem: &Problem, host: &mut Host) -> Result<(Vec<f64>, Vec<f64>, Report), Error> {
    let filled = problem.filled(y.len())?;
    let (mut x, mut multipliers) = (vec![0.0; y.len()], vec![0.0; problem.row_count()]);
    let mut report = Report::default();
    call(host, |host, error| unsafe {
        obc_projected_gradient_project(&filled, y.as_ptr(), x.as_mut_ptr(), multipliers.as_mut_ptr(), &mut report.0, host, error)
    })?;
    Ok((x, multipliers, report))
}

handle!(Handle, obc_projected_gradient, obc_projected_gradient_destroy);

/// A run by reverse communication: `while let Some(x) = solver.ask()? { ... solver.tell(value, &gradient)?; }`
pub struct Solver {
    handle: Handle,
    n: usize,
    m: usize,
}

// As of trust_region.
unsafe impl Send for Solver {}

impl Solver {
    pub fn new(x0: &[f64], problem: &Problem, options: &Options) -> Result<Solver, Error> {
        let filled = problem.filled(x0.len())?;
        let mut out = std::ptr::null_mut();
        checked(|error| unsafe {
            obc_projected_gradient_create(&filled, &options.0, x0.as_ptr(), std::ptr::null(), &mut out, error)
        })?;
        Ok(Solver { handle: Handle::own(out), n: x0.len(), m: problem.row_count() })
    }
    /// Goes on with a run that was saved, of the same problem.
    pub fn load(bytes: &[u8], unknowns: usize, problem: &Problem) -> Result<Solver, Error> {
        let filled = problem.filled(unknowns)?;
        let mut out = std::ptr::null_mut();
        checked(|error| unsafe {
            obc_projected_gradient_load(&filled, bytes.as_ptr() as *const c_void, bytes.len(), std::ptr::null(), &mut out, error)
        })?;
        Ok(Solver { handle: Handle::own(out), n: unknowns, m: problem.row_count() })
    }
    /// The point at which f and its gradient are requested next; `None` when the run has ended.
    pub fn ask(&mut self) -> Result<Option<&[f64]>, Error> {
        let mut x = std::ptr::null();
        loop {
            match unsafe { obc_projected_gradient_step(self.handle.as_ptr(), &mut x) } {
                OBC_PROJECTED_GRADIENT_ITERATION => {}
                OBC_PROJECTED_GRADIENT_NEED_FG => return Ok(Some(unsafe { slice::from_raw_parts(x, self.n) })),
                OBC_PROJECTED_GRADIENT_DONE => return Ok(None),
                status => return Err(Error { status, kind: "internal".into(), message: "step".into() }),
            }
        }
    }
    /// Value and gradient at the point queried; what is not finite: there is none.
    pub fn tell(&mut self, value: f64, gradient: &[f64]) -> Result<(), Error> {
        expect_length(gradient.len(), self.n, "gradient")?;
        checked(|error| unsafe { obc_projected_gradient_tell(self.handle.as_ptr(), value, gradient.as_ptr(), error) })
    }
    /// What is known now.
    pub fn report(&self) -> Result<Report, Error> {
        let mut report = Report::default();
        checked(|error| unsafe {
            obc_projected_gradient_get_result(self.handle.as_ptr(), &mut report.0, std::ptr::null_mut(), error)
        })?;
        Ok(report)
    }
    fn numbers(&self, count: usize, f: impl FnOnce(*const obc_projected_gradient, *mut f64, *mut crate::sys::base::obc_error) -> i32)
               -> Result<Vec<f64>, Error> {
        let mut numbers = vec![0.0; count];
        checked(|error| f(self.handle.as_ptr(), numbers.as_mut_ptr(), error))?;
        Ok(numbers)
    }
    /// The lowest feasible point so far, or the one that met the tolerance.
    pub fn best(&self) -> Result<Vec<f64>, Error> {
        self.numbers(self.n, |solver, x, error| unsafe {
            obc_projected_gradient_get_result(solver, std::ptr::null_mut(), x, error)
        })
    }
    /// Multipliers of the rows at the current iterate.
    pub fn multipliers(&self) -> Result<Vec<f64>, Error> {
        self.numbers(self.m, |solver, t, error| unsafe { obc_projected_gradient_multipliers(solver, t, error) })
    }
    /// After "infeasible": c with c'A x < c'b for every x within the bounds.
    pub fn certificate(&self) -> Result<Vec<f64>, Error> {
        self.numbers(self.m, |solver, c, error| unsafe { obc_projected_gradient_certificate(solver, c, error) })
    }
    /// The run as bytes, from which [`Solver::load`] goes on to the same bits.
    pub fn save(&self) -> Result<Vec<u8>, Error> {
        let mut bytes = vec![0; unsafe { obc_projected_gradient_save_size(self.handle.as_ptr()) }];
        checked(|error| unsafe {
            obc_projected_gradient_save(self.handle.as_ptr(), bytes.as_mut_ptr() as *mut c_void, bytes.len(), error)
        })?;
        Ok(bytes)
    }
}
