// Numbers with the noun that they count, for messages: "1 face", "2 faces".
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>

namespace orbicube::base {

// Returns the number and, after a space, `one` where it is 1, else `many`. Either may go on with a verb.
std::string counted_text(std::int64_t number, std::string_view one, std::string_view many);
// Of a noun whose plural ends in s.
std::string counted_text(std::int64_t number, std::string_view one);

template <std::integral Number>
std::string counted(Number number, std::string_view one, std::string_view many) {
  return counted_text(static_cast<std::int64_t>(number), one, many);
}

template <std::integral Number>
std::string counted(Number number, std::string_view one) {
  return counted_text(static_cast<std::int64_t>(number), one);
}

}  // namespace orbicube::base
