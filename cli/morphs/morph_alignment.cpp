#include "morphs/morph_alignment.h"

#include <Eigen/Geometry>
#include <numbers>
#include <utility>
#include <vector>

#include "files/landmark_file.h"
#include "morphs/morph_placement.h"
#include "report/text.h"

namespace orbicube::cli {
namespace {

void report_settled(MorphShape& shape, const correspondence::Settled& settled) {
  shape.figures["rotation"] = json_of(settled.rotation);
  shape.figures["added"] = settled.added;
  shape.figures["moved"] = settled.moved;
}

Json json_of(const correspondence::Angles& angles) {
  return {{"mean", angles.mean}, {"max", angles.max}};
}

void report_bend(MorphShape& shape, std::size_t landmarks, const correspondence::Bent& bent, Session& session) {
  shape.figures["landmarks"] = {{"count", landmarks},
                                {"angle_before", json_of(bent.before)},
                                {"angle_rotated", json_of(bent.rotated)},
                                {"share", bent.share},
                                {"angle", json_of(bent.after)}};
  shape.figures["warp"] = {{"vertices", bent.vertices},
                           {"flipped", bent.warp.flipped + bent.warp.degenerate},
                           {"max_quasi_conformal", bent.warp.max_quasi_conformal},
                           {"min_area_ratio", bent.warp.min_area_ratio},
                           {"max_area_ratio", bent.warp.max_area_ratio}};
  if (bent.share < 1) {
    session.note(shape.path + ": landmarks go " + number(100 * bent.share) +
                 " percent of their way; all of it would flip triangles");
  }
  report_settled(shape, bent.settled);
}

}  // namespace

void align_by_correlation(std::deque<MorphShape>& shapes, bool joint, Session& session) {
  const base::Host& host = session.host();
  const harmonics::Coefficients first =
      about(shapes[0].path, Role::input, [&] { return correspondence::coefficients_of(shapes[0], host); });
  for (std::size_t i = 1; i < shapes.size(); ++i) {
    MorphShape& shape = shapes[i];
    about(shape.path, Role::input, [&] {
      const correspondence::Correlated found = correspondence::align_by_correlation(first, shape, joint, host);
      shape.figures["correlation"] = found.correlation;
      const Eigen::AngleAxisd turn_of_shape(found.turn_of_shape);
      constexpr double degrees = 180 / std::numbers::pi;
      shape.figures["turn"] = {{"angle", degrees * turn_of_shape.angle()}, {"rotation", json_of(found.turn_of_shape)}};
      session.say(shape.path + ": correlation " + number(found.correlation) +
                  (joint ? ", turned by " + number(degrees * turn_of_shape.angle()) + " degrees for it" : ""));
      report_settled(shape, found.settled);
    });
  }
}

void note_turned(const std::deque<MorphShape>& shapes, Session& session) {
  constexpr double noticeable = 20;  // degrees
  for (std::size_t i = 1; i < shapes.size(); ++i) {
    const double angle = shapes[i].figures["turn"]["angle"].get<double>();
    if (angle > noticeable)
      session.note(shapes[i].path + " lies turned by " + number(angle) + " degrees from " + shapes[0].path +
                   "; --placement turned brings it to where that one stands");
  }
}

void align_by_landmarks(std::deque<MorphShape>& shapes, const std::string& path, Session& session) {
  const base::Host& host = session.host();
  std::vector<MappedSurface> mapped;
  for (const MorphShape& shape : shapes)
    mapped.push_back({shape.mesh, shape.directions});
  const auto landmarks = about(path, Role::input, [&] {
    auto read = read_landmarks(path, mapped, host);
    for (const auto& of_shape : read)
      correspondence::require_apart(of_shape);
    return read;
  });
  for (std::size_t i = 1; i < shapes.size(); ++i) {
    about(path, Role::input, [&] {
      report_bend(shapes[i], landmarks[i].size(),
                  correspondence::align_by_landmarks(shapes[i], landmarks[i], landmarks[0], host), session);
    });
  }
}

}  // namespace orbicube::cli
