// Run by mpirun on two processes: the results of PETSc's conjugate gradients against a direct solver's.
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "base/error.h"
#include "cli/distributed/petsc_engine.h"
#include "tests/untangle/tangled_cases.h"
#include "untangle/tetrahedra/foldover_energy.h"

using namespace orbicube;
using namespace orbicube::untangle;

extern "C" BlockEngine* orbicube_petsc_start();

namespace {

int failures = 0;

void check(bool holds, const std::string& what) {
  std::printf("%s: %s\n", holds ? "ok" : "FAILED", what.c_str());
  failures += !holds;
}

Eigen::SparseMatrix<double> sparse(const BlockMatrix& m) {
  std::vector<Eigen::Triplet<double>> entries;
  const auto add = [&](std::size_t row, std::size_t column, double value) {
    entries.emplace_back(static_cast<int>(row), static_cast<int>(column), value);
    if (row != column) entries.emplace_back(static_cast<int>(column), static_cast<int>(row), value);
  };
  for (std::size_t v = 0; v < m.rows(); ++v) {
    for (std::size_t a = 0; a < 3; ++a) {
      for (std::size_t b = 0; b <= a; ++b)
        add(3 * v + a, 3 * v + b, m.diagonal[v](static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)));
      for (Index i = m.row_begin[v]; i < m.row_begin[v + 1]; ++i) {
        for (std::size_t b = 0; b < 3; ++b)
          add(3 * v + a, 3 * static_cast<std::size_t>(m.column[i]) + b,
              m.lower[i](static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)));
      }
    }
  }
  for (std::size_t s = 0; s < m.shared(); ++s) {
    const std::size_t row = 3 * m.rows() + s;
    add(row, row, m.corner_diagonal[s]);
    for (Index i = m.border_begin[s]; i < m.border_begin[s + 1]; ++i) {
      for (std::size_t a = 0; a < 3; ++a)
        add(row, 3 * static_cast<std::size_t>(m.border_column[i]) + a, m.border[i][static_cast<Eigen::Index>(a)]);
    }
    for (Index i = m.corner_begin[s]; i < m.corner_begin[s + 1]; ++i)
      add(row, 3 * m.rows() + m.corner_column[i], m.corner[i]);
  }
  Eigen::SparseMatrix<double> result(static_cast<Eigen::Index>(m.size()), static_cast<Eigen::Index>(m.size()));
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

void compare(const test::TangledCase& c, BlockEngine& engine) {
  const base::Host host;
  const auto elements = elements_of(c.tetrahedra, c.rest, 1, host);
  const Variables variables(c.start, c.fixed, c.ties, host.memory);
  FoldoverEnergy energy(elements, variables, 1, host);
  std::vector<double> gradient(variables.free());
  energy.linearise(variables.start(), 0.5, gradient);
  std::mt19937_64 random(5);
  for (double& entry : gradient)
    entry = std::uniform_real_distribution<double>(-1, 1)(random);
  const BlockMatrix& matrix = energy.matrix();
  std::vector<double> right(matrix.size()), found(matrix.size());
  energy.assembly().scatter(gradient, right);
  const int steps = engine.solve(matrix, right, 2000, 1e-14, found, host);
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> direct(sparse(matrix));
  const auto size = static_cast<Eigen::Index>(right.size());
  const Eigen::VectorXd wanted = direct.solve(Eigen::Map<const Eigen::VectorXd>(right.data(), size));
  const double error = (Eigen::Map<const Eigen::VectorXd>(found.data(), size) - wanted).norm() / wanted.norm();
  char text[200];
  std::snprintf(text, sizeof text, "%s, %zu unknowns (%zu shared): %d steps, relative difference %.1e", c.name.c_str(),
                variables.free(), variables.free() - variables.own(), steps, error);
  check(steps > 0 && error <= 1e-10, text);
}

}  // namespace

int main() {
  try {
    const std::unique_ptr<BlockEngine> engine(orbicube_petsc_start());
    if (engine == nullptr) return 0;
    compare(test::strewn(2, 8, 0, 1), *engine);
    compare(test::twisted(3, 7, 1), *engine);
    compare(test::polycube_start({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, 7, 0.4, 0.2, 0.3), *engine);
    // A host that cancels stops all processes, and the engine can be used again.
    const test::TangledCase c = test::twisted(3, 7, 1);
    const base::Host quiet;
    const auto elements = elements_of(c.tetrahedra, c.rest, 1, quiet);
    const Variables variables(c.start, c.fixed, c.ties, quiet.memory);
    FoldoverEnergy energy(elements, variables, 1, quiet);
    std::vector<double> gradient(variables.free());
    energy.linearise(variables.start(), 0.5, gradient);
    std::vector<double> right(energy.matrix().size()), found(right);
    energy.assembly().scatter(gradient, right);
    for (const int steps : {0, 3}) {
      base::Host impatient;
      int reports = 0;
      // Hosts are asked at most every 20 ms, and a fast machine is done by then: a host that takes longer than that to
      // callback is called again at the very next step, however fast these are.
      impatient.on_progress = [&](const base::Progress&) {
        std::this_thread::sleep_for(std::chrono::milliseconds(25));
        return reports++ < steps;
      };
      bool cancelled = false;
      try {
        engine->solve(energy.matrix(), right, 2000, 1e-14, found, impatient);
      } catch (const base::Error& error) {
        cancelled = std::string(error.kind()) == "cancelled";
      }
      check(cancelled && reports == steps + 1, "a host that cancels is heard, report " + std::to_string(steps));
    }
    compare(c, *engine);
  } catch (const base::Error& error) {
    check(false, error.what());
  }
  return failures == 0 ? 0 : 1;
}
