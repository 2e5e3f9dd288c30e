//! What `<orbicube/trust_region.h>` declares. Written by scripts/bindings.py; not to be edited.
#![allow(non_camel_case_types, non_upper_case_globals)]

use crate::base::{obc_error, obc_host};
use std::os::raw::{c_char, c_void};

pub const OBC_TRUST_REGION_TWO_RADII: i32 = 0;
/// the dissertation's radius rule
pub const OBC_TRUST_REGION_SEED: i32 = 1;

/// CROSS for a scalar f with bounds, else CHAIN
pub const OBC_TRUST_REGION_AUTOMATIC: i32 = 0;
/// n + 1 points, each a step along an axis from the best so far
pub const OBC_TRUST_REGION_CHAIN: i32 = 1;
/// x0 and steps to both sides along the axes, all asked for at once
pub const OBC_TRUST_REGION_CROSS: i32 = 2;

/// f, or the residuals, at each of count points; answer with \_tell
pub const OBC_TRUST_REGION_NEED_VALUES: i32 = 1;
/// a step was taken into account; nothing to answer
pub const OBC_TRUST_REGION_ITERATION: i32 = 2;
/// see \_get\_result
pub const OBC_TRUST_REGION_DONE: i32 = 3;

pub const OBC_TRUST_REGION_RUNNING: i32 = 0;
/// the resolution reached radius\_end and no step improves the models
pub const OBC_TRUST_REGION_CONVERGED: i32 = 1;
pub const OBC_TRUST_REGION_TARGET_REACHED: i32 = 2;
pub const OBC_TRUST_REGION_EVALUATION_BUDGET: i32 = 3;
/// the values around the best point differ by less than the noise
pub const OBC_TRUST_REGION_NOISE_LIMIT: i32 = 4;
/// no set of points that the arithmetic resolves
pub const OBC_TRUST_REGION_STALLED: i32 = 5;
/// by the host's progress callback, or by the callback f
pub const OBC_TRUST_REGION_CANCELLED: i32 = 6;
/// no value at x0 of a CHAIN, or more than 20 + 2n failures in a row
pub const OBC_TRUST_REGION_EVALUATION_FAILED: i32 = 7;

pub const OBC_TRUST_REGION_CONTINUE: i32 = 0;
/// end the run as cancelled; the best point so far is handed out
pub const OBC_TRUST_REGION_STOP: i32 = 1;
/// f has no value at x; the method goes on elsewhere
pub const OBC_TRUST_REGION_FAILED: i32 = 2;

/// A run of the method.
#[repr(C)]
pub struct obc_trust_region {
    _private: [u8; 0],
    _marker: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

/// f, or the residuals (one or \`residuals\` entries of outputs), at x. An entry that is not finite counts as FAILED.
pub type obc_trust_region_function = Option<unsafe extern "C" fn(x: *const f64, n: usize, outputs: *mut f64, user: *mut c_void) -> i32>;

/// What is minimised; what is pointed at is copied. Fill with \_problem\_init first.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_trust_region_problem {
    pub struct_size: u32,
    /// unknowns, at least 1
    pub n: usize,
    /// m, or 0: a scalar f
    pub residuals: usize,
    /// n entries, or NULL: none; infinities allowed; equal bounds fix an unknown
    pub lower: *const f64,
    pub upper: *const f64,
    /// n typical magnitudes of the unknowns, 1e-150 to 1e150, or NULL: 1. Radii are lengths of (x - y) / scale
    pub scale: *const f64,
    /// m entries, 1 or -1, or NULL: 1. With a -1, f may have no minimum: give bounds or a target
    pub sign: *const f64,
}

/// Fill with \_options\_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_trust_region_options {
    pub struct_size: u32,
    /// TWO\_RADII
    pub method: i32,
    /// AUTOMATIC
    pub start: i32,
    /// interpolated at most, n + 2 to (n+1)(n+2)/2: 0, which is the larger of 6n + 1 and 45, with
    /// residuals of 2n + 1 and 91, or all that a full quadratic has where that is less; SEED 2n + 1
    pub points: u64,
    /// of steps at the start: 0, a tenth of max(1, |x0 / scale|inf)
    pub radius_begin: f64,
    /// of the resolution at the end, about the accuracy wanted of x / scale: 1e-8
    pub radius_end: f64,
    /// stop once f \<= target: -infinity
    pub target: f64,
    /// f is known to max(noise\_absolute, noise\_relative |f|) only: 0
    pub noise_absolute: f64,
    /// 0
    pub noise_relative: f64,
    /// times to begin again around the best point, with another radius: 0
    pub restarts: u64,
    /// 0: 500 (n + 1)
    pub max_evaluations: u64,
}

