#include "sphere_map/relaxation.h"

#include <numbers>

namespace orbicube::sphere_map {

void Level::build(const VertexRings& rings, std::span<const Vector3> positions, Energy& energy,
                  const base::Host& host) {
  star_begin.clear();
  stars.clear();
  double area = 0;
  large.clear();
  star_begin.reserve(vertices.size() + 1);
  stars.reserve(6 * vertices.size() - 12);  // three corners for each of the 2 n - 4 triangles
  for (const Index v : vertices) {
    if (star_begin.size() % 16384 == 0) host.report("stars", star_begin.size(), vertices.size());
    const auto ring = rings[v];
    if (ring.size() > large_star) large.push_back(v);
    star_begin.push_back(stars.size());
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Index q = ring[i];
      const Index r = ring[i + 1 < ring.size() ? i + 1 : 0];
      stars.push_back({q, r, triangle_shape(positions[v], positions[q], positions[r], energy.least_area)});
      area += stars.back().shape.area / 3;
    }
  }
  star_begin.push_back(stars.size());
  energy.area_scale = 4 * std::numbers::pi / area;
  energy.uniform_area = 4 * std::numbers::pi / static_cast<double>(2 * vertices.size() - 4);
}

double level_energy(const Energy& energy, const Level& level, std::span<const Vector3> directions) {
  double sum = 0;
  for (std::size_t i = 0; i < level.vertices.size(); ++i) {
    const Index v = level.vertices[i];
    for (const StarTriangle& s : level.star(i)) {
      if (v < s.q && v < s.r) {
        sum += triangle_energy(energy, s.shape, SphericalTriangle(directions[v], directions[s.q], directions[s.r]));
      }
    }
  }
  return sum;
}

double relax(const Energy& energy, const Level& level, const RelaxationLimits& limits, std::span<Vector3> directions,
             BucketQueue& queue, std::span<Index> place, StepScratch& scratch, const base::Host& host) {
  const std::size_t count = level.vertices.size();
  double value = level_energy(energy, level, directions);
  queue.start(value);
  for (std::size_t i = 0; i < count; ++i) {
    const Index v = level.vertices[i];
    place[v] = static_cast<Index>(i);
    queue.raise(v, value);
  }
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
    for (const Index v : level.large)
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
  return value;
}

}  // namespace orbicube::sphere_map
