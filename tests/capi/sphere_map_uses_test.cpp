// The C functions of sphere_map that use a map: what they promise about arguments, memory, cancelling and threads.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "failing_allocations.h"
#include "orbicube/sphere_map.h"

using namespace orbicube;

namespace {

// An octahedron, each triangle split in four `levels` times: a surface whose directions are a map.
struct Ball {
  std::vector<double> positions{2, 0, 0, -2, 0, 0, 0, 2, 0, 0, -2, 0, 0, 0, 2, 0, 0, -2};
  std::vector<std::uint32_t> triangles{0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
  std::vector<double> directions;

  explicit Ball(int levels) {
    for (int level = 0; level < levels; ++level) {
      std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
      const auto middle = [&](std::uint32_t a, std::uint32_t b) {
        const auto [entry, is_new] =
            middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(positions.size() / 3));
        for (std::size_t k = 0; is_new && k < 3; ++k)
          positions.push_back((positions[3 * a + k] + positions[3 * b + k]) / 2);
        return entry->second;
      };
      std::vector<std::uint32_t> finer;
      for (std::size_t t = 0; t < triangles.size(); t += 3) {
        const std::uint32_t a = triangles[t], b = triangles[t + 1], c = triangles[t + 2];
        const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        finer.insert(finer.end(), {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca});
      }
      triangles = finer;
    }
    for (std::size_t i = 0; i < positions.size(); i += 3) {
      const double length = std::hypot(positions[i], positions[i + 1], positions[i + 2]);
      for (std::size_t k = 0; k < 3; ++k)
        directions.push_back(positions[i + k] / length);
    }
  }

  obc_surface surface() const {
    return {positions.data(), positions.size() / 3, triangles.data(), triangles.size() / 3};
  }
};

class LocatorHandle {
 public:
  explicit LocatorHandle(const Ball& ball) {
    const obc_surface surface = ball.surface();
    REQUIRE(obc_sphere_map_locator_create(&surface, ball.directions.data(), nullptr, &locator_, nullptr) == OBC_OK);
  }
  ~LocatorHandle() { obc_sphere_map_locator_destroy(locator_); }
  LocatorHandle(const LocatorHandle&) = delete;
  LocatorHandle& operator=(const LocatorHandle&) = delete;
  const obc_sphere_map_locator* get() const { return locator_; }

 private:
  obc_sphere_map_locator* locator_ = nullptr;
};

}  // namespace

TEST_CASE("Through C, the vertices of a map are found, and samples are their own values") {
  const Ball ball(3);
  const LocatorHandle locator(ball);
  const std::size_t count = ball.directions.size() / 3;
  std::vector<std::uint32_t> triangles(count);
  std::vector<double> weights(3 * count), sampled(3 * count), unit(3 * count);
  obc_error error;
  REQUIRE(obc_sphere_map_locate(locator.get(), ball.directions.data(), count, nullptr, triangles.data(), weights.data(),
                                &error) == OBC_OK);
  for (std::size_t v = 0; v < count; ++v) {
    for (std::size_t k = 0; k < 3; ++k)
      CHECK(weights[3 * v + k] == (ball.triangles[3 * triangles[v] + k] == v ? 1 : 0));
  }
  REQUIRE(obc_sphere_map_sample(locator.get(), ball.directions.data(), count, ball.positions.data(), 3, 0, nullptr,
                                sampled.data(), &error) == OBC_OK);
  CHECK(sampled == ball.positions);
  REQUIRE(obc_sphere_map_sample(locator.get(), ball.directions.data(), count, ball.positions.data(), 3, 1, nullptr,
                                unit.data(), &error) == OBC_OK);
  for (std::size_t i = 0; i < unit.size(); ++i)
    CHECK(unit[i] == doctest::Approx(ball.directions[i]).epsilon(1e-15));
  const obc_surface surface = ball.surface();
  // Only triangles and counts are needed for a locator, and none of its outputs.
  const obc_surface bare{nullptr, surface.vertex_count, surface.triangles, surface.triangle_count};
  obc_sphere_map_locator* other = nullptr;
  REQUIRE(obc_sphere_map_locator_create(&bare, ball.directions.data(), nullptr, &other, &error) == OBC_OK);
  CHECK(obc_sphere_map_locate(other, ball.directions.data(), count, nullptr, nullptr, nullptr, &error) == OBC_OK);
  obc_sphere_map_locator_destroy(other);
  obc_sphere_map_locator_destroy(nullptr);
}

