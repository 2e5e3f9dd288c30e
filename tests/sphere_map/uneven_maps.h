// Maps to the sphere that are hard for an inverse.
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "base/host.h"
#include "mesh/shapes/make_shape.h"
#include "sphere_map/optimization/measure.h"
#include "sphere_map/sphere_map.h"

namespace orbicube::test {

struct MappedShape {
  mesh::Mesh surface;
  base::Array<mesh::Vector3> directions;
};

// A shape that is made here, and its map.
inline MappedShape mapped(const char* name, std::size_t triangles, std::uint64_t seed = 0) {
  MappedShape result;
  result.surface = mesh::make_shape(name, {.triangles = triangles, .seed = seed}, base::Host());
  result.directions = sphere_map::compute(result.surface.positions, result.surface.triangles, {}, base::Host());
  return result;
}

// Adds a vertex near the first corner of the triangle, then one in the triangle that this leaves at the corner, and so
// on: each is `factor` times as large as the one before. As many as stay positive, at most `levels`.
inline void nest(std::vector<mesh::Triangle>& triangles, std::vector<mesh::Vector3>& directions, std::size_t triangle,
                 double factor, int levels) {
  for (int level = 0; level < levels; ++level) {
    const auto [a, b, c] = triangles[triangle];
    const mesh::Vector3& p = directions[a];
    const mesh::Vector3 added = (p + factor * ((directions[b] - p) + (directions[c] - p)) / 2).normalized();
    const auto v = static_cast<mesh::Index>(directions.size());
    directions.push_back(added);
    const std::vector<mesh::Triangle> parts{{v, b, c}, {a, v, c}, {a, b, v}};
    if (sphere_map::count_not_positive(parts, directions) > 0) {
      directions.pop_back();
      return;
    }
    triangles[triangle] = parts[0];
    triangles.push_back(parts[1]);
    triangles.push_back(parts[2]);
    triangle = level % 2 == 0 ? triangles.size() - 1 : triangles.size() - 2;
  }
}

inline mesh::Vector3 random_direction(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return mesh::Vector3(normal(random), normal(random), normal(random)).normalized();
}

}  // namespace orbicube::test
