// A solid, given by its surface or by tetrahedra, as the verbs hex and volume take it.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <utility>

#include "base/catch_all.h"
#include "files/given_polycube_file.h"
#include "files/surface_file.h"
#include "mesh/files/write.h"
#include "mesh/mesh.h"
#include "session/session.h"
#include "solids/repaired_surface.h"
#include "volume_map/input/polycube_pieces.h"

namespace orbicube::cli {

struct SolidOptions {
  std::string input;
  std::size_t corners = volume_map::PieceOptions{}.corners;
  std::size_t triangles = volume_map::PieceOptions{}.triangles;
  Mending mending;
  std::string from;  // a polycube's file, or empty
};

void add_solid_options(CLI::App& verb, SolidOptions& options);
Json json_of(const SolidOptions& options);

// A polycube that the solid is given.
struct SolidPolycube {
  explicit SolidPolycube(GivenPolycube&& given) : file(std::move(given)) {}

  GivenPolycube file;
  volume_map::GivenPolycube view() const { return {&file.target, file.pose}; }
};

// Reads the polycube of --from; nothing without that option. Throws Failure.
std::optional<SolidPolycube> read_solid_polycube(const SolidOptions& options, Session& session);

// TetGen's, in builds that have it.
volume_map::FillSurface fill_by_tetgen();

// Findings whose notes go to the session.
volume_map::InputFindings findings_of(Session& session);
// Their figures go to the session.
void report_findings(const volume_map::InputFindings& findings, const std::string& format, Session& session);

// Does `work` on a solid; its figures go to the session also where it fails, which is about the input or, once that is
// examined, about the output.
template <class Work>
auto about_solid(const std::string& input, const std::string& output, const std::string& format,
                 const volume_map::InputFindings& findings, Session& session, const Work& work) -> decltype(work()) {
  using Made = decltype(work());
  const auto rethrow = []() -> Made { throw; };
  const auto failed = [&]() -> Made {
    report_findings(findings, format, session);
    return findings.examined ? about(output, Role::output, rethrow) : about(input, Role::input, rethrow);
  };
  Made made = base::catch_all(work, failed);
  report_findings(findings, format, session);
  return made;
}

// Writes beside the place, reads again and compares, so that the file holds the certified mesh.
void write_cells_exactly(const std::string& path, const mesh::Mesh& cells, const mesh::WriteOptions& options,
                         Session& session);

}  // namespace orbicube::cli
