// Inverted meshes that have an untangled state, of four kinds: vertices strewn about, boxes folded flat, twisted bars,
// and starts of polycube maps. Used by tests and by bench/volume_map.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "untangle/tetrahedra/untangle_tetrahedra.h"

namespace orbicube::untangle::test {

struct TangledCase {
  std::string name;
  std::vector<Tetrahedron> tetrahedra;
  std::vector<Vector3> rest, start;
  std::vector<std::uint8_t> fixed;
  std::vector<Index> ties;

  UntangleProblem mesh() const { return {tetrahedra, start, rest, fixed, ties}; }
};

using Block = std::array<int, 3>;

// Unit blocks cut into n x n x n cubes, each into the six tetrahedra around its diagonal (Kuhn), so that faces match.
struct BlockMesh {
  std::vector<Vector3> positions;
  std::vector<Tetrahedron> tetrahedra;
  // For each coordinate a number of the boundary plane that the vertex lies in, or no_index.
  std::vector<Index> planes;

  BlockMesh(const std::vector<Block>& blocks, int n) {
    std::map<Block, Index> vertex;
    std::map<Block, bool> cube;
    for (const Block& b : blocks) {
      for (int i = 0; i < n * n * n; ++i)
        cube[{b[0] * n + i / (n * n), b[1] * n + i / n % n, b[2] * n + i % n}] = true;
    }
    const auto at = [&](const Block& p) {
      const auto [entry, added] = vertex.try_emplace(p, static_cast<Index>(positions.size()));
      if (added) positions.push_back(Vector3(p[0], p[1], p[2]) / n);
      return entry->second;
    };
    constexpr std::array<std::array<int, 3>, 6> orders = {
        {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
    for (const auto& entry : cube) {
      for (std::size_t o = 0; o < 6; ++o) {
        Block p = entry.first;
        Tetrahedron t{at(p), 0, 0, 0};
        for (std::size_t k = 0; k < 3; ++k) {
          ++p[static_cast<std::size_t>(orders[o][k])];
          t[k + 1] = at(p);
        }
        if (o >= 3) std::swap(t[2], t[3]);
        tetrahedra.push_back(t);
      }
    }
    planes.assign(3 * positions.size(), no_index);
    std::map<std::array<int, 3>, Index> plane;  // axis, side, place
    for (const auto& entry : cube) {
      for (int axis = 0; axis < 3; ++axis) {
        for (int side = 0; side < 2; ++side) {
          const auto a = static_cast<std::size_t>(axis);
          Block beside = entry.first;
          beside[a] += side == 1 ? 1 : -1;
          if (cube.count(beside) != 0) continue;
          Block corner = entry.first;
          corner[a] += side;
          const Index number =
              plane.try_emplace({axis, side, corner[a]}, static_cast<Index>(plane.size())).first->second;
          for (int k = 0; k < 4; ++k) {
            Block p = corner;
            p[(a + 1) % 3] += k % 2;
            p[(a + 2) % 3] += k / 2;
            planes[3 * at(p) + a] = number;
          }
        }
      }
    }
  }
  bool on_boundary(std::size_t v) const {
    return planes[3 * v] != no_index || planes[3 * v + 1] != no_index || planes[3 * v + 2] != no_index;
  }
};

inline std::vector<Block> bar(int length, int width = 1) {
  std::vector<Block> blocks;
  for (int x = 0; x < length; ++x) {
    for (int y = 0; y < width; ++y)
      blocks.push_back({x, y, 0});
  }
  return blocks;
}

// Cubes of a bar of two blocks, every vertex pushed about by up to `push` a coordinate; nothing is fixed or tied.
struct PushedBar {
  base::Host host;
  BlockMesh mesh{bar(2), 2};
  std::vector<Vector3> start;
  std::vector<std::uint8_t> fixed;
  std::vector<Index> ties;

  explicit PushedBar(double push)
      : start(mesh.positions), fixed(3 * start.size(), 0), ties(3 * start.size(), no_index) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> uniform(-push, push);
    for (Vector3& p : start) {
      for (double& x : p)
        x += uniform(random);
    }
  }
};

// A smooth, positive change of shape: round, bent, turned.
inline Vector3 warped(Vector3 p, double roundness, double bend, double turn) {
  for (Eigen::Index a = 1; a < 3; ++a) {
    const double other = 2 * p[3 - a] - 1;
    p[a] = 0.5 + (p[a] - 0.5) * (1 - roundness * 0.25 * std::min(other * other, 1.0));
  }
  const double angle = bend * p[0], radius = 1 / std::max(bend, 1e-9) - p[1];
  if (bend > 0) p = Vector3(radius * std::sin(angle), 1 / bend - radius * std::cos(angle), p[2]);
  return Eigen::AngleAxisd(turn, Vector3(0.3, 0.5, 0.8).normalized()) * p;
}

// A part of the vertices inside is anywhere within the box, whose boundary stays.
inline TangledCase strewn(int blocks, int n, double part, std::uint64_t seed) {
  const BlockMesh mesh(bar(blocks), n);
  TangledCase result{"strewn", mesh.tetrahedra, mesh.positions, mesh.positions, {}, {}};
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  result.fixed.assign(3 * mesh.positions.size(), 0);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (mesh.on_boundary(v)) {
      for (std::size_t a = 0; a < 3; ++a)
        result.fixed[3 * v + a] = 1;
    } else if (uniform(random) < part) {
      result.start[v] = Vector3(blocks * uniform(random), uniform(random), uniform(random));
    }
  }
  return result;
}

// A bar folded over itself like a strip of paper; one end stays, and with `both` the other one where it belongs.
inline TangledCase folded(int blocks, int n, double period, bool both) {
  const BlockMesh mesh(bar(blocks), n);
  TangledCase result{"folded", mesh.tetrahedra, mesh.positions, mesh.positions, {}, {}};
  result.fixed.assign(3 * mesh.positions.size(), 0);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const double x = mesh.positions[v][0];
    const bool stays = x == 0 || (both && x == blocks);
    for (std::size_t a = 0; a < 3; ++a)
      result.fixed[3 * v + a] = stays;
    if (!stays) result.start[v][0] = std::abs(x - period * std::round(x / period));
  }
  return result;
}

