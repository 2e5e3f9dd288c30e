"""What <orbicube/trust_region.h> declares. Written by scripts/bindings.py; not to be edited."""
from typing import Any

from .._library import Pointer, Struct

OBC_TRUST_REGION_TWO_RADII: int
OBC_TRUST_REGION_DISSERTATION: int

OBC_TRUST_REGION_AUTOMATIC: int
OBC_TRUST_REGION_CHAIN: int
OBC_TRUST_REGION_CROSS: int

OBC_TRUST_REGION_SUM_OF_SQUARES: int
OBC_TRUST_REGION_SUM_OF_MAGNITUDES: int
OBC_TRUST_REGION_MAX_MAGNITUDE: int
OBC_TRUST_REGION_MAX_VALUE: int

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
OBC_TRUST_REGION_RESOLUTION_LIMIT: int

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
    objective: int
    def __init__(self, struct_size: int = ..., n: int = ..., residuals: int = ..., lower: Any = ..., upper: Any = ..., scale: Any = ..., sign: Any = ..., objective: int = ...) -> None: ...

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
    """Fills a problem with n = 0, a scalar f and no bounds."""
    ...

def obc_trust_region_options_init(options: Pointer, struct_size: int) -> int:
    """Fills options with the defaults."""
    ...

def obc_trust_region_create(problem: Pointer, options: Pointer, x0: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Creates a solver that starts at x0 (n entries, x0 / scale within 1e150), moved into the bounds. options and host may be NULL;
    what the host points to must remain valid until _destroy. Errors: invalid argument, out of memory."""
    ...

def obc_trust_region_give(solver: Pointer, points: Pointer, outputs: Pointer, count: int, error: Pointer) -> int:
    """Supplies earlier evaluations before the first step: `count` points (count x n, row by row, within the bounds) with their outputs
    (count, or count x m). They do not count against max_evaluations. The run starts at the lowest of them in place of x0 and
    uses nearby ones in place of its own evaluations; of more points than it can interpolate it keeps the lowest.
    Errors: invalid argument (also for an output that is not finite), out of memory."""
    ...

def obc_trust_region_step(solver: Pointer, points: Pointer, count: Pointer) -> int:
    """Advances to the next request and returns it: NEED_VALUES, ITERATION or DONE, or a negative obc_status for NULL or after a
    defect. With NEED_VALUES, *points (points may be NULL) are *count (count may be NULL) rows of n entries in memory of the solver,
    valid until its next call other than _tell. The rows may be evaluated in parallel; there is one, except at the start of a
    CROSS. Until _tell has supplied all of them, and after DONE, the same request is returned, without the supplied rows."""
    ...

def obc_trust_region_tell(solver: Pointer, outputs: Pointer, error: Pointer) -> int:
    """Supplies f, or m residuals, at the first requested point. An entry that is not finite, or outputs NULL, means that f is
    undefined there. Errors: invalid argument if no request waits."""
    ...

def obc_trust_region_get_result(solver: Pointer, result: Pointer, x: Pointer, outputs: Pointer, error: Pointer) -> int:
    """Copies the current state at any time: result (or NULL), and the lowest evaluated point, x (n entries, or NULL), with its outputs
    (1 or m, or NULL; NaN before the first value). Before the first value x is the start. Errors: invalid argument."""
    ...

def obc_trust_region_save_size(solver: Pointer) -> int:
    """Save and restore a run between two calls. save_size returns the number of bytes, save writes them to blob, whose capacity is at
    least that. load creates a solver that continues with the same bits and the saved options; the problem must be that of the
    saved run. Both machines need the same byte order. Errors: invalid argument (another problem), malformed file (damaged,
    or of another version), out of memory."""
    ...

def obc_trust_region_save(solver: Pointer, blob: Pointer, capacity: int, error: Pointer) -> int:
    """Save and restore a run between two calls. save_size returns the number of bytes, save writes them to blob, whose capacity is at
    least that. load creates a solver that continues with the same bits and the saved options; the problem must be that of the
    saved run. Both machines need the same byte order. Errors: invalid argument (another problem), malformed file (damaged,
    or of another version), out of memory."""
    ...

def obc_trust_region_load(problem: Pointer, blob: Pointer, size: int, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Save and restore a run between two calls. save_size returns the number of bytes, save writes them to blob, whose capacity is at
    least that. load creates a solver that continues with the same bits and the saved options; the problem must be that of the
    saved run. Both machines need the same byte order. Errors: invalid argument (another problem), malformed file (damaged,
    or of another version), out of memory."""
    ...

def obc_trust_region_destroy(solver: Pointer) -> None:
    """Destroys a solver; NULL is allowed."""
    ...

def obc_trust_region_minimize(problem: Pointer, options: Pointer, f: Any, user: Pointer, x: Pointer, result: Pointer, host: Pointer, error: Pointer) -> int:
    """Runs to the end with a callback. x (n entries) is the start and receives the best point; result may be NULL. Returns OBC_OK
    however the run ended (see result->stop), except OBC_CANCELLED where the host cancelled it; x and result are filled in that case
    too. Errors: invalid argument, out of memory, cancelled."""
    ...

def obc_trust_region_stop_name(stop: int) -> bytes | None:
    """Returns the English name of a stop code, such as "converged"; a static string, never NULL."""
    ...

def obc_trust_region_version() -> int:
    """Returns the version of the library, major * 10000 + minor * 100 + patch."""
    ...
