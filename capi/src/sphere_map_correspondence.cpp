// Correspondence of two shapes through the spheres of their maps.
#include <algorithm>
#include <memory>

#include "capi/src/entry.h"
#include "capi/src/sphere_map_surface.h"
#include "orbicube/sphere_map.h"
#include "sphere_map/correspondence/alignment.h"
#include "sphere_map/correspondence/overlay.h"
#include "sphere_map/optimization/pieces.h"

using namespace orbicube;
using capi::view;
using sphere_map::Triangle;
using sphere_map::Vector3;

struct obc_sphere_map_warp {
  obc_sphere_map_warp(const obc_host* host, std::span<const Vector3> from, std::span<const Vector3> to)
      : adapter(host), warp(from, to, adapter.host()) {}
  capi::HostAdapter adapter;
  sphere_map::SphereWarp warp;
};

obc_status obc_sphere_map_best_rotation(const double* from, const double* to, size_t count, double rotation[9],
                                        obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(rotation != nullptr, "rotation is NULL");
    const sphere_map::Matrix3 best =
        sphere_map::best_rotation(view<Vector3>(from, count, "from is NULL"), view<Vector3>(to, count, "to is NULL"));
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>{rotation} = best;
  });
}

obc_status obc_sphere_map_warp_create(const double* from, const double* to, size_t count, const obc_host* host,
                                      obc_sphere_map_warp** out, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(out != nullptr, "out is NULL");
    *out = nullptr;
    *out = new obc_sphere_map_warp(host, view<Vector3>(from, count, "from is NULL"),
                                   view<Vector3>(to, count, "to is NULL"));
  });
}

void obc_sphere_map_warp_destroy(obc_sphere_map_warp* warp) {
  delete warp;
}

obc_status obc_sphere_map_warp_apply(const obc_sphere_map_warp* warp, const double* directions, size_t count,
                                     int32_t backward, const obc_host* host, double* moved, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(warp != nullptr, "warp is NULL");
    capi::require(backward == 0 || backward == 1, "backward is neither 0 nor 1");
    const auto from = view<Vector3>(directions, count, "directions is NULL");
    const auto to = view<Vector3>(moved, count, "moved is NULL");
    const capi::HostAdapter adapter(host);
    sphere_map::for_each_in_pieces(count, "warping", adapter.host(), [&](std::size_t i) {
      sphere_map::require_direction(from[i], "direction", i);
      to[i] = backward == 1 ? warp->warp.backward(from[i]) : warp->warp.forward(from[i]);
    });
  });
}

obc_status obc_sphere_map_overlay(const obc_surface* first, const double* first_directions, const obc_surface* second,
                                  const double* second_directions, const obc_host* host, obc_mesh** out,
                                  uint32_t* second_vertex, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(out != nullptr, "out is NULL");
    *out = nullptr;
    const auto placed = [](const obc_surface* surface, const double* directions) {
      capi::require(surface != nullptr, "a surface is NULL");
      return sphere_map::PlacedMap{view<Vector3>(directions, surface->vertex_count, "directions are NULL"),
                                   view<Triangle>(surface->triangles, surface->triangle_count, "triangles are NULL")};
    };
    const sphere_map::PlacedMap of_first = placed(first, first_directions);
    const sphere_map::PlacedMap of_second = placed(second, second_directions);
    const capi::HostAdapter adapter(host);
    const sphere_map::Overlay made = sphere_map::overlay(of_first, {&of_second, 1}, adapter.host());
    capi::hand_out(made.directions, made.triangles, host, out);
    if (second_vertex != nullptr) std::copy(made.vertex_of[0].begin(), made.vertex_of[0].end(), second_vertex);
  });
}
