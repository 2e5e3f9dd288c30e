#include "scenes/report_page.h"

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "report_page/filled_page.h"
#include "report_page/packed_mesh.h"
#include "report_page/template.h"

namespace orbicube::cli {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Levels& levels) {
  return {{"zero", levels.zero}, {"span", levels.span}, {"octaves", levels.octaves}, {"none", levels.none}};
}

Json json_of(const PageResult& result) {
  PackedMesh mesh = pack(result);
  Json figures = Json::array();
  for (const auto& [name, value] : result.figures)
    figures.push_back({name, value});
  Json harmonics;
  if (!result.coefficients.empty()) {
    harmonics = {{"degree", result.degree},
                 {"facing", std::vector<double>(mesh.facing.data(), mesh.facing.data() + mesh.facing.size())},
                 {"coefficients", std::move(mesh.coefficients)}};
  }
  Json polycube;
  if (!result.polycube.empty()) {
    polycube = {{"positions", std::move(mesh.polycube)},
                {"facing", std::vector<double>(mesh.facing.data(), mesh.facing.data() + mesh.facing.size())}};
  }
  return {{"name", result.name},
          {"figures", std::move(figures)},
          {"zUp", result.z_up},
          {"vertices", mesh.vertices},
          {"triangles", mesh.triangles},
          {"low", {mesh.low.x(), mesh.low.y(), mesh.low.z()}},
          {"step", mesh.step},
          {"positions", std::move(mesh.positions)},
          {"directions", std::move(mesh.directions)},
          {"connections", std::move(mesh.connections)},
          {"quasiConformal", std::move(mesh.quasi_conformal)},
          {"areaRatio", std::move(mesh.area_ratio)},
          {"quasiConformalShare", mesh.quasi_conformal_share},
          {"areaRatioShare", mesh.area_ratio_share},
          {"polycube", std::move(polycube)},
          {"energies", result.energies},
          {"harmonics", std::move(harmonics)}};
}

}  // namespace

std::string report_page(std::span<const PageResult> results, const std::string& title) {
  if (results.empty()) throw base::Error("invalid-argument", "no result for the page");
  Json data = {{"levels", {{"quasiConformal", json_of(quasi_conformal_levels)}, {"area", json_of(area_levels)}}},
               {"results", Json::array()}};
  for (const PageResult& result : results)
    data["results"].push_back(json_of(result));
  return filled_page(page_template(), title, data);
}

}  // namespace orbicube::cli
