/* The page as a whole: one time, keys, and what starts when. */
const state = {t: 0, playing: 0, note: '', busy: false, again: false};
/* Those of all runs; what is written as the same is one. */
const times = pack.runs.flatMap(r => r.surfaces.map(s => Math.round(s.t * 1e6) / 1e6)).sort((a, b) => a - b)
  .filter((t, k, all) => !k || t - all[k - 1] > 1e-3);

/* Draws, and once more when something changed meanwhile. */
async function redraw() {
  if (state.busy) { state.again = true; return; }
  state.busy = true;
  do {
    state.again = false;
    try { await draw(state.t); } catch (error) { byId('said').textContent = `The picture cannot be drawn: ${error.message}`; throw error; } finally { state.busy = state.again; }
    say();
  } while (state.again);
  state.busy = false;
}

function say() {
  const points = scene.points, parts = [state.note];
  if (points && points.moved && shown.points) parts.push(`Particles of t* = ${g(points.t)}, moved on with their velocity.`);
  if (shown.points && !points && pack.runs.some(r => r.points.length)) parts.push('There are no particles at this time.');
  if (shown.colour === 'difference' && !scene.values) parts.push("The reference has no points that fill its water: surfaces are coloured by their distance from its own.");
  byId('said').textContent = parts.filter(p => p).join(' ');
}

const placeOfTime = t => times.reduce((best, s, k) => Math.abs(s - t) < Math.abs(times[best] - t) ? k : best, 0);

function setTime(t) {
  const k = placeOfTime(t);
  state.t = times[k] ?? 0;
  byId('time').value = k;
  byId('time').setAttribute('aria-valuetext', `t* = ${state.t.toFixed(3)}`);
  byId('now').textContent = `t* = ${state.t.toFixed(3)} · ${(state.t * report.scales.time_s).toFixed(3)} s`;
  charts.forEach(c => c.cursor(state.t));
  return redraw();
}

const step = n => setTime(times[Math.max(0, Math.min(times.length - 1, placeOfTime(state.t) + n))]);

function stop() {
  clearTimeout(state.playing);
  state.playing = 0;
  byId('play').textContent = '▶';
  byId('play').setAttribute('aria-label', 'Play');
}

function play() {
  if (state.playing) return stop();
  byId('play').textContent = '⏸';
  byId('play').setAttribute('aria-label', 'Pause');
  if (placeOfTime(state.t) === times.length - 1) setTime(times[0]);
  const on = async () => {
    await step(1);
    if (!state.playing) return;
    if (placeOfTime(state.t) === times.length - 1) stop();
    else state.playing = setTimeout(on, 60);
  };
  state.playing = setTimeout(on, 60);
}

function setJet(on) {
  shown.jet = on;
  byId('jet-view').setAttribute('aria-pressed', on);
}

function whole() {
  setJet(false);
  shown.mark = null;
  state.note = '';
  fit(wholeBox());
  return redraw();
}

function zoom(factor, px = size().width / 2, py = size().height / 2) {
  const [x, y] = toWater(px, py);
  view.scale = Math.max(5, Math.min(2e4, view.scale * factor));
  const [nx, ny] = toWater(px, py);
  view.x += x - nx;
  view.y += y - ny;
  return redraw();
}

function move(dx, dy) {
  setJet(false);
  view.x -= dx / view.scale;
  view.y += dy / view.scale;
  return redraw();
}

/* ---- light and dark ---- */

