// Engines of linear systems side by side, on systems of real meshes.
//
//   bench-linear FILES     a row for each engine and system; files of triangles and of tetrahedra
//
// A mesh of triangles gives the matrix of a harmonic map (edges weigh alike, plus 1e-6 of the diagonal), as polycubes
// have it; one of tetrahedra gives the same matrix of its edges, as maps along frames have it, and one of 3 x 3 blocks,
// springs with a little resistance across, as volume maps have it.
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "base/error.h"
#include "bench/linear/systems.h"
#include "bench/measuring.h"
#include "linear/direct/direct_factor.h"
#include "linear/iterative/iterative_solver.h"
#include "mesh/files/read.h"
#ifdef ORBICUBE_WITH_CHOLMOD
#include "linear/direct/cholmod_factor.h"
#endif

using namespace orbicube;
using namespace orbicube::linear;
using bench::cpu_seconds;
using bench::Edges;
using bench::random_right;
using bench::residual_of;
using bench::System;
using bench::system_of;

namespace {

template <class Cells>
Edges edges_of(const Cells& cells) {
  Edges edges;
  for (const auto& cell : cells) {
    for (std::size_t i = 0; i < cell.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j)
        edges.emplace_back(std::max(cell[i], cell[j]), std::min(cell[i], cell[j]));
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

void direct_row(const System& system, const char* engine, DirectMethod method, const std::vector<double>& right) {
  Array<int> place;
  const SparseMatrix matrix = by_columns(system.view(), place);
  std::vector<double> x(right.size());
  const double start = cpu_seconds();
  const auto factor = make_direct_factor(method);
  factor->analyze(matrix);
  const double analyzed = cpu_seconds();
  const bool done = factor->factorize(matrix);
  const double factorized = cpu_seconds();
  if (done) factor->solve(right, 1, x);
  const double solved = cpu_seconds();
  std::printf("  %-22s %8.3f %8.3f %8.3f %8.3f %9.1e %12zu %6.0f\n", engine, analyzed - start, factorized - analyzed,
              solved - factorized, solved - start, done ? residual_of(system, right, x) : NAN, factor->entries(),
              factor->operations_per_entry());
  std::fflush(stdout);
}

void iterative_row(const System& system, const char* engine, IterativeMethod method, double tolerance,
                   const std::vector<double>& right, const base::Host& host) {
  std::vector<double> x(right.size());
  const double start = cpu_seconds();
  const auto solver = make_iterative_solver(system.view(), system.block, method, host);
  const double made = cpu_seconds();
  const IterativeReport report = solver->solve(right, {tolerance, 2000}, x);
  const double solved = cpu_seconds();
  std::printf("  %-14s %.0e %8.3f %8s %8.3f %8.3f %9.1e %8d steps\n", engine, tolerance, made - start, "",
              solved - made, solved - start, residual_of(system, right, x), report.iterations);
  std::fflush(stdout);
}

void rows(const System& system, const base::Host& host) {
  const std::vector<double> right = random_right(system);
  std::printf("%s: %zu unknowns, %zu entries\n", system.name.c_str(), right.size(), system.columns.size());
  std::printf("  %-22s %8s %8s %8s %8s %9s %12s %6s\n", "", "analyze", "factor", "solve", "sum, s", "residual",
              "entries of L", "ops");
  direct_row(system, "Eigen", DirectMethod::eigen, right);
  if (has_cholmod()) {
    direct_row(system, "automatic", DirectMethod::automatic, right);
    direct_row(system, "CHOLMOD simplicial", DirectMethod::cholmod_simplicial, right);
    direct_row(system, "CHOLMOD supernodal", DirectMethod::cholmod_supernodal, right);
  }
  for (const double tolerance : {1e-2, 1e-8}) {
    iterative_row(system, "Gauss-Seidel", IterativeMethod::gauss_seidel, tolerance, right, host);
    iterative_row(system, "multigrid", IterativeMethod::multigrid, tolerance, right, host);
  }
}

}  // namespace

int main(int argc, char** argv) {
#ifdef ORBICUBE_WITH_CHOLMOD
  provide_cholmod(&make_cholmod_factor);
#endif
  const base::Host host;
  const auto laplacian = [](Index, Index) { return Eigen::Matrix3d(Eigen::Matrix3d::Identity()); };
  for (int i = 1; i < argc; ++i) {
    const std::string path = argv[i], name = path.substr(path.find_last_of('/') + 1);
    try {
      const mesh::Mesh m = mesh::read_mesh(path, {}, host);
      const std::size_t vertices = m.positions.size();
      if (m.tetrahedra.empty()) {
        rows(system_of(name + ", harmonic map", 1, vertices, edges_of(m.triangles), laplacian), host);
        continue;
      }
      const Edges edges = edges_of(m.tetrahedra);
      rows(system_of(name + ", harmonic", 1, vertices, edges, laplacian), host);
      rows(system_of(name + ", springs in blocks", 3, vertices, edges,
                     [&](Index a, Index b) {
                       const Eigen::Vector3d along = (m.positions[a] - m.positions[b]).normalized();
                       return Eigen::Matrix3d(along * along.transpose() + 0.1 * Eigen::Matrix3d::Identity());
                     }),
           host);
    } catch (const base::Error& error) {
      std::printf("%s: %s: %s\n", name.c_str(), error.kind(), error.what());
    }
  }
  return 0;
}
