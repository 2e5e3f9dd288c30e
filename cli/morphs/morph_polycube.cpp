#include "morphs/morph_polycube.h"

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "base/counted.h"
#include "correspondence/polycube_mesh.h"
#include "gltf/kept/kept_nearest.h"
#include "morphs/morph_placement.h"
#include "morphs/morph_states.h"
#include "report/sphere_uses.h"
#include "report/text.h"
#include "solids/shared_polycube.h"

namespace orbicube::cli {
namespace {

using correspondence::PolycubeMesh;
using mesh::Vector3;

// Of quads: 0 for --grid first.
std::size_t cells_of(const PolycubeMorphOptions& options, std::span<const mesh::Mesh> meshes) {
  if (options.grid == "first") return 0;
  if (options.grid == "both") {
    std::size_t most = 0;
    for (const mesh::Mesh& m : meshes)
      most = std::max(most, m.triangles.size());
    return correspondence::cells_for(most);
  }
  const std::string name = "cells:";
  std::size_t cells = 0;
  const char* const end = options.grid.data() + options.grid.size();
  const auto [read, problem] =
      std::from_chars(options.grid.data() + std::min(name.size(), options.grid.size()), end, cells);
  if (!options.grid.starts_with(name) || problem != std::errc() || read != end || cells < 1 || cells > 100'000'000)
    throw Failure(Exit::wrong_input, "", "usage",
                  "--grid: '" + options.grid + "' is no grid of a polycube; there are first and cells:N");
  return cells;
}

// Where the triangles lie on the first shape, whose vertices are at `positions` there.
base::Array<gltf::KeptTriangle> on_first_shape(const SharedPolycube& shared, const PolycubeMesh& common,
                                               std::span<const Vector3> positions, const base::Host& host) {
  const base::Array<Vector3> middles = correspondence::middles_on(shared.common.maps.front(), common, positions, host);
  return gltf::nearest_kept_triangles(shared.meshes.front(), positions, common.triangles, middles, host);
}

// The common triangles on each shape.
std::vector<base::Array<Vector3>> states_of(SharedPolycube& shared, const PolycubeMesh& common,
                                            const std::vector<std::string>& inputs, const base::Host& host) {
  std::vector<base::Array<Vector3>> states;
  for (std::size_t i = 0; i < shared.meshes.size(); ++i) {
    base::Array<Vector3>& state = states.emplace_back(about(
        inputs[i], Role::output, [&] { return correspondence::positions_on(shared.common.maps[i], common, host); }));
    mesh::Mesh on_shape(host.memory);
    on_shape.positions = state;
    on_shape.triangles = common.triangles;
    shared.figures[i]["distance"] = json_of_distance(shared.meshes[i], on_shape, host);
  }
  return states;
}

void report_shapes(const PolycubeMorphOptions& options, const SharedPolycube& shared, const PolycubeMesh& common,
                   Session& session) {
  session.figures()["output"] = options.output;
  session.figures()["vertices"] = common.polycube.size();
  session.figures()["triangles"] = common.triangles.size();
  session.figures()["flipped"] = 0;
  session.figures()["shapes"] = shared.figures;
  session.say("wrote " + options.output + ": " + base::counted(options.inputs.size(), "shape") + " on " +
              base::counted(common.polycube.size(), "vertex", "vertices") + " and " +
              base::counted(common.triangles.size(), "triangle"));
  for (std::size_t i = 0; i < options.inputs.size(); ++i)
    session.say("  " + options.inputs[i] + ": at most " +
                number(100 * shared.figures[i]["distance"]["from_surface"]["max_of_diagonal"].get<double>()) +
                " % of its diagonal is lost");
  for (const std::string& note : session.notes())
    session.say("  note: " + note);
}

}  // namespace

void morph_by_polycube(const PolycubeMorphOptions& options, Session& session) {
  const base::Host& host = session.host();
  if (options.inputs.size() > 10) throw Failure(Exit::wrong_input, "", "usage", "--polycube takes at most ten shapes");
  cells_of(options, {});
  if (!options.blend.quads.empty() && options.grid == "first")
    throw Failure(Exit::wrong_input, "", "usage", "--quads is for a grid of the polycube; --grid first has triangles");
  SharedPolycube shared = share_polycube(
      {.inputs = options.inputs,
       .landmarks = options.landmarks,
       .common = {.construction = {.corners = options.corners, .seed = session.seed()}},
       .mending = options.mending,
       .keep_first = options.blend.weights.empty() ? keep_for(options.output, Keep::decoration) : Keep::surface},
      session);
  const std::size_t cells = cells_of(options, shared.meshes);
  const PolycubeMesh common =
      about(options.output, Role::output, [&] { return correspondence::triangles_on(shared.common, cells, host); });
  std::vector<base::Array<Vector3>> states = states_of(shared, common, options.inputs, host);
  base::Array<gltf::KeptTriangle> on_first(host.memory);
  if (shared.kept_first) on_first = on_first_shape(shared, common, states.front(), host);
  std::vector<Json*> figures;
  for (Json& shape : shared.figures)
    figures.push_back(&shape);
  place_states(options.place, common.triangles, states, figures);
  MorphStates morph{options.output, {}, common.triangles, states, options.seconds, options.steps};
  morph.kept = shared.kept_first.get();
  morph.kept_surface = shared.meshes[0].triangles;
  morph.kept_triangles = on_first;
  for (const std::string& path : options.inputs)
    morph.names.push_back(std::filesystem::path(path).stem().string());
  if (options.show_polycube) {
    states.insert(states.begin() + 1, correspondence::polycube_beside(common, states.front(), host));
    morph.states = states;
    morph.names.insert(morph.names.begin() + 1, "polycube");
  }
  if (options.blend.weights.empty())
    write_morph(morph, session);
  else
    write_blend(morph, options.blend, common.quads, session);
  report_shapes(options, shared, common, session);
}

}  // namespace orbicube::cli
