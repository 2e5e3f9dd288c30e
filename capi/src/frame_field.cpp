#include "orbicube/frame_field.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <numbers>
#include <span>
#include <string>

#include "base/version.h"
#include "capi/src/entry.h"
#include "frame_field/frame_field.h"
#include "frame_field/graph/boundary_indices.h"
#include "frame_field/singularities/faults.h"
#include "frame_field/singularities/measurement.h"
#include "frame_field/singularities/meshability.h"
#include "frame_field/singularities/singularities.h"

using namespace orbicube;
using frame_field::Quaternion;
using mesh::Index;
using mesh::Tetrahedron;
using mesh::Vector3;

struct obc_frame_field_singularities {
  explicit obc_frame_field_singularities(const obc_host* given)
      : host(given), graph(host.host().memory), local(host.host().memory) {}
  capi::HostAdapter host;
  frame_field::SingularGraph graph;
  frame_field::Meshability local;
};

namespace {

obc_frame_field_options default_options() {
  const frame_field::Options d;
  obc_frame_field_options o{};
  o.struct_size = sizeof o;
  o.start = OBC_FRAME_FIELD_AUTO;
  o.method = OBC_FRAME_FIELD_SMOOTH;
  o.weighting = OBC_FRAME_FIELD_UNIFORM;
  o.align_boundary = 1;
  o.rounds = d.rounds;
  o.feature_angle = d.feature_angle * 180 / std::numbers::pi;
  o.relative_gain = d.relative_gain;
  o.repair = OBC_FRAME_FIELD_NO_REPAIR;
  return o;
}

obc_frame_field_constraints no_constraints() {
  obc_frame_field_constraints c{};
  c.struct_size = sizeof c;
  return c;
}

// The caller's arrays as the C++ side takes them: doubles and indices have the layout of its vectors and cells.
struct Solid {
  std::span<const Vector3> positions;
  std::span<const Tetrahedron> tetrahedra;

  explicit Solid(const obc_frame_field_solid* s) {
    static_assert(sizeof(Vector3) == 3 * sizeof(double) && sizeof(Tetrahedron) == 4 * sizeof(uint32_t) &&
                  sizeof(Quaternion) == 4 * sizeof(double));
    capi::require(s != nullptr, "solid is NULL");
    capi::require(s->positions != nullptr && s->vertex_count > 0, "solid->positions is NULL or there are none");
    capi::require(s->tetrahedra != nullptr && s->tetrahedron_count > 0, "solid->tetrahedra is NULL or there are none");
    positions = {reinterpret_cast<const Vector3*>(s->positions), s->vertex_count};
    tetrahedra = {reinterpret_cast<const Tetrahedron*>(s->tetrahedra), s->tetrahedron_count};
    for (const Vector3& p : positions)
      capi::require(p.allFinite(), "a position is not finite");
    for (const Tetrahedron& t : tetrahedra)
      capi::require(*std::max_element(t.begin(), t.end()) < positions.size(), "a tetrahedron's vertex is out of range");
  }

  std::span<const Quaternion> field(const double* frames) const {
    capi::require(frames != nullptr, "frames is NULL");
    const std::span<const Quaternion> field(reinterpret_cast<const Quaternion*>(frames), tetrahedra.size());
    for (const Quaternion& q : field) {
      const double square = dot(q, q);
      capi::require(square > 1e-12 && square < 1e12, "a frame is zero or not finite");
    }
    return field;
  }
};

void write_report(const Solid& solid, std::span<const Quaternion> field, const frame_field::Outcome* outcome,
                  const base::Host& host, obc_frame_field_report* to) {
  if (to == nullptr) return;
  const mesh::TetrahedralConnectivity connectivity(solid.positions.size(), solid.tetrahedra, host);
  const frame_field::Measurement m = frame_field::measure(solid.positions, connectivity, field, host);
  const frame_field::Structure structure = frame_field::FaultFinder(solid.positions, connectivity, host).find(field);
  const frame_field::SingularGraph& graph = structure.graph;
  const auto indices = frame_field::boundary_indices(solid.positions, connectivity, field, host);
  obc_frame_field_report r{};
  r.energy = m.energy;
  r.symmetric_mean = m.symmetric.mean;
  r.symmetric_deviation = m.symmetric.deviation;
  r.symmetric_median = m.symmetric.median;
  r.symmetric_p99 = m.symmetric.p99;
  r.symmetric_max = m.symmetric.largest;
  r.plain_mean = m.plain.mean;
  r.plain_deviation = m.plain.deviation;
  r.plain_median = m.plain.median;
  r.plain_p99 = m.plain.p99;
  r.plain_max = m.plain.largest;
  r.inner_faces = m.inner_faces;
  r.boundary_faces = m.boundary_faces;
  r.above_30 = m.above_30;
  r.one_face_max = m.one_face_max;
  r.several_best_max = m.several_best_max;
  r.several_worst_max = m.several_worst_max;
  r.singular_edges = graph.edges.size();
  r.singular_half = graph.by_class[static_cast<std::size_t>(quaternion::CubeClass::face_half)];
  r.singular_quarter = graph.by_class[static_cast<std::size_t>(quaternion::CubeClass::face_quarter)];
  r.singular_third = graph.by_class[static_cast<std::size_t>(quaternion::CubeClass::corner_third)];
  r.singular_diagonal = graph.by_class[static_cast<std::size_t>(quaternion::CubeClass::edge_half)];
  r.curves = graph.curves();
  r.closed_curves = static_cast<uint64_t>(std::count(graph.curve_closed.begin(), graph.curve_closed.end(), 1));
  r.nodes = graph.nodes.size();
  r.boundary_ends = graph.boundary_ends;
  r.dead_ends = graph.dead_ends.size();
  r.singular_length = graph.singular_length;
  r.edge_length = graph.inner_length;
  r.boundary_index_quarters = indices.sum_of_quarters;
  r.euler_characteristic = indices.euler_characteristic;
  const auto mesh = frame_field::meshability(graph, connectivity.boundary_vertices(host.memory), host.memory);
  r.locally_meshable = mesh.locally_meshable() ? 1 : 0;
  r.improper_edges = mesh.edges.size();
  r.turning_points = mesh.turning_points;
  r.improper_nodes = mesh.improper_nodes;
  r.fragments = structure.faults.fragments;
  if (outcome != nullptr) {
    r.start = static_cast<int32_t>(outcome->start);
    r.smoothing_steps = outcome->smoothing_steps;
    r.solver_iterations = outcome->solver_iterations;
    r.repair_rounds = outcome->repair.rounds;
    r.unmeshable_before = outcome->repair.before.unmeshable();
    r.fragments_before = outcome->repair.before.fragments;
    r.energy_before_repair = outcome->repair.energy_before;
  }
  capi::write_versioned(to, r);
}

}  // namespace

