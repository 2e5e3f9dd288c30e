#include "hexmesh/regions/conforming_regions.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/error.h"
#include "hexmesh/certificate/hex_embedding.h"
#include "hexmesh/certificate/hex_figures.h"
#include "hexmesh/features/boundary_quads.h"
#include "hexmesh/regions/boundary_lines.h"
#include "hexmesh/regions/hex_labels.h"
#include "hexmesh/regions/region_fitting.h"
#include "hexmesh/regions/region_sheets.h"
#include "volume_map/input/solid_boundary.h"

namespace orbicube::hexmesh {
namespace {

double mean_edge(const HexMesh& mesh) {
  double sum = 0;
  for (const Hexahedron& h : mesh.hexahedra)
    sum += (mesh.positions[h[6]] - mesh.positions[h[0]]).norm() / std::sqrt(3.0);
  return sum / static_cast<double>(mesh.hexahedra.size());
}

// Scaled by a power of two, rounding changes nothing.
int exponent_of_mean_edge(const HexMesh& mesh) {
  return static_cast<int>(std::lround(std::log2(mean_edge(mesh))));
}

void scale_positions(Array<Vector3>& positions, int exponent) {
  for (Vector3& p : positions)
    p *= std::ldexp(1.0, exponent);
}

Array<Quad> quads_between(const HexMesh& mesh, const Array<Index>& labels, const base::Host& host) {
  Array<Quad> quads(host.memory);
  for (const HexFace& face : faces_of(mesh.hexahedra, mesh.positions.size(), {}, host)) {
    if (face.second != no_index && labels[face.first] != labels[face.second]) quads.push_back(face.quad);
  }
  return quads;
}

// The number of labels that no hexahedron has.
std::size_t lost_labels(const Array<Index>& labels, const RegionInterfaces& interfaces, const base::Host& host) {
  Array<std::uint8_t> there(interfaces.numbers().size() + 1, 0, host.memory);
  for (const Index label : labels)
    there[label] = 1;
  return interfaces.numbers().size() - static_cast<std::size_t>(std::count(there.begin(), there.end(), 1));
}

// Vertices and middles of the triangles of one surface from the other.
double farthest_from(std::span<const Vector3> p, std::span<const mesh::Triangle> triangles,
                     const mesh::SurfaceSearch& from, const base::Host& host) {
  double most = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (i % 1024 == 0) host.report("regions", i, triangles.size());
    const mesh::Triangle& t = triangles[i];
    for (const Index v : t)
      most = std::max(most, from.nearest(p[v]).distance);
    most = std::max(most, from.nearest((p[t[0]] + p[t[1]] + p[t[2]]) / 3).distance);
  }
  return most;
}

// The input in units in which edges of hexahedra have about length 1.
struct Scaled {
  Scaled(const HexMesh& m, const mesh::Mesh& s, const base::Host& host)
      : exponent(exponent_of_mean_edge(m)), mesh(host.memory), solid(host.memory) {
    mesh.positions.assign(m.positions.begin(), m.positions.end());
    mesh.hexahedra.assign(m.hexahedra.begin(), m.hexahedra.end());
    solid.positions.assign(s.positions.begin(), s.positions.end());
    solid.tetrahedra.assign(s.tetrahedra.begin(), s.tetrahedra.end());
    solid.regions.tetrahedra.assign(s.regions.tetrahedra.begin(), s.regions.tetrahedra.end());
    scale_positions(mesh.positions, -exponent);
    scale_positions(solid.positions, -exponent);
  }

