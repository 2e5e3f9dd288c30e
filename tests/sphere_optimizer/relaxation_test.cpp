// Block by block: single steps, the queue, and whole relaxations against known optima.
#include "sphere_optimizer/relaxation.h"

#include "base/error.h"
#include "block_energies.h"

using namespace orbicube;
using namespace orbicube::test;
using namespace orbicube::sphere_optimizer;

namespace {

template <class Energy>
RelaxationResult relaxed(const Energy& energy, std::vector<double>& points, const RelaxationOptions& options = {}) {
  return relax(energy, points, options, base::Host());
}

// An energy that has a value only where z is above a limit, and says so by a value or by valid() and longest_angle().
class HighEnergy {
 public:
  HighEnergy(const std::vector<double>& points, double limit) : points_(points), limit_(limit) {}
  FixedDimension<3> dimension() const { return {}; }
  double value(std::size_t, const double* x) const { return x[2] > limit_ ? x[2] : std::nan(""); }
  double value_and_gradient(std::size_t block, double* gradient) const {
    gradient[0] = gradient[1] = 0;
    gradient[2] = 1;
    return value(block, &points_[3 * block]);
  }
  template <class Visit>
  void for_each_neighbor(std::size_t, const Visit&) const {}

 protected:
  const std::vector<double>& points_;
  double limit_;
};

class LimitedEnergy : public HighEnergy {
 public:
  using HighEnergy::HighEnergy;
  double value(std::size_t, const double* x) const {
    CHECK(x[2] > limit_);  // never asked elsewhere
    return x[2];
  }
  bool valid(std::size_t, const double* x) const { return x[2] > limit_; }
  double longest_angle(std::size_t, const double*) const { return 0.05; }
};

}  // namespace

TEST_CASE("Charges relaxed one by one reach the known energies, by gradients and by Newton's steps") {
  for (const auto& [count, energy] :
       {std::pair{std::size_t{4}, 3.674234614}, {12, 49.165253058}, {24, 223.347074052}}) {
    for (const bool newton : {false, true}) {
      std::vector<double> points = unit_blocks(count, 3, 3);
      const RelaxationResult result =
          newton ? relaxed(ChargeEnergyWithHessian(points), points) : relaxed(ChargeEnergy(points), points);
      const Problem whole = thomson(count, 0);
      std::vector<double> gradient(points.size());
      CHECK(result.stop == Stop::converged);
      CHECK(std::abs(whole.function(points, gradient) - energy) < 1e-9 * energy);
      CHECK(stationarity(whole, points) <= 1.01e-6);
      CHECK(length_error(whole.shape, points) <= 2);
    }
  }
}

TEST_CASE("Vectors on a ring agree in the end, in dimensions that the compiler knows and in others") {
  const auto agree = [](auto d) {
    std::vector<double> points = blocks_near_one(12, d, 5);
    const RingEnergy<decltype(d)> energy(d, points);
    const double before = energy.total();
    const RelaxationResult result = relaxed(energy, points);
    CHECK(result.stop == Stop::converged);
    CHECK(energy.total() < 1e-9);
    // Each step's gain is what the whole energy falls by.
    CHECK(result.gain == doctest::Approx(before - energy.total()).epsilon(1e-12));
    CHECK(length_error({12, d}, points) <= 2);
  };
  agree(FixedDimension<4>{});
  agree(std::size_t{4});
  agree(std::size_t{7});
  agree(std::size_t{64});
  // Known to the compiler or not, the steps are the same.
  std::vector<double> fixed = unit_blocks(12, 4, 6), free = fixed;
  relaxed(RingEnergy<FixedDimension<4>>({}, fixed), fixed);
  relaxed(RingEnergy<std::size_t>(4, free), free);
  for (std::size_t k = 0; k < fixed.size(); ++k)
    CHECK(std::abs(fixed[k] - free[k]) < 1e-5);
}

TEST_CASE("With the others fixed, Newton's steps on one block converge quadratically") {
  std::vector<double> points = unit_blocks(20, 3, 8), other = points;
  const auto settle = [](const auto& energy, std::vector<double>& x, std::vector<double>& norms) {
    double reach = 0;
    for (int step = 0; step < 200; ++step) {
      const BlockStep done = improve_block(energy, 0, {1e-7}, x.data(), reach);
      norms.push_back(done.gradient_norm);
      if (!(done.gain > 0)) break;
    }
  };
  std::vector<double> newton, gradient;
  settle(ChargeEnergyWithHessian(points), points, newton);
  settle(ChargeEnergy(other), other, gradient);
  CHECK(newton.back() <= 1e-7);
  CHECK(gradient.back() <= 1e-6);  // where the value resolves no more
  CHECK(newton.size() < 9);
  CHECK(newton.size() < gradient.size());
  for (std::size_t k = 0; k < 3; ++k)
    CHECK(std::abs(points[k] - other[k]) < 1e-6);
}

TEST_CASE("Steps in closed form need the fewest evaluations") {
  std::vector<double> points = blocks_near_one(40, 4, 7);
  std::vector<double> other = points;
  const RelaxationResult closed = relaxed(ClosedRingEnergy(points), points);
  const RelaxationResult searched = relaxed(RingEnergy<FixedDimension<4>>({}, other), other);
  CHECK(closed.stop == Stop::converged);
  CHECK(ClosedRingEnergy(points).total() < 1e-8);
  CHECK(closed.evaluations < searched.evaluations);
}

