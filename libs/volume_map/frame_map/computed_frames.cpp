#include "volume_map/frame_map/computed_frames.h"

#include <array>
#include <exception>

#include "base/error.h"
#include "frame_field/frame_field.h"

namespace orbicube::volume_map {

Parameterization parameterize_by_computed_frames(std::span<const Vector3> positions,
                                                 std::span<const Tetrahedron> tetrahedra, double feature_angle,
                                                 const ParameterizationOptions& options, const base::Host& host) {
  FramedSolid solid(host.memory);
  solid.positions.assign(positions.begin(), positions.end());
  solid.tetrahedra.assign(tetrahedra.begin(), tetrahedra.end());
  std::exception_ptr refusal;
  for (const auto repairs : {frame_field::Repairs::places, frame_field::Repairs::single_axis}) {
    const base::Stage stage(host, 0.5);
    frame_field::Options field;
    field.feature_angle = feature_angle;
    field.repairs = repairs;
    solid.frames = frame_field::compute(positions, tetrahedra, field, {}, host).field;
    try {
      return parameterize(solid, options, host);
    } catch (const base::Error& error) {
      if (error.status() != base::Status::no_valid_result) throw;
      if (!refusal) refusal = std::current_exception();
    }
  }
  std::rethrow_exception(refusal);
}

}  // namespace orbicube::volume_map
