/* Written by `python -m derive` with SymPy 1.14.0; do not edit. */
#define DIGEST "0926378a030668ec9f81476563cf13fa07eedf9fd6b79a1c865c125873c24079"
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
 * proved within 0.83 ulp (certificates/polar_moment.json) */
/* alpha < 0.93 */
INLINE double polar_moment_best_fused_near(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double t1 = -alpha_2;
    const double alpha_4 = alpha_2 * alpha_2;
    const double p1 = POLY4(alpha_4, 0x1.35581eb7b9c4ep-11, 0x1.f97dd8a440e49p-20, 0x1.20dc3d60db7aap-25,
        0x1.1cf83c1392ee5p-27, 0x1.5a4eb8d4fdf16p-30);
    const double p2 = POLY4(alpha_4, -0x1.ce55c8ec1b57ap-8, -0x1.08db8c9edc7c7p-15, 0x1.ffc5bb85d3a0bp-25,
        0x1.372e5bb516f5ap-30, -0x1.a3e7d0b8cee94p-29);
    const double t2 = FMA(alpha_2, FMA(alpha_2, p1, p2), 0x1.d41d41d41edeap-5);
    const double t3 = FMA(t2, alpha_2, -0x1.111111111111cp-2);
    const double t4 = FMA(t3, alpha_2, 0x1.5555555555555p-1);
    const double t5 = -0x1.111111111111cp-2 - t3;
    const double t6 = FMA(t3, alpha_2, 0x1.5555555555555p-1 - t4) + 0x1.5555555555555p-55;
    const double t7 = alpha_2 * t4;
    const double t8 = FMA(t1, t5, FMA(2.0, t4, -0x1.5555555555555p-1));
    const double t9 = FMA(FMA(alpha, alpha, t1), t8, FMA(alpha_2, t4, -t7));
    return FMA(alpha, t7, alpha * FMA(alpha_2, FMA(alpha_2, FMA(t2, alpha_2, t5), t6), t9));
}
/* alpha >= 0.93, in b = pi/2 - alpha */
INLINE double polar_moment_best_fused_far(double alpha)
{
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p1 = POLY5(b_2, 0x1.55555555579d1p-2, -0x1.555555518e7c3p-3, 0x1.27d279e0496b5p-5,
        -0x1.2834e1f3e1a60p-8, 0x1.80dce9acbd0ffp-12, -0x1.b16de590ed744p-16);
    const double p2 = POLY5(b_2, -0x1.213ce230290f3p-7, 0x1.94ebfbb2ec66fp-4, -0x1.0ee086df8c2f9p-5,
        0x1.556ffb39c3af9p-8, -0x1.058aebdba383ap-11, 0x1.1477caa143cfbp-15);
    const double t1 = FMA(b * b_2, FMA(p1, logarithm_fused(b), p2), 0x1.ee6913347c2a6p-55);
    return alpha + -0x1.0c152382d7366p-1 + t1;
}
INLINE double polar_moment_best_fused(double alpha)
{
    const double near = polar_moment_best_fused_near(alpha);
    const double far = polar_moment_best_fused_far(alpha);
    return SELECT(alpha < 0x1.dc28f5c28f5c3p-1, near, far);
}
#define polar_moment_best_fused_KIND pieces
#define polar_moment_best_fused_BELOW_double UINT64_C(0x3fedc28f5c28f5c2)
#define polar_moment_best_fused_BELOW_float UINT32_C(0x3f6e147a)

/* Theta* = alpha/2 - sin(2*alpha)/6 - sin(4*alpha)/24, 0 <= alpha <= pi/2, best, fused: proved within 0.783 ulp
 * (certificates/moment_of_inertia.json) */
/* alpha < 1.0 */
INLINE double moment_of_inertia_best_fused_near(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double t1 = -alpha_2;
    const double alpha_4 = alpha_2 * alpha_2;
    const double p1 = POLY3(alpha_4, 0x1.1f7d05c72fc3ap-8, 0x1.1f0877c40acffp-15, 0x1.9465eeb660151p-24,
        0x1.f3cdbf532eaf7p-34);
    const double p2 = POLY4(alpha_4, -0x1.f1029e62cad66p-6, -0x1.d71607bd2727dp-12, -0x1.0e1fd712de8dbp-19,
        -0x1.ed2a462794ae8p-29, -0x1.91e6b7ad796a6p-39);
    const double t2 = FMA(alpha_2, FMA(alpha_2, p1, p2), 0x1.1e11e11e11e36p-3);
    const double t3 = FMA(t2, alpha_2, -0x1.999999999999ap-2);
    const double t4 = FMA(t3, alpha_2, 0x1.5555555555555p-1);
    const double t5 = -0x1.999999999999ap-2 - t3;
    const double t6 = FMA(t3, alpha_2, 0x1.5555555555555p-1 - t4) + 0x1.5555555555555p-55;
    const double t7 = alpha_2 * t4;
    const double t8 = FMA(t1, t5, FMA(2.0, t4, -0x1.5555555555555p-1));
    const double t9 = FMA(FMA(alpha, alpha, t1), t8, FMA(alpha_2, t4, -t7));
    return FMA(alpha, t7, alpha * FMA(alpha_2, FMA(alpha_2, FMA(t2, alpha_2, t5), t6), t9));
}
/* alpha >= 1.0, in b = pi/2 - alpha */
INLINE double moment_of_inertia_best_fused_far(double alpha)
{
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p1 = POLY9(b_2, -0x1.555555555554ep-3, -0x1.c71c71c71cad2p-3, 0x1.3e93e93e9959dp-2,
        -0x1.0cbb76630619cp-3, 0x1.e94dfd8b6e6d2p-6, -0x1.1e5e23528aa32p-8, 0x1.d6a371cc475cdp-12,
        -0x1.1f397f95f7403p-15, 0x1.1425220d45aaap-19, -0x1.00589fe65ed98p-23);
    return 0.5 * alpha + -0x1.e000000000000p-4 + FMA(b, p1, 0x1.dffffffffffffp-4);
}
INLINE double moment_of_inertia_best_fused(double alpha)
{
    const double near = moment_of_inertia_best_fused_near(alpha);
    const double far = moment_of_inertia_best_fused_far(alpha);
    return SELECT(alpha < 1.0, near, far);
}
#define moment_of_inertia_best_fused_KIND pieces
#define moment_of_inertia_best_fused_BELOW_double UINT64_C(0x3fefffffffffffff)
#define moment_of_inertia_best_fused_BELOW_float UINT32_C(0x3f7fffff)

/* C_r = sin(alpha) - cos(alpha)**2*atanh(sin(alpha)), 0 <= alpha <= pi/2, best, fused: proved within 0.889 ulp
 * (certificates/radial_weight_amplitude.json) */
