#include "sphere_map/rotation_search.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "sphere_map/grids.h"
#include "sphere_map/normalise.h"
#include "sphere_map/sampling.h"

namespace orbicube::sphere_map {
namespace {

using Eigen::Matrix3d;

// A shape's positions at the vertices of a grid, of mean 0 and mean square 1.
Array<Vector3> centred_samples(const Locator& locator, std::span<const Vector3> positions,
                               std::span<const Vector3> directions, const base::Host& host) {
  if (positions.size() != locator.directions().size())
    throw base::Error("invalid-argument", "positions have another size than the map");
  Array<Vector3> samples =
      sample_vectors(locator, directions, normalised(positions, host.memory), Interpolation::linear, host);
  const auto count = static_cast<double>(samples.size());
  Vector3 mean = Vector3::Zero();
  for (const Vector3& x : samples)
    mean += x / count;
  double square = 0;
  for (Vector3& x : samples) {
    x -= mean;
    square += x.squaredNorm() / count;
  }
  if (!(square > 0)) throw base::Error("no-valid-result", "a shape that is a single point has no direction");
  for (Vector3& x : samples)
    x /= std::sqrt(square);
  return samples;
}

// Samples on the cells of a cube, found by a division: for the many rotations that are tried first.
class CubeTable {
 public:
  CubeTable(const Locator& locator, std::span<const Vector3> positions, const base::Host& host)
      : samples_(centred_samples(locator, positions, directions(host), host)) {}

  const Vector3& at(const Vector3& d) const {
    Eigen::Index axis = 0;
    const double size = d.cwiseAbs().maxCoeff(&axis);
    const auto cell = [&](Eigen::Index k) {
      return static_cast<std::size_t>(std::min(0.5 * (d[k] / size + 1) * cells, cells - 0.5));
    };
    const std::size_t face = static_cast<std::size_t>(2 * axis) + (d[axis] < 0 ? 1 : 0);
    return samples_[(face * side + cell((axis + 1) % 3)) * side + cell((axis + 2) % 3)];
  }

 private:
  static constexpr std::size_t side = 48;
  static constexpr double cells = side;

  static Array<Vector3> directions(const base::Host& host) {
    Array<Vector3> result(host.memory);
    for (std::size_t face = 0; face < 6; ++face) {
      const auto axis = static_cast<Eigen::Index>(face / 2);
      for (std::size_t i = 0; i < side; ++i) {
        for (std::size_t j = 0; j < side; ++j) {
          Vector3 d;
          d[axis] = face % 2 == 0 ? 1 : -1;
          d[(axis + 1) % 3] = 2 * (static_cast<double>(i) + 0.5) / cells - 1;
          d[(axis + 2) % 3] = 2 * (static_cast<double>(j) + 0.5) / cells - 1;
          result.push_back(d.normalized());
        }
      }
    }
    return result;
  }

