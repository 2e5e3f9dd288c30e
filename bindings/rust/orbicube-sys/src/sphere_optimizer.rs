//! What `<orbicube/sphere_optimizer.h>` declares. Written by scripts/bindings.py; not to be edited.
#![allow(non_camel_case_types, non_upper_case_globals)]

use crate::base::{obc_error, obc_host};
use std::os::raw::{c_char, c_void};

pub const OBC_SPHERE_OPTIMIZER_LIMITED_MEMORY: i32 = 0;
pub const OBC_SPHERE_OPTIMIZER_BARZILAI_BORWEIN: i32 = 1;
pub const OBC_SPHERE_OPTIMIZER_GREAT_CIRCLE: i32 = 2;
pub const OBC_SPHERE_OPTIMIZER_DISSERTATION: i32 = 3;
pub const OBC_SPHERE_OPTIMIZER_TRUNCATED_NEWTON: i32 = 4;

/// evaluate f and its gradient at x, then call \_tell
pub const OBC_SPHERE_OPTIMIZER_NEED_FG: i32 = 1;
/// x is a new iterate; requires no action
pub const OBC_SPHERE_OPTIMIZER_ITERATION: i32 = 2;
/// the run has ended; see \_get\_result
pub const OBC_SPHERE_OPTIMIZER_DONE: i32 = 3;
/// compute the product of the Hessian of f at x and the vector of \_get\_direction, then call
/// \_tell\_product. Only with the option hessian\_products
pub const OBC_SPHERE_OPTIMIZER_NEED_PRODUCT: i32 = 4;

/// not ended
pub const OBC_SPHERE_OPTIMIZER_RUNNING: i32 = 0;
/// the tangent gradient of each block is at most gradient\_tolerance long
pub const OBC_SPHERE_OPTIMIZER_CONVERGED: i32 = 1;
/// f \<= target
pub const OBC_SPHERE_OPTIMIZER_TARGET_REACHED: i32 = 2;
/// max\_evaluations reached
pub const OBC_SPHERE_OPTIMIZER_EVALUATION_BUDGET: i32 = 3;
/// max\_iterations or max\_passes reached
pub const OBC_SPHERE_OPTIMIZER_ITERATION_BUDGET: i32 = 4;
/// no step that double precision resolves lowers f, or lowers it by relative\_gain
pub const OBC_SPHERE_OPTIMIZER_STALLED: i32 = 5;
/// by the host's progress callback or by the callback f
pub const OBC_SPHERE_OPTIMIZER_CANCELLED: i32 = 6;
/// f is not finite at the start, or along two whole directions
pub const OBC_SPHERE_OPTIMIZER_EVALUATION_FAILED: i32 = 7;

/// value and gradient are set
pub const OBC_SPHERE_OPTIMIZER_CONTINUE: i32 = 0;
/// end the run as CANCELLED with the best point so far. A finite value that is set as well
/// counts; the gradient is unused
pub const OBC_SPHERE_OPTIMIZER_STOP: i32 = 1;
/// f is undefined at x; the method continues elsewhere
pub const OBC_SPHERE_OPTIMIZER_FAILED: i32 = 2;

/// QUEUE, then SWEEPS when gains decrease slowly
pub const OBC_SPHERE_OPTIMIZER_AUTOMATIC: i32 = 0;
/// the block first for which it or a neighbor gained most in the last step
pub const OBC_SPHERE_OPTIMIZER_QUEUE: i32 = 1;
/// 0, 1, 2, ... repeatedly
pub const OBC_SPHERE_OPTIMIZER_SWEEPS: i32 = 2;

