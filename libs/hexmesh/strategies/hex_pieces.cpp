#include "hexmesh/strategies/hex_pieces.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/error.h"
#include "hexmesh/certificate/hex_embedding.h"
#include "hexmesh/certificate/hex_figures.h"
#include "hexmesh/quality/gap_opening.h"
#include "mesh/search/bounding_volume_tree.h"
#include "mesh/topology/place_text.h"
#include "volume_map/input/solid_pieces.h"

namespace orbicube::hexmesh {
namespace {

constexpr const char* hex_pieces_phase = "pieces";

// A further piece, in its place; the next piece's patches are numbered from `first_patch` on.
void add(const HexResult& piece, HexResult& all, Index& first_patch) {
  HexMesh& mesh = all.mesh;
  const auto first = static_cast<Index>(mesh.positions.size());
  Index patches = 0;
  mesh.positions.insert(mesh.positions.end(), piece.mesh.positions.begin(), piece.mesh.positions.end());
  const auto take = [first](const auto& from, auto& to) {
    for (auto cell : from) {
      for (Index& v : cell)
        v += first;
      to.push_back(cell);
    }
  };
  take(piece.mesh.hexahedra, mesh.hexahedra);
  take(piece.mesh.quads, mesh.quads);
  for (const Index patch : piece.mesh.quad_patches) {
    mesh.quad_patches.push_back(first_patch + patch);
    patches = std::max(patches, patch + 1);
  }
  first_patch += patches;
  all.padded = all.padded || piece.padded;
  all.follows_sharp_edges = all.follows_sharp_edges || piece.follows_sharp_edges;
  all.grid_based = all.grid_based || piece.grid_based;
  all.off_surface += piece.off_surface;
  all.pieces.insert(all.pieces.end(), piece.pieces.begin(), piece.pieces.end());
}

// A piece in the coordinates of the solid, times a power of two that keeps squares in range.
struct Original {
  Array<Vector3> positions;
  std::span<const mesh::Triangle> triangles;
  mesh::Box box;
  double volume = 0;

  Original(const PolycubeSurface& piece, const base::Host& host) : positions(host.memory) {
    host.report(hex_pieces_phase, 0, 0);
    const TargetSurface target(piece);
    triangles = target.triangles;
    for (const Vector3& p : target.positions)
      positions.push_back(piece.space != nullptr ? piece.space->back(p) : p);
    for (const mesh::Triangle& t : triangles) {
      for (const Index v : t)
        box.add(positions[v]);
    }
    const Vector3 center = 0.5 * (box.low + box.high);
    for (const mesh::Triangle& t : triangles) {
      const Vector3 a = positions[t[0]] - center, b = positions[t[1]] - center, c = positions[t[2]] - center;
      volume += a.dot(b.cross(c)) / 6;
    }
    volume = std::abs(volume);
  }

