// Normals of a surface that has flowed towards a sphere for a while: small features no longer turn them.
#pragma once

#include <span>

#include "polycube/surface/surface.h"

namespace orbicube::polycube {

// Conformalized mean curvature flow (Kazhdan, Solomon and Ben-Chen 2012): implicit steps, the first of length `time`
// (for a surface of unit area), each twice as long as the one before. The positions keep area and center.
void flow(const Surface& surface, double time, int steps, std::span<Vector3> positions, const base::Host& host);

}  // namespace orbicube::polycube
