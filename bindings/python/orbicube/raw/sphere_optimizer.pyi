"""What <orbicube/sphere_optimizer.h> declares. Written by scripts/bindings.py; not to be edited."""
from typing import Any

from .._library import Pointer, Struct

OBC_SPHERE_OPTIMIZER_LIMITED_MEMORY: int
OBC_SPHERE_OPTIMIZER_BARZILAI_BORWEIN: int
OBC_SPHERE_OPTIMIZER_GREAT_CIRCLE: int
OBC_SPHERE_OPTIMIZER_DISSERTATION: int
OBC_SPHERE_OPTIMIZER_TRUNCATED_NEWTON: int

OBC_SPHERE_OPTIMIZER_NEED_FG: int
OBC_SPHERE_OPTIMIZER_ITERATION: int
OBC_SPHERE_OPTIMIZER_DONE: int
OBC_SPHERE_OPTIMIZER_NEED_PRODUCT: int

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

obc_sphere_optimizer_product_function: Any

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
    starts: int
    seed: int
    hessian_products: int
    def __init__(self, struct_size: int = ..., method: int = ..., memory: int = ..., history: int = ..., gradient_tolerance: float = ..., target: float = ..., max_evaluations: int = ..., max_iterations: int = ..., starts: int = ..., seed: int = ..., hessian_products: int = ...) -> None: ...

class obc_sphere_optimizer_result(Struct):
    struct_size: int
    stop: int
    value: float
    gradient_norm: float
    evaluations: int
    failed_evaluations: int
    iterations: int
    starts: int
    best_start: int
    products: int
    def __init__(self, struct_size: int = ..., stop: int = ..., value: float = ..., gradient_norm: float = ..., evaluations: int = ..., failed_evaluations: int = ..., iterations: int = ..., starts: int = ..., best_start: int = ..., products: int = ...) -> None: ...

class obc_sphere_optimizer_blocks(Struct):
    struct_size: int
    dimension: int
    count: int
    neighbor_start: Any
    neighbor: Any
    def __init__(self, struct_size: int = ..., dimension: int = ..., count: int = ..., neighbor_start: Any = ..., neighbor: Any = ...) -> None: ...

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
    """Fills options with the defaults."""
    ...

