#include "hexmesh/grid/grid_extraction.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <tuple>

#include "base/error.h"
#include "base/grouping.h"
#include "mesh/search/predicates.h"

namespace orbicube::hexmesh {
namespace {

using Connectivity = mesh::TetrahedralConnectivity;
using mesh::orientation_3d;

// A point in a chart, and which of the tetrahedron's faces it lies on: bit k for the one opposite corner k.
struct Place {
  Index tetrahedron;
  Vector3 point;
  unsigned faces;
};

class Extraction {
 public:
  Extraction(const volume_map::FrameMap& map, const base::Host& host)
      : map_(map),
        host_(host),
        connectivity_(map.solid.positions.size(), map.solid.tetrahedra, host),
        around_(base::cells_around(std::span<const Tetrahedron>(map.solid.tetrahedra), map.solid.positions.size(),
                                   host.memory)),
        mesh_(host.memory) {}

  HexMesh run() {
    struct Key {
      Index tetrahedron;
      std::array<std::int32_t, 3> point;
      Index slot;  // 8 hexahedron + corner
    };
    Array<Key> keys(host_.memory);
    double volume = 0, boxes = 0;
    for (const auto& c : map_.charts) {
      const Vector3 box =
          c[0].cwiseMax(c[1]).cwiseMax(c[2]).cwiseMax(c[3]) - c[0].cwiseMin(c[1]).cwiseMin(c[2]).cwiseMin(c[3]);
      boxes += (box[0] + 1) * (box[1] + 1) * (box[2] + 1);
    }
    constexpr double most = 1e10;
    if (boxes > most) throw base::Error("no-valid-result", "the charts are too large for their cells");
    Index cells = 0;
    for (Index t = 0; t < map_.charts.size(); ++t) {
      if (t % 64 == 0) host_.report("grid", t, map_.charts.size());
      const auto& c = map_.charts[t];
      volume += (c[1] - c[0]).dot((c[2] - c[0]).cross(c[3] - c[0])) / 6;
      for_cells(t, [&](const Vector3& middle) {
        const Index cell = cells++;
        for (Index k = 0; k < 8; ++k) {
          const Place place = canonical(walk(t, middle, middle + 0.5 * direction(k)));
          keys.push_back({place.tetrahedron,
                          {static_cast<std::int32_t>(place.point[0]), static_cast<std::int32_t>(place.point[1]),
                           static_cast<std::int32_t>(place.point[2])},
                          8 * cell + k});
        }
      });
    }
    if (std::abs(volume - cells) > 1e-6 * (1 + volume)) {
      throw base::Error("no-valid-result", "the charts have a volume of " + std::to_string(volume) + " cells, and " +
                                               std::to_string(cells) + " were found");
    }
    std::sort(keys.begin(), keys.end(), [](const Key& a, const Key& b) {
      return std::tie(a.tetrahedron, a.point, a.slot) < std::tie(b.tetrahedron, b.point, b.slot);
    });
    mesh_.hexahedra.resize(cells);
    for (std::size_t i = 0; i < keys.size(); ++i) {
      if (i == 0 || keys[i].tetrahedron != keys[i - 1].tetrahedron || keys[i].point != keys[i - 1].point)
        mesh_.positions.push_back(
            in_space(keys[i].tetrahedron, {static_cast<double>(keys[i].point[0]), static_cast<double>(keys[i].point[1]),
                                           static_cast<double>(keys[i].point[2])}));
      mesh_.hexahedra[keys[i].slot / 8][keys[i].slot % 8] = static_cast<Index>(mesh_.positions.size() - 1);
    }
    find_boundary();
    return std::move(mesh_);
  }

 private:
  static Vector3 direction(Index corner) {
    constexpr std::array<std::array<double, 3>, 8> table = {
        {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}};
    return {table[corner][0], table[corner][1], table[corner][2]};
  }

  // On which side of each face, counter-clockwise from outside, the point is: positive inside.
  int side(Index t, Index k, const Vector3& x) const {
    const auto& c = map_.charts[t];
    const auto& f = mesh::face_corners[k];
    return -orientation_3d(c[f[0]], c[f[1]], c[f[2]], x);
  }

  // The faces that the point lies on, if it is in the tetrahedron.
  std::optional<unsigned> inside(Index t, const Vector3& x) const {
    unsigned faces = 0;
    for (Index k = 0; k < 4; ++k) {
      const int s = side(t, k, x);
      if (s < 0) return std::nullopt;
      faces |= s == 0 ? 1U << k : 0U;
    }
    return faces;
  }

