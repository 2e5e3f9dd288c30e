"""What <orbicube/sphere_optimizer.h> declares. Written by scripts/bindings.py; not to be edited."""
from typing import Any

from .._library import Pointer, Struct

OBC_SPHERE_OPTIMIZER_LIMITED_MEMORY: int
OBC_SPHERE_OPTIMIZER_BARZILAI_BORWEIN: int
OBC_SPHERE_OPTIMIZER_GREAT_CIRCLE: int
OBC_SPHERE_OPTIMIZER_SEED: int

OBC_SPHERE_OPTIMIZER_NEED_FG: int
OBC_SPHERE_OPTIMIZER_ITERATION: int
OBC_SPHERE_OPTIMIZER_DONE: int

OBC_SPHERE_OPTIMIZER_RUNNING: int
OBC_SPHERE_OPTIMIZER_CONVERGED: int
OBC_SPHERE_OPTIMIZER_TARGET_REACHED: int
OBC_SPHERE_OPTIMIZER_EVALUATION_BUDGET: int
OBC_SPHERE_OPTIMIZER_ITERATION_BUDGET: int
OBC_SPHERE_OPTIMIZER_STALLED: int
OBC_SPHERE_OPTIMIZER_CANCELLED: int
OBC_SPHERE_OPTIMIZER_EVALUATION_FAILED: int

OBC_SPHERE_OPTIMIZER_CONTINUE: int
OBC_SPHERE_OPTIMIZER_STOP: int
OBC_SPHERE_OPTIMIZER_FAILED: int

OBC_SPHERE_OPTIMIZER_AUTOMATIC: int
OBC_SPHERE_OPTIMIZER_QUEUE: int
OBC_SPHERE_OPTIMIZER_SWEEPS: int

obc_sphere_optimizer_function: Any

obc_sphere_optimizer_block_function: Any

class obc_sphere_optimizer_options(Struct):
    struct_size: int
    method: int
    memory: int
    history: int
    gradient_tolerance: float
    target: float
    max_evaluations: int
    max_iterations: int
    def __init__(self, struct_size: int = ..., method: int = ..., memory: int = ..., history: int = ..., gradient_tolerance: float = ..., target: float = ..., max_evaluations: int = ..., max_iterations: int = ...) -> None: ...

class obc_sphere_optimizer_result(Struct):
    struct_size: int
    stop: int
    value: float
    gradient_norm: float
    evaluations: int
    failed_evaluations: int
    iterations: int
    def __init__(self, struct_size: int = ..., stop: int = ..., value: float = ..., gradient_norm: float = ..., evaluations: int = ..., failed_evaluations: int = ..., iterations: int = ...) -> None: ...

class obc_sphere_optimizer_blocks(Struct):
    struct_size: int
    dimension: int
    count: int
    neighbour_start: Any
    neighbour: Any
    def __init__(self, struct_size: int = ..., dimension: int = ..., count: int = ..., neighbour_start: Any = ..., neighbour: Any = ...) -> None: ...

class obc_sphere_optimizer_relaxation_options(Struct):
    struct_size: int
    method: int
    second_order: int
    order: int
    gradient_tolerance: float
    relative_gain: float
    over_relaxation: float
    max_passes: int
    def __init__(self, struct_size: int = ..., method: int = ..., second_order: int = ..., order: int = ..., gradient_tolerance: float = ..., relative_gain: float = ..., over_relaxation: float = ..., max_passes: int = ...) -> None: ...

class obc_sphere_optimizer_relaxation_result(Struct):
    struct_size: int
    stop: int
    gain: float
    gradient_norm: float
    steps: int
    evaluations: int
    failed_steps: int
    over_relaxation: float
    def __init__(self, struct_size: int = ..., stop: int = ..., gain: float = ..., gradient_norm: float = ..., steps: int = ..., evaluations: int = ..., failed_steps: int = ..., over_relaxation: float = ...) -> None: ...

def obc_sphere_optimizer_options_init(options: Pointer, struct_size: int) -> int:
    """The defaults, which the members' comments give."""
    ...

