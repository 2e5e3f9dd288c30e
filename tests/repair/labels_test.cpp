// Closed surfaces of labels of images.
#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <bit>
#include <map>
#include <set>
#include <string>

#include "base/error.h"
#include "label_images.h"
#include "mesh/search/intersections.h"
#include "repair/labels/cell_cases.h"
#include "repair/labels/simple_voxel.h"

using namespace orbicube;
using namespace orbicube::test;
using mesh::Vector3;
using repair::Voxels;

namespace {

repair::LabelSurface surface_of(const LabelVolume& v, const repair::LabelOptions& options = {},
                                const base::Host& host = {}) {
  return repair::surface_of_label(v.image(), options, host);
}

std::string refusal(const LabelVolume& v, const repair::LabelOptions& options = {}) {
  try {
    surface_of(v, options);
  } catch (const base::Error& error) {
    return std::string(error.kind()) + ": " + error.what();
  }
  return "";
}

// Parts of the 27 voxels of a cube with in == kind, connected where the coordinates differ by one in at most `most`
// axes.
int parts_in_cube(const std::array<int, 27>& in, int kind, int most) {
  std::array<int, 27> seen{};
  int parts = 0;
  for (int start = 0; start < 27; ++start) {
    if (in[static_cast<std::size_t>(start)] != kind || seen[static_cast<std::size_t>(start)] != 0) continue;
    ++parts;
    std::vector<int> open = {start};
    seen[static_cast<std::size_t>(start)] = 1;
    while (!open.empty()) {
      const int a = open.back();
      open.pop_back();
      for (int b = 0; b < 27; ++b) {
        const int dx = std::abs(a % 3 - b % 3), dy = std::abs(a / 3 % 3 - b / 3 % 3), dz = std::abs(a / 9 - b / 9);
        if (std::max({dx, dy, dz}) != 1 || dx + dy + dz > most) continue;
        const auto k = static_cast<std::size_t>(b);
        if (in[k] != kind || seen[k] != 0) continue;
        seen[k] = 1;
        open.push_back(b);
      }
    }
  }
  return parts;
}

std::int64_t euler(const std::array<int, 27>& in) {
  Voxels voxels({5, 5, 5}, std::pmr::get_default_resource());
  for (std::size_t n = 0; n < 27; ++n)
    voxels.in[voxels.index(n % 3 + 1, n / 3 % 3 + 1, n / 9 + 1)] = static_cast<std::uint8_t>(in[n]);
  return repair::euler_characteristic(voxels);
}

double signed_volume(const repair::LabelSurface& s) {
  double sum = 0;
  for (const mesh::Triangle& t : s.triangles)
    sum += s.positions[t[0]].dot(s.positions[t[1]].cross(s.positions[t[2]])) / 6;
  return sum;
}

}  // namespace

TEST_CASE("A voxel is simple where parts, cavities and handles stay the same with and without it") {
  base::Random random(7);
  int simple = 0;
  for (int trial = 0; trial < 20'000; ++trial) {
    std::array<int, 27> in{};
    const double density = random.unit();
    repair::Neighborhood bits = 0;
    for (std::size_t n = 0; n < 27; ++n) {
      in[n] = random.unit() < density;
      if (n != 13 && in[n] != 0) bits |= repair::Neighborhood{1} << n;
    }
    std::array<int, 27> with = in, without = in;
    with[13] = 1;
    without[13] = 0;
    // In the cube alone each change of the topology shows in one of these counts or in a face that is missing: the
    // whole cube's boundary belongs to neither.
    const bool same = parts_in_cube(with, 1, 1) == parts_in_cube(without, 1, 1) &&
                      parts_in_cube(with, 0, 3) == parts_in_cube(without, 0, 3) && euler(with) == euler(without);
    const bool is_simple = repair::is_simple(bits);
    if (is_simple) {
      CHECK(same);
      ++simple;
    }
    if (same && !is_simple) {
      // Two changes that cancel: the voxel joins parts of its neighbors and closes what they surround.
      CHECK(parts_in_cube(without, 0, 3) >= 1);
    }
  }
  CHECK(simple > 1000);
}

