// Points and curves that must be mapped to target positions of a polycube, from a file.
#pragma once

#include <filesystem>
#include <vector>

#include "polycube/features/features.h"
#include "session/session.h"

namespace orbicube::cli {

struct Features {
  std::vector<polycube::FeaturePoint> points;
  std::vector<std::vector<mesh::Index>> vertices;  // of each curve
  std::vector<polycube::FeatureCurve> curves;      // views of them
};

// Reads JSON: an object with "points", each with "vertex" of the surface and "target" on the polycube, and "curves",
// each with "vertices", "from" and "to"; all may have a "weight". Throws Failure.
Features read_features(const std::filesystem::path& path, const base::Host& host);

}  // namespace orbicube::cli
