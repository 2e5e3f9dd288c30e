#include "repair/wrap/wrap.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <memory_resource>
#include <string>
#include <unordered_map>

#include "base/error.h"
#include "mesh/search/measures.h"
#include "mesh/search/nearest.h"
#include "mesh/topology/tetrahedral_connectivity.h"
#include "repair/wrap/tetrahedra_of_cube.h"

namespace orbicube::repair {
namespace {

// Nodes beyond the box on each side, in cells: the offset, and one that is outside.
constexpr double margin = 3;
// Vertices stay at least this fraction of an edge away from its ends. Larger: better triangles; smaller: a level set
// nearer to the offset.
constexpr double end_fraction = 0.1;

class Grid {
 public:
  Grid(const Soup& soup, double offset, const base::Host& host)
      : soup_(soup), offset_(offset), host_(host), value_(host.memory), outside_(host.memory) {
    const mesh::Measures box = mesh::measures(soup.positions, soup.triangles, host);
    low_ = box.low.array() - margin * offset;
    double nodes = 1;
    for (int axis = 0; axis < 3; ++axis) {
      const double cells = std::ceil((box.high[axis] - box.low[axis]) / offset + 2 * margin);
      nodes *= cells + 1;
      if (!(nodes <= max_wrap_nodes)) refuse(box);
      size_[static_cast<std::size_t>(axis)] = static_cast<std::size_t>(cells) + 1;
    }
  }

  void run(Soup& result) {
    measure_distances();
    flood();
    extract(result);
  }

 private:
  [[noreturn]] void refuse(const mesh::Measures& box) const {
    const Vector3 side = box.high - box.low;
    // About: the margin counts for less the smaller the offset is.
    const double smallest = std::max(std::cbrt(side.prod() / max_wrap_nodes), side.maxCoeff() / max_wrap_nodes);
    throw base::Error("invalid-argument", "the offset " + std::to_string(offset_) +
                                              " of the wrap is too small for the grid; the smallest is about " +
                                              std::to_string(1.1 * smallest));
  }

