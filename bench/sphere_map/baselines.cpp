#include "baselines.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <queue>
#include <utility>
#include <vector>

#include "base/error.h"
#include "linear/sparse_system.h"
#include "mesh/search/vertex_measures.h"
#include "mesh/topology/edge_table.h"

namespace orbicube::bench {
namespace {

using mesh::Index;
using mesh::Vector3;
using Directions = sphere_map::Array<Vector3>;

// Of the harmonic flow: the time of a step, for the areas of the unit sphere, and the relative change of the energy at
// which it ends. Longer steps lose the degree of the map on long protrusions.
constexpr double time_step = 0.01, smallest_change = 1e-6;
constexpr int max_steps = 2000;
// Of the quasi-harmonic coordinates: rounds, the power of the ratio of areas by which conductivities change, and the
// bounds of that ratio, of a conductivity and of a weight from below.
constexpr int conductivity_rounds = 6;
constexpr double conductivity_power = 0.5, max_ratio = 100, max_conductivity = 1e5, min_weight = 2.5e-4;
constexpr int tangential_sweeps = 20;

struct Edge {
  Index start, end;
  double weight;  // half the sum of the cotangents of the two opposite angles
};

// With the weights of triangles multiplied by their conductivity.
std::vector<Edge> edges_of(const mesh::Mesh& surface, const std::vector<double>& conductivity, const base::Host& host) {
  const mesh::EdgeTable table(surface.positions.size(), surface.triangles, host);
  std::vector<Edge> edges;
  edges.reserve(table.size());
  for (std::size_t e = 0; e < table.size(); ++e) {
    const auto sides = table.half_edges(e);
    Edge edge{mesh::start_of(surface.triangles, sides[0]), mesh::end_of(surface.triangles, sides[0]), 0};
    for (const Index side : sides) {
      const Index opposite = mesh::end_of(surface.triangles, mesh::next_in_triangle(side));
      const Vector3 a = surface.positions[edge.start] - surface.positions[opposite],
                    b = surface.positions[edge.end] - surface.positions[opposite];
      const double area = a.cross(b).norm();
      if (area > 0) edge.weight += 0.5 * conductivity[mesh::triangle_of(side)] * a.dot(b) / area;
    }
    edges.push_back(edge);
  }
  return edges;
}

double energy(const std::vector<Edge>& edges, const Directions& f) {
  double sum = 0;
  for (const Edge& e : edges)
    sum += 0.5 * e.weight * (f[e.start] - f[e.end]).squaredNorm();
  return sum;
}

// Adds the weights of the edges among unknowns; `number` has that of a vertex, or no_index where its value is known.
void add_laplacian(const std::vector<Edge>& edges, const std::vector<Index>& number, double factor,
                   linear::SparseSystem::Triplets& triplets) {
  for (const Edge& e : edges) {
    const Index i = number[e.start], j = number[e.end];
    if (i != mesh::no_index) triplets.emplace_back(static_cast<int>(i), static_cast<int>(i), factor * e.weight);
    if (j != mesh::no_index) triplets.emplace_back(static_cast<int>(j), static_cast<int>(j), factor * e.weight);
    if (i != mesh::no_index && j != mesh::no_index)
      triplets.emplace_back(static_cast<int>(std::max(i, j)), static_cast<int>(std::min(i, j)), -factor * e.weight);
  }
}

void factorize(linear::SparseSystem& system) {
  if (!system.factorize()) throw base::Error("degenerate-geometry", "a system of the baseline has no factor");
}

// Moebius transformations that bring the center of mass to that of the sphere.
void bring_to_center(const std::vector<double>& masses, Directions& f) {
  constexpr int max_rounds = 20;
  for (int round = 0; round < max_rounds; ++round) {
    Vector3 center = Vector3::Zero();
    double mass = 0;
    for (std::size_t v = 0; v < f.size(); ++v) {
      center += masses[v] * f[v];
      mass += masses[v];
    }
    center /= mass;
    if (center.norm() < 1e-6) break;
    for (Vector3& p : f)
      p = ((1 - center.squaredNorm()) * (p - center) / (p - center).squaredNorm() - center).normalized();
  }
}

// The flow of the energy of these weights: (M + t L) f' = M f, onto the sphere, and with its center of mass back there.
void flow(const std::vector<Edge>& edges, const std::vector<double>& masses, double time, Directions& f) {
  const std::size_t count = f.size();
  linear::SparseSystem::Triplets triplets;
  std::vector<Index> number(count);
  for (std::size_t v = 0; v < count; ++v) {
    number[v] = static_cast<Index>(v);
    triplets.emplace_back(static_cast<int>(v), static_cast<int>(v), masses[v]);
  }
  add_laplacian(edges, number, time, triplets);
  linear::SparseSystem system(count, triplets);
  factorize(system);
  double before = energy(edges, f);
  for (int step = 0; step < max_steps; ++step) {
    Eigen::VectorXd right(static_cast<Eigen::Index>(count));
    for (Eigen::Index a = 0; a < 3; ++a) {
      for (std::size_t v = 0; v < count; ++v)
        right[static_cast<Eigen::Index>(v)] = masses[v] * f[v][a];
      const Eigen::VectorXd next = system.solve(right);
      for (std::size_t v = 0; v < count; ++v)
        f[v][a] = next[static_cast<Eigen::Index>(v)];
    }
    for (Vector3& p : f)
      p.normalize();
    bring_to_center(masses, f);
    const double after = energy(edges, f);
    if (std::abs(before - after) < smallest_change * after) break;
    before = after;
  }
}

// Dijkstra's distances along edges from a vertex, and the vertex before each.
std::pair<std::vector<double>, std::vector<Index>> distances_from(const mesh::Mesh& surface,
                                                                  const std::vector<Edge>& edges, Index from) {
  std::vector<std::vector<Index>> neighbors(surface.positions.size());
  for (const Edge& e : edges) {
    neighbors[e.start].push_back(e.end);
    neighbors[e.end].push_back(e.start);
  }
  std::vector<double> distance(surface.positions.size(), HUGE_VAL);
  std::vector<Index> before(surface.positions.size(), mesh::no_index);
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  distance[from] = 0;
  queue.emplace(0, from);
  while (!queue.empty()) {
    const auto [d, v] = queue.top();
    queue.pop();
    if (d > distance[v]) continue;
    for (const Index w : neighbors[v]) {
      const double next = d + (surface.positions[v] - surface.positions[w]).norm();
      if (next >= distance[w]) continue;
      distance[w] = next;
      before[w] = v;
      queue.emplace(next, w);
    }
  }
  return {std::move(distance), std::move(before)};
}

Index farthest(const std::vector<double>& distance) {
  Index best = 0;
  for (Index v = 0; v < distance.size(); ++v) {
    if (std::isfinite(distance[v]) && (!std::isfinite(distance[best]) || distance[v] > distance[best])) best = v;
  }
  return best;
}

// For each edge that leaves the path on its left side, the turn of the longitude: 1 away from the path, -1 towards it.
std::vector<int> crossings(const mesh::Mesh& surface, const std::vector<Edge>& edges, const std::vector<Index>& path,
                           const base::Host& host) {
  std::vector<Index> place(surface.positions.size(), mesh::no_index);
  for (std::size_t i = 0; i < path.size(); ++i)
    place[path[i]] = static_cast<Index>(i);
  // Neighbors on the left of inner vertices of the path: around each, from the next vertex of the path to the one
  // before.
  const mesh::EdgeTable table(surface.positions.size(), surface.triangles, host);
  std::vector<std::vector<std::pair<Index, Index>>> ring(surface.positions.size());  // next neighbor of each neighbor
  for (const auto& t : surface.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (place[t[k]] != mesh::no_index) ring[t[k]].emplace_back(t[(k + 1) % 3], t[(k + 2) % 3]);
    }
  }
  std::vector<std::vector<Index>> left(surface.positions.size());
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    const auto& around = ring[path[i]];
    Index at = path[i + 1];
    while (true) {
      const auto next = std::find_if(around.begin(), around.end(), [&](const auto& pair) { return pair.first == at; });
      at = next->second;
      if (at == path[i - 1]) break;
      left[path[i]].push_back(at);
    }
  }
  const auto is_left = [&](Index v, Index w) {
    return place[v] != mesh::no_index && std::find(left[v].begin(), left[v].end(), w) != left[v].end();
  };
  std::vector<int> turns(edges.size(), 0);
  for (std::size_t e = 0; e < edges.size(); ++e)
    turns[e] = (is_left(edges[e].start, edges[e].end) ? 1 : 0) - (is_left(edges[e].end, edges[e].start) ? 1 : 0);
  return turns;
}

