// A thousand meshes of 100 to 5000 elements whose fixed boundary is known to allow positive elements, a hundred of each
// family, untangled with one setting. A row a family: solved cases, as exact signs of the result say that are computed
// here, steps, and seconds of all processors. Cases that fail are listed with their seed.
//
//     bench-untangle-cases [cases of each family [first seed [family, 0 to 9]]]
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "tests/untangle/feasible_flat.h"
#include "tests/untangle/feasible_solid.h"
#include "untangle/refine/refined.h"

using namespace orbicube;
using namespace orbicube::untangle;

namespace {

struct Row {
  std::size_t cases = 0, solved = 0, refined = 0, min_elements = 1000000, max_elements = 0, steps = 0;
  double seconds = 0, slowest = 0, growth = 1;  // of the number of elements, by splits
};

bool is_positive(const Array<Triangle>& triangles, const Array<Vector2d>& p) {
  for (const Triangle& t : triangles)
    if (mesh::orientation_2d(p[t[0]], p[t[1]], p[t[2]]) <= 0) return false;
  return true;
}

bool is_positive(const Array<Tetrahedron>& tetrahedra, const Array<Vector3>& p) {
  for (const Tetrahedron& t : tetrahedra)
    if (mesh::orientation_3d(p[t[0]], p[t[1]], p[t[2]], p[t[3]]) <= 0) return false;
  return true;
}

// Whether fixed vertices have their bits.
template <class Case, class Positions>
bool keeps_fixed(const Case& c, const Positions& positions, std::size_t axes) {
  for (std::size_t v = 0; v < c.start.size(); ++v)
    if (c.fixed[axes * v] != 0 && positions[v] != c.start[v]) return false;
  return true;
}

// Runs a case and adds it to its row.
template <class Case, class Solve>
void measure(const Case& c, std::size_t axes, std::size_t seed, const Solve& solve, Row& row) {
  const std::clock_t start = std::clock();
  const auto result = solve();
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  const bool solved = is_positive(result.elements, result.positions) && keeps_fixed(c, result.positions, axes);
  const std::size_t count =
      result.parents.empty() ? 0 : 1 + *std::max_element(result.parents.begin(), result.parents.end());
  ++row.cases;
  row.refined += result.rounds > 0;
  row.growth = std::max(row.growth, static_cast<double>(result.elements.size()) / static_cast<double>(count));
  row.solved += solved;
  row.min_elements = std::min(row.min_elements, count);
  row.max_elements = std::max(row.max_elements, count);
  row.steps += result.steps;
  row.seconds += seconds;
  row.slowest = std::max(row.slowest, seconds);
  if (!solved) {
    std::printf("  not solved: %s %zu, %zu elements, %zu of %zu inverted, %zu rounds to %zu elements, %.2f s\n",
                c.name.c_str(), seed, count, result.inverted, result.inverted_before, result.rounds,
                result.elements.size(), seconds);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t count = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 100;
  const std::size_t first = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 0;
  const std::size_t only = argc > 3 ? std::strtoul(argv[3], nullptr, 10) : no_index;
  std::size_t solved = 0, cases = 0;
  const base::Host host;
  std::printf("| family | solved | elements | split | maximum growth | steps, mean | seconds, all | slowest |\n");
  std::printf("|---|---|---|---|---|---|---|---|\n");
  for (std::size_t family = 0; family < test::flat_family_count + test::solid_family_count; ++family) {
    if (only != no_index && family != only) continue;
    Row row;
    const bool flat = family < test::flat_family_count;
    for (std::size_t seed = first; seed < first + count; ++seed) {
      if (flat) {
        const auto c = test::feasible_flat(family, seed);
        measure(
            c, 2, seed, [&] { return untangle_refined(c.mesh(), {}, host); }, row);
      } else {
        const auto c = test::feasible_solid(family - test::flat_family_count, seed);
        measure(
            c, 3, seed, [&] { return untangle_refined(c.mesh(), {}, host); }, row);
      }
    }
    const char* name = flat ? test::flat_families[family] : test::solid_families[family - test::flat_family_count];
    std::printf("| %s, %s | %zu of %zu | %zu to %zu | %zu | %.2f | %.0f | %.1f | %.2f |\n", flat ? "2D" : "3D", name,
                row.solved, row.cases, row.min_elements, row.max_elements, row.refined, row.growth,
                static_cast<double>(row.steps) / static_cast<double>(row.cases), row.seconds, row.slowest);
    std::fflush(stdout);
    solved += row.solved;
    cases += row.cases;
  }
  std::printf("%zu of %zu solved\n", solved, cases);
  return solved == cases ? 0 : 1;
}
