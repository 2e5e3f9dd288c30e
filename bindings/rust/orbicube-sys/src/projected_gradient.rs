//! What `<orbicube/projected_gradient.h>` declares. Written by scripts/bindings.py; not to be edited.
#![allow(non_camel_case_types, non_upper_case_globals)]

use crate::base::{obc_error, obc_host};
use std::os::raw::{c_char, c_void};

/// active face of a quasi-Newton model
pub const OBC_PROJECTED_GRADIENT_FACE: i32 = 0;
/// the dissertation's section 4.3.1, for comparison
pub const OBC_PROJECTED_GRADIENT_DISSERTATION: i32 = 1;

/// Grippo, Lampariello, Lucidi: below the largest of the last values
pub const OBC_PROJECTED_GRADIENT_MAX_OF_LAST: i32 = 0;
/// Zhang and Hager: below a weighted mean of all values
pub const OBC_PROJECTED_GRADIENT_AVERAGE: i32 = 1;

/// evaluate f and its gradient at x, then call \_tell
pub const OBC_PROJECTED_GRADIENT_NEED_FG: i32 = 1;
/// x is a new iterate, evaluated or interpolated; requires no action
pub const OBC_PROJECTED_GRADIENT_ITERATION: i32 = 2;
/// the run has ended; see \_get\_result
pub const OBC_PROJECTED_GRADIENT_DONE: i32 = 3;

/// not ended
pub const OBC_PROJECTED_GRADIENT_RUNNING: i32 = 0;
/// |P(x - g) - x|inf \<= gradient\_tolerance
pub const OBC_PROJECTED_GRADIENT_CONVERGED: i32 = 1;
/// f \<= target
pub const OBC_PROJECTED_GRADIENT_TARGET_REACHED: i32 = 2;
/// max\_evaluations reached
pub const OBC_PROJECTED_GRADIENT_EVALUATION_BUDGET: i32 = 3;
/// max\_iterations reached
pub const OBC_PROJECTED_GRADIENT_ITERATION_BUDGET: i32 = 4;
/// no step that double precision resolves lowers f: f is at its rounding
/// floor, or the gradient is wrong; see \_check\_gradient
pub const OBC_PROJECTED_GRADIENT_STALLED: i32 = 5;
/// no x satisfies the constraints; see \_certificate
pub const OBC_PROJECTED_GRADIENT_INFEASIBLE: i32 = 6;
/// by the host's progress callback or by the callback f
pub const OBC_PROJECTED_GRADIENT_CANCELLED: i32 = 7;
/// f is not finite at the start, or along two whole directions
pub const OBC_PROJECTED_GRADIENT_EVALUATION_FAILED: i32 = 8;
/// the caller's projection failed, or the rows cannot be satisfied
pub const OBC_PROJECTED_GRADIENT_PROJECTION_FAILED: i32 = 9;
/// f decreases without bound along a direction, or is below -1e200
pub const OBC_PROJECTED_GRADIENT_UNBOUNDED: i32 = 10;

/// value and gradient are set
pub const OBC_PROJECTED_GRADIENT_CONTINUE: i32 = 0;
/// end the run as CANCELLED with the best point so far. A finite value that is set as well
/// counts; the gradient is unused
pub const OBC_PROJECTED_GRADIENT_STOP: i32 = 1;
/// f is undefined at x; the method continues elsewhere
pub const OBC_PROJECTED_GRADIENT_FAILED: i32 = 2;

