// Norms of the degrees, distances and filters.
#include "harmonics/functions/spectrum.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "samples.h"

using namespace orbicube;
using namespace orbicube::harmonics;

TEST_CASE("The norms of the degrees add up to the norm of the function") {
  const Coefficients f = Samples(31).coefficients(7, 3);
  std::vector<double> norms(8);
  degree_norms(f, norms);
  double sum = 0, all = 0;
  for (const double n : norms)
    sum += n * n;
  for (const double a : f.values)
    all += a * a;
  CHECK(sum == doctest::Approx(all).epsilon(1e-14));
  CHECK(norms[0] ==
        doctest::Approx(std::sqrt(f.values[0] * f.values[0] + f.values[1] * f.values[1] + f.values[2] * f.values[2])));
}

TEST_CASE("D_n is the sum of the squared differences of the norms, between the degrees requested") {
  Samples samples(32);
  const Coefficients f = samples.coefficients(4, 2), g = samples.coefficients(6, 2);
  std::vector<double> a(7), b(7);
  degree_norms(f, std::span(a).first(5));
  degree_norms(g, b);
  for (const auto& [first, last] : {std::pair{0U, 6U}, {1U, 3U}, {5U, 100U}, {3U, 2U}}) {
    double sum = 0;
    for (std::uint32_t l = first; l <= std::min(last, 6U); ++l)
      sum += (a[l] - b[l]) * (a[l] - b[l]);
    CHECK(shape_distance(f, g, first, last) == doctest::Approx(sum).epsilon(1e-14));
    CHECK(shape_distance(f, g, first, last) == shape_distance(g, f, first, last));
    CHECK(shape_distance(f, f, first, last) == 0);
  }
}

TEST_CASE("Filters keep their band, fade beside it, and leave degree 0 when asked to") {
  const Coefficients f = Samples(33).coefficients(10, 3);
  for (const bool keep_mean : {false, true}) {
    Coefficients g = f;
    filter(g, {.low = 3, .high = 6, .width = 2}, keep_mean);
    for (std::uint32_t l = 0; l <= 10; ++l) {
      const double two_thirds = 0.75, one_third = 0.25;
      const double factor = l == 0 && keep_mean ? 1
                            : l >= 3 && l <= 6  ? 1
                            : l == 2 || l == 7  ? two_thirds
                            : l == 1 || l == 8  ? one_third
                                                : 0;
      for (std::size_t k = l * l * 3; k < basis_size(l) * 3; ++k)
        CHECK(std::abs(g.values[k] - factor * f.values[k]) < 1e-15);
    }
  }
}

TEST_CASE("Low and high pass of one cut add up to the whole") {
  const Coefficients f = Samples(34).coefficients(9, 1);
  Coefficients low = f, high = f;
  filter(low, {.low = 0, .high = 4}, false);
  filter(high, {.low = 5}, false);
  for (std::size_t k = 0; k < f.values.size(); ++k)
    CHECK(low.values[k] + high.values[k] == f.values[k]);
}
