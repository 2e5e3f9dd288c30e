// orbicube polycube for several surfaces: one polycube, constructed for one of them or given, and certified maps to it.
#include <filesystem>
#include <optional>
#include <utility>

#include "files/exact_file.h"
#include "files/feature_file.h"
#include "files/given_polycube_file.h"
#include "polycube/features/features.h"
#include "report/polycube_methods.h"
#include "report/text.h"
#include "solids/shared_polycube.h"
#include "verbs/polycube_options.h"

namespace orbicube::cli {
namespace {

// name-2.obj for the second of several shapes.
std::string numbered(const std::string& path, std::size_t shape) {
  if (path.empty()) return path;
  const std::filesystem::path whole(path);
  return (whole.parent_path() / (whole.stem().string() + "-" + std::to_string(shape + 1) + whole.extension().string()))
      .string();
}

polycube::CommonPolycubeOptions common_options(const PolycubeOptions& options, const Session& session) {
  polycube::CommonPolycubeOptions result;
  result.construction = {
      .method = polycube_method_named(options.construct), .corners = options.corners, .seed = session.seed()};
  result.domain = {.measure = measure_of(options.measure), .area_weight = options.area_weight};
  if (!options.from.empty()) result.proportions = options.optimize == "domain" || options.optimize == "all";
  result.corners = options.optimize == "corners" || options.optimize == "all";
  if (options.corner_search == "gradient") result.corner_search = polycube::CornerMethod::gradient;
  return result;
}

}  // namespace

polycube::DomainMeasure measure_of(const std::string& name) {
  if (name == "faces") return polycube::DomainMeasure::face_mean;
  return name == "harmonic" ? polycube::DomainMeasure::harmonic : polycube::DomainMeasure::surface_mean;
}

// Points and curves at their target positions, and sharp edges on edges of the polycube.
void align_features(const std::string& input, const std::string& targets, double feature_angle,
                    polycube::SurfaceMap& map, polycube::Certificate& certificate, polycube::Distortion& distortion,
                    Json& figures, Session& session) {
  const double start = session.seconds();
  Features features;
  if (!targets.empty()) features = read_features(targets, session.host());
  polycube::FeatureFit found = about(targets.empty() ? input : targets, Role::input, [&] {
    return polycube::align_features(
        map, {.points = features.points, .curves = features.curves, .feature_angle = feature_angle}, session.host());
  });
  figures["features"] = {{"distortion_before", distortion_figures(distortion)},
                         {"points", features.points.size()},
                         {"curves", features.curves.size()},
                         {"distances_before", found.distances_before},
                         {"distances", found.distances},
                         {"sharp_length", found.sharp_length},
                         {"sharp_on_edges_before", found.sharp_before},
                         {"sharp_on_edges", found.sharp},
                         {"seconds", session.seconds() - start}};
  if (found.sharp_length > 0)
    session.say("  sharp edges on edges of the polycube: " + number(100 * found.sharp / found.sharp_length) +
                " % of their length, before " + number(100 * found.sharp_before / found.sharp_length) + " %");
  certificate = std::move(found.certificate);
  distortion = found.distortion;
}

void share_one_polycube(const PolycubeOptions& options, Session& session) {
  if (options.construct == "dissertation")
    throw Failure(Exit::wrong_input, "", "usage", "--method dissertation is for one surface");
  if (!options.targets.empty() && options.targets.size() != options.inputs.size())
    throw Failure(Exit::wrong_input, "", "usage",
                  "--targets must be given for each of the " + std::to_string(options.inputs.size()) +
                      " surfaces, in their order, with none for no file");
  session.options()["inputs"] = options.inputs;
  session.options()["landmarks"] = options.landmarks;
  std::optional<GivenPolycube> given;
  polycube::CommonPolycubeOptions of_common = common_options(options, session);
  if (!options.from.empty()) {
    given.emplace(read_given_polycube(options.from, session));
    of_common.target = {&given->target.graph, given->target.genus, given->pose};
    session.figures()["from"] = {
        {"file", options.from}, {"corners", given->target.graph.corners.size()}, {"genus", given->target.genus}};
  }
  SharedPolycube shared = share_polycube(
      {.inputs = options.inputs, .landmarks = options.landmarks, .common = of_common, .mending = options.mending},
      session);
  polycube::CommonPolycube& common = shared.common;
  for (std::size_t i = 0; i < options.inputs.size(); ++i) {
    polycube::SurfaceMap& map = common.maps[i];
    const std::string targets = options.targets.empty() || options.targets[i] == "none" ? "" : options.targets[i];
    if (!targets.empty() || options.feature_angle > 0) {
      align_features(options.inputs[i], targets, options.feature_angle, map, common.certificates[i],
                     common.distortions[i], shared.figures[i], session);
      shared.figures[i]["distortion"] = distortion_figures(common.distortions[i]);
    }
    const std::string output = numbered(options.output, i), surface = numbered(options.surface, i);
    write_exactly(output, map.polycube, map.triangles, options.text, session);
    if (!surface.empty()) write_exactly(surface, map.positions, map.triangles, options.text, session);
    Json& figures = shared.figures[i];
    figures.update(Json{{"output", output},
                        {"surface", surface},
                        {"vertices_added", map.positions.size() - shared.meshes[i].positions.size()}});
    session.say("wrote " + output + (surface.empty() ? "" : " and " + surface) + ": mean distortion of angles " +
                std::to_string(common.distortions[i].angle_weighted_mean) + ", of areas " +
                std::to_string(common.distortions[i].area_weighted_mean) + " (over the surface; 1: none)");
    PolycubeOutputs own = options.outputs;
    if (i != common.base) own.domain.clear();
    own.quads = numbered(own.quads, i);
    own.glb = numbered(own.glb, i);
    own.atlas = numbered(own.atlas, i);
    own.page = numbered(own.page, i);
    const polycube::Certificate& certificate = common.certificates[i];
    write_polycube_outputs(own,
                           {options.inputs[i], map, certificate.genus, certificate.corners, certificate.patch_count,
                            common.distortions[i], common.energies},
                           figures, session);
  }
  session.figures()["shapes"] = shared.figures;
  for (const std::string& note : session.notes())
    session.say("note: " + note);
}

}  // namespace orbicube::cli
