#include "volume_map/hex_pieces.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/error.h"

namespace orbicube::volume_map {
namespace {

// A further piece, in its place.
void add(const HexResult& piece, HexResult& all) {
  HexMesh& mesh = all.mesh;
  const auto first = static_cast<Index>(mesh.positions.size());
  Index first_patch = 0;
  for (const Index patch : mesh.quad_patches)
    first_patch = std::max(first_patch, patch + 1);
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
  for (const Index patch : piece.mesh.quad_patches)
    mesh.quad_patches.push_back(first_patch + patch);
  all.padded = all.padded || piece.padded;
  all.follows_sharp_edges = all.follows_sharp_edges || piece.follows_sharp_edges;
  all.by_voxels = all.by_voxels || piece.by_voxels;
  all.off_surface += piece.off_surface;
  all.distance = std::max(all.distance, piece.distance);
  all.volume_error = std::max(all.volume_error, piece.volume_error);
}

}  // namespace

HexResult make_hexahedra_of_pieces(std::span<const PolycubeSurface> pieces, const HexOptions& options,
                                   const base::Host& host) {
  base::require(!pieces.empty(), "there is no piece");
  if (pieces.size() == 1) return make_hexahedra(pieces[0], options, host);
  Array<double> volumes(host.memory);
  for (const PolycubeSurface& piece : pieces)
    volumes.push_back(std::abs(WantedSurface(piece).volume));
  const double whole = std::accumulate(volumes.begin(), volumes.end(), 0.0);
  HexResult all(host.memory);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto share = [&](std::size_t cells) {
      const double part = std::round(static_cast<double>(cells) * volumes[i] / whole);
      return std::max(std::size_t{1}, static_cast<std::size_t>(part));
    };
    HexOptions of_piece = options;
    of_piece.cells = share(options.cells);
    of_piece.most_cells = share(options.most_cells);
    try {
      add(make_hexahedra(pieces[i], of_piece, host), all);
    } catch (const base::Error& error) {
      if (error.status() != base::Status::no_valid_result) throw;
      throw base::Error(error.kind(), std::string(error.what()) + "; in piece " + std::to_string(i));
    }
  }
  all.quality = measure_hexahedra(all.mesh.positions, all.mesh.hexahedra, host);
  return all;
}

}  // namespace orbicube::volume_map
