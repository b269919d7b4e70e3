/* Charts against time, drawn by D3, with one cursor through all of them. */
const charts = [];
const PX = parseFloat(getComputedStyle(document.documentElement).fontSize) / 16; // of large screens
const HEIGHT = 220 * PX, MARGIN = {top: 10 * PX, right: 14 * PX, bottom: 34 * PX, left: 58 * PX};

/* The last time that anything is at. */
const lastTime = () => Math.max(...pack.runs.flatMap(r => r.surfaces.slice(-1).map(s => s.t)), 1e-9);

/* Curves whose values lie more than eight times beyond those of the others leave the frame; of pressures, which are
 * noise there, two and a half times. */
function frameOf(curves, section) {
  const most = section === 'pressure' ? 2.5 : 8;
  const spans = curves.filter(c => !c.raw).map(c => [quantile(c.values, 0), quantile(c.values, 1)]).filter(s => Number.isFinite(s[0]));
  if (!spans.length) return [0, 1];
  const sizes = spans.map(s => Math.max(Math.abs(s[0]), Math.abs(s[1]))).sort((a, b) => a - b), usual = sizes[Math.floor((sizes.length - 1) / 2)];
  const within = spans.filter((_, k) => Math.max(Math.abs(spans[k][0]), Math.abs(spans[k][1])) <= most * usual || !usual);
  const low = Math.min(...within.map(s => s[0])), high = Math.max(...within.map(s => s[1])), room = 0.05 * (high - low || Math.abs(high) || 1);
  return [low >= 0 && low < 0.4 * high ? 0 : low - room, high + room];
}

/* The times that all charts show; null: each shows all of its own. */
let zoomed = null;

/* A curve in those times alone: what its frame is made of. */
function within(curve, times) {
  if (!times) return curve;
  const kept = curve.values.filter((_, k) => curve.ts[k] >= times[0] && curve.ts[k] <= times[1]);
  const ends = times.map(t => valueAt(curve.ts, curve.values, t)).filter(Number.isFinite);
  return {...curve, values: [...kept, ...ends]};
}

/* Takes the window in to what there is, and draws all charts in it. */
function setZoom(low, high) {
  const all = lastTime(), width = Math.max(all / 1000, Math.min(all, high - low)), from = Math.max(0, Math.min(all - width, low));
  zoomed = width > 0.999 * all ? null : [from, from + width];
  cancelAnimationFrame(setZoom.frame);
  setZoom.frame = requestAnimationFrame(() => charts.forEach(c => c.draw()));
}

const inFrame = (curve, [low, high]) => quantile(curve.values, 0) >= low - (high - low) && quantile(curve.values, 1) <= high + (high - low);

class Chart {
  constructor(section, plan) {
    Object.assign(this, plan, {section});
    this.legend = make('div', {class: 'legend'});
    this.drawing = make('div', {class: 'drawing', tabindex: 0, role: 'group', 'aria-label': `${this.title}: plus, minus, arrows and 0 zoom and move all charts`});
    this.back = make('button', {type: 'button', class: 'back', hidden: ''}, 'All times');
    this.back.addEventListener('click', () => setZoom(0, lastTime()));
    this.element = make('figure', {class: 'chart'}, make('figcaption', {}, this.title, this.back), this.drawing, this.legend);
    charts.push(this);
    this.listenZoom();
  }

  /* The times at its left and right edge. */
  get span() { return zoomed || [0, this.end || lastTime()]; }

  visible(curve) { return curve.run === null || shown.runs.has(curve.run); }

