#include "volume_map/input/solid_pieces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/counted.h"
#include "base/error.h"
#include "mesh/search/bounding_volume_tree.h"
#include "mesh/search/intersections.h"
#include "mesh/topology/conforming_tetrahedra.h"
#include "mesh/topology/disjoint_sets.h"
#include "mesh/topology/topology.h"

namespace orbicube::volume_map {
namespace {

using mesh::Index;
using mesh::no_index;
using mesh::Triangle;
using mesh::Vector3;

// Numbers of sets in the order of their first members.
Pieces numbered(mesh::DisjointSets& sets, std::size_t items, std::size_t vertices, const base::Host& host,
                const auto& vertex_of) {
  Pieces result(host.memory);
  base::Array<Index> number(vertices, no_index, host.memory);
  result.of.resize(items);
  for (std::size_t i = 0; i < items; ++i) {
    Index& n = number[sets.find(vertex_of(i))];
    if (n == no_index) n = static_cast<Index>(result.count++);
    result.of[i] = n;
  }
  return result;
}

// A vertex of the place that a refusal of require_closed_manifold means.
Index vertex_of(const std::string& kind, const mesh::Topology& facts, std::span<const Triangle> triangles) {
  if (kind == "degenerate-face") return triangles[facts.first_degenerate_face][0];
  if (kind == "duplicate-face") return triangles[facts.first_duplicate_faces[1]][0];
  if (kind == "non-manifold-edge") return facts.first_non_manifold_edge[0];
  if (kind == "not-closed") return facts.first_boundary_edge[0];
  if (kind == "non-manifold-vertex") return facts.first_non_manifold_vertex;
  return no_index;
}

// How often a closed surface, of these of the triangles, goes around a point that is not on it, by solid angles (van
// Oosterom and Strackee 1983).
double winding(std::span<const Vector3> positions, std::span<const Triangle> triangles, std::span<const Index> chosen,
               const Vector3& p, const base::Host& host) {
  double sum = 0;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    if (i % 65536 == 0) host.report("check", i, chosen.size());
    const Triangle& t = triangles[chosen[i]];
    const Vector3 a = positions[t[0]] - p, b = positions[t[1]] - p, c = positions[t[2]] - p;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    sum += std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return sum / (2 * std::numbers::pi);
}

// A connected part of a surface.
struct Part {
  mesh::Box box;
  Index vertex = no_index;
  double volume = 0;       // times six, about the vertex, for the digits
  std::size_t around = 0;  // parts that it lies within
  std::size_t piece = 0;
};

base::Array<Part> parts_of(std::span<const Vector3> positions, std::span<const Triangle> triangles, const Pieces& found,
                           const base::Host& host) {
  base::Array<Part> parts(found.count, host.memory);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (i % 65536 == 0) host.report("check", i, triangles.size());
    const Triangle& t = triangles[i];
    Part& part = parts[found.of[i]];
    for (const Index v : t)
      part.box.add(positions[v]);
    if (part.vertex == no_index) part.vertex = t[0];
    const Vector3& at = positions[part.vertex];
    part.volume += (positions[t[0]] - at).dot((positions[t[1]] - at).cross(positions[t[2]] - at));
  }
  return parts;
}

bool contains(const mesh::Box& outer, const mesh::Box& inner) {
  return (outer.low.array() <= inner.low.array()).all() && (inner.high.array() <= outer.high.array()).all();
}

}  // namespace

void require_closed_surface(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                            const base::Host& host) {
  const mesh::Topology facts = mesh::topology(positions, triangles, host);
  try {
    mesh::require_closed_manifold(facts);
  } catch (const base::Error& error) {
    const Index v = vertex_of(error.kind(), facts, triangles);
    if (v == no_index) throw;
    throw base::Error(error.kind(), std::string(error.what()) + ", at " + place_text(positions[v]));
  }
  if (!facts.orientable)
    throw base::Error("non-orientable",
                      "the surface has one side only, like a Klein bottle; it bounds no solid, from " +
                          place_text(positions[triangles[0][0]]) + " on");
  if (facts.zero_area_faces > 0) {
    const Index first = facts.first_zero_area_face;
    throw base::Error("degenerate-face", "faces without area: " + std::to_string(facts.zero_area_faces) +
                                             "; first face " + std::to_string(first) + ", at " +
                                             place_text(positions[triangles[first][0]]));
  }
}

std::size_t refuse_self_intersections(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                                      double share, const base::Host& host) {
  const auto pairs = mesh::intersecting_triangles(positions, triangles, host);
  if (pairs.empty()) return 0;
  const Pieces parts = surface_parts(triangles, positions.size(), host);
  base::Array<std::uint8_t> meets(triangles.size(), 0, host.memory);
  std::size_t count = 0;
  auto between_parts = pairs.end();
  for (auto pair = pairs.begin(); pair != pairs.end(); ++pair) {
    for (const Index t : *pair) {
      count += meets[t] == 0;
      meets[t] = 1;
    }
    if (between_parts == pairs.end() && parts.of[(*pair)[0]] != parts.of[(*pair)[1]]) between_parts = pair;
  }
  const bool meeting = between_parts != pairs.end();
  if (meeting || static_cast<double>(count) > share * static_cast<double>(triangles.size())) {
    const auto& [p, q] = meeting ? *between_parts : pairs[0];
    throw base::Error("self-intersection",
                      "pairs of faces that meet where they should not: " + std::to_string(pairs.size()) +
                          (meeting ? "; parts of the surface meet, first in faces " : "; first faces ") +
                          std::to_string(p) + " and " + std::to_string(q) + ", at " +
                          place_text(positions[triangles[p][0]]));
  }
  return pairs.size();
}