TEST_CASE("Patches of all 256 cells have the edges of their faces, and no triangles intersect") {
  for (unsigned corners = 1; corners < 255; ++corners) {
    const repair::CellCase& made = repair::cell_case(static_cast<std::uint8_t>(corners));
    std::vector<Vector3> positions(24 + 4);
    for (std::size_t e = 0; e < 24; ++e) {
      const std::size_t c = e / 3;
      positions[e] = Vector3(static_cast<double>(c & 1), static_cast<double>(c >> 1 & 1), static_cast<double>(c >> 2));
      positions[e][static_cast<int>(e % 3)] += 0.5;
    }
    std::vector<mesh::Triangle> triangles;
    std::set<std::uint8_t> used;
    for (std::size_t p = 0; p < made.patch_count; ++p) {
      const repair::CellPatch& patch = made.patches[p];
      Vector3& center = positions[24 + p];
      for (std::size_t i = 0; i < patch.loop_size; ++i) {
        center += positions[patch.loop[i]] / patch.loop_size;
        CHECK(used.insert(patch.loop[i]).second);
      }
      for (std::size_t t = 0; t < patch.triangle_count; ++t) {
        mesh::Triangle triangle{};
        for (std::size_t k = 0; k < 3; ++k) {
          const std::uint8_t e = patch.triangles[t][k];
          triangle[k] = e == repair::center_vertex ? static_cast<mesh::Index>(24 + p) : e;
        }
        triangles.push_back(triangle);
      }
    }
    // Every edge between a corner of the object and one of the background has a vertex.
    std::size_t crossed = 0;
    for (unsigned c = 0; c < 8; ++c) {
      for (unsigned axis = 0; axis < 3; ++axis)
        crossed += (c >> axis & 1) == 0 && (corners >> c & 1) != (corners >> (c | 1U << axis) & 1);
    }
    CHECK(used.size() == crossed);
    CHECK(mesh::intersecting_triangles(positions, triangles, base::Host()).empty());
    // Edges of one triangle lie in a face of the cell, edges of two do not.
    std::map<std::pair<mesh::Index, mesh::Index>, int> balance;
    for (const mesh::Triangle& t : triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const mesh::Index a = t[k], b = t[(k + 1) % 3];
        balance[{std::min(a, b), std::max(a, b)}] += 1;
      }
    }
    for (const auto& [edge, count] : balance) {
      bool in_face = false;
      for (int axis = 0; axis < 3; ++axis) {
        const double x = positions[edge.first][axis], y = positions[edge.second][axis];
        in_face = in_face || (x == y && (x == 0 || x == 1));
      }
      CHECK(count == (in_face ? 1 : 2));
    }
  }
}

TEST_CASE("The surface has the topology of the object connected through faces") {
  base::Random random(3);
  for (int trial = 0; trial < 16; ++trial) {
    const LabelVolume v = loose_voxels(random);
    repair::LabelOptions options;
    options.keep = 0;
    options.cavities = options.handles = true;
    const repair::LabelSurface s = surface_of(v, options);
    CHECK(s.report.certificate.is_solid());
    CHECK(s.report.certificate.self_intersections == 0);
    const repair::LabelVoxels object = repair::voxels_of_label(v.image(), 1, base::Host());
    const std::int64_t surface_euler =
        2 * (static_cast<std::int64_t>(s.report.certificate.parts) - s.report.certificate.genus);
    CHECK(surface_euler == 2 * repair::euler_characteristic(object.voxels));
    // Centers of voxels stay on their side: vertices stay within their edges.
    CHECK(s.report.largest_slide <= 0.45);
    CHECK(largest_distance_from_sides(object, s) <= 0.5);
  }
}

