#include "report/frame_figures.h"

#include <algorithm>
#include <string>

#include "base/counted.h"
#include "report/text.h"
#include "report/unit_size.h"

namespace orbicube::cli {
namespace {

constexpr std::size_t max_places = 1000;  // that a report lists of each kind

Json json_of(const frame_field::AngleStatistics& a) {
  return {{"mean", a.mean}, {"sd", a.deviation}, {"median", a.median}, {"p99", a.p99}, {"max", a.largest}};
}

Json json_of(const frame_field::Measurement& m) {
  Json histogram = Json::array();
  for (const std::size_t n : m.histogram)
    histogram.push_back(n);
  return {{"E", m.energy},
          {"angle_deg", json_of(m.symmetric)},
          {"angle_without_symmetry_deg", json_of(m.plain)},
          {"faces_above_30deg", m.above_30},
          {"histogram", histogram},
          {"interior_faces", m.inner_faces},
          {"boundary_faces", m.boundary_faces},
          {"norm_error", m.norm_error},
          {"misalignment_deg",
           {{"one_face_tets", m.one_face_tetrahedra},
            {"one_face_max", m.one_face_max},
            {"one_face_mean", m.one_face_mean},
            {"several_face_tets", m.several_face_tetrahedra},
            {"several_best_face_max", m.several_best_max},
            {"several_worst_face_max", m.several_worst_max}}}};
}

Json json_of(const frame_field::SingularGraph& g, int exponent) {
  const auto of = [&](quaternion::CubeClass kind) { return g.by_class[static_cast<std::size_t>(kind)]; };
  std::size_t closed = 0;
  for (const std::uint8_t c : g.curve_closed)
    closed += c;
  return {{"interior_edges", g.inner_edges},
          {"singular_edges",
           {{"total", g.edges.size()},
            {"90", of(quaternion::CubeClass::face_quarter)},
            {"180", of(quaternion::CubeClass::face_half)},
            {"120", of(quaternion::CubeClass::corner_third)},
            {"other", of(quaternion::CubeClass::edge_half)}}},
          {"singular_length", unscaled(g.singular_length, -exponent)},
          {"singular_length_fraction", g.inner_length > 0 ? g.singular_length / g.inner_length : 0},
          {"curves", g.curves()},
          {"loops", closed},
          {"nodes", g.nodes.size()},
          {"boundary_ends", g.boundary_ends},
          {"dead_ends", g.dead_ends.size()}};
}

const char* turn_name(const frame_field::SingularEdge& edge) {
  switch (edge.kind()) {
    case quaternion::CubeClass::face_half:
      return "180";
    case quaternion::CubeClass::corner_third:
      return "120";
    case quaternion::CubeClass::edge_half:
      return "other";
    default:
      return "90";
  }
}

// Where no hexahedral mesh could follow: the first edges and vertices of each kind.
Json improper_places(const mesh::Mesh& solid, const frame_field::SingularGraph& graph,
                     const frame_field::Meshability& local, int exponent) {
  const auto point = [&](const mesh::Vector3& p) {
    return Json{unscaled(p[0], -exponent), unscaled(p[1], -exponent), unscaled(p[2], -exponent)};
  };
  Json edges = Json::array(), vertices = Json::array();
  for (std::size_t i = 0; i < std::min(local.edges.size(), max_places); ++i) {
    const frame_field::SingularEdge& edge = graph.edges[local.edges[i]];
    const auto& [a, b] = edge.vertices;
    edges.push_back({{"vertices", {a, b}},
                     {"turn", turn_name(edge)},
                     {"at", point(0.5 * (solid.positions[a] + solid.positions[b]))}});
  }
  for (std::size_t i = 0; i < std::min(local.vertices.size(), max_places); ++i) {
    const mesh::Index v = local.vertices[i];
    vertices.push_back({{"vertex", v},
                        {"kind", std::ranges::binary_search(graph.nodes, v) ? "node" : "turning-point"},
                        {"at", point(solid.positions[v])}});
  }
  return {{"edges", edges}, {"vertices", vertices}};
}

}  // namespace

FieldFindings::FieldFindings(const mesh::Mesh& solid, const mesh::TetrahedralConnectivity& connectivity,
                             const frame_field::Field& field, const base::Host& host)
    : measurement(frame_field::measure(solid.positions, connectivity, field, host)),
      graph(frame_field::singular_graph(solid.positions, connectivity, field,
                                        frame_field::matchings(connectivity, field, host), host)),
      indices(frame_field::boundary_indices(solid.positions, connectivity, field, host)),
      local(frame_field::meshability(graph, connectivity.boundary_vertices(host.memory), host.memory)) {}

Json field_figures(const mesh::Mesh& solid, const FieldFindings& found, int exponent) {
  Json figures = json_of(found.measurement);
  figures.update(json_of(found.graph, exponent));
  figures.update({{"boundary_index_sum", 0.25 * static_cast<double>(found.indices.sum_of_quarters)},
                  {"boundary_singular_vertices", found.indices.singular_vertices},
                  {"euler_characteristic", found.indices.euler_characteristic},
                  {"locally_meshable", found.local.locally_meshable()},
                  {"improper_edges", found.local.edges.size()},
                  {"turning_points", found.local.turning_points},
                  {"improper_nodes", found.local.improper_nodes},
                  {"improper_places", improper_places(solid, found.graph, found.local, exponent)}});
  return figures;
}

Json repair_figures(const frame_field::RepairOutcome& r) {
  const auto faults = [](const frame_field::Faults& f, double energy) {
    return Json{
        {"improper_edges", f.edges}, {"improper_vertices", f.vertices}, {"fragments", f.fragments}, {"E", energy}};
  };
  return {
      {"rounds", r.rounds}, {"before", faults(r.before, r.energy_before)}, {"after", faults(r.after, r.energy_after)}};
}

void say_field(const FieldFindings& found, Session& session) {
  const auto& [m, graph, indices, local] = found;
  session.say("  energy " + number(m.energy) + ", angles " + number(m.symmetric.mean) + " degrees on average, " +
              number(m.symmetric.p99) + " at 99 %, maximum " + number(m.symmetric.largest) + "; at most " +
              number(m.one_face_max) + " degrees off the normals");
  session.say("  " + base::counted(graph.edges.size(), "singular edge") + " on " +
              base::counted(graph.curves(), "curve") + " with " + base::counted(graph.nodes.size(), "node") + "; " +
              (local.locally_meshable()
                   ? "locally meshable"
                   : base::counted(local.edges.size(), "edge") + " and " +
                         base::counted(local.vertices.size(), "vertex is", "vertices are") + " not meshable"));
}

void say_repair(const frame_field::RepairOutcome& repair, Session& session) {
  session.say("  repaired: " + base::counted(repair.before.unmeshable(), "place that is", "places that are") +
              " not meshable became " + std::to_string(repair.after.unmeshable()) + ", the energy " +
              number(repair.energy_before) + " became " + number(repair.energy_after));
}

}  // namespace orbicube::cli