/// What is known of a run; set struct\_size before asking for it.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_trust_region_result {
    pub struct_size: u32,
    /// OBC\_TRUST\_REGION\_RUNNING, ...
    pub stop: i32,
    /// f at the best point; NaN before the first value
    pub value: f64,
    /// of steps, now; without bounds along the longest axis of a trust region that is an ellipsoid
    pub radius: f64,
    pub resolution: f64,
    pub evaluations: u64,
    pub failed_evaluations: u64,
    pub iterations: u64,
    pub restarts: u64,
    /// interpolated now
    pub points: u64,
    /// of the interpolation from scratch, because of rounding or a far move
    pub rebuilds: u64,
}

extern "C" {
    /// An empty problem: n = 0, a scalar f, no bounds.
    pub fn obc_trust_region_problem_init(problem: *mut obc_trust_region_problem, struct_size: usize) -> i32;
    /// The defaults, which the members' comments give.
    pub fn obc_trust_region_options_init(options: *mut obc_trust_region_options, struct_size: usize) -> i32;
    /// Makes a solver that starts at x0 (n entries, x0 / scale within 1e150), moved into the bounds. options and host may be NULL; what the host points at
    /// must stay valid until \_destroy. Errors: invalid argument, out of memory.
    pub fn obc_trust_region_create(problem: *const obc_trust_region_problem, options: *const obc_trust_region_options, x0: *const f64, host: *const obc_host, out: *mut *mut obc_trust_region, error: *mut obc_error) -> i32;
    /// Gives evaluations made before, \`count\` points (count x n, row by row, within the bounds) with their outputs (count, or
    /// count x m): before the first step. They do not count against max\_evaluations. The run begins at the lowest of them
    /// instead of x0, and uses those near it in the place of evaluations of its own; of more than it can interpolate it keeps
    /// the lowest. Errors: invalid argument (also for an output that is not finite).
    pub fn obc_trust_region_give(solver: *mut obc_trust_region, points: *const f64, outputs: *const f64, count: usize, error: *mut obc_error) -> i32;
    /// Goes on to the next request: NEED\_VALUES, ITERATION or DONE, or a negative obc\_status when the solver is NULL or on a
    /// defect. With NEED\_VALUES, \*points (may be NULL) is what is asked for: \*count (may be NULL) rows of n entries, in the
    /// solver's memory until its next call other than \_tell. Rows may be evaluated at the same time; there is one, but at the
    /// start of a CROSS. Until each is answered by \_tell, and after DONE, the answer stays the same, less the rows told.
    pub fn obc_trust_region_step(solver: *mut obc_trust_region, points: *mut *const f64, count: *mut usize) -> i32;
    /// Answers NEED\_VALUES at the first of the points asked for: f, or m residuals. Not finite, or outputs NULL: f cannot be
    /// evaluated there. Errors: invalid argument when nothing was asked.
    pub fn obc_trust_region_tell(solver: *mut obc_trust_region, outputs: *const f64, error: *mut obc_error) -> i32;
    /// What is known now, at any time: result (or NULL), and the lowest point evaluated, x (n entries, or NULL) with its outputs (1
    /// or m, or NULL; NaN before the first value). Before the first value x is the start.
    pub fn obc_trust_region_get_result(solver: *const obc_trust_region, result: *mut obc_trust_region_result, x: *mut f64, outputs: *mut f64, error: *mut obc_error) -> i32;
    /// A run as bytes, at any time between two calls: save\_size gives their number, save writes them to blob (capacity at least
    /// that). load makes a solver from them that goes on with the same bits; the problem must be the one of the saved run, the
    /// options are those of the saved run. For machines of the same byte order. Errors: invalid argument (another problem),
    /// malformed file (damaged, or of another version).
    pub fn obc_trust_region_save_size(solver: *const obc_trust_region) -> usize;
    /// A run as bytes, at any time between two calls: save\_size gives their number, save writes them to blob (capacity at least
    /// that). load makes a solver from them that goes on with the same bits; the problem must be the one of the saved run, the
    /// options are those of the saved run. For machines of the same byte order. Errors: invalid argument (another problem),
    /// malformed file (damaged, or of another version).
    pub fn obc_trust_region_save(solver: *const obc_trust_region, blob: *mut c_void, capacity: usize, error: *mut obc_error) -> i32;
    /// A run as bytes, at any time between two calls: save\_size gives their number, save writes them to blob (capacity at least
    /// that). load makes a solver from them that goes on with the same bits; the problem must be the one of the saved run, the
    /// options are those of the saved run. For machines of the same byte order. Errors: invalid argument (another problem),
    /// malformed file (damaged, or of another version).
    pub fn obc_trust_region_load(problem: *const obc_trust_region_problem, blob: *const c_void, size: usize, host: *const obc_host, out: *mut *mut obc_trust_region, error: *mut obc_error) -> i32;
    /// Frees a solver; NULL is fine.
    pub fn obc_trust_region_destroy(solver: *mut obc_trust_region);
    /// Runs to the end with a callback. x (n entries) is the start and receives the best point; result may be NULL. Errors:
    /// invalid argument, out of memory, cancelled (by the host; x and result are filled). How the run ended is result's stop.
    pub fn obc_trust_region_minimize(problem: *const obc_trust_region_problem, options: *const obc_trust_region_options, f: obc_trust_region_function, user: *mut c_void, x: *mut f64, result: *mut obc_trust_region_result, host: *const obc_host, error: *mut obc_error) -> i32;
    /// Short English name of an end, such as "converged". Never NULL; a static string.
    pub fn obc_trust_region_stop_name(stop: i32) -> *const c_char;
    /// Version of this library, major \* 10000 + minor \* 100 + patch.
    pub fn obc_trust_region_version() -> u32;
}

