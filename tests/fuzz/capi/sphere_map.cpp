// Sphere maps: surfaces, directions, weights, grids and images of any kind.
#include "orbicube/sphere_map.h"
#include "scratch.h"
#include "shapes.h"

using namespace fuzz;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Input in(data, size);
  Host host(in);
  const Shape shape = surface(in), second = surface(in);
  const obc_surface given = shape.surface(), also = second.surface();
  const std::size_t n = shape.vertex_count();
  obc_sphere_map_options options;
  obc_sphere_map_options_init(&options, sizeof options);
  options.method = in.choice(6);
  if (in.one_in(3)) options.angle_weight = in.number();
  if (in.one_in(3)) options.area_weight = in.number();
  options.seed = in.byte();
  if (in.one_in(3)) options.level_splits = in.byte();
  if (in.one_in(3)) options.level_tolerance = in.number();
  if (in.one_in(3)) options.final_tolerance = in.number();
  if (in.one_in(3)) options.max_level_iterations = in.byte();
  if (in.one_in(3)) options.max_final_iterations = in.byte();
  obc_sphere_map_report report;
  obc_sphere_map_report_init(&report, sizeof report);
  std::vector<double> directions = in.one_in(2) ? in.numbers(3 * n) : shape.positions;
  if (in.one_in(2)) {
    if (ok([&](obc_error* e) {
          return obc_sphere_map_compute(&given, &options, host.c(), directions.data(), &report, e);
        })) {
      require_finite(directions, "a direction that is not finite");
      require(report.bijective == 1, "a map that is no bijection");
    }
  } else if (in.one_in(2)) {
    std::size_t placed = 0;
    ok([&](obc_error* e) {
      return obc_sphere_map_compute_partial(&given, &options, host.c(), directions.data(), &placed, &report, e);
    });
    require(placed <= n, "more vertices have places than there are");
  }
  ok([&](obc_error* e) { return obc_sphere_map_measure(&given, directions.data(), &options, host.c(), &report, e); });
  std::vector<double> quasi_conformal(shape.cell_count()), ratio(shape.cell_count());
  ok([&](obc_error* e) {
    return obc_sphere_map_face_distortion(&given, directions.data(), host.c(), quasi_conformal.data(), ratio.data(), e);
  });
  std::vector<float> rounded(3 * n);
  ok([&](obc_error* e) {
    return obc_sphere_map_round_to_float(&given, directions.data(), host.c(), rounded.data(), e);
  });

  const std::int32_t grid = in.choice(4);
  const std::size_t resolution = in.one_in(20) ? in.bits() : in.below(grid == OBC_SPHERE_MAP_ICOSPHERE ? 3 : 9);
  const std::size_t fine = grid == OBC_SPHERE_MAP_ICOSPHERE ? 4 : 64;  // a request must end
  const bool small = resolution <= fine || resolution > 1u << 20;
  obc_mesh* mesh = nullptr;
  if (small && ok([&](obc_error* e) { return obc_sphere_map_grid(grid, resolution, host.c(), &mesh, e); }))
    obc_mesh_destroy(mesh);
  const auto asked = in.numbers(9), warp_ends = in.one_in(2) ? in.moderates(9) : in.numbers(9);
  obc_sphere_map_locator* locator = nullptr;
  if (ok([&](obc_error* e) {
        return obc_sphere_map_locator_create(&given, directions.data(), host.c(), &locator, e);
      })) {
    std::uint32_t triangles[3];
    double weights[9];
    if (ok([&](obc_error* e) {
          return obc_sphere_map_locate(locator, asked.data(), 3, host.c(), triangles, weights, e);
        }))
      require_below(triangles, shape.cell_count(), "a direction lies in no triangle");
    const auto values = in.numbers(2 * n);
    double sampled[6];
    ok([&](obc_error* e) {
      return obc_sphere_map_sample(locator, asked.data(), 3, values.data(), 2, in.choice(2), host.c(), sampled, e);
    });
    if (small && ok([&](obc_error* e) {
          return obc_sphere_map_remesh(locator, shape.positions.data(), grid, resolution, host.c(), &mesh, e);
        }))
      obc_mesh_destroy(mesh);
    std::size_t width = 0, height = 0;
    if (small && ok([&](obc_error* e) { return obc_sphere_map_image_size(grid, resolution, &width, &height, e); }) &&
        width <= 1024) {
      std::vector<double> pixels(3 * width * height);
      ok([&](obc_error* e) {
        return obc_sphere_map_image(locator, shape.positions.data(), grid, resolution, host.c(), pixels.data(), e);
      });
      for (std::size_t i = in.below(3); i > 0 && !pixels.empty(); --i)
        pixels[in.bits() % pixels.size()] = in.number();
      double gap = 0;
      if (ok([&](obc_error* e) {
            return obc_sphere_map_image_surface(pixels.data(), grid, resolution, host.c(), &mesh, &gap, e);
          }))
        obc_mesh_destroy(mesh);
      if (in.one_in(6)) {
        const Scratch file(in.one_in(2) ? ".pfm" : ".png");
        ok([&](obc_error* e) {
          return obc_sphere_map_image_write(file.path(), pixels.data(), grid, resolution, host.c(), e);
        });
      }
    }
    obc_sphere_map_locator_destroy(locator);
  }
  double rotation[9];
  ok([&](obc_error* e) { return obc_sphere_map_best_rotation(asked.data(), warp_ends.data(), 3, rotation, e); });
  obc_sphere_map_warp* warp = nullptr;
  const std::size_t landmarks = in.below(4);
  if (ok([&](obc_error* e) {
        return obc_sphere_map_warp_create(warp_ends.data(), asked.data(), landmarks, host.c(), &warp, e);
      })) {
    double moved[9];
    ok([&](obc_error* e) {
      return obc_sphere_map_warp_apply(warp, warp_ends.data(), 3, in.choice(2), host.c(), moved, e);
    });
    obc_sphere_map_warp_destroy(warp);
  }
  const auto other = in.one_in(2) ? second.positions : in.numbers(second.positions.size());
  std::vector<std::uint32_t> where(second.vertex_count());
  if (ok([&](obc_error* e) {
        return obc_sphere_map_overlay(&given, directions.data(), &also, other.data(), host.c(), &mesh, where.data(), e);
      })) {
    for (const std::uint32_t vertex : where)
      require(vertex < obc_mesh_vertex_count(mesh) || vertex == UINT32_MAX, "a vertex of the second map is nowhere");
    obc_mesh_destroy(mesh);
  }
  if (in.one_in(6)) {
    const Scratch file(in.one_in(2) ? ".pfm" : ".png");
    std::vector<std::uint8_t> bytes;
    for (const char c : {'P', 'F', '\n', '4', ' ', '4', '\n', '-', '1', '\n'})
      bytes.push_back(in.one_in(30) ? in.byte() : static_cast<std::uint8_t>(c));
    bytes.insert(bytes.end(), in.rest().begin(), in.rest().end());
    file.write(bytes);
    std::int32_t layout = 0;
    std::size_t pixels = 0;
    std::vector<double> image(1000);
    ok([&](obc_error* e) {
      return obc_sphere_map_image_read(file.path(), host.c(), &layout, &pixels, image.data(), image.size(), e);
    });
  }
  return 0;
}
