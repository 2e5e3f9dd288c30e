// C functions that search points of a surface, and the exact predicates.
#include <algorithm>
#include <cstddef>
#include <new>
#include <span>

#include "capi/src/surface_view.h"
#include "mesh/search/nearest.h"
#include "mesh/search/predicates.h"
#include "mesh/topology/surface_check.h"
#include "orbicube/mesh.h"

using namespace orbicube;
using capi::view;
using mesh::Triangle;
using mesh::Vector3;

struct obc_mesh_search {
  obc_mesh_search(const obc_host* host, std::span<const Vector3> x, std::span<const Triangle> t)
      : adapter(host),
        positions(x.begin(), x.end(), adapter.host().memory),
        triangles(t.begin(), t.end(), adapter.host().memory),
        vertex_search(positions, adapter.host()),
        surface_search(positions, triangles, adapter.host()) {}
  capi::HostAdapter adapter;
  mesh::Array<Vector3> positions;
  mesh::Array<Triangle> triangles;
  mesh::VertexSearch vertex_search;
  mesh::SurfaceSearch surface_search;
};

namespace {

const obc_mesh_search& checked(const obc_mesh_search* search) {
  capi::require(search != nullptr, "search is NULL");
  return *search;
}

// Finite points to look for.
// Squares of distances must be in the range of double.
constexpr double max_searched = 1e150;

std::span<const Vector3> queries(const double* points, std::size_t count) {
  const auto result = view<Vector3>(points, count, "points");
  for (const Vector3& p : result)
    capi::require(p.allFinite() && p.cwiseAbs().maxCoeff() <= max_searched, "a point is not finite, or beyond 1e150");
  return result;
}

// The sign that `predicate` returns for the points, or 2 when it cannot.
template <int dimension, class Predicate, class... Points>
int32_t sign_or_failure(const Predicate& predicate, const Points*... points) noexcept {
  using Point = Eigen::Matrix<double, dimension, 1>;
  if ((... || (points == nullptr))) return 2;
  const auto apply = [&](const auto&... p) { return (... && p.allFinite()) ? predicate(p...) : 2; };
  try {
    return apply(Point(points)...);
  } catch (const std::bad_alloc&) {
    return 2;
  }
}

}  // namespace

obc_status obc_mesh_search_create(const obc_surface* surface, const obc_host* host, obc_mesh_search** out,
                                  obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(out != nullptr, "out is NULL");
    *out = nullptr;
    const capi::SurfaceView s(surface);
    mesh::require_valid_surface(s.positions, s.triangles, capi::HostAdapter(host).host());
    for (const Vector3& p : s.positions)
      capi::require(p.cwiseAbs().maxCoeff() <= max_searched, "a coordinate is beyond 1e150");
    *out = new obc_mesh_search(host, s.positions, s.triangles);
  });
}

void obc_mesh_search_destroy(obc_mesh_search* search) {
  delete search;
}

obc_status obc_mesh_search_vertices(const obc_mesh_search* search, const double* points, size_t count,
                                    uint32_t* vertices, obc_error* error) {
  return capi::guarded(error, [&] {
    const obc_mesh_search& in = checked(search);
    const auto at = queries(points, count);
    capi::require(vertices != nullptr || count == 0, "vertices is NULL");
    capi::require(!in.positions.empty() || count == 0, "there are no vertices");
    for (std::size_t i = 0; i < count; ++i)
      vertices[i] = in.vertex_search.nearest(at[i]);
  });
}

obc_status obc_mesh_search_surface(const obc_mesh_search* search, const double* points, size_t count,
                                   uint32_t* triangles, double* weights, double* positions, double* distances,
                                   obc_error* error) {
  return capi::guarded(error, [&] {
    const obc_mesh_search& in = checked(search);
    const auto at = queries(points, count);
    capi::require(!in.triangles.empty() || count == 0, "there are no triangles");
    for (std::size_t i = 0; i < count; ++i) {
      const mesh::SurfacePoint found = in.surface_search.nearest(at[i]);
      if (triangles != nullptr) triangles[i] = found.triangle;
      if (weights != nullptr) std::copy(found.weights.begin(), found.weights.end(), weights + 3 * i);
      if (positions != nullptr) std::copy(found.position.begin(), found.position.end(), positions + 3 * i);
      if (distances != nullptr) distances[i] = found.distance;
    }
  });
}

int32_t obc_mesh_orientation_2d(const double* a, const double* b, const double* c) {
  return sign_or_failure<2>(mesh::orientation_2d, a, b, c);
}

int32_t obc_mesh_orientation_3d(const double* a, const double* b, const double* c, const double* d) {
  return sign_or_failure<3>(mesh::orientation_3d, a, b, c, d);
}

int32_t obc_mesh_orientation_from_origin(const double* p, const double* q, const double* r) {
  return sign_or_failure<3>(mesh::orientation_from_origin, p, q, r);
}
