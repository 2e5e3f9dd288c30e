#include "solids/solid_input.h"

#include <filesystem>

#include "mesh/files/file.h"
#include "mesh/files/read.h"
#include "mesh/files/write.h"
#ifdef ORBICUBE_WITH_TETRAHEDRA
#include "tetrahedra/tetrahedra.h"
#endif

namespace orbicube::cli {

void add_solid_options(CLI::App& verb, SolidOptions& options) {
  verb.add_option("IN", options.input, std::string("closed surface, or a tetrahedral mesh: ") + surface_endings)
      ->required()
      ->type_name("");
  CLI::Option* corners =
      verb.add_option("--corners", options.corners,
                      "maximum number of polycube corners per boundary component; 0: no limit [default: 100]")
          ->check(unnamed(CLI::Range(0, 1'000'000)))
          ->type_name("N");
  CLI::Option* triangles = verb.add_option("--triangles", options.triangles,
                                           "approximate number of triangles of the surface that is mapped; surfaces of "
                                           "more than twice that number are made coarser first [default: 6000]")
                               ->check(unnamed(CLI::Range(100, 10'000'000)))
                               ->type_name("N");
  add_mending_options(verb, options.mending);
  verb.add_option("--from", options.from,
                  "use this polycube, of a solid of one piece: a .json of polycube --domain, which is drawn on the "
                  "surface, or the OUT of polycube, whose map is used where IN is its OUT2 of --surface")
      ->excludes(corners)
      ->excludes(triangles)
      ->type_name("POLYCUBE");
}

std::optional<SolidPolycube> read_solid_polycube(const SolidOptions& options, Session& session) {
  if (options.from.empty()) return std::nullopt;
  SolidPolycube result(read_given_polycube(options.from, session));
  session.figures()["from"] = {{"file", options.from},
                               {"corners", result.file.target.graph.corners.size()},
                               {"genus", result.file.target.genus}};
  return result;
}

Json json_of(const SolidOptions& options) {
  return {{"corners", options.corners},
          {"triangles", options.triangles},
          {"weld", options.mending.weld},
          {"repair", options.mending.repair},
          {"from", options.from}};
}

volume_map::FillSurface fill_by_tetgen() {
#ifdef ORBICUBE_WITH_TETRAHEDRA
  return tetrahedra::filled_mesh;
#else
  return {};
#endif
}

volume_map::InputFindings findings_of(Session& session) {
  volume_map::InputFindings findings;
  findings.on_note = [&session](const std::string& text) { session.note(text); };
  return findings;
}

void report_findings(const volume_map::InputFindings& findings, const std::string& format, Session& session) {
  Json& figures = session.figures();
  if (findings.surface) {
    figures["input"] = {{"format", format},
                        {"vertices", findings.surface->vertices},
                        {"triangles", findings.surface->triangles},
                        {"genus", findings.surface->genus},
                        {"cavities", findings.surface->cavities}};
  }
  if (findings.pieces == 0) return;
  if (findings.polycube) {
    figures["polycube"] = {{"corners", findings.polycube->corners},
                           {"patches", findings.polycube->patches},
                           {"genus", findings.polycube->genus},
                           {"surface_triangles", findings.polycube->surface_triangles},
                           {"distortion_of_angles", findings.polycube->angles},
                           {"distortion_of_areas", findings.polycube->areas}};
  }
  if (findings.pieces > 1) figures["pieces"] = findings.pieces;
  figures["seconds_fill"] = findings.fill_seconds;
  figures["seconds_polycube"] = findings.polycube_seconds;
}

void write_cells_exactly(const std::string& path, const mesh::Mesh& cells, const mesh::WriteOptions& options,
                         Session& session) {
  const base::Host& host = session.host();
  about(path, Role::output, [&] {
    const std::filesystem::path file = session.stage(path);
    mesh::write_mesh(file, cells, options, host);
    const mesh::Mesh again = mesh::read_mesh(file, {}, host);
    if (again.positions != cells.positions || again.tetrahedra != cells.tetrahedra ||
        again.hexahedra != cells.hexahedra || again.regions.tetrahedra != cells.regions.tetrahedra ||
        again.regions.hexahedra != cells.regions.hexahedra)
      throw base::Error("no-valid-result", "verification failed: the written file reads back differently");
  });
}

}  // namespace orbicube::cli
