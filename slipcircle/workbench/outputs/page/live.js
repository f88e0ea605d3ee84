// Slide of a page. Its state is the time and the places of the sliders: every view is drawn from them, and the address
// stores them. When a slider moves, the engine solves the scene again.

const SVG = 'http://www.w3.org/2000/svg';
const SAMPLES = 401; // samples of a motion
const STEPS = 100; // key presses from the start to the end
const SHORTEST = 4, LONGEST = 10; // seconds of the animation
const ACROSS = 200; // number of motions of the curve over a number
const FRAME = 6; // milliseconds of each frame for this curve
const CHARTS = {
  v: { title: 'velocity (m/s)', across: 't' },
  s: { title: 'displacement (m)', across: 't' },
  plane: { title: 'velocity (m/s) over displacement (m)', across: 's' },
  stress: { title: 'mean normal stress (Pa)', across: 't' },
  energy: { title: 'energy, of the work', across: 't' },
  run_out: { title: 'run-out (m)', across: 'number' },
  peak_velocity: { title: 'peak velocity (m/s)', across: 'number' },
  duration: { title: 'duration (s)', across: 'number' },
};

const slides = document.querySelectorAll('.slide');
const loaded = slides.length ? engine().catch(() => null) : Promise.resolve(null);
for (const figure of slides) {
  try {
    start(figure, slides.length === 1);
  } catch (fault) {
    figure.prepend(made('p', `This page is damaged, or the browser is too old for it: ${fault.message}`));
  }
}

