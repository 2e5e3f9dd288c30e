// The verbs of the command. Each adds itself to the command line, and works when it is called there.
#pragma once

#include <CLI/CLI.hpp>

#include "session/session.h"

namespace orbicube::cli {

void add_info(CLI::App& app, CommonOptions& common);
void add_convert(CLI::App& app, CommonOptions& common);
void add_repair(CLI::App& app, CommonOptions& common);
void add_surface(CLI::App& app, CommonOptions& common);
void add_make(CLI::App& app, CommonOptions& common);
void add_sphere(CLI::App& app, CommonOptions& common);
void add_frames(CLI::App& app, CommonOptions& common);
void add_morph(CLI::App& app, CommonOptions& common);
void add_map(CLI::App& app, CommonOptions& common);
void add_harmonics(CLI::App& app, CommonOptions& common);
void add_compare(CLI::App& app, CommonOptions& common);
void add_page(CLI::App& app, CommonOptions& common);
void add_study(CLI::App& app, CommonOptions& common);
void add_view(CLI::App& app, CommonOptions& common);
void add_doctor(CLI::App& app, CommonOptions& common);
void add_tetrahedralize(CLI::App& app, CommonOptions& common);  // in builds with TetGen
void add_polycube(CLI::App& app, CommonOptions& common);        // in builds with the library
void add_hex(CLI::App& app, CommonOptions& common);             // in builds with the library volume_map
void add_parameterize(CLI::App& app, CommonOptions& common);
void add_untangle(CLI::App& app, CommonOptions& common);
void add_volume(CLI::App& app, CommonOptions& common);

}  // namespace orbicube::cli
