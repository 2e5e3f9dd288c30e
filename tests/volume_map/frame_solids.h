// Solids of tetrahedra with frames that are known: bars along the axes, and cylinders with four singular edges inside;
// and rings without.
#pragma once

#include <cmath>
#include <complex>
#include <numbers>

#include "tests/untangle/tangled_cases.h"
#include "volume_map/frames/framed_solid.h"

namespace orbicube::volume_map::test {

using namespace untangle::test;

inline FramedSolid framed(const BlockMesh& mesh) {
  FramedSolid solid(std::pmr::get_default_resource());
  solid.positions.assign(mesh.positions.begin(), mesh.positions.end());
  solid.tetrahedra.assign(mesh.tetrahedra.begin(), mesh.tetrahedra.end());
  solid.frames.assign(solid.tetrahedra.size(), {1, 0, 0, 0});
  return solid;
}

// A bar of square section made round about the z axis, of radius 1. Frames turn about z by a quarter of the angle of
//   product over four points z_i of (z - z_i) (1 - conj(z_i) z),
// so that an axis is radial at the boundary, and cells meet in threes around the lines through the points, which are
// those of vertices.
inline FramedSolid cylinder(int n, int layers, double height) {
  FramedSolid solid(std::pmr::get_default_resource());
  const auto at = [&](int i, int j, int k) { return static_cast<Index>((i * (n + 1) + j) * (layers + 1) + k); };
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) {
      for (int k = 0; k <= layers; ++k) {
        Eigen::Vector2d p(2.0 * i / n - 1, 2.0 * j / n - 1);
        const double longest = p.cwiseAbs().maxCoeff();
        if (longest > 0) p *= (1 - longest) + longest * longest / p.norm();
        solid.positions.push_back({p[0], p[1], height * k / layers});
      }
    }
  }
  constexpr std::array<std::array<int, 3>, 6> orders = {
      {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      for (int k = 0; k < layers; ++k) {
        for (std::size_t o = 0; o < 6; ++o) {
          std::array<int, 3> p{i, j, k};
          Tetrahedron t{at(i, j, k), 0, 0, 0};
          for (std::size_t c = 0; c < 3; ++c) {
            ++p[static_cast<std::size_t>(orders[o][c])];
            t[c + 1] = at(p[0], p[1], p[2]);
          }
          if (o >= 3) std::swap(t[2], t[3]);
          solid.tetrahedra.push_back(t);
        }
      }
    }
  }
  const Vector3& on_line = solid.positions[at(3 * n / 4, 3 * n / 4, 0)];
  const double radius = std::hypot(on_line[0], on_line[1]);
  for (const Tetrahedron& t : solid.tetrahedra) {
    Vector3 centre = Vector3::Zero();
    for (const Index v : t)
      centre += 0.25 * solid.positions[v];
    const std::complex<double> z(centre[0], centre[1]);
    double sum = 0;
    for (int k = 0; k < 4; ++k) {
      const std::complex<double> point = std::polar(radius, std::numbers::pi * (0.25 + 0.5 * k));
      sum += 0.25 * std::arg((z - point) * (1.0 - std::conj(point) * z));
    }
    solid.frames.push_back({std::cos(0.5 * sum), 0, 0, std::sin(0.5 * sum)});
  }
  return solid;
}

// The same bar bent to a ring about the z axis, its ends glued, without frames.
inline FramedSolid ring(int n, int layers, double radius) {
  FramedSolid bar = cylinder(n, layers, 1), solid(std::pmr::get_default_resource());
  const auto length = static_cast<Index>(layers);
  const auto number = [&](Index v) { return v / (length + 1) * length + v % (length + 1) % length; };
  for (Index v = 0; v < bar.positions.size(); ++v) {
    const Vector3& p = bar.positions[v];
    const double turn = 2 * std::numbers::pi * p[2], distance = 1 + radius * p[0];
    if (v % (length + 1) < length)
      solid.positions.push_back({distance * std::cos(turn), distance * std::sin(turn), -radius * p[1]});
  }
  for (Tetrahedron t : bar.tetrahedra) {
    for (Index& v : t)
      v = number(v);
    solid.tetrahedra.push_back(t);
  }
  return solid;
}

}  // namespace orbicube::volume_map::test
