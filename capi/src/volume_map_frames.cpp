// The C functions of volume_map for parameterizations along frames, and for maps as functions of points.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <span>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/threads/pieces.h"
#include "capi/src/entry.h"
#include "capi/src/surface_view.h"
#include "capi/src/tetrahedral_input.h"
#include "mesh/topology/cells.h"
#include "orbicube/volume_map.h"
#include "volume_map/frame_map/computed_frames.h"
#include "volume_map/sampling/point_location.h"

using namespace orbicube;

struct obc_volume_map_frame_map {
  explicit obc_volume_map_frame_map(const obc_host* host) : adapter(host), map(adapter.host().memory) {}

  capi::HostAdapter adapter;
  volume_map::Parameterization map;
};

struct obc_volume_map_locator {
  explicit obc_volume_map_locator(const obc_host* host) : adapter(host), solid(adapter.host().memory) {}

  capi::HostAdapter adapter;
  mesh::Mesh solid;
  std::unique_ptr<volume_map::PointLocator> locator;
};

namespace {

obc_volume_map_frame_map_options default_frame_map_options() {
  obc_volume_map_frame_map_options o{};
  o.struct_size = sizeof o;
  return o;
}

obc_volume_map_frame_map_report empty_frame_map_report() {
  obc_volume_map_frame_map_report r{};
  r.struct_size = sizeof r;
  return r;
}

obc_volume_map_frame_map_report report_of(const volume_map::Parameterization& map) {
  obc_volume_map_frame_map_report r = empty_frame_map_report();
  r.integers_optimal = map.integers_optimal ? 1 : 0;
  r.energy = map.energy;
  r.integer_cost = map.integer_cost;
  r.residual = map.residual;
  r.cell_length = map.cell_length;
  r.inverted = map.inverted;
  r.integers = map.integers;
  r.patches = map.patches;
  r.cut_faces = map.cut_faces;
  r.singular_edges = map.singular_edges.size();
  r.solves = map.solves;
  return r;
}

volume_map::Parameterization parameterize(mesh::Mesh&& solid, const double* frames,
                                          const obc_volume_map_frame_map_options& o, const base::Host& host) {
  const volume_map::ParameterizationOptions options = {.cell_length = o.cell_length, .integer = o.integer != 0};
  volume_map::FramedSolid framed(host.memory);
  for (std::size_t t = 0; frames != nullptr && t < solid.tetrahedra.size(); ++t) {
    const quaternion::Quaternion q{frames[4 * t], frames[4 * t + 1], frames[4 * t + 2], frames[4 * t + 3]};
    // Written so that NaN is refused.
    if (!(std::abs(quaternion::dot(q, q) - 1) < 1e-6))
      throw base::Error("invalid-argument", "the frame of tetrahedron " + std::to_string(t) + " is no unit quaternion");
    framed.frames.push_back(quaternion::normalized(q));
  }
  framed.positions = std::move(solid.positions);
  framed.tetrahedra = std::move(solid.tetrahedra);
  if (frames == nullptr) {
    return volume_map::parameterize_by_computed_frames(framed, o.feature_angle * std::numbers::pi / 180, false, options,
                                                       host);
  }
  return volume_map::parameterize(framed, options, host);
}

}  // namespace

obc_status obc_volume_map_frame_map_options_init(obc_volume_map_frame_map_options* options, size_t struct_size) {
  return capi::init_versioned(options, struct_size, default_frame_map_options());
}

obc_status obc_volume_map_frame_map_report_init(obc_volume_map_frame_map_report* report, size_t struct_size) {
  return capi::init_versioned(report, struct_size, empty_frame_map_report());
}

obc_status obc_volume_map_frame_map_compute(const double* positions, size_t vertex_count, const uint32_t* tetrahedra,
                                            size_t tetrahedron_count, const double* frames,
                                            const obc_volume_map_frame_map_options* options, const obc_host* host,
                                            obc_volume_map_frame_map_report* report, obc_volume_map_frame_map** out,
                                            obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(out != nullptr, "out is NULL");
    *out = nullptr;
    const obc_volume_map_frame_map_options o = capi::copy_versioned(options, default_frame_map_options());
    capi::require(o.integer == 0 || o.integer == 1, "integer is neither 0 nor 1");
    capi::require(o.cell_length >= 0 && std::isfinite(o.cell_length), "cell_length is not a length");
    capi::require(o.feature_angle >= 0 && o.feature_angle <= 180, "feature_angle is not from 0 to 180");
    capi::require(frames == nullptr || !(o.feature_angle > 0), "feature_angle is for frames that are computed");
    auto made = std::make_unique<obc_volume_map_frame_map>(host);
    const base::Host& h = made->adapter.host();
    capi::write_versioned(report, empty_frame_map_report());
    mesh::Mesh solid = capi::solid_of(positions, vertex_count, tetrahedra, tetrahedron_count, h);
    if (solid.tetrahedra.empty()) throw base::Error("no-cells", "no tetrahedra");
    mesh::require_valid_cells(solid, h);
    made->map = parameterize(std::move(solid), frames, o, h);
    capi::write_versioned(report, report_of(made->map));
    *out = made.release();
  });
}

