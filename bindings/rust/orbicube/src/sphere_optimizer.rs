//! Minimizes f over products of unit spheres: directions, quaternions, unit eigenvectors.
//!
//! ```
//! let mut x = [1.0, 0.0, 0.0];
//! let report = orbicube::sphere_optimizer::minimize(
//!     |x: &[f64], gradient: &mut [f64]| {
//!         gradient.copy_from_slice(&[0.0, 0.0, 1.0]);
//!         x[2]
//!     },
//!     &mut x, 3, &Default::default(),
//! )?;
//! assert!((report.value + 1.0).abs() < 1e-12);
//! # Ok::<(), orbicube::Error>(())
//! ```

use std::os::raw::c_void;
use std::slice;

use crate::call::{checked, expect_length, pointer, rows, text, Caught, Error, Evaluation};
use crate::sys::sphere_optimizer::*;

filled!(/// Options, with their defaults.
    Options, obc_sphere_optimizer_options, obc_sphere_optimizer_options_init);
sized!(/// How a run ended, with all figures.
    Report, obc_sphere_optimizer_result);
filled!(/// Options of [`relax`], with their defaults.
    RelaxationOptions, obc_sphere_optimizer_relaxation_options, obc_sphere_optimizer_relaxation_options_init);
sized!(/// How a relaxation ended.
    RelaxationReport, obc_sphere_optimizer_relaxation_result);

impl RelaxationReport {
    pub fn converged(&self) -> bool {
        self.stop == OBC_SPHERE_OPTIMIZER_CONVERGED
    }
    /// Whether there is more to do, of a [`Relaxation`].
    pub fn running(&self) -> bool {
        self.stop == OBC_SPHERE_OPTIMIZER_RUNNING
    }
    /// Why the relaxation ended, such as "converged"; "running" before.
    pub fn stop_name(&self) -> String {
        text(unsafe { obc_sphere_optimizer_stop_name(self.stop) })
    }
}

impl Report {
    pub fn converged(&self) -> bool {
        self.stop == OBC_SPHERE_OPTIMIZER_CONVERGED
    }
    /// Why the run ended, such as "converged".
    pub fn stop_name(&self) -> String {
        text(unsafe { obc_sphere_optimizer_stop_name(self.stop) })
    }
}

struct Function<F> {
    f: F,
    dimension: usize,
    length: usize,
    caught: Caught,
}

unsafe extern "C" fn all<E: Into<Evaluation>, F: FnMut(&[f64], &mut [f64]) -> E>(
    x: *const f64, count: usize, dimension: usize, value: *mut f64, gradient: *mut f64, user: *mut c_void,
) -> i32 {
    let Function { f, caught, .. } = &mut *(user as *mut Function<F>);
    let n = count * dimension;
    caught.guard(|| f(slice::from_raw_parts(x, n), slice::from_raw_parts_mut(gradient, n)).into().code(&mut *value))
}

/// The minimum value of `f` that is found from `x`: blocks of `dimension` numbers. `f` fills the gradient and returns the value,
/// or an [`Evaluation`].
pub fn minimize<E: Into<Evaluation>, F: FnMut(&[f64], &mut [f64]) -> E>(
    f: F, x: &mut [f64], dimension: usize, options: &Options,
) -> Result<Report, Error> {
    let count = rows(x.len(), dimension, "x")?;
    let mut function = Function { f, dimension, length: x.len(), caught: Caught::default() };
    let mut report = Report::default();
    let result = checked(|error| unsafe {
        obc_sphere_optimizer_minimize(count, dimension, &options.0, Some(all::<E, F>),
                                      &mut function as *mut Function<F> as *mut c_void, x.as_mut_ptr(), &mut report.0,
                                      std::ptr::null(), error)
    });
    function.caught.resume();
    result.map(|_| report)
}

struct FunctionAndProduct<F, P> {
    f: F,
    product: P,
    caught: Caught,
}

