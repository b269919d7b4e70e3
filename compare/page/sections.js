/* The tables of each section, from report.json. */
const live = id => document.querySelector(`.live[data-of="${id}"]`);
const soft = text => make('p', {class: 'soft'}, text);
const h3 = text => make('h3', {}, text);
const unnamed = runs.length - named.length;

function measureCell(row, reasons) {
  if (!row) return td('–');
  const cell = reasons.cell(row, 'value');
  if (Number.isFinite(row.value) && row.value < row.noise_floor) cell.className = 'below';
  return cell;
}

/* A row for each measure of a section and time, a column for each run. */
function measureTable(section) {
  const reasons = new Reasons(), shown = named.filter(i => i > 0), rows = [];
  for (const measure of report.about.measures.filter(m => m.section === section)) {
    const own = report.measures.filter(m => m.measure === measure.name);
    for (const t of [...new Set(own.map(m => m.t_star))]) {
      const at = own.filter(m => m.t_star === t);
      rows.push([make('th', {class: 't', scope: 'row', title: measure.help}, `${measure.name} [${measure.units}]`),
        td(t === null ? 'all' : g(t)),
        ...shown.map(i => measureCell(at.find(m => m.run === runs[i].label), reasons))]);
    }
  }
  if (!rows.length) return [];
  return [...table(['measure', 't*', ...shown.map(runName)], rows, reasons),
    unnamed > 0 ? soft(`${unnamed} runs more are in report.json.`) : null];
}

function both(a, b, key, reasons) {
  return Number.isFinite(a[key]) && Number.isFinite(b[key]) ? td(`${g(a[key], 3)} (${g(b[key], 3)})`)
    : reasons.cell(Number.isFinite(a[key]) ? b : a, key);
}

function signalTable(units) {
  const reasons = new Reasons(), rows = [];
  runs.forEach((run, i) => run.signals.filter(units).forEach(s => {
    const mean = s.averaged_over > 0 ? ` (mean over ${g(s.averaged_over, 3)})` : '';
    rows.push([th(...runName(i)), td(`${s.signal}${mean} against ${s.against}`, 't'), td(`${g(s.from, 3)}–${g(s.to, 3)}`),
      both(s.run, s.other, 'onset', reasons), both(s.run, s.other, 'peak', reasons),
      both(s.run, s.other, 'peak_time', reasons), both(s.run, s.other, 'impulse', reasons),
      reasons.cell(s, 'rms', 3), Number.isFinite(s.best_shift) ? td(`${g(s.best_shift, 3)} → ${g(s.rms_if_shifted, 3)}`) : reasons.cell(s, 'best_shift')]);
  }));
  if (!rows.length) return [];
  return [...table(['run', 'signal', 'common t*', 'arrival t*', 'peak', 'time of peak', 'impulse', 'rms difference', 'best shift → rms then'], rows, reasons),
    soft('In brackets: the same of what it is compared with, over the same common time. Best shift: positive when the run is late; it is not applied.')];
}

function filterTable() {
  const reasons = new Reasons(), rows = [];
  const change = (f, key) => f.kind === 'impulse' ? reasons.cell(f.raw, key)
    : Number.isFinite(f.raw[key]) && Number.isFinite(f.filtered[key]) ? td(`${g(f.raw[key], 3)} → ${g(f.filtered[key], 3)}`)
      : reasons.cell(Number.isFinite(f.raw[key]) ? f.filtered : f.raw, key);
  runs.forEach((run, i) => run.filters.forEach(f => rows.push([th(...runName(i)), td(`${f.probe}: ${f.says}`, 't'),
    change(f, 'peak'), change(f, 'peak_time'), change(f, 'impulse'), reasons.cell(f, 'rms_taken_out')])));
  if (!rows.length) return [];
  return [h3('Filters, raw → filtered'),
    ...table(['run', 'filter', 'peak / (ρgH)', 'time of peak', 'impulse / (ρgH√(H/g))', 'rms taken out / (ρgH)'], rows, reasons),
    soft('Over the whole of each signal. No number of any comparison is taken of a filtered signal, and none of it is in the files.')];
}

