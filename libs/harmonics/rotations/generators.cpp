#include "harmonics/rotations/generators.h"

#include <cmath>
#include <numbers>

namespace orbicube::harmonics {
namespace {

Coefficients about_z(const Coefficients& g) {
  Coefficients x(g.degree, g.channels, g.values.get_allocator().resource());
  for (std::uint32_t l = 1; l <= g.degree; ++l) {
    for (std::int32_t m = 1; m <= static_cast<std::int32_t>(l); ++m) {
      for (std::size_t c = 0; c < g.channels; ++c) {
        x.at(l, m, c) = -m * g.at(l, -m, c);
        x.at(l, -m, c) = m * g.at(l, m, c);
      }
    }
  }
  return x;
}

// The derivative of Wigner's functions at 0, which lead from an order to its neighbors.
Coefficients about_y(const Coefficients& g) {
  Coefficients x(g.degree, g.channels, g.values.get_allocator().resource());
  for (std::uint32_t l = 1; l <= g.degree; ++l) {
    for (std::int32_t m = 0; m < static_cast<std::int32_t>(l); ++m) {
      const double step = 0.5 * std::sqrt((double(l) - m) * (double(l) + m + 1)) * (m == 0 ? std::numbers::sqrt2 : 1);
      for (std::size_t c = 0; c < g.channels; ++c) {
        x.at(l, m + 1, c) += step * g.at(l, m, c);
        x.at(l, m, c) -= step * g.at(l, m + 1, c);
        if (m == 0) continue;
        x.at(l, -m - 1, c) += step * g.at(l, -m, c);
        x.at(l, -m, c) -= step * g.at(l, -m - 1, c);
      }
    }
  }
  return x;
}

// By `quarters` quarters of a turn about z, without rounding.
Coefficients quarter_turns(const Coefficients& g, std::int32_t quarters) {
  Coefficients turned = g.copy();
  constexpr std::array<double, 4> cosine = {1, 0, -1, 0};
  for (std::uint32_t l = 1; l <= g.degree; ++l) {
    for (std::int32_t m = 1; m <= static_cast<std::int32_t>(l); ++m) {
      const auto turn = static_cast<std::size_t>((m * quarters % 4 + 4) % 4);
      const double c = cosine[turn], s = cosine[(turn + 3) % 4];
      for (std::size_t k = 0; k < g.channels; ++k) {
        turned.at(l, m, k) = c * g.at(l, m, k) - s * g.at(l, -m, k);
        turned.at(l, -m, k) = s * g.at(l, m, k) + c * g.at(l, -m, k);
      }
    }
  }
  return turned;
}

}  // namespace

std::array<Coefficients, 3> generators(const Coefficients& g) {
  // The x axis is the y axis turned back by a quarter.
  return {quarter_turns(about_y(quarter_turns(g, 1)), -1), about_y(g), about_z(g)};
}

}  // namespace orbicube::harmonics
