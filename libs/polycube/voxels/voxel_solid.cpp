#include "polycube/voxels/voxel_solid.h"

#include <algorithm>
#include <bit>

#include "base/error.h"

namespace orbicube::polycube {
namespace {

constexpr const char* voxel_solid_phase = "voxels";

// Whether a set of the eight cells around a vertex hangs together through faces.
constexpr bool connected(unsigned cells) {
  if (cells == 0) return true;
  unsigned reached = cells & (~cells + 1);
  for (unsigned before = 0; before != reached;) {
    before = reached;
    for (unsigned b = 0; b < 8; ++b) {
      if (!(reached >> b & 1)) continue;
      for (unsigned axis = 0; axis < 3; ++axis)
        reached |= (1U << (b ^ (1U << axis))) & cells;
    }
  }
  return reached == cells;
}

// The four cells around one of the six grid edges at a vertex, in cyclic order, as bits 0 to 3.
constexpr unsigned around_edge(unsigned cells, unsigned axis, unsigned side) {
  const unsigned u = 1U << (axis + 1) % 3, v = 1U << (axis + 2) % 3, base = side << axis;
  return (cells >> base & 1) | (cells >> (base | u) & 1) << 1 | (cells >> (base | u | v) & 1) << 2 |
         (cells >> (base | v) & 1) << 3;
}

struct Tables {
  std::array<bool, 256> manifold{}, corner{};

  constexpr Tables() {
    for (unsigned cells = 0; cells < 256; ++cells) {
      bool checkered = false;
      int edges = 0;
      for (unsigned axis = 0; axis < 3; ++axis) {
        for (unsigned side = 0; side < 2; ++side) {
          const unsigned four = around_edge(cells, axis, side);
          if (four == 5 || four == 10) checkered = true;
          const int in = std::popcount(four);
          if (in == 1 || in == 3) ++edges;
        }
      }
      manifold[cells] = !checkered && connected(cells) && connected(255U & ~cells);
      corner[cells] = edges >= 3;
    }
  }
};
constexpr Tables tables;

}  // namespace

VoxelSolid::VoxelSolid(std::array<Array<double>, 3> planes, std::pmr::memory_resource* memory)
    : planes_(std::move(planes)), count_y_(planes_[1].size() - 1), count_z_(planes_[2].size() - 1), inside_(memory) {
  for (const auto& p : planes_)
    base::require(p.size() >= 4, "a solid of voxels needs three layers an axis");
  inside_.assign((planes_[0].size() - 1) * count_y_ * count_z_, 0);
}

unsigned VoxelSolid::configuration(const Cell& vertex) const {
  const std::size_t base = place({vertex[0] - 1, vertex[1] - 1, vertex[2] - 1});
  const std::size_t x = count_y_ * count_z_, y = count_z_;
  return static_cast<unsigned>(inside_[base] | inside_[base + x] << 1 | inside_[base + y] << 2 |
                               inside_[base + x + y] << 3 | inside_[base + 1] << 4 | inside_[base + x + 1] << 5 |
                               inside_[base + y + 1] << 6 | inside_[base + x + y + 1] << 7);
}

bool VoxelSolid::manifold(unsigned configuration) {
  return tables.manifold[configuration];
}

bool VoxelSolid::corner(unsigned configuration) {
  return tables.corner[configuration];
}

bool VoxelSolid::flip_if_simple(const Cell& cell, std::int64_t& corners) {
  if (in_outermost_layer(cell)) return false;
  const std::size_t here = place(cell);
  // Bits 2a and 2a + 1: whether the faces below and above along axis a are exposed.
  unsigned exposed = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    exposed |= static_cast<unsigned>(inside_[here - stride(a)] != inside_[here]) << (2 * a);
    exposed |= static_cast<unsigned>(inside_[here + stride(a)] != inside_[here]) << (2 * a + 1);
  }
  // A set of faces of a cube hangs together unless it is empty or a pair of opposite ones.
  const auto joined = [](unsigned faces) { return faces != 0 && faces != 3 && faces != 12 && faces != 48; };
  if (!joined(exposed) || !joined(63U & ~exposed)) return false;
  std::int64_t change = 0;
  const auto vertex = [&](unsigned b) {
    return Cell{cell[0] + static_cast<int>(b & 1), cell[1] + static_cast<int>(b >> 1 & 1),
                cell[2] + static_cast<int>(b >> 2 & 1)};
  };
  for (unsigned b = 0; b < 8; ++b)
    change -= tables.corner[configuration(vertex(b))];
  inside_[here] ^= 1;
  for (unsigned b = 0; b < 8; ++b) {
    const unsigned after = configuration(vertex(b));
    if (!tables.manifold[after]) {
      inside_[here] ^= 1;
      return false;
    }
    change += tables.corner[after];
  }
  corners += change;
  return true;
}

