#include "frame_field/smoothing/harmonic_frame.h"

#include <algorithm>
#include <numbers>

namespace orbicube::frame_field {
namespace {

using quaternion::multiply;
using quaternion::normalized;

// Lengths of the harmonics in Racah's scaling, by order.
// Lengths of the harmonics in Racah's scaling, by order: sqrt 10 / 4, sqrt 5 / 4, sqrt 70 / 4, sqrt 35 / 8.
constexpr double scale1 = 0.79056941504209483300, scale2 = 0.55901699437494742410, scale3 = 2.09165006633518886995,
                 scale4 = 0.73950997288745200532;
// 1 / |S(x) + S(y) + S(z)| for three orthogonal directions, by the addition theorem (3 + 6 P4(0))^-1/2.
constexpr double frame_scale = 0.43643578047198476253;

std::array<Vector, 3> axes_of(const Quaternion& q) {
  return {quaternion::rotate(q, {1, 0, 0}), quaternion::rotate(q, {0, 1, 0}), quaternion::rotate(q, {0, 0, 1})};
}

double dot(const Vector& a, const Vector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

// The quartic form sum a_m S_m near a frame: its value, and how it changes with rotations about the frame's own axes.
struct Expansion {
  double value;
  std::array<double, 3> gradient;
  std::array<double, 6> hessian;  // xx yy zz xy xz yz
};

// All of it from t[k][j] = T(k, k, k, j) in the frame's axes, since the tensor T has no trace.
Expansion expand(const Harmonic& a, const Quaternion& frame) {
  const auto axis = axes_of(frame);
  double t[3][3];
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector g = quartic_gradient(a, axis[k]);
    for (std::size_t j = 0; j < 3; ++j)
      t[k][j] = dot(axis[j], g);
  }
  return {t[0][0] + t[1][1] + t[2][2],
          {4 * (t[1][2] - t[2][1]), 4 * (t[2][0] - t[0][2]), 4 * (t[0][1] - t[1][0])},
          {12 * t[0][0] - 16 * (t[1][1] + t[2][2]), 12 * t[1][1] - 16 * (t[2][2] + t[0][0]),
           12 * t[2][2] - 16 * (t[0][0] + t[1][1]), 14 * (t[0][1] + t[1][0]), 14 * (t[0][2] + t[2][0]),
           14 * (t[1][2] + t[2][1])}};
}

// The solution of (shift - H) x = g by Cholesky's method; false when that matrix is not safely positive.
bool solve_positive(const std::array<double, 6>& h, double shift, const std::array<double, 3>& g,
                    std::array<double, 3>& x) {
  const double a = shift - h[0];
  const double small = 1e-3 * std::abs(shift + std::abs(h[0]) + std::abs(h[1]) + std::abs(h[2]));
  if (!(a > small)) return false;
  const double l10 = -h[3] / a, l20 = -h[4] / a;
  const double b = shift - h[1] - l10 * l10 * a;
  if (!(b > small)) return false;
  const double l21 = (-h[5] - l20 * l10 * a) / b;
  const double c = shift - h[2] - l20 * l20 * a - l21 * l21 * b;
  if (!(c > small)) return false;
  const double y1 = g[1] - l10 * g[0], y2 = g[2] - l20 * g[0] - l21 * y1;
  x[2] = y2 / c;
  x[1] = y1 / b - l21 * x[2];
  x[0] = g[0] / a - l10 * x[1] - l20 * x[2];
  return true;
}

// Starts for climbing: spread over all frames by farthest-point choice from a spiral of rotations (Alexa 2022,
// "Super-Fibonacci spirals").
struct Starts {
  static constexpr std::size_t count = 60;
  std::array<Quaternion, count> frame;
  std::array<Harmonic, count> harmonic;

