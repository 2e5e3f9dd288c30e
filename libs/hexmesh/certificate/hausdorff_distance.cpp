#include "hexmesh/certificate/hausdorff_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/heap.h"
#include "base/threads/pieces.h"
#include "mesh/search/nearest.h"

namespace orbicube::hexmesh {
namespace {

constexpr const char* hausdorff_distance_phase = "distance";

// A point of a surface and what of the other surface is nearest to it.
struct Sample {
  Vector3 position;
  double distance = 0;
  Index near = no_index;
};

// A triangle, or a part of one, and a bound of the distances of its points. A distance to one triangle of the other
// surface is convex: it is largest at a corner.
struct Patch {
  std::array<Sample, 3> corners;
  double bound = 0;

  bool operator<(const Patch& other) const { return bound < other.bound; }
};

class OneWay {
 public:
  OneWay(const mesh::SurfaceSearch& other, double tolerance, double floor, const base::Host& host)
      : other_(other), tolerance_(tolerance), floor_(floor), host_(host), open_(host.memory) {}

  // At least `most`.
  double largest(std::span<const Vector3> positions, std::span<const mesh::Triangle> triangles, double most) {
    most_ = most;
    open_.assign(start(positions, triangles));
    // Where bounds do not close in, as between sheets that are equally far, what was found stands.
    const std::size_t max_halvings = 200'000 + 20 * triangles.size();
    for (std::size_t halvings = 0; !open_.empty() && halvings < max_halvings; ++halvings) {
      if (halvings % 256 == 0) host_.report(hausdorff_distance_phase, 0, 0);
      if (!in_doubt(open_.top().bound)) break;
      halve(open_.pop());
    }
    return most_;
  }

 private:
  bool in_doubt(double bound) const { return bound > (1 + tolerance_) * most_ && bound > floor_; }

  Sample sample(const Vector3& p, Index may_be_near) const {
    const mesh::SurfacePoint found = other_.nearest(p, may_be_near);
    return {p, found.distance, found.triangle};
  }

  double bound_of(const std::array<Sample, 3>& corners) const {
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
      const Index near = corners[i].near;
      if ((i > 0 && near == corners[0].near) || (i > 1 && near == corners[1].near)) continue;
      double farthest = 0;
      for (const Sample& corner : corners)
        farthest = std::max(farthest, corner.near == near ? corner.distance : other_.distance(near, corner.position));
      best = std::min(best, farthest);
    }
    return best;
  }

  // The triangles that are in doubt.
  Array<Patch> start(std::span<const Vector3> positions, std::span<const mesh::Triangle> triangles) {
    Array<Sample> samples(positions.size(), host_.memory);
    for (const mesh::Triangle& t : triangles) {
      for (const Index v : t)
        samples[v].near = 0;
    }
    constexpr std::size_t piece = 256;
    base::parallel_pieces(host_, hausdorff_distance_phase, positions.size(), piece,
                          [&](std::size_t begin, std::size_t end) {
                            Index near = no_index;
                            for (std::size_t v = begin; v < end; ++v) {
                              if (samples[v].near == no_index) continue;
                              samples[v] = sample(positions[v], near);
                              near = samples[v].near;
                            }
                          });
    for (const Sample& s : samples)
      most_ = std::max(most_, s.distance);
    Array<Patch> doubtful(host_.memory);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      if (i % 4096 == 0) host_.report(hausdorff_distance_phase, i, triangles.size());
      const mesh::Triangle& t = triangles[i];
      const std::array<Sample, 3> corners{samples[t[0]], samples[t[1]], samples[t[2]]};
      const double bound = bound_of(corners);
      if (in_doubt(bound)) doubtful.push_back({corners, bound});
    }
    return doubtful;
  }

  // The longest edge in two.
  void halve(const Patch& patch) {
    std::size_t longest = 0;
    double most = -1;
    for (std::size_t i = 0; i < 3; ++i) {
      const double length = (patch.corners[(i + 1) % 3].position - patch.corners[i].position).squaredNorm();
      if (length > most) {
        most = length;
        longest = i;
      }
    }
    const Sample &a = patch.corners[longest], &b = patch.corners[(longest + 1) % 3],
                 &c = patch.corners[(longest + 2) % 3];
    const Sample middle = sample(0.5 * (a.position + b.position), a.near);
    most_ = std::max(most_, middle.distance);
    for (const auto& half : {std::array<Sample, 3>{a, middle, c}, std::array<Sample, 3>{middle, b, c}}) {
      const double bound = bound_of(half);
      if (in_doubt(bound)) open_.push({half, bound});
    }
  }

  const mesh::SurfaceSearch& other_;
  const double tolerance_, floor_;
  const base::Host& host_;
  base::Heap<Patch, std::less<>> open_;
  double most_ = 0;
};

}  // namespace

double hausdorff_distance(std::span<const Vector3> positions, std::span<const mesh::Triangle> triangles,
                          std::span<const Vector3> other_positions, std::span<const mesh::Triangle> other_triangles,
                          double tolerance, const base::Host& host) {
  const mesh::SurfaceSearch search(positions, triangles, host);
  const mesh::SurfaceSearch other(other_positions, other_triangles, host);
  mesh::Box box;
  for (const mesh::Triangle& t : other_triangles) {
    for (const Index v : t)
      box.add(other_positions[v]);
  }
  constexpr double rounding = 1e-12;  // of the diagonal: smaller distances are taken for 0
  const double floor = rounding * (box.high - box.low).norm();
  const double there = OneWay(other, tolerance, floor, host).largest(positions, triangles, 0);
  return OneWay(search, tolerance, floor, host).largest(other_positions, other_triangles, there);
}

}  // namespace orbicube::hexmesh
