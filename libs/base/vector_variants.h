// Marks a function whose loops are worth wider vector instructions: on x86 it is compiled for AVX2 as well and chosen
// when the library is loaded. Contraction to fused operations is off, so every variant gives the same bits. Not on
// templates, and what the function calls must be inlined into it to profit.
#pragma once

#include <cstring>

#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__GLIBC__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define ORBICUBE_VECTOR_VARIANTS __attribute__((target_clones("avx2", "default")))
#else
#define ORBICUBE_VECTOR_VARIANTS
#endif

// Marks what such a function calls.
#if defined(__GNUC__)
#define ORBICUBE_INLINE inline __attribute__((always_inline))
#else
#define ORBICUBE_INLINE inline
#endif

namespace orbicube::base {

// Four numbers that are worked on at once: one vector register where there is AVX2, else two.
using Four = double __attribute__((vector_size(32)));

ORBICUBE_INLINE Four load(const double* from) {
  Four four;
  std::memcpy(&four, from, sizeof four);
  return four;
}
ORBICUBE_INLINE void store(double* to, Four four) {
  std::memcpy(to, &four, sizeof four);
}

}  // namespace orbicube::base
