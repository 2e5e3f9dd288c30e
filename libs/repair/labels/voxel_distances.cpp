#include "repair/labels/voxel_distances.h"

#include <algorithm>
#include <limits>

namespace orbicube::repair {
namespace {

constexpr float far = std::numeric_limits<float>::max();

// The lower envelope of the parabolas value[i] + weight (x - i)^2 of a line, at its places.
class Envelope {
 public:
  Envelope(std::size_t length, std::pmr::memory_resource* memory)
      : vertex_(length, 0, memory), from_(length + 1, 0, memory), value_(length, 0, memory) {}

  void apply(float* line, std::ptrdiff_t stride, std::size_t length, double weight) {
    for (std::size_t i = 0; i < length; ++i)
      value_[i] = line[static_cast<std::ptrdiff_t>(i) * stride];
    std::size_t count = 0;
    for (std::size_t i = 0; i < length; ++i) {
      if (value_[i] == far) continue;
      double from = -std::numeric_limits<double>::infinity();
      while (count > 0) {
        const double at = crossing(vertex_[count - 1], i, weight);
        if (at > from_[count - 1]) {
          from = at;
          break;
        }
        --count;
      }
      vertex_[count] = i;
      from_[count++] = from;
    }
    if (count == 0) return;
    std::size_t k = 0;
    for (std::size_t i = 0; i < length; ++i) {
      while (k + 1 < count && from_[k + 1] <= static_cast<double>(i))
        ++k;
      const double d = static_cast<double>(i) - static_cast<double>(vertex_[k]);
      line[static_cast<std::ptrdiff_t>(i) * stride] = static_cast<float>(value_[vertex_[k]] + weight * d * d);
    }
  }

 private:
  // Where the parabola of j gets below that of i < j.
  double crossing(std::size_t i, std::size_t j, double weight) const {
    const auto x = static_cast<double>(i), y = static_cast<double>(j);
    return 0.5 * (x + y) + (value_[j] - value_[i]) / (2 * weight * (y - x));
  }

  base::Array<std::size_t> vertex_;
  base::Array<double> from_;
  base::Array<double> value_;
};

}  // namespace

base::Array<float> squared_distances(const Voxels& voxels, std::uint8_t kind, const std::array<double, 3>& spacing,
                                     const base::Host& host) {
  base::Array<float> distances(voxels.in.size(), 0, host.memory);
  for (VoxelIndex v = 0; v < voxels.in.size(); ++v)
    distances[v] = voxels.in[v] == kind ? 0 : far;
  Envelope envelope(std::max({voxels.size[0], voxels.size[1], voxels.size[2]}), host.memory);
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis), b = (a + 1) % 3, c = (a + 2) % 3;
    const double weight = spacing[a] * spacing[a];
    for (std::size_t i = 0; i < voxels.size[c]; ++i) {
      host.report("distances", a * voxels.size[c] + i, 3 * voxels.size[c]);
      for (std::size_t j = 0; j < voxels.size[b]; ++j) {
        const std::ptrdiff_t start = static_cast<std::ptrdiff_t>(i) * voxels.stride(static_cast<int>(c)) +
                                     static_cast<std::ptrdiff_t>(j) * voxels.stride(static_cast<int>(b));
        envelope.apply(distances.data() + start, voxels.stride(axis), voxels.size[a], weight);
      }
    }
  }
  return distances;
}

}  // namespace orbicube::repair
