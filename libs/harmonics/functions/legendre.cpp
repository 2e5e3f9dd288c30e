#include "harmonics/functions/legendre.h"

#include <cmath>
#include <numbers>

#include "base/vector_variants.h"

namespace orbicube::harmonics {
namespace {

using Step = std::array<double, 2>;

ORBICUBE_INLINE void start(double first, Lanes& last, Lanes& before) {
  last.fill(first);
  before.fill(0);
}

// One step of the recurrence: `last` becomes the next degree.
ORBICUBE_INLINE void advance(const Step& step, const Lanes& z, Lanes& last, Lanes& before) {
  for (std::size_t i = 0; i < block_size; ++i) {
    const double next = step[0] * z[i] * last[i] - step[1] * before[i];
    before[i] = last[i];
    last[i] = next;
  }
}

template <std::size_t channels>
ORBICUBE_INLINE void synthesise_circles(double first, const Step* step, std::size_t count, const Lanes& z,
                                        const double* packed, GroupLanes& cosine, GroupLanes& sine) {
  Lanes last, before;
  start(first, last, before);
  for (std::size_t c = 0; c < channels; ++c) {
    cosine[c].fill(0);
    sine[c].fill(0);
  }
  for (std::size_t l = 0; l < count; ++l, packed += 2 * channels) {
    if (l > 0) advance(step[l], z, last, before);
    for (std::size_t c = 0; c < channels; ++c) {
      for (std::size_t i = 0; i < block_size; ++i)
        cosine[c][i] += packed[c] * last[i];
      for (std::size_t i = 0; i < block_size; ++i)
        sine[c][i] += packed[channels + c] * last[i];
    }
  }
}

// The sum of a_i b_i, in an order that vector instructions can follow.
ORBICUBE_INLINE double dot(const Lanes& a, const Lanes& b) {
  constexpr std::size_t width = 8;
  std::array<double, width> lane{};
  for (std::size_t i = 0; i < block_size; i += width) {
    for (std::size_t k = 0; k < width; ++k)
      lane[k] += a[i + k] * b[i + k];
  }
  return ((lane[0] + lane[4]) + (lane[1] + lane[5])) + ((lane[2] + lane[6]) + (lane[3] + lane[7]));
}

template <std::size_t channels>
ORBICUBE_INLINE void analyse_circles(double first, const Step* step, std::size_t count, const Lanes& z,
                                     const GroupLanes& cosine, const GroupLanes& sine, double* packed) {
  Lanes last, before;
  start(first, last, before);
  for (std::size_t l = 0; l < count; ++l, packed += 2 * channels) {
    if (l > 0) advance(step[l], z, last, before);
    for (std::size_t c = 0; c < channels; ++c) {
      packed[c] += dot(cosine[c], last);
      packed[channels + c] += dot(sine[c], last);
    }
  }
}

// Variants are made of plain functions only, so there is one for each number of channels.
ORBICUBE_VECTOR_VARIANTS
void synthesise_1(double first, const Step* step, std::size_t count, const Lanes& z, const double* packed,
                  GroupLanes& cosine, GroupLanes& sine) {
  synthesise_circles<1>(first, step, count, z, packed, cosine, sine);
}
ORBICUBE_VECTOR_VARIANTS
void synthesise_2(double first, const Step* step, std::size_t count, const Lanes& z, const double* packed,
                  GroupLanes& cosine, GroupLanes& sine) {
  synthesise_circles<2>(first, step, count, z, packed, cosine, sine);
}
ORBICUBE_VECTOR_VARIANTS
void synthesise_3(double first, const Step* step, std::size_t count, const Lanes& z, const double* packed,
                  GroupLanes& cosine, GroupLanes& sine) {
  synthesise_circles<3>(first, step, count, z, packed, cosine, sine);
}
ORBICUBE_VECTOR_VARIANTS
void analyse_1(double first, const Step* step, std::size_t count, const Lanes& z, const GroupLanes& cosine,
               const GroupLanes& sine, double* packed) {
  analyse_circles<1>(first, step, count, z, cosine, sine, packed);
}
ORBICUBE_VECTOR_VARIANTS
void analyse_2(double first, const Step* step, std::size_t count, const Lanes& z, const GroupLanes& cosine,
               const GroupLanes& sine, double* packed) {
  analyse_circles<2>(first, step, count, z, cosine, sine, packed);
}
ORBICUBE_VECTOR_VARIANTS
void analyse_3(double first, const Step* step, std::size_t count, const Lanes& z, const GroupLanes& cosine,
               const GroupLanes& sine, double* packed) {
  analyse_circles<3>(first, step, count, z, cosine, sine, packed);
}

}  // namespace

LegendreTable::LegendreTable(std::uint32_t degree, std::pmr::memory_resource* memory)
    : degree_(degree), first_(degree + std::size_t{1}, memory), step_(memory) {
  step_.resize((std::size_t{degree} + 1) * (std::size_t{degree} + 2) / 2);
  double product = 1;  // of (2k - 1) / (2k)
  for (std::uint32_t m = 0; m <= degree; ++m) {
    if (m > 0) product *= (2.0 * m - 1) / (2.0 * m);
    first_[m] = std::sqrt((m > 0 ? 2 : 1) * (2.0 * m + 1) / (4 * std::numbers::pi) * product);
    Step* step = step_.data() + start(m);
    double previous = 1;  // a_l-1,m
    for (std::uint32_t l = m + 1; l <= degree; ++l) {
      const double a = std::sqrt((4.0 * l * l - 1) / (static_cast<double>(l - m) * static_cast<double>(l + m)));
      step[l - m] = {a, l == m + 1 ? 0 : a / previous};
      previous = a;
    }
  }
}

void LegendreTable::values(std::uint32_t m, const Lanes& z, Lanes* column) const {
  const Step* step = step_.data() + start(m);
  Lanes last, before;
  harmonics::start(first_[m], last, before);
  for (std::size_t l = 0; l + m <= degree_; ++l) {
    if (l > 0) advance(step[l], z, last, before);
    column[l] = last;
  }
}

void LegendreTable::values_and_slopes(std::uint32_t m, const Lanes& z, Lanes* column, Lanes* slopes) const {
  values(m, z, column);
  const Step* step = step_.data() + start(m);
  slopes[0].fill(0);
  for (std::size_t l = 1; l + m <= degree_; ++l) {
    for (std::size_t i = 0; i < block_size; ++i) {
      const double older = l > 1 ? slopes[l - 2][i] : 0;
      slopes[l][i] = step[l][0] * (z[i] * slopes[l - 1][i] + column[l - 1][i]) - step[l][1] * older;
    }
  }
}

void LegendreTable::synthesise(std::uint32_t m, const Lanes& z, std::size_t channels, const double* packed,
                               GroupLanes& cosine, GroupLanes& sine) const {
  const auto work = channels == 1 ? synthesise_1 : channels == 2 ? synthesise_2 : synthesise_3;
  work(first_[m], step_.data() + start(m), degree_ + std::size_t{1} - m, z, packed, cosine, sine);
}

void LegendreTable::analyse(std::uint32_t m, const Lanes& z, std::size_t channels, const GroupLanes& cosine,
                            const GroupLanes& sine, double* packed) const {
  const auto work = channels == 1 ? analyse_1 : channels == 2 ? analyse_2 : analyse_3;
  work(first_[m], step_.data() + start(m), degree_ + std::size_t{1} - m, z, cosine, sine, packed);
}

void PackedCoefficients::pack(std::span<const double> values, std::uint32_t degree, std::size_t all_channels,
                              std::size_t first) {
  for (std::uint32_t m = 0; m <= degree; ++m) {
    double* to = order(m);
    for (std::uint32_t l = m; l <= degree; ++l, to += 2 * channels_) {
      const std::size_t cosine = basis_index(l, static_cast<std::int32_t>(m)) * all_channels + first;
      const std::size_t sine = basis_index(l, -static_cast<std::int32_t>(m)) * all_channels + first;
      for (std::size_t c = 0; c < channels_; ++c) {
        to[c] = values[cosine + c];
        to[channels_ + c] = m > 0 ? values[sine + c] : 0;
      }
    }
  }
}

void PackedCoefficients::unpack(std::span<double> values, std::uint32_t degree, std::size_t all_channels,
                                std::size_t first) const {
  for (std::uint32_t m = 0; m <= degree; ++m) {
    const double* from = order(m);
    for (std::uint32_t l = m; l <= degree; ++l, from += 2 * channels_) {
      const std::size_t cosine = basis_index(l, static_cast<std::int32_t>(m)) * all_channels + first;
      const std::size_t sine = basis_index(l, -static_cast<std::int32_t>(m)) * all_channels + first;
      for (std::size_t c = 0; c < channels_; ++c) {
        values[cosine + c] = from[c];
        if (m > 0) values[sine + c] = from[channels_ + c];
      }
    }
  }
}

}  // namespace orbicube::harmonics
