// Requests for the features of a surface that the tests share.
#pragma once

#include "hexmesh/captured/feature_surface.h"

namespace orbicube::hexmesh::test {

inline const FeatureRequest by_angles = {Features::angles, 40, {}, {}};

}  // namespace orbicube::hexmesh::test
