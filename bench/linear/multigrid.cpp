// Multigrid of the library beside GAMG of PETSc and BoomerAMG of hypre, on six generated systems; each preconditions
// conjugate gradients, which end at a residual of 1e-8.
//
//     bench-linear-multigrid [FOLDER [SIZE]]    with FOLDER the systems are written there, for peers in Python
//
// A line for each engine and system, with tabs: system, unknowns, entries of the whole matrix, engine, seconds of the
// processor for setup and solution, iterations, the residual, and whether two threads give the same bits. SIZE scales
// the edges of the grids, 1 by default. bench/linear/multigrid.py writes docs/linear_tables.md with it.
#include <Eigen/Geometry>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "base/random.h"
#include "bench/linear/systems.h"
#include "bench/measuring.h"
#include "linear/iterative/iterative_solver.h"
#ifdef ORBICUBE_WITH_PETSC
#include <petscksp.h>
#endif

using namespace orbicube;
using bench::cpu_seconds;
using bench::Edges;
using bench::System;
using bench::system_of;
using linear::Index;

namespace {

constexpr double tolerance = 1e-8;

Eigen::Matrix3d same(double weight) {
  return weight * Eigen::Matrix3d::Identity();
}

// A grid of nx * ny * nz vertices with a weight for each edge, and zero around it.
System grid(const std::string& name, Index nx, Index ny, Index nz, const std::function<double(Index, Index)>& weight) {
  const std::array<Index, 3> size = {nx, ny, nz}, step = {1, nx, nx * ny};
  const std::size_t count = static_cast<std::size_t>(nx) * ny * nz;
  Edges edges;
  std::vector<double> fixed(count, 0);
  for (Index v = 0; v < count; ++v) {
    for (std::size_t a = 0; a < 3; ++a) {
      if (size[a] == 1) continue;
      const Index at = v / step[a] % size[a];
      if (at > 0)
        edges.emplace_back(v, v - step[a]);
      else
        fixed[v] += weight(v, v + step[a]);
      if (at + 1 == size[a]) fixed[v] += weight(v, v - step[a]);
    }
  }
  std::sort(edges.begin(), edges.end());
  return system_of(
      name, 1, count, edges, [&](Index i, Index j) { return same(weight(i, j)); }, fixed);
}

// Coefficients of 1e-3 to 1e3, one for each block of 8^3 vertices; an edge has the harmonic mean of those at its ends.
System jumps(Index n) {
  base::Random random(3);
  const Index blocks = n / 8 + 1;
  std::vector<double> coefficient;
  for (Index i = 0; i < blocks * blocks * blocks; ++i)
    coefficient.push_back(std::pow(10, 6 * random.unit() - 3));
  const auto at = [&](Index v) { return coefficient[(v / (n * n) / 8 * blocks + v / n % n / 8) * blocks + v % n / 8]; };
  return grid("3D, jumps of up to 1e6", n, n, n, [&](Index i, Index j) { return 2 / (1 / at(i) + 1 / at(j)); });
}

// Edges of a square of triangles, in any order of vertices, that weigh alike: as harmonic maps to polycubes have them.
System harmonic_map(Index n) {
  base::Random random(5);
  std::vector<Index> number(static_cast<std::size_t>(n) * n);
  for (Index v = 0; v < number.size(); ++v) {
    number[v] = v;
    std::swap(number[v], number[random.below(v + std::size_t{1})]);
  }
  Edges edges;
  const auto add = [&](Index v, Index w) {
    edges.emplace_back(std::max(number[v], number[w]), std::min(number[v], number[w]));
  };
  for (Index v = 0; v < number.size(); ++v) {
    const bool right = v % n + 1 < n, up = v / n + 1 < n;
    if (right) add(v, v + 1);
    if (up) add(v, v + n);
    if (!right || !up) continue;
    if (random.below(2) == 0)
      add(v, v + n + 1);
    else
      add(v + 1, v + n);
  }
  std::sort(edges.begin(), edges.end());
  return system_of("triangles, harmonic map", 1, number.size(), edges, [](Index, Index) { return same(1); });
}

// Springs with a little resistance across on the edges of tetrahedra of a box: as volume maps have them.
System springs(Index n) {
  base::Random random(7);
  std::vector<Eigen::Vector3d> positions;
  for (Index v = 0; v < n * n * n; ++v) {
    positions.emplace_back(v % n, v / n % n, v / (n * n));
    for (Eigen::Index a = 0; a < 3; ++a)
      positions.back()[a] += 0.4 * (random.unit() - 0.5);
  }
  Edges edges;
  for (Index v = 0; v < positions.size(); ++v) {
    for (Index direction = 1; direction < 8; ++direction) {
      const Index x = direction & 1U, y = direction >> 1U & 1U, z = direction >> 2U;
      if (v % n + x < n && v / n % n + y < n && v / (n * n) + z < n) edges.emplace_back(v + x + n * (y + n * z), v);
    }
  }
  std::sort(edges.begin(), edges.end());
  return system_of("tetrahedra, springs in 3 x 3 blocks", 3, positions.size(), edges, [&](Index i, Index j) {
    const Eigen::Vector3d along = (positions[i] - positions[j]).normalized();
    return Eigen::Matrix3d(along * along.transpose() + 0.1 * Eigen::Matrix3d::Identity());
  });
}

// Both halves of a matrix by rows.
struct Whole {
  std::vector<int> begin, column;
  std::vector<double> value;

