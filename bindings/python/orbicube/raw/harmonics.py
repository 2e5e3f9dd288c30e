"""What <orbicube/harmonics.h> declares. Written by scripts/bindings.py; not to be edited."""
import ctypes as _c

from .._library import bind as _bind
from .._library import Struct as _Struct

OBC_HARMONICS_AUTOMATIC = 0
OBC_HARMONICS_DENSE = 1
OBC_HARMONICS_ITERATIVE = 2

OBC_HARMONICS_BY_ENDING = 0
OBC_HARMONICS_SHTOOLS = 1
OBC_HARMONICS_SPHARM_PDM = 2


class obc_harmonics_fit_options(_Struct):
    """Options of a fit. Fill with _init."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("degree", _c.c_uint32),
        ("method", _c.c_int32),
        ("reserved", _c.c_int32),
        ("regularization", _c.c_double),
    ]


class obc_harmonics_fit_report(_Struct):
    """Figures of a fit."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("method", _c.c_int32),
        ("unknowns", _c.c_uint64),
        ("rank", _c.c_uint64),
        ("condition", _c.c_double),
        ("residual", _c.c_double),
        ("iterations", _c.c_uint64),
    ]


class obc_harmonics_refinement_report(_Struct):
    """Figures of a refinement of a map."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("rounds", _c.c_uint32),
        ("residual_before", _c.c_double),
        ("residual", _c.c_double),
    ]


class obc_harmonics_align_options(_Struct):
    """Options of an alignment. Fill with _init."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("turn_values", _c.c_int32),
        ("search_degree", _c.c_uint32),
        ("reserved", _c.c_uint32),
    ]


class obc_harmonics_alignment(_Struct):
    """Result of an alignment."""
    _fields_ = [
        ("struct_size", _c.c_uint32),
        ("reserved", _c.c_uint32),
        ("rotation", _c.c_double * 9),
        ("values", _c.c_double * 9),
        ("correlation", _c.c_double),
    ]


_functions = [
    ("obc_harmonics_fit_options_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_harmonics_fit_report_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_harmonics_refinement_report_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_harmonics_size", _c.c_size_t, [_c.c_uint32]),
    ("obc_harmonics_evaluate", _c.c_int32, [_c.c_void_p, _c.c_size_t, _c.c_uint32, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_harmonics_fit", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_size_t, _c.c_size_t, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_harmonics_refine_map", _c.c_int32, [_c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_void_p, _c.c_uint32, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_harmonics_synthesize", _c.c_int32, [_c.c_void_p, _c.c_uint32, _c.c_size_t, _c.c_void_p, _c.c_size_t, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_harmonics_analyze", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_size_t, _c.c_size_t, _c.c_uint32, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_harmonics_degree_norms", _c.c_int32, [_c.c_void_p, _c.c_uint32, _c.c_size_t, _c.c_void_p, _c.c_void_p]),
    ("obc_harmonics_shape_distance", _c.c_int32, [_c.c_void_p, _c.c_uint32, _c.c_void_p, _c.c_uint32, _c.c_size_t, _c.c_uint32, _c.c_uint32, _c.c_void_p, _c.c_void_p]),
    ("obc_harmonics_filter", _c.c_int32, [_c.c_void_p, _c.c_uint32, _c.c_size_t, _c.c_uint32, _c.c_uint32, _c.c_uint32, _c.c_int32, _c.c_void_p]),
    ("obc_harmonics_rotate", _c.c_int32, [_c.c_void_p, _c.c_uint32, _c.c_size_t, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_harmonics_align_options_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_harmonics_alignment_init", _c.c_int32, [_c.c_void_p, _c.c_size_t]),
    ("obc_harmonics_align", _c.c_int32, [_c.c_void_p, _c.c_uint32, _c.c_void_p, _c.c_uint32, _c.c_size_t, _c.c_void_p, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_harmonics_write", _c.c_int32, [_c.c_char_p, _c.c_int32, _c.c_void_p, _c.c_uint32, _c.c_size_t, _c.c_void_p]),
    ("obc_harmonics_read", _c.c_int32, [_c.c_char_p, _c.c_int32, _c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_harmonics_coefficients_degree", _c.c_uint32, [_c.c_void_p]),
    ("obc_harmonics_coefficients_channels", _c.c_size_t, [_c.c_void_p]),
    ("obc_harmonics_coefficients_copy", _c.c_int32, [_c.c_void_p, _c.c_void_p, _c.c_void_p]),
    ("obc_harmonics_coefficients_destroy", None, [_c.c_void_p]),
    ("obc_harmonics_version", _c.c_uint32, []),
]


def __getattr__(name):
    """A function; the shared library is loaded at the first use."""
    return _bind("harmonics", ["base"], _functions, globals(), name)
