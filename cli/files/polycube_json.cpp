#include "files/polycube_json.h"

namespace orbicube::cli {

Json json_of(const polycube::PatchGraph& graph, std::int64_t genus, std::span<const mesh::Vector3> positions) {
  Json corners = Json::array();
  Json points = Json::array();
  for (const mesh::Vector3& c : graph.corners)
    corners.push_back({c[0], c[1], c[2]});
  for (const mesh::Index v : graph.corner_vertices)
    points.push_back({positions[v][0], positions[v][1], positions[v][2]});
  Json edges = Json::array();
  for (mesh::Index e = 0; e < graph.edges(); ++e)
    edges.push_back({{"corners", {graph.origin(2 * e), graph.target(2 * e)}},
                     {"patches", {graph.dart_left[2 * e], graph.dart_left[2 * e + 1]}},
                     {"convex", graph.convex[e] != 0}});
  Json patches = Json::array();
  Json neighbors = Json::array();
  for (mesh::Index p = 0; p < graph.patches(); ++p) {
    Json loops = Json::array();
    for (mesh::Index l = graph.loops_of_patch[p]; l < graph.loops_of_patch[p + 1]; ++l) {
      Json loop = Json::array();
      for (const mesh::Index dart : graph.loop(l))
        loop.push_back(graph.origin(dart));
      loops.push_back(std::move(loop));
    }
    patches.push_back({{"axis", std::string(1, "xyz"[polycube::axis_of(graph.labels[p])])},
                       {"sign", polycube::sign_of(graph.labels[p])},
                       {"coordinate", graph.coordinates[p]},
                       {"loops", std::move(loops)}});
    Json around = Json::array();
    for (const mesh::Index q : graph.neighbors_of(p))
      around.push_back(q);
    neighbors.push_back(std::move(around));
  }
  return {{"format", polycube_format},
          {"version", 1},
          {"genus", genus},
          {"corners", std::move(corners)},
          {"corner_points", std::move(points)},
          {"corner_vertices", std::vector<mesh::Index>(graph.corner_vertices.begin(), graph.corner_vertices.end())},
          {"edges", std::move(edges)},
          {"patches", std::move(patches)},
          {"dual_graph", std::move(neighbors)}};
}

}  // namespace orbicube::cli
