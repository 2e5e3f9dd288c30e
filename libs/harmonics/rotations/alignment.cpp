#include "harmonics/rotations/alignment.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/sums.h"
#include "harmonics/rotations/correlation_search.h"
#include "harmonics/rotations/generators.h"

namespace orbicube::harmonics {
namespace {

using Vector3 = Eigen::Vector3d;

// Degrees 1 to `degree`, the others left out.
Coefficients without_mean(const Coefficients& f, std::uint32_t degree, std::pmr::memory_resource* memory) {
  Coefficients cut(degree, f.channels, memory);
  std::copy_n(f.values.begin() + static_cast<std::ptrdiff_t>(f.channels), cut.values.size() - f.channels,
              cut.values.begin() + static_cast<std::ptrdiff_t>(f.channels));
  return cut;
}

double inner_product(const Coefficients& a, const Coefficients& b) {
  return base::dot(a.values, b.values);
}

Matrix3 small_rotation(const Vector3& w) {
  const double angle = w.norm();
  return angle > 0 ? Eigen::AngleAxisd(angle, w / angle).toRotationMatrix() : Matrix3::Identity();
}

// d/dt of the values turned by exp(t [a]).
Coefficients turn_slope(const Coefficients& g, const Vector3& axis) {
  Coefficients slope = g.copy();
  for (std::size_t k = 0; k < g.values.size(); k += 3) {
    Eigen::Map<Vector3>(slope.values.data() + k) = axis.cross(Eigen::Map<const Vector3>(g.values.data() + k));
  }
  return slope;
}

// sum over i, j of <f_i, g_j>, the matrix that the best turn of the values follows from.
Matrix3 value_products(const Coefficients& f, const Coefficients& g) {
  Matrix3 sum = Matrix3::Zero();
  for (std::size_t k = 0; k < f.values.size(); k += 3) {
    sum += Eigen::Map<const Vector3>(f.values.data() + k) * Eigen::Map<const Vector3>(g.values.data() + k).transpose();
  }
  return sum;
}

struct Place {
  Matrix3 rotation, values;
  double sum = 0;
};

// One pair of functions at one degree, and the climb to the nearest maximum.
class Climb {
 public:
  Climb(const Coefficients& f, const Coefficients& g, bool turn_values, const base::Host& host)
      : f_(f), g_(g), turn_values_(turn_values), host_(host), f_slopes_(slopes(f)) {}

  // Newton's method for the maximum. Far from it, directions in which the sum bends the wrong way are followed uphill.
  void run(Place& place) const {
    constexpr int max_steps = 50;
    constexpr double longest = 0.15;  // radians
    Coefficients h = turned(place.rotation, place.values);
    place.sum = inner_product(f_, h);
    for (int step = 0; step < max_steps; ++step) {
      const Eigen::VectorXd direction = newton_direction(h, longest);
      const double length = direction.norm();
      if (!(length > 0)) return;
      bool better = false;
      // Where the sum no longer resolves the step, Newton's own convergence is trusted.
      constexpr double unresolved = 1e-6;
      for (double share = 1; share > 1e-3 && !better; share /= 2) {
        const Matrix3 rotation = small_rotation(share * direction.head<3>()) * place.rotation;
        const Matrix3 values =
            turn_values_ ? Matrix3(small_rotation(share * direction.tail<3>()) * place.values) : place.values;
        Coefficients there = turned(rotation, values);
        const double sum = inner_product(f_, there);
        better = sum > place.sum || length < unresolved;
        if (!better) continue;
        place = {orthogonal(rotation), orthogonal(values), sum};
        h = std::move(there);
      }
      constexpr double rounding = 1e-14;
      if (!better || length < rounding) return;
    }
  }

 private:
  static Matrix3 orthogonal(const Matrix3& r) { return Eigen::Quaterniond(r).normalized().toRotationMatrix(); }

  Coefficients turned(const Matrix3& rotation, const Matrix3& values) const {
    Coefficients h = rotate(g_, rotation, host_);
    if (turn_values_) rotate_values(h, values);
    return h;
  }

  // The slopes of a function along the three rotations of the sphere and, with turned values, those of the values.
  std::vector<Coefficients> slopes(const Coefficients& f) const {
    std::vector<Coefficients> all;
    for (Coefficients& x : generators(f))
      all.push_back(std::move(x));
    for (int axis = 0; turn_values_ && axis < 3; ++axis)
      all.push_back(turn_slope(f, Vector3::Unit(axis)));
    return all;
  }

