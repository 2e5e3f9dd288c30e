#include "hexmesh/certificate/surface_distance.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "mesh/search/nearest.h"

namespace orbicube::hexmesh {
namespace {

class SampledDistance {
 public:
  SampledDistance(std::span<const Vector3> positions, std::span<const mesh::Triangle> triangles,
                  const mesh::SurfaceSearch& other, double spacing, const base::Host& host)
      : positions_(positions), triangles_(triangles), other_(other), spacing_(spacing), host_(host) {}

  double largest() const {
    constexpr std::size_t pieces_at_once = 16;
    const Array<std::size_t> begin = pieces();
    std::array<double, pieces_at_once> farthest{};
    double most = 0;
    for (std::size_t first = 0; first + 1 < begin.size(); first += pieces_at_once) {
      host_.report("distance", first, begin.size());
      host_.parallel_for(std::min(pieces_at_once, begin.size() - 1 - first), [&](std::size_t p) {
        farthest[p] = farthest_of(begin[first + p], begin[first + p + 1], most);
      });
      most = *std::max_element(farthest.begin(), farthest.end());
    }
    return most;
  }

 private:
  // An edge of triangle i has one point more than that.
  int parts_of(std::size_t i) const {
    constexpr int max_parts = 60;
    const mesh::Triangle& t = triangles_[i];
    const Vector3 a = positions_[t[0]], b = positions_[t[1]] - a, c = positions_[t[2]] - a;
    const double longest = std::sqrt(std::max({b.squaredNorm(), c.squaredNorm(), (c - b).squaredNorm()}));
    return static_cast<int>(std::clamp(std::ceil(longest / spacing_), 1.0, double{max_parts}));
  }

  // Where the pieces begin, and the end. Each has about max_points points, so that a cancel takes effect within 50 ms.
  Array<std::size_t> pieces() const {
    constexpr int max_points = 1000;
    constexpr std::size_t max_triangles = 64;
    Array<std::size_t> begin(host_.memory);
    int points = max_points;
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
      const int parts = parts_of(i), own = (parts + 1) * (parts + 2) / 2;
      if (points + own > max_points || i - begin.back() == max_triangles) {
        begin.push_back(i);
        points = 0;
      }
      points += own;
    }
    begin.push_back(triangles_.size());
    return begin;
  }

  double farthest_of(std::size_t begin, std::size_t end, double most) const {
    double far = most;
    Index near = no_index;
    for (std::size_t i = begin; i < end; ++i) {
      const mesh::Triangle& t = triangles_[i];
      const Vector3 a = positions_[t[0]], b = positions_[t[1]] - a, c = positions_[t[2]] - a;
      const int parts = parts_of(i);
      for (int k = 0; k <= parts; ++k) {
        for (int l = 0; k + l <= parts; ++l) {
          const Vector3 x = a + (k * b + l * c) / parts;
          // What is near to the triangle of the point before is not the farthest, whatever else is nearer.
          if (near != no_index && other_.distance(near, x) <= far) continue;
          const mesh::SurfacePoint found = other_.nearest(x, near);
          near = found.triangle;
          far = std::max(far, found.distance);
        }
      }
    }
    return far;
  }

  std::span<const Vector3> positions_;
  std::span<const mesh::Triangle> triangles_;
  const mesh::SurfaceSearch& other_;
  const double spacing_;
  const base::Host& host_;
};

}  // namespace

double surface_distance(std::span<const Vector3> positions, std::span<const mesh::Triangle> triangles,
                        std::span<const Vector3> other_positions, std::span<const mesh::Triangle> other_triangles,
                        double spacing, const base::Host& host) {
  const mesh::SurfaceSearch search(positions, triangles, host);
  const mesh::SurfaceSearch other(other_positions, other_triangles, host);
  return std::max(SampledDistance(positions, triangles, other, spacing, host).largest(),
                  SampledDistance(other_positions, other_triangles, search, spacing, host).largest());
}

}  // namespace orbicube::hexmesh
