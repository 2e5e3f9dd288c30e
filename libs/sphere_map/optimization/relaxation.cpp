#include "sphere_map/optimization/relaxation.h"

namespace orbicube::sphere_map {

void relax(const Energy& energy, const Level& level, std::span<const Index> place, std::span<const Index> first,
           const RelaxationLimits& limits, std::span<Vector3> directions, BucketQueue& queue, StepScratch& scratch,
           const base::Host& host, const base::ThreadPool& pool) {
  const std::size_t count = first.size();
  if (count == 0) return;
  // A few vertices are no reason to look at the largest stars again and again.
  const std::span<const Index> large =
      count == level.vertices.size() ? std::span(level.large) : std::span<const Index>();
  double value = level_energy(energy, level, directions, host, pool);
  queue.start(value);
  for (const Index v : first)
    queue.raise(v, value);
  for (const Index v : level.large)
    queue.hold(v);
  const auto visit = [&](Index v) {
    const auto star = level.star(place[v]);
    const StepResult result = improve_vertex(energy, v, star, directions, scratch);
    if (result.gain > 0 && result.movement > limits.movement) {
      queue.raise(v, 0.25 * result.gain);
      for (const StarTriangle& s : star)
        queue.raise(s.q, result.gain);
    }
    return result.gain;
  };
  for (std::size_t pass = 0; pass < limits.passes; ++pass) {
    double gain = 0;
    for (const Index v : large)
      gain += visit(v);
    for (std::size_t step = 0; step < count && !queue.empty(); ++step) {
      gain += visit(queue.pop());
      if (step % 1024 == 0) host.report("relaxation", pass * count + step, limits.passes * count, value - gain);
    }
    value -= gain;
    if (gain < limits.relative_gain * value || queue.empty()) break;
  }
  for (const Index v : level.large)
    queue.release(v);
}

}  // namespace orbicube::sphere_map
