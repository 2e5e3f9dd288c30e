// Any triangles to a closed, oriented, manifold surface, step by step, with a certificate of what was reached.
#pragma once

#include <span>
#include <string>

#include "repair/certificate.h"
#include "repair/handles/handles.h"
#include "repair/holes/fill.h"
#include "repair/soup/slivers.h"
#include "repair/soup/soup.h"
#include "repair/soup/t_junctions.h"
#include "repair/soup/weld.h"
#include "repair/topology/contacts.h"
#include "repair/topology/parts.h"
#include "repair/types.h"
#include "repair/wrap/wrap.h"

namespace orbicube::repair {

struct Options {
  bool weld = true;
  double weld_distance =
      0;              // 0: the same position and, while edges stay open, 1e-6 of the diagonal of the bounding box
  bool clean = true;  // removes faces with a repeated corner, copies of faces, and unused vertices
  bool slivers = true;
  double sliver_ratio = 1e-6;  // height over the longest side
  double sliver_move = 0;      // bound of the movement of the surface; 0: 1e-5 of the diagonal
  bool t_junctions = true;
  double t_junction_distance = 0;  // of a vertex from the edge; 0: 1e-6 of the diagonal
  bool orient = true;
  bool contacts = true;
  double contact_gap = 0;
  bool drop_parts = true;
  PartOptions parts{};
  bool fill_holes = true;
  HoleOptions holes{};
  HandleOptions handles{};
  double wrap_offset = 0;          // distance of a surface around all parts, which replaces them; 0: none
  bool find_intersections = true;  // for the certificate
};

struct Report {
  std::size_t input_vertices = 0, input_triangles = 0;
  WeldFigures weld;
  CleanFigures clean;
  std::size_t unused_vertices = 0;
  SliverFigures slivers;
  TJunctionFigures t_junctions;
  bool orientable = true;
  std::size_t reversed_triangles = 0;
  ContactFigures contacts;
  PartFigures parts;
  HoleFigures holes;
  HandleFigures handles;
  WrapFigures wrap;
  bool handles_searched = true;  // false: the surface was not closed, oriented and manifold
  Move move;
  Certificate certificate;
  bool changed = false;
};

struct Repaired {
  explicit Repaired(std::pmr::memory_resource* memory) : surface(memory), events(memory) {}
  Soup surface;
  Array<Event> events;  // what was done, in the order in which it was
  Report report;
};

// Runs the steps in the order of the options. Each changes nothing where nothing is wrong: a clean surface comes back
// bit for bit. Coordinates may have any size. Whether a closed, oriented, manifold surface without self-intersections
// was reached is in the certificate. The same bits for any number of threads. O(n log n) besides the holes. Throws
// Error "invalid-argument" for an index that is out of range, a position that is not finite or an option that is,
// "empty-mesh" if there are no triangles, "degenerate-geometry" if nothing is left, "cancelled".
Repaired repair(std::span<const Vector3> positions, std::span<const Triangle> triangles, const Options& options,
                const base::Host& host);

// Returns what the certificate lacks for a solid, in words, or an empty text: "2 boundary loops, 3 self-intersections".
std::string shortcomings(const Certificate& certificate);

}  // namespace orbicube::repair
