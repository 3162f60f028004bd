// LIPPMANN_MULTIVERSION before a function definition compiles it once per instruction set (AVX-512, AVX2, baseline) and
// picks at load time; LIPPMANN_INLINE marks the small functions that such kernels are made of.
//
// Inside, write plain loops over lanes or pixels: the compiler vectorises them for each set. Only what is inlined gets the
// wide instructions, hence LIPPMANN_INLINE. -ffp-contract=off (cmake/options.cmake) keeps all versions bit-identical.
#pragma once

#if defined(LIPPMANN_NO_MULTIVERSION) || !defined(__x86_64__)
#define LIPPMANN_MULTIVERSION
#else
#define LIPPMANN_MULTIVERSION __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#endif

#define LIPPMANN_INLINE_LAMBDA __attribute__((always_inline))
#define LIPPMANN_INLINE inline __attribute__((always_inline))