// A bar whose ends stay, one turned by `angle`; all of that turn lies in one layer in the middle.
inline TangledCase twisted(int blocks, int n, double angle) {
  const BlockMesh mesh(bar(blocks), n);
  TangledCase result{"twisted", mesh.tetrahedra, mesh.positions, mesh.positions, {}, {}};
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, Vector3::UnitX()).toRotationMatrix();
  const Vector3 middle(0, 0.5, 0.5);
  result.fixed.assign(3 * mesh.positions.size(), 0);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const Vector3 p = mesh.positions[v];
    if (p[0] > 0.5 * blocks) result.start[v] = turn * (p - middle) + middle;
    if (p[0] == 0 || p[0] == blocks) {
      for (std::size_t a = 0; a < 3; ++a)
        result.fixed[3 * v + a] = 1;
    }
  }
  return result;
}

// A bent, rounded and turned solid of blocks whose boundary faces are to become planes; where these lie is free but for
// one along each axis. It starts where it is, with each face pressed into its mean plane.
inline TangledCase polycube_start(const std::vector<Block>& blocks, int n, double roundness, double bend, double turn) {
  const BlockMesh mesh(blocks, n);
  TangledCase result{"polycube", mesh.tetrahedra, {}, {}, {}, mesh.planes};
  for (const Vector3& p : mesh.positions)
    result.rest.push_back(warped(p, roundness, bend, turn));
  result.start = result.rest;
  result.fixed.assign(3 * mesh.positions.size(), 0);
  std::array<Index, 3> held{no_index, no_index, no_index};
  std::array<double, 3> sum{}, count{};
  for (std::size_t i = 0; i < result.fixed.size(); ++i) {
    if (mesh.planes[i] == no_index) continue;
    if (held[i % 3] == no_index) held[i % 3] = mesh.planes[i];
    if (mesh.planes[i] != held[i % 3]) continue;
    sum[i % 3] += result.start[i / 3][static_cast<Eigen::Index>(i % 3)];
    ++count[i % 3];
  }
  for (std::size_t i = 0; i < result.fixed.size(); ++i) {
    if (mesh.planes[i] == no_index || mesh.planes[i] != held[i % 3]) continue;
    result.fixed[i] = 1;
    result.start[i / 3][static_cast<Eigen::Index>(i % 3)] = sum[i % 3] / count[i % 3];
  }
  return result;
}

}  // namespace orbicube::untangle::test
