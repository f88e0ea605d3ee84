/* Written by `python -m derive` with SymPy 1.14.0; do not edit. */
#define DIGEST "ab61257e17e963ed12fa8a08c480684253e83f9a4a8b91d8781802c509250738"
/* The integrator of lanes along their Taylor series.
 *
 * A lane is one motion: a column of numbers ("cells"), with what its scene gives, the state of its motion, and results.
 * A program (`slipcircle.core.program.program`) says how the series of the motion follow from them. Lanes are integrated
 * side by side in vectors, as many as the processor takes, each with its own step, phase and piece of every table; one
 * that has ended makes room for the next in the queue. No operation mixes lanes, so that the bits of a lane depend
 * neither on its neighbours nor on its place. The whole state of a lane is in its cells: integration may be interrupted
 * after any step and resumed.
 *
 * `slipcircle/core/walk/integrate.py` is the same integrator in NumPy, with the same names. This file is compiled once
 * for every kind of processor (with LEVEL, its name), and once more for the module, which runs the best of those that
 * the machine has. */
#define PY_SSIZE_T_CLEAN
#if !defined(__GNUC__)
#error "the integrator needs the vectors of GCC or Clang"
#endif
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "unsafe float flags: compile without -ffast-math and its parts"
#endif
#include <stddef.h>
#include <stdint.h>

enum { HIGHEST = 40, STRIDE = HIGHEST + 2, MOST_TABLES = 16, MOST_STATES = 16 };

typedef struct { int32_t kind, reg, cell, degree; } Table;
typedef struct {
    const double *breaks, *coefficients, *jumps; /* (pieces[, lanes]), (pieces, terms[, lanes]), (pieces) */
    int64_t pieces, across, apart; /* lanes of the coefficients and of the breaks, or 0 where lanes share them */
    int terms, sine, open;
} Data;
/* Registers, by where they begin, and cells that the prologue fills; -1 where the program has none. */
typedef struct {
    int32_t x, omega, net, normal, upright, drive, drive_scale, normal0, driving_moment, normal_load, normal_load_slope, driving, resisting, mu;
} Roles;

typedef struct {
    /* Of the program: cells, of which those from `made` on come from the prologue or are alike in all lanes; registers,
     * states, tables, those of time and the others; whether its rate depends on the speed alone. */
    int cells, made, registers, states, tables, timed, sloped, autonomous;
    const int32_t *scalar, *scalar_end, *series, *series_end, *later_end, *state; /* after `series` what no rate needs */
    const Table *table;
    const Roles *role;
    Data data[MOST_TABLES];
    double *all; /* cells of all lanes, (cells, count); those from `begin` to `end` are integrated */
    int64_t count, begin, end, budget;
    const double *times; /* where states are read off: (samples, times_across), into (outputs, samples, count) */
    double *outputs; /* without times for the registers of lanes that are not integrated: (registers, count) */
    int64_t samples, times_across;
    double *notes; /* events of the first lane: kind, time, rotation, direction */
    int64_t noted, notes_room;
    void *memory; /* zeros, for the lanes of a batch: a vector for each cell, and STRIDE for each register */
    int order; /* the highest of all lanes */
} Job;

#ifndef LEVEL
/* --- the module --------------------------------------------------------------------------------------------------- */

#include <Python.h>
#include <string.h>

#if defined(__x86_64__)
#define LEVELS(X) X(avx512) X(avx2) X(baseline)
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
#else
#define LEVELS(X) X(baseline)
#endif
#define RUNS_baseline 1

#define DECLARE(LEVEL) int64_t flow_integrate_##LEVEL(Job *job);
LEVELS(DECLARE)
static const struct { const char *name; int64_t (*integrate)(Job *); } levels[] = {
#define ROW(LEVEL) {#LEVEL, flow_integrate_##LEVEL},
    LEVELS(ROW)
};
enum { KINDS = sizeof levels / sizeof *levels };

static int runs(int kind)
{
    const int can[] = {
#define CAN(LEVEL) (RUNS_##LEVEL) != 0,
        LEVELS(CAN)
    };
    return can[kind];
}

/* The program as integers: cells (and `made`), registers, states, tables, integers of operations on numbers,
 * of those on series and of those on series that no rate needs, autonomous; roles; then these operations, states (3 each), tables (4 each), as the structs have them. */
enum { HEAD = 9, WIDEST = 64 };

static int read_program(Job *job, const Py_buffer *program)
{
    const int32_t *p = program->buf, *end = p + program->len / 4;
    if (end - p < HEAD) return -1;
    job->cells = p[0], job->made = p[1], job->registers = p[2], job->states = p[3], job->tables = p[4];
    job->scalar = p + HEAD + sizeof(Roles) / 4;
    job->role = (const Roles *)(p + HEAD);
    job->scalar_end = job->series = job->scalar + p[5];
    job->series_end = job->series + p[6], job->later_end = job->state = job->series_end + p[7];
    job->autonomous = p[8];
    job->table = (const Table *)(job->state + 3 * job->states);
    for (int t = 0; t < job->tables; t++) job->timed += job->table[t].kind == 2, job->sloped += job->table[t].kind != 2;
    return (const int32_t *)(job->table + job->tables) == end && job->tables <= MOST_TABLES && job->states <= MOST_STATES ? 0 : -1;
}

static const char doc[] = "integrate(program, tables, cells, order, begin, end, budget, times, outputs, notes, level)\n--\n\n"
    "Integrate the lanes from `begin` to `end`, columns of `cells`, which change in place, for `budget` steps of a vector\n"
    "at most. Returns how many lanes have not ended (call again), and how many notes there are.\n\n"
    "`program` are integers (see `slipcircle.core.walk.compiled`); each of `tables` is (breaks, coefficients, jumps, terms,\n"
    "across, sine, open); `order` is the highest of the lanes'. States are read off at `times`, (samples, 1 or lanes),\n"
    "into `outputs`, (4 + further states, samples, lanes), or nowhere where `times` is empty; events of the first lane\n"
    "are written into `notes`, (rows, 4), and what has no room there is not written.\n\n"
    "With `outputs`, (registers, lanes), and no times nothing is integrated: all registers are evaluated where each lane is;\n"
    "with a budget a phase begins there first, in the direction that is set.";

static PyObject *integrate(PyObject *self, PyObject *args)
{
    (void)self;
    Job job = {0};
    Py_buffer program, cells, times, outputs, notes, held[3 * MOST_TABLES];
    PyObject *tables, *result = NULL;
    int order, level, views = 0;
    Py_ssize_t begin, end, budget;
    if (!PyArg_ParseTuple(args, "y*O!w*innny*w*w*i", &program, &PyTuple_Type, &tables, &cells, &order, &begin, &end,
                          &budget, &times, &outputs, &notes, &level)) return NULL;
    const int bad = read_program(&job, &program) || order < 5 || order > HIGHEST || PyTuple_GET_SIZE(tables) != job.tables;
    if (bad || level < 0 || level >= KINDS || !runs(level)) {
        PyErr_SetString(PyExc_ValueError, "integrate: the program, its tables, order or level do not fit");
        goto done;
    }
    for (int t = 0; t < job.tables; t++, views += 3) {
        Data *d = job.data + t;
        long long across;
        Py_buffer *b = held + views;
        if (!PyArg_ParseTuple(PyTuple_GET_ITEM(tables, t), "y*y*y*iLpp", b, b + 1, b + 2, &d->terms, &across, &d->sine,
                              &d->open)) goto done;
        d->breaks = b[0].buf, d->coefficients = b[1].buf, d->jumps = b[2].buf;
        d->pieces = b[2].len / 8, d->across = across, d->apart = b[0].len > b[2].len ? across : 0;
    }
    job.all = cells.buf, job.count = cells.len / 8 / job.cells;
    job.begin = begin, job.end = end < job.count ? end : job.count, job.budget = budget;
    if (times.len) {
        job.times = times.buf, job.outputs = outputs.buf;
        job.samples = outputs.len / 8 / job.count / (2 + job.states);
        job.times_across = times.len / 8 / job.samples;
    } else if (outputs.len) job.outputs = outputs.buf;
    job.notes = notes.buf, job.notes_room = notes.len / 32;
    job.order = order;
    void *memory = PyMem_RawCalloc((size_t)(job.cells + job.registers * STRIDE) + 1, WIDEST);
    if (memory == NULL) {
        PyErr_NoMemory();
        goto done;
    }
    job.memory = (void *)(((uintptr_t)memory + WIDEST - 1) & ~(uintptr_t)(WIDEST - 1));
    int64_t left;
    Py_BEGIN_ALLOW_THREADS
    left = levels[level].integrate(&job);
    Py_END_ALLOW_THREADS
    PyMem_RawFree(memory);
    result = Py_BuildValue("LL", (long long)left, (long long)job.noted);
done:
    while (views--) PyBuffer_Release(held + views);
    PyBuffer_Release(&program), PyBuffer_Release(&cells), PyBuffer_Release(&times), PyBuffer_Release(&outputs);
    PyBuffer_Release(&notes);
    return result;
}

/* DIGEST of the source; LEVELS: those that run here, name -> number, the widest first. */
static int fill(PyObject *module)
{
    PyObject *levels_here = PyDict_New();
    int failed = levels_here == NULL;
    for (int k = 0; k < KINDS && !failed; k++) {
        PyObject *number = runs(k) ? PyLong_FromLong(k) : NULL;
        failed = number && PyDict_SetItemString(levels_here, levels[k].name, number);
        Py_XDECREF(number);
    }
    failed = failed || PyModule_AddObjectRef(module, "LEVELS", levels_here) ||
             PyModule_AddStringConstant(module, "DIGEST", DIGEST);
    Py_XDECREF(levels_here);
    return failed ? -1 : 0;
}

static PyMethodDef methods[] = {{"integrate", integrate, METH_VARARGS, doc}, {NULL, NULL, 0, NULL}};
static PyModuleDef_Slot slots[] = {
    {Py_mod_exec, fill},
#ifdef Py_mod_gil
    {Py_mod_gil, Py_MOD_GIL_NOT_USED},
#endif
    {0, NULL},
};
static struct PyModuleDef definition = {PyModuleDef_HEAD_INIT, "_flow", NULL, 0, methods, slots, NULL, NULL, NULL};
PyMODINIT_FUNC PyInit__flow(void) { return PyModuleDef_Init(&definition); }

