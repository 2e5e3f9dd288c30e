#include "base/counted.h"

#include <doctest/doctest.h>

namespace orbicube::base {
namespace {

TEST_CASE("A counted noun is singular for one only, whatever the kind of the number") {
  CHECK(counted(std::size_t{1}, "face") == "1 face");
  CHECK(counted(std::size_t{0}, "face") == "0 faces");
  CHECK(counted(2U, "vertex", "vertices") == "2 vertices");
  CHECK(counted(1, "vertex is", "vertices are") == "1 vertex is");
  CHECK(counted(-1, "entry", "entries") == "-1 entries");
}

}  // namespace
}  // namespace orbicube::base
