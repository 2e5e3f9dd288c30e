#include "gltf/reading/target_names.h"

#include <algorithm>

#include "gltf/json/asset.h"
#include "mesh/files/file.h"

namespace orbicube::gltf {
namespace {

std::vector<std::string> names_of(const tiny::Mesh& mesh) {
  std::vector<std::string> result;
  if (!mesh.extras.Has("targetNames")) return result;
  const tiny::Value& names = mesh.extras.Get("targetNames");
  for (std::size_t i = 0; i < names.ArrayLen(); ++i) {
    const tiny::Value& each = names.Get(static_cast<int>(i));
    if (each.IsString()) result.push_back(each.Get<std::string>());
  }
  return result;
}

}  // namespace

std::vector<std::string> target_names(const std::filesystem::path& path, const base::Host& host) {
  const base::Array<std::byte> bytes = mesh::read_file(path, host);
  const Asset asset(bytes, path.parent_path(), Extent::surface, host);
  const auto& meshes = asset.model().meshes;
  if (meshes.empty()) return {};
  std::vector<std::string> result = names_of(meshes.front());
  for (const tiny::Mesh& mesh : meshes) {
    const std::vector<std::string> others = names_of(mesh);
    std::erase_if(result, [&](const std::string& name) { return std::ranges::find(others, name) == others.end(); });
  }
  return result;
}

}  // namespace orbicube::gltf
