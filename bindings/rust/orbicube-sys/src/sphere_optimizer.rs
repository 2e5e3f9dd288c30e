//! What `<orbicube/sphere_optimizer.h>` declares. Written by scripts/bindings.py; not to be edited.
#![allow(non_camel_case_types, non_upper_case_globals)]

use crate::base::{obc_error, obc_host};
use std::os::raw::{c_char, c_void};

pub const OBC_SPHERE_OPTIMIZER_LIMITED_MEMORY: i32 = 0;
pub const OBC_SPHERE_OPTIMIZER_BARZILAI_BORWEIN: i32 = 1;
pub const OBC_SPHERE_OPTIMIZER_GREAT_CIRCLE: i32 = 2;
pub const OBC_SPHERE_OPTIMIZER_SEED: i32 = 3;

/// value and gradient of f at x; answer with \_tell
pub const OBC_SPHERE_OPTIMIZER_NEED_FG: i32 = 1;
/// x is a new iterate; nothing to answer
pub const OBC_SPHERE_OPTIMIZER_ITERATION: i32 = 2;
/// see \_get\_result
pub const OBC_SPHERE_OPTIMIZER_DONE: i32 = 3;

pub const OBC_SPHERE_OPTIMIZER_RUNNING: i32 = 0;
/// every block's tangent gradient is at most gradient\_tolerance long
pub const OBC_SPHERE_OPTIMIZER_CONVERGED: i32 = 1;
/// f \<= target
pub const OBC_SPHERE_OPTIMIZER_TARGET_REACHED: i32 = 2;
pub const OBC_SPHERE_OPTIMIZER_EVALUATION_BUDGET: i32 = 3;
pub const OBC_SPHERE_OPTIMIZER_ITERATION_BUDGET: i32 = 4;
/// no step that the arithmetic resolves improves f, or gains as asked
pub const OBC_SPHERE_OPTIMIZER_STALLED: i32 = 5;
/// by the host's progress callback, or by the callback f
pub const OBC_SPHERE_OPTIMIZER_CANCELLED: i32 = 6;
/// f not finite at the start, or all along two directions
pub const OBC_SPHERE_OPTIMIZER_EVALUATION_FAILED: i32 = 7;

pub const OBC_SPHERE_OPTIMIZER_CONTINUE: i32 = 0;
/// end the run as cancelled; the best point so far is handed out
pub const OBC_SPHERE_OPTIMIZER_STOP: i32 = 1;
/// f has no value at x; the method goes on elsewhere
pub const OBC_SPHERE_OPTIMIZER_FAILED: i32 = 2;

/// QUEUE, then SWEEPS when gains fall slowly
pub const OBC_SPHERE_OPTIMIZER_AUTOMATIC: i32 = 0;
/// the block first whose or whose neighbours' last step gained most
pub const OBC_SPHERE_OPTIMIZER_QUEUE: i32 = 1;
/// 0, 1, 2, ... again and again
pub const OBC_SPHERE_OPTIMIZER_SWEEPS: i32 = 2;

