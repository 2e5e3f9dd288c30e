//! What `<orbicube/projected_gradient.h>` declares. Written by scripts/bindings.py; not to be edited.
#![allow(non_camel_case_types, non_upper_case_globals)]

use crate::base::{obc_error, obc_host};
use std::os::raw::{c_char, c_void};

pub const OBC_PROJECTED_GRADIENT_FACE: i32 = 0;
pub const OBC_PROJECTED_GRADIENT_SEED: i32 = 1;

/// Grippo, Lampariello, Lucidi: below the largest of the last values
pub const OBC_PROJECTED_GRADIENT_LARGEST_OF_LAST: i32 = 0;
/// Zhang and Hager: below a weighted mean of all values
pub const OBC_PROJECTED_GRADIENT_AVERAGE: i32 = 1;

/// value and gradient of f at x; answer with \_tell
pub const OBC_PROJECTED_GRADIENT_NEED_FG: i32 = 1;
/// x is a new iterate; nothing to answer
pub const OBC_PROJECTED_GRADIENT_ITERATION: i32 = 2;
/// see \_result
pub const OBC_PROJECTED_GRADIENT_DONE: i32 = 3;

pub const OBC_PROJECTED_GRADIENT_RUNNING: i32 = 0;
/// |P(x - g) - x|inf \<= gradient\_tolerance
pub const OBC_PROJECTED_GRADIENT_CONVERGED: i32 = 1;
/// f \<= target
pub const OBC_PROJECTED_GRADIENT_TARGET_REACHED: i32 = 2;
pub const OBC_PROJECTED_GRADIENT_EVALUATION_BUDGET: i32 = 3;
pub const OBC_PROJECTED_GRADIENT_ITERATION_BUDGET: i32 = 4;
/// no step that the arithmetic resolves improves f
pub const OBC_PROJECTED_GRADIENT_STALLED: i32 = 5;
/// no x satisfies the constraints; see \_certificate
pub const OBC_PROJECTED_GRADIENT_INFEASIBLE: i32 = 6;
/// by the host's progress callback, or by the callback f
pub const OBC_PROJECTED_GRADIENT_CANCELLED: i32 = 7;
/// f not finite at the start, or all along two directions
pub const OBC_PROJECTED_GRADIENT_EVALUATION_FAILED: i32 = 8;
/// the caller's projection failed, or the rows could not be met
pub const OBC_PROJECTED_GRADIENT_PROJECTION_FAILED: i32 = 9;

pub const OBC_PROJECTED_GRADIENT_CONTINUE: i32 = 0;
/// end the run as cancelled; the best point so far is handed out
pub const OBC_PROJECTED_GRADIENT_STOP: i32 = 1;
/// f has no value at x; the method goes on elsewhere
pub const OBC_PROJECTED_GRADIENT_FAILED: i32 = 2;

/// A run of the method.
#[repr(C)]
pub struct obc_projected_gradient {
    _private: [u8; 0],
    _marker: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

/// Value and gradient (n entries) of f at x. A value or entry that is not finite counts as FAILED.
pub type obc_projected_gradient_function = Option<unsafe extern "C" fn(x: *const f64, n: usize, value: *mut f64, gradient: *mut f64, user: *mut c_void) -> i32>;

/// The point x (n entries) of a closed convex set that is nearest to y; x and y do not overlap. Answers 0, or anything else
/// when it cannot. Must depend on y alone.
pub type obc_projected_gradient_projection = Option<unsafe extern "C" fn(y: *const f64, n: usize, x: *mut f64, user: *mut c_void) -> i32>;

/// The feasible set; what is pointed at is copied. Fill with \_problem\_init first. Either bounds and rows, or a projection
/// of the caller's own. Rows may be redundant.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_projected_gradient_problem {
    pub struct_size: u32,
    /// unknowns, at least 1
    pub n: usize,
    /// rows of A, or 0
    pub m: usize,
    /// n entries, or NULL: none; infinities allowed. Starts and points to project are within 1e150
    pub lower: *const f64,
    pub upper: *const f64,
    /// m + 1 offsets into column and value: A by rows, each zero or of length 1e-150 to 1e150
    pub row_start: *const usize,
    /// entries of the same column in a row are summed
    pub column: *const u32,
    pub value: *const f64,
    /// m entries
    pub b: *const f64,
    /// or NULL
    pub project: obc_projected_gradient_projection,
    pub project_user: *mut c_void,
}

