//! What `<orbicube/trust_region.h>` declares. Written by scripts/bindings.py; not to be edited.
#![allow(non_camel_case_types, non_upper_case_globals)]

use crate::base::{obc_error, obc_host};
use std::os::raw::{c_char, c_void};

/// radius of steps and resolution
pub const OBC_TRUST_REGION_TWO_RADII: i32 = 0;
/// the dissertation's radius rule, for comparison
pub const OBC_TRUST_REGION_DISSERTATION: i32 = 1;

/// CROSS for a scalar f with bounds, otherwise CHAIN
pub const OBC_TRUST_REGION_AUTOMATIC: i32 = 0;
/// n + 1 points, each one step along an axis from the best so far
pub const OBC_TRUST_REGION_CHAIN: i32 = 1;
/// x0 and steps to both sides along the axes, all requested at once
pub const OBC_TRUST_REGION_CROSS: i32 = 2;

/// sum\_i sign\_i r\_i^2
pub const OBC_TRUST_REGION_SUM_OF_SQUARES: i32 = 0;
/// sum\_i |r\_i|: L1 fits
pub const OBC_TRUST_REGION_SUM_OF_MAGNITUDES: i32 = 1;
/// max\_i |r\_i|: Chebyshev fits
pub const OBC_TRUST_REGION_MAX_MAGNITUDE: i32 = 2;
/// max\_i r\_i: minimax problems
pub const OBC_TRUST_REGION_MAX_VALUE: i32 = 3;

/// evaluate f, or the residuals, at each of \*count points, then call \_tell
pub const OBC_TRUST_REGION_NEED_VALUES: i32 = 1;
/// a step is complete; requires no action
pub const OBC_TRUST_REGION_ITERATION: i32 = 2;
/// the run has ended; see \_get\_result
pub const OBC_TRUST_REGION_DONE: i32 = 3;

/// not ended
pub const OBC_TRUST_REGION_RUNNING: i32 = 0;
/// the resolution reached radius\_end, and no step improves the models
pub const OBC_TRUST_REGION_CONVERGED: i32 = 1;
/// f \<= target
pub const OBC_TRUST_REGION_TARGET_REACHED: i32 = 2;
/// max\_evaluations reached
pub const OBC_TRUST_REGION_EVALUATION_BUDGET: i32 = 3;
/// the values around the best point differ by less than the noise
pub const OBC_TRUST_REGION_NOISE_LIMIT: i32 = 4;
/// no set of points that double precision resolves
pub const OBC_TRUST_REGION_STALLED: i32 = 5;
/// by the host's progress callback or by the callback f
pub const OBC_TRUST_REGION_CANCELLED: i32 = 6;
/// no value at x0 of a CHAIN, or more than 80 + 8n (DISSERTATION: 20 + 2n) failures in a row
pub const OBC_TRUST_REGION_EVALUATION_FAILED: i32 = 7;
/// the resolution reached radius\_end while the models still have a descent direction: at the
/// boundary of the domain of f, where f is not smooth, or where the given scale is
/// far from the lengths over which f bends
pub const OBC_TRUST_REGION_RESOLUTION_LIMIT: i32 = 8;

/// outputs are set
pub const OBC_TRUST_REGION_CONTINUE: i32 = 0;
/// end the run as CANCELLED with the best point so far. Outputs that are set as well count if all
/// of them are finite
pub const OBC_TRUST_REGION_STOP: i32 = 1;
/// f is undefined at x; the method continues elsewhere
pub const OBC_TRUST_REGION_FAILED: i32 = 2;

/// A run of the method.
#[repr(C)]
pub struct obc_trust_region {
    _private: [u8; 0],
    _marker: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

/// Evaluates f, or the residuals, at x: 1 or \`residuals\` entries of outputs. An entry that is not finite counts as FAILED. Returns one
/// of the constants above.
pub type obc_trust_region_function = Option<unsafe extern "C" fn(x: *const f64, n: usize, outputs: *mut f64, user: *mut c_void) -> i32>;

/// The problem. Arrays are copied. Fill with \_problem\_init, or with zeros and struct\_size, which is the same: in C99
/// {.struct\_size = sizeof(obc\_trust\_region\_problem), .n = 2}.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_trust_region_problem {
    pub struct_size: u32,
    /// number of unknowns, at least 1. Default: 0, which must be set.
    pub n: usize,
    /// number m of residuals; 0: a scalar f. Default: 0.
    pub residuals: usize,
    /// n lower bounds, -infinity allowed; NULL: none. Equal bounds fix an unknown. Default: NULL.
    pub lower: *const f64,
    /// n upper bounds, infinity allowed; NULL: none. Default: NULL.
    pub upper: *const f64,
    /// Typical magnitudes of the unknowns, n entries from 1e-150 to 1e150; radii are lengths of (x - y) / scale. NULL: 1 for unknowns of
    /// like magnitude. NULL where the widths of boxes differ by more than 10, one is below 0.01, or magnitudes of x0 differ by more
    /// than 1e4: upper - lower, and for unknowns without two bounds the larger distance of x0 from 0 and from its bound. NULL
    /// with a radius\_begin: the width over that of the narrowest box, and 1 without two bounds. Default: NULL.
    pub scale: *const f64,
    /// m signs of the squares, 1 or -1; NULL: 1. With a -1 f may have no minimum without bounds or a target. Default: NULL.
    pub sign: *const f64,
    /// OBC\_TRUST\_REGION\_SUM\_OF\_SQUARES or another, which needs residuals and no sign. Default: SUM\_OF\_SQUARES.
    pub objective: i32,
}

