/* What there is of the water at a time: surfaces, particles, and how far it is from the reference's. */

/* Points within reach of each other, by cells of a lattice. */
class Cells {
  constructor(x, y, size) {
    Object.assign(this, {x, y, size, cells: new Map()});
    for (let i = 0; i < x.length; i++) {
      const key = this.key(Math.floor(x[i] / size), Math.floor(y[i] / size));
      if (!this.cells.has(key)) this.cells.set(key, []);
      this.cells.get(key).push(i);
    }
  }

  key(a, b) { return (a + 32768) * 65536 + b + 32768; }

  /* Calls see(k) for the points in the ring of cells r away from that of (x, y). */
  ring(x, y, r, see) {
    const a = Math.floor(x / this.size), b = Math.floor(y / this.size);
    for (let i = a - r; i <= a + r; i++)
      for (let j = b - r; j <= b + r; j += Math.abs(i - a) === r ? 1 : Math.max(1, 2 * r))
        (this.cells.get(this.key(i, j)) || []).forEach(see);
  }

  /* The point nearest to (x, y), looked for in rings of cells up to `rings` away; -1: none. */
  nearest(x, y, rings = 8) {
    let best = -1, least = Infinity;
    for (let r = 0; r <= rings && (best < 0 || (r - 1) * this.size < Math.sqrt(least)); r++)
      this.ring(x, y, r, k => {
        const d = (this.x[k] - x) ** 2 + (this.y[k] - y) ** 2;
        if (d < least) [best, least] = [k, d];
      });
    return best;
  }
}

async function surfaceAt(i, t) {
  const list = pack.runs[i].surfaces, entry = nearest(list, t, slackOf(list));
  if (!entry) return null;
  const [x, y] = await columnsOf(entry.planes);
  return {t: entry.t, x, y, pieces: entry.pieces, closed: entry.closed, tip: entry.tip};
}

/* Half of the largest interval between outputs. */
function slackOf(list) {
  if (list.slack === undefined)
    list.slack = list.reduce((most, s, k) => k ? Math.max(most, s.t - list[k - 1].t) : most, 0) * 0.501 + 1e-6;
  return list.slack;
}

/* Particles of the output nearest to t, moved on with their velocity to t. */
async function pointsAt(i, t) {
  const list = pack.runs[i].points, entry = nearest(list, t, slackOf(list));
  if (!entry || !entry.planes) return null;
  const columns = await columnsOf(entry.planes), fields = {};
  entry.fields.forEach((name, k) => { fields[name] = columns[k + 2]; });
  const n = entry.planes.n, dt = fields.u ? t - entry.t : 0, x = new Float64Array(n), y = new Float64Array(n);
  for (let k = 0; k < n; k++) {
    x[k] = columns[0][k] + (dt ? dt * fields.u[k] : 0);
    y[k] = columns[1][k] + (dt ? dt * fields.v[k] : 0);
  }
  if (fields.u) fields.speed = Float64Array.from(fields.u, (u, k) => Math.hypot(u, fields.v[k]));
  return {t: entry.t, moved: Math.abs(dt) > 1e-6, n, x, y, fields, size: pack.runs[i].dx * Math.sqrt(entry.every)};
}

/* Pressure less that of the reference's nearest point; null: the reference has none. */
async function differenceAt(points, t) {
  const other = await pointsAt(0, t);
  if (!other || !other.fields.p || !points.fields.p) return null;
  const cells = new Cells(other.x, other.y, 2 * other.size);
  return Float64Array.from(points.x, (x, k) => {
    const at = cells.nearest(x, points.y[k], 3);
    return at < 0 ? NaN : points.fields.p[k] - other.fields.p[at];
  });
}

/* A surface as segments, to measure from. */
function segmentsOf(surface) {
  const list = [];
  let from = 0;
  surface.pieces.forEach((n, piece) => {
    for (let k = 0; k + (surface.closed[piece] ? 0 : 1) < n; k++) list.push([from + k, from + (k + 1) % n]);
    from += n;
  });
  return list;
}

function distanceToSegment(s, [a, b], x, y) {
  const ex = s.x[b] - s.x[a], ey = s.y[b] - s.y[a], l2 = ex * ex + ey * ey;
  const way = l2 > 0 ? Math.max(0, Math.min(1, ((x - s.x[a]) * ex + (y - s.y[a]) * ey) / l2)) : 0;
  return Math.hypot(s.x[a] + way * ex - x, s.y[a] + way * ey - y);
}

/* How far (x, y) is from a surface. */
function distanceFrom(surface, x, y) {
  surface.segments ||= segmentsOf(surface);
  let least = Infinity;
  for (const s of surface.segments) least = Math.min(least, distanceToSegment(surface, s, x, y));
  return least;
}

/* The segments of a surface by cells: places along them, half a cell apart at most, and whose they are. */
function segmentCells(surface) {
  surface.segments ||= segmentsOf(surface);
  const length = ([a, b]) => Math.hypot(surface.x[b] - surface.x[a], surface.y[b] - surface.y[a]), x = [], y = [], of = [];
  const size = surface.segments.reduce((most, s) => Math.max(most, length(s) / 500), 0.05);
  surface.segments.forEach((s, k) => {
    const [a, b] = s, n = Math.ceil(2 * length(s) / size);
    for (let i = 0; i <= n; i++) {
      const way = n ? i / n : 0;
      x.push(surface.x[a] + way * (surface.x[b] - surface.x[a]));
      y.push(surface.y[a] + way * (surface.y[b] - surface.y[a]));
      of.push(k);
    }
  });
  return Object.assign(new Cells(x, y, size), {of});
}

/* The same for every point of another surface. What has no place within r rings is further than r - 1/4 cells. */
function distancesFrom(surface, other) {
  const cells = surface.cells ||= segmentCells(surface), rings = 12;
  return Float64Array.from(other.x, (x, k) => {
    const y = other.y[k];
    let least = Infinity, r = -1;
    while (++r <= rings && least > (r - 1.25) * cells.size)
      cells.ring(x, y, r, at => { least = Math.min(least, distanceToSegment(surface, surface.segments[cells.of[at]], x, y)); });
    return r <= rings || least <= (rings - 0.25) * cells.size ? least : distanceFrom(surface, x, y);
  });
}
