// The orbicube command: reads the command line and hands over to the verb.
#include <CLI/CLI.hpp>
#include <iostream>
#include <map>
#include <string>

#include "base/version.h"
#include "session/failure.h"
#include "session/interrupt.h"
#ifdef ORBICUBE_WITH_CHOLMOD
#include "linear/direct/cholmod_factor.h"
#endif
#include "manual/description.h"
#include "session/mistakes.h"
#include "verbs/verbs.h"

namespace {

using orbicube::cli::Exit;
using orbicube::cli::mistake;

// The verb whose options were wrong, for the hint.
std::string verb_of(const CLI::App& app) {
  for (const CLI::App* verb : app.get_subcommands())
    return " " + verb->get_name();
  return "";
}

// Each verb's help ends with a line that works, its own.
void add_examples(CLI::App& app) {
  const std::map<std::string, const char*> examples = {
      {"info", "scan.ply"},
      {"convert", "scan.stl scan.ply"},
      {"repair", "scan.ply -o closed.ply"},
      {"surface", "labels.nii.gz --label 4 -o ventricle.ply"},
      {"make", "bracket -o bracket.obj --resolution 50000"},
      {"sphere", "creature.obj -o creature.glb --page creature.html"},
      {"frames", "part.mesh -o part.frames --glb part.glb"},
      {"morph", "a.obj b.obj -o ab.glb --placement turned"},
      {"harmonics", "creature.obj --sphere map.obj --degree 32 -o creature.coef"},
      {"compare", "a.coef b.coef c.coef -o distances.txt --png distances.png"},
      {"parameterize", "part.mesh -o part.vtk --integer"},
      {"view", "bracket.mesh -o bracket.html"},
      {"doctor", "--json"},
      {"page", "creature.obj map.obj -o creature.html"},
      {"polycube", "bracket.obj -o polycube.obj --surface surface.obj"},
      {"tetrahedralize", "bracket.obj -o bracket.mesh --edge-length 0.1"},
      {"hex", "bracket.obj -o bracket.mesh --cells 5000"},
      {"untangle", "inverted.mesh -o valid.mesh"},
      {"volume", "bracket.obj -o polycube.mesh --source solid.mesh"}};
  for (CLI::App* verb : app.get_subcommands([](CLI::App*) { return true; })) {
    const std::string own = "orbicube " + verb->get_name() + " ", before = verb->get_footer();
    const auto example = examples.find(verb->get_name());
    if (example == examples.end() || before.find(own) != std::string::npos) continue;
    verb->footer(before + (before.empty() ? "" : "\n") + "For example:\n  " + own + example->second);
  }
}

void add_verbs(CLI::App& app, orbicube::cli::CommonOptions& common) {
  orbicube::cli::add_info(app, common);
  orbicube::cli::add_convert(app, common);
  orbicube::cli::add_repair(app, common);
  orbicube::cli::add_surface(app, common);
  orbicube::cli::add_make(app, common);
  orbicube::cli::add_sphere(app, common);
  orbicube::cli::add_frames(app, common);
  orbicube::cli::add_morph(app, common);
  orbicube::cli::add_map(app, common);
  orbicube::cli::add_harmonics(app, common);
  orbicube::cli::add_compare(app, common);
  orbicube::cli::add_page(app, common);
  orbicube::cli::add_study(app, common);
  orbicube::cli::add_view(app, common);
#ifdef ORBICUBE_WITH_POLYCUBE
  orbicube::cli::add_polycube(app, common);
#endif
#ifdef ORBICUBE_WITH_TETRAHEDRA
  orbicube::cli::add_tetrahedralize(app, common);
#endif
#ifdef ORBICUBE_WITH_HEXMESH
  orbicube::cli::add_hex(app, common);
#endif
#ifdef ORBICUBE_WITH_VOLUME_MAP
  orbicube::cli::add_parameterize(app, common);
  orbicube::cli::add_untangle(app, common);
  orbicube::cli::add_volume(app, common);
#endif
  orbicube::cli::add_doctor(app, common);
}

int run(int argc, char** argv) {
#ifdef ORBICUBE_WITH_CHOLMOD
  orbicube::linear::provide_cholmod(&orbicube::linear::make_cholmod_factor);
#endif
  CLI::App app(
      "Maps closed surfaces to the unit sphere and to polycubes, and solids to hexahedral meshes, with certificates.",
      "orbicube");
  app.set_version_flag("--version", std::string("orbicube ") + orbicube::base::version_text);
  app.add_flag_callback(
      "--describe", [&app] { throw CLI::CallForVersion(orbicube::cli::description(app), 0); },
      "print all verbs and options as JSON, for other programs");
  app.require_subcommand(1);
  orbicube::cli::CommonOptions common;
  orbicube::cli::add_common_options(app, common);
  add_verbs(app, common);
  add_examples(app);
  app.footer(
      "Exit code: 0 success with a valid result, 1 no valid result, 2 a wrong input or command line.\n"
      "'orbicube VERB --help' describes a verb. For example:\n"
      "  orbicube make creature -o creature.obj --resolution 50000\n"
      "  orbicube sphere creature.obj -o creature.glb --report creature.json");
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {  // help or version
    app.exit(success);
  } catch (const CLI::ParseError& error) {
    throw orbicube::cli::Failure(Exit::wrong_input, "", "usage",
                                 mistake(error, app, argc, argv) + "; see 'orbicube" + verb_of(app) + " --help'");
  }
  std::cout.flush();
  if (!std::cout) throw orbicube::cli::Failure(Exit::no_result, "standard output", "io", "cannot write");
  return static_cast<int>(Exit::done);
}

}  // namespace

int main(int argc, char** argv) {
  orbicube::cli::watch_for_interrupts();
  try {
    return run(argc, argv);
  } catch (const orbicube::cli::Failure& failure) {
    std::cout.flush();
    std::cerr << "orbicube: " << failure.line() << '\n';
    return static_cast<int>(failure.exit_code());
  } catch (const std::bad_alloc&) {
    std::cerr << "orbicube: out-of-memory: there is not enough memory\n";
  } catch (const std::exception& error) {
    std::cerr << "orbicube: internal: " << error.what() << '\n';
  }
  return static_cast<int>(Exit::no_result);
}
