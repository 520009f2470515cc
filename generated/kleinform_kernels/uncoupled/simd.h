/* Generated from derivations/ by "make derive"; do not edit.
   SPDX-License-Identifier: BSD-3-Clause */
/* What loops over lanes need of the compiler, and which instructions the machine has. */
#ifndef KLEINFORM_SIMD_H
#define KLEINFORM_SIMD_H

#include <string.h>

/* Poses that a lane function takes at once: a few SIMD registers of any machine. */
#define LANES 16

/* Functions of one set of instructions, VARIANT, have its name at their end. */
#define KLEINFORM_PASTE(name, variant) name##_##variant
#define KLEINFORM_EXPAND(name, variant) KLEINFORM_PASTE(name, variant)
#define VARIANT_OF(name) KLEINFORM_EXPAND(name, VARIANT)

#if defined(__cplusplus) || defined(_MSC_VER)
#define RESTRICT __restrict
#else
#define RESTRICT restrict
#endif

/* A loop over lanes is vectorised only if all that it calls is inlined, and if the compiler
   need not prove that lanes are independent. */
#if defined(__GNUC__)
#define INLINE static inline __attribute__((always_inline))
#define ALIGNED __attribute__((aligned(64)))
#define SIMD _Pragma("omp simd")
#elif defined(_MSC_VER)
#define INLINE static __forceinline
#define ALIGNED __declspec(align(64))
#define SIMD __pragma(loop(ivdep))
#else
#define INLINE static inline
#define ALIGNED
#define SIMD
#endif

/* Whether this machine has the instructions of a variant, and this build has the variant. */
INLINE int simd_supported(const char *variant)
{
#ifdef KLEINFORM_X86
    __builtin_cpu_init();
    if (strcmp(variant, "avx512") == 0)
        return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
               __builtin_cpu_supports("avx512vl");
    if (strcmp(variant, "avx2") == 0)
        return __builtin_cpu_supports("avx2");
#endif
    return strcmp(variant, "baseline") == 0;
}

#endif
