// Frame fields: solids, frames, constraints and options of any kind.
#include "orbicube/frame_field.h"
#include "shapes.h"

using namespace fuzz;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Input in(data, size);
  Host host(in);
  const Shape mesh = solid(in);
  const std::size_t n = mesh.cell_count();
  const obc_frame_field_solid given = {mesh.positions.data(), mesh.vertex_count(), mesh.cells.data(), n};
  std::vector<double> frames = in.one_in(3) ? in.numbers(4 * n) : std::vector<double>(4 * n);
  for (std::size_t i = 0; i < n && in.one_in(2); ++i)
    frames[4 * i] = 1;
  obc_frame_field_options options;
  obc_frame_field_options_init(&options, sizeof options);
  if (in.one_in(2)) {
    options.start = in.choice(4);
    options.method = in.choice(2);
    options.weighting = in.choice(3);
    options.align_boundary = in.choice(2);
    options.rounds = in.byte() % 4;
    options.feature_angle = in.one_in(2) ? in.number() : 0;
    options.relative_gain = in.one_in(2) ? in.number() : 1e-3;
    options.repair = in.choice(3);
  }
  const std::size_t held = in.below(4), along = in.below(4);
  const auto cells = in.indices(held, n), axis_cells = in.indices(along, n);
  auto quaternions = in.one_in(4) ? in.numbers(4 * held) : std::vector<double>(4 * held);
  auto axes = in.one_in(4) ? in.numbers(3 * along) : std::vector<double>(3 * along);
  for (std::size_t i = 0; i < held; ++i)
    quaternions[4 * i + in.below(4)] = 1;
  for (std::size_t i = 0; i < along; ++i)
    axes[3 * i + in.below(3)] = 1;
  const auto weights = in.numbers(held), axis_weights = in.numbers(along);
  obc_frame_field_constraints constraints;
  obc_frame_field_constraints_init(&constraints, sizeof constraints);
  constraints.frame_tetrahedra = cells.data();
  constraints.frames = quaternions.data();
  constraints.frame_count = held;
  constraints.axis_tetrahedra = axis_cells.data();
  constraints.axes = axes.data();
  constraints.axis_count = along;
  if (in.one_in(3)) constraints.frame_weights = weights.data();
  if (in.one_in(3)) constraints.axis_weights = axis_weights.data();

  obc_frame_field_report report;
  obc_frame_field_report_init(&report, sizeof report);
  ok([&](obc_error* e) { return obc_frame_field_measure(&given, frames.data(), host.c(), &report, e); });
  if (ok([&](obc_error* e) {
        return obc_frame_field_compute(&given, &options, in.one_in(2) ? &constraints : nullptr, host.c(), frames.data(),
                                       &report, e);
      })) {
    for (std::size_t i = 0; i < n; ++i) {
      const double* q = &frames[4 * i];
      require(std::abs(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3] - 1) < 1e-9,
              "a frame that is no rotation");
    }
  }
  std::vector<std::uint8_t> rotations(4 * n);
  ok([&](obc_error* e) { return obc_frame_field_matchings(&given, frames.data(), host.c(), rotations.data(), e); });
  obc_frame_field_singularities* found = nullptr;
  if (!ok([&](obc_error* e) {
        return obc_frame_field_singularities_create(&given, frames.data(), host.c(), &found, e);
      }))
    return 0;
  const std::size_t edges = obc_frame_field_singular_edge_count(found),
                    curves = obc_frame_field_singular_curve_count(found);
  std::vector<std::uint32_t> ends(2 * edges), order(edges), nodes(obc_frame_field_singular_node_count(found)),
      bad_edges(obc_frame_field_unmeshable_edge_count(found)),
      bad_vertices(obc_frame_field_unmeshable_vertex_count(found));
  std::vector<std::uint8_t> elements(edges);
  std::vector<std::int8_t> turns(edges);
  std::vector<std::size_t> begin(curves + 1);
  require(ok([&](obc_error* e) {
            return obc_frame_field_singularities_copy(found, ends.data(), elements.data(), turns.data(), begin.data(),
                                                      order.data(), nodes.data(), e);
          }),
          "singularities cannot be copied");
  require(ok([&](obc_error* e) {
            return obc_frame_field_unmeshable_copy(found, bad_edges.data(), bad_vertices.data(), e);
          }),
          "places cannot be copied");
  require_below(ends, mesh.vertex_count(), "a singular edge with a vertex that does not exist");
  require_below(order, edges, "a curve with an edge that does not exist");
  require_below(nodes, mesh.vertex_count(), "a node that does not exist");
  obc_frame_field_singularities_destroy(found);
  return 0;
}
