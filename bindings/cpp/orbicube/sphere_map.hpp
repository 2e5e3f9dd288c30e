// Bijective maps of closed surfaces to the sphere, and what they are for; wraps orbicube/sphere_map.h.
//
//   auto map = orbicube::sphere_map::compute(mesh);       // map.directions, map.report
//   orbicube::sphere_map::Locator locator(mesh, map.directions);
#ifndef ORBICUBE_SPHERE_MAP_HPP
#define ORBICUBE_SPHERE_MAP_HPP

#include <array>
#include <vector>

#include <orbicube/sphere_map.h>
#include <orbicube/mesh.hpp>

namespace orbicube {
inline namespace api {
namespace sphere_map {

using Options = detail::Filled<obc_sphere_map_options, obc_sphere_map_options_init>;
using Report = detail::Filled<obc_sphere_map_report, obc_sphere_map_report_init>;

struct Map {
  std::vector<double> directions;  // x y z a vertex
  Report report;
};

namespace detail {
using namespace orbicube::detail;
template <class F>
Mesh mesh(Host* host, F&& f) {
  return Mesh(take<obc_mesh, obc_mesh_destroy>(host, std::forward<F>(f)).release());
}
}  // namespace detail

inline Map compute(const Surface& surface, const Options& options = {}, Host* host = nullptr) {
  Map map{std::vector<double>(3 * surface.vertex_count), {}};
  detail::call(host, [&](obc_error* error) {
    return obc_sphere_map_compute(&surface, &options, detail::c(host), map.directions.data(), &map.report, error);
  });
  return map;
}
// What there is of a map, also when the work is cancelled or finds no valid result.
struct Partial {
  std::vector<double> directions;
  std::size_t placed = 0;      // vertices that have places of their own
  obc_status status = OBC_OK;  // OBC_CANCELLED or OBC_NO_VALID_RESULT, or all went well
  std::string message;
};
inline Partial compute_partial(const Surface& surface, const Options& options = {}, Host* host = nullptr) {
  Partial partial;
  partial.directions.resize(3 * surface.vertex_count);
  try {
    detail::call(host, [&](obc_error* error) {
      return obc_sphere_map_compute_partial(&surface, &options, detail::c(host), partial.directions.data(),
                                            &partial.placed, nullptr, error);
    });
  } catch (const Error& error) {
    if (error.status() != OBC_CANCELLED && error.status() != OBC_NO_VALID_RESULT) throw;
    partial.status = error.status();
    partial.message = error.what();
  }
  return partial;
}
inline Report measure(const Surface& surface, Doubles directions, const Options& options = {}, Host* host = nullptr) {
  detail::check_size(directions.size(), 3 * surface.vertex_count, "directions");
  Report report;
  detail::call(host, [&](obc_error* error) {
    return obc_sphere_map_measure(&surface, directions.data(), &options, detail::c(host), &report, error);
  });
  return report;
}
// Of each triangle.
struct Distortion {
  std::vector<double> quasi_conformal, area_ratio;
};
inline Distortion face_distortion(const Surface& surface, Doubles directions, Host* host = nullptr) {
  detail::check_size(directions.size(), 3 * surface.vertex_count, "directions");
  Distortion found{std::vector<double>(surface.triangle_count), std::vector<double>(surface.triangle_count)};
  detail::call(host, [&](obc_error* error) {
    return obc_sphere_map_face_distortion(&surface, directions.data(), detail::c(host), found.quasi_conformal.data(),
                                          found.area_ratio.data(), error);
  });
  return found;
}
inline std::vector<float> round_to_float(const Surface& surface, Doubles directions, Host* host = nullptr) {
  detail::check_size(directions.size(), 3 * surface.vertex_count, "directions");
  std::vector<float> rounded(directions.size());
  detail::call(host, [&](obc_error* error) {
    return obc_sphere_map_round_to_float(&surface, directions.data(), detail::c(host), rounded.data(), error);
  });
  return rounded;
}
// grid: OBC_SPHERE_MAP_ICOSPHERE, ...
inline Mesh grid(std::int32_t grid, std::size_t resolution, Host* host = nullptr) {
  return detail::mesh(host, [&](obc_mesh** out, obc_error* error) {
    return obc_sphere_map_grid(grid, resolution, detail::c(host), out, error);
  });
}

// Where directions lie in a map. Any number of threads may use one.
class Locator {
 public:
  Locator(const Surface& surface, Doubles directions, Host* host = nullptr) : vertex_count_(surface.vertex_count) {
    detail::check_size(directions.size(), 3 * vertex_count_, "directions");
    handle_ = detail::take<obc_sphere_map_locator, obc_sphere_map_locator_destroy>(
        host, [&](obc_sphere_map_locator** out, obc_error* error) {
          return obc_sphere_map_locator_create(&surface, directions.data(), detail::c(host), out, error);
        });
  }
  struct Places {
    std::vector<std::uint32_t> triangles;
    std::vector<double> weights;  // three a direction
  };
  Places locate(Doubles directions, Host* host = nullptr) const {
    const std::size_t n = detail::rows(directions.size(), 3, "directions");
    Places places{std::vector<std::uint32_t>(n), std::vector<double>(3 * n)};
    detail::call(host, [&](obc_error* error) {
      return obc_sphere_map_locate(handle(), directions.data(), n, detail::c(host), places.triangles.data(),
                                   places.weights.data(), error);
    });
    return places;
  }
  // Values of the vertices, interpolated; `unit` scales each result to length 1.
  std::vector<double> sample(Doubles directions, Doubles values, bool unit = false, Host* host = nullptr) const {
    const std::size_t n = detail::rows(directions.size(), 3, "directions");
    const std::size_t components = detail::rows(values.size(), vertex_count_, "values");
    std::vector<double> sampled(components * n);
    detail::call(host, [&](obc_error* error) {
      return obc_sphere_map_sample(handle(), directions.data(), n, values.data(), components, unit ? 1 : 0,
                                   detail::c(host), sampled.data(), error);
    });
    return sampled;
  }
  Mesh remesh(Doubles positions, std::int32_t grid, std::size_t resolution, Host* host = nullptr) const {
    detail::check_size(positions.size(), 3 * vertex_count_, "positions");
    return detail::mesh(host, [&](obc_mesh** out, obc_error* error) {
      return obc_sphere_map_remesh(handle(), positions.data(), grid, resolution, detail::c(host), out, error);
    });
  }
  std::size_t vertex_count() const noexcept { return vertex_count_; }
  obc_sphere_map_locator* handle() const noexcept { return handle_.get(); }

 private:
  std::size_t vertex_count_;
  detail::Handle<obc_sphere_map_locator, obc_sphere_map_locator_destroy> handle_;
};

// A geometry image: pixels x y z, row by row from the top. layout: OBC_SPHERE_MAP_OCTAHEDRON or OBC_SPHERE_MAP_CUBE.
struct Image {
  std::int32_t layout;
  std::size_t resolution, width = 0, height = 0;
  std::vector<double> pixels;

  Image(std::int32_t layout_, std::size_t resolution_) : layout(layout_), resolution(resolution_) {
    detail::call(nullptr, [&](obc_error* error) {
      return obc_sphere_map_image_size(layout, resolution, &width, &height, error);
    });
    pixels.resize(3 * width * height);
  }
  // Of positions of the vertices, or other vectors.
  Image(const Locator& locator, Doubles positions, std::int32_t layout_, std::size_t resolution_, Host* host = nullptr)
      : Image(layout_, resolution_) {
    detail::check_size(positions.size(), 3 * locator.vertex_count(), "positions");
    detail::call(host, [&](obc_error* error) {
      return obc_sphere_map_image(locator.handle(), positions.data(), layout, resolution, detail::c(host),
                                  pixels.data(), error);
    });
  }
  // From .pfm and .png, and to them.
  static Image read(const std::string& path, Host* host = nullptr) {
    std::int32_t kind = 0;
    std::size_t size = 0;
    detail::call(host, [&](obc_error* error) {
      return obc_sphere_map_image_read(path.c_str(), detail::c(host), &kind, &size, nullptr, 0, error);
    });
    Image image(kind, size);
    detail::call(host, [&](obc_error* error) {
      return obc_sphere_map_image_read(path.c_str(), detail::c(host), &kind, &size, image.pixels.data(),
                                       image.pixels.size(), error);
    });
    return image;
  }
  void write(const std::string& path, Host* host = nullptr) const {
    check();
    detail::call(host, [&](obc_error* error) {
      return obc_sphere_map_image_write(path.c_str(), pixels.data(), layout, resolution, detail::c(host), error);
    });
  }
  // The closed surface back; seam_gap: the largest distance between pixels that are one vertex.
  Mesh surface(double* seam_gap = nullptr, Host* host = nullptr) const {
    check();
    return detail::mesh(host, [&](obc_mesh** out, obc_error* error) {
      return obc_sphere_map_image_surface(pixels.data(), layout, resolution, detail::c(host), out, seam_gap, error);
    });
  }
  void check() const { detail::check_size(pixels.size(), 3 * width * height, "pixels"); }
};

// One triangulation of the sphere with the vertices of two maps; second_vertex: where those of the second are in it
// (UINT32_MAX: in no triangle).
inline Mesh overlay(const Surface& first, Doubles first_directions, const Surface& second, Doubles second_directions,
                    std::vector<std::uint32_t>* second_vertex = nullptr, Host* host = nullptr) {
  detail::check_size(first_directions.size(), 3 * first.vertex_count, "first_directions");
  detail::check_size(second_directions.size(), 3 * second.vertex_count, "second_directions");
  if (second_vertex != nullptr) second_vertex->resize(second.vertex_count);
  return detail::mesh(host, [&](obc_mesh** out, obc_error* error) {
    return obc_sphere_map_overlay(&first, first_directions.data(), &second, second_directions.data(), detail::c(host),
                                  out, second_vertex == nullptr ? nullptr : second_vertex->data(), error);
  });
}

// The matrix, by rows, that takes directions nearest to others.
inline std::array<double, 9> best_rotation(Doubles from, Doubles to) {
  detail::check_size(to.size(), from.size(), "to");
  std::array<double, 9> rotation{};
  detail::call(nullptr, [&](obc_error* error) {
    return obc_sphere_map_best_rotation(from.data(), to.data(), detail::rows(from.size(), 3, "from"), rotation.data(),
                                        error);
  });
  return rotation;
}

// A smooth bijection of the sphere that carries landmarks onto landmarks.
class Warp {
 public:
  Warp(Doubles from, Doubles to, Host* host = nullptr) {
    detail::check_size(to.size(), from.size(), "to");
    handle_ = detail::take<obc_sphere_map_warp, obc_sphere_map_warp_destroy>(
        host, [&](obc_sphere_map_warp** out, obc_error* error) {
          return obc_sphere_map_warp_create(from.data(), to.data(), detail::rows(from.size(), 3, "from"),
                                            detail::c(host), out, error);
        });
  }
  std::vector<double> apply(Doubles directions, bool backward = false, Host* host = nullptr) const {
    std::vector<double> moved(directions.size());
    detail::call(host, [&](obc_error* error) {
      return obc_sphere_map_warp_apply(handle(), directions.data(), detail::rows(directions.size(), 3, "directions"),
                                       backward ? 1 : 0, detail::c(host), moved.data(), error);
    });
    return moved;
  }
  obc_sphere_map_warp* handle() const noexcept { return handle_.get(); }

 private:
  detail::Handle<obc_sphere_map_warp, obc_sphere_map_warp_destroy> handle_;
};

}  // namespace sphere_map
}  // namespace api
}  // namespace orbicube

#endif
