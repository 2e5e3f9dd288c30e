#include "frame_field/graph/dual_graph.h"

#include <Eigen/Geometry>

#include <cmath>

#include "mesh/search/hilbert_curve.h"

namespace orbicube::frame_field {
namespace {

// Area of the shared face over the distance of the centers; 1 where that is no positive number.
double geometric_weight(std::span<const Vector3> positions, const mesh::TetrahedralConnectivity& connectivity,
                        Index face) {
  const auto centre = [&](Index t) {
    const Tetrahedron& c = connectivity.tetrahedra()[t];
    return Vector3(0.25 * ((positions[c[0]] + positions[c[1]]) + (positions[c[2]] + positions[c[3]])));
  };
  const mesh::Triangle v = connectivity.vertices(face);
  const double area = 0.5 * (positions[v[1]] - positions[v[0]]).cross(positions[v[2]] - positions[v[0]]).norm();
  const Index other = connectivity.opposite(face);
  const double weight =
      area / (centre(connectivity.tetrahedron_of(face)) - centre(connectivity.tetrahedron_of(other))).norm();
  return std::isfinite(weight) && weight > 0 ? weight : 1;
}

}  // namespace

Array<Index> tetrahedral_order(std::span<const Vector3> positions, std::span<const Tetrahedron> tetrahedra,
                               const base::Host& host) {
  Array<Vector3> centres(host.memory);
  centres.reserve(tetrahedra.size());
  for (const Tetrahedron& t : tetrahedra)
    centres.push_back(0.25 * ((positions[t[0]] + positions[t[1]]) + (positions[t[2]] + positions[t[3]])));
  return mesh::hilbert_order(centres, host);
}

DualGraph make_dual_graph(std::span<const Vector3> positions, const mesh::TetrahedralConnectivity& connectivity,
                          Weighting weighting, const base::Host& host) {
  const std::size_t count = connectivity.tetrahedra().size();
  DualGraph graph(host.memory);
  graph.tetrahedron = tetrahedral_order(positions, connectivity.tetrahedra(), host);
  Array<Index> node(count, host.memory);
  for (Index i = 0; i < count; ++i)
    node[graph.tetrahedron[i]] = i;

  graph.others.resize(count);
  graph.weights.resize(count);
  double sum = 0;
  std::size_t ends = 0;
  for (Index i = 0; i < count; ++i) {
    if (i % base::items_between_reports == 0) host.report("linking tetrahedra", i, count);
    const Index t = graph.tetrahedron[i];
    for (Index k = 0; k < 4; ++k) {
      const Index face = 4 * t + k;
      const bool inner = !connectivity.on_boundary(face);
      graph.others[i][k] = inner ? node[connectivity.neighbor(t, k)] : i;
      double weight = inner ? 1 : 0;
      if (inner && weighting == Weighting::geometric) weight = geometric_weight(positions, connectivity, face);
      graph.weights[i][k] = static_cast<float>(weight);
      sum += weight;
      ends += inner ? 1 : 0;
    }
  }
  graph.links = ends / 2;
  if (weighting == Weighting::geometric && sum > 0) {
    const double scale = static_cast<double>(ends) / sum;
    for (auto& weights : graph.weights) {
      for (float& w : weights)
        w = static_cast<float>(w * scale);
    }
  }
  return graph;
}

Field by_node(const DualGraph& graph, std::span<const Quaternion> by_tetrahedron, std::pmr::memory_resource* memory) {
  Field result(graph.size(), memory);
  for (std::size_t i = 0; i < graph.size(); ++i)
    result[i] = by_tetrahedron[graph.tetrahedron[i]];
  return result;
}

void by_tetrahedron(const DualGraph& graph, const Field& by_node, std::span<Quaternion> result) {
  for (std::size_t i = 0; i < graph.size(); ++i)
    result[graph.tetrahedron[i]] = by_node[i];
}

}  // namespace orbicube::frame_field