  Array<Vector3> samples_;
};

// Rotations about 10 degrees from each other: the pole goes to each vertex of an icosphere, turned by each angle.
Array<Matrix3d> rotations_all_over(const base::Host& host) {
  constexpr int angles = 36;
  const Grid poles = make_grid(GridKind::icosphere, 2, host);
  Array<Matrix3d> rotations(host.memory);
  for (const Vector3& pole : poles.directions) {
    const Eigen::Quaterniond to_pole = Eigen::Quaterniond::FromTwoVectors(Vector3::UnitZ(), pole);
    for (int i = 0; i < angles; ++i) {
      const Eigen::AngleAxisd turn(2 * std::numbers::pi * i / angles, Vector3::UnitZ());
      rotations.push_back((to_pole * turn).toRotationMatrix());
    }
  }
  return rotations;
}

double angle_between(const Matrix3d& a, const Matrix3d& b) {
  return std::acos(std::clamp(0.5 * ((a.transpose() * b).trace() - 1), -1.0, 1.0));
}

}  // namespace

CorrelatedRotation correlated_rotation(const Locator& moving, std::span<const Vector3> moving_positions,
                                       const Locator& fixed, std::span<const Vector3> fixed_positions,
                                       const base::Host& host) {
  const Grid grid = make_grid(GridKind::icosphere, 3, host);
  const Array<Vector3> wanted = centred_samples(fixed, fixed_positions, grid.directions, host);
  const CubeTable table(moving, moving_positions, host);
  const Array<Vector3> unit_size = normalised(moving_positions, host.memory);
  const auto count = static_cast<double>(grid.directions.size());

  const Array<Matrix3d> rotations = rotations_all_over(host);
  Array<double> scores(rotations.size(), 0, host.memory);
  constexpr std::size_t piece = 64;
  constexpr std::size_t pieces_at_once = 16;
  const std::size_t pieces = (rotations.size() + piece - 1) / piece;
  for (std::size_t first = 0; first < pieces; first += pieces_at_once) {
    host.report("trying rotations", first, pieces);
    host.parallel_for(std::min(pieces_at_once, pieces - first), [&](std::size_t p) {
      const std::size_t end = std::min(rotations.size(), (first + p + 1) * piece);
      for (std::size_t r = (first + p) * piece; r < end; ++r) {
        for (std::size_t i = 0; i < grid.directions.size(); ++i)
          scores[r] += wanted[i].dot(table.at(rotations[r].transpose() * grid.directions[i]));
      }
    });
  }
  Array<std::size_t> order(host.memory);
  for (std::size_t r = 0; r < rotations.size(); ++r)
    order.push_back(r);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return scores[a] > scores[b]; });

  // The correlation proper, with the mean and size of what is sampled.
  const auto correlation = [&](const Matrix3d& rotation) {
    Vector3 mean = Vector3::Zero();
    double square = 0, product = 0;
    for (std::size_t i = 0; i < grid.directions.size(); ++i) {
      const Location at = moving.locate(rotation.transpose() * grid.directions[i]);
      const Triangle& t = moving.triangles()[at.triangle];
      const Vector3 x =
          at.weights[0] * unit_size[t[0]] + at.weights[1] * unit_size[t[1]] + at.weights[2] * unit_size[t[2]];
      mean += x / count;
      square += x.squaredNorm() / count;
      product += x.dot(wanted[i]) / count;
    }
    const double variance = square - mean.squaredNorm();
    return variance > 0 ? product / std::sqrt(variance) : 0;
  };
  struct Candidate {
    CorrelatedRotation at;
    double step;
  };
  constexpr std::size_t most_candidates = 8;
  constexpr double apart = 0.3, first_step = 0.1, last_step = 5e-4;
  Array<Candidate> candidates(host.memory);
  for (const std::size_t r : order) {
    const bool near = std::any_of(candidates.begin(), candidates.end(), [&](const Candidate& other) {
      return angle_between(other.at.rotation, rotations[r]) < apart;
    });
    if (near) continue;
    candidates.push_back({{rotations[r], correlation(rotations[r])}, first_step});
    if (candidates.size() == most_candidates) break;
  }
  // Each is turned about each axis by steps that are halved when none of them helps.
  const auto improve = [&](Candidate& candidate) {
    if (candidate.step < last_step) return;
    CorrelatedRotation next = candidate.at;
    for (int axis = 0; axis < 3; ++axis) {
      for (const double angle : {-candidate.step, candidate.step}) {
        const Matrix3d tried = Eigen::AngleAxisd(angle, Vector3::Unit(axis)).toRotationMatrix() * candidate.at.rotation;
        if (const double value = correlation(tried); value > next.correlation + 1e-12) next = {tried, value};
      }
    }
    if (!(next.correlation > candidate.at.correlation)) candidate.step /= 2;
    candidate.at = next;
  };
  for (bool moving_on = true; moving_on;) {
    host.report("refining rotations", 0, 0);
    host.parallel_for(candidates.size(), [&](std::size_t i) { improve(candidates[i]); });
    moving_on =
        std::any_of(candidates.begin(), candidates.end(), [&](const Candidate& c) { return c.step >= last_step; });
  }
  CorrelatedRotation result =
      std::max_element(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
        return a.at.correlation < b.at.correlation;
      })->at;
  // Products of many rotations: orthogonal to the last bits again.
  result.rotation = Eigen::Quaterniond(result.rotation).normalized().toRotationMatrix();
  return result;
}

}  // namespace orbicube::sphere_map
