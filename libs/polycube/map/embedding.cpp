#include "polycube/map/embedding.h"

#include <algorithm>
#include <array>
#include <compare>

#include "mesh/topology/place_text.h"

namespace orbicube::polycube {
namespace {

using mesh::Connectivity;
using Place = std::array<Index, 3>;  // numbers of planes

constexpr const char* embedding_phase = "certificate";

class Grid {
 public:
  Grid(std::span<const Vector3> polycube, std::span<const Triangle> triangles, std::span<const AxisLabel> labels,
       std::span<const Index> patches, const Connectivity& connectivity, const base::Host& host)
      : polycube_(polycube),
        triangles_(triangles),
        labels_(labels),
        patches_(patches),
        connectivity_(connectivity),
        host_(host),
        planes_{Array<double>(host.memory), Array<double>(host.memory), Array<double>(host.memory)},
        is_corner_(polycube.size(), 0, host.memory),
        crossings_(host.memory),
        cells_(host.memory),
        edges_(host.memory),
        vertices_(host.memory),
        triangle_of_(host.memory) {}

  std::optional<std::string> run(std::size_t max_cells) {
    find_planes();
    find_crossings();
    if (crossings_.size() > max_cells) return std::nullopt;
    std::sort(crossings_.begin(), crossings_.end());
    if (count_cells() > max_cells) return std::nullopt;
    if (overlapping_ != no_index)
      return "the polycube meets itself, face " + std::to_string(overlapping_) + " overlaps itself";
    std::string wrong = check_cells();
    if (wrong.empty()) wrong = check_edges();
    if (wrong.empty()) wrong = check_vertices();
    if (!wrong.empty()) return "the polycube meets itself, " + wrong;
    return check_sides();
  }

 private:
  // Where the boundary of a face crosses a row of cells: `change` to what is beyond it.
  struct Crossing {
    Index patch, row, at;
    int change;
    auto operator<=>(const Crossing&) const = default;
  };
  // The cell from the place on, across the axis.
  struct Cell {
    Place place;
    int axis;
    Index patch;
    std::strong_ordering operator<=>(const Cell&) const = default;
  };
  // The edge of the grid from the place on, along the axis.
  struct Edge {
    Place place;
    int axis;
    Index patch;
    std::strong_ordering operator<=>(const Edge&) const = default;
  };
  struct Vertex {
    Place place;
    unsigned quadrant;  // one of 12
    std::strong_ordering operator<=>(const Vertex&) const = default;
  };

  bool on_edge(Index h) const { return patches_[h / 3] != patches_[connectivity_.opposite(h) / 3]; }

  void report(std::size_t i) const {
    if (i % 4096 == 0) host_.report(embedding_phase, 0, 0);
  }

  void find_planes() {
    for (Index v = 0; v < polycube_.size(); ++v) {
      report(v);
      int edges = 0;
      connectivity_.for_each_outgoing(v, [&](Index h) { edges += on_edge(h); });
      if (edges < 3) continue;
      is_corner_[v] = 1;
      for (std::size_t axis = 0; axis < 3; ++axis)
        planes_[axis].push_back(polycube_[v][static_cast<Eigen::Index>(axis)]);
    }
    for (Array<double>& along : planes_) {
      std::sort(along.begin(), along.end());
      along.erase(std::unique(along.begin(), along.end()), along.end());
    }
  }

  Place place_of(Index v) const {
    Place result{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Array<double>& along = planes_[axis];
      const double at = polycube_[v][static_cast<Eigen::Index>(axis)];
      result[axis] = static_cast<Index>(std::lower_bound(along.begin(), along.end(), at) - along.begin());
    }
    return result;
  }

  // The corner at the other end of the edge of the polycube that h is the first part of, with h's face on the left.
  Index end_of_edge(Index h) const {
    while (!is_corner_[connectivity_.end(h)]) {
      h = Connectivity::next(h);
      while (!on_edge(h))
        h = Connectivity::next(connectivity_.opposite(h));
    }
    return connectivity_.end(h);
  }

