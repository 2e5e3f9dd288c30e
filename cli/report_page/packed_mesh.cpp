#include "report_page/packed_mesh.h"
#include "report_page/base64_text.h"

#include <Eigen/Dense>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <deque>
#include <numbers>
#include <vector>

#include "base/error.h"
#include "base/host.h"
#include "mesh/search/rotations.h"
#include "mesh/topology/edge_table.h"

namespace orbicube::cli {
namespace {

using mesh::Index;
using mesh::Triangle;
using mesh::Vector3;

std::span<const Vector3> target_of(const PageResult& result) {
  return result.polycube.empty() ? result.directions : result.polycube;
}

void check(const PageResult& result) {
  const auto fail = [&](const std::string& what) {
    throw base::Error("invalid-argument", "result " + result.name + ": " + what);
  };
  if (result.triangles.empty()) fail("no triangle");
  if (target_of(result).size() != result.positions.size()) fail("the map has not as many vertices as the shape");
  if (result.quasi_conformal.size() != result.triangles.size() || result.area_ratio.size() != result.triangles.size()) {
    fail("not as many distortions as triangles");
  }
  const std::size_t basis = (std::size_t{result.degree} + 1) * (std::size_t{result.degree} + 1);
  if (!result.coefficients.empty() && result.coefficients.size() != 3 * basis) {
    fail("not as many coefficients as its degree has");
  }
  for (const Triangle& triangle : result.triangles) {
    for (const Index corner : triangle) {
      if (corner >= result.positions.size()) fail("triangle index " + std::to_string(corner) + " out of range");
    }
  }
}

void append_number(std::vector<std::uint8_t>& bytes, double value, int byte_count) {
  const auto number = static_cast<std::uint32_t>(value);
  for (int k = 0; k < byte_count; ++k)
    bytes.push_back(static_cast<std::uint8_t>(number >> (8 * k) & 255U));
}

void append_varying(std::vector<std::uint8_t>& bytes, std::uint32_t number) {
  for (; number >= 128; number >>= 7U)
    bytes.push_back(static_cast<std::uint8_t>(number | 128U));
  bytes.push_back(static_cast<std::uint8_t>(number));
}

// For each half-edge the one that runs back along the same edge, where exactly one other does.
std::vector<Index> twins(std::size_t vertex_count, std::span<const Triangle> triangles) {
  std::vector<Index> twin(3 * triangles.size(), mesh::no_index);
  const mesh::EdgeTable edges(vertex_count, triangles, base::Host());
  for (std::size_t edge = 0; edge < edges.size(); ++edge) {
    const std::span<const Index> sides = edges.half_edges(edge);
    if (sides.size() != 2 || mesh::start_of(triangles, sides[0]) == mesh::start_of(triangles, sides[1])) continue;
    twin[sides[0]] = sides[1];
    twin[sides[1]] = sides[0];
  }
  return twin;
}

struct Walk {
  std::vector<Index> vertices;   // in the order in which they are met
  std::vector<Index> triangles;  // likewise
  std::vector<std::uint8_t> codes;
};

// Walks over the triangles across their edges, breadth first, and writes down what a reader cannot foresee. Each part
// of the surface starts with a triangle: its three corners; its edges wait in a queue. Then for the next waiting edge:
// 0 when no new triangle lies across it, or else the new triangle's third corner; its other two edges join the queue.
// A corner is 1 when it was not met before and takes the next number; otherwise 2 plus how many vertices were met
// since.
Walk walk(std::size_t vertex_count, std::span<const Triangle> triangles) {
  Walk result;
  const std::vector<Index> twin = twins(vertex_count, triangles);
  std::vector<Index> number(vertex_count, mesh::no_index);
  std::vector<bool> visited(triangles.size(), false);
  std::deque<Index> waiting;
  const auto write_corner = [&](Index vertex) {
    if (number[vertex] == mesh::no_index) {
      number[vertex] = static_cast<Index>(result.vertices.size());
      result.vertices.push_back(vertex);
      append_varying(result.codes, 1);
    } else {
      append_varying(result.codes, static_cast<Index>(result.vertices.size()) - number[vertex] + 1);
    }
  };
  const auto visit = [&](Index triangle) {
    visited[triangle] = true;
    result.triangles.push_back(triangle);
  };
  for (Index seed = 0; seed < triangles.size(); ++seed) {
    if (visited[seed]) continue;
    visit(seed);
    for (Index k = 0; k < 3; ++k) {
      write_corner(triangles[seed][k]);
      waiting.push_back(3 * seed + k);
    }
    while (!waiting.empty()) {
      const Index across = twin[waiting.front()];
      waiting.pop_front();
      if (across == mesh::no_index || visited[mesh::triangle_of(across)]) {
        append_varying(result.codes, 0);
        continue;
      }
      visit(mesh::triangle_of(across));
      const Index second = mesh::next_in_triangle(across);
      const Index third = mesh::next_in_triangle(second);
      write_corner(mesh::start_of(triangles, third));
      waiting.push_back(second);
      waiting.push_back(third);
    }
  }
  return result;
}

double area_of(const PageResult& result, const Triangle& t) {
  const auto& p = result.positions;
  return 0.5 * (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]).norm();
}

// The rotation that brings directions, or the polycube, nearest to the vertices seen from the shape's centroid, in the
// mean over the shape's area (Kabsch 1976).
Eigen::Matrix3d facing_rotation(const PageResult& result) {
  std::vector<double> weight(result.positions.size(), 0);
  Vector3 centroid = Vector3::Zero();
  double area = 0;
  for (const Triangle& t : result.triangles) {
    const double a = area_of(result, t);
    for (const Index corner : t) {
      weight[corner] += a / 3;
      centroid += a / 3 * result.positions[corner];
    }
    area += a;
  }
  if (!(area > 0) || !std::isfinite(area)) return Eigen::Matrix3d::Identity();
  centroid /= area;
  Eigen::Matrix3d correlation = Eigen::Matrix3d::Zero();
  for (std::size_t v = 0; v < weight.size(); ++v) {
    correlation += weight[v] / area * (result.positions[v] - centroid) * target_of(result)[v].transpose();
  }
  return mesh::nearest_rotation(correlation);
}

void append_direction(std::vector<std::uint8_t>& bytes, const Vector3& direction) {
  constexpr double largest = (1 << 24) - 1;
  const Vector3 p = direction / direction.lpNorm<1>();
  double u = p.x();
  double v = p.y();
  if (p.z() < 0) {
    u = std::copysign(1 - std::abs(p.y()), p.x());
    v = std::copysign(1 - std::abs(p.x()), p.y());
  }
  for (const double coordinate : {u, v}) {
    append_number(bytes, std::round(std::clamp(0.5 * (coordinate + 1), 0.0, 1.0) * largest), 3);
  }
}

// Of the sums in steps from `low`, as the positions are stored.
std::string packed_coefficients(const PageResult& result, const Vector3& low, double step) {
  std::vector<std::uint8_t> bytes;
  const double first = std::sqrt(0.25 / std::numbers::pi);  // Y_00
  for (std::size_t i = 0; i < result.coefficients.size(); ++i) {
    const double offset = i < 3 ? low[static_cast<Eigen::Index>(i)] / first : 0;
    const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>((result.coefficients[i] - offset) / step));
    append_number(bytes, bits, 4);
  }
  return base64(bytes);
}

