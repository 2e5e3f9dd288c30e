#include "volume_map/frame_map/frame_guided.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "base/grouping.h"
#include "frame_field/singularities/singularities.h"
#include "linear/sparse_system.h"
#include "mesh/search/predicates.h"
#include "volume_map/frames/frame_energy.h"
#include "volume_map/sampling/point_location.h"
#include "volume_map/solid/boundary_refinement.h"
#include "volume_map/solid/harmonic_start.h"
#include "volume_map/solid/solid_map.h"

namespace orbicube::volume_map {
namespace {

constexpr int max_sweeps = 200;

using quaternion::cube_group;
using quaternion::Quaternion;

std::array<Vector3, 4> corners_of(std::span<const Vector3> positions, const Tetrahedron& t) {
  return {positions[t[0]], positions[t[1]], positions[t[2]], positions[t[3]]};
}

Eigen::Matrix<double, 4, 3> rows_of(std::span<const Vector3> positions, const Tetrahedron& t) {
  Eigen::Matrix<double, 4, 3> rows;
  for (std::size_t k = 0; k < 4; ++k)
    rows.row(static_cast<Eigen::Index>(k)) = positions[t[k]];
  return rows;
}

// The frames of the tetrahedra in which the centers of these lie; where rounding puts one outside, that of the one
// before.
Array<Quaternion> frames_at(const PolycubeSolid& solid, std::span<const Quaternion> frames,
                            std::span<const Vector3> positions, std::span<const Tetrahedron> tetrahedra,
                            const base::Host& host) {
  const PointLocator locator(solid.positions, solid.tetrahedra, host);
  Array<Quaternion> result(tetrahedra.size(), frames[0], host.memory);
  Index last = 0;
  for (std::size_t t = 0; t < tetrahedra.size(); ++t) {
    if (t % 1024 == 0) host.report("frames", t, tetrahedra.size());
    Vector3 center = Vector3::Zero();
    for (const Index v : tetrahedra[t])
      center += 0.25 * positions[v];
    const Location found = locator.locate(center, 1e-6);
    if (found.tetrahedron != no_index) last = found.tetrahedron;
    result[t] = frames[last];
  }
  return result;
}

// The one of the 24 names of a frame whose matrix R has the maximum trace of `towards` R.
Quaternion named_towards(const Quaternion& frame, const Eigen::Matrix3d& towards) {
  double nearest = -HUGE_VAL;
  Quaternion name = frame;
  for (const Quaternion& g : cube_group.element) {
    const Quaternion q = quaternion::multiply(frame, g);
    const double along = (towards * matrix_of(q)).trace();
    if (along <= nearest) continue;
    nearest = along;
    name = q;
  }
  return name;
}

// Names each frame so that its axes are near to the gradients of the image, then, in sweeps, also to those of its
// neighbors: a gradient may be turned by more than 45 degrees from the frames around, and these agree.
void name_by_gradients(std::span<const Vector3> source, std::span<const Vector3> image,
                       std::span<const Tetrahedron> tetrahedra, double scale, std::span<Quaternion> frames,
                       const base::Host& host) {
  constexpr int sweeps = 10;
  const mesh::TetrahedralConnectivity connectivity(source.size(), tetrahedra, host);
  Array<Eigen::Matrix3d> gradients(tetrahedra.size(), host.memory);
  for (std::size_t t = 0; t < tetrahedra.size(); ++t) {
    Eigen::Matrix3d edges, images;
    for (std::size_t k = 0; k < 3; ++k) {
      edges.col(static_cast<Eigen::Index>(k)) = source[tetrahedra[t][k + 1]] - source[tetrahedra[t][0]];
      images.col(static_cast<Eigen::Index>(k)) = image[tetrahedra[t][k + 1]] - image[tetrahedra[t][0]];
    }
    gradients[t] = images * edges.inverse() / scale;
    frames[t] = named_towards(frames[t], gradients[t]);
  }
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (Index t = 0; t < tetrahedra.size(); ++t) {
      if (t % 1024 == 0) host.report("frames", t, tetrahedra.size());
      Eigen::Matrix3d towards = gradients[t] / std::max(1.0, gradients[t].norm() / std::sqrt(3.0));
      for (Index k = 0; k < 4; ++k) {
        const Index other = connectivity.neighbor(t, k);
        if (other != no_index) towards += matrix_of(frames[other]).transpose();
      }
      frames[t] = named_towards(frames[t], towards);
    }
  }
}

// Moves the vertices that are not `held` to the minimum of eq. 5.3 for frames of the length `scale`.
void minimize(std::span<const Vector3> source, std::span<const Tetrahedron> tetrahedra,
              std::span<const Quaternion> frames, double scale, std::span<const std::uint8_t> held,
              std::span<Vector3> image, const base::Host& host) {
  Array<Index> number(held.size(), no_index, host.memory);
  std::size_t free = 0;
  for (std::size_t v = 0; v < held.size(); ++v) {
    if (held[v] == 0) number[v] = static_cast<Index>(free++);
  }
  if (free == 0) return;
  linear::SparseSystem::Triplets triplets(host.memory);
  for (std::size_t i = 0; i < free; ++i)
    triplets.emplace_back(static_cast<int>(i), static_cast<int>(i), 0.0);
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(free), 3);
  for (std::size_t t = 0; t < tetrahedra.size(); ++t) {
    if (t % 1024 == 0) host.report("parameterize", t, tetrahedra.size());
    // Half of the gradient at 0 is what the frames pull by; fixed coordinates join it.
    const std::array<Vector3, 4> p = corners_of(source, tetrahedra[t]);
    Eigen::Matrix<double, 4, 3> pull;
    frame_energy(p, matrix_of(frames[t]), 1 / scale, Eigen::Matrix<double, 4, 3>::Zero(), &pull);
    Eigen::Matrix3d edges;
    edges << p[1] - p[0], p[2] - p[0], p[3] - p[0];
    Eigen::Matrix<double, 4, 3> gradients;
    gradients.bottomRows<3>() = edges.inverse();
    gradients.row(0) = -gradients.bottomRows<3>().colwise().sum();
    const Eigen::Matrix4d square = edges.determinant() / 6 * gradients * gradients.transpose();
    for (std::size_t k = 0; k < 4; ++k) {
      const auto row = static_cast<Eigen::Index>(k);
      const Index i = number[tetrahedra[t][k]];
      if (i == no_index) continue;
      right.row(static_cast<Eigen::Index>(i)) -= 0.5 * pull.row(row);
      for (std::size_t l = 0; l < 4; ++l) {
        const double entry = square(row, static_cast<Eigen::Index>(l));
        const Index j = number[tetrahedra[t][l]];
        if (j == no_index)
          right.row(static_cast<Eigen::Index>(i)) -= entry * image[tetrahedra[t][l]].transpose();
        else if (i >= j)
          triplets.emplace_back(static_cast<int>(i), static_cast<int>(j), entry);
      }
    }
  }
  host.report("factorize", 0, 0);
  linear::SparseSystem system(free, triplets);
  if (!system.factorize()) throw base::Error("degenerate-geometry", "the system of eq. 5.3 cannot be factorized");
  for (Eigen::Index a = 0; a < 3; ++a) {
    const Eigen::VectorXd solution = system.solve(right.col(a));
    for (std::size_t v = 0; v < held.size(); ++v) {
      if (number[v] != no_index) image[v][a] = solution[static_cast<Eigen::Index>(number[v])];
    }
  }
}

