#include "hexmesh/regions/hex_labels.h"

#include <algorithm>
#include <array>

#include "base/grouping.h"
#include "hexmesh/features/boundary_quads.h"
#include "mesh/regions/nearest_regions.h"
#include "mesh/topology/disjoint_sets.h"

namespace orbicube::hexmesh {
namespace {

Vector3 point_in_hexahedron(const HexMesh& mesh, const Hexahedron& h, const Vector3& at) {
  constexpr std::array<std::array<int, 3>, 8> corner = {
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
  Vector3 p = Vector3::Zero();
  for (std::size_t k = 0; k < 8; ++k) {
    double weight = 1;
    for (Eigen::Index d = 0; d < 3; ++d)
      weight *= corner[k][static_cast<std::size_t>(d)] == 1 ? at[d] : 1 - at[d];
    p += weight * mesh.positions[h[k]];
  }
  return p;
}

class HexLabels {
 public:
  HexLabels(const HexMesh& mesh, const mesh::Mesh& solid, const RegionInterfaces& interfaces, const base::Host& host)
      : mesh_(mesh),
        solid_(solid),
        interfaces_(interfaces),
        host_(host),
        labels_(mesh.hexahedra.size(), host.memory),
        second_(mesh.hexahedra.size(), no_index, host.memory),
        outer_(mesh.hexahedra.size(), 0, host.memory),
        settled_(mesh.hexahedra.size(), 0, host.memory),
        around_(base::cells_around(std::span<const Hexahedron>(mesh.hexahedra), mesh.positions.size(), host.memory)),
        neighbors_(mesh.hexahedra.size(), {no_index, no_index, no_index, no_index, no_index, no_index}, host.memory) {
    for (const HexFace& face : faces_of(mesh.hexahedra, mesh.positions.size(), {}, host)) {
      if (face.second == no_index) {
        outer_[face.first] = 1;
        continue;
      }
      add_neighbor(face.first, face.second);
      add_neighbor(face.second, face.first);
    }
  }

  Array<Index> run() {
    take_most();
    constexpr int max_passes = 20;
    for (int pass = 0; pass < max_passes; ++pass) {
      const std::size_t changed = part_strangers() + give_up_spikes() + join_fans();
      if (changed == 0) break;
    }
    return std::move(labels_);
  }

 private:
  static constexpr std::uint8_t max_changes = 3;  // of a hexahedron: they might go on otherwise

  void add_neighbor(Index of, Index other) {
    *std::find(neighbors_[of].begin(), neighbors_[of].end(), no_index) = other;
  }

  // Few points tell where all of them agree.
  void take_most() {
    Array<Index> all(mesh_.hexahedra.size(), host_.memory);
    for (Index i = 0; i < all.size(); ++i)
      all[i] = i;
    take_most(all, {0.1, 0.9});
    Array<Index> mixed(host_.memory);
    for (Index i = 0; i < all.size(); ++i)
      if (settled_[i] == 0) mixed.push_back(i);
    take_most(mixed, {0.1, 0.3, 0.5, 0.7, 0.9});
    std::fill(settled_.begin(), settled_.end(), std::uint8_t{0});
  }

  void take_most(const Array<Index>& hexahedra, std::initializer_list<double> at) {
    Array<Vector3> points(host_.memory);
    for (const Index i : hexahedra) {
      for (const double x : at)
        for (const double y : at)
          for (const double z : at)
            points.push_back(point_in_hexahedron(mesh_, mesh_.hexahedra[i], {x, y, z}));
    }
    Array<std::int32_t> regions = mesh::nearest_cell_regions(solid_, points, host_);
    regions.resize(points.size(), 0);
    const std::size_t each = at.size() * at.size() * at.size();
    Array<std::size_t> count(interfaces_.numbers().size() + 1, host_.memory);
    for (std::size_t i = 0; i < hexahedra.size(); ++i) {
      std::fill(count.begin(), count.end(), 0U);
      for (std::size_t k = 0; k < each; ++k)
        ++count[interfaces_.label_of(regions[i * each + k])];
      const auto most = std::max_element(count.begin(), count.end());
      labels_[hexahedra[i]] = static_cast<Index>(most - count.begin());
      settled_[hexahedra[i]] = *most == each ? 1 : 0;
      *most = 0;
      const auto next = std::max_element(count.begin(), count.end());
      if (*next > 0) second_[hexahedra[i]] = static_cast<Index>(next - count.begin());
    }
  }

  void change(Index hexahedron, Index label) {
    labels_[hexahedron] = label;
    ++settled_[hexahedron];
  }

  // Regions that share no face in the solid share none in the mesh, which would be squeezed onto a curve; nor do they
  // with the outside.
  std::size_t part_strangers() {
    std::size_t changed = 0;
    for (Index i = 0; i < labels_.size(); ++i) {
      if (settled_[i] >= max_changes || strangers_of(i, labels_[i]) == 0) continue;
      Index best = labels_[i];
      int least = strangers_of(i, best);
      const auto consider = [&](Index label) {
        if (label == no_index || strangers_of(i, label) >= least) return;
        least = strangers_of(i, label);
        best = label;
      };
      consider(second_[i]);
      for (const Index n : neighbors_[i])
        if (n != no_index) consider(labels_[n]);
      for (Index label = 1; label <= interfaces_.numbers().size(); ++label)
        consider(label);
      if (best == labels_[i]) continue;
      change(i, best);
      ++changed;
    }
    return changed;
  }

  // Faces of a hexahedron beyond which is what its region does not meet.
  int strangers_of(Index hexahedron, Index label) const {
    int count = outer_[hexahedron] != 0 && !interfaces_.meet(0, label) ? 1 : 0;
    for (const Index n : neighbors_[hexahedron])
      count += n != no_index && !interfaces_.meet(labels_[n], label) ? 1 : 0;
    return count;
  }

  std::size_t give_up_spikes() {
    constexpr int most_faces = 4;
    std::size_t changed = 0;
    for (Index i = 0; i < labels_.size(); ++i) {
      if (settled_[i] >= max_changes) continue;
      for (const Index n : neighbors_[i]) {
        if (n == no_index || labels_[n] == labels_[i]) continue;
        const auto alike = std::count_if(neighbors_[i].begin(), neighbors_[i].end(),
                                         [&](Index m) { return m != no_index && labels_[m] == labels_[n]; });
        if (alike < most_faces) continue;
        change(i, labels_[n]);
        ++changed;
        break;
      }
    }
    return changed;
  }

  // Around each vertex the hexahedra of a region hang together by faces, or the smaller part goes to a neighbor.
  std::size_t join_fans() {
    std::size_t changed = 0;
    for (Index v = 0; v < around_.keys(); ++v) {
      if (v % base::items_between_reports == 0) host_.report("regions", v, around_.keys());
      const auto cells = around_[v];
      if (std::all_of(cells.begin(), cells.end(), [&](Index i) { return labels_[i] == labels_[cells[0]]; })) continue;
      changed += join_fans_at(v) ? 1 : 0;
    }
    return changed;
  }

  bool join_fans_at(Index v) {
    const auto cells = around_[v];
    mesh::DisjointSets fans(cells.size(), host_.memory);
    for (Index a = 0; a < cells.size(); ++a) {
      for (Index b = 0; b < a; ++b)
        if (labels_[cells[a]] == labels_[cells[b]] && share_a_face_at(v, cells[a], cells[b])) fans.unite(a, b);
    }
    const auto size = [&](Index a) {
      std::size_t count = 0;
      for (Index b = 0; b < cells.size(); ++b)
        count += fans.find(b) == fans.find(a) ? 1 : 0;
      return count;
    };
    Index smallest = no_index;
    for (Index a = 0; a < cells.size(); ++a) {
      bool other_fan = false, free = true;
      for (Index b = 0; b < cells.size(); ++b) {
        other_fan = other_fan || (labels_[cells[a]] == labels_[cells[b]] && fans.find(a) != fans.find(b));
        free = free && (fans.find(a) != fans.find(b) || settled_[cells[b]] < max_changes);
      }
      if (other_fan && free && (smallest == no_index || size(a) < size(smallest))) smallest = a;
    }
    if (smallest == no_index) return false;
    const Index to = label_beside(v, cells, smallest, fans);
    if (to == no_index) return false;
    const Index fan = fans.find(smallest);
    for (Index b = 0; b < cells.size(); ++b)
      if (fans.find(b) == fan) change(cells[b], to);
    return true;
  }

  // That of most faces at the vertex between the fan and others.
  template <class Cells>
  Index label_beside(Index v, const Cells& cells, Index fan, mesh::DisjointSets& fans) const {
    Array<std::size_t> count(interfaces_.numbers().size() + 1, 0, host_.memory);
    for (Index a = 0; a < cells.size(); ++a) {
      for (Index b = 0; b < cells.size(); ++b) {
        if (fans.find(a) != fans.find(fan) || fans.find(b) == fans.find(fan)) continue;
        if (share_a_face_at(v, cells[a], cells[b])) ++count[labels_[cells[b]]];
      }
    }
    const auto most = std::max_element(count.begin(), count.end());
    return *most == 0 ? no_index : static_cast<Index>(most - count.begin());
  }

  bool share_a_face_at(Index v, Index a, Index b) const {
    if (std::find(neighbors_[a].begin(), neighbors_[a].end(), b) == neighbors_[a].end()) return false;
    std::size_t shared = 0;
    bool with_v = false;
    for (const Index x : mesh_.hexahedra[a]) {
      const Hexahedron& h = mesh_.hexahedra[b];
      if (std::find(h.begin(), h.end(), x) == h.end()) continue;
      ++shared;
      with_v = with_v || x == v;
    }
    return shared >= 4 && with_v;
  }

  const HexMesh& mesh_;
  const mesh::Mesh& solid_;
  const RegionInterfaces& interfaces_;
  const base::Host& host_;
  Array<Index> labels_;
  Array<Index> second_;        // label of the region with the second largest part
  Array<std::uint8_t> outer_;  // whether a hexahedron has a face on the boundary
  Array<std::uint8_t> settled_;
  base::Groups<Index, Index> around_;
  Array<std::array<Index, 6>> neighbors_;
};

}  // namespace

Array<Index> labels_of_hexahedra(const HexMesh& mesh, const mesh::Mesh& solid, const RegionInterfaces& interfaces,
                                 const base::Host& host) {
  return HexLabels(mesh, solid, interfaces, host).run();
}

}  // namespace orbicube::hexmesh
