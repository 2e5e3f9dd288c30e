"""What tests of solids share: whether the library tetrahedra is there, and a box of tetrahedra."""

import importlib.util

import numpy as np
import orbicube

HAS_TETRAHEDRA = importlib.util.find_spec("orbicube.tetrahedra") is not None
try:
    orbicube.tetrahedra.version()
except ImportError:
    HAS_TETRAHEDRA = False


def box_of_tetrahedra(n):
    """A cube of n^3 cells, six tetrahedra each around its diagonal."""
    axis = np.arange(n + 1)
    positions = np.array(np.meshgrid(axis, axis, axis, indexing="ij")).reshape(3, -1).T / n
    cells = []
    for i in np.ndindex(n, n, n):
        for order in ((0, 1, 2), (1, 2, 0), (2, 0, 1), (0, 2, 1), (2, 1, 0), (1, 0, 2)):
            corner, path = list(i), [tuple(i)]
            for k in order:
                corner[k] += 1
                path.append(tuple(corner))
            four = [(a * (n + 1) + b) * (n + 1) + c for a, b, c in path]
            cells.append(four if order in ((0, 1, 2), (1, 2, 0), (2, 0, 1)) else [four[0], four[1], four[3], four[2]])
    return positions, np.array(cells, dtype=np.uint32)
