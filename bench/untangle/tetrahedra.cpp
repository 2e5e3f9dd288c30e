// A hundred inverted meshes of up to 50000 tetrahedra, of four kinds, untangled with one setting: inverted before and
// after by exact signs, steps, and seconds of all processors.
//
//     bench-untangle-tetrahedra [first case [last case]]
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <numbers>
#include <string>
#include <vector>

#include "tests/untangle/tangled_cases.h"
#include "untangle/tetrahedra/untangle_tetrahedra.h"

using namespace orbicube;
using namespace orbicube::untangle;

namespace {

const std::vector<std::vector<test::Block>> solids = {
    {{0, 0, 0}},
    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}},
    {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 1, 0}},
    {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 1, 0}, {0, 2, 0}, {1, 2, 0}, {2, 2, 0}},
    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {2, 1, 1}},
};

// Cases 0 to 99, 25 of each kind, from small to large.
test::TangledCase make(std::size_t number) {
  const std::size_t kind = number / 25, i = number % 25;
  const double t = static_cast<double>(i) / 24;
  // Cubes along a block's edge, so that 6 blocks n^3 comes to at most 50000.
  const auto edge = [&](std::size_t blocks) {
    const double most = std::cbrt(50000 / (6.0 * static_cast<double>(blocks)));
    return static_cast<int>(3 + t * (most - 3));
  };
  if (kind == 0) {
    const std::size_t blocks = 1 + i % 3;
    return test::strewn(static_cast<int>(blocks), edge(blocks), 0.1 + 0.9 * static_cast<double>(i % 4) / 3, i);
  }
  if (kind == 1) {
    const std::size_t blocks = 3 + i % 4;
    return test::folded(static_cast<int>(blocks), edge(blocks), 0.7 + 0.25 * static_cast<double>(i % 5), i % 2 == 1);
  }
  if (kind == 2) {
    const std::size_t blocks = 3 + i % 4;
    return test::twisted(static_cast<int>(blocks), edge(blocks),
                         (0.5 + 0.8 * static_cast<double>(i % 7) / 6) * std::numbers::pi);
  }
  const std::vector<test::Block>& solid = solids[i % solids.size()];
  return test::polycube_start(solid, edge(solid.size()), 0.2 + 0.2 * static_cast<double>(i % 4),
                              0.1 * static_cast<double>(i % 3), 0.15 * static_cast<double>(1 + i % 6));
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t first = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 0;
  const std::size_t last = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 99;
  std::printf("%4s %-9s %8s %8s %8s %6s %6s %10s %8s %8s\n", "case", "kind", "tets", "before", "after", "steps",
              "polish", "min det", "energy", "s");
  std::size_t good = 0, count = 0;
  double slowest = 0;
  for (std::size_t i = first; i <= last && i < 100; ++i) {
    const test::TangledCase c = make(i);
    const std::clock_t start = std::clock();
    const Untangled result = untangle_tetrahedra(c.mesh(), {}, base::Host());
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    std::printf("%4zu %-9s %8zu %8zu %8zu %6zu %6zu %10.3g %8.3f %8.2f\n", i, c.name.c_str(), c.tetrahedra.size(),
                result.inverted_before, result.inverted, result.steps, result.polish_steps, result.min_determinant,
                result.energy, seconds);
    std::fflush(stdout);
    ++count;
    good += result.inverted == 0;
    slowest = std::max(slowest, seconds);
  }
  std::printf("%zu of %zu without inverted tetrahedra, the slowest in %.1f s\n", good, count, slowest);
  return good == count ? 0 : 1;
}
