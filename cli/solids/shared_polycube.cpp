#include "solids/shared_polycube.h"

#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

#include "base/counted.h"
#include "files/landmark_file.h"
#include "report/polycube_outputs.h"
#include "report/text.h"
#include "report/unit_size.h"
#include "solids/any_genus_surface.h"

namespace orbicube::cli {

namespace {

// The surface with more handles is the one to look at.
void require_one_genus(const SharedPolycube& shared, const std::vector<std::string>& inputs) {
  const auto genus = [&](std::size_t i) { return shared.figures[i].at("genus").get<std::int64_t>(); };
  for (std::size_t i = 1; i < inputs.size(); ++i) {
    if (genus(i) == genus(0)) continue;
    const std::size_t more = genus(i) > genus(0) ? i : 0, fewer = more == 0 ? i : 0;
    throw Failure(Exit::wrong_input, inputs[more], "wrong-genus",
                  "genus " + std::to_string(genus(more)) + ", and " + inputs[fewer] + " has genus " +
                      std::to_string(genus(fewer)) + ": surfaces of one genus have a polycube in common");
  }
}

}  // namespace

SharedPolycube share_polycube(const SharedPolycubeOptions& options, Session& session) {
  const base::Host& host = session.host();
  SharedPolycube result{{}, {}, polycube::CommonPolycube(host.memory), {}, nullptr};
  for (const std::string& path : options.inputs) {
    const bool is_first = result.meshes.empty();
    AnyGenusSurface surface =
        read_any_genus_surface(path, options.mending, session, is_first ? options.keep_first : Keep::surface);
    require_ordinary_size(surface.mesh, path);
    if (is_first) result.kept_first = std::move(surface.kept);
    result.meshes.push_back(std::move(surface.mesh));
    result.given.push_back(std::move(surface.given));
    Json figures = {{"input", path}};
    figures.update(surface.figures);
    result.figures.push_back(std::move(figures));
  }
  require_one_genus(result, options.inputs);
  std::vector<polycube::SurfaceSpan> shapes;
  std::vector<const mesh::Mesh*> meshes;
  for (const mesh::Mesh& m : result.meshes) {
    shapes.push_back({m.positions, m.triangles});
    meshes.push_back(&m);
  }
  std::vector<base::Array<mesh::Vector3>> landmarks;
  if (!options.landmarks.empty()) {
    about(options.landmarks, Role::input, [&] {
      for (const auto& points : read_landmark_points(options.landmarks, meshes, host)) {
        landmarks.emplace_back(host.memory);
        for (const LandmarkPoint& point : points)
          landmarks.back().push_back(point.on_surface.position);
      }
    });
  }
  const double start = session.seconds();
  result.common = about(options.inputs.front(), Role::input, [&] {
    polycube::CommonPolycubeOptions of_common = options.common;
    of_common.landmarks = landmarks;
    return polycube::construct_common(shapes, of_common, host);
  });
  const polycube::CommonPolycube& common = result.common;
  const double own = std::accumulate(common.own_energies.begin(), common.own_energies.end(), 0.0);
  session.figures()["polycube"] = {{"constructed_from", options.inputs[common.base]},
                                   {"polycubes_tried", common.tried},
                                   {"genus", common.genus},
                                   {"corners", common.graph.corners.size()},
                                   {"patches", common.graph.patches()},
                                   {"energies", common.energies},
                                   {"own_energies", common.own_energies},
                                   {"energy_over_own", common.energies.back() / own},
                                   {"seconds", session.seconds() - start}};
  for (std::size_t i = 0; i < shapes.size(); ++i)
    result.figures[i]["distortion"] = distortion_figures(common.distortions[i]);
  const bool given = options.common.target.graph != nullptr;
  session.say("  one polycube with " + base::counted(common.graph.corners.size(), "corner") + ", " +
              (given ? "given, drawn first on " : "made for ") + options.inputs[common.base] + "; energies add up to " +
              number(common.energies.back()) + (std::isfinite(own) ? ", with a polycube each to " + number(own) : ""));
  return result;
}

}  // namespace orbicube::cli
