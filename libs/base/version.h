#pragma once

#include <cstdint>

namespace orbicube::base {

// Version of the whole family, major * 10000 + minor * 100 + patch. A test compares it with meson.build.
inline constexpr int version_major = 0;
inline constexpr int version_minor = 1;
inline constexpr int version_patch = 0;
inline constexpr std::uint32_t version_number = version_major * 10000 + version_minor * 100 + version_patch;
inline constexpr const char* version_text = "0.1.0";

}  // namespace orbicube::base
