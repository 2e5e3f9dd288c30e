#include "polycube/map/starts.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "linear/sparse_system.h"
#include "mesh/search/rotations.h"

namespace orbicube::polycube {
namespace {

constexpr const char* starts_phase = "start";

// Half the cotangent opposite to a half-edge, bounded so that the Laplacian is positive and slivers do not rule it.
double bounded_weight(const Surface& surface, Index h, double least, double most) {
  const Index a = surface.start(h), b = surface.end(h), c = surface.end(mesh::Connectivity::next(h));
  return std::clamp(0.5 * cotangent(surface.positions[c], surface.positions[a], surface.positions[b]), least, most);
}

// The rotation about an axis of the polycube that fits the map best, after the turn of the triangle's normal.
Eigen::Matrix3d fitted_turn(const TiedMap& map, Index triangle, const Eigen::Matrix3d& turn,
                            std::span<const double> weights) {
  const Surface& surface = *map.surface;
  const int u = (axis_of(map.label(triangle)) + 1) % 3, v = (axis_of(map.label(triangle)) + 2) % 3;
  double cosine = 0, sine = 0;
  for (Index h = 3 * triangle; h < 3 * triangle + 3; ++h) {
    const Index a = surface.start(h), b = surface.end(h);
    const Vector3 e = turn * (surface.positions[b] - surface.positions[a]);
    const double x = map.coordinate(b, u) - map.coordinate(a, u);
    const double y = map.coordinate(b, v) - map.coordinate(a, v);
    cosine += weights[h] * (x * e[u] + y * e[v]);
    sine += weights[h] * (y * e[u] - x * e[v]);
  }
  const double size = std::hypot(cosine, sine);
  if (!(size > 1e-14)) return turn;
  Eigen::Matrix3d within = Eigen::Matrix3d::Identity();
  within(u, u) = within(v, v) = cosine / size;
  within(u, v) = -sine / size;
  within(v, u) = sine / size;
  return within * turn;
}

}  // namespace

void poisson_start(TiedMap& map, int rounds, const base::Host& host) {
  const Surface& surface = *map.surface;
  const auto half_edges = static_cast<Index>(3 * surface.triangles.size());
  Array<double> weights(half_edges, host.memory);
  linear::SparseSystem::Triplets triplets(host.memory);
  triplets.reserve(9 * std::size_t{half_edges});
  for (Index h = 0; h < half_edges; ++h) {
    if (h % 8192 == 0) host.report(starts_phase, 0, 0);
    weights[h] = bounded_weight(surface, h, 1e-3, 50);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto p = static_cast<int>(map.variable[surface.start(h)][axis]);
      const auto q = static_cast<int>(map.variable[surface.end(h)][axis]);
      if (p == q) continue;
      triplets.emplace_back(p, p, weights[h]);
      triplets.emplace_back(q, q, weights[h]);
      triplets.emplace_back(std::max(p, q), std::min(p, q), -weights[h]);
    }
  }
  constexpr double anchor = 1e-8;  // makes the translation definite
  for (int i = 0; i < static_cast<int>(map.value.size()); ++i)
    triplets.emplace_back(i, i, anchor);
  linear::SparseSystem system(map.value.size(), triplets);
  host.report(starts_phase, 0, 0);
  if (!system.factorize()) throw base::Error("no-valid-result", "the start of the map could not be computed");

  Array<Eigen::Matrix3d> turns(surface.triangles.size(), host.memory);
  for (Index i = 0; i < surface.triangles.size(); ++i) {
    turns[i] = mesh::rotation_between(surface.normals[i], direction_of(map.label(i))).toRotationMatrix();
  }
  Eigen::VectorXd right(static_cast<Eigen::Index>(map.value.size()));
  for (int round = 0; round < rounds; ++round) {
    host.report(starts_phase, 0, 0);
    for (std::size_t i = 0; i < map.value.size(); ++i)
      right[static_cast<Eigen::Index>(i)] = anchor * map.value[i];
    for (Index i = 0; i < surface.triangles.size(); ++i) {
      const Eigen::Matrix3d turn = round == 0 ? turns[i] : fitted_turn(map, i, turns[i], weights);
      for (Index h = 3 * i; h < 3 * i + 3; ++h) {
        const Index a = surface.start(h), b = surface.end(h);
        const Vector3 flow = weights[h] * (turn * (surface.positions[b] - surface.positions[a]));
        for (std::size_t axis = 0; axis < 3; ++axis) {
          right[map.variable[b][axis]] += flow[static_cast<Eigen::Index>(axis)];
          right[map.variable[a][axis]] -= flow[static_cast<Eigen::Index>(axis)];
        }
      }
    }
    const Eigen::VectorXd x = system.solve(right);
    std::copy(x.begin(), x.end(), map.value.begin());
  }
}

Array<double> target_signs(const TiedMap& map, const ArcNetwork& network, const base::Host& host) {
  Array<double> result(network.arcs.size(), host.memory);
  const double unit = std::sqrt(map.surface->area);
  for (std::size_t i = 0; i < result.size(); ++i) {
    const Arc& arc = network.arcs[i];
    const double way = map.coordinate(arc.last, arc.axis) - map.coordinate(arc.first, arc.axis);
    result[i] = way * arc.direction_if_convex / unit;
  }
  return result;
}

