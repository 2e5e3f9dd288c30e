// Solids of blocks with a polycube map of their surface that is known: the blocks themselves.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "polycube/map/certificate.h"
#include "tests/untangle/tangled_cases.h"
#include "volume_map/solid/volume_map.h"

namespace orbicube::volume_map::test {

using namespace untangle::test;

struct BlockSolid {
  std::vector<Vector3> positions;  // those of the boundary first
  std::vector<Tetrahedron> tetrahedra;
  std::vector<mesh::Triangle> surface;
  polycube::SurfaceMap map;

  // Blocks cut into n^3 cubes, bent and rounded in space.
  BlockSolid(const std::vector<Block>& blocks, int n, double roundness, double bend) {
    const BlockMesh mesh(blocks, n);
    std::vector<Index> number(mesh.positions.size(), no_index);
    for (const bool outer : {true, false}) {
      for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        if (mesh.on_boundary(v) != outer) continue;
        number[v] = static_cast<Index>(positions.size());
        positions.push_back(warped(mesh.positions[v], roundness, bend, 0.3));
        if (outer) map.polycube.push_back(mesh.positions[v]);
      }
    }
    for (Tetrahedron t : mesh.tetrahedra) {
      for (Index& v : t)
        v = number[v];
      tetrahedra.push_back(t);
    }
    // Faces of one tetrahedron.
    std::map<mesh::Triangle, std::pair<int, mesh::Triangle>> faces;
    for (const Tetrahedron& t : tetrahedra) {
      const std::array<mesh::Triangle, 4> outward = {
          {{t[1], t[2], t[3]}, {t[0], t[3], t[2]}, {t[0], t[1], t[3]}, {t[0], t[2], t[1]}}};
      for (const mesh::Triangle& face : outward) {
        mesh::Triangle key = face;
        std::sort(key.begin(), key.end());
        auto& entry = faces.try_emplace(key, 0, face).first->second;
        ++entry.first;
      }
    }
    for (const auto& [key, entry] : faces) {
      if (entry.first == 1) surface.push_back(entry.second);
    }
    map.positions.assign(positions.begin(), positions.begin() + static_cast<std::ptrdiff_t>(map.polycube.size()));
    map.triangles.assign(surface.begin(), surface.end());
    polycube::set_unrefined(map);
    certificate = polycube::certify(map, base::Host()).reason;
  }

  // The edge between the first two corners of a triangle cut in its middle, as maps cut edges.
  void cut(std::size_t triangle) {
    const Index a = surface[triangle][0], b = surface[triangle][1];
    const auto middle = static_cast<Index>(map.positions.size());
    map.positions.push_back(0.5 * (map.positions[a] + map.positions[b]));
    map.polycube.push_back(0.5 * (map.polycube[a] + map.polycube[b]));
    map.vertex_sources.push_back({{a, b, no_index}, {0.5, 0.5, 0}});
    const std::size_t count = map.triangles.size();
    for (std::size_t i = 0; i < count; ++i) {
      mesh::Triangle& t = map.triangles[i];
      if (std::count(t.begin(), t.end(), a) + std::count(t.begin(), t.end(), b) != 2) continue;
      mesh::Triangle other = t;
      std::replace(t.begin(), t.end(), a, middle);
      std::replace(other.begin(), other.end(), b, middle);
      map.triangles.push_back(other);
      map.triangle_sources.push_back(map.triangle_sources[i]);
    }
    certificate = polycube::certify(map, base::Host()).reason;
  }

  PolycubeSolid solid() const { return {positions, tetrahedra, surface, map}; }

  std::string certificate;  // empty
};

inline const std::vector<Block> angle = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};

}  // namespace orbicube::volume_map::test
