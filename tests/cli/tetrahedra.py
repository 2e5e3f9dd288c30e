"""Meshes of tetrahedra for the tests of the command."""
import itertools


def box(n):
    """n^3 cubes, each cut into six tetrahedra: positions from 0 to n, tetrahedra."""
    def at(p):
        return (p[0] * (n + 1) + p[1]) * (n + 1) + p[2]
    cells = []
    for corner in itertools.product(range(n), repeat=3):
        for order in itertools.permutations(range(3)):
            p, t = list(corner), [at(corner)]
            for axis in order:
                p[axis] += 1
                t.append(at(p))
            if sum(order[i] > order[j] for i, j in ((0, 1), (0, 2), (1, 2))) % 2:
                t[2], t[3] = t[3], t[2]
            cells.append(t)
    return list(itertools.product(range(n + 1), repeat=3)), cells


def write_medit(path, positions, cells):
    with open(path, "w", encoding="ascii") as file:
        file.write(f"MeshVersionFormatted 2\nDimension 3\nVertices\n{len(positions)}\n")
        file.writelines("%r %r %r 0\n" % tuple(p) for p in positions)
        file.write(f"Tetrahedra\n{len(cells)}\n")
        file.writelines("%d %d %d %d 0\n" % tuple(v + 1 for v in t) for t in cells)
        file.write("End\n")
