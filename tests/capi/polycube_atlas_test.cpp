// The C functions for texture atlases of polycubes.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "orbicube/polycube.h"
#include "polycube_cube.h"

using namespace orbicube;
using test::check_every_end, test::cube, test::sphere, test::triangles;

TEST_CASE("The atlas of a cube's map has six squares apart, and its texels show what lies there") {
  const std::vector<double> in_space = sphere();
  const obc_surface surface = {in_space.data(), 8, triangles.data(), 12};
  obc_polycube* map = nullptr;
  obc_error error;
  REQUIRE(obc_polycube_create(&surface, cube.data(), nullptr, nullptr, &map, &error) == OBC_OK);
  obc_polycube_atlas_options options;
  REQUIRE(obc_polycube_atlas_options_init(&options, sizeof options) == OBC_OK);
  CHECK(options.size == 1024);
  CHECK(options.padding == 4);
  options.size = 64;
  obc_polycube_atlas* atlas = nullptr;
  REQUIRE(obc_polycube_atlas_create(map, &options, nullptr, &atlas, &error) == OBC_OK);
  CHECK(obc_polycube_atlas_size(atlas) == 64);
  REQUIRE(obc_polycube_atlas_triangle_count(atlas) == 12);
  std::vector<double> at(72), weights(3 * 64 * 64);
  double scale = 0, coverage = 0;
  REQUIRE(obc_polycube_atlas_copy(atlas, at.data(), &scale, &coverage, &error) == OBC_OK);
  // Six squares of edge 2 at one scale.
  CHECK(coverage == doctest::Approx(6 * 4 * scale * scale / (64 * 64)));
  for (std::size_t t = 0; t < 12; ++t) {
    const double* const c = &at[6 * t];
    // v goes down, so that a triangle counter-clockwise seen from outside has a negative area; half a face.
    const double twice = (c[2] - c[0]) * (c[5] - c[1]) - (c[3] - c[1]) * (c[4] - c[0]);
    CHECK(-twice * 64 * 64 == doctest::Approx(4 * scale * scale));
    for (std::size_t i = 0; i < 6; ++i) {
      CHECK(c[i] >= 2.0 / 64 - 1e-12);  // half of the padding, and roundoff
      CHECK(c[i] <= 1 - 2.0 / 64 + 1e-12);
    }
  }
  std::vector<std::uint32_t> shown(64 * 64);
  std::vector<std::uint8_t> covered(64 * 64);
  REQUIRE(obc_polycube_atlas_sample(atlas, nullptr, shown.data(), weights.data(), covered.data(), &error) == OBC_OK);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    REQUIRE(shown[i] < 12);
    const double* const w = &weights[3 * i];
    CHECK(w[0] + w[1] + w[2] == doctest::Approx(1));
    CHECK(std::min({w[0], w[1], w[2]}) >= 0);
    if (covered[i] == 0) continue;
    for (std::size_t k = 0; k < 2; ++k) {
      const double* const c = &at[6 * shown[i] + k];
      const double middle = static_cast<double>(k == 0 ? i % 64 : i / 64) + 0.5;
      CHECK(64 * (w[0] * c[0] + w[1] * c[2] + w[2] * c[4]) == doctest::Approx(middle));
    }
  }
  // A square of whole or half texels has as many middles as its area says, up to one along each side.
  const double side = 2 * scale, fewest = 6 * std::pow(std::floor(side), 2), most = 6 * std::pow(std::ceil(side), 2);
  const auto count = static_cast<double>(std::count(covered.begin(), covered.end(), 1));
  CHECK(count >= fewest);
  CHECK(count <= most);
  CHECK(obc_polycube_atlas_copy(atlas, nullptr, nullptr, nullptr, &error) == OBC_OK);
  CHECK(obc_polycube_atlas_sample(atlas, nullptr, nullptr, nullptr, nullptr, &error) == OBC_OK);

  std::vector<std::uint32_t> again(shown.size());
  for (const std::uint32_t threads : {1U, 2U, 3U}) {
    obc_host host;
    REQUIRE(obc_host_init(&host, sizeof host) == OBC_OK);
    host.thread_count = threads;
    obc_polycube_atlas* other = nullptr;
    REQUIRE(obc_polycube_atlas_create(map, &options, &host, &other, &error) == OBC_OK);
    std::vector<double> there(72), mixed(weights.size());
    REQUIRE(obc_polycube_atlas_copy(other, there.data(), nullptr, nullptr, &error) == OBC_OK);
    REQUIRE(obc_polycube_atlas_sample(other, &host, again.data(), mixed.data(), nullptr, &error) == OBC_OK);
    CHECK(std::memcmp(there.data(), at.data(), sizeof(double) * at.size()) == 0);
    CHECK(std::memcmp(mixed.data(), weights.data(), sizeof(double) * weights.size()) == 0);
    CHECK(again == shown);
    obc_polycube_atlas_destroy(other);
  }
  obc_polycube_atlas_destroy(atlas);
  obc_polycube_destroy(map);
}

