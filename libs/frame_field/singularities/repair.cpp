#include "frame_field/singularities/repair.h"

#include <algorithm>
#include <cmath>

#include "frame_field/singularities/zipping.h"
#include "frame_field/smoothing/energy.h"
#include "frame_field/smoothing/region_relaxation.h"
#include "frame_field/smoothing/smoothing.h"
#include "frame_field/smoothing/starts.h"
#include "quaternion/frame_distance.h"

namespace orbicube::frame_field {
namespace {

// Rings of tetrahedra about what is wrong, and how it is changed, attempt by attempt.
enum class Way { zip, refill };
struct Attempt {
  std::uint32_t rings;
  Way way;
};
constexpr Attempt attempts[] = {{2, Way::zip}, {3, Way::refill}, {4, Way::zip}, {2, Way::refill}, {3, Way::zip}};
constexpr std::uint32_t max_rounds = 12;
constexpr std::uint32_t fitting_sweeps = 60, smoothing_sweeps = 60, seam_sweeps = 20;
constexpr std::uint32_t rings_not_smoothed = 3;  // about faults that smoothing brings back
// Frames that differ by less are the same (recombination.h); radians.
constexpr double same_angle = 0.1;
constexpr double last_gain = 1e-5, first_gain = 1e-3;

}  // namespace

Repair::Repair(std::span<const Vector3> positions, const mesh::TetrahedralConnectivity& connectivity,
               const DualGraph& graph, std::span<const CoarseGraph> hierarchy, Constraints& constraints,
               const base::Host& host)
    : positions_(positions),
      connectivity_(connectivity),
      graph_(graph),
      hierarchy_(hierarchy),
      constraints_(constraints),
      host_(host),
      finder_(positions, connectivity, host) {}

RepairOutcome Repair::repair(Field& field) {
  const Field before(field, host_.memory);
  const std::uint32_t count = rounds(field);
  if (count > 0) smooth_all(last_gain, field);
  return outcome_of(before, field, count);
}

RepairOutcome Repair::search_about_single_axes(Field& smoother) {
  const Field before(smoother, host_.memory);
  std::uint32_t count = rounds(smoother);
  Field field = constant_start(graph_, constraints_, {1, 0, 0, 0}, host_);
  count += rounds(field);
  smooth_all(first_gain, field);
  count += rounds(field);
  take_smoother(smoother, field);
  count += rounds(field);
  smooth_all(last_gain, field);
  std::swap(field, smoother);
  return outcome_of(before, smoother, count);
}

// Returns how many rounds it took.
std::uint32_t Repair::rounds(Field& field) {
  Structure now = finder_.find(field);
  std::uint32_t round = 0;
  for (std::uint32_t idle = 0; idle < std::size(attempts) && round < max_rounds && !now.places.empty(); ++round) {
    const Attempt& attempt = attempts[round % std::size(attempts)];
    const auto inside = finder_.around(now.vertices, attempt.rings);
    Field candidate(field, host_.memory);
    if (attempt.way == Way::zip)
      zip_apart(inside, now, candidate);
    else
      refill(inside, candidate);
    ++idle;
    if (!keep_fewer(inside, now, finder_.find(candidate), candidate, field)) continue;
    now = finder_.find(field);
    idle = 0;
  }
  return round;
}

void Repair::zip_apart(std::span<const std::uint8_t> inside, const Structure& structure, Field& field) const {
  Array<std::uint8_t> target(structure.matchings, host_.memory);
  zip(positions_, connectivity_, finder_, field, inside, structure.graph, host_, target);
  const Array<Index> list = listed(inside);
  const RegionRelaxation relaxation(graph_, constraints_, connectivity_, host_);
  relaxation.relax(list, target, fitting_sweeps, field);
  relaxation.relax(list, {}, smoothing_sweeps, field);
}

void Repair::refill(std::span<const std::uint8_t> inside, Field& field) const {
  Array<std::uint8_t> left(inside.begin(), inside.end(), host_.memory);
  Array<Index> front(host_.memory);
  for (Index t = 0; t < left.size(); ++t) {
    if (inside[t] != 0) continue;
    bool next_to = false;
    for (Index k = 0; k < 4; ++k) {
      const Index other = connectivity_.neighbor(t, k);
      next_to = next_to || (other != no_index && inside[other] != 0);
    }
    if (next_to) front.push_back(t);
  }
  for (std::size_t i = 0; i < front.size(); ++i) {
    for (Index k = 0; k < 4; ++k) {
      const Index other = connectivity_.neighbor(front[i], k);
      if (other == no_index || left[other] == 0) continue;
      left[other] = 0;
      field[other] = satisfying(other, field[front[i]]);
      front.push_back(other);
    }
  }
  RegionRelaxation(graph_, constraints_, connectivity_, host_)
      .relax(listed(inside), {}, fitting_sweeps + smoothing_sweeps, field);
}

// Takes over from the candidate the parts with fewer faults; true if there are any.
bool Repair::keep_fewer(std::span<const std::uint8_t> inside, const Structure& before, const Structure& after,
                        const Field& candidate, Field& field) const {
  Parts parts(connectivity_, inside, host_);
  parts.count(before, after);
  bool any = false;
  for (Index t = 0; t < field.size(); ++t) {
    if (inside[t] == 0 || !parts.at(connectivity_.tetrahedra()[t][0]).fewer()) continue;
    field[t] = candidate[t];
    any = true;
  }
  return any;
}

// Takes over from the candidate the parts where the fields differ and it has fewer faults, or as many and less energy.
void Repair::take_smoother(const Field& candidate, Field& field) const {
  const double threshold = std::sin(0.5 * same_angle) * std::sin(0.5 * same_angle);
  Array<std::uint8_t> differs(field.size(), 0, host_.memory);
  for (Index t = 0; t < field.size(); ++t)
    differs[t] = quaternion::symmetric_sine_square(field[t], candidate[t]) > threshold ? 1 : 0;
  const Structure before = finder_.find(field);
  Parts parts(connectivity_, differs, host_);
  parts.count(before, finder_.find(candidate));
  for (Index t = 0; t < field.size(); ++t) {
    if (differs[t] == 0) continue;
    Parts::Change& change = parts.at(connectivity_.tetrahedra()[t][0]);
    for (Index k = 0; k < 4; ++k) {
      const Index other = connectivity_.neighbor(t, k);
      const bool both = other != no_index && differs[other] != 0;
      if (other == no_index || (both && other < t)) continue;
      const double w = static_cast<double>(graph_.weights[t][k]);
      change.energy += w * (quaternion::symmetric_sine_square(candidate[t], both ? candidate[other] : field[other]) -
                            quaternion::symmetric_sine_square(field[t], field[other]));
    }
  }
  Field mixed(field, host_.memory);
  Array<Index> seam(host_.memory);
  for (Index t = 0; t < field.size(); ++t) {
    if (differs[t] == 0) continue;
    const Parts::Change& change = parts.at(connectivity_.tetrahedra()[t][0]);
    if (!change.fewer() && (change.more() || !(change.energy < 0))) continue;
    mixed[t] = candidate[t];
    seam.insert(seam.end(), connectivity_.tetrahedra()[t].begin(), connectivity_.tetrahedra()[t].end());
  }
  RegionRelaxation(graph_, constraints_, connectivity_, host_)
      .relax(listed(finder_.around(seam, 1)), {}, seam_sweeps, mixed);
  // Small differences around the parts add up to a fault now and then.
  if (!(before.faults < finder_.find(mixed).faults)) std::swap(field, mixed);
}

// Smooths all frames together, and takes that back around faults that it brings.
void Repair::smooth_all(double gain, Field& field) {
  const Structure before = finder_.find(field);
  Field candidate(field, host_.memory);
  smooth(graph_, hierarchy_, constraints_, {.relative_gain = gain, .choose_normals = false}, host_, candidate);
  Structure after = finder_.find(candidate);
  for (std::uint32_t attempt = 1; before.faults < after.faults && attempt < 3; ++attempt) {
    const auto inside = finder_.around(after.vertices, attempt * rings_not_smoothed);
    for (Index t = 0; t < field.size(); ++t) {
      if (inside[t] != 0) candidate[t] = field[t];
    }
    after = finder_.find(candidate);
  }
  if (!(before.faults < after.faults)) std::swap(field, candidate);
}

Array<Index> Repair::listed(std::span<const std::uint8_t> inside) const {
  Array<Index> list(host_.memory);
  for (Index t = 0; t < inside.size(); ++t) {
    if (inside[t] != 0) list.push_back(t);
  }
  return list;
}

Quaternion Repair::satisfying(Index tetrahedron, const Quaternion& frame) const {
  const Index c = constraints_.of_node[tetrahedron];
  if (c == no_index) return frame;
  const Constraint& constraint = constraints_.list[c];
  return constraint.fixed ? constraint.frame : aligned(frame, constraint.direction);
}

double Repair::energy_of(const Field& field) const {
  return energy(graph_, field, host_);
}

RepairOutcome Repair::outcome_of(const Field& before, const Field& after, std::uint32_t count) const {
  return {finder_.find(before).faults, finder_.find(after).faults, energy_of(before), energy_of(after), count};
}

}  // namespace orbicube::frame_field