/// A run of the all-at-once solver.
#[repr(C)]
pub struct obc_sphere_optimizer {
    _private: [u8; 0],
    _marker: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

/// A relaxation that runs in parts.
#[repr(C)]
pub struct obc_sphere_optimizer_relaxation {
    _private: [u8; 0],
    _marker: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

/// Evaluates f at x (count blocks of dimension numbers, consecutive) and its gradient in the same order: the gradient in R^d of each
/// block, or any vector with the same tangential component. DISSERTATION uses the whole gradient; LIMITED\_MEMORY takes the normal component as an
/// estimate of the stiffness of each block, which saves evaluations, and TRUNCATED\_NEWTON with hessian\_products needs the whole. A value or entry that is not finite counts as FAILED. Returns one
/// of the constants above.
pub type obc_sphere_optimizer_function = Option<unsafe extern "C" fn(x: *const f64, count: usize, dimension: usize, value: *mut f64, gradient: *mut f64, user: *mut c_void) -> i32>;

/// Computes the product of the Hessian of f in R^(count dimension) at x with a direction, which is tangent to the spheres; x, direction and
/// product have count \* dimension numbers. f was evaluated at the same x before. An entry that is not finite counts as FAILED, which ends
/// the search for a step, not the run. Returns one of the constants above.
pub type obc_sphere_optimizer_product_function = Option<unsafe extern "C" fn(x: *const f64, direction: *const f64, count: usize, dimension: usize, product: *mut f64, user: *mut c_void) -> i32>;

/// Evaluates the terms of f that contain \`block\`, with that block at \`place\` (dimension numbers) and all others as in \`points\` (all
/// blocks). With gradient not NULL (dimension numbers), place is the current position of the block; with hessian not NULL
/// (dimension squared, by rows) it returns second derivatives too. The result must depend on nothing else. A value that is not finite
/// counts as FAILED, by which the callback can also exclude positions.
pub type obc_sphere_optimizer_block_function = Option<unsafe extern "C" fn(block: usize, place: *const f64, points: *const f64, value: *mut f64, gradient: *mut f64, hessian: *mut f64, user: *mut c_void) -> i32>;

/// Options of an all-at-once run. Fill with \_options\_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_sphere_optimizer_options {
    pub struct_size: u32,
    /// OBC\_SPHERE\_OPTIMIZER\_LIMITED\_MEMORY or another. Default: LIMITED\_MEMORY.
    pub method: i32,
    /// number of pairs of LIMITED\_MEMORY, 1 to 1000. Default: 16.
    pub memory: u32,
    /// number of values that BARZILAI\_BORWEIN considers, 1 (monotone) to 1000000. Default: 10.
    pub history: u32,
    /// tolerance of the longest tangent gradient of a block. Default: 1e-8.
    pub gradient_tolerance: f64,
    /// ends the run at f \<= target. Default: -infinity.
    pub target: f64,
    /// maximum number of evaluations. Default: 100000.
    pub max_evaluations: u64,
    /// maximum number of iterations. Default: 100000.
    pub max_iterations: u64,
    /// number of points to start from, at least 1: x0, then random points. A run that CONVERGED, STALLED or failed at one
    /// continues at the next; the lowest point of all is the result, and all limits are of the whole run. Default: 1.
    pub starts: u64,
    /// of the random points. Default: 0.
    pub seed: u64,
    /// for TRUNCATED\_NEWTON, 1: requests products of the Hessian (NEED\_PRODUCT), 0: evaluates gradients nearby
    /// and computes products from differences. Default: 0.
    pub hessian_products: i32,
}

/// State of a run. The caller sets struct\_size.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_sphere_optimizer_result {
    pub struct_size: u32,
    /// stop code, OBC\_SPHERE\_OPTIMIZER\_RUNNING or another
    pub stop: i32,
    /// f at the returned point; NaN before the first value
    pub value: f64,
    /// longest tangent gradient of a block at the current iterate; infinite before it is known
    pub gradient_norm: f64,
    /// number of evaluations, including failed ones
    pub evaluations: u64,
    /// number of evaluations without a value
    pub failed_evaluations: u64,
    /// number of iterations
    pub iterations: u64,
    /// number of starts that have begun
    pub starts: u64,
    /// number of the start that led to the returned point, from 0
    pub best_start: u64,
    /// number of products of the Hessian, supplied or from differences
    pub products: u64,
}

