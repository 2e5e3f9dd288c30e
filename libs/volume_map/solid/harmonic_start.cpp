#include "volume_map/solid/harmonic_start.h"

#include "untangle/tetrahedra/block_assembly.h"

namespace orbicube::volume_map {

void make_harmonic(std::span<const untangle::Element> elements, std::span<const std::uint8_t> held,
                   std::span<Vector3> positions, const base::Host& host, untangle::BlockEngine* engine) {
  constexpr int max_steps = 1000;
  constexpr double tolerance = 1e-8;
  Array<std::uint8_t> fixed(3 * positions.size(), host.memory);
  for (std::size_t i = 0; i < fixed.size(); ++i)
    fixed[i] = held[i / 3];
  const untangle::Variables variables(positions, fixed, {}, host.memory);
  if (variables.free() == 0) return;
  untangle::BlockAssembly assembly(elements, variables, host);
  untangle::BlockMatrix& matrix = assembly.matrix();
  for (Eigen::Matrix3d& block : matrix.diagonal)
    block.setZero();
  Array<double> right(matrix.size(), 0, host.memory), change(right, host.memory);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (i % 16384 == 0) host.report("start", 0, 0);
    const untangle::Element& e = elements[i];
    const Eigen::Matrix3d j = e.weight * e.jacobian(positions);
    for (std::size_t k = 0; k < 4; ++k) {
      matrix.diagonal[e.corner[k]].diagonal().array() += e.weight * e.gradient[k].squaredNorm();
      for (std::size_t l = 0; l < k; ++l) {
        const Index place = assembly.place(i, k, l);
        if (place != no_index) matrix.lower[place].diagonal().array() += e.weight * e.gradient[k].dot(e.gradient[l]);
      }
      if (held[e.corner[k]] == 0)
        Eigen::Map<Vector3>(&right[3 * static_cast<std::size_t>(e.corner[k])]) -= j * e.gradient[k];
    }
  }
  assembly.finish(base::ThreadPool(host));
  untangle::BlockSolver solver(host);
  solver.set_engine(engine);
  solver.factor(matrix);
  solver.solve(right, max_steps, tolerance, change);
  for (std::size_t v = 0; v < positions.size(); ++v)
    positions[v] += Eigen::Map<const Vector3>(&change[3 * v]);
}

}  // namespace orbicube::volume_map
