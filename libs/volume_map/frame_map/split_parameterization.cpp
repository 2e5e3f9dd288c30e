#include "volume_map/frame_map/split_parameterization.h"

#include <utility>

#include "mesh/search/predicates.h"

namespace orbicube::volume_map {
namespace {

constexpr int max_splittings = 5;

Array<Index> inverted_of(const Parameterization& map, const base::Host& host) {
  Array<Index> result(host.memory);
  for (Index t = 0; t < map.corners.size(); ++t) {
    const auto& c = map.corners[t];
    if (mesh::orientation_3d(c[0], c[1], c[2], c[3]) <= 0) result.push_back(t);
  }
  return result;
}

}  // namespace

Parameterization parameterize_split(FramedSolid& solid, const ParameterizationOptions& options,
                                    const base::Host& host) {
  Parameterization best = parameterize(solid, options, host);
  FramedSolid trial(host.memory);
  for (int round = 0; round < max_splittings && best.inverted > 0; ++round) {
    trial.positions = solid.positions;
    trial.tetrahedra = solid.tetrahedra;
    trial.frames = solid.frames;
    if (round > 0) split_around(trial, inverted_of(best, host), host);
    split_for_frames(trial, host);
    Parameterization map = parameterize(trial, options, host);
    if (map.inverted >= best.inverted) break;
    best = std::move(map);
    std::swap(solid, trial);
  }
  return best;
}

}  // namespace orbicube::volume_map
