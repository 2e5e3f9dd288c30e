// The orbicube command: reads the command line and hands over to the verb.
#include <CLI/CLI.hpp>
#include <iostream>
#include <string>

#include "base/version.h"
#include "failure.h"
#include "interrupt.h"
#include "verbs.h"

namespace {

using orbicube::cli::Exit;

// What is wrong with the command line.
std::string mistake(const CLI::ParseError& error, const CLI::App& app, int argc, char** argv) {
  if (!app.get_subcommands().empty()) return error.what();
  for (int i = 1; i < argc; ++i) {
    if (argv[i][0] != '-') return "there is no verb '" + std::string(argv[i]) + "'";
    if (std::string(argv[i]).find('=') == std::string::npos) break;  // what follows may be the value of an option
  }
  return error.get_name() == "RequiredError" ? "a verb is missing" : error.what();
}

// The verb whose options were wrong, for the hint.
std::string verb_of(const CLI::App& app) {
  for (const CLI::App* verb : app.get_subcommands())
    return " " + verb->get_name();
  return "";
}

int run(int argc, char** argv) {
  CLI::App app("Turns 3D shapes into regular ones: maps closed surfaces to the unit sphere, one to one.", "orbicube");
  app.set_version_flag("--version", std::string("orbicube ") + orbicube::base::version_text);
  app.require_subcommand(1);
  app.footer(
      "Exit code: 0 done and valid, 1 no valid result, 2 the input or the command line is wrong.\n"
      "'orbicube VERB --help' tells more about a verb. For example:\n"
      "  orbicube make creature -o creature.obj --resolution 50000\n"
      "  orbicube sphere creature.obj -o creature.glb --report creature.json");
  orbicube::cli::CommonOptions common;
  orbicube::cli::add_common_options(app, common);
  orbicube::cli::add_info(app, common);
  orbicube::cli::add_convert(app, common);
  orbicube::cli::add_make(app, common);
  orbicube::cli::add_sphere(app, common);
  orbicube::cli::add_frames(app, common);
  orbicube::cli::add_morph(app, common);
  orbicube::cli::add_harmonics(app, common);
  orbicube::cli::add_compare(app, common);
  orbicube::cli::add_page(app, common);
#ifdef ORBICUBE_WITH_POLYCUBE
  orbicube::cli::add_polycube(app, common);
#endif
#ifdef ORBICUBE_WITH_TETRAHEDRA
  orbicube::cli::add_tetrahedralize(app, common);
#endif
#ifdef ORBICUBE_WITH_VOLUME_MAP
  orbicube::cli::add_hex(app, common);
  orbicube::cli::add_untangle(app, common);
  orbicube::cli::add_volume(app, common);
#endif
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
