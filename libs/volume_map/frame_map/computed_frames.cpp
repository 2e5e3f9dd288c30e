#include "volume_map/frame_map/computed_frames.h"

#include <array>
#include <exception>

#include "base/error.h"
#include "frame_field/frame_field.h"
#include "volume_map/frame_map/split_parameterization.h"

namespace orbicube::volume_map {
namespace {

// The smoothest field first. Harmonics alone, without a search for lower energy, leave other curves, which repairs
// bring together where those of the search have turning points.
struct Attempt {
  frame_field::Start start;
  frame_field::Repairs repairs;
};
constexpr std::array<Attempt, 4> attempts = {{
    {frame_field::Start::automatic, frame_field::Repairs::places},
    {frame_field::Start::automatic, frame_field::Repairs::single_axis},
    {frame_field::Start::harmonic, frame_field::Repairs::places},
    {frame_field::Start::harmonic, frame_field::Repairs::single_axis},
}};

}  // namespace

Parameterization parameterize_by_computed_frames(FramedSolid& solid, double feature_angle, bool split,
                                                 const ParameterizationOptions& options, const base::Host& host) {
  std::exception_ptr refusal;
  for (const Attempt& attempt : attempts) {
    const base::Stage stage(host, 0.5);
    frame_field::Options field;
    field.feature_angle = feature_angle;
    field.start = attempt.start;
    field.repairs = attempt.repairs;
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