/// The spheres and their adjacency. Fill with \_blocks\_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_sphere_optimizer_blocks {
    pub struct_size: u32,
    /// dimension of a block, 2 to 64; 3 and 4 have specialized code. Default: 0, which must be set.
    pub dimension: u32,
    /// number of blocks, below 4294967295. Default: 0, which must be set.
    pub count: usize,
    /// count + 1 offsets into the array of neighbors. Default: NULL.
    pub neighbor_start: *const usize,
    /// for each block, the blocks whose terms of f contain it. Default: NULL.
    pub neighbor: *const u32,
}

/// Options of a relaxation. Fill with \_relaxation\_options\_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_sphere_optimizer_relaxation_options {
    pub struct_size: u32,
    /// GREAT\_CIRCLE, or DISSERTATION: Algorithm 2 as printed, in the order of eq. 3.6. Default: GREAT\_CIRCLE.
    pub method: i32,
    /// 1: Newton steps, for which f returns Hessians; 0: first-order steps. Default: 0.
    pub second_order: i32,
    /// AUTOMATIC, QUEUE or SWEEPS. Default: AUTOMATIC.
    pub order: i32,
    /// a block with a shorter tangent gradient does not move. Default: 1e-6.
    pub gradient_tolerance: f64,
    /// ends when a pass gains at most this fraction of the total gain. Default: 0.
    pub relative_gain: f64,
    /// step length relative to the minimizer along the step, from 1 to below 2; 0: chosen from the rate
    /// at which gains decrease. Default: 0.
    pub over_relaxation: f64,
    /// maximum number of passes, each of \`count\` steps. Default: 10000.
    pub max_passes: u64,
}

/// State of a relaxation. The caller sets struct\_size.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_sphere_optimizer_relaxation_result {
    pub struct_size: u32,
    /// CONVERGED, ITERATION\_BUDGET, STALLED, CANCELLED, EVALUATION\_FAILED (at the position of a block) or RUNNING
    pub stop: i32,
    /// total decrease of f
    pub gain: f64,
    /// longest tangent gradient of a block, known at the end
    pub gradient_norm: f64,
    /// number of steps
    pub steps: u64,
    /// number of evaluations of terms of f
    pub evaluations: u64,
    /// number of steps at which f was undefined along the whole search
    pub failed_steps: u64,
    /// value of the latest step
    pub over_relaxation: f64,
}

