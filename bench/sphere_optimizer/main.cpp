// Prints tables: evaluations of each method on each problem until every block's tangent gradient is at most 1e-6 (and
// 1e-12 for two), beside what peers took; the certificate of the max-cut relaxation; and a million
// quaternions, all at once and block by block, with the nanoseconds that the library takes a block. compare.py adds
// Pymanopt's methods.
//
// Usage: bench-sphere-optimizer [most evaluations, default 20000]
#include <orbicube/sphere_optimizer.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <random>
#include <string>

#include "problems.h"
#include "sphere_optimizer/relaxation.h"
#include "tests/sphere_optimizer/lattice.h"

using namespace orbicube::bench;

namespace {

struct Outcome {
  obc_sphere_optimizer_result result{};
  std::vector<double> x;
  double length_error = 0;  // largest |length of a block - 1| where f was requested, in units of 2^-52
};

double length_error(const Problem& problem, const double* x) {
  long double worst = 0;
  for (std::size_t i = 0; i < problem.count; ++i) {
    long double square = 0;
    for (std::size_t k = i * problem.dimension; k < (i + 1) * problem.dimension; ++k)
      square += static_cast<long double>(x[k]) * x[k];
    worst = std::max(worst, std::abs(std::sqrt(square) - 1));
  }
  return static_cast<double>(worst) * 0x1p52;
}

Outcome run(const Problem& problem, std::int32_t method, double tolerance, std::uint64_t most) {
  obc_sphere_optimizer_options options;
  obc_sphere_optimizer_options_init(&options, sizeof options);
  options.method = method;
  options.gradient_tolerance = tolerance;
  options.max_evaluations = most;
  Outcome outcome;
  outcome.x = problem.start;
  outcome.result.struct_size = sizeof outcome.result;
  struct Call {
    const Problem& problem;
    double worst = 0;
  } call{problem};
  const obc_sphere_optimizer_function f = [](const double* x, std::size_t, std::size_t, double* value, double* gradient,
                                             void* user) -> std::int32_t {
    Call& to = *static_cast<Call*>(user);
    to.worst = std::max(to.worst, length_error(to.problem, x));
    *value = to.problem.evaluate(x, gradient);
    return OBC_SPHERE_OPTIMIZER_CONTINUE;
  };
  obc_error error;
  if (obc_sphere_optimizer_minimize(problem.count, problem.dimension, &options, f, &call, outcome.x.data(),
                                    &outcome.result, nullptr, &error) != OBC_OK) {
    std::fprintf(stderr, "%s: %s\n", error.kind, error.message);
    std::exit(1);
  }
  outcome.length_error = call.worst;
  return outcome;
}

std::string evaluations(const Outcome& outcome) {
  std::string text = std::to_string(outcome.result.evaluations);
  if (outcome.result.stop != OBC_SPHERE_OPTIMIZER_CONVERGED) {
    char gradient[32];
    std::snprintf(gradient, sizeof gradient, " (%.0e)", outcome.result.gradient_norm);
    text += gradient;
  }
  return text;
}

// How far below the value the optimum may be, relative to it: from the minimum eigenvalue of W - diag(x_i . (W X)_i).
double certificate(const Problem& problem, const Outcome& outcome) {
  const auto n = static_cast<Eigen::Index>(problem.count), d = static_cast<Eigen::Index>(problem.dimension);
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Eigen::Map<const Rows> weights(problem.weights.data(), n, n), x(outcome.x.data(), n, d);
  const Rows pulled = weights * x;
  Eigen::MatrixXd slack = weights;
  for (Eigen::Index i = 0; i < n; ++i)
    slack(i, i) -= x.row(i).dot(pulled.row(i));
  const double least = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(slack, Eigen::EigenvaluesOnly).eigenvalues()[0];
  return static_cast<double>(n) * std::max(0.0, -least) / std::abs(outcome.result.value);
}

// A sum over pairs block by block.
template <class Dimension>
class PairEnergy {
 public:
  PairEnergy(Dimension dimension, const Problem& problem, const std::vector<double>& points)
      : dimension_(dimension), sum_(problem.pair_sum), points_(points), begin_(problem.count + 1) {
    for (const auto& [a, b] : sum_.pairs) {
      ++begin_[a + 1];
      ++begin_[b + 1];
    }
    for (std::size_t i = 0; i < problem.count; ++i)
      begin_[i + 1] += begin_[i];
    neighbors_.resize(2 * sum_.pairs.size());
    std::vector<std::size_t> next(begin_.begin(), begin_.end());
    for (std::size_t k = 0; k < sum_.pairs.size(); ++k) {
      const auto& [a, b] = sum_.pairs[k];
      neighbors_[next[a]++] = {b, k};
      neighbors_[next[b]++] = {a, k + sum_.pairs.size()};
    }
  }
  Dimension dimension() const { return dimension_; }
  double value(std::size_t block, const double* x) const { return add_up(block, x, nullptr); }
  double value_and_gradient(std::size_t block, double* gradient) const {
    std::fill_n(gradient, std::size_t{dimension_}, 0.0);
    return add_up(block, &points_[dimension_ * block], gradient);
  }
  template <class Visit>
  void for_each_neighbor(std::size_t block, const Visit& visit) const {
    for (std::size_t k = begin_[block]; k < begin_[block + 1]; ++k)
      visit(neighbors_[k].block);
  }

