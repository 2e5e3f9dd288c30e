#include "correspondence/statistics/outliers.h"

#include <algorithm>
#include <cmath>

namespace orbicube::correspondence {

namespace {

constexpr double normal_deviations =
    1.4826;                             // standard deviations of a normal variable in its median absolute deviation
constexpr double max_deviations = 3.5;  // smaller: more outliers
constexpr double rounding = 1e-9;       // of the median: distances that differ by less are equal

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return *std::max_element(values.begin(), middle) / 2 + *middle / 2;
}

}  // namespace

std::vector<double> distances_from_mean(const Population& subjects, const Eigen::VectorXd& mean) {
  std::vector<double> distances;
  for (Eigen::Index i = 0; i < subjects.rows(); ++i) {
    const double squares = (subjects.row(i).transpose() - mean).squaredNorm();
    distances.push_back(std::sqrt(3 * squares / static_cast<double>(subjects.cols())));
  }
  return distances;
}

std::vector<std::uint8_t> outliers(std::span<const double> distances) {
  std::vector<std::uint8_t> result(distances.size(), 0);
  if (distances.size() < 5) return result;
  const std::vector<double> values(distances.begin(), distances.end());
  const double middle = median(values);
  std::vector<double> deviations;
  for (const double value : values)
    deviations.push_back(std::abs(value - middle));
  const double limit = std::max(max_deviations * normal_deviations * median(deviations), rounding * middle);
  for (std::size_t i = 0; i < values.size(); ++i)
    result[i] = values[i] - middle > limit ? 1 : 0;
  return result;
}

}  // namespace orbicube::correspondence
