// Variables of a map: which coordinates share one, which stay.
#include "untangle/tetrahedra/variables.h"

#include <doctest/doctest.h>

#include <limits>
#include <vector>

#include "base/error.h"

using namespace orbicube;
using untangle::Index;
using untangle::no_index;
using untangle::Variables;
using untangle::Vector3;

namespace {

const std::vector<Vector3> start = {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}};

std::string refusal(const std::vector<Vector3>& positions, const std::vector<std::uint8_t>& fixed,
                    const std::vector<Index>& ties) {
  try {
    const Variables variables(positions, fixed, ties, std::pmr::get_default_resource());
  } catch (const base::Error& error) {
    return std::string(error.kind()) + ": " + error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("Without ties and fixed coordinates each has a variable of its own") {
  const Variables variables(start, {}, {}, std::pmr::get_default_resource());
  CHECK(variables.vertices() == 3);
  CHECK(variables.free() == 9);
  CHECK(variables.size() == 9);
  std::vector<Vector3> positions(3);
  variables.expand(variables.start(), positions);
  CHECK(positions == start);
}

TEST_CASE("A group is one variable at its mean, a fixed one stays, and derivatives add up") {
  std::vector<std::uint8_t> fixed(9, 0);
  std::vector<Index> ties(9, no_index);
  ties[0] = ties[3] = ties[8] = 5;  // 0, 3, 8
  ties[1] = ties[7] = 2;            // 1, 7, held at 7
  fixed[7] = 1;
  fixed[2] = 1;
  const Variables variables(start, fixed, ties, std::pmr::get_default_resource());
  CHECK(variables.free() == 3 + 1);  // y and z of vertex 1, x and y of vertex 2 less the held one; the group
  CHECK(variables.size() == variables.free() + 2);
  CHECK(variables.of(0, 0) == variables.of(1, 0));
  CHECK(variables.of(0, 0) == variables.of(2, 2));
  CHECK(variables.is_free(0, 0));
  CHECK(!variables.is_own(0, 0));
  CHECK(!variables.is_free(0, 1));
  CHECK(!variables.is_free(0, 2));
  CHECK(variables.is_own(1, 1));
  std::vector<Vector3> positions(3);
  variables.expand(variables.start(), positions);
  const double mean = 11.0 / 3;
  CHECK(positions == std::vector<Vector3>{{mean, 7, 2}, {mean, 4, 5}, {6, 7, mean}});
  std::vector<double> sums(variables.free());
  variables.reduce(start, sums);
  CHECK(sums[variables.of(0, 0)] == 11);
  CHECK(sums[variables.of(1, 1)] == 4);
  CHECK(sums[variables.of(1, 2)] == 5);
  CHECK(sums[variables.of(2, 0)] == 6);
}

TEST_CASE("What makes no sense is refused with its place") {
  const std::vector<Index> none(9, no_index);
  CHECK(refusal(start, {}, {}) == "");
  CHECK(refusal(start, std::vector<std::uint8_t>(8, 0), {}).starts_with("invalid-argument"));
  CHECK(refusal(start, {}, std::vector<Index>(10, no_index)).starts_with("invalid-argument"));
  auto ties = none;
  ties[4] = 9;
  CHECK(refusal(start, {}, ties).find("y of vertex 1") != std::string::npos);
  ties[4] = ties[8] = 0;
  CHECK(refusal(start, {}, ties) == "");
  const std::string contradiction = refusal(start, std::vector<std::uint8_t>(9, 1), ties);
  CHECK(contradiction.find("y of vertex 1") != std::string::npos);
  CHECK(contradiction.find("z of vertex 2") != std::string::npos);
  auto positions = start;
  positions[2][0] = std::numeric_limits<double>::quiet_NaN();
  CHECK(refusal(positions, {}, {}).find("x of vertex 2") != std::string::npos);
}