function start(figure, addressed) {
  const find = (selector) => figure.querySelector(selector);
  const data = JSON.parse(find('script').textContent);
  const given = { ...data.stored, ...data.first }; // the solved motion, computed when the page was written
  given.cut = given.left ? given.t.findIndex((t) => t >= given.left) : null;
  const sliders = data.sliders.map((slider) => ({ ...slider, now: slider.value }));
  const slider = find('.at input'), button = find('.play'), shape = find('.shape');
  const mass = find('.mass'), ghost = mass.querySelector('.edge').cloneNode();
  const charts = [...figure.querySelectorAll('.chart')].map((svg) => ({ svg, of: svg.dataset.of, ...CHARTS[svg.dataset.of] }));
  let solver = null, motion = given, playing = 0, hovered = null, queued = 0, dragged = null, across = null;
  let time = given.duration || 0;

  ghost.setAttribute('class', 'given');
  mass.after(ghost);
  controls();
  read();
  layout();
  loaded.then(async (exports) => {
    if (!data.model) return;
    if (!exports) {
      find('.warnings').append(made('li', 'this browser cannot run the engine (WebAssembly); the page plays the scene as it was given'));
      return;
    }
    solver = solverOf(JSON.parse(new TextDecoder().decode(await unpacked(data.model))), exports);
    figure.classList.add('solves');
    dragged = sliders[0] || null;
    solve();
    layout();
    curve();
  });

  // Name of the unit of output for an SI unit, and a title with these names.
  function named(unit) {
    return (data.units[unit] || [unit])[0];
  }

  function titled(words) {
    return words.replace(/\((.+?)\)/g, (_, unit) => `(${named(unit)})`);
  }

  // --- the motion ---

  // Place of a slider in its range, from -1 to 1; a coefficient of friction is shown as an angle.
  function place({ si: [low, high], tangent, per_unit: per }, value) {
    const inside = tangent ? Math.tan(value * Math.PI / 180) : value * per;
    return Math.min(Math.max((2 * inside - low - high) / (high - low), -1), 1);
  }

  function solve() {
    if (!solver) return;
    const asGiven = sliders.every((one) => one.now === one.value);
    try {
      const found = solver.motion(sliders.map((one) => place(one, one.now)), SAMPLES);
      motion = described(found, asGiven);
    } catch (fault) {
      motion = { ...stopped(fault.message) };
    }
    if (time > longest() || !playing) time = Math.min(time, longest());
  }

  function stopped(words) {
    return { t: [0], s: [0], v: [0], duration: 0, headline: `no result: ${words}`, end: 'no result', facts: [], warnings: [] };
  }

  function described(found, asGiven) {
    const { end } = found;
    if (!end.answered) return stopped(end.reason || end.words);
    const still = { t: [0], s: [0], v: [0], duration: 0 };
    const text = (value, unit) => `${Number(value.toPrecision(4))} ${named(unit)}`;
    const swingsBack = found.moves && Math.abs(found.run_out - found.end_displacement) > 1e-6 * Math.abs(found.run_out);
    const facts = found.moves
      ? [['run-out along the arc', text(found.run_out, 'm') + verdict('run_out', found.run_out)],
        ['peak velocity', text(found.peak_velocity, 'm/s') + verdict('peak_velocity', found.peak_velocity)],
        ['duration', text(found.duration, 's') + verdict('duration', found.duration)]]
      : [];
    if (swingsBack) facts.push(['displacement at the end', text(found.end_displacement, 'm') + verdict('end_displacement', found.end_displacement)]);
    const left = found.moves ? departure(found) : { cut: null };
    if (left.words) facts.push(['outside the range of the method', left.words]);
    facts.push(['factor of safety at the start', String(Number(found.factor.toPrecision(4)))]);
    if (found.moves) facts.push(['estimated error', found.error.toExponential(1)]);
    if (data.input_error > 1e-14) facts.push(['inputs interpolated within', data.input_error.toExponential(0)]);
    const warnings = found.moves && Number.isFinite(found.lift) ? [`contact lost from ${text(found.lift, 's')} (lift-off)`] : [];
    if (left.words) warnings.push(`outside the range of the method ${left.words}`);
    const [time, last] = swingsBack ? [found.run_out_time, `swings back to ${text(found.end_displacement, 'm')}`] : [found.duration, end.words];
    const headline = found.moves ? `${text(found.run_out, 'm')} in ${text(time, 's')}, ${last}` : end.words;
    return {
      ...(found.moves ? found : still),
      cut: left.cut,
      ...(asGiven ? { headline: given.headline, end: given.end, warnings: given.warnings } : { headline, end: end.words, warnings }),
      facts,
    };
  }

  // Return the first sample outside the range of the method, and when and where the mass leaves the range, in words.
  function departure({ rotation, t, s }) {
    const [upslope, downslope] = data.range, cut = rotation.findIndex((phi) => phi > downslope || phi < upslope);
    if (cut < 1) return { cut: null };
    const [before, after] = rotation.slice(cut - 1, cut + 1), bound = after > 0 ? downslope : upslope;
    const between = (column) => column[cut - 1] + (column[cut] - column[cut - 1]) * (bound - before) / (after - before);
    const [time, way] = [t, s].map((column) => Number(between(column).toPrecision(3)));
    return { cut, words: `after ${time} s, ${way} ${named('m')}` };
  }

  function verdict(name, value) {
    const seen = data.observed[name];
    if (!Array.isArray(seen)) return '';
    return value >= seen[0] && value <= seen[1] ? ' (as observed)' : ` (observed ${seen[0]} to ${seen[1]})`;
  }

  function longest() {
    return Math.max(motion.duration, given.duration, 0);
  }

  // Compute the curve over the dragged number, a few motions in each frame.
  function curve() {
    cancelAnimationFrame(queued);
    if (!solver || !dragged) return;
    const one = dragged, places = sliders.map((other) => place(other, other.now)), k = sliders.indexOf(one);
    across = { number: [], run_out: [], peak_velocity: [], duration: [] };
    const more = () => {
      const begin = performance.now();
      while (across.number.length < ACROSS && performance.now() - begin < FRAME) {
        const value = one.low + (one.high - one.low) * across.number.length / (ACROSS - 1);
        places[k] = place(one, value);
        let found = {};
        try { found = solver.outline(places); } catch { /* a gap */ }
        across.number.push(value);
        for (const name of ['run_out', 'peak_velocity', 'duration']) across[name].push(name in found ? found[name] : NaN);
      }
      charts.filter((chart) => chart.across === 'number').forEach(draw);
      if (across.number.length < ACROSS) queued = requestAnimationFrame(more);
    };
    queued = requestAnimationFrame(more);
  }

  // --- views ---

  function show() {
    const now = at(motion, time), before = at(given, time);
    const { centre: [x, y], turn } = data.shape;
    mass.setAttribute('transform', `rotate(${turn * now.s} ${x} ${y})`);
    ghost.setAttribute('transform', `rotate(${turn * before.s} ${x} ${y})`);
    shape.setAttribute('transform', shaped(x, y));
    put('.time', time, longest());
    put('.velocity', now.v, spread(motion.v));
    put('.displacement', now.s, spread(motion.s));
    find('.state').textContent = state();
    find('.headline').textContent = motion.headline;
    slider.max = String(longest());
    slider.value = time;
    slider.setAttribute('aria-valuetext', `${text(time, longest())} s`);
    find('.facts').replaceChildren(...motion.facts.map(([name, value]) => made('div', made('dt', name), made('dd', value))));
    if (solver) find('.warnings').replaceChildren(...motion.warnings.map((words) => made('li', words)));
    figure.classList.toggle('still', longest() === 0);
    charts.forEach(move);
  }

  // An arc with a different radius or dip gives the same picture, scaled or turned.
  function shaped(x, y) {
    const change = (name) => sliders.find((one) => one.name === name) || { now: 0, value: 0 };
    const size = change('radius'), dip = change('dip');
    const scale = size.value ? size.now / size.value : 1, turned = Math.sign(data.shape.turn) * (dip.value - dip.now);
    return `translate(${x} ${y}) rotate(${turned}) scale(${scale}) translate(${-x} ${-y})`;
  }

  function state() {
    if (playing) return data.pace;
    if (time > 0 && time >= motion.duration) return motion.end;
    return time > 0 ? '' : 'at the start';
  }

  function put(selector, value, size) {
    const element = find(selector);
    element.value = String(value);
    element.textContent = text(value, size);
  }

  function controls() {
    const list = find('.numbers');
    sliders.forEach((one) => {
      one.input = made('input');
      Object.assign(one.input, { type: 'range', min: one.low, max: one.high, step: 'any' });
      one.output = made('output');
      const label = made('label', `${one.label}${one.unit ? ` (${one.unit})` : ''} `, one.output, one.input);
      one.input.addEventListener('input', () => { set(one, Number(one.input.value)); });
      one.input.addEventListener('change', write);
      list.append(label);
      set(one, one.value, false);
    });
    find('.reset').addEventListener('click', () => {
      for (const one of sliders) set(one, one.value, false);
      changed();
      write();
    });
    find('.picture').addEventListener('click', picture);
    find('.series').addEventListener('click', series);
  }

  function set(one, value, draws = true) {
    one.now = value;
    one.input.value = value;
    one.output.textContent = String(Number(value.toPrecision(4)));
    one.input.setAttribute('aria-valuetext', `${one.output.textContent} ${one.unit}`);
    if (!draws) return;
    dragged = one;
    changed();
  }

  let waiting = 0;
  function changed() {
    if (waiting) return;
    waiting = requestAnimationFrame(() => { waiting = 0; solve(); charts.forEach(draw); show(); curve(); });
  }

  // --- curves ---

  function layout() {
    const drawing = find('.section');
    const width = drawing.clientWidth || 1000;
    const unit = 1000 / width;
    drawing.style.setProperty('--unit', String(unit));
    names(shape.querySelectorAll('text'), 13 * unit, drawing.viewBox.baseVal.height);
    charts.forEach(draw);
    show();
  }

  function names(texts, size, height) {
    let lowest = size;
    for (const name of texts) {
      const line = Number(name.dataset.line), below = !name.matches('.of-water, .of-surcharge, .of-pond');
      const room = below && line + 1.4 * size < height;
      const y = Math.max(room ? line + 1.15 * size : line - (below ? 1.8 : 0.5) * size, lowest);
      name.setAttribute('y', y);
      name.setAttribute('dy', 0);
      lowest = y + 1.25 * size;
    }
  }

  // Return the columns of a chart, for the motion and for the scene as given.
  function columns({ of, across: over }) {
    const most = Math.max(...(motion.work || [0]).map(Math.abs), 1e-300);
    const shares = (values) => (values || []).map((value) => value / most);
    const kinetic = (motion.work || []).map((work, k) => work - motion.dissipation[k]);
    if (over === 'number') return across ? [[across.number, across[of]]] : [];
    if (of === 'energy') return [shares(motion.work), shares(motion.dissipation), shares(kinetic)].map((c) => [motion.t, c]);
    if (of === 'stress') return [motion.total, motion.effective].map((c) => [motion.t, c || []]);
    const pairs = (one) => (of === 'plane' ? [one.s, one.v] : [one.t, one[of]]);
    return [pairs(motion), pairs(given)];
  }

  function limits(values, ends = []) {
    const all = values.flat().filter(Number.isFinite).concat(ends);
    const low = Math.min(0, ...all), high = Math.max(0, ...all);
    return high > low ? [low, high] : [0, 1];
  }

  function draw(chart) {
    const { svg, of, across: over } = chart, pairs = columns(chart);
    const seen = over === 'number' && Array.isArray(data.observed[of]) ? data.observed[of] : [];
    const number = over === 'number' && dragged;
    svg.toggleAttribute('hidden', (over === 'number' && !number) || (of === 'energy' && !motion.work) || (of === 'stress' && !motion.total));
    const sideways = number ? [dragged.low, dragged.high] : limits(pairs.map(([c]) => c), over === 't' ? [longest()] : []);
    const [low, high] = limits(pairs.map(([, c]) => c), seen);
    const width = Math.max(svg.clientWidth, 240), height = Math.round(Math.min(0.5 * width, 200));
    const box = { left: 48, right: width - 14, top: 24, bottom: height - 34 };
    const x = (value) => box.left + (box.right - box.left) * (value - sideways[0]) / (sideways[1] - sideways[0] || 1);
    const y = (value) => box.bottom - (box.bottom - box.top) * (value - low) / (high - low);
    svg.setAttribute('viewBox', `0 0 ${width} ${height}`);
    const parts = [drawn('text', { class: 'title', x: 0, y: 13 }, titled(chart.title))];
    if (seen.length) parts.push(drawn('rect', { class: 'seen', x: box.left, width: box.right - box.left, y: y(seen[1]), height: y(seen[0]) - y(seen[1]) }));
    for (const value of rounds(low, high, 3)) {
      parts.push(drawn('path', { class: 'grid', d: `M${box.left} ${y(value)}H${box.right}` }));
      parts.push(drawn('text', { x: box.left - 6, y: y(value) + 4, 'text-anchor': 'end' }, plain(value)));
    }
    for (const value of sideways[1] > sideways[0] ? rounds(sideways[0], sideways[1], 5) : []) {
      parts.push(drawn('path', { class: 'grid', d: `M${x(value)} ${box.bottom}v4` }));
      parts.push(drawn('text', { x: x(value), y: box.bottom + 17, 'text-anchor': 'middle' }, plain(value)));
    }
    const words = number ? `${dragged.label}${dragged.unit ? ` (${dragged.unit})` : ''}` : over === 's' ? titled('displacement (m)') : 'time (s)';
    parts.push(drawn('text', { x: box.right, y: height - 3, 'text-anchor': 'end' }, words));
    const kinds = of === 'energy' ? ['work', 'dissipation', 'kinetic'] : of === 'stress' ? ['', 'dissipation'] : ['', 'other'];
    const lines = pairs.flatMap(([a, b], k) => {
      const cut = over === 'number' || kinds[k] === 'other' ? null : motion.cut;
      const parts = cut ? [[0, cut], [cut - 1]] : [[0]];
      return parts.map((part, beyond) => drawn('path', {
        class: `curve ${kinds[k]}${beyond ? ' beyond' : ''}`, d: line(a.slice(...part), b.slice(...part), x, y),
      }));
    });
    chart.cursor = drawn('path', { class: 'cursor' });
    chart.hover = drawn('path', { class: 'hover' });
    chart.words = drawn('text', { class: 'values', x: box.right, y: 13, 'text-anchor': 'end' });
    chart.dot = drawn('circle', { r: 4.5 });
    svg.replaceChildren(...parts, chart.hover, chart.cursor, ...lines.reverse(), chart.dot, chart.words);
    Object.assign(chart, { box, x, y, high, low });
    move(chart);
  }

  function line(a, b, x, y) {
    let path = '', pen = 'M';
    a.forEach((value, k) => {
      if (!Number.isFinite(b[k])) { pen = 'M'; return; }
      path += `${pen}${x(value).toFixed(1)} ${y(b[k]).toFixed(1)}`;
      pen = 'L';
    });
    return path;
  }

  function move(chart) {
    const { of, across: over, box, x, y } = chart, now = at(motion, time);
    const places = { v: [time, now.v], s: [time, now.s], plane: [now.s, now.v], energy: [time, NaN], stress: [time, NaN] };
    let [a, b] = places[of] || [dragged ? dragged.now : 0, motion[of]];
    if (over === 't') a = Math.min(a, longest());
    const visible = Number.isFinite(a) && Number.isFinite(b);
    chart.cursor.setAttribute('d', `M${x(a)} ${box.top}V${box.bottom}`);
    chart.dot.setAttribute('display', visible ? 'inline' : 'none');
    if (visible) { chart.dot.setAttribute('cx', x(a)); chart.dot.setAttribute('cy', y(b)); }
    const hovers = hovered !== null && ['v', 's'].includes(of);
    chart.hover.setAttribute('d', hovers ? `M${x(hovered)} ${box.top}V${box.bottom}` : '');
    const value = () => `${text(at(motion, hovered)[of], chart.high - chart.low)} ${named(of === 'v' ? 'm/s' : 'm')} at ${text(hovered, longest())} s`;
    const keys = { energy: [['', 'work'], ['dissipation', '- - dissipation'], ['kinetic', 'kinetic']], stress: [['', 'total'], ['dissipation', '- - effective']] };
    chart.words.replaceChildren(...(keys[of] || []).map(([kind, name]) => drawn('tspan', { class: kind, dx: 8 }, name)));
    if (hovers) chart.words.textContent = value();
  }

  // --- controls ---

  function go(to, save = true) {
    time = Math.min(Math.max(to, 0), longest());
    show();
    if (save) write();
  }

  function play() {
    if (playing) return pause();
    if (time >= longest()) time = 0;
    const pace = longest() / seconds(longest()), from = time, begin = performance.now();
    const frame = (clock) => {
      go(from + pace * Math.max(clock - begin, 0) / 1000, false);
      if (time < longest()) playing = requestAnimationFrame(frame);
      else pause();
    };
    playing = requestAnimationFrame(frame);
    button.textContent = '\u275a\u275a';
    button.setAttribute('aria-label', 'pause');
  }

  function pause() {
    cancelAnimationFrame(playing);
    playing = 0;
    button.textContent = '\u25b6';
    button.setAttribute('aria-label', 'play');
    show();
    write();
  }

  function pressed(event) {
    const step = longest() / STEPS / (event.shiftKey ? 10 : 1);
    const does = {
      ' ': () => play(),
      ArrowLeft: () => go(time - step),
      ArrowRight: () => go(time + step),
      Home: () => go(0),
      End: () => go(longest()),
    }[event.key];
    const elsewhere = !does || event.ctrlKey || event.metaKey || event.altKey || longest() === 0;
    if (elsewhere || (event.key === ' ' && event.target.matches('button'))) return;
    if (sliders.some((one) => one.input === event.target) && event.key !== ' ') return;
    event.preventDefault();
    does();
  }

  function pointed(chart, event) {
    const { svg, box } = chart, frame = svg.getBoundingClientRect();
    const share = (event.clientX - frame.left) * (svg.viewBox.baseVal.width / frame.width) - box.left;
    return Math.min(Math.max(share / (box.right - box.left), 0), 1);
  }

  for (const chart of charts) {
    const timed = chart.across === 't';
    const moves = (event) => {
      const share = pointed(chart, event);
      if (timed) go(share * longest());
      else if (chart.across === 'number' && dragged) set(dragged, dragged.low + share * (dragged.high - dragged.low));
    };
    chart.svg.addEventListener('pointermove', (event) => {
      if (timed) hovered = pointed(chart, event) * longest();
      if (event.buttons) moves(event);
      else if (timed) show();
    });
    chart.svg.addEventListener('pointerdown', (event) => {
      if (playing) pause();
      chart.svg.setPointerCapture(event.pointerId);
      moves(event);
    });
    chart.svg.addEventListener('pointerup', write);
    chart.svg.addEventListener('pointerleave', () => { hovered = null; show(); });
  }
  slider.addEventListener('input', () => { if (playing) pause(); go(Number(slider.value)); });
  button.addEventListener('click', play);
  (addressed ? document : figure).addEventListener('keydown', pressed);
  addEventListener('resize', layout);
  addEventListener('hashchange', () => { read(); solve(); layout(); curve(); });

  // --- address and downloads ---

  function read() {
    if (!addressed) return;
    const asked = new URLSearchParams(location.hash.slice(1)), t = parseFloat(asked.get('t'));
    for (const one of sliders) {
      const value = parseFloat(asked.get(one.key));
      if (Number.isFinite(value)) set(one, Math.min(Math.max(value, one.low), one.high), false);
    }
    if (Number.isFinite(t)) time = Math.max(t, 0);
  }

  function write() {
    if (!addressed || playing) return;
    const asked = new URLSearchParams({ t: String(Number(time.toPrecision(6))) });
    for (const one of sliders) if (one.now !== one.value) asked.set(one.key, String(one.now));
    try {
      history.replaceState(null, '', `#${asked}`);
    } catch { /* a page inside a frame cannot change the address */ }
  }

  function picture() {
    const copy = find('.section').cloneNode(true), look = made('style', document.querySelector('style').textContent);
    copy.setAttribute('xmlns', SVG);
    copy.setAttribute('class', 'slide section');
    copy.prepend(look);
    save('slide.svg', 'image/svg+xml', new XMLSerializer().serializeToString(copy));
  }

  function series() {
    const heads = ['time_s', 'displacement_m', 'velocity_m_s'], [metre, speed] = ['m', 'm/s'].map((unit) => data.units[unit][1]);
    const rows = motion.t.map((t, k) => [t, motion.s[k] / metre, motion.v[k] / speed].join(','));
    save('slide.csv', 'text/csv', `${heads.join(',')}\n${rows.join('\n')}\n`);
  }

  function save(name, type, content) {
    const link = made('a');
    link.href = URL.createObjectURL(new Blob([content], { type }));
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  }
}

