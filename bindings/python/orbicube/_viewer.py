"""The page of meshes, made of those in memory: for notebooks and browsers."""

from __future__ import annotations

import base64
import html
import json
import os
import subprocess
import sys
import tempfile
import webbrowser
from typing import Any, Optional, Sequence

import numpy as np

from ._arrays import Doubles, doubles, indices
from ._foreign import MANY, Parts, parts_of

HERE = os.path.dirname(os.path.abspath(__file__))
STEPS = 2**24 - 1  # of a position along the longest side of the box


def template() -> str:
    """The empty page: of the installed package, or made of its parts in the source tree."""
    path = os.path.join(HERE, "viewer.html")
    if not os.path.exists(path):
        folder = os.path.normpath(os.path.join(HERE, "..", "..", "..", "cli", "view_page"))
        if not os.path.isdir(folder):
            raise RuntimeError("the package has no viewer.html; install it again, from a wheel")
        with open(os.path.join(folder, "parts.txt"), encoding="utf-8") as file:
            parts = [os.path.join(folder, line) for line in file.read().split()]
        with tempfile.TemporaryDirectory() as made:
            path = os.path.join(made, "viewer.html")
            embed = os.path.join(folder, "..", "report_page", "embed.py")
            subprocess.run([sys.executable, embed, path, "-", *parts], check=True)
            with open(path, encoding="utf-8") as file:
                return file.read()
    with open(path, encoding="utf-8") as file:
        return file.read()


def _text(numbers: Any, width: int) -> str:
    """Whole numbers of `width` bytes each, low byte first, in base64."""
    flat = np.ascontiguousarray(numbers, dtype="<u4").reshape(-1, 1).view(np.uint8)
    return base64.b64encode(flat[:, :width].tobytes()).decode("ascii")


def _positions(positions: Doubles, used: Any, name: str) -> dict[str, Any]:
    box = positions[used]
    if not np.all(np.isfinite(box)):
        raise ValueError(f"{name}: a position is not finite")
    low, high = box.min(axis=0), box.max(axis=0)
    half = float((0.5 * high - 0.5 * low).max())
    step = half / STEPS * 2 if half > 0 else 1.0
    numbers = np.nan_to_num(2 * ((0.5 * positions - 0.5 * low) / step), posinf=STEPS, neginf=0)
    return {"low": low.tolist(), "step": step, "positions": _text(np.clip(np.round(numbers), 0, STEPS), 3)}


def _parts(shape: Any, name: str) -> Parts:
    if isinstance(shape, (tuple, list)) and len(shape) == 2:
        return Parts(*shape)
    parts = parts_of(shape, name)
    if parts is None:
        raise TypeError(f"{name}: give a mesh, or (positions, triangles), not {type(shape).__name__}")
    return parts


def item_of(shape: Any, name: str, target: Optional[Any] = None, target_name: str = "map") -> dict[str, Any]:
    """A mesh as the page reads it; `target`: positions of its vertices on a map."""
    parts = _parts(shape, name)
    positions = doubles(parts.positions, 3, name=f"{name}: positions")
    cells = {kind: indices(getattr(parts, kind), corners, name=f"{name}: {kind}", below=len(positions), of="positions")
             for kind, corners in MANY.items() if parts.count(kind)}
    if len(cells) > 1:
        cells.pop("triangles", None)
    if not cells:
        raise ValueError(f"{name}: there are no triangles or cells to show")
    used = np.unique(np.concatenate([cell.ravel() for cell in cells.values()]))
    width = next(width for width in (1, 2, 3, 4) if width == 4 or len(positions) <= 256**width)
    item: dict[str, Any] = {"name": name, "width": width, **_positions(positions, used, name), "targets": [], "curves": []}
    item.update({kind: _text(cell, width) for kind, cell in cells.items()})
    if target is not None:
        places = doubles(target, 3, name=f"{name}: map")
        if len(places) != len(positions):
            raise ValueError(f"{name}: the map has {len(places)} positions, the shape {len(positions)}")
        item["targets"].append({"name": target_name, **_positions(places, used, name)})
    item["figures"] = [["Vertices", str(len(positions))]] + [[kind.capitalize(), str(len(cell))] for kind, cell in cells.items()]
    return item


def page(items: Sequence[dict[str, Any]], title: str, up: str = "y", preset: str = "") -> str:
    """The text of the page."""
    data = json.dumps({"up": up, "preset": preset, "items": list(items)}).replace("<", "\\u003c")
    before, after = template().split("@RESULTS@")
    title = html.escape(title, quote=False)
    return before.replace("@TITLE@", title) + data + after.replace("@TITLE@", title)


def frame(text: str, height: int = 640) -> str:
    """The page within another one, such as a notebook."""
    return (f'<iframe srcdoc="{html.escape(text)}" style="width: 100%; height: {int(height)}px; border: 0" '
            'title="Meshes in three dimensions"></iframe>')


class Shown:
    """A page: in a notebook as the last value of a cell, otherwise by open() in a browser or by write() in a file."""

    def __init__(self, text: str, height: int = 640) -> None:
        self.text, self.height = text, height

    def _repr_html_(self) -> str:
        return frame(self.text, self.height)

    def write(self, path: "str | os.PathLike[str]") -> None:
        """Writes the page, one file that loads nothing else."""
        with open(path, "w", encoding="utf-8") as file:
            file.write(self.text)

    def open(self) -> None:
        """Opens the page in a browser, from a temporary file that stays."""
        handle, path = tempfile.mkstemp(prefix="orbicube-", suffix=".html")
        os.close(handle)
        self.write(path)
        webbrowser.open("file://" + path)


def show(*shapes: Any, names: Optional[Sequence[str]] = None, maps: Optional[Sequence[Any]] = None, title: str = "Orbicube",
         up: str = "y", height: int = 640, preset: str = "") -> Shown:
    """
    The page of one shape or of several with linked views: slices, quality, colors and figures of what is picked. A shape is
    all that the functions of orbicube.mesh take, or cells as well. `maps`: for each shape positions of its vertices on a map
    or None. `preset`: how the page begins, such as "color=jacobian&slice=0,0.5&theme=dark". In a notebook the result shows
    itself; write(path) and open() are for everywhere else.
    """
    if not shapes:
        raise ValueError("there is no shape to show")
    if up not in ("y", "z"):
        raise ValueError(f"up is y or z, not {up!r}")
    names = list(names) if names is not None else ["mesh" if len(shapes) == 1 else f"mesh {i + 1}" for i in range(len(shapes))]
    targets = list(maps) if maps is not None else [None] * len(shapes)
    if len(names) != len(shapes) or len(targets) != len(shapes):
        raise ValueError(f"{len(shapes)} shapes, but {len(names)} names and {len(targets)} maps")
    items = [item_of(shape, name, target) for shape, name, target in zip(shapes, names, targets)]
    return Shown(page(items, title, up, preset), height)
