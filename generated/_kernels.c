/* Written by `python -m derive` with SymPy 1.14.0; do not edit. */
#define DIGEST "2eeba247028410fcf0c5b0cc4b0eb7846b014e60c57708e192ce38b8391590d1"
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
    const double v7 = __builtin_fma((-0x1.193b19ef5c23bp-30), v4, (-0x1.901eb3e3eb095p-28));
    const double v9 = __builtin_fma(v7, v4, (-0x1.47aac75a405bfp-28));
    const double v11 = __builtin_fma(v9, v4, 0x1.d3b86ab5c000bp-26);
    const double v13 = __builtin_fma(v11, v4, 0x1.f948b3dad684fp-20);
    const double v15 = __builtin_fma(v13, v4, 0x1.35581e11affcep-11);
    const double v18 = __builtin_fma(0x1.74252957b0351p-33, v4, 0x1.bd01f9ca630bbp-29);
    const double v20 = __builtin_fma(v18, v4, 0x1.1b3183a5c4eddp-27);
    const double v22 = __builtin_fma(v20, v4, 0x1.9b302f0b75252p-27);
    const double v24 = __builtin_fma(v22, v4, 0x1.0b5b7c104b9c6p-24);
    const double v26 = __builtin_fma(v24, v4, (-0x1.08db39a994468p-15));
    const double v28 = __builtin_fma(v26, v4, (-0x1.ce55c8ea93fc3p-8));
    const double v29 = __builtin_fma(v1, v15, v28);
    const double v31 = __builtin_fma(v1, v29, 0x1.d41d41d41d0e9p-5);
    const double v33 = __builtin_fma(v31, v1, (-0x1.1111111111110p-2));
    const double v35 = __builtin_fma(v33, v1, 0x1.5555555555555p-1);
    const double v36 = 0x1.5555555555555p-1 - v35;
    const double v37 = __builtin_fma(v33, v1, v36);
    const double v38 = (-0x1.1111111111110p-2) - v33;
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
    const double v59 = __builtin_fma(0x1.142a50dc4a9dep-15, v56, (-0x1.058191e40d3cfp-11));
    const double v61 = __builtin_fma(v59, v56, 0x1.556fa69a4a6aep-8);
    const double v63 = __builtin_fma(v61, v56, (-0x1.0ee08d6ddcdd4p-5));
    const double v65 = __builtin_fma(v63, v56, 0x1.94ebfb8ed1634p-4);
    const double v67 = __builtin_fma(v65, v56, (-0x1.213ce2316924dp-7));
    const double v70 = __builtin_fma((-0x1.b08fc34d11d4dp-16), v56, 0x1.80dd0f969ca49p-12);
    const double v72 = __builtin_fma(v70, v56, (-0x1.2835c7b8e7a0fp-8));
    const double v74 = __builtin_fma(v72, v56, 0x1.27d27519db656p-5);
    const double v76 = __builtin_fma(v74, v56, (-0x1.55555559507f8p-3));
    const double v78 = __builtin_fma(v76, v56, 0x1.5555555554f26p-2);
    const double v80 = v55 > 0x1.0000000000000p-60 ? v55 : 0x1.0000000000000p-60;
    const double v81 = significand_of(v80);
    const double v83 = v81 - 0x1.0000000000000p+0;
    const double v84 = v83 + 0x1.0000000000000p+1;
    const double v85 = v83 / v84;
    const double v86 = v85 * v85;
    const double v89 = __builtin_fma(0x1.3cda08c7927d8p-3, v86, 0x1.3804595ac79edp-3);
    const double v91 = __builtin_fma(v89, v86, 0x1.747966b22b47ep-3);
    const double v93 = __builtin_fma(v91, v86, 0x1.c71be01ef8d7bp-3);
    const double v95 = __builtin_fma(v93, v86, 0x1.249249f1b0e53p-2);
    const double v97 = __builtin_fma(v95, v86, 0x1.999999987c7a3p-2);
    const double v99 = __builtin_fma(v97, v86, 0x1.55555555559d8p-1);
    const double v100 = -v83;
    const double v101 = __builtin_fma(v86, v99, v100);
    const double v102 = exponent_of(v80);
    const double v104 = __builtin_fma(v102, 0x1.62e42fefa39efp-1, v83);
    const double v105 = __builtin_fma(v85, v101, v104);
    const double v106 = __builtin_fma(v78, v105, v67);
    const double v107 = v55 * v56;
    const double v109 = __builtin_fma(v107, v106, 0x1.fab71f4a3269fp-7);
    const double v111 = alpha + (-0x1.1400000000000p-1);
    const double v112 = v111 + v109;
    const int v114 = alpha < 0x1.0f5c28f5c28f6p+0;
    const double v115 = v114 ? v53 : v112;
    return v115;
}
#define polar_moment_best_fused_KIND pieces
#define polar_moment_best_fused_BELOW_double UINT64_C(0x3ff0f5c28f5c28f5)
#define polar_moment_best_fused_BELOW_float UINT32_C(0x3f87ae14)
INLINE double polar_moment_best_fused_below(double alpha)
{
    const double v1 = alpha * alpha;
    const double v2 = -v1;
    const double v3 = __builtin_fma(alpha, alpha, v2);
    const double v4 = v1 * v1;
    const double v7 = __builtin_fma((-0x1.193b19ef5c23bp-30), v4, (-0x1.901eb3e3eb095p-28));
    const double v9 = __builtin_fma(v7, v4, (-0x1.47aac75a405bfp-28));
    const double v11 = __builtin_fma(v9, v4, 0x1.d3b86ab5c000bp-26);
    const double v13 = __builtin_fma(v11, v4, 0x1.f948b3dad684fp-20);
    const double v15 = __builtin_fma(v13, v4, 0x1.35581e11affcep-11);
    const double v18 = __builtin_fma(0x1.74252957b0351p-33, v4, 0x1.bd01f9ca630bbp-29);
    const double v20 = __builtin_fma(v18, v4, 0x1.1b3183a5c4eddp-27);
    const double v22 = __builtin_fma(v20, v4, 0x1.9b302f0b75252p-27);
    const double v24 = __builtin_fma(v22, v4, 0x1.0b5b7c104b9c6p-24);
    const double v26 = __builtin_fma(v24, v4, (-0x1.08db39a994468p-15));
    const double v28 = __builtin_fma(v26, v4, (-0x1.ce55c8ea93fc3p-8));
    const double v29 = __builtin_fma(v1, v15, v28);
    const double v31 = __builtin_fma(v1, v29, 0x1.d41d41d41d0e9p-5);
    const double v33 = __builtin_fma(v31, v1, (-0x1.1111111111110p-2));
    const double v35 = __builtin_fma(v33, v1, 0x1.5555555555555p-1);
    const double v36 = 0x1.5555555555555p-1 - v35;
    const double v37 = __builtin_fma(v33, v1, v36);
    const double v38 = (-0x1.1111111111110p-2) - v33;
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
    const double v7 = __builtin_fma(0x1.a8ba4759b0fdap-34, v4, 0x1.941f1c14d0473p-24);
    const double v9 = __builtin_fma(v7, v4, 0x1.1f08650cd3114p-15);
    const double v11 = __builtin_fma(v9, v4, 0x1.1f7d05c3f1e63p-8);
    const double v14 = __builtin_fma((-0x1.e71abb89b23b1p-29), v4, (-0x1.0e1dd50de3f07p-19));
    const double v16 = __builtin_fma(v14, v4, (-0x1.d71606dd73949p-12));
    const double v18 = __builtin_fma(v16, v4, (-0x1.f1029e62af137p-6));
    const double v19 = __builtin_fma(v1, v11, v18);
    const double v21 = __builtin_fma(v1, v19, 0x1.1e11e11e11a83p-3);
    const double v23 = __builtin_fma(v21, v1, (-0x1.999999999998fp-2));
    const double v25 = __builtin_fma(v23, v1, 0x1.5555555555555p-1);
    const double v26 = 0x1.5555555555555p-1 - v25;
    const double v27 = __builtin_fma(v23, v1, v26);
    const double v28 = (-0x1.999999999998fp-2) - v23;
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
    const double v49 = __builtin_fma(0x1.f4ffb320b7c92p-20, v46, (-0x1.1e264f7e219b6p-15));
    const double v51 = __builtin_fma(v49, v46, 0x1.d696da6d44e9dp-12);
    const double v53 = __builtin_fma(v51, v46, (-0x1.1e5df77310522p-8));
    const double v55 = __builtin_fma(v53, v46, 0x1.e94dfc180d8d8p-6);
    const double v57 = __builtin_fma(v55, v46, (-0x1.0cbb765f6105bp-3));
    const double v59 = __builtin_fma(v57, v46, 0x1.3e93e93e8513fp-2);
    const double v61 = __builtin_fma(v59, v46, (-0x1.c71c71c71bd51p-3));
    const double v63 = __builtin_fma(v61, v46, (-0x1.5555555555569p-3));
    const double v65 = __builtin_fma(v45, v63, 0x1.1000000000000p-3);
    const double v67 = 0x1.0000000000000p-1 * alpha;
    const double v69 = v67 + (-0x1.1000000000000p-3);
    const double v70 = v69 + v65;
    const int v72 = alpha < 0x1.0a3d70a3d70a4p+0;
    const double v73 = v72 ? v43 : v70;
    return v73;
}
#define moment_of_inertia_best_fused_KIND pieces
#define moment_of_inertia_best_fused_BELOW_double UINT64_C(0x3ff0a3d70a3d70a3)
#define moment_of_inertia_best_fused_BELOW_float UINT32_C(0x3f851eb8)
INLINE double moment_of_inertia_best_fused_below(double alpha)
{
    const double v1 = alpha * alpha;
    const double v2 = -v1;
    const double v3 = __builtin_fma(alpha, alpha, v2);
    const double v4 = v1 * v1;
    const double v7 = __builtin_fma(0x1.a8ba4759b0fdap-34, v4, 0x1.941f1c14d0473p-24);
    const double v9 = __builtin_fma(v7, v4, 0x1.1f08650cd3114p-15);
    const double v11 = __builtin_fma(v9, v4, 0x1.1f7d05c3f1e63p-8);
    const double v14 = __builtin_fma((-0x1.e71abb89b23b1p-29), v4, (-0x1.0e1dd50de3f07p-19));
    const double v16 = __builtin_fma(v14, v4, (-0x1.d71606dd73949p-12));
    const double v18 = __builtin_fma(v16, v4, (-0x1.f1029e62af137p-6));
    const double v19 = __builtin_fma(v1, v11, v18);
    const double v21 = __builtin_fma(v1, v19, 0x1.1e11e11e11a83p-3);
    const double v23 = __builtin_fma(v21, v1, (-0x1.999999999998fp-2));
    const double v25 = __builtin_fma(v23, v1, 0x1.5555555555555p-1);
    const double v26 = 0x1.5555555555555p-1 - v25;
    const double v27 = __builtin_fma(v23, v1, v26);
    const double v28 = (-0x1.999999999998fp-2) - v23;
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
    const double v7 = __builtin_fma((-0x1.118c1ab6478a7p-30), v4, (-0x1.808764f9c7467p-25));
    const double v9 = __builtin_fma(v7, v4, (-0x1.0da38495dca49p-22));
    const double v11 = __builtin_fma(v9, v4, (-0x1.98a0e625ac4aap-22));
    const double v13 = __builtin_fma(v11, v4, (-0x1.c9c7a0d4325bbp-23));
    const double v15 = __builtin_fma(v13, v4, (-0x1.69604923282bfp-22));
    const double v17 = __builtin_fma(v15, v4, (-0x1.01678419751a3p-18));
    const double v19 = __builtin_fma(v17, v4, (-0x1.47d680513384ep-16));
    const double v22 = __builtin_fma(0x1.4c4121214b1efp-27, v4, 0x1.124061f8f1f6dp-23);
    const double v24 = __builtin_fma(v22, v4, 0x1.7dcaed0b76a63p-22);
    const double v26 = __builtin_fma(v24, v4, 0x1.3c0c18c594a0bp-22);
    const double v28 = __builtin_fma(v26, v4, (-0x1.5fa25ecf780ffp-28));
    const double v30 = __builtin_fma(v28, v4, (-0x1.1bab41746e402p-20));
    const double v32 = __builtin_fma(v30, v4, (-0x1.07d71cad9a82ep-16));
    const double v34 = __builtin_fma(v32, v4, (-0x1.664f487ef01ffp-10));
    const double v35 = __builtin_fma(v1, v19, v34);
    const double v37 = __builtin_fma(v1, v35, 0x1.2b12b12b11157p-6);
    const double v39 = __builtin_fma(v37, v1, (-0x1.9999999999992p-3));
    const double v41 = __builtin_fma(v39, v1, 0x1.5555555555555p-1);
    const double v42 = 0x1.5555555555555p-1 - v41;
    const double v43 = __builtin_fma(v39, v1, v42);
    const double v44 = (-0x1.9999999999992p-3) - v39;
    const double v45 = __builtin_fma(v37, v1, v44);
    const double v47 = v43 + 0x1.5555555555555p-55;
    const double v48 = __builtin_fma(v1, v45, v47);
    const double v51 = __builtin_fma(0x1.0000000000000p+1, v41, (-0x1.5555555555555p-1));
    const double v52 = __builtin_fma(v2, v44, v51);
    const double v53 = v1 * v41;
    const double v54 = -v53;
    const double v55 = __builtin_fma(v1, v41, v54);
    const double v56 = __builtin_fma(v3, v52, v55);
    const double v57 = __builtin_fma(v1, v48, v56);
    const double v58 = alpha * v57;
    const double v59 = __builtin_fma(alpha, v53, v58);
    const double v61 = 0x1.921fb54442d18p+0 - alpha;
    const double v62 = v61 * v61;
    const double v65 = __builtin_fma(0x1.536149c083855p-17, v62, (-0x1.5c87336390abap-12));
    const double v67 = __builtin_fma(v65, v62, 0x1.c0fa7521974f7p-8);
    const double v69 = __builtin_fma(v67, v62, (-0x1.5fec361a7a6e3p-4));
    const double v71 = __builtin_fma(v69, v62, 0x1.2c981ff65e78ap-1);
    const double v73 = __builtin_fma(v71, v62, 0x1.d1bd0105cacaap-4);
    const double v76 = __builtin_fma((-0x1.11c7f03358b1fp-18), v62, 0x1.29896a4b09812p-13);
    const double v78 = __builtin_fma(v76, v62, (-0x1.a013dfccb8a12p-9));
    const double v80 = __builtin_fma(v78, v62, 0x1.6c16c5c417f46p-5);
    const double v82 = __builtin_fma(v80, v62, (-0x1.55555554239ddp-2));
    const double v84 = __builtin_fma(v82, v62, 0x1.0000000000175p+0);
    const double v85 = 0x1.0000000000000p+1 * v61;
    const double v87 = v85 > 0x1.0000000000000p-60 ? v85 : 0x1.0000000000000p-60;
    const double v88 = significand_of(v87);
    const double v90 = v88 - 0x1.0000000000000p+0;
    const double v91 = v90 + 0x1.0000000000000p+1;
    const double v92 = v90 / v91;
    const double v93 = v92 * v92;
    const double v96 = __builtin_fma(0x1.3cda08c7927d8p-3, v93, 0x1.3804595ac79edp-3);
    const double v98 = __builtin_fma(v96, v93, 0x1.747966b22b47ep-3);
    const double v100 = __builtin_fma(v98, v93, 0x1.c71be01ef8d7bp-3);
    const double v102 = __builtin_fma(v100, v93, 0x1.249249f1b0e53p-2);
    const double v104 = __builtin_fma(v102, v93, 0x1.999999987c7a3p-2);
    const double v106 = __builtin_fma(v104, v93, 0x1.55555555559d8p-1);
    const double v107 = -v90;
    const double v108 = __builtin_fma(v93, v106, v107);
    const double v109 = exponent_of(v87);
    const double v111 = __builtin_fma(v109, 0x1.62e42fefa39efp-1, v90);
    const double v112 = __builtin_fma(v92, v108, v111);
    const double v113 = __builtin_fma(v84, v112, v73);
    const double v115 = __builtin_fma(v62, v113, 0x1.3c095777a5d00p-6);
    const double v118 = __builtin_fma(v61, (-0x1.0000000000000p+1), 0x1.0000000000000p-1);
    const double v119 = __builtin_fma(v61, v118, v115);
    const double v120 = 0x1.0000000000000p-1 * alpha;
    const double v122 = v120 + 0x1.9000000000000p-3;
    const double v123 = v122 + v119;
    const int v125 = alpha < 0x1.23d70a3d70a3dp+0;
    const double v126 = v125 ? v59 : v123;
    return v126;
}
#define radial_weight_amplitude_best_fused_KIND pieces
#define radial_weight_amplitude_best_fused_BELOW_double UINT64_C(0x3ff23d70a3d70a3c)
#define radial_weight_amplitude_best_fused_BELOW_float UINT32_C(0x3f91eb85)
INLINE double radial_weight_amplitude_best_fused_below(double alpha)
{
    const double v1 = alpha * alpha;
    const double v2 = -v1;
    const double v3 = __builtin_fma(alpha, alpha, v2);
    const double v4 = v1 * v1;
    const double v7 = __builtin_fma((-0x1.118c1ab6478a7p-30), v4, (-0x1.808764f9c7467p-25));
    const double v9 = __builtin_fma(v7, v4, (-0x1.0da38495dca49p-22));
    const double v11 = __builtin_fma(v9, v4, (-0x1.98a0e625ac4aap-22));
    const double v13 = __builtin_fma(v11, v4, (-0x1.c9c7a0d4325bbp-23));
    const double v15 = __builtin_fma(v13, v4, (-0x1.69604923282bfp-22));
    const double v17 = __builtin_fma(v15, v4, (-0x1.01678419751a3p-18));
    const double v19 = __builtin_fma(v17, v4, (-0x1.47d680513384ep-16));
    const double v22 = __builtin_fma(0x1.4c4121214b1efp-27, v4, 0x1.124061f8f1f6dp-23);
    const double v24 = __builtin_fma(v22, v4, 0x1.7dcaed0b76a63p-22);
    const double v26 = __builtin_fma(v24, v4, 0x1.3c0c18c594a0bp-22);
    const double v28 = __builtin_fma(v26, v4, (-0x1.5fa25ecf780ffp-28));
    const double v30 = __builtin_fma(v28, v4, (-0x1.1bab41746e402p-20));
    const double v32 = __builtin_fma(v30, v4, (-0x1.07d71cad9a82ep-16));
    const double v34 = __builtin_fma(v32, v4, (-0x1.664f487ef01ffp-10));
    const double v35 = __builtin_fma(v1, v19, v34);
    const double v37 = __builtin_fma(v1, v35, 0x1.2b12b12b11157p-6);
    const double v39 = __builtin_fma(v37, v1, (-0x1.9999999999992p-3));
    const double v41 = __builtin_fma(v39, v1, 0x1.5555555555555p-1);
    const double v42 = 0x1.5555555555555p-1 - v41;
    const double v43 = __builtin_fma(v39, v1, v42);
    const double v44 = (-0x1.9999999999992p-3) - v39;
    const double v45 = __builtin_fma(v37, v1, v44);
    const double v47 = v43 + 0x1.5555555555555p-55;
    const double v48 = __builtin_fma(v1, v45, v47);
    const double v51 = __builtin_fma(0x1.0000000000000p+1, v41, (-0x1.5555555555555p-1));
    const double v52 = __builtin_fma(v2, v44, v51);
    const double v53 = v1 * v41;
    const double v54 = -v53;
    const double v55 = __builtin_fma(v1, v41, v54);
    const double v56 = __builtin_fma(v3, v52, v55);
    const double v57 = __builtin_fma(v1, v48, v56);
    const double v58 = alpha * v57;
    const double v59 = __builtin_fma(alpha, v53, v58);
    return v59;
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
    const double v6 = __builtin_fma(0x1.3cfcc3c3dc6ebp-2, v3, 0x1.5c3fe8cc9aaa0p+2);
    const double v8 = __builtin_fma(v6, v3, 0x1.816280b47e4c5p+4);
    const double v10 = __builtin_fma(v8, v3, 0x1.bb4bf0c970e93p+4);
    const double v12 = __builtin_fma(v10, v3, 0x1.c85b59ccf7e43p+2);
    const double v14 = __builtin_fma(v12, v3, 0x1.0834666ddd492p-2);
    const double v15 = v14 * v1;
    const double v18 = __builtin_fma((-0x1.3b15ecf57e019p+1), v3, 0x1.522412f400f39p+5);
    const double v20 = __builtin_fma(v18, v3, 0x1.6d637ba392228p+6);
    const double v22 = __builtin_fma(v20, v3, 0x1.b0786efcf9f8bp+4);
    const double v24 = __builtin_fma(v22, v3, 0x1.0000000000000p+0);
    const double v25 = v15 / v24;
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
    const double v7 = __builtin_fma(0x1.2a361f9003235p-41, v4, 0x1.b594a1501d7fep-30);
    const double v9 = __builtin_fma(v7, v4, 0x1.eaeaa11069e73p-20);
    const double v11 = __builtin_fma(v9, v4, 0x1.83c8978eb147ap-11);
    const double v14 = __builtin_fma((-0x1.29c691f90f0d3p-35), v4, (-0x1.03e502c0de95ep-24));
    const double v16 = __builtin_fma(v14, v4, (-0x1.65f59e2b28380p-15));
    const double v18 = __builtin_fma(v16, v4, (-0x1.282ef4b666a5bp-7));
    const double v19 = __builtin_fma(v1, v11, v18);
    const double v21 = __builtin_fma(v1, v19, 0x1.27d27d27d27a2p-4);
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
    const double v49 = __builtin_fma(0x1.629d6790f59cdp-22, v46, (-0x1.329964da2a8a0p-17));
    const double v51 = __builtin_fma(v49, v46, 0x1.83c9cfd63f094p-13);
    const double v53 = __builtin_fma(v51, v46, (-0x1.637e07a789800p-9));
    const double v55 = __builtin_fma(v53, v46, 0x1.bc8bc8b4233bfp-6);
    const double v57 = __builtin_fma(v55, v46, (-0x1.5b05b05af73fdp-3));
    const double v59 = __builtin_fma(v57, v46, 0x1.2aaaaaaaaa92ep-1);
    const double v61 = __builtin_fma(v59, v46, (-0x1.ffffffffffff2p-3));
    const double v64 = __builtin_fma(v45, (-0x1.1a62633145c07p-53), (-0x1.94bfdddaf8555p-10));
    const double v65 = __builtin_fma(v46, v61, v64);
    const double v68 = __builtin_fma(v45, (-0x1.8000000000000p-1), 0x1.0000000000000p-1);
    const double v69 = __builtin_fma(v45, v68, v65);
    const double v70 = 0x1.0000000000000p-1 * alpha;
    const double v72 = v70 + (-0x1.e000000000000p-4);
    const double v73 = v72 + v69;
    const int v75 = alpha < 0x1.0a3d70a3d70a4p+0;
    const double v76 = v75 ? v43 : v73;
    return v76;
}
#define weight_moment_amplitude_best_fused_KIND pieces
#define weight_moment_amplitude_best_fused_BELOW_double UINT64_C(0x3ff0a3d70a3d70a3)
#define weight_moment_amplitude_best_fused_BELOW_float UINT32_C(0x3f851eb8)
INLINE double weight_moment_amplitude_best_fused_below(double alpha)
{
    const double v1 = alpha * alpha;
    const double v2 = -v1;
    const double v3 = __builtin_fma(alpha, alpha, v2);
    const double v4 = v1 * v1;
    const double v7 = __builtin_fma(0x1.2a361f9003235p-41, v4, 0x1.b594a1501d7fep-30);
    const double v9 = __builtin_fma(v7, v4, 0x1.eaeaa11069e73p-20);
    const double v11 = __builtin_fma(v9, v4, 0x1.83c8978eb147ap-11);
    const double v14 = __builtin_fma((-0x1.29c691f90f0d3p-35), v4, (-0x1.03e502c0de95ep-24));
    const double v16 = __builtin_fma(v14, v4, (-0x1.65f59e2b28380p-15));
    const double v18 = __builtin_fma(v16, v4, (-0x1.282ef4b666a5bp-7));
    const double v19 = __builtin_fma(v1, v11, v18);
    const double v21 = __builtin_fma(v1, v19, 0x1.27d27d27d27a2p-4);
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
    const double v5 = __builtin_fma((-0x1.2c0d230256175p-30), v2, (-0x1.f2e1d02f3340cp-27));
    const double v7 = __builtin_fma(v5, v2, (-0x1.53d73ac978ed8p-25));
    const double v9 = __builtin_fma(v7, v2, (-0x1.fee67d54196edp-26));
    const double v11 = __builtin_fma(v9, v2, 0x1.6da73104fa7a4p-26);
    const double v13 = __builtin_fma(v11, v2, 0x1.f92bab6a0abaap-20);
    const double v15 = __builtin_fma(v13, v2, 0x1.35581dd41bf26p-11);
    const double v18 = __builtin_fma(0x1.e98e74a1ee8a8p-34, v2, 0x1.5daa0ca94aea0p-28);
    const double v20 = __builtin_fma(v18, v2, 0x1.e8184e269e990p-26);
    const double v22 = __builtin_fma(v20, v2, 0x1.666ac0bc24d1ap-25);
    const double v24 = __builtin_fma(v22, v2, 0x1.bf05d956aca7bp-26);
    const double v26 = __builtin_fma(v24, v2, 0x1.135a83002a443p-24);
    const double v28 = __builtin_fma(v26, v2, (-0x1.08db14dc94ea7p-15));
    const double v30 = __builtin_fma(v28, v2, (-0x1.ce55c8ea17b0fp-8));
    const double v31 = __builtin_fma(v1, v15, v30);
    const double v33 = __builtin_fma(v1, v31, 0x1.d41d41d41c8dap-5);
    const double v35 = __builtin_fma(v33, v1, (-0x1.111111111110dp-2));
    const double v37 = __builtin_fma(v35, v1, 0x1.5555555555555p-1);
    const double v38 = 0x1.5555555555555p-1 - v37;
    const double v39 = __builtin_fma(v35, v1, v38);
    const double v40 = (-0x1.111111111110dp-2) - v35;
    const double v41 = __builtin_fma(v33, v1, v40);
    const double v43 = v39 + 0x1.5555555555555p-55;
    const double v44 = __builtin_fma(v1, v41, v43);
    const double v45 = -v1;
    const double v47 = __builtin_fma(alpha, alpha, v45);
    const double v48 = __builtin_fma(v47, v35, v44);
    const double v50 = 0x1.921fb54442d18p+0 - alpha;
    const double v51 = v50 * v50;
    const double v54 = __builtin_fma(0x1.f52cc7c7dfefdp-16, v51, (-0x1.047e200356e2ep-11));
    const double v56 = __builtin_fma(v54, v51, 0x1.5582f28f586d2p-8);
    const double v58 = __builtin_fma(v56, v51, (-0x1.0ee063bdf7d00p-5));
    const double v60 = __builtin_fma(v58, v51, 0x1.94ebfbcf8c0fdp-4);
    const double v62 = __builtin_fma(v60, v51, (-0x1.213ce230a79e8p-7));
    const double v65 = __builtin_fma((-0x1.74ce10bfef7f7p-16), v51, 0x1.85f979159b9b1p-12);
    const double v67 = __builtin_fma(v65, v51, (-0x1.2825e27d993d6p-8));
    const double v69 = __builtin_fma(v67, v51, 0x1.27d28a4134219p-5);
    const double v71 = __builtin_fma(v69, v51, (-0x1.5555554df34edp-3));
    const double v73 = __builtin_fma(v71, v51, 0x1.55555555565f3p-2);
    const double v75 = v50 > 0x1.0000000000000p-60 ? v50 : 0x1.0000000000000p-60;
    const double v76 = significand_of(v75);
    const double v78 = v76 - 0x1.0000000000000p+0;
    const double v79 = v78 + 0x1.0000000000000p+1;
    const double v80 = v78 / v79;
    const double v81 = v80 * v80;
    const double v84 = __builtin_fma(0x1.3cda08c7927d8p-3, v81, 0x1.3804595ac79edp-3);
    const double v86 = __builtin_fma(v84, v81, 0x1.747966b22b47ep-3);
    const double v88 = __builtin_fma(v86, v81, 0x1.c71be01ef8d7bp-3);
    const double v90 = __builtin_fma(v88, v81, 0x1.249249f1b0e53p-2);
    const double v92 = __builtin_fma(v90, v81, 0x1.999999987c7a3p-2);
    const double v94 = __builtin_fma(v92, v81, 0x1.55555555559d8p-1);
    const double v95 = -v78;
    const double v96 = __builtin_fma(v81, v94, v95);
    const double v97 = exponent_of(v75);
    const double v99 = __builtin_fma(v97, 0x1.62e42fefa39efp-1, v78);
    const double v100 = __builtin_fma(v80, v96, v99);
    const double v101 = __builtin_fma(v73, v100, v62);
    const double v102 = v50 * v51;
    const double v104 = __builtin_fma(v102, v101, 0x1.fab71f4a3269fp-7);
    const double v106 = alpha + (-0x1.1400000000000p-1);
    const double v107 = v106 + v104;
    const double v108 = v107 - v106;
    const double v109 = v104 - v108;
    const int v111 = alpha < 0x1.2e147ae147ae1p+0;
    const double v112 = v111 ? v37 : v107;
    const double v113 = v111 ? v48 : v109;
    const double v116 = __builtin_fma(0x1.5aeb95ee17e27p-52, v2, 0x1.93966653151c3p-36);
    const double v118 = __builtin_fma(v116, v2, 0x1.27e4fb7471f25p-21);
    const double v121 = __builtin_fma((-0x1.ae33aea2b0d55p-44), v2, (-0x1.1eed8d7449e95p-28));
    const double v123 = __builtin_fma(v121, v2, (-0x1.a01a01a0132c2p-15));
    const double v124 = __builtin_fma(v1, v118, v123);
    const double v126 = __builtin_fma(v1, v124, 0x1.6c16c16c16ba2p-9);
    const double v128 = __builtin_fma(v126, v1, (-0x1.5555555555555p-4));
    const double v129 = __builtin_fma(v128, v1, 0x1.0000000000000p+0);
    const double v130 = 0x1.0000000000000p+0 - v129;
    const double v131 = __builtin_fma(v128, v1, v130);
    const double v132 = (-0x1.5555555555555p-4) - v128;
    const double v133 = __builtin_fma(v126, v1, v132);
    const double v134 = __builtin_fma(v1, v133, v131);
    const double v135 = __builtin_fma(v47, v128, v134);
    const double v136 = v1 * v129;
    const double v137 = -v136;
    const double v138 = __builtin_fma(v1, v129, v137);
    const double v139 = __builtin_fma(v47, v129, v138);
    const double v140 = __builtin_fma(v1, v134, v139);
    const double v141 = alpha * v136;
    const double v142 = -v141;
    const double v143 = __builtin_fma(alpha, v136, v142);
    const double v144 = __builtin_fma(alpha, v140, v143);
    const double v145 = v111 ? v129 : v141;
    const double v146 = v111 ? v135 : v144;
    const double v147 = 0x1.0000000000000p+0 / v145;
    const double v148 = v112 * v147;
    const double v149 = -v148;
    const double v150 = __builtin_fma(v149, v145, v112);
    const double v151 = v150 + v113;
    const double v152 = __builtin_fma(v149, v146, v151);
    const double v153 = __builtin_fma(v152, v147, v148);
    return v153;
}
#define dynamic_coefficient_best_fused_KIND whole