  draw() {
    const width = Math.max(240, this.drawing.clientWidth), right = width - MARGIN.right, bottom = HEIGHT - MARGIN.bottom;
    const shownCurves = this.curves.map(c => within(c, zoomed));
    this.frame = frameOf(shownCurves, this.section);
    this.strays = new Set(this.curves.filter((_, k) => !inFrame(shownCurves[k], this.frame)));
    this.back.hidden = !zoomed;
    this.x = d3.scaleLinear().domain(this.span).range([MARGIN.left, right]);
    this.zoomAlike();
    this.y = d3.scaleLinear().domain(this.frame).range([bottom, MARGIN.top]);
    this.drawing.replaceChildren();
    const svg = d3.select(this.drawing).append('svg').attr('viewBox', `0 0 ${width} ${HEIGHT}`).attr('width', width).attr('height', HEIGHT)
      .attr('role', 'img').attr('aria-label', `${this.title}, ${this.unit}, against time from t* = ${g(this.span[0])} to ${g(this.span[1])}`);
    const id = `clip-${charts.indexOf(this)}`;
    svg.append('clipPath').attr('id', id).append('rect').attr('x', MARGIN.left).attr('y', MARGIN.top - 1).attr('width', right - MARGIN.left).attr('height', bottom - MARGIN.top + 2);
    svg.append('g').attr('class', 'axis').attr('transform', `translate(0,${bottom})`).call(d3.axisBottom(this.x).ticks(width / 90 / PX));
    svg.append('g').attr('class', 'axis grid').attr('transform', `translate(${MARGIN.left},0)`)
      .call(d3.axisLeft(this.y).ticks(5, Math.max(...this.frame.map(Math.abs)) < 0.01 ? '.0e' : undefined).tickSize(-(right - MARGIN.left)));
    svg.append('text').attr('class', 'label').attr('x', right).attr('y', HEIGHT - 4).attr('text-anchor', 'end').text('t* in √(H/g)');
    svg.append('text').attr('class', 'label').attr('x', -MARGIN.top).attr('y', 12 * PX).attr('transform', 'rotate(-90)').attr('text-anchor', 'end').text(this.unit);
    const lines = svg.append('g').attr('clip-path', `url(#${id})`);
    const far = c => this.strays.has(c) ? 0 : 1; // those that leave the frame lie below the others
    [...this.curves].sort((a, b) => far(a) - far(b)).filter(c => this.visible(c)).forEach(c => this.drawCurve(lines, c));
    this.levels.forEach(level => lines.append('line').attr('class', 'level').attr('x1', MARGIN.left).attr('x2', right).attr('y1', this.y(level)).attr('y2', this.y(level)));
    this.hoverLine = svg.append('line').attr('class', 'hover').attr('y1', MARGIN.top).attr('y2', bottom).attr('visibility', 'hidden');
    this.timeLine = svg.append('line').attr('class', 'time').attr('y1', MARGIN.top).attr('y2', bottom);
    this.listen(svg.node());
    this.fillLegend();
    this.cursor(state.t);
  }

  drawCurve(lines, curve) {
    const rows = d3.range(curve.ts.length), x = k => this.x(curve.ts[k]), y = k => this.y(curve.values[k]);
    if (curve.run === null && !curve.raw) {
      let last = -Infinity; // circles that would lie on one another are left out
      const apart = rows.filter(k => Number.isFinite(curve.values[k]) && x(k) - last > 7 && ((last = x(k)), true));
      lines.append('path').attr('class', 'measured').attr('d', apart.map(k => `M${x(k) - 2},${y(k)}a2,2 0 1,0 4,0a2,2 0 1,0 -4,0`).join(''));
      return;
    }
    if (curve.errors) lines.append('path').attr('fill', colourOf(curve.run)).attr('fill-opacity', 0.2)
      .attr('d', d3.area().defined(k => Number.isFinite(curve.errors[k])).x(x).y0(k => this.y(curve.values[k] - curve.errors[k])).y1(k => this.y(curve.values[k] + curve.errors[k]))(rows));
    lines.append('path').attr('fill', 'none').style('stroke', curve.run === null ? 'var(--soft)' : colourOf(curve.run)).attr('stroke-width', curve.raw || this.strays.has(curve) ? 0.5 : curve.run ? 1.4 : 2)
      .attr('stroke-dasharray', curve.run ? DASHES[styleOf(curve.run).dashes] : null)
      .attr('d', d3.line().defined(k => Number.isFinite(curve.values[k])).x(x).y(y)(rows));
  }

  fillLegend() {
    this.values = this.curves.filter(c => !c.raw && this.visible(c)).map(curve => ({curve, value: make('b', {})}));
    this.legend.replaceChildren(...this.values.map(({curve, value}) => make('span', {},
      ...curve.run === null ? [make('span', {class: 'dot ring'}), curve.experiment] : runName(curve.run),
      this.strays.has(curve) ? ' (beyond the frame)' : '', ' ', value)));
  }

  cursor(t, hovered) {
    if (!this.timeLine) return;
    const line = hovered ? this.hoverLine : this.timeLine, px = this.x(t);
    line.attr('x1', px).attr('x2', px).attr('visibility', px > this.x.range()[1] + 1 || px < this.x.range()[0] - 1 ? 'hidden' : 'visible');
    if (!hovered) this.hoverLine.attr('visibility', 'hidden');
    for (const {curve, value} of this.values) value.textContent = g(valueAt(curve.ts, curve.values, t)).replace('n/a', '–');
  }

  listen(svg) {
    const timeOf = event => {
      const box = svg.getBoundingClientRect();
      return Math.max(this.span[0], Math.min(this.span[1], this.x.invert((event.clientX - box.left) * svg.viewBox.baseVal.width / box.width)));
    };
    const other = event => event.shiftKey || this.zooming; // that moves and zooms
    svg.addEventListener('pointermove', event => {
      if (other(event)) return;
      if (event.buttons) setTime(timeOf(event));
      else charts.forEach(c => c.cursor(timeOf(event), true));
    });
    svg.addEventListener('pointerdown', event => other(event) || setTime(timeOf(event)));
    svg.addEventListener('pointerleave', () => charts.forEach(c => c.cursor(state.t)));
  }

