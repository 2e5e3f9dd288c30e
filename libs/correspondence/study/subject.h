// One subject of a study: its surface on the triangulation that all subjects share.
#pragma once

#include <optional>

#include "correspondence/sphere_alignment.h"
#include "correspondence/sphere_mesh.h"
#include "harmonics/functions/coefficients.h"
#include "sphere_map/sampling/grids.h"

namespace orbicube::correspondence {

struct SubjectOptions {
  sphere_map::GridKind grid = sphere_map::GridKind::icosphere;
  std::size_t resolution = 5;
  bool align = true;  // rotate the sphere to maximum correlation with the first subject
  bool joint = true;  // for any poses of the shapes, else for equal poses
  std::uint64_t seed = 0;
};

struct Subject {
  explicit Subject(std::pmr::memory_resource* memory) : positions(memory) {}

  base::Array<mesh::Vector3> positions;  // one a vertex of the grid
  double correlation = 1;                // with the first subject, at most 1
  double turn = 0;                       // angle by which the shape is rotated for it, in degrees
  // Of the first subject with `align`: its positions as functions on the sphere, which the others are aligned with.
  std::optional<harmonics::Coefficients> functions;
  std::size_t flipped = 0;  // triangles of the grid that are not positive on the subject's own sphere
};

// Maps a closed, outward-oriented surface of genus 0 to the sphere, rotates the sphere to maximum correlation with the
// first subject (null: this is the first), and carries the grid to the surface. The same bits for any number of
// threads. Throws Error "no-valid-result", "cancelled", and what sphere_map::compute() does.
Subject map_subject(const mesh::Mesh& surface, const harmonics::Coefficients* first, const SubjectOptions& options,
                    const base::Host& host);

}  // namespace orbicube::correspondence
