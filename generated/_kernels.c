/* Written by `python -m derive` with SymPy 1.14.0; do not edit. */
#define DIGEST "e6b592ac3a4486ce4582755731e4e7c5f2614cc4dd575c3c5bff5288acdc962b"
/* Ufunc loops of the certified kernels.
 *
 * Every program stands here once, as an inline function of one alpha. Loops around it are compiled for several
 * processors, and the module offers those that can run here, the widest first. What a fused program asks for is one
 * rounding (fma); a plain program has none of that, so that no processor needs a library call. Nothing may be
 * reordered, contracted or flushed: the proofs are about these operations in this order. */
#define PY_SSIZE_T_CLEAN
#define NPY_NO_DEPRECATED_API NPY_2_0_API_VERSION
#include <Python.h>
#include <fenv.h>
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>
#include <numpy/arrayobject.h>
#include <numpy/ufuncobject.h>

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "unsafe float flags: compile without -ffast-math and its parts"
#endif
#if FLT_EVAL_METHOD != 0
#error "float64 arithmetic must round to float64"
#endif

#if defined(__GNUC__)
#define INLINE static inline __attribute__((always_inline))
#else
#define INLINE static __forceinline
#endif
#if defined(__clang__)
#define INDEPENDENT _Pragma("clang loop vectorize(assume_safety)")
#elif defined(__GNUC__)
#define INDEPENDENT _Pragma("GCC ivdep")
#else
#define INDEPENDENT
#endif

/* Levels: which program, compiled for what. */
#if defined(__GNUC__) && defined(__x86_64__)
#define LEVELS(X) X(avx512, fused) X(avx2, fused) X(baseline, plain)
#define TARGET_avx512 __attribute__((target("avx512f,avx512dq,avx512vl,avx2,fma,prefer-vector-width=512")))
#define TARGET_avx2 __attribute__((target("avx2,fma")))
#define RUNS_avx512 (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && \
                     __builtin_cpu_supports("avx512vl") && RUNS_avx2)
#define RUNS_avx2 (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
#elif defined(__GNUC__) && (defined(__FP_FAST_FMA) || defined(__aarch64__))
#define LEVELS(X) X(fma, fused) X(baseline, plain)
#define TARGET_fma
#define RUNS_fma 1
#else
#define LEVELS(X) X(baseline, plain)
#define NO_FMA
#endif
#define TARGET_baseline
#define RUNS_baseline 1

#define HALF_PI 0x1.921fb54442d18p+0
#define END_double 0x1.921fb54442d1ep+0 /* pi/2 (1 + 4 eps), with the eps of the type */
#define END_float 0x1.921fc1d5407bap+0
#define LAST_double UINT64_C(0x3ff921fb54442d18) /* pattern of the largest number of the type that is not above pi/2 */
#define LAST_float UINT32_C(0x3fc90fda)

enum { BLOCK = 128 };

typedef uint64_t PATTERN_double;
typedef uint32_t PATTERN_float;
INLINE PATTERN_double pattern_double(double x) { PATTERN_double u; memcpy(&u, &x, sizeof u); return u; }
INLINE PATTERN_float pattern_float(float x) { PATTERN_float u; memcpy(&u, &x, sizeof u); return u; }
#define NEGATIVE(u) ((u) >> (8 * sizeof(u) - 1))
#define bits pattern_double
INLINE double number(uint64_t u) { double x; memcpy(&x, &u, sizeof x); return x; }

/* x = significand * 2**exponent for a normal x > 0, significand in [3/4, 3/2), both exact. */
/* The biased exponent, of 3/4 that of 1: the patterns of 3/4 and 1 are half of one exponent apart. */
INLINE uint64_t biased(double x) { return (bits(x) + (UINT64_C(1) << 51)) >> 52; }
/* An integer k below 2**52 as a float64: the pattern of 2**52 + k, less 2**52. */
INLINE double exponent_of(double x) { return number(biased(x) | bits(0x1p52)) - (0x1p52 + 1023); }
INLINE double significand_of(double x) { return number(bits(x) - (biased(x) << 52) + bits(1.0)); }

#define SELECT(condition, yes, no) ((condition) ? (yes) : (no))
#define SMALLER(a, b) SELECT((a) < (b), a, b)
#define LARGER(a, b) SELECT((a) > (b), a, b)
/* A polynomial by Horner's scheme; its coefficients come lowest first. */
#define POLY1(x, c0, c1) FMA(c1, x, c0)
#define POLY2(x, c0, ...) FMA(POLY1(x, __VA_ARGS__), x, c0)
#define POLY3(x, c0, ...) FMA(POLY2(x, __VA_ARGS__), x, c0)
#define POLY4(x, c0, ...) FMA(POLY3(x, __VA_ARGS__), x, c0)
#define POLY5(x, c0, ...) FMA(POLY4(x, __VA_ARGS__), x, c0)
#define POLY6(x, c0, ...) FMA(POLY5(x, __VA_ARGS__), x, c0)
#define POLY7(x, c0, ...) FMA(POLY6(x, __VA_ARGS__), x, c0)
#define POLY8(x, c0, ...) FMA(POLY7(x, __VA_ARGS__), x, c0)
#define POLY9(x, c0, ...) FMA(POLY8(x, __VA_ARGS__), x, c0)
#define POLY10(x, c0, ...) FMA(POLY9(x, __VA_ARGS__), x, c0)
#define POLY11(x, c0, ...) FMA(POLY10(x, __VA_ARGS__), x, c0)
#define POLY12(x, c0, ...) FMA(POLY11(x, __VA_ARGS__), x, c0)
#define POLY13(x, c0, ...) FMA(POLY12(x, __VA_ARGS__), x, c0)
#define POLY14(x, c0, ...) FMA(POLY13(x, __VA_ARGS__), x, c0)
#define POLY15(x, c0, ...) FMA(POLY14(x, __VA_ARGS__), x, c0)
#define POLY16(x, c0, ...) FMA(POLY15(x, __VA_ARGS__), x, c0)
#define POLY17(x, c0, ...) FMA(POLY16(x, __VA_ARGS__), x, c0)
#define POLY18(x, c0, ...) FMA(POLY17(x, __VA_ARGS__), x, c0)
#define POLY19(x, c0, ...) FMA(POLY18(x, __VA_ARGS__), x, c0)
#define POLY20(x, c0, ...) FMA(POLY19(x, __VA_ARGS__), x, c0)
#define POLY21(x, c0, ...) FMA(POLY20(x, __VA_ARGS__), x, c0)
#define POLY22(x, c0, ...) FMA(POLY21(x, __VA_ARGS__), x, c0)
#define POLY23(x, c0, ...) FMA(POLY22(x, __VA_ARGS__), x, c0)

#ifndef NO_FMA
#undef FMA
#define FMA(a, b, c) __builtin_fma(a, b, c)

/* ln b of a b >= 0; at 0 something finite, which a factor 0 waits for. */
INLINE double logarithm_fused(double b)
{
    const double t1 = LARGER(b, 0x1.0000000000000p-60);
    const double t2 = significand_of(t1) - 1.0;
    const double t3 = t2 / (t2 + 2.0);
    const double t4 = t3 * t3;
    const double p1 = POLY6(t4, 0x1.55555555559d8p-1, 0x1.999999987c7a3p-2, 0x1.249249f1b0e53p-2,
        0x1.c71be01ef8d7bp-3, 0x1.747966b22b47ep-3, 0x1.3804595ac79edp-3, 0x1.3cda08c7927d8p-3);
    return FMA(t3, FMA(t4, p1, -t2), FMA(exponent_of(t1), 0x1.62e42fefa39efp-1, t2));
}

/* I_p* = (2*alpha - sin(alpha)*cos(alpha) - cos(alpha)**3*atanh(sin(alpha)))/3, 0 <= alpha <= pi/2, best, fused:
 * proved within 0.63 ulp (certificates/polar_moment.json) */
/* alpha < 1.06 */
INLINE double polar_moment_best_fused_near(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double t1 = -alpha_2;
    const double alpha_4 = alpha_2 * alpha_2;
    const double p1 = POLY5(alpha_4, 0x1.35581e11affcep-11, 0x1.f948b3dad684fp-20, 0x1.d3b86ab5c000bp-26,
        -0x1.47aac75a405bfp-28, -0x1.901eb3e3eb095p-28, -0x1.193b19ef5c23bp-30);
    const double p2 = POLY6(alpha_4, -0x1.ce55c8ea93fc3p-8, -0x1.08db39a994468p-15, 0x1.0b5b7c104b9c6p-24,
        0x1.9b302f0b75252p-27, 0x1.1b3183a5c4eddp-27, 0x1.bd01f9ca630bbp-29, 0x1.74252957b0351p-33);
    const double t2 = FMA(alpha_2, FMA(alpha_2, p1, p2), 0x1.d41d41d41d0e9p-5);
    const double t3 = FMA(t2, alpha_2, -0x1.1111111111110p-2);
    const double t4 = FMA(t3, alpha_2, 0x1.5555555555555p-1);
    const double t5 = -0x1.1111111111110p-2 - t3;
    const double t6 = FMA(t3, alpha_2, 0x1.5555555555555p-1 - t4) + 0x1.5555555555555p-55;
    const double t7 = alpha_2 * t4;
    const double t8 = FMA(t1, t5, FMA(2.0, t4, -0x1.5555555555555p-1));
    const double t9 = FMA(FMA(alpha, alpha, t1), t8, FMA(alpha_2, t4, -t7));
    return FMA(alpha, t7, alpha * FMA(alpha_2, FMA(alpha_2, FMA(t2, alpha_2, t5), t6), t9));
}
/* alpha >= 1.06, in b = pi/2 - alpha */
INLINE double polar_moment_best_fused_far(double alpha)
{
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p1 = POLY5(b_2, -0x1.213ce2316924dp-7, 0x1.94ebfb8ed1634p-4, -0x1.0ee08d6ddcdd4p-5,
        0x1.556fa69a4a6aep-8, -0x1.058191e40d3cfp-11, 0x1.142a50dc4a9dep-15);
    const double p2 = POLY5(b_2, 0x1.5555555554f26p-2, -0x1.55555559507f8p-3, 0x1.27d27519db656p-5,
        -0x1.2835c7b8e7a0fp-8, 0x1.80dd0f969ca49p-12, -0x1.b08fc34d11d4dp-16);
    const double t1 = FMA(b * b_2, FMA(p2, logarithm_fused(b), p1), 0x1.fab71f4a3269fp-7);
    return alpha + -0x1.1400000000000p-1 + t1;
}
INLINE double polar_moment_best_fused(double alpha)
{
    const double near = polar_moment_best_fused_near(alpha);
    const double far = polar_moment_best_fused_far(alpha);
    return SELECT(alpha < 0x1.0f5c28f5c28f6p+0, near, far);
}
#define polar_moment_best_fused_KIND pieces
#define polar_moment_best_fused_BELOW_double UINT64_C(0x3ff0f5c28f5c28f5)
#define polar_moment_best_fused_BELOW_float UINT32_C(0x3f87ae14)

/* I_p* = (2*alpha - sin(alpha)*cos(alpha) - cos(alpha)**3*atanh(sin(alpha)))/3, 0 <= alpha <= pi/2, 1e-10, fused:
 * proved within 6.69e-11 relative (certificates/polar_moment.json) */
INLINE double polar_moment_1e_10_fused(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double t1 = 0x1.3bd3cc9be45dep+1 - alpha_2;
    const double p1 = POLY7(t1, 0x1.14aca4167a07fp-2, 0x1.6f67e48f11997p+3, 0x1.705f937528711p+6,
        0x1.781f38b2a68b0p+7, 0x1.97881d28eb78fp+6, 0x1.15f5651c6c2b6p+4, 0x1.764b4fd12c227p+1,
        0x1.e250654a0fa79p-5);
    const double p2 = POLY7(t1, 1.0, 0x1.5185165bf6bccp+5, 0x1.47ee26059427dp+8, 0x1.283ecbb1b4392p+9,
        0x1.4ea305d69d8f6p+7, -0x1.444345493560ap+5, 0x1.b9bc468114fd2p+1, -0x1.efcbe37812bdfp-4);
    return p1 * alpha_2 / p2 * alpha;
}
#define polar_moment_1e_10_fused_KIND whole

/* I_p* = (2*alpha - sin(alpha)*cos(alpha) - cos(alpha)**3*atanh(sin(alpha)))/3, 0 <= alpha <= pi/2, 1e-6, fused:
 * proved within 6.63e-07 relative (certificates/polar_moment.json) */
INLINE double polar_moment_1e_6_fused(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY8(alpha_2, 0x1.555563e45ba3ep-1, -0x1.1116d4346c2b7p-2, 0x1.d5a56118ff0cbp-5,
        -0x1.f6c43e68063fbp-8, 0x1.a45a7a5b48d87p-10, -0x1.f017539ffdb0bp-11, 0x1.e6addd2fd57c1p-12,
        -0x1.01f8715011affp-13, 0x1.c6cb40d04487cp-17);
    return p1 * alpha_2 * alpha;
}
#define polar_moment_1e_6_fused_KIND short

/* I_p* = (2*alpha - sin(alpha)*cos(alpha) - cos(alpha)**3*atanh(sin(alpha)))/3, 0 <= alpha <= pi/2, float32,
 * fused: proved within 0.503 ulp (certificates/polar_moment.json) */
INLINE double polar_moment_float32_fused(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double t1 = 0x1.3bd3cc9be45dep+1 - alpha_2;
    const double p1 = POLY7(t1, 0x1.14aca415ff9bep-2, 0x1.0a493d7acae63p+3, 0x1.7e9225dc641bdp+5,
        0x1.1699441fb3d7bp+6, 0x1.db1c7a52b7740p+4, 0x1.933d9ee3bc318p+2, 0x1.dc0d095bd83c1p-1,
        0x1.06bac513c89bdp-4);
    const double p2 = POLY6(t1, 1.0, 0x1.e7e99b90416b4p+4, 0x1.4f42aae35dcb3p+7, 0x1.981502230ec47p+7,
        0x1.060efdd46e2e3p+5, -0x1.62e6200f03a08p+2, 0x1.d7d31fc8e0f2ap-3);
    return p1 * alpha_2 / p2 * alpha;
}
#define polar_moment_float32_fused_KIND whole

