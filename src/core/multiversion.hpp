// LIPPMANN_MULTIVERSION before a function definition compiles the function once per instruction set (AVX-512, AVX2, baseline);
// the loader selects one version. LIPPMANN_INLINE marks the small functions inside such kernels.
//
// Write plain loops over lanes or pixels: the compiler vectorises them for each instruction set. Functions that are not inlined
// use only baseline instructions. -ffp-contract=off (cmake/options.cmake) keeps all versions bit-identical.
//
// Multiple versions need x86-64, glibc (whose loader resolves such functions), and GCC or Clang 19. Clang 14 has the attribute,
// but its resolver does not test for architecture levels.
#pragma once

#include <cstddef>

#if defined(LIPPMANN_NO_MULTIVERSION) || !defined(__x86_64__) || !defined(__GLIBC__) || \
    (defined(__clang__) && __clang_major__ < 19)
#define LIPPMANN_MULTIVERSION
#else
#define LIPPMANN_MULTIVERSION __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#endif

#define LIPPMANN_INLINE_LAMBDA __attribute__((always_inline))
#define LIPPMANN_INLINE inline __attribute__((always_inline))