/* alpha < 1.02 */
INLINE double radial_weight_amplitude_best_fused_near(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double t1 = -alpha_2;
    const double alpha_4 = alpha_2 * alpha_2;
    const double p1 = POLY5(alpha_4, -0x1.47d654b129ff9p-16, -0x1.01343350b0275p-18, -0x1.31eb80a2fef7dp-22,
        0x1.ce69726473d26p-25, 0x1.59d79b38274bdp-24, 0x1.1daae6a223a3dp-26);
    const double p2 = POLY6(alpha_4, -0x1.664f4888b6cd1p-10, -0x1.07d8efa7a3041p-16, -0x1.1f97784d3fc01p-20,
        -0x1.2d7a3353abe26p-23, -0x1.cb311e1e7579cp-24, -0x1.a2c353c442e22p-25, -0x1.9d4044a7034c3p-29);
    const double t2 = FMA(alpha_2, FMA(alpha_2, p1, p2), 0x1.2b12b12b158cap-6);
    const double t3 = FMA(t2, alpha_2, -0x1.99999999999a9p-3);
    const double t4 = FMA(t3, alpha_2, 0x1.5555555555555p-1);
    const double t5 = -0x1.99999999999a9p-3 - t3;
    const double t6 = FMA(t3, alpha_2, 0x1.5555555555555p-1 - t4) + 0x1.5555555555555p-55;
    const double t7 = alpha_2 * t4;
    const double t8 = FMA(t1, t5, FMA(2.0, t4, -0x1.5555555555555p-1));
    const double t9 = FMA(FMA(alpha, alpha, t1), t8, FMA(alpha_2, t4, -t7));
    return FMA(alpha, t7, alpha * FMA(alpha_2, FMA(alpha_2, FMA(t2, alpha_2, t5), t6), t9));
}
/* alpha >= 1.02, in b = pi/2 - alpha */
INLINE double radial_weight_amplitude_best_fused_far(double alpha)
{
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p1 = POLY5(b_2, 0x1.00000000000b6p+0, -0x1.555555554900ap-2, 0x1.6c16c0a0e6534p-5,
        -0x1.a01c15d7033acp-9, 0x1.26ecb6ae67667p-13, -0x1.4b80ca7eaf925p-18);
    const double p2 = POLY5(b_2, -0x1.7217f7d1c0c33p-7, 0x1.2c981ff50df71p-1, -0x1.5fec3987413d3p-4,
        0x1.c0f84768fd081p-8, -0x1.5c1de3bda9c32p-12, 0x1.8128754f493fdp-17);
    return 1.0 - b + FMA(b, FMA(b, -1.875, 1.0), b_2 * FMA(p1, logarithm_fused(2.0 * b), p2));
}
INLINE double radial_weight_amplitude_best_fused(double alpha)
{
    const double near = radial_weight_amplitude_best_fused_near(alpha);
    const double far = radial_weight_amplitude_best_fused_far(alpha);
    return SELECT(alpha < 0x1.051eb851eb852p+0, near, far);
}
#define radial_weight_amplitude_best_fused_KIND pieces
#define radial_weight_amplitude_best_fused_BELOW_double UINT64_C(0x3ff051eb851eb851)
#define radial_weight_amplitude_best_fused_BELOW_float UINT32_C(0x3f828f5c)

/* C_theta = 2*sin(alpha)**3/3, 0 <= alpha <= pi/2, best, fused: proved within 0.824 ulp
 * (certificates/weight_moment_amplitude.json) */
/* alpha < 1.14 */
INLINE double weight_moment_amplitude_best_fused_near(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double t1 = -alpha_2;
    const double alpha_4 = alpha_2 * alpha_2;
    const double p1 = POLY3(alpha_4, 0x1.83c8978ec53afp-11, 0x1.eaeaa2cd96bc4p-20, 0x1.b59da2f914bb4p-30,
        0x1.30e9ff831c7c7p-41);
    const double p2 = POLY3(alpha_4, -0x1.282ef4b666c9dp-7, -0x1.65f59e30b1564p-15, -0x1.03e52c1c9f8cfp-24,
        -0x1.2a4e8655ba3f6p-35);
    const double t2 = FMA(alpha_2, FMA(alpha_2, p1, p2), 0x1.27d27d27d27a5p-4);
    const double t3 = FMA(t2, alpha_2, -0x1.5555555555555p-2);
    const double t4 = FMA(t3, alpha_2, 0x1.5555555555555p-1);
    const double t5 = -0x1.5555555555555p-2 - t3;
    const double t6 = FMA(t3, alpha_2, 0x1.5555555555555p-1 - t4) + 0x1.5555555555555p-55;
    const double t7 = alpha_2 * t4;
    const double t8 = FMA(t1, t5, FMA(2.0, t4, -0x1.5555555555555p-1));
    const double t9 = FMA(FMA(alpha, alpha, t1), t8, FMA(alpha_2, t4, -t7));
    return FMA(alpha, t7, alpha * FMA(alpha_2, FMA(alpha_2, FMA(t2, alpha_2, t5), t6), t9));
}
/* alpha >= 1.14, in b = pi/2 - alpha */
INLINE double weight_moment_amplitude_best_fused_far(double alpha)
{
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double b_4 = b_2 * b_2;
    const double p1 = POLY6(b_2, 0x1.2aaaaaaaaaab3p-1, -0x1.5b05b05b057bfp-3, 0x1.bc8bc8bc177d0p-6,
        -0x1.637e0a0dbbad2p-9, 0x1.83ca9db15ed0ep-13, -0x1.32bd9577001abp-17, 0x1.67d5bb5cbd93ep-22);
    const double t1 = FMA(b, 0.5 - b, FMA(b_4, p1, FMA(b, -0x1.1a62633145c07p-53, -0x1.5555555555556p-54)));
    return 0.5 * alpha + -0x1.e652ff776be10p-4 + t1;
}
INLINE double weight_moment_amplitude_best_fused(double alpha)
{
    const double near = weight_moment_amplitude_best_fused_near(alpha);
    const double far = weight_moment_amplitude_best_fused_far(alpha);
    return SELECT(alpha < 0x1.23d70a3d70a3dp+0, near, far);
}
#define weight_moment_amplitude_best_fused_KIND pieces
#define weight_moment_amplitude_best_fused_BELOW_double UINT64_C(0x3ff23d70a3d70a3c)
#define weight_moment_amplitude_best_fused_BELOW_float UINT32_C(0x3f91eb85)

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

/* A = polar_moment(alpha)/resistance_factor(alpha), finite at alpha = 0 where both vanish, 0 <= alpha <= pi/2,
 * best, fused: proved within 0.924 ulp (certificates/dynamic_coefficient.json) */
INLINE double dynamic_coefficient_best_fused(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double alpha_4 = alpha_2 * alpha_2;
    const double p1 = POLY4(alpha_4, 0x1.35581eb7b9c4ep-11, 0x1.f97dd8a440e49p-20, 0x1.20dc3d60db7aap-25,
        0x1.1cf83c1392ee5p-27, 0x1.5a4eb8d4fdf16p-30);
    const double p2 = POLY4(alpha_4, -0x1.ce55c8ec1b57ap-8, -0x1.08db8c9edc7c7p-15, 0x1.ffc5bb85d3a0bp-25,
        0x1.372e5bb516f5ap-30, -0x1.a3e7d0b8cee94p-29);
    const double t1 = FMA(alpha_2, FMA(alpha_2, p1, p2), 0x1.d41d41d41edeap-5);
    const double t2 = FMA(t1, alpha_2, -0x1.111111111111cp-2);
    const double t3 = FMA(t2, alpha_2, 0x1.5555555555555p-1);
    const double t4 = FMA(t2, alpha_2, 0x1.5555555555555p-1 - t3) + 0x1.5555555555555p-55;
    const double t5 = FMA(alpha, alpha, -alpha_2);
    const double t6 = FMA(t5, t2, FMA(alpha_2, FMA(t1, alpha_2, -0x1.111111111111cp-2 - t2), t4));
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p3 = POLY5(b_2, 0x1.55555555579d1p-2, -0x1.555555518e7c3p-3, 0x1.27d279e0496b5p-5,
        -0x1.2834e1f3e1a60p-8, 0x1.80dce9acbd0ffp-12, -0x1.b16de590ed744p-16);
    const double p4 = POLY5(b_2, -0x1.213ce230290f3p-7, 0x1.94ebfbb2ec66fp-4, -0x1.0ee086df8c2f9p-5,
        0x1.556ffb39c3af9p-8, -0x1.058aebdba383ap-11, 0x1.1477caa143cfbp-15);
    const double t7 = alpha + -0x1.0c152382d7366p-1;
    const double t8 = FMA(b * b_2, FMA(p3, logarithm_fused(b), p4), 0x1.ee6913347c2a6p-55);
    const double t9 = t7 + t8;
    const double t10 = alpha < 0x1.dc28f5c28f5c3p-1;
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
    const double t23 = FMA(t22, t19, t11) + SELECT(t10, t6, t8 - (t9 - t7));
    return FMA(FMA(t22, SELECT(t10, FMA(t5, t13, t15), t18), t23), t20, t21);
}
#define dynamic_coefficient_best_fused_KIND whole

/* C_theta/Theta* = weight_moment_amplitude(alpha)/moment_of_inertia(alpha), finite at alpha = 0 where both vanish,
 * 0 <= alpha <= pi/2, best, fused: proved within 1.03 ulp (certificates/weight_moment_per_inertia.json) */
