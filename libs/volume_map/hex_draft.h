// A mesh of hexahedra on its way from the grid of a map to what is answered: smoothed, held where it would leave the
// surface, searched, certified, and measured against the surface.
#pragma once

#include <string>

#include "polycube/surface_map.h"
#include "volume_map/hex_boundary.h"
#include "volume_map/hex_mesh.h"

namespace orbicube::volume_map {

// A surface with the faces of the polycube, or of another map to integers, that its triangles lie on.
struct PolycubeSurface {
  const polycube::SurfaceMap& map;  // certified
  // The surface that is to be followed, where the map is of a coarse version of it; may be empty.
  std::span<const Vector3> fine_positions = {};
  std::span<const mesh::Triangle> fine_triangles = {};
};

// The surface that counts.
struct WantedSurface {
  explicit WantedSurface(const PolycubeSurface& solid);

  std::span<const Vector3> positions;
  std::span<const mesh::Triangle> triangles;
  double diagonal = 0, volume = 0;
};

// What is made of a grid.
struct HexAim {
  // In percent: so far the boundary may be from the surface and the surface from the boundary, of the diagonal of its
  // box, and so much the volume may differ; 0: nothing is asked for.
  double distance = 1;
  int rounds = 40;  // of smoothing
};

struct HexResult {
  explicit HexResult(std::pmr::memory_resource* memory) : mesh(memory) {}

  HexMesh mesh;
  HexQuality quality;
  bool padded = false;               // somewhere
  bool follows_sharp_edges = false;  // those that the polycube has edges for
  std::size_t off_surface = 0;       // vertices of the boundary that could not be put onto the surface
  bool by_voxels = false;            // the cells of a grid in space, not of a polycube (voxel_hexes.h)
  bool hardly_near = false;          // as far from the surface as allowed, or moved to where it is near (hex_reach.h)
  // In percent, of the diagonal and of the volume of the surface.
  double distance = 0, volume_error = 0;
};

// How many times farther from the surface than allowed; 1 where it is no farther, or that does not matter.
double excess(const HexResult& result, double distance);

// Nearer, or as near and with a better worst hexahedron.
bool better(const HexResult& x, const HexResult& y, double distance);

std::string what_is_wrong(const HexQuality& quality);

// What a mesh may do besides: its boundary lifted off the surface, held where it would leave it, and bad corners made
// better at any cost.
struct HexManner {
  bool lift = true, hold = false, insist = false;
};

class HexDraft {
 public:
  // `mesh` with cells about 1 long: positions times `scale`. The last `padding` hexahedra are layers at the boundary.
  // Keeps references.
  HexDraft(HexMesh mesh, std::size_t padding, double scale, const PolycubeSurface& surface, const WantedSurface& wanted,
           const HexAim& aim, const base::Host& host);

  // Valid or not. May be called once. The same for any number of threads. Throws Error "cancelled".
  HexResult finish(const HexManner& manner);

 private:
  double distance() const { return 0.01 * aim_.distance * scale_ * wanted_.diagonal; }
  HexResult searched(bool all) const;
  // As it is to be answered.
  HexResult measured(const HexMesh& mesh, std::size_t off_surface) const;
  void measure(HexResult& result) const;

  const WantedSurface& wanted_;
  const HexAim aim_;
  const base::Host& host_;
  HexMesh mesh_;
  const std::size_t padding_;
  const double scale_;
  const SurfaceTarget target_;
  HexBoundary boundary_;
};

}  // namespace orbicube::volume_map
