/* Written by `python -m derive` with SymPy 1.14.0; do not edit. */
#define DIGEST "62499e5f9b0abaec2ebdd128437aa5a170e140194230cbecec0b08478a1f680c"
/* The integrator of lanes along their Taylor series.
 *
 * A lane is one motion: a column of numbers ("cells"), with what its scene gives, the state of its motion, and results.
 * A program (`slipcircle.core.program.program`) says how the series of the motion follow from them. Lanes are integrated
 * side by side in vectors, as many as the processor takes, each with its own step, phase and piece of every table; one
 * that has ended makes room for the next in the queue. No operation mixes lanes, so that the bits of a lane depend
 * neither on its neighbours nor on its place. The whole state of a lane is in its cells: integration may be interrupted
 * after any step and resumed.
 *
 * How a lane is integrated is written once, in `derive/flow/integrator`, for this file and for `integrator.py`, the same in NumPy.
 * This file is compiled once for every kind of processor (with LEVEL, its name), and once more for the module, which
 * runs the best of those that the machine has; for a browser it is one module of WebAssembly. */
#define PY_SSIZE_T_CLEAN
#if !defined(__GNUC__)
#error "the integrator needs the vectors of GCC or Clang"
#endif
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "unsafe float flags: compile without -ffast-math and its parts"
#endif
#include <stddef.h>
#include <stdint.h>

enum { HIGHEST = 40, STRIDE = 42, CELLS = 33, RESULTS = 20, PARTS = 9, REGISTER_ROLES = 6, CELL = -2, MOST_TABLES = 16, MOST_STATES = 16, MOST_WORKING = 24 };

typedef struct { int32_t kind, reg, cell, degree; } Table;
typedef struct { int32_t cell, series, rate; } State;
typedef struct { int lanes, straight; } Traits; /* of a level: lanes of a vector, whether it has straight-line programs */
typedef struct {
    const double *breaks, *coefficients, *jumps; /* (pieces[, lanes]), (pieces, terms[, lanes]), (pieces) */
    int64_t pieces, across, apart; /* lanes of the coefficients and of the breaks, or 0 where lanes share them */
    int terms, sine, open;
} Data;
/* Registers, by where they begin, and cells that the prologue fills; -1 where the program has none. */
typedef struct {
    int32_t x, omega, net, normal, upright, square, drive, drive_scale, normal0, driving_moment, normal_load, normal_load_slope, driving_moment_slope, driving, resisting, mu, pace, net_sine, net_vers, net_square, normal_sine, normal_vers, normal_square, upright_sine, upright_vers, net_loss, net_loss_sine, net_loss_vers, net_loss_square, loss_rate, per_pole, net_record, net_record_sine, net_record_vers, normal_record, normal_record_sine, normal_record_vers;
} Roles;

typedef struct {
    /* Of the program: cells, of which those from `made` on come from the prologue or are alike in all lanes; registers,
     * states, tables, those of time; 1 where its rate depends on the speed alone, 2 where on time alone; 1 where series in
     * powers of the rotation exist, 2 where the first operation is the square of omega. */
    int cells, made, registers, states, tables, timed, autonomous, by_rotation;
    const int32_t *scalar, *scalar_end, *series, *series_end, *later_end; /* after `series` what no rate needs */
    const State *state;
    const Table *table;
    const Roles *role;
    Data data[MOST_TABLES];
    double *all; /* cells of all lanes, (cells, count); those from `begin` to `end` are integrated */
    const double *shared; /* cells with which every lane starts; not a number where lanes have their own in `all` */
    int64_t count, begin, end, budget;
    const double *times; /* where states are read off: (samples, times_across), into (outputs, samples, count) */
    double *outputs; /* without times for the registers of lanes that are not integrated: (registers, count) */
    int64_t samples, times_across;
    double *notes; /* events of the first lane: kind, time, rotation, direction */
    int64_t noted, notes_room;
    void *memory; /* for the lanes of a batch: MOST_WORKING vectors, one for each cell, STRIDE for each register */
    void *begun; /* vectors and integers of lanes that begin side by side, or NULL; see `find_begun` */
    int order; /* the highest of the lanes */
    int straight; /* which of `patterns` the program is, or -1 */
} Job;

enum { LIN, MUL, SQR, POWERS, TIM, TURN, EXP, REC, LOG };
enum { S_ADD, S_SUB, S_MUL, S_DIV, S_NEG, S_SIN, S_COS, S_TAN, S_EXP, S_EXPM1, S_LOG, S_LOG1P, S_SQRT, S_ABS, S_MIN, S_MAX, S_LESS, S_SELECT };
/* How many cells an operation on cells reads. */
static const unsigned char arguments[] = { 2, 2, 2, 2, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 2, 2, 2, 3 };
#if !defined(LEVEL) || defined(__wasm__)
#ifndef __wasm__
/* Programs with functions of their own: their operations on series and their states, CELL where any cell may be, and where
 * the operations that rates need, all operations, and the states end. */
static const struct { int rates, later, length; const int32_t *operations; } patterns[] = {
    {43, 75, 81, (const int32_t[]){2, 462, 42, 4, 84, 0, 5, 126, 168, 84, 0, 3, 210, 252, 294, 336, 378, 420, 0, 0, 10, 504, 0, 126, 168, 210, 252, 294, 336, 378, 420, 462, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, 0, 10, 546, 0, 126, 168, 210, 252, 294, 336, 378, 420, 462, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, 0, 2, 588, 126, 168, CELL, CELL, CELL, CELL, 0, 42, CELL, 42, 504}},
    {35, 59, 65, (const int32_t[]){2, 336, 42, 4, 126, 0, 5, 168, 210, 126, 0, 1, 252, 84, 168, 1, 294, 84, 210, 0, 6, 378, 84, 168, 210, 252, 294, 336, CELL, CELL, CELL, CELL, CELL, CELL, CELL, 0, 6, 420, 84, 168, 210, 252, 294, 336, CELL, CELL, CELL, CELL, CELL, CELL, CELL, 0, 2, 462, 168, 210, CELL, CELL, CELL, CELL, 0, 42, CELL, 42, 378}},
    {49, 79, 85, (const int32_t[]){2, 462, 42, 4, 168, 0, 5, 210, 252, 168, 0, 1, 294, 84, 210, 1, 336, 84, 252, 1, 378, 126, 210, 1, 420, 126, 252, 0, 9, 504, 84, 126, 210, 252, 294, 336, 378, 420, 462, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, 0, 9, 546, 84, 126, 210, 252, 294, 336, 378, 420, 462, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, 0, 2, 588, 210, 252, CELL, CELL, CELL, CELL, 0, 42, CELL, 42, 504}},
    {59, 73, 79, (const int32_t[]){2, 420, 42, 4, 84, 0, 5, 126, 168, 84, 0, 0, 1, 210, 0, CELL, CELL, 4, 252, 210, 6, 294, 336, 252, 210, 0, 1, 378, 336, CELL, CELL, 0, 3, 462, 126, 168, 420, CELL, CELL, CELL, CELL, 1, 504, 378, 462, 0, 5, 546, 126, 168, 378, 462, 504, CELL, CELL, CELL, CELL, CELL, CELL, 0, 1, 588, 462, CELL, CELL, 0, 2, 630, 126, 168, CELL, CELL, CELL, CELL, 0, 42, CELL, 42, 546}},
    {81, 95, 101, (const int32_t[]){2, 672, 42, 4, 84, 0, 5, 126, 168, 84, 0, 0, 1, 210, 0, CELL, CELL, 4, 252, 210, 6, 294, 336, 252, 210, 0, 1, 378, 336, CELL, CELL, 3, 420, 462, 504, 546, 588, 630, 0, 0, 10, 714, 0, 126, 168, 420, 462, 504, 546, 588, 630, 672, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, 1, 756, 378, 714, 0, 5, 798, 126, 168, 378, 714, 756, CELL, CELL, CELL, CELL, CELL, CELL, 0, 1, 840, 714, CELL, CELL, 0, 2, 882, 126, 168, CELL, CELL, CELL, CELL, 0, 42, CELL, 42, 798}},
    {79, 93, 99, (const int32_t[]){2, 546, 42, 4, 126, 0, 5, 168, 210, 126, 0, 1, 252, 84, 168, 1, 294, 84, 210, 0, 1, 336, 0, CELL, CELL, 4, 378, 336, 6, 420, 462, 378, 336, 0, 1, 504, 462, CELL, CELL, 0, 6, 588, 84, 168, 210, 252, 294, 546, CELL, CELL, CELL, CELL, CELL, CELL, CELL, 1, 630, 504, 588, 0, 8, 672, 84, 168, 210, 252, 294, 504, 588, 630, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, 0, 1, 714, 588, CELL, CELL, 0, 2, 756, 168, 210, CELL, CELL, CELL, CELL, 0, 42, CELL, 42, 672}},
    {99, 113, 119, (const int32_t[]){2, 672, 42, 4, 168, 0, 5, 210, 252, 168, 0, 1, 294, 84, 210, 1, 336, 84, 252, 1, 378, 126, 210, 1, 420, 126, 252, 0, 1, 462, 0, CELL, CELL, 4, 504, 462, 6, 546, 588, 504, 462, 0, 1, 630, 588, CELL, CELL, 0, 9, 714, 84, 126, 210, 252, 294, 336, 378, 420, 672, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, 1, 756, 630, 714, 0, 11, 798, 84, 126, 210, 252, 294, 336, 378, 420, 630, 714, 756, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, 0, 1, 840, 714, CELL, CELL, 0, 2, 882, 210, 252, CELL, CELL, CELL, CELL, 0, 42, CELL, 42, 798}},
    {45, 63, 69, (const int32_t[]){2, 84, 42, 0, 2, 126, 42, 84, CELL, CELL, CELL, 4, 168, 0, 5, 210, 252, 168, 0, 0, 3, 294, 84, 210, 252, CELL, CELL, CELL, CELL, 1, 336, 294, 42, 0, 4, 378, 84, 210, 252, 336, CELL, CELL, CELL, CELL, CELL, 0, 3, 420, 84, 210, 252, CELL, CELL, CELL, CELL, 0, 2, 462, 210, 252, CELL, CELL, CELL, CELL, 0, 126, CELL, 42, 378}},
    {77, 91, 97, (const int32_t[]){2, 630, 42, 4, 84, 0, 5, 126, 168, 84, 0, 0, 1, 210, 42, CELL, CELL, 7, 252, 294, 210, 0, 1, 336, 294, CELL, CELL, 3, 378, 420, 462, 504, 546, 588, 0, 0, 10, 672, 0, 126, 168, 378, 420, 462, 504, 546, 588, 630, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, 1, 714, 336, 672, 0, 5, 756, 126, 168, 336, 672, 714, CELL, CELL, CELL, CELL, CELL, CELL, 0, 1, 798, 672, CELL, CELL, 0, 2, 840, 126, 168, CELL, CELL, CELL, CELL, 0, 42, CELL, 42, 756}},
    {75, 89, 95, (const int32_t[]){2, 504, 42, 4, 126, 0, 5, 168, 210, 126, 0, 1, 252, 84, 168, 1, 294, 84, 210, 0, 1, 336, 42, CELL, CELL, 7, 378, 420, 336, 0, 1, 462, 420, CELL, CELL, 0, 6, 546, 84, 168, 210, 252, 294, 504, CELL, CELL, CELL, CELL, CELL, CELL, CELL, 1, 588, 462, 546, 0, 8, 630, 84, 168, 210, 252, 294, 462, 546, 588, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, 0, 1, 672, 546, CELL, CELL, 0, 2, 714, 168, 210, CELL, CELL, CELL, CELL, 0, 42, CELL, 42, 630}},
    {95, 109, 115, (const int32_t[]){2, 630, 42, 4, 168, 0, 5, 210, 252, 168, 0, 1, 294, 84, 210, 1, 336, 84, 252, 1, 378, 126, 210, 1, 420, 126, 252, 0, 1, 462, 42, CELL, CELL, 7, 504, 546, 462, 0, 1, 588, 546, CELL, CELL, 0, 9, 672, 84, 126, 210, 252, 294, 336, 378, 420, 630, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, 1, 714, 588, 672, 0, 11, 756, 84, 126, 210, 252, 294, 336, 378, 420, 588, 672, 714, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, 0, 1, 798, 672, CELL, CELL, 0, 2, 840, 210, 252, CELL, CELL, CELL, CELL, 0, 42, CELL, 42, 756}},
    {67, 81, 87, (const int32_t[]){2, 504, 42, 4, 84, 0, 5, 126, 168, 84, 0, 0, 1, 210, 0, CELL, CELL, 3, 252, 294, 336, 378, 420, 462, 0, 0, 10, 546, 0, 126, 168, 252, 294, 336, 378, 420, 462, 504, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, 1, 588, 210, 546, 0, 5, 630, 126, 168, 210, 546, 588, CELL, CELL, CELL, CELL, CELL, CELL, 0, 1, 672, 546, CELL, CELL, 0, 2, 714, 126, 168, CELL, CELL, CELL, CELL, 0, 42, CELL, 42, 630}},
    {65, 79, 85, (const int32_t[]){2, 378, 42, 4, 126, 0, 5, 168, 210, 126, 0, 1, 252, 84, 168, 1, 294, 84, 210, 0, 1, 336, 0, CELL, CELL, 0, 6, 420, 84, 168, 210, 252, 294, 378, CELL, CELL, CELL, CELL, CELL, CELL, CELL, 1, 462, 336, 420, 0, 8, 504, 84, 168, 210, 252, 294, 336, 420, 462, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, 0, 1, 546, 420, CELL, CELL, 0, 2, 588, 168, 210, CELL, CELL, CELL, CELL, 0, 42, CELL, 42, 504}},
    {85, 99, 105, (const int32_t[]){2, 504, 42, 4, 168, 0, 5, 210, 252, 168, 0, 1, 294, 84, 210, 1, 336, 84, 252, 1, 378, 126, 210, 1, 420, 126, 252, 0, 1, 462, 0, CELL, CELL, 0, 9, 546, 84, 126, 210, 252, 294, 336, 378, 420, 504, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, 1, 588, 462, 546, 0, 11, 630, 84, 126, 210, 252, 294, 336, 378, 420, 462, 546, 588, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, CELL, 0, 1, 672, 546, CELL, CELL, 0, 2, 714, 210, 252, CELL, CELL, CELL, CELL, 0, 42, CELL, 42, 630}},
};

static int straight_of(const Job *job)
{
    const int32_t *const own = job->series;
    for (int k = 0; k < (int)(sizeof patterns / sizeof *patterns); k++) {
        const int32_t *const known = patterns[k].operations;
        int same = patterns[k].rates == job->series_end - own && patterns[k].later == job->later_end - own &&
                   patterns[k].length == patterns[k].later + 3 * job->states;
        for (int i = 0; same && i < patterns[k].length; i++) same = known[i] == CELL || known[i] == own[i];
        if (same) return k;
    }
    return -1;
}
#endif

/* The program as integers: cells (and `made`), registers, states, tables, integers of operations on numbers,
 * of those on series and of those on series that no rate needs, autonomous, by_rotation; roles; then these operations, states (3 each), tables (4 each), as the structs have them. */
enum { HEAD = 10, WIDEST = 64 };

static int read_program(Job *job, const int32_t *p, const int32_t *end)
{
    int64_t length = HEAD + sizeof(Roles) / 4;
    if (end - p < length) return -1;
    for (int k = 0; k < HEAD; k++) if (p[k] < 0) return -1;
    if (p[0] < CELLS || p[1] > p[0] || p[3] < 2 || p[3] > MOST_STATES || p[4] > MOST_TABLES) return -1;
    length += (int64_t)p[5] + p[6] + p[7] + 3 * p[3] + 4 * p[4];
    if (end - p != length || p[2] > length) return -1; /* each register is a state or the result of an operation */
    job->cells = p[0], job->made = p[1], job->registers = p[2], job->states = p[3], job->tables = p[4];
    job->scalar = p + HEAD + sizeof(Roles) / 4;
    job->role = (const Roles *)(p + HEAD);
    job->scalar_end = job->series = job->scalar + p[5];
    job->series_end = job->series + p[6], job->later_end = job->series_end + p[7];
    job->state = (const State *)job->later_end;
    job->autonomous = p[8], job->by_rotation = p[9];
    job->table = (const Table *)(job->state + job->states);
    for (int t = 0; t < job->tables; t++) job->timed += job->table[t].kind == 2;
#ifdef __wasm__
    job->straight = -1; /* a page shall be small */
#else
    job->straight = straight_of(job);
#endif
    return 0;
}
#endif

#ifndef LEVEL
/* --- the module --------------------------------------------------------------------------------------------------- */

#include <Python.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { TIME, STATUS, PHASES, END_TIME, FIRST_ONLY, LIMIT, LIMIT_REST, PEAK_TIME, PEAK_ROTATION, PEAK_OMEGA, PEAK_RATE, REACH_TIME, REACH_ROTATION, END_ROTATION, END_OMEGA, END_RATE, CLOSE, REST_SINCE, TURNS, STEPS, ROTATION, SLIP, DIRECTION, LIFTED, ORDER, FACTOR, ONE_WAY, LIFT_TIME, PASSED, LAST_WAY, NEGLIGIBLE, X, OMEGA };
enum { PENDING = -16, FACED, SUDDEN, RATE_BEFORE, DRIVE_BEFORE, SCALE_BEFORE, SERIES_ORDER, LARGEST_OMEGA, STEP, EVENT, START_DIRECTION, QUIET_FROM, QUIET_TO, SINE_X, VERSINE_X, CLOCKED };
enum { PIECE, VALUE, INC, UPPER, LOWER, SCALE, SCALED_BY, WAY, RISE, Q1 };
enum { OF_SLIP, OF_SPEED, OF_TIME, OF_ROTATION };
enum { START, MOVING, RESTING, ARRESTED, PAUSED, ENDED, STOPPED, UPRIGHT, TOO_LONG, FAILED, NEED };
enum { NOTHING, LIFT, FASTER, SLOWER };
enum { READY, START_MOVING, RESOLVE, START_AGAIN, ENTER_PHASE, DISCONTINUITY, BEGIN_PHASE, REST };
enum { EVENT_NONE = -1, EVENT_STANDSTILL, EVENT_LIFT_OFF, EVENT_CHORD_UPRIGHT, EVENT_START, EVENT_LIMIT, EVENT_ENDLESS, EVENT_BREAKPOINT };
enum { NOTE_BEGINS = 1, NOTE_STANDS, NOTE_LIFTS, NOTE_LANDS };
enum { MOST_STEPS = 200000, STIFF_STEP = 20, MOST_TURNS = 2000 };
#define STIFF_CHANGE 0.001
#define CARRIED 0.001
#define SETTLED 1.4210854715202004e-14
#define BETWEEN 2.0
#define LEAST_SIZE 1e-300
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

#define DECLARE(LEVEL) int64_t flow_integrate_##LEVEL(Job *job); extern const Traits flow_traits_##LEVEL;
LEVELS(DECLARE)
static const struct { const char *name; int64_t (*integrate)(Job *); const Traits *traits; } levels[] = {
#define ROW(LEVEL) {#LEVEL, flow_integrate_##LEVEL, &flow_traits_##LEVEL},
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

/* Registers that an operation on series names, without the terms of a sum. */
static const unsigned char named[] = { 1, 3, 2, 7, 2, 4, 4, 3, 4 };

static int is_register(const Job *job, int32_t i) { return i >= 0 && i % STRIDE == 0 && i / STRIDE < job->registers; }
static int is_cell(const Job *job, int32_t i) { return i >= 0 && i < job->cells; }

/* Whether operations end where they should, and their registers and cells exist. */
static int series_fit(const Job *job, const int32_t *at, const int32_t *end)
{
    while (at < end) {
        const int code = *at++;
        if (code < 0 || code >= (int)sizeof named || at == end) return 0;
        const int terms = code == LIN ? *at++ : 0, cells = code == LIN ? terms + 1 : 0;
        if (terms < 0 || terms > end - at || end - at < named[code] + terms + cells) return 0;
        for (int i = 0; i < named[code] + terms; i++) if (!is_register(job, *at++)) return 0;
        for (int i = 0; i < cells; i++) if (!is_cell(job, *at++)) return 0;
    }
    return 1;
}

static int program_fits(const Job *job)
{
    for (const int32_t *at = job->scalar; at < job->scalar_end;) {
        const int code = *at++;
        if (code < 0 || code >= (int)sizeof arguments || job->scalar_end - at < 1 + arguments[code]) return 0;
        for (int i = 0; i < 1 + arguments[code]; i++) if (!is_cell(job, *at++)) return 0;
    }
    for (const State *s = job->state; s < job->state + job->states; s++)
        if (!is_cell(job, s->cell) || !is_register(job, s->series) || !is_register(job, s->rate)) return 0;
    for (const Table *t = job->table; t < job->table + job->tables; t++) {
        const int64_t end = (int64_t)t->cell + PARTS + t->degree;
        if (t->kind < 0 || t->kind > 3 || t->cell < 0 || t->degree < 0 || t->degree >= STRIDE || end > job->cells ||
            (t->reg != -1 && !is_register(job, t->reg))) return 0;
    }
    if (job->by_rotation == 2 && (job->series_end - job->series < 3 || job->series[0] != SQR || job->role->square < 0)) return 0;
    const int32_t *const role = (const int32_t *)job->role;
    for (int i = 0; i < (int)sizeof(Roles) / 4; i++)
        if (role[i] != -1 && !(i < REGISTER_ROLES ? is_register(job, role[i]) : is_cell(job, role[i]))) return 0;
    return series_fit(job, job->series, job->series_end) && series_fit(job, job->series_end, job->later_end);
}

static int table_fits(const Data *d, const Py_buffer *buffers, int64_t count)
{
    const int64_t pieces = d->pieces, across = d->across ? d->across : 1;
    return pieces > 0 && d->terms > 0 && d->terms <= STRIDE && (across == 1 || across == count) &&
           buffers[0].len == 8 * pieces * (d->apart ? across : 1) && buffers[1].len == 8 * pieces * d->terms * across &&
           buffers[2].len == 8 * pieces;
}

static const char doc[] = "integrate(program, tables, cells, begin, end, budget, times, outputs, notes, level, shared)\n--\n\n"
    "Integrate the lanes from `begin` to `end`, columns of `cells`, which change in place, for `budget` steps of a vector\n"
    "at most. Returns how many lanes have not ended (call again), and how many notes there are.\n\n"
    "`program` are integers (see `slipcircle.core.integrator.compiled`); each of `tables` is (breaks, coefficients, jumps, terms,\n"
    "across, sine, open). States are read off at `times`, (samples, 1 or lanes),\n"
    "into `outputs`, (4 + further states, samples, lanes), or nowhere where `times` is empty; events of the first lane\n"
    "are written into `notes`, (rows, 4), and what has no room there is not written. A lane that has not begun takes its\n"
    "cells from the column `shared`, unless it is empty, and only those that are not a number there from `cells`.\n\n"
    "With `outputs`, (registers, lanes), and no times nothing is integrated: all registers are evaluated where each lane is;\n"
    "with a budget a phase begins there first, in the direction that is set.";

/* Buffers of a call, released together. */
typedef struct { Py_buffer program, tables[3 * MOST_TABLES]; int views; } Held;

/* Read the program and its tables; 0 with an exception where they do not fit. */
static int read_job(Job *job, Held *held, PyObject *program, PyObject *tables, int level)
{
    held->views = 0, held->program.obj = NULL; /* without a buffer there is nothing to release */
    if (PyObject_GetBuffer(program, &held->program, PyBUF_SIMPLE)) return 0;
    const int32_t *const code = held->program.buf;
    if (read_program(job, code, code + held->program.len / 4) || !program_fits(job) || PyTuple_Size(tables) != job->tables ||
        level < 0 || level >= KINDS || !runs(level)) {
        PyErr_SetString(PyExc_ValueError, "integrate: the program, its tables or level do not fit");
        return 0;
    }
    for (int t = 0; t < job->tables; t++, held->views += 3) {
        Data *d = job->data + t;
        long long across;
        Py_buffer *b = held->tables + held->views;
        if (!PyArg_ParseTuple(PyTuple_GetItem(tables, t), "y*y*y*iLpp", b, b + 1, b + 2, &d->terms, &across, &d->sine,
                              &d->open)) return 0;
        d->breaks = b[0].buf, d->coefficients = b[1].buf, d->jumps = b[2].buf;
        d->pieces = b[2].len / 8, d->across = across, d->apart = b[0].len > b[2].len ? across : 0;
    }
    return 1;
}

static void release(Held *held)
{
    while (held->views--) PyBuffer_Release(held->tables + held->views);
    PyBuffer_Release(&held->program);
}

/* Lanes that have not ended, or -1 with an exception where cells, tables, times, registers or an order do not fit. */
static int64_t run(Job *job, const Held *held, int level, int fits)
{
    for (int t = 0; t < job->tables; t++) fits = fits && table_fits(job->data + t, held->tables + 3 * t, job->count);
    if (!fits) {
        PyErr_SetString(PyExc_ValueError, "integrate: the cells, tables, times or registers are not those of as many lanes");
        return -1;
    }
    const int64_t room = (MOST_WORKING + job->cells + (int64_t)job->registers * STRIDE) * WIDEST;
    const int64_t begun = job->shared ? job->cells * WIDEST + 5 * job->cells + 4 * (job->scalar_end - job->scalar) : 0;
    void *memory = malloc((size_t)(room + WIDEST + begun));
    if (memory == NULL) {
        PyErr_NoMemory();
        return -1;
    }
    job->memory = (void *)(((uintptr_t)memory + WIDEST - 1) & ~(uintptr_t)(WIDEST - 1));
    job->begun = begun ? (char *)job->memory + room : NULL;
    int64_t left;
    Py_BEGIN_ALLOW_THREADS
    left = levels[level].integrate(job);
    Py_END_ALLOW_THREADS
    free(memory);
    if (left < 0) PyErr_SetString(PyExc_ValueError, "integrate: an order does not fit");
    return left;
}

static PyObject *integrate(PyObject *self, PyObject *args)
{
    (void)self;
    Job job = {0};
    Held held;
    Py_buffer cells, times, outputs, notes, shared;
    PyObject *program, *tables, *result = NULL;
    int level;
    Py_ssize_t begin, end, budget;
    if (!PyArg_ParseTuple(args, "OO!w*nnny*w*w*iy*", &program, &PyTuple_Type, &tables, &cells, &begin, &end, &budget,
                          &times, &outputs, &notes, &level, &shared)) return NULL;
    if (read_job(&job, &held, program, tables, level)) {
        job.all = cells.buf, job.count = cells.len / 8 / job.cells;
        job.begin = begin, job.end = end < job.count ? end : job.count, job.budget = budget;
        job.shared = shared.len ? shared.buf : NULL;
        int fits = job.count > 0 && cells.len == 8 * job.cells * job.count && begin >= 0 && begin <= end &&
                   (!shared.len || shared.len == 8 * job.cells);
        if (fits && times.len) {
            job.times = times.buf, job.outputs = outputs.buf;
            job.samples = outputs.len / 8 / job.count / (2 + job.states);
            job.times_across = job.samples ? times.len / 8 / job.samples : 0;
            fits = outputs.len == 8 * job.samples * job.count * (2 + job.states) && (job.times_across == 1 ||
                   job.times_across == job.count) && times.len == 8 * job.samples * job.times_across;
        } else if (fits && outputs.len) {
            job.outputs = outputs.buf;
            fits = outputs.len == 8 * (int64_t)job.registers * job.count;
        }
        job.notes = notes.buf, job.notes_room = notes.len / 32;
        const int64_t left = run(&job, &held, level, fits);
        if (left >= 0) result = Py_BuildValue("LL", (long long)left, (long long)job.noted);
    }
    release(&held);
    PyBuffer_Release(&cells), PyBuffer_Release(&times), PyBuffer_Release(&outputs), PyBuffer_Release(&notes);
    PyBuffer_Release(&shared);
    return result;
}

/* Relative differences of runs of a motion, of which the first is the motion: of duration, run-out, peak velocity, and of
 * states before the end. States differ by the spread of times, at the peak velocity, or by the spread of rotations. All
 * differences are infinite where a run ends otherwise. */
static PyObject *differences(const double *cells, int64_t count)
{
#define AT(cell, k) cells[(cell) * count + (k)]
    const int creeps = AT(TIME, 0) == INFINITY;
    double duration = 0.0, times = 0.0, reaches = 0.0, peaks = 0.0, ends = 0.0, unlike = 0.0;
    for (int64_t k = 0; k < count; k++) {
        const double status = AT(STATUS, k);
        const int rest = status >= ARRESTED && status <= ENDED && AT(STATUS, 0) >= ARRESTED && AT(STATUS, 0) <= ENDED;
        if ((status != AT(STATUS, 0) && !rest) || (AT(PHASES, k) > 0.0) != (AT(PHASES, 0) > 0.0)) unlike = INFINITY;
        const double time = status == ENDED && !creeps ? AT(END_TIME, k) : AT(REST_SINCE, k);
        if (k == 0) duration = time;
        times = fmax(times, fabs(time - duration));
        reaches = fmax(reaches, fabs(AT(REACH_ROTATION, k) - AT(REACH_ROTATION, 0)));
        peaks = fmax(peaks, fabs(fabs(AT(PEAK_OMEGA, k)) - fabs(AT(PEAK_OMEGA, 0))));
        ends = fmax(ends, fabs(AT(END_ROTATION, k) - AT(END_ROTATION, 0)));
    }
    const double peak = fmax(fabs(AT(PEAK_OMEGA, 0)), LEAST_SIZE), reach = fmax(fabs(AT(REACH_ROTATION, 0)), LEAST_SIZE);
    const double states = fmax(BETWEEN * times * fabs(AT(PEAK_OMEGA, 0)), ends) / reach;
#undef AT
    return Py_BuildValue("dddd", times / fmax(duration, LEAST_SIZE) + unlike, reaches / reach + unlike, peaks / peak + unlike,
                         states + unlike);
}

static PyObject *spreads(PyObject *self, PyObject *args)
{
    (void)self;
    Py_buffer cells;
    Py_ssize_t count;
    if (!PyArg_ParseTuple(args, "y*n", &cells, &count)) return NULL;
    PyObject *result = NULL;
    if (count > 0 && cells.len % (8 * count) == 0 && cells.len >= 8 * RESULTS * count) result = differences(cells.buf, count);
    else PyErr_SetString(PyExc_ValueError, "spreads: the cells are not those of as many lanes");
    PyBuffer_Release(&cells);
    return result;
}

/* Cells of runs, (cells, runs), from numbers by the name of the cell: times factors, (cells, runs), plus summands after
 * them. */
static int fill_runs(const Job *job, PyObject *start, PyObject *places, const double *moves)
{
    const double *const further = moves + job->cells * job->count;
    PyObject *name, *value;
    for (Py_ssize_t at = 0; PyDict_Next(start, &at, &name, &value);) {
        PyObject *const place = PyDict_GetItemWithError(places, name);
        if (place == NULL) continue;
        const double number = PyFloat_AsDouble(value);
        const int64_t row = PyLong_AsLongLong(place) * job->count;
        if (row < 0 || row >= job->cells * job->count) return 0;
        for (int64_t k = row; k < row + job->count; k++) job->all[k] = number * moves[k] + further[k];
    }
    return !PyErr_Occurred();
}

static PyObject *first_lane(const double *cells, int64_t count)
{
    PyObject *list = PyList_New(RESULTS);
    for (int i = 0; list != NULL && i < RESULTS; i++) {
        PyObject *number = PyFloat_FromDouble(cells[i * count]);
        if (number == NULL || PyList_SetItem(list, i, number)) Py_CLEAR(list);
    }
    return list;
}

static PyObject *integrate_runs(PyObject *self, PyObject *args)
{
    (void)self;
    Job job = {0};
    Held held;
    Py_buffer moves;
    PyObject *program, *tables, *start, *places, *result = NULL;
    int level;
    Py_ssize_t budget;
    if (!PyArg_ParseTuple(args, "OO!O!O!y*ni", &program, &PyTuple_Type, &tables, &PyDict_Type, &start, &PyDict_Type,
                          &places, &moves, &budget, &level)) return NULL;
    if (read_job(&job, &held, program, tables, level)) {
        const int64_t size = moves.len / 16;
        job.count = job.end = size / job.cells, job.budget = budget;
        job.all = calloc((size_t)size + 1, 8);
        const int fits = job.all != NULL && job.count > 0 && moves.len == 16 * job.cells * job.count &&
                         fill_runs(&job, start, places, moves.buf);
        if (!PyErr_Occurred()) {
            const int64_t left = run(&job, &held, level, fits);
            int ended = left == 0;
            for (int64_t k = 0; ended && k < job.count; k++) ended = job.all[STATUS * job.count + k] < TOO_LONG;
            if (ended) result = Py_BuildValue("NN", first_lane(job.all, job.count), differences(job.all, job.count));
            else if (left >= 0) result = Py_BuildValue("");
        }
        free(job.all);
    }
    release(&held);
    PyBuffer_Release(&moves);
    return result;
}

#ifdef Py_LIMITED_API
#define ORIGIN ", shipped"
#else
#define ORIGIN ""
#endif
#define TEXT(x) #x
#define NUMBERS(a, b, c) TEXT(a) "." TEXT(b) "." TEXT(c)
#ifdef __clang__
#define COMPILER "Clang " NUMBERS(__clang_major__, __clang_minor__, __clang_patchlevel__) ORIGIN
#else
#define COMPILER "GCC " NUMBERS(__GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__) ORIGIN
#endif

/* DIGEST of the source; COMPILER, its name and version; LEVELS: those that run here, name -> number, the
 * widest first; TRAITS: name -> (lanes, has straight-line programs). */
static int fill(PyObject *module)
{
    PyObject *levels_here = PyDict_New(), *traits = PyDict_New();
    int failed = levels_here == NULL || traits == NULL;
    for (int k = 0; k < KINDS && !failed; k++) {
        if (!runs(k)) continue;
        PyObject *number = PyLong_FromLong(k), *of = Py_BuildValue("ii", levels[k].traits->lanes, levels[k].traits->straight);
        failed = number == NULL || of == NULL || PyDict_SetItemString(levels_here, levels[k].name, number) ||
                 PyDict_SetItemString(traits, levels[k].name, of);
        Py_XDECREF(number), Py_XDECREF(of);
    }
    failed = failed || PyModule_AddObjectRef(module, "LEVELS", levels_here) ||
             PyModule_AddObjectRef(module, "TRAITS", traits) ||
             PyModule_AddStringConstant(module, "COMPILER", COMPILER) ||
             PyModule_AddStringConstant(module, "DIGEST", DIGEST);
    Py_XDECREF(levels_here), Py_XDECREF(traits);
    return failed ? -1 : 0;
}

static PyObject *straight_line(PyObject *self, PyObject *args)
{
    (void)self;
    Py_buffer code;
    Job job = {0};
    int level;
    if (!PyArg_ParseTuple(args, "y*i", &code, &level)) return NULL;
    const int fits = !read_program(&job, code.buf, (const int32_t *)code.buf + code.len / 4) && program_fits(&job);
    PyBuffer_Release(&code);
    return PyLong_FromLong(fits && level >= 0 && level < KINDS && levels[level].traits->straight ? job.straight : -1);
}

static PyMethodDef methods[] = {
    {"integrate", integrate, METH_VARARGS, doc},
    {"integrate_runs", integrate_runs, METH_VARARGS,
     "integrate_runs(program, tables, start, places, moves, budget, level)\n--\n\n"
     "Integrate runs of one motion. Their cells are numbers `start` by name, at `places` by name, times the first of `moves`,\n"
     "(2, cells, runs), plus the second. Returns the final cells of the first run, and `spreads` of all; None where a run has\n"
     "not ended."},
    {"spreads", spreads, METH_VARARGS,
     "spreads(cells, runs)\n--\n\n"
     "Greatest relative differences of the duration, run-out and peak velocity of runs from the first one, and of states."},
    {"straight_line", straight_line, METH_VARARGS,
     "straight_line(program, level)\n--\n\nWhich of the programs with functions of their own it is there, or -1."},
    {NULL, NULL, 0, NULL},
};
static PyModuleDef_Slot slots[] = {
    {Py_mod_exec, fill},
#ifdef Py_MOD_GIL_NOT_USED
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
#ifdef __SSE2__
#include <immintrin.h>
#endif

/* Pages shall be small, and wheels: x86 processors without AVX2 are old. */
#if defined(__wasm__) || (WIDE == 128 && defined(__x86_64__))
#define SMALL
#define INLINE static inline
#else
#define INLINE static inline __attribute__((always_inline))
#endif
#define APART static __attribute__((noinline)) /* what all programs call, once, so that wheels are small */
#define NAMED_(name, level) name##_##level
#define NAMED(name, level) NAMED_(name, level)
#define EPS 0x1p-52

/* With AVX2 two registers are a vector, so that a step waits half as long for its last coefficients; GCC would pass these
 * vectors through memory. */
#if WIDE == 256 && defined(__clang__)
#define SPAN 512
#else
#define SPAN WIDE
#endif
enum { LANES = SPAN / 64, ALL = (1 << LANES) - 1 };
typedef double V __attribute__((vector_size(SPAN / 8)));
typedef int64_t M __attribute__((vector_size(SPAN / 8))); /* true is -1, false is 0 */

enum { TIME, STATUS, PHASES, END_TIME, FIRST_ONLY, LIMIT, LIMIT_REST, PEAK_TIME, PEAK_ROTATION, PEAK_OMEGA, PEAK_RATE, REACH_TIME, REACH_ROTATION, END_ROTATION, END_OMEGA, END_RATE, CLOSE, REST_SINCE, TURNS, STEPS, ROTATION, SLIP, DIRECTION, LIFTED, ORDER, FACTOR, ONE_WAY, LIFT_TIME, PASSED, LAST_WAY, NEGLIGIBLE, X, OMEGA };
enum { PENDING = -16, FACED, SUDDEN, RATE_BEFORE, DRIVE_BEFORE, SCALE_BEFORE, SERIES_ORDER, LARGEST_OMEGA, STEP, EVENT, START_DIRECTION, QUIET_FROM, QUIET_TO, SINE_X, VERSINE_X, CLOCKED };
enum { PIECE, VALUE, INC, UPPER, LOWER, SCALE, SCALED_BY, WAY, RISE, Q1 };
enum { OF_SLIP, OF_SPEED, OF_TIME, OF_ROTATION };
enum { START, MOVING, RESTING, ARRESTED, PAUSED, ENDED, STOPPED, UPRIGHT, TOO_LONG, FAILED, NEED };
enum { NOTHING, LIFT, FASTER, SLOWER };
enum { READY, START_MOVING, RESOLVE, START_AGAIN, ENTER_PHASE, DISCONTINUITY, BEGIN_PHASE, REST };
enum { EVENT_NONE = -1, EVENT_STANDSTILL, EVENT_LIFT_OFF, EVENT_CHORD_UPRIGHT, EVENT_START, EVENT_LIMIT, EVENT_ENDLESS, EVENT_BREAKPOINT };
enum { NOTE_BEGINS = 1, NOTE_STANDS, NOTE_LIFTS, NOTE_LANDS };
enum { MOST_STEPS = 200000, STIFF_STEP = 20, MOST_TURNS = 2000 };
#define STIFF_CHANGE 0.001
#define CARRIED 0.001
#define SETTLED 1.4210854715202004e-14
#define BETWEEN 2.0
#define LEAST_SIZE 1e-300
_Static_assert(PENDING >= -MOST_WORKING, "cells in front of the others");
/* Lanes that begin side by side: cells of a batch before its first step, as far as all lanes of the queue share them, or
 * NULL; places of cells that each lane has of its own; the operations that depend on these; and whether the others have
 * been repeated since. Only after that are their results changed. */
typedef struct { const V *shared; const int32_t *own, *own_end, *scalar_end; int changed; } Begun;
/* The lanes that are integrated now, beside their cells. */
typedef struct {
    Job *job;
    V *c, *r; /* cells, and registers: coefficient n of the register that begins at i is r[i + n] */
    int64_t column[LANES];
    unsigned held; /* a bit for each lane */
    double inverse[STRIDE];
    const int32_t *scalar, *scalar_end; /* the operations of the next prologue */
    Begun begun;
} Batch;
typedef struct { V one, other; } Pair;

/* --- vectors and functions of them --- */

INLINE V pick(M m, V a, V b)
{
#if SPAN == 256
    return (V)_mm256_blendv_pd((__m256d)b, (__m256d)a, (__m256d)m);
#else
    return (V)(((M)a & m) | ((M)b & ~m));
#endif
}
INLINE V magnitude(V x) { return (V)((M)x & INT64_MAX); }
/* The lesser and the greater number, b if one is not a number. */
#if WIDE == 512
#define EXTREME(name, before) (V)_mm512_##name##_pd((__m512d)a, (__m512d)b)
#elif SPAN == 256
#define EXTREME(name, before) (V)_mm256_##name##_pd((__m256d)a, (__m256d)b)
#else
#define EXTREME(name, before) pick(a before b, a, b)
#endif
INLINE V minimum(V a, V b) { return EXTREME(min, <); }
INLINE V maximum(V a, V b) { return EXTREME(max, >); }
INLINE V broadcast(double x)
{
    return x - (V){0}; /* one instruction, which a loop over lanes is not with all compilers */
}
INLINE unsigned bits(M m)
{
#if WIDE == 512
    return _mm512_movepi64_mask((__m512i)m);
#elif SPAN == 256
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
/* The greatest and the least of integers in all lanes, and whether a mask is true in all. */
INLINE int greatest(V x)
{
    double most = x[0];
    for (int k = 1; k < LANES; k++) most = x[k] > most ? x[k] : most;
    return (int)most;
}
INLINE int least(V x)
{
    double low = x[0];
    for (int k = 1; k < LANES; k++) low = x[k] < low ? x[k] : low;
    return (int)low;
}
INLINE int all_lanes(M m) { return bits(m) == (unsigned)ALL; }
#define EACH(k, b) for (unsigned left_ = (b), k; left_ && (k = (unsigned)__builtin_ctz(left_), 1); left_ &= left_ - 1)

/* The nearest integer of |x| < 2^51, by the addition that has no bits beyond it; the sum's pattern ends in its bits. */
#define TO_INTEGER 0x1.8p52

/* sin x and cos x: x = k pi/2 + r (Cody and Waite's reduction by three parts of pi/2), Taylor's series on |r| <= pi/4. */
APART void sine_cosine(V x, V *sine, V *cosine)
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
APART V exponential(V x, V *whole)
{
    const V y = pick(x > 709.5, broadcast(709.5), pick(x < -708.0, broadcast(-708.0), x)); /* NaN stays */
    V k = y * 0x1.71547652b82fep+0 + TO_INTEGER;
    const M n = (M)k;
    k -= TO_INTEGER;
    const V r = (y - k * 0x1.62e42ffp-1) + k * 0x1.718432a1b0e26p-35;
    const V square = r * r; /* even and odd powers do not wait for each other */
    V p = broadcast(1 / 87178291200.0), odd = broadcast(1 / 6227020800.0);
    p = p * square + 1 / 479001600.0, odd = odd * square + 1 / 39916800.0;
    p = p * square + 1 / 3628800.0, odd = odd * square + 1 / 362880.0;
    p = p * square + 1 / 40320.0, odd = odd * square + 1 / 5040.0;
    p = p * square + 1 / 720.0, odd = odd * square + 1 / 120.0;
    p = p * square + 1 / 24.0, odd = odd * square + 1 / 6.0;
    p = r + square * (p * square + 0.5 + r * odd);
    const V power = (V)((n << 52) + INT64_C(0x3ff0000000000000)); /* 2^k: the bits of TO_INTEGER are shifted out */
    const V over = pick(x > 709.5, broadcast(INFINITY), broadcast(0.0));
    *whole = power + power * p + over;
    return power * p + (power - 1.0) + over;
}

/* A function of the C library, lane by lane. */
APART V by_lanes(double f(double), V x)
{
    for (int k = 0; k < LANES; k++) x[k] = f(x[k]);
    return x;
}

/* log(1 + x): 1 + x = 2^k (1 + f) with |f| < 0.42, and twice the series of artanh(f / (2 + f)). */
APART V log1p_of(V x)
{
    const unsigned inside = bits((x > -1.0) & (x < 0x1p1000)); /* a lane elsewhere changes no bit of the others */
    const V y = 1.0 + x;
    const M n = ((M)y - INT64_C(0x3fe6a09e667f3bcd)) >> 52;
    const V per = (V)((INT64_C(1023) - n) << 52), k = (V)(n + (M)broadcast(TO_INTEGER)) - TO_INTEGER;
    const V f = (y * per - 1.0) + (x - (y - 1.0)) * per, s = f / (2.0 + f), z = s * s;
    V p = broadcast(2 / 21.0);
    for (int j = 19; j > 1; j -= 2) p = p * z + 2.0 / j;
    V result = k * 0x1.62e42ffp-1 + (2.0 * s + (s * z * p - k * 0x1.718432a1b0e26p-35));
    EACH(lane, ~inside & ALL) result[lane] = log1p(x[lane]);
    return result;
}

INLINE V sin_of(V x) { V s, c; sine_cosine(x, &s, &c); return s; }
INLINE V cos_of(V x) { V s, c; sine_cosine(x, &s, &c); return c; }
INLINE V tan_of(V x) { V s, c; sine_cosine(x, &s, &c); return s / c; }
INLINE V exp_of(V x) { V e; exponential(x, &e); return e; }
INLINE V expm1_of(V x) { V e; return exponential(x, &e); }
INLINE V log_of(V x) { return by_lanes(log, x); }
INLINE V sqrt_of(V x)
{
#if WIDE == 512
    return (V)_mm512_sqrt_pd((__m512d)x);
#elif SPAN == 256
    return (V)_mm256_sqrt_pd((__m256d)x);
#else
    for (int k = 0; k < LANES; k++) x[k] = sqrt(x[k]);
    return x;
#endif
}

/* What the text of the operations calls functions of vectors. */
#define IN(name) vector_##name
#define vector_map(f, x) f##_of(x)
#define vector_choose pick

/* One operation on series at order n: coefficient n of its results, and where the next operation stands. It is its
 * code, its results and its arguments; a sum is its code, how many terms, its result, their registers, the cell of its
 * constant and those of the factors. What is read off a table is there already. Register i begins at r + i; by_n is 1 / n. */
INLINE const int32_t *operation(const int32_t *at, V *r, const V *c, int n, double by_n)
{
    switch (at[0]) {
    case LIN: {
        const int terms = at[1];
        V sum = n == 0 ? c[at[3 + terms]] : (V){0};
        for (int k = 0; k < terms; k++) sum += c[at[4 + terms + k]] * r[at[3 + k] + n];
        r[at[2] + n] = sum;
        return at + 4 + 2 * terms;
    }
    case MUL: { /* d = a*b */
        V *restrict d = r + at[1];
        const V *a = r + at[2];
        const V *b = r + at[3];
        if (n == 0) {
            d[0] = a[0] * b[0];
        } else {
            if (n % 2 == 0) {
                V sum0 = a[1] * b[n - 1], sum0_next = {0}, sum0_before = b[n - 1];
                for (int i = 1; 2 * i < n; i++) {
                    sum0_next += a[2 * i] * sum0_before; sum0_before = b[n - 2 * i];
                    sum0 += a[2 * i] * sum0_before; sum0_next += a[2 * i + 1] * sum0_before;
                    sum0_before = b[n - 2 * i - 1]; sum0 += a[2 * i + 1] * sum0_before;
                }
                d[n] = sum0, d[n + 1] = sum0_next;
            } else {
                d[n] = n > 1 ? d[n] + a[1] * b[n - 1] + a[n - 1] * b[1] : (V){0};
            }
            const V sum0 = d[n];
            d[n] = sum0 + a[0] * b[n] + a[n] * b[0];
        }
        return at + 4;
    }
    case SQR: { /* d = a**2 */
        V *restrict d = r + at[1];
        const V *a = r + at[2];
        if (n == 0) {
            d[0] = a[0] * a[0];
        } else {
            if (n % 2 == 0) {
                V sum0 = {0}, sum0_next = {0};
                for (int i = 1; 2 * i < n; i++) {
                    const V sum0_now = a[n - i]; sum0 += a[i] * sum0_now; sum0_next += a[i + 1] * sum0_now;
                }
                d[n] = 2.0 * sum0 + a[n / 2] * a[n / 2], d[n + 1] = 2.0 * sum0_next;
            } else {
                d[n] = n > 1 ? d[n] + 2.0 * a[1] * a[n - 1] : (V){0};
            }
            const V sum0 = d[n];
            d[n] = sum0 + 2.0 * a[0] * a[n];
        }
        return at + 3;
    }
    case POWERS: { /* p2 = x**2, p3 = x**3, p4 = x**4, p5 = x**5, p6 = x**6, p7 = x**7 */
        V *restrict p2 = r + at[1];
        V *restrict p3 = r + at[2];
        V *restrict p4 = r + at[3];
        V *restrict p5 = r + at[4];
        V *restrict p6 = r + at[5];
        V *restrict p7 = r + at[6];
        const V *x = r + at[7];
        if (n == 0) {
            const V t1 = x[0] * x[0];
            const V t2 = x[0] * t1;
            const V t3 = t1 * t1;
            p2[0] = t1;
            p3[0] = t2;
            p4[0] = t3;
            p5[0] = x[0] * t3;
            p6[0] = t1 * t3;
            p7[0] = t2 * t3;
        } else {
            if (n % 2 == 0) {
                V sum0 = x[1] * p2[n - 1], sum0_next = {0}, sum0_before = p2[n - 1];
                V sum1 = x[1] * p3[n - 1], sum1_next = {0}, sum1_before = p3[n - 1];
                V sum2 = x[1] * p4[n - 1], sum2_next = {0}, sum2_before = p4[n - 1];
                V sum3 = x[1] * p5[n - 1], sum3_next = {0}, sum3_before = p5[n - 1];
                V sum4 = x[1] * p6[n - 1], sum4_next = {0}, sum4_before = p6[n - 1];
                V sum5 = {0}, sum5_next = {0};
                for (int i = 1; 2 * i < n; i++) {
                    sum0_next += x[2 * i] * sum0_before; sum0_before = p2[n - 2 * i];
                    sum0 += x[2 * i] * sum0_before; sum0_next += x[2 * i + 1] * sum0_before;
                    sum0_before = p2[n - 2 * i - 1]; sum0 += x[2 * i + 1] * sum0_before;
                    sum1_next += x[2 * i] * sum1_before; sum1_before = p3[n - 2 * i];
                    sum1 += x[2 * i] * sum1_before; sum1_next += x[2 * i + 1] * sum1_before;
                    sum1_before = p3[n - 2 * i - 1]; sum1 += x[2 * i + 1] * sum1_before;
                    sum2_next += x[2 * i] * sum2_before; sum2_before = p4[n - 2 * i];
                    sum2 += x[2 * i] * sum2_before; sum2_next += x[2 * i + 1] * sum2_before;
                    sum2_before = p4[n - 2 * i - 1]; sum2 += x[2 * i + 1] * sum2_before;
                    sum3_next += x[2 * i] * sum3_before; sum3_before = p5[n - 2 * i];
                    sum3 += x[2 * i] * sum3_before; sum3_next += x[2 * i + 1] * sum3_before;
                    sum3_before = p5[n - 2 * i - 1]; sum3 += x[2 * i + 1] * sum3_before;
                    sum4_next += x[2 * i] * sum4_before; sum4_before = p6[n - 2 * i];
                    sum4 += x[2 * i] * sum4_before; sum4_next += x[2 * i + 1] * sum4_before;
                    sum4_before = p6[n - 2 * i - 1]; sum4 += x[2 * i + 1] * sum4_before;
                    const V sum5_now = x[n - i]; sum5 += x[i] * sum5_now; sum5_next += x[i + 1] * sum5_now;
                }
                p2[n] = sum0, p2[n + 1] = sum0_next;
                p3[n] = sum1, p3[n + 1] = sum1_next;
                p4[n] = sum2, p4[n + 1] = sum2_next;
                p5[n] = sum3, p5[n + 1] = sum3_next;
                p6[n] = sum4, p6[n + 1] = sum4_next;
                p7[n] = 2.0 * sum5 + x[n / 2] * x[n / 2], p7[n + 1] = 2.0 * sum5_next;
            } else {
                p2[n] = n > 1 ? p2[n] + x[1] * p2[n - 1] + x[n - 1] * p2[1] : (V){0};
                p3[n] = n > 1 ? p3[n] + x[1] * p3[n - 1] + x[n - 1] * p3[1] : (V){0};
                p4[n] = n > 1 ? p4[n] + x[1] * p4[n - 1] + x[n - 1] * p4[1] : (V){0};
                p5[n] = n > 1 ? p5[n] + x[1] * p5[n - 1] + x[n - 1] * p5[1] : (V){0};
                p6[n] = n > 1 ? p6[n] + x[1] * p6[n - 1] + x[n - 1] * p6[1] : (V){0};
                p7[n] = n > 1 ? p7[n] + 2.0 * x[1] * x[n - 1] : (V){0};
            }
            const V sum0 = p2[n];
            const V sum1 = p3[n];
            const V sum2 = p4[n];
            const V sum3 = p5[n];
            const V sum4 = p6[n];
            const V sum5 = p7[n];
            p2[n] = sum5 + 2.0 * x[0] * x[n];
            p3[n] = sum0 + p2[0] * x[n] + p2[n] * x[0];
            p4[n] = sum1 + p3[0] * x[n] + p3[n] * x[0];
            p5[n] = sum2 + p4[0] * x[n] + p4[n] * x[0];
            p6[n] = sum3 + p5[0] * x[n] + p5[n] * x[0];
            p7[n] = sum4 + p6[0] * x[n] + p6[n] * x[0];
        }
        return at + 8;
    }
    case TIM: { /* q = t*Derivative(a, t) */
        V *restrict q = r + at[1];
        const V *a = r + at[2];
        if (n == 0) {
            q[0] = (V){0};
        } else {
            q[n] = a[n] * n;
        }
        return at + 3;
    }
    case TURN: { /* s = sin(x), v = 1 - cos(x) */
        V *restrict s = r + at[1];
        V *restrict v = r + at[2];
        const V *q = r + at[3];
        const V *x = r + at[4];
        if (n == 0) {
            const V t1 = IN(map)(sin, 0.5 * x[0]);
            s[0] = IN(map)(sin, x[0]);
            v[0] = 2.0 * (t1 * t1);
        } else {
            if (n % 2 == 0) {
                V sum0 = q[1] * s[n - 1], sum0_next = {0}, sum0_before = s[n - 1];
                V sum1 = q[1] * v[n - 1], sum1_next = {0}, sum1_before = v[n - 1];
                for (int i = 1; 2 * i < n; i++) {
                    sum0_next += q[2 * i] * sum0_before; sum0_before = s[n - 2 * i];
                    sum0 += q[2 * i] * sum0_before; sum0_next += q[2 * i + 1] * sum0_before;
                    sum0_before = s[n - 2 * i - 1]; sum0 += q[2 * i + 1] * sum0_before;
                    sum1_next += q[2 * i] * sum1_before; sum1_before = v[n - 2 * i];
                    sum1 += q[2 * i] * sum1_before; sum1_next += q[2 * i + 1] * sum1_before;
                    sum1_before = v[n - 2 * i - 1]; sum1 += q[2 * i + 1] * sum1_before;
                }
                s[n] = sum0, s[n + 1] = sum0_next;
                v[n] = sum1, v[n + 1] = sum1_next;
            } else {
                s[n] = n > 1 ? s[n] + q[1] * s[n - 1] + q[n - 1] * s[1] : (V){0};
                v[n] = n > 1 ? v[n] + q[1] * v[n - 1] + q[n - 1] * v[1] : (V){0};
            }
            const V sum0 = s[n];
            const V sum1 = v[n];
            const V b = 1.0 - v[0];
            s[n] = b * x[n] - by_n * sum1;
            v[n] = by_n * sum0 + s[0] * x[n];
        }
        return at + 5;
    }
    case EXP: { /* e = exp(z), m = exp(z) - 1 */
        V *restrict e = r + at[1];
        V *restrict m = r + at[2];
        const V *q = r + at[3];
        const V *z = r + at[4];
        if (n == 0) {
            e[0] = IN(map)(exp, z[0]);
            m[0] = IN(map)(expm1, z[0]);
        } else {
            if (n % 2 == 0) {
                V sum0 = q[1] * e[n - 1], sum0_next = {0}, sum0_before = e[n - 1];
                for (int i = 1; 2 * i < n; i++) {
                    sum0_next += q[2 * i] * sum0_before; sum0_before = e[n - 2 * i];
                    sum0 += q[2 * i] * sum0_before; sum0_next += q[2 * i + 1] * sum0_before;
                    sum0_before = e[n - 2 * i - 1]; sum0 += q[2 * i + 1] * sum0_before;
                }
                e[n] = sum0, e[n + 1] = sum0_next;
            } else {
                e[n] = n > 1 ? e[n] + q[1] * e[n - 1] + q[n - 1] * e[1] : (V){0};
            }
            const V sum0 = e[n];
            e[n] = by_n * sum0 + e[0] * z[n];
            m[n] = e[n];
        }
        return at + 5;
    }
    case REC: { /* h = 1/(z + 1), m = -z/(z + 1) */
        V *restrict h = r + at[1];
        V *restrict m = r + at[2];
        const V *z = r + at[3];
        if (n == 0) {
            const V t1 = 1.0 + z[0];
            h[0] = 1.0 / t1;
            m[0] = -(z[0] / t1);
        } else {
            if (n % 2 == 0) {
                V sum0 = z[1] * h[n - 1], sum0_next = {0}, sum0_before = h[n - 1];
                for (int i = 1; 2 * i < n; i++) {
                    sum0_next += z[2 * i] * sum0_before; sum0_before = h[n - 2 * i];
                    sum0 += z[2 * i] * sum0_before; sum0_next += z[2 * i + 1] * sum0_before;
                    sum0_before = h[n - 2 * i - 1]; sum0 += z[2 * i + 1] * sum0_before;
                }
                h[n] = sum0, h[n + 1] = sum0_next;
            } else {
                h[n] = n > 1 ? h[n] + z[1] * h[n - 1] + z[n - 1] * h[1] : (V){0};
            }
            const V sum0 = h[n];
            h[n] = -((sum0 + h[0] * z[n]) * h[0]);
            m[n] = h[n];
        }
        return at + 4;
    }
    case LOG: { /* u = t*Derivative(z, t)/(z + 1), l = log(z + 1) */
        V *restrict u = r + at[1];
        V *restrict l = r + at[2];
        const V *q = r + at[3];
        const V *z = r + at[4];
        if (n == 0) {
            u[0] = (V){0};
            l[0] = IN(map)(log1p, z[0]);
        } else {
            if (n % 2 == 0) {
                V sum0 = u[1] * z[n - 1], sum0_next = {0}, sum0_before = z[n - 1];
                for (int i = 1; 2 * i < n; i++) {
                    sum0_next += u[2 * i] * sum0_before; sum0_before = z[n - 2 * i];
                    sum0 += u[2 * i] * sum0_before; sum0_next += u[2 * i + 1] * sum0_before;
                    sum0_before = z[n - 2 * i - 1]; sum0 += u[2 * i + 1] * sum0_before;
                }
                u[n] = sum0, u[n + 1] = sum0_next;
            } else {
                u[n] = n > 1 ? u[n] + u[1] * z[n - 1] + u[n - 1] * z[1] : (V){0};
            }
            const V sum0 = u[n];
            u[n] = (q[n] - sum0) / (1.0 + z[0]);
            l[n] = by_n * u[n];
        }
        return at + 5;
    }
    default:
        __builtin_unreachable();
    }
}

/* The operations on cells of a prologue, to their end, in some of the lanes: each its code, result and arguments. Each
 * operation jumps to the next one itself, so that the processor predicts where it leads. */
static void IN(prologue)(const int32_t *at, const int32_t *end, V *c, M here)
{
    static const void *const codes[] = { &&S_ADD, &&S_SUB, &&S_MUL, &&S_DIV, &&S_NEG, &&S_SIN, &&S_COS, &&S_TAN, &&S_EXP, &&S_EXPM1, &&S_LOG, &&S_LOG1P, &&S_SQRT, &&S_ABS, &&S_MIN, &&S_MAX, &&S_LESS, &&S_SELECT };
    V a, *d;
#define NEXT do { if (at >= end) return; a = c[at[2]], d = c + at[1]; goto *codes[at[0]]; } while (0)
    NEXT;
    S_ADD: { const V b = c[at[3]]; *d = IN(choose)(here, a + b, *d); at += 4; NEXT; }
    S_SUB: { const V b = c[at[3]]; *d = IN(choose)(here, a - b, *d); at += 4; NEXT; }
    S_MUL: { const V b = c[at[3]]; *d = IN(choose)(here, a * b, *d); at += 4; NEXT; }
    S_DIV: { const V b = c[at[3]]; *d = IN(choose)(here, a / b, *d); at += 4; NEXT; }
    S_NEG: { *d = IN(choose)(here, -a, *d); at += 3; NEXT; }
    S_SIN: { *d = IN(choose)(here, IN(map)(sin, a), *d); at += 3; NEXT; }
    S_COS: { *d = IN(choose)(here, IN(map)(cos, a), *d); at += 3; NEXT; }
    S_TAN: { *d = IN(choose)(here, IN(map)(tan, a), *d); at += 3; NEXT; }
    S_EXP: { *d = IN(choose)(here, IN(map)(exp, a), *d); at += 3; NEXT; }
    S_EXPM1: { *d = IN(choose)(here, IN(map)(expm1, a), *d); at += 3; NEXT; }
    S_LOG: { *d = IN(choose)(here, IN(map)(log, a), *d); at += 3; NEXT; }
    S_LOG1P: { *d = IN(choose)(here, IN(map)(log1p, a), *d); at += 3; NEXT; }
    S_SQRT: { *d = IN(choose)(here, IN(map)(sqrt, a), *d); at += 3; NEXT; }
    S_ABS: { *d = IN(choose)(here, IN(choose)(a < 0.0, -a, a), *d); at += 3; NEXT; }
    S_MIN: { const V b = c[at[3]]; *d = IN(choose)(here, IN(choose)(a < b, a, b), *d); at += 4; NEXT; }
    S_MAX: { const V b = c[at[3]]; *d = IN(choose)(here, IN(choose)(a < b, b, a), *d); at += 4; NEXT; }
    S_LESS: { const V b = c[at[3]]; *d = IN(choose)(here, IN(choose)(a < b, (V){0} + 1.0, (V){0}), *d); at += 4; NEXT; }
    S_SELECT: { const V b = c[at[3]]; const V e = c[at[4]]; *d = IN(choose)(here, IN(choose)(a > 0.0, b, e), *d); at += 5; NEXT; }
}

INLINE void prologue(Batch *b, M here)
{
    IN(prologue)(b->scalar, b->scalar_end, b->c, here);
    b->begun.changed |= b->scalar == b->job->scalar;
    b->scalar = b->job->scalar, b->scalar_end = b->job->scalar_end;
}

/* --- what the text asks of a program, of tables and of records --- */

#ifndef SMALL
#define HAS_STRAIGHT
#define ORDERS const int32_t *own, V *restrict r, const V *restrict c, int n, int behind, const double *inverse, int squares, \
               int moves
#define LATER const int32_t *own, V *restrict r, const V *restrict c, int top
static void orders_0(ORDERS)
{
    if (n == 0) {
        const V x0 = (r + 0)[n];
        const V x1 = (r + 42)[n];
        V x11 = (r + 462)[n];
        if (squares) {
            x11 = x1 * x1;
            (r + 462)[n] = x11;
        }
        V x2;
        {
            x2 = (V){0};
            (r + 84)[n] = x2;
        }
        V x3;
        V x4;
        {
            const V t1 = IN(map)(sin, 0.5 * x0);
            x3 = IN(map)(sin, x0);
            x4 = 2.0 * (t1 * t1);
            (r + 126)[n] = x3;
            (r + 168)[n] = x4;
        }
        V x5;
        V x6;
        V x7;
        V x8;
        V x9;
        V x10;
        {
            const V t1 = x0 * x0;
            const V t2 = x0 * t1;
            const V t3 = t1 * t1;
            x5 = t1;
            x6 = t2;
            x7 = t3;
            x8 = x0 * t3;
            x9 = t1 * t3;
            x10 = t2 * t3;
            (r + 210)[n] = x5;
            (r + 252)[n] = x6;
            (r + 294)[n] = x7;
            (r + 336)[n] = x8;
            (r + 378)[n] = x9;
            (r + 420)[n] = x10;
        }
        V x12;
        {
            x12 = c[own[32]];
            x12 += c[own[33]] * x0;
            x12 += c[own[34]] * x3;
            x12 += c[own[35]] * x4;
            x12 += c[own[36]] * x5;
            x12 += c[own[37]] * x6;
            x12 += c[own[38]] * x7;
            x12 += c[own[39]] * x8;
            x12 += c[own[40]] * x9;
            x12 += c[own[41]] * x10;
            x12 += c[own[42]] * x11;
            (r + 504)[n] = x12;
        }
        if (moves) {
            (r + 0)[n + 1] = x1 * inverse[n + 1];
            (r + 42)[n + 1] = x12 * inverse[n + 1];
        }
        n++;
    }
    for (; n < behind; n++) {
        const double by_n = inverse[n];
        if (n % 2 == 0) {
            V sum1 = (r + 84)[1] * (r + 126)[n - 1], sum1_next = {0}, sum1_before = (r + 126)[n - 1];
            V sum2 = (r + 84)[1] * (r + 168)[n - 1], sum2_next = {0}, sum2_before = (r + 168)[n - 1];
            for (int i = 1; 2 * i < n; i++) {
                sum1_next += (r + 84)[2 * i] * sum1_before; sum1_before = (r + 126)[n - 2 * i];
                sum1 += (r + 84)[2 * i] * sum1_before; sum1_next += (r + 84)[2 * i + 1] * sum1_before;
                sum1_before = (r + 126)[n - 2 * i - 1]; sum1 += (r + 84)[2 * i + 1] * sum1_before;
                sum2_next += (r + 84)[2 * i] * sum2_before; sum2_before = (r + 168)[n - 2 * i];
                sum2 += (r + 84)[2 * i] * sum2_before; sum2_next += (r + 84)[2 * i + 1] * sum2_before;
                sum2_before = (r + 168)[n - 2 * i - 1]; sum2 += (r + 84)[2 * i + 1] * sum2_before;
            }
            (r + 126)[n] = sum1, (r + 126)[n + 1] = sum1_next;
            (r + 168)[n] = sum2, (r + 168)[n + 1] = sum2_next;
        } else {
            (r + 126)[n] = n > 1 ? (r + 126)[n] + (r + 84)[1] * (r + 126)[n - 1] + (r + 84)[n - 1] * (r + 126)[1] : (V){0};
            (r + 168)[n] = n > 1 ? (r + 168)[n] + (r + 84)[1] * (r + 168)[n - 1] + (r + 84)[n - 1] * (r + 168)[1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum3 = (r + 0)[1] * (r + 210)[n - 1], sum3_next = {0}, sum3_before = (r + 210)[n - 1];
            V sum4 = (r + 0)[1] * (r + 252)[n - 1], sum4_next = {0}, sum4_before = (r + 252)[n - 1];
            for (int i = 1; 2 * i < n; i++) {
                sum3_next += (r + 0)[2 * i] * sum3_before; sum3_before = (r + 210)[n - 2 * i];
                sum3 += (r + 0)[2 * i] * sum3_before; sum3_next += (r + 0)[2 * i + 1] * sum3_before;
                sum3_before = (r + 210)[n - 2 * i - 1]; sum3 += (r + 0)[2 * i + 1] * sum3_before;
                sum4_next += (r + 0)[2 * i] * sum4_before; sum4_before = (r + 252)[n - 2 * i];
                sum4 += (r + 0)[2 * i] * sum4_before; sum4_next += (r + 0)[2 * i + 1] * sum4_before;
                sum4_before = (r + 252)[n - 2 * i - 1]; sum4 += (r + 0)[2 * i + 1] * sum4_before;
            }
            (r + 210)[n] = sum3, (r + 210)[n + 1] = sum3_next;
            (r + 252)[n] = sum4, (r + 252)[n + 1] = sum4_next;
        } else {
            (r + 210)[n] = n > 1 ? (r + 210)[n] + (r + 0)[1] * (r + 210)[n - 1] + (r + 0)[n - 1] * (r + 210)[1] : (V){0};
            (r + 252)[n] = n > 1 ? (r + 252)[n] + (r + 0)[1] * (r + 252)[n - 1] + (r + 0)[n - 1] * (r + 252)[1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum5 = (r + 0)[1] * (r + 294)[n - 1], sum5_next = {0}, sum5_before = (r + 294)[n - 1];
            V sum6 = (r + 0)[1] * (r + 336)[n - 1], sum6_next = {0}, sum6_before = (r + 336)[n - 1];
            for (int i = 1; 2 * i < n; i++) {
                sum5_next += (r + 0)[2 * i] * sum5_before; sum5_before = (r + 294)[n - 2 * i];
                sum5 += (r + 0)[2 * i] * sum5_before; sum5_next += (r + 0)[2 * i + 1] * sum5_before;
                sum5_before = (r + 294)[n - 2 * i - 1]; sum5 += (r + 0)[2 * i + 1] * sum5_before;
                sum6_next += (r + 0)[2 * i] * sum6_before; sum6_before = (r + 336)[n - 2 * i];
                sum6 += (r + 0)[2 * i] * sum6_before; sum6_next += (r + 0)[2 * i + 1] * sum6_before;
                sum6_before = (r + 336)[n - 2 * i - 1]; sum6 += (r + 0)[2 * i + 1] * sum6_before;
            }
            (r + 294)[n] = sum5, (r + 294)[n + 1] = sum5_next;
            (r + 336)[n] = sum6, (r + 336)[n + 1] = sum6_next;
        } else {
            (r + 294)[n] = n > 1 ? (r + 294)[n] + (r + 0)[1] * (r + 294)[n - 1] + (r + 0)[n - 1] * (r + 294)[1] : (V){0};
            (r + 336)[n] = n > 1 ? (r + 336)[n] + (r + 0)[1] * (r + 336)[n - 1] + (r + 0)[n - 1] * (r + 336)[1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum7 = (r + 0)[1] * (r + 378)[n - 1], sum7_next = {0}, sum7_before = (r + 378)[n - 1];
            V sum0 = {0}, sum0_next = {0};
            for (int i = 1; 2 * i < n; i++) {
                sum7_next += (r + 0)[2 * i] * sum7_before; sum7_before = (r + 378)[n - 2 * i];
                sum7 += (r + 0)[2 * i] * sum7_before; sum7_next += (r + 0)[2 * i + 1] * sum7_before;
                sum7_before = (r + 378)[n - 2 * i - 1]; sum7 += (r + 0)[2 * i + 1] * sum7_before;
                const V sum0_now = (r + 42)[n - i]; sum0 += (r + 42)[i] * sum0_now; sum0_next += (r + 42)[i + 1] * sum0_now;
            }
            (r + 378)[n] = sum7, (r + 378)[n + 1] = sum7_next;
            if (squares) (r + 462)[n] = 2.0 * sum0 + (r + 42)[n / 2] * (r + 42)[n / 2], (r + 462)[n + 1] = 2.0 * sum0_next;
        } else {
            (r + 378)[n] = n > 1 ? (r + 378)[n] + (r + 0)[1] * (r + 378)[n - 1] + (r + 0)[n - 1] * (r + 378)[1] : (V){0};
            if (squares) (r + 462)[n] = n > 1 ? (r + 462)[n] + 2.0 * (r + 42)[1] * (r + 42)[n - 1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum8 = {0}, sum8_next = {0};
            for (int i = 1; 2 * i < n; i++) {
                const V sum8_now = (r + 0)[n - i]; sum8 += (r + 0)[i] * sum8_now; sum8_next += (r + 0)[i + 1] * sum8_now;
            }
            (r + 420)[n] = 2.0 * sum8 + (r + 0)[n / 2] * (r + 0)[n / 2], (r + 420)[n + 1] = 2.0 * sum8_next;
        } else {
            (r + 420)[n] = n > 1 ? (r + 420)[n] + 2.0 * (r + 0)[1] * (r + 0)[n - 1] : (V){0};
        }
        const V x0 = (r + 0)[n];
        const V x1 = (r + 42)[n];
        V x11 = (r + 462)[n];
        if (squares) {
            const V sum0 = x11;
            x11 = sum0 + 2.0 * (r + 42)[0] * x1;
            (r + 462)[n] = x11;
        }
        V x2 = (r + 84)[n];
        {
            x2 = x0 * n;
            (r + 84)[n] = x2;
        }
        V x3 = (r + 126)[n];
        V x4 = (r + 168)[n];
        {
            const V sum0 = x3;
            const V sum1 = x4;
            const V b = 1.0 - (r + 168)[0];
            x3 = b * x0 - by_n * sum1;
            x4 = by_n * sum0 + (r + 126)[0] * x0;
            (r + 126)[n] = x3;
            (r + 168)[n] = x4;
        }
        V x5 = (r + 210)[n];
        V x6 = (r + 252)[n];
        V x7 = (r + 294)[n];
        V x8 = (r + 336)[n];
        V x9 = (r + 378)[n];
        V x10 = (r + 420)[n];
        {
            const V sum0 = x5;
            const V sum1 = x6;
            const V sum2 = x7;
            const V sum3 = x8;
            const V sum4 = x9;
            const V sum5 = x10;
            x5 = sum5 + 2.0 * (r + 0)[0] * x0;
            x6 = sum0 + (r + 210)[0] * x0 + x5 * (r + 0)[0];
            x7 = sum1 + (r + 252)[0] * x0 + x6 * (r + 0)[0];
            x8 = sum2 + (r + 294)[0] * x0 + x7 * (r + 0)[0];
            x9 = sum3 + (r + 336)[0] * x0 + x8 * (r + 0)[0];
            x10 = sum4 + (r + 378)[0] * x0 + x9 * (r + 0)[0];
            (r + 210)[n] = x5;
            (r + 252)[n] = x6;
            (r + 294)[n] = x7;
            (r + 336)[n] = x8;
            (r + 378)[n] = x9;
            (r + 420)[n] = x10;
        }
        V x12;
        {
            x12 = (V){0};
            x12 += c[own[33]] * x0;
            x12 += c[own[34]] * x3;
            x12 += c[own[35]] * x4;
            x12 += c[own[36]] * x5;
            x12 += c[own[37]] * x6;
            x12 += c[own[38]] * x7;
            x12 += c[own[39]] * x8;
            x12 += c[own[40]] * x9;
            x12 += c[own[41]] * x10;
            x12 += c[own[42]] * x11;
            (r + 504)[n] = x12;
        }
        if (moves) {
            (r + 0)[n + 1] = x1 * inverse[n + 1];
            (r + 42)[n + 1] = x12 * inverse[n + 1];
        }
    }
}
static void later_0(LATER)
{
    int n = 0;
    const V x0 = (r + 0)[n];
    const V x3 = (r + 126)[n];
    const V x4 = (r + 168)[n];
    const V x5 = (r + 210)[n];
    const V x6 = (r + 252)[n];
    const V x7 = (r + 294)[n];
    const V x8 = (r + 336)[n];
    const V x9 = (r + 378)[n];
    const V x10 = (r + 420)[n];
    const V x11 = (r + 462)[n];
    V x13;
    {
        x13 = c[own[56]];
        x13 += c[own[57]] * x0;
        x13 += c[own[58]] * x3;
        x13 += c[own[59]] * x4;
        x13 += c[own[60]] * x5;
        x13 += c[own[61]] * x6;
        x13 += c[own[62]] * x7;
        x13 += c[own[63]] * x8;
        x13 += c[own[64]] * x9;
        x13 += c[own[65]] * x10;
        x13 += c[own[66]] * x11;
        (r + 546)[n] = x13;
    }
    V x14;
    {
        x14 = c[own[72]];
        x14 += c[own[73]] * x3;
        x14 += c[own[74]] * x4;
        (r + 588)[n] = x14;
    }
    for (n = 1; n < top; n++) {
        const V x0 = (r + 0)[n];
        const V x3 = (r + 126)[n];
        const V x4 = (r + 168)[n];
        const V x5 = (r + 210)[n];
        const V x6 = (r + 252)[n];
        const V x7 = (r + 294)[n];
        const V x8 = (r + 336)[n];
        const V x9 = (r + 378)[n];
        const V x10 = (r + 420)[n];
        const V x11 = (r + 462)[n];
        V x13;
        {
            x13 = (V){0};
            x13 += c[own[57]] * x0;
            x13 += c[own[58]] * x3;
            x13 += c[own[59]] * x4;
            x13 += c[own[60]] * x5;
            x13 += c[own[61]] * x6;
            x13 += c[own[62]] * x7;
            x13 += c[own[63]] * x8;
            x13 += c[own[64]] * x9;
            x13 += c[own[65]] * x10;
            x13 += c[own[66]] * x11;
            (r + 546)[n] = x13;
        }
        V x14;
        {
            x14 = (V){0};
            x14 += c[own[73]] * x3;
            x14 += c[own[74]] * x4;
            (r + 588)[n] = x14;
        }
    }
}
static void orders_1(ORDERS)
{
    if (n == 0) {
        const V x0 = (r + 0)[n];
        const V x1 = (r + 42)[n];
        const V x2 = (r + 84)[n];
        V x8 = (r + 336)[n];
        if (squares) {
            x8 = x1 * x1;
            (r + 336)[n] = x8;
        }
        V x3;
        {
            x3 = (V){0};
            (r + 126)[n] = x3;
        }
        V x4;
        V x5;
        {
            const V t1 = IN(map)(sin, 0.5 * x0);
            x4 = IN(map)(sin, x0);
            x5 = 2.0 * (t1 * t1);
            (r + 168)[n] = x4;
            (r + 210)[n] = x5;
        }
        V x6;
        {
            x6 = x2 * x4;
            (r + 252)[n] = x6;
        }
        V x7;
        {
            x7 = x2 * x5;
            (r + 294)[n] = x7;
        }
        V x9;
        {
            x9 = c[own[28]];
            x9 += c[own[29]] * x2;
            x9 += c[own[30]] * x4;
            x9 += c[own[31]] * x5;
            x9 += c[own[32]] * x6;
            x9 += c[own[33]] * x7;
            x9 += c[own[34]] * x8;
            (r + 378)[n] = x9;
        }
        if (moves) {
            (r + 0)[n + 1] = x1 * inverse[n + 1];
            (r + 42)[n + 1] = x9 * inverse[n + 1];
        }
        n++;
    }
    for (; n < behind; n++) {
        const double by_n = inverse[n];
        if (n % 2 == 0) {
            V sum1 = (r + 126)[1] * (r + 168)[n - 1], sum1_next = {0}, sum1_before = (r + 168)[n - 1];
            V sum2 = (r + 126)[1] * (r + 210)[n - 1], sum2_next = {0}, sum2_before = (r + 210)[n - 1];
            for (int i = 1; 2 * i < n; i++) {
                sum1_next += (r + 126)[2 * i] * sum1_before; sum1_before = (r + 168)[n - 2 * i];
                sum1 += (r + 126)[2 * i] * sum1_before; sum1_next += (r + 126)[2 * i + 1] * sum1_before;
                sum1_before = (r + 168)[n - 2 * i - 1]; sum1 += (r + 126)[2 * i + 1] * sum1_before;
                sum2_next += (r + 126)[2 * i] * sum2_before; sum2_before = (r + 210)[n - 2 * i];
                sum2 += (r + 126)[2 * i] * sum2_before; sum2_next += (r + 126)[2 * i + 1] * sum2_before;
                sum2_before = (r + 210)[n - 2 * i - 1]; sum2 += (r + 126)[2 * i + 1] * sum2_before;
            }
            (r + 168)[n] = sum1, (r + 168)[n + 1] = sum1_next;
            (r + 210)[n] = sum2, (r + 210)[n + 1] = sum2_next;
        } else {
            (r + 168)[n] = n > 1 ? (r + 168)[n] + (r + 126)[1] * (r + 168)[n - 1] + (r + 126)[n - 1] * (r + 168)[1] : (V){0};
            (r + 210)[n] = n > 1 ? (r + 210)[n] + (r + 126)[1] * (r + 210)[n - 1] + (r + 126)[n - 1] * (r + 210)[1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum3 = (r + 84)[1] * (r + 168)[n - 1], sum3_next = {0}, sum3_before = (r + 168)[n - 1];
            V sum4 = (r + 84)[1] * (r + 210)[n - 1], sum4_next = {0}, sum4_before = (r + 210)[n - 1];
            for (int i = 1; 2 * i < n; i++) {
                sum3_next += (r + 84)[2 * i] * sum3_before; sum3_before = (r + 168)[n - 2 * i];
                sum3 += (r + 84)[2 * i] * sum3_before; sum3_next += (r + 84)[2 * i + 1] * sum3_before;
                sum3_before = (r + 168)[n - 2 * i - 1]; sum3 += (r + 84)[2 * i + 1] * sum3_before;
                sum4_next += (r + 84)[2 * i] * sum4_before; sum4_before = (r + 210)[n - 2 * i];
                sum4 += (r + 84)[2 * i] * sum4_before; sum4_next += (r + 84)[2 * i + 1] * sum4_before;
                sum4_before = (r + 210)[n - 2 * i - 1]; sum4 += (r + 84)[2 * i + 1] * sum4_before;
            }
            (r + 252)[n] = sum3, (r + 252)[n + 1] = sum3_next;
            (r + 294)[n] = sum4, (r + 294)[n + 1] = sum4_next;
        } else {
            (r + 252)[n] = n > 1 ? (r + 252)[n] + (r + 84)[1] * (r + 168)[n - 1] + (r + 84)[n - 1] * (r + 168)[1] : (V){0};
            (r + 294)[n] = n > 1 ? (r + 294)[n] + (r + 84)[1] * (r + 210)[n - 1] + (r + 84)[n - 1] * (r + 210)[1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum0 = {0}, sum0_next = {0};
            for (int i = 1; 2 * i < n; i++) {
                const V sum0_now = (r + 42)[n - i]; sum0 += (r + 42)[i] * sum0_now; sum0_next += (r + 42)[i + 1] * sum0_now;
            }
            if (squares) (r + 336)[n] = 2.0 * sum0 + (r + 42)[n / 2] * (r + 42)[n / 2], (r + 336)[n + 1] = 2.0 * sum0_next;
        } else {
            if (squares) (r + 336)[n] = n > 1 ? (r + 336)[n] + 2.0 * (r + 42)[1] * (r + 42)[n - 1] : (V){0};
        }
        const V x0 = (r + 0)[n];
        const V x1 = (r + 42)[n];
        const V x2 = (r + 84)[n];
        V x8 = (r + 336)[n];
        if (squares) {
            const V sum0 = x8;
            x8 = sum0 + 2.0 * (r + 42)[0] * x1;
            (r + 336)[n] = x8;
        }
        V x3 = (r + 126)[n];
        {
            x3 = x0 * n;
            (r + 126)[n] = x3;
        }
        V x4 = (r + 168)[n];
        V x5 = (r + 210)[n];
        {
            const V sum0 = x4;
            const V sum1 = x5;
            const V b = 1.0 - (r + 210)[0];
            x4 = b * x0 - by_n * sum1;
            x5 = by_n * sum0 + (r + 168)[0] * x0;
            (r + 168)[n] = x4;
            (r + 210)[n] = x5;
        }
        V x6 = (r + 252)[n];
        {
            const V sum0 = x6;
            x6 = sum0 + (r + 84)[0] * x4 + x2 * (r + 168)[0];
            (r + 252)[n] = x6;
        }
        V x7 = (r + 294)[n];
        {
            const V sum0 = x7;
            x7 = sum0 + (r + 84)[0] * x5 + x2 * (r + 210)[0];
            (r + 294)[n] = x7;
        }
        V x9;
        {
            x9 = (V){0};
            x9 += c[own[29]] * x2;
            x9 += c[own[30]] * x4;
            x9 += c[own[31]] * x5;
            x9 += c[own[32]] * x6;
            x9 += c[own[33]] * x7;
            x9 += c[own[34]] * x8;
            (r + 378)[n] = x9;
        }
        if (moves) {
            (r + 0)[n + 1] = x1 * inverse[n + 1];
            (r + 42)[n + 1] = x9 * inverse[n + 1];
        }
    }
}
static void later_1(LATER)
{
    int n = 0;
    const V x2 = (r + 84)[n];
    const V x4 = (r + 168)[n];
    const V x5 = (r + 210)[n];
    const V x6 = (r + 252)[n];
    const V x7 = (r + 294)[n];
    const V x8 = (r + 336)[n];
    V x10;
    {
        x10 = c[own[44]];
        x10 += c[own[45]] * x2;
        x10 += c[own[46]] * x4;
        x10 += c[own[47]] * x5;
        x10 += c[own[48]] * x6;
        x10 += c[own[49]] * x7;
        x10 += c[own[50]] * x8;
        (r + 420)[n] = x10;
    }
    V x11;
    {
        x11 = c[own[56]];
        x11 += c[own[57]] * x4;
        x11 += c[own[58]] * x5;
        (r + 462)[n] = x11;
    }
    for (n = 1; n < top; n++) {
        const V x2 = (r + 84)[n];
        const V x4 = (r + 168)[n];
        const V x5 = (r + 210)[n];
        const V x6 = (r + 252)[n];
        const V x7 = (r + 294)[n];
        const V x8 = (r + 336)[n];
        V x10;
        {
            x10 = (V){0};
            x10 += c[own[45]] * x2;
            x10 += c[own[46]] * x4;
            x10 += c[own[47]] * x5;
            x10 += c[own[48]] * x6;
            x10 += c[own[49]] * x7;
            x10 += c[own[50]] * x8;
            (r + 420)[n] = x10;
        }
        V x11;
        {
            x11 = (V){0};
            x11 += c[own[57]] * x4;
            x11 += c[own[58]] * x5;
            (r + 462)[n] = x11;
        }
    }
}
static void orders_2(ORDERS)
{
    if (n == 0) {
        const V x0 = (r + 0)[n];
        const V x1 = (r + 42)[n];
        const V x2 = (r + 84)[n];
        const V x3 = (r + 126)[n];
        V x11 = (r + 462)[n];
        if (squares) {
            x11 = x1 * x1;
            (r + 462)[n] = x11;
        }
        V x4;
        {
            x4 = (V){0};
            (r + 168)[n] = x4;
        }
        V x5;
        V x6;
        {
            const V t1 = IN(map)(sin, 0.5 * x0);
            x5 = IN(map)(sin, x0);
            x6 = 2.0 * (t1 * t1);
            (r + 210)[n] = x5;
            (r + 252)[n] = x6;
        }
        V x7;
        {
            x7 = x2 * x5;
            (r + 294)[n] = x7;
        }
        V x8;
        {
            x8 = x2 * x6;
            (r + 336)[n] = x8;
        }
        V x9;
        {
            x9 = x3 * x5;
            (r + 378)[n] = x9;
        }
        V x10;
        {
            x10 = x3 * x6;
            (r + 420)[n] = x10;
        }
        V x12;
        {
            x12 = c[own[39]];
            x12 += c[own[40]] * x2;
            x12 += c[own[41]] * x3;
            x12 += c[own[42]] * x5;
            x12 += c[own[43]] * x6;
            x12 += c[own[44]] * x7;
            x12 += c[own[45]] * x8;
            x12 += c[own[46]] * x9;
            x12 += c[own[47]] * x10;
            x12 += c[own[48]] * x11;
            (r + 504)[n] = x12;
        }
        if (moves) {
            (r + 0)[n + 1] = x1 * inverse[n + 1];
            (r + 42)[n + 1] = x12 * inverse[n + 1];
        }
        n++;
    }
    for (; n < behind; n++) {
        const double by_n = inverse[n];
        if (n % 2 == 0) {
            V sum1 = (r + 168)[1] * (r + 210)[n - 1], sum1_next = {0}, sum1_before = (r + 210)[n - 1];
            V sum2 = (r + 168)[1] * (r + 252)[n - 1], sum2_next = {0}, sum2_before = (r + 252)[n - 1];
            for (int i = 1; 2 * i < n; i++) {
                sum1_next += (r + 168)[2 * i] * sum1_before; sum1_before = (r + 210)[n - 2 * i];
                sum1 += (r + 168)[2 * i] * sum1_before; sum1_next += (r + 168)[2 * i + 1] * sum1_before;
                sum1_before = (r + 210)[n - 2 * i - 1]; sum1 += (r + 168)[2 * i + 1] * sum1_before;
                sum2_next += (r + 168)[2 * i] * sum2_before; sum2_before = (r + 252)[n - 2 * i];
                sum2 += (r + 168)[2 * i] * sum2_before; sum2_next += (r + 168)[2 * i + 1] * sum2_before;
                sum2_before = (r + 252)[n - 2 * i - 1]; sum2 += (r + 168)[2 * i + 1] * sum2_before;
            }
            (r + 210)[n] = sum1, (r + 210)[n + 1] = sum1_next;
            (r + 252)[n] = sum2, (r + 252)[n + 1] = sum2_next;
        } else {
            (r + 210)[n] = n > 1 ? (r + 210)[n] + (r + 168)[1] * (r + 210)[n - 1] + (r + 168)[n - 1] * (r + 210)[1] : (V){0};
            (r + 252)[n] = n > 1 ? (r + 252)[n] + (r + 168)[1] * (r + 252)[n - 1] + (r + 168)[n - 1] * (r + 252)[1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum3 = (r + 84)[1] * (r + 210)[n - 1], sum3_next = {0}, sum3_before = (r + 210)[n - 1];
            V sum4 = (r + 84)[1] * (r + 252)[n - 1], sum4_next = {0}, sum4_before = (r + 252)[n - 1];
            for (int i = 1; 2 * i < n; i++) {
                sum3_next += (r + 84)[2 * i] * sum3_before; sum3_before = (r + 210)[n - 2 * i];
                sum3 += (r + 84)[2 * i] * sum3_before; sum3_next += (r + 84)[2 * i + 1] * sum3_before;
                sum3_before = (r + 210)[n - 2 * i - 1]; sum3 += (r + 84)[2 * i + 1] * sum3_before;
                sum4_next += (r + 84)[2 * i] * sum4_before; sum4_before = (r + 252)[n - 2 * i];
                sum4 += (r + 84)[2 * i] * sum4_before; sum4_next += (r + 84)[2 * i + 1] * sum4_before;
                sum4_before = (r + 252)[n - 2 * i - 1]; sum4 += (r + 84)[2 * i + 1] * sum4_before;
            }
            (r + 294)[n] = sum3, (r + 294)[n + 1] = sum3_next;
            (r + 336)[n] = sum4, (r + 336)[n + 1] = sum4_next;
        } else {
            (r + 294)[n] = n > 1 ? (r + 294)[n] + (r + 84)[1] * (r + 210)[n - 1] + (r + 84)[n - 1] * (r + 210)[1] : (V){0};
            (r + 336)[n] = n > 1 ? (r + 336)[n] + (r + 84)[1] * (r + 252)[n - 1] + (r + 84)[n - 1] * (r + 252)[1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum5 = (r + 126)[1] * (r + 210)[n - 1], sum5_next = {0}, sum5_before = (r + 210)[n - 1];
            V sum6 = (r + 126)[1] * (r + 252)[n - 1], sum6_next = {0}, sum6_before = (r + 252)[n - 1];
            for (int i = 1; 2 * i < n; i++) {
                sum5_next += (r + 126)[2 * i] * sum5_before; sum5_before = (r + 210)[n - 2 * i];
                sum5 += (r + 126)[2 * i] * sum5_before; sum5_next += (r + 126)[2 * i + 1] * sum5_before;
                sum5_before = (r + 210)[n - 2 * i - 1]; sum5 += (r + 126)[2 * i + 1] * sum5_before;
                sum6_next += (r + 126)[2 * i] * sum6_before; sum6_before = (r + 252)[n - 2 * i];
                sum6 += (r + 126)[2 * i] * sum6_before; sum6_next += (r + 126)[2 * i + 1] * sum6_before;
                sum6_before = (r + 252)[n - 2 * i - 1]; sum6 += (r + 126)[2 * i + 1] * sum6_before;
            }
            (r + 378)[n] = sum5, (r + 378)[n + 1] = sum5_next;
            (r + 420)[n] = sum6, (r + 420)[n + 1] = sum6_next;
        } else {
            (r + 378)[n] = n > 1 ? (r + 378)[n] + (r + 126)[1] * (r + 210)[n - 1] + (r + 126)[n - 1] * (r + 210)[1] : (V){0};
            (r + 420)[n] = n > 1 ? (r + 420)[n] + (r + 126)[1] * (r + 252)[n - 1] + (r + 126)[n - 1] * (r + 252)[1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum0 = {0}, sum0_next = {0};
            for (int i = 1; 2 * i < n; i++) {
                const V sum0_now = (r + 42)[n - i]; sum0 += (r + 42)[i] * sum0_now; sum0_next += (r + 42)[i + 1] * sum0_now;
            }
            if (squares) (r + 462)[n] = 2.0 * sum0 + (r + 42)[n / 2] * (r + 42)[n / 2], (r + 462)[n + 1] = 2.0 * sum0_next;
        } else {
            if (squares) (r + 462)[n] = n > 1 ? (r + 462)[n] + 2.0 * (r + 42)[1] * (r + 42)[n - 1] : (V){0};
        }
        const V x0 = (r + 0)[n];
        const V x1 = (r + 42)[n];
        const V x2 = (r + 84)[n];
        const V x3 = (r + 126)[n];
        V x11 = (r + 462)[n];
        if (squares) {
            const V sum0 = x11;
            x11 = sum0 + 2.0 * (r + 42)[0] * x1;
            (r + 462)[n] = x11;
        }
        V x4 = (r + 168)[n];
        {
            x4 = x0 * n;
            (r + 168)[n] = x4;
        }
        V x5 = (r + 210)[n];
        V x6 = (r + 252)[n];
        {
            const V sum0 = x5;
            const V sum1 = x6;
            const V b = 1.0 - (r + 252)[0];
            x5 = b * x0 - by_n * sum1;
            x6 = by_n * sum0 + (r + 210)[0] * x0;
            (r + 210)[n] = x5;
            (r + 252)[n] = x6;
        }
        V x7 = (r + 294)[n];
        {
            const V sum0 = x7;
            x7 = sum0 + (r + 84)[0] * x5 + x2 * (r + 210)[0];
            (r + 294)[n] = x7;
        }
        V x8 = (r + 336)[n];
        {
            const V sum0 = x8;
            x8 = sum0 + (r + 84)[0] * x6 + x2 * (r + 252)[0];
            (r + 336)[n] = x8;
        }
        V x9 = (r + 378)[n];
        {
            const V sum0 = x9;
            x9 = sum0 + (r + 126)[0] * x5 + x3 * (r + 210)[0];
            (r + 378)[n] = x9;
        }
        V x10 = (r + 420)[n];
        {
            const V sum0 = x10;
            x10 = sum0 + (r + 126)[0] * x6 + x3 * (r + 252)[0];
            (r + 420)[n] = x10;
        }
        V x12;
        {
            x12 = (V){0};
            x12 += c[own[40]] * x2;
            x12 += c[own[41]] * x3;
            x12 += c[own[42]] * x5;
            x12 += c[own[43]] * x6;
            x12 += c[own[44]] * x7;
            x12 += c[own[45]] * x8;
            x12 += c[own[46]] * x9;
            x12 += c[own[47]] * x10;
            x12 += c[own[48]] * x11;
            (r + 504)[n] = x12;
        }
        if (moves) {
            (r + 0)[n + 1] = x1 * inverse[n + 1];
            (r + 42)[n + 1] = x12 * inverse[n + 1];
        }
    }
}
static void later_2(LATER)
{
    int n = 0;
    const V x2 = (r + 84)[n];
    const V x3 = (r + 126)[n];
    const V x5 = (r + 210)[n];
    const V x6 = (r + 252)[n];
    const V x7 = (r + 294)[n];
    const V x8 = (r + 336)[n];
    const V x9 = (r + 378)[n];
    const V x10 = (r + 420)[n];
    const V x11 = (r + 462)[n];
    V x13;
    {
        x13 = c[own[61]];
        x13 += c[own[62]] * x2;
        x13 += c[own[63]] * x3;
        x13 += c[own[64]] * x5;
        x13 += c[own[65]] * x6;
        x13 += c[own[66]] * x7;
        x13 += c[own[67]] * x8;
        x13 += c[own[68]] * x9;
        x13 += c[own[69]] * x10;
        x13 += c[own[70]] * x11;
        (r + 546)[n] = x13;
    }
    V x14;
    {
        x14 = c[own[76]];
        x14 += c[own[77]] * x5;
        x14 += c[own[78]] * x6;
        (r + 588)[n] = x14;
    }
    for (n = 1; n < top; n++) {
        const V x2 = (r + 84)[n];
        const V x3 = (r + 126)[n];
        const V x5 = (r + 210)[n];
        const V x6 = (r + 252)[n];
        const V x7 = (r + 294)[n];
        const V x8 = (r + 336)[n];
        const V x9 = (r + 378)[n];
        const V x10 = (r + 420)[n];
        const V x11 = (r + 462)[n];
        V x13;
        {
            x13 = (V){0};
            x13 += c[own[62]] * x2;
            x13 += c[own[63]] * x3;
            x13 += c[own[64]] * x5;
            x13 += c[own[65]] * x6;
            x13 += c[own[66]] * x7;
            x13 += c[own[67]] * x8;
            x13 += c[own[68]] * x9;
            x13 += c[own[69]] * x10;
            x13 += c[own[70]] * x11;
            (r + 546)[n] = x13;
        }
        V x14;
        {
            x14 = (V){0};
            x14 += c[own[77]] * x5;
            x14 += c[own[78]] * x6;
            (r + 588)[n] = x14;
        }
    }
}
static void orders_3(ORDERS)
{
    if (n == 0) {
        const V x0 = (r + 0)[n];
        const V x1 = (r + 42)[n];
        V x10 = (r + 420)[n];
        if (squares) {
            x10 = x1 * x1;
            (r + 420)[n] = x10;
        }
        V x2;
        {
            x2 = (V){0};
            (r + 84)[n] = x2;
        }
        V x3;
        V x4;
        {
            const V t1 = IN(map)(sin, 0.5 * x0);
            x3 = IN(map)(sin, x0);
            x4 = 2.0 * (t1 * t1);
            (r + 126)[n] = x3;
            (r + 168)[n] = x4;
        }
        V x5;
        {
            x5 = c[own[15]];
            x5 += c[own[16]] * x0;
            (r + 210)[n] = x5;
        }
        V x6;
        {
            x6 = (V){0};
            (r + 252)[n] = x6;
        }
        V x7;
        V x8;
        {
            x7 = IN(map)(exp, x5);
            x8 = IN(map)(expm1, x5);
            (r + 294)[n] = x7;
            (r + 336)[n] = x8;
        }
        V x9;
        {
            x9 = c[own[29]];
            x9 += c[own[30]] * x8;
            (r + 378)[n] = x9;
        }
        V x11;
        {
            x11 = c[own[37]];
            x11 += c[own[38]] * x3;
            x11 += c[own[39]] * x4;
            x11 += c[own[40]] * x10;
            (r + 462)[n] = x11;
        }
        V x12;
        {
            x12 = x9 * x11;
            (r + 504)[n] = x12;
        }
        V x13;
        {
            x13 = c[own[53]];
            x13 += c[own[54]] * x3;
            x13 += c[own[55]] * x4;
            x13 += c[own[56]] * x9;
            x13 += c[own[57]] * x11;
            x13 += c[own[58]] * x12;
            (r + 546)[n] = x13;
        }
        if (moves) {
            (r + 0)[n + 1] = x1 * inverse[n + 1];
            (r + 42)[n + 1] = x13 * inverse[n + 1];
        }
        n++;
    }
    for (; n < behind; n++) {
        const double by_n = inverse[n];
        if (n % 2 == 0) {
            V sum1 = (r + 84)[1] * (r + 126)[n - 1], sum1_next = {0}, sum1_before = (r + 126)[n - 1];
            V sum2 = (r + 84)[1] * (r + 168)[n - 1], sum2_next = {0}, sum2_before = (r + 168)[n - 1];
            for (int i = 1; 2 * i < n; i++) {
                sum1_next += (r + 84)[2 * i] * sum1_before; sum1_before = (r + 126)[n - 2 * i];
                sum1 += (r + 84)[2 * i] * sum1_before; sum1_next += (r + 84)[2 * i + 1] * sum1_before;
                sum1_before = (r + 126)[n - 2 * i - 1]; sum1 += (r + 84)[2 * i + 1] * sum1_before;
                sum2_next += (r + 84)[2 * i] * sum2_before; sum2_before = (r + 168)[n - 2 * i];
                sum2 += (r + 84)[2 * i] * sum2_before; sum2_next += (r + 84)[2 * i + 1] * sum2_before;
                sum2_before = (r + 168)[n - 2 * i - 1]; sum2 += (r + 84)[2 * i + 1] * sum2_before;
            }
            (r + 126)[n] = sum1, (r + 126)[n + 1] = sum1_next;
            (r + 168)[n] = sum2, (r + 168)[n + 1] = sum2_next;
        } else {
            (r + 126)[n] = n > 1 ? (r + 126)[n] + (r + 84)[1] * (r + 126)[n - 1] + (r + 84)[n - 1] * (r + 126)[1] : (V){0};
            (r + 168)[n] = n > 1 ? (r + 168)[n] + (r + 84)[1] * (r + 168)[n - 1] + (r + 84)[n - 1] * (r + 168)[1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum3 = (r + 252)[1] * (r + 294)[n - 1], sum3_next = {0}, sum3_before = (r + 294)[n - 1];
            V sum4 = (r + 378)[1] * (r + 462)[n - 1], sum4_next = {0}, sum4_before = (r + 462)[n - 1];
            for (int i = 1; 2 * i < n; i++) {
                sum3_next += (r + 252)[2 * i] * sum3_before; sum3_before = (r + 294)[n - 2 * i];
                sum3 += (r + 252)[2 * i] * sum3_before; sum3_next += (r + 252)[2 * i + 1] * sum3_before;
                sum3_before = (r + 294)[n - 2 * i - 1]; sum3 += (r + 252)[2 * i + 1] * sum3_before;
                sum4_next += (r + 378)[2 * i] * sum4_before; sum4_before = (r + 462)[n - 2 * i];
                sum4 += (r + 378)[2 * i] * sum4_before; sum4_next += (r + 378)[2 * i + 1] * sum4_before;
                sum4_before = (r + 462)[n - 2 * i - 1]; sum4 += (r + 378)[2 * i + 1] * sum4_before;
            }
            (r + 294)[n] = sum3, (r + 294)[n + 1] = sum3_next;
            (r + 504)[n] = sum4, (r + 504)[n + 1] = sum4_next;
        } else {
            (r + 294)[n] = n > 1 ? (r + 294)[n] + (r + 252)[1] * (r + 294)[n - 1] + (r + 252)[n - 1] * (r + 294)[1] : (V){0};
            (r + 504)[n] = n > 1 ? (r + 504)[n] + (r + 378)[1] * (r + 462)[n - 1] + (r + 378)[n - 1] * (r + 462)[1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum0 = {0}, sum0_next = {0};
            for (int i = 1; 2 * i < n; i++) {
                const V sum0_now = (r + 42)[n - i]; sum0 += (r + 42)[i] * sum0_now; sum0_next += (r + 42)[i + 1] * sum0_now;
            }
            if (squares) (r + 420)[n] = 2.0 * sum0 + (r + 42)[n / 2] * (r + 42)[n / 2], (r + 420)[n + 1] = 2.0 * sum0_next;
        } else {
            if (squares) (r + 420)[n] = n > 1 ? (r + 420)[n] + 2.0 * (r + 42)[1] * (r + 42)[n - 1] : (V){0};
        }
        const V x0 = (r + 0)[n];
        const V x1 = (r + 42)[n];
        V x10 = (r + 420)[n];
        if (squares) {
            const V sum0 = x10;
            x10 = sum0 + 2.0 * (r + 42)[0] * x1;
            (r + 420)[n] = x10;
        }
        V x2 = (r + 84)[n];
        {
            x2 = x0 * n;
            (r + 84)[n] = x2;
        }
        V x3 = (r + 126)[n];
        V x4 = (r + 168)[n];
        {
            const V sum0 = x3;
            const V sum1 = x4;
            const V b = 1.0 - (r + 168)[0];
            x3 = b * x0 - by_n * sum1;
            x4 = by_n * sum0 + (r + 126)[0] * x0;
            (r + 126)[n] = x3;
            (r + 168)[n] = x4;
        }
        V x5;
        {
            x5 = (V){0};
            x5 += c[own[16]] * x0;
            (r + 210)[n] = x5;
        }
        V x6 = (r + 252)[n];
        {
            x6 = x5 * n;
            (r + 252)[n] = x6;
        }
        V x7 = (r + 294)[n];
        V x8 = (r + 336)[n];
        {
            const V sum0 = x7;
            x7 = by_n * sum0 + (r + 294)[0] * x5;
            x8 = x7;
            (r + 294)[n] = x7;
            (r + 336)[n] = x8;
        }
        V x9;
        {
            x9 = (V){0};
            x9 += c[own[30]] * x8;
            (r + 378)[n] = x9;
        }
        V x11;
        {
            x11 = (V){0};
            x11 += c[own[38]] * x3;
            x11 += c[own[39]] * x4;
            x11 += c[own[40]] * x10;
            (r + 462)[n] = x11;
        }
        V x12 = (r + 504)[n];
        {
            const V sum0 = x12;
            x12 = sum0 + (r + 378)[0] * x11 + x9 * (r + 462)[0];
            (r + 504)[n] = x12;
        }
        V x13;
        {
            x13 = (V){0};
            x13 += c[own[54]] * x3;
            x13 += c[own[55]] * x4;
            x13 += c[own[56]] * x9;
            x13 += c[own[57]] * x11;
            x13 += c[own[58]] * x12;
            (r + 546)[n] = x13;
        }
        if (moves) {
            (r + 0)[n + 1] = x1 * inverse[n + 1];
            (r + 42)[n + 1] = x13 * inverse[n + 1];
        }
    }
}
static void later_3(LATER)
{
    int n = 0;
    const V x3 = (r + 126)[n];
    const V x4 = (r + 168)[n];
    const V x11 = (r + 462)[n];
    V x14;
    {
        x14 = c[own[63]];
        x14 += c[own[64]] * x11;
        (r + 588)[n] = x14;
    }
    V x15;
    {
        x15 = c[own[70]];
        x15 += c[own[71]] * x3;
        x15 += c[own[72]] * x4;
        (r + 630)[n] = x15;
    }
    for (n = 1; n < top; n++) {
        const V x3 = (r + 126)[n];
        const V x4 = (r + 168)[n];
        const V x11 = (r + 462)[n];
        V x14;
        {
            x14 = (V){0};
            x14 += c[own[64]] * x11;
            (r + 588)[n] = x14;
        }
        V x15;
        {
            x15 = (V){0};
            x15 += c[own[71]] * x3;
            x15 += c[own[72]] * x4;
            (r + 630)[n] = x15;
        }
    }
}
static void orders_4(ORDERS)
{
    if (n == 0) {
        const V x0 = (r + 0)[n];
        const V x1 = (r + 42)[n];
        V x16 = (r + 672)[n];
        if (squares) {
            x16 = x1 * x1;
            (r + 672)[n] = x16;
        }
        V x2;
        {
            x2 = (V){0};
            (r + 84)[n] = x2;
        }
        V x3;
        V x4;
        {
            const V t1 = IN(map)(sin, 0.5 * x0);
            x3 = IN(map)(sin, x0);
            x4 = 2.0 * (t1 * t1);
            (r + 126)[n] = x3;
            (r + 168)[n] = x4;
        }
        V x5;
        {
            x5 = c[own[15]];
            x5 += c[own[16]] * x0;
            (r + 210)[n] = x5;
        }
        V x6;
        {
            x6 = (V){0};
            (r + 252)[n] = x6;
        }
        V x7;
        V x8;
        {
            x7 = IN(map)(exp, x5);
            x8 = IN(map)(expm1, x5);
            (r + 294)[n] = x7;
            (r + 336)[n] = x8;
        }
        V x9;
        {
            x9 = c[own[29]];
            x9 += c[own[30]] * x8;
            (r + 378)[n] = x9;
        }
        V x10;
        V x11;
        V x12;
        V x13;
        V x14;
        V x15;
        {
            const V t1 = x0 * x0;
            const V t2 = x0 * t1;
            const V t3 = t1 * t1;
            x10 = t1;
            x11 = t2;
            x12 = t3;
            x13 = x0 * t3;
            x14 = t1 * t3;
            x15 = t2 * t3;
            (r + 420)[n] = x10;
            (r + 462)[n] = x11;
            (r + 504)[n] = x12;
            (r + 546)[n] = x13;
            (r + 588)[n] = x14;
            (r + 630)[n] = x15;
        }
        V x17;
        {
            x17 = c[own[52]];
            x17 += c[own[53]] * x0;
            x17 += c[own[54]] * x3;
            x17 += c[own[55]] * x4;
            x17 += c[own[56]] * x10;
            x17 += c[own[57]] * x11;
            x17 += c[own[58]] * x12;
            x17 += c[own[59]] * x13;
            x17 += c[own[60]] * x14;
            x17 += c[own[61]] * x15;
            x17 += c[own[62]] * x16;
            (r + 714)[n] = x17;
        }
        V x18;
        {
            x18 = x9 * x17;
            (r + 756)[n] = x18;
        }
        V x19;
        {
            x19 = c[own[75]];
            x19 += c[own[76]] * x3;
            x19 += c[own[77]] * x4;
            x19 += c[own[78]] * x9;
            x19 += c[own[79]] * x17;
            x19 += c[own[80]] * x18;
            (r + 798)[n] = x19;
        }
        if (moves) {
            (r + 0)[n + 1] = x1 * inverse[n + 1];
            (r + 42)[n + 1] = x19 * inverse[n + 1];
        }
        n++;
    }
    for (; n < behind; n++) {
        const double by_n = inverse[n];
        if (n % 2 == 0) {
            V sum1 = (r + 84)[1] * (r + 126)[n - 1], sum1_next = {0}, sum1_before = (r + 126)[n - 1];
            V sum2 = (r + 84)[1] * (r + 168)[n - 1], sum2_next = {0}, sum2_before = (r + 168)[n - 1];
            for (int i = 1; 2 * i < n; i++) {
                sum1_next += (r + 84)[2 * i] * sum1_before; sum1_before = (r + 126)[n - 2 * i];
                sum1 += (r + 84)[2 * i] * sum1_before; sum1_next += (r + 84)[2 * i + 1] * sum1_before;
                sum1_before = (r + 126)[n - 2 * i - 1]; sum1 += (r + 84)[2 * i + 1] * sum1_before;
                sum2_next += (r + 84)[2 * i] * sum2_before; sum2_before = (r + 168)[n - 2 * i];
                sum2 += (r + 84)[2 * i] * sum2_before; sum2_next += (r + 84)[2 * i + 1] * sum2_before;
                sum2_before = (r + 168)[n - 2 * i - 1]; sum2 += (r + 84)[2 * i + 1] * sum2_before;
            }
            (r + 126)[n] = sum1, (r + 126)[n + 1] = sum1_next;
            (r + 168)[n] = sum2, (r + 168)[n + 1] = sum2_next;
        } else {
            (r + 126)[n] = n > 1 ? (r + 126)[n] + (r + 84)[1] * (r + 126)[n - 1] + (r + 84)[n - 1] * (r + 126)[1] : (V){0};
            (r + 168)[n] = n > 1 ? (r + 168)[n] + (r + 84)[1] * (r + 168)[n - 1] + (r + 84)[n - 1] * (r + 168)[1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum3 = (r + 252)[1] * (r + 294)[n - 1], sum3_next = {0}, sum3_before = (r + 294)[n - 1];
            V sum4 = (r + 0)[1] * (r + 420)[n - 1], sum4_next = {0}, sum4_before = (r + 420)[n - 1];
            for (int i = 1; 2 * i < n; i++) {
                sum3_next += (r + 252)[2 * i] * sum3_before; sum3_before = (r + 294)[n - 2 * i];
                sum3 += (r + 252)[2 * i] * sum3_before; sum3_next += (r + 252)[2 * i + 1] * sum3_before;
                sum3_before = (r + 294)[n - 2 * i - 1]; sum3 += (r + 252)[2 * i + 1] * sum3_before;
                sum4_next += (r + 0)[2 * i] * sum4_before; sum4_before = (r + 420)[n - 2 * i];
                sum4 += (r + 0)[2 * i] * sum4_before; sum4_next += (r + 0)[2 * i + 1] * sum4_before;
                sum4_before = (r + 420)[n - 2 * i - 1]; sum4 += (r + 0)[2 * i + 1] * sum4_before;
            }
            (r + 294)[n] = sum3, (r + 294)[n + 1] = sum3_next;
            (r + 420)[n] = sum4, (r + 420)[n + 1] = sum4_next;
        } else {
            (r + 294)[n] = n > 1 ? (r + 294)[n] + (r + 252)[1] * (r + 294)[n - 1] + (r + 252)[n - 1] * (r + 294)[1] : (V){0};
            (r + 420)[n] = n > 1 ? (r + 420)[n] + (r + 0)[1] * (r + 420)[n - 1] + (r + 0)[n - 1] * (r + 420)[1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum5 = (r + 0)[1] * (r + 462)[n - 1], sum5_next = {0}, sum5_before = (r + 462)[n - 1];
            V sum6 = (r + 0)[1] * (r + 504)[n - 1], sum6_next = {0}, sum6_before = (r + 504)[n - 1];
            for (int i = 1; 2 * i < n; i++) {
                sum5_next += (r + 0)[2 * i] * sum5_before; sum5_before = (r + 462)[n - 2 * i];
                sum5 += (r + 0)[2 * i] * sum5_before; sum5_next += (r + 0)[2 * i + 1] * sum5_before;
                sum5_before = (r + 462)[n - 2 * i - 1]; sum5 += (r + 0)[2 * i + 1] * sum5_before;
                sum6_next += (r + 0)[2 * i] * sum6_before; sum6_before = (r + 504)[n - 2 * i];
                sum6 += (r + 0)[2 * i] * sum6_before; sum6_next += (r + 0)[2 * i + 1] * sum6_before;
                sum6_before = (r + 504)[n - 2 * i - 1]; sum6 += (r + 0)[2 * i + 1] * sum6_before;
            }
            (r + 462)[n] = sum5, (r + 462)[n + 1] = sum5_next;
            (r + 504)[n] = sum6, (r + 504)[n + 1] = sum6_next;
        } else {
            (r + 462)[n] = n > 1 ? (r + 462)[n] + (r + 0)[1] * (r + 462)[n - 1] + (r + 0)[n - 1] * (r + 462)[1] : (V){0};
            (r + 504)[n] = n > 1 ? (r + 504)[n] + (r + 0)[1] * (r + 504)[n - 1] + (r + 0)[n - 1] * (r + 504)[1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum7 = (r + 0)[1] * (r + 546)[n - 1], sum7_next = {0}, sum7_before = (r + 546)[n - 1];
            V sum8 = (r + 0)[1] * (r + 588)[n - 1], sum8_next = {0}, sum8_before = (r + 588)[n - 1];
            for (int i = 1; 2 * i < n; i++) {
                sum7_next += (r + 0)[2 * i] * sum7_before; sum7_before = (r + 546)[n - 2 * i];
                sum7 += (r + 0)[2 * i] * sum7_before; sum7_next += (r + 0)[2 * i + 1] * sum7_before;
                sum7_before = (r + 546)[n - 2 * i - 1]; sum7 += (r + 0)[2 * i + 1] * sum7_before;
                sum8_next += (r + 0)[2 * i] * sum8_before; sum8_before = (r + 588)[n - 2 * i];
                sum8 += (r + 0)[2 * i] * sum8_before; sum8_next += (r + 0)[2 * i + 1] * sum8_before;
                sum8_before = (r + 588)[n - 2 * i - 1]; sum8 += (r + 0)[2 * i + 1] * sum8_before;
            }
            (r + 546)[n] = sum7, (r + 546)[n + 1] = sum7_next;
            (r + 588)[n] = sum8, (r + 588)[n + 1] = sum8_next;
        } else {
            (r + 546)[n] = n > 1 ? (r + 546)[n] + (r + 0)[1] * (r + 546)[n - 1] + (r + 0)[n - 1] * (r + 546)[1] : (V){0};
            (r + 588)[n] = n > 1 ? (r + 588)[n] + (r + 0)[1] * (r + 588)[n - 1] + (r + 0)[n - 1] * (r + 588)[1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum10 = (r + 378)[1] * (r + 714)[n - 1], sum10_next = {0}, sum10_before = (r + 714)[n - 1];
            V sum0 = {0}, sum0_next = {0};
            for (int i = 1; 2 * i < n; i++) {
                sum10_next += (r + 378)[2 * i] * sum10_before; sum10_before = (r + 714)[n - 2 * i];
                sum10 += (r + 378)[2 * i] * sum10_before; sum10_next += (r + 378)[2 * i + 1] * sum10_before;
                sum10_before = (r + 714)[n - 2 * i - 1]; sum10 += (r + 378)[2 * i + 1] * sum10_before;
                const V sum0_now = (r + 42)[n - i]; sum0 += (r + 42)[i] * sum0_now; sum0_next += (r + 42)[i + 1] * sum0_now;
            }
            (r + 756)[n] = sum10, (r + 756)[n + 1] = sum10_next;
            if (squares) (r + 672)[n] = 2.0 * sum0 + (r + 42)[n / 2] * (r + 42)[n / 2], (r + 672)[n + 1] = 2.0 * sum0_next;
        } else {
            (r + 756)[n] = n > 1 ? (r + 756)[n] + (r + 378)[1] * (r + 714)[n - 1] + (r + 378)[n - 1] * (r + 714)[1] : (V){0};
            if (squares) (r + 672)[n] = n > 1 ? (r + 672)[n] + 2.0 * (r + 42)[1] * (r + 42)[n - 1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum9 = {0}, sum9_next = {0};
            for (int i = 1; 2 * i < n; i++) {
                const V sum9_now = (r + 0)[n - i]; sum9 += (r + 0)[i] * sum9_now; sum9_next += (r + 0)[i + 1] * sum9_now;
            }
            (r + 630)[n] = 2.0 * sum9 + (r + 0)[n / 2] * (r + 0)[n / 2], (r + 630)[n + 1] = 2.0 * sum9_next;
        } else {
            (r + 630)[n] = n > 1 ? (r + 630)[n] + 2.0 * (r + 0)[1] * (r + 0)[n - 1] : (V){0};
        }
        const V x0 = (r + 0)[n];
        const V x1 = (r + 42)[n];
        V x16 = (r + 672)[n];
        if (squares) {
            const V sum0 = x16;
            x16 = sum0 + 2.0 * (r + 42)[0] * x1;
            (r + 672)[n] = x16;
        }
        V x2 = (r + 84)[n];
        {
            x2 = x0 * n;
            (r + 84)[n] = x2;
        }
        V x3 = (r + 126)[n];
        V x4 = (r + 168)[n];
        {
            const V sum0 = x3;
            const V sum1 = x4;
            const V b = 1.0 - (r + 168)[0];
            x3 = b * x0 - by_n * sum1;
            x4 = by_n * sum0 + (r + 126)[0] * x0;
            (r + 126)[n] = x3;
            (r + 168)[n] = x4;
        }
        V x5;
        {
            x5 = (V){0};
            x5 += c[own[16]] * x0;
            (r + 210)[n] = x5;
        }
        V x6 = (r + 252)[n];
        {
            x6 = x5 * n;
            (r + 252)[n] = x6;
        }
        V x7 = (r + 294)[n];
        V x8 = (r + 336)[n];
        {
            const V sum0 = x7;
            x7 = by_n * sum0 + (r + 294)[0] * x5;
            x8 = x7;
            (r + 294)[n] = x7;
            (r + 336)[n] = x8;
        }
        V x9;
        {
            x9 = (V){0};
            x9 += c[own[30]] * x8;
            (r + 378)[n] = x9;
        }
        V x10 = (r + 420)[n];
        V x11 = (r + 462)[n];
        V x12 = (r + 504)[n];
        V x13 = (r + 546)[n];
        V x14 = (r + 588)[n];
        V x15 = (r + 630)[n];
        {
            const V sum0 = x10;
            const V sum1 = x11;
            const V sum2 = x12;
            const V sum3 = x13;
            const V sum4 = x14;
            const V sum5 = x15;
            x10 = sum5 + 2.0 * (r + 0)[0] * x0;
            x11 = sum0 + (r + 420)[0] * x0 + x10 * (r + 0)[0];
            x12 = sum1 + (r + 462)[0] * x0 + x11 * (r + 0)[0];
            x13 = sum2 + (r + 504)[0] * x0 + x12 * (r + 0)[0];
            x14 = sum3 + (r + 546)[0] * x0 + x13 * (r + 0)[0];
            x15 = sum4 + (r + 588)[0] * x0 + x14 * (r + 0)[0];
            (r + 420)[n] = x10;
            (r + 462)[n] = x11;
            (r + 504)[n] = x12;
            (r + 546)[n] = x13;
            (r + 588)[n] = x14;
            (r + 630)[n] = x15;
        }
        V x17;
        {
            x17 = (V){0};
            x17 += c[own[53]] * x0;
            x17 += c[own[54]] * x3;
            x17 += c[own[55]] * x4;
            x17 += c[own[56]] * x10;
            x17 += c[own[57]] * x11;
            x17 += c[own[58]] * x12;
            x17 += c[own[59]] * x13;
            x17 += c[own[60]] * x14;
            x17 += c[own[61]] * x15;
            x17 += c[own[62]] * x16;
            (r + 714)[n] = x17;
        }
        V x18 = (r + 756)[n];
        {
            const V sum0 = x18;
            x18 = sum0 + (r + 378)[0] * x17 + x9 * (r + 714)[0];
            (r + 756)[n] = x18;
        }
        V x19;
        {
            x19 = (V){0};
            x19 += c[own[76]] * x3;
            x19 += c[own[77]] * x4;
            x19 += c[own[78]] * x9;
            x19 += c[own[79]] * x17;
            x19 += c[own[80]] * x18;
            (r + 798)[n] = x19;
        }
        if (moves) {
            (r + 0)[n + 1] = x1 * inverse[n + 1];
            (r + 42)[n + 1] = x19 * inverse[n + 1];
        }
    }
}
static void later_4(LATER)
{
    int n = 0;
    const V x3 = (r + 126)[n];
    const V x4 = (r + 168)[n];
    const V x17 = (r + 714)[n];
    V x20;
    {
        x20 = c[own[85]];
        x20 += c[own[86]] * x17;
        (r + 840)[n] = x20;
    }
    V x21;
    {
        x21 = c[own[92]];
        x21 += c[own[93]] * x3;
        x21 += c[own[94]] * x4;
        (r + 882)[n] = x21;
    }
    for (n = 1; n < top; n++) {
        const V x3 = (r + 126)[n];
        const V x4 = (r + 168)[n];
        const V x17 = (r + 714)[n];
        V x20;
        {
            x20 = (V){0};
            x20 += c[own[86]] * x17;
            (r + 840)[n] = x20;
        }
        V x21;
        {
            x21 = (V){0};
            x21 += c[own[93]] * x3;
            x21 += c[own[94]] * x4;
            (r + 882)[n] = x21;
        }
    }
}
static void orders_5(ORDERS)
{
    if (n == 0) {
        const V x0 = (r + 0)[n];
        const V x1 = (r + 42)[n];
        const V x2 = (r + 84)[n];
        V x13 = (r + 546)[n];
        if (squares) {
            x13 = x1 * x1;
            (r + 546)[n] = x13;
        }
        V x3;
        {
            x3 = (V){0};
            (r + 126)[n] = x3;
        }
        V x4;
        V x5;
        {
            const V t1 = IN(map)(sin, 0.5 * x0);
            x4 = IN(map)(sin, x0);
            x5 = 2.0 * (t1 * t1);
            (r + 168)[n] = x4;
            (r + 210)[n] = x5;
        }
        V x6;
        {
            x6 = x2 * x4;
            (r + 252)[n] = x6;
        }
        V x7;
        {
            x7 = x2 * x5;
            (r + 294)[n] = x7;
        }
        V x8;
        {
            x8 = c[own[23]];
            x8 += c[own[24]] * x0;
            (r + 336)[n] = x8;
        }
        V x9;
        {
            x9 = (V){0};
            (r + 378)[n] = x9;
        }
        V x10;
        V x11;
        {
            x10 = IN(map)(exp, x8);
            x11 = IN(map)(expm1, x8);
            (r + 420)[n] = x10;
            (r + 462)[n] = x11;
        }
        V x12;
        {
            x12 = c[own[37]];
            x12 += c[own[38]] * x11;
            (r + 504)[n] = x12;
        }
        V x14;
        {
            x14 = c[own[48]];
            x14 += c[own[49]] * x2;
            x14 += c[own[50]] * x4;
            x14 += c[own[51]] * x5;
            x14 += c[own[52]] * x6;
            x14 += c[own[53]] * x7;
            x14 += c[own[54]] * x13;
            (r + 588)[n] = x14;
        }
        V x15;
        {
            x15 = x12 * x14;
            (r + 630)[n] = x15;
        }
        V x16;
        {
            x16 = c[own[70]];
            x16 += c[own[71]] * x2;
            x16 += c[own[72]] * x4;
            x16 += c[own[73]] * x5;
            x16 += c[own[74]] * x6;
            x16 += c[own[75]] * x7;
            x16 += c[own[76]] * x12;
            x16 += c[own[77]] * x14;
            x16 += c[own[78]] * x15;
            (r + 672)[n] = x16;
        }
        if (moves) {
            (r + 0)[n + 1] = x1 * inverse[n + 1];
            (r + 42)[n + 1] = x16 * inverse[n + 1];
        }
        n++;
    }
    for (; n < behind; n++) {
        const double by_n = inverse[n];
        if (n % 2 == 0) {
            V sum1 = (r + 126)[1] * (r + 168)[n - 1], sum1_next = {0}, sum1_before = (r + 168)[n - 1];
            V sum2 = (r + 126)[1] * (r + 210)[n - 1], sum2_next = {0}, sum2_before = (r + 210)[n - 1];
            for (int i = 1; 2 * i < n; i++) {
                sum1_next += (r + 126)[2 * i] * sum1_before; sum1_before = (r + 168)[n - 2 * i];
                sum1 += (r + 126)[2 * i] * sum1_before; sum1_next += (r + 126)[2 * i + 1] * sum1_before;
                sum1_before = (r + 168)[n - 2 * i - 1]; sum1 += (r + 126)[2 * i + 1] * sum1_before;
                sum2_next += (r + 126)[2 * i] * sum2_before; sum2_before = (r + 210)[n - 2 * i];
                sum2 += (r + 126)[2 * i] * sum2_before; sum2_next += (r + 126)[2 * i + 1] * sum2_before;
                sum2_before = (r + 210)[n - 2 * i - 1]; sum2 += (r + 126)[2 * i + 1] * sum2_before;
            }
            (r + 168)[n] = sum1, (r + 168)[n + 1] = sum1_next;
            (r + 210)[n] = sum2, (r + 210)[n + 1] = sum2_next;
        } else {
            (r + 168)[n] = n > 1 ? (r + 168)[n] + (r + 126)[1] * (r + 168)[n - 1] + (r + 126)[n - 1] * (r + 168)[1] : (V){0};
            (r + 210)[n] = n > 1 ? (r + 210)[n] + (r + 126)[1] * (r + 210)[n - 1] + (r + 126)[n - 1] * (r + 210)[1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum3 = (r + 84)[1] * (r + 168)[n - 1], sum3_next = {0}, sum3_before = (r + 168)[n - 1];
            V sum4 = (r + 84)[1] * (r + 210)[n - 1], sum4_next = {0}, sum4_before = (r + 210)[n - 1];
            for (int i = 1; 2 * i < n; i++) {
                sum3_next += (r + 84)[2 * i] * sum3_before; sum3_before = (r + 168)[n - 2 * i];
                sum3 += (r + 84)[2 * i] * sum3_before; sum3_next += (r + 84)[2 * i + 1] * sum3_before;
                sum3_before = (r + 168)[n - 2 * i - 1]; sum3 += (r + 84)[2 * i + 1] * sum3_before;
                sum4_next += (r + 84)[2 * i] * sum4_before; sum4_before = (r + 210)[n - 2 * i];
                sum4 += (r + 84)[2 * i] * sum4_before; sum4_next += (r + 84)[2 * i + 1] * sum4_before;
                sum4_before = (r + 210)[n - 2 * i - 1]; sum4 += (r + 84)[2 * i + 1] * sum4_before;
            }
            (r + 252)[n] = sum3, (r + 252)[n + 1] = sum3_next;
            (r + 294)[n] = sum4, (r + 294)[n + 1] = sum4_next;
        } else {
            (r + 252)[n] = n > 1 ? (r + 252)[n] + (r + 84)[1] * (r + 168)[n - 1] + (r + 84)[n - 1] * (r + 168)[1] : (V){0};
            (r + 294)[n] = n > 1 ? (r + 294)[n] + (r + 84)[1] * (r + 210)[n - 1] + (r + 84)[n - 1] * (r + 210)[1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum5 = (r + 378)[1] * (r + 420)[n - 1], sum5_next = {0}, sum5_before = (r + 420)[n - 1];
            V sum6 = (r + 504)[1] * (r + 588)[n - 1], sum6_next = {0}, sum6_before = (r + 588)[n - 1];
            for (int i = 1; 2 * i < n; i++) {
                sum5_next += (r + 378)[2 * i] * sum5_before; sum5_before = (r + 420)[n - 2 * i];
                sum5 += (r + 378)[2 * i] * sum5_before; sum5_next += (r + 378)[2 * i + 1] * sum5_before;
                sum5_before = (r + 420)[n - 2 * i - 1]; sum5 += (r + 378)[2 * i + 1] * sum5_before;
                sum6_next += (r + 504)[2 * i] * sum6_before; sum6_before = (r + 588)[n - 2 * i];
                sum6 += (r + 504)[2 * i] * sum6_before; sum6_next += (r + 504)[2 * i + 1] * sum6_before;
                sum6_before = (r + 588)[n - 2 * i - 1]; sum6 += (r + 504)[2 * i + 1] * sum6_before;
            }
            (r + 420)[n] = sum5, (r + 420)[n + 1] = sum5_next;
            (r + 630)[n] = sum6, (r + 630)[n + 1] = sum6_next;
        } else {
            (r + 420)[n] = n > 1 ? (r + 420)[n] + (r + 378)[1] * (r + 420)[n - 1] + (r + 378)[n - 1] * (r + 420)[1] : (V){0};
            (r + 630)[n] = n > 1 ? (r + 630)[n] + (r + 504)[1] * (r + 588)[n - 1] + (r + 504)[n - 1] * (r + 588)[1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum0 = {0}, sum0_next = {0};
            for (int i = 1; 2 * i < n; i++) {
                const V sum0_now = (r + 42)[n - i]; sum0 += (r + 42)[i] * sum0_now; sum0_next += (r + 42)[i + 1] * sum0_now;
            }
            if (squares) (r + 546)[n] = 2.0 * sum0 + (r + 42)[n / 2] * (r + 42)[n / 2], (r + 546)[n + 1] = 2.0 * sum0_next;
        } else {
            if (squares) (r + 546)[n] = n > 1 ? (r + 546)[n] + 2.0 * (r + 42)[1] * (r + 42)[n - 1] : (V){0};
        }
        const V x0 = (r + 0)[n];
        const V x1 = (r + 42)[n];
        const V x2 = (r + 84)[n];
        V x13 = (r + 546)[n];
        if (squares) {
            const V sum0 = x13;
            x13 = sum0 + 2.0 * (r + 42)[0] * x1;
            (r + 546)[n] = x13;
        }
        V x3 = (r + 126)[n];
        {
            x3 = x0 * n;
            (r + 126)[n] = x3;
        }
        V x4 = (r + 168)[n];
        V x5 = (r + 210)[n];
        {
            const V sum0 = x4;
            const V sum1 = x5;
            const V b = 1.0 - (r + 210)[0];
            x4 = b * x0 - by_n * sum1;
            x5 = by_n * sum0 + (r + 168)[0] * x0;
            (r + 168)[n] = x4;
            (r + 210)[n] = x5;
        }
        V x6 = (r + 252)[n];
        {
            const V sum0 = x6;
            x6 = sum0 + (r + 84)[0] * x4 + x2 * (r + 168)[0];
            (r + 252)[n] = x6;
        }
        V x7 = (r + 294)[n];
        {
            const V sum0 = x7;
            x7 = sum0 + (r + 84)[0] * x5 + x2 * (r + 210)[0];
            (r + 294)[n] = x7;
        }
        V x8;
        {
            x8 = (V){0};
            x8 += c[own[24]] * x0;
            (r + 336)[n] = x8;
        }
        V x9 = (r + 378)[n];
        {
            x9 = x8 * n;
            (r + 378)[n] = x9;
        }
        V x10 = (r + 420)[n];
        V x11 = (r + 462)[n];
        {
            const V sum0 = x10;
            x10 = by_n * sum0 + (r + 420)[0] * x8;
            x11 = x10;
            (r + 420)[n] = x10;
            (r + 462)[n] = x11;
        }
        V x12;
        {
            x12 = (V){0};
            x12 += c[own[38]] * x11;
            (r + 504)[n] = x12;
        }
        V x14;
        {
            x14 = (V){0};
            x14 += c[own[49]] * x2;
            x14 += c[own[50]] * x4;
            x14 += c[own[51]] * x5;
            x14 += c[own[52]] * x6;
            x14 += c[own[53]] * x7;
            x14 += c[own[54]] * x13;
            (r + 588)[n] = x14;
        }
        V x15 = (r + 630)[n];
        {
            const V sum0 = x15;
            x15 = sum0 + (r + 504)[0] * x14 + x12 * (r + 588)[0];
            (r + 630)[n] = x15;
        }
        V x16;
        {
            x16 = (V){0};
            x16 += c[own[71]] * x2;
            x16 += c[own[72]] * x4;
            x16 += c[own[73]] * x5;
            x16 += c[own[74]] * x6;
            x16 += c[own[75]] * x7;
            x16 += c[own[76]] * x12;
            x16 += c[own[77]] * x14;
            x16 += c[own[78]] * x15;
            (r + 672)[n] = x16;
        }
        if (moves) {
            (r + 0)[n + 1] = x1 * inverse[n + 1];
            (r + 42)[n + 1] = x16 * inverse[n + 1];
        }
    }
}
static void later_5(LATER)
{
    int n = 0;
    const V x4 = (r + 168)[n];
    const V x5 = (r + 210)[n];
    const V x14 = (r + 588)[n];
    V x17;
    {
        x17 = c[own[83]];
        x17 += c[own[84]] * x14;
        (r + 714)[n] = x17;
    }
    V x18;
    {
        x18 = c[own[90]];
        x18 += c[own[91]] * x4;
        x18 += c[own[92]] * x5;
        (r + 756)[n] = x18;
    }
    for (n = 1; n < top; n++) {
        const V x4 = (r + 168)[n];
        const V x5 = (r + 210)[n];
        const V x14 = (r + 588)[n];
        V x17;
        {
            x17 = (V){0};
            x17 += c[own[84]] * x14;
            (r + 714)[n] = x17;
        }
        V x18;
        {
            x18 = (V){0};
            x18 += c[own[91]] * x4;
            x18 += c[own[92]] * x5;
            (r + 756)[n] = x18;
        }
    }
}
static void orders_6(ORDERS)
{
    if (n == 0) {
        const V x0 = (r + 0)[n];
        const V x1 = (r + 42)[n];
        const V x2 = (r + 84)[n];
        const V x3 = (r + 126)[n];
        V x16 = (r + 672)[n];
        if (squares) {
            x16 = x1 * x1;
            (r + 672)[n] = x16;
        }
        V x4;
        {
            x4 = (V){0};
            (r + 168)[n] = x4;
        }
        V x5;
        V x6;
        {
            const V t1 = IN(map)(sin, 0.5 * x0);
            x5 = IN(map)(sin, x0);
            x6 = 2.0 * (t1 * t1);
            (r + 210)[n] = x5;
            (r + 252)[n] = x6;
        }
        V x7;
        {
            x7 = x2 * x5;
            (r + 294)[n] = x7;
        }
        V x8;
        {
            x8 = x2 * x6;
            (r + 336)[n] = x8;
        }
        V x9;
        {
            x9 = x3 * x5;
            (r + 378)[n] = x9;
        }
        V x10;
        {
            x10 = x3 * x6;
            (r + 420)[n] = x10;
        }
        V x11;
        {
            x11 = c[own[31]];
            x11 += c[own[32]] * x0;
            (r + 462)[n] = x11;
        }
        V x12;
        {
            x12 = (V){0};
            (r + 504)[n] = x12;
        }
        V x13;
        V x14;
        {
            x13 = IN(map)(exp, x11);
            x14 = IN(map)(expm1, x11);
            (r + 546)[n] = x13;
            (r + 588)[n] = x14;
        }
        V x15;
        {
            x15 = c[own[45]];
            x15 += c[own[46]] * x14;
            (r + 630)[n] = x15;
        }
        V x17;
        {
            x17 = c[own[59]];
            x17 += c[own[60]] * x2;
            x17 += c[own[61]] * x3;
            x17 += c[own[62]] * x5;
            x17 += c[own[63]] * x6;
            x17 += c[own[64]] * x7;
            x17 += c[own[65]] * x8;
            x17 += c[own[66]] * x9;
            x17 += c[own[67]] * x10;
            x17 += c[own[68]] * x16;
            (r + 714)[n] = x17;
        }
        V x18;
        {
            x18 = x15 * x17;
            (r + 756)[n] = x18;
        }
        V x19;
        {
            x19 = c[own[87]];
            x19 += c[own[88]] * x2;
            x19 += c[own[89]] * x3;
            x19 += c[own[90]] * x5;
            x19 += c[own[91]] * x6;
            x19 += c[own[92]] * x7;
            x19 += c[own[93]] * x8;
            x19 += c[own[94]] * x9;
            x19 += c[own[95]] * x10;
            x19 += c[own[96]] * x15;
            x19 += c[own[97]] * x17;
            x19 += c[own[98]] * x18;
            (r + 798)[n] = x19;
        }
        if (moves) {
            (r + 0)[n + 1] = x1 * inverse[n + 1];
            (r + 42)[n + 1] = x19 * inverse[n + 1];
        }
        n++;
    }
    for (; n < behind; n++) {
        const double by_n = inverse[n];
        if (n % 2 == 0) {
            V sum1 = (r + 168)[1] * (r + 210)[n - 1], sum1_next = {0}, sum1_before = (r + 210)[n - 1];
            V sum2 = (r + 168)[1] * (r + 252)[n - 1], sum2_next = {0}, sum2_before = (r + 252)[n - 1];
            for (int i = 1; 2 * i < n; i++) {
                sum1_next += (r + 168)[2 * i] * sum1_before; sum1_before = (r + 210)[n - 2 * i];
                sum1 += (r + 168)[2 * i] * sum1_before; sum1_next += (r + 168)[2 * i + 1] * sum1_before;
                sum1_before = (r + 210)[n - 2 * i - 1]; sum1 += (r + 168)[2 * i + 1] * sum1_before;
                sum2_next += (r + 168)[2 * i] * sum2_before; sum2_before = (r + 252)[n - 2 * i];
                sum2 += (r + 168)[2 * i] * sum2_before; sum2_next += (r + 168)[2 * i + 1] * sum2_before;
                sum2_before = (r + 252)[n - 2 * i - 1]; sum2 += (r + 168)[2 * i + 1] * sum2_before;
            }
            (r + 210)[n] = sum1, (r + 210)[n + 1] = sum1_next;
            (r + 252)[n] = sum2, (r + 252)[n + 1] = sum2_next;
        } else {
            (r + 210)[n] = n > 1 ? (r + 210)[n] + (r + 168)[1] * (r + 210)[n - 1] + (r + 168)[n - 1] * (r + 210)[1] : (V){0};
            (r + 252)[n] = n > 1 ? (r + 252)[n] + (r + 168)[1] * (r + 252)[n - 1] + (r + 168)[n - 1] * (r + 252)[1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum3 = (r + 84)[1] * (r + 210)[n - 1], sum3_next = {0}, sum3_before = (r + 210)[n - 1];
            V sum4 = (r + 84)[1] * (r + 252)[n - 1], sum4_next = {0}, sum4_before = (r + 252)[n - 1];
            for (int i = 1; 2 * i < n; i++) {
                sum3_next += (r + 84)[2 * i] * sum3_before; sum3_before = (r + 210)[n - 2 * i];
                sum3 += (r + 84)[2 * i] * sum3_before; sum3_next += (r + 84)[2 * i + 1] * sum3_before;
                sum3_before = (r + 210)[n - 2 * i - 1]; sum3 += (r + 84)[2 * i + 1] * sum3_before;
                sum4_next += (r + 84)[2 * i] * sum4_before; sum4_before = (r + 252)[n - 2 * i];
                sum4 += (r + 84)[2 * i] * sum4_before; sum4_next += (r + 84)[2 * i + 1] * sum4_before;
                sum4_before = (r + 252)[n - 2 * i - 1]; sum4 += (r + 84)[2 * i + 1] * sum4_before;
            }
            (r + 294)[n] = sum3, (r + 294)[n + 1] = sum3_next;
            (r + 336)[n] = sum4, (r + 336)[n + 1] = sum4_next;
        } else {
            (r + 294)[n] = n > 1 ? (r + 294)[n] + (r + 84)[1] * (r + 210)[n - 1] + (r + 84)[n - 1] * (r + 210)[1] : (V){0};
            (r + 336)[n] = n > 1 ? (r + 336)[n] + (r + 84)[1] * (r + 252)[n - 1] + (r + 84)[n - 1] * (r + 252)[1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum5 = (r + 126)[1] * (r + 210)[n - 1], sum5_next = {0}, sum5_before = (r + 210)[n - 1];
            V sum6 = (r + 126)[1] * (r + 252)[n - 1], sum6_next = {0}, sum6_before = (r + 252)[n - 1];
            for (int i = 1; 2 * i < n; i++) {
                sum5_next += (r + 126)[2 * i] * sum5_before; sum5_before = (r + 210)[n - 2 * i];
                sum5 += (r + 126)[2 * i] * sum5_before; sum5_next += (r + 126)[2 * i + 1] * sum5_before;
                sum5_before = (r + 210)[n - 2 * i - 1]; sum5 += (r + 126)[2 * i + 1] * sum5_before;
                sum6_next += (r + 126)[2 * i] * sum6_before; sum6_before = (r + 252)[n - 2 * i];
                sum6 += (r + 126)[2 * i] * sum6_before; sum6_next += (r + 126)[2 * i + 1] * sum6_before;
                sum6_before = (r + 252)[n - 2 * i - 1]; sum6 += (r + 126)[2 * i + 1] * sum6_before;
            }
            (r + 378)[n] = sum5, (r + 378)[n + 1] = sum5_next;
            (r + 420)[n] = sum6, (r + 420)[n + 1] = sum6_next;
        } else {
            (r + 378)[n] = n > 1 ? (r + 378)[n] + (r + 126)[1] * (r + 210)[n - 1] + (r + 126)[n - 1] * (r + 210)[1] : (V){0};
            (r + 420)[n] = n > 1 ? (r + 420)[n] + (r + 126)[1] * (r + 252)[n - 1] + (r + 126)[n - 1] * (r + 252)[1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum7 = (r + 504)[1] * (r + 546)[n - 1], sum7_next = {0}, sum7_before = (r + 546)[n - 1];
            V sum8 = (r + 630)[1] * (r + 714)[n - 1], sum8_next = {0}, sum8_before = (r + 714)[n - 1];
            for (int i = 1; 2 * i < n; i++) {
                sum7_next += (r + 504)[2 * i] * sum7_before; sum7_before = (r + 546)[n - 2 * i];
                sum7 += (r + 504)[2 * i] * sum7_before; sum7_next += (r + 504)[2 * i + 1] * sum7_before;
                sum7_before = (r + 546)[n - 2 * i - 1]; sum7 += (r + 504)[2 * i + 1] * sum7_before;
                sum8_next += (r + 630)[2 * i] * sum8_before; sum8_before = (r + 714)[n - 2 * i];
                sum8 += (r + 630)[2 * i] * sum8_before; sum8_next += (r + 630)[2 * i + 1] * sum8_before;
                sum8_before = (r + 714)[n - 2 * i - 1]; sum8 += (r + 630)[2 * i + 1] * sum8_before;
            }
            (r + 546)[n] = sum7, (r + 546)[n + 1] = sum7_next;
            (r + 756)[n] = sum8, (r + 756)[n + 1] = sum8_next;
        } else {
            (r + 546)[n] = n > 1 ? (r + 546)[n] + (r + 504)[1] * (r + 546)[n - 1] + (r + 504)[n - 1] * (r + 546)[1] : (V){0};
            (r + 756)[n] = n > 1 ? (r + 756)[n] + (r + 630)[1] * (r + 714)[n - 1] + (r + 630)[n - 1] * (r + 714)[1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum0 = {0}, sum0_next = {0};
            for (int i = 1; 2 * i < n; i++) {
                const V sum0_now = (r + 42)[n - i]; sum0 += (r + 42)[i] * sum0_now; sum0_next += (r + 42)[i + 1] * sum0_now;
            }
            if (squares) (r + 672)[n] = 2.0 * sum0 + (r + 42)[n / 2] * (r + 42)[n / 2], (r + 672)[n + 1] = 2.0 * sum0_next;
        } else {
            if (squares) (r + 672)[n] = n > 1 ? (r + 672)[n] + 2.0 * (r + 42)[1] * (r + 42)[n - 1] : (V){0};
        }
        const V x0 = (r + 0)[n];
        const V x1 = (r + 42)[n];
        const V x2 = (r + 84)[n];
        const V x3 = (r + 126)[n];
        V x16 = (r + 672)[n];
        if (squares) {
            const V sum0 = x16;
            x16 = sum0 + 2.0 * (r + 42)[0] * x1;
            (r + 672)[n] = x16;
        }
        V x4 = (r + 168)[n];
        {
            x4 = x0 * n;
            (r + 168)[n] = x4;
        }
        V x5 = (r + 210)[n];
        V x6 = (r + 252)[n];
        {
            const V sum0 = x5;
            const V sum1 = x6;
            const V b = 1.0 - (r + 252)[0];
            x5 = b * x0 - by_n * sum1;
            x6 = by_n * sum0 + (r + 210)[0] * x0;
            (r + 210)[n] = x5;
            (r + 252)[n] = x6;
        }
        V x7 = (r + 294)[n];
        {
            const V sum0 = x7;
            x7 = sum0 + (r + 84)[0] * x5 + x2 * (r + 210)[0];
            (r + 294)[n] = x7;
        }
        V x8 = (r + 336)[n];
        {
            const V sum0 = x8;
            x8 = sum0 + (r + 84)[0] * x6 + x2 * (r + 252)[0];
            (r + 336)[n] = x8;
        }
        V x9 = (r + 378)[n];
        {
            const V sum0 = x9;
            x9 = sum0 + (r + 126)[0] * x5 + x3 * (r + 210)[0];
            (r + 378)[n] = x9;
        }
        V x10 = (r + 420)[n];
        {
            const V sum0 = x10;
            x10 = sum0 + (r + 126)[0] * x6 + x3 * (r + 252)[0];
            (r + 420)[n] = x10;
        }
        V x11;
        {
            x11 = (V){0};
            x11 += c[own[32]] * x0;
            (r + 462)[n] = x11;
        }
        V x12 = (r + 504)[n];
        {
            x12 = x11 * n;
            (r + 504)[n] = x12;
        }
        V x13 = (r + 546)[n];
        V x14 = (r + 588)[n];
        {
            const V sum0 = x13;
            x13 = by_n * sum0 + (r + 546)[0] * x11;
            x14 = x13;
            (r + 546)[n] = x13;
            (r + 588)[n] = x14;
        }
        V x15;
        {
            x15 = (V){0};
            x15 += c[own[46]] * x14;
            (r + 630)[n] = x15;
        }
        V x17;
        {
            x17 = (V){0};
            x17 += c[own[60]] * x2;
            x17 += c[own[61]] * x3;
            x17 += c[own[62]] * x5;
            x17 += c[own[63]] * x6;
            x17 += c[own[64]] * x7;
            x17 += c[own[65]] * x8;
            x17 += c[own[66]] * x9;
            x17 += c[own[67]] * x10;
            x17 += c[own[68]] * x16;
            (r + 714)[n] = x17;
        }
        V x18 = (r + 756)[n];
        {
            const V sum0 = x18;
            x18 = sum0 + (r + 630)[0] * x17 + x15 * (r + 714)[0];
            (r + 756)[n] = x18;
        }
        V x19;
        {
            x19 = (V){0};
            x19 += c[own[88]] * x2;
            x19 += c[own[89]] * x3;
            x19 += c[own[90]] * x5;
            x19 += c[own[91]] * x6;
            x19 += c[own[92]] * x7;
            x19 += c[own[93]] * x8;
            x19 += c[own[94]] * x9;
            x19 += c[own[95]] * x10;
            x19 += c[own[96]] * x15;
            x19 += c[own[97]] * x17;
            x19 += c[own[98]] * x18;
            (r + 798)[n] = x19;
        }
        if (moves) {
            (r + 0)[n + 1] = x1 * inverse[n + 1];
            (r + 42)[n + 1] = x19 * inverse[n + 1];
        }
    }
}
static void later_6(LATER)
{
    int n = 0;
    const V x5 = (r + 210)[n];
    const V x6 = (r + 252)[n];
    const V x17 = (r + 714)[n];
    V x20;
    {
        x20 = c[own[103]];
        x20 += c[own[104]] * x17;
        (r + 840)[n] = x20;
    }
    V x21;
    {
        x21 = c[own[110]];
        x21 += c[own[111]] * x5;
        x21 += c[own[112]] * x6;
        (r + 882)[n] = x21;
    }
    for (n = 1; n < top; n++) {
        const V x5 = (r + 210)[n];
        const V x6 = (r + 252)[n];
        const V x17 = (r + 714)[n];
        V x20;
        {
            x20 = (V){0};
            x20 += c[own[104]] * x17;
            (r + 840)[n] = x20;
        }
        V x21;
        {
            x21 = (V){0};
            x21 += c[own[111]] * x5;
            x21 += c[own[112]] * x6;
            (r + 882)[n] = x21;
        }
    }
}
static void orders_7(ORDERS)
{
    if (n == 0) {
        const V x0 = (r + 0)[n];
        const V x1 = (r + 42)[n];
        V x2 = (r + 84)[n];
        if (squares) {
            x2 = x1 * x1;
            (r + 84)[n] = x2;
        }
        V x3;
        {
            x3 = c[own[8]];
            x3 += c[own[9]] * x1;
            x3 += c[own[10]] * x2;
            (r + 126)[n] = x3;
        }
        V x4;
        {
            x4 = (V){0};
            (r + 168)[n] = x4;
        }
        V x5;
        V x6;
        {
            const V t1 = IN(map)(sin, 0.5 * x0);
            x5 = IN(map)(sin, x0);
            x6 = 2.0 * (t1 * t1);
            (r + 210)[n] = x5;
            (r + 252)[n] = x6;
        }
        V x7;
        {
            x7 = c[own[25]];
            x7 += c[own[26]] * x2;
            x7 += c[own[27]] * x5;
            x7 += c[own[28]] * x6;
            (r + 294)[n] = x7;
        }
        V x8;
        {
            x8 = x7 * x1;
            (r + 336)[n] = x8;
        }
        V x9;
        {
            x9 = c[own[40]];
            x9 += c[own[41]] * x2;
            x9 += c[own[42]] * x5;
            x9 += c[own[43]] * x6;
            x9 += c[own[44]] * x8;
            (r + 378)[n] = x9;
        }
        if (moves) {
            (r + 0)[n + 1] = x3 * inverse[n + 1];
            (r + 42)[n + 1] = x9 * inverse[n + 1];
        }
        n++;
    }
    for (; n < behind; n++) {
        const double by_n = inverse[n];
        if (n % 2 == 0) {
            V sum1 = (r + 168)[1] * (r + 210)[n - 1], sum1_next = {0}, sum1_before = (r + 210)[n - 1];
            V sum2 = (r + 168)[1] * (r + 252)[n - 1], sum2_next = {0}, sum2_before = (r + 252)[n - 1];
            for (int i = 1; 2 * i < n; i++) {
                sum1_next += (r + 168)[2 * i] * sum1_before; sum1_before = (r + 210)[n - 2 * i];
                sum1 += (r + 168)[2 * i] * sum1_before; sum1_next += (r + 168)[2 * i + 1] * sum1_before;
                sum1_before = (r + 210)[n - 2 * i - 1]; sum1 += (r + 168)[2 * i + 1] * sum1_before;
                sum2_next += (r + 168)[2 * i] * sum2_before; sum2_before = (r + 252)[n - 2 * i];
                sum2 += (r + 168)[2 * i] * sum2_before; sum2_next += (r + 168)[2 * i + 1] * sum2_before;
                sum2_before = (r + 252)[n - 2 * i - 1]; sum2 += (r + 168)[2 * i + 1] * sum2_before;
            }
            (r + 210)[n] = sum1, (r + 210)[n + 1] = sum1_next;
            (r + 252)[n] = sum2, (r + 252)[n + 1] = sum2_next;
        } else {
            (r + 210)[n] = n > 1 ? (r + 210)[n] + (r + 168)[1] * (r + 210)[n - 1] + (r + 168)[n - 1] * (r + 210)[1] : (V){0};
            (r + 252)[n] = n > 1 ? (r + 252)[n] + (r + 168)[1] * (r + 252)[n - 1] + (r + 168)[n - 1] * (r + 252)[1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum3 = (r + 294)[1] * (r + 42)[n - 1], sum3_next = {0}, sum3_before = (r + 42)[n - 1];
            V sum0 = {0}, sum0_next = {0};
            for (int i = 1; 2 * i < n; i++) {
                sum3_next += (r + 294)[2 * i] * sum3_before; sum3_before = (r + 42)[n - 2 * i];
                sum3 += (r + 294)[2 * i] * sum3_before; sum3_next += (r + 294)[2 * i + 1] * sum3_before;
                sum3_before = (r + 42)[n - 2 * i - 1]; sum3 += (r + 294)[2 * i + 1] * sum3_before;
                const V sum0_now = (r + 42)[n - i]; sum0 += (r + 42)[i] * sum0_now; sum0_next += (r + 42)[i + 1] * sum0_now;
            }
            (r + 336)[n] = sum3, (r + 336)[n + 1] = sum3_next;
            if (squares) (r + 84)[n] = 2.0 * sum0 + (r + 42)[n / 2] * (r + 42)[n / 2], (r + 84)[n + 1] = 2.0 * sum0_next;
        } else {
            (r + 336)[n] = n > 1 ? (r + 336)[n] + (r + 294)[1] * (r + 42)[n - 1] + (r + 294)[n - 1] * (r + 42)[1] : (V){0};
            if (squares) (r + 84)[n] = n > 1 ? (r + 84)[n] + 2.0 * (r + 42)[1] * (r + 42)[n - 1] : (V){0};
        }
        const V x0 = (r + 0)[n];
        const V x1 = (r + 42)[n];
        V x2 = (r + 84)[n];
        if (squares) {
            const V sum0 = x2;
            x2 = sum0 + 2.0 * (r + 42)[0] * x1;
            (r + 84)[n] = x2;
        }
        V x3;
        {
            x3 = (V){0};
            x3 += c[own[9]] * x1;
            x3 += c[own[10]] * x2;
            (r + 126)[n] = x3;
        }
        V x4 = (r + 168)[n];
        {
            x4 = x0 * n;
            (r + 168)[n] = x4;
        }
        V x5 = (r + 210)[n];
        V x6 = (r + 252)[n];
        {
            const V sum0 = x5;
            const V sum1 = x6;
            const V b = 1.0 - (r + 252)[0];
            x5 = b * x0 - by_n * sum1;
            x6 = by_n * sum0 + (r + 210)[0] * x0;
            (r + 210)[n] = x5;
            (r + 252)[n] = x6;
        }
        V x7;
        {
            x7 = (V){0};
            x7 += c[own[26]] * x2;
            x7 += c[own[27]] * x5;
            x7 += c[own[28]] * x6;
            (r + 294)[n] = x7;
        }
        V x8 = (r + 336)[n];
        {
            const V sum0 = x8;
            x8 = sum0 + (r + 294)[0] * x1 + x7 * (r + 42)[0];
            (r + 336)[n] = x8;
        }
        V x9;
        {
            x9 = (V){0};
            x9 += c[own[41]] * x2;
            x9 += c[own[42]] * x5;
            x9 += c[own[43]] * x6;
            x9 += c[own[44]] * x8;
            (r + 378)[n] = x9;
        }
        if (moves) {
            (r + 0)[n + 1] = x3 * inverse[n + 1];
            (r + 42)[n + 1] = x9 * inverse[n + 1];
        }
    }
}
static void later_7(LATER)
{
    int n = 0;
    const V x2 = (r + 84)[n];
    const V x5 = (r + 210)[n];
    const V x6 = (r + 252)[n];
    V x10;
    {
        x10 = c[own[51]];
        x10 += c[own[52]] * x2;
        x10 += c[own[53]] * x5;
        x10 += c[own[54]] * x6;
        (r + 420)[n] = x10;
    }
    V x11;
    {
        x11 = c[own[60]];
        x11 += c[own[61]] * x5;
        x11 += c[own[62]] * x6;
        (r + 462)[n] = x11;
    }
    for (n = 1; n < top; n++) {
        const V x2 = (r + 84)[n];
        const V x5 = (r + 210)[n];
        const V x6 = (r + 252)[n];
        V x10;
        {
            x10 = (V){0};
            x10 += c[own[52]] * x2;
            x10 += c[own[53]] * x5;
            x10 += c[own[54]] * x6;
            (r + 420)[n] = x10;
        }
        V x11;
        {
            x11 = (V){0};
            x11 += c[own[61]] * x5;
            x11 += c[own[62]] * x6;
            (r + 462)[n] = x11;
        }
    }
}
static void orders_8(ORDERS)
{
    if (n == 0) {
        const V x0 = (r + 0)[n];
        const V x1 = (r + 42)[n];
        V x15 = (r + 630)[n];
        if (squares) {
            x15 = x1 * x1;
            (r + 630)[n] = x15;
        }
        V x2;
        {
            x2 = (V){0};
            (r + 84)[n] = x2;
        }
        V x3;
        V x4;
        {
            const V t1 = IN(map)(sin, 0.5 * x0);
            x3 = IN(map)(sin, x0);
            x4 = 2.0 * (t1 * t1);
            (r + 126)[n] = x3;
            (r + 168)[n] = x4;
        }
        V x5;
        {
            x5 = c[own[15]];
            x5 += c[own[16]] * x1;
            (r + 210)[n] = x5;
        }
        V x6;
        V x7;
        {
            const V t1 = 1.0 + x5;
            x6 = 1.0 / t1;
            x7 = -(x5 / t1);
            (r + 252)[n] = x6;
            (r + 294)[n] = x7;
        }
        V x8;
        {
            x8 = c[own[25]];
            x8 += c[own[26]] * x7;
            (r + 336)[n] = x8;
        }
        V x9;
        V x10;
        V x11;
        V x12;
        V x13;
        V x14;
        {
            const V t1 = x0 * x0;
            const V t2 = x0 * t1;
            const V t3 = t1 * t1;
            x9 = t1;
            x10 = t2;
            x11 = t3;
            x12 = x0 * t3;
            x13 = t1 * t3;
            x14 = t2 * t3;
            (r + 378)[n] = x9;
            (r + 420)[n] = x10;
            (r + 462)[n] = x11;
            (r + 504)[n] = x12;
            (r + 546)[n] = x13;
            (r + 588)[n] = x14;
        }
        V x16;
        {
            x16 = c[own[48]];
            x16 += c[own[49]] * x0;
            x16 += c[own[50]] * x3;
            x16 += c[own[51]] * x4;
            x16 += c[own[52]] * x9;
            x16 += c[own[53]] * x10;
            x16 += c[own[54]] * x11;
            x16 += c[own[55]] * x12;
            x16 += c[own[56]] * x13;
            x16 += c[own[57]] * x14;
            x16 += c[own[58]] * x15;
            (r + 672)[n] = x16;
        }
        V x17;
        {
            x17 = x8 * x16;
            (r + 714)[n] = x17;
        }
        V x18;
        {
            x18 = c[own[71]];
            x18 += c[own[72]] * x3;
            x18 += c[own[73]] * x4;
            x18 += c[own[74]] * x8;
            x18 += c[own[75]] * x16;
            x18 += c[own[76]] * x17;
            (r + 756)[n] = x18;
        }
        if (moves) {
            (r + 0)[n + 1] = x1 * inverse[n + 1];
            (r + 42)[n + 1] = x18 * inverse[n + 1];
        }
        n++;
    }
    for (; n < behind; n++) {
        const double by_n = inverse[n];
        if (n % 2 == 0) {
            V sum1 = (r + 84)[1] * (r + 126)[n - 1], sum1_next = {0}, sum1_before = (r + 126)[n - 1];
            V sum2 = (r + 84)[1] * (r + 168)[n - 1], sum2_next = {0}, sum2_before = (r + 168)[n - 1];
            for (int i = 1; 2 * i < n; i++) {
                sum1_next += (r + 84)[2 * i] * sum1_before; sum1_before = (r + 126)[n - 2 * i];
                sum1 += (r + 84)[2 * i] * sum1_before; sum1_next += (r + 84)[2 * i + 1] * sum1_before;
                sum1_before = (r + 126)[n - 2 * i - 1]; sum1 += (r + 84)[2 * i + 1] * sum1_before;
                sum2_next += (r + 84)[2 * i] * sum2_before; sum2_before = (r + 168)[n - 2 * i];
                sum2 += (r + 84)[2 * i] * sum2_before; sum2_next += (r + 84)[2 * i + 1] * sum2_before;
                sum2_before = (r + 168)[n - 2 * i - 1]; sum2 += (r + 84)[2 * i + 1] * sum2_before;
            }
            (r + 126)[n] = sum1, (r + 126)[n + 1] = sum1_next;
            (r + 168)[n] = sum2, (r + 168)[n + 1] = sum2_next;
        } else {
            (r + 126)[n] = n > 1 ? (r + 126)[n] + (r + 84)[1] * (r + 126)[n - 1] + (r + 84)[n - 1] * (r + 126)[1] : (V){0};
            (r + 168)[n] = n > 1 ? (r + 168)[n] + (r + 84)[1] * (r + 168)[n - 1] + (r + 84)[n - 1] * (r + 168)[1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum3 = (r + 210)[1] * (r + 252)[n - 1], sum3_next = {0}, sum3_before = (r + 252)[n - 1];
            V sum4 = (r + 0)[1] * (r + 378)[n - 1], sum4_next = {0}, sum4_before = (r + 378)[n - 1];
            for (int i = 1; 2 * i < n; i++) {
                sum3_next += (r + 210)[2 * i] * sum3_before; sum3_before = (r + 252)[n - 2 * i];
                sum3 += (r + 210)[2 * i] * sum3_before; sum3_next += (r + 210)[2 * i + 1] * sum3_before;
                sum3_before = (r + 252)[n - 2 * i - 1]; sum3 += (r + 210)[2 * i + 1] * sum3_before;
                sum4_next += (r + 0)[2 * i] * sum4_before; sum4_before = (r + 378)[n - 2 * i];
                sum4 += (r + 0)[2 * i] * sum4_before; sum4_next += (r + 0)[2 * i + 1] * sum4_before;
                sum4_before = (r + 378)[n - 2 * i - 1]; sum4 += (r + 0)[2 * i + 1] * sum4_before;
            }
            (r + 252)[n] = sum3, (r + 252)[n + 1] = sum3_next;
            (r + 378)[n] = sum4, (r + 378)[n + 1] = sum4_next;
        } else {
            (r + 252)[n] = n > 1 ? (r + 252)[n] + (r + 210)[1] * (r + 252)[n - 1] + (r + 210)[n - 1] * (r + 252)[1] : (V){0};
            (r + 378)[n] = n > 1 ? (r + 378)[n] + (r + 0)[1] * (r + 378)[n - 1] + (r + 0)[n - 1] * (r + 378)[1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum5 = (r + 0)[1] * (r + 420)[n - 1], sum5_next = {0}, sum5_before = (r + 420)[n - 1];
            V sum6 = (r + 0)[1] * (r + 462)[n - 1], sum6_next = {0}, sum6_before = (r + 462)[n - 1];
            for (int i = 1; 2 * i < n; i++) {
                sum5_next += (r + 0)[2 * i] * sum5_before; sum5_before = (r + 420)[n - 2 * i];
                sum5 += (r + 0)[2 * i] * sum5_before; sum5_next += (r + 0)[2 * i + 1] * sum5_before;
                sum5_before = (r + 420)[n - 2 * i - 1]; sum5 += (r + 0)[2 * i + 1] * sum5_before;
                sum6_next += (r + 0)[2 * i] * sum6_before; sum6_before = (r + 462)[n - 2 * i];
                sum6 += (r + 0)[2 * i] * sum6_before; sum6_next += (r + 0)[2 * i + 1] * sum6_before;
                sum6_before = (r + 462)[n - 2 * i - 1]; sum6 += (r + 0)[2 * i + 1] * sum6_before;
            }
            (r + 420)[n] = sum5, (r + 420)[n + 1] = sum5_next;
            (r + 462)[n] = sum6, (r + 462)[n + 1] = sum6_next;
        } else {
            (r + 420)[n] = n > 1 ? (r + 420)[n] + (r + 0)[1] * (r + 420)[n - 1] + (r + 0)[n - 1] * (r + 420)[1] : (V){0};
            (r + 462)[n] = n > 1 ? (r + 462)[n] + (r + 0)[1] * (r + 462)[n - 1] + (r + 0)[n - 1] * (r + 462)[1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum7 = (r + 0)[1] * (r + 504)[n - 1], sum7_next = {0}, sum7_before = (r + 504)[n - 1];
            V sum8 = (r + 0)[1] * (r + 546)[n - 1], sum8_next = {0}, sum8_before = (r + 546)[n - 1];
            for (int i = 1; 2 * i < n; i++) {
                sum7_next += (r + 0)[2 * i] * sum7_before; sum7_before = (r + 504)[n - 2 * i];
                sum7 += (r + 0)[2 * i] * sum7_before; sum7_next += (r + 0)[2 * i + 1] * sum7_before;
                sum7_before = (r + 504)[n - 2 * i - 1]; sum7 += (r + 0)[2 * i + 1] * sum7_before;
                sum8_next += (r + 0)[2 * i] * sum8_before; sum8_before = (r + 546)[n - 2 * i];
                sum8 += (r + 0)[2 * i] * sum8_before; sum8_next += (r + 0)[2 * i + 1] * sum8_before;
                sum8_before = (r + 546)[n - 2 * i - 1]; sum8 += (r + 0)[2 * i + 1] * sum8_before;
            }
            (r + 504)[n] = sum7, (r + 504)[n + 1] = sum7_next;
            (r + 546)[n] = sum8, (r + 546)[n + 1] = sum8_next;
        } else {
            (r + 504)[n] = n > 1 ? (r + 504)[n] + (r + 0)[1] * (r + 504)[n - 1] + (r + 0)[n - 1] * (r + 504)[1] : (V){0};
            (r + 546)[n] = n > 1 ? (r + 546)[n] + (r + 0)[1] * (r + 546)[n - 1] + (r + 0)[n - 1] * (r + 546)[1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum10 = (r + 336)[1] * (r + 672)[n - 1], sum10_next = {0}, sum10_before = (r + 672)[n - 1];
            V sum0 = {0}, sum0_next = {0};
            for (int i = 1; 2 * i < n; i++) {
                sum10_next += (r + 336)[2 * i] * sum10_before; sum10_before = (r + 672)[n - 2 * i];
                sum10 += (r + 336)[2 * i] * sum10_before; sum10_next += (r + 336)[2 * i + 1] * sum10_before;
                sum10_before = (r + 672)[n - 2 * i - 1]; sum10 += (r + 336)[2 * i + 1] * sum10_before;
                const V sum0_now = (r + 42)[n - i]; sum0 += (r + 42)[i] * sum0_now; sum0_next += (r + 42)[i + 1] * sum0_now;
            }
            (r + 714)[n] = sum10, (r + 714)[n + 1] = sum10_next;
            if (squares) (r + 630)[n] = 2.0 * sum0 + (r + 42)[n / 2] * (r + 42)[n / 2], (r + 630)[n + 1] = 2.0 * sum0_next;
        } else {
            (r + 714)[n] = n > 1 ? (r + 714)[n] + (r + 336)[1] * (r + 672)[n - 1] + (r + 336)[n - 1] * (r + 672)[1] : (V){0};
            if (squares) (r + 630)[n] = n > 1 ? (r + 630)[n] + 2.0 * (r + 42)[1] * (r + 42)[n - 1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum9 = {0}, sum9_next = {0};
            for (int i = 1; 2 * i < n; i++) {
                const V sum9_now = (r + 0)[n - i]; sum9 += (r + 0)[i] * sum9_now; sum9_next += (r + 0)[i + 1] * sum9_now;
            }
            (r + 588)[n] = 2.0 * sum9 + (r + 0)[n / 2] * (r + 0)[n / 2], (r + 588)[n + 1] = 2.0 * sum9_next;
        } else {
            (r + 588)[n] = n > 1 ? (r + 588)[n] + 2.0 * (r + 0)[1] * (r + 0)[n - 1] : (V){0};
        }
        const V x0 = (r + 0)[n];
        const V x1 = (r + 42)[n];
        V x15 = (r + 630)[n];
        if (squares) {
            const V sum0 = x15;
            x15 = sum0 + 2.0 * (r + 42)[0] * x1;
            (r + 630)[n] = x15;
        }
        V x2 = (r + 84)[n];
        {
            x2 = x0 * n;
            (r + 84)[n] = x2;
        }
        V x3 = (r + 126)[n];
        V x4 = (r + 168)[n];
        {
            const V sum0 = x3;
            const V sum1 = x4;
            const V b = 1.0 - (r + 168)[0];
            x3 = b * x0 - by_n * sum1;
            x4 = by_n * sum0 + (r + 126)[0] * x0;
            (r + 126)[n] = x3;
            (r + 168)[n] = x4;
        }
        V x5;
        {
            x5 = (V){0};
            x5 += c[own[16]] * x1;
            (r + 210)[n] = x5;
        }
        V x6 = (r + 252)[n];
        V x7 = (r + 294)[n];
        {
            const V sum0 = x6;
            x6 = -((sum0 + (r + 252)[0] * x5) * (r + 252)[0]);
            x7 = x6;
            (r + 252)[n] = x6;
            (r + 294)[n] = x7;
        }
        V x8;
        {
            x8 = (V){0};
            x8 += c[own[26]] * x7;
            (r + 336)[n] = x8;
        }
        V x9 = (r + 378)[n];
        V x10 = (r + 420)[n];
        V x11 = (r + 462)[n];
        V x12 = (r + 504)[n];
        V x13 = (r + 546)[n];
        V x14 = (r + 588)[n];
        {
            const V sum0 = x9;
            const V sum1 = x10;
            const V sum2 = x11;
            const V sum3 = x12;
            const V sum4 = x13;
            const V sum5 = x14;
            x9 = sum5 + 2.0 * (r + 0)[0] * x0;
            x10 = sum0 + (r + 378)[0] * x0 + x9 * (r + 0)[0];
            x11 = sum1 + (r + 420)[0] * x0 + x10 * (r + 0)[0];
            x12 = sum2 + (r + 462)[0] * x0 + x11 * (r + 0)[0];
            x13 = sum3 + (r + 504)[0] * x0 + x12 * (r + 0)[0];
            x14 = sum4 + (r + 546)[0] * x0 + x13 * (r + 0)[0];
            (r + 378)[n] = x9;
            (r + 420)[n] = x10;
            (r + 462)[n] = x11;
            (r + 504)[n] = x12;
            (r + 546)[n] = x13;
            (r + 588)[n] = x14;
        }
        V x16;
        {
            x16 = (V){0};
            x16 += c[own[49]] * x0;
            x16 += c[own[50]] * x3;
            x16 += c[own[51]] * x4;
            x16 += c[own[52]] * x9;
            x16 += c[own[53]] * x10;
            x16 += c[own[54]] * x11;
            x16 += c[own[55]] * x12;
            x16 += c[own[56]] * x13;
            x16 += c[own[57]] * x14;
            x16 += c[own[58]] * x15;
            (r + 672)[n] = x16;
        }
        V x17 = (r + 714)[n];
        {
            const V sum0 = x17;
            x17 = sum0 + (r + 336)[0] * x16 + x8 * (r + 672)[0];
            (r + 714)[n] = x17;
        }
        V x18;
        {
            x18 = (V){0};
            x18 += c[own[72]] * x3;
            x18 += c[own[73]] * x4;
            x18 += c[own[74]] * x8;
            x18 += c[own[75]] * x16;
            x18 += c[own[76]] * x17;
            (r + 756)[n] = x18;
        }
        if (moves) {
            (r + 0)[n + 1] = x1 * inverse[n + 1];
            (r + 42)[n + 1] = x18 * inverse[n + 1];
        }
    }
}
static void later_8(LATER)
{
    int n = 0;
    const V x3 = (r + 126)[n];
    const V x4 = (r + 168)[n];
    const V x16 = (r + 672)[n];
    V x19;
    {
        x19 = c[own[81]];
        x19 += c[own[82]] * x16;
        (r + 798)[n] = x19;
    }
    V x20;
    {
        x20 = c[own[88]];
        x20 += c[own[89]] * x3;
        x20 += c[own[90]] * x4;
        (r + 840)[n] = x20;
    }
    for (n = 1; n < top; n++) {
        const V x3 = (r + 126)[n];
        const V x4 = (r + 168)[n];
        const V x16 = (r + 672)[n];
        V x19;
        {
            x19 = (V){0};
            x19 += c[own[82]] * x16;
            (r + 798)[n] = x19;
        }
        V x20;
        {
            x20 = (V){0};
            x20 += c[own[89]] * x3;
            x20 += c[own[90]] * x4;
            (r + 840)[n] = x20;
        }
    }
}
static void orders_9(ORDERS)
{
    if (n == 0) {
        const V x0 = (r + 0)[n];
        const V x1 = (r + 42)[n];
        const V x2 = (r + 84)[n];
        V x12 = (r + 504)[n];
        if (squares) {
            x12 = x1 * x1;
            (r + 504)[n] = x12;
        }
        V x3;
        {
            x3 = (V){0};
            (r + 126)[n] = x3;
        }
        V x4;
        V x5;
        {
            const V t1 = IN(map)(sin, 0.5 * x0);
            x4 = IN(map)(sin, x0);
            x5 = 2.0 * (t1 * t1);
            (r + 168)[n] = x4;
            (r + 210)[n] = x5;
        }
        V x6;
        {
            x6 = x2 * x4;
            (r + 252)[n] = x6;
        }
        V x7;
        {
            x7 = x2 * x5;
            (r + 294)[n] = x7;
        }
        V x8;
        {
            x8 = c[own[23]];
            x8 += c[own[24]] * x1;
            (r + 336)[n] = x8;
        }
        V x9;
        V x10;
        {
            const V t1 = 1.0 + x8;
            x9 = 1.0 / t1;
            x10 = -(x8 / t1);
            (r + 378)[n] = x9;
            (r + 420)[n] = x10;
        }
        V x11;
        {
            x11 = c[own[33]];
            x11 += c[own[34]] * x10;
            (r + 462)[n] = x11;
        }
        V x13;
        {
            x13 = c[own[44]];
            x13 += c[own[45]] * x2;
            x13 += c[own[46]] * x4;
            x13 += c[own[47]] * x5;
            x13 += c[own[48]] * x6;
            x13 += c[own[49]] * x7;
            x13 += c[own[50]] * x12;
            (r + 546)[n] = x13;
        }
        V x14;
        {
            x14 = x11 * x13;
            (r + 588)[n] = x14;
        }
        V x15;
        {
            x15 = c[own[66]];
            x15 += c[own[67]] * x2;
            x15 += c[own[68]] * x4;
            x15 += c[own[69]] * x5;
            x15 += c[own[70]] * x6;
            x15 += c[own[71]] * x7;
            x15 += c[own[72]] * x11;
            x15 += c[own[73]] * x13;
            x15 += c[own[74]] * x14;
            (r + 630)[n] = x15;
        }
        if (moves) {
            (r + 0)[n + 1] = x1 * inverse[n + 1];
            (r + 42)[n + 1] = x15 * inverse[n + 1];
        }
        n++;
    }
    for (; n < behind; n++) {
        const double by_n = inverse[n];
        if (n % 2 == 0) {
            V sum1 = (r + 126)[1] * (r + 168)[n - 1], sum1_next = {0}, sum1_before = (r + 168)[n - 1];
            V sum2 = (r + 126)[1] * (r + 210)[n - 1], sum2_next = {0}, sum2_before = (r + 210)[n - 1];
            for (int i = 1; 2 * i < n; i++) {
                sum1_next += (r + 126)[2 * i] * sum1_before; sum1_before = (r + 168)[n - 2 * i];
                sum1 += (r + 126)[2 * i] * sum1_before; sum1_next += (r + 126)[2 * i + 1] * sum1_before;
                sum1_before = (r + 168)[n - 2 * i - 1]; sum1 += (r + 126)[2 * i + 1] * sum1_before;
                sum2_next += (r + 126)[2 * i] * sum2_before; sum2_before = (r + 210)[n - 2 * i];
                sum2 += (r + 126)[2 * i] * sum2_before; sum2_next += (r + 126)[2 * i + 1] * sum2_before;
                sum2_before = (r + 210)[n - 2 * i - 1]; sum2 += (r + 126)[2 * i + 1] * sum2_before;
            }
            (r + 168)[n] = sum1, (r + 168)[n + 1] = sum1_next;
            (r + 210)[n] = sum2, (r + 210)[n + 1] = sum2_next;
        } else {
            (r + 168)[n] = n > 1 ? (r + 168)[n] + (r + 126)[1] * (r + 168)[n - 1] + (r + 126)[n - 1] * (r + 168)[1] : (V){0};
            (r + 210)[n] = n > 1 ? (r + 210)[n] + (r + 126)[1] * (r + 210)[n - 1] + (r + 126)[n - 1] * (r + 210)[1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum3 = (r + 84)[1] * (r + 168)[n - 1], sum3_next = {0}, sum3_before = (r + 168)[n - 1];
            V sum4 = (r + 84)[1] * (r + 210)[n - 1], sum4_next = {0}, sum4_before = (r + 210)[n - 1];
            for (int i = 1; 2 * i < n; i++) {
                sum3_next += (r + 84)[2 * i] * sum3_before; sum3_before = (r + 168)[n - 2 * i];
                sum3 += (r + 84)[2 * i] * sum3_before; sum3_next += (r + 84)[2 * i + 1] * sum3_before;
                sum3_before = (r + 168)[n - 2 * i - 1]; sum3 += (r + 84)[2 * i + 1] * sum3_before;
                sum4_next += (r + 84)[2 * i] * sum4_before; sum4_before = (r + 210)[n - 2 * i];
                sum4 += (r + 84)[2 * i] * sum4_before; sum4_next += (r + 84)[2 * i + 1] * sum4_before;
                sum4_before = (r + 210)[n - 2 * i - 1]; sum4 += (r + 84)[2 * i + 1] * sum4_before;
            }
            (r + 252)[n] = sum3, (r + 252)[n + 1] = sum3_next;
            (r + 294)[n] = sum4, (r + 294)[n + 1] = sum4_next;
        } else {
            (r + 252)[n] = n > 1 ? (r + 252)[n] + (r + 84)[1] * (r + 168)[n - 1] + (r + 84)[n - 1] * (r + 168)[1] : (V){0};
            (r + 294)[n] = n > 1 ? (r + 294)[n] + (r + 84)[1] * (r + 210)[n - 1] + (r + 84)[n - 1] * (r + 210)[1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum5 = (r + 336)[1] * (r + 378)[n - 1], sum5_next = {0}, sum5_before = (r + 378)[n - 1];
            V sum6 = (r + 462)[1] * (r + 546)[n - 1], sum6_next = {0}, sum6_before = (r + 546)[n - 1];
            for (int i = 1; 2 * i < n; i++) {
                sum5_next += (r + 336)[2 * i] * sum5_before; sum5_before = (r + 378)[n - 2 * i];
                sum5 += (r + 336)[2 * i] * sum5_before; sum5_next += (r + 336)[2 * i + 1] * sum5_before;
                sum5_before = (r + 378)[n - 2 * i - 1]; sum5 += (r + 336)[2 * i + 1] * sum5_before;
                sum6_next += (r + 462)[2 * i] * sum6_before; sum6_before = (r + 546)[n - 2 * i];
                sum6 += (r + 462)[2 * i] * sum6_before; sum6_next += (r + 462)[2 * i + 1] * sum6_before;
                sum6_before = (r + 546)[n - 2 * i - 1]; sum6 += (r + 462)[2 * i + 1] * sum6_before;
            }
            (r + 378)[n] = sum5, (r + 378)[n + 1] = sum5_next;
            (r + 588)[n] = sum6, (r + 588)[n + 1] = sum6_next;
        } else {
            (r + 378)[n] = n > 1 ? (r + 378)[n] + (r + 336)[1] * (r + 378)[n - 1] + (r + 336)[n - 1] * (r + 378)[1] : (V){0};
            (r + 588)[n] = n > 1 ? (r + 588)[n] + (r + 462)[1] * (r + 546)[n - 1] + (r + 462)[n - 1] * (r + 546)[1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum0 = {0}, sum0_next = {0};
            for (int i = 1; 2 * i < n; i++) {
                const V sum0_now = (r + 42)[n - i]; sum0 += (r + 42)[i] * sum0_now; sum0_next += (r + 42)[i + 1] * sum0_now;
            }
            if (squares) (r + 504)[n] = 2.0 * sum0 + (r + 42)[n / 2] * (r + 42)[n / 2], (r + 504)[n + 1] = 2.0 * sum0_next;
        } else {
            if (squares) (r + 504)[n] = n > 1 ? (r + 504)[n] + 2.0 * (r + 42)[1] * (r + 42)[n - 1] : (V){0};
        }
        const V x0 = (r + 0)[n];
        const V x1 = (r + 42)[n];
        const V x2 = (r + 84)[n];
        V x12 = (r + 504)[n];
        if (squares) {
            const V sum0 = x12;
            x12 = sum0 + 2.0 * (r + 42)[0] * x1;
            (r + 504)[n] = x12;
        }
        V x3 = (r + 126)[n];
        {
            x3 = x0 * n;
            (r + 126)[n] = x3;
        }
        V x4 = (r + 168)[n];
        V x5 = (r + 210)[n];
        {
            const V sum0 = x4;
            const V sum1 = x5;
            const V b = 1.0 - (r + 210)[0];
            x4 = b * x0 - by_n * sum1;
            x5 = by_n * sum0 + (r + 168)[0] * x0;
            (r + 168)[n] = x4;
            (r + 210)[n] = x5;
        }
        V x6 = (r + 252)[n];
        {
            const V sum0 = x6;
            x6 = sum0 + (r + 84)[0] * x4 + x2 * (r + 168)[0];
            (r + 252)[n] = x6;
        }
        V x7 = (r + 294)[n];
        {
            const V sum0 = x7;
            x7 = sum0 + (r + 84)[0] * x5 + x2 * (r + 210)[0];
            (r + 294)[n] = x7;
        }
        V x8;
        {
            x8 = (V){0};
            x8 += c[own[24]] * x1;
            (r + 336)[n] = x8;
        }
        V x9 = (r + 378)[n];
        V x10 = (r + 420)[n];
        {
            const V sum0 = x9;
            x9 = -((sum0 + (r + 378)[0] * x8) * (r + 378)[0]);
            x10 = x9;
            (r + 378)[n] = x9;
            (r + 420)[n] = x10;
        }
        V x11;
        {
            x11 = (V){0};
            x11 += c[own[34]] * x10;
            (r + 462)[n] = x11;
        }
        V x13;
        {
            x13 = (V){0};
            x13 += c[own[45]] * x2;
            x13 += c[own[46]] * x4;
            x13 += c[own[47]] * x5;
            x13 += c[own[48]] * x6;
            x13 += c[own[49]] * x7;
            x13 += c[own[50]] * x12;
            (r + 546)[n] = x13;
        }
        V x14 = (r + 588)[n];
        {
            const V sum0 = x14;
            x14 = sum0 + (r + 462)[0] * x13 + x11 * (r + 546)[0];
            (r + 588)[n] = x14;
        }
        V x15;
        {
            x15 = (V){0};
            x15 += c[own[67]] * x2;
            x15 += c[own[68]] * x4;
            x15 += c[own[69]] * x5;
            x15 += c[own[70]] * x6;
            x15 += c[own[71]] * x7;
            x15 += c[own[72]] * x11;
            x15 += c[own[73]] * x13;
            x15 += c[own[74]] * x14;
            (r + 630)[n] = x15;
        }
        if (moves) {
            (r + 0)[n + 1] = x1 * inverse[n + 1];
            (r + 42)[n + 1] = x15 * inverse[n + 1];
        }
    }
}
static void later_9(LATER)
{
    int n = 0;
    const V x4 = (r + 168)[n];
    const V x5 = (r + 210)[n];
    const V x13 = (r + 546)[n];
    V x16;
    {
        x16 = c[own[79]];
        x16 += c[own[80]] * x13;
        (r + 672)[n] = x16;
    }
    V x17;
    {
        x17 = c[own[86]];
        x17 += c[own[87]] * x4;
        x17 += c[own[88]] * x5;
        (r + 714)[n] = x17;
    }
    for (n = 1; n < top; n++) {
        const V x4 = (r + 168)[n];
        const V x5 = (r + 210)[n];
        const V x13 = (r + 546)[n];
        V x16;
        {
            x16 = (V){0};
            x16 += c[own[80]] * x13;
            (r + 672)[n] = x16;
        }
        V x17;
        {
            x17 = (V){0};
            x17 += c[own[87]] * x4;
            x17 += c[own[88]] * x5;
            (r + 714)[n] = x17;
        }
    }
}
static void orders_10(ORDERS)
{
    if (n == 0) {
        const V x0 = (r + 0)[n];
        const V x1 = (r + 42)[n];
        const V x2 = (r + 84)[n];
        const V x3 = (r + 126)[n];
        V x15 = (r + 630)[n];
        if (squares) {
            x15 = x1 * x1;
            (r + 630)[n] = x15;
        }
        V x4;
        {
            x4 = (V){0};
            (r + 168)[n] = x4;
        }
        V x5;
        V x6;
        {
            const V t1 = IN(map)(sin, 0.5 * x0);
            x5 = IN(map)(sin, x0);
            x6 = 2.0 * (t1 * t1);
            (r + 210)[n] = x5;
            (r + 252)[n] = x6;
        }
        V x7;
        {
            x7 = x2 * x5;
            (r + 294)[n] = x7;
        }
        V x8;
        {
            x8 = x2 * x6;
            (r + 336)[n] = x8;
        }
        V x9;
        {
            x9 = x3 * x5;
            (r + 378)[n] = x9;
        }
        V x10;
        {
            x10 = x3 * x6;
            (r + 420)[n] = x10;
        }
        V x11;
        {
            x11 = c[own[31]];
            x11 += c[own[32]] * x1;
            (r + 462)[n] = x11;
        }
        V x12;
        V x13;
        {
            const V t1 = 1.0 + x11;
            x12 = 1.0 / t1;
            x13 = -(x11 / t1);
            (r + 504)[n] = x12;
            (r + 546)[n] = x13;
        }
        V x14;
        {
            x14 = c[own[41]];
            x14 += c[own[42]] * x13;
            (r + 588)[n] = x14;
        }
        V x16;
        {
            x16 = c[own[55]];
            x16 += c[own[56]] * x2;
            x16 += c[own[57]] * x3;
            x16 += c[own[58]] * x5;
            x16 += c[own[59]] * x6;
            x16 += c[own[60]] * x7;
            x16 += c[own[61]] * x8;
            x16 += c[own[62]] * x9;
            x16 += c[own[63]] * x10;
            x16 += c[own[64]] * x15;
            (r + 672)[n] = x16;
        }
        V x17;
        {
            x17 = x14 * x16;
            (r + 714)[n] = x17;
        }
        V x18;
        {
            x18 = c[own[83]];
            x18 += c[own[84]] * x2;
            x18 += c[own[85]] * x3;
            x18 += c[own[86]] * x5;
            x18 += c[own[87]] * x6;
            x18 += c[own[88]] * x7;
            x18 += c[own[89]] * x8;
            x18 += c[own[90]] * x9;
            x18 += c[own[91]] * x10;
            x18 += c[own[92]] * x14;
            x18 += c[own[93]] * x16;
            x18 += c[own[94]] * x17;
            (r + 756)[n] = x18;
        }
        if (moves) {
            (r + 0)[n + 1] = x1 * inverse[n + 1];
            (r + 42)[n + 1] = x18 * inverse[n + 1];
        }
        n++;
    }
    for (; n < behind; n++) {
        const double by_n = inverse[n];
        if (n % 2 == 0) {
            V sum1 = (r + 168)[1] * (r + 210)[n - 1], sum1_next = {0}, sum1_before = (r + 210)[n - 1];
            V sum2 = (r + 168)[1] * (r + 252)[n - 1], sum2_next = {0}, sum2_before = (r + 252)[n - 1];
            for (int i = 1; 2 * i < n; i++) {
                sum1_next += (r + 168)[2 * i] * sum1_before; sum1_before = (r + 210)[n - 2 * i];
                sum1 += (r + 168)[2 * i] * sum1_before; sum1_next += (r + 168)[2 * i + 1] * sum1_before;
                sum1_before = (r + 210)[n - 2 * i - 1]; sum1 += (r + 168)[2 * i + 1] * sum1_before;
                sum2_next += (r + 168)[2 * i] * sum2_before; sum2_before = (r + 252)[n - 2 * i];
                sum2 += (r + 168)[2 * i] * sum2_before; sum2_next += (r + 168)[2 * i + 1] * sum2_before;
                sum2_before = (r + 252)[n - 2 * i - 1]; sum2 += (r + 168)[2 * i + 1] * sum2_before;
            }
            (r + 210)[n] = sum1, (r + 210)[n + 1] = sum1_next;
            (r + 252)[n] = sum2, (r + 252)[n + 1] = sum2_next;
        } else {
            (r + 210)[n] = n > 1 ? (r + 210)[n] + (r + 168)[1] * (r + 210)[n - 1] + (r + 168)[n - 1] * (r + 210)[1] : (V){0};
            (r + 252)[n] = n > 1 ? (r + 252)[n] + (r + 168)[1] * (r + 252)[n - 1] + (r + 168)[n - 1] * (r + 252)[1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum3 = (r + 84)[1] * (r + 210)[n - 1], sum3_next = {0}, sum3_before = (r + 210)[n - 1];
            V sum4 = (r + 84)[1] * (r + 252)[n - 1], sum4_next = {0}, sum4_before = (r + 252)[n - 1];
            for (int i = 1; 2 * i < n; i++) {
                sum3_next += (r + 84)[2 * i] * sum3_before; sum3_before = (r + 210)[n - 2 * i];
                sum3 += (r + 84)[2 * i] * sum3_before; sum3_next += (r + 84)[2 * i + 1] * sum3_before;
                sum3_before = (r + 210)[n - 2 * i - 1]; sum3 += (r + 84)[2 * i + 1] * sum3_before;
                sum4_next += (r + 84)[2 * i] * sum4_before; sum4_before = (r + 252)[n - 2 * i];
                sum4 += (r + 84)[2 * i] * sum4_before; sum4_next += (r + 84)[2 * i + 1] * sum4_before;
                sum4_before = (r + 252)[n - 2 * i - 1]; sum4 += (r + 84)[2 * i + 1] * sum4_before;
            }
            (r + 294)[n] = sum3, (r + 294)[n + 1] = sum3_next;
            (r + 336)[n] = sum4, (r + 336)[n + 1] = sum4_next;
        } else {
            (r + 294)[n] = n > 1 ? (r + 294)[n] + (r + 84)[1] * (r + 210)[n - 1] + (r + 84)[n - 1] * (r + 210)[1] : (V){0};
            (r + 336)[n] = n > 1 ? (r + 336)[n] + (r + 84)[1] * (r + 252)[n - 1] + (r + 84)[n - 1] * (r + 252)[1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum5 = (r + 126)[1] * (r + 210)[n - 1], sum5_next = {0}, sum5_before = (r + 210)[n - 1];
            V sum6 = (r + 126)[1] * (r + 252)[n - 1], sum6_next = {0}, sum6_before = (r + 252)[n - 1];
            for (int i = 1; 2 * i < n; i++) {
                sum5_next += (r + 126)[2 * i] * sum5_before; sum5_before = (r + 210)[n - 2 * i];
                sum5 += (r + 126)[2 * i] * sum5_before; sum5_next += (r + 126)[2 * i + 1] * sum5_before;
                sum5_before = (r + 210)[n - 2 * i - 1]; sum5 += (r + 126)[2 * i + 1] * sum5_before;
                sum6_next += (r + 126)[2 * i] * sum6_before; sum6_before = (r + 252)[n - 2 * i];
                sum6 += (r + 126)[2 * i] * sum6_before; sum6_next += (r + 126)[2 * i + 1] * sum6_before;
                sum6_before = (r + 252)[n - 2 * i - 1]; sum6 += (r + 126)[2 * i + 1] * sum6_before;
            }
            (r + 378)[n] = sum5, (r + 378)[n + 1] = sum5_next;
            (r + 420)[n] = sum6, (r + 420)[n + 1] = sum6_next;
        } else {
            (r + 378)[n] = n > 1 ? (r + 378)[n] + (r + 126)[1] * (r + 210)[n - 1] + (r + 126)[n - 1] * (r + 210)[1] : (V){0};
            (r + 420)[n] = n > 1 ? (r + 420)[n] + (r + 126)[1] * (r + 252)[n - 1] + (r + 126)[n - 1] * (r + 252)[1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum7 = (r + 462)[1] * (r + 504)[n - 1], sum7_next = {0}, sum7_before = (r + 504)[n - 1];
            V sum8 = (r + 588)[1] * (r + 672)[n - 1], sum8_next = {0}, sum8_before = (r + 672)[n - 1];
            for (int i = 1; 2 * i < n; i++) {
                sum7_next += (r + 462)[2 * i] * sum7_before; sum7_before = (r + 504)[n - 2 * i];
                sum7 += (r + 462)[2 * i] * sum7_before; sum7_next += (r + 462)[2 * i + 1] * sum7_before;
                sum7_before = (r + 504)[n - 2 * i - 1]; sum7 += (r + 462)[2 * i + 1] * sum7_before;
                sum8_next += (r + 588)[2 * i] * sum8_before; sum8_before = (r + 672)[n - 2 * i];
                sum8 += (r + 588)[2 * i] * sum8_before; sum8_next += (r + 588)[2 * i + 1] * sum8_before;
                sum8_before = (r + 672)[n - 2 * i - 1]; sum8 += (r + 588)[2 * i + 1] * sum8_before;
            }
            (r + 504)[n] = sum7, (r + 504)[n + 1] = sum7_next;
            (r + 714)[n] = sum8, (r + 714)[n + 1] = sum8_next;
        } else {
            (r + 504)[n] = n > 1 ? (r + 504)[n] + (r + 462)[1] * (r + 504)[n - 1] + (r + 462)[n - 1] * (r + 504)[1] : (V){0};
            (r + 714)[n] = n > 1 ? (r + 714)[n] + (r + 588)[1] * (r + 672)[n - 1] + (r + 588)[n - 1] * (r + 672)[1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum0 = {0}, sum0_next = {0};
            for (int i = 1; 2 * i < n; i++) {
                const V sum0_now = (r + 42)[n - i]; sum0 += (r + 42)[i] * sum0_now; sum0_next += (r + 42)[i + 1] * sum0_now;
            }
            if (squares) (r + 630)[n] = 2.0 * sum0 + (r + 42)[n / 2] * (r + 42)[n / 2], (r + 630)[n + 1] = 2.0 * sum0_next;
        } else {
            if (squares) (r + 630)[n] = n > 1 ? (r + 630)[n] + 2.0 * (r + 42)[1] * (r + 42)[n - 1] : (V){0};
        }
        const V x0 = (r + 0)[n];
        const V x1 = (r + 42)[n];
        const V x2 = (r + 84)[n];
        const V x3 = (r + 126)[n];
        V x15 = (r + 630)[n];
        if (squares) {
            const V sum0 = x15;
            x15 = sum0 + 2.0 * (r + 42)[0] * x1;
            (r + 630)[n] = x15;
        }
        V x4 = (r + 168)[n];
        {
            x4 = x0 * n;
            (r + 168)[n] = x4;
        }
        V x5 = (r + 210)[n];
        V x6 = (r + 252)[n];
        {
            const V sum0 = x5;
            const V sum1 = x6;
            const V b = 1.0 - (r + 252)[0];
            x5 = b * x0 - by_n * sum1;
            x6 = by_n * sum0 + (r + 210)[0] * x0;
            (r + 210)[n] = x5;
            (r + 252)[n] = x6;
        }
        V x7 = (r + 294)[n];
        {
            const V sum0 = x7;
            x7 = sum0 + (r + 84)[0] * x5 + x2 * (r + 210)[0];
            (r + 294)[n] = x7;
        }
        V x8 = (r + 336)[n];
        {
            const V sum0 = x8;
            x8 = sum0 + (r + 84)[0] * x6 + x2 * (r + 252)[0];
            (r + 336)[n] = x8;
        }
        V x9 = (r + 378)[n];
        {
            const V sum0 = x9;
            x9 = sum0 + (r + 126)[0] * x5 + x3 * (r + 210)[0];
            (r + 378)[n] = x9;
        }
        V x10 = (r + 420)[n];
        {
            const V sum0 = x10;
            x10 = sum0 + (r + 126)[0] * x6 + x3 * (r + 252)[0];
            (r + 420)[n] = x10;
        }
        V x11;
        {
            x11 = (V){0};
            x11 += c[own[32]] * x1;
            (r + 462)[n] = x11;
        }
        V x12 = (r + 504)[n];
        V x13 = (r + 546)[n];
        {
            const V sum0 = x12;
            x12 = -((sum0 + (r + 504)[0] * x11) * (r + 504)[0]);
            x13 = x12;
            (r + 504)[n] = x12;
            (r + 546)[n] = x13;
        }
        V x14;
        {
            x14 = (V){0};
            x14 += c[own[42]] * x13;
            (r + 588)[n] = x14;
        }
        V x16;
        {
            x16 = (V){0};
            x16 += c[own[56]] * x2;
            x16 += c[own[57]] * x3;
            x16 += c[own[58]] * x5;
            x16 += c[own[59]] * x6;
            x16 += c[own[60]] * x7;
            x16 += c[own[61]] * x8;
            x16 += c[own[62]] * x9;
            x16 += c[own[63]] * x10;
            x16 += c[own[64]] * x15;
            (r + 672)[n] = x16;
        }
        V x17 = (r + 714)[n];
        {
            const V sum0 = x17;
            x17 = sum0 + (r + 588)[0] * x16 + x14 * (r + 672)[0];
            (r + 714)[n] = x17;
        }
        V x18;
        {
            x18 = (V){0};
            x18 += c[own[84]] * x2;
            x18 += c[own[85]] * x3;
            x18 += c[own[86]] * x5;
            x18 += c[own[87]] * x6;
            x18 += c[own[88]] * x7;
            x18 += c[own[89]] * x8;
            x18 += c[own[90]] * x9;
            x18 += c[own[91]] * x10;
            x18 += c[own[92]] * x14;
            x18 += c[own[93]] * x16;
            x18 += c[own[94]] * x17;
            (r + 756)[n] = x18;
        }
        if (moves) {
            (r + 0)[n + 1] = x1 * inverse[n + 1];
            (r + 42)[n + 1] = x18 * inverse[n + 1];
        }
    }
}
static void later_10(LATER)
{
    int n = 0;
    const V x5 = (r + 210)[n];
    const V x6 = (r + 252)[n];
    const V x16 = (r + 672)[n];
    V x19;
    {
        x19 = c[own[99]];
        x19 += c[own[100]] * x16;
        (r + 798)[n] = x19;
    }
    V x20;
    {
        x20 = c[own[106]];
        x20 += c[own[107]] * x5;
        x20 += c[own[108]] * x6;
        (r + 840)[n] = x20;
    }
    for (n = 1; n < top; n++) {
        const V x5 = (r + 210)[n];
        const V x6 = (r + 252)[n];
        const V x16 = (r + 672)[n];
        V x19;
        {
            x19 = (V){0};
            x19 += c[own[100]] * x16;
            (r + 798)[n] = x19;
        }
        V x20;
        {
            x20 = (V){0};
            x20 += c[own[107]] * x5;
            x20 += c[own[108]] * x6;
            (r + 840)[n] = x20;
        }
    }
}
static void orders_11(ORDERS)
{
    if (n == 0) {
        const V x0 = (r + 0)[n];
        const V x1 = (r + 42)[n];
        V x12 = (r + 504)[n];
        if (squares) {
            x12 = x1 * x1;
            (r + 504)[n] = x12;
        }
        V x2;
        {
            x2 = (V){0};
            (r + 84)[n] = x2;
        }
        V x3;
        V x4;
        {
            const V t1 = IN(map)(sin, 0.5 * x0);
            x3 = IN(map)(sin, x0);
            x4 = 2.0 * (t1 * t1);
            (r + 126)[n] = x3;
            (r + 168)[n] = x4;
        }
        V x5;
        {
            x5 = c[own[15]];
            x5 += c[own[16]] * x0;
            (r + 210)[n] = x5;
        }
        V x6;
        V x7;
        V x8;
        V x9;
        V x10;
        V x11;
        {
            const V t1 = x0 * x0;
            const V t2 = x0 * t1;
            const V t3 = t1 * t1;
            x6 = t1;
            x7 = t2;
            x8 = t3;
            x9 = x0 * t3;
            x10 = t1 * t3;
            x11 = t2 * t3;
            (r + 252)[n] = x6;
            (r + 294)[n] = x7;
            (r + 336)[n] = x8;
            (r + 378)[n] = x9;
            (r + 420)[n] = x10;
            (r + 462)[n] = x11;
        }
        V x13;
        {
            x13 = c[own[38]];
            x13 += c[own[39]] * x0;
            x13 += c[own[40]] * x3;
            x13 += c[own[41]] * x4;
            x13 += c[own[42]] * x6;
            x13 += c[own[43]] * x7;
            x13 += c[own[44]] * x8;
            x13 += c[own[45]] * x9;
            x13 += c[own[46]] * x10;
            x13 += c[own[47]] * x11;
            x13 += c[own[48]] * x12;
            (r + 546)[n] = x13;
        }
        V x14;
        {
            x14 = x5 * x13;
            (r + 588)[n] = x14;
        }
        V x15;
        {
            x15 = c[own[61]];
            x15 += c[own[62]] * x3;
            x15 += c[own[63]] * x4;
            x15 += c[own[64]] * x5;
            x15 += c[own[65]] * x13;
            x15 += c[own[66]] * x14;
            (r + 630)[n] = x15;
        }
        if (moves) {
            (r + 0)[n + 1] = x1 * inverse[n + 1];
            (r + 42)[n + 1] = x15 * inverse[n + 1];
        }
        n++;
    }
    for (; n < behind; n++) {
        const double by_n = inverse[n];
        if (n % 2 == 0) {
            V sum1 = (r + 84)[1] * (r + 126)[n - 1], sum1_next = {0}, sum1_before = (r + 126)[n - 1];
            V sum2 = (r + 84)[1] * (r + 168)[n - 1], sum2_next = {0}, sum2_before = (r + 168)[n - 1];
            for (int i = 1; 2 * i < n; i++) {
                sum1_next += (r + 84)[2 * i] * sum1_before; sum1_before = (r + 126)[n - 2 * i];
                sum1 += (r + 84)[2 * i] * sum1_before; sum1_next += (r + 84)[2 * i + 1] * sum1_before;
                sum1_before = (r + 126)[n - 2 * i - 1]; sum1 += (r + 84)[2 * i + 1] * sum1_before;
                sum2_next += (r + 84)[2 * i] * sum2_before; sum2_before = (r + 168)[n - 2 * i];
                sum2 += (r + 84)[2 * i] * sum2_before; sum2_next += (r + 84)[2 * i + 1] * sum2_before;
                sum2_before = (r + 168)[n - 2 * i - 1]; sum2 += (r + 84)[2 * i + 1] * sum2_before;
            }
            (r + 126)[n] = sum1, (r + 126)[n + 1] = sum1_next;
            (r + 168)[n] = sum2, (r + 168)[n + 1] = sum2_next;
        } else {
            (r + 126)[n] = n > 1 ? (r + 126)[n] + (r + 84)[1] * (r + 126)[n - 1] + (r + 84)[n - 1] * (r + 126)[1] : (V){0};
            (r + 168)[n] = n > 1 ? (r + 168)[n] + (r + 84)[1] * (r + 168)[n - 1] + (r + 84)[n - 1] * (r + 168)[1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum3 = (r + 0)[1] * (r + 252)[n - 1], sum3_next = {0}, sum3_before = (r + 252)[n - 1];
            V sum4 = (r + 0)[1] * (r + 294)[n - 1], sum4_next = {0}, sum4_before = (r + 294)[n - 1];
            for (int i = 1; 2 * i < n; i++) {
                sum3_next += (r + 0)[2 * i] * sum3_before; sum3_before = (r + 252)[n - 2 * i];
                sum3 += (r + 0)[2 * i] * sum3_before; sum3_next += (r + 0)[2 * i + 1] * sum3_before;
                sum3_before = (r + 252)[n - 2 * i - 1]; sum3 += (r + 0)[2 * i + 1] * sum3_before;
                sum4_next += (r + 0)[2 * i] * sum4_before; sum4_before = (r + 294)[n - 2 * i];
                sum4 += (r + 0)[2 * i] * sum4_before; sum4_next += (r + 0)[2 * i + 1] * sum4_before;
                sum4_before = (r + 294)[n - 2 * i - 1]; sum4 += (r + 0)[2 * i + 1] * sum4_before;
            }
            (r + 252)[n] = sum3, (r + 252)[n + 1] = sum3_next;
            (r + 294)[n] = sum4, (r + 294)[n + 1] = sum4_next;
        } else {
            (r + 252)[n] = n > 1 ? (r + 252)[n] + (r + 0)[1] * (r + 252)[n - 1] + (r + 0)[n - 1] * (r + 252)[1] : (V){0};
            (r + 294)[n] = n > 1 ? (r + 294)[n] + (r + 0)[1] * (r + 294)[n - 1] + (r + 0)[n - 1] * (r + 294)[1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum5 = (r + 0)[1] * (r + 336)[n - 1], sum5_next = {0}, sum5_before = (r + 336)[n - 1];
            V sum6 = (r + 0)[1] * (r + 378)[n - 1], sum6_next = {0}, sum6_before = (r + 378)[n - 1];
            for (int i = 1; 2 * i < n; i++) {
                sum5_next += (r + 0)[2 * i] * sum5_before; sum5_before = (r + 336)[n - 2 * i];
                sum5 += (r + 0)[2 * i] * sum5_before; sum5_next += (r + 0)[2 * i + 1] * sum5_before;
                sum5_before = (r + 336)[n - 2 * i - 1]; sum5 += (r + 0)[2 * i + 1] * sum5_before;
                sum6_next += (r + 0)[2 * i] * sum6_before; sum6_before = (r + 378)[n - 2 * i];
                sum6 += (r + 0)[2 * i] * sum6_before; sum6_next += (r + 0)[2 * i + 1] * sum6_before;
                sum6_before = (r + 378)[n - 2 * i - 1]; sum6 += (r + 0)[2 * i + 1] * sum6_before;
            }
            (r + 336)[n] = sum5, (r + 336)[n + 1] = sum5_next;
            (r + 378)[n] = sum6, (r + 378)[n + 1] = sum6_next;
        } else {
            (r + 336)[n] = n > 1 ? (r + 336)[n] + (r + 0)[1] * (r + 336)[n - 1] + (r + 0)[n - 1] * (r + 336)[1] : (V){0};
            (r + 378)[n] = n > 1 ? (r + 378)[n] + (r + 0)[1] * (r + 378)[n - 1] + (r + 0)[n - 1] * (r + 378)[1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum7 = (r + 0)[1] * (r + 420)[n - 1], sum7_next = {0}, sum7_before = (r + 420)[n - 1];
            V sum9 = (r + 210)[1] * (r + 546)[n - 1], sum9_next = {0}, sum9_before = (r + 546)[n - 1];
            for (int i = 1; 2 * i < n; i++) {
                sum7_next += (r + 0)[2 * i] * sum7_before; sum7_before = (r + 420)[n - 2 * i];
                sum7 += (r + 0)[2 * i] * sum7_before; sum7_next += (r + 0)[2 * i + 1] * sum7_before;
                sum7_before = (r + 420)[n - 2 * i - 1]; sum7 += (r + 0)[2 * i + 1] * sum7_before;
                sum9_next += (r + 210)[2 * i] * sum9_before; sum9_before = (r + 546)[n - 2 * i];
                sum9 += (r + 210)[2 * i] * sum9_before; sum9_next += (r + 210)[2 * i + 1] * sum9_before;
                sum9_before = (r + 546)[n - 2 * i - 1]; sum9 += (r + 210)[2 * i + 1] * sum9_before;
            }
            (r + 420)[n] = sum7, (r + 420)[n + 1] = sum7_next;
            (r + 588)[n] = sum9, (r + 588)[n + 1] = sum9_next;
        } else {
            (r + 420)[n] = n > 1 ? (r + 420)[n] + (r + 0)[1] * (r + 420)[n - 1] + (r + 0)[n - 1] * (r + 420)[1] : (V){0};
            (r + 588)[n] = n > 1 ? (r + 588)[n] + (r + 210)[1] * (r + 546)[n - 1] + (r + 210)[n - 1] * (r + 546)[1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum0 = {0}, sum0_next = {0};
            V sum8 = {0}, sum8_next = {0};
            for (int i = 1; 2 * i < n; i++) {
                const V sum0_now = (r + 42)[n - i]; sum0 += (r + 42)[i] * sum0_now; sum0_next += (r + 42)[i + 1] * sum0_now;
                const V sum8_now = (r + 0)[n - i]; sum8 += (r + 0)[i] * sum8_now; sum8_next += (r + 0)[i + 1] * sum8_now;
            }
            if (squares) (r + 504)[n] = 2.0 * sum0 + (r + 42)[n / 2] * (r + 42)[n / 2], (r + 504)[n + 1] = 2.0 * sum0_next;
            (r + 462)[n] = 2.0 * sum8 + (r + 0)[n / 2] * (r + 0)[n / 2], (r + 462)[n + 1] = 2.0 * sum8_next;
        } else {
            if (squares) (r + 504)[n] = n > 1 ? (r + 504)[n] + 2.0 * (r + 42)[1] * (r + 42)[n - 1] : (V){0};
            (r + 462)[n] = n > 1 ? (r + 462)[n] + 2.0 * (r + 0)[1] * (r + 0)[n - 1] : (V){0};
        }
        const V x0 = (r + 0)[n];
        const V x1 = (r + 42)[n];
        V x12 = (r + 504)[n];
        if (squares) {
            const V sum0 = x12;
            x12 = sum0 + 2.0 * (r + 42)[0] * x1;
            (r + 504)[n] = x12;
        }
        V x2 = (r + 84)[n];
        {
            x2 = x0 * n;
            (r + 84)[n] = x2;
        }
        V x3 = (r + 126)[n];
        V x4 = (r + 168)[n];
        {
            const V sum0 = x3;
            const V sum1 = x4;
            const V b = 1.0 - (r + 168)[0];
            x3 = b * x0 - by_n * sum1;
            x4 = by_n * sum0 + (r + 126)[0] * x0;
            (r + 126)[n] = x3;
            (r + 168)[n] = x4;
        }
        V x5;
        {
            x5 = (V){0};
            x5 += c[own[16]] * x0;
            (r + 210)[n] = x5;
        }
        V x6 = (r + 252)[n];
        V x7 = (r + 294)[n];
        V x8 = (r + 336)[n];
        V x9 = (r + 378)[n];
        V x10 = (r + 420)[n];
        V x11 = (r + 462)[n];
        {
            const V sum0 = x6;
            const V sum1 = x7;
            const V sum2 = x8;
            const V sum3 = x9;
            const V sum4 = x10;
            const V sum5 = x11;
            x6 = sum5 + 2.0 * (r + 0)[0] * x0;
            x7 = sum0 + (r + 252)[0] * x0 + x6 * (r + 0)[0];
            x8 = sum1 + (r + 294)[0] * x0 + x7 * (r + 0)[0];
            x9 = sum2 + (r + 336)[0] * x0 + x8 * (r + 0)[0];
            x10 = sum3 + (r + 378)[0] * x0 + x9 * (r + 0)[0];
            x11 = sum4 + (r + 420)[0] * x0 + x10 * (r + 0)[0];
            (r + 252)[n] = x6;
            (r + 294)[n] = x7;
            (r + 336)[n] = x8;
            (r + 378)[n] = x9;
            (r + 420)[n] = x10;
            (r + 462)[n] = x11;
        }
        V x13;
        {
            x13 = (V){0};
            x13 += c[own[39]] * x0;
            x13 += c[own[40]] * x3;
            x13 += c[own[41]] * x4;
            x13 += c[own[42]] * x6;
            x13 += c[own[43]] * x7;
            x13 += c[own[44]] * x8;
            x13 += c[own[45]] * x9;
            x13 += c[own[46]] * x10;
            x13 += c[own[47]] * x11;
            x13 += c[own[48]] * x12;
            (r + 546)[n] = x13;
        }
        V x14 = (r + 588)[n];
        {
            const V sum0 = x14;
            x14 = sum0 + (r + 210)[0] * x13 + x5 * (r + 546)[0];
            (r + 588)[n] = x14;
        }
        V x15;
        {
            x15 = (V){0};
            x15 += c[own[62]] * x3;
            x15 += c[own[63]] * x4;
            x15 += c[own[64]] * x5;
            x15 += c[own[65]] * x13;
            x15 += c[own[66]] * x14;
            (r + 630)[n] = x15;
        }
        if (moves) {
            (r + 0)[n + 1] = x1 * inverse[n + 1];
            (r + 42)[n + 1] = x15 * inverse[n + 1];
        }
    }
}
static void later_11(LATER)
{
    int n = 0;
    const V x3 = (r + 126)[n];
    const V x4 = (r + 168)[n];
    const V x13 = (r + 546)[n];
    V x16;
    {
        x16 = c[own[71]];
        x16 += c[own[72]] * x13;
        (r + 672)[n] = x16;
    }
    V x17;
    {
        x17 = c[own[78]];
        x17 += c[own[79]] * x3;
        x17 += c[own[80]] * x4;
        (r + 714)[n] = x17;
    }
    for (n = 1; n < top; n++) {
        const V x3 = (r + 126)[n];
        const V x4 = (r + 168)[n];
        const V x13 = (r + 546)[n];
        V x16;
        {
            x16 = (V){0};
            x16 += c[own[72]] * x13;
            (r + 672)[n] = x16;
        }
        V x17;
        {
            x17 = (V){0};
            x17 += c[own[79]] * x3;
            x17 += c[own[80]] * x4;
            (r + 714)[n] = x17;
        }
    }
}
static void orders_12(ORDERS)
{
    if (n == 0) {
        const V x0 = (r + 0)[n];
        const V x1 = (r + 42)[n];
        const V x2 = (r + 84)[n];
        V x9 = (r + 378)[n];
        if (squares) {
            x9 = x1 * x1;
            (r + 378)[n] = x9;
        }
        V x3;
        {
            x3 = (V){0};
            (r + 126)[n] = x3;
        }
        V x4;
        V x5;
        {
            const V t1 = IN(map)(sin, 0.5 * x0);
            x4 = IN(map)(sin, x0);
            x5 = 2.0 * (t1 * t1);
            (r + 168)[n] = x4;
            (r + 210)[n] = x5;
        }
        V x6;
        {
            x6 = x2 * x4;
            (r + 252)[n] = x6;
        }
        V x7;
        {
            x7 = x2 * x5;
            (r + 294)[n] = x7;
        }
        V x8;
        {
            x8 = c[own[23]];
            x8 += c[own[24]] * x0;
            (r + 336)[n] = x8;
        }
        V x10;
        {
            x10 = c[own[34]];
            x10 += c[own[35]] * x2;
            x10 += c[own[36]] * x4;
            x10 += c[own[37]] * x5;
            x10 += c[own[38]] * x6;
            x10 += c[own[39]] * x7;
            x10 += c[own[40]] * x9;
            (r + 420)[n] = x10;
        }
        V x11;
        {
            x11 = x8 * x10;
            (r + 462)[n] = x11;
        }
        V x12;
        {
            x12 = c[own[56]];
            x12 += c[own[57]] * x2;
            x12 += c[own[58]] * x4;
            x12 += c[own[59]] * x5;
            x12 += c[own[60]] * x6;
            x12 += c[own[61]] * x7;
            x12 += c[own[62]] * x8;
            x12 += c[own[63]] * x10;
            x12 += c[own[64]] * x11;
            (r + 504)[n] = x12;
        }
        if (moves) {
            (r + 0)[n + 1] = x1 * inverse[n + 1];
            (r + 42)[n + 1] = x12 * inverse[n + 1];
        }
        n++;
    }
    for (; n < behind; n++) {
        const double by_n = inverse[n];
        if (n % 2 == 0) {
            V sum1 = (r + 126)[1] * (r + 168)[n - 1], sum1_next = {0}, sum1_before = (r + 168)[n - 1];
            V sum2 = (r + 126)[1] * (r + 210)[n - 1], sum2_next = {0}, sum2_before = (r + 210)[n - 1];
            for (int i = 1; 2 * i < n; i++) {
                sum1_next += (r + 126)[2 * i] * sum1_before; sum1_before = (r + 168)[n - 2 * i];
                sum1 += (r + 126)[2 * i] * sum1_before; sum1_next += (r + 126)[2 * i + 1] * sum1_before;
                sum1_before = (r + 168)[n - 2 * i - 1]; sum1 += (r + 126)[2 * i + 1] * sum1_before;
                sum2_next += (r + 126)[2 * i] * sum2_before; sum2_before = (r + 210)[n - 2 * i];
                sum2 += (r + 126)[2 * i] * sum2_before; sum2_next += (r + 126)[2 * i + 1] * sum2_before;
                sum2_before = (r + 210)[n - 2 * i - 1]; sum2 += (r + 126)[2 * i + 1] * sum2_before;
            }
            (r + 168)[n] = sum1, (r + 168)[n + 1] = sum1_next;
            (r + 210)[n] = sum2, (r + 210)[n + 1] = sum2_next;
        } else {
            (r + 168)[n] = n > 1 ? (r + 168)[n] + (r + 126)[1] * (r + 168)[n - 1] + (r + 126)[n - 1] * (r + 168)[1] : (V){0};
            (r + 210)[n] = n > 1 ? (r + 210)[n] + (r + 126)[1] * (r + 210)[n - 1] + (r + 126)[n - 1] * (r + 210)[1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum3 = (r + 84)[1] * (r + 168)[n - 1], sum3_next = {0}, sum3_before = (r + 168)[n - 1];
            V sum4 = (r + 84)[1] * (r + 210)[n - 1], sum4_next = {0}, sum4_before = (r + 210)[n - 1];
            for (int i = 1; 2 * i < n; i++) {
                sum3_next += (r + 84)[2 * i] * sum3_before; sum3_before = (r + 168)[n - 2 * i];
                sum3 += (r + 84)[2 * i] * sum3_before; sum3_next += (r + 84)[2 * i + 1] * sum3_before;
                sum3_before = (r + 168)[n - 2 * i - 1]; sum3 += (r + 84)[2 * i + 1] * sum3_before;
                sum4_next += (r + 84)[2 * i] * sum4_before; sum4_before = (r + 210)[n - 2 * i];
                sum4 += (r + 84)[2 * i] * sum4_before; sum4_next += (r + 84)[2 * i + 1] * sum4_before;
                sum4_before = (r + 210)[n - 2 * i - 1]; sum4 += (r + 84)[2 * i + 1] * sum4_before;
            }
            (r + 252)[n] = sum3, (r + 252)[n + 1] = sum3_next;
            (r + 294)[n] = sum4, (r + 294)[n + 1] = sum4_next;
        } else {
            (r + 252)[n] = n > 1 ? (r + 252)[n] + (r + 84)[1] * (r + 168)[n - 1] + (r + 84)[n - 1] * (r + 168)[1] : (V){0};
            (r + 294)[n] = n > 1 ? (r + 294)[n] + (r + 84)[1] * (r + 210)[n - 1] + (r + 84)[n - 1] * (r + 210)[1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum5 = (r + 336)[1] * (r + 420)[n - 1], sum5_next = {0}, sum5_before = (r + 420)[n - 1];
            V sum0 = {0}, sum0_next = {0};
            for (int i = 1; 2 * i < n; i++) {
                sum5_next += (r + 336)[2 * i] * sum5_before; sum5_before = (r + 420)[n - 2 * i];
                sum5 += (r + 336)[2 * i] * sum5_before; sum5_next += (r + 336)[2 * i + 1] * sum5_before;
                sum5_before = (r + 420)[n - 2 * i - 1]; sum5 += (r + 336)[2 * i + 1] * sum5_before;
                const V sum0_now = (r + 42)[n - i]; sum0 += (r + 42)[i] * sum0_now; sum0_next += (r + 42)[i + 1] * sum0_now;
            }
            (r + 462)[n] = sum5, (r + 462)[n + 1] = sum5_next;
            if (squares) (r + 378)[n] = 2.0 * sum0 + (r + 42)[n / 2] * (r + 42)[n / 2], (r + 378)[n + 1] = 2.0 * sum0_next;
        } else {
            (r + 462)[n] = n > 1 ? (r + 462)[n] + (r + 336)[1] * (r + 420)[n - 1] + (r + 336)[n - 1] * (r + 420)[1] : (V){0};
            if (squares) (r + 378)[n] = n > 1 ? (r + 378)[n] + 2.0 * (r + 42)[1] * (r + 42)[n - 1] : (V){0};
        }
        const V x0 = (r + 0)[n];
        const V x1 = (r + 42)[n];
        const V x2 = (r + 84)[n];
        V x9 = (r + 378)[n];
        if (squares) {
            const V sum0 = x9;
            x9 = sum0 + 2.0 * (r + 42)[0] * x1;
            (r + 378)[n] = x9;
        }
        V x3 = (r + 126)[n];
        {
            x3 = x0 * n;
            (r + 126)[n] = x3;
        }
        V x4 = (r + 168)[n];
        V x5 = (r + 210)[n];
        {
            const V sum0 = x4;
            const V sum1 = x5;
            const V b = 1.0 - (r + 210)[0];
            x4 = b * x0 - by_n * sum1;
            x5 = by_n * sum0 + (r + 168)[0] * x0;
            (r + 168)[n] = x4;
            (r + 210)[n] = x5;
        }
        V x6 = (r + 252)[n];
        {
            const V sum0 = x6;
            x6 = sum0 + (r + 84)[0] * x4 + x2 * (r + 168)[0];
            (r + 252)[n] = x6;
        }
        V x7 = (r + 294)[n];
        {
            const V sum0 = x7;
            x7 = sum0 + (r + 84)[0] * x5 + x2 * (r + 210)[0];
            (r + 294)[n] = x7;
        }
        V x8;
        {
            x8 = (V){0};
            x8 += c[own[24]] * x0;
            (r + 336)[n] = x8;
        }
        V x10;
        {
            x10 = (V){0};
            x10 += c[own[35]] * x2;
            x10 += c[own[36]] * x4;
            x10 += c[own[37]] * x5;
            x10 += c[own[38]] * x6;
            x10 += c[own[39]] * x7;
            x10 += c[own[40]] * x9;
            (r + 420)[n] = x10;
        }
        V x11 = (r + 462)[n];
        {
            const V sum0 = x11;
            x11 = sum0 + (r + 336)[0] * x10 + x8 * (r + 420)[0];
            (r + 462)[n] = x11;
        }
        V x12;
        {
            x12 = (V){0};
            x12 += c[own[57]] * x2;
            x12 += c[own[58]] * x4;
            x12 += c[own[59]] * x5;
            x12 += c[own[60]] * x6;
            x12 += c[own[61]] * x7;
            x12 += c[own[62]] * x8;
            x12 += c[own[63]] * x10;
            x12 += c[own[64]] * x11;
            (r + 504)[n] = x12;
        }
        if (moves) {
            (r + 0)[n + 1] = x1 * inverse[n + 1];
            (r + 42)[n + 1] = x12 * inverse[n + 1];
        }
    }
}
static void later_12(LATER)
{
    int n = 0;
    const V x4 = (r + 168)[n];
    const V x5 = (r + 210)[n];
    const V x10 = (r + 420)[n];
    V x13;
    {
        x13 = c[own[69]];
        x13 += c[own[70]] * x10;
        (r + 546)[n] = x13;
    }
    V x14;
    {
        x14 = c[own[76]];
        x14 += c[own[77]] * x4;
        x14 += c[own[78]] * x5;
        (r + 588)[n] = x14;
    }
    for (n = 1; n < top; n++) {
        const V x4 = (r + 168)[n];
        const V x5 = (r + 210)[n];
        const V x10 = (r + 420)[n];
        V x13;
        {
            x13 = (V){0};
            x13 += c[own[70]] * x10;
            (r + 546)[n] = x13;
        }
        V x14;
        {
            x14 = (V){0};
            x14 += c[own[77]] * x4;
            x14 += c[own[78]] * x5;
            (r + 588)[n] = x14;
        }
    }
}
static void orders_13(ORDERS)
{
    if (n == 0) {
        const V x0 = (r + 0)[n];
        const V x1 = (r + 42)[n];
        const V x2 = (r + 84)[n];
        const V x3 = (r + 126)[n];
        V x12 = (r + 504)[n];
        if (squares) {
            x12 = x1 * x1;
            (r + 504)[n] = x12;
        }
        V x4;
        {
            x4 = (V){0};
            (r + 168)[n] = x4;
        }
        V x5;
        V x6;
        {
            const V t1 = IN(map)(sin, 0.5 * x0);
            x5 = IN(map)(sin, x0);
            x6 = 2.0 * (t1 * t1);
            (r + 210)[n] = x5;
            (r + 252)[n] = x6;
        }
        V x7;
        {
            x7 = x2 * x5;
            (r + 294)[n] = x7;
        }
        V x8;
        {
            x8 = x2 * x6;
            (r + 336)[n] = x8;
        }
        V x9;
        {
            x9 = x3 * x5;
            (r + 378)[n] = x9;
        }
        V x10;
        {
            x10 = x3 * x6;
            (r + 420)[n] = x10;
        }
        V x11;
        {
            x11 = c[own[31]];
            x11 += c[own[32]] * x0;
            (r + 462)[n] = x11;
        }
        V x13;
        {
            x13 = c[own[45]];
            x13 += c[own[46]] * x2;
            x13 += c[own[47]] * x3;
            x13 += c[own[48]] * x5;
            x13 += c[own[49]] * x6;
            x13 += c[own[50]] * x7;
            x13 += c[own[51]] * x8;
            x13 += c[own[52]] * x9;
            x13 += c[own[53]] * x10;
            x13 += c[own[54]] * x12;
            (r + 546)[n] = x13;
        }
        V x14;
        {
            x14 = x11 * x13;
            (r + 588)[n] = x14;
        }
        V x15;
        {
            x15 = c[own[73]];
            x15 += c[own[74]] * x2;
            x15 += c[own[75]] * x3;
            x15 += c[own[76]] * x5;
            x15 += c[own[77]] * x6;
            x15 += c[own[78]] * x7;
            x15 += c[own[79]] * x8;
            x15 += c[own[80]] * x9;
            x15 += c[own[81]] * x10;
            x15 += c[own[82]] * x11;
            x15 += c[own[83]] * x13;
            x15 += c[own[84]] * x14;
            (r + 630)[n] = x15;
        }
        if (moves) {
            (r + 0)[n + 1] = x1 * inverse[n + 1];
            (r + 42)[n + 1] = x15 * inverse[n + 1];
        }
        n++;
    }
    for (; n < behind; n++) {
        const double by_n = inverse[n];
        if (n % 2 == 0) {
            V sum1 = (r + 168)[1] * (r + 210)[n - 1], sum1_next = {0}, sum1_before = (r + 210)[n - 1];
            V sum2 = (r + 168)[1] * (r + 252)[n - 1], sum2_next = {0}, sum2_before = (r + 252)[n - 1];
            for (int i = 1; 2 * i < n; i++) {
                sum1_next += (r + 168)[2 * i] * sum1_before; sum1_before = (r + 210)[n - 2 * i];
                sum1 += (r + 168)[2 * i] * sum1_before; sum1_next += (r + 168)[2 * i + 1] * sum1_before;
                sum1_before = (r + 210)[n - 2 * i - 1]; sum1 += (r + 168)[2 * i + 1] * sum1_before;
                sum2_next += (r + 168)[2 * i] * sum2_before; sum2_before = (r + 252)[n - 2 * i];
                sum2 += (r + 168)[2 * i] * sum2_before; sum2_next += (r + 168)[2 * i + 1] * sum2_before;
                sum2_before = (r + 252)[n - 2 * i - 1]; sum2 += (r + 168)[2 * i + 1] * sum2_before;
            }
            (r + 210)[n] = sum1, (r + 210)[n + 1] = sum1_next;
            (r + 252)[n] = sum2, (r + 252)[n + 1] = sum2_next;
        } else {
            (r + 210)[n] = n > 1 ? (r + 210)[n] + (r + 168)[1] * (r + 210)[n - 1] + (r + 168)[n - 1] * (r + 210)[1] : (V){0};
            (r + 252)[n] = n > 1 ? (r + 252)[n] + (r + 168)[1] * (r + 252)[n - 1] + (r + 168)[n - 1] * (r + 252)[1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum3 = (r + 84)[1] * (r + 210)[n - 1], sum3_next = {0}, sum3_before = (r + 210)[n - 1];
            V sum4 = (r + 84)[1] * (r + 252)[n - 1], sum4_next = {0}, sum4_before = (r + 252)[n - 1];
            for (int i = 1; 2 * i < n; i++) {
                sum3_next += (r + 84)[2 * i] * sum3_before; sum3_before = (r + 210)[n - 2 * i];
                sum3 += (r + 84)[2 * i] * sum3_before; sum3_next += (r + 84)[2 * i + 1] * sum3_before;
                sum3_before = (r + 210)[n - 2 * i - 1]; sum3 += (r + 84)[2 * i + 1] * sum3_before;
                sum4_next += (r + 84)[2 * i] * sum4_before; sum4_before = (r + 252)[n - 2 * i];
                sum4 += (r + 84)[2 * i] * sum4_before; sum4_next += (r + 84)[2 * i + 1] * sum4_before;
                sum4_before = (r + 252)[n - 2 * i - 1]; sum4 += (r + 84)[2 * i + 1] * sum4_before;
            }
            (r + 294)[n] = sum3, (r + 294)[n + 1] = sum3_next;
            (r + 336)[n] = sum4, (r + 336)[n + 1] = sum4_next;
        } else {
            (r + 294)[n] = n > 1 ? (r + 294)[n] + (r + 84)[1] * (r + 210)[n - 1] + (r + 84)[n - 1] * (r + 210)[1] : (V){0};
            (r + 336)[n] = n > 1 ? (r + 336)[n] + (r + 84)[1] * (r + 252)[n - 1] + (r + 84)[n - 1] * (r + 252)[1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum5 = (r + 126)[1] * (r + 210)[n - 1], sum5_next = {0}, sum5_before = (r + 210)[n - 1];
            V sum6 = (r + 126)[1] * (r + 252)[n - 1], sum6_next = {0}, sum6_before = (r + 252)[n - 1];
            for (int i = 1; 2 * i < n; i++) {
                sum5_next += (r + 126)[2 * i] * sum5_before; sum5_before = (r + 210)[n - 2 * i];
                sum5 += (r + 126)[2 * i] * sum5_before; sum5_next += (r + 126)[2 * i + 1] * sum5_before;
                sum5_before = (r + 210)[n - 2 * i - 1]; sum5 += (r + 126)[2 * i + 1] * sum5_before;
                sum6_next += (r + 126)[2 * i] * sum6_before; sum6_before = (r + 252)[n - 2 * i];
                sum6 += (r + 126)[2 * i] * sum6_before; sum6_next += (r + 126)[2 * i + 1] * sum6_before;
                sum6_before = (r + 252)[n - 2 * i - 1]; sum6 += (r + 126)[2 * i + 1] * sum6_before;
            }
            (r + 378)[n] = sum5, (r + 378)[n + 1] = sum5_next;
            (r + 420)[n] = sum6, (r + 420)[n + 1] = sum6_next;
        } else {
            (r + 378)[n] = n > 1 ? (r + 378)[n] + (r + 126)[1] * (r + 210)[n - 1] + (r + 126)[n - 1] * (r + 210)[1] : (V){0};
            (r + 420)[n] = n > 1 ? (r + 420)[n] + (r + 126)[1] * (r + 252)[n - 1] + (r + 126)[n - 1] * (r + 252)[1] : (V){0};
        }
        if (n % 2 == 0) {
            V sum7 = (r + 462)[1] * (r + 546)[n - 1], sum7_next = {0}, sum7_before = (r + 546)[n - 1];
            V sum0 = {0}, sum0_next = {0};
            for (int i = 1; 2 * i < n; i++) {
                sum7_next += (r + 462)[2 * i] * sum7_before; sum7_before = (r + 546)[n - 2 * i];
                sum7 += (r + 462)[2 * i] * sum7_before; sum7_next += (r + 462)[2 * i + 1] * sum7_before;
                sum7_before = (r + 546)[n - 2 * i - 1]; sum7 += (r + 462)[2 * i + 1] * sum7_before;
                const V sum0_now = (r + 42)[n - i]; sum0 += (r + 42)[i] * sum0_now; sum0_next += (r + 42)[i + 1] * sum0_now;
            }
            (r + 588)[n] = sum7, (r + 588)[n + 1] = sum7_next;
            if (squares) (r + 504)[n] = 2.0 * sum0 + (r + 42)[n / 2] * (r + 42)[n / 2], (r + 504)[n + 1] = 2.0 * sum0_next;
        } else {
            (r + 588)[n] = n > 1 ? (r + 588)[n] + (r + 462)[1] * (r + 546)[n - 1] + (r + 462)[n - 1] * (r + 546)[1] : (V){0};
            if (squares) (r + 504)[n] = n > 1 ? (r + 504)[n] + 2.0 * (r + 42)[1] * (r + 42)[n - 1] : (V){0};
        }
        const V x0 = (r + 0)[n];
        const V x1 = (r + 42)[n];
        const V x2 = (r + 84)[n];
        const V x3 = (r + 126)[n];
        V x12 = (r + 504)[n];
        if (squares) {
            const V sum0 = x12;
            x12 = sum0 + 2.0 * (r + 42)[0] * x1;
            (r + 504)[n] = x12;
        }
        V x4 = (r + 168)[n];
        {
            x4 = x0 * n;
            (r + 168)[n] = x4;
        }
        V x5 = (r + 210)[n];
        V x6 = (r + 252)[n];
        {
            const V sum0 = x5;
            const V sum1 = x6;
            const V b = 1.0 - (r + 252)[0];
            x5 = b * x0 - by_n * sum1;
            x6 = by_n * sum0 + (r + 210)[0] * x0;
            (r + 210)[n] = x5;
            (r + 252)[n] = x6;
        }
        V x7 = (r + 294)[n];
        {
            const V sum0 = x7;
            x7 = sum0 + (r + 84)[0] * x5 + x2 * (r + 210)[0];
            (r + 294)[n] = x7;
        }
        V x8 = (r + 336)[n];
        {
            const V sum0 = x8;
            x8 = sum0 + (r + 84)[0] * x6 + x2 * (r + 252)[0];
            (r + 336)[n] = x8;
        }
        V x9 = (r + 378)[n];
        {
            const V sum0 = x9;
            x9 = sum0 + (r + 126)[0] * x5 + x3 * (r + 210)[0];
            (r + 378)[n] = x9;
        }
        V x10 = (r + 420)[n];
        {
            const V sum0 = x10;
            x10 = sum0 + (r + 126)[0] * x6 + x3 * (r + 252)[0];
            (r + 420)[n] = x10;
        }
        V x11;
        {
            x11 = (V){0};
            x11 += c[own[32]] * x0;
            (r + 462)[n] = x11;
        }
        V x13;
        {
            x13 = (V){0};
            x13 += c[own[46]] * x2;
            x13 += c[own[47]] * x3;
            x13 += c[own[48]] * x5;
            x13 += c[own[49]] * x6;
            x13 += c[own[50]] * x7;
            x13 += c[own[51]] * x8;
            x13 += c[own[52]] * x9;
            x13 += c[own[53]] * x10;
            x13 += c[own[54]] * x12;
            (r + 546)[n] = x13;
        }
        V x14 = (r + 588)[n];
        {
            const V sum0 = x14;
            x14 = sum0 + (r + 462)[0] * x13 + x11 * (r + 546)[0];
            (r + 588)[n] = x14;
        }
        V x15;
        {
            x15 = (V){0};
            x15 += c[own[74]] * x2;
            x15 += c[own[75]] * x3;
            x15 += c[own[76]] * x5;
            x15 += c[own[77]] * x6;
            x15 += c[own[78]] * x7;
            x15 += c[own[79]] * x8;
            x15 += c[own[80]] * x9;
            x15 += c[own[81]] * x10;
            x15 += c[own[82]] * x11;
            x15 += c[own[83]] * x13;
            x15 += c[own[84]] * x14;
            (r + 630)[n] = x15;
        }
        if (moves) {
            (r + 0)[n + 1] = x1 * inverse[n + 1];
            (r + 42)[n + 1] = x15 * inverse[n + 1];
        }
    }
}
static void later_13(LATER)
{
    int n = 0;
    const V x5 = (r + 210)[n];
    const V x6 = (r + 252)[n];
    const V x13 = (r + 546)[n];
    V x16;
    {
        x16 = c[own[89]];
        x16 += c[own[90]] * x13;
        (r + 672)[n] = x16;
    }
    V x17;
    {
        x17 = c[own[96]];
        x17 += c[own[97]] * x5;
        x17 += c[own[98]] * x6;
        (r + 714)[n] = x17;
    }
    for (n = 1; n < top; n++) {
        const V x5 = (r + 210)[n];
        const V x6 = (r + 252)[n];
        const V x13 = (r + 546)[n];
        V x16;
        {
            x16 = (V){0};
            x16 += c[own[90]] * x13;
            (r + 672)[n] = x16;
        }
        V x17;
        {
            x17 = (V){0};
            x17 += c[own[97]] * x5;
            x17 += c[own[98]] * x6;
            (r + 714)[n] = x17;
        }
    }
}
static const struct { void (*orders)(ORDERS); void (*later)(LATER); } straight[] = {
    {orders_0, later_0},
    {orders_1, later_1},
    {orders_2, later_2},
    {orders_3, later_3},
    {orders_4, later_4},
    {orders_5, later_5},
    {orders_6, later_6},
    {orders_7, later_7},
    {orders_8, later_8},
    {orders_9, later_9},
    {orders_10, later_10},
    {orders_11, later_11},
    {orders_12, later_12},
    {orders_13, later_13},
};
const Traits NAMED(flow_traits, LEVEL) = {LANES, 1};
#else
const Traits NAMED(flow_traits, LEVEL) = {LANES, 0};
#endif

/* Coefficients from n on of every register that the rates need, and one more of the states of masses that move. In powers
 * of the rotation, the square of omega is a state. */
INLINE void operate(const Batch *b, int n, int behind, int by_rotation, int moves)
{
    const Job *const job = b->job;
    const int given = by_rotation && job->by_rotation == 2;
#ifdef HAS_STRAIGHT
    if (job->straight >= 0) {
        straight[job->straight].orders(job->series, b->r, b->c, n, behind, b->inverse, !given, moves);
        return;
    }
#endif
    for (; n < behind; n++) {
        const int32_t *at = job->series + 3 * given;
        while (at < job->series_end) at = operation(at, b->r, b->c, n, b->inverse[n]);
        for (const State *q = job->state; q < job->state + (moves ? job->states : 0); q++)
            b->r[q->series + n + 1] = b->r[q->rate + n] * b->inverse[n + 1];
    }
}

/* Coefficients below n of all others. */
INLINE void operate_later(const Batch *b, int n)
{
    const Job *const job = b->job;
#ifdef HAS_STRAIGHT
    if (job->straight >= 0) {
        straight[job->straight].later(job->series, b->r, b->c, n);
        return;
    }
#endif
    for (const int32_t *at = job->series_end, *next = at; at < job->later_end; at = next)
        for (int k = 0; k < n; k++) next = operation(at, b->r, b->c, k, b->inverse[k]);
}

#define REGISTER(i) (b->r + (i))

/* Pages shall be small. They solve single scenes, in which friction softens in time. */
#ifdef __wasm__
#define SOFTENS(role) 0
#define HAS_CLOSED_FORM(role) ((role)->net_sine >= 0 && (role)->loss_rate < 0)
#else
#define SOFTENS(role) ((role)->loss_rate >= 0)
#define HAS_CLOSED_FORM(role) ((role)->net_sine >= 0)
#endif

/* log2 of sizes and its inverse, straight between powers of two: up to 0.09 too small, which the (n - k)th root of the
 * radius makes a hundredth. Fixed point with 40 bits behind the point, as float64. */
#define FIXED 0x1p40
INLINE V log2_of(V x) { return (V)((M)((M)magnitude(x) >> 12) | (M)broadcast(0x1p52)) - 0x1p52; }
INLINE V power_of_two(V y)
{
    y = pick(y < 1000 * FIXED, y, broadcast(1000 * FIXED)), y = pick(y > -1000 * FIXED, y, broadcast(-1000 * FIXED));
    return (V)((M)(y + (0x1p52 + 1023 * FIXED)) << 12);
}

/* Where the piece of each lane begins, by how much a function of time jumps there, and a coefficient of the piece, in
 * powers of the distance from there. */
INLINE V breaks_at(const Batch *b, int t, V piece)
{
    const Data *const d = b->job->data + t;
    V x;
    for (unsigned k = 0; k < LANES; k++) x[k] = d->breaks[d->apart ? (int64_t)piece[k] * d->apart + b->column[k] : (int64_t)piece[k]];
    return x;
}
INLINE V jumps_at(const Batch *b, int t, V piece)
{
    const Data *const d = b->job->data + t;
    V x;
    for (unsigned k = 0; k < LANES; k++) x[k] = d->jumps[(int64_t)piece[k]];
    return x;
}
INLINE V coefficients_at(const Batch *b, int t, V piece, int j)
{
    const Data *const d = b->job->data + t;
    V x;
    for (unsigned k = 0; k < LANES; k++) {
        const int64_t row = (int64_t)piece[k] * d->terms + j;
        x[k] = d->coefficients[d->across ? row * d->across + b->column[k] : row];
    }
    return x;
}

/* The last piece of a function of time through which each lane certainly rests: it rests on while the value that begins
 * the following piece is in its quiet range, and that piece ends before a place. Most lanes rest at times of their own,
 * so that they are followed one by one. */
static V last_quiet(const Batch *b, M here, int t, V before)
{
    const Data *const d = b->job->data + t;
    const V *const c = b->c;
    V piece = c[b->job->table[t].cell + PIECE];
    EACH(k, bits(here)) {
        const int64_t column = b->column[k], across = d->across ? d->across : 1, apart = d->apart ? d->apart : 1;
        const double *const heights = d->coefficients + (d->across ? column : 0);
        const double *const breaks = d->breaks + (d->apart ? column : 0);
        const double from = c[QUIET_FROM][k], to = c[QUIET_TO][k], latest = before[k];
        int64_t now = (int64_t)piece[k];
        for (; now + 2 < d->pieces; now++) {
            const double height = heights[(now + 1) * d->terms * across];
            if (!(from <= height && height <= to && breaks[(now + 2) * apart] < latest)) break;
        }
        piece[k] = (double)now;
    }
    return piece;
}

/* Record an event of the first lane. */
static void note(const Batch *b, M here, int kind)
{
    Job *const job = b->job;
    EACH(k, bits(here)) {
        if (b->column[k] != 0 || job->noted == job->notes_room) continue;
        double *const row = job->notes + 4 * job->noted++;
        row[0] = kind, row[1] = b->c[TIME][k], row[2] = b->c[ROTATION][k], row[3] = b->c[DIRECTION][k];
    }
}

INLINE V variable_at(Batch *b, int top, V time);

/* States of a lane at sample times from `begin` up to, and without, `end`; it moves along series in r, or rests. */
static void read_samples_of(Batch *b, unsigned k, double begin, double end, int moving, int top)
{
    const Job *const job = b->job;
    const V *const c = b->c;
    if (!(end >= begin)) return;
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
        const double time = times[i * across], since = time - begin;
        if (!(time < end || (closed && time == end))) break;
        const int paced = moving && job->role->pace >= 0;
        const double past = paced ? fmin(variable_at(b, top, broadcast(since))[k], c[STEP][k]) : since;
        double states[4 + MOST_STATES];
        for (int j = -1; j < job->states; j++) { /* the rate of the second state, and the states */
            const int32_t of = j < 0 ? net : job->state[j].series;
            double sum = 0.0;
            for (int n = moving ? top - (j < 0) : -1; n >= 0; n--) sum = sum * past + REGISTER(of)[n][k];
            states[j < 0 ? 2 : j < 2 ? j : j + 2] = moving || j < 2 ? sum : c[job->state[j].cell][k];
        }
        states[3] = c[SLIP][k] + states[0], states[0] = c[ROTATION][k] + c[DIRECTION][k] * states[0];
        if (paced) states[2] /= 1.0 + c[job->role->pace][k] * states[1];
        states[1] *= c[DIRECTION][k], states[2] *= c[DIRECTION][k];
        for (int j = 0; j < job->states + 2; j++) job->outputs[(j * job->samples + i) * job->count + column] = states[j];
    }
}

static void read_samples(Batch *b, M here, V begin, V end, int moving, int top)
{
    EACH(k, bits(here)) read_samples_of(b, k, begin[k], end[k], moving, top);
}

/* A sample time of each lane, and the states of lanes that move then. */
INLINE V sample_time(const Batch *b, int i)
{
    const Job *const job = b->job;
    const double *times = job->times + i * (int64_t)job->times_across;
    V time;
    for (int k = 0; k < LANES; k++) time[k] = times[job->times_across > 1 ? b->column[k] : 0];
    return time;
}
static void keep_sample(const Batch *b, M here, int i, V x, V omega, V rate)
{
    const Job *const job = b->job;
    const V *const c = b->c, side = c[DIRECTION], states[4] = {c[ROTATION] + side * x, side * omega, side * rate, c[SLIP] + x};
    EACH(k, bits(here))
        for (int j = 0; j < 4; j++) job->outputs[(j * job->samples + i) * job->count + b->column[k]] = states[j][k];
}

/* --- the text of derive/flow/integrator --- */

static const double SINES[] = {0.0, 0.009607359798384776, 0.03806023374435662, 0.08426519384872735, 0.14644660940672624, 0.22221488349019888, 0.3086582838174551, 0.40245483899193585, 0.4999999999999999};
static const double COSINES[] = {0.5, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 0.5, 0.5, 0.9807852804032304, 0.9238795325112867, 0.8314696123025452, 0.7071067811865476, 0.5555702330196022, 0.3826834323650898, 0.19509032201612828, 0.0, 0.25, 0.46193976625564337, 0.3535533905932738, 0.1913417161825449, 0.0, -0.1913417161825449, -0.3535533905932738, -0.46193976625564337, -0.25, 0.16666666666666666, 0.2771565374341817, 0.12756114412169658, -0.06503010733870943, -0.23570226039551587, -0.3269284268010768, -0.30795984417042893, -0.18519007767320073, 0.0, 0.125, 0.1767766952966369, 0.0, -0.1767766952966369, -0.25, -0.1767766952966369, 0.0, 0.1767766952966369, 0.125, 0.1, 0.11111404660392044, -0.07653668647301795, -0.1961570560806461, -0.1414213562373095, 0.03901806440322565, 0.18477590650225734, 0.16629392246050906, 0.0, 0.08333333333333333, 0.06378057206084829, -0.11785113019775793, -0.15397992208521447, 0.0, 0.15397992208521447, 0.11785113019775793, -0.06378057206084829, -0.08333333333333333, 0.07142857142857142, 0.027870046002304038, -0.13198279035875524, -0.07936717614565746, 0.10101525445522108, 0.11878137318607788, -0.054669061766441394, -0.1401121829147472, 0.0, 0.0625, 0.0, -0.125, 0.0, 0.125, 0.0, -0.125, 0.0, 0.0625, 0.05555555555555555, -0.021676702446236474, -0.10265328139014297, 0.06173002589106691, 0.07856742013183862, -0.09238551247806058, -0.042520381373898866, 0.10897614226702561, 0.0, 0.05, -0.038268343236508975, -0.07071067811865475, 0.09238795325112867, 0.0, -0.09238795325112867, 0.07071067811865475, 0.038268343236508975, -0.05, 0.045454545454545456, -0.050506384819963834, -0.03478940294228089, 0.08916229821847549, -0.0642824346533225, -0.017735483819648026, 0.08398904841011698, -0.07558814657295866, 0.0, 0.041666666666666664, -0.05892556509887897, 0.0, 0.05892556509887897, -0.08333333333333333, 0.05892556509887897, 0.0, -0.05892556509887897, 0.041666666666666664, 0.038461538461538464, -0.06395920094634963, 0.029437187105006906, 0.015006947847394482, -0.05439282932204212, 0.07544502156947927, -0.07106765634702206, 0.04273617177073863, 0.0, 0.03571428571428571, -0.06599139517937762, 0.05050762722761054, -0.027334530883220697, 0.0, 0.027334530883220697, -0.05050762722761054, 0.06599139517937762, -0.03571428571428571, 0.03333333333333333, -0.06538568536021536, 0.061591968834085783, -0.05543130748683635, 0.047140452079103175, -0.037038015534640145, 0.02551222882433932, -0.013006021467741885, 0.0, 0.03125, -0.0625, 0.0625, -0.0625, 0.0625, -0.0625, 0.0625, -0.0625, 0.03125};
static const double ARCSINE[] = {1.0, 0.16666666666666666, 0.075, 0.044642857142857144, 0.030381944444444444, 0.022372159090909092, 0.017352764423076924, 0.01396484375, 0.011551800896139705, 0.009761609529194078, 0.008390335809616815, 0.0073125258735988454, 0.006447210311889649, 0.005740037670841924, 0.005153309682319905, 0.004660143486915096, 0.004240907093679363, 0.003880964558837669, 0.0035692053938259347, 0.003297059503473485, 0.0030578216492580306};
#define LAST_OF_ARCSINE 20
#define SHORTEST 6
static const double NODES[] = {0.033765242898423975, 0.16939530676686776, 0.38069040695840156, 0.6193095930415985, 0.8306046932331322, 0.966234757101576, 0.009219682876640378, 0.047941371814762546, 0.11504866290284765, 0.20634102285669126, 0.31608425050090994, 0.43738329574426554, 0.5626167042557344, 0.6839157494990901, 0.7936589771433087, 0.8849513370971523, 0.9520586281852375, 0.9907803171233596, 0.0024063900014893447, 0.012635722014345263, 0.0308627239986336, 0.056792236497799464, 0.08999900701304853, 0.12993790421072282, 0.17595317403151223, 0.22728926430558022, 0.28310324618697746, 0.3424786601519183, 0.40444056626319186, 0.4679715535686972, 0.5320284464313028, 0.5955594337368082, 0.6575213398480817, 0.7168967538130225, 0.7727107356944198, 0.8240468259684878, 0.8700620957892772, 0.9100009929869515, 0.9432077635022005, 0.9691372760013663, 0.9873642779856547, 0.9975936099985107, 0.0006144963737869658, 0.003234913866824618, 0.007937708138586574, 0.014704203726876364, 0.023506148419784545, 0.034306654646722834, 0.047060431642215184, 0.06171398986287607, 0.07820586918780326, 0.09646689798527869, 0.11642048374212982, 0.13798293453809268, 0.16106381018366805, 0.1855663016117432, 0.21138763695801366, 0.2384195126388835, 0.2665485476245208, 0.2956567590046416, 0.32562205685391965, 0.3563187563222722, 0.38761810480265546, 0.41938882196555416, 0.4514976503952687, 0.4838099145185653, 0.5161900854814346, 0.5485023496047313, 0.5806111780344458, 0.6123818951973445, 0.6436812436777277, 0.6743779431460803, 0.7043432409953584, 0.7334514523754792, 0.7615804873611165, 0.7886123630419863, 0.8144336983882567, 0.8389361898163319, 0.8620170654619073, 0.8835795162578701, 0.9035331020147213, 0.9217941308121967, 0.938286010137124, 0.9529395683577848, 0.9656933453532772, 0.9764938515802155, 0.9852957962731237, 0.9920622918614135, 0.9967650861331754, 0.999385503626213};
static const double SHARES[] = {0.17132449237917036, 0.3607615730481386, 0.46791393457269104, 0.46791393457269104, 0.3607615730481386, 0.17132449237917036, 0.04717533638651183, 0.10693932599531843, 0.16007832854334622, 0.20316742672306592, 0.2334925365383548, 0.24914704581340277, 0.24914704581340277, 0.2334925365383548, 0.20316742672306592, 0.16007832854334622, 0.10693932599531843, 0.04717533638651183, 0.0123412297999872, 0.028531388628933663, 0.04427743881741981, 0.05929858491543678, 0.0733464814110803, 0.08619016153195327, 0.09761865210411388, 0.10744427011596563, 0.1155056680537256, 0.12167047292780339, 0.1258374563468283, 0.12793819534675216, 0.12793819534675216, 0.1258374563468283, 0.12167047292780339, 0.1155056680537256, 0.10744427011596563, 0.09761865210411388, 0.08619016153195327, 0.0733464814110803, 0.05929858491543678, 0.04427743881741981, 0.028531388628933663, 0.0123412297999872, 0.0031533460523058385, 0.0073275539012762625, 0.01147723457923454, 0.015579315722943849, 0.01961616045735553, 0.02357076083932438, 0.027426509708356948, 0.03116722783279809, 0.03477722256477044, 0.03824135106583071, 0.04154508294346475, 0.04467456085669428, 0.04761665849249048, 0.05035903555385447, 0.05289018948519367, 0.055199503699984165, 0.057277292100403214, 0.059114839698395635, 0.06070443916589388, 0.062039423159892665, 0.06311419228625402, 0.06392423858464819, 0.06446616443595009, 0.06473769681268392, 0.06473769681268392, 0.06446616443595009, 0.06392423858464819, 0.06311419228625402, 0.062039423159892665, 0.06070443916589388, 0.059114839698395635, 0.057277292100403214, 0.055199503699984165, 0.05289018948519367, 0.05035903555385447, 0.04761665849249048, 0.04467456085669428, 0.04154508294346475, 0.03824135106583071, 0.03477722256477044, 0.03116722783279809, 0.027426509708356948, 0.02357076083932438, 0.01961616045735553, 0.015579315722943849, 0.01147723457923454, 0.0073275539012762625, 0.0031533460523058385};
static const double LAST_SHARES[] = {-0.3876791299527941, 1.1682732733664538, -1.7223019283558145, 1.7223019283558145, -1.1682732733664538, 0.3876791299527941, -0.11253711127058313, 0.3787454113112651, -0.6920832471686439, 0.9888453586985653, -1.2179538033266577, 1.3423224756654495, -1.3423224756654495, 1.2179538033266577, -0.9888453586985653, 0.6920832471686439, -0.3787454113112651, 0.11253711127058313, -0.030148844086217933, 0.10450373227140303, -0.20157312656922508, 0.31217774827820993, -0.42930015376012065, 0.546768530245034, -0.658980420783875, 0.7608887698130468, -0.848074469558393, 0.9168449387260235, -0.9643317908246022, 0.9885732942601926, -0.9885732942601926, 0.9643317908246022, -0.9168449387260235, 0.848074469558393, -0.7608887698130468, 0.658980420783875, -0.546768530245034, 0.42930015376012065, -0.31217774827820993, 0.20157312656922508, -0.10450373227140303, 0.03014884408621794, -0.007790034178160955, 0.027210382191082905, -0.053218548447853446, 0.08410186396997915, -0.1187845228885847, 0.15643105228230791, -0.1963239421927137, 0.2378131591508195, -0.28029248353192465, 0.32318795454504484, -0.36595248109290257, 0.40806385480730345, -0.4490247379947773, 0.488363825542185, -0.5256376989451522, 0.5604330646255685, -0.5923691692370727, 0.6211002458494637, -0.6463178840446435, 0.6677532432675436, -0.6851790473890056, 0.6984113123199125, -0.7073107694370226, 0.711783956628457, -0.711783956628457, 0.7073107694370226, -0.6984113123199125, 0.6851790473890056, -0.6677532432675436, 0.6463178840446435, -0.6211002458494637, 0.5923691692370727, -0.5604330646255685, 0.5256376989451522, -0.488363825542185, 0.4490247379947773, -0.40806385480730345, 0.36595248109290257, -0.32318795454504484, 0.28029248353192465, -0.2378131591508195, 0.19632394219271368, -0.15643105228230791, 0.1187845228885847, -0.08410186396997914, 0.05321854844785345, -0.027210382191082915, 0.007790034178160959};
static const double NEXT_SHARES[] = {0.6506981459528086, -1.3904518577536216, 0.739753711800813, 0.739753711800813, -1.3904518577536216, 0.6506981459528086, 0.2108819967832719, -0.6537305004446008, 1.0172337816331414, -1.108736299700892, 0.8552761124501606, -0.3209250907210808, -0.3209250907210808, 0.8552761124501606, -1.108736299700892, 1.0172337816331414, -0.6537305004446008, 0.2108819967832719, 0.05870297804143083, -0.1992967279249246, 0.37003878592342787, -0.5414071368112371, 0.6887484365130017, -0.7917585973595219, 0.8355933145971909, -0.8119664459895835, 0.7197832151957603, -0.565132082012826, 0.3605908690393087, -0.12389660921202703, -0.12389660921202703, 0.3605908690393087, -0.565132082012826, 0.7197832151957603, -0.8119664459895835, 0.8355933145971909, -0.7917585973595219, 0.6887484365130017, -0.5414071368112371, 0.37003878592342787, -0.1992967279249246, 0.058702978041430834, 0.015395378857163742, -0.05349347277944267, 0.10363303001903507, -0.16152034625672088, 0.22399186460403825, -0.28829564702411775, 0.3519075741302629, -0.4124853958917247, 0.4678720159660525, -0.5161184901411058, 0.5555142313787836, -0.5846181008158503, 0.6022867338773646, -0.6076977904534808, 0.6003665987606669, -0.5801551888747979, 0.5472731144586855, -0.5022697983595777, 0.44601843579385353, -0.3796917587665565, 0.30473021064864453, -0.2228033001446087, 0.13576509711972842, -0.04560499610629582, -0.04560499610629582, 0.13576509711972842, -0.2228033001446087, 0.30473021064864453, -0.3796917587665565, 0.44601843579385353, -0.5022697983595777, 0.5472731144586855, -0.5801551888747979, 0.6003665987606669, -0.6076977904534808, 0.6022867338773646, -0.5846181008158503, 0.5555142313787836, -0.5161184901411058, 0.4678720159660525, -0.4124853958917247, 0.3519075741302629, -0.28829564702411775, 0.22399186460403825, -0.16152034625672088, 0.10363303001903508, -0.05349347277944268, 0.015395378857163744};
#define RATIO 0x1.0000000000000p-2
#define RATIO_TO_ROUNDING 0x1.70a3d70a3d70ap-3
#define LAST_STEP 0x1.0000000000000p-30
#define MOST_ITERATIONS 200
#define ROUNDING 0x1.0000000000000p-56
#define LARGEST 0x1.f400000000000p+49
#define TIE 0x1.0000000000000p-44
#define CLOSEST 0x1.56e1fc2f8f359p-997
#define SURE 0x1.ffffe00000000p-1
#define SIXTH 0x1.5555555555555p-3
#define ROUNDINGS 0x1.0000000000000p+27
#define FAR 0x1.7e43c8800759cp+996
#define TOP 7
#define SHORT 0x1.0000000000000p-7
#define PRESSED 0x1.47ae147ae147bp-7
#define SURELY 0x1.0000000000000p+2
#define BEYOND 0x1.2000000000000p+0
#define LONGEST 0x1.0000000000000p+0
#define REACH 0x1.0000000000000p+2
#define STRAIGHT 0x1.0000000000000p+4
#define NEWTON 3
#define NEAREST 0x1.ccccccccccccdp-1
#define EVEN 0x1.0000000000000p-20
#define FINEST 17
#define CLOSER 0x1.0000000000000p-25
#define MOST_HALVINGS 30
#define BRIEFEST 0x1.ad7f29abcaf48p-24
#define LAST 7
static const double VERSINE[] = {0.5, -0.041666666666666664, 0.001388888888888889, -2.48015873015873e-05, 2.755731922398589e-07, -2.08767569878681e-09, 1.1470745597729725e-11, -4.779477332387385e-14};
static const double LAG[] = {0.16666666666666666, -0.008333333333333333, 0.0001984126984126984, -2.7557319223985893e-06, 2.505210838544172e-08, -1.6059043836821613e-10, 7.647163731819816e-13, -2.8114572543455206e-15};
static const double FADING[] = {0.5, -0.16666666666666666, 0.041666666666666664, -0.008333333333333333, 0.001388888888888889, -0.0001984126984126984, 2.48015873015873e-05, -2.7557319223985893e-06, 2.755731922398589e-07, -2.505210838544172e-08, 2.08767569878681e-09, -1.6059043836821613e-10, 1.1470745597729725e-11, -7.647163731819816e-13, 4.779477332387385e-14};
#define HALF 12
#define LEAST 0x1.bff2ee48e0530p-333
#define SHIFT 5
#define FIRST 6
#define POLE 7
#define POWER 8
#define LOAD 33
#define NET 36
#define TERMS 8
#define GREATEST 0x1.0000000000000p-4
#define DRIVEN 0x1.0000000000000p+10
#define ALIKE 0x1.0000000000000p-18
#define BETWEEN 0x1.eb851eb851eb8p-3
#define BENT 0x1.4cccccccccccdp-2
#define CLOSER_TO_POLE 0x1.8000000000000p+1
#define LEAST_EXPONENT -0x1.0000000000000p-1
#define COMPLETE 0x1.8000000000000p+2
#define CONSTANT 8
#define SINE 16
#define VERS 24
#define PI 0x1.921fb54442d18p+1
#define QUARTER 0x1.921fb54442d18p-1
#define PAIRS 8
#define LONG 17
#define LAST_WAVE 0x1.0000000000000p-44
#define MOST_CORRECTIONS 12
#define LAST_OF_NEWTON 0x1.0000000000000p-26
#define OMEGA_THERE 1
#define RATE_THERE 2
#define ANGLE_THERE 3
#define SLOPE_THERE 4
#define FARTHEST 0x1.91eb851eb851fp+1
#define FADED 0x1.0000000000000p+1
#define LAST_OF_HALLEY 0x1.0000000000000p-18
#define CLEAR 0x1.47ae147ae147bp-7
#define CLOSE_TO_REST 0x1.0000000000000p-40
#define LEAST_DURATION 0x1.8000000000000p+0
#define NEAR_MIDDLE 0x1.b333333333333p-1
#define TOUCHES 0x1.0000000000000p+1
#define TOGETHER 0x1.12e0be826d695p-30

/* Return the value at time t of the polynomial with coefficients p[0] to p[n], by Horner's scheme. */
INLINE V value(V *p, int n, V t)
{
    V total = p[n];
    for (int k = n - 1; k >= 0; k--) {
        total = (total * t) + p[k];
    }
    return total;
}

/* Return the value minus the constant term, without cancellation. */
INLINE V increment(V *p, int n, V t)
{
    return (n > 0) ? t * value(p + 1, n - 1, t) : broadcast(0.0);
}

/* Return the value and the derivative at a time. */
INLINE Pair value_and_slope(V *p, int n, V t)
{
    V total = p[n];
    V slope = broadcast(0.0);
    for (int k = n - 1; k >= 0; k--) {
        slope = (slope * t) + total;
        total = (total * t) + p[k];
    }
    return (Pair){total, slope};
}

/* Compute the coefficients of the derivative. */
INLINE void differentiate(V *rates, V *p, int n)
{
    for (int k = 1; k <= n; k++) {
        rates[k - 1] = p[k] * (double)k;
    }
}

/* Shift a polynomial to another origin: Taylor's shift by Horner's scheme. */
INLINE void shift(V *p, int n, V by)
{
    for (int first = 0; first <= n - 1; first++) {
        for (int j = n - 1; j >= first; j--) {
            p[j] = p[j] + (by * p[j + 1]);
        }
    }
}

/* Return a place if it lies between two bounds, otherwise their middle. */
INLINE V inside_or_middle(V at, V low, V high)
{
    return pick((at >= low) & (at <= high), at, 0.5 * (low + high));
}

/* Return a root between bounds at which values have opposite signs. Newton's method starts where the chord crosses
 * zero, and bisects if a step leaves the bounds. */
static V bracketed_root(V *p, int n, V low, V at_low, V high, V at_high, M which)
{
    M falls = at_low > 0.0;
    V share = at_low / (at_low - at_high);
    V chord = low + ((high - low) * share);
    V at = inside_or_middle(chord, low, high);
    int count = 0;
    while (bits(which) && (count < MOST_ITERATIONS)) {
        const Pair residual_slope = value_and_slope(p, n, at);
        V residual = residual_slope.one, slope = residual_slope.other;
        M beyond = (residual > 0.0) != falls;
        low = pick(beyond, low, at);
        high = pick(beyond, at, high);
        V following = inside_or_middle(at - (residual / slope), low, high);
        following = pick(residual == 0.0, at, following);
        V change = magnitude(following - at);
        at = pick(which, following, at);
        which = which & (change > (LAST_STEP * magnitude(following)));
        count = count + 1;
    }
    return at;
}

/* Return the first zero in (0, h] of initially positive polynomials, infinity without a zero. Within a step the
 * terms decrease like 0.2^k. A polynomial that has the same sign at h, and does not fall at first and rise at the
 * end, therefore has no root. If it falls and rises, its least value decides. A polynomial that only touches zero
 * does not cross it, and the zero polynomial has no root. */
static V first_root(V *p, int n, V h, M which)
{
    V high = h;
    const Pair last_slope = value_and_slope(p, n, h);
    V last = last_slope.one, slope = last_slope.other;
    M crosses = which & ((last < 0.0) | ((last == 0.0) & (p[0] > 0.0)));
    M dips = which & ~crosses & (p[1] < 0.0) & (slope > 0.0);
    if (bits(dips)) {
        V rates[STRIDE];
        differentiate(rates, p, n);
        V lowest = bracketed_root(rates, n - 1, broadcast(0.0), rates[0], h, slope, dips);
        V least = value(p, n, lowest);
        V terms = magnitude(p[n]);
        for (int k = n - 1; k >= 0; k--) {
            terms = (terms * h) + magnitude(p[k]);
        }
        M below = dips & (least < (((-4.0) * EPS) * terms));
        high = pick(below, lowest, high);
        last = pick(below, least, last);
        crosses = crosses | below;
    }
    V root = broadcast(INFINITY);
    if (bits(crosses)) {
        root = pick(crosses, bracketed_root(p, n, broadcast(0.0), p[0], high, last, crosses), root);
    }
    return root;
}

/* Compute the coefficients of sign p + constant, divided by the time if its root at 0 is to be removed. */
INLINE void margin_of(V *e, V *p, int n, V sign, V constant, M divided)
{
    for (int k = 0; k <= n; k++) {
        e[k] = sign * p[k];
    }
    e[0] = e[0] + constant;
    if (bits(divided)) {
        for (int k = 0; k <= n - 1; k++) {
            e[k] = pick(divided, e[k + 1], e[k]);
        }
        e[n] = pick(divided, broadcast(0.0), e[n]);
    }
}

/* Return the first time in (0, t] at which sign p + constant falls through zero, infinity without a zero. A root
 * at 0 is removed where it is to be ``divided`` out. */
static V crossing(V *p, int n, V t, V sign, V constant, M divided, M here)
{
    const Pair last_slope = value_and_slope(p, n, t);
    V last = last_slope.one, slope = last_slope.other;
    M falls_and_rises = ((sign * p[1]) < 0.0) & ((sign * slope) > 0.0);
    M asked = here & ((((sign * last) + constant) <= 0.0) | falls_and_rises | divided);
    V at = broadcast(INFINITY);
    if (bits(asked)) {
        V e[STRIDE];
        margin_of(e, p, n, sign, constant, divided);
        at = first_root(e, n, t, asked);
    }
    return at;
}

/* Return the zero in (0, t] at which polynomials become negative, possibly beyond a maximum, otherwise infinity.
 * ``last`` and ``slope`` are the value and the derivative at t. */
static V falling_root(V *p, int n, V t, V last, V slope, M here)
{
    M touches = p[0] == 0.0;
    M positive = (p[0] > 0.0) | (touches & (p[1] > 0.0));
    M dips = (p[1] < 0.0) & (slope > 0.0);
    M falls = here & positive & ((last < 0.0) | dips);
    V e[STRIDE];
    V root = broadcast(INFINITY);
    if (bits(falls)) {
        margin_of(e, p, n, broadcast(1.0), broadcast(0.0), touches);
        root = first_root(e, n, t, falls);
    }
    M rises = (p[0] < 0.0) & (p[1] > 0.0);
    M hump = here & rises & (last < 0.0) & (slope < 0.0);
    if (bits(hump)) {
        differentiate(e, p, n);
        V top = bracketed_root(e, n - 1, broadcast(0.0), e[0], t, slope, hump);
        V most = value(p, n, top);
        hump = hump & (most > 0.0);
        if (bits(hump)) {
            root = pick(hump, bracketed_root(p, n, top, most, t, last, hump), root);
        }
    }
    return root;
}

/* Return the end of a piece in the table's argument, infinity for the last piece. */
INLINE V end_of_piece(Batch *b, int t, V piece)
{
    const Job *const job = b->job;
    V last = broadcast((double)((int)job->data[t].pieces - 1));
    V following = breaks_at(b, t, minimum(piece + 1.0, last));
    return pick(piece < last, following, broadcast(INFINITY));
}

/* Return the piece that contains an argument, searched from a first piece on. A break belongs to the piece above
 * where it is ``included``, otherwise to the piece below. */
static V piece_at(Batch *b, M here, int t, V first, V argument, M included)
{
    V piece = 1.0 * first;
    M goes_on = here;
    while (bits(goes_on)) {
        V end = end_of_piece(b, t, piece);
        M ends_there = included & (end == argument);
        goes_on = goes_on & (end < INFINITY) & ((end < argument) | ends_there);
        piece = pick(goes_on, piece + 1.0, piece);
    }
    return piece;
}

/* Return a function of time, a sine or a straight line, at a distance from the left end of a piece. */
INLINE V value_within(Batch *b, int t, V piece, V local)
{
    const Job *const job = b->job;
    V *const c = b->c;
    V height = coefficients_at(b, t, piece, 0);
    V change = coefficients_at(b, t, piece, 1) * local;
    V value = height + change;
    if (job->data[t].sine) {
        value = height * sin_of(change + coefficients_at(b, t, piece, 2));
    }
    return c[job->table[t].cell + SCALED_BY] * value;
}

/* Return the distance of the current time from the left end of its piece, in the table's argument. */
INLINE V since_break(Batch *b, int t)
{
    const Job *const job = b->job;
    V *const c = b->c;
    return (c[TIME] * c[job->table[t].cell + SCALE]) - breaks_at(b, t, c[job->table[t].cell + PIECE]);
}

/* Return a function of time at the current time. */
INLINE V value_now(Batch *b, int t)
{
    const Job *const job = b->job;
    V *const c = b->c;
    V local = since_break(b, t);
    return value_within(b, t, c[job->table[t].cell + PIECE], local);
}

/* Compute the series of a sine about the current time, as its increment since the phase began. */
INLINE void expand_sine(Batch *b, int t)
{
    const Job *const job = b->job;
    V *const c = b->c;
    V size = coefficients_at(b, t, c[job->table[t].cell + PIECE], 0) * c[job->table[t].cell + SCALED_BY];
    V rate = coefficients_at(b, t, c[job->table[t].cell + PIECE], 1);
    V angle = (rate * since_break(b, t)) + coefficients_at(b, t, c[job->table[t].cell + PIECE], 2);
    V now = sin_of(angle);
    V slope = cos_of(angle);
    for (int j = 1; j <= job->order; j++) {
        size = size * ((rate * c[job->table[t].cell + SCALE]) * b->inverse[j]);
        (b->r + job->table[t].reg)[j] = size * slope;
        V before = now;
        now = slope;
        slope = -before;
    }
}

/* Return the rise of a function of time over a step: of a sine by all terms, whatever the other lanes' orders. */
INLINE V rise_of_step(Batch *b, int t)
{
    const Job *const job = b->job;
    V *const c = b->c;
    int last = job->data[t].sine ? job->order : 1;
    return increment(b->r + job->table[t].reg, last, c[STEP]);
}

/* Return the rise of a sine over a distance ahead of a place in its piece: 2 A sin(r/2) cos(angle + r/2). */
INLINE V rise_of_sine(Batch *b, int t, V local, V past)
{
    const Job *const job = b->job;
    V *const c = b->c;
    V rate = coefficients_at(b, t, c[job->table[t].cell + PIECE], 1);
    V half = (0.5 * rate) * past;
    V angle = (rate * local) + coefficients_at(b, t, c[job->table[t].cell + PIECE], 2);
    V change = (2.0 * sin_of(half)) * cos_of(angle + half);
    return (c[job->table[t].cell + SCALED_BY] * coefficients_at(b, t, c[job->table[t].cell + PIECE], 0)) * change;
}

/* Compute the end of the piece of a function of time and the increment there, from a distance from its left end. */
static void find_end_of_piece(Batch *b, M here, int t, V local)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    V end = end_of_piece(b, t, c[job->table[t].cell + PIECE]);
    V now = breaks_at(b, t, c[job->table[t].cell + PIECE]) + local;
    V past = pick(end < INFINITY, end - now, broadcast(0.0));
    V slope = coefficients_at(b, t, c[job->table[t].cell + PIECE], 1) * c[job->table[t].cell + SCALED_BY];
    V rise = slope * past;
    if (job->data[t].sine) {
        rise = rise_of_sine(b, t, local, past);
    }
    c[job->table[t].cell + RISE] = pick(here, slope * c[job->table[t].cell + SCALE], c[job->table[t].cell + RISE]);
    c[job->table[t].cell + UPPER] = pick(here, end / c[job->table[t].cell + SCALE], c[job->table[t].cell + UPPER]);
    c[job->table[t].cell + LOWER] = pick(here, c[job->table[t].cell + INC] + rise, c[job->table[t].cell + LOWER]);
    c[job->table[t].cell + WAY] = pick(here, c[job->table[t].cell + WAY] + magnitude(rise), c[job->table[t].cell + WAY]);
}

/* Enter the piece that contains the current time, without a value that is carried. */
static void enter_piece(Batch *b, M here, int t)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    V now = c[TIME] * c[job->table[t].cell + SCALE];
    V piece = piece_at(b, here, t, c[job->table[t].cell + PIECE], now * (1.0 + (2.0 * EPS)), here);
    c[SCALE_BEFORE] = pick(here, pick(piece > c[job->table[t].cell + PIECE], broadcast(INFINITY), c[SCALE_BEFORE]), c[SCALE_BEFORE]);
    c[job->table[t].cell + PIECE] = pick(here, piece, c[job->table[t].cell + PIECE]);
    c[job->table[t].cell + WAY] = pick(here, broadcast(0.0), c[job->table[t].cell + WAY]);
    c[job->table[t].cell + VALUE] = pick(here, value_now(b, t), c[job->table[t].cell + VALUE]);
    find_end_of_piece(b, here, t, since_break(b, t));
}

/* Begin a phase: increments of a function of time are counted from now. It may jump at the left end of a piece.
 * Within a piece the value and the rise to its end follow from the increment, since on a short ramp the rounding
 * of the time times the slope is large. */
static void begin_in_time(Batch *b, M here, int t)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    c[job->table[t].cell + VALUE] = pick(here, c[job->table[t].cell + VALUE] + c[job->table[t].cell + INC], c[job->table[t].cell + VALUE]);
    c[job->table[t].cell + LOWER] = pick(here, c[job->table[t].cell + LOWER] - c[job->table[t].cell + INC], c[job->table[t].cell + LOWER]);
    c[job->table[t].cell + INC] = pick(here, broadcast(0.0), c[job->table[t].cell + INC]);
    c[job->table[t].cell + WAY] = pick(here, magnitude(c[job->table[t].cell + LOWER]), c[job->table[t].cell + WAY]);
    enter_piece(b, here & (c[job->table[t].cell + UPPER] <= c[TIME]), t);
}

/* Enter the next piece of a function of time. If its value jumps, the contact must be checked. Increments
 * accumulate rounding along a record. Beyond some path the difference of two values is more accurate. */
static void pass_break(Batch *b, M here, int t)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    V last = broadcast((double)((int)job->data[t].pieces - 1));
    V piece = minimum(c[job->table[t].cell + PIECE] + 1.0, last);
    V jump = jumps_at(b, t, piece) * c[job->table[t].cell + SCALED_BY];
    V there = value_within(b, t, piece, broadcast(0.0));
    V way = c[job->table[t].cell + WAY] + magnitude(jump);
    V rounding = magnitude(there) + magnitude(c[job->table[t].cell + VALUE]);
    M is_long = way > rounding;
    V carried = c[job->table[t].cell + LOWER] + jump;
    c[PENDING] = pick(here, pick(jump != 0.0, broadcast(DISCONTINUITY), c[PENDING]), c[PENDING]);
    c[job->table[t].cell + PIECE] = pick(here, piece, c[job->table[t].cell + PIECE]);
    c[job->table[t].cell + INC] = pick(here, pick(is_long, there - c[job->table[t].cell + VALUE], carried), c[job->table[t].cell + INC]);
    c[job->table[t].cell + WAY] = pick(here, pick(is_long, rounding, way), c[job->table[t].cell + WAY]);
    find_end_of_piece(b, here, t, broadcast(0.0));
}

/* Enter the next piece of each function of time that has a break now. */
INLINE void pass_breaks(Batch *b, M here)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    for (int t = 0; t < job->tables; t++) {
        if (job->table[t].kind == OF_TIME) {
            pass_break(b, here & (c[job->table[t].cell + UPPER] <= c[TIME]), t);
        }
    }
}

/* Return whether a force will still change while lanes rest. */
INLINE M still_changes(Batch *b)
{
    const Job *const job = b->job;
    V *const c = b->c;
    M changes = (M){0};
    for (int t = 0; t < job->tables; t++) {
        if (job->table[t].kind == OF_TIME) {
            changes = changes | (c[job->table[t].cell + UPPER] < INFINITY);
        }
    }
    return changes;
}

/* Return the next time at which a function of time has a break. */
INLINE V next_break(Batch *b)
{
    const Job *const job = b->job;
    V *const c = b->c;
    V time = broadcast(INFINITY);
    for (int t = 0; t < job->tables; t++) {
        if (job->table[t].kind == OF_TIME) {
            time = minimum(c[job->table[t].cell + UPPER], time);
        }
    }
    return time;
}

/* Compute the value at the start of a phase and the coefficients about it. */
static void develop(Batch *b, M here, int t, V local, V unit)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    V terms[STRIDE];
    for (int j = 0; j <= job->data[t].terms - 1; j++) {
        terms[j] = coefficients_at(b, t, c[job->table[t].cell + PIECE], j);
    }
    shift(terms, job->data[t].terms - 1, local);
    V factor = 1.0 * c[job->table[t].cell + SCALED_BY];
    c[job->table[t].cell + VALUE] = pick(here, factor * terms[0], c[job->table[t].cell + VALUE]);
    for (int j = 1; j <= job->table[t].degree; j++) {
        factor = factor * unit;
        V coefficient = (j < job->data[t].terms) ? factor * terms[j] : broadcast(0.0);
        c[job->table[t].cell + Q1 + j - 1] = pick(here, coefficient, c[job->table[t].cell + Q1 + j - 1]);
    }
}

/* Select the piece of a function of the rotation ahead in the direction of travel, which may be either. */
static void begin_in_rotation(Batch *b, M here, int t)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    M forward = c[DIRECTION] > 0.0;
    c[job->table[t].cell + PIECE] = pick(here, piece_at(b, here, t, broadcast(0.0), c[ROTATION], forward), c[job->table[t].cell + PIECE]);
    V local = c[ROTATION] - breaks_at(b, t, c[job->table[t].cell + PIECE]);
    V ahead = end_of_piece(b, t, c[job->table[t].cell + PIECE]) - c[ROTATION];
    V behind = pick(c[job->table[t].cell + PIECE] > 0.0, local, broadcast(INFINITY));
    c[job->table[t].cell + UPPER] = pick(here, pick(forward, ahead, behind), c[job->table[t].cell + UPPER]);
    develop(b, here, t, local, c[DIRECTION]);
}

/* Select the piece of a function of slip, which ends ahead even if another function has just passed a break. */
INLINE void begin_in_slip(Batch *b, M here, int t)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    V edge = breaks_at(b, t, c[job->table[t].cell + PIECE]);
    V local = maximum((c[SLIP] * c[job->table[t].cell + SCALE]) - edge, broadcast(0.0));
    V ahead = (end_of_piece(b, t, c[job->table[t].cell + PIECE]) - edge) - local;
    c[job->table[t].cell + UPPER] = pick(here, maximum(ahead / c[job->table[t].cell + SCALE], EPS * c[SLIP]), c[job->table[t].cell + UPPER]);
    develop(b, here, t, local, c[job->table[t].cell + SCALE]);
}

/* Select the piece of a polynomial of the logarithm of the speed. Piece 0, below the first speed, is constant. */
INLINE void begin_in_speed(Batch *b, M here, int t)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    V edge = breaks_at(b, t, c[job->table[t].cell + PIECE]);
    V speed = c[OMEGA] * c[job->table[t].cell + SCALE];
    M varies = c[job->table[t].cell + PIECE] > 0.0;
    M moves = varies & (speed > 0.0);
    V ratio = pick(moves, speed / pick(moves, edge, broadcast(1.0)), broadcast(1.0));
    c[job->table[t].cell + UPPER] = pick(here, end_of_piece(b, t, c[job->table[t].cell + PIECE]) / c[job->table[t].cell + SCALE], c[job->table[t].cell + UPPER]);
    c[job->table[t].cell + LOWER] = pick(here, pick(varies, edge / c[job->table[t].cell + SCALE], broadcast(0.0)), c[job->table[t].cell + LOWER]);
    develop(b, here, t, log_of(ratio), broadcast(1.0));
}

/* Begin a phase: compute the ends of each table's piece, its value, and its coefficients. */
static void begin_pieces(Batch *b, M here)
{
    const Job *const job = b->job;
    if (!bits(here)) return;
    for (int t = 0; t < job->tables; t++) {
        if (job->table[t].kind == OF_TIME) {
            begin_in_time(b, here, t);
        }
        if (job->table[t].kind == OF_ROTATION) {
            begin_in_rotation(b, here, t);
        }
        if (job->table[t].kind == OF_SLIP) {
            begin_in_slip(b, here, t);
        }
        if (job->table[t].kind == OF_SPEED) {
            begin_in_speed(b, here, t);
        }
    }
}

/* Find the pieces that contain slip and speed. */
static void find_pieces(Batch *b, M here)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    for (int t = 0; t < job->tables; t++) {
        if (job->table[t].kind == OF_SLIP) {
            c[job->table[t].cell + PIECE] = pick(here, piece_at(b, here, t, broadcast(0.0), c[SLIP] * c[job->table[t].cell + SCALE], here), c[job->table[t].cell + PIECE]);
        }
        if (job->table[t].kind == OF_SPEED) {
            c[job->table[t].cell + PIECE] = pick(here, piece_at(b, here, t, broadcast(0.0), c[OMEGA] * c[job->table[t].cell + SCALE], here), c[job->table[t].cell + PIECE]);
        }
    }
}

/* Set order 0 of the registers that do not result from operations. */
INLINE void begin_series(Batch *b)
{
    const Job *const job = b->job;
    V *const c = b->c;
    for (const State *q = job->state; q < job->state + job->states; q++) {
        (b->r + q->series)[0] = c[q->cell];
    }
    for (int t = 0; t < job->tables; t++) {
        if (job->table[t].kind == OF_TIME) {
            (b->r + job->table[t].reg)[0] = c[job->table[t].cell + INC];
        }
    }
}

/* Return a rate by time from a rate by tau, the variable of a step, where dt = (1 + pace omega) dtau. */
INLINE V per_time(Batch *b, V rate, V omega)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (job->role->pace >= 0) {
        return rate / (1.0 + (c[job->role->pace] * omega));
    }
    return rate;
}

/* Compute the time since the beginning of a step as a series in tau. */
INLINE void find_clock(Batch *b, V *t, int top)
{
    const Job *const job = b->job;
    V *const c = b->c;
    t[0] = broadcast(0.0);
    for (int k = 0; k <= top - 1; k++) {
        t[k + 1] = (c[job->role->pace] * (b->r + job->role->omega)[k]) * b->inverse[k + 1];
    }
    t[1] = 1.0 + t[1];
}

/* Return the time since the beginning of a step from its variable. */
INLINE V elapsed(Batch *b, int top, V at)
{
    const Job *const job = b->job;
    if (job->role->pace >= 0) {
        V t[STRIDE];
        find_clock(b, t, top);
        return value(t, top, at);
    }
    return at;
}

/* Return the variable of a step from the time since its beginning, infinite if the step does not last so long. In
 * tau the time rises up to a standstill, beyond which it falls. */
static V variable_at(Batch *b, int top, V time)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (job->role->pace >= 0) {
        V left[STRIDE];
        find_clock(b, left, top);
        M limited = time < INFINITY;
        margin_of(left, left, top, broadcast(-1.0), pick(limited, time, broadcast(0.0)), (M){0});
        return first_root(left, top, c[STEP], limited);
    }
    return pick(time <= c[STEP], time, broadcast(INFINITY));
}

/* Compute order 0 of all registers. Rates of states are per time. */
INLINE void evaluate(Batch *b)
{
    const Job *const job = b->job;
    V *const c = b->c;
    begin_series(b);
    operate(b, 0, 1, 0, 0);
    operate_later(b, 1);
    for (const State *q = job->state; q < job->state + job->states; q++) {
        (b->r + q->rate)[0] = per_time(b, (b->r + q->rate)[0], c[OMEGA]);
    }
}

/* Return the normal force on the slip surface from order 0. Contact is lost if it is negative. */
INLINE V normal_force(Batch *b)
{
    const Job *const job = b->job;
    V *const c = b->c;
    V force = c[job->role->normal0];
    if (job->role->normal >= 0) {
        force = (b->r + job->role->normal)[0];
    }
    return force;
}

/* Compute the size of the last terms over the largest term of a step that a break cuts short, factor^order. The
 * truncation error is such a term times the step over the radius of convergence, per time the same as in complete
 * steps. */
INLINE void find_negligible(Batch *b, M here)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    V negligible = broadcast(1.0);
    for (int n = 1; n <= job->order; n++) {
        negligible = pick(c[ORDER] >= (double)n, negligible * c[FACTOR], negligible);
    }
    c[NEGLIGIBLE] = pick(here, maximum(negligible, broadcast(ROUNDING)), c[NEGLIGIBLE]);
}

/* Set the coefficients of a series from each lane's order on to zero. */
INLINE void truncate(V *p, V order, int top)
{
    for (int n = least(order); n <= top - 1; n++) {
        p[n] = pick(order > (double)n, p[n], broadcast(0.0));
    }
}

/* Truncate the series of the states, and those that events use, at each lane's order. */
INLINE void cut(Batch *b, V order, int top)
{
    const Job *const job = b->job;
    for (const State *q = job->state; q < job->state + job->states; q++) {
        truncate(b->r + q->series + 1, order, top);
    }
    truncate(b->r + job->role->net, order, top);
    if (job->role->normal >= 0) {
        truncate(b->r + job->role->normal, order, top);
    }
    if (job->role->upright >= 0) {
        truncate(b->r + job->role->upright, order, top);
    }
}

/* Set order 0 of the registers that do not result from operations, and the series of functions of time. */
static void begin_expansion(Batch *b, M which, int top, int at_rest)
{
    const Job *const job = b->job;
    V *const c = b->c;
    begin_series(b);
    if (at_rest) {
        for (const State *q = job->state; q < job->state + job->states; q++) {
            for (int n = 1; n <= top; n++) {
                (b->r + q->series)[n] = broadcast(0.0);
            }
        }
    }
    for (int t = 0; t < job->tables; t++) {
        if (job->table[t].kind == OF_TIME) {
            (b->r + job->table[t].reg)[1] = c[job->table[t].cell + RISE];
        }
        if (job->data[t].sine) {
            expand_sine(b, t);
        }
    }
    c[LARGEST_OMEGA] = at_rest ? broadcast(0.0) : magnitude((b->r + job->role->omega)[0]);
}

/* Return whether coefficient n times a power of the step is significant beside the largest term so far. It is a
 * term of the speed, at rest of the net moment. The path needs no test of its own: its term n + 1 is term n of the
 * speed, times the step over n + 1. */
INLINE M next_term_counts(Batch *b, int n, V power, int at_rest)
{
    const Job *const job = b->job;
    V *const c = b->c;
    V *omega = at_rest ? (b->r + job->role->net) : (b->r + job->role->omega);
    V term = magnitude(omega[n]) * power;
    V largest = 1.0 * c[LARGEST_OMEGA];
    M negligible = (term <= (c[NEGLIGIBLE] * largest)) & (largest > 0.0) & (largest < INFINITY);
    c[LARGEST_OMEGA] = maximum(term, largest);
    return ~negligible;
}

/* Compute the series of all registers, of states to one order more than of rates; return the highest order. If a
 * function of time cuts the step short after ``room``, a series ends as soon as two consecutive terms are
 * negligible there, three if the speed grows beyond its first term. At rest the states are constant, and the net
 * moment decides. Each lane's order is `series_order`; states, net moment, normal force and dip are zero beyond
 * it. */
static int expand(Batch *b, V room, M which, int at_rest)
{
    const Job *const job = b->job;
    V *const c = b->c;
    V order = pick(which, c[ORDER], broadcast(1.0));
    int top = greatest(order);
    int alike = all_lanes(order == (double)top);
    begin_expansion(b, which, top, at_rest);
    V first = c[LARGEST_OMEGA];
    V power = at_rest ? broadcast(1.0) : room;
    V in_a_row = broadcast(0.0);
    int n = 0;
    if (!job->timed) {
        operate(b, 0, top, 0, 1);
        n = top;
    }
    int computed = 0;
    while (n < top) {
        if (n == computed) {
            computed = (n + 2) < top ? (n + 2) : top;
            operate(b, n, computed, 0, !at_rest);
        }
        M counts = next_term_counts(b, at_rest ? n : (n + 1), power, at_rest);
        power = power * room;
        in_a_row = pick(counts, broadcast(0.0), in_a_row + 1.0);
        V enough = pick(c[LARGEST_OMEGA] > first, broadcast(3.0), broadcast(2.0));
        M ends = (in_a_row >= (at_rest ? broadcast(2.0) : enough)) & (order > (double)n) & which;
        if ((n >= 2) && bits(ends)) {
            order = pick(ends, minimum(order, broadcast((double)(n + 1))), order);
            alike = 0;
            if (!bits(order > (double)(n + 1))) {
                top = n + 1;
            }
        }
        n = n + 1;
    }
    operate_later(b, top);
    if (!alike) {
        cut(b, order, top);
    }
    c[SERIES_ORDER] = order;
    c[STEP] = room;
    return top;
}

/* Return the longest step at the end of which each of the last four terms is small beside one of the first five.
 * Term n is at most factor^n of the largest of the first five, so that the step is the factor times the radius of
 * convergence if the series is geometric. Entire functions, whose terms decrease ever faster, allow longer steps.
 * The step is 2^1000 if these coefficients are zero. */
static V longest_step(Batch *b, V *p, int top, V order)
{
    V *const c = b->c;
    V first[STRIDE];
    M comparable = p[0] != 0.0;
    for (int k = 0; k <= 4; k++) {
        first[k] = log2_of(p[k]);
        comparable = comparable | (p[k] != 0.0);
    }
    V one = broadcast(1.0);
    V share = log2_of(c[FACTOR]) - log2_of(one);
    V lowest = broadcast(LARGEST);
    for (int n = (least(order) - 3) > 5 ? (least(order) - 3) : 5; n <= top; n++) {
        V last = log2_of(p[n]) - ((double)n * share);
        V most = broadcast(-LARGEST);
        for (int k = 0; k <= 4; k++) {
            most = maximum((first[k] - last) * b->inverse[n - k], most);
        }
        M among_last = (order >= (double)n) & (order <= (double)(n + 3));
        M counts = comparable & among_last & (p[n] != 0.0);
        lowest = pick(counts & (most < lowest), most, lowest);
    }
    return power_of_two(lowest);
}

/* Record a candidate for the greatest speed in the current step if it exceeds the record. If the record is not at
 * the beginning of the step, the difference must exceed rounding. */
INLINE void keep_faster(Batch *b, M here, V speed, V time, V x, V rate)
{
    V *const c = b->c;
    if (!bits(here)) return;
    M faster = here & (speed > magnitude(c[PEAK_OMEGA]));
    if (bits(faster)) {
        M begins = c[PEAK_TIME] == c[TIME];
        M clearly = speed > ((1.0 + TIE) * magnitude(c[PEAK_OMEGA]));
        faster = faster & (begins | clearly);
        c[PEAK_OMEGA] = pick(here, pick(faster, c[DIRECTION] * speed, c[PEAK_OMEGA]), c[PEAK_OMEGA]);
        c[PEAK_TIME] = pick(here, pick(faster, time, c[PEAK_TIME]), c[PEAK_TIME]);
        c[PEAK_ROTATION] = pick(here, pick(faster, c[ROTATION] + (c[DIRECTION] * x), c[PEAK_ROTATION]), c[PEAK_ROTATION]);
        c[PEAK_RATE] = pick(here, pick(faster, c[DIRECTION] * rate, c[PEAK_RATE]), c[PEAK_RATE]);
    }
}

/* Record the current rotation if it is the greatest from the start. */
INLINE void update_reach(Batch *b, M here)
{
    V *const c = b->c;
    if (!bits(here)) return;
    V rotation = c[ROTATION] + (c[DIRECTION] * c[X]);
    here = here & (magnitude(rotation) > magnitude(c[REACH_ROTATION]));
    c[REACH_ROTATION] = pick(here, rotation, c[REACH_ROTATION]);
    c[REACH_TIME] = pick(here, c[TIME], c[REACH_TIME]);
}

/* Log the loss of contact with the slip surface. */
INLINE void note_lift_off(Batch *b, M here)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    if (job->notes_room > 0) {
        note(b, here, NOTE_LIFTS);
    }
    here = here & (c[LIFT_TIME] != c[LIFT_TIME]);
    c[LIFT_TIME] = pick(here, c[TIME], c[LIFT_TIME]);
}

/* Reset the origin of rotation and slip to the current position, where another phase begins. */
INLINE void advance_origin(Batch *b, M here)
{
    V *const c = b->c;
    if (!bits(here)) return;
    c[ROTATION] = pick(here, c[ROTATION] + (c[DIRECTION] * c[X]), c[ROTATION]);
    c[SLIP] = pick(here, c[SLIP] + c[X], c[SLIP]);
    c[X] = pick(here, broadcast(0.0), c[X]);
}

/* Set the direction of travel at a standstill. */
INLINE void face(Batch *b, M here, V side)
{
    V *const c = b->c;
    if (!bits(here)) return;
    c[X] = pick(here, broadcast(0.0), c[X]);
    c[OMEGA] = pick(here, broadcast(0.0), c[OMEGA]);
    c[DIRECTION] = pick(here, side, c[DIRECTION]);
    c[LIFTED] = pick(here, broadcast(0.0), c[LIFTED]);
}

/* Start lanes with a velocity or at rest. */
static void start(Batch *b, M here)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    c[DIRECTION] = pick(here, pick(c[OMEGA] < 0.0, broadcast(-1.0), broadcast(1.0)), c[DIRECTION]);
    c[OMEGA] = pick(here, magnitude(c[OMEGA]), c[OMEGA]);
    c[X] = pick(here, broadcast(0.0), c[X]);
    c[LIFTED] = pick(here, broadcast(0.0), c[LIFTED]);
    c[FACED] = pick(here, broadcast(0.0), c[FACED]);
    M moves = c[OMEGA] > 0.0;
    c[PENDING] = pick(here, pick(moves, broadcast(START_MOVING), broadcast(RESOLVE)), c[PENDING]);
    c[CLOCKED] = pick(here, broadcast(0.0), c[CLOCKED]);
    c[NEGLIGIBLE] = pick(here, broadcast(ROUNDING), c[NEGLIGIBLE]);
    if (job->timed) {
        find_negligible(b, here);
    }
    find_pieces(b, here);
}

/* Count a phase that begins in the current direction. */
INLINE void count_phase(Batch *b, M here)
{
    V *const c = b->c;
    if (!bits(here)) return;
    M turns = (c[LAST_WAY] * c[DIRECTION]) < 0.0;
    c[PHASES] = pick(here, c[PHASES] + 1.0, c[PHASES]);
    c[TURNS] = pick(here, c[TURNS] + pick(turns, broadcast(1.0), broadcast(0.0)), c[TURNS]);
    c[LAST_WAY] = pick(here, c[DIRECTION], c[LAST_WAY]);
}

/* Start slip in the current direction. */
INLINE void start_moving(Batch *b, M here, V rate)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    c[STATUS] = pick(here, broadcast(MOVING), c[STATUS]);
    c[PASSED] = pick(here, broadcast(NOTHING), c[PASSED]);
    count_phase(b, here);
    if (job->notes_room > 0) {
        note(b, here, NOTE_BEGINS);
    }
    note_lift_off(b, here & (c[LIFTED] > 0.0));
    keep_faster(b, here, c[OMEGA], c[TIME], c[X], rate);
    c[PENDING] = pick(here, broadcast(READY), c[PENDING]);
}

/* Keep lanes at rest until their end. */
INLINE void stay(Batch *b, M here, V status)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    c[STATUS] = pick(here, status, c[STATUS]);
    c[END_ROTATION] = pick(here, c[ROTATION], c[END_ROTATION]);
    c[END_OMEGA] = pick(here, broadcast(0.0), c[END_OMEGA]);
    c[END_RATE] = pick(here, broadcast(0.0), c[END_RATE]);
    c[DIRECTION] = pick(here, broadcast(0.0), c[DIRECTION]);
    c[REST_SINCE] = pick(here, pick(c[REST_SINCE] > c[END_TIME], c[END_TIME], c[REST_SINCE]), c[REST_SINCE]);
    c[PENDING] = pick(here, broadcast(READY), c[PENDING]);
    V for_ever = broadcast(INFINITY);
    if (job->samples) {
        read_samples(b, here, c[TIME], for_ever, 0, 0);
    }
}

/* Return whether masses at rest may start in their direction. Shaking starts a one-way mass only down-slope. */
INLINE M may_start(Batch *b)
{
    const Job *const job = b->job;
    V *const c = b->c;
    V pull = c[job->role->driving_moment];
    M down_slope = (pull > 0.0) | ((pull == 0.0) & (c[DIRECTION] > 0.0));
    return (c[ONE_WAY] == 0.0) | down_slope;
}

/* Return whether masses swing for ever, because almost no force presses on them at their lowest point. */
INLINE M never_rests(Batch *b)
{
    const Job *const job = b->job;
    V *const c = b->c;
    V load = c[job->role->normal_load];
    V slope = c[job->role->normal_load_slope];
    V square = (load * load) + (slope * slope);
    V most = sqrt_of(square);
    V least = c[job->role->normal0] + (most - load);
    M carried = least <= ((double)CARRIED * most);
    return (c[FIRST_ONLY] == 1.0) | (carried & ~still_changes(b));
}

/* Keep masses at rest, until a force changes or for good. */
INLINE void stick(Batch *b, M here)
{
    V *const c = b->c;
    if (!bits(here)) return;
    M changes = still_changes(b);
    stay(b, here & ~changes, broadcast(ARRESTED));
    here = here & changes;
    c[STATUS] = pick(here, broadcast(RESTING), c[STATUS]);
    c[PENDING] = pick(here, broadcast(READY), c[PENDING]);
    note_lift_off(b, here & (c[LIFTED] > 0.0));
    here = here & ~may_start(b);
    c[DIRECTION] = pick(here, -c[DIRECTION], c[DIRECTION]);
    c[PENDING] = pick(here, broadcast(BEGIN_PHASE), c[PENDING]);
}

/* Let masses that moved down-slope stick, since they do not turn back, in the direction in which they may start. */
INLINE void rest_one_way(Batch *b, M here)
{
    V *const c = b->c;
    if (!bits(here)) return;
    M may = may_start(b);
    stick(b, here & may);
    here = here & ~may;
    face(b, here, -c[DIRECTION]);
    c[PENDING] = pick(here, broadcast(RESOLVE), c[PENDING]);
}

/* Start slip in the current direction, otherwise in the other direction if it is allowed, otherwise stick. */
static void resolve_stick_or_slip(Batch *b, M here)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    V terms = magnitude(c[job->role->driving]) + c[job->role->resisting];
    V unsure = EPS * (terms + (c[job->role->mu] * magnitude(c[job->role->normal0])));
    M of_weight = (c[job->role->driving] == c[job->role->driving_moment]) & (c[job->role->normal0] == c[job->role->normal_load]);
    of_weight = of_weight & (c[job->role->resisting] == 0.0);
    M refined = ((c[LIMIT_REST] * c[job->role->drive]) != 0.0) & of_weight;
    unsure = maximum(pick(refined, c[job->role->drive_scale], unsure), broadcast(CLOSEST));
    M may = here & may_start(b);
    V margin = magnitude(c[job->role->drive]) / unsure;
    c[CLOSE] = pick(here, pick(may, minimum(c[CLOSE], margin), c[CLOSE]), c[CLOSE]);
    M starts = may & (c[job->role->drive] > 0.0);
    start_moving(b, starts, c[job->role->drive]);
    here = here & ~starts;
    c[FACED] = pick(here, c[FACED] + 1.0, c[FACED]);
    M stays_down = may & (c[ONE_WAY] > 0.0);
    M sticks = here & ((c[FACED] > 1.0) | stays_down);
    stick(b, sticks);
    face(b, here & ~sticks, -c[DIRECTION]);
}

/* Decide whether masses at a standstill, or at the start, stop, stick or slip. */
INLINE void resolve_standstill(Batch *b, M here)
{
    V *const c = b->c;
    if (!bits(here)) return;
    M stops = here & (c[FIRST_ONLY] > 0.0) & (c[PHASES] > 0.0);
    if (bits(stops)) {
        stops = stops & never_rests(b);
        stay(b, stops, broadcast(STOPPED));
        here = here & ~stops;
    }
    M one_way = here & (c[PENDING] == (double)REST);
    rest_one_way(b, one_way);
    resolve_stick_or_slip(b, here & ~one_way);
}

/* Begin a phase in motion with the drive computed anew or continued, whichever is more accurate. */
INLINE void carry_net_moment(Batch *b, M here, V net)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    c[PENDING] = pick(here, broadcast(READY), c[PENDING]);
    V change = net - c[job->role->drive];
    V terms = (magnitude(c[RATE_BEFORE]) + magnitude(change)) + magnitude(c[DRIVE_BEFORE]);
    V carried = c[SCALE_BEFORE] + (EPS * terms);
    here = here & (carried < c[job->role->drive_scale]);
    c[job->role->drive] = pick(here, c[job->role->drive] + (c[RATE_BEFORE] - net), c[job->role->drive]);
    c[job->role->drive_scale] = pick(here, carried, c[job->role->drive_scale]);
}

/* Begin the phases for which lanes wait, from their net moments and normal forces. */
static void resolve_pending(Batch *b, M waits, V net, V force)
{
    const Job *const job = b->job;
    V *const c = b->c;
    M enters = waits & (c[PENDING] == (double)ENTER_PHASE);
    M begins = waits & (c[PENDING] == (double)BEGIN_PHASE);
    M moving = waits & (c[PENDING] == (double)START_MOVING);
    M again = waits & (c[PENDING] == (double)START_AGAIN);
    M decides = waits & ~(enters | begins | moving | again);
    M by_force = moving & (force < 0.0);
    M at_rest = again | decides;
    M by_load = at_rest & (c[job->role->normal0] <= 0.0);
    M lifts = (by_force | by_load) & (c[LIFTED] == 0.0);
    c[LIFTED] = pick(lifts, broadcast(1.0), c[LIFTED]);
    c[PENDING] = pick(begins, broadcast(READY), c[PENDING]);
    carry_net_moment(b, enters, net);
    M starts = (moving | again) & ~lifts;
    if (bits(starts)) {
        M level = again & starts & (c[SUDDEN] <= 0.0);
        c[job->role->drive] = pick(level, broadcast(0.0), c[job->role->drive]);
        start_moving(b, starts, pick(again, c[job->role->drive], net));
    }
    resolve_standstill(b, decides & ~lifts);
}

/* Decide about contact after a jump of forces. If contact changes, another phase begins. */
INLINE void on_discontinuity(Batch *b, M here, V force)
{
    V *const c = b->c;
    if (!bits(here)) return;
    V lifted = pick(force < 0.0, broadcast(1.0), broadcast(0.0));
    M same = c[LIFTED] == lifted;
    note_lift_off(b, here & (lifted > c[LIFTED]));
    c[PENDING] = pick(here, pick(same, broadcast(READY), broadcast(BEGIN_PHASE)), c[PENDING]);
    c[LIFTED] = pick(here, lifted, c[LIFTED]);
    advance_origin(b, here & ~same);
}

/* Begin all pending phases, until every lane is ready for a step. */
static void begin_phases(Batch *b)
{
    const Job *const job = b->job;
    V *const c = b->c;
    M sudden = c[PENDING] == (double)DISCONTINUITY;
    if (bits(sudden)) {
        evaluate(b);
        V force = normal_force(b);
        on_discontinuity(b, sudden, force);
    }
    M waits = c[PENDING] != (double)READY;
    while (bits(waits)) {
        begin_pieces(b, waits);
        prologue(b, waits);
        if (bits((c[PENDING] == (double)START_MOVING) | (c[PENDING] == (double)ENTER_PHASE))) {
            evaluate(b);
        }
        V force = normal_force(b);
        V net = (b->r + job->role->net)[0];
        resolve_pending(b, waits, net, force);
        waits = c[PENDING] != (double)READY;
    }
}

/* Begin a phase in the current state. Its prologue follows. */
static void begin_here(Batch *b, M here)
{
    V *const c = b->c;
    if (!bits(here)) return;
    c[X] = pick(here, broadcast(0.0), c[X]);
    find_pieces(b, here);
    begin_pieces(b, here);
}

/* Place lanes at the left end of a piece, which they have not entered yet. */
INLINE void stand_before(Batch *b, M here, int t, V piece, V now)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    c[TIME] = pick(here, now, c[TIME]);
    c[job->table[t].cell + PIECE] = pick(here, piece - 1.0, c[job->table[t].cell + PIECE]);
    c[job->table[t].cell + WAY] = pick(here, broadcast(INFINITY), c[job->table[t].cell + WAY]);
}

/* Bound the values of the function of time, without its factor, for which sign p certainly keeps its sign. p is
 * linear in the function. */
static void keep_quiet(Batch *b, M here, int t, V *p, V sign, V terms)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    V now = (c[job->table[t].cell + VALUE] + c[job->table[t].cell + INC]) / c[job->table[t].cell + SCALED_BY];
    V rise = c[job->table[t].cell + RISE] / c[job->table[t].cell + SCALED_BY];
    M level = c[job->table[t].cell + RISE] == 0.0;
    V way = (sign * p[1]) * rise;
    V room = ((SURE * p[0]) * rise) / p[1];
    V bound = pick(level, now, now - room);
    M straight = (p[2] == 0.0) & (c[SERIES_ORDER] <= 4.0);
    V rounding = ROUNDINGS * terms;
    M sure = straight & ((sign * p[0]) > rounding) & (c[LIFTED] == 0.0);
    c[QUIET_FROM] = pick(here, pick(level | (way > 0.0), maximum(bound, c[QUIET_FROM]), c[QUIET_FROM]), c[QUIET_FROM]);
    c[QUIET_TO] = pick(here, pick(level | (way < 0.0), minimum(bound, c[QUIET_TO]), c[QUIET_TO]), c[QUIET_TO]);
    c[QUIET_TO] = pick(here, pick(sure, c[QUIET_TO], broadcast(-INFINITY)), c[QUIET_TO]);
}

/* Find the range of one function of time in which the mass certainly stays at rest in its direction. */
INLINE void look_for_quiet(Batch *b, M here)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    V terms_of_normal = EPS * (magnitude(c[job->role->normal_load]) + magnitude(c[job->role->normal_load_slope]));
    for (int t = 0; t < job->tables; t++) {
        if ((job->table[t].kind == OF_TIME) && (job->data[t].terms == 2)) {
            keep_quiet(b, here, t, b->r + job->role->net, broadcast(-1.0), c[job->role->drive_scale]);
            if (job->role->normal >= 0) {
                keep_quiet(b, here, t, b->r + job->role->normal, broadcast(1.0), terms_of_normal);
            }
        }
    }
}

/* Return the place in a record, up to rounding, at which the end time is reached. */
INLINE V latest_end(Batch *b, int t)
{
    const Job *const job = b->job;
    V *const c = b->c;
    return (c[END_TIME] * c[job->table[t].cell + SCALE]) * (1.0 - (4.0 * EPS));
}

/* Pass the pieces through which masses certainly rest, as both end values are in the quiet range. The following
 * piece must end before the end time, so that the function cannot jump between both. */
INLINE void rest_through(Batch *b, M here, int t)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    V piece = last_quiet(b, here, t, latest_end(b, t));
    M passes = here & (piece > c[job->table[t].cell + PIECE]);
    V now = breaks_at(b, t, piece) / c[job->table[t].cell + SCALE];
    if (job->samples) {
        read_samples(b, passes, c[TIME], now, 0, 0);
    }
    stand_before(b, passes, t, piece, now);
}

/* Enter the next pieces of functions of time, or those after all pieces in which masses certainly rest. */
INLINE void enter_pieces(Batch *b, M here)
{
    const Job *const job = b->job;
    if (!bits(here)) return;
    for (int t = 0; t < job->tables; t++) {
        if ((job->timed == 1) && (job->table[t].kind == OF_TIME) && (job->data[t].terms == 2)) {
            rest_through(b, here, t);
        }
    }
    pass_breaks(b, here);
}

/* Return the path over the length of a piece after a time at a speed, with a net moment that rises linearly. */
INLINE V path(V time, V omega, V net, V rise)
{
    V by_rise = (SIXTH * time) * rise;
    V by_net = (0.5 * net) + by_rise;
    V mean = omega + (time * by_net);
    return time * mean;
}

/* Return the first time at which a falling speed is zero. */
INLINE V standstill(V omega, V net, V rise)
{
    V square = net * net;
    V decrease = (2.0 * rise) * omega;
    V left = maximum(square - decrease, broadcast(0.0));
    V root = sqrt_of(left);
    M falls = net <= 0.0;
    V over = pick(falls, 2.0 * omega, net + root);
    V under = pick(falls, root - net, 0.0 - rise);
    return over / under;
}

/* Place lanes at the left end of a piece, at rest or in motion. Another phase begins there. */
static void end_slide(Batch *b, M here, int t, int piece, V x, V omega)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    c[X] = pick(here, x, c[X]);
    c[OMEGA] = pick(here, omega, c[OMEGA]);
    c[STEPS] = pick(here, broadcast(0.0), c[STEPS]);
    c[PASSED] = pick(here, broadcast(NOTHING), c[PASSED]);
    M moves = omega > 0.0;
    c[STATUS] = pick(here, pick(moves, broadcast(MOVING), broadcast(RESTING)), c[STATUS]);
    c[TIME] = pick(here, pick(moves, c[TIME], c[REST_SINCE]), c[TIME]);
    update_reach(b, here & ~moves);
    advance_origin(b, here);
    stand_before(b, here, t, broadcast((double)piece), job->data[t].breaks[piece] / c[job->table[t].cell + SCALE]);
    pass_break(b, here, t);
    c[PENDING] = pick(here, broadcast(BEGIN_PHASE), c[PENDING]);
}

/* Pass a part of a piece in which the net moment keeps its sign; return the speed at its end and the path. Lanes
 * start at its beginning, or stop within it. ``span`` and path are over the length of the piece. */
static Pair pass_part(Batch *b, M here, V now, V length, V span, V omega, V net, V rise)
{
    V *const c = b->c;
    V mean = net + ((0.5 * span) * rise);
    V end = omega + (span * mean);
    M moves = omega > 0.0;
    M goes_on = end > 0.0;
    count_phase(b, here & goes_on & ~moves);
    V time = 1.0 * span;
    M stops = here & moves & ~goes_on;
    if (bits(stops)) {
        time = pick(stops, standstill(omega, net, rise), span);
        c[REST_SINCE] = pick(here, pick(stops, now + (length * time), c[REST_SINCE]), c[REST_SINCE]);
    }
    V way = path(time, omega, net, rise);
    M slides = moves | goes_on;
    return (Pair){pick(goes_on, end, broadcast(0.0)), pick(slides, way, broadcast(0.0))};
}

/* Pass a piece in which lanes start, stop, or have their greatest or lowest speed. Return the speed at its end and
 * the path over its length. Where the net moment changes its sign the piece has two parts. */
INLINE Pair pass_change(Batch *b, M here, V now, V length, V x, V omega, V net, V after)
{
    V rise = after - net;
    M changes = here & ((net > 0.0) != (after > 0.0));
    V share = pick(changes, (-net) / rise, broadcast(1.0));
    const Pair speed_way = pass_part(b, here, now, length, share, omega, net, rise);
    V speed = speed_way.one, way = speed_way.other;
    V until = now + (length * share);
    keep_faster(b, changes & (net > 0.0), speed, until, x + (length * way), broadcast(0.0));
    const Pair end_further = pass_part(b, changes, until, length, 1.0 - share, speed, broadcast(0.0), rise);
    V end = end_further.one, further = end_further.other;
    return (Pair){pick(changes, end, speed), (way + pick(changes, further, broadcast(0.0)))};
}

/* Return the speed at the end of a piece and the path over its length; lanes outside the mask ``here`` rest. */
static Pair pass_piece(Batch *b, M here, V now, V length, V x, V omega, V net, V after)
{
    V twice = net + after;
    V by_rates = net + twice;
    V end = pick(here, omega + (0.5 * twice), broadcast(0.0));
    V way = pick(here, omega + (SIXTH * by_rates), broadcast(0.0));
    M changes = (net > 0.0) != (after > 0.0);
    M moves = (omega > 0.0) & (end > 0.0);
    M turns = here & (changes | ~moves);
    if (bits(turns)) {
        const Pair speed_further = pass_change(b, turns, now, length, x, omega, net, after);
        V speed = speed_further.one, further = speed_further.other;
        end = pick(turns, speed, end);
        way = pick(turns, further, way);
    }
    return (Pair){end, way};
}

/* Return the lanes for which a piece ends before a place and not at the last break, where the record may jump. */
INLINE M passes(Batch *b, int t, int piece, V before)
{
    const Job *const job = b->job;
    M inside = (M){0};
    if ((piece + 2) < (int)job->data[t].pieces) {
        inside = job->data[t].breaks[piece + 2] < before;
    }
    return inside;
}

/* Return the time at which a piece ends, where ``per`` is 1 over the scale. */
INLINE V end_of(Batch *b, int t, int piece, V per)
{
    const Job *const job = b->job;
    return job->data[t].breaks[piece + 1] * per;
}

/* Return the value of a record, without its factor, at the right end of a piece. */
INLINE V height_after(Batch *b, int t, int piece)
{
    const Job *const job = b->job;
    return broadcast(job->data[t].coefficients[(2 * piece) + 2]);
}

/* Return the lanes that certainly rest in a piece if they rest at its left end, and that do not leave after it.
 * They leave where the following piece does not end before a place. */
INLINE M rests_through(Batch *b, int t, int piece, V before)
{
    const Job *const job = b->job;
    V *const c = b->c;
    V height = height_after(b, t, piece);
    M quiet = (c[QUIET_FROM] <= height) & (height <= c[QUIET_TO]);
    return quiet & (job->data[t].breaks[piece + 2] < before);
}

/* Return the last piece through which all lanes certainly rest, from a piece at rest on. */
static int last_at_rest(Batch *b, M on, int t, int piece, V before)
{
    const Job *const job = b->job;
    int last = piece;
    while (((last + 3) < (int)job->data[t].pieces) && !bits(on & ~rests_through(b, t, last + 1, before))) {
        last = last + 1;
    }
    return last;
}

/* End the slide of lanes that may lift or end in the next piece, and return the other lanes. */
INLINE M keep_sliding(Batch *b, M on, int t, int piece, V before, V press, V x, V omega)
{
    M inside = passes(b, t, piece, before) & (press > 0.0);
    M leaves = on & ~inside;
    end_slide(b, leaves, t, piece, x, omega);
    return on & inside;
}

/* Move lanes at rest through the pieces of a record, exactly: omega is quadratic in time, and x cubic. The net
 * moment is ``base`` + ``slope`` times the record, the normal force is ``weight`` + ``grip`` times the record,
 * which is without its factor. A lane leaves before a piece in which it may lift. */
static void slide(Batch *b, M here, int t, int first, V slope, V base, V grip, V weight)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    V per = 1.0 / c[job->table[t].cell + SCALE];
    V before = latest_end(b, t);
    int piece = first;
    V now = c[TIME];
    V net = (b->r + job->role->net)[0];
    V omega = broadcast(0.0);
    V x = broadcast(0.0);
    M on = here;
    while (bits(on)) {
        V until = end_of(b, t, piece, per);
        V after = base + (slope * height_after(b, t, piece));
        M drives = (net > 0.0) | (after > 0.0);
        M acts = on & ((omega > 0.0) | drives);
        if (bits(acts)) {
            V length = until - now;
            V at_first = length * net;
            V at_last = length * after;
            const Pair speed_way = pass_piece(b, acts, now, length, x, omega, at_first, at_last);
            V speed = speed_way.one, way = speed_way.other;
            omega = speed;
            x = x + (length * way);
        }
        if (!bits(acts)) {
            piece = last_at_rest(b, on, t, piece, before);
            until = end_of(b, t, piece, per);
            after = base + (slope * height_after(b, t, piece));
        }
        now = until;
        net = after;
        piece = piece + 1;
        V press = weight + (grip * height_after(b, t, piece));
        on = keep_sliding(b, on, t, piece, before, press, x, omega);
    }
}

/* Move lanes that rest in the same piece, down-slope; return lanes that follow in a later round. So the numbers of
 * a lane do not depend on other lanes. */
static M slide_together(Batch *b, M here, int t)
{
    const Job *const job = b->job;
    V *const c = b->c;
    V *net = b->r + job->role->net;
    V slope = net[1] / c[job->table[t].cell + RISE];
    V origin = c[job->table[t].cell + VALUE] + c[job->table[t].cell + INC];
    V base = net[0] - (slope * origin);
    V grip = broadcast(0.0);
    if (job->role->normal >= 0) {
        grip = (b->r + job->role->normal)[1] / c[job->table[t].cell + RISE];
    }
    V force = normal_force(b);
    V weight = force - (grip * origin);
    M straight = net[2] == 0.0;
    M forward = here & straight & (c[job->table[t].cell + RISE] != 0.0);
    int piece = greatest(pick(forward, c[job->table[t].cell + PIECE], broadcast(-1.0)));
    M same = c[job->table[t].cell + PIECE] == (double)piece;
    M there = forward & same;
    if (bits(there)) {
        V ahead = c[job->table[t].cell + VALUE] + c[job->table[t].cell + LOWER];
        V press = weight + (grip * ahead);
        V before = latest_end(b, t);
        M inside = there & passes(b, t, piece, before) & (press > 0.0);
        V by_height = slope * c[job->table[t].cell + SCALED_BY];
        V grip_by_height = grip * c[job->table[t].cell + SCALED_BY];
        slide(b, inside, t, piece, by_height, base, grip_by_height, weight);
    }
    return forward & ~there;
}

/* Begin another phase in motion: lanes enter another piece of a table, are lifted or land. */
INLINE void enter_phase(Batch *b, M here, V rate)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    c[RATE_BEFORE] = pick(here, rate, c[RATE_BEFORE]);
    c[DRIVE_BEFORE] = pick(here, c[job->role->drive], c[DRIVE_BEFORE]);
    c[SCALE_BEFORE] = pick(here, c[job->role->drive_scale], c[SCALE_BEFORE]);
    advance_origin(b, here);
    c[PENDING] = pick(here, broadcast(ENTER_PHASE), c[PENDING]);
}

/* Bring lanes to a standstill, reversed unless they are one-way, so that rounding cannot continue their motion. */
INLINE void on_standstill(Batch *b, M here)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    advance_origin(b, here);
    update_reach(b, here);
    c[REST_SINCE] = pick(here, c[TIME], c[REST_SINCE]);
    if (job->notes_room > 0) {
        note(b, here, NOTE_STANDS);
    }
    c[FACED] = pick(here, broadcast(1.0), c[FACED]);
    M one_way = c[ONE_WAY] > 0.0;
    face(b, here, pick(one_way, c[DIRECTION], -c[DIRECTION]));
    c[PENDING] = pick(here, pick(one_way, broadcast(REST), broadcast(RESOLVE)), c[PENDING]);
}

/* Lose or regain contact with the slip surface. */
INLINE void change_contact(Batch *b, M here)
{
    V *const c = b->c;
    if (!bits(here)) return;
    c[LIFTED] = pick(here, 1.0 - c[LIFTED], c[LIFTED]);
    c[PASSED] = pick(here, broadcast(LIFT), c[PASSED]);
    note_lift_off(b, here & (c[LIFTED] > 0.0));
}

/* Place lanes exactly at an edge of a table of slip, speed or rotation, in the next piece. */
static void on_breakpoint(Batch *b, M here, int t, M upwards)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    if (job->table[t].kind == OF_ROTATION) {
        M forward = c[DIRECTION] > 0.0;
        c[ROTATION] = pick(here, pick(forward, end_of_piece(b, t, c[job->table[t].cell + PIECE]), breaks_at(b, t, c[job->table[t].cell + PIECE])), c[ROTATION]);
        return;
    }
    if (job->table[t].kind == OF_SPEED) {
        c[OMEGA] = pick(here, pick(upwards, c[job->table[t].cell + UPPER], c[job->table[t].cell + LOWER]), c[OMEGA]);
        c[PASSED] = pick(here, pick(upwards, broadcast(FASTER), broadcast(SLOWER)), c[PASSED]);
    }
    c[job->table[t].cell + PIECE] = pick(here, c[job->table[t].cell + PIECE] + pick(upwards, broadcast(1.0), broadcast(-1.0)), c[job->table[t].cell + PIECE]);
    if (job->table[t].kind == OF_SLIP) {
        c[SLIP] = pick(here, breaks_at(b, t, c[job->table[t].cell + PIECE]) / c[job->table[t].cell + SCALE], c[SLIP]);
    }
    if (job->data[t].open) {
        here = here & upwards & (c[job->table[t].cell + PIECE] == (double)((int)job->data[t].pieces - 1));
        c[STATUS] = pick(here, broadcast(NEED), c[STATUS]);
        c[PENDING] = pick(here, broadcast(READY), c[PENDING]);
    }
}

/* Pass edges of tables of slip, speed or rotation. */
INLINE void on_breakpoints(Batch *b, M here, V rate)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    enter_phase(b, here, rate);
    for (int t = 0; t < job->tables; t++) {
        int upper = EVENT_BREAKPOINT + (2 * t);
        M upwards = c[EVENT] == (double)upper;
        M downwards = c[EVENT] == (double)(upper + 1);
        on_breakpoint(b, here & (upwards | downwards), t, upwards);
    }
}

/* End moving lanes at their end time or with an upright chord. */
INLINE void end_motion(Batch *b, M here, V rate, V status)
{
    V *const c = b->c;
    if (!bits(here)) return;
    c[STATUS] = pick(here, status, c[STATUS]);
    c[END_ROTATION] = pick(here, c[ROTATION] + (c[DIRECTION] * c[X]), c[END_ROTATION]);
    c[END_OMEGA] = pick(here, c[DIRECTION] * c[OMEGA], c[END_OMEGA]);
    c[END_RATE] = pick(here, c[DIRECTION] * rate, c[END_RATE]);
    update_reach(b, here);
}

/* Apply the consequences of the event that ends a step. */
static void settle(Batch *b, M here, V rate)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    c[STATUS] = pick(here, pick(c[EVENT] == (double)EVENT_ENDLESS, broadcast(TOO_LONG), c[STATUS]), c[STATUS]);
    M limits = here & (c[EVENT] == (double)EVENT_LIMIT);
    pass_breaks(b, limits & (c[TIME] < c[END_TIME]));
    end_motion(b, limits & (c[TIME] >= c[END_TIME]), rate, broadcast(ENDED));
    on_standstill(b, here & (c[EVENT] == (double)EVENT_STANDSTILL));
    M lifts = here & (c[EVENT] == (double)EVENT_LIFT_OFF);
    change_contact(b, lifts);
    if (job->notes_room > 0) {
        note(b, lifts & (c[LIFTED] == 0.0), NOTE_LANDS);
    }
    enter_phase(b, lifts, rate);
    end_motion(b, here & (c[EVENT] == (double)EVENT_CHORD_UPRIGHT), rate, broadcast(UPRIGHT));
    on_breakpoints(b, here & (c[EVENT] >= (double)EVENT_BREAKPOINT), rate);
}

/* Shorten the step to an event at a time, infinite without an event. Each event is searched in the step that
 * earlier events leave. */
INLINE void consider(Batch *b, M here, V at, int event)
{
    V *const c = b->c;
    if (!bits(here)) return;
    c[EVENT] = pick(here, pick(at <= c[STEP], broadcast((double)event), c[EVENT]), c[EVENT]);
    c[STEP] = pick(here, minimum(at, c[STEP]), c[STEP]);
}

/* Shorten the step to the time left, up to a break of a function of time or the end time. */
static void reach_limit(Batch *b, M here, V room, int top)
{
    V *const c = b->c;
    if (!bits(here)) return;
    M reaches = here & (room < INFINITY);
    if (bits(reaches)) {
        V at = variable_at(b, top, room);
        reaches = reaches & (at < INFINITY);
        c[STEP] = pick(here, pick(reaches, at, c[STEP]), c[STEP]);
    }
    c[EVENT] = pick(here, pick(reaches, broadcast(EVENT_LIMIT), broadcast(EVENT_NONE)), c[EVENT]);
}

/* Find the time at which the speed becomes zero. It is immediate if the drive from rest points backwards or is
 * rounding. */
static void find_standstill(Batch *b, M here, int top)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    V *omega = b->r + job->role->omega;
    V *net = b->r + job->role->net;
    V last = value(omega, top, c[STEP]);
    M from_rest = omega[0] == 0.0;
    M decelerates = net[0] < 0.0;
    M falls_from_rest = from_rest & (decelerates | ((net[0] == 0.0) & (net[1] <= 0.0)));
    M dips = decelerates & (value(net, top - 1, c[STEP]) > 0.0);
    M asked = here & ((last <= 0.0) | dips | falls_from_rest);
    if (bits(asked)) {
        V e[STRIDE];
        margin_of(e, omega, top, broadcast(1.0), broadcast(0.0), from_rest);
        for (int _ = 1; _ <= 2; _++) {
            margin_of(e, e, top, broadcast(1.0), broadcast(0.0), from_rest & (e[0] == 0.0));
        }
        V at = first_root(e, top, c[STEP], asked);
        M vanishes = from_rest & (e[0] == 0.0) & (last == 0.0);
        M at_once = asked & ((e[0] < 0.0) | vanishes);
        consider(b, here, pick(at_once, broadcast(0.0), at), EVENT_STANDSTILL);
    }
}

/* Find the time at which sign p + constant falls through zero, unless the phase began with this event. */
static void find_crossing(Batch *b, M here, V *p, int n, V sign, V constant, M passed, int event)
{
    V *const c = b->c;
    if (!bits(here)) return;
    V at = crossing(p, n, c[STEP], sign, constant, passed, here);
    consider(b, here, at, event);
}

/* Find the time at which contact with the slip surface is lost or regained. */
static void find_contact_change(Batch *b, M here, int top)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    if (job->role->normal >= 0) {
        V sign = pick(c[LIFTED] > 0.0, broadcast(-1.0), broadcast(1.0));
        M passed = c[PASSED] == (double)LIFT;
        find_crossing(b, here, b->r + job->role->normal, top - 1, sign, broadcast(0.0), passed, EVENT_LIFT_OFF);
    }
}

/* Find the time at which an edge of a table's piece is passed. The last piece may have no upper edge. */
static void find_edges(Batch *b, M here, int t, int top, int by_rotation)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    M ends = here & (c[job->table[t].cell + UPPER] < FAR);
    V upper = minimum(c[job->table[t].cell + UPPER], broadcast(FAR));
    int event = EVENT_BREAKPOINT + (2 * t);
    if (job->table[t].kind == OF_SPEED) {
        V *omega = b->r + job->role->omega;
        M slower = c[PASSED] == (double)SLOWER;
        find_crossing(b, ends, omega, top, broadcast(-1.0), upper, slower, event);
        M varies = here & (c[job->table[t].cell + LOWER] > 0.0);
        M faster = c[PASSED] == (double)FASTER;
        find_crossing(b, varies, omega, top, broadcast(1.0), -c[job->table[t].cell + LOWER], faster, event + 1);
        return;
    }
    if (by_rotation) {
        V ahead = upper - c[X];
        consider(b, here, pick(ends, ahead, broadcast(INFINITY)), event);
        return;
    }
    find_crossing(b, ends, b->r + job->role->x, top, broadcast(-1.0), upper, (M){0}, event);
}

/* Find the first event of the step. Of simultaneous events the last one in the order of the search is used. Water
 * over a mass may change faster than its motion, which determines the step. The normal force is therefore valid
 * only until the first other event, beyond which it may pass zero twice. */
static void find_events(Batch *b, M here, int top, int by_rotation)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    find_standstill(b, here, top);
    if (job->role->upright >= 0) {
        find_crossing(b, here, b->r + job->role->upright, top - 1, broadcast(1.0), broadcast(0.0), (M){0}, EVENT_CHORD_UPRIGHT);
    }
    for (int t = 0; t < job->tables; t++) {
        if (job->table[t].kind != OF_TIME) {
            int follows = (t > 0) && (job->table[t].kind == OF_ROTATION);
            int known = follows && (job->table[t - 1].kind == OF_ROTATION);
            if (known) {
                known = !bits(here & (minimum(c[job->table[t].cell + UPPER], broadcast(FAR)) != c[job->table[t - 1].cell + UPPER]));
            }
            if (!known) {
                find_edges(b, here, t, top, by_rotation);
            }
        }
    }
    find_contact_change(b, here, top);
}

/* Shorten the step to the longest one that the series of the states allow, except where series end early. The
 * rotation is the integral of the angular velocity and allows the same step. In tau it is the integral of an
 * expression with the square of the angular velocity, so that its series alone decides. */
INLINE void choose_step(Batch *b, M here, int top)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    M complete = here & (c[SERIES_ORDER] == c[ORDER]);
    if (bits(complete)) {
        V step = broadcast(INFINITY);
        for (const State *q = job->state; q < job->state + job->states; q++) {
            int decides = (q->series == job->role->x) == (job->role->pace >= 0);
            if (decides) {
                step = minimum(longest_step(b, b->r + q->series, top, c[SERIES_ORDER]), step);
            }
        }
        c[STEP] = pick(here, pick(complete, minimum(step, c[STEP]), c[STEP]), c[STEP]);
    }
}

/* Advance the states besides rotation and speed, and the functions of time, by the step. */
INLINE void advance_further(Batch *b, M here, int top)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    for (const State *q = job->state; q < job->state + job->states; q++) {
        int further = !((q->series == job->role->x) || (q->series == job->role->omega));
        if (further) {
            c[q->cell] = pick(here, c[q->cell] + increment(b->r + q->series, top, c[STEP]), c[q->cell]);
        }
    }
    for (int t = 0; t < job->tables; t++) {
        if (job->table[t].kind == OF_TIME) {
            c[job->table[t].cell + INC] = pick(here, c[job->table[t].cell + INC] + rise_of_step(b, t), c[job->table[t].cell + INC]);
        }
    }
}

/* End motions that continue for ever. If the rate depends on the speed alone and hardly changes it, the rate never
 * becomes negative again. Neither does a mass come to rest that nothing but its speed brakes. */
INLINE void find_endless(Batch *b, M here, V room)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    V change = (b->r + job->role->net)[0] * c[STEP];
    M settled = change >= ((double)(-SETTLED) * (b->r + job->role->omega)[0]);
    M unopposed = magnitude(c[job->role->drive]) <= ((double)SETTLED * c[job->role->drive_scale]);
    M uneventful = c[EVENT] == (double)EVENT_NONE;
    here = here & uneventful & (settled | unopposed) & (room == INFINITY) & (c[LIFTED] == 0.0);
    c[EVENT] = pick(here, broadcast(EVENT_ENDLESS), c[EVENT]);
    c[STEP] = pick(here, broadcast(0.0), c[STEP]);
}

/* Record the greatest speed within the step, where the net moment falls through zero. */
static void keep_peak(Batch *b, M here, int top, V rate, V slope)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    V *net = b->r + job->role->net;
    V at = falling_root(net, top - 1, c[STEP], rate, slope, here);
    M peaks = at < INFINITY;
    if (bits(peaks)) {
        V since = elapsed(b, top, at);
        V time = c[TIME] + since;
        V speed = value(b->r + job->role->omega, top, at);
        V x = value(b->r + job->role->x, top, at);
        V rate_there = value(net, top - 1, at);
        keep_faster(b, peaks, speed, time, x, rate_there);
    }
}

/* Let a step end at the time ``until``, count it, and apply its consequences. */
INLINE void arrive(Batch *b, M here, V until, V rate)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    keep_faster(b, here, c[OMEGA], until, c[X], rate);
    c[TIME] = pick(here, until, c[TIME]);
    V change = magnitude((b->r + job->role->net)[0]) * c[STEP];
    M steady = (change < ((double)STIFF_CHANGE * (b->r + job->role->omega)[0])) & (c[EVENT] == (double)EVENT_NONE);
    V steps = c[STEPS] + pick(steady, broadcast(STIFF_STEP), broadcast(1.0));
    c[STEPS] = pick(here, pick(c[EVENT] == (double)EVENT_LIMIT, broadcast(0.0), steps), c[STEPS]);
    c[PASSED] = pick(here, broadcast(NOTHING), c[PASSED]);
    settle(b, here & (c[EVENT] != (double)EVENT_NONE), rate);
}

/* Make one step of moving lanes. */
static void make_step(Batch *b, M here)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    V limit = minimum(next_break(b), c[END_TIME]);
    V room = limit - c[TIME];
    int top = expand(b, room, here, 0);
    choose_step(b, here, top);
    reach_limit(b, here, room, top);
    find_events(b, here, top, 0);
    if (job->autonomous) {
        find_endless(b, here, room);
    }
    V step = c[STEP];
    V *net = b->r + job->role->net;
    V *omega = b->r + job->role->omega;
    V *x = b->r + job->role->x;
    V rate = broadcast(0.0);
    V slope = broadcast(0.0);
    V faster = broadcast(0.0);
    V farther = broadcast(0.0);
    for (int k = top - 1; k >= 0; k--) {
        slope = (slope * step) + rate;
        rate = (rate * step) + net[k];
        faster = (faster * step) + omega[k + 1];
        farther = (farther * step) + x[k + 1];
    }
    keep_peak(b, here, top, rate, slope);
    V time = c[TIME] + elapsed(b, top, step);
    V until = pick(c[EVENT] == (double)EVENT_LIMIT, limit, time);
    if (job->samples) {
        read_samples(b, here, c[TIME], until, 1, top);
    }
    c[OMEGA] = pick(here, c[OMEGA] + (step * faster), c[OMEGA]);
    c[X] = pick(here, c[X] + (step * farther), c[X]);
    advance_further(b, here, top);
    rate = per_time(b, rate, c[OMEGA]);
    arrive(b, here, until, rate);
}

/* Return a sum with sine and 1 - cosine of the current rotation. */
INLINE V at_rotation(Batch *b, V constant, V sine, V versine)
{
    V *const c = b->c;
    V turned = (sine * c[SINE_X]) + (versine * c[VERSINE_X]);
    return constant + turned;
}

/* Return the net moment of a mass at rest where its phase began, and its rate with the function of time. */
INLINE Pair net_at_rest(Batch *b)
{
    const Job *const job = b->job;
    V *const c = b->c;
    V moment = at_rotation(b, c[job->role->drive], c[job->role->net_sine], c[job->role->net_vers]);
    return (Pair){moment, at_rotation(b, c[job->role->net_record], c[job->role->net_record_sine], c[job->role->net_record_vers])};
}

/* Return the normal force of a mass at rest where its phase began, and its rate with the function of time. */
INLINE Pair force_at_rest(Batch *b)
{
    const Job *const job = b->job;
    V *const c = b->c;
    V force = at_rotation(b, c[job->role->normal0], c[job->role->normal_sine], c[job->role->normal_vers]);
    return (Pair){force, at_rotation(b, c[job->role->normal_record], c[job->role->normal_record_sine], c[job->role->normal_record_vers])};
}

/* Return coefficient n of the product of two series. */
INLINE V coefficient_of_product(V *p, V *q, int n)
{
    V total = broadcast(0);
    for (int k = 0; k <= n; k++) {
        total = total + (p[k] * q[n - k]);
    }
    return total;
}

/* Compute the series of a piece from the factors of 1, sin(x) and 1 - cos(x), and from their rates. */
static void expand_piece(Batch *b, V *e, V *rise, V *sine, V *versine)
{
    const Job *const job = b->job;
    V *const c = b->c;
    V *x = b->r + job->role->x;
    V *omega = b->r + job->role->omega;
    V *net = b->r + job->role->net;
    x[0] = c[X];
    omega[0] = c[OMEGA];
    sine[0] = c[SINE_X];
    versine[0] = c[VERSINE_X];
    for (int n = 0; n <= TOP - 1; n++) {
        V total = ((e[1] * sine[n]) + (e[2] * versine[n])) + (c[job->role->net_square] * coefficient_of_product(omega, omega, n));
        if (n == 0) {
            total = total + e[0];
        }
        if (n == 1) {
            total = total + rise[0];
        }
        if (n > 0) {
            total = total + ((rise[1] * sine[n - 1]) + (rise[2] * versine[n - 1]));
        }
        net[n] = total;
        x[n + 1] = omega[n] * b->inverse[n + 1];
        omega[n + 1] = total * b->inverse[n + 1];
        V along = omega[n] - coefficient_of_product(versine, omega, n);
        sine[n + 1] = along * b->inverse[n + 1];
        versine[n + 1] = coefficient_of_product(sine, omega, n) * b->inverse[n + 1];
    }
}

/* Compute the factors of 1, sin(x) and 1 - cos(x) in the net moment, and their rates. */
INLINE void find_factors(Batch *b, int t, V *factors, V *rise)
{
    const Job *const job = b->job;
    V *const c = b->c;
    rise[0] = c[job->role->net_record] * c[job->table[t].cell + RISE];
    rise[1] = c[job->role->net_record_sine] * c[job->table[t].cell + RISE];
    rise[2] = c[job->role->net_record_vers] * c[job->table[t].cell + RISE];
    factors[0] = c[job->role->drive] + (c[job->role->net_record] * c[job->table[t].cell + INC]);
    factors[1] = c[job->role->net_sine] + (c[job->role->net_record_sine] * c[job->table[t].cell + INC]);
    factors[2] = c[job->role->net_vers] + (c[job->role->net_record_vers] * c[job->table[t].cell + INC]);
}

/* Shorten a step to a standstill, record a peak within it, and return the rate of the speed at its end. */
static V pass_events(Batch *b, M here, V left)
{
    const Job *const job = b->job;
    V *const c = b->c;
    V *omega = b->r + job->role->omega;
    V *net = b->r + job->role->net;
    c[STEP] = pick(here, left, c[STEP]);
    c[EVENT] = pick(here, broadcast(EVENT_NONE), c[EVENT]);
    V loss = left * minimum(net[0], broadcast(0.0));
    V bend = (left * left) * magnitude(omega[2]);
    M slow = here & (omega[0] > 0.0) & ((omega[0] + loss) <= (2.0 * bend));
    find_standstill(b, slow, TOP);
    V step = c[STEP];
    const Pair rate_slope = value_and_slope(net, TOP - 1, step);
    V rate = rate_slope.one, slope = rate_slope.other;
    V most = omega[0] + (step * net[0]);
    M peaks = here & (rate <= 0.0) & (net[0] > 0.0) & (most > magnitude(c[PEAK_OMEGA]));
    keep_peak(b, peaks, TOP, rate, slope);
    return rate;
}

/* Move lanes to the end of a piece, or to a standstill within it. */
static void move_within(Batch *b, M here, int t)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    V factors[STRIDE];
    V rise[STRIDE];
    V sine[STRIDE];
    V versine[STRIDE];
    find_factors(b, t, factors, rise);
    expand_piece(b, factors, rise, sine, versine);
    V rate = pass_events(b, here, c[job->table[t].cell + UPPER] - c[TIME]);
    V step = c[STEP];
    V *omega = b->r + job->role->omega;
    V speed = omega[0] + increment(omega, TOP, step);
    M stops = here & ((c[EVENT] == (double)EVENT_STANDSTILL) | (speed <= 0.0));
    c[X] = pick(here, c[X] + increment(b->r + job->role->x, TOP, step), c[X]);
    c[OMEGA] = pick(here, pick(stops, broadcast(0.0), speed), c[OMEGA]);
    c[SINE_X] = pick(here, c[SINE_X] + increment(sine, TOP, step), c[SINE_X]);
    c[VERSINE_X] = pick(here, c[VERSINE_X] + increment(versine, TOP, step), c[VERSINE_X]);
    c[job->table[t].cell + INC] = pick(here, c[job->table[t].cell + INC] + (step * c[job->table[t].cell + RISE]), c[job->table[t].cell + INC]);
    V then = pick(stops, c[TIME] + step, c[job->table[t].cell + UPPER]);
    keep_faster(b, here, c[OMEGA], then, c[X], rate);
    c[REST_SINCE] = pick(here, pick(stops, then, c[REST_SINCE]), c[REST_SINCE]);
    c[TIME] = pick(here, then, c[TIME]);
}

/* Return whether masses are pressed through a piece, for which the series suffice, and not at the lowest place.
 * The piece must end before the end time, and not at the last break, where the function may jump. */
static M fits(Batch *b, int t)
{
    const Job *const job = b->job;
    V *const c = b->c;
    V last = broadcast((double)((int)job->data[t].pieces - 1));
    V beyond = breaks_at(b, t, minimum(c[job->table[t].cell + PIECE] + 2.0, last));
    M inside = ((c[job->table[t].cell + PIECE] + 1.0) < last) & (beyond < INFINITY) & (c[job->table[t].cell + UPPER] < c[END_TIME]);
    V size = c[job->role->driving_moment] + magnitude(c[job->role->driving_moment_slope]);
    M drives = (size * c[X]) < (0.5 * c[job->role->driving_moment]);
    V length = c[job->table[t].cell + UPPER] - c[TIME];
    V turning = magnitude(c[job->role->net_record_sine]) + magnitude(c[job->role->net_record_vers]);
    V moments = (magnitude(c[job->role->net_sine]) + magnitude(c[job->role->net_vers])) + (turning * magnitude(c[job->table[t].cell + LOWER]));
    V path = length * (c[OMEGA] + ((32.0 * length) * moments));
    V terms = magnitude(c[job->role->normal_load]) + magnitude(c[job->role->normal_load_slope]);
    const Pair force_by_record = force_at_rest(b);
    V force = force_by_record.one, by_record = force_by_record.other;
    return inside & drives & (path < SHORT) & ((force + (by_record * c[job->table[t].cell + LOWER])) > (PRESSED * terms));
}

/* Advance lanes at rest to the start of their motion, and return the lanes that start in the piece they reach. The
 * net moment is valid in contact. Lanes that may lift within a piece stay at its left end, where they leave. */
static M wait_for_start(Batch *b, M here, int t)
{
    const Job *const job = b->job;
    V *const c = b->c;
    V *net = b->r + job->role->net;
    V *normal = b->r + job->role->normal;
    const Pair moment_by_record = net_at_rest(b);
    V moment = moment_by_record.one, by_record = moment_by_record.other;
    const Pair force_force_by_record = force_at_rest(b);
    V force = force_force_by_record.one, force_by_record = force_force_by_record.other;
    net[0] = moment + (by_record * c[job->table[t].cell + INC]);
    net[1] = by_record * c[job->table[t].cell + RISE];
    net[2] = broadcast(0.0);
    normal[0] = force + (force_by_record * c[job->table[t].cell + INC]);
    normal[1] = force_by_record * c[job->table[t].cell + RISE];
    normal[2] = broadcast(0.0);
    c[QUIET_FROM] = pick(here, broadcast(-INFINITY), c[QUIET_FROM]);
    c[QUIET_TO] = pick(here, broadcast(INFINITY), c[QUIET_TO]);
    look_for_quiet(b, here);
    enter_pieces(b, here);
    V now = minimum(moment + (by_record * c[job->table[t].cell + INC]), broadcast(0.0));
    V then = moment + (by_record * c[job->table[t].cell + LOWER]);
    M starts = here & (then > (SURELY * c[job->role->drive_scale])) & fits(b, t);
    V share = pick(starts, now / (now - then), broadcast(0.0));
    c[TIME] = pick(here, c[TIME] + (share * (c[job->table[t].cell + UPPER] - c[TIME])), c[TIME]);
    c[job->table[t].cell + INC] = pick(here, c[job->table[t].cell + INC] + (share * (c[job->table[t].cell + LOWER] - c[job->table[t].cell + INC])), c[job->table[t].cell + INC]);
    return starts;
}

/* Leave moving lanes to the integration in time, and begin another phase for lanes that rest after a motion. */
INLINE void leave_series(Batch *b, M here, V since)
{
    V *const c = b->c;
    if (!bits(here)) return;
    M moves = c[OMEGA] > 0.0;
    c[STATUS] = pick(here, pick(moves, broadcast(MOVING), broadcast(RESTING)), c[STATUS]);
    here = here & ~moves & (c[TIME] > since);
    c[STEPS] = pick(here, broadcast(0.0), c[STEPS]);
    update_reach(b, here);
    advance_origin(b, here);
    c[PENDING] = pick(here, broadcast(BEGIN_PHASE), c[PENDING]);
}

/* Move lanes at rest through the pieces of a record, down-slope, as far as the series of a piece fit. */
static void turn_through(Batch *b, M here, int t)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    c[SINE_X] = pick(here, broadcast(0.0), c[SINE_X]);
    c[VERSINE_X] = pick(here, broadcast(0.0), c[VERSINE_X]);
    V since = c[TIME];
    while (bits(here)) {
        M moves = here & (c[OMEGA] > 0.0);
        M rests = here & (c[OMEGA] == 0.0);
        M starts = (M){0};
        if (bits(rests)) {
            starts = wait_for_start(b, rests, t);
        }
        M goes = starts | (moves & fits(b, t));
        leave_series(b, here & ~goes, since);
        count_phase(b, starts & goes);
        here = goes;
        move_within(b, here, t);
        pass_break(b, here & (c[TIME] == c[job->table[t].cell + UPPER]), t);
    }
}

/* Return whether the net moment has this form. */
INLINE int has_recurrence(Batch *b)
{
    const Job *const job = b->job;
    return HAS_CLOSED_FORM(job->role) && !SOFTENS(job->role);
}

/* Compute the series of start + sine sin(x) + vers (1 - cos(x)). */
INLINE void expand_force(Batch *b, V *p, V start, V sine, V vers, int top)
{
    p[0] = start;
    p[1] = sine;
    p[2] = 0.5 * vers;
    for (int n = 3; n <= top; n++) {
        p[n] = (-p[n - 2]) * (b->inverse[n] * b->inverse[n - 1]);
    }
}

/* Add the parts that E and its weight cause to coefficient n of net moment and weight. */
INLINE void complete_net(Batch *b, V *weight, int n)
{
    const Job *const job = b->job;
    V *const c = b->c;
    V *e = b->r + job->role->omega;
    V net = 1.0 * (b->r + job->role->net)[n];
    for (int t = 0; t < job->tables; t++) {
        int most = job->table[t].degree < n ? job->table[t].degree : n;
        for (int k = 1; k <= most; k++) {
            net = net + (c[job->table[t].cell + Q1 + k - 1] * weight[n - k]);
        }
    }
    (b->r + job->role->net)[n] = net + (c[job->role->net_square] * e[n]);
    weight[n] = weight[n] + (c[job->role->net_loss_square] * e[n]);
}

/* Compute the series of the normal force and of the dip of the chord. */
INLINE void expand_contact(Batch *b, int top)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (job->role->normal >= 0) {
        V *normal = b->r + job->role->normal;
        expand_force(b, normal, c[job->role->normal0], c[job->role->normal_sine], c[job->role->normal_vers], top);
        for (int n = 0; n <= top - 1; n++) {
            normal[n] = normal[n] + (c[job->role->normal_square] * (b->r + job->role->omega)[n]);
        }
    }
    if (job->role->upright >= 0) {
        expand_force(b, b->r + job->role->upright, c[job->role->normal_load], c[job->role->upright_sine], c[job->role->upright_vers], top);
    }
}

/* Return the path beyond which a step in rotation is useless, as the mass rests, and store the size of terms. The
 * end is estimated by a parabola. If it is too near, another step follows. */
INLINE V look_for_end(Batch *b, V room)
{
    const Job *const job = b->job;
    V *const c = b->c;
    V *e = b->r + job->role->omega;
    V product = e[0] * e[2];
    V square = (e[1] * e[1]) - (4.0 * product);
    V root = sqrt_of(maximum(square, broadcast(0.0)));
    V end = (e[1] + root) / ((-2.0) * e[2]);
    V nearer = minimum(BEYOND * end, room);
    V path = pick(e[2] < 0.0, nearer, room);
    V largest = maximum(magnitude(e[2]), path * magnitude(e[3]));
    largest = maximum(magnitude(e[1]), path * largest);
    c[LARGEST_OMEGA] = maximum(magnitude(e[0]), path * largest);
    return path;
}

/* Compute coefficient n of the net moment and n + 1 of the states. */
INLINE void integrate_in_rotation(Batch *b, V *weight, int n)
{
    const Job *const job = b->job;
    V *e = b->r + job->role->omega;
    if (has_recurrence(b)) {
        complete_net(b, weight, n);
    }
    if (!has_recurrence(b)) {
        if (job->role->square >= 0) {
            (b->r + job->role->square)[n] = e[n];
        }
        operate(b, n, n + 1, 1, 0);
        (b->r + job->role->x)[n + 1] = broadcast((n == 0) ? 1.0 : 0.0);
    }
    e[n + 1] = (b->r + job->role->net)[n] * (2.0 * b->inverse[n + 1]);
}

/* Compute the series of a step up to ``room``, or the estimated end of motion, and return their highest order. A
 * series ends as soon as two consecutive terms are negligible, unless water or loads are functions of the
 * rotation, which may change faster than the motion. */
static int expand_in_rotation(Batch *b, V room, M which)
{
    const Job *const job = b->job;
    V *const c = b->c;
    int early = 1;
    for (int t = 0; t < job->tables; t++) {
        early = early && (job->table[t].kind != OF_ROTATION);
    }
    V order = pick(which, c[ORDER], broadcast(3.0));
    int top = greatest(order);
    V weight[STRIDE];
    int recurs = has_recurrence(b);
    begin_series(b);
    if (recurs) {
        expand_force(b, b->r + job->role->net, c[job->role->drive], c[job->role->net_sine], c[job->role->net_vers], top);
        expand_force(b, weight, c[job->role->net_loss], c[job->role->net_loss_sine], c[job->role->net_loss_vers], top);
    }
    V last = broadcast(0.0);
    V power = broadcast(0.0);
    M goes_on = which;
    int n = 0;
    while ((n < top) && bits(goes_on)) {
        integrate_in_rotation(b, weight, n);
        n = n + 1;
        power = power * c[STEP];
        M counts = which;
        if (early && (n > 3)) {
            counts = next_term_counts(b, n, power, 0);
        }
        if (n == 3) {
            c[STEP] = look_for_end(b, room);
            power = (c[STEP] * c[STEP]) * c[STEP];
        }
        last = pick(counts, broadcast((double)n), last);
        goes_on = goes_on & (last > (double)(n - 2));
    }
    order = pick(last < (order - 1.0), maximum(last, broadcast(3.0)), order);
    top = greatest(order);
    if (recurs) {
        expand_contact(b, top);
    }
    if (!recurs) {
        operate_later(b, top);
    }
    cut(b, order, top);
    c[SERIES_ORDER] = order;
    return top;
}

/* Return the integral of v dv/(sqrt(E) (1 + per v^2)^2) over a path by a rule, infinite if it is uncertain. The
 * path begins where v is ``first``, ``span`` is its length, and ``k_first`` the number of the rule's first node. */
static V integral(V *p, int n, int k_first, V most, V side, V first, V span, V per)
{
    V total = broadcast(0.0);
    V last = broadcast(0.0);
    V last_but_one = broadcast(0.0);
    int near_second = bits(per > 0.0);
    for (int k = k_first; k <= ((2 * k_first) + SHORTEST) - 1; k++) {
        V past = span * NODES[k];
        V v = first + past;
        V square = v * v;
        V share = broadcast(1.0);
        if (near_second) {
            share = 1.0 / (1.0 + (per * square));
        }
        V y = (past * (first + v)) * share;
        V speed = sqrt_of(value(p, n, side * y));
        V slowness = (v * (share * share)) / speed;
        total = total + (SHARES[k] * slowness);
        last = last + (LAST_SHARES[k] * slowness);
        last_but_one = last_but_one + (NEXT_SHARES[k] * slowness);
    }
    M accurate = (magnitude(last) + magnitude(last_but_one)) <= (most * total);
    return pick(accurate, total, broadcast(INFINITY));
}

/* Return the time over a path that begins at the distance ``beyond`` from a rest, infinite if it is uncertain. E
 * is the polynomial ``p`` of the distance from this beginning. ``way`` is the path with its sign: against the
 * motion if the rest is at the end. ``per`` is 1 over the distance of another rest in this direction, or 0. In the
 * variable v with v^2 = (beyond + y)/(1 - per y) both rests are regular. With ``fine`` the rule has more nodes; on
 * a short path far from rest half as many may suffice. */
static V time_over(V *p, int n, int fine, V way, V beyond, V per)
{
    V size = magnitude(way);
    V side = pick(way < 0.0, broadcast(-1.0), broadcast(1.0));
    V first = sqrt_of(beyond);
    V left = 1.0 - (per * size);
    V stretch = 1.0 + (per * beyond);
    V final = sqrt_of((beyond + size) / left);
    V span = (size * stretch) / (left * (first + final));
    V most = broadcast(fine ? CLOSER : EVEN);
    int rule = fine ? (3 * SHORTEST) : SHORTEST;
    M moves = size > 0.0;
    M is_short = moves & (size <= beyond) & (per == 0.0);
    V total = broadcast(INFINITY);
    if (bits(is_short)) {
        total = pick(is_short, integral(p, n, 0, most, side, first, span, per), total);
    }
    M remains = moves & (total == INFINITY);
    if (bits(remains)) {
        total = pick(remains, integral(p, n, rule, most, side, first, span, per), total);
    }
    return pick(moves, (span * stretch) * total, broadcast(0.0));
}

/* Return the distance at which the polynomial E has a zero, by Newton's method as far as it converges. It is
 * searched forwards if ``side`` is 1, backwards if it is -1. Without a zero there the distance is ``far``. */
INLINE V distance_of_rest(V *p, int n, V side, V far)
{
    V distance = ((-side) * p[0]) / p[1];
    for (int _ = 1; _ <= NEWTON; _++) {
        const Pair at_slope = value_and_slope(p, n, side * distance);
        V at = at_slope.one, slope = at_slope.other;
        V change = ((-side) * at) / slope;
        M converges = magnitude(change) < (0.5 * distance);
        distance = pick(converges, distance + change, distance);
    }
    V nearest = minimum(distance, far);
    return pick(distance >= 0.0, nearest, far);
}

/* Compute E as a polynomial of the distance from the end of the step. It has no rounding error where the mass
 * comes to rest, near which the duration depends on it. */
INLINE void expand_about_end(Batch *b, V *p, int n)
{
    const Job *const job = b->job;
    V *const c = b->c;
    V *e = b->r + job->role->omega;
    for (int k = 0; k <= n; k++) {
        p[k] = e[k];
    }
    shift(p, n, c[STEP]);
    M stands = c[EVENT] == (double)EVENT_STANDSTILL;
    p[0] = pick(stands, broadcast(0.0), p[0]);
}

/* Return 1 over the distance of the rest ahead, beyond a peak or estimated from E, or 0 if the path is too long. */
INLINE V rest_ahead(Batch *b, M peaks, V to_end, V path)
{
    const Job *const job = b->job;
    V *const c = b->c;
    V *e = b->r + job->role->omega;
    V by_bend = maximum((-e[2]) / e[1], broadcast(0.0));
    V ahead = pick(peaks, 1.0 / (c[STEP] + to_end), by_bend);
    M near = (e[1] > 0.0) & ((ahead * path) < NEAREST);
    return pick(near, ahead, broadcast(0.0));
}

/* Return the durations of the parts of a step before and after its greatest speed, infinite if uncertain. ``peak``
 * is the rotation at the greatest speed, infinite without one. */
static Pair times_of_step(Batch *b, M here, int top, V peak)
{
    const Job *const job = b->job;
    V *const c = b->c;
    V *e = b->r + job->role->omega;
    V step = c[STEP];
    M peaks = peak < INFINITY;
    V far = STRAIGHT * step;
    int fine = job->order > FINEST;
    M rises = e[1] > 0.0;
    V of_end[STRIDE];
    V to_end = 1.0 * far;
    M falls = (M){0};
    M nears = here & (peaks | ~rises);
    if (bits(nears)) {
        expand_about_end(b, of_end, top);
        to_end = distance_of_rest(of_end, top, broadcast(1.0), far);
        falls = here & ~peaks & ~rises & (of_end[1] < 0.0);
    }
    V behind = distance_of_rest(e, top, broadcast(-1.0), far);
    behind = pick(rises, behind, far);
    V path = minimum(peak, step);
    V ahead = rest_ahead(b, peaks, to_end, path);
    V after = broadcast(0.0);
    if (bits(peaks)) {
        V back = pick(peaks, peak - step, broadcast(0.0));
        V from_end = pick(rises, 1.0 / (step + behind), broadcast(0.0));
        after = time_over(of_end, top, fine, back, to_end, from_end);
    }
    for (int k = 0; k <= top; k++) {
        of_end[k] = pick(falls, of_end[k], e[k]);
    }
    V beyond = pick(falls, to_end, behind);
    path = pick(falls, -step, path);
    V before = time_over(of_end, top, fine, path, beyond, ahead);
    return (Pair){before, after};
}

/* Return the rotation up to which a step may go: to the next edge of a table. */
INLINE V way_ahead(Batch *b)
{
    const Job *const job = b->job;
    V *const c = b->c;
    V room = LONGEST + c[X];
    for (int t = 0; t < job->tables; t++) {
        if ((job->table[t].kind == OF_SLIP) || (job->table[t].kind == OF_ROTATION)) {
            room = minimum(c[job->table[t].cell + UPPER] - c[X], room);
        }
    }
    return room;
}

/* Shorten a step where the square of the speed bends upwards, so that a second rest behind is not too near. */
INLINE void shorten(Batch *b, M here)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    V *e = b->r + job->role->omega;
    M bends = here & (e[2] > 0.0) & (e[1] >= 0.0);
    V by_slope = e[1] / e[2];
    V by_speed = sqrt_of(e[0] / e[2]);
    V most = REACH * (by_slope + by_speed);
    V shorter = minimum(most, c[STEP]);
    c[STEP] = pick(here, pick(bends, shorter, c[STEP]), c[STEP]);
}

/* Bring lanes to the end of their step at the time ``until``, by the greatest speed after the time ``before``. */
static void complete(Batch *b, M here, int top, V peak, V before, V until)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    V *net = b->r + job->role->net;
    V *e = b->r + job->role->omega;
    V step = c[STEP];
    V rate = value(net, top - 1, step);
    M peaks = here & (peak < INFINITY);
    if (bits(peaks)) {
        V there = pick(peaks, peak, broadcast(0.0));
        V speed = sqrt_of(value(e, top, there));
        V slope = value(net, top - 1, there);
        keep_faster(b, peaks, speed, c[TIME] + before, c[X] + there, slope);
    }
    c[X] = pick(here, c[X] + step, c[X]);
    V square = e[0] + increment(e, top, step);
    c[OMEGA] = pick(here, sqrt_of(maximum(square, broadcast(0.0))), c[OMEGA]);
    arrive(b, here, until, rate);
    if (has_recurrence(b)) {
        enter_phase(b, here & (c[EVENT] == (double)EVENT_NONE), rate);
    }
}

/* Make one step of moving lanes in powers of the rotation. If its duration is uncertain or extremely short, or
 * exceeds the end time, the lane stays where it is and is integrated in time. */
static void turn_on(Batch *b, M here)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    V omega = 1.0 * c[OMEGA];
    c[OMEGA] = pick(here, omega * omega, c[OMEGA]);
    V room = way_ahead(b);
    int top = expand_in_rotation(b, room, here);
    choose_step(b, here, top);
    shorten(b, here);
    c[EVENT] = pick(here, broadcast(EVENT_NONE), c[EVENT]);
    find_events(b, here, top, 1);
    V peak = broadcast(INFINITY);
    V before = broadcast(0.0);
    V after = broadcast(0.0);
    M unsure = here;
    int count = 0;
    while (bits(unsure) && (count <= MOST_HALVINGS)) {
        const Pair rate_slope = value_and_slope(b->r + job->role->net, top - 1, c[STEP]);
        V rate = rate_slope.one, slope = rate_slope.other;
        peak = falling_root(b->r + job->role->net, top - 1, c[STEP], rate, slope, here);
        const Pair before_after = times_of_step(b, here, top, peak);
        before = before_after.one, after = before_after.other;
        unsure = here & ~((before + after) < INFINITY);
        c[STEP] = pick(here, pick(unsure, 0.5 * c[STEP], c[STEP]), c[STEP]);
        c[EVENT] = pick(here, pick(unsure, broadcast(EVENT_NONE), c[EVENT]), c[EVENT]);
        count = count + 1;
    }
    V duration = before + after;
    V until = c[TIME] + duration;
    M stands = (c[STEP] == 0.0) & (c[EVENT] == (double)EVENT_STANDSTILL);
    M regular = (duration > BRIEFEST) | stands;
    M fits = here & regular & (until < c[END_TIME]);
    c[OMEGA] = pick(here, omega, c[OMEGA]);
    c[CLOCKED] = pick(here, pick(fits, broadcast(0.0), broadcast(1.0)), c[CLOCKED]);
    complete(b, fits, top, peak, before, until);
}

/* Return x - sin(x) and 1 - cos(x), for |x| <= pi, from a quarter of the angle, doubled twice. */
static Pair turned(V x)
{
    V h = 0.25 * x;
    V square = h * h;
    V lag = broadcast(LAG[LAST]);
    V versine = broadcast(VERSINE[LAST]);
    for (int k = LAST - 1; k >= 0; k--) {
        lag = (lag * square) + LAG[k];
        versine = (versine * square) + VERSINE[k];
    }
    lag = (lag * square) * h;
    versine = versine * square;
    for (int _ = 1; _ <= 2; _++) {
        V sine = h - lag;
        V change = sine * versine;
        lag = 2.0 * (lag + change);
        versine = 2.0 * (sine * sine);
        h = 2.0 * h;
    }
    return (Pair){lag, versine};
}

/* Return (y - 1 + exp(-y))/y^2, for 0 <= y <= 2, from a quarter of y, doubled twice. */
static V faded(V y)
{
    V h = 0.25 * y;
    V square = h * h;
    V even = broadcast(FADING[2 * LAST]);
    V odd = broadcast(FADING[(2 * LAST) - 1]);
    for (int k = LAST - 1; k >= 1; k--) {
        even = (even * square) + FADING[2 * k];
        odd = (odd * square) + FADING[(2 * k) - 1];
    }
    V part = (FADING[0] + (h * odd)) + (square * even);
    for (int _ = 1; _ <= 2; _++) {
        V lost = 1.0 - (h * part);
        part = (0.5 * part) + ((0.25 * lost) * lost);
        h = 2.0 * h;
    }
    return part;
}

/* Compute the factors of E, followed by q. */
INLINE void factors(V *e, V drive, V sine, V vers, V q)
{
    V square = q * q;
    V share = 2.0 / (1.0 + square);
    e[0] = 2.0 * drive;
    e[3] = share * (vers - (sine * q));
    e[2] = share * (sine + (vers * q));
    e[1] = (-q) * (e[3] + e[0]);
    e[4] = q;
}

/* Compute the four functions of which E is the sum. */
INLINE void functions(V *f, V x, V q)
{
    const Pair lag_versine = turned(x);
    V lag = lag_versine.one, versine = lag_versine.other;
    f[0] = x;
    f[1] = (x * x) * faded(q * x);
    f[2] = versine;
    f[3] = lag;
}

/* Return E from its factors and its functions. */
INLINE V energy(V *e, V *f)
{
    V faded_part = e[1] * f[1];
    V turned_part = (e[2] * f[2]) + (e[3] * f[3]);
    return (e[0] * f[0]) + (faded_part + turned_part);
}

/* Return start + sine sin + vers (1 - cos) at the rotation at which ``f`` has the functions of E. */
INLINE V force_at(V start, V sine, V vers, V *f)
{
    V sine_there = sine * (f[0] - f[3]);
    return start + (sine_there + (vers * f[2]));
}

/* Compute drive, sine and vers of the negative moment as a function of the distance from the end of a phase. They
 * are stored from place ``first`` on; ``f`` are the four functions at the end. */
INLINE void look_back(V *back, int first, V drive, V sine, V vers, V *f)
{
    V sine_end = f[0] - f[3];
    V cosine = 1.0 - f[2];
    V change = (sine * sine_end) + (vers * f[2]);
    back[first] = -(drive + change);
    back[first + 1] = (sine * cosine) + (vers * sine_end);
    back[first + 2] = (sine * sine_end) - (vers * cosine);
}

/* Compute the factors of E about the end of a phase, from the four functions there. */
INLINE void mirror(V *back, V drive, V sine, V vers, V q, V *f)
{
    look_back(back, 0, drive, sine, vers, f);
    factors(back, back[0], back[1], back[2], -q);
}

/* Replace the functions for q by those for -q. */
INLINE void reverse(V *f, V q)
{
    V y = q * f[0];
    V bend = (q * q) * f[1];
    V faded_by = (1.0 - y) + bend;
    V square = f[0] * f[0];
    V rest = (square - f[1]) - (y * f[1]);
    f[1] = rest / faded_by;
}

/* Compute the power series of the right-hand side. ``drive`` is the net moment with the load at the beginning. */
static void expand_right_side(Batch *b, V *e, V drive)
{
    V q = e[4];
    V sine = e[NET + 1] + (e[FIRST] * e[LOAD + 1]);
    V vers = e[NET + 2] + (e[FIRST] * e[LOAD + 2]);
    V fading = broadcast(2.0);
    V even = broadcast(2.0);
    V odd = broadcast(0.0);
    V before = broadcast(0.0);
    for (int k = 0; k <= 2 * HALF; k++) {
        V versine = fading - even;
        V whole = (drive * fading) + ((sine * odd) + (vers * versine));
        e[POWER + k] = (e[POLE] * whole) + before;
        before = (e[NET] * fading) + ((e[NET + 1] * odd) + (e[NET + 2] * versine));
        V of_sine = (odd * q) + even;
        V of_cosine = (even * q) - odd;
        fading = (fading * q) * b->inverse[k + 1];
        even = of_cosine * b->inverse[k + 1];
        odd = of_sine * b->inverse[k + 1];
    }
}

/* Compute -w/p and the power series. ``drive`` is the net moment with the load at the beginning. */
static void hyperbolic_factors(Batch *b, V *e, V q, V drive)
{
    e[0] = 2.0 * e[NET];
    e[4] = q;
    e[SHIFT] = pick(e[SHIFT] == 0.0, broadcast(LEAST), e[SHIFT]);
    expand_right_side(b, e, drive);
    V higher = broadcast(0.0);
    for (int k = 2 * HALF; k >= 1; k--) {
        V per = 1.0 / (e[SHIFT] + (double)k);
        V shrink = ((double)(k + 1) * e[POLE]) * per;
        higher = (e[POWER + k] * per) - (shrink * higher);
        e[POWER + k] = higher;
    }
    V weight = e[POWER] - (e[POLE] * higher);
    e[POWER] = (-weight) / e[SHIFT];
}

/* Return E, and compute x in place 0, where the logarithm of 1 + x/pole is ``passed``. */
INLINE V hyperbolic_energy(V *e, V *f, V passed)
{
    V x = e[POLE] * expm1_of(passed);
    f[0] = x;
    V square = x * x;
    V even = e[POWER + (2 * HALF)];
    V odd = e[(POWER + (2 * HALF)) - 1];
    for (int k = HALF - 1; k >= 1; k--) {
        even = (even * square) + e[POWER + (2 * k)];
        odd = (odd * square) + e[(POWER + (2 * k)) - 1];
    }
    V series = x * (odd + (x * even));
    V singular = e[POWER] * expm1_of((-e[SHIFT]) * passed);
    return (1.0 + expm1_of((-e[4]) * x)) * (series + singular);
}

/* Compute the factors of all terms from the numbers of the net moment without the load, and of the load. */
static void factors_of_terms(V *e, V q, V rate)
{
    factors(e, e[NET], e[NET + 1], e[NET + 2], q);
    V part[STRIDE];
    V weight = broadcast(1.0);
    for (int j = 1; j <= TERMS; j++) {
        V before = weight;
        weight = (weight * e[SHIFT]) / (double)(-j);
        V drive = (weight * e[NET]) + (before * e[LOAD]);
        V sine = (weight * e[NET + 1]) + (before * e[LOAD + 1]);
        V vers = (weight * e[NET + 2]) + (before * e[LOAD + 2]);
        V faster = q + ((double)j * rate);
        factors(part, drive, sine, vers, faster);
        e[CONSTANT + j] = (part[0] + part[3]) / part[4];
        e[SINE + j] = part[3];
        e[VERS + j] = part[2];
    }
}

/* Compute the factors of E from the numbers of the net moment and of the load. ``drive`` is their sum. */
INLINE void factors_of_law(Batch *b, V *e, V q, V rate, V drive)
{
    const Job *const job = b->job;
    if (job->role->per_pole >= 0) {
        hyperbolic_factors(b, e, q, drive);
        return;
    }
    factors_of_terms(e, q, rate);
}

/* Compute the factors of E. */
INLINE void softening_factors(Batch *b, V *e)
{
    const Job *const job = b->job;
    V *const c = b->c;
    e[SHIFT] = (2.0 * c[job->role->net_loss_square]) / c[job->role->loss_rate];
    e[FIRST] = broadcast(1.0);
    e[LOAD] = c[job->role->net_loss];
    e[LOAD + 1] = c[job->role->net_loss_sine];
    e[LOAD + 2] = c[job->role->net_loss_vers];
    e[NET] = c[job->role->drive] - c[job->role->net_loss];
    e[NET + 1] = c[job->role->net_sine] - c[job->role->net_loss_sine];
    e[NET + 2] = c[job->role->net_vers] - c[job->role->net_loss_vers];
    e[POLE] = (-1.0) / c[job->role->loss_rate];
    V q = 2.0 * (c[job->role->net_loss_square] - c[job->role->net_square]);
    factors_of_law(b, e, q, c[job->role->loss_rate], c[job->role->drive]);
}

/* Compute the factors of E as a function of the distance from the end of a phase, from the functions there. Near
 * the end E is small, and without a rounding error of the terms of which it is the sum. */
INLINE void factors_about_end(Batch *b, V *back, V *e, V *f)
{
    const Job *const job = b->job;
    V *const c = b->c;
    back[SHIFT] = e[SHIFT];
    back[FIRST] = 1.0 + f[4];
    look_back(back, LOAD, e[LOAD], e[LOAD + 1], e[LOAD + 2], f);
    look_back(back, NET, e[NET], e[NET + 1], e[NET + 2], f);
    back[POLE] = (-e[POLE]) - f[0];
    V drive = back[NET] + (back[FIRST] * back[LOAD]);
    factors_of_law(b, back, -e[4], -c[job->role->loss_rate], drive);
}

/* Return whether the series is as accurate as the order of a lane requires, and no term is in resonance. */
INLINE M series_suffices(Batch *b, V *e)
{
    const Job *const job = b->job;
    V *const c = b->c;
    M driven = magnitude(c[job->role->net_loss]) <= (DRIVEN * c[job->role->drive]);
    if (job->role->per_pole >= 0) {
        return driven & (e[SHIFT] > LEAST_EXPONENT);
    }
    M converges = magnitude(e[SHIFT]) <= GREATEST;
    M resonates = ((2.0 * e[4]) + c[job->role->loss_rate]) >= 0.0;
    return driven & converges & ~resonates;
}

/* Compute the functions of which E consists, the last one what friction has lost, such as exp(-slope x) - 1. */
INLINE void softening_functions(Batch *b, V *e, V *f, V x)
{
    const Job *const job = b->job;
    V *const c = b->c;
    functions(f, x, magnitude(e[4]));
    if (job->role->per_pole >= 0) {
        V change = c[job->role->loss_rate] * x;
        f[4] = change / (1.0 - change);
        return;
    }
    f[4] = expm1_of(c[job->role->loss_rate] * x);
}

/* Change the functions of a distance from the end of a phase to those of E there, at the rotation ``x``. */
INLINE void count_from_end(Batch *b, V *back, V *f, V x)
{
    const Job *const job = b->job;
    V *const c = b->c;
    reverse(f, -back[4]);
    f[4] = (-f[4]) * (1.0 + expm1_of(c[job->role->loss_rate] * x));
}

/* Return E from its factors and its functions. */
static V softening_energy(V *e, V *f)
{
    V first = e[FIRST];
    V left = first + f[4];
    V above = broadcast(0.0);
    V constant = broadcast(0.0);
    V of_sine = broadcast(0.0);
    V of_vers = broadcast(0.0);
    for (int j = TERMS; j >= 1; j--) {
        above = (above * first) + e[CONSTANT + j];
        constant = (constant * left) + above;
        of_sine = (of_sine * left) + e[SINE + j];
        of_vers = (of_vers * left) + e[VERS + j];
    }
    V sine = f[0] - f[3];
    V turned_part = left * ((of_vers * f[2]) - (of_sine * sine));
    V terms = (f[4] * constant) + turned_part;
    V shift = e[SHIFT] * left;
    V grown = broadcast(0.0);
    for (int k = LAST; k >= 0; k--) {
        grown = FADING[k] - (grown * shift);
    }
    V square = shift * shift;
    grown = 1.0 + (shift + (square * grown));
    V lost = f[0] - (e[4] * f[1]);
    V faded_part = (e[4] * (above * first)) * lost;
    return grown * (energy(e, f) + (terms + faded_part));
}

/* Return the variable of the rules: the rotation, or under hyperbolic friction the logarithm from its pole. */
INLINE V passed_to(Batch *b, V x)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (job->role->per_pole >= 0) {
        return log1p_of(c[job->role->per_pole] * x);
    }
    return x;
}

/* Compute the functions of which E consists, and return E. */
INLINE V energy_at(Batch *b, V *e, V *f, V x)
{
    const Job *const job = b->job;
    if (SOFTENS(job->role)) {
        softening_functions(b, e, f, x);
        return (job->role->per_pole >= 0) ? hyperbolic_energy(e, f, passed_to(b, x)) : softening_energy(e, f);
    }
    functions(f, x, e[4]);
    return energy(e, f);
}

/* Compute the functions of which E consists, and from place 5 on E and its first three derivatives. The
 * derivatives follow from the equation of motion, in which friction softens or is constant. The third one leaves
 * out that friction softens further. */
static void evaluate_at(Batch *b, V *e, V *f, V x)
{
    const Job *const job = b->job;
    V *const c = b->c;
    V drive = 1.0 * c[job->role->drive];
    V of_sine = 1.0 * c[job->role->net_sine];
    V of_vers = 1.0 * c[job->role->net_vers];
    V of_square = 1.0 * c[job->role->net_square];
    V by_loss = broadcast(0.0);
    f[5] = energy_at(b, e, f, x);
    if (SOFTENS(job->role)) {
        V left = 1.0 + f[4];
        V rate = c[job->role->loss_rate] * left;
        if (job->role->per_pole >= 0) {
            rate = rate * left;
        }
        V weight = force_at(c[job->role->net_loss], c[job->role->net_loss_sine], c[job->role->net_loss_vers], f);
        by_loss = rate * (weight + (c[job->role->net_loss_square] * f[5]));
        drive = drive + (f[4] * c[job->role->net_loss]);
        of_sine = of_sine + (f[4] * c[job->role->net_loss_sine]);
        of_vers = of_vers + (f[4] * c[job->role->net_loss_vers]);
        of_square = of_square + (f[4] * c[job->role->net_loss_square]);
    }
    V sine = f[0] - f[3];
    V cosine = 1.0 - f[2];
    V twice = 2.0 * of_square;
    f[6] = (2.0 * force_at(drive, of_sine, of_vers, f)) + (twice * f[5]);
    f[7] = (2.0 * (((of_sine * cosine) + (of_vers * sine)) + by_loss)) + (twice * f[6]);
    f[8] = (2.0 * ((of_vers * cosine) - (of_sine * sine))) + (twice * f[7]);
}

/* Return E at a distance from rest in the variable of the rules, and compute dx by this variable in place 5. */
INLINE V energy_past(Batch *b, V *e, V *f, V past, V end, int part)
{
    const Job *const job = b->job;
    f[5] = broadcast(1.0);
    if (job->role->per_pole >= 0) {
        V at = hyperbolic_energy(e, f, part ? -past : past);
        f[5] = magnitude(e[POLE] + f[0]);
        return at;
    }
    softening_functions(b, e, f, past);
    if (part) {
        count_from_end(b, e, f, end - past);
    }
    return softening_energy(e, f);
}

/* Return E and the integrand at a node of `time_of_part`, with its arguments. */
INLINE Pair at_node(Batch *b, V *e, V end, V unit, V bend, V node, int part)
{
    V here = unit * (node * node);
    V other = 1.0 + (bend * (1.0 - node));
    V share = 1.0 / (here + (other * other));
    V past = end * (here * share);
    V f[STRIDE];
    V energy_there = energy_past(b, e, f, past, end, part);
    return (Pair){energy_there, ((((share * share) * (other * node)) * f[5]) / sqrt_of(energy_there))};
}

/* Return the time before the greatest speed, or with ``part`` 1 after it, infinite if it is uncertain. The
 * variable v of the rule is 0 at rest and 1 at the peak: unit v^2/(1 + bend (1 - v))^2 is the ratio of the
 * distances to both rests, under hyperbolic friction of their logarithms from its pole. E rises from node to node.
 * There are twice as many nodes if they are to be ``closer``. */
static V time_of_part(Batch *b, V *e, V end, V unit, V bend, int part, int closer)
{
    const Job *const job = b->job;
    V total = broadcast(0.0);
    V last = broadcast(0.0);
    V last_but_one = broadcast(0.0);
    V lower = broadcast(0.0);
    int longest = closer && (part == 0);
    int k_first = longest ? (7 * SHORTEST) : ((closer == part) ? (3 * SHORTEST) : SHORTEST);
    for (int k = k_first; k <= ((2 * k_first) + SHORTEST) - 1; k++) {
        const Pair at_slowness = at_node(b, e, end, unit, bend, broadcast(NODES[k]), part);
        V at = at_slowness.one, slowness = at_slowness.other;
        total = pick(at > lower, total + (SHARES[k] * slowness), broadcast(INFINITY));
        lower = at;
        last = last + (LAST_SHARES[k] * slowness);
        last_but_one = last_but_one + (NEXT_SHARES[k] * slowness);
    }
    V most = broadcast((job->order > FINEST) ? CLOSER : ALIKE);
    V uneven = magnitude(last) + magnitude(last_but_one);
    M accurate = uneven <= (most * total);
    V time = ((end * unit) * (1.0 + bend)) * total;
    return pick(accurate, time, broadcast(INFINITY));
}

/* Return the times from rest to the greatest speed and to the end, infinite if they are uncertain. ``f`` has the
 * functions of E at the end. Error estimates change the factor of a lane, and with it the rules, which they so
 * compare. */
static Pair duration_of_softening(Batch *b, V *e, V *f, V end, V peak, int closer)
{
    const Job *const job = b->job;
    V *const c = b->c;
    V to_peak = passed_to(b, peak);
    V to_end = passed_to(b, end);
    V unit = to_peak / (to_end - to_peak);
    V softened = 1.0 - (peak * c[job->role->loss_rate]);
    V usual = pick(c[FACTOR] < BETWEEN, broadcast(RATIO_TO_ROUNDING), broadcast(RATIO));
    V change = c[FACTOR] / usual;
    V bend = (change * BENT) * sqrt_of(softened);
    if (job->role->per_pole >= 0) {
        bend = change * CLOSER_TO_POLE;
        V reach = end + e[POLE];
        M complete = ((1.0 + (e[4] * e[4])) * (reach * reach)) < COMPLETE;
        to_end = pick(complete, to_end, broadcast(INFINITY));
    }
    V before = time_of_part(b, e, to_end, unit, bend, 0, closer);
    V back[STRIDE];
    factors_about_end(b, back, e, f);
    V after = time_of_part(b, back, to_end, 1.0 / unit, change - 1.0, 1, closer);
    return (Pair){before, (before + after)};
}

/* Return the mean of the integrand by the trapezoidal rule of twice so many intervals, of every node in ``by``. */
INLINE V mean_of(V *both, int pairs, int by)
{
    V ends = both[0] + both[PAIRS];
    V total = 0.5 * ends;
    for (int k = 1; k <= pairs - 1; k++) {
        total = total + both[k * by];
    }
    return total / (double)(2 * pairs);
}

/* Compute the coefficients of the time as a series in u and sines of 2 u from the nodes of a rule. It is the
 * integral of a series of cosines, whose even coefficients are sums of ``both``, and whose odd coefficients are
 * sums of ``odd``. */
static void find_waves(V *w, M here, V *both, V *odd, int pairs, int by)
{
    if (!bits(here)) return;
    V scale = broadcast(1.0 / (double)pairs);
    w[0] = pick(here, mean_of(both, pairs, by), w[0]);
    for (int j = 1; j <= pairs; j++) {
        V of_odd = broadcast(0.0);
        V of_even = broadcast(0.0);
        int even_row = (2 * j) * (PAIRS + 1);
        int odd_row = even_row - (PAIRS + 1);
        for (int k = 0; k <= pairs; k++) {
            int node = k * by;
            of_odd = of_odd + (COSINES[odd_row + node] * odd[node]);
            of_even = of_even + (COSINES[even_row + node] * both[node]);
        }
        V last = broadcast((j == pairs) ? 0.5 : 1.0);
        w[(2 * j) - 1] = pick(here, scale * of_odd, w[(2 * j) - 1]);
        w[2 * j] = pick(here, (scale * last) * of_even, w[2 * j]);
    }
}

/* Return the time since rest at the rotation end sin(u)^2, and its derivative by u. ``place`` and ``sine`` are
 * -cos(2 u) and sin(2 u). */
static Pair time_at(V *w, V u, V place, V sine)
{
    int top = bits(w[LONG] > 0.0) ? (2 * PAIRS) : PAIRS;
    V twice = (-2.0) * place;
    V cosine = -place;
    V sine_before = broadcast(0.0);
    V cosine_before = broadcast(1.0);
    V time = (2.0 * w[0]) * u;
    V slope = 2.0 * w[0];
    for (int m = 1; m <= top; m++) {
        time = time + (w[m] * sine);
        slope = slope + (((double)(2 * m) * w[m]) * cosine);
        V sine_after = (twice * sine) - sine_before;
        V cosine_after = (twice * cosine) - cosine_before;
        sine_before = sine;
        cosine_before = cosine;
        sine = sine_after;
        cosine = cosine_after;
    }
    return (Pair){time, slope};
}

/* Return the time from rest to a rotation, with u from the series of the arcsine. */
INLINE V time_to(V *w, V x, V end)
{
    V left = end - x;
    V place = (x - left) / end;
    V sine = (2.0 * sqrt_of(x * left)) / end;
    V z = place / sqrt_of(2.0 + (2.0 * sine));
    V square = z * z;
    V total = broadcast(0.0);
    for (int k = LAST_OF_ARCSINE; k >= 0; k--) {
        total = (total * square) + ARCSINE[k];
    }
    const Pair time__ = time_at(w, QUARTER + (z * total), place, sine);
    V time = time__.one, _ = time__.other;
    return time;
}

/* Return whether the last two coefficients of the series of the time are not negligible. */
INLINE M is_uneven(V *w, int n)
{
    V last = magnitude(w[n - 1]) + magnitude(w[n]);
    return ~(last <= (LAST_WAVE * w[0]));
}

/* Compute the rotation, the angular velocity and its rate at a time since rest, where lanes of the mask move. The
 * search begins at the angle u in ``there``, to which it is added together with the slope of the time. */
static void find_state(Batch *b, V *there, M here, V *e, V *back, V *w, V end, V time)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    V u = there[ANGLE_THERE];
    V slope = broadcast(1.0);
    const Pair lag_versine = turned(2.0 * u);
    V lag = lag_versine.one, versine = lag_versine.other;
    M asked = here;
    int count = 0;
    while (bits(asked) && (count < MOST_CORRECTIONS)) {
        const Pair then_slope = time_at(w, u, versine - 1.0, (2.0 * u) - lag);
        V then = then_slope.one, slope = then_slope.other;
        V change = (time - then) / slope;
        u = pick(asked, u + change, u);
        asked = asked & (magnitude(change) > (LAST_OF_NEWTON * u));
        const Pair lag_versine = turned(2.0 * u);
        lag = lag_versine.one, versine = lag_versine.other;
        count = count + 1;
    }
    there[ANGLE_THERE] = u;
    there[SLOPE_THERE] = slope;
    V x = (0.5 * end) * versine;
    V f[STRIDE];
    functions(f, x, e[4]);
    V square = energy(e, f);
    there[0] = x;
    there[RATE_THERE] = force_at(c[job->role->drive], c[job->role->net_sine], c[job->role->net_vers], f) + (c[job->role->net_square] * square);
    M late = versine > 1.0;
    if (bits(here & late)) {
        const Pair __versine_back = turned(PI - (2.0 * u));
        V _ = __versine_back.one, versine_back = __versine_back.other;
        functions(f, (0.5 * end) * versine_back, e[4]);
        reverse(f, e[4]);
        square = pick(late, energy(back, f), square);
    }
    there[OMEGA_THERE] = sqrt_of(square);
}

/* Store the states at the output times within a phase, which ends at the time ``until``. */
static void keep_samples(Batch *b, M here, V *e, V *back, V *w, V end, V until)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    V there[STRIDE];
    there[ANGLE_THERE] = broadcast(0.0);
    there[SLOPE_THERE] = 2.0 * w[0];
    V before = c[TIME];
    int k = 0;
    while (k < job->samples) {
        V time = sample_time(b, k);
        M inside = here & (time >= c[TIME]) & (time < until);
        if (bits(inside)) {
            V ahead = (time - before) / there[SLOPE_THERE];
            there[ANGLE_THERE] = pick(inside, there[ANGLE_THERE] + ahead, there[ANGLE_THERE]);
            before = pick(inside, time, before);
            find_state(b, there, inside, e, back, w, end, time - c[TIME]);
            keep_sample(b, inside, k, there[0], there[OMEGA_THERE], there[RATE_THERE]);
        }
        k = k + 1;
    }
}

/* Return the first positive zero of E, by Halley's method on E/x, or a rotation beyond the farthest. */
static V end_of_swing(Batch *b, V *e, V sine, M which)
{
    V falls_by = (0.5 * (e[4] * e[0])) - sine;
    V x = e[0] / falls_by;
    V f[STRIDE];
    int count = 0;
    while (bits(which) && (count < MOST_CORRECTIONS)) {
        M inside = (x > 0.0) & (x < FARTHEST);
        x = pick(inside, x, broadcast(FARTHEST));
        evaluate_at(b, e, f, x);
        V at = f[5];
        V falls = (f[6] * x) - at;
        V bends = (f[7] * (x * x)) - (2.0 * falls);
        V steepness = ((2.0 * falls) * falls) - (at * bends);
        V change = (((2.0 * at) * falls) * x) / steepness;
        x = pick(which, x - change, x);
        which = which & (magnitude(change) > (LAST_OF_HALLEY * x));
        count = count + 1;
    }
    return pick(which, broadcast(2.0 * FARTHEST), x);
}

/* Return the rotation of the greatest speed if E is a cubic with these slopes at both of its zeros. */
INLINE V peak_of_cubic(V rise, V fall, V end)
{
    V square = (rise * rise) + (fall * (fall - rise));
    V falls_by = ((2.0 * rise) - fall) + sqrt_of(square);
    return (end * rise) / falls_by;
}

/* Return the rotation of the greatest speed, by Halley's method on the derivative of E from a rotation ``x`` on.
 * Places 9 and 10 of ``f`` have E and its derivative there. */
static V peak_of_swing(Batch *b, V *e, V *f, V x, V end, M which)
{
    V low = broadcast(0.0);
    V high = end;
    int count = 0;
    while (bits(which) && (count < (2 * MOST_CORRECTIONS))) {
        evaluate_at(b, e, f, x);
        V slope = f[6];
        low = pick(slope > 0.0, x, low);
        high = pick(slope > 0.0, high, x);
        V twice = 2.0 * f[7];
        V following = x - ((slope * twice) / ((twice * f[7]) - (slope * f[8])));
        following = inside_or_middle(following, low, high);
        V change = following - x;
        V bend = f[7] * change;
        f[9] = pick(which, f[5] + (change * (slope + (0.5 * bend))), f[9]);
        f[10] = pick(which, slope + bend, f[10]);
        x = pick(which, following, x);
        which = which & (magnitude(change) > (LAST_OF_NEWTON * x));
        count = count + 1;
    }
    return x;
}

/* Return whether start + sine sin + vers (1 - cos) is positive and concave over a rotation up to half a turn. A
 * sum of sines is concave between two such rotations if it is concave at both, and then positive if it is there. */
INLINE M stays_positive(V start, V sine, V vers, V *f)
{
    V at_end = force_at(start, sine, vers, f);
    V cosine = 1.0 - f[2];
    V change = sine * (f[0] - f[3]);
    M concave = (vers <= 0.0) & ((vers * cosine) <= change);
    return (start > 0.0) & (at_end > 0.0) & concave;
}

/* Return whether phases up to a rotation have the closed form, from the functions of E there. */
INLINE M has_closed_form(Batch *b, V *f, V q)
{
    const Job *const job = b->job;
    V *const c = b->c;
    V end = f[0];
    M near = (end < FARTHEST) & (q >= 0.0) & ((q * end) < FADED);
    M upright = stays_positive(c[job->role->normal_load], c[job->role->upright_sine], c[job->role->upright_vers], f);
    M pressed = stays_positive(c[job->role->normal0], c[job->role->normal_sine], c[job->role->normal_vers], f);
    return near & (c[job->role->normal_square] >= 0.0) & upright & pressed;
}

/* Compute sum and difference of the integrand at a node and at its mirror image, the same node from the end. */
INLINE void add_node(V *e, V *back, V end, V *both, V *odd, int k)
{
    V x = end * SINES[k];
    V f[STRIDE];
    functions(f, x, e[4]);
    V left = end - x;
    V room = x * left;
    V near = sqrt_of(room / energy(e, f));
    reverse(f, e[4]);
    V far = sqrt_of(room / energy(back, f));
    both[k] = near + far;
    odd[k] = near - far;
}

/* Return the time from rest to rest, infinite if it is uncertain, and compute the time as a series in ``w``. */
static V duration_of_swing(V *e, V *back, V end, V *w, M which)
{
    V both[STRIDE];
    V odd[STRIDE];
    V near = sqrt_of(end / e[0]);
    V far = sqrt_of(end / back[0]);
    both[0] = near + far;
    odd[0] = near - far;
    for (int k = 1; k <= 4; k++) {
        add_node(e, back, end, both, odd, 2 * k);
    }
    for (int m = 0; m <= LONG; m++) {
        w[m] = broadcast(0.0);
    }
    find_waves(w, which, both, odd, 4, 2);
    M unsure = which & is_uneven(w, 8);
    if (bits(unsure)) {
        for (int k = 1; k <= 4; k++) {
            add_node(e, back, end, both, odd, (2 * k) - 1);
        }
        find_waves(w, unsure, both, odd, 8, 1);
        w[LONG] = pick(unsure, broadcast(1.0), broadcast(0.0));
        unsure = unsure & is_uneven(w, 16);
    }
    return pick(unsure, broadcast(INFINITY), PI * w[0]);
}

/* Let masses at a standstill stick, without the numbers of another phase, if they clearly do not turn back.
 * ``rate`` is the net moment in the direction in which they arrived, ``lost`` the resistance that friction has
 * lost, and ``f`` has the functions of E at the end of the phase. */
INLINE void rest(Batch *b, M here, V rate, V lost, V *f)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    V force = force_at(c[job->role->normal0], c[job->role->normal_sine], c[job->role->normal_vers], f);
    V resistance = (c[job->role->resisting] + (c[job->role->mu] * force)) - lost;
    V driving = rate + resistance;
    V terms = (magnitude(driving) + resistance) + magnitude(lost);
    V excess = driving + resistance;
    M free = (c[ONE_WAY] == 0.0) & (c[FIRST_ONLY] == 0.0);
    M clear = excess > (CLEAR * terms);
    here = here & free & clear;
    V margin = excess / (EPS * terms);
    c[CLOSE] = pick(here, minimum(c[CLOSE], margin), c[CLOSE]);
    stick(b, here);
}

/* Let masses stick at the end of a phase in which friction has softened, if they clearly do not turn back. */
INLINE void rest_softened(Batch *b, M here, V *f)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    V lost = f[4] * force_at(c[job->role->net_loss], c[job->role->net_loss_sine], c[job->role->net_loss_vers], f);
    V rate = lost + force_at(c[job->role->drive], c[job->role->net_sine], c[job->role->net_vers], f);
    rest(b, here, rate, lost, f);
}

/* Record the greatest speed, which lanes reach after the time ``before``. ``f`` is that of `peak_of_swing`, which
 * returned the rotation ``peak``. */
INLINE void pass_peak(Batch *b, M here, V *f, V peak, V before)
{
    V *const c = b->c;
    if (!bits(here)) return;
    V speed = sqrt_of(f[9]);
    V then = c[TIME] + before;
    keep_faster(b, here, speed, then, peak, 0.5 * f[10]);
}

/* Bring lanes to rest at the end of their phase. */
INLINE void finish(Batch *b, M here, V end, V duration)
{
    V *const c = b->c;
    if (!bits(here)) return;
    c[X] = pick(here, end, c[X]);
    c[OMEGA] = pick(here, broadcast(0.0), c[OMEGA]);
    c[TIME] = pick(here, c[TIME] + duration, c[TIME]);
    c[STEPS] = pick(here, c[STEPS] + 1.0, c[STEPS]);
    c[PASSED] = pick(here, broadcast(NOTHING), c[PASSED]);
    on_standstill(b, here);
}

/* End lanes at their end time within a phase. */
static void end_within(Batch *b, M here, V *e, V *back, V *w, V end)
{
    V *const c = b->c;
    if (!bits(here)) return;
    V there[STRIDE];
    V time = c[END_TIME] - c[TIME];
    there[ANGLE_THERE] = (0.5 * time) / w[0];
    find_state(b, there, here, e, back, w, end, time);
    c[X] = pick(here, there[0], c[X]);
    c[OMEGA] = pick(here, there[OMEGA_THERE], c[OMEGA]);
    V rate = there[RATE_THERE];
    c[TIME] = pick(here, c[END_TIME], c[TIME]);
    c[STEPS] = pick(here, broadcast(0.0), c[STEPS]);
    keep_faster(b, here, c[OMEGA], c[TIME], c[X], rate);
    end_motion(b, here, rate, broadcast(ENDED));
}

/* Complete phases under constant friction, up to rest or the end time, and return these lanes. ``f`` has the
 * functions of E at the end of the phase, and ``at_peak`` is that of `peak_of_swing`. */
static M complete_swing(Batch *b, M fits, V *e, V *back, V *f, V *at_peak, V end, V peak)
{
    const Job *const job = b->job;
    V *const c = b->c;
    V w[STRIDE];
    V off_middle = magnitude((2.0 * peak) - end);
    fits = fits & (off_middle < (NEAR_MIDDLE * end));
    V duration = duration_of_swing(e, back, end, w, fits);
    V before = time_to(w, peak, end);
    V until = c[TIME] + duration;
    M rests = fits & (until < c[END_TIME]);
    M ends = fits & (until < INFINITY) & (until > (c[END_TIME] * (1.0 + CLOSE_TO_REST)));
    if (job->samples) {
        keep_samples(b, rests | ends, e, back, w, end, until);
    }
    pass_peak(b, rests | (ends & ((c[TIME] + before) < c[END_TIME])), at_peak, peak, before);
    finish(b, rests, end, duration);
    rest(b, rests, (-0.5) * back[0], broadcast(0.0), f);
    end_within(b, ends, e, back, w, end);
    return rests | ends;
}

/* Complete phases under softening laws, up to rest before the end time, and return these lanes. Lanes that hardly
 * come to rest before the end time are left at once. ``f`` and ``at_peak`` are those of `complete_swing`. */
static M complete_softening(Batch *b, M fits, V *e, V *f, V *at_peak, V end, V peak)
{
    const Job *const job = b->job;
    V *const c = b->c;
    V least = (LEAST_DURATION * end) / sqrt_of(at_peak[9]);
    fits = fits & ((c[TIME] + least) < c[END_TIME]);
    if (!bits(fits)) {
        return fits;
    }
    int fine = job->order > FINEST;
    const Pair before_duration = duration_of_softening(b, e, f, end, peak, fine);
    V before = before_duration.one, duration = before_duration.other;
    M unsure = fits & (duration == INFINITY);
    if (!fine && bits(unsure)) {
        const Pair sooner_sure = duration_of_softening(b, e, f, end, peak, 1);
        V sooner = sooner_sure.one, sure = sooner_sure.other;
        before = pick(unsure, sooner, before);
        duration = pick(unsure, sure, duration);
    }
    fits = fits & ((c[TIME] + duration) < c[END_TIME]);
    pass_peak(b, fits, at_peak, peak, before);
    finish(b, fits, end, duration);
    rest_softened(b, fits, f);
    return fits;
}

/* Complete the phases that begin at rest and in contact, where they have a closed form, and return these lanes. */
static M swing(Batch *b, M which)
{
    const Job *const job = b->job;
    V *const c = b->c;
    M rests = (c[X] == 0.0) & (c[OMEGA] == 0.0);
    M fits = which & rests & (c[job->role->drive] > 0.0) & (c[LIFTED] == 0.0);
    if (!bits(fits)) {
        return fits;
    }
    int softens = SOFTENS(job->role);
    V e[STRIDE];
    V back[STRIDE];
    V f[STRIDE];
    V sine = c[job->role->net_sine];
    if (softens) {
        softening_factors(b, e);
        fits = fits & series_suffices(b, e);
        sine = c[job->role->net_sine] - c[job->role->net_loss_sine];
    }
    if (!softens) {
        factors(e, c[job->role->drive], sine, c[job->role->net_vers], (-2.0) * c[job->role->net_square]);
    }
    V q = e[4];
    V end = end_of_swing(b, e, sine, fits);
    V farthest = minimum(end, broadcast(FARTHEST));
    V peak = 0.5 * end;
    if (softens) {
        softening_functions(b, e, f, farthest);
    }
    if (!softens) {
        functions(f, farthest, q);
        mirror(back, c[job->role->drive], sine, c[job->role->net_vers], q, f);
        peak = peak_of_cubic(e[0], back[0], end);
        fits = fits & (back[0] > 0.0);
    }
    fits = fits & has_closed_form(b, f, q);
    if (!bits(fits)) {
        return fits;
    }
    V at_peak[STRIDE];
    peak = peak_of_swing(b, e, at_peak, peak, end, fits);
    if (softens) {
        return complete_softening(b, fits, e, f, at_peak, end, peak);
    }
    return complete_swing(b, fits, e, back, f, at_peak, end, peak);
}

/* Find the next change of a mass at rest in its direction, if it precedes the changes that are known already. The
 * net moment at rest is a series of time alone. Slip begins at its root, where the drive is zero, or immediately
 * if the net moment is zero and rises, or has jumped above zero. */
static void look_ahead(Batch *b, M here, V room)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    int top = expand(b, room, here, 1);
    V *net = b->r + job->role->net;
    M complete = here & (c[SERIES_ORDER] == c[ORDER]);
    if (bits(complete)) {
        V step = longest_step(b, net, top - 1, c[SERIES_ORDER] - 1.0);
        c[STEP] = pick(here, pick(complete, minimum(step, c[STEP]), c[STEP]), c[STEP]);
    }
    M touches = magnitude(net[0]) <= (TOUCHES * c[job->role->drive_scale]);
    M jumps = (net[0] > 0.0) & ~touches;
    M at_once = jumps | (touches & (net[1] > 0.0));
    V later = crossing(net, top - 1, c[STEP], broadcast(-1.0), broadcast(0.0), touches, here & ~at_once);
    V at = pick(at_once, broadcast(0.0), later);
    consider(b, here, at, EVENT_START);
    M sooner = at <= c[STEP];
    c[START_DIRECTION] = pick(here, pick(sooner, c[DIRECTION], c[START_DIRECTION]), c[START_DIRECTION]);
    c[SUDDEN] = pick(here, pick(sooner, pick(jumps, broadcast(1.0), broadcast(0.0)), c[SUDDEN]), c[SUDDEN]);
    look_for_quiet(b, here);
    V known = 1.0 * c[STEP];
    c[STEP] = pick(here, minimum(known * (1.0 + TOGETHER), room), c[STEP]);
    find_contact_change(b, here, top);
    c[STEP] = pick(here, pick(c[EVENT] == (double)EVENT_LIFT_OFF, c[STEP], known), c[STEP]);
}

/* Reverse the direction at rest. */
INLINE void turn_back(Batch *b, M here)
{
    V *const c = b->c;
    if (!bits(here)) return;
    c[DIRECTION] = pick(here, -c[DIRECTION], c[DIRECTION]);
    c[PENDING] = pick(here, broadcast(BEGIN_PHASE), c[PENDING]);
}

/* Start slip from rest. */
INLINE void start_again(Batch *b, M here)
{
    V *const c = b->c;
    if (!bits(here)) return;
    face(b, here, c[START_DIRECTION]);
    c[PENDING] = pick(here, broadcast(START_AGAIN), c[PENDING]);
}

/* Advance to the first change: start of slip, change of contact, break or end. */
static void leave_rest(Batch *b, M here, V limit)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    M lifts = c[EVENT] == (double)EVENT_LIFT_OFF;
    M starts = c[EVENT] == (double)EVENT_START;
    M breaks = c[EVENT] == (double)EVENT_LIMIT;
    V until = pick(breaks, limit, c[TIME] + c[STEP]);
    M for_ever = ~starts & ~(until < INFINITY);
    if (job->samples) {
        read_samples(b, here, c[TIME], minimum(until, c[END_TIME]), 0, 0);
    }
    V least = TOGETHER * until;
    M rested = starts & (c[STEP] > least);
    c[STEPS] = pick(here, pick(breaks | rested, broadcast(0.0), c[STEPS] + 1.0), c[STEPS]);
    c[PASSED] = pick(here, broadcast(NOTHING), c[PASSED]);
    M ends = here & (for_ever | (until >= c[END_TIME]));
    c[TIME] = pick(here, pick(for_ever, c[TIME], minimum(until, c[END_TIME])), c[TIME]);
    stay(b, ends, pick(for_ever, broadcast(ARRESTED), broadcast(PAUSED)));
    here = here & ~ends;
    start_again(b, here & starts);
    change_contact(b, here & lifts);
    c[PENDING] = pick(here, pick(lifts, broadcast(BEGIN_PHASE), c[PENDING]), c[PENDING]);
    enter_pieces(b, here & breaks);
}

/* Advance lanes at rest to the next break, or to the start of motion, which is found in the other direction too. */
static void rest_to_change(Batch *b, M here, V limit, V room)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    M both = here & (c[ONE_WAY] == 0.0);
    if (bits(both)) {
        turn_back(b, both);
        begin_phases(b);
        look_ahead(b, both, c[STEP]);
    }
    for (int t = 0; t < job->tables; t++) {
        if (job->table[t].kind == OF_TIME) {
            c[job->table[t].cell + INC] = pick(here, c[job->table[t].cell + INC] + rise_of_step(b, t), c[job->table[t].cell + INC]);
        }
    }
    M reaches = (c[EVENT] == (double)EVENT_NONE) & (c[STEP] >= room);
    c[EVENT] = pick(here, pick(reaches, broadcast(EVENT_LIMIT), c[EVENT]), c[EVENT]);
    leave_rest(b, here, limit);
}

/* Advance lanes at rest under changing forces to the next break, or to the start of motion. */
static void rest_on(Batch *b, M here)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    V limit = next_break(b);
    V room = pick(limit < INFINITY, limit - c[TIME], broadcast(1.0));
    c[EVENT] = pick(here, broadcast(EVENT_NONE), c[EVENT]);
    c[QUIET_FROM] = pick(here, broadcast(-INFINITY), c[QUIET_FROM]);
    c[QUIET_TO] = pick(here, broadcast(INFINITY), c[QUIET_TO]);
    look_ahead(b, here, room);
    M later = (M){0};
    for (int t = 0; t < job->tables; t++) {
        int alone = (job->autonomous == 2) && (job->timed == 1);
        int linear = !job->samples && !(job->notes_room > 0) && (job->data[t].terms == 2);
        if ((alone || (job->role->net_record >= 0)) && linear && (job->table[t].kind == OF_TIME) && !job->data[t].sine) {
            M down_slope = here & (c[ONE_WAY] > 0.0) & (c[DIRECTION] > 0.0) & (c[LIFTED] == 0.0);
            if (job->role->net_record >= 0) {
                turn_through(b, down_slope, t);
            }
            if (!(job->role->net_record >= 0)) {
                later = slide_together(b, down_slope, t);
            }
        }
    }
    M stays = here & (c[STATUS] == (double)RESTING) & (c[PENDING] == (double)READY);
    rest_to_change(b, stays & ~later, limit, room);
}

/* Stop lanes with too many steps since they last rested or passed a break, too many turns, or overflow. */
INLINE void stop_endless(Batch *b, M here)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    M going = c[STATUS] <= (double)RESTING;
    V most = pick(c[OMEGA] > 0.0, broadcast(MOST_STEPS), broadcast((double)(2 * MOST_STEPS)));
    M too_long = c[STEPS] > most;
    if (!job->timed) {
        too_long = too_long | (c[TURNS] > (double)MOST_TURNS);
    }
    V total = ((c[TIME] + c[X]) + c[OMEGA]) + c[ROTATION];
    M overflows = going & ((total - total) != 0.0);
    c[STATUS] = pick(here, pick(going & too_long, broadcast(TOO_LONG), c[STATUS]), c[STATUS]);
    c[STATUS] = pick(here, pick(overflows, broadcast(FAILED), c[STATUS]), c[STATUS]);
}

/* Complete phases in closed form, and make one step of the other moving lanes or of the lanes at rest. The cost of
 * a step does not depend on the number of lanes, so that the minority waits until it is the majority. */
static void advance(Batch *b, M here)
{
    const Job *const job = b->job;
    V *const c = b->c;
    if (!bits(here)) return;
    M moving = here & (c[STATUS] == (double)MOVING);
    M resting = here & (c[STATUS] == (double)RESTING);
    int complete = HAS_CLOSED_FORM(job->role) && !(job->samples && SOFTENS(job->role));
    for (int t = 0; t < job->tables; t++) {
        complete = complete && (job->table[t].kind != OF_SLIP) && (job->table[t].kind != OF_TIME);
    }
    if (complete) {
        moving = moving & ~swing(b, moving);
    }
    if (job->by_rotation && !job->samples) {
        M turning = moving & (c[CLOCKED] == 0.0);
        if (has_recurrence(b)) {
            turning = turning & (c[X] == 0.0);
        }
        turn_on(b, turning);
        moving = moving & ~(turning & (c[CLOCKED] == 0.0));
    }
    if (__builtin_popcount(bits(moving)) > __builtin_popcount(bits(resting))) {
        make_step(b, moving);
    }
    if (__builtin_popcount(bits(resting)) >= __builtin_popcount(bits(moving))) {
        rest_on(b, resting);
    }
    begin_phases(b);
    stop_endless(b, here);
}
/* --- the queue --- */

static int is_shared(const Job *job, int i) { return job->shared && !isnan(job->shared[i]); }

/* The cell with which a lane starts. */
static double at_start(const Job *job, int i, int64_t column)
{
    return is_shared(job, i) ? job->shared[i] : job->all[i * job->count + column];
}

/* A lane at its start has no numbers of a phase yet. */
static void load_lane(Batch *b, unsigned k, int64_t column)
{
    const Job *const job = b->job;
    V *const c = b->c;
    const double *from = job->all + column;
    const int starts = from[STATUS * job->count] == START;
    for (int i = 0; starts && i < job->made; i++) c[i][k] = at_start(job, i, column);
    for (int i = 0; !starts && i < job->cells; i++, from += job->count) c[i][k] = *from;
    b->begun.changed |= !starts;
    b->column[k] = column, b->held |= 1u << k;
    if (c[STATUS][k] == START) start(b, lanes(1u << k));
}

/* What the lanes share that begin side by side: see `Begun`. Cells that follow from cells of their own are their own too,
 * as the direction from a velocity. Where there are tables, all are. */
static void find_begun(Batch *b, int64_t first)
{
    const Job *const job = b->job;
    if (!job->begun || job->tables || job->end - first < 2 * LANES) return;
    V *const shared = job->begun, *const c = b->c;
    int32_t *const own = (int32_t *)(shared + job->cells), *own_end = own;
    for (int i = 0; i < job->made; i++) {
        c[i] = broadcast(at_start(job, i, first));
        if (!is_shared(job, i)) *own_end++ = i;
    }
    const V velocity = c[OMEGA];
    start(b, lanes(ALL));
    prologue(b, lanes(ALL));
    memcpy(shared, c, job->cells * sizeof(V));
    shared[OMEGA] = velocity; /* with its sign, from which `start` has the direction */
    memset(job->memory, 0, MOST_WORKING * sizeof(V)); /* lanes that are resumed are ready for a step */
    int32_t *end = own_end;
    unsigned char *const differs = (unsigned char *)(own_end + (job->scalar_end - job->scalar));
    memset(differs, 0, job->cells);
    for (const int32_t *of = own; of < own_end; of++) differs[*of] = 1;
    differs[DIRECTION] |= differs[OMEGA];
    for (const int32_t *at = job->scalar, *next; at < job->scalar_end; at = next) {
        next = at + 2 + arguments[at[0]];
        for (const int32_t *from = at + 2; from < next; from++) differs[at[1]] |= differs[*from];
        if (!differs[at[1]]) continue;
        memcpy(end, at, (next - at) * sizeof *at);
        end += next - at;
    }
    b->begun = (Begun){shared, own, own_end, end, 0};
}

/* Neighbours that have not begun take all lanes at once. */
static int load_neighbours(Batch *b, int64_t first)
{
    const Job *const job = b->job;
    const Begun *const begun = &b->begun;
    if (b->held || job->end - first < LANES) return 0;
    for (int k = 0; k < LANES; k++) if (job->all[STATUS * job->count + first + k] != START) return 0;
    const double *const from = job->all + first;
    if (begun->shared) {
        memcpy(b->c, begun->shared, (begun->changed ? job->cells : job->made) * sizeof(V));
        for (const int32_t *i = begun->own; i < begun->own_end; i++) {
            memcpy(b->c + *i, from + *i * job->count, sizeof(V));
            __builtin_prefetch(from + *i * job->count + LANES); /* for the next neighbours */
        }
        b->scalar = begun->own_end, b->scalar_end = begun->scalar_end, b->begun.changed = 0;
    } else for (int i = 0; i < job->made; i++) {
        if (is_shared(job, i)) b->c[i] = broadcast(job->shared[i]);
        else memcpy(b->c + i, from + i * job->count, sizeof(V));
    }
    for (int k = 0; k < LANES; k++) b->column[k] = first + k;
    const double *to = from + LANES - 1; /* fetched while the lanes move, for their results */
    for (int i = 0; i < OMEGA - 1 + job->states; i++, to += job->count) __builtin_prefetch(to, 1);
    start(b, lanes(ALL));
    b->held = ALL;
    return 1;
}

/* Neighbours that have come to rest leave at once. */
static int store_neighbours(Batch *b, unsigned ended)
{
    const Job *const job = b->job;
    for (int k = 0; k < LANES; k++) if (b->column[k] != b->column[0] + k) return 0;
    if (ended != ALL || !all_lanes(b->c[STATUS] == (double)ARRESTED)) return 0;
    double *to = job->all + b->column[0];
    for (int i = 0; i < OMEGA - 1 + job->states; i++, to += job->count) memcpy(to, b->c + i, sizeof(V));
    b->held = 0;
    return 1;
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
        }
        if (job->budget) begin_here(b, lanes((1u << count) - 1));
        if (job->budget) prologue(b, lanes(ALL));
        evaluate(b);
        for (int64_t k = 0; k < count; k++) {
            for (int i = 0; job->budget && i < job->cells; i++) job->all[i * job->count + first + k] = b->c[i][k];
            for (int i = 0; i < job->registers; i++) job->outputs[i * job->count + first + k] = REGISTER(i * STRIDE)[0][k];
        }
    }
}

/* Where so many lanes are free, or as many as wait, the next of the queue take them. */
enum { LEAST_FREE = LANES / 2 };

static __attribute__((noinline)) int64_t integrate_queue(Job *job)
{
    V *const memory = (V *)job->memory + MOST_WORKING;
    Batch batch = {.job = job, .c = memory, .r = memory + job->cells, .scalar = job->scalar, .scalar_end = job->scalar_end}, *const b = &batch;
    V *const c = b->c;
    int64_t next = job->begin;
    memset(job->memory, 0, (size_t)(MOST_WORKING + job->cells) * sizeof(V));
    for (const Table *t = job->table; t < job->table + job->tables; t++)
        if (t->reg >= 0) memset(b->r + t->reg, 0, STRIDE * sizeof(V)); /* most of their coefficients stay zero */
    for (int n = 1; n < STRIDE; n++) b->inverse[n] = 1.0 / n;
    if (job->outputs && !job->times) {
        read_registers(b);
        return 0;
    }
    for (int64_t k = job->begin; k < job->end; k++) {
        const double order = at_start(job, ORDER, k);
        if (!(order >= 5.0 && order <= HIGHEST)) return -1;
        job->order = order > job->order ? (int)order : job->order;
    }
    for (int i = job->made; i < job->cells; i++) c[i] = broadcast(at_start(job, i, 0));
    find_begun(b, next);
    /* Motions under a record whose series end early begin side by side. */
    const int least_free = job->autonomous == 2 && job->timed ? LANES : LEAST_FREE;
    for (int64_t round = 0;; round++) {
        const int vacant = LANES - __builtin_popcount(b->held);
        if (round < job->budget && load_neighbours(b, next)) next += LANES;
        else if (round < job->budget && (vacant >= least_free || vacant >= job->end - next))
            EACH(k, ~b->held & ALL) {
                while (next < job->end && !is_active(job, next)) next++;
                if (next == job->end) break;
                load_lane(b, k, next++);
            }
        begin_phases(b);
        if (round >= job->budget || !b->held || (job->notes_room && job->notes_room - job->noted < LANES)) break;
        advance(b, lanes(b->held));
        const unsigned ended = b->held & ~bits(c[STATUS] <= (double)RESTING);
        if (!store_neighbours(b, ended)) EACH(k, ended) store_lane(b, k);
    }
    int64_t left = 0;
    EACH(k, b->held) store_lane(b, k), left++;
    return left + (job->end - next);
}

/* Numbers below 2^-1022 are zero meanwhile: friction that softens comes to them, and each product of one takes x86 a
 * hundred cycles. */
int64_t NAMED(flow_integrate, LEVEL)(Job *job);
int64_t NAMED(flow_integrate, LEVEL)(Job *job)
{
#ifdef __SSE2__
    enum { FLUSH_RESULTS = 0x8000, FLUSH_OPERANDS = 0x40 };
    const unsigned mode = _mm_getcsr();
    _mm_setcsr(mode | FLUSH_RESULTS | FLUSH_OPERANDS);
#endif
    const int64_t left = integrate_queue(job);
#ifdef __SSE2__
    _mm_setcsr(mode);
#endif
    return left;
}

#ifdef __wasm__
/* --- the module of a browser: what `integrate` of the Python module takes, by addresses ------------------------------ */

#include <stdlib.h>

/* A table: addresses of its breaks, coefficients and jumps, pieces, terms, lanes across and apart, sine, open. */
typedef struct { const double *breaks, *coefficients, *jumps; int32_t pieces, terms, across, apart, sine, open; } Given;

/* Lanes that have not ended, or -1 where the program, an order and what it is given do not fit. */
__attribute__((export_name("integrate"))) int integrate(const int32_t *program, int length, const Given *tables, double *cells,
    int count, int begin, int end, int budget, const double *times, int samples, int across, double *outputs)
{
    Job job = {.all = cells, .count = count, .begin = begin, .end = end, .budget = budget,
               .times = samples ? times : NULL, .samples = samples, .times_across = across, .outputs = outputs};
    if (read_program(&job, program, program + length)) return -1;
    for (int t = 0; t < job.tables; t++) {
        const Given *const g = tables + t;
        job.data[t] = (Data){g->breaks, g->coefficients, g->jumps, g->pieces, g->across, g->apart, g->terms, g->sine, g->open};
    }
    void *const memory = malloc((size_t)(MOST_WORKING + job.cells + job.registers * STRIDE + 1) * WIDEST);
    if (memory == NULL) return -1;
    job.memory = (void *)(((uintptr_t)memory + WIDEST - 1) & ~(uintptr_t)(WIDEST - 1));
    const int left = (int)flow_integrate_wasm(&job);
    free(memory);
    return left;
}
__attribute__((export_name("room"))) void *room(int bytes) { return malloc((size_t)bytes); }
__attribute__((export_name("leave"))) void leave(void *room) { free(room); }
#endif
#endif