void obc_volume_map_frame_map_destroy(obc_volume_map_frame_map* map) {
  delete map;
}

size_t obc_volume_map_frame_map_tetrahedron_count(const obc_volume_map_frame_map* map) {
  return map != nullptr ? map->map.corners.size() : 0;
}

size_t obc_volume_map_frame_map_singular_edge_count(const obc_volume_map_frame_map* map) {
  return map != nullptr ? map->map.singular_edges.size() : 0;
}

obc_status obc_volume_map_frame_map_copy(const obc_volume_map_frame_map* map, double* parameters, uint8_t* rotations,
                                         double* gaps, uint8_t* cut, uint8_t* labels, uint32_t* singular_edges,
                                         obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(map != nullptr, "map is NULL");
    static_assert(sizeof(map->map.corners[0]) == 12 * sizeof(double) && sizeof(map->map.gap[0]) == 3 * sizeof(double));
    capi::copy(map->map.corners, parameters);
    capi::copy(map->map.rotation, rotations);
    capi::copy(map->map.gap, gaps);
    capi::copy(map->map.cut, cut);
    capi::copy(map->map.label, labels);
    capi::copy(map->map.singular_edges, singular_edges);
  });
}

obc_status obc_volume_map_locator_create(const double* positions, size_t vertex_count, const uint32_t* tetrahedra,
                                         size_t tetrahedron_count, const obc_host* host, obc_volume_map_locator** out,
                                         obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(out != nullptr, "out is NULL");
    *out = nullptr;
    auto made = std::make_unique<obc_volume_map_locator>(host);
    const base::Host& h = made->adapter.host();
    made->solid = capi::solid_of(positions, vertex_count, tetrahedra, tetrahedron_count, h);
    for (const mesh::Tetrahedron& t : made->solid.tetrahedra) {
      for (const mesh::Index v : t) {
        if (v >= vertex_count) throw base::Error("index-range", "a tetrahedron has vertex " + std::to_string(v));
      }
    }
    made->locator = std::make_unique<volume_map::PointLocator>(made->solid.positions, made->solid.tetrahedra, h);
    *out = made.release();
  });
}

void obc_volume_map_locator_destroy(obc_volume_map_locator* locator) {
  delete locator;
}

obc_status obc_volume_map_locator_locate(const obc_volume_map_locator* locator, const double* points,
                                         size_t point_count, const obc_host* host, uint32_t* tetrahedra,
                                         double* weights, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(locator != nullptr, "locator is NULL");
    const auto queries = capi::view<mesh::Vector3>(points, point_count, "points");
    const capi::HostAdapter adapter(host);
    base::for_each_in_pieces(point_count, "locating", adapter.host(), [&](std::size_t i) {
      if (!queries[i].allFinite())
        throw base::Error("invalid-argument", "point " + std::to_string(i) + " is not finite");
      const volume_map::Location found = locator->locator->locate(queries[i]);
      if (tetrahedra != nullptr) tetrahedra[i] = found.tetrahedron;
      if (weights != nullptr) std::copy(found.weight.begin(), found.weight.end(), weights + 4 * i);
    });
  });
}

obc_status obc_volume_map_locator_interpolate(const obc_volume_map_locator* locator, const uint32_t* tetrahedra,
                                              const double* weights, size_t point_count, const double* values,
                                              size_t components, const obc_host* host, double* images,
                                              obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(locator != nullptr, "locator is NULL");
    const volume_map::PointLocator& in = *locator->locator;
    const std::size_t rows = std::max({point_count, in.positions().size(), std::size_t{4}});
    capi::require(components > 0 && components <= PTRDIFF_MAX / sizeof(double) / rows, "components is 0 or too large");
    const auto cells = capi::view<uint32_t>(tetrahedra, point_count, "tetrahedra");
    const auto shares = capi::view<double>(weights, 4 * point_count, "weights");
    const auto at_vertices = capi::view<double>(values, components * in.positions().size(), "values");
    capi::require(images != nullptr || point_count == 0, "images is NULL");
    const capi::HostAdapter adapter(host);
    base::for_each_in_pieces(point_count, "interpolating", adapter.host(), [&](std::size_t i) {
      const std::span<double> image(images + components * i, components);
      std::fill(image.begin(), image.end(), std::numeric_limits<double>::quiet_NaN());
      if (cells[i] == mesh::no_index) return;
      capi::require(cells[i] < in.tetrahedra().size(), "a tetrahedron does not exist");
      const mesh::Tetrahedron& corners = in.tetrahedra()[cells[i]];
      for (std::size_t c = 0; c < components; ++c) {
        double sum = 0;
        for (std::size_t k = 0; k < 4; ++k)
          sum += shares[4 * i + k] * at_vertices[components * corners[k] + c];
        image[c] = sum;
      }
    });
  });
}