TEST_CASE("A block never goes where its energy has no value, nor where it may not, and gets close") {
  for (const double limit : {-0.5, 0.2}) {
    std::vector<double> points = {0.6, 0, 0.8, 0, -0.6, 0.8};
    RelaxationOptions options;
    options.max_passes = 100;
    relaxed(HighEnergy(points, limit), points, options);
    CHECK(points[2] > limit);
    CHECK(points[2] < limit + 0.05);
    std::vector<double> held = {0.6, 0, 0.8};
    relaxed(LimitedEnergy(held, limit), held, options);
    CHECK(held[2] > limit);
    CHECK(held[2] < limit + 0.05);
  }
}

TEST_CASE("A block without a value where it is stays and is reported; the others go on") {
  std::vector<double> points = {0.6, 0, 0.8, 0.8, 0, -0.6};  // the second is below the limit
  const RelaxationResult result = relaxed(HighEnergy(points, 0), points);
  CHECK(points[3] == 0.8);
  CHECK(points[2] < 0.1);
  CHECK(result.stop == Stop::evaluation_failed);
  CHECK(result.failed_steps >= 1);
}

TEST_CASE("Values that are not finite at any one evaluation do no harm") {
  class Spoiled : public ChargeEnergyWithHessian {
   public:
    Spoiled(const std::vector<double>& points, std::uint64_t bad, int kind)
        : ChargeEnergyWithHessian(points), bad_(bad), kind_(kind) {}
    double value(std::size_t block, const double* x) const {
      return spoils() ? (kind_ == 1 ? -infinity : std::nan("")) : ChargeEnergyWithHessian::value(block, x);
    }
    double value_gradient_and_hessian(std::size_t block, double* gradient, double* hessian) const {
      const double f = ChargeEnergyWithHessian::value_gradient_and_hessian(block, gradient, hessian);
      if (!spoils()) return f;
      if (kind_ == 2) gradient[1] = std::nan("");
      if (kind_ == 3) hessian[4] = std::nan("");
      return kind_ == 0 ? std::nan("") : f;
    }

   private:
    bool spoils() const { return calls_++ == bad_; }
    std::uint64_t bad_;
    int kind_;
    mutable std::uint64_t calls_ = 0;
  };
  const std::vector<double> start = unit_blocks(6, 3, 9);
  for (std::uint64_t bad = 0; bad < 60; ++bad) {
    for (const int kind : {0, 1, 2, 3}) {
      std::vector<double> points = start;
      RelaxationOptions options;
      options.max_passes = 1000;
      const RelaxationResult result = relaxed(Spoiled(points, bad, kind), points, options);
      CHECK(length_error({6, 3}, points) <= 2);
      CHECK(result.stop != Stop::running);
      // A block that failed once is woken by its neighbors, unless nothing moves any more.
      CHECK(result.gain > 0);
    }
  }
}

TEST_CASE("Passes, gains and hosts end a relaxation") {
  std::vector<double> points = unit_blocks(30, 3, 10);
  const std::vector<double> start = points;
  RelaxationOptions options;
  options.max_passes = 2;
  RelaxationResult result = relaxed(ChargeEnergy(points), points, options);
  CHECK(result.stop == Stop::iteration_budget);
  CHECK(result.steps == 60);
  const double after_two = result.gain;
  options = {};
  options.relative_gain = 0.01;
  points = start;
  result = relaxed(ChargeEnergy(points), points, options);
  CHECK(result.stop == Stop::stalled);
  CHECK(result.gain > 0.9 * after_two);

  points = start;
  base::Host host;
  int reports = 0;
  host.on_progress = [&](const base::Progress&) { return ++reports < 1; };
  Relaxation relaxation({30, 3}, {}, host.memory);
  const ChargeEnergy energy(points);
  CHECK_THROWS_AS(relaxation.run(energy, points, host), base::Error);
  CHECK(relaxation.result().stop == Stop::running);
  CHECK(points == start);
  // It goes on, and serves again.
  const base::Host quiet;
  relaxation.run(energy, points, quiet);
  CHECK(relaxation.result().stop == Stop::converged);
  const std::vector<double> end = points;
  points = start;
  relaxation.begin({});
  relaxation.run(energy, points, quiet);
  CHECK(points == end);
}

TEST_CASE("Algorithm 2 as printed lowers the energy, in more evaluations") {
  std::vector<double> points = unit_blocks(12, 3, 11), other = points;
  RelaxationOptions options;
  options.method = Method::dissertation;
  options.max_passes = 2000;
  const RelaxationResult printed = relaxed(ChargeEnergy(points), points, options);
  const RelaxationResult mended = relaxed(ChargeEnergy(other), other);
  std::vector<double> gradient(36);
  const Problem whole = thomson(12, 0);
  CHECK(whole.function(points, gradient) < 50);
  CHECK(std::abs(whole.function(other, gradient) - 49.165253058) < 1e-8);
  CHECK(mended.evaluations < printed.evaluations);
}