const darkNow = () => (document.documentElement.dataset.theme || (matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light')) === 'dark';

function setTheme(dark) {
  document.documentElement.dataset.theme = dark ? 'dark' : 'light';
  byId('theme').setAttribute('aria-pressed', dark);
  return redraw();
}

function setFigures(on) {
  document.body.classList.toggle('with-figures', on);
  byId('figures').setAttribute('aria-pressed', on);
}

/* ---- the pointer and keys on the picture ---- */

function listenPointer() {
  const down = new Map();
  picture.addEventListener('pointerdown', e => { picture.setPointerCapture(e.pointerId); down.set(e.pointerId, [e.offsetX, e.offsetY]); });
  for (const end of ['pointerup', 'pointercancel']) picture.addEventListener(end, e => down.delete(e.pointerId));
  picture.addEventListener('pointermove', e => {
    const before = down.get(e.pointerId);
    if (!before) return point(e);
    const others = [...down].filter(([id]) => id !== e.pointerId).map(([, p]) => p);
    if (others.length) {
      const [ox, oy] = others[0], d = (x, y) => Math.hypot(x - ox, y - oy);
      zoom(d(e.offsetX, e.offsetY) / Math.max(1, d(...before)), ox, oy);
    } else move(e.offsetX - before[0], e.offsetY - before[1]);
    down.set(e.pointerId, [e.offsetX, e.offsetY]);
  });
  picture.addEventListener('pointerleave', () => { byId('pointed').hidden = true; });
  picture.addEventListener('wheel', e => {
    if (document.activeElement !== picture && !e.ctrlKey) return; // the page scrolls
    e.preventDefault();
    zoom(Math.exp(-e.deltaY / 400), e.offsetX, e.offsetY);
  }, {passive: false});
  picture.addEventListener('dblclick', e => zoom(2, e.offsetX, e.offsetY));
}

function point(e) {
  const lines = describe(e.offsetX, e.offsetY), box = byId('pointed');
  box.hidden = !lines.length;
  box.replaceChildren(...lines.map(line => make('div', {}, line)));
  const left = e.offsetX + 16 + box.offsetWidth > size().width;
  box.style.left = `${Math.max(0, left ? e.offsetX - box.offsetWidth - 12 : e.offsetX + 14)}px`;
  box.style.top = `${Math.max(0, Math.min(size().height - box.offsetHeight, e.offsetY + 14))}px`;
}

const toggle = id => () => byId(id).click();
const KEYS = {' ': play, ArrowLeft: () => step(-1), ArrowRight: () => step(1), Home: () => setTime(times[0]), End: () => setTime(times[times.length - 1]),
  '+': () => zoom(1.25), '=': () => zoom(1.25), '-': () => zoom(0.8), 0: whole, w: () => move(0, 40), s: () => move(0, -40), a: () => move(40, 0), d: () => move(-40, 0),
  j: toggle('jet-view'), p: toggle('show-points'), u: toggle('show-surfaces'), v: toggle('show-velocity'), t: toggle('theme'),
  c: () => { const box = byId('colour'); box.selectedIndex = (box.selectedIndex + 1) % box.length; box.dispatchEvent(new Event('change')); }};

/* Keys are the page's where no other control wants them. */
function listenKeys() {
  document.addEventListener('keydown', e => {
    if (e.ctrlKey || e.metaKey || e.altKey) return;
    const at = e.target, action = KEYS[e.key.length === 1 ? e.key.toLowerCase() : e.key];
    const typing = at.closest('input, select, textarea'), pressing = e.key === ' ' && at.closest('button, summary, a');
    const scrolling = at.closest('.scroll, pre, .paper') && /^(Arrow|Home|End| )/.test(e.key);
    const away = /^(Home|End| )$/.test(e.key) && at === document.body && picture.getBoundingClientRect().bottom < 0;
    if (!action || typing || pressing || scrolling || away) return;
    e.preventDefault();
    action();
  });
}

/* ---- controls ---- */

function listenControls() {
  const on = (id, event, act) => byId(id).addEventListener(event, act);
  on('play', 'click', play);
  on('back', 'click', () => step(-1));
  on('on', 'click', () => step(1));
  on('time', 'input', e => setTime(times[e.target.value]));
  on('nearer', 'click', () => zoom(1.25));
  on('farther', 'click', () => zoom(0.8));
  on('whole', 'click', whole);
  on('jet-view', 'click', () => { setJet(!shown.jet); return shown.jet ? setTime(jetTime(state.t)) : whole(); });
  on('of', 'change', e => { shown.of = Number(e.target.value); redraw(); });
  on('colour', 'change', e => { shown.colour = e.target.value; redraw(); });
  for (const what of ['points', 'surfaces', 'velocity']) on(`show-${what}`, 'change', e => { shown[what] = e.target.checked; redraw(); });
  on('theme', 'click', () => setTheme(!darkNow()));
  on('figures', 'click', () => setFigures(!document.body.classList.contains('with-figures')));
}

function showRun(i, on) {
  shown.runs[on ? 'add' : 'delete'](i);
  charts.forEach(c => c.draw());
  redraw();
}

/* How near the reference a run is at the last comparison time: the particles of the nearest are shown at first. */
function nearness(i) {
  const own = report.measures.filter(m => m.measure === 'mean_distance' && m.run === runs[i].label && m.value !== null);
  return i && own.length ? -own[own.length - 1].value : -Infinity;
}

function makeControls() {
  byId('time').max = times.length - 1;
  byId('runs-shown').append(...named.map(i => make('label', {}, make('input', {type: 'checkbox', id: `run-${i}`, checked: true,
    onchange: e => showRun(i, e.target.checked)}), ' ', ...runName(i), i ? '' : ' (reference)')));
  const having = pack.runs.map((_, i) => i).filter(i => pack.runs[i].points.length);
  byId('of').append(...having.map(i => make('option', {value: i}, runs[i].label)));
  shown.of = having.length ? having.reduce((best, i) => nearness(i) > nearness(best) ? i : best) : 0;
  byId('of').value = shown.of;
  if (!having.length) {
    shown.points = false;
    for (const id of ['of', 'show-points', 'show-velocity']) byId(id).closest('label').hidden = true;
  }
  const fields = new Set(pack.runs.flatMap(r => r.points.flatMap(p => p.fields))), colour = byId('colour');
  const needs = {p: 'p', speed: 'u', rho: 'rho'};
  for (const option of [...colour.options]) if (needs[option.value] && !fields.has(needs[option.value])) option.remove();
  if (!fields.size) colour.prepend(make('option', {value: 'none'}, 'nothing'));
  shown.colour = colour.value = colour.options[0].value;
  byId('jet-view').hidden = !pack.runs.some(r => r.surfaces.some(s => s.tip));
}

async function start() {
  byId('switches').hidden = false;
  byId('theme').setAttribute('aria-pressed', darkNow());
  fillSections();
  if (!('DecompressionStream' in window) || !times.length) {
    listenControls();
    return;
  }
  byId('explore').hidden = false;
  document.querySelector('nav b').after('\n', make('a', {href: '#explore'}, 'Explore'));
  makeConvergence();
  makeControls();
  listenControls();
  listenPointer();
  listenKeys();
  await makeCharts();
  makeChips();
  const seen = report.about.method.window_is_whole ? wholeBox() : report.window;
  const aspect = (seen[1][1] - seen[0][1]) / (seen[1][0] - seen[0][0]);
  picture.style.setProperty('--aspect', Math.max(0.25, Math.min(0.5, 1.1 * aspect)));
  fit(seen);
  await setTime(report.times[report.times.length - 1] ?? times[times.length - 1]);
  let last = size();
  new ResizeObserver(() => { // what is seen stays, as large as there is room
    view.scale *= size().width / last.width;
    last = size();
    redraw();
  }).observe(picture);
  let width = window.innerWidth;
  window.addEventListener('resize', () => {
    if (window.innerWidth === width) return;
    width = window.innerWidth;
    charts.forEach(c => c.draw());
  });
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => {
    byId('theme').setAttribute('aria-pressed', darkNow());
    redraw();
  });
}

start().then(() => { document.documentElement.dataset.ready = 'yes'; });
