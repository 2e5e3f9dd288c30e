// Weak scaling of the PETSc module: the system of a map whose size grows with the number of processes, one solve.
//
//     mpirun -n N bench-weak-scaling [thousands of tetrahedra a process]
#include <mpi.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <random>
#include <vector>

#include "cli/distributed/petsc_engine.h"
#include "tests/untangle/tangled_cases.h"
#include "untangle/tetrahedra/foldover_energy.h"

using namespace orbicube;
using namespace orbicube::volume_map;

extern "C" BlockEngine* orbicube_petsc_start();

int main(int argc, char** argv) {
  const std::unique_ptr<BlockEngine> engine(orbicube_petsc_start());
  if (engine == nullptr) return 0;
  int processes = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &processes);
  const double size = 1000 * (argc > 1 ? std::atof(argv[1]) : 60) * processes;
  const auto c = test::twisted(3, static_cast<int>(std::lround(std::cbrt(size / (6 * 3)))), 0.5);
  const base::Host host;
  const auto elements = elements_of(c.tetrahedra, c.rest, 1, host);
  const Variables variables(c.rest, c.fixed, c.ties, host.memory);
  FoldoverEnergy energy(elements, variables, 1, host);
  std::vector<double> values(variables.free());
  energy.linearise(variables.start(), 0, values);
  std::mt19937_64 random(5);
  for (double& entry : values)
    entry = std::uniform_real_distribution<double>(-1, 1)(random);
  std::vector<double> right(energy.matrix().size()), found(right);
  energy.assembly().scatter(values, right);
  for (const double tolerance : {1e-2, 1e-10}) {
    const auto start = std::chrono::steady_clock::now();
    const int steps = engine->solve(energy.matrix(), right, 1000, tolerance, found, host);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::printf("%d processes, %zu tetrahedra, %zu unknowns: tolerance %.0e, %d steps, %.2f s\n", processes,
                c.tetrahedra.size(), variables.free(), tolerance, steps, seconds);
  }
}
