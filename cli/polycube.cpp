// orbicube polycube: a polycube of a closed surface and a certified map to it.
#include <memory>
#include <string>
#include <utility>

#include "checked_file.h"
#include "mesh/file.h"
#include "mesh/orient.h"
#include "mesh/topology.h"
#include "mesh/write.h"
#include "polycube/construction.h"
#include "polycube/optimal_domain.h"
#include "surface_file.h"
#include "verbs.h"

namespace orbicube::cli {
namespace {

struct PolycubeOptions {
  std::string input;
  std::string output;
  std::string surface;
  std::string construct = "auto";
  std::size_t corners = 0;
  std::string optimise;
  std::string measure = "surface";
  double area_weight = 1;
  bool text = false;
  bool weld = false;
};

// Formats that keep the order of vertices and every bit of their coordinates.
void require_exact_format(const std::string& path) {
  const auto format = is_gltf(path) ? mesh::Format::stl : mesh::format_of_path(path);
  if (format != mesh::Format::stl) return;
  throw Failure(Exit::wrong_input, path, "unsupported-format",
                "faces of a polycube lie exactly in planes; this format rounds coordinates or joins vertices");
}

mesh::Mesh read_surface(const PolycubeOptions& options, Session& session) {
  InputMesh input = read_input(options.input, options.weld, session);
  mesh::Mesh& m = input.mesh;
  about(options.input, Role::input, [&] {
    if (!m.tetrahedra.empty() || !m.hexahedra.empty())
      throw base::Error("unsupported", "a solid of cells; polycube takes surfaces");
    const mesh::Topology facts = mesh::topology(m.positions, m.triangles, session.host());
    mesh::require_closed_manifold(facts);
    if (facts.components > 1) throw base::Error("not-connected", std::to_string(facts.components) + " components");
    if (!facts.orientable) throw base::Error("non-orientable", "no orientation of the triangles is consistent");
    const mesh::OrientReport turned = mesh::orient(m.positions, m.triangles, session.host());
    if (turned.triangles_turned > 0)
      session.note(std::to_string(turned.triangles_turned) + " triangles were turned to agree with their neighbours");
    if (turned.turned_outward) session.note("the surface looked inward; all triangles were turned");
    session.figures()["input"] = {{"format", input.report.format},
                                  {"vertices", m.positions.size()},
                                  {"triangles", m.triangles.size()},
                                  {"genus", facts.genus.value_or(0)}};
  });
  return std::move(m);
}

// Written beside its place, read again and compared: what was certified is what the file holds.
void write_exactly(const std::string& path, const base::Array<mesh::Vector3>& positions,
                   const base::Array<mesh::Triangle>& triangles, bool text, Session& session) {
  about(path, Role::output, [&] {
    mesh::Mesh m(session.host().memory);
    m.positions = positions;
    m.triangles = triangles;
    CheckedFile file(path);
    mesh::write_mesh(file.path(), m, {.binary = !text}, session.host());
    const mesh::Mesh again = mesh::read_mesh(file.path(), {}, session.host());
    if (again.positions != positions || again.triangles != triangles)
      throw base::Error("no-valid-result", "what was written is not what is read again");
    file.commit();
  });
}

polycube::Method method_named(const std::string& name) {
  if (name == "labels") return polycube::Method::labels;
  return name == "voxels" ? polycube::Method::voxels : polycube::Method::automatic;
}

polycube::DomainMeasure measure_of(const std::string& name) {
  if (name == "faces") return polycube::DomainMeasure::face_mean;
  return name == "harmonic" ? polycube::DomainMeasure::harmonic : polycube::DomainMeasure::surface_mean;
}

Json distortion_figures(const polycube::Distortion& d) {
  return {{"angle_mean", d.angle_mean},
          {"area_mean", d.area_mean},
          {"angle_weighted_mean", d.angle_weighted_mean},
          {"area_weighted_mean", d.area_weighted_mean}};
}

// The best proportions for the polycube that was made.
void optimise_domain(const PolycubeOptions& options, polycube::Construction& made, Session& session) {
  const double start = session.seconds();
  polycube::OptimalDomain found = polycube::optimise_domain(
      made.map, {.measure = measure_of(options.measure), .area_weight = options.area_weight}, session.host());
  session.figures()["domain"] = {{"distortion_before", distortion_figures(made.distortion)},
                                 {"energies", found.energies},
                                 {"evaluations", found.evaluations},
                                 {"converged", found.converged},
                                 {"layers", found.layers},
                                 {"cells", found.cells},
                                 {"triangles_across_layers", found.crossing},
                                 {"seconds", session.seconds() - start}};
  made.certificate = std::move(found.certificate);
  made.distortion = found.distortion;
}

void polycube(const PolycubeOptions& options, Session& session) {
  require_writable(options.output);
  require_exact_format(options.output);
  if (!options.surface.empty()) {
    require_writable(options.surface);
    require_exact_format(options.surface);
  }
  session.options() = {{"output", options.output},    {"surface", options.surface}, {"construct", options.construct},
                       {"corners", options.corners},  {"text", options.text},       {"weld", options.weld},
                       {"optimise", options.optimise}};
  if (!options.optimise.empty())
    session.options().update(Json{{"measure", options.measure}, {"area_weight", options.area_weight}});
  const mesh::Mesh input = read_surface(options, session);
  const double start = session.seconds();
  polycube::BestConstruction best = about(options.input, Role::input, [&] {
    return polycube::construct(
        input.positions, input.triangles,
        {.method = method_named(options.construct), .corners = options.corners, .seed = session.seed()},
        session.host());
  });
  polycube::Construction& made = best.made;
  const std::string method = best.method == polycube::Method::labels ? "labels" : "voxels";
  const double constructed = session.seconds();
  if (!options.optimise.empty()) optimise_domain(options, made, session);
  const double optimised = session.seconds();
  const polycube::SurfaceMap& map = made.map;
  write_exactly(options.output, map.polycube, map.triangles, options.text, session);
  if (!options.surface.empty()) write_exactly(options.surface, map.positions, map.triangles, options.text, session);

  const std::size_t added = map.positions.size() - input.positions.size();
  session.figures().update(Json{{"vertices", map.positions.size()},
                                {"vertices_added", added},
                                {"triangles", map.triangles.size()},
                                {"corners", made.certificate.corners},
                                {"patches", made.certificate.patches},
                                {"genus", made.certificate.genus},
                                {"distortion", distortion_figures(made.distortion)},
                                {"construction", method},
                                {"polycubes_tried", made.tried},
                                {"polycubes_valid", made.valid},
                                {"seconds_construct", constructed - start},
                                {"seconds_write", session.seconds() - optimised}});
  for (const std::string& note : session.notes())
    session.say("note: " + note);
  session.say("wrote " + options.output + ": a polycube with " + std::to_string(made.certificate.corners) +
              " corners and " + std::to_string(made.certificate.patches) + " faces, genus " +
              std::to_string(made.certificate.genus) + "; " + std::to_string(added) + " vertices were added");
  session.say("  constructed by " + method + ", " + std::to_string(made.valid) + " valid maps in " +
              std::to_string(made.tried) + " attempts");
  session.say("  mean distortion of angles " + std::to_string(made.distortion.angle_mean) + ", of areas " +
              std::to_string(made.distortion.area_mean) + " (1: none)");
  if (!options.surface.empty()) session.say("wrote " + options.surface);
}

}  // namespace

void add_polycube(CLI::App& app, CommonOptions& common) {
  CLI::App* verb = app.add_subcommand("polycube", "make a polycube of a closed surface, and a map to it");
  const auto options = std::make_shared<PolycubeOptions>();
  verb->add_option("IN", options->input, std::string("closed surface: ") + surface_endings)->required()->type_name("");
  verb->add_option("-o,--output", options->output, "the surface's triangles on the polycube: .obj .off .ply .mesh .vtk")
      ->required()
      ->type_name("OUT");
  verb->add_option("--surface", options->surface, "the surface with the same vertices and triangles as OUT")
      ->type_name("OUT2");
  verb->add_option("--construct", options->construct, "how the polycube is found: auto, labels or voxels (auto)")
      ->check(unnamed(CLI::IsMember({"auto", "labels", "voxels"})))
      ->type_name("METHOD");
  verb->add_option("--corners", options->corners, "corners of the polycube at most; 0: any number (0)")
      ->check(unnamed(CLI::Range(0, 1'000'000)))
      ->type_name("N");
  verb->add_option("--optimise", options->optimise, "what is made better: domain, the proportions of the polycube")
      ->check(unnamed(CLI::IsMember({"domain"})))
      ->type_name("WHAT");
  verb->add_option("--measure", options->measure, "of the distortion there: surface, faces or harmonic (surface)")
      ->check(unnamed(CLI::IsMember({"surface", "faces", "harmonic"})))
      ->type_name("MEAN");
  verb->add_option("--area-weight", options->area_weight, "of areas beside angles there (1)")
      ->check(unnamed(CLI::NonNegativeNumber))
      ->type_name("W");
  verb->add_flag("--text", options->text, "text rather than binary PLY and VTK");
  verb->add_flag("--weld", options->weld, "join vertices at identical positions if the surface is not closed");
  add_common_options(*verb, common);
  verb->footer(
      "Every map that is written is certified by exact arithmetic; when none is found the exit code is 1. The "
      "surface's "
      "vertices come first in OUT, in their order; edges are split where that is needed.");
  verb->callback([options, &common] {
    Session session(common, "polycube", options->input);
    session.run([&] { polycube(*options, session); });
  });
}

}  // namespace orbicube::cli