std::uint8_t level_of(const Levels& levels, double value) {
  if (!(value > 0) || std::isinf(value)) return levels.none;
  const double octaves = std::log2(value) / levels.octaves;
  const double level = levels.zero + levels.span * std::copysign(std::sqrt(std::abs(octaves)), octaves);
  return static_cast<std::uint8_t>(std::lround(std::clamp<double>(level, levels.least, levels.most)));
}

// Positions in steps of 16 bits from the lowest corner of their box.
struct Steps {
  Vector3 low;
  double step;
  std::vector<std::uint8_t> bytes;

  Steps(const std::vector<Index>& vertices, std::span<const Vector3> positions) : low(positions[vertices.front()]) {
    Vector3 high = low;
    for (const Index v : vertices) {
      low = low.cwiseMin(positions[v]);
      high = high.cwiseMax(positions[v]);
    }
    constexpr double largest = (1 << 16) - 1;
    step = (high - low).maxCoeff() / largest;
    if (!(step > 0)) step = 1;
    for (const Index v : vertices) {
      for (const double coordinate : Vector3((positions[v] - low) / step))
        append_number(bytes, std::round(std::min(coordinate, largest)), 2);
    }
  }
};

}  // namespace

PackedMesh pack(const PageResult& result) {
  check(result);
  const Walk order = walk(result.positions.size(), result.triangles);
  PackedMesh packed;
  packed.vertices = order.vertices.size();
  packed.triangles = order.triangles.size();
  packed.connections = base64(order.codes);

  const Steps shape(order.vertices, result.positions);
  packed.low = shape.low;
  packed.step = shape.step;
  packed.positions = base64(shape.bytes);
  packed.facing = facing_rotation(result);
  packed.coefficients = packed_coefficients(result, packed.low, packed.step);
  if (!result.polycube.empty()) {
    packed.polycube = base64(Steps(order.vertices, result.polycube).bytes);
  } else {
    std::vector<std::uint8_t> directions;
    for (const Index v : order.vertices)
      append_direction(directions, packed.facing * result.directions[v]);
    packed.directions = base64(directions);
  }

  std::vector<std::uint8_t> quasi_conformal;
  std::vector<std::uint8_t> area_ratio;
  double total = 0;
  for (const Index t : order.triangles) {
    quasi_conformal.push_back(level_of(quasi_conformal_levels, result.quasi_conformal[t]));
    area_ratio.push_back(level_of(area_levels, result.area_ratio[t]));
    const double area = area_of(result, result.triangles[t]);
    packed.quasi_conformal_share[quasi_conformal.back()] += area;
    packed.area_ratio_share[area_ratio.back()] += area;
    total += area;
  }
  if (total > 0) {
    for (double& share : packed.quasi_conformal_share)
      share /= total;
    for (double& share : packed.area_ratio_share)
      share /= total;
  }
  packed.quasi_conformal = base64(quasi_conformal);
  packed.area_ratio = base64(area_ratio);
  return packed;
}

}  // namespace orbicube::cli