// --- the motion between its samples ---

function at(one, time) {
  const { t, s, v } = one, last = t.length - 1;
  if (time >= t[last]) return { s: s[last], v: v[last] };
  let low = 0, high = last;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (t[middle] > time) high = middle;
    else low = middle;
  }
  const share = (time - t[low]) / (t[high] - t[low]), between = (c) => c[low] + share * (c[high] - c[low]);
  return { s: between(s), v: between(v) };
}

function seconds(duration) {
  return Math.min(Math.max(duration, SHORTEST), LONGEST);
}

// --- numbers and elements ---

function spread(values) {
  return Math.max(...values) - Math.min(...values);
}

function text(value, size) {
  const digits = size > 0 ? Math.min(Math.max(3 - Math.floor(Math.log10(size)), 0), 12) : 0;
  const shown = value.toFixed(digits);
  return Number(shown) === 0 ? (0).toFixed(digits) : shown;
}

function plain(value) {
  return String(Number(value.toPrecision(6)));
}

function rounds(low, high, most) {
  const least = (high - low) / most, power = 10 ** Math.floor(Math.log10(least));
  const step = [1, 2, 5, 10].map((n) => n * power).find((n) => n >= least * 0.999999);
  const values = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * (high - low); k += 1) values.push(k * step);
  return values;
}

function made(name, ...contents) {
  const element = document.createElement(name);
  element.append(...contents);
  return element;
}

function drawn(name, attributes, words = '') {
  const element = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  element.textContent = words;
  return element;
}
