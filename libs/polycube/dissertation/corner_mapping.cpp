#include "polycube/dissertation/corner_mapping.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/error.h"
#include "base/infinity.h"
#include "polycube/dissertation/corner_disks.h"
#include "trust_region/solver.h"

namespace orbicube::polycube::dissertation {
namespace {

// Of the unit disk, whose 20 rings are about 0.05 wide each: three rings at first, half a ring at the end, below which
// corner points stay at their vertices.
constexpr double radius_begin = 0.15, radius_end = 0.025;
constexpr double max_place = 0.7;  // of either coordinate: a square in the disk
constexpr std::uint64_t more_evaluations = 30;
constexpr std::size_t squares_per_patch = 3;

class CornerOptimization {
 public:
  CornerOptimization(const Layout& layout, std::span<const Index> corner_points, PrintedMapper& mapper,
                     const CornerMappingOptions& options, const base::Host& host)
      : layout_(layout),
        mapper_(mapper),
        options_(options),
        host_(host),
        best_(host.memory),
        now_(host.memory),
        squares_(squares_per_patch * layout.rectangles.size(), 0, host.memory) {
    best_.corner_points.assign(corner_points.begin(), corner_points.end());
    now_ = best_.corner_points;
    disks_.reserve(corner_points.size());
    for (const Index v : corner_points)
      disks_.push_back(make_disk(mapper.surface(), v, disk_rings, host));
  }

  CornerMapping run() {
    best_.energy_before = best_.energy = evaluate();
    max_flipped_ = flipped_;
    const std::size_t n = 2 * disks_.size();
    Array<double> lower(n, -max_place, host_.memory), upper(n, max_place, host_.memory), scale(n, 1, host_.memory);
    Array<double> start(n, 0, host_.memory), sign(squares_.size(), 1, host_.memory);
    for (std::size_t i = 0; i < n; ++i) {
      start[i] = disks_[i / 2].places[0][static_cast<Eigen::Index>(i % 2)];
      lower[i] = std::min(lower[i], start[i]);
      upper[i] = std::max(upper[i], start[i]);
    }
    for (std::size_t i = 1; i < sign.size(); i += squares_per_patch)
      sign[i] = -1;
    trust_region::Problem problem;
    problem.n = n;
    problem.residuals = squares_.size();
    problem.lower = lower;
    problem.upper = upper;
    problem.scale = scale;
    problem.sign = sign;
    trust_region::Options options;
    options.method = trust_region::Method::dissertation;
    options.start = trust_region::Start::cross;
    options.points = 2 * n + 1;
    options.radius_begin = radius_begin;
    options.radius_end = radius_end;
    options.max_evaluations =
        options_.max_evaluations > 0 ? options_.max_evaluations : 2 * n + 1 + n + more_evaluations;
    solve(problem, options, start);
    return std::move(best_);
  }

 private:
  void solve(const trust_region::Problem& problem, const trust_region::Options& options,
             std::span<const double> start) {
    trust_region::Solver solver(problem, options, start, host_);
    for (;;) {
      const trust_region::Request request = solver.step();
      if (request == trust_region::Request::done) break;
      if (request != trust_region::Request::need_values) continue;
      const std::span<const double> point = solver.pending();
      for (std::size_t i = 0; i < disks_.size(); ++i)
        now_[i] = disks_[i].nearest({point[2 * i], point[2 * i + 1]});
      const double energy = evaluate();
      if (std::isfinite(energy))
        solver.tell(squares_);
      else
        solver.tell_failure();
      if (!(energy < best_.energy)) continue;
      best_.energy = energy;
      best_.corner_points = now_;
    }
    if (solver.cancelled_by_host()) throw base::Error("cancelled", "corners");
    const trust_region::Result result = solver.result();
    best_.evaluations = result.evaluations;
    best_.failed = result.failed_evaluations;
    best_.converged =
        result.stop == trust_region::Stop::converged || result.stop == trust_region::Stop::resolution_limit;
  }

  // E with the corner points now_, infinite where they have no map; fills squares_.
  double evaluate() {
    const Drawn drawn = mapper_.draw(layout_, now_);
    if (!drawn.valid()) return base::infinity;
    const PatchMap map = mapper_.map(layout_, drawn);
    flipped_ = map.flipped;
    if (map.flipped > max_flipped_) return base::infinity;
    for (std::size_t r = 0; r < map.energy.size(); ++r) {
      const PatchEnergy& e = map.energy[r];
      squares_[squares_per_patch * r] = std::sqrt(e.positive);
      squares_[squares_per_patch * r + 1] = std::sqrt(e.negative);
      squares_[squares_per_patch * r + 2] = std::sqrt(options_.area_weight * e.stretch);
    }
    return map.total(options_.area_weight);
  }

  const Layout& layout_;
  PrintedMapper& mapper_;
  const CornerMappingOptions& options_;
  const base::Host& host_;
  std::vector<CornerDisk> disks_;
  CornerMapping best_;
  Array<Index> now_;  // corner points that are evaluated
  std::size_t flipped_ = 0, max_flipped_ = no_index;
  Array<double> squares_;  // f of eq. 4.15, of each rectangle
};

}  // namespace

CornerMapping optimize_corner_mapping(const Layout& layout, std::span<const Index> corner_points, PrintedMapper& mapper,
                                      const CornerMappingOptions& options, const base::Host& host) {
  return CornerOptimization(layout, corner_points, mapper, options, host).run();
}

}  // namespace orbicube::polycube::dissertation
