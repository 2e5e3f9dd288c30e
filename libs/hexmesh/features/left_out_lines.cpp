#include "hexmesh/features/left_out_lines.h"

#include <algorithm>
#include <cmath>

#include "base/infinity.h"
#include "hexmesh/features/boundary_quads.h"

namespace orbicube::hexmesh {
namespace {

constexpr double reach = 0.75;            // of the mean edge there: how far a vertex may be from its place
constexpr double on_line = 0.05;          // of the mean edge: vertices that have another target but are there already
constexpr std::size_t most_lines = 2000;  // more are noise, and take long

// Points at equal distances along a line that is not of length 0.
Array<Vector3> points_along(const FeatureShape& shape, std::span<const Index> line, std::size_t steps,
                            const base::Host& host) {
  Array<double> along(1, 0.0, host.memory);
  const auto point = [&](std::size_t i) -> const Vector3& { return shape.positions()[line[i]]; };
  for (std::size_t i = 1; i < line.size(); ++i)
    along.push_back(along.back() + (point(i) - point(i - 1)).norm());
  Array<Vector3> points(1, point(0), host.memory);
  std::size_t i = 1;
  for (std::size_t k = 1; k < steps; ++k) {
    const double s = along.back() * static_cast<double>(k) / static_cast<double>(steps);
    while (i + 1 < line.size() && along[i] < s)
      ++i;
    const double t = (s - along[i - 1]) / (along[i] - along[i - 1]);
    points.push_back(point(i - 1) + t * (point(i) - point(i - 1)));
  }
  points.push_back(point(line.size() - 1));
  return points;
}

class PathFinder {
 public:
  PathFinder(const HexMesh& mesh, const FeatureTargets& targets, const base::Host& host)
      : positions_(mesh.positions),
        targets_(targets),
        host_(host),
        quads_(mesh.hexahedra, mesh.positions.size(), host),
        near_(host.memory),
        taken_(mesh.positions.size(), 0, host.memory) {}

  void add_places(std::span<const Index> line, Array<PlaceOnLine>& places) {
    const FeatureShape& shape = targets_.shape();
    double length = 0;
    for (std::size_t i = 1; i < line.size(); ++i)
      length += (shape.positions()[line[i]] - shape.positions()[line[i - 1]]).norm();
    if (!(length > 0)) return;
    const Vector3 middle = points_along(shape, line, 2, host_)[1];
    patch_ = shape.nearest_patch(middle);
    edge_ = mean_edge_near(middle);
    find_near(line);
    const auto few = static_cast<std::size_t>(std::max(1.0, std::floor(length / edge_)));
    Array<PlaceOnLine> best(host_.memory);
    double least = base::infinity;
    for (const std::size_t steps : {few, few + 1}) {
      Array<PlaceOnLine> path(host_.memory);
      const double cost = find_path(points_along(shape, line, steps, host_), path);
      if (cost >= least) continue;
      least = cost;
      best.swap(path);
    }
    for (const PlaceOnLine& place : best) {
      taken_[place.vertex] = 1;
      if (targets_.kind(place.vertex) == FeatureTargets::Kind::patch) places.push_back(place);
    }
  }

 private:
  struct Candidate {
    Index vertex = no_index;
    double cost = base::infinity;  // of the path up to there
    std::size_t before = 0;        // the candidate of the last point
  };

  double mean_edge_near(const Vector3& p) const {
    const auto vertices = quads_.vertices();
    const Index v = *std::min_element(vertices.begin(), vertices.end(), [&](Index a, Index b) {
      return (positions_[a] - p).squaredNorm() < (positions_[b] - p).squaredNorm();
    });
    double sum = 0;
    std::size_t count = 0;
    quads_.for_each_outgoing(v, [&](Index h) {
      sum += (positions_[quads_.end(h)] - positions_[v]).norm();
      ++count;
    });
    return sum / static_cast<double>(count);
  }

  // The vertices in reach of the line's box.
  void find_near(std::span<const Index> line) {
    Vector3 low = targets_.shape().positions()[line[0]], high = low;
    for (const Index v : line) {
      low = low.cwiseMin(targets_.shape().positions()[v]);
      high = high.cwiseMax(targets_.shape().positions()[v]);
    }
    low.array() -= reach * edge_;
    high.array() += reach * edge_;
    near_.clear();
    for (const Index v : quads_.vertices()) {
      const Vector3& p = positions_[v];
      if ((p.array() >= low.array()).all() && (p.array() <= high.array()).all()) near_.push_back(v);
    }
  }

  bool may_go(Index v, double distance) const {
    if (taken_[v] != 0 || distance > reach * edge_) return false;
    return distance < on_line * edge_ ||
           (targets_.kind(v) == FeatureTargets::Kind::patch && targets_.patch(v) == patch_);
  }

  Array<Candidate> candidates_at(const Vector3& p) const {
    Array<Candidate> result(host_.memory);
    for (const Index v : near_) {
      if (may_go(v, (positions_[v] - p).norm())) result.push_back({v});
    }
    return result;
  }

  // Returns the mean of the squares of the distances that the vertices of the best path go; infinite where there is no
  // path.
  double find_path(std::span<const Vector3> points, Array<PlaceOnLine>& path) const {
    Array<Array<Candidate>> levels(host_.memory);
    for (const Vector3& p : points) {
      host_.report("features", 0, 0);
      levels.push_back(candidates_at(p));
      Array<Candidate>& now = levels.back();
      for (Candidate& c : now) {
        const double own = (positions_[c.vertex] - p).squaredNorm();
        c.cost = levels.size() == 1 ? own : base::infinity;
        if (levels.size() == 1) continue;
        const Array<Candidate>& last = levels[levels.size() - 2];
        for (std::size_t i = 0; i < last.size(); ++i) {
          if (last[i].cost + own >= c.cost || quads_.find(last[i].vertex, c.vertex) == no_index) continue;
          c.cost = last[i].cost + own;
          c.before = i;
        }
      }
    }
    const Array<Candidate>& ends = levels.back();
    const auto end = std::min_element(ends.begin(), ends.end(),
                                      [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
    if (end == ends.end() || end->cost == base::infinity) return base::infinity;
    path.resize(points.size());
    std::size_t at = static_cast<std::size_t>(end - ends.begin());
    for (std::size_t k = points.size(); k-- > 0;) {
      path[k] = {levels[k][at].vertex, points[k]};
      at = levels[k][at].before;
    }
    return is_simple(path) ? end->cost / static_cast<double>(points.size()) : base::infinity;
  }

  bool is_simple(std::span<const PlaceOnLine> path) const {
    Array<Index> vertices(host_.memory);
    for (const PlaceOnLine& place : path)
      vertices.push_back(place.vertex);
    std::sort(vertices.begin(), vertices.end());
    return std::adjacent_find(vertices.begin(), vertices.end()) == vertices.end();
  }

  std::span<const Vector3> positions_;
  const FeatureTargets& targets_;
  const base::Host& host_;
  BoundaryQuads quads_;
  Array<Index> near_;
  Array<std::uint8_t> taken_;
  Index patch_ = no_index;
  double edge_ = 0;
};

}  // namespace

Array<PlaceOnLine> places_on_lines_left_out(const HexMesh& mesh, const FeatureTargets& targets,
                                            const base::Host& host) {
  Array<PlaceOnLine> places(host.memory);
  const auto lines = targets.shape().lines_left_out();
  if (lines.empty() || lines.size() > most_lines) return places;
  PathFinder finder(mesh, targets, host);
  for (const Array<Index>& line : lines)
    finder.add_places(line, places);
  return places;
}

}  // namespace orbicube::hexmesh
