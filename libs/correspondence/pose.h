// Shapes of a morph brought to where the first one stands, at its size.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "mesh/mesh.h"

namespace orbicube::correspondence {

enum class Pose {
  kept = 0,    // as the shapes are
  turned = 1,  // translated and rotated to the least-squares fit with the first
  scaled = 2,  // scaled as well
};

// A point x goes to scale * rotation * x + shift.
struct Similarity {
  double scale = 1;
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  mesh::Vector3 shift = mesh::Vector3::Zero();
};

// Moves and rotates the further states (and scales them) so that the mean of the squared distances between points that
// correspond, weighted by area, is minimum (Umeyama 1991). Returns what each state was moved by.
std::vector<Similarity> place(Pose pose, std::span<const mesh::Triangle> triangles,
                              std::span<base::Array<mesh::Vector3>> states);

}  // namespace orbicube::correspondence