/// A run of the all-at-once solver.
#[repr(C)]
pub struct obc_sphere_optimizer {
    _private: [u8; 0],
    _marker: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

/// A relaxation that is done in parts.
#[repr(C)]
pub struct obc_sphere_optimizer_relaxation {
    _private: [u8; 0],
    _marker: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

/// Value of f at x (count blocks of dimension numbers, one after the other) and its gradient there, in the same order: that in
/// R^d of each block, or any vector with the same part tangent to the spheres: SEED looks at the whole, LIMITED\_MEMORY takes
/// the rest as a hint of how stiff each block is, which saves evaluations. A value or entry that is not finite counts as
/// FAILED.
pub type obc_sphere_optimizer_function = Option<unsafe extern "C" fn(x: *const f64, count: usize, dimension: usize, value: *mut f64, gradient: *mut f64, user: *mut c_void) -> i32>;

/// The part of f that contains \`block\`, if that block was at \`place\` (dimension numbers) and all others where \`points\` (all
/// blocks) says. With gradient (dimension numbers, or NULL), place is where the block is; with hessian (dimension squared, or
/// NULL) second derivatives as well, by rows. Must depend on nothing else. A value that is not finite counts as FAILED; so the
/// callback also keeps a block from places where it must not be.
pub type obc_sphere_optimizer_block_function = Option<unsafe extern "C" fn(block: usize, place: *const f64, points: *const f64, value: *mut f64, gradient: *mut f64, hessian: *mut f64, user: *mut c_void) -> i32>;

/// Fill with \_options\_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_sphere_optimizer_options {
    pub struct_size: u32,
    /// LIMITED\_MEMORY
    pub method: i32,
    /// pairs of LIMITED\_MEMORY, 1 to 1000: 16
    pub memory: u32,
    /// values that BARZILAI\_BORWEIN looks back on, 1 (monotone) to 1000000: 10
    pub history: u32,
    /// on the longest tangent gradient of a block: 1e-8
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
pub struct obc_sphere_optimizer_result {
    pub struct_size: u32,
    /// OBC\_SPHERE\_OPTIMIZER\_RUNNING, ...
    pub stop: i32,
    /// f at the point handed out; NaN before the first value
    pub value: f64,
    /// longest tangent gradient of a block at the current iterate; infinite before it is known
    pub gradient_norm: f64,
    pub evaluations: u64,
    pub failed_evaluations: u64,
    pub iterations: u64,
}

/// The spheres and who is whose neighbour; fill with \_blocks\_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_sphere_optimizer_blocks {
    pub struct_size: u32,
    /// 2 to 64; 3 and 4 are compiled for themselves
    pub dimension: u32,
    /// less than 4294967295
    pub count: usize,
    /// count + 1 offsets into neighbour
    pub neighbour_start: *const usize,
    /// the blocks whose part of f contains this one, for each block
    pub neighbour: *const u32,
}

/// Fill with \_relaxation\_options\_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_sphere_optimizer_relaxation_options {
    pub struct_size: u32,
    /// GREAT\_CIRCLE, or SEED: Algorithm 2 as printed, in the order of eq. 3.6
    pub method: i32,
    /// 1: Newton's steps, f gives Hessians: 0
    pub second_order: i32,
    /// AUTOMATIC
    pub order: i32,
    /// a block with a shorter tangent gradient stays: 1e-6
    pub gradient_tolerance: f64,
    /// end when a pass gains at most this part of all that was gained: 0
    pub relative_gain: f64,
    /// how many times as far each step goes as its own energy asks, from 1 to below 2; 0: chosen from
    /// the rate at which gains fall: 0
    pub over_relaxation: f64,
    /// of as many steps as there are blocks: 10000
    pub max_passes: u64,
}

/// What a relaxation did; set struct\_size before asking for it.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_sphere_optimizer_relaxation_result {
    pub struct_size: u32,
    /// CONVERGED, ITERATION\_BUDGET, STALLED, CANCELLED, EVALUATION\_FAILED (where a block is); RUNNING
    pub stop: i32,
    /// by how much f fell
    pub gain: f64,
    /// longest tangent gradient of a block, known at the end
    pub gradient_norm: f64,
    pub steps: u64,
    /// of parts of f
    pub evaluations: u64,
    pub failed_steps: u64,
    /// of the latest step
    pub over_relaxation: f64,
}

