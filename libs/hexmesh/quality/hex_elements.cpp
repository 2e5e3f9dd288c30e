#include "hexmesh/quality/hex_elements.h"

#include <Eigen/Dense>
#include <algorithm>

#include "hexmesh/certificate/hex_tetrahedra.h"

namespace orbicube::hexmesh {
namespace {

constexpr double padding_length = 0.6;  // across the layer at the boundary

}  // namespace

HexElements::HexElements(const HexMesh& mesh, const base::Host& host)
    : mesh_(mesh), host_(host), elements_(host.memory), edges_(mesh.hexahedra.size(), no_index, host.memory) {
  elements_.reserve(corner_tetrahedra * mesh.hexahedra.size());
  for (const Hexahedron& h : mesh.hexahedra) {
    for (std::size_t k = 0; k < corner_tetrahedra; ++k)
      elements_.push_back(hex_tetrahedra[k].element(h));
  }
}

// Calls body(tetrahedron, element) for each tetrahedron of a hexahedron that counts.
template <class Body>
void HexElements::for_tetrahedra(std::size_t hexahedron, const Body& body) {
  for (std::size_t k = 0; k < corner_tetrahedra; ++k)
    body(hex_tetrahedra[k], elements_[corner_tetrahedra * hexahedron + k]);
  if (edges_[hexahedron] == no_index) return;
  for (std::size_t k = 0; k < edge_tetrahedra; ++k)
    body(hex_tetrahedra[corner_tetrahedra + k], elements_[edges_[hexahedron] + k]);
}

void HexElements::set_shapes(double own, std::size_t padding) {
  for (std::size_t i = 0; i < mesh_.hexahedra.size(); ++i) {
    if (i % base::items_between_reports == 0) host_.report("smooth", 0, 0);
    const Hexahedron& h = mesh_.hexahedra[i];
    const bool padded = i + padding >= mesh_.hexahedra.size();
    std::array<double, 3> length;
    for (std::size_t d = 0; d < 3; ++d) {
      double mean = 0;
      for (const auto& e : edges_along[d])
        mean += 0.25 * (mesh_.positions[h[e[1]]] - mesh_.positions[h[e[0]]]).norm();
      const double wanted = d == 2 && padded ? padding_length : 1;
      length[d] = own * std::clamp(mean, 0.15, 3.0) + (1 - own) * wanted;
    }
    for_tetrahedra(i, [&](const HexTetrahedron& t, Element& element) { t.set_shape(length, element); });
  }
}

// Weights change as multipliers of constraints do.
void HexElements::set_weights(double max_weight) {
  constexpr double enough = 0.7;
  for (std::size_t i = 0; i < mesh_.hexahedra.size(); ++i) {
    if (i % base::items_between_reports == 0) host_.report("smooth", 0, 0);
    for_tetrahedra(i, [&](const HexTetrahedron& t, Element& element) {
      const double ratio = enough / std::max(0.02, t.scaled_jacobian(mesh_.positions, element));
      element.weight = std::clamp(ratio * ratio * element.weight, 1.0, max_weight);
    });
  }
}

Array<Index> HexElements::find_twisted(double least) const {
  Array<Index> twisted(host_.memory);
  for (Index i = 0; i < mesh_.hexahedra.size(); ++i) {
    if (i % base::items_between_reports == 0) host_.report("smooth", 0, 0);
    if (edges_[i] == no_index && min_bezier(mesh_.positions, mesh_.hexahedra[i]) <= least) twisted.push_back(i);
  }
  return twisted;
}

void HexElements::add_edges(std::span<const Index> twisted) {
  for (const Index i : twisted) {
    edges_[i] = static_cast<Index>(elements_.size());
    for (std::size_t k = corner_tetrahedra; k < hex_tetrahedra.size(); ++k)
      elements_.push_back(hex_tetrahedra[k].element(mesh_.hexahedra[i]));
  }
}

void HexElements::keep_positive_edges(std::span<const Index> twisted) {
  std::size_t end = elements_.size() - edge_tetrahedra * twisted.size();
  for (const Index i : twisted) {
    const std::size_t first = edges_[i];
    bool positive = true;
    for (std::size_t k = 0; k < edge_tetrahedra; ++k)
      positive &= elements_[first + k].jacobian(mesh_.positions).determinant() > 0;
    edges_[i] = positive ? static_cast<Index>(end) : no_index;
    for (std::size_t k = 0; k < edge_tetrahedra && positive; ++k)
      elements_[end++] = elements_[first + k];
  }
  elements_.resize(end);
}

}  // namespace orbicube::hexmesh
