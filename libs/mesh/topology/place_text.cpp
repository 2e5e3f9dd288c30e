#include "mesh/topology/place_text.h"

#include <fast_float/fast_float.h>
#include <array>
#include <cmath>
#include <cstdio>
#include <system_error>

namespace orbicube::mesh {
namespace {

// Takes "(x, y, z)" from the front of a text. Returns false, and leaves the text, where it does not begin with a place.
bool take_place(std::string_view& text, Vector3& p) {
  std::string_view rest = text;
  for (int axis = 0; axis < 3; ++axis) {
    const std::string_view before = axis == 0 ? "(" : ", ";
    if (!rest.starts_with(before)) return false;
    rest.remove_prefix(before.size());
    const auto [end, problem] = fast_float::from_chars(rest.data(), rest.data() + rest.size(), p[axis]);
    if (problem != std::errc()) return false;
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  }
  if (!rest.starts_with(')')) return false;
  text = rest.substr(1);
  return true;
}

}  // namespace

std::string place_text(const Vector3& p) {
  std::array<char, 120> text{};
  std::snprintf(text.data(), text.size(), "(%.9g, %.9g, %.9g)", p[0], p[1], p[2]);
  return text.data();
}

std::string scaled_places(std::string_view message, int exponent) {
  std::string result;
  while (!message.empty()) {
    Vector3 p;
    if (result.ends_with(' ') && take_place(message, p)) {
      for (double& x : p)
        x = std::ldexp(x, exponent);
      result += place_text(p);
    } else {
      result += message.front();
      message.remove_prefix(1);
    }
  }
  return result;
}

}  // namespace orbicube::mesh