extern "C" {
    /// The defaults, which the members' comments give.
    pub fn obc_sphere_optimizer_options_init(options: *mut obc_sphere_optimizer_options, struct_size: usize) -> i32;
    /// Makes a solver over count \>= 1 spheres in dimension \>= 2 that starts from x0 (count \* dimension numbers, each block scaled
    /// to length 1). options and host may be NULL; what the host points at must stay valid until \_destroy. Errors: invalid
    /// argument (also a block of x0 that is zero), out of memory.
    pub fn obc_sphere_optimizer_create(count: usize, dimension: usize, options: *const obc_sphere_optimizer_options, x0: *const f64, host: *const obc_host, out: *mut *mut obc_sphere_optimizer, error: *mut obc_error) -> i32;
    /// Goes on to the next request: NEED\_FG, ITERATION or DONE, or a negative obc\_status when the solver is NULL or on a defect.
    /// \*x (x may be NULL) is the point that is asked about, the solver's, valid until its next call. While a request waits for
    /// \_tell, and after DONE, the answer stays the same. Does not allocate.
    pub fn obc_sphere_optimizer_step(solver: *mut obc_sphere_optimizer, x: *mut *const f64) -> i32;
    /// Answers NEED\_FG. A value or gradient entry that is not finite says that f cannot be evaluated there; gradient may be NULL
    /// then. Errors: invalid argument when nothing was asked.
    pub fn obc_sphere_optimizer_tell(solver: *mut obc_sphere_optimizer, value: f64, gradient: *const f64, error: *mut obc_error) -> i32;
    /// What is known now, at any time: result (or NULL), and x (or NULL), which is the iterate that met the tolerance if the run
    /// CONVERGED, else the lowest point evaluated, and before that the start.
    pub fn obc_sphere_optimizer_get_result(solver: *const obc_sphere_optimizer, result: *mut obc_sphere_optimizer_result, x: *mut f64, error: *mut obc_error) -> i32;
    /// How many spheres, and of how many numbers each; each of count and dimension may be NULL. For runs that come from \_load.
    pub fn obc_sphere_optimizer_get_shape(solver: *const obc_sphere_optimizer, count: *mut usize, dimension: *mut usize, error: *mut obc_error) -> i32;
    /// A run as bytes, at any time between two calls: save\_size gives their number, save writes them to blob (capacity at least
    /// that). load makes a solver from them that goes on with the same bits, with the options of the saved run. For machines of
    /// the same byte order. Errors: invalid argument, malformed file (damaged, or of another version).
    pub fn obc_sphere_optimizer_save_size(solver: *const obc_sphere_optimizer) -> usize;
    /// A run as bytes, at any time between two calls: save\_size gives their number, save writes them to blob (capacity at least
    /// that). load makes a solver from them that goes on with the same bits, with the options of the saved run. For machines of
    /// the same byte order. Errors: invalid argument, malformed file (damaged, or of another version).
    pub fn obc_sphere_optimizer_save(solver: *const obc_sphere_optimizer, blob: *mut c_void, capacity: usize, error: *mut obc_error) -> i32;
    /// A run as bytes, at any time between two calls: save\_size gives their number, save writes them to blob (capacity at least
    /// that). load makes a solver from them that goes on with the same bits, with the options of the saved run. For machines of
    /// the same byte order. Errors: invalid argument, malformed file (damaged, or of another version).
    pub fn obc_sphere_optimizer_load(blob: *const c_void, size: usize, host: *const obc_host, out: *mut *mut obc_sphere_optimizer, error: *mut obc_error) -> i32;
    /// Releases a solver; NULL is fine.
    pub fn obc_sphere_optimizer_destroy(solver: *mut obc_sphere_optimizer);
    /// The loop over step with a callback: x holds the start and gets what \_get\_result hands out; result may be NULL. Answers
    /// OBC\_OK however the run ended (result-\>stop), but OBC\_CANCELLED when the host cancelled it; x and result are filled then
    /// as well.
    pub fn obc_sphere_optimizer_minimize(count: usize, dimension: usize, options: *const obc_sphere_optimizer_options, f: obc_sphere_optimizer_function, user: *mut c_void, x: *mut f64, result: *mut obc_sphere_optimizer_result, host: *const obc_host, error: *mut obc_error) -> i32;
    /// Empty: no blocks. And the defaults, which the members' comments give.
    pub fn obc_sphere_optimizer_blocks_init(blocks: *mut obc_sphere_optimizer_blocks, struct_size: usize) -> i32;
    /// Empty: no blocks. And the defaults, which the members' comments give.
    pub fn obc_sphere_optimizer_relaxation_options_init(options: *mut obc_sphere_optimizer_relaxation_options, struct_size: usize) -> i32;
    /// Lowers f block by block: x (count \* dimension numbers) holds the start, scaled to length 1, and gets the end. options, host
    /// and result may be NULL. Answers OBC\_OK however it ended (result-\>stop), but OBC\_CANCELLED when the host cancelled it; x and
    /// result are filled then as well. Errors: invalid argument (also a neighbour out of range), out of memory.
    pub fn obc_sphere_optimizer_relax(blocks: *const obc_sphere_optimizer_blocks, options: *const obc_sphere_optimizer_relaxation_options, f: obc_sphere_optimizer_block_function, user: *mut c_void, x: *mut f64, result: *mut obc_sphere_optimizer_relaxation_result, host: *const obc_host, error: *mut obc_error) -> i32;
    /// The same in parts: \_create copies blocks and x0 (scaled to length 1); what the host points at must stay valid until
    /// \_destroy.
    pub fn obc_sphere_optimizer_relaxation_create(blocks: *const obc_sphere_optimizer_blocks, options: *const obc_sphere_optimizer_relaxation_options, x0: *const f64, host: *const obc_host, out: *mut *mut obc_sphere_optimizer_relaxation, error: *mut obc_error) -> i32;
    /// At most \`steps\` more steps of one block each, without an allocation; at the end of the relaxation its gradients are
    /// measured. Answers OBC\_OK however it ended; stop is RUNNING when steps are left to do, CANCELLED when f answered STOP.
    /// OBC\_CANCELLED: the host cancelled. However it was broken off, the step under way is as if it had not begun, and the next
    /// \_run goes on with the same bits as without the break.
    pub fn obc_sphere_optimizer_relaxation_run(relaxation: *mut obc_sphere_optimizer_relaxation, f: obc_sphere_optimizer_block_function, user: *mut c_void, steps: u64, error: *mut obc_error) -> i32;
    /// What is known now: result (or NULL) and x (count \* dimension numbers, or NULL).
    pub fn obc_sphere_optimizer_relaxation_get_result(relaxation: *const obc_sphere_optimizer_relaxation, result: *mut obc_sphere_optimizer_relaxation_result, x: *mut f64, error: *mut obc_error) -> i32;
    /// The relaxation as bytes between two calls, like a run of the all-at-once solver. load takes the blocks of the saved one
    /// again (invalid argument if they are others), with the options of the saved one.
    pub fn obc_sphere_optimizer_relaxation_save_size(relaxation: *const obc_sphere_optimizer_relaxation) -> usize;
    /// The relaxation as bytes between two calls, like a run of the all-at-once solver. load takes the blocks of the saved one
    /// again (invalid argument if they are others), with the options of the saved one.
    pub fn obc_sphere_optimizer_relaxation_save(relaxation: *const obc_sphere_optimizer_relaxation, blob: *mut c_void, capacity: usize, error: *mut obc_error) -> i32;
    /// The relaxation as bytes between two calls, like a run of the all-at-once solver. load takes the blocks of the saved one
    /// again (invalid argument if they are others), with the options of the saved one.
    pub fn obc_sphere_optimizer_relaxation_load(blocks: *const obc_sphere_optimizer_blocks, blob: *const c_void, size: usize, host: *const obc_host, out: *mut *mut obc_sphere_optimizer_relaxation, error: *mut obc_error) -> i32;
    /// Releases a relaxation; NULL is fine.
    pub fn obc_sphere_optimizer_relaxation_destroy(relaxation: *mut obc_sphere_optimizer_relaxation);
    /// English name of a stop, such as "evaluation budget". Never NULL; a static string.
    pub fn obc_sphere_optimizer_stop_name(stop: i32) -> *const c_char;
    /// Version of this library, major \* 10000 + minor \* 100 + patch.
    pub fn obc_sphere_optimizer_version() -> u32;
}

