#include "frame_field/smoothing/region_relaxation.h"

#include <cmath>

#include "quaternion/frame_distance.h"

namespace orbicube::frame_field {
namespace {

using quaternion::conjugate;
using quaternion::cube_group;
using quaternion::multiply;

constexpr double over_relaxation = 1.6;
constexpr std::size_t tetrahedra_between_reports = 1024;

}  // namespace

Quaternion RegionRelaxation::relaxed(Index t, std::span<const std::uint8_t> matchings, const Field& field) const {
  const Quaternion q = field[t];
  const Index number = constraints_.of_node[t];
  if (number != no_index && constraints_.list[number].fixed) return q;
  Quaternion sum{0, 0, 0, 0};
  double weights = 0;
  for (Index k = 0; k < 4; ++k) {
    const Index other = connectivity_.neighbor(t, k);
    if (other == no_index) continue;
    const std::uint32_t g = matchings.empty() ? quaternion::symmetric_matching(q, field[other]) : matchings[4 * t + k];
    const Quaternion p = multiply(field[other], conjugate(cube_group.element[g]));
    const double w = static_cast<double>(graph_.weights[t][k]), along = dot(p, q) < 0 ? -w : w;
    sum = {sum.w + along * p.w, sum.x + along * p.x, sum.y + along * p.y, sum.z + along * p.z};
    weights += w;
  }
  if (!constraints_.pulls.empty()) {
    for (const Pull& pull : constraints_.pulls_at(t)) {
      const Quaternion p = target(pull, q);
      const double along = dot(p, q) < 0 ? -pull.weight : pull.weight;
      sum = {sum.w + along * p.w, sum.x + along * p.x, sum.y + along * p.y, sum.z + along * p.z};
      weights += pull.weight;
    }
  }
  if (!(weights > 0)) return q;
  if (number != no_index) {
    // Half the angle about the direction that brings q nearest to the sum.
    const Vector& n = constraints_.list[number].direction;
    const Quaternion across = multiply({0, n.x, n.y, n.z}, q);
    return aligned(turned(q, n, 2 * over_relaxation * std::atan2(dot(sum, across), dot(sum, q))), n);
  }
  const double step = over_relaxation / weights, keep = 1 - over_relaxation;
  return quaternion::normalized(
      {keep * q.w + step * sum.w, keep * q.x + step * sum.x, keep * q.y + step * sum.y, keep * q.z + step * sum.z});
}

void RegionRelaxation::relax(std::span<const Index> tetrahedra, std::span<const std::uint8_t> matchings,
                             std::uint32_t sweeps, Field& field) const {
  for (std::uint32_t sweep = 0; sweep < sweeps; ++sweep) {
    for (std::size_t i = 0; i < tetrahedra.size(); ++i) {
      if (i % tetrahedra_between_reports == 0) host_.report("relaxing regions", sweep, sweeps);
      field[tetrahedra[i]] = relaxed(tetrahedra[i], matchings, field);
    }
  }
}

}  // namespace orbicube::frame_field
