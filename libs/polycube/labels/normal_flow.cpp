#include "polycube/labels/normal_flow.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "linear/sparse_system.h"

namespace orbicube::polycube {

void flow(const Surface& surface, double time, int steps, std::span<Vector3> positions, const base::Host& host) {
  const std::size_t count = positions.size();
  const auto half_edges = static_cast<Index>(3 * surface.triangles.size());
  // The Laplacian is that of the surface at the start; only masses change.
  Array<double> weights(half_edges, host.memory);
  linear::SparseSystem::Triplets triplets(host.memory);
  triplets.reserve(half_edges + count);
  for (Index h = 0; h < half_edges; ++h) {
    const Index a = surface.start(h), b = surface.end(h), c = surface.end(mesh::Connectivity::next(h));
    weights[h] =
        std::clamp(0.5 * cotangent(surface.positions[c], surface.positions[a], surface.positions[b]), 1e-3, 30.0);
    triplets.emplace_back(static_cast<int>(std::max(a, b)), static_cast<int>(std::min(a, b)), 0.0);
  }
  linear::SparseSystem system(count, triplets);
  Array<double> mass(count, host.memory);
  Eigen::MatrixXd right(static_cast<Eigen::Index>(count), 3);
  for (int s = 0; s < steps; ++s, time *= 2) {
    host.report("normals", static_cast<std::uint64_t>(s), static_cast<std::uint64_t>(steps));
    std::fill(mass.begin(), mass.end(), 0.0);
    double area = 0;
    const auto area_of = [&](const Triangle& t) {
      return 0.5 * (positions[t[1]] - positions[t[0]]).cross(positions[t[2]] - positions[t[0]]).norm();
    };
    for (const Triangle& t : surface.triangles) {
      const double a = area_of(t);
      area += a;
      for (const Index v : t)
        mass[v] += a / 3;
    }
    std::fill_n(system.values(), system.value_count(), 0.0);
    for (Index h = 0; h < half_edges; ++h) {
      const Index a = surface.start(h), b = surface.end(h);
      system.values()[system.place(std::max(a, b), std::min(a, b))] -= time * weights[h];
      system.values()[system.place(a, a)] += time * weights[h];
      system.values()[system.place(b, b)] += time * weights[h];
    }
    for (Index v = 0; v < count; ++v) {
      const double m = mass[v] / area;
      system.values()[system.place(v, v)] += m + 1e-12;
      right.row(v) = m * positions[v].transpose();
    }
    if (!system.factorize()) throw base::Error("no-valid-result", "the flow of the surface could not be computed");
    Vector3 centre = Vector3::Zero();
    for (Eigen::Index k = 0; k < 3; ++k) {
      const Eigen::VectorXd x = system.solve(right.col(k));
      for (std::size_t v = 0; v < count; ++v)
        positions[v][k] = x[static_cast<Eigen::Index>(v)];
    }
    for (std::size_t v = 0; v < count; ++v)
      centre += mass[v] / area * positions[v];
    double reached = 0;
    for (const Triangle& t : surface.triangles)
      reached += area_of(t);
    const double scale = reached > 0 ? std::sqrt(area / reached) : 1;
    for (Vector3& p : positions)
      p = scale * (p - centre);
  }
}

}  // namespace orbicube::polycube