// Harmonic values with those of two vertices known, where each edge adds `jump` times its turn.
std::vector<double> harmonic_values(const std::vector<Edge>& edges, std::size_t count, std::pair<Index, double> first,
                                    std::pair<Index, double> second, const std::vector<int>& turns, double jump) {
  std::vector<Index> number(count);
  std::vector<double> value(count, 0);
  Index unknowns = 0;
  for (Index v = 0; v < count; ++v)
    number[v] = v == first.first || v == second.first ? mesh::no_index : unknowns++;
  value[first.first] = first.second;
  value[second.first] = second.second;
  linear::SparseSystem::Triplets triplets;
  for (Index i = 0; i < unknowns; ++i)
    triplets.emplace_back(static_cast<int>(i), static_cast<int>(i), 1e-12);
  add_laplacian(edges, number, 1, triplets);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(unknowns));
  for (std::size_t e = 0; e < edges.size(); ++e) {
    // value[end] - value[start] + jump * turn is small.
    const auto& [start, end, weight] = edges[e];
    const double shift = turns.empty() ? 0 : jump * turns[e];
    if (number[start] != mesh::no_index)
      right[static_cast<Eigen::Index>(number[start])] +=
          weight * (shift + (number[end] == mesh::no_index ? value[end] : 0));
    if (number[end] != mesh::no_index)
      right[static_cast<Eigen::Index>(number[end])] -=
          weight * (shift - (number[start] == mesh::no_index ? value[start] : 0));
  }
  linear::SparseSystem system(unknowns, triplets);
  factorize(system);
  const Eigen::VectorXd solution = system.solve(right);
  for (Index v = 0; v < count; ++v) {
    if (number[v] != mesh::no_index) value[v] = solution[static_cast<Eigen::Index>(number[v])];
  }
  return value;
}