extern "C" {
    /// Fills options with the defaults.
    pub fn obc_sphere_optimizer_options_init(options: *mut obc_sphere_optimizer_options, struct_size: usize) -> i32;
    /// Creates a solver over count \>= 1 spheres in dimension \>= 2 that starts from x0 (count \* dimension numbers, each block scaled to
    /// length 1). options and host may be NULL; what the host points to must remain valid until \_destroy. Errors: invalid argument
    /// (also a zero block of x0), out of memory.
    pub fn obc_sphere_optimizer_create(count: usize, dimension: usize, options: *const obc_sphere_optimizer_options, x0: *const f64, host: *const obc_host, out: *mut *mut obc_sphere_optimizer, error: *mut obc_error) -> i32;
    /// Advances to the next request and returns it: NEED\_FG, ITERATION or DONE, or a negative obc\_status for NULL or after a defect. \*x
    /// (x may be NULL) is the point of the request, in memory of the solver, valid until its next call. While a request waits for
    /// \_tell, and after DONE, the same request is returned. Does not allocate.
    pub fn obc_sphere_optimizer_step(solver: *mut obc_sphere_optimizer, x: *mut *const f64) -> i32;
    /// Supplies value and gradient for NEED\_FG. An entry that is not finite means that f is undefined there; gradient may then be
    /// NULL. Errors: invalid argument if no request waits.
    pub fn obc_sphere_optimizer_tell(solver: *mut obc_sphere_optimizer, value: f64, gradient: *const f64, error: *mut obc_error) -> i32;
    /// Hands out the direction of a request NEED\_PRODUCT, count \* dimension numbers in memory of the solver, valid until its next call.
    /// Errors: invalid argument if no product is requested.
    pub fn obc_sphere_optimizer_get_direction(solver: *const obc_sphere_optimizer, direction: *mut *const f64, error: *mut obc_error) -> i32;
    /// Supplies the product of the Hessian and the direction, count \* dimension numbers, for NEED\_PRODUCT. NULL, or an entry that is not finite,
    /// means that there is none at this point. Errors: invalid argument if no product is requested.
    pub fn obc_sphere_optimizer_tell_product(solver: *mut obc_sphere_optimizer, product: *const f64, error: *mut obc_error) -> i32;
    /// Copies the current state at any time: result (or NULL), and x (or NULL). x is the iterate that satisfies the tolerance if the
    /// run CONVERGED, otherwise the lowest point evaluated, and before the first value the start. Errors: invalid argument.
    pub fn obc_sphere_optimizer_get_result(solver: *const obc_sphere_optimizer, result: *mut obc_sphere_optimizer_result, x: *mut f64, error: *mut obc_error) -> i32;
    /// Returns the number of spheres and their dimension, for runs that \_load created; count and dimension may be NULL.
    /// Errors: invalid argument.
    pub fn obc_sphere_optimizer_get_shape(solver: *const obc_sphere_optimizer, count: *mut usize, dimension: *mut usize, error: *mut obc_error) -> i32;
    /// Save and restore a run between two calls. save\_size returns the number of bytes, save writes them to blob, whose capacity is at
    /// least that. load creates a solver that continues with the same bits and the saved options. Both machines need the same
    /// byte order. Errors: invalid argument, malformed file (damaged, or of another version), out of memory.
    pub fn obc_sphere_optimizer_save_size(solver: *const obc_sphere_optimizer) -> usize;
    /// Save and restore a run between two calls. save\_size returns the number of bytes, save writes them to blob, whose capacity is at
    /// least that. load creates a solver that continues with the same bits and the saved options. Both machines need the same
    /// byte order. Errors: invalid argument, malformed file (damaged, or of another version), out of memory.
    pub fn obc_sphere_optimizer_save(solver: *const obc_sphere_optimizer, blob: *mut c_void, capacity: usize, error: *mut obc_error) -> i32;
    /// Save and restore a run between two calls. save\_size returns the number of bytes, save writes them to blob, whose capacity is at
    /// least that. load creates a solver that continues with the same bits and the saved options. Both machines need the same
    /// byte order. Errors: invalid argument, malformed file (damaged, or of another version), out of memory.
    pub fn obc_sphere_optimizer_load(blob: *const c_void, size: usize, host: *const obc_host, out: *mut *mut obc_sphere_optimizer, error: *mut obc_error) -> i32;
    /// Destroys a solver; NULL is allowed.
    pub fn obc_sphere_optimizer_destroy(solver: *mut obc_sphere_optimizer);
    /// Runs to the end with a callback. x is the start and receives the point of \_get\_result; result may be NULL. Returns OBC\_OK
    /// however the run ended (see result-\>stop), except OBC\_CANCELLED where the host cancelled it; x and result are filled in that case
    /// too. Errors: invalid argument, out of memory, cancelled.
    pub fn obc_sphere_optimizer_minimize(count: usize, dimension: usize, options: *const obc_sphere_optimizer_options, f: obc_sphere_optimizer_function, user: *mut c_void, x: *mut f64, result: *mut obc_sphere_optimizer_result, host: *const obc_host, error: *mut obc_error) -> i32;
    /// The same with TRUNCATED\_NEWTON and products of the Hessian from a callback, whatever options-\>method and hessian\_products are.
    pub fn obc_sphere_optimizer_minimize_second_order(count: usize, dimension: usize, options: *const obc_sphere_optimizer_options, f: obc_sphere_optimizer_function, product: obc_sphere_optimizer_product_function, user: *mut c_void, x: *mut f64, result: *mut obc_sphere_optimizer_result, host: *const obc_host, error: *mut obc_error) -> i32;
    /// Fill blocks with no blocks, and options with the defaults.
    pub fn obc_sphere_optimizer_blocks_init(blocks: *mut obc_sphere_optimizer_blocks, struct_size: usize) -> i32;
    /// Fill blocks with no blocks, and options with the defaults.
    pub fn obc_sphere_optimizer_relaxation_options_init(options: *mut obc_sphere_optimizer_relaxation_options, struct_size: usize) -> i32;
    /// Lowers f block by block. x (count \* dimension numbers) is the start, scaled to length 1, and receives the end. options, host and
    /// result may be NULL. Returns OBC\_OK however it ended (see result-\>stop), except OBC\_CANCELLED where the host cancelled it; x and
    /// result are filled in that case too. Errors: invalid argument (also a neighbor out of range), out of memory, cancelled.
    pub fn obc_sphere_optimizer_relax(blocks: *const obc_sphere_optimizer_blocks, options: *const obc_sphere_optimizer_relaxation_options, f: obc_sphere_optimizer_block_function, user: *mut c_void, x: *mut f64, result: *mut obc_sphere_optimizer_relaxation_result, host: *const obc_host, error: *mut obc_error) -> i32;
    /// Creates a relaxation that runs in parts. Copies blocks and x0 (scaled to length 1); what the host points to must remain valid until
    /// \_destroy. Errors: invalid argument, out of memory.
    pub fn obc_sphere_optimizer_relaxation_create(blocks: *const obc_sphere_optimizer_blocks, options: *const obc_sphere_optimizer_relaxation_options, x0: *const f64, host: *const obc_host, out: *mut *mut obc_sphere_optimizer_relaxation, error: *mut obc_error) -> i32;
    /// Relaxes up to \`steps\` more blocks without an allocation, and measures the gradients at the end of the relaxation. Returns OBC\_OK
    /// however it ended; stop is RUNNING where steps remain, CANCELLED where f returned STOP. After an interruption, also by the
    /// host (OBC\_CANCELLED), the current step is undone, and the next \_run continues with the same bits as without the
    /// interruption. Errors: invalid argument, cancelled.
    pub fn obc_sphere_optimizer_relaxation_run(relaxation: *mut obc_sphere_optimizer_relaxation, f: obc_sphere_optimizer_block_function, user: *mut c_void, steps: u64, error: *mut obc_error) -> i32;
    /// Copies the current state: result (or NULL) and x (count \* dimension numbers, or NULL). Errors: invalid argument.
    pub fn obc_sphere_optimizer_relaxation_get_result(relaxation: *const obc_sphere_optimizer_relaxation, result: *mut obc_sphere_optimizer_relaxation_result, x: *mut f64, error: *mut obc_error) -> i32;
    /// Save and restore a relaxation between two calls, like an all-at-once run. load takes the blocks of the saved relaxation (invalid
    /// argument for others) and keeps its options.
    pub fn obc_sphere_optimizer_relaxation_save_size(relaxation: *const obc_sphere_optimizer_relaxation) -> usize;
    /// Save and restore a relaxation between two calls, like an all-at-once run. load takes the blocks of the saved relaxation (invalid
    /// argument for others) and keeps its options.
    pub fn obc_sphere_optimizer_relaxation_save(relaxation: *const obc_sphere_optimizer_relaxation, blob: *mut c_void, capacity: usize, error: *mut obc_error) -> i32;
    /// Save and restore a relaxation between two calls, like an all-at-once run. load takes the blocks of the saved relaxation (invalid
    /// argument for others) and keeps its options.
    pub fn obc_sphere_optimizer_relaxation_load(blocks: *const obc_sphere_optimizer_blocks, blob: *const c_void, size: usize, host: *const obc_host, out: *mut *mut obc_sphere_optimizer_relaxation, error: *mut obc_error) -> i32;
    /// Destroys a relaxation; NULL is allowed.
    pub fn obc_sphere_optimizer_relaxation_destroy(relaxation: *mut obc_sphere_optimizer_relaxation);
    /// Returns the English name of a stop code, such as "evaluation budget"; a static string, never NULL.
    pub fn obc_sphere_optimizer_stop_name(stop: i32) -> *const c_char;
    /// Returns the version of the library, major \* 10000 + minor \* 100 + patch.
    pub fn obc_sphere_optimizer_version() -> u32;
}

