// Computed fields: optima that are known, alignment, invariance, equal bits, constraints, and the seed's method.
#include "frame_field/frame_field.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>
#include <numbers>
#include <numeric>
#include <random>

#include "base/error.h"
#include "frame_field/graph/boundary_indices.h"
#include "frame_field/graph/hierarchy.h"
#include "frame_field/singularities/measurement.h"
#include "frame_field/singularities/singularities.h"
#include "frame_field/smoothing/energy.h"
#include "frame_field/smoothing/recombination.h"
#include "frame_field/smoothing/smoothing.h"
#include "frame_field/smoothing/starts.h"
#include "quaternion/frame_distance.h"
#include "solids.h"

using namespace orbicube;
using namespace orbicube::frame_field;
using test::computed;

namespace {

Measurement measured(const test::Solid& solid, const Field& field) {
  const mesh::TetrahedralConnectivity connectivity(solid.positions.size(), solid.tetrahedra, base::Host());
  return measure(solid.positions, connectivity, field, base::Host());
}

const std::vector<Start> starts = {Start::automatic, Start::identity, Start::propagated, Start::harmonic,
                                   Start::diffusion};

bool same_bits(const Field& a, const Field& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Quaternion)) == 0;
}

std::string refusal(const test::Solid& solid, const Options& options, const Given& given = {}) {
  try {
    computed(solid, options, given);
  } catch (const base::Error& e) {
    return e.kind();
  }
  return "";
}

}  // namespace

TEST_CASE("A box that stands askew has the constant field, from every start") {
  std::mt19937_64 random(1);
  test::Solid solid = test::cubes(5, 4, 6);
  const Quaternion turn = test::random_rotation(random);
  for (Vector3& p : solid.positions)
    p = test::rotated(turn, p);
  for (const Start start : {Start::automatic, Start::harmonic, Start::diffusion}) {
    const Outcome outcome = computed(solid, {.start = start});
    CHECK(outcome.energy < 1e-10);
    for (const Quaternion& q : outcome.field)
      CHECK(quaternion::symmetric_distance(q, turn) < 1e-4);
  }
}

TEST_CASE("Fields are units, aligned to 1e-6 degrees, within the bound of angles, and measured as reported") {
  for (const test::Solid& solid : {test::ball(7), test::ring(18, 3), test::shaken(test::cubes(5, 5, 5), 0.15)}) {
    for (const Start start : starts) {
      const Outcome outcome = computed(solid, {.start = start});
      const Measurement m = measured(solid, outcome.field);
      const mesh::TetrahedralConnectivity connectivity(solid.positions.size(), solid.tetrahedra, {});
      CHECK(m.norm_error < 1e-14);
      CHECK(m.one_face_max < 1e-6);
      CHECK(test::off_boundary(solid, connectivity, outcome.field) < 1e-6);
      CHECK(m.symmetric.largest <= 62.80);
      CHECK(outcome.energy == doctest::Approx(m.energy).epsilon(1e-9));
    }
  }
}

TEST_CASE("The best of all starts is no worse than any of them" * doctest::test_suite("long")) {
  const test::Solid solid = test::ball(8);
  const double best = computed(solid).energy;
  for (const Start start : starts) {
    // Candidates are smoothed until a step gains a thousandth, and then in the end.
    CHECK(best <= computed(solid, {.start = start}).energy * 1.01);
  }
}

TEST_CASE("A smoothed field is a minimum: turning any frame, within what it may, does not lower the energy") {
  const test::Solid solid = test::ball(6);
  const Outcome outcome = computed(solid, {.start = Start::harmonic, .relative_gain = 1e-12});
  const base::Host host;
  const mesh::TetrahedralConnectivity connectivity(solid.positions.size(), solid.tetrahedra, host);
  const DualGraph graph = make_dual_graph(solid.positions, connectivity, Weighting::uniform, host);
  const Constraints constraints = make_constraints(graph, solid.positions, connectivity, true, {}, {}, host);
  const Field field = by_node(graph, outcome.field, host.memory);
  const auto around = [&](Index i, const Quaternion& q) {
    double sum = 0;
    for (const Index other : graph.others[i])
      sum += other == i ? 0 : quaternion::symmetric_sine_square(q, field[other]);
    return sum;
  };
  for (Index i = 0; i < graph.size(); ++i) {
    if (!constraints.is_free(i)) continue;
    for (const Vector& axis : {Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}}) {
      const double h = 1e-4;
      const double slope = (around(i, turned(field[i], axis, h)) - around(i, turned(field[i], axis, -h))) / (2 * h);
      CHECK(std::abs(slope) < 1e-4);
    }
  }
}