  // The middles of the cells that belong to a tetrahedron. One on what several have in common is the first one's.
  template <class Visit>
  void for_cells(Index t, const Visit& visit) const {
    const auto& c = map_.charts[t];
    const Vector3 low = c[0].cwiseMin(c[1]).cwiseMin(c[2]).cwiseMin(c[3]);
    const Vector3 high = c[0].cwiseMax(c[1]).cwiseMax(c[2]).cwiseMax(c[3]);
    for (double x = std::floor(low[0]) + 0.5; x <= high[0]; ++x) {
      for (double y = std::floor(low[1]) + 0.5; y <= high[1]; ++y) {
        host_.report("grid", t, map_.charts.size());
        for (double z = std::floor(low[2]) + 0.5; z <= high[2]; ++z) {
          const Vector3 middle(x, y, z);
          const auto faces = inside(t, middle);
          if (faces && first_around(t, *faces) == t) visit(middle);
        }
      }
    }
  }

  template <class Visit>
  void for_common(Index t, unsigned faces, const Visit& visit) const {
    std::array<Index, 4> held{};
    std::size_t count = 0;
    for (Index k = 0; k < 4; ++k) {
      if ((faces >> k & 1U) == 0) held[count++] = map_.solid.tetrahedra[t][k];
    }
    for (const Index near : around_[held[0]]) {
      const Tetrahedron& other = map_.solid.tetrahedra[near];
      bool all = true;
      for (std::size_t k = 1; k < count; ++k)
        all = all && std::find(other.begin(), other.end(), held[k]) != other.end();
      if (all) visit(near);
    }
  }
  // The first of the tetrahedra that have what lies on all these faces in common.
  Index first_around(Index t, unsigned faces) const {
    Index first = t;
    if (faces != 0) for_common(t, faces, [&](Index other) { first = std::min(first, other); });
    return first;
  }

  // The same point in the first tetrahedron that has it.
  Place canonical(const Place& place) const {
    const Index first = first_around(place.tetrahedron, place.faces);
    if (first == place.tetrahedron) return place;
    // From one to the next around what they have in common; any way leads to the same point.
    struct Reached {
      Index tetrahedron;
      Vector3 point;
    };
    Array<Reached> queue({{place.tetrahedron, place.point}}, host_.memory);
    Array<Index> common(host_.memory);
    for_common(place.tetrahedron, place.faces, [&](Index t) { common.push_back(t); });
    for (std::size_t i = 0; i < queue.size(); ++i) {
      const Reached now = queue[i];
      if (now.tetrahedron == first) return {first, now.point, 0};
      for (Index face = 4 * now.tetrahedron; face < 4 * now.tetrahedron + 4; ++face) {
        const Index other = connectivity_.opposite(face);
        if (other == no_index || std::find(common.begin(), common.end(), other / 4) == common.end() ||
            std::find_if(queue.begin(), queue.end(), [&](const Reached& r) { return r.tetrahedron == other / 4; }) !=
                queue.end())
          continue;
        queue.push_back({other / 4, map_.transition[face](now.point)});
      }
    }
    throw base::Error("no-valid-result", "the solid touches itself in a vertex or along an edge");
  }

  // Straight from a point near `middle`, which the tetrahedron has, to `to`, which is in the same cell.
  Place walk(Index t, const Vector3& middle, const Vector3& to) const {
    constexpr int max_attempts = 64;
    const auto& c = map_.charts[t];
    const Vector3 centre = 0.25 * (c[0] + c[1] + c[2] + c[3]);
    for (int attempt = 0; attempt < max_attempts; ++attempt) {
      // Another point of the tetrahedron where the line meets an edge.
      Vector3 aim = centre;
      for (std::size_t k = 0; k < 4; ++k) {
        const double weight = std::fmod(0.6180339887498949 * (attempt + 1) * static_cast<double>(k + 1), 1.0);
        aim += 0.2 * weight * (c[k] - centre);
      }
      double part = std::min(0.5, 0.25 / std::max((aim - middle).cwiseAbs().maxCoeff(), 1e-9));
      Vector3 from = middle + part * (aim - middle);
      for (double& x : from)
        x = std::ldexp(std::round(std::ldexp(x, 40)), -40);
      const auto on = inside(t, from);
      if (!on || *on != 0) continue;
      if (const auto place = line(t, from, to)) return *place;
    }
    throw base::Error("no-valid-result", "a corner of a cell cannot be reached from its middle");
  }

  std::optional<Place> line(Index t, Vector3 from, Vector3 to) const {
    constexpr int most = 100000;
    Index entered = no_index;
    for (int step = 0; step < most; ++step) {
      if (const auto faces = inside(t, to)) return Place{t, to, *faces};
      const auto& c = map_.charts[t];
      Index exit = no_index;
      for (Index k = 0; k < 4 && exit == no_index; ++k) {
        if (4 * t + k == entered || side(t, k, to) >= 0) continue;
        const auto& f = mesh::face_corners[k];
        int turn = 0;
        for (std::size_t e = 0; e < 3; ++e)
          turn += orientation_3d(from, to, c[f[e]], c[f[(e + 1) % 3]]);
        if (turn == 3 || turn == -3) exit = 4 * t + k;
      }
      if (exit == no_index) return std::nullopt;
      const Index other = connectivity_.opposite(exit);
      if (other == no_index) return std::nullopt;
      from = map_.transition[exit](from);
      to = map_.transition[exit](to);
      entered = other;
      t = other / 4;
    }
    return std::nullopt;
  }

