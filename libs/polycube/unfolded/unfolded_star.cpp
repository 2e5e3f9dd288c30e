#include "polycube/unfolded/unfolded_star.h"

#include <Eigen/Geometry>

#include "base/backtracking.h"
#include "mesh/search/predicates.h"

namespace orbicube::polycube {

TriangleWeights::TriangleWeights(const UnfoldedMap& map) {
  const EditableSurface& surface = map.surface;
  double in_space = 0, on_polycube = 0, count = 0;
  for (Index f = 0; f < surface.faces(); ++f) {
    if (!surface.alive(f)) continue;
    const auto& [a, b, c] = surface.triangle[f];
    const Vector3& p = surface.position[a];
    in_space += 0.5 * (surface.position[b] - p).cross(surface.position[c] - p).norm();
    const Vector2d u = map.at(3 * f + 1) - map.at(3 * f), v = map.at(3 * f + 2) - map.at(3 * f);
    on_polycube += 0.5 * (u.x() * v.y() - u.y() * v.x());
    ++count;
  }
  scale = std::sqrt(on_polycube / in_space);
  area = on_polycube;
  each = 0.5 / count;
}

void UnfoldedStar::gather(const UnfoldedMap& map, const TriangleWeights& weights, Index vertex) {
  triangles.clear();
  held = map.held[vertex];
  tie = map.tie_at[vertex] == no_index ? nullptr : &map.ties[map.tie_at[vertex]];
  map.surface.for_each_outgoing(vertex, [&](Index h) {
    const Index n = EditableSurface::next(h), p = EditableSurface::previous(h);
    const PlaneMotion back = map.motion[h].inverse();
    Corner t{weights.rest(map.surface, vertex, map.surface.start(n), map.surface.start(p)), back(map.at(n)),
             back(map.at(p)), 0};
    t.weight = weights.weight(t.rest);
    triangles.push_back(t);
  });
}

double UnfoldedStar::energy(const Vector2d& place) const {
  double sum = tie == nullptr ? 0 : tie->energy(place);
  for (const Corner& t : triangles)
    sum += t.weight * untangle::barrier(jacobian(t.rest, place, t.a, t.b));
  return sum;
}

bool UnfoldedStar::positive(const Vector2d& place) const {
  return std::all_of(triangles.begin(), triangles.end(),
                     [&](const Corner& t) { return mesh::orientation_2d(place, t.a, t.b) > 0; });
}

Vector2d UnfoldedStar::improved(const Vector2d& place, double& before, double& gain) const {
  double value = 0;
  before = gain = 0;
  Vector2d gradient = Vector2d::Zero();
  Eigen::Matrix2d hessian = Eigen::Matrix2d::Zero();
  for (const Corner& t : triangles) {
    const Eigen::Matrix2d j = jacobian(t.rest, place, t.a, t.b);
    const double one = untangle::barrier(j);
    if (!std::isfinite(one)) return place;
    value += t.weight * one;
    const untangle::BarrierDerivatives of(j);
    const Vector2d& hat = t.rest.hat[0];
    for (Eigen::Index r = 0; r < 2; ++r) {
      gradient[r] += t.weight * hat.dot(of.gradient.segment<2>(2 * r));
      for (Eigen::Index s = 0; s < 2; ++s)
        hessian(r, s) += t.weight * hat.dot(of.block.block<2, 2>(2 * r, 2 * s) * hat);
    }
  }
  if (tie != nullptr) {
    value += tie->energy(place);
    for (Eigen::Index k = 0; k < 2; ++k) {
      const double weight = tie->weight[static_cast<std::size_t>(k)];
      gradient[k] += 2 * weight * (place[k] - tie->place[k]);
      hessian(k, k) += 2 * weight;
    }
  }
  for (Eigen::Index k = 0; k < 2; ++k) {
    if ((held >> k & 1) == 0) continue;
    gradient[k] = 0;
    hessian(0, 1) = hessian(1, 0) = 0;
    hessian(k, k) = 1;
  }
  before = value;
  const double determinant = hessian.determinant();
  if (!(determinant > 0)) return place;
  const Vector2d step = -Vector2d(hessian(1, 1) * gradient.x() - hessian(0, 1) * gradient.y(),
                                  hessian(0, 0) * gradient.y() - hessian(1, 0) * gradient.x()) /
                        determinant;
  const double slope = gradient.dot(step);
  if (!(slope < 0)) return place;
  Vector2d there;
  const auto energy_after = [&](double length) {
    there = place + length * step;
    return energy(there);
  };
  const auto taken = base::backtrack(value, slope, {.max_trials = 12}, energy_after, [&] { return positive(there); });
  if (!taken) return place;
  gain = value - taken->value;
  return there;
}

}  // namespace orbicube::polycube
