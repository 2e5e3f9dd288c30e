#include "hexmesh/features/feature_targets.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace orbicube::hexmesh {
namespace {

constexpr double min_spacing = 0.35;  // of vertices along an arc, times that of equal edges

}  // namespace

FeatureTargets::FeatureTargets(const HexMesh& mesh, const FeatureShape& shape, const Embedding& embedding,
                               const base::Host& host)
    : shape_(&shape),
      kind_(mesh.positions.size(), Kind::inside, host.memory),
      owner_(mesh.positions.size(), no_index, host.memory),
      along_(mesh.positions.size(), 0, host.memory),
      s_(mesh.positions.size(), 0, host.memory),
      kept_(mesh.positions.size(), 0, host.memory),
      places_(mesh.positions.size(), Vector3::Zero(), host.memory),
      paths_(embedding.paths, host.memory),
      spacing_(host.memory),
      pull_(mesh.positions.size(), 1, host.memory),
      vertices_(host.memory),
      quads_(mesh.quads),
      facing_(mesh.positions.size(), Vector3::Zero(), host.memory) {
  for (std::size_t q = 0; q < mesh.quads.size(); ++q) {
    for (const Index v : mesh.quads[q]) {
      kind_[v] = Kind::patch;
      owner_[v] = mesh.quad_patches[q];
    }
  }
  Array<double> lengths(host.memory);
  for (Index a = 0; a < paths_.size(); ++a) {
    const auto& path = paths_[a];
    spacing_.emplace_back(path.size() - 1, shape.length(a) / static_cast<double>(path.size() - 1));
    lengths.assign(path.size(), 0);
    for (std::size_t i = 1; i < path.size(); ++i)
      lengths[i] = lengths[i - 1] + (mesh.positions[path[i]] - mesh.positions[path[i - 1]]).norm();
    for (Index i = 1; i + 1 < path.size(); ++i) {
      kind_[path[i]] = Kind::arc;
      owner_[path[i]] = a;
      along_[path[i]] = i;
      s_[path[i]] = lengths[i] / lengths.back() * shape.length(a);
    }
  }
  for (Index c = 0; c < shape.corners(); ++c) {
    kind_[embedding.corner_vertices[c]] = Kind::corner;
    owner_[embedding.corner_vertices[c]] = c;
  }
  for (Index v = 0; v < kind_.size(); ++v) {
    if (kind_[v] != Kind::inside) vertices_.push_back(v);
  }
  look_from(mesh.positions);
}

void FeatureTargets::look_from(std::span<const Vector3> positions) {
  for (const Index v : vertices_)
    facing_[v].setZero();
  for (const Quad& q : quads_) {
    const Vector3 normal = (positions[q[2]] - positions[q[0]]).cross(positions[q[3]] - positions[q[1]]);
    for (const Index v : q)
      facing_[v] += normal;
  }
  for (const Index v : vertices_)
    facing_[v].stableNormalize();
}

void FeatureTargets::move_to(const FeatureShape& shape, std::span<const double> size) {
  for (Index a = 0; a < paths_.size(); ++a) {
    double before = 0, whole = 0;
    for (double& spacing : spacing_[a]) {
      whole += spacing;
      const double at = shape_->same_place(a, whole, shape);
      spacing = at - before;
      before = at;
    }
    for (std::size_t i = 1; i + 1 < paths_[a].size(); ++i) {
      double& s = s_[paths_[a][i]];
      s = shape_->same_place(a, s, shape);
    }
  }
  for (const Index v : vertices_)
    pull_[v] = 1 / (size[v] * size[v]);
  shape_ = &shape;
}

FeatureTargets::Target FeatureTargets::target(Index v, const Vector3& p) const {
  switch (kind_[v]) {
    case Kind::corner:
      return {shape_->corner(owner_[v]), Vector3::Zero()};
    case Kind::arc: {
      const Vector3 at = shape_->point(owner_[v], s_[v]);
      return {at, shape_->nearest_on_arc(owner_[v], at, s_[v], 0).tangent};
    }
    case Kind::patch: {
      const Vector3& from = kept_[v] != 0 ? places_[v] : p;
      const FeatureShape::PatchPoint point = shape_->nearest_on_patch(owner_[v], from, facing_[v]);
      return {point.position, point.normal};
    }
    case Kind::inside:
      break;
  }
  return {p, Vector3::Zero()};
}

void FeatureTargets::keep_at(Index v, const Vector3& place) {
  places_[v] = place;
  kept_[v] = 1;
}

void FeatureTargets::pull(Index v, const Vector3& p, double weight, bool slide, Pull& pull) const {
  pull_to_target(v, p, weight * pull_[v], slide, pull);
}

