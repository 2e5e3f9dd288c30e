#include "mesh/topology/cells.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <utility>

#include "base/counted.h"
#include "base/error.h"
#include "base/grouping.h"
#include "mesh/search/predicates.h"
#include "mesh/topology/place_text.h"

namespace orbicube::mesh {
namespace {

constexpr const char* cell_phase = "checking cells";

// The three neighbors of each corner of a hexahedron, so that their edges have a positive determinant in a cube.
constexpr std::array<std::array<std::size_t, 3>, 8> corner_neighbors = {
    {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7}, {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}}};

constexpr std::array<std::array<std::size_t, 3>, 4> tetrahedron_faces = {{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

const char* name(const Tetrahedron&) {
  return "tetrahedron";
}
const char* name(const Hexahedron&) {
  return "hexahedron";
}

// -1, 0 or 1: inverted somewhere, flat somewhere, or neither.
int orientation(std::span<const Vector3> x, const Tetrahedron& c) {
  return orientation_3d(x[c[0]], x[c[1]], x[c[2]], x[c[3]]);
}
int orientation(std::span<const Vector3> x, const Hexahedron& c) {
  int least = 1;
  for (std::size_t i = 0; i < 8; ++i) {
    const auto& n = corner_neighbors[i];
    least = std::min(least, orientation_3d(x[c[i]], x[c[n[0]]], x[c[n[1]]], x[c[n[2]]]));
  }
  return least;
}

template <std::size_t size>
using Key = std::array<Index, size>;  // ascending

template <std::size_t size>
Key<size> sorted(Key<size> vertices) {
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

template <std::size_t size>
struct Entry {
  Key<size> key;
  Index item;  // what has that key
  bool operator<(const Entry& o) const { return key != o.key ? key < o.key : item < o.item; }
};

// Those of `count` items for which key_of returns a key, equal keys beside each other. A counting sort by the lowest
// vertex, then a sort of those that share it.
template <std::size_t size, class KeyOf>
Array<Entry<size>> sorted_by_key(std::size_t count, std::size_t vertex_count, const KeyOf& key_of,
                                 const base::Host& host) {
  if (count >= no_index) throw base::Error("unsupported", "more cells than 32-bit numbers of their faces can count");
  Array<Index> begin(vertex_count + 1, host.memory);
  Array<Entry<size>> entries(count, host.memory);
  base::group_by_key(
      std::span(begin),
      [&](const auto& visit) {
        for (std::size_t i = 0; i < count; ++i) {
          if (i % base::items_between_reports == 0) host.report(cell_phase, i, 0);
          const Key<size> key = key_of(i);
          visit(key[0], Entry<size>{key, static_cast<Index>(i)});
        }
      },
      [](Index) {}, [&](Index at, const Entry<size>& entry) { entries[at] = entry; });
  for (std::size_t v = 0; v < vertex_count; ++v) {
    if (v % base::items_between_reports == 0) host.report(cell_phase, v, 0);
    std::sort(entries.begin() + begin[v], entries.begin() + begin[v + 1]);
  }
  return entries;
}

// visit(first, count) for each group of entries with equal keys.
template <std::size_t size, class Visit>
void for_each_group(const Array<Entry<size>>& entries, const Visit& visit) {
  for (std::size_t first = 0; first < entries.size();) {
    std::size_t end = first + 1;
    while (end < entries.size() && entries[end].key == entries[first].key)
      ++end;
    visit(first, end - first);
    first = end;
  }
}

template <std::size_t size>
std::string text(const Key<size>& vertices) {
  std::string result;
  for (const Index v : vertices)
    result.append(result.empty() ? "" : "-").append(std::to_string(v));
  return result;
}

// The first place of a defect and how many there are.
struct Defect {
  std::size_t count = 0;
  std::string first;

  template <class Text>
  void add(const Text& describe) {
    if (count++ == 0) first = describe();
  }
  void refuse(const char* kind, const std::string& what) const {
    if (count > 0) throw base::Error(kind, what + ": " + std::to_string(count) + "; first " + first);
  }
};

std::string at(const Vector3& p) {
  return ", at " + place_text(p);
}

template <class Cell>
std::string describe(std::span<const Cell> cells, std::size_t i) {
  return std::string(name(cells[i])) + " " + std::to_string(i) + " with vertices " + text(cells[i]);
}

template <class Cell>
void check_indices(std::size_t vertex_count, std::span<const Cell> cells) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (std::ranges::max(cells[i]) >= vertex_count)
      throw base::Error("index-range", describe(cells, i) + ", where there are " + std::to_string(vertex_count));
  }
}

template <class Cell>
void check_each(std::span<const Vector3> positions, std::span<const Cell> cells, const base::Host& host) {
  check_indices(positions.size(), cells);
  Defect repeated, flat, inverted;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i % base::items_between_reports == 0) host.report(cell_phase, i, cells.size());
    const Cell vertices = sorted(cells[i]);
    const bool repeats = std::adjacent_find(vertices.begin(), vertices.end()) != vertices.end();
    const int sign = repeats ? 0 : orientation(positions, cells[i]);
    if (sign > 0) continue;
    (repeats     ? repeated
     : sign == 0 ? flat
                 : inverted)
        .add([&] { return describe(cells, i) + at(positions[cells[i][0]]); });
  }
  repeated.refuse("degenerate-cell", "cells with a repeated vertex");
  const bool all = inverted.count == cells.size();
  inverted.refuse("inverted-cell", all ? "all cells are inverted, as in another order of vertices"
                                       : "cells that are inverted, or have a corner that is");
  flat.refuse("degenerate-cell", "cells without volume, or with a flat corner");
  Defect duplicate;
  const auto same = sorted_by_key<std::tuple_size_v<Cell>>(
      cells.size(), positions.size(), [&](std::size_t i) { return sorted(cells[i]); }, host);
  for_each_group(same, [&](std::size_t first, std::size_t size) {
    for (std::size_t i = 1; i < size; ++i) {
      const Index item = same[first + i].item;
      duplicate.add([&] {
        return describe(cells, item) + ", those of " + std::to_string(same[first].item) + at(positions[cells[item][0]]);
      });
    }
  });
  duplicate.refuse("duplicate-cell", "cells with the vertices of another");
}