/// A run of the method.
#[repr(C)]
pub struct obc_projected_gradient {
    _private: [u8; 0],
    _marker: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

/// Evaluates f at x: value and gradient (n entries). A value or entry that is not finite counts as FAILED. Returns one of the constants
/// above.
pub type obc_projected_gradient_function = Option<unsafe extern "C" fn(x: *const f64, n: usize, value: *mut f64, gradient: *mut f64, user: *mut c_void) -> i32>;

/// Computes the point x (n entries) of a closed convex set nearest to y, which x does not overlap. The result must depend on y
/// alone. Returns 0, or another value on failure.
pub type obc_projected_gradient_projection = Option<unsafe extern "C" fn(y: *const f64, n: usize, x: *mut f64, user: *mut c_void) -> i32>;

/// The feasible set: either bounds and rows, or a projection of the caller. Arrays are copied. Fill with \_problem\_init, or with zeros
/// and struct\_size, which is the same: in C99 {.struct\_size = sizeof(obc\_projected\_gradient\_problem), .n = 2}.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_projected_gradient_problem {
    pub struct_size: u32,
    /// number of unknowns, at least 1. Default: 0, which must be set.
    pub n: usize,
    /// number of rows of A; rows may be redundant. Default: 0.
    pub m: usize,
    /// n lower bounds, -infinity allowed; NULL: none. Starts and projected points are within 1e150. Default: NULL.
    pub lower: *const f64,
    /// n upper bounds, infinity allowed; NULL: none. Default: NULL.
    pub upper: *const f64,
    /// m + 1 offsets into column and value: A by rows, each zero or of length 1e-150 to 1e150. Default: NULL.
    pub row_start: *const usize,
    /// column of each entry, below n; entries of one column in a row are summed. Default: NULL.
    pub column: *const u32,
    /// value of each entry, finite. Default: NULL.
    pub value: *const f64,
    /// right-hand side, m entries. Default: NULL.
    pub b: *const f64,
    /// projection in place of bounds and rows; NULL: none. Default: NULL.
    pub project: obc_projected_gradient_projection,
    /// passed to project. Default: NULL.
    pub project_user: *mut c_void,
}

/// Options of a run. Fill with \_options\_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_projected_gradient_options {
    pub struct_size: u32,
    /// OBC\_PROJECTED\_GRADIENT\_FACE or DISSERTATION. Default: FACE.
    pub method: i32,
    /// line search of DISSERTATION. Default: MAX\_OF\_LAST.
    pub line_search: i32,
    /// number of pairs in the model of FACE, 1 to 1000; 3 times as many are kept for n \<= 4 memory with bounds
    /// only. Default: 10.
    pub memory: u32,
    /// number of values that MAX\_OF\_LAST considers. Default: 10.
    pub history: u32,
    /// eta of AVERAGE, 0 (monotone) to 1. Default: 0.85.
    pub average_weight: f64,
    /// tolerance of |P(x - g) - x|inf, the projected gradient. Default: 1e-8.
    pub gradient_tolerance: f64,
    /// ends the run at f \<= target. Default: -infinity.
    pub target: f64,
    /// maximum number of evaluations. Default: 100000.
    pub max_evaluations: u64,
    /// maximum number of iterations. Default: 100000.
    pub max_iterations: u64,
}

/// State of a run. The caller sets struct\_size.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_projected_gradient_result {
    pub struct_size: u32,
    /// stop code, OBC\_PROJECTED\_GRADIENT\_RUNNING or another
    pub stop: i32,
    /// f at the returned point; NaN before the first value
    pub value: f64,
    /// |P(x - g) - x|inf at the current iterate, without the rounding of x - g for large x
    pub projected_gradient: f64,
    /// maximum over the rows of |a'x - b| / (|b| + sum |a\_j x\_j|) at the returned point
    pub equality_residual: f64,
    /// number of evaluations, including failed ones
    pub evaluations: u64,
    /// number of evaluations without a value
    pub failed_evaluations: u64,
    /// number of iterations
    pub iterations: u64,
    /// number of passes over the unknowns in all projections
    pub projection_passes: u64,
    /// see \_certificate
    pub certificate_gap: f64,
}

/// Comparison of a gradient with finite differences. The caller sets struct\_size.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_projected_gradient_check {
    pub struct_size: u32,
    /// 1: each compared entry agrees to 1e-4 or to the accuracy of the differences; 0: some entry does not
    pub agrees: i32,
    /// entry of the gradient with the largest error
    pub worst: usize,
    /// this entry as f returns it
    pub told: f64,
    /// this entry by differences of f
    pub difference: f64,
    /// |\`told\` - \`difference\`|, less 5 uncertainties, over the larger of the two
    pub error: f64,
    /// of \`difference\`, from two step lengths and the rounding of f
    pub uncertainty: f64,
    /// number of compared entries; fixed unknowns, and entries where f is undefined on either side, are left out
    pub compared: usize,
    /// number of evaluations of f: 1, and 4 to 8 an unknown
    pub evaluations: u64,
}

