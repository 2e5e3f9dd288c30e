#include "hexmesh/regions/region_targets.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace orbicube::hexmesh {

RegionTargets::RegionTargets(const HexMesh& mesh, const Array<Index>& labels, const base::Groups<Index, Index>& around,
                             const Sheets& sheets, const BoundaryLines& lines, RegionInterfaces& interfaces,
                             bool creases, const base::Host& host)
    : mesh_(mesh),
      labels_(labels),
      lines_(lines),
      interfaces_(interfaces),
      host_(host),
      quads_(mesh.hexahedra, mesh.positions.size(), host),
      patch_of_quad_(lines.patches_of(quads_, sheets)),
      vertices_(mesh.positions.size()) {
  classify(around);
  if (!creases) return;
  take_creases();
  take_corners();
}

void RegionTargets::classify(const base::Groups<Index, Index>& around) {
  for (Index v = 0; v < vertices_.size(); ++v) {
    LabelSet& set = vertices_[v].labels;
    for (const Index i : around[v])
      set.push_back(labels_[i]);
  }
  for (const Index v : quads_.vertices())
    vertices_[v].labels.push_back(0);
  for (Vertex& vertex : vertices_) {
    LabelSet& set = vertex.labels;
    std::sort(set.begin(), set.end());
    set.erase(std::unique(set.begin(), set.end()), set.end());
    const std::size_t outside = set.empty() || set[0] != 0 ? 0 : 1;
    if (set.size() > 1 + outside) vertex.kind = Kind::interface;
  }
  for (const Index v : quads_.vertices())
    classify_on_boundary(v);
}

void RegionTargets::classify_on_boundary(Index v) {
  Vertex& vertex = vertices_[v];
  LabelSet patches;
  bool along = false;  // a line that is where regions meet, too
  quads_.for_each_outgoing(v, [&](Index h) {
    patches.push_back(patch_of_quad_[h / 4]);
    const Index o = quads_.opposite(h);
    along = along || (patch_of_quad_[h / 4] != patch_of_quad_[o / 4] &&
                      labels_[quads_.owner(h / 4)] != labels_[quads_.owner(o / 4)]);
  });
  std::sort(patches.begin(), patches.end());
  patches.erase(std::unique(patches.begin(), patches.end()), patches.end());
  const bool corner = patches.size() > 2 || lines_.is_special(v);
  if (patches.size() == 2) vertex.patches = {patches[0], patches[1]};
  if (vertex.kind == Kind::interface) {
    if (corner || (patches.size() == 2 && !along)) vertex.point = point_of(v);
    return;
  }
  vertex.kind = corner ? Kind::fixed : patches.size() == 2 ? Kind::line : Kind::surface;
}

// Where the regions around a vertex of a sharp line meet on it; nothing where that is no point.
std::optional<Vector3> RegionTargets::point_of(Index v) {
  constexpr double near = 1.5, on_line = 0.25;  // edges: from the vertex, and from its sharp line

  const Vector3& p = mesh_.positions[v];
  Array<Vector3> points(host_.memory);
  interfaces_.vertices_near(vertices_[v].labels, p, near, points);
  std::optional<Vector3> best;
  double least = vertices_[v].patches.first == no_index ? near : on_line;
  for (const Vector3& q : points) {
    const double off =
        vertices_[v].patches.first == no_index ? (q - p).norm() : lines_.nearest(vertices_[v].patches, q).distance;
    // Of points on the line that near to the vertex.
    const double rating = off + 1e-3 * (q - p).norm();
    if (rating >= least) continue;
    least = rating;
    best = q;
  }
  return best;
}

