// What a map to the sphere is for: its inverse, sampling, remeshing and geometry images.
#include <algorithm>
#include <memory>

#include "capi/src/entry.h"
#include "capi/src/sphere_map_surface.h"
#include "mesh/topology/surface_check.h"
#include "orbicube/sphere_map.h"
#include "sphere_map/sampling/geometry_image.h"
#include "sphere_map/sampling/grids.h"
#include "sphere_map/sampling/locator.h"
#include "sphere_map/sampling/sampling.h"

using namespace orbicube;
using capi::Surface;
using capi::view;
using sphere_map::Triangle;
using sphere_map::Vector3;

struct obc_sphere_map_locator {
  obc_sphere_map_locator(const obc_host* host, std::span<const Triangle> t, std::span<const Vector3> d)
      : adapter(host),
        triangles(t.begin(), t.end(), adapter.host().memory),
        directions(d.begin(), d.end(), adapter.host().memory),
        locator(triangles, directions, adapter.host()) {}
  capi::HostAdapter adapter;
  base::Array<Triangle> triangles;
  base::Array<Vector3> directions;
  sphere_map::Locator locator;
};

namespace {

const sphere_map::Locator& checked(const obc_sphere_map_locator* locator) {
  capi::require(locator != nullptr, "locator is NULL");
  return locator->locator;
}

sphere_map::ImageLayout to_layout(int32_t layout) {
  capi::require(layout == OBC_SPHERE_MAP_OCTAHEDRON || layout == OBC_SPHERE_MAP_CUBE,
                "images are of an octahedron or a cube");
  return layout == OBC_SPHERE_MAP_CUBE ? sphere_map::ImageLayout::cube : sphere_map::ImageLayout::octahedron;
}

// The caller's pixels as an image.
sphere_map::GeometryImage to_image(const double* pixels, int32_t layout, size_t resolution, const base::Host& host) {
  sphere_map::GeometryImage image(host.memory);
  image.layout = to_layout(layout);
  image.resolution = resolution;
  const auto [width, height] = sphere_map::image_size(image.layout, resolution);
  image.width = width;
  image.height = height;
  const auto given = view<Vector3>(pixels, width * height, "pixels is NULL");
  image.pixels.assign(given.begin(), given.end());
  return image;
}

}  // namespace

obc_status obc_sphere_map_locator_create(const obc_surface* surface, const double* directions, const obc_host* host,
                                         obc_sphere_map_locator** out, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(out != nullptr, "out is NULL");
    *out = nullptr;
    capi::require(surface != nullptr, "surface is NULL");
    const auto triangles = view<Triangle>(surface->triangles, surface->triangle_count, "surface->triangles is NULL");
    const auto map = view<Vector3>(directions, surface->vertex_count, "directions is NULL");
    *out = new obc_sphere_map_locator(host, triangles, map);
  });
}

void obc_sphere_map_locator_destroy(obc_sphere_map_locator* locator) {
  delete locator;
}

obc_status obc_sphere_map_locate(const obc_sphere_map_locator* locator, const double* directions, size_t count,
                                 const obc_host* host, uint32_t* triangles, double* weights, obc_error* error) {
  return capi::guarded(error, [&] {
    const sphere_map::Locator& in = checked(locator);
    const auto queries = view<Vector3>(directions, count, "directions is NULL");
    const capi::HostAdapter adapter(host);
    in.for_each_location(queries, adapter.host(), [&](std::size_t i, const sphere_map::Location& at) {
      if (triangles != nullptr) triangles[i] = at.triangle;
      if (weights != nullptr) std::copy(at.weights.begin(), at.weights.end(), weights + 3 * i);
    });
  });
}

obc_status obc_sphere_map_sample(const obc_sphere_map_locator* locator, const double* directions, size_t count,
                                 const double* values, size_t components, int32_t unit, const obc_host* host,
                                 double* sampled, obc_error* error) {
  return capi::guarded(error, [&] {
    const sphere_map::Locator& in = checked(locator);
    const auto queries = view<Vector3>(directions, count, "directions is NULL");
    capi::require(unit == 0 || unit == 1, "unit is neither 0 nor 1");
    capi::require(components > 0 && components <= PTRDIFF_MAX / sizeof(double) / std::max<std::size_t>(count, 1) &&
                      components <= PTRDIFF_MAX / sizeof(double) / in.directions().size(),
                  "components is 0 or too large");
    const capi::HostAdapter adapter(host);
    sphere_map::sample(in, queries, view<double>(values, components * in.directions().size(), "values is NULL"),
                       components, unit == 1 ? sphere_map::Interpolation::unit : sphere_map::Interpolation::linear,
                       view<double>(sampled, components * count, "sampled is NULL"), adapter.host());
  });
}

