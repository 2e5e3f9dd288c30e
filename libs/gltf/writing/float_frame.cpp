#include "gltf/writing/float_frame.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "base/error.h"
#include "mesh/formats/formats.h"

namespace orbicube::gltf {
namespace {

// Squares of sizes between these are normal numbers of float32 or close to it, and renderers may flush others to 0.
constexpr double smallest_as_is = 0x1p-100, largest_as_is = 0x1p100;
// Of float32 itself, whose least normal number is 2^-126 and whose largest is below 2^128.
constexpr double min_scale = 0x1p-125, max_scale = 0x1p126;

[[noreturn]] void refuse(double size) {
  std::array<char, 160> text{};
  std::snprintf(text.data(), text.size(),
                "coordinates of about %.3g are beyond float32, which glTF holds: from 1e-37 to 1e37; scale the shape, "
                "or write one of ",
                size);
  throw base::Error("unsupported", text.data() + mesh::format_endings(mesh::Holds::polygons));
}

}  // namespace

double float_scale(double size) {
  if (size == 0 || (size >= smallest_as_is && size <= largest_as_is)) return 1;
  if (!(size >= min_scale && size <= max_scale)) refuse(size);
  return std::ldexp(1.0, std::ilogb(size));
}

FloatFrame float_frame(const mesh::Vector3& low, const mesh::Vector3& high) {
  const double half_size = (0.5 * high - 0.5 * low).maxCoeff();
  const double largest = low.cwiseAbs().cwiseMax(high.cwiseAbs()).maxCoeff();
  FloatFrame frame;
  if (largest <= 32 * half_size) {
    frame.scale = float_scale(largest);
    return frame;
  }
  if (largest > max_scale) refuse(largest);
  frame.translation = 0.5 * low + 0.5 * high;
  frame.scale = float_scale(half_size);
  return frame;
}

base::Array<float> stored_positions(std::span<const mesh::Vector3> positions, const FloatFrame& frame,
                                    std::pmr::memory_resource* memory) {
  base::Array<float> result(memory);
  result.reserve(3 * positions.size());
  for (const mesh::Vector3& p : positions) {
    for (const double x : frame.stored(p))
      result.push_back(static_cast<float>(x));
  }
  return result;
}

}  // namespace orbicube::gltf