INLINE double weight_moment_per_inertia_best_fused(double alpha)
{
    const double v1 = alpha * alpha;
    const double v2 = v1 * v1;
    const double v5 = __builtin_fma(0x1.2cbf2ac4da2b8p-41, v2, 0x1.b597e33b4fe12p-30);
    const double v7 = __builtin_fma(v5, v2, 0x1.eaeaa1ab8770dp-20);
    const double v9 = __builtin_fma(v7, v2, 0x1.83c8978eb80fep-11);
    const double v12 = __builtin_fma((-0x1.29f8d2f261d93p-35), v2, (-0x1.03e5116ace15dp-24));
    const double v14 = __builtin_fma(v12, v2, (-0x1.65f59e2d0f0a3p-15));
    const double v16 = __builtin_fma(v14, v2, (-0x1.282ef4b666b1ep-7));
    const double v17 = __builtin_fma(v1, v9, v16);
    const double v19 = __builtin_fma(v1, v17, 0x1.27d27d27d27a3p-4);
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
    const double v39 = __builtin_fma(0x1.64c78b2442998p-22, v36, (-0x1.32aba46279bb3p-17));
    const double v41 = __builtin_fma(v39, v36, 0x1.83ca4d0f33cdbp-13);
    const double v43 = __builtin_fma(v41, v36, (-0x1.637e09681a6fbp-9));
    const double v45 = __builtin_fma(v43, v36, 0x1.bc8bc8bb1d67bp-6);
    const double v47 = __builtin_fma(v45, v36, (-0x1.5b05b05b06654p-3));
    const double v49 = __builtin_fma(v47, v36, 0x1.2aaaaaaaaab34p-1);
    const double v51 = __builtin_fma(v49, v36, (-0x1.0000000000006p-2));
    const double v54 = __builtin_fma(v35, (-0x1.1a62633145c07p-53), (-0x1.194bfdddaf855p-6));
    const double v55 = __builtin_fma(v36, v51, v54);
    const double v58 = __builtin_fma(v35, (-0x1.8000000000000p-1), 0x1.0000000000000p-1);
    const double v59 = __builtin_fma(v35, v58, v55);
    const double v60 = 0x1.0000000000000p-1 * alpha;
    const double v62 = v60 + (-0x1.a000000000000p-4);
    const double v63 = v62 + v59;
    const double v64 = v63 - v62;
    const double v65 = v59 - v64;
    const int v67 = alpha < 0x1.0f5c28f5c28f6p+0;
    const double v68 = v67 ? v23 : v63;
    const double v69 = v67 ? v33 : v65;
    const double v72 = __builtin_fma(0x1.eaf6c7c779d13p-34, v2, 0x1.945e2a38f102ep-24);
    const double v74 = __builtin_fma(v72, v2, 0x1.1f0875d692422p-15);
    const double v76 = __builtin_fma(v74, v2, 0x1.1f7d05c6dedbbp-8);
    const double v79 = __builtin_fma((-0x1.60b9ed103c0fap-39), v2, (-0x1.ec7a22ee46a5cp-29));
    const double v81 = __builtin_fma(v79, v2, (-0x1.0e1fa07f81ed1p-19));
    const double v83 = __builtin_fma(v81, v2, (-0x1.d71607a6c20cep-12));
    const double v85 = __builtin_fma(v83, v2, (-0x1.f1029e62c8327p-6));
    const double v86 = __builtin_fma(v1, v76, v85);
    const double v88 = __builtin_fma(v1, v86, 0x1.1e11e11e11ddep-3);
    const double v90 = __builtin_fma(v88, v1, (-0x1.9999999999999p-2));
    const double v91 = __builtin_fma(v90, v1, 0x1.5555555555555p-1);
    const double v92 = 0x1.5555555555555p-1 - v91;
    const double v93 = __builtin_fma(v90, v1, v92);
    const double v94 = (-0x1.9999999999999p-2) - v90;
    const double v95 = __builtin_fma(v88, v1, v94);
    const double v96 = v93 + 0x1.5555555555555p-55;
    const double v97 = __builtin_fma(v1, v95, v96);
    const double v98 = __builtin_fma(v32, v90, v97);
    const double v101 = __builtin_fma(0x1.00ab575ef75a6p-19, v36, (-0x1.1e99caf0a78dfp-15));
    const double v103 = __builtin_fma(v101, v36, 0x1.d69dd6e3a84b4p-12);
    const double v105 = __builtin_fma(v103, v36, (-0x1.1e5e14556f803p-8));
    const double v107 = __builtin_fma(v105, v36, 0x1.e94dfd2a84da7p-6);
    const double v109 = __builtin_fma(v107, v36, (-0x1.0cbb76624ef26p-3));
    const double v111 = __builtin_fma(v109, v36, 0x1.3e93e93e9679ap-2);
    const double v113 = __builtin_fma(v111, v36, (-0x1.c71c71c71c995p-3));
    const double v115 = __builtin_fma(v113, v36, (-0x1.555555555554fp-3));
    const double v117 = __builtin_fma(v35, v115, 0x1.9ffffffffffffp-4);
    const double v118 = v62 + v117;
    const double v119 = v118 - v62;
    const double v120 = v117 - v119;
    const double v121 = v67 ? v91 : v118;
    const double v122 = v67 ? v98 : v120;
    const double v124 = 0x1.0000000000000p+0 / v121;
    const double v125 = v68 * v124;
    const double v126 = -v125;
    const double v127 = __builtin_fma(v126, v121, v68);
    const double v128 = v127 + v69;
    const double v129 = __builtin_fma(v126, v122, v128);
    const double v130 = __builtin_fma(v129, v124, v125);
    return v130;
}
#define weight_moment_per_inertia_best_fused_KIND whole

