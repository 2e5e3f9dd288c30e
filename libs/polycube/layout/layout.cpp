#include "polycube/layout/layout.h"

#include <algorithm>
#include <tuple>

#include "base/error.h"
#include "polycube/voxels/grid_rectangles.h"

namespace orbicube::polycube {
namespace {

constexpr const char* layout_phase = "layout";

// The solid on the planes only that it has faces in, and one empty layer around.
VoxelSolid compressed(const VoxelSolid& solid, const base::Host& host) {
  std::array<Array<int>, 3> kept = {Array<int>(host.memory), Array<int>(host.memory), Array<int>(host.memory)};
  std::array<Array<double>, 3> planes = {Array<double>(host.memory), Array<double>(host.memory),
                                         Array<double>(host.memory)};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (int plane = 1; plane < solid.count(axis); ++plane) {
      host.report(layout_phase, 0, 0);
      bool differs = false;
      Cell c{};
      c[axis] = plane;
      for (c[u] = 0; c[u] < solid.count(u) && !differs; ++c[u])
        for (c[v] = 0; c[v] < solid.count(v) && !differs; ++c[v])
          differs = solid.inside(solid.place(c)) != solid.inside(solid.neighbor(solid.place(c), axis, -1));
      if (differs) kept[axis].push_back(plane);
    }
    if (kept[axis].size() < 2) throw base::Error("internal", "a polycube without extent");
    const auto all = solid.planes(axis);
    planes[axis].push_back(all.front());
    for (const int plane : kept[axis])
      planes[axis].push_back(all[static_cast<std::size_t>(plane)]);
    planes[axis].push_back(all.back());
  }
  VoxelSolid result(std::move(planes), host.memory);
  for (std::size_t i = 0; i < result.size(); ++i) {
    Cell c = result.cell(i);
    if (result.in_outermost_layer(c)) continue;
    for (std::size_t a = 0; a < 3; ++a)
      c[a] = kept[a][static_cast<std::size_t>(c[a]) - 1];
    result.set(i, solid.inside(c));
  }
  return result;
}

// A unit square of the surface: its corners are four half-edges of the quad mesh, 4 q to 4 q + 3, counter-clockwise
// seen from outside.
struct Square {
  Cell cell;  // the inside one
  AxisLabel label;
  Index rectangle, facet;
  std::array<std::size_t, 4> corner;  // places of grid vertices
};

class Builder {
 public:
  Builder(const VoxelSolid& solid, const base::Host& host)
      : host_(host), solid_(compressed(solid, host)), squares_(host.memory), twin_(host.memory), layout_(host.memory) {}

  Layout build() {
    for (std::size_t a = 0; a < 3; ++a)
      layout_.planes[a].assign(solid_.planes(a).begin(), solid_.planes(a).end());
    find_squares();
    join_squares();
    cut_facets();
    find_nodes();
    find_arcs();
    find_boundaries();
    return std::move(layout_);
  }

 private:
  static Index square_of(Index half_edge) { return half_edge / 4; }
  static Index next(Index half_edge) { return half_edge % 4 == 3 ? half_edge - 3 : half_edge + 1; }
  static Index previous(Index half_edge) { return half_edge % 4 == 0 ? half_edge + 3 : half_edge - 1; }
  std::size_t origin(Index half_edge) const { return squares_[half_edge / 4].corner[half_edge % 4]; }
  // The next half-edge out of the same vertex, counter-clockwise.
  Index turned(Index half_edge) const { return twin_[previous(half_edge)]; }
  bool drawn(Index half_edge) const {
    return squares_[square_of(half_edge)].rectangle != squares_[square_of(twin_[half_edge])].rectangle;
  }

