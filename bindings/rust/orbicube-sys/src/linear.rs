//! What `<orbicube/linear.h>` declares. Written by scripts/bindings.py; not to be edited.
#![allow(non_camel_case_types, non_upper_case_globals)]

use crate::base::{obc_error, obc_host};

/// CHOLMOD's supernodal factors if the build has them and the pattern promises a gain, else Eigen
pub const OBC_LINEAR_AUTO: i32 = 0;
/// simplicial factors, approximate minimum degree ordering
pub const OBC_LINEAR_EIGEN: i32 = 1;
/// simplicial factors (Chen, Davis, Hager and Rajamanickam 2008)
pub const OBC_LINEAR_CHOLMOD_SIMPLICIAL: i32 = 2;
/// blocks of columns by BLAS
pub const OBC_LINEAR_CHOLMOD_SUPERNODAL: i32 = 3;

/// multigrid from 20,000 blocks on, else Gauss-Seidel
pub const OBC_LINEAR_ITERATIVE_AUTO: i32 = 0;
/// symmetric sweeps at the cost of one product an iteration (Eisenstat 1981)
pub const OBC_LINEAR_GAUSS_SEIDEL: i32 = 1;
/// aggregation-based multigrid with Krylov cycles (Notay 2010)
pub const OBC_LINEAR_MULTIGRID: i32 = 2;

/// A factor of a matrix.
#[repr(C)]
pub struct obc_linear_direct {
    _private: [u8; 0],
    _marker: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

/// A matrix with its preconditioner.
#[repr(C)]
pub struct obc_linear_iterative {
    _private: [u8; 0],
    _marker: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

/// The lower triangle of a symmetric matrix in compressed rows: a view, which functions copy if they need it after they return.
/// Row i has the entries row\_begin\[i\] to row\_begin\[i + 1\] - 1. Its columns ascend; the last one is i, the diagonal.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_linear_matrix {
    /// Number of rows and columns, 0 to 2^31 - 1.
    pub size: usize,
    /// size + 1 numbers, the first 0, ascending; the last at most 2^31 - 1.
    pub row_begin: *const usize,
    /// row\_begin\[size\] numbers.
    pub columns: *const u32,
    /// row\_begin\[size\] finite numbers.
    pub values: *const f64,
}

/// Options of a factor. Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_linear_direct_options {
    pub struct_size: u32,
    /// Engine, OBC\_LINEAR\_AUTO to OBC\_LINEAR\_CHOLMOD\_SUPERNODAL. Default: OBC\_LINEAR\_AUTO.
    pub method: i32,
}

/// Options of an iterative solver. Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_linear_iterative_options {
    pub struct_size: u32,
    /// Preconditioner, OBC\_LINEAR\_ITERATIVE\_AUTO to OBC\_LINEAR\_MULTIGRID. Default: OBC\_LINEAR\_ITERATIVE\_AUTO.
    pub method: i32,
    /// Number of consecutive unknowns that form a block, as x, y, z of a point: 1, 2 or 3. Default: 1.
    pub block_size: i32,
    /// Maximum number of iterations of a solution. Default: 1000.
    pub max_iterations: u32,
    /// Requested relative residual |b - A x| / |b|, 0 to 1, exclusive. Default: 1e-8.
    pub tolerance: f64,
}

/// Result of an iterative solution. Set struct\_size, or fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_linear_iterative_report {
    pub struct_size: u32,
    /// 1: the residual reached the tolerance; 0: max\_iterations or rounding ended the iterations.
    pub converged: i32,
    /// Number of iterations, of all restarts together.
    pub iterations: u64,
    /// |b - A x| / |b| of the solution, computed with A itself; 0 for b = 0.
    pub residual: f64,
}

