#include "polycube/voxels/local_thickness.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orbicube::polycube {
namespace {

constexpr const char* local_thickness_phase = "voxels";

// Squared distances of the centers of inside cells from the nearest center of an outside cell: one axis after the
// other, the lower envelope of parabolas in each line (Felzenszwalb and Huttenlocher 2012).
Array<float> squared_distances(const VoxelSolid& solid, const base::Host& host) {
  constexpr float infinite = 1e20F;
  Array<float> squared(solid.size(), 0.0F, host.memory);
  for (std::size_t i = 0; i < solid.size(); ++i)
    if (solid.inside(i)) squared[i] = infinite;
  std::size_t longest = 0;
  for (std::size_t a = 0; a < 3; ++a)
    longest = std::max(longest, static_cast<std::size_t>(solid.count(a)));
  Array<float> line(longest, host.memory), ends(longest + 1, host.memory);
  Array<std::size_t> apex(longest, host.memory);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3, stride = solid.stride(axis);
    const auto count = static_cast<std::size_t>(solid.count(axis));
    for (int i = 0; i < solid.count(u); ++i) {
      host.report(local_thickness_phase, 0, 0);
      for (int j = 0; j < solid.count(v); ++j) {
        Cell c{};
        c[u] = i;
        c[v] = j;
        const std::size_t base = solid.place(c);
        for (std::size_t k = 0; k < count; ++k)
          line[k] = squared[base + k * stride];
        std::size_t top = 0;
        apex[0] = 0;
        ends[0] = -infinite;
        ends[1] = infinite;
        for (std::size_t k = 1; k < count; ++k) {
          const auto meet = [&](std::size_t p) {
            const auto x = static_cast<float>(k), y = static_cast<float>(p);
            return ((line[k] + x * x) - (line[p] + y * y)) / (2 * (x - y));
          };
          float at = meet(apex[top]);
          while (top > 0 && at <= ends[top])
            at = meet(apex[--top]);
          apex[++top] = k;
          ends[top] = at;
          ends[top + 1] = infinite;
        }
        for (std::size_t k = 0, p = 0; k < count; ++k) {
          while (ends[p + 1] < static_cast<float>(k))
            ++p;
          const float apart = static_cast<float>(k) - static_cast<float>(apex[p]);
          squared[base + k * stride] = line[apex[p]] + apart * apart;
        }
      }
    }
  }
  return squared;
}

}  // namespace

Array<float> local_thickness(const VoxelSolid& solid, const base::Host& host) {
  const Array<float> squared = squared_distances(solid, host);
  Array<float> thickness(solid.size(), 0.0F, host.memory);
  Array<std::size_t> order(host.memory);
  for (std::size_t i = 0; i < solid.size(); ++i)
    if (solid.inside(i)) order.push_back(i);
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return squared[a] != squared[b] ? squared[a] > squared[b] : a < b; });
  for (std::size_t k = 0; k < order.size(); ++k) {
    const float radius = std::sqrt(squared[order[k]]);
    if (radius < 1.1F * thickness[order[k]]) continue;
    host.report(local_thickness_phase, k, order.size());
    const Cell centre = solid.cell(order[k]);
    const int reach = static_cast<int>(radius);
    std::array<int, 3> low{}, high{};
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = std::max(0, centre[a] - reach);
      high[a] = std::min(solid.count(a) - 1, centre[a] + reach);
    }
    for (int x = low[0]; x <= high[0]; ++x) {
      for (int y = low[1]; y <= high[1]; ++y) {
        for (int z = low[2]; z <= high[2]; ++z) {
          const int dx = x - centre[0], dy = y - centre[1], dz = z - centre[2];
          // Not the outside cells that touch the ball.
          if (static_cast<float>(dx * dx + dy * dy + dz * dz) >= squared[order[k]]) continue;
          float& here = thickness[solid.place({x, y, z})];
          here = std::max(here, radius);
        }
      }
    }
  }
  // Outside: layer by layer.
  Array<std::size_t> front = std::move(order), next(host.memory);
  std::sort(front.begin(), front.end());
  while (!front.empty()) {
    host.report(local_thickness_phase, 0, 0);
    next.clear();
    for (const std::size_t here : front) {
      solid.for_each_neighbor(here, [&](std::size_t there) {
        if (thickness[there] > 0) return;
        thickness[there] = thickness[here];
        next.push_back(there);
      });
    }
    std::swap(front, next);
  }
  return thickness;
}

}  // namespace orbicube::polycube
