// Parameterizations along frames (chapter 5 of the dissertation) and functions of maps at points: constraints to
// rounding, integers exactly, derivatives against differences, known optima.
#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <random>

#include "base/error.h"
#include "block_solid.h"
#include "frame_solids.h"
#include "untangle/tetrahedra/untangle_tetrahedra.h"
#include "volume_map/frame_map/frame_guided.h"
#include "volume_map/frame_map/parameterization.h"
#include "volume_map/frame_map/split_parameterization.h"
#include "volume_map/frames/frame_energy.h"
#include "volume_map/frames/transitions.h"
#include "volume_map/sampling/grid_resampling.h"
#include "volume_map/sampling/point_location.h"

using namespace orbicube;
using namespace orbicube::volume_map;
using namespace orbicube::volume_map::test;

namespace {

bool is_integer(double x) {
  return x == std::round(x);
}

double volume_of(std::span<const Vector3> positions, std::span<const Tetrahedron> tetrahedra) {
  double sum = 0;
  for (const Tetrahedron& t : tetrahedra)
    sum += untangle::six_volumes(positions, t) / 6;
  return sum;
}

// Eq. 5.3 for frames along the axes over the volume, as GuidedFigures has it, and its minimum over the vertices behind
// the first `fixed` ones, by conjugate gradients from the derivative alone.
struct OwnMinimum {
  std::span<const Vector3> source;
  std::span<const Tetrahedron> tetrahedra;
  std::size_t fixed;
  double scale, unit;
  Array<quaternion::Quaternion> frames;

  OwnMinimum(const VolumeMap& map, std::size_t fixed_vertices)
      : source(map.source),
        tetrahedra(map.tetrahedra),
        fixed(fixed_vertices),
        scale(std::cbrt(volume_of(map.image, map.tetrahedra) / volume_of(map.source, map.tetrahedra))),
        unit(scale * scale * volume_of(map.source, map.tetrahedra)),
        frames(map.tetrahedra.size(), quaternion::Quaternion{1, 0, 0, 0}) {}

  double energy(std::span<const Vector3> image) const {
    return guided_energy(source, image, tetrahedra, frames, scale) / unit;
  }

  Eigen::VectorXd gradient(std::span<const Vector3> image) const {
    std::vector<Vector3> all(image.size(), Vector3::Zero());
    guided_energy(source, image, tetrahedra, frames, scale, all);
    Eigen::VectorXd inner = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(3 * (all.size() - fixed)));
    for (std::size_t v = fixed; v < all.size(); ++v)
      inner.segment<3>(static_cast<Eigen::Index>(3 * (v - fixed))) = all[v] / unit;
    return inner;
  }

  double minimum(std::span<const Vector3> start) const {
    std::vector<Vector3> x(start.begin(), start.end());
    const auto moved = [&](const Eigen::VectorXd& step) {
      std::vector<Vector3> y = x;
      for (std::size_t v = fixed; v < y.size(); ++v)
        y[v] += step.segment<3>(static_cast<Eigen::Index>(3 * (v - fixed)));
      return y;
    };
    Eigen::VectorXd rest = -gradient(x), direction = rest;
    const double first = rest.norm();
    for (int k = 0; k < 3000 && rest.norm() > 1e-10 * first; ++k) {
      const Eigen::VectorXd product = gradient(moved(direction)) + rest;  // the energy is quadratic
      const double length = rest.squaredNorm() / direction.dot(product), before = rest.squaredNorm();
      x = moved(length * direction);
      rest -= length * product;
      direction = rest + rest.squaredNorm() / before * direction;
    }
    return energy(x);
  }
};

}  // namespace

