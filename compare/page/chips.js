/* Chips: a check each, which leads to the place and time of its worst value. */
const ratioOf = row => Number.isFinite(row.value) ? Math.abs(row.value) / Math.abs(row.limit || 1) : Infinity;

/* Of the runs that a tolerance is for, the one nearest to it, or furthest beyond. */
function worstChecks() {
  const groups = new Map();
  for (const row of report.measures) {
    if (row.outcome === 'no limit') continue;
    const key = `${row.measure} ${row.t_star} ${row.limit}`, best = groups.get(key);
    if (!best || ratioOf(row) > ratioOf(best.row)) groups.set(key, {row, n: (best ? best.n : 0) + 1});
    else best.n++;
  }
  const failing = g => g.row.outcome === 'fail' ? 0 : 1;
  return [...groups.values()].sort((a, b) => failing(a) - failing(b) || ratioOf(b.row) - ratioOf(a.row));
}

function latestWorst(run, measure) {
  const {t_star: ts, [measure]: values} = run.against_time || {};
  if (!values) return null;
  return values.reduce((best, v, k) => v !== null && (best === null || v > values[best]) ? k : best, null) ?? null;
}

/* {t, at} of a row: where its value is found; at may be null. */
function placeOf(row) {
  const i = indexOf(row.run), run = runs[i], detail = row.detail || '', saysT = detail.match(/t\* = ([-\d.e+]+)/);
  const sensor = pack.charts.filter(c => c.at && detail.split(/[^\w"'-]+/).includes(c.name)).pop();
  const entry = row.t_star === null ? null : run.at_times.find(a => Math.abs(a.t_star_asked - row.t_star) < 1e-9);
  const instant = /^(overturning|touchdown)/.exec(row.measure);
  if (instant) return {t: run[instant[1]].t_star, at: run[instant[1]].at};
  if (sensor) {
    const signal = run.signals.find(s => s.signal === sensor.name);
    return {t: signal && signal.run.peak_time !== null ? signal.run.peak_time : null, at: [sensor.at[0], sensor.at[1] ?? 0]};
  }
  if (entry) {
    const at = /jet/.test(row.measure) && entry.jet ? entry.jet.tip : /distance|area|hausdorff|frechet/.test(row.measure) ? entry.largest_distance_at : null;
    return {t: row.t_star, at};
  }
  if (saysT) return {t: Number(saysT[1]), at: null};
  const k = latestWorst(run, row.measure);
  return {t: k !== null ? run.against_time.t_star[k] : row.t_star ?? report.reference.wall_impact.t_star ?? report.times[report.times.length - 1], at: null};
}

/* A front has its place in the chart of fronts. */
function frontPlace(row, t) {
  const chart = charts.find(c => c.section === 'front' && c.sensor), curve = chart && chart.curves.find(c => c.run === indexOf(row.run));
  const x = curve ? valueAt(curve.ts, curve.values, t) : NaN;
  return Number.isFinite(x) ? [x, 0] : null;
}

function jumpTo(row) {
  const place = placeOf(row), at = place.at && Number.isFinite(place.at[0]) && Number.isFinite(place.at[1]) ? place.at
    : row.measure === 'front' ? frontPlace(row, place.t) : null;
  stop();
  setJet(false);
  shown.mark = at;
  const i = indexOf(row.run);
  shown.runs.add(i);
  const box = byId(`run-${i}`);
  if (box) box.checked = true;
  if (pack.runs[i].points.length) byId('of').value = shown.of = i;
  if (at) {
    [view.x, view.y] = at;
    view.scale = size().width / 2.5;
  } else fit(wholeBox());
  state.note = `${readable(row.measure)} of ${row.run}: ${Number.isFinite(row.value) ? g(row.value) : 'n/a'} ${row.units}, limit ${g(row.limit)}${row.detail ? `, ${row.detail}` : ''}.` +
    (at ? '' : ' It is of the whole water.');
  setTime(Number.isFinite(place.t) ? place.t : state.t);
  byId('explore').scrollIntoView({block: 'start', behavior: matchMedia('(prefers-reduced-motion: reduce)').matches ? 'auto' : 'smooth'});
  picture.focus({preventScroll: true});
}

function makeChips() {
  const groups = worstChecks();
  byId('chips').append(...groups.map(({row, n}) => make('button', {type: 'button', class: `chip ${row.outcome}`, onclick: () => jumpTo(row),
    title: `${n} ${n > 1 ? 'checks' : 'check'}; the worst is of ${row.run}`},
  make('b', {}, row.outcome === 'pass' ? '✓ ' : '✗ '), `${readable(row.measure)}${row.t_star === null ? '' : ` at ${g(row.t_star)}`} `,
  make('span', {class: 'of'}, `${row.run} ${Number.isFinite(row.value) ? g(row.value, 3) : 'n/a'} of ${g(row.limit, 3)}`))));
  byId('chips').hidden = !groups.length;
}
