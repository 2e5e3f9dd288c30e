// The pieces of a solid, each with the polycube of its surface: what maps of solids and hexahedra start from.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mesh/mesh.h"
#include "polycube/map/construction.h"
#include "volume_map/input/filled_solid.h"
#include "volume_map/input/given_polycube.h"
#include "volume_map/input/solid_pieces.h"
#include "volume_map/input/working_space.h"
#include "volume_map/solid/volume_map.h"

namespace orbicube::volume_map {

struct SurfaceFigures {
  std::size_t vertices = 0, triangles = 0;
  std::int64_t genus = 0;
  std::size_t cavities = 0;
};

// Of the polycubes of all pieces; distortions are means.
struct PolycubeFigures {
  std::size_t corners = 0, patches = 0;
  std::int64_t genus = 0;
  std::size_t surface_triangles = 0;
  double angles = 0, areas = 0;
};

// What was found in an input and done to it, as far as the work got.
struct InputFindings {
  std::function<void(const std::string&)> on_note;  // what was done to the input, for people; may be empty
  std::optional<SurfaceFigures> surface;            // of an input that is a surface
  std::optional<PolycubeFigures> polycube;          // where all pieces have a polycube
  std::size_t pieces = 0;                           // with polycubes or without; 0: the work did not get there
  double fill_seconds = 0, polycube_seconds = 0;
  bool examined = false;  // whether the input was found to be good; an error is about the result from then on

  void note(const std::string& text) const {
    if (on_note) on_note(text);
  }
};

enum class Inside { tetrahedra, nothing };
// Where there is no polycube, and none has to be, the surface of the input is `fine`.
enum class Polycubes { needed, where_there_are, none };

struct PieceOptions {
  std::size_t corners = 100;     // maximum number of corners of a polycube; 0: no limit
  std::size_t triangles = 6000;  // see coarse_target()
  std::uint64_t seed = 0;
  std::size_t max_pieces = 0;  // more are refused; 0: any number
  Inside inside = Inside::tetrahedra;
  Polycubes polycubes = Polycubes::needed;
  FillSurface fill = {};     // of surfaces, for tetrahedra inside
  GivenPolycube given = {};  // of the surface of a solid of one piece without cavities, which is not made coarser
};

struct PolycubePiece {
  explicit PolycubePiece(std::pmr::memory_resource* memory)
      : positions(memory), tetrahedra(memory), surface(memory), made(memory), fine(memory) {}

  base::Array<mesh::Vector3> positions;  // those of the surface first
  base::Array<mesh::Tetrahedron> tetrahedra;
  base::Array<mesh::Triangle> surface;
  polycube::Construction made;
  mesh::Mesh fine;     // the surface of the input, where `surface` is coarser or there is no polycube
  WorkingSpace space;  // of all these coordinates, where there are no tetrahedra to be mapped

  PolycubeSolid solid() const { return {positions, tetrahedra, surface, made.map}; }
};

// The solids that a surface bounds; its parts are turned to look out of them. Hexahedra stand it where one piece meets
// itself in few places; who fills it decides what can be filled. Throws Error for what bounds no solid, with the place,
// and for more than `max_pieces` solids (0: any number).
SurfacePieces pieces_of_surface(mesh::Mesh& surface, Inside inside, std::size_t max_pieces, InputFindings& findings,
                                const base::Host& host);

// Of a surface, which is filled with tetrahedra where these are requested, or of a solid of tetrahedra, which keeps
// them. Surfaces of more than twice as many triangles as the options say are made coarser first. Sizes must be near 1
// (mesh/search/unit_scale.h). Throws what pieces_of_surface(), filled_solid(), boundary_first() and
// construct_polycube() do.
std::vector<PolycubePiece> polycube_pieces(mesh::Mesh&& input, const PieceOptions& options, InputFindings& findings,
                                           const base::Host& host);

}  // namespace orbicube::volume_map
