#include "orbicube/hexmesh.h"

#include <algorithm>
#include <exception>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/catch_all.h"
#include "base/error.h"
#include "base/known_kind.h"
#include "base/version.h"
#include "capi/src/entry.h"
#include "capi/src/surface_view.h"
#include "capi/src/tetrahedral_input.h"
#include "hexmesh/hexmesh.h"
#include "mesh/topology/cells.h"
#include "mesh/topology/surface_check.h"

using namespace orbicube;
using capi::copy;

struct obc_hexmesh {
  explicit obc_hexmesh(const obc_host* host)
      : adapter(host), made(adapter.host().memory), regions(adapter.host().memory) {}

  capi::HostAdapter adapter;
  hexmesh::HexMesh made;
  base::Array<std::int32_t> regions;
  std::vector<hexmesh::MissingFeature> missing;
};

namespace {

obc_hexmesh_options default_options() {
  const hexmesh::Options defaults;
  obc_hexmesh_options o{};
  o.struct_size = sizeof o;
  o.padding = static_cast<std::int32_t>(defaults.padding);
  o.cells = defaults.cells;
  o.corners = defaults.corners;
  o.triangles = defaults.triangles;
  o.seed = defaults.seed;
  o.rounds = defaults.rounds;
  o.method = static_cast<std::int32_t>(defaults.method);
  o.max_hausdorff_percent = defaults.distance;
  o.max_cells = defaults.max_cells;
  o.feature_angle = -1;
  o.features = static_cast<std::int32_t>(defaults.features);
  return o;
}

// Calls a filling function of the caller. Its host is the caller's, with progress that is part of ours; what stops ours
// stops it.
class Filler {
 public:
  Filler(const obc_hexmesh_options& options, const obc_host* host) : fill_(options.fill), user_(options.fill_user) {
    host_.struct_size = sizeof host_;
    host_ = capi::copy_versioned(host, host_);
  }

  mesh::Mesh operator()(std::span<const mesh::Vector3> positions, std::span<const mesh::Triangle> triangles,
                        double max_volume, const base::Host& host) const {
    Report report{&host, nullptr};
    obc_host lent = host_;
    lent.progress = pass_on;
    lent.progress_user = &report;
    lent.fraction = nullptr;
    const obc_surface surface = {reinterpret_cast<const double*>(positions.data()), positions.size(),
                                 reinterpret_cast<const std::uint32_t*>(triangles.data()), triangles.size()};
    obc_mesh* made = nullptr;
    obc_error error{};
    const obc_status status = fill_(&surface, max_volume, &lent, &made, &error, user_);
    const std::unique_ptr<obc_mesh, void (*)(obc_mesh*)> keeper(made, obc_mesh_destroy);
    if (report.stop) std::rethrow_exception(report.stop);
    if (status != OBC_OK) {
      error.kind[sizeof error.kind - 1] = error.message[sizeof error.message - 1] = '\0';
      throw base::Error(base::known_kind(error.kind, static_cast<base::Status>(status)), error.message);
    }
    return checked(made, positions, host);
  }

 private:
  struct Report {
    const base::Host* host;
    std::exception_ptr stop;
  };

  static std::int32_t pass_on(const char* /*phase*/, std::uint64_t done, std::uint64_t total, double best, void* user) {
    auto* const report = static_cast<Report*>(user);
    const auto outcome = [&]() -> std::int32_t {
      // The words of others may not outlive the call.
      report->host->report("tetrahedra", done, total, best);
      return 0;
    };
    return base::catch_all(outcome, [&]() -> std::int32_t {
      report->stop = std::current_exception();
      return 1;
    });
  }

  static mesh::Mesh checked(const obc_mesh* made, std::span<const mesh::Vector3> positions, const base::Host& host) {
    mesh::Mesh solid(host.memory);
    solid.positions.resize(obc_mesh_vertex_count(made));
    solid.tetrahedra.resize(obc_mesh_tetrahedron_count(made));
    if (solid.tetrahedra.empty() || solid.positions.size() < positions.size())
      throw base::Error("no-valid-result", "the filling function made no tetrahedra of the surface");
    obc_error error{};
    if (obc_mesh_copy(made, reinterpret_cast<double*>(solid.positions.data()), nullptr,
                      reinterpret_cast<std::uint32_t*>(solid.tetrahedra.data()), nullptr, &error) != OBC_OK)
      throw base::Error("internal", error.message);
    if (!std::equal(positions.begin(), positions.end(), solid.positions.begin()))
      throw base::Error("no-valid-result", "the filling function moved vertices of the surface");
    return solid;
  }

