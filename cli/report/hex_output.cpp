#include "report/hex_output.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "files/surface_file.h"
#include "mesh/search/unit_scale.h"
#include "mesh/topology/place_text.h"
#include "report/text.h"
#include "report/unit_size.h"
#include "solids/polycube_solid.h"

namespace orbicube::cli {

namespace {

// Beyond this multiple of --distance there is no result.
constexpr double far = 2;

Json json_of(const volume_map::HexPiece& piece, const Json& method) {
  return {{"place", {piece.place[0], piece.place[1], piece.place[2]}},
          {"hexahedra", piece.hexahedra},
          {"hausdorff_percent", piece.distance},
          {"volume_error_percent", piece.volume_error},
          {"method", piece.grid_based   ? Json("grid")
                     : method == "grid" ? Json("polycube")
                                        : method}};
}

std::string figures_text(const volume_map::HexResult& result) {
  return "at most " + number(result.distance) + " % of the diagonal from the surface, volume off by " +
         number(result.volume_error) + " %";
}

// The piece that is worst by itself.
std::string worst_piece_text(const volume_map::HexResult& result) {
  const auto off = [](const volume_map::HexPiece& piece) { return std::max(piece.distance, piece.volume_error); };
  const auto worst = std::max_element(result.pieces.begin(), result.pieces.end(),
                                      [&](const auto& a, const auto& b) { return off(a) < off(b); });
  return "of " + std::to_string(result.pieces.size()) + " pieces the worst is that at " +
         mesh::place_text(worst->place) + ": " + number(worst->distance) +
         " % of its own diagonal from its surface, volume off by " + number(worst->volume_error) + " %, " +
         std::to_string(worst->hexahedra) + " hexahedra";
}

}  // namespace

void require_hex_output(const HexOutput& output) {
  require_cells_writable(output.path);
  if (output.glb.empty()) return;
  require_writable(output.glb);
  if (!is_gltf(output.glb))
    throw Failure(Exit::wrong_input, output.glb, "unsupported-format", "--glb needs one of " + gltf_endings);
}

void write_hexahedra(const HexOutput& output, HexOutcome made, double asked, Session& session) {
  const base::Host& host = session.host();
  volume_map::HexResult& result = made.result;
  const volume_map::HexQuality& quality = result.quality;
  mesh::scale_by_power(result.mesh.positions, -made.exponent);
  for (volume_map::HexPiece& piece : result.pieces)
    piece.place = volume_map::times_power_of_two(piece.place, -made.exponent);
  session.figures().update(made.figures);
  if (!made.note.empty()) session.note(made.note);
  session.figures().update(Json{{"output", output.path},
                                {"vertices", result.mesh.positions.size()},
                                {"hexahedra", result.mesh.hexahedra.size()},
                                {"boundary_quads", result.mesh.quads.size()},
                                {"min_scaled_jacobian", quality.min_scaled_jacobian},
                                {"mean_scaled_jacobian", quality.mean_scaled_jacobian},
                                {"volume", unscaled(quality.volume, -3 * made.exponent)},
                                {"off_surface", result.off_surface},
                                {"intersecting_quads", quality.intersections},
                                {"hausdorff_percent", result.distance},
                                {"volume_error_percent", result.volume_error}});
  Json& pieces = session.figures()["by_piece"] = Json::array();
  for (const volume_map::HexPiece& piece : result.pieces)
    pieces.push_back(json_of(piece, session.figures()["method"]));
  const double off = std::max(result.distance, result.volume_error);
  const bool too_far = asked > 0 && !(off <= far * asked);
  const std::string why = figures_text(result) + ": more than twice --distance " + number(asked) +
                          "; raise --cells and --max-cells, or --distance";
  if (too_far && !output.keep_partial)
    throw Failure(Exit::no_result, output.path, "no-valid-result", why + "; --keep-partial writes the mesh");
  if (!output.glb.empty()) {
    about(output.glb, Role::output, [&] {
      session.figures()["scene"] = write_hex_scene(session.stage(output.glb), result.mesh, output.cut,
                                                   std::filesystem::path(output.path).stem().string(), host);
      session.figures()["scene"]["output"] = output.glb;
    });
  }
  mesh::Mesh cells(host.memory);
  cells.positions = std::move(result.mesh.positions);
  cells.hexahedra = std::move(result.mesh.hexahedra);
  write_cells_exactly(output.path, cells, output.text, session);
  for (const std::string& note : session.notes())
    session.say("note: " + note);
  session.say("wrote " + output.path + ": " + std::to_string(cells.hexahedra.size()) +
              " hexahedra, certified: each is positive, and the boundary does not meet itself");
  session.say("  scaled Jacobians at least " + number(quality.min_scaled_jacobian) + ", " +
              number(quality.mean_scaled_jacobian) + " on average; " + made.besides);
  session.say("  " + figures_text(result));
  if (result.pieces.size() > 1) session.say("  " + worst_piece_text(result));
  if (too_far) {
    session.keep();
    throw Failure(Exit::no_result, output.path, "no-valid-result", why + "; the mesh is kept");
  }
  if (asked > 0 && off > asked)
    session.say("  that is more than --distance " + number(asked) + ", with any number of cells up to --max-cells");
}

}  // namespace orbicube::cli
