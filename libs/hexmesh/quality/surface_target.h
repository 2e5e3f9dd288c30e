// The surface that a mesh of hexahedra is to follow: the nearest point of the whole, of one patch of the polycube, or
// of its sharp edges.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "hexmesh/types.h"
#include "mesh/search/nearest.h"
#include "polycube/outputs/patch_graph.h"
#include "polycube/surface/surface_map.h"

namespace orbicube::hexmesh {

struct TargetPoint {
  Vector3 position;
  Vector3 normal;  // of the surface, smooth but for sharp edges; of a line its direction
};

class SurfaceTarget {
 public:
  // `map` with positions times `scale`. Patches of the polycube whose edges are mostly sharp in space (more than
  // 40 degrees) are kept apart, and these edges are lines. `fine`, if it has triangles, is the surface that counts in
  // place of the map's own, which then is a coarse one and determines where the patches are.
  SurfaceTarget(const polycube::SurfaceMap& map, std::span<const Vector3> fine_positions,
                std::span<const mesh::Triangle> fine_triangles, double scale, const base::Host& host);

  std::span<const Vector3> positions() const { return positions_; }
  std::span<const mesh::Triangle> triangles() const { return triangles_; }
  bool has_sharp_edges() const { return !lines_.empty(); }

  // Whether the edges between two patches of the polycube are sharp.
  bool sharp(Index patch, Index other) const;

  TargetPoint nearest(const Vector3& p) const;
  TargetPoint nearest_on(Index patch, const Vector3& p) const;
  // Those of triangles that look about where `facing` does, or aside: not the other wall of a narrow gap or of a thin
  // part. The whole surface's where there are none.
  TargetPoint nearest(const Vector3& p, const Vector3& facing) const;
  TargetPoint nearest_on(Index patch, const Vector3& p, const Vector3& facing) const;
  // How far the surface opposite of a point on the surface is, across what is outside: at most `far`.
  double gap(const TargetPoint& at, double far) const;
  // On the sharp edges between these two faces. There must be some.
  TargetPoint nearest_on_line(Index patch, Index other, const Vector3& p) const;

  // Where sharp edges between two faces and those between two others have an end in common, the nearest to p.
  struct Meeting {
    Vector3 position;
    bool corner;  // rather than one curve that goes on
  };
  std::optional<Meeting> meeting(const std::array<Index, 2>& faces, const std::array<Index, 2>& others,
                                 const Vector3& p) const;

 private:
  // Triangles of one face, or of all, with their search.
  struct Part {
    explicit Part(std::pmr::memory_resource* memory) : triangles(memory), sources(memory) {}
    Array<mesh::Triangle> triangles;
    Array<Index> sources;
    std::unique_ptr<mesh::SurfaceSearch> search;
  };
  struct Line {
    std::array<Index, 2> patches;
    Vector3 start, end;
  };
  std::span<const Line> lines_of(std::array<Index, 2> faces) const;
  TargetPoint on(const Part& part, const Vector3& p) const { return target_point(part, part.search->nearest(p)); }
  TargetPoint on(const Part& part, const Vector3& p, const Vector3& facing) const;
  TargetPoint target_point(const Part& part, const mesh::SurfacePoint& found) const;
  void find_lines(std::span<const Vector3> positions, std::span<const mesh::Triangle> triangles,
                  std::span<const Index> charts, double scale, const base::Host& host);

  Array<Vector3> positions_;
  Array<mesh::Triangle> triangles_;
  Array<std::array<Vector3, 3>> normals_;  // at the corners of each triangle
  Array<Vector3> flat_normals_;            // of triangles; 0 of those without area
  Part whole_;
  std::vector<Part> patches_;
  Array<Line> lines_;  // sorted by patches, the lower one first
};

}  // namespace orbicube::hexmesh
