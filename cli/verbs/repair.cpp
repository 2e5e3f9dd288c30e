// orbicube repair: any surface to a closed, oriented, manifold one.
#include "repair/repair.h"

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/counted.h"
#include "files/surface_file.h"
#include "report/text.h"
#include "session/unused_options.h"
#include "solids/repaired_surface.h"
#include "verbs/verbs.h"

namespace orbicube::cli {
namespace {

struct RepairVerb {
  std::string input;
  std::string output;
  repair::Options options;
  std::vector<std::string> skipped;
  bool largest = false;  // as without the option
  bool keep_partial = false;
  bool text = false;
};

// The steps by their names.
std::map<std::string, bool*> steps_of(repair::Options& o) {
  return {{"weld", &o.weld},     {"clean", &o.clean},       {"slivers", &o.slivers},  {"t-junctions", &o.t_junctions},
          {"orient", &o.orient}, {"contacts", &o.contacts}, {"parts", &o.drop_parts}, {"holes", &o.fill_holes}};
}

const std::vector<std::string> step_names = {"weld",   "clean",    "slivers", "t-junctions",
                                             "orient", "contacts", "parts",   "holes"};

Json json_of(const RepairVerb& verb) {
  const repair::Options& o = verb.options;
  return {{"output", verb.output},
          {"skip", verb.skipped},
          {"weld_distance", o.weld_distance},
          {"sliver_ratio", o.sliver_ratio},
          {"max_move", o.sliver_move},
          {"t_junction_distance", o.t_junction_distance},
          {"gap", o.contact_gap},
          {"keep", o.parts.keep},
          {"min_part", o.parts.min_area_percent},
          {"cavities", o.parts.cavities},
          {"wrap", o.wrap_offset},
          {"genus", o.handles.max_genus},
          {"max_handle", o.handles.max_length},
          {"fill_holes", o.holes.max_edges},
          {"flat_patches", !o.holes.fair},
          {"keep_partial", verb.keep_partial},
          {"text", verb.text}};
}

// What the requested steps should have reached, but did not.
std::string missing(const repair::Options& o, const repair::Certificate& c) {
  const bool reached = (c.closed || !o.fill_holes || o.holes.max_edges > 0) &&
                       (c.manifold || !o.contacts || !o.clean) && (c.oriented || !o.orient);
  if (!reached) return repair::shortcomings(c);
  const bool too_many =
      c.is_solid() && o.handles.max_genus >= 0 && !(o.handles.max_length > 0) && c.genus > o.handles.max_genus;
  return too_many ? "genus " + std::to_string(c.genus) : "";
}

void say_result(const RepairVerb& verb, const repair::Repaired& repaired, Session& session) {
  const repair::Report& r = repaired.report;
  const repair::Certificate& c = r.certificate;
  for (const std::string& note : session.notes())
    session.say("note: " + note);
  for (const std::string& line : lines_of(r))
    session.say("  " + line);
  session.say("wrote " + verb.output + ": " + base::counted(repaired.surface.positions.size(), "vertex", "vertices") +
              ", " + base::counted(repaired.surface.triangles.size(), "triangle") +
              (r.changed ? "" : ", as they were"));
  session.say(std::string("  ") + (c.closed ? "closed" : "open") + ", " + (c.manifold ? "manifold" : "not manifold") +
              ", " + (c.oriented ? "oriented" : "not oriented") + ", " + base::counted(c.parts, "part") +
              (c.is_solid() ? ", genus " + std::to_string(c.genus) : "") + ", " +
              (c.self_intersections == 0 ? "no self-intersection"
                                         : base::counted(c.self_intersections, "pair of triangles intersects",
                                                         "pairs of triangles intersect") +
                                               "; --wrap DISTANCE makes a surface around it without"));
  if (r.changed) {
    session.say("  distance of changed triangles " + number(std::max(r.move.from_input, r.move.from_result)) +
                (r.holes.filled > 0 ? ", of patches " + number(r.move.patches) : ""));
  }
}

void run_repair(RepairVerb& verb, Session& session) {
  require_writable(verb.output);
  for (const std::string& step : verb.skipped)
    *steps_of(verb.options).at(step) = false;
  session.options() = json_of(verb);
  const InputMesh input = session.portion(0.1, [&] { return read_input(verb.input, false, session); });
  repair::Repaired repaired = about(verb.input, Role::input, [&] {
    if (!input.mesh.tetrahedra.empty() || !input.mesh.hexahedra.empty())
      throw base::Error("unsupported", "a solid of cells; repair takes surfaces");
    return session.portion(
        0.9, [&] { return repair::repair(input.mesh.positions, input.mesh.triangles, verb.options, session.host()); });
  });
  session.figures() = figures_of_repair(repaired);
  session.figures()["output"] = verb.output;
  session.figures()["format"] = input.report.format;
  session.figures()["vertices"] = repaired.surface.positions.size();
  session.figures()["triangles"] = repaired.surface.triangles.size();
  const std::string lacks = missing(verb.options, repaired.report.certificate);
  if (lacks.empty() || verb.keep_partial) {
    mesh::Mesh result(session.host().memory);
    result.regions.triangles = repaired_regions(input.mesh, repaired.surface, session.host());
    result.positions = std::move(repaired.surface.positions);
    result.triangles = std::move(repaired.surface.triangles);
    write_output(verb.output, result, !verb.text, session);
    repaired.surface.positions = std::move(result.positions);
    repaired.surface.triangles = std::move(result.triangles);
    say_result(verb, repaired, session);
    if (!lacks.empty()) session.keep();
  }
  if (!lacks.empty()) {
    about(verb.output, Role::output,
          [&] { throw base::Error("no-valid-result", "no closed, oriented manifold was reached: " + lacks); });
  }
}

void add_part_options(CLI::App& verb, repair::Options& options, bool& largest_only) {
  auto* largest = verb.add_flag("--largest", largest_only, "keep the largest part by area; this is the default");
  auto* keep = verb.add_option("--keep", options.parts.keep, "keep the N largest parts; 0: all [default: 1]")
                   ->check(unnamed(CLI::Range(0, 1'000'000'000)))
                   ->type_name("N");
  auto* min_part =
      verb.add_option(
              "--min-part", options.parts.min_area_percent,
              "keep all parts with at least this area, in percent of that of all; with --keep the N largest of them")
          ->check(number_from_to(0, 100))
          ->type_name("PERCENT");
  largest->excludes(keep)->excludes(min_part);
  verb.add_flag("--cavities", options.parts.cavities, "keep parts inside others as walls of cavities");
}

}  // namespace

void add_repair(CLI::App& app, CommonOptions& common) {
  CLI::App* verb = app.add_subcommand("repair", "repair a surface: closed, oriented and manifold");
  const auto options = std::make_shared<RepairVerb>();
  repair::Options& o = options->options;
  verb->add_option("IN", options->input, std::string("surface to read: ") + surface_endings)->required()->type_name("");
  verb->add_option("-o,--output", options->output, std::string("surface to write: ") + surface_endings)
      ->required()
      ->type_name("OUT");
  const auto length = [&](const char* name, double& value, const char* help) {
    verb->add_option(name, value, help)->check(non_negative_number())->type_name("DISTANCE");
  };
  length("--weld", o.weld_distance,
         "weld vertices of open edges within this distance [default: at the same position, then 1e-6 of the diagonal]");
  verb->get_option("--weld")->expected(0, 1)->default_str("0")->option_text("[DISTANCE]");
  verb->add_option("--slivers", o.sliver_ratio,
                   "height over longest side of near-degenerate triangles, below 0.5 [default: 1e-6]")
      ->check(number_from_to(0, 0.4999))
      ->type_name("RATIO");
  length("--max-move", o.sliver_move,
         "maximum movement of the surface where these are removed [default: 1e-5 of the diagonal]");
  length("--t-junctions", o.t_junction_distance,
         "split open edges at vertices within this distance [default: 1e-6 of the diagonal]");
  length("--gap", o.contact_gap, "move vertices where sheets touch apart by this distance [default: 0]");
  add_part_options(*verb, o, options->largest);
  verb->add_option("--fill-holes", o.holes.max_edges, "fill holes of at most this number of edges [default: all]")
      ->expected(0, 1)
      ->default_str("0")
      ->check(unnamed(CLI::Range(0, 1'000'000'000)))
      ->option_text("[EDGES]");
  verb->add_flag_callback(
      "--flat-patches", [&o] { o.holes.fair = false; },
      "insert no vertices inside patches of holes; default: patches continue the surface around them smoothly");
  length("--wrap", o.wrap_offset,
         "replace all parts by a surface around them at this distance, which does not intersect itself");
  verb->add_option("--genus", o.handles.max_genus, "cut handles and tunnels, shortest loops first, down to this genus")
      ->check(unnamed(CLI::Range(0, 1'000'000)))
      ->type_name("N");
  verb->add_option("--max-handle", o.handles.max_length, "cut handles and tunnels with loops of at most this length")
      ->check(positive_number())
      ->type_name("LENGTH");
  verb->add_option("--skip", options->skipped,
                   "leave steps out: weld clean slivers t-junctions orient contacts parts holes")
      ->check(unnamed(CLI::IsMember(step_names)))
      ->type_name("STEP...");
  verb->add_flag("--keep-partial", options->keep_partial,
                 "write OUT also if no closed, oriented manifold was reached (exit code 1)");
  add_text_option(*verb, options->text);
  add_common_options(*verb, common);
  verb->footer(
      "Steps, in this order: weld, clean (degenerate and repeated faces, unused vertices), slivers, t-junctions, "
      "orient,\n"
      "contacts (edges of more than two faces), parts, holes; on request wrap and handles. Each changes nothing where "
      "nothing is wrong.");
  verb->callback([options, &common, verb] {
    refuse_unused_repair_options(*verb);
    if (verb->count("--min-part") > 0 && verb->count("--keep") == 0) options->options.parts.keep = 0;
    Session session(common, "repair", options->input);
    session.run([&] { run_repair(*options, session); });
  });
}

}  // namespace orbicube::cli
