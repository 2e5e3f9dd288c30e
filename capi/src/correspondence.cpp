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
  require_choice(o.grid, OBC_CORRESPONDENCE_GRID_FIRST, "grid");
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
  return result;
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
    const correspondence::MorphOptions o = options_of(options);
    auto made = std::make_unique<obc_correspondence>(host);
    const base::Host& on = made->adapter.host();
    std::vector<correspondence::SurfaceSpan> shapes;
    for (std::size_t i = 0; i < count; ++i) {
      const capi::SurfaceView s(&surfaces[i]);
      mesh::require_valid_surface(s.positions, s.triangles, on);
      shapes.push_back({s.positions, s.triangles});
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
    if (positions != nullptr) copy(morph.states[shape], positions);
    if (triangles != nullptr)
      std::copy_n(reinterpret_cast<const uint32_t*>(morph.triangles.data()), 3 * morph.triangles.size(), triangles);
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

uint32_t obc_correspondence_version() {
  return base::version_number;
}
