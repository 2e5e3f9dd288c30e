// How elementary functions round on this machine, which the last bits of a study's results depend on.
#pragma once

#include <string>

namespace orbicube::cli {

// Returns a digest of the values of sin, cos, tan, asin, acos, atan2, exp, exp2, log, log2, log10, pow, cbrt and hypot
// at 16,384 fixed arguments each, as a text of 16 digits. It differs between C libraries that round otherwise, and
// between processors for which one library has different functions, as glibc with and without FMA instructions. It does
// not cover what the compiler has made of this program.
const std::string& rounding_digest();

}  // namespace orbicube::cli
