// A k-d tree over points (Bentley 1975): which of them is nearest to another. The tree is a permutation of the points,
// each node the median of its part along the longest side of the part's box.
#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "base/host.h"
#include "harmonics/functions/basis.h"

namespace orbicube::harmonics {

class PointTree {
 public:
  // Copies the points. O(n log n).
  PointTree(std::span<const Vector3> points, const base::Host& host);

  // Squared distance from p to the nearest point; infinite when there is none. O(log n) on average.
  double nearest_square(const Vector3& p) const {
    double best = std::numeric_limits<double>::infinity();
    search(0, points_.size(), p, best);
    return best;
  }

 private:
  void build(std::size_t begin, std::size_t end, const base::Host& host);
  void search(std::size_t begin, std::size_t end, const Vector3& p, double& best) const;

  Array<Vector3> points_;
  Array<std::uint8_t> axis_;  // along which the node at this place splits
};

}  // namespace orbicube::harmonics
