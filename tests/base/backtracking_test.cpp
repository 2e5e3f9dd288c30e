#include "base/backtracking.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <vector>

using orbicube::base::backtrack;
using orbicube::base::Backtracking;

TEST_CASE("The accepted step fulfills Armijo's condition, and no longer one that was tried does") {
  for (const double steepness : {1.0, 30.0, 1e4}) {
    for (const double factor : {0.4, 0.5, 0.9}) {
      const Backtracking rule{.factor = factor, .max_trials = 200};
      std::vector<double> lengths, values;
      const auto value_at = [&](double t) {
        lengths.push_back(t);
        values.push_back(3 - t + steepness * t * t);
        return values.back();
      };
      const auto step = backtrack(3, -1, rule, value_at);
      REQUIRE(step);
      CHECK(step->trials == static_cast<int>(lengths.size()));
      CHECK(step->length == lengths.back());
      CHECK(step->value == values.back());
      CHECK(lengths.front() == rule.first_length);
      for (std::size_t i = 0; i < lengths.size(); ++i) {
        CHECK((values[i] <= 3 - rule.decrease * lengths[i]) == (i + 1 == lengths.size()));
        if (i > 0) CHECK(lengths[i] == lengths[i - 1] * factor);
      }
    }
  }
}

TEST_CASE("A function that does not fall, and one that is not a number, is given up after the maximum of trials") {
  for (const double value : {2.0, std::numeric_limits<double>::infinity(), std::nan("")}) {
    int trials = 0;
    const auto step = backtrack(1, -1, {.max_trials = 7}, [&](double) {
      ++trials;
      return value;
    });
    CHECK(!step);
    CHECK(trials == 7);
  }
}

TEST_CASE("Only steps that are allowed are accepted, and only those that fall are checked") {
  double last = 0;
  int checks = 0;
  const auto step = backtrack(
      0, -1, {},
      [&](double t) {
        last = t;
        return t > 0.5 ? 1 : -t;
      },
      [&] {
        ++checks;
        return last < 0.2;
      });
  REQUIRE(step);
  CHECK(step->length == 0.125);
  CHECK(checks == 3);
  CHECK(!backtrack(
      0, -1, {}, [](double t) { return -t; }, [] { return false; }));
}

TEST_CASE("A strict rule without sufficient decrease accepts every lower value, and no equal one") {
  const Backtracking rule{.max_trials = 3, .decrease = 0, .strict = true};
  CHECK(!backtrack(1, -1, rule, [](double) { return 1.0; }));
  CHECK(backtrack(1, -1, rule, [](double) { return std::nextafter(1.0, 0.0); }));
  CHECK(backtrack(1, -1, {.decrease = 0}, [](double) { return 1.0; }));
}
