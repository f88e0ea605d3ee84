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
@PROCESSOR@
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

#define HALF_PI @HALF_PI@
#define END_double @END_double@ /* pi/2 (1 + 4 eps), with the eps of the type */
#define END_float @END_float@
#define LIMIT @LIMIT@ /* of an end of an arc, rad */
#define LAST_double @LAST_double@ /* pattern of the largest number of the type that is not above pi/2 */
#define LAST_float @LAST_float@

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
@POLYNOMIALS@

@BODIES@

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

@LOOPS@

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

@UFUNCS@

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
