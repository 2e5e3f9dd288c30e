"""Maps of tetrahedral meshes without inverted tetrahedra.

    positions, report = untangle((positions, tetrahedra), rest=rest_positions, fixed=fixed)
"""

from __future__ import annotations

from ctypes import byref
from typing import Any, Optional

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import Doubles, address, doubles, indices, solid_of
from ._call import HOST, NoValidResult, Progress, call, call_init, filled
from .raw import volume_map as raw


def untangle(solid: Any, *, rest: Optional[ArrayLike] = None, fixed: Optional[ArrayLike] = None,
             ties: Optional[ArrayLike] = None, threads: int = 0, progress: Progress = None,
             **options: Any) -> tuple[Doubles, raw.obc_volume_map_untangle_report]:
    """Moves vertices until every tetrahedron is positive: positions, and a report. rest: positions where each has the shape
    that it should have. fixed: a flag a coordinate, shape (n, 3), or a vertex, shape (n,). ties: a group a coordinate, of which
    all are to be equal, or 2^32 - 1. Options: steps, polish_steps, volume_weight. When some stay inverted, the NoValidResult has the
    best that was found, positions and report, as its member `best`."""
    positions, tetrahedra = solid_of(solid)
    tangle = raw.obc_volume_map_tangle()
    call_init(raw.obc_volume_map_tangle_init, tangle)
    tangle.positions, tangle.vertex_count = address(positions), len(positions)
    tangle.tetrahedra, tangle.tetrahedron_count = address(tetrahedra), len(tetrahedra)
    kept: list[Any] = []
    if rest is not None:
        kept.append(doubles(rest, 3, len(positions), "rest"))
        tangle.rest = address(kept[-1])
    if fixed is not None:
        flags = np.asarray(fixed, dtype=bool)
        flags = flags[:, None] if flags.ndim == 1 else flags
        kept.append(np.ascontiguousarray(np.broadcast_to(flags, positions.shape), dtype=np.uint8))
        tangle.fixed = address(kept[-1])
    if ties is not None:
        kept.append(indices(ties, 3, len(positions), "ties"))
        tangle.ties = address(kept[-1])
    chosen = filled(raw.obc_volume_map_untangle_options, raw.obc_volume_map_untangle_options_init, options)
    report = raw.obc_volume_map_untangle_report()
    call_init(raw.obc_volume_map_untangle_report_init, report)
    result = np.empty_like(positions)
    try:
        call(raw.obc_volume_map_untangle, byref(tangle), byref(chosen), HOST, address(result), byref(report),
             threads=threads, progress=progress)
    except NoValidResult as error:
        error.best = (result, report)
        raise
    return result, report


def version() -> int:
    """major * 10000 + minor * 100 + patch."""
    return raw.obc_volume_map_version()