function spectrumTables() {
  const reasons = new Reasons(), tables = [];
  report.reference.spectra.forEach((spectrum, k) => {
    const most = Math.max(1, ...runs.map(r => r.spectra[k].peaks.length));
    const rows = runs.map((run, i) => {
      const s = run.spectra[k], known = s.from !== null;
      return [th(...runName(i)), known ? td(`${g(s.from)}–${g(s.to)}`) : reasons.cell(s, 'sampling_interval'),
        td(known ? `${s.samples}${s.resampled ? ' ≈' : ''}` : ''), td(known ? g(s.bin, 3) : ''), td(known ? g(Math.sqrt(s.mean_square), 3) : ''),
        ...Array.from({length: most}, (_, p) => td(s.peaks[p] ? `${g(s.peaks[p].frequency)} (${g(s.peaks[p].amplitude, 3)})` : known ? '–' : ''))];
    });
    tables.push(h3(`Peaks of ${spectrum.series}`), ...table(['run', 't*', 'samples', 'bin', 'rms',
      ...Array.from({length: most}, (_, p) => p ? `${p + 1}.` : '1. peak (amplitude)')], rows));
  });
  return [...tables, reasons.say(), soft("Frequencies (waves in a time, not radians) and bins in √(g/H); amplitudes and rms in the series' unit. ≈: rows that are uneven in time, put on as many even instants by the cubic through the four rows around each.")];
}

function budgetTable() {
  const t = report.times[report.times.length - 1], reasons = new Reasons();
  if (t === undefined) return [];
  const last = i => runs[i].energy_budget[runs[i].energy_budget.length - 1];
  const row = (name, help, cell) => [make('th', {class: 't', scope: 'row', title: help}, name), ...named.map(cell)];
  const rows = [row('mechanical energy lost', 'kinetic + potential', i => reasons.cell(last(i), 'mechanical_lost')),
    row('of that: elastic', 'gained by the compressible fluid', i => reasons.cell(last(i), 'elastic_gained')),
    ...report.about.energy_terms.map(term => row(term.name, term.help, i => td(g(last(i).terms[term.name] ?? 0)))),
    row('unaccounted', 'lost less the rows above: the error of the time steps', i => reasons.cell(last(i), 'unaccounted'))];
  return [h3(`Where the energy went until t* = ${g(t)}, in E0`), ...table(['term', ...named.map(runName)], rows, reasons)];
}

function instantCells(instant, reasons) {
  if (!Number.isFinite(instant.t_star)) return [reasons.cell(instant, 't_star'), td('')];
  const digits = instant.error > 0 && instant.located_by_solver ? 5 : instant.error > 0 ? 3 : 4;
  const bar = instant.error > 0 ? ` ± ${g(instant.error, instant.located_by_solver ? 1 : 2)}` : '';
  return [td(instant.t_star.toFixed(digits) + bar),
    td(Number.isFinite(instant.at[0]) ? `(${instant.at[0].toFixed(3)}, ${instant.at[1].toFixed(3)})` : '')];
}

function jetRows(reasons) {
  const rows = [], add = (i, t, jet) => jet && rows.push([th(...runName(i)), td(g(t)), td(jet.tip[0].toFixed(4)), td(jet.tip[1].toFixed(4)),
    reasons.cell(jet, 'direction_degrees'), ...jet.thickness.map(s => reasons.cell(s, 'thickness')), reasons.cell(jet, 'cavity_area')]);
  report.times.forEach((t, k) => {
    const at = report.runs.map(r => r.at_times[k]);
    add(0, t, (at.find(a => a.jet_reference) || {}).jet_reference);
    at.forEach((a, r) => add(r + 1, t, a.jet));
  });
  return rows;
}

function jetTables() {
  const reasons = new Reasons(), shape = new Reasons();
  const rows = jetRows(shape);
  return [h3('Instants'), ...table(['run', 'wall impact t*', 'at (x, y)/H', 'overturning t*', 'at (x, y)/H', 'touchdown t*', 'at (x, y)/H'],
    runs.map((run, i) => [th(...runName(i)), ...instantCells(run.wall_impact, reasons), ...instantCells(run.overturning, reasons), ...instantCells(run.touchdown, reasons)]), reasons),
  soft('A time with three decimals and ± was read off the sequence of surfaces; ± holds the interval between outputs and how far the instant moves when the surface does by half a particle spacing: a face that stands near the vertical for long has no sharp instant. One with more decimals was located by the solver; ± is then the standard error that its run states.'),
  h3('Shape'),
  ...rows.length ? table(['run', 't*', 'tip x/H', 'tip y/H', 'direction [deg]', 'thickness at 0.05 H', 'at 0.1 H', 'at 0.2 H', 'cavity / H²'], rows, shape)
    : [make('p', {}, `No surface overhangs by more than ${g(report.about.method.jet_least_overhang, 3)} H at the comparison times.`)],
  h3('Differences from the reference'), ...measureTable('jet')];
}

