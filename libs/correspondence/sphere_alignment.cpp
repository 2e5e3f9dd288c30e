#include "correspondence/sphere_alignment.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "harmonics/fitting/fit.h"
#include "harmonics/rotations/alignment.h"
#include "sphere_map/correspondence/landmark_flow.h"
#include "sphere_map/correspondence/placement.h"
#include "sphere_map/optimization/measure.h"

namespace orbicube::correspondence {
namespace {

using mesh::Index;
using mesh::Triangle;
using mesh::Vector3;
using Directions = base::Array<Vector3>;

Angles angles_between(std::span<const Vector3> a, std::span<const Vector3> b) {
  double sum = 0, largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double angle = std::atan2(a[i].cross(b[i]).norm(), a[i].dot(b[i]));
    sum += angle;
    largest = std::max(largest, angle);
  }
  return {sum / static_cast<double>(a.size()), largest};
}

using Placed = std::optional<sphere_map::Placement>;

Placed placed(const SphereShape& shape, const sphere_map::SphereMove& move, const base::Host& host) {
  const mesh::Mesh& mesh = shape.mesh;
  return sphere_map::placed_one_to_one(mesh.positions, shape.directions, mesh.triangles, move, host);
}

void turn(const Eigen::Matrix3d& rotation, std::span<Vector3> directions) {
  if (rotation == Eigen::Matrix3d::Identity()) return;
  for (Vector3& d : directions)
    d = (rotation * d).normalized();
}

// The middle of two vertices of one triangle.
polycube::VertexSource middle_of(const polycube::VertexSource& a, const polycube::VertexSource& b) {
  polycube::VertexSource result;
  std::size_t count = 0;
  for (const polycube::VertexSource* end : {&a, &b}) {
    for (std::size_t k = 0; k < 3 && end->corner[k] != mesh::no_index; ++k) {
      const auto used = result.corner.begin() + static_cast<std::ptrdiff_t>(count);
      const auto at = std::find(result.corner.begin(), used, end->corner[k]);
      if (at == used) result.corner[count++] = end->corner[k];
      result.weight[static_cast<std::size_t>(at - result.corner.begin())] += 0.5 * end->weight[k];
    }
  }
  return result;
}

void keep_sources(SphereShape& shape, const sphere_map::Placement& placement) {
  const std::size_t own = placement.positions.size() - placement.parents.size();
  shape.triangle_sources = placement.triangle_sources;
  shape.vertex_sources.clear();
  for (Index v = 0; v < own; ++v)
    shape.vertex_sources.push_back({{v, mesh::no_index, mesh::no_index}, {1, 0, 0}});
  for (const auto& [a, b] : placement.parents)
    shape.vertex_sources.push_back(middle_of(shape.vertex_sources[a], shape.vertex_sources[b]));
}

// From here on this is the shape's map.
Settled settle(SphereShape& shape, sphere_map::Placement placement, const Eigen::Matrix3d& rotation,
               const base::Host& host) {
  keep_sources(shape, placement);
  shape.mesh.positions = std::move(placement.positions);
  shape.mesh.triangles = std::move(placement.triangles);
  shape.directions = std::move(placement.directions);
  shape.locator = std::make_unique<sphere_map::Locator>(shape.mesh.triangles, shape.directions, host);
  return {rotation, placement.added, placement.moved};
}

// Where points of a map, given by their directions, are when its vertices are elsewhere.
std::vector<Vector3> carried(const SphereShape& shape, std::span<const Vector3> directions,
                             std::span<const Vector3> placed) {
  std::vector<Vector3> result;
  for (const Vector3& direction : directions) {
    const sphere_map::Location at = shape.locator->locate(direction);
    const Triangle& t = shape.locator->triangles()[at.triangle];
    Vector3 sum = Vector3::Zero();
    for (std::size_t k = 0; k < 3; ++k)
      sum += at.weights[static_cast<Eigen::Index>(k)] * placed[t[k]];
    result.push_back(sum.normalized());
  }
  return result;
}

// A direction on the great circle from a to b, unit vectors.
Vector3 between(const Vector3& a, const Vector3& b, double share) {
  const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
  const Vector3 across = b - a.dot(b) * a;
  if (!(across.norm() > 1e-12)) return share < 1 ? a : b;
  return std::cos(share * angle) * a + std::sin(share * angle) * across.normalized();
}

// The map turned and bent by a flow on the whole sphere; the landmarks themselves arrive at their goals to the last
// bits. `turned`: the landmarks turned.
Placed bent(const SphereShape& shape, const Eigen::Matrix3d& rotation, std::span<const Vector3> landmarks,
            const std::vector<Vector3>& turned, const std::vector<Vector3>& goals, const base::Host& host) {
  const sphere_map::LandmarkFlow flow(turned, goals, host);
  const auto bend = [&](std::span<Vector3> directions) {
    const Directions before(directions.begin(), directions.end(), host.memory);
    turn(rotation, directions);
    flow.move(directions, host);
    for (std::size_t v = 0; v < before.size(); ++v) {
      const auto at = std::find_if(landmarks.begin(), landmarks.end(), [&](const Vector3& landmark) {
        return (landmark - before[v]).squaredNorm() < 1e-30;  // but for its length
      });
      if (at != landmarks.end()) directions[v] = goals[static_cast<std::size_t>(at - landmarks.begin())];
    }
  };
  return placed(shape, bend, host);
}

}  // namespace

