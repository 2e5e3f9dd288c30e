#include "base/random.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>

using orbicube::base::Random;
using orbicube::base::unit_interval;

TEST_CASE("The generator has the numbers that its authors publish") {
  Random random(1234567);
  for (const std::uint64_t known :
       {6457827717110365317U, 3203168211198807973U, 9817491932198370423U, 4593380528125082431U, 16408922859458223821U})
    CHECK(random.next() == known);
  CHECK(Random(0).next() == 0xe220a8397b1dcdafU);
}

TEST_CASE("Words become multiples of 2^-53 below 1") {
  CHECK(unit_interval(0) == 0);
  CHECK(unit_interval(~std::uint64_t{0}) == 1 - 0x1p-53);
  CHECK(unit_interval(std::uint64_t{1} << 63U) == 0.5);
  CHECK(unit_interval(0x7ff) == 0);
}

TEST_CASE("Numbers spread evenly over their range") {
  Random random(3);
  constexpr int count = 100000;
  std::array<int, 7> hits{};
  double sum = 0, squares = 0;
  for (int i = 0; i < count; ++i) {
    ++hits[random.below(hits.size())];
    const double u = random.unit();
    REQUIRE(u >= 0);
    REQUIRE(u < 1);
    sum += u;
    squares += u * u;
  }
  CHECK(std::abs(sum / count - 0.5) < 0.005);
  CHECK(std::abs(squares / count - 1.0 / 3) < 0.005);
  for (const int n : hits)
    CHECK(std::abs(n - count / 7) < 500);
}
