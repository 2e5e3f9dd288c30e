"""Finds and loads the shared libraries, each when its first function is called.

They are looked for in the folders of the variable ORBICUBE_LIBRARIES (as in PATH), in the package itself and beside it (a wheel
carries them there, by setuptools or by meson-python), then where the system looks.
"""

from __future__ import annotations

import ctypes
import os
import sys
from typing import Any, Union

Pointer = Union[int, None, ctypes.Array, "ctypes._Pointer[Any]", "ctypes._CArgObject", ctypes.c_void_p]

_loaded: dict[str, ctypes.CDLL] = {}


class Struct(ctypes.Structure):
    """A struct of the C headers; its members are attributes."""

    def as_dict(self) -> dict[str, Any]:
        """The members by name, arrays as lists; without the size of the struct and what is reserved."""
        result = {}
        for name, *_ in self._fields_:
            if name in ("struct_size", "reserved"):
                continue
            value = getattr(self, name)
            result[name] = list(value) if isinstance(value, ctypes.Array) else value
        return result

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Struct) or type(self) is not type(other):
            return NotImplemented
        return self.as_dict() == other.as_dict()

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        members = ", ".join(f"{name}={value!r}" for name, value in self.as_dict().items())
        return f"{type(self).__name__}({members})"


def _file_name(name: str) -> str:
    if sys.platform == "darwin":
        return f"lib{name}.0.dylib"
    return f"{name}-0.dll" if sys.platform == "win32" else f"lib{name}.so.0"


def _combined(folder: str, library: str) -> ctypes.CDLL | None:
    """The one library with all C functions that a wheel of meson-python carries, where it has those of this one."""
    path = os.path.join(folder, _file_name("orbicube"))
    if not os.path.exists(path):
        return None
    combined = ctypes.CDLL(path)
    return combined if hasattr(combined, f"obc_{library}_version") else None


def load(library: str) -> ctypes.CDLL:
    """The shared library of that name; ImportError says where it was looked for."""
    if library not in _loaded:
        file = _file_name("orbicube-" + library.replace("_", "-"))
        package = os.path.dirname(os.path.abspath(__file__))
        folders = [folder for folder in os.environ.get("ORBICUBE_LIBRARIES", "").split(os.pathsep) if folder]
        folders.append(os.path.join(package, "lib"))
        path = next((p for p in (os.path.join(folder, file) for folder in folders) if os.path.exists(p)), None)
        folders.append(os.path.join(os.path.dirname(package), ".orbicube.mesonpy.libs"))
        try:
            _loaded[library] = ctypes.CDLL(path) if path else _combined(folders[-1], library) or ctypes.CDLL(file)
        except OSError as error:
            raise ImportError(f"orbicube.{library}: {error}. Looked in {', '.join(folders)} and where the system looks; "
                              "name the folder of the libraries in ORBICUBE_LIBRARIES") from error
    return _loaded[library]


def bind(library: str, uses: list[str], functions: list[tuple[str, Any, list[Any]]], namespace: dict[str, Any],
         wanted: str) -> Any:
    """Puts the functions of a library into the module that declares them, and returns the requested one."""
    if wanted not in (row[0] for row in functions):
        raise AttributeError(f"orbicube.raw.{library} has no {wanted}")
    for used in uses:  # so that the system finds them loaded
        load(used)
    shared = load(library)
    for name, result, arguments in functions:
        try:
            function = getattr(shared, name)
        except AttributeError:
            continue  # a library that is older than this package
        function.restype, function.argtypes = result, arguments
        namespace[name] = function
    if wanted not in namespace:
        raise AttributeError(f"the library {library} is too old: it has no {wanted}")
    return namespace[wanted]
