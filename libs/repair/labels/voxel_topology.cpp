#include "repair/labels/voxel_topology.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/heap.h"
#include "repair/labels/simple_voxel.h"
#include "repair/labels/voxel_distances.h"

namespace orbicube::repair {
namespace {

constexpr std::uint32_t no_part = 0;

struct VoxelParts {
  base::Array<std::uint32_t> number;  // of the part of each voxel, from 1; 0: of the other kind
  base::Array<std::size_t> voxels;    // of each part, from 0
};

constexpr bool shares_face(int n) {
  return n == 4 || n == 10 || n == 12 || n == 14 || n == 16 || n == 22;
}

bool in_outermost_layer(const Voxels& voxels, VoxelIndex v) {
  const auto p = voxels.place(v);
  for (std::size_t a = 0; a < 3; ++a) {
    if (p[a] == 0 || p[a] + 1 == voxels.size[a]) return true;
  }
  return false;
}

// Parts of voxels with in == kind, in the order of their first voxels. Those in the outermost layer are no starts of a
// part.
VoxelParts parts_of(const Voxels& voxels, std::uint8_t kind, bool through_corners, const base::Host& host) {
  VoxelParts parts{base::Array<std::uint32_t>(voxels.in.size(), no_part, host.memory),
                   base::Array<std::size_t>(host.memory)};
  base::Array<VoxelIndex> open(host.memory);
  std::size_t done = 0;
  for (VoxelIndex start = 0; start < voxels.in.size(); ++start) {
    if (start % 65536 == 0) host.report("parts", start, voxels.in.size());
    if (voxels.in[start] != kind || parts.number[start] != no_part || in_outermost_layer(voxels, start)) continue;
    parts.voxels.push_back(0);
    const auto number = static_cast<std::uint32_t>(parts.voxels.size());
    parts.number[start] = number;
    open.assign(1, start);
    while (!open.empty()) {
      const VoxelIndex v = open.back();
      open.pop_back();
      ++parts.voxels.back();
      if (++done % 65536 == 0) host.report("parts", start, voxels.in.size());
      if (in_outermost_layer(voxels, v)) continue;
      for (int n = 0; n < 27; ++n) {
        if (!through_corners && !shares_face(n)) continue;
        const VoxelIndex w = v + static_cast<VoxelIndex>(voxels.offset(n));
        if (voxels.in[w] != kind || parts.number[w] != no_part) continue;
        parts.number[w] = number;
        open.push_back(w);
      }
    }
  }
  return parts;
}

Neighborhood neighborhood(const Voxels& voxels, const std::array<std::ptrdiff_t, 27>& offsets, VoxelIndex v) {
  Neighborhood bits = 0;
  for (std::size_t n = 0; n < 27; ++n)
    bits |= static_cast<Neighborhood>(voxels.in[v + static_cast<VoxelIndex>(offsets[n])]) << n;
  return bits;
}

std::array<std::ptrdiff_t, 27> offsets_of(const Voxels& voxels) {
  std::array<std::ptrdiff_t, 27> offsets{};
  for (int n = 0; n < 27; ++n)
    offsets[static_cast<std::size_t>(n)] = voxels.offset(n);
  return offsets;
}

// Changes voxels, as long as they are simple, from the neighborhood of those in `starts` on, in descending order of
// `order`: those with may_change, which are none of the outermost layer.
void change_simple_voxels(Voxels& voxels, base::Array<std::uint8_t>& may_change, const base::Array<float>& order,
                          const base::Array<VoxelIndex>& starts, const base::Host& host) {
  struct Candidate {
    float order;
    VoxelIndex voxel;
  };
  struct After {
    bool operator()(const Candidate& a, const Candidate& b) const {
      return a.order != b.order ? a.order < b.order : a.voxel > b.voxel;
    }
  };
  enum : std::uint8_t { fixed = 0, changeable = 1, waiting = 2 };
  const std::array<std::ptrdiff_t, 27> offsets = offsets_of(voxels);
  base::Heap<Candidate, After> heap(host.memory);
  const auto push_neighbors = [&](VoxelIndex v) {
    for (const std::ptrdiff_t offset : offsets) {
      const VoxelIndex w = v + static_cast<VoxelIndex>(offset);
      if (may_change[w] != changeable) continue;
      may_change[w] = waiting;
      heap.push({order[w], w});
    }
  };
  for (const VoxelIndex v : starts)
    push_neighbors(v);
  for (std::size_t i = 0; !heap.empty(); ++i) {
    if (i % 4096 == 0) host.report("handles", i, 0);
    const VoxelIndex v = heap.pop().voxel;
    may_change[v] = changeable;
    if (!is_simple(neighborhood(voxels, offsets, v))) continue;  // until a neighbor changes
    voxels.in[v] ^= 1;
    may_change[v] = fixed;
    push_neighbors(v);
  }
}

// The largest object that grows in this one from the deepest voxel of each part and consists of balls.
Voxels grown(const Voxels& object, const std::array<double, 3>& spacing, const base::Host& host) {
  const base::Array<float> depth = squared_distances(object, 0, spacing, host);
  const VoxelParts parts = parts_of(object, 1, false, host);
  base::Array<std::uint8_t> may_change(object.in, host.memory);
  base::Array<VoxelIndex> deepest(parts.voxels.size(), 0, host.memory);  // the outermost layer has depth 0
  for (VoxelIndex v = 0; v < object.in.size(); ++v) {
    if (object.in[v] == 0) continue;
    VoxelIndex& d = deepest[parts.number[v] - 1];
    if (depth[v] > depth[d]) d = v;
  }
  Voxels balls(object.size, host.memory);
  for (const VoxelIndex v : deepest) {
    balls.in[v] = 1;
    may_change[v] = 0;
  }
  change_simple_voxels(balls, may_change, depth, deepest, host);
  return balls;
}

// The smallest object that a box around this one shrinks to and is a ball.
Voxels shrunken(const Voxels& object, const std::array<double, 3>& spacing, const base::Host& host) {
  const base::Array<float> distance = squared_distances(object, 1, spacing, host);
  base::Array<std::uint8_t> may_change(object.in.size(), 0, host.memory);
  base::Array<VoxelIndex> starts(host.memory);
  Voxels ball(object.size, host.memory);
  for (VoxelIndex v = 0; v < object.in.size(); ++v) {
    if (in_outermost_layer(object, v)) continue;
    ball.in[v] = 1;
    may_change[v] = object.in[v] == 0;
    const auto p = object.place(v);
    bool second_layer = false;
    for (std::size_t a = 0; a < 3; ++a)
      second_layer = second_layer || p[a] == 1 || p[a] + 2 == object.size[a];
    if (second_layer) starts.push_back(v);
  }
  change_simple_voxels(ball, may_change, distance, starts, host);
  return ball;
}

std::size_t differences(const Voxels& a, const Voxels& b) {
  std::size_t count = 0;
  for (VoxelIndex v = 0; v < a.in.size(); ++v)
    count += a.in[v] != b.in[v];
  return count;
}

HandleVoxelFigures replace(Voxels& voxels, Voxels& by) {
  HandleVoxelFigures figures;
  for (VoxelIndex v = 0; v < voxels.in.size(); ++v) {
    figures.added_voxels += by.in[v] > voxels.in[v];
    figures.removed_voxels += by.in[v] < voxels.in[v];
  }
  voxels.in = std::move(by.in);
  return figures;
}

}  // namespace

void keep_voxel_parts(Voxels& voxels, std::size_t keep, VoxelPartFigures& figures, const base::Host& host) {
  const VoxelParts parts = parts_of(voxels, 1, false, host);
  figures.found = figures.kept = parts.voxels.size();
  if (keep == 0 || parts.voxels.size() <= keep) return;
  base::Array<std::size_t> by_size(parts.voxels.size(), 0, host.memory);
  for (std::size_t p = 0; p < by_size.size(); ++p)
    by_size[p] = p;
  std::stable_sort(by_size.begin(), by_size.end(),
                   [&](std::size_t a, std::size_t b) { return parts.voxels[a] > parts.voxels[b]; });
  base::Array<std::uint8_t> kept(parts.voxels.size(), 0, host.memory);
  for (std::size_t i = 0; i < keep; ++i)
    kept[by_size[i]] = 1;
  for (std::size_t i = keep; i < by_size.size(); ++i)
    figures.dropped_voxels += parts.voxels[by_size[i]];
  figures.kept = keep;
  for (VoxelIndex v = 0; v < voxels.in.size(); ++v) {
    if (parts.number[v] != no_part) voxels.in[v] = kept[parts.number[v] - 1];
  }
}

void fill_cavities(Voxels& voxels, VoxelPartFigures& figures, const base::Host& host) {
  const VoxelParts parts = parts_of(voxels, 0, true, host);
  const std::uint32_t outside =
      parts.number[0];  // of the first part that reaches the outermost layer; all others are cavities
  for (VoxelIndex v = 0; v < voxels.in.size(); ++v) {
    if (voxels.in[v] != 0 || parts.number[v] == outside || in_outermost_layer(voxels, v)) continue;
    voxels.in[v] = 1;
    ++figures.filled_voxels;
  }
  figures.cavities = parts.voxels.size() - 1;
}

HandleVoxelFigures remove_handles(Voxels& voxels, const std::array<double, 3>& spacing, const base::Host& host) {
  if (euler_characteristic(voxels) == 1) return {};
  base::Stage stage(host, 0.8);
  const Voxels filled = shrunken(voxels, spacing, host);
  Voxels closings(voxels.size, host.memory);
  for (VoxelIndex v = 0; v < voxels.in.size(); ++v)
    closings.in[v] = filled.in[v] & (voxels.in[v] ^ 1);
  const VoxelParts tunnels = parts_of(closings, 1, true, host);
  Voxels best = grown(voxels, spacing, host);
  std::size_t least = differences(best, voxels), tried = 0;
  // The limits of size that change what is closed, the sizes doubled.
  for (std::size_t limit = 1; least > 0; limit *= 2) {
    std::size_t closed = 0;
    for (const std::size_t size : tunnels.voxels)
      closed += size <= limit ? size : 0;
    if (closed == tried || closed >= least) {
      if (limit > *std::max_element(tunnels.voxels.begin(), tunnels.voxels.end())) break;
      continue;
    }
    tried = closed;
    Voxels candidate(voxels.size, host.memory);
    for (VoxelIndex v = 0; v < voxels.in.size(); ++v) {
      const std::uint32_t tunnel = tunnels.number[v];
      candidate.in[v] = voxels.in[v] | (tunnel != no_part && tunnels.voxels[tunnel - 1] <= limit);
    }
    VoxelPartFigures ignored;
    fill_cavities(candidate, ignored, host);
    if (euler_characteristic(candidate) != 1) candidate = grown(candidate, spacing, host);
    const std::size_t changes = differences(candidate, voxels);
    if (changes < least) {
      least = changes;
      best = std::move(candidate);
    }
  }
  return replace(voxels, best);
}

HandleVoxelFigures cut_handles(Voxels& voxels, const std::array<double, 3>& spacing, const base::Host& host) {
  Voxels balls = grown(voxels, spacing, host);
  return replace(voxels, balls);
}

// Counts of the complex whose vertices are voxels, edges pairs that share a face, squares four around an edge, cubes
// eight around a corner: it has the topology of the object connected through faces.
std::int64_t euler_characteristic(const Voxels& voxels) {
  std::int64_t sum = 0;
  const auto sx = static_cast<VoxelIndex>(voxels.stride(0)), sy = static_cast<VoxelIndex>(voxels.stride(1)),
             sz = static_cast<VoxelIndex>(voxels.stride(2));
  for (VoxelIndex v = 0; v < voxels.in.size(); ++v) {
    if (voxels.in[v] == 0) continue;  // none in the outermost layer
    const int x = voxels.in[v + sx], y = voxels.in[v + sy], z = voxels.in[v + sz];
    const int xy = x & y & voxels.in[v + sx + sy], yz = y & z & voxels.in[v + sy + sz],
              xz = x & z & voxels.in[v + sx + sz];
    const int xyz = xy & yz & xz & voxels.in[v + sx + sy + sz];
    sum += 1 - x - y - z + xy + yz + xz - xyz;
  }
  return sum;
}

}  // namespace orbicube::repair