#else
/* --- the integrator, for one kind of processor ----------------------------------------------------------------------- */

#include <math.h>
#include <string.h>
#if WIDE > 128
#include <immintrin.h>
#endif

#define INLINE static inline __attribute__((always_inline))
#define NAMED_(name, level) name##_##level
#define NAMED(name, level) NAMED_(name, level)
#define EPS 0x1p-52

enum { LANES = WIDE / 64, ALL = (1 << LANES) - 1 };
typedef double V __attribute__((vector_size(WIDE / 8)));
typedef int64_t M __attribute__((vector_size(WIDE / 8))); /* true is -1, false is 0 */

enum { TIME, ROTATION, SLIP, DIRECTION, LIFTED, STATUS, STEPS, PHASES, ORDER, FACTOR, END_TIME, ONE_WAY, FIRST_ONLY, LIMIT, PEAK_TIME, PEAK_ROTATION, PEAK_OMEGA, PEAK_RATE, REACH_TIME, REACH_ROTATION, END_ROTATION, END_OMEGA, END_RATE, CLOSE, LIFT_TIME, PASSED, REST_SINCE, TURNS, LAST_WAY, X, OMEGA };
enum { PIECE, VALUE, INC, UPPER, LOWER, SCALE, SCALED_BY, WAY, Q1 };
enum { START, MOVING, RESTING, ARRESTED, PAUSED, ENDED, STOPPED, UPRIGHT, TOO_LONG, FAILED, NEED };
enum { NOTHING, LIFT, FASTER, SLOWER };
enum { EVENT_NONE = -1, EVENT_STANDSTILL, EVENT_LIFT_OFF, EVENT_CHORD_UPRIGHT, EVENT_BREAKPOINT };
enum { NOTE_BEGINS = 1, NOTE_STANDS, NOTE_LIFTS, NOTE_LANDS };
enum { OF_SLIP, OF_SPEED, OF_TIME, OF_ROTATION };
enum { MOST_STEPS = 200000, STIFF_STEP = 20, MOST_TURNS = 2000 };
#define STIFF_CHANGE 0.001
#define CARRIED 0.001
#define SETTLED 1.4210854715202004e-14
enum { LIN, RAMP, MUL, SQR, POWERS, TIM, TURN, EXP, REC, LOG, POW };
enum { S_ADD, S_SUB, S_MUL, S_DIV, S_NEG, S_SIN, S_COS, S_TAN, S_EXP, S_EXPM1, S_LOG, S_LOG1P, S_SQRT, S_ABS, S_MIN, S_MAX, S_LESS, S_SELECT };
enum { READY, START_MOVING, RESOLVE, START_AGAIN, ENTER_PHASE, DISCONTINUITY, BEGIN_PHASE }; /* what a lane waits for before its next step */

/* The lanes that are integrated now, beside their cells. */
typedef struct {
    Job *job;
    V *c, *r; /* cells, and registers: coefficient n of the register that begins at i is r[i + n] */
    int64_t column[LANES];
    unsigned held; /* a bit for each lane */
    int pending[LANES], faced[LANES], sudden[LANES];
    double rate[LANES], drive[LANES], drive_scale[LANES];
    double inverse[HIGHEST + 2];
} Batch;

/* --- vectors and functions of them --- */

INLINE V pick(M m, V a, V b) { return (V)(((M)a & m) | ((M)b & ~m)); }
INLINE V magnitude(V x) { return (V)((M)x & INT64_MAX); }
INLINE V minimum(V a, V b) { return pick(a < b, a, b); }
INLINE V maximum(V a, V b) { return pick(a > b, a, b); }
INLINE V broadcast(double x)
{
    V all;
    for (int k = 0; k < LANES; k++) all[k] = x;
    return all;
}
INLINE unsigned bits(M m)
{
#if WIDE == 512
    return _mm512_movepi64_mask((__m512i)m);
#elif WIDE == 256
    return (unsigned)_mm256_movemask_pd((__m256d)m);
#else
    unsigned mask = 0;
    for (int k = 0; k < LANES; k++) mask |= (unsigned)(m[k] & 1) << k;
    return mask;
#endif
}
INLINE M lanes(unsigned b)
{
    M each;
    for (int k = 0; k < LANES; k++) each[k] = 1 << k;
    return (each & (int64_t)b) != 0;
}
#define EACH(k, b) for (unsigned left_ = (b), k; left_ && (k = (unsigned)__builtin_ctz(left_), 1); left_ &= left_ - 1)

/* The nearest integer of |x| < 2^51, by the addition that has no bits beyond it; the sum's pattern ends in its bits. */
#define TO_INTEGER 0x1.8p52

/* sin x and cos x: x = k pi/2 + r (Cody and Waite's reduction by three parts of pi/2), Taylor's series on |r| <= pi/4. */
INLINE void sine_cosine(V x, V *sine, V *cosine)
{
    V k = x * 0x1.45f306dc9c883p-1 + TO_INTEGER;
    const M n = (M)k;
    k -= TO_INTEGER;
    const V r = ((x - k * 0x1.921fb544p+0) - k * 0x1.0b4611a6p-34) - k * 0x1.3198a2e037073p-69, z = r * r;
    V s = broadcast(1 / 355687428096000.0), c = broadcast(1 / 20922789888000.0);
    s = s * z - 1 / 1307674368000.0, c = c * z - 1 / 87178291200.0;
    s = s * z + 1 / 6227020800.0, c = c * z + 1 / 479001600.0;
    s = s * z - 1 / 39916800.0, c = c * z - 1 / 3628800.0;
    s = s * z + 1 / 362880.0, c = c * z + 1 / 40320.0;
    s = s * z - 1 / 5040.0, c = c * z - 1 / 720.0;
    s = s * z + 1 / 120.0, c = c * z + 1 / 24.0;
    s = s * z - 1 / 6.0, c = c * z - 0.5;
    s = r + r * z * s, c = 1.0 + z * c;
    const M odd = -(n & 1);
    *sine = (V)((M)pick(odd, c, s) ^ ((n & 2) << 62));
    *cosine = (V)((M)pick(odd, s, c) ^ (((n + 1) & 2) << 62));
}

/* exp x - 1 and exp x: x = k log 2 + r, Taylor's series on |r| <= log(2)/2. */
INLINE V exponential(V x, V *whole)
{
    const V y = pick(x > 709.5, broadcast(709.5), pick(x < -708.0, broadcast(-708.0), x)); /* NaN stays */
    V k = y * 0x1.71547652b82fep+0 + TO_INTEGER;
    const M n = (M)k;
    k -= TO_INTEGER;
    const V r = (y - k * 0x1.62e42ffp-1) + k * 0x1.718432a1b0e26p-35;
    V p = broadcast(1 / 87178291200.0);
    p = p * r + 1 / 6227020800.0;
    p = p * r + 1 / 479001600.0;
    p = p * r + 1 / 39916800.0;
    p = p * r + 1 / 3628800.0;
    p = p * r + 1 / 362880.0;
    p = p * r + 1 / 40320.0;
    p = p * r + 1 / 5040.0;
    p = p * r + 1 / 720.0;
    p = p * r + 1 / 120.0;
    p = p * r + 1 / 24.0;
    p = p * r + 1 / 6.0;
    p = p * r + 0.5;
    p = r + r * r * p;
    const V power = (V)((n << 52) + INT64_C(0x3ff0000000000000)); /* 2^k: the bits of TO_INTEGER are shifted out */
    const V over = pick(x > 709.5, broadcast(INFINITY), broadcast(0.0));
    *whole = power + power * p + over;
    return power * p + (power - 1.0) + over;
}

/* A function of the C library, lane by lane. */
INLINE V by_lanes(double f(double), V x)
{
    for (int k = 0; k < LANES; k++) x[k] = f(x[k]);
    return x;
}

INLINE V sin_of(V x) { V s, c; sine_cosine(x, &s, &c); return s; }
INLINE V cos_of(V x) { V s, c; sine_cosine(x, &s, &c); return c; }
INLINE V tan_of(V x) { V s, c; sine_cosine(x, &s, &c); return s / c; }
INLINE V exp_of(V x) { V e; exponential(x, &e); return e; }
INLINE V expm1_of(V x) { V e; return exponential(x, &e); }
INLINE V log_of(V x) { return by_lanes(log, x); }
INLINE V log1p_of(V x) { return by_lanes(log1p, x); }
INLINE V sqrt_of(V x) { return by_lanes(sqrt, x); }

/* What the text of the operations calls functions of vectors. */
#define IN(name) vector_##name
#define vector_map(f, x) f##_of(x)
#define vector_choose pick

/* What is added at each k from the first to below another, by turns into parts j = 0 and 1 that do not wait for each
 * other. */
#define OVER(first, below, add) do { int k = first; \
    while (k + 1 < (below)) { { const int j = 0; add; } k++; { const int j = 1; add; } k++; } \
    if (k < (below)) { const int j = 0; add; } } while (0)

/* One operation on series at order n: coefficient n of its results, and where the next operation stands. It is its
 * code, its results, its arguments and the cells of its numbers; a sum is its code, its result, the cell of its
 * constant or -1, how many terms, and the cell and the register of each. What is read off a table is there already.
 * Register i begins at r + i * stride; by_n is 1 / n. */