unsafe extern "C" fn value<E: Into<Evaluation>, F: FnMut(&[f64], &mut [f64]) -> E, P>(
    x: *const f64, count: usize, dimension: usize, value: *mut f64, gradient: *mut f64, user: *mut c_void,
) -> i32 {
    let FunctionAndProduct { f, caught, .. } = &mut *(user as *mut FunctionAndProduct<F, P>);
    let n = count * dimension;
    caught.guard(|| f(slice::from_raw_parts(x, n), slice::from_raw_parts_mut(gradient, n)).into().code(&mut *value))
}

unsafe extern "C" fn multiply<F, P: FnMut(&[f64], &[f64], &mut [f64])>(
    x: *const f64, direction: *const f64, count: usize, dimension: usize, out: *mut f64, user: *mut c_void,
) -> i32 {
    let FunctionAndProduct { product, caught, .. } = &mut *(user as *mut FunctionAndProduct<F, P>);
    let n = count * dimension;
    caught.guard(|| {
        product(slice::from_raw_parts(x, n), slice::from_raw_parts(direction, n), slice::from_raw_parts_mut(out, n));
        OBC_SPHERE_OPTIMIZER_CONTINUE
    })
}

/// [`minimize`] with truncated Newton steps: `product(x, direction, out)` fills the product of the Hessian of f at x, as a function of
/// all numbers of x, and a direction; an entry that is NaN says that there is none.
///
/// ```
/// use orbicube::sphere_optimizer::minimize_second_order;
///
/// let stiffness = [1.0, 2.0, 3.0];
/// let mut x = [1.0; 3];
/// let report = minimize_second_order(
///     |x: &[f64], gradient: &mut [f64]| {
///         (0..3).map(|k| { gradient[k] = 2.0 * stiffness[k] * x[k]; stiffness[k] * x[k] * x[k] }).sum::<f64>()
///     },
///     |_: &[f64], direction: &[f64], out: &mut [f64]| (0..3).for_each(|k| out[k] = 2.0 * stiffness[k] * direction[k]),
///     &mut x, 3, &Default::default(),
/// )?;
/// assert!((report.value - 1.0).abs() < 1e-12);
/// # Ok::<(), orbicube::Error>(())
/// ```
pub fn minimize_second_order<E: Into<Evaluation>, F: FnMut(&[f64], &mut [f64]) -> E, P: FnMut(&[f64], &[f64], &mut [f64])>(
    f: F, product: P, x: &mut [f64], dimension: usize, options: &Options,
) -> Result<Report, Error> {
    let count = rows(x.len(), dimension, "x")?;
    let mut function = FunctionAndProduct { f, product, caught: Caught::default() };
    let mut report = Report::default();
    let result = checked(|error| unsafe {
        obc_sphere_optimizer_minimize_second_order(count, dimension, &options.0, Some(value::<E, F, P>), Some(multiply::<F, P>),
                                                   &mut function as *mut FunctionAndProduct<F, P> as *mut c_void,
                                                   x.as_mut_ptr(), &mut report.0, std::ptr::null(), error)
    });
    function.caught.resume();
    result.map(|_| report)
}

/// The request for the terms of f that contain a block.
pub struct Part<'a> {
    pub block: usize,
    /// Where the block would be.
    pub place: &'a [f64],
    /// Where all blocks are.
    pub points: &'a [f64],
    /// To be filled, where it is requested: the gradient with respect to the block.
    pub gradient: Option<&'a mut [f64]>,
    /// Likewise second derivatives, by rows; only with `second_order`.
    pub hessian: Option<&'a mut [f64]>,
}

unsafe extern "C" fn one<E: Into<Evaluation>, F: FnMut(Part<'_>) -> E>(
    block: usize, place: *const f64, points: *const f64, value: *mut f64, gradient: *mut f64, hessian: *mut f64,
    user: *mut c_void,
) -> i32 {
    let Function { f, dimension, length, caught } = &mut *(user as *mut Function<F>);
    let d = *dimension;
    caught.guard(|| {
        let part = Part {
            block,
            place: slice::from_raw_parts(place, d),
            points: slice::from_raw_parts(points, *length),
            gradient: if gradient.is_null() { None } else { Some(slice::from_raw_parts_mut(gradient, d)) },
            hessian: if hessian.is_null() { None } else { Some(slice::from_raw_parts_mut(hessian, d * d)) },
        };
        f(part).into().code(&mut *value)
    })
}