TEST_CASE("Results are the same bits for any number of threads") {
  const test::Solid solid = test::ball(28);
  REQUIRE(solid.tetrahedra.size() > least_of_little);  // so that every pass uses them
  base::Host alone, crowd;
  alone.thread_count = 1;
  crowd.thread_count = 3;
  const Options options{.start = Start::harmonic, .relative_gain = 0.1};
  CHECK(same_bits(computed(solid, options, {}, crowd).field, computed(solid, options, {}, alone).field));
}

TEST_CASE("Results are the same bits for any numbers of vertices and tetrahedra" * doctest::test_suite("long")) {
  const test::Solid solid = test::shaken(test::ball(10), 1e-3);
  const Options options{.repairs = Repairs::places};
  const Outcome one = computed(solid, options);
  test::Solid other = solid;
  std::mt19937 random(3);
  const auto shuffled_numbers = [&](std::size_t count) {
    std::vector<Index> order(count);
    std::iota(order.begin(), order.end(), Index{0});
    std::shuffle(order.begin(), order.end(), random);
    return order;
  };
  const std::vector<Index> vertex = shuffled_numbers(solid.positions.size());
  const std::vector<Index> order = shuffled_numbers(solid.tetrahedra.size());
  for (std::size_t v = 0; v < vertex.size(); ++v)
    other.positions[vertex[v]] = solid.positions[v];
  for (std::size_t t = 0; t < order.size(); ++t) {
    const Tetrahedron& from = solid.tetrahedra[order[t]];
    // Another corner comes first, with the same volume.
    other.tetrahedra[t] = {vertex[from[1]], vertex[from[2]], vertex[from[0]], vertex[from[3]]};
  }
  const Outcome shuffled = computed(other, options);
  Field back(one.field.size());
  for (std::size_t t = 0; t < order.size(); ++t)
    back[order[t]] = shuffled.field[t];
  CHECK(same_bits(back, one.field));
  CHECK(shuffled.repair.after.unmeshable() == one.repair.after.unmeshable());
}

TEST_CASE("The field of a solid that is moved is the moved field" * doctest::test_suite("long")) {
  const test::Solid solid = test::shaken(test::ball(8), 0.02);
  const Outcome one = computed(solid);
  std::mt19937_64 random(2);
  for (int motion = 0; motion < 3; ++motion) {
    const Quaternion turn = test::random_rotation(random);
    test::Solid moved = solid;
    for (Vector3& p : moved.positions)
      p = test::rotated(turn, p) + Vector3(1, 2, 3);
    const Outcome other = computed(moved);
    CHECK(other.energy == doctest::Approx(one.energy).epsilon(1e-9));
    double farthest = 0;
    for (std::size_t t = 0; t < one.field.size(); ++t) {
      farthest =
          std::max(farthest, quaternion::symmetric_distance(other.field[t], quaternion::multiply(turn, one.field[t])));
    }
    // Rounding of the positions, amplified where the solver stops.
    CHECK(farthest < 1e-5);
  }
}

TEST_CASE("Given frames stay as they are, given axes are kept, and a given start is what is smoothed") {
  const test::Solid solid = test::cubes(5, 5, 5);
  std::mt19937_64 random(4);
  const std::vector<GivenFrame> frames = {{100, test::random_rotation(random)}, {400, test::random_rotation(random)}};
  const Vector axis = quaternion::rotate(test::random_rotation(random), {0, 0, 1});
  const std::vector<GivenAxis> axes = {{200, axis}};
  const Outcome outcome = computed(solid, {}, {.frames = frames, .axes = axes});
  for (const GivenFrame& g : frames)
    CHECK(quaternion::symmetric_distance(outcome.field[g.tetrahedron], g.frame) < 1e-12);
  const Vector local = quaternion::rotate(quaternion::conjugate(outcome.field[200]), axis);
  CHECK(std::max({std::abs(local.x), std::abs(local.y), std::abs(local.z)}) > 1 - 1e-12);
  CHECK(outcome.energy > 0.1);

  const std::vector<Quaternion> constant(solid.tetrahedra.size(), quaternion::normalized({1, 0.1, 0, 0}));
  CHECK(computed(solid, {.start = Start::given}, {.frames = {}, .axes = {}, .start = constant}).energy < 1e-10);
  const Outcome untouched =
      computed(solid, {.start = Start::given, .align_boundary = false}, {.frames = {}, .axes = {}, .start = constant});
  CHECK(untouched.energy < 1e-25);  // it was turned to the solid's axes and back
  CHECK(quaternion::symmetric_distance(untouched.field[0], constant[0]) < 1e-12);
}

