// Places the surfaces of a group so that a difference in one place does not move them elsewhere. A least-squares fit
// distributes a local difference over the whole shape; this one follows where the group varies least.
#pragma once

#include <span>

#include "correspondence/study/group_pose.h"

namespace orbicube::correspondence {

// Moves the shapes, whose points are the vertices of these triangles, by translations and rotations that minimize the
// squared distances from their mean along its normals (Chen and Medioni 1992), each point weighted by the inverse of
// its variance in the group (maximum likelihood, Theobald and Wuttke 2006). Distances along normals ignore that maps
// move points along the surface. The mean stands where the first shape stood. Throws as place_group does. The same bits
// for any number of threads.
GroupPose place_robustly(Population& shapes, std::span<const mesh::Triangle> triangles, const base::Host& host);

// Returns unit normals of the mean of the shapes, one a point.
base::Array<mesh::Vector3> normals_of_mean(const Population& shapes, std::span<const mesh::Triangle> triangles,
                                           const base::Host& host);

}  // namespace orbicube::correspondence