/// Options of a run. Fill with \_options\_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_trust_region_options {
    pub struct_size: u32,
    /// OBC\_TRUST\_REGION\_TWO\_RADII or DISSERTATION. Default: TWO\_RADII.
    pub method: i32,
    /// initial points, OBC\_TRUST\_REGION\_AUTOMATIC, CHAIN or CROSS. Default: AUTOMATIC.
    pub start: i32,
    /// Maximum number of interpolation points, n + 2 to (n+1)(n+2)/2. 0: the larger of 6n + 1 and 45, with residuals of 2n + 1 and
    /// 91, limited to the number for a full quadratic; DISSERTATION 2n + 1. Default: 0.
    pub points: u64,
    /// initial radius of steps. 0: a tenth of max(1, |x0 / scale|inf), or of 1 for a scale by boxes. Default: 0.
    pub radius_begin: f64,
    /// final resolution, about the accuracy of x / scale. Default: 1e-8.
    pub radius_end: f64,
    /// ends the run at f \<= target. Default: -infinity.
    pub target: f64,
    /// the error of f is up to max(noise\_absolute, noise\_relative |f|). Default: 0.
    pub noise_absolute: f64,
    /// see noise\_absolute. Default: 0.
    pub noise_relative: f64,
    /// Number of restarts around the best point with another radius. At the boundary of the domain of f, and where noise or the
    /// resolution limit ends it, a run also restarts as long as that lowers f by a thousandth and by the noise. Default: 0.
    pub restarts: u64,
    /// maximum number of evaluations; 0: 500 (n + 1). Default: 0.
    pub max_evaluations: u64,
}

/// State of a run. The caller sets struct\_size.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_trust_region_result {
    pub struct_size: u32,
    /// stop code, OBC\_TRUST\_REGION\_RUNNING or another
    pub stop: i32,
    /// f at the best point; NaN before the first value
    pub value: f64,
    /// current radius of steps; without bounds along the longest axis of the trust-region ellipsoid
    pub radius: f64,
    /// current resolution
    pub resolution: f64,
    /// number of evaluations, including failed ones
    pub evaluations: u64,
    /// number of evaluations without a value
    pub failed_evaluations: u64,
    /// number of iterations
    pub iterations: u64,
    /// number of restarts
    pub restarts: u64,
    /// current number of interpolation points
    pub points: u64,
    /// number of times the interpolation was rebuilt, because of rounding or a long move
    pub rebuilds: u64,
}