/// A C struct with the arrays that it points at.
struct Blocks {
    filled: obc_sphere_optimizer_blocks,
    _start: Vec<usize>,
    _flat: Vec<u32>,
}

impl Blocks {
    fn new(dimension: usize, neighbors: &[Vec<u32>]) -> Result<Blocks, Error> {
        let mut start = vec![0];
        let mut flat = vec![];
        for row in neighbors {
            flat.extend_from_slice(row);
            start.push(flat.len());
        }
        let mut filled: obc_sphere_optimizer_blocks = unsafe { std::mem::zeroed() };
        unsafe { obc_sphere_optimizer_blocks_init(&mut filled, std::mem::size_of::<obc_sphere_optimizer_blocks>()) };
        filled.dimension = u32::try_from(dimension).map_err(|_| Error::invalid("dimension"))?;
        filled.count = neighbors.len();
        filled.neighbor_start = start.as_ptr();
        filled.neighbor = pointer(&flat);
        Ok(Blocks { filled, _start: start, _flat: flat })
    }
}

/// Lowers f block by block; `neighbors[i]` are the blocks whose part of f contains block i.
pub fn relax<E: Into<Evaluation>, F: FnMut(Part<'_>) -> E>(
    f: F, x: &mut [f64], dimension: usize, neighbors: &[Vec<u32>], options: &RelaxationOptions,
) -> Result<RelaxationReport, Error> {
    expect_length(x.len(), neighbors.len() * dimension, "x")?;
    let blocks = Blocks::new(dimension, neighbors)?;
    let mut function = Function { f, dimension, length: x.len(), caught: Caught::default() };
    let mut report = RelaxationReport::default();
    let result = checked(|error| unsafe {
        obc_sphere_optimizer_relax(&blocks.filled, &options.0, Some(one::<E, F>), &mut function as *mut Function<F> as *mut c_void,
                                   x.as_mut_ptr(), &mut report.0, std::ptr::null(), error)
    });
    function.caught.resume();
    result.map(|_| report)
}

handle!(RelaxationHandle, obc_sphere_optimizer_relaxation, obc_sphere_optimizer_relaxation_destroy);

/// [`relax`] in parts, which ends in the same bits:
///
/// ```
/// use orbicube::sphere_optimizer::{Part, Relaxation};
///
/// let down = |part: Part| {
///     if let Some(gradient) = part.gradient {
///         gradient.copy_from_slice(&[0.0, 0.0, 1.0]);
///     }
///     part.place[2]
/// };
/// let mut relaxation = Relaxation::new(&[1.0, 0.0, 0.0], 3, &[vec![]], &Default::default())?;
/// while relaxation.run(down, 10)?.running() {
///     relaxation = Relaxation::load(&relaxation.save()?, 3, &[vec![]])?;
/// }
/// assert!((relaxation.points()?[2] + 1.0).abs() < 1e-9);
/// # Ok::<(), orbicube::Error>(())
/// ```
///
/// Like a solver it may move to another thread, but is used by one at a time:
///
/// ```compile_fail
/// fn sync<T: Sync>() {}
/// sync::<orbicube::sphere_optimizer::Relaxation>();
/// ```
pub struct Relaxation {
    handle: RelaxationHandle,
    dimension: usize,
    length: usize,
}

// As of trust_region; it holds copies of what it was made from.
unsafe impl Send for Relaxation {}

