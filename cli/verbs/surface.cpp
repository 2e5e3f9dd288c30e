// orbicube surface: a label of an image to a closed surface.
#include <memory>
#include <string>
#include <utility>

#include "files/surface_file.h"
#include "images/label_surface.h"
#include "repair/labels/surface_of_labels.h"
#include "report/text.h"
#include "session/unused_options.h"
#include "solids/repaired_surface.h"
#include "verbs/verbs.h"

namespace orbicube::cli {
namespace {

struct SurfaceVerb {
  std::string input;
  std::string output;
  repair::LabelOptions options;
  bool text = false;
};

Json surface_json(const SurfaceVerb& verb) {
  const repair::LabelOptions& o = verb.options;
  return {{"output", verb.output},     {"label", o.label},         {"keep", o.keep},           {"cavities", o.cavities},
          {"keep_handles", o.handles}, {"smoothing", o.smoothing}, {"max_slide", o.max_slide}, {"text", verb.text}};
}

Json label_figures(const LabelFile& file, const repair::LabelReport& r) {
  const ImageHeader& h = file.header;
  return {{"image",
           {{"format", h.format},
            {"size", h.size},
            {"space", h.space.empty() ? Json(nullptr) : Json(h.space)},
            {"to_world", h.to_world}}},
          {"label", r.label},
          {"voxels", r.voxels},
          {"border_voxels", r.border_voxels},
          {"parts", {{"found", r.found_parts}, {"kept", r.kept_parts}, {"dropped_voxels", r.dropped_voxels}}},
          {"cavities", {{"filled", r.cavities}, {"filled_voxels", r.filled_voxels}}},
          {"handles", {{"removed", r.handles}, {"added_voxels", r.added_voxels}, {"removed_voxels", r.removed_voxels}}},
          {"largest_slide", r.largest_slide},
          {"centered_vertices", r.centered_vertices},
          {"certificate", certificate_json(r.certificate)}};
}

std::string count_of_voxels(std::size_t n) {
  return std::to_string(n) + (n == 1 ? " voxel" : " voxels");
}

void say_surface(const SurfaceVerb& verb, const repair::LabelSurface& surface, Session& session) {
  const repair::LabelReport& r = surface.report;
  for (const std::string& note : session.notes())
    session.say("note: " + note);
  session.say("  label " + std::to_string(r.label) + ", " + count_of_voxels(r.voxels));
  if (r.dropped_voxels > 0) {
    session.say("  kept " + std::to_string(r.kept_parts) + " of " + std::to_string(r.found_parts) + " parts; " +
                count_of_voxels(r.dropped_voxels) + " dropped");
  }
  if (r.cavities > 0)
    session.say("  " + std::to_string(r.cavities) + (r.cavities == 1 ? " cavity" : " cavities") + " filled, " +
                count_of_voxels(r.filled_voxels));
  if (r.handles > 0) {
    session.say("  " + std::to_string(r.handles) + (r.handles == 1 ? " handle or tunnel" : " handles and tunnels") +
                " removed: " + count_of_voxels(r.added_voxels) + " added, " + std::to_string(r.removed_voxels) +
                " removed");
  }
  session.say("wrote " + verb.output + ": " + std::to_string(surface.positions.size()) + " vertices, " +
              std::to_string(surface.triangles.size()) + " triangles");
  const repair::Certificate& c = r.certificate;
  session.say("  closed, manifold, oriented, " + std::to_string(c.parts) + (c.parts == 1 ? " part" : " parts") +
              ", genus " + std::to_string(c.genus) + ", no self-intersection, area " + number(c.area) + ", volume " +
              number(c.volume));
}

void run_surface(SurfaceVerb& verb, Session& session) {
  require_writable(verb.output);
  session.options() = surface_json(verb);
  const LabelFile file = about(verb.input, Role::input,
                               [&] { return session.portion(0.2, [&] { return read_labels(verb.input, session); }); });
  repair::LabelSurface surface = about(verb.input, Role::input, [&] {
    return session.portion(0.8, [&] { return extract_label(file, verb.options, session.host()); });
  });
  const repair::LabelReport& r = surface.report;
  if (r.border_voxels > 0)
    session.note("the label reaches the border of the image with " + count_of_voxels(r.border_voxels) +
                 ", where the surface is closed");
  if (file.header.space.empty()) session.note("the image has no orientation: its axes are those of the surface");
  session.figures() = label_figures(file, r);
  session.figures()["output"] = verb.output;
  session.figures()["vertices"] = surface.positions.size();
  session.figures()["triangles"] = surface.triangles.size();
  mesh::Mesh result(session.host().memory);
  result.positions = std::move(surface.positions);
  result.triangles = std::move(surface.triangles);
  write_output(verb.output, result, !verb.text, session);
  surface.positions = std::move(result.positions);
  surface.triangles = std::move(result.triangles);
  say_surface(verb, surface, session);
}

}  // namespace

void add_surface(CLI::App& app, CommonOptions& common) {
  CLI::App* verb = app.add_subcommand("surface", "extract the closed surface of a label of an image");
  const auto options = std::make_shared<SurfaceVerb>();
  repair::LabelOptions& o = options->options;
  verb->add_option("LABELS", options->input, "label image to read: " + label_image_endings)->required()->type_name("");
  verb->add_option("-o,--output", options->output, std::string("surface to write: ") + surface_endings)
      ->required()
      ->type_name("OUT");
  verb->add_option("--label", o.label, "label whose voxels are the object [default: the only one besides 0]")
      ->check(unnamed(CLI::Validator(
          [](std::string& text) { return text == "0" ? "label 0 is the background" : std::string(); }, "")))
      ->type_name("N");
  verb->add_option("--keep", o.keep, "keep the N largest parts, connected through faces of voxels; 0: all [default: 1]")
      ->check(unnamed(CLI::Range(0, 1'000'000'000)))
      ->type_name("N");
  verb->add_flag("--keep-handles", o.handles,
                 "keep handles and tunnels; default: they are removed where they are thinnest");
  verb->add_flag("--cavities", o.cavities, "keep cavities as surfaces inside; default: they are filled");
  verb->add_option("--smoothing", o.smoothing,
                   "standard deviation of the Gaussian that smooths the object, in voxels [default: 1]")
      ->check(number_from_to(0, 10))
      ->type_name("VOXELS");
  verb->add_option("--max-slide", o.max_slide,
                   "maximum distance of vertices from the middle between two voxel centers, in voxels, below 0.5; "
                   "0: all are there [default: 0.45]")
      ->check(number_from_to(0, 0.4999))
      ->type_name("VOXELS");
  add_text_option(*verb, options->text);
  add_common_options(*verb, common);
  verb->footer(
      "Positions are those of the header: NIfTI has its axes to the right, anterior and superior, MetaImage to the "
      "left, "
      "posterior and\nsuperior, NRRD as it says.");
  verb->callback([options, &common, verb] {
    refuse_unused_surface_options(*verb);
    Session session(common, "surface", options->input);
    session.run([&] { run_surface(*options, session); });
  });
}

}  // namespace orbicube::cli
