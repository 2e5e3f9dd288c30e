// What the report page shows of a polycube map: how much each triangle is distorted.
#pragma once

#include "base/host.h"
#include "polycube/surface/surface_map.h"

namespace orbicube::cli {

struct FaceDistortions {
  explicit FaceDistortions(std::pmr::memory_resource* memory) : quasi_conformal(memory), area_ratio(memory) {}

  base::Array<double> quasi_conformal;  // sigma_max / sigma_min of each triangle; infinite where it has no area
  base::Array<double> area_ratio;  // area on the polycube over area in space, both wholes equal; 0 where that has none
};

FaceDistortions face_distortions(const polycube::SurfaceMap& map, const base::Host& host);

}  // namespace orbicube::cli
