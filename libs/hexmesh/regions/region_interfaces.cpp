#include "hexmesh/regions/region_interfaces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

#include "base/host.h"

namespace orbicube::hexmesh {
namespace {

constexpr const char* regions_phase = "regions";
constexpr std::array<std::array<std::uint8_t, 3>, 4> faces_of_tetrahedron = {
    {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};

const double cosine_of_crease = std::cos(35 * std::numbers::pi / 180);

bool contains_all(const LabelSet& set, const LabelSet& of) {
  return std::includes(set.begin(), set.end(), of.begin(), of.end());
}

std::size_t count_common(const LabelSet& a, const LabelSet& b) {
  LabelSet both;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return both.size();
}

// Sorts keys with labels, and calls visit(key, labels) for each different key.
template <class Key, class Visit>
void for_each_set(Array<std::pair<Key, Index>>& entries, const Visit& visit) {
  std::sort(entries.begin(), entries.end());
  entries.erase(std::unique(entries.begin(), entries.end()), entries.end());
  LabelSet labels;
  for (std::size_t i = 0; i < entries.size();) {
    labels.clear();
    const Key key = entries[i].first;
    for (; i < entries.size() && entries[i].first == key; ++i)
      labels.push_back(entries[i].second);
    visit(key, labels);
  }
}

}  // namespace

RegionInterfaces::RegionInterfaces(std::span<const Vector3> positions, std::span<const mesh::Tetrahedron> tetrahedra,
                                   std::span<const std::int32_t> regions, const base::Host& host)
    : positions_(positions), host_(host), numbers_(regions.begin(), regions.end(), host.memory), between_(host.memory) {
  std::sort(numbers_.begin(), numbers_.end());
  numbers_.erase(std::unique(numbers_.begin(), numbers_.end()), numbers_.end());
  Array<Index> label(tetrahedra.size(), host.memory);
  for (std::size_t i = 0; i < tetrahedra.size(); ++i)
    label[i] = label_of(regions[i]);
  collect_faces(tetrahedra, label);
  if (!any_) return;
  collect_curves(tetrahedra, label);
  collect_creases();
  collect_corners();
}

Index RegionInterfaces::label_of(std::int32_t number) const {
  return static_cast<Index>(std::lower_bound(numbers_.begin(), numbers_.end(), number) - numbers_.begin()) + 1;
}

void RegionInterfaces::collect_faces(std::span<const mesh::Tetrahedron> tetrahedra, const Array<Index>& label) {
  struct Face {
    mesh::Triangle key, seen;
    Index label;
  };
  Array<Face> faces(host_.memory);
  faces.reserve(4 * tetrahedra.size());
  for (std::size_t i = 0; i < tetrahedra.size(); ++i) {
    if (i % base::items_between_reports == 0) host_.report(regions_phase, 0, 0);
    const mesh::Tetrahedron& t = tetrahedra[i];
    for (const auto& f : faces_of_tetrahedron) {
      const mesh::Triangle seen = {t[f[0]], t[f[1]], t[f[2]]};
      mesh::Triangle key = seen;
      std::sort(key.begin(), key.end());
      faces.push_back({key, seen, label[i]});
    }
  }
  std::sort(faces.begin(), faces.end(),
            [](const Face& a, const Face& b) { return std::tie(a.key, a.label) < std::tie(b.key, b.label); });
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const bool shared = i + 1 < faces.size() && faces[i].key == faces[i + 1].key;
    // Out of the greater label, which of the boundary is the region.
    const Face& from = shared ? faces[i + 1] : faces[i];
    const Index other = shared ? faces[i].label : 0;
    i += shared ? 1 : 0;
    if (from.label == other) continue;
    faces_.try_emplace({other, from.label}, host_.memory).first->second.push_back(from.seen);
    if (!shared) continue;
    any_ = true;
    between_.push_back(from.seen);
  }
}

void RegionInterfaces::collect_curves(std::span<const mesh::Tetrahedron> tetrahedra, const Array<Index>& label) {
  Array<std::uint8_t> on_face(positions_.size(), 0, host_.memory);
  for (const mesh::Triangle& t : between_) {
    for (const Index v : t)
      on_face[v] = 1;
  }
  Array<std::pair<mesh::Edge, Index>> around_edges(host_.memory);
  Array<std::pair<Index, Index>> around_vertices(host_.memory);
  const auto add = [&](std::span<const Index> cell, Index with) {
    for (std::size_t a = 0; a < cell.size(); ++a) {
      if (on_face[cell[a]] == 0) continue;
      around_vertices.emplace_back(cell[a], with);
      for (std::size_t b = a + 1; b < cell.size(); ++b) {
        if (on_face[cell[b]] == 0) continue;
        const auto [low, high] = std::minmax(cell[a], cell[b]);
        around_edges.push_back({{low, high}, with});
      }
    }
  };
  for (std::size_t i = 0; i < tetrahedra.size(); ++i) {
    if (i % base::items_between_reports == 0) host_.report(regions_phase, 0, 0);
    add(tetrahedra[i], label[i]);
  }
  for (const auto& [labels, faces] : faces_) {
    for (std::size_t i = 0; labels[0] == 0 && i < faces.size(); ++i)
      add(faces[i], 0);
  }
  for_each_set(around_edges, [&](const mesh::Edge& edge, const LabelSet& labels) {
    if (labels.size() > 2) curves_.try_emplace(labels, host_.memory).first->second.push_back(edge);
  });
  for_each_set(around_vertices, [&](Index v, const LabelSet& labels) {
    if (labels.size() > 2) points_.try_emplace(labels, host_.memory).first->second.push_back(v);
  });
}

void RegionInterfaces::collect_creases() {
  const auto normal = [&](const mesh::Triangle& t) {
    return (positions_[t[1]] - positions_[t[0]]).cross(positions_[t[2]] - positions_[t[0]]).stableNormalized();
  };
  Array<std::pair<mesh::Edge, Index>> sides(host_.memory);
  for (const auto& [labels, faces] : faces_) {
    if (labels[0] == 0) continue;
    sides.clear();
    for (Index f = 0; f < faces.size(); ++f) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [low, high] = std::minmax(faces[f][k], faces[f][(k + 1) % 3]);
        sides.push_back({{low, high}, f});
      }
    }
    std::sort(sides.begin(), sides.end());
    for (std::size_t i = 1; i < sides.size(); ++i) {
      if (sides[i].first != sides[i - 1].first) continue;
      if (normal(faces[sides[i].second]).dot(normal(faces[sides[i - 1].second])) < cosine_of_crease)
        creases_.try_emplace(labels, host_.memory).first->second.push_back(sides[i].first);
    }
  }
}