obc_status obc_frame_field_options_init(obc_frame_field_options* options, size_t struct_size) {
  return capi::init_versioned(options, struct_size, default_options());
}

obc_status obc_frame_field_constraints_init(obc_frame_field_constraints* constraints, size_t struct_size) {
  return capi::init_versioned(constraints, struct_size, no_constraints());
}

obc_status obc_frame_field_report_init(obc_frame_field_report* report, size_t struct_size) {
  return capi::init_versioned(report, struct_size, obc_frame_field_report{});
}

obc_status obc_frame_field_compute(const obc_frame_field_solid* given, const obc_frame_field_options* options,
                                   const obc_frame_field_constraints* constraints, const obc_host* host, double* frames,
                                   obc_frame_field_report* report, obc_error* error) {
  return capi::guarded(error, [&] {
    const Solid solid(given);
    capi::require(frames != nullptr, "frames is NULL");
    const obc_frame_field_options o = capi::copy_versioned(options, default_options());
    const obc_frame_field_constraints c = capi::copy_versioned(constraints, no_constraints());
    capi::require(c.frame_count == 0 || (c.frame_tetrahedra != nullptr && c.frames != nullptr),
                  "constraints->frames or frame_tetrahedra is NULL");
    capi::require(c.axis_count == 0 || (c.axis_tetrahedra != nullptr && c.axes != nullptr),
                  "constraints->axes or axis_tetrahedra is NULL");
    const capi::HostAdapter adapter(host);
    base::Array<frame_field::GivenFrame> frames_wanted(adapter.host().memory);
    base::Array<frame_field::GivenAxis> axes(adapter.host().memory);
    for (size_t i = 0; i < c.frame_count; ++i) {
      const double* q = c.frames + 4 * i;
      const double weight = c.frame_weights != nullptr ? c.frame_weights[i] : frame_field::held;
      frames_wanted.push_back({c.frame_tetrahedra[i], {q[0], q[1], q[2], q[3]}, weight});
    }
    for (size_t i = 0; i < c.axis_count; ++i) {
      const double weight = c.axis_weights != nullptr ? c.axis_weights[i] : frame_field::held;
      axes.push_back({c.axis_tetrahedra[i], {c.axes[3 * i], c.axes[3 * i + 1], c.axes[3 * i + 2]}, weight});
    }
    frame_field::Options settings;
    settings.start = static_cast<frame_field::Start>(o.start);
    settings.method = static_cast<frame_field::Method>(o.method);
    settings.weighting = static_cast<frame_field::Weighting>(o.weighting);
    settings.align_boundary = o.align_boundary != 0;
    settings.feature_angle = o.feature_angle * std::numbers::pi / 180;
    settings.relative_gain = o.relative_gain;
    settings.rounds = o.rounds;
    settings.repairs = static_cast<frame_field::Repairs>(o.repair);
    frame_field::Given target{frames_wanted, axes, {}};
    if (o.start == OBC_FRAME_FIELD_GIVEN) target.start = solid.field(frames);
    const frame_field::Outcome outcome =
        frame_field::compute(solid.positions, solid.tetrahedra, settings, target, adapter.host());
    write_report(solid, outcome.field, &outcome, adapter.host(), report);
    std::memcpy(frames, outcome.field.data(), outcome.field.size() * sizeof(Quaternion));
  });
}

