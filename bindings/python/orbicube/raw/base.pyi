"""What <orbicube/base.h> declares. Written by scripts/bindings.py; not to be edited."""
from typing import Any

from .._library import Pointer, Struct

OBC_OK: int
OBC_INVALID_ARGUMENT: int
OBC_MALFORMED_FILE: int
OBC_NOT_CLOSED: int
OBC_NOT_MANIFOLD: int
OBC_WRONG_GENUS: int
OBC_DEGENERATE: int
OBC_OUT_OF_MEMORY: int
OBC_CANCELLED: int
OBC_IO: int
OBC_UNSUPPORTED: int
OBC_NO_VALID_RESULT: int
OBC_INTERNAL: int

obc_progress_function: Any

obc_log_function: Any

obc_parallel_for_function: Any

class obc_error(Struct):
    status: int
    kind: bytes
    message: bytes
    def __init__(self, status: int = ..., kind: bytes = ..., message: bytes = ...) -> None: ...

class obc_allocator(Struct):
    allocate: Any
    release: Any
    user: Any
    def __init__(self, allocate: Any = ..., release: Any = ..., user: Any = ...) -> None: ...

class obc_host(Struct):
    struct_size: int
    thread_count: int
    progress: Any
    progress_user: Any
    log: Any
    log_user: Any
    parallel_for: Any
    parallel_for_user: Any
    allocator: Any
    fraction: Any
    def __init__(self, struct_size: int = ..., thread_count: int = ..., progress: Any = ..., progress_user: Any = ..., log: Any = ..., log_user: Any = ..., parallel_for: Any = ..., parallel_for_user: Any = ..., allocator: Any = ..., fraction: Any = ...) -> None: ...

def obc_host_init(host: Pointer, struct_size: int) -> int:
    """Fills a host with the defaults. Errors: invalid argument (NULL, or a size that no version has)."""
    ...

def obc_status_name(status: int) -> bytes | None:
    """Returns a short English name of a status, such as "out of memory"; a static string, never NULL."""
    ...

def obc_base_version() -> int:
    """Returns the version of the library, major * 10000 + minor * 100 + patch."""
    ...