  void find_squares() {
    for (std::size_t place = 0; place < solid_.size(); ++place) {
      if (!solid_.inside(place)) continue;
      const Cell c = solid_.cell(place);
      for (AxisLabel label = 0; label < label_count; ++label) {
        const auto axis = static_cast<std::size_t>(axis_of(label));
        if (solid_.inside(solid_.neighbor(place, axis, sign_of(label)))) continue;
        Square square{c, label, no_index, no_index, {}};
        constexpr std::array<std::array<int, 2>, 4> around = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
        for (std::size_t k = 0; k < 4; ++k) {
          const auto& [first, second] = around[sign_of(label) > 0 ? k : 3 - k];
          Cell vertex = c;
          vertex[axis] += sign_of(label) > 0;
          vertex[(axis + 1) % 3] += first;
          vertex[(axis + 2) % 3] += second;
          square.corner[k] = solid_.place(vertex);
        }
        squares_.push_back(square);
      }
    }
  }

  // Pairs half-edges; a certified surface has two at each edge.
  void join_squares() {
    struct Key {
      std::size_t low, high;
      Index half_edge;
    };
    Array<Key> keys(host_.memory);
    for (Index h = 0; h < 4 * squares_.size(); ++h) {
      const std::size_t a = origin(h), b = origin(next(h));
      keys.push_back({std::min(a, b), std::max(a, b), h});
    }
    std::sort(keys.begin(), keys.end(), [](const Key& a, const Key& b) {
      return std::tie(a.low, a.high, a.half_edge) < std::tie(b.low, b.high, b.half_edge);
    });
    twin_.assign(4 * squares_.size(), no_index);
    for (std::size_t i = 0; i + 1 < keys.size(); i += 2) {
      if (keys[i].low != keys[i + 1].low || keys[i].high != keys[i + 1].high)
        throw base::Error("internal", "the surface of the voxels is no manifold");
      twin_[keys[i].half_edge] = keys[i + 1].half_edge;
      twin_[keys[i + 1].half_edge] = keys[i].half_edge;
    }
  }

  // Patches by flooding, each cut into slabs, of the two directions the one that gives fewer.
  void cut_facets() {
    Array<Index> members(host_.memory);
    Array<std::array<int, 2>> places(host_.memory);
    Array<GridRectangle> slabs(host_.memory), other(host_.memory);
    for (Index start = 0; start < squares_.size(); ++start) {
      if (squares_[start].facet != no_index) continue;
      host_.report(layout_phase, start, squares_.size());
      const auto facet = static_cast<Index>(layout_.facets++);
      squares_[start].facet = facet;
      members.assign(1, start);
      for (std::size_t i = 0; i < members.size(); ++i) {
        for (Index k = 0; k < 4; ++k) {
          const Index there = square_of(twin_[4 * members[i] + k]);
          if (squares_[there].facet != no_index || squares_[there].label != squares_[start].label) continue;
          squares_[there].facet = facet;
          members.push_back(there);
        }
      }
      const auto axis = static_cast<std::size_t>(axis_of(squares_[start].label));
      const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
      const auto cut = [&](std::size_t row, std::size_t column, Array<GridRectangle>& result) {
        places.clear();
        for (const Index q : members)
          places.push_back({squares_[q].cell[row], squares_[q].cell[column]});
        std::sort(places.begin(), places.end());
        result.clear();
        cut_into_slabs(places, result);
      };
      cut(u, v, slabs);
      cut(v, u, other);
      const bool swapped = other.size() < slabs.size();
      const Array<GridRectangle>& fewer = swapped ? other : slabs;
      const std::size_t row = swapped ? v : u, column = swapped ? u : v;
      const int plane = squares_[start].cell[axis] + (sign_of(squares_[start].label) > 0);
      for (const GridRectangle& slab : fewer) {
        LayoutRectangle r{squares_[start].label, facet, {}, {}};
        r.low[axis] = r.high[axis] = plane;
        r.low[row] = slab.low[0];
        r.high[row] = slab.high[0];
        r.low[column] = slab.low[1];
        r.high[column] = slab.high[1];
        for (const Index q : members) {
          const Cell& c = squares_[q].cell;
          if (c[row] >= slab.low[0] && c[row] < slab.high[0] && c[column] >= slab.low[1] && c[column] < slab.high[1])
            squares_[q].rectangle = static_cast<Index>(layout_.rectangles.size());
        }
        layout_.rectangles.push_back(r);
      }
    }
  }

