/* Written by `python -m derive` with SymPy 1.14.0; do not edit. */
#define DIGEST "7a6a32e43c09258bc75e7eb2cd3381df89a773e35a3dad884be3df7820fd2ac3"
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

#ifndef NO_FMA
INLINE double polar_moment_best_fused(double alpha)
{
    const double v1 = alpha * alpha;
    const double v2 = -v1;
    const double v3 = __builtin_fma(alpha, alpha, v2);
    const double v4 = v1 * v1;
    const double v7 = __builtin_fma(0x1.5a4eb8d4fdf16p-30, v4, 0x1.1cf83c1392ee5p-27);
    const double v9 = __builtin_fma(v7, v4, 0x1.20dc3d60db7aap-25);
    const double v11 = __builtin_fma(v9, v4, 0x1.f97dd8a440e49p-20);
    const double v13 = __builtin_fma(v11, v4, 0x1.35581eb7b9c4ep-11);
    const double v16 = __builtin_fma((-0x1.a3e7d0b8cee94p-29), v4, 0x1.372e5bb516f5ap-30);
    const double v18 = __builtin_fma(v16, v4, 0x1.ffc5bb85d3a0bp-25);
    const double v20 = __builtin_fma(v18, v4, (-0x1.08db8c9edc7c7p-15));
    const double v22 = __builtin_fma(v20, v4, (-0x1.ce55c8ec1b57ap-8));
    const double v23 = __builtin_fma(v1, v13, v22);
    const double v25 = __builtin_fma(v1, v23, 0x1.d41d41d41edeap-5);
    const double v27 = __builtin_fma(v25, v1, (-0x1.111111111111cp-2));
    const double v29 = __builtin_fma(v27, v1, 0x1.5555555555555p-1);
    const double v30 = 0x1.5555555555555p-1 - v29;
    const double v31 = __builtin_fma(v27, v1, v30);
    const double v32 = (-0x1.111111111111cp-2) - v27;
    const double v33 = __builtin_fma(v25, v1, v32);
    const double v35 = v31 + 0x1.5555555555555p-55;
    const double v36 = __builtin_fma(v1, v33, v35);
    const double v39 = __builtin_fma(0x1.0000000000000p+1, v29, (-0x1.5555555555555p-1));
    const double v40 = __builtin_fma(v2, v32, v39);
    const double v41 = v1 * v29;
    const double v42 = -v41;
    const double v43 = __builtin_fma(v1, v29, v42);
    const double v44 = __builtin_fma(v3, v40, v43);
    const double v45 = __builtin_fma(v1, v36, v44);
    const double v46 = alpha * v45;
    const double v47 = __builtin_fma(alpha, v41, v46);
    const double v49 = 0x1.921fb54442d18p+0 - alpha;
    const double v50 = v49 * v49;
    const double v53 = __builtin_fma(0x1.1477caa143cfbp-15, v50, (-0x1.058aebdba383ap-11));
    const double v55 = __builtin_fma(v53, v50, 0x1.556ffb39c3af9p-8);
    const double v57 = __builtin_fma(v55, v50, (-0x1.0ee086df8c2f9p-5));
    const double v59 = __builtin_fma(v57, v50, 0x1.94ebfbb2ec66fp-4);
    const double v61 = __builtin_fma(v59, v50, (-0x1.213ce230290f3p-7));
    const double v64 = __builtin_fma((-0x1.b16de590ed744p-16), v50, 0x1.80dce9acbd0ffp-12);
    const double v66 = __builtin_fma(v64, v50, (-0x1.2834e1f3e1a60p-8));
    const double v68 = __builtin_fma(v66, v50, 0x1.27d279e0496b5p-5);
    const double v70 = __builtin_fma(v68, v50, (-0x1.555555518e7c3p-3));
    const double v72 = __builtin_fma(v70, v50, 0x1.55555555579d1p-2);
    const double v74 = v49 > 0x1.0000000000000p-60 ? v49 : 0x1.0000000000000p-60;
    const double v75 = significand_of(v74);
    const double v77 = v75 - 0x1.0000000000000p+0;
    const double v78 = v77 + 0x1.0000000000000p+1;
    const double v79 = v77 / v78;
    const double v80 = v79 * v79;
    const double v83 = __builtin_fma(0x1.3cda08c7927d8p-3, v80, 0x1.3804595ac79edp-3);
    const double v85 = __builtin_fma(v83, v80, 0x1.747966b22b47ep-3);
    const double v87 = __builtin_fma(v85, v80, 0x1.c71be01ef8d7bp-3);
    const double v89 = __builtin_fma(v87, v80, 0x1.249249f1b0e53p-2);
    const double v91 = __builtin_fma(v89, v80, 0x1.999999987c7a3p-2);
    const double v93 = __builtin_fma(v91, v80, 0x1.55555555559d8p-1);
    const double v94 = -v77;
    const double v95 = __builtin_fma(v80, v93, v94);
    const double v96 = exponent_of(v74);
    const double v98 = __builtin_fma(v96, 0x1.62e42fefa39efp-1, v77);
    const double v99 = __builtin_fma(v79, v95, v98);
    const double v100 = __builtin_fma(v72, v99, v61);
    const double v101 = v49 * v50;
    const double v103 = __builtin_fma(v101, v100, 0x1.ee6913347c2a6p-55);
    const double v105 = alpha + (-0x1.0c152382d7366p-1);
    const double v106 = v105 + v103;
    const int v108 = alpha < 0x1.dc28f5c28f5c3p-1;
    const double v109 = v108 ? v47 : v106;
    return v109;
}
#define polar_moment_best_fused_KIND pieces
#define polar_moment_best_fused_BELOW_double UINT64_C(0x3fedc28f5c28f5c2)
#define polar_moment_best_fused_BELOW_float UINT32_C(0x3f6e147a)
INLINE double polar_moment_best_fused_below(double alpha)
{
    const double v1 = alpha * alpha;
    const double v2 = -v1;
    const double v3 = __builtin_fma(alpha, alpha, v2);
    const double v4 = v1 * v1;
    const double v7 = __builtin_fma(0x1.5a4eb8d4fdf16p-30, v4, 0x1.1cf83c1392ee5p-27);
    const double v9 = __builtin_fma(v7, v4, 0x1.20dc3d60db7aap-25);
    const double v11 = __builtin_fma(v9, v4, 0x1.f97dd8a440e49p-20);
    const double v13 = __builtin_fma(v11, v4, 0x1.35581eb7b9c4ep-11);
    const double v16 = __builtin_fma((-0x1.a3e7d0b8cee94p-29), v4, 0x1.372e5bb516f5ap-30);
    const double v18 = __builtin_fma(v16, v4, 0x1.ffc5bb85d3a0bp-25);
    const double v20 = __builtin_fma(v18, v4, (-0x1.08db8c9edc7c7p-15));
    const double v22 = __builtin_fma(v20, v4, (-0x1.ce55c8ec1b57ap-8));
    const double v23 = __builtin_fma(v1, v13, v22);
    const double v25 = __builtin_fma(v1, v23, 0x1.d41d41d41edeap-5);
    const double v27 = __builtin_fma(v25, v1, (-0x1.111111111111cp-2));
    const double v29 = __builtin_fma(v27, v1, 0x1.5555555555555p-1);
    const double v30 = 0x1.5555555555555p-1 - v29;
    const double v31 = __builtin_fma(v27, v1, v30);
    const double v32 = (-0x1.111111111111cp-2) - v27;
    const double v33 = __builtin_fma(v25, v1, v32);
    const double v35 = v31 + 0x1.5555555555555p-55;
    const double v36 = __builtin_fma(v1, v33, v35);
    const double v39 = __builtin_fma(0x1.0000000000000p+1, v29, (-0x1.5555555555555p-1));
    const double v40 = __builtin_fma(v2, v32, v39);
    const double v41 = v1 * v29;
    const double v42 = -v41;
    const double v43 = __builtin_fma(v1, v29, v42);
    const double v44 = __builtin_fma(v3, v40, v43);
    const double v45 = __builtin_fma(v1, v36, v44);
    const double v46 = alpha * v45;
    const double v47 = __builtin_fma(alpha, v41, v46);
    return v47;
}

INLINE double polar_moment_1e_10_fused(double alpha)
{
    const double v1 = alpha * alpha;
    const double v3 = 0x1.3bd3cc9be45dep+1 - v1;
    const double v6 = __builtin_fma(0x1.e250654a0fa79p-5, v3, 0x1.764b4fd12c227p+1);
    const double v8 = __builtin_fma(v6, v3, 0x1.15f5651c6c2b6p+4);
    const double v10 = __builtin_fma(v8, v3, 0x1.97881d28eb78fp+6);
    const double v12 = __builtin_fma(v10, v3, 0x1.781f38b2a68b0p+7);
    const double v14 = __builtin_fma(v12, v3, 0x1.705f937528711p+6);
    const double v16 = __builtin_fma(v14, v3, 0x1.6f67e48f11997p+3);
    const double v18 = __builtin_fma(v16, v3, 0x1.14aca4167a07fp-2);
    const double v19 = v18 * v1;
    const double v22 = __builtin_fma((-0x1.efcbe37812bdfp-4), v3, 0x1.b9bc468114fd2p+1);
    const double v24 = __builtin_fma(v22, v3, (-0x1.444345493560ap+5));
    const double v26 = __builtin_fma(v24, v3, 0x1.4ea305d69d8f6p+7);
    const double v28 = __builtin_fma(v26, v3, 0x1.283ecbb1b4392p+9);
    const double v30 = __builtin_fma(v28, v3, 0x1.47ee26059427dp+8);
    const double v32 = __builtin_fma(v30, v3, 0x1.5185165bf6bccp+5);
    const double v34 = __builtin_fma(v32, v3, 0x1.0000000000000p+0);
    const double v35 = v19 / v34;
    const double v36 = v35 * alpha;
    return v36;
}
#define polar_moment_1e_10_fused_KIND whole

INLINE double polar_moment_1e_6_fused(double alpha)
{
    const double v1 = alpha * alpha;
    const double v4 = __builtin_fma(0x1.c6cb40d04487cp-17, v1, (-0x1.01f8715011affp-13));
    const double v6 = __builtin_fma(v4, v1, 0x1.e6addd2fd57c1p-12);
    const double v8 = __builtin_fma(v6, v1, (-0x1.f017539ffdb0bp-11));
    const double v10 = __builtin_fma(v8, v1, 0x1.a45a7a5b48d87p-10);
    const double v12 = __builtin_fma(v10, v1, (-0x1.f6c43e68063fbp-8));
    const double v14 = __builtin_fma(v12, v1, 0x1.d5a56118ff0cbp-5);
    const double v16 = __builtin_fma(v14, v1, (-0x1.1116d4346c2b7p-2));
    const double v18 = __builtin_fma(v16, v1, 0x1.555563e45ba3ep-1);
    const double v19 = v18 * v1;
    const double v20 = v19 * alpha;
    return v20;
}
#define polar_moment_1e_6_fused_KIND short

INLINE double polar_moment_float32_fused(double alpha)
{
    const double v1 = alpha * alpha;
    const double v3 = 0x1.3bd3cc9be45dep+1 - v1;
    const double v6 = __builtin_fma(0x1.06bac513c89bdp-4, v3, 0x1.dc0d095bd83c1p-1);
    const double v8 = __builtin_fma(v6, v3, 0x1.933d9ee3bc318p+2);
    const double v10 = __builtin_fma(v8, v3, 0x1.db1c7a52b7740p+4);
    const double v12 = __builtin_fma(v10, v3, 0x1.1699441fb3d7bp+6);
    const double v14 = __builtin_fma(v12, v3, 0x1.7e9225dc641bdp+5);
    const double v16 = __builtin_fma(v14, v3, 0x1.0a493d7acae63p+3);
    const double v18 = __builtin_fma(v16, v3, 0x1.14aca415ff9bep-2);
    const double v19 = v18 * v1;
    const double v22 = __builtin_fma(0x1.d7d31fc8e0f2ap-3, v3, (-0x1.62e6200f03a08p+2));
    const double v24 = __builtin_fma(v22, v3, 0x1.060efdd46e2e3p+5);
    const double v26 = __builtin_fma(v24, v3, 0x1.981502230ec47p+7);
    const double v28 = __builtin_fma(v26, v3, 0x1.4f42aae35dcb3p+7);
    const double v30 = __builtin_fma(v28, v3, 0x1.e7e99b90416b4p+4);
    const double v32 = __builtin_fma(v30, v3, 0x1.0000000000000p+0);
    const double v33 = v19 / v32;
    const double v34 = v33 * alpha;
    return v34;
}
#define polar_moment_float32_fused_KIND whole

INLINE double moment_of_inertia_best_fused(double alpha)
{
    const double v1 = alpha * alpha;
    const double v2 = -v1;
    const double v3 = __builtin_fma(alpha, alpha, v2);
    const double v4 = v1 * v1;
    const double v7 = __builtin_fma(0x1.f3cdbf532eaf7p-34, v4, 0x1.9465eeb660151p-24);
    const double v9 = __builtin_fma(v7, v4, 0x1.1f0877c40acffp-15);
    const double v11 = __builtin_fma(v9, v4, 0x1.1f7d05c72fc3ap-8);
    const double v14 = __builtin_fma((-0x1.91e6b7ad796a6p-39), v4, (-0x1.ed2a462794ae8p-29));
    const double v16 = __builtin_fma(v14, v4, (-0x1.0e1fd712de8dbp-19));
    const double v18 = __builtin_fma(v16, v4, (-0x1.d71607bd2727dp-12));
    const double v20 = __builtin_fma(v18, v4, (-0x1.f1029e62cad66p-6));
    const double v21 = __builtin_fma(v1, v11, v20);
    const double v23 = __builtin_fma(v1, v21, 0x1.1e11e11e11e36p-3);
    const double v25 = __builtin_fma(v23, v1, (-0x1.999999999999ap-2));
    const double v27 = __builtin_fma(v25, v1, 0x1.5555555555555p-1);
    const double v28 = 0x1.5555555555555p-1 - v27;
    const double v29 = __builtin_fma(v25, v1, v28);
    const double v30 = (-0x1.999999999999ap-2) - v25;
    const double v31 = __builtin_fma(v23, v1, v30);
    const double v33 = v29 + 0x1.5555555555555p-55;
    const double v34 = __builtin_fma(v1, v31, v33);
    const double v37 = __builtin_fma(0x1.0000000000000p+1, v27, (-0x1.5555555555555p-1));
    const double v38 = __builtin_fma(v2, v30, v37);
    const double v39 = v1 * v27;
    const double v40 = -v39;
    const double v41 = __builtin_fma(v1, v27, v40);
    const double v42 = __builtin_fma(v3, v38, v41);
    const double v43 = __builtin_fma(v1, v34, v42);
    const double v44 = alpha * v43;
    const double v45 = __builtin_fma(alpha, v39, v44);
    const double v47 = 0x1.921fb54442d18p+0 - alpha;
    const double v48 = v47 * v47;
    const double v51 = __builtin_fma((-0x1.00589fe65ed98p-23), v48, 0x1.1425220d45aaap-19);
    const double v53 = __builtin_fma(v51, v48, (-0x1.1f397f95f7403p-15));
    const double v55 = __builtin_fma(v53, v48, 0x1.d6a371cc475cdp-12);
    const double v57 = __builtin_fma(v55, v48, (-0x1.1e5e23528aa32p-8));
    const double v59 = __builtin_fma(v57, v48, 0x1.e94dfd8b6e6d2p-6);
    const double v61 = __builtin_fma(v59, v48, (-0x1.0cbb76630619cp-3));
    const double v63 = __builtin_fma(v61, v48, 0x1.3e93e93e9959dp-2);
    const double v65 = __builtin_fma(v63, v48, (-0x1.c71c71c71cad2p-3));
    const double v67 = __builtin_fma(v65, v48, (-0x1.555555555554ep-3));
    const double v69 = __builtin_fma(v47, v67, 0x1.dffffffffffffp-4);
    const double v71 = 0x1.0000000000000p-1 * alpha;
    const double v73 = v71 + (-0x1.e000000000000p-4);
    const double v74 = v73 + v69;
    const int v76 = alpha < 0x1.0000000000000p+0;
    const double v77 = v76 ? v45 : v74;
    return v77;
}
#define moment_of_inertia_best_fused_KIND pieces
#define moment_of_inertia_best_fused_BELOW_double UINT64_C(0x3fefffffffffffff)
#define moment_of_inertia_best_fused_BELOW_float UINT32_C(0x3f7fffff)
INLINE double moment_of_inertia_best_fused_below(double alpha)
{
    const double v1 = alpha * alpha;
    const double v2 = -v1;
    const double v3 = __builtin_fma(alpha, alpha, v2);
    const double v4 = v1 * v1;
    const double v7 = __builtin_fma(0x1.f3cdbf532eaf7p-34, v4, 0x1.9465eeb660151p-24);
    const double v9 = __builtin_fma(v7, v4, 0x1.1f0877c40acffp-15);
    const double v11 = __builtin_fma(v9, v4, 0x1.1f7d05c72fc3ap-8);
    const double v14 = __builtin_fma((-0x1.91e6b7ad796a6p-39), v4, (-0x1.ed2a462794ae8p-29));
    const double v16 = __builtin_fma(v14, v4, (-0x1.0e1fd712de8dbp-19));
    const double v18 = __builtin_fma(v16, v4, (-0x1.d71607bd2727dp-12));
    const double v20 = __builtin_fma(v18, v4, (-0x1.f1029e62cad66p-6));
    const double v21 = __builtin_fma(v1, v11, v20);
    const double v23 = __builtin_fma(v1, v21, 0x1.1e11e11e11e36p-3);
    const double v25 = __builtin_fma(v23, v1, (-0x1.999999999999ap-2));
    const double v27 = __builtin_fma(v25, v1, 0x1.5555555555555p-1);
    const double v28 = 0x1.5555555555555p-1 - v27;
    const double v29 = __builtin_fma(v25, v1, v28);
    const double v30 = (-0x1.999999999999ap-2) - v25;
    const double v31 = __builtin_fma(v23, v1, v30);
    const double v33 = v29 + 0x1.5555555555555p-55;
    const double v34 = __builtin_fma(v1, v31, v33);
    const double v37 = __builtin_fma(0x1.0000000000000p+1, v27, (-0x1.5555555555555p-1));
    const double v38 = __builtin_fma(v2, v30, v37);
    const double v39 = v1 * v27;
    const double v40 = -v39;
    const double v41 = __builtin_fma(v1, v27, v40);
    const double v42 = __builtin_fma(v3, v38, v41);
    const double v43 = __builtin_fma(v1, v34, v42);
    const double v44 = alpha * v43;
    const double v45 = __builtin_fma(alpha, v39, v44);
    return v45;
}

INLINE double moment_of_inertia_1e_10_fused(double alpha)
{
    const double v1 = alpha * alpha;
    const double v4 = __builtin_fma((-0x1.4936e56328342p-29), v1, 0x1.7a7cb07e3408cp-24);
    const double v6 = __builtin_fma(v4, v1, (-0x1.0bc4e9f8c08c4p-19));
    const double v8 = __builtin_fma(v6, v1, 0x1.1ec4f59c801cbp-15);
    const double v10 = __builtin_fma(v8, v1, (-0x1.d70c8c3356105p-12));
    const double v12 = __builtin_fma(v10, v1, 0x1.1f7c9cb90ff08p-8);
    const double v14 = __builtin_fma(v12, v1, (-0x1.f10293cdf1d20p-6));
    const double v16 = __builtin_fma(v14, v1, 0x1.1e11e0d7b66ffp-3);
    const double v18 = __builtin_fma(v16, v1, (-0x1.99999996b5367p-2));
    const double v20 = __builtin_fma(v18, v1, 0x1.55555555502c0p-1);
    const double v21 = v20 * v1;
    const double v22 = v21 * alpha;
    return v22;
}
#define moment_of_inertia_1e_10_fused_KIND short

INLINE double moment_of_inertia_1e_6_fused(double alpha)
{
    const double v1 = alpha * alpha;
    const double v4 = __builtin_fma(0x1.50ef7c600437bp-16, v1, (-0x1.a6e3a2c99c515p-12));
    const double v6 = __builtin_fma(v4, v1, 0x1.1a5c427a6780ap-8);
    const double v8 = __builtin_fma(v6, v1, (-0x1.efda754ae7b31p-6));
    const double v10 = __builtin_fma(v8, v1, 0x1.1e017fc24dd09p-3);
    const double v12 = __builtin_fma(v10, v1, (-0x1.999830f1f6825p-2));
    const double v14 = __builtin_fma(v12, v1, 0x1.55554ffb45dfap-1);
    const double v15 = v14 * v1;
    const double v16 = v15 * alpha;
    return v16;
}
#define moment_of_inertia_1e_6_fused_KIND short