/* Theta* = alpha/2 - sin(2*alpha)/6 - sin(4*alpha)/24, 0 <= alpha <= pi/2, best, fused: proved within 0.864 ulp
 * (certificates/moment_of_inertia.json) */
/* alpha < 1.04 */
INLINE double moment_of_inertia_best_fused_near(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double t1 = -alpha_2;
    const double alpha_4 = alpha_2 * alpha_2;
    const double p1 = POLY3(alpha_4, 0x1.1f7d05c3f1e63p-8, 0x1.1f08650cd3114p-15, 0x1.941f1c14d0473p-24,
        0x1.a8ba4759b0fdap-34);
    const double p2 = POLY3(alpha_4, -0x1.f1029e62af137p-6, -0x1.d71606dd73949p-12, -0x1.0e1dd50de3f07p-19,
        -0x1.e71abb89b23b1p-29);
    const double t2 = FMA(alpha_2, FMA(alpha_2, p1, p2), 0x1.1e11e11e11a83p-3);
    const double t3 = FMA(t2, alpha_2, -0x1.999999999998fp-2);
    const double t4 = FMA(t3, alpha_2, 0x1.5555555555555p-1);
    const double t5 = -0x1.999999999998fp-2 - t3;
    const double t6 = FMA(t3, alpha_2, 0x1.5555555555555p-1 - t4) + 0x1.5555555555555p-55;
    const double t7 = alpha_2 * t4;
    const double t8 = FMA(t1, t5, FMA(2.0, t4, -0x1.5555555555555p-1));
    const double t9 = FMA(FMA(alpha, alpha, t1), t8, FMA(alpha_2, t4, -t7));
    return FMA(alpha, t7, alpha * FMA(alpha_2, FMA(alpha_2, FMA(t2, alpha_2, t5), t6), t9));
}
/* alpha >= 1.04, in b = pi/2 - alpha */
INLINE double moment_of_inertia_best_fused_far(double alpha)
{
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p1 = POLY8(b_2, -0x1.5555555555569p-3, -0x1.c71c71c71bd51p-3, 0x1.3e93e93e8513fp-2,
        -0x1.0cbb765f6105bp-3, 0x1.e94dfc180d8d8p-6, -0x1.1e5df77310522p-8, 0x1.d696da6d44e9dp-12,
        -0x1.1e264f7e219b6p-15, 0x1.f4ffb320b7c92p-20);
    return 0.5 * alpha + -0x1.1000000000000p-3 + FMA(b, p1, 0x1.1000000000000p-3);
}
INLINE double moment_of_inertia_best_fused(double alpha)
{
    const double near = moment_of_inertia_best_fused_near(alpha);
    const double far = moment_of_inertia_best_fused_far(alpha);
    return SELECT(alpha < 0x1.0a3d70a3d70a4p+0, near, far);
}
#define moment_of_inertia_best_fused_KIND pieces
#define moment_of_inertia_best_fused_BELOW_double UINT64_C(0x3ff0a3d70a3d70a3)
#define moment_of_inertia_best_fused_BELOW_float UINT32_C(0x3f851eb8)

/* Theta* = alpha/2 - sin(2*alpha)/6 - sin(4*alpha)/24, 0 <= alpha <= pi/2, 1e-10, fused: proved within 3.57e-12
 * relative (certificates/moment_of_inertia.json) */
INLINE double moment_of_inertia_1e_10_fused(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY9(alpha_2, 0x1.55555555502c0p-1, -0x1.99999996b5367p-2, 0x1.1e11e0d7b66ffp-3,
        -0x1.f10293cdf1d20p-6, 0x1.1f7c9cb90ff08p-8, -0x1.d70c8c3356105p-12, 0x1.1ec4f59c801cbp-15,
        -0x1.0bc4e9f8c08c4p-19, 0x1.7a7cb07e3408cp-24, -0x1.4936e56328342p-29);
    return p1 * alpha_2 * alpha;
}
#define moment_of_inertia_1e_10_fused_KIND short

/* Theta* = alpha/2 - sin(2*alpha)/6 - sin(4*alpha)/24, 0 <= alpha <= pi/2, 1e-6, fused: proved within 2.42e-07
 * relative (certificates/moment_of_inertia.json) */
INLINE double moment_of_inertia_1e_6_fused(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY6(alpha_2, 0x1.55554ffb45dfap-1, -0x1.999830f1f6825p-2, 0x1.1e017fc24dd09p-3,
        -0x1.efda754ae7b31p-6, 0x1.1a5c427a6780ap-8, -0x1.a6e3a2c99c515p-12, 0x1.50ef7c600437bp-16);
    return p1 * alpha_2 * alpha;
}
#define moment_of_inertia_1e_6_fused_KIND short

/* Theta* = alpha/2 - sin(2*alpha)/6 - sin(4*alpha)/24, 0 <= alpha <= pi/2, float32, fused: proved within 0.503 ulp
 * (certificates/moment_of_inertia.json) */
INLINE double moment_of_inertia_float32_fused(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY8(alpha_2, 0x1.55555554542e9p-1, -0x1.9999992647539p-2, 0x1.1e11d8503acb9p-3,
        -0x1.f1018ef94d003p-6, 0x1.1f74af1fc94e4p-8, -0x1.d6804e76da319p-12, 0x1.1be5d7f6ae24dp-15,
        -0x1.f4342ef238f03p-20, 0x1.049a5be9eb92ap-24);
    return p1 * alpha_2 * alpha;
}
#define moment_of_inertia_float32_fused_KIND short

/* C_r = sin(alpha) - cos(alpha)**2*atanh(sin(alpha)), 0 <= alpha <= pi/2, best, fused: proved within 0.717 ulp
 * (certificates/radial_weight_amplitude.json) */
/* alpha < 1.14 */
INLINE double radial_weight_amplitude_best_fused_near(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double t1 = -alpha_2;
    const double alpha_4 = alpha_2 * alpha_2;
    const double p1 = POLY7(alpha_4, -0x1.47d680513384ep-16, -0x1.01678419751a3p-18, -0x1.69604923282bfp-22,
        -0x1.c9c7a0d4325bbp-23, -0x1.98a0e625ac4aap-22, -0x1.0da38495dca49p-22, -0x1.808764f9c7467p-25,
        -0x1.118c1ab6478a7p-30);
    const double p2 = POLY7(alpha_4, -0x1.664f487ef01ffp-10, -0x1.07d71cad9a82ep-16, -0x1.1bab41746e402p-20,
        -0x1.5fa25ecf780ffp-28, 0x1.3c0c18c594a0bp-22, 0x1.7dcaed0b76a63p-22, 0x1.124061f8f1f6dp-23,
        0x1.4c4121214b1efp-27);
    const double t2 = FMA(alpha_2, FMA(alpha_2, p1, p2), 0x1.2b12b12b11157p-6);
    const double t3 = FMA(t2, alpha_2, -0x1.9999999999992p-3);
    const double t4 = FMA(t3, alpha_2, 0x1.5555555555555p-1);
    const double t5 = -0x1.9999999999992p-3 - t3;
    const double t6 = FMA(t3, alpha_2, 0x1.5555555555555p-1 - t4) + 0x1.5555555555555p-55;
    const double t7 = alpha_2 * t4;
    const double t8 = FMA(t1, t5, FMA(2.0, t4, -0x1.5555555555555p-1));
    const double t9 = FMA(FMA(alpha, alpha, t1), t8, FMA(alpha_2, t4, -t7));
    return FMA(alpha, t7, alpha * FMA(alpha_2, FMA(alpha_2, FMA(t2, alpha_2, t5), t6), t9));
}
/* alpha >= 1.14, in b = pi/2 - alpha */
INLINE double radial_weight_amplitude_best_fused_far(double alpha)
{
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p1 = POLY5(b_2, 0x1.d1bd0105cacaap-4, 0x1.2c981ff65e78ap-1, -0x1.5fec361a7a6e3p-4,
        0x1.c0fa7521974f7p-8, -0x1.5c87336390abap-12, 0x1.536149c083855p-17);
    const double p2 = POLY5(b_2, 0x1.0000000000175p+0, -0x1.55555554239ddp-2, 0x1.6c16c5c417f46p-5,
        -0x1.a013dfccb8a12p-9, 0x1.29896a4b09812p-13, -0x1.11c7f03358b1fp-18);
    const double t1 = FMA(b_2, FMA(p2, logarithm_fused(2.0 * b), p1), 0x1.3c095777a5d00p-6);
    return 0.5 * alpha + 0x1.9000000000000p-3 + FMA(b, FMA(b, -2.0, 0.5), t1);
}
INLINE double radial_weight_amplitude_best_fused(double alpha)
{
    const double near = radial_weight_amplitude_best_fused_near(alpha);
    const double far = radial_weight_amplitude_best_fused_far(alpha);
    return SELECT(alpha < 0x1.23d70a3d70a3dp+0, near, far);
}
#define radial_weight_amplitude_best_fused_KIND pieces
#define radial_weight_amplitude_best_fused_BELOW_double UINT64_C(0x3ff23d70a3d70a3c)
#define radial_weight_amplitude_best_fused_BELOW_float UINT32_C(0x3f91eb85)

/* C_r = sin(alpha) - cos(alpha)**2*atanh(sin(alpha)), 0 <= alpha <= pi/2, 1e-10, fused: proved within 5.86e-11
 * relative (certificates/radial_weight_amplitude.json) */
INLINE double radial_weight_amplitude_1e_10_fused(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double t1 = 0x1.3bd3cc9be45dep+1 - alpha_2;
    const double p1 = POLY10(t1, 0x1.08345eb49dfa4p-2, 0x1.40cc71ab82b17p+9, 0x1.c7fae97af9e1fp+17,
        0x1.2d9988866fd53p+24, 0x1.d131baf022e41p+28, 0x1.dda5739c64a89p+31, 0x1.6259be601aeb1p+33,
        0x1.8da34cb08e1f0p+33, 0x1.508e0e40facb6p+32, 0x1.83d173767ec99p+29, 0x1.04f7df6595ca2p+25);
    const double p2 = POLY10(t1, 1.0, 0x1.36c2b5ccd0c1fp+11, 0x1.b915276826f3cp+19, 0x1.22251312f6b79p+26,
        0x1.b7d217ea325d6p+30, 0x1.ae1c93f2d7caep+33, 0x1.18d58653a0677p+35, 0x1.c5d99f7e12cd1p+34,
        0x1.1ea89b013008dp+32, -0x1.cb6e4518cfd29p+28, 0x1.aed60df82a50dp+23);
    return p1 * alpha_2 / p2 * alpha;
}
#define radial_weight_amplitude_1e_10_fused_KIND whole

/* C_r = sin(alpha) - cos(alpha)**2*atanh(sin(alpha)), 0 <= alpha <= pi/2, 1e-6, fused: proved within 4.53e-07
 * relative (certificates/radial_weight_amplitude.json) */
INLINE double radial_weight_amplitude_1e_6_fused(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double t1 = 0x1.3bd3cc9be45dep+1 - alpha_2;
    const double p1 = POLY5(t1, 0x1.0834666ddd492p-2, 0x1.c85b59ccf7e43p+2, 0x1.bb4bf0c970e93p+4,
        0x1.816280b47e4c5p+4, 0x1.5c3fe8cc9aaa0p+2, 0x1.3cfcc3c3dc6ebp-2);
    const double p2 = POLY4(t1, 1.0, 0x1.b0786efcf9f8bp+4, 0x1.6d637ba392228p+6, 0x1.522412f400f39p+5,
        -0x1.3b15ecf57e019p+1);
    return p1 * alpha_2 / p2 * alpha;
}
#define radial_weight_amplitude_1e_6_fused_KIND short

/* C_r = sin(alpha) - cos(alpha)**2*atanh(sin(alpha)), 0 <= alpha <= pi/2, float32, fused: proved within 0.505 ulp
 * (certificates/radial_weight_amplitude.json) */
INLINE double radial_weight_amplitude_float32_fused(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double t1 = 0x1.3bd3cc9be45dep+1 - alpha_2;
    const double p1 = POLY9(t1, 0x1.08345eb56857ap-2, 0x1.3b6600d74bccbp+8, 0x1.b837b6270ce48p+15,
        0x1.1c70adff422e7p+21, 0x1.a80171a3e90ffp+24, 0x1.9d535830bdb5cp+26, 0x1.1b0db627b1ac4p+27,
        0x1.146d584af00dcp+26, 0x1.5866e2818eb1dp+23, 0x1.a41276abb9bcap+18);
    const double p2 = POLY9(t1, 1.0, 0x1.3173bf280d278p+10, 0x1.a919145cb9bd0p+17, 0x1.0f96e362556bdp+23,
        0x1.86838e8dc8106p+26, 0x1.573eb93a9e7aap+28, 0x1.61a66a4a4b7dfp+28, 0x1.1d5c0538d4588p+26,
        -0x1.c99f8ffd771f7p+22, 0x1.c1ec6782b793bp+17);
    return p1 * alpha_2 / p2 * alpha;
}
#define radial_weight_amplitude_float32_fused_KIND whole

/* C_theta = 2*sin(alpha)**3/3, 0 <= alpha <= pi/2, best, fused: proved within 0.733 ulp
 * (certificates/weight_moment_amplitude.json) */