TEST_CASE("With features, frames beside sharp edges follow them") {
  // A prism over a rhombus: its edges along z turn by 60 and 120 degrees.
  test::Solid solid = test::cubes(6, 6, 6);
  for (Vector3& p : solid.positions)
    p = Vector3(p[0] + 0.5 * p[1], std::sqrt(0.75) * p[1], p[2]);
  const Outcome outcome = computed(solid, {.feature_angle = 0.5});
  const mesh::TetrahedralConnectivity connectivity(solid.positions.size(), solid.tetrahedra, base::Host());
  const mesh::EdgeRings rings(connectivity, base::Host());
  std::size_t checked = 0;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const Vector3 a = solid.positions[rings.vertices(r)[0]], b = solid.positions[rings.vertices(r)[1]];
    const bool sharp = a.head<2>().norm() < 1e-12 && b.head<2>().norm() < 1e-12;
    if (!sharp || a[2] < 0.5 || b[2] < 0.5 || a[2] > 5.5 || b[2] > 5.5) continue;
    for (const Index face : rings.faces(r)) {
      ++checked;
      const Vector local = quaternion::rotate(
          quaternion::conjugate(outcome.field[mesh::TetrahedralConnectivity::tetrahedron_of(face)]), {0, 0, 1});
      CHECK(std::max({std::abs(local.x), std::abs(local.y), std::abs(local.z)}) > 1 - 1e-9);
    }
  }
  CHECK(checked > 4);
}

TEST_CASE("With aligned stars, frames that meet the boundary in a vertex alone follow it") {
  const test::Solid solid = test::ball(6);
  const Outcome outcome = computed(solid, {.align_stars = true});
  const mesh::TetrahedralConnectivity connectivity(solid.positions.size(), solid.tetrahedra, base::Host());
  const auto outer = connectivity.boundary_vertices(std::pmr::get_default_resource());
  std::vector<Vector3> normal(solid.positions.size(), Vector3::Zero());
  for (Index face = 0; face < connectivity.face_count(); ++face) {
    if (!connectivity.on_boundary(face)) continue;
    const auto [a, b, c] = connectivity.vertices(face);
    for (const Index v : {a, b, c}) {
      normal[v] += (solid.positions[b] - solid.positions[a]).cross(solid.positions[c] - solid.positions[a]);
    }
  }
  std::size_t checked = 0;
  for (Index t = 0; t < solid.tetrahedra.size(); ++t) {
    Index touching = no_index;
    int count = 0;
    for (const Index v : solid.tetrahedra[t]) {
      if (outer[v] == 0) continue;
      touching = v;
      ++count;
    }
    if (count != 1) continue;
    ++checked;
    const Vector3 n = normal[touching].normalized();
    const Vector local = quaternion::rotate(quaternion::conjugate(outcome.field[t]), {n[0], n[1], n[2]});
    CHECK(std::max({std::abs(local.x), std::abs(local.y), std::abs(local.z)}) > 1 - 1e-9);
  }
  CHECK(checked > 50);
}

TEST_CASE("Recombination takes the better region of two fields and nothing else") {
  const test::Solid solid = test::cubes(8, 8, 8);
  const base::Host host;
  const mesh::TetrahedralConnectivity connectivity(solid.positions.size(), solid.tetrahedra, host);
  const DualGraph graph = make_dual_graph(solid.positions, connectivity, Weighting::uniform, host);
  std::mt19937_64 random(6);
  Field a(graph.size(), Quaternion{1, 0, 0, 0}), b = a;
  const Index far = static_cast<Index>(graph.size() - 20);
  a[10] = test::random_rotation(random);   // only a is bad here
  b[far] = test::random_rotation(random);  // and b there
  const double before = energy(graph, a, host);
  Field best = a;
  const double gain = take_better_regions(graph, Constraints(host.memory), b, 0.01, host, best);
  CHECK(energy(graph, best, host) == 0);
  CHECK(gain == doctest::Approx(before));
  CHECK(take_better_regions(graph, Constraints(host.memory), b, 0.01, host, best) == 0);
}

