//! What `<orbicube/base.h>` declares. Written by scripts/bindings.py; not to be edited.
#![allow(non_camel_case_types, non_upper_case_globals)]

use std::os::raw::{c_char, c_void};

/// success
pub const OBC_OK: i32 = 0;
/// an argument is NULL, not finite or out of range, or an option is unknown
pub const OBC_INVALID_ARGUMENT: i32 = -1;
/// the contents violate the file format
pub const OBC_MALFORMED_FILE: i32 = -2;
/// the surface has a boundary
pub const OBC_NOT_CLOSED: i32 = -3;
/// edges, vertices or orientation are not those of a manifold
pub const OBC_NOT_MANIFOLD: i32 = -4;
/// the method requires another genus
pub const OBC_WRONG_GENUS: i32 = -5;
/// the input has zero area or volume, or a degenerate cell
pub const OBC_DEGENERATE: i32 = -6;
/// an allocation failed; everything is released
pub const OBC_OUT_OF_MEMORY: i32 = -7;
/// the host's progress callback requested the end
pub const OBC_CANCELLED: i32 = -8;
/// a file cannot be opened, read or written
pub const OBC_IO: i32 = -9;
/// valid input that this library does not handle
pub const OBC_UNSUPPORTED: i32 = -10;
/// the method ended without a result that can be certified
pub const OBC_NO_VALID_RESULT: i32 = -11;
/// a defect of the library
pub const OBC_INTERNAL: i32 = -12;

/// Outcome of a call: OBC\_OK or one of the negative values below.
pub type obc_status = i32;

/// Receives the progress of a computation: the name of the phase, the completed and the total amount of its work (total 0: unknown) and
/// the lowest objective value so far (NaN: none). obc\_host.fraction has the fraction of the whole call. Returns 0 to continue, any
/// other value to end the call with OBC\_CANCELLED. Runs on the thread that called the library, at intervals of at most 50 ms.
pub type obc_progress_function = Option<unsafe extern "C" fn(phase: *const c_char, done: u64, total: u64, best: f64, user: *mut c_void) -> i32>;

/// Receives one line for a log, without a line end.
pub type obc_log_function = Option<unsafe extern "C" fn(line: *const c_char, user: *mut c_void)>;

/// Job system of the program. Calls task(i, context) once for each i in \[0, count), on any threads and in any order, and returns after
/// the last one. Results do not depend on the order or the number of threads.
pub type obc_parallel_for_function = Option<unsafe extern "C" fn(count: usize, task: Option<unsafe extern "C" fn(index: usize, context: *mut c_void)>, context: *mut c_void, user: *mut c_void)>;

/// Description of a failure, in memory of the caller. A failing function fills it; a successful one clears it.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_error {
    /// the returned status
    pub status: i32,
    /// one word for programs, such as "not-closed" or "index-range"; empty after success
    pub kind: [c_char; 28],
    /// sentence for people: what is wrong and where; UTF-8, truncated if longer, always terminated
    pub message: [c_char; 480],
}

/// Memory of the program for the allocations of the libraries. Both functions must be thread-safe.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_allocator {
    /// Returns \`size\` bytes at a multiple of \`alignment\`, a power of two, or NULL, which ends the call in OBC\_OUT\_OF\_MEMORY.
    pub allocate: Option<unsafe extern "C" fn(size: usize, alignment: usize, user: *mut c_void) -> *mut c_void>,
    /// Releases an allocation; size and alignment are those of the allocation.
    pub release: Option<unsafe extern "C" fn(pointer: *mut c_void, size: usize, alignment: usize, user: *mut c_void)>,
    /// passed to both functions
    pub user: *mut c_void,
}