INLINE double radial_weight_per_inertia_best_fused(double alpha)
{
    const double v1 = alpha * alpha;
    const double v2 = v1 * v1;
    const double v5 = __builtin_fma((-0x1.b88267851e4a5p-31), v2, (-0x1.1f1ed07467e72p-25));
    const double v7 = __builtin_fma(v5, v2, (-0x1.7849a9f05aa4ap-23));
    const double v9 = __builtin_fma(v7, v2, (-0x1.0bef51e7eecdbp-22));
    const double v11 = __builtin_fma(v9, v2, (-0x1.2fa88e52f9e30p-23));
    const double v13 = __builtin_fma(v11, v2, (-0x1.5b9ad7cbb1202p-22));
    const double v15 = __builtin_fma(v13, v2, (-0x1.015bd71ab20f7p-18));
    const double v17 = __builtin_fma(v15, v2, (-0x1.47d67746cef40p-16));
    const double v20 = __builtin_fma(0x1.00fc0cec735acp-27, v2, 0x1.8b78856019984p-24);
    const double v22 = __builtin_fma(v20, v2, 0x1.014d0e8ca8808p-22);
    const double v24 = __builtin_fma(v22, v2, 0x1.88d893699f450p-23);
    const double v26 = __builtin_fma(v24, v2, (-0x1.58a3290228af4p-25));
    const double v28 = __builtin_fma(v26, v2, (-0x1.1c9a1d34b6f3fp-20));
    const double v30 = __builtin_fma(v28, v2, (-0x1.07d7822d7b6f1p-16));
    const double v32 = __builtin_fma(v30, v2, (-0x1.664f4880dd143p-10));
    const double v33 = __builtin_fma(v1, v17, v32);
    const double v35 = __builtin_fma(v1, v33, 0x1.2b12b12b11ea5p-6);
    const double v37 = __builtin_fma(v35, v1, (-0x1.9999999999996p-3));
    const double v39 = __builtin_fma(v37, v1, 0x1.5555555555555p-1);
    const double v40 = 0x1.5555555555555p-1 - v39;
    const double v41 = __builtin_fma(v37, v1, v40);
    const double v42 = (-0x1.9999999999996p-3) - v37;
    const double v43 = __builtin_fma(v35, v1, v42);
    const double v45 = v41 + 0x1.5555555555555p-55;
    const double v46 = __builtin_fma(v1, v43, v45);
    const double v47 = -v1;
    const double v49 = __builtin_fma(alpha, alpha, v47);
    const double v50 = __builtin_fma(v49, v37, v46);
    const double v52 = 0x1.921fb54442d18p+0 - alpha;
    const double v53 = v52 * v52;
    const double v56 = __builtin_fma(0x1.64009ce2f3630p-17, v53, (-0x1.5c6d8636f92ccp-12));
    const double v58 = __builtin_fma(v56, v53, 0x1.c0f9c0515effdp-8);
    const double v60 = __builtin_fma(v58, v53, (-0x1.5fec36ee4b768p-4));
    const double v62 = __builtin_fma(v60, v53, 0x1.2c981ff6211c9p-1);
    const double v64 = __builtin_fma(v62, v53, (-0x1.7217f7d1acae6p-7));
    const double v67 = __builtin_fma((-0x1.27ac624df162ep-18), v53, 0x1.28ae92a1ef664p-13);
    const double v69 = __builtin_fma(v67, v53, (-0x1.a01620d59d215p-9));
    const double v71 = __builtin_fma(v69, v53, 0x1.6c16c49fd75c7p-5);
    const double v73 = __builtin_fma(v71, v53, (-0x1.5555555455f4cp-2));
    const double v75 = __builtin_fma(v73, v53, 0x1.000000000015dp+0);
    const double v76 = 0x1.0000000000000p+1 * v52;
    const double v78 = v76 > 0x1.0000000000000p-60 ? v76 : 0x1.0000000000000p-60;
    const double v79 = significand_of(v78);
    const double v81 = v79 - 0x1.0000000000000p+0;
    const double v82 = v81 + 0x1.0000000000000p+1;
    const double v83 = v81 / v82;
    const double v84 = v83 * v83;
    const double v87 = __builtin_fma(0x1.3cda08c7927d8p-3, v84, 0x1.3804595ac79edp-3);
    const double v89 = __builtin_fma(v87, v84, 0x1.747966b22b47ep-3);
    const double v91 = __builtin_fma(v89, v84, 0x1.c71be01ef8d7bp-3);
    const double v93 = __builtin_fma(v91, v84, 0x1.249249f1b0e53p-2);
    const double v95 = __builtin_fma(v93, v84, 0x1.999999987c7a3p-2);
    const double v97 = __builtin_fma(v95, v84, 0x1.55555555559d8p-1);
    const double v98 = -v81;
    const double v99 = __builtin_fma(v84, v97, v98);
    const double v100 = exponent_of(v78);
    const double v102 = __builtin_fma(v100, 0x1.62e42fefa39efp-1, v81);
    const double v103 = __builtin_fma(v83, v99, v102);
    const double v104 = __builtin_fma(v75, v103, v64);
    const double v106 = __builtin_fma(v53, v104, 0x1.5e04abbbd2e80p-5);
    const double v109 = __builtin_fma(v52, (-0x1.e000000000000p+0), 0x1.0000000000000p-1);
    const double v110 = __builtin_fma(v52, v109, v106);
    const double v111 = 0x1.0000000000000p-1 * alpha;
    const double v113 = v111 + 0x1.6000000000000p-3;
    const double v114 = v113 + v110;
    const double v115 = v114 - v113;
    const double v116 = v110 - v115;
    const int v118 = alpha < 0x1.1eb851eb851ecp+0;
    const double v119 = v118 ? v39 : v114;
    const double v120 = v118 ? v50 : v116;
    const double v123 = __builtin_fma(0x1.eb70be827f311p-34, v2, 0x1.945e8f1de9e15p-24);
    const double v125 = __builtin_fma(v123, v2, 0x1.1f0875ebcbf04p-15);
    const double v127 = __builtin_fma(v125, v2, 0x1.1f7d05c6e1487p-8);
    const double v130 = __builtin_fma((-0x1.63629956670d9p-39), v2, (-0x1.ec837110b11a7p-29));
    const double v132 = __builtin_fma(v130, v2, (-0x1.0e1fa3172eb2cp-19));
    const double v134 = __builtin_fma(v132, v2, (-0x1.d71607a7973dcp-12));
    const double v136 = __builtin_fma(v134, v2, (-0x1.f1029e62c840ep-6));
    const double v137 = __builtin_fma(v1, v127, v136);
    const double v139 = __builtin_fma(v1, v137, 0x1.1e11e11e11ddfp-3);
    const double v141 = __builtin_fma(v139, v1, (-0x1.9999999999999p-2));
    const double v142 = __builtin_fma(v141, v1, 0x1.5555555555555p-1);
    const double v143 = 0x1.5555555555555p-1 - v142;
    const double v144 = __builtin_fma(v141, v1, v143);
    const double v145 = (-0x1.9999999999999p-2) - v141;
    const double v146 = __builtin_fma(v139, v1, v145);
    const double v147 = v144 + 0x1.5555555555555p-55;
    const double v148 = __builtin_fma(v1, v146, v147);
    const double v149 = __builtin_fma(v49, v141, v148);
    const double v152 = __builtin_fma(0x1.16f943a246fa1p-19, v53, (-0x1.1fcee5678494fp-15));
    const double v154 = __builtin_fma(v152, v53, 0x1.d6ab8ca876bdep-12);
    const double v156 = __builtin_fma(v154, v53, (-0x1.1e5e3d4c60700p-8));
    const double v158 = __builtin_fma(v156, v53, 0x1.e94dfe3da88b8p-6);
    const double v160 = __builtin_fma(v158, v53, (-0x1.0cbb76644f474p-3));
    const double v162 = __builtin_fma(v160, v53, 0x1.3e93e93e9e0d6p-2);
    const double v164 = __builtin_fma(v162, v53, (-0x1.c71c71c71cc85p-3));
    const double v166 = __builtin_fma(v164, v53, (-0x1.555555555554dp-3));
    const double v168 = __builtin_fma(v52, v166, 0x1.7ffffffffffffp-4);
    const double v170 = v111 + (-0x1.8000000000000p-4);
    const double v171 = v170 + v168;
    const double v172 = v171 - v170;
    const double v173 = v168 - v172;
    const double v174 = v118 ? v142 : v171;
    const double v175 = v118 ? v149 : v173;
    const double v176 = 0x1.0000000000000p+0 / v174;
    const double v177 = v119 * v176;
    const double v178 = -v177;
    const double v179 = __builtin_fma(v178, v174, v119);
    const double v180 = v179 + v120;
    const double v181 = __builtin_fma(v178, v175, v180);
    const double v182 = __builtin_fma(v181, v176, v177);
    return v182;
}
#define radial_weight_per_inertia_best_fused_KIND whole