#[cfg(all(test, target_pointer_width = "64"))]
mod layout {
    use super::*;
    use std::mem::{align_of, size_of, MaybeUninit};
    use std::ptr::addr_of;

    #[test]
    fn structs_lie_in_memory_as_in_c() {
        assert_eq!((size_of::<obc_trust_region_problem>(), align_of::<obc_trust_region_problem>()), (56, 8));
        let it = MaybeUninit::<obc_trust_region_problem>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_trust_region_problem.struct_size");
        assert_eq!(unsafe { addr_of!((*start).n) } as usize - start as usize, 8, "obc_trust_region_problem.n");
        assert_eq!(unsafe { addr_of!((*start).residuals) } as usize - start as usize, 16, "obc_trust_region_problem.residuals");
        assert_eq!(unsafe { addr_of!((*start).lower) } as usize - start as usize, 24, "obc_trust_region_problem.lower");
        assert_eq!(unsafe { addr_of!((*start).upper) } as usize - start as usize, 32, "obc_trust_region_problem.upper");
        assert_eq!(unsafe { addr_of!((*start).scale) } as usize - start as usize, 40, "obc_trust_region_problem.scale");
        assert_eq!(unsafe { addr_of!((*start).sign) } as usize - start as usize, 48, "obc_trust_region_problem.sign");
        assert_eq!((size_of::<obc_trust_region_options>(), align_of::<obc_trust_region_options>()), (80, 8));
        let it = MaybeUninit::<obc_trust_region_options>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_trust_region_options.struct_size");
        assert_eq!(unsafe { addr_of!((*start).method) } as usize - start as usize, 4, "obc_trust_region_options.method");
        assert_eq!(unsafe { addr_of!((*start).start) } as usize - start as usize, 8, "obc_trust_region_options.start");
        assert_eq!(unsafe { addr_of!((*start).points) } as usize - start as usize, 16, "obc_trust_region_options.points");
        assert_eq!(unsafe { addr_of!((*start).radius_begin) } as usize - start as usize, 24, "obc_trust_region_options.radius_begin");
        assert_eq!(unsafe { addr_of!((*start).radius_end) } as usize - start as usize, 32, "obc_trust_region_options.radius_end");
        assert_eq!(unsafe { addr_of!((*start).target) } as usize - start as usize, 40, "obc_trust_region_options.target");
        assert_eq!(unsafe { addr_of!((*start).noise_absolute) } as usize - start as usize, 48, "obc_trust_region_options.noise_absolute");
        assert_eq!(unsafe { addr_of!((*start).noise_relative) } as usize - start as usize, 56, "obc_trust_region_options.noise_relative");
        assert_eq!(unsafe { addr_of!((*start).restarts) } as usize - start as usize, 64, "obc_trust_region_options.restarts");
        assert_eq!(unsafe { addr_of!((*start).max_evaluations) } as usize - start as usize, 72, "obc_trust_region_options.max_evaluations");
        assert_eq!((size_of::<obc_trust_region_result>(), align_of::<obc_trust_region_result>()), (80, 8));
        let it = MaybeUninit::<obc_trust_region_result>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_trust_region_result.struct_size");
        assert_eq!(unsafe { addr_of!((*start).stop) } as usize - start as usize, 4, "obc_trust_region_result.stop");
        assert_eq!(unsafe { addr_of!((*start).value) } as usize - start as usize, 8, "obc_trust_region_result.value");
        assert_eq!(unsafe { addr_of!((*start).radius) } as usize - start as usize, 16, "obc_trust_region_result.radius");
        assert_eq!(unsafe { addr_of!((*start).resolution) } as usize - start as usize, 24, "obc_trust_region_result.resolution");
        assert_eq!(unsafe { addr_of!((*start).evaluations) } as usize - start as usize, 32, "obc_trust_region_result.evaluations");
        assert_eq!(unsafe { addr_of!((*start).failed_evaluations) } as usize - start as usize, 40, "obc_trust_region_result.failed_evaluations");
        assert_eq!(unsafe { addr_of!((*start).iterations) } as usize - start as usize, 48, "obc_trust_region_result.iterations");
        assert_eq!(unsafe { addr_of!((*start).restarts) } as usize - start as usize, 56, "obc_trust_region_result.restarts");
        assert_eq!(unsafe { addr_of!((*start).points) } as usize - start as usize, 64, "obc_trust_region_result.points");
        assert_eq!(unsafe { addr_of!((*start).rebuilds) } as usize - start as usize, 72, "obc_trust_region_result.rebuilds");
    }
}
