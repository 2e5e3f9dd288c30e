// The models that stand for those of the dissertation's tables (docs/sphere_map_tables.md says how well).
#pragma once

#include <filesystem>
#include <vector>

#include "mesh/files/read.h"
#include "mesh/topology/edge_table.h"
#include "mesh/topology/orient.h"

namespace orbicube::bench {

struct Model {
  const char* name;
  const char* file;
  int subdivisions;  // number of splits of each triangle into four: the shape stays, the vertices become four times as
                     // many
  bool with_baselines = false;  // whether Tables 3.1 to 3.3 have it
};

inline constexpr Model table_models[] = {{"cow", "cow.off", 1, true},
                                         {"frog", "frog.obj", 1},
                                         {"bunny", "bunny.ply", 0, true},
                                         {"horse", "horse.ply", 0},
                                         {"david", "david.obj", 1},
                                         {"venus", "venus.ply", 0},
                                         {"gargoyle", "gargoyle.ply", 1, true},
                                         {"armadillo", "armadillo.ply", 1}};

inline mesh::Mesh subdivided(const mesh::Mesh& coarse) {
  const base::Host host;
  const mesh::EdgeTable edges(coarse.positions.size(), coarse.triangles, host);
  mesh::Mesh fine(host.memory);
  fine.positions = coarse.positions;
  std::vector<mesh::Index> middle_of(3 * coarse.triangles.size());
  for (std::size_t edge = 0; edge < edges.size(); ++edge) {
    const auto sides = edges.half_edges(edge);
    const auto middle = static_cast<mesh::Index>(fine.positions.size());
    for (const mesh::Index side : sides)
      middle_of[side] = middle;
    const mesh::Vector3& from = coarse.positions[mesh::start_of(coarse.triangles, sides[0])];
    const mesh::Vector3& to = coarse.positions[mesh::end_of(coarse.triangles, sides[0])];
    fine.positions.push_back(0.5 * (from + to));
  }
  for (std::size_t i = 0; i < coarse.triangles.size(); ++i) {
    const auto [a, b, c] = coarse.triangles[i];
    const mesh::Index ab = middle_of[3 * i];
    const mesh::Index bc = middle_of[3 * i + 1];
    const mesh::Index ca = middle_of[3 * i + 2];
    for (const mesh::Triangle& t : {mesh::Triangle{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
      fine.triangles.push_back(t);
  }
  return fine;
}

// Outward-oriented.
inline mesh::Mesh read_model(const std::filesystem::path& folder, const Model& model, int subdivisions) {
  mesh::Mesh surface = mesh::read_mesh(folder / model.file, {}, base::Host());
  for (int i = 0; i < subdivisions; ++i)
    surface = subdivided(surface);
  mesh::orient(surface.positions, surface.triangles, base::Host());
  return surface;
}

}  // namespace orbicube::bench