static inline __attribute__((always_inline)) const int32_t *IN(operate)(const int32_t *at, V *r, const V *c, int stride,
                                                                        int n, double by_n) {
    switch (at[0]) {
    case LIN: {
        V sum = n == 0 && at[2] >= 0 ? c[at[2]] : (V){0};
        const int32_t *const end = at + 4 + 2 * at[3];
        for (const int32_t *term = at + 4; term < end; term += 2)
            sum += c[term[0]] * r[(ptrdiff_t)term[1] * stride + n];
        r[(ptrdiff_t)at[1] * stride + n] = sum;
        return end;
    }
    case RAMP:
        return at + 3;
    case MUL: { /* d = a*b */
        V *restrict d = r + (ptrdiff_t)at[1] * stride;
        const V *a = r + (ptrdiff_t)at[2] * stride;
        const V *b = r + (ptrdiff_t)at[3] * stride;
        if (n == 0) {
            d[0] = a[0] * b[0];
        } else {
            V part0[2] = {{0}};
            OVER(0, n + 1, part0[j] += a[k] * b[n - k]);
            V sum0 = (part0[0] + part0[1]);
            d[n] = sum0;
        }
        return at + 4;
    }
    case SQR: { /* d = a**2 */
        V *restrict d = r + (ptrdiff_t)at[1] * stride;
        const V *a = r + (ptrdiff_t)at[2] * stride;
        if (n == 0) {
            d[0] = a[0] * a[0];
        } else {
            V part0[2] = {{0}};
            OVER(0, (n + 1) / 2, part0[j] += a[k] * a[n - k]);
            V sum0 = 2.0 * (part0[0] + part0[1]);
            if (n % 2 == 0) sum0 += a[n / 2] * a[n / 2];
            d[n] = sum0;
        }
        return at + 3;
    }
    case POWERS: { /* p2 = x**2, p3 = x**3, p4 = x**4, p5 = x**5, p6 = x**6, p7 = x**7 */
        V *restrict p2 = r + (ptrdiff_t)at[1] * stride;
        V *restrict p3 = r + (ptrdiff_t)at[2] * stride;
        V *restrict p4 = r + (ptrdiff_t)at[3] * stride;
        V *restrict p5 = r + (ptrdiff_t)at[4] * stride;
        V *restrict p6 = r + (ptrdiff_t)at[5] * stride;
        V *restrict p7 = r + (ptrdiff_t)at[6] * stride;
        const V *x = r + (ptrdiff_t)at[7] * stride;
        if (n == 0) {
            p2[0] = x[0] * x[0];
            p3[0] = x[0] * x[0] * x[0];
            p4[0] = x[0] * x[0] * x[0] * x[0];
            p5[0] = x[0] * x[0] * x[0] * x[0] * x[0];
            p6[0] = x[0] * x[0] * x[0] * x[0] * x[0] * x[0];
            p7[0] = x[0] * x[0] * x[0] * x[0] * x[0] * x[0] * x[0];
        } else {
            V part0[2] = {{0}}, part1[2] = {{0}}, part2[2] = {{0}}, part3[2] = {{0}}, part4[2] = {{0}}, part5[2] = {{0}};
            OVER(1, n + 1, part0[j] += x[k] * p2[n - k]; part1[j] += x[k] * p3[n - k]; part2[j] += x[k] * p4[n - k]; part3[j] += x[k] * p5[n - k]; part4[j] += x[k] * p6[n - k]; part5[j] += x[k] * x[n - k]);
            V sum0 = (part0[0] + part0[1]);
            V sum1 = (part1[0] + part1[1]);
            V sum2 = (part2[0] + part2[1]);
            V sum3 = (part3[0] + part3[1]);
            V sum4 = (part4[0] + part4[1]);
            V sum5 = (part5[0] + part5[1]);
            p2[n] = (sum5 + x[0] * x[n]);
            p3[n] = (sum0 + p2[n] * x[0]);
            p4[n] = (sum1 + p3[n] * x[0]);
            p5[n] = (sum2 + p4[n] * x[0]);
            p6[n] = (sum3 + p5[n] * x[0]);
            p7[n] = (sum4 + p6[n] * x[0]);
        }
        return at + 8;
    }
    case TIM: { /* q = t*Derivative(a, t) */
        V *restrict q = r + (ptrdiff_t)at[1] * stride;
        const V *a = r + (ptrdiff_t)at[2] * stride;
        if (n == 0) {
            q[0] = (V){0};
        } else {
            q[n] = a[n] * n;
        }
        return at + 3;
    }
    case TURN: { /* s = sin(x), v = 1 - cos(x) */
        V *restrict s = r + (ptrdiff_t)at[1] * stride;
        V *restrict v = r + (ptrdiff_t)at[2] * stride;
        const V *q = r + (ptrdiff_t)at[3] * stride;
        const V *x = r + (ptrdiff_t)at[4] * stride;
        if (n == 0) {
            const V f0 = IN(map)(sin, x[0]);
            const V f1 = IN(map)(sin, 0.5 * x[0]);
            s[0] = f0;
            v[0] = 2.0 * f1 * f1;
        } else {
            V part0[2] = {{0}}, part1[2] = {{0}};
            OVER(1, n + 1, part0[j] += q[k] * s[n - k]; part1[j] += q[k] * v[n - k]);
            V sum0 = (part0[0] + part0[1]);
            V sum1 = (part1[0] + part1[1]);
            s[n] = (q[n] - sum1) * by_n;
            v[n] = sum0 * by_n;
        }
        return at + 5;
    }
    case EXP: { /* e = exp(z), m = exp(z) - 1 */
        V *restrict e = r + (ptrdiff_t)at[1] * stride;
        V *restrict m = r + (ptrdiff_t)at[2] * stride;
        const V *q = r + (ptrdiff_t)at[3] * stride;
        const V *z = r + (ptrdiff_t)at[4] * stride;
        if (n == 0) {
            const V f0 = IN(map)(expm1, z[0]);
            const V f1 = IN(map)(exp, z[0]);
            e[0] = f1;
            m[0] = f0;
        } else {
            V part0[2] = {{0}};
            OVER(1, n + 1, part0[j] += q[k] * e[n - k]);
            V sum0 = (part0[0] + part0[1]);
            e[n] = sum0 * by_n;
            m[n] = e[n];
        }
        return at + 5;
    }
    case REC: { /* h = 1/(z + 1), m = -1 + 1/(z + 1) */
        V *restrict h = r + (ptrdiff_t)at[1] * stride;
        V *restrict m = r + (ptrdiff_t)at[2] * stride;
        const V *z = r + (ptrdiff_t)at[3] * stride;
        if (n == 0) {
            h[0] = 1.0 / (1.0 + z[0]);
            m[0] = -z[0] / (1.0 + z[0]);
        } else {
            V part0[2] = {{0}};
            OVER(1, n + 1, part0[j] += z[k] * h[n - k]);
            V sum0 = (part0[0] + part0[1]);
            h[n] = -sum0 * h[0];
            m[n] = h[n];
        }
        return at + 4;
    }
    case LOG: { /* l = log(z + 1) */
        V *restrict l = r + (ptrdiff_t)at[1] * stride;
        const V *z = r + (ptrdiff_t)at[2] * stride;
        if (n == 0) {
            const V f0 = IN(map)(log1p, z[0]);
            l[0] = f0;
        } else {
            V part0[2] = {{0}};
            OVER(1, n + 0, part0[j] += k * l[k] * z[n - k]);
            V sum0 = (part0[0] + part0[1]);
            l[n] = (z[n] - sum0 * by_n) / (1.0 + z[0]);
        }
        return at + 3;
    }
    case POW: { /* p = (z + 1)**power, m = (z + 1)**power - 1 */
        V *restrict p = r + (ptrdiff_t)at[1] * stride;
        V *restrict m = r + (ptrdiff_t)at[2] * stride;
        const V *z = r + (ptrdiff_t)at[3] * stride;
        const V power = c[at[4]];
        if (n == 0) {
            const V f0 = IN(map)(log1p, z[0]);
            const V f1 = IN(map)(expm1, f0 * power);
            p[0] = (1.0 + f1);
            m[0] = f1;
        } else {
            V part0[2] = {{0}};
            OVER(1, n + 1, part0[j] += (k + k * power - n) * z[k] * p[n - k]);
            V sum0 = (part0[0] + part0[1]);
            p[n] = sum0 / (1.0 + z[0]) * by_n;
            m[n] = p[n];
        }
        return at + 5;
    }
    default:
        __builtin_unreachable();
    }
}

/* The operations on cells of a prologue, to their end, in some of the lanes: each its code, result and arguments. */
static void IN(prologue)(const int32_t *at, const int32_t *end, V *c, M here) {
    while (at < end) {
        const V a = c[at[2]];
        V *const d = c + at[1];
        switch (at[0]) {
        case S_ADD: { const V b = c[at[3]]; *d = IN(choose)(here, a + b, *d); at += 4; break; }
        case S_SUB: { const V b = c[at[3]]; *d = IN(choose)(here, a - b, *d); at += 4; break; }
        case S_MUL: { const V b = c[at[3]]; *d = IN(choose)(here, a * b, *d); at += 4; break; }
        case S_DIV: { const V b = c[at[3]]; *d = IN(choose)(here, a / b, *d); at += 4; break; }
        case S_NEG: { *d = IN(choose)(here, -a, *d); at += 3; break; }
        case S_SIN: { *d = IN(choose)(here, IN(map)(sin, a), *d); at += 3; break; }
        case S_COS: { *d = IN(choose)(here, IN(map)(cos, a), *d); at += 3; break; }
        case S_TAN: { *d = IN(choose)(here, IN(map)(tan, a), *d); at += 3; break; }
        case S_EXP: { *d = IN(choose)(here, IN(map)(exp, a), *d); at += 3; break; }
        case S_EXPM1: { *d = IN(choose)(here, IN(map)(expm1, a), *d); at += 3; break; }
        case S_LOG: { *d = IN(choose)(here, IN(map)(log, a), *d); at += 3; break; }
        case S_LOG1P: { *d = IN(choose)(here, IN(map)(log1p, a), *d); at += 3; break; }
        case S_SQRT: { *d = IN(choose)(here, IN(map)(sqrt, a), *d); at += 3; break; }
        case S_ABS: { *d = IN(choose)(here, IN(choose)(a < 0.0, -a, a), *d); at += 3; break; }
        case S_MIN: { const V b = c[at[3]]; *d = IN(choose)(here, IN(choose)(a < b, a, b), *d); at += 4; break; }
        case S_MAX: { const V b = c[at[3]]; *d = IN(choose)(here, IN(choose)(a < b, b, a), *d); at += 4; break; }
        case S_LESS: { const V b = c[at[3]]; *d = IN(choose)(here, IN(choose)(a < b, (V){0} + 1.0, (V){0}), *d); at += 4; break; }
        case S_SELECT: { const V b = c[at[3]]; const V e = c[at[4]]; *d = IN(choose)(here, IN(choose)(a > 0.0, b, e), *d); at += 5; break; }
        }
    }
}
/* --- polynomials in the time of a step: coefficients p[0] to p[n] --- */