// The faces of one cell only, in their cells' order of vertices; refuses those of three cells or more.
template <class Cell, std::size_t faces, std::size_t size>
Array<Key<size>> boundary(std::span<const Cell> cells, std::span<const Vector3> positions,
                          const std::array<std::array<std::size_t, size>, faces>& corners, const base::Host& host) {
  const auto face = [&](std::size_t i) {
    Key<size> vertices;
    for (std::size_t k = 0; k < size; ++k)
      vertices[k] = cells[i / faces][corners[i % faces][k]];
    return vertices;
  };
  const auto entries = sorted_by_key<size>(
      faces * cells.size(), positions.size(), [&](std::size_t i) { return sorted(face(i)); }, host);
  Defect crowded;
  std::size_t alone = 0;
  for_each_group(entries, [&](std::size_t first, std::size_t count) {
    alone += count == 1;
    if (count <= 2) return;
    const Key<size>& key = entries[first].key;
    crowded.add([&] { return text(key) + " of " + base::counted(count, "cell") + at(positions[key[0]]); });
  });
  crowded.refuse("non-manifold-face", "faces of more than two cells");
  Array<Key<size>> result(host.memory);
  result.reserve(alone);
  for_each_group(entries, [&](std::size_t first, std::size_t count) {
    if (count == 1) result.push_back(face(entries[first].item));
  });
  return result;
}

// The faces of one cell only of a solid.
struct Boundary {
  Array<Key<3>> triangles;       // of tetrahedra
  Array<Key<4>> quadrilaterals;  // of hexahedra
};

