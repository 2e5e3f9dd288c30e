#include "harmonics/functions/basis.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "harmonics/scattered/fast_sums.h"

namespace orbicube::harmonics {
namespace {

// A block of points and the powers of x + i y that the orders need, one after the other.
struct PointBlock {
  Lanes x, y, z;
  Lanes real, imaginary;  // (x + i y)^m

  // Points first, first + 1, ...; past the end the pole, which does no harm.
  PointBlock(std::span<const Vector3> directions, std::size_t first) {
    for (std::size_t i = 0; i < block_size; ++i) {
      const bool there = first + i < directions.size();
      x[i] = there ? directions[first + i].x() : 0;
      y[i] = there ? directions[first + i].y() : 0;
      z[i] = there ? directions[first + i].z() : 1;
    }
    real.fill(1);
    imaginary.fill(0);
  }

  void next_order() {
    for (std::size_t i = 0; i < block_size; ++i) {
      const double r = real[i] * x[i] - imaginary[i] * y[i];
      imaginary[i] = real[i] * y[i] + imaginary[i] * x[i];
      real[i] = r;
    }
  }
};

// Work on points is cut into chunks of whole blocks, `wave` of which are done between reports: some 20 ms.
struct Chunks {
  static constexpr std::size_t wave = 16;

  Chunks(std::size_t points, std::size_t work_per_point) : point_count(points) {
    constexpr std::size_t work_per_wave = 20'000'000;
    const std::size_t fitting = work_per_wave / wave / std::max<std::size_t>(1, work_per_point) / block_size;
    size = block_size * std::clamp<std::size_t>(fitting, 1, 1024);
    count = (points + size - 1) / size;
  }

  // body(chunk, first, end, number in the wave) for each chunk; after(number of chunks) at the end of each wave.
  template <class Body, class After>
  void run(const char* phase, const base::Host& host, const Body& body, const After& after) const {
    for (std::size_t begin = 0; begin < count; begin += wave) {
      host.report(phase, begin * size, point_count);
      const std::size_t n = std::min(wave, count - begin);
      host.parallel_for(n, [&](std::size_t k) {
        const std::size_t first = (begin + k) * size;
        body(first, std::min(first + size, point_count), k);
      });
      after(n);
    }
  }