INLINE double weight_moment_per_inertia_best_fused(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double alpha_4 = alpha_2 * alpha_2;
    const double p1 = POLY3(alpha_4, 0x1.83c8978e93394p-11, 0x1.eaea9e0178a1ap-20, 0x1.b581dfc3b96a5p-30,
        0x1.198f4c366985bp-41);
    const double p2 = POLY3(alpha_4, -0x1.282ef4b66672dp-7, -0x1.65f59e222b2a7p-15, -0x1.03e4b3b320f82p-24,
        -0x1.28918aeb0ff45p-35);
    const double t1 = FMA(alpha_2, FMA(alpha_2, p1, p2), 0x1.27d27d27d279ep-4);
    const double t2 = FMA(t1, alpha_2, -0x1.5555555555555p-2);
    const double t3 = FMA(t2, alpha_2, 0x1.5555555555555p-1);
    const double t4 = FMA(t2, alpha_2, 0x1.5555555555555p-1 - t3) + 0x1.5555555555555p-55;
    const double t5 = FMA(alpha, alpha, -alpha_2);
    const double t6 = FMA(t5, t2, FMA(alpha_2, FMA(t1, alpha_2, -0x1.5555555555555p-2 - t2), t4));
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double b_4 = b_2 * b_2;
    const double p3 = POLY6(b_2, 0x1.2aaaaaaaaa92dp-1, -0x1.5b05b05af2089p-3, 0x1.bc8bc8b057e9ep-6,
        -0x1.637e0682f56a5p-9, 0x1.83c977d34089bp-13, -0x1.328c51bc2f6bfp-17, 0x1.6115cd6ac8ba9p-22);
    const double t7 = FMA(b, 0.5 - b, FMA(b_4, p3, FMA(b, -0x1.1a62633145c07p-53, -0x1.5555555555556p-54)));
    const double t8 = 0.5 * alpha;
    const double t9 = t8 + -0x1.e652ff776be10p-4;
    const double t10 = t9 + t7;
    const double t11 = alpha < 1.0;
    const double t12 = SELECT(t11, t3, t10);
    const double p4 = POLY3(alpha_4, 0x1.1f7d05c72fc3ap-8, 0x1.1f0877c40acffp-15, 0x1.9465eeb660151p-24,
        0x1.f3cdbf532eaf7p-34);
    const double p5 = POLY4(alpha_4, -0x1.f1029e62cad66p-6, -0x1.d71607bd2727dp-12, -0x1.0e1fd712de8dbp-19,
        -0x1.ed2a462794ae8p-29, -0x1.91e6b7ad796a6p-39);
    const double t13 = FMA(alpha_2, FMA(alpha_2, p4, p5), 0x1.1e11e11e11e36p-3);
    const double t14 = FMA(t13, alpha_2, -0x1.999999999999ap-2);
    const double t15 = FMA(t14, alpha_2, 0x1.5555555555555p-1);
    const double t16 = FMA(t14, alpha_2, 0x1.5555555555555p-1 - t15) + 0x1.5555555555555p-55;
    const double t17 = FMA(t5, t14, FMA(alpha_2, FMA(t13, alpha_2, -0x1.999999999999ap-2 - t14), t16));
    const double p6 = POLY9(b_2, -0x1.555555555554ep-3, -0x1.c71c71c71cad2p-3, 0x1.3e93e93e9959dp-2,
        -0x1.0cbb76630619cp-3, 0x1.e94dfd8b6e6d2p-6, -0x1.1e5e23528aa32p-8, 0x1.d6a371cc475cdp-12,
        -0x1.1f397f95f7403p-15, 0x1.1425220d45aaap-19, -0x1.00589fe65ed98p-23);
    const double t18 = FMA(b, p6, 0x1.dffffffffffffp-4);
    const double t19 = t8 + -0x1.e000000000000p-4;
    const double t20 = t19 + t18;
    const double t21 = SELECT(t11, t15, t20);
    const double t22 = 1.0 / t21;
    const double t23 = t12 * t22;
    const double t24 = -t23;
    const double t25 = FMA(t24, t21, t12) + SELECT(t11, t6, t7 - (t10 - t9));
    return FMA(FMA(t24, SELECT(t11, t17, t18 - (t20 - t19)), t25), t22, t23);
}
#define weight_moment_per_inertia_best_fused_KIND whole

/* C_r/Theta* = radial_weight_amplitude(alpha)/moment_of_inertia(alpha), finite at alpha = 0 where both vanish, 0
 * <= alpha <= pi/2, best, fused: proved within 1.13 ulp (certificates/radial_weight_per_inertia.json) */
INLINE double radial_weight_per_inertia_best_fused(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double alpha_4 = alpha_2 * alpha_2;
    const double p1 = POLY6(alpha_4, -0x1.47d6743d1ab96p-16, -0x1.0156717ae6a98p-18, -0x1.52a8b7fb58b0bp-22,
        -0x1.420eb51f67a97p-24, -0x1.41e50fe69bac0p-24, -0x1.e8d88b74942f1p-26, -0x1.86ec1a4714bc6p-30);
    const double p2 = POLY6(alpha_4, -0x1.664f48816cbcep-10, -0x1.07d7aa081f5bbp-16, -0x1.1d1cbe50df456p-20,
        -0x1.20b66585c3299p-24, 0x1.fdf00b464f2acp-25, 0x1.cd1ef3b3ed5bdp-25, 0x1.315a59a2eff33p-27);
    const double t1 = FMA(alpha_2, FMA(alpha_2, p1, p2), 0x1.2b12b12b1221bp-6);
    const double t2 = FMA(t1, alpha_2, -0x1.9999999999997p-3);
    const double t3 = FMA(t2, alpha_2, 0x1.5555555555555p-1);
    const double t4 = FMA(t2, alpha_2, 0x1.5555555555555p-1 - t3) + 0x1.5555555555555p-55;
    const double t5 = FMA(alpha, alpha, -alpha_2);
    const double t6 = FMA(t5, t2, FMA(alpha_2, FMA(t1, alpha_2, -0x1.9999999999997p-3 - t2), t4));
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p3 = POLY5(b_2, 0x1.00000000000d1p+0, -0x1.555555552b82cp-2, 0x1.6c16c100ecd3dp-5,
        -0x1.a01ba6f54a2d2p-9, 0x1.2705f10ad2bc9p-13, -0x1.49f6ab92b4903p-18);
    const double p4 = POLY5(b_2, -0x1.7217f7d1bdaacp-7, 0x1.2c981ff52d6d6p-1, -0x1.5fec394ef3093p-4,
        0x1.c0f85bb0bd6d8p-8, -0x1.5c240340d7499p-12, 0x1.7fcd25610a7bep-17);
    const double t7 = 1.0 - b;
    const double t8 = FMA(b, FMA(b, -1.875, 1.0), b_2 * FMA(p3, logarithm_fused(2.0 * b), p4));
    const double t9 = t7 + t8;
    const double t10 = alpha < 0x1.07ae147ae147bp+0;
    const double t11 = SELECT(t10, t3, t9);
    const double p5 = POLY4(alpha_4, 0x1.1f7d05c744f00p-8, 0x1.1f0878ebd4d43p-15, 0x1.947001eb768c8p-24,
        0x1.090c1fc3ba5d2p-33, 0x1.01b1332b9b1d7p-41);
    const double p6 = POLY4(alpha_4, -0x1.f1029e62cb3ddp-6, -0x1.d71607c637a7bp-12, -0x1.0e2006e773ecdp-19,
        -0x1.ee8b4e839c601p-29, -0x1.8673117c84002p-38);
    const double t12 = FMA(alpha_2, FMA(alpha_2, p5, p6), 0x1.1e11e11e11e3cp-3);
    const double t13 = FMA(t12, alpha_2, -0x1.999999999999ap-2);
    const double t14 = FMA(t13, alpha_2, 0x1.5555555555555p-1);
    const double t15 = FMA(t13, alpha_2, 0x1.5555555555555p-1 - t14) + 0x1.5555555555555p-55;
    const double t16 = FMA(t5, t13, FMA(alpha_2, FMA(t12, alpha_2, -0x1.999999999999ap-2 - t13), t15));
    const double p7 = POLY9(b_2, -0x1.555555555554ep-3, -0x1.c71c71c71cb31p-3, 0x1.3e93e93e9a95cp-2,
        -0x1.0cbb76636144ep-3, 0x1.e94dfdbeb29efp-6, -0x1.1e5e2b53ee8f7p-8, 0x1.d6a65d5d8efd9p-12,
        -0x1.1f88aff83463bp-15, 0x1.1d2bdb6e180adp-19, -0x1.6de90fa3c36d1p-23);
    const double t17 = FMA(b, p7, 0x1.dffffffffffffp-4);
    const double t18 = 0.5 * alpha + -0x1.e000000000000p-4;
    const double t19 = t18 + t17;
    const double t20 = SELECT(t10, t14, t19);
    const double t21 = 1.0 / t20;
    const double t22 = t11 * t21;
    const double t23 = -t22;
    const double t24 = FMA(t23, t20, t11) + SELECT(t10, t6, t8 - (t9 - t7));
    return FMA(FMA(t23, SELECT(t10, t16, t17 - (t19 - t18)), t24), t21, t22);
}
#define radial_weight_per_inertia_best_fused_KIND whole

