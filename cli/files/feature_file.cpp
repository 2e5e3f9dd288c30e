#include "files/feature_file.h"

#include "files/json_file.h"

namespace orbicube::cli {
namespace {

double weight_of(const Json& feature, const std::string& where) {
  if (!feature.contains("weight")) return 0;
  if (!feature["weight"].is_number()) refuse_file("\"weight\" of " + where + " is no number");
  return feature["weight"].get<double>();
}

}  // namespace

Features read_features(const std::filesystem::path& path, const base::Host& host) {
  return about(path, Role::input, [&] {
    const Json file = json_file(path, host);
    if (!file.is_object() || (!file.contains("points") && !file.contains("curves")))
      refuse_file("there are neither \"points\" nor \"curves\"");
    Features result;
    const Json none = Json::array();
    const Json& points = file.contains("points") ? json_array(file, "points", "the file") : none;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::string where = "point " + std::to_string(i);
      result.points.push_back({json_index(json_member(points[i], "vertex", where), "\"vertex\" of " + where),
                               json_point(json_member(points[i], "target", where), "\"target\" of " + where),
                               weight_of(points[i], where)});
    }
    const Json& curves = file.contains("curves") ? json_array(file, "curves", "the file") : none;
    for (std::size_t i = 0; i < curves.size(); ++i) {
      const std::string where = "curve " + std::to_string(i);
      std::vector<mesh::Index>& vertices = result.vertices.emplace_back();
      for (const Json& vertex : json_array(curves[i], "vertices", where))
        vertices.push_back(json_index(vertex, "a vertex of " + where));
      result.curves.push_back({vertices, json_point(json_member(curves[i], "from", where), "\"from\" of " + where),
                               json_point(json_member(curves[i], "to", where), "\"to\" of " + where),
                               weight_of(curves[i], where)});
    }
    return result;
  });
}

}  // namespace orbicube::cli