INLINE double moment_of_inertia_float32_fused(double alpha)
{
    const double v1 = alpha * alpha;
    const double v4 = __builtin_fma(0x1.049a5be9eb92ap-24, v1, (-0x1.f4342ef238f03p-20));
    const double v6 = __builtin_fma(v4, v1, 0x1.1be5d7f6ae24dp-15);
    const double v8 = __builtin_fma(v6, v1, (-0x1.d6804e76da319p-12));
    const double v10 = __builtin_fma(v8, v1, 0x1.1f74af1fc94e4p-8);
    const double v12 = __builtin_fma(v10, v1, (-0x1.f1018ef94d003p-6));
    const double v14 = __builtin_fma(v12, v1, 0x1.1e11d8503acb9p-3);
    const double v16 = __builtin_fma(v14, v1, (-0x1.9999992647539p-2));
    const double v18 = __builtin_fma(v16, v1, 0x1.55555554542e9p-1);
    const double v19 = v18 * v1;
    const double v20 = v19 * alpha;
    return v20;
}
#define moment_of_inertia_float32_fused_KIND short

INLINE double radial_weight_amplitude_best_fused(double alpha)
{
    const double v1 = alpha * alpha;
    const double v2 = -v1;
    const double v3 = __builtin_fma(alpha, alpha, v2);
    const double v4 = v1 * v1;
    const double v7 = __builtin_fma(0x1.1daae6a223a3dp-26, v4, 0x1.59d79b38274bdp-24);
    const double v9 = __builtin_fma(v7, v4, 0x1.ce69726473d26p-25);
    const double v11 = __builtin_fma(v9, v4, (-0x1.31eb80a2fef7dp-22));
    const double v13 = __builtin_fma(v11, v4, (-0x1.01343350b0275p-18));
    const double v15 = __builtin_fma(v13, v4, (-0x1.47d654b129ff9p-16));
    const double v18 = __builtin_fma((-0x1.9d4044a7034c3p-29), v4, (-0x1.a2c353c442e22p-25));
    const double v20 = __builtin_fma(v18, v4, (-0x1.cb311e1e7579cp-24));
    const double v22 = __builtin_fma(v20, v4, (-0x1.2d7a3353abe26p-23));
    const double v24 = __builtin_fma(v22, v4, (-0x1.1f97784d3fc01p-20));
    const double v26 = __builtin_fma(v24, v4, (-0x1.07d8efa7a3041p-16));
    const double v28 = __builtin_fma(v26, v4, (-0x1.664f4888b6cd1p-10));
    const double v29 = __builtin_fma(v1, v15, v28);
    const double v31 = __builtin_fma(v1, v29, 0x1.2b12b12b158cap-6);
    const double v33 = __builtin_fma(v31, v1, (-0x1.99999999999a9p-3));
    const double v35 = __builtin_fma(v33, v1, 0x1.5555555555555p-1);
    const double v36 = 0x1.5555555555555p-1 - v35;
    const double v37 = __builtin_fma(v33, v1, v36);
    const double v38 = (-0x1.99999999999a9p-3) - v33;
    const double v39 = __builtin_fma(v31, v1, v38);
    const double v41 = v37 + 0x1.5555555555555p-55;
    const double v42 = __builtin_fma(v1, v39, v41);
    const double v45 = __builtin_fma(0x1.0000000000000p+1, v35, (-0x1.5555555555555p-1));
    const double v46 = __builtin_fma(v2, v38, v45);
    const double v47 = v1 * v35;
    const double v48 = -v47;
    const double v49 = __builtin_fma(v1, v35, v48);
    const double v50 = __builtin_fma(v3, v46, v49);
    const double v51 = __builtin_fma(v1, v42, v50);
    const double v52 = alpha * v51;
    const double v53 = __builtin_fma(alpha, v47, v52);
    const double v55 = 0x1.921fb54442d18p+0 - alpha;
    const double v56 = v55 * v55;
    const double v59 = __builtin_fma(0x1.8128754f493fdp-17, v56, (-0x1.5c1de3bda9c32p-12));
    const double v61 = __builtin_fma(v59, v56, 0x1.c0f84768fd081p-8);
    const double v63 = __builtin_fma(v61, v56, (-0x1.5fec3987413d3p-4));
    const double v65 = __builtin_fma(v63, v56, 0x1.2c981ff50df71p-1);
    const double v67 = __builtin_fma(v65, v56, (-0x1.7217f7d1c0c33p-7));
    const double v70 = __builtin_fma((-0x1.4b80ca7eaf925p-18), v56, 0x1.26ecb6ae67667p-13);
    const double v72 = __builtin_fma(v70, v56, (-0x1.a01c15d7033acp-9));
    const double v74 = __builtin_fma(v72, v56, 0x1.6c16c0a0e6534p-5);
    const double v76 = __builtin_fma(v74, v56, (-0x1.555555554900ap-2));
    const double v78 = __builtin_fma(v76, v56, 0x1.00000000000b6p+0);
    const double v79 = 0x1.0000000000000p+1 * v55;
    const double v81 = v79 > 0x1.0000000000000p-60 ? v79 : 0x1.0000000000000p-60;
    const double v82 = significand_of(v81);
    const double v84 = v82 - 0x1.0000000000000p+0;
    const double v85 = v84 + 0x1.0000000000000p+1;
    const double v86 = v84 / v85;
    const double v87 = v86 * v86;
    const double v90 = __builtin_fma(0x1.3cda08c7927d8p-3, v87, 0x1.3804595ac79edp-3);
    const double v92 = __builtin_fma(v90, v87, 0x1.747966b22b47ep-3);
    const double v94 = __builtin_fma(v92, v87, 0x1.c71be01ef8d7bp-3);
    const double v96 = __builtin_fma(v94, v87, 0x1.249249f1b0e53p-2);
    const double v98 = __builtin_fma(v96, v87, 0x1.999999987c7a3p-2);
    const double v100 = __builtin_fma(v98, v87, 0x1.55555555559d8p-1);
    const double v101 = -v84;
    const double v102 = __builtin_fma(v87, v100, v101);
    const double v103 = exponent_of(v81);
    const double v105 = __builtin_fma(v103, 0x1.62e42fefa39efp-1, v84);
    const double v106 = __builtin_fma(v86, v102, v105);
    const double v107 = __builtin_fma(v78, v106, v67);
    const double v108 = v56 * v107;
    const double v110 = __builtin_fma(v55, (-0x1.e000000000000p+0), 0x1.0000000000000p+0);
    const double v111 = __builtin_fma(v55, v110, v108);
    const double v113 = alpha + (-0x1.243f6a8885a30p-1);
    const double v114 = v113 + v111;
    const int v116 = alpha < 0x1.051eb851eb852p+0;
    const double v117 = v116 ? v53 : v114;
    return v117;
}
#define radial_weight_amplitude_best_fused_KIND pieces
#define radial_weight_amplitude_best_fused_BELOW_double UINT64_C(0x3ff051eb851eb851)
#define radial_weight_amplitude_best_fused_BELOW_float UINT32_C(0x3f828f5c)
INLINE double radial_weight_amplitude_best_fused_below(double alpha)
{
    const double v1 = alpha * alpha;
    const double v2 = -v1;
    const double v3 = __builtin_fma(alpha, alpha, v2);
    const double v4 = v1 * v1;
    const double v7 = __builtin_fma(0x1.1daae6a223a3dp-26, v4, 0x1.59d79b38274bdp-24);
    const double v9 = __builtin_fma(v7, v4, 0x1.ce69726473d26p-25);
    const double v11 = __builtin_fma(v9, v4, (-0x1.31eb80a2fef7dp-22));
    const double v13 = __builtin_fma(v11, v4, (-0x1.01343350b0275p-18));
    const double v15 = __builtin_fma(v13, v4, (-0x1.47d654b129ff9p-16));
    const double v18 = __builtin_fma((-0x1.9d4044a7034c3p-29), v4, (-0x1.a2c353c442e22p-25));
    const double v20 = __builtin_fma(v18, v4, (-0x1.cb311e1e7579cp-24));
    const double v22 = __builtin_fma(v20, v4, (-0x1.2d7a3353abe26p-23));
    const double v24 = __builtin_fma(v22, v4, (-0x1.1f97784d3fc01p-20));
    const double v26 = __builtin_fma(v24, v4, (-0x1.07d8efa7a3041p-16));
    const double v28 = __builtin_fma(v26, v4, (-0x1.664f4888b6cd1p-10));
    const double v29 = __builtin_fma(v1, v15, v28);
    const double v31 = __builtin_fma(v1, v29, 0x1.2b12b12b158cap-6);
    const double v33 = __builtin_fma(v31, v1, (-0x1.99999999999a9p-3));
    const double v35 = __builtin_fma(v33, v1, 0x1.5555555555555p-1);
    const double v36 = 0x1.5555555555555p-1 - v35;
    const double v37 = __builtin_fma(v33, v1, v36);
    const double v38 = (-0x1.99999999999a9p-3) - v33;
    const double v39 = __builtin_fma(v31, v1, v38);
    const double v41 = v37 + 0x1.5555555555555p-55;
    const double v42 = __builtin_fma(v1, v39, v41);
    const double v45 = __builtin_fma(0x1.0000000000000p+1, v35, (-0x1.5555555555555p-1));
    const double v46 = __builtin_fma(v2, v38, v45);
    const double v47 = v1 * v35;
    const double v48 = -v47;
    const double v49 = __builtin_fma(v1, v35, v48);
    const double v50 = __builtin_fma(v3, v46, v49);
    const double v51 = __builtin_fma(v1, v42, v50);
    const double v52 = alpha * v51;
    const double v53 = __builtin_fma(alpha, v47, v52);
    return v53;
}

INLINE double radial_weight_amplitude_1e_10_fused(double alpha)
{
    const double v1 = alpha * alpha;
    const double v3 = 0x1.3bd3cc9be45dep+1 - v1;
    const double v6 = __builtin_fma(0x1.04f7df6595ca2p+25, v3, 0x1.83d173767ec99p+29);
    const double v8 = __builtin_fma(v6, v3, 0x1.508e0e40facb6p+32);
    const double v10 = __builtin_fma(v8, v3, 0x1.8da34cb08e1f0p+33);
    const double v12 = __builtin_fma(v10, v3, 0x1.6259be601aeb1p+33);
    const double v14 = __builtin_fma(v12, v3, 0x1.dda5739c64a89p+31);
    const double v16 = __builtin_fma(v14, v3, 0x1.d131baf022e41p+28);
    const double v18 = __builtin_fma(v16, v3, 0x1.2d9988866fd53p+24);
    const double v20 = __builtin_fma(v18, v3, 0x1.c7fae97af9e1fp+17);
    const double v22 = __builtin_fma(v20, v3, 0x1.40cc71ab82b17p+9);
    const double v24 = __builtin_fma(v22, v3, 0x1.08345eb49dfa4p-2);
    const double v25 = v24 * v1;
    const double v28 = __builtin_fma(0x1.aed60df82a50dp+23, v3, (-0x1.cb6e4518cfd29p+28));
    const double v30 = __builtin_fma(v28, v3, 0x1.1ea89b013008dp+32);
    const double v32 = __builtin_fma(v30, v3, 0x1.c5d99f7e12cd1p+34);
    const double v34 = __builtin_fma(v32, v3, 0x1.18d58653a0677p+35);
    const double v36 = __builtin_fma(v34, v3, 0x1.ae1c93f2d7caep+33);
    const double v38 = __builtin_fma(v36, v3, 0x1.b7d217ea325d6p+30);
    const double v40 = __builtin_fma(v38, v3, 0x1.22251312f6b79p+26);
    const double v42 = __builtin_fma(v40, v3, 0x1.b915276826f3cp+19);
    const double v44 = __builtin_fma(v42, v3, 0x1.36c2b5ccd0c1fp+11);
    const double v46 = __builtin_fma(v44, v3, 0x1.0000000000000p+0);
    const double v47 = v25 / v46;
    const double v48 = v47 * alpha;
    return v48;
}
#define radial_weight_amplitude_1e_10_fused_KIND whole

INLINE double radial_weight_amplitude_1e_6_fused(double alpha)
{
    const double v1 = alpha * alpha;
    const double v3 = 0x1.3bd3cc9be45dep+1 - v1;
    const double v6 = __builtin_fma(0x1.cc8a8141fa745p+2, v3, 0x1.16253f17550d1p+5);
    const double v8 = __builtin_fma(v6, v3, 0x1.24ceea0f4ee36p+5);
    const double v10 = __builtin_fma(v8, v3, 0x1.072fc483044bbp+3);
    const double v12 = __builtin_fma(v10, v3, 0x1.083464838a5a9p-2);
    const double v13 = v12 * v1;
    const double v16 = __builtin_fma(0x1.32c3a7d534520p-2, v3, (-0x1.f40a4101ee07ep+2));
    const double v18 = __builtin_fma(v16, v3, 0x1.0589e6f9d3ef3p+6);
    const double v20 = __builtin_fma(v18, v3, 0x1.ed09359bb409ap+6);
    const double v22 = __builtin_fma(v20, v3, 0x1.f44f9842d233ap+4);
    const double v24 = __builtin_fma(v22, v3, 0x1.0000000000000p+0);
    const double v25 = v13 / v24;
    const double v26 = v25 * alpha;
    return v26;
}
#define radial_weight_amplitude_1e_6_fused_KIND short

INLINE double radial_weight_amplitude_float32_fused(double alpha)
{
    const double v1 = alpha * alpha;
    const double v3 = 0x1.3bd3cc9be45dep+1 - v1;
    const double v6 = __builtin_fma(0x1.a41276abb9bcap+18, v3, 0x1.5866e2818eb1dp+23);
    const double v8 = __builtin_fma(v6, v3, 0x1.146d584af00dcp+26);
    const double v10 = __builtin_fma(v8, v3, 0x1.1b0db627b1ac4p+27);
    const double v12 = __builtin_fma(v10, v3, 0x1.9d535830bdb5cp+26);
    const double v14 = __builtin_fma(v12, v3, 0x1.a80171a3e90ffp+24);
    const double v16 = __builtin_fma(v14, v3, 0x1.1c70adff422e7p+21);
    const double v18 = __builtin_fma(v16, v3, 0x1.b837b6270ce48p+15);
    const double v20 = __builtin_fma(v18, v3, 0x1.3b6600d74bccbp+8);
    const double v22 = __builtin_fma(v20, v3, 0x1.08345eb56857ap-2);
    const double v23 = v22 * v1;
    const double v26 = __builtin_fma(0x1.c1ec6782b793bp+17, v3, (-0x1.c99f8ffd771f7p+22));
    const double v28 = __builtin_fma(v26, v3, 0x1.1d5c0538d4588p+26);
    const double v30 = __builtin_fma(v28, v3, 0x1.61a66a4a4b7dfp+28);
    const double v32 = __builtin_fma(v30, v3, 0x1.573eb93a9e7aap+28);
    const double v34 = __builtin_fma(v32, v3, 0x1.86838e8dc8106p+26);
    const double v36 = __builtin_fma(v34, v3, 0x1.0f96e362556bdp+23);
    const double v38 = __builtin_fma(v36, v3, 0x1.a919145cb9bd0p+17);
    const double v40 = __builtin_fma(v38, v3, 0x1.3173bf280d278p+10);
    const double v42 = __builtin_fma(v40, v3, 0x1.0000000000000p+0);
    const double v43 = v23 / v42;
    const double v44 = v43 * alpha;
    return v44;
}
#define radial_weight_amplitude_float32_fused_KIND whole

INLINE double weight_moment_amplitude_best_fused(double alpha)
{
    const double v1 = alpha * alpha;
    const double v2 = -v1;
    const double v3 = __builtin_fma(alpha, alpha, v2);
    const double v4 = v1 * v1;
    const double v7 = __builtin_fma(0x1.30e9ff831c7c7p-41, v4, 0x1.b59da2f914bb4p-30);
    const double v9 = __builtin_fma(v7, v4, 0x1.eaeaa2cd96bc4p-20);
    const double v11 = __builtin_fma(v9, v4, 0x1.83c8978ec53afp-11);
    const double v14 = __builtin_fma((-0x1.2a4e8655ba3f6p-35), v4, (-0x1.03e52c1c9f8cfp-24));
    const double v16 = __builtin_fma(v14, v4, (-0x1.65f59e30b1564p-15));
    const double v18 = __builtin_fma(v16, v4, (-0x1.282ef4b666c9dp-7));
    const double v19 = __builtin_fma(v1, v11, v18);
    const double v21 = __builtin_fma(v1, v19, 0x1.27d27d27d27a5p-4);
    const double v23 = __builtin_fma(v21, v1, (-0x1.5555555555555p-2));
    const double v25 = __builtin_fma(v23, v1, 0x1.5555555555555p-1);
    const double v26 = 0x1.5555555555555p-1 - v25;
    const double v27 = __builtin_fma(v23, v1, v26);
    const double v28 = (-0x1.5555555555555p-2) - v23;
    const double v29 = __builtin_fma(v21, v1, v28);
    const double v31 = v27 + 0x1.5555555555555p-55;
    const double v32 = __builtin_fma(v1, v29, v31);
    const double v35 = __builtin_fma(0x1.0000000000000p+1, v25, (-0x1.5555555555555p-1));
    const double v36 = __builtin_fma(v2, v28, v35);
    const double v37 = v1 * v25;
    const double v38 = -v37;
    const double v39 = __builtin_fma(v1, v25, v38);
    const double v40 = __builtin_fma(v3, v36, v39);
    const double v41 = __builtin_fma(v1, v32, v40);
    const double v42 = alpha * v41;
    const double v43 = __builtin_fma(alpha, v37, v42);
    const double v45 = 0x1.921fb54442d18p+0 - alpha;
    const double v46 = v45 * v45;
    const double v49 = __builtin_fma(0x1.67d5c86be4eaap-22, v46, (-0x1.32bd95a55a9c6p-17));
    const double v51 = __builtin_fma(v49, v46, 0x1.83ca9db1c8d33p-13);
    const double v53 = __builtin_fma(v51, v46, (-0x1.637e0a0dbbf96p-9));
    const double v55 = __builtin_fma(v53, v46, 0x1.bc8bc8bc177d0p-6);
    const double v57 = __builtin_fma(v55, v46, (-0x1.5b05b05b057bfp-3));
    const double v59 = __builtin_fma(v57, v46, 0x1.2aaaaaaaaaab3p-1);
    const double v60 = v46 * v46;
    const double v63 = __builtin_fma(v45, (-0x1.1a62633145c07p-53), (-0x1.5555555555556p-54));
    const double v64 = __builtin_fma(v60, v59, v63);
    const double v67 = __builtin_fma(v45, (-0x1.0000000000000p+0), 0x1.0000000000000p-1);
    const double v68 = __builtin_fma(v45, v67, v64);
    const double v69 = 0x1.0000000000000p-1 * alpha;
    const double v71 = v69 + (-0x1.e652ff776be10p-4);
    const double v72 = v71 + v68;
    const int v74 = alpha < 0x1.23d70a3d70a3dp+0;
    const double v75 = v74 ? v43 : v72;
    return v75;
}
#define weight_moment_amplitude_best_fused_KIND pieces
#define weight_moment_amplitude_best_fused_BELOW_double UINT64_C(0x3ff23d70a3d70a3c)
#define weight_moment_amplitude_best_fused_BELOW_float UINT32_C(0x3f91eb85)
INLINE double weight_moment_amplitude_best_fused_below(double alpha)
{
    const double v1 = alpha * alpha;
    const double v2 = -v1;
    const double v3 = __builtin_fma(alpha, alpha, v2);
    const double v4 = v1 * v1;
    const double v7 = __builtin_fma(0x1.30e9ff831c7c7p-41, v4, 0x1.b59da2f914bb4p-30);
    const double v9 = __builtin_fma(v7, v4, 0x1.eaeaa2cd96bc4p-20);
    const double v11 = __builtin_fma(v9, v4, 0x1.83c8978ec53afp-11);
    const double v14 = __builtin_fma((-0x1.2a4e8655ba3f6p-35), v4, (-0x1.03e52c1c9f8cfp-24));
    const double v16 = __builtin_fma(v14, v4, (-0x1.65f59e30b1564p-15));
    const double v18 = __builtin_fma(v16, v4, (-0x1.282ef4b666c9dp-7));
    const double v19 = __builtin_fma(v1, v11, v18);
    const double v21 = __builtin_fma(v1, v19, 0x1.27d27d27d27a5p-4);
    const double v23 = __builtin_fma(v21, v1, (-0x1.5555555555555p-2));
    const double v25 = __builtin_fma(v23, v1, 0x1.5555555555555p-1);
    const double v26 = 0x1.5555555555555p-1 - v25;
    const double v27 = __builtin_fma(v23, v1, v26);
    const double v28 = (-0x1.5555555555555p-2) - v23;
    const double v29 = __builtin_fma(v21, v1, v28);
    const double v31 = v27 + 0x1.5555555555555p-55;
    const double v32 = __builtin_fma(v1, v29, v31);
    const double v35 = __builtin_fma(0x1.0000000000000p+1, v25, (-0x1.5555555555555p-1));
    const double v36 = __builtin_fma(v2, v28, v35);
    const double v37 = v1 * v25;
    const double v38 = -v37;
    const double v39 = __builtin_fma(v1, v25, v38);
    const double v40 = __builtin_fma(v3, v36, v39);
    const double v41 = __builtin_fma(v1, v32, v40);
    const double v42 = alpha * v41;
    const double v43 = __builtin_fma(alpha, v37, v42);
    return v43;
}

