"""Solves A x = b for sparse symmetric positive definite A: by factors that follow small changes of A, or by iterations.

    factor = Direct(A)
    x = factor.solve(b)
    x, report = Iterative(A, tolerance=1e-6).solve(b)

`A` is a matrix of scipy.sparse (or anything with `tocsr`), an array, or the tuple (row_begin, columns, values) of the lower
triangle as C has it. Of the first two, the whole matrix or its lower triangle alone. Options are the members of
`obc_linear_direct_options` and `obc_linear_iterative_options`; docs/linear.md of the library describes the methods.
"""

from __future__ import annotations

import ctypes
from ctypes import byref
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import Doubles, address, doubles, finite, indices, numbers
from ._call import Handle, KeptHost, Progress, call, filled, sized, with_options
from ._checks import integer, public
from .raw import linear as raw

__all__ = ["Direct", "Iterative", "version"]

# Entries (i, j) and (j, i) of a symmetric matrix may differ by this fraction of sqrt(A[i, i] A[j, j]), which bounds the entries
# of a positive definite matrix: sums of products in another order, as of B' D B, differ by less, and mistakes by more.
SYMMETRY = 1e-12


class _Matrix:
    """The lower triangle by rows, as C has it: `keys` are row * n + column of the entries in order."""

    def __init__(self, A: Any) -> None:
        if isinstance(A, tuple) and len(A) == 3:
            self.n, rows, columns, values = _of_triangle(*A)
        else:
            self.n, rows, columns, values = _of_entries(*(_of_sparse(A) if hasattr(A, "tocsr") else _of_array(A)))
        missing = np.setdiff1d(np.arange(self.n), rows[rows == columns])
        if missing.size:
            i = missing[0]
            raise ValueError(f"A has no entry on the diagonal of row {i}: A[{i}, {i}] must be positive")
        self.keys = rows * self.n + columns
        self.columns = np.ascontiguousarray(columns, dtype=np.uint32)
        self.values = np.ascontiguousarray(values, dtype=np.float64)
        self.row_begin = np.searchsorted(rows, np.arange(self.n + 1)).astype(np.uintp)

    def view(self) -> raw.obc_linear_matrix:
        return raw.obc_linear_matrix(self.n, address(self.row_begin), address(self.columns), address(self.values))


_Entries = tuple[int, Any, Any, Any]  # n, and the row, column and value of each entry


def _of_triangle(row_begin: Any, columns: Any, values: Any) -> _Entries:
    starts = indices(row_begin, name="A: row_begin").astype(np.int64)
    if starts.ndim != 1 or starts.size == 0 or starts[0] != 0 or np.any(np.diff(starts) < 0):
        raise ValueError("A: row_begin must rise from 0 to the number of entries")
    n = starts.size - 1
    column = indices(columns, name="A: columns", below=n, of="rows").astype(np.int64)
    value = doubles(values, name="A: values")
    if not column.shape == value.shape == (starts[-1],):
        raise ValueError(f"A: columns and values must have row_begin[-1] = {starts[-1]} entries, not shapes {column.shape} and "
                         f"{value.shape}")
    row = np.repeat(np.arange(n), np.diff(starts))
    above = np.flatnonzero(column > row)
    if above.size:
        i = above[0]
        raise ValueError(f"A: columns[{i}] is {column[i]}, right of the diagonal of row {row[i]}: the lower triangle is needed")
    unordered = np.flatnonzero(np.diff(row * n + column) <= 0)
    if unordered.size:
        raise ValueError(f"A: the columns of row {row[unordered[0] + 1]} do not ascend")
    return n, row, column, value


def _of_sparse(A: Any) -> _Entries:
    csr = A.tocsr()
    _square(csr.shape)
    starts = indices(csr.indptr, name="A: indptr").astype(np.int64)
    column = indices(csr.indices, name="A: indices", below=csr.shape[0], of="rows").astype(np.int64)
    return csr.shape[0], np.repeat(np.arange(csr.shape[0]), np.diff(starts)), column, doubles(csr.data, name="A: data")


