// A thousand meshes of 100 to 5000 elements whose fixed boundary is known to allow positive elements, a hundred of each
// family, untangled with one setting. A row a family: solved cases, as exact signs of the result say that are computed
// here, those that are solved without splits, those that were split and by how much the largest of them grew, steps,
// and seconds of all processors for the refinement. Cases that fail, or differ with two threads, are listed with their
// seed.
//
//     bench-untangle-cases [cases of each family [first seed [family, 0 to 9]]]
//
// bench/untangle/tables.py writes docs/untangle_tables.md with it.
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
  std::size_t cases = 0, solved = 0, plain = 0, same = 0, refined = 0, min_elements = 1000000, max_elements = 0,
              steps = 0;
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

UntangledTriangles untangle_plain(const TriangleProblem& mesh, const base::Host& host) {
  return untangle_triangles(mesh, {}, host);
}

Untangled untangle_plain(const UntangleProblem& mesh, const base::Host& host) {
  return untangle_tetrahedra(mesh, {}, host);
}

std::span<const Triangle> elements_of(const TriangleProblem& mesh) {
  return mesh.triangles;
}

std::span<const Tetrahedron> elements_of(const UntangleProblem& mesh) {
  return mesh.tetrahedra;
}

// Runs a case and adds it to its row.
template <class Case>
void measure(const Case& c, std::size_t axes, std::size_t seed, Row& row) {
  base::Host one, two;
  one.thread_count = 1;
  two.thread_count = 2;
  const std::clock_t start = std::clock();
  const auto result = untangle_refined(c.mesh(), {}, one);
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  const bool solved = is_positive(result.elements, result.positions) && keeps_fixed(c, result.positions, axes);
  const auto again = untangle_refined(c.mesh(), {}, two);
  const bool same = again.elements == result.elements && again.positions == result.positions;
  const std::size_t count = elements_of(c.mesh()).size();
  row.plain += untangle_plain(c.mesh(), one).inverted == 0;
  row.same += same;
  ++row.cases;
  row.refined += result.rounds > 0;
  row.growth = std::max(row.growth, static_cast<double>(result.elements.size()) / static_cast<double>(count));
  row.solved += solved;
  row.min_elements = std::min(row.min_elements, count);
  row.max_elements = std::max(row.max_elements, count);
  row.steps += result.steps;
  row.seconds += seconds;
  row.slowest = std::max(row.slowest, seconds);
  if (!solved || !same) {
    std::printf("  %s: %s %zu, %zu elements, %zu of %zu inverted, %zu rounds to %zu elements, %.2f s\n",
                solved ? "differs with two threads" : "not solved", c.name.c_str(), seed, count, result.inverted,
                result.inverted_before, result.rounds, result.elements.size(), seconds);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t count = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 100;
  const std::size_t first = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 0;
  const std::size_t only = argc > 3 ? std::strtoul(argv[3], nullptr, 10) : no_index;
  std::size_t solved = 0, plain = 0, same = 0, cases = 0;
  std::printf(
      "| family | solved | without splits | elements | split | maximum growth | steps, mean | seconds, all | slowest "
      "|\n");
  std::printf("|---|---|---|---|---|---|---|---|---|\n");
  for (std::size_t family = 0; family < test::flat_family_count + test::solid_family_count; ++family) {
    if (only != no_index && family != only) continue;
    Row row;
    const bool flat = family < test::flat_family_count;
    for (std::size_t seed = first; seed < first + count; ++seed) {
      if (flat)
        measure(test::feasible_flat(family, seed), 2, seed, row);
      else
        measure(test::feasible_solid(family - test::flat_family_count, seed), 3, seed, row);
    }
    const char* name = flat ? test::flat_families[family] : test::solid_families[family - test::flat_family_count];
    std::printf("| %s, %s | %zu of %zu | %zu | %zu to %zu | %zu | %.2f | %.0f | %.1f | %.2f |\n", flat ? "2D" : "3D",
                name, row.solved, row.cases, row.plain, row.min_elements, row.max_elements, row.refined, row.growth,
                static_cast<double>(row.steps) / static_cast<double>(row.cases), row.seconds, row.slowest);
    std::fflush(stdout);
    solved += row.solved;
    plain += row.plain;
    same += row.same;
    cases += row.cases;
  }
  std::printf("\n%zu of %zu are solved, %zu of them without splits; %zu have the same bits with one and two threads.\n",
              solved, cases, plain, same);
  return solved == cases && same == cases ? 0 : 1;
}
