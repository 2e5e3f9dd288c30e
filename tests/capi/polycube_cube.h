// A cube as a polycube, and the requirements on every call with a host.
#pragma once

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "failing_allocations.h"

namespace orbicube::test {

// A cube's surface, on a sphere for the surface in space.
inline const std::vector<double> cube = {0, 0, 0, 2, 0, 0, 0, 2, 0, 2, 2, 0, 0, 0, 2, 2, 0, 2, 0, 2, 2, 2, 2, 2};
inline const std::vector<std::uint32_t> triangles = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                                     2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};

inline std::vector<double> sphere() {
  std::vector<double> result = cube;
  for (double& x : result)
    x = (x - 1) / std::sqrt(3.0);
  return result;
}

// Each allocation fails and each report cancels, in turn.
inline void check_every_end(const Call& call, std::size_t each_until = SIZE_MAX) {
  const Outcome memory = fail_each_allocation(call, each_until);
  CHECK(memory.problem == "");
  CHECK(memory.runs > 10);
  const Outcome cancelled = cancel_everywhere(call);
  CHECK(cancelled.problem == "");
  CHECK(cancelled.runs > 3);
}

}  // namespace orbicube::test
