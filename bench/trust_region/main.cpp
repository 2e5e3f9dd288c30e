// Prints tables: how many of the 53 cases of More and Wild are solved within kappa (n + 1) evaluations, where solved is
// f <= fL + tau (f(x0) - fL) with fL frozen (lowest.h), standard, rotated and permuted, and with active bounds; signed
// sums; noise; many unknowns; and microseconds an evaluation outside of f. Everything runs in this process through the
// C interface, NLopt's BOBYQA beside it; compare.py adds the peers of PyPI on the same cases.
//
// Usage: bench-trust-region [--lowest | --lowest-bounded | --lowest-magnitudes | --lowest-largest |
// --find-lowest-suite | plain | radius | transformed | bounded | signed | nonsmooth | noise | suite | suite-noise |
// large | domain | cost]...
// With ORBICUBE_BENCH_UNSOLVED in the environment, lists the cases that are not solved to the second tolerance; with
// ORBICUBE_BENCH_ONLY, the tables have the solver of that name only.
#include <orbicube/trust_region.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <initializer_list>
#include <limits>
#include <string>
#include <vector>

#include "domain.h"
#include "lowest.h"
#include "lowest_suite.h"
#include "peers.h"
#include "problems.h"
#include "suite.h"

using namespace orbicube::bench;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::array<int, 6> kappas = {10, 25, 50, 100, 200, 500};

enum class Kind { residuals, growing, fixed_points, dissertation, composite, nlopt, nlopt_newuoa };

const char* name_of(Kind kind) {
  switch (kind) {
    case Kind::residuals:
      return "residuals";
    case Kind::growing:
      return "scalar, growing";
    case Kind::fixed_points:
      return "scalar, 2n + 1 points";
    case Kind::dissertation:
      return "residuals, dissertation";
    case Kind::composite:
      return "residuals, their objective";
    case Kind::nlopt:
      return "NLopt BOBYQA";
    case Kind::nlopt_newuoa:
      return "NLopt NEWUOA";
  }
  return "";
}

struct Record {
  std::vector<double> values;  // of f without noise, in the order of evaluations; infinite outside of the bounds
  std::size_t breaches = 0;
  double seconds = 0;  // outside of f
  int stop = 0;
};

// Processor time of this thread in seconds: what others do on the machine does not count.
double processor_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Evaluation {
  const Problem* noisy;
  Problem exact;
  Record record;
  bool with_residuals = false;
  double seconds = 0;
  std::vector<double> r;

  explicit Evaluation(const Problem& problem) : noisy(&problem), exact(problem), r(problem.m) {
    exact.noise_relative = exact.noise_absolute = 0;
  }
  double value(const double* x, double* residuals) {
    const double start = processor_time();
    exact.residuals(x, r.data());
    bool inside = true;
    for (std::size_t i = 0; i < exact.n; ++i)
      inside = inside && x[i] >= exact.lower[i] && x[i] <= exact.upper[i];
    if (!inside) ++record.breaches;
    record.values.push_back(inside ? exact.objective(r) : infinity);
    if (noisy->noise_relative > 0 || noisy->noise_absolute > 0) noisy->residuals(x, r.data());
    if (residuals != nullptr) std::copy(r.begin(), r.end(), residuals);
    const double f = exact.objective(r);
    seconds += processor_time() - start;
    return f;
  }
};

