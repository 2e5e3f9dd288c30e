// JSON files that users write: read whole, with what is wrong and where.
#pragma once

#include <filesystem>
#include <string>

#include "mesh/mesh.h"
#include "session/session.h"

namespace orbicube::cli {

// All throw base::Error: "parse" and the like with what is wrong, "index-range", "non-finite".
[[noreturn]] void refuse_file(const std::string& what);
Json json_file(const std::filesystem::path& path, const base::Host& host);
const Json& json_member(const Json& object, const char* name, const std::string& where);
mesh::Index json_index(const Json& value, const std::string& where);
mesh::Vector3 json_point(const Json& value, const std::string& where);
const Json& json_array(const Json& object, const char* name, const std::string& where);

}  // namespace orbicube::cli
