// The feature graph of a surface: which edges are features, by dihedral angle, by tags or by both, and the corners,
// arcs and patches of the graph.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "base/error.h"
#include "mesh/features/feature_graph.h"
#include "mesh/files/feature_tags.h"
#include "tests/base/quiet_host.h"

using namespace orbicube;
using namespace orbicube::mesh;
using test::host;

namespace {

// A prism over a polygon, with walls of one quad each cut along a diagonal and its ends as fans about vertex 0 and 1.
Mesh prism(std::span<const double> degrees, double height) {
  Mesh m(host.memory);
  m.positions = {Vector3(0, 0, 0), Vector3(0, 0, height)};
  for (const double d : degrees) {
    const double a = d * std::numbers::pi / 180;
    m.positions.emplace_back(std::cos(a), std::sin(a), 0);
    m.positions.emplace_back(std::cos(a), std::sin(a), height);
  }
  const auto n = static_cast<Index>(degrees.size());
  for (Index k = 0; k < n; ++k) {
    const Index a = 2 + 2 * k, b = 2 + 2 * ((k + 1) % n);
    m.triangles.push_back({a, b, b + 1});
    m.triangles.push_back({a, b + 1, a + 1});
    m.triangles.push_back({0, b, a});
    m.triangles.push_back({1, a + 1, b + 1});
  }
  return m;
}

std::vector<double> regular_polygon(int sides) {
  std::vector<double> degrees;
  for (int k = 0; k < sides; ++k)
    degrees.push_back(360.0 * k / sides);
  return degrees;
}

FeatureGraph graph_of(const Mesh& m, const FeatureOptions& options) {
  return feature_graph(m.positions, m.triangles, options, host);
}

}  // namespace

TEST_CASE("A cube has eight corners, twelve arcs and six patches, each a disk") {
  const Mesh cube = prism(regular_polygon(4), std::numbers::sqrt2);
  const FeatureGraph graph = graph_of(cube, {});
  CHECK(graph.corners.size() == 8);
  CHECK(std::none_of(graph.corners.begin(), graph.corners.end(), [](const FeatureCorner& c) { return c.soft; }));
  CHECK(graph.arcs.size() == 12);
  CHECK(graph.sharp_length == doctest::Approx(12 * std::numbers::sqrt2));
  CHECK(graph.euler == Array<std::int64_t>(6, 1));
  for (Index c = 0; c < 8; ++c)
    CHECK(graph.around.size(c) == 3);
}

TEST_CASE("Tagged edges are features whatever their angle, and without sharp edges the only ones") {
  const Mesh cube = prism(regular_polygon(4), std::numbers::sqrt2);
  // The border of the bottom and a diagonal of it through its middle.
  const std::array<Edge, 6> tags = {{{2, 4}, {4, 6}, {6, 8}, {8, 2}, {2, 0}, {0, 6}}};
  FeatureGraph graph = graph_of(cube, {.sharp = false, .edges = tags});
  CHECK(graph.arcs.size() == 5);  // the bends at 4 and 8 are corners
  CHECK(graph.corners.size() == 4);
  CHECK(graph.euler == Array<std::int64_t>(3, 1));
  const std::array<Index, 1> middle = {0};
  graph = graph_of(cube, {.sharp = false, .edges = tags, .corners = middle});
  CHECK(graph.arcs.size() == 6);
  CHECK(graph.corners.size() == 5);
  graph = graph_of(cube, {.edges = tags});
  CHECK(graph.arcs.size() == 13);
  // Edges and vertices that the surface does not have.
  const std::array<Edge, 2> unknown = {{{4, 8}, {100, 2}}};
  const std::array<Index, 1> far = {100};
  CHECK(graph_of(cube, {.sharp = false, .edges = unknown, .corners = far}).corners.empty());
}

TEST_CASE("Weak lines are those at which the surface turns more than beside them") {
  const auto vertical = [](Index k) { return Edge{2 + 2 * k, 3 + 2 * k}; };
  // Five walls; of the edges between them one turns by 50 degrees, the others by more than 60.
  const std::vector<double> walls = {0, 50, 136.7, 223.3, 310};
  const Mesh part = prism(walls, 1);
  const std::array<Edge, 1> tag = {vertical(0)};
  CHECK(graph_of(part, {.angle = 60}).sharp_edges == 14);
  CHECK(graph_of(part, {.angle = 60, .lines = tag}).sharp_edges == 14);
  CHECK(graph_of(part, {.angle = 60, .lines = tag, .weak_lines = true}).sharp_edges == 15);
  // A line goes no further along edges that are features already: the flat diagonal of a wall beside a sharp edge.
  const Mesh cube = prism(regular_polygon(4), std::numbers::sqrt2);
  const std::array<Edge, 2> bent = {{{2, 4}, {2, 5}}};
  CHECK(graph_of(cube, {.lines = bent, .weak_lines = true}).sharp_edges == 12);
  // The seam of a cylinder turns as much as any line beside it.
  const Mesh cylinder = prism(regular_polygon(24), 2);
  const std::array<Edge, 1> seam = {vertical(5)};
  const FeatureGraph round = graph_of(cylinder, {.lines = seam, .weak_lines = true});
  CHECK(round.sharp_edges == 48);
  CHECK(round.euler.size() == 3);
}

