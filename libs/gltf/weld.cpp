#include "gltf/weld.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace orbicube::gltf {

namespace {

using mesh::Index;
using mesh::Triangle;
using mesh::Vector3;

constexpr std::size_t items_between_reports = std::size_t{1} << 16U;

// -0 and 0 are the same place; the sum makes them the same bits.
std::uint64_t bits_of(double coordinate) {
  return std::bit_cast<std::uint64_t>(coordinate + 0.0);
}

// Mixes the bits of three coordinates (multiplication and folding, as in the finaliser of SplitMix64).
std::uint64_t hash_of(const Vector3& position) {
  std::uint64_t hash = 0;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    hash = (hash ^ bits_of(position[axis])) * 0xBF58476D1CE4E5B9U;
    hash ^= hash >> 29U;
  }
  hash *= 0x94D049BB133111EBU;
  return hash ^ (hash >> 32U);
}

// For each vertex the number of the first vertex at its place. An open-addressing table of vertex numbers.
base::Array<Index> first_at_same_place(std::span<const Vector3> positions, const base::Host& host) {
  const std::size_t slots = std::bit_ceil(std::max<std::size_t>(2 * positions.size(), 2));
  base::Array<Index> table(slots, mesh::no_index, host.memory);
  base::Array<Index> first(positions.size(), host.memory);
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (v % items_between_reports == 0) host.report("joining vertices", v, positions.size());
    std::size_t slot = hash_of(positions[v]) & (slots - 1);
    while (table[slot] != mesh::no_index && positions[table[slot]] != positions[v])
      slot = (slot + 1) & (slots - 1);
    if (table[slot] == mesh::no_index) table[slot] = static_cast<Index>(v);
    first[v] = table[slot];
  }
  return first;
}

bool has_equal_corners(const Triangle& t) {
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

}  // namespace

bool is_closed(std::span<const Triangle> triangles, std::size_t vertex_count, const base::Host& host) {
  // Each edge is kept at its smaller end: the larger end and, in the lowest bit, the direction. Counting sort.
  base::Array<std::size_t> begin(vertex_count + 1, std::size_t{0}, host.memory);
  const auto for_each_edge = [&](const char* phase, const auto& visit) {
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      if (t % items_between_reports == 0) host.report(phase, t, triangles.size());
      for (std::size_t corner = 0; corner < 3; ++corner)
        visit(triangles[t][corner], triangles[t][corner == 2 ? 0 : corner + 1]);
    }
  };
  for_each_edge("counting edges", [&](Index from, Index to) { ++begin[std::min(from, to) + std::size_t{1}]; });
  for (std::size_t v = 0; v < vertex_count; ++v)
    begin[v + 1] += begin[v];
  base::Array<std::uint64_t> edges(3 * triangles.size(), host.memory);
  base::Array<std::size_t> end(begin.begin(), begin.end() - 1, host.memory);
  for_each_edge("sorting edges", [&](Index from, Index to) {
    edges[end[std::min(from, to)]++] = std::uint64_t{std::max(from, to)} << 1U | (from < to ? 1U : 0U);
  });
  for (std::size_t v = 0; v < vertex_count; ++v) {
    if (v % items_between_reports == 0) host.report("matching edges", v, vertex_count);
    const auto first = edges.begin() + static_cast<std::ptrdiff_t>(begin[v]);
    const auto last = edges.begin() + static_cast<std::ptrdiff_t>(begin[v + 1]);
    std::sort(first, last);
    for (auto edge = first; edge != last;) {
      std::ptrdiff_t balance = 0;
      const std::uint64_t other = *edge >> 1U;
      for (; edge != last && *edge >> 1U == other; ++edge)
        balance += (*edge & 1U) != 0 ? 1 : -1;
      if (balance != 0 && other != v) return false;
    }
  }
  return true;
}

WeldReport weld(mesh::Mesh& surface, const base::Host& host) {
  const base::Array<Index> first = first_at_same_place(surface.positions, host);
  base::Array<Index> renumbered(first.size(), host.memory);
  WeldReport report;
  Index kept = 0;
  for (std::size_t v = 0; v < first.size(); ++v) {
    if (first[v] != v) {
      renumbered[v] = renumbered[first[v]];
      ++report.vertices;
      continue;
    }
    surface.positions[kept] = surface.positions[v];
    renumbered[v] = kept++;
  }
  if (report.vertices == 0) return report;
  surface.positions.resize(kept);
  std::size_t to = 0;
  for (const Triangle& triangle : surface.triangles) {
    const Triangle welded = {renumbered[triangle[0]], renumbered[triangle[1]], renumbered[triangle[2]]};
    if (has_equal_corners(welded) && !has_equal_corners(triangle)) {
      ++report.triangles;
    } else {
      surface.triangles[to++] = welded;
    }
  }
  surface.triangles.resize(to);
  return report;
}

}  // namespace orbicube::gltf