/// Fill with \_options\_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_projected_gradient_options {
    pub struct_size: u32,
    /// FACE
    pub method: i32,
    /// of SEED: LARGEST\_OF\_LAST
    pub line_search: i32,
    /// pairs of the model of FACE, 1 to 1000: 10
    pub memory: u32,
    /// values that LARGEST\_OF\_LAST looks back on: 10
    pub history: u32,
    /// eta of AVERAGE, 0 (monotone) to 1: 0.85
    pub average_weight: f64,
    /// on the projected gradient |P(x - g) - x|inf: 1e-8
    pub gradient_tolerance: f64,
    /// stop once f \<= target: -infinity
    pub target: f64,
    /// 100000
    pub max_evaluations: u64,
    /// 100000
    pub max_iterations: u64,
}

/// What is known of a run; set struct\_size before asking for it.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_projected_gradient_result {
    pub struct_size: u32,
    /// OBC\_PROJECTED\_GRADIENT\_RUNNING, ...
    pub stop: i32,
    /// f at the point handed out; NaN before the first value
    pub value: f64,
    /// |P(x - g) - x|inf at the current iterate
    pub projected_gradient: f64,
    /// largest |a'x - b| / (|b| + sum |a\_j x\_j|) of a row at the point handed out
    pub equality_residual: f64,
    pub evaluations: u64,
    pub failed_evaluations: u64,
    pub iterations: u64,
    /// over the unknowns, in all projections
    pub projection_passes: u64,
    /// see \_certificate
    pub certificate_gap: f64,
}

