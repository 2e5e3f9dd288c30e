#include "mesh/search/hilbert_curve.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace orbicube::mesh {
namespace {

constexpr std::size_t points_between_reports = 16384;

struct Place {
  std::uint64_t key;
  Index point;
  auto operator<=>(const Place&) const = default;
};

}  // namespace

std::uint64_t hilbert_key(std::array<std::uint32_t, 3> x) {
  constexpr std::uint32_t highest = 1U << 20;
  for (std::uint32_t q = highest; q > 1; q >>= 1) {
    const std::uint32_t p = q - 1;
    for (std::size_t i = 0; i < 3; ++i) {
      if ((x[i] & q) != 0) {
        x[0] ^= p;
      } else {
        const std::uint32_t t = (x[0] ^ x[i]) & p;
        x[0] ^= t;
        x[i] ^= t;
      }
    }
  }
  x[1] ^= x[0];
  x[2] ^= x[1];
  std::uint32_t t = 0;
  for (std::uint32_t q = highest; q > 1; q >>= 1)
    t ^= (x[2] & q) != 0 ? q - 1 : 0;
  std::uint64_t key = 0;
  for (int bit = 20; bit >= 0; --bit) {
    for (const std::uint32_t c : x)
      key = key << 1 | ((c ^ t) >> bit & 1U);
  }
  return key;
}

base::Array<Index> hilbert_order(std::span<const Vector3> points, const base::Host& host) {
  Vector3 low = Vector3::Constant(HUGE_VAL), high = -low;
  for (const Vector3& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  // Halves, since the distance of two numbers may be beyond the range of double.
  const double size = points.empty() ? 1 : std::max((high / 2 - low / 2).maxCoeff(), 1e-300);
  base::Array<Place> places(points.size(), host.memory);
  for (Index i = 0; i < points.size(); ++i) {
    if (i % points_between_reports == 0) host.report("ordering points", i, points.size());
    const Vector3 unit = (points[i] / 2 - low / 2) / size;
    std::array<std::uint32_t, 3> cell{};
    for (std::size_t k = 0; k < 3; ++k)
      cell[k] = static_cast<std::uint32_t>(unit[static_cast<Eigen::Index>(k)] * ((1 << 21) - 1));
    places[i] = {hilbert_key(cell), i};
  }
  std::ranges::sort(places, std::less<>());
  base::Array<Index> order(points.size(), host.memory);
  for (std::size_t i = 0; i < places.size(); ++i)
    order[i] = places[i].point;
  return order;
}

}  // namespace orbicube::mesh
