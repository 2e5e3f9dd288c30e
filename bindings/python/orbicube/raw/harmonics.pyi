"""What <orbicube/harmonics.h> declares. Written by scripts/bindings.py; not to be edited."""
from typing import Any

from .._library import Pointer, Struct

OBC_HARMONICS_AUTOMATIC: int
OBC_HARMONICS_DENSE: int
OBC_HARMONICS_ITERATIVE: int

OBC_HARMONICS_BY_ENDING: int
OBC_HARMONICS_SHTOOLS: int
OBC_HARMONICS_SPHARM_PDM: int

class obc_harmonics_fit_options(Struct):
    struct_size: int
    degree: int
    method: int
    reserved: int
    smoothing: float
    def __init__(self, struct_size: int = ..., degree: int = ..., method: int = ..., reserved: int = ..., smoothing: float = ...) -> None: ...

class obc_harmonics_fit_report(Struct):
    struct_size: int
    method: int
    unknowns: int
    rank: int
    condition: float
    residual: float
    iterations: int
    def __init__(self, struct_size: int = ..., method: int = ..., unknowns: int = ..., rank: int = ..., condition: float = ..., residual: float = ..., iterations: int = ...) -> None: ...

class obc_harmonics_align_options(Struct):
    struct_size: int
    turn_values: int
    search_degree: int
    reserved: int
    def __init__(self, struct_size: int = ..., turn_values: int = ..., search_degree: int = ..., reserved: int = ...) -> None: ...

class obc_harmonics_alignment(Struct):
    struct_size: int
    reserved: int
    rotation: Any
    values: Any
    correlation: float
    def __init__(self, struct_size: int = ..., reserved: int = ..., rotation: Any = ..., values: Any = ..., correlation: float = ...) -> None: ...

def obc_harmonics_fit_options_init(options: Pointer, struct_size: int) -> int:
    """Fills options with the defaults, and a report with zeros and its size."""
    ...

def obc_harmonics_fit_report_init(report: Pointer, struct_size: int) -> int:
    """Fills options with the defaults, and a report with zeros and its size."""
    ...

def obc_harmonics_size(degree: int) -> int:
    """(degree + 1)^2."""
    ...

def obc_harmonics_evaluate(directions: Pointer, count: int, degree: int, host: Pointer, rows: Pointer, error: Pointer) -> int:
    """Y_lm of every direction: rows, count * (degree+1)^2 doubles, a direction after the other. host may be NULL.
    O(count * degree^2).
    Errors: OBC_INVALID_ARGUMENT (NULL, not finite, length zero, degree), OBC_CANCELLED, OBC_OUT_OF_MEMORY."""
    ...

def obc_harmonics_fit(directions: Pointer, weights: Pointer, values: Pointer, count: int, channels: int, options: Pointer, host: Pointer, coefficients: Pointer, report: Pointer, error: Pointer) -> int:
    """The coefficients that fit values at scattered directions best: least squares with `weights`, one a direction and not
    negative, or NULL for ones. For a surface, the weights of obc_harmonics_vertex_areas are the usual choice: each piece
    counts by its own area.
    options, host and report may be NULL. coefficients: written on success only. A rank-deficient fit is no error: see
    report->rank.
    Errors: as obc_harmonics_evaluate."""
    ...

def obc_harmonics_synthesize(coefficients: Pointer, degree: int, channels: int, directions: Pointer, count: int, host: Pointer, values: Pointer, gradients: Pointer, error: Pointer) -> int:
    """The functions at the directions: values, count * channels doubles; and unless gradients is NULL, their gradients on the
    sphere of radius 1, tangent vectors, 3 * count * channels doubles. O(count * degree^2 * channels).
    Errors: as obc_harmonics_evaluate."""
    ...

def obc_harmonics_vertex_areas(positions: Pointer, vertex_count: int, triangles: Pointer, triangle_count: int, host: Pointer, areas: Pointer, error: Pointer) -> int:
    """A third of the area of its triangles for each vertex: areas, vertex_count doubles. Triangles are three vertex indices
    each. O(n).
    Errors: OBC_INVALID_ARGUMENT, OBC_MALFORMED_FILE (kind index-range: no such vertex), OBC_OUT_OF_MEMORY."""
    ...

def obc_harmonics_degree_norms(coefficients: Pointer, degree: int, channels: int, norms: Pointer, error: Pointer) -> int:
    """The norm of each degree, sqrt(sum over m and the channels of the squares): norms, degree + 1 doubles. It does not change
    when the sphere is turned, nor when the values of three channels are.
    Errors: OBC_INVALID_ARGUMENT, OBC_OUT_OF_MEMORY."""
    ...