  Eigen::VectorXd newton_direction(const Coefficients& h, double longest) const {
    const std::vector<Coefficients> h_slopes = slopes(h);
    const auto n = static_cast<Eigen::Index>(h_slopes.size());
    Eigen::VectorXd gradient(n);
    Eigen::MatrixXd bend(n, n);  // minus the second derivatives: <f, X Y h> = -<X f, Y h>
    for (Eigen::Index i = 0; i < n; ++i) {
      gradient[i] = inner_product(f_, h_slopes[static_cast<std::size_t>(i)]);
      for (Eigen::Index j = 0; j < n; ++j)
        bend(i, j) = inner_product(f_slopes_[static_cast<std::size_t>(i)], h_slopes[static_cast<std::size_t>(j)]);
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(0.5 * (bend + bend.transpose()));
    const double floor = 1e-10 * eigen.eigenvalues().cwiseAbs().maxCoeff();
    const Eigen::VectorXd along = eigen.eigenvectors().transpose() * gradient;
    Eigen::VectorXd direction = Eigen::VectorXd::Zero(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const double curvature = std::abs(eigen.eigenvalues()[i]);
      // A symmetry of the functions leaves a direction flat: there is nothing to be gained along it.
      if (curvature > floor) direction += along[i] / curvature * eigen.eigenvectors().col(i);
    }
    const double length = direction.norm();
    return length > longest ? Eigen::VectorXd(longest / length * direction) : direction;
  }

  const Coefficients& f_;
  const Coefficients& g_;
  bool turn_values_;
  const base::Host& host_;
  std::vector<Coefficients> f_slopes_;
};

// Moves the place that turns the values least, among those about as good as the best, to number `kept` - 1 at the
// latest. Places are in falling order. Another pose counts as about as good while it lacks no more than half as much
// again of a correlation of 1, and a little for maps of two copies that were found apart from each other.
void bring_standing_forward(std::vector<Place>& places, std::size_t kept, double lengths) {
  constexpr double share = 1.5, little = 1e-4;
  const double lacking = 1 - places.front().sum / lengths;
  std::size_t best = 0;
  for (std::size_t k = 1; k < places.size(); ++k) {
    constexpr double same = 1e-6;  // of a trace: turned alike but for rounding
    if (1 - places[k].sum / lengths <= share * lacking + little &&
        places[k].values.trace() > places[best].values.trace() + same)
      best = k;
  }
  if (best < kept) return;
  const auto from = places.begin() + static_cast<std::ptrdiff_t>(best);
  std::rotate(places.begin() + static_cast<std::ptrdiff_t>(kept - 1), from, from + 1);
}

}  // namespace

Alignment align(const Coefficients& fixed, const Coefficients& moving, const AlignmentOptions& options,
                const base::Host& host) {
  const auto wrong = [](const char* text) -> base::Error { return {"invalid-argument", text}; };
  if (fixed.channels == 0 || fixed.channels != moving.channels)
    throw wrong("the two have different numbers of functions");
  if (options.turn_values && fixed.channels != 3) throw wrong("only three functions can be turned as coordinates");
  if (options.search_degree == 0 || options.search_degree > 64) throw wrong("search_degree is not from 1 to 64");
  for (const Coefficients* given : {&fixed, &moving}) {
    for (const double value : given->values) {
      if (!std::isfinite(value)) throw wrong("a coefficient is not finite");
    }
  }
  const std::uint32_t degree = std::min(fixed.degree, moving.degree);
  const auto length_of = [&](const Coefficients& all) {
    const Coefficients cut = without_mean(all, all.degree, host.memory);
    return std::sqrt(inner_product(cut, cut));
  };
  const double lengths = length_of(fixed) * length_of(moving);
  if (degree == 0 || !(lengths > 0))
    throw base::Error("no-valid-result", "functions that are constant look the same under every rotation");

  // From the peaks of the grid, each followed to its maximum at the degree of the grid; the best few of them then at
  // twice that degree, and so on: maxima are as narrow as the finest detail.
  constexpr std::size_t starts = 12, followed = 4;
  std::uint32_t used = std::min(degree, options.search_degree);
  std::vector<Place> places;
  for (const CorrelationPeak& peak : correlation_peaks(fixed, moving, used, options.turn_values, starts, host)) {
    Place place{peak.rotation, Matrix3::Identity(), 0};
    if (options.turn_values) {
      const Coefficients f = without_mean(fixed, used, host.memory),
                         h = rotate(without_mean(moving, used, host.memory), place.rotation, host);
      place.values = best_rotation(value_products(f, h), place.sum);
    }
    places.push_back(place);
  }
  if (options.turn_values && options.prefer_standing) {
    constexpr std::size_t standing_starts = 4;
    for (const CorrelationPeak& peak : correlation_peaks(fixed, moving, used, false, standing_starts, host))
      places.push_back({peak.rotation, Matrix3::Identity(), 0});
  }
  for (;;) {
    const Coefficients f = without_mean(fixed, used, host.memory), g = without_mean(moving, used, host.memory);
    const Climb climb(f, g, options.turn_values, host);
    for (std::size_t k = 0; k < places.size(); ++k) {
      host.report("refining the rotation", k, places.size());
      climb.run(places[k]);
    }
    std::stable_sort(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.sum > b.sum; });
    if (used == degree) break;
    if (options.prefer_standing) bring_standing_forward(places, followed, lengths);
    if (places.size() > followed) places.resize(followed);
    used = std::min(degree, 2 * used);
  }
  if (options.prefer_standing) bring_standing_forward(places, 1, lengths);
  return {places.front().rotation, places.front().values, places.front().sum / lengths};
}

}  // namespace orbicube::harmonics
