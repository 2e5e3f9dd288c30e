// Polycubes: maps made elsewhere, polycubes of small surfaces, on given ones, features, graphs and quads.
#include <algorithm>

#include "orbicube/polycube.h"
#include "shapes.h"

using namespace fuzz;

namespace {

void look_at_atlas(const obc_polycube* map, Input& in, Host& host) {
  obc_polycube_atlas_options square;
  obc_polycube_atlas_options_init(&square, sizeof square);
  square.size = in.one_in(20) ? static_cast<std::uint32_t>(in.bits()) : in.byte();
  if (in.one_in(4)) square.padding = in.number();
  obc_polycube_atlas* atlas = nullptr;
  if (square.size > 256 ||
      !ok([&](obc_error* e) { return obc_polycube_atlas_create(map, &square, host.c(), &atlas, e); }))
    return;
  const std::size_t count = std::size_t{square.size} * square.size;
  std::vector<double> at(6 * obc_polycube_atlas_triangle_count(atlas)), weights(3 * count);
  std::vector<std::uint32_t> triangles(count);
  std::vector<std::uint8_t> covered(count);
  require(ok([&](obc_error* e) { return obc_polycube_atlas_copy(atlas, at.data(), nullptr, nullptr, e); }),
          "an atlas cannot be copied");
  for (const double x : at)
    require(x >= 0 && x <= 1, "a corner outside of the texture");
  if (ok([&](obc_error* e) {
        return obc_polycube_atlas_sample(atlas, host.c(), triangles.data(), weights.data(), covered.data(), e);
      })) {
    for (std::size_t i = 0; i < count; ++i) {
      require(covered[i] == 0 || triangles[i] < obc_polycube_triangle_count(map), "a texel of no triangle");
      require(weights[3 * i] >= 0 && weights[3 * i + 1] >= 0 && weights[3 * i + 2] >= 0, "a weight below zero");
    }
  }
  obc_polycube_atlas_destroy(atlas);
}

void look_at(const obc_polycube* map, Input& in, Host& host) {
  const std::size_t n = obc_polycube_vertex_count(map), m = obc_polycube_triangle_count(map);
  std::vector<double> positions(3 * n), polycube(3 * n), weights(3 * n);
  std::vector<std::uint32_t> triangles(3 * m), patches(m), sources(m), corners(3 * n);
  std::vector<std::uint8_t> labels(m);
  require(ok([&](obc_error* e) {
            return obc_polycube_copy(map, positions.data(), polycube.data(), triangles.data(), e);
          }) &&
              ok([&](obc_error* e) {
                return obc_polycube_copy_triangles(map, labels.data(), patches.data(), sources.data(), e);
              }) &&
              ok([&](obc_error* e) { return obc_polycube_copy_sources(map, corners.data(), weights.data(), e); }),
          "a map cannot be copied");
  require_below(triangles, n, "a triangle with a vertex that does not exist");
  require_below(patches, obc_polycube_patch_count(map), "a triangle in no patch");
  obc_polycube* again = nullptr;
  const obc_surface surface = {positions.data(), n, triangles.data(), m};
  const std::size_t faults = in.below(3);
  auto spoiled = polycube;
  for (std::size_t i = 0; i < faults; ++i)
    spoiled[in.bits() % spoiled.size()] = in.number();
  obc_polycube_certificate certificate;
  certificate.struct_size = sizeof certificate;
  if (ok([&](obc_error* e) {
        return obc_polycube_create(&surface, spoiled.data(), host.c(), &certificate, &again, e);
      })) {
    require(certificate.valid == 1, "a handle of what is not certified");
    obc_polycube_destroy(again);
  }

  obc_polycube_domain_options domain;
  obc_polycube_domain_options_init(&domain, sizeof domain);
  if (in.one_in(2)) {
    domain.measure = in.choice(3);
    domain.area_weight = in.number();
  }
  if (in.one_in(3) &&
      ok([&](obc_error* e) { return obc_polycube_optimize_domain(map, &domain, host.c(), nullptr, &again, e); })) {
    std::vector<double> energies(obc_polycube_energy_count(again));
    require(ok([&](obc_error* e) { return obc_polycube_copy_energies(again, energies.data(), e); }), "no energies");
    for (std::size_t i = 1; i < energies.size(); ++i)
      require(energies[i] <= energies[i - 1], "an energy that rises");
    obc_polycube_destroy(again);
  }
  obc_polycube_corner_options moving;
  obc_polycube_corner_options_init(&moving, sizeof moving);
  moving.rounds = in.one_in(9) ? in.choice(2) - 1 : 1;
  if (in.one_in(2)) {
    moving.method = in.choice(2);
    moving.area_weight = in.number();
    moving.domain = in.choice(2);
    if (moving.rounds > 3) moving.rounds = 3;
  }
  if (in.one_in(6) &&
      ok([&](obc_error* e) { return obc_polycube_optimize_corners(map, &moving, host.c(), nullptr, &again, e); }))
    obc_polycube_destroy(again);

  const std::size_t points = in.below(3), curves = in.below(3);
  const auto vertices = in.indices(points, n), along = in.indices(3 * curves, n);
  auto places = in.one_in(3) ? in.numbers(3 * points) : std::vector<double>(3 * points);
  for (std::size_t i = 0; i < points && vertices[i] < n; ++i)
    std::copy_n(&polycube[3 * (in.bits() % n)], 3, &places[3 * i]);
  auto lines = in.numbers(6 * curves);
  for (std::size_t i = 0; i < curves; ++i) {
    std::copy_n(&polycube[3 * (in.bits() % n)], 3, &lines[6 * i]);
    std::copy_n(&lines[6 * i], 3, &lines[6 * i + 3]);
    lines[6 * i + 3 + in.below(3)] = polycube[in.bits() % polycube.size()];
  }
  std::vector<std::uint32_t> starts = {0};
  for (std::size_t i = 0; i < curves; ++i)
    starts.push_back(starts.back() + static_cast<std::uint32_t>(in.below(4)));
  const auto point_weights = in.numbers(points), curve_weights = in.numbers(curves);
  obc_polycube_feature_options features;
  obc_polycube_feature_options_init(&features, sizeof features);
  features.point_count = points;
  features.points = vertices.data();
  features.targets = places.data();
  if (in.one_in(2)) features.point_weights = point_weights.data();
  features.curve_count = curves;
  features.curve_starts = starts.data();
  features.curve_vertices = along.data();
  features.curve_lines = lines.data();
  if (in.one_in(2)) features.curve_weights = curve_weights.data();
  if (in.one_in(3)) features.feature_angle = in.number();
  obc_polycube_feature_report report;
  report.struct_size = sizeof report;
  if (in.one_in(2) &&
      ok([&](obc_error* e) { return obc_polycube_align_features(map, &features, host.c(), &report, &again, e); }))
    obc_polycube_destroy(again);

  obc_polycube_graph* graph = nullptr;
  if (ok([&](obc_error* e) { return obc_polycube_graph_create(map, host.c(), &graph, e); })) {
    std::vector<std::uint32_t> begin(obc_polycube_graph_loop_count(graph) + 1),
        darts(2 * obc_polycube_graph_edge_count(graph));
    require(ok([&](obc_error* e) { return obc_polycube_graph_copy_loops(graph, begin.data(), darts.data(), e); }),
            "no loops");
    require_below(darts, darts.size(), "a dart that does not exist");
    require(begin.back() == darts.size(), "loops without some darts");
    obc_polycube_graph_destroy(graph);
  }
  look_at_atlas(map, in, host);
  obc_polycube_quads_options fine;
  obc_polycube_quads_options_init(&fine, sizeof fine);
  fine.quads = in.one_in(20) ? in.bits() : in.byte();
  if (in.one_in(4)) fine.edge_length = in.number();
  if ((fine.quads > 10000 && fine.quads < 1000000000) || (fine.edge_length > 0 && fine.edge_length < 0.05))
    return;  // must end
  obc_polycube_quads* quads = nullptr;
  if (ok([&](obc_error* e) { return obc_polycube_quads_create(map, &fine, host.c(), &quads, e); })) {
    const std::size_t k = obc_polycube_quads_vertex_count(quads), l = obc_polycube_quads_quad_count(quads);
    std::vector<double> in_space(3 * k), on_it(3 * k);
    std::vector<std::uint32_t> four(4 * l), of(l);
    require(ok([&](obc_error* e) {
              return obc_polycube_quads_copy(quads, in_space.data(), on_it.data(), four.data(), of.data(), e);
            }),
            "no quads");
    require_below(four, k, "a quad with a vertex that does not exist");
    require_finite(in_space, "a vertex of quads that is not finite");
    obc_polycube_quads_destroy(quads);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Input in(data, size);
  Host host(in);
  // A cube is a polycube: its map to itself, whole and spoiled.
  Shape cube = {
      {0, 0, 0, 2, 0, 0, 0, 2, 0, 2, 2, 0, 0, 0, 2, 2, 0, 2, 0, 2, 2, 2, 2, 2},
      {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5},
      3};
  if (in.one_in(2)) cube = refined(cube);
  const std::vector<double> places = cube.positions;
  if (in.one_in(2)) spoil(cube, in);
  auto target = places;
  target.resize(cube.positions.size(), in.number());
  obc_surface given = cube.surface();
  obc_polycube_certificate certificate;
  certificate.struct_size = sizeof certificate;
  obc_polycube* map = nullptr;
  if (ok([&](obc_error* e) { return obc_polycube_create(&given, target.data(), host.c(), &certificate, &map, e); })) {
    look_at(map, in, host);
    if (in.one_in(4)) {
      obc_polycube* out[2];
      const obc_polycube* both[2] = {map, in.one_in(9) ? nullptr : map};
      const std::size_t maps = in.below(3);
      if (ok([&](obc_error* e) {
            return obc_polycube_optimize_common_domain(both, maps, nullptr, host.c(), out, e);
          })) {
        for (std::size_t i = 0; i < maps; ++i)
          obc_polycube_destroy(out[i]);
      }
    }
    obc_polycube_destroy(map);
  }
  const Shape shape = surface(in);
  given = shape.surface();
  obc_polycube_options options;
  obc_polycube_options_init(&options, sizeof options);
  options.construction = in.choice(3);
  // The more corners there may be, the longer the search, whatever the surface: few as a rule.
  options.corners = in.one_in(16) ? in.byte() : 8 + in.below(24);
  options.seed = in.byte();
  if (in.one_in(4) && ok([&](obc_error* e) { return obc_polycube_compute(&given, &options, host.c(), &map, e); })) {
    look_at(map, in, host);
    obc_polycube_destroy(map);
  }
  const std::size_t count = in.below(4);
  const auto corners = in.indices(count, 8), vertices = in.indices(count, shape.vertex_count());
  const auto points = in.numbers(3 * count);
  const obc_polycube_constraints where = {corners.data(), in.one_in(2) ? vertices.data() : nullptr,
                                          in.one_in(3) ? nullptr : points.data(), count};
  const obc_surface on = {places.data(), places.size() / 3, cube.cells.data(), cube.cell_count()};
  if (in.one_in(4) && ok([&](obc_error* e) {
        return obc_polycube_map_to_domain(&given, &on, in.one_in(2) ? &where : nullptr, host.c(), &map, e);
      })) {
    look_at(map, in, host);
    obc_polycube_destroy(map);
  }
  if (in.one_in(10)) {
    const obc_surface two[] = {given, on};
    obc_polycube* out[2];
    std::size_t constructed_from = 9;
    const std::size_t shapes = in.below(3);
    if (ok([&](obc_error* e) {
          return obc_polycube_compute_common(two, shapes, &options, nullptr, host.c(), &constructed_from, out, e);
        })) {
      require(constructed_from < shapes, "made for no shape");
      for (std::size_t i = 0; i < shapes; ++i)
        obc_polycube_destroy(out[i]);
    }
  }
  return 0;
}
