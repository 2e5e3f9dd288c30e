// Surfaces to fill, and what must hold of a solid.
#pragma once

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "base/error.h"
#include "mesh/search/measures.h"
#include "mesh/search/tetrahedron_quality.h"
#include "mesh/shapes/make_shape.h"
#include "mesh/topology/cells.h"
#include "tests/base/quiet_host.h"
#include "tetrahedra/tetrahedra.h"

namespace orbicube::test {

struct Surface {
  std::vector<mesh::Vector3> positions;
  std::vector<mesh::Triangle> triangles;

  Surface() = default;
  explicit Surface(const mesh::Mesh& mesh)
      : positions(mesh.positions.begin(), mesh.positions.end()),
        triangles(mesh.triangles.begin(), mesh.triangles.end()) {}

  // Adds another, scaled and moved, its triangles turned round if requested.
  void add(const Surface& other, double scale, const mesh::Vector3& shift, bool turned = false) {
    const auto first = static_cast<mesh::Index>(positions.size());
    for (const mesh::Vector3& p : other.positions)
      positions.push_back(scale * p + shift);
    for (mesh::Triangle t : other.triangles) {
      for (mesh::Index& v : t)
        v += first;
      if (turned) std::swap(t[1], t[2]);
      triangles.push_back(t);
    }
  }
};

inline Surface made(const char* shape, std::size_t triangles) {
  return Surface(mesh::make_shape(shape, {.triangles = triangles, .seed = 1}, host));
}

// The box from `low` to `high`, of twelve triangles.
inline Surface box(const mesh::Vector3& low, const mesh::Vector3& high) {
  Surface result;
  for (int i = 0; i < 8; ++i)
    result.positions.push_back({i & 1 ? high[0] : low[0], i & 2 ? high[1] : low[1], i & 4 ? high[2] : low[2]});
  result.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return result;
}

inline tetrahedra::Solid filled(const Surface& surface, const tetrahedra::Options& options = {},
                                const base::Host& with = host) {
  return tetrahedra::fill(surface.positions, surface.triangles, options, with);
}

// The kind of the error that filling ends with; empty for none.
inline std::string refusal(const Surface& surface, const tetrahedra::Options& options = {}) {
  try {
    filled(surface, options);
  } catch (const base::Error& error) {
    return error.kind();
  }
  return "";
}

inline mesh::Mesh as_mesh(const tetrahedra::Solid& solid) {
  mesh::Mesh result;
  result.positions = solid.positions;
  result.tetrahedra = solid.tetrahedra;
  return result;
}

inline mesh::Triangle sorted(mesh::Triangle t) {
  std::sort(t.begin(), t.end());
  return t;
}

inline std::vector<mesh::Triangle> sorted(std::span<const mesh::Triangle> triangles) {
  std::vector<mesh::Triangle> result;
  for (mesh::Triangle t : triangles) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());  // keeps the side that it looks to
    result.push_back(t);
  }
  std::sort(result.begin(), result.end());
  return result;
}

// What holds of every solid, whatever the options.
inline void check_solid(const Surface& surface, const tetrahedra::Solid& solid) {
  REQUIRE(solid.positions.size() >= surface.positions.size());
  CHECK(std::equal(surface.positions.begin(), surface.positions.end(), solid.positions.begin()));
  const mesh::Mesh cells = as_mesh(solid);
  CHECK_NOTHROW(mesh::require_valid_cells(cells, host));  // exact signs, whole faces
  const auto boundary = mesh::boundary_triangles(cells, host);
  CHECK(sorted(boundary) == sorted(solid.boundary));
  const double enclosed = mesh::measures(solid.positions, solid.boundary, host).volume;
  const double sum = mesh::tetrahedron_quality(solid.positions, solid.tetrahedra, host).volume;
  CHECK(sum == doctest::Approx(enclosed).epsilon(1e-11));  // the tetrahedra do not overlap
  CHECK(enclosed > 0);
  REQUIRE(solid.boundary_source.size() == solid.boundary.size());
  CHECK(std::ranges::is_sorted(solid.boundary_source));
}

// And with the surface kept.
inline void check_kept(const Surface& surface, const tetrahedra::Solid& solid) {
  check_solid(surface, solid);
  REQUIRE(solid.boundary.size() == surface.triangles.size());
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    CHECK(solid.boundary_source[i] == i);
    CHECK(sorted(solid.boundary[i]) == sorted(surface.triangles[i]));
  }
}

}  // namespace orbicube::test