INLINE double weight_moment_amplitude_1e_10_fused(double alpha)
{
    const double v1 = alpha * alpha;
    const double v4 = __builtin_fma(0x1.55b68304dda03p-30, v1, (-0x1.f9e9d8d248bfcp-25));
    const double v6 = __builtin_fma(v4, v1, 0x1.e9ce55f457fb1p-20);
    const double v8 = __builtin_fma(v6, v1, (-0x1.65e8281936887p-15));
    const double v10 = __builtin_fma(v8, v1, 0x1.83c7d5627d1d1p-11);
    const double v12 = __builtin_fma(v10, v1, (-0x1.282eee7b92cf7p-7));
    const double v14 = __builtin_fma(v12, v1, 0x1.27d27cf3b8112p-4);
    const double v16 = __builtin_fma(v14, v1, (-0x1.55555553fea4bp-2));
    const double v18 = __builtin_fma(v16, v1, 0x1.555555555259dp-1);
    const double v19 = v18 * v1;
    const double v20 = v19 * alpha;
    return v20;
}
#define weight_moment_amplitude_1e_10_fused_KIND short

INLINE double weight_moment_amplitude_1e_6_fused(double alpha)
{
    const double v1 = alpha * alpha;
    const double v4 = __builtin_fma((-0x1.ff7dbdabc38e7p-16), v1, 0x1.71e62473ed8bap-11);
    const double v6 = __builtin_fma(v4, v1, (-0x1.26ad631e2f9a1p-7));
    const double v8 = __builtin_fma(v6, v1, 0x1.27b41ec7abd41p-4);
    const double v10 = __builtin_fma(v8, v1, (-0x1.555382cc0e3b7p-2));
    const double v12 = __builtin_fma(v10, v1, 0x1.55554ba99af07p-1);
    const double v13 = v12 * v1;
    const double v14 = v13 * alpha;
    return v14;
}
#define weight_moment_amplitude_1e_6_fused_KIND short

INLINE double weight_moment_amplitude_float32_fused(double alpha)
{
    const double v1 = alpha * alpha;
    const double v4 = __builtin_fma((-0x1.8c2a65eb3fec2p-25), v1, 0x1.db665517a168ep-20);
    const double v6 = __builtin_fma(v4, v1, (-0x1.64ea296a14023p-15));
    const double v8 = __builtin_fma(v6, v1, 0x1.83b443c4ba8e3p-11);
    const double v10 = __builtin_fma(v8, v1, (-0x1.282e1a3d0c0eep-7));
    const double v12 = __builtin_fma(v10, v1, 0x1.27d273f81480bp-4);
    const double v14 = __builtin_fma(v12, v1, (-0x1.555555080b38cp-2));
    const double v16 = __builtin_fma(v14, v1, 0x1.5555555478204p-1);
    const double v17 = v16 * v1;
    const double v18 = v17 * alpha;
    return v18;
}
#define weight_moment_amplitude_float32_fused_KIND short

INLINE double resistance_factor_best_fused(double alpha)
{
    const double v1 = alpha * alpha;
    const double v2 = -v1;
    const double v3 = __builtin_fma(alpha, alpha, v2);
    const double v4 = v1 * v1;
    const double v7 = __builtin_fma(0x1.5aeb95ee17e27p-52, v4, 0x1.93966653151c3p-36);
    const double v9 = __builtin_fma(v7, v4, 0x1.27e4fb7471f25p-21);
    const double v12 = __builtin_fma((-0x1.ae33aea2b0d55p-44), v4, (-0x1.1eed8d7449e95p-28));
    const double v14 = __builtin_fma(v12, v4, (-0x1.a01a01a0132c2p-15));
    const double v15 = __builtin_fma(v1, v9, v14);
    const double v17 = __builtin_fma(v1, v15, 0x1.6c16c16c16ba2p-9);
    const double v19 = __builtin_fma(v17, v1, (-0x1.5555555555555p-4));
    const double v21 = __builtin_fma(v19, v1, 0x1.0000000000000p+0);
    const double v22 = 0x1.0000000000000p+0 - v21;
    const double v23 = __builtin_fma(v19, v1, v22);
    const double v24 = (-0x1.5555555555555p-4) - v19;
    const double v25 = __builtin_fma(v17, v1, v24);
    const double v26 = __builtin_fma(v1, v25, v23);
    const double v27 = v1 * v21;
    const double v28 = -v27;
    const double v29 = __builtin_fma(v1, v21, v28);
    const double v30 = __builtin_fma(v3, v21, v29);
    const double v31 = __builtin_fma(v1, v26, v30);
    const double v32 = alpha * v31;
    const double v33 = __builtin_fma(alpha, v27, v32);
    return v33;
}
#define resistance_factor_best_fused_KIND whole

INLINE double resistance_factor_1e_10_fused(double alpha)
{
    const double v1 = alpha * alpha;
    const double v4 = __builtin_fma((-0x1.1363823d24666p-28), v1, 0x1.27a4afc560ce7p-21);
    const double v6 = __builtin_fma(v4, v1, (-0x1.a018b5707a92dp-15));
    const double v8 = __builtin_fma(v6, v1, 0x1.6c16be606925bp-9);
    const double v10 = __builtin_fma(v8, v1, (-0x1.55555550127aap-4));
    const double v12 = __builtin_fma(v10, v1, 0x1.fffffffffa0fbp-1);
    const double v13 = v12 * v1;
    const double v14 = v13 * alpha;
    return v14;
}
#define resistance_factor_1e_10_fused_KIND short

INLINE double resistance_factor_1e_6_fused(double alpha)
{
    const double v1 = alpha * alpha;
    const double v4 = __builtin_fma((-0x1.899d6d596ca14p-15), v1, 0x1.6b8afbde89795p-9);
    const double v6 = __builtin_fma(v4, v1, (-0x1.5553226831932p-4));
    const double v8 = __builtin_fma(v6, v1, 0x1.fffffa5b957a5p-1);
    const double v9 = v8 * v1;
    const double v10 = v9 * alpha;
    return v10;
}
#define resistance_factor_1e_6_fused_KIND short

INLINE double resistance_factor_float32_fused(double alpha)
{
    const double v1 = alpha * alpha;
    const double v4 = __builtin_fma((-0x1.1363823d24666p-28), v1, 0x1.27a4afc560ce7p-21);
    const double v6 = __builtin_fma(v4, v1, (-0x1.a018b5707a92dp-15));
    const double v8 = __builtin_fma(v6, v1, 0x1.6c16be606925bp-9);
    const double v10 = __builtin_fma(v8, v1, (-0x1.55555550127aap-4));
    const double v12 = __builtin_fma(v10, v1, 0x1.fffffffffa0fbp-1);
    const double v13 = v12 * v1;
    const double v14 = v13 * alpha;
    return v14;
}
#define resistance_factor_float32_fused_KIND short

INLINE double dynamic_coefficient_best_fused(double alpha)
{
    const double v1 = alpha * alpha;
    const double v2 = v1 * v1;
    const double v5 = __builtin_fma(0x1.5a4eb8d4fdf16p-30, v2, 0x1.1cf83c1392ee5p-27);
    const double v7 = __builtin_fma(v5, v2, 0x1.20dc3d60db7aap-25);
    const double v9 = __builtin_fma(v7, v2, 0x1.f97dd8a440e49p-20);
    const double v11 = __builtin_fma(v9, v2, 0x1.35581eb7b9c4ep-11);
    const double v14 = __builtin_fma((-0x1.a3e7d0b8cee94p-29), v2, 0x1.372e5bb516f5ap-30);
    const double v16 = __builtin_fma(v14, v2, 0x1.ffc5bb85d3a0bp-25);
    const double v18 = __builtin_fma(v16, v2, (-0x1.08db8c9edc7c7p-15));
    const double v20 = __builtin_fma(v18, v2, (-0x1.ce55c8ec1b57ap-8));
    const double v21 = __builtin_fma(v1, v11, v20);
    const double v23 = __builtin_fma(v1, v21, 0x1.d41d41d41edeap-5);
    const double v25 = __builtin_fma(v23, v1, (-0x1.111111111111cp-2));
    const double v27 = __builtin_fma(v25, v1, 0x1.5555555555555p-1);
    const double v28 = 0x1.5555555555555p-1 - v27;
    const double v29 = __builtin_fma(v25, v1, v28);
    const double v30 = (-0x1.111111111111cp-2) - v25;
    const double v31 = __builtin_fma(v23, v1, v30);
    const double v33 = v29 + 0x1.5555555555555p-55;
    const double v34 = __builtin_fma(v1, v31, v33);
    const double v35 = -v1;
    const double v37 = __builtin_fma(alpha, alpha, v35);
    const double v38 = __builtin_fma(v37, v25, v34);
    const double v40 = 0x1.921fb54442d18p+0 - alpha;
    const double v41 = v40 * v40;
    const double v44 = __builtin_fma(0x1.1477caa143cfbp-15, v41, (-0x1.058aebdba383ap-11));
    const double v46 = __builtin_fma(v44, v41, 0x1.556ffb39c3af9p-8);
    const double v48 = __builtin_fma(v46, v41, (-0x1.0ee086df8c2f9p-5));
    const double v50 = __builtin_fma(v48, v41, 0x1.94ebfbb2ec66fp-4);
    const double v52 = __builtin_fma(v50, v41, (-0x1.213ce230290f3p-7));
    const double v55 = __builtin_fma((-0x1.b16de590ed744p-16), v41, 0x1.80dce9acbd0ffp-12);
    const double v57 = __builtin_fma(v55, v41, (-0x1.2834e1f3e1a60p-8));
    const double v59 = __builtin_fma(v57, v41, 0x1.27d279e0496b5p-5);
    const double v61 = __builtin_fma(v59, v41, (-0x1.555555518e7c3p-3));
    const double v63 = __builtin_fma(v61, v41, 0x1.55555555579d1p-2);
    const double v65 = v40 > 0x1.0000000000000p-60 ? v40 : 0x1.0000000000000p-60;
    const double v66 = significand_of(v65);
    const double v68 = v66 - 0x1.0000000000000p+0;
    const double v69 = v68 + 0x1.0000000000000p+1;
    const double v70 = v68 / v69;
    const double v71 = v70 * v70;
    const double v74 = __builtin_fma(0x1.3cda08c7927d8p-3, v71, 0x1.3804595ac79edp-3);
    const double v76 = __builtin_fma(v74, v71, 0x1.747966b22b47ep-3);
    const double v78 = __builtin_fma(v76, v71, 0x1.c71be01ef8d7bp-3);
    const double v80 = __builtin_fma(v78, v71, 0x1.249249f1b0e53p-2);
    const double v82 = __builtin_fma(v80, v71, 0x1.999999987c7a3p-2);
    const double v84 = __builtin_fma(v82, v71, 0x1.55555555559d8p-1);
    const double v85 = -v68;
    const double v86 = __builtin_fma(v71, v84, v85);
    const double v87 = exponent_of(v65);
    const double v89 = __builtin_fma(v87, 0x1.62e42fefa39efp-1, v68);
    const double v90 = __builtin_fma(v70, v86, v89);
    const double v91 = __builtin_fma(v63, v90, v52);
    const double v92 = v40 * v41;
    const double v94 = __builtin_fma(v92, v91, 0x1.ee6913347c2a6p-55);
    const double v96 = alpha + (-0x1.0c152382d7366p-1);
    const double v97 = v96 + v94;
    const double v98 = v97 - v96;
    const double v99 = v94 - v98;
    const int v101 = alpha < 0x1.dc28f5c28f5c3p-1;
    const double v102 = v101 ? v27 : v97;
    const double v103 = v101 ? v38 : v99;
    const double v106 = __builtin_fma(0x1.5aeb95ee17e27p-52, v2, 0x1.93966653151c3p-36);
    const double v108 = __builtin_fma(v106, v2, 0x1.27e4fb7471f25p-21);
    const double v111 = __builtin_fma((-0x1.ae33aea2b0d55p-44), v2, (-0x1.1eed8d7449e95p-28));
    const double v113 = __builtin_fma(v111, v2, (-0x1.a01a01a0132c2p-15));
    const double v114 = __builtin_fma(v1, v108, v113);
    const double v116 = __builtin_fma(v1, v114, 0x1.6c16c16c16ba2p-9);
    const double v118 = __builtin_fma(v116, v1, (-0x1.5555555555555p-4));
    const double v119 = __builtin_fma(v118, v1, 0x1.0000000000000p+0);
    const double v120 = 0x1.0000000000000p+0 - v119;
    const double v121 = __builtin_fma(v118, v1, v120);
    const double v122 = (-0x1.5555555555555p-4) - v118;
    const double v123 = __builtin_fma(v116, v1, v122);
    const double v124 = __builtin_fma(v1, v123, v121);
    const double v125 = __builtin_fma(v37, v118, v124);
    const double v126 = v1 * v119;
    const double v127 = -v126;
    const double v128 = __builtin_fma(v1, v119, v127);
    const double v129 = __builtin_fma(v37, v119, v128);
    const double v130 = __builtin_fma(v1, v124, v129);
    const double v131 = alpha * v126;
    const double v132 = -v131;
    const double v133 = __builtin_fma(alpha, v126, v132);
    const double v134 = __builtin_fma(alpha, v130, v133);
    const double v135 = v101 ? v119 : v131;
    const double v136 = v101 ? v125 : v134;
    const double v137 = 0x1.0000000000000p+0 / v135;
    const double v138 = v102 * v137;
    const double v139 = -v138;
    const double v140 = __builtin_fma(v139, v135, v102);
    const double v141 = v140 + v103;
    const double v142 = __builtin_fma(v139, v136, v141);
    const double v143 = __builtin_fma(v142, v137, v138);
    return v143;
}
#define dynamic_coefficient_best_fused_KIND whole

INLINE double weight_moment_per_inertia_best_fused(double alpha)
{
    const double v1 = alpha * alpha;
    const double v2 = v1 * v1;
    const double v5 = __builtin_fma(0x1.198f4c366985bp-41, v2, 0x1.b581dfc3b96a5p-30);
    const double v7 = __builtin_fma(v5, v2, 0x1.eaea9e0178a1ap-20);
    const double v9 = __builtin_fma(v7, v2, 0x1.83c8978e93394p-11);
    const double v12 = __builtin_fma((-0x1.28918aeb0ff45p-35), v2, (-0x1.03e4b3b320f82p-24));
    const double v14 = __builtin_fma(v12, v2, (-0x1.65f59e222b2a7p-15));
    const double v16 = __builtin_fma(v14, v2, (-0x1.282ef4b66672dp-7));
    const double v17 = __builtin_fma(v1, v9, v16);
    const double v19 = __builtin_fma(v1, v17, 0x1.27d27d27d279ep-4);
    const double v21 = __builtin_fma(v19, v1, (-0x1.5555555555555p-2));
    const double v23 = __builtin_fma(v21, v1, 0x1.5555555555555p-1);
    const double v24 = 0x1.5555555555555p-1 - v23;
    const double v25 = __builtin_fma(v21, v1, v24);
    const double v26 = (-0x1.5555555555555p-2) - v21;
    const double v27 = __builtin_fma(v19, v1, v26);
    const double v29 = v25 + 0x1.5555555555555p-55;
    const double v30 = __builtin_fma(v1, v27, v29);
    const double v31 = -v1;
    const double v32 = __builtin_fma(alpha, alpha, v31);
    const double v33 = __builtin_fma(v32, v21, v30);
    const double v35 = 0x1.921fb54442d18p+0 - alpha;
    const double v36 = v35 * v35;
    const double v39 = __builtin_fma(0x1.6115c92e5be46p-22, v36, (-0x1.328c51a4a2552p-17));
    const double v41 = __builtin_fma(v39, v36, 0x1.83c977d2eae41p-13);
    const double v43 = __builtin_fma(v41, v36, (-0x1.637e0682f503fp-9));
    const double v45 = __builtin_fma(v43, v36, 0x1.bc8bc8b057e9ep-6);
    const double v47 = __builtin_fma(v45, v36, (-0x1.5b05b05af2089p-3));
    const double v49 = __builtin_fma(v47, v36, 0x1.2aaaaaaaaa92dp-1);
    const double v50 = v36 * v36;
    const double v53 = __builtin_fma(v35, (-0x1.1a62633145c07p-53), (-0x1.5555555555556p-54));
    const double v54 = __builtin_fma(v50, v49, v53);
    const double v57 = __builtin_fma(v35, (-0x1.0000000000000p+0), 0x1.0000000000000p-1);
    const double v58 = __builtin_fma(v35, v57, v54);
    const double v59 = 0x1.0000000000000p-1 * alpha;
    const double v61 = v59 + (-0x1.e652ff776be10p-4);
    const double v62 = v61 + v58;
    const double v63 = v62 - v61;
    const double v64 = v58 - v63;
    const int v66 = alpha < 0x1.0000000000000p+0;
    const double v67 = v66 ? v23 : v62;
    const double v68 = v66 ? v33 : v64;
    const double v71 = __builtin_fma(0x1.f3cdbf532eaf7p-34, v2, 0x1.9465eeb660151p-24);
    const double v73 = __builtin_fma(v71, v2, 0x1.1f0877c40acffp-15);
    const double v75 = __builtin_fma(v73, v2, 0x1.1f7d05c72fc3ap-8);
    const double v78 = __builtin_fma((-0x1.91e6b7ad796a6p-39), v2, (-0x1.ed2a462794ae8p-29));
    const double v80 = __builtin_fma(v78, v2, (-0x1.0e1fd712de8dbp-19));
    const double v82 = __builtin_fma(v80, v2, (-0x1.d71607bd2727dp-12));
    const double v84 = __builtin_fma(v82, v2, (-0x1.f1029e62cad66p-6));
    const double v85 = __builtin_fma(v1, v75, v84);
    const double v87 = __builtin_fma(v1, v85, 0x1.1e11e11e11e36p-3);
    const double v89 = __builtin_fma(v87, v1, (-0x1.999999999999ap-2));
    const double v90 = __builtin_fma(v89, v1, 0x1.5555555555555p-1);
    const double v91 = 0x1.5555555555555p-1 - v90;
    const double v92 = __builtin_fma(v89, v1, v91);
    const double v93 = (-0x1.999999999999ap-2) - v89;
    const double v94 = __builtin_fma(v87, v1, v93);
    const double v95 = v92 + 0x1.5555555555555p-55;
    const double v96 = __builtin_fma(v1, v94, v95);
    const double v97 = __builtin_fma(v32, v89, v96);
    const double v100 = __builtin_fma((-0x1.00589fe65ed98p-23), v36, 0x1.1425220d45aaap-19);
    const double v102 = __builtin_fma(v100, v36, (-0x1.1f397f95f7403p-15));
    const double v104 = __builtin_fma(v102, v36, 0x1.d6a371cc475cdp-12);
    const double v106 = __builtin_fma(v104, v36, (-0x1.1e5e23528aa32p-8));
    const double v108 = __builtin_fma(v106, v36, 0x1.e94dfd8b6e6d2p-6);
    const double v110 = __builtin_fma(v108, v36, (-0x1.0cbb76630619cp-3));
    const double v112 = __builtin_fma(v110, v36, 0x1.3e93e93e9959dp-2);
    const double v114 = __builtin_fma(v112, v36, (-0x1.c71c71c71cad2p-3));
    const double v116 = __builtin_fma(v114, v36, (-0x1.555555555554ep-3));
    const double v118 = __builtin_fma(v35, v116, 0x1.dffffffffffffp-4);
    const double v120 = v59 + (-0x1.e000000000000p-4);
    const double v121 = v120 + v118;
    const double v122 = v121 - v120;
    const double v123 = v118 - v122;
    const double v124 = v66 ? v90 : v121;
    const double v125 = v66 ? v97 : v123;
    const double v126 = 0x1.0000000000000p+0 / v124;
    const double v127 = v67 * v126;
    const double v128 = -v127;
    const double v129 = __builtin_fma(v128, v124, v67);
    const double v130 = v129 + v68;
    const double v131 = __builtin_fma(v128, v125, v130);
    const double v132 = __builtin_fma(v131, v126, v127);
    return v132;
}
#define weight_moment_per_inertia_best_fused_KIND whole

