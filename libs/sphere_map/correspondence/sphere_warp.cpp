#include "sphere_map/correspondence/sphere_warp.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>

#include "base/counted.h"
#include "base/error.h"
#include "mesh/search/nearest.h"
#include "sphere_map/correspondence/landmark_flow.h"
#include "sphere_map/sampling/rounding.h"

namespace orbicube::sphere_map {
namespace {

constexpr double min_apart = 0.01;

Array<Vector3> checked(std::span<const Vector3> directions, const char* what, const base::Host& host) {
  Array<Vector3> unit(host.memory);
  unit.reserve(directions.size());
  for (std::size_t i = 0; i < directions.size(); ++i) {
    require_direction(directions[i], what, i);
    unit.push_back(directions[i].stableNormalized());
  }
  for (std::size_t i = 0; i < unit.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if ((unit[i] - unit[j]).norm() < min_apart) {
        throw base::Error("invalid-argument", std::string(what) + "s " + std::to_string(j) + " and " +
                                                  std::to_string(i) + " are nearer to each other than 0.01");
      }
    }
  }
  return unit;
}

double nearest_two(std::span<const Vector3> points) {
  double nearest = 2;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j)
      nearest = std::min(nearest, (points[i] - points[j]).norm());
  }
  return nearest;
}

// Triangles of the icosphere are this large: with three edges between landmarks, each has a vertex of its own whose
// neighbors are nobody's.
std::size_t level_for(double apart) {
  double edge = 1.2;
  std::size_t level = 0;
  while (level < 8 && (level < 5 || 3 * edge > apart)) {
    edge /= 2;
    ++level;
  }
  return level;
}

}  // namespace

SphereWarp::SphereWarp(std::span<const Vector3> from, std::span<const Vector3> to, const base::Host& host)
    : rest_(host.memory), moved_(host.memory) {
  if (from.size() != to.size() || from.empty())
    throw base::Error("invalid-argument", base::counted(from.size(), "landmark is", "landmarks are") + " to go to " +
                                              std::to_string(to.size()));
  const Array<Vector3> start = checked(from, "landmark", host);
  const Array<Vector3> end = checked(to, "goal of landmark", host);
  rest_ = make_grid(GridKind::icosphere, level_for(std::min(nearest_two(start), nearest_two(end))), host);

  // The vertices nearest to the landmarks move onto them; each moves by half an edge or little more, inside its ring.
  Array<Index> vertex_of(start.size(), 0, host.memory);
  {
    const mesh::VertexSearch search(rest_.directions, host);
    for (std::size_t i = 0; i < start.size(); ++i)
      vertex_of[i] = search.nearest(start[i]);
  }
  for (std::size_t i = 0; i < start.size(); ++i)
    rest_.directions[vertex_of[i]] = start[i];

  moved_.assign(rest_.directions.begin(), rest_.directions.end());
  const LandmarkFlow flow(start, end, host);
  flow.move(moved_, host);
  for (std::size_t i = 0; i < start.size(); ++i)
    moved_[vertex_of[i]] = end[i];
  // Where the flow is steeper than the triangles are small, some may be flipped: their vertices move a little.
  if (count_not_positive(rest_.triangles, moved_) > 0) {
    Array<Index> landmark_of(moved_.size(), mesh::no_index, host.memory);
    for (std::size_t i = 0; i < start.size(); ++i)
      landmark_of[vertex_of[i]] = static_cast<Index>(i);
    const Store keep_landmarks = [&](Index v, const Vector3& direction) {
      return landmark_of[v] == mesh::no_index ? direction : end[landmark_of[v]];
    };
    RoundedMap repaired = round_and_repair(rest_.triangles, moved_, keep_landmarks, 0, host);
    moved_ = std::move(repaired.directions);
  }
  if (const std::size_t bad = count_not_positive(rest_.triangles, moved_); bad > 0) {
    throw base::Error("no-valid-result",
                      "the landmarks pull the sphere over itself: " +
                          base::counted(bad, "triangle of its grid is", "triangles of its grid are") + " flipped");
  }
  at_rest_ = std::make_unique<const Locator>(rest_.triangles, rest_.directions, host);
  when_moved_ = std::make_unique<const Locator>(rest_.triangles, moved_, host);
}

Vector3 SphereWarp::through(const Locator& locator, std::span<const Vector3> image, const Vector3& direction) {
  const Location at = locator.locate(direction);
  const Triangle& t = locator.triangles()[at.triangle];
  Vector3 sum = Vector3::Zero();
  for (std::size_t k = 0; k < 3; ++k) {
    const double weight = at.weights[static_cast<Eigen::Index>(k)];
    if (weight == 1) return image[t[k]];
    sum += weight * image[t[k]];
  }
  return sum.normalized();
}

Measurement SphereWarp::distortion(const base::Host& host) const {
  return measure(rest_.directions, rest_.triangles, moved_, 0.1, 1, host);
}

}  // namespace orbicube::sphere_map