/* I_p* /Theta* = polar_moment(alpha)/moment_of_inertia(alpha), finite at alpha = 0 where both vanish, 0 <= alpha
 * <= pi/2, best, fused: proved within 0.885 ulp (certificates/polar_moment_per_inertia.json) */
INLINE double polar_moment_per_inertia_best_fused(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double alpha_4 = alpha_2 * alpha_2;
    const double p1 = POLY5(alpha_4, 0x1.35581e41e77abp-11, 0x1.f95e135afe164p-20, 0x1.09bc1bebcf001p-25,
        0x1.cd171a110ec19p-28, 0x1.bb4feae5283ecp-29, 0x1.26891cd0b9c00p-32);
    const double p2 = POLY5(alpha_4, -0x1.ce55c8eaf4bc9p-8, -0x1.08db55ee7d9b2p-15, 0x1.05db2a1cb81a5p-24,
        0x1.25925bb16d77dp-28, -0x1.10fbc686826eep-28, -0x1.4871de51476c6p-30);
    const double t1 = FMA(alpha_2, FMA(alpha_2, p1, p2), 0x1.d41d41d41d6efp-5);
    const double t2 = FMA(t1, alpha_2, -0x1.1111111111112p-2);
    const double t3 = FMA(t2, alpha_2, 0x1.5555555555555p-1);
    const double t4 = FMA(t2, alpha_2, 0x1.5555555555555p-1 - t3) + 0x1.5555555555555p-55;
    const double t5 = FMA(alpha, alpha, -alpha_2);
    const double t6 = FMA(t5, t2, FMA(alpha_2, FMA(t1, alpha_2, -0x1.1111111111112p-2 - t2), t4));
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p3 = POLY5(b_2, 0x1.555555555434bp-2, -0x1.5555555ce08d5p-3, 0x1.27d270f96a29bp-5,
        -0x1.2837b580b3980p-8, 0x1.807b27aa47e52p-12, -0x1.b34a574a5ccacp-16);
    const double p4 = POLY5(b_2, -0x1.213ce231c73c8p-7, 0x1.94ebfb7c3ce42p-4, -0x1.0ee09496505b1p-5,
        0x1.556dc54d73912p-8, -0x1.0589062751e4cp-11, 0x1.15ac79423b8b0p-15);
    const double t7 = alpha + -0x1.0c152382d7366p-1;
    const double t8 = FMA(b * b_2, FMA(p3, logarithm_fused(b), p4), 0x1.ee6913347c2a6p-55);
    const double t9 = t7 + t8;
    const double t10 = alpha < 1.0;
    const double t11 = SELECT(t10, t3, t9);
    const double p5 = POLY3(alpha_4, 0x1.1f7d05c72fc3ap-8, 0x1.1f0877c40acffp-15, 0x1.9465eeb660151p-24,
        0x1.f3cdbf532eaf7p-34);
    const double p6 = POLY4(alpha_4, -0x1.f1029e62cad66p-6, -0x1.d71607bd2727dp-12, -0x1.0e1fd712de8dbp-19,
        -0x1.ed2a462794ae8p-29, -0x1.91e6b7ad796a6p-39);
    const double t12 = FMA(alpha_2, FMA(alpha_2, p5, p6), 0x1.1e11e11e11e36p-3);
    const double t13 = FMA(t12, alpha_2, -0x1.999999999999ap-2);
    const double t14 = FMA(t13, alpha_2, 0x1.5555555555555p-1);
    const double t15 = FMA(t13, alpha_2, 0x1.5555555555555p-1 - t14) + 0x1.5555555555555p-55;
    const double t16 = FMA(t5, t13, FMA(alpha_2, FMA(t12, alpha_2, -0x1.999999999999ap-2 - t13), t15));
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
    const double t24 = FMA(t23, t20, t11) + SELECT(t10, t6, t8 - (t9 - t7));
    return FMA(FMA(t23, SELECT(t10, t16, t17 - (t19 - t18)), t24), t21, t22);
}
#define polar_moment_per_inertia_best_fused_KIND whole

/* C_theta/C_r = weight_moment_amplitude(alpha)/radial_weight_amplitude(alpha), finite at alpha = 0 where both
 * vanish, 0 <= alpha <= pi/2, best, fused: proved within 1.15 ulp
 * (certificates/weight_moment_per_radial_weight.json) */
INLINE double weight_moment_per_radial_weight_best_fused(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double alpha_4 = alpha_2 * alpha_2;
    const double p1 = POLY3(alpha_4, 0x1.83c8978ea9dfdp-11, 0x1.eaeaa0548de6dp-20, 0x1.b5904f6877c6fp-30,
        0x1.26910ad30ced0p-41);
    const double p2 = POLY3(alpha_4, -0x1.282ef4b666991p-7, -0x1.65f59e28f78f5p-15, -0x1.03e4f0243a4f9p-24,
        -0x1.29811c85a203bp-35);
    const double t1 = FMA(alpha_2, FMA(alpha_2, p1, p2), 0x1.27d27d27d27a1p-4);
    const double t2 = FMA(t1, alpha_2, -0x1.5555555555555p-2);
    const double t3 = FMA(t2, alpha_2, 0x1.5555555555555p-1);
    const double t4 = FMA(t2, alpha_2, 0x1.5555555555555p-1 - t3) + 0x1.5555555555555p-55;
    const double t5 = FMA(alpha, alpha, -alpha_2);
    const double t6 = FMA(t5, t2, FMA(alpha_2, FMA(t1, alpha_2, -0x1.5555555555555p-2 - t2), t4));
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double b_4 = b_2 * b_2;
    const double p3 = POLY6(b_2, 0x1.2aaaaaaaaaa01p-1, -0x1.5b05b05afba3bp-3, 0x1.bc8bc8b5880b7p-6,
        -0x1.637e07e2724a8p-9, 0x1.83c9d9bc51dc4p-13, -0x1.329a1a829399ap-17, 0x1.62a1cdff01de7p-22);
    const double t7 = FMA(b, 0.5 - b, FMA(b_4, p3, FMA(b, -0x1.1a62633145c07p-53, -0x1.5555555555556p-54)));
    const double t8 = 0.5 * alpha + -0x1.e652ff776be10p-4;
    const double t9 = t8 + t7;
    const double t10 = alpha < 0x1.07ae147ae147bp+0;
    const double t11 = SELECT(t10, t3, t9);
    const double p4 = POLY6(alpha_4, -0x1.47d6743d1ab96p-16, -0x1.0156717ae6a98p-18, -0x1.52a8b7fb58b0bp-22,
        -0x1.420eb51f67a97p-24, -0x1.41e50fe69bac0p-24, -0x1.e8d88b74942f1p-26, -0x1.86ec1a4714bc6p-30);
    const double p5 = POLY6(alpha_4, -0x1.664f48816cbcep-10, -0x1.07d7aa081f5bbp-16, -0x1.1d1cbe50df456p-20,
        -0x1.20b66585c3299p-24, 0x1.fdf00b464f2acp-25, 0x1.cd1ef3b3ed5bdp-25, 0x1.315a59a2eff33p-27);
    const double t12 = FMA(alpha_2, FMA(alpha_2, p4, p5), 0x1.2b12b12b1221bp-6);
    const double t13 = FMA(t12, alpha_2, -0x1.9999999999997p-3);
    const double t14 = FMA(t13, alpha_2, 0x1.5555555555555p-1);
    const double t15 = FMA(t13, alpha_2, 0x1.5555555555555p-1 - t14) + 0x1.5555555555555p-55;
    const double t16 = FMA(t5, t13, FMA(alpha_2, FMA(t12, alpha_2, -0x1.9999999999997p-3 - t13), t15));
    const double p6 = POLY5(b_2, 0x1.00000000000d1p+0, -0x1.555555552b82cp-2, 0x1.6c16c100ecd3dp-5,
        -0x1.a01ba6f54a2d2p-9, 0x1.2705f10ad2bc9p-13, -0x1.49f6ab92b4903p-18);
    const double p7 = POLY5(b_2, -0x1.7217f7d1bdaacp-7, 0x1.2c981ff52d6d6p-1, -0x1.5fec394ef3093p-4,
        0x1.c0f85bb0bd6d8p-8, -0x1.5c240340d7499p-12, 0x1.7fcd25610a7bep-17);
    const double t17 = 1.0 - b;
    const double t18 = FMA(b, FMA(b, -1.875, 1.0), b_2 * FMA(p6, logarithm_fused(2.0 * b), p7));
    const double t19 = t17 + t18;
    const double t20 = SELECT(t10, t14, t19);
    const double t21 = 1.0 / t20;
    const double t22 = t11 * t21;
    const double t23 = -t22;
    const double t24 = FMA(t23, t20, t11) + SELECT(t10, t6, t7 - (t9 - t8));
    return FMA(FMA(t23, SELECT(t10, t16, t18 - (t19 - t17)), t24), t21, t22);
}
#define weight_moment_per_radial_weight_best_fused_KIND whole

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