extern "C" {
    /// An empty problem: n = m = 0, no bounds.
    pub fn obc_projected_gradient_problem_init(problem: *mut obc_projected_gradient_problem, struct_size: usize) -> i32;
    /// The defaults, which the members' comments give.
    pub fn obc_projected_gradient_options_init(options: *mut obc_projected_gradient_options, struct_size: usize) -> i32;
    /// Makes a solver that starts from the feasible point nearest to x0 (n entries). options and host may be NULL; what the
    /// host points at must stay valid until \_destroy. Errors: invalid argument, out of memory. An empty feasible set is not an
    /// error here: the first step ends the run as INFEASIBLE.
    pub fn obc_projected_gradient_create(problem: *const obc_projected_gradient_problem, options: *const obc_projected_gradient_options, x0: *const f64, host: *const obc_host, out: *mut *mut obc_projected_gradient, error: *mut obc_error) -> i32;
    /// Goes on to the next request: NEED\_FG, ITERATION or DONE, or a negative obc\_status when the solver is NULL or on a defect.
    /// \*x (x may be NULL) is the point that is asked about, n entries of the solver's, valid until its next call. While a
    /// request waits for \_tell, and after DONE, the answer stays the same.
    pub fn obc_projected_gradient_step(solver: *mut obc_projected_gradient, x: *mut *const f64) -> i32;
    /// Answers NEED\_FG. A value or gradient entry that is not finite says that f cannot be evaluated there; gradient may be
    /// NULL then. Errors: invalid argument when nothing was asked.
    pub fn obc_projected_gradient_tell(solver: *mut obc_projected_gradient, value: f64, gradient: *const f64, error: *mut obc_error) -> i32;
    /// What is known now, at any time: result (or NULL), and x (n entries, or NULL), which is the iterate that met the tolerance
    /// if the run CONVERGED, else the lowest feasible point evaluated, and before that the projected start.
    pub fn obc_projected_gradient_get_result(solver: *const obc_projected_gradient, result: *mut obc_projected_gradient_result, x: *mut f64, error: *mut obc_error) -> i32;
    /// Multipliers t of the rows (m entries) at the current iterate: at a solution gradient - A't is zero where
    /// lower \< x \< upper, not negative at lower and not positive at upper.
    pub fn obc_projected_gradient_multipliers(solver: *const obc_projected_gradient, multipliers: *mut f64, error: *mut obc_error) -> i32;
    /// After INFEASIBLE: m numbers c with c'A x \< c'b for every x within the bounds (Farkas), where entries of A'c that are
    /// rounding (1e-9 of the length of c) count as zero against an infinite bound. certificate\_gap of the result is
    /// c'b - max c'A x \> 0. Invalid argument after any other end.
    pub fn obc_projected_gradient_certificate(solver: *const obc_projected_gradient, certificate: *mut f64, error: *mut obc_error) -> i32;
    /// A run as bytes, at any time between two calls: save\_size gives their number, save writes them to blob (capacity at least
    /// that). load makes a solver from them that goes on with the same bits; the problem must be the one of the saved run
    /// (a projection of the caller's is taken from it). The options are those of the saved run. For machines of the same byte
    /// order. Errors: invalid argument (another problem), malformed file (damaged, or of another version).
    pub fn obc_projected_gradient_save_size(solver: *const obc_projected_gradient) -> usize;
    /// A run as bytes, at any time between two calls: save\_size gives their number, save writes them to blob (capacity at least
    /// that). load makes a solver from them that goes on with the same bits; the problem must be the one of the saved run
    /// (a projection of the caller's is taken from it). The options are those of the saved run. For machines of the same byte
    /// order. Errors: invalid argument (another problem), malformed file (damaged, or of another version).
    pub fn obc_projected_gradient_save(solver: *const obc_projected_gradient, blob: *mut c_void, capacity: usize, error: *mut obc_error) -> i32;
    /// A run as bytes, at any time between two calls: save\_size gives their number, save writes them to blob (capacity at least
    /// that). load makes a solver from them that goes on with the same bits; the problem must be the one of the saved run
    /// (a projection of the caller's is taken from it). The options are those of the saved run. For machines of the same byte
    /// order. Errors: invalid argument (another problem), malformed file (damaged, or of another version).
    pub fn obc_projected_gradient_load(problem: *const obc_projected_gradient_problem, blob: *const c_void, size: usize, host: *const obc_host, out: *mut *mut obc_projected_gradient, error: *mut obc_error) -> i32;
    /// Releases a solver; NULL is fine.
    pub fn obc_projected_gradient_destroy(solver: *mut obc_projected_gradient);
    /// The loop over step with a callback: x (n entries) holds the start and gets what \_get\_result hands out; result may be
    /// NULL. Answers OBC\_OK however the run ended (result-\>stop), but OBC\_CANCELLED when the host cancelled it; x and result
    /// are filled then as well.
    pub fn obc_projected_gradient_minimize(problem: *const obc_projected_gradient_problem, options: *const obc_projected_gradient_options, f: obc_projected_gradient_function, user: *mut c_void, x: *mut f64, result: *mut obc_projected_gradient_result, host: *const obc_host, error: *mut obc_error) -> i32;
    /// The projection alone: x (n entries, not y) is the point of the feasible set nearest to y. Box: clipping. One row: a root
    /// of a monotone piecewise linear function (Dai and Fletcher 2006). More rows: semismooth Newton on the dual (Li, Sun, Toh
    /// 2018). multipliers (m entries, or NULL) gets t with x = clip(y + A't), up to a last correction along the free unknowns
    /// where y is so large that t cannot resolve it. Of result (or NULL) stop, equality\_residual, projection\_passes and
    /// certificate\_gap are filled: stop is CONVERGED, PROJECTION\_FAILED, or INFEASIBLE, when multipliers gets the certificate.
    pub fn obc_projected_gradient_project(problem: *const obc_projected_gradient_problem, y: *const f64, x: *mut f64, multipliers: *mut f64, result: *mut obc_projected_gradient_result, host: *const obc_host, error: *mut obc_error) -> i32;
    /// English name of a stop, such as "evaluation budget". Never NULL; a static string.
    pub fn obc_projected_gradient_stop_name(stop: i32) -> *const c_char;
    /// Version of this library, major \* 10000 + minor \* 100 + patch.
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
    }
}
