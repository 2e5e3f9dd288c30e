// What no map can be made of is refused with its kind, its number and where it is; pieces are distinguished.
#include "volume_map/input/solid_pieces.h"

#include <doctest/doctest.h>

#include <array>
#include <string>
#include <vector>

#include "base/error.h"
#include "box_surface.h"
#include "tests/untangle/tangled_cases.h"
#include "volume_map/input/solid_boundary.h"

using namespace orbicube;
using namespace orbicube::volume_map;
using mesh::Triangle;

namespace {

using Surface = volume_map::test::BoxSurface;

template <class Work>
std::string refusal(const Work& work) {
  try {
    work();
  } catch (const base::Error& error) {
    return std::string(error.kind()) + ": " + error.what();
  }
  return "";
}

bool tells(const std::string& refusal, const std::string& kind, const std::string& place) {
  CAPTURE(refusal);
  CHECK(refusal.starts_with(kind + ": "));
  CHECK(refusal.find(place) != std::string::npos);
  return refusal.starts_with(kind + ": ") && refusal.find(place) != std::string::npos;
}

mesh::Mesh solid_of(const std::vector<untangle::test::Block>& blocks, int n) {
  const untangle::test::BlockMesh made(blocks, n);
  mesh::Mesh result;
  result.positions.assign(made.positions.begin(), made.positions.end());
  result.tetrahedra.assign(made.tetrahedra.begin(), made.tetrahedra.end());
  return result;
}

}  // namespace

TEST_CASE("Surfaces that bound no solid are refused with the location") {
  const base::Host host;
  const auto closed = [&](const Surface& s) {
    return refusal([&] { require_closed_surface(s.positions, s.triangles, host); });
  };
  Surface good;
  good.add_box({1, 2, 3}, {1, 1, 1});
  CHECK(closed(good) == "");
  Surface s = good;
  s.triangles.pop_back();
  tells(closed(s), "not-closed", "(2, ");
  s = good;
  s.triangles.push_back(s.triangles[4]);
  tells(closed(s), "duplicate-face", "12");
  s = good;
  s.triangles.push_back({0, 1, 7});
  tells(closed(s), "non-manifold-edge", "1-0, at (2, 2, 3)");
  s = good;
  s.triangles[3] = {5, 5, 6};
  tells(closed(s), "degenerate-face", "face 3, at (2, 2, 4)");
  s = good;
  s.add_box({2, 3, 4}, {1, 1, 1});
  for (Triangle& t : s.triangles) {
    for (Index& v : t)
      v = v == 8 ? 7 : v;
  }
  tells(closed(s), "non-manifold-vertex", "7, at (2, 3, 4)");
  s = good;
  s.positions[3] = 0.5 * (s.positions[1] + s.positions[2]);
  tells(closed(s), "degenerate-face", "face 1, at (2, 2, 3)");
  s.triangles.clear();
  CHECK(closed(s).starts_with("empty-mesh"));
}

TEST_CASE("Parts beside each other are pieces, and parts that meet are refused") {
  const base::Host host;
  Surface s;
  s.add_box({0, 0, 0}, {1, 1, 1});
  s.add_box({5, 0, 0}, {3, 3, 3});
  s.add_box({5, 9, 0}, {1, 1, 1}, true);
  const SurfacePieces pieces = surface_pieces(s.positions, s.triangles, host);
  CHECK(pieces.count == 3);
  for (std::size_t i = 0; i < s.triangles.size(); ++i)
    CHECK(pieces.of[i] == i / 12);
  mesh::Mesh whole;
  whole.positions.assign(s.positions.begin(), s.positions.end());
  whole.triangles.assign(s.triangles.begin(), s.triangles.end());
  const mesh::Mesh second = PieceCutter(whole, pieces, host).piece(1);
  CHECK(second.positions.size() == 8);
  CHECK(second.positions[0] == Vector3(5, 0, 0));
  CHECK(second.triangles.size() == 12);
  CHECK(second.triangles[0] == Triangle{0, 2, 1});
  CHECK(refuse_self_intersections(s.positions, s.triangles, 0, host) == 0);

  CHECK(pieces.cavities == 0);
  for (std::size_t i = 0; i < s.triangles.size(); ++i)
    CHECK(pieces.wrong_side[i] == (i < 24 ? 0 : 1));

  Surface crossing = s;
  crossing.add_box({0.5, 0.25, 0.25}, {1, 0.5, 0.5});
  tells(refusal([&] { refuse_self_intersections(crossing.positions, crossing.triangles, 0.05, host); }),
        "self-intersection", "parts of the surface meet, first in faces 10 and ");
  // However many may.
  tells(refusal([&] { refuse_self_intersections(crossing.positions, crossing.triangles, 1, host); }),
        "self-intersection", "parts of the surface meet");
  // One part through itself: a corner of the first box pushed through the face across.
  Surface through;
  through.add_box({0, 0, 0}, {1, 1, 1});
  through.positions[0] = Vector3(3, 3, 3);
  tells(refusal([&] { refuse_self_intersections(through.positions, through.triangles, 0, host); }), "self-intersection",
        "; first faces ");
  CHECK(refuse_self_intersections(through.positions, through.triangles, 1, host) > 0);
}

