/* Groups of runs that differ in their resolution alone. */
const orNone = (v, digits) => v === null || v === undefined ? '–' : g(v, digits);

function convergenceTable(group) {
  const reasons = new Reasons();
  const rows = group.rows.map(row => [make('th', {class: 't wide', scope: 'row', title: row.says}, `${readable(row.name)}${row.of ? ` ${row.of}` : ''} [${row.units}]`), td(row.t_star === null ? 'all' : g(row.t_star)),
    ...row.values.map((v, k) => reasons.cell({v, v_unavailable: (row.values_unavailable || [])[k]}, 'v')),
    make('td', {class: 't wide', title: row.says}, row.trend || row.says || '–'), td(orNone(row.order, 3)), td(orNone(row.richardson)), td(orNone(row.error_bar, 2)), td(orNone(row.gci, 2)),
    td((row.error_orders || []).map(o => orNone(o, 3)).join(', '), 't')]);
  return table(['number', 't*', ...group.runs.map((r, k) => `${r} (H/${g(1 / group.spacing[k], 3)})`), 'trend', 'order', 'at spacing 0', 'error bar', 'GCI', 'orders of the error'], rows, reasons);
}

function makeConvergence() {
  const place = live('convergence');
  if (!place) return;
  for (const group of report.convergence)
    place.append(h3(`${group.name || group.solver}: ${group.runs.join(', ')}`),
      ...group.left_out.length ? [soft(`Left out: ${group.left_out.map(l => `${l.run} (${l.why})`).join('; ')}.`)] : [],
      ...convergenceTable(group).filter(c => c));
}
