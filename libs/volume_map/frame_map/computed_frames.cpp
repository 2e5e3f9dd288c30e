#include "volume_map/frame_map/computed_frames.h"

#include <array>
#include <exception>

#include "base/error.h"
#include "frame_field/frame_field.h"
#include "volume_map/frame_map/split_parameterization.h"

namespace orbicube::volume_map {

Parameterization parameterize_by_computed_frames(FramedSolid& solid, double feature_angle, bool split,
                                                 const ParameterizationOptions& options, const base::Host& host) {
  std::exception_ptr refusal;
  for (const auto repairs : {frame_field::Repairs::places, frame_field::Repairs::single_axis}) {
    const base::Stage stage(host, 0.5);
    frame_field::Options field;
    field.feature_angle = feature_angle;
    field.repairs = repairs;
    solid.frames = frame_field::compute(solid.positions, solid.tetrahedra, field, {}, host).field;
    try {
      return split ? parameterize_split(solid, options, host) : parameterize(solid, options, host);
    } catch (const base::Error& error) {
      if (error.status() != base::Status::no_valid_result) throw;
      if (!refusal) refusal = std::current_exception();
    }
  }
  std::rethrow_exception(refusal);
}

}  // namespace orbicube::volume_map