INLINE V value(const V *p, int n, V t)
{
    V sum = p[n];
    for (int k = n - 1; k >= 0; k--) sum = sum * t + p[k];
    return sum;
}

/* Without the constant term, so that a small change keeps its digits. */
INLINE V increment(const V *p, int n, V t) { return n > 0 ? t * value(p + 1, n - 1, t) : broadcast(0.0); }

INLINE V value_and_slope(const V *p, int n, V t, V *slope)
{
    V sum = p[n], s = broadcast(0.0);
    for (int k = n - 1; k >= 0; k--) {
        s = s * t + sum;
        sum = sum * t + p[k];
    }
    *slope = s;
    return sum;
}

/* Newton's method between bounds, of opposite signs: it starts where the chord crosses, and halves where a step leaves
 * the bounds. A step below 2^-30 of its place is the last: the next would be below rounding. */
static V bracketed_root(const V *p, int n, V low, V at_low, V high, V at_high, unsigned which)
{
    const M falls = at_low > 0.0;
    V at = low + (high - low) * (at_low / (at_low - at_high));
    at = pick((at >= low) & (at <= high), at, 0.5 * (low + high));
    for (int count = 0; which && count < 200; count++) {
        V slope;
        const V f = value_and_slope(p, n, at, &slope);
        const M beyond = (f > 0.0) ^ falls;
        low = pick(beyond, low, at), high = pick(beyond, at, high);
        V next = at - f / slope;
        next = pick((next >= low) & (next <= high), next, 0.5 * (low + high));
        next = pick(f == 0.0, at, next);
        const M go = lanes(which);
        which &= bits(magnitude(next - at) > 0x1p-30 * magnitude(next));
        at = pick(go, next, at);
    }
    return at;
}

/* The first zero in (0, h] of polynomials that are positive at first; infinity where there is none, and where `which` lacks a lane. Within a step the terms fall like exp(-2 k): a polynomial that neither has changed its sign at h nor falls
 * at first and rises at last has none. Where it falls and rises, its least value decides. */
static V first_root(const V *p, int n, V h, unsigned which)
{
    V slope, high = h;
    V last = value_and_slope(p, n, h, &slope);
    unsigned crosses = which & bits((last < 0.0) | ((last == 0.0) & (p[0] > 0.0))); /* a polynomial that is zero has no root */
    const unsigned dips = which & ~crosses & bits((p[1] < 0.0) & (slope > 0.0));
    if (dips) {
        V s[HIGHEST + 2];
        for (int k = 1; k <= n; k++) s[k - 1] = p[k] * (double)k;
        const V lowest = bracketed_root(s, n - 1, broadcast(0.0), s[0], h, slope, dips), least = value(p, n, lowest);
        V terms = magnitude(p[n]);
        for (int k = n - 1; k >= 0; k--) terms = terms * h + magnitude(p[k]);
        const unsigned below = dips & bits(least < -4 * EPS * terms); /* a polynomial that only touches zero does not cross it */
        high = pick(lanes(below), lowest, high), last = pick(lanes(below), least, last);
        crosses |= below;
    }
    if (!crosses) return broadcast(INFINITY);
    return pick(lanes(crosses), bracketed_root(p, n, broadcast(0.0), p[0], high, last, crosses), broadcast(INFINITY));
}

/* --- tables --- */

/* Coefficients of a lane's piece, in powers of what is beyond its break, about a place within it: Taylor's shift. */
static void shifted(const Data *d, int64_t piece, int64_t column, double by, double *terms)
{
    const int64_t across = d->across ? d->across : 1;
    const double *from = d->coefficients + piece * d->terms * across + (d->across ? column : 0);
    for (int j = 0; j < d->terms; j++) terms[j] = from[j * across];
    if (by == 0.0) return;
    for (int first = 0; first < d->terms - 1; first++)
        for (int j = d->terms - 2; j >= first; j--) terms[j] += by * terms[j + 1];
}

/* Taylor coefficients of a function of time about now, in t*, up to an order; returns their number. */
static int taylor_about_now(const Batch *b, const Table *t, const Data *d, unsigned k, int order, double *terms)
{
    const V *c = b->c + t->cell;
    const double scale = c[SCALE][k], factor = c[SCALED_BY][k];
    const int64_t piece = (int64_t)c[PIECE][k];
    const double local = b->c[TIME][k] * scale - d->breaks[piece];
    if (d->sine) { /* amplitude, rate, phase */
        double p[HIGHEST + 1];
        shifted(d, piece, b->column[k], 0.0, p);
        const double angle = p[1] * local + p[2], wave[] = {sin(angle), cos(angle), -sin(angle), -cos(angle)};
        double high = p[0] * factor;
        for (int j = 0; j <= order; j++) {
            terms[j] = high * wave[j % 4];
            high *= p[1] * scale / (j + 1);
        }
        return order + 1;
    }
    shifted(d, piece, b->column[k], d->terms > 2 || order < 1 ? local : 0.0, terms);
    if (d->terms == 2 && order >= 1) terms[0] += local * terms[1];
    double power = factor;
    for (int j = 0; j < d->terms; j++, power *= scale) terms[j] *= power;
    return d->terms;
}

/* The end of a lane's piece of a function of time, and the increment there. */
static void find_end_of_piece(const Batch *b, const Table *t, const Data *d, unsigned k)
{
    V *c = b->c + t->cell;
    const int64_t piece = (int64_t)c[PIECE][k];
    double terms[HIGHEST + 1];
    c[UPPER][k] = piece < d->pieces - 1 ? d->breaks[piece + 1] / c[SCALE][k] : INFINITY;
    c[LOWER][k] = c[INC][k];
    if (piece == d->pieces - 1) return;
    const double past = c[UPPER][k] - b->c[TIME][k];
    if (d->sine) { /* A (sin(angle + r) - sin(angle)) = 2 A sin(r/2) cos(angle + r/2) */
        shifted(d, piece, b->column[k], 0.0, terms);
        const double half = 0.5 * terms[1] * past * c[SCALE][k];
        const double angle = terms[1] * (b->c[TIME][k] * c[SCALE][k] - d->breaks[piece]) + terms[2];
        const double rise = 2.0 * c[SCALED_BY][k] * terms[0] * sin(half) * cos(angle + half);
        c[LOWER][k] += rise, c[WAY][k] += fabs(rise);
        return;
    }
    double sum = 0.0;
    for (int j = taylor_about_now(b, t, d, k, 1, terms) - 1; j > 0; j--) sum = (sum + terms[j]) * past;
    c[LOWER][k] += sum, c[WAY][k] += fabs(sum);
}

/* Where a lane's piece begins. */
static double piece_begin(const Data *d, int64_t piece, int64_t column)
{
    return d->breaks[d->apart ? piece * d->apart + column : piece];
}

/* Where a phase begins: each table's piece, its value, and the coefficients of what is beyond. */
static void begin_pieces(Batch *b, unsigned k)
{
    const Job *const job = b->job;
    for (int i = 0; i < job->tables; i++) {
        const Table *const t = job->table + i;
        const Data *const d = job->data + i;
        V *const all = b->c, *const c = all + t->cell;
        const double scale = c[SCALE][k], factor = c[SCALED_BY][k];
        const int64_t last = d->pieces - 1;
        double terms[HIGHEST + 1], local = 0.0, power = 1.0;
        if (t->kind == OF_TIME) {
            const double now = all[TIME][k] * scale * (1.0 + 2 * EPS);
            int64_t piece = (int64_t)c[PIECE][k];
            while (piece < last && d->breaks[piece + 1] <= now) piece++, b->drive_scale[k] = INFINITY; /* it may leap there */
            c[PIECE][k] = (double)piece, c[INC][k] = c[WAY][k] = 0.0;
            taylor_about_now(b, t, d, k, 1, terms);
            c[VALUE][k] = terms[0];
            find_end_of_piece(b, t, d, k);
            continue;
        }
        const double turn = all[ROTATION][k];
        const int up = all[DIRECTION][k] > 0.0;
        int64_t piece = (int64_t)c[PIECE][k];
        if (t->kind == OF_ROTATION) { /* a break belongs to the piece ahead */
            for (piece = 0; piece < last; piece++) {
                const double next = piece_begin(d, piece + 1, b->column[k]);
                if (!(next < turn || (up && next == turn))) break;
            }
            c[PIECE][k] = (double)piece;
        }
        const double edge = piece_begin(d, piece, b->column[k]);
        const double above = piece < last ? piece_begin(d, piece + 1, b->column[k]) : INFINITY;
        if (t->kind == OF_ROTATION) {
            local = turn - edge, power = all[DIRECTION][k];
            c[UPPER][k] = up ? above - turn : piece > 0 ? local : INFINITY;
        } else if (t->kind == OF_SLIP) {
            local = fmax(all[SLIP][k] * scale - edge, 0.0), power = scale;
            c[UPPER][k] = (above - edge - local) / scale;
        } else { /* piece 0 is constant, below the first speed */
            const double speed = all[OMEGA][k] * scale;
            local = piece > 0 && speed > 0.0 ? log(speed / edge) : 0.0;
            c[UPPER][k] = above / scale, c[LOWER][k] = piece > 0 ? edge / scale : 0.0;
        }
        shifted(d, piece, b->column[k], local, terms);
        c[VALUE][k] = factor * terms[0];
        double scaled = factor;
        for (int j = 1; j <= t->degree; j++) {
            scaled *= power;
            c[Q1 + j - 1][k] = j < d->terms ? scaled * terms[j] : 0.0;
        }
    }
}

/* The pieces in which a lane's slip and speed lie, wherever they came from. */
static void find_pieces(const Batch *b, unsigned k)
{
    const Job *const job = b->job;
    V *const c = b->c;
    for (int i = 0; job->sloped && i < job->tables; i++) {
        const Table *const t = job->table + i;
        const Data *const d = job->data + i;
        if (t->kind == OF_TIME || t->kind == OF_ROTATION) continue;
        const double at = c[t->kind == OF_SLIP ? SLIP : OMEGA][k] * c[t->cell + SCALE][k];
        int64_t piece = 0;
        while (piece < d->pieces - 1 && d->breaks[piece + 1] <= at) piece++;
        c[t->cell + PIECE][k] = (double)piece;
    }
}

