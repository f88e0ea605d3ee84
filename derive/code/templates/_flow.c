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

enum { @SIZES@, CELL = -2, MOST_TABLES = 16, MOST_STATES = 16, MOST_WORKING = 24 };

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
@ROLES@
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

@CODES@
/* How many cells an operation on cells reads. */
static const unsigned char arguments[] = { @ARGUMENTS@ };
#if !defined(LEVEL) || defined(__wasm__)
#ifndef __wasm__
/* Programs with functions of their own: their operations on series and their states, CELL where any cell may be, and where
 * the operations that rates need, all operations, and the states end. */
static const struct { int rates, later, length; const int32_t *operations; } patterns[] = {
@PATTERNS@
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

@CELLS@
#if defined(__x86_64__)
#define LEVELS(X) X(avx512) X(avx2) X(baseline)
@PROCESSOR@
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
static const unsigned char named[] = { @REGISTERS@ };

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

@CELLS@
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
@SERIES@
    default:
        __builtin_unreachable();
    }
}

/* The operations on cells of a prologue, to their end, in some of the lanes: each its code, result and arguments. Each
 * operation jumps to the next one itself, so that the processor predicts where it leads. */
static void IN(prologue)(const int32_t *at, const int32_t *end, V *c, M here)
{
    static const void *const codes[] = { @LABELS@ };
    V a, *d;
#define NEXT do { if (at >= end) return; a = c[at[2]], d = c + at[1]; goto *codes[at[0]]; } while (0)
    NEXT;
@CELL_OPERATIONS@
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
@STRAIGHT@
static const struct { void (*orders)(ORDERS); void (*later)(LATER); } straight[] = {
@STRAIGHT_ROWS@
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

@INTEGRATOR@
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