  int exponent;
  HexMesh mesh;
  mesh::Mesh solid;
};

double percent_between(const Scaled& scaled, const RegionInterfaces& interfaces, const Array<Quad>& quads,
                       const base::Host& host) {
  const Array<mesh::Triangle> halves = halves_of(quads, host.memory);
  const mesh::SurfaceSearch ours(scaled.mesh.positions, halves, host);
  const mesh::SurfaceSearch theirs(scaled.solid.positions, interfaces.between_regions(), host);
  const double distance = std::max(farthest_from(scaled.mesh.positions, halves, theirs, host),
                                   farthest_from(scaled.solid.positions, interfaces.between_regions(), ours, host));
  Vector3 low = scaled.solid.positions[0], high = low;
  for (const Vector3& p : scaled.solid.positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return 100 * distance / (high - low).norm();
}

// Adds sheets and moves the faces between labels, with sharp edges where these are clear and nothing folds. Returns
// whether the hexahedra are positive. Throws Error where sheets make the boundary no manifold.
bool fitted(HexMesh& mesh, Array<Index>& labels, RegionInterfaces& interfaces, const base::Host& host) {
  const double edge = mean_edge(mesh);
  const BoundaryLines lines(mesh, host);
  const Sheets sheets = add_sheets(mesh, labels, lines, interfaces, host);
  const Array<Vector3> start(mesh.positions, host.memory);
  if (interfaces.has_clear_creases(edge) && fit_to_regions(mesh, labels, sheets, lines, interfaces, true, host))
    return true;
  mesh.positions.assign(start.begin(), start.end());
  return fit_to_regions(mesh, labels, sheets, lines, interfaces, false, host);
}

// Takes the mesh into the result if it is valid.
bool take(HexMesh& mesh, HexResult& result, const mesh::Mesh& solid, const base::Host& host) {
  const BoundaryQuads outer(mesh.hexahedra, mesh.positions.size(), host);
  mesh.quads.assign(outer.quads().begin(), outer.quads().end());
  mesh.quad_patches.assign(mesh.quads.size(), 0);
  HexQuality quality = measure_hexahedra(mesh.positions, mesh.hexahedra, host);
  measure_embedding(mesh.positions, mesh.quads, quality, host);
  if (!quality.valid()) {
    host.log("moved to faces between regions: " + what_is_wrong(quality));
    return false;
  }
  const volume_map::BoundaryFirst first = volume_map::boundary_first(solid, host);
  const HexFigures figures = figures_of(mesh.positions, mesh.hexahedra, first.positions, first.surface, host);
  result.mesh = std::move(mesh);
  result.quality = quality;
  result.quality.volume = figures.volume;
  result.distance = figures.distance;
  result.volume_error = figures.volume_error;
  if (result.pieces.size() == 1) {
    HexPiece& piece = result.pieces[0];
    piece.hexahedra = result.mesh.hexahedra.size();
    piece.distance = figures.distance;
    piece.volume_error = figures.volume_error;
  }
  return true;
}

}  // namespace

RegionFigures conform_to_regions(HexResult& result, const mesh::Mesh& solid, const base::Host& host) {
  RegionFigures figures{Array<std::int32_t>(host.memory)};
  Scaled scaled(result.mesh, solid, host);
  RegionInterfaces interfaces(scaled.solid.positions, scaled.solid.tetrahedra, scaled.solid.regions.tetrahedra, host);
  Array<Index> labels = labels_of_hexahedra(scaled.mesh, scaled.solid, interfaces, host);
  const auto take_labels = [&] {
    figures.of_hexahedra.clear();
    for (const Index label : labels)
      figures.of_hexahedra.push_back(interfaces.numbers()[label - 1]);
  };
  take_labels();
  if (!interfaces.any()) return figures;
  figures.lost = lost_labels(labels, interfaces, host);
  if (figures.lost > 0) return figures;
  try {
    if (!fitted(scaled.mesh, labels, interfaces, host)) {
      host.log("moved to faces between regions, some hexahedra fold");
      return figures;
    }
  } catch (const base::Error& error) {
    if (error.must_end()) throw;
    host.log(std::string("faces between regions: ") + error.what());
    return figures;
  }
  const Array<Quad> between = quads_between(scaled.mesh, labels, host);
  const double distance = between.empty() ? 0 : percent_between(scaled, interfaces, between, host);
  scale_positions(scaled.mesh.positions, scaled.exponent);
  if (!take(scaled.mesh, result, solid, host)) return figures;
  take_labels();
  figures.conforming = true;
  figures.interface_quads = between.size();
  figures.distance = distance;
  return figures;
}

}  // namespace orbicube::hexmesh