 private:
  struct Neighbor {
    std::size_t block, pair;
  };
  double add_up(std::size_t block, const double* x, double* gradient) const {
    double value = 0;
    for (std::size_t k = begin_[block]; k < begin_[block + 1]; ++k)
      value += sum_.term(neighbors_[k].pair, x, &points_[dimension_ * neighbors_[k].block], gradient);
    return value;
  }
  Dimension dimension_;
  const PairSum& sum_;
  const std::vector<double>& points_;
  std::vector<std::size_t> begin_;
  std::vector<Neighbor> neighbors_;
};

// Evaluations a block of one relaxation to 1e-5, of all its parts.
std::string relaxed(const Problem& problem, const orbicube::sphere_optimizer::RelaxationOptions& options) {
  using namespace orbicube::sphere_optimizer;
  std::vector<double> points = problem.start;
  RelaxationResult result;
  with_dimension(problem.dimension, [&](auto d) {
    for (std::size_t i = 0; i < problem.count; ++i)
      normalize(d, &points[i * d]);
    result = relax(PairEnergy<decltype(d)>(d, problem, points), points, options, orbicube::base::Host());
  });
  std::vector<double> gradient(points.size());
  char text[96];
  std::snprintf(text, sizeof text, "%.0f",
                static_cast<double>(result.evaluations) / static_cast<double>(problem.count));
  std::string answer = text;
  if (result.stop != Stop::converged) {
    std::snprintf(text, sizeof text, " (%.0e)", result.gradient_norm);
    answer += text;
  }
  std::snprintf(text, sizeof text, ", f %.8g", problem.evaluate(points.data(), gradient.data()));
  return answer + text;
}

void block_by_block() {
  using namespace orbicube::sphere_optimizer;
  std::printf(
      "\n| block by block to 1e-5, evaluations a block | default | queue alone | without over-relaxation | "
      "DISSERTATION "
      "|\n|---|---|---|---|---|\n");
  for (std::size_t index = 0; index < problem_count(); ++index) {
    const Problem problem = make_problem(index);
    if (problem.pair_sum.pairs.empty()) continue;
    RelaxationOptions options;
    options.gradient_tolerance = 1e-5;
    options.max_passes = 5000;
    std::printf("| %s | %s", problem.name.c_str(), relaxed(problem, options).c_str());
    options.order = Order::queue;
    std::printf(" | %s", relaxed(problem, options).c_str());
    options.over_relaxation = 1;
    std::printf(" | %s", relaxed(problem, options).c_str());
    options.method = Method::dissertation;
    std::printf(" | %s |\n", relaxed(problem, options).c_str());
    std::fflush(stdout);
  }
}

void a_million_quaternions() {
  using namespace orbicube::sphere_optimizer;
  // Time of this process, which other work on the machine disturbs less.
  const auto now = [] { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; };
  const auto since = [&](double start) { return now() - start; };
  constexpr std::size_t side = 100, count = side * side * side;
  std::vector<double> start(4 * count), gradient(4 * count);
  // Rotations half a radian or more off one another.
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  for (std::size_t k = 0; k < 4 * count; ++k)
    start[k] = normal(random) + (k % 4 == 0 ? 1.5 : 0);
  for (std::size_t i = 0; i < count; ++i)
    normalize(FixedDimension<4>{}, &start[4 * i]);
  std::printf(
      "\n| a million quaternions on a lattice | evaluations a block | energy | library's ns a block and evaluation "
      "| f's |\n|---|---|---|---|---|\n");

  double in_f = 0;
  const auto all = [&](const std::vector<double>& x) {
    const auto begin = now();
    const double sum = orbicube::test::LatticeEnergy(side, x).all(gradient);
    in_f += since(begin);
    return sum;
  };
  struct Case {
    std::uint32_t memory;
    std::uint64_t evaluations;
  };
  for (const auto [memory, evaluations] : {Case{4, 12}, Case{4, 100}, Case{16, 100}}) {
    obc_sphere_optimizer_options options;
    obc_sphere_optimizer_options_init(&options, sizeof options);
    options.memory = memory;
    options.max_evaluations = evaluations;
    obc_sphere_optimizer* solver = nullptr;
    if (obc_sphere_optimizer_create(count, 4, &options, start.data(), nullptr, &solver, nullptr) != OBC_OK) return;
    in_f = 0;
    std::vector<double> x(4 * count);
    const double* point = nullptr;
    const auto begin = now();
    double copying = 0;
    for (std::int32_t request; (request = obc_sphere_optimizer_step(solver, &point)) != OBC_SPHERE_OPTIMIZER_DONE;) {
      if (request != OBC_SPHERE_OPTIMIZER_NEED_FG) continue;
      const auto copy = now();
      std::copy(point, point + 4 * count, x.begin());
      copying += since(copy);
      const double value = all(x);
      obc_sphere_optimizer_tell(solver, value, gradient.data(), nullptr);
    }
    const double seconds = since(begin);
    obc_sphere_optimizer_result result{};
    result.struct_size = sizeof result;
    obc_sphere_optimizer_get_result(solver, &result, nullptr, nullptr);
    const double evaluated = static_cast<double>(count) * static_cast<double>(result.evaluations);
    std::printf("| all at once, %u pairs | %.1f | %.6g | %.0f | %.0f |\n", memory,
                static_cast<double>(result.evaluations), result.value, 1e9 * (seconds - in_f - copying) / evaluated,
                1e9 * in_f / evaluated);
    std::fflush(stdout);
    obc_sphere_optimizer_destroy(solver);
  }
  struct Row {
    const char* name;
    Method method;
    Order order;
    double over_relaxation;
    std::uint64_t passes;
  };
  for (const Row& row : {Row{"default", Method::great_circle, Order::automatic, 0, 5},
                         Row{"default", Method::great_circle, Order::automatic, 0, 50},
                         Row{"sweeps", Method::great_circle, Order::sweeps, 0, 50},
                         Row{"sweeps, over-relaxation 1.9", Method::great_circle, Order::sweeps, 1.9, 50},
                         Row{"as printed", Method::dissertation, Order::queue, 1, 5},
                         Row{"as printed", Method::dissertation, Order::queue, 1, 20}}) {
    std::vector<double> points = start;
    const orbicube::test::LatticeEnergy energy(side, points);
    const orbicube::base::Host host;
    RelaxationOptions options;
    options.method = row.method;
    options.order = row.order;
    options.over_relaxation = row.over_relaxation;
    options.max_passes = row.passes;
    Relaxation relaxation({count, 4}, options, host.memory);
    const auto begin = now();
    relaxation.run(energy, points, host);
    const double seconds = since(begin);
    const auto evaluations = static_cast<double>(relaxation.result().evaluations);
    std::printf("| block by block, %s, %d passes | %.1f | %.6g | %.0f, with f | |\n", row.name,
                static_cast<int>(row.passes), evaluations / static_cast<double>(count), all(points),
                1e9 * seconds / evaluations);
    std::fflush(stdout);
  }
}

}  // namespace