extern "C" {
    /// Fills a problem with n = m = 0 and no bounds.
    pub fn obc_projected_gradient_problem_init(problem: *mut obc_projected_gradient_problem, struct_size: usize) -> i32;
    /// Fills options with the defaults.
    pub fn obc_projected_gradient_options_init(options: *mut obc_projected_gradient_options, struct_size: usize) -> i32;
    /// Creates a solver that starts from the feasible point nearest to x0 (n entries). options and host may be NULL; what the
    /// host points to must remain valid until \_destroy. An empty feasible set ends the run as INFEASIBLE at the first step.
    /// Errors: invalid argument, out of memory.
    pub fn obc_projected_gradient_create(problem: *const obc_projected_gradient_problem, options: *const obc_projected_gradient_options, x0: *const f64, host: *const obc_host, out: *mut *mut obc_projected_gradient, error: *mut obc_error) -> i32;
    /// Advances to the next request and returns it: NEED\_FG, ITERATION or DONE, or a negative obc\_status for NULL or after a defect. \*x
    /// (x may be NULL) is the point of the request, n entries in memory of the solver, valid until its next call. While a request
    /// waits for \_tell, and after DONE, the same request is returned.
    pub fn obc_projected_gradient_step(solver: *mut obc_projected_gradient, x: *mut *const f64) -> i32;
    /// Supplies value and gradient for NEED\_FG. An entry that is not finite means that f is undefined there; gradient may then be
    /// NULL. Errors: invalid argument if no request waits.
    pub fn obc_projected_gradient_tell(solver: *mut obc_projected_gradient, value: f64, gradient: *const f64, error: *mut obc_error) -> i32;
    /// Copies the current state at any time: result (or NULL), and x (n entries, or NULL). x is the iterate that satisfies the tolerance
    /// if the run CONVERGED, otherwise the lowest feasible point evaluated, and before the first value the projected start.
    /// Errors: invalid argument.
    pub fn obc_projected_gradient_get_result(solver: *const obc_projected_gradient, result: *mut obc_projected_gradient_result, x: *mut f64, error: *mut obc_error) -> i32;
    /// Copies the Lagrange multipliers t of the rows (m entries) at the current iterate. At a solution gradient - A't is zero where
    /// lower \< x \< upper, nonnegative at lower and nonpositive at upper. Errors: invalid argument.
    pub fn obc_projected_gradient_multipliers(solver: *const obc_projected_gradient, multipliers: *mut f64, error: *mut obc_error) -> i32;
    /// Copies a certificate of infeasibility (Farkas) after INFEASIBLE: m numbers c with c'A x \< c'b for every x within the bounds, where
    /// entries of A'c below 1e-9 |c| count as zero against an infinite bound. certificate\_gap of the result is c'b - max c'A x \> 0.
    /// Errors: invalid argument after any other end.
    pub fn obc_projected_gradient_certificate(solver: *const obc_projected_gradient, certificate: *mut f64, error: *mut obc_error) -> i32;
    /// Save and restore a run between two calls. save\_size returns the number of bytes, save writes them to blob, whose capacity is at
    /// least that. load creates a solver that continues with the same bits and the saved options. The problem must be that of the
    /// saved run; a projection of the caller is taken from it. Both machines need the same byte order.
    /// Errors: invalid argument (another problem), malformed file (damaged, or of another version), out of memory.
    pub fn obc_projected_gradient_save_size(solver: *const obc_projected_gradient) -> usize;
    /// Save and restore a run between two calls. save\_size returns the number of bytes, save writes them to blob, whose capacity is at
    /// least that. load creates a solver that continues with the same bits and the saved options. The problem must be that of the
    /// saved run; a projection of the caller is taken from it. Both machines need the same byte order.
    /// Errors: invalid argument (another problem), malformed file (damaged, or of another version), out of memory.
    pub fn obc_projected_gradient_save(solver: *const obc_projected_gradient, blob: *mut c_void, capacity: usize, error: *mut obc_error) -> i32;
    /// Save and restore a run between two calls. save\_size returns the number of bytes, save writes them to blob, whose capacity is at
    /// least that. load creates a solver that continues with the same bits and the saved options. The problem must be that of the
    /// saved run; a projection of the caller is taken from it. Both machines need the same byte order.
    /// Errors: invalid argument (another problem), malformed file (damaged, or of another version), out of memory.
    pub fn obc_projected_gradient_load(problem: *const obc_projected_gradient_problem, blob: *const c_void, size: usize, host: *const obc_host, out: *mut *mut obc_projected_gradient, error: *mut obc_error) -> i32;
    /// Destroys a solver; NULL is allowed.
    pub fn obc_projected_gradient_destroy(solver: *mut obc_projected_gradient);
    /// Runs to the end with a callback. x (n entries) is the start and receives the point of \_get\_result; result may be NULL.
    /// Returns OBC\_OK however the run ended (see result-\>stop), except OBC\_CANCELLED where the host cancelled it; x and result
    /// are filled in that case too. Errors: invalid argument, out of memory, cancelled.
    pub fn obc_projected_gradient_minimize(problem: *const obc_projected_gradient_problem, options: *const obc_projected_gradient_options, f: obc_projected_gradient_function, user: *mut c_void, x: *mut f64, result: *mut obc_projected_gradient_result, host: *const obc_host, error: *mut obc_error) -> i32;
    /// Computes the point x (n entries, not y) of the feasible set nearest to y. Bounds: clipping. One row: the root of a monotone
    /// piecewise linear function (Dai and Fletcher 2006). More rows: semismooth Newton on the dual (Li, Sun, Toh 2018).
    /// multipliers (m entries, or NULL) receives t with x = clip(y + A't), up to a last correction along the free unknowns
    /// where y is too large for t to resolve it. result (or NULL) receives equality\_residual, projection\_passes, certificate\_gap and
    /// stop: CONVERGED, PROJECTION\_FAILED, or INFEASIBLE, for which multipliers receives the certificate.
    /// Errors: invalid argument, out of memory, cancelled.
    pub fn obc_projected_gradient_project(problem: *const obc_projected_gradient_problem, y: *const f64, x: *mut f64, multipliers: *mut f64, result: *mut obc_projected_gradient_result, host: *const obc_host, error: *mut obc_error) -> i32;
    /// Compares the gradient that f returns at x (n entries, moved into the bounds) with differences of its values along each axis,
    /// within the bounds and without regard to rows. Use it after a run that ended as STALLED. Errors: invalid argument (also: f has
    /// no value or gradient at x), cancelled (by the host or by STOP).
    pub fn obc_projected_gradient_check_gradient(problem: *const obc_projected_gradient_problem, f: obc_projected_gradient_function, user: *mut c_void, x: *const f64, check: *mut obc_projected_gradient_check, host: *const obc_host, error: *mut obc_error) -> i32;
    /// Returns the English name of a stop code, such as "evaluation budget"; a static string, never NULL.
    pub fn obc_projected_gradient_stop_name(stop: i32) -> *const c_char;
    /// Returns the version of the library, major \* 10000 + minor \* 100 + patch.
    pub fn obc_projected_gradient_version() -> u32;
}

