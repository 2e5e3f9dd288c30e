#include "volume_map/input/polycube_pieces.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "base/counted.h"
#include "base/error.h"
#include "mesh/topology/orient.h"
#include "mesh/topology/topology.h"
#include "volume_map/input/coarse_surface.h"
#include "volume_map/input/solid_boundary.h"
#include "volume_map/solid/solid_polycube.h"

namespace orbicube::volume_map {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void take_tetrahedra(const mesh::Mesh& solid, PolycubePiece& result, const base::Host& host) {
  BoundaryFirst first = boundary_first(solid, host);
  result.positions = std::move(first.positions);
  result.tetrahedra = std::move(first.tetrahedra);
  result.surface = std::move(first.surface);
}

void take_surface(std::size_t triangles, mesh::Mesh&& surface, PolycubePiece& result, const base::Host& host) {
  CoarseSurface coarse =
      coarse_surface(surface.positions, surface.triangles, coarse_target(triangles, surface.triangles.size()), host);
  result.positions = std::move(coarse.positions);
  result.surface = std::move(coarse.triangles);
  if (result.surface.size() < surface.triangles.size()) result.fine = std::move(surface);
}

void fill(const PieceOptions& options, mesh::Mesh&& surface, PolycubePiece& result, const base::Host& host) {
  FilledSolid filled = [&] {
    try {
      return filled_solid(surface, options.triangles, options.fill, host);
    } catch (const base::Error& error) {
      if (std::string_view(error.kind()) == "self-intersection")
        refuse_self_intersections(surface.positions, surface.triangles, 0, host);
      throw;
    }
  }();
  result.positions = std::move(filled.solid.positions);
  result.tetrahedra = std::move(filled.solid.tetrahedra);
  result.surface = std::move(filled.surface);
  if (result.surface.size() < surface.triangles.size()) result.fine = std::move(surface);
}

// Of angles, on the mean: where a polycube is no basis for hexahedra and only takes long. Those of use have 1 to 3.
constexpr double useless = 50;

void make_polycube(const PieceOptions& options, PolycubePiece& result, const InputFindings& findings,
                   const base::Host& host) {
  // The surface's vertices are the first ones; what lies inside is of no interest to the polycube.
  mesh::Index outer = 0;
  for (const mesh::Triangle& t : result.surface) {
    for (const mesh::Index v : t)
      outer = std::max(outer, v + 1);
  }
  const std::span<const mesh::Vector3> positions = std::span(result.positions).first(outer);
  if (options.given.target != nullptr) {
    bool is_own = false;
    result.made = construct_given(positions, result.surface, options.given, result.space, is_own, host);
    findings.note(is_own ? "the given polycube has the triangles of the surface: its vertices are their images"
                         : "the given polycube has other triangles than the surface: it was drawn on it");
    return;
  }
  try {
    if (options.polycubes != Polycubes::none) {
      result.made = construct_polycube(
          positions, result.surface, {.corners = options.corners, .preferred_corners = 60, .seed = options.seed}, host);
      if (options.polycubes == Polycubes::needed || result.made.distortion.angle_mean < useless) return;
      findings.note("there is no polycube of use: mean distortion of angles " +
                    std::to_string(std::lround(result.made.distortion.angle_mean)));
      result.made = polycube::Construction(host.memory);
    }
  } catch (const base::Error& error) {
    if (options.polycubes == Polycubes::needed || error.status() != base::Status::no_valid_result) throw;
    findings.note("there is no polycube: " + std::string(error.what()));
  }
  if (!result.fine.triangles.empty()) return;
  result.fine.positions.assign(positions.begin(), positions.end());
  result.fine.triangles.assign(result.surface.begin(), result.surface.end());
}

Pieces cell_pieces(const mesh::Mesh& solid, const base::Host& host) {
  if (!solid.hexahedra.empty()) throw base::Error("unsupported", "a mesh of hexahedra already");
  return pieces_of(solid.tetrahedra, solid.positions.size(), host);
}

// Solids are on the inner side of their outer walls and on the outer side of the walls of cavities.
void turn_parts(const SurfacePieces& pieces, std::span<mesh::Triangle> triangles, const InputFindings& findings) {
  std::size_t turned = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (pieces.wrong_side[i] == 0) continue;
    std::swap(triangles[i][1], triangles[i][2]);
    ++turned;
  }
  if (turned > 0)
    findings.note(base::counted(turned, "triangle of parts oriented into the solid was",
                                "triangles of parts oriented into the solid were") +
                  " reversed");
}

