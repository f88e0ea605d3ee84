/* Written by `python -m derive` with SymPy 1.14.0; do not edit. */
#define DIGEST "a74cb39bf07c99a0b7b41b393cf5ac2b64e87ed250f3bb19e0cf2c804e35b3db"
/* Ufunc loops of the certified kernels.
 *
 * Every program stands here once, as an inline function of one alpha. Loops around it are compiled for several
 * processors, and the module offers those that can run here, the widest first. What a fused program asks for is one
 * rounding (fma); a plain program has none of that, so that no processor needs a library call. Nothing may be
 * reordered, contracted or flushed: the proofs are about these operations in this order. */
#define PY_SSIZE_T_CLEAN
#define NPY_NO_DEPRECATED_API NPY_2_0_API_VERSION
#include <Python.h>
#include <structmember.h>
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
#if defined(__clang__)
#define TARGET_avx512 __attribute__((target("avx512f,avx512dq,avx512vl,avx2,fma"), min_vector_width(512)))
#else
#define TARGET_avx512 __attribute__((target("avx512f,avx512dq,avx512vl,avx2,fma,prefer-vector-width=512")))
#endif
#define TARGET_avx2 __attribute__((target("avx2,fma")))
/* What the processor has, of what the system keeps the registers. The compilers' own answer is not used: that of Zig's
 * library is no to everything. */
#include <cpuid.h>
enum { HAS_AVX2 = 1, HAS_AVX512 = 2 };
static int asked_processor(void)
{
    const unsigned wide = bit_AVX512F | bit_AVX512DQ | bit_AVX512VL;
    unsigned a, b, c, d, kept, high;
    if (!__get_cpuid(1, &a, &b, &c, &d) || !(c & bit_OSXSAVE) || !(c & bit_FMA)) return 0;
    __asm__("xgetbv" : "=a"(kept), "=d"(high) : "c"(0));
    if ((kept & 0x06) != 0x06 || !__get_cpuid_count(7, 0, &a, &b, &c, &d) || !(b & bit_AVX2)) return 0;
    return HAS_AVX2 | ((kept & 0xe0) == 0xe0 && (b & wide) == wide ? HAS_AVX512 : 0);
}
/* Asked once: under a hypervisor each question takes microseconds. */
static int processor(void)
{
    static int answer = -1;
    if (answer < 0) answer = asked_processor();
    return answer;
}
#define RUNS_avx512 (processor() & HAS_AVX512)
#define RUNS_avx2 (processor() & HAS_AVX2)
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
#define LIMIT 65536.0 /* of an end of an arc, rad */
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
/* The integer nearest to an x below 2**51, of a tie the even one. */
#define NEAREST(x) ((x) + 0x1.8p52 - 0x1.8p52)
/* The rounding error of a + b (TwoSum). */
INLINE double lost(double a, double b)
{
    const double total = a + b, of_b = total - a;
    return (a - (total - of_b)) + (b - of_b);
}
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

INLINE void cos_psi_fused(double theta_1, double theta_2, double *to_0, double *to_1, double *to_2)
{
    const double t1 = theta_1 + theta_2;
    const double t2 = NEAREST(t1 * 0x1.45f306dc9c883p-3);
    const double t3 = t2 * 2.0;
    const double t4 = t3 * -0x1.921fb54440000p+1;
    const double t5 = t3 * -0x1.68c234c4c0000p-38;
    const double t6 = t3 * -0x1.98a2e03700000p-76;
    const double t7 = t3 * -0x1.cd129024e088ap-114;
    const double t8 = lost(theta_1, theta_2);
    const double t9 = t1 + t4;
    const double t10 = lost(t1, t4);
    const double t11 = t9 + t5;
    const double t12 = lost(t9, t5);
    const double t13 = t11 + t6;
    const double t14 = lost(t11, t6);
    const double t15 = t13 + t7;
    const double t16 = lost(t13, t7);
    const double t17 = t8 + t10;
    const double t18 = lost(t8, t10);
    const double t19 = t17 + t12;
    const double t20 = lost(t17, t12);
    const double t21 = t19 + t14;
    const double t22 = lost(t19, t14);
    const double t23 = t21 + t16;
    const double t24 = lost(t21, t16);
    const double t25 = t23 + t15;
    const double t26 = lost(t23, t15);
    const double t27 = t18 + t20;
    const double t28 = t27 + t22;
    const double t29 = t28 + t24;
    const double t30 = t29 + t26;
    const double t31 = t30 + t25;
    const double t32 = lost(t18, t20) + lost(t27, t22) + lost(t28, t24) + lost(t29, t26) + lost(t30, t25);
    const double t33 = LARGER(SMALLER(t31 + t32, 0x1.921fb54442d18p+1), -0x1.921fb54442d18p+1);
    const double t34 = t2 * 0.5;
    const double t35 = t34 - NEAREST(t34);
    const double t36 = t33 * 0.5;
    const double t37 = t36 * t36;
    const double t38 = (t37 * -0x1.bbd779334ef0bp-13 + -0x1.1566abc011567p-9) * t37 + -0x1.6c16c16c16c17p-6;
    *to_0 = t33;
    *to_1 = ((t38 * t37 + -0x1.5555555555555p-2) * t37 + 1.0) * lost(t31, t32);
    *to_2 = t35 * t35 * 4.0 - 0.5;
}

INLINE void sin_psi_fused(double theta_1, double theta_2, double *to_0, double *to_1, double *to_2)
{
    const double t1 = theta_1 + theta_2;
    const double t2 = NEAREST(t1 * 0x1.45f306dc9c883p-3 - 0.5);
    const double t3 = t2 * 2.0 + 1.0;
    const double t4 = t3 * -0x1.921fb54440000p+1;
    const double t5 = t3 * -0x1.68c234c4c0000p-38;
    const double t6 = t3 * -0x1.98a2e03700000p-76;
    const double t7 = t3 * -0x1.cd129024e088ap-114;
    const double t8 = lost(theta_1, theta_2);
    const double t9 = t1 + t4;
    const double t10 = lost(t1, t4);
    const double t11 = t9 + t5;
    const double t12 = lost(t9, t5);
    const double t13 = t11 + t6;
    const double t14 = lost(t11, t6);
    const double t15 = t13 + t7;
    const double t16 = lost(t13, t7);
    const double t17 = t8 + t10;
    const double t18 = lost(t8, t10);
    const double t19 = t17 + t12;
    const double t20 = lost(t17, t12);
    const double t21 = t19 + t14;
    const double t22 = lost(t19, t14);
    const double t23 = t21 + t16;
    const double t24 = lost(t21, t16);
    const double t25 = t23 + t15;
    const double t26 = lost(t23, t15);
    const double t27 = t18 + t20;
    const double t28 = t27 + t22;
    const double t29 = t28 + t24;
    const double t30 = t29 + t26;
    const double t31 = t30 + t25;
    const double t32 = lost(t18, t20) + lost(t27, t22) + lost(t28, t24) + lost(t29, t26) + lost(t30, t25);
    const double t33 = LARGER(SMALLER(t31 + t32, 0x1.921fb54442d18p+1), -0x1.921fb54442d18p+1);
    const double t34 = t2 * 0.5;
    const double t35 = t34 - NEAREST(t34);
    const double t36 = t33 * 0.5;
    const double t37 = t36 * t36;
    const double t38 = (t37 * -0x1.bbd779334ef0bp-13 + -0x1.1566abc011567p-9) * t37 + -0x1.6c16c16c16c17p-6;
    *to_0 = t33;
    *to_1 = ((t38 * t37 + -0x1.5555555555555p-2) * t37 + 1.0) * lost(t31, t32);
    *to_2 = t35 * t35 * -4.0 - -0.5;
}

INLINE double share_fused(double theta_1, double theta_2)
{
    const double t1 = theta_2 - theta_1;
    const double t2 = SMALLER(t1 * 0.5, 0x1.921fb54442d18p+0);
    const double t3 = t2 * t2;
    const double t4 = (t3 * -0x1.bbd779334ef0bp-13 + -0x1.1566abc011567p-9) * t3 + -0x1.6c16c16c16c17p-6;
    const double t5 = lost(theta_2, -theta_1) / LARGER(t1, 0x1.0000000000000p-1000);
    return ((t4 * t3 + -0x1.5555555555555p-2) * t3 + 1.0) * 3.0 * t5;
}

/* I_p* = (2*alpha - sin(alpha)*cos(alpha) - cos(alpha)**3*atanh(sin(alpha)))/3, 0 <= alpha <= pi/2, best, fused:
 * proved within 0.633 ulp (certificates/polar_moment.json) */
/* alpha < 1.08 */
INLINE double polar_moment_best_fused_near(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double t1 = -alpha_2;
    const double alpha_4 = alpha_2 * alpha_2;
    const double p1 = POLY5(alpha_4, 0x1.35581df44ec96p-11, 0x1.f93e2aae775cep-20, 0x1.b9df879715ff3p-26,
        -0x1.27f314db23c38p-27, -0x1.1e1f4bba8b50ep-27, -0x1.6a451c111f071p-30);
    const double p2 = POLY6(alpha_4, -0x1.ce55c8ea5155fp-8, -0x1.08db2a390eefbp-15, 0x1.0dd07324275dep-24,
        0x1.fc9cd0ab275d4p-27, 0x1.9b04016f6cf6cp-27, 0x1.2b1d88cf43807p-28, 0x1.c14341ea6f3a8p-33);
    const double t2 = FMA(alpha_2, FMA(alpha_2, p1, p2), 0x1.d41d41d41cc16p-5);
    const double t3 = FMA(t2, alpha_2, -0x1.111111111110ep-2);
    const double t4 = FMA(t3, alpha_2, 0x1.5555555555555p-1);
    const double t5 = -0x1.111111111110ep-2 - t3;
    const double t6 = FMA(t3, alpha_2, 0x1.5555555555555p-1 - t4) + 0x1.5555555555555p-55;
    const double t7 = alpha_2 * t4;
    const double t8 = FMA(t1, t5, FMA(2.0, t4, -0x1.5555555555555p-1));
    const double t9 = FMA(FMA(alpha, alpha, t1), t8, FMA(alpha_2, t4, -t7));
    return FMA(alpha, t7, alpha * FMA(alpha_2, FMA(alpha_2, FMA(t2, alpha_2, t5), t6), t9));
}
/* alpha >= 1.08, in b = pi/2 - alpha */
INLINE double polar_moment_best_fused_far(double alpha)
{
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p1 = POLY5(b_2, -0x1.213ce23146d4ep-7, 0x1.94ebfb96f2248p-4, -0x1.0ee089c62234bp-5,
        0x1.5570c6bf81994p-8, -0x1.057adab8c0352p-11, 0x1.1322fd18fd6adp-15);
    const double p2 = POLY5(b_2, 0x1.555555555535bp-2, -0x1.55555557cd14ep-3, 0x1.27d27720bb130p-5,
        -0x1.2834b296ce4d6p-8, 0x1.811b7ecc87ea4p-12, -0x1.ae976a0e5bdb3p-16);
    const double t1 = FMA(b * b_2, FMA(p2, logarithm_fused(b), p1), -0x1.0548e0b5cd961p-7);
    return alpha + -0x1.0800000000000p-1 + t1;
}
INLINE double polar_moment_best_fused(double alpha)
{
    const double near = polar_moment_best_fused_near(alpha);
    const double far = polar_moment_best_fused_far(alpha);
    return SELECT(alpha < 0x1.147ae147ae148p+0, near, far);
}
#define polar_moment_best_fused_KIND pieces
#define polar_moment_best_fused_BELOW_double UINT64_C(0x3ff147ae147ae147)
#define polar_moment_best_fused_BELOW_float UINT32_C(0x3f8a3d70)

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
#define polar_moment_1e_6_fused_KIND whole

/* I_p* = (2*alpha - sin(alpha)*cos(alpha) - cos(alpha)**3*atanh(sin(alpha)))/3, 0 <= alpha <= pi/2, float32,
 * fused: proved within 26.1 ulp (certificates/polar_moment.json), rounded correctly to float32 */
INLINE double polar_moment_float32_fused(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double t1 = b * (alpha + 0x1.921fb54442d18p+0);
    const double p1 = POLY13(t1, -0x1.eda09f3e90404p-3, -0x1.fb18820faf930p+8, -0x1.acc2458341e71p+17,
        -0x1.b89784a124872p+24, -0x1.4aec89218ffcbp+30, -0x1.9493ab246c44dp+34, -0x1.ad1ad41277191p+37,
        -0x1.97371cc7271afp+39, -0x1.58ff746b8797cp+40, -0x1.f26135829abfdp+39, -0x1.11120afbaa57dp+38,
        -0x1.84d2a15011170p+34, -0x1.dea97414601d5p+30, -0x1.0fda1be36df3bp+26);
    const double p2 = POLY13(t1, 1.0, 0x1.06f5c44de3519p+11, 0x1.bc8376cd15a77p+19, 0x1.c84d5ff85cf90p+26,
        0x1.55d3c0d1bcfb3p+32, 0x1.9f64de9289387p+36, 0x1.b2bd5e7e4c44bp+39, 0x1.9098ea56ea0bap+41,
        0x1.3d1a85ebfa9e6p+42, 0x1.7f09711bb0b5fp+41, 0x1.9b97574bd55b0p+38, -0x1.e6cb677ad5a72p+35,
        0x1.62e410c2d8b7bp+31, -0x1.8b209552ed2a2p+25);
    const double t2 = alpha_2 * alpha * (FMA(p1 / p2, alpha_2, -0x1.051eb851eb852p-54) + 1.0);
    return t2 * 0x1.5555555555555p-1;
}
#define polar_moment_float32_fused_KIND whole

/* Theta* = alpha/2 - sin(2*alpha)/6 - sin(4*alpha)/24, 0 <= alpha <= pi/2, best, fused: proved within 0.784 ulp
 * (certificates/moment_of_inertia.json) */
/* alpha < 0.98 */
INLINE double moment_of_inertia_best_fused_near(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double t1 = -alpha_2;
    const double alpha_4 = alpha_2 * alpha_2;
    const double p1 = POLY3(alpha_4, 0x1.1f7d05c5c9224p-8, 0x1.1f086d60486fep-15, 0x1.9433fa964b521p-24,
        0x1.b0e8467a16168p-34);
    const double p2 = POLY3(alpha_4, -0x1.f1029e62c0580p-6, -0x1.d716074f5e010p-12, -0x1.0e1e9522a6e8ep-19,
        -0x1.e85b919eac4d5p-29);
    const double t2 = FMA(alpha_2, FMA(alpha_2, p1, p2), 0x1.1e11e11e11d01p-3);
    const double t3 = FMA(t2, alpha_2, -0x1.9999999999997p-2);
    const double t4 = FMA(t3, alpha_2, 0x1.5555555555555p-1);
    const double t5 = -0x1.9999999999997p-2 - t3;
    const double t6 = FMA(t3, alpha_2, 0x1.5555555555555p-1 - t4) + 0x1.5555555555555p-55;
    const double t7 = alpha_2 * t4;
    const double t8 = FMA(t1, t5, FMA(2.0, t4, -0x1.5555555555555p-1));
    const double t9 = FMA(FMA(alpha, alpha, t1), t8, FMA(alpha_2, t4, -t7));
    return FMA(alpha, t7, alpha * FMA(alpha_2, FMA(alpha_2, FMA(t2, alpha_2, t5), t6), t9));
}
/* alpha >= 0.98, in b = pi/2 - alpha */
INLINE double moment_of_inertia_best_fused_far(double alpha)
{
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p1 = POLY9(b_2, -0x1.555555555554fp-3, -0x1.c71c71c71c9d1p-3, 0x1.3e93e93e974c4p-2,
        -0x1.0cbb766293955p-3, 0x1.e94dfd574ccc8p-6, -0x1.1e5e1c82f59e1p-8, 0x1.d6a153b5d88acp-12,
        -0x1.1f07fbda0bf19p-15, 0x1.0f3d73ce0e4d0p-19, -0x1.989edb1ab88c8p-24);
    return 0.5 * alpha + -0.125 + FMA(b, p1, 0x1.fffffffffffffp-4);
}
INLINE double moment_of_inertia_best_fused(double alpha)
{
    const double near = moment_of_inertia_best_fused_near(alpha);
    const double far = moment_of_inertia_best_fused_far(alpha);
    return SELECT(alpha < 0x1.f5c28f5c28f5cp-1, near, far);
}
#define moment_of_inertia_best_fused_KIND pieces
#define moment_of_inertia_best_fused_BELOW_double UINT64_C(0x3fef5c28f5c28f5b)
#define moment_of_inertia_best_fused_BELOW_float UINT32_C(0x3f7ae147)

