// Surfaces from glTF files and to them; wraps orbicube/gltf.h.
#ifndef ORBICUBE_GLTF_HPP
#define ORBICUBE_GLTF_HPP

#include <memory>
#include <utility>
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
  // Read with the option `keep`: what Scene::kept takes, and write_kept. Empty where the file does not allow it.
  std::shared_ptr<const obc_gltf_surface> kept;
};

namespace detail {
using namespace orbicube::detail;
template <class F>
Surface surface(Host* host, F&& f) {
  auto handle = take<obc_gltf_surface, obc_gltf_surface_destroy>(host, std::forward<F>(f));
  const obc_gltf_surface* const out = handle.get();
  Surface surface;
  surface.positions.resize(3 * obc_gltf_surface_vertex_count(out));
  surface.triangles.resize(3 * obc_gltf_surface_triangle_count(out));
  surface.welded_vertex_count = obc_gltf_surface_welded_vertex_count(out);
  for (std::size_t i = 0; i < obc_gltf_surface_note_count(out); ++i)
    surface.notes.emplace_back(obc_gltf_surface_note(out, i));
  call(nullptr, [&](obc_error* error) {
    return obc_gltf_surface_copy(out, surface.positions.data(), surface.triangles.data(), error);
  });
  if (obc_gltf_surface_keeps(out) != 0) surface.kept = std::move(handle);
  return surface;
}
}  // namespace detail

inline Surface read(const std::string& path, const ReadOptions& options = {}, Host* host = nullptr) {
  return detail::surface(host, [&](obc_gltf_surface** out, obc_error* error) {
    return obc_gltf_read(path.c_str(), &options, detail::c(host), out, error);
  });
}
// From bytes; buffers in files of their own lie in `folder`, nullptr refuses them.
inline Surface read(View<const unsigned char> bytes, const char* folder = nullptr, const ReadOptions& options = {},
                    Host* host = nullptr) {
  return detail::surface(host, [&](obc_gltf_surface** out, obc_error* error) {
    return obc_gltf_read_memory(bytes.data(), bytes.size(), folder, &options, detail::c(host), out, error);
  });
}
inline void write(const std::string& path, const Scene& scene, Host* host = nullptr) {
  detail::call(host, [&](obc_error* error) { return obc_gltf_write(path.c_str(), &scene, detail::c(host), error); });
}
// The file of a surface read with the option `keep` again, with all that it has.
inline void write_kept(const std::string& path, const Surface& surface, Host* host = nullptr) {
  detail::call(host, [&](obc_error* error) {
    return obc_gltf_write_kept(path.c_str(), surface.kept.get(), detail::c(host), error);
  });
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