TEST_CASE("Wrong arguments of the inverse are refused, not followed") {
  const Ball ball(1);
  const obc_surface surface = ball.surface();
  obc_error error;
  obc_sphere_map_locator* made = nullptr;
  const double* map = ball.directions.data();
  CHECK(obc_sphere_map_locator_create(nullptr, map, nullptr, &made, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_sphere_map_locator_create(&surface, nullptr, nullptr, &made, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_sphere_map_locator_create(&surface, map, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(std::strlen(error.message) > 0);
  obc_surface wrong = surface;
  wrong.triangles = nullptr;
  CHECK(obc_sphere_map_locator_create(&wrong, map, nullptr, &made, &error) == OBC_INVALID_ARGUMENT);
  wrong = surface;
  wrong.triangle_count = 0;
  CHECK(obc_sphere_map_locator_create(&wrong, map, nullptr, &made, &error) == OBC_INVALID_ARGUMENT);
  wrong.triangle_count = std::numeric_limits<std::size_t>::max();
  CHECK(obc_sphere_map_locator_create(&wrong, map, nullptr, &made, &error) == OBC_INVALID_ARGUMENT);
  wrong = surface;
  wrong.triangle_count -= 1;
  CHECK(obc_sphere_map_locator_create(&wrong, map, nullptr, &made, &error) == OBC_NOT_CLOSED);
  Ball bad = ball;
  bad.directions[4] = std::nan("");
  CHECK(obc_sphere_map_locator_create(&surface, bad.directions.data(), nullptr, &made, &error) == OBC_INVALID_ARGUMENT);
  CHECK(made == nullptr);

  const LocatorHandle locator(ball);
  std::vector<double> out(300);
  const double one = 1;
  CHECK(obc_sphere_map_locate(nullptr, map, 1, nullptr, nullptr, out.data(), &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_sphere_map_locate(locator.get(), nullptr, 1, nullptr, nullptr, out.data(), &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_sphere_map_locate(locator.get(), nullptr, 0, nullptr, nullptr, nullptr, &error) == OBC_OK);
  const double directions[3][3] = {{0, 0, 0}, {1, 0, std::nan("")}, {0, HUGE_VAL, 0}};
  for (const auto& d : directions)
    CHECK(obc_sphere_map_locate(locator.get(), d, 1, nullptr, nullptr, out.data(), &error) == OBC_INVALID_ARGUMENT);
  const auto sample = [&](const double* values, std::size_t components, std::int32_t unit, double* to) {
    return obc_sphere_map_sample(locator.get(), map, 1, values, components, unit, nullptr, to, &error);
  };
  CHECK(sample(ball.positions.data(), 3, 0, out.data()) == OBC_OK);
  CHECK(sample(nullptr, 3, 0, out.data()) == OBC_INVALID_ARGUMENT);
  CHECK(sample(ball.positions.data(), 3, 0, nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(sample(ball.positions.data(), 3, 2, out.data()) == OBC_INVALID_ARGUMENT);
  CHECK(sample(ball.positions.data(), 0, 0, out.data()) == OBC_INVALID_ARGUMENT);
  CHECK(sample(&one, std::numeric_limits<std::size_t>::max() / 4, 0, out.data()) == OBC_INVALID_ARGUMENT);
}

TEST_CASE("Each allocation of the inverse fails in turn and nothing is leaked") {
  const Ball ball(2);
  const obc_surface surface = ball.surface();
  std::vector<double> out(ball.positions.size());
  const test::Outcome outcome = test::fail_each_allocation([&](const obc_host& host) {
    obc_sphere_map_locator* locator = nullptr;
    obc_status status = obc_sphere_map_locator_create(&surface, ball.directions.data(), &host, &locator, nullptr);
    if (status == OBC_OK) {
      status = obc_sphere_map_sample(locator, ball.directions.data(), surface.vertex_count, ball.positions.data(), 3, 0,
                                     &host, out.data(), nullptr);
    }
    obc_sphere_map_locator_destroy(locator);
    return status;
  });
  CHECK(outcome.problem == "");
  CHECK(outcome.runs > 5);
}

TEST_CASE("The inverse is cancelled at each of its reports") {
  const Ball ball(3);
  const obc_surface surface = ball.surface();
  CHECK(test::cancel_everywhere([&](const obc_host& host) {
          obc_sphere_map_locator* locator = nullptr;
          obc_status status = obc_sphere_map_locator_create(&surface, ball.directions.data(), &host, &locator, nullptr);
          if (status == OBC_OK) {
            status = obc_sphere_map_locate(locator, ball.directions.data(), surface.vertex_count, &host, nullptr,
                                           nullptr, nullptr);
          }
          obc_sphere_map_locator_destroy(locator);
          return status;
        }).problem == "");
}

namespace {

struct MeshHandle {
  obc_mesh* mesh = nullptr;
  ~MeshHandle() { obc_mesh_destroy(mesh); }
  obc_surface surface() const {
    obc_surface result{};
    REQUIRE(obc_mesh_surface(mesh, &result, nullptr) == OBC_OK);
    return result;
  }
};

// Four landmarks, and where they go.
constexpr double landmarks[12] = {1, 0, 0, 0, 1, 0, -1, -1, 0.5, 0, 0, 1};
constexpr double goals[12] = {1, 0.2, 0, -0.2, 1, 0, -1, -1, 0.8, 0.1, 0, 1};

}  // namespace

TEST_CASE("Through C, a surface is resampled on each grid and measured against itself") {
  const Ball ball(4);
  const LocatorHandle locator(ball);
  const obc_surface original = ball.surface();
  obc_error error;
  for (const auto& [grid, resolution, vertices] : {std::tuple{OBC_SPHERE_MAP_ICOSPHERE, 3, 642},
                                                   {OBC_SPHERE_MAP_CUBE, 8, 386},
                                                   {OBC_SPHERE_MAP_LATITUDE, 12, 266},
                                                   {OBC_SPHERE_MAP_OCTAHEDRON, 16, 258}}) {
    MeshHandle alone, made;
    REQUIRE(obc_sphere_map_grid(grid, static_cast<std::size_t>(resolution), nullptr, &alone.mesh, &error) == OBC_OK);
    REQUIRE(obc_sphere_map_remesh(locator.get(), ball.positions.data(), grid, static_cast<std::size_t>(resolution),
                                  nullptr, &made.mesh, &error) == OBC_OK);
    CHECK(alone.surface().vertex_count == static_cast<std::size_t>(vertices));
    CHECK(made.surface().vertex_count == static_cast<std::size_t>(vertices));
    obc_mesh_distance distance;
    REQUIRE(obc_mesh_distance_init(&distance, sizeof distance) == OBC_OK);
    const obc_surface resampled = made.surface();
    REQUIRE(obc_mesh_surface_distance(&original, &resampled, nullptr, &distance, &error) == OBC_OK);
    CHECK(distance.first_max > 0);
    CHECK(distance.first_max < 0.3);
    CHECK(distance.second_root_mean_square <= distance.second_max);
  }
}

TEST_CASE("Through C, geometry images go to files and back to the surface") {
  const Ball ball(3);
  const LocatorHandle locator(ball);
  obc_error error;
  std::size_t width = 0, height = 0;
  REQUIRE(obc_sphere_map_image_size(OBC_SPHERE_MAP_OCTAHEDRON, 16, &width, &height, &error) == OBC_OK);
  CHECK((width == 17 && height == 17));
  std::vector<double> pixels(3 * width * height), again(pixels.size());
  REQUIRE(obc_sphere_map_image(locator.get(), ball.positions.data(), OBC_SPHERE_MAP_OCTAHEDRON, 16, nullptr,
                               pixels.data(), &error) == OBC_OK);
  for (const char* path : {"capi-geometry-image.pfm", "capi-geometry-image.png"}) {
    REQUIRE(obc_sphere_map_image_write(path, pixels.data(), OBC_SPHERE_MAP_OCTAHEDRON, 16, nullptr, &error) == OBC_OK);
    std::int32_t layout = -1;
    std::size_t resolution = 0;
    REQUIRE(obc_sphere_map_image_read(path, nullptr, &layout, &resolution, nullptr, 0, &error) == OBC_OK);
    CHECK(layout == OBC_SPHERE_MAP_OCTAHEDRON);
    CHECK(resolution == 16);
    CHECK(obc_sphere_map_image_read(path, nullptr, &layout, &resolution, again.data(), again.size() - 1, &error) ==
          OBC_INVALID_ARGUMENT);
    REQUIRE(obc_sphere_map_image_read(path, nullptr, &layout, &resolution, again.data(), again.size(), &error) ==
            OBC_OK);
    for (std::size_t i = 0; i < pixels.size(); ++i)
      CHECK(std::abs(again[i] - pixels[i]) < 4.0 / 65535);  // the box is four wide
    std::remove(path);
  }
  MeshHandle made;
  double gap = -1;
  REQUIRE(obc_sphere_map_image_surface(pixels.data(), OBC_SPHERE_MAP_OCTAHEDRON, 16, nullptr, &made.mesh, &gap,
                                       &error) == OBC_OK);
  CHECK(gap == 0);
  const obc_surface surface = made.surface();
  CHECK(obc_mesh_check_closed_genus_zero(&surface, nullptr, &error) == OBC_OK);

  CHECK(obc_sphere_map_image_read("no/such/file.png", nullptr, nullptr, nullptr, nullptr, 0, &error) ==
        OBC_INVALID_ARGUMENT);
  std::int32_t layout = 0;
  std::size_t resolution = 0;
  CHECK(obc_sphere_map_image_read("no/such/file.png", nullptr, &layout, &resolution, nullptr, 0, &error) == OBC_IO);
  CHECK(obc_sphere_map_image_read("image.jpeg", nullptr, &layout, &resolution, nullptr, 0, &error) == OBC_UNSUPPORTED);
  obc_mesh* nothing = nullptr;
  std::vector<double> far(pixels.size());  // finite, and their differences beyond the range of double
  for (std::size_t i = 0; i < far.size(); ++i)
    far[i] = (i / 3 * 2654435761U >> 7U) % 2 == 0 ? 1.7e308 : -1.7e308;
  CHECK(obc_sphere_map_image_surface(far.data(), OBC_SPHERE_MAP_OCTAHEDRON, 16, nullptr, &nothing, &gap, &error) ==
        OBC_INVALID_ARGUMENT);
  CHECK(nothing == nullptr);
  pixels[5] = std::nan("");
  CHECK(obc_sphere_map_image_surface(pixels.data(), OBC_SPHERE_MAP_OCTAHEDRON, 16, nullptr, &nothing, &gap, &error) ==
        OBC_INVALID_ARGUMENT);
  CHECK(nothing == nullptr);
}

TEST_CASE("Through C, a warp carries landmarks there and back, and an overlay has the vertices of both maps") {
  obc_error error;
  obc_sphere_map_warp* warp = nullptr;
  REQUIRE(obc_sphere_map_warp_create(landmarks, goals, 4, nullptr, &warp, &error) == OBC_OK);
  double there[12], back[12];
  REQUIRE(obc_sphere_map_warp_apply(warp, landmarks, 4, 0, nullptr, there, &error) == OBC_OK);
  REQUIRE(obc_sphere_map_warp_apply(warp, there, 4, 1, nullptr, back, &error) == OBC_OK);
  for (std::size_t i = 0; i < 12; i += 3) {
    const double from = std::hypot(landmarks[i], landmarks[i + 1], landmarks[i + 2]);
    const double to = std::hypot(goals[i], goals[i + 1], goals[i + 2]);
    for (std::size_t k = i; k < i + 3; ++k) {
      CHECK(there[k] == doctest::Approx(goals[k] / to).epsilon(1e-15));
      CHECK(back[k] == doctest::Approx(landmarks[k] / from).epsilon(1e-15));
    }
  }
  obc_sphere_map_warp_destroy(warp);
  obc_sphere_map_warp_destroy(nullptr);

  double rotation[9];
  REQUIRE(obc_sphere_map_best_rotation(landmarks, landmarks, 4, rotation, &error) == OBC_OK);
  for (std::size_t i = 0; i < 9; ++i)
    CHECK(rotation[i] == doctest::Approx(i % 4 == 0 ? 1 : 0).epsilon(1e-8));

  const Ball coarse(1), fine(2);
  const obc_surface first = coarse.surface(), second = fine.surface();
  MeshHandle made;
  std::vector<std::uint32_t> places(second.vertex_count);
  REQUIRE(obc_sphere_map_overlay(&first, coarse.directions.data(), &second, fine.directions.data(), nullptr, &made.mesh,
                                 places.data(), &error) == OBC_OK);
  const obc_surface both = made.surface();
  for (std::size_t v = 0; v < places.size(); ++v) {
    for (std::size_t k = 0; k < 3; ++k)
      CHECK(both.positions[3 * places[v] + k] == fine.directions[3 * v + k]);
  }
  CHECK(obc_mesh_check_closed_genus_zero(&both, nullptr, &error) == OBC_OK);
}

TEST_CASE("Wrong arguments of remeshing, images, warps and overlays are refused, not followed") {
  const Ball ball(1);
  const LocatorHandle locator(ball);
  const obc_surface surface = ball.surface();
  obc_error error;
  obc_mesh* mesh = nullptr;
  double number = 0;
  std::size_t size = 0;
  const double* map = ball.directions.data();
  const double* x = ball.positions.data();
  CHECK(obc_sphere_map_grid(7, 3, nullptr, &mesh, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_sphere_map_grid(OBC_SPHERE_MAP_CUBE, 0, nullptr, &mesh, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_sphere_map_grid(OBC_SPHERE_MAP_CUBE, 3, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_sphere_map_remesh(nullptr, x, OBC_SPHERE_MAP_CUBE, 3, nullptr, &mesh, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_sphere_map_remesh(locator.get(), nullptr, OBC_SPHERE_MAP_CUBE, 3, nullptr, &mesh, &error) ==
        OBC_INVALID_ARGUMENT);
  CHECK(obc_sphere_map_image_size(OBC_SPHERE_MAP_LATITUDE, 4, &size, &size, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_sphere_map_image_size(OBC_SPHERE_MAP_CUBE, 4097, &size, &size, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_sphere_map_image_size(OBC_SPHERE_MAP_CUBE, 4, nullptr, &size, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_sphere_map_image(locator.get(), x, OBC_SPHERE_MAP_CUBE, 4, nullptr, nullptr, &error) ==
        OBC_INVALID_ARGUMENT);
  CHECK(obc_sphere_map_image_surface(nullptr, OBC_SPHERE_MAP_CUBE, 4, nullptr, &mesh, nullptr, &error) ==
        OBC_INVALID_ARGUMENT);
  CHECK(obc_sphere_map_image_write("x.png", nullptr, OBC_SPHERE_MAP_CUBE, 4, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_sphere_map_best_rotation(map, nullptr, 2, &number, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_sphere_map_best_rotation(map, map, 0, &number, &error) == OBC_INVALID_ARGUMENT);
  obc_sphere_map_warp* warp = nullptr;
  CHECK(obc_sphere_map_warp_create(map, nullptr, 3, nullptr, &warp, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_sphere_map_warp_create(map, map, 0, nullptr, &warp, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_sphere_map_warp_create(map, map, 3, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  const double swapped[6] = {0, 1, 0, 1, 0, 0}, two[6] = {1, 0, 0, 0, 1, 0};
  CHECK(obc_sphere_map_warp_create(two, swapped, 2, nullptr, &warp, &error) == OBC_NO_VALID_RESULT);
  CHECK(warp == nullptr);
  CHECK(obc_sphere_map_warp_apply(nullptr, map, 1, 0, nullptr, &number, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_sphere_map_overlay(&surface, map, nullptr, map, nullptr, &mesh, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_sphere_map_overlay(&surface, map, &surface, nullptr, nullptr, &mesh, nullptr, &error) ==
        OBC_INVALID_ARGUMENT);
  CHECK(mesh == nullptr);
}

TEST_CASE("Each allocation of remeshing, images, warps and overlays fails in turn and nothing is leaked") {
  const Ball ball(1);
  const LocatorHandle locator(ball);
  const obc_surface surface = ball.surface();
  std::vector<double> pixels(3 * 6 * 25);
  const auto with_mesh = [](const auto& make) {
    return test::fail_each_allocation([&](const obc_host& host) {
      obc_mesh* mesh = nullptr;
      const obc_status status = make(host, &mesh);
      obc_mesh_destroy(mesh);
      return status;
    });
  };
  CHECK(with_mesh([&](const obc_host& host, obc_mesh** out) {
          return obc_sphere_map_remesh(locator.get(), ball.positions.data(), OBC_SPHERE_MAP_ICOSPHERE, 1, &host, out,
                                       nullptr);
        }).problem == "");
  CHECK(with_mesh([&](const obc_host& host, obc_mesh** out) {
          return obc_sphere_map_overlay(&surface, ball.directions.data(), &surface, ball.directions.data(), &host, out,
                                        nullptr, nullptr);
        }).problem == "");
  CHECK(test::fail_each_allocation([&](const obc_host& host) {
          return obc_sphere_map_image(locator.get(), ball.positions.data(), OBC_SPHERE_MAP_CUBE, 4, &host,
                                      pixels.data(), nullptr);
        }).problem == "");
  CHECK(with_mesh([&](const obc_host& host, obc_mesh** out) {
          return obc_sphere_map_image_surface(pixels.data(), OBC_SPHERE_MAP_CUBE, 4, &host, out, nullptr, nullptr);
        }).problem == "");
}

TEST_CASE("Each allocation of a warp and of image files fails in turn and nothing is leaked") {
  // One landmark that moves a little: the grid is as fine as for any, and the flow short.
  const double from[3] = {0, 0, 1}, to[3] = {0.05, 0, 1};
  const test::Outcome warping = test::fail_each_allocation([&](const obc_host& host) {
    obc_sphere_map_warp* warp = nullptr;
    obc_status status = obc_sphere_map_warp_create(from, to, 1, &host, &warp, nullptr);
    double moved[3];
    if (status == OBC_OK) status = obc_sphere_map_warp_apply(warp, from, 1, 0, &host, moved, nullptr);
    obc_sphere_map_warp_destroy(warp);
    return status;
  });
  CHECK(warping.problem == "");
  CHECK(warping.runs > 10);

  const Ball ball(1);
  const LocatorHandle locator(ball);
  std::vector<double> pixels(3 * 25), again(pixels.size());
  REQUIRE(obc_sphere_map_image(locator.get(), ball.positions.data(), OBC_SPHERE_MAP_OCTAHEDRON, 4, nullptr,
                               pixels.data(), nullptr) == OBC_OK);
  for (const char* path : {"capi-failing-image.pfm", "capi-failing-image.png"}) {
    const test::Outcome files = test::fail_each_allocation([&](const obc_host& host) {
      obc_status status = obc_sphere_map_image_write(path, pixels.data(), OBC_SPHERE_MAP_OCTAHEDRON, 4, &host, nullptr);
      std::int32_t layout = 0;
      std::size_t resolution = 0;
      if (status == OBC_OK) {
        status = obc_sphere_map_image_read(path, &host, &layout, &resolution, again.data(), again.size(), nullptr);
      }
      std::remove(path);
      return status;
    });
    CHECK(files.problem == "");
    CHECK(files.runs > 5);
  }
}

TEST_CASE("Warps and overlays are cancelled at each of their reports") {
  const Ball coarse(2), fine(4);
  const obc_surface first = coarse.surface(), second = fine.surface();
  CHECK(test::cancel_everywhere(
            [&](const obc_host& host) {
              obc_sphere_map_warp* warp = nullptr;
              const obc_status status = obc_sphere_map_warp_create(landmarks, goals, 4, &host, &warp, nullptr);
              obc_sphere_map_warp_destroy(warp);
              return status;
            },
            8)
            .problem == "");
  CHECK(test::cancel_everywhere(
            [&](const obc_host& host) {
              obc_mesh* mesh = nullptr;
              const obc_status status = obc_sphere_map_overlay(&first, coarse.directions.data(), &second,
                                                               fine.directions.data(), &host, &mesh, nullptr, nullptr);
              obc_mesh_destroy(mesh);
              return status;
            },
            16)
            .problem == "");
}
