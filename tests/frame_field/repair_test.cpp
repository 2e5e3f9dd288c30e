// Faults of a field, found and repaired: what zipping does to known structures, that parts do not depend on each other,
// and what a repaired field still satisfies.
#include "frame_field/singularities/repair.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>
#include <numbers>
#include <random>

#include "frame_field/frame_field.h"
#include "frame_field/singularities/measurement.h"
#include "frame_field/singularities/zipping.h"
#include "frame_field/smoothing/energy.h"
#include "frame_field/smoothing/region_relaxation.h"
#include "solids.h"

using namespace orbicube;
using namespace orbicube::frame_field;
using quaternion::cube_group;
using quaternion::CubeClass;
using test::bar;

namespace {

// Frames that turn about the z axis by a part of a full turn while one goes round it.
Field field_about_z(const test::Solid& solid, const Quaternion& base, double part) {
  Field field;
  for (const Tetrahedron& t : solid.tetrahedra) {
    Vector3 centre = Vector3::Zero();
    for (const Index v : t)
      centre += solid.positions[v];
    field.push_back(turned(base, {0, 0, 1}, part * std::atan2(centre[1], centre[0])));
  }
  return field;
}

// The solid with its tetrahedra numbered as the nodes of its graph are.
test::Solid in_order_of_nodes(const test::Solid& solid) {
  const mesh::TetrahedralConnectivity connectivity(solid.positions.size(), solid.tetrahedra, base::Host());
  test::Solid result{solid.positions, {}};
  for (const Index t : make_dual_graph(solid.positions, connectivity, Weighting::uniform, base::Host()).tetrahedron)
    result.tetrahedra.push_back(solid.tetrahedra[t]);
  return result;
}

// Everything that repairs work on, without constraints unless requested.
struct Setting {
  explicit Setting(const test::Solid& s, bool align_boundary = false)
      : solid(in_order_of_nodes(s)),
        connectivity(solid.positions.size(), solid.tetrahedra, host),
        graph(make_dual_graph(solid.positions, connectivity, Weighting::uniform, host)),
        hierarchy(make_hierarchy(graph, 60, host)),
        constraints(make_constraints(graph, solid.positions, connectivity, align_boundary, {}, {}, host)),
        finder(solid.positions, connectivity, host) {}

  RepairOutcome repaired(Field& field) {
    return Repair(solid.positions, connectivity, graph, hierarchy, constraints, host).repair(field);
  }
  SingularGraph graph_of(const Field& field, const Array<std::uint8_t>& matching) const {
    return singular_graph(solid.positions, connectivity, finder.rings(), field, matching, host);
  }
  std::size_t zipped(const Field& field, Array<std::uint8_t>& matching) const {
    const Array<std::uint8_t> everywhere(solid.tetrahedra.size(), 1);
    return zip(solid.positions, connectivity, finder, field, everywhere, graph_of(field, matching), host, matching);
  }

  base::Host host;
  test::Solid solid;
  mesh::TetrahedralConnectivity connectivity;
  DualGraph graph;
  Array<CoarseGraph> hierarchy;
  Constraints constraints;
  FaultFinder finder;
};

// The diagonal of this frame's axes lies along z.
Quaternion diagonal_up() {
  const double angle = std::acos(1 / std::sqrt(3.0));
  return turned({1, 0, 0, 0}, {std::sqrt(0.5), -std::sqrt(0.5), 0}, angle);
}

std::size_t count(const SingularGraph& graph, CubeClass kind) {
  return graph.by_class[static_cast<std::size_t>(kind)];
}

}  // namespace