INLINE double radial_weight_per_inertia_best_fused(double alpha)
{
    const double v1 = alpha * alpha;
    const double v2 = v1 * v1;
    const double v5 = __builtin_fma((-0x1.86ec1a4714bc6p-30), v2, (-0x1.e8d88b74942f1p-26));
    const double v7 = __builtin_fma(v5, v2, (-0x1.41e50fe69bac0p-24));
    const double v9 = __builtin_fma(v7, v2, (-0x1.420eb51f67a97p-24));
    const double v11 = __builtin_fma(v9, v2, (-0x1.52a8b7fb58b0bp-22));
    const double v13 = __builtin_fma(v11, v2, (-0x1.0156717ae6a98p-18));
    const double v15 = __builtin_fma(v13, v2, (-0x1.47d6743d1ab96p-16));
    const double v18 = __builtin_fma(0x1.315a59a2eff33p-27, v2, 0x1.cd1ef3b3ed5bdp-25);
    const double v20 = __builtin_fma(v18, v2, 0x1.fdf00b464f2acp-25);
    const double v22 = __builtin_fma(v20, v2, (-0x1.20b66585c3299p-24));
    const double v24 = __builtin_fma(v22, v2, (-0x1.1d1cbe50df456p-20));
    const double v26 = __builtin_fma(v24, v2, (-0x1.07d7aa081f5bbp-16));
    const double v28 = __builtin_fma(v26, v2, (-0x1.664f48816cbcep-10));
    const double v29 = __builtin_fma(v1, v15, v28);
    const double v31 = __builtin_fma(v1, v29, 0x1.2b12b12b1221bp-6);
    const double v33 = __builtin_fma(v31, v1, (-0x1.9999999999997p-3));
    const double v35 = __builtin_fma(v33, v1, 0x1.5555555555555p-1);
    const double v36 = 0x1.5555555555555p-1 - v35;
    const double v37 = __builtin_fma(v33, v1, v36);
    const double v38 = (-0x1.9999999999997p-3) - v33;
    const double v39 = __builtin_fma(v31, v1, v38);
    const double v41 = v37 + 0x1.5555555555555p-55;
    const double v42 = __builtin_fma(v1, v39, v41);
    const double v43 = -v1;
    const double v45 = __builtin_fma(alpha, alpha, v43);
    const double v46 = __builtin_fma(v45, v33, v42);
    const double v48 = 0x1.921fb54442d18p+0 - alpha;
    const double v49 = v48 * v48;
    const double v52 = __builtin_fma(0x1.7fcd25610a7bep-17, v49, (-0x1.5c240340d7499p-12));
    const double v54 = __builtin_fma(v52, v49, 0x1.c0f85bb0bd6d8p-8);
    const double v56 = __builtin_fma(v54, v49, (-0x1.5fec394ef3093p-4));
    const double v58 = __builtin_fma(v56, v49, 0x1.2c981ff52d6d6p-1);
    const double v60 = __builtin_fma(v58, v49, (-0x1.7217f7d1bdaacp-7));
    const double v63 = __builtin_fma((-0x1.49f6ab92b4903p-18), v49, 0x1.2705f10ad2bc9p-13);
    const double v65 = __builtin_fma(v63, v49, (-0x1.a01ba6f54a2d2p-9));
    const double v67 = __builtin_fma(v65, v49, 0x1.6c16c100ecd3dp-5);
    const double v69 = __builtin_fma(v67, v49, (-0x1.555555552b82cp-2));
    const double v71 = __builtin_fma(v69, v49, 0x1.00000000000d1p+0);
    const double v72 = 0x1.0000000000000p+1 * v48;
    const double v74 = v72 > 0x1.0000000000000p-60 ? v72 : 0x1.0000000000000p-60;
    const double v75 = significand_of(v74);
    const double v77 = v75 - 0x1.0000000000000p+0;
    const double v78 = v77 + 0x1.0000000000000p+1;
    const double v79 = v77 / v78;
    const double v80 = v79 * v79;
    const double v83 = __builtin_fma(0x1.3cda08c7927d8p-3, v80, 0x1.3804595ac79edp-3);
    const double v85 = __builtin_fma(v83, v80, 0x1.747966b22b47ep-3);
    const double v87 = __builtin_fma(v85, v80, 0x1.c71be01ef8d7bp-3);
    const double v89 = __builtin_fma(v87, v80, 0x1.249249f1b0e53p-2);
    const double v91 = __builtin_fma(v89, v80, 0x1.999999987c7a3p-2);
    const double v93 = __builtin_fma(v91, v80, 0x1.55555555559d8p-1);
    const double v94 = -v77;
    const double v95 = __builtin_fma(v80, v93, v94);
    const double v96 = exponent_of(v74);
    const double v98 = __builtin_fma(v96, 0x1.62e42fefa39efp-1, v77);
    const double v99 = __builtin_fma(v79, v95, v98);
    const double v100 = __builtin_fma(v71, v99, v60);
    const double v101 = v49 * v100;
    const double v103 = __builtin_fma(v48, (-0x1.e000000000000p+0), 0x1.0000000000000p+0);
    const double v104 = __builtin_fma(v48, v103, v101);
    const double v106 = alpha + (-0x1.243f6a8885a30p-1);
    const double v107 = v106 + v104;
    const double v108 = v107 - v106;
    const double v109 = v104 - v108;
    const int v111 = alpha < 0x1.07ae147ae147bp+0;
    const double v112 = v111 ? v35 : v107;
    const double v113 = v111 ? v46 : v109;
    const double v116 = __builtin_fma(0x1.01b1332b9b1d7p-41, v2, 0x1.090c1fc3ba5d2p-33);
    const double v118 = __builtin_fma(v116, v2, 0x1.947001eb768c8p-24);
    const double v120 = __builtin_fma(v118, v2, 0x1.1f0878ebd4d43p-15);
    const double v122 = __builtin_fma(v120, v2, 0x1.1f7d05c744f00p-8);
    const double v125 = __builtin_fma((-0x1.8673117c84002p-38), v2, (-0x1.ee8b4e839c601p-29));
    const double v127 = __builtin_fma(v125, v2, (-0x1.0e2006e773ecdp-19));
    const double v129 = __builtin_fma(v127, v2, (-0x1.d71607c637a7bp-12));
    const double v131 = __builtin_fma(v129, v2, (-0x1.f1029e62cb3ddp-6));
    const double v132 = __builtin_fma(v1, v122, v131);
    const double v134 = __builtin_fma(v1, v132, 0x1.1e11e11e11e3cp-3);
    const double v136 = __builtin_fma(v134, v1, (-0x1.999999999999ap-2));
    const double v137 = __builtin_fma(v136, v1, 0x1.5555555555555p-1);
    const double v138 = 0x1.5555555555555p-1 - v137;
    const double v139 = __builtin_fma(v136, v1, v138);
    const double v140 = (-0x1.999999999999ap-2) - v136;
    const double v141 = __builtin_fma(v134, v1, v140);
    const double v142 = v139 + 0x1.5555555555555p-55;
    const double v143 = __builtin_fma(v1, v141, v142);
    const double v144 = __builtin_fma(v45, v136, v143);
    const double v147 = __builtin_fma((-0x1.6de90fa3c36d1p-23), v49, 0x1.1d2bdb6e180adp-19);
    const double v149 = __builtin_fma(v147, v49, (-0x1.1f88aff83463bp-15));
    const double v151 = __builtin_fma(v149, v49, 0x1.d6a65d5d8efd9p-12);
    const double v153 = __builtin_fma(v151, v49, (-0x1.1e5e2b53ee8f7p-8));
    const double v155 = __builtin_fma(v153, v49, 0x1.e94dfdbeb29efp-6);
    const double v157 = __builtin_fma(v155, v49, (-0x1.0cbb76636144ep-3));
    const double v159 = __builtin_fma(v157, v49, 0x1.3e93e93e9a95cp-2);
    const double v161 = __builtin_fma(v159, v49, (-0x1.c71c71c71cb31p-3));
    const double v163 = __builtin_fma(v161, v49, (-0x1.555555555554ep-3));
    const double v165 = __builtin_fma(v48, v163, 0x1.dffffffffffffp-4);
    const double v167 = 0x1.0000000000000p-1 * alpha;
    const double v169 = v167 + (-0x1.e000000000000p-4);
    const double v170 = v169 + v165;
    const double v171 = v170 - v169;
    const double v172 = v165 - v171;
    const double v173 = v111 ? v137 : v170;
    const double v174 = v111 ? v144 : v172;
    const double v175 = 0x1.0000000000000p+0 / v173;
    const double v176 = v112 * v175;
    const double v177 = -v176;
    const double v178 = __builtin_fma(v177, v173, v112);
    const double v179 = v178 + v113;
    const double v180 = __builtin_fma(v177, v174, v179);
    const double v181 = __builtin_fma(v180, v175, v176);
    return v181;
}
#define radial_weight_per_inertia_best_fused_KIND whole

INLINE double polar_moment_per_inertia_best_fused(double alpha)
{
    const double v1 = alpha * alpha;
    const double v2 = v1 * v1;
    const double v5 = __builtin_fma(0x1.26891cd0b9c00p-32, v2, 0x1.bb4feae5283ecp-29);
    const double v7 = __builtin_fma(v5, v2, 0x1.cd171a110ec19p-28);
    const double v9 = __builtin_fma(v7, v2, 0x1.09bc1bebcf001p-25);
    const double v11 = __builtin_fma(v9, v2, 0x1.f95e135afe164p-20);
    const double v13 = __builtin_fma(v11, v2, 0x1.35581e41e77abp-11);
    const double v16 = __builtin_fma((-0x1.4871de51476c6p-30), v2, (-0x1.10fbc686826eep-28));
    const double v18 = __builtin_fma(v16, v2, 0x1.25925bb16d77dp-28);
    const double v20 = __builtin_fma(v18, v2, 0x1.05db2a1cb81a5p-24);
    const double v22 = __builtin_fma(v20, v2, (-0x1.08db55ee7d9b2p-15));
    const double v24 = __builtin_fma(v22, v2, (-0x1.ce55c8eaf4bc9p-8));
    const double v25 = __builtin_fma(v1, v13, v24);
    const double v27 = __builtin_fma(v1, v25, 0x1.d41d41d41d6efp-5);
    const double v29 = __builtin_fma(v27, v1, (-0x1.1111111111112p-2));
    const double v31 = __builtin_fma(v29, v1, 0x1.5555555555555p-1);
    const double v32 = 0x1.5555555555555p-1 - v31;
    const double v33 = __builtin_fma(v29, v1, v32);
    const double v34 = (-0x1.1111111111112p-2) - v29;
    const double v35 = __builtin_fma(v27, v1, v34);
    const double v37 = v33 + 0x1.5555555555555p-55;
    const double v38 = __builtin_fma(v1, v35, v37);
    const double v39 = -v1;
    const double v41 = __builtin_fma(alpha, alpha, v39);
    const double v42 = __builtin_fma(v41, v29, v38);
    const double v44 = 0x1.921fb54442d18p+0 - alpha;
    const double v45 = v44 * v44;
    const double v48 = __builtin_fma(0x1.15ac79423b8b0p-15, v45, (-0x1.0589062751e4cp-11));
    const double v50 = __builtin_fma(v48, v45, 0x1.556dc54d73912p-8);
    const double v52 = __builtin_fma(v50, v45, (-0x1.0ee09496505b1p-5));
    const double v54 = __builtin_fma(v52, v45, 0x1.94ebfb7c3ce42p-4);
    const double v56 = __builtin_fma(v54, v45, (-0x1.213ce231c73c8p-7));
    const double v59 = __builtin_fma((-0x1.b34a574a5ccacp-16), v45, 0x1.807b27aa47e52p-12);
    const double v61 = __builtin_fma(v59, v45, (-0x1.2837b580b3980p-8));
    const double v63 = __builtin_fma(v61, v45, 0x1.27d270f96a29bp-5);
    const double v65 = __builtin_fma(v63, v45, (-0x1.5555555ce08d5p-3));
    const double v67 = __builtin_fma(v65, v45, 0x1.555555555434bp-2);
    const double v69 = v44 > 0x1.0000000000000p-60 ? v44 : 0x1.0000000000000p-60;
    const double v70 = significand_of(v69);
    const double v72 = v70 - 0x1.0000000000000p+0;
    const double v73 = v72 + 0x1.0000000000000p+1;
    const double v74 = v72 / v73;
    const double v75 = v74 * v74;
    const double v78 = __builtin_fma(0x1.3cda08c7927d8p-3, v75, 0x1.3804595ac79edp-3);
    const double v80 = __builtin_fma(v78, v75, 0x1.747966b22b47ep-3);
    const double v82 = __builtin_fma(v80, v75, 0x1.c71be01ef8d7bp-3);
    const double v84 = __builtin_fma(v82, v75, 0x1.249249f1b0e53p-2);
    const double v86 = __builtin_fma(v84, v75, 0x1.999999987c7a3p-2);
    const double v88 = __builtin_fma(v86, v75, 0x1.55555555559d8p-1);
    const double v89 = -v72;
    const double v90 = __builtin_fma(v75, v88, v89);
    const double v91 = exponent_of(v69);
    const double v93 = __builtin_fma(v91, 0x1.62e42fefa39efp-1, v72);
    const double v94 = __builtin_fma(v74, v90, v93);
    const double v95 = __builtin_fma(v67, v94, v56);
    const double v96 = v44 * v45;
    const double v98 = __builtin_fma(v96, v95, 0x1.ee6913347c2a6p-55);
    const double v100 = alpha + (-0x1.0c152382d7366p-1);
    const double v101 = v100 + v98;
    const double v102 = v101 - v100;
    const double v103 = v98 - v102;
    const int v104 = alpha < 0x1.0000000000000p+0;
    const double v105 = v104 ? v31 : v101;
    const double v106 = v104 ? v42 : v103;
    const double v109 = __builtin_fma(0x1.f3cdbf532eaf7p-34, v2, 0x1.9465eeb660151p-24);
    const double v111 = __builtin_fma(v109, v2, 0x1.1f0877c40acffp-15);
    const double v113 = __builtin_fma(v111, v2, 0x1.1f7d05c72fc3ap-8);
    const double v116 = __builtin_fma((-0x1.91e6b7ad796a6p-39), v2, (-0x1.ed2a462794ae8p-29));
    const double v118 = __builtin_fma(v116, v2, (-0x1.0e1fd712de8dbp-19));
    const double v120 = __builtin_fma(v118, v2, (-0x1.d71607bd2727dp-12));
    const double v122 = __builtin_fma(v120, v2, (-0x1.f1029e62cad66p-6));
    const double v123 = __builtin_fma(v1, v113, v122);
    const double v125 = __builtin_fma(v1, v123, 0x1.1e11e11e11e36p-3);
    const double v127 = __builtin_fma(v125, v1, (-0x1.999999999999ap-2));
    const double v128 = __builtin_fma(v127, v1, 0x1.5555555555555p-1);
    const double v129 = 0x1.5555555555555p-1 - v128;
    const double v130 = __builtin_fma(v127, v1, v129);
    const double v131 = (-0x1.999999999999ap-2) - v127;
    const double v132 = __builtin_fma(v125, v1, v131);
    const double v133 = v130 + 0x1.5555555555555p-55;
    const double v134 = __builtin_fma(v1, v132, v133);
    const double v135 = __builtin_fma(v41, v127, v134);
    const double v138 = __builtin_fma((-0x1.00589fe65ed98p-23), v45, 0x1.1425220d45aaap-19);
    const double v140 = __builtin_fma(v138, v45, (-0x1.1f397f95f7403p-15));
    const double v142 = __builtin_fma(v140, v45, 0x1.d6a371cc475cdp-12);
    const double v144 = __builtin_fma(v142, v45, (-0x1.1e5e23528aa32p-8));
    const double v146 = __builtin_fma(v144, v45, 0x1.e94dfd8b6e6d2p-6);
    const double v148 = __builtin_fma(v146, v45, (-0x1.0cbb76630619cp-3));
    const double v150 = __builtin_fma(v148, v45, 0x1.3e93e93e9959dp-2);
    const double v152 = __builtin_fma(v150, v45, (-0x1.c71c71c71cad2p-3));
    const double v154 = __builtin_fma(v152, v45, (-0x1.555555555554ep-3));
    const double v156 = __builtin_fma(v44, v154, 0x1.dffffffffffffp-4);
    const double v158 = 0x1.0000000000000p-1 * alpha;
    const double v160 = v158 + (-0x1.e000000000000p-4);
    const double v161 = v160 + v156;
    const double v162 = v161 - v160;
    const double v163 = v156 - v162;
    const double v164 = v104 ? v128 : v161;
    const double v165 = v104 ? v135 : v163;
    const double v166 = 0x1.0000000000000p+0 / v164;
    const double v167 = v105 * v166;
    const double v168 = -v167;
    const double v169 = __builtin_fma(v168, v164, v105);
    const double v170 = v169 + v106;
    const double v171 = __builtin_fma(v168, v165, v170);
    const double v172 = __builtin_fma(v171, v166, v167);
    return v172;
}
#define polar_moment_per_inertia_best_fused_KIND whole