  Vector3 center() const { return 0.5 * (box.low + box.high); }
};

int exponent_of(const PolycubeSurface& piece) {
  return piece.space != nullptr ? piece.space->exponent() : 0;
}

// Back to the coordinates of the solid but for the power of two, and certified there.
void take_back(HexResult& result, const PolycubeSurface& piece, const base::Host& host) {
  if (piece.space == nullptr || piece.space->same()) return;
  for (Vector3& p : result.mesh.positions)
    p = piece.space->back(p);
  HexQuality quality = measure_hexahedra(result.mesh.positions, result.mesh.hexahedra, host);
  measure_embedding(result.mesh.positions, result.mesh.quads, quality, host);
  if (!quality.valid()) throw base::Error("no-valid-result", what_is_wrong(quality));
  result.quality = quality;
}

// Distance, error of the volume, and the one piece.
void add_figures(HexResult& result, const Original& original, const base::Host& host) {
  const HexFigures figures =
      figures_of(result.mesh.positions, result.mesh.hexahedra, original.positions, original.triangles, host);
  result.distance = figures.distance;
  result.volume_error = figures.volume_error;
  result.quality.volume = figures.volume;
  result.pieces.assign(1, HexPiece{original.center(), result.mesh.hexahedra.size(), figures.distance,
                                   figures.volume_error, result.grid_based});
}

// Of the whole, from all surfaces together.
void measure_whole(HexResult& all, std::span<const Original> pieces, const base::Host& host) {
  Array<Vector3> positions(host.memory);
  Array<mesh::Triangle> triangles(host.memory);
  for (const Original& piece : pieces) {
    const auto first = static_cast<Index>(positions.size());
    positions.insert(positions.end(), piece.positions.begin(), piece.positions.end());
    for (const mesh::Triangle& t : piece.triangles)
      triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  const HexFigures figures = figures_of(all.mesh.positions, all.mesh.hexahedra, positions, triangles, host);
  all.distance = figures.distance;
  all.volume_error = figures.volume_error;
  all.quality = measure_hexahedra(all.mesh.positions, all.mesh.hexahedra, host);
  measure_embedding(all.mesh.positions, all.mesh.quads, all.quality, host);
  all.quality.volume = figures.volume;
}

// Each piece is valid by itself; where pieces meet across the gaps between them, walls are moved apart. Figures follow.
void part_pieces(HexResult& all, std::span<const Original> originals, const base::Host& host) {
  if (!all.quality.positive() || all.quality.intersections == 0) return;
  const Array<Vector3> before(all.mesh.positions, host.memory);
  if (!open_gaps(all.mesh, host)) {
    all.mesh.positions = before;
    return;
  }
  std::size_t begin = 0;
  for (std::size_t i = 0; i < originals.size(); ++i) {
    HexPiece& piece = all.pieces[i];
    const auto own = std::span<const Hexahedron>(all.mesh.hexahedra).subspan(begin, piece.hexahedra);
    const HexFigures figures =
        figures_of(all.mesh.positions, own, originals[i].positions, originals[i].triangles, host);
    piece.distance = figures.distance;
    piece.volume_error = figures.volume_error;
    begin += piece.hexahedra;
  }
  measure_whole(all, originals, host);
}

// To the size of the solid.
void enlarge(HexResult& result, int exponent) {
  if (exponent == 0) return;
  for (Vector3& p : result.mesh.positions)
    p = volume_map::times_power_of_two(p, exponent);
  for (HexPiece& piece : result.pieces)
    piece.place = volume_map::times_power_of_two(piece.place, exponent);
  result.quality.volume = std::ldexp(result.quality.volume, 3 * exponent);
}

// The pieces with what percents are of: the diagonal of the whole, and of the volume what pieces may be off together.
Array<PolycubeSurface> with_ratios(std::span<const PolycubeSurface> pieces, std::span<const Original> originals,
                                   const base::Host& host) {
  mesh::Box box;
  double whole = 0;
  for (const Original& original : originals) {
    box.add(original.box);
    whole += original.volume;
  }
  const double least = 0.5 * whole / static_cast<double>(pieces.size());
  Array<PolycubeSurface> result(pieces.begin(), pieces.end(), host.memory);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const mesh::Box& own = originals[i].box;
    result[i].diagonal_ratio = (box.high - box.low).norm() / (own.high - own.low).norm();
    result[i].volume_ratio = std::max(originals[i].volume, least) / originals[i].volume;
  }
  return result;
}

}  // namespace

void complete(HexResult& result, const PolycubeSurface& surface, const base::Host& host) {
  add_figures(result, Original(surface, host), host);
}

HexResult make_hexahedra_of_pieces(std::span<const PolycubeSurface> pieces, const HexOptions& options,
                                   const base::Host& host) {
  base::require(!pieces.empty(), "there is no piece");
  volume_map::require_cells_for_pieces(pieces.size(), options.cells);
  Array<Original> originals(host.memory);
  double whole = 0;
  for (const PolycubeSurface& piece : pieces) {
    base::require(exponent_of(piece) == exponent_of(pieces[0]), "the pieces are in spaces of different sizes");
    originals.emplace_back(piece, host);
    whole += originals.back().volume;
  }
  const Array<PolycubeSurface> parts = with_ratios(pieces, originals, host);
  HexResult all(host.memory);
  double left = whole;
  Index first_patch = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const double volume = originals[i].volume;
    const base::Stage stage(host, 0.95 * volume / left);
    left -= volume;
    const auto share = [&](std::size_t cells) {
      const double part = std::round(static_cast<double>(cells) * volume / whole);
      return parts.size() == 1 ? cells : std::max(std::size_t{1}, static_cast<std::size_t>(part));
    };
    HexOptions of_piece = options;
    of_piece.cells = share(options.cells);
    of_piece.max_cells = share(options.max_cells);
    try {
      HexResult made = make_hexahedra(parts[i], of_piece, host);
      take_back(made, parts[i], host);
      add_figures(made, originals[i], host);
      if (parts.size() == 1)
        all = std::move(made);
      else
        add(made, all, first_patch);
    } catch (const base::Error& error) {
      if (error.status() != base::Status::no_valid_result || parts.size() == 1) throw;
      throw base::Error(error.kind(), std::string(error.what()) + "; in piece " + std::to_string(i) + " of " +
                                          std::to_string(parts.size()) + ", at " +
                                          mesh::place_text(volume_map::times_power_of_two(originals[i].center(),
                                                                                          exponent_of(pieces[0]))));
    }
  }
  if (parts.size() > 1) {
    measure_whole(all, originals, host);
    part_pieces(all, originals, host);
  }
  if (!all.quality.valid()) throw base::Error("no-valid-result", what_is_wrong(all.quality));
  enlarge(all, exponent_of(pieces[0]));
  return all;
}

}  // namespace orbicube::hexmesh
