#include "linear/iterative/multigrid.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "base/grouping.h"
#include "linear/iterative/conjugate_gradients.h"

namespace orbicube::linear {
namespace {

constexpr std::size_t aggregate_size = 8;
constexpr std::size_t coarsest_rows = 100;
constexpr std::size_t max_dense = 800;  // unknowns of a matrix that is factored as a whole
constexpr std::size_t slab = 16384;

Index find(const Array<Index>& begin, const Array<Index>& columns, Index row, Index column) {
  const auto first = columns.begin() + static_cast<std::ptrdiff_t>(begin[row]);
  const auto last = columns.begin() + static_cast<std::ptrdiff_t>(begin[row + 1]);
  return static_cast<Index>(std::lower_bound(first, last, column) - columns.begin());
}

}  // namespace

template <int block>
void Multigrid<block>::factor(Matrix& matrix) {
  for (depth_ = 1;; ++depth_) {
    if (levels_.size() < depth_) levels_.push_back(std::make_unique<Level>(host_));
    Level& level = *levels_[depth_ - 1];
    level.matrix = depth_ == 1 ? &matrix : &level.coarse;
    const Matrix& m = *level.matrix;
    level.smoother.factor(*level.matrix);
    for (Array<double>* x : {&level.right, &level.solution, &level.residual, &level.first, &level.second,
                             &level.first_image, &level.second_image})
      x->assign(m.size(), 0.0);
    if (m.rows() <= coarsest_rows) break;
    std::size_t count = 0;
    aggregate(level, count);
    if (count == 0 || 2 * count > m.rows()) break;
    if (levels_.size() == depth_) levels_.push_back(std::make_unique<Level>(host_));
    make_coarse(level, count, levels_[depth_]->coarse);
  }
  factor_last();
}

// From each vertex that is left, in their order, grows an aggregate by what is coupled most to all of it. What remains
// alone joins the neighbor that it is coupled most to.
template <int block>
void Multigrid<block>::aggregate(Level& level, std::size_t& count) const {
  constexpr double weak = 0.1;  // of the strongest coupling of the first vertex
  const Matrix& m = *level.matrix;
  const std::size_t rows = m.rows();
  Array<Index> begin(rows + 1, host_.memory), neighbor(2 * m.column.size(), host_.memory);
  Array<float> coupling(neighbor.size(), host_.memory);
  // Relative to the diagonal, so that contrasts of the coefficients do not matter by themselves.
  const auto coupling_of = [&](Index v, Index i) {
    const double size = std::sqrt(m.diagonal[v].trace() * m.diagonal[m.column[i]].trace());
    return static_cast<float>(size > 0 ? std::max(0.0, -m.lower[i].trace()) / size : 0.0);
  };
  base::group_by_key(
      std::span(begin),
      [&](const auto& visit) {
        for (Index v = 0; v < rows; ++v) {
          if (v % slab == 0) host_.report("solve", 0, 0);
          for (Index i = m.row_begin[v]; i < m.row_begin[v + 1]; ++i) {
            const Index w = m.column[i];
            const float c = coupling_of(v, i);
            visit(v, w, c);
            visit(w, v, c);
          }
        }
      },
      [](Index) {},
      [&](Index at, Index other, float c) {
        neighbor[at] = other;
        coupling[at] = c;
      });
  level.aggregate.assign(rows, no_index);
  count = 0;
  struct Candidate {
    Index row;
    float coupling;
  };
  Array<Candidate> candidates(host_.memory);
  Array<Index> place(rows, no_index, host_.memory);  // of a row among the candidates
  const auto is_free = [&](Index v) { return m.own[v] != 0 && level.aggregate[v] == no_index; };
  for (Index seed = 0; seed < rows; ++seed) {
    if (seed % slab == 0) host_.report("solve", 0, 0);
    if (!is_free(seed)) continue;
    candidates.clear();
    Index added = seed;
    double strongest = 0;
    for (Index i = begin[seed]; i < begin[seed + 1]; ++i)
      strongest = std::max(strongest, static_cast<double>(coupling[i]));
    const auto number = static_cast<Index>(count);
    std::size_t size = 0;
    while (true) {
      level.aggregate[added] = number;
      if (++size == aggregate_size) break;
      for (Index i = begin[added]; i < begin[added + 1]; ++i) {
        const Index w = neighbor[i];
        if (!is_free(w) || !(coupling[i] > 0)) continue;
        if (place[w] == no_index) {
          place[w] = static_cast<Index>(candidates.size());
          candidates.push_back({w, 0});
        }
        candidates[place[w]].coupling += coupling[i];
      }
      const Candidate* best = nullptr;
      for (const Candidate& c : candidates) {
        if (level.aggregate[c.row] == no_index && (best == nullptr || c.coupling > best->coupling)) best = &c;
      }
      if (best == nullptr || best->coupling < weak * strongest) break;
      added = best->row;
    }
    for (const Candidate& c : candidates)
      place[c.row] = no_index;
    if (size > 2) {
      ++count;
      continue;
    }
    // Too few: where their strongest coupling leads, or an aggregate of their own.
    Index best = no_index;
    float most = 0;
    const auto look = [&](Index v) {
      for (Index i = begin[v]; i < begin[v + 1]; ++i) {
        const Index other = level.aggregate[neighbor[i]];
        if (other == no_index || other == number || !(coupling[i] > most)) continue;
        most = coupling[i];
        best = other;
      }
    };
    look(seed);
    if (size == 2) look(added);
    if (best == no_index) {
      ++count;
      continue;
    }
    level.aggregate[seed] = best;
    if (size == 2) level.aggregate[added] = best;
  }
}

template <int block>
void Multigrid<block>::make_coarse(const Level& level, std::size_t count, Matrix& coarse) const {
  const Matrix& m = *level.matrix;
  const Array<Index>& to = level.aggregate;
  coarse.own.assign(count, 0);
  for (std::size_t v = 0; v < m.rows(); ++v) {
    if (to[v] != no_index) coarse.own[to[v]] |= m.own[v];
  }
  Array<std::pair<Index, Index>> places(host_.memory);
  for (std::size_t v = 0; v < m.rows(); ++v) {
    if (v % slab == 0) host_.report("solve", 0, 0);
    for (Index i = m.row_begin[v]; i < m.row_begin[v + 1]; ++i) {
      const Index a = to[v], b = to[m.column[i]];
      if (a != b && a != no_index && b != no_index) places.push_back({std::max(a, b), std::min(a, b)});
    }
  }
  host_.report("solve", 0, 0);
  make_rows(places, count, coarse.row_begin, coarse.column);
  host_.report("solve", 0, 0);
  coarse.lower.assign(coarse.column.size(), Matrix::Block::Zero());
  coarse.diagonal.assign(count, Matrix::Block::Zero());
  for (std::size_t v = 0; v < m.rows(); ++v) {
    if (v % slab == 0) host_.report("solve", 0, 0);
    const Index a = to[v];
    if (a == no_index) continue;
    for (Eigen::Index r = 0; r < block; ++r) {
      for (Eigen::Index c = 0; c < block; ++c) {
        if (m.is_own(v, static_cast<std::size_t>(r)) && m.is_own(v, static_cast<std::size_t>(c)))
          coarse.diagonal[a](r, c) += m.diagonal[v](r, c);
      }
    }
    for (Index i = m.row_begin[v]; i < m.row_begin[v + 1]; ++i) {
      const Index b = to[m.column[i]];
      if (b == no_index) continue;
      if (a == b)
        coarse.diagonal[a] += m.lower[i] + m.lower[i].transpose();
      else if (a > b)
        coarse.lower[find(coarse.row_begin, coarse.column, a, b)] += m.lower[i];
      else
        coarse.lower[find(coarse.row_begin, coarse.column, b, a)] += m.lower[i].transpose();
    }
  }
  for (std::size_t a = 0; a < count; ++a) {
    const double trace = coarse.diagonal[a].trace();
    for (std::size_t k = 0; k < Matrix::unknowns; ++k) {
      if (!coarse.is_own(a, k))
        coarse.diagonal[a](static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(k)) = trace > 0 ? trace : 1;
    }
  }
  // What is shared stays.
  places.clear();
  for (Index s = 0; s < m.shared(); ++s) {
    for (Index i = m.border_begin[s]; i < m.border_begin[s + 1]; ++i) {
      if (to[m.border_column[i]] != no_index) places.push_back({s, to[m.border_column[i]]});
    }
  }
  make_rows(places, m.shared(), coarse.border_begin, coarse.border_column);
  coarse.border.assign(coarse.border_column.size(), Matrix::Entry::Zero());
  for (Index s = 0; s < m.shared(); ++s) {
    for (Index i = m.border_begin[s]; i < m.border_begin[s + 1]; ++i) {
      const Index a = to[m.border_column[i]];
      if (a != no_index) coarse.border[find(coarse.border_begin, coarse.border_column, s, a)] += m.border[i];
    }
  }
  coarse.corner_begin = m.corner_begin;
  coarse.corner_column = m.corner_column;
  coarse.corner = m.corner;
  coarse.corner_diagonal = m.corner_diagonal;
}

template <int block>
void Multigrid<block>::factor_last() {
  Level& level = *levels_[depth_ - 1];
  const Matrix& m = *level.matrix;
  const std::size_t size = m.size();
  last_.clear();
  if (size > max_dense) return;
  last_.resize(size * size);
  for (std::size_t i = 0; i < size; ++i) {
    level.first[i] = 1;
    m.multiply(level.first, std::span(last_).subspan(i * size, size), host_);
    level.first[i] = 0;
  }
  for (std::size_t i = 0; i < size; ++i) {
    if (i % 64 == 0) host_.report("solve", 0, 0);
    double* const row = &last_[i * size];
    for (std::size_t j = 0; j <= i; ++j) {
      const double* const other = &last_[j * size];
      double sum = row[j];
      for (std::size_t k = 0; k < j; ++k)
        sum -= row[k] * other[k];
      row[j] = j < i ? sum / other[j] : std::sqrt(sum);
    }
    if (row[i] > 0 && std::isfinite(row[i])) continue;
    last_.clear();
    return;
  }
}

template <int block>
void Multigrid<block>::cycle(std::size_t number, std::span<const double> right, std::span<double> x) {
  Level& level = *levels_[number];
  if (number + 1 == depth_) {
    if (last_.empty()) {
      level.smoother.solve(right, 100, 1e-3, x);
      return;
    }
    const std::size_t size = x.size();
    for (std::size_t i = 0; i < size; ++i) {
      double sum = right[i];
      for (std::size_t k = 0; k < i; ++k)
        sum -= last_[i * size + k] * x[k];
      x[i] = sum / last_[i * size + i];
    }
    for (std::size_t i = size; i-- > 0;) {
      x[i] /= last_[i * size + i];
      for (std::size_t k = 0; k < i; ++k)
        x[k] -= last_[i * size + k] * x[i];
    }
    return;
  }
  level.smoother.sweep_from_zero(right, x, level.residual);
  Level& next = *levels_[number + 1];
  const std::size_t rows = level.matrix->rows(), coarse_rows = next.matrix->rows();
  std::fill(next.right.begin(), next.right.end(), 0.0);
  for (std::size_t v = 0; v < rows; ++v) {
    const Index a = level.aggregate[v];
    if (a == no_index) continue;
    for (std::size_t k = 0; k < Matrix::unknowns; ++k) {
      if (level.matrix->is_own(v, k))
        next.right[Matrix::unknowns * static_cast<std::size_t>(a) + k] += level.residual[Matrix::unknowns * v + k];
    }
  }
  for (std::size_t s = 0; s < level.matrix->shared(); ++s)
    next.right[Matrix::unknowns * coarse_rows + s] = level.residual[Matrix::unknowns * rows + s];
  solve_level(number + 1);
  for (std::size_t v = 0; v < rows; ++v) {
    const Index a = level.aggregate[v];
    if (a == no_index) continue;
    for (std::size_t k = 0; k < Matrix::unknowns; ++k) {
      if (level.matrix->is_own(v, k))
        x[Matrix::unknowns * v + k] += next.solution[Matrix::unknowns * static_cast<std::size_t>(a) + k];
    }
  }
  for (std::size_t s = 0; s < level.matrix->shared(); ++s)
    x[Matrix::unknowns * rows + s] += next.solution[Matrix::unknowns * coarse_rows + s];
  level.smoother.sweep_back(right, x, level.residual);
}

template <int block>
void Multigrid<block>::solve_level(std::size_t number) {
  constexpr double little = 0.25;
  Level& level = *levels_[number];
  if (number + 1 == depth_) {
    cycle(number, level.right, level.solution);
    return;
  }
  cycle(number, level.right, level.first);
  level.matrix->multiply(level.first, level.first_image, host_);
  const double curvature = dot(level.first, level.first_image);
  const double slope = dot(level.first, level.right);
  if (!(curvature > 0) || !std::isfinite(slope / curvature)) {
    level.solution = level.first;
    return;
  }
  const double length = slope / curvature;
  const double before = dot(level.right, level.right);
  for (std::size_t i = 0; i < level.right.size(); ++i)
    level.right[i] -= length * level.first_image[i];
  if (dot(level.right, level.right) <= little * little * before) {
    for (std::size_t i = 0; i < level.solution.size(); ++i)
      level.solution[i] = length * level.first[i];
    return;
  }
  cycle(number, level.right, level.second);
  level.matrix->multiply(level.second, level.second_image, host_);
  const double mixed = dot(level.second, level.first_image);
  const double second_slope = dot(level.second, level.right);
  const double second_curvature = dot(level.second, level.second_image) - mixed * mixed / curvature;
  double second_length = second_slope / second_curvature;
  if (!(second_curvature > 0) || !std::isfinite(second_length)) second_length = 0;
  const double first_length = length - mixed * second_length / curvature;
  for (std::size_t i = 0; i < level.solution.size(); ++i)
    level.solution[i] = first_length * level.first[i] + second_length * level.second[i];
}

template <int block>
int Multigrid<block>::solve(std::span<const double> right, int max_steps, double tolerance,
                            std::span<double> solution) {
  // The preconditioner changes from step to step.
  struct System {
    Multigrid& own;
    std::span<const double> right;
    std::span<double> solution;
    Array<double>&residual, &search, &preconditioned, &image;

    double start() {
      std::fill(solution.begin(), solution.end(), 0.0);
      residual.assign(right.begin(), right.end());
      own.cycle(0, residual, preconditioned);
      search = preconditioned;
      return dot(residual, preconditioned);
    }
    double multiply() {
      own.levels_[0]->matrix->multiply(search, image, own.host_);
      return dot(search, image);
    }
    double along() const { return dot(search, residual); }
    double advance(double length) {
      for (std::size_t i = 0; i < solution.size(); ++i) {
        solution[i] += length * search[i];
        residual[i] -= length * image[i];
      }
      own.cycle(0, residual, preconditioned);
      return dot(residual, preconditioned);
    }
    double overlap() const { return dot(preconditioned, image); }
    void turn(double share) {
      for (std::size_t i = 0; i < solution.size(); ++i)
        search[i] = preconditioned[i] + share * search[i];
    }
  };
  Level& fine = *levels_[0];
  System system{*this, right, solution, fine.right, fine.first, fine.second, fine.first_image};
  return conjugate_gradients(system, max_steps, tolerance).steps;
}

template class Multigrid<1>;
template class Multigrid<3>;

}  // namespace orbicube::linear