  // Rows run along the first of a face's own axes, and are counted along the second.
  void find_crossings() {
    for (Index h = 0; h < 3 * triangles_.size(); ++h) {
      report(h);
      if (!on_edge(h) || !is_corner_[connectivity_.start(h)]) continue;
      const AxisLabel label = labels_[h / 3];
      const auto u = static_cast<std::size_t>((axis_of(label) + 1) % 3), v = (u + 1) % 3;
      const Place from = place_of(connectivity_.start(h)), to = place_of(end_of_edge(h));
      if (from[v] == to[v]) continue;
      const auto [low, high] = std::minmax(from[v], to[v]);
      // The face is on the left, seen from outside.
      const int change = (to[v] > from[v] ? -1 : 1) * sign_of(label);
      for (Index row = low; row < high; ++row)
        crossings_.push_back({patches_[h / 3], row, from[u], change});
    }
  }

  // By the crossings along each row; returns how many there are. A face's plane is that of any of its corners.
  std::size_t count_cells() {
    for (Index f = 0; f < triangles_.size(); ++f)
      if (patches_[f] == triangle_of_.size()) triangle_of_.push_back(f);
    int winding = 0;
    for (std::size_t i = 0; i < crossings_.size(); ++i) {
      report(i);
      const Crossing& c = crossings_[i];
      winding += c.change;
      const bool last = i + 1 == crossings_.size();
      if (!last && crossings_[i + 1].patch == c.patch && crossings_[i + 1].row == c.row) {
        const Crossing& next = crossings_[i + 1];
        if (next.at == c.at) continue;
        if (winding < 0 || winding > 1) overlapping_ = c.patch;
        if (winding != 1) continue;
        const AxisLabel label = labels_[triangle_of_[c.patch]];
        const auto axis = static_cast<std::size_t>(axis_of(label));
        Place place{};
        place[axis] = place_of(triangles_[triangle_of_[c.patch]][0])[axis];
        place[(axis + 2) % 3] = c.row;
        for (Index k = c.at; k < next.at; ++k) {
          place[(axis + 1) % 3] = k;
          cells_.push_back({place, axis_of(label), c.patch});
        }
      } else {
        if (winding != 0) overlapping_ = c.patch;
        winding = 0;
      }
    }
    return cells_.size();
  }

  std::string at(const Place& place) const {
    return "near " + mesh::place_text({planes_[0][place[0]], planes_[1][place[1]], planes_[2][place[2]]});
  }
  std::string between(Index first, Index second, const Place& place) const {
    return "first in faces " + std::to_string(first) + " and " + std::to_string(second) + " " + at(place);
  }

  std::string check_cells() {
    std::sort(cells_.begin(), cells_.end());
    for (std::size_t i = 1; i < cells_.size(); ++i) {
      const Cell &a = cells_[i - 1], &b = cells_[i];
      if (a.place == b.place && a.axis == b.axis) return between(a.patch, b.patch, a.place);
    }
    return {};
  }

  std::string check_edges() {
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      report(i);
      const Cell& c = cells_[i];
      const int u = (c.axis + 1) % 3, v = (c.axis + 2) % 3;
      Place beyond_u = c.place, beyond_v = c.place;
      ++beyond_u[static_cast<std::size_t>(u)];
      ++beyond_v[static_cast<std::size_t>(v)];
      edges_.push_back({c.place, u, c.patch});
      edges_.push_back({c.place, v, c.patch});
      edges_.push_back({beyond_v, u, c.patch});
      edges_.push_back({beyond_u, v, c.patch});
    }
    std::sort(edges_.begin(), edges_.end());
    for (std::size_t i = 2; i < edges_.size(); ++i) {
      const Edge &a = edges_[i - 2], &b = edges_[i];
      if (a.place == b.place && a.axis == b.axis) return between(a.patch, b.patch, a.place);
    }
    return {};
  }

