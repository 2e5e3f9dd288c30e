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
    regularization: float
    def __init__(self, struct_size: int = ..., degree: int = ..., method: int = ..., reserved: int = ..., regularization: float = ...) -> None: ...

class obc_harmonics_fit_report(Struct):
    struct_size: int
    method: int
    unknowns: int
    rank: int
    condition: float
    residual: float
    iterations: int
    def __init__(self, struct_size: int = ..., method: int = ..., unknowns: int = ..., rank: int = ..., condition: float = ..., residual: float = ..., iterations: int = ...) -> None: ...

class obc_harmonics_refinement_report(Struct):
    struct_size: int
    rounds: int
    residual_before: float
    residual: float
    def __init__(self, struct_size: int = ..., rounds: int = ..., residual_before: float = ..., residual: float = ...) -> None: ...

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
    """Fill options with the defaults, and a report with zeros and its size."""
    ...

def obc_harmonics_fit_report_init(report: Pointer, struct_size: int) -> int:
    """Fill options with the defaults, and a report with zeros and its size."""
    ...

def obc_harmonics_refinement_report_init(report: Pointer, struct_size: int) -> int:
    """Fill options with the defaults, and a report with zeros and its size."""
    ...

def obc_harmonics_size(degree: int) -> int:
    """Returns the number of coefficients up to a degree, (degree + 1)^2."""
    ...

def obc_harmonics_evaluate(directions: Pointer, count: int, degree: int, host: Pointer, rows: Pointer, error: Pointer) -> int:
    """Evaluates all Y_lm at each direction: rows, count * (degree+1)^2 doubles, one direction after the other. host may be NULL.
    O(count * degree^2). Errors: OBC_INVALID_ARGUMENT (NULL, not finite, zero length, degree), OBC_CANCELLED, OBC_OUT_OF_MEMORY."""
    ...

def obc_harmonics_fit(directions: Pointer, weights: Pointer, values: Pointer, count: int, channels: int, options: Pointer, host: Pointer, coefficients: Pointer, report: Pointer, error: Pointer) -> int:
    """Fits coefficients to values at scattered directions by weighted least squares. weights: one nonnegative number a direction, or NULL
    for ones; those of obc_mesh_vertex_areas, the usual choice for a surface, weight each piece by its area. options, host and
    report may be NULL. coefficients is written on success only. A rank-deficient fit is not an error: see report->rank. Errors: as
    obc_harmonics_evaluate."""
    ...

def obc_harmonics_refine_map(positions: Pointer, vertex_count: int, triangles: Pointer, triangle_count: int, weights: Pointer, options: Pointer, rounds: int, host: Pointer, directions: Pointer, report: Pointer, error: Pointer) -> int:
    """Refines a sphere map for the expansion of its surface to the degree of the options: up to `rounds` times, fits the positions and moves each
    direction, by one damped Gauss-Newton step, towards the point of the fitted surface that is nearest to its vertex. directions (3 *
    vertex_count doubles, of any length) are changed to unit vectors, on success only. Triangles that are positive or negative on the
    sphere beyond rounding keep their orientation, so that a bijection remains one; vertices of others do not move. The angles and
    areas of the map are not controlled. weights as for obc_harmonics_fit; options, host and report may be NULL. O(rounds) fits.
    Errors: as obc_harmonics_evaluate, and OBC_MALFORMED_FILE (kind index-range)."""
    ...

def obc_harmonics_synthesize(coefficients: Pointer, degree: int, channels: int, directions: Pointer, count: int, host: Pointer, values: Pointer, gradients: Pointer, error: Pointer) -> int:
    """Evaluates the functions at directions: values, count * channels doubles, and unless gradients is NULL their tangential gradients on the unit
    sphere, 3 * count * channels doubles. O(count * degree^2 * channels). Errors: as obc_harmonics_evaluate."""
    ...

def obc_harmonics_analyze(directions: Pointer, weights: Pointer, values: Pointer, count: int, channels: int, degree: int, host: Pointer, coefficients: Pointer, error: Pointer) -> int:
    """Computes the transpose of obc_harmonics_synthesize: coefficients, (degree+1)^2 * channels doubles, of which that of Y_lm is the sum of
    weight * value * Y_lm over the directions. For iterative methods of the caller; what fits values best is the result of
    obc_harmonics_fit. weights: one number a direction, or NULL for ones. The weights and values may be any numbers; sums with
    those that are not finite are not finite. O(count * degree^2 * channels), from degree 80 O((count + degree^3) * channels).
    coefficients is written on success only. host may be NULL. Errors: as obc_harmonics_evaluate."""
    ...