TEST_CASE("Tags follow the vertices that are welded") {
  Mesh m = prism(regular_polygon(4), 1);
  FeatureTags tags;
  const std::array<Index, 4> line = {2, 4, 10, 6};
  m.positions.push_back(m.positions[4]);  // 10
  m.positions.push_back(m.positions[2]);  // 11
  m.positions.emplace_back(5, 5, 5);      // 12
  tags.add_line(line);
  tags.vertices = {11, 12};
  renumber_as_welded(tags, m.positions, host);
  CHECK(tags.edges == std::vector<Edge>{{2, 4}, {4, 6}});
  CHECK(tags.vertices == std::vector<Index>{2, 10});
}

TEST_CASE("A line of noise is left out, and one that fades goes on where the surface still turns") {
  // A prism whose lower edge turns by 90 degrees; along its upper ends some walls are nearly level with the end.
  Mesh prism24 = prism(regular_polygon(24), 2);
  const FeatureGraph whole = graph_of(prism24, {.angle = 80});
  CHECK(whole.arcs.size() == 6);  // two circles, three arcs each
  // Two neighboring vertices of the upper circle lower: the edges beside them turn by less than 80 degrees, but by more
  // than half of that.
  for (const Index v : {Index{3}, Index{5}})
    prism24.positions[v] = Vector3(prism24.positions[v].x(), prism24.positions[v].y(), 1.7);
  const FeatureGraph faded = graph_of(prism24, {.angle = 80});
  CHECK(faded.arcs.size() == 6);
  // The ends of what is left of the sharp line are vertices of it.
  CHECK(whole.fades.empty());
  REQUIRE(faded.fades.size() >= 2);
  for (const Index v : faded.fades)
    CHECK(std::find(faded.vertices.begin(), faded.vertices.end(), v) != faded.vertices.end());
  CHECK(faded.euler == whole.euler);
  CHECK(std::all_of(faded.corners.begin(), faded.corners.end(), [](const FeatureCorner& c) { return c.soft; }));
}

TEST_CASE("Where a line bends again soon there is a bend of an arc in place of a corner") {
  // Two low pyramids on an octagon with sides of 0.77: its edges turn by 57 degrees and bend by 45, all others turn by
  // 21.
  Mesh m(host.memory);
  for (Index k = 0; k < 8; ++k) {
    const double angle = k * std::numbers::pi / 4;
    m.positions.emplace_back(std::cos(angle), std::sin(angle), 0);
    m.triangles.push_back({k, (k + 1) % 8, 8});
    m.triangles.push_back({(k + 1) % 8, k, 9});
  }
  m.positions.emplace_back(0, 0, 0.5);
  m.positions.emplace_back(0, 0, -0.5);
  const FeatureGraph corners = graph_of(m, {.angle = 40, .shortest_side = 0.7});
  CHECK(corners.corners.size() == 8);
  CHECK(corners.arcs.size() == 8);
  CHECK(corners.bends.empty());
  const FeatureGraph bends = graph_of(m, {.angle = 40, .shortest_side = 0.8});
  CHECK(bends.bends.size() == 8);
  CHECK(bends.corners.size() == 3);
  CHECK(std::all_of(bends.corners.begin(), bends.corners.end(), [](const FeatureCorner& c) { return c.soft; }));
  CHECK(bends.arcs.size() == 3);
  CHECK(bends.euler == corners.euler);
  CHECK(bends.patches == corners.patches);
}

TEST_CASE("Edges that are left out join patches, and take with them what would end inside one") {
  const Mesh cube = prism(regular_polygon(4), std::numbers::sqrt2);
  // One edge of the lower end; then another one at the same corner, whose third edge would end there.
  const std::vector<Edge> edges = {{2, 4}, {4, 6}};
  const FeatureGraph one = graph_of(cube, {.without = std::span(edges).first(1)});
  CHECK(one.arcs.size() == 11);
  CHECK(one.euler == Array<std::int64_t>(5, 1));
  CHECK(graph_of(cube, {}).left_out.empty());
  REQUIRE(one.left_out.size() == 1);
  CHECK(std::set<Index>(one.left_out[0].begin(), one.left_out[0].end()) == std::set<Index>{2, 4});
  const FeatureGraph two = graph_of(cube, {.without = edges});
  CHECK(two.arcs.size() == 9);
  CHECK(two.euler == Array<std::int64_t>(4, 1));  // three faces at the corner are one
  CHECK(two.left_out.size() == 3);                // lines end where others meet
  for (std::size_t c = 0; c < two.corners.size(); ++c)
    CHECK(two.around.size(static_cast<Index>(c)) > 1);
  const std::vector<Edge> unknown = {{2, 1000}, {1000, 2}};
  CHECK(graph_of(cube, {.without = unknown}).arcs.size() == 12);
}
