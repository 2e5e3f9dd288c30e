#include "sphere_map/sampling/rounding.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "base/counted.h"
#include "base/error.h"
#include "sphere_map/hierarchy/spherical_kernel.h"
#include "sphere_map/hierarchy/vertex_rings.h"
#include "sphere_map/optimization/distortion.h"

namespace orbicube::sphere_map {
namespace {

// How good a star is: fewer triangles that are not safely positive, then a larger smallest height.
struct StarQuality {
  std::size_t bad = 0;
  double min_height = std::numeric_limits<double>::infinity();

  bool better_than(const StarQuality& other) const {
    return bad != other.bad ? bad < other.bad : min_height > other.min_height;
  }
};

class Repairer {
 public:
  Repairer(std::span<const Triangle> triangles, const Store& store, double slack, double grid, Array<Vector3>& stored,
           const base::Host& host)
      : store_(store),
        slack_(slack),
        grid_(grid),
        stored_(stored),
        host_(host),
        rings_(stored.size(), triangles, host),
        polygon_(host.memory),
        queued_(stored.size(), 0, host.memory),
        moved_(stored.size(), 0, host.memory) {}

  // Rounds of moves on the vertices around bad triangles; each round that leaves some takes in their neighbors too.
  // Ends when rounds no longer help: a map whose triangles are far below the grid cannot be mended.
  void run(std::span<const Triangle> triangles) {
    constexpr int max_rounds = 60;
    constexpr int patience = 6;
    std::size_t fewest = triangles.size();
    int without_progress = 0;
    Array<Index> active(host_.memory);
    for (const Triangle& t : triangles) {
      if (!safely_positive(stored_[t[0]], stored_[t[1]], stored_[t[2]], slack_)) {
        for (const Index v : t)
          enqueue(active, v);
      }
    }
    Array<Index> next(host_.memory);
    for (int round = 0; round < max_rounds && !active.empty(); ++round) {
      std::sort(active.begin(), active.end());
      for (std::size_t i = 0; i < active.size(); ++i) {
        move(active[i]);
        if (i % 256 == 0) host_.report("repair of rounding", i, active.size());
      }
      for (const Index v : active)
        queued_[v] = 0;
      next.clear();
      std::size_t bad = 0;
      for (const Index v : active) {
        const std::size_t bad_here = quality(v, stored_[v]).bad;
        bad += bad_here;
        if (bad_here == 0) continue;
        enqueue(next, v);
        for (const Index neighbor : rings_[v])
          enqueue(next, neighbor);
      }
      std::swap(active, next);
      const bool progress = static_cast<double>(bad) < 0.9 * static_cast<double>(fewest);
      without_progress = progress ? 0 : without_progress + 1;
      fewest = std::min(fewest, bad);
      if (without_progress >= patience) break;
    }
  }

  std::size_t moved() const { return static_cast<std::size_t>(std::count(moved_.begin(), moved_.end(), 1)); }

 private:
  void enqueue(Array<Index>& list, Index v) {
    if (queued_[v]) return;
    queued_[v] = 1;
    list.push_back(v);
  }

  StarQuality quality(Index v, const Vector3& position) const {
    const auto ring = rings_[v];
    StarQuality result;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vector3& q = stored_[ring[i]];
      const Vector3& r = stored_[ring[i + 1 < ring.size() ? i + 1 : 0]];
      result.bad += !safely_positive(position, q, r, slack_);
      const Vector3 e = q - position;
      const Vector3 f = r - position;
      const double longest = std::sqrt(std::max({e.squaredNorm(), f.squaredNorm(), (q - r).squaredNorm()}));
      result.min_height = std::min(result.min_height, longest > 0 ? position.dot(e.cross(f)) / longest : 0);
    }
    return result;
  }