  Vector3 in_space(Index t, const Vector3& x) const {
    const auto& c = map_.charts[t];
    Eigen::Matrix3d edges;
    edges << c[1] - c[0], c[2] - c[0], c[3] - c[0];
    const Vector3 w = edges.inverse() * (x - c[0]);
    const Tetrahedron& v = map_.solid.tetrahedra[t];
    const auto& p = map_.solid.positions;
    return (1 - w.sum()) * p[v[0]] + w[0] * p[v[1]] + w[1] * p[v[2]] + w[2] * p[v[3]];
  }

  // Faces of one hexahedron only, and the patches that they are on: those of the map's boundary where lines from the
  // middle of their cells end.
  void find_boundary() {
    struct Face {
      std::array<Index, 4> key;
      Index hexahedron, side;
    };
    Array<Face> faces(host_.memory);
    for (Index h = 0; h < mesh_.hexahedra.size(); ++h) {
      for (Index s = 0; s < 6; ++s) {
        Face face{{}, h, s};
        for (std::size_t k = 0; k < 4; ++k)
          face.key[k] = mesh_.hexahedra[h][hexahedron_faces[s][k]];
        std::sort(face.key.begin(), face.key.end());
        if (std::adjacent_find(face.key.begin(), face.key.end()) != face.key.end())
          throw base::Error("no-valid-result", "a hexahedron meets itself: there are too few cells");
        faces.push_back(face);
      }
    }
    host_.report("grid", 0, 0);
    std::sort(faces.begin(), faces.end(), [](const Face& a, const Face& b) {
      return std::tie(a.key, a.hexahedron, a.side) < std::tie(b.key, b.hexahedron, b.side);
    });
    Array<Index> sides(host_.memory);
    for (std::size_t i = 0; i < faces.size();) {
      std::size_t end = i;
      while (end < faces.size() && faces[end].key == faces[i].key)
        ++end;
      if (end - i > 2) throw base::Error("no-valid-result", "three hexahedra meet in a face: there are too few cells");
      if (end - i == 1) sides.push_back(6 * faces[i].hexahedron + faces[i].side);
      i = end;
    }
    std::sort(sides.begin(), sides.end());
    for (const Index s : sides) {
      Quad quad;
      for (std::size_t k = 0; k < 4; ++k)
        quad[k] = mesh_.hexahedra[s / 6][hexahedron_faces[s % 6][k]];
      mesh_.quads.push_back(quad);
    }
    set_patches(sides);
  }

  void set_patches(std::span<const Index> sides) {
    mesh_.quad_patches.assign(sides.size(), no_index);
    Index cell = 0;
    std::size_t next = 0;
    for (Index t = 0; t < map_.charts.size() && next < sides.size(); ++t) {
      for_cells(t, [&](const Vector3& middle) {
        for (; next < sides.size() && sides[next] / 6 == cell; ++next)
          mesh_.quad_patches[next] = patch_beyond(t, middle, sides[next] % 6);
        ++cell;
      });
    }
  }

  Index patch_beyond(Index t, const Vector3& middle, Index s) const {
    constexpr int max_attempts = 64;
    host_.report("grid", 0, 0);
    Vector3 normal = Vector3::Zero();
    for (const std::uint8_t corner : hexahedron_faces[s])
      normal += 0.25 * direction(corner);
    Eigen::Index axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    for (int attempt = 0; attempt < max_attempts; ++attempt) {
      Vector3 to = middle + 0.5 * normal;
      for (const int other : {1, 2}) {
        double& x = to[(axis + other) % 3];
        x += std::ldexp(std::round(std::ldexp(0.2 * std::fmod(0.7548776662466927 * (attempt + 1) * other, 1.0), 30)),
                        -30);
      }
      const Place place = walk(t, middle, to);
      for (Index k = 0; k < 4; ++k) {
        const Index face = 4 * place.tetrahedron + k;
        if (place.faces == 1U << k && connectivity_.on_boundary(face)) return map_.patch[face];
      }
    }
    throw base::Error("no-valid-result", "a hexahedron has a free face inside the solid");
  }

  const volume_map::FrameMap& map_;
  const base::Host& host_;
  const Connectivity connectivity_;
  base::Groups<Index, Index> around_;
  HexMesh mesh_;
};

}  // namespace

HexMesh extract_hexahedra(const volume_map::FrameMap& map, const base::Host& host) {
  return Extraction(map, host).run();
}

}  // namespace orbicube::hexmesh
