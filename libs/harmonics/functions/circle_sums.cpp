#include "harmonics/functions/circle_sums.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/vector_variants.h"
#include "harmonics/functions/exact_products.h"

namespace orbicube::harmonics {
namespace {

using base::Four, base::load, base::store;

// Circles of at most this radius take Reinsch's form: where both are as exact at degree 1000 but for rounding.
constexpr double polar_radius = 0.5;

// Where some circles are, and what the first function is there.
struct Circles {
  const double *height, *depth, *start;
};

// The next degree of four circles: R_l of `last` and, in `before`, R_l-1.
struct PlainStep {
  const double* step;
  Four z, last, before;

  ORBICUBE_INLINE PlainStep(const OrderRecurrence& recurrence, const Circles& circles, std::size_t first)
      : step(recurrence.steps()), z(load(circles.height + first)), last(load(circles.start + first)), before{} {}
  ORBICUBE_INLINE void advance(std::size_t l) {
    const Four next = step[l] * z * last - before;
    before = last;
    last = next;
  }
};

// The same in Reinsch's form, with D_l in `difference`.
struct PolarStep {
  const double *step, *growth, *shrinking;
  Four depth, last, difference;

  ORBICUBE_INLINE PolarStep(const OrderRecurrence& recurrence, const Circles& circles, std::size_t first)
      : step(recurrence.steps()),
        growth(recurrence.growths()),
        shrinking(recurrence.shrinkings()),
        depth(load(circles.depth + first)),
        last(load(circles.start + first)),
        difference{} {}
  ORBICUBE_INLINE void advance(std::size_t l) {
    difference = shrinking[l - 1] * difference - step[l] * depth * last;
    last = growth[l] * last + difference;
  }
};

struct GroupSums {
  Four even_cosine[2], even_sine[2], odd_cosine[2], odd_sine[2];
};

template <class Step>
ORBICUBE_INLINE void synthesise_group(Step a, Step b, const double* packed, std::size_t count, CircleSums to) {
  GroupSums sums{};
  const auto add_even = [&](std::size_t l) __attribute__((always_inline)) {
    sums.even_cosine[0] += packed[2 * l] * a.last;
    sums.even_cosine[1] += packed[2 * l] * b.last;
    sums.even_sine[0] += packed[2 * l + 1] * a.last;
    sums.even_sine[1] += packed[2 * l + 1] * b.last;
  };
  std::size_t l = 0;
  for (; l + 1 < count; l += 2) {
    add_even(l);
    a.advance(l + 1);
    b.advance(l + 1);
    sums.odd_cosine[0] += packed[2 * l + 2] * a.last;
    sums.odd_cosine[1] += packed[2 * l + 2] * b.last;
    sums.odd_sine[0] += packed[2 * l + 3] * a.last;
    sums.odd_sine[1] += packed[2 * l + 3] * b.last;
    a.advance(l + 2);
    b.advance(l + 2);
  }
  if (l < count) add_even(l);
  for (std::size_t k = 0; k < 2; ++k) {
    store(to.even_cosine + 4 * k, sums.even_cosine[k]);
    store(to.even_sine + 4 * k, sums.even_sine[k]);
    store(to.odd_cosine + 4 * k, sums.odd_cosine[k]);
    store(to.odd_sine + 4 * k, sums.odd_sine[k]);
  }
}

// Adds to [degree][cosine, sine][lane].
template <class Step>
ORBICUBE_INLINE void analyse_group(Step a, Step b, CircleSums from, std::size_t count, double* lanes) {
  GroupSums sums;
  for (std::size_t k = 0; k < 2; ++k) {
    sums.even_cosine[k] = load(from.even_cosine + 4 * k);
    sums.even_sine[k] = load(from.even_sine + 4 * k);
    sums.odd_cosine[k] = load(from.odd_cosine + 4 * k);
    sums.odd_sine[k] = load(from.odd_sine + 4 * k);
  }
  const auto add = [&](std::size_t l, const Four(&cosine)[2], const Four(&sine)[2]) __attribute__((always_inline)) {
    double* to = lanes + 2 * circle_group * l;
    store(to, load(to) + cosine[0] * a.last);
    store(to + 4, load(to + 4) + cosine[1] * b.last);
    store(to + 8, load(to + 8) + sine[0] * a.last);
    store(to + 12, load(to + 12) + sine[1] * b.last);
  };
  std::size_t l = 0;
  for (; l + 1 < count; l += 2) {
    add(l, sums.even_cosine, sums.even_sine);
    a.advance(l + 1);
    b.advance(l + 1);
    add(l + 1, sums.odd_cosine, sums.odd_sine);
    a.advance(l + 2);
    b.advance(l + 2);
  }
  if (l < count) add(l, sums.even_cosine, sums.even_sine);
}

// Writes [degree][circle].
template <class Step>
ORBICUBE_INLINE void write_columns(const OrderRecurrence& recurrence, const Circles& circles, double* column) {
  Step a(recurrence, circles, 0), b(recurrence, circles, 4), c(recurrence, circles, 8), d(recurrence, circles, 12);
  for (std::size_t l = 0;; column += 2 * circle_group) {
    store(column, a.last);
    store(column + 4, b.last);
    store(column + 8, c.last);
    store(column + 12, d.last);
    if (++l == recurrence.count()) return;
    a.advance(l);
    b.advance(l);
    c.advance(l);
    d.advance(l);
  }
}

// Variants are made of plain functions only.
ORBICUBE_VECTOR_VARIANTS
void synthesise_plain(const OrderRecurrence& recurrence, const Circles& circles, const double* packed,
                      CircleSums sums) {
  synthesise_group(PlainStep(recurrence, circles, 0), PlainStep(recurrence, circles, 4), packed, recurrence.count(),
                   sums);
}
ORBICUBE_VECTOR_VARIANTS
void synthesise_polar(const OrderRecurrence& recurrence, const Circles& circles, const double* packed,
                      CircleSums sums) {
  synthesise_group(PolarStep(recurrence, circles, 0), PolarStep(recurrence, circles, 4), packed, recurrence.count(),
                   sums);
}
ORBICUBE_VECTOR_VARIANTS
void analyse_plain(const OrderRecurrence& recurrence, const Circles& circles, CircleSums sums, double* lanes) {
  analyse_group(PlainStep(recurrence, circles, 0), PlainStep(recurrence, circles, 4), sums, recurrence.count(), lanes);
}
ORBICUBE_VECTOR_VARIANTS
void analyse_polar(const OrderRecurrence& recurrence, const Circles& circles, CircleSums sums, double* lanes) {
  analyse_group(PolarStep(recurrence, circles, 0), PolarStep(recurrence, circles, 4), sums, recurrence.count(), lanes);
}
ORBICUBE_VECTOR_VARIANTS
void columns_plain(const OrderRecurrence& recurrence, const Circles& circles, double* column) {
  write_columns<PlainStep>(recurrence, circles, column);
}
ORBICUBE_VECTOR_VARIANTS
void columns_polar(const OrderRecurrence& recurrence, const Circles& circles, double* column) {
  write_columns<PolarStep>(recurrence, circles, column);
}

ORBICUBE_VECTOR_VARIANTS
void multiply_parts(const double* high, const double* low, std::size_t count, double* to_high, double* to_low) {
  for (std::size_t i = 0; i < count; ++i) {
    const TwoParts p = product({to_high[i], to_low[i]}, {high[i], low[i]});
    to_high[i] = p.high;
    to_low[i] = p.low;
  }
}

// radius^m of one group, by squaring.
ORBICUBE_VECTOR_VARIANTS
void group_powers(std::uint32_t m, const double* radius, const double* rest, double* high, double* low) {
  double square_high[circle_group], square_low[circle_group];
  for (std::size_t i = 0; i < circle_group; ++i) {
    square_high[i] = radius[i];
    square_low[i] = rest[i];
    high[i] = 1;
    low[i] = 0;
  }
  for (; m > 0; m /= 2) {
    for (std::size_t i = 0; i < circle_group && m % 2 == 1; ++i) {
      const TwoParts p = product({high[i], low[i]}, {square_high[i], square_low[i]});
      high[i] = p.high;
      low[i] = p.low;
    }
    for (std::size_t i = 0; i < circle_group; ++i) {
      const TwoParts p = product({square_high[i], square_low[i]}, {square_high[i], square_low[i]});
      square_high[i] = p.high;
      square_low[i] = p.low;
    }
  }
}

CircleSums from(CircleSums sums, std::size_t first) {
  return {sums.even_cosine + first, sums.even_sine + first, sums.odd_cosine + first, sums.odd_sine + first};
}

ORBICUBE_VECTOR_VARIANTS
void set_factors(std::uint32_t degree, std::uint32_t m, double* factor) {
  for (std::uint32_t l = m + 1; l <= degree + 1; ++l) {
    const double d = l, o = m;
    factor[l - m] = std::sqrt((4 * d * d - 1) / ((d - o) * (d + o)));
  }
}

// `growth` has g_l-1 / g_l.
ORBICUBE_VECTOR_VARIANTS
void set_steps(std::uint32_t degree, std::uint32_t m, const double* factor, double* step, double* growth,
               double* shrinking) {
  for (std::uint32_t l = m + 1; l <= degree + 1; ++l) {
    const double d = l, o = m, ratio = growth[l - m];
    step[l - m] = factor[l - m] * ratio;
    const double at_pole = std::sqrt(((2 * d + 1) * (d + o)) / ((2 * d - 1) * (d - o))) * ratio;
    growth[l - m] = at_pole;
    shrinking[l - m] = 1 / at_pole;
  }
}

}  // namespace

OrderRecurrence::OrderRecurrence(std::uint32_t degree, std::pmr::memory_resource* memory)
    : degree_(degree),
      first_(degree + std::size_t{1}, memory),
      factor_(degree + std::size_t{3}, memory),
      step_(factor_.size(), memory),
      scale_(factor_.size(), memory),
      growth_(factor_.size(), memory),
      shrinking_(factor_.size(), memory) {
  double product = 1;  // of (2k - 1) / (2k)
  for (std::uint32_t m = 0; m <= degree; ++m) {
    if (m > 0) product *= (2.0 * m - 1) / (2.0 * m);
    first_[m] = std::sqrt((m > 0 ? 2 : 1) * (2.0 * m + 1) / (4 * std::numbers::pi) * product);
  }
}

void OrderRecurrence::set_order(std::uint32_t m) {
  order_ = m;
  set_factors(degree_, m, factor_.data());
  const std::size_t last = count();  // one degree more than there is
  scale_[0] = scale_[1] = first_[m];
  growth_[0] = growth_[1] = 1;
  for (std::size_t l = 2; l <= last; ++l) {
    scale_[l] = scale_[l - 2] * (factor_[l] / factor_[l - 1]);
    growth_[l] = scale_[l - 1] / scale_[l];
  }
  set_steps(degree_, m, factor_.data(), step_.data(), growth_.data(), shrinking_.data());
  shrinking_[0] = 0;
}

CirclePairs::CirclePairs(std::size_t pairs, std::pmr::memory_resource* memory)
    : count_(pairs),
      height_((pairs + circle_group - 1) / circle_group * circle_group, 0.0, memory),
      depth_(height_.size(), 1.0, memory),
      radius_(height_.size(), 1.0, memory),
      radius_rest_(height_.size(), memory) {}

void CirclePairs::set(std::size_t pair, long double angle) {
  const long double radius = std::sin(angle), half = std::sin(0.5L * angle);
  height_[pair] = static_cast<double>(std::cos(angle));
  depth_[pair] = static_cast<double>(2 * half * half);
  radius_[pair] = static_cast<double>(radius);
  radius_rest_[pair] = static_cast<double>(radius - static_cast<long double>(radius_[pair]));
}

// Functions up to the degree are negligible on circles of a smaller radius (Reinecke and Seljebotn 2013).
std::size_t CirclePairs::first_pair(std::uint32_t m, std::uint32_t degree) const {
  const double least =
      (static_cast<double>(m) - std::max(100.0, 0.01 * degree)) / std::max(1.0, static_cast<double>(degree));
  const auto first = std::lower_bound(radius_.begin(), radius_.end(), least) - radius_.begin();
  return static_cast<std::size_t>(first) / circle_group * circle_group;
}

bool CirclePairs::is_polar(std::size_t first, std::size_t count) const {
  return radius_[first + count - 1] <= polar_radius;
}

void CirclePairs::powers(std::uint32_t exponent, std::size_t count, std::size_t first, double* high,
                         double* rest) const {
  for (std::size_t g = first; g < padded(); g += circle_group)
    group_powers(exponent, &radius_[g], &radius_rest_[g], high + g, rest + g);
  for (std::size_t k = 1; k < count; ++k, high += padded()) {
    std::copy(high + first, high + padded(), high + padded() + first);
    multiply_parts(&radius_[first], &radius_rest_[first], padded() - first, high + padded() + first, rest + first);
  }
}

void CirclePairs::synthesise(const OrderRecurrence& recurrence, const double* packed, const double* start,
                             std::size_t first, CircleSums sums) const {
  for (std::size_t g = first; g < padded(); g += circle_group) {
    const auto work = is_polar(g, circle_group) ? synthesise_polar : synthesise_plain;
    work(recurrence, {&height_[g], &depth_[g], start + g}, packed, from(sums, g));
  }
}

void CirclePairs::analyse(const OrderRecurrence& recurrence, CircleSums sums, const double* start, std::size_t first,
                          double* lanes, double* packed) const {
  const std::size_t count = recurrence.count();
  std::fill_n(lanes, 2 * circle_group * count, 0.0);
  for (std::size_t g = first; g < padded(); g += circle_group) {
    const auto work = is_polar(g, circle_group) ? analyse_polar : analyse_plain;
    work(recurrence, {&height_[g], &depth_[g], start + g}, from(sums, g), lanes);
  }
  for (std::size_t k = 0; k < 2 * count; ++k, lanes += circle_group)
    packed[k] = ((lanes[0] + lanes[4]) + (lanes[1] + lanes[5])) + ((lanes[2] + lanes[6]) + (lanes[3] + lanes[7]));
}

void CirclePairs::columns(const OrderRecurrence& recurrence, const double* start, std::size_t first,
                          double* column) const {
  const auto work = is_polar(first, 2 * circle_group) ? columns_polar : columns_plain;
  work(recurrence, {&height_[first], &depth_[first], start + first}, column);
}

}  // namespace orbicube::harmonics
