// Flat meshes of 100 to 5000 triangles whose fixed boundary is known to allow positive triangles, for tests and bench.
// Of the first four families a positive map is kept (`known`). Boundaries of the last are star-shaped polygons, which
// allow one after edges between boundary vertices are split.
#pragma once

#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "flat_cases.h"

namespace orbicube::untangle::test {

struct FeasibleFlat : FlatCase {
  std::vector<Vector2d> known;  // empty: only a mesh with split edges has a positive map
  Vector2d kernel{0, 0};        // of a star-shaped polygon: sees all of the boundary
};

constexpr std::size_t flat_family_count = 5;
constexpr const char* flat_families[] = {"twist", "fold", "handle", "star", "star split"};

// Squares of a grid, of which each is cut along one of its diagonals at random. `lattice` has integer coordinates.
struct Lattice {
  std::vector<Vector2d> lattice;
  std::vector<Triangle> triangles;
  std::vector<std::uint8_t> boundary;

  // Those squares of columns x rows that `has` accepts; with `ring` the last column is before the first one.
  Lattice(int columns, int rows, bool ring, base::Random& random, const std::function<bool(int, int)>& has) {
    std::vector<Index> number(static_cast<std::size_t>((columns + 1) * (rows + 1)), no_index);
    const auto at = [&](int x, int y) {
      if (ring) x %= columns;
      Index& n = number[static_cast<std::size_t>(y * (columns + 1) + x)];
      if (n == no_index) {
        n = static_cast<Index>(lattice.size());
        lattice.emplace_back(x, y);
      }
      return n;
    };
    for (int y = 0; y < rows; ++y) {
      for (int x = 0; x < columns; ++x) {
        if (!has(x, y)) continue;
        const Index p = at(x, y), q = at(x + 1, y), r = at(x + 1, y + 1), s = at(x, y + 1);
        if (random.below(2) == 0)
          triangles.insert(triangles.end(), {{p, q, r}, {p, r, s}});
        else
          triangles.insert(triangles.end(), {{p, q, s}, {q, r, s}});
      }
    }
    const base::Host host;
    const auto found = boundary_vertices(triangles, lattice.size(), host);
    boundary.assign(found.begin(), found.end());
  }
};

// The number of squares of an edge so that about 100 to 5000 triangles fill `part` edges squared.
inline int random_edge(base::Random& random, double part) {
  const double triangles = 100 * std::pow(50, random.unit());
  return std::max(3, static_cast<int>(std::ceil(std::sqrt(triangles / (2 * part)))));
}

// A start: boundary vertices at `placed`, others strewn over the box, collapsed to a vertex, where they rest, or
// folded.
inline void tangle(FeasibleFlat& c, const Lattice& mesh, const std::vector<Vector2d>& placed, std::size_t how,
                   base::Random& random) {
  c.start = placed;
  for (const std::uint8_t on : mesh.boundary)
    c.fixed.insert(c.fixed.end(), 2, on);
  if (how == 0) strew(c, random.next());
  const Vector2d point = placed[random.below(placed.size())];
  for (std::size_t v = 0; v < placed.size(); ++v) {
    if (c.is_fixed(v)) continue;
    if (how == 1) c.start[v] = point;
    if (how == 2) c.start[v] = c.rest[v].head<2>();
  }
}

// Rest positions: those of the lattice, inner ones pushed by up to a fifth of an edge a coordinate.
inline std::vector<Vector3> rest_of(const Lattice& mesh, base::Random& random) {
  std::vector<Vector3> rest;
  for (std::size_t v = 0; v < mesh.lattice.size(); ++v) {
    rest.emplace_back(mesh.lattice[v].x(), mesh.lattice[v].y(), 0);
    for (Eigen::Index a = 0; a < 2 && mesh.boundary[v] == 0; ++a)
      rest[v][a] += 0.4 * (random.unit() - 0.5);
  }
  return rest;
}

inline Vector2d polar(double radius, double angle) {
  return radius * Vector2d(std::cos(angle), std::sin(angle));
}

// A ring whose inner circle is turned, by up to .9 of what its rings of vertices allow.
inline FeasibleFlat twist(base::Random& random) {
  const int rows = random_edge(random, 4), columns = 4 * rows;
  const Lattice mesh(columns, rows, true, random, [](int, int) { return true; });
  FeasibleFlat c;
  const double growth = 1 + 2 * std::numbers::pi / columns, half = std::numbers::pi / columns;
  // The base of a triangle is a chord, and its apex has to be beyond.
  const double most = std::acos(std::cos(half) / growth) - half;
  const double turn = rows * most * (0.3 + 0.6 * random.unit());
  for (const Vector2d& p : mesh.lattice) {
    const double radius = std::pow(growth, p.y()), angle = 2 * half * p.x();
    const Vector2d at = polar(radius, angle);
    c.rest.emplace_back(at.x(), at.y(), 0);
    // Clockwise seen from the middle: x is the first axis of the lattice.
    c.known.push_back(polar(radius, angle + turn * p.y() / rows));
  }
  c.triangles = mesh.triangles;
  for (Triangle& t : c.triangles)
    std::swap(t[1], t[2]);
  tangle(c, mesh, c.known, random.below(3), random);
  return c;
}

// A strip that is bent, whose inner vertices are folded back and forth along it.
inline FeasibleFlat fold(base::Random& random) {
  const int rows = random_edge(random, 4), columns = 4 * rows;
  const Lattice mesh(columns, rows, false, random, [](int, int) { return true; });
  FeasibleFlat c;
  const double angle = (0.3 + 1.6 * random.unit()) * std::numbers::pi, gap = 0.2 * rows;
  const auto bend = [&](Vector2d p) { return polar(gap + p.y(), -angle * p.x() / columns); };
  const double period = columns * (0.2 + 0.6 * random.unit());
  c.rest = rest_of(mesh, random);
  std::vector<Vector2d> folded;
  for (const Vector2d& p : mesh.lattice) {
    c.known.push_back(bend(p));
    folded.push_back(bend({std::abs(p.x() - period * std::round(p.x() / period)), p.y()}));
  }
  c.triangles = mesh.triangles;
  tangle(c, mesh, c.known, 3, random);
  for (std::size_t v = 0; v < folded.size(); ++v)
    if (!c.is_fixed(v)) c.start[v] = folded[v];
  return c;
}

// A plate with a limb or a closed handle of a third of its width, which is 2 to 40 times as thin in the map.
inline FeasibleFlat handle(base::Random& random) {
  const bool closed = random.below(2) == 0;
  const int third = std::max(2, random_edge(random, closed ? 10 : 6));
  const int rows = third * (closed ? 4 : 3);
  const Lattice mesh(3 * third, rows, false, random, [&](int x, int y) {
    const bool body = y < third || (closed && y >= 3 * third);
    return body || (x >= third && x < 2 * third) || (closed && x < third / 2 + 1);
  });
  FeasibleFlat c;
  const double thin = std::pow(20, random.unit()) * 2, middle = 1.5 * third;
  c.rest = rest_of(mesh, random);
  for (Vector2d p : mesh.lattice) {
    const double up = p.y() - third, down = closed ? 3 * third - p.y() : up;
    const bool limb = p.x() >= third && p.x() <= 2 * third && up > 0 && down > 0;
    if (limb) p.x() = middle + (p.x() - middle) / thin;
    c.known.push_back(p);
  }
  c.triangles = mesh.triangles;
  tangle(c, mesh, c.known, random.below(3), random);
  return c;
}

// A disk of rings around a vertex, whose circles become star-shaped polygons with radii from 1 to up to 15.
inline FeasibleFlat star(base::Random& random) {
  const int rows = random_edge(random, 4), columns = 4 * rows;
  const Lattice mesh(columns, rows, true, random, [](int, int) { return true; });
  FeasibleFlat c;
  const double longest = 1 + 14 * random.unit();
  std::vector<double> radius;
  for (int i = 0; i < columns; ++i)
    radius.push_back(1 + (longest - 1) * (i % 2 == 0 ? random.unit() * random.unit() : random.unit()));
  for (const Vector2d& p : mesh.lattice) {
    const double angle = 2 * std::numbers::pi * p.x() / columns;
    const Vector2d at = polar(p.y() + 1, angle);
    c.rest.emplace_back(at.x(), at.y(), 0);
    c.known.push_back(radius[static_cast<std::size_t>(p.x())] * at);
  }
  c.triangles = mesh.triangles;
  for (Triangle& t : c.triangles)
    std::swap(t[1], t[2]);
  Lattice disk = mesh;
  const auto inner = [&](Index v) { return mesh.lattice[v].y() == 0; };
  const auto middle = static_cast<Index>(c.known.size());
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k)
      if (inner(t[k]) && inner(t[(k + 1) % 3])) c.triangles.push_back({t[k], t[(k + 1) % 3], middle});
  }
  for (std::size_t v = 0; v < mesh.lattice.size(); ++v)
    disk.boundary[v] = mesh.lattice[v].y() == rows;
  disk.boundary.push_back(0);
  c.rest.emplace_back(0, 0, 0);
  c.known.emplace_back(0, 0);
  tangle(c, disk, c.known, random.below(3), random);
  return c;
}