void RegionInterfaces::collect_corners() {
  std::map<Index, std::vector<Index>> neighbors;
  for (const auto* lines : {&curves_, &creases_}) {
    for (const auto& [labels, edges] : *lines) {
      for (const mesh::Edge& e : edges) {
        neighbors[e[0]].push_back(e[1]);
        neighbors[e[1]].push_back(e[0]);
      }
    }
  }
  std::map<Index, LabelSet> labels_at;
  for (const auto& [labels, vertices] : points_) {
    for (const Index v : vertices)
      labels_at[v] = labels;
  }
  for (const auto& [labels, edges] : creases_) {
    for (const mesh::Edge& e : edges) {
      labels_at.try_emplace(e[0], labels);
      labels_at.try_emplace(e[1], labels);
    }
  }
  for (const auto& [v, others] : neighbors) {
    bool corner = others.size() != 2;
    if (!corner) {
      const Vector3 in = positions_[v] - positions_[others[0]], out = positions_[others[1]] - positions_[v];
      corner = in.dot(out) < cosine_of_crease * in.norm() * out.norm();
    }
    if (corner) corners_.push_back({v, labels_at[v]});
  }
}

bool RegionInterfaces::has_clear_creases(double edge) const {
  constexpr double densest = 0.7;  // length of creases times an edge, over the area
  double length = 0, area = 0;
  for (const auto& [labels, edges] : creases_) {
    for (const mesh::Edge& e : edges)
      length += (positions_[e[1]] - positions_[e[0]]).norm();
  }
  for (const mesh::Triangle& t : between_)
    area += 0.5 * (positions_[t[1]] - positions_[t[0]]).cross(positions_[t[2]] - positions_[t[0]]).norm();
  return !(creases_.empty() && corners_.empty()) && length * edge <= densest * area;
}