INLINE double polar_moment_per_inertia_best_fused(double alpha)
{
    const double v1 = alpha * alpha;
    const double v2 = v1 * v1;
    const double v5 = __builtin_fma((-0x1.77c8d442bafc7p-29), v2, (-0x1.cddced305e389p-28));
    const double v7 = __builtin_fma(v5, v2, 0x1.a303539235a90p-26);
    const double v9 = __builtin_fma(v7, v2, 0x1.f9291426a15fap-20);
    const double v11 = __builtin_fma(v9, v2, 0x1.35581d9dfe224p-11);
    const double v14 = __builtin_fma(0x1.7e95e1dac17adp-31, v2, 0x1.e745acd142291p-28);
    const double v16 = __builtin_fma(v14, v2, 0x1.09bb69f7fcfadp-26);
    const double v18 = __builtin_fma(v16, v2, 0x1.116ceb2ada79ap-24);
    const double v20 = __builtin_fma(v18, v2, (-0x1.08db03cc5e770p-15));
    const double v22 = __builtin_fma(v20, v2, (-0x1.ce55c8e971fd1p-8));
    const double v23 = __builtin_fma(v1, v11, v22);
    const double v25 = __builtin_fma(v1, v23, 0x1.d41d41d41ba25p-5);
    const double v27 = __builtin_fma(v25, v1, (-0x1.1111111111106p-2));
    const double v29 = __builtin_fma(v27, v1, 0x1.5555555555555p-1);
    const double v30 = 0x1.5555555555555p-1 - v29;
    const double v31 = __builtin_fma(v27, v1, v30);
    const double v32 = (-0x1.1111111111106p-2) - v27;
    const double v33 = __builtin_fma(v25, v1, v32);
    const double v35 = v31 + 0x1.5555555555555p-55;
    const double v36 = __builtin_fma(v1, v33, v35);
    const double v37 = -v1;
    const double v39 = __builtin_fma(alpha, alpha, v37);
    const double v40 = __builtin_fma(v39, v27, v36);
    const double v42 = 0x1.921fb54442d18p+0 - alpha;
    const double v43 = v42 * v42;
    const double v46 = __builtin_fma(0x1.af511ed3efee7p-15, v43, (-0x1.8a9e832d9844dp-11));
    const double v48 = __builtin_fma(v46, v43, 0x1.115fe28110038p-7);
    const double v50 = __builtin_fma(v48, v43, (-0x1.dbecf43061ae4p-5));
    const double v52 = __builtin_fma(v50, v43, 0x1.b70e1da718514p-3);
    const double v54 = __builtin_fma(v52, v43, (-0x1.eb440e0d5b068p-3));
    const double v57 = __builtin_fma((-0x1.b634872dcba2dp-16), v43, 0x1.7ff85a336a890p-12);
    const double v59 = __builtin_fma(v57, v43, (-0x1.283af2ca91d53p-8));
    const double v61 = __builtin_fma(v59, v43, 0x1.27d268328778dp-5);
    const double v63 = __builtin_fma(v61, v43, (-0x1.5555556697b7dp-3));
    const double v65 = __builtin_fma(v63, v43, 0x1.55555555518aap-2);
    const double v66 = 0x1.0000000000000p+1 * v42;
    const double v68 = v66 > 0x1.0000000000000p-60 ? v66 : 0x1.0000000000000p-60;
    const double v69 = significand_of(v68);
    const double v71 = v69 - 0x1.0000000000000p+0;
    const double v72 = v71 + 0x1.0000000000000p+1;
    const double v73 = v71 / v72;
    const double v74 = v73 * v73;
    const double v77 = __builtin_fma(0x1.3cda08c7927d8p-3, v74, 0x1.3804595ac79edp-3);
    const double v79 = __builtin_fma(v77, v74, 0x1.747966b22b47ep-3);
    const double v81 = __builtin_fma(v79, v74, 0x1.c71be01ef8d7bp-3);
    const double v83 = __builtin_fma(v81, v74, 0x1.249249f1b0e53p-2);
    const double v85 = __builtin_fma(v83, v74, 0x1.999999987c7a3p-2);
    const double v87 = __builtin_fma(v85, v74, 0x1.55555555559d8p-1);
    const double v88 = -v71;
    const double v89 = __builtin_fma(v74, v87, v88);
    const double v90 = exponent_of(v68);
    const double v92 = __builtin_fma(v90, 0x1.62e42fefa39efp-1, v71);
    const double v93 = __builtin_fma(v73, v89, v92);
    const double v94 = __builtin_fma(v65, v93, v54);
    const double v95 = v42 * v43;
    const double v97 = __builtin_fma(v95, v94, 0x1.7d5b8fa51934fp-6);
    const double v99 = alpha + (-0x1.1800000000000p-1);
    const double v100 = v99 + v97;
    const double v101 = v100 - v99;
    const double v102 = v97 - v101;
    const int v103 = alpha < 0x1.0000000000000p+0;
    const double v104 = v103 ? v29 : v100;
    const double v105 = v103 ? v40 : v102;
    const double v108 = __builtin_fma(0x1.ae33f297a30d7p-34, v2, 0x1.942d994b09126p-24);
    const double v110 = __builtin_fma(v108, v2, 0x1.1f086b05efb64p-15);
    const double v112 = __builtin_fma(v110, v2, 0x1.1f7d05c54d72cp-8);
    const double v115 = __builtin_fma((-0x1.e7f58bcd729d6p-29), v2, (-0x1.0e1e5caf9c68cp-19));
    const double v117 = __builtin_fma(v115, v2, (-0x1.d716073060e57p-12));
    const double v119 = __builtin_fma(v117, v2, (-0x1.f1029e62bbf32p-6));
    const double v120 = __builtin_fma(v1, v112, v119);
    const double v122 = __builtin_fma(v1, v120, 0x1.1e11e11e11c62p-3);
    const double v124 = __builtin_fma(v122, v1, (-0x1.9999999999995p-2));
    const double v125 = __builtin_fma(v124, v1, 0x1.5555555555555p-1);
    const double v126 = 0x1.5555555555555p-1 - v125;
    const double v127 = __builtin_fma(v124, v1, v126);
    const double v128 = (-0x1.9999999999995p-2) - v124;
    const double v129 = __builtin_fma(v122, v1, v128);
    const double v130 = v127 + 0x1.5555555555555p-55;
    const double v131 = __builtin_fma(v1, v129, v130);
    const double v132 = __builtin_fma(v39, v124, v131);
    const double v135 = __builtin_fma((-0x1.00589fe65ed98p-23), v43, 0x1.1425220d45aaap-19);
    const double v137 = __builtin_fma(v135, v43, (-0x1.1f397f95f7403p-15));
    const double v139 = __builtin_fma(v137, v43, 0x1.d6a371cc475cdp-12);
    const double v141 = __builtin_fma(v139, v43, (-0x1.1e5e23528aa32p-8));
    const double v143 = __builtin_fma(v141, v43, 0x1.e94dfd8b6e6d2p-6);
    const double v145 = __builtin_fma(v143, v43, (-0x1.0cbb76630619cp-3));
    const double v147 = __builtin_fma(v145, v43, 0x1.3e93e93e9959dp-2);
    const double v149 = __builtin_fma(v147, v43, (-0x1.c71c71c71cad2p-3));
    const double v151 = __builtin_fma(v149, v43, (-0x1.555555555554ep-3));
    const double v153 = __builtin_fma(v42, v151, 0x1.dffffffffffffp-4);
    const double v155 = 0x1.0000000000000p-1 * alpha;
    const double v157 = v155 + (-0x1.e000000000000p-4);
    const double v158 = v157 + v153;
    const double v159 = v158 - v157;
    const double v160 = v153 - v159;
    const double v161 = v103 ? v125 : v158;
    const double v162 = v103 ? v132 : v160;
    const double v163 = 0x1.0000000000000p+0 / v161;
    const double v164 = v104 * v163;
    const double v165 = -v164;
    const double v166 = __builtin_fma(v165, v161, v104);
    const double v167 = v166 + v105;
    const double v168 = __builtin_fma(v165, v162, v167);
    const double v169 = __builtin_fma(v168, v163, v164);
    return v169;
}
#define polar_moment_per_inertia_best_fused_KIND whole

INLINE double weight_moment_per_radial_weight_best_fused(double alpha)
{
    const double v1 = alpha * alpha;
    const double v2 = v1 * v1;
    const double v5 = __builtin_fma(0x1.30db2c751a237p-41, v2, 0x1.b59d8e5371c8cp-30);
    const double v7 = __builtin_fma(v5, v2, 0x1.eaeaa2c9de7afp-20);
    const double v9 = __builtin_fma(v7, v2, 0x1.83c8978ec51cep-11);
    const double v12 = __builtin_fma((-0x1.2a4d5179ccb3bp-35), v2, (-0x1.03e52bbf4db10p-24));
    const double v14 = __builtin_fma(v12, v2, (-0x1.65f59e30a6c95p-15));
    const double v16 = __builtin_fma(v14, v2, (-0x1.282ef4b666c9bp-7));
    const double v17 = __builtin_fma(v1, v9, v16);
    const double v19 = __builtin_fma(v1, v17, 0x1.27d27d27d27a5p-4);
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
    const double v40 = __builtin_fma(0x1.44ebe008475edp-22, v37, (-0x1.31e2be57bfe01p-17));
    const double v42 = __builtin_fma(v40, v37, 0x1.83c64150f3de6p-13);
    const double v44 = __builtin_fma(v42, v37, (-0x1.637dfe720b520p-9));
    const double v46 = __builtin_fma(v44, v37, 0x1.bc8bc899c38eep-6);
    const double v48 = __builtin_fma(v46, v37, (-0x1.5b05b05ace2a9p-3));
    const double v50 = __builtin_fma(v48, v37, 0x1.2aaaaaaaaa534p-1);
    const double v52 = __builtin_fma(v50, v37, (-0x1.fffffffffff95p-4));
    const double v55 = __builtin_fma(v36, (-0x1.1a62633145c07p-53), (-0x1.8ca5feeed7c2bp-5));
    const double v56 = __builtin_fma(v37, v52, v55);
    const double v59 = __builtin_fma(v36, (-0x1.c000000000000p-1), 0x1.0000000000000p-1);
    const double v60 = __builtin_fma(v36, v59, v56);
    const double v61 = 0x1.0000000000000p-1 * alpha;
    const double v63 = v61 + (-0x1.2000000000000p-4);
    const double v64 = v63 + v60;
    const double v65 = v64 - v63;
    const double v66 = v60 - v65;
    const int v68 = alpha < 0x1.2147ae147ae14p+0;
    const double v69 = v68 ? v23 : v64;
    const double v70 = v68 ? v34 : v66;
    const double v73 = __builtin_fma(0x1.16a51a0466b36p-26, v2, 0x1.7e0d0f92d659ap-23);
    const double v75 = __builtin_fma(v73, v2, 0x1.ae7d3d37478b8p-22);
    const double v77 = __builtin_fma(v75, v2, 0x1.0242817718f09p-22);
    const double v79 = __builtin_fma(v77, v2, (-0x1.0c93c27d943d3p-22));
    const double v81 = __builtin_fma(v79, v2, (-0x1.01130834deb14p-18));
    const double v83 = __builtin_fma(v81, v2, (-0x1.47d639590fb52p-16));
    const double v86 = __builtin_fma((-0x1.f8851683cc319p-30), v2, (-0x1.26e21fc7faf1ep-24));
    const double v88 = __builtin_fma(v86, v2, (-0x1.54ac07dc5767ap-22));
    const double v90 = __builtin_fma(v88, v2, (-0x1.a2047d109e679p-22));
    const double v92 = __builtin_fma(v90, v2, (-0x1.f5391f483e97bp-23));
    const double v94 = __builtin_fma(v92, v2, (-0x1.222d653c72507p-20));
    const double v96 = __builtin_fma(v94, v2, (-0x1.07da187423fafp-16));
    const double v98 = __builtin_fma(v96, v2, (-0x1.664f488ec5cd7p-10));
    const double v99 = __builtin_fma(v1, v83, v98);
    const double v101 = __builtin_fma(v1, v99, 0x1.2b12b12b184a9p-6);
    const double v103 = __builtin_fma(v101, v1, (-0x1.99999999999b7p-3));
    const double v104 = __builtin_fma(v103, v1, 0x1.5555555555555p-1);
    const double v105 = 0x1.5555555555555p-1 - v104;
    const double v106 = __builtin_fma(v103, v1, v105);
    const double v107 = (-0x1.99999999999b7p-3) - v103;
    const double v108 = __builtin_fma(v101, v1, v107);
    const double v109 = v106 + 0x1.5555555555555p-55;
    const double v110 = __builtin_fma(v1, v108, v109);
    const double v111 = __builtin_fma(v33, v103, v110);
    const double v114 = __builtin_fma(0x1.5cb02195a47e5p-17, v37, (-0x1.5c79b09b316eap-12));
    const double v116 = __builtin_fma(v114, v37, 0x1.c0fa11c3186cdp-8);
    const double v118 = __builtin_fma(v116, v37, (-0x1.5fec368b1249bp-4));
    const double v120 = __builtin_fma(v118, v37, 0x1.2c981ff63ec19p-1);
    const double v122 = __builtin_fma(v120, v37, (-0x1.7217f7d1ab2e7p-7));
    const double v125 = __builtin_fma((-0x1.1e2016c290c5cp-18), v37, 0x1.2910a202b16c5p-13);
    const double v127 = __builtin_fma(v125, v37, (-0x1.a015173aabdaap-9));
    const double v129 = __builtin_fma(v127, v37, 0x1.6c16c52a07b2ap-5);
    const double v131 = __builtin_fma(v129, v37, (-0x1.555555543d7fdp-2));
    const double v133 = __builtin_fma(v131, v37, 0x1.0000000000169p+0);
    const double v134 = 0x1.0000000000000p+1 * v36;
    const double v136 = v134 > 0x1.0000000000000p-60 ? v134 : 0x1.0000000000000p-60;
    const double v137 = significand_of(v136);
    const double v139 = v137 - 0x1.0000000000000p+0;
    const double v140 = v139 + 0x1.0000000000000p+1;
    const double v141 = v139 / v140;
    const double v142 = v141 * v141;
    const double v145 = __builtin_fma(0x1.3cda08c7927d8p-3, v142, 0x1.3804595ac79edp-3);
    const double v147 = __builtin_fma(v145, v142, 0x1.747966b22b47ep-3);
    const double v149 = __builtin_fma(v147, v142, 0x1.c71be01ef8d7bp-3);
    const double v151 = __builtin_fma(v149, v142, 0x1.249249f1b0e53p-2);
    const double v153 = __builtin_fma(v151, v142, 0x1.999999987c7a3p-2);
    const double v155 = __builtin_fma(v153, v142, 0x1.55555555559d8p-1);
    const double v156 = -v139;
    const double v157 = __builtin_fma(v142, v155, v156);
    const double v158 = exponent_of(v136);
    const double v160 = __builtin_fma(v158, 0x1.62e42fefa39efp-1, v139);
    const double v161 = __builtin_fma(v141, v157, v160);
    const double v162 = __builtin_fma(v133, v161, v122);
    const double v164 = __builtin_fma(v37, v162, 0x1.5e04abbbd2e80p-5);
    const double v166 = __builtin_fma(v36, (-0x1.e000000000000p+0), 0x1.0000000000000p-1);
    const double v167 = __builtin_fma(v36, v166, v164);
    const double v169 = v61 + 0x1.6000000000000p-3;
    const double v170 = v169 + v167;
    const double v171 = v170 - v169;
    const double v172 = v167 - v171;
    const double v173 = v68 ? v104 : v170;
    const double v174 = v68 ? v111 : v172;
    const double v175 = 0x1.0000000000000p+0 / v173;
    const double v176 = v69 * v175;
    const double v177 = -v176;
    const double v178 = __builtin_fma(v177, v173, v69);
    const double v179 = v178 + v70;
    const double v180 = __builtin_fma(v177, v174, v179);
    const double v181 = __builtin_fma(v180, v175, v176);
    return v181;
}
#define weight_moment_per_radial_weight_best_fused_KIND whole
#endif