/* alpha < 1.04 */
INLINE double weight_moment_amplitude_best_fused_near(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double t1 = -alpha_2;
    const double alpha_4 = alpha_2 * alpha_2;
    const double p1 = POLY3(alpha_4, 0x1.83c8978eb147ap-11, 0x1.eaeaa11069e73p-20, 0x1.b594a1501d7fep-30,
        0x1.2a361f9003235p-41);
    const double p2 = POLY3(alpha_4, -0x1.282ef4b666a5bp-7, -0x1.65f59e2b28380p-15, -0x1.03e502c0de95ep-24,
        -0x1.29c691f90f0d3p-35);
    const double t2 = FMA(alpha_2, FMA(alpha_2, p1, p2), 0x1.27d27d27d27a2p-4);
    const double t3 = FMA(t2, alpha_2, -0x1.5555555555555p-2);
    const double t4 = FMA(t3, alpha_2, 0x1.5555555555555p-1);
    const double t5 = -0x1.5555555555555p-2 - t3;
    const double t6 = FMA(t3, alpha_2, 0x1.5555555555555p-1 - t4) + 0x1.5555555555555p-55;
    const double t7 = alpha_2 * t4;
    const double t8 = FMA(t1, t5, FMA(2.0, t4, -0x1.5555555555555p-1));
    const double t9 = FMA(FMA(alpha, alpha, t1), t8, FMA(alpha_2, t4, -t7));
    return FMA(alpha, t7, alpha * FMA(alpha_2, FMA(alpha_2, FMA(t2, alpha_2, t5), t6), t9));
}
/* alpha >= 1.04, in b = pi/2 - alpha */
INLINE double weight_moment_amplitude_best_fused_far(double alpha)
{
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p1 = POLY7(b_2, -0x1.ffffffffffff2p-3, 0x1.2aaaaaaaaa92ep-1, -0x1.5b05b05af73fdp-3,
        0x1.bc8bc8b4233bfp-6, -0x1.637e07a789800p-9, 0x1.83c9cfd63f094p-13, -0x1.329964da2a8a0p-17,
        0x1.629d6790f59cdp-22);
    const double t1 = FMA(b_2, p1, FMA(b, -0x1.1a62633145c07p-53, -0x1.94bfdddaf8555p-10));
    return 0.5 * alpha + -0x1.e000000000000p-4 + FMA(b, FMA(b, -0.75, 0.5), t1);
}
INLINE double weight_moment_amplitude_best_fused(double alpha)
{
    const double near = weight_moment_amplitude_best_fused_near(alpha);
    const double far = weight_moment_amplitude_best_fused_far(alpha);
    return SELECT(alpha < 0x1.0a3d70a3d70a4p+0, near, far);
}
#define weight_moment_amplitude_best_fused_KIND pieces
#define weight_moment_amplitude_best_fused_BELOW_double UINT64_C(0x3ff0a3d70a3d70a3)
#define weight_moment_amplitude_best_fused_BELOW_float UINT32_C(0x3f851eb8)

/* C_theta = 2*sin(alpha)**3/3, 0 <= alpha <= pi/2, 1e-10, fused: proved within 2.07e-12 relative
 * (certificates/weight_moment_amplitude.json) */
INLINE double weight_moment_amplitude_1e_10_fused(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY8(alpha_2, 0x1.555555555259dp-1, -0x1.55555553fea4bp-2, 0x1.27d27cf3b8112p-4,
        -0x1.282eee7b92cf7p-7, 0x1.83c7d5627d1d1p-11, -0x1.65e8281936887p-15, 0x1.e9ce55f457fb1p-20,
        -0x1.f9e9d8d248bfcp-25, 0x1.55b68304dda03p-30);
    return p1 * alpha_2 * alpha;
}
#define weight_moment_amplitude_1e_10_fused_KIND short

/* C_theta = 2*sin(alpha)**3/3, 0 <= alpha <= pi/2, 1e-6, fused: proved within 4.38e-07 relative
 * (certificates/weight_moment_amplitude.json) */
INLINE double weight_moment_amplitude_1e_6_fused(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY5(alpha_2, 0x1.55554ba99af07p-1, -0x1.555382cc0e3b7p-2, 0x1.27b41ec7abd41p-4,
        -0x1.26ad631e2f9a1p-7, 0x1.71e62473ed8bap-11, -0x1.ff7dbdabc38e7p-16);
    return p1 * alpha_2 * alpha;
}
#define weight_moment_amplitude_1e_6_fused_KIND short

/* C_theta = 2*sin(alpha)**3/3, 0 <= alpha <= pi/2, float32, fused: proved within 0.503 ulp
 * (certificates/weight_moment_amplitude.json) */
INLINE double weight_moment_amplitude_float32_fused(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY7(alpha_2, 0x1.5555555478204p-1, -0x1.555555080b38cp-2, 0x1.27d273f81480bp-4,
        -0x1.282e1a3d0c0eep-7, 0x1.83b443c4ba8e3p-11, -0x1.64ea296a14023p-15, 0x1.db665517a168ep-20,
        -0x1.8c2a65eb3fec2p-25);
    return p1 * alpha_2 * alpha;
}
#define weight_moment_amplitude_float32_fused_KIND short

/* lambda = 2*alpha*(1 - cos(alpha)), 0 <= alpha <= pi/2, best, fused: proved within 0.65 ulp
 * (certificates/resistance_factor.json) */
INLINE double resistance_factor_best_fused(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double alpha_4 = alpha_2 * alpha_2;
    const double p1 = POLY2(alpha_4, 0x1.27e4fb7471f25p-21, 0x1.93966653151c3p-36, 0x1.5aeb95ee17e27p-52);
    const double p2 = POLY2(alpha_4, -0x1.a01a01a0132c2p-15, -0x1.1eed8d7449e95p-28, -0x1.ae33aea2b0d55p-44);
    const double t1 = FMA(alpha_2, FMA(alpha_2, p1, p2), 0x1.6c16c16c16ba2p-9);
    const double t2 = FMA(t1, alpha_2, -0x1.5555555555555p-4);
    const double t3 = FMA(t2, alpha_2, 1.0);
    const double t4 = FMA(alpha_2, FMA(t1, alpha_2, -0x1.5555555555555p-4 - t2), FMA(t2, alpha_2, 1.0 - t3));
    const double t5 = alpha_2 * t3;
    const double t6 = FMA(alpha_2, t4, FMA(FMA(alpha, alpha, -alpha_2), t3, FMA(alpha_2, t3, -t5)));
    return FMA(alpha, t5, alpha * t6);
}
#define resistance_factor_best_fused_KIND whole

/* lambda = 2*alpha*(1 - cos(alpha)), 0 <= alpha <= pi/2, 1e-10, fused: proved within 2.74e-12 relative
 * (certificates/resistance_factor.json) */
INLINE double resistance_factor_1e_10_fused(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY5(alpha_2, 0x1.fffffffffa0fbp-1, -0x1.55555550127aap-4, 0x1.6c16be606925bp-9,
        -0x1.a018b5707a92dp-15, 0x1.27a4afc560ce7p-21, -0x1.1363823d24666p-28);
    return p1 * alpha_2 * alpha;
}
#define resistance_factor_1e_10_fused_KIND short

/* lambda = 2*alpha*(1 - cos(alpha)), 0 <= alpha <= pi/2, 1e-6, fused: proved within 1.71e-07 relative
 * (certificates/resistance_factor.json) */
INLINE double resistance_factor_1e_6_fused(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY3(alpha_2, 0x1.fffffa5b957a5p-1, -0x1.5553226831932p-4, 0x1.6b8afbde89795p-9,
        -0x1.899d6d596ca14p-15);
    return p1 * alpha_2 * alpha;
}
#define resistance_factor_1e_6_fused_KIND short

/* lambda = 2*alpha*(1 - cos(alpha)), 0 <= alpha <= pi/2, float32, fused: proved within 0.501 ulp
 * (certificates/resistance_factor.json) */
INLINE double resistance_factor_float32_fused(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY5(alpha_2, 0x1.fffffffffa0fbp-1, -0x1.55555550127aap-4, 0x1.6c16be606925bp-9,
        -0x1.a018b5707a92dp-15, 0x1.27a4afc560ce7p-21, -0x1.1363823d24666p-28);
    return p1 * alpha_2 * alpha;
}
#define resistance_factor_float32_fused_KIND short

/* A = polar_moment(alpha)/resistance_factor(alpha), finite at alpha = 0 where both vanish, 0 <= alpha <= pi/2,
 * best, fused: proved within 0.824 ulp (certificates/dynamic_coefficient.json) */
INLINE double dynamic_coefficient_best_fused(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double alpha_4 = alpha_2 * alpha_2;
    const double p1 = POLY6(alpha_4, 0x1.35581dd41bf26p-11, 0x1.f92bab6a0abaap-20, 0x1.6da73104fa7a4p-26,
        -0x1.fee67d54196edp-26, -0x1.53d73ac978ed8p-25, -0x1.f2e1d02f3340cp-27, -0x1.2c0d230256175p-30);
    const double p2 = POLY7(alpha_4, -0x1.ce55c8ea17b0fp-8, -0x1.08db14dc94ea7p-15, 0x1.135a83002a443p-24,
        0x1.bf05d956aca7bp-26, 0x1.666ac0bc24d1ap-25, 0x1.e8184e269e990p-26, 0x1.5daa0ca94aea0p-28,
        0x1.e98e74a1ee8a8p-34);
    const double t1 = FMA(alpha_2, FMA(alpha_2, p1, p2), 0x1.d41d41d41c8dap-5);
    const double t2 = FMA(t1, alpha_2, -0x1.111111111110dp-2);
    const double t3 = FMA(t2, alpha_2, 0x1.5555555555555p-1);
    const double t4 = FMA(t2, alpha_2, 0x1.5555555555555p-1 - t3) + 0x1.5555555555555p-55;
    const double t5 = FMA(alpha, alpha, -alpha_2);
    const double t6 = FMA(t5, t2, FMA(alpha_2, FMA(t1, alpha_2, -0x1.111111111110dp-2 - t2), t4));
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p3 = POLY5(b_2, -0x1.213ce230a79e8p-7, 0x1.94ebfbcf8c0fdp-4, -0x1.0ee063bdf7d00p-5,
        0x1.5582f28f586d2p-8, -0x1.047e200356e2ep-11, 0x1.f52cc7c7dfefdp-16);
    const double p4 = POLY5(b_2, 0x1.55555555565f3p-2, -0x1.5555554df34edp-3, 0x1.27d28a4134219p-5,
        -0x1.2825e27d993d6p-8, 0x1.85f979159b9b1p-12, -0x1.74ce10bfef7f7p-16);
    const double t7 = FMA(b * b_2, FMA(p4, logarithm_fused(b), p3), 0x1.fab71f4a3269fp-7);
    const double t8 = alpha + -0x1.1400000000000p-1;
    const double t9 = t8 + t7;
    const double t10 = alpha < 0x1.2e147ae147ae1p+0;
    const double t11 = SELECT(t10, t3, t9);
    const double p5 = POLY2(alpha_4, 0x1.27e4fb7471f25p-21, 0x1.93966653151c3p-36, 0x1.5aeb95ee17e27p-52);
    const double p6 = POLY2(alpha_4, -0x1.a01a01a0132c2p-15, -0x1.1eed8d7449e95p-28, -0x1.ae33aea2b0d55p-44);
    const double t12 = FMA(alpha_2, FMA(alpha_2, p5, p6), 0x1.6c16c16c16ba2p-9);
    const double t13 = FMA(t12, alpha_2, -0x1.5555555555555p-4);
    const double t14 = FMA(t13, alpha_2, 1.0);
    const double t15 = FMA(alpha_2, FMA(t12, alpha_2, -0x1.5555555555555p-4 - t13), FMA(t13, alpha_2, 1.0 - t14));
    const double t16 = alpha_2 * t14;
    const double t17 = alpha * t16;
    const double t18 = FMA(alpha, FMA(alpha_2, t15, FMA(t5, t14, FMA(alpha_2, t14, -t16))), FMA(alpha, t16, -t17));
    const double t19 = SELECT(t10, t14, t17);
    const double t20 = 1.0 / t19;
    const double t21 = t11 * t20;
    const double t22 = -t21;
    const double t23 = FMA(t22, t19, t11) + SELECT(t10, t6, t7 - (t9 - t8));
    return FMA(FMA(t22, SELECT(t10, FMA(t5, t13, t15), t18), t23), t20, t21);
}
#define dynamic_coefficient_best_fused_KIND whole

/* C_theta/Theta* = weight_moment_amplitude(alpha)/moment_of_inertia(alpha), finite at alpha = 0 where both vanish,
 * 0 <= alpha <= pi/2, best, fused: proved within 0.892 ulp (certificates/weight_moment_per_inertia.json) */
INLINE double weight_moment_per_inertia_best_fused(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double alpha_4 = alpha_2 * alpha_2;
    const double p1 = POLY3(alpha_4, 0x1.83c8978eb80fep-11, 0x1.eaeaa1ab8770dp-20, 0x1.b597e33b4fe12p-30,
        0x1.2cbf2ac4da2b8p-41);
    const double p2 = POLY3(alpha_4, -0x1.282ef4b666b1ep-7, -0x1.65f59e2d0f0a3p-15, -0x1.03e5116ace15dp-24,
        -0x1.29f8d2f261d93p-35);
    const double t1 = FMA(alpha_2, FMA(alpha_2, p1, p2), 0x1.27d27d27d27a3p-4);
    const double t2 = FMA(t1, alpha_2, -0x1.5555555555555p-2);
    const double t3 = FMA(t2, alpha_2, 0x1.5555555555555p-1);
    const double t4 = FMA(t2, alpha_2, 0x1.5555555555555p-1 - t3) + 0x1.5555555555555p-55;
    const double t5 = FMA(alpha, alpha, -alpha_2);
    const double t6 = FMA(t5, t2, FMA(alpha_2, FMA(t1, alpha_2, -0x1.5555555555555p-2 - t2), t4));
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p3 = POLY7(b_2, -0x1.0000000000006p-2, 0x1.2aaaaaaaaab34p-1, -0x1.5b05b05b06654p-3,
        0x1.bc8bc8bb1d67bp-6, -0x1.637e09681a6fbp-9, 0x1.83ca4d0f33cdbp-13, -0x1.32aba46279bb3p-17,
        0x1.64c78b2442998p-22);
    const double t7 = FMA(b_2, p3, FMA(b, -0x1.1a62633145c07p-53, -0x1.194bfdddaf855p-6));
    const double t8 = FMA(b, FMA(b, -0.75, 0.5), t7);
    const double t9 = 0.5 * alpha + -0x1.a000000000000p-4;
    const double t10 = t9 + t8;
    const double t11 = alpha < 0x1.0f5c28f5c28f6p+0;
    const double t12 = SELECT(t11, t3, t10);
    const double p4 = POLY3(alpha_4, 0x1.1f7d05c6dedbbp-8, 0x1.1f0875d692422p-15, 0x1.945e2a38f102ep-24,
        0x1.eaf6c7c779d13p-34);
    const double p5 = POLY4(alpha_4, -0x1.f1029e62c8327p-6, -0x1.d71607a6c20cep-12, -0x1.0e1fa07f81ed1p-19,
        -0x1.ec7a22ee46a5cp-29, -0x1.60b9ed103c0fap-39);
    const double t13 = FMA(alpha_2, FMA(alpha_2, p4, p5), 0x1.1e11e11e11ddep-3);
    const double t14 = FMA(t13, alpha_2, -0x1.9999999999999p-2);
    const double t15 = FMA(t14, alpha_2, 0x1.5555555555555p-1);
    const double t16 = FMA(t14, alpha_2, 0x1.5555555555555p-1 - t15) + 0x1.5555555555555p-55;
    const double t17 = FMA(t5, t14, FMA(alpha_2, FMA(t13, alpha_2, -0x1.9999999999999p-2 - t14), t16));
    const double p6 = POLY8(b_2, -0x1.555555555554fp-3, -0x1.c71c71c71c995p-3, 0x1.3e93e93e9679ap-2,
        -0x1.0cbb76624ef26p-3, 0x1.e94dfd2a84da7p-6, -0x1.1e5e14556f803p-8, 0x1.d69dd6e3a84b4p-12,
        -0x1.1e99caf0a78dfp-15, 0x1.00ab575ef75a6p-19);
    const double t18 = FMA(b, p6, 0x1.9ffffffffffffp-4);
    const double t19 = t9 + t18;
    const double t20 = SELECT(t11, t15, t19);
    const double t21 = 1.0 / t20;
    const double t22 = t12 * t21;
    const double t23 = -t22;
    const double t24 = FMA(t23, t20, t12) + SELECT(t11, t6, t8 - (t10 - t9));
    return FMA(FMA(t23, SELECT(t11, t17, t18 - (t19 - t9)), t24), t21, t22);
}
#define weight_moment_per_inertia_best_fused_KIND whole

