#include "sphere_map/sampling/sampling.h"

#include <Eigen/Geometry>
#include <cmath>

#include "base/error.h"

namespace orbicube::sphere_map {

void sample(const Locator& locator, std::span<const Vector3> queries, std::span<const double> values,
            std::size_t components, Interpolation interpolation, std::span<double> sampled, const base::Host& host) {
  // Quotients, since products of sizes that come from outside can overflow.
  const auto fits = [&](std::size_t size, std::size_t rows) {
    return components > 0 && size % components == 0 && size / components == rows;
  };
  if (!fits(values.size(), locator.directions().size()))
    throw base::Error("invalid-argument", "values have not `components` numbers a vertex");
  if (!fits(sampled.size(), queries.size()))
    throw base::Error("invalid-argument", "the result has not `components` numbers a query");
  if (interpolation != Interpolation::linear && interpolation != Interpolation::unit)
    throw base::Error("invalid-argument", "unknown interpolation");
  locator.for_each_location(queries, host, [&](std::size_t i, const Location& at) {
    double* to = sampled.data() + i * components;
    std::fill_n(to, components, 0.0);
    for (std::size_t k = 0; k < 3; ++k) {
      const double weight = at.weights[static_cast<Eigen::Index>(k)];
      if (weight == 0) continue;  // what a corner has that does not count may be anything, not a number even
      const double* from = values.data() + components * locator.triangles()[at.triangle][k];
      for (std::size_t c = 0; c < components; ++c)
        to[c] += weight * from[c];
    }
    if (interpolation == Interpolation::unit) {
      Eigen::Map<Eigen::VectorXd> vector(to, static_cast<Eigen::Index>(components));
      vector.stableNormalize();
    }
  });
}

Array<Vector3> sample_vectors(const Locator& locator, std::span<const Vector3> queries,
                              std::span<const Vector3> vectors, Interpolation interpolation, const base::Host& host) {
  static_assert(sizeof(Vector3) == 3 * sizeof(double));
  Array<Vector3> result(queries.size(), Vector3::Zero(), host.memory);
  const auto numbers = [](auto vectors_span) {
    return std::span(vectors_span.empty() ? nullptr : vectors_span.data()->data(), 3 * vectors_span.size());
  };
  sample(locator, queries, numbers(vectors), 3, interpolation, numbers(std::span(result)), host);
  return result;
}

}  // namespace orbicube::sphere_map