INLINE double polar_moment_best_plain(double alpha)
{
    const double v1 = alpha * alpha;
    const double v4 = 0x1.1727db8e8d26bp-32 * v1;
    const double v5 = v4 + (-0x1.a5f2cc52df731p-30);
    const double v7 = v5 * v1;
    const double v8 = v7 + 0x1.4ddb2f6e5a435p-28;
    const double v10 = v8 * v1;
    const double v11 = v10 + (-0x1.2c351cb8eed5bp-27);
    const double v13 = v11 * v1;
    const double v14 = v13 + 0x1.a8f8eb47e02adp-27;
    const double v16 = v14 * v1;
    const double v17 = v16 + (-0x1.ebe50399bea97p-28);
    const double v19 = v17 * v1;
    const double v20 = v19 + 0x1.34779b4319ad8p-26;
    const double v22 = v20 * v1;
    const double v23 = v22 + 0x1.5ec4e6cb89e6ep-25;
    const double v25 = v23 * v1;
    const double v26 = v25 + 0x1.910a4d94f0fb2p-24;
    const double v28 = v26 * v1;
    const double v29 = v28 + 0x1.7af6847d6a8b5p-19;
    const double v31 = v29 * v1;
    const double v32 = v31 + (-0x1.8d48d67723bf4p-15);
    const double v34 = v32 * v1;
    const double v35 = v34 + 0x1.d0042d1a7a479p-11;
    const double v37 = v35 * v1;
    const double v38 = v37 + (-0x1.5ac056afeeeedp-7);
    const double v40 = v38 * v1;
    const double v41 = v40 + 0x1.5f15f15f15caep-4;
    const double v43 = v41 * v1;
    const double v44 = v43 + (-0x1.9999999999998p-2);
    const double v45 = v44 * v1;
    const double v46 = v1 * v45;
    const double v47 = v46 + v1;
    const double v49 = v47 / 0x1.8000000000000p+0;
    const double v50 = v49 * alpha;
    const double v52 = 0x1.921fb54442d18p+0 - alpha;
    const double v53 = v52 * v52;
    const double v56 = 0x1.142a50dc4a9dep-15 * v53;
    const double v57 = v56 + (-0x1.058191e40d3cfp-11);
    const double v59 = v57 * v53;
    const double v60 = v59 + 0x1.556fa69a4a6aep-8;
    const double v62 = v60 * v53;
    const double v63 = v62 + (-0x1.0ee08d6ddcdd4p-5);
    const double v65 = v63 * v53;
    const double v66 = v65 + 0x1.94ebfb8ed1634p-4;
    const double v68 = v66 * v53;
    const double v69 = v68 + (-0x1.213ce2316924dp-7);
    const double v72 = (-0x1.b08fc34d11d4dp-16) * v53;
    const double v73 = v72 + 0x1.80dd0f969ca49p-12;
    const double v75 = v73 * v53;
    const double v76 = v75 + (-0x1.2835c7b8e7a0fp-8);
    const double v78 = v76 * v53;
    const double v79 = v78 + 0x1.27d27519db656p-5;
    const double v81 = v79 * v53;
    const double v82 = v81 + (-0x1.55555559507f8p-3);
    const double v84 = v82 * v53;
    const double v85 = v84 + 0x1.5555555554f26p-2;
    const double v87 = v52 > 0x1.0000000000000p-60 ? v52 : 0x1.0000000000000p-60;
    const double v88 = significand_of(v87);
    const double v90 = v88 - 0x1.0000000000000p+0;
    const double v92 = v90 + 0x1.0000000000000p+1;
    const double v93 = v90 / v92;
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
    const double v115 = v114 - v90;
    const double v116 = exponent_of(v87);
    const double v118 = v116 * 0x1.62e42fefa39efp-1;
    const double v119 = v118 + v90;
    const double v120 = v93 * v115;
    const double v121 = v120 + v119;
    const double v122 = v85 * v121;
    const double v123 = v122 + v69;
    const double v124 = v52 * v53;
    const double v126 = v124 * v123;
    const double v127 = v126 + 0x1.fab71f4a3269fp-7;
    const double v129 = alpha + (-0x1.1400000000000p-1);
    const double v130 = v129 + v127;
    const int v132 = alpha < 0x1.0f5c28f5c28f6p+0;
    const double v133 = v132 ? v50 : v130;
    return v133;
}
#define polar_moment_best_plain_KIND pieces
#define polar_moment_best_plain_BELOW_double UINT64_C(0x3ff0f5c28f5c28f5)
#define polar_moment_best_plain_BELOW_float UINT32_C(0x3f87ae14)
INLINE double polar_moment_best_plain_below(double alpha)
{
    const double v1 = alpha * alpha;
    const double v4 = 0x1.1727db8e8d26bp-32 * v1;
    const double v5 = v4 + (-0x1.a5f2cc52df731p-30);
    const double v7 = v5 * v1;
    const double v8 = v7 + 0x1.4ddb2f6e5a435p-28;
    const double v10 = v8 * v1;
    const double v11 = v10 + (-0x1.2c351cb8eed5bp-27);
    const double v13 = v11 * v1;
    const double v14 = v13 + 0x1.a8f8eb47e02adp-27;
    const double v16 = v14 * v1;
    const double v17 = v16 + (-0x1.ebe50399bea97p-28);
    const double v19 = v17 * v1;
    const double v20 = v19 + 0x1.34779b4319ad8p-26;
    const double v22 = v20 * v1;
    const double v23 = v22 + 0x1.5ec4e6cb89e6ep-25;
    const double v25 = v23 * v1;
    const double v26 = v25 + 0x1.910a4d94f0fb2p-24;
    const double v28 = v26 * v1;
    const double v29 = v28 + 0x1.7af6847d6a8b5p-19;
    const double v31 = v29 * v1;
    const double v32 = v31 + (-0x1.8d48d67723bf4p-15);
    const double v34 = v32 * v1;
    const double v35 = v34 + 0x1.d0042d1a7a479p-11;
    const double v37 = v35 * v1;
    const double v38 = v37 + (-0x1.5ac056afeeeedp-7);
    const double v40 = v38 * v1;
    const double v41 = v40 + 0x1.5f15f15f15caep-4;
    const double v43 = v41 * v1;
    const double v44 = v43 + (-0x1.9999999999998p-2);
    const double v45 = v44 * v1;
    const double v46 = v1 * v45;
    const double v47 = v46 + v1;
    const double v49 = v47 / 0x1.8000000000000p+0;
    const double v50 = v49 * alpha;
    return v50;
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
    const double v4 = 0x1.3e673ee0e6ccep-33 * v1;
    const double v5 = v4 + (-0x1.6d4e163551c6fp-28);
    const double v7 = v5 * v1;
    const double v8 = v7 + 0x1.2f16eb244b5dfp-23;
    const double v10 = v8 * v1;
    const double v11 = v10 + (-0x1.952cb7756450ap-19);
    const double v13 = v11 * v1;
    const double v14 = v13 + 0x1.ae8c97331a182p-15;
    const double v16 = v14 * v1;
    const double v17 = v16 + (-0x1.6150852358f81p-11);
    const double v19 = v17 * v1;
    const double v20 = v19 + 0x1.af3b88a5d2a17p-8;
    const double v22 = v20 * v1;
    const double v23 = v22 + (-0x1.74c1f6ca02d52p-5);
    const double v25 = v23 * v1;
    const double v26 = v25 + 0x1.ad1ad1ad1a79fp-3;
    const double v28 = v26 * v1;
    const double v29 = v28 + (-0x1.333333333332bp-1);
    const double v30 = v29 * v1;
    const double v31 = v1 * v30;
    const double v32 = v31 + v1;
    const double v34 = v32 / 0x1.8000000000000p+0;
    const double v35 = v34 * alpha;
    const double v37 = 0x1.921fb54442d18p+0 - alpha;
    const double v38 = v37 * v37;
    const double v41 = 0x1.f4ffb320b7c92p-20 * v38;
    const double v42 = v41 + (-0x1.1e264f7e219b6p-15);
    const double v44 = v42 * v38;
    const double v45 = v44 + 0x1.d696da6d44e9dp-12;
    const double v47 = v45 * v38;
    const double v48 = v47 + (-0x1.1e5df77310522p-8);
    const double v50 = v48 * v38;
    const double v51 = v50 + 0x1.e94dfc180d8d8p-6;
    const double v53 = v51 * v38;
    const double v54 = v53 + (-0x1.0cbb765f6105bp-3);
    const double v56 = v54 * v38;
    const double v57 = v56 + 0x1.3e93e93e8513fp-2;
    const double v59 = v57 * v38;
    const double v60 = v59 + (-0x1.c71c71c71bd51p-3);
    const double v62 = v60 * v38;
    const double v63 = v62 + (-0x1.5555555555569p-3);
    const double v65 = v37 * v63;
    const double v66 = v65 + 0x1.1000000000000p-3;
    const double v68 = 0x1.0000000000000p-1 * alpha;
    const double v70 = v68 + (-0x1.1000000000000p-3);
    const double v71 = v70 + v66;
    const int v73 = alpha < 0x1.0a3d70a3d70a4p+0;
    const double v74 = v73 ? v35 : v71;
    return v74;
}
#define moment_of_inertia_best_plain_KIND pieces
#define moment_of_inertia_best_plain_BELOW_double UINT64_C(0x3ff0a3d70a3d70a3)
#define moment_of_inertia_best_plain_BELOW_float UINT32_C(0x3f851eb8)
INLINE double moment_of_inertia_best_plain_below(double alpha)
{
    const double v1 = alpha * alpha;
    const double v4 = 0x1.3e673ee0e6ccep-33 * v1;
    const double v5 = v4 + (-0x1.6d4e163551c6fp-28);
    const double v7 = v5 * v1;
    const double v8 = v7 + 0x1.2f16eb244b5dfp-23;
    const double v10 = v8 * v1;
    const double v11 = v10 + (-0x1.952cb7756450ap-19);
    const double v13 = v11 * v1;
    const double v14 = v13 + 0x1.ae8c97331a182p-15;
    const double v16 = v14 * v1;
    const double v17 = v16 + (-0x1.6150852358f81p-11);
    const double v19 = v17 * v1;
    const double v20 = v19 + 0x1.af3b88a5d2a17p-8;
    const double v22 = v20 * v1;
    const double v23 = v22 + (-0x1.74c1f6ca02d52p-5);
    const double v25 = v23 * v1;
    const double v26 = v25 + 0x1.ad1ad1ad1a79fp-3;
    const double v28 = v26 * v1;
    const double v29 = v28 + (-0x1.333333333332bp-1);
    const double v30 = v29 * v1;
    const double v31 = v1 * v30;
    const double v32 = v31 + v1;
    const double v34 = v32 / 0x1.8000000000000p+0;
    const double v35 = v34 * alpha;
    return v35;
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
    const double v4 = (-0x1.9596db7996201p-30) * v1;
    const double v5 = v4 + 0x1.ebdda588d4c52p-27;
    const double v7 = v5 * v1;
    const double v8 = v7 + (-0x1.1c5633bfcfc28p-24);
    const double v10 = v8 * v1;
    const double v11 = v10 + 0x1.9555d125daed6p-23;
    const double v13 = v11 * v1;
    const double v14 = v13 + (-0x1.8e7f3cc5112f2p-22);
    const double v16 = v14 * v1;
    const double v17 = v16 + 0x1.1a424504de35dp-21;
    const double v19 = v17 * v1;
    const double v20 = v19 + (-0x1.2e85da2724856p-21);
    const double v22 = v20 * v1;
    const double v23 = v22 + 0x1.d4c5f0b709ceap-22;
    const double v25 = v23 * v1;
    const double v26 = v25 + (-0x1.550ad9861c80cp-22);
    const double v28 = v26 * v1;
    const double v29 = v28 + (-0x1.1659a8c8bfe09p-27);
    const double v31 = v29 * v1;
    const double v32 = v31 + (-0x1.0f17bdb8198afp-21);
    const double v34 = v32 * v1;
    const double v35 = v34 + (-0x1.a978e7b7a1cfbp-20);
    const double v37 = v35 * v1;
    const double v38 = v37 + (-0x1.821bfead0e378p-18);
    const double v40 = v38 * v1;
    const double v41 = v40 + (-0x1.8bc2a180b4b2dp-16);
    const double v43 = v41 * v1;
    const double v44 = v43 + (-0x1.ebc1c1a4ab6e5p-16);
    const double v46 = v44 * v1;
    const double v47 = v46 + (-0x1.0cbb765f0ad28p-9);
    const double v49 = v47 * v1;
    const double v50 = v49 + 0x1.c09c09c09973ep-6;
    const double v52 = v50 * v1;
    const double v53 = v52 + (-0x1.333333333332dp-2);
    const double v54 = v53 * v1;
    const double v55 = v1 * v54;
    const double v56 = v55 + v1;
    const double v58 = v56 / 0x1.8000000000000p+0;
    const double v59 = v58 * alpha;
    const double v61 = 0x1.921fb54442d18p+0 - alpha;
    const double v62 = v61 * v61;
    const double v65 = 0x1.536149c083855p-17 * v62;
    const double v66 = v65 + (-0x1.5c87336390abap-12);
    const double v68 = v66 * v62;
    const double v69 = v68 + 0x1.c0fa7521974f7p-8;
    const double v71 = v69 * v62;
    const double v72 = v71 + (-0x1.5fec361a7a6e3p-4);
    const double v74 = v72 * v62;
    const double v75 = v74 + 0x1.2c981ff65e78ap-1;
    const double v77 = v75 * v62;
    const double v78 = v77 + 0x1.d1bd0105cacaap-4;
    const double v81 = (-0x1.11c7f03358b1fp-18) * v62;
    const double v82 = v81 + 0x1.29896a4b09812p-13;
    const double v84 = v82 * v62;
    const double v85 = v84 + (-0x1.a013dfccb8a12p-9);
    const double v87 = v85 * v62;
    const double v88 = v87 + 0x1.6c16c5c417f46p-5;
    const double v90 = v88 * v62;
    const double v91 = v90 + (-0x1.55555554239ddp-2);
    const double v93 = v91 * v62;
    const double v94 = v93 + 0x1.0000000000175p+0;
    const double v96 = 0x1.0000000000000p+1 * v61;
    const double v98 = v96 > 0x1.0000000000000p-60 ? v96 : 0x1.0000000000000p-60;
    const double v99 = significand_of(v98);
    const double v101 = v99 - 0x1.0000000000000p+0;
    const double v102 = v101 + 0x1.0000000000000p+1;
    const double v103 = v101 / v102;
    const double v104 = v103 * v103;
    const double v107 = 0x1.3cda08c7927d8p-3 * v104;
    const double v108 = v107 + 0x1.3804595ac79edp-3;
    const double v110 = v108 * v104;
    const double v111 = v110 + 0x1.747966b22b47ep-3;
    const double v113 = v111 * v104;
    const double v114 = v113 + 0x1.c71be01ef8d7bp-3;
    const double v116 = v114 * v104;
    const double v117 = v116 + 0x1.249249f1b0e53p-2;
    const double v119 = v117 * v104;
    const double v120 = v119 + 0x1.999999987c7a3p-2;
    const double v122 = v120 * v104;
    const double v123 = v122 + 0x1.55555555559d8p-1;
    const double v124 = v104 * v123;
    const double v125 = v124 - v101;
    const double v126 = exponent_of(v98);
    const double v128 = v126 * 0x1.62e42fefa39efp-1;
    const double v129 = v128 + v101;
    const double v130 = v103 * v125;
    const double v131 = v130 + v129;
    const double v132 = v94 * v131;
    const double v133 = v132 + v78;
    const double v135 = v62 * v133;
    const double v136 = v135 + 0x1.3c095777a5d00p-6;
    const double v139 = v61 * (-0x1.0000000000000p+1);
    const double v140 = v139 + 0x1.0000000000000p-1;
    const double v141 = v61 * v140;
    const double v142 = v141 + v136;
    const double v143 = 0x1.0000000000000p-1 * alpha;
    const double v145 = v143 + 0x1.9000000000000p-3;
    const double v146 = v145 + v142;
    const int v148 = alpha < 0x1.23d70a3d70a3dp+0;
    const double v149 = v148 ? v59 : v146;
    return v149;
}
#define radial_weight_amplitude_best_plain_KIND pieces
#define radial_weight_amplitude_best_plain_BELOW_double UINT64_C(0x3ff23d70a3d70a3c)
#define radial_weight_amplitude_best_plain_BELOW_float UINT32_C(0x3f91eb85)
INLINE double radial_weight_amplitude_best_plain_below(double alpha)
{
    const double v1 = alpha * alpha;
    const double v4 = (-0x1.9596db7996201p-30) * v1;
    const double v5 = v4 + 0x1.ebdda588d4c52p-27;
    const double v7 = v5 * v1;
    const double v8 = v7 + (-0x1.1c5633bfcfc28p-24);
    const double v10 = v8 * v1;
    const double v11 = v10 + 0x1.9555d125daed6p-23;
    const double v13 = v11 * v1;
    const double v14 = v13 + (-0x1.8e7f3cc5112f2p-22);
    const double v16 = v14 * v1;
    const double v17 = v16 + 0x1.1a424504de35dp-21;
    const double v19 = v17 * v1;
    const double v20 = v19 + (-0x1.2e85da2724856p-21);
    const double v22 = v20 * v1;
    const double v23 = v22 + 0x1.d4c5f0b709ceap-22;
    const double v25 = v23 * v1;
    const double v26 = v25 + (-0x1.550ad9861c80cp-22);
    const double v28 = v26 * v1;
    const double v29 = v28 + (-0x1.1659a8c8bfe09p-27);
    const double v31 = v29 * v1;
    const double v32 = v31 + (-0x1.0f17bdb8198afp-21);
    const double v34 = v32 * v1;
    const double v35 = v34 + (-0x1.a978e7b7a1cfbp-20);
    const double v37 = v35 * v1;
    const double v38 = v37 + (-0x1.821bfead0e378p-18);
    const double v40 = v38 * v1;
    const double v41 = v40 + (-0x1.8bc2a180b4b2dp-16);
    const double v43 = v41 * v1;
    const double v44 = v43 + (-0x1.ebc1c1a4ab6e5p-16);
    const double v46 = v44 * v1;
    const double v47 = v46 + (-0x1.0cbb765f0ad28p-9);
    const double v49 = v47 * v1;
    const double v50 = v49 + 0x1.c09c09c09973ep-6;
    const double v52 = v50 * v1;
    const double v53 = v52 + (-0x1.333333333332dp-2);
    const double v54 = v53 * v1;
    const double v55 = v1 * v54;
    const double v56 = v55 + v1;
    const double v58 = v56 / 0x1.8000000000000p+0;
    const double v59 = v58 * alpha;
    return v59;
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
    const double v6 = 0x1.3cfcc3c3dc6ebp-2 * v3;
    const double v7 = v6 + 0x1.5c3fe8cc9aaa0p+2;
    const double v9 = v7 * v3;
    const double v10 = v9 + 0x1.816280b47e4c5p+4;
    const double v12 = v10 * v3;
    const double v13 = v12 + 0x1.bb4bf0c970e93p+4;
    const double v15 = v13 * v3;
    const double v16 = v15 + 0x1.c85b59ccf7e43p+2;
    const double v18 = v16 * v3;
    const double v19 = v18 + 0x1.0834666ddd492p-2;
    const double v20 = v19 * v1;
    const double v23 = (-0x1.3b15ecf57e019p+1) * v3;
    const double v24 = v23 + 0x1.522412f400f39p+5;
    const double v26 = v24 * v3;
    const double v27 = v26 + 0x1.6d637ba392228p+6;
    const double v29 = v27 * v3;
    const double v30 = v29 + 0x1.b0786efcf9f8bp+4;
    const double v32 = v30 * v3;
    const double v33 = v32 + 0x1.0000000000000p+0;
    const double v34 = v20 / v33;
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
    const double v4 = 0x1.d57b926b63ae8p-41 * v1;
    const double v5 = v4 + (-0x1.c090a61bf422dp-35);
    const double v7 = v5 * v1;
    const double v8 = v7 + 0x1.484138797ad96p-29;
    const double v10 = v8 * v1;
    const double v11 = v10 + (-0x1.85d83b7e78aadp-24);
    const double v13 = v11 * v1;
    const double v14 = v13 + 0x1.702ffd4421227p-19;
    const double v16 = v14 * v1;
    const double v17 = v16 + (-0x1.0c7836b1956aap-14);
    const double v19 = v17 * v1;
    const double v20 = v19 + 0x1.22d671ab555f0p-10;
    const double v22 = v20 * v1;
    const double v23 = v22 + (-0x1.bc466f119ba39p-7);
    const double v25 = v23 * v1;
    const double v26 = v25 + 0x1.bbbbbbbbbbbb9p-4;
    const double v28 = v26 * v1;
    const double v29 = v28 + (-0x1.0000000000000p-1);
    const double v30 = v29 * v1;
    const double v31 = v1 * v30;
    const double v32 = v31 + v1;
    const double v34 = v32 / 0x1.8000000000000p+0;
    const double v35 = v34 * alpha;
    const double v37 = 0x1.921fb54442d18p+0 - alpha;
    const double v38 = v37 * v37;
    const double v41 = 0x1.629d6790f59cdp-22 * v38;
    const double v42 = v41 + (-0x1.329964da2a8a0p-17);
    const double v44 = v42 * v38;
    const double v45 = v44 + 0x1.83c9cfd63f094p-13;
    const double v47 = v45 * v38;
    const double v48 = v47 + (-0x1.637e07a789800p-9);
    const double v50 = v48 * v38;
    const double v51 = v50 + 0x1.bc8bc8b4233bfp-6;
    const double v53 = v51 * v38;
    const double v54 = v53 + (-0x1.5b05b05af73fdp-3);
    const double v56 = v54 * v38;
    const double v57 = v56 + 0x1.2aaaaaaaaa92ep-1;
    const double v59 = v57 * v38;
    const double v60 = v59 + (-0x1.ffffffffffff2p-3);
    const double v63 = v37 * (-0x1.1a62633145c07p-53);
    const double v64 = v63 + (-0x1.94bfdddaf8555p-10);
    const double v65 = v38 * v60;
    const double v66 = v65 + v64;
    const double v69 = v37 * (-0x1.8000000000000p-1);
    const double v70 = v69 + 0x1.0000000000000p-1;
    const double v71 = v37 * v70;
    const double v72 = v71 + v66;
    const double v73 = 0x1.0000000000000p-1 * alpha;
    const double v75 = v73 + (-0x1.e000000000000p-4);
    const double v76 = v75 + v72;
    const int v78 = alpha < 0x1.0a3d70a3d70a4p+0;
    const double v79 = v78 ? v35 : v76;
    return v79;
}
#define weight_moment_amplitude_best_plain_KIND pieces
#define weight_moment_amplitude_best_plain_BELOW_double UINT64_C(0x3ff0a3d70a3d70a3)
#define weight_moment_amplitude_best_plain_BELOW_float UINT32_C(0x3f851eb8)
INLINE double weight_moment_amplitude_best_plain_below(double alpha)
{
    const double v1 = alpha * alpha;
    const double v4 = 0x1.d57b926b63ae8p-41 * v1;
    const double v5 = v4 + (-0x1.c090a61bf422dp-35);
    const double v7 = v5 * v1;
    const double v8 = v7 + 0x1.484138797ad96p-29;
    const double v10 = v8 * v1;
    const double v11 = v10 + (-0x1.85d83b7e78aadp-24);
    const double v13 = v11 * v1;
    const double v14 = v13 + 0x1.702ffd4421227p-19;
    const double v16 = v14 * v1;
    const double v17 = v16 + (-0x1.0c7836b1956aap-14);
    const double v19 = v17 * v1;
    const double v20 = v19 + 0x1.22d671ab555f0p-10;
    const double v22 = v20 * v1;
    const double v23 = v22 + (-0x1.bc466f119ba39p-7);
    const double v25 = v23 * v1;
    const double v26 = v25 + 0x1.bbbbbbbbbbbb9p-4;
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
    const double v5 = 0x1.6d9d5170fc716p-33 * v2;
    const double v6 = v5 + (-0x1.bfb0b783ae8f0p-30);
    const double v8 = v6 * v2;
    const double v9 = v8 + 0x1.049260a64bfe6p-27;
    const double v11 = v9 * v2;
    const double v12 = v11 + (-0x1.734fa7fd17f63p-26);
    const double v14 = v12 * v2;
    const double v15 = v14 + 0x1.6acc24dff3191p-25;
    const double v17 = v15 * v2;
    const double v18 = v17 + (-0x1.f864667c48d90p-25);
    const double v20 = v18 * v2;
    const double v21 = v20 + 0x1.0992dc7bcbf01p-24;
    const double v23 = v21 * v2;
    const double v24 = v23 + (-0x1.7955d5936a77ap-25);
    const double v26 = v24 * v2;
    const double v27 = v26 + 0x1.4b5045ea2e1fap-25;
    const double v29 = v27 * v2;
    const double v30 = v29 + 0x1.143e3698c3a5ep-25;
    const double v32 = v30 * v2;
    const double v33 = v32 + 0x1.9ca7a9c4fe21cp-24;
    const double v35 = v33 * v2;
    const double v36 = v35 + 0x1.7ae1913b52dd2p-19;
    const double v38 = v36 * v2;
    const double v39 = v38 + (-0x1.8d48a1c521398p-15);
    const double v41 = v39 * v2;
    const double v42 = v41 + 0x1.d0042cc329a9cp-11;
    const double v44 = v42 * v2;
    const double v45 = v44 + (-0x1.5ac056af97eb5p-7);
    const double v47 = v45 * v2;
    const double v48 = v47 + 0x1.5f15f15f15723p-4;
    const double v50 = v48 * v2;
    const double v51 = v50 + (-0x1.9999999999994p-2);
    const double v52 = v51 * v2;
    const double v53 = 0x1.0000000000000p+0 + v52;
    const double v55 = 0x1.921fb54442d18p+0 - alpha;
    const double v56 = v55 * v55;
    const double v59 = 0x1.f52cc7c7dfefdp-16 * v56;
    const double v60 = v59 + (-0x1.047e200356e2ep-11);
    const double v62 = v60 * v56;
    const double v63 = v62 + 0x1.5582f28f586d2p-8;
    const double v65 = v63 * v56;
    const double v66 = v65 + (-0x1.0ee063bdf7d00p-5);
    const double v68 = v66 * v56;
    const double v69 = v68 + 0x1.94ebfbcf8c0fdp-4;
    const double v71 = v69 * v56;
    const double v72 = v71 + (-0x1.213ce230a79e8p-7);
    const double v75 = (-0x1.74ce10bfef7f7p-16) * v56;
    const double v76 = v75 + 0x1.85f979159b9b1p-12;
    const double v78 = v76 * v56;
    const double v79 = v78 + (-0x1.2825e27d993d6p-8);
    const double v81 = v79 * v56;
    const double v82 = v81 + 0x1.27d28a4134219p-5;
    const double v84 = v82 * v56;
    const double v85 = v84 + (-0x1.5555554df34edp-3);
    const double v87 = v85 * v56;
    const double v88 = v87 + 0x1.55555555565f3p-2;
    const double v90 = v55 > 0x1.0000000000000p-60 ? v55 : 0x1.0000000000000p-60;
    const double v91 = significand_of(v90);
    const double v92 = v91 - 0x1.0000000000000p+0;
    const double v94 = v92 + 0x1.0000000000000p+1;
    const double v95 = v92 / v94;
    const double v96 = v95 * v95;
    const double v99 = 0x1.3cda08c7927d8p-3 * v96;
    const double v100 = v99 + 0x1.3804595ac79edp-3;
    const double v102 = v100 * v96;
    const double v103 = v102 + 0x1.747966b22b47ep-3;
    const double v105 = v103 * v96;
    const double v106 = v105 + 0x1.c71be01ef8d7bp-3;
    const double v108 = v106 * v96;
    const double v109 = v108 + 0x1.249249f1b0e53p-2;
    const double v111 = v109 * v96;
    const double v112 = v111 + 0x1.999999987c7a3p-2;
    const double v114 = v112 * v96;
    const double v115 = v114 + 0x1.55555555559d8p-1;
    const double v116 = v96 * v115;
    const double v117 = v116 - v92;
    const double v118 = exponent_of(v90);
    const double v120 = v118 * 0x1.62e42fefa39efp-1;
    const double v121 = v120 + v92;
    const double v122 = v95 * v117;
    const double v123 = v122 + v121;
    const double v124 = v88 * v123;
    const double v125 = v124 + v72;
    const double v126 = v55 * v56;
    const double v128 = v126 * v125;
    const double v129 = v128 + 0x1.fab71f4a3269fp-7;
    const double v131 = alpha + (-0x1.1400000000000p-1);
    const double v132 = v131 + v129;
    const int v134 = alpha < 0x1.2e147ae147ae1p+0;
    const double v135 = v134 ? v53 : v132;
    const double v137 = v135 / 0x1.8000000000000p+0;
    const double v138 = v134 ? v137 : v135;
    const double v141 = 0x1.5aeb95ee17e27p-52 * v2;
    const double v142 = v141 + (-0x1.ae33aea2b0d55p-44);
    const double v144 = v142 * v2;
    const double v145 = v144 + 0x1.93966653151c3p-36;
    const double v147 = v145 * v2;
    const double v148 = v147 + (-0x1.1eed8d7449e95p-28);
    const double v150 = v148 * v2;
    const double v151 = v150 + 0x1.27e4fb7471f25p-21;
    const double v153 = v151 * v2;
    const double v154 = v153 + (-0x1.a01a01a0132c2p-15);
    const double v156 = v154 * v2;
    const double v157 = v156 + 0x1.6c16c16c16ba2p-9;
    const double v159 = v157 * v2;
    const double v160 = v159 + (-0x1.5555555555555p-4);
    const double v161 = v160 * v2;
    const double v162 = 0x1.0000000000000p+0 + v161;
    const double v163 = v2 * v161;
    const double v164 = v163 + v2;
    const double v165 = v164 * alpha;
    const double v166 = v134 ? v162 : v165;
    const double v167 = v134 ? v166 : v166;
    const double v168 = v138 / v167;
    return v168;
}
#define dynamic_coefficient_best_plain_KIND whole

