// The map of a made solid to its polycube in growing numbers of tetrahedra.
//
//     bench-large-solids [thousands of tetrahedra ...]
#include <sys/resource.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "tests/volume_map/block_solid.h"
#include "volume_map/solid/solid_map.h"

using namespace orbicube;
using namespace orbicube::volume_map;

int main(int argc, char** argv) {
  std::vector<double> sizes = {60, 125, 250, 500, 1000};
  if (argc > 1) {
    sizes.clear();
    for (int i = 1; i < argc; ++i)
      sizes.push_back(std::atof(argv[i]));
  }
  std::printf("%8s %9s %6s %10s %8s %8s\n", "tets", "inverted", "steps", "seconds", "us/tet", "MB");
  for (const double size : sizes) {
    const int n = static_cast<int>(std::lround(std::cbrt(1000 * size / (6 * 3))));
    const test::BlockSolid solid(test::angle, n, 0.8, 0.4);
    const std::clock_t start = std::clock();
    const SolidMap map = map_solid(solid.map, solid.map.polycube, solid.positions, solid.tetrahedra, {}, base::Host());
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    rusage used;
    getrusage(RUSAGE_SELF, &used);
    std::printf("%8zu %9zu %6zu %10.1f %8.1f %8.0f\n", map.tetrahedra.size(), map.inverted_at_start, map.steps, seconds,
                1e6 * seconds / static_cast<double>(map.tetrahedra.size()), static_cast<double>(used.ru_maxrss) / 1024);
    std::fflush(stdout);
  }
}