/* C_r/Theta* = radial_weight_amplitude(alpha)/moment_of_inertia(alpha), finite at alpha = 0 where both vanish, 0
 * <= alpha <= pi/2, best, fused: proved within 1.08 ulp (certificates/radial_weight_per_inertia.json) */
INLINE double radial_weight_per_inertia_best_fused(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double alpha_4 = alpha_2 * alpha_2;
    const double p1 = POLY7(alpha_4, -0x1.47d67746cef40p-16, -0x1.015bd71ab20f7p-18, -0x1.5b9ad7cbb1202p-22,
        -0x1.2fa88e52f9e30p-23, -0x1.0bef51e7eecdbp-22, -0x1.7849a9f05aa4ap-23, -0x1.1f1ed07467e72p-25,
        -0x1.b88267851e4a5p-31);
    const double p2 = POLY7(alpha_4, -0x1.664f4880dd143p-10, -0x1.07d7822d7b6f1p-16, -0x1.1c9a1d34b6f3fp-20,
        -0x1.58a3290228af4p-25, 0x1.88d893699f450p-23, 0x1.014d0e8ca8808p-22, 0x1.8b78856019984p-24,
        0x1.00fc0cec735acp-27);
    const double t1 = FMA(alpha_2, FMA(alpha_2, p1, p2), 0x1.2b12b12b11ea5p-6);
    const double t2 = FMA(t1, alpha_2, -0x1.9999999999996p-3);
    const double t3 = FMA(t2, alpha_2, 0x1.5555555555555p-1);
    const double t4 = FMA(t2, alpha_2, 0x1.5555555555555p-1 - t3) + 0x1.5555555555555p-55;
    const double t5 = FMA(alpha, alpha, -alpha_2);
    const double t6 = FMA(t5, t2, FMA(alpha_2, FMA(t1, alpha_2, -0x1.9999999999996p-3 - t2), t4));
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p3 = POLY5(b_2, -0x1.7217f7d1acae6p-7, 0x1.2c981ff6211c9p-1, -0x1.5fec36ee4b768p-4,
        0x1.c0f9c0515effdp-8, -0x1.5c6d8636f92ccp-12, 0x1.64009ce2f3630p-17);
    const double p4 = POLY5(b_2, 0x1.000000000015dp+0, -0x1.5555555455f4cp-2, 0x1.6c16c49fd75c7p-5,
        -0x1.a01620d59d215p-9, 0x1.28ae92a1ef664p-13, -0x1.27ac624df162ep-18);
    const double t7 = FMA(b_2, FMA(p4, logarithm_fused(2.0 * b), p3), 0x1.5e04abbbd2e80p-5);
    const double t8 = FMA(b, FMA(b, -1.875, 0.5), t7);
    const double t9 = 0.5 * alpha;
    const double t10 = t9 + 0x1.6000000000000p-3;
    const double t11 = t10 + t8;
    const double t12 = alpha < 0x1.1eb851eb851ecp+0;
    const double t13 = SELECT(t12, t3, t11);
    const double p5 = POLY3(alpha_4, 0x1.1f7d05c6e1487p-8, 0x1.1f0875ebcbf04p-15, 0x1.945e8f1de9e15p-24,
        0x1.eb70be827f311p-34);
    const double p6 = POLY4(alpha_4, -0x1.f1029e62c840ep-6, -0x1.d71607a7973dcp-12, -0x1.0e1fa3172eb2cp-19,
        -0x1.ec837110b11a7p-29, -0x1.63629956670d9p-39);
    const double t14 = FMA(alpha_2, FMA(alpha_2, p5, p6), 0x1.1e11e11e11ddfp-3);
    const double t15 = FMA(t14, alpha_2, -0x1.9999999999999p-2);
    const double t16 = FMA(t15, alpha_2, 0x1.5555555555555p-1);
    const double t17 = FMA(t15, alpha_2, 0x1.5555555555555p-1 - t16) + 0x1.5555555555555p-55;
    const double t18 = FMA(t5, t15, FMA(alpha_2, FMA(t14, alpha_2, -0x1.9999999999999p-2 - t15), t17));
    const double p7 = POLY8(b_2, -0x1.555555555554dp-3, -0x1.c71c71c71cc85p-3, 0x1.3e93e93e9e0d6p-2,
        -0x1.0cbb76644f474p-3, 0x1.e94dfe3da88b8p-6, -0x1.1e5e3d4c60700p-8, 0x1.d6ab8ca876bdep-12,
        -0x1.1fcee5678494fp-15, 0x1.16f943a246fa1p-19);
    const double t19 = FMA(b, p7, 0x1.7ffffffffffffp-4);
    const double t20 = t9 + -0x1.8000000000000p-4;
    const double t21 = t20 + t19;
    const double t22 = SELECT(t12, t16, t21);
    const double t23 = 1.0 / t22;
    const double t24 = t13 * t23;
    const double t25 = -t24;
    const double t26 = FMA(t25, t22, t13) + SELECT(t12, t6, t8 - (t11 - t10));
    return FMA(FMA(t25, SELECT(t12, t18, t19 - (t21 - t20)), t26), t23, t24);
}
#define radial_weight_per_inertia_best_fused_KIND whole

/* I_p* /Theta* = polar_moment(alpha)/moment_of_inertia(alpha), finite at alpha = 0 where both vanish, 0 <= alpha
 * <= pi/2, best, fused: proved within 0.814 ulp (certificates/polar_moment_per_inertia.json) */
INLINE double polar_moment_per_inertia_best_fused(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double alpha_4 = alpha_2 * alpha_2;
    const double p1 = POLY4(alpha_4, 0x1.35581d9dfe224p-11, 0x1.f9291426a15fap-20, 0x1.a303539235a90p-26,
        -0x1.cddced305e389p-28, -0x1.77c8d442bafc7p-29);
    const double p2 = POLY5(alpha_4, -0x1.ce55c8e971fd1p-8, -0x1.08db03cc5e770p-15, 0x1.116ceb2ada79ap-24,
        0x1.09bb69f7fcfadp-26, 0x1.e745acd142291p-28, 0x1.7e95e1dac17adp-31);
    const double t1 = FMA(alpha_2, FMA(alpha_2, p1, p2), 0x1.d41d41d41ba25p-5);
    const double t2 = FMA(t1, alpha_2, -0x1.1111111111106p-2);
    const double t3 = FMA(t2, alpha_2, 0x1.5555555555555p-1);
    const double t4 = FMA(t2, alpha_2, 0x1.5555555555555p-1 - t3) + 0x1.5555555555555p-55;
    const double t5 = FMA(alpha, alpha, -alpha_2);
    const double t6 = FMA(t5, t2, FMA(alpha_2, FMA(t1, alpha_2, -0x1.1111111111106p-2 - t2), t4));
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p3 = POLY5(b_2, -0x1.eb440e0d5b068p-3, 0x1.b70e1da718514p-3, -0x1.dbecf43061ae4p-5,
        0x1.115fe28110038p-7, -0x1.8a9e832d9844dp-11, 0x1.af511ed3efee7p-15);
    const double p4 = POLY5(b_2, 0x1.55555555518aap-2, -0x1.5555556697b7dp-3, 0x1.27d268328778dp-5,
        -0x1.283af2ca91d53p-8, 0x1.7ff85a336a890p-12, -0x1.b634872dcba2dp-16);
    const double t7 = FMA(b * b_2, FMA(p4, logarithm_fused(2.0 * b), p3), 0x1.7d5b8fa51934fp-6);
    const double t8 = alpha + -0x1.1800000000000p-1;
    const double t9 = t8 + t7;
    const double t10 = alpha < 1.0;
    const double t11 = SELECT(t10, t3, t9);
    const double p5 = POLY3(alpha_4, 0x1.1f7d05c54d72cp-8, 0x1.1f086b05efb64p-15, 0x1.942d994b09126p-24,
        0x1.ae33f297a30d7p-34);
    const double p6 = POLY3(alpha_4, -0x1.f1029e62bbf32p-6, -0x1.d716073060e57p-12, -0x1.0e1e5caf9c68cp-19,
        -0x1.e7f58bcd729d6p-29);
    const double t12 = FMA(alpha_2, FMA(alpha_2, p5, p6), 0x1.1e11e11e11c62p-3);
    const double t13 = FMA(t12, alpha_2, -0x1.9999999999995p-2);
    const double t14 = FMA(t13, alpha_2, 0x1.5555555555555p-1);
    const double t15 = FMA(t13, alpha_2, 0x1.5555555555555p-1 - t14) + 0x1.5555555555555p-55;
    const double t16 = FMA(t5, t13, FMA(alpha_2, FMA(t12, alpha_2, -0x1.9999999999995p-2 - t13), t15));
    const double p7 = POLY9(b_2, -0x1.555555555554ep-3, -0x1.c71c71c71cad2p-3, 0x1.3e93e93e9959dp-2,
        -0x1.0cbb76630619cp-3, 0x1.e94dfd8b6e6d2p-6, -0x1.1e5e23528aa32p-8, 0x1.d6a371cc475cdp-12,
        -0x1.1f397f95f7403p-15, 0x1.1425220d45aaap-19, -0x1.00589fe65ed98p-23);
    const double t17 = FMA(b, p7, 0x1.dffffffffffffp-4);
    const double t18 = 0.5 * alpha + -0x1.e000000000000p-4;
    const double t19 = t18 + t17;
    const double t20 = SELECT(t10, t14, t19);
    const double t21 = 1.0 / t20;
    const double t22 = t11 * t21;
    const double t23 = -t22;
    const double t24 = FMA(t23, t20, t11) + SELECT(t10, t6, t7 - (t9 - t8));
    return FMA(FMA(t23, SELECT(t10, t16, t17 - (t19 - t18)), t24), t21, t22);
}
#define polar_moment_per_inertia_best_fused_KIND whole

/* C_theta/C_r = weight_moment_amplitude(alpha)/radial_weight_amplitude(alpha), finite at alpha = 0 where both
 * vanish, 0 <= alpha <= pi/2, best, fused: proved within 1.03 ulp
 * (certificates/weight_moment_per_radial_weight.json) */
INLINE double weight_moment_per_radial_weight_best_fused(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double alpha_4 = alpha_2 * alpha_2;
    const double p1 = POLY3(alpha_4, 0x1.83c8978ec51cep-11, 0x1.eaeaa2c9de7afp-20, 0x1.b59d8e5371c8cp-30,
        0x1.30db2c751a237p-41);
    const double p2 = POLY3(alpha_4, -0x1.282ef4b666c9bp-7, -0x1.65f59e30a6c95p-15, -0x1.03e52bbf4db10p-24,
        -0x1.2a4d5179ccb3bp-35);
    const double t1 = FMA(alpha_2, FMA(alpha_2, p1, p2), 0x1.27d27d27d27a5p-4);
    const double t2 = FMA(t1, alpha_2, -0x1.5555555555555p-2);
    const double t3 = FMA(t2, alpha_2, 0x1.5555555555555p-1);
    const double t4 = FMA(t2, alpha_2, 0x1.5555555555555p-1 - t3) + 0x1.5555555555555p-55;
    const double t5 = FMA(alpha, alpha, -alpha_2);
    const double t6 = FMA(t5, t2, FMA(alpha_2, FMA(t1, alpha_2, -0x1.5555555555555p-2 - t2), t4));
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p3 = POLY7(b_2, -0x1.fffffffffff95p-4, 0x1.2aaaaaaaaa534p-1, -0x1.5b05b05ace2a9p-3,
        0x1.bc8bc899c38eep-6, -0x1.637dfe720b520p-9, 0x1.83c64150f3de6p-13, -0x1.31e2be57bfe01p-17,
        0x1.44ebe008475edp-22);
    const double t7 = FMA(b_2, p3, FMA(b, -0x1.1a62633145c07p-53, -0x1.8ca5feeed7c2bp-5));
    const double t8 = FMA(b, FMA(b, -0.875, 0.5), t7);
    const double t9 = 0.5 * alpha;
    const double t10 = t9 + -0x1.2000000000000p-4;
    const double t11 = t10 + t8;
    const double t12 = alpha < 0x1.2147ae147ae14p+0;
    const double t13 = SELECT(t12, t3, t11);
    const double p4 = POLY6(alpha_4, -0x1.47d639590fb52p-16, -0x1.01130834deb14p-18, -0x1.0c93c27d943d3p-22,
        0x1.0242817718f09p-22, 0x1.ae7d3d37478b8p-22, 0x1.7e0d0f92d659ap-23, 0x1.16a51a0466b36p-26);
    const double p5 = POLY7(alpha_4, -0x1.664f488ec5cd7p-10, -0x1.07da187423fafp-16, -0x1.222d653c72507p-20,
        -0x1.f5391f483e97bp-23, -0x1.a2047d109e679p-22, -0x1.54ac07dc5767ap-22, -0x1.26e21fc7faf1ep-24,
        -0x1.f8851683cc319p-30);
    const double t14 = FMA(alpha_2, FMA(alpha_2, p4, p5), 0x1.2b12b12b184a9p-6);
    const double t15 = FMA(t14, alpha_2, -0x1.99999999999b7p-3);
    const double t16 = FMA(t15, alpha_2, 0x1.5555555555555p-1);
    const double t17 = FMA(t15, alpha_2, 0x1.5555555555555p-1 - t16) + 0x1.5555555555555p-55;
    const double t18 = FMA(t5, t15, FMA(alpha_2, FMA(t14, alpha_2, -0x1.99999999999b7p-3 - t15), t17));
    const double p6 = POLY5(b_2, -0x1.7217f7d1ab2e7p-7, 0x1.2c981ff63ec19p-1, -0x1.5fec368b1249bp-4,
        0x1.c0fa11c3186cdp-8, -0x1.5c79b09b316eap-12, 0x1.5cb02195a47e5p-17);
    const double p7 = POLY5(b_2, 0x1.0000000000169p+0, -0x1.555555543d7fdp-2, 0x1.6c16c52a07b2ap-5,
        -0x1.a015173aabdaap-9, 0x1.2910a202b16c5p-13, -0x1.1e2016c290c5cp-18);
    const double t19 = FMA(b_2, FMA(p7, logarithm_fused(2.0 * b), p6), 0x1.5e04abbbd2e80p-5);
    const double t20 = FMA(b, FMA(b, -1.875, 0.5), t19);
    const double t21 = t9 + 0x1.6000000000000p-3;
    const double t22 = t21 + t20;
    const double t23 = SELECT(t12, t16, t22);
    const double t24 = 1.0 / t23;
    const double t25 = t13 * t24;
    const double t26 = -t25;
    const double t27 = FMA(t26, t23, t13) + SELECT(t12, t6, t8 - (t11 - t10));
    return FMA(FMA(t26, SELECT(t12, t18, t20 - (t22 - t21)), t27), t24, t25);
}
#define weight_moment_per_radial_weight_best_fused_KIND whole
#endif

