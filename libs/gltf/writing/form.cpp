#include "gltf/writing/form.h"

#include "mesh/formats/formats.h"

namespace orbicube::gltf {
namespace {

constexpr const char* glb_ending = ".glb";
constexpr const char* gltf_ending = ".gltf";

}  // namespace

std::optional<Form> form_of_path(const std::filesystem::path& path) {
  const std::string ending = mesh::ending_of(path);
  if (ending == glb_ending) return Form::glb;
  if (ending == gltf_ending) return Form::gltf;
  return std::nullopt;
}

std::string form_endings() {
  return std::string(glb_ending) + " " + gltf_ending;
}

}  // namespace orbicube::gltf