// Lowers eq. 5.3 vertex by vertex, each to the minimum among its tetrahedra or as far towards it as all of these stay
// positive, by exact signs, and none gets flatter than a hundredth of its target shape or than it was.
class PositiveDescent {
 public:
  PositiveDescent(const SolidMap& map, std::span<const Quaternion> frames, const base::Host& host)
      : map_(map),
        host_(host),
        around_(base::cells_around(std::span<const Tetrahedron>(map.tetrahedra), map.source.size(), host.memory)),
        gradients_(map.tetrahedra.size(), host.memory),
        volumes_(map.tetrahedra.size(), host.memory),
        targets_(map.tetrahedra.size(), host.memory) {
    for (std::size_t t = 0; t < map.tetrahedra.size(); ++t) {
      const std::array<Vector3, 4> p = corners_of(map.source, map.tetrahedra[t]);
      Eigen::Matrix3d edges;
      edges << p[1] - p[0], p[2] - p[0], p[3] - p[0];
      gradients_[t].bottomRows<3>() = edges.inverse();
      gradients_[t].row(0) = -gradients_[t].bottomRows<3>().colwise().sum();
      volumes_[t] = edges.determinant() / 6;
      targets_[t] = map.scale * matrix_of(frames[t]);
    }
  }

  // `image` is positive, and stays so; fixed vertices stay.
  void run(int sweeps, std::span<const std::uint8_t> held, std::span<Vector3> image) const {
    for (int sweep = 0; sweep < sweeps; ++sweep) {
      double moved = 0;
      for (Index v = 0; v < image.size(); ++v) {
        if (v % 1024 == 0) host_.report("lower", static_cast<std::uint64_t>(sweep), static_cast<std::uint64_t>(sweeps));
        if (held[v] == 0) moved = std::max(moved, move(v, image));
      }
      if (moved < 1e-6) break;
    }
  }

