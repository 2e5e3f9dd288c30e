#include "harmonics/scattered/fourier.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/vector_variants.h"

namespace orbicube::harmonics {
namespace {

using base::Four, base::load, base::store;
using Root = std::array<double, 2>;
static_assert(fourier_lanes == 4);

// What one pass of a radix r needs: sequences of `length` entries, `stride` of them interleaved, become r times as many
// of a length that is r times shorter.
struct Pass {
  std::size_t length, stride;
  double sign;
  const Root* roots;
  std::size_t root_step;  // e^(-2 pi i k / length) is roots[k * root_step]
};

struct Complex {
  Four real, imaginary;
};

ORBICUBE_INLINE Complex read(const ComplexLanes& from) {
  return {load(from.real.data()), load(from.imaginary.data())};
}

ORBICUBE_INLINE void write(const Complex& a, ComplexLanes& to) {
  store(to.real.data(), a.real);
  store(to.imaginary.data(), a.imaginary);
}

// to = a * (c, s).
ORBICUBE_INLINE void write_turned(const Complex& a, double c, double s, ComplexLanes& to) {
  write({a.real * c - a.imaginary * s, a.real * s + a.imaginary * c}, to);
}

ORBICUBE_INLINE Complex sum(const Complex& a, const Complex& b) {
  return {a.real + b.real, a.imaginary + b.imaginary};
}

ORBICUBE_INLINE Complex difference(const Complex& a, const Complex& b) {
  return {a.real - b.real, a.imaginary - b.imaginary};
}

// a + factor b.
ORBICUBE_INLINE Complex plus(const Complex& a, double factor, const Complex& b) {
  return {a.real + factor * b.real, a.imaginary + factor * b.imaginary};
}

// a + i factor b.
ORBICUBE_INLINE Complex plus_turned(const Complex& a, double factor, const Complex& b) {
  return {a.real - factor * b.imaginary, a.imaginary + factor * b.real};
}

// a + i b, and a - i b.
ORBICUBE_INLINE Complex plus_quarter(const Complex& a, const Complex& b) {
  return {a.real - b.imaginary, a.imaginary + b.real};
}
ORBICUBE_INLINE Complex minus_quarter(const Complex& a, const Complex& b) {
  return {a.real + b.imaginary, a.imaginary - b.real};
}

ORBICUBE_VECTOR_VARIANTS
void pass_2(const Pass& pass, const ComplexLanes* from, ComplexLanes* to) {
  const std::size_t part = pass.length / 2, s = pass.stride;
  for (std::size_t q = 0; q < part; ++q) {
    const Root& w = pass.roots[q * pass.root_step];
    for (std::size_t k = 0; k < s; ++k) {
      const Complex a = read(from[k + s * q]), b = read(from[k + s * (q + part)]);
      write(sum(a, b), to[k + s * 2 * q]);
      write_turned(difference(a, b), w[0], -pass.sign * w[1], to[k + s * (2 * q + 1)]);
    }
  }
}

ORBICUBE_VECTOR_VARIANTS
void pass_3(const Pass& pass, const ComplexLanes* from, ComplexLanes* to) {
  const std::size_t part = pass.length / 3, s = pass.stride;
  const double sine = pass.sign * std::numbers::sqrt3 / 2;
  for (std::size_t q = 0; q < part; ++q) {
    const Root &w1 = pass.roots[q * pass.root_step], &w2 = pass.roots[2 * q * pass.root_step];
    for (std::size_t k = 0; k < s; ++k) {
      const Complex a = read(from[k + s * q]), b = read(from[k + s * (q + part)]),
                    c = read(from[k + s * (q + 2 * part)]);
      const Complex even = sum(b, c), odd = difference(b, c), middle = plus(a, -0.5, even);
      write(sum(a, even), to[k + s * 3 * q]);
      write_turned(plus_turned(middle, sine, odd), w1[0], -pass.sign * w1[1], to[k + s * (3 * q + 1)]);
      write_turned(plus_turned(middle, -sine, odd), w2[0], -pass.sign * w2[1], to[k + s * (3 * q + 2)]);
    }
  }
}

template <bool positive>
ORBICUBE_INLINE void pass_4_of_sign(const Pass& pass, const ComplexLanes* from, ComplexLanes* to) {
  const std::size_t part = pass.length / 4, s = pass.stride;
  for (std::size_t q = 0; q < part; ++q) {
    const Root &w1 = pass.roots[q * pass.root_step], &w2 = pass.roots[2 * q * pass.root_step],
               &w3 = pass.roots[3 * q * pass.root_step];
    for (std::size_t k = 0; k < s; ++k) {
      const Complex a = read(from[k + s * q]), b = read(from[k + s * (q + part)]),
                    c = read(from[k + s * (q + 2 * part)]), d = read(from[k + s * (q + 3 * part)]);
      const Complex ac = sum(a, c), bd = sum(b, d), low = difference(a, c), high = difference(b, d);
      const Complex plus = plus_quarter(low, high), minus = minus_quarter(low, high);
      write(sum(ac, bd), to[k + s * 4 * q]);
      write_turned(positive ? plus : minus, w1[0], -pass.sign * w1[1], to[k + s * (4 * q + 1)]);
      write_turned(difference(ac, bd), w2[0], -pass.sign * w2[1], to[k + s * (4 * q + 2)]);
      write_turned(positive ? minus : plus, w3[0], -pass.sign * w3[1], to[k + s * (4 * q + 3)]);
    }
  }
}

ORBICUBE_VECTOR_VARIANTS
void pass_4_forward(const Pass& pass, const ComplexLanes* from, ComplexLanes* to) {
  pass_4_of_sign<false>(pass, from, to);
}
ORBICUBE_VECTOR_VARIANTS
void pass_4_back(const Pass& pass, const ComplexLanes* from, ComplexLanes* to) {
  pass_4_of_sign<true>(pass, from, to);
}

ORBICUBE_VECTOR_VARIANTS
void pass_5(const Pass& pass, const ComplexLanes* from, ComplexLanes* to) {
  const std::size_t part = pass.length / 5, s = pass.stride;
  // Cosines and sines of 72 and 144 degrees.
  constexpr double c1 = 0.30901699437494742410, c2 = -0.80901699437494742410;
  const double s1 = pass.sign * 0.95105651629515357212, s2 = pass.sign * 0.58778525229247312917;
  for (std::size_t q = 0; q < part; ++q) {
    const Root* w[5];
    for (std::size_t r = 0; r < 5; ++r)
      w[r] = &pass.roots[r * q * pass.root_step];
    for (std::size_t k = 0; k < s; ++k) {
      const Complex a = read(from[k + s * q]), b = read(from[k + s * (q + part)]),
                    c = read(from[k + s * (q + 2 * part)]), d = read(from[k + s * (q + 3 * part)]),
                    e = read(from[k + s * (q + 4 * part)]);
      const Complex be = sum(b, e), cd = sum(c, d), b_e = difference(b, e), c_d = difference(c, d);
      const Complex even1 = plus(plus(a, c1, be), c2, cd), even2 = plus(plus(a, c2, be), c1, cd);
      ComplexLanes* out = to + k + s * 5 * q;
      write(sum(a, sum(be, cd)), out[0]);
      write_turned(plus_turned(plus_turned(even1, s1, b_e), s2, c_d), (*w[1])[0], -pass.sign * (*w[1])[1], out[s]);
      write_turned(plus_turned(plus_turned(even2, s2, b_e), -s1, c_d), (*w[2])[0], -pass.sign * (*w[2])[1], out[2 * s]);
      write_turned(plus_turned(plus_turned(even2, -s2, b_e), s1, c_d), (*w[3])[0], -pass.sign * (*w[3])[1], out[3 * s]);
      write_turned(plus_turned(plus_turned(even1, -s1, b_e), -s2, c_d), (*w[4])[0], -pass.sign * (*w[4])[1],
                   out[4 * s]);
    }
  }
}

}  // namespace

FourierTransform::FourierTransform(std::size_t length, std::pmr::memory_resource* memory)
    : length_(length), radices_(memory), roots_(length, memory) {
  std::size_t rest = length;
  for (const std::size_t radix : std::array<std::size_t, 4>{4, 2, 3, 5}) {
    for (; rest % radix == 0; rest /= radix)
      radices_.push_back(radix);
  }
  for (std::size_t k = 0; k < length; ++k) {
    const long double angle =
        2 * std::numbers::pi_v<long double> * static_cast<long double>(k) / static_cast<long double>(length);
    roots_[k] = {static_cast<double>(std::cos(angle)), static_cast<double>(-std::sin(angle))};
  }
}

ComplexLanes* FourierTransform::transform(int sign, ComplexLanes* data, ComplexLanes* scratch) const {
  Pass pass{length_, 1, static_cast<double>(sign), roots_.data(), 1};
  ComplexLanes *from = data, *to = scratch;
  for (const std::size_t radix : radices_) {
    const auto pass_4 = sign > 0 ? pass_4_back : pass_4_forward;
    const auto work = radix == 2 ? pass_2 : radix == 3 ? pass_3 : radix == 4 ? pass_4 : pass_5;
    work(pass, from, to);
    std::swap(from, to);
    pass.length /= radix;
    pass.stride *= radix;
    pass.root_step *= radix;
  }
  return from;
}

std::size_t FourierTransform::fitting_length(std::size_t minimum) {
  for (std::size_t length = minimum + minimum % 2;; length += 2) {
    std::size_t rest = length;
    for (const std::size_t prime : std::array<std::size_t, 3>{2, 3, 5}) {
      while (rest % prime == 0)
        rest /= prime;
    }
    if (rest == 1) return length;
  }
}

}  // namespace orbicube::harmonics
