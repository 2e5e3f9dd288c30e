#include "frame_field/dual_graph.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

#include "mesh/hilbert_curve.h"

namespace orbicube::frame_field {
namespace {

constexpr std::size_t items_between_reports = 16384;

struct Place {
  std::uint64_t key;
  Index tetrahedron;
  bool operator<(const Place& o) const { return key != o.key ? key < o.key : tetrahedron < o.tetrahedron; }
};

// Area of the shared face over the distance of the centres; 1 where that is no positive number.
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

DualGraph make_dual_graph(std::span<const Vector3> positions, const mesh::TetrahedralConnectivity& connectivity,
                          Weighting weighting, const base::Host& host) {
  const auto tetrahedra = connectivity.tetrahedra();
  const std::size_t count = tetrahedra.size();
  DualGraph graph(host.memory);

  Vector3 low = Vector3::Constant(HUGE_VAL), high = -low;
  for (const Tetrahedron& t : tetrahedra) {
    for (const Index v : t) {
      low = low.cwiseMin(positions[v]);
      high = high.cwiseMax(positions[v]);
    }
  }
  const double size = count == 0 ? 1 : std::max((high - low).maxCoeff(), 1e-300);
  Array<Place> order(count, host.memory);
  for (Index t = 0; t < count; ++t) {
    if (t % items_between_reports == 0) host.report("ordering tetrahedra", t, count);
    Vector3 sum = Vector3::Zero();
    for (const Index v : tetrahedra[t])
      sum += (positions[v] - low) / size;
    std::array<std::uint32_t, 3> cell{};
    for (std::size_t k = 0; k < 3; ++k)
      cell[k] = static_cast<std::uint32_t>(sum[static_cast<Eigen::Index>(k)] * (0.25 * ((1 << 21) - 1)));
    order[t] = {mesh::hilbert_key(cell), t};
  }
  std::ranges::sort(order, std::less<>());
  graph.tetrahedron.resize(count);
  Array<Index> node(count, host.memory);
  for (Index i = 0; i < count; ++i) {
    graph.tetrahedron[i] = order[i].tetrahedron;
    node[order[i].tetrahedron] = i;
  }

  graph.others.resize(count);
  graph.weights.resize(count);
  double sum = 0;
  std::size_t ends = 0;
  for (Index i = 0; i < count; ++i) {
    if (i % items_between_reports == 0) host.report("linking tetrahedra", i, count);
    const Index t = graph.tetrahedron[i];
    for (Index k = 0; k < 4; ++k) {
      const Index face = 4 * t + k;
      const bool inner = !connectivity.on_boundary(face);
      graph.others[i][k] = inner ? node[connectivity.neighbour(t, k)] : i;
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
