#include "mesh/topology/edge_table.h"

#include <algorithm>

#include "base/error.h"
#include "base/grouping.h"

namespace orbicube::mesh {

EdgeTable::EdgeTable(std::size_t vertex_count, std::span<const Triangle> triangles, const base::Host& host)
    : half_edges_(host.memory), edge_begin_(host.memory) {
  if (triangles.size() > no_index / 3)
    throw base::Error("unsupported", "more triangles than 32-bit half-edges can count");
  struct Entry {
    Index high, half_edge;
    bool operator<(const Entry& other) const {
      return high != other.high ? high < other.high : half_edge < other.half_edge;
    }
  };
  // A counting sort by the lower vertex, then a sort of the few that share it by the higher one.
  const auto for_each_half_edge = [&](const auto& visit) {
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      if (t % base::items_between_reports == 0) host.report("sorting edges", t, triangles.size());
      if (has_repeated_corner(triangles[t])) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [low, high] = std::minmax(triangles[t][k], triangles[t][(k + 1) % 3]);
        visit(low, Entry{high, static_cast<Index>(3 * t + k)});
      }
    }
  };
  base::Groups<Entry, Index> by_lower(vertex_count, for_each_half_edge, host.memory);
  half_edges_.reserve(by_lower.all().size());
  edge_begin_.reserve(by_lower.all().size() / 2 + 1);
  for (std::size_t v = 0; v < vertex_count; ++v) {
    if (v % base::items_between_reports == 0) host.report("sorting edges", v, vertex_count);
    const std::span<Entry> entries = by_lower[v];
    std::sort(entries.begin(), entries.end());
    for (std::size_t i = 0; i < entries.size(); ++i) {
      if (i == 0 || entries[i].high != entries[i - 1].high)
        edge_begin_.push_back(static_cast<Index>(half_edges_.size()));
      half_edges_.push_back(entries[i].half_edge);
    }
  }
  edge_begin_.push_back(static_cast<Index>(half_edges_.size()));
}

}  // namespace orbicube::mesh
