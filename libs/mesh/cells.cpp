#include "mesh/cells.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>

#include "base/error.h"
#include "mesh/place_text.h"
#include "mesh/predicates.h"

namespace orbicube::mesh {
namespace {

constexpr const char* phase = "checking cells";
constexpr std::size_t items_between_reports = 8192;

// The three neighbours of each corner of a hexahedron, so that their edges have a positive determinant in a cube.
constexpr std::array<std::array<std::size_t, 3>, 8> corner_neighbours = {
    {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7}, {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}}};

constexpr std::array<std::array<std::size_t, 3>, 4> tetrahedron_faces = {{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
constexpr std::array<std::array<std::size_t, 4>, 6> hexahedron_faces = {
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};

const char* name(const Tetrahedron&) {
  return "tetrahedron";
}
const char* name(const Hexahedron&) {
  return "hexahedron";
}

// -1, 0 or 1: inside out somewhere, flat somewhere, or neither.
int orientation(std::span<const Vector3> x, const Tetrahedron& c) {
  return orientation_3d(x[c[0]], x[c[1]], x[c[2]], x[c[3]]);
}
int orientation(std::span<const Vector3> x, const Hexahedron& c) {
  int least = 1;
  for (std::size_t i = 0; i < 8; ++i) {
    const auto& n = corner_neighbours[i];
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

// Those of `count` items for which key_of answers a key, equal keys beside each other. A counting sort by the lowest
// vertex, then a sort of those that share it.
template <std::size_t size, class KeyOf>
Array<Entry<size>> sorted_by_key(std::size_t count, std::size_t vertex_count, const KeyOf& key_of,
                                 const base::Host& host) {
  if (count >= no_index) throw base::Error("unsupported", "more cells than 32-bit numbers of their faces can count");
  Array<Index> begin(vertex_count + 1, 0, host.memory);
  for (std::size_t i = 0; i < count; ++i) {
    if (i % items_between_reports == 0) host.report(phase, i, 0);
    ++begin[key_of(i)[0] + std::size_t{1}];
  }
  for (std::size_t v = 0; v < vertex_count; ++v)
    begin[v + 1] += begin[v];
  Array<Entry<size>> entries(count, host.memory);
  for (std::size_t i = 0; i < count; ++i) {
    if (i % items_between_reports == 0) host.report(phase, i, 0);
    const Key<size> key = key_of(i);
    entries[begin[key[0]]++] = {key, static_cast<Index>(i)};
  }
  // Each begin has moved on to the next one.
  for (std::size_t v = 0; v < vertex_count; ++v) {
    if (v % items_between_reports == 0) host.report(phase, v, 0);
    std::sort(entries.begin() + (v == 0 ? 0 : begin[v - 1]), entries.begin() + begin[v]);
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
  void refuse(const char* kind, const char* what) const {
    if (count > 0) throw base::Error(kind, std::string(what) + ": " + std::to_string(count) + "; first " + first);
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
    if (i % items_between_reports == 0) host.report(phase, i, cells.size());
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
  inverted.refuse("inverted-cell", "cells that are inside out, or have a corner that is");
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
    crowded.add([&] { return text(key) + " of " + std::to_string(count) + " cells" + at(positions[key[0]]); });
  });
  crowded.refuse("non-manifold-face", "faces of more than two cells");
  Array<Key<size>> result(host.memory);
  result.reserve(alone);
  for_each_group(entries, [&](std::size_t first, std::size_t count) {
    if (count == 1) result.push_back(face(entries[first].item));
  });
  return result;
}

template <std::size_t size>
void check_boundary(const Array<Key<size>>& faces, std::span<const Vector3> positions, const base::Host& host) {
  const auto edge = [&](std::size_t i) {
    const auto& face = faces[i / size];
    return sorted<2>({face[i % size], face[(i + 1) % size]});
  };
  const auto entries = sorted_by_key<2>(size * faces.size(), positions.size(), edge, host);
  Defect crowded;
  for_each_group(entries, [&](std::size_t first, std::size_t count) {
    if (count <= 2) return;
    const Key<2>& key = entries[first].key;
    crowded.add([&] { return text(key) + " of " + std::to_string(count) + " boundary faces" + at(positions[key[0]]); });
  });
  crowded.refuse("non-manifold-edge", "edges where parts of the solid touch");
}

}  // namespace

void require_valid_cells(const Mesh& mesh, const base::Host& host) {
  const std::span<const Tetrahedron> tetrahedra = mesh.tetrahedra;
  const std::span<const Hexahedron> hexahedra = mesh.hexahedra;
  const std::span<const Vector3> positions = mesh.positions;
  check_each(positions, tetrahedra, host);
  check_each(positions, hexahedra, host);
  const auto triangles = boundary(tetrahedra, positions, tetrahedron_faces, host);
  const auto quadrilaterals = boundary(hexahedra, positions, hexahedron_faces, host);
  if (hexahedra.empty()) check_boundary(triangles, positions, host);
  if (tetrahedra.empty()) check_boundary(quadrilaterals, positions, host);
}

Array<Triangle> boundary_triangles(const Mesh& mesh, const base::Host& host) {
  const std::span<const Tetrahedron> tetrahedra = mesh.tetrahedra;
  const std::span<const Hexahedron> hexahedra = mesh.hexahedra;
  const std::span<const Vector3> positions = mesh.positions;
  check_indices(positions.size(), tetrahedra);
  check_indices(positions.size(), hexahedra);
  Array<Triangle> result = boundary(tetrahedra, positions, tetrahedron_faces, host);
  const auto length = [&](Index a, Index b) { return (positions[b] - positions[a]).stableNorm(); };
  for (const auto& q : boundary(hexahedra, positions, hexahedron_faces, host)) {
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