INLINE double weight_moment_per_radial_weight_best_fused(double alpha)
{
    const double v1 = alpha * alpha;
    const double v2 = v1 * v1;
    const double v5 = __builtin_fma(0x1.26910ad30ced0p-41, v2, 0x1.b5904f6877c6fp-30);
    const double v7 = __builtin_fma(v5, v2, 0x1.eaeaa0548de6dp-20);
    const double v9 = __builtin_fma(v7, v2, 0x1.83c8978ea9dfdp-11);
    const double v12 = __builtin_fma((-0x1.29811c85a203bp-35), v2, (-0x1.03e4f0243a4f9p-24));
    const double v14 = __builtin_fma(v12, v2, (-0x1.65f59e28f78f5p-15));
    const double v16 = __builtin_fma(v14, v2, (-0x1.282ef4b666991p-7));
    const double v17 = __builtin_fma(v1, v9, v16);
    const double v19 = __builtin_fma(v1, v17, 0x1.27d27d27d27a1p-4);
    const double v21 = __builtin_fma(v19, v1, (-0x1.5555555555555p-2));
    const double v23 = __builtin_fma(v21, v1, 0x1.5555555555555p-1);
    const double v24 = 0x1.5555555555555p-1 - v23;
    const double v25 = __builtin_fma(v21, v1, v24);
    const double v26 = (-0x1.5555555555555p-2) - v21;
    const double v27 = __builtin_fma(v19, v1, v26);
    const double v29 = v25 + 0x1.5555555555555p-55;
    const double v30 = __builtin_fma(v1, v27, v29);
    const double v31 = -v1;
    const double v33 = __builtin_fma(alpha, alpha, v31);
    const double v34 = __builtin_fma(v33, v21, v30);
    const double v36 = 0x1.921fb54442d18p+0 - alpha;
    const double v37 = v36 * v36;
    const double v40 = __builtin_fma(0x1.62a1ce00bcbbbp-22, v37, (-0x1.329a1a829faa0p-17));
    const double v42 = __builtin_fma(v40, v37, 0x1.83c9d9bc521a1p-13);
    const double v44 = __builtin_fma(v42, v37, (-0x1.637e07e2724b1p-9));
    const double v46 = __builtin_fma(v44, v37, 0x1.bc8bc8b5880b7p-6);
    const double v48 = __builtin_fma(v46, v37, (-0x1.5b05b05afba3bp-3));
    const double v50 = __builtin_fma(v48, v37, 0x1.2aaaaaaaaaa01p-1);
    const double v51 = v37 * v37;
    const double v54 = __builtin_fma(v36, (-0x1.1a62633145c07p-53), (-0x1.5555555555556p-54));
    const double v55 = __builtin_fma(v51, v50, v54);
    const double v58 = __builtin_fma(v36, (-0x1.0000000000000p+0), 0x1.0000000000000p-1);
    const double v59 = __builtin_fma(v36, v58, v55);
    const double v60 = 0x1.0000000000000p-1 * alpha;
    const double v62 = v60 + (-0x1.e652ff776be10p-4);
    const double v63 = v62 + v59;
    const double v64 = v63 - v62;
    const double v65 = v59 - v64;
    const int v67 = alpha < 0x1.07ae147ae147bp+0;
    const double v68 = v67 ? v23 : v63;
    const double v69 = v67 ? v34 : v65;
    const double v72 = __builtin_fma((-0x1.86ec1a4714bc6p-30), v2, (-0x1.e8d88b74942f1p-26));
    const double v74 = __builtin_fma(v72, v2, (-0x1.41e50fe69bac0p-24));
    const double v76 = __builtin_fma(v74, v2, (-0x1.420eb51f67a97p-24));
    const double v78 = __builtin_fma(v76, v2, (-0x1.52a8b7fb58b0bp-22));
    const double v80 = __builtin_fma(v78, v2, (-0x1.0156717ae6a98p-18));
    const double v82 = __builtin_fma(v80, v2, (-0x1.47d6743d1ab96p-16));
    const double v85 = __builtin_fma(0x1.315a59a2eff33p-27, v2, 0x1.cd1ef3b3ed5bdp-25);
    const double v87 = __builtin_fma(v85, v2, 0x1.fdf00b464f2acp-25);
    const double v89 = __builtin_fma(v87, v2, (-0x1.20b66585c3299p-24));
    const double v91 = __builtin_fma(v89, v2, (-0x1.1d1cbe50df456p-20));
    const double v93 = __builtin_fma(v91, v2, (-0x1.07d7aa081f5bbp-16));
    const double v95 = __builtin_fma(v93, v2, (-0x1.664f48816cbcep-10));
    const double v96 = __builtin_fma(v1, v82, v95);
    const double v98 = __builtin_fma(v1, v96, 0x1.2b12b12b1221bp-6);
    const double v100 = __builtin_fma(v98, v1, (-0x1.9999999999997p-3));
    const double v101 = __builtin_fma(v100, v1, 0x1.5555555555555p-1);
    const double v102 = 0x1.5555555555555p-1 - v101;
    const double v103 = __builtin_fma(v100, v1, v102);
    const double v104 = (-0x1.9999999999997p-3) - v100;
    const double v105 = __builtin_fma(v98, v1, v104);
    const double v106 = v103 + 0x1.5555555555555p-55;
    const double v107 = __builtin_fma(v1, v105, v106);
    const double v108 = __builtin_fma(v33, v100, v107);
    const double v111 = __builtin_fma(0x1.7fcd25610a7bep-17, v37, (-0x1.5c240340d7499p-12));
    const double v113 = __builtin_fma(v111, v37, 0x1.c0f85bb0bd6d8p-8);
    const double v115 = __builtin_fma(v113, v37, (-0x1.5fec394ef3093p-4));
    const double v117 = __builtin_fma(v115, v37, 0x1.2c981ff52d6d6p-1);
    const double v119 = __builtin_fma(v117, v37, (-0x1.7217f7d1bdaacp-7));
    const double v122 = __builtin_fma((-0x1.49f6ab92b4903p-18), v37, 0x1.2705f10ad2bc9p-13);
    const double v124 = __builtin_fma(v122, v37, (-0x1.a01ba6f54a2d2p-9));
    const double v126 = __builtin_fma(v124, v37, 0x1.6c16c100ecd3dp-5);
    const double v128 = __builtin_fma(v126, v37, (-0x1.555555552b82cp-2));
    const double v130 = __builtin_fma(v128, v37, 0x1.00000000000d1p+0);
    const double v131 = 0x1.0000000000000p+1 * v36;
    const double v133 = v131 > 0x1.0000000000000p-60 ? v131 : 0x1.0000000000000p-60;
    const double v134 = significand_of(v133);
    const double v136 = v134 - 0x1.0000000000000p+0;
    const double v137 = v136 + 0x1.0000000000000p+1;
    const double v138 = v136 / v137;
    const double v139 = v138 * v138;
    const double v142 = __builtin_fma(0x1.3cda08c7927d8p-3, v139, 0x1.3804595ac79edp-3);
    const double v144 = __builtin_fma(v142, v139, 0x1.747966b22b47ep-3);
    const double v146 = __builtin_fma(v144, v139, 0x1.c71be01ef8d7bp-3);
    const double v148 = __builtin_fma(v146, v139, 0x1.249249f1b0e53p-2);
    const double v150 = __builtin_fma(v148, v139, 0x1.999999987c7a3p-2);
    const double v152 = __builtin_fma(v150, v139, 0x1.55555555559d8p-1);
    const double v153 = -v136;
    const double v154 = __builtin_fma(v139, v152, v153);
    const double v155 = exponent_of(v133);
    const double v157 = __builtin_fma(v155, 0x1.62e42fefa39efp-1, v136);
    const double v158 = __builtin_fma(v138, v154, v157);
    const double v159 = __builtin_fma(v130, v158, v119);
    const double v160 = v37 * v159;
    const double v162 = __builtin_fma(v36, (-0x1.e000000000000p+0), 0x1.0000000000000p+0);
    const double v163 = __builtin_fma(v36, v162, v160);
    const double v165 = alpha + (-0x1.243f6a8885a30p-1);
    const double v166 = v165 + v163;
    const double v167 = v166 - v165;
    const double v168 = v163 - v167;
    const double v169 = v67 ? v101 : v166;
    const double v170 = v67 ? v108 : v168;
    const double v171 = 0x1.0000000000000p+0 / v169;
    const double v172 = v68 * v171;
    const double v173 = -v172;
    const double v174 = __builtin_fma(v173, v169, v68);
    const double v175 = v174 + v69;
    const double v176 = __builtin_fma(v173, v170, v175);
    const double v177 = __builtin_fma(v176, v171, v172);
    return v177;
}
#define weight_moment_per_radial_weight_best_fused_KIND whole
#endif

INLINE double polar_moment_best_plain(double alpha)
{
    const double v1 = alpha * alpha;
    const double v4 = 0x1.03ba64fc6390ep-29 * v1;
    const double v5 = v4 + (-0x1.3aec2023926f3p-28);
    const double v7 = v5 * v1;
    const double v8 = v7 + 0x1.ab724f22aa27ep-27;
    const double v10 = v8 * v1;
    const double v11 = v10 + 0x1.d2dbb0cb27f33p-30;
    const double v13 = v11 * v1;
    const double v14 = v13 + 0x1.b149c360dbe22p-25;
    const double v16 = v14 * v1;
    const double v17 = v16 + 0x1.7fd478253df46p-24;
    const double v19 = v17 * v1;
    const double v20 = v19 + 0x1.7b1e61f702731p-19;
    const double v22 = v20 * v1;
    const double v23 = v22 + (-0x1.8d4952ec3d425p-15);
    const double v25 = v23 * v1;
    const double v26 = v25 + 0x1.d0042e1391951p-11;
    const double v28 = v26 * v1;
    const double v29 = v28 + (-0x1.5ac056b1147acp-7);
    const double v31 = v29 * v1;
    const double v32 = v31 + 0x1.5f15f15f1726fp-4;
    const double v34 = v32 * v1;
    const double v35 = v34 + (-0x1.99999999999aap-2);
    const double v36 = v35 * v1;
    const double v37 = v1 * v36;
    const double v38 = v37 + v1;
    const double v40 = v38 / 0x1.8000000000000p+0;
    const double v41 = v40 * alpha;
    const double v43 = 0x1.921fb54442d18p+0 - alpha;
    const double v44 = v43 * v43;
    const double v47 = 0x1.1477caa143cfbp-15 * v44;
    const double v48 = v47 + (-0x1.058aebdba383ap-11);
    const double v50 = v48 * v44;
    const double v51 = v50 + 0x1.556ffb39c3af9p-8;
    const double v53 = v51 * v44;
    const double v54 = v53 + (-0x1.0ee086df8c2f9p-5);
    const double v56 = v54 * v44;
    const double v57 = v56 + 0x1.94ebfbb2ec66fp-4;
    const double v59 = v57 * v44;
    const double v60 = v59 + (-0x1.213ce230290f3p-7);
    const double v63 = (-0x1.b16de590ed744p-16) * v44;
    const double v64 = v63 + 0x1.80dce9acbd0ffp-12;
    const double v66 = v64 * v44;
    const double v67 = v66 + (-0x1.2834e1f3e1a60p-8);
    const double v69 = v67 * v44;
    const double v70 = v69 + 0x1.27d279e0496b5p-5;
    const double v72 = v70 * v44;
    const double v73 = v72 + (-0x1.555555518e7c3p-3);
    const double v75 = v73 * v44;
    const double v76 = v75 + 0x1.55555555579d1p-2;
    const double v78 = v43 > 0x1.0000000000000p-60 ? v43 : 0x1.0000000000000p-60;
    const double v79 = significand_of(v78);
    const double v81 = v79 - 0x1.0000000000000p+0;
    const double v83 = v81 + 0x1.0000000000000p+1;
    const double v84 = v81 / v83;
    const double v85 = v84 * v84;
    const double v88 = 0x1.3cda08c7927d8p-3 * v85;
    const double v89 = v88 + 0x1.3804595ac79edp-3;
    const double v91 = v89 * v85;
    const double v92 = v91 + 0x1.747966b22b47ep-3;
    const double v94 = v92 * v85;
    const double v95 = v94 + 0x1.c71be01ef8d7bp-3;
    const double v97 = v95 * v85;
    const double v98 = v97 + 0x1.249249f1b0e53p-2;
    const double v100 = v98 * v85;
    const double v101 = v100 + 0x1.999999987c7a3p-2;
    const double v103 = v101 * v85;
    const double v104 = v103 + 0x1.55555555559d8p-1;
    const double v105 = v85 * v104;
    const double v106 = v105 - v81;
    const double v107 = exponent_of(v78);
    const double v109 = v107 * 0x1.62e42fefa39efp-1;
    const double v110 = v109 + v81;
    const double v111 = v84 * v106;
    const double v112 = v111 + v110;
    const double v113 = v76 * v112;
    const double v114 = v113 + v60;
    const double v115 = v43 * v44;
    const double v117 = v115 * v114;
    const double v118 = v117 + 0x1.ee6913347c2a6p-55;
    const double v120 = alpha + (-0x1.0c152382d7366p-1);
    const double v121 = v120 + v118;
    const int v123 = alpha < 0x1.dc28f5c28f5c3p-1;
    const double v124 = v123 ? v41 : v121;
    return v124;
}
#define polar_moment_best_plain_KIND pieces
#define polar_moment_best_plain_BELOW_double UINT64_C(0x3fedc28f5c28f5c2)
#define polar_moment_best_plain_BELOW_float UINT32_C(0x3f6e147a)
INLINE double polar_moment_best_plain_below(double alpha)
{
    const double v1 = alpha * alpha;
    const double v4 = 0x1.03ba64fc6390ep-29 * v1;
    const double v5 = v4 + (-0x1.3aec2023926f3p-28);
    const double v7 = v5 * v1;
    const double v8 = v7 + 0x1.ab724f22aa27ep-27;
    const double v10 = v8 * v1;
    const double v11 = v10 + 0x1.d2dbb0cb27f33p-30;
    const double v13 = v11 * v1;
    const double v14 = v13 + 0x1.b149c360dbe22p-25;
    const double v16 = v14 * v1;
    const double v17 = v16 + 0x1.7fd478253df46p-24;
    const double v19 = v17 * v1;
    const double v20 = v19 + 0x1.7b1e61f702731p-19;
    const double v22 = v20 * v1;
    const double v23 = v22 + (-0x1.8d4952ec3d425p-15);
    const double v25 = v23 * v1;
    const double v26 = v25 + 0x1.d0042e1391951p-11;
    const double v28 = v26 * v1;
    const double v29 = v28 + (-0x1.5ac056b1147acp-7);
    const double v31 = v29 * v1;
    const double v32 = v31 + 0x1.5f15f15f1726fp-4;
    const double v34 = v32 * v1;
    const double v35 = v34 + (-0x1.99999999999aap-2);
    const double v36 = v35 * v1;
    const double v37 = v1 * v36;
    const double v38 = v37 + v1;
    const double v40 = v38 / 0x1.8000000000000p+0;
    const double v41 = v40 * alpha;
    return v41;
}

INLINE double polar_moment_1e_10_plain(double alpha)
{
    const double v1 = alpha * alpha;
    const double v3 = 0x1.3bd3cc9be45dep+1 - v1;
    const double v6 = 0x1.e250654a0fa79p-5 * v3;
    const double v7 = v6 + 0x1.764b4fd12c227p+1;
    const double v9 = v7 * v3;
    const double v10 = v9 + 0x1.15f5651c6c2b6p+4;
    const double v12 = v10 * v3;
    const double v13 = v12 + 0x1.97881d28eb78fp+6;
    const double v15 = v13 * v3;
    const double v16 = v15 + 0x1.781f38b2a68b0p+7;
    const double v18 = v16 * v3;
    const double v19 = v18 + 0x1.705f937528711p+6;
    const double v21 = v19 * v3;
    const double v22 = v21 + 0x1.6f67e48f11997p+3;
    const double v24 = v22 * v3;
    const double v25 = v24 + 0x1.14aca4167a07fp-2;
    const double v26 = v25 * v1;
    const double v29 = (-0x1.efcbe37812bdfp-4) * v3;
    const double v30 = v29 + 0x1.b9bc468114fd2p+1;
    const double v32 = v30 * v3;
    const double v33 = v32 + (-0x1.444345493560ap+5);
    const double v35 = v33 * v3;
    const double v36 = v35 + 0x1.4ea305d69d8f6p+7;
    const double v38 = v36 * v3;
    const double v39 = v38 + 0x1.283ecbb1b4392p+9;
    const double v41 = v39 * v3;
    const double v42 = v41 + 0x1.47ee26059427dp+8;
    const double v44 = v42 * v3;
    const double v45 = v44 + 0x1.5185165bf6bccp+5;
    const double v47 = v45 * v3;
    const double v48 = v47 + 0x1.0000000000000p+0;
    const double v49 = v26 / v48;
    const double v50 = v49 * alpha;
    return v50;
}
#define polar_moment_1e_10_plain_KIND whole

INLINE double polar_moment_1e_6_plain(double alpha)
{
    const double v1 = alpha * alpha;
    const double v4 = 0x1.c6cb40d04487cp-17 * v1;
    const double v5 = v4 + (-0x1.01f8715011affp-13);
    const double v7 = v5 * v1;
    const double v8 = v7 + 0x1.e6addd2fd57c1p-12;
    const double v10 = v8 * v1;
    const double v11 = v10 + (-0x1.f017539ffdb0bp-11);
    const double v13 = v11 * v1;
    const double v14 = v13 + 0x1.a45a7a5b48d87p-10;
    const double v16 = v14 * v1;
    const double v17 = v16 + (-0x1.f6c43e68063fbp-8);
    const double v19 = v17 * v1;
    const double v20 = v19 + 0x1.d5a56118ff0cbp-5;
    const double v22 = v20 * v1;
    const double v23 = v22 + (-0x1.1116d4346c2b7p-2);
    const double v25 = v23 * v1;
    const double v26 = v25 + 0x1.555563e45ba3ep-1;
    const double v27 = v26 * v1;
    const double v28 = v27 * alpha;
    return v28;
}
#define polar_moment_1e_6_plain_KIND whole

INLINE double polar_moment_float32_plain(double alpha)
{
    const double v1 = alpha * alpha;
    const double v3 = 0x1.3bd3cc9be45dep+1 - v1;
    const double v6 = 0x1.06bac513c89bdp-4 * v3;
    const double v7 = v6 + 0x1.dc0d095bd83c1p-1;
    const double v9 = v7 * v3;
    const double v10 = v9 + 0x1.933d9ee3bc318p+2;
    const double v12 = v10 * v3;
    const double v13 = v12 + 0x1.db1c7a52b7740p+4;
    const double v15 = v13 * v3;
    const double v16 = v15 + 0x1.1699441fb3d7bp+6;
    const double v18 = v16 * v3;
    const double v19 = v18 + 0x1.7e9225dc641bdp+5;
    const double v21 = v19 * v3;
    const double v22 = v21 + 0x1.0a493d7acae63p+3;
    const double v24 = v22 * v3;
    const double v25 = v24 + 0x1.14aca415ff9bep-2;
    const double v26 = v25 * v1;
    const double v29 = 0x1.d7d31fc8e0f2ap-3 * v3;
    const double v30 = v29 + (-0x1.62e6200f03a08p+2);
    const double v32 = v30 * v3;
    const double v33 = v32 + 0x1.060efdd46e2e3p+5;
    const double v35 = v33 * v3;
    const double v36 = v35 + 0x1.981502230ec47p+7;
    const double v38 = v36 * v3;
    const double v39 = v38 + 0x1.4f42aae35dcb3p+7;
    const double v41 = v39 * v3;
    const double v42 = v41 + 0x1.e7e99b90416b4p+4;
    const double v44 = v42 * v3;
    const double v45 = v44 + 0x1.0000000000000p+0;
    const double v46 = v26 / v45;
    const double v47 = v46 * alpha;
    return v47;
}
#define polar_moment_float32_plain_KIND whole

INLINE double moment_of_inertia_best_plain(double alpha)
{
    const double v1 = alpha * alpha;
    const double v4 = (-0x1.06aa0de1b2785p-38) * v1;
    const double v5 = v4 + 0x1.701f99390685dp-33;
    const double v7 = v5 * v1;
    const double v8 = v7 + (-0x1.715e85182e3c6p-28);
    const double v10 = v8 * v1;
    const double v11 = v10 + 0x1.2f46f95e97102p-23;
    const double v13 = v11 * v1;
    const double v14 = v13 + (-0x1.952f78d94e8b4p-19);
    const double v16 = v14 * v1;
    const double v17 = v16 + 0x1.ae8cb1283bb0dp-15;
    const double v19 = v17 * v1;
    const double v20 = v19 + (-0x1.615085c00e86dp-11);
    const double v22 = v20 * v1;
    const double v23 = v22 + 0x1.af3b88aa68aebp-8;
    const double v25 = v23 * v1;
    const double v26 = v25 + (-0x1.74c1f6ca16a80p-5);
    const double v28 = v26 * v1;
    const double v29 = v28 + 0x1.ad1ad1ad1acf4p-3;
    const double v31 = v29 * v1;
    const double v32 = v31 + (-0x1.3333333333333p-1);
    const double v33 = v32 * v1;
    const double v34 = v1 * v33;
    const double v35 = v34 + v1;
    const double v37 = v35 / 0x1.8000000000000p+0;
    const double v38 = v37 * alpha;
    const double v40 = 0x1.921fb54442d18p+0 - alpha;
    const double v41 = v40 * v40;
    const double v44 = (-0x1.00589fe65ed98p-23) * v41;
    const double v45 = v44 + 0x1.1425220d45aaap-19;
    const double v47 = v45 * v41;
    const double v48 = v47 + (-0x1.1f397f95f7403p-15);
    const double v50 = v48 * v41;
    const double v51 = v50 + 0x1.d6a371cc475cdp-12;
    const double v53 = v51 * v41;
    const double v54 = v53 + (-0x1.1e5e23528aa32p-8);
    const double v56 = v54 * v41;
    const double v57 = v56 + 0x1.e94dfd8b6e6d2p-6;
    const double v59 = v57 * v41;
    const double v60 = v59 + (-0x1.0cbb76630619cp-3);
    const double v62 = v60 * v41;
    const double v63 = v62 + 0x1.3e93e93e9959dp-2;
    const double v65 = v63 * v41;
    const double v66 = v65 + (-0x1.c71c71c71cad2p-3);
    const double v68 = v66 * v41;
    const double v69 = v68 + (-0x1.555555555554ep-3);
    const double v71 = v40 * v69;
    const double v72 = v71 + 0x1.dffffffffffffp-4;
    const double v74 = 0x1.0000000000000p-1 * alpha;
    const double v76 = v74 + (-0x1.e000000000000p-4);
    const double v77 = v76 + v72;
    const int v79 = alpha < 0x1.0000000000000p+0;
    const double v80 = v79 ? v38 : v77;
    return v80;
}
#define moment_of_inertia_best_plain_KIND pieces
#define moment_of_inertia_best_plain_BELOW_double UINT64_C(0x3fefffffffffffff)
#define moment_of_inertia_best_plain_BELOW_float UINT32_C(0x3f7fffff)
INLINE double moment_of_inertia_best_plain_below(double alpha)
{
    const double v1 = alpha * alpha;
    const double v4 = (-0x1.06aa0de1b2785p-38) * v1;
    const double v5 = v4 + 0x1.701f99390685dp-33;
    const double v7 = v5 * v1;
    const double v8 = v7 + (-0x1.715e85182e3c6p-28);
    const double v10 = v8 * v1;
    const double v11 = v10 + 0x1.2f46f95e97102p-23;
    const double v13 = v11 * v1;
    const double v14 = v13 + (-0x1.952f78d94e8b4p-19);
    const double v16 = v14 * v1;
    const double v17 = v16 + 0x1.ae8cb1283bb0dp-15;
    const double v19 = v17 * v1;
    const double v20 = v19 + (-0x1.615085c00e86dp-11);
    const double v22 = v20 * v1;
    const double v23 = v22 + 0x1.af3b88aa68aebp-8;
    const double v25 = v23 * v1;
    const double v26 = v25 + (-0x1.74c1f6ca16a80p-5);
    const double v28 = v26 * v1;
    const double v29 = v28 + 0x1.ad1ad1ad1acf4p-3;
    const double v31 = v29 * v1;
    const double v32 = v31 + (-0x1.3333333333333p-1);
    const double v33 = v32 * v1;
    const double v34 = v1 * v33;
    const double v35 = v34 + v1;
    const double v37 = v35 / 0x1.8000000000000p+0;
    const double v38 = v37 * alpha;
    return v38;
}

