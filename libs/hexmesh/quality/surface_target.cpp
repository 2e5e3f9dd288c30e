#include "hexmesh/quality/surface_target.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mesh/topology/connectivity.h"

namespace orbicube::hexmesh {
namespace {

// The cosine of the angle to the normal of what looks the other way.
constexpr double opposite = -0.3;
constexpr double feature_angle = 40 * std::numbers::pi / 180;

Vector3 twice_area(std::span<const Vector3> positions, const mesh::Triangle& t) {
  return (positions[t[1]] - positions[t[0]]).cross(positions[t[2]] - positions[t[0]]);
}

// Each triangle belongs to the face that the coarse surface has beside its center; lines are where faces meet that have
// a sharp edge in common there.
Array<Index> faces_beside(const polycube::SurfaceMap& map, std::span<const Vector3> positions,
                          std::span<const mesh::Triangle> triangles, const base::Host& host) {
  Array<Index> patches(triangles.size(), host.memory);
  const mesh::SurfaceSearch search(map.positions, map.triangles, host);
  constexpr std::size_t piece = 256;
  host.parallel_for((triangles.size() + piece - 1) / piece, [&](std::size_t p) {
    for (std::size_t i = p * piece; i < std::min(triangles.size(), (p + 1) * piece); ++i) {
      const mesh::Triangle& t = triangles[i];
      patches[i] = map.patches[search.nearest((positions[t[0]] + positions[t[1]] + positions[t[2]]) / 3).triangle];
    }
  });
  return patches;
}

// Normals of vertices: of all triangles around, or of those of the same face where faces are kept apart by `patches`.
void set_corner_normals(std::span<const Vector3> positions, std::span<const mesh::Triangle> triangles,
                        std::span<const Index> patches, Array<std::array<Vector3, 3>>& normals,
                        const base::Host& host) {
  normals.resize(triangles.size());
  struct Corner {
    Index vertex, patch, triangle, corner;
  };
  Array<Corner> corners(host.memory);
  for (Index i = 0; i < triangles.size(); ++i) {
    for (Index k = 0; k < 3; ++k)
      corners.push_back({triangles[i][k], patches.empty() ? 0 : patches[i], i, k});
  }
  std::sort(corners.begin(), corners.end(), [](const Corner& x, const Corner& y) {
    return std::array{x.vertex, x.patch, x.triangle, x.corner} < std::array{y.vertex, y.patch, y.triangle, y.corner};
  });
  host.report("target", 0, 0);
  for (std::size_t i = 0; i < corners.size();) {
    std::size_t end = i;
    Vector3 sum = Vector3::Zero();
    for (; end < corners.size() && corners[end].vertex == corners[i].vertex && corners[end].patch == corners[i].patch;
         ++end)
      sum += twice_area(positions, triangles[corners[end].triangle]);
    const Vector3 normal = sum.norm() > 0 ? Vector3(sum.normalized()) : Vector3(Vector3::UnitX());
    for (; i < end; ++i)
      normals[corners[i].triangle][corners[i].corner] = normal;
  }
}

}  // namespace

SurfaceTarget::SurfaceTarget(const polycube::SurfaceMap& map, std::span<const Vector3> fine_positions,
                             std::span<const mesh::Triangle> fine_triangles, double scale, const base::Host& host)
    : positions_(host.memory),
      triangles_(host.memory),
      normals_(host.memory),
      flat_normals_(host.memory),
      whole_(host.memory),
      lines_(host.memory) {
  const bool fine = !fine_triangles.empty();
  if (fine) {
    positions_.assign(fine_positions.begin(), fine_positions.end());
    triangles_.assign(fine_triangles.begin(), fine_triangles.end());
  } else {
    positions_ = map.positions;
    triangles_ = map.triangles;
  }
  for (Vector3& p : positions_)
    p *= scale;
  Index patch_count = 0;
  for (const Index patch : map.patches)
    patch_count = std::max(patch_count, patch + 1);
  Array<Index> patches(map.patches, host.memory);
  find_lines(map.positions, map.triangles, patches, scale, host);
  if (fine && has_sharp_edges()) {
    patches = faces_beside(map, fine_positions, fine_triangles, host);
    host.report("target", 0, 0);
    const Array<Line> coarse(lines_, host.memory);
    find_lines(fine_positions, fine_triangles, patches, scale, host);
    std::erase_if(lines_, [&](const Line& line) {
      return !std::binary_search(coarse.begin(), coarse.end(), line,
                                 [](const Line& x, const Line& y) { return x.patches < y.patches; });
    });
  }
  for (const mesh::Triangle& t : triangles_) {
    const Vector3 n = twice_area(positions_, t);
    flat_normals_.push_back(n.norm() > 0 ? Vector3(n.normalized()) : Vector3(Vector3::Zero()));
  }
  const bool apart = has_sharp_edges();
  set_corner_normals(positions_, triangles_, apart ? std::span<const Index>(patches) : std::span<const Index>(),
                     normals_, host);
  whole_.triangles = triangles_;
  whole_.search = std::make_unique<mesh::SurfaceSearch>(positions_, whole_.triangles, host);
  if (!apart) return;
  patches_.reserve(patch_count);
  for (Index i = 0; i < patch_count; ++i)
    patches_.emplace_back(host.memory);
  for (Index i = 0; i < triangles_.size(); ++i) {
    Part& part = patches_[patches[i]];
    part.triangles.push_back(triangles_[i]);
    part.sources.push_back(i);
  }
  for (Part& part : patches_)
    part.search = std::make_unique<mesh::SurfaceSearch>(positions_, part.triangles, host);
}

// The edges between faces whose border is mostly sharp, sorted.
void SurfaceTarget::find_lines(std::span<const Vector3> positions, std::span<const mesh::Triangle> triangles,
                               std::span<const Index> patches, double scale, const base::Host& host) {
  const mesh::Connectivity connectivity(positions.size(), triangles, host);
  // How much of the border between two faces is sharp.
  struct Border {
    std::array<Index, 2> patches;
    double length, sharp;
  };
  Array<Border> borders(host.memory);
  Array<Line> all(host.memory);
  for (Index h = 0; h < 3 * triangles.size(); ++h) {
    const Index other = connectivity.opposite(h);
    if (other == no_index || other < h) continue;
    Index a = patches[h / 3], b = patches[other / 3];
    if (a == b) continue;
    if (a > b) std::swap(a, b);
    const Vector3 p = positions[connectivity.start(h)], q = positions[connectivity.end(h)];
    const Vector3 m = twice_area(positions, triangles[h / 3]), n = twice_area(positions, triangles[other / 3]);
    const bool is_sharp = std::atan2(m.cross(n).norm(), m.dot(n)) > feature_angle;
    borders.push_back({{a, b}, (q - p).norm(), is_sharp ? (q - p).norm() : 0});
    all.push_back({{a, b}, scale * p, scale * q});
  }
  std::sort(borders.begin(), borders.end(), [](const Border& x, const Border& y) {
    return std::pair(x.patches, std::pair(x.length, x.sharp)) < std::pair(y.patches, std::pair(y.length, y.sharp));
  });
  std::sort(all.begin(), all.end(), [](const Line& x, const Line& y) {
    return std::pair(x.patches, std::array{x.start[0], x.start[1], x.start[2]}) <
           std::pair(y.patches, std::array{y.start[0], y.start[1], y.start[2]});
  });
  lines_.clear();
  for (std::size_t i = 0; i < borders.size();) {
    std::size_t end = i;
    double length = 0, sharp_length = 0;
    for (; end < borders.size() && borders[end].patches == borders[i].patches; ++end) {
      length += borders[end].length;
      sharp_length += borders[end].sharp;
    }
    if (sharp_length > 0.6 * length)
      lines_.insert(lines_.end(), all.begin() + static_cast<std::ptrdiff_t>(i),
                    all.begin() + static_cast<std::ptrdiff_t>(end));
    i = end;
  }
}

TargetPoint SurfaceTarget::on(const Part& part, const Vector3& p, const Vector3& facing) const {
  const mesh::SurfacePoint found = part.search->nearest_of(
      p, [&](Index i) { return flat_normals_[part.sources.empty() ? i : part.sources[i]].dot(facing) > opposite; });
  return found.triangle == no_index ? on(part, p) : target_point(part, found);
}

double SurfaceTarget::gap(const TargetPoint& at, double far) const {
  const auto is_other_wall = [&](Index i) {
    if (flat_normals_[i].dot(at.normal) > opposite) return false;
    const mesh::Triangle& t = triangles_[i];
    return std::any_of(t.begin(), t.end(), [&](Index v) { return (positions_[v] - at.position).dot(at.normal) > 0; });
  };
  const mesh::SurfacePoint found = whole_.search->nearest_of(at.position, is_other_wall, far);
  return found.triangle == no_index ? far : std::min(far, found.distance);
}

TargetPoint SurfaceTarget::target_point(const Part& part, const mesh::SurfacePoint& found) const {
  const Index triangle = part.sources.empty() ? found.triangle : part.sources[found.triangle];
  const auto& n = normals_[triangle];
  const Vector3 normal = found.weights[0] * n[0] + found.weights[1] * n[1] + found.weights[2] * n[2];
  return {found.position, normal.norm() > 1e-9 ? Vector3(normal.normalized()) : n[0]};
}

TargetPoint SurfaceTarget::nearest(const Vector3& p) const {
  return on(whole_, p);
}

TargetPoint SurfaceTarget::nearest_on(Index patch, const Vector3& p) const {
  return on(patches_[patch], p);
}

TargetPoint SurfaceTarget::nearest(const Vector3& p, const Vector3& facing) const {
  return on(whole_, p, facing);
}

TargetPoint SurfaceTarget::nearest_on(Index patch, const Vector3& p, const Vector3& facing) const {
  return on(patches_[patch], p, facing);
}

std::span<const SurfaceTarget::Line> SurfaceTarget::lines_of(std::array<Index, 2> faces) const {
  if (faces[0] > faces[1]) std::swap(faces[0], faces[1]);
  const auto [begin, end] = std::equal_range(lines_.begin(), lines_.end(), Line{faces, {}, {}},
                                             [](const Line& x, const Line& y) { return x.patches < y.patches; });
  return std::span(lines_).subspan(static_cast<std::size_t>(begin - lines_.begin()),
                                   static_cast<std::size_t>(end - begin));
}

bool SurfaceTarget::sharp(Index patch, Index other) const {
  return !lines_of({patch, other}).empty();
}

TargetPoint SurfaceTarget::nearest_on_line(Index patch, Index other, const Vector3& p) const {
  TargetPoint best{p, Vector3::UnitX()};
  double least = std::numeric_limits<double>::infinity();
  for (const Line& line : lines_of({patch, other})) {
    const Vector3 along = line.end - line.start;
    const double square = along.squaredNorm();
    const double t = square > 0 ? std::clamp(along.dot(p - line.start) / square, 0.0, 1.0) : 0;
    const Vector3 q = line.start + t * along;
    if (!((q - p).squaredNorm() < least)) continue;
    least = (q - p).squaredNorm();
    best = {q, square > 0 ? Vector3(along / std::sqrt(square)) : Vector3(Vector3::UnitX())};
  }
  return best;
}

std::optional<SurfaceTarget::Meeting> SurfaceTarget::meeting(const std::array<Index, 2>& faces,
                                                             const std::array<Index, 2>& others,
                                                             const Vector3& p) const {
  std::optional<Meeting> best;
  const auto ends = [](const Line& line) {
    return std::array{std::pair(line.start, line.end), std::pair(line.end, line.start)};
  };
  for (const Line& line : lines_of(faces)) {
    for (const Line& other : lines_of(others)) {
      for (const auto& [at, to] : ends(line)) {
        for (const auto& [other_at, other_to] : ends(other)) {
          if (at != other_at || (best && (at - p).squaredNorm() >= (best->position - p).squaredNorm())) continue;
          const Vector3 m = to - at, n = at - other_to;
          best = Meeting{at, std::atan2(m.cross(n).norm(), m.dot(n)) > feature_angle};
        }
      }
    }
  }
  return best;
}

}  // namespace orbicube::hexmesh
