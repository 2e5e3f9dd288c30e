#include "polycube/corners/corner_search.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"
#include "projected_gradient/solver.h"
#include "trust_region/solver.h"

namespace orbicube::polycube {
namespace {

constexpr double min_move_gain = 1e-9;
const double bound = CornerMove::reach / std::sqrt(2.0);
constexpr std::uint64_t max_values = 16, max_gradients = 7;

class Search {
 public:
  Search(CornerMove& move, const base::Host& host) : move_(move), host_(host) { best_.energy = move.energy_now(); }

  CornerSearch run(CornerMethod method, double step) {
    if (!std::isfinite(best_.energy)) return best_;
    if (method == CornerMethod::trust_region)
      by_values(step);
    else
      by_gradients(step);
    if (best_.improved && last_ != best_.at) evaluate(best_.at, nullptr);
    return best_;
  }

 private:
  double evaluate(const Vector2d& at, Vector2d* gradient) {
    ++best_.evaluations;
    last_ = at;
    const double energy = move_.evaluate(at, gradient);
    if (energy < best_.energy * (1 - min_move_gain)) {
      best_.energy = energy;
      best_.at = at;
      best_.improved = true;
    }
    return energy;
  }

  void by_values(double step) {
    const std::array<double, 2> lower = {-bound, -bound}, upper = {bound, bound}, start = {0, 0};
    trust_region::Problem problem;
    problem.n = 2;
    problem.lower = lower;
    problem.upper = upper;
    trust_region::Options options;
    options.radius_begin = step;
    options.radius_end = 0.1 * step;
    options.max_evaluations = max_values;
    options.follow_edges = 0;
    trust_region::Solver solver(problem, options, start, host_);
    for (;;) {
      const trust_region::Request request = solver.step();
      if (request == trust_region::Request::done) break;
      if (request != trust_region::Request::need_values) continue;
      const std::span<const double> points = solver.pending();
      const double energy = evaluate({points[0], points[1]}, nullptr);
      if (std::isfinite(energy))
        solver.tell({&energy, 1});
      else
        solver.tell_failure();
    }
    if (solver.cancelled_by_host()) throw base::Error("cancelled", "corners");
  }

  // The first step has the given length.
  void by_gradients(double step) {
    Vector2d gradient;
    const double start = evaluate(Vector2d::Zero(), &gradient);
    if (!std::isfinite(start) || !(gradient.norm() > 0)) return;
    const double unit = gradient.norm() / step;
    const std::array<double, 2> lower = {-bound, -bound}, upper = {bound, bound}, zero = {0, 0};
    projected_gradient::Problem problem;
    problem.n = 2;
    problem.lower = lower;
    problem.upper = upper;
    projected_gradient::Options options;
    options.gradient_tolerance = 0.1 * step;
    options.max_evaluations = max_gradients;
    projected_gradient::Solver solver(problem, options, zero, host_);
    bool first = true;
    for (;;) {
      const projected_gradient::Request request = solver.step();
      if (request == projected_gradient::Request::done) break;
      if (request != projected_gradient::Request::need_value_and_gradient) continue;
      const Vector2d at(solver.point()[0], solver.point()[1]);
      const double energy = first ? start : evaluate(at, &gradient);
      first = false;
      const std::array<double, 2> scaled = {gradient.x() / unit, gradient.y() / unit};
      if (std::isfinite(energy))
        solver.tell(energy / unit, scaled);
      else
        solver.tell_failure();
    }
    if (solver.result().stop == projected_gradient::Stop::cancelled) throw base::Error("cancelled", "corners");
  }

  CornerMove& move_;
  const base::Host& host_;
  CornerSearch best_;
  Vector2d last_ = Vector2d::Constant(2);
};

}  // namespace

CornerSearch search_corner(CornerMove& move, CornerMethod method, double step, const base::Host& host) {
  return Search(move, host).run(method, step);
}

}  // namespace orbicube::polycube
