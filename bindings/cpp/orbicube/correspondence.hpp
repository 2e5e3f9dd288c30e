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