extern "C" {
    /// Fills a problem with n = 0, a scalar f and no bounds.
    pub fn obc_trust_region_problem_init(problem: *mut obc_trust_region_problem, struct_size: usize) -> i32;
    /// Fills options with the defaults.
    pub fn obc_trust_region_options_init(options: *mut obc_trust_region_options, struct_size: usize) -> i32;
    /// Creates a solver that starts at x0 (n entries, x0 / scale within 1e150), moved into the bounds. options and host may be NULL;
    /// what the host points to must remain valid until \_destroy. Errors: invalid argument, out of memory.
    pub fn obc_trust_region_create(problem: *const obc_trust_region_problem, options: *const obc_trust_region_options, x0: *const f64, host: *const obc_host, out: *mut *mut obc_trust_region, error: *mut obc_error) -> i32;
    /// Supplies earlier evaluations before the first step: \`count\` points (count x n, row by row, within the bounds) with their outputs
    /// (count, or count x m). They do not count against max\_evaluations. The run starts at the lowest of them in place of x0 and
    /// uses nearby ones in place of its own evaluations; of more points than it can interpolate it keeps the lowest.
    /// Errors: invalid argument (also for an output that is not finite), out of memory.
    pub fn obc_trust_region_give(solver: *mut obc_trust_region, points: *const f64, outputs: *const f64, count: usize, error: *mut obc_error) -> i32;
    /// Advances to the next request and returns it: NEED\_VALUES, ITERATION or DONE, or a negative obc\_status for NULL or after a
    /// defect. With NEED\_VALUES, \*points (points may be NULL) are \*count (count may be NULL) rows of n entries in memory of the solver,
    /// valid until its next call other than \_tell. The rows may be evaluated in parallel; there is one, except at the start of a
    /// CROSS. Until \_tell has supplied all of them, and after DONE, the same request is returned, without the supplied rows.
    pub fn obc_trust_region_step(solver: *mut obc_trust_region, points: *mut *const f64, count: *mut usize) -> i32;
    /// Supplies f, or m residuals, at the first requested point. An entry that is not finite, or outputs NULL, means that f is
    /// undefined there. Errors: invalid argument if no request waits.
    pub fn obc_trust_region_tell(solver: *mut obc_trust_region, outputs: *const f64, error: *mut obc_error) -> i32;
    /// Copies the current state at any time: result (or NULL), and the lowest evaluated point, x (n entries, or NULL), with its outputs
    /// (1 or m, or NULL; NaN before the first value). Before the first value x is the start. Errors: invalid argument.
    pub fn obc_trust_region_get_result(solver: *const obc_trust_region, result: *mut obc_trust_region_result, x: *mut f64, outputs: *mut f64, error: *mut obc_error) -> i32;
    /// Save and restore a run between two calls. save\_size returns the number of bytes, save writes them to blob, whose capacity is at
    /// least that. load creates a solver that continues with the same bits and the saved options; the problem must be that of the
    /// saved run. Both machines need the same byte order. Errors: invalid argument (another problem), malformed file (damaged,
    /// or of another version), out of memory.
    pub fn obc_trust_region_save_size(solver: *const obc_trust_region) -> usize;
    /// Save and restore a run between two calls. save\_size returns the number of bytes, save writes them to blob, whose capacity is at
    /// least that. load creates a solver that continues with the same bits and the saved options; the problem must be that of the
    /// saved run. Both machines need the same byte order. Errors: invalid argument (another problem), malformed file (damaged,
    /// or of another version), out of memory.
    pub fn obc_trust_region_save(solver: *const obc_trust_region, blob: *mut c_void, capacity: usize, error: *mut obc_error) -> i32;
    /// Save and restore a run between two calls. save\_size returns the number of bytes, save writes them to blob, whose capacity is at
    /// least that. load creates a solver that continues with the same bits and the saved options; the problem must be that of the
    /// saved run. Both machines need the same byte order. Errors: invalid argument (another problem), malformed file (damaged,
    /// or of another version), out of memory.
    pub fn obc_trust_region_load(problem: *const obc_trust_region_problem, blob: *const c_void, size: usize, host: *const obc_host, out: *mut *mut obc_trust_region, error: *mut obc_error) -> i32;
    /// Destroys a solver; NULL is allowed.
    pub fn obc_trust_region_destroy(solver: *mut obc_trust_region);
    /// Runs to the end with a callback. x (n entries) is the start and receives the best point; result may be NULL. Returns OBC\_OK
    /// however the run ended (see result-\>stop), except OBC\_CANCELLED where the host cancelled it; x and result are filled in that case
    /// too. Errors: invalid argument, out of memory, cancelled.
    pub fn obc_trust_region_minimize(problem: *const obc_trust_region_problem, options: *const obc_trust_region_options, f: obc_trust_region_function, user: *mut c_void, x: *mut f64, result: *mut obc_trust_region_result, host: *const obc_host, error: *mut obc_error) -> i32;
    /// Returns the English name of a stop code, such as "converged"; a static string, never NULL.
    pub fn obc_trust_region_stop_name(stop: i32) -> *const c_char;
    /// Returns the version of the library, major \* 10000 + minor \* 100 + patch.
    pub fn obc_trust_region_version() -> u32;
}

#[cfg(all(test, target_pointer_width = "64"))]
mod layout {
    use super::*;
    use std::mem::{align_of, size_of, MaybeUninit};
    use std::ptr::addr_of;

    #[test]
    fn structs_lie_in_memory_as_in_c() {
        assert_eq!((size_of::<obc_trust_region_problem>(), align_of::<obc_trust_region_problem>()), (64, 8));
        let it = MaybeUninit::<obc_trust_region_problem>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_trust_region_problem.struct_size");
        assert_eq!(unsafe { addr_of!((*start).n) } as usize - start as usize, 8, "obc_trust_region_problem.n");
        assert_eq!(unsafe { addr_of!((*start).residuals) } as usize - start as usize, 16, "obc_trust_region_problem.residuals");
        assert_eq!(unsafe { addr_of!((*start).lower) } as usize - start as usize, 24, "obc_trust_region_problem.lower");
        assert_eq!(unsafe { addr_of!((*start).upper) } as usize - start as usize, 32, "obc_trust_region_problem.upper");
        assert_eq!(unsafe { addr_of!((*start).scale) } as usize - start as usize, 40, "obc_trust_region_problem.scale");
        assert_eq!(unsafe { addr_of!((*start).sign) } as usize - start as usize, 48, "obc_trust_region_problem.sign");
        assert_eq!(unsafe { addr_of!((*start).objective) } as usize - start as usize, 56, "obc_trust_region_problem.objective");
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