def obc_sphere_optimizer_create(count: int, dimension: int, options: Pointer, x0: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Creates a solver over count >= 1 spheres in dimension >= 2 that starts from x0 (count * dimension numbers, each block scaled to
    length 1). options and host may be NULL; what the host points to must remain valid until _destroy. Errors: invalid argument
    (also a zero block of x0), out of memory."""
    ...

def obc_sphere_optimizer_step(solver: Pointer, x: Pointer) -> int:
    """Advances to the next request and returns it: NEED_FG, ITERATION or DONE, or a negative obc_status for NULL or after a defect. *x
    (x may be NULL) is the point of the request, in memory of the solver, valid until its next call. While a request waits for
    _tell, and after DONE, the same request is returned. Does not allocate."""
    ...

def obc_sphere_optimizer_tell(solver: Pointer, value: float, gradient: Pointer, error: Pointer) -> int:
    """Supplies value and gradient for NEED_FG. An entry that is not finite means that f is undefined there; gradient may then be
    NULL. Errors: invalid argument if no request waits."""
    ...

def obc_sphere_optimizer_get_direction(solver: Pointer, direction: Pointer, error: Pointer) -> int:
    """Hands out the direction of a request NEED_PRODUCT, count * dimension numbers in memory of the solver, valid until its next call.
    Errors: invalid argument if no product is requested."""
    ...

def obc_sphere_optimizer_tell_product(solver: Pointer, product: Pointer, error: Pointer) -> int:
    """Supplies the product of the Hessian and the direction, count * dimension numbers, for NEED_PRODUCT. NULL, or an entry that is not finite,
    means that there is none at this point. Errors: invalid argument if no product is requested."""
    ...

def obc_sphere_optimizer_get_result(solver: Pointer, result: Pointer, x: Pointer, error: Pointer) -> int:
    """Copies the current state at any time: result (or NULL), and x (or NULL). x is the iterate that satisfies the tolerance if the
    run CONVERGED, otherwise the lowest point evaluated, and before the first value the start. Errors: invalid argument."""
    ...

def obc_sphere_optimizer_get_shape(solver: Pointer, count: Pointer, dimension: Pointer, error: Pointer) -> int:
    """Returns the number of spheres and their dimension, for runs that _load created; count and dimension may be NULL.
    Errors: invalid argument."""
    ...

def obc_sphere_optimizer_save_size(solver: Pointer) -> int:
    """Save and restore a run between two calls. save_size returns the number of bytes, save writes them to blob, whose capacity is at
    least that. load creates a solver that continues with the same bits and the saved options. Both machines need the same
    byte order. Errors: invalid argument, malformed file (damaged, or of another version), out of memory."""
    ...

def obc_sphere_optimizer_save(solver: Pointer, blob: Pointer, capacity: int, error: Pointer) -> int:
    """Save and restore a run between two calls. save_size returns the number of bytes, save writes them to blob, whose capacity is at
    least that. load creates a solver that continues with the same bits and the saved options. Both machines need the same
    byte order. Errors: invalid argument, malformed file (damaged, or of another version), out of memory."""
    ...

def obc_sphere_optimizer_load(blob: Pointer, size: int, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Save and restore a run between two calls. save_size returns the number of bytes, save writes them to blob, whose capacity is at
    least that. load creates a solver that continues with the same bits and the saved options. Both machines need the same
    byte order. Errors: invalid argument, malformed file (damaged, or of another version), out of memory."""
    ...

def obc_sphere_optimizer_destroy(solver: Pointer) -> None:
    """Destroys a solver; NULL is allowed."""
    ...

def obc_sphere_optimizer_minimize(count: int, dimension: int, options: Pointer, f: Any, user: Pointer, x: Pointer, result: Pointer, host: Pointer, error: Pointer) -> int:
    """Runs to the end with a callback. x is the start and receives the point of _get_result; result may be NULL. Returns OBC_OK
    however the run ended (see result->stop), except OBC_CANCELLED where the host cancelled it; x and result are filled in that case
    too. Errors: invalid argument, out of memory, cancelled."""
    ...

def obc_sphere_optimizer_minimize_second_order(count: int, dimension: int, options: Pointer, f: Any, product: Any, user: Pointer, x: Pointer, result: Pointer, host: Pointer, error: Pointer) -> int:
    """The same with TRUNCATED_NEWTON and products of the Hessian from a callback, whatever options->method and hessian_products are."""
    ...

def obc_sphere_optimizer_blocks_init(blocks: Pointer, struct_size: int) -> int:
    """Fill blocks with no blocks, and options with the defaults."""
    ...

def obc_sphere_optimizer_relaxation_options_init(options: Pointer, struct_size: int) -> int:
    """Fill blocks with no blocks, and options with the defaults."""
    ...

def obc_sphere_optimizer_relax(blocks: Pointer, options: Pointer, f: Any, user: Pointer, x: Pointer, result: Pointer, host: Pointer, error: Pointer) -> int:
    """Lowers f block by block. x (count * dimension numbers) is the start, scaled to length 1, and receives the end. options, host and
    result may be NULL. Returns OBC_OK however it ended (see result->stop), except OBC_CANCELLED where the host cancelled it; x and
    result are filled in that case too. Errors: invalid argument (also a neighbor out of range), out of memory, cancelled."""
    ...

def obc_sphere_optimizer_relaxation_create(blocks: Pointer, options: Pointer, x0: Pointer, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Creates a relaxation that runs in parts. Copies blocks and x0 (scaled to length 1); what the host points to must remain valid until
    _destroy. Errors: invalid argument, out of memory."""
    ...

def obc_sphere_optimizer_relaxation_run(relaxation: Pointer, f: Any, user: Pointer, steps: int, error: Pointer) -> int:
    """Relaxes up to `steps` more blocks without an allocation, and measures the gradients at the end of the relaxation. Returns OBC_OK
    however it ended; stop is RUNNING where steps remain, CANCELLED where f returned STOP. After an interruption, also by the
    host (OBC_CANCELLED), the current step is undone, and the next _run continues with the same bits as without the
    interruption. Errors: invalid argument, cancelled."""
    ...

def obc_sphere_optimizer_relaxation_get_result(relaxation: Pointer, result: Pointer, x: Pointer, error: Pointer) -> int:
    """Copies the current state: result (or NULL) and x (count * dimension numbers, or NULL). Errors: invalid argument."""
    ...

def obc_sphere_optimizer_relaxation_save_size(relaxation: Pointer) -> int:
    """Save and restore a relaxation between two calls, like an all-at-once run. load takes the blocks of the saved relaxation (invalid
    argument for others) and keeps its options."""
    ...

def obc_sphere_optimizer_relaxation_save(relaxation: Pointer, blob: Pointer, capacity: int, error: Pointer) -> int:
    """Save and restore a relaxation between two calls, like an all-at-once run. load takes the blocks of the saved relaxation (invalid
    argument for others) and keeps its options."""
    ...

def obc_sphere_optimizer_relaxation_load(blocks: Pointer, blob: Pointer, size: int, host: Pointer, out: Pointer, error: Pointer) -> int:
    """Save and restore a relaxation between two calls, like an all-at-once run. load takes the blocks of the saved relaxation (invalid
    argument for others) and keeps its options."""
    ...

def obc_sphere_optimizer_relaxation_destroy(relaxation: Pointer) -> None:
    """Destroys a relaxation; NULL is allowed."""
    ...

def obc_sphere_optimizer_stop_name(stop: int) -> bytes | None:
    """Returns the English name of a stop code, such as "evaluation budget"; a static string, never NULL."""
    ...

def obc_sphere_optimizer_version() -> int:
    """Returns the version of the library, major * 10000 + minor * 100 + patch."""
    ...