int main(int argument_count, char** arguments) {
  const std::uint64_t most = argument_count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 20000;
  std::printf(
      "| evaluations | default | to 1e-12 | BARZILAI_BORWEIN | GREAT_CIRCLE | DISSERTATION | TRUNCATED_NEWTON | to "
      "1e-12 "
      "| reference CG | BB | halving | f | lengths |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  double gap = 0;
  for (std::size_t index = 0; index < problem_count(); ++index) {
    const Problem problem = make_problem(index);
    const Outcome best = run(problem, OBC_SPHERE_OPTIMIZER_LIMITED_MEMORY, 1e-12, most),
                  newton = run(problem, OBC_SPHERE_OPTIMIZER_TRUNCATED_NEWTON, 1e-12, most);
    std::vector<Outcome> outcomes;
    double worst = best.length_error;
    for (std::int32_t method = 0; method <= OBC_SPHERE_OPTIMIZER_TRUNCATED_NEWTON; ++method) {
      outcomes.push_back(run(problem, method, 1e-6, most));
      worst = std::max(worst, outcomes.back().length_error);
    }
    const auto reference = [](int value) { return value > 0 ? std::to_string(value) : std::string("-"); };
    std::printf("| %s | %s | %s | %s | %s | %s | %s | %s | %s | %s | %s | %.12g | %.2f ulp |\n", problem.name.c_str(),
                evaluations(outcomes[0]).c_str(), evaluations(best).c_str(), evaluations(outcomes[1]).c_str(),
                evaluations(outcomes[2]).c_str(), evaluations(outcomes[3]).c_str(), evaluations(outcomes[4]).c_str(),
                evaluations(newton).c_str(), reference(problem.reference.conjugate).c_str(),
                reference(problem.reference.barzilai_borwein).c_str(), reference(problem.reference.halving).c_str(),
                best.result.value, worst);
    std::fflush(stdout);
    if (!problem.weights.empty()) gap = certificate(problem, outcomes[0]);
  }
  std::printf("\nMax-cut: no feasible value is lower by more than %.1e of it, proved by an eigenvalue.\n", gap);
  block_by_block();
  a_million_quaternions();
  return gap < 1e-6 ? 0 : 1;
}
