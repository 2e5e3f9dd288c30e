#include "hexmesh/grid/hex_grid.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "polycube/outputs/inverse_map.h"
#include "volume_map/solid/harmonic_start.h"

namespace orbicube::hexmesh {
namespace {

// Vertices inside at the mean of their neighbors, by conjugate gradients on the corners of the hexahedra.
void place_inner(HexMesh& mesh, std::span<const std::uint8_t> outer, const base::Host& host) {
  Array<untangle::Element> elements(8 * mesh.hexahedra.size(), host.memory);
  for (std::size_t i = 0; i < mesh.hexahedra.size(); ++i) {
    for (std::size_t k = 0; k < 8; ++k) {
      const Hexahedron& h = mesh.hexahedra[i];
      const auto& n = corner_neighbors[k];
      untangle::Element& e = elements[8 * i + k];
      e.corner = {h[k], h[n[0]], h[n[1]], h[n[2]]};
      e.gradient = {-Vector3::Ones(), Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ()};
      e.weight = 1;
    }
  }
  volume_map::make_harmonic(elements, outer, mesh.positions, host);
}

}  // namespace

HexMesh hexahedra_of_cells(const std::array<int, 3>& size, std::span<const std::uint8_t> inside,
                           const base::Host& host) {
  HexMesh mesh(host.memory);
  const auto place = [](const std::array<int, 3>& counts, const Cell& c) {
    return (static_cast<std::size_t>(c[0]) * static_cast<std::size_t>(counts[1]) + static_cast<std::size_t>(c[1])) *
               static_cast<std::size_t>(counts[2]) +
           static_cast<std::size_t>(c[2]);
  };
  const std::array<int, 3> corners = {size[0] + 1, size[1] + 1, size[2] + 1};
  const auto is_inside = [&](const Cell& c) {
    for (std::size_t a = 0; a < 3; ++a) {
      if (c[a] < 0 || c[a] >= size[a]) return false;
    }
    return inside[place(size, c)] != 0;
  };
  Array<Index> vertex(place(corners, {size[0], size[1], size[2]}) + 1, no_index, host.memory);
  constexpr std::array<std::array<int, 3>, 8> offsets = {
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
  // The face of a hexahedron towards each side: axis, then below and above.
  constexpr std::array<std::array<std::size_t, 2>, 3> face_towards = {{{5, 3}, {2, 4}, {0, 1}}};
  Cell c{};
  for (c[0] = 0; c[0] < size[0]; ++c[0]) {
    for (c[1] = 0; c[1] < size[1]; ++c[1]) {
      host.report("grid", 0, 0);
      for (c[2] = 0; c[2] < size[2]; ++c[2]) {
        if (!is_inside(c)) continue;
        Hexahedron h{};
        for (std::size_t k = 0; k < 8; ++k) {
          const Cell corner{c[0] + offsets[k][0], c[1] + offsets[k][1], c[2] + offsets[k][2]};
          Index& v = vertex[place(corners, corner)];
          if (v == no_index) {
            v = static_cast<Index>(mesh.positions.size());
            mesh.positions.push_back(Vector3(corner[0], corner[1], corner[2]));
          }
          h[k] = v;
        }
        mesh.hexahedra.push_back(h);
        for (std::size_t a = 0; a < 3; ++a) {
          for (std::size_t side = 0; side < 2; ++side) {
            Cell beside = c;
            beside[a] += side == 1 ? 1 : -1;
            if (is_inside(beside)) continue;
            const auto& face = hexahedron_faces[face_towards[a][side]];
            mesh.quads.push_back({h[face[0]], h[face[1]], h[face[2]], h[face[3]]});
          }
        }
      }
    }
  }
  mesh.quad_patches.assign(mesh.quads.size(), 0);
  return mesh;
}

HexMesh sample_hexahedra(const IntegerDomain& domain, const polycube::SurfaceMap& surface, const base::Host& host) {
  HexMesh mesh = hexahedra_of_cells({domain.size(0), domain.size(1), domain.size(2)}, domain.inside(), host);
  // The boundary by the map of the surface: vertices, then centers of faces.
  polycube::SurfaceMap image(host.memory);
  image.positions = surface.positions;
  for (const Vector3& p : surface.polycube)
    image.polycube.push_back(domain.place(p));
  image.triangles = surface.triangles;
  image.labels = surface.labels;
  Array<std::uint8_t> outer(mesh.positions.size(), 0, host.memory);
  for (const Quad& q : mesh.quads) {
    for (const Index v : q)
      outer[v] = 1;
  }
  Array<Index> boundary(host.memory);
  Array<Vector3> points(host.memory);
  for (Index v = 0; v < outer.size(); ++v) {
    if (outer[v] == 0) continue;
    boundary.push_back(v);
    points.push_back(Vector3(mesh.positions[v]));
  }
  for (const Quad& q : mesh.quads)
    points.push_back(Vector3(0.5 * (mesh.positions[q[0]] + mesh.positions[q[2]])));
  const polycube::LocatedPoints located = polycube::locate(image, points, host);
  if (std::find(located.triangles.begin(), located.triangles.end(), no_index) != located.triangles.end())
    throw base::Error("no-valid-result", "a cell of the grid lies on no triangle of the boundary");
  Vector3 center = Vector3::Zero();
  for (std::size_t i = 0; i < boundary.size(); ++i) {
    mesh.positions[boundary[i]] = polycube::interpolate(image, located.triangles[i], located.weights[i]);
    center += mesh.positions[boundary[i]] / static_cast<double>(boundary.size());
  }
  for (Index v = 0; v < outer.size(); ++v) {
    if (outer[v] == 0) mesh.positions[v] = center;
  }
  place_inner(mesh, outer, host);
  for (std::size_t i = 0; i < mesh.quads.size(); ++i)
    mesh.quad_patches[i] = surface.patches[located.triangles[boundary.size() + i]];
  return mesh;
}

}  // namespace orbicube::hexmesh
