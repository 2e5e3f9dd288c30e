// Hexahedral meshes of solids through their polycubes: the solid is mapped to a polycube with integer planes, the grid
// there is taken back, padded, and made better; what is answered is certified.
#pragma once

#include <string>

#include "polycube/surface_map.h"
#include "volume_map/hex_mesh.h"

namespace orbicube::volume_map {

// A solid of tetrahedra with a polycube map of its surface.
struct PolycubeSolid {
  std::span<const Vector3> positions;  // those of the surface that the map was made of come first
  std::span<const Tetrahedron> tetrahedra;
  std::span<const mesh::Triangle> surface;  // that surface: the boundary of the tetrahedra, looking outward
  const polycube::SurfaceMap& map;          // certified
  // The surface that is to be followed, where the one above is a coarse version of it; may be empty.
  std::span<const Vector3> fine_positions = {};
  std::span<const mesh::Triangle> fine_triangles = {};
};

enum class Padding : std::int32_t { automatic = 0, with = 1, without = 2 };

struct HexOptions {
  std::size_t cells = 10000;             // about
  Padding padding = Padding::automatic;  // a layer of hexahedra at the boundary; automatic: what turns out better
  int rounds = 40;                       // of smoothing
};

struct HexResult {
  explicit HexResult(std::pmr::memory_resource* memory) : mesh(memory) {}

  HexMesh mesh;
  HexQuality quality;
  bool padded = false;
  std::size_t tetrahedra = 0, inverted_at_start = 0, steps = 0;  // of the map of the solid
  std::size_t off_surface = 0;  // vertices of the boundary that could not be put onto the surface
};

// Every hexahedron of the result has positive corners by exact signs and a trilinear map that is certainly positive;
// the mesh is conforming, with the components and the genus of the surface. The same for any number of threads. Throws
// Error "no-valid-result" with what failed and where, "invalid-argument", "cancelled".
HexResult make_hexahedra(const PolycubeSolid& solid, const HexOptions& options, const base::Host& host);

// The same tetrahedra in space, cut where the map cuts the surface, and on the polycube, with its own planes.
struct VolumeMap {
  explicit VolumeMap(std::pmr::memory_resource* memory) : source(memory), image(memory), tetrahedra(memory) {}

  Array<Vector3> source, image;
  Array<Tetrahedron> tetrahedra;
  std::size_t inverted_at_start = 0, steps = 0;
};

// One to one, by exact signs and the certificate of the boundary. Throws the same.
VolumeMap map_to_polycube(const PolycubeSolid& solid, const base::Host& host);

}  // namespace orbicube::volume_map
