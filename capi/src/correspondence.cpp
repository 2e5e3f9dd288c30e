#include "orbicube/correspondence.h"

#include <algorithm>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/version.h"
#include "capi/src/entry.h"
#include "capi/src/surface_view.h"
#include "correspondence/morph.h"
#include "mesh/topology/surface_check.h"

using namespace orbicube;
using capi::copy;
using mesh::Vector3;

struct obc_correspondence {
  explicit obc_correspondence(const obc_host* host) : adapter(host), morph(adapter.host().memory) {}
  capi::HostAdapter adapter;
  correspondence::Morph morph;
  std::vector<std::size_t> vertex_counts;  // of the surfaces
};

namespace {

obc_correspondence_options default_options() {
  const correspondence::MorphOptions defaults;
  obc_correspondence_options o{};
  o.struct_size = sizeof o;
  o.via = OBC_CORRESPONDENCE_SPHERE;
  o.align = OBC_CORRESPONDENCE_ALIGN_SHAPE;
  o.grid = OBC_CORRESPONDENCE_GRID_BOTH;
  o.placement = OBC_CORRESPONDENCE_KEPT;
  o.tolerance = defaults.tolerance;
  return o;
}

void require_choice(std::int32_t value, std::int32_t last, const char* what) {
  if (value < 0 || value > last)
    throw base::Error("invalid-argument", std::string(what) + " is not one of OBC_CORRESPONDENCE_...");
}

correspondence::MorphOptions options_of(const obc_correspondence_options* options) {
  const obc_correspondence_options o = capi::copy_versioned(options, default_options());
  require_choice(o.via, OBC_CORRESPONDENCE_POLYCUBE, "via");
  require_choice(o.align, OBC_CORRESPONDENCE_ALIGN_NONE, "align");
  require_choice(o.grid, OBC_CORRESPONDENCE_GRID_OCTAHEDRON, "grid");
  require_choice(o.placement, OBC_CORRESPONDENCE_SCALED, "placement");
  correspondence::MorphOptions result;
  result.via = static_cast<correspondence::Via>(o.via);
  result.align = static_cast<correspondence::SphereAlignment>(o.align);
  result.grid = static_cast<correspondence::CommonGrid>(o.grid);
  result.pose = static_cast<correspondence::Pose>(o.placement);
  result.tolerance = o.tolerance;
  result.cells = o.cells;
  result.corners = o.corners;
  result.seed = o.seed;
  result.resolution = o.resolution;
  return result;
}

// The landmarks of each of `count` surfaces.
std::vector<std::span<const Vector3>> landmarks_of(const obc_correspondence_options* options, std::size_t count) {
  const obc_correspondence_options o = capi::copy_versioned(options, default_options());
  std::vector<std::span<const Vector3>> result;
  if (o.landmark_count == 0) return result;
  constexpr std::size_t max_landmarks = 1'000'000;
  capi::require(o.landmark_count <= max_landmarks, "at most 1000000 landmarks");
  const auto all = capi::view<Vector3>(o.landmarks, count * o.landmark_count, "landmarks");
  for (std::size_t i = 0; i < count; ++i)
    result.push_back(all.subspan(i * o.landmark_count, o.landmark_count));
  return result;
}

using Points = base::Array<correspondence::TrianglePoint>;

const correspondence::ShapeMaps& maps_of(const obc_correspondence* correspondence, std::size_t from, std::size_t to) {
  capi::require(correspondence != nullptr, "correspondence is NULL");
  const correspondence::ShapeMaps& maps = *correspondence->morph.maps;
  capi::require(from < maps.size() && to < maps.size(), "from or to is out of range");
  return maps;
}

void copy_points(const Points& points, std::uint32_t* triangles, double* weights) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    triangles[i] = points[i].triangle;
    std::copy_n(points[i].weights.data(), 3, weights + 3 * i);
  }
}

}  // namespace

obc_status obc_correspondence_options_init(obc_correspondence_options* options, size_t struct_size) {
  return capi::init_versioned(options, struct_size, default_options());
}

obc_status obc_correspondence_create(const obc_surface* surfaces, size_t count,
                                     const obc_correspondence_options* options, const obc_host* host,
                                     obc_correspondence** out, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(out != nullptr, "out is NULL");
    *out = nullptr;
    capi::require(surfaces != nullptr || count == 0, "surfaces is NULL");
    capi::require(count <= 100, "at most 100 shapes");
    correspondence::MorphOptions o = options_of(options);
    const std::vector<std::span<const Vector3>> landmarks = landmarks_of(options, count);
    o.landmarks = landmarks;
    auto made = std::make_unique<obc_correspondence>(host);
    const base::Host& on = made->adapter.host();
    std::vector<correspondence::SurfaceSpan> shapes;
    for (std::size_t i = 0; i < count; ++i) {
      const capi::SurfaceView s(&surfaces[i]);
      mesh::require_valid_surface(s.positions, s.triangles, on);
      shapes.push_back({s.positions, s.triangles});
      made->vertex_counts.push_back(s.positions.size());
    }
    made->morph = correspondence::morph(shapes, o, on);
    *out = made.release();
  });
}