/* Theta* = alpha/2 - sin(2*alpha)/6 - sin(4*alpha)/24, 0 <= alpha <= pi/2, 1e-10, fused: proved within 3.56e-12
 * relative (certificates/moment_of_inertia.json) */
INLINE double moment_of_inertia_1e_10_fused(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY9(alpha_2, 0x1.55555555502c0p-1, -0x1.99999996b5367p-2, 0x1.1e11e0d7b66ffp-3,
        -0x1.f10293cdf1d20p-6, 0x1.1f7c9cb90ff08p-8, -0x1.d70c8c3356105p-12, 0x1.1ec4f59c801cbp-15,
        -0x1.0bc4e9f8c08c4p-19, 0x1.7a7cb07e3408cp-24, -0x1.4936e56328342p-29);
    return p1 * alpha_2 * alpha;
}
#define moment_of_inertia_1e_10_fused_KIND whole

/* Theta* = alpha/2 - sin(2*alpha)/6 - sin(4*alpha)/24, 0 <= alpha <= pi/2, 1e-6, fused: proved within 2.42e-07
 * relative (certificates/moment_of_inertia.json) */
INLINE double moment_of_inertia_1e_6_fused(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY6(alpha_2, 0x1.55554ffb45dfap-1, -0x1.999830f1f6825p-2, 0x1.1e017fc24dd09p-3,
        -0x1.efda754ae7b31p-6, 0x1.1a5c427a6780ap-8, -0x1.a6e3a2c99c515p-12, 0x1.50ef7c600437bp-16);
    return p1 * alpha_2 * alpha;
}
#define moment_of_inertia_1e_6_fused_KIND whole

/* Theta* = alpha/2 - sin(2*alpha)/6 - sin(4*alpha)/24, 0 <= alpha <= pi/2, float32, fused: proved within 13.2 ulp
 * (certificates/moment_of_inertia.json), rounded correctly to float32 */
INLINE double moment_of_inertia_float32_fused(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY11(alpha_2, -0x1.051eb851eb852p-54, -0x1.99999999996c8p-2, 0x1.1e11e11e0a487p-3,
        -0x1.f1029e60fb14bp-6, 0x1.1f7d05ab48cbcp-8, -0x1.d71603ca7c39cp-12, 0x1.1f084a41ae704p-15,
        -0x1.0e1d1e6c6b2cep-19, 0x1.942dc15a29305p-24, -0x1.ea28f9307f31ap-29, 0x1.da8a01ce2be69p-34,
        -0x1.2d46b60ffc0b0p-39);
    return alpha_2 * alpha * (p1 + 0x1.5555555555555p-1);
}
#define moment_of_inertia_float32_fused_KIND whole

/* C_r = sin(alpha) - cos(alpha)**2*atanh(sin(alpha)), 0 <= alpha <= pi/2, best, fused: proved within 0.711 ulp
 * (certificates/radial_weight_amplitude.json) */
/* alpha < 1.16 */
INLINE double radial_weight_amplitude_best_fused_near(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double t1 = -alpha_2;
    const double alpha_4 = alpha_2 * alpha_2;
    const double p1 = POLY6(alpha_4, -0x1.47d5cdb030433p-16, -0x1.00ac8c802feebp-18, -0x1.69df4f230a0b7p-23,
        0x1.2d45b70de203ap-21, 0x1.a784f4de008cbp-21, 0x1.4dfa67586ea60p-22, 0x1.af42be543eb97p-26);
    const double p2 = POLY7(alpha_4, -0x1.664f48a970d61p-10, -0x1.07de2765dbf0fp-16, -0x1.292bdce010dd2p-20,
        -0x1.c415858a36ac5p-22, -0x1.aca0247c4f189p-21, -0x1.3b0445a115011p-21, -0x1.e50b53856db7fp-24,
        -0x1.6be6fd1ae56a3p-29);
    const double t2 = FMA(alpha_2, FMA(alpha_2, p1, p2), 0x1.2b12b12b25b86p-6);
    const double t3 = FMA(t2, alpha_2, -0x1.9999999999a03p-3);
    const double t4 = FMA(t3, alpha_2, 0x1.5555555555555p-1);
    const double t5 = -0x1.9999999999a03p-3 - t3;
    const double t6 = FMA(t3, alpha_2, 0x1.5555555555555p-1 - t4) + 0x1.5555555555555p-55;
    const double t7 = alpha_2 * t4;
    const double t8 = FMA(t1, t5, FMA(2.0, t4, -0x1.5555555555555p-1));
    const double t9 = FMA(FMA(alpha, alpha, t1), t8, FMA(alpha_2, t4, -t7));
    return FMA(alpha, t7, alpha * FMA(alpha_2, FMA(alpha_2, FMA(t2, alpha_2, t5), t6), t9));
}
/* alpha >= 1.16, in b = pi/2 - alpha */
INLINE double radial_weight_amplitude_best_fused_far(double alpha)
{
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p1 = POLY5(b_2, 0x1.d1bd0105cb2e0p-4, 0x1.2c981ff6a61a1p-1, -0x1.5fec3504ee171p-4,
        0x1.c0fb866c21493p-8, -0x1.5ca68c3cf25f9p-12, 0x1.37f1000d20ec1p-17);
    const double p2 = POLY5(b_2, 0x1.000000000018dp+0, -0x1.55555553ea141p-2, 0x1.6c16c7361cfd2p-5,
        -0x1.a010b7f783d5ep-9, 0x1.2adbbfd3a71d1p-13, -0x1.d8e0e3d8e3d1ep-19);
    const double t1 = FMA(b_2, FMA(p2, logarithm_fused(2.0 * b), p1), 0x1.1e04abbbd2e80p-5);
    return 0.5 * alpha + 0x1.7000000000000p-3 + FMA(b, FMA(b, -2.0, 0.5), t1);
}
INLINE double radial_weight_amplitude_best_fused(double alpha)
{
    const double near = radial_weight_amplitude_best_fused_near(alpha);
    const double far = radial_weight_amplitude_best_fused_far(alpha);
    return SELECT(alpha < 0x1.28f5c28f5c28fp+0, near, far);
}
#define radial_weight_amplitude_best_fused_KIND pieces
#define radial_weight_amplitude_best_fused_BELOW_double UINT64_C(0x3ff28f5c28f5c28e)
#define radial_weight_amplitude_best_fused_BELOW_float UINT32_C(0x3f947ae1)

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
#define radial_weight_amplitude_1e_6_fused_KIND whole

/* C_r = sin(alpha) - cos(alpha)**2*atanh(sin(alpha)), 0 <= alpha <= pi/2, float32, fused: proved within 43.1 ulp
 * (certificates/radial_weight_amplitude.json), rounded correctly to float32 */
INLINE double radial_weight_amplitude_float32_fused(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double t1 = b * (alpha + 0x1.921fb54442d18p+0);
    const double p1 = POLY20(t1, -0x1.fcc9f54cce51fp-3, -0x1.24c3bc7db3f90p+18, -0x1.8b95658e50fe7p+35,
        -0x1.f635f6163f6b0p+50, -0x1.7ad31e8998acbp+64, -0x1.89b7d36da870ep+76, -0x1.38d53348af22cp+87,
        -0x1.9aea5de6b3401p+96, -0x1.da1efb4ce0161p+104, -0x1.f853b23fb5f71p+111, -0x1.00f930750414ap+118,
        -0x1.027a37dc5256ep+123, -0x1.0629e1fa4c058p+127, -0x1.0f68b6a6bf1b6p+130, -0x1.1f0f74881d055p+132,
        -0x1.31ba3d8b7b082p+133, -0x1.3b9b7132332abp+133, -0x1.23713f613483ep+132, -0x1.95d005b405c3fp+129,
        -0x1.2029435426073p+125, -0x1.0d996f1762d3fp+120);
    const double p2 = POLY20(t1, 1.0, 0x1.269cbff6ba6dap+20, 0x1.8e1485ae88f9ap+37, 0x1.f9614ee4cab88p+52,
        0x1.7d3702af0e259p+66, 0x1.8c336fef56e5cp+78, 0x1.3acd91fc2dbc7p+89, 0x1.9d7eda824fed5p+98,
        0x1.dd13e333b1d4ap+106, 0x1.fb6ce9266286bp+113, 0x1.0280557cab165p+120, 0x1.03e74cef09d9cp+125,
        0x1.075c98db4c490p+129, 0x1.101042ad622d7p+132, 0x1.1e4a4988dca0fp+134, 0x1.2d14b959fe94ap+135,
        0x1.2c93e14a580f0p+135, 0x1.f5cb8e20a4305p+133, 0x1.c474dcf704384p+130, -0x1.c7de34571c909p+126,
        0x1.f534fe5a2ef06p+120);
    const double t2 = alpha_2 * alpha * (FMA(p1 / p2, alpha_2, -0x1.051eb851eb852p-54) + 1.0);
    return t2 * 0x1.5555555555555p-1;
}
#define radial_weight_amplitude_float32_fused_KIND whole

/* C_theta = 2*sin(alpha)**3/3, 0 <= alpha <= pi/2, best, fused: proved within 0.746 ulp
 * (certificates/weight_moment_amplitude.json) */
/* alpha < 1.03 */
INLINE double weight_moment_amplitude_best_fused_near(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double t1 = -alpha_2;
    const double alpha_4 = alpha_2 * alpha_2;
    const double p1 = POLY2(alpha_4, 0x1.83c897879fcd2p-11, 0x1.eaea362838402p-20, 0x1.b3d227f76be5dp-30);
    const double p2 = POLY3(alpha_4, -0x1.282ef4b6547dbp-7, -0x1.65f59c9b7af02p-15, -0x1.03dc2f0f49b91p-24,
        -0x1.10ed8c6371668p-35);
    const double t2 = FMA(alpha_2, FMA(alpha_2, p1, p2), 0x1.27d27d27d24c4p-4);
    const double t3 = FMA(t2, alpha_2, -0x1.5555555555550p-2);
    const double t4 = FMA(t3, alpha_2, 0x1.5555555555555p-1);
    const double t5 = -0x1.5555555555550p-2 - t3;
    const double t6 = FMA(t3, alpha_2, 0x1.5555555555555p-1 - t4) + 0x1.5555555555555p-55;
    const double t7 = alpha_2 * t4;
    const double t8 = FMA(t1, t5, FMA(2.0, t4, -0x1.5555555555555p-1));
    const double t9 = FMA(FMA(alpha, alpha, t1), t8, FMA(alpha_2, t4, -t7));
    return FMA(alpha, t7, alpha * FMA(alpha_2, FMA(alpha_2, FMA(t2, alpha_2, t5), t6), t9));
}
/* alpha >= 1.03, in b = pi/2 - alpha */
INLINE double weight_moment_amplitude_best_fused_far(double alpha)
{
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p1 = POLY7(b_2, -0x1.fffffffffffedp-3, 0x1.2aaaaaaaaa8bcp-1, -0x1.5b05b05af3bb4p-3,
        0x1.bc8bc8b27c25fp-6, -0x1.637e073d46fc3p-9, 0x1.83c9b28c7277ap-13, -0x1.329537d00329ap-17,
        0x1.62222bcf50f00p-22);
    const double t1 = FMA(b_2, p1, FMA(b, -0x1.1a62633145c07p-53, 0x1.5555555555555p-53));
    return 0.5 * alpha + -0x1.e652ff776be20p-4 + FMA(b, FMA(b, -0.75, 0.5), t1);
}
INLINE double weight_moment_amplitude_best_fused(double alpha)
{
    const double near = weight_moment_amplitude_best_fused_near(alpha);
    const double far = weight_moment_amplitude_best_fused_far(alpha);
    return SELECT(alpha < 0x1.07ae147ae147bp+0, near, far);
}
#define weight_moment_amplitude_best_fused_KIND pieces
#define weight_moment_amplitude_best_fused_BELOW_double UINT64_C(0x3ff07ae147ae147a)
#define weight_moment_amplitude_best_fused_BELOW_float UINT32_C(0x3f83d70a)

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
#define weight_moment_amplitude_1e_10_fused_KIND whole

/* C_theta = 2*sin(alpha)**3/3, 0 <= alpha <= pi/2, 1e-6, fused: proved within 4.38e-07 relative
 * (certificates/weight_moment_amplitude.json) */
INLINE double weight_moment_amplitude_1e_6_fused(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY5(alpha_2, 0x1.55554ba99af07p-1, -0x1.555382cc0e3b7p-2, 0x1.27b41ec7abd41p-4,
        -0x1.26ad631e2f9a1p-7, 0x1.71e62473ed8bap-11, -0x1.ff7dbdabc38e7p-16);
    return p1 * alpha_2 * alpha;
}
#define weight_moment_amplitude_1e_6_fused_KIND whole

/* C_theta = 2*sin(alpha)**3/3, 0 <= alpha <= pi/2, float32, fused: proved within 7.75 ulp
 * (certificates/weight_moment_amplitude.json), rounded correctly to float32 */
INLINE double weight_moment_amplitude_float32_fused(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY11(alpha_2, -0x1.051eb851eb852p-54, -0x1.5555555555554p-2, 0x1.27d27d27d2756p-4,
        -0x1.282ef4b665ffep-7, 0x1.83c8978eb865bp-11, -0x1.65f59e3640a49p-15, 0x1.eaeaa5aab60b2p-20,
        -0x1.03e57d9d383d5p-24, 0x1.b5b2194d4ba7cp-30, -0x1.2bcf358638b26p-35, 0x1.4fd86dd53b9c7p-41,
        -0x1.0dfa1fe98d53ep-47);
    return alpha_2 * alpha * (p1 + 0x1.5555555555555p-1);
}
#define weight_moment_amplitude_float32_fused_KIND whole

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
#define resistance_factor_1e_10_fused_KIND whole

/* lambda = 2*alpha*(1 - cos(alpha)), 0 <= alpha <= pi/2, 1e-6, fused: proved within 1.71e-07 relative
 * (certificates/resistance_factor.json) */
INLINE double resistance_factor_1e_6_fused(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY3(alpha_2, 0x1.fffffa5b957a5p-1, -0x1.5553226831932p-4, 0x1.6b8afbde89795p-9,
        -0x1.899d6d596ca14p-15);
    return p1 * alpha_2 * alpha;
}
#define resistance_factor_1e_6_fused_KIND whole

/* lambda = 2*alpha*(1 - cos(alpha)), 0 <= alpha <= pi/2, float32, fused: proved within 4.52 ulp
 * (certificates/resistance_factor.json), rounded correctly to float32 */
INLINE double resistance_factor_float32_fused(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY7(alpha_2, -0x1.051eb851eb852p-54, -0x1.5555555555532p-4, 0x1.6c16c16c13f58p-9,
        -0x1.a01a019db037ep-15, 0x1.27e4fa7a17b18p-21, -0x1.1eed1f83c7382p-28, 0x1.936141e56bb6cp-36,
        -0x1.a0dfa5b9b370bp-44);
    return alpha_2 * alpha * (p1 + 1.0);
}
#define resistance_factor_float32_fused_KIND whole

/* A = polar_moment(alpha)/resistance_factor(alpha), finite at alpha = 0 where both vanish, 0 <= alpha <= pi/2,
 * best, fused: proved within 0.791 ulp (certificates/dynamic_coefficient.json) */
