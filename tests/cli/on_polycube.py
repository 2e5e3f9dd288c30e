"""What the tests of polycubes share."""
from fractions import Fraction


def looks_along(positions, triangle):
    """(axis, sign) of a triangle that lies exactly in an axis-aligned plane and has area, else None."""
    points = [tuple(map(Fraction, positions[v])) for v in triangle]
    for axis in range(3):
        if len({p[axis] for p in points}) == 1:
            u, v = (axis + 1) % 3, (axis + 2) % 3
            a, b, c = points
            area = (b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u])
            if area != 0:
                return axis, 1 if area > 0 else -1
    return None
