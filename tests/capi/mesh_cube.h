// A cube of triangles and tetrahedra, and what the tests of mesh's C functions do with one.
#pragma once

#include <doctest/doctest.h>

#include <array>
#include <cstdint>
#include <memory>

#include "orbicube/mesh.h"

namespace orbicube::test {

struct Destroy {
  void operator()(obc_mesh* mesh) const { obc_mesh_destroy(mesh); }
  void operator()(obc_mesh_search* search) const { obc_mesh_search_destroy(search); }
};
using Mesh = std::unique_ptr<obc_mesh, Destroy>;
using Search = std::unique_ptr<obc_mesh_search, Destroy>;

// A cube of 12 triangles, cut into five tetrahedra.
struct Cube {
  std::array<double, 24> positions{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1};
  std::array<std::uint32_t, 36> triangles{0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                          2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
  std::array<std::uint32_t, 20> tetrahedra{0, 1, 2, 4, 3, 2, 1, 7, 5, 4, 7, 1, 6, 7, 4, 2, 1, 2, 4, 7};
  std::array<std::uint32_t, 8> hexahedra{0, 1, 3, 2, 4, 5, 7, 6};

  obc_surface surface() const { return {positions.data(), 8, triangles.data(), 12}; }
  obc_mesh_cells cells() const {
    obc_mesh_cells result;
    obc_mesh_cells_init(&result, sizeof result);
    result.positions = positions.data();
    result.vertex_count = 8;
    result.triangles = triangles.data();
    result.triangle_count = 12;
    result.tetrahedra = tetrahedra.data();
    result.tetrahedron_count = 5;
    return result;
  }
};

inline Mesh create(const obc_mesh_cells& cells) {
  obc_mesh* mesh = nullptr;
  obc_error error;
  REQUIRE(obc_mesh_create(&cells, nullptr, &mesh, &error) == OBC_OK);
  return Mesh(mesh);
}

inline obc_mesh_topology_report topology(const obc_surface& surface) {
  obc_mesh_topology_report report;
  obc_mesh_topology_report_init(&report, sizeof report);
  REQUIRE(obc_mesh_topology(&surface, nullptr, &report, nullptr) == OBC_OK);
  return report;
}

}  // namespace orbicube::test
