// A mesh of hexahedra from the grid of a map to the result: smoothed, fixed where it would leave the
// surface, searched, certified, and measured against the surface.
#pragma once

#include <string>
#include <utility>

#include "hexmesh/certificate/hex_mesh.h"
#include "hexmesh/quality/hex_boundary.h"
#include "polycube/surface/surface_map.h"
#include "volume_map/input/working_space.h"

namespace orbicube::hexmesh {

// A surface with the patches of the polycube, or of another map to integers, that its triangles lie on.
struct PolycubeSurface {
  const polycube::SurfaceMap& map;  // certified
  // The surface that is to be followed, where the map is of a coarse version of it; may be empty.
  std::span<const Vector3> fine_positions = {};
  std::span<const mesh::Triangle> fine_triangles = {};
  // Where the map is not in the coordinates of the solid.
  const volume_map::WorkingSpace* space = nullptr;
  // What percents of distance and volume are of, in multiples of its own diagonal and volume: those of the solid that
  // this is a piece of.
  double diagonal_ratio = 1, volume_ratio = 1;
};

// What volumes of a solid with this box are summed about: the origin, or where that is far, and would cost digits, the
// middle of the box.
inline Vector3 near_origin(const Vector3& low, const Vector3& high) {
  const bool far = low.cwiseAbs().cwiseMax(high.cwiseAbs()).maxCoeff() > 16 * (high - low).maxCoeff();
  return far ? Vector3(0.5 * low + 0.5 * high) : Vector3(Vector3::Zero());
}

// The surface that counts.
struct TargetSurface {
  explicit TargetSurface(const PolycubeSurface& solid);

  std::span<const Vector3> positions;
  std::span<const mesh::Triangle> triangles;
  double diagonal = 0, volume = 0;
  double diagonal_ratio = 1, volume_ratio = 1;
};

constexpr int max_rounds = 1000;  // of smoothing

// In the host's memory, which a plain copy would not be.
HexMesh copy_of(const HexMesh& mesh, const base::Host& host);

// What is made of a grid.
struct HexTarget {
  // In percent: so far the boundary may be from the surface and the surface from the boundary, of the diagonal of its
  // box, and so much the volume may differ; 0: nothing is requested.
  double distance = 1;
  int rounds = 40;  // of smoothing
};

// A connected solid of several, in a result.
struct HexPiece {
  Vector3 place = Vector3::Zero();  // the center of its box
  std::size_t hexahedra = 0;
  double distance = 0, volume_error = 0;  // in percent of its own diagonal and volume
  bool grid_based = false;
};

struct HexResult {
  explicit HexResult(std::pmr::memory_resource* memory) : mesh(memory), pieces(memory) {}

  HexMesh mesh;
  HexQuality quality;
  bool padded = false;               // somewhere
  bool follows_sharp_edges = false;  // those that the polycube has edges for
  std::size_t off_surface = 0;       // vertices of the boundary that could not be put onto the surface
  bool grid_based = false;           // the cells of a grid in space, not of a polycube (voxel_hexes.h)
  bool hardly_near = false;          // as far from the surface as allowed, or moved to where it is near (hex_reach.h)
  // In percent, of the diagonal and of the volume of the whole surface.
  double distance = 0, volume_error = 0;
  Array<HexPiece> pieces;  // one at least once the mesh is complete
};

// How many times farther from the surface than allowed; 1 where it is no farther, or that does not matter.
double excess(const HexResult& result, double distance);

// Nearer, or as near and with a better worst hexahedron.
bool better(const HexResult& x, const HexResult& y, double distance);

std::string what_is_wrong(const HexQuality& quality);

// What a mesh may do besides: its boundary raised off the surface, fixed where it would leave it, and bad corners made
// better at any cost.
struct HexManner {
  bool lift = true, hold = false, insist = false;
  bool apart = false;        // no vertex goes to the other wall of a gap (hex_boundary.h)
  double held_fraction = 1;  // of the distance that is allowed: where the boundary is fixed the nearer to the surface
};

// Writes to the log how a mesh was made and what it is like.
void log_made(const HexResult& made, const HexManner& manner, const base::Host& host);

class HexDraft {
 public:
  // `mesh` with cells about 1 long: positions times `scale`. The last `padding` hexahedra are layers at the boundary.
  // Keeps references.
  HexDraft(HexMesh mesh, std::size_t padding, double scale, const PolycubeSurface& surface, const TargetSurface& shape,
           const HexTarget& aim, const base::Host& host);

  // Valid or not. May be called once. The same for any number of threads. Throws Error "cancelled".
  HexResult finish(const HexManner& manner);
  // Moves walls apart where the boundary of a result meets itself (gap_opening.h), if nothing else is wrong and that
  // makes it valid.
  void part_walls(HexResult& result) const;

 private:
  double distance() const { return 0.01 * aim_.distance * scale_ * shape_.diagonal; }
  // How far the boundary may move where it is fixed. Without a distance that is allowed: as for one percent.
  double held_distance(const HexManner& manner) const {
    constexpr double held = 0.65;  // farther vertices are fixed, in the distance that is allowed
    const double percent = aim_.distance > 0 ? aim_.distance : 1;
    return held * manner.held_fraction * 0.01 * percent * scale_ * shape_.diagonal;
  }
  HexResult searched(const HexManner& manner, bool all) const;
  // As it is to be returned.
  HexResult measured(const HexMesh& mesh, std::size_t off_surface) const;
  void measure(HexResult& result) const;

  const TargetSurface& shape_;
  const HexTarget aim_;
  const base::Host& host_;
  HexMesh mesh_;
  const std::size_t padding_;
  const double scale_;
  const SurfaceTarget target_;
  HexBoundary boundary_;
};

// Finishes drafts, each new from `draft()`. While the hexahedra are positive and the boundary meets itself, as across a
// narrow gap, the next draft keeps the walls apart, then is fixed nearer to where its vertices begin, on the surface,
// which does not meet itself; what quads between vertices still cut through is moved.
template <class Draft>
HexResult finish_apart(const Draft& draft, HexManner manner) {
  HexResult result = draft().finish(manner);
  manner.apart = true;
  const bool held = manner.hold;
  for (const double fraction : {1.0, 0.25, 0.06}) {
    if (!result.quality.positive() || result.quality.valid()) break;
    const bool first = fraction == 1;
    manner.hold = held || !first;
    manner.held_fraction = fraction;
    HexDraft next = draft();
    HexResult now = next.finish(manner);
    next.part_walls(now);
    if (now.quality.positive() && now.quality.intersections < result.quality.intersections) result = std::move(now);
  }
  return result;
}

}  // namespace orbicube::hexmesh
