// Surfaces from glTF files and to them; wraps orbicube/gltf.h.
#ifndef ORBICUBE_GLTF_HPP
#define ORBICUBE_GLTF_HPP

#include <vector>

#include <orbicube/gltf.h>
#include <orbicube/base.hpp>

namespace orbicube {
inline namespace api {
namespace gltf {

using ReadOptions = detail::Filled<obc_gltf_read_options, obc_gltf_read_options_init>;
using Scene = detail::Filled<obc_gltf_scene, obc_gltf_scene_init>;  // views of the caller's arrays

struct Surface {
  std::vector<double> positions;
  std::vector<std::uint32_t> triangles;
  std::size_t welded_vertex_count = 0;
  std::vector<std::string> notes;
};

inline Surface read(const std::string& path, const ReadOptions& options = {}, Host* host = nullptr) {
  const auto handle =
      detail::take<obc_gltf_surface, obc_gltf_surface_destroy>(host, [&](obc_gltf_surface** made, obc_error* error) {
        return obc_gltf_read(path.c_str(), &options, detail::c(host), made, error);
      });
  const obc_gltf_surface* const out = handle.get();
  Surface surface;
  surface.positions.resize(3 * obc_gltf_surface_vertex_count(out));
  surface.triangles.resize(3 * obc_gltf_surface_triangle_count(out));
  surface.welded_vertex_count = obc_gltf_surface_welded_vertex_count(out);
  for (std::size_t i = 0; i < obc_gltf_surface_note_count(out); ++i)
    surface.notes.emplace_back(obc_gltf_surface_note(out, i));
  detail::call(nullptr, [&](obc_error* error) {
    return obc_gltf_surface_copy(out, surface.positions.data(), surface.triangles.data(), error);
  });
  return surface;
}
inline void write(const std::string& path, const Scene& scene, Host* host = nullptr) {
  detail::call(host, [&](obc_error* error) { return obc_gltf_write(path.c_str(), &scene, detail::c(host), error); });
}
// A surface alone, with smooth normals.
inline void write(const std::string& path, View<const float> positions, Indices triangles, Host* host = nullptr) {
  detail::call(host, [&](obc_error* error) {
    return obc_gltf_write_surface(path.c_str(), positions.data(), detail::rows(positions.size(), 3, "positions"),
                                  triangles.data(), detail::rows(triangles.size(), 3, "triangles"), detail::c(host),
                                  error);
  });
}

}  // namespace gltf
}  // namespace api
}  // namespace orbicube

#endif