void RegionTargets::take_creases() {
  constexpr double near = 0.6, along = 0.7;  // of the edge, and the cosine of its angle with the crease
  Array<std::pair<std::array<Index, 2>, Vector3>> sides(host_.memory);
  for (const HexFace& face : faces_of(mesh_.hexahedra, mesh_.positions.size(), {}, host_)) {
    if (face.second == no_index || labels_[face.first] == labels_[face.second]) continue;
    const auto& p = mesh_.positions;
    const Quad& q = face.quad;
    Vector3 normal = (p[q[2]] - p[q[0]]).cross(p[q[3]] - p[q[1]]).stableNormalized();
    if (labels_[face.first] > labels_[face.second]) normal = -normal;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto [low, high] = std::minmax(q[k], q[(k + 1) % 4]);
      sides.push_back({{low, high}, normal});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  constexpr double bent = 0.8;  // cosine
  for (std::size_t i = 1; i < sides.size(); ++i) {
    const auto [v, w] = sides[i].first;
    const LabelSet& labels = vertices_[v].labels;
    if (sides[i].first != sides[i - 1].first || sides[i].second.dot(sides[i - 1].second) > bent) continue;
    if (labels.size() != 2 || labels != vertices_[w].labels) continue;
    const Vector3 &p = mesh_.positions[v], &q = mesh_.positions[w];
    const auto at_v = interfaces_.nearest_on_crease(labels, p), at_w = interfaces_.nearest_on_crease(labels, q);
    const double edge = (q - p).norm();
    if (!at_v.found || std::max((at_v.position - p).norm(), (at_w.position - q).norm()) > near * edge) continue;
    if (std::abs((q - p).dot(at_v.direction)) < along * edge) continue;
    vertices_[v].on_crease = vertices_[w].on_crease = true;
  }
}

void RegionTargets::take_corners() {
  constexpr double near = 1.3;  // edges
  const mesh::VertexSearch search(mesh_.positions, host_);
  for (const RegionInterfaces::Corner& corner : interfaces_.corners()) {
    const Vector3& p = interfaces_.positions()[corner.vertex];
    Index nearest = no_index;
    double least = near;
    search.for_each_within(p, near, [&](Index v) {
      const Vertex& vertex = vertices_[v];
      if (vertex.kind != Kind::interface || vertex.labels != corner.labels) return;
      const double distance = (mesh_.positions[v] - p).norm();
      if (distance > least || (distance == least && v > nearest)) return;
      least = distance;
      nearest = v;
    });
    if (nearest != no_index && !vertices_[nearest].point) vertices_[nearest].point = p;
  }
}

// A vector that the boundary looks along at a vertex.
Vector3 RegionTargets::facing(Index v) const {
  Vector3 sum = Vector3::Zero();
  quads_.for_each_outgoing(v, [&](Index h) {
    const Quad& q = quads_.quads()[h / 4];
    sum += (mesh_.positions[q[2]] - mesh_.positions[q[0]]).cross(mesh_.positions[q[3]] - mesh_.positions[q[1]]);
  });
  return sum;
}

RegionTargets::Target RegionTargets::target(Index v) {
  const Vertex& vertex = vertices_[v];
  const Vector3& p = mesh_.positions[v];
  if (vertex.point) return {*vertex.point, Vector3::Zero(), 0};
  if (vertex.kind == Kind::line) {
    const BoundaryLines::Point at = lines_.nearest(vertex.patches, p);
    if (std::isfinite(at.distance)) return {at.position, at.tangent, 1};
    return {p, Vector3::Zero(), 0};
  }
  if (vertex.on_crease) {
    const RegionInterfaces::Place at = interfaces_.nearest_on_crease(vertex.labels, p);
    return {at.position, at.direction, 1};
  }
  const Vector3 from = vertex.kind == Kind::surface ? facing(v) : Vector3::Zero();
  const RegionInterfaces::Place at = interfaces_.nearest(vertex.labels, p, from);
  if (!at.found) return {p, Vector3::Zero(), 0};
  return {at.position, at.direction, at.dimension};
}

void RegionTargets::add_pull(Index v, double weight, Pull& pull) {
  constexpr double point = 4, curve = 2, sideways = 0.5, along = 0.03;  // times the weight
  constexpr double stay = 0.02, apart = 0.02;
  const Target to = target(v);
  const Vector3& p = mesh_.positions[v];
  if (to.dimension == 0) return pull.to_point(to.position, point * weight);
  if (to.dimension == 1) {
    const Vector3 a = to.direction.unitOrthogonal(), b = to.direction.cross(a);
    pull.to_plane(a, to.position, curve * weight);
    pull.to_plane(b, to.position, curve * weight);
    pull.to_point(to.position, along * weight);
    return;
  }
  pull.to_plane(to.direction, to.position, weight);
  Vector3 rest = to.position - p;
  rest -= to.direction * to.direction.dot(rest);
  const double length = rest.norm();
  if (length > apart) pull.to_plane(Vector3(rest / length), to.position, sideways * weight);
  pull.to_point(p, stay);
}

}  // namespace orbicube::hexmesh