/// Resources of the program that a computation uses. Fill with obc\_host\_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_host {
    pub struct_size: u32,
    /// Number of threads, up to 1024; 0: one a core. Unused with parallel\_for. Default: 0.
    pub thread_count: u32,
    /// receives progress and can cancel; NULL: none. Default: NULL.
    pub progress: obc_progress_function,
    /// passed to progress. Default: NULL.
    pub progress_user: *mut c_void,
    /// receives lines for a log; NULL: none. Default: NULL.
    pub log: obc_log_function,
    /// passed to log. Default: NULL.
    pub log_user: *mut c_void,
    /// job system; NULL: threads of the library. Default: NULL.
    pub parallel_for: obc_parallel_for_function,
    /// passed to parallel\_for. Default: NULL.
    pub parallel_for_user: *mut c_void,
    /// Memory; NULL: the default of the library. A handle uses it until it is destroyed. Default: NULL.
    pub allocator: *const obc_allocator,
    /// Completed fraction of the whole call, 0 to 1, never decreasing, stored before each call of progress; NULL: not stored. It is an
    /// estimate where the amount of work is unknown in advance. A host with it serves one call at a time. Default: NULL.
    pub fraction: *mut f64,
}

extern "C" {
    /// Fills a host with the defaults. Errors: invalid argument (NULL, or a size that no version has).
    pub fn obc_host_init(host: *mut obc_host, struct_size: usize) -> i32;
    /// Returns a short English name of a status, such as "out of memory"; a static string, never NULL.
    pub fn obc_status_name(status: i32) -> *const c_char;
    /// Returns the version of the library, major \* 10000 + minor \* 100 + patch.
    pub fn obc_base_version() -> u32;
}

#[cfg(all(test, target_pointer_width = "64"))]
mod layout {
    use super::*;
    use std::mem::{align_of, size_of, MaybeUninit};
    use std::ptr::addr_of;

    #[test]
    fn structs_lie_in_memory_as_in_c() {
        assert_eq!((size_of::<obc_error>(), align_of::<obc_error>()), (512, 4));
        let it = MaybeUninit::<obc_error>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).status) } as usize - start as usize, 0, "obc_error.status");
        assert_eq!(unsafe { addr_of!((*start).kind) } as usize - start as usize, 4, "obc_error.kind");
        assert_eq!(unsafe { addr_of!((*start).message) } as usize - start as usize, 32, "obc_error.message");
        assert_eq!((size_of::<obc_allocator>(), align_of::<obc_allocator>()), (24, 8));
        let it = MaybeUninit::<obc_allocator>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).allocate) } as usize - start as usize, 0, "obc_allocator.allocate");
        assert_eq!(unsafe { addr_of!((*start).release) } as usize - start as usize, 8, "obc_allocator.release");
        assert_eq!(unsafe { addr_of!((*start).user) } as usize - start as usize, 16, "obc_allocator.user");
        assert_eq!((size_of::<obc_host>(), align_of::<obc_host>()), (72, 8));
        let it = MaybeUninit::<obc_host>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_host.struct_size");
        assert_eq!(unsafe { addr_of!((*start).thread_count) } as usize - start as usize, 4, "obc_host.thread_count");
        assert_eq!(unsafe { addr_of!((*start).progress) } as usize - start as usize, 8, "obc_host.progress");
        assert_eq!(unsafe { addr_of!((*start).progress_user) } as usize - start as usize, 16, "obc_host.progress_user");
        assert_eq!(unsafe { addr_of!((*start).log) } as usize - start as usize, 24, "obc_host.log");
        assert_eq!(unsafe { addr_of!((*start).log_user) } as usize - start as usize, 32, "obc_host.log_user");
        assert_eq!(unsafe { addr_of!((*start).parallel_for) } as usize - start as usize, 40, "obc_host.parallel_for");
        assert_eq!(unsafe { addr_of!((*start).parallel_for_user) } as usize - start as usize, 48, "obc_host.parallel_for_user");
        assert_eq!(unsafe { addr_of!((*start).allocator) } as usize - start as usize, 56, "obc_host.allocator");
        assert_eq!(unsafe { addr_of!((*start).fraction) } as usize - start as usize, 64, "obc_host.fraction");
    }
}
