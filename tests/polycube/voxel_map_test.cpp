// Layouts drawn on surfaces and maps to voxel polycubes: edits that are undone to the bit, drawings with the layout's
// combinatorics, maps that the certificate accepts.
#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <random>
#include <set>

#include "base/error.h"
#include "blocks.h"
#include "mesh/topology/topology.h"
#include "polycube/layout/planar_star.h"
#include "polycube/surface/surface_decimation.h"
#include "polycube/voxels/voxel_construction.h"
#include "shapes.h"
#include "tests/base/quiet_host.h"

using namespace orbicube;
using namespace orbicube::polycube;
using test::area_of;
using test::host;
using test::shape;

namespace {

// The layout of a block of cells in the box of a surface.
Layout layout_of(const std::vector<test::Cell>& cells, const mesh::Mesh& m) {
  std::array<Array<double>, 3> planes;
  Vector3 low = m.positions[0], high = low;
  for (const Vector3& p : m.positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  test::Cell size{};
  for (const test::Cell& c : cells)
    for (std::size_t a = 0; a < 3; ++a)
      size[a] = std::max(size[a], c[a] + 1);
  for (std::size_t a = 0; a < 3; ++a) {
    const auto i = static_cast<Eigen::Index>(a);
    for (int k = -1; k <= size[a] + 1; ++k)
      planes[a].push_back(low[i] + (high[i] - low[i]) * k / size[a]);
  }
  VoxelSolid solid(std::move(planes), host.memory);
  for (const test::Cell& c : cells)
    solid.set(solid.place({c[0] + 1, c[1] + 1, c[2] + 1}), true);
  return make_layout(solid, host);
}

// A floor with as many by as many protrusions on it.
std::vector<test::Cell> knobs(int count) {
  std::vector<test::Cell> cells = test::box_without({2 * count - 1, 2 * count - 1, 1});
  for (int x = 0; x < count; ++x)
    for (int y = 0; y < count; ++y)
      cells.push_back({2 * x, 2 * y, 1});
  return cells;
}

// The layout of a block of cells drawn on a surface.
struct Traced {
  Traced(const std::vector<test::Cell>& cells, const mesh::Mesh& m)
      : layout(layout_of(cells, m)), surface(m.positions, m.triangles, host), drawing(trace(layout, surface, host)) {}

  Layout layout;
  EditableSurface surface;
  Drawing drawing;
};

}  // namespace

TEST_CASE("Splits keep a closed surface and its area, and sources give the positions") {
  const mesh::Mesh m = shape("torus", 800);
  EditableSurface surface(m.positions, m.triangles, host);
  std::mt19937_64 random(5);
  for (int i = 0; i < 300; ++i) {
    if (i % 4 == 0)
      surface.split_face(static_cast<Index>(random() % surface.faces()));
    else
      surface.split_edge(static_cast<Index>(random() % (3 * surface.faces())), 0.3);
  }
  const auto topology = mesh::topology(surface.position, surface.triangle, host);
  CHECK(topology.manifold());
  CHECK(topology.closed());
  CHECK(topology.genus == 1);
  // Sums of as many triangles round to about that.
  CHECK(area_of(surface.position, surface.triangle) ==
        doctest::Approx(area_of(m.positions, m.triangles)).epsilon(1e-11));
  for (Index v = 0; v < surface.vertices(); ++v) {
    Vector3 p = Vector3::Zero();
    for (std::size_t k = 0; k < 3; ++k)
      if (surface.source[v].corner[k] != no_index)
        p += surface.source[v].weight[k] * m.positions[surface.source[v].corner[k]];
    CHECK((p - surface.position[v]).norm() < 1e-13);  // positions are about 1
  }
  for (Index h = 0; h < 3 * surface.faces(); ++h) {
    CHECK(surface.opposite(surface.opposite(h)) == h);
    CHECK(surface.start(surface.opposite(h)) == surface.end(h));
  }
}

TEST_CASE("Drawings have the layout's rotation at every node, and paths meet at nodes only") {
  struct Case {
    std::vector<test::Cell> cells;
    const char* shape;
  };
  // What is drawn need not be like the shape.
  const std::vector<Case> cases = {
      {test::box_without({1, 1, 1}), "sphere"},
      {test::box_without({2, 2, 2}, {{1, 1, 1}}), "sphere"},
      {test::box_without({3, 3, 3}, {{0, 0, 0}, {2, 2, 2}}), "sphere"},
      {test::box_without({3, 3, 1}, {{1, 1, 0}}), "torus"},
  };
  for (const Case& c : cases) {
    const Traced traced(c.cells, shape(c.shape, 1500));
    const Layout& layout = traced.layout;
    std::set<Index> seen(traced.drawing.node_vertex.begin(), traced.drawing.node_vertex.end());
    CHECK(seen.size() == layout.nodes.size());
    for (Index arc = 0; arc < layout.arcs(); ++arc) {
      const auto& path = traced.drawing.path[arc];
      CHECK(path.front() == traced.drawing.node_vertex[layout.origin(2 * arc)]);
      CHECK(path.back() == traced.drawing.node_vertex[layout.target(2 * arc)]);
      for (std::size_t i = 1; i + 1 < path.size(); ++i)
        CHECK(seen.insert(path[i]).second);
      for (std::size_t i = 0; i + 1 < path.size(); ++i)
        CHECK(traced.surface.arc[traced.surface.between(path[i], path[i + 1])] == arc);
    }
    for (Index n = 0; n < layout.nodes.size(); ++n) {
      std::vector<Index> drawn;
      traced.surface.for_each_outgoing(traced.drawing.node_vertex[n], [&](Index h) {
        if (traced.surface.arc[h] == no_index) return;
        const Index arc = traced.surface.arc[h];
        drawn.push_back(layout.origin(2 * arc) == n ? 2 * arc : 2 * arc + 1);
      });
      std::vector<Index> wanted(layout.darts_of(n).begin(), layout.darts_of(n).end());
      REQUIRE(drawn.size() == wanted.size());
      std::rotate(wanted.begin(), std::find(wanted.begin(), wanted.end(), drawn[0]), wanted.end());
      CHECK(drawn == wanted);
    }
  }
}

TEST_CASE("Polycubes with many corners on surfaces with few triangles are drawn, or refused, in bounded work") {
  mesh::Mesh tetrahedron;
  tetrahedron.positions = {{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}};
  tetrahedron.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  std::size_t refused_at_once = 0;
  for (const int count : {1, 2, 3, 9}) {
    CAPTURE(count);
    const Layout layout = layout_of(knobs(count), tetrahedron);
    EditableSurface surface(tetrahedron.positions, tetrahedron.triangles, host);
    bool drawn = true;
    try {
      trace(layout, surface, host);
    } catch (const base::Error& error) {
      CHECK(error.status() == base::Status::no_valid_result);
      drawn = false;
    }
    if (count == 1) CHECK(drawn);
    // Searches take time in proportion to the faces. One split adds two.
    CHECK(surface.faces() <= 40'002);
    if (layout.nodes.size() > 416) {
      CHECK_FALSE(drawn);
      CHECK(surface.faces() == 4);  // refused before anything is done
      ++refused_at_once;
    }
  }
  CHECK(refused_at_once > 0);
}

TEST_CASE("Collapses that are undone leave the surface as it was, and the drawing while it is coarse") {
  Traced traced(test::box_without({2, 2, 2}, {{1, 1, 1}}), shape("sphere", 3000));
  EditableSurface& surface = traced.surface;
  const std::vector<Triangle> triangles(surface.triangle.begin(), surface.triangle.end());
  const std::vector<Index> arcs(surface.arc.begin(), surface.arc.end());
  const Array<Index> collapsed = decimate(traced.layout, surface, traced.drawing, 150, host);
  CHECK(collapsed.size() > 1000);
  std::vector<Triangle> coarse;
  for (Index f = 0; f < surface.faces(); ++f)
    if (surface.alive(f)) coarse.push_back(surface.triangle[f]);
  const auto topology = mesh::topology(surface.position, coarse, host);
  CHECK(topology.manifold());
  CHECK(topology.genus == 0);
  for (Index f = 0; f < surface.faces(); ++f) {
    if (!surface.alive(f)) continue;
    for (Index k = 0; k < 3; ++k) {
      const Index h = 3 * f + k;
      CHECK(surface.arc[h] == surface.arc[surface.opposite(h)]);
      const bool chord =
          surface.arc[h] == no_index && surface.occupied[surface.start(h)] && surface.occupied[surface.end(h)];
      CHECK_FALSE(chord);
    }
  }
  for (auto h = collapsed.rbegin(); h != collapsed.rend(); ++h)
    surface.undo_collapse(*h);
  CHECK(std::equal(triangles.begin(), triangles.end(), surface.triangle.begin()));
  CHECK(std::equal(arcs.begin(), arcs.end(), surface.arc.begin()));
  for (Index h = 0; h < 3 * surface.faces(); ++h)
    CHECK(surface.start(surface.opposite(h)) == surface.end(h));
}

TEST_CASE("Steps of a vertex lower the energy, keep the signs, and end where no direction leads down") {
  // The top of a cube's face, its middle vertex moved.
  mesh::Mesh m;
  m.positions = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 0}, {1, 1, -1}};
  m.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}};
  const EditableSurface surface(m.positions, m.triangles, host);
  const Array<AxisLabel> labels(8, label_of(2, 1));
  const Array<Index> facets(8, 0);
  Array<Vector3> image(m.positions.begin(), m.positions.end());
  image[4] = {1.9, 0.3, 0};
  const MapView view{surface, labels, facets, image, 1, 1e-9};
  PlanarStar star(host.memory);
  double before = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 30; ++i) {
    star.gather(view, 4);
    CHECK(star.freedoms() == 2);
    CHECK(star.positive());
    CHECK(star.energy() <= before);
    before = star.energy();
    star.improve(view);
  }
  // The identity is the optimum: energy 4 a unit of area.
  CHECK(before == doctest::Approx(16).epsilon(1e-12));
  CHECK((image[4] - Vector3(1, 1, 0)).norm() < 1e-6);
  // From anywhere, even outside, a vertex is put where all see it.
  image[4] = {5, -3, 0};
  star.gather(view, 4);
  CHECK_FALSE(star.positive());
  REQUIRE(star.place(view));
  CHECK(star.positive());
}