  std::size_t point_count, size, count;
};

constexpr const char* evaluating = "evaluating harmonics";

}  // namespace

Array<Vector3> unit_directions(std::span<const Vector3> directions, const base::Host& host) {
  Array<Vector3> unit(directions.begin(), directions.end(), host.memory);
  for (std::size_t i = 0; i < unit.size(); ++i) {
    const double square = unit[i].squaredNorm();
    if (square > 1e-200 && square < 1e200) {
      unit[i] /= std::sqrt(square);
      continue;
    }
    const double largest = unit[i].cwiseAbs().maxCoeff();
    if (!unit[i].allFinite() || largest == 0) {
      throw base::Error("invalid-argument",
                        "direction " + std::to_string(i) + (largest == 0 ? " has the length zero" : " is not finite"));
    }
    unit[i] /= largest;
    unit[i].normalize();
  }
  return unit;
}

void evaluate(std::span<const Vector3> directions, std::uint32_t degree, std::span<double> rows,
              const base::Host& host) {
  require_degree(degree);
  const Array<Vector3> unit = unit_directions(directions, host);
  const LegendreTable table(degree, host.memory);
  const std::size_t size = basis_size(degree);
  const Chunks chunks(unit.size(), 4 * table.pair_count());
  Array<Lanes> columns((degree + std::size_t{1}) * Chunks::wave, host.memory);
  chunks.run(
      evaluating, host,
      [&](std::size_t first, std::size_t end, std::size_t k) {
        Lanes* column = columns.data() + k * (degree + std::size_t{1});
        for (; first < end; first += block_size) {
          PointBlock block(unit, first);
          const std::size_t here = std::min(block_size, end - first);
          for (std::uint32_t m = 0; m <= degree; ++m) {
            if (m > 0) block.next_order();
            table.values(m, block.z, column);
            for (std::uint32_t l = m; l <= degree; ++l) {
              double* to = rows.data() + first * size + basis_index(l, 0);
              for (std::size_t i = 0; i < here; ++i, to += size) {
                to[m] = column[l - m][i] * block.real[i];
                if (m > 0) to[-static_cast<std::ptrdiff_t>(m)] = column[l - m][i] * block.imaginary[i];
              }
            }
          }
        }
      },
      [](std::size_t) {});
}

void synthesise(const Coefficients& coefficients, std::span<const Vector3> directions, std::span<double> values,
                const base::Host& host) {
  const Array<Vector3> unit = unit_directions(directions, host);
  if (synthesise_fast(coefficients, unit, values, evaluating, host)) return;
  const LegendreTable table(coefficients.degree, host.memory);
  const std::size_t channels = coefficients.channels;
  for (std::size_t from = 0; from < channels; from += channel_group) {
    const std::size_t group = std::min(channel_group, channels - from);
    PackedCoefficients packed(table, group, host.memory);
    packed.pack(coefficients.values, coefficients.degree, channels, from);
    const Chunks chunks(unit.size(), table.pair_count() * group);
    chunks.run(
        evaluating, host,
        [&](std::size_t first, std::size_t end, std::size_t) {
          GroupLanes cosine, sine, sum;
          for (; first < end; first += block_size) {
            PointBlock block(unit, first);
            for (Lanes& lanes : sum)
              lanes.fill(0);
            for (std::uint32_t m = 0; m <= table.degree(); ++m) {
              if (m > 0) block.next_order();
              table.synthesise(m, block.z, group, packed.order(m), cosine, sine);
              for (std::size_t c = 0; c < group; ++c) {
                for (std::size_t i = 0; i < block_size; ++i)
                  sum[c][i] += cosine[c][i] * block.real[i] + sine[c][i] * block.imaginary[i];
              }
            }
            for (std::size_t i = 0; i < std::min(block_size, end - first); ++i) {
              for (std::size_t c = 0; c < group; ++c)
                values[(first + i) * channels + from + c] = sum[c][i];
            }
          }
        },
        [](std::size_t) {});
  }
}

void synthesise_with_gradients(const Coefficients& coefficients, std::span<const Vector3> directions,
                               std::span<double> values, std::span<Vector3> gradients, const base::Host& host) {
  const Array<Vector3> unit = unit_directions(directions, host);
  const std::uint32_t degree = coefficients.degree;
  const LegendreTable table(degree, host.memory);
  const std::size_t channels = coefficients.channels, rows = degree + std::size_t{1};
  const Chunks chunks(unit.size(), 3 * table.pair_count() * std::max<std::size_t>(channels, 1));
  Array<Lanes> columns(2 * rows * Chunks::wave, host.memory);
  chunks.run(
      evaluating, host,
      [&](std::size_t first, std::size_t end, std::size_t k) {
        Lanes* column = columns.data() + 2 * rows * k;
        Lanes* slope = column + rows;
        for (; first < end; first += block_size) {
          PointBlock block(unit, first);
          const std::size_t here = std::min(block_size, end - first);
          std::fill_n(values.data() + first * channels, here * channels, 0.0);
          std::fill_n(gradients.data() + first * channels, here * channels, Vector3::Zero());
          Lanes lower_real{}, lower_imaginary{};  // (x + i y)^(m - 1)
          for (std::uint32_t m = 0; m <= degree; ++m) {
            if (m > 0) {
              lower_real = block.real;
              lower_imaginary = block.imaginary;
              block.next_order();
            }
            table.values_and_slopes(m, block.z, column, slope);
            const auto order = static_cast<std::int32_t>(m);
            for (std::size_t c = 0; c < channels; ++c) {
              for (std::size_t i = 0; i < here; ++i) {
                double cosine = 0, sine = 0, cosine_slope = 0, sine_slope = 0;
                for (std::uint32_t l = m; l <= degree; ++l) {
                  const double a = coefficients.at(l, order, c), b = m > 0 ? coefficients.at(l, -order, c) : 0;
                  cosine += a * column[l - m][i];
                  sine += b * column[l - m][i];
                  cosine_slope += a * slope[l - m][i];
                  sine_slope += b * slope[l - m][i];
                }
                const double r = block.real[i], s = block.imaginary[i];
                const double low_r = m * lower_real[i], low_s = m * lower_imaginary[i];
                values[(first + i) * channels + c] += cosine * r + sine * s;
                gradients[(first + i) * channels + c] += Vector3(
                    cosine * low_r + sine * low_s, sine * low_r - cosine * low_s, cosine_slope * r + sine_slope * s);
              }
            }
          }
          for (std::size_t i = 0; i < here; ++i) {
            const Vector3& p = unit[first + i];
            for (std::size_t c = 0; c < channels; ++c) {
              Vector3& g = gradients[(first + i) * channels + c];
              g -= g.dot(p) * p;
            }
          }
        }
      },
      [](std::size_t) {});
}

void analyse(std::span<const Vector3> directions, std::span<const double> weights, std::span<const double> values,
             Coefficients& coefficients, const char* phase, const base::Host& host) {
  const Array<Vector3> unit = unit_directions(directions, host);
  if (analyse_fast(unit, weights, values, coefficients, phase, host)) return;
  const LegendreTable table(coefficients.degree, host.memory);
  const std::size_t channels = coefficients.channels;
  for (std::size_t from = 0; from < channels; from += channel_group) {
    const std::size_t group = std::min(channel_group, channels - from);
    PackedCoefficients sum(table, group, host.memory);
    const std::size_t length = sum.values().size();
    // Each chunk of a wave adds up for itself; what they have is added in their order.
    Array<double> parts(length * Chunks::wave, host.memory);
    const Chunks chunks(unit.size(), table.pair_count() * group);
    chunks.run(
        phase, host,
        [&](std::size_t first, std::size_t end, std::size_t k) {
          double* part = parts.data() + k * length;
          std::fill_n(part, length, 0.0);
          GroupLanes value, cosine, sine;
          for (; first < end; first += block_size) {
            PointBlock block(unit, first);
            for (std::size_t c = 0; c < group; ++c) {
              for (std::size_t i = 0; i < block_size; ++i) {
                const std::size_t point = first + i;
                value[c][i] =
                    point >= end ? 0 : values[point * channels + from + c] * (weights.empty() ? 1 : weights[point]);
              }
            }
            for (std::uint32_t m = 0; m <= table.degree(); ++m) {
              if (m > 0) block.next_order();
              for (std::size_t c = 0; c < group; ++c) {
                for (std::size_t i = 0; i < block_size; ++i) {
                  cosine[c][i] = value[c][i] * block.real[i];
                  sine[c][i] = value[c][i] * block.imaginary[i];
                }
              }
              table.analyse(m, block.z, group, cosine, sine, part + table.start(m) * 2 * group);
            }
          }
        },
        [&](std::size_t n) {
          const std::span<double> total = sum.values();
          for (std::size_t k = 0; k < n; ++k) {
            for (std::size_t j = 0; j < length; ++j)
              total[j] += parts[k * length + j];
          }
        });
    sum.unpack(coefficients.values, coefficients.degree, channels, from);
  }
}

}  // namespace orbicube::harmonics