Record run(const Problem& problem, Kind kind, std::size_t budget) {
  Evaluation evaluation(problem);
  const double start = processor_time();
  if (kind == Kind::nlopt || kind == Kind::nlopt_newuoa) {
    run_nlopt(kind == Kind::nlopt_newuoa, problem.start, problem.lower, problem.upper, problem.start_radius(), budget,
              [&](const double* x) { return evaluation.value(x, nullptr); });
  } else {
    evaluation.with_residuals = kind == Kind::residuals || kind == Kind::dissertation || kind == Kind::composite;
    obc_trust_region_problem p;
    obc_trust_region_problem_init(&p, sizeof p);
    p.n = problem.n;
    if (problem.bounded()) {
      p.lower = problem.lower.data();
      p.upper = problem.upper.data();
    }
    if (evaluation.with_residuals) {
      p.residuals = problem.m;
      if (!problem.sign.empty()) p.sign = problem.sign.data();
      if (kind == Kind::composite)
        p.objective =
            problem.norm == Norm::largest ? OBC_TRUST_REGION_MAX_MAGNITUDE : OBC_TRUST_REGION_SUM_OF_MAGNITUDES;
    }
    obc_trust_region_options options;
    obc_trust_region_options_init(&options, sizeof options);
    options.radius_begin = problem.start_radius();
    options.max_evaluations = budget;
    if (kind == Kind::dissertation) options.method = OBC_TRUST_REGION_DISSERTATION;
    if (kind == Kind::fixed_points) options.points = std::min(2 * problem.n + 1, (problem.n + 1) * (problem.n + 2) / 2);
    options.noise_relative = 2 * problem.noise_relative;  // of the sum of squares
    options.noise_absolute = problem.noise_absolute;
    obc_trust_region_result result{};
    result.struct_size = sizeof result;
    const obc_trust_region_function f = [](const double* x, std::size_t, double* outputs, void* user) -> std::int32_t {
      Evaluation& e = *static_cast<Evaluation*>(user);
      const double value = e.value(x, e.with_residuals ? outputs : nullptr);
      if (!e.with_residuals) *outputs = value;
      return OBC_TRUST_REGION_CONTINUE;
    };
    std::vector<double> x = problem.start;
    obc_error error;
    if (obc_trust_region_minimize(&p, &options, f, &evaluation, x.data(), &result, nullptr, &error) != OBC_OK) {
      std::fprintf(stderr, "%s: %s\n", error.kind, error.message);
      std::exit(1);
    }
    evaluation.record.stop = result.stop;
  }
  evaluation.record.seconds = processor_time() - start - evaluation.seconds;
  return evaluation.record;
}

// Evaluations until f <= fL + tau (f(x0) - fL); infinite when that was not reached.
double solved_at(const Record& record, double lowest, double tau) {
  const double goal = lowest + tau * (record.values[0] - lowest);
  for (std::size_t k = 0; k < record.values.size(); ++k) {
    if (record.values[k] <= goal) return static_cast<double>(k + 1);
  }
  return infinity;
}

void table(const char* title, const std::vector<Kind>& kinds, const std::vector<double>& taus,
           const std::vector<std::vector<Problem>>& sets, const double* lowest, std::size_t most = 500) {
  std::printf("\n### %s\n\n| solver | tau | 10 | 25 | 50 | 100 | 200 | 500 | points outside of the bounds |\n", title);
  std::printf("|---|---|---|---|---|---|---|---|---|\n");
  for (const Kind kind : kinds) {
    if ((kind == Kind::nlopt || kind == Kind::nlopt_newuoa) && !has_nlopt()) continue;
    if (const char* only = std::getenv("ORBICUBE_BENCH_ONLY"); only != nullptr && std::strcmp(only, name_of(kind)) != 0)
      continue;
    std::vector<std::array<double, kappas.size()>> counts(taus.size());
    std::size_t breaches = 0;
    for (const std::vector<Problem>& set : sets) {
      for (std::size_t i = 0; i < set.size(); ++i) {
        const double unit = static_cast<double>(set[i].n + 1);
        const Record record = run(set[i], kind, most * (set[i].n + 1));
        breaches += record.breaches;
        if (std::getenv("ORBICUBE_BENCH_UNSOLVED") != nullptr && solved_at(record, lowest[i], taus[1]) > 1e8)
          std::fprintf(stderr, "%s: %s, n %zu, unsolved, f %g of %g after %zu\n", name_of(kind), set[i].name.c_str(),
                       set[i].n, *std::min_element(record.values.begin(), record.values.end()), lowest[i],
                       record.values.size());
        for (std::size_t t = 0; t < taus.size(); ++t) {
          const double at = solved_at(record, lowest[i], taus[t]);
          for (std::size_t k = 0; k < kappas.size(); ++k)
            counts[t][k] += at <= kappas[k] * unit ? 1 : 0;
        }
      }
    }
    for (std::size_t t = 0; t < taus.size(); ++t) {
      std::printf("| %s | %g |", name_of(kind), taus[t]);
      for (std::size_t k = 0; k < kappas.size(); ++k) {
        if (static_cast<std::size_t>(kappas[k]) <= most)
          std::printf(" %g |", counts[t][k] / static_cast<double>(sets.size()));
        else
          std::printf(" - |");
      }
      std::printf(" %zu |\n", breaches);
    }
    std::fflush(stdout);
  }
}

