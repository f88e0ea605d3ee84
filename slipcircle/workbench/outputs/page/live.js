'use strict';
// The slide of a page: time and case are its whole state, every view is drawn from them, and the address holds them.
// The motion is interpolated as `interpolant.py` says; nothing is computed here that was not solved there.

const SVG = 'http://www.w3.org/2000/svg';
const STEPS = 100; // of a key, from the start to the end
const SHORTEST = 4, LONGEST = 10; // seconds in which a slide is played

const slides = document.querySelectorAll('.slide');
for (const figure of slides) start(figure, slides.length === 1);

function start(figure, addressed) {
  const find = (selector) => figure.querySelector(selector);
  const data = JSON.parse(find('script').textContent);
  const cases = data.cases.map(decoded);
  const shapes = [...figure.querySelectorAll('.shape')];
  const slider = find('.at input'), chooser = find('.which input'), button = find('.play');
  const charts = [...figure.querySelectorAll('.chart')].map((svg) => ({ svg, of: svg.dataset.of }));
  const most = { v: data.velocity, s: data.displacement };
  let time = data.duration, chosen = data.first, playing = 0, hovered = null;

  find('.which').hidden = cases.length === 1;
  figure.classList.toggle('still', data.duration === 0);
  read();
  layout();

  // --- what is shown ---

  function show() {
    const one = cases[chosen], now = at(one, time);
    const shape = data.shapes[one.shape];
    shapes.forEach((group, index) => group.setAttribute('display', index === one.shape ? 'inline' : 'none'));
    const angle = shape.turn * now.s;
    const mass = shapes[one.shape].querySelector('.mass');
    mass.setAttribute('transform', `rotate(${angle} ${shape.centre[0]} ${shape.centre[1]})`);
    put('.time', time, data.duration);
    put('.velocity', now.v, most.v[1] - most.v[0]);
    put('.displacement', now.s, most.s[1] - most.s[0]);
    find('.state').textContent = state(one);
    find('.headline').textContent = one.headline;
    slider.value = time;
    slider.setAttribute('aria-valuetext', `${text(time, data.duration)} s`);
    chooser.value = chosen;
    chooser.setAttribute('aria-valuetext', one.label);
    find('.which output').textContent = one.label;
    find('.facts').replaceChildren(...one.facts.map(([name, value]) => made('div', made('dt', name), made('dd', value))));
    find('.warnings').replaceChildren(...one.warnings.map((words) => made('li', words)));
    charts.forEach(move);
  }

  function state(one) {
    if (playing) return data.pace;
    if (time > 0 && time >= one.t[one.t.length - 1]) return one.end;
    return time > 0 ? '' : 'at the start';
  }

  function put(selector, value, size) {
    const place = find(selector);
    place.value = String(value);
    place.textContent = text(value, size);
  }

  // --- curves ---

  function layout() {
    const drawing = find('.section');
    const width = drawing.clientWidth || 1000;
    const unit = 1000 / width;
    drawing.style.setProperty('--unit', String(unit));
    for (const shape of shapes) place(shape.querySelectorAll('text'), 13 * unit, drawing.viewBox.baseVal.height);
    for (const chart of charts) draw(chart);
    show();
  }

  function place(names, size, height) {
    let lowest = 0;
    for (const name of names) {
      const line = Number(name.dataset.line), below = !name.matches('.of-water, .of-surcharge');
      const room = below && line + 1.4 * size < height;
      const y = Math.max(room ? line + 1.15 * size : line - (below ? 1.8 : 0.5) * size, lowest);
      name.setAttribute('y', y);
      name.setAttribute('dy', 0);
      lowest = y + 1.25 * size;
    }
  }

  function draw(chart) {
    const { svg, of } = chart, [low, high] = most[of];
    const width = Math.max(svg.clientWidth, 240), height = Math.round(Math.min(0.5 * width, 200));
    const box = { left: 44, right: width - 14, top: 24, bottom: height - 34 };
    const x = (t) => box.left + (box.right - box.left) * (data.duration ? t / data.duration : 0);
    const y = (value) => box.bottom - (box.bottom - box.top) * (value - low) / (high - low);
    svg.setAttribute('viewBox', `0 0 ${width} ${height}`);
    const parts = [drawn('text', { class: 'title', x: 0, y: 13 }, of === 'v' ? 'velocity (m/s)' : 'displacement (m)')];
    for (const value of rounds(low, high, 3)) {
      parts.push(drawn('path', { class: 'grid', d: `M${box.left} ${y(value)}H${box.right}` }));
      parts.push(drawn('text', { x: box.left - 6, y: y(value) + 4, 'text-anchor': 'end' }, plain(value)));
    }
    for (const value of data.duration ? rounds(0, data.duration, 5) : []) {
      parts.push(drawn('path', { class: 'grid', d: `M${x(value)} ${box.bottom}v4` }));
      parts.push(drawn('text', { x: x(value), y: box.bottom + 17, 'text-anchor': 'middle' }, plain(value)));
    }
    parts.push(drawn('text', { x: box.right, y: height - 3, 'text-anchor': 'end' }, 'time (s)'));
    const line = (one) => path(one, of, x, y);
    if (cases.length > 1) parts.push(drawn('path', { class: 'other', d: cases.map(line).join('') }));
    chart.curves = cases.map(line);
    chart.curve = drawn('path', { class: 'curve' });
    chart.cursor = drawn('path', { class: 'cursor' });
    chart.hover = drawn('path', { class: 'hover' });
    chart.words = drawn('text', { class: 'values', x: box.right, y: 13, 'text-anchor': 'end' });
    chart.dot = drawn('circle', { r: 4.5 });
    svg.replaceChildren(...parts, chart.hover, chart.cursor, chart.curve, chart.dot, chart.words);
    Object.assign(chart, { box, x, y });
  }

  function path(one, of, x, y) {
    const last = one.t[one.t.length - 1], points = [];
    for (let k = 0; k <= 200; k += 1) points.push(last * k / 200);
    const times = [...points, ...one.t].sort((a, b) => a - b);
    const places = times.map((t) => `${x(t).toFixed(1)} ${y(at(one, t)[of]).toFixed(1)}`);
    return `M${places.join('L')}`;
  }

  function move(chart) {
    const { of, box, x, y } = chart, one = cases[chosen];
    const vertical = (t) => `M${x(t)} ${box.top}V${box.bottom}`;
    chart.curve.setAttribute('d', chart.curves[chosen]);
    chart.cursor.setAttribute('d', vertical(time));
    chart.dot.setAttribute('cx', x(time));
    chart.dot.setAttribute('cy', y(at(one, time)[of]));
    chart.hover.setAttribute('d', hovered === null ? '' : vertical(hovered));
    const [low, high] = most[of];
    const unit = of === 'v' ? 'm/s' : 'm';
    const value = (t) => `${text(at(one, t)[of], high - low)} ${unit} at ${text(t, data.duration)} s`;
    chart.words.textContent = hovered === null ? '' : value(hovered);
  }

  // --- what changes it ---

  function go(to, save = true) {
    time = Math.min(Math.max(to, 0), data.duration);
    show();
    if (save) write();
  }

  function choose(index) {
    chosen = Math.min(Math.max(index, 0), cases.length - 1);
    show();
    write();
  }

  function play() {
    if (playing) return pause();
    if (time >= data.duration) time = 0;
    const pace = data.duration / seconds(data.duration), from = time, begin = performance.now();
    const frame = (clock) => {
      const to = from + pace * Math.max(clock - begin, 0) / 1000;
      go(to, false);
      if (time < data.duration) playing = requestAnimationFrame(frame);
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
    const step = data.duration / STEPS / (event.shiftKey ? 10 : 1);
    const does = {
      ' ': () => play(),
      ArrowLeft: () => go(time - step),
      ArrowRight: () => go(time + step),
      Home: () => go(0),
      End: () => go(data.duration),
      ArrowUp: () => choose(chosen + 1),
      ArrowDown: () => choose(chosen - 1),
    }[event.key];
    const elsewhere = !does || event.ctrlKey || event.metaKey || event.altKey || data.duration === 0;
    if (elsewhere || (event.key === ' ' && event.target === button)) return;
    if (event.target === chooser && event.key !== ' ') return;
    event.preventDefault();
    does();
  }

  function pointed(chart, event) {
    const { svg, box } = chart, frame = svg.getBoundingClientRect();
    const share = (event.clientX - frame.left) * (svg.viewBox.baseVal.width / frame.width) - box.left;
    return Math.min(Math.max(share / (box.right - box.left), 0), 1) * data.duration;
  }

  for (const chart of charts) {
    chart.svg.addEventListener('pointermove', (event) => {
      hovered = pointed(chart, event);
      if (event.buttons) go(hovered);
      else show();
    });
    chart.svg.addEventListener('pointerdown', (event) => {
      if (playing) pause();
      chart.svg.setPointerCapture(event.pointerId);
      go(pointed(chart, event));
    });
    chart.svg.addEventListener('pointerleave', () => { hovered = null; show(); });
  }
  slider.addEventListener('input', () => { if (playing) pause(); go(Number(slider.value)); });
  chooser.addEventListener('input', () => choose(Number(chooser.value)));
  button.addEventListener('click', play);
  (addressed ? document : figure).addEventListener('keydown', pressed);
  addEventListener('resize', layout);
  addEventListener('hashchange', () => { read(); show(); });

  // --- the address ---

  function read() {
    if (!addressed) return;
    const given = new URLSearchParams(location.hash.slice(1));
    const t = parseFloat(given.get('t')), v = parseFloat(given.get('v'));
    if (Number.isFinite(t)) time = Math.min(Math.max(t, 0), data.duration);
    if (Number.isInteger(v) && v >= 0 && v < cases.length) chosen = v;
  }

  function write() {
    if (!addressed || playing) return;
    try {
      history.replaceState(null, '', `#t=${Number(time.toPrecision(6))}&v=${chosen}`);
    } catch { /* a page within another has no address of its own */ }
  }
}

// --- the motion ---

function decoded(one) {
  const [t, v, a] = one.columns.map((column, k) => {
    const bytes = Uint8Array.from(atob(column), (letter) => letter.charCodeAt(0));
    const ticks = k < 2 ? new Int32Array(bytes.buffer) : new Int16Array(bytes.buffer);
    return Array.from(ticks, (tick) => tick * one.units[k]);
  });
  const s = [0]; // the integral of the cubics of the velocity
  for (let k = 1; k < t.length; k += 1) {
    const step = t[k] - t[k - 1];
    s.push(s[k - 1] + step * (v[k] + v[k - 1]) / 2 - step * step * (a[k] - a[k - 1]) / 12);
  }
  return { ...one, t, s, v, a };
}

function at(one, time) {
  const { t, s, v, a } = one, last = t.length - 1;
  if (time >= t[last]) return { s: s[last], v: v[last] };
  let low = 0, high = last;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (t[middle] > time) high = middle;
    else low = middle;
  }
  const step = t[high] - t[low], share = (time - t[low]) / step;
  const cubic = (value, slope) => {
    const rest = 1 - share;
    const values = rest * rest * (1 + 2 * share) * value[low] + share * share * (1 + 2 * rest) * value[high];
    return values + step * share * rest * (rest * slope[low] - share * slope[high]);
  };
  return { s: cubic(s, v), v: cubic(v, a) };
}

function seconds(duration) {
  return Math.min(Math.max(duration, SHORTEST), LONGEST);
}

// --- numbers and elements ---

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
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high * (1 + 1e-9); k += 1) values.push(k * step);
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
