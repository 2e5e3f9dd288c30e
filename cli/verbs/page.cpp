// orbicube page: maps that are there already, measured, to look at in a browser.
#include <algorithm>
#include <deque>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "base/counted.h"
#include "files/map_file.h"
#include "files/surface_file.h"
#include "harmonics/fitting/fit.h"
#include "harmonics/rotations/alignment.h"
#include "mesh/search/vertex_measures.h"
#include "scenes/page_figures.h"
#include "solids/harmonics_of_shape.h"
#include "sphere_map/optimization/measure.h"
#include "sphere_map/sphere_map.h"
#include "verbs/verbs.h"

namespace orbicube::cli {
namespace {

struct PageOptions {
  std::vector<std::string> files;  // a shape, its map, a shape, its map, ...
  std::string output;
  std::string title = "Sphere maps";
  std::string up = "y";
  std::string align = "none";
  std::uint32_t degree = 0;  // of the harmonics; 0: none
};

struct MeasuredMap {
  explicit MeasuredMap(std::pmr::memory_resource* memory) : faces(memory), coefficients(memory) {}

  mesh::Mesh shape, map;
  sphere_map::FaceDistortion faces;
  harmonics::Coefficients coefficients;
  PageResult result;
};

harmonics::Coefficients fitted(const MeasuredMap& measured, std::uint32_t degree, const base::Host& host,
                               harmonics::FitReport& report) {
  return harmonics::fit(measured.map.positions,
                        mesh::vertex_areas(measured.shape.positions, measured.shape.triangles, host),
                        numbers(measured.shape.positions), 3, {.degree = degree}, host, report);
}

// Rotates shapes, with their maps, to where positions agree best with those of the first one, which stays.
class Alignment {
 public:
  void apply(MeasuredMap& measured, const base::Host& host) {
    constexpr std::uint32_t degree = 12;
    harmonics::FitReport report;
    harmonics::Coefficients own = fitted(measured, degree, host, report);
    if (!first_) {
      first_ = std::move(own);
      return;
    }
    const harmonics::Alignment found =
        harmonics::align(*first_, own, {.turn_values = true, .prefer_standing = true}, host);
    for (mesh::Vector3& direction : measured.map.positions)
      direction = (found.rotation * direction).stableNormalized();
    for (mesh::Vector3& position : measured.shape.positions)
      position = found.values * position;
  }

 private:
  std::optional<harmonics::Coefficients> first_;  // coarse
};

void measure(const std::string& shape_path, const std::string& map_path, const std::string& name, std::uint32_t degree,
             Alignment* alignment, Session& session, MeasuredMap& measured) {
  measured.shape = session.portion(0.2, [&] { return read_input(shape_path, false, session).mesh; });
  measured.map = read_map(measured.shape, shape_path, map_path, session);
  measured.shape.triangles = measured.map.triangles;
  const mesh::Mesh& shape = measured.shape;
  const sphere_map::Options weights;
  const sphere_map::Measurement figures = about(map_path, Role::input, [&] {
    return sphere_map::measure(shape.positions, shape.triangles, measured.map.positions, weights.angle_weight,
                               weights.area_weight, session.host(), &measured.faces);
  });
  for (mesh::Vector3& direction : measured.map.positions)
    direction.stableNormalize();
  if (alignment != nullptr) about(map_path, Role::input, [&] { alignment->apply(measured, session.host()); });
  measured.result = page_result(name, shape, measured.map.positions, figures, measured.faces, weights.angle_weight,
                                weights.area_weight);
  if (degree == 0) return;
  about(map_path, Role::input, [&] {
    const base::Host& host = session.host();
    harmonics::FitReport fit;
    measured.coefficients = fitted(measured, degree, host, fit);
    const mesh::Mesh made = surface_of(measured.coefficients, measured.map, host);
    add_harmonics(measured.result, measured.coefficients, fit, reconstruction_error(shape, made, host));
  });
}

void run_page(const PageOptions& options, Session& session) {
  session.options() = {{"files", options.files}, {"output", options.output}, {"title", options.title},
                       {"up", options.up},       {"align", options.align},   {"degree", options.degree}};
  if (options.files.size() % 2 != 0) {
    throw Failure(Exit::wrong_input, options.files.back(), "usage", "a shape without its map: give files in pairs");
  }
  if (options.align != "none" && options.files.size() == 2)
    throw Failure(Exit::wrong_input, options.files[0], "usage", "--align is for several shapes");
  std::map<std::string, int> times;  // that a shape is given; its maps are distinguished by their own names
  for (std::size_t i = 0; i < options.files.size(); i += 2)
    ++times[options.files[i]];
  std::deque<MeasuredMap> maps;
  std::vector<PageResult> results;
  Alignment alignment;
  for (std::size_t i = 0; i < options.files.size(); i += 2) {
    const std::filesystem::path named = times[options.files[i]] > 1 ? options.files[i + 1] : options.files[i];
    maps.emplace_back(session.host().memory);
    const base::Stage stage(session.host(), 2.0 / static_cast<double>(options.files.size() - i));
    measure(options.files[i], options.files[i + 1], named.filename().string(), options.degree,
            options.align == "none" ? nullptr : &alignment, session, maps.back());
    results.push_back(maps.back().result);
    results.back().z_up = options.up == "z";
  }
  const std::size_t bytes = write_page(options.output, results, options.title, session);
  session.figures() = {{"output", options.output}, {"results", results.size()}, {"bytes", bytes}};
  session.say("wrote " + options.output + ": " + base::counted(results.size(), "map") + ", open it in a browser");
  for (const std::string& note : session.notes())
    session.say("  note: " + note);
}

}  // namespace

void add_page(CLI::App& app, CommonOptions& common) {
  CLI::App* verb = app.add_subcommand("page", "show shapes beside their sphere maps, in one HTML file");
  const auto options = std::make_shared<PageOptions>();
  verb->add_option("FILES", options->files, std::string("shape and map, shape and map, ...: ") + surface_endings)
      ->required()
      ->type_name("SHAPE MAP");
  verb->add_option("-o,--output", options->output, "page to write")->required()->type_name("FILE.html");
  verb->add_option("--title", options->title, "heading of the page [default: " + options->title + "]")
      ->type_name("TEXT");
  verb->add_option("--up", options->up, "vertical axis of the first view, y or z [default: y]")
      ->check(CLI::IsMember({"y", "z"}))
      ->type_name("AXIS");
  verb->add_option(
          "--align", options->align,
          "rotation of shapes and their maps: none; shape, to maximum correlation of the positions with the first one "
          "[default: none]")
      ->check(unnamed(CLI::IsMember({"none", "shape"})))
      ->type_name("HOW");
  verb->add_option(
          "--degree", options->degree,
          "add a slider that shows shapes by their spherical harmonics to each degree up to L; 0: none [default: 0]")
      ->check(unnamed(CLI::Range(0U, harmonics::largest_degree)))
      ->type_name("L");
  add_common_options(*verb, common);
  verb->footer(
      "A map has the vertices and triangles of its shape, as written by 'orbicube sphere SHAPE -o MAP.obj'.\nThe page "
      "is one file that loads nothing else and needs no network.");
  verb->callback([options, &common] {
    Session session(common, "page", options->files.front());
    session.run([&] { run_page(*options, session); });
  });
}

}  // namespace orbicube::cli