// Harmonic latitude and longitude between two poles far from each other, with a cut along the shortest path between
// them.
Directions longitude_latitude(const mesh::Mesh& surface, const std::vector<Edge>& edges, const base::Host& host) {
  const Index south = farthest(distances_from(surface, edges, 0).first);
  const auto [distance, before] = distances_from(surface, edges, south);
  const Index north = farthest(distance);
  std::vector<Index> path;
  for (Index v = north; v != mesh::no_index; v = before[v])
    path.push_back(v);
  const std::vector<int> turns = crossings(surface, edges, path, host);
  const std::size_t count = surface.positions.size();
  const auto latitude = harmonic_values(edges, count, {north, 0.0}, {south, std::numbers::pi}, {}, 0);
  // The longitude has no value at the poles, whose edges have no part in it; one value is fixed.
  std::vector<Edge> inner = edges;
  for (Edge& e : inner) {
    for (const Index v : {e.start, e.end}) {
      if (v == north || v == south) e.weight = 0;
    }
  }
  const auto longitude =
      harmonic_values(inner, count, {north, 0.0}, {path[path.size() / 2], 0.0}, turns, 2 * std::numbers::pi);
  Directions f(count);
  for (std::size_t v = 0; v < count; ++v) {
    const double across = std::sin(latitude[v]);
    f[v] = Vector3(across * std::cos(longitude[v]), across * std::sin(longitude[v]), std::cos(latitude[v]));
  }
  return f;
}

