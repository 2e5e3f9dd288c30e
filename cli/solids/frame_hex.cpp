#include "solids/frame_hex.h"

#include <algorithm>
#include <numbers>
#include <string>
#include <utility>

#include "frame_field/frames_file.h"
#include "mesh/topology/cells.h"
#include "mesh/topology/place_text.h"
#include "report/text.h"
#include "report/unit_size.h"
#ifdef ORBICUBE_WITH_TETRAHEDRA
#include "solids/filled_solid.h"
#endif

namespace orbicube::cli {

HexOutcome hexahedra_along_frames(const FrameHexVerb& verb, Session& session) {
  const base::Host& host = session.host();
  const double begin = session.seconds();
  volume_map::FramedSolid solid(host.memory);
  mesh::Mesh fine(host.memory);  // the surface, where what is filled is a coarser one
  InputMesh input = read_input(verb.solid.input, verb.solid.weld, session);
  const int exponent = bring_to_unit_size(input.mesh);
  if (input.mesh.tetrahedra.empty() && input.mesh.hexahedra.empty() && verb.frames.empty()) {
#ifdef ORBICUBE_WITH_TETRAHEDRA
    about(verb.solid.input, Role::input, [&] {
      const volume_map::SurfacePieces pieces = pieces_of_surface(input, Inside::tetrahedra, 0, session);
      if (pieces.count > 1) {
        const auto second = std::find(pieces.of.begin(), pieces.of.end(), 1U) - pieces.of.begin();
        const mesh::Index v = input.mesh.triangles[static_cast<std::size_t>(second)][0];
        throw base::Error("not-connected", std::to_string(pieces.count) +
                                               " pieces, and a frame field has one; the second has vertex " +
                                               std::to_string(v) + ", at " + mesh::place_text(input.mesh.positions[v]));
      }
      FilledSolid filled = filled_solid(input.mesh, verb.solid.triangles, host);
      solid.positions = std::move(filled.solid.positions);
      solid.tetrahedra = std::move(filled.solid.tetrahedra);
      if (filled.surface.size() < input.mesh.triangles.size()) fine = std::move(input.mesh);
    });
#else
    throw Failure(Exit::wrong_input, verb.solid.input, "unsupported",
                  "this build has no TetGen to fill a surface; give a mesh of tetrahedra");
#endif
  } else {
    about(verb.solid.input, Role::input, [&] {
      if (input.mesh.tetrahedra.empty()) throw base::Error("no-cells", "no tetrahedra; --frames has a frame for each");
      mesh::require_valid_cells(input.mesh, host);
      if (!input.mesh.hexahedra.empty()) throw base::Error("unsupported", "hexahedra beside the tetrahedra");
    });
    solid.positions = std::move(input.mesh.positions);
    solid.tetrahedra = std::move(input.mesh.tetrahedra);
  }
  const double seconds_fill = session.seconds() - begin;
  if (!verb.frames.empty()) {
    solid.frames = about(verb.frames, Role::input,
                         [&] { return frame_field::read_frames(verb.frames, solid.tetrahedra.size(), host); });
  }
  const double start = session.seconds();
  volume_map::FrameHexes made = about(verb.output, Role::output, [&] {
    const volume_map::FrameHexOptions options = {.cells = verb.cells,
                                                 .distance = verb.distance,
                                                 .max_cells = verb.max_cells,
                                                 .fine_positions = fine.positions,
                                                 .fine_triangles = fine.triangles,
                                                 .max_fields = verb.max_fields};
    if (!verb.frames.empty()) return volume_map::make_hexahedra_by_frames(solid, options, host);
    return volume_map::make_hexahedra_along_frames(solid.positions, solid.tetrahedra,
                                                   verb.feature_angle * std::numbers::pi / 180, options, host);
  });
  const volume_map::FrameMap& map = made.map;
  const std::string note = made.fields > 1 ? "no map follows the smoothest field; that of the hexahedra is number " +
                                                 std::to_string(made.fields)
                                           : "";
  const Json figures = {{"inner_irregular_edges", made.inner_irregular_edges},
                        {"tetrahedra", map.solid.tetrahedra.size()},
                        {"singular_edges", map.singular_edges},
                        {"cut_faces", map.cut_faces},
                        {"integers", map.integers},
                        {"layer_bounds", map.bounds},
                        {"integers_optimal", map.integers_optimal},
                        {"inverted_at_start", map.inverted_at_start},
                        {"steps", map.steps},
                        {"fields", made.fields},
                        {"seconds_fill", seconds_fill},
                        {"seconds_frames", made.field_seconds},
                        {"seconds_compute", session.seconds() - start - made.field_seconds}};
  return {std::move(made.result), figures,
          std::to_string(made.inner_irregular_edges) + " inner edges with other than four hexahedra", note, exponent};
}

}  // namespace orbicube::cli
