// Marks a function whose loops are worth wider vector instructions: on x86 it is compiled for AVX2 as well and chosen
// when the library is loaded. Contraction to fused operations is off, so every variant gives the same bits. Not on
// templates, and what the function calls must be inlined into it to profit.
#pragma once

#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__GLIBC__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define ORBICUBE_VECTOR_VARIANTS __attribute__((target_clones("avx2", "default")))
#else
#define ORBICUBE_VECTOR_VARIANTS
#endif
