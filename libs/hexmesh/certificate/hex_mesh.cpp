#include "hexmesh/certificate/hex_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "mesh/search/predicates.h"

namespace orbicube::hexmesh {
namespace {

using Coefficients = std::array<double, 27>;

// The corner of each place of the cube, the first parameter fastest.
constexpr std::array<std::size_t, 8> corner_at = {0, 1, 3, 2, 4, 5, 7, 6};

// Values at 0, 1/2, 1 along a parameter become coefficients.
void to_bernstein(Coefficients& f, std::size_t stride) {
  for (std::size_t i = 0; i < 27; ++i) {
    if (i / stride % 3 == 1) f[i] = 2 * f[i] - 0.5 * (f[i - stride] + f[i + stride]);
  }
}

// The two halves along a parameter (de Casteljau).
void halve(const Coefficients& f, std::size_t stride, Coefficients& low, Coefficients& high) {
  for (std::size_t i = 0; i < 27; ++i) {
    if (i / stride % 3 != 0) continue;
    const double a = f[i], b = f[i + stride], c = f[i + 2 * stride];
    const double ab = 0.5 * (a + b), bc = 0.5 * (b + c), abc = 0.5 * (ab + bc);
    low[i] = a;
    low[i + stride] = ab;
    low[i + 2 * stride] = abc;
    high[i] = abc;
    high[i + stride] = bc;
    high[i + 2 * stride] = c;
  }
}

// What changes bilinearly between four values, at 0, 1/2 and 1 along both parameters.
std::array<Vector3, 9> between(const std::array<Vector3, 4>& values) {
  std::array<Vector3, 9> result;
  for (std::size_t i = 0; i < 9; ++i) {
    const double s = 0.5 * static_cast<double>(i % 3), t = 0.5 * static_cast<double>(i / 3);
    result[i] = (1 - t) * ((1 - s) * values[0] + s * values[1]) + t * ((1 - s) * values[2] + s * values[3]);
  }
  return result;
}

bool positive(const Coefficients& f, double margin, int depth) {
  if (*std::min_element(f.begin(), f.end()) > margin) return true;
  constexpr std::array<std::size_t, 8> corners = {0, 2, 6, 8, 18, 20, 24, 26};
  for (const std::size_t corner : corners) {
    if (!(f[corner] > margin)) return false;
  }
  if (depth == 0) return false;
  constexpr std::array<std::size_t, 3> strides = {1, 3, 9};
  Coefficients low, high;
  halve(f, strides[static_cast<std::size_t>(depth) % 3], low, high);
  return positive(low, margin, depth - 1) && positive(high, margin, depth - 1);
}

}  // namespace

Array<mesh::Triangle> halves_of(std::span<const Quad> quads, std::pmr::memory_resource* memory) {
  Array<mesh::Triangle> halves(memory);
  halves.reserve(2 * quads.size());
  for (const Quad& q : quads) {
    halves.push_back({q[0], q[1], q[2]});
    halves.push_back({q[0], q[2], q[3]});
  }
  return halves;
}

double corner_jacobian(std::span<const Vector3> positions, const Hexahedron& h, std::size_t corner) {
  const auto& n = corner_neighbors[corner];
  const Vector3& o = positions[h[corner]];
  const Vector3 a = positions[h[n[0]]] - o, b = positions[h[n[1]]] - o, c = positions[h[n[2]]] - o;
  const double lengths = std::sqrt(a.squaredNorm() * b.squaredNorm() * c.squaredNorm());
  return lengths > 0 ? a.dot(b.cross(c)) / lengths : 0;
}

double scaled_jacobian(std::span<const Vector3> positions, const Hexahedron& h) {
  double least = 1;
  for (std::size_t k = 0; k < 8; ++k)
    least = std::min(least, corner_jacobian(positions, h, k));
  return least;
}

Coefficients bezier_coefficients(std::span<const Vector3> positions, const Hexahedron& h) {
  std::array<Vector3, 8> p;
  for (std::size_t i = 0; i < 8; ++i)
    p[i] = positions[h[corner_at[i]]] - positions[h[0]];
  // Derivatives along each parameter, at the four edges.
  std::array<Vector3, 4> du, dv, dw;
  for (std::size_t i = 0; i < 4; ++i) {
    du[i] = p[2 * i + 1] - p[2 * i];                              // i = v + 2 w
    dv[i] = p[i % 2 + 4 * (i / 2) + 2] - p[i % 2 + 4 * (i / 2)];  // u + 2 w
    dw[i] = p[i + 4] - p[i];                                      // u + 2 v
  }
  const std::array<Vector3, 9> along_u = between(du), along_v = between(dv), along_w = between(dw);
  Coefficients f;
  for (std::size_t i = 0; i < 27; ++i) {
    const std::size_t u = i % 3, v = i / 3 % 3, w = i / 9;
    f[i] = along_u[v + 3 * w].dot(along_v[u + 3 * w].cross(along_w[u + 3 * v]));
  }
  to_bernstein(f, 1);
  to_bernstein(f, 3);
  to_bernstein(f, 9);
  return f;
}

double min_bezier(std::span<const Vector3> positions, const Hexahedron& h) {
  const Coefficients f = bezier_coefficients(positions, h);
  double product = 1;
  for (const auto& parallel : edges_along) {
    double longest = 0;
    for (const auto& [from, to] : parallel)
      longest = std::max(longest, (positions[h[to]] - positions[h[from]]).squaredNorm());
    product *= longest;
  }
  const double least = *std::min_element(f.begin(), f.end());
  return product > 0 ? least / std::sqrt(product) : 0;
}

bool certainly_positive(std::span<const Vector3> positions, const Hexahedron& h) {
  constexpr int max_halvings = 15;
  constexpr double rounding = 4e-13;  // times the cube of the reach: a coefficient's is below 2e-13
  double reach = 0;
  for (const Index a : h) {
    for (const Index b : h)
      reach = std::max(reach, (positions[a] - positions[b]).cwiseAbs().maxCoeff());
  }
  return positive(bezier_coefficients(positions, h), rounding * reach * reach * reach, max_halvings);
}

HexQuality measure_hexahedra(std::span<const Vector3> positions, std::span<const Hexahedron> hexahedra,
                             const base::Host& host) {
  HexQuality q;
  for (std::size_t i = 0; i < hexahedra.size(); ++i) {
    if (i % 1024 == 0) host.report("check", i, hexahedra.size());
    const Hexahedron& h = hexahedra[i];
    const double least = scaled_jacobian(positions, h);
    q.min_scaled_jacobian = std::min(q.min_scaled_jacobian, least);
    q.mean_scaled_jacobian += least / static_cast<double>(hexahedra.size());
    for (const double f : bezier_coefficients(positions, h))
      q.volume += f / 27;
    bool inverted = false;
    for (std::size_t k = 0; k < 8 && !inverted; ++k) {
      const auto& n = corner_neighbors[k];
      inverted = mesh::orientation_3d(positions[h[k]], positions[h[n[0]]], positions[h[n[1]]], positions[h[n[2]]]) <= 0;
    }
    const bool uncertain = !inverted && !certainly_positive(positions, h);
    q.inverted += inverted;
    q.uncertain += uncertain;
    if ((inverted || uncertain) && q.first_bad == no_index) q.first_bad = static_cast<Index>(i);
  }
  return q;
}

}  // namespace orbicube::hexmesh