  // Quadrants of the three planes through a vertex of the grid: 4 axis + 1 for what is beyond along the first of the
  // other axes + 2 for the second.
  std::string check_vertices() {
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      report(i);
      const Cell& c = cells_[i];
      for (unsigned corner = 0; corner < 4; ++corner) {
        Place place = c.place;
        place[static_cast<std::size_t>((c.axis + 1) % 3)] += corner % 2;
        place[static_cast<std::size_t>((c.axis + 2) % 3)] += corner / 2;
        vertices_.push_back({place, 4 * static_cast<unsigned>(c.axis) + 3 - corner});
      }
    }
    std::sort(vertices_.begin(), vertices_.end());
    for (std::size_t i = 0; i < vertices_.size();) {
      report(i);
      const std::size_t begin = i;
      unsigned quadrants = 0;
      for (; i < vertices_.size() && vertices_[i].place == vertices_[begin].place; ++i)
        quadrants |= 1U << vertices_[i].quadrant;
      if (!one_ring(quadrants)) return "first at the vertex " + at(vertices_[begin].place);
    }
    return {};
  }

  // Along each row of the first axis faces look back and forth by turns, the first one back.
  std::string check_sides() {
    const auto row = [](const Cell& c) { return std::pair(c.place[1], c.place[2]); };
    Array<Cell> across(host_.memory);
    for (const Cell& c : cells_)
      if (c.axis == 0) across.push_back(c);
    std::sort(across.begin(), across.end(), [&](const Cell& a, const Cell& b) {
      return std::pair(row(a), a.place[0]) < std::pair(row(b), b.place[0]);
    });
    int before = 1;
    for (std::size_t i = 0; i < across.size(); ++i) {
      report(i);
      const int now = sign_of(labels_[triangle_of_[across[i].patch]]);
      const bool last = i + 1 == across.size() || row(across[i + 1]) != row(across[i]);
      if (now == before || (last && now < 0))
        return "a part of the polycube lies in what is inside or outside already, " + at(across[i].place);
      before = last ? 1 : now;
    }
    return {};
  }

  // Each ray from the vertex has two of the quadrants or none. Those that hang together are looked for by rays.
  static bool one_ring(unsigned quadrants) {
    // Rays: 2 axis + 1 for what is beyond.
    const auto rays = [](unsigned quadrant) {
      const unsigned axis = quadrant / 4, u = (axis + 1) % 3, v = (axis + 2) % 3;
      return (1U << (2 * u + quadrant % 2)) | (1U << (2 * v + quadrant / 2 % 2));
    };
    unsigned first = 0;
    while ((quadrants >> first & 1U) == 0)
      ++first;
    unsigned reached = rays(first), left = quadrants & ~(1U << first);
    for (bool more = true; more;) {
      more = false;
      for (unsigned q = 0; q < 12; ++q) {
        if ((left >> q & 1U) == 0 || (rays(q) & reached) == 0) continue;
        reached |= rays(q);
        left &= ~(1U << q);
        more = true;
      }
    }
    return left == 0;
  }

  std::span<const Vector3> polycube_;
  std::span<const Triangle> triangles_;
  std::span<const AxisLabel> labels_;
  std::span<const Index> patches_;
  const Connectivity& connectivity_;
  const base::Host& host_;
  std::array<Array<double>, 3> planes_;
  Array<std::uint8_t> is_corner_;
  Array<Crossing> crossings_;
  Array<Cell> cells_;
  Array<Edge> edges_;
  Array<Vertex> vertices_;
  Array<Index> triangle_of_;  // of each patch, the first
  Index overlapping_ = no_index;
};

}  // namespace

std::optional<std::string> embedding_fault(std::span<const Vector3> polycube, std::span<const Triangle> triangles,
                                           std::span<const AxisLabel> labels, std::span<const Index> patches,
                                           const Connectivity& connectivity, std::size_t max_cells,
                                           const base::Host& host) {
  return Grid(polycube, triangles, labels, patches, connectivity, host).run(max_cells);
}

}  // namespace orbicube::polycube
