#include "volume_map/solid/cavity_placement.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace orbicube::volume_map {
namespace {

using mesh::Triangle;

// Weights of a triangle's corners for a point off its plane; zero where the plane goes through the point.
std::array<double, 3> mean_value_weights(const std::array<Vector3, 3>& to) {
  constexpr double flat = 1e-10;
  std::array<double, 3> length{}, angle{}, weight{};
  std::array<Vector3, 3> u;
  for (std::size_t k = 0; k < 3; ++k) {
    length[k] = to[k].norm();
    if (length[k] == 0) return weight;
    u[k] = to[k] / length[k];
  }
  double half = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    angle[k] = 2 * std::asin(std::min(1.0, 0.5 * (u[(k + 1) % 3] - u[(k + 2) % 3]).norm()));
    half += 0.5 * angle[k];
  }
  const double side = u[0].dot(u[1].cross(u[2]));
  if (std::numbers::pi - half < flat || std::abs(side) < flat) return weight;
  std::array<double, 3> c{}, s{};
  for (std::size_t k = 0; k < 3; ++k) {
    c[k] =
        2 * std::sin(half) * std::sin(half - angle[k]) / (std::sin(angle[(k + 1) % 3]) * std::sin(angle[(k + 2) % 3])) -
        1;
    s[k] = std::copysign(std::sqrt(std::max(0.0, 1 - c[k] * c[k])), side);
    if (std::abs(s[k]) < flat) return weight;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    weight[k] = (angle[k] - c[i] * angle[j] - c[j] * angle[i]) / (length[k] * std::sin(angle[i]) * s[j]);
  }
  return weight;
}

// The map of the surface, carried to a point inside.
Vector3 carried(const polycube::SurfaceMap& map, const Vector3& p, const base::Host& host) {
  Vector3 sum = Vector3::Zero();
  double all = 0;
  for (std::size_t i = 0; i < map.triangles.size(); ++i) {
    if (i % 16384 == 0) host.report("cavities", 0, 0);
    const Triangle& t = map.triangles[i];
    const auto weights =
        mean_value_weights({map.positions[t[0]] - p, map.positions[t[1]] - p, map.positions[t[2]] - p});
    for (std::size_t k = 0; k < 3; ++k) {
      sum += weights[k] * map.polycube[t[k]];
      all += weights[k];
    }
  }
  return sum / all;
}

// The 24 turns of the cube.
Array<Eigen::Matrix3d> turns_of_cube(std::pmr::memory_resource* memory) {
  Array<Eigen::Matrix3d> turns(memory);
  std::array<int, 3> axis = {0, 1, 2};
  do {
    for (int signs = 0; signs < 8; ++signs) {
      Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
      for (int row = 0; row < 3; ++row)
        m(row, axis[static_cast<std::size_t>(row)]) = (signs >> row & 1) != 0 ? -1 : 1;
      if (m.determinant() > 0) turns.push_back(m);
    }
  } while (std::next_permutation(axis.begin(), axis.end()));
  return turns;
}

struct Sample {
  Vector3 on_cavity, wanted;
  double area;
};

Array<Sample> samples_of(const polycube::SurfaceMap& outer, const polycube::SurfaceMap& cavity,
                         const base::Host& host) {
  constexpr std::size_t most = 400;
  const std::size_t step = 1 + (cavity.triangles.size() - 1) / most;
  Array<Sample> samples(host.memory);
  for (std::size_t i = 0; i < cavity.triangles.size(); i += step) {
    const Triangle& t = cavity.triangles[i];
    const auto center = [&](const Array<Vector3>& p) { return Vector3((p[t[0]] + p[t[1]] + p[t[2]]) / 3); };
    const Vector3 a = cavity.positions[t[1]] - cavity.positions[t[0]],
                  b = cavity.positions[t[2]] - cavity.positions[t[0]];
    samples.push_back({center(cavity.polycube), carried(outer, center(cavity.positions), host), a.cross(b).norm()});
  }
  return samples;
}

}  // namespace

CavityPlacement place_cavity(const polycube::SurfaceMap& outer, const polycube::SurfaceMap& cavity,
                             const base::Host& host) {
  const Array<Sample> samples = samples_of(outer, cavity, host);
  Vector3 mean = Vector3::Zero(), wanted_mean = Vector3::Zero();
  double area = 0;
  for (const Sample& s : samples) {
    mean += s.area * s.on_cavity;
    wanted_mean += s.area * s.wanted;
    area += s.area;
  }
  mean /= area;
  wanted_mean /= area;
  // Target by present lengths: entry (a, b) for axis a of the target.
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
  Vector3 squares = Vector3::Zero();
  for (const Sample& s : samples) {
    const Vector3 d = s.on_cavity - mean;
    products += s.area * (s.wanted - wanted_mean) * d.transpose();
    squares += s.area * d.cwiseAbs2();
  }
  CavityPlacement best;
  double best_sum = -std::numeric_limits<double>::infinity();
  for (const Eigen::Matrix3d& turn : turns_of_cube(host.memory)) {
    const double sum = products.cwiseProduct(turn).sum();
    if (sum <= best_sum) continue;
    best_sum = sum;
    best.turn = turn;
  }
  // Along one axis more or less than in all by a factor of at most two.
  constexpr double most = 2;
  const double all = std::abs(best_sum) / squares.sum();
  for (int a = 0; a < 3; ++a) {
    const double product = products.row(a).dot(best.turn.row(a)), square = best.turn.row(a).cwiseAbs().dot(squares);
    best.scale[a] = std::clamp(product / square, all / most, all * most);
  }
  best.shift = wanted_mean - best.scale.cwiseProduct(best.turn * mean);
  return best;
}

}  // namespace orbicube::volume_map
