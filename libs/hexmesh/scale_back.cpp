#include "hexmesh/scale_back.h"

#include <cmath>

#include "mesh/search/unit_scale.h"
#include "volume_map/input/working_space.h"

namespace orbicube::hexmesh {

void scale_back(FeatureFigures& figures, int exponent) {
  for (MissingFeature& missing : figures.missing) {
    missing.from = volume_map::times_power_of_two(missing.from, -exponent);
    missing.to = volume_map::times_power_of_two(missing.to, -exponent);
  }
}

void scale_back(HexResult& result, int exponent) {
  mesh::scale_by_power(result.mesh.positions, -exponent);
  for (HexPiece& piece : result.pieces)
    piece.place = volume_map::times_power_of_two(piece.place, -exponent);
  result.quality.volume = std::ldexp(result.quality.volume, -3 * exponent);
}

}  // namespace orbicube::hexmesh
