// orbicube convert: a mesh in another format.
#include <memory>

#include "surface_file.h"
#include "verbs.h"

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
  const InputMesh input = read_input(options.input, options.weld, session);
  const mesh::Mesh& mesh = input.mesh;
  const double start = session.seconds();
  write_output(options.output, mesh, !options.text, session.host());
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
  session.say("wrote " + options.output + ": " + std::to_string(mesh.positions.size()) + " vertices, " +
              std::to_string(mesh.triangles.size()) + " triangles" +
              (mesh.tetrahedra.empty() ? "" : ", " + std::to_string(mesh.tetrahedra.size()) + " tetrahedra") +
              (mesh.hexahedra.empty() ? "" : ", " + std::to_string(mesh.hexahedra.size()) + " hexahedra"));
}

}  // namespace

void add_convert(CLI::App& app, CommonOptions& common) {
  CLI::App* verb = app.add_subcommand("convert", "write a mesh in another format");
  const auto options = std::make_shared<ConvertOptions>();
  verb->add_option("IN", options->input, std::string("mesh to read: ") + surface_endings)->required()->type_name("");
  verb->add_option("OUT", options->output, "mesh to write, in the format of its ending")->required()->type_name("");
  verb->add_flag("--text", options->text, "text rather than binary, where the format has both (PLY, STL, VTK)");
  verb->add_flag("--weld", options->weld, "join vertices at identical positions if the surface is not closed");
  add_common_options(*verb, common);
  verb->footer(
      "Text and binary PLY and VTK hold doubles to the last bit; STL and glTF hold float32. A .gltf has its buffer "
      "inside.");
  verb->callback([options, &common] {
    Session session(common, "convert", options->input);
    session.run([&] { convert(*options, session); });
  });
}

}  // namespace orbicube::cli