void obc_correspondence_destroy(obc_correspondence* correspondence) {
  delete correspondence;
}

size_t obc_correspondence_shape_count(const obc_correspondence* correspondence) {
  return correspondence == nullptr ? 0 : correspondence->morph.states.size();
}

size_t obc_correspondence_vertex_count(const obc_correspondence* correspondence) {
  return correspondence == nullptr ? 0 : correspondence->morph.states.front().size();
}

size_t obc_correspondence_triangle_count(const obc_correspondence* correspondence) {
  return correspondence == nullptr ? 0 : correspondence->morph.triangles.size();
}

obc_status obc_correspondence_copy(const obc_correspondence* correspondence, size_t shape, double* positions,
                                   uint32_t* triangles, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(correspondence != nullptr, "correspondence is NULL");
    const auto& morph = correspondence->morph;
    capi::require(shape < morph.states.size(), "shape is out of range");
    copy(morph.states[shape], positions);
    copy(morph.triangles, triangles);
  });
}

obc_status obc_correspondence_blend(const obc_correspondence* correspondence, const double* weights, size_t count,
                                    double* positions, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(correspondence != nullptr, "correspondence is NULL");
    capi::require(weights != nullptr && positions != nullptr, "weights or positions is NULL");
    copy(correspondence::blend(correspondence->morph, {weights, count}, correspondence->adapter.host()), positions);
  });
}

obc_status obc_correspondence_copy_domain(const obc_correspondence* correspondence, double* positions,
                                          obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(correspondence != nullptr && positions != nullptr, "correspondence or positions is NULL");
    copy(correspondence->morph.domain, positions);
  });
}

size_t obc_correspondence_quad_count(const obc_correspondence* correspondence) {
  return correspondence == nullptr ? 0 : correspondence->morph.quads.size();
}

obc_status obc_correspondence_copy_quads(const obc_correspondence* correspondence, uint32_t* quads, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(correspondence != nullptr, "correspondence is NULL");
    const auto& from = correspondence->morph.quads;
    capi::require(quads != nullptr || from.empty(), "quads is NULL");
    copy(from, quads);
  });
}

size_t obc_correspondence_surface_vertex_count(const obc_correspondence* correspondence, size_t shape) {
  if (correspondence == nullptr || shape >= correspondence->vertex_counts.size()) return 0;
  return correspondence->vertex_counts[shape];
}

obc_status obc_correspondence_map(const obc_correspondence* correspondence, size_t from, size_t to,
                                  const uint32_t* triangles, const double* weights, size_t count, const obc_host* host,
                                  uint32_t* mapped_triangles, double* mapped_weights, obc_error* error) {
  return capi::guarded(error, [&] {
    const correspondence::ShapeMaps& maps = maps_of(correspondence, from, to);
    const auto of_triangles = capi::view<std::uint32_t>(triangles, count, "triangles");
    const auto of_weights = capi::view<Vector3>(weights, count, "weights");
    capi::require(count == 0 || (mapped_triangles != nullptr && mapped_weights != nullptr),
                  "mapped_triangles or mapped_weights is NULL");
    const capi::HostAdapter adapter(host);
    Points points(adapter.host().memory);
    points.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
      points.push_back({of_triangles[i], of_weights[i]});
    copy_points(maps.carry(from, to, points, adapter.host()), mapped_triangles, mapped_weights);
  });
}

obc_status obc_correspondence_map_vertices(const obc_correspondence* correspondence, size_t from, size_t to,
                                           const obc_host* host, uint32_t* mapped_triangles, double* mapped_weights,
                                           obc_error* error) {
  return capi::guarded(error, [&] {
    const correspondence::ShapeMaps& maps = maps_of(correspondence, from, to);
    capi::require(mapped_triangles != nullptr && mapped_weights != nullptr,
                  "mapped_triangles or mapped_weights is NULL");
    const capi::HostAdapter adapter(host);
    copy_points(correspondence::carry_vertices(maps, from, to, correspondence->vertex_counts[from], adapter.host()),
                mapped_triangles, mapped_weights);
  });
}

uint32_t obc_correspondence_version() {
  return base::version_number;
}