  void find_nodes() {
    node_at_.assign(solid_.size(), no_index);
    Array<std::uint8_t> seen(solid_.size(), 0, host_.memory);
    for (Index h = 0; h < 4 * squares_.size(); ++h) {
      const std::size_t vertex = origin(h);
      if (seen[vertex]) continue;
      seen[vertex] = 1;
      int arcs = 0;
      Vector3 normal = Vector3::Zero();
      Index around = h;
      do {
        arcs += drawn(around);
        normal += direction_of(squares_[square_of(around)].label);
        around = turned(around);
      } while (around != h);
      if (arcs < 3) continue;
      node_at_[vertex] = static_cast<Index>(layout_.nodes.size());
      const Cell cell = solid_.cell(vertex);
      layout_.nodes.push_back({cell, normal.normalized(), VoxelSolid::corner(solid_.configuration(cell))});
      first_.push_back(h);
    }
  }

  void find_arcs() {
    Array<Index> dart_at(4 * squares_.size(), no_index, host_.memory);  // of first half-edges
    layout_.rotation_begin.push_back(0);
    for (Index node = 0; node < layout_.nodes.size(); ++node) {
      Index around = first_[node];
      do {
        if (drawn(around)) {
          if (dart_at[around] == no_index) {
            const auto dart = static_cast<Index>(layout_.dart_origin.size());
            dart_at[around] = dart;
            Index here = around;
            Index end = node_at_[origin(twin_[here])];
            while (end == no_index) {
              Index onward = turned(twin_[here]);
              while (!drawn(onward))
                onward = turned(onward);
              here = onward;
              end = node_at_[origin(twin_[here])];
            }
            dart_at[twin_[here]] = dart + 1;
            layout_.dart_origin.push_back(node);
            layout_.dart_origin.push_back(end);
            layout_.dart_left.push_back(squares_[square_of(around)].rectangle);
            layout_.dart_left.push_back(squares_[square_of(twin_[here])].rectangle);
          }
          layout_.rotation.push_back(dart_at[around]);
        }
        around = turned(around);
      } while (around != first_[node]);
      layout_.rotation_begin.push_back(static_cast<Index>(layout_.rotation.size()));
    }
  }

  void find_boundaries() {
    const auto count = static_cast<Index>(layout_.rectangles.size());
    Array<Index> any(count, no_index, host_.memory);
    for (Index dart = 0; dart < layout_.dart_origin.size(); ++dart)
      any[layout_.dart_left[dart]] = dart;
    layout_.boundary_begin.push_back(0);
    for (Index r = 0; r < count; ++r) {
      Index dart = any[r];
      do {
        layout_.boundary.push_back(dart);
        // With the rectangle on the left, the dart before the one back in the rotation of the target goes on.
        const auto around = layout_.darts_of(layout_.target(dart));
        const auto back = std::find(around.begin(), around.end(), dart ^ 1U);
        dart = back == around.begin() ? around.back() : *(back - 1);
      } while (dart != any[r]);
      layout_.boundary_begin.push_back(static_cast<Index>(layout_.boundary.size()));
    }
  }

  const base::Host& host_;
  VoxelSolid solid_;
  Array<Square> squares_;
  Array<Index> twin_;
  Array<Index> node_at_{host_.memory};  // of grid vertices
  Array<Index> first_{host_.memory};    // a half-edge out of each node
  Layout layout_;
};

}  // namespace

std::size_t Layout::corners() const {
  return static_cast<std::size_t>(
      std::count_if(nodes.begin(), nodes.end(), [](const LayoutNode& node) { return node.corner; }));
}

std::size_t Layout::axis(Index arc) const {
  const Cell &a = nodes[dart_origin[2 * arc]].vertex, &b = nodes[dart_origin[2 * arc + 1]].vertex;
  return a[0] != b[0] ? 0 : a[1] != b[1] ? 1 : 2;
}

Layout make_layout(const VoxelSolid& solid, const base::Host& host) {
  return Builder(solid, host).build();
}

}  // namespace orbicube::polycube
