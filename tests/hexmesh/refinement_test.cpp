// How many cells follow a mesh that is too far from the surface.
#include <doctest/doctest.h>

#include <cstddef>

#include "hexmesh/strategies/refinement.h"

using orbicube::hexmesh::may_be_near;
using orbicube::hexmesh::Refinement;

TEST_CASE("The farther a mesh is from the surface, the more cells the next one has") {
  const auto next = [](double excess, std::size_t max_cells) {
    Refinement refinement(1000, max_cells);
    return refinement.next(excess, excess) ? refinement.cells() : 0;
  };
  for (const double excess : {0.0, 1.0, 1.5, 2.5})
    CHECK(next(excess, 100'000) == 2000);
  CHECK(next(2.6, 100'000) == 4000);
  CHECK(next(4, 100'000) == 8000);
  CHECK(next(1e9, 100'000) == 8000);
  CHECK(next(1e9, 7999) == 4000);
  CHECK(next(1e9, 2000) == 2000);
  CHECK(next(1e9, 1999) == 0);
}

TEST_CASE("More cells follow while they help so much that the maximum may do") {
  Refinement by_length(1000, 100'000);
  double excess = 2;
  for (const std::size_t cells : {2000U, 4000U, 8000U}) {
    REQUIRE(by_length.next(excess, excess));
    CHECK(by_length.cells() == cells);
    excess /= 1.25;
  }

  Refinement stays(1000, 100'000);
  CHECK(stays.next(2, 2));
  CHECK(stays.next(2, 2));
  CHECK_FALSE(stays.next(2, 2));
  Refinement slow(1000, 100'000);
  CHECK(slow.next(2, 2));
  CHECK(slow.next(1.95, 1.95));
  CHECK_FALSE(slow.next(1.9, 1.9));
  Refinement changes(1000, 100'000);
  CHECK(changes.next(2, 2));
  CHECK(changes.next(2, 2));
  changes.forget();
  CHECK(changes.next(4, 2));
  CHECK(changes.next(4, 2));
  CHECK(changes.cells() == 16000);

  // Where there was no mesh the next one has twice as many.
  Refinement none(1000, 100'000);
  CHECK(none.next(0, 0));
  CHECK(none.next(3, 3));
  CHECK(none.cells() == 8000);
}

TEST_CASE("A mesh may be near where the square of the length of its cells is as small as that takes") {
  CHECK(may_be_near({0, 0}, 100));
  CHECK(may_be_near({1000, 1}, 1000));
  CHECK(may_be_near({1000, 4}, 8000));
  CHECK_FALSE(may_be_near({1000, 4}, 7900));
}
