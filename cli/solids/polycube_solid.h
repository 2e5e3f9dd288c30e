// A solid with a polycube map of its surface, made of a file: what the verbs hex and volume start from.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "files/surface_file.h"
#include "mesh/mesh.h"
#include "polycube/map/construction.h"
#include "session/session.h"
#include "volume_map/meshing/hex_meshing.h"
#include "volume_map/solid/solid_pieces.h"
#include "volume_map/solid/volume_map.h"

namespace orbicube::cli {

struct PolycubeSolidOptions {
  std::string input;
  std::size_t corners = 100;
  std::size_t triangles = 6000;
  bool weld = false;
  std::size_t max_pieces = 0;  // more are refused; 0: any number
};

void add_polycube_solid_options(CLI::App& verb, PolycubeSolidOptions& options);
Json json_of(const PolycubeSolidOptions& options);

struct PolycubeSolidInput {
  base::Array<mesh::Vector3> positions;
  base::Array<mesh::Tetrahedron> tetrahedra;
  base::Array<mesh::Triangle> surface;
  polycube::Construction made;
  mesh::Mesh fine;                      // the surface of the file, where `surface` is coarser
  int exponent = 0;                     // all lengths are those of the file times 2^exponent (unit_size.h)
  volume_map::WorkingSpace space = {};  // of all these coordinates, where there are no tetrahedra to be mapped

  volume_map::PolycubeSolid solid() const { return {positions, tetrahedra, surface, made.map}; }
  volume_map::PolycubeSurface boundary() const { return {made.map, fine.positions, fine.triangles, &space}; }
};

enum class Inside { tetrahedra, nothing };
// Where there is no polycube, and none has to be, the surface of the file is `fine`.
enum class Polycubes { needed, where_there_are, none };

// The solids that a surface bounds; its parts are turned to look out of them. Hexahedra stand it where one piece meets
// itself in few places; the library tetrahedra decides what can be filled. Figures and notes go to the session. Throws
// base::Error for what bounds no solid, with the place, and for more than `max_pieces` solids (0: any number).
volume_map::SurfacePieces pieces_of_surface(InputMesh& input, Inside inside, std::size_t max_pieces, Session& session);

// The pieces of a solid, each with a polycube of its own. Of a surface, which is filled with tetrahedra where these are
// requested (in builds with TetGen), or of a solid of tetrahedra, which keeps them. Surfaces of more than twice as many
// triangles as the options say are made coarser first. Figures go to the session.
std::vector<PolycubeSolidInput> read_polycube_solid(const PolycubeSolidOptions& options, Inside inside,
                                                    Polycubes polycubes, Session& session);

// Written beside its place, read again and compared: what was certified is what the file holds.
void write_cells_exactly(const std::string& path, const mesh::Mesh& cells, bool text, Session& session);

}  // namespace orbicube::cli
