// Associated Legendre functions of one order m in all degrees, for many points at once, in the orthonormal scaling of
// coefficients.h. What is computed is Q_lm(z) = sqrt 2 N_lm P_lm(z) / sin^m theta (without sqrt 2 for m = 0), so that
//
//   Y_lm = Q_lm(z) Re (x + i y)^m,   Y_l,-m = Q_lm(z) Im (x + i y)^m,
//
// which needs no angle and knows no special point. The recurrence goes up in l at fixed m (Holmes and Featherstone
// 2002, "A unified approach to the Clenshaw summation", section 2): Q_lm = a_lm (z Q_l-1,m - Q_l-2,m / a_l-1,m) with
// a_lm = sqrt((4 l^2 - 1) / (l^2 - m^2)), stable for |z| <= 1.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <span>

#include "harmonics/functions/coefficients.h"

namespace orbicube::harmonics {

// Points are worked on in blocks of this number, in the lanes of vector instructions.
inline constexpr std::size_t block_size = 64;
using Lanes = std::array<double, block_size>;

// Channels are worked on in groups of at most this number.
inline constexpr std::size_t channel_group = 3;
using GroupLanes = std::array<Lanes, channel_group>;

class LegendreTable {
 public:
  LegendreTable(std::uint32_t degree, std::pmr::memory_resource* memory);

  std::uint32_t degree() const { return degree_; }
  // Pairs l, m with 0 <= m <= l <= degree, those of m = 0 first; and where those of m start (the pair m, m).
  std::size_t pair_count() const { return step_.size(); }
  std::size_t start(std::uint32_t m) const { return std::size_t{m} * (2 * std::size_t{degree_} + 3 - m) / 2; }

  // What the recurrence of an order starts with, Q_mm, and its steps: Q_l = [0] z Q_l-1 - [1] Q_l-2 for step[l - m].
  double first(std::uint32_t m) const { return first_[m]; }
  const std::array<double, 2>* steps(std::uint32_t m) const { return step_.data() + start(m); }

  // Values of one order at a block of heights z: Q_lm is written to column[l - m].
  void values(std::uint32_t m, const Lanes& z, Lanes* column) const;
  // The same and the derivatives dQ_lm / dz.
  void values_and_slopes(std::uint32_t m, const Lanes& z, Lanes* column, Lanes* slopes) const;

  // cosine[c] = sum over l of C_lm Q_lm, sine[c] likewise of S_lm, of the packed coefficients (PackedCoefficients) of
  // `channels` <= channel_group functions.
  void synthesise(std::uint32_t m, const Lanes& z, std::size_t channels, const double* packed, GroupLanes& cosine,
                  GroupLanes& sine) const;
  // The transpose: adds sum over the block of cosine[c] Q_lm to C_lm, and of sine[c] to S_lm.
  void analyse(std::uint32_t m, const Lanes& z, std::size_t channels, const GroupLanes& cosine, const GroupLanes& sine,
               double* packed) const;

 private:
  std::uint32_t degree_;
  Array<double> first_;                // Q_mm, which does not depend on z
  Array<std::array<double, 2>> step_;  // Q_l = [0] z Q_l-1 - [1] Q_l-2
};

// The coefficients of a group of channels in the order of LegendreTable: for each pair l, m first C_lm of each channel,
// then S_lm (zero for m = 0).
class PackedCoefficients {
 public:
  // Zeros.
  PackedCoefficients(const LegendreTable& table, std::size_t channels, std::pmr::memory_resource* memory)
      : table_(table), channels_(channels), packed_(table.pair_count() * 2 * channels, memory) {}

  // Channels first, first + 1, ... of coefficients of the table's degree or lower.
  void pack(std::span<const double> values, std::uint32_t degree, std::size_t all_channels, std::size_t first);
  // The other way, up to `degree`.
  void unpack(std::span<double> values, std::uint32_t degree, std::size_t all_channels, std::size_t first) const;

  std::size_t channels() const { return channels_; }
  std::span<double> values() { return packed_; }
  const double* order(std::uint32_t m) const { return packed_.data() + table_.start(m) * 2 * channels_; }
  double* order(std::uint32_t m) { return packed_.data() + table_.start(m) * 2 * channels_; }

 private:
  const LegendreTable& table_;
  std::size_t channels_;
  Array<double> packed_;
};

}  // namespace orbicube::harmonics