TEST_CASE("A part within another is a cavity of it, and a part within that a piece again") {
  const base::Host host;
  Surface s;
  s.add_box({2, 2, 2}, {5, 5, 5});        // in the cavity
  s.add_box({1, 1, 1}, {7, 7, 7}, true);  // the cavity
  s.add_box({0, 0, 0}, {9, 9, 9});
  s.add_box({3, 3, 3}, {1, 1, 1});  // two cavities of the first, one of which looks to the wrong side
  s.add_box({5, 5, 5}, {1, 1, 1}, true);
  const SurfacePieces pieces = surface_pieces(s.positions, s.triangles, host);
  CHECK(pieces.count == 2);
  CHECK(pieces.cavities == 3);
  constexpr std::array<std::size_t, 5> piece_of = {0, 1, 1, 0, 0};
  for (std::size_t i = 0; i < s.triangles.size(); ++i) {
    CHECK(pieces.of[i] == piece_of[i / 12]);
    CHECK(pieces.wrong_side[i] == (i / 12 == 3 ? 1 : 0));
  }
}

TEST_CASE(
    "Solids of several pieces, or that are none are refused with the location, cavities are part of the boundary") {
  const base::Host host;
  const auto whole = [&](const mesh::Mesh& m) { return refusal([&] { boundary_first(m, host); }); };
  const mesh::Mesh good = solid_of({{0, 0, 0}, {1, 0, 0}}, 2);
  CHECK(whole(good) == "");
  CHECK(pieces_of(good.tetrahedra, good.positions.size(), host).count == 1);

  std::vector<untangle::test::Block> shell;
  for (int i = 0; i < 27; ++i) {
    if (i != 13) shell.push_back({i / 9, i / 3 % 3, i % 3});
  }
  const mesh::Mesh hollow = solid_of(shell, 1);
  CHECK(pieces_of(hollow.tetrahedra, hollow.positions.size(), host).count == 1);
  const BoundaryFirst boundary = boundary_first(hollow, host);
  CHECK(boundary.surface.size() == 2 * (54 + 6));
  CHECK(boundary.outer == 64);

  const mesh::Mesh two = solid_of({{0, 0, 0}, {4, 0, 0}}, 1);
  const Pieces pieces = pieces_of(two.tetrahedra, two.positions.size(), host);
  CHECK(pieces.count == 2);
  tells(whole(two), "not-connected", "tetrahedron 6, at (4, 0, 0)");
  for (std::size_t i = 0; i < 2; ++i)
    CHECK(whole(PieceCutter(two, pieces, host).piece(i)) == "");

  mesh::Mesh inverted = good;
  inverted.positions[inverted.tetrahedra[0][3]] = Vector3(-3, -3, -3);
  tells(whole(inverted), "inverted-cell", ", at (");
}

TEST_CASE("Tetrahedra that can never be positive together are refused before anything is moved") {
  untangle::test::TangledCase c = untangle::test::strewn(1, 2, 1, 3);
  const base::Host host;
  const auto tried = [&](const untangle::test::TangledCase& t) {
    return refusal([&] { untangle::untangle_tetrahedra(t.mesh(), {}, host); });
  };
  untangle::test::TangledCase bad = c;
  bad.rest.clear();
  std::swap(bad.tetrahedra[7][1], bad.tetrahedra[7][2]);
  tells(tried(bad), "inconsistent-orientation", ", at (");
  bad = c;
  bad.rest.clear();
  const auto t = bad.tetrahedra[0];
  bad.tetrahedra.push_back({t[0], t[1], t[2], static_cast<Index>(bad.start.size() - 1)});
  bad.tetrahedra.push_back({t[0], t[1], t[2], static_cast<Index>(bad.start.size() - 2)});
  tells(tried(bad), "non-manifold-face", ", at (");
}
