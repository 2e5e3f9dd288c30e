#include "mesh/topology/tetrahedral_connectivity.h"

#include <algorithm>
#include <string>

#include "base/error.h"
#include "base/grouping.h"

namespace orbicube::mesh {
namespace {

constexpr const char* tetrahedral_connectivity_phase = "joining tetrahedra";

std::string place(const Triangle& face) {
  return "face " + std::to_string(face[0]) + "-" + std::to_string(face[1]) + "-" + std::to_string(face[2]);
}

// The number in edge_corners of the edge between two corners.
constexpr auto edge_number = [] {
  std::array<std::array<std::uint8_t, 4>, 4> number{};
  for (std::uint8_t e = 0; e < 6; ++e) {
    number[edge_corners[e].start][edge_corners[e].end] = e;
    number[edge_corners[e].end][edge_corners[e].start] = e;
  }
  return number;
}();

void require_distinct_corners(std::span<const Tetrahedron> tetrahedra, const base::Host& host) {
  for (std::size_t t = 0; t < tetrahedra.size(); ++t) {
    if (t % base::items_between_reports == 0) host.report(tetrahedral_connectivity_phase, t, tetrahedra.size());
    Tetrahedron sorted = tetrahedra[t];
    std::ranges::sort(sorted);
    if (std::ranges::adjacent_find(sorted) != sorted.end())
      throw base::Error("degenerate-cell", "tetrahedron " + std::to_string(t) + " has a repeated vertex");
  }
}

}  // namespace

TetrahedralConnectivity::TetrahedralConnectivity(std::size_t vertex_count, std::span<const Tetrahedron> tetrahedra,
                                                 const base::Host& host)
    : tetrahedra_(tetrahedra), vertex_count_(vertex_count), opposite_(host.memory) {
  if (tetrahedra.size() >= (std::size_t{1} << 30))
    throw base::Error("unsupported", "more tetrahedra than 32-bit numbers of their faces can count");
  opposite_.assign(4 * tetrahedra.size(), no_index);
  boundary_faces_ = opposite_.size();
  const auto face_count = static_cast<Index>(opposite_.size());

  require_distinct_corners(tetrahedra, host);

  // Faces by their lowest vertex (a counting sort), then those that share it by the other two.
  const auto lowest = [&](Index face) { return std::ranges::min(vertices(face)); };
  const auto for_each_face = [&](const auto& visit) {
    for (Index f = 0; f < face_count; ++f) {
      if (f % base::items_between_reports == 0) host.report(tetrahedral_connectivity_phase, f / 4, tetrahedra.size());
      visit(lowest(f), f);
    }
  };
  const base::Groups<Index, Index> by_lowest(vertex_count, for_each_face, host.memory);

  struct Entry {
    Index middle, highest, face;
    bool same_face(const Entry& o) const { return middle == o.middle && highest == o.highest; }
  };
  Array<Entry> entries(host.memory);
  for (std::size_t v = 0; v < vertex_count; ++v) {
    if (v % base::items_between_reports == 0) host.report(tetrahedral_connectivity_phase, v, vertex_count);
    entries.clear();
    for (const Index f : by_lowest[v]) {
      Triangle face = vertices(f);
      std::ranges::sort(face);
      entries.push_back({face[1], face[2], f});
    }
    std::ranges::sort(entries, [](const Entry& a, const Entry& b) {
      if (a.middle != b.middle) return a.middle < b.middle;
      return a.highest != b.highest ? a.highest < b.highest : a.face < b.face;
    });
    for (std::size_t i = 1; i < entries.size(); ++i) {
      if (!entries[i].same_face(entries[i - 1])) continue;
      const Index f = entries[i - 1].face, g = entries[i].face;
      if (opposite_[f] != no_index)
        throw base::Error("non-manifold-face", place(vertices(f)) + " of more than two tetrahedra");
      // The same three vertices the other way round, from wherever one starts.
      const Triangle a = vertices(f), b = vertices(g);
      const std::size_t k = a[0] == b[0] ? 0 : a[0] == b[1] ? 1 : 2;
      if (a[1] != b[(k + 2) % 3]) {
        throw base::Error("inconsistent-orientation", place(a) + " has both of its tetrahedra, " +
                                                          std::to_string(tetrahedron_of(f)) + " and " +
                                                          std::to_string(tetrahedron_of(g)) + ", on the same side");
      }
      opposite_[f] = g;
      opposite_[g] = f;
      boundary_faces_ -= 2;
    }
  }
}

Array<std::uint8_t> TetrahedralConnectivity::boundary_vertices(std::pmr::memory_resource* memory) const {
  Array<std::uint8_t> result(vertex_count_, 0, memory);
  for (Index f = 0; f < opposite_.size(); ++f) {
    if (opposite_[f] != no_index) continue;
    for (const Index v : vertices(f))
      result[v] = 1;
  }
  return result;
}

EdgeRings::EdgeRings(const TetrahedralConnectivity& connectivity, const base::Host& host)
    : edges_(host.memory), faces_(host.memory), begin_(host.memory), open_(host.memory) {
  const auto tetrahedra = connectivity.tetrahedra();
  Array<std::uint8_t> seen(tetrahedra.size(), 0, host.memory);  // one bit an edge
  faces_.reserve(6 * tetrahedra.size());
  begin_.push_back(0);
  for (Index t = 0; t < tetrahedra.size(); ++t) {
    if (t % base::items_between_reports == 0) host.report("edges of tetrahedra", t, tetrahedra.size());
    for (std::size_t e = 0; e < 6; ++e) {
      if ((seen[t] >> e & 1) != 0) continue;
      const Edge edge{tetrahedra[t][edge_corners[e].start], tetrahedra[t][edge_corners[e].end]};
      const bool closed = connectivity.for_each_around(t, e, [&](Index face) {
        faces_.push_back(face);
        const Index at = TetrahedralConnectivity::tetrahedron_of(face);
        const auto bit = edge_number[connectivity.corner_of(at, edge[0])][connectivity.corner_of(at, edge[1])];
        seen[at] = static_cast<std::uint8_t>(seen[at] | 1U << bit);
      });
      edges_.push_back(edge);
      begin_.push_back(faces_.size());
      open_.push_back(closed ? 0 : 1);
    }
  }
}

}  // namespace orbicube::mesh