  std::size_t count() const { return size_[0] * size_[1] * size_[2]; }
  std::size_t index(std::size_t x, std::size_t y, std::size_t z) const { return x + size_[0] * (y + size_[1] * z); }
  Vector3 place(std::size_t x, std::size_t y, std::size_t z) const {
    return low_ + offset_ * Vector3(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
  }

  // To the nearest triangle, where that is below two cells and the offset.
  void measure_distances() {
    constexpr float far = 1e30F;
    value_.assign(count(), far);
    for (std::size_t t = 0; t < soup_.triangles.size(); ++t) {
      if (t % 64 == 0) host_.report("wrapping", t, soup_.triangles.size());
      const Triangle& c = soup_.triangles[t];
      const Vector3 &a = soup_.positions[c[0]], &b = soup_.positions[c[1]], &d = soup_.positions[c[2]];
      std::array<std::size_t, 3> first{}, last{};
      for (int axis = 0; axis < 3; ++axis) {
        const double from = (std::min({a[axis], b[axis], d[axis]}) - low_[axis]) / offset_ - 2;
        const double to = (std::max({a[axis], b[axis], d[axis]}) - low_[axis]) / offset_ + 2;
        const auto k = static_cast<std::size_t>(axis);
        first[k] = static_cast<std::size_t>(std::max(0.0, std::floor(from)));
        last[k] = std::min(size_[k] - 1, static_cast<std::size_t>(std::ceil(to)));
      }
      Vector3 normal = (b - a).cross(d - a).stableNormalized();
      for (std::size_t z = first[2]; z <= last[2]; ++z) {
        host_.report("wrapping", t, soup_.triangles.size());
        for (std::size_t y = first[1]; y <= last[1]; ++y) {
          for (std::size_t x = first[0]; x <= last[0]; ++x) {
            const Vector3 p = place(x, y, z);
            float& value = value_[index(x, y, z)];
            // Nodes far from the plane are quickly done with.
            if (std::abs(normal.dot(p - a)) >= 2 * offset_) continue;
            value = std::min(value,
                             static_cast<float>((mesh::nearest_on_triangle(p, a, b, d).position - p).norm() / offset_));
          }
        }
      }
    }
  }

  // From the first node over edges of the tetrahedra to nodes that are farther than the offset.
  void flood() {
    outside_.assign(count(), 0);
    Array<std::size_t> open(1, 0, host_.memory);
    outside_[0] = 1;
    std::size_t done = 0;
    while (!open.empty()) {
      if (++done % 16384 == 0) host_.report("wrapping", done, count());
      const std::size_t node = open.back();
      open.pop_back();
      const std::size_t x = node % size_[0], y = node / size_[0] % size_[1], z = node / size_[0] / size_[1];
      for (std::size_t step = 1; step < 8; ++step) {
        const std::size_t dx = step & 1U, dy = step >> 1U & 1U, dz = step >> 2U;
        if (x + dx < size_[0] && y + dy < size_[1] && z + dz < size_[2]) enter(index(x + dx, y + dy, z + dz), open);
        if (x >= dx && y >= dy && z >= dz) enter(index(x - dx, y - dy, z - dz), open);
      }
    }
  }
  void enter(std::size_t node, Array<std::size_t>& open) {
    if (outside_[node] != 0 || !(value_[node] > 1)) return;
    outside_[node] = 1;
    open.push_back(node);
  }

  void extract(Soup& result) {
    std::pmr::unordered_map<std::uint64_t, Index> vertices(host_.memory);
    for (std::size_t z = 0; z + 1 < size_[2]; ++z) {
      for (std::size_t y = 0; y + 1 < size_[1]; ++y) {
        if (y % 16 == 0) host_.report("extracting the wrap", z, size_[2]);
        for (std::size_t x = 0; x + 1 < size_[0]; ++x) {
          std::array<std::size_t, 8> nodes{};
          std::size_t inside = 0;
          for (std::size_t k = 0; k < 8; ++k) {
            nodes[k] = index(x + (k & 1U), y + (k >> 1U & 1U), z + (k >> 2U));
            inside += outside_[nodes[k]] == 0;
          }
          if (inside == 0 || inside == 8) continue;
          for (const auto& t : tetrahedra_of_cube)
            add_tetrahedron({nodes[t[0]], nodes[t[1]], nodes[t[2]], nodes[t[3]]}, vertices, result);
        }
      }
    }
  }

  // The tetrahedron is positive. One corner or two are apart from the others; triangles face those outside.
  void add_tetrahedron(const std::array<std::size_t, 4>& t, std::pmr::unordered_map<std::uint64_t, Index>& vertices,
                       Soup& result) const {
    const auto outside = [&](std::size_t k) { return outside_[t[k]] != 0; };
    const auto at = [&](std::size_t k, std::size_t l) { return vertex(t[k], t[l], vertices, result); };
    const int count = outside(0) + outside(1) + outside(2) + outside(3);
    if (count == 1 || count == 3) {
      std::size_t apex = 0;
      while (outside(apex) != (count == 1))
        ++apex;
      const auto& face = mesh::face_corners[apex];
      const Index a = at(apex, face[0]), b = at(apex, face[1]), c = at(apex, face[2]);
      result.add_triangle(count == 1 ? Triangle{a, c, b} : Triangle{a, b, c}, no_index);
    } else if (count == 2) {
      for (const mesh::EdgeCorners& e : mesh::edge_corners) {
        if (!outside(e.start) || !outside(e.end)) continue;
        const Index a = at(e.start, e.first), b = at(e.start, e.second), c = at(e.end, e.second),
                    d = at(e.end, e.first);
        result.add_triangle({a, c, b}, no_index);
        result.add_triangle({a, d, c}, no_index);
      }
    }
  }

  // Where the distance is the offset on the edge from a node outside to one inside, or the other way round.
  Index vertex(std::size_t a, std::size_t b, std::pmr::unordered_map<std::uint64_t, Index>& vertices,
               Soup& result) const {
    if (a > b) std::swap(a, b);
    const auto [entry, is_new] =
        vertices.try_emplace(std::uint64_t{a} << 32U | b, static_cast<Index>(result.positions.size()));
    if (!is_new) return entry->second;
    const double from = std::min<double>(value_[a], 2) - 1, to = std::min<double>(value_[b], 2) - 1;
    const double along = from == to ? 0.5 : std::clamp(from / (from - to), end_fraction, 1 - end_fraction);
    const auto place_of = [&](std::size_t n) {
      return place(n % size_[0], n / size_[0] % size_[1], n / size_[0] / size_[1]);
    };
    result.add_vertex(place_of(a) + along * (place_of(b) - place_of(a)), no_index);
    return entry->second;
  }

  const Soup& soup_;
  double offset_;
  const base::Host& host_;
  Vector3 low_;
  std::array<std::size_t, 3> size_{};
  Array<float> value_;  // distance over the offset
  Array<std::uint8_t> outside_;
};

}  // namespace

WrapFigures wrap(Soup& soup, double offset, const Context& context) {
  Soup result(soup.memory());
  Grid(soup, offset, context.host).run(result);
  soup = std::move(result);
  return {soup.triangles.size(), offset};
}

}  // namespace orbicube::repair