/* Enter the next piece of each function of time that breaks now; whether a value leaps. */
static int pass_breaks(const Batch *b, unsigned k)
{
    const Job *const job = b->job;
    int leaps = 0;
    for (int i = 0; i < job->tables; i++) {
        const Table *const t = job->table + i;
        const Data *const d = job->data + i;
        V *const c = b->c + t->cell;
        if (t->kind != OF_TIME || !(c[UPPER][k] <= b->c[TIME][k])) continue;
        const int64_t piece = (int64_t)c[PIECE][k] + 1;
        const double jump = d->jumps[piece] * c[SCALED_BY][k];
        c[PIECE][k] = (double)piece, c[INC][k] = c[LOWER][k] + jump, c[WAY][k] += fabs(jump);
        leaps |= jump != 0.0;
        /* Increments add their roundings up, along a record: beyond some way the difference of two values is better. */
        double terms[HIGHEST + 1];
        shifted(d, piece, b->column[k], 0.0, terms);
        const double there = c[SCALED_BY][k] * terms[0] * (d->sine ? sin(terms[2]) : 1.0);
        const double rounding = fabs(there) + fabs(c[VALUE][k]);
        if (c[WAY][k] > rounding) c[INC][k] = there - c[VALUE][k], c[WAY][k] = rounding;
        find_end_of_piece(b, t, d, k);
    }
    return leaps;
}

/* Whether something will still change while a lane rests. */
static int still_changes(const Batch *b, unsigned k)
{
    const Job *const job = b->job;
    int any = 0;
    for (int i = 0; i < job->tables; i++)
        any |= job->table[i].kind == OF_TIME && b->c[job->table[i].cell + UPPER][k] < INFINITY;
    return any;
}

/* The next time at which something breaks. */
INLINE V next_break(const Batch *b)
{
    const Job *const job = b->job;
    V time = broadcast(INFINITY);
    for (int i = 0; i < job->tables; i++)
        if (job->table[i].kind == OF_TIME) time = minimum(b->c[job->table[i].cell + UPPER], time);
    return time;
}

/* --- series --- */

/* Coefficient n of every register that the rates need. */
INLINE void operate(const Batch *b, int n)
{
    const Job *const job = b->job;
    const double per = b->inverse[n];
    for (const int32_t *at = job->series; at < job->series_end;) at = IN(operate)(at, b->r, b->c, 1, n, per);
}

/* Coefficients below n of all others. */
INLINE void operate_later(const Batch *b, int n)
{
    const Job *const job = b->job;
    for (const int32_t *at = job->series_end, *next = at; at < job->later_end; at = next)
        for (int k = 0; k < n; k++) next = IN(operate)(at, b->r, b->c, 1, k, b->inverse[k]);
}

#define REGISTER(i) (b->r + (i))

/* Order 0 of the registers that do not come from operations. */
INLINE void begin_series(const Batch *b)
{
    const Job *const job = b->job;
    for (int i = 0; i < job->states; i++) REGISTER(job->state[3 * i + 1])[0] = b->c[job->state[3 * i]];
    for (int i = 0; i < job->tables; i++)
        if (job->table[i].kind == OF_TIME) REGISTER(job->table[i].reg)[0] = b->c[job->table[i].cell + INC];
}

/* Series of all registers; of the states up to a lane's order, of the others one less. Where a function of time cuts
 * the step short, a lane's series may end before: where two terms following each other do not count at the cut. Returns
 * the highest order, and each lane's; what is beyond is 0. At rest the net moment decides. */
INLINE int expand(const Batch *b, V room, unsigned which, int at_rest, V *order)
{
    const Job *const job = b->job;
    const M here = lanes(which);
    V last = pick(here, b->c[ORDER], broadcast(1.0)), power = broadcast(1.0), small = broadcast(0.0);
    int top = 1, even = 1;
    for (int k = 0; k < LANES; k++) top = last[k] > top ? (int)last[k] : top;
    even = bits(last == (double)top) == (unsigned)ALL;
    begin_series(b);
    for (int i = 0; job->timed && i < job->tables; i++) {
        if (job->table[i].kind != OF_TIME) continue;
        V *const r = REGISTER(job->table[i].reg);
        EACH(k, which) {
            double terms[HIGHEST + 1];
            const int count = taylor_about_now(b, job->table + i, job->data + i, k, top, terms);
            for (int j = 1; j < count && j <= top; j++) r[j][k] = terms[j];
        }
    }
    const int watched[2] = {at_rest ? job->role->net : job->role->x, at_rest ? job->role->net : job->role->omega};
    V most[2] = {broadcast(0.0), broadcast(0.0)};
    const int early = job->timed;
    if (early) for (int i = 0; i < 2; i++) most[i] = at_rest ? broadcast(0.0) : magnitude(REGISTER(watched[i])[0]);
    for (int n = 0; n < top; n++) {
        operate(b, n);
        const double per = b->inverse[n + 1];
        const M within = last > (double)n;
        for (int i = 0; i < job->states; i++) {
            const V d = at_rest ? broadcast(0.0) : REGISTER(job->state[3 * i + 2])[n] * per;
            REGISTER(job->state[3 * i + 1])[n + 1] = even ? d : pick(within, d, broadcast(0.0));
        }
        if (!early) continue;
        V share = broadcast(0.0);
        if (!at_rest) power *= room;
        for (int i = 0; i < 2; i++) {
            const V term = magnitude(REGISTER(watched[i])[at_rest ? n : n + 1]) * power;
            share = pick((term <= 0x1p-56 * most[i]) & (most[i] > 0.0) & (most[i] < INFINITY), share, broadcast(1.0));
            most[i] = maximum(term, most[i]);
        }
        if (at_rest) power *= room;
        small = pick(share == 0.0, small + 1.0, broadcast(0.0));
        const M ends = (small >= 2.0) & within & here;
        if (n < 2 || !bits(ends)) continue;
        last = pick(ends, minimum(last, broadcast(n + 1.0)), last), even = 0;
        if (!bits(last > n + 1.0)) top = n + 1;
    }
    operate_later(b, top);
    if (!even)
        for (int n = 0; n < top; n++) {
            const M within = last > (double)n;
            const int32_t of[] = {job->role->net, job->role->normal, job->role->upright};
            for (int i = 0; i < 3; i++)
                if (of[i] >= 0) REGISTER(of[i])[n] = pick(within, REGISTER(of[i])[n], broadcast(0.0));
        }
    *order = last;
    return top;
}

/* log2 of sizes and its inverse, straight between powers of two: up to 0.09 too small, which the (n - k)th root of the
 * radius below makes a hundredth. Fixed point with 40 bits behind the point, as float64. */
#define FIXED 0x1p40
INLINE V log2_of(V x) { return (V)((M)((M)magnitude(x) >> 12) | (M)broadcast(0x1p52)) - 0x1p52; }
INLINE V power_of_two(V y)
{
    y = pick(y < 1000 * FIXED, y, broadcast(1000 * FIXED)), y = pick(y > -1000 * FIXED, y, broadcast(-1000 * FIXED));
    return (V)((M)(y + (0x1p52 + 1023 * FIXED)) << 12);
}

/* Radius of convergence: the least that the last four coefficients suggest, each against the largest of the first five. */
INLINE V radius_of_convergence(const Batch *b, const V *p, int top, V order)
{
    V first[5], least = broadcast(1000 * FIXED);
    M comparable = {0}; /* where all of the first are zero there is no comparison */
    for (int k = 0; k < 5 && k <= top; k++) first[k] = log2_of(p[k]), comparable |= p[k] != 0.0;
    double low = order[0];
    for (int k = 1; k < LANES; k++) low = order[k] < low ? order[k] : low;
    for (int n = low > 8.0 ? (int)low - 3 : 5; n <= top; n++) {
        const V here = log2_of(p[n]);
        V most = broadcast(-1000 * FIXED);
        for (int k = 0; k < 5; k++) most = maximum((first[k] - here) * b->inverse[n - k], most);
        const M counts = comparable & (order >= (double)n) & (order <= n + 3.0) & (p[n] != 0.0);
        least = pick(counts & (most < least), most, least);
    }
    return power_of_two(least);
}

/* --- phases --- */

/* Record an event of the first lane. */
static void note(const Batch *b, unsigned k, int kind)
{
    Job *const job = b->job;
    if (b->column[k] != 0 || job->noted == job->notes_room) return;
    double *const row = job->notes + 4 * job->noted++;
    row[0] = kind, row[1] = b->c[TIME][k], row[2] = b->c[ROTATION][k], row[3] = b->c[DIRECTION][k];
}

/* A candidate for the greatest speed. */
static void update_peak(const Batch *b, unsigned k, double rate)
{
    V *const c = b->c;
    if (!(c[OMEGA][k] > fabs(c[PEAK_OMEGA][k]))) return;
    c[PEAK_TIME][k] = c[TIME][k], c[PEAK_ROTATION][k] = c[ROTATION][k] + c[DIRECTION][k] * c[X][k];
    c[PEAK_OMEGA][k] = c[DIRECTION][k] * c[OMEGA][k], c[PEAK_RATE][k] = c[DIRECTION][k] * rate;
}

static void update_reach(const Batch *b, unsigned k)
{
    V *const c = b->c;
    const double rotation = c[ROTATION][k] + c[DIRECTION][k] * c[X][k];
    if (fabs(rotation) > fabs(c[REACH_ROTATION][k])) c[REACH_ROTATION][k] = rotation, c[REACH_TIME][k] = c[TIME][k];
}

static void note_lift_off(Batch *b, unsigned k)
{
    V *const c = b->c;
    note(b, k, NOTE_LIFTS);
    if (isnan(c[LIFT_TIME][k])) c[LIFT_TIME][k] = c[TIME][k];
}

/* Count rotation and slip from where the lane is now, where another phase begins. */
static void advance_origin(const Batch *b, unsigned k)
{
    V *const c = b->c;
    c[ROTATION][k] += c[DIRECTION][k] * c[X][k], c[SLIP][k] += c[X][k], c[X][k] = 0.0;
}