TEST_CASE("Voxel polycubes of shapes of several genera have certified maps within their budgets" *
          doctest::test_suite("long")) {
  struct Case {
    const char* name;
    std::size_t corners, reached;
  };
  for (const Case& c : {Case{"sphere", 8, 8}, Case{"creature", 40, 40}, Case{"torus", 16, 16}}) {
    CAPTURE(c.name);
    const mesh::Mesh m = shape(c.name, 2500);
    const SurfaceMap map = construct_by_voxels(m.positions, m.triangles, {c.corners}, host).map;
    const Certificate certificate = certify(map.polycube, map.triangles, host);
    CHECK(certificate.valid());
    CHECK(certificate.corners <= c.reached);
    CHECK(certificate.genus == *mesh::topology(m.positions, m.triangles, host).genus);
    CHECK(std::equal(m.positions.begin(), m.positions.end(), map.positions.begin()));
    CHECK(area_of(map.positions, map.triangles) == doctest::Approx(area_of(m.positions, m.triangles)).epsilon(1e-11));
    // Each triangle lies in one of the input and looks where that looks; added vertices are where their sources say.
    for (std::size_t i = 0; i < map.triangles.size(); ++i) {
      const Triangle &t = map.triangles[i], &source = m.triangles[map.triangle_sources[i]];
      const auto normal = [](std::span<const Vector3> p, const Triangle& f) {
        return (p[f[1]] - p[f[0]]).cross(p[f[2]] - p[f[0]]);
      };
      CHECK(normal(map.positions, t).dot(normal(m.positions, source)) > 0);
      for (const Index v : t) {
        Vector3 there = Vector3::Zero();
        bool within = true;
        for (std::size_t k = 0; k < 3; ++k) {
          const Index corner = map.vertex_sources[v].corner[k];
          if (corner == no_index) continue;
          within = within && std::find(source.begin(), source.end(), corner) != source.end();
          there += map.vertex_sources[v].weight[k] * m.positions[corner];
        }
        CHECK(within);
        CHECK((there - map.positions[v]).norm() < 1e-13);  // positions are about 1
      }
    }
    if (c.corners != 16) continue;
    // The same bits again.
    const SurfaceMap again = construct_by_voxels(m.positions, m.triangles, {c.corners}, host).map;
    CHECK(std::equal(map.polycube.begin(), map.polycube.end(), again.polycube.begin(), again.polycube.end()));
  }
}
