#include "polycube/layout/given_polycube.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/error.h"
#include "polycube/map/certificate.h"
#include "polycube/outputs/patch_rectangles.h"
#include "polycube/outputs/quad_mesh.h"

namespace orbicube::polycube {
namespace {

[[noreturn]] void refuse(const std::string& what) {
  throw base::Error("unsupported", "this is no polycube: " + what);
}

// Coordinates that are nearly the same become the first of them.
void join_coordinates(Array<Vector3>& positions, double tolerance, const base::Host& host) {
  Array<double> sorted(positions.size(), 0.0, host.memory);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < positions.size(); ++i)
      sorted[i] = positions[i][axis];
    std::sort(sorted.begin(), sorted.end());
    Array<double> kept(host.memory);
    for (std::size_t i = 0; i < sorted.size(); ++i)
      if (i == 0 || sorted[i] - sorted[i - 1] > tolerance) kept.push_back(sorted[i]);
    for (Vector3& p : positions)
      p[axis] = *(std::upper_bound(kept.begin(), kept.end(), p[axis]) - 1);
  }
}

void require_finite(std::span<const Vector3> positions) {
  for (std::size_t i = 0; i < positions.size(); ++i)
    if (!positions[i].allFinite())
      throw base::Error("non-finite", "vertex " + std::to_string(i) + " of the polycube is not finite");
}

// Throws unless an edge of a patch, between two corners, lies in the patch's plane along one axis.
void require_edge(std::span<const Vector3> corners, const GivenPatch& patch, std::size_t number, Index from, Index to,
                  Index first_of_loop) {
  const auto fail = [&](const std::string& what) { refuse("face " + std::to_string(number) + " " + what); };
  for (const Index corner : {from, to})
    if (corner >= corners.size())
      throw base::Error("index-range", "the polycube has no corner " + std::to_string(corner));
  const int axis = axis_of(patch.label);
  int different = 0;
  for (Eigen::Index a = 0; a < 3; ++a)
    different += corners[from][a] != corners[to][a];
  const std::string edge = "from corner " + std::to_string(from) + " to " + std::to_string(to);
  if (different != 1) fail("has an edge along no axis, " + edge);
  if (corners[from][axis] != corners[to][axis]) fail("has an edge across its plane, " + edge);
  if (corners[from][axis] != corners[first_of_loop][axis] || corners[from][axis] != corners[patch.corners[0]][axis])
    fail("has corners in more than one plane");
}

// Throws unless each edge of a patch is one of another patch in the other direction. Sorts them.
void require_closed(Array<std::array<Index, 2>>& edges) {
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const std::array<Index, 2> back = {edges[i][1], edges[i][0]};
    if ((i > 0 && edges[i] == edges[i - 1]) || !std::binary_search(edges.begin(), edges.end(), back))
      refuse("the edge from corner " + std::to_string(back[1]) + " to " + std::to_string(back[0]) +
             " is not shared by two faces");
  }
}

}  // namespace

TargetPolycube target_of_mesh(std::span<const Vector3> positions, std::span<const Triangle> triangles, double tolerance,
                              const base::Host& host) {
  require_finite(positions);
  for (const Triangle& t : triangles)
    for (const Index v : t)
      if (v >= positions.size()) throw base::Error("index-range", "the polycube has no vertex " + std::to_string(v));
  TargetPolycube result(host.memory);
  result.map.polycube.assign(positions.begin(), positions.end());
  if (tolerance > 0) join_coordinates(result.map.polycube, tolerance, host);
  result.map.positions = result.map.polycube;
  result.map.triangles.assign(triangles.begin(), triangles.end());
  set_unrefined(result.map);
  const Certificate certificate = certify(result.map, host);
  if (!certificate.valid()) refuse(certificate.reason);
  if (certificate.cavities > 0) refuse("it has cavities, which a connected surface has not");
  result.graph = make_patch_graph(result.map, host);
  result.genus = certificate.genus;
  return result;
}