#[cfg(all(test, target_pointer_width = "64"))]
mod layout {
    use super::*;
    use std::mem::{align_of, size_of, MaybeUninit};
    use std::ptr::addr_of;

    #[test]
    fn structs_lie_in_memory_as_in_c() {
        assert_eq!((size_of::<obc_sphere_optimizer_options>(), align_of::<obc_sphere_optimizer_options>()), (48, 8));
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
        assert_eq!((size_of::<obc_sphere_optimizer_result>(), align_of::<obc_sphere_optimizer_result>()), (48, 8));
        let it = MaybeUninit::<obc_sphere_optimizer_result>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_sphere_optimizer_result.struct_size");
        assert_eq!(unsafe { addr_of!((*start).stop) } as usize - start as usize, 4, "obc_sphere_optimizer_result.stop");
        assert_eq!(unsafe { addr_of!((*start).value) } as usize - start as usize, 8, "obc_sphere_optimizer_result.value");
        assert_eq!(unsafe { addr_of!((*start).gradient_norm) } as usize - start as usize, 16, "obc_sphere_optimizer_result.gradient_norm");
        assert_eq!(unsafe { addr_of!((*start).evaluations) } as usize - start as usize, 24, "obc_sphere_optimizer_result.evaluations");
        assert_eq!(unsafe { addr_of!((*start).failed_evaluations) } as usize - start as usize, 32, "obc_sphere_optimizer_result.failed_evaluations");
        assert_eq!(unsafe { addr_of!((*start).iterations) } as usize - start as usize, 40, "obc_sphere_optimizer_result.iterations");
        assert_eq!((size_of::<obc_sphere_optimizer_blocks>(), align_of::<obc_sphere_optimizer_blocks>()), (32, 8));
        let it = MaybeUninit::<obc_sphere_optimizer_blocks>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_sphere_optimizer_blocks.struct_size");
        assert_eq!(unsafe { addr_of!((*start).dimension) } as usize - start as usize, 4, "obc_sphere_optimizer_blocks.dimension");
        assert_eq!(unsafe { addr_of!((*start).count) } as usize - start as usize, 8, "obc_sphere_optimizer_blocks.count");
        assert_eq!(unsafe { addr_of!((*start).neighbour_start) } as usize - start as usize, 16, "obc_sphere_optimizer_blocks.neighbour_start");
        assert_eq!(unsafe { addr_of!((*start).neighbour) } as usize - start as usize, 24, "obc_sphere_optimizer_blocks.neighbour");
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
