#include "hex_output.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "surface_file.h"
#include "text.h"

namespace orbicube::cli {

void require_hex_output(const HexOutput& output) {
  require_cells_writable(output.path);
  if (output.glb.empty()) return;
  require_writable(output.glb);
  if (!is_gltf(output.glb))
    throw Failure(Exit::wrong_input, output.glb, "unsupported-format", "--glb needs .glb or .gltf");
}

void write_hexahedra(const HexOutput& output, HexOutcome made, double asked, Session& session) {
  const base::Host& host = session.host();
  volume_map::HexResult& result = made.result;
  const volume_map::HexQuality& quality = result.quality;
  session.figures().update(made.figures);
  if (!made.note.empty()) session.note(made.note);
  session.figures().update(Json{{"output", output.path},
                                {"vertices", result.mesh.positions.size()},
                                {"hexahedra", result.mesh.hexahedra.size()},
                                {"boundary_quads", result.mesh.quads.size()},
                                {"scaled_jacobian_min", quality.least_scaled_jacobian},
                                {"scaled_jacobian_mean", quality.mean_scaled_jacobian},
                                {"volume", quality.volume},
                                {"off_surface", result.off_surface},
                                {"distance_percent", result.distance},
                                {"volume_error_percent", result.volume_error}});
  if (!output.glb.empty()) {
    about(output.glb, Role::output, [&] {
      session.figures()["scene"] = write_hex_scene(output.glb, result.mesh, output.cut,
                                                   std::filesystem::path(output.path).stem().string(), host);
    });
  }
  mesh::Mesh cells(host.memory);
  cells.positions = std::move(result.mesh.positions);
  cells.hexahedra = std::move(result.mesh.hexahedra);
  write_cells_exactly(output.path, cells, output.text, host);
  for (const std::string& note : session.notes())
    session.say("note: " + note);
  session.say("wrote " + output.path + ": " + std::to_string(cells.hexahedra.size()) +
              " hexahedra, each certified to be positive");
  session.say("  scaled Jacobians " + number(quality.least_scaled_jacobian) + " at least, " +
              number(quality.mean_scaled_jacobian) + " on average; " + made.besides);
  session.say("  " + number(result.distance) + " % of the diagonal from the surface at most, volume off by " +
              number(result.volume_error) + " %");
  if (asked > 0 && std::max(result.distance, result.volume_error) > asked)
    session.say("  that is more than --distance " + number(asked) + ", with any number of cells up to --most-cells");
}

}  // namespace orbicube::cli
