#include "harmonics/fitting/gauss_grid.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/vector_variants.h"
#include "harmonics/functions/gauss_legendre.h"

namespace orbicube::harmonics {
namespace {

constexpr const char* gauss_grid_phase = "fitting";
constexpr std::size_t width = 16;
using Column = std::array<double, width>;
using base::Four, base::load, base::store;

// Sums over every other degree of cosine and sine coefficients times the columns.
ORBICUBE_VECTOR_VARIANTS
void add_columns(const double* packed, std::size_t count, const double* column, double* cosine, double* sine) {
  Four c[4] = {}, s[4] = {};
  for (std::size_t l = 0; l < count; l += 2) {
    for (std::size_t r = 0; r < 4; ++r) {
      const Four value = load(column + l * width + 4 * r);
      c[r] += packed[2 * l] * value;
      s[r] += packed[2 * l + 1] * value;
    }
  }
  for (std::size_t r = 0; r < 4; ++r) {
    store(cosine + 4 * r, c[r]);
    store(sine + 4 * r, s[r]);
  }
}

// The transpose: adds to sums of four lanes each, [degree][cosine, sine][lane].
ORBICUBE_VECTOR_VARIANTS
void add_products(const double* cosine, const double* sine, std::size_t count, const double* column, double* sums) {
  Four c[4], s[4];
  for (std::size_t r = 0; r < 4; ++r) {
    c[r] = load(cosine + 4 * r);
    s[r] = load(sine + 4 * r);
  }
  for (std::size_t l = 0; l < count; l += 2) {
    const double* value = column + l * width;
    double* to = sums + 8 * l;
    const Four q[4] = {load(value), load(value + 4), load(value + 8), load(value + 12)};
    store(to, load(to) + ((c[0] * q[0] + c[1] * q[1]) + (c[2] * q[2] + c[3] * q[3])));
    store(to + 4, load(to + 4) + ((s[0] * q[0] + s[1] * q[1]) + (s[2] * q[2] + s[3] * q[3])));
  }
}

ORBICUBE_VECTOR_VARIANTS
void multiply_lanes(const ComplexLanes* density, std::size_t count, ComplexLanes* data) {
  for (std::size_t j = 0; j < count; ++j) {
    for (std::size_t i = 0; i < fourier_lanes; ++i) {
      data[j].real[i] *= density[j].real[i];
      data[j].imaginary[i] *= density[j].imaginary[i];
    }
  }
}

// Where the pairs l, m start in the order of `packed`.
std::size_t order_start(std::uint32_t m, std::uint32_t degree) {
  return std::size_t{m} * (2 * std::size_t{degree} + 3 - m) / 2;
}

// Coefficients of `channels` functions times the scales of the recurrence, or the transpose.
void scale_order(const OrderRecurrence& recurrence, std::size_t channels, double* packed) {
  for (std::size_t c = 0; c < channels; ++c) {
    for (std::size_t l = 0; l < recurrence.count(); ++l, packed += 2) {
      packed[0] *= recurrence.scales()[l];
      packed[1] *= recurrence.scales()[l];
    }
  }
}

}  // namespace

GaussGrid::GaussGrid(std::uint32_t degree, const base::Host& host)
    : host_(host),
      degree_(degree),
      fourier_(FourierTransform::fitting_length(4 * std::size_t{degree} + 1), host.memory),
      pairs_((degree + lanes) / lanes * lanes, host.memory),
      weight_(pairs_.padded(), host.memory),
      powers_((degree + std::size_t{1}) * pairs_.padded(), host.memory),
      slots_(host),
      spectra_(host.memory),
      series_(2 * slots_.count() * fourier_.length(), host.memory),
      work_(host.memory),
      packed_(host.memory) {
  static_assert(lanes == width);
  const std::size_t circles = 2 * std::size_t{degree} + 1;
  Array<long double> angle(degree + std::size_t{1}, host.memory);
  Array<double> weight(circles, host.memory), rest(pairs_.padded(), host.memory);
  gauss_legendre_angles(angle, weight, [&] { host.report(gauss_grid_phase, 0, 0); });
  for (std::size_t t = 0; t <= degree; ++t) {
    pairs_.set(t, angle[t]);
    // The equator is a circle and its opposite.
    weight_[t] = weight[t] * (t == degree ? 0.5 : 1) * 2 * std::numbers::pi / static_cast<double>(longitudes());
  }
  pairs_.powers(0, degree + std::size_t{1}, 0, powers_.data(), rest.data());
}

Array<GaussGrid::Work> GaussGrid::make_work(std::uint32_t degree, std::size_t channels) {
  Array<Work> work(host_.memory);
  work.reserve(slots_.count());
  for (std::size_t k = 0; k < slots_.count(); ++k) {
    work.push_back({OrderRecurrence(degree, host_.memory),
                    Array<double>((degree + std::size_t{1}) * (width + 8 * channels), host_.memory)});
  }
  return work;
}

// Writes the spectra of the circles of one order.
void GaussGrid::synthesize_order(Work& work, std::uint32_t m, double* packed, std::size_t channels) {
  work.recurrence.set_order(m);
  scale_order(work.recurrence, channels, packed);
  const std::size_t count = work.recurrence.count(), groups = group_count();
  const std::size_t first = pairs_.first_pair(m, work.recurrence.degree()) / lanes * lanes;
  const double *start = power(m / 2), *end = power(m - m / 2);
  double* column = work.column.data();
  ComplexLanes* positive = spectrum(m > 0 ? 2 * std::size_t{m} - 1 : 0, channels);
  ComplexLanes* negative = spectrum(2 * std::size_t{m}, channels);
  for (std::size_t c = 0; c < channels; ++c) {
    std::fill_n(positive + c * groups, first / fourier_lanes, ComplexLanes{});
    if (m > 0) std::fill_n(negative + c * groups, first / fourier_lanes, ComplexLanes{});
  }
  for (std::size_t block = first; block < pairs_.padded(); block += lanes) {
    const std::size_t to = block / fourier_lanes;
    pairs_.columns(work.recurrence, start, block, column);
    Column factor;
    for (std::size_t i = 0; i < lanes; ++i)
      factor[i] = (m > 0 ? 0.5 : 1) * end[block + i];
    for (std::size_t c = 0; c < channels; ++c) {
      const double* from = packed + c * 2 * count;
      Column even_cosine, even_sine, odd_cosine{}, odd_sine{};
      add_columns(from, count, column, even_cosine.data(), even_sine.data());
      if (count > 1) add_columns(from + 2, count - 1, column + width, odd_cosine.data(), odd_sine.data());
      for (std::size_t i = 0; i < lanes; ++i) {
        // c_m - i s_m of the circle z, and of the circle -z, which is i times that.
        const double a = (even_cosine[i] + odd_cosine[i]) * factor[i], b = -(even_sine[i] + odd_sine[i]) * factor[i];
        const double p = (even_cosine[i] - odd_cosine[i]) * factor[i], q = -(even_sine[i] - odd_sine[i]) * factor[i];
        const std::size_t at = c * groups + to + i / fourier_lanes, lane = i % fourier_lanes;
        if (m > 0) {
          negative[at].real[lane] = a + q;
          negative[at].imaginary[lane] = p - b;
        }
        positive[at].real[lane] = a - q;
        positive[at].imaginary[lane] = b + p;
      }
    }
  }
}

// The transpose: writes the coefficients.
void GaussGrid::analyze_order(Work& work, std::uint32_t m, double* packed, std::size_t channels) {
  work.recurrence.set_order(m);
  const std::size_t count = work.recurrence.count(), groups = group_count();
  const double *start = power(m / 2), *end = power(m - m / 2);
  double *column = work.column.data(), *sums = column + count * width;  // [channel][degree][cosine, sine][lane]
  std::fill_n(sums, channels * count * 8, 0.0);
  const ComplexLanes* positive = spectrum(m > 0 ? 2 * std::size_t{m} - 1 : 0, channels);
  const ComplexLanes* negative = spectrum(2 * std::size_t{m}, channels);
  for (std::size_t block = pairs_.first_pair(m, degree_) / lanes * lanes; block < pairs_.padded(); block += lanes) {
    pairs_.columns(work.recurrence, start, block, column);
    for (std::size_t c = 0; c < channels; ++c) {
      Column even_cosine, even_sine, odd_cosine, odd_sine;
      for (std::size_t i = 0; i < lanes; ++i) {
        const std::size_t at = c * groups + block / fourier_lanes + i / fourier_lanes, lane = i % fourier_lanes;
        const ComplexLanes &plus = positive[at], &minus = negative[at];
        const double factor = 0.5 * end[block + i];
        const double a = factor * (plus.real[lane] + minus.real[lane]);
        const double b = factor * (minus.imaginary[lane] - plus.imaginary[lane]);
        const double p = factor * (plus.imaginary[lane] + minus.imaginary[lane]);
        const double q = factor * (plus.real[lane] - minus.real[lane]);
        even_cosine[i] = a + p;
        even_sine[i] = b + q;
        odd_cosine[i] = a - p;
        odd_sine[i] = b - q;
      }
      double* to = sums + c * count * 8;
      add_products(even_cosine.data(), even_sine.data(), count, column, to);
      if (count > 1) add_products(odd_cosine.data(), odd_sine.data(), count - 1, column + width, to + 8);
    }
  }
  for (std::size_t j = 0; j < channels * count * 2; ++j)
    packed[j] = (sums[4 * j] + sums[4 * j + 1]) + (sums[4 * j + 2] + sums[4 * j + 3]);
  scale_order(work.recurrence, channels, packed);
}

// Spectra of all circles from packed_, which is scaled.
void GaussGrid::synthesize_orders(Array<Work>& work, std::uint32_t degree, std::size_t channels) {
  spectra_.resize((2 * std::size_t{degree} + 1) * channels * group_count());
  slots_.run_all(degree + std::size_t{1}, gauss_grid_phase, host_, [&](std::size_t m, std::size_t slot) {
    const auto order = static_cast<std::uint32_t>(m);
    synthesize_order(work[slot], order, packed_.data() + order_start(order, degree) * 2 * channels, channels);
  });
}

void GaussGrid::read_spectrum(std::size_t group, std::size_t channel, std::size_t channels, std::uint32_t degree,
                              ComplexLanes* data) {
  std::fill_n(data, longitudes(), ComplexLanes{});
  const std::size_t at = channel * group_count() + group;
  data[0] = spectrum(0, channels)[at];
  for (std::size_t m = 1; m <= degree; ++m) {
    data[m] = spectrum(2 * m - 1, channels)[at];
    data[longitudes() - m] = spectrum(2 * m, channels)[at];
  }
}

GaussGrid::Values GaussGrid::values(const Coefficients& function) {
  packed_.assign(order_start(function.degree + 1, function.degree) * 2, 0);
  for (std::uint32_t m = 0; m <= function.degree; ++m) {
    double* to = packed_.data() + order_start(m, function.degree) * 2;
    for (std::uint32_t l = m; l <= function.degree; ++l, to += 2) {
      to[0] = function.at(l, static_cast<std::int32_t>(m), 0);
      to[1] = m > 0 ? function.at(l, -static_cast<std::int32_t>(m), 0) : 0;
    }
  }
  Array<Work> work = make_work(function.degree, 1);
  synthesize_orders(work, function.degree, 1);
  Values values(group_count() * longitudes(), host_.memory);
  slots_.run_all(group_count(), gauss_grid_phase, host_, [&](std::size_t group, std::size_t slot) {
    ComplexLanes* data = values.data() + group * longitudes();
    read_spectrum(group, 0, 1, function.degree, data);
    ComplexLanes* scratch = series_.data() + 2 * slot * longitudes();
    if (fourier_.transform(1, data, scratch) == scratch) std::copy_n(scratch, longitudes(), data);
  });
  return values;
}

void GaussGrid::weigh(Values& values) const {
  for (std::size_t group = 0; group < group_count(); ++group) {
    for (std::size_t j = 0; j < longitudes(); ++j) {
      ComplexLanes& value = values[group * longitudes() + j];
      for (std::size_t i = 0; i < fourier_lanes; ++i) {
        value.real[i] *= weight_[group * fourier_lanes + i];
        value.imaginary[i] *= weight_[group * fourier_lanes + i];
      }
    }
  }
}

void GaussGrid::multiply(const Values& density, std::span<const double> c, std::size_t channels,
                         std::span<double> product) {
  const std::uint32_t degree = degree_;
  if (channels > work_channels_) work_ = make_work(degree, channels);
  work_channels_ = std::max(work_channels_, channels);
  packed_.resize(order_start(degree + 1, degree) * 2 * channels);
  const auto each = [&](const auto& copy) {
    for (std::uint32_t m = 0; m <= degree; ++m) {
      double* at = packed_.data() + order_start(m, degree) * 2 * channels;
      for (std::size_t channel = 0; channel < channels; ++channel) {
        for (std::uint32_t l = m; l <= degree; ++l, at += 2) {
          copy(at[0], basis_index(l, static_cast<std::int32_t>(m)) * channels + channel, true);
          copy(at[1], basis_index(l, -static_cast<std::int32_t>(m)) * channels + channel, m > 0);
        }
      }
    }
  };
  each([&](double& packed, std::size_t k, bool used) { packed = used ? c[k] : 0; });
  synthesize_orders(work_, degree, channels);
  slots_.run_all(group_count(), gauss_grid_phase, host_, [&](std::size_t group, std::size_t slot) {
    ComplexLanes* data = series_.data() + 2 * slot * longitudes();
    ComplexLanes* scratch = data + longitudes();
    for (std::size_t channel = 0; channel < channels; ++channel) {
      read_spectrum(group, channel, channels, degree, data);
      ComplexLanes* values = fourier_.transform(1, data, scratch);
      multiply_lanes(density.data() + group * longitudes(), longitudes(), values);
      values = fourier_.transform(-1, values, values == data ? scratch : data);
      const std::size_t at = channel * group_count() + group;
      spectrum(0, channels)[at] = values[0];
      for (std::size_t m = 1; m <= degree; ++m) {
        spectrum(2 * m - 1, channels)[at] = values[m];
        spectrum(2 * m, channels)[at] = values[longitudes() - m];
      }
    }
  });
  slots_.run_all(degree + std::size_t{1}, gauss_grid_phase, host_, [&](std::size_t m, std::size_t slot) {
    const auto order = static_cast<std::uint32_t>(m);
    analyze_order(work_[slot], order, packed_.data() + order_start(order, degree) * 2 * channels, channels);
  });
  each([&](double& packed, std::size_t k, bool used) {
    if (used) product[k] = packed;
  });
}

}  // namespace orbicube::harmonics
