#include "sphere_map/optimization/coarse_space.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

namespace orbicube::sphere_map {
namespace {

// Larger: a smaller system, which leaves more to conjugate gradients; smaller: its factor costs more than they do.
constexpr std::size_t vertices_a_cluster = 24;
constexpr std::size_t clusters_a_piece = 64;
// Fewer are no coarse space.
constexpr std::size_t min_clusters = 4;

// Parts of the diagonal that are added: the first for the rotations of the sphere, which cost no energy, then ten times
// more at each failure, up to what dominates the matrix.
constexpr double first_shift = 1e-4, shift_growth = 10;
constexpr int max_shifts = 6;

constexpr Index none = ~Index{0};

}  // namespace

CoarseSpace::CoarseSpace(const StarMatrix& matrix, const base::Host& host, const base::ThreadPool& pool)
    : host_(host),
      pool_(pool),
      count_((matrix.size() + vertices_a_cluster - 1) / vertices_a_cluster),
      cluster_of_(matrix.size(), none, host.memory),
      members_(matrix.size(), host.memory),
      begin_(count_ + 1, 0, host.memory),
      modes_(matrix.size(), host.memory),
      // The same bits in every program, also where one provides CHOLMOD.
      factor_(linear::make_direct_factor(linear::DirectMethod::eigen)),
      solution_(static_cast<Eigen::Index>(4 * count_)) {
  // Breadth-first from all first vertices at once; the order of a level is local, so that they lie apart.
  base::Array<Index> queue(host.memory);
  queue.reserve(matrix.size());
  for (std::size_t c = 0; c < count_; ++c) {
    queue.push_back(static_cast<Index>(c * vertices_a_cluster));
    cluster_of_[queue.back()] = static_cast<Index>(c);
  }
  for (std::size_t k = 0; k < queue.size(); ++k) {
    for (const Index neighbor : matrix.columns(queue[k])) {
      if (cluster_of_[neighbor] != none) continue;
      cluster_of_[neighbor] = cluster_of_[queue[k]];
      queue.push_back(neighbor);
    }
  }
  for (const Index c : cluster_of_)
    ++begin_[c + 1];
  for (std::size_t c = 0; c < count_; ++c)
    begin_[c + 1] += begin_[c];
  base::Array<std::size_t> end(begin_.begin(), begin_.end(), host.memory);
  for (std::size_t i = 0; i < matrix.size(); ++i)
    members_[end[cluster_of_[i]]++] = static_cast<Index>(i);
}

void CoarseSpace::set_modes(std::span<const Index> cluster, std::span<const Vector3> points) {
  Vector3 center = Vector3::Zero();
  for (const Index i : cluster)
    center += points[i];
  center.normalize();
  double square = 0;
  for (const Index i : cluster)
    square += (points[i] - center).squaredNorm();
  constexpr double min_square = 1e-30;
  const double scale = 1 / std::sqrt(std::max(square / static_cast<double>(cluster.size()), min_square));
  const TangentBasis plane(center);
  for (const Index i : cluster) {
    const TangentBasis basis(points[i]);
    Eigen::Matrix<double, 3, 4> moves;
    moves << plane.first, plane.second, scale * center.cross(points[i]), scale * (points[i] - center);
    modes_[i].row(0) = basis.first.transpose() * moves;
    modes_[i].row(1) = basis.second.transpose() * moves;
    if (cluster.size() == 1) modes_[i].rightCols<2>().setZero();
  }
}

// The entries of the lower triangle in the rows of a cluster; `blocks` is room for its own.
void CoarseSpace::add_rows(std::size_t c, const StarMatrix& matrix, Blocks& blocks, linear::Triplets& entries) const {
  blocks.assign(1, {c, Eigen::Matrix4d::Zero()});
  const auto block = [&](std::size_t other) -> Eigen::Matrix4d& {
    auto found = std::find_if(blocks.begin(), blocks.end(), [&](const auto& b) { return b.first == other; });
    if (found == blocks.end()) found = blocks.insert(found, {other, Eigen::Matrix4d::Zero()});
    return found->second;
  };
  for (const Index i : cluster(c)) {
    block(c) += modes_[i].transpose() * matrix.diagonal[i] * modes_[i];
    const std::span<const Index> columns = matrix.columns(i);
    const std::span<const Eigen::Matrix2d> row = matrix.row(i);
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const std::size_t other = cluster_of_[columns[k]];
      if (other <= c) block(other) += modes_[i].transpose() * row[k] * modes_[columns[k]];
    }
  }
  for (const auto& b : blocks) {
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < (b.first == c ? i + 1 : 4); ++j)
        entries.emplace_back(static_cast<int>(4 * c) + i, static_cast<int>(4 * b.first) + j, b.second(i, j));
    }
  }
}

void CoarseSpace::set(const StarMatrix& matrix, std::span<const Vector3> points) {
  usable_ = false;
  if (count_ < min_clusters) return;
  pool_.run_pieces(count_, clusters_a_piece, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c)
      set_modes(cluster(c), points);
  });
  base::Array<linear::Triplets> pieces((count_ + clusters_a_piece - 1) / clusters_a_piece,
                                       linear::Triplets(host_.memory), host_.memory);
  pool_.run_pieces(count_, clusters_a_piece, [&](std::size_t begin, std::size_t end) {
    Blocks blocks(host_.memory);
    for (std::size_t c = begin; c < end; ++c)
      add_rows(c, matrix, blocks, pieces[begin / clusters_a_piece]);
  });
  linear::Triplets entries(host_.memory);
  for (const linear::Triplets& piece : pieces)
    entries.insert(entries.end(), piece.begin(), piece.end());
  const auto size = static_cast<Eigen::Index>(4 * count_);
  linear::SparseMatrix coarse(size, size);
  coarse.setFromTriplets(entries.begin(), entries.end());
  factor(coarse);
}

void CoarseSpace::factor(linear::SparseMatrix& coarse) {
  constexpr double min_diagonal = 1e-12;  // of clusters of one vertex, which have no rotation
  const Eigen::VectorXd diagonal = coarse.diagonal().cwiseAbs().cwiseMax(min_diagonal);
  if (!analyzed_) factor_->analyze(coarse);
  analyzed_ = true;
  double shift = first_shift, before = 0;
  for (int trial = 0; trial < max_shifts && !usable_; ++trial) {
    host_.report("final optimization", 0, 0);
    for (Eigen::Index i = 0; i < coarse.rows(); ++i)
      coarse.coeffRef(i, i) += (shift - before) * diagonal[i];
    usable_ = factor_->factorize(coarse) && factor_->is_positive();
    before = std::exchange(shift, shift_growth * shift);
  }
}

void CoarseSpace::correct(std::span<const Vector2d> residual, std::span<Vector2d> z) {
  if (!usable_) return;
  pool_.run_pieces(count_, clusters_a_piece, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      Eigen::Vector4d sum = Eigen::Vector4d::Zero();
      for (const Index i : cluster(c))
        sum += modes_[i].transpose() * residual[i];
      solution_.segment<4>(static_cast<Eigen::Index>(4 * c)) = sum;
    }
  });
  const std::span<double> solution(solution_.data(), static_cast<std::size_t>(solution_.size()));
  factor_->solve(solution, 1, solution);
  pool_.run_pieces(z.size(), vertices_a_piece, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      z[i] += modes_[i] * solution_.segment<4>(static_cast<Eigen::Index>(4 * cluster_of_[i]));
  });
}

}  // namespace orbicube::sphere_map
