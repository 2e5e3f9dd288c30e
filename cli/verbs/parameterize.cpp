// orbicube parameterize: coordinates of a solid along a frame field.
#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>
#include <string>

#include "base/counted.h"
#include "files/surface_file.h"
#include "frame_field/frames_file.h"
#include "mesh/search/unit_scale.h"
#include "mesh/topology/cells.h"
#include "mesh/topology/place_text.h"
#include "report/text.h"
#include "scenes/parameter_scene.h"
#include "solids/solid_input.h"
#include "untangle/tetrahedra/elements.h"
#include "verbs/verbs.h"
#include "volume_map/frame_map/computed_frames.h"
#include "volume_map/frame_map/parameter_file.h"
#include "volume_map/frame_map/split_parameterization.h"

namespace orbicube::cli {
namespace {

constexpr const char* hexex_ending = ".hexex";

std::string parameter_ending(mesh::Format format) {
  return mesh::row_of(format).ending;
}

// What holds coordinates of the corners of tetrahedra, and what holds texture coordinates of the boundary.
std::string solid_endings() {
  return parameter_ending(mesh::Format::vtk) + " " + hexex_ending;
}

std::string boundary_endings() {
  return parameter_ending(mesh::Format::obj) + " " + gltf_endings;
}

struct ParameterizeVerb {
  std::string input;
  std::string output;
  std::string frames;
  std::string page;
  std::string split;
  bool integer = false;
  double feature_angle = 0;  // degrees
  std::size_t cells = 10000;
};

bool has_ending(const std::string& path, const char* ending) {
  return std::filesystem::path(path).extension() == ending;
}

mesh::Mesh read_tetrahedra(const ParameterizeVerb& verb, Session& session) {
  InputMesh input = read_input(verb.input, false, session);
  session.figures()["format"] = input.report.format;
  about(verb.input, Role::input, [&] {
    if (input.mesh.tetrahedra.empty())
      throw base::Error("no-cells", "no tetrahedra; `orbicube tetrahedralize` fills a surface");
    mesh::require_valid_cells(input.mesh, session.host());
    if (!input.mesh.hexahedra.empty()) throw base::Error("unsupported", "hexahedra beside the tetrahedra");
  });
  return std::move(input.mesh);
}

// Of the solid times 2^exponent, whose tetrahedra are split where --split requires that.
volume_map::Parameterization compute(const ParameterizeVerb& verb, int exponent, mesh::Mesh& solid, Session& session) {
  const base::Host& host = session.host();
  double volume = 0;
  for (const mesh::Tetrahedron& t : solid.tetrahedra)
    volume += untangle::six_volumes(solid.positions, t) / 6;
  const volume_map::ParameterizationOptions options = {
      .cell_length = std::cbrt(volume / static_cast<double>(verb.cells)), .integer = verb.integer};
  volume_map::FramedSolid framed(host.memory);
  framed.positions.assign(solid.positions.begin(), solid.positions.end());
  framed.tetrahedra.assign(solid.tetrahedra.begin(), solid.tetrahedra.end());
  const bool computed = verb.frames.empty(), split = !verb.split.empty();
  volume_map::Parameterization map = about(computed ? verb.input : verb.frames, Role::input, [&] {
    if (!computed) framed.frames = frame_field::read_frames(verb.frames, solid.tetrahedra.size(), host);
    return mesh::with_places_of_caller(exponent, [&] {
      if (computed) {
        return volume_map::parameterize_by_computed_frames(framed, verb.feature_angle * std::numbers::pi / 180, split,
                                                           options, host);
      }
      return split ? volume_map::parameterize_split(framed, options, host)
                   : volume_map::parameterize(framed, options, host);
    });
  });
  if (split) {
    solid.positions.assign(framed.positions.begin(), framed.positions.end());
    solid.tetrahedra.assign(framed.tetrahedra.begin(), framed.tetrahedra.end());
  }
  return map;
}

Json figures_of(const mesh::Mesh& solid, const volume_map::Parameterization& map, double cell_length) {
  return {{"vertices", solid.positions.size()},
          {"tetrahedra", solid.tetrahedra.size()},
          {"energy", map.energy},
          {"integer_cost", map.integer_cost},
          {"residual", map.residual},
          {"inverted", map.inverted},
          {"iterations", map.solves},
          {"cell_length", cell_length},
          {"integers", map.integers},
          {"integers_optimal", map.integers_optimal},
          {"patches", map.patches},
          {"cut_faces", map.cut_faces},
          {"singular_edges", map.singular_edges.size()}};
}

void write(const ParameterizeVerb& verb, const mesh::Mesh& solid, int exponent, const volume_map::Parameterization& map,
           Session& session) {
  const base::Host& host = session.host();
  base::Array<mesh::Vector3> positions(solid.positions, host.memory);
  mesh::scale_by_power(positions, -exponent);
  const std::string name = std::filesystem::path(verb.input).stem().string();
  const ParameterSurface surface = parameter_surface(positions, solid.tetrahedra, map, host);
  about(verb.output, Role::output, [&] {
    const std::filesystem::path file = session.stage(verb.output);
    const auto format = mesh::format_of_path(verb.output);
    if (format == mesh::Format::vtk)
      volume_map::write_parameter_vtk(file, positions, solid.tetrahedra, map, host);
    else if (has_ending(verb.output, hexex_ending))
      volume_map::write_hexex(file, positions, solid.tetrahedra, map, host);
    else if (format == mesh::Format::obj)
      write_parameter_obj(file, surface, host);
    else
      write_parameter_scene(file, surface, name, host);
  });
  if (!verb.split.empty()) {
    mesh::Mesh cells(host.memory);
    cells.positions = positions;
    cells.tetrahedra = solid.tetrahedra;
    write_cells_exactly(verb.split, cells, {}, session);
  }
  if (verb.page.empty()) return;
  write_parameter_page(verb.page, surface, name,
                       {{"Tetrahedra", std::to_string(solid.tetrahedra.size())},
                        {"Energy (eq. 5.3 over the volume)", number(map.energy)},
                        {"Inverted tetrahedra", std::to_string(map.inverted)},
                        {"Singular edges", std::to_string(map.singular_edges.size())}},
                       session);
}

void run_parameterize(const ParameterizeVerb& verb, Session& session) {
  const auto format = mesh::format_of_path(verb.output);
  if (format != mesh::Format::vtk && format != mesh::Format::obj && !has_ending(verb.output, hexex_ending) &&
      !is_gltf(verb.output))
    throw Failure(Exit::wrong_input, verb.output, "unsupported-format",
                  "parameterizations are written to " + solid_endings() + " " + boundary_endings());
  if (!verb.frames.empty() && verb.feature_angle > 0)
    throw Failure(Exit::wrong_input, "", "usage", "--feature-angle is for frames that are computed, without --frames");
  require_folder(verb.output);
  if (!verb.page.empty()) require_folder(verb.page);
  if (!verb.split.empty()) require_cells_writable(verb.split);
  session.options() = {{"output", verb.output},   {"frames", verb.frames},
                       {"integer", verb.integer}, {"feature_angle", verb.feature_angle},
                       {"cells", verb.cells},     {"page", verb.page},
                       {"split", verb.split}};
  mesh::Mesh solid = session.portion(0.05, [&] { return read_tetrahedra(verb, session); });
  const int exponent = mesh::bring_to_unit_size(solid);
  const double start = session.seconds();
  const volume_map::Parameterization map =
      session.portion(0.9, [&] { return compute(verb, exponent, solid, session); });
  session.figures()["output"] = verb.output;
  if (!verb.split.empty()) session.figures()["split"] = verb.split;
  session.figures().update(figures_of(solid, map, std::ldexp(map.cell_length, -exponent)));
  session.figures()["seconds_compute"] = session.seconds() - start;
  write(verb, solid, exponent, map, session);
  for (const std::string& note : session.notes())
    session.say("note: " + note);
  session.say("wrote " + verb.output + ": energy " + number(map.energy) + ", " + std::to_string(map.inverted) + " of " +
              base::counted(solid.tetrahedra.size(), "tetrahedron", "tetrahedra") + " inverted, " +
              base::counted(map.singular_edges.size(), "singular edge") + ", " + base::counted(map.patches, "plane") +
              " on the boundary; constraints to " + number(map.residual));
}

}  // namespace

void add_parameterize(CLI::App& app, CommonOptions& common) {
  CLI::App* verb = app.add_subcommand("parameterize", "compute coordinates of a solid along a frame field");
  const auto options = std::make_shared<ParameterizeVerb>();
  verb->add_option("SOLID", options->input, "tetrahedral mesh: " + cell_endings)->required()->type_name("");
  verb->add_option("-o,--output", options->output,
                   "tetrahedra with the coordinates of their corners: " + solid_endings() +
                       "; the boundary with the coordinates as texture coordinates: " + boundary_endings())
      ->required()
      ->type_name("OUT");
  verb->add_option("--frames", options->frames, "frame field of SOLID; default: computed")->type_name("FILE.frames");
  verb->add_flag("--integer", options->integer,
                 "round gaps, planes of the boundary and singular edges to integers, so that the grid of the "
                 "coordinates is continuous");
  verb->add_option("--cells", options->cells, "approximate number of unit cells of the coordinates [default: 10000]")
      ->check(unnamed(CLI::Range(1, 10'000'000)))
      ->type_name("N");
  verb->add_option("--feature-angle", options->feature_angle,
                   "minimum dihedral angle, in degrees, of boundary edges that computed frames follow; 0: none "
                   "[default: 0]")
      ->check(number_from_to(0, 179))
      ->type_name("DEGREES");
  verb->add_option("--split", options->split,
                   "split tetrahedra first that have no room between planes of the boundary and singular edges, and "
                   "around inverted ones, and write the split solid: " +
                       cell_endings)
      ->type_name("SOLID2");
  verb->add_option("--page", options->page, "one HTML file with the boundary and its coordinates")
      ->type_name("FILE.html");
  add_common_options(*verb, common);
  verb->callback([options, &common] {
    Session session(common, "parameterize", options->input);
    session.run([&] { run_parameterize(*options, session); });
  });
}

}  // namespace orbicube::cli
