#include "repair/labels/crossings.h"

#include <algorithm>
#include <cmath>

namespace orbicube::repair {
namespace {

// The Gaussian is cut off at this many standard deviations: larger changes no crossing by more than 1e-3.
constexpr double cut_off = 3;
// Voxels around an edge whose values give the level. Larger: walls of different thickness share a level and the thin
// ones lose volume; smaller: the level follows the steps of the voxels, which stay visible.
constexpr std::size_t level_radius = 2;

base::Array<float> weights_of(double deviation, std::pmr::memory_resource* memory) {
  const auto radius = static_cast<std::size_t>(std::ceil(cut_off * deviation));
  base::Array<float> weights(radius + 1, 0, memory);
  double sum = 0;
  for (std::size_t i = 0; i <= radius; ++i) {
    const double x = static_cast<double>(i) / deviation, weight = std::exp(-0.5 * x * x);
    weights[i] = static_cast<float>(weight);
    sum += i == 0 ? weight : 2 * weight;
  }
  for (float& weight : weights)
    weight = static_cast<float>(weight / sum);
  return weights;
}

// Smooths the lines of one axis; beyond the box is background.
void smooth_line(float* line, std::size_t stride, std::size_t length, const base::Array<float>& weights,
                 base::Array<float>& padded) {
  const std::size_t radius = weights.size() - 1;
  padded.assign(length + 2 * radius, 0);
  bool any = false;
  for (std::size_t i = 0; i < length; ++i) {
    padded[radius + i] = line[i * stride];
    any = any || padded[radius + i] != 0;
  }
  if (!any) return;
  for (std::size_t i = 0; i < length; ++i) {
    const float* at = padded.data() + radius + i;
    float sum = weights[0] * *at;
    for (std::size_t k = 1; k <= radius; ++k)
      sum += weights[k] * (*(at - k) + at[k]);
    line[i * stride] = sum;
  }
}

}  // namespace

SmoothedVoxels::SmoothedVoxels(const Voxels& voxels, double deviation, const base::Host& host)
    : voxels_(voxels), value_(voxels.in.begin(), voxels.in.end(), host.memory) {
  if (!(deviation > 0)) return;
  const base::Array<float> weights = weights_of(deviation, host.memory);
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
    const auto stride = [&](std::size_t axis) {
      return static_cast<std::size_t>(voxels.stride(static_cast<int>(axis)));
    };
    // A few planes of lines at a time, so that cancelling is quick.
    constexpr std::size_t planes = 8;
    for (std::size_t first = 0; first < voxels.size[c]; first += planes) {
      host.report("smoothing", a * voxels.size[c] + first, 3 * voxels.size[c]);
      host.parallel_for(std::min(planes, voxels.size[c] - first), [&](std::size_t i) {
        base::Array<float> padded(std::pmr::get_default_resource());
        for (std::size_t j = 0; j < voxels.size[b]; ++j)
          smooth_line(value_.data() + (first + i) * stride(c) + j * stride(b), stride(a), voxels.size[a], weights,
                      padded);
      });
    }
  }
}

double SmoothedVoxels::level(VoxelIndex v, int axis) const {
  std::array<std::size_t, 3> first = voxels_.place(v), last = first;
  ++last[static_cast<std::size_t>(axis)];
  for (std::size_t a = 0; a < 3; ++a) {
    first[a] -= std::min(first[a], level_radius);
    last[a] = std::min(last[a] + level_radius, voxels_.size[a] - 2);  // the outermost layer is background
  }
  double sum = 0;
  std::size_t count = 0;
  const std::array<std::size_t, 3> strides = {1, voxels_.size[0], voxels_.size[0] * voxels_.size[1]};
  for (std::size_t z = first[2]; z <= last[2]; ++z) {
    for (std::size_t y = first[1]; y <= last[1]; ++y) {
      const VoxelIndex row = voxels_.index(0, y, z);
      for (VoxelIndex w = row + first[0]; w <= row + last[0]; ++w) {
        for (const std::size_t stride : strides) {
          if (voxels_.in[w] == voxels_.in[w + stride]) continue;
          sum += 0.5 * (static_cast<double>(value_[w]) + static_cast<double>(value_[w + stride]));
          ++count;
        }
      }
    }
  }
  return sum / static_cast<double>(count);
}

double SmoothedVoxels::crossing(VoxelIndex v, int axis, double max_slide) const {
  const double from = value_[v], to = value_[v + static_cast<VoxelIndex>(voxels_.stride(axis))];
  const bool starts_inside = voxels_.in[v] != 0;
  // Where smoothing reversed the order of both values, the boundary is midway.
  if (starts_inside ? !(from > to) : !(to > from)) return 0.5;
  const double t = (from - level(v, axis)) / (from - to);
  return std::clamp(t, 0.5 - max_slide, 0.5 + max_slide);
}

}  // namespace orbicube::repair
