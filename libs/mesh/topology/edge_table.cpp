#include "mesh/topology/edge_table.h"

#include <algorithm>

#include "base/error.h"

namespace orbicube::mesh {

EdgeTable::EdgeTable(std::size_t vertex_count, std::span<const Triangle> triangles, const base::Host& host)
    : half_edges_(host.memory), edge_begin_(host.memory) {
  constexpr std::size_t items_between_reports = 65536;
  if (triangles.size() > no_index / 3)
    throw base::Error("unsupported", "more triangles than 32-bit half-edges can count");
  // A counting sort by the lower vertex, then a sort of the few that share it by the higher one.
  Array<Index> begin(vertex_count + 1, 0, host.memory);
  const auto for_each_half_edge = [&](const auto& visit) {
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      if (t % items_between_reports == 0) host.report("sorting edges", t, triangles.size());
      if (has_repeated_corner(triangles[t])) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [low, high] = std::minmax(triangles[t][k], triangles[t][(k + 1) % 3]);
        visit(low, high, static_cast<Index>(3 * t + k));
      }
    }
  };
  for_each_half_edge([&](Index low, Index, Index) { ++begin[low + 1]; });
  for (std::size_t v = 0; v < vertex_count; ++v)
    begin[v + 1] += begin[v];
  struct Entry {
    Index high, half_edge;
    bool operator<(const Entry& other) const {
      return high != other.high ? high < other.high : half_edge < other.half_edge;
    }
  };
  Array<Entry> entries(begin[vertex_count], host.memory);
  {
    Array<Index> fill(begin.begin(), begin.end(), host.memory);
    for_each_half_edge([&](Index low, Index high, Index half_edge) { entries[fill[low]++] = {high, half_edge}; });
  }
  half_edges_.reserve(entries.size());
  edge_begin_.reserve(entries.size() / 2 + 1);
  for (std::size_t v = 0; v < vertex_count; ++v) {
    if (v % items_between_reports == 0) host.report("sorting edges", v, vertex_count);
    std::sort(entries.begin() + begin[v], entries.begin() + begin[v + 1]);
    for (Index i = begin[v]; i < begin[v + 1]; ++i) {
      if (i == begin[v] || entries[i].high != entries[i - 1].high) edge_begin_.push_back(i);
      half_edges_.push_back(entries[i].half_edge);
    }
  }
  edge_begin_.push_back(static_cast<Index>(half_edges_.size()));
}

}  // namespace orbicube::mesh