/* States at sample times from `begin` up to, and without, `end`; the lane moves along series in r, or rests. */
static void read_samples(const Batch *b, unsigned k, double begin, double end, int moving, int top)
{
    const Job *const job = b->job;
    const V *const c = b->c;
    if (!job->samples || !(end >= begin)) return;
    const int64_t across = job->times_across, column = b->column[k];
    const double *times = job->times + (across > 1 ? column : 0);
    int64_t low = 0, high = job->samples;
    while (low < high) {
        const int64_t middle = (low + high) / 2;
        if (times[middle * across] < begin) low = middle + 1; else high = middle;
    }
    const int closed = end >= c[END_TIME][k] && end < INFINITY;
    const int32_t net = job->role->net;
    for (int64_t i = low; i < job->samples; i++) {
        const double time = times[i * across], past = time - begin;
        if (!(time < end || (closed && time == end))) break;
        double states[4 + MOST_STATES];
        for (int j = -1; j < job->states; j++) { /* the rate of the second state, and the states */
            const int32_t of = j < 0 ? net : job->state[3 * j + 1];
            double sum = 0.0;
            for (int n = moving ? top - (j < 0) : -1; n >= 0; n--) sum = sum * past + REGISTER(of)[n][k];
            states[j < 0 ? 2 : j < 2 ? j : j + 2] = moving || j < 2 ? sum : c[job->state[3 * j]][k];
        }
        states[3] = c[SLIP][k] + states[0], states[0] = c[ROTATION][k] + c[DIRECTION][k] * states[0];
        states[1] *= c[DIRECTION][k], states[2] *= c[DIRECTION][k];
        for (int j = 0; j < job->states + 2; j++) job->outputs[(j * job->samples + i) * job->count + column] = states[j];
    }
}

/* The lane stays where it is, until its end. */
static void stay(const Batch *b, unsigned k, int status)
{
    V *const c = b->c;
    c[STATUS][k] = status;
    c[END_ROTATION][k] = c[ROTATION][k], c[END_OMEGA][k] = c[END_RATE][k] = c[DIRECTION][k] = 0.0;
    if (c[REST_SINCE][k] > c[END_TIME][k]) c[REST_SINCE][k] = c[END_TIME][k]; /* later by rounding at most */
    read_samples(b, k, c[TIME][k], INFINITY, 0, 0);
}

/* Motion begins. */
static void start_moving(Batch *b, unsigned k, double rate)
{
    V *const c = b->c;
    c[STATUS][k] = MOVING, c[PASSED][k] = NOTHING, c[PHASES][k] += 1.0;
    c[TURNS][k] += c[LAST_WAY][k] * c[DIRECTION][k] < 0.0, c[LAST_WAY][k] = c[DIRECTION][k];
    note(b, k, NOTE_BEGINS);
    if (c[LIFTED][k] > 0.0) note_lift_off(b, k);
    update_peak(b, k, rate);
    b->pending[k] = READY;
}

/* Face a direction at a standstill. */
static void face(Batch *b, unsigned k, double side)
{
    V *const c = b->c;
    c[X][k] = c[OMEGA][k] = 0.0, c[DIRECTION][k] = side, c[LIFTED][k] = 0.0;
}

/* Whether a mass at rest may start the way it faces: shaking starts a one-way mass only the way that gravity pulls. */
static int may_start(const Batch *b, unsigned k)
{
    const V *const c = b->c;
    if (c[ONE_WAY][k] == 0.0) return 1;
    const double pull = c[b->job->role->driving_moment][k];
    return pull > 0.0 || (pull == 0.0 && c[DIRECTION][k] > 0.0);
}

/* Nothing moves it now: it waits for another time, or stays. */
static void stick(Batch *b, unsigned k)
{
    V *const c = b->c;
    b->pending[k] = READY;
    if (!still_changes(b, k)) {
        stay(b, k, ARRESTED);
        return;
    }
    c[STATUS][k] = RESTING;
    if (c[LIFTED][k] > 0.0) note_lift_off(b, k);
    if (!may_start(b, k)) c[DIRECTION][k] = -c[DIRECTION][k], b->pending[k] = BEGIN_PHASE;
}

/* Whether a mass swings on for ever: at its lowest next to nothing presses on it, and that will not change. */
static int never_rests(const Batch *b, unsigned k)
{
    const V *const c = b->c;
    const Roles *const role = b->job->role;
    const double p0 = c[role->normal_load][k], most = hypot(p0, c[role->normal_load_slope][k]);
    return c[FIRST_ONLY][k] == 1.0 || (!still_changes(b, k) && c[role->normal0][k] + (most - p0) <= CARRIED * most);
}

/* Normal force on the slip surface now, once order 0 of the series is computed. */
INLINE double contact(const Batch *b, unsigned k)
{
    const Roles *const role = b->job->role;
    return role->normal < 0 ? b->c[role->normal0][k] : REGISTER(role->normal)[0][k];
}

/* Begin the phases that lanes wait for and decide what follows, until every lane is ready for a step. */
static void begin_phases(Batch *b)
{
    Job *const job = b->job;
    V *const c = b->c;
    const Roles *const role = job->role;
    for (;;) {
        unsigned which = 0, series = 0;
        for (unsigned k = 0; k < LANES; k++) {
            if (b->pending[k] == DISCONTINUITY) { /* forces have leapt: decide contact again */
                begin_series(b), operate(b, 0), operate_later(b, 1);
                const int lifted = contact(b, k) < 0.0;
                if (lifted && c[LIFTED][k] == 0.0) note_lift_off(b, k);
                b->pending[k] = (c[LIFTED][k] > 0.0) == lifted ? READY : BEGIN_PHASE;
                c[LIFTED][k] = lifted;
                if (b->pending[k] == BEGIN_PHASE) advance_origin(b, k);
            }
            if (b->pending[k] == READY) continue;
            which |= 1u << k;
            if (b->pending[k] == START_MOVING || b->pending[k] == ENTER_PHASE) series = 1;
        }
        if (!which) return;
        if (job->tables) EACH(k, which) begin_pieces(b, k);
        IN(prologue)(job->scalar, job->scalar_end, c, lanes(which));
        if (series) begin_series(b), operate(b, 0), operate_later(b, 1);
        EACH(k, which) {
            const double net = REGISTER(role->net)[0][k];
            if (b->pending[k] == START_MOVING || b->pending[k] == RESOLVE || b->pending[k] == START_AGAIN) {
                const int of_velocity = b->pending[k] == START_MOVING;
                const int free = of_velocity ? contact(b, k) < 0.0 : c[role->normal0][k] <= 0.0;
                if (free && c[LIFTED][k] == 0.0) {
                    c[LIFTED][k] = 1.0;
                    continue;
                }
                if (of_velocity) {
                    start_moving(b, k, net);
                    continue;
                }
            }
            double *const drive = (double *)&c[role->drive] + k, *const scale = (double *)&c[role->drive_scale] + k;
            if (b->pending[k] == START_AGAIN) {
                if (!b->sudden[k]) *drive = 0.0;
                start_moving(b, k, *drive);
            } else if (b->pending[k] == ENTER_PHASE) { /* the drive is fresh or carried over, whichever is known better */
                const double carried = b->drive_scale[k] + EPS * (fabs(b->rate[k]) + fabs(net - *drive) + fabs(b->drive[k]));
                if (carried < *scale) *drive += b->rate[k] - net, *scale = carried;
                b->pending[k] = READY;
            } else if (b->pending[k] == RESOLVE) {
                if (c[FIRST_ONLY][k] > 0.0 && c[PHASES][k] > 0.0 && never_rests(b, k)) {
                    stay(b, k, STOPPED), b->pending[k] = READY;
                    continue;
                }
                const int may = may_start(b, k);
                const double terms = fabs(c[role->driving][k]) + c[role->resisting][k];
                const double unsure = EPS * (terms + c[role->mu][k] * fabs(c[role->normal0][k]));
                if (may) c[CLOSE][k] = fmin(c[CLOSE][k], fabs(*drive) / fmax(unsure, 1e-300));
                if (may && *drive > 0.0) start_moving(b, k, *drive);
                else if (++b->faced[k] > 1 || (may && c[ONE_WAY][k] > 0.0)) stick(b, k);
                else face(b, k, -c[DIRECTION][k]);
            } else b->pending[k] = READY;
        }
    }
}

/* --- motion --- */

/* A lane enters another piece of a table, is lifted or lands: another phase begins. */
static void enter_phase(Batch *b, unsigned k, double rate)
{
    const V *const c = b->c;
    b->rate[k] = rate, b->drive[k] = c[b->job->role->drive][k], b->drive_scale[k] = c[b->job->role->drive_scale][k];
    advance_origin(b, k);
    b->pending[k] = ENTER_PHASE;
}

/* A lane comes to its standstill. It does not go on the way it came, whatever its rounding. */
static void on_standstill(Batch *b, unsigned k)
{
    V *const c = b->c;
    advance_origin(b, k);
    update_reach(b, k);
    c[REST_SINCE][k] = c[TIME][k];
    note(b, k, NOTE_STANDS);
    b->faced[k] = 1;
    face(b, k, -c[DIRECTION][k]);
    b->pending[k] = RESOLVE;
}

/* The end time, or an upright chord, while the lane moves. */
static void end_motion(Batch *b, unsigned k, double rate, int status)
{
    V *const c = b->c;
    c[STATUS][k] = status;
    c[END_ROTATION][k] = c[ROTATION][k] + c[DIRECTION][k] * c[X][k];
    c[END_OMEGA][k] = c[DIRECTION][k] * c[OMEGA][k], c[END_RATE][k] = c[DIRECTION][k] * rate;
    update_reach(b, k);
}