std::vector<Problem> every_case(int transform) {
  std::vector<Problem> set;
  for (std::size_t i = 0; i < case_count; ++i)
    set.push_back(transform < 0 ? make_bounded_case(i) : make_case(i, transform));
  return set;
}

const std::vector<Kind> every_kind = {Kind::residuals, Kind::dissertation, Kind::growing, Kind::fixed_points,
                                      Kind::nlopt};

void plain() {
  table("53 cases, standard starts", every_kind, {1e-3, 1e-5, 1e-7}, {every_case(0)}, lowest_values.data());
}

void radius() {
  std::vector<Problem> set = every_case(0);
  for (Problem& p : set)
    p.radius_part = 1;
  table("53 cases, standard starts, start radius 1",
        {Kind::residuals, Kind::growing, Kind::fixed_points, Kind::nlopt, Kind::nlopt_newuoa}, {1e-1, 1e-3, 1e-5, 1e-7},
        {set}, lowest_values.data());
}

void transformed() {
  std::vector<std::vector<Problem>> sets;
  for (int transform = 1; transform <= 10; ++transform)
    sets.push_back(every_case(transform));
  table("53 cases, mean over 6 rotations and 4 permutations of the variables (at most 100 (n + 1) evaluations)",
        {Kind::residuals, Kind::growing, Kind::fixed_points, Kind::nlopt}, {1e-5, 1e-7}, sets, lowest_values.data(),
        100);
}

// The lowest f that any solver of this program reaches on each problem.
std::vector<double> lowest_here(const std::vector<Problem>& set, const std::vector<Kind>& kinds = every_kind) {
  std::vector<double> lowest;
  for (const Problem& p : set) {
    double least = infinity;
    for (const Kind kind : kinds) {
      if ((kind == Kind::nlopt || kind == Kind::nlopt_newuoa) && !has_nlopt()) continue;
      if (!p.squares && (kind == Kind::residuals || kind == Kind::dissertation)) continue;
      for (const double value : run(p, kind, 500 * (p.n + 1)).values)
        least = std::min(least, value);
    }
    lowest.push_back(least);
  }
  return lowest;
}

void bounded() {
  table("53 cases with active bounds", every_kind, {1e-5, 1e-7}, {every_case(-1)}, lowest_bounded_values.data());
}

void signed_sums() {
  std::vector<Problem> set;
  for (std::size_t i = 0; i < signed_count; ++i)
    set.push_back(make_signed(i));
  table("signed sums of squares in a box, n = 2 to 13 (12 cases; fL of these runs)", every_kind, {1e-5, 1e-7}, {set},
        lowest_here(set).data());
}

const std::vector<Kind> kinds_with_corners = {Kind::composite, Kind::growing, Kind::fixed_points, Kind::nlopt,
                                              Kind::nlopt_newuoa};

std::vector<Problem> cases_of_norm(Norm norm) {
  std::vector<Problem> set = every_case(0);
  for (Problem& p : set)
    p.norm = norm;
  return set;
}

// The lowest f that any solver of this program reaches; 0 where the residuals vanish.
std::vector<double> lowest_of_norm(Norm norm) {
  std::vector<double> lowest = lowest_here(cases_of_norm(norm), kinds_with_corners);
  for (std::size_t i = 0; i < lowest.size(); ++i) {
    if (lowest_values[i] < 1e-20) lowest[i] = 0;
  }
  return lowest;
}