TEST_CASE("An atlas that cannot be is refused") {
  const obc_surface surface = {cube.data(), 8, triangles.data(), 12};
  obc_polycube* map = nullptr;
  obc_error error;
  REQUIRE(obc_polycube_create(&surface, cube.data(), nullptr, nullptr, &map, &error) == OBC_OK);
  obc_polycube_atlas* atlas = nullptr;
  const auto refused = [&](std::uint32_t size, double padding) {
    obc_polycube_atlas_options options;
    obc_polycube_atlas_options_init(&options, sizeof options);
    options.size = size;
    options.padding = padding;
    atlas = reinterpret_cast<obc_polycube_atlas*>(&options);  // no handle
    const obc_status status = obc_polycube_atlas_create(map, &options, nullptr, &atlas, &error);
    CHECK(atlas == nullptr);
    return status;
  };
  CHECK(refused(0, 4) == OBC_INVALID_ARGUMENT);
  CHECK(refused(16385, 4) == OBC_INVALID_ARGUMENT);
  CHECK(refused(UINT32_MAX, 4) == OBC_INVALID_ARGUMENT);
  CHECK(refused(64, -1) == OBC_INVALID_ARGUMENT);
  CHECK(refused(64, std::numeric_limits<double>::quiet_NaN()) == OBC_INVALID_ARGUMENT);
  CHECK(refused(64, std::numeric_limits<double>::infinity()) == OBC_INVALID_ARGUMENT);
  CHECK(refused(16, 16) == OBC_UNSUPPORTED);
  CHECK(obc_polycube_atlas_create(nullptr, nullptr, nullptr, &atlas, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_polycube_atlas_create(map, nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_polycube_atlas_copy(nullptr, nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_polycube_atlas_sample(nullptr, nullptr, nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_polycube_atlas_options_init(nullptr, sizeof(obc_polycube_atlas_options)) == OBC_INVALID_ARGUMENT);
  CHECK(obc_polycube_atlas_size(nullptr) + obc_polycube_atlas_triangle_count(nullptr) == 0);
  obc_polycube_atlas_destroy(nullptr);
  obc_polycube_destroy(map);
}

TEST_CASE("An atlas and its samples end well wherever memory or patience does") {
  const obc_surface surface = {cube.data(), 8, triangles.data(), 12};
  obc_polycube* map = nullptr;
  obc_error error;
  REQUIRE(obc_polycube_create(&surface, cube.data(), nullptr, nullptr, &map, &error) == OBC_OK);
  obc_polycube_atlas_options options;
  REQUIRE(obc_polycube_atlas_options_init(&options, sizeof options) == OBC_OK);
  options.size = 256;
  std::vector<std::uint32_t> shown(256 * 256);
  std::vector<double> weights(3 * shown.size());
  std::vector<std::uint8_t> covered(shown.size());
  const test::Call call = [&](const obc_host& host) {
    obc_polycube_atlas* made = nullptr;
    obc_status status = obc_polycube_atlas_create(map, &options, &host, &made, nullptr);
    if (status == OBC_OK)
      status = obc_polycube_atlas_sample(made, &host, shown.data(), weights.data(), covered.data(), nullptr);
    obc_polycube_atlas_destroy(made);
    return status;
  };
  check_every_end(call);
  obc_polycube_destroy(map);
}
