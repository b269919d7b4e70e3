/* Tables that sort, and the reasons of what is not available. */
class Reasons {
  constructor() { this.list = []; }

  mark(reason) {
    if (!this.list.includes(reason)) this.list.push(reason);
    return this.list.indexOf(reason) + 1;
  }

  /* A cell of a member of an object of report.json, whose reason stands beside it. */
  cell(object, key, digits = 4) {
    const value = object ? object[key] : null;
    if (Number.isFinite(value)) return make('td', {}, g(value, digits));
    const why = object && object[`${key}_unavailable`] || 'the report has no such number';
    return make('td', {class: 'na', title: why}, 'n/a', make('sup', {}, this.mark(why)));
  }

  say() {
    if (!this.list.length) return null;
    return make('p', {class: 'why'}, 'n/a, not available: ' +
      this.list.map((why, k) => `(${k + 1}) ${why}`).join('; ') + '.');
  }
}

const td = (text, cls) => make('td', cls ? {class: cls} : {}, String(text));
const th = (...content) => make('th', {class: 't', scope: 'row'}, ...content);

/* Headings are texts, nodes or [node, text]; rows are lists of cells. */
function table(headings, rows, reasons) {
  const head = make('tr', {}, headings.map((h, k) => make('th', {class: k ? null : 't', scope: 'col'}, ...[h].flat())));
  const body = rows.map(cells => make('tr', {}, cells));
  const whole = make('table', {}, make('thead', {}, head), make('tbody', {}, body));
  sortable(whole);
  return [make('div', {class: 'scroll', tabindex: 0}, whole), reasons && reasons.say()];
}

function keyOf(row, column) {
  const text = row.cells[column] ? row.cells[column].firstChild ? row.cells[column].textContent.trim() : '' : '';
  const number = parseFloat(text.replace('−', '-'));
  return /^[-−+]?[.\d]/.test(text) && Number.isFinite(number) ? number : text;
}

function compareKeys(a, b) {
  const numbers = [typeof a, typeof b].filter(t => t === 'number').length;
  if (numbers === 2) return a - b;
  if (numbers === 1) return typeof a === 'number' ? -1 : 1; // what is not available comes last
  return a.localeCompare(b);
}

function sortBy(whole, column) {
  const heads = [...whole.tHead.rows[0].cells], body = whole.tBodies[0];
  const down = heads[column].getAttribute('aria-sort') === 'ascending';
  const rows = [...body.rows].map((row, place) => ({row, place, key: keyOf(row, column)}));
  rows.sort((a, b) => {
    const order = compareKeys(a.key, b.key);
    return (typeof a.key === typeof b.key && down ? -order : order) || a.place - b.place;
  });
  heads.forEach((h, k) => k === column ? h.setAttribute('aria-sort', down ? 'descending' : 'ascending') : h.removeAttribute('aria-sort'));
  body.append(...rows.map(r => r.row));
}

function sortable(whole) {
  if (!whole.tHead || whole.tBodies[0].rows.length < 2) return;
  [...whole.tHead.rows[0].cells].forEach((head, column) => {
    const button = make('button', {type: 'button', class: 'sort', title: 'Sort by this column', onclick: () => sortBy(whole, column)});
    button.append(...head.childNodes);
    head.append(button);
  });
}
