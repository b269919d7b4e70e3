/* The picture: a canvas that shows the water at the time chosen. */
const picture = byId('picture');
const view = {x: 0, y: 0, scale: 100}; // middle in H, px in an H
const shown = {points: true, surfaces: true, velocity: false, runs: new Set(named), of: 0, colour: 'p', jet: false, mark: null};
let scene = null; // what was drawn last: {t, surfaces, points, values, quantity, range}

const size = () => ({width: picture.clientWidth, height: picture.clientHeight});
const toScreen = (x, y) => [(x - view.x) * view.scale + size().width / 2, size().height / 2 - (y - view.y) * view.scale];
const toWater = (px, py) => [(px - size().width / 2) / view.scale + view.x, (size().height / 2 - py) / view.scale + view.y];

function fit(box) {
  const {width, height} = size();
  view.scale = Math.min(width / (box[1][0] - box[0][0]), height / (box[1][1] - box[0][1])) * 0.94;
  view.x = (box[0][0] + box[1][0]) / 2;
  view.y = (box[0][1] + box[1][1]) / 2;
}

/* All that the runs ever fill, within the walls. */
function wholeBox() {
  const box = [[Infinity, Infinity], [-Infinity, -Infinity]];
  for (const run of pack.runs)
    for (const s of run.surfaces)
      for (const k of [0, 1]) {
        if (!s.planes.n) continue;
        box[0][k] = Math.min(box[0][k], s.planes.lo[k]);
        box[1][k] = Math.max(box[1][k], s.planes.hi[k]);
      }
  for (const k of [0, 1]) {
    box[0][k] = Math.min(box[0][k], report.window[0][k], pack.walls.planes.n ? pack.walls.planes.lo[k] : Infinity);
    box[1][k] = Math.max(Math.min(box[1][k], 3 * report.window[1][k] || box[1][k]), report.window[1][k]);
  }
  return box;
}

async function prepare(t) {
  const surfaces = await Promise.all(pack.runs.map((_, i) => shown.runs.has(i) || i === 0 ? surfaceAt(i, t) : null));
  const points = shown.points || shown.velocity ? await pointsAt(shown.of, t) : null;
  const made = {t, surfaces, points, values: null, distances: null};
  if (shown.colour === 'difference') {
    made.values = points && await differenceAt(points, t);
    if (!made.values && surfaces[0])
      made.distances = surfaces.map((s, i) => s && i ? distancesFrom(surfaces[0], s) : null);
    made.quantity = made.values ? QUANTITIES.difference : QUANTITIES.distance;
  } else {
    made.values = points && points.fields[shown.colour] || null;
    made.quantity = QUANTITIES[shown.colour];
  }
  made.range = made.values || made.distances ? rangeOf(made) : null;
  return made;
}

/* A range that grows as outputs are seen, and does not flicker. */
const ranges = new Map();
function rangeOf(made) {
  const key = `${made.quantity.name} ${made.values ? shown.of : ''}`, now = made.quantity.range(made.values);
  const before = ranges.get(key) || now;
  const range = [Math.min(before[0], now[0]), Math.max(before[1], now[1])];
  ranges.set(key, range);
  return range;
}

function drawPoints(c, made) {
  const {points, values, quantity, range} = made, side = Math.max(1, 1.02 * points.size * view.scale);
  const {width, height} = size(), shades = Array.from({length: SHADES + 1}, () => []);
  for (let k = 0; k < points.n; k++) {
    const px = (points.x[k] - view.x) * view.scale + width / 2, py = height / 2 - (points.y[k] - view.y) * view.scale;
    if (px < -side || py < -side || px > width + side || py > height + side) continue;
    shades[values && Number.isFinite(values[k]) ? shadeOf(quantity, range, values[k]) : SHADES].push(px, py);
  }
  shades.forEach((list, shade) => {
    if (!list.length) return;
    c.fillStyle = shade < SHADES ? quantity.shades[shade] : '#b9c2c9';
    for (let k = 0; k < list.length; k += 2)
      if (side < 6) c.fillRect(list[k] - side / 2, list[k + 1] - side / 2, side, side);
      else {
        c.beginPath();
        c.arc(list[k], list[k + 1], 0.65 * side, 0, 7); // no gaps between them
        c.fill();
      }
  });
}

/* An arrow for a particle in each square of the screen. */
function drawVelocity(c, points, ink) {
  if (!points.fields.u) return;
  const {width, height} = size(), gap = 26, taken = new Set(), fastest = Math.max(quantile(points.fields.speed, 0.98), 1e-9);
  c.strokeStyle = ink;
  c.lineWidth = 1;
  c.beginPath();
  for (let k = 0; k < points.n; k++) {
    const [px, py] = toScreen(points.x[k], points.y[k]), key = `${Math.floor(px / gap)} ${Math.floor(py / gap)}`;
    if (px < 0 || py < 0 || px > width || py > height || taken.has(key)) continue;
    taken.add(key);
    const dx = points.fields.u[k] / fastest * gap, dy = -points.fields.v[k] / fastest * gap, l = Math.hypot(dx, dy);
    if (l < 1) continue;
    const ex = px + dx, ey = py + dy, a = Math.min(5, l / 2) / l;
    c.moveTo(px, py);
    c.lineTo(ex, ey);
    c.moveTo(ex - a * (dx - 0.5 * dy), ey - a * (dy + 0.5 * dx));
    c.lineTo(ex, ey);
    c.lineTo(ex - a * (dx + 0.5 * dy), ey - a * (dy - 0.5 * dx));
  }
  c.stroke();
}

