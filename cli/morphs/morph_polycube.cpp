#include "morphs/morph_polycube.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>

#include "gltf/kept/kept_nearest.h"
#include "mesh/search/predicates.h"
#include "morphs/morph_placement.h"
#include "morphs/morph_states.h"
#include "polycube/outputs/inverse_map.h"
#include "polycube/outputs/quad_mesh.h"
#include "report/sphere_uses.h"
#include "report/text.h"
#include "solids/shared_polycube.h"

namespace orbicube::cli {
namespace {

using mesh::Index;
using mesh::Triangle;
using mesh::Vector3;

// The triangulation of the polycube that all shapes get.
struct PolycubeTriangles {
  explicit PolycubeTriangles(std::pmr::memory_resource* memory) : polycube(memory), triangles(memory), labels(memory) {}

  base::Array<Vector3> polycube;
  base::Array<Triangle> triangles;
  base::Array<polycube::AxisLabel> labels;
};

// Of quads: 0 for --grid first.
std::size_t cells_of(const PolycubeMorphOptions& options, std::span<const mesh::Mesh> meshes) {
  if (options.grid == "first") return 0;
  if (options.grid == "both") {
    std::size_t most = 0;
    for (const mesh::Mesh& m : meshes)
      most = std::max(most, m.triangles.size());
    return std::clamp<std::size_t>(most, 20'000, 400'000);
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

PolycubeTriangles triangles_on(const polycube::CommonPolycube& common, std::size_t cells, const base::Host& host) {
  PolycubeTriangles result(host.memory);
  if (cells == 0) {
    const polycube::SurfaceMap& first = common.maps.front();
    result.triangles = first.triangles;
    // Without the vertices of the shape that are in no triangle.
    base::Array<Index> number(first.polycube.size(), mesh::no_index, host.memory);
    for (Triangle& t : result.triangles) {
      for (Index& v : t) {
        if (number[v] == mesh::no_index) number[v] = 0;
      }
    }
    for (Index v = 0; v < number.size(); ++v) {
      if (number[v] == mesh::no_index) continue;
      number[v] = static_cast<Index>(result.polycube.size());
      result.polycube.push_back(first.polycube[v]);
    }
    for (Triangle& t : result.triangles) {
      for (Index& v : t)
        v = number[v];
    }
    result.labels = first.labels;
    return result;
  }
  const polycube::PolycubeGrid grid = polycube::make_grid(common.graph, {.quads = cells}, host);
  polycube::QuadMesh quads = polycube::mesh_grid(common.graph, grid, host);
  result.polycube = std::move(quads.polycube);
  for (std::size_t q = 0; q < quads.quads.size(); ++q) {
    const auto& c = quads.quads[q];
    result.triangles.push_back({c[0], c[1], c[2]});
    result.triangles.push_back({c[0], c[2], c[3]});
    for (int half = 0; half < 2; ++half)
      result.labels.push_back(polycube::AxisLabel{common.graph.labels[quads.patches[q]]});
  }
  return result;
}

// Triangles that are not positive in their patch of the polycube, exactly.
std::size_t count_not_positive_on(const PolycubeTriangles& m) {
  std::size_t result = 0;
  for (std::size_t t = 0; t < m.triangles.size(); ++t) {
    const int axis = polycube::axis_of(m.labels[t]);
    const auto flat = [&](Index v) {
      const Vector3& p = m.polycube[v];
      return Eigen::Vector2d(p[(axis + 1) % 3], polycube::sign_of(m.labels[t]) * p[(axis + 2) % 3]);
    };
    result += mesh::orientation_2d(flat(m.triangles[t][0]), flat(m.triangles[t][1]), flat(m.triangles[t][2])) <= 0;
  }
  return result;
}

// The polycube itself at the size and place of the first shape: of its area, and with its center of area.
base::Array<Vector3> polycube_beside(const PolycubeTriangles& common, std::span<const Vector3> shape,
                                     const base::Host& host) {
  const auto area_and_centre = [&](std::span<const Vector3> positions) {
    double area = 0;
    Vector3 centre = Vector3::Zero();
    for (const Triangle& t : common.triangles) {
      const Vector3 &a = positions[t[0]], &b = positions[t[1]], &c = positions[t[2]];
      const double part = (b - a).cross(c - a).norm() / 2;
      area += part;
      centre += part * (a + b + c) / 3;
    }
    return std::pair(area, Vector3(centre / area));
  };
  const auto [area, centre] = area_and_centre(shape);
  const auto [domain_area, domain_centre] = area_and_centre(common.polycube);
  const double scale = std::sqrt(area / domain_area);
  base::Array<Vector3> result(host.memory);
  for (const Vector3& p : common.polycube)
    result.push_back(centre + scale * (p - domain_centre));
  return result;
}

// A point within each triangle, exactly in the plane of its patch.
base::Array<Vector3> middles_of(const PolycubeTriangles& m, const base::Host& host) {
  base::Array<Vector3> result(host.memory);
  result.reserve(m.triangles.size());
  for (std::size_t t = 0; t < m.triangles.size(); ++t) {
    const auto& [a, b, c] = m.triangles[t];
    Vector3 middle = (m.polycube[a] + m.polycube[b] + m.polycube[c]) / 3;
    const int axis = polycube::axis_of(m.labels[t]);
    middle[axis] = m.polycube[a][axis];
    result.push_back(middle);
  }
  return result;
}

// Where the triangles lie on the first shape, whose vertices are at `positions` there.
base::Array<gltf::KeptTriangle> on_first_shape(const SharedPolycube& shared, const PolycubeTriangles& common,
                                               std::span<const Vector3> positions, const base::Host& host) {
  const polycube::SurfaceMap& map = shared.common.maps.front();
  base::Array<Vector3> middles = middles_of(common, host);
  const polycube::LocatedPoints located = polycube::locate(map, middles, host);
  for (std::size_t t = 0; t < middles.size(); ++t) {
    const auto& [a, b, c] = common.triangles[t];
    // Of a very thin triangle at the border of a patch, the middle may be rounded out of it.
    middles[t] = located.triangles[t] == mesh::no_index
                     ? Vector3((positions[a] + positions[b] + positions[c]) / 3)
                     : polycube::interpolate(map, located.triangles[t], located.weights[t]);
  }
  return gltf::nearest_kept_triangles(shared.meshes.front(), positions, common.triangles, middles, host);
}

// The common triangles on each shape.
std::vector<base::Array<Vector3>> states_of(SharedPolycube& shared, const PolycubeTriangles& common,
                                            const std::vector<std::string>& inputs, const base::Host& host) {
  std::vector<base::Array<Vector3>> states;
  for (std::size_t i = 0; i < shared.meshes.size(); ++i) {
    const polycube::SurfaceMap& map = shared.common.maps[i];
    const polycube::LocatedPoints located = polycube::locate(map, common.polycube, host);
    base::Array<Vector3>& state = states.emplace_back(host.memory);
    for (std::size_t v = 0; v < common.polycube.size(); ++v) {
      if (located.triangles[v] == mesh::no_index)
        throw Failure(Exit::no_result, inputs[i], "internal", "a vertex is on no triangle of the polycube");
      state.push_back(polycube::interpolate(map, located.triangles[v], located.weights[v]));
    }
    mesh::Mesh on_shape(host.memory);
    on_shape.positions = state;
    on_shape.triangles = common.triangles;
    shared.figures[i]["distance"] = json_of_distance(shared.meshes[i], on_shape, host);
  }
  return states;
}

void report_shapes(const PolycubeMorphOptions& options, const SharedPolycube& shared, const PolycubeTriangles& common,
                   std::size_t flipped, Session& session) {
  session.figures()["output"] = options.output;
  session.figures()["vertices"] = common.polycube.size();
  session.figures()["triangles"] = common.triangles.size();
  session.figures()["flipped"] = flipped;
  session.figures()["shapes"] = shared.figures;
  session.say("wrote " + options.output + ": " + std::to_string(options.inputs.size()) + " shapes on " +
              std::to_string(common.polycube.size()) + " vertices and " + std::to_string(common.triangles.size()) +
              " triangles");
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
  SharedPolycube shared = share_polycube({.inputs = options.inputs,
                                          .landmarks = options.landmarks,
                                          .construction = {.corners = options.corners, .seed = session.seed()},
                                          .domain = {},
                                          .weld = options.weld,
                                          .keep_first = keep_for(options.output, Keep::decoration)},
                                         session);
  const PolycubeTriangles common = triangles_on(shared.common, cells_of(options, shared.meshes), host);
  // Each map is certified, so what is positive on the polycube is covered once on every shape.
  const std::size_t flipped = count_not_positive_on(common);
  if (flipped > 0)
    throw Failure(Exit::no_result, options.output, "no-valid-result",
                  std::to_string(flipped) + " triangles are flipped on the polycube");
  std::vector<base::Array<Vector3>> states = states_of(shared, common, options.inputs, host);
  base::Array<gltf::KeptTriangle> on_first(host.memory);
  if (shared.kept_first) on_first = on_first_shape(shared, common, states.front(), host);
  std::vector<Json*> figures;
  for (Json& shape : shared.figures)
    figures.push_back(&shape);
  place(options.place, common.triangles, states, figures);
  MorphStates morph{options.output, {}, common.triangles, states, options.seconds, options.steps};
  morph.kept = shared.kept_first.get();
  morph.kept_surface = shared.meshes[0].triangles;
  morph.kept_triangles = on_first;
  for (const std::string& path : options.inputs)
    morph.names.push_back(std::filesystem::path(path).stem().string());
  if (options.show_polycube) {
    states.insert(states.begin() + 1, polycube_beside(common, states.front(), host));
    morph.states = states;
    morph.names.insert(morph.names.begin() + 1, "polycube");
  }
  write_morph(morph, session);
  report_shapes(options, shared, common, flipped, session);
}

}  // namespace orbicube::cli
