#include "sphere_map/sampling/locator.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <string>

#include "base/counted.h"
#include "base/error.h"
#include "base/grouping.h"
#include "mesh/search/predicates.h"
#include "sphere_map/optimization/measure.h"

namespace orbicube::sphere_map {

using CubePoint = Locator::CubePoint;

namespace {

// Cells with more vertices are cut in four.
constexpr std::size_t most_in_cell = 4;
constexpr Index has_children = Index{1} << 31U;
// Of the coordinates on a face of the cube, which are whole numbers below 2^this.
constexpr unsigned coordinate_bits = 52;

CubePoint on_cube(const Vector3& d) {
  Eigen::Index axis = 0;
  const double size = d.cwiseAbs().maxCoeff(&axis);
  constexpr double last = 0x1p52 - 1;
  const auto coordinate = [&](Eigen::Index k) {
    return static_cast<std::uint64_t>(std::min((0.5 + 0.5 * (d[k] / size)) * 0x1p52, last));
  };
  return {static_cast<unsigned>(2 * axis + (d[axis] < 0)), coordinate((axis + 1) % 3), coordinate((axis + 2) % 3)};
}

// The direction of the middle of the cell whose lowest corner is `at`, 2^bits wide.
Vector3 middle_of(const CubePoint& at, unsigned bits) {
  const double half = std::ldexp(0.5, static_cast<int>(bits));
  const auto coordinate = [&](std::uint64_t x) { return 0x1p-51 * (static_cast<double>(x) + half) - 1; };
  Vector3 d;
  const Eigen::Index axis = at.face / 2;
  d[axis] = at.face % 2 == 0 ? 1 : -1;
  d[(axis + 1) % 3] = coordinate(at.x);
  d[(axis + 2) % 3] = coordinate(at.y);
  return d;
}

std::size_t child_of(const CubePoint& at, unsigned bits) {
  return (at.x >> bits & 1U) | (at.y >> bits & 1U) << 1U;
}

// Times a power of two, so that the largest coordinate is near 1 where that loses nothing: the filter of the predicates
// is best at equal lengths.
Vector3 balanced_length(const Vector3& d) {
  const double size = d.cwiseAbs().maxCoeff();
  if (size >= 0.25 && size <= 2) return d;
  const int exponent = std::ilogb(size);
  const auto scaled = [&](const Vector3& v, int by) -> Vector3 {
    return {std::scalbn(v.x(), by), std::scalbn(v.y(), by), std::scalbn(v.z(), by)};
  };
  const Vector3 result = scaled(d, -exponent);
  return scaled(result, exponent) == d ? result : d;
}

std::span<const Triangle> checked(std::span<const Triangle> triangles, std::span<const Vector3> directions) {
  if (triangles.empty()) throw base::Error("invalid-argument", "a map without triangles");
  if (triangles.size() >= has_children / 3)
    throw base::Error("unsupported", "a map of " + base::counted(triangles.size(), "triangle"));
  for (const Triangle& t : triangles) {
    for (const Index v : t) {
      if (v >= directions.size()) {
        throw base::Error("invalid-argument", "triangle index " + std::to_string(v) + " of " +
                                                  base::counted(directions.size(), "direction"));
      }
      require_direction(directions[v], "the direction of vertex", v);
      if (const double square = directions[v].squaredNorm(); !(square > 0.25 && square < 4))
        throw base::Error("invalid-argument", "the direction of vertex " + std::to_string(v) + " is far from length 1");
    }
  }
  return triangles;
}

}  // namespace

void require_direction(const Vector3& direction, const char* what, std::size_t number) {
  if (!direction.allFinite() || direction == Vector3::Zero()) {
    throw base::Error("invalid-argument", std::string(what) + " " + std::to_string(number) + " is zero or not finite");
  }
}

Locator::Locator(std::span<const Triangle> triangles, std::span<const Vector3> directions, const base::Host& host)
    : triangles_(checked(triangles, directions)),
      directions_(directions),
      connectivity_(directions.size(), triangles, host),
      longest_walk_(1000 + 8 * static_cast<std::size_t>(std::sqrt(static_cast<double>(triangles.size())))),
      cells_(host.memory) {
  require_bijection(host);
  build_cells(host);
}

// Sets orientation_ on the way.
void Locator::require_bijection(const base::Host& host) {
  std::size_t positive = 0;
  std::size_t negative = 0;
  double angle = 0;
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    if (t % 4096 == 0) host.report("checking the map", t, triangles_.size());
    for (std::size_t k = 0; k < 3; ++k) {
      if (connectivity_.opposite(static_cast<Index>(3 * t + k)) == mesh::no_index)
        throw base::Error("not-closed", "the map has a boundary at triangle " + std::to_string(t));
    }
    const Vector3& p = directions_[triangles_[t][0]];
    const Vector3& q = directions_[triangles_[t][1]];
    const Vector3& r = directions_[triangles_[t][2]];
    const int sign = mesh::orientation_from_origin(p, q, r);
    positive += sign > 0;
    negative += sign < 0;
    angle += solid_angle(p.normalized(), q.normalized(), r.normalized());
  }
  orientation_ = positive >= negative ? 1 : -1;
  if (const std::size_t good = std::max(positive, negative); good < triangles_.size()) {
    throw base::Error("invalid-argument", "the map is no bijection: " +
                                              base::counted(triangles_.size() - good, "triangle is", "triangles are") +
                                              " flipped or without area on the sphere");
  }
  // Where every triangle has the same sign, the sphere is covered a whole number of times.
  if (const double degree = std::abs(angle) / (4 * std::numbers::pi); degree > 1.5) {
    throw base::Error("invalid-argument",
                      "the map is no bijection: it covers the sphere " + base::counted(std::lround(degree), "time"));
  }
}

