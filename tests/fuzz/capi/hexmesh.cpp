// Hexahedra of small shapes with faults, along frames of any kind too, with a filling function that may do anything.
#include "orbicube/hexmesh.h"

#include <algorithm>

#include "shapes.h"

using namespace fuzz;

namespace {

// The vertices of the surface and a fan of tetrahedra around the first, another mesh, or an error.
obc_status make_any(const obc_surface* surface, double /*max_volume*/, const obc_host* host, obc_mesh** out,
                    obc_error* error, void* user) {
  Input& in = *static_cast<Input*>(user);
  if (in.one_in(10)) return OBC_NO_VALID_RESULT;
  Shape other;
  std::vector<std::uint32_t> fan;
  obc_mesh_cells cells;
  obc_mesh_cells_init(&cells, sizeof cells);
  cells.positions = surface->positions;
  cells.vertex_count = surface->vertex_count;
  if (in.one_in(3)) {
    other = solid(in);
    cells.positions = other.positions.data();
    cells.vertex_count = other.vertex_count();
    cells.tetrahedra = other.cells.data();
    cells.tetrahedron_count = other.cell_count();
  } else {
    for (std::size_t t = 0; t < surface->triangle_count; ++t)
      fan.insert(fan.end(),
                 {0, surface->triangles[3 * t], surface->triangles[3 * t + 1], surface->triangles[3 * t + 2]});
    cells.tetrahedra = fan.data();
    cells.tetrahedron_count = fan.size() / 4;
  }
  return obc_mesh_create(&cells, host, out, error);
}

void fill_with_hexahedra(Input& in, Host& host) {
  const Shape shape = surface(in);
  const obc_surface given = shape.surface();
  obc_hexmesh_options options;
  obc_hexmesh_options_init(&options, sizeof options);
  options.cells = in.one_in(20) ? in.bits() : 1 + in.below(60);
  if (options.cells > 1000 && options.cells <= 10'000'000) return;  // must end
  options.padding = in.choice(3);
  options.method = in.choice(4);
  options.corners = in.one_in(3) ? 8 : in.byte();
  options.triangles = in.one_in(3) ? in.byte() : 0;
  options.seed = in.byte();
  options.rounds = in.one_in(20) ? -1 : static_cast<std::int32_t>(in.below(5));
  options.max_hausdorff_percent = in.one_in(20) ? -1 : static_cast<double>(in.below(20));
  options.max_cells = in.one_in(20) ? in.bits() : in.below(200);
  if (options.max_hausdorff_percent > 0 && options.max_cells > 1000 && options.max_cells <= 10'000'000) return;
  options.feature_angle = in.one_in(20) ? -1 : static_cast<double>(in.below(180));
  if (in.one_in(2)) options.fill = make_any;
  options.fill_user = &in;
  obc_hexmesh_report report;
  report.struct_size = sizeof report;
  obc_hexmesh* hexes = nullptr;
  if (!ok([&](obc_error* e) { return obc_hexmesh_compute(&given, &options, host.c(), &report, &hexes, e); })) return;
  const std::size_t n = obc_hexmesh_vertex_count(hexes), m = obc_hexmesh_count(hexes),
                    q = obc_hexmesh_quad_count(hexes);
  std::vector<double> positions(3 * n);
  std::vector<std::uint32_t> hexahedra(8 * m), quads(4 * q), faces(q);
  require(ok([&](obc_error* e) {
            return obc_hexmesh_copy(hexes, positions.data(), hexahedra.data(), quads.data(), faces.data(), e);
          }),
          "hexahedra cannot be copied");
  obc_hexmesh_destroy(hexes);
  require_finite(positions, "a vertex of hexahedra that is not finite");
  require_below(hexahedra, n, "a hexahedron with a vertex that does not exist");
  require_below(quads, n, "a quad with a vertex that does not exist");
  require(m > 0 && q > 0 && report.min_scaled_jacobian > 0 && report.mean_scaled_jacobian <= 1 && report.volume > 0,
          "certified hexahedra with figures that are none");
}

void fill_along_frames(Input& in, Host& host) {
  const Shape mesh = solid(in);
  std::vector<double> frames(4 * mesh.cell_count());
  const bool one = in.one_in(2);
  for (std::size_t i = 0; i < frames.size(); ++i)
    frames[i] = one && i >= 4 ? frames[i - 4] : in.one_in(30) ? in.number() : in.moderate();
  obc_hexmesh_options options;
  obc_hexmesh_options_init(&options, sizeof options);
  options.cells = in.one_in(20) ? in.bits() : 1 + in.below(60);
  if (options.cells > 1000 && options.cells <= 10'000'000) return;  // must end
  options.rounds = in.one_in(20) ? -1 : static_cast<std::int32_t>(in.below(4));
  options.method = in.one_in(3) ? in.choice(4) : OBC_HEXMESH_METHOD_FRAMES;
  if (in.one_in(3)) options.feature_angle = in.number();
  if (in.one_in(3)) options.max_hausdorff_percent = in.number();
  options.max_cells = in.below(200);
  obc_hexmesh_report report;
  report.struct_size = sizeof report;
  obc_hexmesh* hexes = nullptr;
  if (!ok([&](obc_error* e) {
        return obc_hexmesh_compute_solid(mesh.positions.data(), mesh.vertex_count(), mesh.cells.data(),
                                         mesh.cell_count(), in.one_in(3) ? nullptr : frames.data(), &options, host.c(),
                                         &report, &hexes, e);
      }))
    return;
  const std::size_t n = obc_hexmesh_vertex_count(hexes), m = obc_hexmesh_count(hexes);
  std::vector<double> positions(3 * n);
  std::vector<std::uint32_t> hexahedra(8 * m);
  require(ok([&](obc_error* e) {
            return obc_hexmesh_copy(hexes, positions.data(), hexahedra.data(), nullptr, nullptr, e);
          }),
          "hexahedra along frames cannot be copied");
  obc_hexmesh_destroy(hexes);
  require_finite(positions, "a vertex of hexahedra that is not finite");
  require_below(hexahedra, n, "a hexahedron with a vertex that does not exist");
  require(m > 0 && report.min_scaled_jacobian > 0 && report.volume > 0,
          "certified hexahedra with figures that are none");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Input in(data, size);
  Host host(in);
  in.one_in(2) ? fill_with_hexahedra(in, host) : fill_along_frames(in, host);
  return 0;
}