int VoxelSolid::bad_vertices(const Cell& cell) const {
  int bad = 0;
  for (int b = 0; b < 8; ++b)
    bad += !tables.manifold[configuration({cell[0] + (b & 1), cell[1] + (b >> 1 & 1), cell[2] + (b >> 2 & 1)})];
  return bad;
}

std::size_t VoxelSolid::corners() const {
  std::size_t corners = 0;
  for (int x = 1; x < count(0); ++x)
    for (int y = 1; y < count(1); ++y)
      for (int z = 1; z < count(2); ++z)
        corners += tables.corner[configuration({x, y, z})];
  return corners;
}

std::size_t VoxelSolid::components(bool inside, Array<Index>& marks, Array<std::size_t>& sizes,
                                   const base::Host& host) const {
  marks.assign(size(), no_index);
  sizes.clear();
  Array<std::size_t> waiting(marks.get_allocator().resource());
  for (std::size_t first = 0; first < size(); ++first) {
    if ((inside_[first] != 0) != inside || marks[first] != no_index) continue;
    const auto component = static_cast<Index>(sizes.size());
    sizes.push_back(0);
    marks[first] = component;
    waiting.push_back(first);
    while (!waiting.empty()) {
      const std::size_t here = waiting.back();
      waiting.pop_back();
      if (++sizes[component] % 65536 == 0) host.report(voxel_solid_phase, 0, 0);
      const Cell c = cell(here);
      for (std::size_t a = 0; a < 3; ++a) {
        for (const int step : {-1, 1}) {
          if (c[a] + step < 0 || c[a] + step >= count(a)) continue;
          const std::size_t there = neighbor(here, a, step);
          if ((inside_[there] != 0) != inside || marks[there] != no_index) continue;
          marks[there] = component;
          waiting.push_back(there);
        }
      }
    }
  }
  return sizes.size();
}

VoxelTopology VoxelSolid::topology(const base::Host& host) const {
  VoxelTopology result;
  std::int64_t vertices = 0, edges = 0, faces = 0;
  for (int x = 1; x < count(0); ++x) {
    host.report(voxel_solid_phase, 0, 0);
    for (int y = 1; y < count(1); ++y) {
      for (int z = 1; z < count(2); ++z) {
        const unsigned cells = configuration({x, y, z});
        if (cells == 0 || cells == 255) continue;
        if (!tables.manifold[cells]) ++result.bad_vertices;
        ++vertices;
        // Each edge is counted at its lower vertex, each face as the one between the highest cell and the one below it
        // along an axis.
        for (unsigned axis = 0; axis < 3; ++axis) {
          const int in = std::popcount(around_edge(cells, axis, 1));
          edges += in > 0 && in < 4;
          faces += (cells >> 7 & 1) != (cells >> (7U ^ 1U << axis) & 1);
        }
      }
    }
  }
  result.genus = (2 - (vertices - edges + faces)) / 2;
  if (result.bad_vertices > 0) return result;
  auto* memory = inside_.get_allocator().resource();
  Array<Index> marks(memory);
  Array<std::size_t> sizes(memory);
  result.inside_components = components(true, marks, sizes, host);
  result.outside_components = components(false, marks, sizes, host);
  return result;
}

void VoxelSolid::keep_largest(bool inside, const base::Host& host) {
  auto* memory = inside_.get_allocator().resource();
  Array<Index> marks(memory);
  Array<std::size_t> sizes(memory);
  if (components(inside, marks, sizes, host) < 2) return;
  const auto largest = static_cast<Index>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
  for (std::size_t i = 0; i < size(); ++i)
    if (marks[i] != no_index && marks[i] != largest) inside_[i] ^= 1;
}

}  // namespace orbicube::polycube
