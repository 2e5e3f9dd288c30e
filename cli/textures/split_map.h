// A polycube map with its vertices once for each patch that they are in, since texture coordinates differ there.
#pragma once

#include <span>

#include "gltf/writing/float_frame.h"
#include "polycube/surface/surface_map.h"
#include "session/session.h"

namespace orbicube::cli {

struct SplitMap {
  SplitMap(const polycube::SurfaceMap& map, std::pmr::memory_resource* memory);

  // Of each vertex.
  base::Array<mesh::Index> vertices;  // of the map
  base::Array<mesh::Index> patches;
  base::Array<polycube::AxisLabel> labels;
  base::Array<mesh::Vector3> positions, on_polycube;
  base::Array<mesh::Triangle> triangles;
};

// The frame in which float32 holds the surface and, around its own middle, the polycube.
struct PolycubeFrame {
  PolycubeFrame(const SplitMap& split, const base::Host& host);

  gltf::FloatFrame surface, polycube;
  mesh::Vector3 low, high;  // of the polycube
};

// Of the surface, which is smooth across edges of the polycube: three a vertex.
base::Array<float> normals_of(const polycube::SurfaceMap& map, const SplitMap& split, const gltf::FloatFrame& frame,
                              const base::Host& host);

// Number of triangles that are flat or flipped on the polycube when a renderer adds the target to the base.
std::size_t lost_triangles(const SplitMap& split, std::span<const float> base, std::span<const float> target);

}  // namespace orbicube::cli
