#include "sphere_map/dissertation/method.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/heap.h"
#include "sphere_map/dissertation/step.h"
#include "sphere_map/hierarchy/decimation.h"
#include "sphere_map/hierarchy/partial.h"
#include "sphere_map/hierarchy/spherical_kernel.h"

namespace orbicube::sphere_map::dissertation {
namespace {

// Mended of Algorithm 1:
//   1. Its stop |E_j - E_(j-1)| < epsilon ends the work on the first vertex that happens not to move, be all others far
//      from their best positions. Here the mean gain of the last `window` iterations stands for the gain of one, and
//      epsilon is a part of E over the number of vertices: work ends when one step for each would gain less than that.
//   2. When a kernel is empty in double precision all the same, the hierarchy is begun again with another order of
//      decimation and a stricter bound of the quasi-conformal distortion (mend 2 of step.h).
struct Limits {
  double relative_gain;          // 0: not by gain
  std::uint64_t window;          // iterations
  std::uint64_t max_iterations;  // Iter_max
};

Limits level_limits(const AlgorithmLimits& of) {
  return {of.level_tolerance, of.level_splits,
          of.max_level_iterations > 0 ? of.max_level_iterations : 50 * of.level_splits};
}

Limits final_limits(const AlgorithmLimits& of, std::size_t vertices) {
  return {of.final_tolerance, vertices, of.max_final_iterations > 0 ? of.max_final_iterations : 100 * vertices};
}

void require_limits(const AlgorithmLimits& of) {
  if (of.level_splits == 0 || of.level_splits > max_level_splits) {
    throw base::Error("invalid-argument", "level_splits must be from 1 to " + std::to_string(max_level_splits));
  }
  const auto usable = [](double tolerance) { return tolerance >= 0 && std::isfinite(tolerance); };
  if (!usable(of.level_tolerance) || !usable(of.final_tolerance)) {
    throw base::Error("invalid-argument", "level_tolerance and final_tolerance must be nonnegative and finite");
  }
}

class Hierarchy {
 public:
  Hierarchy(Decimation& decimation, std::span<const Vector3> positions, const PrintedEnergy& energy,
            const RestTriangles& rest, const DissertationOptions& options, const base::Host& host)
      : decimation_(decimation),
        rings_(decimation.rings),
        positions_(positions),
        options_(options),
        host_(host),
        energy_(energy),
        rest_(rest),
        directions_(positions.size(), Vector3::Zero(), host.memory),
        queued_(positions.size(), 0, host.memory),
        queue_(host.memory),
        star_(host.memory),
        kernel_scratch_(host.memory) {}

  Array<Vector3> run(Partial* partial) {
    try {
      refine();
    } catch (const base::Error&) {
      keep_partial(decimation_.collapses, directions_, partial);
      throw;
    }
    return std::move(directions_);
  }

 private:
  // Algorithm 1.
  void refine() {
    const std::size_t total = 4 + decimation_.collapses.size();
    place_tetrahedron();
    for (std::size_t k = 4; k < total; ++k) {
      split(decimation_.collapses[total - 1 - k]);
      if (k % options_.limits.level_splits == 0) {
        optimize(level_limits(options_.limits), "refinement", k, total);
        while (!queue_.empty())
          pop();
        trace();
      }
      if (k % 64 == 0) host_.report("refinement", k, total);
    }
    for (Index v = 0; v < directions_.size(); ++v) {
      if (rings_.valence(v) > 0) enqueue(v);
      if (v % 1024 == 0) host_.report("priorities", v, directions_.size());
    }
    optimize(final_limits(options_.limits, total), "optimization", 0, 0);
  }

  using Entry = std::pair<double, Index>;

  void place_tetrahedron() {
    set_tetrahedron(decimation_.tetrahedron, directions_);
    const auto [top, first, second, third] = decimation_.tetrahedron;
    vertices_ = 4;
    value_ = star_energy(energy_, star_of(top), directions_[top], directions_) + fan_energy(first, {third, second});
  }

  std::span<const StarTriangle> star_of(Index v) {
    const auto ring = rings_[v];
    star_.clear();
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Index q = ring[i];
      const Index r = ring[i + 1 < ring.size() ? i + 1 : 0];
      star_.push_back({q, r, shape(v, q, r)});
    }
    return star_;
  }

  TriangleShape shape(Index v, Index q, Index r) const {
    return triangle_shape(positions_[v], positions_[q], positions_[r], rest_);
  }

  // Energy of the triangles of `v` with each two of `others` that follow each other.
  double fan_energy(Index v, std::initializer_list<Index> others) {
    return fan_energy(v, std::span(others.begin(), others.size()));
  }
  double fan_energy(Index v, std::span<const Index> others) {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < others.size(); ++i) {
      const Index q = others[i];
      const Index r = others[i + 1];
      sum += triangle_energy(energy_, shape(v, q, r), directions_[v], directions_[q], directions_[r]);
    }
    return sum;
  }