#[cfg(all(test, target_pointer_width = "64"))]
mod layout {
    use super::*;
    use std::mem::{align_of, size_of, MaybeUninit};
    use std::ptr::addr_of;

    #[test]
    fn structs_lie_in_memory_as_in_c() {
        assert_eq!((size_of::<obc_sphere_optimizer_options>(), align_of::<obc_sphere_optimizer_options>()), (72, 8));
        let it = MaybeUninit::<obc_sphere_optimizer_options>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_sphere_optimizer_options.struct_size");
        assert_eq!(unsafe { addr_of!((*start).method) } as usize - start as usize, 4, "obc_sphere_optimizer_options.method");
        assert_eq!(unsafe { addr_of!((*start).memory) } as usize - start as usize, 8, "obc_sphere_optimizer_options.memory");
        assert_eq!(unsafe { addr_of!((*start).history) } as usize - start as usize, 12, "obc_sphere_optimizer_options.history");
        assert_eq!(unsafe { addr_of!((*start).gradient_tolerance) } as usize - start as usize, 16, "obc_sphere_optimizer_options.gradient_tolerance");
        assert_eq!(unsafe { addr_of!((*start).target) } as usize - start as usize, 24, "obc_sphere_optimizer_options.target");
        assert_eq!(unsafe { addr_of!((*start).max_evaluations) } as usize - start as usize, 32, "obc_sphere_optimizer_options.max_evaluations");
        assert_eq!(unsafe { addr_of!((*start).max_iterations) } as usize - start as usize, 40, "obc_sphere_optimizer_options.max_iterations");
        assert_eq!(unsafe { addr_of!((*start).starts) } as usize - start as usize, 48, "obc_sphere_optimizer_options.starts");
        assert_eq!(unsafe { addr_of!((*start).seed) } as usize - start as usize, 56, "obc_sphere_optimizer_options.seed");
        assert_eq!(unsafe { addr_of!((*start).hessian_products) } as usize - start as usize, 64, "obc_sphere_optimizer_options.hessian_products");
        assert_eq!((size_of::<obc_sphere_optimizer_result>(), align_of::<obc_sphere_optimizer_result>()), (72, 8));
        let it = MaybeUninit::<obc_sphere_optimizer_result>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_sphere_optimizer_result.struct_size");
        assert_eq!(unsafe { addr_of!((*start).stop) } as usize - start as usize, 4, "obc_sphere_optimizer_result.stop");
        assert_eq!(unsafe { addr_of!((*start).value) } as usize - start as usize, 8, "obc_sphere_optimizer_result.value");
        assert_eq!(unsafe { addr_of!((*start).gradient_norm) } as usize - start as usize, 16, "obc_sphere_optimizer_result.gradient_norm");
        assert_eq!(unsafe { addr_of!((*start).evaluations) } as usize - start as usize, 24, "obc_sphere_optimizer_result.evaluations");
        assert_eq!(unsafe { addr_of!((*start).failed_evaluations) } as usize - start as usize, 32, "obc_sphere_optimizer_result.failed_evaluations");
        assert_eq!(unsafe { addr_of!((*start).iterations) } as usize - start as usize, 40, "obc_sphere_optimizer_result.iterations");
        assert_eq!(unsafe { addr_of!((*start).starts) } as usize - start as usize, 48, "obc_sphere_optimizer_result.starts");
        assert_eq!(unsafe { addr_of!((*start).best_start) } as usize - start as usize, 56, "obc_sphere_optimizer_result.best_start");
        assert_eq!(unsafe { addr_of!((*start).products) } as usize - start as usize, 64, "obc_sphere_optimizer_result.products");
        assert_eq!((size_of::<obc_sphere_optimizer_blocks>(), align_of::<obc_sphere_optimizer_blocks>()), (32, 8));
        let it = MaybeUninit::<obc_sphere_optimizer_blocks>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_sphere_optimizer_blocks.struct_size");
        assert_eq!(unsafe { addr_of!((*start).dimension) } as usize - start as usize, 4, "obc_sphere_optimizer_blocks.dimension");
        assert_eq!(unsafe { addr_of!((*start).count) } as usize - start as usize, 8, "obc_sphere_optimizer_blocks.count");
        assert_eq!(unsafe { addr_of!((*start).neighbor_start) } as usize - start as usize, 16, "obc_sphere_optimizer_blocks.neighbor_start");
        assert_eq!(unsafe { addr_of!((*start).neighbor) } as usize - start as usize, 24, "obc_sphere_optimizer_blocks.neighbor");
        assert_eq!((size_of::<obc_sphere_optimizer_relaxation_options>(), align_of::<obc_sphere_optimizer_relaxation_options>()), (48, 8));
        let it = MaybeUninit::<obc_sphere_optimizer_relaxation_options>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_sphere_optimizer_relaxation_options.struct_size");
        assert_eq!(unsafe { addr_of!((*start).method) } as usize - start as usize, 4, "obc_sphere_optimizer_relaxation_options.method");
        assert_eq!(unsafe { addr_of!((*start).second_order) } as usize - start as usize, 8, "obc_sphere_optimizer_relaxation_options.second_order");
        assert_eq!(unsafe { addr_of!((*start).order) } as usize - start as usize, 12, "obc_sphere_optimizer_relaxation_options.order");
        assert_eq!(unsafe { addr_of!((*start).gradient_tolerance) } as usize - start as usize, 16, "obc_sphere_optimizer_relaxation_options.gradient_tolerance");
        assert_eq!(unsafe { addr_of!((*start).relative_gain) } as usize - start as usize, 24, "obc_sphere_optimizer_relaxation_options.relative_gain");
        assert_eq!(unsafe { addr_of!((*start).over_relaxation) } as usize - start as usize, 32, "obc_sphere_optimizer_relaxation_options.over_relaxation");
        assert_eq!(unsafe { addr_of!((*start).max_passes) } as usize - start as usize, 40, "obc_sphere_optimizer_relaxation_options.max_passes");
        assert_eq!((size_of::<obc_sphere_optimizer_relaxation_result>(), align_of::<obc_sphere_optimizer_relaxation_result>()), (56, 8));
        let it = MaybeUninit::<obc_sphere_optimizer_relaxation_result>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_sphere_optimizer_relaxation_result.struct_size");
        assert_eq!(unsafe { addr_of!((*start).stop) } as usize - start as usize, 4, "obc_sphere_optimizer_relaxation_result.stop");
        assert_eq!(unsafe { addr_of!((*start).gain) } as usize - start as usize, 8, "obc_sphere_optimizer_relaxation_result.gain");
        assert_eq!(unsafe { addr_of!((*start).gradient_norm) } as usize - start as usize, 16, "obc_sphere_optimizer_relaxation_result.gradient_norm");
        assert_eq!(unsafe { addr_of!((*start).steps) } as usize - start as usize, 24, "obc_sphere_optimizer_relaxation_result.steps");
        assert_eq!(unsafe { addr_of!((*start).evaluations) } as usize - start as usize, 32, "obc_sphere_optimizer_relaxation_result.evaluations");
        assert_eq!(unsafe { addr_of!((*start).failed_steps) } as usize - start as usize, 40, "obc_sphere_optimizer_relaxation_result.failed_steps");
        assert_eq!(unsafe { addr_of!((*start).over_relaxation) } as usize - start as usize, 48, "obc_sphere_optimizer_relaxation_result.over_relaxation");
    }
}
