/* Elements and numbers. What comes from files gets into the page as text alone. */
function make(tag, attributes, ...content) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes || {}))
    if (name === 'class') element.className = value;
    else if (name.startsWith('on')) element.addEventListener(name.slice(2), value);
    else if (value !== null && value !== undefined && value !== false) element.setAttribute(name, value === true ? '' : value);
  element.append(...content.flat().filter(c => c !== null && c !== undefined));
  return element;
}

/* As %.4g of C would. */
function g(value, digits = 4) {
  if (value === null || value === undefined || !Number.isFinite(value)) return 'n/a';
  if (value === 0) return '0';
  const [mantissa, exponent] = value.toExponential(digits - 1).split('e');
  const e = Number(exponent), strip = s => s.includes('.') ? s.replace(/0+$/, '').replace(/\.$/, '') : s;
  if (e < -4 || e >= digits)
    return `${strip(mantissa)}e${e < 0 ? '-' : '+'}${String(Math.abs(e)).padStart(2, '0')}`;
  return strip(value.toFixed(digits - 1 - e));
}

/* Units of report.json as people write them. */
const pretty = unit => unit.replace('rho g H', 'ρgH').replace(/\^2/g, '²').replace(/\^3/g, '³').replace(/sqrt\(([^)]*)\)/g, '√($1)');
const readable = name => name.replace(/_/g, ' ');
const styleOf = i => pack.runs[i] || {colour: '#c4c4c4', dashes: 0};
const colourOf = i => i === 0 ? 'var(--fg)' : styleOf(i).colour;
const RINGS = ['', ' dash', ' dots', ' ring'], DASHES = [null, '9 4', '2 3', '9 3 2 3'];

/* A run's mark and name. */
const runName = i => [
  make('span', {class: `dot${RINGS[styleOf(i).dashes]}`, style: `color:${colourOf(i)}`}),
  runs[i].label
];
const named = runs.map((_, i) => i).filter(i => styleOf(i).named);
const indexOf = label => runs.findIndex(r => r.label === label);
