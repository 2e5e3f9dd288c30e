#include "tetrahedra/assemble.h"

#include <algorithm>
#include <string>
#include <utility>

#include "base/counted.h"
#include "base/error.h"
#include "base/grouping.h"
#include "mesh/search/predicates.h"
#include "tetrahedra/regions.h"

namespace orbicube::tetrahedra {
namespace {

constexpr const char* assemble_phase = "checking tetrahedra";

[[noreturn]] void refuse(const std::string& what) {
  throw base::Error("no-valid-result", what);
}

// The number that each of TetGen's vertices has in the result, whose positions are filled: those of the surface keep
// theirs, the others follow; no_index for those of cavities.
Array<Index> number_vertices(std::span<const Vector3> positions, const ScaledSurface& surface, const TetgenMesh& made,
                             const Regions& regions, const base::Host& host, Array<Vector3>& result) {
  const auto given = surface.positions();
  if (made.positions.size() < given.size() || !std::equal(given.begin(), given.end(), made.positions.begin()))
    refuse("TetGen left vertices of the surface out");
  Array<Index> number(made.positions.size(), mesh::no_index, host.memory);
  for (std::size_t t = 0; t < made.tetrahedra.size(); ++t) {
    if (regions.solid[t] == 0) continue;
    for (const std::int32_t v : made.tetrahedra[t])
      number[static_cast<std::size_t>(v)] = 0;
  }
  result.assign(positions.begin(), positions.end());
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (v < given.size()) {
      number[v] = surface.original()[v];
    } else if (number[v] != mesh::no_index) {
      number[v] = static_cast<Index>(result.size());
      result.push_back(surface.unscaled(made.positions[v]));
    }
  }
  return number;
}

template <std::size_t size>
std::array<Index, size> renumbered(const std::array<std::int32_t, size>& from, const Array<Index>& number) {
  std::array<Index, size> result;
  std::transform(from.begin(), from.end(), result.begin(),
                 [&](std::int32_t v) { return number[static_cast<std::size_t>(v)]; });
  return result;
}

void add_tetrahedra(const TetgenMesh& made, const Regions& regions, const Array<Index>& number, const base::Host& host,
                    Solid& solid) {
  const auto& x = solid.positions;
  solid.tetrahedra.reserve(made.tetrahedra.size());
  std::size_t flat = 0;
  for (std::size_t i = 0; i < made.tetrahedra.size(); ++i) {
    if (i % base::items_between_reports == 0) host.report(assemble_phase, i, made.tetrahedra.size());
    if (regions.solid[i] == 0) continue;
    const Tetrahedron t = renumbered(made.tetrahedra[i], number);
    flat += mesh::orientation_3d(x[t[0]], x[t[1]], x[t[2]], x[t[3]]) <= 0;
    solid.tetrahedra.push_back(t);
  }
  if (flat > 0) {
    refuse(std::to_string(flat) + " of " +
           base::counted(solid.tetrahedra.size(), "tetrahedron has", "tetrahedra have") +
           " no volume or are inverted in double precision");
  }
}

// Turns a face of a tetrahedron so that it looks away from the other corner.
Triangle outward(Triangle face, const Tetrahedron& t, const Array<Vector3>& x) {
  for (const Index v : t) {
    if (std::find(face.begin(), face.end(), v) != face.end()) continue;
    if (mesh::orientation_3d(x[face[0]], x[face[1]], x[face[2]], x[v]) > 0) std::swap(face[1], face[2]);
  }
  return face;
}

bool same_corners(Triangle a, Triangle b) {
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  return a == b;
}

void add_boundary(std::span<const Triangle> triangles, const TetgenMesh& made, const Regions& regions,
                  const Array<Index>& number, bool keep_surface, const base::Host& host, Solid& solid) {
  // Faces in the order of the triangles that they lie in.
  Array<Index> begin(triangles.size() + 1, 0, host.memory);
  for (const std::int32_t source : made.face_sources) {
    if (source < 0 || static_cast<std::size_t>(source) >= triangles.size())
      refuse("TetGen lists a face of no triangle");
    ++begin[static_cast<std::size_t>(source) + 1];
  }
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (begin[i + 1] == 0) refuse("triangle " + std::to_string(i) + " is not in TetGen's mesh");
  }
  base::add_up_counts(std::span(begin));
  solid.boundary.resize(made.faces.size());
  solid.boundary_source.resize(made.faces.size());
  for (std::size_t f = 0; f < made.faces.size(); ++f) {
    if (f % base::items_between_reports == 0) host.report(assemble_phase, f, made.faces.size());
    const auto source = static_cast<std::size_t>(made.face_sources[f]);
    Triangle face = renumbered(made.faces[f], number);
    if (keep_surface) {
      if (!same_corners(face, triangles[source]))
        refuse("triangle " + std::to_string(source) + " is not in TetGen's mesh as it was");
      face = triangles[source];
    }
    const Tetrahedron inside = renumbered(made.tetrahedra[static_cast<std::size_t>(regions.inside[f])], number);
    const Index at = begin[source]++;
    solid.boundary[at] = outward(face, inside, solid.positions);
    solid.boundary_source[at] = static_cast<Index>(source);
  }
}

}  // namespace

Solid assemble(std::span<const Vector3> positions, std::span<const Triangle> triangles, const ScaledSurface& surface,
               const TetgenMesh& made, bool keep_surface, const base::Host& host) {
  const Regions regions = find_regions(made, host);
  Solid solid(host.memory);
  solid.parts = regions.parts;
  solid.cavities = regions.cavities;
  const Array<Index> number = number_vertices(positions, surface, made, regions, host, solid.positions);
  add_tetrahedra(made, regions, number, host, solid);
  add_boundary(triangles, made, regions, number, keep_surface, host, solid);
  if (keep_surface && solid.boundary.size() != triangles.size()) refuse("TetGen cut triangles of the surface");
  return solid;
}

}  // namespace orbicube::tetrahedra
