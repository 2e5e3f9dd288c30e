#include "hexmesh/strategies/refinement.h"

#include <algorithm>
#include <cmath>

namespace orbicube::hexmesh {
namespace {

// Distances fall by no more than the square of the length of cells: chords of a curved surface do. Minimum number of
// cells needed, over that of a mesh with excess e: e to the power of this. Larger: cells are wasted; smaller: meshes
// are.
constexpr double fastest = 1.5;
// Maximum number of doublings at once: where distances begin to fall faster than that, a mesh of many cells was not
// needed.
constexpr int max_doublings = 3;
// Where the last meshes had distances that fell so slowly that this multiple of the maximum number of cells would be
// needed, no more are tried. Estimates from two meshes are rough, and a protrusion may be met all at once.
constexpr double hopeless = 8;
constexpr int max_slow = 2;  // times in a row

}  // namespace

bool Refinement::next(double excess, double nearest) {
  if (excess > 1 && excess_before_ > 1) {
    const double more = std::log(static_cast<double>(cells_) / static_cast<double>(cells_before_));
    const double rate = std::log(excess_before_ / excess) / more;
    const double room = std::log(hopeless * static_cast<double>(max_cells_) / static_cast<double>(cells_));
    slow_ = rate * room < std::log(excess) ? slow_ + 1 : 0;
    if (slow_ == max_slow) return false;
  }
  excess_before_ = excess;
  cells_before_ = cells_;
  int doublings = nearest > 1 ? std::clamp(static_cast<int>(fastest * std::log2(nearest)), 1, max_doublings) : 1;
  while (doublings > 1 && cells_ > max_cells_ >> doublings)
    --doublings;
  if (cells_ > max_cells_ >> doublings) return false;
  cells_ <<= doublings;
  return true;
}

bool may_be_near(const std::pair<std::size_t, double>& before, std::size_t cells) {
  const auto& [cells_before, excess] = before;
  return std::pow(excess, fastest) * static_cast<double>(cells_before) <= static_cast<double>(cells);
}

}  // namespace orbicube::hexmesh
