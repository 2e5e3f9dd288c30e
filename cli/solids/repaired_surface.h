// A surface repaired before it is used, and what is said of that.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "files/surface_file.h"
#include "repair/repair.h"
#include "session/session.h"

namespace orbicube::cli {

// What is done to a surface before a verb that needs a closed one.
struct Mending {
  bool weld = false;    // vertices at identical positions, if the surface is not closed
  bool repair = false;  // all steps of orbicube repair, as its defaults are
};

// Adds --weld and --repair.
void add_mending_options(CLI::App& verb, Mending& mending);

// Reads a mesh (read_input) and repairs it if requested; what that did becomes notes and, where something was wrong,
// the entry "repair" of the session's figures. Meshes of cells stay as they are. What a glTF file has besides its
// surface is kept only if nothing was changed. Throws Failure also where no closed, oriented manifold could be reached.
InputMesh read_mended(const std::filesystem::path& path, const Mending& mending, Session& session,
                      Keep keep = Keep::surface, bool tags = false);

// The regions of repaired triangles: those of their sources and, of triangles without one, of the nearest of the input.
base::Array<std::int32_t> repaired_regions(const mesh::Mesh& input, const repair::Soup& surface,
                                           const base::Host& host);

// What the steps did, one sentence each; empty for a clean surface.
std::vector<std::string> lines_of(const repair::Report& report);
// The entry "certificate" of reports.
Json certificate_json(const repair::Certificate& certificate);
// All figures, and places with their actions.
Json figures_of_repair(const repair::Repaired& repaired);

}  // namespace orbicube::cli