  Starts() {
    constexpr std::size_t candidates = 4000;
    static_assert(candidates > count);
    const double phi = std::numbers::sqrt2, psi = 1.533751168755204288118041;
    std::array<double, candidates> square{};  // distance from those chosen so far
    square.fill(2);
    const auto candidate = [&](std::size_t i) {
      const double s = static_cast<double>(i) + 0.5, t = s / candidates, d = 2 * std::numbers::pi * s;
      const double r = std::sqrt(t), big = std::sqrt(1 - t), alpha = d / phi, beta = d / psi;
      return normalized({r * std::sin(alpha), r * std::cos(alpha), big * std::sin(beta), big * std::cos(beta)});
    };
    Quaternion chosen{1, 0, 0, 0};
    for (std::size_t k = 0; k < count; ++k) {
      frame[k] = chosen;
      harmonic[k] = harmonic_of(chosen);
      std::size_t farthest = 0;
      for (std::size_t i = 0; i < candidates; ++i) {
        square[i] = std::min(square[i], quaternion::symmetric_sine_square(chosen, candidate(i)));
        if (square[i] > square[farthest]) farthest = i;
      }
      chosen = candidate(farthest);
    }
  }
};

const Starts& starts() {
  static const Starts table;
  return table;
}

}  // namespace

Harmonic harmonics_at(const Vector& v) {
  const double xx = v.x * v.x, yy = v.y * v.y, zz = v.z * v.z, round = xx + yy;
  const double xy = v.x * v.y, xz = v.x * v.z, yz = v.y * v.z;
  return {4 * scale4 * xy * (xx - yy),
          scale3 * yz * (3 * xx - yy),
          2 * scale2 * xy * (6 * zz - round),
          scale1 * yz * (4 * zz - 3 * round),
          zz * zz - 3 * zz * round + 0.375 * (round * round),
          scale1 * xz * (4 * zz - 3 * round),
          scale2 * (xx - yy) * (6 * zz - round),
          scale3 * xz * (xx - 3 * yy),
          scale4 * (xx * xx - 6 * xx * yy + yy * yy)};
}

Harmonic harmonic_of(const Quaternion& frame) {
  const auto axis = axes_of(frame);
  const Harmonic x = harmonics_at(axis[0]), y = harmonics_at(axis[1]), z = harmonics_at(axis[2]);
  Harmonic sum;
  for (std::size_t k = 0; k < 9; ++k)
    sum[k] = frame_scale * (x[k] + y[k] + z[k]);
  return sum;
}

Vector quartic_gradient(const Harmonic& a, const Vector& v) {
  const double x = v.x, y = v.y, z = v.z;
  const double xx = x * x, yy = y * y, zz = z * z, round = xx + yy;
  const double a4 = 4 * scale4 * a[0], b4 = scale4 * a[8], a3 = scale3 * a[1], b3 = scale3 * a[7];
  const double a2 = 2 * scale2 * a[2], b2 = scale2 * a[6], a1 = scale1 * a[3], b1 = scale1 * a[5], c = a[4];
  const double cubic3 = 3 * xx - yy, cubic3_too = xx - 3 * yy, bow = 4 * zz - 3 * round, ring = 6 * zz - round;
  const double twelve = 12 * zz - 3 * round;
  const double gx = a4 * y * (3 * xx - yy) + 4 * b4 * x * cubic3_too + a3 * 6 * x * y * z + b3 * 3 * z * (xx - yy) +
                    a2 * y * (ring - 2 * xx) + b2 * 2 * x * (ring - (xx - yy)) - a1 * 6 * x * y * z +
                    b1 * z * (bow - 6 * xx) + c * x * (1.5 * round - 6 * zz);
  const double gy = a4 * x * (xx - 3 * yy) - 4 * b4 * y * cubic3 + a3 * 3 * z * (xx - yy) - b3 * 6 * x * y * z +
                    a2 * x * (ring - 2 * yy) - b2 * 2 * y * (ring + (xx - yy)) + a1 * z * (bow - 6 * yy) -
                    b1 * 6 * x * y * z + c * y * (1.5 * round - 6 * zz);
  const double gz = a3 * y * cubic3 + b3 * x * cubic3_too + 12 * z * (a2 * x * y + b2 * (xx - yy)) +
                    (a1 * y + b1 * x) * twelve + c * z * (4 * zz - 6 * round);
  return {0.25 * gx, 0.25 * gy, 0.25 * gz};
}

Quaternion climb_to_frame(const Harmonic& a, const Quaternion& start) {
  constexpr int max_steps = 50;
  constexpr double certain = 1e-3;  // Newton's steps that short go up, whatever rounding makes of the values
  Quaternion q = start;
  Expansion here = expand(a, q);
  for (int step = 0; step < max_steps; ++step) {
    const auto& g = here.gradient;
    const double size = std::abs(here.hessian[0]) + std::abs(here.hessian[1]) + std::abs(here.hessian[2]);
    const double slope = std::sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
    if (!(slope > 1e-12 * size)) break;
    double shift = 0;
    std::array<double, 3> turn{};
    while (!solve_positive(here.hessian, shift, g, turn))
      shift = std::max(2 * shift, 0.5 * size);
    const double angle = std::sqrt(turn[0] * turn[0] + turn[1] * turn[1] + turn[2] * turn[2]);
    const bool trusted = shift == 0 && angle < certain;
    double length = angle > 0.5 ? 0.5 / angle : 1.0;
    bool taken = false;
    for (int cut = 0; cut < 8 && !taken; ++cut, length *= 0.4) {
      const double half = 0.5 * length;
      const Quaternion next = normalized(multiply(q, {1, half * turn[0], half * turn[1], half * turn[2]}));
      const Expansion there = expand(a, next);
      taken = trusted || there.value > here.value;
      if (!taken) continue;
      q = next;
      here = there;
    }
    if (!taken || (trusted && angle < certain * certain)) break;  // the error is the square of that by now
  }
  return q;
}

Quaternion nearest_frame(const Harmonic& a, const Quaternion& guess) {
  // A maximum has a start at most some 17 degrees away, where the value is lower by at most a third; and frames whose
  // coefficients are as near as this to those of a maximum lie about the same one
  // (tests/frame_field/harmonic_frame_test.cpp tries both).
  constexpr double part_at_start = 0.65, part_nearby = 0.6;
  const Starts& table = starts();
  Quaternion best = climb_to_frame(a, guess);
  // The maxima that were found; a few more than most vectors have.
  std::array<Harmonic, 12> maxima;
  maxima[0] = harmonic_of(best);
  std::size_t found = 1;
  double value = dot(a, maxima[0]);
  // With `rest` the part of a that is orthogonal to the coefficients m of this maximum, a frame whose coefficients have
  // the product c with m has the value of at most c value + sqrt(1 - c^2) |rest|. Where c is at most part_nearby, that
  // is below `value`.
  constexpr double certain = (1 - part_nearby) / (1 + part_nearby);
  const double rest = dot(a, a) - value * value;
  if (value > 0 && rest < certain * value * value) return best;
  for (std::size_t k = 0; k < Starts::count; ++k) {
    const Harmonic& start = table.harmonic[k];
    if (dot(a, start) < part_at_start * value) continue;
    const auto near = [&](const Harmonic& m) { return dot(m, start) > part_nearby; };
    if (std::any_of(maxima.begin(), maxima.begin() + found, near)) continue;
    const Quaternion frame = climb_to_frame(a, table.frame[k]);
    const Harmonic there = harmonic_of(frame);
    if (found < maxima.size()) maxima[found++] = there;
    const double height = dot(a, there);
    if (height <= value) continue;
    value = height;
    best = frame;
  }
  return best;
}

Quaternion nearest_frame(const Harmonic& a) {
  const Starts& table = starts();
  std::size_t best = 0;
  double highest = -HUGE_VAL;
  for (std::size_t k = 0; k < Starts::count; ++k) {
    const double product = dot(a, table.harmonic[k]);
    if (product <= highest) continue;
    highest = product;
    best = k;
  }
  return nearest_frame(a, table.frame[best]);
}

AxisCircle axis_circle(const Quaternion& base_frame, const Vector& direction) {
  const Harmonic at0 = harmonic_of(base_frame);
  const Harmonic at45 = harmonic_of(turned(base_frame, direction, std::numbers::pi / 4));
  const Harmonic at22 = harmonic_of(turned(base_frame, direction, std::numbers::pi / 8));
  AxisCircle circle;
  for (std::size_t k = 0; k < 9; ++k) {
    circle.centre[k] = 0.5 * (at0[k] + at45[k]);
    circle.first[k] = 0.5 * (at0[k] - at45[k]);
    circle.second[k] = at22[k] - circle.centre[k];
  }
  return circle;
}

}  // namespace orbicube::frame_field