def _of_array(A: Any) -> _Entries:
    dense = doubles(A, name="A")
    _square(dense.shape)
    row, column = np.nonzero(dense)
    return len(dense), row, column, dense[row, column]


def _square(shape: tuple[int, ...]) -> None:
    if len(shape) != 2 or shape[0] != shape[1]:
        raise ValueError(f"A: a square matrix is needed, not shape {shape}")


def _of_entries(n: int, row: Any, column: Any, value: Any) -> _Entries:
    """Of entries in any order, repeated ones added: the lower triangle, in order."""
    below = row >= column
    key, value_at = _added(row[below] * n + column[below], value[below])
    if not below.all():
        upper_key, upper = _added(column[~below] * n + row[~below], value[~below])
        union = np.union1d(key, upper_key)
        value_at, mirrored = _spread(union, key, value_at), _spread(union, upper_key, upper)
        _require_symmetric(n, union, value_at, mirrored)
        key = union
    return n, key // max(n, 1), key % max(n, 1), value_at


def _added(key: Any, value: Any) -> tuple[Any, Any]:
    """Keys in order, each once, with the sums of their values."""
    order = np.argsort(key, kind="stable")
    unique, first = np.unique(key[order], return_index=True)
    return unique, np.add.reduceat(value[order], first) if unique.size else value[order]


def _spread(union: Any, key: Any, value: Any) -> Doubles:
    """Values of the keys at their positions in a larger set; 0 elsewhere."""
    result = np.zeros(union.size)
    result[np.searchsorted(union, key)] = value
    return result


def _require_symmetric(n: int, key: Any, lower: Any, upper: Any) -> None:
    row, column = key // n, key % n
    inner = row == column
    scale = np.zeros(n)
    scale[row[inner]] = np.sqrt(np.abs(lower[inner]))
    bad = np.flatnonzero(~inner & (np.abs(lower - upper) > SYMMETRY * scale[row] * scale[column]))
    if bad.size:
        i, j = row[bad[0]], column[bad[0]]
        raise ValueError(f"A is not symmetric: A[{i}, {j}] is {lower[bad[0]]} and A[{j}, {i}] is {upper[bad[0]]}; give a symmetric "
                         "matrix or its lower triangle alone")


