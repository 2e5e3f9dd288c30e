#include "sphere_map/sampling/grids.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "base/error.h"

namespace orbicube::sphere_map {
namespace {

constexpr double pi = std::numbers::pi;

// The icosahedron's edges, each cut into 2^levels, and the triangles' insides. Vertices: the corners, then those on the
// edges, then those inside, so that each has one number without a search.
class Icosphere {
 public:
  Icosphere(std::size_t levels, const base::Host& host)
      : host_(host), n_(std::size_t{1} << levels), grid_(host.memory) {}

  Grid make() {
    place_corners();
    grid_.directions.resize(10 * n_ * n_ + 2);
    for (std::size_t edge = 0; edge < 30; ++edge) {
      const auto [a, b] = edges_[edge];
      for (std::size_t i = 1; i < n_; ++i)
        grid_.directions[12 + edge * (n_ - 1) + i - 1] = on_arc(grid_.directions[a], grid_.directions[b], i, n_);
    }
    grid_.triangles.reserve(20 * n_ * n_);
    for (std::size_t face = 0; face < 20; ++face)
      fill(face);
    return std::move(grid_);
  }

 private:
  // Two poles and two rings of five. All of them are corners of golden rectangles.
  void place_corners() {
    grid_.directions.push_back(Vector3::UnitZ());
    const double height = 1 / std::sqrt(5.0);
    for (int ring = 0; ring < 2; ++ring) {
      for (int k = 0; k < 5; ++k) {
        const double angle = 2 * pi * (k + 0.5 * ring) / 5;
        const double z = ring == 0 ? height : -height;
        grid_.directions.push_back(Vector3(2 * height * std::cos(angle), 2 * height * std::sin(angle), z).normalized());
      }
    }
    grid_.directions.push_back(-Vector3::UnitZ());
    const auto upper = [](std::size_t k) { return static_cast<Index>(1 + k % 5); };
    const auto lower = [](std::size_t k) { return static_cast<Index>(6 + k % 5); };
    for (std::size_t k = 0; k < 5; ++k) {
      const std::size_t f = 4 * k;
      faces_[f] = {0, upper(k), upper(k + 1)};
      faces_[f + 1] = {upper(k), lower(k), upper(k + 1)};
      faces_[f + 2] = {lower(k), lower(k + 1), upper(k + 1)};
      faces_[f + 3] = {11, lower(k + 1), lower(k)};
    }
    std::size_t count = 0;
    for (const auto& face : faces_) {
      for (std::size_t s = 0; s < 3; ++s) {
        if (face[s] < face[(s + 1) % 3]) edges_[count++] = {face[s], face[(s + 1) % 3]};
      }
    }
  }

  // The point i / n of the way along the great circle from a to b.
  static Vector3 on_arc(const Vector3& a, const Vector3& b, std::size_t i, std::size_t n) {
    const double t = static_cast<double>(i) / static_cast<double>(n);
    const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
    return (std::sin((1 - t) * angle) * a + std::sin(t * angle) * b).normalized();
  }

  // The vertex i / n along the edge from a to b.
  Index on_edge(Index a, Index b, std::size_t i) const {
    if (i == 0) return a;
    if (i == n_) return b;
    for (std::size_t edge = 0; edge < 30; ++edge) {
      if (edges_[edge] == std::array{a, b}) return static_cast<Index>(12 + edge * (n_ - 1) + i - 1);
      if (edges_[edge] == std::array{b, a}) return static_cast<Index>(12 + edge * (n_ - 1) + n_ - i - 1);
    }
    throw base::Error("internal", "an edge that the icosahedron has not");
  }

  // Row i of a face goes from its first side to its last one, and has i + 1 vertices.
  void fill(std::size_t face) {
    const auto [a, b, c] = faces_[face];
    const std::size_t inside = n_ < 3 ? 0 : (n_ - 1) * (n_ - 2) / 2;
    std::size_t next_inside = 12 + 30 * (n_ - 1) + face * inside;
    Array<Index> above(host_.memory), row(host_.memory);
    for (std::size_t i = 0; i <= n_; ++i) {
      host_.report("making the icosphere", face * (n_ + 1) + i, 20 * (n_ + 1));
      row.clear();
      const Index first = on_edge(a, b, i);
      const Index last = on_edge(a, c, i);
      row.push_back(first);
      for (std::size_t j = 1; j < i; ++j) {
        if (i == n_) {
          row.push_back(on_edge(b, c, j));
          continue;
        }
        row.push_back(static_cast<Index>(next_inside));
        // The mean of the points on the three great circles of the barycentric coordinates.
        const Vector3 &A = grid_.directions[a], &B = grid_.directions[b], &C = grid_.directions[c];
        const Vector3 x = on_arc(on_arc(A, B, i, n_), on_arc(A, C, i, n_), j, i);
        const Vector3 y = on_arc(on_arc(C, B, i - j, n_), on_arc(A, B, i - j, n_), n_ - i, n_ - i + j);
        const Vector3 z = on_arc(on_arc(A, C, j, n_), on_arc(B, C, j, n_), i - j, n_ - j);
        grid_.directions[next_inside++] = (x + y + z).normalized();
      }
      if (i > 0) row.push_back(last);
      for (std::size_t j = 0; j < i; ++j) {
        grid_.triangles.push_back({above[j], row[j], row[j + 1]});
        if (j + 1 < i) grid_.triangles.push_back({above[j], row[j + 1], above[j + 1]});
      }
      std::swap(above, row);
    }
  }