  explicit Whole(const System& s) : begin(s.row_begin.size(), 0) {
    const std::size_t n = s.row_begin.size() - 1;
    const auto each = [&](const auto& visit) {
      for (std::size_t row = 0; row < n; ++row) {
        for (std::size_t i = s.row_begin[row]; i < s.row_begin[row + 1]; ++i) {
          visit(row, s.columns[i], s.values[i]);
          if (s.columns[i] != row) visit(s.columns[i], static_cast<Index>(row), s.values[i]);
        }
      }
    };
    each([&](std::size_t row, Index, double) { ++begin[row + 1]; });
    for (std::size_t row = 0; row < n; ++row)
      begin[row + 1] += begin[row];
    std::vector<int> at(begin.begin(), begin.end() - 1);
    column.resize(static_cast<std::size_t>(begin.back()));
    value.resize(column.size());
    each([&](std::size_t row, Index c, double entry) {
      const auto place = static_cast<std::size_t>(at[row]++);
      column[place] = static_cast<int>(c);
      value[place] = entry;
    });
  }
};

template <class Number>
void write(std::ofstream& file, const std::vector<Number>& numbers) {
  file.write(reinterpret_cast<const char*>(numbers.data()),
             static_cast<std::streamsize>(numbers.size() * sizeof(Number)));
}

// Rows, entries and the block, then begins and columns of 32 bits, values, and the right side.
void write_system(const std::string& path, const System& s, const Whole& whole, const std::vector<double>& right) {
  std::ofstream file(path, std::ios::binary);
  write<std::int64_t>(file, {static_cast<std::int64_t>(right.size()), static_cast<std::int64_t>(whole.column.size()),
                             static_cast<std::int64_t>(s.block)});
  write(file, whole.begin);
  write(file, whole.column);
  write(file, whole.value);
  write(file, right);
}

struct Solution {
  double setup = 0, solve = 0;
  int iterations = 0;
  std::vector<double> x;
};

Solution ours(const System& s, const std::vector<double>& right, unsigned threads) {
  base::Host host;
  host.thread_count = threads;
  Solution result;
  result.x.resize(right.size());
  const double start = cpu_seconds();
  const auto solver = make_iterative_solver(s.view(), s.block, linear::IterativeMethod::multigrid, host);
  const double made = cpu_seconds();
  result.iterations = solver->solve(right, {tolerance, 2000}, result.x).iterations;
  result.setup = made - start;
  result.solve = cpu_seconds() - made;
  return result;
}

#ifdef ORBICUBE_WITH_PETSC
void check(PetscErrorCode code) {
  if (code == 0) return;
  std::fprintf(stderr, "PETSc failed, error %d\n", static_cast<int>(code));
  std::exit(1);
}

// Conjugate gradients with a preconditioner of PETSc, with its defaults, on one process.
Solution petsc(const System& s, const Whole& whole, const std::vector<double>& right, const char* type) {
  Solution result;
  result.x.resize(right.size());
  const auto n = static_cast<PetscInt>(right.size());
  std::vector<PetscInt> begin(whole.begin.begin(), whole.begin.end()), column(whole.column.begin(), whole.column.end());
  std::vector<double> value = whole.value;
  Mat a = nullptr;
  Vec b = nullptr, x = nullptr;
  KSP ksp = nullptr;
  PC pc = nullptr;
  check(MatCreateSeqAIJWithArrays(PETSC_COMM_SELF, n, n, begin.data(), column.data(), value.data(), &a));
  check(MatSetBlockSize(a, s.block));
  check(MatSetOption(a, MAT_SPD, PETSC_TRUE));
  check(VecCreateSeqWithArray(PETSC_COMM_SELF, 1, n, right.data(), &b));
  check(VecCreateSeqWithArray(PETSC_COMM_SELF, 1, n, result.x.data(), &x));
  const double start = cpu_seconds();
  check(KSPCreate(PETSC_COMM_SELF, &ksp));
  check(KSPSetType(ksp, KSPCG));
  check(KSPSetNormType(ksp, KSP_NORM_UNPRECONDITIONED));
  check(KSPSetTolerances(ksp, tolerance, 0, PETSC_DEFAULT, 2000));
  check(KSPGetPC(ksp, &pc));
  check(PCSetType(pc, type));
  check(KSPSetOperators(ksp, a, a));
  check(KSPSetUp(ksp));
  const double made = cpu_seconds();
  check(KSPSolve(ksp, b, x));
  result.setup = made - start;
  result.solve = cpu_seconds() - made;
  PetscInt iterations = 0;
  check(KSPGetIterationNumber(ksp, &iterations));
  result.iterations = static_cast<int>(iterations);
  check(KSPDestroy(&ksp));
  check(VecDestroy(&x));
  check(VecDestroy(&b));
  check(MatDestroy(&a));
  return result;
}
#endif

void rows(const System& s, const std::string& file) {
  const std::vector<double> right = bench::random_right(s);
  const Whole whole(s);
  if (!file.empty()) write_system(file, s, whole, right);
  const auto row = [&](const char* engine, const Solution& solution, const char* threads) {
    std::printf("%s\t%zu\t%zu\t%s\t%.4f\t%.4f\t%d\t%.1e\t%s\n", s.name.c_str(), right.size(), whole.column.size(),
                engine, solution.setup, solution.solve, solution.iterations, residual_of(s, right, solution.x),
                threads);
    std::fflush(stdout);
  };
  const Solution one = ours(s, right, 1);
  row("orbicube", one, ours(s, right, 2).x == one.x ? "same" : "other");
#ifdef ORBICUBE_WITH_PETSC
  row("GAMG", petsc(s, whole, right, PCGAMG), "");
  row("BoomerAMG", petsc(s, whole, right, PCHYPRE), "");
#endif
}

}  // namespace