void nonsmooth() {
  for (const Norm norm : {Norm::magnitudes, Norm::largest}) {
    table(norm == Norm::magnitudes ? "53 cases, sum of |residuals| (fL of these runs)"
                                   : "53 cases, largest |residual| (fL of these runs)",
          kinds_with_corners, {1e-1, 1e-3, 1e-5, 1e-7}, {cases_of_norm(norm)}, lowest_of_norm(norm).data());
  }
}

void noise() {
  for (const bool relative : {true, false}) {
    std::vector<Problem> set = every_case(0);
    for (Problem& p : set)
      (relative ? p.noise_relative : p.noise_absolute) = relative ? 1e-3 : 1e-5;
    table(relative ? "53 cases, each residual with relative noise 1e-3 (f of the points without noise)"
                   : "53 cases, each residual with absolute noise 1e-5 (f of the points without noise)",
          {Kind::residuals, Kind::growing, Kind::fixed_points, Kind::nlopt}, {1e-2, 1e-3}, {set}, lowest_values.data());
    std::printf("\nEvaluations until the runs ended by themselves:");
    for (const Kind kind : {Kind::residuals, Kind::growing, Kind::fixed_points, Kind::nlopt}) {
      std::size_t evaluations = 0;
      for (const Problem& p : set)
        evaluations += run(p, kind, 500 * (p.n + 1)).values.size();
      std::printf(" %s %zu;", name_of(kind), evaluations);
    }
    std::printf("\n");
  }
}

// Tables of the second set of problems. Everything at the three tolerances of the other tables.
void suite_tables(const char* title, const std::vector<std::size_t>& numbers, double radius_part, double noise,
                  const std::vector<double>& taus) {
  std::vector<Problem> squares, values;
  std::vector<double> lowest_squares, lowest;
  for (const std::size_t i : numbers) {
    Problem p = make_suite_case(i);
    p.radius_part = radius_part;
    p.noise_relative = noise;
    if (p.squares) {
      squares.push_back(p);
      lowest_squares.push_back(lowest_suite_values[i]);
    }
    values.push_back(std::move(p));
    lowest.push_back(lowest_suite_values[i]);
  }
  const std::string text = std::string(title) + ", start radius " + (radius_part == 1 ? "1" : "0.1") + ", " +
                           std::to_string(values.size()) + " cases (" + std::to_string(squares.size()) +
                           " with residuals)";
  std::vector<Kind> kinds = {Kind::growing, Kind::fixed_points, Kind::nlopt};
  if (!values.front().bounded()) kinds.push_back(Kind::nlopt_newuoa);
  table(text.c_str(), kinds, taus, {values}, lowest.data(), 100);
  if (!squares.empty())
    table("the same with residuals", {Kind::residuals}, taus, {squares}, lowest_squares.data(), 100);
}

void suite() {
  std::vector<std::size_t> open, boxed;
  for (std::size_t i = 0; i < suite_rows().size(); ++i)
    (suite_rows()[i].lower.empty() ? open : boxed).push_back(i);
  for (const double part : {0.1, 1.0}) {
    suite_tables("Second set, no bounds", open, part, 0, {1e-1, 1e-3, 1e-5, 1e-7});
    suite_tables("Second set, with bounds", boxed, part, 0, {1e-1, 1e-3, 1e-5, 1e-7});
  }
}

void suite_noise() {
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < suite_rows().size(); ++i) {
    if (suite_rows()[i].lower.empty()) open.push_back(i);
  }
  for (const double noise : {1e-3, 1e-5, 1e-8}) {
    std::string title = "Second set, no bounds, relative noise ";
    title += noise == 1e-3 ? "1e-3" : noise == 1e-5 ? "1e-5" : "1e-8";
    suite_tables(title.c_str(), open, 0.1, noise, {1e-1, 1e-3, 1e-5});
  }
}

