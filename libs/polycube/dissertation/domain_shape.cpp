#include "polycube/dissertation/domain_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "projected_gradient/solver.h"

namespace orbicube::polycube::dissertation {
namespace {

// lambda of section 4.3.1, which the dissertation does not print, in units of E over the area: the area differs by
// about 1 % from what it should be, and the result is scaled to it.
constexpr double area_penalty = 100;
// The minimum of beta, which eq. 4.9 leaves open, in parts of the mean length; less where it was less at the start.
constexpr double min_length_part = 0.01;
constexpr double gradient_tolerance = 1e-7;
constexpr std::uint64_t max_evaluations = 5000;

}  // namespace

DomainEnergy::DomainEnergy(const Layout& layout, std::span<const PatchEnergy> energy, double area_weight,
                           const base::Host& host)
    : start_(host.memory), terms_(host.memory) {
  for (std::size_t a = 0; a < 3; ++a)
    first_[a + 1] = first_[a] + layout.planes[a].size() - 3;  // without the empty layers
  lengths_ = first_[3];
  double area = 0;
  for (std::size_t r = 0; r < layout.rectangles.size(); ++r) {
    const LayoutRectangle& rectangle = layout.rectangles[r];
    Term term{};
    std::array<double, 2> size{};
    for (std::size_t side = 0; side < 2; ++side) {
      const std::size_t axis = (static_cast<std::size_t>(axis_of(rectangle.label)) + 1 + side) % 3;
      const auto low = static_cast<std::size_t>(rectangle.low[axis]),
                 high = static_cast<std::size_t>(rectangle.high[axis]);
      term.begin[side] = first_[axis] + low - 1;
      term.end[side] = first_[axis] + high - 1;
      size[side] = layout.planes[axis][high] - layout.planes[axis][low];
      term.harmonic[side] = energy[r].harmonic[axis] / (size[side] * size[side]);
    }
    term.stretch = area_weight * energy[r].stretch / std::pow(size[0] * size[1], 2);
    area += size[0] * size[1];
    terms_.push_back(term);
  }
  unit_ = std::sqrt(area);
  for (Term& term : terms_)
    term.stretch *= area;
  start_.resize(unknowns());
  for (std::size_t a = 0; a < 3; ++a) {
    const auto& planes = layout.planes[a];
    for (std::size_t j = 0; j < first_[a + 1] - first_[a]; ++j) {
      start_[first_[a] + j] = (planes[j + 2] - planes[1]) / unit_;
      start_[lengths_ + first_[a] + j] = (planes[j + 2] - planes[j + 1]) / unit_;
    }
  }
}

double DomainEnergy::length(const Term& term, std::size_t side, std::span<const double> x) const {
  double sum = 0;
  for (std::size_t i = term.begin[side]; i < term.end[side]; ++i)
    sum += x[lengths_ + i];
  return sum;
}

double DomainEnergy::area(std::span<const double> x) const {
  double sum = 0;
  for (const Term& term : terms_)
    sum += length(term, 0, x) * length(term, 1, x);
  return sum;
}

double DomainEnergy::evaluate(std::span<const double> x, double penalty, std::span<double> gradient) const {
  std::fill(gradient.begin(), gradient.end(), 0.0);
  const double excess = area(x) - 1;
  double value = penalty * excess * excess;
  for (const Term& term : terms_) {
    const std::array<double, 2> size = {length(term, 0, x), length(term, 1, x)};
    const double product = size[0] * size[1];
    value += term.stretch * product * product;
    for (std::size_t side = 0; side < 2; ++side) {
      value += term.harmonic[side] * size[side] * size[side];
      const double slope =
          2 * term.harmonic[side] * size[side] + (2 * term.stretch * product + 2 * penalty * excess) * size[1 - side];
      for (std::size_t i = term.begin[side]; i < term.end[side]; ++i)
        gradient[lengths_ + i] += slope;
    }
  }
  return value;
}

namespace {

// alpha_j - alpha_(j-1) - beta_j = 0 for each length (eq. 4.9).
struct Rows {
  Rows(const DomainEnergy& energy, std::pmr::memory_resource* memory)
      : begin(memory), column(memory), value(memory), right(energy.lengths(), 0, memory) {
    begin.push_back(0);
    for (std::size_t a = 0; a < 3; ++a) {
      const std::size_t end = a < 2 ? energy.first(a + 1) : energy.lengths();
      for (std::size_t i = energy.first(a); i < end; ++i) {
        add(i, 1);
        if (i > energy.first(a)) add(i - 1, -1);
        add(energy.lengths() + i, -1);
        begin.push_back(column.size());
      }
    }
  }
  void add(std::size_t unknown, double factor) {
    column.push_back(static_cast<std::uint32_t>(unknown));
    value.push_back(factor);
  }
  Array<std::size_t> begin;
  Array<std::uint32_t> column;
  Array<double> value, right;
};

void take_planes(const Layout& layout, const DomainEnergy& energy, std::span<const double> x, double scale,
                 DomainShape& shape) {
  for (std::size_t a = 0; a < 3; ++a) {
    const auto& from = layout.planes[a];
    Array<double>& planes = shape.planes[a];
    planes.push_back(from[0]);
    planes.push_back(from[1]);
    for (std::size_t j = 0; j + 3 < from.size(); ++j)
      planes.push_back(planes.back() + scale * energy.unit() * x[energy.lengths() + energy.first(a) + j]);
    planes.push_back(planes.back() + (from[from.size() - 1] - from[from.size() - 2]));
  }
}

}  // namespace

DomainShape optimize_domain_shape(const Layout& layout, std::span<const PatchEnergy> energies, double area_weight,
                                  const base::Host& host) {
  const DomainEnergy energy(layout, energies, area_weight, host);
  const std::size_t n = energy.unknowns(), half = energy.lengths();
  const std::span<const double> start = energy.start();
  Array<double> lower(n, -std::numeric_limits<double>::infinity(), host.memory);
  Array<double> upper(n, std::numeric_limits<double>::infinity(), host.memory);
  double mean = 0;
  for (std::size_t i = 0; i < half; ++i)
    mean += start[half + i] / static_cast<double>(half);
  for (std::size_t i = 0; i < half; ++i)
    lower[half + i] = std::min(min_length_part * mean, start[half + i] / 2);
  const Rows rows(energy, host.memory);
  projected_gradient::Problem problem;
  problem.n = n;
  problem.lower = lower;
  problem.upper = upper;
  problem.row_start = rows.begin;
  problem.column = rows.column;
  problem.value = rows.value;
  problem.rhs = rows.right;
  projected_gradient::Options options;
  options.method = projected_gradient::Method::dissertation;
  options.gradient_tolerance = gradient_tolerance;
  options.max_evaluations = max_evaluations;
  projected_gradient::Solver solver(problem, options, start, host);
  Array<double> gradient(n, 0, host.memory);
  for (;;) {
    const projected_gradient::Request request = solver.step();
    if (request == projected_gradient::Request::done) break;
    if (request != projected_gradient::Request::need_value_and_gradient) continue;
    const double value = energy.evaluate(solver.point(), area_penalty, gradient);
    solver.tell(value, gradient);
  }
  const projected_gradient::Result result = solver.result();
  if (result.stop == projected_gradient::Stop::cancelled) throw base::Error("cancelled", "proportions");
  DomainShape shape(host.memory);
  shape.evaluations = result.evaluations;
  shape.converged = result.stop == projected_gradient::Stop::converged;
  Array<double> best(solver.best_point().begin(), solver.best_point().end(), host.memory);
  const double scale = 1 / std::sqrt(energy.area(best));
  take_planes(layout, energy, best, scale, shape);
  for (double& x : best)
    x *= scale;
  shape.energy_before = energy.evaluate(start, 0, gradient);
  shape.energy = energy.evaluate(best, 0, gradient);
  return shape;
}

}  // namespace orbicube::polycube::dissertation
