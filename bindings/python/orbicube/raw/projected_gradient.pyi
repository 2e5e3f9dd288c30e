"""What <orbicube/projected_gradient.h> declares. Written by scripts/bindings.py; not to be edited."""
from typing import Any

from .._library import Pointer, Struct

OBC_PROJECTED_GRADIENT_FACE: int
OBC_PROJECTED_GRADIENT_DISSERTATION: int

OBC_PROJECTED_GRADIENT_MAX_OF_LAST: int
OBC_PROJECTED_GRADIENT_AVERAGE: int

OBC_PROJECTED_GRADIENT_NEED_FG: int
OBC_PROJECTED_GRADIENT_ITERATION: int
OBC_PROJECTED_GRADIENT_DONE: int

OBC_PROJECTED_GRADIENT_RUNNING: int
OBC_PROJECTED_GRADIENT_CONVERGED: int
OBC_PROJECTED_GRADIENT_TARGET_REACHED: int
OBC_PROJECTED_GRADIENT_EVALUATION_BUDGET: int
OBC_PROJECTED_GRADIENT_ITERATION_BUDGET: int
OBC_PROJECTED_GRADIENT_STALLED: int
OBC_PROJECTED_GRADIENT_INFEASIBLE: int
OBC_PROJECTED_GRADIENT_CANCELLED: int
OBC_PROJECTED_GRADIENT_EVALUATION_FAILED: int
OBC_PROJECTED_GRADIENT_PROJECTION_FAILED: int
OBC_PROJECTED_GRADIENT_UNBOUNDED: int

OBC_PROJECTED_GRADIENT_CONTINUE: int
OBC_PROJECTED_GRADIENT_STOP: int
OBC_PROJECTED_GRADIENT_FAILED: int

obc_projected_gradient_function: Any

obc_projected_gradient_projection: Any

class obc_projected_gradient_problem(Struct):
    struct_size: int
    n: int
    m: int
    lower: Any
    upper: Any
    row_start: Any
    column: Any
    value: Any
    b: Any
    project: Any
    project_user: Any
    def __init__(self, struct_size: int = ..., n: int = ..., m: int = ..., lower: Any = ..., upper: Any = ..., row_start: Any = ..., column: Any = ..., value: Any = ..., b: Any = ..., project: Any = ..., project_user: Any = ...) -> None: ...

class obc_projected_gradient_options(Struct):
    struct_size: int
    method: int
    line_search: int
    memory: int
    history: int
    average_weight: float
    gradient_tolerance: float
    target: float
    max_evaluations: int
    max_iterations: int
    def __init__(self, struct_size: int = ..., method: int = ..., line_search: int = ..., memory: int = ..., history: int = ..., average_weight: float = ..., gradient_tolerance: float = ..., target: float = ..., max_evaluations: int = ..., max_iterations: int = ...) -> None: ...

class obc_projected_gradient_result(Struct):
    struct_size: int
    stop: int
    value: float
    projected_gradient: float
    equality_residual: float
    evaluations: int
    failed_evaluations: int
    iterations: int
    projection_passes: int
    certificate_gap: float
    def __init__(self, struct_size: int = ..., stop: int = ..., value: float = ..., projected_gradient: float = ..., equality_residual: float = ..., evaluations: int = ..., failed_evaluations: int = ..., iterations: int = ..., projection_passes: int = ..., certificate_gap: float = ...) -> None: ...

class obc_projected_gradient_check(Struct):
    struct_size: int
    agrees: int
    worst: int
    told: float
    difference: float
    error: float
    uncertainty: float
    compared: int
    evaluations: int
    def __init__(self, struct_size: int = ..., agrees: int = ..., worst: int = ..., told: float = ..., difference: float = ..., error: float = ..., uncertainty: float = ..., compared: int = ..., evaluations: int = ...) -> None: ...

def obc_projected_gradient_problem_init(problem: Pointer, struct_size: int) -> int:
    """Fills a problem with n = m = 0 and no bounds."""
    ...

def obc_projected_gradient_options_init(options: Pointer, struct_size: int) -> int:
    """Fills options with the defaults."""
    ...