 private:
  // Returns the way over the length of the frames' vectors and the cube root of the mean volume around.
  double move(Index v, std::span<Vector3> image) const {
    Vector3 pull = Vector3::Zero();
    double stiffness = 0, volume = 0;
    for (const Index t : around_[v]) {
      const Tetrahedron& c = map_.tetrahedra[t];
      const auto row = static_cast<Eigen::Index>(std::find(c.begin(), c.end(), v) - c.begin());
      const Eigen::Matrix3d rest = gradients_[t].transpose() * rows_of(image, c) - targets_[t];
      pull += volumes_[t] * (gradients_[t].row(row) * rest).transpose();
      stiffness += volumes_[t] * gradients_[t].row(row).squaredNorm();
      volume += volumes_[t];
    }
    if (!(stiffness > 0)) return 0;
    const Vector3 before = image[v], step = -pull / stiffness;
    constexpr int max_halvings = 6;
    double length = over_relaxation;
    for (int halving = 0; halving < max_halvings; ++halving, length *= 0.5) {
      if (!stays_positive(v, before, before + length * step, image)) continue;
      image[v] = before + length * step;
      return length * step.norm() / (map_.scale * std::cbrt(volume / static_cast<double>(around_[v].size())));
    }
    return 0;
  }

  bool stays_positive(Index v, const Vector3& before, const Vector3& after, std::span<Vector3> image) const {
    constexpr double flattest = 0.01;
    for (const Index t : around_[v]) {
      const Tetrahedron& c = map_.tetrahedra[t];
      image[v] = before;
      const double was = untangle::six_volumes(image, c);
      image[v] = after;
      const double now = untangle::six_volumes(image, c),
                   target = 6 * volumes_[t] * map_.scale * map_.scale * map_.scale;
      const bool good = now >= std::min(flattest * target, was) &&
                        mesh::orientation_3d(image[c[0]], image[c[1]], image[c[2]], image[c[3]]) > 0;
      image[v] = before;
      if (!good) return false;
    }
    return true;
  }

  static constexpr double over_relaxation = 1.5;
  const SolidMap& map_;
  const base::Host& host_;
  base::Groups<Index, Index> around_;             // tetrahedra of each vertex
  Array<Eigen::Matrix<double, 4, 3>> gradients_;  // of barycentric coordinates
  Array<double> volumes_;
  Array<Eigen::Matrix3d> targets_;  // a column a coordinate
};

// The share of the way from one image to another on which all tetrahedra stay positive: the first of 1, 1/2, ...
// that is.
void go_towards(const SolidMap& map, std::span<const Vector3> target, std::span<Vector3> image,
                const base::Host& host) {
  Array<Vector3> trial(image.begin(), image.end(), host.memory);
  for (double share = 1; share > 0.01; share *= 0.5) {
    host.report("lower", 0, 0);
    for (std::size_t v = 0; v < image.size(); ++v)
      trial[v] = image[v] + share * (target[v] - image[v]);
    const bool positive = std::all_of(map.tetrahedra.begin(), map.tetrahedra.end(), [&](const Tetrahedron& t) {
      return mesh::orientation_3d(trial[t[0]], trial[t[1]], trial[t[2]], trial[t[3]]) > 0;
    });
    if (!positive) continue;
    std::copy(trial.begin(), trial.end(), image.begin());
    return;
  }
}

