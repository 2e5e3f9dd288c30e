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
#include <functional>
#include <string>
#include <vector>

#include "base/error.h"
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

namespace {

using Edges = std::vector<std::pair<Index, Index>>;  // the larger vertex first, sorted

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

struct System {
  std::string name;
  int block = 1;
  std::vector<std::size_t> row_begin{0};
  std::vector<Index> columns;
  std::vector<double> values;

  SymmetricMatrix view() const { return {row_begin, columns, values}; }
};

// Blocks of size 1 or 3 on the edges of a mesh; block_of(i, j) is that of an edge, subtracted off the diagonal and
// added to that of both ends.
System system_of(const std::string& name, int block, std::size_t vertices, const Edges& edges,
                 const std::function<Eigen::Matrix3d(Index, Index)>& block_of) {
  constexpr double mass = 1e-6;
  std::vector<Eigen::Matrix3d> diagonal(vertices, Eigen::Matrix3d::Zero());
  for (const auto& [i, j] : edges) {
    const Eigen::Matrix3d b = block_of(i, j);
    diagonal[i] += b;
    diagonal[j] += b;
  }
  System system;
  system.name = name;
  system.block = block;
  auto edge = edges.begin();
  for (Index v = 0; v < vertices; ++v) {
    auto last = edge;
    while (last != edges.end() && last->first == v)
      ++last;
    for (int r = 0; r < block; ++r) {
      for (auto e = edge; e != last; ++e) {
        const Eigen::Matrix3d b = block_of(v, e->second);
        for (int c = 0; c < block; ++c) {
          system.columns.push_back(static_cast<Index>(block) * e->second + static_cast<Index>(c));
          system.values.push_back(-b(r, c));
        }
      }
      for (int c = 0; c <= r; ++c) {
        system.columns.push_back(static_cast<Index>(block) * v + static_cast<Index>(c));
        const double d = diagonal[v](r, c);
        system.values.push_back(r == c ? (d > 0 ? d * (1 + mass) : 1) : d);
      }
      system.row_begin.push_back(system.columns.size());
    }
    edge = last;
  }
  return system;
}

double residual_of(const System& system, const std::vector<double>& right, const std::vector<double>& x) {
  std::vector<double> image(right.size());
  system.view().multiply(x, image);
  double above = 0, below = 0;
  for (std::size_t i = 0; i < right.size(); ++i) {
    above += (right[i] - image[i]) * (right[i] - image[i]);
    below += right[i] * right[i];
  }
  return std::sqrt(above / below);
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
  const std::size_t size = system.row_begin.size() - 1;
  std::vector<double> right(size);
  std::uint64_t state = 1;
  for (double& entry : right) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    entry = static_cast<double>(state >> 11) / 4503599627370496.0 - 1;
  }
  std::printf("%s: %zu unknowns, %zu entries\n", system.name.c_str(), size, system.columns.size());
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