std::size_t place_patches(TiedMap& map, const ArcNetwork& network, const ArcSigns& signs, const base::Host& host) {
  const auto count = static_cast<Eigen::Index>(map.patches->count());
  const double unit = std::sqrt(map.surface->area);
  struct Difference {
    Index from, to;  // patches; the arc runs from the lower to the higher
    double wanted, least, pressure;
    bool active;
  };
  Array<Difference> differences(host.memory);
  for (std::size_t i = 0; i < network.arcs.size(); ++i) {
    const Arc& arc = network.arcs[i];
    const auto axis = static_cast<std::size_t>(arc.axis);
    Difference d{map.variable[arc.first][axis], map.variable[arc.last][axis], 0, 0, 0, false};
    if (arc.direction_if_convex * (signs.convex[i] ? 1 : -1) < 0) std::swap(d.from, d.to);
    const double now = map.value[d.to] - map.value[d.from];
    d.wanted = now > 0 ? now : 0.3 * arc.length;
    d.least = std::max(0.01 * unit, std::min(0.3 * arc.length, 0.5 * std::max(d.wanted, 0.02 * unit)));
    differences.push_back(d);
  }

  // Augmented Lagrangian of the lower bounds.
  constexpr double stay = 1e-6;
  constexpr double stiffness = 10;
  constexpr int max_rounds = 200;
  Eigen::VectorXd x(count), right(count);
  Eigen::MatrixXd matrix(count, count);
  std::size_t wrong = 0;
  for (int round = 0; round < max_rounds; ++round) {
    host.report(starts_phase, 0, 0);
    matrix = stay * Eigen::MatrixXd::Identity(count, count);
    for (Eigen::Index c = 0; c < count; ++c)
      right[c] = stay * map.value[static_cast<std::size_t>(c)];
    for (const Difference& d : differences) {
      const double weight = 1 + (d.active ? stiffness : 0);
      const double target = d.wanted + (d.active ? stiffness * d.least + d.pressure : 0);
      matrix(d.from, d.from) += weight;
      matrix(d.to, d.to) += weight;
      matrix(d.from, d.to) -= weight;
      matrix(d.to, d.from) -= weight;
      right[d.to] += target;
      right[d.from] -= target;
    }
    x = matrix.ldlt().solve(right);
    wrong = 0;
    bool far_off = false;
    for (Difference& d : differences) {
      const double now = x[d.to] - x[d.from];
      wrong += now <= 0;
      far_off = far_off || now < 0.5 * d.least;
      d.pressure = std::max(0.0, d.pressure + stiffness * (d.least - now));
      d.active = d.pressure > 0 || now < d.least;
    }
    if (!far_off && round > 2) break;
  }
  std::copy(x.begin(), x.end(), map.value.begin());
  return wrong;
}

void spread_vertices(TiedMap& map, const ArcNetwork& network, const base::Host& host) {
  const Surface& surface = *map.surface;
  Array<std::uint8_t> fixed(map.value.size(), host.memory);
  std::fill_n(fixed.begin(), map.patches->count(), std::uint8_t{1});
  for (const Arc& arc : network.arcs) {
    const double from = map.coordinate(arc.first, arc.axis), to = map.coordinate(arc.last, arc.axis);
    double passed = 0;
    for (const Index h : network.half_edges_of(arc)) {
      passed += surface.length(h);
      if (surface.end(h) == arc.last) break;
      const Index variable = map.variable[surface.end(h)][static_cast<std::size_t>(arc.axis)];
      map.value[variable] = from + (to - from) * (passed / arc.length);
      fixed[variable] = 1;
    }
  }
  Array<Index> place(map.value.size(), no_index, host.memory);
  Index count = 0;
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    if (!fixed[i]) place[i] = count++;
  }
  if (count == 0) return;
  linear::SparseSystem::Triplets triplets(host.memory);
  triplets.reserve(12 * surface.triangles.size() + count);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(count);
  for (Index h = 0; h < 3 * surface.triangles.size(); ++h) {
    if (h % 8192 == 0) host.report(starts_phase, 0, 0);
    const double weight = 0.05 + bounded_weight(surface, h, 0, 5);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (static_cast<int>(axis) == axis_of(map.label(h / 3))) continue;
      const Index p = map.variable[surface.start(h)][axis], q = map.variable[surface.end(h)][axis];
      if (p == q) continue;
      const auto i = static_cast<int>(place[p]), j = static_cast<int>(place[q]);
      if (!fixed[p]) triplets.emplace_back(i, i, weight);
      if (!fixed[q]) triplets.emplace_back(j, j, weight);
      if (!fixed[p] && !fixed[q]) triplets.emplace_back(std::max(i, j), std::min(i, j), -weight);
      if (!fixed[p] && fixed[q]) right[i] += weight * map.value[q];
      if (fixed[p] && !fixed[q]) right[j] += weight * map.value[p];
    }
  }
  linear::SparseSystem system(count, triplets);
  host.report(starts_phase, 0, 0);
  if (!system.factorize()) throw base::Error("no-valid-result", "the start of the map could not be computed");
  const Eigen::VectorXd x = system.solve(right);
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    if (!fixed[i]) map.value[i] = x[place[i]];
  }
}

}  // namespace orbicube::polycube