// Takes the quadrilaterals that two triangles fill, and these, out of the boundary; refuses those with triangles on
// them that do not.
void glue(Boundary& boundary, std::span<const Vector3> positions, const base::Host& host) {
  const auto entries = sorted_by_key<3>(
      boundary.triangles.size(), positions.size(), [&](std::size_t i) { return sorted(boundary.triangles[i]); }, host);
  // The triangle with the corners of a quadrilateral but one.
  const auto without = [&](const Key<4>& q, std::size_t corner) {
    const Entry<3> target{sorted<3>({q[(corner + 1) % 4], q[(corner + 2) % 4], q[(corner + 3) % 4]}), 0};
    const auto found = std::lower_bound(entries.begin(), entries.end(), target);
    return found != entries.end() && found->key == target.key ? found->item : no_index;
  };
  Array<std::uint8_t> glued(boundary.triangles.size(), 0, host.memory);
  Array<Key<4>> left(host.memory);
  Defect apart;
  for (std::size_t i = 0; i < boundary.quadrilaterals.size(); ++i) {
    if (i % base::items_between_reports == 0) host.report(cell_phase, i, boundary.quadrilaterals.size());
    const Key<4>& q = boundary.quadrilaterals[i];
    std::array<Index, 4> found{};
    std::size_t count = 0;
    for (std::size_t corner = 0; corner < 4; ++corner) {
      found[corner] = without(q, corner);
      count += found[corner] != no_index;
    }
    if (count == 0) {
      left.push_back(q);
      continue;
    }
    const std::size_t one = found[0] != no_index ? 0 : 1;
    const bool filled = count == 2 && found[one] != no_index && found[one + 2] != no_index &&
                        glued[found[one]] + glued[found[one + 2]] == 0;
    if (filled) {
      glued[found[one]] = glued[found[one + 2]] = 1;
    } else {
      apart.add([&] { return text(q) + " with " + std::to_string(count) + " on it" + at(positions[q[0]]); });
    }
  }
  apart.refuse("non-manifold-face",
               "faces where hexahedra and tetrahedra do not conform, with triangles on them that do not fill them");
  boundary.quadrilaterals = std::move(left);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < glued.size(); ++i) {
    if (glued[i] == 0) boundary.triangles[kept++] = boundary.triangles[i];
  }
  boundary.triangles.resize(kept);
}

Boundary boundary_of(const Mesh& mesh, const base::Host& host) {
  const std::span<const Vector3> positions = mesh.positions;
  Boundary result{boundary(std::span<const Tetrahedron>(mesh.tetrahedra), positions, tetrahedron_faces, host),
                  boundary(std::span<const Hexahedron>(mesh.hexahedra), positions, hexahedron_faces, host)};
  if (!result.triangles.empty() && !result.quadrilaterals.empty()) glue(result, positions, host);
  return result;
}

Boundary checked_boundary_of(const Mesh& mesh, const base::Host& host) {
  check_indices(mesh.positions.size(), std::span<const Tetrahedron>(mesh.tetrahedra));
  check_indices(mesh.positions.size(), std::span<const Hexahedron>(mesh.hexahedra));
  return boundary_of(mesh, host);
}

void check_edges(const Boundary& boundary, std::span<const Vector3> positions, const base::Host& host) {
  const std::size_t of_triangles = 3 * boundary.triangles.size();
  const auto edge = [&](std::size_t i) {
    if (i < of_triangles) {
      const auto& face = boundary.triangles[i / 3];
      return sorted<2>({face[i % 3], face[(i + 1) % 3]});
    }
    const auto& face = boundary.quadrilaterals[(i - of_triangles) / 4];
    return sorted<2>({face[(i - of_triangles) % 4], face[(i - of_triangles + 1) % 4]});
  };
  const auto entries =
      sorted_by_key<2>(of_triangles + 4 * boundary.quadrilaterals.size(), positions.size(), edge, host);
  Defect crowded;
  for_each_group(entries, [&](std::size_t first, std::size_t count) {
    if (count <= 2) return;
    const Key<2>& key = entries[first].key;
    crowded.add([&] { return text(key) + " of " + base::counted(count, "boundary face") + at(positions[key[0]]); });
  });
  crowded.refuse("non-manifold-edge", "edges where parts of the solid touch");
}