class Direct:
    """The factor L D L' of a matrix, for any number of right sides.

    `method`: "cholmod-simplicial" and "cholmod-supernodal" are in builds with CHOLMOD, else orbicube.Unsupported. A matrix that is
    not positive definite is orbicube.NoValidResult."""

    @with_options("obc_linear_direct_options")
    def __init__(self, A: Any, *,
                 # options of obc_linear_direct_options, written by scripts/bindings.py
                 method: Literal["auto", "eigen", "cholmod-simplicial", "cholmod-supernodal"] = "auto",
                 # end of options
                 ) -> None:
        chosen = filled(raw.obc_linear_direct_options, raw.obc_linear_direct_options_init, locals())
        matrix, handle = _Matrix(A), ctypes.c_void_p()
        view = matrix.view()
        call(raw.obc_linear_direct_create, byref(view), byref(chosen), None, byref(handle))
        self._handle = Handle(raw.obc_linear_direct_destroy, handle.value)
        self._n, self._keys = matrix.n, matrix.keys

    @public
    def solve(self, b: ArrayLike) -> Doubles:
        """Solves A x = b; of an array of n rows, for each of its columns."""
        right = np.asarray(numbers(b, "b"), dtype=np.float64)
        if right.ndim not in (1, 2) or right.shape[0] != self._n:
            raise ValueError(f"b: {self._n} rows are needed, in one column or several, not shape {right.shape}")
        right = np.require(finite(right, "b"), requirements=["F", "A"])
        solution = np.empty(right.shape, order="F")
        count = 1 if right.ndim == 1 else right.shape[1]
        call(raw.obc_linear_direct_solve, self._handle, count, address(right), address(solution))
        return solution

    @public
    def refactor(self, A: Any) -> None:
        """Factorizes a matrix of the same pattern, or of fewer entries. Removed rows and updates do not remain."""
        matrix = _Matrix(A)
        if matrix.n != self._n:
            raise ValueError(f"A: {self._n} rows are needed as before, not {matrix.n}")
        new = np.flatnonzero(~np.isin(matrix.keys, self._keys, assume_unique=True))
        if new.size:
            key = matrix.keys[new[0]]
            raise ValueError(f"A[{key // self._n}, {key % self._n}] is not in the pattern of the factor: make a new Direct")
        values = _spread(self._keys, matrix.keys, matrix.values)
        call(raw.obc_linear_direct_refactor, self._handle, address(values), values.size)

    @public
    def remove_row(self, row: int) -> None:
        """Replaces row and column `row` of A by those of the identity, as for an unknown that becomes known."""
        call(raw.obc_linear_direct_remove_row, self._handle, integer(row, "row", 0, self._n - 1))

    @public
    def update(self, rows: ArrayLike, values: ArrayLike, sign: int = 1) -> None:
        """Adds sign w w' to A, for the w with these entries. A has an entry, which may be 0, for any two of the rows."""
        where = indices(rows, name="rows", below=self._n, of="rows")
        w = doubles(values, name="values")
        if where.ndim != 1 or w.shape != where.shape:
            raise ValueError(f"rows and values must be as many in one dimension, not of shapes {where.shape} and {w.shape}")
        if sign not in (1, -1):
            raise ValueError(f"sign={sign}: 1 or -1 is needed")
        call(raw.obc_linear_direct_update, self._handle, address(where), address(w), where.size, sign)

    @property
    def entry_count(self) -> int:
        """The number of entries of L below its diagonal."""
        return int(raw.obc_linear_direct_entry_count(self._handle))


class Iterative:
    """Conjugate gradients for a matrix, with symmetric Gauss-Seidel or algebraic multigrid. That A is positive definite is not
    checked. An object is for one thread at a time."""

    @with_options("obc_linear_iterative_options")
    def __init__(self, A: Any, *,
                 # options of obc_linear_iterative_options, written by scripts/bindings.py
                 method: Literal["auto", "gauss-seidel", "multigrid"] = "auto", block_size: int = 1,
                 max_iterations: int = 1000, tolerance: float = 1e-08,
                 # end of options
                 progress: Progress = None, threads: int = 0) -> None:
        chosen = filled(raw.obc_linear_iterative_options, raw.obc_linear_iterative_options_init, locals())
        if chosen.block_size not in (1, 2, 3):
            raise ValueError(f"block_size={chosen.block_size}: 1, 2 or 3 is needed")
        matrix, handle = _Matrix(A), ctypes.c_void_p()
        if matrix.n % chosen.block_size:
            raise ValueError(f"block_size={chosen.block_size}: A has {matrix.n} rows, which is no multiple of it")
        view = matrix.view()
        self._n, self._host = matrix.n, KeptHost(threads)
        self._host.call(raw.obc_linear_iterative_create, byref(view), byref(chosen), byref(self._host.host), byref(handle),
                        progress=progress)
        self._handle = Handle(raw.obc_linear_iterative_destroy, handle.value)

    @public
    def solve(self, b: ArrayLike, progress: Progress = None) -> tuple[Doubles, raw.obc_linear_iterative_report]:
        """The solution of A x = b, and a report: `converged`, `iterations` and `residual`, |b - A x| / |b| of the solution."""
        right = doubles(b, name="b")
        if right.shape != (self._n,):
            raise ValueError(f"b: {self._n} numbers are needed, not shape {right.shape}")
        solution, report = np.empty(self._n), sized(raw.obc_linear_iterative_report)
        self._host.call(raw.obc_linear_iterative_solve, self._handle, address(right), address(solution), byref(report),
                        progress=progress)
        return solution, report


def version() -> int:
    """major * 10000 + minor * 100 + patch."""
    return raw.obc_linear_version()