TEST_CASE("Zipping takes half turns and third turns apart into quarter turns, and no curve ends inside") {
  const Quaternion up = diagonal_up();
  const Vector along = quaternion::rotate(up, {1 / std::sqrt(3.0), 1 / std::sqrt(3.0), 1 / std::sqrt(3.0)});
  REQUIRE(std::abs(along.z) == doctest::Approx(1));
  const Setting setting(bar());
  for (const CubeClass kind : {CubeClass::face_half, CubeClass::corner_third}) {
    const bool half = kind == CubeClass::face_half;
    const Field field = field_about_z(setting.solid, half ? Quaternion{1, 0, 0, 0} : up, half ? 0.5 : 1.0 / 3);
    Array<std::uint8_t> matching = matchings(setting.connectivity, field, setting.host);
    const SingularGraph before = setting.graph_of(field, matching);
    REQUIRE(before.edges.size() == 5);
    REQUIRE(count(before, kind) == 5);
    CHECK(setting.zipped(field, matching) >= 5);
    const SingularGraph after = setting.graph_of(field, matching);
    CHECK(count(after, CubeClass::face_quarter) == after.edges.size());
    CHECK(after.edges.size() >= 10);  // two curves through all layers
    CHECK(after.dead_ends.empty());
    for (Index f = 0; f < setting.connectivity.face_count(); ++f) {
      if (!setting.connectivity.on_boundary(f))
        CHECK(matching[setting.connectivity.opposite(f)] == cube_group.inverse[matching[f]]);
    }
    CHECK(setting.zipped(field, matching) == 0);
  }
}

TEST_CASE("A loop around any one face vanishes") {
  const Setting setting(test::cubes(4, 4, 4));
  const Field field(setting.solid.tetrahedra.size(), Quaternion{1, 0, 0, 0});
  const Array<std::uint8_t> regular(setting.connectivity.face_count(), 0);
  std::size_t loops = 0;
  for (Index f = 0; f < setting.connectivity.face_count(); f += 13) {
    if (setting.connectivity.on_boundary(f)) continue;
    for (const std::uint8_t rotation : {std::uint8_t{4}, std::uint8_t{7}, std::uint8_t{8}}) {
      Array<std::uint8_t> matching = regular;
      matching[f] = rotation;
      matching[setting.connectivity.opposite(f)] = cube_group.inverse[rotation];
      loops += setting.graph_of(field, matching).edges.size() == 3 ? 1 : 0;
      setting.zipped(field, matching);
      CHECK(matching == regular);
    }
  }
  CHECK(loops > 20);
}

TEST_CASE("Faults of different parts add up to those of the whole") {
  const Setting setting(test::ball(8));
  std::mt19937_64 random(5);
  Field field(setting.solid.tetrahedra.size());
  for (Quaternion& q : field)
    q = turned({1, 0, 0, 0}, quaternion::rotate(test::random_rotation(random), {0, 0, 1}), 0.8);
  const Structure before = setting.finder.find(field);
  CHECK(before.faults.unmeshable() > 10);
  const Array<Index> somewhere = {40, 300, 650};
  const auto marked = setting.finder.around(somewhere, 1);
  Field candidate = field;
  for (Index t = 0; t < field.size(); ++t) {
    if (marked[t] != 0) candidate[t] = test::random_rotation(random);
  }
  const Structure after = setting.finder.find(candidate);
  Parts parts(setting.connectivity, marked, setting.host);
  parts.count(before, after);
  std::int64_t sum = 0;
  for (const Index v : somewhere)
    sum += parts.at(v).unmeshable;
  CHECK(sum != 0);
  CHECK(static_cast<std::int64_t>(after.faults.unmeshable()) ==
        static_cast<std::int64_t>(before.faults.unmeshable()) + sum);
  // Taking over one part changes the faults by what was counted for it.
  for (const Index v : somewhere) {
    Field one = field;
    const auto part = setting.finder.around(std::span(&v, 1), 1);
    for (Index t = 0; t < field.size(); ++t) {
      if (part[t] != 0) one[t] = candidate[t];
    }
    CHECK(static_cast<std::int64_t>(setting.finder.find(one).faults.unmeshable()) ==
          static_cast<std::int64_t>(before.faults.unmeshable()) + parts.at(v).unmeshable);
  }
}

