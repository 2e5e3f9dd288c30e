#include "correspondence/statistics/group_test.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "base/error.h"
#include "base/random.h"

namespace orbicube::correspondence {

namespace {

using Values = std::vector<double>;  // one a subject, their sum zero

constexpr std::size_t piece = 16;  // points that a thread takes at once
constexpr double ridge = 1e-12;    // of the trace, added to covariances: points that move in a plane only
constexpr double tie = 1 - 1e-10;  // a permutation with the same groups counts, whatever its rounding

// Returns the values as they are, and then permutations of them.
std::vector<Values> permuted(const Values& values, const GroupTestOptions& options) {
  std::vector<Values> result(options.permutations + 1, values);
  for (std::size_t k = 1; k < result.size(); ++k) {
    base::Random random(base::Random(options.seed + k).next());
    for (std::size_t i = result[k].size(); i > 1; --i)
      std::swap(result[k][i - 1], result[k][random.below(i)]);
  }
  return result;
}

// Returns the values minus their mean, divided by the largest, which goes to `scale`: no square of them overflows.
Values standardized(std::span<const double> values, double& scale) {
  const auto [low, high] = std::ranges::minmax(values);
  scale = high / 2 - low / 2;
  Values result;
  double sum = 0;
  for (const double value : values) {
    result.push_back((value / 2 - low / 2) / scale);
    sum += result.back();
  }
  for (double& value : result)
    value -= sum / static_cast<double>(values.size());
  return result;
}

// A point of all subjects, a column each: its coordinates, or one number along a direction.
template <int Rows>
using Samples = Eigen::Matrix<double, Rows, Eigen::Dynamic>;

// Returns the slope of the regression on values whose squares have this sum.
template <int Rows>
Eigen::Vector<double, Rows> slope_of(const Samples<Rows>& centered, const Values& values, double squares) {
  Eigen::Vector<double, Rows> sum = Eigen::Vector<double, Rows>::Zero();
  for (std::size_t i = 0; i < values.size(); ++i)
    sum += values[i] * centered.col(static_cast<Eigen::Index>(i));
  return sum / squares;
}

// Returns T2 for a slope d: the scatter of the residuals is the whole scatter minus squares d d'.
template <int Rows>
double hotelling(const Eigen::Matrix<double, Rows, Rows>& scatter, const Eigen::Vector<double, Rows>& d, double squares,
                 std::size_t subjects) {
  Eigen::Matrix<double, Rows, Rows> within = scatter - squares * d * d.transpose();
  const double trace = scatter.trace();
  if (!(trace > 0)) return 0;
  within.diagonal().array() += ridge * trace;
  return std::max(0.0, squares * static_cast<double>(subjects - 2) * d.dot(within.ldlt().solve(d)));
}

// What the tests of all points share.
struct Regression {
  const Population& subjects;
  std::span<const mesh::Vector3> directions;
  const std::vector<Values>& all_values;  // permuted; the first are as they are
  double squares = 0;                     // the sum of their squares
  double range = 1;                       // of the covariate, whose values go over a range of one here

  Eigen::Matrix3Xd positions(std::size_t v) const {
    return subjects.middleCols(static_cast<Eigen::Index>(3 * v), 3).transpose();
  }

  template <int Rows>
  Samples<Rows> samples(std::size_t v) const {
    if constexpr (Rows == 3)
      return positions(v);
    else
      return directions[v].transpose() * positions(v);
  }

  template <int Rows>
  Eigen::Vector3d in_space(std::size_t v, const Eigen::Vector<double, Rows>& d) const {
    if constexpr (Rows == 3)
      return d;
    else
      return d(0) * directions[v];
  }

