// Texture atlases of polycubes: patches lie apart, keep their shape, and each texel knows what it shows.
#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"
#include "blocks.h"
#include "mesh/search/predicates.h"
#include "polycube/map/certificate.h"
#include "polycube/outputs/atlas_texels.h"
#include "tests/base/quiet_host.h"

using namespace orbicube;
using namespace orbicube::polycube;
using test::host;

namespace {

// The map of a polycube to itself: a plate with a tunnel beside steps.
SurfaceMap example() {
  return test::on_itself(test::blocks(test::box_without({4, 3, 2}, {{1, 1, 0}, {1, 1, 1}, {3, 0, 1}, {3, 1, 1}})),
                         host);
}

struct Made {
  explicit Made(const AtlasOptions& options, SurfaceMap of = example())
      : map(std::move(of)), graph(make_patch_graph(map, host)), atlas(make_atlas(graph, options, host)) {}

  Eigen::Vector2d texel(Index t, std::size_t k) const {
    const auto [x, y] = texel_of(atlas, graph, map.patches[t], map.polycube[map.triangles[t][k]]);
    return {x, y};
  }

  SurfaceMap map;
  PatchGraph graph;
  Atlas atlas;
};

struct TexelBox {
  Eigen::Vector2d low, high;
};

TexelBox box_of(const Made& made, Index t) {
  const Eigen::Vector2d a = made.texel(t, 0), b = made.texel(t, 1), c = made.texel(t, 2);
  return {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
}

}  // namespace

TEST_CASE("patches keep their shape at one scale, and none is mirrored") {
  const Made made({.size = 256, .padding = 3});
  CHECK(made.atlas.scale > 0);
  CHECK(made.atlas.coverage > 0.4);
  for (Index t = 0; t < made.map.triangles.size(); ++t) {
    const Eigen::Vector2d a = made.texel(t, 0), b = made.texel(t, 1), c = made.texel(t, 2);
    // v goes down.
    CHECK(mesh::orientation_2d({a[0], -a[1]}, {b[0], -b[1]}, {c[0], -c[1]}) > 0);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& corner = made.map.triangles[t];
      const double length = (made.map.polycube[corner[(k + 1) % 3]] - made.map.polycube[corner[k]]).norm();
      CHECK((made.texel(t, (k + 1) % 3) - made.texel(t, k)).norm() ==
            doctest::Approx(made.atlas.scale * length).epsilon(1e-12));  // roundoff
    }
  }
}

TEST_CASE("a patch turned by any number of quarters fills its place and is not mirrored") {
  Made made({.size = 256, .padding = 3});
  for (const int turns : {0, 1, 2, 3}) {
    for (AtlasPlace& place : made.atlas.places)
      place.quarter_turns = turns;
    std::vector<TexelBox> bounds(made.graph.patches(), {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}});
    for (Index t = 0; t < made.map.triangles.size(); ++t) {
      const Eigen::Vector2d a = made.texel(t, 0), b = made.texel(t, 1), c = made.texel(t, 2);
      CHECK(mesh::orientation_2d({a[0], -a[1]}, {b[0], -b[1]}, {c[0], -c[1]}) > 0);
      TexelBox& box = bounds[made.map.patches[t]];
      box = {box.low.cwiseMin(box_of(made, t).low), box.high.cwiseMax(box_of(made, t).high)};
    }
    for (std::size_t p = 0; p < bounds.size(); ++p) {
      const AtlasPlace& place = made.atlas.places[p];
      Eigen::Vector2d size(place.u_high - place.u_low, place.v_high - place.v_low);
      if (turns % 2 == 1) std::swap(size[0], size[1]);
      CHECK(bounds[p].low.isApprox(Eigen::Vector2d(place.left, place.top), 1e-12));  // roundoff
      CHECK((bounds[p].high - bounds[p].low).isApprox(made.atlas.scale * size, 1e-12));
    }
  }
}

TEST_CASE("patches lie in notches of others: more is covered than boxes around them could") {
  // A plate with the outline of an E, whose front and back cover 13 of 21 cells each; the sides cover 28.
  const Made made(
      {.size = 256, .padding = 1},
      test::on_itself(
          test::blocks(test::box_without(
              {3, 7, 1}, {{1, 1, 0}, {2, 1, 0}, {1, 2, 0}, {2, 2, 0}, {1, 4, 0}, {2, 4, 0}, {1, 5, 0}, {2, 5, 0}})),
          host));
  CHECK(made.atlas.coverage > (2 * 13 + 28) / (2 * 21 + 28.0));
}

