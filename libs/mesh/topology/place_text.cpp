#include "mesh/topology/place_text.h"

#include <array>
#include <cstdio>

namespace orbicube::mesh {

std::string place_text(const Vector3& p) {
  std::array<char, 120> text{};
  std::snprintf(text.data(), text.size(), "(%.9g, %.9g, %.9g)", p[0], p[1], p[2]);
  return text.data();
}

}  // namespace orbicube::mesh
