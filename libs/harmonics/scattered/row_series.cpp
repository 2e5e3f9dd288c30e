#include "harmonics/scattered/row_series.h"

#include <algorithm>

#include "base/vector_variants.h"

namespace orbicube::harmonics {
namespace {

using base::Four, base::load, base::store;

// One number of four rows, or of four columns.
struct SeriesBlock {
  Four a, b, c, d;
};

ORBICUBE_INLINE SeriesBlock transposed(const SeriesBlock& m) {
  const Four ab_low = __builtin_shufflevector(m.a, m.b, 0, 4, 2, 6),
             ab_high = __builtin_shufflevector(m.a, m.b, 1, 5, 3, 7);
  const Four cd_low = __builtin_shufflevector(m.c, m.d, 0, 4, 2, 6),
             cd_high = __builtin_shufflevector(m.c, m.d, 1, 5, 3, 7);
  return {__builtin_shufflevector(ab_low, cd_low, 0, 1, 4, 5), __builtin_shufflevector(ab_high, cd_high, 0, 1, 4, 5),
          __builtin_shufflevector(ab_low, cd_low, 2, 3, 6, 7), __builtin_shufflevector(ab_high, cd_high, 2, 3, 6, 7)};
}

// Pointers to the eight rows of a group of orders, and what they are multiplied with.
template <class Lanes>
struct GroupRows {
  std::array<Lanes*, rows_at_once> row;
  std::array<double, rows_at_once> sign;
};

// Four rows, every other one, of which each has four orders.
ORBICUBE_INLINE SeriesBlock real_parts(const GroupRows<const ComplexLanes>& g, std::size_t odd_row, std::size_t odd) {
  const auto at = [&](std::size_t i) __attribute__((always_inline)) {
    const std::size_t r = 2 * i + odd_row;
    return load(g.row[r][odd].real.data()) * (odd == 1 ? g.sign[r] : 1.0);
  };
  return transposed({at(0), at(1), at(2), at(3)});
}
ORBICUBE_INLINE SeriesBlock imaginary_parts(const GroupRows<const ComplexLanes>& g, std::size_t odd_row,
                                            std::size_t odd) {
  const auto at = [&](std::size_t i) __attribute__((always_inline)) {
    const std::size_t r = 2 * i + odd_row;
    return load(g.row[r][odd].imaginary.data()) * (odd == 1 ? g.sign[r] : 1.0);
  };
  return transposed({at(0), at(1), at(2), at(3)});
}

// Writes the spectrum of a group of orders from m on. `length`: of the transform.
ORBICUBE_VECTOR_VARIANTS
void write_spectrum(const GroupRows<const ComplexLanes>& g, const double* factor, std::size_t m, std::size_t count,
                    std::size_t length, ComplexLanes* data) {
  for (std::size_t odd = 0; odd < 2; ++odd) {
    const SeriesBlock a = real_parts(g, 0, odd), b = imaginary_parts(g, 0, odd);
    const SeriesBlock c = real_parts(g, 1, odd), d = imaginary_parts(g, 1, odd);
    const auto write = [&](std::size_t i, Four one, Four two, Four three, Four four) __attribute__((always_inline)) {
      const std::size_t k = m + 2 * i + odd;
      if (k >= count) return;
      const double f = factor[k];
      if (k > 0) {
        store(data[length - k].real.data(), f * (one + four));
        store(data[length - k].imaginary.data(), f * (three - two));
      }
      store(data[k].real.data(), f * (one - four));
      store(data[k].imaginary.data(), f * (two + three));
    };
    write(0, a.a, b.a, c.a, d.a);
    write(1, a.b, b.b, c.b, d.b);
    write(2, a.c, b.c, c.c, d.c);
    write(3, a.d, b.d, c.d, d.d);
  }
}

ORBICUBE_INLINE void add(ComplexLanes* to, std::size_t odd, double sign, Four real, Four imaginary) {
  const double s = odd == 1 ? sign : 1;
  store(to[odd].real.data(), load(to[odd].real.data()) + s * real);
  store(to[odd].imaginary.data(), load(to[odd].imaginary.data()) + s * imaginary);
}

// The transpose: adds.
ORBICUBE_VECTOR_VARIANTS
void add_spectrum(const ComplexLanes* data, const double* factor, std::size_t m, std::size_t count, std::size_t length,
                  const GroupRows<ComplexLanes>& g) {
  for (std::size_t odd = 0; odd < 2; ++odd) {
    SeriesBlock a, b, c, d;
    const auto read = [&](std::size_t i, Four & one, Four & two, Four & three, Four & four)
        __attribute__((always_inline)) {
      const std::size_t k = m + 2 * i + odd;
      one = two = three = four = Four{};
      if (k >= count) return;
      const double f = k > 0 ? factor[k] : 0.5 * factor[k];
      const ComplexLanes &x = data[k], &y = data[k > 0 ? length - k : 0];
      const Four xr = load(x.real.data()), xi = load(x.imaginary.data());
      const Four yr = load(y.real.data()), yi = load(y.imaginary.data());
      one = f * (xr + yr);
      two = f * (xi - yi);
      three = f * (xi + yi);
      four = f * (yr - xr);
    };
    read(0, a.a, b.a, c.a, d.a);
    read(1, a.b, b.b, c.b, d.b);
    read(2, a.c, b.c, c.c, d.c);
    read(3, a.d, b.d, c.d, d.d);
    a = transposed(a);
    b = transposed(b);
    c = transposed(c);
    d = transposed(d);
    add(g.row[0], odd, g.sign[0], a.a, b.a);
    add(g.row[1], odd, g.sign[1], c.a, d.a);
    add(g.row[2], odd, g.sign[2], a.b, b.b);
    add(g.row[3], odd, g.sign[3], c.b, d.b);
    add(g.row[4], odd, g.sign[4], a.c, b.c);
    add(g.row[5], odd, g.sign[5], c.c, d.c);
    add(g.row[6], odd, g.sign[6], a.d, b.d);
    add(g.row[7], odd, g.sign[7], c.d, d.d);
  }
}

// From lanes to rows `stride` numbers apart.
ORBICUBE_VECTOR_VARIANTS
void write_rows(const ComplexLanes* data, std::size_t count, std::size_t stride, double* to) {
  std::size_t p = 0;
  for (; p + 4 <= count; p += 4, data += 4, to += 4) {
    const SeriesBlock real = transposed(
        {load(data[0].real.data()), load(data[1].real.data()), load(data[2].real.data()), load(data[3].real.data())});
    const SeriesBlock imaginary = transposed({load(data[0].imaginary.data()), load(data[1].imaginary.data()),
                                              load(data[2].imaginary.data()), load(data[3].imaginary.data())});
    store(to, real.a);
    store(to + stride, imaginary.a);
    store(to + 2 * stride, real.b);
    store(to + 3 * stride, imaginary.b);
    store(to + 4 * stride, real.c);
    store(to + 5 * stride, imaginary.c);
    store(to + 6 * stride, real.d);
    store(to + 7 * stride, imaginary.d);
  }
  for (; p < count; ++p, ++data, ++to) {
    for (std::size_t i = 0; i < fourier_lanes; ++i) {
      to[2 * i * stride] = data->real[i];
      to[(2 * i + 1) * stride] = data->imaginary[i];
    }
  }
}

ORBICUBE_VECTOR_VARIANTS
void read_rows(const double* from, std::size_t count, std::size_t stride, ComplexLanes* data) {
  std::size_t p = 0;
  for (; p + 4 <= count; p += 4, data += 4, from += 4) {
    const SeriesBlock real =
        transposed({load(from), load(from + 2 * stride), load(from + 4 * stride), load(from + 6 * stride)});
    const SeriesBlock imaginary =
        transposed({load(from + stride), load(from + 3 * stride), load(from + 5 * stride), load(from + 7 * stride)});
    store(data[0].real.data(), real.a);
    store(data[0].imaginary.data(), imaginary.a);
    store(data[1].real.data(), real.b);
    store(data[1].imaginary.data(), imaginary.b);
    store(data[2].real.data(), real.c);
    store(data[2].imaginary.data(), imaginary.c);
    store(data[3].real.data(), real.d);
    store(data[3].imaginary.data(), imaginary.d);
  }
  for (; p < count; ++p, ++data, ++from) {
    for (std::size_t i = 0; i < fourier_lanes; ++i) {
      data->real[i] = from[2 * i * stride];
      data->imaginary[i] = from[(2 * i + 1) * stride];
    }
  }
}

}  // namespace

RowSeries::RowSeries(std::uint32_t degree, std::size_t columns, const SpreadingKernel& kernel, const base::Host& host)
    : degree_(degree), transform_(columns, host.memory), factor_(degree + std::size_t{1}, host.memory) {
  for (std::size_t m = 0; m <= degree; ++m)
    factor_[m] = (m > 0 ? 0.5 : 1) / kernel.transform(static_cast<double>(m) / static_cast<double>(columns));
}

RowSeries::Sources RowSeries::sources(std::ptrdiff_t first, std::size_t row_count) {
  Sources sources;
  const auto last = static_cast<std::ptrdiff_t>(row_count) - 1;
  for (std::size_t i = 0; i < rows_at_once; ++i) {
    const std::ptrdiff_t row = first + static_cast<std::ptrdiff_t>(i);
    const bool inside = row >= 0 && row <= last;
    sources.row[i] = static_cast<std::size_t>(row < 0 ? -row : row > last ? 2 * last - row : row);
    sources.sign[i] = inside ? 1 : -1;
  }
  return sources;
}

void RowSeries::synthesise(const OrderRows& orders, std::ptrdiff_t first, std::size_t margin, std::size_t stride,
                           double* to, ComplexLanes* work) const {
  const std::size_t length = transform_.length(), orders_used = degree_ + std::size_t{1};
  const Sources from = sources(first, orders.row_count);
  for (std::size_t group = 0; group < orders.group_count; ++group) {
    GroupRows<const ComplexLanes> rows;
    rows.sign = from.sign;
    for (std::size_t i = 0; i < rows_at_once; ++i)
      rows.row[i] = orders.at(group, from.row[i]);
    write_spectrum(rows, factor_.data(), group * orders_at_once, orders_used, length, work);
  }
  std::fill(work + orders_used, work + (length - degree_), ComplexLanes{});
  write_rows(transform_.transform(1, work, work + length), length, stride, to);
  for (std::size_t i = 0; i < rows_at_once; ++i, to += stride) {
    std::copy_n(to + (length - margin), margin, to - margin);
    std::copy_n(to, margin, to + length);
  }
}

void RowSeries::analyse(double* from, std::ptrdiff_t first, std::size_t margin, std::size_t stride, OrderRows& orders,
                        ComplexLanes* work) const {
  const std::size_t length = transform_.length(), orders_used = degree_ + std::size_t{1};
  double* row = from;
  for (std::size_t i = 0; i < rows_at_once; ++i, row += stride) {
    for (std::size_t c = 0; c < margin; ++c) {
      row[length - margin + c] += *(row - margin + c);
      row[c] += row[length + c];
    }
  }
  read_rows(from, length, stride, work);
  const ComplexLanes* data = transform_.transform(-1, work, work + length);
  const Sources to = sources(first, orders.row_count);
  for (std::size_t group = 0; group < orders.group_count; ++group) {
    GroupRows<ComplexLanes> rows;
    rows.sign = to.sign;
    for (std::size_t i = 0; i < rows_at_once; ++i)
      rows.row[i] = orders.at(group, to.row[i]);
    add_spectrum(data, factor_.data(), group * orders_at_once, orders_used, length, rows);
  }
}

}  // namespace orbicube::harmonics
