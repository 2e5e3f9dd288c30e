#include "harmonics/fitting/gram_operator.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "harmonics/functions/gauss_legendre.h"

namespace orbicube::harmonics {

GramOperator::Work::Work(std::uint32_t degree, std::size_t width, std::pmr::memory_resource* memory)
    : orders((2 * std::size_t{degree} + 1) * channel_group * block_size, memory),
      grid(width * channel_group * block_size, memory) {}

GramOperator::GramOperator(const Coefficients& moments, const base::Host& host)
    : host_(host),
      table_(moments.degree / 2, host.memory),
      longitudes_(2 * std::size_t{moments.degree} + 1),
      block_count_((moments.degree + block_size) / block_size),
      height_(block_count_, host.memory),
      radius_(block_count_, host.memory),
      waves_((2 * std::size_t{moments.degree} + 1) * longitudes_, host.memory),
      density_(block_count_ * block_size * longitudes_, host.memory),
      work_(host.memory),
      parts_(block_count_ * table_.pair_count() * 2 * channel_group, host.memory) {
  const std::size_t circles = moments.degree + std::size_t{1};
  Array<double> node(circles, host.memory), weight(circles, host.memory);
  gauss_legendre(node, weight);
  for (std::size_t t = 0; t < block_count_ * block_size; ++t) {
    const double z = t < circles ? node[t] : 1;
    height_[t / block_size][t % block_size] = z;
    radius_[t / block_size][t % block_size] = std::sqrt((1 - z) * (1 + z));
  }
  const std::size_t rows = 2 * std::size_t{moments.degree} + 1;
  for (std::size_t j = 0; j < longitudes_; ++j) {
    double* column = waves_.data() + j * rows;
    column[0] = 1;
    for (std::size_t m = 1; m <= moments.degree; ++m) {
      // The angle is reduced first: m j can be large.
      const double turn = static_cast<double>(m * j % longitudes_) / static_cast<double>(longitudes_);
      column[2 * m - 1] = std::cos(2 * std::numbers::pi * turn);
      column[2 * m] = std::sin(2 * std::numbers::pi * turn);
    }
  }

  const LegendreTable table(moments.degree, host.memory);
  PackedCoefficients packed(table, 1, host.memory);
  packed.pack(moments.values, moments.degree, 1, 0);
  work_.reserve(block_count_);
  for (std::size_t b = 0; b < block_count_; ++b) {
    host.report("preparing the normal equations", b, block_count_);
    work_.emplace_back(moments.degree, longitudes_, host.memory);
    to_grid(b, table, packed, work_[b]);
    for (std::size_t j = 0; j < longitudes_; ++j) {
      for (std::size_t i = 0; i < block_size; ++i) {
        const std::size_t t = b * block_size + i;
        density_[(b * longitudes_ + j) * block_size + i] = t < circles
                                                               ? work_[b].grid[j * block_size + i] * weight[t] * 2 *
                                                                     std::numbers::pi / static_cast<double>(longitudes_)
                                                               : 0;
      }
    }
  }
}

void GramOperator::to_grid(std::size_t block, const LegendreTable& table, const PackedCoefficients& packed,
                           Work& work) const {
  const std::size_t channels = packed.channels();
  const auto rows = static_cast<Eigen::Index>(channels * block_size);
  const auto orders = static_cast<Eigen::Index>(2 * std::size_t{table.degree()} + 1);
  const auto width = static_cast<Eigen::Index>(longitudes_);
  GroupLanes cosine, sine;
  Lanes power;  // sin^m theta
  power.fill(1);
  for (std::uint32_t m = 0; m <= table.degree(); ++m) {
    table.synthesise(m, height_[block], channels, packed.order(m), cosine, sine);
    double* even = work.orders.data() + (m > 0 ? 2 * m - 1 : 0) * channels * block_size;
    double* odd = even + channels * block_size;
    for (std::size_t c = 0; c < channels; ++c) {
      for (std::size_t i = 0; i < block_size; ++i) {
        even[c * block_size + i] = cosine[c][i] * power[i];
        if (m > 0) odd[c * block_size + i] = sine[c][i] * power[i];
      }
    }
    for (std::size_t i = 0; i < block_size; ++i)
      power[i] *= radius_[block][i];
  }
  const Eigen::Map<const Eigen::MatrixXd> waves(waves_.data(), static_cast<Eigen::Index>(waves_.size() / longitudes_),
                                                width);
  Matrix(work.grid.data(), rows, width).noalias() = Matrix(work.orders.data(), rows, orders) * waves.topRows(orders);
}

void GramOperator::multiply(std::span<const double> c, std::size_t channels, std::span<double> product) {
  for (std::size_t first = 0; first < channels; first += channel_group)
    multiply_group(c, channels, first, std::min(channel_group, channels - first), product);
}

// What the circles of a block add to the product of `group` channels, into its part.
void GramOperator::multiply_block(std::size_t b, std::size_t group, const PackedCoefficients& packed) {
  const auto rows = static_cast<Eigen::Index>(group * block_size);
  const auto orders = static_cast<Eigen::Index>(2 * std::size_t{degree()} + 1);
  const auto width = static_cast<Eigen::Index>(longitudes_);
  const Eigen::Map<const Eigen::MatrixXd> waves(waves_.data(), static_cast<Eigen::Index>(waves_.size() / longitudes_),
                                                width);
  Work& work = work_[b];
  to_grid(b, table_, packed, work);
  for (std::size_t j = 0; j < longitudes_; ++j) {
    const double* density = density_.data() + (b * longitudes_ + j) * block_size;
    double* column = work.grid.data() + j * group * block_size;
    for (std::size_t k = 0; k < group; ++k) {
      for (std::size_t i = 0; i < block_size; ++i)
        column[k * block_size + i] *= density[i];
    }
  }
  Matrix(work.orders.data(), rows, orders).noalias() =
      Matrix(work.grid.data(), rows, width) * waves.topRows(orders).transpose();
  const std::size_t length = table_.pair_count() * 2 * group;
  double* part = parts_.data() + b * length;
  std::fill_n(part, length, 0.0);
  GroupLanes cosine, sine;
  for (Lanes& lanes : sine)
    lanes.fill(0);
  Lanes power;
  power.fill(1);
  for (std::uint32_t m = 0; m <= degree(); ++m) {
    const double* even = work.orders.data() + (m > 0 ? 2 * m - 1 : 0) * group * block_size;
    const double* odd = even + group * block_size;
    for (std::size_t k = 0; k < group; ++k) {
      for (std::size_t i = 0; i < block_size; ++i) {
        cosine[k][i] = even[k * block_size + i] * power[i];
        if (m > 0) sine[k][i] = odd[k * block_size + i] * power[i];
      }
    }
    table_.analyse(m, height_[b], group, cosine, sine, part + table_.start(m) * 2 * group);
    for (std::size_t i = 0; i < block_size; ++i)
      power[i] *= radius_[b][i];
  }
}

void GramOperator::multiply_group(std::span<const double> c, std::size_t channels, std::size_t first, std::size_t group,
                                  std::span<double> product) {
  PackedCoefficients packed(table_, group, host_.memory);
  packed.pack(c, degree(), channels, first);
  const std::size_t length = packed.values().size();
  // Threads cost more than they bring for a small degree.
  constexpr std::uint32_t threads_from = 24;
  if (degree() < threads_from) {
    for (std::size_t b = 0; b < block_count_; ++b)
      multiply_block(b, group, packed);
  } else {
    // Number of blocks between two reports, so that a cancel takes effect within 50 ms at any degree.
    constexpr std::size_t work_between_reports = 200'000;
    const std::size_t at_once = std::max<std::size_t>(4, work_between_reports / (std::size_t{degree()} * degree()));
    for (std::size_t b = 0; b < block_count_; b += at_once) {
      if (b > 0) host_.report("fitting", 0, 0);
      host_.parallel_for(std::min(at_once, block_count_ - b),
                         [&](std::size_t i) { multiply_block(b + i, group, packed); });
    }
  }
  const std::span<double> sum = packed.values();
  std::fill(sum.begin(), sum.end(), 0.0);
  for (std::size_t b = 0; b < block_count_; ++b) {
    for (std::size_t j = 0; j < length; ++j)
      sum[j] += parts_[b * length + j];
  }
  packed.unpack(product, degree(), channels, first);
}

}  // namespace orbicube::harmonics
