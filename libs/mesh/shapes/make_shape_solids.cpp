// Cube, L-shape, plate with three holes and bracket: solids of boxes on uneven grid lines, some boxes bored through.
// Planes stay planes to the last bit.
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "mesh/shapes/make_shape_kinds.h"
#include "mesh/shapes/quad_patches.h"

namespace orbicube::mesh {
namespace {

// Exact at both ends, and wherever a == b.
Vector3 between(const Vector3& a, const Vector3& b, double t) {
  return t < 0.5 ? Vector3(a + t * (b - a)) : Vector3(b - (1 - t) * (b - a));
}

using Cell = std::array<int, 3>;

class BoxSolid : public PatchSurface {
 public:
  explicit BoxSolid(std::array<std::vector<double>, 3> lines) : lines_(std::move(lines)) {}

  void fill(const Cell& cell) { cells_[cell] = std::nullopt; }
  // With a round hole along an axis.
  void fill_bored(const Cell& cell, int axis, double radius) { cells_[cell] = Hole{axis, radius}; }

  Mesh make(const ShapeOptions& options, const base::Host& host) {
    for (const auto& [cell, hole] : cells_) {
      for (int axis = 0; axis < 3; ++axis) {
        if (hole && hole->axis == axis) continue;
        for (const bool high : {false, true}) {
          Cell neighbor = cell;
          neighbor[static_cast<std::size_t>(axis)] += high ? 1 : -1;
          if (!cells_.contains(neighbor)) complex_.quads.push_back(side_of(cell, axis, high));
        }
      }
      if (hole) bore(cell, *hole);
    }
    std::vector<double> lengths;
    for (const Quad& quad : complex_.quads) {
      for (std::size_t k = 0; k < 4; ++k) {
        double length = 0;
        constexpr int pieces = 8;
        for (int i = 0; i < pieces; ++i)
          length += (on_side(quad[k], quad[(k + 1) % 4], (i + 1.0) / pieces) -
                     on_side(quad[k], quad[(k + 1) % 4], static_cast<double>(i) / pieces))
                        .norm();
        lengths.push_back(length);
      }
    }
    return mesh_patches(complex_, *this, lengths, options.triangles, host);
  }

  void select(std::size_t quad) override { selected_ = complex_.quads[quad]; }

  // The bilinearly blended surface of Coons between the four sides.
  Vector3 at(double u, double v) const override {
    const auto& q = selected_;
    const auto corner = [&](std::size_t k) -> const Vector3& { return complex_.corners[q[k]]; };
    const Vector3 across = between(on_side(q[0], q[1], u), on_side(q[3], q[2], u), v);
    const Vector3 along = between(on_side(q[0], q[3], v), on_side(q[1], q[2], v), u);
    const Vector3 bilinear = between(between(corner(0), corner(1), u), between(corner(3), corner(2), u), v);
    return across + (along - bilinear);
  }

 private:
  struct Hole {
    int axis;
    double radius;
  };
  struct Arc {
    Vector3 centre, first, second;  // center + cos first + sin second
    double from, to;
  };

  double line(int axis, int i) const { return lines_[static_cast<std::size_t>(axis)][static_cast<std::size_t>(i)]; }

  Index corner_at(const Cell& node) {
    const auto [place, is_new] = nodes_.insert({node, static_cast<Index>(complex_.corners.size())});
    if (is_new) complex_.corners.emplace_back(line(0, node[0]), line(1, node[1]), line(2, node[2]));
    return place->second;
  }

  // The four nodes of one side of a box, counter-clockwise seen against the axis.
  std::array<Cell, 4> nodes_of_side(const Cell& cell, int axis, bool high) const {
    std::array<Cell, 4> nodes;
    const auto a = static_cast<std::size_t>(axis);
    for (std::size_t k = 0; k < 4; ++k) {
      nodes[k] = cell;
      nodes[k][a] += high ? 1 : 0;
      nodes[k][(a + 1) % 3] += k == 1 || k == 2 ? 1 : 0;
      nodes[k][(a + 2) % 3] += k >= 2 ? 1 : 0;
    }
    return nodes;
  }

  Quad side_of(const Cell& cell, int axis, bool high) {
    const auto nodes = nodes_of_side(cell, axis, high);
    const std::array<std::size_t, 4> order =
        high ? std::array<std::size_t, 4>{0, 1, 2, 3} : std::array<std::size_t, 4>{0, 3, 2, 1};
    return {corner_at(nodes[order[0]]), corner_at(nodes[order[1]]), corner_at(nodes[order[2]]),
            corner_at(nodes[order[3]])};
  }

