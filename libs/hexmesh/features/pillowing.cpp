#include "hexmesh/features/pillowing.h"

#include <algorithm>

#include "hexmesh/features/boundary_quads.h"
#include "mesh/topology/disjoint_sets.h"

namespace orbicube::hexmesh {
namespace {

class Pillow {
 public:
  Pillow(HexMesh& mesh, Array<Index>& labels, const IsCovered& is_covered, const base::Host& host)
      : mesh_(mesh),
        labels_(labels),
        is_covered_(is_covered),
        host_(host),
        chosen_(host.memory),
        place_(mesh.hexahedra.size(), no_index, host.memory),
        copy_(host.memory),
        centers_(host.memory) {}

  void run() {
    choose();
    const Array<HexFace> faces = faces_of(mesh_.hexahedra, mesh_.positions.size(), chosen_, host_);
    mesh::DisjointSets fans(8 * chosen_.size(), host_.memory);
    for (const HexFace& face : faces) {
      if (face.second == no_index || label(face.first) == 0 || label(face.first) != label(face.second)) continue;
      for (const Index v : face.quad)
        fans.unite(slot(face.first, v), slot(face.second, v));
    }
    find_centers(fans);
    copy_.assign(8 * chosen_.size(), no_index);
    Array<Hexahedron> sheet(host_.memory);
    Array<Index> sheet_labels(host_.memory);
    for (const HexFace& face : faces) {
      const bool outer = face.second == no_index;
      if (outer ? !is_covered_ || !is_covered_(face.first, face.quad) : label(face.first) == label(face.second))
        continue;
      for (const bool turned : {false, true}) {
        const Index own = turned ? face.second : face.first;
        if (own == no_index || label(own) == 0) continue;
        Quad quad = face.quad;
        if (turned) std::swap(quad[1], quad[3]);
        Hexahedron h{};
        for (std::size_t k = 0; k < 4; ++k) {
          h[k] = copy_of(own, quad[k], fans);
          h[k + 4] = quad[k];
        }
        sheet.push_back(h);
        sheet_labels.push_back(label(own));
      }
    }
    for (const Index i : chosen_) {
      for (std::size_t k = 0; label(i) != 0 && k < 8; ++k) {
        const Index c = copy_[fans.find(8 * place_[i] + static_cast<Index>(k))];
        if (c != no_index) mesh_.hexahedra[i][k] = c;
      }
    }
    mesh_.hexahedra.insert(mesh_.hexahedra.end(), sheet.begin(), sheet.end());
    labels_.insert(labels_.end(), sheet_labels.begin(), sheet_labels.end());
  }

 private:
  Index label(Index hexahedron) const { return labels_[hexahedron]; }

  // Hexahedra with a label and those that share a vertex with one.
  void choose() {
    Array<std::uint8_t> near(mesh_.positions.size(), 0, host_.memory);
    for (std::size_t i = 0; i < mesh_.hexahedra.size(); ++i) {
      for (std::size_t k = 0; labels_[i] != 0 && k < 8; ++k)
        near[mesh_.hexahedra[i][k]] = 1;
    }
    for (Index i = 0; i < mesh_.hexahedra.size(); ++i) {
      const Hexahedron& h = mesh_.hexahedra[i];
      if (std::none_of(h.begin(), h.end(), [&](Index v) { return near[v] != 0; })) continue;
      place_[i] = static_cast<Index>(chosen_.size());
      chosen_.push_back(i);
    }
  }

  // The number of a vertex in a hexahedron, among those of all chosen ones.
  Index slot(Index hexahedron, Index vertex) const {
    const Hexahedron& h = mesh_.hexahedra[hexahedron];
    return 8 * place_[hexahedron] + static_cast<Index>(std::find(h.begin(), h.end(), vertex) - h.begin());
  }

  // Of each fan the mean center of its hexahedra, and their number.
  void find_centers(mesh::DisjointSets& fans) {
    centers_.assign(8 * chosen_.size(), {Vector3::Zero(), 0});
    for (const Index i : chosen_) {
      if (label(i) == 0) continue;
      Vector3 center = Vector3::Zero();
      for (const Index v : mesh_.hexahedra[i])
        center += mesh_.positions[v] / 8;
      for (Index k = 0; k < 8; ++k) {
        auto& [sum, count] = centers_[fans.find(8 * place_[i] + k)];
        sum += center;
        ++count;
      }
    }
  }

  Index copy_of(Index hexahedron, Index vertex, mesh::DisjointSets& fans) {
    constexpr double part = 0.4;  // of the way to the center
    const Index fan = fans.find(slot(hexahedron, vertex));
    if (copy_[fan] == no_index) {
      copy_[fan] = static_cast<Index>(mesh_.positions.size());
      const auto& [sum, count] = centers_[fan];
      const Vector3 from = mesh_.positions[vertex];
      mesh_.positions.push_back(Vector3(from + part * (sum / count - from)));
    }
    return copy_[fan];
  }

  HexMesh& mesh_;
  Array<Index>& labels_;
  const IsCovered& is_covered_;
  const base::Host& host_;
  Array<Index> chosen_, place_;
  Array<Index> copy_;  // of each fan
  Array<std::pair<Vector3, double>> centers_;
};

}  // namespace

void pillow(HexMesh& mesh, Array<Index>& labels, const base::Host& host) {
  Pillow(mesh, labels, {}, host).run();
}

void pillow(HexMesh& mesh, Array<Index>& labels, const IsCovered& is_covered, const base::Host& host) {
  Pillow(mesh, labels, is_covered, host).run();
}

void pillow_one(HexMesh& mesh, Index hexahedron, const base::Host& host) {
  Array<Index> labels(mesh.hexahedra.size(), 0, host.memory);
  labels[hexahedron] = 1;
  Pillow(mesh, labels, {}, host).run();
}

}  // namespace orbicube::hexmesh