// A third of the areas around each vertex, 4 pi in all.
std::vector<double> masses_of(const mesh::Mesh& surface, const base::Host& host) {
  const auto areas = mesh::vertex_areas(surface.positions, surface.triangles, host);
  double sum = 0;
  for (const double area : areas)
    sum += area;
  std::vector<double> masses;
  for (const double area : areas)
    masses.push_back(std::max(area / sum, 1e-12) * 4 * std::numbers::pi);
  return masses;
}

double area_of(const auto& positions, const mesh::Triangle& t) {
  return 0.5 * (positions[t[1]] - positions[t[0]]).cross(positions[t[2]] - positions[t[0]]).norm();
}

// Conducts less where triangles are smaller on the sphere than on the surface.
void update_conductivity(const mesh::Mesh& surface, const Directions& f, std::vector<double>& conductivity) {
  double total = 0, logarithms = 0;
  for (const auto& t : surface.triangles)
    total += area_of(surface.positions, t);
  for (std::size_t i = 0; i < conductivity.size(); ++i) {
    const double area = std::max(area_of(surface.positions, surface.triangles[i]), 1e-300),
                 ratio = area_of(f, surface.triangles[i]) / (4 * std::numbers::pi) * total / area;
    conductivity[i] *= std::pow(std::clamp(ratio, 1 / max_ratio, max_ratio), conductivity_power);
    logarithms += std::log(conductivity[i]);
  }
  const double mean = std::exp(logarithms / static_cast<double>(conductivity.size()));
  for (double& c : conductivity)
    c = std::clamp(c / mean, 1 / max_conductivity, max_conductivity);
}

// Moves corners of flipped triangles to the mean of their neighbors, in their tangent planes, where that flips no more.
void smooth_flipped(const mesh::Mesh& surface, Directions& f) {
  std::vector<std::vector<Index>> around(f.size());
  for (Index i = 0; i < surface.triangles.size(); ++i) {
    for (const Index v : surface.triangles[i])
      around[v].push_back(i);
  }
  const auto is_flipped = [&](Index i) {
    const auto& [a, b, c] = surface.triangles[i];
    return f[a].dot(f[b].cross(f[c])) <= 0;
  };
  for (int sweep = 0; sweep < tangential_sweeps; ++sweep) {
    for (Index v = 0; v < f.size(); ++v) {
      const auto before = std::count_if(around[v].begin(), around[v].end(), is_flipped);
      if (before == 0) continue;
      Vector3 step = Vector3::Zero();
      for (const Index i : around[v]) {
        for (const Index w : surface.triangles[i])
          step += (f[w] - f[v]) / static_cast<double>(2 * around[v].size());
      }
      const Vector3 old = f[v];
      f[v] = (old + step - step.dot(old) * old).normalized();
      if (std::count_if(around[v].begin(), around[v].end(), is_flipped) > before) f[v] = old;
    }
  }
}

}  // namespace

Directions harmonic_baseline(const mesh::Mesh& surface, const base::Host& host) {
  const std::vector<Edge> edges = edges_of(surface, std::vector<double>(surface.triangles.size(), 1), host);
  std::vector<Edge> alike = edges;
  for (Edge& e : alike)
    e.weight = 1;
  Directions f = longitude_latitude(surface, alike, host);
  const std::vector<double> masses = masses_of(surface, host);
  bring_to_center(masses, f);
  flow(edges, masses, time_step, f);
  return f;
}

Directions curvilinear_baseline(const mesh::Mesh& surface, const base::Host& host) {
  std::vector<double> conductivity(surface.triangles.size(), 1);
  Directions f;
  for (int round = 0; round <= conductivity_rounds; ++round) {
    if (round > 0) update_conductivity(surface, f, conductivity);
    std::vector<Edge> edges = edges_of(surface, conductivity, host);
    for (Edge& e : edges)
      e.weight = std::max(e.weight, min_weight);
    f = longitude_latitude(surface, edges, host);
  }
  smooth_flipped(surface, f);
  return f;
}

}  // namespace orbicube::bench