// The cells of the regular grid, enough of them that one has about one of `count` vertices.
void Locator::make_grid(std::size_t count) {
  level_ = 0;
  while (level_ < 12 && (std::size_t{6} << (2 * level_)) < count)
    ++level_;
  cells_.assign(std::size_t{6} << (2 * level_), 0);
}

// The cells that hold too many vertices get children, and so do these; then the triangle at the middle of each leaf.
void Locator::build_cells(const base::Host& host) {
  Array<CubePoint> points(host.memory);
  points.reserve(directions_.size());
  for (Index v = 0; v < directions_.size(); ++v) {
    if (connectivity_.outgoing(v) != mesh::no_index) points.push_back(on_cube(directions_[v]));
  }
  make_grid(points.size());
  const std::size_t cell_count = cells_.size();
  const unsigned cell_bits = coordinate_bits - level_;

  // The vertices in the order of their cells.
  Array<Index> begin(cell_count + 1, host.memory);
  Array<CubePoint> sorted(points.size(), CubePoint{}, host.memory);
  base::group_by_key(
      std::span(begin),
      [&](const auto& visit) {
        for (const CubePoint& p : points)
          visit(cell_of(p), p);
      },
      [](Index) {}, [&](Index at, const CubePoint& p) { sorted[at] = p; });

  Array<Cell> open(host.memory);
  Array<Leaf> leaves(host.memory);
  leaves.reserve(cell_count);
  for (std::size_t cell = 0; cell < cell_count; ++cell) {
    if (cell % 4096 == 0) host.report("building the grid", cell, cell_count);
    const std::size_t row = cell >> level_;
    const std::uint64_t side_mask = (std::uint64_t{1} << level_) - 1;
    const CubePoint corner{static_cast<unsigned>(row >> level_), (cell & side_mask) << cell_bits,
                           (row & side_mask) << cell_bits};
    open.push_back({static_cast<Index>(cell), corner, cell_bits, begin[cell], begin[cell + 1]});
    while (!open.empty()) {
      const Cell at = open.back();
      open.pop_back();
      if (at.end - at.begin <= most_in_cell || at.bits == 0 || cells_.size() + 4 >= has_children)
        leaves.push_back({at.number, middle_of(at.corner, at.bits)});
      else
        split(at, sorted, open);
    }
  }
  fill_leaves(leaves, host);
}

// Gives a cell four children, which go to `open`, and puts its vertices into their order.
void Locator::split(const Cell& at, std::span<CubePoint> sorted, Array<Cell>& open) {
  const auto place = static_cast<Index>(cells_.size());
  cells_.insert(cells_.end(), 4, 0);
  cells_[at.number] = has_children | place;
  const unsigned bits = at.bits - 1;
  auto from = sorted.begin() + static_cast<std::ptrdiff_t>(at.begin);
  const auto end = sorted.begin() + static_cast<std::ptrdiff_t>(at.end);
  for (Index child = 0; child < 4; ++child) {
    const auto to = std::partition(from, end, [&](const CubePoint& p) { return child_of(p, bits) == child; });
    const CubePoint below{at.corner.face, at.corner.x | std::uint64_t{child & 1U} << bits,
                          at.corner.y | std::uint64_t{child >> 1U} << bits};
    open.push_back({place + child, below, bits, static_cast<std::size_t>(from - sorted.begin()),
                    static_cast<std::size_t>(to - sorted.begin())});
    from = to;
  }
}