#undef FMA
#define FMA(a, b, c) ((a) * (b) + (c))

/* ln b of a b >= 0; at 0 something finite, which a factor 0 waits for. */
INLINE double logarithm_plain(double b)
{
    const double t1 = LARGER(b, 0x1.0000000000000p-60);
    const double t2 = significand_of(t1) - 1.0;
    const double t3 = t2 / (t2 + 2.0);
    const double t4 = t3 * t3;
    const double p1 = POLY6(t4, 0x1.55555555559d8p-1, 0x1.999999987c7a3p-2, 0x1.249249f1b0e53p-2,
        0x1.c71be01ef8d7bp-3, 0x1.747966b22b47ep-3, 0x1.3804595ac79edp-3, 0x1.3cda08c7927d8p-3);
    return t3 * (t4 * p1 - t2) + (exponent_of(t1) * 0x1.62e42fefa39efp-1 + t2);
}

/* I_p* = (2*alpha - sin(alpha)*cos(alpha) - cos(alpha)**3*atanh(sin(alpha)))/3, 0 <= alpha <= pi/2, best, plain:
 * proved within 4.17 ulp (certificates/polar_moment.json) */
/* alpha < 1.06 */
INLINE double polar_moment_best_plain_near(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY14(alpha_2, -0x1.9999999999998p-2, 0x1.5f15f15f15caep-4, -0x1.5ac056afeeeedp-7,
        0x1.d0042d1a7a479p-11, -0x1.8d48d67723bf4p-15, 0x1.7af6847d6a8b5p-19, 0x1.910a4d94f0fb2p-24,
        0x1.5ec4e6cb89e6ep-25, 0x1.34779b4319ad8p-26, -0x1.ebe50399bea97p-28, 0x1.a8f8eb47e02adp-27,
        -0x1.2c351cb8eed5bp-27, 0x1.4ddb2f6e5a435p-28, -0x1.a5f2cc52df731p-30, 0x1.1727db8e8d26bp-32);
    return (alpha_2 * (p1 * alpha_2) + alpha_2) / 1.5 * alpha;
}
/* alpha >= 1.06, in b = pi/2 - alpha */
INLINE double polar_moment_best_plain_far(double alpha)
{
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p1 = POLY5(b_2, -0x1.213ce2316924dp-7, 0x1.94ebfb8ed1634p-4, -0x1.0ee08d6ddcdd4p-5,
        0x1.556fa69a4a6aep-8, -0x1.058191e40d3cfp-11, 0x1.142a50dc4a9dep-15);
    const double p2 = POLY5(b_2, 0x1.5555555554f26p-2, -0x1.55555559507f8p-3, 0x1.27d27519db656p-5,
        -0x1.2835c7b8e7a0fp-8, 0x1.80dd0f969ca49p-12, -0x1.b08fc34d11d4dp-16);
    const double t1 = b * b_2 * (p2 * logarithm_plain(b) + p1) + 0x1.fab71f4a3269fp-7;
    return alpha + -0x1.1400000000000p-1 + t1;
}
INLINE double polar_moment_best_plain(double alpha)
{
    const double near = polar_moment_best_plain_near(alpha);
    const double far = polar_moment_best_plain_far(alpha);
    return SELECT(alpha < 0x1.0f5c28f5c28f6p+0, near, far);
}
#define polar_moment_best_plain_KIND pieces
#define polar_moment_best_plain_BELOW_double UINT64_C(0x3ff0f5c28f5c28f5)
#define polar_moment_best_plain_BELOW_float UINT32_C(0x3f87ae14)

/* I_p* = (2*alpha - sin(alpha)*cos(alpha) - cos(alpha)**3*atanh(sin(alpha)))/3, 0 <= alpha <= pi/2, 1e-10, plain:
 * proved within 6.69e-11 relative (certificates/polar_moment.json) */
INLINE double polar_moment_1e_10_plain(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double t1 = 0x1.3bd3cc9be45dep+1 - alpha_2;
    const double p1 = POLY7(t1, 0x1.14aca4167a07fp-2, 0x1.6f67e48f11997p+3, 0x1.705f937528711p+6,
        0x1.781f38b2a68b0p+7, 0x1.97881d28eb78fp+6, 0x1.15f5651c6c2b6p+4, 0x1.764b4fd12c227p+1,
        0x1.e250654a0fa79p-5);
    const double p2 = POLY7(t1, 1.0, 0x1.5185165bf6bccp+5, 0x1.47ee26059427dp+8, 0x1.283ecbb1b4392p+9,
        0x1.4ea305d69d8f6p+7, -0x1.444345493560ap+5, 0x1.b9bc468114fd2p+1, -0x1.efcbe37812bdfp-4);
    return p1 * alpha_2 / p2 * alpha;
}
#define polar_moment_1e_10_plain_KIND whole

/* I_p* = (2*alpha - sin(alpha)*cos(alpha) - cos(alpha)**3*atanh(sin(alpha)))/3, 0 <= alpha <= pi/2, 1e-6, plain:
 * proved within 6.63e-07 relative (certificates/polar_moment.json) */
INLINE double polar_moment_1e_6_plain(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY8(alpha_2, 0x1.555563e45ba3ep-1, -0x1.1116d4346c2b7p-2, 0x1.d5a56118ff0cbp-5,
        -0x1.f6c43e68063fbp-8, 0x1.a45a7a5b48d87p-10, -0x1.f017539ffdb0bp-11, 0x1.e6addd2fd57c1p-12,
        -0x1.01f8715011affp-13, 0x1.c6cb40d04487cp-17);
    return p1 * alpha_2 * alpha;
}
#define polar_moment_1e_6_plain_KIND whole

/* I_p* = (2*alpha - sin(alpha)*cos(alpha) - cos(alpha)**3*atanh(sin(alpha)))/3, 0 <= alpha <= pi/2, float32,
 * plain: proved within 0.503 ulp (certificates/polar_moment.json) */
INLINE double polar_moment_float32_plain(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double t1 = 0x1.3bd3cc9be45dep+1 - alpha_2;
    const double p1 = POLY7(t1, 0x1.14aca415ff9bep-2, 0x1.0a493d7acae63p+3, 0x1.7e9225dc641bdp+5,
        0x1.1699441fb3d7bp+6, 0x1.db1c7a52b7740p+4, 0x1.933d9ee3bc318p+2, 0x1.dc0d095bd83c1p-1,
        0x1.06bac513c89bdp-4);
    const double p2 = POLY6(t1, 1.0, 0x1.e7e99b90416b4p+4, 0x1.4f42aae35dcb3p+7, 0x1.981502230ec47p+7,
        0x1.060efdd46e2e3p+5, -0x1.62e6200f03a08p+2, 0x1.d7d31fc8e0f2ap-3);
    return p1 * alpha_2 / p2 * alpha;
}
#define polar_moment_float32_plain_KIND whole

/* Theta* = alpha/2 - sin(2*alpha)/6 - sin(4*alpha)/24, 0 <= alpha <= pi/2, best, plain: proved within 3.94 ulp
 * (certificates/moment_of_inertia.json) */
/* alpha < 1.04 */
INLINE double moment_of_inertia_best_plain_near(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY9(alpha_2, -0x1.333333333332bp-1, 0x1.ad1ad1ad1a79fp-3, -0x1.74c1f6ca02d52p-5,
        0x1.af3b88a5d2a17p-8, -0x1.6150852358f81p-11, 0x1.ae8c97331a182p-15, -0x1.952cb7756450ap-19,
        0x1.2f16eb244b5dfp-23, -0x1.6d4e163551c6fp-28, 0x1.3e673ee0e6ccep-33);
    return (alpha_2 * (p1 * alpha_2) + alpha_2) / 1.5 * alpha;
}
/* alpha >= 1.04, in b = pi/2 - alpha */
INLINE double moment_of_inertia_best_plain_far(double alpha)
{
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p1 = POLY8(b_2, -0x1.5555555555569p-3, -0x1.c71c71c71bd51p-3, 0x1.3e93e93e8513fp-2,
        -0x1.0cbb765f6105bp-3, 0x1.e94dfc180d8d8p-6, -0x1.1e5df77310522p-8, 0x1.d696da6d44e9dp-12,
        -0x1.1e264f7e219b6p-15, 0x1.f4ffb320b7c92p-20);
    return 0.5 * alpha + -0x1.1000000000000p-3 + (b * p1 + 0x1.1000000000000p-3);
}
INLINE double moment_of_inertia_best_plain(double alpha)
{
    const double near = moment_of_inertia_best_plain_near(alpha);
    const double far = moment_of_inertia_best_plain_far(alpha);
    return SELECT(alpha < 0x1.0a3d70a3d70a4p+0, near, far);
}
#define moment_of_inertia_best_plain_KIND pieces
#define moment_of_inertia_best_plain_BELOW_double UINT64_C(0x3ff0a3d70a3d70a3)
#define moment_of_inertia_best_plain_BELOW_float UINT32_C(0x3f851eb8)

/* Theta* = alpha/2 - sin(2*alpha)/6 - sin(4*alpha)/24, 0 <= alpha <= pi/2, 1e-10, plain: proved within 3.57e-12
 * relative (certificates/moment_of_inertia.json) */
INLINE double moment_of_inertia_1e_10_plain(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY9(alpha_2, 0x1.55555555502c0p-1, -0x1.99999996b5367p-2, 0x1.1e11e0d7b66ffp-3,
        -0x1.f10293cdf1d20p-6, 0x1.1f7c9cb90ff08p-8, -0x1.d70c8c3356105p-12, 0x1.1ec4f59c801cbp-15,
        -0x1.0bc4e9f8c08c4p-19, 0x1.7a7cb07e3408cp-24, -0x1.4936e56328342p-29);
    return p1 * alpha_2 * alpha;
}
#define moment_of_inertia_1e_10_plain_KIND whole

/* Theta* = alpha/2 - sin(2*alpha)/6 - sin(4*alpha)/24, 0 <= alpha <= pi/2, 1e-6, plain: proved within 2.42e-07
 * relative (certificates/moment_of_inertia.json) */
INLINE double moment_of_inertia_1e_6_plain(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY6(alpha_2, 0x1.55554ffb45dfap-1, -0x1.999830f1f6825p-2, 0x1.1e017fc24dd09p-3,
        -0x1.efda754ae7b31p-6, 0x1.1a5c427a6780ap-8, -0x1.a6e3a2c99c515p-12, 0x1.50ef7c600437bp-16);
    return p1 * alpha_2 * alpha;
}
#define moment_of_inertia_1e_6_plain_KIND short

/* Theta* = alpha/2 - sin(2*alpha)/6 - sin(4*alpha)/24, 0 <= alpha <= pi/2, float32, plain: proved within 0.503 ulp
 * (certificates/moment_of_inertia.json) */
INLINE double moment_of_inertia_float32_plain(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY8(alpha_2, 0x1.55555554542e9p-1, -0x1.9999992647539p-2, 0x1.1e11d8503acb9p-3,
        -0x1.f1018ef94d003p-6, 0x1.1f74af1fc94e4p-8, -0x1.d6804e76da319p-12, 0x1.1be5d7f6ae24dp-15,
        -0x1.f4342ef238f03p-20, 0x1.049a5be9eb92ap-24);
    return p1 * alpha_2 * alpha;
}
#define moment_of_inertia_float32_plain_KIND whole

/* C_r = sin(alpha) - cos(alpha)**2*atanh(sin(alpha)), 0 <= alpha <= pi/2, best, plain: proved within 3.92 ulp
 * (certificates/radial_weight_amplitude.json) */