  obc_hexmesh_fill_function fill_;
  void* user_;
  obc_host host_{};
};

hexmesh::Options options_of(const obc_hexmesh_options& o, const obc_host* host) {
  capi::require(o.padding >= OBC_HEXMESH_PADDING_AUTO && o.padding <= OBC_HEXMESH_PADDING_WITHOUT,
                "options->padding is none of the constants");
  capi::require(o.method >= OBC_HEXMESH_METHOD_AUTO && o.method <= OBC_HEXMESH_METHOD_FRAMES,
                "options->method is none of the constants");
  capi::require(o.feature_angle == -1 || (o.feature_angle >= 0 && o.feature_angle < 180),
                "options->feature_angle is out of range");
  capi::require(o.features >= OBC_HEXMESH_FEATURES_OFF && o.features <= OBC_HEXMESH_FEATURES_MACHINED,
                "options->features is none of the constants");
  capi::require(o.tagged_edges != nullptr || o.tagged_edge_count == 0, "options->tagged_edges is NULL");
  capi::require(o.tagged_vertices != nullptr || o.tagged_vertex_count == 0, "options->tagged_vertices is NULL");
  hexmesh::Options options;
  options.method = static_cast<hexmesh::Method>(o.method);
  options.padding = static_cast<hexmesh::Padding>(o.padding);
  options.cells = o.cells;
  options.corners = o.corners;
  options.triangles = o.triangles;
  options.seed = o.seed;
  options.rounds = o.rounds;
  options.distance = o.max_hausdorff_percent;
  options.max_cells = o.max_cells;
  if (o.feature_angle >= 0) options.feature_angle = o.feature_angle;
  options.features = static_cast<hexmesh::Features>(o.features);
  options.tagged_edges = {reinterpret_cast<const mesh::Edge*>(o.tagged_edges), o.tagged_edge_count};
  options.tagged_vertices = {o.tagged_vertices, o.tagged_vertex_count};
  if (o.fill != nullptr) options.fill = Filler(o, host);
  return options;
}

obc_hexmesh_report report_of(const hexmesh::Hexahedra& made) {
  obc_hexmesh_report r{};
  r.struct_size = sizeof r;
  r.padded = made.result.padded ? 1 : 0;
  r.min_scaled_jacobian = made.result.quality.min_scaled_jacobian;
  r.mean_scaled_jacobian = made.result.quality.mean_scaled_jacobian;
  r.volume = made.result.quality.volume;
  r.polycube_corners = made.polycube_corners;
  r.off_surface = made.result.off_surface;
  r.hausdorff_percent = made.result.distance;
  r.volume_error_percent = made.result.volume_error;
  r.follows_sharp_edges = made.result.follows_sharp_edges ? 1 : 0;
  r.grid_based = made.result.grid_based ? 1 : 0;
  r.method = static_cast<std::int32_t>(made.method);
  if (made.features) {
    r.feature_curves = made.features->curves;
    r.feature_corners = made.features->corners;
    r.missing_features = made.features->missing.size();
    r.captured = made.features->captured;
    r.scaled_jacobian_bound = made.features->bound;
    r.embedded = made.features->replaced ? 1 : 0;
  }
  if (made.regions) {
    r.conforming = made.regions->conforming ? 1 : 0;
    r.region_quads = made.regions->interface_quads;
    r.region_hausdorff_percent = made.regions->distance;
  }
  if (!made.along_frames) return r;
  r.integers_optimal = made.along_frames->integers_optimal ? 1 : 0;
  r.singular_edges = made.along_frames->singular_edges;
  r.irregular_edges = made.along_frames->inner_irregular_edges;
  r.integers = made.along_frames->integers;
  r.tetrahedra = made.along_frames->tetrahedra;
  r.inverted_at_start = made.along_frames->inverted_at_start;
  r.steps = made.along_frames->steps;
  r.fields = made.along_frames->fields;
  return r;
}

base::Array<quaternion::Quaternion> frames_of(const double* frames, std::size_t count, const base::Host& host) {
  base::Array<quaternion::Quaternion> result(host.memory);
  if (frames == nullptr) return result;
  const auto* const first = reinterpret_cast<const quaternion::Quaternion*>(frames);
  result.assign(first, first + count);
  for (quaternion::Quaternion& q : result) {
    const double square = dot(q, q);
    capi::require(square > 1e-12 && square < 1e12, "a frame is zero or not finite");
    q = quaternion::normalized(q);
  }
  return result;
}

// The mesh of `input`, which makes one for a host, with these options.
template <class Input>
void compute(const Input& input, const double* frames, const obc_hexmesh_options* options, const obc_host* host,
             obc_hexmesh_report* report, obc_hexmesh** out) {
  capi::require(out != nullptr, "out is NULL");
  *out = nullptr;
  const obc_hexmesh_options o = capi::copy_versioned(options, default_options());
  hexmesh::Options chosen = options_of(o, host);
  auto made = std::make_unique<obc_hexmesh>(host);
  const base::Host& h = made->adapter.host();
  mesh::Mesh given = input(h);
  capi::require(o.regions != nullptr || o.region_count == 0, "options->regions is NULL");
  capi::require(o.region_count == 0 || o.region_count == given.tetrahedra.size(),
                "options->region_count must be the number of tetrahedra");
  given.regions.tetrahedra.assign(o.regions, o.regions + o.region_count);
  const base::Array<quaternion::Quaternion> directions = frames_of(frames, given.tetrahedra.size(), h);
  chosen.frames = directions;
  volume_map::InputFindings findings;
  findings.on_note = [&](const std::string& text) { h.log(text); };
  hexmesh::Hexahedra result = hexmesh::make_hexahedra(given, chosen, findings, h);
  capi::write_versioned(report, report_of(result));
  made->made = std::move(result.result.mesh);
  if (result.regions) made->regions = std::move(result.regions->of_hexahedra);
  if (result.features) made->missing = std::move(result.features->missing);
  *out = made.release();
}

}  // namespace