INLINE double dynamic_coefficient_best_fused(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double alpha_4 = alpha_2 * alpha_2;
    const double p1 = POLY6(alpha_4, 0x1.35581e870032ap-11, 0x1.f97a7c55fd43dp-20, 0x1.3466cc6763dc2p-25,
        0x1.9ce4e640bb658p-26, 0x1.7336ecde65986p-26, 0x1.6b4001adffcfdp-28, 0x1.5d16ff54208cdp-33);
    const double p2 = POLY6(alpha_4, -0x1.ce55c8eb89282p-8, -0x1.08db7c94b9b10p-15, 0x1.fd34771cf025ep-25,
        -0x1.bd50f1ff22c7cp-28, -0x1.a96ece7c74626p-26, -0x1.b9693fa33fa33p-27, -0x1.69ce9749f5b0ep-30);
    const double t1 = FMA(alpha_2, FMA(alpha_2, p1, p2), 0x1.d41d41d41e123p-5);
    const double t2 = FMA(t1, alpha_2, -0x1.1111111111116p-2);
    const double t3 = FMA(t2, alpha_2, 0x1.5555555555555p-1);
    const double t4 = FMA(t2, alpha_2, 0x1.5555555555555p-1 - t3) + 0x1.5555555555555p-55;
    const double t5 = FMA(alpha, alpha, -alpha_2);
    const double t6 = FMA(t5, t2, FMA(alpha_2, FMA(t1, alpha_2, -0x1.1111111111116p-2 - t2), t4));
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p3 = POLY5(b_2, -0x1.213ce230dbeefp-7, 0x1.94ebfbb754504p-4, -0x1.0ee077691b943p-5,
        0x1.5578045f5fe35p-8, -0x1.0533239fbfa2ep-11, 0x1.0aedde3663fc9p-15);
    const double p4 = POLY5(b_2, 0x1.5555555556010p-2, -0x1.5555555202e7cp-3, 0x1.27d280bf8021ep-5,
        -0x1.282e5dae893d2p-8, 0x1.82dcf0100d8aep-12, -0x1.9d1d2c7ac5e77p-16);
    const double t7 = FMA(b * b_2, FMA(p4, logarithm_fused(b), p3), 0x1.fab71f4a3269fp-7);
    const double t8 = alpha + -0x1.1400000000000p-1;
    const double t9 = t8 + t7;
    const double t10 = alpha < 0x1.23d70a3d70a3dp+0;
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
 * 0 <= alpha <= pi/2, best, fused: proved within 0.849 ulp (certificates/weight_moment_per_inertia.json) */
INLINE double weight_moment_per_inertia_best_fused(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double alpha_4 = alpha_2 * alpha_2;
    const double p1 = POLY2(alpha_4, 0x1.83c897879fcd2p-11, 0x1.eaea362838402p-20, 0x1.b3d227f76be5dp-30);
    const double p2 = POLY3(alpha_4, -0x1.282ef4b6547dbp-7, -0x1.65f59c9b7af02p-15, -0x1.03dc2f0f49b91p-24,
        -0x1.10ed8c6371668p-35);
    const double t1 = FMA(alpha_2, FMA(alpha_2, p1, p2), 0x1.27d27d27d24c4p-4);
    const double t2 = FMA(t1, alpha_2, -0x1.5555555555550p-2);
    const double t3 = FMA(t2, alpha_2, 0x1.5555555555555p-1);
    const double t4 = FMA(t2, alpha_2, 0x1.5555555555555p-1 - t3) + 0x1.5555555555555p-55;
    const double t5 = FMA(alpha, alpha, -alpha_2);
    const double t6 = FMA(t5, t2, FMA(alpha_2, FMA(t1, alpha_2, -0x1.5555555555550p-2 - t2), t4));
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p3 = POLY7(b_2, -0x1.fffffffffffdap-4, 0x1.2aaaaaaaaa8bcp-1, -0x1.5b05b05af3bb4p-3,
        0x1.bc8bc8b27c25fp-6, -0x1.637e073d46fc3p-9, 0x1.83c9b28c7277ap-13, -0x1.329537d00329ap-17,
        0x1.62222bcf50f00p-22);
    const double t7 = FMA(b_2, p3, FMA(b, -0x1.1a62633145c07p-53, 0x1.5555555555555p-53));
    const double t8 = FMA(b, FMA(b, -0.875, 0.5), t7);
    const double t9 = 0.5 * alpha;
    const double t10 = t9 + -0x1.e652ff776be20p-4;
    const double t11 = t10 + t8;
    const double t12 = alpha < 0x1.07ae147ae147bp+0;
    const double t13 = SELECT(t12, t3, t11);
    const double p4 = POLY3(alpha_4, 0x1.1f7d05c727936p-8, 0x1.1f087770ddc04p-15, 0x1.9464193efe988p-24,
        0x1.f1202dbed1bfap-34);
    const double p5 = POLY4(alpha_4, -0x1.f1029e62caa8ap-6, -0x1.d71607ba22323p-12, -0x1.0e1fcc07dea81p-19,
        -0x1.ecfac632905bcp-29, -0x1.8163a70cab18cp-39);
    const double t14 = FMA(alpha_2, FMA(alpha_2, p4, p5), 0x1.1e11e11e11e33p-3);
    const double t15 = FMA(t14, alpha_2, -0x1.999999999999ap-2);
    const double t16 = FMA(t15, alpha_2, 0x1.5555555555555p-1);
    const double t17 = FMA(t15, alpha_2, 0x1.5555555555555p-1 - t16) + 0x1.5555555555555p-55;
    const double t18 = FMA(t5, t15, FMA(alpha_2, FMA(t14, alpha_2, -0x1.999999999999ap-2 - t15), t17));
    const double p6 = POLY8(b_2, -0x1.555555555555dp-3, -0x1.c71c71c71c2cbp-3, 0x1.3e93e93e8caaap-2,
        -0x1.0cbb76609fd02p-3, 0x1.e94dfc8968252p-6, -0x1.1e5e0301d5402p-8, 0x1.d6998e219ebbfp-12,
        -0x1.1e5164529e7c6p-15, 0x1.f96e579402ac4p-20);
    const double t19 = FMA(b, p6, 0x1.bffffffffffffp-5);
    const double t20 = t9 + -0x1.c000000000000p-5;
    const double t21 = t20 + t19;
    const double t22 = SELECT(t12, t16, t21);
    const double t23 = 1.0 / t22;
    const double t24 = t13 * t23;
    const double t25 = -t24;
    const double t26 = FMA(t25, t22, t13) + SELECT(t12, t6, t8 - (t11 - t10));
    return FMA(FMA(t25, SELECT(t12, t18, t19 - (t21 - t20)), t26), t23, t24);
}
#define weight_moment_per_inertia_best_fused_KIND whole

/* C_r/Theta* = radial_weight_amplitude(alpha)/moment_of_inertia(alpha), finite at alpha = 0 where both vanish, 0
 * <= alpha <= pi/2, best, fused: proved within 1.06 ulp (certificates/radial_weight_per_inertia.json) */
INLINE double radial_weight_per_inertia_best_fused(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double alpha_4 = alpha_2 * alpha_2;
    const double p1 = POLY6(alpha_4, -0x1.47d6550ee9d0cp-16, -0x1.012ffa1d7bb8cp-18, -0x1.27bb8bae33966p-22,
        0x1.1a81359ccddd5p-23, 0x1.13418fe0b0991p-22, 0x1.0943213fab51ep-23, 0x1.a4adecb98e7bcp-27);
    const double p2 = POLY7(alpha_4, -0x1.664f488838d73p-10, -0x1.07d900514f6e9p-16, -0x1.201bb884760cfp-20,
        -0x1.72761c0d3ee37p-23, -0x1.05b20a4b4d81bp-22, -0x1.c78901f7a344ap-23, -0x1.ab23c0c684008p-25,
        -0x1.8feee638d9bccp-30);
    const double t1 = FMA(alpha_2, FMA(alpha_2, p1, p2), 0x1.2b12b12b15251p-6);
    const double t2 = FMA(t1, alpha_2, -0x1.99999999999a6p-3);
    const double t3 = FMA(t2, alpha_2, 0x1.5555555555555p-1);
    const double t4 = FMA(t2, alpha_2, 0x1.5555555555555p-1 - t3) + 0x1.5555555555555p-55;
    const double t5 = FMA(alpha, alpha, -alpha_2);
    const double t6 = FMA(t5, t2, FMA(alpha_2, FMA(t1, alpha_2, -0x1.99999999999a6p-3 - t2), t4));
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p3 = POLY5(b_2, -0x1.7217f7d1ae2b5p-7, 0x1.2c981ff605456p-1, -0x1.5fec37466d3d8p-4,
        0x1.c0f97cefd9809p-8, -0x1.5c629576dda1ep-12, 0x1.69d163753cfb6p-17);
    const double p4 = POLY5(b_2, 0x1.0000000000151p+0, -0x1.555555546d298p-2, 0x1.6c16c422fd14bp-5,
        -0x1.a017058253bf2p-9, 0x1.285e13327bf2cp-13, -0x1.2f2674152353dp-18);
    const double t7 = FMA(b_2, FMA(p4, logarithm_fused(2.0 * b), p3), 0x1.5e04abbbd2e80p-5);
    const double t8 = FMA(b, FMA(b, -1.875, 0.5), t7);
    const double t9 = 0.5 * alpha;
    const double t10 = t9 + 0x1.6000000000000p-3;
    const double t11 = t10 + t8;
    const double t12 = alpha < 0x1.1c28f5c28f5c3p+0;
    const double t13 = SELECT(t12, t3, t11);
    const double p5 = POLY3(alpha_4, 0x1.1f7d05c6e14c8p-8, 0x1.1f0875ebf62e5p-15, 0x1.945e8fcf159d3p-24,
        0x1.eb715733f5861p-34);
    const double p6 = POLY4(alpha_4, -0x1.f1029e62c840fp-6, -0x1.d71607a798d92p-12, -0x1.0e1fa31c286cdp-19,
        -0x1.ec837f466cf7dp-29, -0x1.63651d4a410bbp-39);
    const double t14 = FMA(alpha_2, FMA(alpha_2, p5, p6), 0x1.1e11e11e11ddfp-3);
    const double t15 = FMA(t14, alpha_2, -0x1.9999999999999p-2);
    const double t16 = FMA(t15, alpha_2, 0x1.5555555555555p-1);
    const double t17 = FMA(t15, alpha_2, 0x1.5555555555555p-1 - t16) + 0x1.5555555555555p-55;
    const double t18 = FMA(t5, t15, FMA(alpha_2, FMA(t14, alpha_2, -0x1.9999999999999p-2 - t15), t17));
    const double p7 = POLY8(b_2, -0x1.555555555555cp-3, -0x1.c71c71c71c372p-3, 0x1.3e93e93e8dae1p-2,
        -0x1.0cbb7660cde68p-3, 0x1.e94dfc9b43c2dp-6, -0x1.1e5e050e2d7b2p-8, 0x1.d69a1f44ba292p-12,
        -0x1.1e5cc6e589d22p-15, 0x1.faff5e49e839dp-20);
    const double t19 = FMA(b, p7, 0x1.bffffffffffffp-5);
    const double t20 = t9 + -0x1.c000000000000p-5;
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
 * <= pi/2, best, fused: proved within 0.859 ulp (certificates/polar_moment_per_inertia.json) */
INLINE double polar_moment_per_inertia_best_fused(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double alpha_4 = alpha_2 * alpha_2;
    const double p1 = POLY5(alpha_4, 0x1.35581e791a6dcp-11, 0x1.f9700b4f2fc3cp-20, 0x1.1cd3a955650e0p-25,
        0x1.82b2f7bdf7b9ep-27, 0x1.6732f4480f5efp-28, 0x1.8862d1d4fafcdp-32);
    const double p2 = POLY5(alpha_4, -0x1.ce55c8eb76557p-8, -0x1.08db71b3dc7acp-15, 0x1.01ed9716bf3c8p-24,
        0x1.05247a6ed6951p-31, -0x1.08b1d6aba5ae0p-27, -0x1.f61d3d6b2f29ep-30);
    const double t1 = FMA(alpha_2, FMA(alpha_2, p1, p2), 0x1.d41d41d41e089p-5);
    const double t2 = FMA(t1, alpha_2, -0x1.1111111111116p-2);
    const double t3 = FMA(t2, alpha_2, 0x1.5555555555555p-1);
    const double t4 = FMA(t2, alpha_2, 0x1.5555555555555p-1 - t3) + 0x1.5555555555555p-55;
    const double t5 = FMA(alpha, alpha, -alpha_2);
    const double t6 = FMA(t5, t2, FMA(alpha_2, FMA(t1, alpha_2, -0x1.1111111111116p-2 - t2), t4));
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p3 = POLY5(b_2, -0x1.213ce22f8ace3p-7, 0x1.94ebfbdbd73afp-4, -0x1.0ee07496f41fcp-5,
        0x1.55751bc3c375dp-8, -0x1.05761dc378033p-11, 0x1.10577530f2d3dp-15);
    const double p4 = POLY5(b_2, 0x1.5555555558d28p-2, -0x1.5555554a056aep-3, 0x1.27d28418e33f8p-5,
        -0x1.282fbd7742ef9p-8, 0x1.81e84c0a68db4p-12, -0x1.aa0551f4078d8p-16);
    const double t7 = FMA(b * b_2, FMA(p4, logarithm_fused(b), p3), 0x1.3eadc7d28c9a8p-5);
    const double t8 = alpha + -0.5625;
    const double t9 = t8 + t7;
    const double t10 = alpha < 0x1.0a3d70a3d70a4p+0;
    const double t11 = SELECT(t10, t3, t9);
    const double p5 = POLY3(alpha_4, 0x1.1f7d05c725090p-8, 0x1.1f08775913bf9p-15, 0x1.94639daf30d09p-24,
        0x1.f07a32b206b19p-34);
    const double p6 = POLY4(alpha_4, -0x1.f1029e62ca99ep-6, -0x1.d71607b93bd7ep-12, -0x1.0e1fc9002c905p-19,
        -0x1.eceec88dfdfe1p-29, -0x1.7d8e316ca0cc9p-39);
    const double t12 = FMA(alpha_2, FMA(alpha_2, p5, p6), 0x1.1e11e11e11e32p-3);
    const double t13 = FMA(t12, alpha_2, -0x1.999999999999ap-2);
    const double t14 = FMA(t13, alpha_2, 0x1.5555555555555p-1);
    const double t15 = FMA(t13, alpha_2, 0x1.5555555555555p-1 - t14) + 0x1.5555555555555p-55;
    const double t16 = FMA(t5, t13, FMA(alpha_2, FMA(t12, alpha_2, -0x1.999999999999ap-2 - t13), t15));
    const double p7 = POLY8(b_2, -0x1.555555555555cp-3, -0x1.c71c71c71c374p-3, 0x1.3e93e93e8db37p-2,
        -0x1.0cbb7660ceadep-3, 0x1.e94dfc9b0a6adp-6, -0x1.1e5e04e3dd133p-8, 0x1.d69a035b8852bp-12,
        -0x1.1e58f354d2ab8p-15, 0x1.fa3bac2f463d3p-20);
    const double t17 = FMA(b, p7, 0x1.bffffffffffffp-5);
    const double t18 = 0.5 * alpha + -0x1.c000000000000p-5;
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
 * vanish, 0 <= alpha <= pi/2, best, fused: proved within 0.95 ulp
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
    const double p3 = POLY7(b_2, -0x1.ffffffffffffep-4, 0x1.2aaaaaaaaaa94p-1, -0x1.5b05b05b042afp-3,
        0x1.bc8bc8bb3a27ap-6, -0x1.637e09bf1814ap-9, 0x1.83ca7ec09ab67p-13, -0x1.32b73da32d767p-17,
        0x1.66c6f12e40144p-22);
    const double t7 = FMA(b_2, p3, FMA(b, -0x1.1a62633145c07p-53, 0x1.5555555555555p-53));
    const double t8 = FMA(b, FMA(b, -0.875, 0.5), t7);
    const double t9 = 0.5 * alpha;
    const double t10 = t9 + -0x1.e652ff776be20p-4;
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

/* J_r = C_r(alpha) cos(psi), alpha = (theta_2 - theta_1)/2, psi = 3 pi/2 - (theta_1 + theta_2)/2, both ends, best,
 * fused: proved within 8.56e-16 relative (certificates/radial_weight.json) */
INLINE double radial_weight_best_fused(double theta_1, double theta_2)
{
    const double t1 = radial_weight_amplitude_best_fused(SMALLER((theta_2 - theta_1) * 0.5, 0x1.921fb54442d18p+0));
    double t2, t3, t4; cos_psi_fused(theta_1, theta_2, &t2, &t3, &t4);
    const double t5 = t2 * 0.5;
    const double t6 = t5 * t5;
    const double t7 = (t6 * -0x1.761b41316381ap-75 + 0x1.71b8ef6dcf572p-66) * t6 + -0x1.2f49b46814157p-57;
    const double t8 = ((t7 * t6 + 0x1.952c77030ad4ap-49) * t6 + -0x1.ae7f3e733b81fp-41) * t6;
    const double t9 = ((t8 + 0x1.6124613a86d09p-33) * t6 + -0x1.ae64567f544e4p-26) * t6 + 0x1.71de3a556c734p-19;
    const double t10 = ((t9 * t6 + -0x1.a01a01a01a01ap-13) * t6 + 0x1.1111111111111p-7) * t6;
    const double t11 = t1 * ((t10 + -0x1.5555555555555p-3) * t6 + 1.0) * t4;
    return t11 * (t2 + (t3 + t2 * share_fused(theta_1, theta_2)));
}

/* J_r = C_r(alpha) cos(psi), alpha = (theta_2 - theta_1)/2, psi = 3 pi/2 - (theta_1 + theta_2)/2, both ends,
 * 1e-10, fused: proved within 6.47e-11 relative (certificates/radial_weight.json) */
INLINE double radial_weight_1e_10_fused(double theta_1, double theta_2)
{
    const double t1 = radial_weight_amplitude_1e_10_fused(SMALLER((theta_2 - theta_1) * 0.5, 0x1.921fb54442d18p+0));
    double t2, t3, t4; cos_psi_fused(theta_1, theta_2, &t2, &t3, &t4);
    const double t5 = t2 * 0.5;
    const double t6 = t5 * t5;
    const double t7 = (t6 * -0x1.ae7f3e733b81fp-41 + 0x1.6124613a86d09p-33) * t6 + -0x1.ae64567f544e4p-26;
    const double t8 = ((t7 * t6 + 0x1.71de3a556c734p-19) * t6 + -0x1.a01a01a01a01ap-13) * t6;
    const double t9 = t1 * (((t8 + 0x1.1111111111111p-7) * t6 + -0x1.5555555555555p-3) * t6 + 1.0);
    return t9 * t4 * (t2 + (t3 + t2 * share_fused(theta_1, theta_2)));
}

/* J_r = C_r(alpha) cos(psi), alpha = (theta_2 - theta_1)/2, psi = 3 pi/2 - (theta_1 + theta_2)/2, both ends,
 * float32, fused: proved within 0.502 ulp of float32 (certificates/radial_weight.json) */
INLINE double radial_weight_float32_fused(double theta_1, double theta_2)
{
    const double t1 = radial_weight_amplitude_1e_10_fused(SMALLER((theta_2 - theta_1) * 0.5, 0x1.921fb54442d18p+0));
    double t2, t3, t4; cos_psi_fused(theta_1, theta_2, &t2, &t3, &t4);
    const double t5 = t2 * 0.5;
    const double t6 = t5 * t5;
    const double t7 = (t6 * -0x1.ae7f3e733b81fp-41 + 0x1.6124613a86d09p-33) * t6 + -0x1.ae64567f544e4p-26;
    const double t8 = ((t7 * t6 + 0x1.71de3a556c734p-19) * t6 + -0x1.a01a01a01a01ap-13) * t6;
    const double t9 = t1 * (((t8 + 0x1.1111111111111p-7) * t6 + -0x1.5555555555555p-3) * t6 + 1.0);
    return t9 * t4 * (t2 + (t3 + t2 * share_fused(theta_1, theta_2)));
}

/* J_r = C_r(alpha) cos(psi), alpha = (theta_2 - theta_1)/2, psi = 3 pi/2 - (theta_1 + theta_2)/2, both ends, 1e-6,
 * fused: proved within 3.99e-07 relative (certificates/radial_weight.json) */
INLINE double radial_weight_1e_6_fused(double theta_1, double theta_2)
{
    const double t1 = radial_weight_amplitude_1e_6_fused(SMALLER((theta_2 - theta_1) * 0.5, 0x1.921fb54442d18p+0));
    double t2, t3, t4; cos_psi_fused(theta_1, theta_2, &t2, &t3, &t4);
    const double t5 = t2 * 0.5;
    const double t6 = t5 * t5;
    const double t7 = (t6 * -0x1.ae64567f544e4p-26 + 0x1.71de3a556c734p-19) * t6 + -0x1.a01a01a01a01ap-13;
    const double t8 = ((t7 * t6 + 0x1.1111111111111p-7) * t6 + -0x1.5555555555555p-3) * t6 + 1.0;
    return t1 * t8 * t4 * (t2 + (t3 + t2 * share_fused(theta_1, theta_2)));
}

/* J_theta = C_theta(alpha) sin(psi), alpha = (theta_2 - theta_1)/2, psi = 3 pi/2 - (theta_1 + theta_2)/2, both
 * ends, best, fused: proved within 8.47e-16 relative (certificates/weight_moment.json) */
INLINE double weight_moment_best_fused(double theta_1, double theta_2)
{
    const double t1 = weight_moment_amplitude_best_fused(SMALLER((theta_2 - theta_1) * 0.5, 0x1.921fb54442d18p+0));
    double t2, t3, t4; sin_psi_fused(theta_1, theta_2, &t2, &t3, &t4);
    const double t5 = t2 * 0.5;
    const double t6 = t5 * t5;
    const double t7 = (t6 * -0x1.761b41316381ap-75 + 0x1.71b8ef6dcf572p-66) * t6 + -0x1.2f49b46814157p-57;
    const double t8 = ((t7 * t6 + 0x1.952c77030ad4ap-49) * t6 + -0x1.ae7f3e733b81fp-41) * t6;
    const double t9 = ((t8 + 0x1.6124613a86d09p-33) * t6 + -0x1.ae64567f544e4p-26) * t6 + 0x1.71de3a556c734p-19;
    const double t10 = ((t9 * t6 + -0x1.a01a01a01a01ap-13) * t6 + 0x1.1111111111111p-7) * t6;
    const double t11 = t1 * ((t10 + -0x1.5555555555555p-3) * t6 + 1.0) * t4;
    return t11 * (t2 + (t3 + t2 * share_fused(theta_1, theta_2)));
}

/* J_theta = C_theta(alpha) sin(psi), alpha = (theta_2 - theta_1)/2, psi = 3 pi/2 - (theta_1 + theta_2)/2, both
 * ends, 1e-10, fused: proved within 8.17e-12 relative (certificates/weight_moment.json) */
INLINE double weight_moment_1e_10_fused(double theta_1, double theta_2)
{
    const double t1 = weight_moment_amplitude_1e_10_fused(SMALLER((theta_2 - theta_1) * 0.5, 0x1.921fb54442d18p+0));
    double t2, t3, t4; sin_psi_fused(theta_1, theta_2, &t2, &t3, &t4);
    const double t5 = t2 * 0.5;
    const double t6 = t5 * t5;
    const double t7 = (t6 * -0x1.ae7f3e733b81fp-41 + 0x1.6124613a86d09p-33) * t6 + -0x1.ae64567f544e4p-26;
    const double t8 = ((t7 * t6 + 0x1.71de3a556c734p-19) * t6 + -0x1.a01a01a01a01ap-13) * t6;
    const double t9 = t1 * (((t8 + 0x1.1111111111111p-7) * t6 + -0x1.5555555555555p-3) * t6 + 1.0);
    return t9 * t4 * (t2 + (t3 + t2 * share_fused(theta_1, theta_2)));
}

/* J_theta = C_theta(alpha) sin(psi), alpha = (theta_2 - theta_1)/2, psi = 3 pi/2 - (theta_1 + theta_2)/2, both
 * ends, float32, fused: proved within 0.501 ulp of float32 (certificates/weight_moment.json) */
INLINE double weight_moment_float32_fused(double theta_1, double theta_2)
{
    const double t1 = weight_moment_amplitude_1e_10_fused(SMALLER((theta_2 - theta_1) * 0.5, 0x1.921fb54442d18p+0));
    double t2, t3, t4; sin_psi_fused(theta_1, theta_2, &t2, &t3, &t4);
    const double t5 = t2 * 0.5;
    const double t6 = t5 * t5;
    const double t7 = (t6 * -0x1.ae7f3e733b81fp-41 + 0x1.6124613a86d09p-33) * t6 + -0x1.ae64567f544e4p-26;
    const double t8 = ((t7 * t6 + 0x1.71de3a556c734p-19) * t6 + -0x1.a01a01a01a01ap-13) * t6;
    const double t9 = t1 * (((t8 + 0x1.1111111111111p-7) * t6 + -0x1.5555555555555p-3) * t6 + 1.0);
    return t9 * t4 * (t2 + (t3 + t2 * share_fused(theta_1, theta_2)));
}

/* J_theta = C_theta(alpha) sin(psi), alpha = (theta_2 - theta_1)/2, psi = 3 pi/2 - (theta_1 + theta_2)/2, both
 * ends, 1e-6, fused: proved within 4.96e-07 relative (certificates/weight_moment.json) */
INLINE double weight_moment_1e_6_fused(double theta_1, double theta_2)
{
    const double t1 = weight_moment_amplitude_1e_6_fused(SMALLER((theta_2 - theta_1) * 0.5, 0x1.921fb54442d18p+0));
    double t2, t3, t4; sin_psi_fused(theta_1, theta_2, &t2, &t3, &t4);
    const double t5 = t2 * 0.5;
    const double t6 = t5 * t5;
    const double t7 = (t6 * -0x1.ae64567f544e4p-26 + 0x1.71de3a556c734p-19) * t6 + -0x1.a01a01a01a01ap-13;
    const double t8 = ((t7 * t6 + 0x1.1111111111111p-7) * t6 + -0x1.5555555555555p-3) * t6 + 1.0;
    return t1 * t8 * t4 * (t2 + (t3 + t2 * share_fused(theta_1, theta_2)));
}

/* mu_eq = J_theta/J_r = (C_theta/C_r) tan(psi); negative where gravity turns the mass clockwise, both ends, best,
 * fused: proved within 1.59e-15 relative (certificates/limit_friction.json) */
INLINE double limit_friction_best_fused(double theta_1, double theta_2)
{
    const double t1 = weight_moment_per_radial_weight_best_fused(SMALLER((theta_2 - theta_1) * 0.5,
        0x1.921fb54442d18p+0));
    double t2, t3, t4; sin_psi_fused(theta_1, theta_2, &t2, &t3, &t4);
    const double t5 = t2 * 0.5;
    const double t6 = t5 * t5;
    const double t7 = (t6 * -0x1.761b41316381ap-75 + 0x1.71b8ef6dcf572p-66) * t6 + -0x1.2f49b46814157p-57;
    const double t8 = ((t7 * t6 + 0x1.952c77030ad4ap-49) * t6 + -0x1.ae7f3e733b81fp-41) * t6;
    const double t9 = ((t8 + 0x1.6124613a86d09p-33) * t6 + -0x1.ae64567f544e4p-26) * t6 + 0x1.71de3a556c734p-19;
    const double t10 = ((t9 * t6 + -0x1.a01a01a01a01ap-13) * t6 + 0x1.1111111111111p-7) * t6;
    double t11, t12, t13; cos_psi_fused(theta_1, theta_2, &t11, &t12, &t13);
    const double t14 = t11 * 0.5;
    const double t15 = t14 * t14;
    const double t16 = (t15 * -0x1.761b41316381ap-75 + 0x1.71b8ef6dcf572p-66) * t15 + -0x1.2f49b46814157p-57;
    const double t17 = ((t16 * t15 + 0x1.952c77030ad4ap-49) * t15 + -0x1.ae7f3e733b81fp-41) * t15;
    const double t18 = ((t17 + 0x1.6124613a86d09p-33) * t15 + -0x1.ae64567f544e4p-26) * t15 + 0x1.71de3a556c734p-19;
    const double t19 = ((t18 * t15 + -0x1.a01a01a01a01ap-13) * t15 + 0x1.1111111111111p-7) * t15;
    const double t20 = t1 * ((t10 + -0x1.5555555555555p-3) * t6 + 1.0);
    const double t21 = (t2 + t3) * (t20 / ((t19 + -0x1.5555555555555p-3) * t15 + 1.0)) * (t4 * t13 * 4.0);
    return t21 / (t11 + t12);
}
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

INLINE void cos_psi_plain(double theta_1, double theta_2, double *to_0, double *to_1, double *to_2)
{
    const double t1 = theta_1 + theta_2;
    const double t2 = NEAREST(t1 * 0x1.45f306dc9c883p-3);
    const double t3 = t2 * 2.0;
    const double t4 = t3 * -0x1.921fb54440000p+1;
    const double t5 = t3 * -0x1.68c234c4c0000p-38;
    const double t6 = t3 * -0x1.98a2e03700000p-76;
    const double t7 = t3 * -0x1.cd129024e088ap-114;
    const double t8 = lost(theta_1, theta_2);
    const double t9 = t1 + t4;
    const double t10 = lost(t1, t4);
    const double t11 = t9 + t5;
    const double t12 = lost(t9, t5);
    const double t13 = t11 + t6;
    const double t14 = lost(t11, t6);
    const double t15 = t13 + t7;
    const double t16 = lost(t13, t7);
    const double t17 = t8 + t10;
    const double t18 = lost(t8, t10);
    const double t19 = t17 + t12;
    const double t20 = lost(t17, t12);
    const double t21 = t19 + t14;
    const double t22 = lost(t19, t14);
    const double t23 = t21 + t16;
    const double t24 = lost(t21, t16);
    const double t25 = t23 + t15;
    const double t26 = lost(t23, t15);
    const double t27 = t18 + t20;
    const double t28 = t27 + t22;
    const double t29 = t28 + t24;
    const double t30 = t29 + t26;
    const double t31 = t30 + t25;
    const double t32 = lost(t18, t20) + lost(t27, t22) + lost(t28, t24) + lost(t29, t26) + lost(t30, t25);
    const double t33 = LARGER(SMALLER(t31 + t32, 0x1.921fb54442d18p+1), -0x1.921fb54442d18p+1);
    const double t34 = t2 * 0.5;
    const double t35 = t34 - NEAREST(t34);
    const double t36 = t33 * 0.5;
    const double t37 = t36 * t36;
    const double t38 = (t37 * -0x1.bbd779334ef0bp-13 + -0x1.1566abc011567p-9) * t37 + -0x1.6c16c16c16c17p-6;
    *to_0 = t33;
    *to_1 = ((t38 * t37 + -0x1.5555555555555p-2) * t37 + 1.0) * lost(t31, t32);
    *to_2 = t35 * t35 * 4.0 - 0.5;
}

INLINE void sin_psi_plain(double theta_1, double theta_2, double *to_0, double *to_1, double *to_2)
{
    const double t1 = theta_1 + theta_2;
    const double t2 = NEAREST(t1 * 0x1.45f306dc9c883p-3 - 0.5);
    const double t3 = t2 * 2.0 + 1.0;
    const double t4 = t3 * -0x1.921fb54440000p+1;
    const double t5 = t3 * -0x1.68c234c4c0000p-38;
    const double t6 = t3 * -0x1.98a2e03700000p-76;
    const double t7 = t3 * -0x1.cd129024e088ap-114;
    const double t8 = lost(theta_1, theta_2);
    const double t9 = t1 + t4;
    const double t10 = lost(t1, t4);
    const double t11 = t9 + t5;
    const double t12 = lost(t9, t5);
    const double t13 = t11 + t6;
    const double t14 = lost(t11, t6);
    const double t15 = t13 + t7;
    const double t16 = lost(t13, t7);
    const double t17 = t8 + t10;
    const double t18 = lost(t8, t10);
    const double t19 = t17 + t12;
    const double t20 = lost(t17, t12);
    const double t21 = t19 + t14;
    const double t22 = lost(t19, t14);
    const double t23 = t21 + t16;
    const double t24 = lost(t21, t16);
    const double t25 = t23 + t15;
    const double t26 = lost(t23, t15);
    const double t27 = t18 + t20;
    const double t28 = t27 + t22;
    const double t29 = t28 + t24;
    const double t30 = t29 + t26;
    const double t31 = t30 + t25;
    const double t32 = lost(t18, t20) + lost(t27, t22) + lost(t28, t24) + lost(t29, t26) + lost(t30, t25);
    const double t33 = LARGER(SMALLER(t31 + t32, 0x1.921fb54442d18p+1), -0x1.921fb54442d18p+1);
    const double t34 = t2 * 0.5;
    const double t35 = t34 - NEAREST(t34);
    const double t36 = t33 * 0.5;
    const double t37 = t36 * t36;
    const double t38 = (t37 * -0x1.bbd779334ef0bp-13 + -0x1.1566abc011567p-9) * t37 + -0x1.6c16c16c16c17p-6;
    *to_0 = t33;
    *to_1 = ((t38 * t37 + -0x1.5555555555555p-2) * t37 + 1.0) * lost(t31, t32);
    *to_2 = t35 * t35 * -4.0 - -0.5;
}

INLINE double share_plain(double theta_1, double theta_2)
{
    const double t1 = theta_2 - theta_1;
    const double t2 = SMALLER(t1 * 0.5, 0x1.921fb54442d18p+0);
    const double t3 = t2 * t2;
    const double t4 = (t3 * -0x1.bbd779334ef0bp-13 + -0x1.1566abc011567p-9) * t3 + -0x1.6c16c16c16c17p-6;
    const double t5 = lost(theta_2, -theta_1) / LARGER(t1, 0x1.0000000000000p-1000);
    return ((t4 * t3 + -0x1.5555555555555p-2) * t3 + 1.0) * 3.0 * t5;
}

/* I_p* = (2*alpha - sin(alpha)*cos(alpha) - cos(alpha)**3*atanh(sin(alpha)))/3, 0 <= alpha <= pi/2, best, plain:
 * proved within 4.17 ulp (certificates/polar_moment.json) */
/* alpha < 1.08 */
INLINE double polar_moment_best_plain_near(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY14(alpha_2, -0x1.9999999999995p-2, 0x1.5f15f15f15910p-4, -0x1.5ac056afbcf5ep-7,
        0x1.d0042ceea2438p-11, -0x1.8d48bf9429066p-15, 0x1.7aeec3142f738p-19, 0x1.94a27b5610062p-24,
        0x1.4bf7029ebf7b0p-25, 0x1.7b048f66de39ep-26, -0x1.b48ed20c580cdp-27, 0x1.30673886a4693p-26,
        -0x1.a7aa6968db29cp-27, 0x1.bb88316c1ae71p-28, -0x1.0ce34647aa48fp-29, 0x1.4e32c0c040253p-32);
    return (alpha_2 * (p1 * alpha_2) + alpha_2) / 1.5 * alpha;
}
/* alpha >= 1.08, in b = pi/2 - alpha */
INLINE double polar_moment_best_plain_far(double alpha)
{
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p1 = POLY5(b_2, -0x1.213ce23146d4ep-7, 0x1.94ebfb96f2248p-4, -0x1.0ee089c62234bp-5,
        0x1.5570c6bf81994p-8, -0x1.057adab8c0352p-11, 0x1.1322fd18fd6adp-15);
    const double p2 = POLY5(b_2, 0x1.555555555535bp-2, -0x1.55555557cd14ep-3, 0x1.27d27720bb130p-5,
        -0x1.2834b296ce4d6p-8, 0x1.811b7ecc87ea4p-12, -0x1.ae976a0e5bdb3p-16);
    const double t1 = b * b_2 * (p2 * logarithm_plain(b) + p1) + -0x1.0548e0b5cd961p-7;
    return alpha + -0x1.0800000000000p-1 + t1;
}
INLINE double polar_moment_best_plain(double alpha)
{
    const double near = polar_moment_best_plain_near(alpha);
    const double far = polar_moment_best_plain_far(alpha);
    return SELECT(alpha < 0x1.147ae147ae148p+0, near, far);
}
#define polar_moment_best_plain_KIND pieces
#define polar_moment_best_plain_BELOW_double UINT64_C(0x3ff147ae147ae147)
#define polar_moment_best_plain_BELOW_float UINT32_C(0x3f8a3d70)

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
 * plain: proved within 40.8 ulp (certificates/polar_moment.json), rounded correctly to float32 */
INLINE double polar_moment_float32_plain(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double t1 = b * (alpha + 0x1.921fb54442d18p+0);
    const double p1 = POLY13(t1, -0x1.eda09f3e90404p-3, -0x1.fb18820faf930p+8, -0x1.acc2458341e71p+17,
        -0x1.b89784a124872p+24, -0x1.4aec89218ffcbp+30, -0x1.9493ab246c44dp+34, -0x1.ad1ad41277191p+37,
        -0x1.97371cc7271afp+39, -0x1.58ff746b8797cp+40, -0x1.f26135829abfdp+39, -0x1.11120afbaa57dp+38,
        -0x1.84d2a15011170p+34, -0x1.dea97414601d5p+30, -0x1.0fda1be36df3bp+26);
    const double p2 = POLY13(t1, 1.0, 0x1.06f5c44de3519p+11, 0x1.bc8376cd15a77p+19, 0x1.c84d5ff85cf90p+26,
        0x1.55d3c0d1bcfb3p+32, 0x1.9f64de9289387p+36, 0x1.b2bd5e7e4c44bp+39, 0x1.9098ea56ea0bap+41,
        0x1.3d1a85ebfa9e6p+42, 0x1.7f09711bb0b5fp+41, 0x1.9b97574bd55b0p+38, -0x1.e6cb677ad5a72p+35,
        0x1.62e410c2d8b7bp+31, -0x1.8b209552ed2a2p+25);
    return alpha_2 * alpha * (p1 / p2 * alpha_2 + -0x1.051eb851eb852p-54 + 1.0) * 0x1.5555555555555p-1;
}
#define polar_moment_float32_plain_KIND whole

/* Theta* = alpha/2 - sin(2*alpha)/6 - sin(4*alpha)/24, 0 <= alpha <= pi/2, best, plain: proved within 3.92 ulp
 * (certificates/moment_of_inertia.json) */
/* alpha < 0.98 */
INLINE double moment_of_inertia_best_plain_near(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY9(alpha_2, -0x1.3333333333331p-1, 0x1.ad1ad1ad1ab64p-3, -0x1.74c1f6ca0fef0p-5,
        0x1.af3b88a89e917p-8, -0x1.61508579e8d6ap-11, 0x1.ae8ca3d9cd5e3p-15, -0x1.952ddb2f5ccf0p-19,
        0x1.2f26c194f3d0dp-23, -0x1.6e41645a185e3p-28, 0x1.4499f95e1b7eep-33);
    return (alpha_2 * (p1 * alpha_2) + alpha_2) / 1.5 * alpha;
}
/* alpha >= 0.98, in b = pi/2 - alpha */
INLINE double moment_of_inertia_best_plain_far(double alpha)
{
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p1 = POLY9(b_2, -0x1.555555555554fp-3, -0x1.c71c71c71c9d1p-3, 0x1.3e93e93e974c4p-2,
        -0x1.0cbb766293955p-3, 0x1.e94dfd574ccc8p-6, -0x1.1e5e1c82f59e1p-8, 0x1.d6a153b5d88acp-12,
        -0x1.1f07fbda0bf19p-15, 0x1.0f3d73ce0e4d0p-19, -0x1.989edb1ab88c8p-24);
    return 0.5 * alpha + -0.125 + (b * p1 + 0x1.fffffffffffffp-4);
}
INLINE double moment_of_inertia_best_plain(double alpha)
{
    const double near = moment_of_inertia_best_plain_near(alpha);
    const double far = moment_of_inertia_best_plain_far(alpha);
    return SELECT(alpha < 0x1.f5c28f5c28f5cp-1, near, far);
}
#define moment_of_inertia_best_plain_KIND pieces
#define moment_of_inertia_best_plain_BELOW_double UINT64_C(0x3fef5c28f5c28f5b)
#define moment_of_inertia_best_plain_BELOW_float UINT32_C(0x3f7ae147)

/* Theta* = alpha/2 - sin(2*alpha)/6 - sin(4*alpha)/24, 0 <= alpha <= pi/2, 1e-10, plain: proved within 3.56e-12
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
#define moment_of_inertia_1e_6_plain_KIND whole

/* Theta* = alpha/2 - sin(2*alpha)/6 - sin(4*alpha)/24, 0 <= alpha <= pi/2, float32, plain: proved within 15 ulp
 * (certificates/moment_of_inertia.json), rounded correctly to float32 */
INLINE double moment_of_inertia_float32_plain(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY11(alpha_2, -0x1.051eb851eb852p-54, -0x1.99999999996c8p-2, 0x1.1e11e11e0a487p-3,
        -0x1.f1029e60fb14bp-6, 0x1.1f7d05ab48cbcp-8, -0x1.d71603ca7c39cp-12, 0x1.1f084a41ae704p-15,
        -0x1.0e1d1e6c6b2cep-19, 0x1.942dc15a29305p-24, -0x1.ea28f9307f31ap-29, 0x1.da8a01ce2be69p-34,
        -0x1.2d46b60ffc0b0p-39);
    return alpha_2 * alpha * (p1 + 0x1.5555555555555p-1);
}
#define moment_of_inertia_float32_plain_KIND whole

/* C_r = sin(alpha) - cos(alpha)**2*atanh(sin(alpha)), 0 <= alpha <= pi/2, best, plain: proved within 4.05 ulp
 * (certificates/radial_weight_amplitude.json) */
/* alpha < 1.16 */
INLINE double radial_weight_amplitude_best_plain_near(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY16(alpha_2, -0x1.3333333333383p-2, 0x1.c09c09c0b8cbcp-6, -0x1.0cbb767f40d18p-9,
        -0x1.ebc0b36b0755dp-16, -0x1.8bcd43bc47722p-16, -0x1.810221195af71p-18, -0x1.bdcbdbf69a94dp-20,
        -0x1.0efc5badda29fp-22, -0x1.537b583a7cf3cp-21, 0x1.c48c1d72a57b9p-21, -0x1.41d77a9ad2eecp-20,
        0x1.3df82e6545294p-20, -0x1.d8f5fbd55b945p-21, 0x1.f561f3da58400p-22, -0x1.6c0d7c83eaea4p-23,
        0x1.43a87fdd03e21p-25, -0x1.11149d9c88803p-28);
    return (alpha_2 * (p1 * alpha_2) + alpha_2) / 1.5 * alpha;
}
/* alpha >= 1.16, in b = pi/2 - alpha */
INLINE double radial_weight_amplitude_best_plain_far(double alpha)
{
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p1 = POLY5(b_2, 0x1.d1bd0105cb2e0p-4, 0x1.2c981ff6a61a1p-1, -0x1.5fec3504ee171p-4,
        0x1.c0fb866c21493p-8, -0x1.5ca68c3cf25f9p-12, 0x1.37f1000d20ec1p-17);
    const double p2 = POLY5(b_2, 0x1.000000000018dp+0, -0x1.55555553ea141p-2, 0x1.6c16c7361cfd2p-5,
        -0x1.a010b7f783d5ep-9, 0x1.2adbbfd3a71d1p-13, -0x1.d8e0e3d8e3d1ep-19);
    const double t1 = b * (b * -2.0 + 0.5) + (b_2 * (p2 * logarithm_plain(2.0 * b) + p1) + 0x1.1e04abbbd2e80p-5);
    return 0.5 * alpha + 0x1.7000000000000p-3 + t1;
}
INLINE double radial_weight_amplitude_best_plain(double alpha)
{
    const double near = radial_weight_amplitude_best_plain_near(alpha);
    const double far = radial_weight_amplitude_best_plain_far(alpha);
    return SELECT(alpha < 0x1.28f5c28f5c28fp+0, near, far);
}
#define radial_weight_amplitude_best_plain_KIND pieces
#define radial_weight_amplitude_best_plain_BELOW_double UINT64_C(0x3ff28f5c28f5c28e)
#define radial_weight_amplitude_best_plain_BELOW_float UINT32_C(0x3f947ae1)

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

/* C_r = sin(alpha) - cos(alpha)**2*atanh(sin(alpha)), 0 <= alpha <= pi/2, float32, plain: proved within 71.1 ulp
 * (certificates/radial_weight_amplitude.json), rounded correctly to float32 */
INLINE double radial_weight_amplitude_float32_plain(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double t1 = b * (alpha + 0x1.921fb54442d18p+0);
    const double p1 = POLY20(t1, -0x1.fcc9f54cce51fp-3, -0x1.24c3bc7db3f90p+18, -0x1.8b95658e50fe7p+35,
        -0x1.f635f6163f6b0p+50, -0x1.7ad31e8998acbp+64, -0x1.89b7d36da870ep+76, -0x1.38d53348af22cp+87,
        -0x1.9aea5de6b3401p+96, -0x1.da1efb4ce0161p+104, -0x1.f853b23fb5f71p+111, -0x1.00f930750414ap+118,
        -0x1.027a37dc5256ep+123, -0x1.0629e1fa4c058p+127, -0x1.0f68b6a6bf1b6p+130, -0x1.1f0f74881d055p+132,
        -0x1.31ba3d8b7b082p+133, -0x1.3b9b7132332abp+133, -0x1.23713f613483ep+132, -0x1.95d005b405c3fp+129,
        -0x1.2029435426073p+125, -0x1.0d996f1762d3fp+120);
    const double p2 = POLY20(t1, 1.0, 0x1.269cbff6ba6dap+20, 0x1.8e1485ae88f9ap+37, 0x1.f9614ee4cab88p+52,
        0x1.7d3702af0e259p+66, 0x1.8c336fef56e5cp+78, 0x1.3acd91fc2dbc7p+89, 0x1.9d7eda824fed5p+98,
        0x1.dd13e333b1d4ap+106, 0x1.fb6ce9266286bp+113, 0x1.0280557cab165p+120, 0x1.03e74cef09d9cp+125,
        0x1.075c98db4c490p+129, 0x1.101042ad622d7p+132, 0x1.1e4a4988dca0fp+134, 0x1.2d14b959fe94ap+135,
        0x1.2c93e14a580f0p+135, 0x1.f5cb8e20a4305p+133, 0x1.c474dcf704384p+130, -0x1.c7de34571c909p+126,
        0x1.f534fe5a2ef06p+120);
    return alpha_2 * alpha * (p1 / p2 * alpha_2 + -0x1.051eb851eb852p-54 + 1.0) * 0x1.5555555555555p-1;
}
#define radial_weight_amplitude_float32_plain_KIND whole

/* C_theta = 2*sin(alpha)**3/3, 0 <= alpha <= pi/2, best, plain: proved within 3.82 ulp
 * (certificates/weight_moment_amplitude.json) */
/* alpha < 1.03 */
INLINE double weight_moment_amplitude_best_plain_near(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY8(alpha_2, -0x1.ffffffffffff8p-2, 0x1.bbbbbbbbbb725p-4, -0x1.bc466f117eb54p-7,
        0x1.22d671a5b693ep-10, -0x1.0c7835746195ep-14, 0x1.702fa8923cc3bp-19, -0x1.85ca453341102p-24,
        0x1.46dd87d4b9155p-29, -0x1.99632dc542be7p-35);
    return (alpha_2 * (p1 * alpha_2) + alpha_2) / 1.5 * alpha;
}
/* alpha >= 1.03, in b = pi/2 - alpha */
INLINE double weight_moment_amplitude_best_plain_far(double alpha)
{
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p1 = POLY7(b_2, -0x1.fffffffffffedp-3, 0x1.2aaaaaaaaa8bcp-1, -0x1.5b05b05af3bb4p-3,
        0x1.bc8bc8b27c25fp-6, -0x1.637e073d46fc3p-9, 0x1.83c9b28c7277ap-13, -0x1.329537d00329ap-17,
        0x1.62222bcf50f00p-22);
    const double t1 = b * (b * -0.75 + 0.5) + (b_2 * p1 + (b * -0x1.1a62633145c07p-53 + 0x1.5555555555555p-53));
    return 0.5 * alpha + -0x1.e652ff776be20p-4 + t1;
}
INLINE double weight_moment_amplitude_best_plain(double alpha)
{
    const double near = weight_moment_amplitude_best_plain_near(alpha);
    const double far = weight_moment_amplitude_best_plain_far(alpha);
    return SELECT(alpha < 0x1.07ae147ae147bp+0, near, far);
}
#define weight_moment_amplitude_best_plain_KIND pieces
#define weight_moment_amplitude_best_plain_BELOW_double UINT64_C(0x3ff07ae147ae147a)
#define weight_moment_amplitude_best_plain_BELOW_float UINT32_C(0x3f83d70a)

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
#define weight_moment_amplitude_1e_6_plain_KIND whole

/* C_theta = 2*sin(alpha)**3/3, 0 <= alpha <= pi/2, float32, plain: proved within 9.16 ulp
 * (certificates/weight_moment_amplitude.json), rounded correctly to float32 */
INLINE double weight_moment_amplitude_float32_plain(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY11(alpha_2, -0x1.051eb851eb852p-54, -0x1.5555555555554p-2, 0x1.27d27d27d2756p-4,
        -0x1.282ef4b665ffep-7, 0x1.83c8978eb865bp-11, -0x1.65f59e3640a49p-15, 0x1.eaeaa5aab60b2p-20,
        -0x1.03e57d9d383d5p-24, 0x1.b5b2194d4ba7cp-30, -0x1.2bcf358638b26p-35, 0x1.4fd86dd53b9c7p-41,
        -0x1.0dfa1fe98d53ep-47);
    return alpha_2 * alpha * (p1 + 0x1.5555555555555p-1);
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
#define resistance_factor_1e_10_plain_KIND whole

/* lambda = 2*alpha*(1 - cos(alpha)), 0 <= alpha <= pi/2, 1e-6, plain: proved within 1.71e-07 relative
 * (certificates/resistance_factor.json) */
INLINE double resistance_factor_1e_6_plain(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY3(alpha_2, 0x1.fffffa5b957a5p-1, -0x1.5553226831932p-4, 0x1.6b8afbde89795p-9,
        -0x1.899d6d596ca14p-15);
    return p1 * alpha_2 * alpha;
}
#define resistance_factor_1e_6_plain_KIND whole

/* lambda = 2*alpha*(1 - cos(alpha)), 0 <= alpha <= pi/2, float32, plain: proved within 4.52 ulp
 * (certificates/resistance_factor.json), rounded correctly to float32 */
INLINE double resistance_factor_float32_plain(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY7(alpha_2, -0x1.051eb851eb852p-54, -0x1.5555555555532p-4, 0x1.6c16c16c13f58p-9,
        -0x1.a01a019db037ep-15, 0x1.27e4fa7a17b18p-21, -0x1.1eed1f83c7382p-28, 0x1.936141e56bb6cp-36,
        -0x1.a0dfa5b9b370bp-44);
    return alpha_2 * alpha * (p1 + 1.0);
}
#define resistance_factor_float32_plain_KIND whole

/* A = polar_moment(alpha)/resistance_factor(alpha), finite at alpha = 0 where both vanish, 0 <= alpha <= pi/2,
 * best, plain: proved within 3.98 ulp (certificates/dynamic_coefficient.json) */
INLINE double dynamic_coefficient_best_plain(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY15(alpha_2, -0x1.99999999999a0p-2, 0x1.5f15f15f167b2p-4, -0x1.5ac056b0973c3p-7,
        0x1.d0042dbcdffa5p-11, -0x1.8d4933ba928afp-15, 0x1.7b19698e39021p-19, 0x1.7f10bf4b711dcp-24,
        0x1.c8525b3f1aa7ep-25, -0x1.1c993d5132144p-27, 0x1.23dbe3ccce4b8p-25, -0x1.2c3d26964272fp-25,
        0x1.07fc9de8a4877p-25, -0x1.3b7f323007ecfp-26, 0x1.053a2984b6846p-27, -0x1.05ad856991be7p-29,
        0x1.fc7efeb9c41e3p-33);
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p2 = POLY5(b_2, -0x1.213ce230dbeefp-7, 0x1.94ebfbb754504p-4, -0x1.0ee077691b943p-5,
        0x1.5578045f5fe35p-8, -0x1.0533239fbfa2ep-11, 0x1.0aedde3663fc9p-15);
    const double p3 = POLY5(b_2, 0x1.5555555556010p-2, -0x1.5555555202e7cp-3, 0x1.27d280bf8021ep-5,
        -0x1.282e5dae893d2p-8, 0x1.82dcf0100d8aep-12, -0x1.9d1d2c7ac5e77p-16);
    const double t1 = b * b_2 * (p3 * logarithm_plain(b) + p2) + 0x1.fab71f4a3269fp-7;
    const double t2 = alpha < 0x1.23d70a3d70a3dp+0;
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
 * 0 <= alpha <= pi/2, best, plain: proved within 3.25 ulp (certificates/weight_moment_per_inertia.json) */
INLINE double weight_moment_per_inertia_best_plain(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY8(alpha_2, -0x1.ffffffffffff8p-2, 0x1.bbbbbbbbbb725p-4, -0x1.bc466f117eb54p-7,
        0x1.22d671a5b693ep-10, -0x1.0c7835746195ep-14, 0x1.702fa8923cc3bp-19, -0x1.85ca453341102p-24,
        0x1.46dd87d4b9155p-29, -0x1.99632dc542be7p-35);
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p2 = POLY7(b_2, -0x1.fffffffffffdap-4, 0x1.2aaaaaaaaa8bcp-1, -0x1.5b05b05af3bb4p-3,
        0x1.bc8bc8b27c25fp-6, -0x1.637e073d46fc3p-9, 0x1.83c9b28c7277ap-13, -0x1.329537d00329ap-17,
        0x1.62222bcf50f00p-22);
    const double t1 = b * (b * -0.875 + 0.5) + (b_2 * p2 + (b * -0x1.1a62633145c07p-53 + 0x1.5555555555555p-53));
    const double t2 = 0.5 * alpha;
    const double t3 = alpha < 0x1.07ae147ae147bp+0;
    const double p3 = POLY10(alpha_2, -0x1.3333333333333p-1, 0x1.ad1ad1ad1acf5p-3, -0x1.74c1f6ca16b0dp-5,
        0x1.af3b88aa6c2b4p-8, -0x1.615085c0c02b4p-11, 0x1.ae8cb150e8a75p-15, -0x1.952f7e89a051cp-19,
        0x1.2f4777d3dfa8ep-23, -0x1.716bd39848b1fp-28, 0x1.70e6770e0b3aap-33, -0x1.0b9b37dbbf868p-38);
    const double p4 = POLY8(b_2, -0x1.555555555555dp-3, -0x1.c71c71c71c2cbp-3, 0x1.3e93e93e8caaap-2,
        -0x1.0cbb76609fd02p-3, 0x1.e94dfc8968252p-6, -0x1.1e5e0301d5402p-8, 0x1.d6998e219ebbfp-12,
        -0x1.1e5164529e7c6p-15, 0x1.f96e579402ac4p-20);
    const double t4 = SELECT(t3, 1.0 + p3 * alpha_2, t2 + -0x1.c000000000000p-5 + (b * p4 + 0x1.bffffffffffffp-5));
    return SELECT(t3, 1.0 + p1 * alpha_2, t2 + -0x1.e652ff776be20p-4 + t1) / t4;
}
#define weight_moment_per_inertia_best_plain_KIND whole

/* C_r/Theta* = radial_weight_amplitude(alpha)/moment_of_inertia(alpha), finite at alpha = 0 where both vanish, 0
 * <= alpha <= pi/2, best, plain: proved within 3.68 ulp (certificates/radial_weight_per_inertia.json) */
INLINE double radial_weight_per_inertia_best_plain(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY16(alpha_2, -0x1.333333333333cp-2, 0x1.c09c09c09f946p-6, -0x1.0cbb76660cc70p-9,
        -0x1.ebc1806d47c3ep-16, -0x1.8bc5790dff6e4p-16, -0x1.81c8a638bd0cbp-18, -0x1.b01e41cc999d3p-20,
        -0x1.bc216b0bfd2fep-22, -0x1.14a99db0c048cp-22, 0x1.a3cf250e83400p-23, -0x1.86118d5d57200p-22,
        0x1.9a909763ecf3bp-22, -0x1.540d1d354489fp-22, 0x1.8c50fa9a056b8p-23, -0x1.3f4df89ed2466p-24,
        0x1.3aa9b361a458fp-26, -0x1.2b536e83664f5p-29);
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p2 = POLY5(b_2, -0x1.7217f7d1ae2b5p-7, 0x1.2c981ff605456p-1, -0x1.5fec37466d3d8p-4,
        0x1.c0f97cefd9809p-8, -0x1.5c629576dda1ep-12, 0x1.69d163753cfb6p-17);
    const double p3 = POLY5(b_2, 0x1.0000000000151p+0, -0x1.555555546d298p-2, 0x1.6c16c422fd14bp-5,
        -0x1.a017058253bf2p-9, 0x1.285e13327bf2cp-13, -0x1.2f2674152353dp-18);
    const double t1 = b * (b * -1.875 + 0.5) + (b_2 * (p3 * logarithm_plain(2.0 * b) + p2) + 0x1.5e04abbbd2e80p-5);
    const double t2 = 0.5 * alpha;
    const double t3 = alpha < 0x1.1c28f5c28f5c3p+0;
    const double p4 = POLY10(alpha_2, -0x1.3333333333333p-1, 0x1.ad1ad1ad1acf4p-3, -0x1.74c1f6ca16ad7p-5,
        0x1.af3b88aa6beb1p-8, -0x1.615085c0d2b9fp-11, 0x1.ae8cb15975580p-15, -0x1.952f8019da705p-19,
        0x1.2f479f83cb2a1p-23, -0x1.71704c97ba462p-28, 0x1.712b7f47bc98fp-33, -0x1.0d567fd8486dep-38);
    const double p5 = POLY8(b_2, -0x1.555555555555cp-3, -0x1.c71c71c71c372p-3, 0x1.3e93e93e8dae1p-2,
        -0x1.0cbb7660cde68p-3, 0x1.e94dfc9b43c2dp-6, -0x1.1e5e050e2d7b2p-8, 0x1.d69a1f44ba292p-12,
        -0x1.1e5cc6e589d22p-15, 0x1.faff5e49e839dp-20);
    const double t4 = SELECT(t3, 1.0 + p4 * alpha_2, t2 + -0x1.c000000000000p-5 + (b * p5 + 0x1.bffffffffffffp-5));
    return SELECT(t3, 1.0 + p1 * alpha_2, t2 + 0x1.6000000000000p-3 + t1) / t4;
}
#define radial_weight_per_inertia_best_plain_KIND whole

/* I_p* /Theta* = polar_moment(alpha)/moment_of_inertia(alpha), finite at alpha = 0 where both vanish, 0 <= alpha
 * <= pi/2, best, plain: proved within 3.2 ulp (certificates/polar_moment_per_inertia.json) */
INLINE double polar_moment_per_inertia_best_plain(double alpha)
{
    const double alpha_2 = alpha * alpha;
    const double p1 = POLY13(alpha_2, -0x1.99999999999a1p-2, 0x1.5f15f15f16867p-4, -0x1.5ac056b098c3ep-7,
        0x1.d0042db5aaf81p-11, -0x1.8d492a8f799c7p-15, 0x1.7b140904c908bp-19, 0x1.82e428a71e1d0p-24,
        0x1.ab3e88a49fd1dp-25, 0x1.874cebeb20ce7p-31, 0x1.2209d73b424dfp-26, -0x1.8d10189b6754cp-27,
        0x1.0d68c0b762145p-27, -0x1.7898ba0293282p-29, 0x1.264b7838724abp-31);
    const double b = 0x1.921fb54442d18p+0 - alpha;
    const double b_2 = b * b;
    const double p2 = POLY5(b_2, -0x1.213ce22f8ace3p-7, 0x1.94ebfbdbd73afp-4, -0x1.0ee07496f41fcp-5,
        0x1.55751bc3c375dp-8, -0x1.05761dc378033p-11, 0x1.10577530f2d3dp-15);
    const double p3 = POLY5(b_2, 0x1.5555555558d28p-2, -0x1.5555554a056aep-3, 0x1.27d28418e33f8p-5,
        -0x1.282fbd7742ef9p-8, 0x1.81e84c0a68db4p-12, -0x1.aa0551f4078d8p-16);
    const double t1 = alpha + -0.5625 + (b * b_2 * (p3 * logarithm_plain(b) + p2) + 0x1.3eadc7d28c9a8p-5);
    const double t2 = alpha < 0x1.0a3d70a3d70a4p+0;
    const double p4 = POLY10(alpha_2, -0x1.3333333333333p-1, 0x1.ad1ad1ad1acf6p-3, -0x1.74c1f6ca16b7dp-5,
        0x1.af3b88aa6e88cp-8, -0x1.615085c12b0aap-11, 0x1.ae8cb16716e95p-15, -0x1.952f816363ee5p-19,
        0x1.2f47b296c4e1fp-23, -0x1.7171988899170p-28, 0x1.7137440b96e6dp-33, -0x1.0d7e731b16450p-38);
    const double p5 = POLY8(b_2, -0x1.555555555555cp-3, -0x1.c71c71c71c374p-3, 0x1.3e93e93e8db37p-2,
        -0x1.0cbb7660ceadep-3, 0x1.e94dfc9b0a6adp-6, -0x1.1e5e04e3dd133p-8, 0x1.d69a035b8852bp-12,
        -0x1.1e58f354d2ab8p-15, 0x1.fa3bac2f463d3p-20);
    const double t3 = 0.5 * alpha + -0x1.c000000000000p-5 + (b * p5 + 0x1.bffffffffffffp-5);
    return SELECT(t2, 1.0 + p1 * alpha_2, t1) / SELECT(t2, 1.0 + p4 * alpha_2, t3);
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
    const double p2 = POLY7(b_2, -0x1.ffffffffffffep-4, 0x1.2aaaaaaaaaa94p-1, -0x1.5b05b05b042afp-3,
        0x1.bc8bc8bb3a27ap-6, -0x1.637e09bf1814ap-9, 0x1.83ca7ec09ab67p-13, -0x1.32b73da32d767p-17,
        0x1.66c6f12e40144p-22);
    const double t1 = b * (b * -0.875 + 0.5) + (b_2 * p2 + (b * -0x1.1a62633145c07p-53 + 0x1.5555555555555p-53));
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
    const double t5 = SELECT(t3, 1.0 + p1 * alpha_2, t2 + -0x1.e652ff776be20p-4 + t1);
    return t5 / SELECT(t3, 1.0 + p3 * alpha_2, t2 + 0x1.6000000000000p-3 + t4);
}
#define weight_moment_per_radial_weight_best_plain_KIND whole

/* J_r = C_r(alpha) cos(psi), alpha = (theta_2 - theta_1)/2, psi = 3 pi/2 - (theta_1 + theta_2)/2, both ends, best,
 * plain: proved within 1.6e-15 relative (certificates/radial_weight.json) */
INLINE double radial_weight_best_plain(double theta_1, double theta_2)
{
    const double t1 = radial_weight_amplitude_best_plain(SMALLER((theta_2 - theta_1) * 0.5, 0x1.921fb54442d18p+0));
    double t2, t3, t4; cos_psi_plain(theta_1, theta_2, &t2, &t3, &t4);
    const double t5 = t2 * 0.5;
    const double t6 = t5 * t5;
    const double t7 = (t6 * -0x1.761b41316381ap-75 + 0x1.71b8ef6dcf572p-66) * t6 + -0x1.2f49b46814157p-57;
    const double t8 = ((t7 * t6 + 0x1.952c77030ad4ap-49) * t6 + -0x1.ae7f3e733b81fp-41) * t6;
    const double t9 = ((t8 + 0x1.6124613a86d09p-33) * t6 + -0x1.ae64567f544e4p-26) * t6 + 0x1.71de3a556c734p-19;
    const double t10 = ((t9 * t6 + -0x1.a01a01a01a01ap-13) * t6 + 0x1.1111111111111p-7) * t6;
    const double t11 = t1 * ((t10 + -0x1.5555555555555p-3) * t6 + 1.0) * t4;
    return t11 * (t2 + (t3 + t2 * share_plain(theta_1, theta_2)));
}

/* J_r = C_r(alpha) cos(psi), alpha = (theta_2 - theta_1)/2, psi = 3 pi/2 - (theta_1 + theta_2)/2, both ends,
 * 1e-10, plain: proved within 6.47e-11 relative (certificates/radial_weight.json) */
INLINE double radial_weight_1e_10_plain(double theta_1, double theta_2)
{
    const double t1 = radial_weight_amplitude_1e_10_plain(SMALLER((theta_2 - theta_1) * 0.5, 0x1.921fb54442d18p+0));
    double t2, t3, t4; cos_psi_plain(theta_1, theta_2, &t2, &t3, &t4);
    const double t5 = t2 * 0.5;
    const double t6 = t5 * t5;
    const double t7 = (t6 * -0x1.ae7f3e733b81fp-41 + 0x1.6124613a86d09p-33) * t6 + -0x1.ae64567f544e4p-26;
    const double t8 = ((t7 * t6 + 0x1.71de3a556c734p-19) * t6 + -0x1.a01a01a01a01ap-13) * t6;
    const double t9 = t1 * (((t8 + 0x1.1111111111111p-7) * t6 + -0x1.5555555555555p-3) * t6 + 1.0);
    return t9 * t4 * (t2 + (t3 + t2 * share_plain(theta_1, theta_2)));
}

/* J_r = C_r(alpha) cos(psi), alpha = (theta_2 - theta_1)/2, psi = 3 pi/2 - (theta_1 + theta_2)/2, both ends,
 * float32, plain: proved within 0.502 ulp of float32 (certificates/radial_weight.json) */
INLINE double radial_weight_float32_plain(double theta_1, double theta_2)
{
    const double t1 = radial_weight_amplitude_1e_10_plain(SMALLER((theta_2 - theta_1) * 0.5, 0x1.921fb54442d18p+0));
    double t2, t3, t4; cos_psi_plain(theta_1, theta_2, &t2, &t3, &t4);
    const double t5 = t2 * 0.5;
    const double t6 = t5 * t5;
    const double t7 = (t6 * -0x1.ae7f3e733b81fp-41 + 0x1.6124613a86d09p-33) * t6 + -0x1.ae64567f544e4p-26;
    const double t8 = ((t7 * t6 + 0x1.71de3a556c734p-19) * t6 + -0x1.a01a01a01a01ap-13) * t6;
    const double t9 = t1 * (((t8 + 0x1.1111111111111p-7) * t6 + -0x1.5555555555555p-3) * t6 + 1.0);
    return t9 * t4 * (t2 + (t3 + t2 * share_plain(theta_1, theta_2)));
}

/* J_r = C_r(alpha) cos(psi), alpha = (theta_2 - theta_1)/2, psi = 3 pi/2 - (theta_1 + theta_2)/2, both ends, 1e-6,
 * plain: proved within 3.99e-07 relative (certificates/radial_weight.json) */
INLINE double radial_weight_1e_6_plain(double theta_1, double theta_2)
{
    const double t1 = radial_weight_amplitude_1e_6_plain(SMALLER((theta_2 - theta_1) * 0.5, 0x1.921fb54442d18p+0));
    double t2, t3, t4; cos_psi_plain(theta_1, theta_2, &t2, &t3, &t4);
    const double t5 = t2 * 0.5;
    const double t6 = t5 * t5;
    const double t7 = (t6 * -0x1.ae64567f544e4p-26 + 0x1.71de3a556c734p-19) * t6 + -0x1.a01a01a01a01ap-13;
    const double t8 = ((t7 * t6 + 0x1.1111111111111p-7) * t6 + -0x1.5555555555555p-3) * t6 + 1.0;
    return t1 * t8 * t4 * (t2 + (t3 + t2 * share_plain(theta_1, theta_2)));
}

/* J_theta = C_theta(alpha) sin(psi), alpha = (theta_2 - theta_1)/2, psi = 3 pi/2 - (theta_1 + theta_2)/2, both
 * ends, best, plain: proved within 1.53e-15 relative (certificates/weight_moment.json) */
INLINE double weight_moment_best_plain(double theta_1, double theta_2)
{
    const double t1 = weight_moment_amplitude_best_plain(SMALLER((theta_2 - theta_1) * 0.5, 0x1.921fb54442d18p+0));
    double t2, t3, t4; sin_psi_plain(theta_1, theta_2, &t2, &t3, &t4);
    const double t5 = t2 * 0.5;
    const double t6 = t5 * t5;
    const double t7 = (t6 * -0x1.761b41316381ap-75 + 0x1.71b8ef6dcf572p-66) * t6 + -0x1.2f49b46814157p-57;
    const double t8 = ((t7 * t6 + 0x1.952c77030ad4ap-49) * t6 + -0x1.ae7f3e733b81fp-41) * t6;
    const double t9 = ((t8 + 0x1.6124613a86d09p-33) * t6 + -0x1.ae64567f544e4p-26) * t6 + 0x1.71de3a556c734p-19;
    const double t10 = ((t9 * t6 + -0x1.a01a01a01a01ap-13) * t6 + 0x1.1111111111111p-7) * t6;
    const double t11 = t1 * ((t10 + -0x1.5555555555555p-3) * t6 + 1.0) * t4;
    return t11 * (t2 + (t3 + t2 * share_plain(theta_1, theta_2)));
}

/* J_theta = C_theta(alpha) sin(psi), alpha = (theta_2 - theta_1)/2, psi = 3 pi/2 - (theta_1 + theta_2)/2, both
 * ends, 1e-10, plain: proved within 8.17e-12 relative (certificates/weight_moment.json) */
INLINE double weight_moment_1e_10_plain(double theta_1, double theta_2)
{
    const double t1 = weight_moment_amplitude_1e_10_plain(SMALLER((theta_2 - theta_1) * 0.5, 0x1.921fb54442d18p+0));
    double t2, t3, t4; sin_psi_plain(theta_1, theta_2, &t2, &t3, &t4);
    const double t5 = t2 * 0.5;
    const double t6 = t5 * t5;
    const double t7 = (t6 * -0x1.ae7f3e733b81fp-41 + 0x1.6124613a86d09p-33) * t6 + -0x1.ae64567f544e4p-26;
    const double t8 = ((t7 * t6 + 0x1.71de3a556c734p-19) * t6 + -0x1.a01a01a01a01ap-13) * t6;
    const double t9 = t1 * (((t8 + 0x1.1111111111111p-7) * t6 + -0x1.5555555555555p-3) * t6 + 1.0);
    return t9 * t4 * (t2 + (t3 + t2 * share_plain(theta_1, theta_2)));
}

/* J_theta = C_theta(alpha) sin(psi), alpha = (theta_2 - theta_1)/2, psi = 3 pi/2 - (theta_1 + theta_2)/2, both
 * ends, float32, plain: proved within 0.501 ulp of float32 (certificates/weight_moment.json) */
INLINE double weight_moment_float32_plain(double theta_1, double theta_2)
{
    const double t1 = weight_moment_amplitude_1e_10_plain(SMALLER((theta_2 - theta_1) * 0.5, 0x1.921fb54442d18p+0));
    double t2, t3, t4; sin_psi_plain(theta_1, theta_2, &t2, &t3, &t4);
    const double t5 = t2 * 0.5;
    const double t6 = t5 * t5;
    const double t7 = (t6 * -0x1.ae7f3e733b81fp-41 + 0x1.6124613a86d09p-33) * t6 + -0x1.ae64567f544e4p-26;
    const double t8 = ((t7 * t6 + 0x1.71de3a556c734p-19) * t6 + -0x1.a01a01a01a01ap-13) * t6;
    const double t9 = t1 * (((t8 + 0x1.1111111111111p-7) * t6 + -0x1.5555555555555p-3) * t6 + 1.0);
    return t9 * t4 * (t2 + (t3 + t2 * share_plain(theta_1, theta_2)));
}

/* J_theta = C_theta(alpha) sin(psi), alpha = (theta_2 - theta_1)/2, psi = 3 pi/2 - (theta_1 + theta_2)/2, both
 * ends, 1e-6, plain: proved within 4.96e-07 relative (certificates/weight_moment.json) */
INLINE double weight_moment_1e_6_plain(double theta_1, double theta_2)
{
    const double t1 = weight_moment_amplitude_1e_6_plain(SMALLER((theta_2 - theta_1) * 0.5, 0x1.921fb54442d18p+0));
    double t2, t3, t4; sin_psi_plain(theta_1, theta_2, &t2, &t3, &t4);
    const double t5 = t2 * 0.5;
    const double t6 = t5 * t5;
    const double t7 = (t6 * -0x1.ae64567f544e4p-26 + 0x1.71de3a556c734p-19) * t6 + -0x1.a01a01a01a01ap-13;
    const double t8 = ((t7 * t6 + 0x1.1111111111111p-7) * t6 + -0x1.5555555555555p-3) * t6 + 1.0;
    return t1 * t8 * t4 * (t2 + (t3 + t2 * share_plain(theta_1, theta_2)));
}

/* mu_eq = J_theta/J_r = (C_theta/C_r) tan(psi); negative where gravity turns the mass clockwise, both ends, best,
 * plain: proved within 2.27e-15 relative (certificates/limit_friction.json) */
INLINE double limit_friction_best_plain(double theta_1, double theta_2)
{
    const double t1 = weight_moment_per_radial_weight_best_plain(SMALLER((theta_2 - theta_1) * 0.5,
        0x1.921fb54442d18p+0));
    double t2, t3, t4; sin_psi_plain(theta_1, theta_2, &t2, &t3, &t4);
    const double t5 = t2 * 0.5;
    const double t6 = t5 * t5;
    const double t7 = (t6 * -0x1.761b41316381ap-75 + 0x1.71b8ef6dcf572p-66) * t6 + -0x1.2f49b46814157p-57;
    const double t8 = ((t7 * t6 + 0x1.952c77030ad4ap-49) * t6 + -0x1.ae7f3e733b81fp-41) * t6;
    const double t9 = ((t8 + 0x1.6124613a86d09p-33) * t6 + -0x1.ae64567f544e4p-26) * t6 + 0x1.71de3a556c734p-19;
    const double t10 = ((t9 * t6 + -0x1.a01a01a01a01ap-13) * t6 + 0x1.1111111111111p-7) * t6;
    double t11, t12, t13; cos_psi_plain(theta_1, theta_2, &t11, &t12, &t13);
    const double t14 = t11 * 0.5;
    const double t15 = t14 * t14;
    const double t16 = (t15 * -0x1.761b41316381ap-75 + 0x1.71b8ef6dcf572p-66) * t15 + -0x1.2f49b46814157p-57;
    const double t17 = ((t16 * t15 + 0x1.952c77030ad4ap-49) * t15 + -0x1.ae7f3e733b81fp-41) * t15;
    const double t18 = ((t17 + 0x1.6124613a86d09p-33) * t15 + -0x1.ae64567f544e4p-26) * t15 + 0x1.71de3a556c734p-19;
    const double t19 = ((t18 * t15 + -0x1.a01a01a01a01ap-13) * t15 + 0x1.1111111111111p-7) * t15;
    const double t20 = t1 * ((t10 + -0x1.5555555555555p-3) * t6 + 1.0);
    const double t21 = (t2 + t3) * (t20 / ((t19 + -0x1.5555555555555p-3) * t15 + 1.0)) * (t4 * t13 * 4.0);
    return t21 / (t11 + t12);
}

/* A block of numbers is looked at first, as integers: patterns of floats from 0 on are ordered as the floats are, and a
 * negative difference has its sign bit set. If all lie in [0, pi/2], as a rule, the program runs bare; if all lie below
 * its seam, its first piece alone. Others are set aside, and run as 0: of these the result is that of pi/2, or NaN. A
 * loop may run in place, or on an input that lies ahead of its output. */
#define INSIDE(x) ((x) >= 0 && (x) < HALF_PI)
#define PASS(T, PROGRAM) \
    INDEPENDENT \
    for (npy_intp i = start; i < stop; i++) out[i] = (T)PROGRAM((double)in[i]);
/* Kinds of programs: of two pieces, or whole. */
#define ABOVE_pieces(T, PROGRAM, pattern) PROGRAM##_BELOW_##T - pattern
#define ABOVE_whole(T, PROGRAM, pattern) 0
#define RUN_pieces(T, PROGRAM) if (NEGATIVE(above)) PASS(T, PROGRAM) else PASS(T, PROGRAM##_near)
#define RUN_whole(T, PROGRAM) PASS(T, PROGRAM)
#define LOOP(T, NAME, FORM, LEVEL) LOOP_OF(T, NAME##_##FORM##_KIND, NAME##_##FORM, NAME##_##LEVEL##_##T, LEVEL)
#define LOOP_OF(T, KIND, PROGRAM, LOOP_NAME, LEVEL) LOOP_KIND(T, KIND, PROGRAM, LOOP_NAME, LEVEL)
#define LOOP_KIND(T, KIND, PROGRAM, LOOP_NAME, LEVEL) \
    TARGET_##LEVEL static int LOOP_NAME(char *const *args, npy_intp count) \
    { \
        T *out = (T *)args[1], aside[BLOCK]; \
        int outside = 0; \
        for (npy_intp start = 0, stop; start < count; start = stop) { \
            const T *in = (const T *)args[0]; \
            PATTERN_##T beyond = 0, above = 0; \
            stop = count - start < BLOCK ? count : start + BLOCK; \
            for (npy_intp i = start; i < stop; i++) { \
                const PATTERN_##T pattern = pattern_##T(in[i]); \
                beyond |= (LAST_##T - pattern) | pattern; \
                above |= ABOVE_##KIND(T, PROGRAM, pattern); \
            } \
            if (NEGATIVE(beyond)) { \
                INDEPENDENT \
                for (npy_intp i = start; i < stop; i++) { \
                    const T x = in[i]; \
                    aside[i - start] = x; \
                    out[i] = INSIDE(x) ? x : 0; \
                } \
                in = out; \
            } \
            RUN_##KIND(T, PROGRAM) \
            if (NEGATIVE(beyond)) { \
                const T end = (T)PROGRAM(HALF_PI); \
                for (npy_intp i = start; i < stop; i++) { \
                    const double x = aside[i - start]; \
                    if (INSIDE(x)) continue; \
                    out[i] = x >= HALF_PI && x <= END_##T ? end : NAN; \
                    outside |= x < 0 || x > END_##T; /* not NaN, of which NumPy's functions are silent */ \
                } \
            } \
            (void)above; \
        } \
        return outside; \
    }

/* Of both ends of an arc: refused is what is none, or beyond LIMIT. */
#define UNLESS(condition) bits(SELECT(condition, 0.0, NAN))
#define LOOP_ENDS(T, NAME, FORM, LEVEL) LOOP_ENDS_OF(T, NAME##_##FORM, NAME##_##LEVEL##_##T, LEVEL)
#define LOOP_ENDS_OF(T, PROGRAM, LOOP_NAME, LEVEL) \
    TARGET_##LEVEL static int LOOP_NAME(char *const *args, npy_intp count) \
    { \
        const T *first = (const T *)args[0], *second = (const T *)args[1]; \
        T *out = (T *)args[2]; \
        uint64_t outside = 0; \
        double results[BLOCK]; \
        for (npy_intp start = 0, stop; start < count; start = stop) { \
            stop = count - start < BLOCK ? count : start + BLOCK; \
            INDEPENDENT \
            for (npy_intp i = start; i < stop; i++) results[i - start] = PROGRAM(first[i], second[i]); \
            INDEPENDENT \
            for (npy_intp i = start; i < stop; i++) { \
                const double one = first[i], two = second[i]; \
                const double alpha = 0.5 * two - 0.5 * one; \
                const uint64_t refused = UNLESS(one >= -LIMIT) | UNLESS(two <= LIMIT) | UNLESS(two >= one) | \
                                         UNLESS(alpha <= END_##T); \
                out[i] = (T)number(bits(results[i - start]) | refused); \
                outside |= refused & ~(UNLESS(one == one) | UNLESS(two == two)); \
            } \
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
    LOOP_ENDS(double, radial_weight_best, FORM, LEVEL) \
    LOOP_ENDS(double, radial_weight_1e_10, FORM, LEVEL) \
    LOOP_ENDS(double, radial_weight_1e_6, FORM, LEVEL) \
    LOOP_ENDS(double, weight_moment_best, FORM, LEVEL) \
    LOOP_ENDS(double, weight_moment_1e_10, FORM, LEVEL) \
    LOOP_ENDS(double, weight_moment_1e_6, FORM, LEVEL) \
    LOOP_ENDS(double, limit_friction_best, FORM, LEVEL) \
    LOOP(float, polar_moment_float32, FORM, LEVEL) \
    LOOP(float, moment_of_inertia_float32, FORM, LEVEL) \
    LOOP(float, radial_weight_amplitude_float32, FORM, LEVEL) \
    LOOP(float, weight_moment_amplitude_float32, FORM, LEVEL) \
    LOOP(float, resistance_factor_float32, FORM, LEVEL) \
    LOOP(float, dynamic_coefficient_best, FORM, LEVEL) \
    LOOP(float, weight_moment_per_inertia_best, FORM, LEVEL) \
    LOOP(float, radial_weight_per_inertia_best, FORM, LEVEL) \
    LOOP(float, polar_moment_per_inertia_best, FORM, LEVEL) \
    LOOP(float, weight_moment_per_radial_weight_best, FORM, LEVEL) \
    LOOP_ENDS(float, radial_weight_float32, FORM, LEVEL) \
    LOOP_ENDS(float, weight_moment_float32, FORM, LEVEL) \
    LOOP_ENDS(float, limit_friction_best, FORM, LEVEL)
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

typedef int (*Loop)(char *const *, npy_intp);

/* NumPy's inner loop around one of ours: strided operands go through a block. Of the exceptions only `invalid` is
 * meant, for what is outside: an underflow is correctly rounded, and pieces that are not used may raise anything. */
enum { RAISED = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW | FE_UNDERFLOW };

INLINE void walk(char **args, npy_intp const *count, npy_intp const *steps, Loop loop, npy_intp size, int inputs)
{
    const int before = fetestexcept(RAISED);
    int outside = 0, dense = 1;
    for (int k = 0; k <= inputs; k++) dense &= steps[k] == size;
    if (dense) {
        outside = loop(args, *count);
    }
    else {
        double blocks[3][BLOCK];
        char *const places[] = {(char *)blocks[0], (char *)blocks[1], (char *)blocks[2]};
        for (npy_intp done = 0; done < *count; done += BLOCK) {
            const npy_intp n = *count - done < BLOCK ? *count - done : BLOCK;
            char *to = args[inputs] + done * steps[inputs];
            for (int k = 0; k < inputs; k++) {
                const char *from = args[k] + done * steps[k];
                for (npy_intp i = 0; i < n; i++) memcpy(places[k] + i * size, from + i * steps[k], size);
            }
            outside |= loop(places, n);
            for (npy_intp i = 0; i < n; i++) memcpy(to + i * steps[inputs], places[inputs] + i * size, size);
        }
    }
    if (fetestexcept(RAISED) & ~before) feclearexcept(RAISED & ~before);
    if (outside) feraiseexcept(FE_INVALID);
}

#define WALK(T, INPUTS) \
    static void walk_##T##_##INPUTS(char **args, npy_intp const *count, npy_intp const *steps, void *loop) \
    { \
        walk(args, count, steps, (Loop)loop, sizeof(T), INPUTS); \
    }
WALK(float, 1)
WALK(double, 1)
WALK(float, 2)
WALK(double, 2)

/* By the number of inputs, less one. */
static PyUFuncGenericFunction walks[][2] = {{walk_float_1, walk_double_1}, {walk_float_2, walk_double_2}};
static const char types[][6] = {
    {NPY_FLOAT, NPY_FLOAT, NPY_DOUBLE, NPY_DOUBLE},
    {NPY_FLOAT, NPY_FLOAT, NPY_FLOAT, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE},
};

/* A ufunc; where `loops[0]` is NULL it has no loop for float32. */
typedef struct { const char *kernel, *tier; int inputs; void *loops[2]; } Ufunc;

#define UFUNCS(LEVEL, FORM) \
    static Ufunc ufuncs_##LEVEL[] = { \
    {"polar_moment", "best", 1, {(void *)polar_moment_float32_##LEVEL##_float, (void *)polar_moment_best_##LEVEL##_double}}, \
    {"polar_moment", "1e-10", 1, {NULL, (void *)polar_moment_1e_10_##LEVEL##_double}}, \
    {"polar_moment", "1e-6", 1, {NULL, (void *)polar_moment_1e_6_##LEVEL##_double}}, \
    {"moment_of_inertia", "best", 1, {(void *)moment_of_inertia_float32_##LEVEL##_float, (void *)moment_of_inertia_best_##LEVEL##_double}}, \
    {"moment_of_inertia", "1e-10", 1, {NULL, (void *)moment_of_inertia_1e_10_##LEVEL##_double}}, \
    {"moment_of_inertia", "1e-6", 1, {NULL, (void *)moment_of_inertia_1e_6_##LEVEL##_double}}, \
    {"radial_weight_amplitude", "best", 1, {(void *)radial_weight_amplitude_float32_##LEVEL##_float, (void *)radial_weight_amplitude_best_##LEVEL##_double}}, \
    {"radial_weight_amplitude", "1e-10", 1, {NULL, (void *)radial_weight_amplitude_1e_10_##LEVEL##_double}}, \
    {"radial_weight_amplitude", "1e-6", 1, {NULL, (void *)radial_weight_amplitude_1e_6_##LEVEL##_double}}, \
    {"weight_moment_amplitude", "best", 1, {(void *)weight_moment_amplitude_float32_##LEVEL##_float, (void *)weight_moment_amplitude_best_##LEVEL##_double}}, \
    {"weight_moment_amplitude", "1e-10", 1, {NULL, (void *)weight_moment_amplitude_1e_10_##LEVEL##_double}}, \
    {"weight_moment_amplitude", "1e-6", 1, {NULL, (void *)weight_moment_amplitude_1e_6_##LEVEL##_double}}, \
    {"resistance_factor", "best", 1, {(void *)resistance_factor_float32_##LEVEL##_float, (void *)resistance_factor_best_##LEVEL##_double}}, \
    {"resistance_factor", "1e-10", 1, {NULL, (void *)resistance_factor_1e_10_##LEVEL##_double}}, \
    {"resistance_factor", "1e-6", 1, {NULL, (void *)resistance_factor_1e_6_##LEVEL##_double}}, \
    {"dynamic_coefficient", "best", 1, {(void *)dynamic_coefficient_best_##LEVEL##_float, (void *)dynamic_coefficient_best_##LEVEL##_double}}, \
    {"weight_moment_per_inertia", "best", 1, {(void *)weight_moment_per_inertia_best_##LEVEL##_float, (void *)weight_moment_per_inertia_best_##LEVEL##_double}}, \
    {"radial_weight_per_inertia", "best", 1, {(void *)radial_weight_per_inertia_best_##LEVEL##_float, (void *)radial_weight_per_inertia_best_##LEVEL##_double}}, \
    {"polar_moment_per_inertia", "best", 1, {(void *)polar_moment_per_inertia_best_##LEVEL##_float, (void *)polar_moment_per_inertia_best_##LEVEL##_double}}, \
    {"weight_moment_per_radial_weight", "best", 1, {(void *)weight_moment_per_radial_weight_best_##LEVEL##_float, (void *)weight_moment_per_radial_weight_best_##LEVEL##_double}}, \
    {"radial_weight", "best", 2, {(void *)radial_weight_float32_##LEVEL##_float, (void *)radial_weight_best_##LEVEL##_double}}, \
    {"radial_weight", "1e-10", 2, {NULL, (void *)radial_weight_1e_10_##LEVEL##_double}}, \
    {"radial_weight", "1e-6", 2, {NULL, (void *)radial_weight_1e_6_##LEVEL##_double}}, \
    {"weight_moment", "best", 2, {(void *)weight_moment_float32_##LEVEL##_float, (void *)weight_moment_best_##LEVEL##_double}}, \
    {"weight_moment", "1e-10", 2, {NULL, (void *)weight_moment_1e_10_##LEVEL##_double}}, \
    {"weight_moment", "1e-6", 2, {NULL, (void *)weight_moment_1e_6_##LEVEL##_double}}, \
    {"limit_friction", "best", 2, {(void *)limit_friction_best_##LEVEL##_float, (void *)limit_friction_best_##LEVEL##_double}}, \
    {NULL, NULL, 0, {NULL, NULL}}};
LEVELS(UFUNCS)

static PyObject *ufuncs(Ufunc *table)
{
    PyObject *tiers = PyDict_New();
    for (; tiers && table->kernel; table++) {
        const int first = table->loops[0] == NULL, inputs = table->inputs;
        PyObject *ufunc = PyUFunc_FromFuncAndData(walks[inputs - 1] + first, table->loops + first,
                                                  types[inputs - 1] + (inputs + 1) * first, 2 - first,
                                                  inputs, 1, PyUFunc_None, table->kernel, table->tier, 0);
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

/* A public function of Python whose calls with floats alone go to the loop of a ufunc, and all others to itself: a
 * ufunc, or Python in front of one, takes several times as long as the loop. It is made for the life of the process. */
typedef struct { PyObject_HEAD PyObject *function, *attributes, *weak; Loop loop; Py_ssize_t inputs; } Direct;
static PyArray_Descr *doubles;

static PyObject *direct_new(PyTypeObject *type, PyObject *args, PyObject *named)
{
    PyObject *function, *ufunc;
    if (named || !PyArg_ParseTuple(args, "OO!", &function, &PyUFunc_Type, &ufunc)) return NULL;
    const PyUFuncObject *const of = (PyUFuncObject *)ufunc;
    Direct *const self = (Direct *)PyType_GenericAlloc(type, 0);
    if (self == NULL) return NULL;
    self->function = Py_NewRef(function), self->loop = (Loop)of->data[of->ntypes - 1], self->inputs = of->nin;
    return (PyObject *)self;
}

static PyObject *direct_call(PyObject *object, PyObject *args, PyObject *named)
{
    const Direct *const self = (Direct *)object;
    double numbers[3];
    char *places[] = {(char *)numbers, (char *)(numbers + 1), (char *)(numbers + 2)};
    int simple = named == NULL && PyTuple_Size(args) == self->inputs;
    for (Py_ssize_t k = 0; simple && k < self->inputs; k++) {
        PyObject *const x = PyTuple_GetItem(args, k);
        simple = PyFloat_CheckExact(x) || Py_IS_TYPE(x, &PyDoubleArrType_Type);
        if (simple) numbers[k] = PyFloat_AsDouble(x);
    }
    if (!simple || self->loop(places, 1)) return PyObject_Call(self->function, args, named);
    return PyArray_Scalar(places[self->inputs], doubles, NULL);
}

static PyObject *direct_get(PyObject *self, PyObject *object, PyObject *type)
{
    (void)object, (void)type;
    return Py_NewRef(self);
}

static PyObject *direct_reduce(PyObject *self, PyObject *none)
{
    (void)none;
    return PyObject_GetAttrString(self, "__qualname__"); /* it travels by its name */
}

static PyObject *direct_repr(PyObject *self)
{
    PyObject *const name = PyObject_GetAttrString(self, "__qualname__");
    PyObject *const text = name ? PyUnicode_FromFormat("<function %U>", name) : NULL;
    Py_XDECREF(name);
    return text;
}

static PyMethodDef direct_methods[] = {{"__reduce__", direct_reduce, METH_NOARGS, NULL}, {NULL, NULL, 0, NULL}};
static PyMemberDef direct_members[] = {
    {"__dictoffset__", T_PYSSIZET, offsetof(Direct, attributes), READONLY, NULL},
    {"__weaklistoffset__", T_PYSSIZET, offsetof(Direct, weak), READONLY, NULL},
    {NULL, 0, 0, 0, NULL},
};
static PyGetSetDef direct_fields[] = {
    {"__dict__", PyObject_GenericGetDict, PyObject_GenericSetDict, NULL, NULL},
    {NULL, NULL, NULL, NULL, NULL},
};
static PyType_Slot direct_slots[] = {
    {Py_tp_new, direct_new}, {Py_tp_call, direct_call}, {Py_tp_repr, direct_repr}, {Py_tp_descr_get, direct_get},
    {Py_tp_methods, direct_methods}, {Py_tp_members, direct_members}, {Py_tp_getset, direct_fields}, {0, NULL},
};
static PyType_Spec direct_spec = {"generated._kernels.Direct", sizeof(Direct), 0, Py_TPFLAGS_DEFAULT, direct_slots};

/* DIGEST of the source; Direct, a type; LEVELS: level -> (form, tier -> kernel -> ufunc), the widest first; UNSAFE: a flag, or None. */
static int fill(PyObject *module)
{
    PyObject *levels = PyDict_New();
    const char *flag = NULL;
    int failed = PyArray_ImportNumPyAPI() < 0 || PyUFunc_ImportUFuncAPI() < 0 || levels == NULL;
#define ADD(LEVEL, FORM) \
    if (!failed && (RUNS_##LEVEL)) { \
        PyObject *pair = Py_BuildValue("(sN)", #FORM, ufuncs(ufuncs_##LEVEL)); \
        failed = pair == NULL || PyDict_SetItemString(levels, #LEVEL, pair); \
        Py_XDECREF(pair); \
        flag = flag ? flag : unsafe_##LEVEL(); \
    }
    LEVELS(ADD)
    PyObject *const direct = failed ? NULL : PyType_FromSpec(&direct_spec);
    doubles = failed ? NULL : PyArray_DescrFromType(NPY_DOUBLE);
    failed = failed || direct == NULL || PyModule_AddObjectRef(module, "Direct", direct) ||
             PyModule_AddObjectRef(module, "LEVELS", levels) ||
             PyModule_AddStringConstant(module, "DIGEST", DIGEST) ||
             (flag ? PyModule_AddStringConstant(module, "UNSAFE", flag)
                   : PyModule_AddObjectRef(module, "UNSAFE", Py_None));
    Py_XDECREF(levels), Py_XDECREF(direct);
    return failed ? -1 : 0;
}

static PyModuleDef_Slot slots[] = {
    {Py_mod_exec, fill},
#ifdef Py_MOD_GIL_NOT_USED
    {Py_mod_gil, Py_MOD_GIL_NOT_USED},
#endif
    {0, NULL},
};
static struct PyModuleDef definition = {PyModuleDef_HEAD_INIT, "_kernels", NULL, 0, NULL, slots, NULL, NULL, NULL};
PyMODINIT_FUNC PyInit__kernels(void) { return PyModuleDef_Init(&definition); }
