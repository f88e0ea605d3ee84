'use strict';
// Integrator in a browser: `generated/flow.wasm.txt`, and the inputs of a scene as functions of its sliders.
// The mechanics is elsewhere: the page supplies programs, tables and inputs, the integrator solves the motions.

// Decompress base64 data of the page into bytes.
async function unpacked(text) {
  const packed = Uint8Array.from(atob(text.trim()), (letter) => letter.charCodeAt(0));
  const stream = new ReadableStream({ start(to) { to.enqueue(packed); to.close(); } });
  return new Response(stream.pipeThrough(new DecompressionStream('gzip'))).arrayBuffer();
}

// Return the exports of the integrator in the page; null if this browser cannot run it.
async function engine() {
  const held = document.getElementById('slide-engine');
  if (!held || typeof WebAssembly !== 'object' || typeof DecompressionStream !== 'function') return null;
  const none = new Proxy({}, { get: () => () => 0 });
  const { instance } = await WebAssembly.instantiate(await unpacked(held.textContent), { wasi_snapshot_preview1: none, env: none });
  if (instance.exports._initialize) instance.exports._initialize();
  return instance.exports;
}

// Return a solver of the scene for places of its sliders, each from -1 to 1.
function solverOf(model, x) {
  const BUDGET = 1e6, CALLS = 20; // steps of a call, and greatest number of calls for a motion
  const held = [];
  const numbers = (at, count) => new Float64Array(x.memory.buffer, at, count);
  const room = (bytes) => { const at = x.room(Math.max(bytes, 8)); held.push(at); return at; };
  const put = (values) => { const at = room(8 * values.length); numbers(at, values.length).set(values); return at; };
  const integers = (values, at) => { new Int32Array(x.memory.buffer, at, values.length).set(values); return at; };
  const codes = model.programs.map((p) => integers(p.code, x.room(4 * p.code.length)));
  const base = Float64Array.from(model.base, Number);
  const fits = model.fits.map(([of, degrees, rows, ...numbers]) => [of, degrees, rows, ...numbers.map((x) => Float64Array.from(x, Number))]);
  const jumps = model.tables.map((t) => Float64Array.from(t.jumps, Number));
  const first = model.names.length; // rows of the tables follow, then rows of other numbers
  const beyond = model.tables.reduce((at, t) => at + t.pieces * (1 + t.terms), first);

  // Return all inputs: sums of Chebyshev polynomials in the places of the sliders.
  function inputs(places) {
    const rows = base.slice();
    for (const [of, degrees, some, weights, c] of fits) {
      let products = [1];
      of.forEach((k, i) => {
        const powers = [1, places[k]];
        for (let n = 2; n <= degrees[i]; n += 1) powers.push(2 * places[k] * powers[n - 1] - powers[n - 2]);
        powers.length = degrees[i] + 1;
        products = products.flatMap((product) => powers.map((power) => product * power));
      });
      const width = products.length, count = c.length / width;
      const parts = Array.from({ length: count }, (_, i) => products.reduce((sum, x, n) => sum + x * c[i * width + n], 0));
      some.forEach((row, j) => { rows[row] = parts.reduce((sum, part, i) => sum + part * weights[j * count + i], 0); });
    }
    const [whole, part] = model.divisor;
    for (const row of model.divided) rows[row] /= rows[whole] - rows[part];
    if (model.start) begin(rows, model.start);
    return rows;
  }

  // Solve F times driving moment = sum of series in friction over F; scale rows by F relative to the closure's factor.
  function begin(rows, { at, low, high, degree, scaled, factor }) {
    const [whole, other] = rows.subarray(at, at + 2), first = at + 2 + low.length;
    let root = 1;
    for (let last = 0, n = 0; n < 200 && Math.abs(root - last) > 1e-15 * root; n += 1) {
      last = root;
      root = low.reduce((sum, from, k) => {
        const x = 2 * (rows[at + 2 + k] / last - from) / (high[k] - from) - 1, series = first + k * (degree + 1);
        let next = 0, value = 0;
        for (let j = degree; j > 0; j -= 1) [value, next] = [rows[series + j] + 2 * x * value - next, value];
        return sum + rows[series] + x * value - next;
      }, 0) / whole;
    }
    for (const row of scaled) rows[row] *= root * whole / other;
    rows[factor] = root;
  }

  function tables(rows) {
    let at = first;
    const next = (count) => { const some = rows.subarray(at, at + count); at += count; return put(some); };
    const given = model.tables.flatMap((t, k) => {
      const places = [next(t.pieces), next(t.pieces * t.terms), put(jumps[k])];
      return [...places, t.pieces, t.terms, 0, 0, Number(t.sine), Number(t.open)];
    });
    return integers(given, room(4 * given.length));
  }

  // Return cells of lanes with the inputs of a scene; each lane may change some inputs by a factor.
  function cellsOf(program, rows, factors, lanes) {
    const cells = new Float64Array(program.cells * lanes);
    program.places.forEach((place, row) => {
      for (let k = 0; place >= 0 && k < lanes; k += 1) {
        cells[place * lanes + k] = rows[row] * (factors[row] ? factors[row][k] : 1);
      }
    });
    return cells;
  }

  // Return output registers by name in states of a motion where phases begin.
  function registers(rows, states, times) {
    const program = model.programs[1], lanes = times.length, cells = cellsOf(program, rows, {}, lanes);
    const fill = (place, values) => { values.forEach((value, k) => { cells[place * lanes + k] = value; }); };
    const row = (k) => states.subarray(k * lanes, (k + 1) * lanes);
    const { TIME, ROTATION, omega, DIRECTION, LIFTED, SLIP } = model.entries;
    fill(TIME, times);
    fill(ROTATION, row(0));
    fill(omega, row(1).map(Math.abs));
    fill(DIRECTION, row(1).map((value) => (value < 0 ? -1 : 1)));
    fill(LIFTED, times.map(() => 0));
    fill(SLIP, row(3));
    Object.values(program.states).forEach((place, k) => fill(place, row(4 + k)));
    const of = put(cells), given = tables(rows), out = room(8 * lanes * program.registers);
    x.integrate(codes[1], program.code.length, given, of, lanes, 0, lanes, 1, 0, 0, 1, out);
    const found = {}, values = numbers(out, lanes * program.registers).slice();
    for (const [name, place] of Object.entries(program.outputs)) found[name] = values.subarray(place * lanes, (place + 1) * lanes);
    while (held.length) x.leave(held.pop());
    return found;
  }

  // Return final cells of lanes and states at times. Lanes that turn back too often end at their first standstill.
  function integrate(which, rows, factors, lanes, times) {
    const found = solved(which, rows, factors, lanes, times, []);
    const of = (name, k) => entry(found.final, name, k, lanes), { TOO_LONG, MOST_TURNS } = model.codes;
    const swings = Array.from({ length: lanes }, (_, k) => (
      of('STATUS', k) === TOO_LONG && of('TURNS', k) > MOST_TURNS && of('END_TIME', k) === Infinity));
    return swings.includes(true) ? solved(which, rows, factors, lanes, times, swings) : found;
  }

  // Return final cells of lanes, (cells, lanes), and states at the given times, if any, (rows, times).
  function solved(which, rows, factors, lanes, times, ending) {
    const program = model.programs[which], cells = cellsOf(program, rows, factors, lanes);
    ending.forEach((one, k) => { if (one) cells[model.entries.FIRST_ONLY * lanes + k] = 1; });
    const orders = cells.subarray(model.entries.ORDER * lanes, (model.entries.ORDER + 1) * lanes);
    orders.forEach((order, k) => { orders[k] = Math.round(order); });
    const count = times.length, height = 4 + Object.keys(program.states).length;
    const of = put(cells), given = tables(rows), at = put(times), out = room(8 * count * height);
    let left = 1;
    for (let calls = 0; left > 0 && calls < CALLS; calls += 1) {
      left = x.integrate(codes[which], program.code.length, given, of, lanes, 0, lanes, BUDGET,
        count ? at : 0, count, 1, count ? out : 0);
    }
    const final = numbers(of, cells.length).slice(), states = numbers(out, count * height).slice();
    while (held.length) x.leave(held.pop());
    if (left !== 0) throw new Error('the motion takes more steps than a page waits for');
    return { final, states };
  }

  const entry = (final, name, lane = 0, lanes = 1) => final[model.entries[name] * lanes + lane];

  // Return duration, run-out and greatest speed of a lane, dimensionless.
  function outcomes(final, lane = 0, lanes = 1) {
    const of = (name) => entry(final, name, lane, lanes), ended = of('STATUS') === model.codes.ENDED;
    const timed = ended && of('TIME') < Infinity;
    return [timed ? of('END_TIME') : of('REST_SINCE'), of('REACH_ROTATION'), Math.abs(of('PEAK_OMEGA'))];
  }

  function status(final) {
    const ended = entry(final, 'STATUS');
    let name = model.statuses[model.of_end[ended]][0];
    const answered = () => ['RESTS', 'STAYS', 'MOVING', 'TURNED', 'CREEPS'].includes(name);
    if (name === 'RESTS' && entry(final, 'TURNS') > 0) name = 'TURNED';
    if (entry(final, 'TIME') === Infinity) name = 'CREEPS';
    if (answered() && entry(final, 'PHASES') === 0 && ended !== model.codes.STOPPED) name = 'STAYS';
    const [, words, reason] = model.statuses.find((row) => row[0] === name);
    return { answered: answered(), name, words, reason };
  }

  function unitsOf(rows) {
    const units = {};
    model.others.forEach((name, k) => { units[name] = rows[beyond + k]; });
    return units;
  }

  // Return run-out, peak velocity and duration only; an empty object without a result.
  function outline(places) {
    const rows = inputs(places), { final } = integrate(0, rows, {}, 1, []), units = unitsOf(rows);
    if (!status(final).answered) return {};
    const [duration, rotation, omega] = outcomes(final);
    return { run_out: units.m * rotation, peak_velocity: units['m/s'] * omega, duration: units.s * duration };
  }

  // Return a motion with its states at equidistant times, and its estimated error.
  function motion(places, samples) {
    const rows = inputs(places), units = unitsOf(rows), { final } = integrate(0, rows, {}, 1, []);
    const [duration, rotation, omega] = outcomes(final), end = status(final);
    const found = { end, moves: end.answered && entry(final, 'PHASES') > 0, factor: units.factor_of_safety };
    if (!end.answered) return found;
    const last = Number.isFinite(duration) ? duration : entry(final, 'REST_SINCE');
    const times = Float64Array.from({ length: samples }, (_, k) => last * k / (samples - 1));
    const { states } = integrate(1, rows, {}, 1, times);
    const row = (k, unit) => Array.from(states.subarray(k * samples, (k + 1) * samples), (value) => unit * value);
    const { count, factors } = model.runs, all = integrate(0, rows, factors, count, []).final;
    const sizes = outcomes(all, 0, count).map((size) => Math.max(Math.abs(size), 1e-300));
    let spread = 0;
    for (let k = 1; k < count; k += 1) {
      outcomes(all, k, count).forEach((value, i) => {
        const change = Math.abs(value - outcomes(all, 0, count)[i]) / sizes[i];
        if (change > spread) spread = change;
      });
    }
    const further = Object.keys(model.programs[1].states);
    const energy = (name) => (further.includes(name) ? row(4 + further.indexOf(name), units.J) : null);
    return {
      ...found,
      duration: units.s * last,
      lift: units.s * entry(final, 'LIFT_TIME'),
      run_out: units.m * rotation,
      run_out_time: units.s * entry(final, 'REACH_TIME'),
      end_displacement: units.m * entry(final, 'END_ROTATION'),
      peak_velocity: units['m/s'] * omega,
      error: Math.min(Math.max(model.rounded * spread, 9e-16), 1),
      t: Array.from(times, (time) => units.s * time),
      rotation: row(0, 1),
      s: row(0, units.m),
      v: row(1, units['m/s']),
      a: row(2, units['m/s^2']),
      work: energy('work'),
      dissipation: energy('dissipation'),
      ...stresses(registers(rows, states, times), units.Pa),
    };
  }

  // Return total and effective mean normal stress.
  function stresses({ pressing, normal }, unit) {
    const of = (force) => Array.from(force, (value) => unit * value);
    return model.stresses ? { total: of(pressing), effective: of(normal) } : {};
  }

  return { motion, outline };
}
