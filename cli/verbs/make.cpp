// orbicube make: a shape made by the project itself.
#include "mesh/shapes/make_shape.h"

#include <memory>

#include "base/counted.h"
#include "files/surface_file.h"
#include "verbs/verbs.h"

namespace orbicube::cli {
namespace {

struct MakeOptions {
  std::string shape;
  std::string output;
  std::size_t resolution = mesh::ShapeOptions{}.triangles;
  bool text = false;
};

void make(const MakeOptions& options, Session& session) {
  require_writable(options.output);
  session.options() = {{"output", options.output}, {"resolution", options.resolution}, {"text", options.text}};
  const mesh::Mesh shape = session.portion(0.6, [&] {
    return mesh::make_shape(options.shape, {.triangles = options.resolution, .seed = session.seed()}, session.host());
  });
  const double made = session.seconds();
  write_output(options.output, shape, !options.text, session);
  session.figures() = {{"output", options.output},
                       {"vertices", shape.positions.size()},
                       {"triangles", shape.triangles.size()},
                       {"seconds_compute", made},
                       {"seconds_write", session.seconds() - made}};
  session.say("wrote " + options.output + ": " + options.shape + ", " +
              base::counted(shape.positions.size(), "vertex", "vertices") + ", " +
              base::counted(shape.triangles.size(), "triangle"));
}

// One of these; a message of its own names them all.
CLI::Validator shape_name(const std::vector<std::string>& names) {
  return unnamed({[names](const std::string& name) {
                    if (std::find(names.begin(), names.end(), name) != names.end()) return std::string();
                    std::string known;
                    for (const std::string& n : names)
                      known += (known.empty() ? "" : ", ") + n;
                    return "no shape is called '" + name + "'; there are " + known;
                  },
                  CLI::IsMember(names).get_description()});
}

}  // namespace

void add_make(CLI::App& app, CommonOptions& common) {
  CLI::App* verb = app.add_subcommand("make", "generate a test shape");
  const auto options = std::make_shared<MakeOptions>();
  std::string list = "Shapes:\n";
  std::vector<std::string> names;
  for (const mesh::ShapeDescription& shape : mesh::shapes()) {
    names.emplace_back(shape.name);
    list += "  " + names.back() + std::string(14 - names.back().size(), ' ') + shape.text + " (genus " +
            std::to_string(shape.genus) + ")\n";
  }
  list += "All are closed and outward-oriented. --seed varies all but cube and sphere.";
  verb->add_option("SHAPE", options->shape, "shape to generate, one of those below")
      ->required()
      ->type_name("")
      ->check(shape_name(names));
  verb->add_option("-o,--output", options->output, std::string("mesh to write: ") + surface_endings)
      ->required()
      ->type_name("OUT");
  verb->add_option("--resolution", options->resolution, "approximate number of triangles [default: 20000]")
      ->check(unnamed(CLI::Range(1, 100'000'000)))
      ->type_name("N");
  add_text_option(*verb, options->text);
  add_common_options(*verb, common);
  verb->footer(list);
  verb->callback([options, &common] {
    Session session(common, "make", options->shape);
    session.run([&] { make(*options, session); });
  });
}

}  // namespace orbicube::cli