void FeatureTargets::pull_to_target(Index v, const Vector3& p, double weight, bool slide, Pull& pull) const {
  constexpr double corner = 4, arc = 2, sideways = 0.5;  // times the weight
  constexpr double along = 0.03;                         // times the weight, of an arc, where vertices slide
  constexpr double stay = 0.02;
  constexpr double near = 0.02;  // cells: of the nearest point, where the plane is the same
  const Target to = target(v, p);
  switch (kind_[v]) {
    case Kind::corner:
      pull.to_point(to.position, corner * weight);
      return;
    case Kind::arc: {
      if (!slide || kept_[v] != 0) return pull.to_point(to.position, arc * weight);
      const Vector3 a = to.direction.unitOrthogonal(), b = to.direction.cross(a);
      pull.to_plane(a, to.position, arc * weight);
      pull.to_plane(b, to.position, arc * weight);
      pull.to_point(to.position, along * weight);
      return;
    }
    case Kind::patch: {
      if (kept_[v] != 0) return pull.to_point(to.position, arc * weight);
      pull.to_plane(to.direction, to.position, weight);
      Vector3 rest = to.position - p;
      rest -= to.direction * to.direction.dot(rest);
      if (rest.norm() > near) pull.to_plane(rest.normalized(), to.position, sideways * weight);
      pull.to_point(p, stay * pull_[v]);
      return;
    }
    case Kind::inside:
      return;
  }
}

void FeatureTargets::slide(std::span<const Vector3> positions) {
  constexpr double window = 2;  // times the spacing: free nearest points lock
  for (Index a = 0; a < paths_.size(); ++a) {
    const auto& path = paths_[a];
    const std::size_t n = path.size() - 1;
    const Array<double>& spacing = spacing_[a];
    for (std::size_t i = 1; i < n; ++i) {
      const double before = s_[path[i]], reach = window * std::max(spacing[i - 1], spacing[i]);
      s_[path[i]] = shape_->nearest_on_arc(a, positions[path[i]], before, reach).s;
    }
    for (const Index v : path)
      kept_[v] = 0;
    space_out(a);
    keep_near_fades(a);
  }
}

// As many bends and fades as possible get a vertex, and of such choices that which moves them least; vertices between
// them make room.
void FeatureTargets::keep_near_fades(Index arc) {
  constexpr double reach = 1.2;  // of the spacing: how far a vertex goes to be kept
  constexpr std::size_t most_places =
      8;  // an edge: of more, hardly any gets a vertex, and the choices are their square
  const auto& path = paths_[arc];
  const std::span<const double> places = shape_->bends_and_fades(arc);
  const std::size_t n = path.size() - 1;
  if (places.empty() || places.size() > most_places * n) return;
  Array<double> even(1, 0.0, s_.get_allocator().resource());  // arc lengths with equal edges
  for (const double spacing : spacing_[arc])
    even.push_back(even.back() + spacing);
  struct Choice {
    std::size_t vertex = 0, count = 0, before = 0;
    double place = 0, moved = 0;
  };
  const auto has_room = [&](const Choice& low, std::size_t vertex, double place) {
    return vertex > low.vertex && place - low.place >= min_spacing * (even[vertex] - even[low.vertex]);
  };
  Array<Choice> choices(1, Choice(), s_.get_allocator().resource());
  for (const double place : places) {
    const std::size_t earlier = choices.size();
    for (std::size_t i = 1; i < n; ++i) {
      const double moved = std::abs(s_[path[i]] - place);
      if (moved > reach * std::max(spacing_[arc][i - 1], spacing_[arc][i])) continue;
      if (shape_->length(arc) - place < min_spacing * (even[n] - even[i])) continue;
      Choice best;
      for (std::size_t k = 0; k < earlier; ++k) {
        const Choice& low = choices[k];
        if (!has_room(low, i, place)) continue;
        const Choice now = {i, low.count + 1, k, place, low.moved + moved};
        if (now.count > best.count || (now.count == best.count && now.moved < best.moved)) best = now;
      }
      if (best.count > 0) choices.push_back(best);
    }
  }
  const auto last = std::max_element(choices.begin(), choices.end(), [](const Choice& x, const Choice& y) {
    return x.count != y.count ? x.count < y.count : x.moved > y.moved;
  });
  for (const Choice* c = &*last; c->count > 0; c = &choices[c->before]) {
    s_[path[c->vertex]] = c->place;
    kept_[path[c->vertex]] = 1;
  }
  space_out(arc);
}

// Moves vertices that are not kept so that none is too close to its neighbors.
void FeatureTargets::space_out(Index arc) {
  const auto& path = paths_[arc];
  const std::size_t n = path.size() - 1;
  double low = 0;
  for (std::size_t i = 1; i < n; ++i) {
    double& s = s_[path[i]];
    if (kept_[path[i]] == 0) s = std::max(s, low + min_spacing * spacing_[arc][i - 1]);
    low = s;
  }
  double high = shape_->length(arc);
  for (std::size_t i = n; i-- > 1;) {
    double& s = s_[path[i]];
    if (kept_[path[i]] == 0) s = std::min(s, high - min_spacing * spacing_[arc][i]);
    high = s;
  }
}

double FeatureTargets::clamped_place(Index v, double s) const {
  constexpr double min_searched = 0.3, max_searched = 1.7;  // times that of equal edges
  if (kept_[v] != 0) return s_[v];
  const auto& path = paths_[owner_[v]];
  const std::size_t i = along_[v], n = path.size() - 1;
  const double to_here = spacing_[owner_[v]][i - 1], from_here = spacing_[owner_[v]][i];
  const double before = i > 1 ? s_[path[i - 1]] : 0;
  const double after = i + 1 < n ? s_[path[i + 1]] : shape_->length(owner_[v]);
  const double low = std::max(before + min_searched * to_here, after - max_searched * from_here);
  const double high = std::min(after - min_searched * from_here, before + max_searched * to_here);
  return low < high ? std::clamp(s, low, high) : s_[v];
}

}  // namespace orbicube::hexmesh