/* C_r = sin(alpha) - cos(alpha)**2*atanh(sin(alpha)), 0 <= alpha <= pi/2, 1e-6, fused: proved within 3.41e-07
 * relative (certificates/radial_weight_amplitude.json) */
INLINE double radial_weight_amplitude_1e_6_fused(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double t1 = 0x1.3bd3cc9be45dep+1 - alpha_2;
    const double p1 = POLY4(t1, 0x1.083464838a5a9p-2, 0x1.072fc483044bbp+3, 0x1.24ceea0f4ee36p+5,
        0x1.16253f17550d1p+5, 0x1.cc8a8141fa745p+2);
    const double p2 = POLY5(t1, 1.0, 0x1.f44f9842d233ap+4, 0x1.ed09359bb409ap+6, 0x1.0589e6f9d3ef3p+6,
        -0x1.f40a4101ee07ep+2, 0x1.32c3a7d534520p-2);
    return p1 * alpha_2 / p2 * alpha;
}
#define radial_weight_amplitude_1e_6_fused_KIND short

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
 * proved within 3.72 ulp (certificates/polar_moment.json) */
/* alpha < 0.93 */
INLINE double polar_moment_best_plain_near(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY11(alpha_2, -0x1.99999999999aap-2, 0x1.5f15f15f1726fp-4, -0x1.5ac056b1147acp-7,
        0x1.d0042e1391951p-11, -0x1.8d4952ec3d425p-15, 0x1.7b1e61f702731p-19, 0x1.7fd478253df46p-24,
        0x1.b149c360dbe22p-25, 0x1.d2dbb0cb27f33p-30, 0x1.ab724f22aa27ep-27, -0x1.3aec2023926f3p-28,
        0x1.03ba64fc6390ep-29);
    return (alpha_2 * (p1 * alpha_2) + alpha_2) / 1.5 * alpha;
}
/* alpha >= 0.93, in b = pi/2 - alpha */
INLINE double polar_moment_best_plain_far(double alpha)
{
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p1 = POLY5(b_2, 0x1.55555555579d1p-2, -0x1.555555518e7c3p-3, 0x1.27d279e0496b5p-5,
        -0x1.2834e1f3e1a60p-8, 0x1.80dce9acbd0ffp-12, -0x1.b16de590ed744p-16);
    const double p2 = POLY5(b_2, -0x1.213ce230290f3p-7, 0x1.94ebfbb2ec66fp-4, -0x1.0ee086df8c2f9p-5,
        0x1.556ffb39c3af9p-8, -0x1.058aebdba383ap-11, 0x1.1477caa143cfbp-15);
    const double t1 = b * b_2 * (p1 * logarithm_plain(b) + p2) + 0x1.ee6913347c2a6p-55;
    return alpha + -0x1.0c152382d7366p-1 + t1;
}
INLINE double polar_moment_best_plain(double alpha)
{
    const double near = polar_moment_best_plain_near(alpha);
    const double far = polar_moment_best_plain_far(alpha);
    return SELECT(alpha < 0x1.dc28f5c28f5c3p-1, near, far);
}
#define polar_moment_best_plain_KIND pieces
#define polar_moment_best_plain_BELOW_double UINT64_C(0x3fedc28f5c28f5c2)
#define polar_moment_best_plain_BELOW_float UINT32_C(0x3f6e147a)

/* Theta* = alpha/2 - sin(2*alpha)/6 - sin(4*alpha)/24, 0 <= alpha <= pi/2, best, plain: proved within 3.9 ulp
 * (certificates/moment_of_inertia.json) */
/* alpha < 1.0 */
INLINE double moment_of_inertia_best_plain_near(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY10(alpha_2, -0x1.3333333333333p-1, 0x1.ad1ad1ad1acf4p-3, -0x1.74c1f6ca16a80p-5,
        0x1.af3b88aa68aebp-8, -0x1.615085c00e86dp-11, 0x1.ae8cb1283bb0dp-15, -0x1.952f78d94e8b4p-19,
        0x1.2f46f95e97102p-23, -0x1.715e85182e3c6p-28, 0x1.701f99390685dp-33, -0x1.06aa0de1b2785p-38);
    return (alpha_2 * (p1 * alpha_2) + alpha_2) / 1.5 * alpha;
}
/* alpha >= 1.0, in b = pi/2 - alpha */
INLINE double moment_of_inertia_best_plain_far(double alpha)
{
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p1 = POLY9(b_2, -0x1.555555555554ep-3, -0x1.c71c71c71cad2p-3, 0x1.3e93e93e9959dp-2,
        -0x1.0cbb76630619cp-3, 0x1.e94dfd8b6e6d2p-6, -0x1.1e5e23528aa32p-8, 0x1.d6a371cc475cdp-12,
        -0x1.1f397f95f7403p-15, 0x1.1425220d45aaap-19, -0x1.00589fe65ed98p-23);
    return 0.5 * alpha + -0x1.e000000000000p-4 + (b * p1 + 0x1.dffffffffffffp-4);
}
INLINE double moment_of_inertia_best_plain(double alpha)
{
    const double near = moment_of_inertia_best_plain_near(alpha);
    const double far = moment_of_inertia_best_plain_far(alpha);
    return SELECT(alpha < 1.0, near, far);
}
#define moment_of_inertia_best_plain_KIND pieces
#define moment_of_inertia_best_plain_BELOW_double UINT64_C(0x3fefffffffffffff)
#define moment_of_inertia_best_plain_BELOW_float UINT32_C(0x3f7fffff)

/* C_r = sin(alpha) - cos(alpha)**2*atanh(sin(alpha)), 0 <= alpha <= pi/2, best, plain: proved within 3.93 ulp
 * (certificates/radial_weight_amplitude.json) */