obc_status obc_hexmesh_options_init(obc_hexmesh_options* options, size_t struct_size) {
  return capi::init_versioned(options, struct_size, default_options());
}

obc_status obc_hexmesh_compute(const obc_surface* surface, const obc_hexmesh_options* options, const obc_host* host,
                               obc_hexmesh_report* report, obc_hexmesh** out, obc_error* error) {
  return capi::guarded(error, [&] {
    const auto input = [&](const base::Host& h) {
      const capi::SurfaceView s(surface);
      mesh::require_valid_surface(s.positions, s.triangles, h);
      mesh::Mesh given(h.memory);
      given.positions.assign(s.positions.begin(), s.positions.end());
      given.triangles.assign(s.triangles.begin(), s.triangles.end());
      return given;
    };
    compute(input, nullptr, options, host, report, out);
  });
}

obc_status obc_hexmesh_compute_solid(const double* positions, size_t vertex_count, const uint32_t* tetrahedra,
                                     size_t tetrahedron_count, const double* frames, const obc_hexmesh_options* options,
                                     const obc_host* host, obc_hexmesh_report* report, obc_hexmesh** out,
                                     obc_error* error) {
  return capi::guarded(error, [&] {
    const auto input = [&](const base::Host& h) {
      mesh::Mesh given = capi::solid_of(positions, vertex_count, tetrahedra, tetrahedron_count, h);
      if (given.tetrahedra.empty()) throw base::Error("no-cells", "no tetrahedra");
      mesh::require_valid_cells(given, h);
      return given;
    };
    compute(input, frames, options, host, report, out);
  });
}

void obc_hexmesh_destroy(obc_hexmesh* hexes) {
  delete hexes;
}

size_t obc_hexmesh_vertex_count(const obc_hexmesh* hexes) {
  return hexes != nullptr ? hexes->made.positions.size() : 0;
}

size_t obc_hexmesh_count(const obc_hexmesh* hexes) {
  return hexes != nullptr ? hexes->made.hexahedra.size() : 0;
}

size_t obc_hexmesh_quad_count(const obc_hexmesh* hexes) {
  return hexes != nullptr ? hexes->made.quads.size() : 0;
}

obc_status obc_hexmesh_copy(const obc_hexmesh* hexes, double* positions, uint32_t* hexahedra, uint32_t* quads,
                            uint32_t* quad_patches, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(hexes != nullptr, "hexes is NULL");
    copy(hexes->made.positions, positions);
    copy(hexes->made.hexahedra, hexahedra);
    copy(hexes->made.quads, quads);
    copy(hexes->made.quad_patches, quad_patches);
  });
}

obc_status obc_hexmesh_copy_regions(const obc_hexmesh* hexes, int32_t* regions, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(hexes != nullptr, "hexes is NULL");
    capi::require(regions != nullptr, "regions is NULL");
    std::fill_n(regions, hexes->made.hexahedra.size(), 0);
    copy(hexes->regions, regions);
  });
}

size_t obc_hexmesh_missing_count(const obc_hexmesh* hexes) {
  return hexes != nullptr ? hexes->missing.size() : 0;
}

obc_status obc_hexmesh_get_missing(const obc_hexmesh* hexes, size_t index, obc_hexmesh_missing* missing,
                                   obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(hexes != nullptr, "hexes is NULL");
    capi::require(missing != nullptr, "missing is NULL");
    capi::require(index < hexes->missing.size(), "index is not below obc_hexmesh_missing_count");
    const hexmesh::MissingFeature& of = hexes->missing[index];
    obc_hexmesh_missing m{};
    m.struct_size = sizeof m;
    m.corner = of.corner ? 1 : 0;
    std::copy_n(of.from.data(), 3, m.first);
    std::copy_n(of.to.data(), 3, m.last);
    m.captured = of.captured;
    capi::write_versioned(missing, m);
  });
}

const char* obc_hexmesh_missing_reason(const obc_hexmesh* hexes, size_t index) {
  return hexes != nullptr && index < hexes->missing.size() ? hexes->missing[index].why.c_str() : nullptr;
}

uint32_t obc_hexmesh_version(void) {
  return static_cast<uint32_t>(base::version_major * 10000 + base::version_minor * 100 + base::version_patch);
}
