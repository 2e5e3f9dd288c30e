#include "mesh/files/float_positions.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace orbicube::mesh {

float to_float(double x, const char* format) {
  const auto result = static_cast<float>(x);
  if (!std::isfinite(result)) {
    throw base::Error("unsupported", std::string("a coordinate is too large for float32, which ") + format + " holds");
  }
  return result;
}

void require_float_resolution(const Mesh& mesh, const char* format, const std::string& others) {
  if (mesh.triangles.empty()) return;
  Vector3 low = mesh.positions[mesh.triangles[0][0]], high = low;
  double moved = 0;
  for (const Triangle& t : mesh.triangles) {
    for (const Index v : t) {
      low = low.cwiseMin(mesh.positions[v]);
      high = high.cwiseMax(mesh.positions[v]);
      for (const double x : mesh.positions[v])
        moved = std::max(moved, std::abs(x - static_cast<double>(to_float(x, format))));
    }
  }
  constexpr double visible = 1e-3;  // of the size; what is just seen in a picture
  const double size = 2 * (0.5 * high - 0.5 * low).maxCoeff();
  if (moved <= visible * size) return;
  throw base::Error("unsupported", std::string("float32, which ") + format + " holds, would move vertices by " +
                                       std::to_string(std::lround(std::min(100.0, 100 * moved / size))) +
                                       " % of the size; " + others);
}

}  // namespace orbicube::mesh
