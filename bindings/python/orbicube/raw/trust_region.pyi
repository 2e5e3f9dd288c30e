"""What <orbicube/trust_region.h> declares. Written by scripts/bindings.py; not to be edited."""
from typing import Any

from .._library import Pointer, Struct

OBC_TRUST_REGION_TWO_RADII: int
OBC_TRUST_REGION_SEED: int

OBC_TRUST_REGION_AUTOMATIC: int
OBC_TRUST_REGION_CHAIN: int
OBC_TRUST_REGION_CROSS: int

OBC_TRUST_REGION_NEED_VALUES: int
OBC_TRUST_REGION_ITERATION: int
OBC_TRUST_REGION_DONE: int

OBC_TRUST_REGION_RUNNING: int
OBC_TRUST_REGION_CONVERGED: int
OBC_TRUST_REGION_TARGET_REACHED: int
OBC_TRUST_REGION_EVALUATION_BUDGET: int
OBC_TRUST_REGION_NOISE_LIMIT: int
OBC_TRUST_REGION_STALLED: int
OBC_TRUST_REGION_CANCELLED: int
OBC_TRUST_REGION_EVALUATION_FAILED: int

OBC_TRUST_REGION_CONTINUE: int
OBC_TRUST_REGION_STOP: int
OBC_TRUST_REGION_FAILED: int

obc_trust_region_function: Any

class obc_trust_region_problem(Struct):
    struct_size: int
    n: int
    residuals: int
    lower: Any
    upper: Any
    scale: Any
    sign: Any
    def __init__(self, struct_size: int = ..., n: int = ..., residuals: int = ..., lower: Any = ..., upper: Any = ..., scale: Any = ..., sign: Any = ...) -> None: ...

class obc_trust_region_options(Struct):
    struct_size: int
    method: int
    start: int
    points: int
    radius_begin: float
    radius_end: float
    target: float
    noise_absolute: float
    noise_relative: float
    restarts: int
    max_evaluations: int
    def __init__(self, struct_size: int = ..., method: int = ..., start: int = ..., points: int = ..., radius_begin: float = ..., radius_end: float = ..., target: float = ..., noise_absolute: float = ..., noise_relative: float = ..., restarts: int = ..., max_evaluations: int = ...) -> None: ...

class obc_trust_region_result(Struct):
    struct_size: int
    stop: int
    value: float
    radius: float
    resolution: float
    evaluations: int
    failed_evaluations: int
    iterations: int
    restarts: int
    points: int
    rebuilds: int
    def __init__(self, struct_size: int = ..., stop: int = ..., value: float = ..., radius: float = ..., resolution: float = ..., evaluations: int = ..., failed_evaluations: int = ..., iterations: int = ..., restarts: int = ..., points: int = ..., rebuilds: int = ...) -> None: ...

def obc_trust_region_problem_init(problem: Pointer, struct_size: int) -> int:
    """An empty problem: n = 0, a scalar f, no bounds."""
    ...

def obc_trust_region_options_init(options: Pointer, struct_size: int) -> int:
    """The defaults, which the members' comments give."""
    ...

def obc_trust_region_create(problem: Pointer, options: Pointer, x0: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Makes a solver that starts at x0 (n entries, x0 / scale within 1e150), moved into the bounds. options and host may be NULL; what the host points at
    must stay valid until _destroy. Errors: invalid argument, out of memory."""
    ...

def obc_trust_region_give(solver: Pointer, points: Pointer, outputs: Pointer, count: int, error: Pointer) -> int:
    """Gives evaluations made before, `count` points (count x n, row by row, within the bounds) with their outputs (count, or
    count x m): before the first step. They do not count against max_evaluations. The run begins at the lowest of them
    instead of x0, and uses those near it in the place of evaluations of its own; of more than it can interpolate it keeps
    the lowest. Errors: invalid argument (also for an output that is not finite)."""
    ...

def obc_trust_region_step(solver: Pointer, points: Pointer, count: Pointer) -> int:
    """Goes on to the next request: NEED_VALUES, ITERATION or DONE, or a negative obc_status when the solver is NULL or on a
    defect. With NEED_VALUES, *points (may be NULL) is what is asked for: *count (may be NULL) rows of n entries, in the
    solver's memory until its next call other than _tell. Rows may be evaluated at the same time; there is one, but at the
    start of a CROSS. Until each is answered by _tell, and after DONE, the answer stays the same, less the rows told."""
    ...

def obc_trust_region_tell(solver: Pointer, outputs: Pointer, error: Pointer) -> int:
    """Answers NEED_VALUES at the first of the points asked for: f, or m residuals. Not finite, or outputs NULL: f cannot be
    evaluated there. Errors: invalid argument when nothing was asked."""
    ...

def obc_trust_region_get_result(solver: Pointer, result: Pointer, x: Pointer, outputs: Pointer, error: Pointer) -> int:
    """What is known now, at any time: result (or NULL), and the lowest point evaluated, x (n entries, or NULL) with its outputs (1
    or m, or NULL; NaN before the first value). Before the first value x is the start."""
    ...

def obc_trust_region_save_size(solver: Pointer) -> int:
    """A run as bytes, at any time between two calls: save_size gives their number, save writes them to blob (capacity at least
    that). load makes a solver from them that goes on with the same bits; the problem must be the one of the saved run, the
    options are those of the saved run. For machines of the same byte order. Errors: invalid argument (another problem),
    malformed file (damaged, or of another version)."""
    ...

def obc_trust_region_save(solver: Pointer, blob: Pointer, capacity: int, error: Pointer) -> int:
    """A run as bytes, at any time between two calls: save_size gives their number, save writes them to blob (capacity at least
    that). load makes a solver from them that goes on with the same bits; the problem must be the one of the saved run, the
    options are those of the saved run. For machines of the same byte order. Errors: invalid argument (another problem),
    malformed file (damaged, or of another version)."""
    ...

def obc_trust_region_load(problem: Pointer, blob: Pointer, size: int, host: Pointer, out: Pointer, error: Pointer) -> int:
    """A run as bytes, at any time between two calls: save_size gives their number, save writes them to blob (capacity at least
    that). load makes a solver from them that goes on with the same bits; the problem must be the one of the saved run, the
    options are those of the saved run. For machines of the same byte order. Errors: invalid argument (another problem),
    malformed file (damaged, or of another version)."""
    ...

def obc_trust_region_destroy(solver: Pointer) -> None:
    """Frees a solver; NULL is fine."""
    ...

def obc_trust_region_minimize(problem: Pointer, options: Pointer, f: Any, user: Pointer, x: Pointer, result: Pointer, host: Pointer, error: Pointer) -> int:
    """Runs to the end with a callback. x (n entries) is the start and receives the best point; result may be NULL. Errors:
    invalid argument, out of memory, cancelled (by the host; x and result are filled). How the run ended is result's stop."""
    ...

def obc_trust_region_stop_name(stop: int) -> bytes | None:
    """Short English name of an end, such as "converged". Never NULL; a static string."""
    ...

def obc_trust_region_version() -> int:
    """Version of this library, major * 10000 + minor * 100 + patch."""
    ...