/* alpha < 1.02 */
INLINE double radial_weight_amplitude_best_plain_near(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY14(alpha_2, -0x1.333333333333fp-2, 0x1.c09c09c0a0697p-6, -0x1.0cbb766699a91p-9,
        -0x1.ebc17ea4438d8p-16, -0x1.8bc56a975512cp-16, -0x1.81ce091eaad43p-18, -0x1.af675dca502fcp-20,
        -0x1.cab1aff185f12p-22, -0x1.c4fd9a7c6da80p-23, 0x1.5d27070391f4dp-24, -0x1.59a98a325cbd4p-23,
        0x1.045647ffefdb9p-23, -0x1.3b05aafac3a90p-24, 0x1.ad9efb842aa75p-26, -0x1.3687c8bf5bfd6p-28);
    return (alpha_2 * (p1 * alpha_2) + alpha_2) / 1.5 * alpha;
}
/* alpha >= 1.02, in b = pi/2 - alpha */
INLINE double radial_weight_amplitude_best_plain_far(double alpha)
{
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p1 = POLY5(b_2, 0x1.00000000000b6p+0, -0x1.555555554900ap-2, 0x1.6c16c0a0e6534p-5,
        -0x1.a01c15d7033acp-9, 0x1.26ecb6ae67667p-13, -0x1.4b80ca7eaf925p-18);
    const double p2 = POLY5(b_2, -0x1.7217f7d1c0c33p-7, 0x1.2c981ff50df71p-1, -0x1.5fec3987413d3p-4,
        0x1.c0f84768fd081p-8, -0x1.5c1de3bda9c32p-12, 0x1.8128754f493fdp-17);
    return 1.0 - b + (b * (b * -1.875 + 1.0) + b_2 * (p1 * logarithm_plain(2.0 * b) + p2));
}
INLINE double radial_weight_amplitude_best_plain(double alpha)
{
    const double near = radial_weight_amplitude_best_plain_near(alpha);
    const double far = radial_weight_amplitude_best_plain_far(alpha);
    return SELECT(alpha < 0x1.051eb851eb852p+0, near, far);
}
#define radial_weight_amplitude_best_plain_KIND pieces
#define radial_weight_amplitude_best_plain_BELOW_double UINT64_C(0x3ff051eb851eb851)
#define radial_weight_amplitude_best_plain_BELOW_float UINT32_C(0x3f828f5c)

/* C_theta = 2*sin(alpha)**3/3, 0 <= alpha <= pi/2, best, plain: proved within 4.92 ulp
 * (certificates/weight_moment_amplitude.json) */
/* alpha < 1.14 */
INLINE double weight_moment_amplitude_best_plain_near(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY9(alpha_2, -0.5, 0x1.bbbbbbbbbbbacp-4, -0x1.bc466f119b2adp-7, 0x1.22d671ab3a415p-10,
        -0x1.0c7836ab3f49dp-14, 0x1.702ffb8c1bae1p-19, -0x1.85d7f38d0863bp-24, 0x1.483a398c06abcp-29,
        -0x1.bfd1bed6f6a7dp-35, 0x1.cce3e7c2893efp-41);
    return (alpha_2 * (p1 * alpha_2) + alpha_2) / 1.5 * alpha;
}
/* alpha >= 1.14, in b = pi/2 - alpha */
INLINE double weight_moment_amplitude_best_plain_far(double alpha)
{
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p1 = POLY7(b_2, -0x1.fffffffffff33p-1, 0x1.2aaaaaaaa4de1p-1, -0x1.5b05b05725bf8p-3,
        0x1.bc8bc63347c1bp-6, -0x1.637d23719afdep-9, 0x1.836fb52a981c1p-13, -0x1.200f7807f7c5cp-17,
        -0x1.b75240e8c1b90p-22);
    return 0x1.5555555555555p-1 + b_2 * p1;
}
INLINE double weight_moment_amplitude_best_plain(double alpha)
{
    const double near = weight_moment_amplitude_best_plain_near(alpha);
    const double far = weight_moment_amplitude_best_plain_far(alpha);
    return SELECT(alpha < 0x1.23d70a3d70a3dp+0, near, far);
}
#define weight_moment_amplitude_best_plain_KIND pieces
#define weight_moment_amplitude_best_plain_BELOW_double UINT64_C(0x3ff23d70a3d70a3c)
#define weight_moment_amplitude_best_plain_BELOW_float UINT32_C(0x3f91eb85)

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

/* A = polar_moment(alpha)/resistance_factor(alpha), finite at alpha = 0 where both vanish, 0 <= alpha <= pi/2,
 * best, plain: proved within 4.62 ulp (certificates/dynamic_coefficient.json) */
INLINE double dynamic_coefficient_best_plain(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY11(alpha_2, -0x1.99999999999aap-2, 0x1.5f15f15f1726fp-4, -0x1.5ac056b1147acp-7,
        0x1.d0042e1391951p-11, -0x1.8d4952ec3d425p-15, 0x1.7b1e61f702731p-19, 0x1.7fd478253df46p-24,
        0x1.b149c360dbe22p-25, 0x1.d2dbb0cb27f33p-30, 0x1.ab724f22aa27ep-27, -0x1.3aec2023926f3p-28,
        0x1.03ba64fc6390ep-29);
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p2 = POLY5(b_2, 0x1.55555555579d1p-2, -0x1.555555518e7c3p-3, 0x1.27d279e0496b5p-5,
        -0x1.2834e1f3e1a60p-8, 0x1.80dce9acbd0ffp-12, -0x1.b16de590ed744p-16);
    const double p3 = POLY5(b_2, -0x1.213ce230290f3p-7, 0x1.94ebfbb2ec66fp-4, -0x1.0ee086df8c2f9p-5,
        0x1.556ffb39c3af9p-8, -0x1.058aebdba383ap-11, 0x1.1477caa143cfbp-15);
    const double t1 = b * b_2 * (p2 * logarithm_plain(b) + p3) + 0x1.ee6913347c2a6p-55;
    const double t2 = alpha < 0x1.dc28f5c28f5c3p-1;
    const double t3 = SELECT(t2, 1.0 + p1 * alpha_2, alpha + -0x1.0c152382d7366p-1 + t1);
    const double p4 = POLY7(alpha_2, -0x1.5555555555555p-4, 0x1.6c16c16c16ba2p-9, -0x1.a01a01a0132c2p-15,
        0x1.27e4fb7471f25p-21, -0x1.1eed8d7449e95p-28, 0x1.93966653151c3p-36, -0x1.ae33aea2b0d55p-44,
        0x1.5aeb95ee17e27p-52);
    const double t4 = p4 * alpha_2;
    return SELECT(t2, t3 / 1.5, t3) / SELECT(t2, 1.0 + t4, (alpha_2 * t4 + alpha_2) * alpha);
}
#define dynamic_coefficient_best_plain_KIND whole

/* C_theta/Theta* = weight_moment_amplitude(alpha)/moment_of_inertia(alpha), finite at alpha = 0 where both vanish,
 * 0 <= alpha <= pi/2, best, plain: proved within 3.6 ulp (certificates/weight_moment_per_inertia.json) */
INLINE double weight_moment_per_inertia_best_plain(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY9(alpha_2, -0.5, 0x1.bbbbbbbbbbbbap-4, -0x1.bc466f119baebp-7, 0x1.22d671ab58528p-10,
        -0x1.0c7836b2641bdp-14, 0x1.702ffd855872fp-19, -0x1.85d847d52bd84p-24, 0x1.48429a5c8ff5ep-29,
        -0x1.c0bbf1cdc35f2p-35, 0x1.d7b62978183c7p-41);
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p2 = POLY7(b_2, -0x1.fffffffffff8cp-1, 0x1.2aaaaaaaa8b64p-1, -0x1.5b05b05a3eddfp-3,
        0x1.bc8bc86e383e0p-6, -0x1.637df93a2b515p-9, 0x1.83c680f9980fdp-13, -0x1.3233f64cde615p-17,
        0x1.58b634f524f45p-22);
    const double t1 = alpha < 1.0;
    const double p3 = POLY10(alpha_2, -0x1.3333333333333p-1, 0x1.ad1ad1ad1acf4p-3, -0x1.74c1f6ca16a80p-5,
        0x1.af3b88aa68aebp-8, -0x1.615085c00e86dp-11, 0x1.ae8cb1283bb0dp-15, -0x1.952f78d94e8b4p-19,
        0x1.2f46f95e97102p-23, -0x1.715e85182e3c6p-28, 0x1.701f99390685dp-33, -0x1.06aa0de1b2785p-38);
    const double p4 = POLY9(b_2, -0x1.555555555554ep-3, -0x1.c71c71c71cad2p-3, 0x1.3e93e93e9959dp-2,
        -0x1.0cbb76630619cp-3, 0x1.e94dfd8b6e6d2p-6, -0x1.1e5e23528aa32p-8, 0x1.d6a371cc475cdp-12,
        -0x1.1f397f95f7403p-15, 0x1.1425220d45aaap-19, -0x1.00589fe65ed98p-23);
    const double t2 = 0.5 * alpha + -0x1.e000000000000p-4 + (b * p4 + 0x1.dffffffffffffp-4);
    const double t3 = SELECT(t1, 1.0 + p1 * alpha_2, 0x1.5555555555555p-1 + b_2 * p2);
    return t3 / SELECT(t1, 1.0 + p3 * alpha_2, t2);
}
#define weight_moment_per_inertia_best_plain_KIND whole

