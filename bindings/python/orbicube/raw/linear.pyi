"""What <orbicube/linear.h> declares. Written by scripts/bindings.py; not to be edited."""
from typing import Any

from .._library import Pointer, Struct

OBC_LINEAR_AUTO: int
OBC_LINEAR_EIGEN: int
OBC_LINEAR_CHOLMOD_SIMPLICIAL: int
OBC_LINEAR_CHOLMOD_SUPERNODAL: int

OBC_LINEAR_ITERATIVE_AUTO: int
OBC_LINEAR_GAUSS_SEIDEL: int
OBC_LINEAR_MULTIGRID: int

class obc_linear_matrix(Struct):
    size: int
    row_begin: Any
    columns: Any
    values: Any
    def __init__(self, size: int = ..., row_begin: Any = ..., columns: Any = ..., values: Any = ...) -> None: ...

class obc_linear_direct_options(Struct):
    struct_size: int
    method: int
    def __init__(self, struct_size: int = ..., method: int = ...) -> None: ...

class obc_linear_iterative_options(Struct):
    struct_size: int
    method: int
    block_size: int
    max_iterations: int
    tolerance: float
    def __init__(self, struct_size: int = ..., method: int = ..., block_size: int = ..., max_iterations: int = ..., tolerance: float = ...) -> None: ...

class obc_linear_iterative_report(Struct):
    struct_size: int
    converged: int
    iterations: int
    residual: float
    def __init__(self, struct_size: int = ..., converged: int = ..., iterations: int = ..., residual: float = ...) -> None: ...

def obc_linear_direct_options_init(options: Pointer, struct_size: int) -> int:
    """Fills options with the defaults. Errors: OBC_INVALID_ARGUMENT."""
    ...

def obc_linear_direct_create(matrix: Pointer, options: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Factorizes a matrix. options and host may be NULL. The host's allocator must remain valid until _destroy; the factor itself
    is not in its memory. A factorization reports no progress and cannot be cancelled. Release with obc_linear_direct_destroy.
    Errors: OBC_INVALID_ARGUMENT (NULL, unsorted rows, no diagonal, not finite, unknown method), OBC_NO_VALID_RESULT (not positive
    definite), OBC_UNSUPPORTED (the build has no CHOLMOD), OBC_OUT_OF_MEMORY."""
    ...

def obc_linear_direct_destroy(factor: Pointer) -> None:
    """Destroys a factor; NULL is allowed."""
    ...

def obc_linear_direct_refactor(factor: Pointer, values: Pointer, count: int, error: Pointer) -> int:
    """Factorizes other values in the pattern of the matrix that the factor was created from, in the order of its entries; removed
    rows and updates end. count: row_begin[size]. Errors: OBC_INVALID_ARGUMENT; OBC_NO_VALID_RESULT (not positive definite: the
    factor accepts other values, but no right side)."""
    ...

def obc_linear_direct_solve(factor: Pointer, columns: int, right: Pointer, solution: Pointer, error: Pointer) -> int:
    """Solves A X = B for `columns` right sides of `size` numbers each, one after the other. solution has the same length, and may be
    `right`. Errors: OBC_INVALID_ARGUMENT (NULL, not finite, or the last refactor or update failed), OBC_OUT_OF_MEMORY."""
    ...

def obc_linear_direct_remove_row(factor: Pointer, row: int, error: Pointer) -> int:
    """Replaces row and column `row` of the factorized matrix by those of the identity, as for an unknown that becomes known (Davis
    and Hager 2005). Errors: OBC_INVALID_ARGUMENT (row out of range, or the last refactor or update failed)."""
    ...

def obc_linear_direct_update(factor: Pointer, rows: Pointer, values: Pointer, count: int, sign: int, error: Pointer) -> int:
    """Adds w w' to the factorized matrix (sign 1) or subtracts it (sign -1), for the vector w with the given entries (Davis and Hager
    1999). rows: count distinct rows; each pair of them must have an entry in the pattern. values: count finite numbers.
    Errors: OBC_INVALID_ARGUMENT (NULL, out of range, repeated, not in the pattern); OBC_NO_VALID_RESULT (the result is not
    positive definite: call obc_linear_direct_refactor before the next solution)."""
    ...

def obc_linear_direct_entry_count(factor: Pointer) -> int:
    """Returns the number of entries of L below its diagonal; 0 for NULL."""
    ...

def obc_linear_iterative_options_init(options: Pointer, struct_size: int) -> int:
    """Fill options with the defaults, and a report with zeros and its size. Errors: OBC_INVALID_ARGUMENT."""
    ...

def obc_linear_iterative_report_init(report: Pointer, struct_size: int) -> int:
    """Fill options with the defaults, and a report with zeros and its size. Errors: OBC_INVALID_ARGUMENT."""
    ...

def obc_linear_iterative_create(matrix: Pointer, options: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Copies a matrix and computes its preconditioner. options and host may be NULL. The solver keeps the host: each
    obc_linear_iterative_solve uses its allocator and threads, reports to its progress callback and is cancelled by it. Whatever
    the host points at (allocator, progress_user, fraction and others) must remain valid until obc_linear_iterative_destroy.
    Precondition, not checked: the matrix is positive definite.
    Errors: OBC_INVALID_ARGUMENT, OBC_OUT_OF_MEMORY, OBC_CANCELLED."""
    ...

def obc_linear_iterative_destroy(solver: Pointer) -> None:
    """Destroys a solver; NULL is allowed."""
    ...

def obc_linear_iterative_solve(solver: Pointer, right: Pointer, solution: Pointer, report: Pointer, error: Pointer) -> int:
    """Solves A x = b from x = 0. right and solution have `size` numbers and do not overlap. report may be NULL. The solution is
    written also where the tolerance was not reached: see report->converged. Progress goes to the host that the solver was created
    with. Errors, with nothing written: OBC_INVALID_ARGUMENT (NULL, not finite), OBC_OUT_OF_MEMORY, OBC_CANCELLED."""
    ...

def obc_linear_version() -> int:
    """Returns the version of the library, major * 10000 + minor * 100 + patch."""
    ...
