#include "files/json_file.h"

#include <cmath>

#include "base/error.h"
#include "mesh/files/file.h"

namespace orbicube::cli {

using mesh::Index;
using mesh::Vector3;

void refuse_file(const std::string& what) {
  throw base::Error("parse", what);
}

Json json_file(const std::filesystem::path& path, const base::Host& host) {
  const base::Array<std::byte> bytes = mesh::read_file(path, host);
  if (bytes.empty()) throw base::Error("empty-file", "no bytes");
  const char* const begin = reinterpret_cast<const char*>(bytes.data());
  // Deep nesting ends in an error of the parser's own, not of the stack.
  const Json result = Json::parse(
      begin, begin + bytes.size(),
      [](int depth, Json::parse_event_t, Json&) {
        if (depth > 16) throw base::Error("depth-limit", "nested too deeply");
        return true;
      },
      false);
  if (result.is_discarded()) refuse_file("this is no JSON");
  return result;
}

const Json& json_member(const Json& object, const char* name, const std::string& where) {
  if (!object.is_object() || !object.contains(name)) refuse_file(where + " has no \"" + name + "\"");
  return object[name];
}

Index json_index(const Json& value, const std::string& where) {
  if (!value.is_number_unsigned()) refuse_file(where + " is no number of a corner or vertex");
  const auto number = value.get<std::uint64_t>();
  if (number >= mesh::no_index) throw base::Error("index-range", where + " is too large");
  return static_cast<Index>(number);
}

Vector3 json_point(const Json& value, const std::string& where) {
  if (!value.is_array() || value.size() != 3) refuse_file(where + " is no array of three numbers");
  Vector3 result;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!value[k].is_number()) refuse_file(where + " is no array of three numbers");
    result[static_cast<Eigen::Index>(k)] = value[k].get<double>();
    if (!std::isfinite(result[static_cast<Eigen::Index>(k)])) throw base::Error("non-finite", where + " is not finite");
  }
  return result;
}

const Json& json_array(const Json& object, const char* name, const std::string& where) {
  const Json& value = json_member(object, name, where);
  if (!value.is_array()) refuse_file("\"" + std::string(name) + "\" of " + where + " is no array");
  return value;
}

}  // namespace orbicube::cli
