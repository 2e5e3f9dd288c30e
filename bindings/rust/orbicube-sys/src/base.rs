//! What `<orbicube/base.h>` declares. Written by scripts/bindings.py; not to be edited.
#![allow(non_camel_case_types, non_upper_case_globals)]

use std::os::raw::{c_char, c_void};

pub const OBC_OK: i32 = 0;
/// NULL, NaN or a wrong size where that is not allowed, or an unknown option
pub const OBC_INVALID_ARGUMENT: i32 = -1;
/// the file is not what its format asks for
pub const OBC_MALFORMED_FILE: i32 = -2;
/// the surface has a boundary
pub const OBC_NOT_CLOSED: i32 = -3;
/// edges, vertices or orientation are not those of one manifold
pub const OBC_NOT_MANIFOLD: i32 = -4;
/// the method needs another genus
pub const OBC_WRONG_GENUS: i32 = -5;
/// no area, no volume, or a cell without either
pub const OBC_DEGENERATE: i32 = -6;
pub const OBC_OUT_OF_MEMORY: i32 = -7;
/// the host's progress callback asked to stop
pub const OBC_CANCELLED: i32 = -8;
/// a file could not be opened, read or written
pub const OBC_IO: i32 = -9;
/// legal, but not something that this library does
pub const OBC_UNSUPPORTED: i32 = -10;
/// the method ended without a result that can be certified
pub const OBC_NO_VALID_RESULT: i32 = -11;
/// a defect of the library
pub const OBC_INTERNAL: i32 = -12;

pub type obc_status = i32;

/// Progress of a computation: its phase, how much of it is done (total is 0 where it is not known) and the best value of
/// the objective so far (NaN where there is none). Answer 0 to go on, anything else to stop with OBC\_CANCELLED. Called
/// on the thread that called the library, often enough to stop within 50 ms.
pub type obc_progress_function = Option<unsafe extern "C" fn(phase: *const c_char, done: u64, total: u64, best: f64, user: *mut c_void) -> i32>;

/// One line for a log, without a line end.
pub type obc_log_function = Option<unsafe extern "C" fn(line: *const c_char, user: *mut c_void)>;

/// A host's job system: calls task(i, context) once for every i in \[0, count), on any threads, and returns when all of
/// them are done. Results never depend on order or on the number of threads.
pub type obc_parallel_for_function = Option<unsafe extern "C" fn(count: usize, task: Option<unsafe extern "C" fn(index: usize, context: *mut c_void)>, context: *mut c_void, user: *mut c_void)>;

/// Owned by the caller; filled when a function fails, cleared (status OBC\_OK, empty texts) when it succeeds.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_error {
    pub status: i32,
    /// one word, as the orbicube command prints it: "not-closed", "index-range", ...
    pub kind: [c_char; 28],
    /// what is wrong and where; UTF-8, cut at the end if it is longer, always terminated
    pub message: [c_char; 480],
}

/// Memory for what the libraries allocate. allocate answers NULL on failure, which ends in OBC\_OUT\_OF\_MEMORY; alignment is
/// a power of two. release gets the size and alignment of the allocation. Both may be called from several threads.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_allocator {
    pub allocate: Option<unsafe extern "C" fn(size: usize, alignment: usize, user: *mut c_void) -> *mut c_void>,
    pub release: Option<unsafe extern "C" fn(pointer: *mut c_void, size: usize, alignment: usize, user: *mut c_void)>,
    pub user: *mut c_void,
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_host {
    pub struct_size: u32,
    /// 0: one a core; not used when parallel\_for is given
    pub thread_count: u32,
    /// or NULL
    pub progress: obc_progress_function,
    pub progress_user: *mut c_void,
    /// or NULL: silent
    pub log: obc_log_function,
    pub log_user: *mut c_void,
    /// or NULL: threads of our own
    pub parallel_for: obc_parallel_for_function,
    pub parallel_for_user: *mut c_void,
    /// or NULL; kept by handles until they are destroyed
    pub allocator: *const obc_allocator,
}

extern "C" {
    /// Fills a host with the defaults: nothing lent, one thread a core.
    pub fn obc_host_init(host: *mut obc_host, struct_size: usize) -> i32;
    /// Short English name of a status, such as "out of memory". Never NULL; a static string.
    pub fn obc_status_name(status: i32) -> *const c_char;
    /// Version of the base library, major \* 10000 + minor \* 100 + patch.
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
        assert_eq!((size_of::<obc_host>(), align_of::<obc_host>()), (64, 8));
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
    }
}
