// What a line search makes of values that contradict their slopes.
#include "base/line_search.h"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <utility>

using orbicube::base::Search;
using orbicube::base::WolfeSearch;

namespace {

using Function = std::function<std::pair<double, double>(double length)>;  // value and slope

struct End {
  Search verdict;
  std::uint64_t trials;
  double length;
};

End search(double value, double slope, const Function& f, double max_rise = std::numeric_limits<double>::infinity()) {
  WolfeSearch search;
  search.start(value, value, slope, std::numeric_limits<double>::infinity());
  search.max_rise = max_rise;
  for (;;) {
    const double length = search.length;
    const auto [there, falls] = f(length);
    const Search verdict = search.advance(there, falls);
    if (verdict != Search::again) return {verdict, search.trials, length};
    REQUIRE(search.trials < 100);
  }
}

// Between 1 and 3, and another one at any other length.
double rough(double length) {
  const double product = 0.754877666 * std::fmod(1e6 * std::log(length), 1e3);
  return 1 + 2 * (product - std::floor(product));
}

}  // namespace

TEST_CASE("A gradient that f rises along is given up after few trials, whatever its size and the curvature of f") {
  for (const double size : {1e-9, 1e-3, 1.0, 1e6}) {
    for (const double rise : {1e-2, 1.0, 1e3}) {
      for (const double curvature : {0.0, 1.0, 10.0}) {
        const End end =
            search(2, -size, [&](double t) { return std::pair(2 + rise * size * (t + curvature * t * t), -size); });
        CHECK(end.verdict == Search::give_up);
        CHECK(end.trials <= 10);
      }
    }
  }
}

TEST_CASE("Where noise of f hides how it falls, the search goes by its slopes") {
  for (const double noise : {5e-12, 1e-10, 1e-6}) {
    // f falls by a hundredth of its noise over a length of 1, and its slope flattens by a tenth over 100.
    const End end = search(2, -1e-2 * noise,
                           [&](double t) { return std::pair(2 + noise * rough(t), -1e-2 * noise * (1 - 1e-3 * t)); });
    CHECK(end.verdict == Search::accept);
    CHECK(end.trials <= 6);
    CHECK(end.length >= 100);
    CHECK(end.length <= 1000);
  }
}

TEST_CASE("A minimum along the direction is found under a little noise") {
  const End end =
      search(2, -1, [](double t) { return std::pair(2 - t + 50 * t * t + 1e-11 * rough(t), -1 + 100 * t); });
  CHECK(end.verdict == Search::accept);
  CHECK(end.trials <= 4);
  CHECK(end.length == doctest::Approx(0.01).epsilon(0.9));
}

TEST_CASE("Where the slope may rise by little only, a steep end takes another trial to the minimum") {
  const Function parabola = [](double t) { return std::pair((t - 0.52) * (t - 0.52), 2 * (t - 0.52)); };
  const auto [value, slope] = parabola(0);
  const End weak = search(value, slope, parabola);
  CHECK(weak.verdict == Search::accept);
  CHECK(weak.length == 1);
  const End strong = search(value, slope, parabola, 0.9);
  CHECK(strong.verdict == Search::accept);
  CHECK(strong.trials == 2);
  CHECK(strong.length == doctest::Approx(0.52).epsilon(1e-14));
  // Slopes that never flatten, of a kink, end the search all the same, at a lower value.
  const End kink = search(
      1, -1, [](double t) { return t < 0.9 ? std::pair(1 - t, -1.0) : std::pair(t - 0.8, 1.0); }, 0.5);
  CHECK(kink.verdict == Search::accept);
  CHECK(kink.trials <= 10);
}