// The solid of one piece, still without its polycube. `power`: see size_exponent().
PolycubePiece solid_of_piece(const PieceOptions& options, mesh::Mesh part, int power, const base::Host& host) {
  PolycubePiece result(host.memory);
  const auto enter_working_space = [&](std::span<mesh::Vector3> positions, std::span<const mesh::Triangle> surface) {
    if (options.inside == Inside::tetrahedra) return;
    result.space = WorkingSpace(positions, surface, power);
    result.space.take(positions);
  };
  const bool cells = !part.tetrahedra.empty() || !part.hexahedra.empty();
  if (!cells) enter_working_space(part.positions, part.triangles);
  if (cells) {
    take_tetrahedra(part, result, host);
    enter_working_space(result.positions, result.surface);
  } else if (options.polycubes == Polycubes::none) {
    result.fine = std::move(part);
  } else if (options.inside == Inside::nothing) {
    take_surface(options.triangles, std::move(part), result, host);
  } else {
    fill(options, std::move(part), result, host);
  }
  return result;
}

void add_polycube_figures(const std::vector<PolycubePiece>& pieces, InputFindings& findings) {
  PolycubeFigures figures;
  for (const PolycubePiece& piece : pieces) {
    if (piece.made.map.triangles.empty()) return;
    figures.corners += piece.made.certificate.corners;
    figures.patches += piece.made.certificate.patch_count;
    figures.genus += piece.made.certificate.genus;
    figures.surface_triangles += piece.surface.size();
    figures.angles += piece.made.distortion.angle_mean / static_cast<double>(pieces.size());
    figures.areas += piece.made.distortion.area_mean / static_cast<double>(pieces.size());
  }
  findings.polycube = figures;
}

void require_one_piece(const Pieces& pieces, const InputFindings& findings) {
  if (pieces.count > 1 || (findings.surface && findings.surface->cavities > 0))
    throw base::Error("unsupported", "a given polycube is for a solid of one piece without cavities");
}

}  // namespace

SurfacePieces pieces_of_surface(mesh::Mesh& surface, Inside inside, std::size_t max_pieces, InputFindings& findings,
                                const base::Host& host) {
  constexpr double few = 0.05;
  require_closed_surface(surface.positions, surface.triangles, host);
  const mesh::OrientReport turned = mesh::orient(surface.positions, surface.triangles, host);
  for (const std::string& note : turned.notes())
    findings.note(note);
  SurfacePieces pieces = surface_pieces(surface.positions, surface.triangles, host);
  if (max_pieces > 0) require_cells_for_pieces(pieces.count, max_pieces);
  turn_parts(pieces, surface.triangles, findings);
  if (inside == Inside::nothing || pieces.count + pieces.cavities > 1) {
    const std::size_t pairs = refuse_self_intersections(surface.positions, surface.triangles, few, host);
    if (pairs > 0)
      findings.note(base::counted(pairs, "pair of triangles meets", "pairs of triangles meet") +
                    " where they should not");
  }
  findings.surface = {surface.positions.size(), surface.triangles.size(),
                      mesh::topology(surface.positions, surface.triangles, host).genus.value_or(0), pieces.cavities};
  return pieces;
}

std::vector<PolycubePiece> polycube_pieces(mesh::Mesh&& input, const PieceOptions& all_options, InputFindings& findings,
                                           const base::Host& host) {
  PieceOptions options = all_options;
  if (options.given.target != nullptr) options.triangles = 0;
  const auto start = std::chrono::steady_clock::now();
  const bool cells = !input.tetrahedra.empty() || !input.hexahedra.empty();
  std::vector<PolycubePiece> results;
  double filling = 0;
  const Pieces pieces =
      cells ? cell_pieces(input, host) : pieces_of_surface(input, options.inside, options.max_pieces, findings, host);
  if (cells && options.max_pieces > 0) require_cells_for_pieces(pieces.count, options.max_pieces);
  if (options.given.target != nullptr) require_one_piece(pieces, findings);
  std::optional<PieceCutter> cutter;
  if (pieces.count > 1) cutter.emplace(input, pieces, host);
  const int power = size_exponent(input.positions);
  for (std::size_t i = 0; i < pieces.count; ++i) {
    const base::Stage stage(host, 1.0 / static_cast<double>(pieces.count - i));
    const auto before = std::chrono::steady_clock::now();
    PolycubePiece piece = solid_of_piece(options, cutter ? cutter->piece(i) : std::move(input), power, host);
    filling += seconds_since(before);
    make_polycube(options, piece, findings, host);
    results.push_back(std::move(piece));
  }
  add_polycube_figures(results, findings);
  findings.pieces = results.size();
  findings.fill_seconds = filling;
  findings.polycube_seconds = seconds_since(start) - filling;
  findings.examined = true;
  return results;
}

}  // namespace orbicube::volume_map