INLINE double moment_of_inertia_1e_10_plain(double alpha)
{
    const double v1 = alpha * alpha;
    const double v4 = (-0x1.4936e56328342p-29) * v1;
    const double v5 = v4 + 0x1.7a7cb07e3408cp-24;
    const double v7 = v5 * v1;
    const double v8 = v7 + (-0x1.0bc4e9f8c08c4p-19);
    const double v10 = v8 * v1;
    const double v11 = v10 + 0x1.1ec4f59c801cbp-15;
    const double v13 = v11 * v1;
    const double v14 = v13 + (-0x1.d70c8c3356105p-12);
    const double v16 = v14 * v1;
    const double v17 = v16 + 0x1.1f7c9cb90ff08p-8;
    const double v19 = v17 * v1;
    const double v20 = v19 + (-0x1.f10293cdf1d20p-6);
    const double v22 = v20 * v1;
    const double v23 = v22 + 0x1.1e11e0d7b66ffp-3;
    const double v25 = v23 * v1;
    const double v26 = v25 + (-0x1.99999996b5367p-2);
    const double v28 = v26 * v1;
    const double v29 = v28 + 0x1.55555555502c0p-1;
    const double v30 = v29 * v1;
    const double v31 = v30 * alpha;
    return v31;
}
#define moment_of_inertia_1e_10_plain_KIND whole

INLINE double moment_of_inertia_1e_6_plain(double alpha)
{
    const double v1 = alpha * alpha;
    const double v4 = 0x1.50ef7c600437bp-16 * v1;
    const double v5 = v4 + (-0x1.a6e3a2c99c515p-12);
    const double v7 = v5 * v1;
    const double v8 = v7 + 0x1.1a5c427a6780ap-8;
    const double v10 = v8 * v1;
    const double v11 = v10 + (-0x1.efda754ae7b31p-6);
    const double v13 = v11 * v1;
    const double v14 = v13 + 0x1.1e017fc24dd09p-3;
    const double v16 = v14 * v1;
    const double v17 = v16 + (-0x1.999830f1f6825p-2);
    const double v19 = v17 * v1;
    const double v20 = v19 + 0x1.55554ffb45dfap-1;
    const double v21 = v20 * v1;
    const double v22 = v21 * alpha;
    return v22;
}
#define moment_of_inertia_1e_6_plain_KIND short

INLINE double moment_of_inertia_float32_plain(double alpha)
{
    const double v1 = alpha * alpha;
    const double v4 = 0x1.049a5be9eb92ap-24 * v1;
    const double v5 = v4 + (-0x1.f4342ef238f03p-20);
    const double v7 = v5 * v1;
    const double v8 = v7 + 0x1.1be5d7f6ae24dp-15;
    const double v10 = v8 * v1;
    const double v11 = v10 + (-0x1.d6804e76da319p-12);
    const double v13 = v11 * v1;
    const double v14 = v13 + 0x1.1f74af1fc94e4p-8;
    const double v16 = v14 * v1;
    const double v17 = v16 + (-0x1.f1018ef94d003p-6);
    const double v19 = v17 * v1;
    const double v20 = v19 + 0x1.1e11d8503acb9p-3;
    const double v22 = v20 * v1;
    const double v23 = v22 + (-0x1.9999992647539p-2);
    const double v25 = v23 * v1;
    const double v26 = v25 + 0x1.55555554542e9p-1;
    const double v27 = v26 * v1;
    const double v28 = v27 * alpha;
    return v28;
}
#define moment_of_inertia_float32_plain_KIND whole

INLINE double radial_weight_amplitude_best_plain(double alpha)
{
    const double v1 = alpha * alpha;
    const double v4 = (-0x1.3687c8bf5bfd6p-28) * v1;
    const double v5 = v4 + 0x1.ad9efb842aa75p-26;
    const double v7 = v5 * v1;
    const double v8 = v7 + (-0x1.3b05aafac3a90p-24);
    const double v10 = v8 * v1;
    const double v11 = v10 + 0x1.045647ffefdb9p-23;
    const double v13 = v11 * v1;
    const double v14 = v13 + (-0x1.59a98a325cbd4p-23);
    const double v16 = v14 * v1;
    const double v17 = v16 + 0x1.5d27070391f4dp-24;
    const double v19 = v17 * v1;
    const double v20 = v19 + (-0x1.c4fd9a7c6da80p-23);
    const double v22 = v20 * v1;
    const double v23 = v22 + (-0x1.cab1aff185f12p-22);
    const double v25 = v23 * v1;
    const double v26 = v25 + (-0x1.af675dca502fcp-20);
    const double v28 = v26 * v1;
    const double v29 = v28 + (-0x1.81ce091eaad43p-18);
    const double v31 = v29 * v1;
    const double v32 = v31 + (-0x1.8bc56a975512cp-16);
    const double v34 = v32 * v1;
    const double v35 = v34 + (-0x1.ebc17ea4438d8p-16);
    const double v37 = v35 * v1;
    const double v38 = v37 + (-0x1.0cbb766699a91p-9);
    const double v40 = v38 * v1;
    const double v41 = v40 + 0x1.c09c09c0a0697p-6;
    const double v43 = v41 * v1;
    const double v44 = v43 + (-0x1.333333333333fp-2);
    const double v45 = v44 * v1;
    const double v46 = v1 * v45;
    const double v47 = v46 + v1;
    const double v49 = v47 / 0x1.8000000000000p+0;
    const double v50 = v49 * alpha;
    const double v52 = 0x1.921fb54442d18p+0 - alpha;
    const double v53 = v52 * v52;
    const double v56 = 0x1.8128754f493fdp-17 * v53;
    const double v57 = v56 + (-0x1.5c1de3bda9c32p-12);
    const double v59 = v57 * v53;
    const double v60 = v59 + 0x1.c0f84768fd081p-8;
    const double v62 = v60 * v53;
    const double v63 = v62 + (-0x1.5fec3987413d3p-4);
    const double v65 = v63 * v53;
    const double v66 = v65 + 0x1.2c981ff50df71p-1;
    const double v68 = v66 * v53;
    const double v69 = v68 + (-0x1.7217f7d1c0c33p-7);
    const double v72 = (-0x1.4b80ca7eaf925p-18) * v53;
    const double v73 = v72 + 0x1.26ecb6ae67667p-13;
    const double v75 = v73 * v53;
    const double v76 = v75 + (-0x1.a01c15d7033acp-9);
    const double v78 = v76 * v53;
    const double v79 = v78 + 0x1.6c16c0a0e6534p-5;
    const double v81 = v79 * v53;
    const double v82 = v81 + (-0x1.555555554900ap-2);
    const double v84 = v82 * v53;
    const double v85 = v84 + 0x1.00000000000b6p+0;
    const double v87 = 0x1.0000000000000p+1 * v52;
    const double v89 = v87 > 0x1.0000000000000p-60 ? v87 : 0x1.0000000000000p-60;
    const double v90 = significand_of(v89);
    const double v92 = v90 - 0x1.0000000000000p+0;
    const double v93 = v92 + 0x1.0000000000000p+1;
    const double v94 = v92 / v93;
    const double v95 = v94 * v94;
    const double v98 = 0x1.3cda08c7927d8p-3 * v95;
    const double v99 = v98 + 0x1.3804595ac79edp-3;
    const double v101 = v99 * v95;
    const double v102 = v101 + 0x1.747966b22b47ep-3;
    const double v104 = v102 * v95;
    const double v105 = v104 + 0x1.c71be01ef8d7bp-3;
    const double v107 = v105 * v95;
    const double v108 = v107 + 0x1.249249f1b0e53p-2;
    const double v110 = v108 * v95;
    const double v111 = v110 + 0x1.999999987c7a3p-2;
    const double v113 = v111 * v95;
    const double v114 = v113 + 0x1.55555555559d8p-1;
    const double v115 = v95 * v114;
    const double v116 = v115 - v92;
    const double v117 = exponent_of(v89);
    const double v119 = v117 * 0x1.62e42fefa39efp-1;
    const double v120 = v119 + v92;
    const double v121 = v94 * v116;
    const double v122 = v121 + v120;
    const double v123 = v85 * v122;
    const double v124 = v123 + v69;
    const double v125 = v53 * v124;
    const double v127 = v52 * (-0x1.e000000000000p+0);
    const double v128 = v127 + 0x1.0000000000000p+0;
    const double v129 = v52 * v128;
    const double v130 = v129 + v125;
    const double v132 = alpha + (-0x1.243f6a8885a30p-1);
    const double v133 = v132 + v130;
    const int v135 = alpha < 0x1.051eb851eb852p+0;
    const double v136 = v135 ? v50 : v133;
    return v136;
}
#define radial_weight_amplitude_best_plain_KIND pieces
#define radial_weight_amplitude_best_plain_BELOW_double UINT64_C(0x3ff051eb851eb851)
#define radial_weight_amplitude_best_plain_BELOW_float UINT32_C(0x3f828f5c)
INLINE double radial_weight_amplitude_best_plain_below(double alpha)
{
    const double v1 = alpha * alpha;
    const double v4 = (-0x1.3687c8bf5bfd6p-28) * v1;
    const double v5 = v4 + 0x1.ad9efb842aa75p-26;
    const double v7 = v5 * v1;
    const double v8 = v7 + (-0x1.3b05aafac3a90p-24);
    const double v10 = v8 * v1;
    const double v11 = v10 + 0x1.045647ffefdb9p-23;
    const double v13 = v11 * v1;
    const double v14 = v13 + (-0x1.59a98a325cbd4p-23);
    const double v16 = v14 * v1;
    const double v17 = v16 + 0x1.5d27070391f4dp-24;
    const double v19 = v17 * v1;
    const double v20 = v19 + (-0x1.c4fd9a7c6da80p-23);
    const double v22 = v20 * v1;
    const double v23 = v22 + (-0x1.cab1aff185f12p-22);
    const double v25 = v23 * v1;
    const double v26 = v25 + (-0x1.af675dca502fcp-20);
    const double v28 = v26 * v1;
    const double v29 = v28 + (-0x1.81ce091eaad43p-18);
    const double v31 = v29 * v1;
    const double v32 = v31 + (-0x1.8bc56a975512cp-16);
    const double v34 = v32 * v1;
    const double v35 = v34 + (-0x1.ebc17ea4438d8p-16);
    const double v37 = v35 * v1;
    const double v38 = v37 + (-0x1.0cbb766699a91p-9);
    const double v40 = v38 * v1;
    const double v41 = v40 + 0x1.c09c09c0a0697p-6;
    const double v43 = v41 * v1;
    const double v44 = v43 + (-0x1.333333333333fp-2);
    const double v45 = v44 * v1;
    const double v46 = v1 * v45;
    const double v47 = v46 + v1;
    const double v49 = v47 / 0x1.8000000000000p+0;
    const double v50 = v49 * alpha;
    return v50;
}

INLINE double radial_weight_amplitude_1e_10_plain(double alpha)
{
    const double v1 = alpha * alpha;
    const double v3 = 0x1.3bd3cc9be45dep+1 - v1;
    const double v6 = 0x1.04f7df6595ca2p+25 * v3;
    const double v7 = v6 + 0x1.83d173767ec99p+29;
    const double v9 = v7 * v3;
    const double v10 = v9 + 0x1.508e0e40facb6p+32;
    const double v12 = v10 * v3;
    const double v13 = v12 + 0x1.8da34cb08e1f0p+33;
    const double v15 = v13 * v3;
    const double v16 = v15 + 0x1.6259be601aeb1p+33;
    const double v18 = v16 * v3;
    const double v19 = v18 + 0x1.dda5739c64a89p+31;
    const double v21 = v19 * v3;
    const double v22 = v21 + 0x1.d131baf022e41p+28;
    const double v24 = v22 * v3;
    const double v25 = v24 + 0x1.2d9988866fd53p+24;
    const double v27 = v25 * v3;
    const double v28 = v27 + 0x1.c7fae97af9e1fp+17;
    const double v30 = v28 * v3;
    const double v31 = v30 + 0x1.40cc71ab82b17p+9;
    const double v33 = v31 * v3;
    const double v34 = v33 + 0x1.08345eb49dfa4p-2;
    const double v35 = v34 * v1;
    const double v38 = 0x1.aed60df82a50dp+23 * v3;
    const double v39 = v38 + (-0x1.cb6e4518cfd29p+28);
    const double v41 = v39 * v3;
    const double v42 = v41 + 0x1.1ea89b013008dp+32;
    const double v44 = v42 * v3;
    const double v45 = v44 + 0x1.c5d99f7e12cd1p+34;
    const double v47 = v45 * v3;
    const double v48 = v47 + 0x1.18d58653a0677p+35;
    const double v50 = v48 * v3;
    const double v51 = v50 + 0x1.ae1c93f2d7caep+33;
    const double v53 = v51 * v3;
    const double v54 = v53 + 0x1.b7d217ea325d6p+30;
    const double v56 = v54 * v3;
    const double v57 = v56 + 0x1.22251312f6b79p+26;
    const double v59 = v57 * v3;
    const double v60 = v59 + 0x1.b915276826f3cp+19;
    const double v62 = v60 * v3;
    const double v63 = v62 + 0x1.36c2b5ccd0c1fp+11;
    const double v65 = v63 * v3;
    const double v66 = v65 + 0x1.0000000000000p+0;
    const double v67 = v35 / v66;
    const double v68 = v67 * alpha;
    return v68;
}
#define radial_weight_amplitude_1e_10_plain_KIND whole

INLINE double radial_weight_amplitude_1e_6_plain(double alpha)
{
    const double v1 = alpha * alpha;
    const double v3 = 0x1.3bd3cc9be45dep+1 - v1;
    const double v6 = 0x1.cc8a8141fa745p+2 * v3;
    const double v7 = v6 + 0x1.16253f17550d1p+5;
    const double v9 = v7 * v3;
    const double v10 = v9 + 0x1.24ceea0f4ee36p+5;
    const double v12 = v10 * v3;
    const double v13 = v12 + 0x1.072fc483044bbp+3;
    const double v15 = v13 * v3;
    const double v16 = v15 + 0x1.083464838a5a9p-2;
    const double v17 = v16 * v1;
    const double v20 = 0x1.32c3a7d534520p-2 * v3;
    const double v21 = v20 + (-0x1.f40a4101ee07ep+2);
    const double v23 = v21 * v3;
    const double v24 = v23 + 0x1.0589e6f9d3ef3p+6;
    const double v26 = v24 * v3;
    const double v27 = v26 + 0x1.ed09359bb409ap+6;
    const double v29 = v27 * v3;
    const double v30 = v29 + 0x1.f44f9842d233ap+4;
    const double v32 = v30 * v3;
    const double v33 = v32 + 0x1.0000000000000p+0;
    const double v34 = v17 / v33;
    const double v35 = v34 * alpha;
    return v35;
}
#define radial_weight_amplitude_1e_6_plain_KIND whole

INLINE double radial_weight_amplitude_float32_plain(double alpha)
{
    const double v1 = alpha * alpha;
    const double v3 = 0x1.3bd3cc9be45dep+1 - v1;
    const double v6 = 0x1.a41276abb9bcap+18 * v3;
    const double v7 = v6 + 0x1.5866e2818eb1dp+23;
    const double v9 = v7 * v3;
    const double v10 = v9 + 0x1.146d584af00dcp+26;
    const double v12 = v10 * v3;
    const double v13 = v12 + 0x1.1b0db627b1ac4p+27;
    const double v15 = v13 * v3;
    const double v16 = v15 + 0x1.9d535830bdb5cp+26;
    const double v18 = v16 * v3;
    const double v19 = v18 + 0x1.a80171a3e90ffp+24;
    const double v21 = v19 * v3;
    const double v22 = v21 + 0x1.1c70adff422e7p+21;
    const double v24 = v22 * v3;
    const double v25 = v24 + 0x1.b837b6270ce48p+15;
    const double v27 = v25 * v3;
    const double v28 = v27 + 0x1.3b6600d74bccbp+8;
    const double v30 = v28 * v3;
    const double v31 = v30 + 0x1.08345eb56857ap-2;
    const double v32 = v31 * v1;
    const double v35 = 0x1.c1ec6782b793bp+17 * v3;
    const double v36 = v35 + (-0x1.c99f8ffd771f7p+22);
    const double v38 = v36 * v3;
    const double v39 = v38 + 0x1.1d5c0538d4588p+26;
    const double v41 = v39 * v3;
    const double v42 = v41 + 0x1.61a66a4a4b7dfp+28;
    const double v44 = v42 * v3;
    const double v45 = v44 + 0x1.573eb93a9e7aap+28;
    const double v47 = v45 * v3;
    const double v48 = v47 + 0x1.86838e8dc8106p+26;
    const double v50 = v48 * v3;
    const double v51 = v50 + 0x1.0f96e362556bdp+23;
    const double v53 = v51 * v3;
    const double v54 = v53 + 0x1.a919145cb9bd0p+17;
    const double v56 = v54 * v3;
    const double v57 = v56 + 0x1.3173bf280d278p+10;
    const double v59 = v57 * v3;
    const double v60 = v59 + 0x1.0000000000000p+0;
    const double v61 = v32 / v60;
    const double v62 = v61 * alpha;
    return v62;
}
#define radial_weight_amplitude_float32_plain_KIND whole

INLINE double weight_moment_amplitude_best_plain(double alpha)
{
    const double v1 = alpha * alpha;
    const double v4 = 0x1.cce3e7c2893efp-41 * v1;
    const double v5 = v4 + (-0x1.bfd1bed6f6a7dp-35);
    const double v7 = v5 * v1;
    const double v8 = v7 + 0x1.483a398c06abcp-29;
    const double v10 = v8 * v1;
    const double v11 = v10 + (-0x1.85d7f38d0863bp-24);
    const double v13 = v11 * v1;
    const double v14 = v13 + 0x1.702ffb8c1bae1p-19;
    const double v16 = v14 * v1;
    const double v17 = v16 + (-0x1.0c7836ab3f49dp-14);
    const double v19 = v17 * v1;
    const double v20 = v19 + 0x1.22d671ab3a415p-10;
    const double v22 = v20 * v1;
    const double v23 = v22 + (-0x1.bc466f119b2adp-7);
    const double v25 = v23 * v1;
    const double v26 = v25 + 0x1.bbbbbbbbbbbacp-4;
    const double v28 = v26 * v1;
    const double v29 = v28 + (-0x1.0000000000000p-1);
    const double v30 = v29 * v1;
    const double v31 = v1 * v30;
    const double v32 = v31 + v1;
    const double v34 = v32 / 0x1.8000000000000p+0;
    const double v35 = v34 * alpha;
    const double v37 = 0x1.921fb54442d18p+0 - alpha;
    const double v38 = v37 * v37;
    const double v41 = 0x1.67d5c86be4eaap-22 * v38;
    const double v42 = v41 + (-0x1.32bd95a55a9c6p-17);
    const double v44 = v42 * v38;
    const double v45 = v44 + 0x1.83ca9db1c8d33p-13;
    const double v47 = v45 * v38;
    const double v48 = v47 + (-0x1.637e0a0dbbf96p-9);
    const double v50 = v48 * v38;
    const double v51 = v50 + 0x1.bc8bc8bc177d0p-6;
    const double v53 = v51 * v38;
    const double v54 = v53 + (-0x1.5b05b05b057bfp-3);
    const double v56 = v54 * v38;
    const double v57 = v56 + 0x1.2aaaaaaaaaab3p-1;
    const double v58 = v38 * v38;
    const double v61 = v37 * (-0x1.1a62633145c07p-53);
    const double v62 = v61 + (-0x1.5555555555556p-54);
    const double v63 = v58 * v57;
    const double v64 = v63 + v62;
    const double v67 = v37 * (-0x1.0000000000000p+0);
    const double v68 = v67 + 0x1.0000000000000p-1;
    const double v69 = v37 * v68;
    const double v70 = v69 + v64;
    const double v71 = 0x1.0000000000000p-1 * alpha;
    const double v73 = v71 + (-0x1.e652ff776be10p-4);
    const double v74 = v73 + v70;
    const int v76 = alpha < 0x1.23d70a3d70a3dp+0;
    const double v77 = v76 ? v35 : v74;
    return v77;
}
#define weight_moment_amplitude_best_plain_KIND pieces
#define weight_moment_amplitude_best_plain_BELOW_double UINT64_C(0x3ff23d70a3d70a3c)
#define weight_moment_amplitude_best_plain_BELOW_float UINT32_C(0x3f91eb85)
INLINE double weight_moment_amplitude_best_plain_below(double alpha)
{
    const double v1 = alpha * alpha;
    const double v4 = 0x1.cce3e7c2893efp-41 * v1;
    const double v5 = v4 + (-0x1.bfd1bed6f6a7dp-35);
    const double v7 = v5 * v1;
    const double v8 = v7 + 0x1.483a398c06abcp-29;
    const double v10 = v8 * v1;
    const double v11 = v10 + (-0x1.85d7f38d0863bp-24);
    const double v13 = v11 * v1;
    const double v14 = v13 + 0x1.702ffb8c1bae1p-19;
    const double v16 = v14 * v1;
    const double v17 = v16 + (-0x1.0c7836ab3f49dp-14);
    const double v19 = v17 * v1;
    const double v20 = v19 + 0x1.22d671ab3a415p-10;
    const double v22 = v20 * v1;
    const double v23 = v22 + (-0x1.bc466f119b2adp-7);
    const double v25 = v23 * v1;
    const double v26 = v25 + 0x1.bbbbbbbbbbbacp-4;
    const double v28 = v26 * v1;
    const double v29 = v28 + (-0x1.0000000000000p-1);
    const double v30 = v29 * v1;
    const double v31 = v1 * v30;
    const double v32 = v31 + v1;
    const double v34 = v32 / 0x1.8000000000000p+0;
    const double v35 = v34 * alpha;
    return v35;
}