TEST_CASE(
    "The dissertation's method starts from identity, holds the boundary and never ends lower than smoothing does") {
  const test::Solid solid = test::ball(7);
  const Outcome seed = computed(solid, {.method = Method::dissertation});
  const Measurement m = measured(solid, seed.field);
  CHECK(m.one_face_max < 1e-6);
  CHECK(seed.energy == doctest::Approx(m.energy).epsilon(1e-9));
  const Outcome ours = computed(solid);
  CHECK(ours.energy < seed.energy);
  // Boundary frames are those of identity, turned to the normal.
  const base::Host host;
  const mesh::TetrahedralConnectivity connectivity(solid.positions.size(), solid.tetrahedra, host);
  const DualGraph graph = make_dual_graph(solid.positions, connectivity, Weighting::uniform, host);
  const Constraints constraints = make_constraints(graph, solid.positions, connectivity, true, {}, {}, host);
  for (const Constraint& c : constraints.list)
    CHECK(quaternion::symmetric_distance(seed.field[graph.tetrahedron[c.node]], c.frame) < 1e-9);
}

TEST_CASE("Weights by area and distance make the energy one of the solid, not of the mesh") {
  // The energy over links is about sum w |d|^2; with area / distance and mean 1 it grows as the number of links times
  // the mean square of a step, that is as n^(1/3) for a field of fixed shape.
  const Options options{.start = Start::harmonic, .weighting = Weighting::geometric};
  const double coarse = computed(test::ring(20, 3), options).energy;
  const double fine = computed(test::ring(40, 6), options).energy;
  CHECK(fine / coarse == doctest::Approx(2).epsilon(0.25));
}

TEST_CASE("Wrong input is refused and work can be cancelled") {
  const test::Solid solid = test::cubes(3, 3, 3);
  CHECK(refusal({}, {}) == "empty-mesh");
  CHECK(refusal(solid, {.start = static_cast<Start>(77)}) == "invalid-argument");
  CHECK(refusal(solid, {.start = Start::given}) == "invalid-argument");
  CHECK(refusal(solid, {.feature_angle = -1}) == "invalid-argument");
  CHECK(refusal(solid, {.relative_gain = 0}) == "invalid-argument");
  const std::vector<GivenFrame> beyond = {{static_cast<Index>(solid.tetrahedra.size()), {1, 0, 0, 0}}};
  CHECK(refusal(solid, {}, {.frames = beyond, .axes = {}}) == "invalid-argument");
  const std::vector<GivenFrame> long_one = {{0, {2, 0, 0, 0}}};
  CHECK(refusal(solid, {}, {.frames = long_one, .axes = {}}) == "invalid-argument");
  test::Solid twice = solid;
  twice.tetrahedra.push_back(twice.tetrahedra[0]);
  CHECK(refusal(twice, {}) != "");
  base::Host host;
  host.on_progress = [](const base::Progress&) { return false; };
  CHECK_THROWS_AS(computed(solid, {}, {}, host), base::Error);
}

TEST_CASE("A single tetrahedron has a field") {
  const test::Solid solid{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}};
  for (const Start start : starts) {
    const Outcome outcome = computed(solid, {.start = start});
    CHECK(outcome.energy == 0);
    CHECK(measured(solid, outcome.field).several_best_max < 1e-6);
  }
}

TEST_CASE("Vertices in no cell change no bit of a field") {
  const test::Solid solid = test::ball(4);
  test::Solid with = solid;
  with.positions.insert(with.positions.end(), {{1e6, -2e5, 3}, {0.01, 0, 0}, {-7, 7, 1e9}});
  CHECK(same_bits(computed(solid).field, computed(with).field));
}

TEST_CASE("with matchings free on the sphere every field is a minimum of the sextic of section 6.1.4") {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  const auto frame = [&] {
    return quaternion::normalized({normal(random), normal(random), normal(random), normal(random)});
  };
  for (int trial = 0; trial < 100; ++trial) {
    const Quaternion between = quaternion::multiply(frame(), quaternion::conjugate(frame()));
    // Eq. 6.7 and 6.8: s0 is the scalar part of pi q_ij, at most 1 for units, which the inverse of q_ij reaches.
    const Quaternion pi = quaternion::conjugate(between);
    CHECK(quaternion::multiply(pi, between).w == doctest::Approx(1).epsilon(1e-14));
    CHECK(quaternion::multiply(frame(), between).w <= 1 + 1e-14);
  }
}

TEST_CASE("the method of the dissertation refuses starts that it would ignore") {
  const std::vector<Vector3> positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<Tetrahedron> tetrahedra = {{0, 1, 2, 3}};
  for (const Start start : {Start::propagated, Start::harmonic, Start::diffusion})
    CHECK_THROWS_AS(compute(positions, tetrahedra, {.start = start, .method = Method::dissertation}, {}, {}),
                    base::Error);
  CHECK_NOTHROW(compute(positions, tetrahedra, {.start = Start::identity, .method = Method::dissertation}, {}, {}));
}