/* alpha < 1.14 */
INLINE double radial_weight_amplitude_best_plain_near(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY17(alpha_2, -0x1.333333333332dp-2, 0x1.c09c09c09973ep-6, -0x1.0cbb765f0ad28p-9,
        -0x1.ebc1c1a4ab6e5p-16, -0x1.8bc2a180b4b2dp-16, -0x1.821bfead0e378p-18, -0x1.a978e7b7a1cfbp-20,
        -0x1.0f17bdb8198afp-21, -0x1.1659a8c8bfe09p-27, -0x1.550ad9861c80cp-22, 0x1.d4c5f0b709ceap-22,
        -0x1.2e85da2724856p-21, 0x1.1a424504de35dp-21, -0x1.8e7f3cc5112f2p-22, 0x1.9555d125daed6p-23,
        -0x1.1c5633bfcfc28p-24, 0x1.ebdda588d4c52p-27, -0x1.9596db7996201p-30);
    return (alpha_2 * (p1 * alpha_2) + alpha_2) / 1.5 * alpha;
}
/* alpha >= 1.14, in b = pi/2 - alpha */
INLINE double radial_weight_amplitude_best_plain_far(double alpha)
{
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p1 = POLY5(b_2, 0x1.d1bd0105cacaap-4, 0x1.2c981ff65e78ap-1, -0x1.5fec361a7a6e3p-4,
        0x1.c0fa7521974f7p-8, -0x1.5c87336390abap-12, 0x1.536149c083855p-17);
    const double p2 = POLY5(b_2, 0x1.0000000000175p+0, -0x1.55555554239ddp-2, 0x1.6c16c5c417f46p-5,
        -0x1.a013dfccb8a12p-9, 0x1.29896a4b09812p-13, -0x1.11c7f03358b1fp-18);
    const double t1 = b * (b * -2.0 + 0.5) + (b_2 * (p2 * logarithm_plain(2.0 * b) + p1) + 0x1.3c095777a5d00p-6);
    return 0.5 * alpha + 0x1.9000000000000p-3 + t1;
}
INLINE double radial_weight_amplitude_best_plain(double alpha)
{
    const double near = radial_weight_amplitude_best_plain_near(alpha);
    const double far = radial_weight_amplitude_best_plain_far(alpha);
    return SELECT(alpha < 0x1.23d70a3d70a3dp+0, near, far);
}
#define radial_weight_amplitude_best_plain_KIND pieces
#define radial_weight_amplitude_best_plain_BELOW_double UINT64_C(0x3ff23d70a3d70a3c)
#define radial_weight_amplitude_best_plain_BELOW_float UINT32_C(0x3f91eb85)

/* C_r = sin(alpha) - cos(alpha)**2*atanh(sin(alpha)), 0 <= alpha <= pi/2, 1e-10, plain: proved within 5.86e-11
 * relative (certificates/radial_weight_amplitude.json) */
INLINE double radial_weight_amplitude_1e_10_plain(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double t1 = 0x1.3bd3cc9be45dep+1 - alpha_2;
    const double p1 = POLY10(t1, 0x1.08345eb49dfa4p-2, 0x1.40cc71ab82b17p+9, 0x1.c7fae97af9e1fp+17,
        0x1.2d9988866fd53p+24, 0x1.d131baf022e41p+28, 0x1.dda5739c64a89p+31, 0x1.6259be601aeb1p+33,
        0x1.8da34cb08e1f0p+33, 0x1.508e0e40facb6p+32, 0x1.83d173767ec99p+29, 0x1.04f7df6595ca2p+25);
    const double p2 = POLY10(t1, 1.0, 0x1.36c2b5ccd0c1fp+11, 0x1.b915276826f3cp+19, 0x1.22251312f6b79p+26,
        0x1.b7d217ea325d6p+30, 0x1.ae1c93f2d7caep+33, 0x1.18d58653a0677p+35, 0x1.c5d99f7e12cd1p+34,
        0x1.1ea89b013008dp+32, -0x1.cb6e4518cfd29p+28, 0x1.aed60df82a50dp+23);
    return p1 * alpha_2 / p2 * alpha;
}
#define radial_weight_amplitude_1e_10_plain_KIND whole

/* C_r = sin(alpha) - cos(alpha)**2*atanh(sin(alpha)), 0 <= alpha <= pi/2, 1e-6, plain: proved within 4.53e-07
 * relative (certificates/radial_weight_amplitude.json) */
INLINE double radial_weight_amplitude_1e_6_plain(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double t1 = 0x1.3bd3cc9be45dep+1 - alpha_2;
    const double p1 = POLY5(t1, 0x1.0834666ddd492p-2, 0x1.c85b59ccf7e43p+2, 0x1.bb4bf0c970e93p+4,
        0x1.816280b47e4c5p+4, 0x1.5c3fe8cc9aaa0p+2, 0x1.3cfcc3c3dc6ebp-2);
    const double p2 = POLY4(t1, 1.0, 0x1.b0786efcf9f8bp+4, 0x1.6d637ba392228p+6, 0x1.522412f400f39p+5,
        -0x1.3b15ecf57e019p+1);
    return p1 * alpha_2 / p2 * alpha;
}
#define radial_weight_amplitude_1e_6_plain_KIND whole

/* C_r = sin(alpha) - cos(alpha)**2*atanh(sin(alpha)), 0 <= alpha <= pi/2, float32, plain: proved within 0.505 ulp
 * (certificates/radial_weight_amplitude.json) */
INLINE double radial_weight_amplitude_float32_plain(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double t1 = 0x1.3bd3cc9be45dep+1 - alpha_2;
    const double p1 = POLY9(t1, 0x1.08345eb56857ap-2, 0x1.3b6600d74bccbp+8, 0x1.b837b6270ce48p+15,
        0x1.1c70adff422e7p+21, 0x1.a80171a3e90ffp+24, 0x1.9d535830bdb5cp+26, 0x1.1b0db627b1ac4p+27,
        0x1.146d584af00dcp+26, 0x1.5866e2818eb1dp+23, 0x1.a41276abb9bcap+18);
    const double p2 = POLY9(t1, 1.0, 0x1.3173bf280d278p+10, 0x1.a919145cb9bd0p+17, 0x1.0f96e362556bdp+23,
        0x1.86838e8dc8106p+26, 0x1.573eb93a9e7aap+28, 0x1.61a66a4a4b7dfp+28, 0x1.1d5c0538d4588p+26,
        -0x1.c99f8ffd771f7p+22, 0x1.c1ec6782b793bp+17);
    return p1 * alpha_2 / p2 * alpha;
}
#define radial_weight_amplitude_float32_plain_KIND whole

/* C_theta = 2*sin(alpha)**3/3, 0 <= alpha <= pi/2, best, plain: proved within 3.8 ulp
 * (certificates/weight_moment_amplitude.json) */
/* alpha < 1.04 */
INLINE double weight_moment_amplitude_best_plain_near(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY9(alpha_2, -0.5, 0x1.bbbbbbbbbbbb9p-4, -0x1.bc466f119ba39p-7, 0x1.22d671ab555f0p-10,
        -0x1.0c7836b1956aap-14, 0x1.702ffd4421227p-19, -0x1.85d83b7e78aadp-24, 0x1.484138797ad96p-29,
        -0x1.c090a61bf422dp-35, 0x1.d57b926b63ae8p-41);
    return (alpha_2 * (p1 * alpha_2) + alpha_2) / 1.5 * alpha;
}
/* alpha >= 1.04, in b = pi/2 - alpha */
INLINE double weight_moment_amplitude_best_plain_far(double alpha)
{
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p1 = POLY7(b_2, -0x1.ffffffffffff2p-3, 0x1.2aaaaaaaaa92ep-1, -0x1.5b05b05af73fdp-3,
        0x1.bc8bc8b4233bfp-6, -0x1.637e07a789800p-9, 0x1.83c9cfd63f094p-13, -0x1.329964da2a8a0p-17,
        0x1.629d6790f59cdp-22);
    const double t1 = b * (b * -0.75 + 0.5) + (b_2 * p1 + (b * -0x1.1a62633145c07p-53 + -0x1.94bfdddaf8555p-10));
    return 0.5 * alpha + -0x1.e000000000000p-4 + t1;
}
INLINE double weight_moment_amplitude_best_plain(double alpha)
{
    const double near = weight_moment_amplitude_best_plain_near(alpha);
    const double far = weight_moment_amplitude_best_plain_far(alpha);
    return SELECT(alpha < 0x1.0a3d70a3d70a4p+0, near, far);
}
#define weight_moment_amplitude_best_plain_KIND pieces
#define weight_moment_amplitude_best_plain_BELOW_double UINT64_C(0x3ff0a3d70a3d70a3)
#define weight_moment_amplitude_best_plain_BELOW_float UINT32_C(0x3f851eb8)

/* C_theta = 2*sin(alpha)**3/3, 0 <= alpha <= pi/2, 1e-10, plain: proved within 2.07e-12 relative
 * (certificates/weight_moment_amplitude.json) */
INLINE double weight_moment_amplitude_1e_10_plain(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY8(alpha_2, 0x1.555555555259dp-1, -0x1.55555553fea4bp-2, 0x1.27d27cf3b8112p-4,
        -0x1.282eee7b92cf7p-7, 0x1.83c7d5627d1d1p-11, -0x1.65e8281936887p-15, 0x1.e9ce55f457fb1p-20,
        -0x1.f9e9d8d248bfcp-25, 0x1.55b68304dda03p-30);
    return p1 * alpha_2 * alpha;
}
#define weight_moment_amplitude_1e_10_plain_KIND whole

/* C_theta = 2*sin(alpha)**3/3, 0 <= alpha <= pi/2, 1e-6, plain: proved within 4.38e-07 relative
 * (certificates/weight_moment_amplitude.json) */
INLINE double weight_moment_amplitude_1e_6_plain(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY5(alpha_2, 0x1.55554ba99af07p-1, -0x1.555382cc0e3b7p-2, 0x1.27b41ec7abd41p-4,
        -0x1.26ad631e2f9a1p-7, 0x1.71e62473ed8bap-11, -0x1.ff7dbdabc38e7p-16);
    return p1 * alpha_2 * alpha;
}
#define weight_moment_amplitude_1e_6_plain_KIND short

/* C_theta = 2*sin(alpha)**3/3, 0 <= alpha <= pi/2, float32, plain: proved within 0.503 ulp
 * (certificates/weight_moment_amplitude.json) */
INLINE double weight_moment_amplitude_float32_plain(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY7(alpha_2, 0x1.5555555478204p-1, -0x1.555555080b38cp-2, 0x1.27d273f81480bp-4,
        -0x1.282e1a3d0c0eep-7, 0x1.83b443c4ba8e3p-11, -0x1.64ea296a14023p-15, 0x1.db665517a168ep-20,
        -0x1.8c2a65eb3fec2p-25);
    return p1 * alpha_2 * alpha;
}
#define weight_moment_amplitude_float32_plain_KIND whole

/* lambda = 2*alpha*(1 - cos(alpha)), 0 <= alpha <= pi/2, best, plain: proved within 3.01 ulp
 * (certificates/resistance_factor.json) */
INLINE double resistance_factor_best_plain(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY7(alpha_2, -0x1.5555555555555p-4, 0x1.6c16c16c16ba2p-9, -0x1.a01a01a0132c2p-15,
        0x1.27e4fb7471f25p-21, -0x1.1eed8d7449e95p-28, 0x1.93966653151c3p-36, -0x1.ae33aea2b0d55p-44,
        0x1.5aeb95ee17e27p-52);
    return (alpha_2 * (p1 * alpha_2) + alpha_2) * alpha;
}
#define resistance_factor_best_plain_KIND whole

/* lambda = 2*alpha*(1 - cos(alpha)), 0 <= alpha <= pi/2, 1e-10, plain: proved within 2.74e-12 relative
 * (certificates/resistance_factor.json) */
INLINE double resistance_factor_1e_10_plain(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY5(alpha_2, 0x1.fffffffffa0fbp-1, -0x1.55555550127aap-4, 0x1.6c16be606925bp-9,
        -0x1.a018b5707a92dp-15, 0x1.27a4afc560ce7p-21, -0x1.1363823d24666p-28);
    return p1 * alpha_2 * alpha;
}
#define resistance_factor_1e_10_plain_KIND short

/* lambda = 2*alpha*(1 - cos(alpha)), 0 <= alpha <= pi/2, 1e-6, plain: proved within 1.71e-07 relative
 * (certificates/resistance_factor.json) */
INLINE double resistance_factor_1e_6_plain(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY3(alpha_2, 0x1.fffffa5b957a5p-1, -0x1.5553226831932p-4, 0x1.6b8afbde89795p-9,
        -0x1.899d6d596ca14p-15);
    return p1 * alpha_2 * alpha;
}
#define resistance_factor_1e_6_plain_KIND short

/* lambda = 2*alpha*(1 - cos(alpha)), 0 <= alpha <= pi/2, float32, plain: proved within 0.501 ulp
 * (certificates/resistance_factor.json) */
INLINE double resistance_factor_float32_plain(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY5(alpha_2, 0x1.fffffffffa0fbp-1, -0x1.55555550127aap-4, 0x1.6c16be606925bp-9,
        -0x1.a018b5707a92dp-15, 0x1.27a4afc560ce7p-21, -0x1.1363823d24666p-28);
    return p1 * alpha_2 * alpha;
}
#define resistance_factor_float32_plain_KIND short

/* A = polar_moment(alpha)/resistance_factor(alpha), finite at alpha = 0 where both vanish, 0 <= alpha <= pi/2,
 * best, plain: proved within 3.99 ulp (certificates/dynamic_coefficient.json) */
INLINE double dynamic_coefficient_best_plain(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY16(alpha_2, -0x1.9999999999994p-2, 0x1.5f15f15f15723p-4, -0x1.5ac056af97eb5p-7,
        0x1.d0042cc329a9cp-11, -0x1.8d48a1c521398p-15, 0x1.7ae1913b52dd2p-19, 0x1.9ca7a9c4fe21cp-24,
        0x1.143e3698c3a5ep-25, 0x1.4b5045ea2e1fap-25, -0x1.7955d5936a77ap-25, 0x1.0992dc7bcbf01p-24,
        -0x1.f864667c48d90p-25, 0x1.6acc24dff3191p-25, -0x1.734fa7fd17f63p-26, 0x1.049260a64bfe6p-27,
        -0x1.bfb0b783ae8f0p-30, 0x1.6d9d5170fc716p-33);
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p2 = POLY5(b_2, -0x1.213ce230a79e8p-7, 0x1.94ebfbcf8c0fdp-4, -0x1.0ee063bdf7d00p-5,
        0x1.5582f28f586d2p-8, -0x1.047e200356e2ep-11, 0x1.f52cc7c7dfefdp-16);
    const double p3 = POLY5(b_2, 0x1.55555555565f3p-2, -0x1.5555554df34edp-3, 0x1.27d28a4134219p-5,
        -0x1.2825e27d993d6p-8, 0x1.85f979159b9b1p-12, -0x1.74ce10bfef7f7p-16);
    const double t1 = b * b_2 * (p3 * logarithm_plain(b) + p2) + 0x1.fab71f4a3269fp-7;
    const double t2 = alpha < 0x1.2e147ae147ae1p+0;
    const double t3 = SELECT(t2, 1.0 + p1 * alpha_2, alpha + -0x1.1400000000000p-1 + t1);
    const double p4 = POLY7(alpha_2, -0x1.5555555555555p-4, 0x1.6c16c16c16ba2p-9, -0x1.a01a01a0132c2p-15,
        0x1.27e4fb7471f25p-21, -0x1.1eed8d7449e95p-28, 0x1.93966653151c3p-36, -0x1.ae33aea2b0d55p-44,
        0x1.5aeb95ee17e27p-52);
    const double t4 = p4 * alpha_2;
    const double t5 = SELECT(t2, 1.0 + t4, (alpha_2 * t4 + alpha_2) * alpha);
    return SELECT(t2, t3 / 1.5, t3) / SELECT(t2, t5, t5);
}
#define dynamic_coefficient_best_plain_KIND whole