/* C_r/Theta* = radial_weight_amplitude(alpha)/moment_of_inertia(alpha), finite at alpha = 0 where both vanish, 0
 * <= alpha <= pi/2, best, plain: proved within 3.16 ulp (certificates/radial_weight_per_inertia.json) */
INLINE double radial_weight_per_inertia_best_plain(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY15(alpha_2, -0x1.3333333333331p-2, 0x1.c09c09c09b21ap-6, -0x1.0cbb7661039a4p-9,
        -0x1.ebc1aebec88f9p-16, -0x1.8bc37ba4a9e9cp-16, -0x1.8201fa45d5e98p-18, -0x1.aba5f589eb2edp-20,
        -0x1.fc3a7b71ed83bp-22, -0x1.aef8388bf9a7dp-24, -0x1.e67c4929e3d9ap-24, 0x1.8284b98d3ef10p-24,
        -0x1.e6629131fe7cep-24, 0x1.5c0717fe10388p-24, -0x1.707239a982081p-25, 0x1.cbd5f63622b49p-27,
        -0x1.2602c2b4216f8p-29);
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p2 = POLY5(b_2, 0x1.00000000000d1p+0, -0x1.555555552b82cp-2, 0x1.6c16c100ecd3dp-5,
        -0x1.a01ba6f54a2d2p-9, 0x1.2705f10ad2bc9p-13, -0x1.49f6ab92b4903p-18);
    const double p3 = POLY5(b_2, -0x1.7217f7d1bdaacp-7, 0x1.2c981ff52d6d6p-1, -0x1.5fec394ef3093p-4,
        0x1.c0f85bb0bd6d8p-8, -0x1.5c240340d7499p-12, 0x1.7fcd25610a7bep-17);
    const double t1 = 1.0 - b + (b * (b * -1.875 + 1.0) + b_2 * (p2 * logarithm_plain(2.0 * b) + p3));
    const double t2 = alpha < 0x1.07ae147ae147bp+0;
    const double p4 = POLY11(alpha_2, -0x1.3333333333333p-1, 0x1.ad1ad1ad1acf1p-3, -0x1.74c1f6ca168cfp-5,
        0x1.af3b88aa5d36ep-8, -0x1.615085bd8844bp-11, 0x1.ae8cb07f844bap-15, -0x1.952f5cfde36d4p-19,
        0x1.2f43fc0f3b961p-23, -0x1.70f3f2a6450f9p-28, 0x1.66d4d675032fdp-33, -0x1.21425b193f4e3p-39,
        -0x1.45b05b2cc572fp-42);
    const double p5 = POLY9(b_2, -0x1.555555555554ep-3, -0x1.c71c71c71cb31p-3, 0x1.3e93e93e9a95cp-2,
        -0x1.0cbb76636144ep-3, 0x1.e94dfdbeb29efp-6, -0x1.1e5e2b53ee8f7p-8, 0x1.d6a65d5d8efd9p-12,
        -0x1.1f88aff83463bp-15, 0x1.1d2bdb6e180adp-19, -0x1.6de90fa3c36d1p-23);
    const double t3 = 0.5 * alpha + -0x1.e000000000000p-4 + (b * p5 + 0x1.dffffffffffffp-4);
    return SELECT(t2, 1.0 + p1 * alpha_2, t1) / SELECT(t2, 1.0 + p4 * alpha_2, t3);
}
#define radial_weight_per_inertia_best_plain_KIND whole

/* I_p* /Theta* = polar_moment(alpha)/moment_of_inertia(alpha), finite at alpha = 0 where both vanish, 0 <= alpha
 * <= pi/2, best, plain: proved within 3.01 ulp (certificates/polar_moment_per_inertia.json) */
INLINE double polar_moment_per_inertia_best_plain(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY13(alpha_2, -0x1.999999999999bp-2, 0x1.5f15f15f16133p-4, -0x1.5ac056b03787fp-7,
        0x1.d0042d62d5390p-11, -0x1.8d4900e22cd37p-15, 0x1.7b068d35efb42p-19, 0x1.88c9611a62aaap-24,
        0x1.8e96ce5791a84p-25, 0x1.b88d2a10b198ep-28, 0x1.59b16de1aa5bbp-27, -0x1.9941b41d0cf69p-28,
        0x1.4c5bfe80b82dfp-28, -0x1.ec80049fb3d54p-30, 0x1.b9b42a5028f70p-32);
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p2 = POLY5(b_2, 0x1.555555555434bp-2, -0x1.5555555ce08d5p-3, 0x1.27d270f96a29bp-5,
        -0x1.2837b580b3980p-8, 0x1.807b27aa47e52p-12, -0x1.b34a574a5ccacp-16);
    const double p3 = POLY5(b_2, -0x1.213ce231c73c8p-7, 0x1.94ebfb7c3ce42p-4, -0x1.0ee09496505b1p-5,
        0x1.556dc54d73912p-8, -0x1.0589062751e4cp-11, 0x1.15ac79423b8b0p-15);
    const double t1 = b * b_2 * (p2 * logarithm_plain(b) + p3) + 0x1.ee6913347c2a6p-55;
    const double t2 = alpha < 1.0;
    const double p4 = POLY10(alpha_2, -0x1.3333333333333p-1, 0x1.ad1ad1ad1acf4p-3, -0x1.74c1f6ca16a80p-5,
        0x1.af3b88aa68aebp-8, -0x1.615085c00e86dp-11, 0x1.ae8cb1283bb0dp-15, -0x1.952f78d94e8b4p-19,
        0x1.2f46f95e97102p-23, -0x1.715e85182e3c6p-28, 0x1.701f99390685dp-33, -0x1.06aa0de1b2785p-38);
    const double p5 = POLY9(b_2, -0x1.555555555554ep-3, -0x1.c71c71c71cad2p-3, 0x1.3e93e93e9959dp-2,
        -0x1.0cbb76630619cp-3, 0x1.e94dfd8b6e6d2p-6, -0x1.1e5e23528aa32p-8, 0x1.d6a371cc475cdp-12,
        -0x1.1f397f95f7403p-15, 0x1.1425220d45aaap-19, -0x1.00589fe65ed98p-23);
    const double t3 = 0.5 * alpha + -0x1.e000000000000p-4 + (b * p5 + 0x1.dffffffffffffp-4);
    const double t4 = SELECT(t2, 1.0 + p1 * alpha_2, alpha + -0x1.0c152382d7366p-1 + t1);
    return t4 / SELECT(t2, 1.0 + p4 * alpha_2, t3);
}
#define polar_moment_per_inertia_best_plain_KIND whole

/* C_theta/C_r = weight_moment_amplitude(alpha)/radial_weight_amplitude(alpha), finite at alpha = 0 where both
 * vanish, 0 <= alpha <= pi/2, best, plain: proved within 4.99 ulp
 * (certificates/weight_moment_per_radial_weight.json) */