TEST_CASE("transitions across faces and around singular edges hold to rounding") {
  FramedSolid solid = cylinder(8, 3, 0.8);
  split_for_frames(solid, {});  // or edges of the boundary get no length
  for (const bool integer : {false, true}) {
    const Parameterization map = parameterize(solid, {.cell_length = 0.2, .integer = integer}, {});
    CHECK(map.singular_edges.size() == 4 * 3);
    CHECK(map.cut_faces > 0);
    CHECK(map.residual < 1e-12);  // coordinates of up to 10 cells, of which 1e-15 is the last bit
    CHECK(constraint_residual(solid, map, {}) == map.residual);
    CHECK(map.inverted < solid.tetrahedra.size() / 100);  // a few, beside the edges of the boundary
    // A residual that is looked for is found: a corner that is moved leaves its neighbors.
    Parameterization moved = map;
    moved.corners[5][2][1] += 0.25;
    CHECK(constraint_residual(solid, moved, {}) >= 0.25 - 1e-12);
  }
}

TEST_CASE("splits leave fewer tetrahedra inverted, keep the vertices, and the constraints hold") {
  for (const bool integer : {false, true}) {
    const ParameterizationOptions options = {.cell_length = 0.2, .integer = integer};
    const FramedSolid before = cylinder(8, 3, 0.8);
    FramedSolid solid = cylinder(8, 3, 0.8);
    const Parameterization map = parameterize_split(solid, options, {});
    CHECK(map.inverted < parameterize(before, options, {}).inverted);
    CHECK(map.corners.size() == solid.tetrahedra.size());
    CHECK(solid.frames.size() == solid.tetrahedra.size());
    CHECK_UNARY(std::equal(before.positions.begin(), before.positions.end(), solid.positions.begin()));
    CHECK(constraint_residual(solid, map, {}) < 1e-12);
  }
}

TEST_CASE("gaps and planes of the boundary are integers after rounding, exactly") {
  const FramedSolid solid = cylinder(8, 3, 0.8);
  const Parameterization free = parameterize(solid, {.cell_length = 0.2}, {});
  const Parameterization map = parameterize(solid, {.cell_length = 0.2, .integer = true}, {});
  const mesh::TetrahedralConnectivity connectivity(solid.positions.size(), solid.tetrahedra, {});
  for (Index face = 0; face < connectivity.face_count(); ++face) {
    for (Eigen::Index a = 0; a < 3; ++a)
      CHECK_UNARY(is_integer(map.gap[face][a]));
    if (!connectivity.on_boundary(face)) continue;
    const Index v = connectivity.vertices(face)[0];
    const Vector3& f = map.corners[face / 4][connectivity.corner_of(face / 4, v)];
    CHECK_UNARY(is_integer(f[map.label[face] / 2]));
  }
  CHECK(map.integer_cost >= 0);
  // What rounding costs is what the energy rises by.
  CHECK(map.energy - free.energy == doctest::Approx(map.integer_cost).epsilon(1e-3));
}

TEST_CASE("gradients by areas and normals of faces, eqs. 5.4 to 5.6, give the energy of eq. 5.3") {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  const auto vector = [&] { return Vector3(normal(random), normal(random), normal(random)); };
  for (int trial = 0; trial < 50; ++trial) {
    std::array<Vector3, 4> p = {vector(), vector(), vector(), vector()};
    if ((p[1] - p[0]).dot((p[2] - p[0]).cross(p[3] - p[0])) < 0) std::swap(p[0], p[1]);
    const double volume = (p[1] - p[0]).dot((p[2] - p[0]).cross(p[3] - p[0])) / 6;
    if (volume < 1e-2) continue;
    Eigen::Matrix<double, 4, 3> f;
    for (Eigen::Index k = 0; k < 4; ++k)
      f.row(k) = vector();
    // Columns of S: areas of the faces opposite to the corners, along their normals inward.
    Eigen::Matrix<double, 3, 4> s;
    for (std::size_t k = 0; k < 4; ++k) {
      const Vector3 &a = p[(k + 1) % 4], &b = p[(k + 2) % 4], &c = p[(k + 3) % 4];
      const Vector3 across = (b - a).cross(c - a) / 2;
      s.col(static_cast<Eigen::Index>(k)) = across.dot(p[k] - a) > 0 ? across : Vector3(-across);
    }
    const Eigen::Matrix3d gradients = s * f / (3 * volume);  // a column a coordinate
    const Vector3 edge = p[2] - p[0];
    CHECK((gradients.transpose() * edge - (f.row(2) - f.row(0)).transpose()).norm() <
          1e-10 * gradients.norm() * edge.norm());
    const Eigen::Matrix3d frame = Eigen::Quaterniond::UnitRandom().toRotationMatrix();
    const double cell = 0.7;
    CHECK(frame_energy(p, frame, cell, f) ==
          doctest::Approx(volume * (gradients - frame / cell).squaredNorm()).epsilon(1e-10));
  }
}