/* An edge of a table of slip, speed or rotation is passed. */
static void on_breakpoint(Batch *b, unsigned k, int event, double rate)
{
    Job *const job = b->job;
    const Table *const t = job->table + (event - EVENT_BREAKPOINT) / 2;
    const Data *const d = job->data + (event - EVENT_BREAKPOINT) / 2;
    V *const all = b->c, *const c = all + t->cell;
    const int up = (event - EVENT_BREAKPOINT) % 2 == 0;
    enter_phase(b, k, rate);
    if (t->kind == OF_SPEED) all[OMEGA][k] = c[up ? UPPER : LOWER][k], all[PASSED][k] = up ? FASTER : SLOWER;
    if (t->kind == OF_ROTATION) {
        all[ROTATION][k] = piece_begin(d, (int64_t)c[PIECE][k] + (all[DIRECTION][k] > 0.0), b->column[k]);
        return;
    }
    c[PIECE][k] += up ? 1.0 : -1.0;
    if (t->kind == OF_SLIP) all[SLIP][k] = d->breaks[(int64_t)c[PIECE][k]] / c[SCALE][k];
    if (d->open && up && c[PIECE][k] == (double)(d->pieces - 1)) all[STATUS][k] = NEED, b->pending[k] = READY;
}

/* Coefficients of an event's function: with a sign and another constant term, and one order less where its root is now. */
INLINE void event_function(V *e, const V *p, int n, V sign, V constant, M divided)
{
    for (int k = 0; k <= n; k++) e[k] = sign * p[k];
    e[0] += constant;
    if (!bits(divided)) return;
    for (int k = 0; k < n; k++) e[k] = pick(divided, e[k + 1], e[k]);
    e[n] = pick(divided, broadcast(0.0), e[n]);
}

/* Whether a function may have a zero in (0, tau]: from its value and slope there. */
INLINE unsigned may_cross(const V *p, int n, V tau, V sign, V constant, M divided)
{
    V slope, last = value_and_slope(p, n, tau, &slope);
    last = sign * last + constant;
    return bits((last <= 0.0) | ((sign * p[1] < 0.0) & (sign * slope > 0.0)) | divided);
}

/* One step of lanes that move, up to their next event. */
static void step(Batch *b, unsigned which)
{
    Job *const job = b->job;
    V *const c = b->c;
    const Roles *const role = job->role;
    const M here = lanes(which), no = lanes(0);
    const V limit = minimum(next_break(b), c[END_TIME]), room = limit - c[TIME], one = broadcast(1.0), zero = broadcast(0.0);
    V order, e[HIGHEST + 2], slope;
    const int top = expand(b, room, which, 0, &order);
    const V *const x = REGISTER(role->x), *const omega = REGISTER(role->omega), *const net = REGISTER(role->net);
    V tau = radius_of_convergence(b, x, top, order);
    for (int i = 1; i < job->states; i++) tau = minimum(radius_of_convergence(b, REGISTER(job->state[3 * i + 1]), top, order), tau);
    tau = pick(order < c[ORDER], room, minimum(c[FACTOR] * tau, room));
    const M whole = tau >= room;
    int event[LANES];
    for (int k = 0; k < LANES; k++) event[k] = EVENT_NONE;
#define CONSIDER(time, code) \
    do { \
        const V at_ = (time); \
        EACH(k, bits(at_ <= tau)) event[k] = (code); \
        tau = minimum(at_, tau); \
    } while (0)

    /* Standstill. From rest its first root is now: divided by the time as often as it is zero. */
    V last = value_and_slope(omega, top, tau, &slope);
    const M from_rest = omega[0] == 0.0, back = from_rest & ((net[0] < 0.0) | ((net[0] == 0.0) & (net[1] <= 0.0)));
    unsigned ask = which & bits((last <= 0.0) | ((net[0] < 0.0) & (slope > 0.0)) | back);
    if (ask) {
        event_function(e, omega, top, one, zero, from_rest);
        for (int i = 0; i < 2; i++) event_function(e, e, top, one, zero, from_rest & (e[0] == 0.0));
        const V at = first_root(e, top, tau, ask);
        const M nothing = from_rest & (e[0] == 0.0) & (last == 0.0); /* its drive vanishes to rounding */
        CONSIDER(pick(lanes(ask) & ((e[0] < 0.0) | nothing), zero, at), EVENT_STANDSTILL);
    }
    if (role->upright >= 0) {
        const V *const upright = REGISTER(role->upright);
        if ((ask = which & may_cross(upright, top - 1, tau, one, zero, no)))
            CONSIDER(first_root(upright, top - 1, tau, ask), EVENT_CHORD_UPRIGHT);
    }
    for (int i = 0; job->sloped && i < job->tables; i++) {
        const Table *const t = job->table + i;
        if (t->kind == OF_TIME) continue;
        const V *const p = t->kind == OF_SPEED ? omega : x;
        const V upper = minimum(c[t->cell + UPPER], broadcast(1e300)), lower = c[t->cell + LOWER];
        if (i && t->kind == OF_ROTATION && t[-1].kind == OF_ROTATION && !(which & bits(upper != c[t[-1].cell + UPPER])))
            continue; /* its pieces end with those of the table before */
        const M slower = t->kind == OF_SPEED ? c[PASSED] == (double)SLOWER : no;
        if ((ask = which & may_cross(p, top, tau, -one, upper, slower))) {
            event_function(e, p, top, -one, upper, slower);
            CONSIDER(first_root(e, top, tau, ask), EVENT_BREAKPOINT + 2 * i);
        }
        if (t->kind != OF_SPEED) continue;
        const M faster = c[PASSED] == (double)FASTER;
        if ((ask = which & bits(lower > 0.0) & may_cross(p, top, tau, one, -lower, faster))) {
            event_function(e, p, top, one, -lower, faster);
            CONSIDER(first_root(e, top, tau, ask), EVENT_BREAKPOINT + 2 * i + 1);
        }
    }
    /* Water over a mass may change faster than its motion, for which the step was chosen: the normal force is a
       function of the position until the first other event only, and may pass zero twice beyond it. */
    if (role->normal >= 0) {
        const V *const normal = REGISTER(role->normal), sign = pick(c[LIFTED] > 0.0, -one, one);
        const M passed = c[PASSED] == (double)LIFT;
        if ((ask = which & may_cross(normal, top - 1, tau, sign, zero, passed))) {
            event_function(e, normal, top - 1, sign, zero, passed);
            CONSIDER(first_root(e, top - 1, tau, ask), EVENT_LIFT_OFF);
        }
    }

    /* A motion that nothing will end: where the rate depends on the speed alone, it never falls below zero again. */
    unsigned endless = 0;
    if (job->autonomous) {
        endless = which & bits((net[0] * tau >= -SETTLED * omega[0]) & (room == INFINITY) & (c[LIFTED] == 0.0));
        EACH(k, endless) if (event[k] != EVENT_NONE) endless &= ~(1u << k);
        tau = pick(lanes(endless), zero, tau);
    }

    /* Peak: the net moment falls through zero. It may do so beyond a trough, too. */
    const V rate = value_and_slope(net, top - 1, tau, &slope);
    const M touches = net[0] == 0.0, drives = (net[0] > 0.0) | (touches & (net[1] > 0.0));
    V peak = broadcast(INFINITY);
    if ((ask = which & bits(drives & ((rate < 0.0) | ((net[1] < 0.0) & (slope > 0.0)))))) {
        event_function(e, net, top - 1, one, zero, touches);
        peak = first_root(e, top - 1, tau, ask);
    }
    if ((ask = which & bits((net[0] < 0.0) & (net[1] > 0.0) & (rate < 0.0) & (slope < 0.0)))) {
        for (int k = 1; k < top; k++) e[k - 1] = net[k] * (double)k;
        const V most = bracketed_root(e, top - 2, zero, e[0], tau, slope, ask), then = value(net, top - 1, most);
        ask &= bits(then > 0.0);
        if (ask) peak = pick(lanes(ask), bracketed_root(net, top - 1, most, then, tau, rate, ask), peak);
    }
#define CANDIDATE(mask, speed, time, gone, slope_) \
    do { \
        const V speed_ = (speed); \
        const M better_ = (mask) & (speed_ > magnitude(c[PEAK_OMEGA])); \
        if (!bits(better_)) break; \
        c[PEAK_OMEGA] = pick(better_, c[DIRECTION] * speed_, c[PEAK_OMEGA]); \
        c[PEAK_TIME] = pick(better_, (time), c[PEAK_TIME]); \
        c[PEAK_ROTATION] = pick(better_, c[ROTATION] + c[DIRECTION] * (gone), c[PEAK_ROTATION]); \
        c[PEAK_RATE] = pick(better_, c[DIRECTION] * (slope_), c[PEAK_RATE]); \
    } while (0)
    const M peaks = peak < INFINITY;
    if (bits(peaks)) CANDIDATE(peaks, value(omega, top, peak), c[TIME] + peak, value(x, top, peak), value(net, top - 1, peak));

    const M to_limit = whole & ~lanes(endless);
    const V until = pick(to_limit, limit, c[TIME] + tau);
    unsigned at_limit = bits(to_limit) & which;
    V until_[1] = {until}; /* in memory, for lanes */
    EACH(k, which) if (event[k] != EVENT_NONE) at_limit &= ~(1u << k), until_[0][k] = c[TIME][k] + tau[k];
    if (job->samples) EACH(k, which) read_samples(b, k, c[TIME][k], until_[0][k], 1, top);
    for (int i = 0; i < job->states; i++) {
        V *const cell = c + job->state[3 * i];
        *cell = pick(here, *cell + increment(REGISTER(job->state[3 * i + 1]), top, tau), *cell);
    }
    for (int i = 0; job->timed && i < job->tables; i++) {
        V *const inc = c + job->table[i].cell + INC;
        if (job->table[i].kind == OF_TIME) *inc = pick(here, *inc + increment(REGISTER(job->table[i].reg), top, tau), *inc);
    }
    c[TIME] = pick(here, until_[0], c[TIME]);
    unsigned eventful = 0;
    EACH(k, which) eventful |= (unsigned)(event[k] != EVENT_NONE) << k;
    const M stiff = (magnitude(net[0]) * tau < STIFF_CHANGE * omega[0]) & ~lanes(eventful);
    c[STEPS] += pick(here & ~lanes(at_limit), pick(stiff, broadcast(STIFF_STEP), one), zero);
    c[PASSED] = pick(here, zero, c[PASSED]);
    CANDIDATE(here, c[OMEGA], c[TIME], c[X], rate);
    EACH(k, which) {
        if (event[k] == EVENT_NONE) {
            if (endless >> k & 1) c[STATUS][k] = TOO_LONG;
            if (!(at_limit >> k & 1)) continue;
            if (c[TIME][k] >= c[END_TIME][k]) end_motion(b, k, rate[k], ENDED);
            else if (pass_breaks(b, k)) b->pending[k] = DISCONTINUITY;
        } else if (event[k] == EVENT_STANDSTILL) on_standstill(b, k);
        else if (event[k] == EVENT_LIFT_OFF) {
            c[LIFTED][k] = 1.0 - c[LIFTED][k];
            if (c[LIFTED][k] > 0.0) note_lift_off(b, k);
            else note(b, k, NOTE_LANDS);
            enter_phase(b, k, rate[k]);
            c[PASSED][k] = LIFT;
        } else if (event[k] == EVENT_CHORD_UPRIGHT) end_motion(b, k, rate[k], UPRIGHT);
        else on_breakpoint(b, k, event[k], rate[k]);
    }
}

