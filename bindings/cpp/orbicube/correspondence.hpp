// Closed surfaces on one triangulation, and their blends; wraps orbicube/correspondence.h.
#ifndef ORBICUBE_CORRESPONDENCE_HPP
#define ORBICUBE_CORRESPONDENCE_HPP

#include <vector>

#include <orbicube/correspondence.h>
#include <orbicube/mesh.hpp>

namespace orbicube {
inline namespace api {
namespace correspondence {

using Options = detail::Filled<obc_correspondence_options, obc_correspondence_options_init>;

// Points of a surface: triangles, and three weights at the corners of each.
struct Points {
  std::vector<std::uint32_t> triangles;
  std::vector<double> weights;
};

// Surfaces whose vertex i is at corresponding points of all. The host must outlive it.
class Correspondence {
 public:
  explicit Correspondence(const std::vector<obc_surface>& surfaces, const Options& options = {}, Host* host = nullptr)
      : handle_(detail::take<obc_correspondence, obc_correspondence_destroy>(host, [&](obc_correspondence** made,
                                                                                       obc_error* error) {
          return obc_correspondence_create(surfaces.data(), surfaces.size(), &options, detail::c(host), made, error);
        })) {}

  std::size_t shape_count() const { return obc_correspondence_shape_count(handle_.get()); }
  std::size_t vertex_count() const { return obc_correspondence_vertex_count(handle_.get()); }

  std::vector<std::uint32_t> triangles() const {
    std::vector<std::uint32_t> result(3 * obc_correspondence_triangle_count(handle_.get()));
    detail::call(nullptr, [&](obc_error* error) {
      return obc_correspondence_copy(handle_.get(), 0, nullptr, result.data(), error);
    });
    return result;
  }
  // Positions on one of the surfaces.
  std::vector<double> positions(std::size_t shape) const {
    std::vector<double> result(3 * vertex_count());
    detail::call(nullptr, [&](obc_error* error) {
      return obc_correspondence_copy(handle_.get(), shape, result.data(), nullptr, error);
    });
    return result;
  }
  // Positions on the common sphere or polycube.
  std::vector<double> domain() const {
    std::vector<double> result(3 * vertex_count());
    detail::call(nullptr,
                 [&](obc_error* error) { return obc_correspondence_copy_domain(handle_.get(), result.data(), error); });
    return result;
  }
  // Quads of a polycube's grid, four vertices each.
  std::vector<std::uint32_t> quads() const {
    std::vector<std::uint32_t> result(4 * obc_correspondence_quad_count(handle_.get()));
    detail::call(nullptr,
                 [&](obc_error* error) { return obc_correspondence_copy_quads(handle_.get(), result.data(), error); });
    return result;
  }
  // Where points of one surface are on another.
  Points map(std::size_t from, std::size_t to, const Points& points, Host* host = nullptr) const {
    if (points.weights.size() != 3 * points.triangles.size())
      throw Error(OBC_INVALID_ARGUMENT, "weights: three numbers a triangle are needed");
    Points result = points;
    detail::call(host, [&](obc_error* error) {
      return obc_correspondence_map(handle_.get(), from, to, points.triangles.data(), points.weights.data(),
                                    points.triangles.size(), detail::c(host), result.triangles.data(),
                                    result.weights.data(), error);
    });
    return result;
  }
  // Where the vertices of one surface are on another; UINT32_MAX for a vertex in no triangle.
  Points map(std::size_t from, std::size_t to, Host* host = nullptr) const {
    const std::size_t count = obc_correspondence_surface_vertex_count(handle_.get(), from);
    Points result{std::vector<std::uint32_t>(count), std::vector<double>(3 * count)};
    detail::call(host, [&](obc_error* error) {
      return obc_correspondence_map_vertices(handle_.get(), from, to, detail::c(host), result.triangles.data(),
                                             result.weights.data(), error);
    });
    return result;
  }
  // The sum of the positions on all surfaces times weights, one each.
  std::vector<double> blend(const std::vector<double>& weights) const {
    std::vector<double> result(3 * vertex_count());
    detail::call(nullptr, [&](obc_error* error) {
      return obc_correspondence_blend(handle_.get(), weights.data(), weights.size(), result.data(), error);
    });
    return result;
  }

 private:
  detail::Handle<obc_correspondence, obc_correspondence_destroy> handle_;
};

}  // namespace correspondence
}  // namespace api
}  // namespace orbicube

#endif