TEST_CASE("the energy of eq. 5.3 has the derivative that differences give") {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  const auto vector = [&] { return Vector3(normal(random), normal(random), normal(random)); };
  for (int trial = 0; trial < 20; ++trial) {
    std::array<Vector3, 4> p = {vector(), vector(), vector(), vector()};
    if ((p[1] - p[0]).dot((p[2] - p[0]).cross(p[3] - p[0])) < 0) std::swap(p[0], p[1]);
    const Eigen::Matrix3d frame = Eigen::Quaterniond::UnitRandom().toRotationMatrix();
    Eigen::Matrix<double, 4, 3> f, derivative;
    for (Eigen::Index k = 0; k < 4; ++k)
      f.row(k) = vector();
    frame_energy(p, frame, 0.7, f, &derivative);
    for (Eigen::Index i = 0; i < 12; ++i) {
      constexpr double step = 1e-4;  // of a quadratic: differences are exact but for rounding
      Eigen::Matrix<double, 4, 3> more = f, less = f;
      more(i % 4, i / 4) += step;
      less(i % 4, i / 4) -= step;
      const double slope = (frame_energy(p, frame, 0.7, more) - frame_energy(p, frame, 0.7, less)) / (2 * step);
      CHECK(slope == doctest::Approx(derivative(i % 4, i / 4)).epsilon(1e-6).scale(derivative.norm()));
    }
  }
}

TEST_CASE("a bar along its frames has its own coordinates, in cells") {
  const FramedSolid solid = framed(BlockMesh(bar(3), 2));
  const Parameterization map = parameterize(solid, {.cell_length = 0.5}, {});
  CHECK(map.energy < 1e-16);
  CHECK(map.inverted == 0);
  CHECK(map.cut_faces == 0);
  CHECK(map.patches == 6);
  const Vector3 origin = map.corners[0][0] - 2 * solid.positions[solid.tetrahedra[0][0]];
  for (std::size_t t = 0; t < solid.tetrahedra.size(); ++t) {
    for (std::size_t k = 0; k < 4; ++k)
      CHECK((map.corners[t][k] - 2 * solid.positions[solid.tetrahedra[t][k]] - origin).norm() <
            1e-7);  // the system holds what nothing determines by 1e-10
  }
}

TEST_CASE("a field that turns by a third of a turn around an edge is refused with the place") {
  FramedSolid solid = framed(BlockMesh(bar(3), 3));
  // One tetrahedron alone in another frame makes no singular edge; three that differ by a third of a turn in sequence
  // do.
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  for (auto& q : solid.frames)
    q = quaternion::normalized({normal(random), normal(random), normal(random), normal(random)});
  try {
    parameterize(solid, {.cell_length = 0.5}, {});
    FAIL("not refused");
  } catch (const base::Error& error) {
    CHECK(std::string(error.kind()) == "no-valid-result");
    CHECK(std::string(error.what()).find(", at (") != std::string::npos);
  }
}