// Leaves that follow each other are neighbors, mostly, so that each walk from one to the next is short. The runs of
// them that are walked side by side start where a walk over their first leaves came by.
void Locator::fill_leaves(std::span<const Leaf> leaves, const base::Host& host) {
  constexpr std::size_t run = 256;
  constexpr std::size_t runs_at_once = 128;
  Array<Index> starts((leaves.size() + run - 1) / run, 0, host.memory);
  Index near = 0;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    if (i % 256 == 0) host.report("starts of the grid", i, starts.size());
    near = walk(leaves[i * run].middle, near).triangle;
    starts[i] = near;
  }
  for (std::size_t first = 0; first < starts.size(); first += runs_at_once) {
    host.report("filling the grid", first, starts.size());
    host.parallel_for(std::min(runs_at_once, starts.size() - first), [&](std::size_t i) {
      Index start = starts[first + i];
      const std::size_t end = std::min(leaves.size(), (first + i + 1) * run);
      for (std::size_t k = (first + i) * run; k < end; ++k) {
        start = walk(leaves[k].middle, start).triangle;
        cells_[leaves[k].cell] = start;
      }
    });
  }
}

std::size_t Locator::cell_of(const CubePoint& p) const {
  const unsigned bits = coordinate_bits - level_;
  return ((std::size_t{p.face} << level_ | p.y >> bits) << level_) | p.x >> bits;
}

Index Locator::start_near(const Vector3& direction) const {
  const CubePoint at = on_cube(direction);
  unsigned bits = coordinate_bits - level_;
  Index cell = cells_[cell_of(at)];
  while ((cell & has_children) != 0)
    cell = cells_[(cell & ~has_children) + child_of(at, --bits)];
  return cell;
}

// 1 where the direction is on the same side of the half-edge as its triangle.
int Locator::side(Index half_edge, const Vector3& direction) const {
  return orientation_ * mesh::orientation_from_origin(directions_[connectivity_.start(half_edge)],
                                                      directions_[connectivity_.end(half_edge)], direction);
}

WalkEnd Locator::walk(const Vector3& direction, Index start) const {
  const auto where = [&](Index half_edge) { return side(half_edge, direction); };
  const auto opposite = [&](Index half_edge) { return connectivity_.opposite(half_edge); };
  if (const auto found = walk_to(start, longest_walk_, where, opposite)) return *found;
  if (const auto found = scan_for(triangles_.size(), where)) return *found;
  throw base::Error("internal", "a direction is in no triangle of a bijection");
}

// Of the triangles that have the direction.
Index Locator::lowest(const WalkEnd& found) const {
  if (found.on_edges == 0) return found.triangle;
  Index least = found.triangle;
  if (const unsigned corner = found.corner(); corner < 3) {
    connectivity_.for_each_outgoing(triangles_[found.triangle][corner],
                                    [&](Index half_edge) { least = std::min(least, half_edge / 3); });
    return least;
  }
  const Index half_edge = 3 * found.triangle + static_cast<Index>(std::countr_zero(found.on_edges));
  return std::min(least, connectivity_.opposite(half_edge) / 3);
}

Location Locator::locate(const Vector3& direction) const {
  const Vector3 d = balanced_length(direction);
  WalkEnd found = walk(d, start_near(d));
  if (found.on_edges != 0) {
    if (const Index least = lowest(found); least != found.triangle) {
      found = {least, 0};
      for (Index k = 0; k < 3; ++k)
        found.on_edges |= static_cast<unsigned>(side(3 * least + k, d) == 0) << k;
    }
  }
  // The shares are det[d q r], det[d r p] and det[d p q], by differences from a point of the sphere, whose rounding
  // they survive best.
  const Triangle& t = triangles_[found.triangle];
  const double square = d.squaredNorm();
  const Vector3 x = std::abs(square - 1) < 1e-12 ? d : d.stableNormalized();
  const std::array<Vector3, 3> to = {directions_[t[0]] - x, directions_[t[1]] - x, directions_[t[2]] - x};
  Location result{found.triangle, Vector3::Zero()};
  for (unsigned k = 0; k < 3; ++k) {  // edge k is opposite of corner k + 2
    if ((found.on_edges >> k & 1U) != 0) continue;
    const double share = orientation_ * x.dot(to[k].cross(to[(k + 1) % 3]));
    result.weights[(k + 2) % 3] = std::max(share, 0.0);
  }
  const double sum = result.weights.sum();
  // Shares too small for double: the triangle is, and any point of it is as good.
  if (!(sum > 0)) {
    for (unsigned k = 0; k < 3; ++k)
      result.weights[(k + 2) % 3] = (found.on_edges >> k & 1U) != 0 ? 0 : 1;
    result.weights /= result.weights.sum();
    return result;
  }
  result.weights /= sum;
  return result;
}

}  // namespace orbicube::sphere_map
