"""What <orbicube/projected_gradient.h> declares. Written by scripts/bindings.py; not to be edited."""
from typing import Any

from .._library import Pointer, Struct

OBC_PROJECTED_GRADIENT_FACE: int
OBC_PROJECTED_GRADIENT_SEED: int

OBC_PROJECTED_GRADIENT_LARGEST_OF_LAST: int
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

def obc_projected_gradient_problem_init(problem: Pointer, struct_size: int) -> int:
    """An empty problem: n = m = 0, no bounds."""
    ...

def obc_projected_gradient_options_init(options: Pointer, struct_size: int) -> int:
    """The defaults, which the members' comments give."""
    ...

def obc_projected_gradient_create(problem: Pointer, options: Pointer, x0: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Makes a solver that starts from the feasible point nearest to x0 (n entries). options and host may be NULL; what the
    host points at must stay valid until _destroy. Errors: invalid argument, out of memory. An empty feasible set is not an
    error here: the first step ends the run as INFEASIBLE."""
    ...

def obc_projected_gradient_step(solver: Pointer, x: Pointer) -> int:
    """Goes on to the next request: NEED_FG, ITERATION or DONE, or a negative obc_status when the solver is NULL or on a defect.
    *x (x may be NULL) is the point that is asked about, n entries of the solver's, valid until its next call. While a
    request waits for _tell, and after DONE, the answer stays the same."""
    ...

def obc_projected_gradient_tell(solver: Pointer, value: float, gradient: Pointer, error: Pointer) -> int:
    """Answers NEED_FG. A value or gradient entry that is not finite says that f cannot be evaluated there; gradient may be
    NULL then. Errors: invalid argument when nothing was asked."""
    ...

def obc_projected_gradient_get_result(solver: Pointer, result: Pointer, x: Pointer, error: Pointer) -> int:
    """What is known now, at any time: result (or NULL), and x (n entries, or NULL), which is the iterate that met the tolerance
    if the run CONVERGED, else the lowest feasible point evaluated, and before that the projected start."""
    ...

def obc_projected_gradient_multipliers(solver: Pointer, multipliers: Pointer, error: Pointer) -> int:
    """Multipliers t of the rows (m entries) at the current iterate: at a solution gradient - A't is zero where
    lower < x < upper, not negative at lower and not positive at upper."""
    ...

def obc_projected_gradient_certificate(solver: Pointer, certificate: Pointer, error: Pointer) -> int:
    """After INFEASIBLE: m numbers c with c'A x < c'b for every x within the bounds (Farkas), where entries of A'c that are
    rounding (1e-9 of the length of c) count as zero against an infinite bound. certificate_gap of the result is
    c'b - max c'A x > 0. Invalid argument after any other end."""
    ...

def obc_projected_gradient_save_size(solver: Pointer) -> int:
    """A run as bytes, at any time between two calls: save_size gives their number, save writes them to blob (capacity at least
    that). load makes a solver from them that goes on with the same bits; the problem must be the one of the saved run
    (a projection of the caller's is taken from it). The options are those of the saved run. For machines of the same byte
    order. Errors: invalid argument (another problem), malformed file (damaged, or of another version)."""
    ...

def obc_projected_gradient_save(solver: Pointer, blob: Pointer, capacity: int, error: Pointer) -> int:
    """A run as bytes, at any time between two calls: save_size gives their number, save writes them to blob (capacity at least
    that). load makes a solver from them that goes on with the same bits; the problem must be the one of the saved run
    (a projection of the caller's is taken from it). The options are those of the saved run. For machines of the same byte
    order. Errors: invalid argument (another problem), malformed file (damaged, or of another version)."""
    ...

def obc_projected_gradient_load(problem: Pointer, blob: Pointer, size: int, host: Pointer, out: Pointer, error: Pointer) -> int:
    """A run as bytes, at any time between two calls: save_size gives their number, save writes them to blob (capacity at least
    that). load makes a solver from them that goes on with the same bits; the problem must be the one of the saved run
    (a projection of the caller's is taken from it). The options are those of the saved run. For machines of the same byte
    order. Errors: invalid argument (another problem), malformed file (damaged, or of another version)."""
    ...

def obc_projected_gradient_destroy(solver: Pointer) -> None:
    """Releases a solver; NULL is fine."""
    ...

def obc_projected_gradient_minimize(problem: Pointer, options: Pointer, f: Any, user: Pointer, x: Pointer, result: Pointer, host: Pointer, error: Pointer) -> int:
    """The loop over step with a callback: x (n entries) holds the start and gets what _get_result hands out; result may be
    NULL. Answers OBC_OK however the run ended (result->stop), but OBC_CANCELLED when the host cancelled it; x and result
    are filled then as well."""
    ...

def obc_projected_gradient_project(problem: Pointer, y: Pointer, x: Pointer, multipliers: Pointer, result: Pointer, host: Pointer, error: Pointer) -> int:
    """The projection alone: x (n entries, not y) is the point of the feasible set nearest to y. Box: clipping. One row: a root
    of a monotone piecewise linear function (Dai and Fletcher 2006). More rows: semismooth Newton on the dual (Li, Sun, Toh
    2018). multipliers (m entries, or NULL) gets t with x = clip(y + A't), up to a last correction along the free unknowns
    where y is so large that t cannot resolve it. Of result (or NULL) stop, equality_residual, projection_passes and
    certificate_gap are filled: stop is CONVERGED, PROJECTION_FAILED, or INFEASIBLE, when multipliers gets the certificate."""
    ...

def obc_projected_gradient_stop_name(stop: int) -> bytes | None:
    """English name of a stop, such as "evaluation budget". Never NULL; a static string."""
    ...

def obc_projected_gradient_version() -> int:
    """Version of this library, major * 10000 + minor * 100 + patch."""
    ...