// Boundary vertices in their order, counter-clockwise.
inline std::vector<Index> boundary_loop(const std::vector<Triangle>& triangles, std::size_t vertices) {
  std::vector<Index> next(vertices, no_index), loop;
  std::vector<std::pair<Index, Index>> edges;
  for (const Triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k)
      edges.emplace_back(t[k], t[(k + 1) % 3]);
  std::sort(edges.begin(), edges.end());
  for (const auto& [a, b] : edges)
    if (!std::binary_search(edges.begin(), edges.end(), std::pair(b, a))) next[a] = b;
  const auto first =
      static_cast<Index>(std::find_if(next.begin(), next.end(), [](Index v) { return v != no_index; }) - next.begin());
  for (Index v = first; loop.empty() || v != first; v = next[v])
    loop.push_back(v);
  return loop;
}

// A square, a T or a strip onto a polygon of 3 to 12 corners at unlike distances from a point, by arc length:
// triangles and edges have all of their vertices on one side of the polygon, or cross its reflex corners.
inline FeasibleFlat star_split(base::Random& random) {
  const std::size_t shape = random.below(3);
  const int edge = random_edge(random, shape == 0 ? 1 : shape == 1 ? 5 : 9);
  const int columns = shape == 1 ? 3 * edge : edge, rows = shape == 0 ? edge : shape == 1 ? 3 * edge : 9 * edge;
  const Lattice mesh(columns, rows, false, random,
                     [&](int x, int y) { return shape != 1 || y < edge || (x >= edge && x < 2 * edge); });
  FeasibleFlat c;
  const std::size_t corners = 3 + random.below(10);
  const double longest = 1 + 5 * random.unit(), first = 2 * std::numbers::pi * random.unit();
  std::vector<Vector2d> polygon;
  for (std::size_t k = 0; k < corners; ++k) {
    const double angle =
        first + 2 * std::numbers::pi * (static_cast<double>(k) + 0.4 * random.unit()) / static_cast<double>(corners);
    polygon.push_back(polar(k % 2 == 0 ? longest : 1, angle));
  }
  c.rest = rest_of(mesh, random);
  c.triangles = mesh.triangles;
  const std::vector<Index> loop = boundary_loop(c.triangles, mesh.lattice.size());
  std::vector<Vector2d> placed = mesh.lattice;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const double t = static_cast<double>(i * corners) / static_cast<double>(loop.size());
    const auto k = static_cast<std::size_t>(t);
    placed[loop[i]] = polygon[k] + (t - static_cast<double>(k)) * (polygon[(k + 1) % corners] - polygon[k]);
  }
  for (std::size_t v = 0; v < placed.size(); ++v)
    if (mesh.boundary[v] == 0) placed[v] *= 1.0 / columns;
  tangle(c, mesh, placed, random.below(3), random);
  return c;
}

// Case `seed` of a family. The same for every run.
inline FeasibleFlat feasible_flat(std::size_t family, std::uint64_t seed) {
  base::Random random(1000 * family + seed);
  constexpr FeasibleFlat (*makers[])(base::Random&) = {twist, fold, handle, star, star_split};
  FeasibleFlat c = makers[family](random);
  c.name = flat_families[family];
  return c;
}

}  // namespace orbicube::untangle::test