function trace(c, line) {
  let at = 0;
  c.beginPath();
  line.pieces.forEach((n, piece) => {
    for (let k = 0; k < n; k++, at++) {
      const [px, py] = toScreen(line.x[at], line.y[at]);
      if (k) c.lineTo(px, py);
      else c.moveTo(px, py);
    }
    if (line.closed[piece]) c.closePath();
  });
}

function drawDistances(c, surface, distances, made) {
  c.lineWidth = 3.5;
  surface.segments ||= segmentsOf(surface);
  for (const [a, b] of surface.segments) {
    c.strokeStyle = made.quantity.shades[shadeOf(made.quantity, made.range, Math.max(distances[a], distances[b]))];
    c.beginPath();
    c.moveTo(...toScreen(surface.x[a], surface.y[a]));
    c.lineTo(...toScreen(surface.x[b], surface.y[b]));
    c.stroke();
  }
}

function drawSurfaces(c, made, ink) {
  made.surfaces.forEach((surface, i) => {
    if (!surface || !shown.runs.has(i)) return;
    if (made.distances && made.distances[i]) return drawDistances(c, surface, made.distances[i], made);
    trace(c, surface);
    c.setLineDash((DASHES[styleOf(i).dashes] || '').split(' ').filter(s => s).map(Number));
    c.strokeStyle = i ? styleOf(i).colour : ink;
    c.lineWidth = i ? 1.6 : 2.2;
    c.stroke();
    c.setLineDash([]);
  });
}

function drawMark(c, [x, y], ink, ground) {
  const [px, py] = toScreen(x, y);
  c.beginPath();
  c.arc(px, py, 16, 0, 7);
  for (const way of [-1, 1]) {
    c.moveTo(px + 26 * way, py);
    c.lineTo(px + 16 * way, py);
  }
  for (const [style, width] of [[ground, 6], [ink, 2.5]]) {
    c.strokeStyle = style;
    c.lineWidth = width;
    c.stroke();
  }
}

async function draw(t) {
  const made = await prepare(t), style = getComputedStyle(document.documentElement), ink = style.getPropertyValue('--fg').trim();
  if (shown.jet) followJet(made);
  const {width, height} = size(), dpr = window.devicePixelRatio || 1, c = picture.getContext('2d');
  const walls = pack.walls.planes.n ? await columnsOf(pack.walls.planes) : null;
  if (picture.width !== Math.round(width * dpr) || picture.height !== Math.round(height * dpr)) {
    picture.width = Math.round(width * dpr);
    picture.height = Math.round(height * dpr);
  }
  c.setTransform(dpr, 0, 0, dpr, 0, 0);
  c.clearRect(0, 0, width, height);
  if (made.points && shown.points) drawPoints(c, made);
  if (made.points && shown.velocity) drawVelocity(c, made.points, ink);
  if (walls) {
    trace(c, {x: walls[0], y: walls[1], pieces: pack.walls.pieces, closed: pack.walls.closed});
    c.strokeStyle = style.getPropertyValue('--soft').trim();
    c.lineWidth = 3;
    c.stroke();
  }
  if (shown.surfaces) drawSurfaces(c, made, ink);
  if (shown.mark) drawMark(c, shown.mark, ink, style.getPropertyValue('--card').trim());
  byId('scale').hidden = !made.range || !(shown.points || made.distances);
  if (made.range) drawScale(byId('scale'), made.quantity, made.range, ink);
  scene = made;
}

/* The time nearest to t at which there is a jet with half of its largest overhang: of the reference or the run whose particles
   are shown, else of any; until touchdown. So nobody is led to the first fold of a film on the wall. */
function jetTime(t) {
  const until = i => runs[i].touchdown.t_star ?? Infinity;
  const jets = list => list.flatMap(i => pack.runs[i].surfaces.filter(s => s.tip && s.t < until(i) + 1e-6)), own = jets([0, shown.of]);
  const having = own.length ? own : jets([...pack.runs.keys()]), largest = Math.max(...having.map(s => s.overhang));
  return having.filter(s => s.overhang >= largest / 2).reduce((best, s) => Math.abs(s.t - t) < Math.abs(best - t) ? s.t : best, Infinity);
}

/* The tip of the jet of the run whose particles are shown, or else of any. */
function followJet(made) {
  const order = [shown.of, 0, ...shown.runs], tip = order.map(i => made.surfaces[i] && made.surfaces[i].tip).find(s => s);
  if (!tip) return;
  [view.x, view.y] = tip;
  view.scale = Math.max(size().width, size().height) / 1.2;
}

/* What is at a place of the picture, as lines of text. */
function describe(px, py) {
  if (!scene) return [];
  const [x, y] = toWater(px, py), lines = [`x = ${g(x)} H, y = ${g(y)} H`], points = shown.points && scene.points;
  if (points) {
    points.cells ||= new Cells(points.x, points.y, 2 * points.size);
    const k = points.cells.nearest(x, y, 2);
    if (k >= 0 && Math.hypot(points.x[k] - x, points.y[k] - y) < 1.5 * points.size) {
      const names = {p: ['p', 'ρgH'], speed: ['speed', '√(gH)'], u: ['u', '√(gH)'], v: ['v', '√(gH)'], rho: ['ρ/ρ₀', '']};
      lines.push(`particle of ${runs[shown.of].label}`);
      for (const [name, [label, unit]] of Object.entries(names))
        if (points.fields[name]) lines.push(`${label} = ${g(points.fields[name][k], 3)} ${unit}`);
      if (shown.colour === 'difference' && scene.values) lines.push(`p less the reference's = ${g(scene.values[k], 3)} ρgH`);
    }
  }
  if (scene.surfaces[0]) lines.push(`${g(distanceFrom(scene.surfaces[0], x, y), 3)} H from the surface of ${runs[0].label}`);
  return lines;
}