function medianTable() {
  const having = named.filter(i => runs[i].diagnostics), names = Object.keys(report.about.diagnostics);
  if (!having.length) return [];
  const rows = names.map(name => [th(name), ...having.map(i => td(g(runs[i].diagnostics.medians[name]))), td(report.about.diagnostics[name], 'w')]);
  return [h3(`Medians from t* = ${g(runs[having[0]].diagnostics.from)} on`), ...table(['number', ...having.map(runName), 'what it is'], rows),
    soft("From the reference's wall impact on, where it has one. In the units of the figures: momenta in ρH²√(gH), angular momenta in ρH³√(gH), numbers as they are. n/a: the run has no series of that name.")];
}

function errorBarTable() {
  const having = runs.map((_, i) => i).filter(i => runs[i].error_bars), rows = [];
  for (const i of having)
    for (const [name, e] of [['total energy', runs[i].error_bars.total_energy], ...Object.entries(runs[i].error_bars.series)])
      if (e) rows.push([th(...runName(i)), td(name, 't'), td(g(e.mean, 3)), td(g(e.largest, 3))]);
  return rows.length ? [h3('Standard errors that runs state'), ...table(['run', 'series', 'mean', 'largest'], rows)] : [];
}

function absentSay(run) {
  if (!run.absent.length) return null;
  const names = run.absent.length > 1 ? `${run.absent.slice(0, -1).join(', ')} or ${run.absent[run.absent.length - 1]}` : run.absent[0];
  return make('p', {}, `The file of ${run.label} has no ${names}: what needs them is not compared.` +
    (run.absent[0] === 'walls' ? ' It is taken to be of the tank of the others.' : ''));
}

function provenance() {
  const rows = runs.map((run, i) => [th(...runName(i)), td(`${run.solver || 'another program'}${run.complete ? '' : ' (unfinished)'}`, 't'),
    td(g(1 / run.spacing)), td(run.outputs), td(g(run.last_output ?? 0)),
    td(run.evaluations > 0 ? run.evaluations.toFixed(0) : '-'), td(run.evaluations > 0 ? run.wall_time_s.toFixed(1) : '-'),
    td(run.program_version ? `${run.program_version}, ${run.program_revision}` : '', 't'), td(run.file, 'w')]);
  const counted = runs.filter(r => Object.keys(r.statistics).length).map(run => make('details', {}, make('summary', {}, `What ${run.label} counted`),
    table(['statistic', 'value', 'what it is'], Object.entries(run.statistics).map(([name, value]) => [th(name), td(g(value, 6)), td(report.about.statistics[name] || '', 'w')]))[0]));
  const cases = runs.filter(r => r.case).map((run, i) => make('details', {}, make('summary', {},
    `The case as run by ${run.label}${i ? '' : ' (and by every run not listed with its own)'}`), make('pre', {tabindex: 0}, run.case)));
  const sources = report.about.sources.map(s => make('li', {}, `${s.label} (${s.target}): ${s.source}`));
  return [...table(['run', 'solver', 'H/spacing', 'outputs', 'last t*', 'evaluations', 'clock [s]', 'program', 'file'], rows),
    ...runs.map(absentSay), soft(`This report was made by plunge ${report.program_version}, revision ${report.program_revision}. ${pack.thinned}`),
    ...counted, ...cases, ...sources.length ? [h3('Experiments'), make('ul', {}, sources)] : []];
}

function fillSections() {
  const fill = (id, ...content) => live(id) && live(id).append(...content.flat().filter(c => c));
  document.querySelectorAll('section table').forEach(sortable);
  fill('distance', measureTable('distance'));
  fill('jet', live('jet') ? jetTables() : []);
  fill('front', measureTable('front'), signalTable(s => s.signal === 'front'));
  fill('energy', measureTable('energy'), budgetTable());
  fill('pressure', measureTable('pressure'), signalTable(s => s.units === 'rho g H'), filterTable());
  fill('gauges', measureTable('gauges'), signalTable(s => s.units === 'H' && s.signal !== 'front'));
  fill('spectra', live('spectra') ? spectrumTables() : []);
  fill('diagnostics', medianTable());
  fill('runs', provenance(), errorBarTable());
  fill('method', method());
}