  void move(Index v) {
    StarQuality best = quality(v, stored_[v]);
    const auto consider = [&](const Vector3& direction) {
      const Vector3 candidate = store_(v, direction);
      const StarQuality found = quality(v, candidate);
      if (!found.better_than(best)) return;
      best = found;
      stored_[v] = candidate;
      moved_[v] = 1;
    };
    Vector3 mean = Vector3::Zero();
    for (const Index neighbor : rings_[v])
      mean += stored_[neighbor];
    if (mean.norm() > 0) consider(mean.normalized());
    if (polygon_.cut(rings_[v], stored_, stored_[v].normalized(), mesh::no_index)) {
      if (const auto centroid = polygon_.area_centroid()) consider(*centroid);
      consider(polygon_.corner_mean(1));
    }
    // Single steps of the grid or so around the best point, for kernels of few grid points.
    const TangentBasis basis(stored_[v].normalized());
    for (const double step : {4 * grid_, 2 * grid_, grid_}) {
      const Vector3 from = stored_[v];
      for (int direction = 0; direction < 8; ++direction) {
        const double angle = 0.25 * std::numbers::pi * direction;
        consider((from + step * (std::cos(angle) * basis.first + std::sin(angle) * basis.second)).normalized());
      }
    }
  }

  const Store& store_;
  double slack_;
  double grid_;  // maximum distance by which storing moves a vertex
  Array<Vector3>& stored_;
  const base::Host& host_;
  VertexRings rings_;
  KernelPolygon polygon_;
  Array<std::uint8_t> queued_;
  Array<std::uint8_t> moved_;
};

}  // namespace

// GCC 12 drops the rounding of two coordinates at once: it takes double -> float -> double of a vector for nothing. The
// volatile variable keeps them apart.
Vector3 rounded_to_float(const Vector3& d) {
  const auto round = [](double x) {
    const volatile float rounded = static_cast<float>(x);
    return static_cast<double>(rounded);
  };
  return {round(d.x()), round(d.y()), round(d.z())};
}

RoundedMap round_and_repair(std::span<const Triangle> triangles, std::span<const Vector3> directions,
                            const Store& store, double slack, const base::Host& host) {
  RoundedMap result(host.memory);
  result.directions.resize(directions.size());
  double grid = 0;
  for (std::size_t v = 0; v < directions.size(); ++v) {
    result.directions[v] = store(static_cast<Index>(v), directions[v]);
    grid = std::max(grid, (result.directions[v] - directions[v]).norm());
  }
  const auto count_bad = [&] {
    return static_cast<std::size_t>(std::count_if(triangles.begin(), triangles.end(), [&](const Triangle& t) {
      const auto& d = result.directions;
      return !safely_positive(d[t[0]], d[t[1]], d[t[2]], slack);
    }));
  };
  result.not_positive = count_bad();
  if (result.not_positive > 0) {
    Repairer repairer(triangles, store, slack, grid, result.directions, host);
    repairer.run(triangles);
    result.moved = repairer.moved();
    result.not_positive = count_bad();
  }
  return result;
}

Array<Vector3> round_to_float(std::span<const Triangle> triangles, std::span<const Vector3> directions,
                              const base::Host& host) {
  Array<Triangle> positive(triangles.begin(), triangles.end(), host.memory);
  const auto clockwise = std::count_if(triangles.begin(), triangles.end(), [&](const Triangle& t) {
    return !safely_positive(directions[t[0]], directions[t[1]], directions[t[2]]);
  });
  if (static_cast<std::size_t>(clockwise) > triangles.size() / 2) {
    for (Triangle& t : positive)
      std::swap(t[1], t[2]);
  }
  const Store to_float = [](Index, const Vector3& d) { return rounded_to_float(d); };
  RoundedMap map = round_and_repair(positive, directions, to_float, 0, host);
  if (map.not_positive > 0) {
    throw base::Error("no-valid-result",
                      base::counted(map.not_positive, "triangle of the map is", "triangles of the map are") +
                          " too small for float32");
  }
  return std::move(map.directions);
}

}  // namespace orbicube::sphere_map