obc_status obc_sphere_map_grid(int32_t grid, size_t resolution, const obc_host* host, obc_mesh** out,
                               obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(out != nullptr, "out is NULL");
    *out = nullptr;
    const capi::HostAdapter adapter(host);
    const auto made = sphere_map::make_grid(static_cast<sphere_map::GridKind>(grid), resolution, adapter.host());
    capi::hand_out(made.directions, made.triangles, host, out);
  });
}

obc_status obc_sphere_map_remesh(const obc_sphere_map_locator* locator, const double* positions, int32_t grid,
                                 size_t resolution, const obc_host* host, obc_mesh** out, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(out != nullptr, "out is NULL");
    *out = nullptr;
    const sphere_map::Locator& in = checked(locator);
    const auto values = view<Vector3>(positions, in.directions().size(), "positions is NULL");
    const capi::HostAdapter adapter(host);
    const auto made = sphere_map::make_grid(static_cast<sphere_map::GridKind>(grid), resolution, adapter.host());
    const auto sampled =
        sphere_map::sample_vectors(in, made.directions, values, sphere_map::Interpolation::linear, adapter.host());
    mesh::require_valid_surface(sampled, made.triangles, adapter.host());
    capi::hand_out(sampled, made.triangles, host, out);
  });
}

obc_status obc_sphere_map_image_size(int32_t layout, size_t resolution, size_t* width, size_t* height,
                                     obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(width != nullptr && height != nullptr, "width or height is NULL");
    const auto size = sphere_map::image_size(to_layout(layout), resolution);
    *width = size.width;
    *height = size.height;
  });
}

obc_status obc_sphere_map_image(const obc_sphere_map_locator* locator, const double* positions, int32_t layout,
                                size_t resolution, const obc_host* host, double* pixels, obc_error* error) {
  return capi::guarded(error, [&] {
    const sphere_map::Locator& in = checked(locator);
    const auto values = view<Vector3>(positions, in.directions().size(), "positions is NULL");
    capi::require(pixels != nullptr, "pixels is NULL");
    const capi::HostAdapter adapter(host);
    const auto image = sphere_map::make_geometry_image(in, values, to_layout(layout), resolution, adapter.host());
    std::copy(image.pixels.begin(), image.pixels.end(), reinterpret_cast<Vector3*>(pixels));
  });
}

obc_status obc_sphere_map_image_surface(const double* pixels, int32_t layout, size_t resolution, const obc_host* host,
                                        obc_mesh** out, double* seam_gap, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(out != nullptr, "out is NULL");
    *out = nullptr;
    const capi::HostAdapter adapter(host);
    const auto made = sphere_map::surface_of(to_image(pixels, layout, resolution, adapter.host()), adapter.host());
    capi::hand_out(made.mesh.positions, made.mesh.triangles, host, out);
    if (seam_gap != nullptr) *seam_gap = made.seam_gap;
  });
}

obc_status obc_sphere_map_image_write(const char* path, const double* pixels, int32_t layout, size_t resolution,
                                      const obc_host* host, obc_error* error) {
  return capi::guarded(error, [&] {
    const capi::HostAdapter adapter(host);
    const auto image = to_image(pixels, layout, resolution, adapter.host());
    capi::on_file(path, [&] { sphere_map::write_geometry_image(path, image, adapter.host()); });
  });
}

obc_status obc_sphere_map_image_read(const char* path, const obc_host* host, int32_t* layout, size_t* resolution,
                                     double* pixels, size_t capacity, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(layout != nullptr && resolution != nullptr, "layout or resolution is NULL");
    const capi::HostAdapter adapter(host);
    const auto image = capi::on_file(path, [&] { return sphere_map::read_geometry_image(path, adapter.host()); });
    capi::require(pixels == nullptr || capacity / 3 >= image.pixels.size(), "capacity is less than the image needs");
    *layout = image.layout == sphere_map::ImageLayout::cube ? OBC_SPHERE_MAP_CUBE : OBC_SPHERE_MAP_OCTAHEDRON;
    *resolution = image.resolution;
    if (pixels != nullptr) std::copy(image.pixels.begin(), image.pixels.end(), reinterpret_cast<Vector3*>(pixels));
  });
}
