// Options that a command line gives and that what it requests would ignore.
#pragma once

#include <CLI/CLI.hpp>

namespace orbicube::cli {

// Each throws Failure "usage" with the option and what it is for.
void refuse_unused_sphere_options(const CLI::App& verb);
void refuse_unused_repair_options(const CLI::App& verb);
void refuse_unused_surface_options(const CLI::App& verb);
void refuse_unused_frames_options(const CLI::App& verb);
void refuse_unused_polycube_options(const CLI::App& verb);
void refuse_unused_harmonics_options(const CLI::App& verb);
void refuse_unused_morph_options(const CLI::App& verb);
void refuse_unused_hex_options(const CLI::App& verb);
void refuse_unused_tetrahedralize_options(const CLI::App& verb);
void refuse_unused_map_options(const CLI::App& verb);
void refuse_unused_study_options(const CLI::App& verb);
void refuse_unused_view_options(const CLI::App& verb);

}  // namespace orbicube::cli
