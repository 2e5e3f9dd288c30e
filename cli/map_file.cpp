#include "map_file.h"

#include <algorithm>

#include "gltf/read.h"
#include "surface_file.h"

namespace orbicube::cli {
namespace {

bool same_connections(const mesh::Mesh& shape, const mesh::Mesh& map) {
  const auto sorted = [](mesh::Triangle t) {
    std::sort(t.begin(), t.end());
    return t;
  };
  return shape.positions.size() == map.positions.size() &&
         std::equal(shape.triangles.begin(), shape.triangles.end(), map.triangles.begin(), map.triangles.end(),
                    [&](const mesh::Triangle& a, const mesh::Triangle& b) { return sorted(a) == sorted(b); });
}

}  // namespace

mesh::Mesh read_map(const mesh::Mesh& shape, const std::string& shape_path, const std::filesystem::path& path,
                    Session& session) {
  mesh::Mesh map(session.host().memory);
  bool found = false;
  if (is_gltf(path)) {
    about(path, Role::input, [&] {
      try {
        map = gltf::read(path, {.morph_target = "sphere"}, session.host());
        found = true;
      } catch (const base::Error& error) {
        if (std::string_view(error.kind()) != "missing-attribute") throw;  // a map on its own, without a target
      }
    });
  }
  if (!found) map = read_input(path, false, session).mesh;
  if (!same_connections(shape, map)) {
    throw Failure(Exit::wrong_input, path, "invalid-argument",
                  "it has not the vertices and triangles of " + shape_path + ", in that order");
  }
  return map;
}

}  // namespace orbicube::cli