impl Relaxation {
    pub fn new(
        x0: &[f64], dimension: usize, neighbors: &[Vec<u32>], options: &RelaxationOptions,
    ) -> Result<Relaxation, Error> {
        expect_length(x0.len(), neighbors.len() * dimension, "x0")?;
        let blocks = Blocks::new(dimension, neighbors)?;
        let mut out = std::ptr::null_mut();
        checked(|error| unsafe {
            obc_sphere_optimizer_relaxation_create(&blocks.filled, &options.0, x0.as_ptr(), std::ptr::null(), &mut out, error)
        })?;
        Ok(Relaxation { handle: RelaxationHandle::own(out), dimension, length: x0.len() })
    }
    /// Goes on with one that was saved, of the same neighbors.
    pub fn load(bytes: &[u8], dimension: usize, neighbors: &[Vec<u32>]) -> Result<Relaxation, Error> {
        let blocks = Blocks::new(dimension, neighbors)?;
        let mut out = std::ptr::null_mut();
        checked(|error| unsafe {
            obc_sphere_optimizer_relaxation_load(&blocks.filled, bytes.as_ptr() as *const c_void, bytes.len(),
                                                 std::ptr::null(), &mut out, error)
        })?;
        Ok(Relaxation { handle: RelaxationHandle::own(out), dimension, length: neighbors.len() * dimension })
    }
    /// Relaxes up to the given number of further blocks, with `f` as of [`relax`]. Whatever breaks it off, [`Evaluation::Stop`] or a
    /// panic, the next call goes on as if it had not been.
    pub fn run<E: Into<Evaluation>, F: FnMut(Part<'_>) -> E>(&mut self, f: F, steps: u64) -> Result<RelaxationReport, Error> {
        let mut function = Function { f, dimension: self.dimension, length: self.length, caught: Caught::default() };
        let result = checked(|error| unsafe {
            obc_sphere_optimizer_relaxation_run(self.handle.as_ptr(), Some(one::<E, F>),
                                                &mut function as *mut Function<F> as *mut c_void, steps, error)
        });
        function.caught.resume();
        result?;
        self.report()
    }
    /// What is known now.
    pub fn report(&self) -> Result<RelaxationReport, Error> {
        let mut report = RelaxationReport::default();
        checked(|error| unsafe {
            obc_sphere_optimizer_relaxation_get_result(self.handle.as_ptr(), &mut report.0, std::ptr::null_mut(), error)
        })?;
        Ok(report)
    }
    /// Where all blocks are now.
    pub fn points(&self) -> Result<Vec<f64>, Error> {
        let mut x = vec![0.0; self.length];
        checked(|error| unsafe {
            obc_sphere_optimizer_relaxation_get_result(self.handle.as_ptr(), std::ptr::null_mut(), x.as_mut_ptr(), error)
        })?;
        Ok(x)
    }
    /// The relaxation as bytes, from which [`Relaxation::load`] goes on to the same bits.
    pub fn save(&self) -> Result<Vec<u8>, Error> {
        let mut bytes = vec![0; unsafe { obc_sphere_optimizer_relaxation_save_size(self.handle.as_ptr()) }];
        checked(|error| unsafe {
            obc_sphere_optimizer_relaxation_save(self.handle.as_ptr(), bytes.as_mut_ptr() as *mut c_void, bytes.len(), error)
        })?;
        Ok(bytes)
    }
}

handle!(Handle, obc_sphere_optimizer, obc_sphere_optimizer_destroy);

/// A run by reverse communication: `while let Some(x) = solver.ask()? { ... solver.tell(value, &gradient)?; }`. With the option
/// `hessian_products`, where [`Solver::direction`] is not `None`, reply with [`Solver::tell_product`].
pub struct Solver {
    handle: Handle,
    n: usize,
}

// As of trust_region.
unsafe impl Send for Solver {}

