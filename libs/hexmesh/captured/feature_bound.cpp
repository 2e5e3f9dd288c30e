#include "hexmesh/captured/feature_bound.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/features/feature_lines.h"
#include "mesh/search/nearest.h"

namespace orbicube::hexmesh {
namespace {

constexpr double radians = std::numbers::pi / 180;

struct Sector {
  double angle = 0;
  Vector3 normal = Vector3::Zero();  // sum of the normals of the triangles times their angles
};

// The sectors between the arcs at a corner; one, where there is one arc or none.
void collect_sectors(const FeatureSurface& surface, const mesh::Connectivity& connectivity, Index corner,
                     Array<Sector>& sectors) {
  const Index at = surface.graph.corners[corner].vertex;
  const auto begins_arc = [&](Index h) {
    for (const mesh::FeatureEnd& end : surface.graph.around[corner]) {
      const auto v = surface.graph.vertices_of(surface.graph.arcs[end.arc]);
      if (connectivity.end(h) == (end.end == 0 ? v[1] : v[v.size() - 2])) return true;
    }
    return false;
  };
  sectors.clear();
  Index first = connectivity.outgoing(at);
  connectivity.for_each_outgoing(at, [&](Index h) {
    if (begins_arc(h)) first = h;
  });
  const auto& p = surface.positions;
  mesh::circulate(
      first, [&](Index h) { return connectivity.opposite(mesh::Connectivity::previous(h)); },
      [&](Index h) {
        if (sectors.empty() || begins_arc(h)) sectors.emplace_back();
        const Vector3 a = p[connectivity.end(h)] - p[at];
        const Vector3 b = p[connectivity.end(mesh::Connectivity::next(h))] - p[at];
        const double angle = mesh::degrees_between(a, b) * radians;
        sectors.back().angle += angle;
        sectors.back().normal += angle * a.cross(b).stableNormalized();
      });
}

double bound_at_corner(std::span<const Sector> sectors, std::pmr::memory_resource* memory) {
  Array<Vector3> vectors(memory);
  for (const Sector& s : sectors) {
    const double half = std::sin(std::min(s.angle / 2, std::numbers::pi));
    vectors.push_back(-half * s.normal.stableNormalized());
  }
  return distance_of_hull(vectors);
}

// Visits the angle, in degrees, by which the surface turns at each edge of an arc.
template <class Visit>
void for_each_turn(const FeatureSurface& surface, const mesh::Connectivity& connectivity, const mesh::FeatureArc& arc,
                   const Visit& visit) {
  const auto vertices = surface.graph.vertices_of(arc);
  for (std::size_t i = 1; i < vertices.size(); ++i) {
    connectivity.for_each_outgoing(vertices[i - 1], [&](Index h) {
      if (connectivity.end(h) != vertices[i]) return;
      const auto normal = [&](Index half_edge) {
        return mesh::triangle_normal(surface.positions, surface.triangles[mesh::triangle_of(half_edge)]);
      };
      visit(mesh::degrees_between(normal(h), normal(connectivity.opposite(h))));
    });
  }
}

double bound_along(const FeatureSurface& surface, const mesh::Connectivity& connectivity, const mesh::FeatureArc& arc) {
  double least = 1;
  for_each_turn(surface, connectivity, arc,
                [&](double turn) { least = std::min(least, std::cos(turn * radians / 2)); });
  return least;
}

}  // namespace

// The nearest point of the hull lies on one of the triangles between three vectors, and the plane across it has all
// vectors beyond.
double distance_of_hull(std::span<const Vector3> vectors) {
  constexpr double beyond = 1e-9;
  const Vector3 origin = Vector3::Zero();
  double least = vectors.empty() ? 0 : vectors[0].norm();
  Vector3 nearest = vectors.empty() ? origin : vectors[0];
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    for (std::size_t j = i; j < vectors.size(); ++j) {
      for (std::size_t k = j; k < vectors.size(); ++k) {
        const Vector3 p = mesh::nearest_on_triangle(origin, vectors[i], vectors[j], vectors[k]).position;
        if (p.norm() >= least) continue;
        least = p.norm();
        nearest = p;
      }
    }
  }
  const bool outside = std::all_of(vectors.begin(), vectors.end(),
                                   [&](const Vector3& v) { return v.dot(nearest) >= least * least - beyond; });
  return outside ? least : 0;
}

double scaled_jacobian_bound(const FeatureSurface& surface, const base::Host& host) {
  const mesh::Connectivity connectivity(surface.positions.size(), surface.triangles, host);
  double least = 1;
  Array<Sector> sectors(host.memory);
  for (Index c = 0; c < surface.graph.corners.size(); ++c) {
    host.report("features", c, surface.graph.corners.size());
    if (surface.graph.around.size(c) < 2) continue;
    collect_sectors(surface, connectivity, c, sectors);
    least = std::min(least, bound_at_corner(sectors, host.memory));
  }
  for (const mesh::FeatureArc& arc : surface.graph.arcs) {
    host.report("features", 0, 0);
    least = std::min(least, bound_along(surface, connectivity, arc));
  }
  return least;
}

bool has_right_angles(const FeatureSurface& surface, const base::Host& host) {
  constexpr double low = 70, high = 110;  // degrees
  const mesh::FeatureGraph& graph = surface.graph;
  bool corners = false;
  for (Index c = 0; c < graph.corners.size(); ++c) {
    if (graph.corners[c].soft) continue;
    if (graph.around.size(c) != 3) return false;
    corners = true;
  }
  if (!corners) return false;
  const mesh::Connectivity connectivity(surface.positions.size(), surface.triangles, host);
  bool right = true;
  for (const mesh::FeatureArc& arc : graph.arcs) {
    host.report("features", 0, 0);
    for_each_turn(surface, connectivity, arc, [&](double turn) { right = right && turn >= low && turn <= high; });
  }
  return right;
}

}  // namespace orbicube::hexmesh
