// Meshes of 100 to 5000 tetrahedra whose fixed boundary is known to allow positive tetrahedra, for tests and bench. Of
// the first four families a positive map is kept (`known`). Boundaries of the last are star-shaped polyhedra, which
// allow one after what joins boundary vertices inside is split.
#pragma once

#include <functional>

#include "base/random.h"
#include "mesh/search/predicates.h"
#include "mesh/topology/conforming_tetrahedra.h"
#include "tangled_cases.h"

namespace orbicube::untangle::test {

struct FeasibleSolid : TangledCase {
  std::vector<Vector3> known;  // empty: only a mesh with split edges has a positive map
  Vector3 kernel{0, 0, 0};     // of a star-shaped polyhedron: sees all of the boundary
  std::vector<std::uint8_t> boundary;
};

constexpr std::size_t solid_family_count = 5;
constexpr const char* solid_families[] = {"twist", "fold", "handle", "star", "star split"};

inline std::size_t count_not_positive(const std::vector<Tetrahedron>& tetrahedra, const std::vector<Vector3>& p) {
  std::size_t count = 0;
  for (const Tetrahedron& t : tetrahedra)
    count += mesh::orientation_3d(p[t[0]], p[t[1]], p[t[2]], p[t[3]]) <= 0;
  return count;
}

// Cubes along a block's edge so that about 100 to 5000 tetrahedra fill the blocks.
inline int random_edge(base::Random& random, std::size_t blocks) {
  const double tetrahedra = 100 * std::pow(50, random.unit());
  return std::max(2, static_cast<int>(std::cbrt(tetrahedra / (6 * static_cast<double>(blocks)))));
}

// The mesh, and rest positions: those of the blocks, inner ones pushed by up to a tenth of an edge a coordinate.
inline FeasibleSolid solid_of(const BlockMesh& mesh, int n, base::Random& random) {
  FeasibleSolid c;
  c.tetrahedra = mesh.tetrahedra;
  c.rest = mesh.positions;
  for (std::size_t v = 0; v < c.rest.size(); ++v) {
    c.boundary.push_back(mesh.on_boundary(v));
    for (Eigen::Index a = 0; a < 3 && c.boundary[v] == 0; ++a)
      c.rest[v][a] += 0.2 / n * (random.unit() - 0.5);
  }
  return c;
}

// The boundary at `placed`, other vertices strewn over the box, collapsed to a vertex, where they rest, or at `placed`.
inline void tangle(FeasibleSolid& c, const std::vector<Vector3>& placed, std::size_t how, base::Random& random) {
  c.start = placed;
  Vector3 low = Vector3::Constant(1e30), high = -low;
  for (std::size_t v = 0; v < placed.size(); ++v) {
    c.fixed.insert(c.fixed.end(), 3, c.boundary[v]);
    if (c.boundary[v] == 0) continue;
    low = low.cwiseMin(placed[v]);
    high = high.cwiseMax(placed[v]);
  }
  const Vector3 point = placed[random.below(placed.size())];
  for (std::size_t v = 0; v < placed.size(); ++v) {
    if (c.boundary[v] != 0) continue;
    for (Eigen::Index a = 0; a < 3 && how == 0; ++a)
      c.start[v][a] = low[a] + random.unit() * (high[a] - low[a]);
    if (how == 1) c.start[v] = point;
    if (how == 2) c.start[v] = c.rest[v];
  }
}

// The image of the rest of a family that has a map of any strength; weaker until the map of the mesh is positive.
inline void place_known(FeasibleSolid& c, const std::vector<Vector3>& from, double strength,
                        const std::function<Vector3(const Vector3&, double)>& map) {
  for (;; strength *= 0.9) {
    c.known.clear();
    for (const Vector3& p : from)
      c.known.push_back(map(p, strength));
    if (count_not_positive(c.tetrahedra, c.known) == 0) return;
  }
}

// A bar of which each layer is turned against the last; in the start all of the turn is in one layer.
inline FeasibleSolid solid_twist(base::Random& random) {
  const auto blocks = 3 + random.below(3);
  const int n = random_edge(random, blocks);
  const BlockMesh mesh(bar(static_cast<int>(blocks)), n);
  FeasibleSolid c = solid_of(mesh, n, random);
  const double length = static_cast<double>(blocks);
  const auto turned = [&](const Vector3& p, double angle) {
    const Vector3 middle(0, 0.5, 0.5);
    return Vector3(Eigen::AngleAxisd(angle, Vector3::UnitX()) * (p - middle) + middle);
  };
  double used = 0;
  place_known(c, mesh.positions, (0.4 + 1.6 * random.unit()) * std::numbers::pi, [&](const Vector3& p, double angle) {
    used = angle;
    return turned(p, angle * p.x() / length);
  });
  const std::size_t how = random.below(4);
  tangle(c, c.known, how, random);
  for (std::size_t v = 0; v < c.start.size() && how == 3; ++v)
    if (c.boundary[v] == 0) c.start[v] = turned(c.rest[v], c.rest[v].x() > 0.5 * length ? used : 0);
  return c;
}

// A bent bar whose inner vertices are folded back and forth along it.
inline FeasibleSolid solid_fold(base::Random& random) {
  const auto blocks = 3 + random.below(3);
  const int n = random_edge(random, blocks);
  const BlockMesh mesh(bar(static_cast<int>(blocks)), n);
  FeasibleSolid c = solid_of(mesh, n, random);
  const double length = static_cast<double>(blocks), period = length * (0.25 + 0.5 * random.unit());
  double used = 0;
  const auto bent = [&](const Vector3& p, double angle) {
    const double radius = length / angle - p.y(), at = angle * p.x() / length;
    return Vector3(radius * std::sin(at), -radius * std::cos(at), p.z());
  };
  place_known(c, mesh.positions, std::min(0.8 * length, 1.8 * std::numbers::pi) * (0.3 + 0.7 * random.unit()),
              [&](const Vector3& p, double angle) { return bent(p, used = angle); });
  tangle(c, c.known, 3, random);
  for (std::size_t v = 0; v < c.start.size(); ++v) {
    Vector3 p = c.rest[v];
    p.x() = std::abs(p.x() - period * std::round(p.x() / period));
    if (c.boundary[v] == 0) c.start[v] = bent(p, used);
  }
  return c;
}

// A block with a limb, or a ring of blocks, of which one arm is 2 to 20 times as thin in the map.
inline FeasibleSolid solid_handle(base::Random& random) {
  const bool closed = random.below(2) == 0;
  std::vector<Block> blocks = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 0, 1}, {1, 0, 2}};
  if (closed) blocks = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 1}, {2, 0, 1}, {0, 0, 2}, {1, 0, 2}, {2, 0, 2}};
  const int n = std::max(3, random_edge(random, blocks.size()));
  const BlockMesh mesh(blocks, n);
  FeasibleSolid c = solid_of(mesh, n, random);
  const double left = closed ? 2 : 1, end = closed ? 2 : 4;
  place_known(c, mesh.positions, std::pow(10, random.unit()) * 2, [&](Vector3 p, double thin) {
    if (p.x() < left || p.x() > left + 1 || p.z() <= 1 || p.z() >= end) return p;
    p.x() = left + 0.5 + (p.x() - left - 0.5) / thin;
    p.y() = 0.5 + (p.y() - 0.5) / thin;
    return p;
  });
  tangle(c, c.known, random.below(3), random);
  return c;
}

