/* Colour scales that the colour-blind can read: one that rises in lightness, and one with a middle. */
const RISING = ['#30123b', '#31418f', '#2b6cb0', '#2093b5', '#2cb89a', '#6fd36a', '#c0e052', '#fde725'];
const MIDDLED = ['#053061', '#2f79b5', '#8ec2dd', '#e9eef0', '#f9c0a2', '#d6604d', '#67001f'];
const SHADES = 64;

function shadesOf(stops) {
  const rgb = stops.map(s => [1, 3, 5].map(i => parseInt(s.slice(i, i + 2), 16)));
  return Array.from({length: SHADES}, (_, k) => {
    const at = k / (SHADES - 1) * (stops.length - 1), i = Math.min(stops.length - 2, Math.floor(at));
    return `rgb(${[0, 1, 2].map(c => Math.round(rgb[i][c] + (at - i) * (rgb[i + 1][c] - rgb[i][c]))).join(',')})`;
  });
}

const QUANTITIES = {
  p: {name: 'pressure', unit: 'ρgH', shades: shadesOf(RISING), range: v => [0, quantile(v, 0.98)]},
  speed: {name: 'speed', unit: '√(gH)', shades: shadesOf(RISING), range: v => [0, quantile(v, 0.99)]},
  rho: {name: 'density', unit: 'ρ', shades: shadesOf(MIDDLED), range: v => {
    const off = Math.max(1 - quantile(v, 0.02), quantile(v, 0.98) - 1, 1e-4);
    return [1 - off, 1 + off];
  }},
  difference: {name: 'pressure less the reference', unit: 'ρgH', shades: shadesOf(MIDDLED), range: v => {
    const off = Math.max(quantile(v, 0.96), -quantile(v, 0.04), 1e-4);
    return [-off, off];
  }},
  distance: {name: 'distance from the reference', unit: 'H', shades: shadesOf(RISING), range: () => [0, 3 * Math.max(...pack.runs.map(r => r.dx))]}
};

function shadeOf(quantity, range, value) {
  const way = (value - range[0]) / (range[1] - range[0] || 1);
  return Math.max(0, Math.min(SHADES - 1, Math.round(way * (SHADES - 1))));
}

/* The scale in the corner of the picture. */
function drawScale(canvas, quantity, range, ink) {
  const c = canvas.getContext('2d'), dpr = window.devicePixelRatio || 1, width = 220, height = 40;
  canvas.width = width * dpr;
  canvas.height = height * dpr;
  c.scale(dpr, dpr);
  quantity.shades.forEach((shade, k) => {
    c.fillStyle = shade;
    c.fillRect(10 + 200 * k / SHADES, 18, 200 / SHADES + 1, 8);
  });
  c.fillStyle = ink;
  c.font = '11px system-ui, sans-serif';
  c.fillText(`${quantity.name} / ${quantity.unit}`, 10, 13);
  c.fillText(g(range[0], 3), 10, 37);
  c.textAlign = 'right';
  c.fillText(g(range[1], 3), 210, 37);
}