harmonics::Coefficients coefficients_of(const SphereShape& shape, const base::Host& host) {
  constexpr double spacing = 0.08;  // a third of the wave of the highest degree
  constexpr std::uint32_t degree = 24;
  Directions directions(host.memory), positions(host.memory);
  base::Array<double> weights(host.memory);
  const mesh::Mesh& mesh = shape.mesh;
  for (const Triangle& t : mesh.triangles) {
    const Vector3 &a = shape.directions[t[0]], &b = shape.directions[t[1]], &c = shape.directions[t[2]];
    const double longest = std::sqrt(std::max({(a - b).squaredNorm(), (b - c).squaredNorm(), (c - a).squaredNorm()}));
    const int parts = std::clamp(static_cast<int>(std::ceil(longest / spacing)), 1, 64);
    // The middles of equal parts of the flat triangle, seen from the center.
    const Vector3 normal = (b - a).cross(c - a);
    const auto add = [&](double u, double v) {
      const double p = u / (3 * parts), q = v / (3 * parts);
      const Vector3 at = (1 - p - q) * a + p * b + q * c;
      const double distance = at.norm();
      directions.push_back(at / distance);
      positions.push_back((1 - p - q) * mesh.positions[t[0]] + p * mesh.positions[t[1]] + q * mesh.positions[t[2]]);
      weights.push_back(std::abs(at.dot(normal)) / (2 * distance * distance * distance * parts * parts));
    };
    for (int i = 0; i < parts; ++i) {
      for (int j = 0; i + j < parts; ++j) {
        add(3 * i + 1, 3 * j + 1);
        if (i + j + 1 < parts) add(3 * i + 2, 3 * j + 2);
      }
    }
  }
  harmonics::FitReport report;
  return harmonics::fit(directions, weights, {positions.front().data(), 3 * positions.size()}, 3, {.degree = degree},
                        host, report);
}

void require_apart(std::span<const Vector3> landmarks) {
  constexpr double least = 0.01;
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if ((landmarks[i] - landmarks[j]).norm() < least) {
        throw base::Error("invalid-argument", "landmarks " + std::to_string(j) + " and " + std::to_string(i) +
                                                  " are nearer to each other than 0.01 on a sphere");
      }
    }
  }
}

Correlated align_by_correlation(const harmonics::Coefficients& first, SphereShape& shape, bool joint,
                                const base::Host& host) {
  harmonics::Alignment found =
      harmonics::align(first, coefficients_of(shape, host), {.turn_values = joint, .prefer_standing = joint}, host);
  // Maps that are in line to the last digits stay as they are, so that vertices at one place are one.
  if ((found.rotation - Eigen::Matrix3d::Identity()).norm() < 1e-9) found.rotation.setIdentity();
  Placed placement = placed(
      shape, [&](std::span<Vector3> directions) { turn(found.rotation, directions); }, host);
  if (!placement) throw base::Error("no-valid-result", "the map does not stay one to one when it is turned");
  return {found.correlation, found.values, settle(shape, std::move(*placement), found.rotation, host)};
}

Bent align_by_landmarks(SphereShape& shape, std::span<const Vector3> landmarks, std::span<const Vector3> first,
                        const base::Host& host) {
  const Eigen::Matrix3d rotation = sphere_map::best_rotation(landmarks, first);
  std::vector<Vector3> turned;
  for (const Vector3& d : landmarks)
    turned.push_back((rotation * d).normalized());
  Bent result;
  result.before = angles_between(landmarks, first);
  result.rotated = angles_between(turned, first);
  for (const double share : {1.0, 0.75, 0.5, 0.25, 0.0}) {
    std::vector<Vector3> goals;
    for (std::size_t k = 0; k < turned.size(); ++k)
      goals.push_back(between(turned[k], first[k].normalized(), share));
    Placed placement = bent(shape, rotation, landmarks, turned, goals, host);
    if (!placement) continue;
    result.share = share;
    result.after = angles_between(carried(shape, landmarks, placement->directions), first);
    result.vertices = placement->own.size();
    result.warp = sphere_map::measure(placement->own, placement->triangles, placement->directions, 0.1, 1, host);
    result.settled = settle(shape, std::move(*placement), rotation, host);
    return result;
  }
  throw base::Error("no-valid-result", "the map does not stay one to one when it is turned");
}

}  // namespace orbicube::correspondence