std::size_t count_mismatches(std::span<const Vector3> source, std::span<const Tetrahedron> tetrahedra,
                             std::span<const Quaternion> frames, const base::Host& host) {
  const mesh::TetrahedralConnectivity connectivity(source.size(), tetrahedra, host);
  const auto matchings = frame_field::matchings(connectivity, frames, host);
  std::size_t count = 0;
  for (Index face = 0; face < connectivity.face_count(); ++face)
    count += !connectivity.on_boundary(face) && face < connectivity.opposite(face) && matchings[face] != 0 ? 1 : 0;
  return count;
}

}  // namespace

double guided_energy(std::span<const Vector3> source, std::span<const Vector3> image,
                     std::span<const Tetrahedron> tetrahedra, std::span<const Quaternion> frames, double scale,
                     std::span<Vector3> gradient) {
  double sum = 0;
  for (std::size_t t = 0; t < tetrahedra.size(); ++t) {
    Eigen::Matrix<double, 4, 3> derivative;
    sum += frame_energy(corners_of(source, tetrahedra[t]), matrix_of(frames[t]), 1 / scale,
                        rows_of(image, tetrahedra[t]), gradient.empty() ? nullptr : &derivative);
    for (std::size_t k = 0; k < 4 && !gradient.empty(); ++k)
      gradient[tetrahedra[t][k]] += derivative.row(static_cast<Eigen::Index>(k));
  }
  return sum;
}

VolumeMap map_to_polycube_by_frames(const PolycubeSolid& solid, std::span<const Quaternion> frames,
                                    GuidedFigures& figures, const base::Host& host, untangle::BlockEngine* engine) {
  base::require(frames.size() == solid.tetrahedra.size(), "frames need one entry a tetrahedron");
  const RefinedSolid refined = refine_boundary(solid.positions, solid.tetrahedra, solid.surface, solid.map, host);
  Array<Quaternion> named(host.memory);
  const auto energy_of = [&](const SolidMap& map, std::span<const Vector3> image) {
    double volume = 0;
    for (const Tetrahedron& t : map.tetrahedra)
      volume += untangle::six_volumes(map.source, t) / 6;
    return guided_energy(map.source, image, map.tetrahedra, named, map.scale) / (map.scale * map.scale * volume);
  };
  const auto start = [&](const SolidMap& map, std::span<const std::uint8_t> held, std::span<Vector3> image) {
    named = frames_at(solid, frames, map.source, map.tetrahedra, host);
    name_by_gradients(map.source, image, map.tetrahedra, map.scale, named, host);
    minimize(map.source, map.tetrahedra, named, map.scale, held, image, host);
    figures.mismatched_faces = count_mismatches(map.source, map.tetrahedra, named, host);
  };
  SolidMap map = map_solid(solid.map, solid.map.polycube, refined.positions, refined.tetrahedra,
                           {.polish_steps = 0, .engine = engine, .start = start}, host);
  // Untangling goes by another energy: back towards the minimum as far as nothing is inverted.
  Array<std::uint8_t> held(map.source.size(), 0, host.memory);
  std::fill_n(held.begin(), solid.map.positions.size(), std::uint8_t{1});
  Array<Vector3> best(map.image, host.memory);
  minimize(map.source, map.tetrahedra, named, map.scale, held, best, host);
  figures.minimum_energy = energy_of(map, best);
  Array<Vector3> harmonic(map.image, host.memory);
  make_harmonic(untangle::elements_of(map.tetrahedra, map.source, map.scale, host), held, harmonic, host, engine);
  figures.harmonic_energy = energy_of(map, harmonic);
  go_towards(map, best, map.image, host);
  PositiveDescent(map, named, host).run(max_sweeps, held, map.image);
  figures.energy = energy_of(map, map.image);
  return VolumeMap(std::move(map));
}

}  // namespace orbicube::volume_map