def obc_harmonics_shape_distance(f: Pointer, f_degree: int, g: Pointer, g_degree: int, channels: int, first: int, last: int, distance: Pointer, error: Pointer) -> int:
    """The distance D_n(f, g) of the dissertation's section 3.3.3: the sum over the degrees from first to last of the squared
    difference of the norms; degrees that one of them does not have count as zero there. first = 0 is the dissertation's;
    with first = 1 it does not matter where the shapes lie.
    Errors: as obc_harmonics_degree_norms."""
    ...

def obc_harmonics_filter(coefficients: Pointer, degree: int, channels: int, low: int, high: int, width: int, keep_mean: int, error: Pointer) -> int:
    """Filters in place: degrees from low to high stay, the others become zero, over `width` degrees outside of each end with a
    raised cosine (0: at once). With keep_mean 1 degree 0 stays, which is where a shape lies.
    Errors: as obc_harmonics_degree_norms."""
    ...

def obc_harmonics_mean_distance(a: Pointer, a_count: int, b: Pointer, b_count: int, host: Pointer, distance: Pointer, error: Pointer) -> int:
    """The reconstruction error of section 3.3.2: e(A, B) = max(d(A, B), d(B, A)), d(A, B) the mean over the points of A of the
    distance to the nearest point of B. O(n log n).
    Errors: OBC_INVALID_ARGUMENT (NULL, no points, not finite), OBC_CANCELLED, OBC_OUT_OF_MEMORY."""
    ...

def obc_harmonics_rotate(coefficients: Pointer, degree: int, channels: int, rotation: Pointer, host: Pointer, turned: Pointer, error: Pointer) -> int:
    """The functions turned with the sphere: what each has at direction v, it has at R v afterwards. rotation: the matrix R by
    rows, 9 doubles. turned may be coefficients. The values are not turned: for a shape that turns in space, multiply the three
    coefficients of each Y_lm by the matrix. O(degree^3).
    Errors: OBC_INVALID_ARGUMENT (also: no rotation), OBC_CANCELLED, OBC_OUT_OF_MEMORY."""
    ...

def obc_harmonics_align_options_init(options: Pointer, struct_size: int) -> int:
    """Fills options with the defaults, and an alignment with zeros and its size."""
    ...

def obc_harmonics_alignment_init(alignment: Pointer, struct_size: int) -> int:
    """Fills options with the defaults, and an alignment with zeros and its size."""
    ...

def obc_harmonics_align(fixed: Pointer, fixed_degree: int, moving: Pointer, moving_degree: int, channels: int, options: Pointer, host: Pointer, alignment: Pointer, error: Pointer) -> int:
    """The rotation that brings `moving` best into line with `fixed`: it maximises the sum over the channels of the integral of
    fixed(u) * (Q moving)(R^-1 u), without degree 0. Found on a grid of all rotations (Kostelec and Rockmore 2008, "FFTs on the
    rotation group") and refined by Newton's method up to the lower of the two degrees. options and host may be NULL.
    O(search_degree^4 + degree^3).
    Errors: OBC_INVALID_ARGUMENT, OBC_NO_VALID_RESULT (one of them is constant), OBC_CANCELLED, OBC_OUT_OF_MEMORY."""
    ...

def obc_harmonics_write(path: bytes | None, format: int, coefficients: Pointer, degree: int, channels: int, error: Pointer) -> int:
    """Writes a file, whole or not at all; read again, every number is the same to its last bits.
    Errors: OBC_INVALID_ARGUMENT, OBC_UNSUPPORTED (ending; channels other than 3 for SPHARM-PDM), OBC_IO,
    OBC_OUT_OF_MEMORY. The message starts with the path."""
    ...

def obc_harmonics_read(path: bytes | None, format: int, host: Pointer, coefficients: Pointer, error: Pointer) -> int:
    """host may be NULL; its allocator must stay valid until _destroy. Nothing in a file is trusted.
    Errors: OBC_INVALID_ARGUMENT, OBC_MALFORMED_FILE (empty-file, bad-magic, parse, truncated, trailing-data, non-finite, with
    the line), OBC_UNSUPPORTED, OBC_IO, OBC_CANCELLED, OBC_OUT_OF_MEMORY. The message starts with the path."""
    ...

def obc_harmonics_coefficients_degree(coefficients: Pointer) -> int:
    """0 for NULL."""
    ...

def obc_harmonics_coefficients_channels(coefficients: Pointer) -> int:
    """0 for NULL."""
    ...

def obc_harmonics_coefficients_copy(coefficients: Pointer, values: Pointer, error: Pointer) -> int:
    """Copies them out: (degree+1)^2 * channels doubles. Errors: OBC_INVALID_ARGUMENT."""
    ...

def obc_harmonics_coefficients_destroy(coefficients: Pointer) -> None:
    """NULL is fine."""
    ...

def obc_harmonics_version() -> int:
    """Version of the library, major * 10000 + minor * 100 + patch."""
    ...