  void split(const Collapse& collapse) {
    const auto ring = decimation_.ring(collapse);  // kept, left, ..., right
    value_ -= fan_energy(collapse.kept, ring.subspan(1));
    rings_.split(collapse, ring);
    const Index v = collapse.removed;
    const auto point = kernel_centroid(rings_[v], collapse.kept, directions_, kernel_scratch_);
    if (!point) {
      throw base::Error("no-valid-result",
                        "the spherical kernel of vertex " + std::to_string(v) + " is too small for double precision");
    }
    directions_[v] = *point;
    ++vertices_;
    value_ += star_energy(energy_, star_of(v), directions_[v], directions_);
    improve(collapse.kept);
    improve(v);
    enqueue(collapse.kept);
    enqueue(v);
  }

  double improve(Index v) {
    const double gain = great_circle_search(energy_, v, star_of(v), directions_);
    value_ -= gain;
    ++iterations_;
    return gain;
  }

  void enqueue(Index v) {
    if (queued_[v]) return;
    queued_[v] = 1;
    queue_.push({priority(energy_, v, star_of(v), directions_), v});
  }

  Index pop() {
    const Index v = queue_.pop().second;
    queued_[v] = 0;
    return v;
  }

  // The inner loops of Algorithm 1.
  void optimize(const Limits& limits, const char* phase, std::size_t done, std::size_t total) {
    double window_gain = 0;
    for (std::uint64_t j = 1; j <= limits.max_iterations && !queue_.empty(); ++j) {
      const Index v = pop();
      const double gain = improve(v);
      window_gain += gain;
      if (gain > 0) {  // section 3.1.4: only then may the neighbors' best positions have changed
        for (const Index neighbor : rings_[v])
          enqueue(neighbor);
      }
      if (iterations_ % 1024 == 0) host_.report(phase, done, total, value_);
      if (j % limits.window != 0) continue;
      if (vertices_ == limits.window) trace();
      const double mean_gain = window_gain / static_cast<double>(limits.window);
      if (mean_gain < limits.relative_gain * value_ / static_cast<double>(vertices_)) break;
      window_gain = 0;
    }
  }

  void trace() const {
    if (options_.trace) options_.trace({iterations_, vertices_, value_});
  }

  Decimation& decimation_;
  VertexRings& rings_;
  std::span<const Vector3> positions_;
  const DissertationOptions& options_;
  const base::Host& host_;
  PrintedEnergy energy_;
  RestTriangles rest_;
  Array<Vector3> directions_;
  Array<std::uint8_t> queued_;
  base::Heap<Entry, std::less<>> queue_;
  Array<StarTriangle> star_;
  KernelPolygon kernel_scratch_;
  std::size_t vertices_ = 0;
  std::uint64_t iterations_ = 0;
  double value_ = 0;  // E of the mesh as it is refined so far
};

}  // namespace

Array<Vector3> compute(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                       const DissertationOptions& options, const base::Host& host, Partial* partial) {
  require_weights(options.angle_weight, options.area_weight);
  require_limits(options.limits);
  double twice_area = 0;
  for (const Triangle& t : triangles)
    twice_area += (positions[t[1]] - positions[t[0]]).cross(positions[t[2]] - positions[t[0]]).norm();
  const double mean_area = 0.5 * twice_area / static_cast<double>(triangles.size());

  // The last attempts are for surfaces with triangles without area, which count as having some, in the end all alike.
  struct Attempt {
    double max_quasi_conformal, min_area;  // the latter times the mean area
  };
  constexpr std::array<Attempt, 5> attempts = {{{100, 0}, {20, 0}, {10, 1e-2}, {10, 1}, {10, 1e3}}};
  for (std::size_t i = 0;; ++i) {
    RestTriangles rest = options.rest;
    rest.min_area = attempts[i].min_area * mean_area;
    const double area = static_cast<double>(triangles.size()) * (mean_area + rest.min_area);
    const PrintedEnergy energy{options.angle_weight, options.area_weight, 4 * std::numbers::pi / area,
                               attempts[i].max_quasi_conformal};
    try {
      Decimation decimation =
          decimate(positions, VertexRings(positions.size(), triangles, host), options.seed + 0x1000 * i, host,
                   base::ThreadPool(host), usual_region_size, Ties::by_number);
      return Hierarchy(decimation, positions, energy, rest, options, host).run(partial);
    } catch (const base::Error& e) {
      if (e.status() != base::Status::no_valid_result || i + 1 == attempts.size()) throw;
      host.log(std::string("trying again: ") + e.what());
    }
  }
}

}  // namespace orbicube::sphere_map::dissertation
