"""Orbicube: maps of surfaces to spheres and polycubes, frame fields, meshes, and the solvers underneath.

A module a library, loaded when it is used: orbicube.sphere_map, orbicube.polycube, orbicube.trust_region, ... The C
functions as they are lie in orbicube.raw. orbicube.study runs studies of groups, also on clusters.
"""

from __future__ import annotations

import importlib
from typing import Any

from ._call import (Cancelled, Error, FileError, InvalidArgument, MalformedFile, NoValidResult, OutOfMemory, Stop,
                    Unsupported, UnsuitableSurface)
from ._solver import EvaluationFailed

__version__ = "0.1.0"
_LIBRARIES = ["quaternion", "sphere_optimizer", "trust_region", "projected_gradient", "linear", "harmonics", "mesh",
              "gltf", "repair", "frame_field", "sphere_map", "tetrahedra", "untangle", "polycube", "correspondence",
              "volume_map", "hexmesh"]
__all__ = ["Cancelled", "Error", "EvaluationFailed", "FileError", "InvalidArgument", "MalformedFile", "NoValidResult",
           "OutOfMemory", "Stop", "Unsupported", "UnsuitableSurface", "study", *_LIBRARIES]


def __getattr__(name: str) -> Any:
    if name in _LIBRARIES or name in ("raw", "study"):
        return importlib.import_module("." + name, __name__)
    raise AttributeError(f"module 'orbicube' has no attribute {name!r}")