impl Solver {
    pub fn new(x0: &[f64], dimension: usize, options: &Options) -> Result<Solver, Error> {
        let count = rows(x0.len(), dimension, "x0")?;
        let mut out = std::ptr::null_mut();
        checked(|error| unsafe {
            obc_sphere_optimizer_create(count, dimension, &options.0, x0.as_ptr(), std::ptr::null(), &mut out, error)
        })?;
        Ok(Solver { handle: Handle::own(out), n: x0.len() })
    }
    /// Goes on with a run that was saved.
    pub fn load(bytes: &[u8]) -> Result<Solver, Error> {
        let mut out = std::ptr::null_mut();
        checked(|error| unsafe {
            obc_sphere_optimizer_load(bytes.as_ptr() as *const c_void, bytes.len(), std::ptr::null(), &mut out, error)
        })?;
        let handle = Handle::own(out);
        let (mut count, mut dimension) = (0, 0);
        checked(|error| unsafe { obc_sphere_optimizer_get_shape(handle.as_ptr(), &mut count, &mut dimension, error) })?;
        Ok(Solver { handle, n: count * dimension })
    }
    /// The point at which f and its gradient are requested next; `None` when the run has ended.
    pub fn ask(&mut self) -> Result<Option<&[f64]>, Error> {
        let mut x = std::ptr::null();
        loop {
            match unsafe { obc_sphere_optimizer_step(self.handle.as_ptr(), &mut x) } {
                OBC_SPHERE_OPTIMIZER_ITERATION => {}
                OBC_SPHERE_OPTIMIZER_NEED_FG | OBC_SPHERE_OPTIMIZER_NEED_PRODUCT => return Ok(Some(unsafe { slice::from_raw_parts(x, self.n) })),
                OBC_SPHERE_OPTIMIZER_DONE => return Ok(None),
                status => return Err(Error { status, kind: "internal".into(), message: "step".into() }),
            }
        }
    }
    /// The vector whose product with the Hessian at the point is queried; `None` where value and gradient are.
    pub fn direction(&self) -> Option<&[f64]> {
        let mut direction = std::ptr::null();
        match unsafe { obc_sphere_optimizer_get_direction(self.handle.as_ptr(), &mut direction, std::ptr::null_mut()) } {
            0 => Some(unsafe { slice::from_raw_parts(direction, self.n) }),
            _ => None,
        }
    }
    /// That product; what is not finite: there is none.
    pub fn tell_product(&mut self, product: &[f64]) -> Result<(), Error> {
        expect_length(product.len(), self.n, "product")?;
        checked(|error| unsafe { obc_sphere_optimizer_tell_product(self.handle.as_ptr(), product.as_ptr(), error) })
    }
    /// Value and gradient at the point queried; what is not finite: there is none.
    pub fn tell(&mut self, value: f64, gradient: &[f64]) -> Result<(), Error> {
        expect_length(gradient.len(), self.n, "gradient")?;
        checked(|error| unsafe { obc_sphere_optimizer_tell(self.handle.as_ptr(), value, gradient.as_ptr(), error) })
    }
    /// What is known now.
    pub fn report(&self) -> Result<Report, Error> {
        let mut report = Report::default();
        checked(|error| unsafe {
            obc_sphere_optimizer_get_result(self.handle.as_ptr(), &mut report.0, std::ptr::null_mut(), error)
        })?;
        Ok(report)
    }
    /// The lowest point so far, or the one that met the tolerance.
    pub fn best(&self) -> Result<Vec<f64>, Error> {
        let mut x = vec![0.0; self.n];
        checked(|error| unsafe {
            obc_sphere_optimizer_get_result(self.handle.as_ptr(), std::ptr::null_mut(), x.as_mut_ptr(), error)
        })?;
        Ok(x)
    }
    /// The run as bytes, from which [`Solver::load`] goes on to the same bits.
    pub fn save(&self) -> Result<Vec<u8>, Error> {
        let mut bytes = vec![0; unsafe { obc_sphere_optimizer_save_size(self.handle.as_ptr()) }];
        checked(|error| unsafe {
            obc_sphere_optimizer_save(self.handle.as_ptr(), bytes.as_mut_ptr() as *mut c_void, bytes.len(), error)
        })?;
        Ok(bytes)
    }
}