TEST_CASE("Relaxing a part lowers the energy, keeps constraints, and leaves the other frames as they are") {
  const Setting setting(test::ball(7), true);
  const base::Host& host = setting.host;
  Field field(setting.graph.size(), Quaternion{1, 0, 0, 0});
  satisfy(setting.constraints, field);
  Array<Index> part;
  for (Index t = 0; t < field.size(); t += t % 3 + 1)
    part.push_back(t);
  const Field before = field;
  RegionRelaxation(setting.graph, setting.constraints, setting.connectivity, host).relax(part, {}, 30, field);
  CHECK(energy(setting.graph, field, host) < energy(setting.graph, before, host));
  for (Index t = 0; t < field.size(); ++t) {
    if (!std::ranges::binary_search(part, t)) CHECK(std::memcmp(&field[t], &before[t], sizeof field[t]) == 0);
  }
  const Measurement m = measure(setting.solid.positions, setting.connectivity, field, host);
  CHECK(m.one_face_max < 1e-6);
  CHECK(test::off_boundary(setting.solid, setting.connectivity, field) < 1e-6);
}

TEST_CASE("A curve of third turns is repaired") {
  Setting setting(bar());
  Field field = field_about_z(setting.solid, diagonal_up(), 1.0 / 3);
  const RepairOutcome outcome = setting.repaired(field);
  CHECK(outcome.before.edges == 5);
  CHECK(outcome.after < outcome.before);
  const Structure s = setting.finder.find(field);
  CHECK(s.faults.unmeshable() == outcome.after.unmeshable());
  CHECK(count(s.graph, CubeClass::corner_third) == 0);
  CHECK(s.graph.dead_ends.empty());
}

TEST_CASE("Repairs leave fewer faults, an exact boundary, units, no dead ends, and the energies that they report" *
          doctest::test_suite("long")) {
  const Setting setting(test::ball(8));
  const test::Solid& solid = setting.solid;
  // Smoothing alone leaves a random field with faults everywhere.
  std::mt19937_64 random(7);
  Field start(solid.tetrahedra.size());
  for (Quaternion& q : start)
    q = test::random_rotation(random);
  const Given given{.frames = {}, .axes = {}, .start = start};
  Options options{.start = Start::given};
  const Outcome plain = compute(solid.positions, solid.tetrahedra, options, given, {});
  const Faults before = setting.finder.find(plain.field).faults;
  REQUIRE(before.unmeshable() > 0);
  for (const Repairs repairs : {Repairs::places, Repairs::single_axis}) {
    options.repairs = repairs;
    const Outcome outcome = compute(solid.positions, solid.tetrahedra, options, given, {});
    const Structure after = setting.finder.find(outcome.field);
    const Measurement m = measure(solid.positions, setting.connectivity, outcome.field, setting.host);
    CHECK(outcome.repair.before.unmeshable() == before.unmeshable());
    CHECK(outcome.repair.after.unmeshable() == after.faults.unmeshable());
    CHECK(after.faults.unmeshable() < before.unmeshable());
    CHECK(outcome.repair.energy_before == doctest::Approx(plain.energy).epsilon(1e-9));
    CHECK(outcome.energy == doctest::Approx(m.energy).epsilon(1e-9));
    CHECK(after.graph.dead_ends.empty());
    CHECK(m.one_face_max < 1e-6);
    CHECK(test::off_boundary(solid, setting.connectivity, outcome.field) < 1e-6);
    CHECK(m.norm_error < 1e-14);
  }
}

TEST_CASE("What needs no repair stays as it is") {
  const test::Solid solid = test::ring(18, 3);
  const Outcome plain = compute(solid.positions, solid.tetrahedra, {.start = Start::harmonic}, {}, {});
  const Outcome repaired =
      compute(solid.positions, solid.tetrahedra, {.start = Start::harmonic, .repairs = Repairs::places}, {}, {});
  REQUIRE(repaired.repair.before.unmeshable() + repaired.repair.before.fragments == 0);
  CHECK(repaired.repair.rounds == 0);
  CHECK(std::memcmp(plain.field.data(), repaired.field.data(), plain.field.size() * sizeof(Quaternion)) == 0);
}
