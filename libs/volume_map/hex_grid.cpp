#include "volume_map/hex_grid.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "polycube/inverse_map.h"

namespace orbicube::volume_map {
namespace {

// The corners of the grid around all cells.
class Corners {
 public:
  explicit Corners(const IntegerDomain& domain) {
    for (std::size_t a = 0; a < 3; ++a)
      size_[a] = domain.size(a) + 1;
  }
  std::size_t count() const {
    return static_cast<std::size_t>(size_[0]) * static_cast<std::size_t>(size_[1]) * static_cast<std::size_t>(size_[2]);
  }
  std::size_t operator()(const Cell& c) const {
    return (static_cast<std::size_t>(c[0]) * static_cast<std::size_t>(size_[1]) + static_cast<std::size_t>(c[1])) *
               static_cast<std::size_t>(size_[2]) +
           static_cast<std::size_t>(c[2]);
  }
  int size(std::size_t a) const { return size_[a]; }

 private:
  std::array<int, 3> size_{};
};

// Where each corner of the grid is in space, by the tetrahedron in which it lies deepest.
Array<Vector3> inverse_at_corners(const Corners& corners, const SolidMap& solid, const base::Host& host) {
  Array<Vector3> places(corners.count(), Vector3::Zero(), host.memory);
  Array<double> depth(corners.count(), -std::numeric_limits<double>::infinity(), host.memory);
  for (std::size_t i = 0; i < solid.tetrahedra.size(); ++i) {
    if (i % 1024 == 0) host.report("grid", i, solid.tetrahedra.size());
    const Tetrahedron& t = solid.tetrahedra[i];
    Vector3 low = solid.image[t[0]], high = low;
    Eigen::Matrix3d edges;
    for (std::size_t k = 1; k < 4; ++k) {
      low = low.cwiseMin(solid.image[t[k]]);
      high = high.cwiseMax(solid.image[t[k]]);
      edges.col(static_cast<Eigen::Index>(k) - 1) = solid.image[t[k]] - solid.image[t[0]];
    }
    Cell first{}, last{}, c{};
    bool any = true;
    for (std::size_t a = 0; a < 3; ++a) {
      constexpr double margin = 1e-6;
      const auto e = static_cast<Eigen::Index>(a);
      first[a] = std::max(0, static_cast<int>(std::ceil(low[e] - margin)));
      last[a] = std::min(corners.size(a) - 1, static_cast<int>(std::floor(high[e] + margin)));
      any = any && first[a] <= last[a];
    }
    if (!any) continue;
    const Eigen::Matrix3d inverse = edges.inverse();
    for (c[0] = first[0]; c[0] <= last[0]; ++c[0]) {
      for (c[1] = first[1]; c[1] <= last[1]; ++c[1]) {
        for (c[2] = first[2]; c[2] <= last[2]; ++c[2]) {
          const Vector3 w = inverse * (Vector3(c[0], c[1], c[2]) - solid.image[t[0]]);
          const Eigen::Vector4d weights(1 - w.sum(), w[0], w[1], w[2]);
          const double least = weights.minCoeff();
          double& best = depth[corners(c)];
          if (!(least > best)) continue;
          best = least;
          Vector3& place = places[corners(c)];
          place.setZero();
          for (std::size_t k = 0; k < 4; ++k)
            place += weights[static_cast<Eigen::Index>(k)] * solid.source[t[k]];
        }
      }
    }
  }
  return places;
}

}  // namespace

HexMesh sample_hexahedra(const IntegerDomain& domain, const SolidMap& solid, const polycube::SurfaceMap& surface,
                         const base::Host& host) {
  HexMesh mesh(host.memory);
  const Corners corners(domain);
  const Array<Vector3> places = inverse_at_corners(corners, solid, host);
  Array<Index> vertex(corners.count(), no_index, host.memory);
  Array<Cell> corner_of_vertex(host.memory);
  constexpr std::array<std::array<int, 3>, 8> offsets = {
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
  // The face of a hexahedron towards each side: axis, then below and above.
  constexpr std::array<std::array<std::size_t, 2>, 3> face_towards = {{{5, 3}, {2, 4}, {0, 1}}};
  Array<Vector3> centers(host.memory);  // of boundary faces, on the polycube
  Cell c{};
  for (c[0] = 0; c[0] < domain.size(0); ++c[0]) {
    host.report("grid", 0, 0);
    for (c[1] = 0; c[1] < domain.size(1); ++c[1]) {
      for (c[2] = 0; c[2] < domain.size(2); ++c[2]) {
        if (!domain.inside(c)) continue;
        Hexahedron h{};
        for (std::size_t k = 0; k < 8; ++k) {
          const Cell corner{c[0] + offsets[k][0], c[1] + offsets[k][1], c[2] + offsets[k][2]};
          Index& v = vertex[corners(corner)];
          if (v == no_index) {
            v = static_cast<Index>(mesh.positions.size());
            mesh.positions.push_back(places[corners(corner)]);
            corner_of_vertex.push_back(corner);
          }
          h[k] = v;
        }
        mesh.hexahedra.push_back(h);
        for (std::size_t a = 0; a < 3; ++a) {
          for (std::size_t side = 0; side < 2; ++side) {
            Cell beside = c;
            beside[a] += side == 1 ? 1 : -1;
            if (domain.inside(beside)) continue;
            const auto& face = hexahedron_faces[face_towards[a][side]];
            mesh.quads.push_back({h[face[0]], h[face[1]], h[face[2]], h[face[3]]});
            Vector3 center(c[0] + 0.5, c[1] + 0.5, c[2] + 0.5);
            center[static_cast<Eigen::Index>(a)] = c[a] + (side == 1 ? 1 : 0);
            centers.push_back(center);
          }
        }
      }
    }
  }
  // The boundary by the map of the surface: vertices, then centers of faces.
  polycube::SurfaceMap image(host.memory);
  image.positions = surface.positions;
  image.polycube.assign(solid.image.begin(),
                        solid.image.begin() + static_cast<std::ptrdiff_t>(surface.positions.size()));
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
    points.push_back(Vector3(corner_of_vertex[v][0], corner_of_vertex[v][1], corner_of_vertex[v][2]));
  }
  points.insert(points.end(), centers.begin(), centers.end());
  const polycube::LocatedPoints located = polycube::locate(image, points, host);
  if (std::find(located.triangles.begin(), located.triangles.end(), no_index) != located.triangles.end())
    throw base::Error("no-valid-result", "a cell of the grid lies on no triangle of the boundary");
  for (std::size_t i = 0; i < boundary.size(); ++i)
    mesh.positions[boundary[i]] = polycube::interpolate(image, located.triangles[i], located.weights[i]);
  mesh.quad_patches.resize(mesh.quads.size());
  for (std::size_t i = 0; i < mesh.quads.size(); ++i)
    mesh.quad_patches[i] = surface.charts[located.triangles[boundary.size() + i]];
  return mesh;
}

void pad(HexMesh& mesh, double cell_length, const base::Host& host) {
  constexpr double depth = 0.25;
  const std::size_t before = mesh.positions.size();
  Array<Vector3> normal(before, Vector3::Zero(), host.memory);
  Array<Index> outer(before, no_index, host.memory);
  for (const Quad& q : mesh.quads) {
    const Vector3 n = (mesh.positions[q[2]] - mesh.positions[q[0]]).cross(mesh.positions[q[3]] - mesh.positions[q[1]]);
    for (const Index v : q) {
      normal[v] += n;
      if (outer[v] != no_index) continue;
      outer[v] = static_cast<Index>(mesh.positions.size());
      mesh.positions.push_back(mesh.positions[v]);
    }
  }
  for (Quad& q : mesh.quads) {
    Hexahedron h{};
    for (std::size_t k = 0; k < 4; ++k) {
      h[k] = q[k];
      h[k + 4] = outer[q[k]];
      q[k] = outer[q[k]];
    }
    mesh.hexahedra.push_back(h);
  }
  for (std::size_t v = 0; v < before; ++v) {
    const double length = normal[v].norm();
    if (length > 0) mesh.positions[v] -= depth * cell_length / length * normal[v];
  }
}

}  // namespace orbicube::volume_map