obc_status obc_frame_field_measure(const obc_frame_field_solid* given, const double* frames, const obc_host* host,
                                   obc_frame_field_report* report, obc_error* error) {
  return capi::guarded(error, [&] {
    const Solid solid(given);
    capi::require(report != nullptr, "report is NULL");
    const capi::HostAdapter adapter(host);
    write_report(solid, solid.field(frames), nullptr, adapter.host(), report);
  });
}

obc_status obc_frame_field_matchings(const obc_frame_field_solid* given, const double* frames, const obc_host* host,
                                     uint8_t* matchings, obc_error* error) {
  return capi::guarded(error, [&] {
    const Solid solid(given);
    capi::require(matchings != nullptr, "matchings is NULL");
    const capi::HostAdapter adapter(host);
    const mesh::TetrahedralConnectivity connectivity(solid.positions.size(), solid.tetrahedra, adapter.host());
    const auto result = frame_field::matchings(connectivity, solid.field(frames), adapter.host());
    std::copy(result.begin(), result.end(), matchings);
  });
}

obc_status obc_frame_field_singularities_create(const obc_frame_field_solid* given, const double* frames,
                                                const obc_host* host, obc_frame_field_singularities** out,
                                                obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(out != nullptr, "out is NULL");
    const Solid solid(given);
    const auto field = solid.field(frames);
    auto result = std::make_unique<obc_frame_field_singularities>(host);
    const base::Host& lent = result->host.host();
    const mesh::TetrahedralConnectivity connectivity(solid.positions.size(), solid.tetrahedra, lent);
    result->graph = frame_field::singular_graph(solid.positions, connectivity, field,
                                                frame_field::matchings(connectivity, field, lent), lent);
    result->local = frame_field::meshability(result->graph, connectivity.boundary_vertices(lent.memory), lent.memory);
    *out = result.release();
  });
}

void obc_frame_field_singularities_destroy(obc_frame_field_singularities* singularities) {
  delete singularities;
}

size_t obc_frame_field_singular_edge_count(const obc_frame_field_singularities* singularities) {
  return singularities == nullptr ? 0 : singularities->graph.edges.size();
}

size_t obc_frame_field_singular_curve_count(const obc_frame_field_singularities* singularities) {
  return singularities == nullptr ? 0 : singularities->graph.curves();
}

size_t obc_frame_field_singular_node_count(const obc_frame_field_singularities* singularities) {
  return singularities == nullptr ? 0 : singularities->graph.nodes.size();
}

obc_status obc_frame_field_singularities_copy(const obc_frame_field_singularities* singularities,
                                              uint32_t* edge_vertices, uint8_t* edge_rotations, int8_t* edge_turns,
                                              size_t* curve_begin, uint32_t* curve_edges, uint32_t* nodes,
                                              obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(singularities != nullptr, "singularities is NULL");
    const frame_field::SingularGraph& graph = singularities->graph;
    for (std::size_t e = 0; e < graph.edges.size(); ++e) {
      const frame_field::SingularEdge& edge = graph.edges[e];
      if (edge_vertices != nullptr) std::copy(edge.vertices.begin(), edge.vertices.end(), edge_vertices + 2 * e);
      if (edge_rotations != nullptr) edge_rotations[e] = edge.rotation;
      if (edge_turns != nullptr) edge_turns[e] = edge.turn;
    }
    if (curve_begin != nullptr) std::copy(graph.curve_begin.begin(), graph.curve_begin.end(), curve_begin);
    if (curve_edges != nullptr) std::copy(graph.curve_edges.begin(), graph.curve_edges.end(), curve_edges);
    if (nodes != nullptr) std::copy(graph.nodes.begin(), graph.nodes.end(), nodes);
  });
}

size_t obc_frame_field_unmeshable_edge_count(const obc_frame_field_singularities* singularities) {
  return singularities == nullptr ? 0 : singularities->local.edges.size();
}

size_t obc_frame_field_unmeshable_vertex_count(const obc_frame_field_singularities* singularities) {
  return singularities == nullptr ? 0 : singularities->local.vertices.size();
}

obc_status obc_frame_field_unmeshable_copy(const obc_frame_field_singularities* singularities, uint32_t* edges,
                                           uint32_t* vertices, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(singularities != nullptr, "singularities is NULL");
    const frame_field::Meshability& local = singularities->local;
    if (edges != nullptr) std::copy(local.edges.begin(), local.edges.end(), edges);
    if (vertices != nullptr) std::copy(local.vertices.begin(), local.vertices.end(), vertices);
  });
}

uint32_t obc_frame_field_version(void) {
  return static_cast<uint32_t>(base::version_major * 10000 + base::version_minor * 100 + base::version_patch);
}
