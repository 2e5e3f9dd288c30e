// Names of the values of an enumeration that counts from 0, by a table.
#pragma once

#include <cstddef>

namespace orbicube::base {

// "unknown" for a value that is not in the table.
template <class Value, std::size_t count>
constexpr const char* name_of(Value value, const char* const (&names)[count]) {
  const auto index = static_cast<std::size_t>(value);
  return index < count ? names[index] : "unknown";
}

}  // namespace orbicube::base