void large() {
  std::printf("\n### Many unknowns: evaluations / (n + 1) until f <= tau f(x0), at most 100\n\n");
  std::printf("| problem | solver | 1e-3 | 1e-5 | 1e-7 | ms an evaluation outside of f |\n|---|---|---|---|---|---|\n");
  for (const std::size_t n : std::initializer_list<std::size_t>{60, 120}) {
    for (int kind_of_problem = 0; kind_of_problem < large_count; ++kind_of_problem) {
      const Problem p = make_large(kind_of_problem, n);
      for (const Kind kind : {Kind::residuals, Kind::growing, Kind::fixed_points, Kind::nlopt}) {
        if (kind == Kind::nlopt && !has_nlopt()) continue;
        const Record record = run(p, kind, 100 * (n + 1));
        std::printf("| %s | %s |", p.name.c_str(), name_of(kind));
        for (const double tau : {1e-3, 1e-5, 1e-7})
          std::printf(" %.1f |", solved_at(record, 0, tau) / static_cast<double>(n + 1));
        std::printf(" %.3f |\n", 1e3 * record.seconds / static_cast<double>(record.values.size()));
        std::fflush(stdout);
      }
    }
  }
}

void cost() {
  std::printf(
      "\n### Microseconds an evaluation outside of f, chained Rosenbrock, 40 (n + 1) evaluations, best of 5\n\n");
  std::printf("| n | scalar, 2n + 1 points | scalar, growing | NLopt BOBYQA |\n|---|---|---|---|\n");
  for (const std::size_t n : std::initializer_list<std::size_t>{6, 12, 24, 48, 96}) {
    const Problem p = make_large(0, n);
    std::printf("| %zu |", n);
    for (const Kind kind : {Kind::fixed_points, Kind::growing, Kind::nlopt}) {
      double least = infinity;
      for (int repeat = 0; repeat < 5; ++repeat) {
        const Record record = run(p, kind, 40 * (n + 1));
        least = std::min(least, record.seconds / static_cast<double>(record.values.size()));
      }
      std::printf(" %.2f |", 1e6 * least);
    }
    std::printf("\n");
    std::fflush(stdout);
  }
}

}  // namespace

int main(int count, char** arguments) {
  const auto wants = [&](const char* word) {
    for (int i = 1; i < count; ++i) {
      if (std::strcmp(arguments[i], word) == 0) return true;
    }
    return count == 1;
  };
  if (count == 2 && std::strcmp(arguments[1], "--find-lowest-suite") == 0) {
    std::vector<Problem> set;
    for (std::size_t i = 0; i < suite_rows().size(); ++i) {
      set.push_back(make_suite_case(i));
      set.push_back(set.back());
      set.back().radius_part = 1;
    }
    const std::vector<double> lowest = lowest_here(set);
    for (std::size_t i = 0; i < lowest.size(); i += 2)
      std::printf("%.17g,  // %s\n", std::min(lowest[i], lowest[i + 1]), set[i].name.c_str());
    return 0;
  }
  for (const Norm norm : {Norm::magnitudes, Norm::largest}) {
    if (count != 2 ||
        std::strcmp(arguments[1], norm == Norm::magnitudes ? "--lowest-magnitudes" : "--lowest-largest") != 0)
      continue;
    for (const double value : lowest_of_norm(norm))
      std::printf("%.17g\n", value);
    return 0;
  }
  for (const bool boxed : {false, true}) {
    if (count == 2 && std::strcmp(arguments[1], boxed ? "--lowest-bounded" : "--lowest") == 0) {
      for (const double value : boxed ? lowest_bounded_values : lowest_values)
        std::printf("%.17g\n", value);
      return 0;
    }
  }
  std::printf("Peer in this process: NLopt %s.\n", has_nlopt() ? "yes" : "not found");
  if (wants("plain")) plain();
  if (wants("radius")) radius();
  if (wants("transformed")) transformed();
  if (wants("bounded")) bounded();
  if (wants("signed")) signed_sums();
  if (wants("nonsmooth")) nonsmooth();
  if (wants("noise")) noise();
  if (wants("suite")) suite();
  if (wants("suite-noise")) suite_noise();
  if (wants("large")) large();
  if (wants("domain")) print_hidden_domain();
  if (wants("cost")) cost();
  return 0;
}