def obc_sphere_optimizer_create(count: int, dimension: int, options: Pointer, x0: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Makes a solver over count >= 1 spheres in dimension >= 2 that starts from x0 (count * dimension numbers, each block scaled
    to length 1). options and host may be NULL; what the host points at must stay valid until _destroy. Errors: invalid
    argument (also a block of x0 that is zero), out of memory."""
    ...

def obc_sphere_optimizer_step(solver: Pointer, x: Pointer) -> int:
    """Goes on to the next request: NEED_FG, ITERATION or DONE, or a negative obc_status when the solver is NULL or on a defect.
    *x (x may be NULL) is the point that is asked about, the solver's, valid until its next call. While a request waits for
    _tell, and after DONE, the answer stays the same. Does not allocate."""
    ...

def obc_sphere_optimizer_tell(solver: Pointer, value: float, gradient: Pointer, error: Pointer) -> int:
    """Answers NEED_FG. A value or gradient entry that is not finite says that f cannot be evaluated there; gradient may be NULL
    then. Errors: invalid argument when nothing was asked."""
    ...

def obc_sphere_optimizer_get_result(solver: Pointer, result: Pointer, x: Pointer, error: Pointer) -> int:
    """What is known now, at any time: result (or NULL), and x (or NULL), which is the iterate that met the tolerance if the run
    CONVERGED, else the lowest point evaluated, and before that the start."""
    ...

def obc_sphere_optimizer_get_shape(solver: Pointer, count: Pointer, dimension: Pointer, error: Pointer) -> int:
    """How many spheres, and of how many numbers each; each of count and dimension may be NULL. For runs that come from _load."""
    ...

def obc_sphere_optimizer_save_size(solver: Pointer) -> int:
    """A run as bytes, at any time between two calls: save_size gives their number, save writes them to blob (capacity at least
    that). load makes a solver from them that goes on with the same bits, with the options of the saved run. For machines of
    the same byte order. Errors: invalid argument, malformed file (damaged, or of another version)."""
    ...

def obc_sphere_optimizer_save(solver: Pointer, blob: Pointer, capacity: int, error: Pointer) -> int:
    """A run as bytes, at any time between two calls: save_size gives their number, save writes them to blob (capacity at least
    that). load makes a solver from them that goes on with the same bits, with the options of the saved run. For machines of
    the same byte order. Errors: invalid argument, malformed file (damaged, or of another version)."""
    ...

def obc_sphere_optimizer_load(blob: Pointer, size: int, host: Pointer, out: Pointer, error: Pointer) -> int:
    """A run as bytes, at any time between two calls: save_size gives their number, save writes them to blob (capacity at least
    that). load makes a solver from them that goes on with the same bits, with the options of the saved run. For machines of
    the same byte order. Errors: invalid argument, malformed file (damaged, or of another version)."""
    ...

def obc_sphere_optimizer_destroy(solver: Pointer) -> None:
    """Releases a solver; NULL is fine."""
    ...

def obc_sphere_optimizer_minimize(count: int, dimension: int, options: Pointer, f: Any, user: Pointer, x: Pointer, result: Pointer, host: Pointer, error: Pointer) -> int:
    """The loop over step with a callback: x holds the start and gets what _get_result hands out; result may be NULL. Answers
    OBC_OK however the run ended (result->stop), but OBC_CANCELLED when the host cancelled it; x and result are filled then
    as well."""
    ...

def obc_sphere_optimizer_blocks_init(blocks: Pointer, struct_size: int) -> int:
    """Empty: no blocks. And the defaults, which the members' comments give."""
    ...

def obc_sphere_optimizer_relaxation_options_init(options: Pointer, struct_size: int) -> int:
    """Empty: no blocks. And the defaults, which the members' comments give."""
    ...

def obc_sphere_optimizer_relax(blocks: Pointer, options: Pointer, f: Any, user: Pointer, x: Pointer, result: Pointer, host: Pointer, error: Pointer) -> int:
    """Lowers f block by block: x (count * dimension numbers) holds the start, scaled to length 1, and gets the end. options, host
    and result may be NULL. Answers OBC_OK however it ended (result->stop), but OBC_CANCELLED when the host cancelled it; x and
    result are filled then as well. Errors: invalid argument (also a neighbour out of range), out of memory."""
    ...

def obc_sphere_optimizer_relaxation_create(blocks: Pointer, options: Pointer, x0: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """The same in parts: _create copies blocks and x0 (scaled to length 1); what the host points at must stay valid until
    _destroy."""
    ...

def obc_sphere_optimizer_relaxation_run(relaxation: Pointer, f: Any, user: Pointer, steps: int, error: Pointer) -> int:
    """At most `steps` more steps of one block each, without an allocation; at the end of the relaxation its gradients are
    measured. Answers OBC_OK however it ended; stop is RUNNING when steps are left to do, CANCELLED when f answered STOP.
    OBC_CANCELLED: the host cancelled. However it was broken off, the step under way is as if it had not begun, and the next
    _run goes on with the same bits as without the break."""
    ...

def obc_sphere_optimizer_relaxation_get_result(relaxation: Pointer, result: Pointer, x: Pointer, error: Pointer) -> int:
    """What is known now: result (or NULL) and x (count * dimension numbers, or NULL)."""
    ...

def obc_sphere_optimizer_relaxation_save_size(relaxation: Pointer) -> int:
    """The relaxation as bytes between two calls, like a run of the all-at-once solver. load takes the blocks of the saved one
    again (invalid argument if they are others), with the options of the saved one."""
    ...

def obc_sphere_optimizer_relaxation_save(relaxation: Pointer, blob: Pointer, capacity: int, error: Pointer) -> int:
    """The relaxation as bytes between two calls, like a run of the all-at-once solver. load takes the blocks of the saved one
    again (invalid argument if they are others), with the options of the saved one."""
    ...

def obc_sphere_optimizer_relaxation_load(blocks: Pointer, blob: Pointer, size: int, host: Pointer, out: Pointer, error: Pointer) -> int:
    """The relaxation as bytes between two calls, like a run of the all-at-once solver. load takes the blocks of the saved one
    again (invalid argument if they are others), with the options of the saved one."""
    ...

def obc_sphere_optimizer_relaxation_destroy(relaxation: Pointer) -> None:
    """Releases a relaxation; NULL is fine."""
    ...

def obc_sphere_optimizer_stop_name(stop: int) -> bytes | None:
    """English name of a stop, such as "evaluation budget". Never NULL; a static string."""
    ...

def obc_sphere_optimizer_version() -> int:
    """Version of this library, major * 10000 + minor * 100 + patch."""
    ...