// Layers of prisms around a vertex, whose spheres become star-shaped polyhedra with radii from 1 to up to 6.
inline FeasibleSolid solid_star(base::Random& random) {
  // The boundary of a cube of n^3: 12 n^2 triangles, each with 3 tetrahedra a layer and one in the middle.
  const int n = 2 + static_cast<int>(random.below(3));
  const auto layers = static_cast<Index>(1 + random.below(8));
  const BlockMesh cube({{0, 0, 0}}, n);
  std::vector<Index> number(cube.positions.size(), no_index);
  std::vector<Vector3> surface;
  FeasibleSolid c;
  const double longest = 1 + 5 * random.unit();
  std::vector<double> radius;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (!cube.on_boundary(v)) continue;
    number[v] = static_cast<Index>(surface.size());
    surface.push_back((cube.positions[v] - Vector3::Constant(0.5)).normalized());
    radius.push_back(1 + (longest - 1) * random.unit());
  }
  const auto count = static_cast<Index>(surface.size());
  for (Index k = 0; k <= layers; ++k) {
    const double scale = (k + 1.0) / (layers + 1.0);
    for (std::size_t v = 0; v < surface.size(); ++v) {
      c.rest.emplace_back(scale * surface[v]);
      c.known.emplace_back(scale * radius[v] * surface[v]);
      c.boundary.push_back(k == layers);
    }
  }
  const auto middle = static_cast<Index>(c.rest.size());
  c.rest.emplace_back(0, 0, 0);
  c.known.emplace_back(0, 0, 0);
  c.boundary.push_back(0);
  const auto add = [&](Tetrahedron t) {
    if (mesh::orientation_3d(c.rest[t[0]], c.rest[t[1]], c.rest[t[2]], c.rest[t[3]]) < 0) std::swap(t[2], t[3]);
    c.tetrahedra.push_back(t);
  };
  const base::Host host;
  const auto faces = mesh::sorted_faces(cube.tetrahedra, cube.positions.size(), host);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const Triangle& face = faces[i].corners;
    if ((i > 0 && faces[i - 1].corners == face) || (i + 1 < faces.size() && faces[i + 1].corners == face)) continue;
    Triangle f{number[face[0]], number[face[1]], number[face[2]]};
    std::sort(f.begin(), f.end());
    add({middle, f[0], f[1], f[2]});
    for (Index k = 0; k < layers; ++k) {
      const Index a = k * count, b = a + count;
      add({a + f[0], a + f[1], a + f[2], b + f[2]});
      add({a + f[0], a + f[1], b + f[1], b + f[2]});
      add({a + f[0], b + f[0], b + f[1], b + f[2]});
    }
  }
  tangle(c, c.known, random.below(3), random);
  return c;
}