Pieces surface_parts(std::span<const Triangle> triangles, std::size_t vertices, const base::Host& host) {
  mesh::DisjointSets sets(vertices, host.memory);
  for (const Triangle& t : triangles) {
    sets.unite(t[0], t[1]);
    sets.unite(t[0], t[2]);
  }
  return numbered(sets, triangles.size(), vertices, host, [&](std::size_t i) { return triangles[i][0]; });
}

SurfacePieces surface_pieces(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                             const base::Host& host) {
  const Pieces found = surface_parts(triangles, positions.size(), host);
  base::Array<Part> parts = parts_of(positions, triangles, found, host);
  const PieceItems items = items_of(found, host);
  // Boxes first: what lies apart needs no sums.
  base::Array<mesh::Box> boxes(host.memory);
  for (const Part& part : parts)
    boxes.push_back(part.box);
  const mesh::BoundingVolumeTree tree(boxes, host);
  base::Array<std::array<std::size_t, 2>> within(host.memory);  // the first part in the second
  base::Array<Index> near(host.memory);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i % 1024 == 0) host.report("check", i, parts.size());
    near.clear();
    tree.for_each_near(boxes[i], [&](Index k) {
      if (k != i && contains(boxes[k], boxes[i])) near.push_back(k);
    });
    std::sort(near.begin(), near.end());
    for (const Index k : near) {
      if (std::abs(winding(positions, triangles, items[k], positions[parts[i].vertex], host)) > 0.5)
        within.push_back({i, k});
    }
  }
  for (const auto& [inner, outer] : within)
    ++parts[inner].around;
  SurfacePieces result(host.memory);
  for (Part& part : parts) {
    if (part.around % 2 == 0)
      part.piece = result.count++;
    else
      ++result.cavities;
  }
  // The wall of a cavity belongs to what is next around it.
  for (const auto& [inner, outer] : within) {
    if (parts[inner].around % 2 != 0 && parts[outer].around + 1 == parts[inner].around)
      parts[inner].piece = parts[outer].piece;
  }
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Part& part = parts[found.of[i]];
    result.of.push_back(static_cast<Index>(part.piece));
    result.wrong_side.push_back((part.volume > 0) != (part.around % 2 == 0));
  }
  return result;
}

Pieces pieces_of(std::span<const mesh::Tetrahedron> tetrahedra, std::size_t vertices, const base::Host& host) {
  const base::Array<mesh::SortedFace> faces = mesh::sorted_faces(tetrahedra, vertices, host);
  mesh::DisjointSets sets(tetrahedra.size(), host.memory);
  for (std::size_t i = 1; i < faces.size(); ++i) {
    if (faces[i].corners == faces[i - 1].corners) sets.unite(faces[i].tetrahedron, faces[i - 1].tetrahedron);
  }
  return numbered(sets, tetrahedra.size(), tetrahedra.size(), host,
                  [](std::size_t i) { return static_cast<Index>(i); });
}

PieceItems items_of(const Pieces& pieces, const base::Host& host) {
  const auto for_each = [&](const auto& visit) {
    for (Index i = 0; i < pieces.of.size(); ++i)
      visit(pieces.of[i], i);
  };
  return {pieces.count, for_each, host.memory};
}

PieceCutter::PieceCutter(const mesh::Mesh& mesh, const Pieces& pieces, const base::Host& host)
    : mesh_(mesh), host_(host), items_(items_of(pieces, host)), number_(mesh.positions.size(), no_index, host.memory) {}

mesh::Mesh PieceCutter::piece(std::size_t which) {
  mesh::Mesh result(host_.memory);
  base::Array<Index> vertices(host_.memory);
  const auto take = [&](const auto& cells, auto& taken) {
    for (const Index i : items_[which]) {
      for (const Index v : cells[i]) {
        if (number_[v] != no_index) continue;
        number_[v] = 0;
        vertices.push_back(v);
      }
    }
    std::sort(vertices.begin(), vertices.end());
    for (const Index v : vertices) {
      number_[v] = static_cast<Index>(result.positions.size());
      result.positions.push_back(mesh_.positions[v]);
    }
    for (const Index i : items_[which]) {
      taken.push_back(cells[i]);
      for (Index& v : taken.back())
        v = number_[v];
    }
  };
  mesh_.tetrahedra.empty() ? take(mesh_.triangles, result.triangles) : take(mesh_.tetrahedra, result.tetrahedra);
  for (const Index v : vertices)
    number_[v] = no_index;
  return result;
}

void require_cells_for_pieces(std::size_t pieces, std::size_t cells) {
  if (pieces <= cells) return;
  throw base::Error("invalid-argument", base::counted(pieces, "piece needs", "pieces need") +
                                            " at least one cell each, " + std::to_string(cells) +
                                            " were requested; remove small pieces, or request more");
}

}  // namespace orbicube::volume_map
