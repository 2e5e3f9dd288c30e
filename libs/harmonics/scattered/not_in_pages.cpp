// The module of WebAssembly has the sums themselves only, for its size.
#include "harmonics/fitting/large_fit.h"
#include "harmonics/scattered/fast_sums.h"

namespace orbicube::harmonics {

bool synthesise_fast(const Coefficients& /*coefficients*/, std::span<const Vector3> /*unit*/,
                     std::span<double> /*values*/, const char* /*phase*/, const base::Host& /*host*/) {
  return false;
}

bool analyse_fast(std::span<const Vector3> /*unit*/, std::span<const double> /*weights*/,
                  std::span<const double> /*values*/, Coefficients& /*coefficients*/, const char* /*phase*/,
                  const base::Host& /*host*/) {
  return false;
}

bool fit_large(const FitSamples& /*samples*/, const FitOptions& /*options*/, const base::Host& /*host*/,
               Coefficients& /*coefficients*/, FitReport& /*report*/) {
  return false;
}

}  // namespace orbicube::harmonics