// Corners of a hexahedron that are inverted, less those that are right.
int inverted_corners(std::span<const Vector3> x, const Hexahedron& c) {
  int sum = 0;
  for (std::size_t i = 0; i < 8; ++i) {
    const auto& n = corner_neighbors[i];
    sum -= orientation_3d(x[c[i]], x[c[n[0]]], x[c[n[1]]], x[c[n[2]]]);
  }
  return sum;
}

// Whether no cell is right and one at least is inverted; `sign` is that of a cell's volume.
template <class Cell, class Sign>
bool all_inverted(std::span<const Cell> cells, const Sign& sign, const base::Host& host) {
  bool inverted = false;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i % base::items_between_reports == 0) host.report(cell_phase, i, cells.size());
    const int s = sign(cells[i]);
    if (s > 0) return false;
    inverted = inverted || s < 0;
  }
  return inverted;
}

}  // namespace

CellTurnReport turn_inverted_cells(Mesh& mesh, const base::Host& host) {
  const std::span<const Vector3> positions = mesh.positions;
  check_indices(positions.size(), std::span<const Tetrahedron>(mesh.tetrahedra));
  check_indices(positions.size(), std::span<const Hexahedron>(mesh.hexahedra));
  CellTurnReport report;
  const auto tetrahedron_sign = [&](const Tetrahedron& c) { return orientation(positions, c); };
  if (all_inverted(std::span<const Tetrahedron>(mesh.tetrahedra), tetrahedron_sign, host)) {
    for (Tetrahedron& c : mesh.tetrahedra)
      std::swap(c[1], c[2]);
    report.tetrahedra = mesh.tetrahedra.size();
  }
  const auto hexahedron_sign = [&](const Hexahedron& c) { return -inverted_corners(positions, c); };
  if (all_inverted(std::span<const Hexahedron>(mesh.hexahedra), hexahedron_sign, host)) {
    for (Hexahedron& c : mesh.hexahedra) {
      std::swap(c[1], c[3]);
      std::swap(c[5], c[7]);
    }
    report.hexahedra = mesh.hexahedra.size();
  }
  return report;
}

void require_valid_cells(const Mesh& mesh, const base::Host& host) {
  check_each(std::span<const Vector3>(mesh.positions), std::span<const Tetrahedron>(mesh.tetrahedra), host);
  check_each(std::span<const Vector3>(mesh.positions), std::span<const Hexahedron>(mesh.hexahedra), host);
  check_edges(boundary_of(mesh, host), mesh.positions, host);
}

Array<std::array<Index, 4>> boundary_quads(const Mesh& mesh, const base::Host& host) {
  return checked_boundary_of(mesh, host).quadrilaterals;
}

Array<Triangle> boundary_triangles(const Mesh& mesh, const base::Host& host) {
  const std::span<const Vector3> positions = mesh.positions;
  Boundary faces = checked_boundary_of(mesh, host);
  Array<Triangle> result = std::move(faces.triangles);
  const auto length = [&](Index a, Index b) { return (positions[b] - positions[a]).stableNorm(); };
  for (const auto& q : faces.quadrilaterals) {
    if (length(q[0], q[2]) <= length(q[1], q[3])) {
      result.push_back({q[0], q[1], q[2]});
      result.push_back({q[0], q[2], q[3]});
    } else {
      result.push_back({q[1], q[2], q[3]});
      result.push_back({q[1], q[3], q[0]});
    }
  }
  return result;
}

}  // namespace orbicube::mesh
