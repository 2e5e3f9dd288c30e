// Numbers for people.
#pragma once

#include <cstdio>
#include <string>

namespace orbicube::cli {

// Four digits.
inline std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

}  // namespace orbicube::cli