extern "C" {
    /// Fills options with the defaults. Errors: OBC\_INVALID\_ARGUMENT.
    pub fn obc_linear_direct_options_init(options: *mut obc_linear_direct_options, struct_size: usize) -> i32;
    /// Factorizes a matrix. options and host may be NULL. The host's allocator must remain valid until \_destroy; the factor itself
    /// is not in its memory. A factorization reports no progress and cannot be cancelled. Release with obc\_linear\_direct\_destroy.
    /// Errors: OBC\_INVALID\_ARGUMENT (NULL, unsorted rows, no diagonal, not finite, unknown method), OBC\_NO\_VALID\_RESULT (not positive
    /// definite), OBC\_UNSUPPORTED (the build has no CHOLMOD), OBC\_OUT\_OF\_MEMORY.
    pub fn obc_linear_direct_create(matrix: *const obc_linear_matrix, options: *const obc_linear_direct_options, host: *const obc_host, out: *mut *mut obc_linear_direct, error: *mut obc_error) -> i32;
    /// Destroys a factor; NULL is allowed.
    pub fn obc_linear_direct_destroy(factor: *mut obc_linear_direct);
    /// Factorizes other values in the pattern of the matrix that the factor was created from, in the order of its entries; removed
    /// rows and updates end. count: row\_begin\[size\]. Errors: OBC\_INVALID\_ARGUMENT; OBC\_NO\_VALID\_RESULT (not positive definite: the
    /// factor accepts other values, but no right side).
    pub fn obc_linear_direct_refactor(factor: *mut obc_linear_direct, values: *const f64, count: usize, error: *mut obc_error) -> i32;
    /// Solves A X = B for \`columns\` right sides of \`size\` numbers each, one after the other. solution has the same length, and may be
    /// \`right\`. Errors: OBC\_INVALID\_ARGUMENT (NULL, not finite, or the last refactor or update failed), OBC\_OUT\_OF\_MEMORY.
    pub fn obc_linear_direct_solve(factor: *mut obc_linear_direct, columns: usize, right: *const f64, solution: *mut f64, error: *mut obc_error) -> i32;
    /// Replaces row and column \`row\` of the factorized matrix by those of the identity, as for an unknown that becomes known (Davis
    /// and Hager 2005). Errors: OBC\_INVALID\_ARGUMENT (row out of range, or the last refactor or update failed).
    pub fn obc_linear_direct_remove_row(factor: *mut obc_linear_direct, row: u32, error: *mut obc_error) -> i32;
    /// Adds w w' to the factorized matrix (sign 1) or subtracts it (sign -1), for the vector w with the given entries (Davis and Hager
    /// 1999). rows: count distinct rows; each pair of them must have an entry in the pattern. values: count finite numbers.
    /// Errors: OBC\_INVALID\_ARGUMENT (NULL, out of range, repeated, not in the pattern); OBC\_NO\_VALID\_RESULT (the result is not
    /// positive definite: call obc\_linear\_direct\_refactor before the next solution).
    pub fn obc_linear_direct_update(factor: *mut obc_linear_direct, rows: *const u32, values: *const f64, count: usize, sign: i32, error: *mut obc_error) -> i32;
    /// Returns the number of entries of L below its diagonal; 0 for NULL.
    pub fn obc_linear_direct_entry_count(factor: *const obc_linear_direct) -> usize;
    /// Fill options with the defaults, and a report with zeros and its size. Errors: OBC\_INVALID\_ARGUMENT.
    pub fn obc_linear_iterative_options_init(options: *mut obc_linear_iterative_options, struct_size: usize) -> i32;
    /// Fill options with the defaults, and a report with zeros and its size. Errors: OBC\_INVALID\_ARGUMENT.
    pub fn obc_linear_iterative_report_init(report: *mut obc_linear_iterative_report, struct_size: usize) -> i32;
    /// Copies a matrix and computes its preconditioner. options and host may be NULL. The solver keeps the host: each
    /// obc\_linear\_iterative\_solve uses its allocator and threads, reports to its progress callback and is cancelled by it. Whatever
    /// the host points at (allocator, progress\_user, fraction and others) must remain valid until obc\_linear\_iterative\_destroy.
    /// Precondition, not checked: the matrix is positive definite.
    /// Errors: OBC\_INVALID\_ARGUMENT, OBC\_OUT\_OF\_MEMORY, OBC\_CANCELLED.
    pub fn obc_linear_iterative_create(matrix: *const obc_linear_matrix, options: *const obc_linear_iterative_options, host: *const obc_host, out: *mut *mut obc_linear_iterative, error: *mut obc_error) -> i32;
    /// Destroys a solver; NULL is allowed.
    pub fn obc_linear_iterative_destroy(solver: *mut obc_linear_iterative);
    /// Solves A x = b from x = 0. right and solution have \`size\` numbers and do not overlap. report may be NULL. The solution is
    /// written also where the tolerance was not reached: see report-\>converged. Progress goes to the host that the solver was created
    /// with. Errors, with nothing written: OBC\_INVALID\_ARGUMENT (NULL, not finite), OBC\_OUT\_OF\_MEMORY, OBC\_CANCELLED.
    pub fn obc_linear_iterative_solve(solver: *mut obc_linear_iterative, right: *const f64, solution: *mut f64, report: *mut obc_linear_iterative_report, error: *mut obc_error) -> i32;
    /// Returns the version of the library, major \* 10000 + minor \* 100 + patch.
    pub fn obc_linear_version() -> u32;
}

