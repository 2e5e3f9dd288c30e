#include "frame_field/smoothing/dissertation_method.h"

#include <utility>

#include "frame_field/smoothing/energy.h"
#include "frame_field/smoothing/starts.h"
#include "quaternion/frame_distance.h"
#include "sphere_optimizer/relaxation.h"

namespace orbicube::frame_field {
namespace {

using quaternion::conjugate;
using quaternion::cube_group;
using quaternion::multiply;

constexpr double printed_tolerance = 1e-3;  // of the tangent gradient of a frame
constexpr double printed_gain = 1e-5;       // of the energy, in a pass over all frames

// sum -(s0_ij)^2 + 1 over the links of one frame with frozen matchings (eqs. 6.10 and 6.11).
class FrozenEnergy {
 public:
  FrozenEnergy(const DualGraph& graph, const Constraints& constraints, std::span<const std::array<std::uint8_t, 4>> g,
               const double* points)
      : graph_(graph), constraints_(constraints), matchings_(g), points_(points) {}

  sphere_optimizer::FixedDimension<4> dimension() const { return {}; }

  double value(std::size_t node, const double* x) const {
    double gradient[4];
    return evaluate(node, x, gradient);
  }
  double value_and_gradient(std::size_t node, double* gradient) const {
    return evaluate(node, points_ + 4 * node, gradient);
  }
  template <class Visit>
  void for_each_neighbor(std::size_t node, const Visit& visit) const {
    if (!constraints_.is_free(node)) return;
    for (const Index other : graph_.others[node]) {
      if (other != node && constraints_.is_free(other)) visit(other);
    }
  }

 private:
  double evaluate(std::size_t node, const double* x, double* gradient) const {
    std::fill_n(gradient, 4, 0.0);
    double sum = 0;
    if (!constraints_.is_free(node)) return sum;  // held: nothing to gain
    for (std::size_t k = 0; k < 4; ++k) {
      const Index other = graph_.others[node][k];
      if (other == node) continue;
      const double* q = points_ + 4 * other;
      const Quaternion p = multiply({q[0], q[1], q[2], q[3]}, conjugate(cube_group.element[matchings_[node][k]]));
      const double s0 = p.w * x[0] + p.x * x[1] + p.y * x[2] + p.z * x[3];
      const double w = static_cast<double>(graph_.weights[node][k]);
      sum += w * (1 - s0 * s0);
      const double slope = -2 * w * s0;
      gradient[0] += slope * p.w;
      gradient[1] += slope * p.x;
      gradient[2] += slope * p.y;
      gradient[3] += slope * p.z;
    }
    return sum;
  }

  const DualGraph& graph_;
  const Constraints& constraints_;
  std::span<const std::array<std::uint8_t, 4>> matchings_;
  const double* points_;
};

}  // namespace

Outcome dissertation_method(const DualGraph& graph, const Constraints& constraints, const Quaternion& axes,
                            const base::Host& host) {
  const std::size_t n = graph.size();
  Field field = constant_start(graph, constraints, axes, host);
  Array<std::array<std::uint8_t, 4>> matchings(n, host.memory);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      // Both sides of a face must agree, also where two rotations are equally near.
      const Index j = graph.others[i][k];
      const auto low = std::min<std::size_t>(i, j), high = std::max<std::size_t>(i, j);
      const std::uint32_t g = quaternion::symmetric_matching(field[low], field[high]);
      matchings[i][k] = static_cast<std::uint8_t>(low == i ? g : cube_group.inverse[g]);
    }
  }
  static_assert(sizeof(Quaternion) == 4 * sizeof(double));
  auto* points = reinterpret_cast<double*>(field.data());
  const FrozenEnergy frozen(graph, constraints, matchings, points);
  sphere_optimizer::Relaxation relaxation({n, 4},
                                          {.method = sphere_optimizer::Method::dissertation,
                                           .gradient_tolerance = printed_tolerance,
                                           .relative_gain = printed_gain},
                                          host.memory);
  relaxation.run(frozen, {points, 4 * n}, host);
  Outcome outcome(host.memory);
  outcome.start = Start::identity;
  outcome.energy = energy(graph, field, host);
  outcome.smoothing_steps = static_cast<std::uint32_t>(relaxation.result().steps / n);
  outcome.field = std::move(field);
  return outcome;
}

}  // namespace orbicube::frame_field
