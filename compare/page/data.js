/* What the page holds: report.json, and packed columns of numbers (compare/page/planes.h). */
const byId = id => document.getElementById(id);
const report = JSON.parse(byId('report-data').textContent);
const pack = JSON.parse(byId('pack-data').textContent);
const runs = [report.reference, ...report.runs]; // as in pack.runs

async function inflate(text) {
  const packed = Uint8Array.from(atob(text), c => c.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/* The columns of packed numbers; kept once they are there. */
function columnsOf(planes) {
  if (!planes) return Promise.resolve([]);
  planes.columns ||= inflate(planes.data).then(bytes => {
    const n = planes.n;
    return planes.lo.map((lo, k) => {
      const step = (planes.hi[k] - lo) / planes.steps[k], column = new Float64Array(n);
      for (let i = 0, at = 2 * n * k, value = 0; i < n; i++) {
        const folded = bytes[at + i] | bytes[at + n + i] << 8;
        value = value + (folded >> 1 ^ -(folded & 1)) & 0xffff;
        column[i] = value === 0xffff ? NaN : lo + step * value;
      }
      return column;
    });
  });
  return planes.columns;
}

/* The entry of a list of outputs that is nearest to t; null: none within `slack`. */
function nearest(list, t, slack = Infinity) {
  let low = 0, high = list.length - 1;
  if (high < 0) return null;
  while (low < high) {
    const middle = low + high >> 1;
    if (list[middle].t < t) low = middle + 1;
    else high = middle;
  }
  if (low > 0 && t - list[low - 1].t < list[low].t - t) low--;
  return Math.abs(list[low].t - t) <= slack ? list[low] : null;
}

/* Where the values of a column reach the share q, of those that are numbers. */
function quantile(values, q) {
  const sorted = Float64Array.from(values).filter(Number.isFinite).sort();
  return sorted.length ? sorted[Math.min(sorted.length - 1, Math.floor(q * sorted.length))] : NaN;
}

/* The value of a curve at t, between its rows; NaN outside. */
function valueAt(ts, values, t) {
  const n = ts.length;
  if (!n || t < ts[0] - 1e-6 || t > ts[n - 1] + 1e-6) return NaN;
  let low = 0, high = n - 1;
  while (high - low > 1) {
    const middle = low + high >> 1;
    if (ts[middle] <= t) low = middle;
    else high = middle;
  }
  const way = ts[high] > ts[low] ? Math.max(0, Math.min(1, (t - ts[low]) / (ts[high] - ts[low]))) : 0;
  return values[low] + way * (values[high] - values[low]);
}
