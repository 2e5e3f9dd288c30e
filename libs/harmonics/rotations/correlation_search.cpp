#include "harmonics/rotations/correlation_search.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "harmonics/rotations/wigner.h"

namespace orbicube::harmonics {
namespace {

// With R = Rz(alpha) Ry(beta) Rz(gamma) and the waves w = (1, cos t, sin t, cos 2t, ...), the correlation at one beta
// is w(alpha)' X w(gamma): X sums the products of coefficients with the elements of the rotation about y over the
// degrees.
class AtOneBeta {
 public:
  AtOneBeta(double beta, std::uint32_t degree) : degree_(degree) {
    const std::size_t pairs = (degree + std::size_t{1}) * (degree + 1);
    even_.resize(pairs * (degree + 1));
    odd_.resize(pairs * (degree + 1));
    for (std::uint32_t m = 0; m <= degree; ++m) {
      for (std::uint32_t n = 0; n <= m; ++n)
        rotation_about_y(beta, m, n, degree, &even_[at(m, n) + m], &odd_[at(m, n) + m]);
    }
  }

  // X for channel i of f and channel j of g, added to what is there.
  void add(const Coefficients& f, std::size_t i, const Coefficients& g, std::size_t j, Eigen::MatrixXd& x) const {
    for (std::uint32_t m = 0; m <= degree_; ++m) {
      for (std::uint32_t n = 0; n <= degree_; ++n) {
        const std::size_t place = m >= n ? at(m, n) : at(n, m);
        const double sign = m >= n || (m + n) % 2 == 0 ? 1 : -1;
        const auto a = static_cast<std::int32_t>(m), b = static_cast<std::int32_t>(n);
        // Cosine and sine of f with cosine and sine of g, by the elements between cosines and between sines.
        double cc = 0, cs = 0, sc = 0, ss = 0;
        for (std::uint32_t l = std::max({m, n, 1U}); l <= degree_; ++l) {
          const double e = sign * even_[place + l], o = sign * odd_[place + l];
          const double fc = f.at(l, a, i), fs = m > 0 ? f.at(l, -a, i) : 0;
          const double gc = g.at(l, b, j), gs = n > 0 ? g.at(l, -b, j) : 0;
          cc += e * fc * gc + o * fs * gs;
          cs += o * fs * gc - e * fc * gs;
          sc += e * fs * gc - o * fc * gs;
          ss -= e * fs * gs + o * fc * gc;
        }
        const Eigen::Index row = m > 0 ? 2 * static_cast<Eigen::Index>(m) - 1 : 0,
                           column = n > 0 ? 2 * static_cast<Eigen::Index>(n) - 1 : 0;
        x(row, column) += cc;
        if (n > 0) x(row, column + 1) += cs;
        if (m > 0) x(row + 1, column) += sc;
        if (m > 0 && n > 0) x(row + 1, column + 1) += ss;
      }
    }
  }

 private:
  std::size_t at(std::uint32_t m, std::uint32_t n) const {
    return (m * (degree_ + std::size_t{1}) + n) * (degree_ + std::size_t{1});
  }

  std::uint32_t degree_;
  std::vector<double> even_, odd_;  // by m, n <= m and l
};

Matrix3 euler(double alpha, double beta, double gamma) {
  using Eigen::AngleAxisd, Eigen::Vector3d;
  return (AngleAxisd(alpha, Vector3d::UnitZ()) * AngleAxisd(beta, Vector3d::UnitY()) *
          AngleAxisd(gamma, Vector3d::UnitZ()))
      .toRotationMatrix();
}

double angle_between(const Matrix3& a, const Matrix3& b) {
  return std::acos(std::clamp(0.5 * (a.transpose() * b).trace() - 0.5, -1.0, 1.0));
}

}  // namespace

Matrix3 best_rotation(const Matrix3& m, double& sum) {
  // Horn 1987, "Closed-form solution of absolute orientation using unit quaternions": the sum is a quadratic form of
  // the quaternion.
  Eigen::Matrix4d form;
  form << m(0, 0) + m(1, 1) + m(2, 2), m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1),  //
      m(2, 1) - m(1, 2), m(0, 0) - m(1, 1) - m(2, 2), m(0, 1) + m(1, 0), m(0, 2) + m(2, 0),      //
      m(0, 2) - m(2, 0), m(0, 1) + m(1, 0), m(1, 1) - m(0, 0) - m(2, 2), m(1, 2) + m(2, 1),      //
      m(1, 0) - m(0, 1), m(0, 2) + m(2, 0), m(1, 2) + m(2, 1), m(2, 2) - m(0, 0) - m(1, 1);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> eigen(form);
  sum = eigen.eigenvalues()[3];
  const Eigen::Vector4d q = eigen.eigenvectors().col(3);
  return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
}

