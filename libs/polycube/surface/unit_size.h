// Maps of extreme size are worked on at a size near 1, where products of lengths neither overflow nor vanish.
#pragma once

#include <cstdlib>

#include "mesh/search/unit_scale.h"
#include "polycube/surface/surface_map.h"

namespace orbicube::polycube {

// Scales a map by a power of two for as long as this lives, surface and polycube alike. Sizes of 1e-30 to 1e30 stay as
// they are. Exact but for what is below the smallest normal number.
class AtUnitSize {
 public:
  explicit AtUnitSize(SurfaceMap& map) : map_(map) {
    constexpr int ordinary = 100;
    const int exponent = mesh::unit_scale_exponent(map.positions, map.triangles);
    if (std::abs(exponent) > ordinary) exponent_ = exponent;
    scale(exponent_);
  }
  AtUnitSize(const AtUnitSize&) = delete;
  AtUnitSize& operator=(const AtUnitSize&) = delete;
  ~AtUnitSize() { scale(-exponent_); }

  int exponent() const { return exponent_; }

 private:
  void scale(int exponent) const {
    mesh::scale_by_power(map_.positions, exponent);
    mesh::scale_by_power(map_.polycube, exponent);
  }

  SurfaceMap& map_;
  int exponent_ = 0;
};

}  // namespace orbicube::polycube
