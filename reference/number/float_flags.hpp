// Refuses compilers' flags under which doubles are not computed as written. Every header that
// counts on exact doubles includes this file, since its inline code is compiled with the includer's
// flags.
//
// gcc names such flags in macros. clang names -ffast-math and -ffinite-math-only only; the start of
// the program finds the rest (float_self_test.hpp). Contraction to fused multiply-add is no fault:
// the code here is right with it and without it.
#pragma once

#include <cfloat>
#include <cmath>
#include <limits>

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error \
    "minkref needs doubles computed as written: compile without -ffast-math, -Ofast, \
-funsafe-math-optimizations, -fassociative-math, -freciprocal-math and -ffinite-math-only"
#endif
static_assert(FLT_EVAL_METHOD == 0,
              "minkref needs doubles computed in double precision: compile for SSE2 or a later "
              "unit, without -mfpmath=387");
static_assert(std::numeric_limits<double>::is_iec559, "minkref needs IEEE 754 doubles");
static_assert(1.0 + 0x1p-49 != 1.0,
              "minkref needs constants in double precision: compile without "
              "-fsingle-precision-constant");

// A fused multiply-add, where the instruction set has it, does the work of Dekker's product. As a
// function call it would cost more; and without the instruction the compiler cannot contract any
// part of that product.
#if defined(FP_FAST_FMA) || defined(__FP_FAST_FMA) || defined(__FMA__) || defined(__FMA4__) || \
    defined(__aarch64__) || defined(__ARM_FEATURE_FMA) || defined(__powerpc64__) ||            \
    defined(__s390x__) || defined(__riscv_d)
#define MINKREF_FAST_FMA 1
#else
#define MINKREF_FAST_FMA 0
#endif