/* C_theta/Theta* = weight_moment_amplitude(alpha)/moment_of_inertia(alpha), finite at alpha = 0 where both vanish,
 * 0 <= alpha <= pi/2, best, plain: proved within 3.17 ulp (certificates/weight_moment_per_inertia.json) */
INLINE double weight_moment_per_inertia_best_plain(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY9(alpha_2, -0.5, 0x1.bbbbbbbbbbbb8p-4, -0x1.bc466f119b98cp-7, 0x1.22d671ab529c0p-10,
        -0x1.0c7836b0dc07dp-14, 0x1.702ffd0c3458cp-19, -0x1.85d83164ee775p-24, 0x1.4840244c506fap-29,
        -0x1.c070770e543abp-35, 0x1.d3e7e3f9c88d6p-41);
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p2 = POLY7(b_2, -0x1.0000000000006p-2, 0x1.2aaaaaaaaab34p-1, -0x1.5b05b05b06654p-3,
        0x1.bc8bc8bb1d67bp-6, -0x1.637e09681a6fbp-9, 0x1.83ca4d0f33cdbp-13, -0x1.32aba46279bb3p-17,
        0x1.64c78b2442998p-22);
    const double t1 = b * (b * -0.75 + 0.5) + (b_2 * p2 + (b * -0x1.1a62633145c07p-53 + -0x1.194bfdddaf855p-6));
    const double t2 = 0.5 * alpha + -0x1.a000000000000p-4;
    const double t3 = alpha < 0x1.0f5c28f5c28f6p+0;
    const double p3 = POLY10(alpha_2, -0x1.3333333333333p-1, 0x1.ad1ad1ad1acf6p-3, -0x1.74c1f6ca16b80p-5,
        0x1.af3b88aa6ea41p-8, -0x1.615085c1313c5p-11, 0x1.ae8cb1689414fp-15, -0x1.952f81992cfd9p-19,
        0x1.2f47b732005adp-23, -0x1.717211291e65ep-28, 0x1.713e0b35af1d1p-33, -0x1.0da7a75f6871fp-38);
    const double p4 = POLY8(b_2, -0x1.555555555554fp-3, -0x1.c71c71c71c995p-3, 0x1.3e93e93e9679ap-2,
        -0x1.0cbb76624ef26p-3, 0x1.e94dfd2a84da7p-6, -0x1.1e5e14556f803p-8, 0x1.d69dd6e3a84b4p-12,
        -0x1.1e99caf0a78dfp-15, 0x1.00ab575ef75a6p-19);
    const double t4 = SELECT(t3, 1.0 + p3 * alpha_2, t2 + (b * p4 + 0x1.9ffffffffffffp-4));
    return SELECT(t3, 1.0 + p1 * alpha_2, t2 + t1) / t4;
}
#define weight_moment_per_inertia_best_plain_KIND whole

/* C_r/Theta* = radial_weight_amplitude(alpha)/moment_of_inertia(alpha), finite at alpha = 0 where both vanish, 0
 * <= alpha <= pi/2, best, plain: proved within 3.75 ulp (certificates/radial_weight_per_inertia.json) */
INLINE double radial_weight_per_inertia_best_plain(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY17(alpha_2, -0x1.3333333333331p-2, 0x1.c09c09c09b0e7p-6, -0x1.0cbb7660d8f0bp-9,
        -0x1.ebc1b1193de65p-16, -0x1.8bc35755cb770p-16, -0x1.8207776615708p-18, -0x1.ab1617f867c1bp-20,
        -0x1.0358739aa2e8bp-21, -0x1.2056f30bad3a6p-24, -0x1.a89817d793344p-23, 0x1.0e659f269d535p-22,
        -0x1.750d8648525d3p-22, 0x1.6817c7af0123cp-22, -0x1.090e4945627c1p-22, 0x1.1842bd29415d0p-23,
        -0x1.9991739f3798dp-25, 0x1.70ea51a0a09b0p-27, -0x1.3e79820265a98p-30);
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p2 = POLY5(b_2, -0x1.7217f7d1acae6p-7, 0x1.2c981ff6211c9p-1, -0x1.5fec36ee4b768p-4,
        0x1.c0f9c0515effdp-8, -0x1.5c6d8636f92ccp-12, 0x1.64009ce2f3630p-17);
    const double p3 = POLY5(b_2, 0x1.000000000015dp+0, -0x1.5555555455f4cp-2, 0x1.6c16c49fd75c7p-5,
        -0x1.a01620d59d215p-9, 0x1.28ae92a1ef664p-13, -0x1.27ac624df162ep-18);
    const double t1 = b * (b * -1.875 + 0.5) + (b_2 * (p3 * logarithm_plain(2.0 * b) + p2) + 0x1.5e04abbbd2e80p-5);
    const double t2 = 0.5 * alpha;
    const double t3 = alpha < 0x1.1eb851eb851ecp+0;
    const double p4 = POLY10(alpha_2, -0x1.3333333333333p-1, 0x1.ad1ad1ad1acf1p-3, -0x1.74c1f6ca169d6p-5,
        0x1.af3b88aa67b1bp-8, -0x1.615085c03c10ep-11, 0x1.ae8cb1407cfe4p-15, -0x1.952f7d837ab6fp-19,
        0x1.2f47742ab1046p-23, -0x1.716cd10e1367cp-28, 0x1.71035aeccbd2cp-33, -0x1.0c8fef86260a6p-38);
    const double p5 = POLY8(b_2, -0x1.555555555554dp-3, -0x1.c71c71c71cc85p-3, 0x1.3e93e93e9e0d6p-2,
        -0x1.0cbb76644f474p-3, 0x1.e94dfe3da88b8p-6, -0x1.1e5e3d4c60700p-8, 0x1.d6ab8ca876bdep-12,
        -0x1.1fcee5678494fp-15, 0x1.16f943a246fa1p-19);
    const double t4 = SELECT(t3, 1.0 + p4 * alpha_2, t2 + -0x1.8000000000000p-4 + (b * p5 + 0x1.7ffffffffffffp-4));
    return SELECT(t3, 1.0 + p1 * alpha_2, t2 + 0x1.6000000000000p-3 + t1) / t4;
}
#define radial_weight_per_inertia_best_plain_KIND whole

/* I_p* /Theta* = polar_moment(alpha)/moment_of_inertia(alpha), finite at alpha = 0 where both vanish, 0 <= alpha
 * <= pi/2, best, plain: proved within 3.01 ulp (certificates/polar_moment_per_inertia.json) */
INLINE double polar_moment_per_inertia_best_plain(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY12(alpha_2, -0x1.9999999999989p-2, 0x1.5f15f15f14b9cp-4, -0x1.5ac056af15827p-7,
        0x1.d0042c6d017fep-11, -0x1.8d4885b4b5809p-15, 0x1.7adecfc69194fp-19, 0x1.9a231cb6effb3p-24,
        0x1.3a43a49a6a763p-25, 0x1.8e95c135f0567p-26, -0x1.5a5f166c6032dp-27, 0x1.6d70197211f4ap-27,
        -0x1.19d3973aa36cap-28, 0x1.1eee76bd622b2p-30);
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p2 = POLY5(b_2, -0x1.eb440e0d5b068p-3, 0x1.b70e1da718514p-3, -0x1.dbecf43061ae4p-5,
        0x1.115fe28110038p-7, -0x1.8a9e832d9844dp-11, 0x1.af511ed3efee7p-15);
    const double p3 = POLY5(b_2, 0x1.55555555518aap-2, -0x1.5555556697b7dp-3, 0x1.27d268328778dp-5,
        -0x1.283af2ca91d53p-8, 0x1.7ff85a336a890p-12, -0x1.b634872dcba2dp-16);
    const double t1 = b * b_2 * (p3 * logarithm_plain(2.0 * b) + p2) + 0x1.7d5b8fa51934fp-6;
    const double t2 = alpha < 1.0;
    const double p4 = POLY9(alpha_2, -0x1.3333333333330p-1, 0x1.ad1ad1ad1aaafp-3, -0x1.74c1f6ca0d41bp-5,
        0x1.af3b88a801647p-8, -0x1.61508565a6444p-11, 0x1.ae8ca0b5c00e3p-15, -0x1.952d8ea52153ep-19,
        0x1.2f2260a235af0p-23, -0x1.6dfaada66d5aep-28, 0x1.42b63276d0e01p-33);
    const double p5 = POLY9(b_2, -0x1.555555555554ep-3, -0x1.c71c71c71cad2p-3, 0x1.3e93e93e9959dp-2,
        -0x1.0cbb76630619cp-3, 0x1.e94dfd8b6e6d2p-6, -0x1.1e5e23528aa32p-8, 0x1.d6a371cc475cdp-12,
        -0x1.1f397f95f7403p-15, 0x1.1425220d45aaap-19, -0x1.00589fe65ed98p-23);
    const double t3 = 0.5 * alpha + -0x1.e000000000000p-4 + (b * p5 + 0x1.dffffffffffffp-4);
    const double t4 = SELECT(t2, 1.0 + p1 * alpha_2, alpha + -0x1.1800000000000p-1 + t1);
    return t4 / SELECT(t2, 1.0 + p4 * alpha_2, t3);
}
#define polar_moment_per_inertia_best_plain_KIND whole

/* C_theta/C_r = weight_moment_amplitude(alpha)/radial_weight_amplitude(alpha), finite at alpha = 0 where both
 * vanish, 0 <= alpha <= pi/2, best, plain: proved within 4 ulp (certificates/weight_moment_per_radial_weight.json) */
INLINE double weight_moment_per_radial_weight_best_plain(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY9(alpha_2, -0.5, 0x1.bbbbbbbbbbbafp-4, -0x1.bc466f119b448p-7, 0x1.22d671ab3f983p-10,
        -0x1.0c7836ac674c6p-14, 0x1.702ffbd6802c0p-19, -0x1.85d7fece9ce4fp-24, 0x1.483b3c6f03034p-29,
        -0x1.bfeb30e74d917p-35, 0x1.cdf1a753f4825p-41);
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p2 = POLY7(b_2, -0x1.fffffffffff95p-4, 0x1.2aaaaaaaaa534p-1, -0x1.5b05b05ace2a9p-3,
        0x1.bc8bc899c38eep-6, -0x1.637dfe720b520p-9, 0x1.83c64150f3de6p-13, -0x1.31e2be57bfe01p-17,
        0x1.44ebe008475edp-22);
    const double t1 = b * (b * -0.875 + 0.5) + (b_2 * p2 + (b * -0x1.1a62633145c07p-53 + -0x1.8ca5feeed7c2bp-5));
    const double t2 = 0.5 * alpha;
    const double t3 = alpha < 0x1.2147ae147ae14p+0;
    const double p3 = POLY16(alpha_2, -0x1.3333333333349p-2, 0x1.c09c09c0a459dp-6, -0x1.0cbb766afe79ap-9,
        -0x1.ebc156b09ffa0p-16, -0x1.8bc71e89b0d50p-16, -0x1.819d1f4cc4434p-18, -0x1.b33a96b385a3ap-20,
        -0x1.934ebccf8890ep-22, -0x1.76f325364bf99p-22, 0x1.81cf0f1950821p-22, -0x1.388ba79ae4b66p-21,
        0x1.41fbbd705974ep-21, -0x1.fdd2802ad00e9p-22, 0x1.1df88390028d7p-22, -0x1.b99771f548ac0p-24,
        0x1.a164ea493de27p-26, -0x1.79fb0a146f1a6p-29);
    const double p4 = POLY5(b_2, -0x1.7217f7d1ab2e7p-7, 0x1.2c981ff63ec19p-1, -0x1.5fec368b1249bp-4,
        0x1.c0fa11c3186cdp-8, -0x1.5c79b09b316eap-12, 0x1.5cb02195a47e5p-17);
    const double p5 = POLY5(b_2, 0x1.0000000000169p+0, -0x1.555555543d7fdp-2, 0x1.6c16c52a07b2ap-5,
        -0x1.a015173aabdaap-9, 0x1.2910a202b16c5p-13, -0x1.1e2016c290c5cp-18);
    const double t4 = b * (b * -1.875 + 0.5) + (b_2 * (p5 * logarithm_plain(2.0 * b) + p4) + 0x1.5e04abbbd2e80p-5);
    const double t5 = SELECT(t3, 1.0 + p1 * alpha_2, t2 + -0x1.2000000000000p-4 + t1);
    return t5 / SELECT(t3, 1.0 + p3 * alpha_2, t2 + 0x1.6000000000000p-3 + t4);
}
#define weight_moment_per_radial_weight_best_plain_KIND whole

/* A block of numbers is looked at first, as integers: patterns of floats from 0 on are ordered as the floats are, and a
 * negative difference has its sign bit set. If all lie in [0, pi/2], as a rule, the program runs bare; if all lie below
 * its seam, its first piece alone. Else `refused` has the bits of NaN for what is outside the domain, which make a NaN
 * of any result. A loop may run in place, or on an input that lies ahead of its output. */
#define PASS(T, STATEMENTS) \
    INDEPENDENT \
    for (npy_intp i = start; i < stop; i++) { \
        const double x = in[i]; \
        STATEMENTS \
    }