INLINE double weight_moment_per_inertia_best_plain(double alpha)
{
    const double v2 = alpha * alpha;
    const double v5 = 0x1.d3e7e3f9c88d6p-41 * v2;
    const double v6 = v5 + (-0x1.c070770e543abp-35);
    const double v8 = v6 * v2;
    const double v9 = v8 + 0x1.4840244c506fap-29;
    const double v11 = v9 * v2;
    const double v12 = v11 + (-0x1.85d83164ee775p-24);
    const double v14 = v12 * v2;
    const double v15 = v14 + 0x1.702ffd0c3458cp-19;
    const double v17 = v15 * v2;
    const double v18 = v17 + (-0x1.0c7836b0dc07dp-14);
    const double v20 = v18 * v2;
    const double v21 = v20 + 0x1.22d671ab529c0p-10;
    const double v23 = v21 * v2;
    const double v24 = v23 + (-0x1.bc466f119b98cp-7);
    const double v26 = v24 * v2;
    const double v27 = v26 + 0x1.bbbbbbbbbbbb8p-4;
    const double v29 = v27 * v2;
    const double v30 = v29 + (-0x1.0000000000000p-1);
    const double v31 = v30 * v2;
    const double v32 = 0x1.0000000000000p+0 + v31;
    const double v34 = 0x1.921fb54442d18p+0 - alpha;
    const double v35 = v34 * v34;
    const double v38 = 0x1.64c78b2442998p-22 * v35;
    const double v39 = v38 + (-0x1.32aba46279bb3p-17);
    const double v41 = v39 * v35;
    const double v42 = v41 + 0x1.83ca4d0f33cdbp-13;
    const double v44 = v42 * v35;
    const double v45 = v44 + (-0x1.637e09681a6fbp-9);
    const double v47 = v45 * v35;
    const double v48 = v47 + 0x1.bc8bc8bb1d67bp-6;
    const double v50 = v48 * v35;
    const double v51 = v50 + (-0x1.5b05b05b06654p-3);
    const double v53 = v51 * v35;
    const double v54 = v53 + 0x1.2aaaaaaaaab34p-1;
    const double v56 = v54 * v35;
    const double v57 = v56 + (-0x1.0000000000006p-2);
    const double v60 = v34 * (-0x1.1a62633145c07p-53);
    const double v61 = v60 + (-0x1.194bfdddaf855p-6);
    const double v62 = v35 * v57;
    const double v63 = v62 + v61;
    const double v66 = v34 * (-0x1.8000000000000p-1);
    const double v67 = v66 + 0x1.0000000000000p-1;
    const double v68 = v34 * v67;
    const double v69 = v68 + v63;
    const double v70 = 0x1.0000000000000p-1 * alpha;
    const double v72 = v70 + (-0x1.a000000000000p-4);
    const double v73 = v72 + v69;
    const int v75 = alpha < 0x1.0f5c28f5c28f6p+0;
    const double v76 = v75 ? v32 : v73;
    const double v79 = (-0x1.0da7a75f6871fp-38) * v2;
    const double v80 = v79 + 0x1.713e0b35af1d1p-33;
    const double v82 = v80 * v2;
    const double v83 = v82 + (-0x1.717211291e65ep-28);
    const double v85 = v83 * v2;
    const double v86 = v85 + 0x1.2f47b732005adp-23;
    const double v88 = v86 * v2;
    const double v89 = v88 + (-0x1.952f81992cfd9p-19);
    const double v91 = v89 * v2;
    const double v92 = v91 + 0x1.ae8cb1689414fp-15;
    const double v94 = v92 * v2;
    const double v95 = v94 + (-0x1.615085c1313c5p-11);
    const double v97 = v95 * v2;
    const double v98 = v97 + 0x1.af3b88aa6ea41p-8;
    const double v100 = v98 * v2;
    const double v101 = v100 + (-0x1.74c1f6ca16b80p-5);
    const double v103 = v101 * v2;
    const double v104 = v103 + 0x1.ad1ad1ad1acf6p-3;
    const double v106 = v104 * v2;
    const double v107 = v106 + (-0x1.3333333333333p-1);
    const double v108 = v107 * v2;
    const double v109 = 0x1.0000000000000p+0 + v108;
    const double v112 = 0x1.00ab575ef75a6p-19 * v35;
    const double v113 = v112 + (-0x1.1e99caf0a78dfp-15);
    const double v115 = v113 * v35;
    const double v116 = v115 + 0x1.d69dd6e3a84b4p-12;
    const double v118 = v116 * v35;
    const double v119 = v118 + (-0x1.1e5e14556f803p-8);
    const double v121 = v119 * v35;
    const double v122 = v121 + 0x1.e94dfd2a84da7p-6;
    const double v124 = v122 * v35;
    const double v125 = v124 + (-0x1.0cbb76624ef26p-3);
    const double v127 = v125 * v35;
    const double v128 = v127 + 0x1.3e93e93e9679ap-2;
    const double v130 = v128 * v35;
    const double v131 = v130 + (-0x1.c71c71c71c995p-3);
    const double v133 = v131 * v35;
    const double v134 = v133 + (-0x1.555555555554fp-3);
    const double v136 = v34 * v134;
    const double v137 = v136 + 0x1.9ffffffffffffp-4;
    const double v138 = v72 + v137;
    const double v139 = v75 ? v109 : v138;
    const double v140 = v76 / v139;
    return v140;
}
#define weight_moment_per_inertia_best_plain_KIND whole

