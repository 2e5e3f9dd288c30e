// Shapes on one triangulation, as morph targets of one glTF mesh, and what lies between them as files.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "gltf/kept/kept.h"
#include "gltf/writing/write.h"
#include "mesh/mesh.h"
#include "session/session.h"

namespace orbicube::cli {

struct MorphStates {
  std::string output;              // a glTF file
  std::vector<std::string> names;  // of the shapes
  std::span<const mesh::Triangle> triangles;
  std::span<const base::Array<mesh::Vector3>> states;  // positions of each shape
  double seconds = 2;                                  // of the animation, from one to the next
  std::size_t steps = 0;  // intermediate shapes between consecutive ones, to OUT-01 and so on
  // Of the file of the first shape; may be null. With its triangles, and where those of the states lie on them.
  const gltf::Kept* kept = nullptr;
  std::span<const mesh::Triangle> kept_surface{};
  std::span<const gltf::KeptTriangle> kept_triangles{};
};

struct ShapeBlend {
  std::vector<double> weights;  // one a shape; empty: no blend
  std::string quads;            // a file for the quads of a polycube's grid, or empty
};

// Throws Failure unless there are as many weights as shapes, or none.
void require_weights(const ShapeBlend& blend, std::size_t shapes);

// Writes the weighted sum of the states to the output, in any format, and its quads. Throws Failure.
void write_blend(const MorphStates& morph, const ShapeBlend& blend, std::span<const std::array<mesh::Index, 4>> quads,
                 Session& session);

// Writes them, and adds "intermediates" to the session's figures. Throws Failure.
void write_morph(const MorphStates& morph, Session& session);

}  // namespace orbicube::cli