  const base::Host& host_;
  std::size_t n_;
  Grid grid_;
  std::array<Triangle, 20> faces_;
  std::array<std::array<Index, 2>, 30> edges_;
};

// The lattice point as a direction: angles of equal size along each edge.
Vector3 on_cube(const std::array<std::size_t, 3>& lattice, std::size_t n) {
  Vector3 d;
  for (std::size_t k = 0; k < 3; ++k) {
    // Differences of whole numbers, so that the grid is symmetric to the bit.
    const double x = static_cast<double>(lattice[k]) - static_cast<double>(n - lattice[k]);
    d[static_cast<Eigen::Index>(k)] = lattice[k] == 0   ? -1
                                      : lattice[k] == n ? 1
                                                        : std::tan(0.25 * pi * x / static_cast<double>(n));
  }
  return d.normalized();
}

Grid cube_grid(std::size_t n, const base::Host& host) {
  Grid grid(host.memory);
  grid.directions.resize(6 * n * n + 2);
  grid.triangles.reserve(12 * n * n);
  for (std::size_t face = 0; face < 6; ++face) {
    const std::size_t axis = face / 2;
    for (std::size_t v = 0; v <= n; ++v) {
      host.report("making the cube", face * n + v, 6 * n + 1);
      for (std::size_t u = 0; u <= n; ++u) {
        const auto vertex = [&](std::size_t along, std::size_t across) {
          std::array<std::size_t, 3> lattice;
          lattice[axis] = face % 2 == 0 ? n : 0;
          lattice[(axis + 1) % 3] = face % 2 == 0 ? along : n - along;
          lattice[(axis + 2) % 3] = across;
          return lattice;
        };
        const auto index = [&](std::size_t along, std::size_t across) {
          const auto [i, j, k] = vertex(along, across);
          return cube_vertex(n, i, j, k);
        };
        grid.directions[index(u, v)] = on_cube(vertex(u, v), n);
        if (u == n || v == n) continue;
        // Diagonals towards the middle of the face, the shorter ones on the sphere.
        const bool rising = (2 * u < n) == (2 * v < n);
        const Index a = index(u, v), b = index(u + 1, v), c = index(u + 1, v + 1), d = index(u, v + 1);
        if (rising) {
          grid.triangles.insert(grid.triangles.end(), {Triangle{a, b, c}, Triangle{a, c, d}});
        } else {
          grid.triangles.insert(grid.triangles.end(), {Triangle{a, b, d}, Triangle{b, c, d}});
        }
      }
    }
  }
  return grid;
}

Grid latitude_grid(std::size_t bands, const base::Host& host) {
  Grid grid(host.memory);
  const std::size_t around = 2 * bands;
  const auto vertex = [&](std::size_t row, std::size_t column) {  // row 0 and `bands` are the poles
    return static_cast<Index>(1 + (row - 1) * around + column % around);
  };
  const auto south = static_cast<Index>(1 + (bands - 1) * around);
  grid.directions.push_back(Vector3::UnitZ());
  for (std::size_t row = 1; row < bands; ++row) {
    host.report("making the rows of latitude", row, bands);
    const double polar = pi * static_cast<double>(row) / static_cast<double>(bands);
    for (std::size_t column = 0; column < around; ++column) {
      const double longitude = 2 * pi * static_cast<double>(column) / static_cast<double>(around);
      grid.directions.push_back(
          Vector3(std::sin(polar) * std::cos(longitude), std::sin(polar) * std::sin(longitude), std::cos(polar))
              .normalized());
    }
  }
  grid.directions.push_back(-Vector3::UnitZ());
  for (std::size_t column = 0; column < around; ++column) {
    grid.triangles.push_back({0, vertex(1, column), vertex(1, column + 1)});
    for (std::size_t row = 1; row + 1 < bands; ++row) {
      const Index a = vertex(row, column), b = vertex(row + 1, column);
      const Index c = vertex(row + 1, column + 1), d = vertex(row, column + 1);
      grid.triangles.insert(grid.triangles.end(), {Triangle{a, b, c}, Triangle{a, c, d}});
    }
    grid.triangles.push_back({south, vertex(bands - 1, column + 1), vertex(bands - 1, column)});
  }
  return grid;
}

Grid octahedron_grid(std::size_t n, const base::Host& host) {
  Grid grid(host.memory);
  grid.directions.resize(n * n + 2);
  grid.triangles.reserve(2 * n * n);
  const auto whole = static_cast<std::ptrdiff_t>(n);
  for (std::size_t row = 0; row <= n; ++row) {
    host.report("making the octahedron", row, n + 1);
    for (std::size_t column = 0; column <= n; ++column) {
      // In units of half a quad: |x| + |y| <= n is the upper half, the corners beyond fold down.
      const std::ptrdiff_t x = 2 * static_cast<std::ptrdiff_t>(column) - whole;
      const std::ptrdiff_t y = whole - 2 * static_cast<std::ptrdiff_t>(row);
      const std::ptrdiff_t z = whole - std::abs(x) - std::abs(y);
      const auto folded = [&](std::ptrdiff_t a, std::ptrdiff_t b) {
        return z >= 0 ? a : (whole - std::abs(b)) * (a >= 0 ? 1 : -1);
      };
      grid.directions[octahedron_vertex(n, column, row)] =
          Vector3(static_cast<double>(folded(x, y)), static_cast<double>(folded(y, x)), static_cast<double>(z))
              .normalized();
      if (row == n || column == n) continue;
      const Index a = octahedron_vertex(n, column, row + 1), b = octahedron_vertex(n, column + 1, row + 1);
      const Index c = octahedron_vertex(n, column + 1, row), d = octahedron_vertex(n, column, row);
      // Diagonals along the folds.
      const bool rising = (2 * column < n) == (2 * row < n);
      if (rising) {
        grid.triangles.insert(grid.triangles.end(), {Triangle{a, b, c}, Triangle{a, c, d}});
      } else {
        grid.triangles.insert(grid.triangles.end(), {Triangle{a, b, d}, Triangle{b, c, d}});
      }
    }
  }
  return grid;
}

}  // namespace

ResolutionRange resolutions(GridKind kind) {
  switch (kind) {
    case GridKind::icosphere:
      return {0, 10};
    case GridKind::cube:
      return {1, 4096};
    case GridKind::latitude:
      return {2, 8192};
    case GridKind::octahedron:
      return {2, 8192};
  }
  throw base::Error("invalid-argument", "unknown kind of grid");
}

Grid make_grid(GridKind kind, std::size_t resolution, const base::Host& host) {
  const auto [least, greatest] = resolutions(kind);
  if (resolution < least || resolution > greatest) {
    throw base::Error("invalid-argument", "the resolution of this grid is from " + std::to_string(least) + " to " +
                                              std::to_string(greatest) + ", not " + std::to_string(resolution));
  }
  switch (kind) {
    case GridKind::icosphere:
      return Icosphere(resolution, host).make();
    case GridKind::cube:
      return cube_grid(resolution, host);
    case GridKind::latitude:
      return latitude_grid(resolution, host);
    default:
      if (resolution % 2 != 0)
        throw base::Error("invalid-argument", "the resolution of the octahedron is an even number");
      return octahedron_grid(resolution, host);
  }
}

// The bottom layer, a ring of 4 n for each layer between, the top layer.
Index cube_vertex(std::size_t n, std::size_t i, std::size_t j, std::size_t k) {
  const std::size_t layer = (n + 1) * (n + 1);
  if (k == 0) return static_cast<Index>(i + (n + 1) * j);
  if (k == n) return static_cast<Index>(layer + 4 * n * (n - 1) + i + (n + 1) * j);
  const std::size_t round = j == 0 ? i : i == n ? n + j : j == n ? 3 * n - i : 4 * n - j;
  return static_cast<Index>(layer + 4 * n * (k - 1) + round);
}

// The corners, the inside, then half of each side: a side is folded in its middle.
Index octahedron_vertex(std::size_t n, std::size_t column, std::size_t row) {
  const bool at_side = column == 0 || column == n;
  const bool at_end = row == 0 || row == n;
  if (at_side && at_end) return 0;
  if (!at_side && !at_end) return static_cast<Index>(1 + (row - 1) * (n - 1) + column - 1);
  const std::size_t along = at_end ? std::min(column, n - column) : std::min(row, n - row);  // 1 to n / 2
  const std::size_t side = at_end ? (row == 0 ? 0 : 1) : (column == 0 ? 2 : 3);
  return static_cast<Index>(1 + (n - 1) * (n - 1) + side * (n / 2) + along - 1);
}

}  // namespace orbicube::sphere_map
