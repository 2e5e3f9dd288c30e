// A quadratic whose minimum lies on the boundary of a half-space that is known by failures of f alone: where a run ends
// varies with the start, hence the median and the largest of 21 starts.
#include "domain.h"

#include <orbicube/trust_region.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <initializer_list>
#include <limits>
#include <random>
#include <vector>

namespace orbicube::bench {
namespace {

constexpr std::size_t starts = 21;

struct Outcomes {
  std::array<double, starts> values{}, evaluations{};
};

std::int32_t half_space(const double* x, std::size_t n, double* output, void*) {
  *output = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double away = x[i] - static_cast<double>(i) - 1;
    *output += static_cast<double>(i + 1) * away * away;
  }
  if (x[0] + x[1] > 2) *output = std::numeric_limits<double>::quiet_NaN();
  return OBC_TRUST_REGION_CONTINUE;
}

// Runs from starts within 0.001 of 0; of the default points where `points` is 0.
Outcomes run_from_all(std::size_t n, std::size_t points) {
  obc_trust_region_problem problem;
  obc_trust_region_problem_init(&problem, sizeof problem);
  problem.n = n;
  obc_trust_region_options options;
  obc_trust_region_options_init(&options, sizeof options);
  options.points = points;
  Outcomes outcomes;
  std::mt19937 random(1);
  for (std::size_t i = 0; i < starts; ++i) {
    std::vector<double> x(n);
    for (double& v : x)
      v = 1e-3 * (2 * static_cast<double>(random()) / 4294967296.0 - 1);
    obc_trust_region_result result{};
    result.struct_size = sizeof result;
    if (obc_trust_region_minimize(&problem, &options, half_space, nullptr, x.data(), &result, nullptr, nullptr) !=
        OBC_OK)
      std::fprintf(stderr, "no result\n");
    outcomes.values[i] = result.value;
    outcomes.evaluations[i] = static_cast<double>(result.evaluations);
  }
  std::sort(outcomes.values.begin(), outcomes.values.end());
  std::sort(outcomes.evaluations.begin(), outcomes.evaluations.end());
  return outcomes;
}

}  // namespace

void print_hidden_domain() {
  std::printf("\n### f at the end (minimum 2/3), median and largest of 21 starts, and median of the evaluations\n\n");
  std::printf("| n | points | median | largest | evaluations |\n|---|---|---|---|---|\n");
  for (const std::size_t n : std::initializer_list<std::size_t>{2, 4, 6}) {
    for (const std::size_t points : {std::size_t{0}, 2 * n + 1}) {
      const Outcomes outcomes = run_from_all(n, points);
      std::printf("| %zu | %s | %.4f | %.4f | %.0f |\n", n, points == 0 ? "default" : "2n + 1",
                  outcomes.values[starts / 2], outcomes.values.back(), outcomes.evaluations[starts / 2]);
    }
  }
}

}  // namespace orbicube::bench