Array<mesh::Triangle> RegionInterfaces::triangles_of(const LabelSet& labels, int& dimension) const {
  Array<mesh::Triangle> triangles(host_.memory);
  dimension = labels.size() == 2 ? 2 : labels.size() == 3 ? 1 : 0;
  if (dimension == 2) {
    if (const auto found = faces_.find(labels); found != faces_.end())
      triangles.assign(found->second.begin(), found->second.end());
    return triangles;
  }
  for (auto at = points_.begin(); dimension == 0 && at != points_.end(); ++at) {
    if (!contains_all(at->first, labels)) continue;
    for (const Index v : at->second)
      triangles.push_back({v, v, v});
  }
  if (!triangles.empty()) return triangles;
  dimension = 1;
  for (const auto& [set, edges] : curves_) {
    if (count_common(set, labels) < 3) continue;
    for (const mesh::Edge& e : edges)
      triangles.push_back({e[0], e[1], e[1]});
  }
  return triangles;
}

const RegionInterfaces::Stratum& RegionInterfaces::stratum(const LabelSet& labels) {
  const auto found = strata_.find(labels);
  if (found != strata_.end()) return found->second;
  int dimension = 0;
  Array<mesh::Triangle> triangles = triangles_of(labels, dimension);
  return strata_
      .emplace(std::piecewise_construct, std::forward_as_tuple(labels),
               std::forward_as_tuple(positions_, std::move(triangles), dimension, host_))
      .first->second;
}

RegionInterfaces::Place RegionInterfaces::nearest(const LabelSet& labels, const Vector3& p, const Vector3& facing) {
  const Stratum& s = stratum(labels);
  const auto normal = [&](Index t) {
    const mesh::Triangle& of = s.triangles[t];
    return Vector3((positions_[of[1]] - positions_[of[0]]).cross(positions_[of[2]] - positions_[of[0]]));
  };
  mesh::SurfacePoint found;
  if (s.dimension == 2 && facing != Vector3::Zero())
    found = s.search.nearest_of(p, [&](Index t) { return normal(t).dot(facing) > 0; });
  if (found.triangle == no_index) found = s.search.nearest(p);
  Place place;
  if (found.triangle == no_index) return place;
  const mesh::Triangle& of = s.triangles[found.triangle];
  place.position = found.position;
  place.dimension = s.dimension;
  place.found = true;
  if (s.dimension == 2) place.direction = normal(found.triangle).stableNormalized();
  if (s.dimension == 1) place.direction = (positions_[of[1]] - positions_[of[0]]).stableNormalized();
  return place;
}

RegionInterfaces::Place RegionInterfaces::nearest_on_crease(const LabelSet& labels, const Vector3& p) {
  Place place;
  const auto edges = creases_.find(labels);
  if (edges == creases_.end()) return place;
  auto found = strata_of_creases_.find(labels);
  if (found == strata_of_creases_.end()) {
    Array<mesh::Triangle> segments(host_.memory);
    for (const mesh::Edge& e : edges->second)
      segments.push_back({e[0], e[1], e[1]});
    found = strata_of_creases_
                .emplace(std::piecewise_construct, std::forward_as_tuple(labels),
                         std::forward_as_tuple(positions_, std::move(segments), 1, host_))
                .first;
  }
  const mesh::SurfacePoint at = found->second.search.nearest(p);
  const mesh::Triangle& of = found->second.triangles[at.triangle];
  place.position = at.position;
  place.direction = (positions_[of[1]] - positions_[of[0]]).stableNormalized();
  place.dimension = 1;
  place.found = true;
  return place;
}

void RegionInterfaces::vertices_near(const LabelSet& labels, const Vector3& p, double radius,
                                     Array<Vector3>& found) const {
  found.clear();
  for (const auto& [set, vertices] : points_) {
    if (!contains_all(set, labels)) continue;
    for (const Index v : vertices) {
      if ((positions_[v] - p).squaredNorm() <= radius * radius) found.push_back(positions_[v]);
    }
  }
}

}  // namespace orbicube::hexmesh
