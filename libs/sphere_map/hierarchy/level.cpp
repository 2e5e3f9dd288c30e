#include "sphere_map/hierarchy/level.h"

#include <numbers>
#include <numeric>

namespace orbicube::sphere_map {
namespace {

// Sum of body(begin, end) over pieces of [0, total).
template <class Body>
double sum_of_pieces(std::size_t total, const base::Host& host, const base::ThreadPool& pool, const Body& body) {
  Array<double> sums((total + vertices_a_piece - 1) / vertices_a_piece, host.memory);
  pool.run_pieces(total, vertices_a_piece,
                  [&](std::size_t begin, std::size_t end) { sums[begin / vertices_a_piece] = body(begin, end); });
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

}  // namespace

void Level::build(const VertexRings& rings, std::span<const Vector3> positions, Energy& energy, const base::Host& host,
                  const base::ThreadPool& pool) {
  host.report("stars", 0, vertices.size());
  star_begin.resize(vertices.size() + 1);
  large.clear();
  std::size_t total = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    star_begin[i] = total;
    total += rings.valence(vertices[i]);
    if (rings.valence(vertices[i]) > large_star) large.push_back(vertices[i]);
  }
  star_begin.back() = total;
  stars.resize(total);
  host.report("stars", 0, vertices.size());
  const double area = sum_of_pieces(vertices.size(), host, pool, [&](std::size_t begin, std::size_t end) {
    double sum = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const Index v = vertices[i];
      const auto ring = rings[v];
      for (std::size_t k = 0; k < ring.size(); ++k) {
        const Index q = ring[k];
        const Index r = ring[k + 1 < ring.size() ? k + 1 : 0];
        StarTriangle& s = stars[star_begin[i] + k];
        s = {q, r, triangle_shape(positions[v], positions[q], positions[r], energy.rest)};
        sum += s.shape.area / 3;
      }
    }
    return sum;
  });
  host.report("stars", vertices.size(), vertices.size());
  energy.area_scale = 4 * std::numbers::pi / area;
  energy.uniform_area = 4 * std::numbers::pi / static_cast<double>(2 * vertices.size() - 4);
}

double level_energy(const Energy& energy, const Level& level, std::span<const Vector3> directions,
                    const base::Host& host, const base::ThreadPool& pool) {
  return sum_of_pieces(level.vertices.size(), host, pool, [&](std::size_t begin, std::size_t end) {
    double sum = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const Index v = level.vertices[i];
      for (const StarTriangle& s : level.star(i)) {
        if (v < s.q && v < s.r) {
          sum += triangle_energy(energy, s.shape, SphericalTriangle(directions[v], directions[s.q], directions[s.r]));
        }
      }
    }
    return sum;
  });
}

}  // namespace orbicube::sphere_map
