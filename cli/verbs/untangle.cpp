// orbicube untangle: inverted tetrahedra of a mesh untangled.
#include "untangle/tetrahedra/untangle_tetrahedra.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/counted.h"
#include "base/files/file.h"
#include "files/surface_file.h"
#include "mesh/files/write.h"
#include "mesh/topology/cells.h"
#include "mesh/topology/conforming_tetrahedra.h"
#include "report/embedding.h"
#include "report/solver_choice.h"
#include "report/text.h"
#include "verbs/verbs.h"

namespace orbicube::cli {
namespace {

struct UntangleVerb {
  std::string input;
  std::string output;
  std::string rest;
  std::string solver = "own";
  untangle::UntangleOptions options;
  bool free_boundary = false;
  bool keep_partial = false;
  bool text = false;
};

// Without checks: read_mesh refuses inverted tetrahedra.
mesh::Mesh read_tangled(const std::string& path, const base::Host& host, mesh::ReadReport& report) {
  const auto format = mesh::format_of_path(path);
  if (!format || !mesh::holds(*format, mesh::Holds::cells))
    throw base::Error("unsupported-format", "tetrahedra are read from " + cell_endings);
  const base::Array<std::byte> bytes = base::read_file(path, host);
  if (bytes.empty()) throw base::Error("empty-file", "the file has no bytes");
  return mesh::row_of(*format).read(bytes, host, report);
}

mesh::Mesh read_tetrahedra(const std::string& path, Session& session) {
  return about(path, Role::input, [&] {
    mesh::ReadReport report;
    mesh::Mesh tangled = read_tangled(path, session.host(), report);
    for (const std::string& note : report.notes)
      session.note(note);
    if (tangled.tetrahedra.empty()) throw base::Error("no-cells", "no tetrahedra");
    if (!tangled.hexahedra.empty()) throw base::Error("unsupported", "hexahedra beside the tetrahedra");
    return tangled;
  });
}

// Writes beside the place, reads again and compares, so that the file holds the certified mesh.
void write_untangled(const std::string& path, const mesh::Mesh& solid, bool text, Session& session) {
  const base::Host& host = session.host();
  about(path, Role::output, [&] {
    const std::filesystem::path file = session.stage(path);
    mesh::write_mesh(file, solid, {.binary = !text}, host);
    mesh::ReadReport report;
    const mesh::Mesh again = read_tangled(file.string(), host, report);
    if (again.positions != solid.positions || again.tetrahedra != solid.tetrahedra)
      throw base::Error("no-valid-result", "verification failed: the written file reads back differently");
  });
}

void turn_all(mesh::Mesh& solid, Session& session) {
  std::vector<std::string> notes;
  mesh::note_turned_cells(solid, notes, session.host());
  for (const std::string& note : notes)
    session.note(note);
}

Json json_of(const UntangleVerb& verb) {
  return {{"output", verb.output},
          {"rest", verb.rest},
          {"free_boundary", verb.free_boundary},
          {"steps", verb.options.steps},
          {"polish", verb.options.polish_steps},
          {"volume_weight", verb.options.volume_weight},
          {"solver", verb.solver},
          {"keep_partial", verb.keep_partial},
          {"text", verb.text}};
}

// The same tetrahedra in the shapes to have, all of them positive.
mesh::Mesh read_rest(const UntangleVerb& verb, const mesh::Mesh& solid, Session& session) {
  mesh::Mesh rest = read_tetrahedra(verb.rest, session);
  about(verb.rest, Role::input, [&] {
    if (rest.tetrahedra != solid.tetrahedra || rest.positions.size() != solid.positions.size())
      throw base::Error("unsupported", "not the same vertices and tetrahedra as " + verb.input);
    const auto found = untangle::count_inverted(rest.tetrahedra, rest.positions, session.host());
    if (found.count > 0) {
      throw base::Error("inverted-cell", base::counted(found.count, "tetrahedron is", "tetrahedra are") +
                                             " not positive, the first is " + std::to_string(found.first));
    }
  });
  return rest;
}

untangle::Untangled untangle(const UntangleVerb& verb, const mesh::Mesh& solid, const mesh::Mesh& rest,
                             untangle::BlockEngine* engine, Session& session) {
  return about(verb.input, Role::input, [&] {
    const base::Stage stage(session.host(), 0.95);
    base::Array<std::uint8_t> fixed(session.host().memory);
    if (!verb.free_boundary) {
      const auto boundary = mesh::boundary_vertices(solid.tetrahedra, solid.positions.size(), session.host());
      for (const std::uint8_t on_boundary : boundary)
        fixed.insert(fixed.end(), 3, on_boundary);
    }
    untangle::UntangleOptions with_engine = verb.options;
    with_engine.engine = engine;
    return untangle::untangle_tetrahedra(
        {.tetrahedra = solid.tetrahedra, .start = solid.positions, .rest = rest.positions, .fixed = fixed}, with_engine,
        session.host());
  });
}

Json figures_of(const UntangleVerb& verb, const mesh::Mesh& solid, const untangle::Untangled& result) {
  return {{"output", verb.output},
          {"vertices", solid.positions.size()},
          {"tetrahedra", solid.tetrahedra.size()},
          {"inverted_before", result.inverted_before},
          {"inverted", result.inverted},
          {"steps", result.steps},
          {"polish_steps", result.polish_steps},
          {"min_determinant", result.min_determinant},
          {"max_determinant", result.max_determinant},
          {"energy", result.energy}};
}

// Throws unless all tetrahedra are positive; notes where the boundary intersects itself.
void check_untangled(const UntangleVerb& verb, const mesh::Mesh& solid, const untangle::Untangled& result,
                     Session& session) {
  about(verb.output, Role::output,
        [&] { untangle::require_untangled(result, solid.tetrahedra.size(), "tetrahedron stays", "tetrahedra stay"); });
  about(verb.output, Role::output, [&] {
    report_intersections(verb.output, solid.positions, mesh::boundary_triangles(solid, session.host()),
                         verb.free_boundary ? "without --free-boundary the boundary stays as it is"
                                            : "the boundary is that of " + verb.input + ", which intersects itself",
                         session.figures(), session);
  });
}

void run_untangle(const UntangleVerb& verb, Session& session) {
  const std::unique_ptr<untangle::BlockEngine> engine = start_solver(verb.solver);
  require_cells_writable(verb.output);
  session.options() = json_of(verb);
  mesh::Mesh solid = session.portion(0.03, [&] { return read_tetrahedra(verb.input, session); });
  mesh::Mesh rest(session.host().memory);
  // Without shapes to have, tetrahedra that are all inverted are those of another order of vertices.
  if (verb.rest.empty())
    about(verb.input, Role::input, [&] { turn_all(solid, session); });
  else
    rest = read_rest(verb, solid, session);
  const double start = session.seconds();
  const untangle::Untangled result = untangle(verb, solid, rest, engine.get(), session);
  session.figures().update(figures_of(verb, solid, result));
  session.figures()["seconds_compute"] = session.seconds() - start;
  if (result.inverted == 0 || verb.keep_partial) {
    solid.positions = result.positions;
    write_untangled(verb.output, solid, verb.text, session);
    if (result.inverted > 0) session.keep();
  }
  check_untangled(verb, solid, result, session);
  session.say("wrote " + verb.output + ": " + base::counted(solid.tetrahedra.size(), "tetrahedron", "tetrahedra") +
              ", all positive; " + std::to_string(result.inverted_before) + " were not");
  session.say("  determinants from " + number(result.min_determinant) + " to " + number(result.max_determinant) +
              ", after " + std::to_string(result.steps) + " + " + base::counted(result.polish_steps, "step"));
  for (const std::string& note : session.notes())
    session.say("  note: " + note);
}

}  // namespace

void add_untangle(CLI::App& app, CommonOptions& common) {
  CLI::App* verb = app.add_subcommand("untangle", "untangle a tetrahedral mesh");
  const auto options = std::make_shared<UntangleVerb>();
  verb->add_option("TETS", options->input, "tetrahedra to read: " + cell_endings)->required()->type_name("");
  verb->add_option("-o,--output", options->output, "mesh to write: " + cell_endings)->required()->type_name("OUT");
  verb->add_option("--rest", options->rest,
                   "mesh of the same tetrahedra with the target shapes; default: regular tetrahedra")
      ->type_name("REST");
  verb->add_flag("--free-boundary", options->free_boundary, "let boundary vertices move; default: they are fixed");
  verb->add_option("--steps", options->options.steps,
                   "maximum number of steps until all tetrahedra are positive [default: 500]")
      ->check(unnamed(CLI::Range(0, 1'000'000)))
      ->type_name("N");
  verb->add_option("--polish", options->options.polish_steps,
                   "maximum number of further steps that lower the distortion [default: 20]")
      ->check(unnamed(CLI::Range(0, 1'000'000)))
      ->type_name("N");
  verb->add_option("--volume-weight", options->options.volume_weight,
                   "weight of volume relative to angle distortion [default: 1]")
      ->check(unnamed(CLI::PositiveNumber))
      ->type_name("W");
  add_solver_option(*verb, options->solver);
  verb->add_flag("--keep-partial", options->keep_partial, "write OUT also if tetrahedra remain inverted (exit code 1)");
  verb->add_flag("--text", options->text, "write text in place of binary VTK");
  add_common_options(*verb, common);
  verb->callback([options, &common] {
    Session session(common, "untangle", options->input);
    session.run([&] { run_untangle(*options, session); });
  });
}

}  // namespace orbicube::cli
