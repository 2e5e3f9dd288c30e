// Texture atlases of polycubes: patches lie apart, keep their shape, and each texel knows what it shows.
#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <string_view>
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
  explicit Made(const AtlasOptions& options)
      : map(example()), graph(make_patch_graph(map, host)), atlas(make_atlas(graph, options, host)) {}

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
  const AtlasTexels texels = covered_texels(made.atlas, made.graph, made.map, host);
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
      const Vector3 weights = weights_at(made.atlas, made.graph, made.map, texels, texel);
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
