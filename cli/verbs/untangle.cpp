// orbicube untangle: inverted tetrahedra of a solid, or triangles of a flat mesh, untangled.
#include "untangle/tetrahedra/untangle_tetrahedra.h"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/counted.h"
#include "base/files/file.h"
#include "files/exact_file.h"
#include "files/surface_file.h"
#include "mesh/files/write.h"
#include "mesh/topology/cells.h"
#include "mesh/topology/conforming_tetrahedra.h"
#include "report/embedding.h"
#include "report/solver_choice.h"
#include "report/text.h"
#include "solids/refined_solid.h"
#include "untangle/triangles/untangle_triangles.h"
#include "verbs/verbs.h"

namespace orbicube::cli {
namespace {

struct UntangleVerb {
  std::string input;
  std::string output;
  std::string rest;
  std::string source;
  std::string solver = "own";
  untangle::UntangleOptions options;
  bool free_boundary = false;
  bool refine = false;
  bool keep_partial = false;
  bool text = false;
};

// Without checks: read_mesh refuses inverted tetrahedra.
mesh::Mesh read_tangled(const std::string& path, const base::Host& host, mesh::ReadReport& report) {
  const auto format = mesh::format_of_path(path);
  if (!format)
    throw base::Error("unsupported-format",
                      "flat meshes are read from " + mesh::format_endings() + ", tetrahedra from " + cell_endings);
  const base::Array<std::byte> bytes = base::read_file(path, host);
  if (bytes.empty()) throw base::Error("empty-file", "the file has no bytes");
  return mesh::row_of(*format).read(bytes, host, report);
}

// Tetrahedra, or triangles.
mesh::Mesh read_elements(const std::string& path, Session& session) {
  return about(path, Role::input, [&] {
    mesh::ReadReport report;
    mesh::Mesh tangled = read_tangled(path, session.host(), report);
    for (const std::string& note : report.notes)
      session.note(note);
    if (tangled.tetrahedra.empty() && tangled.triangles.empty())
      throw base::Error("no-cells", "no tetrahedra, and no triangles");
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
          {"refine", verb.refine},
          {"source", verb.source},
          {"max_steps", verb.options.steps},
          {"max_polish_steps", verb.options.polish_steps},
          {"volume_weight", verb.options.volume_weight},
          {"solver", verb.solver},
          {"keep_partial", verb.keep_partial},
          {"text", verb.text}};
}

// The same tetrahedra in the shapes to have, all of them positive, or the same triangles.
mesh::Mesh read_rest(const UntangleVerb& verb, const mesh::Mesh& solid, Session& session) {
  mesh::Mesh rest = read_elements(verb.rest, session);
  about(verb.rest, Role::input, [&] {
    if (solid.tetrahedra.empty()) {
      if (rest.triangles != solid.triangles || rest.positions.size() != solid.positions.size())
        throw base::Error("unsupported", "not the same vertices and triangles as " + verb.input);
      return;
    }
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

// Moves the solid, and splits it and the rest on request.
untangle::UntanglingFigures untangle(const UntangleVerb& verb, mesh::Mesh& solid, mesh::Mesh& rest,
                                     untangle::BlockEngine* engine, Session& session) {
  return about(verb.input, Role::input, [&]() -> untangle::UntanglingFigures {
    const base::Stage stage(session.host(), 0.95);
    base::Array<std::uint8_t> fixed(session.host().memory);
    if (!verb.free_boundary) {
      const auto boundary = mesh::boundary_vertices(solid.tetrahedra, solid.positions.size(), session.host());
      for (const std::uint8_t on_boundary : boundary)
        fixed.insert(fixed.end(), 3, on_boundary);
    }
    untangle::UntangleOptions with_engine = verb.options;
    with_engine.engine = engine;
    const untangle::UntangleProblem problem{
        .tetrahedra = solid.tetrahedra, .start = solid.positions, .rest = rest.positions, .fixed = fixed};
    if (!verb.refine) {
      untangle::Untangled result = untangle::untangle_tetrahedra(problem, with_engine, session.host());
      solid.positions = std::move(result.positions);
      return result;
    }
    untangle::RefinedTetrahedra result = untangle::untangle_refined(problem, with_engine, session.host());
    report_splits(result, solid.positions.size(), session);
    const std::size_t left_out = split_cells(result, solid, session.host());
    if (left_out > 0)
      session.note(base::counted(left_out, "triangle") + " inside of the solid left out: tetrahedra there were split");
    if (!rest.positions.empty()) {
      split_cells(result, rest, session.host());
      rest.positions = split_positions(result, rest.positions);
    }
    solid.positions = std::move(result.positions);
    return result;
  });
}

const char* elements_of(const mesh::Mesh& solid) {
  return solid.tetrahedra.empty() ? "triangles" : "tetrahedra";
}

std::size_t count_of(const mesh::Mesh& solid) {
  return solid.tetrahedra.empty() ? solid.triangles.size() : solid.tetrahedra.size();
}

Json figures_of(const UntangleVerb& verb, const mesh::Mesh& solid, const untangle::UntanglingFigures& result) {
  return {{"output", verb.output},
          {"vertices", solid.positions.size()},
          {elements_of(solid), count_of(solid)},
          {"inverted_before", result.inverted_before},
          {"inverted", result.inverted},
          {"steps", result.steps},
          {"polish_steps", result.polish_steps},
          {"min_determinant", result.min_determinant},
          {"max_determinant", result.max_determinant},
          {"energy", result.energy}};
}

// The plane that the triangles lie in, z = const. Throws where they do not, and turns them all where all are clockwise.
double plane_of(const UntangleVerb& verb, mesh::Mesh& flat, Session& session) {
  return about(verb.input, Role::input, [&] {
    const double z = flat.positions.empty() ? 0 : flat.positions[0].z();
    base::Array<Eigen::Vector2d> positions(session.host().memory);
    for (const mesh::Vector3& p : flat.positions) {
      if (p.z() != z)
        throw base::Error("unsupported", "no tetrahedra, and the triangles are not flat: z is " + number(z) + " and " +
                                             number(p.z()) + "; a flat mesh has one z");
      positions.emplace_back(p.head<2>());
    }
    for (const mesh::Triangle& t : flat.triangles) {
      for (const mesh::Index v : t)
        if (v >= positions.size()) throw base::Error("index-range", "a triangle has a vertex that does not exist");
    }
    base::Array<mesh::Triangle> turned(flat.triangles, session.host().memory);
    for (mesh::Triangle& t : turned)
      std::swap(t[1], t[2]);
    if (untangle::count_inverted(turned, positions, session.host()).count == 0) {
      session.note("all triangles are clockwise and were reversed");
      flat.triangles = std::move(turned);
    }
    return z;
  });
}

// Vertices of the plane of `z`; on it again in the end.
untangle::UntanglingFigures untangle_flat(const UntangleVerb& verb, mesh::Mesh& flat, double z, mesh::Mesh& rest,
                                          Session& session) {
  return about(verb.input, Role::input, [&]() -> untangle::UntanglingFigures {
    const base::Stage stage(session.host(), 0.95);
    const base::Host& host = session.host();
    base::Array<Eigen::Vector2d> start(host.memory);
    for (const mesh::Vector3& p : flat.positions)
      start.emplace_back(p.head<2>());
    base::Array<std::uint8_t> fixed(host.memory);
    if (!verb.free_boundary) {
      for (const std::uint8_t on_boundary : untangle::boundary_vertices(flat.triangles, start.size(), host))
        fixed.insert(fixed.end(), 2, on_boundary);
    }
    const untangle::TriangleProblem problem{
        .triangles = flat.triangles, .start = start, .rest = rest.positions, .fixed = fixed};
    const auto place = [&](std::span<const Eigen::Vector2d> positions) {
      flat.positions.clear();
      for (const Eigen::Vector2d& p : positions)
        flat.positions.emplace_back(p.x(), p.y(), z);
    };
    if (!verb.refine) {
      const untangle::UntangledTriangles result = untangle::untangle_triangles(problem, verb.options, host);
      place(result.positions);
      return result;
    }
    const untangle::RefinedTriangles result = untangle::untangle_refined(problem, verb.options, host);
    report_splits(result, start.size(), session);
    if (!rest.positions.empty()) rest.positions = split_positions(result, rest.positions);
    flat.triangles = rest.triangles = result.elements;
    place(result.positions);
    return result;
  });
}

void say_result(const UntangleVerb& verb, const mesh::Mesh& solid, const untangle::UntanglingFigures& result,
                Session& session) {
  const std::string elements = solid.tetrahedra.empty()
                                   ? base::counted(solid.triangles.size(), "triangle")
                                   : base::counted(solid.tetrahedra.size(), "tetrahedron", "tetrahedra");
  session.say("wrote " + verb.output + ": " + elements + ", all positive; " + std::to_string(result.inverted_before) +
              " were not");
  session.say("  determinants from " + number(result.min_determinant) + " to " + number(result.max_determinant) +
              ", after " + std::to_string(result.steps) + " + " + base::counted(result.polish_steps, "step"));
  for (const std::string& note : session.notes())
    session.say("  note: " + note);
}

void run_flat(const UntangleVerb& verb, mesh::Mesh& flat, Session& session) {
  if (verb.solver != "own")
    throw Failure(Exit::wrong_input, "", "usage", "--solver is for tetrahedra, and " + verb.input + " has triangles");
  require_exact_output(verb.output);
  const double z = plane_of(verb, flat, session);
  mesh::Mesh rest(session.host().memory);
  if (!verb.rest.empty()) rest = read_rest(verb, flat, session);
  if (!verb.source.empty()) require_exact_output(verb.source);
  const double start = session.seconds();
  const untangle::UntanglingFigures result = untangle_flat(verb, flat, z, rest, session);
  session.figures().update(figures_of(verb, flat, result));
  session.figures()["seconds_compute"] = session.seconds() - start;
  if (result.inverted == 0 || verb.keep_partial) {
    write_exactly(verb.output, flat.positions, flat.triangles, verb.text, session);
    if (!verb.source.empty()) write_exactly(verb.source, rest.positions, rest.triangles, verb.text, session);
    if (result.inverted > 0) session.keep();
  }
  about(verb.output, Role::output,
        [&] { untangle::require_untangled(result, count_of(flat), "triangle stays", "triangles stay"); });
  say_result(verb, flat, result, session);
}

// Throws unless all tetrahedra are positive; notes where the boundary intersects itself.
void check_untangled(const UntangleVerb& verb, const mesh::Mesh& solid, const untangle::UntanglingFigures& result,
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
  require_writable(verb.output);
  if (!verb.source.empty()) require_writable(verb.source);
  session.options() = json_of(verb);
  mesh::Mesh solid = session.portion(0.03, [&] { return read_elements(verb.input, session); });
  if (solid.tetrahedra.empty()) {
    run_flat(verb, solid, session);
    return;
  }
  require_cells_writable(verb.output);
  if (!verb.source.empty()) require_cells_writable(verb.source);
  mesh::Mesh rest(session.host().memory);
  // Without shapes to have, tetrahedra that are all inverted are those of another order of vertices.
  if (verb.rest.empty())
    about(verb.input, Role::input, [&] { turn_all(solid, session); });
  else
    rest = read_rest(verb, solid, session);
  const double start = session.seconds();
  const untangle::UntanglingFigures result = untangle(verb, solid, rest, engine.get(), session);
  session.figures().update(figures_of(verb, solid, result));
  session.figures()["seconds_compute"] = session.seconds() - start;
  if (result.inverted == 0 || verb.keep_partial) {
    write_untangled(verb.output, solid, verb.text, session);
    if (!verb.source.empty()) write_untangled(verb.source, rest, verb.text, session);
    if (result.inverted > 0) session.keep();
  }
  check_untangled(verb, solid, result, session);
  say_result(verb, solid, result, session);
}

}  // namespace

void add_untangle(CLI::App& app, CommonOptions& common) {
  CLI::App* verb = app.add_subcommand("untangle", "untangle a tetrahedral or a flat triangular mesh");
  const auto options = std::make_shared<UntangleVerb>();
  verb->add_option("IN", options->input,
                   "mesh to read: tetrahedra (" + cell_endings + "), or triangles in a plane z = const (" +
                       mesh::format_endings() + ")")
      ->required()
      ->type_name("");
  verb->add_option("-o,--output", options->output, "mesh to write, of the same elements unless they are split")
      ->required()
      ->type_name("OUT");
  CLI::Option* const rest = verb->add_option("--rest", options->rest,
                                             "mesh of the same elements with the target shapes, such as a surface "
                                             "whose map to the plane IN is; default: "
                                             "regular tetrahedra or triangles")
                                ->type_name("REST");
  verb->add_flag("--free-boundary", options->free_boundary, "let boundary vertices move; default: they are fixed");
  CLI::Option* const refine = verb->add_flag(
      "--refine", options->refine, "split edges, faces and elements inside where the mesh as it is has no solution");
  verb->add_option("--source", options->source, "mesh to write, of the elements of OUT with the target shapes of REST")
      ->needs(refine)
      ->needs(rest)
      ->type_name("OUT2");
  verb->add_option("--max-steps", options->options.steps,
                   "maximum number of steps until all elements are positive [default: 500]")
      ->check(unnamed(CLI::Range(0, 1'000'000)))
      ->type_name("N");
  verb->add_option("--max-polish-steps", options->options.polish_steps,
                   "maximum number of further steps that lower the distortion [default: 20]")
      ->check(unnamed(CLI::Range(0, 1'000'000)))
      ->type_name("N");
  verb->add_option("--volume-weight", options->options.volume_weight,
                   "weight of volume or area relative to angle distortion [default: 1]")
      ->check(positive_number())
      ->type_name("W");
  add_solver_option(*verb, options->solver);
  verb->add_flag("--keep-partial", options->keep_partial, "write OUT also if elements remain inverted (exit code 1)");
  add_text_option(*verb, options->text);
  add_common_options(*verb, common);
  verb->callback([options, &common] {
    Session session(common, "untangle", options->input);
    session.run([&] { run_untangle(*options, session); });
  });
}

}  // namespace orbicube::cli