TEST_CASE("six squares are packed as well as they can be") {
  // Three beside each other, on cells of a 256th of the side.
  const Made made({.size = 1024, .padding = 0}, test::on_itself(test::blocks(test::box_without({1, 1, 1})), host));
  CHECK(made.atlas.scale > 1024 * (1.0 / 3 - 1.0 / 256));
  CHECK(made.atlas.scale <= 1024.0 / 3);
}

TEST_CASE("a triangle that roundoff makes flat has no texel") {
  // Along a row of middles, and one around it.
  const std::vector<TexelCorners> corners = {{{{0.5, 1.5}, {2.5, 1.5}, {3.5, 1.5}}}, {{{0, 0}, {0, 4}, {4, 0}}}};
  const AtlasTexels texels = covered_texels(4, corners, host);
  for (const Index t : texels.triangles)
    CHECK(t != 0);
  CHECK(std::count(texels.triangles.begin(), texels.triangles.end(), Index{1}) == 10);
}

TEST_CASE("patches are the padding away from each other, and half of it from the border") {
  for (const double padding : {0.0, 3.0, 8.5}) {
    const Made made({.size = 256, .padding = padding});
    constexpr double roundoff = 1e-9;  // of numbers up to 256
    // Faces of blocks are two triangles that have the box of the square.
    for (Index t = 0; t < made.map.triangles.size(); ++t) {
      const TexelBox one = box_of(made, t);
      CHECK(one.low.minCoeff() >= padding / 2 - roundoff);
      CHECK(one.high.maxCoeff() <= 256 - padding / 2 + roundoff);
      for (Index s = 0; s < t; ++s) {
        if (made.map.patches[s] == made.map.patches[t]) continue;
        const TexelBox other = box_of(made, s);
        const double gap = std::max((one.low - other.high).maxCoeff(), (other.low - one.high).maxCoeff());
        CHECK(gap >= padding - roundoff);
      }
    }
  }
}

TEST_CASE("texels show the triangle that has their middle, and those beside the patches the nearest in one") {
  const Made made({.size = 128, .padding = 4});
  const Array<TexelCorners> corners = texel_corners(made.atlas, made.graph, made.map, host);
  const AtlasTexels texels = covered_texels(128, corners, host);
  const auto steps = [](Index a, Index b) {
    return std::abs(static_cast<int>(a % 128) - static_cast<int>(b % 128)) +
           std::abs(static_cast<int>(a / 128) - static_cast<int>(b / 128));
  };
  std::size_t covered = 0, beside = 0;
  for (Index texel = 0; texel < texels.shown.size(); ++texel) {
    const Index shown = texels.shown[texel], t = texels.triangles[texel];
    if (t != no_index) {
      ++covered;
      CHECK(shown == texel);
      const Vector3 weights = weights_at(corners, texels, texel);
      CHECK(weights.minCoeff() >= 0);
      CHECK(weights.sum() == doctest::Approx(1));
      Eigen::Vector2d middle = Eigen::Vector2d::Zero();
      for (std::size_t k = 0; k < 3; ++k)
        middle += weights[static_cast<Eigen::Index>(k)] * made.texel(t, k);
      CHECK(middle[0] == doctest::Approx(texel % 128 + 0.5));
      CHECK(middle[1] == doctest::Approx(texel / 128 + 0.5));
    } else {
      ++beside;
      REQUIRE(shown != no_index);
      CHECK(texels.triangles[shown] != no_index);
      const int away = steps(texel, shown);
      bool nearer = false;
      for (Index other = 0; beside % 64 == 0 && other < texels.triangles.size(); ++other)
        nearer = nearer || (texels.triangles[other] != no_index && steps(texel, other) < away);
      CHECK_FALSE(nearer);
    }
  }
  // A patch of whole texels covers its area; others more or less by half of their border.
  CHECK(static_cast<double>(covered) == doctest::Approx(made.atlas.coverage * 128 * 128).epsilon(0.05));
  CHECK(beside > 500);
}

TEST_CASE("an atlas that cannot be is refused") {
  const auto kind_of = [](const AtlasOptions& options) -> std::string {
    try {
      const Made made(options);
    } catch (const base::Error& error) {
      return error.kind();
    }
    return "none";
  };
  CHECK(kind_of({.size = 0}) == "invalid-argument");
  CHECK(kind_of({.size = 20000}) == "invalid-argument");
  CHECK(kind_of({.size = 64, .padding = -1}) == "invalid-argument");
  CHECK(kind_of({.size = 64, .padding = NAN}) == "invalid-argument");
  CHECK(kind_of({.size = 16, .padding = 16}) == "unsupported");
}