TargetPolycube target_of_patches(std::span<const Vector3> corners, std::span<const GivenPatch> patches,
                                 const base::Host& host) {
  require_finite(corners);
  // A graph with as much as rectangles need.
  PatchGraph graph(host.memory);
  graph.corners.assign(corners.begin(), corners.end());
  Array<std::array<Index, 2>> sides(host.memory);  // from corner to corner
  graph.loop_begin.push_back(0);
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const GivenPatch& patch = patches[p];
    const auto fail = [&](const std::string& what) { refuse("face " + std::to_string(p) + " " + what); };
    if (patch.label >= label_count) fail("looks along no axis");
    if (patch.loop_begin.size() < 2) fail("has no corners");
    graph.loops_of_patch.push_back(static_cast<Index>(graph.loop_begin.size() - 1));
    graph.labels.push_back(AxisLabel{patch.label});
    for (std::size_t l = 0; l + 1 < patch.loop_begin.size(); ++l) {
      const auto loop = patch.corners.subspan(patch.loop_begin[l], patch.loop_begin[l + 1] - patch.loop_begin[l]);
      if (loop.size() < 4) fail("has a loop of fewer than four corners");
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const Index from = loop[i], to = loop[(i + 1) % loop.size()];
        require_edge(corners, patch, p, from, to, loop[0]);
        graph.loops.push_back(static_cast<Index>(graph.dart_origin.size()));
        graph.dart_origin.push_back(Index{from});
        graph.dart_origin.push_back(Index{to});
        sides.push_back({from, to});
      }
      graph.loop_begin.push_back(static_cast<Index>(graph.loops.size()));
    }
    graph.coordinates.push_back(corners[patch.corners[0]][axis_of(patch.label)]);
  }
  graph.loops_of_patch.push_back(static_cast<Index>(graph.loop_begin.size() - 1));
  if (patches.empty()) refuse("it has no faces");
  require_closed(sides);
  const auto layers = layers_of(graph, host.memory);
  for (std::size_t c = 0; c < corners.size(); ++c)
    for (std::size_t a = 0; a < 3; ++a)
      if (!std::binary_search(layers[a].begin(), layers[a].end(), corners[c][static_cast<Eigen::Index>(a)]))
        refuse("corner " + std::to_string(c) + " is in no face along each axis");
  const QuadMesh mesh = mesh_grid(graph, make_grid(graph, {.quads = 1}, host), host);
  Array<Triangle> triangles(host.memory);
  for (const auto& [a, b, c, d] : mesh.quads) {
    triangles.push_back({a, b, c});
    triangles.push_back({a, c, d});
  }
  return target_of_mesh(mesh.polycube, triangles, 0, host);
}

VoxelSolid solid_of(const PatchGraph& graph, const base::Host& host) {
  const auto layers = layers_of(graph, host.memory);
  std::array<Array<double>, 3> planes = {Array<double>(host.memory), Array<double>(host.memory),
                                         Array<double>(host.memory)};
  for (std::size_t a = 0; a < 3; ++a) {
    const double margin = 0.1 * (layers[a].back() - layers[a].front());
    planes[a].push_back(layers[a].front() - margin);
    planes[a].insert(planes[a].end(), layers[a].begin(), layers[a].end());
    planes[a].push_back(layers[a].back() + margin);
  }
  VoxelSolid solid(std::move(planes), host.memory);
  // Upwards through each column sides change at the faces that it crosses; x and y are the axes along these.
  Array<std::array<int, 3>> crossings(host.memory);
  for (const PatchRectangle& r : rectangles_of(graph, layers, host))
    if (axis_of(r.label) == 2)
      crossings.push_back(
          {static_cast<int>(r.first) + 1, static_cast<int>(r.second) + 1, static_cast<int>(r.plane) + 1});
  std::sort(crossings.begin(), crossings.end());
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
    const auto &from = crossings[i], &to = crossings[i + 1];
    if (from[0] != to[0] || from[1] != to[1]) throw base::Error("invalid-argument", "the polycube is not closed");
    for (int z = from[2]; z < to[2]; ++z)
      solid.set(solid.place({from[0], from[1], z}), true);
  }
  return solid;
}

}  // namespace orbicube::polycube
