#include "hexmesh/features/feature_targets.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace orbicube::hexmesh {

FeatureTargets::FeatureTargets(const HexMesh& mesh, const FeatureShape& shape, const Embedding& embedding,
                               const base::Host& host)
    : shape_(shape),
      kind_(mesh.positions.size(), Kind::inside, host.memory),
      owner_(mesh.positions.size(), no_index, host.memory),
      along_(mesh.positions.size(), 0, host.memory),
      s_(mesh.positions.size(), 0, host.memory),
      paths_(embedding.paths, host.memory),
      vertices_(host.memory) {
  for (std::size_t q = 0; q < mesh.quads.size(); ++q) {
    for (const Index v : mesh.quads[q]) {
      kind_[v] = Kind::patch;
      owner_[v] = mesh.quad_patches[q];
    }
  }
  Array<double> lengths(host.memory);
  for (Index a = 0; a < paths_.size(); ++a) {
    const auto& path = paths_[a];
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
}

FeatureTargets::Target FeatureTargets::target(Index v, const Vector3& p) const {
  switch (kind_[v]) {
    case Kind::corner:
      return {shape_.corner(owner_[v]), Vector3::Zero()};
    case Kind::arc: {
      const Vector3 at = shape_.point(owner_[v], s_[v]);
      return {at, shape_.nearest_on_arc(owner_[v], at, s_[v], 0).tangent};
    }
    case Kind::patch: {
      const FeatureShape::PatchPoint point = shape_.nearest_on_patch(owner_[v], p);
      return {point.position, point.normal};
    }
    case Kind::inside:
      break;
  }
  return {p, Vector3::Zero()};
}

void FeatureTargets::pull(Index v, const Vector3& p, double weight, bool slide, Pull& pull) const {
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
      if (!slide) return pull.to_point(to.position, arc * weight);
      const Vector3 a = to.direction.unitOrthogonal(), b = to.direction.cross(a);
      pull.to_plane(a, to.position, arc * weight);
      pull.to_plane(b, to.position, arc * weight);
      pull.to_point(to.position, along * weight);
      return;
    }
    case Kind::patch: {
      pull.to_plane(to.direction, to.position, weight);
      Vector3 rest = to.position - p;
      rest -= to.direction * to.direction.dot(rest);
      if (rest.norm() > near) pull.to_plane(rest.normalized(), to.position, sideways * weight);
      pull.to_point(p, stay);
      return;
    }
    case Kind::inside:
      return;
  }
}

void FeatureTargets::slide(std::span<const Vector3> positions) {
  constexpr double min_spacing = 0.35;  // of the mean
  constexpr double window = 2;          // times the mean spacing: free nearest points lock
  for (Index a = 0; a < paths_.size(); ++a) {
    const auto& path = paths_[a];
    const std::size_t n = path.size() - 1;
    const double whole = shape_.length(a), mean = whole / static_cast<double>(n), least = min_spacing * mean;
    for (std::size_t i = 1; i < n; ++i) {
      const double before = s_[path[i]];
      s_[path[i]] = shape_.nearest_on_arc(a, positions[path[i]], before, window * mean).s;
    }
    double low = 0;
    for (std::size_t i = 1; i < n; ++i)
      low = s_[path[i]] = std::max(s_[path[i]], low + least);
    double high = whole;
    for (std::size_t i = n; i-- > 1;)
      high = s_[path[i]] = std::min(s_[path[i]], high - least);
  }
}

double FeatureTargets::clamped_place(Index v, double s) const {
  constexpr double min_spacing = 0.3, max_spacing = 1.7;  // of the mean
  const auto& path = paths_[owner_[v]];
  const std::size_t i = along_[v], n = path.size() - 1;
  const double whole = shape_.length(owner_[v]), mean = whole / static_cast<double>(n);
  const double before = i > 1 ? s_[path[i - 1]] : 0, after = i + 1 < n ? s_[path[i + 1]] : whole;
  const double low = std::max(before + min_spacing * mean, after - max_spacing * mean);
  const double high = std::min(after - min_spacing * mean, before + max_spacing * mean);
  return low < high ? std::clamp(s, low, high) : s_[v];
}

}  // namespace orbicube::hexmesh