/* --- rest --- */

/* One step of lanes at rest under forces that change: to the next break, or to where the mass starts. The net
 * moment at rest is a series of time alone; at its root motion begins, with no drive at all. */
static void wait(Batch *b, unsigned which)
{
    Job *const job = b->job;
    V *const c = b->c;
    const Roles *const role = job->role;
    const V zero = broadcast(0.0), one = broadcast(1.0), limit = next_break(b);
    const V room = pick(limit < INFINITY, limit - c[TIME], one);
    V length = room, start_time = broadcast(INFINITY), direction = zero, e[HIGHEST + 2], order;
    V lift_time = start_time;
    M sudden = lanes(0);
    for (int pass = 0; pass < 2; pass++) {
        const unsigned now = pass ? which & bits(c[ONE_WAY] == 0.0) : which;
        if (!now) break;
        if (pass) {
            EACH(k, now) c[DIRECTION][k] = -c[DIRECTION][k], b->pending[k] = BEGIN_PHASE;
            begin_phases(b);
        }
        const int top = expand(b, room, now, 1, &order);
        const V *const net = REGISTER(role->net);
        const M here = lanes(now), touches = magnitude(net[0]) <= 2.0 * c[role->drive_scale], leaps = ~touches & (net[0] > 0.0);
        const V reach = pick(order < c[ORDER], room, minimum(c[FACTOR] * radius_of_convergence(b, net, top - 1, order - 1.0), room));
        length = pick(here, minimum(reach, length), length);
        event_function(e, net, top - 1, -one, zero, touches);
        unsigned ask = now & bits(~leaps) & may_cross(net, top - 1, length, -one, zero, touches);
        V at = ask ? first_root(e, top - 1, length, ask) : broadcast(INFINITY);
        at = pick(leaps | (touches & (e[0] < 0.0)), zero, at);
        const M sooner = here & (at < start_time);
        start_time = pick(sooner, at, start_time), direction = pick(sooner, c[DIRECTION], direction), sudden = (sooner & leaps) | (~sooner & sudden);
        if (role->normal < 0) continue;
        const V *const normal = REGISTER(role->normal), sign = pick(c[LIFTED] > 0.0, -one, one);
        const M passed = c[PASSED] == (double)LIFT;
        ask = now & may_cross(normal, top - 1, length, sign, zero, passed);
        if (!ask) continue;
        event_function(e, normal, top - 1, sign, zero, passed);
        at = first_root(e, top - 1, length, ask);
        lift_time = pick(here, minimum(at, lift_time), lift_time), length = pick(here, minimum(at, length), length);
    }
    for (int i = 0; i < job->tables; i++) { /* the same for both directions, as of the one begun last */
        V *const inc = c + job->table[i].cell + INC;
        if (job->table[i].kind == OF_TIME)
            *inc = pick(lanes(which), *inc + increment(REGISTER(job->table[i].reg), job->order, length), *inc);
    }
    EACH(k, which) {
        /* Where both pass zero contact is lost and the mass does not start. */
        const int lifts = lift_time[k] <= length[k] && lift_time[k] <= start_time[k] * (1.0 + 1e-9);
        const int starts = !lifts && start_time[k] <= length[k];
        const int at_break = !starts && !lifts && length[k] >= room[k];
        const double until = starts ? c[TIME][k] + start_time[k] : at_break ? limit[k] : c[TIME][k] + length[k];
        const int over = !starts && !(until < INFINITY);
        if (job->samples) read_samples(b, k, c[TIME][k], fmin(until, c[END_TIME][k]), 0, 0);
        c[STEPS][k] += !at_break, c[PASSED][k] = NOTHING;
        if (over || until >= c[END_TIME][k]) { /* what happens after its end time decides nothing */
            if (!over) c[TIME][k] = c[END_TIME][k];
            stay(b, k, over ? ARRESTED : PAUSED);
            continue;
        }
        c[TIME][k] = until;
        if (starts) face(b, k, direction[k]), b->pending[k] = START_AGAIN, b->sudden[k] = sudden[k] != 0;
        else if (lifts) {
            c[LIFTED][k] = 1.0 - c[LIFTED][k], c[PASSED][k] = LIFT, b->pending[k] = BEGIN_PHASE;
            if (c[LIFTED][k] > 0.0) note_lift_off(b, k);
        } else if (at_break && pass_breaks(b, k)) b->pending[k] = DISCONTINUITY;
    }
}

/* --- the queue --- */

/* A lane at its start has no numbers of a phase yet. */
static void load_lane(Batch *b, unsigned k, int64_t column)
{
    const Job *const job = b->job;
    V *const c = b->c;
    const double *from = job->all + column;
    const int count = from[STATUS * job->count] == START ? job->made : job->cells;
    for (int i = 0; i < count; i++, from += job->count) c[i][k] = *from;
    b->column[k] = column, b->held |= 1u << k, b->faced[k] = 0;
    if (c[STATUS][k] == START) {
        c[DIRECTION][k] = c[OMEGA][k] < 0.0 ? -1.0 : 1.0;
        c[OMEGA][k] = fabs(c[OMEGA][k]), c[X][k] = 0.0, c[LIFTED][k] = 0.0;
        b->pending[k] = c[OMEGA][k] > 0.0 ? START_MOVING : RESOLVE;
        find_pieces(b, k);
    }
}

/* Of a lane that has ended only the first cells are read. */
static void store_lane(Batch *b, unsigned k)
{
    const Job *const job = b->job;
    const double status = b->c[STATUS][k];
    const int on = status <= RESTING || status == TOO_LONG;
    const int count = on ? job->cells : OMEGA - 1 + job->states;
    double *to = job->all + b->column[k];
    for (int i = 0; i < count; i++, to += job->count) *to = b->c[i][k];
    b->held &= ~(1u << k);
}

/* Whether a lane is still to be integrated. */
static int is_active(const Job *job, int64_t column)
{
    return job->all[STATUS * job->count + column] <= RESTING;
}

/* Registers where lanes are; with a budget those of the phases that would begin there. */
static void read_registers(Batch *b)
{
    Job *const job = b->job;
    for (int64_t first = job->begin; first < job->end; first += LANES) {
        const int64_t count = job->end - first < LANES ? job->end - first : LANES;
        for (int64_t k = 0; k < count; k++) {
            for (int i = 0; i < job->cells; i++) b->c[i][k] = job->all[i * job->count + first + k];
            b->column[k] = first + k;
            if (job->budget) b->c[X][k] = 0.0, find_pieces(b, k), begin_pieces(b, k);
        }
        if (job->budget) IN(prologue)(job->scalar, job->scalar_end, b->c, lanes(ALL));
        begin_series(b), operate(b, 0), operate_later(b, 1);
        for (int64_t k = 0; k < count; k++) {
            for (int i = 0; job->budget && i < job->cells; i++) job->all[i * job->count + first + k] = b->c[i][k];
            for (int i = 0; i < job->registers; i++) job->outputs[i * job->count + first + k] = REGISTER(i * STRIDE)[0][k];
        }
    }
}

/* Where `least` lanes are free the next of the queue take them. */
enum { LEAST_FREE = LANES / 2 };

int64_t NAMED(flow_integrate, LEVEL)(Job *job);
int64_t NAMED(flow_integrate, LEVEL)(Job *job)
{
    Batch batch = {.job = job, .c = job->memory, .r = (V *)job->memory + job->cells}, *const b = &batch;
    V *const c = b->c;
    int64_t next = job->begin;
    for (int n = 1; n < HIGHEST + 2; n++) b->inverse[n] = 1.0 / n;
    if (job->outputs && !job->times) {
        read_registers(b);
        return 0;
    }
    for (int i = job->made; i < job->cells; i++) c[i] = broadcast(job->all[i * job->count]);
    for (int64_t round = 0;; round++) {
        if (round < job->budget && __builtin_popcount(b->held) <= LANES - LEAST_FREE)
            EACH(k, ~b->held & ALL) {
                while (next < job->end && !is_active(job, next)) next++;
                if (next == job->end) break;
                load_lane(b, k, next++);
            }
        begin_phases(b);
        unsigned moving = b->held & bits(c[STATUS] == (double)MOVING);
        const unsigned resting = b->held & bits(c[STATUS] == (double)RESTING);
        if (round >= job->budget || !b->held || (job->notes_room && job->notes_room - job->noted < LANES)) break;
        if (moving) step(b, moving);
        if (resting) wait(b, resting);
        if (moving | resting) begin_phases(b);
        const V sum = c[TIME] + c[X] + c[OMEGA] + c[ROTATION];
        const M going = c[STATUS] <= (double)RESTING;
        const M turns = job->timed ? lanes(0) : c[TURNS] > (double)MOST_TURNS;
        const M many = c[STEPS] > pick(c[OMEGA] > 0.0, broadcast(MOST_STEPS), broadcast(2.0 * MOST_STEPS)); /* at rest it can wait */
        c[STATUS] = pick(going & (many | turns), broadcast(TOO_LONG), c[STATUS]);
        c[STATUS] = pick(going & ~(sum - sum == 0.0), broadcast(FAILED), c[STATUS]);
        EACH(k, b->held & ~bits(c[STATUS] <= (double)RESTING)) store_lane(b, k);
    }
    int64_t left = 0;
    EACH(k, b->held) store_lane(b, k), left++;
    return left + (job->end - next);
}
#endif
