// Surfaces made coarser and filled by a function: which ones it gets.
#include "volume_map/input/filled_solid.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "base/error.h"
#include "mesh/shapes/make_shape.h"
#include "tests/base/quiet_host.h"

using namespace orbicube;
using namespace orbicube::volume_map;
using orbicube::test::host;

namespace {

// Refuses surfaces of fewer than `fewest` or more than `most` triangles.
struct Filling {
  std::size_t fewest = 0, most = SIZE_MAX;
  const char* kind = "self-intersection";
  std::vector<std::size_t> sizes = {};

  FillSurface function() {
    return [this](auto positions, auto triangles, double max_volume, const base::Host&) {
      sizes.push_back(triangles.size());
      CHECK(max_volume > 0);
      if (triangles.size() < fewest || triangles.size() > most) throw base::Error(kind, "refused");
      mesh::Mesh solid;
      solid.positions.assign(positions.begin(), positions.end());
      solid.tetrahedra.push_back({0, 1, 2, 3});
      return solid;
    };
  }
};

std::string kind_of_failure(const mesh::Mesh& surface, Filling& filling, std::size_t triangles = 1000) {
  try {
    filled_solid(surface, triangles, filling.function(), host);
  } catch (const base::Error& error) {
    return error.kind();
  }
  return "";
}

}  // namespace

TEST_CASE("Fine surfaces are filled coarser, finer where that is refused, and coarser still in the end") {
  const mesh::Mesh surface = mesh::make_shape("sphere", {.triangles = 5000}, host);
  const std::size_t all = surface.triangles.size();
  Filling any;
  const FilledSolid filled = filled_solid(surface, 1000, any.function(), host);
  CHECK(any.sizes.size() == 1);
  CHECK(any.sizes[0] < 1200);
  CHECK(filled.surface.size() == any.sizes[0]);
  Filling fine{.fewest = 1500};
  filled_solid(surface, 1000, fine.function(), host);
  CHECK(fine.sizes.size() == 2);
  CHECK(fine.sizes[1] > 1500);
  Filling coarse{.most = 700};
  filled_solid(surface, 1000, coarse.function(), host);
  CHECK(coarse.sizes.size() > 3);
  CHECK(coarse.sizes.back() <= 700);
  Filling never{.fewest = SIZE_MAX};
  CHECK(kind_of_failure(surface, never) == "self-intersection");
  Filling other{.fewest = SIZE_MAX, .kind = "no-valid-result"};
  CHECK(kind_of_failure(surface, other) == "no-valid-result");
  CHECK(other.sizes.back() == all);
  // From next to nothing, with a surface that is small itself.
  for (const std::size_t few : {1U, 10U, 200U}) {
    Filling from_few{.fewest = SIZE_MAX};
    CHECK(kind_of_failure(surface, from_few, few) == "self-intersection");
    const mesh::Mesh small = mesh::make_shape("sphere", {.triangles = 300}, host);
    Filling of_small{.fewest = SIZE_MAX};
    CHECK(kind_of_failure(small, of_small, few) == "self-intersection");
    CHECK(of_small.sizes.back() <= small.triangles.size());
  }
  Filling cancelled{.fewest = SIZE_MAX, .kind = "cancelled"};
  CHECK(kind_of_failure(surface, cancelled) == "cancelled");
  CHECK(cancelled.sizes.size() == 1);
  CHECK(coarse_target(0, all) == all);
  CHECK_THROWS_AS(filled_solid(surface, 1000, {}, host), base::Error);
}