TEST_CASE("frames guide a map to a polycube, whatever they are named, and nothing is inverted") {
  const BlockSolid block(bar(3), 3, 0.2, 0.05);
  std::mt19937_64 random(11);
  Array<quaternion::Quaternion> frames;
  for (std::size_t t = 0; t < block.tetrahedra.size(); ++t)
    frames.push_back(quaternion::cube_group.element[random() % 24]);
  GuidedFigures figures, again;
  const VolumeMap map = map_to_polycube_by_frames(block.solid(), frames, figures, {});
  CHECK(untangle::count_inverted(map.tetrahedra, map.image, {}).count == 0);
  // Harmonic coordinates have the same boundary, for which no others have less energy than the minimum.
  const OwnMinimum own(map, block.map.positions.size());
  CHECK(figures.energy == doctest::Approx(own.energy(map.image)).epsilon(1e-9));
  CHECK(figures.minimum_energy == doctest::Approx(own.minimum(map.image)).epsilon(1e-7));  // of conjugate gradients
  CHECK(figures.minimum_energy <= figures.harmonic_energy);
  CHECK(figures.energy >= figures.minimum_energy * (1 - 1e-9));
  CHECK(figures.mismatched_faces == 0);
  frames.assign(frames.size(), {1, 0, 0, 0});
  const VolumeMap other = map_to_polycube_by_frames(block.solid(), frames, again, {});
  CHECK(again.energy == doctest::Approx(figures.energy).epsilon(1e-9));
  for (std::size_t v = 0; v < map.image.size(); ++v)
    CHECK((map.image[v] - other.image[v]).norm() < 1e-7);
}

TEST_CASE("the energy of a guided map has the derivative that differences give") {
  const BlockSolid block(bar(2), 1, 0.3, 0.2);
  Array<quaternion::Quaternion> frames(block.tetrahedra.size(), quaternion::Quaternion{0.8, 0, 0.6, 0});
  std::vector<Vector3> image(block.positions.begin(), block.positions.end()), gradient(image.size(), Vector3::Zero());
  guided_energy(block.positions, image, block.tetrahedra, frames, 1.3, gradient);
  for (std::size_t v = 0; v < image.size(); ++v) {
    for (Eigen::Index a = 0; a < 3; ++a) {
      constexpr double step = 1e-4;
      const double at = image[v][a];
      image[v][a] = at + step;
      const double more = guided_energy(block.positions, image, block.tetrahedra, frames, 1.3);
      image[v][a] = at - step;
      const double less = guided_energy(block.positions, image, block.tetrahedra, frames, 1.3);
      image[v][a] = at;
      CHECK((more - less) / (2 * step) == doctest::Approx(gradient[v][a]).epsilon(1e-6).scale(1));
    }
  }
}

TEST_CASE("points are found with the weights that make them, and outside there is none") {
  const FramedSolid solid = cylinder(6, 4, 1);
  const PointLocator locator(solid.positions, solid.tetrahedra, {});
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int trial = 0; trial < 500; ++trial) {
    const auto& t =
        solid.tetrahedra[static_cast<std::size_t>(uniform(random) * static_cast<double>(solid.tetrahedra.size()))];
    std::array<double, 4> w{};
    double sum = 0;
    for (double& x : w)
      sum += x = uniform(random);
    Vector3 p = Vector3::Zero();
    for (std::size_t k = 0; k < 4; ++k)
      p += w[k] / sum * solid.positions[t[k]];
    const Location found = locator.locate(p);
    REQUIRE(found.tetrahedron != no_index);
    CHECK((found.at(solid.positions, solid.tetrahedra) - p).norm() < 1e-13);
  }
  for (const Vector3& p : solid.positions)
    CHECK_UNARY(locator.locate(p).tetrahedron != no_index);
  CHECK(locator.locate({0, 0, 1.01}).tetrahedron == no_index);
  CHECK(locator.locate({2, 0, 0.5}).tetrahedron == no_index);
}

TEST_CASE("a grid taken through the identity is the grid") {
  const BlockMesh block(bar(3), 2);
  Array<Vector3> positions(block.positions.begin(), block.positions.end());
  Array<Tetrahedron> tetrahedra(block.tetrahedra.begin(), block.tetrahedra.end());
  const ResampledGrid grid = resample_grid(positions, positions, tetrahedra, 24, {});
  CHECK(grid.hexahedra.size() == 24);
  CHECK(grid.not_positive == 0);
  CHECK(grid.min_scaled_jacobian == doctest::Approx(1).epsilon(1e-12));
  for (std::size_t v = 0; v < grid.positions.size(); ++v)
    CHECK((grid.positions[v] - grid.parameters[v]).norm() < 1e-14);
}