TEST_CASE("Sixty images give closed surfaces of genus 0 within half a voxel" * doctest::test_suite("long")) {
  base::Random random(1);
  for (int i = 0; i < 60; ++i) {
    const LabelVolume v = i % 4 == 0   ? blob(random)
                          : i % 4 == 1 ? ventricle(random)
                          : i % 4 == 2 ? loose_voxels(random)
                                       : handles(random);
    CAPTURE(i);
    const repair::LabelSurface s = surface_of(v);
    const repair::Certificate& c = s.report.certificate;
    CHECK(c.is_solid());
    CHECK(c.parts == 1);
    CHECK(c.genus == 0);
    CHECK(c.self_intersections == 0);
    CHECK(c.volume > 0);
    CHECK(largest_distance_from_sides(object_of(v, base::Host()), s) <= 0.5);
    if (i % 4 == 3) {
      CHECK(s.report.handles > 0);
      // Of the arcs a voxel each; a tunnel is plugged or opened at its thinnest place.
      CHECK(s.report.removed_voxels + s.report.added_voxels <= 40);
    }
  }
}

TEST_CASE("Specks are dropped, cavities filled and handles removed, or kept on request") {
  LabelVolume v(16, 16, 16);
  v.fill([](const Vector3& p) { return (p - Vector3(6, 6, 6)).norm() < 4.6; });
  v.at(6, 6, 6) = 0;     // a cavity
  v.at(14, 14, 14) = 1;  // a speck
  repair::LabelSurface s = surface_of(v);
  CHECK(s.report.found_parts == 2);
  CHECK(s.report.dropped_voxels == 1);
  CHECK(s.report.cavities == 1);
  CHECK(s.report.filled_voxels == 1);
  CHECK(s.report.certificate.parts == 1);
  repair::LabelOptions options;
  options.keep = 2;
  CHECK(surface_of(v, options).report.certificate.parts == 2);
  options.handles = options.cavities = true;
  s = surface_of(v, options);
  CHECK(s.report.certificate.parts == 3);
  CHECK(s.report.certificate.genus == 0);
  for (std::size_t x = 0; x < 16; ++x)
    v.at(x, 4, 6) = 0;  // a tunnel
  options = {};
  options.handles = true;
  CHECK(surface_of(v, options).report.certificate.genus == 1);
  s = surface_of(v);
  CHECK(s.report.certificate.genus == 0);
  CHECK(s.report.handles == 1);
  CHECK(s.report.added_voxels + s.report.removed_voxels > 0);
  options.handles = false;
  options.keep = 0;
  s = surface_of(v, options);
  CHECK(s.report.certificate.genus == 0);
  CHECK(s.report.certificate.parts == 2);
}

TEST_CASE("A ball's smoothed surface is near the sphere; without slides vertices are midway") {
  LabelVolume v(28, 28, 28);
  v.fill([](const Vector3& p) { return (p - Vector3(13.2, 13.6, 13.9)).norm() < 10; });
  const auto error_of = [&](const repair::LabelSurface& s) {
    double worst = 0;
    for (const Vector3& p : s.positions)
      worst = std::max(worst, std::abs((p - Vector3(13.2, 13.6, 13.9)).norm() - 10));
    return worst;
  };
  const repair::LabelSurface smooth = surface_of(v);
  repair::LabelOptions options;
  options.max_slide = 0;
  const repair::LabelSurface steps = surface_of(v, options);
  CHECK(error_of(smooth) < 0.4);
  CHECK(error_of(smooth) < 0.75 * error_of(steps));
  CHECK(steps.report.largest_slide == 0);
  CHECK(smooth.report.certificate.volume == doctest::Approx(4188.8).epsilon(0.02));
  // Straight walls do not move.
  LabelVolume box(20, 20, 20);
  box.fill([](const Vector3& p) { return p.minCoeff() > 3.5 && p.maxCoeff() < 15.5; });
  for (const Vector3& p : surface_of(box).positions) {
    const Vector3 from_middle = (p - Vector3::Constant(9.5)).cwiseAbs();
    CHECK(from_middle.maxCoeff() == doctest::Approx(6).epsilon(0.08));
  }
}