INLINE double radial_weight_per_inertia_best_plain(double alpha)
{
    const double v2 = alpha * alpha;
    const double v5 = (-0x1.3e79820265a98p-30) * v2;
    const double v6 = v5 + 0x1.70ea51a0a09b0p-27;
    const double v8 = v6 * v2;
    const double v9 = v8 + (-0x1.9991739f3798dp-25);
    const double v11 = v9 * v2;
    const double v12 = v11 + 0x1.1842bd29415d0p-23;
    const double v14 = v12 * v2;
    const double v15 = v14 + (-0x1.090e4945627c1p-22);
    const double v17 = v15 * v2;
    const double v18 = v17 + 0x1.6817c7af0123cp-22;
    const double v20 = v18 * v2;
    const double v21 = v20 + (-0x1.750d8648525d3p-22);
    const double v23 = v21 * v2;
    const double v24 = v23 + 0x1.0e659f269d535p-22;
    const double v26 = v24 * v2;
    const double v27 = v26 + (-0x1.a89817d793344p-23);
    const double v29 = v27 * v2;
    const double v30 = v29 + (-0x1.2056f30bad3a6p-24);
    const double v32 = v30 * v2;
    const double v33 = v32 + (-0x1.0358739aa2e8bp-21);
    const double v35 = v33 * v2;
    const double v36 = v35 + (-0x1.ab1617f867c1bp-20);
    const double v38 = v36 * v2;
    const double v39 = v38 + (-0x1.8207776615708p-18);
    const double v41 = v39 * v2;
    const double v42 = v41 + (-0x1.8bc35755cb770p-16);
    const double v44 = v42 * v2;
    const double v45 = v44 + (-0x1.ebc1b1193de65p-16);
    const double v47 = v45 * v2;
    const double v48 = v47 + (-0x1.0cbb7660d8f0bp-9);
    const double v50 = v48 * v2;
    const double v51 = v50 + 0x1.c09c09c09b0e7p-6;
    const double v53 = v51 * v2;
    const double v54 = v53 + (-0x1.3333333333331p-2);
    const double v55 = v54 * v2;
    const double v56 = 0x1.0000000000000p+0 + v55;
    const double v58 = 0x1.921fb54442d18p+0 - alpha;
    const double v59 = v58 * v58;
    const double v62 = 0x1.64009ce2f3630p-17 * v59;
    const double v63 = v62 + (-0x1.5c6d8636f92ccp-12);
    const double v65 = v63 * v59;
    const double v66 = v65 + 0x1.c0f9c0515effdp-8;
    const double v68 = v66 * v59;
    const double v69 = v68 + (-0x1.5fec36ee4b768p-4);
    const double v71 = v69 * v59;
    const double v72 = v71 + 0x1.2c981ff6211c9p-1;
    const double v74 = v72 * v59;
    const double v75 = v74 + (-0x1.7217f7d1acae6p-7);
    const double v78 = (-0x1.27ac624df162ep-18) * v59;
    const double v79 = v78 + 0x1.28ae92a1ef664p-13;
    const double v81 = v79 * v59;
    const double v82 = v81 + (-0x1.a01620d59d215p-9);
    const double v84 = v82 * v59;
    const double v85 = v84 + 0x1.6c16c49fd75c7p-5;
    const double v87 = v85 * v59;
    const double v88 = v87 + (-0x1.5555555455f4cp-2);
    const double v90 = v88 * v59;
    const double v91 = v90 + 0x1.000000000015dp+0;
    const double v93 = 0x1.0000000000000p+1 * v58;
    const double v95 = v93 > 0x1.0000000000000p-60 ? v93 : 0x1.0000000000000p-60;
    const double v96 = significand_of(v95);
    const double v97 = v96 - 0x1.0000000000000p+0;
    const double v98 = v97 + 0x1.0000000000000p+1;
    const double v99 = v97 / v98;
    const double v100 = v99 * v99;
    const double v103 = 0x1.3cda08c7927d8p-3 * v100;
    const double v104 = v103 + 0x1.3804595ac79edp-3;
    const double v106 = v104 * v100;
    const double v107 = v106 + 0x1.747966b22b47ep-3;
    const double v109 = v107 * v100;
    const double v110 = v109 + 0x1.c71be01ef8d7bp-3;
    const double v112 = v110 * v100;
    const double v113 = v112 + 0x1.249249f1b0e53p-2;
    const double v115 = v113 * v100;
    const double v116 = v115 + 0x1.999999987c7a3p-2;
    const double v118 = v116 * v100;
    const double v119 = v118 + 0x1.55555555559d8p-1;
    const double v120 = v100 * v119;
    const double v121 = v120 - v97;
    const double v122 = exponent_of(v95);
    const double v124 = v122 * 0x1.62e42fefa39efp-1;
    const double v125 = v124 + v97;
    const double v126 = v99 * v121;
    const double v127 = v126 + v125;
    const double v128 = v91 * v127;
    const double v129 = v128 + v75;
    const double v131 = v59 * v129;
    const double v132 = v131 + 0x1.5e04abbbd2e80p-5;
    const double v135 = v58 * (-0x1.e000000000000p+0);
    const double v136 = v135 + 0x1.0000000000000p-1;
    const double v137 = v58 * v136;
    const double v138 = v137 + v132;
    const double v139 = 0x1.0000000000000p-1 * alpha;
    const double v141 = v139 + 0x1.6000000000000p-3;
    const double v142 = v141 + v138;
    const int v144 = alpha < 0x1.1eb851eb851ecp+0;
    const double v145 = v144 ? v56 : v142;
    const double v148 = (-0x1.0c8fef86260a6p-38) * v2;
    const double v149 = v148 + 0x1.71035aeccbd2cp-33;
    const double v151 = v149 * v2;
    const double v152 = v151 + (-0x1.716cd10e1367cp-28);
    const double v154 = v152 * v2;
    const double v155 = v154 + 0x1.2f47742ab1046p-23;
    const double v157 = v155 * v2;
    const double v158 = v157 + (-0x1.952f7d837ab6fp-19);
    const double v160 = v158 * v2;
    const double v161 = v160 + 0x1.ae8cb1407cfe4p-15;
    const double v163 = v161 * v2;
    const double v164 = v163 + (-0x1.615085c03c10ep-11);
    const double v166 = v164 * v2;
    const double v167 = v166 + 0x1.af3b88aa67b1bp-8;
    const double v169 = v167 * v2;
    const double v170 = v169 + (-0x1.74c1f6ca169d6p-5);
    const double v172 = v170 * v2;
    const double v173 = v172 + 0x1.ad1ad1ad1acf1p-3;
    const double v175 = v173 * v2;
    const double v176 = v175 + (-0x1.3333333333333p-1);
    const double v177 = v176 * v2;
    const double v178 = 0x1.0000000000000p+0 + v177;
    const double v181 = 0x1.16f943a246fa1p-19 * v59;
    const double v182 = v181 + (-0x1.1fcee5678494fp-15);
    const double v184 = v182 * v59;
    const double v185 = v184 + 0x1.d6ab8ca876bdep-12;
    const double v187 = v185 * v59;
    const double v188 = v187 + (-0x1.1e5e3d4c60700p-8);
    const double v190 = v188 * v59;
    const double v191 = v190 + 0x1.e94dfe3da88b8p-6;
    const double v193 = v191 * v59;
    const double v194 = v193 + (-0x1.0cbb76644f474p-3);
    const double v196 = v194 * v59;
    const double v197 = v196 + 0x1.3e93e93e9e0d6p-2;
    const double v199 = v197 * v59;
    const double v200 = v199 + (-0x1.c71c71c71cc85p-3);
    const double v202 = v200 * v59;
    const double v203 = v202 + (-0x1.555555555554dp-3);
    const double v205 = v58 * v203;
    const double v206 = v205 + 0x1.7ffffffffffffp-4;
    const double v208 = v139 + (-0x1.8000000000000p-4);
    const double v209 = v208 + v206;
    const double v210 = v144 ? v178 : v209;
    const double v211 = v145 / v210;
    return v211;
}
#define radial_weight_per_inertia_best_plain_KIND whole