INLINE double weight_moment_amplitude_1e_10_plain(double alpha)
{
    const double v1 = alpha * alpha;
    const double v4 = 0x1.55b68304dda03p-30 * v1;
    const double v5 = v4 + (-0x1.f9e9d8d248bfcp-25);
    const double v7 = v5 * v1;
    const double v8 = v7 + 0x1.e9ce55f457fb1p-20;
    const double v10 = v8 * v1;
    const double v11 = v10 + (-0x1.65e8281936887p-15);
    const double v13 = v11 * v1;
    const double v14 = v13 + 0x1.83c7d5627d1d1p-11;
    const double v16 = v14 * v1;
    const double v17 = v16 + (-0x1.282eee7b92cf7p-7);
    const double v19 = v17 * v1;
    const double v20 = v19 + 0x1.27d27cf3b8112p-4;
    const double v22 = v20 * v1;
    const double v23 = v22 + (-0x1.55555553fea4bp-2);
    const double v25 = v23 * v1;
    const double v26 = v25 + 0x1.555555555259dp-1;
    const double v27 = v26 * v1;
    const double v28 = v27 * alpha;
    return v28;
}
#define weight_moment_amplitude_1e_10_plain_KIND whole

INLINE double weight_moment_amplitude_1e_6_plain(double alpha)
{
    const double v1 = alpha * alpha;
    const double v4 = (-0x1.ff7dbdabc38e7p-16) * v1;
    const double v5 = v4 + 0x1.71e62473ed8bap-11;
    const double v7 = v5 * v1;
    const double v8 = v7 + (-0x1.26ad631e2f9a1p-7);
    const double v10 = v8 * v1;
    const double v11 = v10 + 0x1.27b41ec7abd41p-4;
    const double v13 = v11 * v1;
    const double v14 = v13 + (-0x1.555382cc0e3b7p-2);
    const double v16 = v14 * v1;
    const double v17 = v16 + 0x1.55554ba99af07p-1;
    const double v18 = v17 * v1;
    const double v19 = v18 * alpha;
    return v19;
}
#define weight_moment_amplitude_1e_6_plain_KIND short

INLINE double weight_moment_amplitude_float32_plain(double alpha)
{
    const double v1 = alpha * alpha;
    const double v4 = (-0x1.8c2a65eb3fec2p-25) * v1;
    const double v5 = v4 + 0x1.db665517a168ep-20;
    const double v7 = v5 * v1;
    const double v8 = v7 + (-0x1.64ea296a14023p-15);
    const double v10 = v8 * v1;
    const double v11 = v10 + 0x1.83b443c4ba8e3p-11;
    const double v13 = v11 * v1;
    const double v14 = v13 + (-0x1.282e1a3d0c0eep-7);
    const double v16 = v14 * v1;
    const double v17 = v16 + 0x1.27d273f81480bp-4;
    const double v19 = v17 * v1;
    const double v20 = v19 + (-0x1.555555080b38cp-2);
    const double v22 = v20 * v1;
    const double v23 = v22 + 0x1.5555555478204p-1;
    const double v24 = v23 * v1;
    const double v25 = v24 * alpha;
    return v25;
}
#define weight_moment_amplitude_float32_plain_KIND whole

INLINE double resistance_factor_best_plain(double alpha)
{
    const double v1 = alpha * alpha;
    const double v4 = 0x1.5aeb95ee17e27p-52 * v1;
    const double v5 = v4 + (-0x1.ae33aea2b0d55p-44);
    const double v7 = v5 * v1;
    const double v8 = v7 + 0x1.93966653151c3p-36;
    const double v10 = v8 * v1;
    const double v11 = v10 + (-0x1.1eed8d7449e95p-28);
    const double v13 = v11 * v1;
    const double v14 = v13 + 0x1.27e4fb7471f25p-21;
    const double v16 = v14 * v1;
    const double v17 = v16 + (-0x1.a01a01a0132c2p-15);
    const double v19 = v17 * v1;
    const double v20 = v19 + 0x1.6c16c16c16ba2p-9;
    const double v22 = v20 * v1;
    const double v23 = v22 + (-0x1.5555555555555p-4);
    const double v24 = v23 * v1;
    const double v25 = v1 * v24;
    const double v26 = v25 + v1;
    const double v27 = v26 * alpha;
    return v27;
}
#define resistance_factor_best_plain_KIND whole

INLINE double resistance_factor_1e_10_plain(double alpha)
{
    const double v1 = alpha * alpha;
    const double v4 = (-0x1.1363823d24666p-28) * v1;
    const double v5 = v4 + 0x1.27a4afc560ce7p-21;
    const double v7 = v5 * v1;
    const double v8 = v7 + (-0x1.a018b5707a92dp-15);
    const double v10 = v8 * v1;
    const double v11 = v10 + 0x1.6c16be606925bp-9;
    const double v13 = v11 * v1;
    const double v14 = v13 + (-0x1.55555550127aap-4);
    const double v16 = v14 * v1;
    const double v17 = v16 + 0x1.fffffffffa0fbp-1;
    const double v18 = v17 * v1;
    const double v19 = v18 * alpha;
    return v19;
}
#define resistance_factor_1e_10_plain_KIND short

INLINE double resistance_factor_1e_6_plain(double alpha)
{
    const double v1 = alpha * alpha;
    const double v4 = (-0x1.899d6d596ca14p-15) * v1;
    const double v5 = v4 + 0x1.6b8afbde89795p-9;
    const double v7 = v5 * v1;
    const double v8 = v7 + (-0x1.5553226831932p-4);
    const double v10 = v8 * v1;
    const double v11 = v10 + 0x1.fffffa5b957a5p-1;
    const double v12 = v11 * v1;
    const double v13 = v12 * alpha;
    return v13;
}
#define resistance_factor_1e_6_plain_KIND short

INLINE double resistance_factor_float32_plain(double alpha)
{
    const double v1 = alpha * alpha;
    const double v4 = (-0x1.1363823d24666p-28) * v1;
    const double v5 = v4 + 0x1.27a4afc560ce7p-21;
    const double v7 = v5 * v1;
    const double v8 = v7 + (-0x1.a018b5707a92dp-15);
    const double v10 = v8 * v1;
    const double v11 = v10 + 0x1.6c16be606925bp-9;
    const double v13 = v11 * v1;
    const double v14 = v13 + (-0x1.55555550127aap-4);
    const double v16 = v14 * v1;
    const double v17 = v16 + 0x1.fffffffffa0fbp-1;
    const double v18 = v17 * v1;
    const double v19 = v18 * alpha;
    return v19;
}
#define resistance_factor_float32_plain_KIND short

INLINE double dynamic_coefficient_best_plain(double alpha)
{
    const double v2 = alpha * alpha;
    const double v5 = 0x1.03ba64fc6390ep-29 * v2;
    const double v6 = v5 + (-0x1.3aec2023926f3p-28);
    const double v8 = v6 * v2;
    const double v9 = v8 + 0x1.ab724f22aa27ep-27;
    const double v11 = v9 * v2;
    const double v12 = v11 + 0x1.d2dbb0cb27f33p-30;
    const double v14 = v12 * v2;
    const double v15 = v14 + 0x1.b149c360dbe22p-25;
    const double v17 = v15 * v2;
    const double v18 = v17 + 0x1.7fd478253df46p-24;
    const double v20 = v18 * v2;
    const double v21 = v20 + 0x1.7b1e61f702731p-19;
    const double v23 = v21 * v2;
    const double v24 = v23 + (-0x1.8d4952ec3d425p-15);
    const double v26 = v24 * v2;
    const double v27 = v26 + 0x1.d0042e1391951p-11;
    const double v29 = v27 * v2;
    const double v30 = v29 + (-0x1.5ac056b1147acp-7);
    const double v32 = v30 * v2;
    const double v33 = v32 + 0x1.5f15f15f1726fp-4;
    const double v35 = v33 * v2;
    const double v36 = v35 + (-0x1.99999999999aap-2);
    const double v37 = v36 * v2;
    const double v38 = 0x1.0000000000000p+0 + v37;
    const double v40 = 0x1.921fb54442d18p+0 - alpha;
    const double v41 = v40 * v40;
    const double v44 = 0x1.1477caa143cfbp-15 * v41;
    const double v45 = v44 + (-0x1.058aebdba383ap-11);
    const double v47 = v45 * v41;
    const double v48 = v47 + 0x1.556ffb39c3af9p-8;
    const double v50 = v48 * v41;
    const double v51 = v50 + (-0x1.0ee086df8c2f9p-5);
    const double v53 = v51 * v41;
    const double v54 = v53 + 0x1.94ebfbb2ec66fp-4;
    const double v56 = v54 * v41;
    const double v57 = v56 + (-0x1.213ce230290f3p-7);
    const double v60 = (-0x1.b16de590ed744p-16) * v41;
    const double v61 = v60 + 0x1.80dce9acbd0ffp-12;
    const double v63 = v61 * v41;
    const double v64 = v63 + (-0x1.2834e1f3e1a60p-8);
    const double v66 = v64 * v41;
    const double v67 = v66 + 0x1.27d279e0496b5p-5;
    const double v69 = v67 * v41;
    const double v70 = v69 + (-0x1.555555518e7c3p-3);
    const double v72 = v70 * v41;
    const double v73 = v72 + 0x1.55555555579d1p-2;
    const double v75 = v40 > 0x1.0000000000000p-60 ? v40 : 0x1.0000000000000p-60;
    const double v76 = significand_of(v75);
    const double v77 = v76 - 0x1.0000000000000p+0;
    const double v79 = v77 + 0x1.0000000000000p+1;
    const double v80 = v77 / v79;
    const double v81 = v80 * v80;
    const double v84 = 0x1.3cda08c7927d8p-3 * v81;
    const double v85 = v84 + 0x1.3804595ac79edp-3;
    const double v87 = v85 * v81;
    const double v88 = v87 + 0x1.747966b22b47ep-3;
    const double v90 = v88 * v81;
    const double v91 = v90 + 0x1.c71be01ef8d7bp-3;
    const double v93 = v91 * v81;
    const double v94 = v93 + 0x1.249249f1b0e53p-2;
    const double v96 = v94 * v81;
    const double v97 = v96 + 0x1.999999987c7a3p-2;
    const double v99 = v97 * v81;
    const double v100 = v99 + 0x1.55555555559d8p-1;
    const double v101 = v81 * v100;
    const double v102 = v101 - v77;
    const double v103 = exponent_of(v75);
    const double v105 = v103 * 0x1.62e42fefa39efp-1;
    const double v106 = v105 + v77;
    const double v107 = v80 * v102;
    const double v108 = v107 + v106;
    const double v109 = v73 * v108;
    const double v110 = v109 + v57;
    const double v111 = v40 * v41;
    const double v113 = v111 * v110;
    const double v114 = v113 + 0x1.ee6913347c2a6p-55;
    const double v116 = alpha + (-0x1.0c152382d7366p-1);
    const double v117 = v116 + v114;
    const int v119 = alpha < 0x1.dc28f5c28f5c3p-1;
    const double v120 = v119 ? v38 : v117;
    const double v123 = 0x1.5aeb95ee17e27p-52 * v2;
    const double v124 = v123 + (-0x1.ae33aea2b0d55p-44);
    const double v126 = v124 * v2;
    const double v127 = v126 + 0x1.93966653151c3p-36;
    const double v129 = v127 * v2;
    const double v130 = v129 + (-0x1.1eed8d7449e95p-28);
    const double v132 = v130 * v2;
    const double v133 = v132 + 0x1.27e4fb7471f25p-21;
    const double v135 = v133 * v2;
    const double v136 = v135 + (-0x1.a01a01a0132c2p-15);
    const double v138 = v136 * v2;
    const double v139 = v138 + 0x1.6c16c16c16ba2p-9;
    const double v141 = v139 * v2;
    const double v142 = v141 + (-0x1.5555555555555p-4);
    const double v143 = v142 * v2;
    const double v144 = 0x1.0000000000000p+0 + v143;
    const double v145 = v2 * v143;
    const double v146 = v145 + v2;
    const double v147 = v146 * alpha;
    const double v148 = v119 ? v144 : v147;
    const double v150 = v120 / 0x1.8000000000000p+0;
    const double v151 = v119 ? v150 : v120;
    const double v152 = v119 ? v148 : v148;
    const double v153 = v151 / v152;
    return v153;
}
#define dynamic_coefficient_best_plain_KIND whole

INLINE double weight_moment_per_inertia_best_plain(double alpha)
{
    const double v2 = alpha * alpha;
    const double v5 = 0x1.d7b62978183c7p-41 * v2;
    const double v6 = v5 + (-0x1.c0bbf1cdc35f2p-35);
    const double v8 = v6 * v2;
    const double v9 = v8 + 0x1.48429a5c8ff5ep-29;
    const double v11 = v9 * v2;
    const double v12 = v11 + (-0x1.85d847d52bd84p-24);
    const double v14 = v12 * v2;
    const double v15 = v14 + 0x1.702ffd855872fp-19;
    const double v17 = v15 * v2;
    const double v18 = v17 + (-0x1.0c7836b2641bdp-14);
    const double v20 = v18 * v2;
    const double v21 = v20 + 0x1.22d671ab58528p-10;
    const double v23 = v21 * v2;
    const double v24 = v23 + (-0x1.bc466f119baebp-7);
    const double v26 = v24 * v2;
    const double v27 = v26 + 0x1.bbbbbbbbbbbbap-4;
    const double v29 = v27 * v2;
    const double v30 = v29 + (-0x1.0000000000000p-1);
    const double v31 = v30 * v2;
    const double v32 = 0x1.0000000000000p+0 + v31;
    const double v34 = 0x1.921fb54442d18p+0 - alpha;
    const double v35 = v34 * v34;
    const double v38 = 0x1.6115c92e5be46p-22 * v35;
    const double v39 = v38 + (-0x1.328c51a4a2552p-17);
    const double v41 = v39 * v35;
    const double v42 = v41 + 0x1.83c977d2eae41p-13;
    const double v44 = v42 * v35;
    const double v45 = v44 + (-0x1.637e0682f503fp-9);
    const double v47 = v45 * v35;
    const double v48 = v47 + 0x1.bc8bc8b057e9ep-6;
    const double v50 = v48 * v35;
    const double v51 = v50 + (-0x1.5b05b05af2089p-3);
    const double v53 = v51 * v35;
    const double v54 = v53 + 0x1.2aaaaaaaaa92dp-1;
    const double v55 = v35 * v35;
    const double v58 = v34 * (-0x1.1a62633145c07p-53);
    const double v59 = v58 + (-0x1.5555555555556p-54);
    const double v60 = v55 * v54;
    const double v61 = v60 + v59;
    const double v64 = v34 * (-0x1.0000000000000p+0);
    const double v65 = v64 + 0x1.0000000000000p-1;
    const double v66 = v34 * v65;
    const double v67 = v66 + v61;
    const double v68 = 0x1.0000000000000p-1 * alpha;
    const double v70 = v68 + (-0x1.e652ff776be10p-4);
    const double v71 = v70 + v67;
    const int v72 = alpha < 0x1.0000000000000p+0;
    const double v73 = v72 ? v32 : v71;
    const double v76 = (-0x1.06aa0de1b2785p-38) * v2;
    const double v77 = v76 + 0x1.701f99390685dp-33;
    const double v79 = v77 * v2;
    const double v80 = v79 + (-0x1.715e85182e3c6p-28);
    const double v82 = v80 * v2;
    const double v83 = v82 + 0x1.2f46f95e97102p-23;
    const double v85 = v83 * v2;
    const double v86 = v85 + (-0x1.952f78d94e8b4p-19);
    const double v88 = v86 * v2;
    const double v89 = v88 + 0x1.ae8cb1283bb0dp-15;
    const double v91 = v89 * v2;
    const double v92 = v91 + (-0x1.615085c00e86dp-11);
    const double v94 = v92 * v2;
    const double v95 = v94 + 0x1.af3b88aa68aebp-8;
    const double v97 = v95 * v2;
    const double v98 = v97 + (-0x1.74c1f6ca16a80p-5);
    const double v100 = v98 * v2;
    const double v101 = v100 + 0x1.ad1ad1ad1acf4p-3;
    const double v103 = v101 * v2;
    const double v104 = v103 + (-0x1.3333333333333p-1);
    const double v105 = v104 * v2;
    const double v106 = 0x1.0000000000000p+0 + v105;
    const double v109 = (-0x1.00589fe65ed98p-23) * v35;
    const double v110 = v109 + 0x1.1425220d45aaap-19;
    const double v112 = v110 * v35;
    const double v113 = v112 + (-0x1.1f397f95f7403p-15);
    const double v115 = v113 * v35;
    const double v116 = v115 + 0x1.d6a371cc475cdp-12;
    const double v118 = v116 * v35;
    const double v119 = v118 + (-0x1.1e5e23528aa32p-8);
    const double v121 = v119 * v35;
    const double v122 = v121 + 0x1.e94dfd8b6e6d2p-6;
    const double v124 = v122 * v35;
    const double v125 = v124 + (-0x1.0cbb76630619cp-3);
    const double v127 = v125 * v35;
    const double v128 = v127 + 0x1.3e93e93e9959dp-2;
    const double v130 = v128 * v35;
    const double v131 = v130 + (-0x1.c71c71c71cad2p-3);
    const double v133 = v131 * v35;
    const double v134 = v133 + (-0x1.555555555554ep-3);
    const double v136 = v34 * v134;
    const double v137 = v136 + 0x1.dffffffffffffp-4;
    const double v139 = v68 + (-0x1.e000000000000p-4);
    const double v140 = v139 + v137;
    const double v141 = v72 ? v106 : v140;
    const double v142 = v73 / v141;
    return v142;
}
#define weight_moment_per_inertia_best_plain_KIND whole

