// The two kinds of glTF files and their endings: the only place that lists them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace orbicube::gltf {

enum class Form { glb, gltf };

// Returns the kind that a path's ending stands for, in upper or lower case, if any.
std::optional<Form> form_of_path(const std::filesystem::path& path);

// Returns the endings, separated by spaces, for messages and help texts.
std::string form_endings();

}  // namespace orbicube::gltf
