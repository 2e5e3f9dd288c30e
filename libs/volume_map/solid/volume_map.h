// Maps of solids to the polycubes of their surfaces, one to one.
#pragma once

#include <utility>

#include "polycube/surface/surface_map.h"
#include "untangle/tetrahedra/block_assembly.h"
#include "volume_map/solid/solid_map.h"
#include "volume_map/types.h"

namespace orbicube::volume_map {

// A solid of tetrahedra with a polycube map of its surface.
struct PolycubeSolid {
  std::span<const Vector3> positions;  // those of the surface that the map was made of come first
  std::span<const Tetrahedron> tetrahedra;
  std::span<const mesh::Triangle> surface;  // that surface: the boundary of the tetrahedra, outward-oriented
  const polycube::SurfaceMap& map;          // certified
};

// The same tetrahedra in space, cut where the map cuts the surface, and on the polycube, with its own planes.
struct VolumeMap {
  explicit VolumeMap(std::pmr::memory_resource* memory) : source(memory), image(memory), tetrahedra(memory) {}
  explicit VolumeMap(SolidMap&& map)
      : source(std::move(map.source)),
        image(std::move(map.image)),
        tetrahedra(std::move(map.tetrahedra)),
        inverted_at_start(map.inverted_at_start),
        steps(map.steps) {}

  Array<Vector3> source, image;
  Array<Tetrahedron> tetrahedra;
  std::size_t inverted_at_start = 0, steps = 0;
};

// One to one, by exact signs and the certificate of the boundary. With an engine, that solves the linear systems.
// Throws the same.
VolumeMap map_to_polycube(const PolycubeSolid& solid, const base::Host& host, untangle::BlockEngine* engine = nullptr);

// Pieces that are not connected, each to its own polycube; these stand side by side along x. The numbers of vertices
// and tetrahedra go on from piece to piece.
VolumeMap map_pieces_to_polycubes(std::span<const PolycubeSolid> pieces, const base::Host& host,
                                  untangle::BlockEngine* engine = nullptr);

}  // namespace orbicube::volume_map