namespace {

constexpr auto better = [](const CorrelationPeak& a, const CorrelationPeak& b) { return a.value > b.value; };

// Cosines and sines of all orders at the angles of one turn, `step` apart.
Eigen::MatrixXd waves_of(std::uint32_t degree, double step) {
  const auto top = static_cast<Eigen::Index>(degree);
  Eigen::MatrixXd waves(2 * top + 1, 4 * top);
  for (Eigen::Index k = 0; k < waves.cols(); ++k) {
    waves(0, k) = 1;
    for (Eigen::Index m = 1; m <= top; ++m) {
      waves(2 * m - 1, k) = std::cos(static_cast<double>(m * k) * step);
      waves(2 * m, k) = std::sin(static_cast<double>(m * k) * step);
    }
  }
  return waves;
}

// Correlations at all alpha and gamma: the sum of all channels, or with turn_values of each pair of coordinates.
std::vector<Eigen::MatrixXd> grids_at(const Coefficients& f, const Coefficients& g, const AtOneBeta& elements,
                                      bool turn_values, const Eigen::MatrixXd& waves) {
  std::vector<Eigen::MatrixXd> grids;
  const auto add_grid = [&](const Eigen::MatrixXd& x) { grids.emplace_back(waves.transpose() * (x * waves)); };
  if (turn_values) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        Eigen::MatrixXd x = Eigen::MatrixXd::Zero(waves.rows(), waves.rows());
        elements.add(f, i, g, j, x);
        add_grid(x);
      }
    }
  } else {
    Eigen::MatrixXd x = Eigen::MatrixXd::Zero(waves.rows(), waves.rows());
    for (std::size_t c = 0; c < f.channels; ++c)
      elements.add(f, c, g, c, x);
    add_grid(x);
  }
  return grids;
}

// The best rotations of one beta.
std::vector<CorrelationPeak> peaks_at(double beta, double step, const std::vector<Eigen::MatrixXd>& grids) {
  constexpr std::size_t max_peaks = 64;
  std::vector<CorrelationPeak> all;
  for (Eigen::Index p = 0; p < grids[0].rows(); ++p) {
    for (Eigen::Index q = 0; q < grids[0].cols(); ++q) {
      double value = grids[0](p, q);
      if (grids.size() > 1) {
        Matrix3 m;
        for (Eigen::Index k = 0; k < 9; ++k)
          m(k / 3, k % 3) = grids[static_cast<std::size_t>(k)](p, q);
        best_rotation(m, value);
      }
      all.push_back({euler(static_cast<double>(p) * step, beta, static_cast<double>(q) * step), value});
    }
  }
  const std::size_t kept = std::min(all.size(), max_peaks);
  std::partial_sort(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(kept), all.end(), better);
  all.resize(kept);
  return all;
}

}  // namespace

std::vector<CorrelationPeak> correlation_peaks(const Coefficients& f, const Coefficients& g, std::uint32_t degree,
                                               bool turn_values, std::size_t most, const base::Host& host) {
  const std::size_t betas = 2 * std::size_t{degree};
  const double step = std::numbers::pi / static_cast<double>(betas);
  const Eigen::MatrixXd waves = waves_of(degree, step);
  // The best of each beta; then of all.
  std::vector<std::vector<CorrelationPeak>> best(betas);
  const auto search = [&](std::size_t b) {
    const double beta = (static_cast<double>(b) + 0.5) * step;
    best[b] = peaks_at(beta, step, grids_at(f, g, AtOneBeta(beta, degree), turn_values, waves));
  };
  constexpr std::size_t wave = 2;
  for (std::size_t b = 0; b < betas; b += wave) {
    host.report("searching rotations", b, betas);
    host.parallel_for(std::min(wave, betas - b), [&](std::size_t k) { search(b + k); });
  }
  std::vector<CorrelationPeak> all, peaks;
  for (const std::vector<CorrelationPeak>& some : best)
    all.insert(all.end(), some.begin(), some.end());
  std::stable_sort(all.begin(), all.end(), better);
  for (const CorrelationPeak& candidate : all) {
    if (peaks.size() == most) break;
    const bool near = std::any_of(peaks.begin(), peaks.end(), [&](const CorrelationPeak& peak) {
      return angle_between(peak.rotation, candidate.rotation) < 2 * step;
    });
    if (!near) peaks.push_back(candidate);
  }
  return peaks;
}

}  // namespace orbicube::harmonics
