#include "hexmesh/quality/hex_moves.h"

namespace orbicube::hexmesh {
namespace {

constexpr double lowest_coefficients = -5;

}  // namespace

HexMoves::HexMoves(HexMesh& mesh, const HexBoundary& boundary, const base::Host& host)
    : mesh_(mesh),
      boundary_(boundary),
      around_(base::cells_around(std::span<const Hexahedron>(mesh.hexahedra), mesh.positions.size(), host.memory)) {}

double HexMoves::corners(Index hexahedron) const {
  const double least = scaled_jacobian(mesh_.positions, mesh_.hexahedra[hexahedron]);
  return least > 0 ? least : least - 10;
}

double HexMoves::coefficients(Index hexahedron) const {
  return std::max(lowest_coefficients, 6 * min_bezier(mesh_.positions, mesh_.hexahedra[hexahedron]));
}

double HexMoves::quality(Index hexahedron, double enough) const {
  const double result = corners(hexahedron);
  return result < std::max(enough, lowest_coefficients) ? result : std::min(result, coefficients(hexahedron));
}

double HexMoves::worst_around(Index vertex, double enough) const {
  // Corners of all first: they take less time and tell most often.
  double worst = 1;
  for (const Index h : around(vertex)) {
    worst = std::min(worst, corners(h));
    if (worst < enough) return worst;
  }
  if (worst < lowest_coefficients) return worst;
  for (const Index h : around(vertex)) {
    worst = std::min(worst, coefficients(h));
    if (worst < enough) return worst;
  }
  return worst;
}

double HexMoves::worst() const {
  double result = 1;
  for (Index i = 0; i < mesh_.hexahedra.size(); ++i)
    result = std::min(result, quality(i, result));
  return result;
}

double HexMoves::sum_around(Index vertex) const {
  double sum = 0;
  for (const Index h : around(vertex))
    sum += scaled_jacobian(mesh_.positions, mesh_.hexahedra[h]);
  return sum;
}

bool HexMoves::try_better_places(Index vertex, double radius, const Range& range) {
  const double before = worst_around(vertex, lowest);
  double worst = before;
  try_places(vertex, radius, range, [&] {
    const double now = worst_around(vertex, worst);
    const bool better = now > worst + min_gain;
    if (better) worst = now;
    return better;
  });
  return worst > before;
}

double HexMoves::min_edge_length(Index vertex) const {
  double least = std::numeric_limits<double>::infinity();
  for (const Index i : around(vertex)) {
    const Hexahedron& h = mesh_.hexahedra[i];
    for (std::size_t k = 0; k < 8; ++k) {
      if (h[k] != vertex) continue;
      for (const std::uint8_t n : corner_neighbors[k])
        least = std::min(least, (mesh_.positions[h[n]] - mesh_.positions[vertex]).norm());
    }
  }
  return least;
}

}  // namespace orbicube::hexmesh