#[cfg(all(test, target_pointer_width = "64"))]
mod layout {
    use super::*;
    use std::mem::{align_of, size_of, MaybeUninit};
    use std::ptr::addr_of;

    #[test]
    fn structs_lie_in_memory_as_in_c() {
        assert_eq!((size_of::<obc_linear_matrix>(), align_of::<obc_linear_matrix>()), (32, 8));
        let it = MaybeUninit::<obc_linear_matrix>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).size) } as usize - start as usize, 0, "obc_linear_matrix.size");
        assert_eq!(unsafe { addr_of!((*start).row_begin) } as usize - start as usize, 8, "obc_linear_matrix.row_begin");
        assert_eq!(unsafe { addr_of!((*start).columns) } as usize - start as usize, 16, "obc_linear_matrix.columns");
        assert_eq!(unsafe { addr_of!((*start).values) } as usize - start as usize, 24, "obc_linear_matrix.values");
        assert_eq!((size_of::<obc_linear_direct_options>(), align_of::<obc_linear_direct_options>()), (8, 4));
        let it = MaybeUninit::<obc_linear_direct_options>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_linear_direct_options.struct_size");
        assert_eq!(unsafe { addr_of!((*start).method) } as usize - start as usize, 4, "obc_linear_direct_options.method");
        assert_eq!((size_of::<obc_linear_iterative_options>(), align_of::<obc_linear_iterative_options>()), (24, 8));
        let it = MaybeUninit::<obc_linear_iterative_options>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_linear_iterative_options.struct_size");
        assert_eq!(unsafe { addr_of!((*start).method) } as usize - start as usize, 4, "obc_linear_iterative_options.method");
        assert_eq!(unsafe { addr_of!((*start).block_size) } as usize - start as usize, 8, "obc_linear_iterative_options.block_size");
        assert_eq!(unsafe { addr_of!((*start).max_iterations) } as usize - start as usize, 12, "obc_linear_iterative_options.max_iterations");
        assert_eq!(unsafe { addr_of!((*start).tolerance) } as usize - start as usize, 16, "obc_linear_iterative_options.tolerance");
        assert_eq!((size_of::<obc_linear_iterative_report>(), align_of::<obc_linear_iterative_report>()), (24, 8));
        let it = MaybeUninit::<obc_linear_iterative_report>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_linear_iterative_report.struct_size");
        assert_eq!(unsafe { addr_of!((*start).converged) } as usize - start as usize, 4, "obc_linear_iterative_report.converged");
        assert_eq!(unsafe { addr_of!((*start).iterations) } as usize - start as usize, 8, "obc_linear_iterative_report.iterations");
        assert_eq!(unsafe { addr_of!((*start).residual) } as usize - start as usize, 16, "obc_linear_iterative_report.residual");
    }
}