def obc_projected_gradient_create(problem: Pointer, options: Pointer, x0: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Creates a solver that starts from the feasible point nearest to x0 (n entries). options and host may be NULL; what the
    host points to must remain valid until _destroy. An empty feasible set ends the run as INFEASIBLE at the first step.
    Errors: invalid argument, out of memory."""
    ...

def obc_projected_gradient_step(solver: Pointer, x: Pointer) -> int:
    """Advances to the next request and returns it: NEED_FG, ITERATION or DONE, or a negative obc_status for NULL or after a defect. *x
    (x may be NULL) is the point of the request, n entries in memory of the solver, valid until its next call. While a request
    waits for _tell, and after DONE, the same request is returned."""
    ...

def obc_projected_gradient_tell(solver: Pointer, value: float, gradient: Pointer, error: Pointer) -> int:
    """Supplies value and gradient for NEED_FG. An entry that is not finite means that f is undefined there; gradient may then be
    NULL. Errors: invalid argument if no request waits."""
    ...

def obc_projected_gradient_get_result(solver: Pointer, result: Pointer, x: Pointer, error: Pointer) -> int:
    """Copies the current state at any time: result (or NULL), and x (n entries, or NULL). x is the iterate that satisfies the tolerance
    if the run CONVERGED, otherwise the lowest feasible point evaluated, and before the first value the projected start.
    Errors: invalid argument."""
    ...

def obc_projected_gradient_multipliers(solver: Pointer, multipliers: Pointer, error: Pointer) -> int:
    """Copies the Lagrange multipliers t of the rows (m entries) at the current iterate. At a solution gradient - A't is zero where
    lower < x < upper, nonnegative at lower and nonpositive at upper. Errors: invalid argument."""
    ...

def obc_projected_gradient_certificate(solver: Pointer, certificate: Pointer, error: Pointer) -> int:
    """Copies a certificate of infeasibility (Farkas) after INFEASIBLE: m numbers c with c'A x < c'b for every x within the bounds, where
    entries of A'c below 1e-9 |c| count as zero against an infinite bound. certificate_gap of the result is c'b - max c'A x > 0.
    Errors: invalid argument after any other end."""
    ...

def obc_projected_gradient_save_size(solver: Pointer) -> int:
    """Save and restore a run between two calls. save_size returns the number of bytes, save writes them to blob, whose capacity is at
    least that. load creates a solver that continues with the same bits and the saved options. The problem must be that of the
    saved run; a projection of the caller is taken from it. Both machines need the same byte order.
    Errors: invalid argument (another problem), malformed file (damaged, or of another version), out of memory."""
    ...

def obc_projected_gradient_save(solver: Pointer, blob: Pointer, capacity: int, error: Pointer) -> int:
    """Save and restore a run between two calls. save_size returns the number of bytes, save writes them to blob, whose capacity is at
    least that. load creates a solver that continues with the same bits and the saved options. The problem must be that of the
    saved run; a projection of the caller is taken from it. Both machines need the same byte order.
    Errors: invalid argument (another problem), malformed file (damaged, or of another version), out of memory."""
    ...

def obc_projected_gradient_load(problem: Pointer, blob: Pointer, size: int, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Save and restore a run between two calls. save_size returns the number of bytes, save writes them to blob, whose capacity is at
    least that. load creates a solver that continues with the same bits and the saved options. The problem must be that of the
    saved run; a projection of the caller is taken from it. Both machines need the same byte order.
    Errors: invalid argument (another problem), malformed file (damaged, or of another version), out of memory."""
    ...

def obc_projected_gradient_destroy(solver: Pointer) -> None:
    """Destroys a solver; NULL is allowed."""
    ...

def obc_projected_gradient_minimize(problem: Pointer, options: Pointer, f: Any, user: Pointer, x: Pointer, result: Pointer, host: Pointer, error: Pointer) -> int:
    """Runs to the end with a callback. x (n entries) is the start and receives the point of _get_result; result may be NULL.
    Returns OBC_OK however the run ended (see result->stop), except OBC_CANCELLED where the host cancelled it; x and result
    are filled in that case too. Errors: invalid argument, out of memory, cancelled."""
    ...

def obc_projected_gradient_project(problem: Pointer, y: Pointer, x: Pointer, multipliers: Pointer, result: Pointer, host: Pointer, error: Pointer) -> int:
    """Computes the point x (n entries, not y) of the feasible set nearest to y. Bounds: clipping. One row: the root of a monotone
    piecewise linear function (Dai and Fletcher 2006). More rows: semismooth Newton on the dual (Li, Sun, Toh 2018).
    multipliers (m entries, or NULL) receives t with x = clip(y + A't), up to a last correction along the free unknowns
    where y is too large for t to resolve it. result (or NULL) receives equality_residual, projection_passes, certificate_gap and
    stop: CONVERGED, PROJECTION_FAILED, or INFEASIBLE, for which multipliers receives the certificate.
    Errors: invalid argument, out of memory, cancelled."""
    ...

def obc_projected_gradient_check_gradient(problem: Pointer, f: Any, user: Pointer, x: Pointer, check: Pointer, host: Pointer, error: Pointer) -> int:
    """Compares the gradient that f returns at x (n entries, moved into the bounds) with differences of its values along each axis,
    within the bounds and without regard to rows. Use it after a run that ended as STALLED. Errors: invalid argument (also: f has
    no value or gradient at x), cancelled (by the host or by STOP)."""
    ...

def obc_projected_gradient_stop_name(stop: int) -> bytes | None:
    """Returns the English name of a stop code, such as "evaluation budget"; a static string, never NULL."""
    ...

def obc_projected_gradient_version() -> int:
    """Returns the version of the library, major * 10000 + minor * 100 + patch."""
    ...