#define CAREFUL(T, PROGRAM) \
    const double clipped = x < HALF_PI ? x : HALF_PI; /* NaN becomes pi/2 */ \
    const double sign = clipped >= 0.0 ? 0.0 : NAN; \
    const uint64_t refused = bits(x <= END_##T ? sign : NAN); \
    out[i] = (T)number(bits(PROGRAM(clipped)) | refused); \
    outside |= refused;
#define BARE(T, PROGRAM) PASS(T, out[i] = (T)PROGRAM(x);)
/* Kinds of programs: of two pieces, whole, or so short that over doubles care costs less than a look. */
#define LOOK_pieces(T) 1
#define LOOK_whole(T) 1
#define LOOK_short(T) (sizeof(T) == sizeof(float))
#define ABOVE_pieces(T, PROGRAM, pattern) PROGRAM##_BELOW_##T - pattern
#define ABOVE_whole(T, PROGRAM, pattern) 0
#define ABOVE_short(T, PROGRAM, pattern) 0
#define RUN_pieces(T, PROGRAM) if (NEGATIVE(above)) BARE(T, PROGRAM) else BARE(T, PROGRAM##_near)
#define RUN_whole(T, PROGRAM) BARE(T, PROGRAM)
#define RUN_short(T, PROGRAM) BARE(T, PROGRAM)
#define LOOP(T, NAME, FORM, LEVEL) LOOP_OF(T, NAME##_##FORM##_KIND, NAME##_##FORM, NAME##_##LEVEL##_##T, LEVEL)
#define LOOP_OF(T, KIND, PROGRAM, LOOP_NAME, LEVEL) LOOP_KIND(T, KIND, PROGRAM, LOOP_NAME, LEVEL)
#define LOOP_KIND(T, KIND, PROGRAM, LOOP_NAME, LEVEL) \
    TARGET_##LEVEL static int LOOP_NAME(const void *from, void *to, npy_intp count) \
    { \
        const T *in = from; \
        T *out = to; \
        uint64_t outside = 0; \
        for (npy_intp start = 0, stop; start < count; start = stop) { \
            PATTERN_##T beyond = 0, above = 0; \
            stop = count - start < BLOCK ? count : start + BLOCK; \
            for (npy_intp i = start; LOOK_##KIND(T) && i < stop; i++) { \
                const PATTERN_##T pattern = pattern_##T(in[i]); \
                beyond |= (LAST_##T - pattern) | pattern; \
                above |= ABOVE_##KIND(T, PROGRAM, pattern); \
            } \
            if (!LOOK_##KIND(T) || NEGATIVE(beyond)) { \
                PASS(T, CAREFUL(T, PROGRAM)) \
            } \
            else { \
                RUN_##KIND(T, PROGRAM) \
            } \
            (void)above; \
        } \
        return outside != 0; \
    }

#define LOOPS(LEVEL, FORM) \
    LOOP(double, polar_moment_best, FORM, LEVEL) \
    LOOP(double, polar_moment_1e_10, FORM, LEVEL) \
    LOOP(double, polar_moment_1e_6, FORM, LEVEL) \
    LOOP(double, moment_of_inertia_best, FORM, LEVEL) \
    LOOP(double, moment_of_inertia_1e_10, FORM, LEVEL) \
    LOOP(double, moment_of_inertia_1e_6, FORM, LEVEL) \
    LOOP(double, radial_weight_amplitude_best, FORM, LEVEL) \
    LOOP(double, radial_weight_amplitude_1e_10, FORM, LEVEL) \
    LOOP(double, radial_weight_amplitude_1e_6, FORM, LEVEL) \
    LOOP(double, weight_moment_amplitude_best, FORM, LEVEL) \
    LOOP(double, weight_moment_amplitude_1e_10, FORM, LEVEL) \
    LOOP(double, weight_moment_amplitude_1e_6, FORM, LEVEL) \
    LOOP(double, resistance_factor_best, FORM, LEVEL) \
    LOOP(double, resistance_factor_1e_10, FORM, LEVEL) \
    LOOP(double, resistance_factor_1e_6, FORM, LEVEL) \
    LOOP(double, dynamic_coefficient_best, FORM, LEVEL) \
    LOOP(double, weight_moment_per_inertia_best, FORM, LEVEL) \
    LOOP(double, radial_weight_per_inertia_best, FORM, LEVEL) \
    LOOP(double, polar_moment_per_inertia_best, FORM, LEVEL) \
    LOOP(double, weight_moment_per_radial_weight_best, FORM, LEVEL) \
    LOOP(float, polar_moment_float32, FORM, LEVEL) \
    LOOP(float, moment_of_inertia_float32, FORM, LEVEL) \
    LOOP(float, radial_weight_amplitude_float32, FORM, LEVEL) \
    LOOP(float, weight_moment_amplitude_float32, FORM, LEVEL) \
    LOOP(float, resistance_factor_float32, FORM, LEVEL) \
    LOOP(float, dynamic_coefficient_best, FORM, LEVEL) \
    LOOP(float, weight_moment_per_inertia_best, FORM, LEVEL) \
    LOOP(float, radial_weight_per_inertia_best, FORM, LEVEL) \
    LOOP(float, polar_moment_per_inertia_best, FORM, LEVEL) \
    LOOP(float, weight_moment_per_radial_weight_best, FORM, LEVEL)
LEVELS(LOOPS)

/* The first unsafe float flag that this was compiled with, or NULL. */
INLINE const char *unsafe(void)
{
    static volatile const double numbers[] = {1.0, 0x1p-60, 1.0 + 0x1p-30, 1.0 + 0x1p-29, DBL_MIN, 5.0, 5.0 / 3.0, NAN};
    const double one = numbers[0], tiny = numbers[1], odd = numbers[2], square = numbers[3], least = numbers[4];
    const double five = numbers[5], quotient = numbers[6], nan = numbers[7];
    if ((one + tiny) - one != 0.0) return "sums are reordered";
    if (odd * odd - square != 0.0) return "products and sums are contracted";
    if (least / 4.0 * 4.0 != least) return "subnormal numbers are flushed to zero";
    if (five / 3.0 != quotient) return "divisions are multiplications by a reciprocal";
    if (nan == nan) return "NaN is not expected";
    return NULL;
}
#define UNSAFE(LEVEL, FORM) TARGET_##LEVEL static const char *unsafe_##LEVEL(void) { return unsafe(); }
LEVELS(UNSAFE)

typedef int (*Loop)(const void *, void *, npy_intp);

/* NumPy's inner loop around one of ours: strided operands go through a block. Of the exceptions only `invalid` is
 * meant, for what is outside: an underflow is correctly rounded, and pieces that are not used may raise anything. */
enum { RAISED = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW | FE_UNDERFLOW };

INLINE void walk(char **args, npy_intp const *count, npy_intp const *steps, Loop loop, size_t size)
{
    const int before = fetestexcept(RAISED);
    int outside = 0;
    if (steps[0] == (npy_intp)size && steps[1] == (npy_intp)size) {
        outside = loop(args[0], args[1], *count);
    }
    else {
        double in[BLOCK], out[BLOCK];
        for (npy_intp done = 0; done < *count; done += BLOCK) {
            const npy_intp n = *count - done < BLOCK ? *count - done : BLOCK;
            const char *from = args[0] + done * steps[0];
            char *to = args[1] + done * steps[1];
            for (npy_intp i = 0; i < n; i++) memcpy((char *)in + i * size, from + i * steps[0], size);
            outside |= loop(in, out, n);
            for (npy_intp i = 0; i < n; i++) memcpy(to + i * steps[1], (char *)out + i * size, size);
        }
    }
    if (fetestexcept(RAISED) & ~before) feclearexcept(RAISED & ~before);
    if (outside) feraiseexcept(FE_INVALID);
}

static void walk_float(char **args, npy_intp const *count, npy_intp const *steps, void *loop)
{
    walk(args, count, steps, (Loop)loop, sizeof(float));
}

static void walk_double(char **args, npy_intp const *count, npy_intp const *steps, void *loop)
{
    walk(args, count, steps, (Loop)loop, sizeof(double));
}

static PyUFuncGenericFunction walks[] = {walk_float, walk_double};
static const char types[] = {NPY_FLOAT, NPY_FLOAT, NPY_DOUBLE, NPY_DOUBLE};

/* A ufunc; where `loops[0]` is NULL it has no loop for float32. */
typedef struct { const char *kernel, *tier; void *loops[2]; } Ufunc;

#define UFUNCS(LEVEL, FORM) \
    static Ufunc ufuncs_##LEVEL[] = { \
    {"polar_moment", "best", {(void *)polar_moment_float32_##LEVEL##_float, (void *)polar_moment_best_##LEVEL##_double}}, \
    {"polar_moment", "1e-10", {NULL, (void *)polar_moment_1e_10_##LEVEL##_double}}, \
    {"polar_moment", "1e-6", {NULL, (void *)polar_moment_1e_6_##LEVEL##_double}}, \
    {"moment_of_inertia", "best", {(void *)moment_of_inertia_float32_##LEVEL##_float, (void *)moment_of_inertia_best_##LEVEL##_double}}, \
    {"moment_of_inertia", "1e-10", {NULL, (void *)moment_of_inertia_1e_10_##LEVEL##_double}}, \
    {"moment_of_inertia", "1e-6", {NULL, (void *)moment_of_inertia_1e_6_##LEVEL##_double}}, \
    {"radial_weight_amplitude", "best", {(void *)radial_weight_amplitude_float32_##LEVEL##_float, (void *)radial_weight_amplitude_best_##LEVEL##_double}}, \
    {"radial_weight_amplitude", "1e-10", {NULL, (void *)radial_weight_amplitude_1e_10_##LEVEL##_double}}, \
    {"radial_weight_amplitude", "1e-6", {NULL, (void *)radial_weight_amplitude_1e_6_##LEVEL##_double}}, \
    {"weight_moment_amplitude", "best", {(void *)weight_moment_amplitude_float32_##LEVEL##_float, (void *)weight_moment_amplitude_best_##LEVEL##_double}}, \
    {"weight_moment_amplitude", "1e-10", {NULL, (void *)weight_moment_amplitude_1e_10_##LEVEL##_double}}, \
    {"weight_moment_amplitude", "1e-6", {NULL, (void *)weight_moment_amplitude_1e_6_##LEVEL##_double}}, \
    {"resistance_factor", "best", {(void *)resistance_factor_float32_##LEVEL##_float, (void *)resistance_factor_best_##LEVEL##_double}}, \
    {"resistance_factor", "1e-10", {NULL, (void *)resistance_factor_1e_10_##LEVEL##_double}}, \
    {"resistance_factor", "1e-6", {NULL, (void *)resistance_factor_1e_6_##LEVEL##_double}}, \
    {"dynamic_coefficient", "best", {(void *)dynamic_coefficient_best_##LEVEL##_float, (void *)dynamic_coefficient_best_##LEVEL##_double}}, \
    {"weight_moment_per_inertia", "best", {(void *)weight_moment_per_inertia_best_##LEVEL##_float, (void *)weight_moment_per_inertia_best_##LEVEL##_double}}, \
    {"radial_weight_per_inertia", "best", {(void *)radial_weight_per_inertia_best_##LEVEL##_float, (void *)radial_weight_per_inertia_best_##LEVEL##_double}}, \
    {"polar_moment_per_inertia", "best", {(void *)polar_moment_per_inertia_best_##LEVEL##_float, (void *)polar_moment_per_inertia_best_##LEVEL##_double}}, \
    {"weight_moment_per_radial_weight", "best", {(void *)weight_moment_per_radial_weight_best_##LEVEL##_float, (void *)weight_moment_per_radial_weight_best_##LEVEL##_double}}, \
    {NULL, NULL, {NULL, NULL}}};
LEVELS(UFUNCS)

static PyObject *ufuncs(Ufunc *table)
{
    PyObject *tiers = PyDict_New();
    for (; tiers && table->kernel; table++) {
        const int first = table->loops[0] == NULL;
        PyObject *ufunc = PyUFunc_FromFuncAndData(walks + first, table->loops + first, types + 2 * first, 2 - first,
                                                  1, 1, PyUFunc_None, table->kernel, table->tier, 0);
        PyObject *of_tier = PyDict_GetItemString(tiers, table->tier); /* borrowed */
        if (of_tier == NULL && (of_tier = PyDict_New()) != NULL) {
            const int failed = PyDict_SetItemString(tiers, table->tier, of_tier);
            Py_DECREF(of_tier);
            if (failed) of_tier = NULL;
        }
        if (ufunc == NULL || of_tier == NULL || PyDict_SetItemString(of_tier, table->kernel, ufunc)) Py_CLEAR(tiers);
        Py_XDECREF(ufunc);
    }
    return tiers;
}

/* DIGEST of the source; LEVELS: level -> (form, tier -> kernel -> ufunc), the widest first; UNSAFE: a flag, or None. */
static int fill(PyObject *module)
{
    PyObject *levels = PyDict_New();
    const char *flag = NULL;
    int failed = PyArray_ImportNumPyAPI() < 0 || PyUFunc_ImportUFuncAPI() < 0 || levels == NULL;
#ifdef RUNS_avx2
    __builtin_cpu_init();
#endif
#define ADD(LEVEL, FORM) \
    if (!failed && (RUNS_##LEVEL)) { \
        PyObject *pair = Py_BuildValue("(sN)", #FORM, ufuncs(ufuncs_##LEVEL)); \
        failed = pair == NULL || PyDict_SetItemString(levels, #LEVEL, pair); \
        Py_XDECREF(pair); \
        flag = flag ? flag : unsafe_##LEVEL(); \
    }
    LEVELS(ADD)
    failed = failed || PyModule_AddObjectRef(module, "LEVELS", levels) ||
             PyModule_AddStringConstant(module, "DIGEST", DIGEST) ||
             (flag ? PyModule_AddStringConstant(module, "UNSAFE", flag)
                   : PyModule_AddObjectRef(module, "UNSAFE", Py_None));
    Py_XDECREF(levels);
    return failed ? -1 : 0;
}

static PyModuleDef_Slot slots[] = {
    {Py_mod_exec, fill},
#ifdef Py_mod_gil
    {Py_mod_gil, Py_MOD_GIL_NOT_USED},
#endif
    {0, NULL},
};
static struct PyModuleDef definition = {PyModuleDef_HEAD_INIT, "_kernels", NULL, 0, NULL, slots, NULL, NULL, NULL};
PyMODINIT_FUNC PyInit__kernels(void) { return PyModuleDef_Init(&definition); }
