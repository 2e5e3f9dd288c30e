#include "linear/block_matrix.h"

#include <algorithm>

#include "base/grouping.h"

namespace orbicube::linear {
namespace {

// Rows between two reports: some milliseconds.
constexpr std::size_t slab = 16384;

}  // namespace

void make_rows(Array<std::pair<Index, Index>>& places, std::size_t rows, Array<Index>& begin, Array<Index>& columns) {
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  begin.assign(rows + 1, 0);
  columns.clear();
  for (const auto& [row, column] : places) {
    ++begin[row + 1];
    columns.push_back(column);
  }
  base::add_up_counts(std::span(begin));
}

template <int block>
void BlockMatrix<block>::multiply(std::span<const double> x, std::span<double> y, const base::Host& host) const {
  std::fill(y.begin(), y.end(), 0.0);
  for (std::size_t v = 0; v < rows(); ++v) {
    if (v % slab == 0) host.report("solve", 0, 0);
    const Eigen::Map<const Entry> here(&x[unknowns * v]);
    Entry sum = diagonal[v] * here;
    for (Index i = row_begin[v]; i < row_begin[v + 1]; ++i) {
      const std::size_t other = unknowns * static_cast<std::size_t>(column[i]);
      sum.noalias() += lower[i] * Eigen::Map<const Entry>(&x[other]);
      Eigen::Map<Entry>(&y[other]).noalias() += lower[i].transpose() * here;
    }
    Eigen::Map<Entry>(&y[unknowns * v]) += sum;
  }
  for (std::size_t s = 0; s < shared(); ++s) {
    const std::size_t at = unknowns * rows() + s;
    double sum = corner_diagonal[s] * x[at];
    for (Index i = border_begin[s]; i < border_begin[s + 1]; ++i) {
      const std::size_t other = unknowns * static_cast<std::size_t>(border_column[i]);
      sum += border[i].dot(Eigen::Map<const Entry>(&x[other]));
      Eigen::Map<Entry>(&y[other]) += x[at] * border[i];
    }
    for (Index i = corner_begin[s]; i < corner_begin[s + 1]; ++i) {
      const std::size_t other = unknowns * rows() + corner_column[i];
      sum += corner[i] * x[other];
      y[other] += corner[i] * x[at];
    }
    y[at] += sum;
  }
}

template struct BlockMatrix<1>;
template struct BlockMatrix<2>;
template struct BlockMatrix<3>;

}  // namespace orbicube::linear