  // Two sides with a hole of four arcs each, and the wall between them.
  void bore(const Cell& cell, const Hole& hole) {
    const auto a = static_cast<std::size_t>(hole.axis);
    std::array<std::array<Index, 4>, 2> outer{};  // low and high side
    std::array<std::array<Index, 4>, 2> inner{};
    for (const std::size_t side : {0U, 1U}) {
      const auto nodes = nodes_of_side(cell, hole.axis, side == 1);
      Vector3 centre;
      centre[hole.axis] = line(hole.axis, nodes[0][a]);
      for (const std::size_t other : {(a + 1) % 3, (a + 2) % 3})
        centre[static_cast<int>(other)] =
            0.5 * (line(static_cast<int>(other), cell[other]) + line(static_cast<int>(other), cell[other] + 1));
      Arc circle{centre, Vector3::Zero(), Vector3::Zero(), 0, 0};
      circle.first[static_cast<int>((a + 1) % 3)] = hole.radius;
      circle.second[static_cast<int>((a + 2) % 3)] = hole.radius;
      for (std::size_t k = 0; k < 4; ++k) {
        outer[side][k] = corner_at(nodes[k]);
        inner[side][k] = static_cast<Index>(complex_.corners.size());
        complex_.corners.push_back(point(circle, angle(k)));
      }
      for (std::size_t k = 0; k < 4; ++k) {
        circle.from = angle(k);
        circle.to = angle(k + 1);
        const Index p = inner[side][k];
        const Index q = inner[side][(k + 1) % 4];
        arcs_[{p, q}] = circle;
        std::swap(circle.from, circle.to);
        arcs_[{q, p}] = circle;
      }
    }
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t n = (k + 1) % 4;
      complex_.quads.push_back({outer[1][k], outer[1][n], inner[1][n], inner[1][k]});
      complex_.quads.push_back({outer[0][n], outer[0][k], inner[0][k], inner[0][n]});
      complex_.quads.push_back({inner[1][k], inner[1][n], inner[0][n], inner[0][k]});
    }
  }

  // Of the hole's corner that belongs to corner k of the box's side.
  static double angle(std::size_t k) { return std::numbers::pi * (0.5 * static_cast<double>(k) - 0.75); }

  static Vector3 point(const Arc& arc, double angle) {
    return arc.centre + (std::cos(angle) * arc.first + std::sin(angle) * arc.second);
  }

  Vector3 on_side(Index from, Index to, double t) const {
    const Vector3& a = complex_.corners[from];
    const Vector3& b = complex_.corners[to];
    if (t > 0 && t < 1) {
      if (const auto arc = arcs_.find({from, to}); arc != arcs_.end())
        return point(arc->second, arc->second.from + t * (arc->second.to - arc->second.from));
    }
    return between(a, b, t);
  }

  std::array<std::vector<double>, 3> lines_;
  std::map<Cell, std::optional<Hole>> cells_;
  std::map<Cell, Index> nodes_;
  std::map<std::pair<Index, Index>, Arc> arcs_;
  QuadComplex complex_;
  Quad selected_{};
};

}  // namespace

Mesh make_cube(const ShapeOptions& options, const base::Host& host) {
  BoxSolid solid({{{-1, 1}, {-1, 1}, {-1, 1}}});
  solid.fill({0, 0, 0});
  return solid.make(options, host);
}

Mesh make_three_holes(const ShapeOptions& options, const base::Host& host) {
  Random random(options.seed);
  const auto spaced = [&](int count) {
    std::vector<double> lines = {0};
    for (int i = 0; i < count; ++i)
      lines.push_back(lines.back() + (options.seed == 0 ? 0.4 : random.uniform(0.2, 0.6)));
    return lines;
  };
  std::array<std::vector<double>, 3> lines = {spaced(7), spaced(3), spaced(1)};
  BoxSolid solid(std::move(lines));
  for (int i = 0; i < 7; ++i) {
    for (int j = 0; j < 3; ++j) {
      const bool hole = j == 1 && i % 2 == 1;
      if (!hole) solid.fill({i, j, 0});
    }
  }
  return solid.make(options, host);
}

Mesh make_angle(const ShapeOptions& options, const base::Host& host) {
  Random random(options.seed);
  const auto varied = [&](double usual) { return usual * (options.seed == 0 ? 1 : random.uniform(0.6, 1.4)); };
  const double thickness = varied(0.7), length = varied(1.1), height = varied(0.9), width = varied(0.8);
  BoxSolid solid({{{0, thickness, thickness + length}, {0, width}, {0, thickness, thickness + height}}});
  solid.fill({0, 0, 0});
  solid.fill({1, 0, 0});
  solid.fill({0, 0, 1});
  return solid.make(options, host);
}

Mesh make_bracket(const ShapeOptions& options, const base::Host& host) {
  Random random(options.seed);
  const auto varied = [&](double usual) { return usual * (options.seed == 0 ? 1 : random.uniform(0.75, 1.3)); };
  const double thickness = varied(0.3);
  const double width = varied(0.8);  // of half the bracket, with one hole in each leg
  const double gap = varied(0.2);
  const double length = varied(0.8);
  const double height = varied(0.8);
  BoxSolid solid({{{0, thickness, thickness + gap, thickness + gap + length},
                   {0, width, 2 * width},
                   {0, thickness, thickness + gap, thickness + gap + height}}});
  for (int j = 0; j < 2; ++j) {
    solid.fill({0, j, 0});
    solid.fill({1, j, 0});
    solid.fill({0, j, 1});
    solid.fill_bored({2, j, 0}, 2, varied(0.3) * std::min(length, width));
    solid.fill_bored({0, j, 2}, 0, varied(0.3) * std::min(height, width));
  }
  return solid.make(options, host);
}

}  // namespace orbicube::mesh