  // Writes what belongs to point v but for its family-wise p-value; max_t2 has the maximum of each permutation so far.
  template <int Rows>
  void test_point(std::size_t v, GroupTest& result, std::vector<double>& max_t2) const {
    Samples<Rows> x = samples<Rows>(v);
    x.colwise() -= Eigen::Vector<double, Rows>(x.rowwise().mean());
    const Eigen::Matrix<double, Rows, Rows> scatter = x * x.transpose();
    std::size_t reached = 0;
    for (std::size_t k = 0; k < all_values.size(); ++k) {
      const Eigen::Vector<double, Rows> d = slope_of<Rows>(x, all_values[k], squares);
      const double t2 = hotelling<Rows>(scatter, d, squares, all_values[k].size());
      if (k == 0) {
        result.t2[v] = t2;
        Eigen::Vector3d::Map(&result.difference[3 * v]) = in_space<Rows>(v, d) / range;
      }
      max_t2[k] = std::max(max_t2[k], t2);
      if (t2 >= tie * result.t2[v]) ++reached;
    }
    result.p[v] = static_cast<double>(reached) / static_cast<double>(all_values.size());
  }
};

void require_groups(const Population& subjects, std::span<const std::uint8_t> group) {
  const auto ones = static_cast<std::size_t>(std::ranges::count_if(group, [](std::uint8_t g) { return g != 0; }));
  if (group.size() != static_cast<std::size_t>(subjects.rows()))
    throw base::Error("invalid-argument", "there is not one group a subject");
  if (ones < 2 || group.size() - ones < 2 || group.size() < 5)
    throw base::Error("invalid-argument", "a test of two groups needs two subjects in each and five together");
}

void require_values(const Population& subjects, std::span<const double> values) {
  if (values.size() != static_cast<std::size_t>(subjects.rows()))
    throw base::Error("invalid-argument", "there is not one value a subject");
  if (values.size() < 5) throw base::Error("invalid-argument", "a regression needs five subjects or more");
  if (subjects.cols() % 3 != 0) throw base::Error("invalid-argument", "coordinates are not three a point");
  if (!subjects.allFinite()) throw base::Error("invalid-argument", "a coordinate of a subject is not finite");
  if (!std::ranges::all_of(values, [](double value) { return std::isfinite(value); }))
    throw base::Error("invalid-argument", "a value of a subject is not finite");
  const auto [low, high] = std::ranges::minmax(values);
  if (!(high / 2 - low / 2 > std::numeric_limits<double>::min()))
    throw base::Error("invalid-argument", "all subjects have the same value");
}

}  // namespace

std::vector<double> false_discovery_rates(std::span<const double> p) {
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return p[a] < p[b]; });
  std::vector<double> q(p.size());
  double least = 1;
  for (std::size_t k = order.size(); k-- > 0;) {
    least = std::min(least, p[order[k]] * static_cast<double>(p.size()) / static_cast<double>(k + 1));
    q[order[k]] = least;
  }
  return q;
}

GroupTest compare_groups(const Population& subjects, std::span<const std::uint8_t> group,
                         const GroupTestOptions& options, const base::Host& host) {
  require_groups(subjects, group);
  std::vector<double> values;
  for (const std::uint8_t g : group)
    values.push_back(g != 0 ? 1 : 0);
  return regress(subjects, values, options, host);
}

GroupTest regress(const Population& subjects, std::span<const double> covariate, const GroupTestOptions& options,
                  const base::Host& host) {
  require_values(subjects, covariate);
  if (!options.directions.empty() && 3 * options.directions.size() != static_cast<std::size_t>(subjects.cols()))
    throw base::Error("invalid-argument", "there is not one direction a point");
  double scale = 1;
  const Values values = standardized(covariate, scale);
  double squares = 0;
  for (const double value : values)
    squares += value * value;
  const std::vector<Values> all_values = permuted(values, options);
  const auto points = static_cast<std::size_t>(subjects.cols() / 3);
  GroupTest result;
  result.t2.resize(points);
  result.p.resize(points);
  result.p_family_wise.resize(points);
  result.difference.resize(3 * points);
  const std::size_t pieces = (points + piece - 1) / piece;
  std::vector<std::vector<double>> max_of_piece(pieces, std::vector<double>(all_values.size(), 0.0));
  const Regression regression{subjects, options.directions, all_values, squares, 2 * scale};
  const auto test_point = [&](std::size_t v, std::vector<double>& max_t2) {
    if (options.directions.empty())
      regression.test_point<3>(v, result, max_t2);
    else
      regression.test_point<1>(v, result, max_t2);
  };
  // Blocks of pieces between reports.
  constexpr std::size_t block = 8;
  for (std::size_t first = 0; first < pieces; first += block) {
    host.report("group test", first, pieces);
    host.parallel_for(std::min(block, pieces - first), [&](std::size_t i) {
      const std::size_t begin = (first + i) * piece;
      for (std::size_t v = begin; v < std::min(points, begin + piece); ++v)
        test_point(v, max_of_piece[first + i]);
    });
  }
  std::vector<double> max_t2(all_values.size(), 0.0);
  for (const std::vector<double>& of_piece : max_of_piece)
    for (std::size_t k = 0; k < max_t2.size(); ++k)
      max_t2[k] = std::max(max_t2[k], of_piece[k]);
  for (std::size_t v = 0; v < points; ++v) {
    const auto reached = std::ranges::count_if(max_t2, [&](double t2) { return t2 >= tie * result.t2[v]; });
    result.p_family_wise[v] = static_cast<double>(reached) / static_cast<double>(all_values.size());
  }
  result.q = false_discovery_rates(result.p);
  return result;
}

}  // namespace orbicube::correspondence
