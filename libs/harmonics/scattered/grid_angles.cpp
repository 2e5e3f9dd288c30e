#include "harmonics/scattered/grid_angles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/vector_variants.h"
#include "harmonics/functions/exact_products.h"

namespace orbicube::harmonics {
namespace {

constexpr std::size_t lanes = GridAngles::at_once;
using Lanes64 = std::array<double, lanes>;

// Lines of the angles of (x, y), 0 to 2 pi, to 1e-5 radians (Hastings 1955): nearest or the one beside it.
ORBICUBE_VECTOR_VARIANTS
void nearest_lines(const Lanes64& x, const Lanes64& y, double scale, std::array<std::int32_t, lanes>& line) {
  for (std::size_t i = 0; i < lanes; ++i) {
    const double a = std::abs(x[i]), b = std::abs(y[i]);
    const double large = a > b ? a : b, small = a > b ? b : a;
    const double t = small / (large > 0 ? large : 1), s = t * t;
    double angle = t * (0.9998660 + s * (-0.3302995 + s * (0.1801410 + s * (-0.0851330 + s * 0.0208351))));
    angle = b > a ? std::numbers::pi / 2 - angle : angle;
    angle = x[i] < 0 ? std::numbers::pi - angle : angle;
    angle = y[i] < 0 ? 2 * std::numbers::pi - angle : angle;
    line[i] = static_cast<std::int32_t>(angle * scale + 0.5);
  }
}

// More than the rest can be from the nearest line or the one beside it.
constexpr double most = 0.51;

// Numbers in two parts.
struct Parts {
  Lanes64 high, low;
};

// The angle from the line (c, s) to (x, y), in lines. The numerator is what is left of two products.
ORBICUBE_VECTOR_VARIANTS
void rest_angles(const Parts& x, const Parts& y, const Parts& c, const Parts& s, double scale, Lanes64& rest) {
  for (std::size_t i = 0; i < lanes; ++i) {
    const TwoParts p = exact_product(y.high[i], c.high[i]), q = exact_product(x.high[i], s.high[i]);
    const double low =
        (p.low - q.low) + (y.high[i] * c.low[i] - x.high[i] * s.low[i]) + (y.low[i] * c.high[i] - x.low[i] * s.high[i]);
    const double across = (p.high - q.high) + low, along = x.high[i] * c.high[i] + y.high[i] * s.high[i];
    const double t = across / (along > 0 ? along : 1), u = t * t;
    const double series = 1 - u * (1. / 3 - u * (1. / 5 - u * (1. / 7 - u * (1. / 9 - u * (1. / 11 - u * (1. / 13))))));
    const double lines = t * series * scale;
    // Beside a pole, quotients of the smallest numbers may be anything.
    rest[i] = lines > most ? most : lines < -most ? -most : lines;
  }
}

// sqrt(x^2 + y^2) in two parts.
ORBICUBE_VECTOR_VARIANTS
void set_radii(const Lanes64& x, const Lanes64& y, Parts& radius) {
  for (std::size_t i = 0; i < lanes; ++i) {
    const TwoParts a = exact_product(x[i], x[i]), b = exact_product(y[i], y[i]);
    const double r = std::sqrt(a.high + b.high);
    const TwoParts square = exact_product(r, r);
    const double large = a.high > b.high ? a.high : b.high, small = a.high > b.high ? b.high : a.high;
    const double left = ((large - square.high) + small) + (a.low + b.low - square.low);
    radius.high[i] = r;
    radius.low[i] = 0.5 * left / (r > 0 ? r : 1);
  }
}

}  // namespace

GridAngles::GridAngles(std::size_t rows, std::size_t columns, std::pmr::memory_resource* memory)
    : rows_(rows, memory), columns_(columns, memory) {
  fill(rows_);
  fill(columns_);
}

void GridAngles::fill(Array<Line>& lines) {
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const long double angle =
        2 * std::numbers::pi_v<long double> * static_cast<long double>(k) / static_cast<long double>(lines.size());
    const long double c = std::cos(angle), s = std::sin(angle);
    Line& line = lines[k];
    line.cosine = static_cast<double>(c);
    line.sine = static_cast<double>(s);
    line.cosine_rest = static_cast<double>(c - static_cast<long double>(line.cosine));
    line.sine_rest = static_cast<double>(s - static_cast<long double>(line.sine));
  }
}

void GridAngles::compute(std::span<const Vector3> unit, GridPlace* row, GridPlace* column) const {
  Parts x{}, y{}, z{}, radius, c, s;
  z.high.fill(1);
  for (std::size_t i = 0; i < unit.size(); ++i) {
    x.high[i] = unit[i].x();
    y.high[i] = unit[i].y();
    z.high[i] = unit[i].z();
  }
  set_radii(x.high, y.high, radius);
  const auto place = [&](const Array<Line>& lines, const Parts& along, const Parts& across, GridPlace* to) {
    const double scale = static_cast<double>(lines.size()) / (2 * std::numbers::pi);
    std::array<std::int32_t, lanes> line;
    Lanes64 rest;
    nearest_lines(along.high, across.high, scale, line);
    for (std::size_t i = 0; i < lanes; ++i) {
      const auto k = static_cast<std::size_t>(line[i]);
      const Line& at = lines[k < lines.size() ? k : 0];
      c.high[i] = at.cosine;
      s.high[i] = at.sine;
      c.low[i] = at.cosine_rest;
      s.low[i] = at.sine_rest;
    }
    rest_angles(along, across, c, s, scale, rest);
    for (std::size_t i = 0; i < unit.size(); ++i)
      to[i] = {line[i], rest[i]};
  };
  place(columns_, x, y, column);
  place(rows_, z, radius, row);
}

}  // namespace orbicube::harmonics