TEST_CASE("Oblique, sheared and mirroring maps to the world place the surface and keep it outward-oriented") {
  base::Random random(5);
  LabelVolume v = blob(random);
  const repair::LabelSurface plain = surface_of(v);
  for (int trial = 0; trial < 6; ++trial) {
    Eigen::Matrix3d m =
        Eigen::AngleAxisd(random.unit() * 3, Vector3(1, random.unit(), random.unit()).normalized()).toRotationMatrix() *
        Vector3(0.7, 1.1, trial % 2 == 0 ? 2.5 : -2.5).asDiagonal();
    if (trial > 3) m.col(1) += 0.3 * m.col(0);
    const Vector3 offset(-90.5, 126, 72.25);
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c)
        v.to_world[static_cast<std::size_t>(4 * r + c)] = m(r, c);
      v.to_world[static_cast<std::size_t>(4 * r + 3)] = offset[r];
    }
    const repair::LabelSurface s = surface_of(v);
    CHECK(s.report.certificate.self_intersections == 0);
    REQUIRE(s.positions.size() == plain.positions.size());
    double worst = 0;
    for (std::size_t i = 0; i < s.positions.size(); ++i)
      worst = std::max(worst, (s.positions[i] - (m * plain.positions[i] + offset)).norm());
    CHECK(worst < 1e-10);
    CHECK(s.report.certificate.volume == doctest::Approx(std::abs(m.determinant()) * plain.report.certificate.volume));
    CHECK(signed_volume(s) > 0);
  }
}

TEST_CASE("A label at the border of the image is closed there") {
  LabelVolume v(4, 5, 6);
  v.fill([](const Vector3&) { return true; });
  const repair::LabelSurface s = surface_of(v);
  CHECK(s.report.border_voxels == 120 - 2 * 3 * 4);
  CHECK(s.report.certificate.is_solid());
  CHECK(s.report.certificate.genus == 0);
}

TEST_CASE("Images and options without a meaning are refused") {
  LabelVolume v(4, 4, 4);
  CHECK(refusal(v).find("every voxel") != std::string::npos);
  v.at(1, 1, 1) = 3;
  v.at(2, 2, 2) = v.at(2, 2, 1) = -5;
  CHECK(refusal(v).find("-5 (2 voxels), 3 (1 voxel)") != std::string::npos);
  repair::LabelOptions options;
  options.label = 4;
  CHECK(refusal(v, options).find("no voxel has label 4; there are labels -5 (2 voxels), 3 (1 voxel)") !=
        std::string::npos);
  options.label = 3;
  CHECK(refusal(v, options).empty());
  options.max_slide = 0.5;
  CHECK(refusal(v, options).find("slides") != std::string::npos);
  options.max_slide = 0.2;
  options.cavities = true;
  CHECK(refusal(v, options).find("cavities") != std::string::npos);
  options.cavities = false;
  v.to_world[0] = 0;
  CHECK(refusal(v, options).find("singular") != std::string::npos);
  v.to_world[0] = std::nan("");
  CHECK(refusal(v, options).find("not finite") != std::string::npos);
  v.to_world[0] = 1;
  v.size = {std::size_t{1} << 32, std::size_t{1} << 32, 1};
  CHECK(refusal(v, options).find("overflow") != std::string::npos);
  v.size = {4, 4, 5};
  CHECK(refusal(v, options).find("its sizes need 80") != std::string::npos);
}

TEST_CASE("Label surfaces are the same bits for any number of threads") {
  base::Random random(11);
  const LabelVolume v = ventricle(random);
  base::Host one, four;
  one.thread_count = 1;
  four.thread_count = 4;
  const repair::LabelSurface a = surface_of(v, {}, one), b = surface_of(v, {}, four);
  CHECK(a.triangles == b.triangles);
  CHECK(a.positions == b.positions);
}