INLINE double weight_moment_per_radial_weight_best_plain(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY9(alpha_2, -0.5, 0x1.bbbbbbbbbbbb9p-4, -0x1.bc466f119ba3ep-7, 0x1.22d671ab5580dp-10,
        -0x1.0c7836b1a0daep-14, 0x1.702ffd482ffbdp-19, -0x1.85d83c514d29ap-24, 0x1.48415120bdd7dp-29,
        -0x1.c093be0569f32p-35, 0x1.d5a4e25649554p-41);
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p2 = POLY7(b_2, -0x1.fffffffffff81p-1, 0x1.2aaaaaaaa858fp-1, -0x1.5b05b05a0692cp-3,
        0x1.bc8bc8508d3eap-6, -0x1.637df140a6f7bp-9, 0x1.83c438231323ep-13, -0x1.31defbecf388fp-17,
        0x1.4edde2a2fe592p-22);
    const double t1 = alpha < 0x1.07ae147ae147bp+0;
    const double p3 = POLY15(alpha_2, -0x1.3333333333331p-2, 0x1.c09c09c09b21ap-6, -0x1.0cbb7661039a4p-9,
        -0x1.ebc1aebec88f9p-16, -0x1.8bc37ba4a9e9cp-16, -0x1.8201fa45d5e98p-18, -0x1.aba5f589eb2edp-20,
        -0x1.fc3a7b71ed83bp-22, -0x1.aef8388bf9a7dp-24, -0x1.e67c4929e3d9ap-24, 0x1.8284b98d3ef10p-24,
        -0x1.e6629131fe7cep-24, 0x1.5c0717fe10388p-24, -0x1.707239a982081p-25, 0x1.cbd5f63622b49p-27,
        -0x1.2602c2b4216f8p-29);
    const double p4 = POLY5(b_2, 0x1.00000000000d1p+0, -0x1.555555552b82cp-2, 0x1.6c16c100ecd3dp-5,
        -0x1.a01ba6f54a2d2p-9, 0x1.2705f10ad2bc9p-13, -0x1.49f6ab92b4903p-18);
    const double p5 = POLY5(b_2, -0x1.7217f7d1bdaacp-7, 0x1.2c981ff52d6d6p-1, -0x1.5fec394ef3093p-4,
        0x1.c0f85bb0bd6d8p-8, -0x1.5c240340d7499p-12, 0x1.7fcd25610a7bep-17);
    const double t2 = 1.0 - b + (b * (b * -1.875 + 1.0) + b_2 * (p4 * logarithm_plain(2.0 * b) + p5));
    const double t3 = SELECT(t1, 1.0 + p1 * alpha_2, 0x1.5555555555555p-1 + b_2 * p2);
    return t3 / SELECT(t1, 1.0 + p3 * alpha_2, t2);
}
#define weight_moment_per_radial_weight_best_plain_KIND whole

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

/* C_r = sin(alpha) - cos(alpha)**2*atanh(sin(alpha)), 0 <= alpha <= pi/2, 1e-6, plain: proved within 3.41e-07
 * relative (certificates/radial_weight_amplitude.json) */
INLINE double radial_weight_amplitude_1e_6_plain(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double t1 = 0x1.3bd3cc9be45dep+1 - alpha_2;
    const double p1 = POLY4(t1, 0x1.083464838a5a9p-2, 0x1.072fc483044bbp+3, 0x1.24ceea0f4ee36p+5,
        0x1.16253f17550d1p+5, 0x1.cc8a8141fa745p+2);
    const double p2 = POLY5(t1, 1.0, 0x1.f44f9842d233ap+4, 0x1.ed09359bb409ap+6, 0x1.0589e6f9d3ef3p+6,
        -0x1.f40a4101ee07ep+2, 0x1.32c3a7d534520p-2);
    return p1 * alpha_2 / p2 * alpha;
}
#define radial_weight_amplitude_1e_6_plain_KIND whole

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
    LOOP(double, moment_of_inertia_best, FORM, LEVEL) \
    LOOP(double, radial_weight_amplitude_best, FORM, LEVEL) \
    LOOP(double, weight_moment_amplitude_best, FORM, LEVEL) \
    LOOP(double, resistance_factor_best, FORM, LEVEL) \
    LOOP(double, dynamic_coefficient_best, FORM, LEVEL) \
    LOOP(double, weight_moment_per_inertia_best, FORM, LEVEL) \
    LOOP(double, radial_weight_per_inertia_best, FORM, LEVEL) \
    LOOP(double, polar_moment_per_inertia_best, FORM, LEVEL) \
    LOOP(double, weight_moment_per_radial_weight_best, FORM, LEVEL) \
    LOOP(double, polar_moment_1e_10, FORM, LEVEL) \
    LOOP(double, moment_of_inertia_1e_10, FORM, LEVEL) \
    LOOP(double, radial_weight_amplitude_1e_10, FORM, LEVEL) \
    LOOP(double, weight_moment_amplitude_1e_10, FORM, LEVEL) \
    LOOP(double, resistance_factor_1e_10, FORM, LEVEL) \
    LOOP(double, polar_moment_1e_6, FORM, LEVEL) \
    LOOP(double, moment_of_inertia_1e_6, FORM, LEVEL) \
    LOOP(double, radial_weight_amplitude_1e_6, FORM, LEVEL) \
    LOOP(double, weight_moment_amplitude_1e_6, FORM, LEVEL) \
    LOOP(double, resistance_factor_1e_6, FORM, LEVEL) \
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
    {"moment_of_inertia", "best", {(void *)moment_of_inertia_float32_##LEVEL##_float, (void *)moment_of_inertia_best_##LEVEL##_double}}, \
    {"radial_weight_amplitude", "best", {(void *)radial_weight_amplitude_float32_##LEVEL##_float, (void *)radial_weight_amplitude_best_##LEVEL##_double}}, \
    {"weight_moment_amplitude", "best", {(void *)weight_moment_amplitude_float32_##LEVEL##_float, (void *)weight_moment_amplitude_best_##LEVEL##_double}}, \
    {"resistance_factor", "best", {(void *)resistance_factor_float32_##LEVEL##_float, (void *)resistance_factor_best_##LEVEL##_double}}, \
    {"dynamic_coefficient", "best", {(void *)dynamic_coefficient_best_##LEVEL##_float, (void *)dynamic_coefficient_best_##LEVEL##_double}}, \
    {"weight_moment_per_inertia", "best", {(void *)weight_moment_per_inertia_best_##LEVEL##_float, (void *)weight_moment_per_inertia_best_##LEVEL##_double}}, \
    {"radial_weight_per_inertia", "best", {(void *)radial_weight_per_inertia_best_##LEVEL##_float, (void *)radial_weight_per_inertia_best_##LEVEL##_double}}, \
    {"polar_moment_per_inertia", "best", {(void *)polar_moment_per_inertia_best_##LEVEL##_float, (void *)polar_moment_per_inertia_best_##LEVEL##_double}}, \
    {"weight_moment_per_radial_weight", "best", {(void *)weight_moment_per_radial_weight_best_##LEVEL##_float, (void *)weight_moment_per_radial_weight_best_##LEVEL##_double}}, \
    {"polar_moment", "1e-10", {NULL, (void *)polar_moment_1e_10_##LEVEL##_double}}, \
    {"moment_of_inertia", "1e-10", {NULL, (void *)moment_of_inertia_1e_10_##LEVEL##_double}}, \
    {"radial_weight_amplitude", "1e-10", {NULL, (void *)radial_weight_amplitude_1e_10_##LEVEL##_double}}, \
    {"weight_moment_amplitude", "1e-10", {NULL, (void *)weight_moment_amplitude_1e_10_##LEVEL##_double}}, \
    {"resistance_factor", "1e-10", {NULL, (void *)resistance_factor_1e_10_##LEVEL##_double}}, \
    {"polar_moment", "1e-6", {NULL, (void *)polar_moment_1e_6_##LEVEL##_double}}, \
    {"moment_of_inertia", "1e-6", {NULL, (void *)moment_of_inertia_1e_6_##LEVEL##_double}}, \
    {"radial_weight_amplitude", "1e-6", {NULL, (void *)radial_weight_amplitude_1e_6_##LEVEL##_double}}, \
    {"weight_moment_amplitude", "1e-6", {NULL, (void *)weight_moment_amplitude_1e_6_##LEVEL##_double}}, \
    {"resistance_factor", "1e-6", {NULL, (void *)resistance_factor_1e_6_##LEVEL##_double}}, \
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