def obc_harmonics_degree_norms(coefficients: Pointer, degree: int, channels: int, norms: Pointer, error: Pointer) -> int:
    """Computes the norm of each degree, the square root of the sum of squares over m and the channels: norms, degree + 1 doubles. It is
    invariant under rotations of the sphere, and of the values of three channels. Errors: OBC_INVALID_ARGUMENT, OBC_OUT_OF_MEMORY."""
    ...

def obc_harmonics_shape_distance(f: Pointer, f_degree: int, g: Pointer, g_degree: int, channels: int, first: int, last: int, distance: Pointer, error: Pointer) -> int:
    """Computes the distance D_n(f, g) of the dissertation's section 3.3.3: the sum over the degrees from first to last of the squared
    differences of the norms; missing degrees count as zero. first = 0 is the dissertation's; with first = 1 the positions of the
    shapes have no effect. Errors: as obc_harmonics_degree_norms."""
    ...

def obc_harmonics_filter(coefficients: Pointer, degree: int, channels: int, low: int, high: int, width: int, keep_mean: int, error: Pointer) -> int:
    """Filters in place: keeps degrees from low to high and sets the others to zero, with a raised-cosine transition over `width` degrees
    outside each end (0: none). keep_mean 1 preserves degree 0, the position of a shape. Errors: as obc_harmonics_degree_norms."""
    ...

def obc_harmonics_rotate(coefficients: Pointer, degree: int, channels: int, rotation: Pointer, host: Pointer, turned: Pointer, error: Pointer) -> int:
    """Rotates the functions with the sphere: the value at v moves to R v. rotation: the matrix R by rows, 9 doubles. turned may be
    coefficients. The values are not rotated: for a rotation of a shape in space, multiply the three coefficients of each Y_lm by the
    matrix. O(degree^3). Errors: OBC_INVALID_ARGUMENT (also: not a rotation), OBC_CANCELLED, OBC_OUT_OF_MEMORY."""
    ...

def obc_harmonics_align_options_init(options: Pointer, struct_size: int) -> int:
    """Fill options with the defaults, and an alignment with zeros and its size."""
    ...

def obc_harmonics_alignment_init(alignment: Pointer, struct_size: int) -> int:
    """Fill options with the defaults, and an alignment with zeros and its size."""
    ...

def obc_harmonics_align(fixed: Pointer, fixed_degree: int, moving: Pointer, moving_degree: int, channels: int, options: Pointer, host: Pointer, alignment: Pointer, error: Pointer) -> int:
    """Computes the rotation that best aligns `moving` with `fixed`: it maximizes the sum over the channels of the integral of
    fixed(u) * (Q moving)(R^-1 u), without degree 0, by a search over a grid of all rotations (Kostelec and Rockmore 2008, "FFTs on the
    rotation group") and Newton's method up to the lower of the two degrees. options and host may be NULL.
    O(search_degree^4 + degree^3). Errors: OBC_INVALID_ARGUMENT, OBC_NO_VALID_RESULT (one of them is constant), OBC_CANCELLED,
    OBC_OUT_OF_MEMORY."""
    ...

def obc_harmonics_write(path: bytes | None, format: int, coefficients: Pointer, degree: int, channels: int, error: Pointer) -> int:
    """Writes coefficients to a file, which is complete or does not appear; reading it returns the same numbers to their last bits. Errors:
    OBC_INVALID_ARGUMENT, OBC_UNSUPPORTED (ending; channels other than 3 for SPHARM-PDM), OBC_IO, OBC_OUT_OF_MEMORY. The message starts
    with the path."""
    ...

def obc_harmonics_read(path: bytes | None, format: int, host: Pointer, coefficients: Pointer, error: Pointer) -> int:
    """Reads a file and checks all its contents. host may be NULL; its allocator must remain valid until _destroy. Errors:
    OBC_INVALID_ARGUMENT, OBC_MALFORMED_FILE (empty-file, bad-magic, parse, truncated, trailing-data, non-finite, with the line),
    OBC_UNSUPPORTED, OBC_IO, OBC_CANCELLED, OBC_OUT_OF_MEMORY. The message starts with the path."""
    ...

def obc_harmonics_coefficients_degree(coefficients: Pointer) -> int:
    """Return the degree and the number of channels; 0 for NULL."""
    ...

def obc_harmonics_coefficients_channels(coefficients: Pointer) -> int:
    """Return the degree and the number of channels; 0 for NULL."""
    ...

def obc_harmonics_coefficients_copy(coefficients: Pointer, values: Pointer, error: Pointer) -> int:
    """Copies the coefficients: (degree+1)^2 * channels doubles. Errors: OBC_INVALID_ARGUMENT."""
    ...

def obc_harmonics_coefficients_destroy(coefficients: Pointer) -> None:
    """Destroys coefficients; NULL is allowed."""
    ...

def obc_harmonics_version() -> int:
    """Returns the version of the library, major * 10000 + minor * 100 + patch."""
    ...