INLINE double radial_weight_per_inertia_best_plain(double alpha)
{
    const double v2 = alpha * alpha;
    const double v5 = (-0x1.2602c2b4216f8p-29) * v2;
    const double v6 = v5 + 0x1.cbd5f63622b49p-27;
    const double v8 = v6 * v2;
    const double v9 = v8 + (-0x1.707239a982081p-25);
    const double v11 = v9 * v2;
    const double v12 = v11 + 0x1.5c0717fe10388p-24;
    const double v14 = v12 * v2;
    const double v15 = v14 + (-0x1.e6629131fe7cep-24);
    const double v17 = v15 * v2;
    const double v18 = v17 + 0x1.8284b98d3ef10p-24;
    const double v20 = v18 * v2;
    const double v21 = v20 + (-0x1.e67c4929e3d9ap-24);
    const double v23 = v21 * v2;
    const double v24 = v23 + (-0x1.aef8388bf9a7dp-24);
    const double v26 = v24 * v2;
    const double v27 = v26 + (-0x1.fc3a7b71ed83bp-22);
    const double v29 = v27 * v2;
    const double v30 = v29 + (-0x1.aba5f589eb2edp-20);
    const double v32 = v30 * v2;
    const double v33 = v32 + (-0x1.8201fa45d5e98p-18);
    const double v35 = v33 * v2;
    const double v36 = v35 + (-0x1.8bc37ba4a9e9cp-16);
    const double v38 = v36 * v2;
    const double v39 = v38 + (-0x1.ebc1aebec88f9p-16);
    const double v41 = v39 * v2;
    const double v42 = v41 + (-0x1.0cbb7661039a4p-9);
    const double v44 = v42 * v2;
    const double v45 = v44 + 0x1.c09c09c09b21ap-6;
    const double v47 = v45 * v2;
    const double v48 = v47 + (-0x1.3333333333331p-2);
    const double v49 = v48 * v2;
    const double v50 = 0x1.0000000000000p+0 + v49;
    const double v52 = 0x1.921fb54442d18p+0 - alpha;
    const double v53 = v52 * v52;
    const double v56 = 0x1.7fcd25610a7bep-17 * v53;
    const double v57 = v56 + (-0x1.5c240340d7499p-12);
    const double v59 = v57 * v53;
    const double v60 = v59 + 0x1.c0f85bb0bd6d8p-8;
    const double v62 = v60 * v53;
    const double v63 = v62 + (-0x1.5fec394ef3093p-4);
    const double v65 = v63 * v53;
    const double v66 = v65 + 0x1.2c981ff52d6d6p-1;
    const double v68 = v66 * v53;
    const double v69 = v68 + (-0x1.7217f7d1bdaacp-7);
    const double v72 = (-0x1.49f6ab92b4903p-18) * v53;
    const double v73 = v72 + 0x1.2705f10ad2bc9p-13;
    const double v75 = v73 * v53;
    const double v76 = v75 + (-0x1.a01ba6f54a2d2p-9);
    const double v78 = v76 * v53;
    const double v79 = v78 + 0x1.6c16c100ecd3dp-5;
    const double v81 = v79 * v53;
    const double v82 = v81 + (-0x1.555555552b82cp-2);
    const double v84 = v82 * v53;
    const double v85 = v84 + 0x1.00000000000d1p+0;
    const double v87 = 0x1.0000000000000p+1 * v52;
    const double v89 = v87 > 0x1.0000000000000p-60 ? v87 : 0x1.0000000000000p-60;
    const double v90 = significand_of(v89);
    const double v91 = v90 - 0x1.0000000000000p+0;
    const double v92 = v91 + 0x1.0000000000000p+1;
    const double v93 = v91 / v92;
    const double v94 = v93 * v93;
    const double v97 = 0x1.3cda08c7927d8p-3 * v94;
    const double v98 = v97 + 0x1.3804595ac79edp-3;
    const double v100 = v98 * v94;
    const double v101 = v100 + 0x1.747966b22b47ep-3;
    const double v103 = v101 * v94;
    const double v104 = v103 + 0x1.c71be01ef8d7bp-3;
    const double v106 = v104 * v94;
    const double v107 = v106 + 0x1.249249f1b0e53p-2;
    const double v109 = v107 * v94;
    const double v110 = v109 + 0x1.999999987c7a3p-2;
    const double v112 = v110 * v94;
    const double v113 = v112 + 0x1.55555555559d8p-1;
    const double v114 = v94 * v113;
    const double v115 = v114 - v91;
    const double v116 = exponent_of(v89);
    const double v118 = v116 * 0x1.62e42fefa39efp-1;
    const double v119 = v118 + v91;
    const double v120 = v93 * v115;
    const double v121 = v120 + v119;
    const double v122 = v85 * v121;
    const double v123 = v122 + v69;
    const double v124 = v53 * v123;
    const double v126 = v52 * (-0x1.e000000000000p+0);
    const double v127 = v126 + 0x1.0000000000000p+0;
    const double v128 = v52 * v127;
    const double v129 = v128 + v124;
    const double v131 = alpha + (-0x1.243f6a8885a30p-1);
    const double v132 = v131 + v129;
    const int v134 = alpha < 0x1.07ae147ae147bp+0;
    const double v135 = v134 ? v50 : v132;
    const double v138 = (-0x1.45b05b2cc572fp-42) * v2;
    const double v139 = v138 + (-0x1.21425b193f4e3p-39);
    const double v141 = v139 * v2;
    const double v142 = v141 + 0x1.66d4d675032fdp-33;
    const double v144 = v142 * v2;
    const double v145 = v144 + (-0x1.70f3f2a6450f9p-28);
    const double v147 = v145 * v2;
    const double v148 = v147 + 0x1.2f43fc0f3b961p-23;
    const double v150 = v148 * v2;
    const double v151 = v150 + (-0x1.952f5cfde36d4p-19);
    const double v153 = v151 * v2;
    const double v154 = v153 + 0x1.ae8cb07f844bap-15;
    const double v156 = v154 * v2;
    const double v157 = v156 + (-0x1.615085bd8844bp-11);
    const double v159 = v157 * v2;
    const double v160 = v159 + 0x1.af3b88aa5d36ep-8;
    const double v162 = v160 * v2;
    const double v163 = v162 + (-0x1.74c1f6ca168cfp-5);
    const double v165 = v163 * v2;
    const double v166 = v165 + 0x1.ad1ad1ad1acf1p-3;
    const double v168 = v166 * v2;
    const double v169 = v168 + (-0x1.3333333333333p-1);
    const double v170 = v169 * v2;
    const double v171 = 0x1.0000000000000p+0 + v170;
    const double v174 = (-0x1.6de90fa3c36d1p-23) * v53;
    const double v175 = v174 + 0x1.1d2bdb6e180adp-19;
    const double v177 = v175 * v53;
    const double v178 = v177 + (-0x1.1f88aff83463bp-15);
    const double v180 = v178 * v53;
    const double v181 = v180 + 0x1.d6a65d5d8efd9p-12;
    const double v183 = v181 * v53;
    const double v184 = v183 + (-0x1.1e5e2b53ee8f7p-8);
    const double v186 = v184 * v53;
    const double v187 = v186 + 0x1.e94dfdbeb29efp-6;
    const double v189 = v187 * v53;
    const double v190 = v189 + (-0x1.0cbb76636144ep-3);
    const double v192 = v190 * v53;
    const double v193 = v192 + 0x1.3e93e93e9a95cp-2;
    const double v195 = v193 * v53;
    const double v196 = v195 + (-0x1.c71c71c71cb31p-3);
    const double v198 = v196 * v53;
    const double v199 = v198 + (-0x1.555555555554ep-3);
    const double v201 = v52 * v199;
    const double v202 = v201 + 0x1.dffffffffffffp-4;
    const double v204 = 0x1.0000000000000p-1 * alpha;
    const double v206 = v204 + (-0x1.e000000000000p-4);
    const double v207 = v206 + v202;
    const double v208 = v134 ? v171 : v207;
    const double v209 = v135 / v208;
    return v209;
}
#define radial_weight_per_inertia_best_plain_KIND whole

INLINE double polar_moment_per_inertia_best_plain(double alpha)
{
    const double v2 = alpha * alpha;
    const double v5 = 0x1.b9b42a5028f70p-32 * v2;
    const double v6 = v5 + (-0x1.ec80049fb3d54p-30);
    const double v8 = v6 * v2;
    const double v9 = v8 + 0x1.4c5bfe80b82dfp-28;
    const double v11 = v9 * v2;
    const double v12 = v11 + (-0x1.9941b41d0cf69p-28);
    const double v14 = v12 * v2;
    const double v15 = v14 + 0x1.59b16de1aa5bbp-27;
    const double v17 = v15 * v2;
    const double v18 = v17 + 0x1.b88d2a10b198ep-28;
    const double v20 = v18 * v2;
    const double v21 = v20 + 0x1.8e96ce5791a84p-25;
    const double v23 = v21 * v2;
    const double v24 = v23 + 0x1.88c9611a62aaap-24;
    const double v26 = v24 * v2;
    const double v27 = v26 + 0x1.7b068d35efb42p-19;
    const double v29 = v27 * v2;
    const double v30 = v29 + (-0x1.8d4900e22cd37p-15);
    const double v32 = v30 * v2;
    const double v33 = v32 + 0x1.d0042d62d5390p-11;
    const double v35 = v33 * v2;
    const double v36 = v35 + (-0x1.5ac056b03787fp-7);
    const double v38 = v36 * v2;
    const double v39 = v38 + 0x1.5f15f15f16133p-4;
    const double v41 = v39 * v2;
    const double v42 = v41 + (-0x1.999999999999bp-2);
    const double v43 = v42 * v2;
    const double v44 = 0x1.0000000000000p+0 + v43;
    const double v46 = 0x1.921fb54442d18p+0 - alpha;
    const double v47 = v46 * v46;
    const double v50 = 0x1.15ac79423b8b0p-15 * v47;
    const double v51 = v50 + (-0x1.0589062751e4cp-11);
    const double v53 = v51 * v47;
    const double v54 = v53 + 0x1.556dc54d73912p-8;
    const double v56 = v54 * v47;
    const double v57 = v56 + (-0x1.0ee09496505b1p-5);
    const double v59 = v57 * v47;
    const double v60 = v59 + 0x1.94ebfb7c3ce42p-4;
    const double v62 = v60 * v47;
    const double v63 = v62 + (-0x1.213ce231c73c8p-7);
    const double v66 = (-0x1.b34a574a5ccacp-16) * v47;
    const double v67 = v66 + 0x1.807b27aa47e52p-12;
    const double v69 = v67 * v47;
    const double v70 = v69 + (-0x1.2837b580b3980p-8);
    const double v72 = v70 * v47;
    const double v73 = v72 + 0x1.27d270f96a29bp-5;
    const double v75 = v73 * v47;
    const double v76 = v75 + (-0x1.5555555ce08d5p-3);
    const double v78 = v76 * v47;
    const double v79 = v78 + 0x1.555555555434bp-2;
    const double v81 = v46 > 0x1.0000000000000p-60 ? v46 : 0x1.0000000000000p-60;
    const double v82 = significand_of(v81);
    const double v83 = v82 - 0x1.0000000000000p+0;
    const double v85 = v83 + 0x1.0000000000000p+1;
    const double v86 = v83 / v85;
    const double v87 = v86 * v86;
    const double v90 = 0x1.3cda08c7927d8p-3 * v87;
    const double v91 = v90 + 0x1.3804595ac79edp-3;
    const double v93 = v91 * v87;
    const double v94 = v93 + 0x1.747966b22b47ep-3;
    const double v96 = v94 * v87;
    const double v97 = v96 + 0x1.c71be01ef8d7bp-3;
    const double v99 = v97 * v87;
    const double v100 = v99 + 0x1.249249f1b0e53p-2;
    const double v102 = v100 * v87;
    const double v103 = v102 + 0x1.999999987c7a3p-2;
    const double v105 = v103 * v87;
    const double v106 = v105 + 0x1.55555555559d8p-1;
    const double v107 = v87 * v106;
    const double v108 = v107 - v83;
    const double v109 = exponent_of(v81);
    const double v111 = v109 * 0x1.62e42fefa39efp-1;
    const double v112 = v111 + v83;
    const double v113 = v86 * v108;
    const double v114 = v113 + v112;
    const double v115 = v79 * v114;
    const double v116 = v115 + v63;
    const double v117 = v46 * v47;
    const double v119 = v117 * v116;
    const double v120 = v119 + 0x1.ee6913347c2a6p-55;
    const double v122 = alpha + (-0x1.0c152382d7366p-1);
    const double v123 = v122 + v120;
    const int v124 = alpha < 0x1.0000000000000p+0;
    const double v125 = v124 ? v44 : v123;
    const double v128 = (-0x1.06aa0de1b2785p-38) * v2;
    const double v129 = v128 + 0x1.701f99390685dp-33;
    const double v131 = v129 * v2;
    const double v132 = v131 + (-0x1.715e85182e3c6p-28);
    const double v134 = v132 * v2;
    const double v135 = v134 + 0x1.2f46f95e97102p-23;
    const double v137 = v135 * v2;
    const double v138 = v137 + (-0x1.952f78d94e8b4p-19);
    const double v140 = v138 * v2;
    const double v141 = v140 + 0x1.ae8cb1283bb0dp-15;
    const double v143 = v141 * v2;
    const double v144 = v143 + (-0x1.615085c00e86dp-11);
    const double v146 = v144 * v2;
    const double v147 = v146 + 0x1.af3b88aa68aebp-8;
    const double v149 = v147 * v2;
    const double v150 = v149 + (-0x1.74c1f6ca16a80p-5);
    const double v152 = v150 * v2;
    const double v153 = v152 + 0x1.ad1ad1ad1acf4p-3;
    const double v155 = v153 * v2;
    const double v156 = v155 + (-0x1.3333333333333p-1);
    const double v157 = v156 * v2;
    const double v158 = 0x1.0000000000000p+0 + v157;
    const double v161 = (-0x1.00589fe65ed98p-23) * v47;
    const double v162 = v161 + 0x1.1425220d45aaap-19;
    const double v164 = v162 * v47;
    const double v165 = v164 + (-0x1.1f397f95f7403p-15);
    const double v167 = v165 * v47;
    const double v168 = v167 + 0x1.d6a371cc475cdp-12;
    const double v170 = v168 * v47;
    const double v171 = v170 + (-0x1.1e5e23528aa32p-8);
    const double v173 = v171 * v47;
    const double v174 = v173 + 0x1.e94dfd8b6e6d2p-6;
    const double v176 = v174 * v47;
    const double v177 = v176 + (-0x1.0cbb76630619cp-3);
    const double v179 = v177 * v47;
    const double v180 = v179 + 0x1.3e93e93e9959dp-2;
    const double v182 = v180 * v47;
    const double v183 = v182 + (-0x1.c71c71c71cad2p-3);
    const double v185 = v183 * v47;
    const double v186 = v185 + (-0x1.555555555554ep-3);
    const double v188 = v46 * v186;
    const double v189 = v188 + 0x1.dffffffffffffp-4;
    const double v191 = 0x1.0000000000000p-1 * alpha;
    const double v193 = v191 + (-0x1.e000000000000p-4);
    const double v194 = v193 + v189;
    const double v195 = v124 ? v158 : v194;
    const double v196 = v125 / v195;
    return v196;
}
#define polar_moment_per_inertia_best_plain_KIND whole

INLINE double weight_moment_per_radial_weight_best_plain(double alpha)
{
    const double v2 = alpha * alpha;
    const double v5 = 0x1.d5a4e25649554p-41 * v2;
    const double v6 = v5 + (-0x1.c093be0569f32p-35);
    const double v8 = v6 * v2;
    const double v9 = v8 + 0x1.48415120bdd7dp-29;
    const double v11 = v9 * v2;
    const double v12 = v11 + (-0x1.85d83c514d29ap-24);
    const double v14 = v12 * v2;
    const double v15 = v14 + 0x1.702ffd482ffbdp-19;
    const double v17 = v15 * v2;
    const double v18 = v17 + (-0x1.0c7836b1a0daep-14);
    const double v20 = v18 * v2;
    const double v21 = v20 + 0x1.22d671ab5580dp-10;
    const double v23 = v21 * v2;
    const double v24 = v23 + (-0x1.bc466f119ba3ep-7);
    const double v26 = v24 * v2;
    const double v27 = v26 + 0x1.bbbbbbbbbbbb9p-4;
    const double v29 = v27 * v2;
    const double v30 = v29 + (-0x1.0000000000000p-1);
    const double v31 = v30 * v2;
    const double v32 = 0x1.0000000000000p+0 + v31;
    const double v34 = 0x1.921fb54442d18p+0 - alpha;
    const double v35 = v34 * v34;
    const double v38 = 0x1.62a1ce00bcbbbp-22 * v35;
    const double v39 = v38 + (-0x1.329a1a829faa0p-17);
    const double v41 = v39 * v35;
    const double v42 = v41 + 0x1.83c9d9bc521a1p-13;
    const double v44 = v42 * v35;
    const double v45 = v44 + (-0x1.637e07e2724b1p-9);
    const double v47 = v45 * v35;
    const double v48 = v47 + 0x1.bc8bc8b5880b7p-6;
    const double v50 = v48 * v35;
    const double v51 = v50 + (-0x1.5b05b05afba3bp-3);
    const double v53 = v51 * v35;
    const double v54 = v53 + 0x1.2aaaaaaaaaa01p-1;
    const double v55 = v35 * v35;
    const double v58 = v34 * (-0x1.1a62633145c07p-53);
    const double v59 = v58 + (-0x1.5555555555556p-54);
    const double v60 = v55 * v54;
    const double v61 = v60 + v59;
    const double v64 = v34 * (-0x1.0000000000000p+0);
    const double v65 = v64 + 0x1.0000000000000p-1;
    const double v66 = v34 * v65;
    const double v67 = v66 + v61;
    const double v68 = 0x1.0000000000000p-1 * alpha;
    const double v70 = v68 + (-0x1.e652ff776be10p-4);
    const double v71 = v70 + v67;
    const int v73 = alpha < 0x1.07ae147ae147bp+0;
    const double v74 = v73 ? v32 : v71;
    const double v77 = (-0x1.2602c2b4216f8p-29) * v2;
    const double v78 = v77 + 0x1.cbd5f63622b49p-27;
    const double v80 = v78 * v2;
    const double v81 = v80 + (-0x1.707239a982081p-25);
    const double v83 = v81 * v2;
    const double v84 = v83 + 0x1.5c0717fe10388p-24;
    const double v86 = v84 * v2;
    const double v87 = v86 + (-0x1.e6629131fe7cep-24);
    const double v89 = v87 * v2;
    const double v90 = v89 + 0x1.8284b98d3ef10p-24;
    const double v92 = v90 * v2;
    const double v93 = v92 + (-0x1.e67c4929e3d9ap-24);
    const double v95 = v93 * v2;
    const double v96 = v95 + (-0x1.aef8388bf9a7dp-24);
    const double v98 = v96 * v2;
    const double v99 = v98 + (-0x1.fc3a7b71ed83bp-22);
    const double v101 = v99 * v2;
    const double v102 = v101 + (-0x1.aba5f589eb2edp-20);
    const double v104 = v102 * v2;
    const double v105 = v104 + (-0x1.8201fa45d5e98p-18);
    const double v107 = v105 * v2;
    const double v108 = v107 + (-0x1.8bc37ba4a9e9cp-16);
    const double v110 = v108 * v2;
    const double v111 = v110 + (-0x1.ebc1aebec88f9p-16);
    const double v113 = v111 * v2;
    const double v114 = v113 + (-0x1.0cbb7661039a4p-9);
    const double v116 = v114 * v2;
    const double v117 = v116 + 0x1.c09c09c09b21ap-6;
    const double v119 = v117 * v2;
    const double v120 = v119 + (-0x1.3333333333331p-2);
    const double v121 = v120 * v2;
    const double v122 = 0x1.0000000000000p+0 + v121;
    const double v125 = 0x1.7fcd25610a7bep-17 * v35;
    const double v126 = v125 + (-0x1.5c240340d7499p-12);
    const double v128 = v126 * v35;
    const double v129 = v128 + 0x1.c0f85bb0bd6d8p-8;
    const double v131 = v129 * v35;
    const double v132 = v131 + (-0x1.5fec394ef3093p-4);
    const double v134 = v132 * v35;
    const double v135 = v134 + 0x1.2c981ff52d6d6p-1;
    const double v137 = v135 * v35;
    const double v138 = v137 + (-0x1.7217f7d1bdaacp-7);
    const double v141 = (-0x1.49f6ab92b4903p-18) * v35;
    const double v142 = v141 + 0x1.2705f10ad2bc9p-13;
    const double v144 = v142 * v35;
    const double v145 = v144 + (-0x1.a01ba6f54a2d2p-9);
    const double v147 = v145 * v35;
    const double v148 = v147 + 0x1.6c16c100ecd3dp-5;
    const double v150 = v148 * v35;
    const double v151 = v150 + (-0x1.555555552b82cp-2);
    const double v153 = v151 * v35;
    const double v154 = v153 + 0x1.00000000000d1p+0;
    const double v156 = 0x1.0000000000000p+1 * v34;
    const double v158 = v156 > 0x1.0000000000000p-60 ? v156 : 0x1.0000000000000p-60;
    const double v159 = significand_of(v158);
    const double v160 = v159 - 0x1.0000000000000p+0;
    const double v161 = v160 + 0x1.0000000000000p+1;
    const double v162 = v160 / v161;
    const double v163 = v162 * v162;
    const double v166 = 0x1.3cda08c7927d8p-3 * v163;
    const double v167 = v166 + 0x1.3804595ac79edp-3;
    const double v169 = v167 * v163;
    const double v170 = v169 + 0x1.747966b22b47ep-3;
    const double v172 = v170 * v163;
    const double v173 = v172 + 0x1.c71be01ef8d7bp-3;
    const double v175 = v173 * v163;
    const double v176 = v175 + 0x1.249249f1b0e53p-2;
    const double v178 = v176 * v163;
    const double v179 = v178 + 0x1.999999987c7a3p-2;
    const double v181 = v179 * v163;
    const double v182 = v181 + 0x1.55555555559d8p-1;
    const double v183 = v163 * v182;
    const double v184 = v183 - v160;
    const double v185 = exponent_of(v158);
    const double v187 = v185 * 0x1.62e42fefa39efp-1;
    const double v188 = v187 + v160;
    const double v189 = v162 * v184;
    const double v190 = v189 + v188;
    const double v191 = v154 * v190;
    const double v192 = v191 + v138;
    const double v193 = v35 * v192;
    const double v195 = v34 * (-0x1.e000000000000p+0);
    const double v196 = v195 + 0x1.0000000000000p+0;
    const double v197 = v34 * v196;
    const double v198 = v197 + v193;
    const double v200 = alpha + (-0x1.243f6a8885a30p-1);
    const double v201 = v200 + v198;
    const double v202 = v73 ? v122 : v201;
    const double v203 = v74 / v202;
    return v203;
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
#define RUN_pieces(T, PROGRAM) if (NEGATIVE(above)) BARE(T, PROGRAM) else BARE(T, PROGRAM##_below)
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