// A cube, or a bar, whose boundary is moved along rays to a polyhedron of eight triangles around the origin, with
// corners at unlike distances: tetrahedra and faces have all of their vertices in one plane of it.
inline FeasibleSolid solid_star_split(base::Random& random) {
  const auto blocks = 1 + random.below(2);
  const int n = random_edge(random, blocks);
  const BlockMesh mesh(bar(static_cast<int>(blocks)), n);
  FeasibleSolid c = solid_of(mesh, n, random);
  std::array<double, 6> corner{};
  for (double& r : corner)
    r = 1 + 3 * random.unit();
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(6 * random.unit(), Vector3(random.unit(), random.unit(), 1).normalized()).toRotationMatrix();
  std::vector<Vector3> placed;
  for (const Vector3& p : mesh.positions) {
    Vector3 q = p - Vector3(0.5 * static_cast<double>(blocks), 0.5, 0.5);
    q.x() /= static_cast<double>(blocks);
    Vector3 u = turn * q;
    // In the octant of u the plane through its corners is sum of |u_a| / radius_a = 1.
    double sum = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      const double x = u[static_cast<Eigen::Index>(a)];
      sum += std::abs(x) / corner[2 * a + (x < 0)];
    }
    placed.emplace_back(u * (sum > 0 ? 2 * q.cwiseAbs().maxCoeff() / sum : 0));
  }
  tangle(c, placed, random.below(4), random);
  return c;
}

// Case `seed` of a family. The same for every run.
inline FeasibleSolid feasible_solid(std::size_t family, std::uint64_t seed) {
  base::Random random(1000 * family + seed + 500);
  constexpr FeasibleSolid (*makers[])(base::Random&) = {solid_twist, solid_fold, solid_handle, solid_star,
                                                        solid_star_split};
  FeasibleSolid c = makers[family](random);
  c.name = solid_families[family];
  return c;
}

}  // namespace orbicube::untangle::test
