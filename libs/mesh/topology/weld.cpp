#include "mesh/topology/weld.h"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "mesh/topology/edge_table.h"

namespace orbicube::mesh {
namespace {

// Mixes the bits of three coordinates, as the finalizer of SplitMix64 (Steele, Lea, Flood 2014) does with one number.
std::uint64_t hash_of(const Vector3& position) {
  std::uint64_t hash = 0;
  for (const double coordinate : position) {
    hash ^= std::bit_cast<std::uint64_t>(coordinate + 0.0);  // -0 + 0 is 0
    hash = (hash ^ (hash >> 30U)) * 0xBF58476D1CE4E5B9U;
    hash = (hash ^ (hash >> 27U)) * 0x94D049BB133111EBU;
    hash ^= hash >> 31U;
  }
  return hash;
}

template <class Cells>
void renumber(Cells& cells, std::span<const Index> to) {
  for (auto& cell : cells) {
    for (Index& v : cell)
      v = to[v];
  }
}

// Removes triangles that get a repeated corner, and returns how many.
std::size_t remove_collapsed(Mesh& mesh, std::span<const Index> to) {
  Array<std::int32_t>& regions = mesh.regions.triangles;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle t = mesh.triangles[i];
    if (!has_repeated_corner(t) && has_repeated_corner({to[t[0]], to[t[1]], to[t[2]]})) continue;
    if (!regions.empty()) regions[kept] = regions[i];
    mesh.triangles[kept++] = t;
  }
  const std::size_t removed = mesh.triangles.size() - kept;
  mesh.triangles.resize(kept);
  if (!regions.empty()) regions.resize(kept);
  return removed;
}

}  // namespace

Array<Index> first_at_same_position(std::span<const Vector3> positions, const base::Host& host) {
  // An open-addressing table of vertices, at most half full.
  const std::size_t slots = std::bit_ceil(std::max<std::size_t>(2 * positions.size(), 2));
  Array<Index> table(slots, no_index, host.memory);
  Array<Index> first(positions.size(), host.memory);
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (v % 65536 == 0) host.report("vertices at the same position", v, positions.size());
    std::size_t slot = hash_of(positions[v]) & (slots - 1);
    while (table[slot] != no_index && positions[table[slot]] != positions[v])
      slot = (slot + 1) & (slots - 1);
    if (table[slot] == no_index) table[slot] = static_cast<Index>(v);
    first[v] = table[slot];
  }
  return first;
}

WeldReport weld(Mesh& mesh, const base::Host& host) {
  WeldReport report;
  Array<Index> to = first_at_same_position(mesh.positions, host);
  Index kept = 0;
  for (std::size_t v = 0; v < to.size(); ++v) {
    if (to[v] == v) {
      mesh.positions[kept] = mesh.positions[v];
      to[v] = kept++;
    } else {
      to[v] = to[to[v]];  // which has its new number already
      ++report.vertices;
    }
  }
  if (report.vertices == 0) return report;
  mesh.positions.resize(kept);
  report.triangles = remove_collapsed(mesh, to);
  renumber(mesh.triangles, to);
  renumber(mesh.tetrahedra, to);
  renumber(mesh.hexahedra, to);
  return report;
}

}  // namespace orbicube::mesh