INLINE double polar_moment_per_inertia_best_plain(double alpha)
{
    const double v2 = alpha * alpha;
    const double v5 = 0x1.1eee76bd622b2p-30 * v2;
    const double v6 = v5 + (-0x1.19d3973aa36cap-28);
    const double v8 = v6 * v2;
    const double v9 = v8 + 0x1.6d70197211f4ap-27;
    const double v11 = v9 * v2;
    const double v12 = v11 + (-0x1.5a5f166c6032dp-27);
    const double v14 = v12 * v2;
    const double v15 = v14 + 0x1.8e95c135f0567p-26;
    const double v17 = v15 * v2;
    const double v18 = v17 + 0x1.3a43a49a6a763p-25;
    const double v20 = v18 * v2;
    const double v21 = v20 + 0x1.9a231cb6effb3p-24;
    const double v23 = v21 * v2;
    const double v24 = v23 + 0x1.7adecfc69194fp-19;
    const double v26 = v24 * v2;
    const double v27 = v26 + (-0x1.8d4885b4b5809p-15);
    const double v29 = v27 * v2;
    const double v30 = v29 + 0x1.d0042c6d017fep-11;
    const double v32 = v30 * v2;
    const double v33 = v32 + (-0x1.5ac056af15827p-7);
    const double v35 = v33 * v2;
    const double v36 = v35 + 0x1.5f15f15f14b9cp-4;
    const double v38 = v36 * v2;
    const double v39 = v38 + (-0x1.9999999999989p-2);
    const double v40 = v39 * v2;
    const double v41 = 0x1.0000000000000p+0 + v40;
    const double v43 = 0x1.921fb54442d18p+0 - alpha;
    const double v44 = v43 * v43;
    const double v47 = 0x1.af511ed3efee7p-15 * v44;
    const double v48 = v47 + (-0x1.8a9e832d9844dp-11);
    const double v50 = v48 * v44;
    const double v51 = v50 + 0x1.115fe28110038p-7;
    const double v53 = v51 * v44;
    const double v54 = v53 + (-0x1.dbecf43061ae4p-5);
    const double v56 = v54 * v44;
    const double v57 = v56 + 0x1.b70e1da718514p-3;
    const double v59 = v57 * v44;
    const double v60 = v59 + (-0x1.eb440e0d5b068p-3);
    const double v63 = (-0x1.b634872dcba2dp-16) * v44;
    const double v64 = v63 + 0x1.7ff85a336a890p-12;
    const double v66 = v64 * v44;
    const double v67 = v66 + (-0x1.283af2ca91d53p-8);
    const double v69 = v67 * v44;
    const double v70 = v69 + 0x1.27d268328778dp-5;
    const double v72 = v70 * v44;
    const double v73 = v72 + (-0x1.5555556697b7dp-3);
    const double v75 = v73 * v44;
    const double v76 = v75 + 0x1.55555555518aap-2;
    const double v78 = 0x1.0000000000000p+1 * v43;
    const double v80 = v78 > 0x1.0000000000000p-60 ? v78 : 0x1.0000000000000p-60;
    const double v81 = significand_of(v80);
    const double v82 = v81 - 0x1.0000000000000p+0;
    const double v83 = v82 + 0x1.0000000000000p+1;
    const double v84 = v82 / v83;
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
    const double v106 = v105 - v82;
    const double v107 = exponent_of(v80);
    const double v109 = v107 * 0x1.62e42fefa39efp-1;
    const double v110 = v109 + v82;
    const double v111 = v84 * v106;
    const double v112 = v111 + v110;
    const double v113 = v76 * v112;
    const double v114 = v113 + v60;
    const double v115 = v43 * v44;
    const double v117 = v115 * v114;
    const double v118 = v117 + 0x1.7d5b8fa51934fp-6;
    const double v120 = alpha + (-0x1.1800000000000p-1);
    const double v121 = v120 + v118;
    const int v122 = alpha < 0x1.0000000000000p+0;
    const double v123 = v122 ? v41 : v121;
    const double v126 = 0x1.42b63276d0e01p-33 * v2;
    const double v127 = v126 + (-0x1.6dfaada66d5aep-28);
    const double v129 = v127 * v2;
    const double v130 = v129 + 0x1.2f2260a235af0p-23;
    const double v132 = v130 * v2;
    const double v133 = v132 + (-0x1.952d8ea52153ep-19);
    const double v135 = v133 * v2;
    const double v136 = v135 + 0x1.ae8ca0b5c00e3p-15;
    const double v138 = v136 * v2;
    const double v139 = v138 + (-0x1.61508565a6444p-11);
    const double v141 = v139 * v2;
    const double v142 = v141 + 0x1.af3b88a801647p-8;
    const double v144 = v142 * v2;
    const double v145 = v144 + (-0x1.74c1f6ca0d41bp-5);
    const double v147 = v145 * v2;
    const double v148 = v147 + 0x1.ad1ad1ad1aaafp-3;
    const double v150 = v148 * v2;
    const double v151 = v150 + (-0x1.3333333333330p-1);
    const double v152 = v151 * v2;
    const double v153 = 0x1.0000000000000p+0 + v152;
    const double v156 = (-0x1.00589fe65ed98p-23) * v44;
    const double v157 = v156 + 0x1.1425220d45aaap-19;
    const double v159 = v157 * v44;
    const double v160 = v159 + (-0x1.1f397f95f7403p-15);
    const double v162 = v160 * v44;
    const double v163 = v162 + 0x1.d6a371cc475cdp-12;
    const double v165 = v163 * v44;
    const double v166 = v165 + (-0x1.1e5e23528aa32p-8);
    const double v168 = v166 * v44;
    const double v169 = v168 + 0x1.e94dfd8b6e6d2p-6;
    const double v171 = v169 * v44;
    const double v172 = v171 + (-0x1.0cbb76630619cp-3);
    const double v174 = v172 * v44;
    const double v175 = v174 + 0x1.3e93e93e9959dp-2;
    const double v177 = v175 * v44;
    const double v178 = v177 + (-0x1.c71c71c71cad2p-3);
    const double v180 = v178 * v44;
    const double v181 = v180 + (-0x1.555555555554ep-3);
    const double v183 = v43 * v181;
    const double v184 = v183 + 0x1.dffffffffffffp-4;
    const double v186 = 0x1.0000000000000p-1 * alpha;
    const double v188 = v186 + (-0x1.e000000000000p-4);
    const double v189 = v188 + v184;
    const double v190 = v122 ? v153 : v189;
    const double v191 = v123 / v190;
    return v191;
}
#define polar_moment_per_inertia_best_plain_KIND whole

INLINE double weight_moment_per_radial_weight_best_plain(double alpha)
{
    const double v2 = alpha * alpha;
    const double v5 = 0x1.cdf1a753f4825p-41 * v2;
    const double v6 = v5 + (-0x1.bfeb30e74d917p-35);
    const double v8 = v6 * v2;
    const double v9 = v8 + 0x1.483b3c6f03034p-29;
    const double v11 = v9 * v2;
    const double v12 = v11 + (-0x1.85d7fece9ce4fp-24);
    const double v14 = v12 * v2;
    const double v15 = v14 + 0x1.702ffbd6802c0p-19;
    const double v17 = v15 * v2;
    const double v18 = v17 + (-0x1.0c7836ac674c6p-14);
    const double v20 = v18 * v2;
    const double v21 = v20 + 0x1.22d671ab3f983p-10;
    const double v23 = v21 * v2;
    const double v24 = v23 + (-0x1.bc466f119b448p-7);
    const double v26 = v24 * v2;
    const double v27 = v26 + 0x1.bbbbbbbbbbbafp-4;
    const double v29 = v27 * v2;
    const double v30 = v29 + (-0x1.0000000000000p-1);
    const double v31 = v30 * v2;
    const double v32 = 0x1.0000000000000p+0 + v31;
    const double v34 = 0x1.921fb54442d18p+0 - alpha;
    const double v35 = v34 * v34;
    const double v38 = 0x1.44ebe008475edp-22 * v35;
    const double v39 = v38 + (-0x1.31e2be57bfe01p-17);
    const double v41 = v39 * v35;
    const double v42 = v41 + 0x1.83c64150f3de6p-13;
    const double v44 = v42 * v35;
    const double v45 = v44 + (-0x1.637dfe720b520p-9);
    const double v47 = v45 * v35;
    const double v48 = v47 + 0x1.bc8bc899c38eep-6;
    const double v50 = v48 * v35;
    const double v51 = v50 + (-0x1.5b05b05ace2a9p-3);
    const double v53 = v51 * v35;
    const double v54 = v53 + 0x1.2aaaaaaaaa534p-1;
    const double v56 = v54 * v35;
    const double v57 = v56 + (-0x1.fffffffffff95p-4);
    const double v60 = v34 * (-0x1.1a62633145c07p-53);
    const double v61 = v60 + (-0x1.8ca5feeed7c2bp-5);
    const double v62 = v35 * v57;
    const double v63 = v62 + v61;
    const double v66 = v34 * (-0x1.c000000000000p-1);
    const double v67 = v66 + 0x1.0000000000000p-1;
    const double v68 = v34 * v67;
    const double v69 = v68 + v63;
    const double v70 = 0x1.0000000000000p-1 * alpha;
    const double v72 = v70 + (-0x1.2000000000000p-4);
    const double v73 = v72 + v69;
    const int v75 = alpha < 0x1.2147ae147ae14p+0;
    const double v76 = v75 ? v32 : v73;
    const double v79 = (-0x1.79fb0a146f1a6p-29) * v2;
    const double v80 = v79 + 0x1.a164ea493de27p-26;
    const double v82 = v80 * v2;
    const double v83 = v82 + (-0x1.b99771f548ac0p-24);
    const double v85 = v83 * v2;
    const double v86 = v85 + 0x1.1df88390028d7p-22;
    const double v88 = v86 * v2;
    const double v89 = v88 + (-0x1.fdd2802ad00e9p-22);
    const double v91 = v89 * v2;
    const double v92 = v91 + 0x1.41fbbd705974ep-21;
    const double v94 = v92 * v2;
    const double v95 = v94 + (-0x1.388ba79ae4b66p-21);
    const double v97 = v95 * v2;
    const double v98 = v97 + 0x1.81cf0f1950821p-22;
    const double v100 = v98 * v2;
    const double v101 = v100 + (-0x1.76f325364bf99p-22);
    const double v103 = v101 * v2;
    const double v104 = v103 + (-0x1.934ebccf8890ep-22);
    const double v106 = v104 * v2;
    const double v107 = v106 + (-0x1.b33a96b385a3ap-20);
    const double v109 = v107 * v2;
    const double v110 = v109 + (-0x1.819d1f4cc4434p-18);
    const double v112 = v110 * v2;
    const double v113 = v112 + (-0x1.8bc71e89b0d50p-16);
    const double v115 = v113 * v2;
    const double v116 = v115 + (-0x1.ebc156b09ffa0p-16);
    const double v118 = v116 * v2;
    const double v119 = v118 + (-0x1.0cbb766afe79ap-9);
    const double v121 = v119 * v2;
    const double v122 = v121 + 0x1.c09c09c0a459dp-6;
    const double v124 = v122 * v2;
    const double v125 = v124 + (-0x1.3333333333349p-2);
    const double v126 = v125 * v2;
    const double v127 = 0x1.0000000000000p+0 + v126;
    const double v130 = 0x1.5cb02195a47e5p-17 * v35;
    const double v131 = v130 + (-0x1.5c79b09b316eap-12);
    const double v133 = v131 * v35;
    const double v134 = v133 + 0x1.c0fa11c3186cdp-8;
    const double v136 = v134 * v35;
    const double v137 = v136 + (-0x1.5fec368b1249bp-4);
    const double v139 = v137 * v35;
    const double v140 = v139 + 0x1.2c981ff63ec19p-1;
    const double v142 = v140 * v35;
    const double v143 = v142 + (-0x1.7217f7d1ab2e7p-7);
    const double v146 = (-0x1.1e2016c290c5cp-18) * v35;
    const double v147 = v146 + 0x1.2910a202b16c5p-13;
    const double v149 = v147 * v35;
    const double v150 = v149 + (-0x1.a015173aabdaap-9);
    const double v152 = v150 * v35;
    const double v153 = v152 + 0x1.6c16c52a07b2ap-5;
    const double v155 = v153 * v35;
    const double v156 = v155 + (-0x1.555555543d7fdp-2);
    const double v158 = v156 * v35;
    const double v159 = v158 + 0x1.0000000000169p+0;
    const double v161 = 0x1.0000000000000p+1 * v34;
    const double v163 = v161 > 0x1.0000000000000p-60 ? v161 : 0x1.0000000000000p-60;
    const double v164 = significand_of(v163);
    const double v165 = v164 - 0x1.0000000000000p+0;
    const double v166 = v165 + 0x1.0000000000000p+1;
    const double v167 = v165 / v166;
    const double v168 = v167 * v167;
    const double v171 = 0x1.3cda08c7927d8p-3 * v168;
    const double v172 = v171 + 0x1.3804595ac79edp-3;
    const double v174 = v172 * v168;
    const double v175 = v174 + 0x1.747966b22b47ep-3;
    const double v177 = v175 * v168;
    const double v178 = v177 + 0x1.c71be01ef8d7bp-3;
    const double v180 = v178 * v168;
    const double v181 = v180 + 0x1.249249f1b0e53p-2;
    const double v183 = v181 * v168;
    const double v184 = v183 + 0x1.999999987c7a3p-2;
    const double v186 = v184 * v168;
    const double v187 = v186 + 0x1.55555555559d8p-1;
    const double v188 = v168 * v187;
    const double v189 = v188 - v165;
    const double v190 = exponent_of(v163);
    const double v192 = v190 * 0x1.62e42fefa39efp-1;
    const double v193 = v192 + v165;
    const double v194 = v167 * v189;
    const double v195 = v194 + v193;
    const double v196 = v159 * v195;
    const double v197 = v196 + v143;
    const double v199 = v35 * v197;
    const double v200 = v199 + 0x1.5e04abbbd2e80p-5;
    const double v202 = v34 * (-0x1.e000000000000p+0);
    const double v203 = v202 + 0x1.0000000000000p-1;
    const double v204 = v34 * v203;
    const double v205 = v204 + v200;
    const double v207 = v70 + 0x1.6000000000000p-3;
    const double v208 = v207 + v205;
    const double v209 = v75 ? v127 : v208;
    const double v210 = v76 / v209;
    return v210;
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
