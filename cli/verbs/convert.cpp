// orbicube convert: a mesh in another format.
#include <memory>

#include "base/counted.h"
#include "files/surface_file.h"
#include "verbs/verbs.h"

namespace orbicube::cli {
namespace {

struct ConvertOptions {
  std::string input;
  std::string output;
  bool text = false;
  bool weld = false;
};

void convert(const ConvertOptions& options, Session& session) {
  require_writable(options.output);
  session.options() = {{"output", options.output}, {"text", options.text}, {"weld", options.weld}};
  const InputMesh input = session.portion(
      0.5, [&] { return read_input(options.input, options.weld, session, keep_for(options.output, Keep::file)); });
  const mesh::Mesh& mesh = input.mesh;
  const double start = session.seconds();
  if (input.kept) {
    write_output(options.output, *input.kept, session);
  } else {
    write_output(options.output, mesh, !options.text, session);
  }
  session.figures() = {{"output", options.output},
                       {"format", input.report.format},
                       {"vertices", mesh.positions.size()},
                       {"triangles", mesh.triangles.size()},
                       {"tetrahedra", mesh.tetrahedra.size()},
                       {"hexahedra", mesh.hexahedra.size()},
                       {"seconds_read", input.seconds},
                       {"seconds_write", session.seconds() - start}};
  for (const std::string& note : session.notes())
    session.say("note: " + note);
  session.say(
      "wrote " + options.output + ": " + base::counted(mesh.positions.size(), "vertex", "vertices") + ", " +
      base::counted(mesh.triangles.size(), "triangle") +
      (mesh.tetrahedra.empty() ? "" : ", " + base::counted(mesh.tetrahedra.size(), "tetrahedron", "tetrahedra")) +
      (mesh.hexahedra.empty() ? "" : ", " + base::counted(mesh.hexahedra.size(), "hexahedron", "hexahedra")));
}

}  // namespace

void add_convert(CLI::App& app, CommonOptions& common) {
  CLI::App* verb = app.add_subcommand("convert", "convert a mesh to another format");
  const auto options = std::make_shared<ConvertOptions>();
  verb->add_option("IN", options->input, std::string("mesh to read: ") + surface_endings)->required()->type_name("");
  verb->add_option("OUT", options->output, "mesh to write, in the format of its ending")->required()->type_name("");
  add_text_option(*verb, options->text);
  add_weld_option(*verb, options->weld);
  add_common_options(*verb, common);
  verb->footer(
      "Text, and binary PLY and VTK, preserve doubles exactly; binary STL, FreeSurfer, GIFTI and glTF have float32.\n"
      "A glTF file in JSON has an embedded buffer.\n"
      "From glTF to glTF all contents are preserved: nodes, materials, textures, skins, animations, extras.");
  verb->callback([options, &common] {
    Session session(common, "convert", options->input);
    session.run([&] { convert(*options, session); });
  });
}

}  // namespace orbicube::cli