  /* ---- zoom: of all charts together ---- */

  listenZoom() {
    this.zoom = d3.zoom().touchable(() => true).scaleExtent([1, 1000]).filter(() => {
      const e = d3.event;
      return e.type === 'wheel' ? e.ctrlKey : e.touches ? e.touches.length > 1 : e.type === 'mousedown' && e.shiftKey && !e.button;
    });
    this.zoom.on('start', () => { this.zooming = true; }).on('end', () => { this.zooming = false; }).on('zoom', () => {
      if (d3.event.sourceEvent) setZoom(...d3.event.transform.rescaleX(this.whole).domain());
    });
    d3.select(this.drawing).call(this.zoom).on('dblclick.zoom', () => setZoom(0, lastTime()));
    this.drawing.addEventListener('keydown', event => {
      const [low, high] = this.span, width = high - low, middle = Math.max(low, Math.min(high, state.t));
      const by = factor => setZoom(middle - (middle - low) * factor, middle + (high - middle) * factor);
      const keys = {'+': () => by(0.8), '=': () => by(0.8), '-': () => by(1.25), 0: () => setZoom(0, lastTime()),
        ArrowLeft: () => setZoom(low - width / 10, high - width / 10), ArrowRight: () => setZoom(low + width / 10, high + width / 10)};
      if (!keys[event.key] || event.ctrlKey || event.metaKey || event.altKey || (!zoomed && /^Arrow/.test(event.key))) return;
      event.preventDefault();
      event.stopPropagation();
      keys[event.key]();
    });
  }

  /* What D3 knows of the zoom, as that of all charts is. */
  zoomAlike() {
    const [low, high] = this.x.domain(), range = this.x.range();
    this.whole = d3.scaleLinear().domain([0, lastTime()]).range(range);
    this.zoom.extent([[range[0], 0], [range[1], HEIGHT]]).translateExtent([[range[0], -Infinity], [range[1], Infinity]]);
    const k = lastTime() / (high - low);
    if (!this.zooming) this.drawing.__zoom = d3.zoomIdentity.translate(range[0] - k * this.whole(low), 0).scale(k);
  }
}

/* The distances of report.json as curves. */
function distanceCharts() {
  return report.about.measures.filter(m => report.runs.some(r => r.against_time[m.name])).map(m => ({
    section: live(m.section) ? m.section : 'distance', title: readable(m.name), unit: pretty(m.units),
    levels: m.name === 'mean_distance' ? [Math.min(...report.runs.map(r => r.noise_floor))] : [],
    curves: report.runs.map((r, k) => ({run: k + 1, ts: r.against_time.t_star, values: (r.against_time[m.name] || []).map(v => v ?? NaN)}))
      .filter(c => styleOf(c.run).named && c.ts.length)
  })).filter(c => c.curves.length);
}

async function packedCharts() {
  return Promise.all(pack.charts.map(async chart => ({
    section: chart.section, title: readable(chart.title), unit: pretty(chart.unit), levels: [], sensor: chart,
    end: chart.section === 'front' && report.reference.wall_impact.t_star ? 1.1 * report.reference.wall_impact.t_star : 0,
    curves: (await Promise.all(chart.curves.filter(c => c.run === null || styleOf(c.run).named).map(async c => {
      const [ts, values, errors] = await columnsOf(c.planes);
      return {run: c.run, experiment: c.experiment, raw: c.raw, ts, values, errors};
    })))
  })));
}

/* Fixed figures that a chart shows as well are put away, until they are asked for. */
const REPLACED = /^(distance$|front$|energy|pressure-|gauge-|diagnostics|noise|momenta)/;

async function makeCharts() {
  if (!window.d3) return;
  for (const plan of [...distanceCharts(), ...await packedCharts()]) {
    const place = live(plan.section);
    if (!place) continue;
    let box = place.querySelector('.charts');
    if (!box) place.prepend(box = make('div', {class: 'charts'}));
    box.append(new Chart(plan.section, plan).element);
  }
  document.querySelectorAll('.charts').forEach(box => {
    const figures = [...box.closest('section').querySelectorAll('.fixed figure')].filter(f => REPLACED.test(f.dataset.name));
    figures.filter(f => f.querySelector('img')).forEach(f => f.classList.add('replaced'));
    if (!figures.some(f => f.querySelector('img'))) box.classList.add('printed');
  });
  charts.forEach(c => c.draw());
}