int main(int argc, char** argv) {
  const std::string folder = argc > 1 ? argv[1] : "";
  const double size = argc > 2 ? std::strtod(argv[2], nullptr) : 1;
  const auto edge = [&](int n) { return static_cast<Index>(std::max(4.0, std::round(n * size))); };
#ifdef ORBICUBE_WITH_PETSC
  check(PetscInitializeNoArguments());
#endif
  const auto unit = [](Index, Index) { return 1.0; };
  const Index wide = edge(400), deep = edge(48);
  const std::function<System()> systems[] = {
      [&] { return grid("2D, Poisson", wide, wide, 1, unit); },
      [&] {
        return grid("2D, 1000 times stiffer in one direction", wide, wide, 1,
                    [](Index i, Index j) { return i - j == 1 || j - i == 1 ? 1.0 : 1e-3; });
      },
      [&] { return grid("3D, Poisson", deep, deep, deep, unit); },
      [&] { return jumps(deep); },
      [&] { return harmonic_map(wide); },
      [&] { return springs(edge(28)); }};
  int number = 0;
  for (const auto& make : systems)
    rows(make(), folder.empty() ? "" : folder + "/" + std::to_string(number++) + ".system");
#ifdef ORBICUBE_WITH_PETSC
  check(PetscFinalize());
#endif
  return 0;
}