#[cfg(all(test, target_pointer_width = "64"))]
mod layout {
    use super::*;
    use std::mem::{align_of, size_of, MaybeUninit};
    use std::ptr::addr_of;

    #[test]
    fn structs_lie_in_memory_as_in_c() {
        assert_eq!((size_of::<obc_projected_gradient_problem>(), align_of::<obc_projected_gradient_problem>()), (88, 8));
        let it = MaybeUninit::<obc_projected_gradient_problem>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_projected_gradient_problem.struct_size");
        assert_eq!(unsafe { addr_of!((*start).n) } as usize - start as usize, 8, "obc_projected_gradient_problem.n");
        assert_eq!(unsafe { addr_of!((*start).m) } as usize - start as usize, 16, "obc_projected_gradient_problem.m");
        assert_eq!(unsafe { addr_of!((*start).lower) } as usize - start as usize, 24, "obc_projected_gradient_problem.lower");
        assert_eq!(unsafe { addr_of!((*start).upper) } as usize - start as usize, 32, "obc_projected_gradient_problem.upper");
        assert_eq!(unsafe { addr_of!((*start).row_start) } as usize - start as usize, 40, "obc_projected_gradient_problem.row_start");
        assert_eq!(unsafe { addr_of!((*start).column) } as usize - start as usize, 48, "obc_projected_gradient_problem.column");
        assert_eq!(unsafe { addr_of!((*start).value) } as usize - start as usize, 56, "obc_projected_gradient_problem.value");
        assert_eq!(unsafe { addr_of!((*start).b) } as usize - start as usize, 64, "obc_projected_gradient_problem.b");
        assert_eq!(unsafe { addr_of!((*start).project) } as usize - start as usize, 72, "obc_projected_gradient_problem.project");
        assert_eq!(unsafe { addr_of!((*start).project_user) } as usize - start as usize, 80, "obc_projected_gradient_problem.project_user");
        assert_eq!((size_of::<obc_projected_gradient_options>(), align_of::<obc_projected_gradient_options>()), (64, 8));
        let it = MaybeUninit::<obc_projected_gradient_options>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_projected_gradient_options.struct_size");
        assert_eq!(unsafe { addr_of!((*start).method) } as usize - start as usize, 4, "obc_projected_gradient_options.method");
        assert_eq!(unsafe { addr_of!((*start).line_search) } as usize - start as usize, 8, "obc_projected_gradient_options.line_search");
        assert_eq!(unsafe { addr_of!((*start).memory) } as usize - start as usize, 12, "obc_projected_gradient_options.memory");
        assert_eq!(unsafe { addr_of!((*start).history) } as usize - start as usize, 16, "obc_projected_gradient_options.history");
        assert_eq!(unsafe { addr_of!((*start).average_weight) } as usize - start as usize, 24, "obc_projected_gradient_options.average_weight");
        assert_eq!(unsafe { addr_of!((*start).gradient_tolerance) } as usize - start as usize, 32, "obc_projected_gradient_options.gradient_tolerance");
        assert_eq!(unsafe { addr_of!((*start).target) } as usize - start as usize, 40, "obc_projected_gradient_options.target");
        assert_eq!(unsafe { addr_of!((*start).max_evaluations) } as usize - start as usize, 48, "obc_projected_gradient_options.max_evaluations");
        assert_eq!(unsafe { addr_of!((*start).max_iterations) } as usize - start as usize, 56, "obc_projected_gradient_options.max_iterations");
        assert_eq!((size_of::<obc_projected_gradient_result>(), align_of::<obc_projected_gradient_result>()), (72, 8));
        let it = MaybeUninit::<obc_projected_gradient_result>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_projected_gradient_result.struct_size");
        assert_eq!(unsafe { addr_of!((*start).stop) } as usize - start as usize, 4, "obc_projected_gradient_result.stop");
        assert_eq!(unsafe { addr_of!((*start).value) } as usize - start as usize, 8, "obc_projected_gradient_result.value");
        assert_eq!(unsafe { addr_of!((*start).projected_gradient) } as usize - start as usize, 16, "obc_projected_gradient_result.projected_gradient");
        assert_eq!(unsafe { addr_of!((*start).equality_residual) } as usize - start as usize, 24, "obc_projected_gradient_result.equality_residual");
        assert_eq!(unsafe { addr_of!((*start).evaluations) } as usize - start as usize, 32, "obc_projected_gradient_result.evaluations");
        assert_eq!(unsafe { addr_of!((*start).failed_evaluations) } as usize - start as usize, 40, "obc_projected_gradient_result.failed_evaluations");
        assert_eq!(unsafe { addr_of!((*start).iterations) } as usize - start as usize, 48, "obc_projected_gradient_result.iterations");
        assert_eq!(unsafe { addr_of!((*start).projection_passes) } as usize - start as usize, 56, "obc_projected_gradient_result.projection_passes");
        assert_eq!(unsafe { addr_of!((*start).certificate_gap) } as usize - start as usize, 64, "obc_projected_gradient_result.certificate_gap");
        assert_eq!((size_of::<obc_projected_gradient_check>(), align_of::<obc_projected_gradient_check>()), (64, 8));
        let it = MaybeUninit::<obc_projected_gradient_check>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_projected_gradient_check.struct_size");
        assert_eq!(unsafe { addr_of!((*start).agrees) } as usize - start as usize, 4, "obc_projected_gradient_check.agrees");
        assert_eq!(unsafe { addr_of!((*start).worst) } as usize - start as usize, 8, "obc_projected_gradient_check.worst");
        assert_eq!(unsafe { addr_of!((*start).told) } as usize - start as usize, 16, "obc_projected_gradient_check.told");
        assert_eq!(unsafe { addr_of!((*start).difference) } as usize - start as usize, 24, "obc_projected_gradient_check.difference");
        assert_eq!(unsafe { addr_of!((*start).error) } as usize - start as usize, 32, "obc_projected_gradient_check.error");
        assert_eq!(unsafe { addr_of!((*start).uncertainty) } as usize - start as usize, 40, "obc_projected_gradient_check.uncertainty");
        assert_eq!(unsafe { addr_of!((*start).compared) } as usize - start as usize, 48, "obc_projected_gradient_check.compared");
        assert_eq!(unsafe { addr_of!((*start).evaluations) } as usize - start as usize, 56, "obc_projected_gradient_check.evaluations");
    }
}
