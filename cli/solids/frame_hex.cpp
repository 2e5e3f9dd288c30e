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

namespace {

struct FramedInput {
  explicit FramedInput(std::pmr::memory_resource* memory) : solid(memory), fine(memory) {}

  volume_map::FramedSolid solid;  // without frames
  mesh::Mesh fine;                // the surface, where what is filled is a coarser one
  int exponent = 0;               // of the power of two by which the input was scaled
};

#ifdef ORBICUBE_WITH_TETRAHEDRA
void fill_surface(const FrameHexVerb& verb, InputMesh& input, FramedInput& result, Session& session) {
  about(verb.solid.input, Role::input, [&] {
    const volume_map::SurfacePieces pieces = pieces_of_surface(input, Inside::tetrahedra, 0, session);
    if (pieces.count > 1) {
      const auto second = std::find(pieces.of.begin(), pieces.of.end(), 1U) - pieces.of.begin();
      const mesh::Index v = input.mesh.triangles[static_cast<std::size_t>(second)][0];
      throw base::Error("not-connected", std::to_string(pieces.count) +
                                             " pieces, and a frame field has one; the second has vertex " +
                                             std::to_string(v) + ", at " + mesh::place_text(input.mesh.positions[v]));
    }
    FilledSolid filled = filled_solid(input.mesh, verb.solid.triangles, session.host());
    result.solid.positions = std::move(filled.solid.positions);
    result.solid.tetrahedra = std::move(filled.solid.tetrahedra);
    if (filled.surface.size() < input.mesh.triangles.size()) result.fine = std::move(input.mesh);
  });
}
#endif

void take_tetrahedra(const FrameHexVerb& verb, InputMesh& input, FramedInput& result, const base::Host& host) {
  about(verb.solid.input, Role::input, [&] {
    if (input.mesh.tetrahedra.empty()) throw base::Error("no-cells", "no tetrahedra; --frames has a frame for each");
    mesh::require_valid_cells(input.mesh, host);
    if (!input.mesh.hexahedra.empty()) throw base::Error("unsupported", "hexahedra beside the tetrahedra");
  });
  result.solid.positions = std::move(input.mesh.positions);
  result.solid.tetrahedra = std::move(input.mesh.tetrahedra);
}

// The tetrahedra of the input, or of its surface filled.
FramedInput read_framed(const FrameHexVerb& verb, Session& session) {
  FramedInput result(session.host().memory);
  InputMesh input = read_input(verb.solid.input, verb.solid.weld, session);
  result.exponent = bring_to_unit_size(input.mesh);
  if (input.mesh.tetrahedra.empty() && input.mesh.hexahedra.empty() && verb.frames.empty()) {
#ifdef ORBICUBE_WITH_TETRAHEDRA
    fill_surface(verb, input, result, session);
#else
    throw Failure(Exit::wrong_input, verb.solid.input, "unsupported",
                  "this build has no TetGen to fill a surface; give a mesh of tetrahedra");
#endif
  } else {
    take_tetrahedra(verb, input, result, session.host());
  }
  return result;
}

volume_map::FrameHexes make_hexahedra(const FrameHexVerb& verb, const FramedInput& input, const base::Host& host) {
  return about(verb.output, Role::output, [&] {
    const volume_map::FrameHexOptions options = {.cells = verb.cells,
                                                 .distance = verb.distance,
                                                 .max_cells = verb.max_cells,
                                                 .fine_positions = input.fine.positions,
                                                 .fine_triangles = input.fine.triangles,
                                                 .max_fields = verb.max_fields};
    if (!verb.frames.empty()) return volume_map::make_hexahedra_by_frames(input.solid, options, host);
    return volume_map::make_hexahedra_along_frames(input.solid.positions, input.solid.tetrahedra,
                                                   verb.feature_angle * std::numbers::pi / 180, options, host);
  });
}

}  // namespace

HexOutcome hexahedra_along_frames(const FrameHexVerb& verb, Session& session) {
  const base::Host& host = session.host();
  const double begin = session.seconds();
  FramedInput input = read_framed(verb, session);
  const double seconds_fill = session.seconds() - begin;
  if (!verb.frames.empty()) {
    input.solid.frames = about(verb.frames, Role::input, [&] {
      return frame_field::read_frames(verb.frames, input.solid.tetrahedra.size(), host);
    });
  }
  const double start = session.seconds();
  volume_map::FrameHexes made = make_hexahedra(verb, input, host);
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
          std::to_string(made.inner_irregular_edges) + " inner edges with other than four hexahedra", note,
          input.exponent};
}

}  // namespace orbicube::cli
