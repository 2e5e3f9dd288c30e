// The names of the morph targets of a glTF file.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/host.h"

namespace orbicube::gltf {

// The names (mesh.extras.targetNames) that every mesh of the file has, in the order of the first mesh: those that
// ReadOptions::morph_target can be. Throws Error as read (read.h) does of a file that is none.
std::vector<std::string> target_names(const std::filesystem::path& path, const base::Host& host);

}  // namespace orbicube::gltf
